/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "trust.h"

#include "mass.h"
#include "solution.h"

#include <math.h>
#include <string.h>

enum { MOST = 5 }; /* corrections until the theorem speaks */

static const double SAFETY = 2;

/* Corrections below this share of the state are rounding, which a second one does not make
 * smaller; what their square adds is not worth a thought. */
static const double ROUND_OFF = 1e-8;

static size_t size_of(const struct trust *trust)
{
    return (size_t)(3 * trust->s.model->vectors);
}

enum hobe_status trust_open(struct trust *trust, hobe_model *whole, struct hobe_error *err)
{
    return solver_open(&trust->s, whole, &(struct hobe_newton){0}, err);
}

void trust_close(struct trust *trust)
{
    solver_close(&trust->s);
}

/* |D^-1 x| of what moves. */
static double norm_of(const struct trust *trust, const double *x)
{
    const hobe_model *model = trust->s.model;
    double sum = 0;
    for (long v = 0; v < model->moving; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const long i = 3 * model->unknown[v] + a;
            sum += x[i] / trust->s.scale[i] * (x[i] / trust->s.scale[i]);
        }
    return sqrt(sum);
}

double trust_norm(const struct trust *trust, const double *u)
{
    solver_restrict(trust->s.model, u, trust->s.x);
    return norm_of(trust, trust->s.x);
}

/* s.x = the correction at the current state, by new factors or, without a tangent, the last. */
static enum hobe_status correct(struct trust *trust, double load, enum tangent tangent,
                                struct hobe_error *err)
{
    struct solver *s = &trust->s;
    solver_evaluate(s, load, tangent);
    const enum hobe_status status = model_failure(s->model, err);
    if (status)
        return status;
    const enum outcome outcome = tangent ? solver_factor(s, err) : CONVERGED;
    if (outcome != CONVERGED)
        return outcome == FAILED ? HOBE_SINGULAR : HOBE_NO_MEMORY;
    return solver_solve(s, s->r, -1, s->x, err);
}

/* How far the current state is from where it began. */
static double moved(struct trust *trust)
{
    struct solver *s = &trust->s;
    for (size_t i = 0; i < size_of(trust); i++)
        s->step[i] = s->u[i] - s->start[i];
    return trust_norm(trust, s->step);
}

/* (1 - sqrt(1 - 2 h))/h without cancellation. */
static double radius(double h)
{
    return h <= 0.5 ? 2 / (1 + sqrt(1 - 2 * h)) : INFINITY;
}

/* One correction, taken; *rest: how far the equilibrium is from where it began. */
static enum hobe_status advance(struct trust *trust, double load, enum tangent tangent,
                                double *rest, struct hobe_error *err)
{
    struct solver *s = &trust->s;
    enum hobe_status status = correct(trust, load, tangent, err);
    if (status)
        return status;
    const double first = *rest = norm_of(trust, s->x);
    solver_move(s, s->x, 1);
    if (s->motion.force || first <= ROUND_OFF * trust_norm(trust, s->u))
        return HOBE_OK;
    status = correct(trust, load, NO_TANGENT, err);
    if (!status)
        *rest = first * radius(2 * norm_of(trust, s->x) / first);
    return status;
}

static enum hobe_status measure(struct trust *trust, double load, double *bound,
                                struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    memcpy(trust->s.start, trust->s.u, size_of(trust) * sizeof *trust->s.u);
    *bound = INFINITY;
    for (int i = 0; !status && isinf(*bound) && i < MOST; i++) {
        double rest = 0;
        const double before = moved(trust);
        status = advance(trust, load, i == 0 ? TRUE_TANGENT : NEXT_TANGENT, &rest, err);
        *bound = rest >= 0 ? before + rest : INFINITY; /* NaN, too */
    }
    return status;
}

/* What moves has forces of inertia; and the unbalanced ones have acted since it began: a mode of
 * the angular frequency w answers (1 - cos w t)/w^2, about 1/(w^2 + 1/t^2) or less. */
static void set_motion(struct trust *trust, const hobe_solution *state, double *force)
{
    struct solver *s = &trust->s;
    const double t = state->info.time;
    mass_force(s->model, 1, state->w, force);
    s->motion.force = force;
    s->motion.inertia = t > 0 ? 1 / (t * t) : 0;
}

enum hobe_status trust_measure(struct trust *trust, const hobe_solution *state, double *size,
                               double *indicator, double *correction, struct hobe_error *err)
{
    struct solver *s = &trust->s;
    double bound = 0, *force = hobe_alloc(size_of(trust), sizeof *force, err);
    if (!force)
        return HOBE_NO_MEMORY;
    memcpy(s->u, state->u, size_of(trust) * sizeof *s->u);
    s->motion = (struct motion){.instant = solution_instant(state, s->model)};
    if (state->w)
        set_motion(trust, state, force);
    *size = fmax(*size, trust_norm(trust, s->u));
    const enum hobe_status status = measure(trust, state->w ? 1 : state->info.load, &bound, err);
    s->motion.force = NULL;
    hobe_free(force);
    *indicator = bound > 0 ? SAFETY * bound / *size : 0;
    for (size_t i = 0; correction && i < size_of(trust); i++)
        correction[i] = s->u[i] - s->start[i];
    return status;
}

enum hobe_status trust_ask(hobe_model *whole, hobe_solution *state, double *size,
                           struct hobe_error *err)
{
    struct trust trust;
    enum hobe_status status = trust_open(&trust, whole, err);
    if (!status)
        status = trust_measure(&trust, state, size, &state->info.indicator, NULL, err);
    if (status == HOBE_SINGULAR) {
        state->info.indicator = INFINITY;
        status = HOBE_OK;
    }
    trust_close(&trust);
    return status;
}
