/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spaces of fields that no rotation leads out of.  Nodal vectors turn as vectors in space do, q ->
 * R q, and displacements u = q - x_0 to R u + (R - 1) x_0: a space that holds with u its images A u
 * under 3 x 3 maps A, and A x_0, holds every state with all its rotations, exactly. */
#ifndef HOBE_CLOSURE_H
#define HOBE_CLOSURE_H

#include "span.h"

/* Adds to orthonormal fields what closes their space: under all maps in space (closed: 3), or those
 * of a plane, given by its normal (2).  Where nothing is held, so that all may turn, with the
 * reference and the translations. */
enum hobe_status closure_add(struct span *span, int closed, const double normal[3],
                             struct hobe_error *err);

#endif
