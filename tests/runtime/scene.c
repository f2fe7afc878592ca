/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene.h"

#include "check.h"

#include <math.h>

static void expect_ok(enum hobe_status status, const struct hobe_error *err)
{
    if (status)
        check_stop("%s: %s", hobe_status_words(status), err->message);
}

hobe_section *rectangle(double width, double height)
{
    struct hobe_error err;
    hobe_section *section = hobe_section_rectangle(width, height, HOBE_WARPING_SERIES, &err);
    expect_ok(section ? HOBE_OK : err.status, &err);
    return section;
}

hobe_section *tapered(hobe_section *from, hobe_section *to)
{
    struct hobe_error err;
    hobe_section *section = hobe_section_linear(from, to, &err);
    expect_ok(section ? HOBE_OK : err.status, &err);
    hobe_section_free(from);
    hobe_section_free(to);
    return section;
}

hobe_curve *curve_of(hobe_function *point, hobe_function *twist, void *context)
{
    struct hobe_error err;
    hobe_curve *curve = hobe_curve_function(point, context, &err);
    expect_ok(curve ? HOBE_OK : err.status, &err);
    if (twist)
        expect_ok(hobe_curve_twist(curve, twist, context, &err), &err);
    return curve;
}

struct hobe_section_properties properties_of(const hobe_section *section)
{
    struct hobe_section_properties p;
    hobe_section_properties(section, &p);
    return p;
}

struct hobe_beam beam_along_x(const char *element, int elements, const hobe_section *section,
                              double E, double nu, double length)
{
    struct hobe_error err;
    const struct hobe_kernel *kernel = hobe_find_kernel(element, &err);
    expect_ok(kernel ? HOBE_OK : err.status, &err);
    return (struct hobe_beam){.name = "beam",
                              .kernel = kernel,
                              .elements = elements,
                              .section = section,
                              .material = {.E = E, .nu = nu, .k2 = 1, .k3 = 1},
                              .to = {length, 0, 0}};
}

hobe_model *new_model(void)
{
    struct hobe_error err;
    hobe_model *model = hobe_model_new(&err);
    expect_ok(model ? HOBE_OK : err.status, &err);
    return model;
}

void add_beam(hobe_model *model, const struct hobe_beam *beam)
{
    struct hobe_error err;
    expect_ok(hobe_model_beam(model, beam, &err), &err);
}

void add_clamp(hobe_model *model, const char *beam, double at, int free_warping)
{
    struct hobe_error err;
    const struct hobe_clamp clamp = {.beam = beam, .at = at, .free_warping = free_warping};
    expect_ok(hobe_model_clamp(model, &clamp, &err), &err);
}

void add_join(hobe_model *model, const char *first, double at, const char *second, double second_at)
{
    struct hobe_error err;
    const struct hobe_join join = {.beam = {first, second}, .at = {at, second_at}};
    expect_ok(hobe_model_join(model, &join, &err), &err);
}

void add_force(hobe_model *model, const char *beam, double at, double x, double y, double z)
{
    struct hobe_error err;
    const struct hobe_force force = {.beam = beam, .at = at, .value = {x, y, z}};
    expect_ok(hobe_model_force(model, &force, &err), &err);
}

void add_follower(hobe_model *model, const char *beam, double at, double x, double y, double z)
{
    struct hobe_error err;
    const struct hobe_force force = {.beam = beam, .at = at, .value = {x, y, z}, .follower = 1};
    expect_ok(hobe_model_force(model, &force, &err), &err);
}

void add_moment(hobe_model *model, const char *beam, double at, double x, double y, double z)
{
    struct hobe_error err;
    const struct hobe_moment moment = {.beam = beam, .at = at, .value = {x, y, z}};
    expect_ok(hobe_model_moment(model, &moment, &err), &err);
}

void add_body(hobe_model *model, const struct hobe_body *body)
{
    struct hobe_error err;
    expect_ok(hobe_model_body(model, body, &err), &err);
}

void add_joint(hobe_model *model, const struct hobe_joint *joint)
{
    struct hobe_error err;
    if (hobe_model_joint(model, joint, &err))
        check_stop("%s: %s", hobe_joint_name(joint->kind), err.message);
}

hobe_element *new_element(const struct hobe_element_options *options)
{
    struct hobe_error err;
    hobe_element *element = hobe_element_new(options, &err);
    expect_ok(element ? HOBE_OK : err.status, &err);
    return element;
}

hobe_model *cantilever(const struct hobe_beam *beam, int free_warping)
{
    hobe_model *model = new_model();
    add_beam(model, beam);
    add_clamp(model, beam->name, 0, free_warping);
    return model;
}

hobe_solution *solve(hobe_model *model, int steps)
{
    struct hobe_error err;
    hobe_solution *solution;
    const struct hobe_newton options = {.steps = steps, .tolerance = 1e-13};
    expect_ok(hobe_static(model, &options, &solution, &err), &err);
    return solution;
}

struct hobe_solution_info info_of(const hobe_solution *solution)
{
    struct hobe_solution_info info;
    hobe_solution_info(solution, &info);
    return info;
}

struct hobe_point point_of(const hobe_solution *solution, const char *beam, double at, double y,
                           double z)
{
    struct hobe_error err;
    struct hobe_point point;
    expect_ok(hobe_solution_point(solution, beam, at, y, z, &point, &err), &err);
    return point;
}

struct hobe_point tip_of(hobe_model *model, int steps)
{
    hobe_solution *solution = solve(model, steps);
    const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
    hobe_solution_free(solution);
    hobe_model_free(model);
    return tip;
}

hobe_modes *modes_of(hobe_model *model, const hobe_solution *state, int count,
                     enum hobe_modal_method method)
{
    struct hobe_error err;
    hobe_modes *modes;
    const struct hobe_modal_options options = {.modes = count, .method = method};
    if (hobe_modal(model, state, &options, &modes, &err))
        check_stop("hobe_modal: %s", err.message);
    return modes;
}

struct hobe_mode mode_of(const hobe_modes *modes, int i)
{
    struct hobe_error err;
    struct hobe_mode mode;
    if (hobe_modes_mode(modes, i, &mode, &err))
        check_stop("hobe_modes_mode: %s", err.message);
    return mode;
}

struct hobe_modes_info modes_info(const hobe_modes *modes)
{
    struct hobe_modes_info info;
    hobe_modes_info(modes, &info);
    return info;
}

double norm(const double a[3])
{
    return hypot(hypot(a[0], a[1]), a[2]);
}

double distance(const double a[3], const double b[3])
{
    return norm((const double[3]){a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}
