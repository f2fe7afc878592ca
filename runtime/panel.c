/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Columns are eliminated six (or three) at a time: each tile of rows takes in all earlier columns
 * in registers, then the six themselves. */
#include "panel.h"

#include "kernel.h"

#include <string.h>

/* hobe_real at an address that is not aligned to it */
typedef double unaligned __attribute__((vector_size(sizeof(hobe_real)), aligned(8), may_alias));

enum { LANES = sizeof(hobe_real) / sizeof(double), TALL = 2, HEAD = 8 / LANES };

#define INLINE static inline __attribute__((always_inline))

/* sum[t][c] -= sum over k < depth of l[k][t] b[k][c]; `tall` registers of rows, `wide` columns. */
INLINE void subtract_products(const int tall, const int wide, long depth, long stride,
                              const double *l, const double *b, hobe_real sum[][PANEL_WIDE])
{
    for (long k = 0; k < depth; k++) {
        hobe_real x[HEAD];
        for (int t = 0; t < tall; t++)
            x[t] = *(const unaligned *)(l + k * stride + t * LANES);
        for (int c = 0; c < wide; c++)
            for (int t = 0; t < tall; t++)
                sum[t][c] -= x[t] * b[k * wide + c];
    }
}

/* b[k][c] = d_k L(j + c, k), k < depth */
INLINE void weigh_rows(const int wide, long depth, long stride, long j, const double *a,
                       const double *d, double *b)
{
    for (long k = 0; k < depth; k++)
        for (int c = 0; c < wide; c++)
            b[k * wide + c] = d[k] * a[k * stride + j + c];
}

/* L of the diagonal block of columns j ..., l[c][r], zero for r <= c; its d[c] and 1/d[c]. */
INLINE void factor_diagonal(const int wide, long stride, long j, const double *a, const double *b,
                            double l[][PANEL_WIDE], double *d, double *inverse)
{
    hobe_real sum[HEAD][PANEL_WIDE];
    double t[PANEL_WIDE][HEAD * LANES];
    for (int c = 0; c < wide; c++)
        for (int h = 0; h < HEAD; h++)
            sum[h][c] = *(const unaligned *)(a + (j + c) * stride + j + h * LANES);
    subtract_products(HEAD, wide, j, stride, a + j, b, sum);
    for (int c = 0; c < wide; c++)
        for (int h = 0; h < HEAD; h++)
            memcpy(t[c] + h * LANES, &sum[h][c], sizeof sum[h][c]);
#pragma GCC unroll 6
    for (int c = 0; c < wide; c++) {
        d[c] = t[c][c];
        inverse[c] = 1 / d[c];
#pragma GCC unroll 6
        for (int r = 0; r < wide; r++)
            l[c][r] = r > c ? t[c][r] * inverse[c] : 0;
#pragma GCC unroll 6
        for (int e = c + 1; e < wide; e++)
#pragma GCC unroll 6
            for (int r = e; r < wide; r++)
                t[e][r] -= t[c][r] * l[c][e];
    }
}

/* L of a tile of rows, in place: columns j .. j + wide - 1, behind all earlier ones. */
INLINE void solve_rows(const int tall, const int wide, long stride, long j, double *a,
                       const double *b, double l[][PANEL_WIDE], const double *inverse)
{
    hobe_real sum[TALL][PANEL_WIDE];
    for (int c = 0; c < wide; c++)
        for (int t = 0; t < tall; t++)
            sum[t][c] = *(const hobe_real *)(a + (j + c) * stride + t * LANES);
    subtract_products(tall, wide, j, stride, a, b, sum);
#pragma GCC unroll 6
    for (int c = 0; c < wide; c++)
#pragma GCC unroll 2
        for (int t = 0; t < tall; t++) {
#pragma GCC unroll 6
            for (int e = c + 1; e < wide; e++)
                sum[t][e] -= sum[t][c] * l[c][e];
            *(hobe_real *)(a + (j + c) * stride + t * LANES) = sum[t][c] * inverse[c];
        }
}

INLINE void factor_columns(const int wide, long stride, long j, double *a, double *d, double *b)
{
    double l[PANEL_WIDE][PANEL_WIDE], inverse[PANEL_WIDE];
    weigh_rows(wide, j, stride, j, a, d, b);
    factor_diagonal(wide, stride, j, a, b, l, d + j, inverse);
    long i = (j + wide) / LANES * LANES;
    for (; i + TALL * LANES <= stride; i += TALL * LANES)
        solve_rows(TALL, wide, stride, j, a + i, b, l, inverse);
    for (; i < stride; i += LANES)
        solve_rows(1, wide, stride, j, a + i, b, l, inverse);
    for (int c = 0; c < wide; c++) /* the first tile may have begun above */
        memcpy(a + (j + c) * stride + j, l[c], (size_t)wide * sizeof *a);
}

