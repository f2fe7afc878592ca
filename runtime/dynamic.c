/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motion in time: where it starts, which steps it takes, what is kept of it. */
#include "dynamic.h"

#include "body.h"
#include "constraint.h"
#include "drive.h"
#include "mass.h"
#include "quasi_static.h"
#include "reduction.h"
#include "solution.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The velocities of the start may be mended by so much, relatively, and by what would move the
 * scene by so much of its size to the end: drives are differentiated with rounding. */
static const double MENDED = 1e-6, TINY = 1e-9;

/* The constraints hold at the start to this, weighed: what a result of statics leaves. */
static const double CLOSED = 1e-8;

/* A step is tried again where its error is too large, and the next one grows where the error allows
 * a step longer by this at least: each change costs factors. */
static const double SAFETY = 0.9, SHRINK = 0.3, GROW = 1.5, MOST_GROWTH = 2;

/* Displacements, relative to the scene's size, after which a projection is made again. */
static const double DEVIATION = 0.1;

/* Steps of one length at least before it grows. */
enum { PATIENCE = 5 };

/* Accelerations that grow so much within a step, and move the scene by more than the accuracy, or
 * by this share of its size where the step is fixed, are the step's, not the motion's. */
static const double LEAP = 3, FAR = 0.01;

/* The first step of an accurate motion is this share of the time at most. */
static const double FIRST_STEP = 1e-3, SMALLEST_STEP = 1e-9;

/* Steps between the marks from which a motion can be taken up. */
enum { MARKED = 100 };

/* ---- the start ------------------------------------------------------------------------------ */

/* v = the rigid motion of a vector at q; positions move with the point `about`. */
static void move_rigidly(const struct hobe_motion *m, int position, const double q[3], double v[3])
{
    double arm[3];
    for (int a = 0; a < 3; a++)
        arm[a] = q[a] - (position ? m->about[a] : 0);
    cross3(m->angular_velocity, arm, v);
    for (int a = 0; a < 3 && position; a++)
        v[a] += m->velocity[a];
}

/* Sets the velocities of a beam's vectors, of which those that are held have none. */
static enum hobe_status set_velocities(const hobe_model *model, const struct hobe_motion *m,
                                       const struct beam *beam, const double *q, double *rate,
                                       struct hobe_error *err)
{
    for (int e = 0; e < beam->spec.elements; e++)
        for (int v = 0; v < beam->kernel->vectors; v++) {
            const struct hobe_vector *is = beam->kernel->vector + v;
            const long number = model_vector(model, beam, e, v);
            double *to = rate + 3 * number;
            move_rigidly(m, is->mode == 0 && !is->slope, q + 3 * number, to);
            if (model->held[number] && length3(to) > 0)
                return hobe_fail(err, HOBE_BAD_INPUT, m->where,
                                 "beam \"%s\" is clamped at %.4g and cannot start with the "
                                 "velocity {%g, %g, %g} there",
                                 beam->name,
                                 (e + beam->kernel->node[is->node]) / beam->spec.elements, to[0],
                                 to[1], to[2]);
        }
    return HOBE_OK;
}

static void set_body(const struct hobe_motion *m, const struct body *body, const double *q,
                     double *rate)
{
    for (long v = body->first; v < body->first + BODY_VECTORS; v++)
        move_rigidly(m, v == body->first, q + 3 * v, rate + 3 * v);
}

/* rate[vectors][3] = the velocities of a whole model that hobe_motion asks for in state u. */
static enum hobe_status find_velocities(const hobe_model *model, const double *u, double *rate,
                                        struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    double *q = hobe_alloc((size_t)(3 * model->vectors), sizeof *q, err);
    if (!q)
        return HOBE_NO_MEMORY;
    model_reference(model, q);
    for (long i = 0; i < 3 * model->moving; i++)
        q[i] += u[i];
    for (size_t i = 0; !status && i < model->motions.count; i++) {
        const struct hobe_motion *m = (const struct hobe_motion *)model->motions.item + i;
        struct part only = {NULL, NULL};
        if (m->beam)
            status = model_find_part(model, m->beam, m->where, &only, err);
        for (size_t b = 0; !status && b < model->beams.count; b++)
            if (!m->beam || only.beam == model_beam(model, b))
                status = set_velocities(model, m, model_beam(model, b), q, rate, err);
        for (size_t b = 0; !status && b < model->bodies.count; b++)
            if (!m->beam || only.body == model_body(model, b))
                set_body(m, model_body(model, b), q, rate);
    }
    hobe_free(q);
    return status;
}

