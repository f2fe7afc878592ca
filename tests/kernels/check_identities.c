/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What must hold of the energy whatever the element, and what must hold where it is quartic: these
 * need no evaluator, only the kernel itself. */
#include "check.h"
#include "checks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Sums of a few thousand terms of both signs in another order. */
static const real rounding = 1e-13L;

static real *reals(const struct fixture *fx)
{
    return grab((size_t)fx->dofs, sizeof(real));
}

/* ---- lanes ---------------------------------------------------------------------------------- */

/* Lane `a` of one batch has the same force, energy and tangent as lane `b` of another. */
static void same(const struct fixture *fx, const char *name, const struct batch *a, int i,
                 const struct batch *b, int j)
{
    const int blocks = 9 * hobe_pair(fx->kernel->vectors, 0);
    long different = a->U[0][i] != b->U[0][j];
    for (int k = 0; k < fx->dofs; k++)
        different += a->f[k][i] != b->f[k][j];
    for (int k = 0; k < blocks; k++)
        different += a->K[k][i] != b->K[k][j];
    check(name, where(fx, i), different, 0);
}

static void run_all(const struct fixture *fx, struct batch *b)
{
    run_energy(fx, &fx->inv, b);
    run_tangent(fx, &fx->inv, b);
}

/* Lanes do the same arithmetic: a state has, to the last bit, the same result in every lane and
 * whatever its neighbours are. */
static void check_lanes(const struct fixture *fx, struct batch *b, struct batch *c)
{
    for (int lane = 0; lane < HOBE_LANES; lane++)
        batch_copy(fx, c, (lane + 3) % HOBE_LANES, b, lane);
    run_all(fx, b);
    run_all(fx, c);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        same(fx, "lanes: a permuted batch, differing numbers", b, lane, c, (lane + 3) % HOBE_LANES);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        batch_copy(fx, c, lane, b, lane % 2);
    run_all(fx, c);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        same(fx, "lanes: the same state in all, differing numbers", b, lane % 2, c, lane);
}

/* ---- force and tangent ---------------------------------------------------------------------- */

static void check_tangent_parts(const struct fixture *fx, struct batch *b, struct batch *c)
{
    const int n = fx->dofs;
    real *f = reals(fx), *g = reals(fx), *K = grab((size_t)(n * n), sizeof *K);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        batch_copy(fx, c, lane, b, lane);
    run_tangent(fx, &fx->inv, b);
    run_force(fx, &fx->inv, c);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real skew = 0, norm = 0;
        lane_matrix(fx, b->K, lane, K);
        for (int i = 0; i < n * n; i++)
            norm = fmaxl(norm, fabsl(K[i]) * fx->size[i / n] * fx->size[i % n]);
        for (int i = 0; i < n; i++)
            for (int j = i / 3 * 3; j < i / 3 * 3 + 3; j++)
                skew = fmaxl(skew, fabsl(K[i * n + j] - K[j * n + i]) * fx->size[i] * fx->size[j]);
        check("tangent: diagonal blocks symmetric", where(fx, lane), skew / norm, rounding);
    }
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_vector(fx, b->f, lane, f);
        lane_vector(fx, c->f, lane, g);
        check("tangent: its force is the force", where(fx, lane), force_error(fx, f, g), rounding);
    }
    free(f);
    free(g);
    free(K);
}

/* dU/ds along a random direction d, the same in all lanes, by the five-point difference: exact for
 * a quartic energy, so the step may be large and only round-off remains, 1e-16 U/(step f.d), with
 * some digits lost where f.d is small beside U; hence the looser bound. */
static void check_direction(const struct fixture *fx, struct batch *b, const real *d)
{
    static const double weight[4] = {1, -8, 8, -1}, step[4] = {-0.2, -0.1, 0.1, 0.2};
    const size_t dofs = (size_t)fx->dofs;
    hobe_lanes *u = grab(dofs, sizeof *u), sum = {0};
    real *f = reals(fx);
    memcpy(u, b->u, dofs * sizeof *u);
    for (int s = 0; s < 4; s++) {
        for (int i = 0; i < fx->dofs; i++)
            b->u[i] = u[i] + step[s] * (double)d[i];
        run_energy(fx, &fx->inv, b);
        sum += weight[s] / 1.2 * b->U[0];
    }
    memcpy(b->u, u, dofs * sizeof *u);
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real work = 0;
        lane_vector(fx, b->f, lane, f);
        for (int i = 0; i < fx->dofs; i++)
            work += f[i] * d[i];
        check("force: gradient of the energy by differences", where(fx, lane),
              fabsl(sum[lane] - work) / force_norm(fx, f), 1e-10L);
    }
    free(u);
    free(f);
}

