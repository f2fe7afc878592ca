/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a load step has come to the equilibrium that the path leads to, or to another one beyond
 * a limit point.
 *
 * Newton's iteration finds an equilibrium F(u) = lambda Q, not the path to it.  At one load two
 * stable ones have a state between them where the tangent is indefinite (of the energy along the
 * segment both are minima), and so an iteration that jumps from one to the other leaves traces,
 * which cost nothing to watch: pivots below zero, an iteration that does not converge, or an energy
 * that is not convex along the first correction x: x.(F(u + t x) - lambda Q) is a cubic of t where
 * the energy is a quartic of u, and known from its values at t = 0, 1/2 and 1 and its slope at 0.
 *
 * A suspicion is verified by steps of the load that are as small as continuity asks for: the first
 * correction of a step is the path's tangent there, and what the step moves differs from it by a
 * share that goes to zero with the step, on a path; and that stays where there is none. */
#ifndef HOBE_JUMP_H
#define HOBE_JUMP_H

#include "hobe.h"

struct solver;

struct jump {
    double *first;  /* [unknowns] the first correction of the last step */
    double work[2]; /* of the residual along it, before it and half-way, J */
    int suspected;  /* since that was cleared */
};

enum hobe_status jump_open(struct solver *s, struct hobe_error *err);
void jump_close(struct solver *s);

/* Looks at an iteration without line search that has factors and a correction and has not taken it. */
void jump_watch(struct solver *s);

#endif
