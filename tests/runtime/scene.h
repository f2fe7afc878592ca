/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small scenes: the calls of hobe.h with their errors taken care of, for tests in which a failing
 * call is a failure of the test. */
#ifndef HOBE_TEST_SCENE_H
#define HOBE_TEST_SCENE_H

#include "hobe.h"

hobe_section *rectangle(double width, double height);
struct hobe_section_properties properties_of(const hobe_section *section);

/* A section that goes linearly from one to the other, which it frees. */
hobe_section *tapered(hobe_section *from, hobe_section *to);

/* The curve of a function, and with a twist unless NULL; both with the same context. */
hobe_curve *curve_of(hobe_function *point, hobe_function *twist, void *context);

/* A beam "beam" of `elements` elements along x from the origin, k2 = k3 = 1, no density. */
struct hobe_beam beam_along_x(const char *element, int elements, const hobe_section *section,
                              double E, double nu, double length);

hobe_element *new_element(const struct hobe_element_options *options);

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
void add_body(hobe_model *model, const struct hobe_body *body);
void add_joint(hobe_model *model, const struct hobe_joint *joint);

/* Equilibrium in `steps` steps, to round-off; ends the test when there is none. */
hobe_solution *solve(hobe_model *model, int steps);
struct hobe_solution_info info_of(const hobe_solution *solution);
struct hobe_point point_of(const hobe_solution *solution, const char *beam, double at, double y,
                           double z);

/* Solves, gives the point on the axis of "beam" at its end, and frees solution and model. */
struct hobe_point tip_of(hobe_model *model, int steps);

/* The first modes about a state, NULL: the reference. */
hobe_modes *modes_of(hobe_model *model, const hobe_solution *state, int count,
                     enum hobe_modal_method method);
struct hobe_modes_info modes_info(const hobe_modes *modes);
struct hobe_mode mode_of(const hobe_modes *modes, int i);

/* |a - b| and |a| of three. */
double distance(const double a[3], const double b[3]);
double norm(const double a[3]);

#endif
