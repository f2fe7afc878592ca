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
#include "inertia.h"
#include "load.h"
#include "newton.h"
#include "series.h"
#include "solution.h"
#include "taylor.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEFAULT_STEPS = 200, EASY_ITERATIONS = 6 };

static const double DEFAULT_ARC = 0.05, DEFAULT_SMALLEST = 1e-4, DEFAULT_TO = 1;

/* The tangent may turn by acos of this in a step: 45 degrees. */
static const double LEAST_COSINE = 0.7;

/* The last term of a series over its first, where it is left. */
static const double LAST_TERM = 1e-6;

/* Parts of a step by series in which a root of a polynomial is looked for by its sign. */
enum { PARTS = 64 };

struct hobe_path {
    struct hobe_path_info info;
    struct list points, events; /* hobe_solution *, struct hobe_path_event */
};

/* The plane c.u + kappa lambda = value, c over the unknowns. */
struct plane {
    double *c, kappa, value;
};

struct follower {
    struct solver s;
    struct hobe_path_options options;
    hobe_path *path;
    long n;                     /* unknowns */
    double *W;                  /* [n] W/c */
    double *q;                  /* [n] K^-1 Q */
    double *v, kappa;           /* [n] the tangent at the last point */
    double *force;              /* [vectors][3] Q */
    double lambda, last_lambda; /* now, and at the last point, whose state is s.start */
    double mend;                /* of lambda, with s.x */
    struct plane step, reach, load;
    const struct plane *plane; /* that of the last iteration */
    struct series series;
    int symmetric, turned; /* no follower forces; the load turned on the last step */
    double extreme;        /* the load there */
    double started;
};

static int by_series(const struct follower *f)
{
    return f->options.newton.method == HOBE_METHOD_SERIES;
}

/* c.u over the unknowns */
static double along(const struct follower *f, const double *c, const double *u)
{
    const hobe_model *model = f->s.model;
    double sum = 0;
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++)
            sum += c[3 * model->unknown[v] + a] * u[3 * v + a];
    return sum;
}

static double distance(const struct follower *f, const struct plane *p, const double *u,
                       double lambda)
{
    return (p->c ? along(f, p->c, u) : 0) + p->kappa * lambda - p->value;
}

/* ---- one point ------------------------------------------------------------------------------- */

/* f->q = K^-1 Q by the last factors. */
static enum hobe_status solve_load(struct follower *f, struct hobe_error *err)
{
    memset(f->force, 0, (size_t)(3 * f->s.model->vectors) * sizeof *f->force);
    load_subtract(f->s.model, f->s.u, &f->s.motion.instant, -1, f->force, NULL);
    return solver_solve(&f->s, f->force, 1, f->q, err);
}

/* s.x and mend: the correction to where the linearised equations and the plane meet, by the last
 * factors. */
static enum hobe_status find_correction(struct follower *f, const struct plane *plane,
                                        struct hobe_error *err)
{
    struct solver *s = &f->s;
    enum hobe_status status = solver_solve(s, s->r, -1, s->x, err);
    if (!status)
        status = solve_load(f, err);
    if (status)
        return status;
    const double c_x = plane->c ? dot(f->n, plane->c, s->x) : 0;
    const double c_q = plane->c ? dot(f->n, plane->c, f->q) : 0;
    f->mend = -(distance(f, plane, s->u, f->lambda) + c_x) / (c_q + plane->kappa);
    for (long i = 0; i < f->n; i++)
        s->x[i] += f->mend * f->q[i];
    return HOBE_OK;
}

static void take_correction(struct follower *f)
{
    solver_move(&f->s, f->s.x, 1);
    f->lambda += f->mend;
}

static enum outcome correct(struct follower *f, const struct plane *plane, struct hobe_error *err)
{
    struct solver *s = &f->s;
    const enum outcome outcome = solver_factor(s, err);
    if (outcome != CONVERGED)
        return outcome;
    if (find_correction(f, plane, err))
        return ERROR;
    take_correction(f);
    s->info.iterations++;
    return CONVERGED;
}

