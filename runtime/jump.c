/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Jumps over limit points: suspected by how Newton's iteration goes, verified by small steps. */
#include "drive.h"
#include "newton.h"

#include <math.h>
#include <string.h>

/* What a step moves may differ from the path's tangent by this share, where limit points are (half
 * of what leads to one is a parabola's): a turn by some 1 rad. */
static const double PROPORTION = 0.5;

/* ... at which the next step is aimed, and how much longer than the last one it may be. */
static const double AIM = 0.45, LONGER = 2;

/* Shares of the suspected step to begin with, and iterations that a continuous step needs, to what
 * share of its load. */
static const double LARGEST = 0.25, SMALLEST = 1e-3, TOLERANCE = 1e-3;
enum { ITERATIONS = 8 };

/* A step this small, of the load reached, may cross a bifurcation, where pivots change their sign.
 */
static const double CROSSING = 1e-3;

/* Steps this small are none: of the load reached and of that of the suspected step. */
static const double NO_STEP = 1e-6, NO_SHARE = 1e-4, LEAST_STEP = 1e-12;

enum hobe_status jump_open(struct solver *s, struct hobe_error *err)
{
    s->jump.turn = INFINITY;
    s->jump.driven = drive_joint(s->model) != NULL;
    s->jump.first = hobe_alloc((size_t)(3 * s->model->unknowns), sizeof *s->jump.first, err);
    return s->jump.first ? HOBE_OK : HOBE_NO_MEMORY;
}

void jump_close(struct solver *s)
{
    hobe_free(s->jump.first);
}

/* ---- suspicion ------------------------------------------------------------------------------- */

/* first . r */
static double work_along(const struct solver *s)
{
    const hobe_model *model = s->model;
    double sum = 0;
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++)
            sum += s->jump.first[3 * model->unknown[v] + a] * s->r[3 * v + a];
    return sum;
}

/* Reads the energy along the first correction from residuals half-way and at its end. */
static void watch_energy(struct solver *s)
{
    const size_t size = (size_t)(3 * s->model->vectors) * sizeof *s->u;
    struct jump *jump = &s->jump;
    if (s->now.iteration == 0) {
        jump->turn = INFINITY;
        jump->work[0] = work_along(s);
        solver_move(s, s->x, 0.5);
        solver_evaluate(s, s->factor, NO_TANGENT);
        jump->work[1] = work_along(s);
        memcpy(s->u, s->start, size);
    } else if (s->now.iteration == 1) {
        const double k = -jump->work[0], a = 8 * jump->work[1] + 4 * k - work_along(s);
        jump->turn = k > 0 && a < 0 ? -k / (2 * a) : INFINITY;
        jump->suspected |= jump->turn < 1;
    }
}

void jump_watch(struct solver *s)
{
    long negative = 0;
    struct hobe_error err; /* there is none, of fronts */
    if (s->now.iteration == 0)
        memcpy(s->jump.first, s->x, (size_t)(3 * s->model->unknowns) * sizeof *s->x);
    if (!s->jump.verifying && !s->jump.driven)
        watch_energy(s);
    if (s->factored == FRONTS)
        solver_negative(s, &negative, &err);
    if (s->now.iteration == 0)
        s->jump.negative = negative;
    const int changed = negative != s->jump.negative || s->factored != s->K.layout;
    s->jump.suspected = changed || (s->jump.suspected && !s->jump.verifying);
}

/* ---- verification ---------------------------------------------------------------------------- */

/* |du - x|/|du| of the step du from s->start and its first correction x.  Every vector counts by
 * its softest direction, so that rotations move all of its components alike. */
static double disproportion(const struct solver *s)
{
    const hobe_model *model = s->model;
    double error = 0, size = 0;
    for (long v = 0; v < model->moving; v++) {
        const long i = 3 * model->unknown[v];
        if (i < 0)
            continue;
        const double D = fmax(s->scale[i], fmax(s->scale[i + 1], s->scale[i + 2]));
        for (int a = 0; a < 3; a++) {
            const double du = s->u[3 * v + a] - s->start[3 * v + a];
            error += pow((du - s->jump.first[i + a]) / D, 2);
            size += pow(du / D, 2);
        }
    }
    return size > 0 ? sqrt(error / size) : 0;
}

/* Goes along the path from s->start, at the factor *reached, by plain iterations towards `to`. */
static enum outcome follow(struct solver *s, double step, double to, double *reached,
                           struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors) * sizeof *s->u;
    const double tolerance = s->options.tolerance, whole = to - *reached;
    while (*reached < to && step > fmax(fmin(NO_STEP * *reached, NO_SHARE * whole), LEAST_STEP)) {
        const double left = to - *reached, next = step < left ? *reached + step : to;
        s->options.tolerance = fmax(tolerance, TOLERANCE * fmin(step, left));
        memcpy(s->u, s->start, size);
        s->jump.suspected = 0;
        const enum outcome outcome = solver_iterate(s, next, 0, err);
        s->options.tolerance = tolerance;
        double share = outcome == CONVERGED ? disproportion(s) : INFINITY;
        if (outcome == ERROR)
            return ERROR;
        if (s->jump.suspected && step > CROSSING * *reached)
            share = fmax(share, 1);
        if (share <= PROPORTION) {
            memcpy(s->start, s->u, size);
            *reached = next;
        }
        step = fmin(step, left) * (share < INFINITY ? fmin(AIM / share, LONGER) : 0.5);
    }
    return CONVERGED;
}

enum outcome jump_verify(struct solver *s, double from, double to, struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors);
    const int iterations = s->options.max_iterations;
    const double share = fmin(LARGEST * fmin(1, s->jump.turn), AIM / disproportion(s));
    const double step = (to - from) * fmax(share, SMALLEST);
    double reached = from, *found = hobe_alloc(size, sizeof *found, err);
    if (!found)
        return ERROR;
    solver_log(s, "a jump is suspected");
    memcpy(found, s->u, size * sizeof *found);
    s->options.max_iterations = ITERATIONS;
    s->jump.verifying = 1;
    enum outcome outcome = follow(s, step, to, &reached, err);
    s->jump.verifying = 0;
    s->options.max_iterations = iterations;
    if (reached < to) {
        memcpy(s->u, found, size * sizeof *found);
        if (s->info.limit_load == 0)
            s->info.limit_load = fmax(reached, LEAST_STEP);
    }
    if (outcome == CONVERGED)
        outcome = solver_iterate(s, to, 0, err);
    hobe_free(found);
    return outcome == CONVERGED ? solver_refine(s, err) : outcome;
}
