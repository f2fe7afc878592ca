/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modes as they are handed out: of vibration (modal.c) and of buckling (buckling.c). */
#ifndef HOBE_MODES_H
#define HOBE_MODES_H

#include "pencil.h"

struct hobe_modes {
    const hobe_model *model;
    struct hobe_modes_info info;
    double *mu;    /* [count] omega^2 or the critical load factor */
    double *shape; /* [count][vectors][3] */
    /* Of a turning frame, else NULL: shape + i quadrature, in time exp(lambda t). */
    double *quadrature; /* [count][vectors][3] */
    double *exponent;   /* [count][2] Re and Im of lambda, Im >= 0, 1/s */
    double w[3];        /* the frame's angular velocity, rad/s */
    char note[300];
};

/* The first `count` modes of a solved pencil, orthonormal; NULL with err set. */
hobe_modes *modes_take(struct pencil *s, int count, enum hobe_modal_method method,
                       struct hobe_error *err);

/* Room for `count` modes, nothing found; NULL with err set. */
hobe_modes *modes_new(const struct pencil *s, int count, enum hobe_modal_method method,
                      struct hobe_error *err);

/* field[vectors][3] = phi = D x on the unknowns, zero where held. */
void modes_spread(const struct pencil *s, const double *x, double *field);

/* The same on the model of the modes, which is the whole one of a reduced model. */
void modes_expand(const struct pencil *s, const double *x, double *field);

/* Finds the modes of a pencil; the options are a copy of the caller's. */
typedef enum hobe_status modes_solver(struct pencil *s, struct hobe_modal_options *options,
                                      hobe_modes **modes, struct hobe_error *err);

/* Builds the pencil's model, has its modes found, timed, and closes the pencil. */
enum hobe_status modes_find(struct pencil *s, const struct hobe_modal_options *options,
                            modes_solver *solve, hobe_modes **modes, struct hobe_error *err);

/* The shape of mode i, [vectors][3], or NULL with err. */
const double *modes_shape(const hobe_modes *modes, int i, struct hobe_error *err);

#endif
