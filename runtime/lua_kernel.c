/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One element for people who study elements: reference, mass, energy, force, tangent. */
#include "lua_item.h"

#include <math.h>
#include <string.h>

#define KERNEL "hobe.kernel"

/* One element along X from the origin; its user value is the section. */
struct element {
    hobe_element *element;
    int n;       /* degrees of freedom, 3 * vectors */
    double q0[]; /* [n] reference */
};

static int finalize(lua_State *L)
{
    struct element *e = luaL_checkudata(L, 1, KERNEL);
    hobe_element_free(e->element);
    e->element = NULL;
    return 0;
}

const struct hobe_kernel *hobe_lua_find_kernel(lua_State *L, const char *name)
{
    struct hobe_error err;
    const struct hobe_kernel *kernel = hobe_find_kernel(name, &err);
    if (!kernel)
        hobe_lua_raise(L, &err);
    return kernel;
}

/* ---- numbers in and out --------------------------------------------------------------------- */

static int push_rows(lua_State *L, const double *a, int n)
{
    lua_createtable(L, n, 0);
    for (int i = 0; i < n; i++) {
        hobe_lua_push_numbers(L, a + (size_t)i * (size_t)n, n);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

/* Memory that Lua owns, so that no error can leak it. */
static double *new_numbers(lua_State *L, size_t count)
{
    return lua_newuserdatauv(L, count * sizeof(double), 0);
}

/* The list q at index 2, of n numbers; `name` is the method. */
static const double *read_q(lua_State *L, const struct element *e, const char *name)
{
    const char *what = lua_pushfstring(L, "%s: q", name);
    if (!lua_istable(L, 2) || lua_rawlen(L, 2) != (lua_Unsigned)e->n)
        hobe_lua_fail(L, "%s must be a list of %d numbers (see :dofs()), got %s with %I", what,
                      e->n, hobe_lua_describe(L, 2), (LUAI_UACINT)lua_rawlen(L, 2));
    double *q = new_numbers(L, (size_t)e->n);
    for (int i = 0; i < e->n; i++) {
        lua_rawgeti(L, 2, i + 1);
        if (lua_type(L, -1) != LUA_TNUMBER || !isfinite(lua_tonumber(L, -1))) {
            what = lua_pushfstring(L, "%s[%d]", what, i + 1);
            hobe_lua_number(L, -2, what);
        }
        q[i] = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    return q;
}

/* ---- methods -------------------------------------------------------------------------------- */

static int reference(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    return hobe_lua_push_numbers(L, e->q0, e->n);
}

static int mass(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    double *M = new_numbers(L, (size_t)e->n * (size_t)e->n);
    hobe_element_mass(e->element, M);
    return push_rows(L, M, e->n);
}

static int energy(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    const double *q = read_q(L, e, "energy");
    struct hobe_error err;
    double U;
    if (hobe_element_energy(e->element, e->q0, q, &U, &err))
        hobe_lua_raise(L, &err);
    lua_pushnumber(L, U);
    return 1;
}

static int force(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    const double *q = read_q(L, e, "force");
    double *f = new_numbers(L, (size_t)e->n);
    struct hobe_error err;
    if (hobe_element_force(e->element, e->q0, q, f, &err))
        hobe_lua_raise(L, &err);
    return hobe_lua_push_numbers(L, f, e->n);
}

static int tangent(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    const double *q = read_q(L, e, "tangent");
    double *K = new_numbers(L, (size_t)e->n * (size_t)e->n);
    struct hobe_error err;
    if (hobe_element_tangent(e->element, e->q0, q, K, &err))
        hobe_lua_raise(L, &err);
    return push_rows(L, K, e->n);
}

/* The name of degree of freedom i: "r1x", "r_x1y" for a slope along the axis, "r_w3z". */
static void push_name(lua_State *L, const struct hobe_kernel *kernel, int i)
{
    const struct hobe_vector *vector = &kernel->vector[i / 3];
    const char *mode = vector->mode > 0 ? kernel->mode[vector->mode] : "";
    const char *slope = vector->slope ? "x" : "";
    lua_pushfstring(L, "r%s%s%s%d%c", *mode || *slope ? "_" : "", mode, slope, vector->node + 1,
                    "xyz"[i % 3]);
}

static int dofs(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    lua_createtable(L, e->n, 0);
    for (int i = 0; i < e->n; i++) {
        push_name(L, hobe_element_kernel(e->element), i);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

const struct hobe_lua_entry hobe_lua_kernel_methods[] = {
    {"dofs", dofs, "k:dofs()",
     "Names of the 3N degrees of freedom in their order, node by node: `r1x` is the x component of "
     "the position at node 1, `r_x1y` of its slope along the axis, `r_z2x` of the slope r_z at "
     "node 2, `r_w3x` of the warping vector.",
     NULL, NULL},
    {"reference", reference, "k:reference()",
     "The 3N nodal coordinates before deformation: along X from the origin, section axes Y and Z; "
     "of positions in m.",
     NULL, NULL},
    {"mass", mass, "k:mass()", "The mass matrix, a list of 3N rows; of positions in kg.", NULL,
     NULL},
    {"energy", energy, "k:energy(q)", "Strain energy, J, at the 3N nodal coordinates q.", NULL,
     NULL},
    {"force", force, "k:force(q)", "Elastic force dU/dq, 3N numbers; of positions in N.", NULL,
     NULL},
    {"tangent", tangent, "k:tangent(q)",
     "Tangent stiffness d2U/dq2, a list of 3N rows; of positions in N/m.", NULL, NULL},
    {0}};

/* ---- the element ---------------------------------------------------------------------------- */

struct options {
    struct hobe_element_options element;
    const char *name;
    int mechanics, integration;
};

static const struct hobe_lua_key keys[] = {
    KEY_AS("element", struct options, name, KEY_TEXT, .word = "MGD30w", .doc = "as of a beam"),
    KEY_AS("section", struct options, element.section, KEY_SECTION, REQUIRED,
           .doc = "a section, such as hobe.rectangle{...}"),
    KEY_AS("material", struct options, element.material, KEY_GROUP,
           .group = &hobe_lua_material_schema, .doc = "as of a beam"),
    KEY_AS("length", struct options, element.length, KEY_NUMBER, REQUIRED, KEY_ABOVE(0),
           .unit = "m", .doc = "its length"),
    KEY(struct options, mechanics, KEY_CHOICE, .choices = "average|axis|full|structural",
        .doc = "as of a beam"),
    KEY(struct options, integration, KEY_CHOICE, .choices = "exact|paper", .word = "exact",
        .doc = "as of a beam"),
    {0}};

static const struct hobe_lua_schema schema = {"kernel", keys};

struct numbers {
    struct hobe_rest rest;
    int nodes, dofs;
};

#define NUMBER(key, field, type, doc) FIELD_AS(key, struct numbers, field, type, NULL, doc)

static const struct hobe_lua_field fields[] = {
    NUMBER("nodes", nodes, 'i', "number of nodes"),
    NUMBER("size", dofs, 'i', "degrees of freedom, 3N"),
    NUMBER("zero", rest.zero, 'i', "eigenvalues of the stiffness at rest that are zero: 6"),
    NUMBER("negative", rest.negative, 'i', "those below zero: 0"),
    NUMBER("EA", rest.share[HOBE_STRETCH], 'd',
           "stiffness in stretch of a long beam of such elements over that of the section: 1"),
    NUMBER("EIyy", rest.share[HOBE_BEND_Y], 'd', "in bending about y"),
    NUMBER("EIzz", rest.share[HOBE_BEND_Z], 'd', "about z"),
    NUMBER("GJ", rest.share[HOBE_TWIST], 'd',
           "and in torsion, more than 1 without a warping function"),
    {0}};

static int get_field(lua_State *L)
{
    const struct element *e = luaL_checkudata(L, 1, KERNEL);
    const char *name = lua_tostring(L, 2);
    const struct hobe_kernel *kernel = hobe_element_kernel(e->element);
    struct numbers numbers = {.nodes = kernel->nodes, .dofs = e->n};
    if (!strcmp(name, "element") || !strcmp(name, "mechanics")) {
        lua_pushstring(L, *name == 'e' ? kernel->name
                                       : hobe_mechanics_name(hobe_element_mechanics(e->element)));
        return 1;
    }
    hobe_element_rest(e->element, &numbers.rest);
    return hobe_lua_push_field(L, "an element", fields, &numbers, name);
}

/* hobe.kernel{...} */
static int kernel(lua_State *L)
{
    static const double frame[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct options read = {0};
    struct hobe_error err;
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &schema, &read);
    read.element.kernel = hobe_lua_find_kernel(L, read.name);
    hobe_lua_choose_material(L, &schema, read.element.section, &read.element.material);
    read.element.mechanics = (enum hobe_mechanics)read.mechanics;
    read.element.integration =
        read.integration == 2 ? HOBE_INTEGRATION_PAPER : HOBE_INTEGRATION_EXACT;
    int n = 3 * read.element.kernel->vectors;
    struct element *e = lua_newuserdatauv(L, sizeof *e + (size_t)n * sizeof *e->q0, 1);
    e->element = NULL;
    e->n = n;
    hobe_lua_set_type(L, KERNEL, finalize, hobe_lua_kernel_methods, get_field);
    hobe_lua_push_key(L, 1, &schema, "section");
    lua_setiuservalue(L, 2, 1);
    hobe_lua_pause_clock();
    e->element = hobe_element_new(&read.element, &err);
    hobe_lua_resume_clock();
    if (!e->element)
        hobe_lua_raise(L, &err);
    if (hobe_element_q0(e->element))
        memcpy(e->q0, hobe_element_q0(e->element), (size_t)n * sizeof *e->q0);
    else
        hobe_element_reference(e->element, frame, e->q0);
    return 1;
}

const struct hobe_lua_entry hobe_lua_kernel_entries[] = {
    {"kernel", kernel, "hobe.kernel{element =, section =, material =, length =}",
     "One element along X from the origin, to be studied or compared with another code.  Besides "
     "the fields below, `element` and `mechanics` are names.",
     &schema, fields},
    {0}};
