/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key `projection` of the verbs that solve. */
#include "lua_item.h"

static const struct hobe_lua_key keys[] = {
    KEY(struct hobe_projection, method, KEY_CHOICE, .choices = "cms|pod", .word = "cms",
        .doc = "`cms`: component modes of the tangent stiffness, those of interfaces (the nodes at "
               "joints, springs and loads) and the lowest normal modes between them, found again "
               "at each load step, or in motion by `deviation`; `pod`: the main directions of "
               "`training`, for good"),
    KEY(struct hobe_projection, modes, KEY_WHOLE, KEY_WITHIN(1, 1e6),
        .doc = "how many, those of interfaces included; of `pod` as many as `accuracy` asks for "
               "where left out"),
    KEY(struct hobe_projection, frequency, KEY_NUMBER, KEY_ABOVE(0), .unit = "rad/s",
        .doc = "of `cms`, in place of modes: all normal modes up to it"),
    KEY(struct hobe_projection, deviation, KEY_NUMBER, KEY_ABOVE(0), .fallback = 0.1,
        .doc = "of `cms` in motion: displacements, relative to the scene's size, after which modes "
               "are found again; an angle, rad, where the scene turns"),
    KEY(struct hobe_projection, accuracy, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-6,
        .doc = "of `pod`: the share of the displacements in training that may be left out"),
    KEY_OF_LIST("training", .doc = "of `pod`: results of this scene or of one of the same shape"),
    {0}};

const struct hobe_lua_schema hobe_lua_projection_schema = {"projection", keys};

static void read_training(lua_State *L, int list, struct hobe_projection *projection)
{
    static const struct hobe_lua_key result = {.name = "result", .type = KEY_RESULT, REQUIRED};
    const char *what = "projection: training";
    const size_t count = hobe_lua_list_size(L, list, what);
    const hobe_solution **snapshot =
        lua_newuserdatauv(L, (count > 0 ? count : 1) * sizeof(*snapshot), 0);
    for (size_t i = 0; i < count; i++) {
        lua_rawgeti(L, list, (lua_Integer)i + 1);
        const char *which = lua_pushfstring(L, "%s[%d]", what, (int)i + 1);
        hobe_lua_read_value(L, -2, which, &result, snapshot + i);
        lua_pop(L, 2);
    }
    projection->snapshot = snapshot;
    projection->snapshots = (int)count;
}

const struct hobe_projection *hobe_lua_finish_projection(lua_State *L,
                                                         const struct hobe_lua_schema *schema,
                                                         struct hobe_projection *projection)
{
    hobe_lua_push_key(L, 2, schema, "projection");
    if (lua_isnil(L, -1))
        return NULL;
    const int table = lua_gettop(L);
    projection->method =
        projection->method == 2 ? HOBE_PROJECTION_SNAPSHOTS : HOBE_PROJECTION_COMPONENTS;
    lua_getfield(L, table, "training");
    const int pod = projection->method == HOBE_PROJECTION_SNAPSHOTS;
    if (pod == lua_isnil(L, -1))
        hobe_lua_fail(L, pod ? "projection: method \"pod\" needs training, a list of results"
                             : "projection: training is for method \"pod\"");
    if (pod)
        read_training(L, lua_gettop(L), projection);
    else if ((projection->modes > 0) == (projection->frequency > 0))
        hobe_lua_fail(L, "projection: method \"cms\" needs modes, how many, or a frequency");
    return projection;
}
