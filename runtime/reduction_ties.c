/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which constraints a basis leaves nothing to do: fields that were found under joints keep these by
 * themselves, and their multipliers would be undetermined. */
#include "assemble.h"
#include "constraint.h"
#include "damping.h"
#include "load.h"
#include "mass.h"
#include "pattern.h"
#include "reduction.h"
#include "solution.h"
#include "spring.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* A row of the constraints' derivatives is no row of its own where earlier ones leave less than
 * this of what the terms of the largest add up to without their signs: fields are found to 1e-9.
 */
static const double NOTHING = 1e-7;

/* The rows of the multipliers, over coordinates and then what bodies have. */
struct rows {
    long count, columns, *scalar; /* [count] behind the coordinates, -1: of a spare multiplier */
    double *value, *size;         /* [count][columns]; size: the terms' absolute values */
    double largest;               /* |size| of a row */
};

static enum hobe_status open_rows(const struct reduction *r, struct rows *rows,
                                  struct hobe_error *err)
{
    const struct touched *t = &r->whole->touched;
    long multipliers = 0;
    for (long k = 0; k < t->count; k++)
        multipliers += t->vector[k] >= r->whole->moving;
    rows->count = 3 * multipliers;
    rows->columns = r->n + 3 * (t->count - r->touched - multipliers);
    const size_t size = (size_t)(rows->count * rows->columns);
    rows->scalar = hobe_alloc((size_t)rows->count, sizeof *rows->scalar, err);
    rows->value = hobe_alloc(size, sizeof *rows->value, err);
    rows->size = hobe_alloc(size, sizeof *rows->size, err);
    return rows->scalar && rows->value && rows->size ? HOBE_OK : HOBE_NO_MEMORY;
}

/* Row k: the derivatives of the constraint at scalar o of the vectors touched. */
static void fill_row(const struct reduction *r, struct rows *rows, long k, long o)
{
    const long m = 3 * r->whole->touched.count, beams = 3 * r->touched;
    double *value = rows->value + k * rows->columns, *size = rows->size + k * rows->columns;
    for (long i = 0; i < beams; i++)
        for (long j = 0; j < r->n; j++) {
            const double term = r->K.value[i * m + o] * r->J[i * r->n + j];
            value[j] += term;
            size[j] += fabs(term);
        }
    for (long j = r->n; j < rows->columns; j++) {
        value[j] = r->K.value[(beams + j - r->n) * m + o];
        size[j] = fabs(value[j]);
    }
}

static void fill(const struct reduction *r, struct rows *rows)
{
    const struct touched *t = &r->whole->touched;
    for (long k = 0, v = t->count - rows->count / 3; k < rows->count; k++) {
        const long vector = t->vector[v + k / 3];
        const long o = 3 * (v + k / 3) + k % 3;
        const int spare = r->K.value[o * 3 * t->count + o] != 0;
        rows->scalar[k] = spare ? -1 : 3 * (vector - r->whole->beam_vectors) + k % 3;
        fill_row(r, rows, k, o);
    }
    for (long j = 0; j < rows->columns; j++) { /* columns in a unit of their own */
        double most = 0;
        for (long k = 0; k < rows->count; k++)
            most = fmax(most, rows->size[k * rows->columns + j]);
        for (long k = 0; most > 0 && k < rows->count; k++) {
            rows->value[k * rows->columns + j] /= most;
            rows->size[k * rows->columns + j] /= most;
        }
    }
    for (long k = 0; k < rows->count; k++) {
        const double *size = rows->size + k * rows->columns;
        rows->largest = fmax(rows->largest, sqrt(dot(rows->columns, size, size)));
    }
}

/* Takes earlier rows out of row k, and makes what is left a unit vector; 0 where nothing is. */
static int orthonormalise(const struct rows *rows, long k)
{
    const long n = rows->columns;
    double *row = rows->value + k * n;
    for (int pass = 0; pass < 2; pass++)
        for (long l = 0; l < k; l++) {
            const double along = dot(n, row, rows->value + l * n);
            for (long j = 0; j < n; j++)
                row[j] -= along * rows->value[l * n + j];
        }
    const double left = sqrt(dot(n, row, row));
    const int own = left > NOTHING * rows->largest;
    for (long j = 0; j < n; j++)
        row[j] = own ? row[j] / left : 0;
    return own;
}

