/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reduced models, which solver verbs take like scenes. */
#include "lua_item.h"

#include <math.h>
#include <string.h>

enum { SCENE = 1, OWNER }; /* user values: the scene; what owns the basis, if not itself */

enum { MOST_BYTES = 1 << 30 };

static int finalize(lua_State *L)
{
    struct hobe_lua_reduced *r = luaL_checkudata(L, 1, HOBE_LUA_REDUCED);
    hobe_model_free(r->scene.model);
    r->scene.model = NULL;
    if (r->owned)
        hobe_reduced_free(r->reduced);
    r->reduced = NULL;
    return 0;
}

#define INFO(name, type, unit, doc) FIELD(struct hobe_reduced_info, name, type, unit, doc)

static const struct hobe_lua_field fields[] = {
    INFO(unknowns, 'i', NULL, "coordinates of the basis"),
    INFO(whole, 'l', NULL, "unknowns of the scene"),
    INFO(closed, 'i', NULL, "2 or 3 where any rotation in a plane or in space is in the basis"),
    INFO(seconds, 'd', "s", "making the basis and the energy on it, or reading them"),
    {0}};

static int get_field(lua_State *L)
{
    const struct hobe_lua_reduced *r = luaL_checkudata(L, 1, HOBE_LUA_REDUCED);
    struct hobe_reduced_info info;
    hobe_reduced_info(r->reduced, &info);
    return hobe_lua_push_field(L, "a reduced model", fields, &info, lua_tostring(L, 2));
}

struct hobe_lua_scene *hobe_lua_read_scene(lua_State *L, const char *verb)
{
    struct hobe_lua_scene *scene = luaL_testudata(L, 1, HOBE_LUA_SCENE);
    if (!scene)
        scene = luaL_testudata(L, 1, HOBE_LUA_REDUCED);
    if (!scene)
        hobe_lua_fail(L, "%s must be given a scene, %s(hobe.scene{...}), got %s", verb, verb,
                      hobe_lua_describe(L, 1));
    return scene;
}

/* A coarse mesh beside it, which it should beat. */
static void note_coarse(lua_State *L, struct hobe_lua_reduced *r, const hobe_solution *state)
{
    struct hobe_coarse coarse;
    struct hobe_error err;
    r->compared = 1;
    if (hobe_reduced_coarse(r->scene.model, state, &coarse, &err))
        hobe_lua_raise(L, &err);
    if (coarse.elements > 0)
        hobe_lua_note(L, "a mesh of %d element%s, %ld unknowns: error %.1e, reduced %.1e",
                      coarse.elements, coarse.elements == 1 ? "" : "s", coarse.unknowns,
                      coarse.error, coarse.reduced);
}

void hobe_lua_note_reduced(lua_State *L, double indicator, const hobe_solution *state)
{
    static const char *const methods[] = {"series", "modes", "fields"};
    struct hobe_lua_reduced *r = luaL_testudata(L, 1, HOBE_LUA_REDUCED);
    struct hobe_reduced_info info;
    char text[120] = "";
    if (!r)
        return;
    hobe_reduced_info(r->reduced, &info);
    if (isfinite(indicator))
        snprintf(text, sizeof text, ", indicator %.1e", indicator);
    else if (isinf(indicator))
        snprintf(text, sizeof text,
                 ", indicator infinite: the result means nothing; take more "
                 "modes, its load into loads, or a nearer centre");
    hobe_lua_note(L, "reduced: %s, %d unknowns of %ld, offline %.2g s%s", methods[info.method],
                  info.unknowns, info.whole, info.seconds, text);
    if (state && !r->compared)
        note_coarse(L, r, state);
}

/* ---- making them ------------------------------------------------------------------------------
 */

struct options {
    struct hobe_reduce reduce;
    const char *file;
};

#define REDUCE(name, kind, ...) KEY_AS(#name, struct options, reduce.name, kind, __VA_ARGS__)

static const struct hobe_lua_key reduce_keys[] = {
    REDUCE(modes, KEY_WHOLE, KEY_WITHIN(0, 1000),
           .doc = "unknowns at most; as many as accuracy needs, or 12, where left out"),
    REDUCE(accuracy, KEY_NUMBER, KEY_FROM(0),
           .doc = "of displacements under the loads of interest, relative to their size"),
    REDUCE(method, KEY_CHOICE, .choices = "series|modes", .word = "series",
           .doc = "`series`: where the paths under the loads lead; `modes`: the lowest "
                  "vibration modes with what they and the loads bring about"),
    KEY_OF_LIST("loads", .doc = "scenes of the same beams and supports whose loads are of "
                                "interest, too"),
    REDUCE(centre, KEY_RESULT,
           .doc = "a result of the scene about which it is reduced; the reference where left out"),
    REDUCE(closed, KEY_WHOLE, KEY_WITHIN(0, 3),
           .doc = "3: any rotation of the whole is in the basis; 2: any in a plane"),
    REDUCE(normal, KEY_VECTOR, .doc = "of that plane"),
    KEY(struct options, file, KEY_TEXT,
        .doc = "a basis that r:save has written, for this scene; nothing else is then given"),
    {0}};

static const struct hobe_lua_schema reduce_schema = {"reduce", reduce_keys};

/* Pushes a reduced model of the scene at an index that is still empty. */
static struct hobe_lua_reduced *push_empty(lua_State *L, int scene)
{
    struct hobe_lua_reduced *r = lua_newuserdatauv(L, sizeof *r, 2);
    *r = (struct hobe_lua_reduced){.owned = 1};
    hobe_lua_set_type(L, HOBE_LUA_REDUCED, finalize, hobe_lua_reduced_methods, get_field);
    lua_pushvalue(L, scene);
    lua_setiuservalue(L, -2, SCENE);
    return r;
}

