/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Constraints, between the rooms that do them (constraint*.c). */
#ifndef HOBE_CONSTRAINT_PARTS_H
#define HOBE_CONSTRAINT_PARTS_H

#include "constraint.h"

enum { ORDERS = 3 }; /* a value and its derivatives by time */

/* Both places in a state.  Phi is a difference of nearly equal directions: it is formed from
 * displacements, D_a' D_b - D_a0' D_b0 = dD_a' D_b + D_a0' dD_b, to keep its digits. */
struct tie_state {
    double D[2][3][3], dD[2][3][3], d[3];
    double lambda[TIE_CONSTRAINTS];
};

/* Finds that in state u, NULL: the reference. */
void tie_read_state(const struct tie *tie, const double *u, struct tie_state *s);

/* Phi of a constraint, and g = dPhi/d(r, y, z of both places). */
double constraint_value(const struct constraint *c, const struct tie *tie,
                        const struct tie_state *s);
void constraint_gradient(const struct constraint *c, const struct tie_state *s,
                         double g[TIE_VECTORS][3]);

/* c[p][k] = the p-th derivative by time of constraint k at an instant, p < ORDERS.
 * (constraint_drive.c) */
enum hobe_status constraint_at(const struct tie *tie, const struct instant *instant,
                               struct constraint c[ORDERS][TIE_CONSTRAINTS],
                               struct hobe_error *err);

/* The same; where a drive fails the model hears of it, and all is NaN. */
void constraint_now(const struct hobe_model *model, const struct tie *tie,
                    const struct instant *instant, struct constraint c[ORDERS][TIE_CONSTRAINTS]);

#endif
