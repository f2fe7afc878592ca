/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a section gives way in torsion, beyond what w allows it. */
#ifndef HOBE_DISTORTION_H
#define HOBE_DISTORTION_H

#include "section.h"
#include "section_mesh.h"

/* Fields on the mesh, in the order of HOBE_WW ... HOBE_V2Z, and one of zeros that makes them two
 * times HOBE_SECTION_FUNCTIONS. */
enum { HOBE_DISTORTIONS = 2 * HOBE_SECTION_FUNCTIONS };

/* Their nodal values, values[HOBE_DISTORTIONS][nodes], from w[nodes] and the shear centre.
 *
 * ww is the warping of the shear that restrained warping brings: -div G grad ww = E w, without flux
 * through the outline.  (v1y, v1z) and (v2y, v2z) are displacements of the section in its plane:
 * its elastic answer, isotropic without Poisson's coupling, to what a beam whose outline is rigid
 * leaves unbalanced there,
 *
 *     v1   tau, Saint-Venant's shear stress of a unit twist, as where the twist changes along x,
 *     v2   e_x x tau,                                        as where a great twist turns the
 * shear,
 *
 * each less the forces of inertia that make it an equilibrium.  All are orthogonal to 1, y and z,
 * and v as large as y and z are themselves; zero where a section, such as a ring, has no such load.
 *
 * *wall_bending: that of hobe_section_wall_bending, m^6: the work of the load 2 G/G_1 e_x x tau, an
 * energy's by v at a unit twist rate, on the answer of a section of E/E_1. */
enum hobe_status hobe_distortion(const hobe_section *section, const struct hobe_mesh *mesh,
                                 const double *w, const double centre[2], double *values,
                                 double *wall_bending, struct hobe_error *err);

#endif
