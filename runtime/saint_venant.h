/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Saint-Venant's warping function of a meshed section. */
#ifndef HOBE_SAINT_VENANT_H
#define HOBE_SAINT_VENANT_H

#include "section.h"
#include "section_mesh.h"

/* w at the nodes, w[mesh->nodes]: Laplace's equation with w_n = y n_z - z n_y on the outline and
 * mean 0, by quadratic finite elements.  Its energy, int |grad w|^2 dA, is also given. */
enum hobe_status hobe_saint_venant(const struct hobe_mesh *mesh, double *w, double *energy,
                                   struct hobe_error *err);

/* f[3]: the field with nodal values w[mesh->nodes] and its gradient at (y, z); beyond the outline
 * those of the nearest point. */
void hobe_mesh_field(const struct hobe_mesh *mesh, const double *w, double y, double z, double *f);

/* Cubature over the mesh with the field as the first section function: exact for w^2, |grad w|^2
 * and polynomials of degree 4 in y and z. */
enum hobe_status hobe_mesh_rule(const struct hobe_mesh *mesh, const double *w,
                                struct hobe_rule *rule, struct hobe_error *err);

#endif
