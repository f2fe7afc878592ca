/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Joints by Lagrange multipliers: Phi(q) = 0, energy lambda . Phi.
 *
 * A tie relates a place of a beam, b, to another, a, or to the ground by up to six scalar
 * constraints.  At a place a section has its position r, its slopes y = r_y and z = r_z, and their
 * normal n = y x z: three directions D = (n, y, z) that are its axes where it is not strained. With
 * d = u_b - u_a, the displacement of b against a, each constraint is
 *
 *     Phi = turn : (D_a' D_b - D_a0' D_b0) + (slide D_a + hold + bend d/2) . d
 *
 * with D_a' D_b = [D_ai . D_bj], a polynomial of the places' vectors: `turn` keeps the angles
 * between directions, `slide` and `hold` the place of b on the axes of a, and on the global ones;
 * `bend` makes the plane of `hold` a sphere.  r, y and z are sums of nodal vectors by the axial
 * functions, so that a tie may sit anywhere on a beam.
 *
 * A drive turns a's directions, as b sees them, by theta(t) about an axis that they carry: with R
 * the rotation in their components, `turn` becomes R turn, a function of time, and Phi
 *
 *     R turn : (D_a' D_b - D_a0' D_b0) + (R - 1) turn : D_a0' D_b0 + ... - way(t).
 *
 * Each tie owns blocks of three multipliers, which the model numbers behind the beams' vectors: the
 * state u holds them like three more displacements.  Spare ones of its last block are held at zero
 * by an energy lambda^2/2 of their own. */
#ifndef HOBE_CONSTRAINT_H
#define HOBE_CONSTRAINT_H

#include "model.h"

struct body;

enum {
    TIE_CONSTRAINTS = 9,
    TIE_VECTORS = 6 /* r, y, z of a, then of b */
};

struct constraint {
    double turn[3][3], slide[3], hold[3], bend;
    int driven;    /* by the tie's position: it keeps way = s + bend s^2/2 instead of 0 */
    double offset; /* what drives add to Phi, at an instant */
};

/* One of the two places: on a beam, where that is not NULL; of a body; or of the ground, whose
 * directions are the global axes.  y and z of a body are two of its directions. */
struct tied {
    struct place place;
    const struct body *body;
    int slope[2];                    /* which: y and z are d_{1 + slope} */
    double position[3], frame[3][3]; /* in the reference, m; the section's axes there, rows */
    double D0[3][3];                 /* n, y, z there, rows */
};

/* A nodal vector's part in r, y or z of one of the places. */
struct tie_term {
    int entry, what; /* place in `vector`; 3 * (0: a, 1: b) + (0: r, 1: y, 2: z) */
    double weight;   /* axial function */
};

struct tie {
    const char *where, *name; /* of the joint; NULL of a corner */
    int corner;               /* from a join of beams at an angle */
    int rigidity;             /* of a body with itself: it stops no motion */
    struct tied side[2];
    int constraints;
    struct constraint constraint[TIE_CONSTRAINTS];
    hobe_drive *angle, *position; /* theta, rad, and s, m; NULL: not driven */
    double axis[3];               /* of theta, a unit vector on the axes of a */
    long multiplier; /* the first block's number in the model, blocks follow each other */
    int terms, vectors, blocks;
    struct tie_term *term; /* [terms] */
    long *vector;          /* [vectors] numbers in the model, without repeats, multipliers last */
    long *place[LAYOUTS];  /* [vectors][vectors] of their blocks in a tangent, -1: none */
};

static inline struct tie *model_tie(const struct hobe_model *model, size_t i)
{
    return (struct tie *)model->ties.item + i;
}

/* Where constraint k has its multiplier among the entries of `vector`. */
static inline int tie_entry(const struct tie *tie, int k)
{
    return tie->vectors - tie->blocks + k / 3;
}

/* Finds a place of a beam in the reference. */
void tied_at(struct place place, struct tied *tied);

/* The same for a point of a body, global axes, m; y and z of a joint are d_2 and d_3. */
void tied_on_body(const struct body *body, const double point[3], const int slope[2],
                  struct tied *tied);

/* Adds a tie between two places to a model, without constraints; NULL with err set. */
struct tie *tie_add(struct hobe_model *model, const struct tied *a, const struct tied *b,
                    struct hobe_error *err);

