/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Items of a scene, between their constructors and the scene (lua_scene.c). */
#ifndef HOBE_LUA_ITEM_H
#define HOBE_LUA_ITEM_H

#include "lua_hobe.h"

#define HOBE_LUA_ITEM    "hobe.item"
#define HOBE_LUA_SCENE   "hobe.scene"
#define HOBE_LUA_REDUCED "hobe.reduced"
#define HOBE_LUA_CURVE   "hobe.curve"
#define HOBE_LUA_DRIVE   "hobe.drive"
#define HOBE_LUA_RAMP    "hobe.ramp"

enum hobe_lua_kind {
    ITEM_BEAM,
    ITEM_BODY,
    ITEM_MASS,
    ITEM_CLAMP,
    ITEM_FORCE,
    ITEM_MOMENT,
    ITEM_GRAVITY,
    ITEM_SPIN,
    ITEM_JOIN,
    ITEM_JOINT,
    ITEM_MOTION,
    ITEM_SPRING
};

struct hobe_lua_gravity {
    const char *where;
    double value[3]; /* m/s^2 */
    hobe_drive *history;
};

/* A checked item as userdata.  The strings, section and curve it points to are kept in its user
 * values, its `where` ("file:line" of the constructor's call) in the first. */
struct hobe_lua_item {
    enum hobe_lua_kind kind;
    union {
        struct hobe_beam beam;
        struct hobe_body body;
        struct hobe_mass mass;
        struct hobe_clamp clamp;
        struct hobe_force force;
        struct hobe_moment moment;
        struct hobe_lua_gravity gravity;
        struct hobe_spin spin;
        struct hobe_join join;
        struct hobe_joint joint;
        struct hobe_motion motion;
        struct hobe_spring spring;
    } as;
};

/* A scene as userdata; its user value is the list of its items. */
struct hobe_lua_scene {
    hobe_model *model;
};

/* A reduced model as userdata, which verbs take for a scene.  (lua_reduce.c, so below) */
struct hobe_lua_reduced {
    struct hobe_lua_scene scene; /* its model is the reduced one */
    hobe_reduced *reduced;
    int owned;    /* and freed with it */
    int compared; /* with a coarse mesh */
};

/* The scene, or reduced model, that is the first argument of a verb; raises where it is none. */
struct hobe_lua_scene *hobe_lua_read_scene(lua_State *L, const char *verb);

/* Says with the results that the first argument was reduced, if it is, what the indicator of the
 * result is, unless NaN, and, of the first equilibrium, what a coarse mesh would be worth; state
 * NULL: of none. */
void hobe_lua_note_reduced(lua_State *L, double indicator, const hobe_solution *state);

/* The keys material = {...}, fit for struct hobe_material.  (lua_material.c, so below) */
extern const struct hobe_lua_schema hobe_lua_material_schema;

/* Makes the choice of its key k the flag average_shear.  To be called once after it was read. */
void hobe_lua_finish_material(struct hobe_material *material);

/* The same for what has a section, of the table at index 1: raises where a material is missing, or
 * given beside a section's own. */
void hobe_lua_choose_material(lua_State *L, const struct hobe_lua_schema *schema,
                              const hobe_section *section, struct hobe_material *material);

/* Pushes the axis of a beam as userdata, and returns it: along the beam's key `curve`, at the
 * absolute index `curve` of the stack, or straight from `from` to `to` where that is nil, with the
 * twist of its key `twist`.  Nil and NULL where both are nil.  Raises on bad values, and errors of
 * the script's functions as they are.  (lua_curve.c) */
const hobe_curve *hobe_lua_push_curve(lua_State *L, int curve, int twist,
                                      const struct hobe_beam *beam);

/* Pushes an item with a copy of the size bytes of `value`, and on it the place of the script that
 * makes it. */
struct hobe_lua_item *hobe_lua_push_item(lua_State *L, enum hobe_lua_kind kind, const void *value,
                                         size_t size);

/* Keeps the string on top of the stack alive with the item below it as user value `anchor`, and
 * returns it; the same for a copy of s, NULL for NULL. */
enum { WHERE = 1, NAME, OTHER, CURVE, OWN_NAME, DRIVE, DRIVE_2, ANCHORS = DRIVE_2 };
const char *hobe_lua_keep(lua_State *L, int anchor);
const char *hobe_lua_keep_copy(lua_State *L, const char *s, int anchor);

/* Whether the table at index 1 holds the key. */
int hobe_lua_is_given(lua_State *L, const struct hobe_lua_schema *schema, const char *key);