static void check_gradient(const struct fixture *fx, struct batch *b)
{
    real *d = reals(fx);
    for (int n = 0; n < 6; n++) {
        random_vectors(fx, 1, d);
        check_direction(fx, b, d);
    }
    free(d);
}

/* ---- trilinear form ------------------------------------------------------------------------- */

/* out[lane][dofs] = T(p; q, r). */
static void trilinear(const struct fixture *fx, struct batch *b, const hobe_lanes *p,
                      const hobe_lanes *q, const hobe_lanes *r, real *out)
{
    run_trilinear(fx, p, q, r, b);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        lane_vector(fx, b->f, lane, out + lane * fx->dofs);
}

/* |a - b| over the sum of the norms of the terms that make a and b. */
static void compare(const struct fixture *fx, const char *name, const real *a, const real *b,
                    const real *terms)
{
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real *d = reals(fx);
        const int at = lane * fx->dofs;
        for (int i = 0; i < fx->dofs; i++)
            d[i] = a[at + i] - b[at + i];
        check(name, where(fx, lane), force_norm(fx, d) / force_norm(fx, terms + at), 1e-11L);
        free(d);
    }
}

/* T(a; b, c) has absolute positions in it: strains are differences of terms of order one, so the
 * scale is |T|, not the force. */
static void check_trilinear(const struct fixture *fx, struct batch *b)
{
    const int n = HOBE_LANES * fx->dofs;
    real *T = grab(4 * (size_t)n, sizeof *T), *T0 = T + n, *f = T + 2 * n, *sum = T + 3 * n;
    trilinear(fx, b, b->q, b->q, b->q, T);
    trilinear(fx, b, b->q, b->q0, b->q0, T0);
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        lane_vector(fx, b->f, lane, f + lane * fx->dofs);
    for (int i = 0; i < n; i++)
        sum[i] = T[i] - T0[i];
    compare(fx, "trilinear: T(q;q,q) - T(q;q0,q0) is the force", sum, f, T);
    trilinear(fx, b, b->u, b->q, b->q0, T);
    trilinear(fx, b, b->u, b->q0, b->q, T0);
    compare(fx, "trilinear: symmetric in the last two", T, T0, T);
    free(T);
}

/* Linear in the first: T(q; .) = T(q0; .) + T(u; .); and in the second. */
static void check_linear(const struct fixture *fx, struct batch *b)
{
    const int n = HOBE_LANES * fx->dofs;
    real *T = grab(3 * (size_t)n, sizeof *T), *A = T + n, *B = T + 2 * n;
    for (int second = 0; second < 2; second++) {
        trilinear(fx, b, b->q, b->q, b->q, T);
        trilinear(fx, b, second ? b->q : b->q0, second ? b->q0 : b->q, b->q, A);
        trilinear(fx, b, second ? b->q : b->u, second ? b->u : b->q, b->q, B);
        for (int i = 0; i < n; i++)
            A[i] += B[i];
        compare(fx, "trilinear: linear in each", A, T, T);
    }
    free(T);
}

/* T(a; b, c).d = 2 sum strain(a, d) stress(b, c), against the norms of the terms. */
static void check_gram(const struct fixture *fx, struct batch *b)
{
    const struct hobe_kernel *k = fx->kernel;
    const size_t n = (size_t)fx->inv.stations * (size_t)(k->normals + k->shears);
    hobe_lanes *strain = grab(4 * n, sizeof *strain), *stress = strain + n;
    k->gram(&fx->inv, b->q, b->q0, strain, strain + 2 * n);
    k->gram(&fx->inv, b->u, b->q, strain + 3 * n, stress);
    run_trilinear(fx, b->q, b->u, b->q, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real sum = 0, terms = 0, work = 0;
        for (size_t i = 0; i < n; i++) {
            sum += 2 * (real)strain[i][lane] * stress[i][lane];
            terms += 2 * fabsl((real)strain[i][lane] * stress[i][lane]);
        }
        for (int i = 0; i < fx->dofs; i++)
            work += (real)b->f[i][lane] * b->q0[i][lane];
        check("gram: T(a;b,c).d is 2 strain(a,d) stress(b,c)", where(fx, lane),
              fabsl(work - sum) / terms, 1e-11L);
    }
    free(strain);
}

