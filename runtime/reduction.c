/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reduction.h"

#include "body.h"
#include "pattern.h"
#include "reduction_parts.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- fields ---------------------------------------------------------------------------------- */

/* x[3] = sum_j J_j q_j at the k-th vector touched. */
static void expand_at(const struct reduction *r, long k, const double *q, double x[3])
{
    const double *J = r->J + 3 * k * r->n;
    for (int a = 0; a < 3; a++, J += r->n) {
        double sum = 0;
        for (long j = 0; j < r->n; j++)
            sum += J[j] * q[j];
        x[a] = sum;
    }
}

static const double *expand_touched(const struct reduction *r, const double *q,
                                    const double *centre, double *field)
{
    for (long k = 0; k < r->touched; k++) {
        double *x = field + 3 * r->vector[k];
        expand_at(r, k, q, x);
        for (int a = 0; centre && a < 3; a++)
            x[a] += centre[3 * r->vector[k] + a];
    }
    memcpy(field + 3 * r->whole->beam_vectors, q + 3 * r->blocks,
           reduction_behind_size(r) * sizeof *field);
    return field;
}

const double *reduction_state(const hobe_model *model, const double *u)
{
    const struct reduction *r = model->reduction;
    return expand_touched(r, u, r->of->centre, r->u);
}

const double *reduction_rates(const hobe_model *model, const double *v)
{
    const struct reduction *r = model->reduction;
    return expand_touched(r, v, NULL, r->v);
}

void reduction_expand(const hobe_model *model, const double *q, int state, double *field)
{
    const struct reduction *r = model->reduction;
    const long beams = 3 * r->whole->beam_vectors;
    memset(field, 0, (size_t)beams * sizeof *field);
    if (state && r->of->centre)
        memcpy(field, r->of->centre, (size_t)beams * sizeof *field);
    for (long j = 0; j < r->n; j++) {
        const double *phi = reduction_field(r, j);
        for (long i = 0; i < beams; i++)
            field[i] += q[j] * phi[i];
    }
    memcpy(field + beams, q + 3 * r->blocks, reduction_behind_size(r) * sizeof *field);
}

void reduction_project(const hobe_model *model, double factor, const double *F, double *f)
{
    const struct reduction *r = model->reduction;
    const long beams = 3 * r->whole->beam_vectors;
    for (long j = 0; j < r->n; j++)
        f[j] += factor * dot(beams, reduction_field(r, j), F);
    for (size_t i = 0; i < reduction_behind_size(r); i++)
        reduction_behind(r, f)[i] += factor * F[(size_t)beams + i];
}

/* ---- matrices -------------------------------------------------------------------------------- */

/* K_ij += x of scalars of the state, where the layout of K has the block. */
static void add(const hobe_model *model, const struct matrix *K, long i, long j, double x)
{
    const struct reduction *r = model->reduction;
    const long row = model->unknown[i / 3], column = model->unknown[j / 3];
    const long place =
        row < 0 || column < 0 ? -1 : r->place[K->layout][column * model->unknowns + row];
    if (place >= 0)
        K->value[place + j % 3 * model->stride[K->layout][column] + i % 3] += x;
}

void reduction_add_dense(const hobe_model *model, const double *dense, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    for (long j = 0; j < r->n; j++)
        for (long i = 0; i < r->n; i++)
            add(model, K, i, j, dense[i * r->n + j]);
}

/* ---- items ----------------------------------------------------------------------------------- */

void reduction_clear(const struct reduction *r, int matrix)
{
    for (long k = 0; k < r->touched; k++)
        memset(r->f + 3 * r->vector[k], 0, 3 * sizeof *r->f);
    memset(r->f + 3 * r->whole->beam_vectors, 0, reduction_behind_size(r) * sizeof *r->f);
    if (matrix)
        pattern_clear(r->whole, &r->K);
}

/* f += J'F */
static void gather_force(const struct reduction *r, double *f)
{
    const double *J = r->J;
    for (long k = 0; k < r->touched; k++)
        for (int a = 0; a < 3; a++, J += r->n) {
            const double F = r->f[3 * r->vector[k] + a];
            for (long j = 0; F != 0 && j < r->n; j++)
                f[j] += J[j] * F;
        }
    const double *F = r->f + 3 * r->whole->beam_vectors;
    for (size_t i = 0; i < reduction_behind_size(r); i++)
        reduction_behind(r, f)[i] += r->dropped[i] ? 0 : F[i];
}

/* product[3 touched][n] = K J, K the part of the vectors touched. */
static void multiply_touched(const struct reduction *r)
{
    const long m = 3 * r->whole->touched.count, rows = 3 * r->touched, n = r->n;
    memset(r->product, 0, (size_t)(rows * n) * sizeof *r->product);
    for (long s = 0; s < rows; s++)
        for (long row = 0; row < rows; row++) {
            const double k = r->K.value[s * m + row];
            for (long j = 0; k != 0 && j < n; j++)
                r->product[row * n + j] += k * r->J[s * n + j];
        }
}

/* The scalar of the reduced state that a scalar behind the touched vectors of beams is. */
static long scalar_of(const struct reduction *r, long k)
{
    return 3 * r->blocks + 3 * (r->whole->touched.vector[k / 3] - r->whole->beam_vectors) + k % 3;
}