/* The same of a reduced model, as far as its basis has them. */
static enum hobe_status fit_velocities(struct genalpha *g, struct hobe_error *err)
{
    const hobe_model *model = g->s.model, *whole = model_whole(model);
    const size_t size = (size_t)(3 * whole->vectors);
    double left = 0, *u = hobe_alloc(2 * size, sizeof *u, err);
    if (!u)
        return HOBE_NO_MEMORY;
    reduction_expand(model, g->now.u, 1, u);
    enum hobe_status status = find_velocities(whole, u, u + size, err);
    if (!status)
        status = reduction_fit(model, u + size, g->now.v, &left, err);
    if (!status && left > MENDED)
        status = hobe_fail(err, HOBE_BAD_INPUT, ((struct hobe_motion *)whole->motions.item)->where,
                           "the basis of the reduced model has not the velocities of hobe.motion: "
                           "%.1e of them is left; reduce with closed = 3, or with more modes",
                           left);
    hobe_free(u);
    return status;
}

static enum hobe_status set_motions(struct genalpha *g, struct hobe_error *err)
{
    const hobe_model *model = g->s.model;
    if (model_whole(model)->motions.count == 0)
        return HOBE_OK;
    return model->reduction ? fit_velocities(g, err)
                            : find_velocities(model, g->now.u, g->now.v, err);
}

static enum hobe_status take_start(struct run *run, const hobe_solution *from,
                                   struct hobe_error *err)
{
    struct genalpha_state *now = &run->g.now;
    const hobe_model *model = run->g.s.model;
    const size_t size = (size_t)(3 * model->vectors) * sizeof *now->u;
    if (!solution_is_of(from, model))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the state to start from belongs to another "
                         "scene");
    memcpy(now->u, solution_field(from, model, SOLUTION_U), size);
    now->time = from->info.time;
    run->g.s.info.negative = from->info.negative;
    run->g.s.info.limit_load = from->info.limit_load;
    if (!from->v)
        return set_motions(&run->g, err);
    memcpy(now->v, solution_field(from, model, SOLUTION_V), size);
    return HOBE_OK;
}

static enum hobe_status find_start(struct run *run, struct hobe_error *err)
{
    hobe_solution *found = NULL;
    if (run->options.start)
        return take_start(run, run->options.start, err);
    if (!run->options.equilibrium)
        return set_motions(&run->g, err);
    enum hobe_status status = hobe_static(run->g.s.model, &(struct hobe_newton){0}, &found, err);
    if (!status)
        status = take_start(run, found, err);
    hobe_solution_free(found);
    return status;
}

/* Says which constraint is broken most, r on the multipliers, and what that means: a format for its
 * name in quotes and by how much. */
static enum hobe_status fail_broken(const struct genalpha *g, const double *r, const char *format,
                                    struct hobe_error *err)
{
    const hobe_model *model = g->s.model, *whole = model_whole(model);
    const struct tie *worst = NULL;
    double largest = 0;
    char text[400];
    for (size_t i = 0; i < whole->ties.count; i++) {
        const struct tie *tie = model_tie(whole, i);
        const double *broken = r + 3 * model_number(model, tie->multiplier);
        for (int k = 0; k < tie->constraints; k++)
            if (fabs(broken[k]) > largest) {
                largest = fabs(broken[k]);
                worst = tie;
            }
    }
    const char *name = worst && worst->name ? worst->name : "";
    snprintf(text, sizeof text, format, *name ? " \"" : "", name, *name ? "\"" : "", largest);
    return hobe_fail(err, HOBE_BAD_INPUT, worst ? worst->where : NULL, "%s", text);
}

static const char JUMP[] = "a drive with a jump: the joint%s%s%s starts with the speed %g (m/s or "
                           "rad/s) while all is at rest; let it start from rest, or give "
                           "velocities that fit by hobe.motion";
static const char BROKEN[] = "the velocities of the start break the joint%s%s%s by %g (m/s or "
                             "rad/s); give such as fit it by hobe.motion";
