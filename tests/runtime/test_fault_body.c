/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body and a mass on a beam, at rest and vibrating, while allocations fail one by one. */
#include "check.h"
#include "fault.h"
#include "scene.h"

static enum hobe_status add_items(hobe_model *model, const hobe_section *section,
                                  struct hobe_error *err)
{
    const struct hobe_beam beam = {.name = "beam",
                                   .kernel = hobe_find_kernel("MGD30w", err),
                                   .elements = 1,
                                   .section = section,
                                   .material = {.E = 7e9, .nu = 0.3, .rho = 2700, .k2 = 1, .k3 = 1},
                                   .to = {1, 0, 0}};
    const struct hobe_body body = {.name = "body",
                                   .density = 7800,
                                   .shape = HOBE_SHAPE_BOX,
                                   .size = {0.1, 0.2, 0.3},
                                   .centre = {1, 0.1, 0}};
    const struct hobe_joint joints[2] = {
        {.beam = {"beam"}, .kind = HOBE_JOINT_RIGID},
        {.beam = {"beam", "body"}, .name = "joint", .at = {1}, .kind = HOBE_JOINT_FIXED}};
    const struct hobe_mass mass = {.beam = "beam", .at = 0.5, .y = 0.01, .mass = 2};
    enum hobe_status status = hobe_model_beam(model, &beam, err);
    if (!status)
        status = hobe_model_body(model, &body, err);
    if (!status)
        status = hobe_model_mass(model, &mass, err);
    for (int i = 0; !status && i < 2; i++)
        status = hobe_model_joint(model, joints + i, err);
    if (!status)
        status = hobe_model_gravity(model, NULL, (const double[3]){0, 0, -9.81}, err);
    return status;
}

static enum hobe_status go(void *section, struct hobe_error *err)
{
    hobe_model *model = hobe_model_new(err);
    hobe_solution *solution = NULL;
    hobe_modes *modes = NULL;
    enum hobe_status status = model ? add_items(model, section, err) : HOBE_NO_MEMORY;
    if (!status)
        status = hobe_static(model, &(struct hobe_newton){0}, &solution, err);
    if (!status)
        status = hobe_modal(model, solution, &(struct hobe_modal_options){.modes = 1}, &modes, err);
    hobe_modes_free(modes);
    hobe_solution_free(solution);
    hobe_model_free(model);
    return status;
}

int main(void)
{
    hobe_section *section = rectangle(0.05, 0.1);
    fail_each_allocation(go, section, 50, 1000, "body");
    hobe_section_free(section);
    return check_report();
}
