/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The elastic energy of a whole model on a few fields, exactly, by the quadratic form in its
 * strains (strain_form.h).
 *
 * On u = u_c + sum_i q_i phi_i, i = 1 ... n, with q_0 = 1, it is the homogeneous quartic form
 *
 *     U = 1/24 T_ijkl q_i q_j q_k q_l,    i, j, k, l = 0 ... n,
 *     T_ijkl = 4 (A_{ij,kl} + A_{ik,jl} + A_{il,jk}),
 *
 * symmetric in all indices and kept as a symmetric matrix of pairs i >= j.  One product with the
 * pairs q_k q_l gives all: by Y_ij = T_ijkl q_k q_l, and Euler's theorem,
 *
 *     dU/dq_i = 1/6 Y_ij q_j,    d2U/dq_i dq_j = 1/2 Y_ij,
 *
 * at a cost of n^4/4 that knows nothing of the number of elements. */
#ifndef HOBE_QUARTIC_H
#define HOBE_QUARTIC_H

#include "quartic_product.h"
#include "strain_form.h"

struct quartic {
    long n;     /* fields */
    long pairs; /* of 0 ... n, and spare ones up to a multiple of QUARTIC_ROWS, all zero */
    quartic_product *multiply;
    double *T;    /* by quartic_row */
    double *work; /* [2][pairs] */
};

/* The energy of all elements of a built model about the centre u_c[vectors][3] (NULL: the
 * reference) on the fields field[n][vectors][3], displacements; both are read at vectors that are
 * no aliases.  HOBE_BAD_INPUT where an element's energy is not quartic. */
enum hobe_status quartic_open(struct quartic *quartic, const hobe_model *model,
                              const double *centre, long n, const double *field,
                              struct hobe_error *err);
void quartic_close(struct quartic *quartic);

/* Memory of the tensor. */
double quartic_bytes(const struct quartic *quartic);

/* U(q), J.  Not for two threads at once, like the next: they share work. */
double quartic_energy(const struct quartic *quartic, const double *q);

/* f[n] += dU/dq and, unless NULL, K[n][n] += d2U/dq2. */
void quartic_add(const struct quartic *quartic, const double *q, double *f, double *K);

#endif
