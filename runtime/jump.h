/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a load step has come to the equilibrium that the path leads to, or to another one beyond
 * a limit point.
 *
 * Newton's iteration finds an equilibrium F(u) = lambda Q, not the path to it.  At one load two
 * stable ones have a state between them where the tangent is indefinite (along the segment between
 * them the energy is least at both), and so an iteration that jumps from one to the other leaves
 * traces, which cost next to nothing to watch: pivots below zero, or that it fails.  Where it leaps
 * over that state at once there is the start of the path left: along the first correction x the
 * residual's work x.(F(u + t x) - Q) = -k + k t + a t^2 + b t^3 (a cubic where the energy is a
 * quartic, known from its values at t = 0, 1/2 and 1), to whose second order the path
 * Q.u = k lambda - a lambda^2 turns at k/(-2 a) of the load.
 *
 * A suspicion is verified by steps of the load that are as small as continuity asks for: the first
 * correction of a step is the path's tangent there, and what the step moves differs from it by a
 * share that goes to zero with the step, on a path; and that stays where there is none. */
#ifndef HOBE_JUMP_H
#define HOBE_JUMP_H

#include "hobe.h"

struct solver;

struct jump {
    double *first;  /* [unknowns] the first correction of the last step; NULL: nothing is watched */
    double work[2]; /* of the residual along it, before it and half-way, J */
    double turn;   /* the share of the load of the step at which the path would turn by its start */
    long negative; /* eigenvalues of the tangent at the start of the step */
    int suspected; /* since that was cleared */
    int driven;    /* by joints, which do work, too: the turn is not known */
    int verifying; /* the iterations are those of small steps */
};

enum hobe_status jump_open(struct solver *s, struct hobe_error *err);
void jump_close(struct solver *s);

/* Looks at an iteration without line search that has factors and a correction and has not taken it.
 */
void jump_watch(struct solver *s);

#endif