/* The coefficients of a series are sums of T(c_i; c_j, c_l), i + j + l = k, none of them k. */
static void check_series(const struct fixture *fx, struct batch *b)
{
    enum { LAST = 4 };
    const struct hobe_kernel *k = fx->kernel;
    const size_t dofs = (size_t)fx->dofs, n = HOBE_LANES * dofs;
    const size_t kept = (size_t)(3 * (2 * k->modes - 1) + k->normals + k->shears);
    hobe_lanes *c = grab((LAST - 1) * dofs, sizeof *c);
    hobe_lanes *table = grab((LAST + 1) * kept * (size_t)fx->inv.stations, sizeof *c);
    real *sum = grab(3 * n, sizeof *sum), *T = sum + n, *f = T + n;
    for (size_t i = 0; i < (LAST - 1) * dofs; i++)
        for (int lane = 0; lane < HOBE_LANES; lane++)
            c[i][lane] = b->u[i % dofs][(lane + 1 + (int)(i / dofs)) % HOBE_LANES];
    for (int order = 1; order <= LAST; order++) {
        run_series(fx, order, order > 1 ? c + (size_t)(order - 2) * dofs : b->u, table, b);
        for (int lane = 0; lane < HOBE_LANES; lane++)
            lane_vector(fx, b->f, lane, f + (size_t)lane * dofs);
        memset(sum, 0, n * sizeof *sum);
        for (int i = 0; i < order; i++)
            for (int j = order - i, l = 0; j >= 0; j--, l++) {
                if (j >= order || l >= order)
                    continue;
                const hobe_lanes *at[] = {b->q, c, c + dofs, c + 2 * dofs};
                trilinear(fx, b, at[i], at[j], at[l], T);
                for (size_t m = 0; m < n; m++)
                    sum[m] += T[m];
            }
        trilinear(fx, b, b->q, b->q, b->q, T);
        compare(fx, "series: the sum of T of lower orders", f, sum, T);
    }
    free(c);
    free(table);
    free(sum);
}

/* K d = T(d;q,q) - T(d;q0,q0) + 2 T(q;q,d), from force(q) = T(q;q,q) - T(q;q0,q0). */
static void check_tangent_trilinear(const struct fixture *fx, struct batch *b)
{
    const int n = HOBE_LANES * fx->dofs, dofs = fx->dofs;
    real *T = grab(4 * (size_t)n, sizeof *T), *A = T + n, *B = T + 2 * n, *Kd = T + 3 * n;
    real *K = grab((size_t)(dofs * dofs), sizeof *K), *random = reals(fx);
    hobe_lanes *d = grab((size_t)dofs, sizeof *d);
    random_vectors(fx, 1, random);
    for (int i = 0; i < dofs; i++)
        d[i] = (double)random[i] + (hobe_lanes){0};
    trilinear(fx, b, d, b->q, b->q, T);
    trilinear(fx, b, d, b->q0, b->q0, A);
    trilinear(fx, b, b->q, b->q, d, B);
    run_tangent(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_matrix(fx, b->K, lane, K);
        for (int i = 0; i < dofs; i++) {
            real s = 0;
            for (int j = 0; j < dofs; j++)
                s += K[i * dofs + j] * d[j][lane];
            Kd[lane * dofs + i] = s;
        }
    }
    for (int i = 0; i < n; i++) {
        A[i] = T[i] - A[i] + 2 * B[i];
        T[i] = fabsl(T[i]) + 2 * fabsl(B[i]);
    }
    compare(fx, "tangent: K d from the trilinear form", Kd, A, T);
    free(T);
    free(K);
    free(random);
    free(d);
}

/* ---- invariants and translation ------------------------------------------------------------- */

/* The largest relative difference of U, and of f, between two batches. */
static void compare_batches(const struct fixture *fx, const char *name, const struct batch *a,
                            const struct batch *b, real bound)
{
    real *f = reals(fx), *g = reals(fx);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real error = fabsl((real)a->U[0][lane] / b->U[0][lane] - 1);
        lane_vector(fx, a->f, lane, f);
        lane_vector(fx, b->f, lane, g);
        check(name, where(fx, lane), fmaxl(error, force_error(fx, f, g)), bound);
    }
    free(f);
    free(g);
}

/* One station more than the kernel asks for, with a block of its own for each station (as in a
 * tapered beam), changes nothing: the energy is a polynomial in xi. */
