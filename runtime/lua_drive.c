/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of time and of motion: drives from numbers, lists, ramps and functions, and what lets
 * the core call functions of the script while it solves. */
#include "lua_item.h"

#include <limits.h>
#include <string.h>

/* ---- functions that the core calls ----------------------------------------------------------- */

struct script {
    lua_State *thread; /* of its own, so that it may be called from any place; [1] the function */
    struct hobe_lua *context;
    void (*body)(lua_State *L, struct script *); /* calls [2] on top of the stack, reads results */
    const char *what;                            /* "joint: angle", for sentences */
    double t;                                    /* of this call, s */
    const double *x, *v;                         /* m, m/s */
    double *out;
};

hobe_lua_script *hobe_lua_push_script(lua_State *L, int function, const char *what)
{
    struct script *script = lua_newuserdatauv(L, sizeof *script, 2);
    *script = (struct script){.thread = lua_newthread(L), .context = hobe_lua_context(L)};
    lua_pushvalue(L, function);
    lua_xmove(L, script->thread, 1);
    lua_setiuservalue(L, -2, 1);
    script->what = lua_pushstring(L, what);
    lua_setiuservalue(L, -2, 2);
    return script;
}

/* The struct script [1] calls its function [2]; may raise. */
static int call(lua_State *L)
{
    struct script *script = lua_touserdata(L, 1);
    script->body(L, script);
    return 0;
}

/* An error as a string. */
static int explain(lua_State *L)
{
    if (!lua_isstring(L, 1))
        lua_pushfstring(L, "the script failed with %s", hobe_lua_describe(L, 1));
    return 1;
}

/* Runs the body under lua_pcall: no error may leap over the core. */
static enum hobe_status run(struct script *script, void (*body)(lua_State *, struct script *),
                            struct hobe_error *err)
{
    lua_State *L = script->thread;
    const int paused = hobe_lua_clock_paused();
    if (!lua_checkstack(L, 5))
        return hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: too many nested calls");
    script->body = body;
    lua_pushcfunction(L, explain);
    lua_pushcfunction(L, call);
    lua_pushlightuserdata(L, script);
    lua_pushvalue(L, 1);
    if (paused)
        hobe_lua_resume_clock();
    script->context->called++;
    const int failed = lua_pcall(L, 2, 0, 2) != LUA_OK;
    script->context->called--;
    if (paused)
        hobe_lua_pause_clock();
    const char *text = failed ? lua_tostring(L, -1) : NULL;
    if (failed)
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s: %s", script->what, text ? text : "failed");
    lua_settop(L, 1);
    return failed ? HOBE_BAD_INPUT : HOBE_OK;
}

/* ---- drives ---------------------------------------------------------------------------------- */

static const struct hobe_lua_key value_key = {
    .type = KEY_NUMBER, REQUIRED, .doc = "the function must return a number"};
static const struct hobe_lua_key pair_key = {
    .type = KEY_PAIR, REQUIRED, .doc = "a pair {t, value}"};

static void call_with_time(lua_State *L, struct script *script)
{
    lua_pushnumber(L, script->t);
    lua_call(L, 1, 1);
    hobe_lua_read_value(L, 2, lua_pushfstring(L, "the value at t = %f", script->t), &value_key,
                        script->out);
}

/* A hobe_function. */
static enum hobe_status value_at(void *context, double t, double *f, struct hobe_error *err)
{
    struct script *script = context;
    script->t = t;
    script->out = f;
    return run(script, call_with_time, err);
}

struct ramp { /* of hobe.ramp, and of other lists on their way */
    int n;
    double point[][2];
};

/* Pushes the points of the list at the absolute index. */
static struct ramp *push_points(lua_State *L, int index, const char *what)
{
    const size_t n = hobe_lua_list_size(L, index, what);
    if (n > INT_MAX)
        hobe_lua_fail(L, "%s: the list is too long", what);
    struct ramp *ramp = lua_newuserdatauv(L, sizeof *ramp + n * sizeof *ramp->point, 0);
    ramp->n = (int)n;
    for (int i = 0; i < ramp->n; i++) {
        const char *part = lua_pushfstring(L, "%s[%d]", what, i + 1);
        lua_rawgeti(L, index, i + 1);
        hobe_lua_read_value(L, -1, part, &pair_key, ramp->point[i]);
        lua_pop(L, 2);
    }
    return ramp;
}

static int finalize(lua_State *L)
{
    hobe_drive **drive = luaL_checkudata(L, 1, HOBE_LUA_DRIVE);
    hobe_drive_free(*drive);
    *drive = NULL;
    return 0;
}

/* The drive of the value at index; pushes what it needs as long as it lives, or nothing. */
static hobe_drive *make_drive(lua_State *L, int index, const char *what, int integral,
                              struct hobe_error *err)
{
    const struct ramp *ramp = luaL_testudata(L, index, HOBE_LUA_RAMP);
    if (ramp)
        return hobe_drive_points(ramp->n, ramp->point, HOBE_RAMP, integral, err);
    if (lua_isfunction(L, index))
        return hobe_drive_function(value_at, hobe_lua_push_script(L, index, what), integral, err);
    if (lua_istable(L, index)) {
        ramp = push_points(L, index, what);
        return hobe_drive_points(ramp->n, ramp->point, HOBE_LINEAR, integral, err);
    }
    if (lua_type(L, index) != LUA_TNUMBER)
        hobe_lua_fail(L,
                      "%s must be a number, a list {{t, value}, ...}, hobe.ramp{...} or a function "
                      "of time, got %s",
                      what, hobe_lua_describe(L, index));
    const double constant[1][2] = {{0, hobe_lua_number(L, index, what)}};
    return hobe_drive_points(1, constant, HOBE_LINEAR, integral, err);
}

