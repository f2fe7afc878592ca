/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rigid bodies in natural coordinates.
 *
 * A body owns four vectors: the position r of its centre of mass and three directions d_1, d_2, d_3
 * that are fixed to it, the global axes in the reference.  A point X from the centre in the
 * reference is r + X_i d_i, so that the mass matrix is constant,
 *
 *     diag(m, J) (x) I_3,  J_ij = int rho X_i X_j dV = tr(I)/2 delta_ij - I_ij,
 *
 * without centrifugal or Coriolis forces.  Six constraints d_i . d_j = delta_ij with multipliers,
 * ties of the body with itself, keep it rigid. */
#ifndef HOBE_BODY_H
#define HOBE_BODY_H

#include "model.h"

enum { BODY_VECTORS = 4 }; /* r, d_1, d_2, d_3 */

struct body {
    struct hobe_body spec;                   /* its mass and name resolved */
    double mass[BODY_VECTORS][BODY_VECTORS]; /* m and J, kg and kg m^2 */
    long first;                              /* vector r; the others follow */
    size_t tie; /* the first of its two, whose first vectors are the body's in this order */
};

static inline struct body *model_body(const struct hobe_model *model, size_t i)
{
    return (struct body *)model->bodies.item + i;
}

/* The body called name, or NULL. */
const struct body *model_find_body(const struct hobe_model *model, const char *name);

/* What a place of a scene may be on: the beam or the body called name.  HOBE_UNKNOWN (where) with
 * the known ones where there is none. */
struct part {
    const struct beam *beam;
    const struct body *body;
};
enum hobe_status model_find_part(const struct hobe_model *model, const char *name,
                                 const char *where, struct part *part, struct hobe_error *err);

/* HOBE_BAD_INPUT: something at a point, where the beam called name needs `at`. */
enum hobe_status model_refuse_point(const char *name, const char *where, struct hobe_error *err);

/* Checks a body and finds its mass and inertia; its name is not copied. */
enum hobe_status body_open(const struct hobe_body *spec, struct body *body, struct hobe_error *err);

/* Its radius of gyration about its centre, m. */
double body_radius(const struct body *body);

/* Adds the two ties that keep each body rigid. */
enum hobe_status body_ties(struct hobe_model *model, struct hobe_error *err);

/* A body has no stiffness of its own but what its multipliers make, of any size and sign: its
 * vectors are scaled at least as those of what it is joined to, scale[3 unknowns] = diag^(-1/2), so
 * that beside the constraints that is small. */
void body_scale(const struct hobe_model *model, double *scale);

/* weight[BODY_VECTORS] of the body's vectors in the position of a point of it, global axes in the
 * reference, m; NULL: its centre. */
void body_weights(const struct body *body, const double point[3], double weight[BODY_VECTORS]);

/* K += block at vectors (v, w) of the body. */
void body_tangent_add(const struct hobe_model *model, const struct body *body, int v, int w,
                      const double block[3][3], const struct matrix *K);

/* Its vectors in the reference, q[vectors][3], m and 1. */
void body_reference(const struct body *body, double *q);

/* f[vectors][3] += its part of (m (x) A) a, and K += that of m (x) A: mass.h. */
void body_mass_force(const struct body *body, const double A[3][3], const double *a, double *f);
void body_mass_matrix(const struct hobe_model *model, const struct body *body, const double A[3][3],
                      const struct matrix *K);

/* a'M b of two fields [vectors][3]. */
double body_mass_product(const struct body *body, const double *a, const double *b);

/* Displacement u of a point, as in body_weights, of the field vectors[..][3]; and where it is in
 * the reference, r0. */
void body_displacement(const struct body *body, const double *vectors, const double point[3],
                       double r0[3], double u[3]);

/* turn = sum d_i x v_i / 2, the angular velocity, rad/s, with the velocities v[vectors][3] in state
 * u. */
void body_turn(const struct body *body, const double *u, const double *v, double turn[3]);

#endif
