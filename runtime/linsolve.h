/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sparse linear systems behind four functions: analyse, factor, solve, free.  The only room that
 * talks to SuiteSparse. */
#ifndef HOBE_LINSOLVE_H
#define HOBE_LINSOLVE_H

#include "error.h"

typedef struct hobe_linsolve hobe_linsolve;

/* Ordering and symbolic factorisation, once per sparsity pattern.  Compressed columns: n, Ap[n+1],
 * Ai[Ap[n]] with ascending rows; both must outlive the solver and are not modified. */
hobe_linsolve *hobe_linsolve_analyse(long n, long *Ap, long *Ai, struct hobe_error *err);

/* order[n]: an order of elimination, by least degree, of a symmetric pattern in compressed columns.
 */
enum hobe_status hobe_linsolve_order(long n, const long *Ap, const long *Ai, long *order,
                                     struct hobe_error *err);

/* LU factors, with partial pivoting, of S A S with S = diag(scale): Ax[Ap[n]] and scale[n] are not
 * modified.  HOBE_SINGULAR with *column set to the column of the vanishing pivot (-1 if unknown).
 */
enum hobe_status hobe_linsolve_factor(hobe_linsolve *solver, const double *Ax, const double *scale,
                                      long *column, struct hobe_error *err);

/* Solves A x = b with the last factors; b[n] is overwritten by x. */
enum hobe_status hobe_linsolve_solve(hobe_linsolve *solver, double *b, struct hobe_error *err);

/* How many eigenvalues of the symmetric matrix that was factored last are negative: Sylvester's
 * law, by the signs of the pivots; -1 where a pivot was taken off the diagonal. */
long hobe_linsolve_negative(const hobe_linsolve *solver);

void hobe_linsolve_free(hobe_linsolve *solver);

#endif
