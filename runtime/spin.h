/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Centrifugal, Coriolis' and Euler's force in a frame that turns. */
#ifndef HOBE_SPIN_H
#define HOBE_SPIN_H

#include "model.h"

/* What the reference is from the axis; HOBE_BAD_INPUT where a beam has no density.  Without a spin
 * these do nothing. */
enum hobe_status spin_build(struct hobe_model *model, struct hobe_error *err);

/* r -= factor (w^2 M P q - 2 M w x v - M dw/dt x q), q the nodal vectors in state u, v their
 * velocities at the instant, and their matrix to K unless NULL: those of Coriolis' and Euler's
 * force are skew and for columns alone, fronts go without.  At rest, v = NULL, the turning is
 * steady.  Where the speed's history fails r is NaN, and the error waits in the model
 * (model_failure). */
void spin_subtract(const struct hobe_model *model, const double *u, const struct instant *instant,
                   double factor, double *r, const struct matrix *K);

/* f += factor times the force on element e of a beam. */
void spin_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double factor, const struct beam *beam, int e, double *f);

/* w[3] = the angular velocity at a load factor, rad/s, which scales its square, and a time; zero
 * without a spin.  HOBE_BAD_INPUT where the factor is negative: no speed has such a force. */
enum hobe_status spin_velocity(const struct hobe_model *model, double factor, double time,
                               double w[3], struct hobe_error *err);

#endif
