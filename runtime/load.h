/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forces, moments and gravity; and the centrifugal force. */
#ifndef HOBE_LOAD_H
#define HOBE_LOAD_H

#include "model.h"

/* What a force or moment acts on: a body or, NULL, a place of a beam; whose beam is NULL otherwise.
 */
struct target {
    const struct body *body;
    struct place place;
};
struct force {
    struct hobe_force spec;
    struct target on; /* as load_find finds it, also of moments */
};
struct moment {
    struct hobe_moment spec;
    struct target on;
};

static inline struct force *model_force(const struct hobe_model *model, size_t i)
{
    return (struct force *)model->forces.item + i;
}

static inline struct moment *model_moment(const struct hobe_model *model, size_t i)
{
    return (struct moment *)model->moments.item + i;
}

/* Finds what forces and moments act on, in this model. */
enum hobe_status load_find(struct hobe_model *model, struct hobe_error *err);

/* The same, and sums what does not depend on the state into model->dead. */
enum hobe_status load_build(struct hobe_model *model, struct hobe_error *err);

/* r -= factor * Q, and K -= factor * (dQ/du + rate dQ/dv) when K is not NULL: Q the forces of all
 * loads on the vectors in state u at an instant, [vectors][3], N or N m.  Where a history or a
 * function of the caller fails r is NaN, and the error waits in the model (model_failure). */
void load_subtract(const struct hobe_model *model, const double *u, const struct instant *instant,
                   double factor, double *r, const struct matrix *K);

/* Q[vectors][3] = the coefficient of a^k of the forces of all loads along the states u_0 + a u_1 +
 * ... + a^(known-1) u_(known-1), u[known], at rest at the instant; known <= k + 1, k <=
 * TAYLOR_ORDER (taylor.h). */
void load_series(const struct hobe_model *model, const double *const *u,
                 const struct instant *instant, int known, int k, double *Q);

/* f[vectors][3] += factor * the forces of the loads on element e of a beam that do not act at its
 * ends: its weight, and what acts between them.  As above, errors of the caller's functions wait in
 * the model. */
void load_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double factor, const struct beam *beam, int e, double *f);

/* touched[vectors] = 1 at the vectors that forces and moments at places act on; of those alone
 * whose force or stiffness changes with the state or in time where `changing`.  Not of weights and
 * spins.
 */
void load_touch(const struct hobe_model *model, int changing, unsigned char *touched);

/* Adds the force F, N, at a place of a beam to the forces on the vectors, r[vectors][3].
 * HOBE_UNKNOWN with `where` for a beam that is not there. */
enum hobe_status load_at(const struct hobe_model *model, const char *beam, double at,
                         const double F[3], const char *where, double *r, struct hobe_error *err);

/* Whether the stiffness of some load is not symmetric, since it turns with the section, or is a
 * function of the caller: such a force, or NULL. */
const struct hobe_force *load_follower(const struct hobe_model *model);

#endif
