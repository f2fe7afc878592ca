/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sparsity of the tangent stiffness, and where each element's blocks go: built once. */
#ifndef HOBE_PATTERN_H
#define HOBE_PATTERN_H

#include "model.h"

/* Fills model->pattern and every beam's block[] from the numbering. */
enum hobe_status pattern_build(struct hobe_model *model, struct hobe_error *err);
void pattern_free(struct pattern *pattern);

#endif
