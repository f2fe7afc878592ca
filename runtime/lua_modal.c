/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies, critical loads and their shapes as Lua sees them. */
#include "lua_item.h"

#include <math.h>

#include <string.h>

struct modes {         /* its user value is the scene */
    hobe_modes *modes; /* first: KEY_MODES reads it */
    const hobe_model *model;
};

/* ---- modes ---------------------------------------------------------------------------------- */

static int finalize(lua_State *L)
{
    struct modes *modes = luaL_checkudata(L, 1, HOBE_LUA_MODES);
    hobe_modes_free(modes->modes);
    modes->modes = NULL;
    return 0;
}

/* All numbers that are not of one mode. */
struct summary {
    struct hobe_modes_info modes;
    struct hobe_model_info model;
};

#define FOUND(key, field, type, unit, doc) FIELD_AS(key, struct summary, field, type, unit, doc)

static const struct hobe_lua_field fields[] = {
    FOUND("count", modes.count, 'i', NULL, "modes found"),
    FOUND("unstable", modes.unstable, 'i', NULL,
          "modes of the scene that grow, asked for or not; -1 where they were not counted"),
    FOUND("residual", modes.residual, 'd', NULL,
          "of a turning frame: how much a step of inverse iteration would change the worst shape, "
          "relative; its square is about the error of a frequency"),
    FOUND("mass", modes.mass, 'd', "kg", "of all beams, bodies and masses"),
    FOUND("unknowns", modes.unknowns, 'l', NULL, "scalar unknowns"),
    FOUND("setup_seconds", model.setup, 'd', "s", "building the scene"),
    FOUND("solve_seconds", modes.seconds, 'd', "s", "finding the modes"),
    {0}};

static const char methods[] = "auto|dense|lanczos"; /* in the order of hobe_modal_method */

static int get_field(lua_State *L)
{
    const struct modes *modes = luaL_checkudata(L, 1, HOBE_LUA_MODES);
    struct summary summary;
    hobe_modes_info(modes->modes, &summary.modes);
    hobe_model_info(modes->model, &summary.model);
    if (!strcmp(lua_tostring(L, 2), "method")) {
        lua_pushstring(L, summary.modes.method == HOBE_MODAL_DENSE ? "dense" : "lanczos");
        return 1;
    }
    return hobe_lua_push_field(L, "a set of modes", fields, &summary, lua_tostring(L, 2));
}

/* The mode, from 0, that the first argument of a method asks for; `name` is the method. */
static int read_index(lua_State *L, const struct modes *modes, const char *name)
{
    static const struct hobe_lua_key whole = {.name = "i", .type = KEY_WHOLE, REQUIRED};
    struct hobe_modes_info info;
    int i;
    hobe_modes_info(modes->modes, &info);
    hobe_lua_read_value(L, 2, lua_pushfstring(L, "%s: the mode", name), &whole, &i);
    if (i < 1 || i > info.count)
        hobe_lua_fail(L, "%s: the mode must be from 1 to %d, got %d", name, info.count, i);
    return i - 1;
}

/* The modes, the first argument, which must be of one kind. */
static const struct modes *read_modes(lua_State *L, const char *name, int buckling)
{
    const struct modes *modes = luaL_checkudata(L, 1, HOBE_LUA_MODES);
    struct hobe_modes_info info;
    hobe_modes_info(modes->modes, &info);
    if (info.buckling != buckling)
        hobe_lua_fail(L,
                      buckling ? "%s: modes of vibration have frequencies, not load factors"
                               : "%s: modes of buckling have load factors, factor(i), no more",
                      name);
    return modes;
}

static struct hobe_mode read_mode(lua_State *L, const char *name)
{
    const struct modes *modes = read_modes(L, name, 0);
    struct hobe_mode mode;
    struct hobe_error err;
    lua_settop(L, 2);
    if (hobe_modes_mode(modes->modes, read_index(L, modes, name), &mode, &err))
        hobe_lua_raise(L, &err);
    return mode;
}

static int frequency(lua_State *L)
{
    lua_pushnumber(L, read_mode(L, "frequency").omega);
    return 1;
}

static int omega2(lua_State *L)
{
    lua_pushnumber(L, read_mode(L, "omega2").omega2);
    return 1;
}

static int growth(lua_State *L)
{
    lua_pushnumber(L, read_mode(L, "growth").growth);
    return 1;
}

static int whirl(lua_State *L)
{
    lua_pushnumber(L, read_mode(L, "whirl").whirl);
    return 1;
}

static int participation(lua_State *L)
{
    return hobe_lua_push_numbers(L, read_mode(L, "participation").participation, 3);
}

static int effective_mass(lua_State *L)
{
    return hobe_lua_push_numbers(L, read_mode(L, "effective_mass").effective_mass, 3);
}

static int factor(lua_State *L)
{
    const struct modes *modes = read_modes(L, "factor", 1);
    lua_settop(L, 2);
    lua_pushnumber(L, hobe_modes_factor(modes->modes, read_index(L, modes, "factor")));
    return 1;
}

