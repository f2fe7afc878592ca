/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Velocities, accelerations and multipliers that fit the constraints. */
#include "constraint.h"
#include "genalpha.h"
#include "mass.h"
#include "pattern.h"

#include <math.h>
#include <string.h>

/* rate[vectors][3] on the multipliers = Phi_q v at a state, 0 elsewhere.  Along u + s v, at a fixed
 * time, Phi is a polynomial of at most fourth degree in s: n = y x z of one place times that of
 * another.  Differences of five points are its derivative but for rounding. */
static void derive(const struct genalpha *g, const struct genalpha_state *at, double *moved,
                   double *f, double *rate)
{
    static const double weight[] = {1.0 / 12, -2.0 / 3, 0, 2.0 / 3, -1.0 / 12};
    const hobe_model *model = g->s.model;
    const long n = 3 * model->vectors;
    const struct instant instant = {at->time, at->v, 0, 0};
    double fastest = 0;
    for (long i = 0; i < 3 * model->moving; i++)
        fastest = fmax(fastest, fabs(at->v[i]));
    memset(rate, 0, (size_t)n * sizeof *rate);
    const double s = fmin(g->size, 1) / fastest;
    for (int k = 0; k < 5 && fastest > 0; k++) {
        memset(f, 0, (size_t)n * sizeof *f);
        for (long i = 0; i < n; i++)
            moved[i] = i < 3 * model->moving ? at->u[i] + (k - 2) * s * at->v[i] : 0;
        constraint_add(model, moved, &instant, f, NULL);
        for (long i = 3 * model->moving; i < n; i++)
            rate[i] += weight[k] * f[i] / s;
    }
}

void settle_rate(const struct genalpha *g, const struct genalpha_state *at, double *moved,
                 double *f, double *rate)
{
    const struct instant instant = {at->time, at->v, 0, 0};
    derive(g, at, moved, f, rate);
    memset(f, 0, (size_t)(3 * g->s.model->vectors) * sizeof *f);
    constraint_rate(g->s.model, at->u, &instant, f);
    for (long i = 3 * g->s.model->moving; i < 3 * g->s.model->vectors; i++)
        rate[i] += f[i];
}

/* ---- the state now -------------------------------------------------------------------------- */

/* field[i] += x of the unknowns in the vectors from..to - 1. */
static void spread(const struct genalpha *g, long from, long to, double *field)
{
    const long *unknown = g->s.model->unknown;
    for (long v = from; v < to; v++)
        for (int a = 0; a < 3 && unknown[v] >= 0; a++)
            field[3 * v + a] += g->s.x[3 * unknown[v] + a];
}

/* s->u = the state now without multipliers, so that the border is all that constraints add. */
static void take_state(struct genalpha *g)
{
    const size_t moving = (size_t)(3 * g->s.model->moving);
    const size_t all = (size_t)(3 * g->s.model->vectors);
    memcpy(g->s.u, g->now.u, moving * sizeof *g->s.u);
    memset(g->s.u + moving, 0, (all - moving) * sizeof *g->s.u);
}

/* Factors of [M, Phi_q'; Phi_q, 0]. */
static enum hobe_status factor_mass(struct genalpha *g, struct hobe_error *err)
{
    struct solver *s = &g->s;
    take_state(g);
    s->motion = (struct motion){.instant = {g->now.time, g->now.v, 0, 0}, .mass_alone = 1};
    solver_evaluate(s, 1, TRUE_TANGENT);
    pattern_scale(s->model, &s->K, s->scale);
    genalpha_forget(g);
    const enum hobe_status failed = model_failure(s->model, err);
    if (failed)
        return failed;
    const enum outcome outcome = solver_factor(s, err);
    if (outcome == FAILED)
        return hobe_fail(err, HOBE_SINGULAR, NULL,
                         "the accelerations at t = %g s are not determined: something that can "
                         "move has no mass, or constraints depend on each other there",
                         g->now.time);
    return outcome == ERROR ? (err ? err->status : HOBE_NO_MEMORY) : HOBE_OK;
}

/* Velocities that a projection can have: v becomes v1 of its space with M (v1 - v) + Phi_q' mu = 0
 * along that, Phi_q v1 + Phi_t = 0. */
static enum hobe_status confine(struct genalpha *g, struct hobe_error *err)
{
    struct solver *s = &g->s;
    const hobe_model *model = s->model;
    memset(s->r, 0, (size_t)(3 * model->vectors) * sizeof *s->r);
    constraint_rate(model, g->now.u, &s->motion.instant, s->r);
    mass_force(model, -1, g->now.v, s->r);
    const enum hobe_status status = solver_solve(s, s->r, -1, s->x, err);
    memset(g->now.v, 0, (size_t)(3 * model->vectors) * sizeof *g->now.v);
    if (!status)
        spread(g, 0, model->moving, g->now.v);
    return status;
}

/* M dv + Phi_q' mu = 0, Phi_q dv = -(Phi_q v + Phi_t). */
static enum hobe_status project(struct genalpha *g, double *changed, struct hobe_error *err)
{
    const hobe_model *model = g->s.model;
    *changed = 0;
    settle_rate(g, &g->now, g->s.u, g->force, g->a);
    if (genalpha_violation(g, g->a) == 0)
        return HOBE_OK;
    const enum hobe_status status = solver_solve(&g->s, g->a, -1, g->s.x, err);
    if (status)
        return status;
    memset(g->a, 0, (size_t)(3 * model->vectors) * sizeof *g->a);
    spread(g, 0, model->moving, g->a);
    for (long i = 0; i < 3 * model->moving; i++)
        g->now.v[i] += g->a[i];
    *changed = genalpha_norm(g, g->a);
    return HOBE_OK;
}

enum hobe_status settle(struct genalpha *g, double *changed, struct hobe_error *err)
{
    struct solver *s = &g->s;
    const hobe_model *model = s->model;
    const size_t size = (size_t)(3 * model->vectors) * sizeof(double);
    enum hobe_status status = factor_mass(g, err);
    if (!status && s->space.count > 0)
        status = confine(g, err);
    if (!status)
        status = project(g, changed, err);
    if (status)
        return status;
    take_state(g);
    solver_evaluate(s, 1, NO_TANGENT);
    memset(g->a, 0, size);
    constraint_acceleration(model, g->now.u, g->now.v, &s->motion.instant, g->a);
    for (long i = 3 * model->moving; i < 3 * model->vectors; i++)
        s->r[i] = g->a[i];
    status = model_failure(model, err);
    if (!status)
        status = solver_solve(s, s->r, -1, s->x, err);
    if (status)
        return status;
    memset(g->now.w, 0, size);
    memset(g->now.u + 3 * model->moving, 0, size - (size_t)(3 * model->moving) * sizeof(double));
    spread(g, 0, model->moving, g->now.w);
    spread(g, model->moving, model->vectors, g->now.u);
    memcpy(g->now.a, g->now.w, size);
    return HOBE_OK;
}
