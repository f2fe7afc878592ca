/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "subspace.h"

#include "eigen.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* A field of which less than this is left by those before it depends on them: rounding, enlarged by
 * as much as scaled fields of a stiff spectrum lean on each other. */
static const double DEPENDENT = 1e-11;

void subspace_close(struct subspace *space)
{
    hobe_free(space->W);
    hobe_free(space->A);
    hobe_free(space->product);
    hobe_free(space->x);
    hobe_free(space->pivot);
    *space = (struct subspace){0};
}

enum hobe_status subspace_open(struct subspace *space, const struct hobe_model *model,
                               const double *scale, long room, struct hobe_error *err)
{
    const size_t n = (size_t)(3 * model->unknowns), m = (size_t)room;
    subspace_close(space);
    *space = (struct subspace){.model = model, .n = (long)n, .room = room, .scale = scale};
    space->W = hobe_alloc(m * n, sizeof *space->W, err);
    space->A = hobe_alloc(m * m, sizeof *space->A, err);
    space->product = hobe_alloc(n, sizeof *space->product, err);
    space->x = hobe_alloc(m, sizeof *space->x, err);
    space->pivot = hobe_alloc(m, sizeof *space->pivot, err);
    return space->W && space->A && space->product && space->x && space->pivot ? HOBE_OK
                                                                              : HOBE_NO_MEMORY;
}

/* ---- fields --------------------------------------------------------------------------------- */

double *subspace_next(struct subspace *space)
{
    return space->W + space->count * space->n;
}

/* Gram and Schmidt's method, twice: the second pass takes what rounding left of the first. */
static void orthonormalize(struct subspace *space, double *w)
{
    const double before = sqrt(dot(space->n, w, w));
    for (int pass = 0; pass < 2; pass++)
        for (long j = 0; j < space->count; j++) {
            const double *other = space->W + j * space->n, along = dot(space->n, w, other);
            for (long i = 0; i < space->n; i++)
                w[i] -= along * other[i];
        }
    const double left = sqrt(dot(space->n, w, w));
    if (!(left > DEPENDENT * before))
        return;
    for (long i = 0; i < space->n; i++)
        w[i] /= left;
    space->count++;
}

void subspace_take(struct subspace *space)
{
    double *w = subspace_next(space);
    for (long i = 0; i < space->n; i++)
        w[i] /= space->scale[i];
    orthonormalize(space, w);
}

void subspace_take_vector(struct subspace *space, long unknown)
{
    for (int a = 0; a < 3; a++) {
        double *phi = subspace_next(space);
        memset(phi, 0, (size_t)space->n * sizeof *phi);
        phi[3 * unknown + a] = 1;
        subspace_take(space);
    }
}

/* ---- projections ---------------------------------------------------------------------------- */

double subspace_norm(const struct subspace *space, const double *f)
{
    const struct hobe_model *model = space->model;
    double sum = 0;
    for (long j = 0; j < space->count; j++) {
        const double *w = space->W + j * space->n;
        double along = 0;
        for (long v = 0; v < model->vectors; v++)
            for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
                const long i = 3 * model->unknown[v] + a;
                along += w[i] * space->scale[i] * f[3 * v + a];
            }
        sum += along * along;
    }
    return sqrt(sum);
}

/* y = D A D w */
static void multiply(const struct subspace *space, const double *Ax, const double *w, double *y)
{
    const struct pattern *p = &space->model->pattern;
    const double *D = space->scale;
    memset(y, 0, (size_t)space->n * sizeof *y);
    for (long j = 0; j < space->n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            y[p->Ai[k]] += D[p->Ai[k]] * Ax[k] * D[j] * w[j];
}

enum hobe_status subspace_factor(struct subspace *space, const double *Ax, struct hobe_error *err)
{
    const long m = space->count;
    for (long j = 0; j < m; j++) {
        multiply(space, Ax, space->W + j * space->n, space->product);
        for (long i = 0; i < m; i++)
            space->A[j * m + i] = dot(space->n, space->W + i * space->n, space->product);
    }
    return eigen_factor((int)m, space->A, space->pivot, err);
}

void subspace_solve(const struct subspace *space, double *x)
{
    for (long i = 0; i < space->n; i++)
        x[i] *= space->scale[i];
    for (long j = 0; j < space->count; j++)
        space->x[j] = dot(space->n, space->W + j * space->n, x);
    eigen_divide((int)space->count, space->A, space->pivot, space->x);
    memset(x, 0, (size_t)space->n * sizeof *x);
    for (long j = 0; j < space->count; j++)
        for (long i = 0; i < space->n; i++)
            x[i] += space->x[j] * space->W[j * space->n + i];
    for (long i = 0; i < space->n; i++)
        x[i] *= space->scale[i];
}
