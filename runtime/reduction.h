/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A reduced model is a model: its state holds the coordinates q of u = u_c + sum_j q_j phi_j, three
 * to a vector, then the vectors of bodies and the multipliers of the whole model, one to one.  What
 * the last vector of coordinates has too many of are spare, as multipliers may be (constraint.h).
 *
 * It has no items: forces, joints, springs and bodies are those of the whole model and act on its
 * arrays, at the few vectors they touch; expanded to these and projected from them their sums cost
 * no more for a long beam than for a short one.  Elements, inertia and dead loads are projected
 * once.  Statics, paths, vibration and motion take the model as any other, since the rooms they
 * call ask here where model->reduction is not NULL. */
#ifndef HOBE_REDUCTION_H
#define HOBE_REDUCTION_H

#include "model.h"
#include "reduced.h"

struct reduction {
    const struct hobe_reduced *of; /* basis and elastic energy */
    hobe_model *whole;
    long n, blocks;          /* coordinates, and the vectors that hold them */
    long touched;            /* vectors of beams that items act on, */
    long *vector;            /* [touched] their numbers in the whole model, */
    double *J;               /* [touched][3][n] and phi_j there */
    double *mass;            /* [3][3][n][n] phi_i,a' m phi_j,b, kg */
    double *damping;         /* [n][n] of the forces alpha M v, kg/s */
    double *position;        /* [3][3][n] phi_i,a' m (x_0 + u_c)_b, of the reference x_0, kg m */
    double *weight;          /* [3][n] phi_i,a' m 1: the work of a unit acceleration, kg */
    double *u, *v, *f, *all; /* [vectors][3] of the whole model: zero but where touched; all: any */
    unsigned char *dropped;  /* [3 behind the beams' vectors] multipliers of constraints that the
                                basis keeps by itself: they are spare */
    long drops;              /* how many */
    struct matrix K;         /* of the vectors touched, then bodies and multipliers */
    double *dense, *product; /* [n][n], and n more; [3 touched][n] */
    double *scale;           /* [3 unknowns] of the whole model */
    long *place[LAYOUTS];    /* [unknowns][unknowns] where the block (i, j) lies: column j first */
};

/* The model whose items act: itself, or the whole one. */
static inline const hobe_model *model_whole(const hobe_model *model)
{
    return model->reduction ? model->reduction->whole : model;
}

/* The number in a model of a body's vector or a multiplier that has this one in the whole. */
static inline long model_number(const hobe_model *model, long v)
{
    const struct reduction *r = model->reduction;
    return r ? v - r->whole->beam_vectors + r->blocks : v;
}

/* Whether the basis keeps constraint k of a tie with the multipliers from this vector on. */
static inline int reduction_drops(const hobe_model *model, long multiplier, int k)
{
    const struct reduction *r = model->reduction;
    return r && r->dropped[3 * (multiplier - r->whole->beam_vectors) + k];
}

/* Forces of some items of a model, f += and K += unless NULL; `factor` for what has one. */
typedef void reduction_items(const hobe_model *model, const double *u,
                             const struct instant *instant, double factor, double *f,
                             const struct matrix *K);

/* Has items act on a model; of a reduced one on the whole, projected. */
void reduction_act(const hobe_model *model, reduction_items *act, const double *u,
                   const struct instant *instant, double factor, double *f, const struct matrix *K);

/* The rest is for models whose reduction is not NULL.
 *
 * The whole model's fields at what items touch, valid until the next call: of a state u, and of
 * velocities. */
const double *reduction_state(const hobe_model *model, const double *u);
const double *reduction_rates(const hobe_model *model, const double *v);

/* Everywhere: field[vectors][3] of the whole model; with the centre for states, without for
 * rates. */
void reduction_expand(const hobe_model *model, const double *q, int state, double *field);

/* f += phi'F, a field of forces F on the whole model. */
void reduction_project(const hobe_model *model, double factor, const double *F, double *f);

/* f = dU/dq and K = d2U/dq2 unless NULL, overwritten; U, J. */
void reduction_elastic(const hobe_model *model, const double *u, double *f, const struct matrix *K);
double reduction_energy(const hobe_model *model, const double *u);

/* |D^-1 u| of the centre, by its energy: a root of J, as coordinates are in a basis that is normal
 * in the stiffness. */
double reduction_centre(const hobe_model *model);

/* f = by how much dU/dq changes where the state is changed in its last digits: what rounding leaves
 * of it. */
void reduction_round_off(const hobe_model *model, const double *u, double *f);

/* Spare coordinates are held by the energy q^2/2. */
void reduction_spare(const hobe_model *model, const double *u, double *f, const struct matrix *K);

/* mass.h: with m (x) A. */
void reduction_mass_force(const hobe_model *model, const double A[3][3], const double *a,
                          double *f);
double reduction_mass_product(const hobe_model *model, const double *a, const double *b);
void reduction_mass_matrix(const hobe_model *model, const double A[3][3], const struct matrix *K);

/* f += (m (x) A) (x - o), x the centre's positions and o a point. */
void reduction_arm_force(const hobe_model *model, const double A[3][3], const double o[3],
                         double *f);

/* f += factor times the weights of all in the gravity g, m/s^2. */
void reduction_weights(const hobe_model *model, const double g[3], double factor, double *f);

/* f += alpha M v of beams, N, and K += rate times its matrix; and their power, W. */
void reduction_damping(const hobe_model *model, const struct instant *instant, double *f,
                       const struct matrix *K);
double reduction_damping_power(const hobe_model *model, const double *v);

/* Momentum, kg m/s, and angular momentum about the origin, kg m^2/s. */
void reduction_momenta(const hobe_model *model, const double *u, const double *v,
                       double momentum[3], double angular[3]);

/* q = the rates nearest to a field v of the whole model in the norm of M, and *left = |v - phi q|
 * over |v|. */
enum hobe_status reduction_fit(const hobe_model *model, const double *v, double *q, double *left,
                               struct hobe_error *err);

/* HOBE_BAD_INPUT where the whole model has a viscous stress, which is not reduced. */
enum hobe_status reduction_check_motion(const hobe_model *model, struct hobe_error *err);

/* scale[3 unknowns] = diag^(-1/2), with what is left to bodies (body_scale), and to coordinates
 * that nothing but joints holds. */
void reduction_scale(const hobe_model *model, double *scale);

/* Finds the multipliers to drop, in the reference, whose state at the vectors touched is given. */
enum hobe_status reduction_drop(struct reduction *r, const double *state, struct hobe_error *err);

/* Gives a state of the whole model that was expanded the multipliers of joints that the basis
 * keeps, which balance the forces there. */
enum hobe_status reduction_reactions(const struct reduction *r, struct hobe_solution *state,
                                     struct hobe_error *err);

/* x = A^-1 x of a symmetric positive definite A[n][n], whose lower triangle is overwritten.  What A
 * has no part in becomes zero. */
void reduction_solve(long n, double *A, double *x);

/* The reduced form of a whole model that is built, to be freed with its model; NULL with err. */
struct reduction *reduction_open(const struct hobe_reduced *of, hobe_model *whole,
                                 struct hobe_error *err);
void reduction_free(struct reduction *r);

#endif
