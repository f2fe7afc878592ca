/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tangent.h"

#include "check.h"
#include "pattern.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A built model and fields on its vectors. */
struct probe {
    const hobe_model *model;
    residual_part *part;
    double *u, *moved, *r, *d[2], *product;
    struct matrix K; /* in columns */
};

static double *numbers(long n)
{
    double *p = calloc((size_t)n, sizeof *p);
    if (!p)
        check_stop("out of memory: %ld numbers", n);
    return p;
}

static void random_field(const hobe_model *model, double size, double *x)
{
    for (long i = 0; i < 3 * model->vectors; i++)
        x[i] = model->unknown[i / 3] >= 0 ? random_real(-size, size) : 0;
}

static void probe_open(struct probe *p, const hobe_model *model, residual_part *part)
{
    const long n = 3 * model->vectors;
    *p = (struct probe){.model = model, .part = part};
    double **const fields[] = {&p->u, &p->moved, &p->r, &p->product, &p->d[0], &p->d[1]};
    for (int i = 0; i < 6; i++)
        *fields[i] = numbers(n);
    if (pattern_matrix(model, COLUMNS, &p->K, NULL))
        check_stop("out of memory");
    random_field(model, 0.3, p->u);
    random_field(model, 1, p->d[0]);
    random_field(model, 1, p->d[1]);
}

static void probe_close(struct probe *p)
{
    double *const all[] = {p->u, p->moved, p->r, p->product, p->d[0], p->d[1]};
    for (int i = 0; i < 6; i++)
        free(all[i]);
    hobe_free(p->K.value);
}

/* product = A d over the unknowns, as a field on the vectors. */
static void multiply(const struct probe *p, const double *d)
{
    const hobe_model *model = p->model;
    long *vector = calloc((size_t)model->unknowns, sizeof *vector);
    if (!vector)
        check_stop("out of memory");
    memset(p->product, 0, (size_t)(3 * model->vectors) * sizeof *p->product);
    for (long v = 0; v < model->vectors; v++)
        if (model->unknown[v] >= 0)
            vector[model->unknown[v]] = v;
    for (long j = 0; j < 3 * model->unknowns; j++)
        for (long k = model->pattern.Ap[j]; k < model->pattern.Ap[j + 1]; k++) {
            const long i = model->pattern.Ai[k];
            p->product[3 * vector[i / 3] + i % 3] += p->K.value[k] * d[3 * vector[j / 3] + j % 3];
        }
    free(vector);
}

static double inner(const struct probe *p, const double *a, const double *b)
{
    double sum = 0;
    for (long i = 0; i < 3 * p->model->vectors; i++)
        sum += a[i] * b[i];
    return sum;
}

/* d1 . dr/d(d0) by differences of fourth order: truncation and round-off about 1e-12. */
static double slope_of_residual(const struct probe *p)
{
    static const double at[4] = {-2, -1, 1, 2}, weight[4] = {1, -8, 8, -1};
    const double h = 1e-3;
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        memset(p->r, 0, (size_t)(3 * p->model->vectors) * sizeof *p->r);
        for (long i = 0; i < 3 * p->model->vectors; i++)
            p->moved[i] = p->u[i] + at[k] * h * p->d[0][i];
        p->part(p->model, p->moved, p->r, NULL);
        sum += weight[k] / (12 * h) * inner(p, p->r, p->d[1]);
    }
    return sum;
}

void check_tangent(hobe_model *model, residual_part *part, int symmetric, const char *what)
{
    struct hobe_error err;
    struct probe p;
    if (hobe_model_build(model, &err) || pattern_columns(model, &err))
        check_stop("%s: %s", what, err.message);
    probe_open(&p, model, part);
    part(model, p.u, p.r, &p.K);
    multiply(&p, p.d[0]);
    const double one = inner(&p, p.d[1], p.product), size = sqrt(inner(&p, p.product, p.product));
    check_that(size > 0, "%s: the tangent is there", what);
    check_absolute(one, slope_of_residual(&p), 1e-9 * size, "%s: tangent", what);
    multiply(&p, p.d[1]);
    const double other = inner(&p, p.d[0], p.product);
    if (symmetric)
        check_absolute(one, other, 1e-12 * size, "%s: symmetry", what);
    else
        check_that(fabs(one - other) > 1e-8 * size, "%s: has no potential", what);
    probe_close(&p);
}

double *field_on(const hobe_model *model)
{
    double *x = hobe_alloc(3 * (size_t)model->vectors, sizeof *x, NULL);
    if (!x)
        check_stop("out of memory");
    return x;
}
