/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How many eigenvalues of a tangent are negative, ties or not. */
#ifndef HOBE_INERTIA_H
#define HOBE_INERTIA_H

#include "model.h"

/* Rows of the model's tangent that belong to multipliers of constraints; and to spare ones, whose
 * diagonal is 1. */
long inertia_multipliers(const struct hobe_model *model, long *spare);

/* The negative eigenvalues, on the displacements that the ties leave free, of the tangent whose
 * values in the pattern are Ax, of a model with ties; -1 where the factors do not show them, or
 * ties are too many.  Ax is changed, and the model's solver holds other factors afterwards;
 * scale[n] as for hobe_linsolve_factor. */
enum hobe_status inertia_behind_ties(struct hobe_model *model, double *Ax, const double *scale,
                                     long *negative, struct hobe_error *err);

#endif