static void factor(long rows, long columns, long stride, double *a, double *d, double *room)
{
    (void)rows;
    long j = 0;
    for (; j + PANEL_WIDE <= columns; j += PANEL_WIDE)
        factor_columns(PANEL_WIDE, stride, j, a, d, room);
    if (j < columns)
        factor_columns(PANEL_STEP, stride, j, a, d, room);
}

INLINE void update_rows(const int tall, const int wide, long columns, long stride, const double *a,
                        const double *b, double *w)
{
    hobe_real sum[TALL][PANEL_WIDE] = {0};
    subtract_products(tall, wide, columns, stride, a, b, sum);
    for (int c = 0; c < wide; c++)
        for (int t = 0; t < tall; t++)
            *(hobe_real *)(w + c * stride + t * LANES) = sum[t][c];
}

INLINE void update_columns(const int wide, long columns, long stride, long j, const double *a,
                           const double *d, double *w, double *b)
{
    weigh_rows(wide, columns, stride, j, a, d, b);
    long i = j / LANES * LANES;
    for (; i + TALL * LANES <= stride; i += TALL * LANES)
        update_rows(TALL, wide, columns, stride, a + i, b, w + i);
    for (; i < stride; i += LANES)
        update_rows(1, wide, columns, stride, a + i, b, w + i);
}

static void update(long rows, long columns, long stride, const double *a, const double *d,
                   double *w, double *room)
{
    long j = columns;
    for (; j + PANEL_WIDE <= rows; j += PANEL_WIDE)
        update_columns(PANEL_WIDE, columns, stride, j, a, d, w + (j - columns) * stride, room);
    if (j < rows)
        update_columns(PANEL_STEP, columns, stride, j, a, d, w + (j - columns) * stride, room);
}

/* Three columns at once; their own 3 x 3 triangle first. */
static void forward(long columns, long stride, const double *a, double *v)
{
    for (long k = 0; k < columns; k += PANEL_STEP) {
        const double *l0 = a + k * stride, *l1 = l0 + stride, *l2 = l1 + stride;
        const double x0 = v[k], x1 = v[k + 1] - l0[k + 1] * x0;
        const double x2 = v[k + 2] - l0[k + 2] * x0 - l1[k + 2] * x1;
        for (long i = k / LANES * LANES; i < stride; i += LANES)
            *(hobe_real *)(v + i) -= x0 * *(const hobe_real *)(l0 + i) +
                                     x1 * *(const hobe_real *)(l1 + i) +
                                     x2 * *(const hobe_real *)(l2 + i);
        v[k] = x0;
        v[k + 1] = x1;
        v[k + 2] = x2;
    }
}

static void backward(long columns, long stride, const double *a, double *v)
{
    for (long k = columns - PANEL_STEP; k >= 0; k -= PANEL_STEP) {
        const double *l0 = a + k * stride, *l1 = l0 + stride, *l2 = l1 + stride;
        double x0 = v[k], x1 = v[k + 1], x2 = v[k + 2];
        hobe_real s0 = {0}, s1 = {0}, s2 = {0};
        v[k] = v[k + 1] = v[k + 2] = 0; /* the triangle comes last */
        for (long i = k / LANES * LANES; i < stride; i += LANES) {
            const hobe_real x = *(const hobe_real *)(v + i);
            s0 += x * *(const hobe_real *)(l0 + i);
            s1 += x * *(const hobe_real *)(l1 + i);
            s2 += x * *(const hobe_real *)(l2 + i);
        }
        for (int t = 0; t < LANES; t++) {
            x0 -= s0[t];
            x1 -= s1[t];
            x2 -= s2[t];
        }
        v[k + 2] = x2;
        v[k + 1] = x1 - l1[k + 2] * x2;
        v[k] = x0 - l0[k + 1] * v[k + 1] - l0[k + 2] * x2;
    }
}

#ifdef __AVX2__
const struct panel_functions panel_avx2 = {factor, update, forward, backward};
#else
const struct panel_functions panel_portable = {factor, update, forward, backward};
#endif
