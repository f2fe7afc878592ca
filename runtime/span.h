/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields of displacements of a model's beams in the inner product
 *
 *     (a, b) = a'(K + diag K) b,
 *
 * K the tangent at some state, as a rule the reference.  By K fields count as the energy they take,
 * and one that leaves out a stiff part is far from what it stands for; by its diagonal, the square
 * of the norm |D^-1 a| of displacements (solver.h), as what they move, so that soft ones and rigid
 * motions count, too.
 *
 * A scalar function psi is kept as a group of three fields, psi e_x, psi e_y and psi e_z, and the
 * product of two is the sum of those of their fields: the trace, which no turn of the axes changes.
 */
#ifndef HOBE_SPAN_H
#define HOBE_SPAN_H

#include "model.h"

struct span {
    hobe_model *model;
    struct matrix K;
    long n, room;  /* fields */
    long group;    /* 1, or 3 where they are functions; below i and j are the first of a group */
    double *field; /* [room][vectors][3] */
    double *image; /* [room][unknowns] (K + diag K) field */
    double *x;     /* [2][unknowns] */
};

/* Room for none yet, in the product of the tangent at u[vectors][3], NULL: the reference. */
enum hobe_status span_open(struct span *span, hobe_model *model, const double *u,
                           struct hobe_error *err);
void span_close(struct span *span);

/* Appends a copy of what the beams have of a field, with its image. */
enum hobe_status span_add(struct span *span, const double *field, struct hobe_error *err);

/* Removes the fields from `first` to the one before `end`. */
void span_drop(struct span *span, long first, long end);

double span_product(const struct span *span, long i, long j);

/* Field i += factor field j. */
void span_combine(struct span *span, long i, double factor, long j);

/* Gives field i unit length; one of no length stays. */
void span_normalise(struct span *span, long i);

/* Makes the fields from `first` on orthonormal to those before them and one another, in turn;
 * those that depend on them, but for 1e-5, of functions 1e-6, are dropped. */
void span_orthonormalise(struct span *span, long first);

/* Replaces the fields from `first` on by their principal ones, orthonormal, those first that hold
 * most of all: at most `most`, as many as leave no more than a share of the fields, by the root of
 * the mean of squares.  What is held by rounding alone is dropped.  Not for functions. */
enum hobe_status span_compress(struct span *span, long first, long most, double share,
                               struct hobe_error *err);

#endif
