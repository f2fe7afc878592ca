/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sparsity of the tangent stiffness, and where each element's blocks go: built once. */
#ifndef HOBE_PATTERN_H
#define HOBE_PATTERN_H

#include "model.h"

/* Fills model->pattern from the numbering and lays tangents out: in fronts where they are symmetric
 * and need no pivoting by the look of them, else in columns. */
enum hobe_status pattern_build(struct hobe_model *model, struct hobe_error *err);

/* Lays tangents out in columns as well, and opens model->solver, unless that is done. */
enum hobe_status pattern_columns(struct hobe_model *model, struct hobe_error *err);

/* touched[vectors] = 1 at those that items act on: loads (load_touch), joints, springs, bodies; and
 * at multipliers. */
void pattern_mark(const struct hobe_model *model, int changing, unsigned char *touched);

/* Finds the vectors that are touched, but by dead forces, and lays tangents of these out as well,
 * unless that is done.
 */
enum hobe_status pattern_touch(struct hobe_model *model, struct hobe_error *err);

/* A matrix of the model's pattern with all values zero; the caller frees its values. */
enum hobe_status pattern_matrix(const struct hobe_model *model, enum layout layout,
                                struct matrix *matrix, struct hobe_error *err);
void pattern_clear(const struct hobe_model *model, const struct matrix *matrix);

/* A += factor B, of one layout. */
void pattern_add(const struct hobe_model *model, double factor, const struct matrix *B,
                 const struct matrix *A);

/* A += a 3 x 3 block whose columns are a vector's, at its place in the layout of A; < 0: it has
 * none. The same for (v, w) of element e; of symmetric matrices both (v, w) and (w, v) are to be
 * given. */
void pattern_add_block(const struct hobe_model *model, long place, long vector,
                       const double block[3][3], const struct matrix *A);
void pattern_add_element(const struct hobe_model *model, const struct beam *beam, int e, int v,
                         int w, const double block[3][3], const struct matrix *A);

/* fronts = a symmetric matrix whose values in columns are Ax. */
void pattern_to_fronts(const struct hobe_model *model, const double *Ax, double *fronts);

/* scale[3 * blocks] = diag(A)^(-1/2) of a tangent.  A multiplier has no diagonal: its row is scaled
 * to entries of order one. */
void pattern_scale(const struct hobe_model *model, const struct matrix *A, double *scale);

void pattern_free(struct pattern *pattern);

#endif
