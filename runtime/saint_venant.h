/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Saint-Venant's functions of torsion and bending on a meshed section. */
#ifndef HOBE_SAINT_VENANT_H
#define HOBE_SAINT_VENANT_H

#include "section.h"
#include "section_mesh.h"

/* Nodal values of the three functions, values[HOBE_SECTION_FUNCTIONS][mesh->nodes], by quadratic
 * finite elements:
 *
 *     HOBE_W             div G grad w = 0,           w_n = y n_z - z n_y on the outline;
 *     HOBE_WY, HOBE_WZ   -div G grad psi = E y, E z  psi_n = 0, solvable about the centroid,
 *
 * with E and G over those of the first region; where regions meet, G (grad w - (-z, y)) and G grad
 * psi keep their flux.  In int E ..dA w is made orthogonal to 1, y and z, psi_y to these and w,
 * psi_z to all.  energy: int G |grad w|^2 dA; centre: the shear centre ys, zs. */
enum hobe_status hobe_saint_venant(const hobe_section *section, const struct hobe_mesh *mesh,
                                   double *values, double *energy, double centre[2],
                                   struct hobe_error *err);

/* Smooth fields on a mesh whose values at some nodes are given, those of the least
 * sum over the triangles of int |grad f|^2 dA / A (Stein, Tezduyar & Benney 2003). */
struct hobe_extension;
/* held[mesh->nodes]: 1 where values will be given, which must be all along the outline.  The mesh
 * must outlive the result; NULL for want of memory. */
struct hobe_extension *hobe_extension_new(const struct hobe_mesh *mesh, const unsigned char *held,
                                          struct hobe_error *err);
/* values[mesh->nodes]: given at the held nodes, set at the others, in the middle of a side to the
 * mean of its ends, so that nodes moved by such fields leave sides straight. */
enum hobe_status hobe_extension_apply(const struct hobe_extension *extension, double *values,
                                      struct hobe_error *err);
void hobe_extension_free(struct hobe_extension *extension);

/* f[HOBE_SECTION_FUNCTIONS][4]: the fields of such nodal values and their gradients at a place. */
void hobe_mesh_fields(const struct hobe_mesh *mesh, const double *values,
                      const struct hobe_mesh_place *place, double (*f)[4]);

/* Cubature over the mesh with the fields as section functions: exact for their squares, those of
 * their gradients and polynomials of degree 4 in y and z. */
enum hobe_status hobe_mesh_rule(const struct hobe_mesh *mesh, const double *values,
                                struct hobe_rule *rule, struct hobe_error *err);

#endif
