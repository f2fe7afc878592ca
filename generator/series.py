# SPDX-License-Identifier: GPL-3.0-or-later
"""The force along a power series of states, as text: the same for every element whose energy is
quartic, from the loop nests of section.py."""

SERIES = """\
/* What a station keeps of one order of a series: its section vectors D and its stresses Q. */
enum { KEPT = 3 * S + GRAMS };

static void add_to(hobe_real *sum, const hobe_real *x, int n)
{
    for (int i = 0; i < n; i++)
        sum[i] += x[i];
}

/* The Gram entries of order k > 1 that D_1 .. D_(k-1) make: sum of D_i . D_j, i + j = k.  The
 * orders at a station are `order` apart. */
static void gram_of_order(int k, const hobe_real *at, ptrdiff_t order, hobe_real *gamma)
{
    hobe_real weighted[3 * S], more[GRAMS];
    for (int p = 0; p < GRAMS; p++)
        gamma[p] = zero;
    for (int i = 1; i <= k / 2; i++) {
        const double weight = 2 * i < k ? 1.0 : 0.5;
        for (int a = 0; a < 3 * S; a++)
            weighted[a] = weight * at[i * order + a];
        column_differences(sectional, weighted, at + (k - i) * order, more);
        add_to(gamma, more, GRAMS);
    }
}

/* P = sum of Q_i D_(k-i), i = 1 .. k. */
static void force_of_order(int k, const hobe_real *at, ptrdiff_t order, hobe_real *P)
{
    hobe_real more[3 * S];
    for (int i = 0; i < 3 * S; i++)
        P[i] = zero;
    for (int i = 1; i <= k; i++) {
        section_force(at + i * order + 3 * S, at + (k - i) * order, more);
        add_to(P, more, 3 * S);
    }
}

/* Q += the stress of the Gram entries of B and D, what completes an order: with D_0 of the state
 * and D_m, m > 0; or with B = D0 + U/2 and U of the state itself. */
static void add_stress(const double *H, int symmetry, const hobe_real *B, const hobe_real *D,
                       hobe_real *Q)
{
    hobe_real gamma[GRAMS], more[GRAMS];
    column_differences(sectional, B, D, gamma);
    row_stress(sectional, H, symmetry, gamma, more);
    add_to(Q, more, GRAMS);
}

/* The first order: D_0 = D0 + U of the state, from the reference x0, and its Q_0. */
static void begin_series(const double *N, const double *Nx, const double *H, int symmetry,
                         const hobe_real *x0, hobe_real *at)
{
    hobe_real D0[3 * S], B[3 * S];
    section_vectors(N, Nx, x0, D0);
    for (int i = 0; i < 3 * S; i++)
        B[i] = D0[i] + 0.5 * at[i];
    for (int i = 3 * S; i < KEPT; i++)
        at[i] = zero;
    add_stress(H, symmetry, B, at, at + 3 * S);
    add_to(at, D0, 3 * S);
}

static void series_part(const struct hobe_invariants *inv, int k, const hobe_real *q0,
                        const hobe_real *u, hobe_real *table, hobe_real *f)
{
    const ptrdiff_t order = (ptrdiff_t)HOBE_PARTS * inv->stations * KEPT;
    hobe_real x0[3 * V], x[3 * V], P[3 * S], gamma[GRAMS];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        hobe_real *at = table + KEPT * g, *next = at + k * order;
        section_vectors(N, Nx, x, next - order);
        if (k > 1)
            add_stress(H, inv->symmetry, at, next - order, next - order + 3 * S);
        else
            begin_series(N, Nx, H, inv->symmetry, x0, at);
        gram_of_order(k, at, order, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, next + 3 * S);
        force_of_order(k, at, order, P);
        for (int v = 0; v < V; v++)
            for (int a = 0; a < 3; a++) {
                const int m = mode[v];
                f[(3 * v + a) * HOBE_PARTS] += inv->wx[g] * Nx[v] * P[3 * m + a];
                if (m > 0)
                    f[(3 * v + a) * HOBE_PARTS] += inv->wx[g] * N[v] * P[3 * (M - 1 + m) + a];
            }
    }
}

static void series(const struct hobe_invariants *inv, int k, const hobe_lanes *q0,
                   const hobe_lanes *u, hobe_lanes *table, hobe_lanes *f)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        series_part(inv, k, (const hobe_real *)q0 + h, (const hobe_real *)u + h,
                    (hobe_real *)table + (ptrdiff_t)h * inv->stations * KEPT, (hobe_real *)f + h);
}
"""
