/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams, supports and loads: each constructor checks its table and returns an item that knows the
 * line it was written in. */
#include "lua_item.h"

#include <string.h>

struct hobe_lua_item *hobe_lua_push_item(lua_State *L, enum hobe_lua_kind kind, const void *value,
                                         size_t size)
{
    struct hobe_lua_item *item = lua_newuserdatauv(L, sizeof *item, ANCHORS);
    memset(item, 0, sizeof *item);
    item->kind = kind;
    memcpy(&item->as, value, size);
    if (luaL_newmetatable(L, HOBE_LUA_ITEM)) {
        lua_pushliteral(L, "part of a scene"); /* what sentences call it */
        lua_setfield(L, -2, "__name");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
    }
    lua_setmetatable(L, -2);
    hobe_lua_where(L);
    return item;
}

const char *hobe_lua_keep(lua_State *L, int anchor)
{
    const char *s = lua_tostring(L, -1);
    lua_setiuservalue(L, -2, anchor);
    return s;
}

const char *hobe_lua_keep_copy(lua_State *L, const char *s, int anchor)
{
    lua_pushstring(L, s);
    return hobe_lua_keep(L, anchor);
}

int hobe_lua_is_given(lua_State *L, const struct hobe_lua_schema *schema, const char *key)
{
    hobe_lua_push_key(L, 1, schema, key);
    const int is = !lua_isnil(L, -1);
    lua_pop(L, 1);
    return is;
}

