/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hobe.body{...}: its sizes, and its inertia as principal values or a matrix. */
#include "lua_item.h"

struct body {
    struct hobe_body body;
    int shape;
    double radius, length, size[3];
};

#define BODY(name, kind, ...) KEY_AS(#name, struct body, body.name, kind, __VA_ARGS__)

static const struct hobe_lua_key keys[] = {
    BODY(name, KEY_TEXT, REQUIRED, .doc = "its name in the scene, for joints, loads and results"),
    BODY(mass, KEY_NUMBER, KEY_ABOVE(0), .unit = "kg", .doc = "its mass"),
    BODY(density, KEY_NUMBER, KEY_ABOVE(0), .unit = "kg/m^3",
         .doc = "density of a shape, in place of its mass"),
    BODY(centre, KEY_VECTOR, REQUIRED, .unit = "m", .doc = "its centre of mass in the reference"),
    KEY(struct body, shape, KEY_CHOICE, .choices = "cylinder|box|sphere",
        .doc = "a shape that its inertia is found of; a disk is a short cylinder"),
    KEY(struct body, radius, KEY_NUMBER, KEY_ABOVE(0), .unit = "m",
        .doc = "of a cylinder or sphere"),
    KEY(struct body, length, KEY_NUMBER, KEY_ABOVE(0), .unit = "m",
        .doc = "of a cylinder, along the axis"),
    KEY(struct body, size, KEY_VECTOR, .unit = "m", .doc = "of a box: its edges along the axes"),
    KEY_OF_OTHER("inertia", "{I1, I2, I3} or {{I11, I12, I13}, ...}", .unit = "kg m^2",
                 .doc =
                     "without a shape: about the centre of mass, on the body's axes, as principal "
                     "values or a symmetric matrix"),
    BODY(axis, KEY_VECTOR, .doc = "the first axis of shape and inertia; global X where left out"),
    BODY(second, KEY_VECTOR,
         .doc = "the second one, at a right angle; global Y where both are left out, and any where "
                "the body is round about the first"),
    {0}};

static const struct hobe_lua_schema body_schema = {"body", keys};

/* The sizes that a shape has, and no other. */
static void read_shape(lua_State *L, struct body *read)
{
    static const struct {
        const char *key;
        int of[4]; /* by shape */
    } sizes[] = {{"radius", {0, 1, 0, 1}}, {"length", {0, 1, 0, 0}}, {"size", {0, 0, 1, 0}}};
    static const char *const names[] = {"without a shape", "of shape cylinder", "of shape box",
                                        "of shape sphere"};
    for (int i = 0; i < 3; i++)
        if (hobe_lua_is_given(L, &body_schema, sizes[i].key) != sizes[i].of[read->shape])
            hobe_lua_fail(L, "body: a body %s %s %s", names[read->shape],
                          sizes[i].of[read->shape] ? "needs" : "has no", sizes[i].key);
    if (hobe_lua_is_given(L, &body_schema, "inertia") == (read->shape > 0))
        hobe_lua_fail(L, read->shape > 0
                             ? "body: its shape gives the inertia; leave inertia or shape out"
                             : "body: inertia is missing: {I1, I2, I3}, kg m^2; or a shape");
    read->body.shape = (enum hobe_shape)read->shape;
    for (int i = 0; i < 3; i++)
        read->body.size[i] = read->shape == HOBE_SHAPE_BOX ? read->size[i]
                             : i == 0                      ? read->radius
                             : i == 1                      ? read->length
                                                           : 0;
}

/* The inertia on top of the stack. */
static void read_inertia(lua_State *L, double inertia[3][3])
{
    static const struct hobe_lua_key row = {
        .type = KEY_VECTOR, REQUIRED, .doc = "three numbers {x, y, z}"};
    const int rows = lua_istable(L, -1) && lua_rawgeti(L, -1, 1) == LUA_TTABLE;
    double values[3];
    lua_settop(L, 2);
    if (!rows)
        hobe_lua_read_value(L, 2, "body: inertia", &row, values);
    for (int i = 0; i < 3; i++)
        if (rows) {
            lua_settop(L, 2);
            lua_rawgeti(L, 2, i + 1);
            hobe_lua_read_value(L, 3, lua_pushfstring(L, "body: inertia[%d]", i + 1), &row,
                                inertia[i]);
        } else
            inertia[i][i] = values[i];
    lua_settop(L, 2);
}

static int body(lua_State *L)
{
    struct body read = {.shape = 0};
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &body_schema, &read);
    read_shape(L, &read);
    hobe_lua_push_key(L, 1, &body_schema, "inertia");
    if (read.shape == 0)
        read_inertia(L, read.body.inertia);
    struct hobe_body *b = &hobe_lua_push_item(L, ITEM_BODY, &read.body, sizeof read.body)->as.body;
    b->where = hobe_lua_keep(L, WHERE);
    b->name = hobe_lua_keep_copy(L, b->name, NAME);
    return 1;
}

int hobe_lua_read_body_point(lua_State *L, int index, const char *method, double point[3])
{
    static const struct hobe_lua_key key = {.type = KEY_VECTOR};
    hobe_lua_read_value(L, index, lua_pushfstring(L, "%s: the point of the body", method), &key,
                        point);
    return !lua_isnoneornil(L, index);
}

const struct hobe_lua_entry hobe_lua_body_entries[] = {
    {"body", body,
     "hobe.body{name =, mass =, centre =, inertia =, axis =, second =} or hobe.body{name =, shape "
     "=, ..., density =, centre =}",
     "A rigid body, in natural coordinates: its centre of mass and three directions.  Joints, "
     "supports, forces and moments name it as they name a beam.",
     &body_schema, NULL},
    {0}};
