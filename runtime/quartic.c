/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "quartic.h"

#include "kernel.h"

#include <string.h>

static quartic_product *choose_product(void)
{
#ifdef HOBE_AVX2
    if (strcmp(hobe_machine(), "portable") != 0)
        return quartic_multiply_avx2;
#endif
    return quartic_multiply_portable;
}

/* ---- the tensor ------------------------------------------------------------------------------ */

static double entry(const struct quartic *q, const double *A, long i, long j, long k, long l)
{
    const long pairs = form_pairs(q->n + 1), p = form_pair(i, j), r = form_pair(k, l);
    return p > r ? A[p * pairs + r] : A[r * pairs + p];
}

/* Row (i, j) of T, as far as the block of the diagonal reaches. */
static void fill_row(const struct quartic *q, const double *A, long i, long j)
{
    const long p = form_pair(i, j), end = (p / QUARTIC_ROWS + 1) * QUARTIC_ROWS;
    double *row = q->T + quartic_row(p);
    for (long k = 0; k <= q->n; k++)
        for (long l = 0; l <= k && form_pair(k, l) < end; l++)
            row[form_pair(k, l)] =
                4 * (entry(q, A, i, j, k, l) + entry(q, A, i, k, j, l) + entry(q, A, i, l, j, k));
}

enum hobe_status quartic_open(struct quartic *q, const hobe_model *model, const double *centre,
                              long n, const double *field, struct hobe_error *err)
{
    double *A;
    const long blocks = (form_pairs(n + 1) + QUARTIC_ROWS - 1) / QUARTIC_ROWS;
    *q = (struct quartic){.n = n, .pairs = blocks * QUARTIC_ROWS, .multiply = choose_product()};
    const enum hobe_status status = strain_form(model, centre, n, field, &A, err);
    if (status)
        return status;
    q->T = hobe_alloc((size_t)quartic_row(q->pairs), sizeof *q->T, err);
    q->work = hobe_alloc((size_t)(2 * q->pairs), sizeof *q->work, err);
    const int there = q->T && q->work;
    for (long i = 0; there && i <= n; i++)
        for (long j = 0; j <= i; j++)
            fill_row(q, A, i, j);
    hobe_free(A);
    if (!there)
        quartic_close(q);
    return there ? HOBE_OK : HOBE_NO_MEMORY;
}

void quartic_close(struct quartic *q)
{
    hobe_free(q->T);
    hobe_free(q->work);
    *q = (struct quartic){.n = 0};
}

double quartic_bytes(const struct quartic *q)
{
    return (double)quartic_row(q->pairs) * sizeof *q->T;
}

/* ---- the energy ------------------------------------------------------------------------------ */

/* h = the pairs of (1, q), twice where i > j; Y = T h, which is returned. */
static const double *contract(const struct quartic *q, const double *x)
{
    double *h = q->work, *Y = h + q->pairs;
    long p = 0;
    h[p++] = 1;
    for (long i = 0; i < q->n; i++) {
        h[p++] = 2 * x[i];
        for (long j = 0; j < i; j++)
            h[p++] = 2 * x[i] * x[j];
        h[p++] = x[i] * x[i];
    }
    q->multiply(q->pairs, q->T, h, Y);
    return Y;
}

double quartic_energy(const struct quartic *q, const double *x)
{
    const double *Y = contract(q, x);
    double energy = 0;
    for (long p = 0; p < q->pairs; p++)
        energy += q->work[p] * Y[p] / 24;
    return energy;
}

void quartic_add(const struct quartic *q, const double *x, double *f, double *K)
{
    const double *Y = contract(q, x) + 1;
    for (long i = 0; i < q->n; i++, Y += i + 1) {
        double sum = Y[0] + Y[i + 1] * x[i];
        for (long j = 0; j < i; j++) {
            sum += Y[j + 1] * x[j];
            f[j] += Y[j + 1] * x[i] / 6;
        }
        f[i] += sum / 6;
        for (long j = 0; K && j <= i; j++) {
            K[i * q->n + j] += Y[j + 1] / 2;
            if (j < i)
                K[j * q->n + i] += Y[j + 1] / 2;
        }
    }
}