#define BEAM_NAME(owner)                                                                           \
    KEY(owner, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam")
#define PLACE(owner)                                                                               \
    KEY(owner, at, KEY_NUMBER, REQUIRED, KEY_WITHIN(0, 1),                                         \
        .doc = "place on the beam, as a fraction of its length")

/* A key that holds a function of time (hobe_lua_push_drive). */
#define TIME_KEY(key_name, measure, text)                                                          \
    KEY_OF_OTHER(key_name, "function of time", .unit = measure, .doc = text)

#define HISTORY_KEY                                                                                \
    TIME_KEY("history", NULL,                                                                      \
             "a factor that changes in time; equilibria take it at the `time` of `hobe.static`, "  \
             "0 where left out")

/* The drive that `key` of the table at index 1 gives, or NULL; kept by the item on top. */
static hobe_drive *keep_drive(lua_State *L, const struct hobe_lua_schema *schema, const char *key,
                              int integral, int anchor)
{
    const int item = lua_gettop(L);
    hobe_drive *drive = NULL;
    hobe_lua_push_key(L, 1, schema, key);
    if (!lua_isnil(L, -1)) {
        const char *what = lua_pushfstring(L, "%s: %s", schema->name, key);
        drive = hobe_lua_push_drive(L, item + 1, what, integral);
        lua_setiuservalue(L, item, anchor);
    }
    lua_settop(L, item);
    return drive;
}

/* The drive of a motion, which one key gives itself and another its rate. */
static hobe_drive *keep_motion(lua_State *L, const struct hobe_lua_schema *schema, const char *key,
                               const char *rate, int anchor)
{
    hobe_drive *drive = keep_drive(L, schema, key, 0, anchor);
    hobe_lua_push_key(L, 1, schema, rate);
    if (drive && !lua_isnil(L, -1))
        hobe_lua_fail(L, "%s: %s and %s exclude each other: one follows from the other",
                      schema->name, key, rate);
    lua_pop(L, 1);
    return drive ? drive : keep_drive(L, schema, rate, 1, anchor);
}

/* ---- beams ---------------------------------------------------------------------------------- */

#define MATERIAL(name, ...) KEY(struct hobe_material, name, KEY_NUMBER, __VA_ARGS__)

static const struct hobe_lua_key material_keys[] = {
    MATERIAL(E, REQUIRED, KEY_ABOVE(0), .unit = "Pa", .doc = "Young's modulus"),
    MATERIAL(nu, REQUIRED, KEY_BETWEEN(-1, 0.5), .doc = "Poisson's ratio"),
    MATERIAL(rho, KEY_FROM(0), .unit = "kg/m^3", .doc = "density; needed where mass matters"),
    MATERIAL(k2, KEY_ABOVE(0), .fallback = 1, .doc = "shear correction on xz"),
    MATERIAL(k3, KEY_ABOVE(0), .fallback = 1, .doc = "shear correction on xy"),
    KEY_AS("k", struct hobe_material, average_shear, KEY_CHOICE, .choices = "point|average",
           .word = "point",
           .doc = "where k2 and k3 act: on the strain at every point, which makes torsion softer, "
                  "too, or on the shear strain averaged over the section, which leaves it alone"),
    {0}};

const struct hobe_lua_schema hobe_lua_material_schema = {"material", material_keys};

void hobe_lua_finish_material(struct hobe_material *material)
{
    material->average_shear = material->average_shear == 2;
}

void hobe_lua_choose_material(lua_State *L, const struct hobe_lua_schema *schema,
                              const hobe_section *section, struct hobe_material *material)
{
    const int own = hobe_section_material(section, 0) != NULL;
    hobe_lua_push_key(L, 1, schema, "material");
    if (lua_isnil(L, -1) != own)
        hobe_lua_fail(L,
                      own ? "%s: a composite section brings its materials; leave material out"
                          : "%s: material is missing: a table {E =, nu =, rho =}",
                      schema->name);
    lua_pop(L, 1);
    hobe_lua_finish_material(material);
}

struct beam {
    struct hobe_beam beam;
    const char *element;
    int mechanics, integration;
};

static const struct hobe_lua_key damping_keys[] = {
    KEY(struct hobe_damping, mass, KEY_NUMBER, KEY_FROM(0), .unit = "1/s",
        .doc = "forces of so many times the momentum; they hold back rigid motions, too"),
    KEY(struct hobe_damping, stiffness, KEY_NUMBER, KEY_FROM(0), .unit = "s",
        .doc = "viscous stress C : dE/dt of so many times the rate of strain, beside the elastic "
               "one (Kelvin, Voigt): no rigid motion feels it; not for 3333s.  A mode of angular "
               "frequency omega has (mass/omega + stiffness omega)/2 of the critical damping"),
    {0}};

static const struct hobe_lua_schema damping_schema = {"damping", damping_keys};

#define BEAM(name, kind, ...) KEY_AS(#name, struct beam, beam.name, kind, __VA_ARGS__)

static const struct hobe_lua_key beam_keys[] = {
    BEAM(name, KEY_TEXT, REQUIRED, .doc = "its name in the scene, for loads and results"),
    KEY(struct beam, element, KEY_TEXT, .word = "MGD30w",
        .doc = "name of the element; see `hobe.elements()`"),
    BEAM(elements, KEY_WHOLE, REQUIRED, KEY_WITHIN(1, 1e6), .doc = "number of elements"),
    BEAM(section, KEY_SECTION, REQUIRED, .doc = "a section, such as hobe.rectangle{...}"),
    BEAM(material, KEY_GROUP, .group = &hobe_lua_material_schema,
         .doc = "a table {E =, nu =, rho =, k2 =, k3 =, k =}; a composite section brings its own"),
    BEAM(from, KEY_VECTOR, .unit = "m", .doc = "begin of a straight axis, {x, y, z}"),
    BEAM(to, KEY_VECTOR, .unit = "m", .doc = "its end"),
    KEY_OF_OTHER(
        "curve", "function or list", .unit = "m",
        .doc = "a curved axis, in place of from and to: a function that gives the point {x, y, z} "
               "of a smooth curve at t from 0 to 1, at any speed; or a list of points for a "
               "spline"),
    KEY_OF_OTHER(
        "twist", "number or function", .unit = "rad",
        .doc = "turn of the section about the axis, y to z: the angle at the end, to which it "
               "grows evenly, or a function that gives it at a fraction of the length"),
    BEAM(up, KEY_VECTOR,
         .doc = "where the section's z axis points to, made normal to the beam; global Z where "
                "left out, or global -X for a beam along Z"),
    KEY(struct beam, mechanics, KEY_CHOICE, .choices = "average|axis|full|structural",
        .doc =
            "where Poisson's coupling acts: on the strain averaged over the section, on the "
            "axis (the paper), everywhere (full); nowhere in the law of a rod, structural, which "
            "3333s has and no other.  average also averages what warping in large torsion strains "
            "the section in its plane.  The element's own choice where left out"),
    KEY(struct beam, integration, KEY_CHOICE, .choices = "exact|paper", .word = "exact",
        .doc = "exact, or 3 x 3 x 3 Gauss points and one term of the warping "
               "series as in the paper; not for 3333s"),
    BEAM(damping, KEY_GROUP, .group = &damping_schema,
         .doc = "what it loses in motion, a table {mass =, stiffness =}"),
    {0}};

static const struct hobe_lua_schema beam_schema = {"beam", beam_keys};

const struct hobe_kernel *hobe_lua_find_kernel(lua_State *L, const char *name)
{
    struct hobe_error err;
    const struct hobe_kernel *kernel = hobe_find_kernel(name, &err);
    if (!kernel)
        hobe_lua_raise(L, &err);
    return kernel;
}

/* Whether the beam's table holds the key; pushes its value. */
static int push_given(lua_State *L, const char *key)
{
    hobe_lua_push_key(L, 1, &beam_schema, key);
    return !lua_isnil(L, -1);
}

/* Pushes the curve that is the beam's axis; nil where the axis is straight and not twisted. */
static void push_axis(lua_State *L, struct hobe_beam *beam)
{
    static const char *const ends[] = {"from", "to"};
    const int curved = push_given(L, "curve"), curve = lua_gettop(L);
    for (int i = 0; i < 2; i++)
        if (push_given(L, ends[i]) == curved)
            hobe_lua_fail(L,
                          curved ? "beam: %s and curve exclude each other: the curve is the axis"
                                 : "beam: %s is missing: an end of the axis {x, y, z}, or a curve",
                          ends[i]);
    push_given(L, "twist");
    beam->curve = hobe_lua_push_curve(L, curve, lua_gettop(L), beam);
    lua_replace(L, curve);
    lua_settop(L, curve);
}

static int beam(lua_State *L)
{
    struct beam read = {0};
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &beam_schema, &read);
    read.beam.kernel = hobe_lua_find_kernel(L, read.element);
    hobe_lua_choose_material(L, &beam_schema, read.beam.section, &read.beam.material);
    read.beam.mechanics = (enum hobe_mechanics)read.mechanics;
    read.beam.integration = read.integration == 2 ? HOBE_INTEGRATION_PAPER : HOBE_INTEGRATION_EXACT;
    push_axis(L, &read.beam);
    struct hobe_beam *b = &hobe_lua_push_item(L, ITEM_BEAM, &read.beam, sizeof read.beam)->as.beam;
    b->where = hobe_lua_keep(L, WHERE);
    b->name = hobe_lua_keep_copy(L, b->name, NAME);
    hobe_lua_push_key(L, 1, &beam_schema, "section");
    lua_setiuservalue(L, -2, OTHER);
    lua_pushvalue(L, 2);
    lua_setiuservalue(L, -2, CURVE);
    return 1;
}

