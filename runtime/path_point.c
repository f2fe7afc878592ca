/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One point of a path: Newton's iteration in a plane, and the tangent there. */
#include "load.h"
#include "path_parts.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

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

double path_distance(const struct follower *f, const struct plane *p, const double *u,
                     double lambda)
{
    return (p->c ? along(f, p->c, u) : 0) + p->kappa * lambda - p->value;
}

enum hobe_status path_solve_load(struct follower *f, struct hobe_error *err)
{
    memset(f->force, 0, (size_t)(3 * f->s.model->vectors) * sizeof *f->force);
    load_subtract(f->s.model, f->s.u, &f->s.motion.instant, -1, f->force, NULL);
    return solver_solve(&f->s, f->force, 1, f->q, err);
}

enum hobe_status path_find_correction(struct follower *f, const struct plane *plane,
                                      struct hobe_error *err)
{
    struct solver *s = &f->s;
    enum hobe_status status = solver_solve(s, s->r, -1, s->x, err);
    if (!status)
        status = path_solve_load(f, err);
    if (status)
        return status;
    const double c_x = plane->c ? dot(f->n, plane->c, s->x) : 0;
    const double c_q = plane->c ? dot(f->n, plane->c, f->q) : 0;
    f->mend = -(path_distance(f, plane, s->u, f->lambda) + c_x) / (c_q + plane->kappa);
    for (long i = 0; i < f->n; i++)
        s->x[i] += f->mend * f->q[i];
    return HOBE_OK;
}

void path_take_correction(struct follower *f)
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
    if (path_find_correction(f, plane, err))
        return ERROR;
    path_take_correction(f);
    s->info.iterations++;
    return CONVERGED;
}

enum outcome path_iterate(struct follower *f, const struct plane *plane, struct hobe_error *err)
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

enum outcome path_count_and_factor(struct follower *f, struct hobe_error *err)
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

double path_length(const struct follower *f, const double *v, double kappa)
{
    double sum = kappa * kappa;
    for (long i = 0; i < f->n; i++)
        sum += f->W[i] * v[i] * v[i];
    return sqrt(sum);
}

void path_set_plane(struct follower *f)
{
    struct plane *p = &f->step;
    for (long i = 0; i < f->n; i++)
        p->c[i] = f->W[i] * f->v[i];
    p->kappa = f->kappa;
    p->value = 0;
    p->value = path_distance(f, p, f->s.u, f->lambda);
}