static void check_stations(const struct fixture *fx, struct batch *b, struct batch *c)
{
    const int n = fx->kernel->stations + 1;
    struct hobe_invariants inv;
    for (int lane = 0; lane < HOBE_LANES; lane++)
        batch_copy(fx, c, lane, b, lane);
    make_invariants(fx, n, n, &inv);
    run_all(fx, b);
    run_energy(fx, &inv, c);
    run_tangent(fx, &inv, c);
    compare_batches(fx, "invariants: stations suffice, blocks of a taper", b, c, 1e-12L);
    free_invariants(&inv);
}

/* Positions on a grid of 2^-30 m can be moved by whole 1e6 m without rounding.  The kernel takes
 * differences of positions first, so the results keep all their digits. */
static void check_translation(const struct fixture *fx, struct batch *b, struct batch *c)
{
    double far[6]; /* of the reference, and of the displacement */
    for (int i = 0; i < 6; i++)
        far[i] = (double)roundl(random_real(-1e6L, 1e6L));
    for (int i = 0; i < fx->dofs; i++)
        for (int lane = 0; lane < HOBE_LANES; lane++) {
            const int moves = is_position(fx, i / 3);
            const double grid = 0x1p30, shift = moves ? far[i % 3] : 0;
            const double q0 = round(b->q0[i][lane] * grid) / grid;
            const double u = round(b->u[i][lane] * grid) / grid;
            b->q0[i][lane] = moves ? q0 : b->q0[i][lane];
            b->u[i][lane] = moves ? u : b->u[i][lane];
            c->q0[i][lane] = b->q0[i][lane] + shift;
            c->u[i][lane] = b->u[i][lane] + (moves ? far[3 + i % 3] : 0);
        }
    run_all(fx, b);
    run_all(fx, c);
    compare_batches(fx, "translation by 1e6 m", c, b, rounding);
}

/* At the reference everything but the tangent is zero, exactly. */
static void check_rest(const struct fixture *fx, struct batch *b)
{
    const size_t bytes = (size_t)fx->dofs * sizeof *b->u;
    hobe_lanes *u = memcpy(grab((size_t)fx->dofs, sizeof *u), b->u, bytes);
    memset(b->u, 0, bytes);
    run_energy(fx, &fx->inv, b);
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real worst = fabsl((real)b->U[0][lane]);
        for (int i = 0; i < fx->dofs; i++)
            worst = fmaxl(worst, fabsl((real)b->f[i][lane]));
        check("rest: no energy, no force", where(fx, lane), worst, 0);
    }
    memcpy(b->u, u, bytes);
    free(u);
}

/* Strains of 1e-12 are linear in u to 1e-12, and so are the forces they give if no digits are lost:
 * f(u) = K(0) u.  With strains as differences of lengths 1e-16/1e-12 would remain. */
static void check_small(const struct fixture *fx, struct batch *b)
{
    const int n = fx->dofs;
    hobe_lanes *u = grab((size_t)n, sizeof *u);
    real *f = reals(fx), *Ku = reals(fx), *K = grab((size_t)(n * n), sizeof *K);
    memcpy(u, b->u, (size_t)n * sizeof *u);
    for (int i = 0; i < n; i++)
        b->u[i] = (hobe_lanes){0};
    run_tangent(fx, &fx->inv, b);
    for (int i = 0; i < n; i++)
        b->u[i] = 1e-12 * u[i];
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_matrix(fx, b->K, lane, K);
        lane_vector(fx, b->f, lane, f);
        for (int i = 0; i < n; i++) {
            Ku[i] = 0;
            for (int j = 0; j < n; j++)
                Ku[i] += K[i * n + j] * b->u[j][lane];
        }
        check("force at strain 1e-12: K(0) u", where(fx, lane), force_error(fx, f, Ku), 1e-10L);
    }
    memcpy(b->u, u, (size_t)n * sizeof *u);
    free(u);
    free(f);
    free(Ku);
    free(K);
}

void check_identities(const struct fixture *fx)
{
    struct batch b, c;
    batch_open(fx, &b);
    batch_open(fx, &c);
    batch_random(fx, &b, 0.3L);
    check_lanes(fx, &b, &c);
    check_tangent_parts(fx, &b, &c);
    if (!fx->structural) { /* a quartic energy */
        check_gradient(fx, &b);
        check_trilinear(fx, &b);
        check_gram(fx, &b);
        check_linear(fx, &b);
        check_series(fx, &b);
        check_tangent_trilinear(fx, &b);
        check_stations(fx, &b, &c);
    }
    check_small(fx, &b);
    check_rest(fx, &b);
    check_translation(fx, &b, &c); /* last: it rounds the states of b */
    batch_close(&b);
    batch_close(&c);
}
