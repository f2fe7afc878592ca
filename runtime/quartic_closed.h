/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The elastic energy of a whole model on scalar functions that have vectors for coefficients,
 * exactly: a basis that is closed under 3 x 3 maps, and so holds every rotation of what it holds.
 *
 * On x = x0 + sum_b function_b q_b = sum_a chi_a c_a (strain_form.h) the strains are linear in the
 * Gram differences g of the c, U = 1/2 g'A g, and with s_ab = A_{ab,cd} g_cd, summed over all c, d,
 *
 *     dU/dq_b = 2 s_ab c_a,    d2U/dq_a dq_b = 2 s_ab I + 4 A_{ac,bd} c_c c_d',
 *
 * eqs. 27 and 28 of Tang, Tian & Hu 2022 for the whole model as one element. */
#ifndef HOBE_QUARTIC_CLOSED_H
#define HOBE_QUARTIC_CLOSED_H

#include "strain_form.h"

struct quartic_closed {
    long n;       /* functions */
    long pairs;   /* of them and the three of the reference */
    double *A;    /* [pairs][pairs] J */
    double *work; /* c[n + 3][3]; g and s[pairs]; G[3][pairs] */
};

/* The energy of all elements of a built model on function[n][vectors], which are read at vectors
 * that are no aliases.  A rotation is exact where the reference is in their span.  HOBE_BAD_INPUT
 * where an element's energy is not quartic. */
enum hobe_status quartic_closed_open(struct quartic_closed *closed, const hobe_model *model, long n,
                                     const double *function, struct hobe_error *err);
void quartic_closed_close(struct quartic_closed *closed);

/* U(q), J, of q[n][3].  Not for two threads at once, like the next: they share work. */
double quartic_closed_energy(const struct quartic_closed *closed, const double *q);

/* f[n][3] += dU/dq and, unless NULL, K[3 n][3 n] += d2U/dq2. */
void quartic_closed_add(const struct quartic_closed *closed, const double *q, double *f, double *K);

#endif