static const char APART[] =
    "the start breaks the joint%s%s%s by %g (m or rad): its drive is not at "
    "0 then; let it begin there, or start from \"equilibrium\"";

/* The constraints hold at the start. */
static enum hobe_status check_position(struct genalpha *g, struct hobe_error *err)
{
    const hobe_model *model = g->s.model;
    const struct instant instant = {g->now.time, g->now.v, 0, 0};
    double *r = g->a;
    memset(r, 0, (size_t)(3 * model->vectors) * sizeof *r);
    constraint_add(model, g->now.u, &instant, r, NULL);
    const enum hobe_status status = model_failure(model, err);
    return status || genalpha_violation(g, r) <= CLOSED ? status : fail_broken(g, r, APART, err);
}

/* The state at the start: its velocities fit the constraints, or nearly, and are made to. */
static enum hobe_status begin(struct run *run, struct hobe_error *err)
{
    struct genalpha *g = &run->g;
    const size_t size = (size_t)(3 * g->s.model->vectors) * sizeof(double);
    double *rate = g->a, changed;
    enum hobe_status status = find_start(run, err);
    if (status)
        return status;
    if (!(run->options.to > g->now.time))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the motion must end after its start at t = %g s, got to = %g",
                         g->now.time, run->options.to);
    g->now.begin = g->now.time;
    status = check_position(g, err);
    if (status)
        return status;
    status = genalpha_confine(g, err);
    if (status)
        return status;
    const double speed = genalpha_norm(g, g->now.v);
    memcpy(g->v, g->now.v, size);
    status = settle(g, &changed, err);
    if (status)
        return status;
    if (changed > MENDED * speed + TINY * g->size / (run->options.to - g->now.time)) {
        memcpy(g->now.v, g->v, size);
        settle_rate(g, &g->now, g->s.u, g->force, rate);
        return fail_broken(g, rate, speed == 0 ? JUMP : BROKEN, err);
    }
    account_begin(&run->account, g);
    status = history_keep(run->history, g, &run->account, run->started, err);
    g->s.info.negative = -1; /* counted of equilibria alone */
    g->s.info.limit_load = 0;
    return status;
}

/* ---- steps ---------------------------------------------------------------------------------- */

static void log_step(const struct run *run, const char *note)
{
    const struct genalpha *g = &run->g;
    if (run->options.log)
        run->options.log(run->options.context,
                         &(struct hobe_time_step){.step = run->history->info.steps,
                                                  .time = g->now.time,
                                                  .size = g->now.step,
                                                  .iterations = g->iterations,
                                                  .error = run->error,
                                                  .note = note});
}

/* Sets the step, and what belongs to it where it differs from the last. */
static enum hobe_status choose_step(struct run *run, double target, int kink,
                                    struct hobe_error *err)
{
    struct genalpha *g = &run->g;
    const int first = g->now.step == 0, differs = genalpha_choose_step(g, target, run->wanted);
    double changed;
    run->steady = differs ? 0 : run->steady;
    if (first || !(differs || kink))
        return HOBE_OK;
    const enum hobe_status status = settle(g, &changed, err);
    account_begin(&run->account, g);
    return status;
}

static enum hobe_status give_up(const struct run *run, struct hobe_error *err)
{
    const struct genalpha *g = &run->g;
    const int fixed = !(run->options.accuracy > 0);
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                     "no motion was found beyond t = %g s: in a step of %g s %s; %s", g->now.time,
                     g->now.step, g->reason,
                     fixed ? "take a smaller step, or give an accuracy that chooses the steps"
                           : "smaller steps were given up: is the motion smooth, is a smaller rho "
                             "or a finer mesh needed?");
}

/* Whether the step that was found is good: its accelerations did not leap, and it is accurate. */
static enum outcome judge(struct run *run)
{
    struct genalpha *g = &run->g;
    const double h = g->now.step, accuracy = run->options.accuracy;
    const double after = genalpha_acceleration(g);
    run->error = genalpha_error(g) / g->size;
    g->reason = NULL;
    if (!(h * h * after <= (accuracy > 0 ? accuracy : FAR) * g->size) &&
        !(after <= LEAP * genalpha_norm(g, g->now.w)))
        g->reason = "the accelerations grew to more than three times what they were";
    else if (accuracy > 0 && run->error > accuracy)
        g->reason = "the error was too large";
    return g->reason ? FAILED : CONVERGED;
}

