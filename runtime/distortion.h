/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a section gives way in torsion, beyond what w allows it. */
#ifndef HOBE_DISTORTION_H
#define HOBE_DISTORTION_H

#include "section.h"
#include "section_mesh.h"

/* Fields on the mesh, in the order of HOBE_WW ... HOBE_V3Z, and one of zeros that makes them four
 * times HOBE_SECTION_FUNCTIONS. */
enum { HOBE_DISTORTIONS = 4 * HOBE_SECTION_FUNCTIONS };

/* Their nodal values, values[HOBE_DISTORTIONS][nodes], from w[nodes] and the shear centre.
 *
 * (v1y, v1z), (v2y, v2z) and (v3y, v3z) are displacements of the section in its plane: its elastic
 * answer, isotropic without Poisson's coupling, to what a beam whose outline is rigid leaves
 * unbalanced there,
 *
 *     v1   tau, Saint-Venant's shear stress of a unit twist, as where the twist changes along x,
 *     v2   e_x x tau, as where a great twist turns the shear,
 *
 * each less the forces of inertia that make it an equilibrium, and v3 to the stress of v2's strain
 * of second order, grad v2^T grad v2 / 2: walls that bend far keep their length.
 *
 * The others are warpings f with -div G (grad f - F) = E g, without flux through the outline:
 *
 *     ww              g = w: the shear that restrained warping brings,
 *     w1, w2, w3      F = v1, v2, v3: walls turn with the slope of a v that changes along x
 *                     (Kirchhoff's hypothesis),
 *     w2t             F_a = (e_x x v2)_a + (e_x x r) . v2,a: w follows the outline that v2 moves.
 *
 * v3 and w2t are derivatives of v2 and w by the amplitude of v2 (modal derivatives: Idelsohn &
 * Cardona 1985).  All are orthogonal to 1, y and z, and v as large as y and z are themselves; zero
 * where a section, such as a ring, has no such load.
 *
 * *wall_bending: that of hobe_section_wall_bending, m^6: the work of the load 2 G/G_1 e_x x tau, an
 * energy's by v at a unit twist rate, on the answer of a section of E/E_1. */
enum hobe_status hobe_distortion(const hobe_section *section, const struct hobe_mesh *mesh,
                                 const double *w, const double centre[2], double *values,
                                 double *wall_bending, struct hobe_error *err);

#endif
