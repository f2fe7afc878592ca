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
    printed,
};