/* The drive that `key` of the table at index 1 gives, its integral where that is a velocity, NULL
 * where it is left out; kept by the item on top as user value `anchor`. */
hobe_drive *hobe_lua_keep_drive(lua_State *L, const struct hobe_lua_schema *schema, const char *key,
                                int integral, int anchor);

/* Raises unless the table at index 1 says a place: `at` of a beam or the point of a body. */
void hobe_lua_check_place(lua_State *L, const struct hobe_lua_schema *schema);

/* Reads the places of a joint or spring from the table at index 1: `at` as one number or, of two
 * parts, two; *at_point = how many points are given, 0, 1 or 2.  Raises. */
void hobe_lua_read_places(lua_State *L, const struct hobe_lua_schema *schema, int two, double at[2],
                          int *at_point);

/* Keys of several items: the name of a beam, a place on it, a name of its own that a support or
 * joint may have, a function of time (hobe_lua_keep_drive). */
#define KEY_BEAM(owner)                                                                            \
    KEY(owner, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam")
#define KEY_PLACE(owner)                                                                           \
    KEY(owner, at, KEY_NUMBER, REQUIRED, KEY_WITHIN(0, 1),                                         \
        .doc = "place on the beam, as a fraction of its length")
#define KEY_OWN_NAME(owner, field)                                                                 \
    KEY_AS("name", owner, field, KEY_TEXT, .doc = "its own name, for `r:reaction`")
#define KEY_OF_TIME(key_name, measure, text)                                                       \
    KEY_OF_OTHER(key_name, "function of time", .unit = measure, .doc = text)

/* Reads a point {x, y, z} of a body, an argument of a method; 0 where it is nil.  (lua_body.c) */
int hobe_lua_read_body_point(lua_State *L, int index, const char *method, double point[3]);

/* Pushes the scene of the list of items at the absolute index, its beams as a model has them, NULL:
 * as they are.  (lua_scene.c) */
struct hobe_lua_scene *hobe_lua_make_scene(lua_State *L, int items,
                                           const struct advise_model *model);

/* The same with the cheapest model that holds the accuracy in the quantities that the function at
 * an absolute index gives of a scene, nil: of how its beams move; says which.  (lua_advise.c) */
void hobe_lua_advise(lua_State *L, int items, int function, double accuracy);

/* Pushes the result that is the state i of the motion at the absolute index, i = 0 the start, and
 * returns what it holds, alive as long as the motion (lua_dynamic.c). */
const hobe_solution *hobe_lua_push_state(lua_State *L, int motion, int i);

/* The key `projection` of the table at index 2, which has been read into *projection by that
 * schema: what the solver is to be given, NULL where it is left out; results to train with stay on
 * the stack.  (lua_projection.c) */
extern const struct hobe_lua_schema hobe_lua_projection_schema;
const struct hobe_projection *hobe_lua_finish_projection(lua_State *L,
                                                         const struct hobe_lua_schema *schema,
                                                         struct hobe_projection *projection);

/* Raises where the command line wants a linear model of a verb that has none. */
void hobe_lua_check_linear(lua_State *L, const char *verb);

/* The scene and the table of options of a verb, the schema's name: its first two arguments. */
struct hobe_lua_scene *hobe_lua_read_verb(lua_State *L, const struct hobe_lua_schema *schema,
                                          void *options, size_t size);

/* Pushes a drive as userdata, and returns it: of the value at the absolute `index`, called `what`
 * in sentences; the integral of it where it is a velocity.  Raises on values that are none.
 * (lua_drive.c, so below) */
hobe_drive *hobe_lua_push_drive(lua_State *L, int index, const char *what, int integral);

/* A function of the script that the core may call at any time, on a thread of its own. */
typedef struct script hobe_lua_script;

/* Pushes that of the function at the absolute index as userdata, which must outlive its calls. */
hobe_lua_script *hobe_lua_push_script(lua_State *L, int function, const char *what);

/* A hobe_force_function and its derivative; their context is a struct hobe_lua_scripts. */
struct hobe_lua_scripts {
    hobe_lua_script *value, *derivative;
};
enum hobe_status hobe_lua_force(void *context, double t, const double x[3], const double v[3],
                                double F[3], struct hobe_error *err);
enum hobe_status hobe_lua_force_derivative(void *context, double t, const double x[3],
                                           const double v[3], double G[2][3][3],
                                           struct hobe_error *err);

/* The kernel called name; raises where there is none.  (lua_kernel.c) */
const struct hobe_kernel *hobe_lua_find_kernel(lua_State *L, const char *name);

#endif
