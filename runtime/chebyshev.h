/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Smooth functions of one variable as Chebyshev series: sampled once, then known everywhere with
 * their derivatives. */
#ifndef HOBE_CHEBYSHEV_H
#define HOBE_CHEBYSHEV_H

#include "hobe.h"

enum { HOBE_CHEBYSHEV_ORDERS = 2 }; /* the highest derivative on offer */

/* f(t) = sum_k c[k][values] T_k(2 t - 1), t in [0,1].  All zero: no series. */
struct hobe_chebyshev {
    int values, terms;
    double *c;
};

/* The series of `function`, which gives `values` numbers of like magnitude at t in [0,1].
 *
 * It interpolates at the n + 1 extrema of T_n, n = 16, 32, ..., 512, until all coefficients of its
 * second half are below `tolerance` times the largest |value| met; as those of an analytic function
 * fall geometrically, the error is then near the tolerance's square, or rounding.  Terms below
 * rounding are cut off.
 *
 * Sentences call the function `name`.  HOBE_BAD_INPUT where a value is not finite or 512 terms do
 * not follow the function, with the t at fault; else the function's own status.  The caller frees
 * the series; a failure leaves none. */
enum hobe_status hobe_chebyshev_fit(struct hobe_chebyshev *series, int values,
                                    hobe_function *function, void *context, double tolerance,
                                    const char *name, struct hobe_error *err);
void hobe_chebyshev_free(struct hobe_chebyshev *series);

/* f[orders + 1][values]: the values at t and their derivatives by t up to the given order. */
void hobe_chebyshev_at(const struct hobe_chebyshev *series, double t, int orders, double *f);

#endif
