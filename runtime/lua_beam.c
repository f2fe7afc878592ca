/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hobe.beam{...}, and masses on beams. */
#include "lua_item.h"

static const struct hobe_lua_key damping_keys[] = {
    KEY(struct hobe_damping, mass, KEY_NUMBER, KEY_FROM(0), .unit = "1/s",
        .doc = "forces of so many times the momentum; they hold back rigid motions, too"),
    KEY(struct hobe_damping, stiffness, KEY_NUMBER, KEY_FROM(0), .unit = "s",
        .doc = "viscous stress C : dE/dt of so many times the rate of strain, beside the elastic "
               "one (Kelvin, Voigt): no rigid motion feels it; not for 3333s.  A mode of angular "
               "frequency omega has (mass/omega + stiffness omega)/2 of the critical damping"),
    {0}};

static const struct hobe_lua_schema damping_schema = {"damping", damping_keys};

struct beam {
    struct hobe_beam beam;
    const char *element;
    int mechanics, integration;
};

#define BEAM(name, kind, ...) KEY_AS(#name, struct beam, beam.name, kind, __VA_ARGS__)

static const struct hobe_lua_key beam_keys[] = {
    BEAM(name, KEY_TEXT, REQUIRED, .doc = "its name in the scene, for loads and results"),
    KEY(struct beam, element, KEY_TEXT, .word = "MGD30w",
        .doc = "name of the element; see `hobe.elements()`"),
    BEAM(elements, KEY_WHOLE, REQUIRED, KEY_WITHIN(1, 1e6), .doc = "number of elements"),
    BEAM(section, KEY_SECTION, REQUIRED, .doc = "a section, such as hobe.rectangle{...}"),
    BEAM(material, KEY_GROUP, .group = &hobe_lua_material_schema,
         .doc = "a table {E =, nu =, rho =, k2 =, k3 =, k =}; a composite section brings its own"),
    BEAM(from, KEY_VECTOR, .unit = "m", .doc = "begin of a straight axis, {x, y, z}"),
    BEAM(to, KEY_VECTOR, .unit = "m", .doc = "its end"),
    KEY_OF_OTHER(
        "curve", "function or list", .unit = "m",
        .doc = "a curved axis, in place of from and to: a function that gives the point {x, y, z} "
               "of a smooth curve at t from 0 to 1, at any speed; or a list of points for a "
               "spline"),
    KEY_OF_OTHER(
        "twist", "number or function", .unit = "rad",
        .doc = "turn of the section about the axis, y to z: the angle at the end, to which it "
               "grows evenly, or a function that gives it at a fraction of the length"),
    BEAM(up, KEY_VECTOR,
         .doc = "where the section's z axis points to, made normal to the beam; global Z where "
                "left out, or global -X for a beam along Z"),
    KEY(struct beam, mechanics, KEY_CHOICE, .choices = "average|axis|full|structural",
        .doc =
            "where Poisson's coupling acts: on the strain averaged over the section, on the "
            "axis (the paper), everywhere (full); nowhere in the law of a rod, structural, which "
            "3333s has and no other.  average also averages what warping in large torsion strains "
            "the section in its plane.  The element's own choice where left out"),
    KEY(struct beam, integration, KEY_CHOICE, .choices = "exact|paper", .word = "exact",
        .doc = "exact, or 3 x 3 x 3 Gauss points and one term of the warping "
               "series as in the paper; not for 3333s"),
    BEAM(damping, KEY_GROUP, .group = &damping_schema,
         .doc = "what it loses in motion, a table {mass =, stiffness =}"),
    {0}};

static const struct hobe_lua_schema beam_schema = {"beam", beam_keys};

/* Whether the beam's table holds the key; pushes its value. */
static int push_given(lua_State *L, const char *key)
{
    hobe_lua_push_key(L, 1, &beam_schema, key);
    return !lua_isnil(L, -1);
}

/* Pushes the curve that is the beam's axis; nil where the axis is straight and not twisted. */
static void push_axis(lua_State *L, struct hobe_beam *beam)
{
    static const char *const ends[] = {"from", "to"};
    const int curved = push_given(L, "curve"), curve = lua_gettop(L);
    for (int i = 0; i < 2; i++)
        if (push_given(L, ends[i]) == curved)
            hobe_lua_fail(L,
                          curved ? "beam: %s and curve exclude each other: the curve is the axis"
                                 : "beam: %s is missing: an end of the axis {x, y, z}, or a curve",
                          ends[i]);
    push_given(L, "twist");
    beam->curve = hobe_lua_push_curve(L, curve, lua_gettop(L), beam);
    lua_replace(L, curve);
    lua_settop(L, curve);
}

static int beam(lua_State *L)
{
    struct beam read = {0};
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &beam_schema, &read);
    read.beam.kernel = hobe_lua_find_kernel(L, read.element);
    hobe_lua_choose_material(L, &beam_schema, read.beam.section, &read.beam.material);
    read.beam.mechanics = (enum hobe_mechanics)read.mechanics;
    read.beam.integration = read.integration == 2 ? HOBE_INTEGRATION_PAPER : HOBE_INTEGRATION_EXACT;
    push_axis(L, &read.beam);
    struct hobe_beam *b = &hobe_lua_push_item(L, ITEM_BEAM, &read.beam, sizeof read.beam)->as.beam;
    b->where = hobe_lua_keep(L, WHERE);
    b->name = hobe_lua_keep_copy(L, b->name, NAME);
    hobe_lua_push_key(L, 1, &beam_schema, "section");
    lua_setiuservalue(L, -2, OTHER);
    lua_pushvalue(L, 2);
    lua_setiuservalue(L, -2, CURVE);
    return 1;
}

/* ---- masses --------------------------------------------------------------------------------- */

static const struct hobe_lua_key mass_keys[] = {
    KEY_BEAM(struct hobe_mass),
    KEY_PLACE(struct hobe_mass),
    KEY(struct hobe_mass, mass, KEY_NUMBER, REQUIRED, KEY_FROM(0), .unit = "kg", .doc = "the mass"),
    KEY(struct hobe_mass, y, KEY_NUMBER, .unit = "m", .doc = "where it sits in the section, and"),
    KEY(struct hobe_mass, z, KEY_NUMBER, .unit = "m", .doc = "likewise, from the centroid"),
    {0}};

static const struct hobe_lua_schema mass_schema = {"mass", mass_keys};

static int mass(lua_State *L)
{
    struct hobe_mass read = {0};
    hobe_lua_read(L, 1, &mass_schema, &read);
    struct hobe_mass *m = &hobe_lua_push_item(L, ITEM_MASS, &read, sizeof read)->as.mass;
    m->where = hobe_lua_keep(L, WHERE);
    m->beam = hobe_lua_keep_copy(L, m->beam, NAME);
    return 1;
}

const struct hobe_lua_entry hobe_lua_beam_entries[] = {
    {"beam", beam,
     "hobe.beam{name =, element =, elements =, section =, material =, from =, to =, twist =} or "
     "hobe.beam{..., curve =, twist =}",
     "A beam of elements of equal length on a straight or curved axis, on which its section can "
     "turn.",
     &beam_schema, NULL},
    {"mass", mass, "hobe.mass{\"beam\", at =, mass =}",
     "A mass at a point of a beam, which every mode of the section moves.", &mass_schema, NULL},
    {0}};
