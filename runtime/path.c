/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Equilibrium paths by arc length (Riks 1979): F(u) = lambda Q(u) with the load factor lambda
 * unknown, so that limit points, where the load turns, are points like others.
 *
 * A step of length s goes along the path's tangent (v, kappa), |(v, kappa)| = 1, and is corrected
 * in the plane normal to it.  Two solves with the same factors of K give each correction: K a = -r
 * and K q = Q, du = a + dlambda q, and the plane gives dlambda.  The norm is u'W u/c + lambda^2,
 * W = D^-2 the diagonal of the stiffness at the reference (multipliers do not count) and c the
 * q'W q there.  The end of a path is one more plane: at a load, or at a displacement.
 *
 * The next tangent is +-(q, 1) on the side of the last one: it goes on through limit points, and
 * straight over bifurcations.  Both show in the number of negative eigenvalues.
 *
 * By series (series.h) a step goes along the path itself, as far as its power series is good, and
 * at most to the end of the path or past one limit point.  The same plane and iteration correct
 * what the series has left open. */
#include "drive.h"
#include "load.h"
#include "path_parts.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

enum { DEFAULT_STEPS = 200, EASY_ITERATIONS = 6 };

static const double DEFAULT_ARC = 0.05, DEFAULT_SMALLEST = 1e-4, DEFAULT_TO = 1;

/* The tangent may turn by acos of this in a step: 45 degrees. */
static const double LEAST_COSINE = 0.7;

/* ---- steps ----------------------------------------------------------------------------------- */

static enum hobe_status keep_point(struct follower *f, struct hobe_error *err)
{
    f->s.info.load = f->lambda;
    f->s.info.steps = (int)f->path->points.count + 1;
    hobe_solution **to = list_append(&f->path->points, sizeof *to, err);
    if (!to)
        return HOBE_NO_MEMORY;
    *to = solver_take(&f->s, f->started, err);
    if (!*to)
        f->path->points.count--;
    return *to ? HOBE_OK : HOBE_NO_MEMORY;
}

/* Moves along the tangent. */
static void predict(struct follower *f, double arc)
{
    solver_move(&f->s, f->v, arc);
    f->lambda += arc * f->kappa;
    path_set_plane(f);
}

/* Where the step from the last state passes an end of the path: the point on it. */
static enum outcome stop_at(struct follower *f, const struct plane *end, struct hobe_error *err)
{
    struct solver *s = &f->s;
    const double before = path_distance(f, end, s->start, f->last_lambda);
    const double after = path_distance(f, end, s->u, f->lambda);
    if (!(before * after < 0 || after == 0))
        return GOING_ON;
    const double share = before / (before - after);
    for (long i = 0; i < 3 * s->model->vectors; i++)
        s->u[i] = s->start[i] + share * (s->u[i] - s->start[i]);
    f->lambda = f->last_lambda + share * (f->lambda - f->last_lambda);
    return path_iterate(f, end, err);
}

/* Looks for the ends of the path: CONVERGED at one of them. */
static enum outcome stop(struct follower *f, struct hobe_error *err)
{
    enum outcome outcome = GOING_ON;
    if (f->reach.c) {
        outcome = stop_at(f, &f->reach, err);
        f->path->info.end = HOBE_PATH_DISPLACEMENT;
    }
    if (outcome == GOING_ON) {
        outcome = stop_at(f, &f->load, err);
        f->path->info.end = HOBE_PATH_LOAD;
    }
    return outcome;
}

/* ---- one step -------------------------------------------------------------------------------- */

/* Makes v, kappa the tangent of the current point, on the side of the last one; FAILED where that
 * would turn it too far. */
static enum outcome turn_tangent(struct follower *f)
{
    const double length = path_length(f, f->q, 1);
    double cosine = f->kappa;
    for (long i = 0; i < f->n; i++)
        cosine += f->W[i] * f->q[i] * f->v[i];
    cosine /= length;
    if (fabs(cosine) < LEAST_COSINE) {
        solver_log(&f->s, "the path turns too far");
        return FAILED;
    }
    f->kappa = copysign(1 / length, cosine);
    for (long i = 0; i < f->n; i++)
        f->v[i] = f->kappa * f->q[i];
    return CONVERGED;
}

static enum outcome step_by_series(struct follower *f, double arc, int *ended,
                                   struct hobe_error *err)
{
    const struct plane *plane = path_predict_by_series(f, arc);
    *ended = plane != &f->step;
    return path_iterate(f, plane, err);
}