/* Newton from the current state to the equilibrium in a plane. */
static enum outcome iterate(struct follower *f, const struct plane *plane, struct hobe_error *err)
{
    struct solver *s = &f->s;
    double last_norm = INFINITY;
    f->plane = plane;
    s->now.line = 1;
    s->now.energy = 0;
    for (s->now.iteration = 0; s->now.iteration <= s->options.max_iterations; s->now.iteration++) {
        solver_evaluate(s, f->lambda, s->now.iteration ? NEXT_TANGENT : TRUE_TANGENT);
        const double norm = solver_norm(s, s->r, 1);
        s->now.load = f->lambda;
        if (model_failure(s->model, err))
            return ERROR;
        enum outcome outcome = solver_judge(s, norm, last_norm);
        if (outcome == CONVERGED && s->now.iteration > 0)
            return solver_check_volume(s, err);
        if (outcome == FAILED)
            return FAILED;
        last_norm = norm;
        outcome = correct(f, plane, err);
        if (outcome != CONVERGED)
            return outcome;
    }
    solver_log(s, "too many iterations");
    return FAILED;
}

/* Negative eigenvalues of the tangent at the current state, and its factors. */
static enum outcome count_and_factor(struct follower *f, struct hobe_error *err)
{
    struct solver *s = &f->s;
    long negative = -1;
    solver_evaluate(s, f->lambda, TRUE_TANGENT);
    const enum outcome outcome = solver_factor(s, err);
    if (outcome == CONVERGED && f->symmetric && solver_negative(s, &negative, err))
        return ERROR;
    s->info.negative = (int)negative;
    return outcome;
}

/* |(v, kappa)| */
static double length_of(const struct follower *f, const double *v, double kappa)
{
    double sum = kappa * kappa;
    for (long i = 0; i < f->n; i++)
        sum += f->W[i] * v[i] * v[i];
    return sqrt(sum);
}

/* Makes v, kappa the tangent of the current point, on the side of the last one; FAILED where that
 * would turn it too far. */
static enum outcome turn_tangent(struct follower *f)
{
    const double length = length_of(f, f->q, 1);
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

/* ---- events ---------------------------------------------------------------------------------- */

/* The extreme load of the cubic lambda(s), 0 <= s <= h, with the given ends and slopes. */
static double extreme_load(const double load[2], const double slope[2], double h)
{
    const double rise = (load[1] - load[0]) / h;
    const double c = slope[0], b = (3 * rise - 2 * slope[0] - slope[1]) / h;
    const double a = (slope[0] + slope[1] - 2 * rise) / (h * h);
    /* 3 a s^2 + 2 b s + c = 0: the root between 0 and h, where the slope has both signs */
    const double root = sqrt(fmax(0, b * b - 3 * a * c));
    const double s = c / (c > 0 ? root - b : -root - b);
    return load[0] + s * (c + s * (b + s * a));
}

/* How far the current point is from the last one. */
static double travelled(const struct follower *f)
{
    const hobe_model *model = f->s.model;
    double sum = (f->lambda - f->last_lambda) * (f->lambda - f->last_lambda);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const double du = f->s.u[3 * v + a] - f->s.start[3 * v + a];
            sum += f->W[3 * model->unknown[v] + a] * du * du;
        }
    return sqrt(sum);
}

static enum hobe_status add_event(struct follower *f, struct hobe_path_event event,
                                  struct hobe_error *err)
{
    struct hobe_path_event *to = list_append(&f->path->events, sizeof event, err);
    if (!to)
        return HOBE_NO_MEMORY;
    *to = event;
    return HOBE_OK;
}

/* What happened between the last point and this one.  A limit point makes one eigenvalue change
 * its sign; those beyond it belong to bifurcations. */
static enum hobe_status find_events(struct follower *f, int before_negative, double before_kappa,
                                    struct hobe_error *err)
{
    const int known = before_negative >= 0 && f->s.info.negative >= 0;
    const int change = known ? f->s.info.negative - before_negative : 0;
    struct hobe_path_event event = {.before = (int)f->path->points.count - 2,
                                    .change = change,
                                    .load = {f->last_lambda, f->lambda}};
    const double slope[2] = {before_kappa, f->kappa};
    f->turned = before_kappa * f->kappa < 0;
    if (f->turned) {
        event.extreme = by_series(f) ? f->extreme : extreme_load(event.load, slope, travelled(f));
        if (add_event(f, event, err))
            return HOBE_NO_MEMORY;
    }
    if (known && (f->turned ? change != 1 && change != -1 : change != 0)) {
        event.bifurcation = 1;
        event.extreme = (event.load[0] + event.load[1]) / 2;
        return add_event(f, event, err);
    }
    return HOBE_OK;
}

