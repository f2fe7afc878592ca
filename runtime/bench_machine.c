/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arithmetic of the peak and the baselines: compiled once for each kind of processor, as
 * kernels are. */
#include "bench_baseline.h"

static void turn(hobe_lanes *x)
{
    hobe_real *const at = (hobe_real *)x, a = at[0] * 0 + 0.5, b = at[0] * 0 + 1;
    hobe_real chain[BENCH_TURN_CHAINS];
    for (int i = 0; i < BENCH_TURN_CHAINS; i++)
        chain[i] = at[i];
    for (int step = 0; step < BENCH_TURN_STEPS; step++)
        for (int i = 0; i < BENCH_TURN_CHAINS; i++)
            chain[i] = chain[i] * a + b;
    for (int i = 0; i < BENCH_TURN_CHAINS; i++)
        at[i] = chain[i];
}

/* ---- points --------------------------------------------------------------------------------- */

/* Of one point: the deformation gradient F_ia, dr_i/dX_a; and the weighted stress S_ab. */
struct at_point {
    hobe_real F[3][3], S[3][3];
};

static void deform(int vectors, const double *G, const hobe_real *q, hobe_real F[3][3])
{
    for (int i = 0; i < 9; i++)
        F[i / 3][i % 3] = (hobe_real){0};
    for (int v = 0; v < vectors; v++)
        for (int i = 0; i < 3; i++)
            for (int a = 0; a < 3; a++)
                F[i][a] += G[3 * v + a] * q[(3 * v + i) * HOBE_PARTS];
}

/* S = weight C:E, E = (F'F - 1)/2 */
static void set_stress(const struct hobe_elasticity *C, double weight, struct at_point *at)
{
    hobe_real g[3][3];
    for (int a = 0; a < 3; a++)
        for (int b = a; b < 3; b++)
            g[a][b] =
                at->F[0][a] * at->F[0][b] + at->F[1][a] * at->F[1][b] + at->F[2][a] * at->F[2][b];
    for (int a = 0; a < 3; a++)
        at->S[a][a] = 0.5 * weight *
                      (C->normal[a][0] * (g[0][0] - 1) + C->normal[a][1] * (g[1][1] - 1) +
                       C->normal[a][2] * (g[2][2] - 1));
    at->S[1][2] = at->S[2][1] = weight * C->shear[0] * g[1][2];
    at->S[0][2] = at->S[2][0] = weight * C->shear[1] * g[0][2];
    at->S[0][1] = at->S[1][0] = weight * C->shear[2] * g[0][1];
}

/* f_v += F S G_v */
static void add_force(int vectors, const double *G, const struct at_point *at, hobe_real *f)
{
    for (int i = 0; i < 3; i++) {
        hobe_real P[3];
        for (int a = 0; a < 3; a++)
            P[a] =
                at->F[i][0] * at->S[0][a] + at->F[i][1] * at->S[1][a] + at->F[i][2] * at->S[2][a];
        for (int v = 0; v < vectors; v++)
            f[(3 * v + i) * HOBE_PARTS] +=
                P[0] * G[3 * v] + P[1] * G[3 * v + 1] + P[2] * G[3 * v + 2];
    }
}

/* Rows of a vector at a point: B[6][3], the strain xx, yy, zz, 2yz, 2xz, 2xy of each component;
 * weight C B; and weight S G. */
struct rows {
    hobe_real B[18], CB[18], SG[3];
};

static void set_rows(const double *G, const struct hobe_elasticity *C, double weight,
                     const struct at_point *at, struct rows *rows)
{
    static const int voigt[3][2] = {{1, 2}, {0, 2}, {0, 1}};
    hobe_real *B = rows->B, *CB = rows->CB;
    for (int i = 0; i < 3; i++) {
        for (int r = 0; r < 3; r++) {
            const int a = voigt[r][0], b = voigt[r][1];
            B[3 * r + i] = at->F[i][r] * G[r];
            B[9 + 3 * r + i] = at->F[i][a] * G[b] + at->F[i][b] * G[a];
            CB[9 + 3 * r + i] = weight * C->shear[r] * B[9 + 3 * r + i];
        }
        for (int r = 0; r < 3; r++)
            CB[3 * r + i] = weight * C->normal[r][0] * B[i] + weight * C->normal[r][1] * B[3 + i] +
                            weight * C->normal[r][2] * B[6 + i];
        rows->SG[i] = at->S[i][0] * G[0] + at->S[i][1] * G[1] + at->S[i][2] * G[2];
    }
}

