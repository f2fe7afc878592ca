/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene with a beam that is curved, and tapered, while the n-th of the library's own allocations
 * fails, n = 1, 2, ...: each time "out of memory", and nothing is leaked (the sanitizer looks). */
#include "check.h"
#include "hobe.h"

#include <stdio.h>
#include <string.h>

static enum hobe_status circle_at(void *context, double t, const hobe_section **section,
                                  struct hobe_error *err)
{
    hobe_section **last = context;
    hobe_section_free(*last);
    *section = *last = hobe_section_circle(0.1 - 0.05 * t, err);
    return *last ? HOBE_OK : err->status;
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context, (void)err;
    r[0] = t;
    r[1] = t * t / 2;
    r[2] = 0;
    return HOBE_OK;
}

struct run {
    hobe_section *circle, *section;
    hobe_curve *curve;
    hobe_model *model;
    hobe_solution *solution;
};

static enum hobe_status open_axis(struct run *run, int tapered, int curved, struct hobe_error *err)
{
    run->section =
        tapered ? hobe_section_taper(circle_at, &run->circle, err) : hobe_section_circle(0.1, err);
    if (!run->section)
        return err->status;
    run->curve = curved ? hobe_curve_function(arc, NULL, err) : NULL;
    return run->curve || !curved ? HOBE_OK : err->status;
}

static enum hobe_status go(struct run *run, int tapered, int curved, struct hobe_error *err)
{
    const struct hobe_clamp clamp = {.beam = "beam", .at = 0};
    const struct hobe_force force = {.beam = "beam", .at = 0.7, .value = {10, 20, 30}};
    struct hobe_point point;
    enum hobe_status status = open_axis(run, tapered, curved, err);
    if (status)
        return status;
    run->model = hobe_model_new(err);
    if (!run->model)
        return err->status;
    const struct hobe_beam beam = {.name = "beam",
                                   .kernel = hobe_find_kernel("BE24w", err),
                                   .elements = 1,
                                   .section = run->section,
                                   .material = {.E = 70e9, .nu = 0.3, .k2 = 1, .k3 = 1},
                                   .to = {1, 0, 0},
                                   .curve = run->curve};
    status = hobe_model_beam(run->model, &beam, err);
    if (!status)
        status = hobe_model_clamp(run->model, &clamp, err);
    if (!status)
        status = hobe_model_force(run->model, &force, err);
    if (!status)
        status = hobe_static(run->model, &(struct hobe_newton){0}, &run->solution, err);
    return status ? status
                  : hobe_solution_point(run->solution, "beam", 0.6, 0.01, 0.02, &point, err);
}

static void close_run(struct run *run)
{
    hobe_solution_free(run->solution);
    hobe_model_free(run->model);
    hobe_curve_free(run->curve);
    hobe_section_free(run->section);
    hobe_section_free(run->circle);
}

static void fails(int tapered, int curved, const char *what)
{
    long n = 0, seen;
    do {
        struct run run = {0};
        struct hobe_error err = {0};
        hobe_fail_allocation(++n);
        const enum hobe_status status = go(&run, tapered, curved, &err);
        seen = hobe_fail_allocation(0);
        if (seen >= n)
            check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY &&
                           strncmp(err.message, "out of memory", 13) == 0,
                       "%s, allocation %ld of %ld: %s", what, n, seen, err.message);
        else
            check_that(!status, "%s: nothing failed: %s", what, err.message);
        close_run(&run);
    } while (seen >= n && n < 3000);
    check_that(n > 50 && n < 3000, "%s: %ld allocations", what, n - 1);
    printf("%s: %ld allocations\n", what, n - 1);
}

int main(void)
{
    fails(0, 1, "curved");
    fails(1, 1, "tapered and curved");
    return check_report();
}
