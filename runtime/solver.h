/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the ways to equilibrium and through time share: residual, tangent, correction and when to
 * stop.  For newton.c (load steps), path.c (arc length) and genalpha.c (steps in time) only.
 *
 * Residuals are measured in the norm |D r|, D = diag(K_0)^(-1/2) at the reference, which gives
 * forces on positions and on slopes of any mode the same unit (root of energy); the tangent is
 * scaled by the same D before it is factored. */
#ifndef HOBE_SOLVER_H
#define HOBE_SOLVER_H

#include "jump.h"
#include "subspace.h"

/* What motion adds to statics: the residual gets the forces of inertia M w, the tangent M dw/du,
 * and both take velocities from the instant.  All zero in statics. */
struct motion {
    struct instant instant;
    const double *force; /* [vectors][3] M w, N; NULL: none */
    double inertia;      /* dw/du, 1/s^2 */
    int mass_alone;      /* the matrix is M bordered by the constraints' derivatives instead */
};

struct solver {
    hobe_model *model;
    struct hobe_newton options;
    struct motion motion;
    double *u;       /* [vectors][3] accepted state, then the one being found */
    double *start;   /* state at the start of the step */
    double *r;       /* [vectors][3] residual F - factor Q */
    struct matrix K; /* tangent of the last evaluation, or its factors where they are fronts */
    double factor;   /* of the load there */
    double *turned;  /* [vectors][3] state of the last tangent */
    double *step;    /* [vectors][3] from the tangent before, where this one expects it */
    int expecting;
    struct matrix mass;     /* M, where it is needed often (solver_keep_mass) */
    struct matrix pivoting; /* the tangent once more where fronts need it, in columns */
    enum layout factored;   /* whose factors are the last */
    double *x;              /* [unknowns] right-hand side and correction */
    double *scale;          /* [unknowns] D */
    double load_norm;       /* |D Q| at the reference */
    double *reference;      /* [unknowns] D of the space, that of the reference; NULL: none */
    struct subspace space;  /* where corrections are sought, once solver_confine has been called */
    struct jump jump;       /* what the iterations look like */
    struct hobe_solution_info info;
    struct hobe_iteration now;
    long singular;      /* column of a vanishing pivot */
    const char *reason; /* why the last attempt failed */
};

enum outcome { CONVERGED, GOING_ON, FAILED, ERROR };

/* Memory, the scale and the load's norm at the reference, where s->u is left. */
enum hobe_status solver_open(struct solver *s, hobe_model *model, const struct hobe_newton *options,
                             struct hobe_error *err);
void solver_close(struct solver *s);

/* Lays the tangent out in columns from now on, for what is not symmetric. */
enum hobe_status solver_use_columns(struct solver *s, struct hobe_error *err);

/* Keeps M in the layout of the tangent, to which motion adds it again and again. */
enum hobe_status solver_keep_mass(struct solver *s, struct hobe_error *err);

/* Looks for corrections in the space that options.projection makes about the state s->u under the
 * load factor, from now on; nothing where there is none. */
enum hobe_status solver_confine(struct solver *s, double factor, struct hobe_error *err);

/* One line of the log, with a note. */
void solver_log(struct solver *s, const char *note);

/* The residual in the current state; and the tangent when asked for, the true one or that which is
 * best for the next iteration, with the stresses expected of the last. */
enum tangent { NO_TANGENT, TRUE_TANGENT, NEXT_TANGENT };
void solver_evaluate(struct solver *s, double factor, enum tangent tangent);

/* |D^p field| over the unknowns, p = 1 for forces, of which only the part along the space counts
 * where there is one, -1 for displacements; NaN where the field is. */
double solver_norm(const struct solver *s, const double *field, int p);

/* Takes one more correction of a converged state, where there are factors, into info.change; FAILED
 * where round-off leaves no digits or the state is turned inside out. */
enum outcome solver_refine(struct solver *s, struct hobe_error *err);

/* Whether the iteration is over, and how, by the residual's norm and the one before. */
enum outcome solver_judge(struct solver *s, double norm, double last_norm);

/* Factors of the tangent: CONVERGED, FAILED where it is singular, ERROR. */
enum outcome solver_factor(struct solver *s, struct hobe_error *err);

/* The negative eigenvalues, on what constraints leave free, of the tangent that was factored last,
 * which must be symmetric; -1 where that is not known. */
enum hobe_status solver_negative(struct solver *s, long *negative, struct hobe_error *err);

/* x = factor K^-1 field by the last factors. */
enum hobe_status solver_solve(struct solver *s, const double *field, double factor, double *x,
                              struct hobe_error *err);

/* x = the entries of a vector field at the unknowns. */
void solver_restrict(const hobe_model *model, const double *field, double *x);

/* u += factor x */
void solver_move(struct solver *s, const double *x, double factor);

/* Measures the correction x by a residual that was small enough, in info.change: one of round-off
 * may move a slender beam far, and taking the correction, too, mends most of that.  FAILED where it
 * leaves nothing. */
enum outcome solver_measure(struct solver *s);

/* The volume of the converged state: FAILED where it is turned inside out. */
enum outcome solver_check_volume(struct solver *s, struct hobe_error *err);

/* A solution with a copy of the state; NULL with err set. */
hobe_solution *solver_take(struct solver *s, double started, struct hobe_error *err);

/* Says where the scene can move without resistance, by the column of a vanishing pivot. */
enum hobe_status solver_name_free(const struct solver *s, struct hobe_error *err);

#endif
