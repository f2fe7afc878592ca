/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vectors of three, and the product of longer ones. */
#ifndef HOBE_VECTOR3_H
#define HOBE_VECTOR3_H

#include <math.h>

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double dot(long n, const double *a, const double *b)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

static inline double length3(const double a[3])
{
    return hypot(hypot(a[0], a[1]), a[2]);
}

/* c = a x b; c must be neither. */
static inline void cross3(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* c += factor a */
static inline void add3(double factor, const double a[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] += factor * a[i];
}

/* c += a x b */
static inline void add_cross3(const double a[3], const double b[3], double c[3])
{
    double product[3];
    cross3(a, b, product);
    add3(1, product, c);
}

/* B = factor A */
static inline void times3(double factor, const double A[3][3], double B[3][3])
{
    for (int i = 0; i < 9; i++)
        B[i / 3][i % 3] = factor * A[i / 3][i % 3];
}

/* t[0] = axis/|axis| and two more that make a right-handed triad with it, rows. */
static inline void triad3(const double axis[3], double t[3][3])
{
    const double length = length3(axis);
    int least = 0;
    for (int a = 0; a < 3; a++) {
        t[0][a] = axis[a] / length;
        least = fabs(axis[a]) < fabs(axis[least]) ? a : least;
    }
    const double other[3] = {least == 0, least == 1, least == 2};
    cross3(t[0], other, t[1]);
    const double across = length3(t[1]);
    for (int a = 0; a < 3; a++)
        t[1][a] /= across;
    cross3(t[0], t[1], t[2]);
}

#endif