/* ---- masses --------------------------------------------------------------------------------- */

static const struct hobe_lua_key mass_keys[] = {
    BEAM_NAME(struct hobe_mass),
    PLACE(struct hobe_mass),
    KEY(struct hobe_mass, mass, KEY_NUMBER, REQUIRED, KEY_FROM(0), .unit = "kg", .doc = "the mass"),
    KEY(struct hobe_mass, y, KEY_NUMBER, .unit = "m", .doc = "where it sits in the section, and"),
    KEY(struct hobe_mass, z, KEY_NUMBER, .unit = "m", .doc = "likewise, from the centroid"),
    {0}};

static const struct hobe_lua_schema mass_schema = {"mass", mass_keys};

static int mass(lua_State *L)
{
    struct hobe_mass read = {0};
    hobe_lua_read(L, 1, &mass_schema, &read);
    struct hobe_mass *m = &hobe_lua_push_item(L, ITEM_MASS, &read, sizeof read)->as.mass;
    m->where = hobe_lua_keep(L, WHERE);
    m->beam = hobe_lua_keep_copy(L, m->beam, NAME);
    return 1;
}

/* ---- supports ------------------------------------------------------------------------------- */

#define OWN_NAME_KEY(key_owner, field)                                                             \
    KEY_AS("name", key_owner, field, KEY_TEXT, .doc = "its own name, for `r:reaction`")

