/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads, between the rooms that do them (load*.c). */
#ifndef HOBE_LOAD_PARTS_H
#define HOBE_LOAD_PARTS_H

#include "load.h"

/* ---- places (load_station.c) ---------------------------------------------------------------- */

/* The section or body on which a load acts. */
struct station {
    struct place place;      /* on a beam, */
    const struct body *body; /* or of this */
    int vectors;
    double weight[3][HOBE_MAX_VECTORS]; /* of its vectors in r, r_y, r_z there */
    double slope[2][3];                 /* r_y, r_z there */
    double frame[3][3];                 /* the section's axes there in the reference, rows */
};

/* Finds that of a force or moment in state u, NULL: the reference; of a body at a point, NULL: its
 * centre.  The same at a place of a beam. */
void station_find(const struct hobe_model *model, const struct target *on, const double *point,
                  const double *u, struct station *s);
void station_on_beam(const struct hobe_model *model, struct place place, const double *u,
                     struct station *s);

/* The model's number of one of its vectors. */
long station_vector(const struct hobe_model *model, const struct station *s, int v);

/* r += factor * w_v F over the vectors' weights in r, r_y or r_z (of: 0, 1, 2). */
void station_add_force(const struct hobe_model *model, const struct station *s, int of,
                       const double F[3], double factor, double *r);

/* K += factor * w_v w_w G over the weights in one of them and in another. */
void station_add_stiffness(const struct hobe_model *model, const struct station *s, int of_v,
                           int of_w, const double G[3][3], double factor, const struct matrix *K);

/* touched[vectors] = 1 at those with weights in one of `from` to `to`. */
void station_touch(const struct hobe_model *model, const struct station *s, int from, int to,
                   unsigned char *touched);

/* ---- forces and moments at places (load_placed.c) ------------------------------------------- */

/* The point of a body that a force acts on; NULL: its centre. */
static inline const double *load_point(const struct force *force)
{
    return force->spec.at_point ? force->spec.point : NULL;
}

/* r -= factor * Q of any force but the constant dead ones, or of a moment; K likewise, unless NULL,
 * as in load_subtract. */
void load_subtract_force(const struct hobe_model *model, const struct force *force, const double *u,
                         const struct instant *instant, double factor, double *r,
                         const struct matrix *K);
void load_subtract_moment(const struct hobe_model *model, const struct moment *load,
                          const double *u, const struct instant *instant, double factor, double *r,
                          const struct matrix *K);

/* ---- weights (load_weight.c) ---------------------------------------------------------------- */

/* Adds the weights that do not change in time to model->dead, once all masses are known. */
enum hobe_status load_build_weights(struct hobe_model *model, struct hobe_error *err);

/* g = gravity as far as it has histories, m/s^2. */
void load_changing_gravity(const struct hobe_model *model, const struct instant *instant,
                           double g[3]);

/* f[vectors][3] += factor times the weight of an element: M a, with a = g on every position of the
 * centreline; or of all elements, bodies and masses. */
void load_add_weight(const struct hobe_model *model, const struct beam *beam, int e,
                     const double g[3], double factor, double *f);
void load_add_weights(const struct hobe_model *model, const double g[3], double factor, double *f);

#endif
