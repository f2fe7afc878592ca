/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vectors, joins, supports and unknowns of a model. */
#ifndef HOBE_NUMBERING_H
#define HOBE_NUMBERING_H

#include "model.h"

/* Lays out the vectors of all beams, joins and holds them, looks what is free to move
 * (model_check_held), numbers the unknowns, and checks that no joint is one too many. */
enum hobe_status number_model(hobe_model *model, struct hobe_error *err);

/* Numbers the vectors that are no alias and not held. */
void number_unknowns(hobe_model *model);

/* Beams that share a vector are one group: group[i] leads to the same root for all of them, which
 * group_of finds; bodies, behind the beams, are groups of their own. */
void group_parts(const hobe_model *model, size_t *group);
size_t group_of(const size_t *group, size_t i);

/* Makes one of the vectors that joined beams share, and adds corners (join.c). */
enum hobe_status join_beams(hobe_model *model, struct hobe_error *err);

/* The node of a beam at `at`, as element and node of it; -1 where there is none with a position. */
int node_at(const struct beam *beam, double at, int *element);

#endif
