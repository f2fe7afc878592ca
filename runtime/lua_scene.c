/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene: items in any order, built into a model that a solver verb can act on. */
#include "lua_item.h"

#include <string.h>

static int finalize(lua_State *L)
{
    struct hobe_lua_scene *scene = luaL_checkudata(L, 1, HOBE_LUA_SCENE);
    hobe_model_free(scene->model);
    scene->model = NULL;
    return 0;
}

#define INFO(name, type, unit, doc) FIELD(struct hobe_model_info, name, type, unit, doc)

static const struct hobe_lua_field fields[] = {
    INFO(beams, 'i', NULL, "number of beams"),
    INFO(bodies, 'i', NULL, "number of bodies"),
    INFO(elements, 'i', NULL, "number of elements"),
    INFO(vectors, 'l', NULL, "nodal vectors, held ones included"),
    INFO(unknowns, 'l', NULL, "scalar unknowns that are solved for"),
    INFO(nonzeros, 'l', NULL, "nonzeros of the tangent stiffness"),
    INFO(setup, 'd', "s", "time spent in building the scene"),
    {0}};

static int get_field(lua_State *L)
{
    struct hobe_lua_scene *scene = luaL_checkudata(L, 1, HOBE_LUA_SCENE);
    struct hobe_model_info info;
    hobe_model_info(scene->model, &info);
    return hobe_lua_push_field(L, "a scene", fields, &info, lua_tostring(L, 2));
}

/* ---- items ---------------------------------------------------------------------------------- */

/* The item at index; raises where it is something else. */
static const struct hobe_lua_item *check_item(lua_State *L, int index, lua_Integer place)
{
    const struct hobe_lua_item *item = luaL_testudata(L, index, HOBE_LUA_ITEM);
    if (!item)
        hobe_lua_fail(L,
                      "scene: item %I must be a beam, support or load such as hobe.beam{...}, "
                      "got %s",
                      (LUAI_UACINT)place, hobe_lua_describe(L, index));
    return item;
}

/* Copies the list at index 1 into a table that the script cannot change, and pushes that. */
static void copy_items(lua_State *L)
{
    if (!lua_istable(L, 1))
        hobe_lua_fail(L, "scene must be given a table, scene{...}, got %s",
                      hobe_lua_describe(L, 1));
    lua_Integer n = 0, count = (lua_Integer)lua_rawlen(L, 1);
    lua_newtable(L);
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1), n++)
        if (!lua_isinteger(L, -2))
            hobe_lua_fail(L, "scene: unknown key %s; a scene is a list of items",
                          hobe_lua_describe(L, -2));
    if (n != count)
        hobe_lua_fail(L, "scene: there are holes (nil) between the items");
    for (lua_Integer i = 1; i <= count; i++) {
        lua_rawgeti(L, 1, i);
        check_item(L, -1, i);
        lua_rawseti(L, -2, i);
    }
}

static enum hobe_status add_item(hobe_model *model, const struct hobe_lua_item *item,
                                 struct hobe_error *err)
{
    switch (item->kind) {
    case ITEM_BEAM:
        return hobe_model_beam(model, &item->as.beam, err);
    case ITEM_BODY:
        return hobe_model_body(model, &item->as.body, err);
    case ITEM_MASS:
        return hobe_model_mass(model, &item->as.mass, err);
    case ITEM_CLAMP:
        return hobe_model_clamp(model, &item->as.clamp, err);
    case ITEM_FORCE:
        return hobe_model_force(model, &item->as.force, err);
    case ITEM_MOMENT:
        return hobe_model_moment(model, &item->as.moment, err);
    case ITEM_GRAVITY:
        return hobe_model_gravity_history(model, item->as.gravity.where, item->as.gravity.value,
                                          item->as.gravity.history, err);
    case ITEM_SPIN:
        return hobe_model_spin(model, &item->as.spin, err);
    case ITEM_JOIN:
        return hobe_model_join(model, &item->as.join, err);
    case ITEM_JOINT:
        return hobe_model_joint(model, &item->as.joint, err);
    case ITEM_SPRING:
        return hobe_model_spring(model, &item->as.spring, err);
    case ITEM_MOTION:
        return hobe_model_motion(model, &item->as.motion, err);
    }
    return HOBE_OK;
}

