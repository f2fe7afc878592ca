/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Joints and supports of a model: their ties, and whether these are too few or too many. */
#ifndef HOBE_JOINT_H
#define HOBE_JOINT_H

#include "constraint.h"

/* Places, kind and axes of a joint, as far as they can be judged without its beams. */
enum hobe_status joint_check(const struct hobe_joint *joint, struct hobe_error *err);

/* Finds the places of something like a joint between two parts, or the ground at `to` and one
 * (beam[1] NULL), and the gap from the first to the second; *apart: whether they do not coincide.
 */
enum hobe_status joint_places(const struct hobe_model *model, const struct hobe_joint *joint,
                              struct tied side[2], double gap[3], int *apart,
                              struct hobe_error *err);

/* c[3] = the direction t as one of a section, on its n, y, z. */
void joint_direction(const struct tied *side, const double t[3], double c[3]);

/* Adds the ties of all joints and numbers the multipliers of these and of corners. */
enum hobe_status joint_parts(struct hobe_model *model, struct hobe_error *err);

/* HOBE_UNCONSTRAINED where groups of beams that share nodes, or bodies, can move as rigid bodies:
 * root[beams + bodies] leads to the one that stands for the group, held[root] where it is clamped.
 */
enum hobe_status joint_check_held(const struct hobe_model *model, const size_t *root,
                                  const unsigned char *held, struct hobe_error *err);

/* HOBE_BAD_INPUT where a tie's constraints depend on those before it and on what is held: their
 * multipliers would be undetermined.  For a model whose unknowns are numbered. */
enum hobe_status joint_check_redundant(const struct hobe_model *model, struct hobe_error *err);

#endif
