/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a built model holds: numbering, loads, sparsity.  Shared by the core's rooms only.
 *
 * Every beam owns a run of nodal vectors; element e of a beam uses vectors
 * first + e * step + (0 .. V-1), so that neighbours share those of their common node.  A join
 * makes a vector stand for another (`alias`); a vector that is neither an alias nor held has a
 * number `unknown` >= 0, and its three components are the scalar unknowns 3 * unknown + 0, 1, 2.
 * Behind the beams' vectors are those of rigid bodies, four each (body.h).
 * States u hold displacements of all vectors, and then the Lagrange multipliers, [vectors][3]. */
#ifndef HOBE_MODEL_H
#define HOBE_MODEL_H

#include "beam.h"
#include "fronts.h"
#include "hobe.h"
#include "linsolve.h"

/* Where something acts: an element of a beam and the place in it. */
struct place {
    const struct beam *beam;
    int element;
    double xi;
};

/* Whether it is inside element e of a beam, between its ends. */
static inline int place_inside(struct place place, const struct beam *beam, int e)
{
    return place.beam == beam && place.element == e && place.xi > 0 && place.xi < 1;
}

/* A list of items of one kind that grows. */
struct list {
    void *item;
    size_t count, room;
};

/* Compressed columns of 3 x 3 blocks, and their scalar form for the solver. */
struct pattern {
    long blocks;       /* columns */
    long *start, *row; /* [blocks + 1], [start[blocks]] */
    long *Ap, *Ai;     /* scalar columns */
};

/* The values of a matrix in the model's pattern: scalar (a, c) of the block at a place in column j
 * lies at value[place + c * stride[layout][j] + a]. */
struct matrix {
    enum layout layout;
    double *value;
};

/* What drives and some loads ask for beside the state u: the time and the velocities. */
struct instant {
    double time;      /* s */
    const double *v;  /* [vectors][3] m/s; NULL: at rest */
    double rate;      /* dv/du, 1/s, of the step in time: tangents are d/du + rate d/dv */
    double held_back; /* share of the drives' motion that is not done yet: 1 - the load factor in
                         statics, 0 in time */
};
static const struct instant AT_REST = {0, NULL, 0, 0};

/* The vectors that what is no element acts on, where that is asked for: those of beams that have
 * joints, springs, or loads that depend on the state or on time, and all behind the beams'. */
struct touched {
    long count, *vector; /* ascending, unknown ones alone */
    long *at;            /* [unknowns] their places in `vector`, -1: none; NULL: not asked for */
};

struct workspace {                               /* of one batch, large enough for every beam */
    hobe_lanes *q0, *u, *f, *K, *more, *scratch; /* more: a second K */
};

/* Gravity that changes in time. */
struct gravity {
    double g[3]; /* m/s^2 */
    hobe_drive *history;
    const char *where;
};

/* Runs of neighbouring batches in the order of assembly: those of one colour share no vector, so
 * that threads may take them at once, and sums are the same to the last digit for any number of
 * threads.  The last colour is of those left over, one after the other. */
enum { COLOURS = 64 };

struct task {
    const struct beam *beam;
    int first, count; /* batches */
};

struct schedule {
    struct task *task;
    long first[COLOURS + 1];
    int threads;
    struct workspace *work; /* [threads] */
};

struct hobe_model {
    struct list beams, clamps, forces, moments, joins, joints; /* struct beam, hobe_clamp, ... */
    struct list bodies, masses;   /* struct body (body.h), struct point_mass (point_mass.h) */
    struct list springs, motions; /* struct spring, hobe_motion */
    struct list gravities;        /* struct gravity, with a history */
    struct list ties;             /* struct tie (constraint.h), of corners, bodies and joints */
    double gravity[3];
    const char *gravity_where;
    struct hobe_spin spin; /* with a unit axis */
    int spun;              /* there is one */
    double *arm;           /* [vectors][3] reference from a point of the spin's axis, NULL: none */
    int built;
    enum hobe_status failed; /* a failed build is not tried again */
    struct hobe_error loose; /* what is free to move, where something is: its status is not 0 */
    long beam_vectors;       /* those of the beams */
    long moving;             /* and those of bodies behind them: all before the multipliers */
    long vectors;            /* and the blocks of multipliers behind them */
    long *alias, *unknown;   /* [vectors] */
    unsigned char *held;     /* [vectors] */
    long unknowns;           /* vectors solved for */
    double *dead;            /* [vectors][3] forces that do not depend on the state */
    struct pattern pattern;
    struct touched touched;
    struct parts *parts;         /* that nothing couples (parts.h), of a built one */
    struct reduction *reduction; /* of a reduced model (reduction.h); NULL: it is none */
    int *stride[LAYOUTS];        /* [unknowns] */
    hobe_fronts *fronts;         /* NULL where tangents are not symmetric */
    hobe_linsolve *solver;       /* NULL until pattern_columns */
    struct schedule schedule;
    struct hobe_error *failure; /* the first in a drive or a force of the caller (model_fail) */
    char **note;
    size_t notes;
    double setup;
};

static inline struct beam *model_beam(const struct hobe_model *model, size_t i)
{
    return (struct beam *)model->beams.item + i;
}

/* The vector that element e of a beam calls v. */
static inline long model_vector(const struct hobe_model *model, const struct beam *beam, int e,
                                int v)
{
    return model->alias[beam->first + (long)e * beam->step + v];
}

/* HOBE_UNCONSTRAINED with the sentence that names what is free to move, of a built model. */
enum hobe_status model_check_held(const struct hobe_model *model, struct hobe_error *err);

/* Frees the numbers of the unknowns and all that is laid out for them; forgets them, for a copy of
 * the model that gets its own. */
void model_free_system(hobe_model *model);
void model_forget_system(hobe_model *model);

/* Whether the states of two built models have the same unknowns. */
int model_same_shape(const hobe_model *a, const hobe_model *b);

/* q[vectors][3] = the nodal vectors in the reference, global axes: positions from the origin; 0 for
 * multipliers. */
void model_reference(const struct hobe_model *model, double *q);

/* A new item of the given size at the end of a list; NULL with err when there is no room. */
void *list_append(struct list *list, size_t size, struct hobe_error *err);

/* Keeps a copy of a sentence for hobe_model_note. */
enum hobe_status model_add_note(hobe_model *model, const char *text, struct hobe_error *err);

/* The beam called name; NULL with err (HOBE_UNKNOWN, where) listing the known ones. */
const struct beam *model_find_beam(const struct hobe_model *model, const char *name,
                                   const char *where, struct hobe_error *err);

/* Element and xi of `at` in [0,1] of a beam. */
struct place model_place(const struct beam *beam, double at);

/* Place of scalar (a, c) of block b, which lies in block column j. */
static inline long pattern_scalar(const struct pattern *p, long j, long b, int a, int c)
{
    const long height = p->start[j + 1] - p->start[j];
    return 9 * p->start[j] + 3 * height * c + 3 * (b - p->start[j]) + a;
}

/* Residuals are sums without a status: where a drive or a force of the caller fails in one, it is
 * NaN, and the error waits in the model. */
void model_fail(const struct hobe_model *model, const char *where, const struct hobe_error *err);

/* The error that waits, which it forgets; HOBE_OK without one.  To be asked after residuals. */
enum hobe_status model_failure(const struct hobe_model *model, struct hobe_error *err);

/* Seconds of a monotonic clock. */
double hobe_seconds(void);

#endif
