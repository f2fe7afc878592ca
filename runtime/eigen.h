/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Eigenproblems, and products of dense matrices.  The only room that talks to BLAS, LAPACK and
 * ARPACK. */
#ifndef HOBE_EIGEN_H
#define HOBE_EIGEN_H

#include "error.h"

/* Eigenvalues, ascending, of a dense symmetric matrix A[n][n] (destroyed). */
enum hobe_status hobe_eigenvalues(int n, double *A, double *eigenvalue, struct hobe_error *err);

/* How many eigenvalues of a dense symmetric matrix A[n][n] (destroyed) are negative. */
enum hobe_status eigen_count_negative(int n, double *A, long *negative, struct hobe_error *err);

/* All pairs of M x = nu K x, dense and symmetric, [n][n], K positive definite: nu[n] ascending, the
 * vectors as rows of M with x'Kx = 1; K is destroyed.  *definite is 0, and nothing else is told,
 * where K is not positive definite. */
enum hobe_status eigen_dense(int n, double *M, double *K, double *nu, int *definite,
                             struct hobe_error *err);

/* All eigenvalues re[n] + i im[n] of a dense matrix, given by its columns A[n][n] (destroyed), with
 * the vectors as rows of Z[n][n]: of a conjugate pair, im > 0 first, the real and the imaginary
 * part of the first one's. */
enum hobe_status eigen_general(int n, double *A, double *re, double *im, double *Z,
                               struct hobe_error *err);

/* L U factors with row pivots, pivot[n], of a dense matrix given by its columns A[n][n], in its
 * place; and x[n] = its inverse times x by them.  HOBE_SINGULAR where the pivots, whose matrix
 * should be scaled, differ by what rounding leaves of nothing. */
enum hobe_status eigen_factor(int n, double *A, int *pivot, struct hobe_error *err);
void eigen_divide(int n, const double *LU, const int *pivot, double *x);

/* A[n][n] += X Y' of X, Y[n][k], where that is symmetric: its lower triangle; what is above its
 * diagonal is undefined. */
void eigen_add_product(int n, int k, const double *X, const double *Y, double *A);

/* A pencil of n unknowns as functions: y = M x; x = K^-1 x; and y = B x, B the matrix of the inner
 * product: K, where it is positive definite, or, where that is NULL, M, positive semidefinite. */
struct eigen_pencil {
    int n;
    void *context;
    void (*multiply)(void *context, const double *x, double *y);
    void (*inner)(void *context, const double *x, double *y);
    enum hobe_status (*solve)(void *context, double *x, struct hobe_error *err);
};

/* The end of the spectrum of M x = nu K x, nu finite, that is wanted. */
enum eigen_end { EIGEN_LARGEST, EIGEN_SMALLEST, EIGEN_LARGEST_MAGNITUDE };

/* `wanted` pairs of that end by Lanczos' method with implicit restarts, to rounding: nu[wanted],
 * X[wanted][n] with x'Bx = 1, in no special order.  The start vector is always the same.  The
 * Krylov space has at most `most` dimensions, wanted < most <= the rank of K^-1 M.  Not for two
 * threads at once: ARPACK keeps its state to itself. */
enum hobe_status eigen_lanczos(const struct eigen_pencil *pencil, enum eigen_end end, int wanted,
                               int most, double *nu, double *X, struct hobe_error *err);

#endif