/* The scene at an index that is one, not reduced. */
static hobe_model *check_scene(lua_State *L, int index, const char *what)
{
    const struct hobe_lua_scene *scene = luaL_testudata(L, index, HOBE_LUA_SCENE);
    if (!scene)
        hobe_lua_fail(L, "%s must be a scene, hobe.scene{...}, got %s", what,
                      hobe_lua_describe(L, index));
    return scene->model;
}

/* The models of the list `loads` of the table at 2; on the stack, unless it is nil. */
static void read_loads(lua_State *L, struct hobe_reduce *options)
{
    hobe_lua_push_key(L, 2, &reduce_schema, "loads");
    if (lua_isnil(L, -1))
        return;
    const int list = lua_absindex(L, -1);
    const size_t count = hobe_lua_list_size(L, list, "reduce: loads");
    hobe_model **model = lua_newuserdatauv(L, (count + 1) * sizeof *model, 0);
    for (size_t i = 0; i < count; i++) {
        lua_rawgeti(L, list, (lua_Integer)i + 1);
        model[i] = check_scene(L, -1, "reduce: each of loads");
        lua_pop(L, 1);
    }
    options->loads = model;
    options->load_count = (int)count;
}

static enum hobe_status read_basis(lua_State *L, const char *name, hobe_model *model,
                                   hobe_reduced **reduced, struct hobe_error *err)
{
    struct hobe_text text = {0};
    hobe_lua_read_file(L, "reduce", name, MOST_BYTES, &text);
    const enum hobe_status status =
        hobe_reduced_read(model, text.at ? text.at : "", text.size, reduced, err);
    hobe_text_free(&text);
    return status;
}

/* hobe.reduce(scene, options) */
static int reduce(lua_State *L)
{
    struct options options = {.file = NULL};
    struct hobe_error err;
    lua_settop(L, 2);
    if (hobe_lua_context(L)->called)
        hobe_lua_fail(L, "reduce: a function that a solver calls cannot reduce");
    hobe_model *model = check_scene(L, 1, "reduce: what is reduced");
    if (lua_isnil(L, 2)) {
        lua_newtable(L);
        lua_replace(L, 2);
    }
    hobe_lua_read(L, 2, &reduce_schema, &options);
    options.reduce.method = options.reduce.method ? options.reduce.method - 1 : 0;
    read_loads(L, &options.reduce);
    struct hobe_lua_reduced *r = push_empty(L, 1);
    enum hobe_status status = HOBE_OK;
    if (options.file)
        status = read_basis(L, options.file, model, &r->reduced, &err);
    hobe_lua_pause_clock();
    if (!options.file)
        status = hobe_reduce(model, &options.reduce, &r->reduced, &err);
    if (!status)
        status = hobe_reduced_model(r->reduced, model, &r->scene.model, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    struct hobe_reduced_info info;
    hobe_reduced_info(r->reduced, &info);
    hobe_lua_context(L)->cost.setup += info.seconds;
    return 1;
}

/* ---- methods --------------------------------------------------------------------------------- */

/* r:on(scene) */
static int on(lua_State *L)
{
    const struct hobe_lua_reduced *of = luaL_checkudata(L, 1, HOBE_LUA_REDUCED);
    struct hobe_error err;
    lua_settop(L, 2);
    hobe_model *model = check_scene(L, 2, "on: what the basis is to serve");
    struct hobe_lua_reduced *r = push_empty(L, 2);
    r->owned = 0;
    r->reduced = of->reduced;
    lua_pushvalue(L, 1);
    lua_setiuservalue(L, -2, OWNER);
    hobe_lua_pause_clock();
    const enum hobe_status status = hobe_reduced_model(of->reduced, model, &r->scene.model, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    return 1;
}

/* r:save(name) */
static int save(lua_State *L)
{
    const struct hobe_lua_reduced *r = luaL_checkudata(L, 1, HOBE_LUA_REDUCED);
    const char *name = hobe_lua_text(L, 2, "save: the file name");
    struct hobe_error err;
    void *bytes;
    size_t size;
    hobe_lua_check_file(L, "save", name, ".basis");
    if (!hobe_lua_context(L)->folder)
        return 0;
    struct hobe_text *text = hobe_lua_stage(L, name);
    if (hobe_reduced_write(r->reduced, &bytes, &size, &err))
        hobe_lua_raise(L, &err);
    hobe_text_bytes(text, bytes, size);
    hobe_free(bytes);
    hobe_lua_check_text(L, text);
    hobe_lua_publish(L);
    return 0;
}

const struct hobe_lua_entry hobe_lua_reduced_methods[] = {
    {"on", on, "r:on(scene)",
     "The same basis for another scene of the same beams, joins and clamps, with its own loads, "
     "joints, springs and bodies.",
     NULL, NULL},
    {"save", save, "r:save(name)",
     "Writes the basis to a file, whose name ends in .basis, in the output folder, for "
     "`hobe.reduce(scene, {file = name})` in a later run.",
     NULL, NULL},
    {0}};

const struct hobe_lua_entry hobe_lua_reduce_entries[] = {
    {"reduce", reduce, "hobe.reduce(scene [, {modes =, accuracy =, method =, loads =, ...}])",
     "A scene whose displacements are sums of a few fields, with its exact strain energy on them: "
     "`hobe.static`, `hobe.path`, `hobe.modal` and `hobe.dynamic` take it in the place of the "
     "scene, and give results of the whole.  A step costs as little for many elements as for few; "
     "what is asked of each result, such as stress, is that of the sum.",
     &reduce_schema, fields},
    {0}};
