/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Items of a scene: what their constructors, in rooms of their own, have in common.  Each checks
 * its table and returns an item that knows the line it was written in. */
#include "lua_item.h"

#include <string.h>

struct hobe_lua_item *hobe_lua_push_item(lua_State *L, enum hobe_lua_kind kind, const void *value,
                                         size_t size)
{
    struct hobe_lua_item *item = lua_newuserdatauv(L, sizeof *item, ANCHORS);
    memset(item, 0, sizeof *item);
    item->kind = kind;
    memcpy(&item->as, value, size);
    if (luaL_newmetatable(L, HOBE_LUA_ITEM)) {
        lua_pushliteral(L, "part of a scene"); /* what sentences call it */
        lua_setfield(L, -2, "__name");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
    }
    lua_setmetatable(L, -2);
    hobe_lua_where(L);
    return item;
}

const char *hobe_lua_keep(lua_State *L, int anchor)
{
    const char *s = lua_tostring(L, -1);
    lua_setiuservalue(L, -2, anchor);
    return s;
}

const char *hobe_lua_keep_copy(lua_State *L, const char *s, int anchor)
{
    lua_pushstring(L, s);
    return hobe_lua_keep(L, anchor);
}

int hobe_lua_is_given(lua_State *L, const struct hobe_lua_schema *schema, const char *key)
{
    hobe_lua_push_key(L, 1, schema, key);
    const int is = !lua_isnil(L, -1);
    lua_pop(L, 1);
    return is;
}

hobe_drive *hobe_lua_keep_drive(lua_State *L, const struct hobe_lua_schema *schema, const char *key,
                                int integral, int anchor)
{
    const int item = lua_gettop(L);
    hobe_drive *drive = NULL;
    hobe_lua_push_key(L, 1, schema, key);
    if (!lua_isnil(L, -1)) {
        const char *what = lua_pushfstring(L, "%s: %s", schema->name, key);
        drive = hobe_lua_push_drive(L, item + 1, what, integral);
        lua_setiuservalue(L, item, anchor);
    }
    lua_settop(L, item);
    return drive;
}

void hobe_lua_check_place(lua_State *L, const struct hobe_lua_schema *schema)
{
    if (!hobe_lua_is_given(L, schema, "at") && !hobe_lua_is_given(L, schema, "point"))
        hobe_lua_fail(L,
                      "%s: at is missing: the place on a beam, as a fraction of its length; or "
                      "point, {x, y, z}, of a body",
                      schema->name);
}

void hobe_lua_read_places(lua_State *L, const struct hobe_lua_schema *schema, int two, double at[2],
                          int *at_point)
{
    struct hobe_lua_key key = {.type = KEY_NUMBER, KEY_WITHIN(0, 1)};
    hobe_lua_check_place(L, schema);
    const char *what = lua_pushfstring(L, "%s: at", schema->name);
    hobe_lua_push_key(L, 1, schema, "at");
    const int number = lua_type(L, -1) == LUA_TNUMBER;
    if (two && !number)
        key = (struct hobe_lua_key){.type = KEY_PAIR};
    hobe_lua_read_value(L, -1, what, &key, at);
    if (two && number)
        at[1] = at[0];
    lua_pop(L, 2);
    *at_point = hobe_lua_is_given(L, schema, "point");
    if (*at_point && two && hobe_lua_is_given(L, schema, "to"))
        *at_point = 2;
}