enum hobe_status reduction_drop(struct reduction *r, const double *state, struct hobe_error *err)
{
    const struct instant reference = {.held_back = 1};
    struct rows rows = {0};
    const long behind = 3 * (r->whole->vectors - r->whole->beam_vectors);
    r->dropped = hobe_alloc((size_t)behind, 1, err);
    enum hobe_status status = r->dropped ? open_rows(r, &rows, err) : HOBE_NO_MEMORY;
    if (!status && rows.count > 0) {
        constraint_add(r->whole, state, &reference, r->f, &r->K);
        status = model_failure(r->whole, err);
        fill(r, &rows);
    }
    for (long k = 0; !status && k < rows.count; k++)
        if (!orthonormalise(&rows, k) && rows.scalar[k] >= 0) {
            r->dropped[rows.scalar[k]] = 1;
            r->drops++;
        }
    hobe_free(rows.scalar);
    hobe_free(rows.value);
    hobe_free(rows.size);
    return status;
}

/* ---- what they carry ---------------------------------------------------------------------------
 */

/* Forces out of balance on the whole model in a state without these multipliers; and K, the
 * derivatives of the constraints. */
static void sum_forces(const struct reduction *r, const struct hobe_solution *state, double *f)
{
    const hobe_model *whole = r->whole;
    const struct instant at = {
        .time = state->info.time, .v = state->v, .held_back = state->v ? 0 : 1 - state->info.load};
    assemble(whole, state->u, f, NULL);
    pattern_clear(whole, &r->K);
    constraint_add(whole, state->u, &at, f, &r->K);
    spring_add(whole, state->u, &at, f, NULL);
    damping_add(whole, state->u, &at, f, NULL);
    load_subtract(whole, state->u, &at, state->v ? 1 : state->info.load, f, NULL);
    if (state->w)
        mass_force(whole, 1, state->w, f);
}

/* scalar[count]: the multipliers, [vectors][3], of joints that the basis keeps, some or all; zero
 * in u from now on. */
static long find_idle(const struct reduction *r, double *u, long *scalar)
{
    long count = 0;
    for (size_t i = 0; i < r->whole->ties.count; i++) {
        const struct tie *tie = model_tie(r->whole, i);
        const long first = 3 * tie->multiplier;
        int drops = 0;
        for (int k = 0; k < tie->constraints; k++)
            drops |= r->dropped[first - 3 * r->whole->beam_vectors + k];
        for (int k = 0; k < tie->constraints && drops; k++) {
            scalar[count++] = first + k;
            u[first + k] = 0;
        }
    }
    return count;
}

/* The derivatives of the constraint of a multiplier, by the vectors touched, row[3 touched], 0 by
 * other multipliers. */
static void take_row(const struct reduction *r, long scalar, double *row)
{
    const struct touched *t = &r->whole->touched;
    const long m = 3 * t->count, o = 3 * t->at[r->whole->unknown[scalar / 3]] + scalar % 3;
    for (long i = 0; i < m; i++)
        row[i] = t->vector[i / 3] < r->whole->moving ? r->K.value[i * m + o] : 0;
}

/* lambda of G G' lambda = -G f: with G' lambda the forces at the joints are nearest to balance. */
static void balance(const struct reduction *r, long count, const long *scalar, const double *f,
                    double *work, double *u)
{
    const struct touched *t = &r->whole->touched;
    const long m = 3 * t->count;
    double *G = work, *A = G + count * m, *x = A + count * count;
    for (long k = 0; k < count; k++) {
        take_row(r, scalar[k], G + k * m);
        x[k] = 0;
        for (long i = 0; i < m; i++)
            x[k] -= G[k * m + i] * f[3 * t->vector[i / 3] + i % 3];
        for (long l = 0; l <= k; l++)
            A[k * count + l] = dot(m, G + k * m, G + l * m);
    }
    reduction_solve(count, A, x);
    for (long k = 0; k < count; k++)
        u[scalar[k]] = x[k];
}

enum hobe_status reduction_reactions(const struct reduction *r, struct hobe_solution *state,
                                     struct hobe_error *err)
{
    const size_t behind = 3 * (size_t)(r->whole->vectors - r->whole->beam_vectors);
    if (r->drops == 0)
        return HOBE_OK;
    long *scalar = hobe_alloc(behind, sizeof *scalar, err);
    double *f = hobe_alloc((size_t)(3 * r->whole->vectors), sizeof *f, err);
    const long count = scalar ? find_idle(r, state->u, scalar) : 0;
    const size_t size = (size_t)(count * (3 * r->whole->touched.count + count + 1));
    double *work = hobe_alloc(size, sizeof *work, err);
    if (scalar && f && work) {
        sum_forces(r, state, f);
        balance(r, count, scalar, f, work, state->u);
    }
    hobe_free(scalar);
    hobe_free(f);
    hobe_free(work);
    return !scalar || !f || !work ? HOBE_NO_MEMORY : model_failure(r->whole, err);
}
