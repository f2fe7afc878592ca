/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections as Lua sees them. */
#include "lua_hobe.h"

#include <string.h>

static int finalize(lua_State *L)
{
    hobe_section **section = luaL_checkudata(L, 1, HOBE_LUA_SECTION);
    hobe_section_free(*section);
    *section = NULL;
    return 0;
}

#define PROPERTY(name, unit, doc) FIELD(struct hobe_section_properties, name, 'd', unit, doc)

static const struct hobe_lua_field fields[] = {
    PROPERTY(A, "m^2", "area"),
    PROPERTY(Iyy, "m^4", "integral of z^2"),
    PROPERTY(Izz, "m^4", "integral of y^2"),
    PROPERTY(Iyz, "m^4", "integral of y z"),
    PROPERTY(J, "m^4", "Saint-Venant's torsion constant, exact"),
    PROPERTY(J_w, "m^4", "torsion constant with this warping function, >= J"),
    PROPERTY(Iw, "m^6", "warping constant, integral of w^2"),
    PROPERTY(width, "m", "extent along y"),
    PROPERTY(height, "m", "extent along z"),
    {0}};

static int get_field(lua_State *L)
{
    hobe_section *const *section = luaL_checkudata(L, 1, HOBE_LUA_SECTION);
    const char *name = lua_tostring(L, 2);
    struct hobe_section_properties properties;
    if (!strcmp(name, "text")) {
        lua_pushstring(L, hobe_section_text(*section));
        return 1;
    }
    hobe_section_properties(*section, &properties);
    return hobe_lua_push_field(L, "a section", fields, &properties, name);
}

/* Pushes a section that is still empty, so that what is made next is owned from the start. */
static hobe_section **push_section(lua_State *L)
{
    hobe_section **section = lua_newuserdatauv(L, sizeof *section, 0);
    *section = NULL;
    hobe_lua_set_type(L, HOBE_LUA_SECTION, finalize, NULL, get_field);
    return section;
}

/* ---- rectangles ----------------------------------------------------------------------------- */

struct rectangle {
    double width, height, side;
    int warping;
};

#define SIZE(name, text)                                                                           \
    KEY(struct rectangle, name, KEY_NUMBER, REQUIRED, KEY_ABOVE(0), .unit = "m", .doc = text)
#define WARPING                                                                                    \
    KEY(struct rectangle, warping, KEY_CHOICE, .choices = "series|paper", .word = "series",        \
        .doc = "warping function: the Saint-Venant series summed to convergence, or only its "     \
               "first term as in the paper")

static const struct hobe_lua_key rectangle_keys[] = {
    SIZE(width, "size along y"), SIZE(height, "size along z"), WARPING, {0}};
static const struct hobe_lua_key square_keys[] = {SIZE(side, "size along y and z"), WARPING, {0}};

static const struct hobe_lua_schema rectangle_schema = {"rectangle", rectangle_keys};
static const struct hobe_lua_schema square_schema = {"square", square_keys};

static int make_rectangle(lua_State *L, double width, double height, int warping)
{
    enum hobe_warping kind = warping == 2 ? HOBE_WARPING_PAPER : HOBE_WARPING_SERIES;
    struct hobe_error err;
    hobe_section **section = push_section(L);
    *section = hobe_section_rectangle(width, height, kind, &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

static int rectangle(lua_State *L)
{
    struct rectangle r;
    hobe_lua_read(L, 1, &rectangle_schema, &r);
    return make_rectangle(L, r.width, r.height, r.warping);
}

static int square(lua_State *L)
{
    struct rectangle r;
    hobe_lua_read(L, 1, &square_schema, &r);
    return make_rectangle(L, r.side, r.side, r.warping);
}

const struct hobe_lua_entry hobe_lua_section_entries[] = {
    {"rectangle", rectangle, "hobe.rectangle{width =, height =}",
     "A solid rectangle, about its centroid.  Besides the fields below, `text` says in words what "
     "the section and its warping function are.",
     &rectangle_schema, fields},
    {"square", square, "hobe.square{side =}", "A solid square; fields as of a rectangle.",
     &square_schema, NULL},
    {0}};
