/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motion in time as Lua sees it. */
#define _GNU_SOURCE
#include "advise.h"
#include "journal.h"
#include "lua_item.h"
#include "lua_result.h"

#include <math.h>
#include <string.h>

/* Its user values are the scene and the results of the states asked for so far. */
struct history {
    hobe_history *history; /* first: KEY_HISTORY reads it */
    hobe_journal *journal; /* while it is solved */
};

enum { SCENE = 1, STATES = 2 };

/* The error of a step, over the scene's size, from which on it is said. */
static const double COARSE = 1e-3;

/* ---- the log -------------------------------------------------------------------------------- */

/* Nothing here calls Lua: the core must not be left by an error of Lua. */
struct watch {
    const struct hobe_lua *context;
    int log;      /* write each step to stderr */
    int shown;    /* a progress line stands on the terminal */
    double since; /* when it was last renewed, s */
};

static void watch_step(void *p, const struct hobe_time_step *step)
{
    struct watch *watch = p;
    if (watch->log)
        fprintf(stderr, "%8ld %14.7g %10.3e %5d %10.3e%s%s\n", step->step, step->time, step->size,
                step->iterations, step->error, *step->note ? "  " : "", step->note);
    else if (watch->context->progress && hobe_lua_now() - watch->since > 0.2) {
        fprintf(stderr, "\rt = %.5g s, h = %.3g s, step %ld, iterations %d\033[K", step->time,
                step->size, step->step, step->iterations);
        watch->since = hobe_lua_now();
        watch->shown = 1;
    }
}

static void write_rows(struct hobe_lua *context, const hobe_history *history)
{
    struct hobe_text *text = &context->motion;
    const struct hobe_energies *e;
    if (text->size == 0)
        hobe_text_add(text,
                      "solve,time,kinetic,strain,loads,drives,damped,balance,px,py,pz,lx,ly,lz,"
                      "violation,violation_rate\n");
    for (int i = 0; (e = hobe_history_energies(history, i)); i++) {
        const double *p = e->momentum, *l = e->angular_momentum;
        hobe_text_add(
            text, "%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.3g,%.3g\n",
            context->solves, e->time, e->kinetic, e->strain, e->loads, e->drives, e->damped,
            e->balance, p[0], p[1], p[2], l[0], l[1], l[2], e->violation, e->violation_rate);
    }
}

/* ---- a motion ------------------------------------------------------------------------------- */

static const hobe_history *check_history(lua_State *L)
{
    return ((const struct history *)luaL_checkudata(L, 1, HOBE_LUA_HISTORY))->history;
}

static int finalize(lua_State *L)
{
    struct history *history = luaL_checkudata(L, 1, HOBE_LUA_HISTORY);
    hobe_history_free(history->history);
    journal_close(history->journal);
    *history = (struct history){NULL, NULL};
    return 0;
}

#define INFO(key, field, type, unit, doc)                                                          \
    FIELD_AS(key, struct hobe_history_info, field, type, unit, doc)

static const struct hobe_lua_field fields[] = {
    INFO("count", states, 'i', NULL, "states that were kept, the start among them"),
    INFO("steps", steps, 'l', NULL, "steps taken"),
    INFO("rejected", rejected, 'l', NULL, "steps tried and given up"),
    INFO("iterations", iterations, 'l', NULL, "Newton iterations in all"),
    INFO("factorisations", factorisations, 'l', NULL, "factorisations in all"),
    INFO("projected", projected, 'l', NULL,
         "unknowns of a projection, multipliers included; 0: none"),
    INFO("linearisations", linearisations, 'i', NULL,
         "how often the modes of a projection were found"),
    INFO("smallest_step", smallest_step, 'd', "s", "the shortest step taken"),
    INFO("largest_step", largest_step, 'd', "s", "the longest"),
    INFO("largest_error", largest_error, 'd', NULL,
         "the greatest error of displacements in a step, as estimated, relative to the scene's "
         "size; hobe.dynamic warns where it is more than 0.001"),
    INFO("solve_seconds", seconds, 'd', "s", "solving"),
    {0}};

