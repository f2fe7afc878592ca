/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam of a model: its axis in the reference, its elements, and the batches they are evaluated
 * in. */
#ifndef HOBE_BEAM_H
#define HOBE_BEAM_H

#include "hobe.h"

/* Neighbouring elements of one law, evaluated together. */
struct batch {
    int first, count; /* elements first .. first + count - 1, count <= HOBE_LANES */
    const hobe_element *law;
    const hobe_lanes *q0; /* [V][3] */
};

/* Where the values of a tangent lie: those of a symmetric one in the panels of fronts (fronts.h),
 * of any in compressed columns; and of the vectors that loads and joints touch (struct touched) in
 * a full matrix, column by column. */
enum layout { FRONTS, COLUMNS, TOUCHED, LAYOUTS };

struct beam {
    struct hobe_beam spec;
    char *name;
    /* What is left of the spec's where the section drops modes; and which, of those of the spec's.
     */
    const struct hobe_kernel *kernel;
    unsigned char dropped[HOBE_MAX_MODES];
    double length;             /* of the axis, m */
    double end[2][3];          /* first and last point of the axis, m */
    double end_frame[2][3][3]; /* the section's axes e_x, e_y, e_z there, rows */

    hobe_element *
        *law; /* [laws] the beam's distinct elements, those of a uniform beam its only one */
    int laws, borrowed;  /* borrowed: the only one is an earlier beam's */
    int *law_of;         /* [elements], NULL: all have the first */
    double (*origin)[3]; /* [elements] the first node of each, m; NULL where straight */
    double *q0;          /* [curved ? elements : 1][V][3] references, first node at the origin */
    hobe_lanes *q0_lanes;
    struct batch *batch;
    int batches;

    long first; /* first vector */
    int step;   /* vectors from an element to the next */
    /* [elements][V][V] where the 3 x 3 block (v, w) lies, -1: nowhere; NULL: not laid out so */
    long *place[LAYOUTS];
};

/* Makes a beam of its spec, whose name is copied.  `lend`: an earlier beam whose law a straight and
 * prismatic one may use, or NULL.  On failure the beam holds what beam_free frees. */
enum hobe_status beam_open(struct beam *beam,
                           const struct beam *(*lend)(void *, const struct beam *), void *context,
                           struct hobe_error *err);
void beam_free(struct beam *beam);

/* Whether one element law serves both: kernel, section, material and integration alike. */
int beam_same_law(const struct hobe_beam *a, const struct hobe_beam *b);

static inline const hobe_element *beam_law(const struct beam *beam, int e)
{
    return beam->law[beam->law_of ? beam->law_of[e] : 0];
}

/* The reference vectors [V][3] of element e, its first node at the origin. */
static inline const double *beam_q0(const struct beam *beam, int e)
{
    return beam->q0 + (beam->origin ? 3 * (size_t)e * (size_t)beam->kernel->vectors : 0);
}

/* Where the first node of element e is in the reference, m. */
void beam_origin(const struct beam *beam, int e, double origin[3]);

/* The section's axes in the reference, rows, where element e has the axial functions N, Nx. */
void beam_frame(const struct beam *beam, int e, const double *N, const double *Nx,
                double frame[3][3]);

#endif
