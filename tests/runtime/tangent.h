/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A part of the core's residual against its tangent.  Looks into the core (model.h). */
#ifndef HOBE_TEST_TANGENT_H
#define HOBE_TEST_TANGENT_H

#include "model.h"

/* Adds a force on all vectors in state u to r, and its derivative to K unless NULL. */
typedef void residual_part(const hobe_model *model, const double *u, double *r,
                           const struct matrix *K);

/* At a random state, slopes turned and stretched by a third: the tangent agrees with differences of
 * the force, and is symmetric if there is a potential, and only then.  Builds the model. */
void check_tangent(hobe_model *model, residual_part *part, int symmetric, const char *what);

/* A field [vectors][3] on a built model, zero, to be freed by hobe_free; ends the test without. */
double *field_on(const hobe_model *model);

#endif
