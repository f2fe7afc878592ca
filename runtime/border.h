/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Multipliers among the unknowns that fronts eliminate (fronts.h): K = [A B'; B 0].
 *
 * Without pivoting A would have to be regular, which it is not where only B holds something, and in
 * some orders not even where A is.  With E = D B, D the scale of the multipliers,
 *
 *     [A + E'E  B'] [u]   [f + E'D g]
 *     [B        0 ] [l] = [g        ]
 *
 * has the same solution as K (u, l) = (f, g), and is congruent to K, so that it has the same number
 * of negative eigenvalues.  Where A is positive definite on what B leaves free, and semidefinite
 * elsewhere, A + E'E is positive definite; where A and E are scaled to entries of order one, it is
 * as well conditioned as K.  Then any order is good in which a multiplier comes after the vectors
 * it ties: their pivots are positive, its own are those of -B (A + E'E)^-1 B', negative.
 *
 * Spare multipliers, whose diagonal is not zero, must tie nothing. */
#ifndef HOBE_BORDER_H
#define HOBE_BORDER_H

#include "fronts.h"

/* Of a symmetric pattern of blocks, the last of which are multipliers. */
struct border {
    long first, multipliers; /* blocks: the first of them, and how many */
    long *start;             /* [multipliers + 1] in what follows */
    long *vector;            /* the vectors that each ties, in the order of elimination, */
    long *place;             /* of the multiplier's block beside each in the panels, */
    int *stride;             /* and of that column there */
    double *E;               /* [][3][3] rows of E beside each */
    long *pairs;             /* [multipliers + 1] in what follows */
    long *pair;              /* places of the blocks that couple the vectors, by columns */
    double *scale;           /* [3 multipliers] D */
};

/* Puts each multiplier, a block from `first` on, right behind the last of the vectors that it ties
 * in order[blocks]. */
enum hobe_status border_order(long first, long blocks, const long *start, const long *row,
                              long *order, struct hobe_error *err);

/* Finds the places of a bordered pattern in the panels of its fronts.  The vectors that a
 * multiplier ties must be coupled.  border_free frees what it made, whatever its status. */
enum hobe_status border_open(struct border *border, const hobe_fronts *fronts, long first,
                             long blocks, const long *start, const long *row,
                             struct hobe_error *err);
void border_free(struct border *border);

/* Where the diagonal of a multiplier is zero, scale[3 * blocks] of it so that the largest entry of
 * its row becomes one, by the scale of the vectors. */
void border_scale(const struct border *border, const double *value, double *scale);

/* Adds E'E to the values in the panels, D by the multipliers' part of scale[3 * blocks], and keeps
 * D and E. */
void border_stiffen(struct border *border, double *value, const double *scale);

/* x = (f, g) becomes (f + E'D g, g), x[3 * blocks]. */
void border_load(const struct border *border, double *x);

#endif