static int factors(lua_State *L)
{
    const struct modes *modes = read_modes(L, "factors", 1);
    struct hobe_modes_info info;
    hobe_modes_info(modes->modes, &info);
    lua_createtable(L, info.count, 0);
    for (int i = 0; i < info.count; i++) {
        lua_pushnumber(L, hobe_modes_factor(modes->modes, i));
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static int frequencies(lua_State *L)
{
    const struct modes *modes = read_modes(L, "frequencies", 0);
    struct hobe_modes_info info;
    hobe_modes_info(modes->modes, &info);
    lua_createtable(L, info.count, 0);
    for (int i = 0; i < info.count; i++) {
        struct hobe_mode mode;
        struct hobe_error err;
        if (hobe_modes_mode(modes->modes, i, &mode, &err))
            hobe_lua_raise(L, &err);
        lua_pushnumber(L, mode.omega);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

typedef enum hobe_status mode_point(const hobe_modes *, int, const char *, double, double, double,
                                    double[3], struct hobe_error *);

/* The displacement {x, y, z} of a place in a mode, as the method `name` gives it. */
static int push_point(lua_State *L, const char *name, mode_point *point)
{
    static const struct hobe_lua_key at_key = {
        .name = "at", .type = KEY_NUMBER, REQUIRED, KEY_WITHIN(0, 1)};
    static const struct hobe_lua_key offset_key = {.name = "offset", .type = KEY_NUMBER};
    const struct modes *modes = luaL_checkudata(L, 1, HOBE_LUA_MODES);
    struct hobe_error err;
    double at, y, z, u[3], quadrature[3], of[3];
    lua_settop(L, 6);
    const int i = read_index(L, modes, name);
    const char *beam = hobe_lua_text(L, 3, lua_pushfstring(L, "%s: the beam", name));
    if (hobe_model_has_body(modes->model, beam)) {
        const int given = hobe_lua_read_body_point(L, 4, name, of);
        if (hobe_modes_body(modes->modes, i, beam, given ? of : NULL, u, quadrature, &err))
            hobe_lua_raise(L, &err);
        return hobe_lua_push_numbers(L, point == hobe_modes_quadrature ? quadrature : u, 3);
    }
    hobe_lua_read_value(L, 4, lua_pushfstring(L, "%s: at", name), &at_key, &at);
    hobe_lua_read_value(L, 5, lua_pushfstring(L, "%s: y", name), &offset_key, &y);
    hobe_lua_read_value(L, 6, lua_pushfstring(L, "%s: z", name), &offset_key, &z);
    if (point(modes->modes, i, beam, at, y, z, u, &err))
        hobe_lua_raise(L, &err);
    return hobe_lua_push_numbers(L, u, 3);
}

static int shape(lua_State *L)
{
    return push_point(L, "shape", hobe_modes_point);
}

static int quadrature(lua_State *L)
{
    return push_point(L, "quadrature", hobe_modes_quadrature);
}

const struct hobe_lua_entry hobe_lua_modes_methods[] = {
    {"frequency", frequency, "m:frequency(i)",
     "Natural frequency of the i-th mode, i = 1, 2, ... with omega^2 ascending, rad/s; not a "
     "number where the mode grows without vibrating.  Of a scene that spins: in the turning frame.",
     NULL, NULL},
    {"frequencies", frequencies, "m:frequencies()", "All of them in a list, rad/s.", NULL, NULL},
    {"omega2", omega2, "m:omega2(i)",
     "Its square, rad^2/s^2; negative for a mode in which the equilibrium is unstable.  In a "
     "turning frame -Re lambda^2 of the motion exp(lambda t).",
     NULL, NULL},
    {"growth", growth, "m:growth(i)",
     "Re lambda, 1/s: > 0 for a mode that grows, as exp(lambda t).  With a frequency beside it, "
     "flutter.",
     NULL, NULL},
    {"whirl", whirl, "m:whirl(i)",
     "In a turning frame: 1 where all circles about the axis as the frame turns, -1 against it, 0 "
     "where the motion is to and fro.",
     NULL, NULL},
    {"shape", shape, "m:shape(i, beam, at [, y, z])",
     "`{u1, u2, u3}` of the i-th mode at a place, as `r:displacement` takes it, global axes, "
     "normalised to modal mass 1 (phi' M phi = 1), so in 1/sqrt(kg); of buckling to phi' G phi = "
     "-1 J, so in m.",
     NULL, NULL},
    {"quadrature", quadrature, "m:quadrature(i, beam, at [, y, z])",
     "`{u1, u2, u3}`, a quarter period out of phase with the shape, that modes of a turning frame "
     "have: at the phase p of its cycle the place is displaced by shape cos p - quadrature sin p.  "
     "The largest component is at its crest at p = 0.",
     NULL, NULL},
    {"factor", factor, "m:factor(i)",
     "Of buckling: the i-th critical factor of all loads, ascending.", NULL, NULL},
    {"factors", factors, "m:factors()", "All of them in a list.", NULL, NULL},
    {"participation", participation, "m:participation(i)",
     "`{x, y, z}`: participation factors phi' M r in sqrt(kg), r the unit translation of the "
     "whole scene, supports included, along each global axis; no numbers in a turning frame.",
     NULL, NULL},
    {"effective_mass", effective_mass, "m:effective_mass(i)",
     "`{x, y, z}`: their squares, kg.  Over all modes they add up to `m.mass` less what rests on "
     "the supports.",
     NULL, NULL},
    {0}};

/* ---- the verb ------------------------------------------------------------------------------- */

struct options {
    int modes, method;
    const hobe_solution *state;
};

static const struct hobe_lua_key modal_keys[] = {
    KEY(struct options, modes, KEY_WHOLE, KEY_WITHIN(1, 1e6), .fallback = 10,
        .doc = "how many, those of the smallest omega^2, or the smallest critical loads"),
    KEY(struct options, state, KEY_RESULT,
        .doc = "a result of this scene, about whose equilibrium it vibrates (so that prestress "
               "counts), or from which it buckles; the reference, without loads, where left out"),
    KEY(struct options, method, KEY_CHOICE, .choices = methods, .word = "auto",
        .doc = "LAPACK's dense solver, or Lanczos' method with shift and invert (ARPACK); by the "
               "size of the scene where left out"),
    {0}};

static const struct hobe_lua_schema modal_schema = {"modal", modal_keys};
static const struct hobe_lua_schema buckling_schema = {"buckling", modal_keys};

static struct hobe_modal_options read_options(lua_State *L, const struct hobe_lua_schema *schema,
                                              const hobe_solution **state)
{
    struct options read = {0};
    if (lua_isnil(L, 2)) {
        lua_newtable(L);
        lua_replace(L, 2);
    }
    hobe_lua_read(L, 2, schema, &read);
    *state = read.state;
    return (struct hobe_modal_options){
        .modes = read.modes, .method = read.method ? (enum hobe_modal_method)(read.method - 1) : 0};
}

typedef enum hobe_status find_modes(hobe_model *, const hobe_solution *,
                                    const struct hobe_modal_options *, hobe_modes **,
                                    struct hobe_error *);

/* hobe.VERB(scene, options), VERB the schema's name. */
static int find(lua_State *L, const struct hobe_lua_schema *schema, find_modes *verb)
{
    lua_settop(L, 2);
    struct hobe_lua_scene *scene = hobe_lua_read_scene(L, schema->name);
    const hobe_solution *state;
    struct hobe_error err;
    const struct hobe_modal_options options = read_options(L, schema, &state);
    hobe_lua_check_linear(L, schema->name);
    struct modes *modes = lua_newuserdatauv(L, sizeof *modes, 1);
    *modes = (struct modes){NULL, scene->model};
    hobe_lua_set_type(L, HOBE_LUA_MODES, finalize, hobe_lua_modes_methods, get_field);
    lua_pushvalue(L, 1);
    lua_setiuservalue(L, -2, 1);
    hobe_lua_pause_clock();
    enum hobe_status status = verb(scene->model, state, &options, &modes->modes, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    struct hobe_modes_info info;
    hobe_modes_info(modes->modes, &info);
    hobe_lua_context(L)->cost.solve += info.seconds;
    hobe_lua_note_reduced(L, NAN, NULL);
    if (hobe_modes_note(modes->modes))
        hobe_lua_note(L, "%s", hobe_modes_note(modes->modes));
    return 1;
}

static int modal(lua_State *L)
{
    return find(L, &modal_schema, hobe_modal);
}

static int buckling(lua_State *L)
{
    return find(L, &buckling_schema, hobe_buckling);
}

const struct hobe_lua_entry hobe_lua_modal_entries[] = {
    {"modal", modal, "hobe.modal(scene [, {modes =, state =, method =}])",
     "Natural frequencies and mode shapes of small undamped vibrations about the reference, or "
     "about the equilibrium of a result: K phi = omega^2 M phi.  Where the scene has "
     "a `hobe.spin`, about a result: with Coriolis' force in the turning frame, lambda^2 M phi + 2 "
     "lambda M w x phi + K phi = 0.  Every beam needs a density.  "
     "Returns a set of modes; its field `method` is the one that was used.  An unstable "
     "equilibrium is said in a note with the results.",
     &modal_schema, fields},
    {"buckling", buckling, "hobe.buckling(scene [, {modes =, state =, method =}])",
     "Linear buckling: the factors of all loads at which the stiffness of the reference, or of the "
     "equilibrium of a result, becomes singular when stresses grow linearly; the smallest positive "
     "ones.  Where loads move the scene much before it buckles, ask again from a result near the "
     "critical load, or follow the path with `hobe.path`.  Returns a set of modes, for "
     "`m:factor(i)`, `m:shape(...)` and pictures; "
     "its mass is 0.",
     &buckling_schema, fields},
    {0}};