static enum outcome step_along_tangent(struct follower *f, double arc, int *ended,
                                       struct hobe_error *err)
{
    predict(f, arc);
    const enum outcome outcome = path_iterate(f, &f->step, err);
    const enum outcome stopped = outcome == CONVERGED ? stop(f, err) : outcome;
    *ended = stopped == CONVERGED && outcome == CONVERGED;
    return stopped == FAILED || stopped == ERROR ? stopped : outcome;
}

/* One step of a length from the last point; FAILED leaves that in place.  *ended where it came to
 * an end of the path. */
static enum outcome attempt(struct follower *f, double arc, int *ended, struct hobe_error *err)
{
    struct solver *s = &f->s;
    const int negative = s->info.negative;
    const double kappa = f->kappa;
    enum outcome outcome = path_by_series(f) ? step_by_series(f, arc, ended, err)
                                             : step_along_tangent(f, arc, ended, err);
    if (outcome == CONVERGED)
        outcome = path_count_and_factor(f, err);
    if (outcome == CONVERGED)
        outcome = path_find_correction(f, f->plane, err) ? ERROR : solver_measure(s);
    if (outcome == CONVERGED && !path_by_series(f)) /* which begin where the tangent was factored */
        path_take_correction(f);
    if (outcome == CONVERGED)
        outcome = turn_tangent(f);
    if (outcome == CONVERGED)
        return keep_point(f, err) || path_find_events(f, negative, kappa, err) ? ERROR : CONVERGED;
    if (outcome == FAILED) {
        s->reason = s->now.note;
        s->info.negative = negative;
        f->lambda = f->last_lambda;
        f->kappa = kappa;
        memcpy(s->u, s->start, (size_t)(3 * s->model->vectors) * sizeof *s->u);
    }
    return outcome;
}

static enum hobe_status give_up(const struct follower *f, double arc, struct hobe_error *err)
{
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                     "the path could not be followed beyond %.6g of the load, after %d points (%s, "
                     "residual %.2g); try a smaller arc or smallest_arc (the last one was %.2g), "
                     "or a finer mesh",
                     f->lambda, (int)f->path->points.count, f->s.reason, f->s.now.residual, arc);
}

static enum hobe_status run_steps(struct follower *f, struct hobe_error *err)
{
    struct solver *s = &f->s;
    double longest, arc;
    int ended = 0;
    enum hobe_status status = path_expand(f, &longest, err);
    arc = longest;
    while (!status && !ended && (int)f->path->points.count < f->options.steps) {
        const int before = s->info.iterations;
        s->now.step = (int)f->path->points.count + 1;
        f->last_lambda = f->lambda;
        memcpy(s->start, s->u, (size_t)(3 * s->model->vectors) * sizeof *s->u);
        const enum outcome outcome = attempt(f, arc, &ended, err);
        if (outcome == ERROR)
            return err ? err->status : HOBE_NO_MEMORY;
        if (outcome == FAILED) {
            if (arc / 2 < f->options.smallest_arc * longest)
                return give_up(f, arc, err);
            arc /= 2;
            ended = 0;
            s->info.cutbacks++;
            solver_log(s, "step cut back");
            continue;
        }
        if (!ended)
            status = path_expand(f, &longest, err);
        if (path_by_series(f) || s->info.iterations - before <= EASY_ITERATIONS)
            arc = fmin(path_by_series(f) ? longest : 2 * arc, longest);
    }
    if (!ended)
        f->path->info.end = HOBE_PATH_STEPS;
    return status;
}

/* ---- the beginning --------------------------------------------------------------------------- */

