/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strains of a whole model on a few fields, and the quadratic form of its energy in them.
 *
 * Strains are differences of a bilinear measure s of section vectors (kernel.h).  On the affine
 * space x = sum_i q_i phi_i, i = 0 ... n, with phi_0 = x_c = x0 + u_c and q_0 = 1,
 *
 *     s(x, x) - s(x0, x0) = s_00 + 2 sum_i q_i s(x_c, phi_i) + sum_ij q_i q_j s(phi_i, phi_j),
 *     s_00 = s(u_c, x0 + x_c),
 *
 * so that the energy is U = 1/2 h'A h of the pairs h = (q_i q_j, i >= j, twice where i > j), where
 * A = sum of S'Q S over the stations of all elements: positive semidefinite where the elastic law
 * is. */
#ifndef HOBE_STRAIN_FORM_H
#define HOBE_STRAIN_FORM_H

#include "model.h"

/* The place of a pair (i, j) in a packed triangle, and how many there are of n. */
static inline long form_pair(long i, long j)
{
    return i > j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}
static inline long form_pairs(long n)
{
    return n * (n + 1) / 2;
}

/* *A[pairs][pairs], J, its lower triangle, pairs = form_pairs(n + 1), to be freed by hobe_free:
 * about a centre u_c[vectors][3] (NULL: the reference) on displacements field[n][vectors][3], both
 * read at vectors that are no aliases.  HOBE_BAD_INPUT where an element's energy is not quartic. */
enum hobe_status strain_form(const hobe_model *model, const double *centre, long n,
                             const double *field, double **A, struct hobe_error *err);

/* The same by functions[n][vectors] that have vectors for coefficients,
 *
 *     x = x0 + sum_b function_b q_b = sum_a chi_a c_a,    q_b in R^3,
 *
 * where chi are the three components of x0 and the functions, c = (e_1, e_2, e_3, q_1, ...): pairs
 * = form_pairs(n + 3), and h = (c_a.c_b less its value in the reference, a >= b, twice where a >
 * b), which vanishes where both are of the first three. */
enum hobe_status strain_form_closed(const hobe_model *model, long n, const double *function,
                                    double **A, struct hobe_error *err);

#endif
