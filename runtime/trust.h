/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a state of a model may be from the equilibrium near it: what a reduced model is asked.
 *
 * Newton's correction of the whole model there, d = -K^-1 r, is what the state lacks, to the second
 * order.  Another one by the same factors, d_2 = -K^-1 r(u + d), tells that order: |d_2| = h/2 |d|,
 * and by Newton's and Kantorovich's theorem, which asks for h <= 1/2, the equilibrium is within
 *
 *     |d| (1 - sqrt(1 - 2 h))/h
 *
 * (affine covariant form: Deuflhard 2004, Newton Methods for Nonlinear Problems, sect. 2.1).  Where
 * h is larger the correction is taken and the next one asked, and what was travelled adds up.  h is
 * an estimate of what the theorem bounds, and so the indicator is twice that, over the size of the
 * state; infinite where a few corrections come to nothing.  Norms are |D^-1 u| as in solver.h,
 * without multipliers: a slope counts as what it moves over an element's length. */
#ifndef HOBE_TRUST_H
#define HOBE_TRUST_H

#include "solver.h"

struct trust {
    struct solver s;
};

/* Memory for states of a built model, and the factors that its solver shares.  What is open is
 * closed, too, after an error. */
enum hobe_status trust_open(struct trust *trust, hobe_model *whole, struct hobe_error *err);
void trust_close(struct trust *trust);

/* The indicator of a state of the model at its load factor and time, relative to *size, which
 * becomes at least that of the state: the largest so far.  One in motion, with accelerations, is
 * asked by one correction what the left-out fields would do if the forces that are out of balance
 * had acted since it began.  correction[vectors][3]: what the state lacks, by all of them, or NULL.
 * HOBE_SINGULAR, without a sentence, at a critical point. */
enum hobe_status trust_measure(struct trust *trust, const hobe_solution *state, double *size,
                               double *indicator, double *correction, struct hobe_error *err);

/* Writes the indicator into a state of the model, infinite at a critical point. */
enum hobe_status trust_ask(hobe_model *whole, hobe_solution *state, double *size,
                           struct hobe_error *err);

/* |D^-1 u| of displacements u[vectors][3]. */
double trust_norm(const struct trust *trust, const double *u);

#endif
