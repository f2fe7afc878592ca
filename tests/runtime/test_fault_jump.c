/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A load step over a limit point, verified while allocations fail one by one. */
#include "check.h"
#include "fault.h"
#include "scene.h"

/* Two bars that lean on each other, hinged. */
static enum hobe_status add_bars(hobe_model *model, const hobe_section *section,
                                 struct hobe_error *err)
{
    static const char *const names[2] = {"left", "right"};
    const double x[3] = {-1, 0, 1}, z[3] = {0, 0.05, 0};
    enum hobe_status status = HOBE_OK;
    for (int i = 0; i < 2 && !status; i++) {
        const struct hobe_beam bar = {.name = names[i],
                                      .kernel = hobe_find_kernel("MGD30", err),
                                      .elements = 1,
                                      .section = section,
                                      .material = {.E = 1e9, .k2 = 1, .k3 = 1},
                                      .from = {x[i], 0, z[i]},
                                      .to = {x[i + 1], 0, z[i + 1]}};
        const struct hobe_joint foot = {
            .beam = {names[i]}, .at = {i}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 1, 0}};
        status = hobe_model_beam(model, &bar, err);
        if (!status)
            status = hobe_model_joint(model, &foot, err);
    }
    const struct hobe_joint top = {
        .beam = {"left", "right"}, .at = {1}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 1, 0}};
    const struct hobe_force force = {.beam = "left", .at = 1, .value = {0, 0, -5e3}};
    if (!status)
        status = hobe_model_joint(model, &top, err);
    return status ? status : hobe_model_force(model, &force, err);
}

static enum hobe_status go(void *section, struct hobe_error *err)
{
    hobe_solution *solution = NULL;
    hobe_model *model = hobe_model_new(err);
    if (!model)
        return HOBE_NO_MEMORY;
    enum hobe_status status = add_bars(model, section, err);
    if (!status)
        status = hobe_static(model, &(struct hobe_newton){0}, &solution, err);
    if (!status)
        check_that(info_of(solution).limit_load > 0, "it jumps");
    hobe_solution_free(solution);
    hobe_model_free(model);
    return status;
}

int main(void)
{
    hobe_section *section = rectangle(0.1, 0.1);
    fail_each_allocation(go, section, 30, 400, "a jump");
    hobe_section_free(section);
    return check_report();
}
