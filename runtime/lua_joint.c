/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Supports, joints and shared nodes. */
#include "lua_item.h"

/* ---- clamps --------------------------------------------------------------------------------- */

static const struct hobe_lua_key clamp_keys[] = {
    KEY_BEAM(struct hobe_clamp),
    KEY_PLACE(struct hobe_clamp),
    KEY_AS("warping", struct hobe_clamp, free_warping, KEY_CHOICE, .choices = "fixed|free",
           .word = "fixed",
           .doc = "fixed holds every vector of the node; free only its position and the section's "
                  "slopes y and z, so that the section may warp and the axis stretch there"),
    KEY_OWN_NAME(struct hobe_clamp, name),
    {0}};

static const struct hobe_lua_schema clamp_schema = {"clamp", clamp_keys};

static int clamp(lua_State *L)
{
    struct hobe_clamp read = {0};
    hobe_lua_read(L, 1, &clamp_schema, &read);
    read.free_warping = read.free_warping == 2;
    struct hobe_clamp *c = &hobe_lua_push_item(L, ITEM_CLAMP, &read, sizeof read)->as.clamp;
    c->where = hobe_lua_keep(L, WHERE);
    c->beam = hobe_lua_keep_copy(L, c->beam, NAME);
    c->name = hobe_lua_keep_copy(L, c->name, OWN_NAME);
    return 1;
}

/* ---- supports and joints -------------------------------------------------------------------- */

struct joint {
    struct hobe_joint joint;
    int kind;
};

#define JOINT(name, field, kind, ...) KEY_AS(name, struct joint, joint.field, kind, __VA_ARGS__)

/* What supports and joints have in common; kinds in the order of enum hobe_joint_kind. */
#define JOINT_KEYS                                                                                 \
    KEY(struct joint, kind, KEY_CHOICE, REQUIRED,                                                  \
        .choices = "fixed|spherical|revolute|universal|cylindrical|prismatic|planar|inline|"       \
                   "inplane|distance|rigid",                                                       \
        .doc = "what it stops.  All translations: fixed, and all rotations; spherical, no "        \
               "rotation; revolute, all but the one about the axis; universal, the one that "      \
               "would take `axis` and `second` from their right angle.  Translations across the "  \
               "axis: cylindrical, and all rotations but about it; prismatic, and all rotations; " \
               "inline, no rotation.  The translation along the axis: planar, and all rotations "  \
               "but about it; inplane, no rotation.  The translation along the line between two "  \
               "places that are apart: distance, a rod without mass.  rigid, to a body or the "    \
               "ground: all, and the mean plane of the beam's section is that part's, without "    \
               "shear or strain.  Warping stays free"),                                            \
        JOINT("axis", axis, KEY_VECTOR,                                                            \
              .doc = "its axis in the reference, global; it moves with the first beam, or stays"), \
        JOINT("second", second, KEY_VECTOR,                                                        \
              .doc = "of a universal joint: the axis of the second beam, at a right angle"),       \
        JOINT("point", point, KEY_VECTOR, .unit = "m",                                             \
              .doc = "the place on a body, global, in the reference"),                             \
        KEY_OF_TIME(                                                                               \
            "angle", "rad",                                                                        \
            "turns the second beam about the axis: what is left free of that motion is free "      \
            "no more.  For kinds whose axis cannot tilt: fixed, revolute, cylindrical, "           \
            "prismatic, planar"),                                                                  \
        KEY_OF_TIME("angular_velocity", "rad/s",                                                   \
                    "the same by its rate, from the angle 0 at t = 0"),                            \
        KEY_OF_TIME("position", "m",                                                               \
                    "shifts the second beam along the axis likewise, or lengthens a distance"),    \
        KEY_OF_TIME("velocity", "m/s", "the same by its rate, from 0 at t = 0"),                   \
        KEY_OWN_NAME(struct joint, joint.name),                                                    \
    {                                                                                              \
        0                                                                                          \
    }

