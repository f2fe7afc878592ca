/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of time that move joints and scale loads: what other rooms ask of them. */
#ifndef HOBE_DRIVE_H
#define HOBE_DRIVE_H

#include "model.h"

/* The time at which the value jumps, of a table with two points at it; NAN where it never does. */
double drive_jump(const hobe_drive *drive);

/* The first joint with a drive; NULL without one. */
const struct hobe_joint *drive_joint(const struct hobe_model *model);

/* The factor of a history at a time, NULL: 1; where it fails the model hears of it, with the
 * `where` of its load, and the factor is NaN. */
double drive_factor(const struct hobe_model *model, hobe_drive *history, double t,
                    const char *where);

/* d[2] = that factor and its derivative, 1/s. */
void drive_history(const struct hobe_model *model, hobe_drive *history, double t, const char *where,
                   double d[2]);

/* The next time after t at which a drive or a history of the model breaks (hobe_drive_next). */
double drive_next(const struct hobe_model *model, double t);

#endif
