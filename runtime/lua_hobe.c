/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The Lua module: context, errors, parameters, and the list of all that it offers. */
#include "lua_hobe.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- the context ---------------------------------------------------------------------------- */

static const char context_key; /* its address names the context in the registry */

static int free_context(lua_State *L)
{
    struct hobe_lua *context = lua_touserdata(L, 1);
    hobe_lua_count_warnings(context);
    hobe_text_free(&context->tables);
    hobe_text_free(&context->newton);
    hobe_text_free(&context->motion);
    hobe_text_free(&context->chart);
    hobe_lua_forget_files(context);
    return 0;
}

double hobe_lua_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct hobe_lua *hobe_lua_context(lua_State *L)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &context_key);
    struct hobe_lua *context = lua_touserdata(L, -1);
    lua_pop(L, 1);
    if (context)
        return context;
    context = lua_newuserdatauv(L, sizeof *context, HOBE_LUA_STORES);
    *context = (struct hobe_lua){0};
    lua_createtable(L, 0, 1);
    lua_pushcfunction(L, free_context);
    lua_setfield(L, -2, "__gc");
    lua_setmetatable(L, -2);
    for (int i = 1; i <= HOBE_LUA_STORES; i++) {
        lua_newtable(L);
        lua_setiuservalue(L, -2, i);
    }
    lua_rawsetp(L, LUA_REGISTRYINDEX, &context_key);
    return context;
}

void hobe_lua_push_store(lua_State *L, enum hobe_lua_store store)
{
    hobe_lua_context(L);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &context_key);
    lua_getiuservalue(L, -1, (int)store);
    lua_remove(L, -2);
}

/* ---- errors --------------------------------------------------------------------------------- */

void hobe_lua_where(lua_State *L)
{
    lua_Debug at;
    for (int level = 0; lua_getstack(L, level, &at); level++) {
        lua_getinfo(L, "Sl", &at);
        if (at.currentline <= 0)
            continue;
        lua_pushfstring(L, "%s:%d", *at.source == '@' ? at.source + 1 : at.short_src,
                        at.currentline);
        return;
    }
    lua_pushliteral(L, "");
}

/* Raises the sentence on top of the stack, with the place below it in front. */
static _Noreturn void raise(lua_State *L)
{
    if (*lua_tostring(L, -2))
        lua_pushfstring(L, "%s: %s", lua_tostring(L, -2), lua_tostring(L, -1));
    lua_error(L);
    abort(); /* not reached: lua_error does not return */
}

int hobe_lua_fail(lua_State *L, const char *format, ...)
{
    va_list args;
    luaL_checkstack(L, 10, NULL);
    hobe_lua_where(L);
    va_start(args, format);
    lua_pushvfstring(L, format, args);
    va_end(args);
    raise(L);
}

int hobe_lua_raise(lua_State *L, const struct hobe_error *err)
{
    luaL_checkstack(L, 10, NULL);
    if (err->where)
        lua_pushstring(L, err->where);
    else
        hobe_lua_where(L);
    lua_pushstring(L, err->message);
    raise(L);
}

void hobe_lua_check_text(lua_State *L, const struct hobe_text *text)
{
    struct hobe_error err;
    if (hobe_text_check(text, &err))
        hobe_lua_raise(L, &err);
}

/* ---- values -------------------------------------------------------------------------------- */

