/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene: items in any order, built into a model that a solver verb can act on. */
#include "advise.h"
#include "lua_item.h"

#include <math.h>
#include <string.h>

static const struct hobe_lua_key scene_keys[] = {
    {.name = "accuracy",
     .type = KEY_NUMBER,
     KEY_BETWEEN(0, 1),
     .doc = "has the scene choose its model: the cheapest whose quantities are right to this share "
            "of them (or of a hundredth of the largest of the same unit, where that is more). "
            "What beams say of `element` and `elements` does not count then, but for how "
            "`elements` of several compare; notes say which model it is, what it needs and what "
            "leaving out the rest loses"},
    KEY_OF_OTHER("quantities", "function",
                 .doc =
                     "with accuracy: a function that gets a scene and gives a table "
                     "`{name = number}` or `{name = {number, unit}}` of what is wanted of it, by "
                     "any verb; without it displacements and rotations of the ends and middles "
                     "of beams, in statics"),
    {0}};

static const struct hobe_lua_schema scene_schema = {"scene", scene_keys};

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

/* Whether the key at index is one of a scene's own. */
static int is_key(lua_State *L, int index)
{
    for (const struct hobe_lua_key *key = scene_keys; key->name; key++)
        if (lua_type(L, index) == LUA_TSTRING && !strcmp(lua_tostring(L, index), key->name))
            return 1;
    return 0;
}

/* Copies the list at index 1 into a table that the script cannot change, and pushes that. */
static void copy_items(lua_State *L)
{
    if (!lua_istable(L, 1))
        hobe_lua_fail(L, "scene must be given a table, scene{...}, got %s",
                      hobe_lua_describe(L, 1));
    lua_Integer n = 0, count = (lua_Integer)lua_rawlen(L, 1);
    lua_newtable(L);
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1))
        if (lua_isinteger(L, -2))
            n++;
        else if (!is_key(L, -2))
            hobe_lua_fail(L,
                          "scene: unknown key %s; a scene is a list of items, and may have "
                          "accuracy and quantities",
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

/* Adds a beam as a model has it: with its element and so many elements, where the beam that has
 * most, `most`, has those of the model. */
static enum hobe_status add_beam(hobe_model *to, const struct hobe_beam *given,
                                 const struct advise_model *model, int most, struct hobe_error *err)
{
    struct hobe_beam beam = *given;
    const double share = (double)model->elements / most;
    beam.kernel = model->kernel;
    if (model->paper)
        beam.integration = HOBE_INTEGRATION_PAPER;
    beam.elements = (int)fmax(1, round(given->elements * share));
    if (model->without && (hobe_section_material(beam.section, 0) ||
                           !advise_leave_out(model->without, &beam.material)))
        return hobe_fail(err, HOBE_BAD_INPUT, given->where,
                         "what a beam with shear factors or materials of its section loses without "
                         "an effect cannot be said");
    return hobe_model_beam(to, &beam, err);
}

/* The most elements that a beam of the items has. */
static int most_elements(lua_State *L, int items)
{
    int most = 1;
    for (lua_Integer i = 1; lua_rawgeti(L, items, i) != LUA_TNIL; i++, lua_pop(L, 1)) {
        const struct hobe_lua_item *item = lua_touserdata(L, -1);
        if (item->kind == ITEM_BEAM && item->as.beam.elements > most)
            most = item->as.beam.elements;
    }
    lua_pop(L, 1);
    return most;
}

/* Says with the results which physics a beam has, since it may be the element's choice. */
static void note_beam(lua_State *L, const struct hobe_beam *beam, const struct hobe_kernel *kernel)
{
    const char *mechanics = beam->mechanics == HOBE_MECHANICS_DEFAULT
                                ? kernel->mechanics
                                : hobe_mechanics_name(beam->mechanics);
    const char *integration = beam->integration == HOBE_INTEGRATION_PAPER ? "paper" : "exact";
    hobe_lua_note(L, "beam %s: %s, mechanics %s, integration %s", beam->name, kernel->name,
                  mechanics, integration);
}

/* Adds the items of the list at index `items` to the model. */
static void add_items(lua_State *L, int items, const struct advise_model *as, hobe_model *model)
{
    const int most = as ? most_elements(L, items) : 0;
    int parts = 0;
    for (lua_Integer i = 1; lua_rawgeti(L, items, i) != LUA_TNIL; i++) {
        const struct hobe_lua_item *item = lua_touserdata(L, -1);
        struct hobe_error err;
        hobe_lua_pause_clock();
        enum hobe_status status = as && item->kind == ITEM_BEAM
                                      ? add_beam(model, &item->as.beam, as, most, &err)
                                      : add_item(model, item, &err);
        hobe_lua_resume_clock();
        if (status)
            hobe_lua_raise(L, &err);
        if (item->kind == ITEM_BEAM)
            note_beam(L, &item->as.beam, as ? as->kernel : item->as.beam.kernel);
        parts += item->kind == ITEM_BEAM || item->kind == ITEM_BODY;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (parts == 0)
        hobe_lua_fail(L, "scene: there is no hobe.beam{...} or hobe.body{...} in it");
}

/* ---- scenes --------------------------------------------------------------------------------- */

/* Counts what the model took, and tells Lua's collector what it weighs, which it cannot see, so
 * that a script that makes many scenes has the old ones freed in time. */
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

struct hobe_lua_scene *hobe_lua_make_scene(lua_State *L, int items, const struct advise_model *as)
{
    struct hobe_error err;
    struct hobe_lua_scene *made = lua_newuserdatauv(L, sizeof *made, 1);
    made->model = NULL;
    hobe_lua_set_type(L, HOBE_LUA_SCENE, finalize, NULL, get_field);
    lua_pushvalue(L, items);
    lua_setiuservalue(L, -2, 1);
    made->model = hobe_model_new(&err);
    if (!made->model)
        hobe_lua_raise(L, &err);
    add_items(L, items, as, made->model);
    build(L, made->model);
    return made;
}

/* Pushes the function of the key `quantities`, or nil. */
static void push_quantities(lua_State *L)
{
    lua_getfield(L, 1, "quantities");
    if (!lua_isnil(L, -1) && !lua_isfunction(L, -1))
        hobe_lua_fail(L, "scene: quantities must be a function of a scene, got %s",
                      hobe_lua_describe(L, -1));
}

/* hobe.scene{items..., accuracy =, quantities =} */
static int scene(lua_State *L)
{
    double accuracy;
    lua_settop(L, 1);
    copy_items(L);
    push_quantities(L);
    if (lua_getfield(L, 1, "accuracy") != LUA_TNIL) {
        hobe_lua_read_value(L, 4, "scene: accuracy", scene_keys, &accuracy);
        if (!hobe_lua_context(L)->model) {
            hobe_lua_advise(L, 2, 3, accuracy);
            return 1;
        }
    } else if (!lua_isnil(L, 3))
        hobe_lua_fail(L, "scene: quantities are those of accuracy, which is missing");
    hobe_lua_make_scene(L, 2, hobe_lua_context(L)->model);
    return 1;
}

const struct hobe_lua_entry hobe_lua_scene_entries[] = {
    {"scene", scene, "hobe.scene{items... [, accuracy =, quantities =]}",
     "A scene of beams, bodies, supports and loads in any order, checked and made ready to be "
     "solved.  An "
     "error names the line of the item at fault.",
     &scene_schema, fields},
    {0}};
