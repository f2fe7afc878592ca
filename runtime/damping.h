/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forces that the velocities of beams make: struct hobe_damping. */
#ifndef HOBE_DAMPING_H
#define HOBE_DAMPING_H

#include "model.h"

/* f[vectors][3] += the forces alpha M v + tau K_m(u) v with which beams resist their velocities
 * instant->v, N; K += rate times their matrices unless NULL.  The second part depends on u, too,
 * which K leaves out (assemble_viscous). */
void damping_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double *f, const struct matrix *K);

/* What these forces take, and the dampers of springs (spring.h): v'f >= 0, W. */
double damping_power(const struct hobe_model *model, const double *u, const double *v);

/* HOBE_BAD_INPUT where a beam cannot have the damping that it asks for. */
enum hobe_status damping_check(const struct hobe_beam *spec, struct hobe_error *err);

#endif