static const struct hobe_lua_key support_keys[] = {
    JOINT("beam", beam[0], KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam or body"),
    JOINT("at", at[0], KEY_NUMBER, KEY_WITHIN(0, 1),
          .doc = "place on the beam, as a fraction of its length; not to be left out, but of a "
                 "body, which has a point instead"),
    JOINT("to", to, KEY_VECTOR, .unit = "m",
          .doc = "of a support that keeps a distance: the point of the ground from which"),
    JOINT_KEYS};

static const struct hobe_lua_key joint_keys[] = {
    JOINT("beam", beam[0], KEY_TEXT, REQUIRED, .position = 1,
          .doc = "name of the first beam or body"),
    JOINT("other", beam[1], KEY_TEXT, REQUIRED, .position = 2, .doc = "name of the second"),
    KEY_OF_OTHER("at", "number or {a, b}",
                 .doc =
                     "the places on both, as fractions of their length; or one number, of a beam "
                     "that is joined to a body, whose place is where the beam's is, or `point`"),
    JOINT("to", to, KEY_VECTOR, .unit = "m",
          .doc = "of two bodies at a distance: the point of the second"),
    JOINT_KEYS};

static const struct hobe_lua_schema support_schema = {"support", support_keys};
static const struct hobe_lua_schema joint_schema = {"joint", joint_keys};

/* The drive of a motion, which one key gives itself and another its rate. */
static hobe_drive *keep_motion(lua_State *L, const struct hobe_lua_schema *schema, const char *key,
                               const char *rate, int anchor)
{
    hobe_drive *drive = hobe_lua_keep_drive(L, schema, key, 0, anchor);
    hobe_lua_push_key(L, 1, schema, rate);
    if (drive && !lua_isnil(L, -1))
        hobe_lua_fail(L, "%s: %s and %s exclude each other: one follows from the other",
                      schema->name, key, rate);
    lua_pop(L, 1);
    return drive ? drive : hobe_lua_keep_drive(L, schema, rate, 1, anchor);
}

static int push_joint(lua_State *L, const struct hobe_lua_schema *schema)
{
    struct joint read = {0};
    hobe_lua_read(L, 1, schema, &read);
    hobe_lua_read_places(L, schema, schema == &joint_schema, read.joint.at, &read.joint.at_point);
    read.joint.kind = (enum hobe_joint_kind)(read.kind - 1);
    struct hobe_joint *j =
        &hobe_lua_push_item(L, ITEM_JOINT, &read.joint, sizeof read.joint)->as.joint;
    j->where = hobe_lua_keep(L, WHERE);
    j->beam[0] = hobe_lua_keep_copy(L, j->beam[0], NAME);
    j->beam[1] = hobe_lua_keep_copy(L, j->beam[1], OTHER);
    j->name = hobe_lua_keep_copy(L, j->name, OWN_NAME);
    j->angle = keep_motion(L, schema, "angle", "angular_velocity", DRIVE);
    j->position = keep_motion(L, schema, "position", "velocity", DRIVE_2);
    return 1;
}

static int support(lua_State *L)
{
    lua_settop(L, 1);
    push_joint(L, &support_schema);
    const struct hobe_lua_item *item = lua_touserdata(L, 2);
    hobe_lua_push_key(L, 1, &support_schema, "to");
    if (lua_isnil(L, -1) == (item->as.joint.kind == HOBE_JOINT_DISTANCE))
        hobe_lua_fail(L,
                      "support: kind \"distance\" needs to = {x, y, z}, a point of the ground; no "
                      "other kind has it");
    lua_settop(L, 2);
    return 1;
}

static int joint(lua_State *L)
{
    return push_joint(L, &joint_schema);
}

/* ---- shared nodes ---------------------------------------------------------------------------- */

static const struct hobe_lua_key join_keys[] = {
    KEY_AS("beam", struct hobe_join, beam[0], KEY_TEXT, REQUIRED, .position = 1,
           .doc = "name of one beam"),
    KEY_AS("other", struct hobe_join, beam[1], KEY_TEXT, REQUIRED, .position = 2,
           .doc = "name of the other beam"),
    KEY(struct hobe_join, at, KEY_PAIR, REQUIRED, .doc = "the end of each that they share: 0 or 1"),
    {0}};

static const struct hobe_lua_schema join_schema = {"join", join_keys};

static int join(lua_State *L)
{
    struct hobe_join read = {0};
    hobe_lua_read(L, 1, &join_schema, &read);
    for (int i = 0; i < 2; i++)
        if (read.at[i] != 0 && read.at[i] != 1)
            hobe_lua_fail(L, "join: at[%d] must be an end of the beam, 0 or 1, got %f", i + 1,
                          read.at[i]);
    struct hobe_join *j = &hobe_lua_push_item(L, ITEM_JOIN, &read, sizeof read)->as.join;
    j->where = hobe_lua_keep(L, WHERE);
    j->beam[0] = hobe_lua_keep_copy(L, j->beam[0], NAME);
    j->beam[1] = hobe_lua_keep_copy(L, j->beam[1], OTHER);
    return 1;
}

const struct hobe_lua_entry hobe_lua_joint_entries[] = {
    {"clamp", clamp, "hobe.clamp{\"beam\", at =}", "Holds a node of a beam in place and direction.",
     &clamp_schema, NULL},
    {"support", support, "hobe.support{\"beam\", at =, kind =, axis =}",
     "Holds a place of a beam, or a point of a body, as a joint to the ground would.",
     &support_schema, NULL},
    {"joint", joint, "hobe.joint{\"a\", \"b\", at = {1, 0}, kind =, axis =}",
     "A joint between places of two beams or bodies, which must coincide but for a distance.  "
     "Directions that move with a beam are carried by its section's slopes y and z and by their "
     "normal.",
     &joint_schema, NULL},
    {"join", join, "hobe.join{\"a\", \"b\", at = {1, 0}}",
     "Makes ends of two beams one node, rigidly, at any angle; the ends must coincide.",
     &join_schema, NULL},
    {0}};