void hobe_path_event_text(const struct hobe_path_event *event, char *text, size_t size)
{
    char change[80] = "";
    if (event->change)
        snprintf(change, sizeof change, ": %d negative eigenvalue%s %s", abs(event->change),
                 abs(event->change) == 1 ? "" : "s", event->change > 0 ? "more" : "less");
    if (event->bifurcation)
        snprintf(text, size,
                 "bifurcation between points %d and %d, load factors %.6g and %.6g%s; the path "
                 "goes on straight, another one crosses",
                 event->before + 1, event->before + 2, event->load[0], event->load[1], change);
    else
        snprintf(text, size, "limit point between points %d and %d, load factor %.6g%s",
                 event->before + 1, event->before + 2, event->extreme, change);
}

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

/* f->step = the plane normal to the tangent at the current state. */
static void set_plane(struct follower *f)
{
    struct plane *p = &f->step;
    for (long i = 0; i < f->n; i++)
        p->c[i] = f->W[i] * f->v[i];
    p->kappa = f->kappa;
    p->value = 0;
    p->value = distance(f, p, f->s.u, f->lambda);
}

/* Moves along the tangent. */
static void predict(struct follower *f, double arc)
{
    solver_move(&f->s, f->v, arc);
    f->lambda += arc * f->kappa;
    set_plane(f);
}

