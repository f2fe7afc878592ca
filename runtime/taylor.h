/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arithmetic of power series, cut off behind an order: x(a) = sum over k <= order of x[k] a^k.
 * Results are no arguments. */
#ifndef HOBE_TAYLOR_H
#define HOBE_TAYLOR_H

enum { TAYLOR_ORDER = 24 }; /* the highest order there is */

typedef double taylor[TAYLOR_ORDER + 1];
typedef double taylor3[TAYLOR_ORDER + 1][3]; /* of vectors */

/* c += factor a b */
static inline void taylor_scale(int order, const taylor a, const taylor3 b, double factor,
                                taylor3 c)
{
    for (int k = 0; k <= order; k++)
        for (int i = 0; i <= k; i++)
            for (int x = 0; x < 3; x++)
                c[k][x] += factor * a[i] * b[k - i][x];
}

/* c += factor a . b */
static inline void taylor_dot(int order, const taylor3 a, const taylor3 b, double factor, taylor c)
{
    for (int k = 0; k <= order; k++)
        for (int i = 0; i <= k; i++)
            for (int x = 0; x < 3; x++)
                c[k] += factor * a[i][x] * b[k - i][x];
}

/* c += a x b */
static inline void taylor_cross(int order, const taylor3 a, const taylor3 b, taylor3 c)
{
    for (int k = 0; k <= order; k++)
        for (int i = 0; i <= k; i++)
            for (int x = 0; x < 3; x++) {
                const int y = (x + 1) % 3, z = (x + 2) % 3;
                c[k][x] += a[i][y] * b[k - i][z] - a[i][z] * b[k - i][y];
            }
}

/* c = factor a / b, by c b = factor a: b[0] is not 0. */
static inline void taylor_divide(int order, const taylor3 a, const taylor b, double factor,
                                 taylor3 c)
{
    for (int k = 0; k <= order; k++)
        for (int x = 0; x < 3; x++) {
            double sum = factor * a[k][x];
            for (int i = 1; i <= k; i++)
                sum -= b[i] * c[k - i][x];
            c[k][x] = sum / b[0];
        }
}

/* c = |b|, by c c = b . b: b[0] is not 0. */
static inline void taylor_length(int order, const taylor3 b, taylor c)
{
    for (int k = 0; k <= order; k++) {
        double sum = 0;
        for (int i = 0; i <= k; i++)
            for (int x = 0; x < 3; x++)
                sum += b[i][x] * b[k - i][x];
        for (int i = 1; i < k; i++)
            sum -= c[i] * c[k - i];
        c[k] = k ? sum / (2 * c[0]) : __builtin_sqrt(sum);
    }
}

#endif
