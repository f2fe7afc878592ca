/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene with a beam that is curved, and tapered, while the n-th of the library's own allocations
 * fails, n = 1, 2, ...: each time "out of memory", and nothing is leaked (the sanitizer looks). */
#include "check.h"
#include "fault.h"

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
    int tapered;
    hobe_section *circle, *section;
    hobe_curve *curve;
    hobe_model *model;
    hobe_solution *solution;
};

static enum hobe_status open_axis(struct run *run, struct hobe_error *err)
{
    run->section = run->tapered ? hobe_section_taper(circle_at, &run->circle, err)
                                : hobe_section_circle(0.1, err);
    if (run->section)
        run->curve = hobe_curve_function(arc, NULL, err);
    return run->curve ? HOBE_OK : err->status;
}

static enum hobe_status bend(struct run *run, struct hobe_error *err)
{
    const struct hobe_clamp clamp = {.beam = "beam", .at = 0};
    const struct hobe_force force = {.beam = "beam", .at = 0.7, .value = {10, 20, 30}};
    struct hobe_point point;
    enum hobe_status status = open_axis(run, err);
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

static enum hobe_status go(void *tapered, struct hobe_error *err)
{
    struct run run = {.tapered = *(const int *)tapered};
    const enum hobe_status status = bend(&run, err);
    close_run(&run);
    return status;
}

int main(void)
{
    for (int tapered = 0; tapered < 2; tapered++)
        fail_each_allocation(go, &tapered, 50, 3000, tapered ? "tapered and curved" : "curved");
    return check_report();
}
