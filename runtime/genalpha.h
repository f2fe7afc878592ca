/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps in time: generalised alpha (Chung & Hulbert 1993) for constrained motion of index 3, in the
 * form of Arnold & Bruls (2007, Multibody Syst. Dyn. 18):
 *
 *     M w + F(q) + Phi_q' lambda = Q(q, v, t),  Phi(q, t) = 0 at the end of each step,
 *     (1 - am) a1 + am a = (1 - af) w1 + af w,
 *     q1 = q + h v + h^2 ((1/2 - beta) a + beta a1),  v1 = v + h ((1 - gamma) a + gamma a1).
 *
 * w are the accelerations; a, the algorithmic ones, are those at t + (am - af) h to first order.
 * The unknowns of a step are the displacements and multipliers u1; velocities and accelerations
 * follow by dv/du = gamma/(h beta) and dw/du = (1 - am)/((1 - af) h^2 beta), and are moved with the
 * corrections, not formed from differences of u, which would lose digits as h gets small.
 *
 * Between genalpha.c, settle.c and dynamic.c only. */
#ifndef HOBE_GENALPHA_H
#define HOBE_GENALPHA_H

#include "solver.h"

/* All that the steps to come depend on, but for factors at hand (genalpha_forget). */
struct genalpha_state {
    double time;  /* reached, s */
    double step;  /* h of the step to come, s */
    double begin; /* time = begin + taken * step: where h was chosen, and steps since */
    long taken;
    double *u, *v, *w, *a; /* [vectors][3] m, m/s, m/s^2; of u the multipliers, too */
};

struct genalpha {
    struct solver s; /* s.u: the state being found */
    double am, af, beta, gamma;
    double tolerance;
    int max_iterations, full_newton; /* as in hobe_dynamic */
    struct genalpha_state now;
    double *v, *w, *a;  /* [vectors][3] at the end of the step */
    double *force;      /* [vectors][3] M w there, N */
    double *turned;     /* [vectors][3] displacements about which corrections are confined */
    double *weight;     /* [vectors][3] of Phi on the multipliers: 1/size of lengths, 1 of angles */
    double mass, size;  /* kg; the scene's extent in the mass norm, m */
    int inert;          /* how the step is predicted */
    int factored;       /* factors of some Newton matrix of this h are at hand */
    int iterations;     /* of the last step */
    const char *reason; /* why it failed */
};

/* Memory and parameters; all at rest at t = 0, in the reference, with a step yet to be set. */
enum hobe_status genalpha_open(struct genalpha *g, hobe_model *model,
                               const struct hobe_dynamic *options, struct hobe_error *err);
void genalpha_close(struct genalpha *g);

/* The largest |Phi| of a residual, weighed: relative to the scene's size, or rad. */
double genalpha_violation(const struct genalpha *g, const double *r);

/* Sets the step, so that whole ones lead to the time `target`, none longer than `longest`.  Whether
 * it differs from the last one. */
int genalpha_choose_step(struct genalpha *g, double target, double longest);

/* Tries a step from now: CONVERGED, FAILED with g->reason, ERROR. */
enum outcome genalpha_step(struct genalpha *g, struct hobe_error *err);

/* Confines corrections to what a projection makes of the state now, whose velocities settle then
 * takes into that space; and how far the scene has moved since, in the mass norm, relative to its
 * size. */
enum hobe_status genalpha_confine(struct genalpha *g, struct hobe_error *err);
double genalpha_deviation(struct genalpha *g);

/* |x|_M / sqrt(m) of a field, in the field's unit. */
double genalpha_norm(const struct genalpha *g, const double *x);

/* That of the accelerations of the step that was found last. */
double genalpha_acceleration(const struct genalpha *g);

/* The part of the last step's displacements that its order leaves out, m:
 * |beta + (am - af)/2 - 1/6| h^2 |a1 - a| in the mass norm (Geradin & Cardona 2001, 7.6). */
double genalpha_error(struct genalpha *g);

/* Makes the end of the last step the state now. */
void genalpha_accept(struct genalpha *g);

/* The next step makes factors of its own: a run that goes on from a stored state does the same. */
void genalpha_forget(struct genalpha *g);

/* ---- settle.c ------------------------------------------------------------------------------- */

/* Makes the velocities fit the constraints, Phi_q v + Phi_t = 0, by the least change in the norm of
 * M, and finds the accelerations and multipliers that belong to them: M w + Phi_q' lambda = Q - F,
 * Phi_q w = -(d/dt Phi_q) v - ...; a = w.  To be called where h changes and where drives have a
 * kink.  *changed: the size of the change, |dv|_M/sqrt(m), m/s. */
enum hobe_status settle(struct genalpha *g, double *changed, struct hobe_error *err);

/* rate[vectors][3] on the multipliers: Phi_q v + Phi_t of a state; 0 elsewhere.  moved and f of the
 * same shape are overwritten. */
void settle_rate(const struct genalpha *g, const struct genalpha_state *at, double *moved,
                 double *f, double *rate);

#endif