/* Keeps the name that a support or joint may have, with the item on top of the stack. */
static const char *keep_own_name(lua_State *L, const char *name)
{
    return name ? hobe_lua_keep_copy(L, name, OWN_NAME) : NULL;
}

static const struct hobe_lua_key clamp_keys[] = {
    BEAM_NAME(struct hobe_clamp),
    PLACE(struct hobe_clamp),
    KEY_AS("warping", struct hobe_clamp, free_warping, KEY_CHOICE, .choices = "fixed|free",
           .word = "fixed",
           .doc = "fixed holds every vector of the node; free only its position and the section's "
                  "slopes y and z, so that the section may warp and the axis stretch there"),
    OWN_NAME_KEY(struct hobe_clamp, name),
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
    c->name = keep_own_name(L, c->name);
    return 1;
}

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
        TIME_KEY("angle", "rad",                                                                   \
                 "turns the second beam about the axis: what is left free of that motion is free " \
                 "no more.  For kinds whose axis cannot tilt: fixed, revolute, cylindrical, "      \
                 "prismatic, planar"),                                                             \
        TIME_KEY("angular_velocity", "rad/s", "the same by its rate, from the angle 0 at t = 0"),  \
        TIME_KEY("position", "m",                                                                  \
                 "shifts the second beam along the axis likewise, or lengthens a distance"),       \
        TIME_KEY("velocity", "m/s", "the same by its rate, from 0 at t = 0"),                      \
        OWN_NAME_KEY(struct joint, joint.name),                                                    \
    {                                                                                              \
        0                                                                                          \
    }

