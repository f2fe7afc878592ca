/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetric systems of 3 x 3 blocks, by elimination front after front: K = L D L' without pivoting,
 * which positive definite matrices do not need, and indefinite ones rarely; those with multipliers
 * are made so (border.h).  Where one does, the elimination says so and another room must help
 * (linsolve.h).
 *
 * A front is a run of blocks with the same neighbours among the later ones: along a beam, an
 * element and the node behind it.  Its columns form one dense panel (panel.h), in which the
 * matrix is summed and then factored in place: what a front leaves goes straight into the panels of
 * later ones.  Blocks are eliminated in the order given where that makes no new entries, as along
 * beams in a row, else in that of least degree if it costs less; multipliers behind what they tie.
 */
#ifndef HOBE_FRONTS_H
#define HOBE_FRONTS_H

#include "error.h"

typedef struct hobe_fronts hobe_fronts;

/* Order and panels, once per pattern: `blocks` columns with the rows row[start[j] ...
 * start[j + 1] - 1], ascending, of a symmetric pattern with its diagonal, which are not kept.  The
 * last `multipliers` blocks have a zero diagonal, or nothing else, and couple those they tie. */
hobe_fronts *fronts_analyse(long blocks, long multipliers, const long *start, const long *row,
                            struct hobe_error *err);
void fronts_free(hobe_fronts *f);

/* How many doubles the panels are. */
size_t fronts_size(const hobe_fronts *f);

/* Where the panels have block (i, j): its scalar (a, c) at place + c * fronts_stride(f, j) + a; -1
 * where they have its transpose (j, i). */
long fronts_place(const hobe_fronts *f, long i, long j);
int fronts_stride(const hobe_fronts *f, long j);

/* scale[3 * blocks] = diag(K)^(-1/2) of the values in the panels, 1 where there is none. */
void fronts_scale(const hobe_fronts *f, const double *value, double *scale);

/* Those of multipliers, which have no diagonal, by the others: their rows get entries of order one.
 */
void fronts_scale_border(const hobe_fronts *f, const double *value, double *scale);

/* Overwrites the values by the factors, which fronts_solve needs.  HOBE_SINGULAR, without a
 * sentence, where a pivot is too small beside its scale^-2, or entries grow too much: then the
 * values are lost, but nothing is wrong with them. */
enum hobe_status fronts_factor(hobe_fronts *f, double *value, const double *scale);

/* x[3 * blocks] = K^-1 x by the factors. */
void fronts_solve(const hobe_fronts *f, const double *value, double *x);

/* How many eigenvalues of the matrix that was factored last are negative: Sylvester's law.  Each
 * multiplier, unless spare, is one of them. */
long fronts_negative(const hobe_fronts *f);

#endif
