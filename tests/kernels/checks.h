/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The groups of checks; each is one file. */
#ifndef HOBE_TEST_CHECKS_H
#define HOBE_TEST_CHECKS_H

#include "fixture.h"

/* The evaluator against itself and against exact solutions. */
void check_evaluator(const struct pw_element *element);

/* What does not depend on the law: sizes and names, shape functions, strain, mass. */
void check_declaration(const struct fixture *fx);
void check_shape(const struct fixture *fx);
void check_strain(const struct fixture *fx);
void check_mass(const struct fixture *fx);

/* Random states: against the evaluator, and identities of the quartic energy. */
void check_values(const struct fixture *fx);
void check_identities(const struct fixture *fx);
/* Force and energy at strains of 1e-7 and 1e-10 against the evaluator; and the tangent, which takes
 * it long, where asked for. */
void check_round_off(const struct fixture *fx, int tangent);

/* The plan "points" beside the kernel's, and at small strains where asked for. */
void check_points(struct fixture *fx, int small);

/* Both plans with every symmetry that the section has, against the plan "section" that knows of
 * none; leaves the tensor with the section's own symmetry in use, for the other checks. */
void check_plans(struct fixture *fx);

/* Exact solutions: rigid motion, homogeneous deformation. */
void check_rigid(const struct fixture *fx);
void check_homogeneous(const struct fixture *fx);

#endif
