/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include "constraint.h"
#include "load.h"
#include "spring.h"
#include "taylor.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static long size_of(const struct series *series)
{
    return 3 * series->s->model->vectors;
}

static const struct hobe_force *find_function(const struct hobe_model *model)
{
    for (size_t i = 0; i < model->forces.count; i++)
        if (model_force(model, i)->spec.function)
            return &model_force(model, i)->spec;
    return NULL;
}

/* What a series would have to know the powers of, and does not. */
static enum hobe_status check(const struct hobe_model *model, struct hobe_error *err)
{
    const struct hobe_force *function = find_function(model);
    const struct spring *spring = model->springs.count > 0 ? model->springs.item : NULL;
    const char *unknown = NULL, *where = NULL;
    if (model->spin.speed != 0) {
        unknown = "a scene that spins";
        where = model->spin.where;
    } else if (spring) {
        unknown = "springs";
        where = spring->spec.where;
    } else if (function) {
        unknown = "forces that are functions of the state";
        where = function->where;
    }
    if (!unknown)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, where,
                     "method = \"series\" knows no power series of %s; use method = \"newton\"",
                     unknown);
}

enum hobe_status series_open(struct series *series, struct solver *s, struct hobe_error *err)
{
    const size_t n = (size_t)(3 * s->model->vectors);
    *series = (struct series){.s = s};
    const enum hobe_status status = check(s->model, err);
    if (status)
        return status;
    series->u = hobe_alloc(2 * (SERIES_ORDER + 1), sizeof *series->u, err);
    series->lambda = hobe_alloc(SERIES_ORDER + 1, sizeof *series->lambda, err);
    series->q = hobe_alloc((size_t)(3 * s->model->unknowns), sizeof *series->q, err);
    series->f = hobe_alloc((2 * (SERIES_ORDER + 1) + 2) * n, sizeof *series->f, err);
    if (!series->u || !series->lambda || !series->q || !series->f)
        return HOBE_NO_MEMORY;
    series->Q = series->u + SERIES_ORDER + 1;
    series->more = series->f + n;
    for (int k = 0; k < 2 * (SERIES_ORDER + 1); k++)
        series->u[k] = series->f + (size_t)(2 + k) * n;
    return assemble_series_open(s->model, SERIES_ORDER, &series->table, err);
}

void series_close(struct series *series)
{
    assemble_series_close(&series->table);
    hobe_free(series->u);
    hobe_free(series->lambda);
    hobe_free(series->q);
    hobe_free(series->f);
}

/* y += factor x */
static void add(long n, double factor, const double *x, double *y)
{
    for (long i = 0; i < n; i++)
        y[i] += factor * x[i];
}

/* f = the coefficient of a^k of F - lambda Q that lower orders make. */
static void gather_known(struct series *series, int k)
{
    const struct hobe_model *model = series->s->model;
    const struct instant *instant = &series->s->motion.instant;
    const double *const *u = (const double *const *)series->u;
    const long n = size_of(series);
    assemble_series(model, k, u[k - 1], &series->table, series->f);
    constraint_series(model, u, k, k, series->f);
    load_series(model, u, instant, k, k - 1, series->Q[k - 1]);
    load_series(model, u, instant, k, k, series->more);
    add(n, -series->lambda[0], series->more, series->f);
    for (int i = 1; i < k; i++)
        add(n, -series->lambda[i], series->Q[k - i], series->f);
}

/* u_k = w + lambda_k q with lambda_k from the plane: w[unknowns] = K^-1 of what is known. */
static void set_order(struct series *series, int k, const double *c, double kappa, const double *w)
{
    const struct hobe_model *model = series->s->model;
    const long unknowns = 3 * model->unknowns;
    const double aim = k == 1 ? 1 : 0;
    const double by_w = c ? dot(unknowns, c, w) : 0, by_q = c ? dot(unknowns, c, series->q) : 0;
    const double lambda = (aim - by_w) / (by_q + kappa);
    series->lambda[k] = lambda;
    memset(series->u[k], 0, (size_t)size_of(series) * sizeof *w);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const long i = 3 * model->unknown[v] + a;
            series->u[k][3 * v + a] = w[i] + lambda * series->q[i];
        }
}

enum hobe_status series_expand(struct series *series, double lambda, const double *c, double kappa,
                               struct hobe_error *err)
{
    struct solver *s = series->s;
    memcpy(series->u[0], s->u, (size_t)size_of(series) * sizeof *s->u);
    series->lambda[0] = lambda;
    load_series(s->model, (const double *const *)series->u, &s->motion.instant, 1, 0, series->Q[0]);
    enum hobe_status status = solver_solve(s, series->Q[0], 1, series->q, err);
    for (int k = 1; !status && k <= SERIES_ORDER; k++) {
        gather_known(series, k);
        status = solver_solve(s, series->f, -1, s->x, err);
        if (!status)
            set_order(series, k, c, kappa, s->x);
    }
    return status;
}

double series_range(const struct series *series, double share)
{
    const double first = solver_norm(series->s, series->u[1], -1);
    const double last = solver_norm(series->s, series->u[SERIES_ORDER], -1);
    return pow(share * first / last, 1.0 / (SERIES_ORDER - 1));
}

double series_move(const struct series *series, double a)
{
    const long n = size_of(series);
    double *u = series->s->u, lambda = series->lambda[SERIES_ORDER];
    memcpy(u, series->u[SERIES_ORDER], (size_t)n * sizeof *u);
    for (int k = SERIES_ORDER - 1; k >= 0; k--) {
        lambda = lambda * a + series->lambda[k];
        for (long i = 0; i < n; i++)
            u[i] = u[i] * a + series->u[k][i];
    }
    return lambda;
}

double series_slope(const struct series *series, double a, double *v)
{
    const struct hobe_model *model = series->s->model;
    double lambda = 0;
    memset(v, 0, (size_t)(3 * model->unknowns) * sizeof *v);
    for (int k = SERIES_ORDER; k > 0; k--) {
        lambda = lambda * a + k * series->lambda[k];
        for (long j = 0; j < model->vectors; j++)
            for (int x = 0; x < 3 && model->unknown[j] >= 0; x++) {
                double *to = v + 3 * model->unknown[j] + x;
                *to = *to * a + k * series->u[k][3 * j + x];
            }
    }
    return lambda;
}
