/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections that are their own mirror image: half of one is meshed, the rest is its image.  Then
 * what is solved on the mesh has the symmetry of the section, too, and kernels may leave out what
 * vanishes by it. */
#ifndef HOBE_SECTION_MIRROR_H
#define HOBE_SECTION_MIRROR_H

#include "section_mesh.h"

/* Whether each outline is its own image under the reflection that takes coordinate a (0: y, 1: z)
 * to 2 at - that, point by point to within `same`, m.  at: the middle of all of them. */
int mirror_outlines(int parts, const struct hobe_outline *outline, int a, double same, double *at);

/* Adds the image of a mesh that lies on one side of the mirror; nodes within `same` of it are put
 * on it and shared. */
enum hobe_status mirror_mesh(struct hobe_mesh *mesh, int a, double at, double same,
                             struct hobe_error *err);

/* Takes out of a field what only rounding puts there: of one that is even, or odd, under a mirror
 * of the mesh but for a share of 1e-9, the rest.  value[nodes]. */
void mirror_restore(const struct hobe_mesh *mesh, double *value);

#endif
