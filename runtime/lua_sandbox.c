/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a case script from a stranger can reach: the standard libraries without processes, other
 * libraries, compiled chunks, finalizers and files outside the output folder.
 *
 * Finalizers are left out because Lua runs them where no limit on time can name a line. */
#include "lua_hobe.h"

#include <lualib.h>
#include <string.h>

/* ---- refusals ------------------------------------------------------------------------------- */

/* Called in place of a function (upvalue 1: its name). */
static int refuse_call(lua_State *L)
{
    return hobe_lua_fail(L, "%s is not for case scripts (hobe run --trust allows it)",
                         lua_tostring(L, lua_upvalueindex(1)));
}

/* __index of a library (upvalue 1: its name) of which only a part is there. */
static int refuse_field(lua_State *L)
{
    lua_settop(L, 2);
    return hobe_lua_fail(L, "%s.%s is not for case scripts (hobe run --trust allows it)",
                         lua_tostring(L, lua_upvalueindex(1)), luaL_tolstring(L, 2, NULL));
}

/* Sets global `name` to a function that refuses. */
static void forbid_global(lua_State *L, const char *name)
{
    lua_pushstring(L, name);
    lua_pushcclosure(L, refuse_call, 1);
    lua_setglobal(L, name);
}

/* Pops a table and makes it the library `name`, which refuses all that is not in it. */
static void set_library(lua_State *L, const char *name)
{
    lua_createtable(L, 0, 2);
    lua_pushstring(L, name);
    lua_pushcclosure(L, refuse_field, 1);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
    lua_setglobal(L, name);
}

/* Makes the library `name` of only the functions in `keep`, which ends with NULL. */
static void keep_functions(lua_State *L, const char *name, const char *const *keep)
{
    lua_getglobal(L, name);
    lua_newtable(L);
    for (; *keep; keep++) {
        lua_getfield(L, -2, *keep);
        lua_setfield(L, -2, *keep);
    }
    set_library(L, name);
    lua_pop(L, 1);
}

/* ---- wrapped functions ---------------------------------------------------------------------- */

/* Calls a C function of the libraries (upvalue 1), which may work for long, with the line noted
 * that called it.  It runs in this function's own frame, so that its errors are the usual ones;
 * the wrapped functions have no upvalues. */
static int call_marked(lua_State *L)
{
    hobe_lua_mark_place(L);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/* Wraps the function on top of the stack. */
static void wrap(lua_State *L, lua_CFunction wrapper)
{
    lua_pushcclosure(L, wrapper, 1);
}

static void mark_library(lua_State *L, const char *name)
{
    lua_getglobal(L, name);
    for (lua_pushnil(L); lua_next(L, -2);) {
        if (!lua_iscfunction(L, -1)) {
            lua_pop(L, 1);
            continue;
        }
        wrap(L, call_marked);
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        lua_rawset(L, -4);
    }
    lua_pop(L, 1);
}

/* load(chunk [, name [, mode [, env]]]): text only, whatever the mode says. */
static int load_text(lua_State *L)
{
    if (lua_gettop(L) < 3)
        lua_settop(L, 3);
    lua_pushliteral(L, "t");
    lua_replace(L, 3);
    return call_marked(L);
}

static int set_metatable(lua_State *L)
{
    if (lua_istable(L, 2)) {
        lua_pushliteral(L, "__gc");
        if (lua_rawget(L, 2) != LUA_TNIL)
            hobe_lua_fail(L, "setmetatable: finalizers (__gc) are not for case scripts");
        lua_pop(L, 1);
    }
    return call_marked(L);
}

static int collect_garbage(lua_State *L)
{
    if (strcmp(luaL_optstring(L, 1, "collect"), "count"))
        hobe_lua_fail(L, "collectgarbage: only \"count\" is for case scripts, got %s",
                      hobe_lua_describe(L, 1));
    return call_marked(L);
}

static void wrap_global(lua_State *L, const char *name, lua_CFunction wrapper)
{
    lua_getglobal(L, name);
    wrap(L, wrapper);
    lua_setglobal(L, name);
}

static int require_hobe(lua_State *L)
{
    const char *name = hobe_lua_text(L, 1, "require: the name");
    if (strcmp(name, "hobe"))
        hobe_lua_fail(L,
                      "require: only \"hobe\" is for case scripts, got \"%s\" (hobe run "
                      "--trust allows others)",
                      name);
    lua_getfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    lua_getfield(L, -1, "hobe");
    return 1;
}

/* ---- the sandbox ---------------------------------------------------------------------------- */

static void open_libraries(lua_State *L)
{
    static const luaL_Reg libraries[] = {{LUA_GNAME, luaopen_base},
                                         {LUA_STRLIBNAME, luaopen_string},
                                         {LUA_TABLIBNAME, luaopen_table},
                                         {LUA_MATHLIBNAME, luaopen_math},
                                         {LUA_UTF8LIBNAME, luaopen_utf8},
                                         {LUA_COLIBNAME, luaopen_coroutine},
                                         {LUA_OSLIBNAME, luaopen_os},
                                         {LUA_IOLIBNAME, luaopen_io},
                                         {NULL, NULL}};
    for (const luaL_Reg *library = libraries; library->name; library++) {
        luaL_requiref(L, library->name, library->func, 1);
        lua_pop(L, 1);
    }
}

void hobe_lua_open_sandbox(lua_State *L)
{
    static const char *const os[] = {"clock", "date", "difftime", "time", NULL};
    static const char *const io[] = {"close", "type", "write", "stderr", NULL};
    static const char *const nothing[] = {NULL};
    open_libraries(L);
    mark_library(L, "string");
    mark_library(L, "table");
    mark_library(L, "utf8");
    lua_getglobal(L, "string");
    lua_pushliteral(L, "string.dump");
    lua_pushcclosure(L, refuse_call, 1);
    lua_setfield(L, -2, "dump");
    lua_pop(L, 1);
    keep_functions(L, "os", os);
    keep_functions(L, "io", io);
    lua_getglobal(L, "io");
    lua_pushcfunction(L, hobe_lua_io_open);
    lua_setfield(L, -2, "open");
    lua_pop(L, 1);
    keep_functions(L, "debug", nothing);
    keep_functions(L, "package", nothing);
    forbid_global(L, "dofile");
    forbid_global(L, "loadfile");
    wrap_global(L, "load", load_text);
    wrap_global(L, "setmetatable", set_metatable);
    wrap_global(L, "collectgarbage", collect_garbage);
    lua_pushcfunction(L, require_hobe);
    lua_setglobal(L, "require");
}