static const struct hobe_lua_key support_keys[] = {
    JOINT("beam", beam[0], KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam or body"),
    JOINT("at", at[0], KEY_NUMBER, KEY_WITHIN(0, 1),
          .doc = "place on the beam, as a fraction of its length; a body has a point instead"),
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

/* A place is needed: `at` of a beam or the point of a body. */
static void check_place(lua_State *L, const struct hobe_lua_schema *schema)
{
    if (!hobe_lua_is_given(L, schema, "at") && !hobe_lua_is_given(L, schema, "point"))
        hobe_lua_fail(L,
                      "%s: at is missing: the place on a beam, as a fraction of its length; or "
                      "point, {x, y, z}, of a body",
                      schema->name);
}

/* The places of a joint or spring: `at` as one number or, of two parts, two; and whether a point is
 * given, or two. */
static void read_places(lua_State *L, const struct hobe_lua_schema *schema, int two, double at[2],
                        int *at_point)
{
    struct hobe_lua_key key = {.type = KEY_NUMBER, KEY_WITHIN(0, 1)};
    check_place(L, schema);
    const char *what = lua_pushfstring(L, "%s: at", schema->name);
    hobe_lua_push_key(L, 1, schema, "at");
    const int number = lua_type(L, -1) == LUA_TNUMBER;
    if (two && !number)
        key = (struct hobe_lua_key){.type = KEY_PAIR};
    hobe_lua_read_value(L, -1, what, &key, at);
    if (two && number)
        at[1] = at[0];
    lua_pop(L, 2);
    *at_point = hobe_lua_is_given(L, schema, "point");
    if (*at_point && two && hobe_lua_is_given(L, schema, "to"))
        *at_point = 2;
}

static int push_joint(lua_State *L, const struct hobe_lua_schema *schema)
{
    struct joint read = {0};
    hobe_lua_read(L, 1, schema, &read);
    read_places(L, schema, schema == &joint_schema, read.joint.at, &read.joint.at_point);
    read.joint.kind = (enum hobe_joint_kind)(read.kind - 1);
    struct hobe_joint *j =
        &hobe_lua_push_item(L, ITEM_JOINT, &read.joint, sizeof read.joint)->as.joint;
    j->where = hobe_lua_keep(L, WHERE);
    j->beam[0] = hobe_lua_keep_copy(L, j->beam[0], NAME);
    if (j->beam[1])
        j->beam[1] = hobe_lua_keep_copy(L, j->beam[1], OTHER);
    j->name = keep_own_name(L, j->name);
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

/* ---- springs --------------------------------------------------------------------------------- */

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
    read_places(L, &spring_schema, s->beam[1] != NULL, s->at, &s->at_point);
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
    if (s->beam[1])
        s->beam[1] = hobe_lua_keep_copy(L, s->beam[1], OTHER);
    s->name = keep_own_name(L, s->name);
    return 1;
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

/* ---- loads ---------------------------------------------------------------------------------- */

#define PART_NAME(owner)                                                                           \
    KEY(owner, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam or body")
#define PART_PLACE(owner)                                                                          \
    KEY(owner, at, KEY_NUMBER, KEY_WITHIN(0, 1),                                                   \
        .doc = "place on the beam, as a fraction of its length")

static const struct hobe_lua_key force_keys[] = {
    PART_NAME(struct hobe_force),
    PART_PLACE(struct hobe_force),
    KEY(struct hobe_force, point, KEY_VECTOR, .unit = "m",
        .doc = "place on a body, {x, y, z}, global, in the reference"),
    KEY_OF_OTHER("value", "vector or function", REQUIRED, .unit = "N",
                 .doc = "the force {x, y, z}, global axes; or `function(t, x, v) return {x, y, z} "
                        "end`, smooth, of the time, the position of its place, {x, y, z}, m, and "
                        "its velocity, m/s, which is 0 in statics"),
    KEY_OF_OTHER("derivative", "function", .unit = "N/m",
                 .doc = "of such a function: `function(t, x, v) return dF_dx, dF_dv end`, lists of "
                        "three rows, the second where it is not 0; differences where left out"),
    KEY(struct hobe_force, follower, KEY_FLAG,
        .doc = "whether the force turns with the section or body (false: it keeps its direction)"),
    HISTORY_KEY,
    {0}};

static const struct hobe_lua_key moment_keys[] = {
    PART_NAME(struct hobe_moment),
    PART_PLACE(struct hobe_moment),
    KEY(struct hobe_moment, value, KEY_VECTOR, REQUIRED, .unit = "N m",
        .doc = "the moment {x, y, z} about the global axes"),
    HISTORY_KEY,
    {0}};

static const struct hobe_lua_key gravity_keys[] = {
    KEY(struct hobe_lua_gravity, value, KEY_VECTOR, REQUIRED, .position = 1, .unit = "m/s^2",
        .doc = "the acceleration {x, y, z}, global axes"),
    HISTORY_KEY,
    {0}};

static const struct hobe_lua_key spin_keys[] = {
    KEY(struct hobe_spin, axis, KEY_VECTOR, REQUIRED,
        .doc = "direction {x, y, z} of the line about which the scene turns, global axes"),
    KEY(struct hobe_spin, about, KEY_VECTOR, .unit = "m",
        .doc = "a point of that line, {0, 0, 0} where left out"),
    KEY(struct hobe_spin, speed, KEY_NUMBER, REQUIRED, .unit = "rad/s",
        .doc = "angular velocity, by the right-hand rule about the axis"),
    HISTORY_KEY,
    {0}};

static const struct hobe_lua_schema force_schema = {"force", force_keys};
static const struct hobe_lua_schema moment_schema = {"moment", moment_keys};
static const struct hobe_lua_schema gravity_schema = {"gravity", gravity_keys};
static const struct hobe_lua_schema spin_schema = {"spin", spin_keys};

static const struct hobe_lua_key force_value = {
    .type = KEY_VECTOR, REQUIRED, .doc = "the force {x, y, z}"};

/* Pushes a key of the force at index 1; whether it is a function. */
static int push_function(lua_State *L, const char *key)
{
    hobe_lua_push_key(L, 1, &force_schema, key);
    return lua_isfunction(L, -1);
}

/* The value of the force on top of the stack: a vector, or functions that it keeps. */
static void read_force(lua_State *L, struct hobe_force *force)
{
    const int item = lua_gettop(L), derived = push_function(L, "derivative");
    if (!derived && !lua_isnil(L, -1))
        hobe_lua_fail(L, "force: derivative must be a function, got %s", hobe_lua_describe(L, -1));
    const int called = push_function(L, "value");
    if (derived && !called)
        hobe_lua_fail(L, "force: only a value that is a function has a derivative");
    if (!called)
        hobe_lua_read_value(L, -1, "force: value", &force_value, force->value);
    else {
        struct hobe_lua_scripts *scripts = lua_newuserdatauv(L, sizeof *scripts, 2);
        const int kept = lua_gettop(L);
        scripts->value = hobe_lua_push_script(L, item + 2, "force: value");
        lua_setiuservalue(L, kept, 1);
        scripts->derivative =
            derived ? hobe_lua_push_script(L, item + 1, "force: derivative") : NULL;
        if (derived)
            lua_setiuservalue(L, kept, 2);
        lua_setiuservalue(L, item, DRIVE_2);
        force->function = hobe_lua_force;
        force->derivative = derived ? hobe_lua_force_derivative : NULL;
        force->context = scripts;
    }
    lua_settop(L, item);
}

static int force(lua_State *L)
{
    struct hobe_force read = {0};
    hobe_lua_read(L, 1, &force_schema, &read);
    check_place(L, &force_schema);
    read.at_point = hobe_lua_is_given(L, &force_schema, "point");
    struct hobe_force *f = &hobe_lua_push_item(L, ITEM_FORCE, &read, sizeof read)->as.force;
    f->where = hobe_lua_keep(L, WHERE);
    f->beam = hobe_lua_keep_copy(L, f->beam, NAME);
    f->history = keep_drive(L, &force_schema, "history", 0, DRIVE);
    read_force(L, f);
    return 1;
}

static int moment(lua_State *L)
{
    struct hobe_moment read = {0};
    hobe_lua_read(L, 1, &moment_schema, &read);
    read.at_point = !hobe_lua_is_given(L, &moment_schema, "at");
    struct hobe_moment *m = &hobe_lua_push_item(L, ITEM_MOMENT, &read, sizeof read)->as.moment;
    m->where = hobe_lua_keep(L, WHERE);
    m->beam = hobe_lua_keep_copy(L, m->beam, NAME);
    m->history = keep_drive(L, &moment_schema, "history", 0, DRIVE);
    return 1;
}

static int gravity(lua_State *L)
{
    struct hobe_lua_gravity read = {0};
    hobe_lua_read(L, 1, &gravity_schema, &read);
    struct hobe_lua_gravity *g =
        &hobe_lua_push_item(L, ITEM_GRAVITY, &read, sizeof read)->as.gravity;
    g->where = hobe_lua_keep(L, WHERE);
    g->history = keep_drive(L, &gravity_schema, "history", 0, DRIVE);
    return 1;
}

static int spin(lua_State *L)
{
    struct hobe_spin read = {0};
    hobe_lua_read(L, 1, &spin_schema, &read);
    struct hobe_spin *s = &hobe_lua_push_item(L, ITEM_SPIN, &read, sizeof read)->as.spin;
    s->where = hobe_lua_keep(L, WHERE);
    s->history = keep_drive(L, &spin_schema, "history", 0, DRIVE);
    return 1;
}

/* ---- the start of a motion ------------------------------------------------------------------ */

static const struct hobe_lua_key motion_keys[] = {
    KEY(struct hobe_motion, beam, KEY_TEXT, .position = 1,
        .doc = "name of the beam or body; everything where left out"),
    KEY(struct hobe_motion, velocity, KEY_VECTOR, .unit = "m/s",
        .doc = "of the point `about`, {x, y, z}"),
    KEY(struct hobe_motion, angular_velocity, KEY_VECTOR, .unit = "rad/s",
        .doc = "about that point, {x, y, z}"),
    KEY(struct hobe_motion, about, KEY_VECTOR, .unit = "m", .doc = "a point, {x, y, z}"),
    {0}};

static const struct hobe_lua_schema motion_schema = {"motion", motion_keys};

static int motion(lua_State *L)
{
    struct hobe_motion read = {0};
    hobe_lua_read(L, 1, &motion_schema, &read);
    struct hobe_motion *m = &hobe_lua_push_item(L, ITEM_MOTION, &read, sizeof read)->as.motion;
    m->where = hobe_lua_keep(L, WHERE);
    m->beam = m->beam ? hobe_lua_keep_copy(L, m->beam, NAME) : NULL;
    return 1;
}

const struct hobe_lua_entry hobe_lua_item_entries[] = {
    {"beam", beam,
     "hobe.beam{name =, element =, elements =, section =, material =, from =, to =, twist =} or "
     "hobe.beam{..., curve =, twist =}",
     "A beam of elements of equal length on a straight or curved axis, on which its section can "
     "turn.",
     &beam_schema, NULL},
    {"body", hobe_lua_body,
     "hobe.body{name =, mass =, centre =, inertia =, axis =, second =} or hobe.body{name =, shape "
     "=, "
     "..., density =, centre =}",
     "A rigid body, in natural coordinates: its centre of mass and three directions.  Joints, "
     "supports, forces and moments name it as they name a beam.",
     &hobe_lua_body_schema, NULL},
    {"mass", mass, "hobe.mass{\"beam\", at =, mass =}",
     "A mass at a point of a beam, which every mode of the section moves.", &mass_schema, NULL},
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
    {"spring", spring,
     "hobe.spring{\"a\", \"b\", at = {1, 0}, stiffness =, damping =} or "
     "hobe.spring{\"a\", at =, to = {x, y, z}, stiffness =, damping =}",
     "A spring and damper without mass between places of two beams or bodies, or of one and the "
     "ground.  It "
     "holds a scene as a support does, along what it acts on.",
     &spring_schema, NULL},
    {"join", join, "hobe.join{\"a\", \"b\", at = {1, 0}}",
     "Makes ends of two beams one node, rigidly, at any angle; the ends must coincide.",
     &join_schema, NULL},
    {"force", force, "hobe.force{\"beam\", at =, value = {x, y, z}}",
     "A force on the axis of a beam or on a body, dead or following the section or the body.",
     &force_schema, NULL},
    {"moment", moment, "hobe.moment{\"beam\", at =, value = {x, y, z}}",
     "A moment, conservative.  Resolved on the beam's axes in the reference, (m_x, m_y, m_z), its "
     "potential is -m_x (a + b)/2 - m_y c - m_z d: a and b the angles of the section's slopes y "
     "and "
     "z about x, c that of slope z about y, d that of slope y about z; of a body its global axes "
     "and its directions that are Y and Z in the reference.",
     &moment_schema, NULL},
    {"gravity", gravity, "hobe.gravity{0, 0, -9.81}",
     "Gravity on every beam, body and mass of the scene; several add up.", &gravity_schema, NULL},
    {"spin", spin, "hobe.spin{axis = {0, 0, 1}, speed =}",
     "The scene as seen in a frame that turns with all its supports: its equilibrium "
     "bears the centrifugal force w^2 M P q, P the projection across the axis, which moves with "
     "what it acts on.  Forces keep their direction in the turning frame.  The load factor of "
     "statics and paths scales w^2.  Vibration about such an equilibrium and motion feel Coriolis' "
     "force, too, and motion Euler's where the speed changes by its history, from which equilibria "
     "take the speed alone; velocities are those in the turning frame.  Critical speeds of a shaft "
     "are w "
     "sqrt(factor) of `hobe.buckling`.",
     &spin_schema, NULL},
    {"motion", motion, "hobe.motion{[\"beam\",] velocity =, angular_velocity =, about =}",
     "Velocities with which `hobe.dynamic` starts: those of a rigid motion.  Of several that speak "
     "of a beam or body the last counts.",
     &motion_schema, NULL},
    {0}};
