/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam with a body on a hinge, reduced, at rest, vibrating and in motion, and its basis written
 * and read, while allocations fail one by one. */
#include "check.h"
#include "fault.h"
#include "scene.h"

#include <math.h>
#include <stdlib.h>

static enum hobe_status add_items(hobe_model *model, const hobe_section *section,
                                  struct hobe_error *err)
{
    const struct hobe_beam beam = {.name = "beam",
                                   .kernel = hobe_find_kernel("MGD30", err),
                                   .elements = 1,
                                   .section = section,
                                   .material = {.E = 7e9, .nu = 0.3, .rho = 2700, .k2 = 1, .k3 = 1},
                                   .damping = {.mass = 1},
                                   .to = {1, 0, 0}};
    const struct hobe_body body = {.name = "body",
                                   .density = 7800,
                                   .shape = HOBE_SHAPE_BOX,
                                   .size = {0.1, 0.2, 0.3},
                                   .centre = {1, 0.1, 0}};
    const struct hobe_clamp clamp = {.beam = "beam"};
    const struct hobe_joint joint = {.beam = {"beam", "body"}, .at = {1}, .kind = HOBE_JOINT_FIXED};
    const struct hobe_moment moment = {.beam = "beam", .at = 1, .value = {10, 0, 0}};
    enum hobe_status status = hobe_model_beam(model, &beam, err);
    if (!status)
        status = hobe_model_body(model, &body, err);
    if (!status)
        status = hobe_model_clamp(model, &clamp, err);
    if (!status)
        status = hobe_model_joint(model, &joint, err);
    if (!status)
        status = hobe_model_moment(model, &moment, err);
    if (!status)
        status = hobe_model_gravity(model, NULL, (const double[3]){0, 0, -9.81}, err);
    return status;
}

static enum hobe_status solve_all(hobe_model *model, struct hobe_error *err)
{
    const struct hobe_dynamic options = {.to = 0.002, .step = 0.001, .store = 0.002};
    hobe_solution *solution = NULL;
    hobe_modes *modes = NULL;
    hobe_history *history = NULL;
    enum hobe_status status = hobe_static(model, &(struct hobe_newton){0}, &solution, err);
    if (!status)
        status = hobe_modal(model, solution, &(struct hobe_modal_options){.modes = 1}, &modes, err);
    if (!status)
        status = hobe_dynamic(model, &options, &history, err);
    hobe_history_free(history);
    hobe_modes_free(modes);
    hobe_solution_free(solution);
    return status;
}

/* Any two fields: making better ones has its own test. */
static enum hobe_status reduce(hobe_model *model, hobe_reduced **reduced, struct hobe_error *err)
{
    struct hobe_model_info info;
    const enum hobe_status status = hobe_model_build(model, err);
    if (status)
        return status;
    hobe_model_info(model, &info);
    double *field = calloc((size_t)(6 * info.vectors), sizeof *field);
    for (long i = 0; i < 6 * info.vectors; i++)
        field[i] = sin((double)i);
    const struct hobe_reduce options = {.method = HOBE_REDUCE_FIELDS, .field = field, .fields = 2};
    const enum hobe_status made = hobe_reduce(model, &options, reduced, err);
    free(field);
    return made;
}

static enum hobe_status go(void *section, struct hobe_error *err)
{
    hobe_model *model = hobe_model_new(err), *small = NULL;
    hobe_reduced *reduced = NULL, *read = NULL;
    void *bytes = NULL;
    size_t size;
    enum hobe_status status = model ? add_items(model, section, err) : HOBE_NO_MEMORY;
    if (!status)
        status = reduce(model, &reduced, err);
    if (!status)
        status = hobe_reduced_write(reduced, &bytes, &size, err);
    if (!status)
        status = hobe_reduced_read(model, bytes, size, &read, err);
    if (!status)
        status = hobe_reduced_model(read, model, &small, err);
    if (!status)
        status = solve_all(small, err);
    hobe_model_free(small);
    hobe_free(bytes);
    hobe_reduced_free(read);
    hobe_reduced_free(reduced);
    hobe_model_free(model);
    return status;
}

int main(void)
{
    hobe_section *section = rectangle(0.05, 0.1);
    fail_each_allocation(go, section, 100, 3000, "reduction");
    hobe_section_free(section);
    return check_report();
}
