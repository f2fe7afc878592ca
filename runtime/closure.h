/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spaces of fields that no rotation leads out of.  Nodal vectors turn as vectors in space do, q ->
 * R q, and displacements u = q - x_0 to R u + (R - 1) x_0: a space that holds with u its images A u
 * under 3 x 3 maps A, and A x_0, holds every state with all its rotations, exactly. */
#ifndef HOBE_CLOSURE_H
#define HOBE_CLOSURE_H

#include "span.h"

/* Adds to the fields from `first` on what closes their space: under all maps in space (closed: 3),
 * or those of a plane, given by its normal (2).  Where nothing is held, so that all may turn, with
 * the reference and the translations.  Those before are closed and orthonormal; then all are.
 *
 * In a span of functions, whose group is 3, those of the components along x, y and z take the place
 * of the fields: psi e_a for all a, as many independent ones. */
enum hobe_status closure_add(struct span *span, long first, int closed, const double normal[3],
                             struct hobe_error *err);

#endif