/* The list of the times of all states. */
static int push_times(lua_State *L, const hobe_history *history)
{
    const struct hobe_energies *e;
    lua_newtable(L);
    for (int i = 0; (e = hobe_history_energies(history, i)); i++) {
        lua_pushnumber(L, e->time);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static int get_field(lua_State *L)
{
    const hobe_history *history = check_history(L);
    struct hobe_history_info info;
    if (!strcmp(lua_tostring(L, 2), "times"))
        return push_times(L, history);
    hobe_history_info(history, &info);
    return hobe_lua_push_field(L, "a motion", fields, &info, lua_tostring(L, 2));
}

/* The number of the state, from 0, that the argument of a method asks for. */
static int read_index(lua_State *L, const hobe_history *history, const char *name)
{
    static const struct hobe_lua_key whole = {.name = "i", .type = KEY_WHOLE, REQUIRED};
    struct hobe_history_info info;
    int i;
    hobe_history_info(history, &info);
    hobe_lua_read_value(L, 2, lua_pushfstring(L, "%s: the state", name), &whole, &i);
    if (i < 1 || i > info.states)
        hobe_lua_fail(L, "%s: the state must be from 1 to %d, got %d", name, info.states, i);
    return i - 1;
}

const hobe_solution *hobe_lua_push_state(lua_State *L, int motion, int i)
{
    struct history *history = lua_touserdata(L, motion);
    lua_getiuservalue(L, motion, STATES);
    if (lua_rawgeti(L, -1, i + 1) == LUA_TNIL) {
        lua_getiuservalue(L, motion, SCENE);
        *hobe_lua_new_result(L, -1) = hobe_history_take(history->history, i);
        lua_replace(L, -3); /* the nil */
        lua_pop(L, 1);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, i + 1);
    }
    lua_remove(L, -2);
    return *(hobe_solution **)lua_touserdata(L, -1);
}

/* d:state(i) */
static int state(lua_State *L)
{
    const hobe_history *history = check_history(L);
    lua_settop(L, 2);
    hobe_lua_push_state(L, 1, read_index(L, history, "state"));
    return 1;
}

#define BALANCE(name, type, unit, doc) FIELD(struct hobe_energies, name, type, unit, doc)

static const struct hobe_lua_field energy_fields[] = {
    BALANCE(time, 'd', "s", "of the state"),
    BALANCE(kinetic, 'd', "J", "kinetic energy"),
    BALANCE(strain, 'd', "J", "strain energy"),
    BALANCE(loads, 'd', "J", "work of the loads since the start"),
    BALANCE(drives, 'd', "J", "and of the drives of joints"),
    BALANCE(damped, 'd', "J", "what damping has taken since the start"),
    BALANCE(balance, 'd', "J",
            "kinetic + strain - their sum at the start - loads - drives + damped"),
    BALANCE(violation, 'd', NULL, "largest violation of a constraint, of the scene's size or rad"),
    BALANCE(violation_rate, 'd', "1/s", "and its rate"),
    {0}};

/* d:energies(i) */
static int energies(lua_State *L)
{
    const hobe_history *history = check_history(L);
    lua_settop(L, 2);
    const struct hobe_energies *e =
        hobe_history_energies(history, read_index(L, history, "energies"));
    lua_newtable(L);
    for (const struct hobe_lua_field *field = energy_fields; field->name; field++) {
        hobe_lua_push_field(L, "energies", energy_fields, e, field->name);
        lua_setfield(L, -2, field->name);
    }
    hobe_lua_push_numbers(L, e->momentum, 3);
    lua_setfield(L, -2, "momentum");
    hobe_lua_push_numbers(L, e->angular_momentum, 3);
    lua_setfield(L, -2, "angular_momentum");
    return 1;
}

const struct hobe_lua_entry hobe_lua_history_methods[] = {
    {"state", state, "d:state(i)",
     "The i-th state that was kept, i = 1 the start, as a result: with `time`, velocities and "
     "accelerations; its reactions and resultants have the forces of inertia in them.",
     NULL, NULL},
    {"energies", energies, "d:energies(i)",
     "What the motion has in the i-th state, a table: `time`, s; `kinetic` and `strain` energy, "
     "the "
     "work of `loads` and `drives` and what damping has taken, `damped`, since the start, J; "
     "`balance`, what "
     "the integration has lost (negative), J; `momentum`, kg m/s, and `angular_momentum` about the "
     "origin, kg m^2/s; `violation`, the largest of the constraints, relative to the scene's size, "
     "or rad, and `violation_rate`, 1/s.",
     NULL, NULL},
    {0}};

/* ---- the verb ------------------------------------------------------------------------------- */

struct options {
    struct hobe_dynamic dynamic;
    struct hobe_projection projection;
    int log;
};

#define OPTION(name, kind, ...) KEY_AS(#name, struct options, dynamic.name, kind, __VA_ARGS__)

static const struct hobe_lua_key dynamic_keys[] = {
    OPTION(to, KEY_NUMBER, REQUIRED, .unit = "s", .doc = "the time that ends the motion"),
    OPTION(step, KEY_NUMBER, KEY_ABOVE(0), .unit = "s",
           .doc = "the step; with an accuracy, the longest one"),
    OPTION(accuracy, KEY_NUMBER, KEY_BETWEEN(0, 1),
           .doc =
               "chooses the steps: the error of displacements in a step, relative to the scene's "
               "size"),
    OPTION(rho, KEY_NUMBER, .fallback = 0.8, .lower = 0, .upper = 1,
           .bounds = KEY_LOWER | KEY_LOWER_OPEN | KEY_UPPER,
           .doc = "what a step leaves of vibrations too fast for it; 1 damps nothing, not even "
                  "errors"),
    OPTION(store, KEY_NUMBER, KEY_ABOVE(0), .unit = "s",
           .doc = "time between the states that are kept; steps end there.  Every step where left "
                  "out"),
    KEY_OF_OTHER("start", "\"equilibrium\" or result",
                 .doc = "\"equilibrium\": the static one under the loads at t = 0; a result: that "
                        "state, of a motion with its time and velocities; the reference where left "
                        "out"),
    OPTION(tolerance, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-9,
           .doc = "forces left over, relative to those of inertia, loads and joints"),
    OPTION(max_iterations, KEY_WHOLE, KEY_WITHIN(1, 1000), .fallback = 10,
           .doc = "iterations of a step before it is given up"),
    OPTION(smallest_step, KEY_NUMBER, KEY_ABOVE(0), .unit = "s",
           .doc = "below which a step is not cut; 1e-9 of the time to go where left out"),
    KEY(struct options, projection, KEY_GROUP, .group = &hobe_lua_projection_schema,
        .doc = "moves by few fields only, as in `hobe.static`; --resume "
               "begins such a motion again"),
    KEY(struct options, log, KEY_FLAG, .doc = "print each step on standard error"),
    {0}};

static const struct hobe_lua_schema dynamic_schema = {"dynamic", dynamic_keys};

/* Reads the key `start` of the table at index 2. */
static void read_start(lua_State *L, struct hobe_dynamic *options)
{
    static const struct hobe_lua_key result = {.name = "start", .type = KEY_RESULT};
    hobe_lua_push_key(L, 2, &dynamic_schema, "start");
    const char *word = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : NULL;
    options->equilibrium = word && !strcmp(word, "equilibrium");
    if (word && !options->equilibrium)
        hobe_lua_fail(L, "dynamic: start must be \"equilibrium\" or a result, got %s",
                      hobe_lua_describe(L, -1));
    if (!word)
        hobe_lua_read_value(L, -1, "dynamic: start", &result, &options->start);
    lua_pop(L, 1);
}

/* That of the last state, the largest of all. */
static double last_indicator(const hobe_history *history)
{
    struct hobe_history_info info;
    struct hobe_solution_info last;
    hobe_history_info(history, &info);
    hobe_solution_info(hobe_history_state(history, info.states - 1), &last);
    return last.indicator;
}

/* Warns where a fixed step was too long. */
static void warn_of_steps(lua_State *L, const hobe_history *history)
{
    struct hobe_history_info info;
    char text[200];
    hobe_history_info(history, &info);
    if (info.largest_error <= COARSE)
        return;
    snprintf(
        text, sizeof text,
        "dynamic: a step left an error of about %.2g of the scene's size; take a smaller step, "
        "or give an accuracy that chooses the steps",
        info.largest_error);
    hobe_lua_warn(L, HOBE_LUA_WARN_STEPS, text);
}

/* The step that the run's model asks for, or none; steps that an accuracy chooses are left to it.
 * Without `store` every step is a state, and the script's states would be others. */
static void follow_model(lua_State *L, struct hobe_dynamic *options)
{
    struct hobe_lua *context = hobe_lua_context(L);
    const struct advise_model *model = context->model;
    const int fixed = !(options->accuracy > 0), stored = options->store > 0;
    const double times = model && fixed ? model->step : 0;
    context->stepped |= fixed;
    context->moved = stored && context->moved >= 0 ? 1 : -1;
    options->quasi_static = model && model->without == ADVISE_NO_INERTIA;
    if (times > 0 && !stored)
        hobe_lua_fail(L, "dynamic: a model with another step needs store, the time between the "
                         "states that are kept");
    if (times > 0)
        options->step *= times;
}

/* hobe.dynamic(scene, options) */
static int solve_dynamic(lua_State *L)
{
    struct options options;
    const struct hobe_lua_scene *scene =
        hobe_lua_read_verb(L, &dynamic_schema, &options, sizeof options);
    struct hobe_lua *context = hobe_lua_context(L);
    struct watch watch = {context, options.log || context->log, 0, hobe_lua_now()};
    struct hobe_error err;
    read_start(L, &options.dynamic);
    follow_model(L, &options.dynamic);
    options.dynamic.projection =
        hobe_lua_finish_projection(L, &dynamic_schema, &options.projection);
    struct history *history = lua_newuserdatauv(L, sizeof *history, 2);
    *history = (struct history){NULL, NULL};
    hobe_lua_set_type(L, HOBE_LUA_HISTORY, finalize, hobe_lua_history_methods, get_field);
    lua_pushvalue(L, 1);
    lua_setiuservalue(L, -2, SCENE);
    lua_newtable(L);
    lua_setiuservalue(L, -2, STATES);
    options.dynamic.log = watch_step;
    options.dynamic.context = &watch;
    context->solves++;
    if (!options.dynamic.projection && !options.dynamic.quasi_static)
        history->journal = options.dynamic.journal = hobe_lua_open_journal(L);
    hobe_lua_pause_clock();
    if (watch.log)
        fprintf(stderr, "    step           time       size  iter      error  (solve %d)\n",
                context->solves);
    const enum hobe_status status =
        hobe_dynamic(scene->model, &options.dynamic, &history->history, &err);
    if (watch.shown)
        fputs("\r\033[K", stderr);
    hobe_lua_resume_clock();
    journal_close(history->journal);
    history->journal = NULL;
    if (status)
        hobe_lua_raise(L, &err);
    struct hobe_history_info info;
    hobe_history_info(history->history, &info);
    context->cost.solve += info.seconds;
    context->cost.factorisations += info.iterations;
    if (context->program && context->folder)
        write_rows(context, history->history);
    hobe_lua_note_reduced(L, last_indicator(history->history), NULL);
    if (options.dynamic.rho > 0.9)
        hobe_lua_warn(L, HOBE_LUA_WARN_DAMPING,
                      "dynamic: rho above 0.9 leaves fast vibrations, and errors, to grow; "
                      "motions with joints may fail");
    hobe_lua_warn_start(L, hobe_history_state(history->history, 0));
    warn_of_steps(L, history->history);
    return 1;
}

const struct hobe_lua_entry hobe_lua_dynamic_entries[] = {
    {"dynamic", solve_dynamic,
     "hobe.dynamic(scene, {to =, step = or accuracy =, start =, store =, rho =, ...})",
     "The motion of a scene under its loads, which may be free to move, by generalised alpha: "
     "implicit, of second order, constraints held at the end of each step, with steps that are "
     "fixed or as long as an accuracy allows.  Returns a motion: `d:state(i)`, and its field "
     "`times`, the list of their times.",
     &dynamic_schema, fields},
    {0}};
