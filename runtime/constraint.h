/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Joints by Lagrange multipliers: Phi(q) = 0, energy lambda . Phi.
 *
 * Each constraint owns one block of three multipliers, which the model numbers behind the beams'
 * vectors: the state u holds them like three more displacements. */
#ifndef HOBE_CONSTRAINT_H
#define HOBE_CONSTRAINT_H

#include "model.h"

/* A rigid corner between sections a and b that share their position: they do not turn against each
 * other.  With a's slopes y, z and its normal n = y x z, the slopes of b should point along
 *
 *     p_s = C_sx n + C_sy y + C_sz z,    s = y, z,   C_st = e_s(b) . e_t(a) in the reference,
 *
 * and Phi = p_y x b_y + p_z x b_z vanishes when they do, whatever either section's stretch. */
enum { CORNER_VECTORS = 5 }; /* a_y, a_z, b_y, b_z, multipliers */

struct corner {
    const struct beam *beam[2];
    const double (*frame[2])[3];                /* their axes there in the reference, rows */
    int element[2], slope[2][2];                /* element and its vectors y, z at the joint */
    double C[2][3];                             /* C_st */
    long vector[CORNER_VECTORS];                /* their numbers in the model */
    long block[CORNER_VECTORS][CORNER_VECTORS]; /* places in the pattern, -1: held */
};

static inline struct corner *model_corner(const struct hobe_model *model, size_t i)
{
    return (struct corner *)model->corners.item + i;
}

/* C_st of two beams' frames. */
void corner_orient(struct corner *corner);

/* f += d(lambda . Phi)/dq and Phi on the multipliers; Ax += its derivative unless NULL. */
void constraint_add(const struct hobe_model *model, const double *u, double *f, double *Ax);

#endif
