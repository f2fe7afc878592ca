/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the ways to solve an eigenproblem share.  Between modal.c and modal_lanczos.c only. */
#ifndef HOBE_MODAL_H
#define HOBE_MODAL_H

#include "model.h"

struct modal {
    hobe_model *model;
    const hobe_solution *state; /* or NULL */
    long n, multipliers;        /* scalar unknowns, and how many of them are multipliers */
    double *u, *r;              /* [vectors][3] state, and a force nobody reads */
    double *Ax, *Mx;            /* D K D and D M D in the model's pattern */
    double *Sx;                 /* a shifted matrix */
    double *scale, *ones;       /* [n] D, and no further scale */
    double *product;            /* [n] M x */
    int room;                   /* modes found, wanted or more */
    double *omega2, *X;         /* [room], [room][n]: x = phi / D */
};

/* Entries of the model's pattern. */
static inline long values(const struct modal *s)
{
    return s->model->pattern.Ap[s->n];
}

static inline double dot(long n, const double *a, const double *b)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* y = M x. */
void modal_multiply_mass(void *context, const double *x, double *y);

/* full[n][n] = A - sigma M, A given by its values in the pattern. */
void modal_spread(const struct modal *s, const double *Ax, double sigma, double *full);

/* Room for omega2 and X of so many modes; what was there is lost. */
enum hobe_status modal_make_room(struct modal *s, int modes, struct hobe_error *err);

/* At least `modes` lowest modes and the number of unstable ones, by shift-invert Lanczos. */
enum hobe_status modal_lanczos(struct modal *s, int modes, int *unstable, struct hobe_error *err);

#endif
