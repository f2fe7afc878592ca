/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two beams that nothing couples, of which one runs on a smaller element, while allocations fail
 * one by one. */
#include "check.h"
#include "fault.h"
#include "scene.h"

struct sections {
    hobe_section *round, *rectangle;
};

static enum hobe_status add_one(hobe_model *model, const char *name, const hobe_section *section,
                                struct hobe_error *err)
{
    const struct hobe_beam beam = {.name = name,
                                   .kernel = hobe_find_kernel("BE24w", err),
                                   .elements = 1,
                                   .section = section,
                                   .material = {.E = 7e9, .nu = 0.3, .k2 = 1, .k3 = 1},
                                   .to = {1, 0, 0}};
    const struct hobe_clamp clamp = {.beam = name};
    const struct hobe_force force = {.beam = name, .at = 1, .value = {0, 1e3, 0}};
    const struct hobe_spring spring = {.beam = {name}, .at = {1}, .stiffness = {1e3}};
    enum hobe_status status = hobe_model_beam(model, &beam, err);
    if (!status)
        status = hobe_model_clamp(model, &clamp, err);
    if (!status)
        status = hobe_model_spring(model, &spring, err);
    return status ? status : hobe_model_force(model, &force, err);
}

static enum hobe_status go(void *context, struct hobe_error *err)
{
    const struct sections *sections = context;
    hobe_solution *solution[2] = {NULL, NULL};
    hobe_model *model = hobe_model_new(err);
    enum hobe_status status =
        model ? add_one(model, "round", sections->round, err) : HOBE_NO_MEMORY;
    if (!status)
        status = add_one(model, "other", sections->rectangle, err);
    if (!status)
        status = hobe_static(model, &(struct hobe_newton){.steps = 1}, solution, err);
    if (!status)
        status = hobe_static(model, &(struct hobe_newton){.start = solution[0]}, solution + 1, err);
    hobe_solution_free(solution[0]);
    hobe_solution_free(solution[1]);
    hobe_model_free(model);
    return status;
}

int main(void)
{
    struct hobe_error err;
    struct sections sections = {hobe_section_circle(0.03, &err), rectangle(0.03, 0.05)};
    fail_each_allocation(go, &sections, 60, 900, "parts");
    hobe_section_free(sections.round);
    hobe_section_free(sections.rectangle);
    return check_report();
}
