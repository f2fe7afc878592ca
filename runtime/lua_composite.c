/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections of several materials, as Lua sees them. */
#include "lua_item.h"

#define PART(name, kind, ...) KEY(struct hobe_section_part, name, kind, __VA_ARGS__)

static const struct hobe_lua_key part_keys[] = {
    PART(section, KEY_SECTION, REQUIRED, .doc = "a section, such as hobe.rectangle{...}"),
    PART(at, KEY_PAIR, .unit = "m",
         .doc = "{y, z}: where its origin is, {0, 0} where left out; that of an outline's "
                "coordinates, the centroid of a rectangle, circle or tube"),
    PART(material, KEY_GROUP, REQUIRED, .group = &hobe_lua_material_schema,
         .doc = "a table {E =, nu =, rho =, k2 =, k3 =, k =}"),
    {0}};
static const struct hobe_lua_schema part_schema = {"part", part_keys};

static const struct hobe_lua_key keys[] = {KEY_OF_LIST("{section =, at =, material =}, ...",
                                                       REQUIRED, .group = &part_schema,
                                                       .doc = "the parts"),
                                           {0}};
static const struct hobe_lua_schema schema = {"composite", keys};

/* The length of the list at index 1, which holds nothing else. */
static int count_parts(lua_State *L)
{
    if (!lua_istable(L, 1))
        hobe_lua_fail(L, "composite must be given a list of parts, got %s",
                      hobe_lua_describe(L, 1));
    const lua_Integer count = (lua_Integer)lua_rawlen(L, 1);
    if (count > HOBE_MAX_REGIONS)
        hobe_lua_fail(L, "composite: at most %d parts are possible, got %d", HOBE_MAX_REGIONS,
                      (int)count);
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1))
        if (!lua_isinteger(L, -2) || lua_tointeger(L, -2) < 1 || lua_tointeger(L, -2) > count)
            hobe_lua_fail(L,
                          "composite: unknown key %s; it holds parts {section =, at =, "
                          "material =}",
                          hobe_lua_describe(L, lua_absindex(L, -2)));
    return (int)count;
}

static int composite(lua_State *L)
{
    struct hobe_section_part part[HOBE_MAX_REGIONS];
    struct hobe_error err;
    lua_settop(L, 1);
    const int parts = count_parts(L);
    for (int k = 0; k < parts; k++) {
        const char *what = lua_pushfstring(L, "composite: part %d", k + 1);
        lua_rawgeti(L, 1, k + 1);
        hobe_lua_read_group(L, lua_absindex(L, -1), what, &part_schema, part + k);
        hobe_lua_finish_material(&part[k].material);
        lua_pop(L, 2);
    }
    hobe_section **section = hobe_lua_new_section(L);
    *section = hobe_section_composite(parts, part, &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

const struct hobe_lua_entry hobe_lua_composite_entries[] = {
    {"composite", composite, "hobe.composite{ {section =, at =, material =}, ... }",
     "A section of parts with materials of their own, which touch along edges in one piece and do "
     "not overlap; circles and tubes become polygons of 96 sides and the same area.  The axis goes "
     "through the centroid of EA.  Of the fields, A is the area; Iyy, Izz, Iyz, Iw and Wagner are "
     "weighted with E, J and J_w with G, over those of part 1: EI is E of part 1 times Iyy, GJ its "
     "G times J.  In ky, kz, kyz G A is the sum over the parts.",
     &schema, NULL},
    {0}};
