/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sparsity of the tangent stiffness, and where each element's blocks go: built once. */
#ifndef HOBE_PATTERN_H
#define HOBE_PATTERN_H

#include "model.h"

/* Fills model->pattern and every beam's block[] from the numbering. */
enum hobe_status pattern_build(struct hobe_model *model, struct hobe_error *err);

/* scale[3 * blocks] = diag(A)^(-1/2) for the values Ax of a tangent.  A multiplier has no diagonal:
 * its row is scaled to entries of order one. */
void pattern_scale(const struct pattern *pattern, const double *Ax, double *scale);

void pattern_free(struct pattern *pattern);

#endif
