/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "quartic_closed.h"

#include <string.h>

enum { REFERENCE = 3 }; /* functions of the reference, before those given */

enum hobe_status quartic_closed_open(struct quartic_closed *closed, const hobe_model *model, long n,
                                     const double *function, struct hobe_error *err)
{
    const long all = n + REFERENCE, pairs = form_pairs(all);
    *closed = (struct quartic_closed){.n = n, .pairs = pairs};
    enum hobe_status status = strain_form_closed(model, n, function, &closed->A, err);
    if (status)
        return status;
    closed->work = hobe_alloc((size_t)(3 * all + 5 * pairs), sizeof *closed->work, err);
    if (!closed->work) {
        quartic_closed_close(closed);
        return HOBE_NO_MEMORY;
    }
    for (long p = 0; p < pairs; p++)
        for (long r = 0; r < p; r++)
            closed->A[r * pairs + p] = closed->A[p * pairs + r];
    return HOBE_OK;
}

void quartic_closed_close(struct quartic_closed *closed)
{
    hobe_free(closed->A);
    hobe_free(closed->work);
    *closed = (struct quartic_closed){.n = 0};
}

/* y += factor A_p, a row. */
static void add_row(const struct quartic_closed *closed, long p, double factor, double *y)
{
    const double *row = closed->A + p * closed->pairs;
    for (long r = 0; r < closed->pairs; r++)
        y[r] += factor * row[r];
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Fills c, the differences g of pairs, and s = A g, which is returned. */
static const double *find_stresses(const struct quartic_closed *closed, const double *q)
{
    const long n = closed->n, pairs = closed->pairs;
    double *c = closed->work, *g = c + 3 * (REFERENCE + n), *s = g + pairs;
    for (long a = 0; a < REFERENCE; a++)
        for (long x = 0; x < 3; x++)
            c[3 * a + x] = a == x;
    memcpy(c + 3 * REFERENCE, q, (size_t)(3 * n) * sizeof *q);
    memset(g, 0, (size_t)(2 * pairs) * sizeof *g);
    for (long a = REFERENCE; a < REFERENCE + n; a++)
        for (long b = 0; b <= a; b++) {
            const long p = form_pair(a, b);
            g[p] = (a == b ? 1 : 2) * dot(c + 3 * a, c + 3 * b);
            add_row(closed, p, g[p], s);
        }
    return s;
}

double quartic_closed_energy(const struct quartic_closed *closed, const double *q)
{
    const double *s = find_stresses(closed, q), *g = s - closed->pairs;
    double energy = 0;
    for (long p = 0; p < closed->pairs; p++)
        energy += 0.5 * g[p] * s[p];
    return energy;
}

/* The rows x of function a: K += 2 s_ab I + 4 G_{a,bd} c_d', G_{a,bd} = sum_c A_{ac,bd} c_c. */
static void add_tangent(const struct quartic_closed *closed, long a, const double *s, double *K)
{
    const long all = REFERENCE + closed->n, pairs = closed->pairs, size = 3 * closed->n;
    const double *c = closed->work;
    double *G = closed->work + 3 * all + 2 * pairs;
    memset(G, 0, (size_t)(3 * pairs) * sizeof *G);
    for (long e = 0; e < all; e++)
        for (long x = 0; x < 3; x++)
            if (c[3 * e + x] != 0) /* of the reference's only one is not */
                add_row(closed, form_pair(a, e), c[3 * e + x], G + x * pairs);
    for (long x = 0; x < 3; x++)
        for (long b = REFERENCE; b < all; b++) {
            double *to = K + (3 * (a - REFERENCE) + x) * size + 3 * (b - REFERENCE);
            to[x] += 2 * s[form_pair(a, b)];
            for (long d = 0; d < all; d++)
                for (long y = 0; y < 3; y++)
                    to[y] += 4 * G[x * pairs + form_pair(b, d)] * c[3 * d + y];
        }
}

void quartic_closed_add(const struct quartic_closed *closed, const double *q, double *f, double *K)
{
    const long all = REFERENCE + closed->n;
    const double *s = find_stresses(closed, q), *c = closed->work;
    for (long b = REFERENCE; b < all; b++) {
        for (long a = 0; a < all; a++)
            for (long x = 0; x < 3; x++)
                f[3 * (b - REFERENCE) + x] += 2 * s[form_pair(a, b)] * c[3 * a + x];
        if (K)
            add_tangent(closed, b, s, K);
    }
}
