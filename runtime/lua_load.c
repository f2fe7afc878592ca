/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forces, moments, gravity and spin; and the velocities with which a motion starts. */
#include "lua_item.h"

/* A factor in time of a load. */
#define HISTORY_KEY                                                                                \
    KEY_OF_TIME("history", NULL,                                                                   \
                "a factor that changes in time; equilibria take it at the `time` of "              \
                "`hobe.static`, 0 where left out")

#define PART_NAME(owner)                                                                           \
    KEY(owner, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam or body")
#define PART_PLACE(owner)                                                                          \
    KEY(owner, at, KEY_NUMBER, KEY_WITHIN(0, 1),                                                   \
        .doc =                                                                                     \
            "place on the beam, as a fraction of its length; not to be left out, but of a body")

static const struct hobe_lua_key force_keys[] = {
    PART_NAME(struct hobe_force),
    PART_PLACE(struct hobe_force),
    KEY(struct hobe_force, point, KEY_VECTOR, .unit = "m",
        .doc = "place on a body, {x, y, z}, global, in the reference"),
    KEY_OF_OTHER("value", "vector or function", REQUIRED, .unit = "N",
                 .doc = "the force {x, y, z}, global axes; or `function(t, x, v) return {x, y, z} "
                        "end`, smooth, of the time, the position of its place, {x, y, z}, m, and "
                        "its velocity, m/s, which is 0 in statics"),
    KEY_OF_OTHER("derivative", "function", .unit = "N/m, N s/m",
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
    hobe_lua_check_place(L, &force_schema);
    read.at_point = hobe_lua_is_given(L, &force_schema, "point");
    struct hobe_force *f = &hobe_lua_push_item(L, ITEM_FORCE, &read, sizeof read)->as.force;
    f->where = hobe_lua_keep(L, WHERE);
    f->beam = hobe_lua_keep_copy(L, f->beam, NAME);
    f->history = hobe_lua_keep_drive(L, &force_schema, "history", 0, DRIVE);
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
    m->history = hobe_lua_keep_drive(L, &moment_schema, "history", 0, DRIVE);
    return 1;
}

static int gravity(lua_State *L)
{
    struct hobe_lua_gravity read = {0};
    hobe_lua_read(L, 1, &gravity_schema, &read);
    struct hobe_lua_gravity *g =
        &hobe_lua_push_item(L, ITEM_GRAVITY, &read, sizeof read)->as.gravity;
    g->where = hobe_lua_keep(L, WHERE);
    g->history = hobe_lua_keep_drive(L, &gravity_schema, "history", 0, DRIVE);
    return 1;
}

static int spin(lua_State *L)
{
    struct hobe_spin read = {0};
    hobe_lua_read(L, 1, &spin_schema, &read);
    struct hobe_spin *s = &hobe_lua_push_item(L, ITEM_SPIN, &read, sizeof read)->as.spin;
    s->where = hobe_lua_keep(L, WHERE);
    s->history = hobe_lua_keep_drive(L, &spin_schema, "history", 0, DRIVE);
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
    KEY(struct hobe_motion, about, KEY_VECTOR, .unit = "m",
        .doc = "a point, {x, y, z}; {0, 0, 0} where left out"),
    {0}};

static const struct hobe_lua_schema motion_schema = {"motion", motion_keys};

static int motion(lua_State *L)
{
    struct hobe_motion read = {0};
    hobe_lua_read(L, 1, &motion_schema, &read);
    struct hobe_motion *m = &hobe_lua_push_item(L, ITEM_MOTION, &read, sizeof read)->as.motion;
    m->where = hobe_lua_keep(L, WHERE);
    m->beam = hobe_lua_keep_copy(L, m->beam, NAME);
    return 1;
}

const struct hobe_lua_entry hobe_lua_load_entries[] = {
    {"force", force, "hobe.force{\"beam\", at =, value = {x, y, z}}",
     "A force on the axis of a beam or on a body, dead or following the section or the body.",
     &force_schema, NULL},
    {"moment", moment, "hobe.moment{\"beam\", at =, value = {x, y, z}}",
     "A moment, conservative.  Resolved on the beam's axes in the reference, (m_x, m_y, m_z), its "
     "potential is -m_x (a + b)/2 - m_y c - m_z d: a and b the angles of the section's slopes y "
     "and z about x, c that of slope z about y, d that of slope y about z; of a body its global "
     "axes "
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
