/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Newton's iteration, and statics by it. */
#ifndef HOBE_NEWTON_H
#define HOBE_NEWTON_H

#include "solver.h"

/* Newton's iteration from the current state to equilibrium at a load factor. */
enum outcome solver_iterate(struct solver *s, double factor, int line_search,
                            struct hobe_error *err);

/* Verifies the state s->u that a suspected step from s->start, at the load factor `from`, has come
 * to at the factor `to`: leaves the one that the path leads to, or, where it leads to none, the one
 * that is there, and info.limit_load then.  Changes s->start. */
enum outcome jump_verify(struct solver *s, double from, double to, struct hobe_error *err);

/* hobe_static of a model that is built and held, as one problem; options.start fits it. */
enum hobe_status newton_static(hobe_model *model, const struct hobe_newton *options,
                               hobe_solution **solution, struct hobe_error *err);

#endif
