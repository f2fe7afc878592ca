/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Springs and dampers. */
#include "lua_item.h"

struct spring {
    struct hobe_spring spring;
    int kind;
};

#define SPRING(name, field, kind, ...) KEY_AS(name, struct spring, spring.field, kind, __VA_ARGS__)

static const struct hobe_lua_key spring_keys[] = {
    SPRING("beam", beam[0], KEY_TEXT, REQUIRED, .position = 1,
           .doc = "name of the first beam or body"),
    SPRING("other", beam[1], KEY_TEXT, .position = 2,
           .doc = "name of the second; the ground where left out"),
    KEY_OF_OTHER("at", "number or {a, b}",
                 .doc = "the place on the beam, as a fraction of its length; the places {a, b} on "
                        "two, or one number for both"),
    SPRING("point", point, KEY_VECTOR, .unit = "m",
           .doc = "the place on a body, global, in the reference"),
    KEY(struct spring, kind, KEY_CHOICE, .choices = "length|torsion|bushing", .word = "length",
        .doc = "what it acts on.  length: the distance of its places; torsion: the angle by which "
               "the second beam has turned against the first, or the beam against the ground, "
               "about the axis, from -pi to pi; bushing: the displacement of the second place "
               "against the first along the global axes, which move with the first beam, or stay"),
    KEY_OF_OTHER("stiffness", "number or three numbers", .unit = "N/m or N m/rad",
                 .doc = "k of the force k (l - length) or moment k (a - angle); of a bushing one "
                        "for all axes, or three {x, y, z}; 0 where left out"),
    KEY_OF_OTHER("damping", "number or three numbers", .unit = "N s/m or N m s/rad",
                 .doc = "of the force or moment by the rate, in hobe.dynamic; likewise"),
    SPRING("length", length, KEY_NUMBER, KEY_ABOVE(0), .unit = "m",
           .doc = "where a length has no force; the distance in the reference where left out"),
    SPRING("angle", angle, KEY_NUMBER, .unit = "rad",
           .doc = "where torsion has no moment, from the reference"),
    SPRING("axis", axis, KEY_VECTOR,
           .doc = "of torsion, in the reference, global; it moves with the first beam, or stays"),
    SPRING(
        "to", to, KEY_VECTOR, .unit = "m",
        .doc =
            "of a length to the ground: its place there; of two bodies: the place on the second"),
    KEY_AS("name", struct spring, spring.name, KEY_TEXT, .doc = "its own name, for `r:spring`"),
    {0}};

static const struct hobe_lua_schema spring_schema = {"spring", spring_keys};

/* The value of a key, as one number or as many as the type says. */
static void read_spring_key(lua_State *L, const char *name, enum hobe_lua_type type, double *out)
{
    const char *what = lua_pushfstring(L, "spring: %s", name);
    hobe_lua_push_key(L, 1, &spring_schema, name);
    hobe_lua_read_value(L, -1, what, &(struct hobe_lua_key){.type = type}, out);
    lua_pop(L, 2);
}

/* One number, of a bushing for all axes; or, where it has them, three. */
static void read_rates(lua_State *L, const char *name, int bushing, double value[3])
{
    hobe_lua_push_key(L, 1, &spring_schema, name);
    const int many = bushing && lua_istable(L, -1);
    lua_pop(L, 1);
    read_spring_key(L, name, many ? KEY_VECTOR : KEY_NUMBER, value);
    if (bushing && !many)
        value[1] = value[2] = value[0];
}

static int spring(lua_State *L)
{
    struct spring read = {0};
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &spring_schema, &read);
    struct hobe_spring *s = &read.spring;
    s->kind = (enum hobe_spring_kind)(read.kind > 0 ? read.kind - 1 : 0);
    hobe_lua_read_places(L, &spring_schema, s->beam[1] != NULL, s->at, &s->at_point);
    read_rates(L, "stiffness", s->kind == HOBE_SPRING_BUSHING, s->stiffness);
    read_rates(L, "damping", s->kind == HOBE_SPRING_BUSHING, s->damping);
    hobe_lua_push_key(L, 1, &spring_schema, "to");
    if (s->at_point < 2 && lua_isnil(L, -1) == (s->kind == HOBE_SPRING_LENGTH && !s->beam[1]))
        hobe_lua_fail(L,
                      "spring: kind \"length\" from one beam to the ground needs to = {x, y, z}, "
                      "a point of the ground; no other has it");
    lua_settop(L, 1);
    s = &hobe_lua_push_item(L, ITEM_SPRING, s, sizeof *s)->as.spring;
    s->where = hobe_lua_keep(L, WHERE);
    s->beam[0] = hobe_lua_keep_copy(L, s->beam[0], NAME);
    s->beam[1] = hobe_lua_keep_copy(L, s->beam[1], OTHER);
    s->name = hobe_lua_keep_copy(L, s->name, OWN_NAME);
    return 1;
}

const struct hobe_lua_entry hobe_lua_spring_entries[] = {
    {"spring", spring,
     "hobe.spring{\"a\", \"b\", at = {1, 0}, stiffness =, damping =} or "
     "hobe.spring{\"a\", at =, to = {x, y, z}, stiffness =, damping =}",
     "A spring and damper without mass between places of two beams or bodies, or of one and the "
     "ground.  It "
     "holds a scene as a support does, along what it acts on.",
     &spring_schema, NULL},
    {0}};
