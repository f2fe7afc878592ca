/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A block of rows is used twice while it is in registers: with x for its own part of y, and
 * transposed for all before. */
#include "quartic_product.h"

#include "kernel.h"

#ifdef __AVX2__
#define MULTIPLY quartic_multiply_avx2
#else
#define MULTIPLY quartic_multiply_portable
#endif

enum { LANES = sizeof(hobe_real) / sizeof(double) };

static double sum_of(hobe_real x)
{
    double sum = 0;
    for (int i = 0; i < LANES; i++)
        sum += x[i];
    return sum;
}

void MULTIPLY(long n, const double *T, const double *x, double *y)
{
    for (long i = 0; i < n; i += QUARTIC_ROWS) {
        const long width = i + QUARTIC_ROWS;
        const double *a = T, *b = a + width, *c = b + width, *d = c + width;
        hobe_real s0 = {0}, s1 = {0}, s2 = {0}, s3 = {0};
        for (long k = 0; k < i; k += LANES) {
            const hobe_real ak = *(const hobe_real *)(a + k), bk = *(const hobe_real *)(b + k);
            const hobe_real ck = *(const hobe_real *)(c + k), dk = *(const hobe_real *)(d + k);
            const hobe_real xk = *(const hobe_real *)(x + k);
            s0 += ak * xk;
            s1 += bk * xk;
            s2 += ck * xk;
            s3 += dk * xk;
            *(hobe_real *)(y + k) += (ak * x[i] + bk * x[i + 1]) + (ck * x[i + 2] + dk * x[i + 3]);
        }
        const double before[] = {sum_of(s0), sum_of(s1), sum_of(s2), sum_of(s3)};
        for (int r = 0; r < QUARTIC_ROWS; r++, T += width)
            y[i + r] = before[r] + T[i] * x[i] + T[i + 1] * x[i + 1] + T[i + 2] * x[i + 2] +
                       T[i + 3] * x[i + 3];
    }
}
