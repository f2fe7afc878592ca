/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A motion without inertia and damping: equilibria at the times of its states, under the loads and
 * drives of then.  What a motion differs from it by is the dynamics of the scene. */
#ifndef HOBE_QUASI_STATIC_H
#define HOBE_QUASI_STATIC_H

#include "history.h"

/* Appends the equilibria at the start, at each options->store after it, and at the end, at rest;
 * HOBE_BAD_INPUT without `store`, else as hobe_static. */
enum hobe_status quasi_static(hobe_model *model, const struct hobe_dynamic *options,
                              hobe_history *history, struct hobe_error *err);

#endif