/* K += B'CB + G S G' 1, its lower triangle; G[vectors][3], rows[vectors] */
static void add_tangent(int vectors, const double *G, const struct rows *rows, hobe_real *K)
{
    for (int v = 0; v < vectors; v++)
        for (int w = 0; w <= v; w++, K += 9 * HOBE_PARTS) {
            const struct rows *row = rows + v;
            const hobe_real *c = rows[w].CB, s = row->SG[0] * G[3 * w] + row->SG[1] * G[3 * w + 1] +
                                                 row->SG[2] * G[3 * w + 2];
            hobe_real k[9] = {s, {0}, {0}, {0}, s, {0}, {0}, {0}, s};
            for (int r = 0; r < 6; r++)
                for (int ij = 0; ij < 9; ij++)
                    k[ij] += row->B[3 * r + ij / 3] * c[3 * r + ij % 3];
            for (int ij = 0; ij < 9; ij++)
                K[ij * HOBE_PARTS] += k[ij];
        }
}

static void clear(hobe_lanes *x, int n)
{
    for (int i = 0; i < n; i++)
        x[i] = (hobe_lanes){0};
}

static void points(const struct bench_points *p, const hobe_lanes *q, hobe_lanes *f, hobe_lanes *K)
{
    const int V = p->vectors;
    struct rows *rows = (struct rows *)p->scratch;
    clear(f, 3 * V);
    if (K)
        clear(K, 9 * V * (V + 1) / 2);
    for (int h = 0; h < HOBE_PARTS; h++)
        for (int i = 0; i < p->points; i++) {
            const double *G = p->gradient + 3 * V * i, weight = p->weight[i];
            struct at_point at;
            deform(V, G, (const hobe_real *)q + h, at.F);
            set_stress(&p->law, weight, &at);
            add_force(V, G, &at, (hobe_real *)f + h);
            for (int v = 0; K && v < V; v++)
                set_rows(G + 3 * v, &p->law, weight, &at, rows + v);
            if (K)
                add_tangent(V, G, rows, (hobe_real *)K + h);
        }
}

/* ---- eqs. 27 and 28 ------------------------------------------------------------------------- */

/* c_tk = (A_tjkv e_j.e_v - b_tk)/2, with which eq. 27 is f_t = c_tk e_k, and the part of eq. 28
 * that holds the force is c_tj 1 */
static void contract_twice(const struct bench_tensors *t, const hobe_real *g, hobe_real *c)
{
    const int V = t->vectors;
    for (int i = 0; i < V * V; i++)
        c[i] = -0.5 * t->b[i] + (hobe_real){0};
    const double *A = t->A;
    for (int i = 0; i < V; i++)
        for (int j = 0; j < V; j++)
            for (int k = 0; k < V; k++, A += V) {
                hobe_real sum = {0};
                for (int v = 0; v < V; v++)
                    sum += A[v] * g[V * j + v];
                c[V * i + k] += 0.5 * sum;
            }
}

/* k_md = sum over k and v of e_km e_vd A_kv */
static void contract_sides(int V, const double *A, const hobe_real *e, hobe_real *k)
{
    for (int i = 0; i < 9; i++)
        k[i] = (hobe_real){0};
    for (int from = 0; from < V; from++)
        for (int v = 0; v < V; v++)
            for (int m = 0; m < 3; m++)
                for (int d = 0; d < 3; d++)
                    k[3 * m + d] += e[3 * from + m] * (e[3 * v + d] * A[V * from + v]);
}

static void printed(const struct bench_tensors *t, const hobe_lanes *q, hobe_lanes *f,
                    hobe_lanes *K)
{
    const int V = t->vectors;
    hobe_real *e = (hobe_real *)t->scratch, *g = e + 3 * V, *c = g + V * V, k[9];
    for (int h = 0; h < HOBE_PARTS; h++) {
        hobe_real *fh = (hobe_real *)f + h, *Kh = (hobe_real *)K + h;
        for (int i = 0; i < 3 * V; i++)
            e[i] = ((const hobe_real *)q)[i * HOBE_PARTS + h];
        for (int i = 0; i < V * V; i++)
            g[i] = e[3 * (i / V)] * e[3 * (i % V)] + e[3 * (i / V) + 1] * e[3 * (i % V) + 1] +
                   e[3 * (i / V) + 2] * e[3 * (i % V) + 2];
        contract_twice(t, g, c);
        for (int i = 0; i < 3 * V; i++) {
            hobe_real sum = {0};
            for (int v = 0; v < V; v++)
                sum += c[V * (i / 3) + v] * e[3 * v + i % 3];
            fh[i * HOBE_PARTS] = sum;
        }
        for (int i = 0; K && i < V; i++)
            for (int j = 0; j <= i; j++, Kh += 9 * HOBE_PARTS) {
                contract_sides(V, t->A + (long)(V * i + j) * V * V, e, k);
                for (int m = 0; m < 3; m++)
                    k[4 * m] += c[V * i + j];
                for (int md = 0; md < 9; md++)
                    Kh[md * HOBE_PARTS] = k[md];
            }
    }
}

const struct bench_machine HOBE_KERNEL(bench) = {
#ifdef __AVX512F__
    "avx512",
#elif defined __AVX2__
    "avx2",
#else
    "portable",
#endif
    sizeof(hobe_real) / sizeof(double),
    turn,
    points,
    printed,
};
