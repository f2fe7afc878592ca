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

#endif
