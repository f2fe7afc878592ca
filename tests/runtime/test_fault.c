/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A small run in which the n-th of the library's own allocations fails, for n = 1, 2, ... until it
 * gets through: each time it ends with "out of memory", crashes nowhere, and leaks nothing (the
 * sanitizer looks).  The run has every kind of item. */
#include "check.h"
#include "hobe.h"
#include "solution.h"

#include <stdio.h>
#include <string.h>

struct run {
    hobe_section *section;
    hobe_model *model;
    hobe_solution *solution;
    struct hobe_point tip;
    struct hobe_reaction reaction[2];
    struct hobe_error err;
};

static enum hobe_status add_beams(struct run *run)
{
    struct hobe_beam beam = {.name = "inner",
                             .kernel = hobe_find_kernel("MGD30w", &run->err),
                             .elements = 2,
                             .section = run->section,
                             .material = {.E = 70e9, .nu = 0.3, .rho = 2700, .k2 = 1, .k3 = 1},
                             .to = {1, 0, 0}};
    enum hobe_status status = hobe_model_beam(run->model, &beam, &run->err);
    beam.name = "outer";
    beam.kernel = hobe_find_kernel("3333", &run->err);
    beam.elements = 1;
    beam.from[0] = 1;
    beam.to[0] = 1.5;
    if (!status)
        status = hobe_model_beam(run->model, &beam, &run->err);
    beam.name = "upright"; /* a corner */
    beam.from[0] = 1.5;
    beam.to[2] = 0.5;
    return status ? status : hobe_model_beam(run->model, &beam, &run->err);
}

static enum hobe_status add_items(struct run *run)
{
    const struct hobe_clamp clamp = {.beam = "inner", .name = "root", .at = 0, .free_warping = 1};
    const struct hobe_joint joint = {.beam = {"outer"},
                                     .name = "prop",
                                     .at = {0.8},
                                     .kind = HOBE_JOINT_INPLANE,
                                     .axis = {0, 0, 1}};
    const struct hobe_join joins[] = {{.beam = {"inner", "outer"}, .at = {1, 0}},
                                      {.beam = {"upright", "outer"}, .at = {0, 1}}};
    const struct hobe_force forces[] = {
        {.beam = "outer", .at = 1, .value = {0, 10, -20}},
        {.beam = "inner", .at = 0.3, .value = {5, 0, 10}, .follower = 1}};
    const struct hobe_moment moment = {.beam = "outer", .at = 0.5, .value = {10, 20, 30}};
    const struct hobe_spring spring = {
        .beam = {"outer", "upright"}, .name = "brace", .at = {0.3, 1}, .stiffness = {1e4}};
    enum hobe_status status = hobe_model_clamp(run->model, &clamp, &run->err);
    if (!status)
        status = hobe_model_spring(run->model, &spring, &run->err);
    if (!status)
        status = hobe_model_joint(run->model, &joint, &run->err);
    for (int i = 0; !status && i < 2; i++)
        status = hobe_model_join(run->model, joins + i, &run->err);
    for (int i = 0; !status && i < 5; i++) /* enough that the list grows */
        status = hobe_model_force(run->model, forces + i % 2, &run->err);
    if (!status)
        status = hobe_model_moment(run->model, &moment, &run->err);
    if (!status)
        status = hobe_model_gravity(run->model, NULL, (const double[3]){0, 0, -9.81}, &run->err);
    return status;
}

/* Everything, from the section to a point. */
static enum hobe_status go(struct run *run)
{
    run->section = hobe_section_rectangle(0.05, 0.1, HOBE_WARPING_SERIES, &run->err);
    if (!run->section)
        return run->err.status;
    run->model = hobe_model_new(&run->err);
    if (!run->model)
        return run->err.status;
    enum hobe_status status = add_beams(run);
    if (!status)
        status = add_items(run);
    if (!status)
        status = hobe_model_build(run->model, &run->err);
    if (!status)
        status =
            hobe_static(run->model, &(struct hobe_newton){.steps = 1}, &run->solution, &run->err);
    check_that(!run->solution || !status, "no solution is left behind a failure");
    if (!status)
        status = hobe_solution_point(run->solution, "outer", 1, 0.01, 0.02, &run->tip, &run->err);
    for (int i = 0; !status && i < 2; i++)
        status = hobe_solution_reaction(run->solution, i ? "prop" : "root", &run->reaction[i],
                                        &run->err);
    return status;
}

static void close_run(struct run *run)
{
    hobe_solution_free(run->solution);
    hobe_model_free(run->model);
    hobe_section_free(run->section);
}

/* One run with the n-th allocation failing; 1 when none was left to fail. */
static int fail_at(long n, const struct hobe_point *expected)
{
    struct run run = {0};
    run.err.where = "not set";
    hobe_fail_allocation(n);
    const enum hobe_status status = go(&run);
    const long seen = hobe_fail_allocation(0);
    const int through = seen < n;
    if (through) {
        check_that(status == HOBE_OK, "nothing failed: %s", run.err.message);
        check_that(memcmp(run.tip.u, expected->u, sizeof run.tip.u) == 0, "with the same result");
    } else
        check_that(status == HOBE_NO_MEMORY && run.err.status == HOBE_NO_MEMORY &&
                       strncmp(run.err.message, "out of memory", 13) == 0 &&
                       !strchr(run.err.message, '\n'),
                   "allocation %ld of %ld: \"%s\", \"%s\"", n, seen, hobe_status_words(status),
                   run.err.message);
    close_run(&run);
    return through;
}

