/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One element's vectors around a place of a beam, from which every field there is made. */
#ifndef HOBE_AROUND_H
#define HOBE_AROUND_H

#include "model.h"
#include "section.h"

struct around {
    const struct hobe_kernel *kernel;
    struct place place;
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS], phi[HOBE_MAX_MODES][4];
    const double *q0; /* [vectors][3] reference, the element's first node at the origin */
    double u[3 * HOBE_MAX_VECTORS];
    double frame[3][3]; /* the section's axes on the beam's axis in the reference, rows */
};

/* The beam called name and the place `at` in [0,1] of it, in *place; NULL with err where there is
 * none. */
const struct beam *around_find(const hobe_model *model, const char *name, double at,
                               struct place *place, struct hobe_error *err);

/* Displacements of the element's vectors in the state u, NULL: none, and its axial functions at a
 * place. */
void around_look(const hobe_model *model, const double *u, struct place place, struct around *p);

/* Where that is, as sections want to know it. */
struct hobe_section_place around_section_place(struct place place);

/* Sets phi to the section modes at (y, z). */
enum hobe_status around_modes(struct around *p, double y, double z, struct hobe_error *err);

/* Sets phi to the section modes on the axis, functions of the section left out: what they do there
 * is no part of its mean plane, and in a hollow section nothing real. */
void around_axis(struct around *p);

/* A field sum_v N_v phi_v q_v is sum_m phi_m a_m: the section modes' amplitudes a at a place, and
 * their derivatives along the beam. */
struct amplitudes {
    double a[HOBE_MAX_MODES][3], ax[HOBE_MAX_MODES][3];
};

/* Of the field with the vectors q[vectors][3]. */
void around_amplitudes(const struct around *p, const double *q, struct amplitudes *of);

/* Value and gradient by x, y, z at the point of phi. */
void amplitudes_field(const struct amplitudes *of, int modes, const double (*phi)[4],
                      double value[3], double F[3][3]);

/* Both at once: value and gradient of the field with the vectors q[vectors][3] at p's point. */
void around_field(const struct around *p, const double *q, double value[3], double F[3][3]);

/* F = dr/dX at phi's point, columns along the section's axes in the reference; returns det J0, the
 * volume in the reference over dx dy dz. */
double around_gradient(const struct around *p, double F[3][3]);

/* The section's axes t, rows, where F is the gradient on the axis: t_x along r_y x r_z, t_y and t_z
 * as near to r_y and r_z as an orthonormal pair can be (both turned by the same angle in their
 * plane). */
void around_axes(const double F[3][3], double t[3][3]);

double determinant(const double F[3][3]);

#endif
