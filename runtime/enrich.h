/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reduced models that are as accurate as they were asked to be. */
#ifndef HOBE_ENRICH_H
#define HOBE_ENRICH_H

#include "reduced.h"

/* Solves the reduced model under each of the loads of interest by itself, and adds what its state
 * lacks there (trust.h) to the basis, until no indicator is above the accuracy.
 * HOBE_NOT_CONVERGED where the unknowns that are allowed do not suffice.  The time `started` is
 * that of reduced_finish. */
enum hobe_status enrich(struct hobe_reduced *r, const struct hobe_reduce *options, double started,
                        struct hobe_error *err);

#endif