/* Says with the results which physics a beam has, since it may be the element's choice. */
static void note_beam(lua_State *L, const struct hobe_beam *beam)
{
    const char *mechanics = beam->mechanics == HOBE_MECHANICS_DEFAULT
                                ? beam->kernel->mechanics
                                : hobe_mechanics_name(beam->mechanics);
    const char *integration = beam->integration == HOBE_INTEGRATION_PAPER ? "paper" : "exact";
    hobe_lua_note(L, "beam %s: %s, mechanics %s, integration %s", beam->name, beam->kernel->name,
                  mechanics, integration);
}

/* Adds the items of the list at index `items` to the model. */
static void add_items(lua_State *L, int items, hobe_model *model)
{
    int parts = 0;
    for (lua_Integer i = 1; lua_rawgeti(L, items, i) != LUA_TNIL; i++) {
        const struct hobe_lua_item *item = lua_touserdata(L, -1);
        struct hobe_error err;
        hobe_lua_pause_clock();
        enum hobe_status status = add_item(model, item, &err);
        hobe_lua_resume_clock();
        if (status)
            hobe_lua_raise(L, &err);
        if (item->kind == ITEM_BEAM)
            note_beam(L, &item->as.beam);
        parts += item->kind == ITEM_BEAM || item->kind == ITEM_BODY;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (parts == 0)
        hobe_lua_fail(L, "scene: there is no hobe.beam{...} or hobe.body{...} in it");
}

/* ---- scenes --------------------------------------------------------------------------------- */

/* Counts what the model took, and tells Lua's collector what it weighs, which it cannot see, so that
 * a script that makes many scenes has the old ones freed in time. */
static void weigh(lua_State *L, const hobe_model *model)
{
    struct hobe_lua *context = hobe_lua_context(L);
    struct hobe_model_info info;
    hobe_model_info(model, &info);
    context->cost.setup += info.setup;
    if (info.unknowns > context->cost.unknowns)
        context->cost.unknowns = info.unknowns;
    long kilobytes = (40 * info.nonzeros + 200 * info.vectors) / 1024;
    lua_gc(L, LUA_GCSTEP, kilobytes < 1000000 ? (int)kilobytes : 1000000);
}

static void build(lua_State *L, hobe_model *model)
{
    struct hobe_error err;
    hobe_lua_pause_clock();
    enum hobe_status status = hobe_model_build(model, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    for (int i = 0; hobe_model_note(model, i); i++)
        hobe_lua_note(L, "%s", hobe_model_note(model, i));
    weigh(L, model);
}

/* hobe.scene{items...} */
static int scene(lua_State *L)
{
    struct hobe_error err;
    lua_settop(L, 1);
    copy_items(L);
    struct hobe_lua_scene *made = lua_newuserdatauv(L, sizeof *made, 1);
    made->model = NULL;
    hobe_lua_set_type(L, HOBE_LUA_SCENE, finalize, NULL, get_field);
    lua_pushvalue(L, 2);
    lua_setiuservalue(L, 3, 1);
    made->model = hobe_model_new(&err);
    if (!made->model)
        hobe_lua_raise(L, &err);
    add_items(L, 2, made->model);
    build(L, made->model);
    return 1;
}

const struct hobe_lua_entry hobe_lua_scene_entries[] = {
    {"scene", scene, "hobe.scene{items...}",
     "A scene of beams, bodies, supports and loads in any order, checked and made ready to be "
     "solved.  An "
     "error names the line of the item at fault.",
     NULL, fields},
    {0}};