hobe_drive *hobe_lua_push_drive(lua_State *L, int index, const char *what, int integral)
{
    struct hobe_error err;
    hobe_drive **drive = lua_newuserdatauv(L, sizeof *drive, 1);
    const int top = lua_gettop(L);
    *drive = NULL;
    hobe_lua_set_type(L, HOBE_LUA_DRIVE, finalize, NULL, NULL);
    *drive = make_drive(L, index, what, integral, &err);
    if (!*drive)
        hobe_lua_fail(L, "%s: %s", what, err.message);
    if (lua_gettop(L) > top)
        lua_setiuservalue(L, top, 1);
    lua_settop(L, top);
    return *drive;
}

/* hobe.ramp{{t, value}, ...} */
static int ramp(lua_State *L)
{
    struct hobe_error err;
    lua_settop(L, 1);
    if (!lua_istable(L, 1))
        hobe_lua_fail(L, "ramp must be given a list {{t, value}, ...}, got %s",
                      hobe_lua_describe(L, 1));
    const struct ramp *made = push_points(L, 1, "ramp");
    hobe_drive *drive = hobe_drive_points(made->n, made->point, HOBE_RAMP, 0, &err);
    if (!drive)
        hobe_lua_fail(L, "ramp: %s", err.message);
    hobe_drive_free(drive);
    if (luaL_newmetatable(L, HOBE_LUA_RAMP)) {
        lua_pushliteral(L, "a ramp"); /* what sentences call it */
        lua_setfield(L, -2, "__name");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
    }
    lua_setmetatable(L, 2);
    return 1;
}

/* ---- forces ---------------------------------------------------------------------------------- */

static const struct hobe_lua_key vector_key = {
    .type = KEY_VECTOR, REQUIRED, .doc = "the function must return {x, y, z}"};

/* Leaves `results` of the function [2] from that place on. */
static void call_with_motion(lua_State *L, const struct script *script, int results)
{
    lua_pushnumber(L, script->t);
    hobe_lua_push_numbers(L, script->x, 3);
    hobe_lua_push_numbers(L, script->v, 3);
    lua_call(L, 3, results);
}

static void read_force(lua_State *L, struct script *script)
{
    call_with_motion(L, script, 1);
    hobe_lua_read_value(L, 2, lua_pushfstring(L, "the force at t = %f", script->t), &vector_key,
                        script->out);
}

/* Two lists of three rows; the second may be left out. */
static void read_derivative(lua_State *L, struct script *script)
{
    call_with_motion(L, script, 2);
    for (int i = 0; i < 2; i++) {
        const char *what = i ? "the derivative by v" : "the derivative by x";
        const int given = !lua_isnil(L, 2 + i);
        if (!given)
            memset(script->out + 9 * i, 0, 9 * sizeof(double));
        if (given ? !lua_istable(L, 2 + i) || lua_rawlen(L, 2 + i) != 3 : i == 0)
            hobe_lua_fail(L, "%s must be three rows {{x, y, z}, ...}, got %s", what,
                          hobe_lua_describe(L, 2 + i));
        for (int row = 0; given && row < 3; row++) {
            lua_rawgeti(L, 2 + i, row + 1);
            hobe_lua_read_value(L, 4, lua_pushfstring(L, "%s[%d]", what, row + 1), &vector_key,
                                script->out + 9 * i + 3 * row);
            lua_settop(L, 3);
        }
    }
}

enum hobe_status hobe_lua_force(void *context, double t, const double x[3], const double v[3],
                                double F[3], struct hobe_error *err)
{
    struct script *script = ((struct hobe_lua_scripts *)context)->value;
    script->t = t;
    script->x = x;
    script->v = v;
    script->out = F;
    return run(script, read_force, err);
}

enum hobe_status hobe_lua_force_derivative(void *context, double t, const double x[3],
                                           const double v[3], double G[2][3][3],
                                           struct hobe_error *err)
{
    struct script *script = ((struct hobe_lua_scripts *)context)->derivative;
    script->t = t;
    script->x = x;
    script->v = v;
    script->out = &G[0][0][0];
    return run(script, read_derivative, err);
}

const struct hobe_lua_entry hobe_lua_drive_entries[] = {
    {"ramp", ramp, "hobe.ramp{{t, value}, ...}",
     "A function of time that goes from point to point by v0 + (v1 - v0)(1 - cos(pi s))/2, s from "
     "0 to 1, at rest at each; constant before the first and after the last.  Wherever a function "
     "of time is asked for it may also be a number, a list `{{t, value}, ...}`, straight between "
     "its points and constant outside, where two points at one time make a jump, or a function of "
     "the script, `function(t) return value end`, of t >= 0 s and smooth: its derivatives are "
     "differences over 1/4096 s, and motions are integrals of velocities from t = 0, exact of "
     "points, by Gauss's rule in cells of 1/128 s of functions.",
     NULL, NULL},
    {0}};
