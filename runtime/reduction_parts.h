/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A reduced form, between the rooms that do it (reduction*.c). */
#ifndef HOBE_REDUCTION_PARTS_H
#define HOBE_REDUCTION_PARTS_H

#include "reduction.h"

/* What bodies and multipliers have in a reduced field: behind the coordinates. */
static inline double *reduction_behind(const struct reduction *r, double *field)
{
    return field + 3 * r->blocks;
}

static inline size_t reduction_behind_size(const struct reduction *r)
{
    return (size_t)(3 * (r->whole->vectors - r->whole->beam_vectors));
}

/* phi_j on the vectors of beams, [beam_vectors][3]. */
static inline const double *reduction_field(const struct reduction *r, long j)
{
    return r->of->basis.field + 3 * j * r->of->model->vectors;
}

/* r->f = 0 where items act, and r->K where that is asked. */
void reduction_clear(const struct reduction *r, int matrix);

/* K += dense[n][n] of the coordinates. */
void reduction_add_dense(const hobe_model *model, const double *dense, const struct matrix *K);

/* K += what r->K couples coordinates with bodies and multipliers by, and these with each other. */
void reduction_gather_behind(const hobe_model *model, const struct matrix *K);

#endif
