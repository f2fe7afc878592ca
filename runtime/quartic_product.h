/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Products of a packed symmetric matrix with a vector, each number read once.
 *
 * Rows come QUARTIC_ROWS at a time, each as long as the block that ends with the diagonal.  The
 * function exists twice, for registers of AVX2 and portably: hobe_machine says which goes. */
#ifndef HOBE_QUARTIC_PRODUCT_H
#define HOBE_QUARTIC_PRODUCT_H

enum { QUARTIC_ROWS = 4 };

/* Where row i begins; with i the size of the matrix, how many numbers it has. */
static inline long quartic_row(long i)
{
    const long block = i / QUARTIC_ROWS, width = QUARTIC_ROWS * (block + 1);
    return QUARTIC_ROWS * QUARTIC_ROWS * block * (block + 1) / 2 + i % QUARTIC_ROWS * width;
}

/* y[n] = T x[n], n a multiple of QUARTIC_ROWS, all aligned to 32 bytes. */
typedef void quartic_product(long n, const double *T, const double *x, double *y);

quartic_product quartic_multiply_portable, quartic_multiply_avx2; /* that one if HOBE_AVX2 */

#endif
