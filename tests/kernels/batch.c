/* SPDX-License-Identifier: GPL-3.0-or-later */
/* States, norms, and batches of eight elements (declared in fixture.h). */
#include "fixture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- states --------------------------------------------------------------------------------- */

void turn(const struct fixture *fx, const real *R, const real *X, real *q)
{
    for (int v = 0; v < fx->kernel->vectors; v++)
        for (int i = 0; i < 3; i++) {
            const real *x = X + 3 * v, *row = R + 3 * i;
            q[3 * v + i] = row[0] * x[0] + row[1] * x[1] + row[2] * x[2];
        }
}

int is_position(const struct fixture *fx, int v)
{
    return fx->kernel->vector[v].mode == 0 && !fx->kernel->vector[v].slope;
}

/* The fraction, of denominator 12 at most, that a double stands for: 1/3 to the last digit. */
static real fraction(double x)
{
    real near = roundl(12 * (real)x) / 12;
    return fabsl(near - x) < 1e-15L ? near : x;
}

void reference(const struct fixture *fx, real *X)
{
    const struct hobe_kernel *k = fx->kernel;
    if (fx->curved) {
        memcpy(X, fx->curved, (size_t)fx->dofs * sizeof *X);
        return;
    }
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *a = &k->vector[v];
        const char *name = k->mode[a->mode];
        real *x = X + 3 * v;
        x[0] = x[1] = x[2] = 0;
        if (a->mode == 0)
            x[0] = a->slope ? 1 : fx->beam.length * fraction(k->node[a->node]);
        else if (!a->slope && !strcmp(name, "y"))
            x[1] = 1;
        else if (!a->slope && !strcmp(name, "z"))
            x[2] = 1;
    }
}

void random_vectors(const struct fixture *fx, real scale, real *u)
{
    for (int i = 0; i < fx->dofs; i++)
        u[i] = random_real(-scale, scale) * fx->size[i];
}

/* ---- norms ---------------------------------------------------------------------------------- */

real force_norm(const struct fixture *fx, const real *f)
{
    real s = 0;
    for (int i = 0; i < fx->dofs; i++)
        s += f[i] * fx->size[i] * f[i] * fx->size[i];
    return sqrtl(s);
}

real force_error(const struct fixture *fx, const real *f, const real *exact)
{
    real s = 0;
    for (int i = 0; i < fx->dofs; i++) {
        real d = (f[i] - exact[i]) * fx->size[i];
        s += d * d;
    }
    return sqrtl(s) / force_norm(fx, exact);
}

real matrix_error(const struct fixture *fx, const real *K, const real *exact)
{
    real s = 0, norm = 0;
    for (int i = 0; i < fx->dofs; i++)
        for (int j = 0; j < fx->dofs; j++) {
            real size = fx->size[i] * fx->size[j],
                 d = size * (K[i * fx->dofs + j] - exact[i * fx->dofs + j]);
            s += d * d;
            norm += size * exact[i * fx->dofs + j] * size * exact[i * fx->dofs + j];
        }
    return sqrtl(s / norm);
}

/* ---- batches -------------------------------------------------------------------------------- */

static size_t scratch(const struct fixture *fx)
{
    return fx->points ? POINTS_SCRATCH * (size_t)fx->kernel->vectors : fx->kernel->scratch;
}

void batch_open(const struct fixture *fx, struct batch *b)
{
    const size_t dofs = (size_t)fx->dofs, vectors = (size_t)fx->kernel->vectors;
    b->q0 = grab(dofs, sizeof(hobe_lanes));
    b->u = grab(dofs, sizeof(hobe_lanes));
    b->q = grab(dofs, sizeof(hobe_lanes));
    b->f = grab(dofs, sizeof(hobe_lanes));
    b->U = grab(1, sizeof(hobe_lanes));
    b->K = grab(9 * vectors * (vectors + 1) / 2, sizeof(hobe_lanes));
    b->scratch = grab(scratch(fx), sizeof(hobe_lanes));
    b->exact_q0 = grab(HOBE_LANES * dofs, sizeof(real));
    b->exact_u = grab(HOBE_LANES * dofs, sizeof(real));
}

void batch_close(struct batch *b)
{
    free(b->q0);
    free(b->u);
    free(b->q);
    free(b->f);
    free(b->U);
    free(b->K);
    free(b->scratch);
    free(b->exact_q0);
    free(b->exact_u);
}

