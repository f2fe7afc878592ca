/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small scenes: the calls of hobe.h with their errors taken care of, for tests in which a failing
 * call is a failure of the test. */
#ifndef HOBE_TEST_SCENE_H
#define HOBE_TEST_SCENE_H

#include "hobe.h"

hobe_section *rectangle(double width, double height);
struct hobe_section_properties properties_of(const hobe_section *section);

/* A beam "beam" of `elements` elements along x from the origin, k2 = k3 = 1, no density. */
struct hobe_beam beam_along_x(const char *element, int elements, const hobe_section *section,
                              double E, double nu, double length);

/* A model with the beam, clamped at 0. */
hobe_model *cantilever(const struct hobe_beam *beam, int free_warping);

hobe_model *new_model(void);
void add_beam(hobe_model *model, const struct hobe_beam *beam);
void add_clamp(hobe_model *model, const char *beam, double at, int free_warping);
void add_join(hobe_model *model, const char *first, double at, const char *second,
              double second_at);
void add_force(hobe_model *model, const char *beam, double at, double x, double y, double z);
void add_follower(hobe_model *model, const char *beam, double at, double x, double y, double z);
void add_moment(hobe_model *model, const char *beam, double at, double x, double y, double z);

/* Equilibrium in `steps` steps, to round-off; ends the test when there is none. */
hobe_solution *solve(hobe_model *model, int steps);
struct hobe_solution_info info_of(const hobe_solution *solution);
struct hobe_point point_of(const hobe_solution *solution, const char *beam, double at, double y,
                           double z);

/* Solves, gives the point on the axis of "beam" at its end, and frees solution and model. */
struct hobe_point tip_of(hobe_model *model, int steps);

/* |a - b| and |a| of three. */
double distance(const double a[3], const double b[3]);
double norm(const double a[3]);

#endif
