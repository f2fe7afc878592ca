/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The space of a Galerkin method: fields of a model among which a solver looks for corrections.
 *
 * With a fixed scale D, that of the solver's residuals, the scaled fields W = D^-1 phi are
 * orthonormal, W'W = 1.  So the projected residual is measured as the whole one, |W'D r| <= |D r|,
 * equal where the space is all, and the projected matrix W'D A D W is as well conditioned. */
#ifndef HOBE_SUBSPACE_H
#define HOBE_SUBSPACE_H

#include "model.h"

struct subspace {
    const struct hobe_model *model;
    long n, room, count; /* scalar unknowns; fields it has room for; and those it has, 0: none */
    const double *scale; /* [n] D, the owner's */
    double *W;           /* [count][n] */
    double *A, *product; /* [count][count] factors; [n] D A D w */
    double *x;           /* [room] */
    int *pivot;          /* [room] of the factors */
};

/* Room for `room` fields, none yet; what it held is freed. */
enum hobe_status subspace_open(struct subspace *space, const struct hobe_model *model,
                               const double *scale, long room, struct hobe_error *err);
void subspace_close(struct subspace *space);

/* Where the next field is to be written, phi[n], in the unknowns' own units; and its place in the
 * space, unless it depends on those before it.  No more of them than there is room for. */
double *subspace_next(struct subspace *space);
void subspace_take(struct subspace *space);

/* The same with the unit fields of the three unknowns of a vector. */
void subspace_take_vector(struct subspace *space, long unknown);

/* |W'D f| of a residual f[vectors][3]. */
double subspace_norm(const struct subspace *space, const double *f);

/* Factors of W'D A D W, A in the model's columns.  HOBE_SINGULAR without a sentence. */
enum hobe_status subspace_factor(struct subspace *space, const double *Ax, struct hobe_error *err);

/* x[n] = D W (W'D A D W)^-1 W'D x by the last factors. */
void subspace_solve(const struct subspace *space, double *x);

#endif
