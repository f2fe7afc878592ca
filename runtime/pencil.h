/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The eigenproblem K x = mu M x in a model's pattern: K the tangent stiffness in a state, M the
 * mass (vibration) or what a load takes from K (buckling).
 *
 * Both matrices are scaled by D = diag(K)^(-1/2), without which K's condition reaches 1e25 (rich
 * section modes).  Solved is the inverse problem M x = nu K x, nu = 1/mu: the spectrum of a beam
 * spans ten decades and more, and rounding is relative to the largest eigenvalue, which must
 * therefore be that of the lowest mode. */
#ifndef HOBE_PENCIL_H
#define HOBE_PENCIL_H

#include "model.h"

struct pencil {
    hobe_model *model;
    const hobe_solution *state; /* or NULL: the reference without load */
    int buckling;         /* K is definite and M is not: K's inner product, and mu > 0 is wanted */
    double least;         /* the nu up to which such a mu is taken for infinite */
    long n, multipliers;  /* scalar unknowns, and how many of them are multipliers */
    long rank;            /* modes that there are: those of K^-1 M */
    double *u, *r;        /* [vectors][3] state, and a force nobody reads */
    double *Ax, *Mx;      /* D K D and D M D in the model's pattern */
    double *Sx;           /* a shifted matrix */
    double *fronts;       /* its factors where they need no pivoting; NULL: the model has none */
    enum layout factored; /* whose factors are the last */
    double *scale, *ones; /* [n] D, and no further scale */
    double *product;      /* [n] M x */
    int room;             /* modes found, wanted or more */
    double *mu, *X;       /* [room], [room][n]: x = phi / D */
};

/* Entries of the model's pattern. */
static inline long values(const struct pencil *s)
{
    return s->model->pattern.Ap[s->n];
}

/* Memory for the matrices, and the state's displacements in u.  HOBE_BAD_INPUT where the state is
 * another model's, or holds follower forces, whose stiffness is not symmetric: said of `what`. */
enum hobe_status pencil_open(struct pencil *s, const char *what, struct hobe_error *err);
void pencil_close(struct pencil *s);

/* Settles how many modes, and by which method. */
enum hobe_status pencil_choose(const struct pencil *s, struct hobe_modal_options *options,
                               struct hobe_error *err);

/* The tangent stiffness of elements, corners and loads at the displacements s->u and a load factor,
 * into Ax; not scaled. */
void pencil_tangent(struct pencil *s, double factor, double *Ax);

/* Ax to D Ax D. */
void pencil_scale(const struct pencil *s, double *Ax);

/* Factors of a matrix in the model's pattern, Ax[values], scaled as by hobe_linsolve_factor; and
 * x[n] = its inverse times x by the last of them. */
enum hobe_status pencil_factor(struct pencil *s, const double *Ax, const double *scale,
                               struct hobe_error *err);
enum hobe_status pencil_divide(struct pencil *s, double *x, struct hobe_error *err);

/* Solves; s->mu and s->X hold at least so many lowest modes, mu ascending (where buckling, that is
 * infinite where no such load is), and *unstable those with mu < 0, asked for or not; -1: not
 * counted. */
enum hobe_status pencil_solve(struct pencil *s, const struct hobe_modal_options *options,
                              int *unstable, struct hobe_error *err);

/* Makes the first `count` modes orthonormal, x'Mx = 1. */
void pencil_orthonormalize(struct pencil *s, int count);

/* ---- between pencil.c and pencil_lanczos.c -------------------------------------------------- */

/* y = M x and y = K x. */
void pencil_multiply(void *context, const double *x, double *y);
void pencil_multiply_stiffness(void *context, const double *x, double *y);

/* full[n][n] = A - sigma M, A given by its values in the pattern. */
void pencil_spread(const struct pencil *s, const double *Ax, double sigma, double *full);

/* Room for mu and X of so many modes; what was there is lost. */
enum hobe_status pencil_make_room(struct pencil *s, int modes, struct hobe_error *err);

/* 1/nu, or infinite. */
double pencil_mu(const struct pencil *s, double nu);

/* Says that K is not definite where buckling. */
enum hobe_status pencil_fail_unstable(struct hobe_error *err);

/* pencil_solve by shift-invert Lanczos. */
enum hobe_status pencil_lanczos(struct pencil *s, int modes, int *unstable, struct hobe_error *err);

#endif