/* The same with one element alone, whose calls allocate too. */
static enum hobe_status one_element(struct hobe_error *err)
{
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double q[30], f[30], K[900], U;
    struct hobe_element_options options = {.kernel = hobe_find_kernel("MGD30", err),
                                           .material = {.E = 1, .nu = 0.3, .k2 = 1, .k3 = 1},
                                           .length = 50}; /* long: checked on a shorter one */
    hobe_section *section = hobe_section_rectangle(1, 2, HOBE_WARPING_PAPER, err);
    options.section = section;
    hobe_element *element = section ? hobe_element_new(&options, err) : NULL;
    enum hobe_status status = element ? HOBE_OK : err->status;
    if (element)
        hobe_element_reference(element, identity, q);
    if (!status)
        status = hobe_element_energy(element, q, q, &U, err);
    if (!status)
        status = hobe_element_force(element, q, q, f, err);
    if (!status)
        status = hobe_element_tangent(element, q, q, K, err);
    hobe_element_free(element);
    hobe_section_free(section);
    return status;
}

/* A tapered structural element, which asks for the section's properties at each of its points. */
static enum hobe_status tapered_element(struct hobe_error *err)
{
    struct hobe_element_options options = {.kernel = hobe_find_kernel("3333s", err),
                                           .material = {.E = 1, .nu = 0.3, .k2 = 1, .k3 = 1},
                                           .length = 5};
    hobe_section *from = hobe_section_circle(1, err);
    hobe_section *to = from ? hobe_section_circle(2, err) : NULL;
    hobe_section *section = to ? hobe_section_linear(from, to, err) : NULL;
    options.section = section;
    hobe_element *element = section ? hobe_element_new(&options, err) : NULL;
    const enum hobe_status status = element ? HOBE_OK : err->status;
    hobe_element_free(element);
    hobe_section_free(section);
    hobe_section_free(to);
    hobe_section_free(from);
    return status;
}

/* A cantilever solved by series. */
static enum hobe_status by_series(struct hobe_error *err)
{
    const struct hobe_newton options = {.method = HOBE_METHOD_SERIES};
    hobe_section *section = hobe_section_rectangle(1, 2, HOBE_WARPING_PAPER, err);
    hobe_model *model = section ? hobe_model_new(err) : NULL;
    const struct hobe_beam beam = {.name = "beam",
                                   .kernel = hobe_find_kernel("3333", err),
                                   .elements = 1,
                                   .section = section,
                                   .material = {.E = 1, .nu = 0.3, .k2 = 1, .k3 = 1},
                                   .to = {10, 0, 0}};
    const struct hobe_clamp clamp = {.beam = "beam"};
    const struct hobe_moment moment = {.beam = "beam", .at = 1, .value = {0, 1e-3, 1e-3}};
    enum hobe_status status = model ? hobe_model_beam(model, &beam, err) : err->status;
    hobe_solution *solution = NULL;
    if (!status)
        status = hobe_model_clamp(model, &clamp, err);
    if (!status)
        status = hobe_model_moment(model, &moment, err);
    if (!status)
        status = hobe_static(model, &options, &solution, err);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
    return status;
}

static long elements_fail(enum hobe_status (*make)(struct hobe_error *err))
{
    for (long n = 1;; n++) {
        struct hobe_error err = {0};
        hobe_fail_allocation(n);
        const enum hobe_status status = make(&err);
        if (hobe_fail_allocation(0) < n) {
            check_that(status == HOBE_OK, "nothing failed: %s", err.message);
            return n - 1;
        }
        check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY,
                   "allocation %ld of one element: %s", n, err.message);
    }
}

/* Stress, section forces and what is told of a solution that stands. */
static enum hobe_status read_forces(const hobe_solution *solution, struct hobe_error *err)
{
    struct hobe_stress stress;
    struct hobe_resultants r;
    struct hobe_wall_bending bending;
    enum hobe_status status = hobe_solution_stress(solution, "inner", 0.2, 0, 0, &stress, err);
    if (!status)
        status = hobe_solution_resultants(solution, "inner", 0.5, HOBE_CUT_FORCES, &r, err);
    if (!status)
        status = hobe_solution_resultants(solution, "inner", 0.5, HOBE_CUT_STRESS, &r, err);
    if (!status)
        status = hobe_solution_wall_bending(solution, "inner", &bending, err);
    return status;
}

/* The way to it once more, from itself. */
static enum hobe_status solve_again(const hobe_solution *solution, struct hobe_error *err)
{
    const struct hobe_newton options = {.start = solution};
    hobe_solution *again;
    const enum hobe_status status =
        hobe_static((hobe_model *)solution->model, &options, &again, err);
    hobe_solution_free(again);
    return status;
}

static long calls_fail(enum hobe_status (*call)(const hobe_solution *, struct hobe_error *),
                       const hobe_solution *solution)
{
    for (long n = 1;; n++) {
        struct hobe_error err = {0};
        hobe_fail_allocation(n);
        const enum hobe_status status = call(solution, &err);
        if (hobe_fail_allocation(0) < n) {
            check_that(status == HOBE_OK, "nothing failed: %s", err.message);
            return n - 1;
        }
        check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY,
                   "allocation %ld of a solution that stands: %s", n, err.message);
    }
}

int main(void)
{
    struct run run = {0};
    if (go(&run))
        check_stop("%s", run.err.message);
    long n = 1;
    while (!fail_at(n, &run.tip) && n < 10000)
        n++;
    check_that(n > 30 && n < 10000, "allocations were counted: %ld", n);
    printf("%ld allocations of a scene, %ld of an element, %ld of a tapered one, failed in turn\n",
           n - 1, elements_fail(one_element), elements_fail(tapered_element));
    check_that(calls_fail(read_forces, run.solution) >= 6, "section forces allocate");
    check_that(elements_fail(by_series) >= 40, "series allocate");
    check_that(calls_fail(solve_again, run.solution) >= 8, "solvers allocate");
    close_run(&run);
    return check_report();
}
