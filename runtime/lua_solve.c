/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verbs of equilibrium: statics and paths. */
#include "advise.h"
#include "lua_item.h"
#include "lua_result.h"

#include <math.h>
#include <string.h>

/* ---- Newton's log --------------------------------------------------------------------------- */

/* What the solver tells us as it goes.  The core must not be left by an error of Lua, so that
 * nothing here calls Lua. */
struct watch {
    struct hobe_lua *context;
    int log;      /* write each iteration to stderr */
    int shown;    /* a progress line stands on the terminal */
    double since; /* when it was last renewed, s */
};

static void write_row(struct hobe_text *text, int solve, const struct hobe_iteration *it)
{
    if (text->size == 0)
        hobe_text_add(text, "solve,step,iteration,load,residual,energy,line,note\n");
    hobe_text_add(text, "%d,%d,%d,%.6g,%.6g,%.6g,%.6g,", solve, it->step, it->iteration, it->load,
                  it->residual, it->energy, it->line);
    hobe_text_csv(text, it->note ? it->note : "");
    hobe_text_bytes(text, "\n", 1);
}

static void watch_iteration(void *p, const struct hobe_iteration *it)
{
    struct watch *watch = p;
    if (watch->context->program && watch->context->folder)
        write_row(&watch->context->newton, watch->context->solves, it);
    if (watch->log) {
        const char *note = it->note ? it->note : "";
        fprintf(stderr, "%5d %5d %9.6f %10.3e %10.3e %6.3f%s%s\n", it->step, it->iteration,
                it->load, it->residual, it->energy, it->line, *note ? "  " : "", note);
    } else if (watch->context->progress && hobe_lua_now() - watch->since > 0.2) {
        fprintf(stderr, "\rload %.4f, step %d, iteration %d, residual %.1e\033[K", it->load,
                it->step, it->iteration, it->residual);
        watch->since = hobe_lua_now();
        watch->shown = 1;
    }
}

static void begin_watch(struct watch *watch, struct hobe_lua *context, int log)
{
    *watch = (struct watch){context, log || context->log, 0, hobe_lua_now()};
    context->solves++;
    if (watch->log)
        fprintf(stderr, " step  iter      load   residual     energy   line  (solve %d)\n",
                context->solves);
}

static void end_watch(const struct watch *watch)
{
    if (watch->shown)
        fputs("\r\033[K", stderr);
}

/* ---- what all verbs read -------------------------------------------------------------------- */

void hobe_lua_check_linear(lua_State *L, const char *verb)
{
    const struct advise_model *model = hobe_lua_context(L)->model;
    if (model && model->linear && strcmp(verb, "static"))
        hobe_lua_fail(L, "%s: a linear model is one of hobe.static alone", verb);
}

struct hobe_lua_scene *hobe_lua_read_verb(lua_State *L, const struct hobe_lua_schema *schema,
                                          void *options, size_t size)
{
    lua_settop(L, 2);
    if (hobe_lua_context(L)->called)
        hobe_lua_fail(L, "%s: a function that a solver calls cannot solve", schema->name);
    struct hobe_lua_scene *scene = hobe_lua_read_scene(L, schema->name);
    if (lua_isnil(L, 2)) {
        lua_newtable(L);
        lua_replace(L, 2);
    }
    memset(options, 0, size);
    hobe_lua_read(L, 2, schema, options);
    hobe_lua_check_linear(L, schema->name);
    return scene;
}

/* ---- statics -------------------------------------------------------------------------------- */

struct options {
    struct hobe_newton newton;
    struct hobe_projection projection;
    int line_search, log;
};

#define NEWTON(name, kind, ...) KEY_AS(#name, struct options, newton.name, kind, __VA_ARGS__)

/* METHOD of the options of a verb. */
#define METHOD(owner, field)                                                                       \
    KEY_AS("method", owner, field, KEY_CHOICE, .choices = "newton|series", .word = "newton",       \
           .doc = "`series`: steps go along a power series of the path, as far as that is good; "  \
                  "fewer factorisations where many steps are needed")

