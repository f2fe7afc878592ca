/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The elastic energy of a whole model on a few fields, exactly.
 *
 * With x = x_c + sum_i q_i phi_i, x_c = x0 + u_c, the strains of every station are differences of a
 * bilinear measure s of section vectors (kernel.h),
 *
 *     s(x, x) - s(x0, x0) = s(u_c, x0 + x_c) + 2 sum_i q_i s(x_c, phi_i) + sum_ij q_i q_j
 *                           s(phi_i, phi_j),
 *
 * and the energy is 1/2 h'A h in h = (1, q_i, q_i q_j), A = sum of S'Q S over the stations,
 * positive semidefinite where the elastic law is.  So it has five tensors, the derivatives at q =
 * 0,
 *
 *     U = k0 + k1 q + 1/2 k2:qq + 1/6 k3:qqq + 1/24 k4:qqqq,
 *
 * symmetric in all their indices.  They are kept by pairs i >= j, k4 by pairs of pairs, so that one
 * product with the pairs q_i q_j gives force and tangent, at a cost of n^4/4 that knows nothing of
 * the number of elements. */
#ifndef HOBE_QUARTIC_H
#define HOBE_QUARTIC_H

#include "model.h"

struct quartic {
    long n;               /* fields */
    long pairs;           /* n (n + 1)/2, and zeros up to a multiple of QUARTIC_ALIGN */
    double k0;            /* J */
    double *k1, *k2, *k3; /* [n], [pairs], [n][pairs] */
    double *k4;           /* rows of pairs, QUARTIC_ALIGN of them at a time up to their diagonal */
    double *work;         /* [3][pairs] */
};

enum { QUARTIC_ALIGN = 4 };

/* The energy of all elements of a built model about the centre u_c[vectors][3] (NULL: the
 * reference) on the fields field[n][vectors][3], displacements whose vectors agree with their
 * aliases.  HOBE_BAD_INPUT where an element's energy is not quartic. */
enum hobe_status quartic_open(struct quartic *quartic, const hobe_model *model,
                              const double *centre, long n, const double *field,
                              struct hobe_error *err);
void quartic_close(struct quartic *quartic);

/* U(q), J.  Not for two threads at once, like the next: they share work. */
double quartic_energy(const struct quartic *quartic, const double *q);

/* f[n] += dU/dq and, unless NULL, K[n][n] += d2U/dq2. */
void quartic_add(const struct quartic *quartic, const double *q, double *f, double *K);

#endif
