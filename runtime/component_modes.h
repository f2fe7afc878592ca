/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Component modes (Craig & Bampton 1968, AIAA J. 6): a scene is cut at its interfaces, the nodes
 * that joints, bodies, springs and loads act on.  With the displacements there, b, and those of
 * the interior, i, of the tangent stiffness in a state, the fields are
 *
 *     constraint modes               u_b = e_k, u_i = -K_ii^-1 K_ib e_k,    one for each unknown of
 * b, fixed-interface normal modes   u_b = 0,   K_ii u_i = omega^2 M_ii u_i,        the lowest ones,
 *
 * and the multipliers.  Whole nodes are kept, so that the constraint modes hold every rigid
 * motion of a component exactly (where it is in equilibrium; K is that of the state). */
#ifndef HOBE_COMPONENT_MODES_H
#define HOBE_COMPONENT_MODES_H

#include "subspace.h"

/* kept[unknowns] = 1 at the vectors of interfaces, bodies and multipliers; 0 before. */
enum hobe_status component_interfaces(const struct hobe_model *model, unsigned char *kept,
                                      struct hobe_error *err);

/* Fills the space with the modes about the displacements u[vectors][3], loads with the given
 * factor: projection->modes of both kinds, those of interfaces first, or the normal ones up to
 * projection->frequency, and the multipliers.
 * HOBE_BAD_INPUT where these are less than the interfaces have, or a beam has no mass. */
enum hobe_status component_modes(struct hobe_model *model, const struct hobe_projection *projection,
                                 const double *u, double factor, const double *scale,
                                 struct subspace *space, struct hobe_error *err);

#endif
