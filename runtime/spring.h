/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Springs and dampers between two places: struct hobe_spring.
 *
 * Each acts on extensions s of the places' vectors: the change of a length or an angle, or three
 * displacements.  With the energy sum k (s - s_0)^2/2 and the damping c their forces are
 *
 *     f = sum M ds/dq,    M = k (s - s_0) + c ds/dt,
 *
 * so that those on the two places are in equilibrium.  The places, and the measures that s is a
 * function of, are those of a tie, which has no constraints. */
#ifndef HOBE_SPRING_H
#define HOBE_SPRING_H

#include "constraint.h"

enum { SPRING_PARTS = 3 }; /* extensions that a spring may have */

struct spring {
    struct hobe_spring spec;
    struct tie tie;
    double start[2]; /* length: that in the reference, m; torsion: sine and cosine there */
    struct constraint measure[SPRING_PARTS]; /* (length^2 - start^2)/2; the change of sine and
                                                cosine; displacements */
};

static inline struct spring *model_spring(const struct hobe_model *model, size_t i)
{
    return (struct spring *)model->springs.item + i;
}

/* What can be judged without the spring's beams. */
enum hobe_status spring_check(const struct hobe_spring *spec, struct hobe_error *err);

/* Finds the places of all springs, and the vectors that they act on. */
enum hobe_status spring_build(struct hobe_model *model, struct hobe_error *err);

/* f[vectors][3] += the forces of all springs in state u at an instant, N; K += their derivatives,
 * d/du + rate d/dv, unless NULL.  Left out is what a damper's force c ds/dt ds/dq changes with u in
 * ds/dt: it is not symmetric, and to the rest as the motion of a time step is to the length. */
void spring_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                double *f, const struct matrix *K);

/* K += the stiffness of springs in state u with the forces that displacements v would add to those
 * they have (assemble_strained). */
void spring_strained(const struct hobe_model *model, const double *u, const double *v,
                     const struct matrix *K);

/* The energy of all springs, J, and what their dampers take, W. */
double spring_energy(const struct hobe_model *model, const double *u);
double spring_power(const struct hobe_model *model, const double *u, const double *v);

/* J[k] = the derivatives, by r, y, z of both places in the reference, of the extensions that have
 * stiffness; how many these are. */
int spring_jacobian(const struct spring *spring, double J[TIE_CONSTRAINTS][TIE_VECTORS][3]);

/* f[vectors][3] += what springs at places inside element e of a beam do to it, N. */
void spring_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                   const struct beam *beam, int e, double *f);

#endif