static const struct hobe_lua_key static_keys[] = {
    METHOD(struct options, newton.method),
    NEWTON(start, KEY_RESULT,
           .doc = "a result to start from, at the full load, in one step, or if that fails from "
                  "the reference: of this scene or of one of the same shape, under another load "
                  "or of other size; not by series.  So a sweep goes from neighbour to neighbour: "
                  "r = hobe.static(scene, { start = r })"),
    NEWTON(steps, KEY_WHOLE, KEY_WITHIN(1, 1e6), .fallback = 1, .doc = "load steps to begin with"),
    NEWTON(time, KEY_NUMBER, KEY_FROM(0), .unit = "s",
           .doc = "when functions of time are taken; load steps go to the motions of joints there, "
                  "as to the loads"),
    NEWTON(tolerance, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-9,
           .doc = "residual to reach, relative to the load"),
    NEWTON(max_iterations, KEY_WHOLE, KEY_WITHIN(1, 1000), .fallback = 30,
           .doc = "iterations of a step before it is cut"),
    NEWTON(smallest_step, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-4,
           .doc = "share of the load below which a step is not cut"),
    KEY(struct options, projection, KEY_GROUP, .group = &hobe_lua_projection_schema,
        .doc = "looks for corrections among few fields only, by the matrices and forces of the "
               "whole: it shows what such fields can do, and takes longer; not by series"),
    NEWTON(linear, KEY_FLAG,
           .doc = "the linear response to the loads instead, right where they are small: one "
                  "correction from the reference; `residual` tells how far from equilibrium it is"),
    KEY(struct options, line_search, KEY_FLAG, .fallback = 1,
        .doc = "whether steps that increase the residual are shortened"),
    KEY(struct options, log, KEY_FLAG, .doc = "print each iteration on standard error"),
    {0}};

static const struct hobe_lua_schema static_schema = {"static", static_keys};

/* hobe.static(scene, options) */
static int solve_static(lua_State *L)
{
    struct options options;
    struct hobe_lua_scene *scene = hobe_lua_read_verb(L, &static_schema, &options, sizeof options);
    struct watch watch;
    struct hobe_error err;
    const struct advise_model *model = hobe_lua_context(L)->model;
    options.newton.no_line_search = !options.line_search;
    options.newton.projection = hobe_lua_finish_projection(L, &static_schema, &options.projection);
    options.newton.linear |= model && model->linear;
    hobe_solution **solution = hobe_lua_new_result(L, 1);
    options.newton.log = watch_iteration;
    options.newton.context = &watch;
    hobe_lua_pause_clock();
    begin_watch(&watch, hobe_lua_context(L), options.log);
    enum hobe_status status = hobe_static(scene->model, &options.newton, solution, &err);
    end_watch(&watch);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    struct hobe_solution_info info;
    hobe_solution_info(*solution, &info);
    hobe_lua_context(L)->cost.factorisations += info.factorisations;
    hobe_lua_context(L)->cost.solve += info.seconds;
    hobe_lua_note_change(L, info.change);
    hobe_lua_note_reduced(L, info.indicator, *solution);
    hobe_lua_warn_equilibrium(L, *solution, scene->model);
    return 1;
}

/* ---- paths ---------------------------------------------------------------------------------- */

struct path_options {
    struct hobe_path_options path;
    int log;
};

