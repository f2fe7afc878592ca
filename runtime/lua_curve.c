/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The axis of a beam where it is more than a straight line: curves and twists from a script. */
#include "lua_item.h"

#include <limits.h>
#include <string.h>

static int finalize(lua_State *L)
{
    hobe_curve **curve = luaL_checkudata(L, 1, HOBE_LUA_CURVE);
    hobe_curve_free(*curve);
    *curve = NULL;
    return 0;
}

/* Pushes a curve that is still empty, so that what is made next is owned from the start. */
static hobe_curve **push_curve(lua_State *L)
{
    hobe_curve **curve = lua_newuserdatauv(L, sizeof *curve, 0);
    *curve = NULL;
    hobe_lua_set_type(L, HOBE_LUA_CURVE, finalize, NULL, NULL);
    return curve;
}

/* ---- functions of the script ---------------------------------------------------------------- */

static const struct hobe_lua_key position = {
    .type = KEY_VECTOR, REQUIRED, .doc = "the function must return {x, y, z}"};
static const struct hobe_lua_key angle = {
    .type = KEY_NUMBER, REQUIRED, .doc = "the function must return an angle"};

/* A function of the script on its way through the core. */
struct script {
    lua_State *L;
    int function; /* its place on the stack */
    const char *name;
    const struct hobe_lua_key *key; /* what it returns */
    double t, *f;                   /* of this call */
    int failed;                     /* the error is on top of the stack */
};

/* Calls the function [2] of the struct script [1]; may raise. */
static int call(lua_State *L)
{
    const struct script *script = lua_touserdata(L, 1);
    lua_pushnumber(L, script->t);
    lua_call(L, 1, 1);
    const char *what = lua_pushfstring(L, "beam: %s(%f)", script->name, script->t);
    hobe_lua_read_value(L, 2, what, script->key, script->f);
    return 0;
}

/* A hobe_function.  No error may leap over the core: it waits on the stack for raise_failure. */
static enum hobe_status call_script(void *context, double t, double *f, struct hobe_error *err)
{
    struct script *script = context;
    lua_State *L = script->L;
    if (!lua_checkstack(L, 3))
        return hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: too many nested calls");
    script->t = t;
    script->f = f;
    lua_pushcfunction(L, call);
    lua_pushlightuserdata(L, script);
    lua_pushvalue(L, script->function);
    script->failed = lua_pcall(L, 2, 0, 0) != LUA_OK;
    return script->failed ? hobe_fail(err, HOBE_BAD_INPUT, NULL, "the script failed") : HOBE_OK;
}

static void raise_failure(lua_State *L, const struct script *script, const struct hobe_error *err)
{
    if (script->failed)
        lua_error(L);
    hobe_lua_raise(L, err);
}

/* ---- curves and twists ---------------------------------------------------------------------- */

static hobe_curve *read_points(lua_State *L, int index, struct hobe_error *err)
{
    const size_t n = lua_rawlen(L, index);
    double(*r)[3] = lua_newuserdatauv(L, (n + 1) * sizeof *r, 0);
    size_t entries = 0;
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
        entries++;
    if (entries != n)
        hobe_lua_fail(L, "beam: curve must be a list of points {{x, y, z}, ...}, got a table with "
                         "other keys or holes");
    for (size_t i = 0; i < n; i++) {
        const char *what = lua_pushfstring(L, "beam: curve[%I]", (LUAI_UACINT)i + 1);
        lua_rawgeti(L, index, (lua_Integer)i + 1);
        hobe_lua_read_value(L, -1, what, &position, r[i]);
        lua_pop(L, 2);
    }
    hobe_curve *curve =
        hobe_curve_points(n < INT_MAX ? (int)n : INT_MAX, (const double(*)[3])r, err);
    lua_pop(L, 1);
    return curve;
}

static hobe_curve *read_curve(lua_State *L, int index, const struct hobe_beam *beam)
{
    struct hobe_error err;
    struct script script = {.L = L, .function = index, .name = "curve", .key = &position};
    hobe_curve *curve = NULL;
    double line[2][3];
    switch (lua_type(L, index)) {
    case LUA_TNIL:
        memcpy(line[0], beam->from, sizeof line[0]);
        memcpy(line[1], beam->to, sizeof line[1]);
        curve = hobe_curve_points(2, (const double(*)[3])line, &err);
        break;
    case LUA_TFUNCTION:
        curve = hobe_curve_function(call_script, &script, &err);
        break;
    case LUA_TTABLE:
        curve = read_points(L, index, &err);
        break;
    default:
        hobe_lua_fail(L,
                      "beam: curve must be a function of t or a list of points {x, y, z}, got %s",
                      hobe_lua_describe(L, index));
    }
    if (!curve)
        raise_failure(L, &script, &err);
    return curve;
}

/* A hobe_function: evenly from 0 to the angle. */
static enum hobe_status even_twist(void *context, double at, double *phi, struct hobe_error *err)
{
    (void)err;
    *phi = at * *(const double *)context;
    return HOBE_OK;
}

static void read_twist(lua_State *L, int index, hobe_curve *curve)
{
    struct hobe_error err;
    struct script script = {.L = L, .function = index, .name = "twist", .key = &angle};
    enum hobe_status status = HOBE_OK;
    if (lua_isfunction(L, index))
        status = hobe_curve_twist(curve, call_script, &script, &err);
    else if (lua_type(L, index) == LUA_TNUMBER) {
        double total = hobe_lua_number(L, index, "beam: twist");
        status = hobe_curve_twist(curve, even_twist, &total, &err);
    } else if (!lua_isnil(L, index))
        hobe_lua_fail(L, "beam: twist must be an angle or a function of it, got %s",
                      hobe_lua_describe(L, index));
    if (status)
        raise_failure(L, &script, &err);
}

const hobe_curve *hobe_lua_push_curve(lua_State *L, int curve, int twist,
                                      const struct hobe_beam *beam)
{
    if (lua_isnil(L, curve) && lua_isnil(L, twist)) {
        lua_pushnil(L);
        return NULL;
    }
    hobe_curve **made = push_curve(L);
    *made = read_curve(L, curve, beam);
    read_twist(L, twist, *made);
    return *made;
}
