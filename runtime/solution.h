/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A state of a model and how it was found. */
#ifndef HOBE_SOLUTION_H
#define HOBE_SOLUTION_H

#include "model.h"

struct hobe_solution {
    const hobe_model *model;
    double *u;     /* [vectors][3] displacements of the nodal vectors, and multipliers */
    double *v, *w; /* [vectors][3] velocities and accelerations; NULL of equilibria */
    struct hobe_solution_info info;
    /* Of a reduced model, `model` is the whole one; and what was expanded: */
    const struct hobe_reduced *reduced; /* NULL: it was whole */
    long coordinates;                   /* vectors of the reduced model */
    double *q;                          /* [3][coordinates][3] its u, v, w */
};

/* The fields of a state as its model, or a reduced one of the same shape, has them. */
enum { SOLUTION_U, SOLUTION_V, SOLUTION_W };
static inline const double *solution_field(const struct hobe_solution *state,
                                           const hobe_model *model, int which)
{
    const double *const whole[] = {state->u, state->v, state->w};
    return !model->reduction || !whole[which] ? whole[which]
                                              : state->q + 3 * which * state->coordinates;
}

/* When a state of a model is, for its constraints and loads; NULL: the reference, where nothing is
 * driven yet. */
static inline struct instant solution_instant(const struct hobe_solution *state,
                                              const hobe_model *model)
{
    return state ? (struct instant){.time = state->info.time,
                                    .v = solution_field(state, model, SOLUTION_V)}
                 : (struct instant){.held_back = 1};
}

/* Whether it is a state of this very model, whole or reduced. */
int solution_is_of(const struct hobe_solution *state, const hobe_model *model);

/* A state with copies of the fields [vectors][3], those of joined vectors spread; v and w NULL: an
 * equilibrium.  Of a reduced model the state of the whole.  NULL with err set. */
hobe_solution *solution_new(const hobe_model *model, const double *u, const double *v,
                            const double *w, const struct hobe_solution_info *info,
                            struct hobe_error *err);

/* The i-th of a list of hobe_solution *, owned by the list; NULL where there is none.  Taken from
 * the list it is the caller's.  Frees all of them, and the list's memory. */
const hobe_solution *solutions_get(const struct list *list, int i);
hobe_solution *solutions_take(struct list *list, int i);
void solutions_free(struct list *list);

/* *smallest = min det F over the stations of all elements and the corners and centre of their
 * sections: the deformation has turned inside out where it is not positive. */
enum hobe_status solution_smallest_volume(const hobe_model *model, const double *u,
                                          double *smallest, struct hobe_error *err);

/* Displacement u at a place of a beam, as in hobe_solution_point, of the field vectors[..][3]; and
 * where the place is in the reference, r0 (may be NULL). */
enum hobe_status solution_displacement(const hobe_model *model, const double *vectors,
                                       const char *beam, double at, double y, double z,
                                       double r0[3], double u[3], struct hobe_error *err);

/* The body called name; NULL with err where there is none. */
const struct body *solution_find_body(const hobe_model *model, const char *name,
                                      struct hobe_error *err);

/* The model that vibrates, and hobe_modes_point with the place in the reference (modal.c). */
const hobe_model *modes_model(const hobe_modes *modes);
enum hobe_status modes_displacement(const hobe_modes *modes, int i, const char *beam, double at,
                                    double y, double z, double r0[3], double u[3],
                                    struct hobe_error *err);

#endif