int hobe_lua_push_numbers(lua_State *L, const double *x, int n)
{
    lua_createtable(L, n, 0);
    for (int i = 0; i < n; i++) {
        lua_pushnumber(L, x[i]);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

/* ---- parameters ----------------------------------------------------------------------------- */

/* Pushes the value that `text` from the command line gives a parameter of the type of its default
 * at index 2. */
static void push_override(lua_State *L, const char *name, const char *text)
{
    int whole = lua_isinteger(L, 2);
    switch (lua_type(L, 2)) {
    case LUA_TBOOLEAN:
        if (strcmp(text, "true") && strcmp(text, "false"))
            hobe_lua_fail(L, "argument %s=%s: parameter %s must be true or false", name, text,
                          name);
        lua_pushboolean(L, !strcmp(text, "true"));
        return;
    case LUA_TNUMBER:
        if (lua_stringtonumber(L, text) == 0 || !isfinite(lua_tonumber(L, -1)))
            hobe_lua_fail(L, "argument %s=%s: parameter %s must be a number", name, text, name);
        if (!whole)
            lua_pushnumber(L, lua_tonumber(L, -1));
        return;
    default:
        lua_pushstring(L, text);
    }
}

static void check_parameter(lua_State *L)
{
    const char *name = hobe_lua_text(L, 1, "param: the name");
    int good = isalpha((unsigned char)*name) || *name == '_';
    for (const char *c = name; *c; c++)
        good = good && (isalnum((unsigned char)*c) || *c == '_');
    if (!good)
        hobe_lua_fail(L, "param: a name is letters, digits and _, got %s", hobe_lua_describe(L, 1));
    if (lua_type(L, 2) == LUA_TNUMBER)
        hobe_lua_number(L, 2, "param: the default");
    else if (lua_type(L, 2) == LUA_TSTRING)
        hobe_lua_text(L, 2, "param: the default");
    else if (!lua_isboolean(L, 2))
        hobe_lua_fail(L, "param: the default of %s must be a number, string or boolean, got %s",
                      name, hobe_lua_describe(L, 2));
}

/* hobe.param(name, default) */
static int parameter(lua_State *L)
{
    lua_settop(L, 2);
    check_parameter(L);
    const char *name = lua_tostring(L, 1);
    hobe_lua_push_store(L, HOBE_LUA_PARAMETERS);
    if (lua_getfield(L, -1, name) != LUA_TNIL && !lua_rawequal(L, -1, 2))
        hobe_lua_fail(L, "param: %s has the default %s already, got %s", name,
                      hobe_lua_describe(L, 4), hobe_lua_describe(L, 2));
    lua_pushvalue(L, 2);
    lua_setfield(L, 3, name);
    hobe_lua_push_store(L, HOBE_LUA_OVERRIDES);
    if (lua_getfield(L, -1, name) == LUA_TNIL) {
        lua_settop(L, 2);
        return 1;
    }
    push_override(L, name, lua_tostring(L, -1));
    if (!lua_rawequal(L, -1, 2))
        hobe_lua_context(L)->overridden = 1;
    return 1;
}

void hobe_lua_check_overrides(lua_State *L)
{
    hobe_lua_push_store(L, HOBE_LUA_OVERRIDES);
    hobe_lua_push_store(L, HOBE_LUA_PARAMETERS);
    for (lua_pushnil(L); lua_next(L, -3); lua_pop(L, 1)) {
        struct hobe_lua_nearest nearest = {.word = lua_tostring(L, -2)};
        if (lua_getfield(L, -3, nearest.word) == LUA_TNIL) {
            for (lua_pushnil(L); lua_next(L, -5); lua_pop(L, 1))
                hobe_lua_try(&nearest, lua_tostring(L, -2));
            if (nearest.best)
                hobe_lua_fail(L, "the case has no parameter \"%s\", did you mean \"%s\"?",
                              nearest.word, nearest.best);
            hobe_lua_fail(L, "the case has no parameters, got \"%s\"", nearest.word);
        }
        lua_pop(L, 1);
    }
    lua_pop(L, 2);
}

/* ---- elements ------------------------------------------------------------------------------- */

static void set_number(lua_State *L, const char *key, lua_Integer value)
{
    lua_pushinteger(L, value);
    lua_setfield(L, -2, key);
}

static void set_string(lua_State *L, const char *key, const char *value)
{
    lua_pushstring(L, value);
    lua_setfield(L, -2, key);
}

/* hobe.elements() */
static int elements(lua_State *L)
{
    lua_newtable(L);
    for (int i = 0; hobe_kernels()[i]; i++) {
        const struct hobe_kernel *kernel = hobe_kernels()[i];
        lua_newtable(L);
        set_string(L, "name", kernel->name);
        set_string(L, "source", kernel->source);
        set_string(L, "mechanics", kernel->mechanics);
        set_string(L, "hash", kernel->hash);
        set_number(L, "nodes", kernel->nodes);
        set_number(L, "dofs", 3 * kernel->vectors);
        set_number(L, "stations", kernel->stations);
        set_number(L, "flops_force", kernel->flops_force);
        set_number(L, "flops_tangent", kernel->flops_tangent);
        lua_createtable(L, kernel->modes, 0);
        for (int k = 0; k < kernel->modes; k++) {
            lua_pushstring(L, kernel->mode[k]);
            lua_rawseti(L, -2, k + 1);
        }
        lua_setfield(L, -2, "modes");
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static const struct hobe_lua_entry general_entries[] = {
    {"param", parameter, "hobe.param(name, default)",
     "The value of a parameter: what the command line says (`hobe run case.lua name=value`), else "
     "`default`, whose type (number, string, boolean) it keeps: `element=3333` stays a string.",
     NULL, NULL},
    {"elements", elements, "hobe.elements()",
     "A list of the elements built in, each a table with `name`, `nodes`, `dofs`, `modes`, "
     "`stations`, `flops_force`, `flops_tangent`, `mechanics` (its default), `source`, `hash`.",
     NULL, NULL},
    {0}};

/* ---- the module ----------------------------------------------------------------------------- */

const struct hobe_lua_chapter hobe_lua_chapters[] = {
    {"General", general_entries, 0},
    {"Sections", hobe_lua_section_entries, 0},
    {"Composite sections", hobe_lua_composite_entries, 0},
    {"Sections along a beam", hobe_lua_taper_entries, 0},
    {"Methods of a section", hobe_lua_section_methods, 1},
    {"Beams", hobe_lua_beam_entries, 0},
    {"Rigid bodies", hobe_lua_body_entries, 0},
    {"Supports and joints", hobe_lua_joint_entries, 0},
    {"Springs and dampers", hobe_lua_spring_entries, 0},
    {"Loads and initial velocities", hobe_lua_load_entries, 0},
    {"Functions of time", hobe_lua_drive_entries, 0},
    {"Scenes", hobe_lua_scene_entries, 0},
    {"Solving", hobe_lua_solve_entries, 0},
    {"Results", hobe_lua_result_methods, 1},
    {"Motion in time", hobe_lua_dynamic_entries, 0},
    {"A motion", hobe_lua_history_methods, 1},
    {"Vibration and buckling", hobe_lua_modal_entries, 0},
    {"Modes", hobe_lua_modes_methods, 1},
    {"Reduced models", hobe_lua_reduce_entries, 0},
    {"A reduced model", hobe_lua_reduced_methods, 1},
    {"One element", hobe_lua_kernel_entries, 0},
    {"Methods of an element", hobe_lua_kernel_methods, 1},
    {"Reports", hobe_lua_report_entries, 0},
    {"Charts of models", hobe_lua_chart_entries, 0},
    {"Tables and diagrams", hobe_lua_figure_entries, 0},
    {"Pictures", hobe_lua_picture_entries, 0},
    {"Files for ParaView", hobe_lua_vtk_entries, 0},
    {0}};

void hobe_lua_add_entries(lua_State *L, const struct hobe_lua_entry *entry)
{
    for (; entry->name; entry++) {
        lua_pushcfunction(L, entry->function);
        lua_setfield(L, -2, entry->name);
    }
}

/* The __index of an object: a method (from upvalue 1), else a field (by upvalue 2). */
static int object_index(lua_State *L)
{
    hobe_lua_text(L, 2, "the name of a field");
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL)
        return 1;
    return lua_tocfunction(L, lua_upvalueindex(2))(L);
}

void hobe_lua_set_type(lua_State *L, const char *type, lua_CFunction finalizer,
                       const struct hobe_lua_entry *methods, lua_CFunction field)
{
    if (luaL_newmetatable(L, type)) {
        lua_pushcfunction(L, finalizer);
        lua_setfield(L, -2, "__gc");
        if (field) {
            lua_newtable(L);
            if (methods)
                hobe_lua_add_entries(L, methods);
            lua_pushcfunction(L, field);
            lua_pushcclosure(L, object_index, 2);
            lua_setfield(L, -2, "__index");
        }
        lua_pushstring(L, strchr(type, '.') + 1); /* what sentences call it */
        lua_setfield(L, -2, "__name");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
    }
    lua_setmetatable(L, -2);
}

int luaopen_hobe(lua_State *L)
{
    luaL_checkversion(L);
    hobe_lua_context(L);
    lua_newtable(L);
    for (const struct hobe_lua_chapter *chapter = hobe_lua_chapters; chapter->title; chapter++)
        if (!chapter->methods)
            hobe_lua_add_entries(L, chapter->entry);
    lua_pushliteral(L, HOBE_VERSION);
    lua_setfield(L, -2, "version");
    return 1;
}
