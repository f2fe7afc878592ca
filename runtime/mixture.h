/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A model under a sum of the loads of several, which have the same beams and supports. */
#ifndef HOBE_MIXTURE_H
#define HOBE_MIXTURE_H

#include "model.h"

/* A copy of the first model that shares all it has but its loads: sum_i weight[i] Q_i, and of spins
 * the sum of the speeds' squares about the axis of the first.  Forces that are functions of the
 * state act as they are.  It must be closed, and nothing may be built in it. */
struct mixture {
    hobe_model model;
    double *dead; /* [vectors][3] */
};

enum hobe_status mixture_open(struct mixture *mixture, int count, hobe_model *const *models,
                              const double *weight, struct hobe_error *err);
void mixture_close(struct mixture *mixture);

#endif