/* What an error says of the next step, relative to the last. */
static double growth(const struct run *run, double error)
{
    return SAFETY * cbrt(run->options.accuracy / fmax(error, 1e-300));
}

/* Tries steps until one is good, and takes it. */
static enum hobe_status advance(struct run *run, double target, struct hobe_error *err)
{
    struct genalpha *g = &run->g;
    for (;;) {
        run->error = NAN;
        enum outcome outcome = genalpha_step(g, err);
        if (outcome == CONVERGED)
            outcome = judge(run);
        if (outcome == ERROR)
            return err ? err->status : HOBE_NO_MEMORY;
        if (outcome == CONVERGED)
            return HOBE_OK;
        log_step(run, g->reason);
        run->history->info.rejected++;
        run->wanted = g->now.step * (run->error > run->options.accuracy
                                         ? fmin(0.8, fmax(SHRINK, growth(run, run->error)))
                                         : SHRINK);
        if (!(run->options.accuracy > 0) || run->wanted < run->options.smallest_step)
            return give_up(run, err);
        const enum hobe_status status = choose_step(run, target, 1, err);
        if (status)
            return status;
    }
}

/* Finds the modes of a projection again where the scene has moved far enough. */
static enum hobe_status follow(struct run *run, struct hobe_error *err)
{
    struct genalpha *g = &run->g;
    const struct hobe_projection *how = run->options.projection;
    double changed;
    if (!how || how->method != HOBE_PROJECTION_COMPONENTS ||
        genalpha_deviation(g) <= (how->deviation > 0 ? how->deviation : DEVIATION))
        return HOBE_OK;
    enum hobe_status status = genalpha_confine(g, err);
    if (!status)
        status = settle(g, &changed, err);
    account_begin(&run->account, g);
    return status;
}

/* Takes the step that was found. */
static void take(struct run *run, double target)
{
    struct genalpha *g = &run->g;
    struct hobe_history_info *info = &run->history->info;
    account_step(&run->account, g);
    genalpha_accept(g);
    if (fabs(target - g->now.time) < 1e-6 * g->now.step)
        g->now.time = target;
    info->steps++;
    info->smallest_step = info->steps == 1 ? g->now.step : fmin(info->smallest_step, g->now.step);
    info->largest_step = fmax(info->largest_step, g->now.step);
    info->largest_error = fmax(info->largest_error, run->error);
    log_step(run, "");
}

/* Lets the step grow where the error allows it: at once, or from the next stop on. */
static enum hobe_status grow(struct run *run, double target, struct hobe_error *err)
{
    const struct genalpha_state *now = &run->g.now;
    const double longest = run->options.step > 0 ? run->options.step : INFINITY;
    run->largest = run->steady++ ? fmax(run->largest, run->error) : run->error;
    const double factor = fmin(MOST_GROWTH, growth(run, run->largest));
    if (!(run->options.accuracy > 0) || run->steady < PATIENCE || factor < GROW ||
        now->step * GROW > longest)
        return HOBE_OK;
    run->wanted = fmin(longest, now->step * factor);
    return now->step * GROW > target - now->time ? HOBE_OK : choose_step(run, target, 0, err);
}

static void find_stops(struct run *run, double t)
{
    const double every = run->options.store, to = run->options.to, near = TINY * run->wanted;
    struct stops *stops = &run->stops;
    stops->kink = drive_next(run->g.s.model, t);
    if (every > 0 && !(stops->store > t))
        stops->store = stops->begin + every * floor((t - stops->begin) / every + 1 + TINY);
    stops->target = fmin(to, fmin(stops->store, stops->kink));
    stops->keep = fmin(to, stops->store) <= stops->target + near;
    if (stops->kink <= stops->target + near)
        stops->target = stops->kink;
    else if (to <= stops->target + near)
        stops->target = to;
}

