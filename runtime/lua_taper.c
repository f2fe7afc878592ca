/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections that vary along the beam, as Lua sees them. */
#include "lua_hobe.h"

/* A Lua function that gives sections, called under lua_pcall from inside the core. */
struct maker {
    lua_State *L;
    int failed; /* the error is on top of the stack */
};

/* Stack: the function, the section to be made, the function's last one. */
static enum hobe_status call(void *context, double t, const hobe_section **section,
                             struct hobe_error *err)
{
    struct maker *m = context;
    lua_State *L = m->L;
    lua_settop(L, 2);
    lua_pushvalue(L, 1);
    lua_pushnumber(L, t);
    if (lua_pcall(L, 1, 1, 0)) {
        m->failed = 1;
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "the function that gives the section failed");
    }
    hobe_section *const *made = luaL_testudata(L, 3, HOBE_LUA_SECTION);
    if (!made)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the function of a taper must return a section such as "
                         "hobe.rectangle{...}, got %s at %g",
                         hobe_lua_describe(L, 3), t);
    *section = *made;
    return HOBE_OK;
}

struct ends {
    hobe_section *from, *to;
};

static const struct hobe_lua_key keys[] = {
    KEY(struct ends, from, KEY_SECTION, REQUIRED, .doc = "the section at the beam's begin"),
    KEY(struct ends, to, KEY_SECTION, REQUIRED, .doc = "the section at its end, of the same kind"),
    {0}};
static const struct hobe_lua_schema schema = {"taper", keys};

/* hobe.taper{from =, to =} or hobe.taper(function) */
static int taper(lua_State *L)
{
    struct hobe_error err;
    struct ends ends = {0};
    struct maker maker = {L, 0};
    const int is_function = lua_isfunction(L, 1);
    lua_settop(L, 1);
    if (!is_function)
        hobe_lua_read(L, 1, &schema, &ends);
    hobe_section **made = hobe_lua_new_section(L);
    *made = is_function ? hobe_section_taper(call, &maker, &err)
                        : hobe_section_linear(ends.from, ends.to, &err);
    if (maker.failed)
        return lua_error(L); /* as it was raised, with its place */
    if (!*made)
        hobe_lua_raise(L, &err);
    lua_settop(L, 2);
    return 1;
}

/* section:at(t) */
static int at(lua_State *L)
{
    struct hobe_error err;
    hobe_section *const *section = luaL_checkudata(L, 1, HOBE_LUA_SECTION);
    const double t = hobe_lua_number(L, 2, "at: the fraction of the length");
    if (!(t >= 0 && t <= 1))
        hobe_lua_fail(L, "at: the fraction of the length must be from 0 to 1, got %f", t);
    hobe_section **made = hobe_lua_new_section(L);
    *made = hobe_section_at(*section, t, &err);
    if (!*made)
        hobe_lua_raise(L, &err);
    return 1;
}

/* section:wall_bending() */
static int wall_bending(lua_State *L)
{
    struct hobe_error err;
    hobe_section *const *section = luaL_checkudata(L, 1, HOBE_LUA_SECTION);
    double c;
    hobe_lua_pause_clock();
    const enum hobe_status status = hobe_section_wall_bending(*section, &c, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    lua_pushnumber(L, c);
    return 1;
}

const struct hobe_lua_entry hobe_lua_section_methods[] = {
    {"at", at, "section:at(t)", "The section that a taper has at the fraction t of its length.",
     NULL, NULL},
    {"wall_bending", wall_bending, "section:wall_bending()",
     "How easily the walls bend in torsion, c, m^6: a twist rate kappa loads them by "
     "2 kappa times the shear stress, inwards, and what they give takes "
     "2 C kappa^3, C = c (1 - nu^2) G^2/E, of the torque G J kappa.  By finite elements when it is "
     "first asked for; 0 of rectangles, circles and tubes.",
     NULL, NULL},
    {0}};

const struct hobe_lua_entry hobe_lua_taper_entries[] = {
    {"taper", taper, "hobe.taper{from =, to =} or hobe.taper(function(at) return section end)",
     "A section that varies along the beam: linear between two of the same kind, or what a "
     "function "
     "gives for fractions of the length from 0 to 1, called at 17 places or more.  The beam's axis "
     "goes through the centroids.  Only `text` and `:at(t)`, the section at a fraction of the "
     "length, can be asked of it.",
     &schema, NULL},
    {0}};
