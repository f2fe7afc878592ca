/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A path that is being followed, between the rooms that do it (path*.c). */
#ifndef HOBE_PATH_PARTS_H
#define HOBE_PATH_PARTS_H

#include "solver.h"
#include "series.h"
#include "solution.h"

struct hobe_path {
    struct hobe_path_info info;
    struct list points, events; /* hobe_solution *, struct hobe_path_event */
};

/* The plane c.u + kappa lambda = value, c over the unknowns. */
struct plane {
    double *c, kappa, value;
};

struct follower {
    struct solver s;
    struct hobe_path_options options;
    hobe_path *path;
    long n;                     /* unknowns */
    double *W;                  /* [n] W/c */
    double *q;                  /* [n] K^-1 Q */
    double *v, kappa;           /* [n] the tangent at the last point */
    double *force;              /* [vectors][3] Q */
    double lambda, last_lambda; /* now, and at the last point, whose state is s.start */
    double mend;                /* of lambda, with s.x */
    struct plane step, reach, load;
    const struct plane *plane; /* that of the last iteration */
    struct series series;
    int symmetric, turned; /* no follower forces; the load turned on the last step */
    double extreme;        /* the load there */
    double started;
};

static inline int path_by_series(const struct follower *f)
{
    return f->options.newton.method == HOBE_METHOD_SERIES;
}

/* ---- one point (path_point.c) --------------------------------------------------------------- */

/* How far (u, lambda) is from the plane: c.u + kappa lambda - value. */
double path_distance(const struct follower *f, const struct plane *plane, const double *u,
                     double lambda);

/* |(v, kappa)|, v[n] */
double path_length(const struct follower *f, const double *v, double kappa);

/* f->step = the plane normal to the tangent at the current state. */
void path_set_plane(struct follower *f);

/* f->q = K^-1 Q by the last factors. */
enum hobe_status path_solve_load(struct follower *f, struct hobe_error *err);

/* s.x and mend: the correction to where the linearised equations and the plane meet, by the last
 * factors; and takes it. */
enum hobe_status path_find_correction(struct follower *f, const struct plane *plane,
                                      struct hobe_error *err);
void path_take_correction(struct follower *f);

/* Newton from the current state to the equilibrium in a plane. */
enum outcome path_iterate(struct follower *f, const struct plane *plane, struct hobe_error *err);

/* Negative eigenvalues of the tangent at the current state, in s.info, and its factors. */
enum outcome path_count_and_factor(struct follower *f, struct hobe_error *err);

/* ---- steps by series (path_series.c) -------------------------------------------------------- */

/* The longest step from a new point; by series, how far that is good. */
enum hobe_status path_expand(struct follower *f, double *longest, struct hobe_error *err);

/* Moves along the series, at most `arc`; the plane normal to it there, or that of an end of the
 * path. */
const struct plane *path_predict_by_series(struct follower *f, double arc);

/* ---- events (path_event.c) ------------------------------------------------------------------ */

/* Adds what happened between the last point, with its negative eigenvalues and kappa, and this
 * one. */
enum hobe_status path_find_events(struct follower *f, int before_negative, double before_kappa,
                                  struct hobe_error *err);

#endif