/* Steps up to the next stop. */
static enum hobe_status move_to_stop(struct run *run, struct hobe_error *err)
{
    const double target = run->stops.target;
    enum hobe_status status = HOBE_OK;
    while (!status && run->g.now.time < target) {
        status = advance(run, target, err);
        if (status)
            return status;
        take(run, target);
        if (!(run->options.store > 0) || (run->stops.keep && run->g.now.time == target))
            status = history_keep(run->history, &run->g, &run->account, run->started, err);
        if (!status)
            status = grow(run, target, err);
        if (!status)
            status = follow(run, err);
        if (!status && run->history->info.steps % MARKED == 0)
            status = checkpoint_save(run, err);
    }
    return status;
}

static enum hobe_status move(struct run *run, struct hobe_error *err)
{
    const double *t = &run->g.now.time;
    enum hobe_status status = move_to_stop(run, err); /* what a motion taken up had in mind */
    while (!status && *t < run->options.to) {
        const int kink = *t == run->stops.kink;
        find_stops(run, *t);
        status = choose_step(run, run->stops.target, kink, err);
        if (!status)
            status = move_to_stop(run, err);
    }
    return status;
}

/* ---- the verb ------------------------------------------------------------------------------- */

static enum hobe_status check_options(const struct hobe_dynamic *o, struct hobe_error *err)
{
    if (!(o->step > 0) && !(o->accuracy > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a motion needs step (s), or accuracy, relative to the scene's size, that "
                         "chooses the steps");
    if (!isfinite(o->to) || !isfinite(o->step) || !(o->rho <= 1))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a motion needs a finite end and step, and rho up to 1, got %g, %g and %g",
                         o->to, o->step, o->rho);
    if (o->projection && o->quasi_static)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a quasi-static motion takes no projection; leave one of them out");
    if (o->projection && o->journal)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a motion with a projection cannot be taken up from a journal; leave one "
                         "of them out");
    return HOBE_OK;
}

static void set_defaults(struct run *run)
{
    struct hobe_dynamic *o = &run->options;
    const struct genalpha *g = &run->g;
    const double t = g->now.time, time = o->to - t, w = genalpha_norm(g, g->now.w);
    if (!(o->smallest_step > 0))
        o->smallest_step = SMALLEST_STEP * time;
    run->stops = (struct stops){t, o->store > 0 ? t : INFINITY, t, t, 0};
    run->wanted = o->step > 0 ? o->step : FIRST_STEP * time;
    if (o->accuracy > 0 && w > 0)
        run->wanted = fmin(run->wanted, sqrt(o->accuracy * g->size / w));
}

static enum hobe_status integrate(struct run *run, hobe_model *model, struct hobe_error *err)
{
    int resumed;
    enum hobe_status status = genalpha_open(&run->g, model, &run->options, err);
    if (!status)
        status = account_open(&run->account, model, err);
    if (status)
        return status;
    status = checkpoint_load(run, &resumed, err);
    if (!status && !resumed)
        status = begin(run, err);
    if (!status && !resumed)
        set_defaults(run);
    if (!status)
        status = move(run, err);
    run->history->info.time = run->g.now.time;
    run->history->info.iterations = run->g.s.info.iterations;
    run->history->info.projected = run->g.s.space.count;
    run->history->info.linearisations = run->g.s.info.linearisations;
    run->history->info.factorisations = run->g.s.info.factorisations;
    return status;
}

static enum hobe_status run_all(struct run *run, hobe_model *model, struct hobe_error *err)
{
    run->started = hobe_seconds();
    run->history = hobe_alloc(1, sizeof *run->history, err);
    if (!run->history)
        return HOBE_NO_MEMORY;
    const enum hobe_status status = run->options.quasi_static
                                        ? quasi_static(model, &run->options, run->history, err)
                                        : integrate(run, model, err);
    run->history->info.seconds = hobe_seconds() - run->started;
    return status;
}

enum hobe_status hobe_dynamic(hobe_model *model, const struct hobe_dynamic *options,
                              hobe_history **history, struct hobe_error *err)
{
    struct run run = {.options = *options};
    *history = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (!status)
        status = check_options(options, err);
    if (!status)
        status = mass_check(model, "motion in time", NULL, err);
    if (!status && model->reduction)
        status = reduction_check_motion(model, err);
    if (status)
        return status;
    status = run_all(&run, model, err);
    if (status)
        hobe_history_free(run.history);
    else
        *history = run.history;
    account_close(&run.account);
    genalpha_close(&run.g);
    return status;
}