/* The next constraint of a tie, to be filled. */
struct constraint *tie_constraint(struct tie *tie);

/* Three constraints: b does not turn against a.  With P the axes of b as directions of a, they are
 * the skew part of P' D_b, which vanishes when both sections are turned alike, whatever their
 * stretch. */
void tie_turning(struct tie *tie);

/* Six: the slopes y, z of the one keep their components on the directions n, y, z of the other, a
 * body or the ground. */
void tie_slopes(struct tie *tie);

/* Numbers the multipliers, and finds the vectors that a tie whose constraints are complete acts on.
 */
enum hobe_status tie_resolve(struct hobe_model *model, struct tie *tie, struct hobe_error *err);
void tie_free(struct tie *tie);

/* J[k] = the derivatives of the constraints by r, y, z of both places in the reference. */
void tie_jacobian(const struct tie *tie, double J[TIE_CONSTRAINTS][TIE_VECTORS][3]);

/* What a tie does to its place b: force, N, and moment about it, N m, global axes.  Errors of its
 * drives. */
enum hobe_status tie_reaction(const struct tie *tie, const double *u, const struct instant *instant,
                              double force[3], double moment[3], struct hobe_error *err);

/* *power = lambda . Phi_t, W: what the drives of a tie do. */
enum hobe_status tie_power(const struct tie *tie, const double *u, const struct instant *instant,
                           double *power, struct hobe_error *err);

/* What a constraint measures between the places of a tie in state u, NULL: the reference; the tie
 * need not have it.  G = its derivatives by r, y, z of both places, H the second ones unless NULL.
 */
double tie_measure(const struct tie *tie, const struct constraint *c, const double *u,
                   double G[TIE_VECTORS][3], double (*H)[TIE_VECTORS][3][3]);

/* moved = r, y, z of both places in a field on the vectors, NULL: zero. */
void tie_motion(const struct tie *tie, const double *field, double moved[TIE_VECTORS][3]);

/* f += factor G and K += H, given on r, y, z of both places. */
void tie_add_force(const struct tie *tie, double factor, const double G[TIE_VECTORS][3], double *f);

/* The same of one of the places alone. */
void tie_add_side(const struct tie *tie, int side, double factor, const double G[TIE_VECTORS][3],
                  double *f);
void tie_add_tangent(const struct hobe_model *model, const struct tie *tie,
                     double H[TIE_VECTORS][TIE_VECTORS][3][3], const struct matrix *K);

/* Where K has scalar (a, b) of the block of a tie's entries i and j; NULL: it is held.  And K +=
 * amount there. */
double *tie_scalar(const struct hobe_model *model, const struct tie *tie, int i, int a, int j,
                   int b, const struct matrix *K);
void tie_add_at(const struct hobe_model *model, const struct tie *tie, int i, int a, int j, int b,
                double amount, const struct matrix *K);

/* f += d(lambda . Phi)/dq and Phi on the multipliers; K += its derivative unless NULL. */
void constraint_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                    double *f, const struct matrix *K);

/* f += the coefficient of a^k, k > 0, of that along the states u_0 + a u_1 + ... + a^(known-1)
 * u_(known-1), u[known]; known <= k <= TAYLOR_ORDER of taylor.h (constraint_series.c). */
void constraint_series(const struct hobe_model *model, const double *const *u, int known, int k,
                       double *f);

/* At the multipliers, into a field rate[vectors][3] that is zero elsewhere: Phi_t, what drives ask
 * of the velocities, Phi_q v + Phi_t = 0.  A drive that fails leaves its error in the model, and
 * NaN (model_failure); so below. */
void constraint_rate(const struct hobe_model *model, const double *u, const struct instant *instant,
                     double *rate);

/* The same of the second derivative of Phi along u + v t but for the accelerations a:
 * Phi_tt + 2 Phi_qt v + (Phi_q v)_q v, so that Phi_q a + this = 0; v[vectors][3], m/s. */
void constraint_acceleration(const struct hobe_model *model, const double *u, const double *v,
                             const struct instant *instant, double *out);

/* f[vectors][3] += what ties at places inside element e of a beam do to it, N. */
void constraint_inside(const struct hobe_model *model, const double *u,
                       const struct instant *instant, const struct beam *beam, int e, double *f);

#endif