void reduction_gather_behind(const hobe_model *model, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    const long m = 3 * r->whole->touched.count, rows = 3 * r->touched, n = r->n;
    for (long o = rows; o < m; o++) {
        const long to = scalar_of(r, o);
        if (r->dropped[to - 3 * r->blocks])
            continue;
        for (long j = 0; j < n; j++) {
            double below = 0, right = 0;
            for (long row = 0; row < rows; row++) {
                below += r->K.value[row * m + o] * r->J[row * n + j];
                right += r->K.value[o * m + row] * r->J[row * n + j];
            }
            add(model, K, to, j, below);
            add(model, K, j, to, right);
        }
        for (long p = rows; p < m; p++)
            if (!r->dropped[scalar_of(r, p) - 3 * r->blocks])
                add(model, K, scalar_of(r, p), to, r->K.value[o * m + p]);
    }
}

/* K += J'K J */
static void gather_tangent(const hobe_model *model, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    const long n = r->n;
    multiply_touched(r);
    memset(r->dense, 0, (size_t)(n * n) * sizeof *r->dense);
    for (long row = 0; row < 3 * r->touched; row++)
        for (long i = 0; i < n; i++) {
            const double J = r->J[row * n + i];
            for (long j = 0; J != 0 && j < n; j++)
                r->dense[i * n + j] += J * r->product[row * n + j];
        }
    reduction_add_dense(model, r->dense, K);
    reduction_gather_behind(model, K);
}

void reduction_act(const hobe_model *model, reduction_items *act, const double *u,
                   const struct instant *instant, double factor, double *f, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    if (!r) {
        act(model, u, instant, factor, f, K);
        return;
    }
    struct instant at = *instant;
    if (instant->v)
        at.v = reduction_rates(model, instant->v);
    reduction_clear(r, K != NULL);
    act(r->whole, reduction_state(model, u), &at, factor, r->f, K ? &r->K : NULL);
    gather_force(r, f);
    if (K)
        gather_tangent(model, K);
}

void reduction_spare(const hobe_model *model, const double *u, double *f, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    for (long i = r->n; i < 3 * model->vectors; i++) {
        if (i >= 3 * r->blocks && !r->dropped[i - 3 * r->blocks])
            continue;
        f[i] += u[i];
        if (K)
            add(model, K, i, i, 1);
    }
}

/* ---- elements -------------------------------------------------------------------------------- */

void reduction_elastic(const hobe_model *model, const double *u, double *f, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    if (K) {
        pattern_clear(model, K);
        memset(r->dense, 0, (size_t)(r->n * r->n) * sizeof *r->dense);
    }
    reduced_add(r->of, u, f, K ? r->dense : NULL);
    if (K)
        reduction_add_dense(model, r->dense, K);
}

double reduction_energy(const hobe_model *model, const double *u)
{
    return reduced_energy(model->reduction->of, u);
}

double reduction_centre(const hobe_model *model)
{
    const struct reduction *r = model->reduction;
    memset(r->dense, 0, (size_t)r->n * sizeof *r->dense);
    return sqrt(2 * fmax(0, reduced_energy(r->of, r->dense)));
}

void reduction_round_off(const hobe_model *model, const double *u, double *f)
{
    const struct reduction *r = model->reduction;
    double *moved = r->dense, *at = r->dense + r->n; /* which has room for both */
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    memset(at, 0, (size_t)r->n * sizeof *at);
    for (long j = 0; j < r->n; j++)
        moved[j] = u[j] * (1 + (j % 2 ? DBL_EPSILON : -DBL_EPSILON));
    reduced_add(r->of, u, at, NULL);
    reduced_add(r->of, moved, f, NULL);
    for (long j = 0; j < r->n; j++)
        f[j] -= at[j];
}

/* ---- scale ----------------------------------------------------------------------------------- */

/* Fields of a basis are normal in the stiffness and, for rigid motions, a billionth of its
 * diagonal: what is stiff by less than this share of the stiffest is so by rounding. */
static const double SOFTEST = 1e-3;

static void limit_coordinates(const struct reduction *r, double *scale)
{
    double least = INFINITY;
    for (long j = 0; j < r->n; j++)
        least = scale[j] > 0 ? fmin(least, scale[j]) : least;
    const double most = isfinite(least) ? least / sqrt(SOFTEST) : 1;
    for (long j = 0; j < r->n; j++)
        scale[j] = scale[j] > 0 ? fmin(scale[j], most) : most;
}

/* What D = diag^(-1/2) of the coordinates lets the vectors touched move by: D^2 = sum_j J_j^2
 * D_j^2. */
void reduction_scale(const hobe_model *model, double *scale)
{
    const struct reduction *r = model->reduction;
    const hobe_model *whole = r->whole;
    limit_coordinates(r, scale);
    if (whole->bodies.count == 0)
        return;
    for (long k = 0; k < 3 * r->touched; k++) {
        double sum = 0;
        for (long j = 0; j < r->n; j++)
            sum += pow(r->J[k * r->n + j] * scale[j], 2);
        r->scale[3 * whole->unknown[r->vector[k / 3]] + k % 3] = sqrt(sum);
    }
    for (int back = 0; back < 2; back++) {
        for (long v = whole->beam_vectors; v < whole->vectors; v++) {
            const long from = model->unknown[model_number(model, v)];
            for (int a = 0; a < 3 && from >= 0; a++) {
                double *there = r->scale + 3 * whole->unknown[v] + a;
                double *here = scale + 3 * from + a;
                *(back ? here : there) = *(back ? there : here);
            }
        }
        if (!back)
            body_scale(whole, r->scale);
    }
}