void batch_set(const struct fixture *fx, struct batch *b, int lane, const real *q0, const real *u)
{
    for (int i = 0; i < fx->dofs; i++) {
        b->q0[i][lane] = (double)q0[i];
        b->u[i][lane] = (double)u[i];
        b->q[i][lane] = b->q0[i][lane] + b->u[i][lane];
        b->exact_q0[lane * fx->dofs + i] = q0[i];
        b->exact_u[lane * fx->dofs + i] = b->u[i][lane];
    }
}

void batch_random(const struct fixture *fx, struct batch *b, real scale)
{
    real R[9], *X = grab((size_t)fx->dofs, sizeof(real));
    real *q0 = grab((size_t)fx->dofs, sizeof(real)), *u = grab((size_t)fx->dofs, sizeof(real));
    reference(fx, X);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        random_rotation(R);
        turn(fx, R, X, q0);
        random_vectors(fx, scale, u);
        batch_set(fx, b, lane, q0, u);
    }
    free(X);
    free(q0);
    free(u);
}

void batch_copy(const struct fixture *fx, struct batch *a, int to, const struct batch *b, int from)
{
    batch_set(fx, a, to, b->exact_q0 + from * fx->dofs, b->exact_u + from * fx->dofs);
}

void lane_position(const struct fixture *fx, const struct batch *b, int lane, real *q)
{
    for (int i = 0; i < fx->dofs; i++)
        q[i] = b->exact_q0[lane * fx->dofs + i] + b->exact_u[lane * fx->dofs + i];
}

void lane_vector(const struct fixture *fx, const hobe_lanes *a, int lane, real *x)
{
    for (int i = 0; i < fx->dofs; i++)
        x[i] = a[i][lane];
}

void lane_matrix(const struct fixture *fx, const hobe_lanes *K, int lane, real *full)
{
    for (int r = 0; r < fx->dofs; r++)
        for (int c = 0; c < fx->dofs; c++) {
            int v = r / 3, w = c / 3, i = r % 3, j = c % 3;
            int at = v >= w ? 9 * hobe_pair(v, w) + 3 * i + j : 9 * hobe_pair(w, v) + 3 * j + i;
            full[r * fx->dofs + c] = K[at][lane];
        }
}

/* ---- calls ---------------------------------------------------------------------------------- */

static void spoil(hobe_lanes *a, size_t count)
{
    memset(a, 0xff, count * sizeof *a);
}

static void spoil_force(const struct fixture *fx, struct batch *b)
{
    spoil(b->f, (size_t)fx->dofs);
    spoil(b->scratch, scratch(fx));
}

void run_energy(const struct fixture *fx, const struct hobe_invariants *inv, struct batch *b)
{
    spoil(b->U, 1);
    fx->kernel->energy(inv, b->q0, b->u, b->U);
}

void run_force(const struct fixture *fx, const struct hobe_invariants *inv, struct batch *b)
{
    spoil_force(fx, b);
    if (fx->points)
        points_evaluate()(fx->points, b->q0, b->u, b->f, NULL, b->scratch);
    else
        fx->kernel->force(inv, b->q0, b->u, b->f, b->scratch);
}

void run_tangent(const struct fixture *fx, const struct hobe_invariants *inv, struct batch *b)
{
    const size_t n = (size_t)fx->kernel->vectors;
    spoil_force(fx, b);
    spoil(b->K, 9 * n * (n + 1) / 2);
    if (fx->points)
        points_evaluate()(fx->points, b->q0, b->u, b->f, b->K, b->scratch);
    else
        fx->kernel->tangent(inv, b->q0, b->u, b->f, b->K, b->scratch);
}

void run_trilinear(const struct fixture *fx, const hobe_lanes *p, const hobe_lanes *q,
                   const hobe_lanes *r, struct batch *b)
{
    spoil_force(fx, b);
    fx->kernel->trilinear(&fx->inv, p, q, r, b->f, b->scratch);
}

void run_series(const struct fixture *fx, int k, const hobe_lanes *u, hobe_lanes *table,
                struct batch *b)
{
    spoil_force(fx, b);
    fx->kernel->series(&fx->inv, k, b->q0, u, table, b->f);
}