static const struct hobe_lua_key reach_keys[] = {
    KEY(struct hobe_reach, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam"),
    KEY(struct hobe_reach, at, KEY_NUMBER, REQUIRED, KEY_WITHIN(0, 1),
        .doc = "place, a fraction of the beam's length"),
    KEY(struct hobe_reach, value, KEY_VECTOR, REQUIRED, .unit = "m",
        .doc = "reached when the displacement has this component along this direction"),
    {0}};

static const struct hobe_lua_schema reach_schema = {"reach", reach_keys};

#define PATH(name, field, kind, ...)                                                               \
    KEY_AS(name, struct path_options, path.field, kind, __VA_ARGS__)

static const struct hobe_lua_key path_keys[] = {
    PATH("steps", steps, KEY_WHOLE, KEY_WITHIN(1, 1e6), .fallback = 200, .doc = "steps at most"),
    PATH("arc", arc, KEY_NUMBER, KEY_ABOVE(0),
         .doc = "longest step: 1 is what the linear response to all loads would take; 0.05 unless "
                "given, by series without limit"),
    PATH("smallest_arc", smallest_arc, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-4,
         .doc = "share of it below which a step is not cut"),
    PATH("to", to, KEY_NUMBER, .fallback = 1,
         .doc = "load factor that ends the path, other than 0; the path starts towards it"),
    PATH("reach", reach, KEY_GROUP, .group = &reach_schema,
         .doc = "a displacement that ends the path"),
    METHOD(struct path_options, path.newton.method),
    PATH("tolerance", newton.tolerance, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-9,
         .doc = "residual to reach, relative to the load"),
    PATH("max_iterations", newton.max_iterations, KEY_WHOLE, KEY_WITHIN(1, 1000), .fallback = 12,
         .doc = "iterations of a step before it is cut"),
    KEY(struct path_options, log, KEY_FLAG, .doc = "print each iteration on standard error"),
    {0}};

static const struct hobe_lua_schema path_schema = {"path", path_keys};

struct path {
    hobe_path *path;
};

static int finalize_path(lua_State *L)
{
    struct path *path = luaL_checkudata(L, 1, "hobe.path");
    hobe_path_free(path->path);
    path->path = NULL;
    return 0;
}

static void set_number(lua_State *L, const char *key, double value)
{
    lua_pushnumber(L, value);
    lua_setfield(L, -2, key);
}

/* Sets limit_points and bifurcations of the table on top, and says them in notes. */
static void set_events(lua_State *L, const hobe_path *path)
{
    static const char *const lists[] = {"limit_points", "bifurcations"};
    for (int kind = 0; kind < 2; kind++) {
        lua_newtable(L);
        for (int i = 0; hobe_path_event(path, i); i++) {
            const struct hobe_path_event *event = hobe_path_event(path, i);
            char text[300];
            if (event->bifurcation != kind)
                continue;
            hobe_path_event_text(event, text, sizeof text);
            hobe_lua_note(L, "%s", text);
            lua_newtable(L);
            set_number(L, "load", event->extreme);
            set_number(L, "from", event->load[0]);
            set_number(L, "to", event->load[1]);
            set_number(L, "change", event->change);
            lua_pushinteger(L, event->before + 1);
            lua_setfield(L, -2, "after");
            lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
        }
        lua_setfield(L, -2, lists[kind]);
    }
}

/* Pushes the list of results with the fields of the whole path. */
static void push_path(lua_State *L, hobe_path *path, const hobe_model *model)
{
    static const char *const ends[] = {"load", "displacement", "steps"};
    struct hobe_path_info info;
    struct hobe_solution_info of;
    double change = 0, indicator = NAN;
    const hobe_solution *last = NULL;
    hobe_path_info(path, &info);
    hobe_lua_context(L)->cost.solve += info.seconds;
    hobe_lua_context(L)->cost.factorisations += info.factorisations;
    lua_createtable(L, info.points, 6);
    for (int i = 0; i < info.points; i++) {
        hobe_solution **point = hobe_lua_new_result(L, 1);
        last = *point = hobe_path_take(path, i);
        hobe_solution_info(last, &of);
        change = fmax(change, of.change);
        indicator = fmax(indicator, of.indicator);
        lua_rawseti(L, -2, i + 1);
    }
    hobe_lua_note_change(L, change);
    hobe_lua_note_reduced(L, indicator, NULL);
    lua_pushstring(L, ends[info.end]);
    lua_setfield(L, -2, "ended");
    set_number(L, "solve_seconds", info.seconds);
    lua_pushinteger(L, info.iterations);
    lua_setfield(L, -2, "iterations");
    lua_pushinteger(L, info.cutbacks);
    lua_setfield(L, -2, "cutbacks");
    lua_pushinteger(L, info.factorisations);
    lua_setfield(L, -2, "factorisations");
    set_events(L, path);
    hobe_lua_warn_path(L, last, model);
    if (info.end == HOBE_PATH_STEPS)
        hobe_lua_note(L, "the path ends after its %d steps, short of its end; give it more steps",
                      info.points);
}

/* hobe.path(scene, options) */
static int solve_path(lua_State *L)
{
    struct path_options options;
    struct hobe_lua_scene *scene = hobe_lua_read_verb(L, &path_schema, &options, sizeof options);
    struct watch watch;
    struct hobe_error err;
    if (options.path.to == 0)
        hobe_lua_fail(L, "path: to must not be 0, where the path begins");
    struct path *path = lua_newuserdatauv(L, sizeof *path, 0);
    path->path = NULL;
    hobe_lua_set_type(L, "hobe.path", finalize_path, NULL, NULL);
    options.path.newton.log = watch_iteration;
    options.path.newton.context = &watch;
    hobe_lua_pause_clock();
    begin_watch(&watch, hobe_lua_context(L), options.log);
    enum hobe_status status = hobe_path_follow(scene->model, &options.path, &path->path, &err);
    end_watch(&watch);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    push_path(L, path->path, scene->model);
    return 1;
}

const struct hobe_lua_entry hobe_lua_solve_entries[] = {
    {"static", solve_static, "hobe.static(scene [, {steps =, ...}])",
     "Static equilibrium under all loads, from the reference: load steps with automatic "
     "cut-back, Newton's iteration with line search.  Returns a result.",
     &static_schema, hobe_lua_result_fields},
    {"path", solve_path, "hobe.path(scene [, {steps =, arc =, to =, reach =, ...}])",
     "The equilibrium path from the reference through limit points, by arc length: the load factor "
     "is found with the displacements.  Returns a list of results, `p[i].load` the load factor of "
     "the i-th and `p[i].negative` its negative eigenvalues; and in it `ended`, what ended it: "
     "`\"load\"`, `\"displacement\"` or `\"steps\"`; `iterations`, `factorisations`, `cutbacks`, "
     "`solve_seconds`; and `limit_points` and `bifurcations`, lists of tables: `load`, the factor "
     "there; `from` and "
     "`to`, those of the points before and after; `after`, the number of the point before; "
     "`change`, of the negative eigenvalues.  They are said in notes, too.  At a bifurcation the "
     "path goes on straight.",
     &path_schema, NULL},
    {0}};
