/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proper orthogonal decomposition: the main directions of states that are given. */
#ifndef HOBE_SNAPSHOT_MODES_H
#define HOBE_SNAPSHOT_MODES_H

#include "subspace.h"

/* Fills the space with the main directions of projection->snapshot: of their scaled displacements
 * S = [D^-1 u_k], the left singular vectors to the largest singular values.  These come from the
 * eigenvalues of S'S, so that those below 1e-8 of the largest are lost (Sirovich 1987, Quart. Appl.
 * Math. 45).  HOBE_BAD_INPUT where there are none, where one is of another shape, where more modes
 * are asked for than they have directions, or where the scene has multipliers. */
enum hobe_status snapshot_modes(const struct hobe_model *model,
                                const struct hobe_projection *projection, const double *scale,
                                struct subspace *space, struct hobe_error *err);

#endif