/* The tangent and the norm at the reference. */
static enum hobe_status start(struct follower *f, struct hobe_error *err)
{
    struct solver *s = &f->s;
    const hobe_model *model = s->model;
    double c = 0;
    const struct hobe_joint *driven = drive_joint(model);
    if (driven)
        return hobe_fail(err, HOBE_BAD_INPUT, driven->where,
                         "a path follows loads and cannot follow a driven joint; use hobe.static "
                         "with method = \"newton\"");
    if (!(s->load_norm > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "a path needs loads, and the scene has none");
    const enum outcome outcome = path_count_and_factor(f, err);
    if (outcome == FAILED)
        return solver_name_free(s, err);
    if (outcome == ERROR || path_solve_load(f, err))
        return err ? err->status : HOBE_NO_MEMORY;
    for (long v = 0; v < model->beam_vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const long i = 3 * model->unknown[v] + a;
            f->W[i] = 1 / (s->scale[i] * s->scale[i]);
        }
    for (long i = 0; i < f->n; i++)
        c += f->W[i] * f->q[i] * f->q[i];
    for (long i = 0; i < f->n; i++)
        f->W[i] /= c;
    f->kappa = copysign(1 / path_length(f, f->q, 1), f->options.to);
    for (long i = 0; i < f->n; i++)
        f->v[i] = f->kappa * f->q[i];
    return HOBE_OK;
}

/* The plane where a displacement ends the path: the functional of a force of that direction. */
static enum hobe_status open_reach(struct follower *f, struct hobe_error *err)
{
    const struct hobe_reach *reach = &f->options.reach;
    const double *value = reach->value;
    const double length = length3(value);
    if (!reach->beam)
        return HOBE_OK;
    if (!(length > 0) || !isfinite(length) || !(reach->at >= 0 && reach->at <= 1))
        return hobe_fail(err, HOBE_BAD_INPUT, reach->where,
                         "reach must be a displacement other than {0, 0, 0} at a place from 0 to "
                         "1, got {%g, %g, %g} at %g",
                         value[0], value[1], value[2], reach->at);
    f->reach.c = hobe_alloc((size_t)f->n, sizeof *f->reach.c, err);
    if (!f->reach.c)
        return HOBE_NO_MEMORY;
    const double unit[3] = {value[0] / length, value[1] / length, value[2] / length};
    f->reach.value = length;
    memset(f->force, 0, (size_t)(3 * f->s.model->vectors) * sizeof *f->force);
    const enum hobe_status status =
        load_at(f->s.model, reach->beam, reach->at, unit, reach->where, f->force, err);
    solver_restrict(f->s.model, f->force, f->reach.c);
    return status;
}

static enum hobe_status open_follower(struct follower *f, hobe_model *model, struct hobe_error *err)
{
    const size_t n = (size_t)(3 * model->unknowns);
    enum hobe_status status = solver_open(&f->s, model, &f->options.newton, err);
    if (status)
        return status;
    f->n = (long)n;
    f->W = hobe_alloc(n, sizeof *f->W, err);
    f->q = hobe_alloc(n, sizeof *f->q, err);
    f->v = hobe_alloc(n, sizeof *f->v, err);
    f->step.c = hobe_alloc(n, sizeof *f->step.c, err);
    f->force = hobe_alloc((size_t)(3 * model->vectors), sizeof *f->force, err);
    f->path = hobe_alloc(1, sizeof *f->path, err);
    if (!f->W || !f->q || !f->v || !f->step.c || !f->force || !f->path)
        return HOBE_NO_MEMORY;
    f->symmetric = !load_follower(model);
    f->load = (struct plane){NULL, 1, f->options.to};
    status = open_reach(f, err);
    return status || !path_by_series(f) ? status : series_open(&f->series, &f->s, err);
}

static void close_follower(struct follower *f)
{
    solver_close(&f->s);
    hobe_free(f->W);
    hobe_free(f->q);
    hobe_free(f->v);
    hobe_free(f->step.c);
    hobe_free(f->reach.c);
    hobe_free(f->force);
    series_close(&f->series);
}

static void set_defaults(struct hobe_path_options *o)
{
    if (o->steps <= 0)
        o->steps = DEFAULT_STEPS;
    if (!(o->arc > 0))
        o->arc = o->newton.method == HOBE_METHOD_SERIES ? INFINITY : DEFAULT_ARC;
    if (!(o->smallest_arc > 0))
        o->smallest_arc = DEFAULT_SMALLEST;
    if (o->to == 0)
        o->to = DEFAULT_TO;
}

enum hobe_status hobe_path_follow(hobe_model *model, const struct hobe_path_options *options,
                                  hobe_path **path, struct hobe_error *err)
{
    struct follower f = {.options = *options};
    *path = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (!status)
        status = model_check_held(model, err);
    if (!status && options->newton.projection)
        status = hobe_fail(err, HOBE_BAD_INPUT, NULL,
                           "a projection is for load steps by Newton's method and for motions, not "
                           "for paths and series");
    if (status)
        return status;
    f.started = hobe_seconds();
    set_defaults(&f.options);
    status = open_follower(&f, model, err);
    if (!status)
        status = start(&f, err);
    if (!status)
        status = run_steps(&f, err);
    if (status)
        hobe_path_free(f.path);
    else {
        *path = f.path;
        f.path->info.points = (int)f.path->points.count;
        f.path->info.events = (int)f.path->events.count;
        f.path->info.iterations = f.s.info.iterations;
        f.path->info.cutbacks = f.s.info.cutbacks;
        f.path->info.factorisations = f.s.info.factorisations;
        f.path->info.seconds = hobe_seconds() - f.started;
    }
    close_follower(&f);
    return status;
}
