# SPDX-License-Identifier: GPL-3.0-or-later
"""The force along a power series of states, as text: the same for every element whose energy is
quartic, from the loop nests of plan.py."""

SERIES = """\
/* What a station keeps of one order of a series: its section vectors D, its stresses tn, ts. */
enum { KEPT = 3 * S + NN + NS };

static void add_to(hobe_real *sum, const hobe_real *x, int n)
{
    for (int i = 0; i < n; i++)
        sum[i] += x[i];
}

/* The Gram entries of order k > 1 that D_1 .. D_(k-1) make: sum of D_i . D_j, i + j = k.  The
 * orders at a station are `order` apart. */
static void gram_of_order(int k, const hobe_real *at, ptrdiff_t order, hobe_real *n, hobe_real *s)
{
    hobe_real half[3 * S], more_n[NN], more_s[NS];
    for (int i = 0; i < NN; i++)
        n[i] = zero;
    for (int i = 0; i < NS; i++)
        s[i] = zero;
    for (int i = 1; i <= k / 2; i++) {
        const double weight = 2 * i < k ? 1.0 : 0.5;
        for (int a = 0; a < 3 * S; a++)
            half[a] = weight * at[i * order + a];
        differences(half, at + (k - i) * order, more_n, more_s);
        add_to(n, more_n, NN);
        add_to(s, more_s, NS);
    }
}

/* P = sum of sigma_i D_(k-i), i = 1 .. k. */
static void force_of_order(int k, const hobe_real *at, ptrdiff_t order, hobe_real *P)
{
    hobe_real more[3 * S];
    for (int i = 0; i < 3 * S; i++)
        P[i] = zero;
    for (int i = 1; i <= k; i++) {
        const hobe_real *sigma = at + i * order + 3 * S;
        section_force(sigma, sigma + NN, at + (k - i) * order, more);
        add_to(P, more, 3 * S);
    }
}

/* sigma += Q s(B, D), what completes an order: with D_0 of the state and D_m, m > 0; or with
 * B = D0 + U/2 and U of the state itself. */
static void add_stress(const double *Qn, const double *Qs, const double *Qc, const hobe_real *B,
                       const hobe_real *D, hobe_real *sigma)
{
    hobe_real n[NN], s[NS], tn[NN], ts[NS];
    differences(B, D, n, s);
    stress(Qn, Qs, Qc, n, s, tn, ts);
    add_to(sigma, tn, NN);
    add_to(sigma + NN, ts, NS);
}

/* The first order: D_0 = D0 + U and sigma_0 of the state, from the reference x0. */
static void begin_series(const double *N, const double *Nx, const double *Qn, const double *Qs,
                         const double *Qc, const hobe_real *x0, hobe_real *at)
{
    hobe_real D0[3 * S], B[3 * S];
    section_vectors(N, Nx, x0, D0);
    for (int i = 0; i < 3 * S; i++)
        B[i] = D0[i] + 0.5 * at[i];
    for (int i = 3 * S; i < KEPT; i++)
        at[i] = zero;
    add_stress(Qn, Qs, Qc, B, at, at + 3 * S);
    add_to(at, D0, 3 * S);
}

static void series_part(const struct hobe_invariants *inv, int k, const hobe_real *q0,
                        const hobe_real *u, hobe_real *table, hobe_real *f)
{
    const ptrdiff_t order = (ptrdiff_t)HOBE_PARTS * inv->stations * KEPT;
    hobe_real x0[3 * V], x[3 * V], P[3 * S], n[NN], s[NS];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g, *Qs = inv->Qs + inv->step_s * g;
        const double *Qc = inv->Qc ? inv->Qc + inv->step_c * g : NULL;
        hobe_real *at = table + KEPT * g, *next = at + k * order;
        section_vectors(N, Nx, x, next - order);
        if (k > 1)
            add_stress(Qn, Qs, Qc, at, next - order, next - order + 3 * S);
        else
            begin_series(N, Nx, Qn, Qs, Qc, x0, at);
        gram_of_order(k, at, order, n, s);
        stress(Qn, Qs, Qc, n, s, next + 3 * S, next + 3 * S + NN);
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