/* Where the step from the last state passes an end of the path: the point on it. */
static enum outcome stop_at(struct follower *f, const struct plane *end, struct hobe_error *err)
{
    struct solver *s = &f->s;
    const double before = distance(f, end, s->start, f->last_lambda);
    const double after = distance(f, end, s->u, f->lambda);
    if (!(before * after < 0 || after == 0))
        return GOING_ON;
    const double share = before / (before - after);
    for (long i = 0; i < 3 * s->model->vectors; i++)
        s->u[i] = s->start[i] + share * (s->u[i] - s->start[i]);
    f->lambda = f->last_lambda + share * (f->lambda - f->last_lambda);
    return iterate(f, end, err);
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

/* ---- steps by series ------------------------------------------------------------------------- */

/* The coefficients of the distance from a plane. */
static void distance_series(const struct follower *f, const struct plane *p, taylor sum)
{
    for (int k = 0; k <= SERIES_ORDER; k++)
        sum[k] = distance(f, p, f->series.u[k], f->series.lambda[k]) + (k > 0 ? p->value : 0);
}

static double value_of(const taylor p, double a)
{
    double sum = p[SERIES_ORDER];
    for (int k = SERIES_ORDER - 1; k >= 0; k--)
        sum = sum * a + p[k];
    return sum;
}

/* The first a in (from, to] where p changes its sign; 0 where it does not. */
static double first_root(const taylor p, double from, double to)
{
    for (int part = 0; part < PARTS; part++) {
        double low = from + (to - from) * part / PARTS;
        double high = from + (to - from) * (part + 1) / PARTS;
        const double sign = value_of(p, low);
        if (sign == 0 || !(sign * value_of(p, high) <= 0))
            continue;
        for (int halving = 0; halving < DBL_MANT_DIG; halving++) {
            const double middle = (low + high) / 2;
            if (sign * value_of(p, middle) > 0)
                low = middle;
            else
                high = middle;
        }
        return high;
    }
    return 0;
}

/* How far to go, at most `arc`: past one limit point, whose load it notes, and not on to a second
 * one. */
static double pass_limit(struct follower *f, double arc)
{
    const double *lambda = f->series.lambda;
    taylor slope = {0};
    for (int k = 1; k <= SERIES_ORDER; k++)
        slope[k - 1] = k * lambda[k];
    const double first = first_root(slope, 0, arc);
    if (first == 0)
        return arc;
    f->extreme = value_of(lambda, first);
    const double second = first_root(slope, first + (arc - first) / PARTS, arc);
    return second > 0 ? (first + second) / 2 : arc;
}

/* The root of an end of the path within `arc`, where that becomes the plane; else arc. */
static double shorten(const struct follower *f, const struct plane *end, double arc,
                      const struct plane **plane)
{
    taylor to;
    distance_series(f, end, to);
    const double root = first_root(to, 0, arc);
    if (root > 0)
        *plane = end;
    return root > 0 ? root : arc;
}

/* Moves along the series; the plane normal to it there, or that of an end of the path. */
static const struct plane *predict_by_series(struct follower *f, double arc)
{
    const struct plane *plane = &f->step;
    arc = pass_limit(f, arc);
    if (f->reach.c)
        arc = shorten(f, &f->reach, arc, &plane);
    arc = shorten(f, &f->load, arc, &plane);
    f->path->info.end = plane == &f->load ? HOBE_PATH_LOAD : HOBE_PATH_DISPLACEMENT;
    f->lambda = series_move(&f->series, arc);
    f->kappa = series_slope(&f->series, arc, f->v);
    const double length = length_of(f, f->v, f->kappa);
    f->kappa /= length;
    for (long i = 0; i < f->n; i++)
        f->v[i] /= length;
    set_plane(f);
    return plane;
}

/* ---- one step -------------------------------------------------------------------------------- */

static enum outcome step_by_series(struct follower *f, double arc, int *ended,
                                   struct hobe_error *err)
{
    const struct plane *plane = predict_by_series(f, arc);
    *ended = plane != &f->step;
    return iterate(f, plane, err);
}

static enum outcome step_along_tangent(struct follower *f, double arc, int *ended,
                                       struct hobe_error *err)
{
    predict(f, arc);
    const enum outcome outcome = iterate(f, &f->step, err);
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
    enum outcome outcome =
        by_series(f) ? step_by_series(f, arc, ended, err) : step_along_tangent(f, arc, ended, err);
    if (outcome == CONVERGED)
        outcome = count_and_factor(f, err);
    if (outcome == CONVERGED)
        outcome = find_correction(f, f->plane, err) ? ERROR : solver_measure(s);
    if (outcome == CONVERGED && !by_series(f)) /* which begin where the tangent was factored */
        take_correction(f);
    if (outcome == CONVERGED)
        outcome = turn_tangent(f);
    if (outcome == CONVERGED)
        return keep_point(f, err) || find_events(f, negative, kappa, err) ? ERROR : CONVERGED;
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

/* The longest step from a new point; by series, how far that is good. */
static enum hobe_status expand(struct follower *f, double *longest, struct hobe_error *err)
{
    *longest = f->options.arc;
    if (!by_series(f))
        return HOBE_OK;
    for (long i = 0; i < f->n; i++)
        f->step.c[i] = f->W[i] * f->v[i];
    const enum hobe_status status = series_expand(&f->series, f->lambda, f->step.c, f->kappa, err);
    if (!status)
        *longest = fmin(*longest, series_range(&f->series, LAST_TERM));
    return status;
}

static enum hobe_status run_steps(struct follower *f, struct hobe_error *err)
{
    struct solver *s = &f->s;
    double longest, arc;
    int ended = 0;
    enum hobe_status status = expand(f, &longest, err);
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
            status = expand(f, &longest, err);
        if (by_series(f) || s->info.iterations - before <= EASY_ITERATIONS)
            arc = fmin(by_series(f) ? longest : 2 * arc, longest);
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
    const enum outcome outcome = count_and_factor(f, err);
    if (outcome == FAILED)
        return solver_name_free(s, err);
    if (outcome == ERROR || solve_load(f, err))
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
    f->kappa = copysign(1 / length_of(f, f->q, 1), f->options.to);
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
    return status || !by_series(f) ? status : series_open(&f->series, &f->s, err);
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

/* ---- what is given --------------------------------------------------------------------------- */

static hobe_solution **point(const hobe_path *path, int i)
{
    return i >= 0 && (size_t)i < path->points.count ? (hobe_solution **)path->points.item + i
                                                    : NULL;
}

void hobe_path_free(hobe_path *path)
{
    if (!path)
        return;
    for (int i = 0; point(path, i); i++)
        hobe_solution_free(*point(path, i));
    hobe_free(path->points.item);
    hobe_free(path->events.item);
    hobe_free(path);
}

void hobe_path_info(const hobe_path *path, struct hobe_path_info *info)
{
    *info = path->info;
}

const hobe_solution *hobe_path_point(const hobe_path *path, int i)
{
    return point(path, i) ? *point(path, i) : NULL;
}

hobe_solution *hobe_path_take(hobe_path *path, int i)
{
    hobe_solution **at = point(path, i), *taken = at ? *at : NULL;
    if (at)
        *at = NULL;
    return taken;
}

const struct hobe_path_event *hobe_path_event(const hobe_path *path, int i)
{
    return i >= 0 && (size_t)i < path->events.count
               ? (const struct hobe_path_event *)path->events.item + i
               : NULL;
}
