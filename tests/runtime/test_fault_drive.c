/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A driven joint and loads with histories, while allocations fail one by one: also where a drive
 * stores what it has integrated, in the middle of a residual. */
#include "check.h"
#include "fault.h"
#include "scene.h"

struct drives {
    hobe_drive *ramp, *speed;
};

static enum hobe_status one(void *context, double t, double *f, struct hobe_error *err)
{
    (void)context;
    (void)t;
    (void)err;
    *f = 1;
    return HOBE_OK;
}

static enum hobe_status add_items(hobe_model *model, const hobe_section *section,
                                  const struct drives *drives, struct hobe_error *err)
{
    const struct hobe_beam beam = {.name = "beam",
                                   .kernel = hobe_find_kernel("MGD30w", err),
                                   .elements = 1,
                                   .section = section,
                                   .material = {.E = 7e9, .nu = 0.3, .rho = 2700, .k2 = 1, .k3 = 1},
                                   .to = {1, 0, 0}};
    const struct hobe_joint joint = {.beam = {"beam"},
                                     .kind = HOBE_JOINT_CYLINDRICAL,
                                     .axis = {0, 0, 1},
                                     .angle = drives->speed,
                                     .position = drives->ramp};
    enum hobe_status status = hobe_model_beam(model, &beam, err);
    if (!status)
        status = hobe_model_joint(model, &joint, err);
    if (!status)
        status = hobe_model_gravity_history(model, NULL, (const double[3]){0, 0, -9.81},
                                            drives->ramp, err);
    return status;
}

static enum hobe_status run_scene(hobe_model *model, const hobe_section *section,
                                  const struct drives *drives, struct hobe_error *err)
{
    hobe_solution *solution = NULL;
    enum hobe_status status = add_items(model, section, drives, err);
    if (!status)
        status = hobe_static(model, &(struct hobe_newton){.time = 0.1}, &solution, err);
    hobe_solution_free(solution);
    return status;
}

static enum hobe_status go(void *context, struct hobe_error *err)
{
    static const double point[2][2] = {{0, 0}, {1, 0.1}};
    struct drives drives = {hobe_drive_points(2, point, HOBE_RAMP, 0, err), NULL};
    drives.speed = drives.ramp ? hobe_drive_function(one, NULL, 1, err) : NULL;
    hobe_model *model = drives.speed ? hobe_model_new(err) : NULL;
    const enum hobe_status status =
        model ? run_scene(model, context, &drives, err) : HOBE_NO_MEMORY;
    hobe_model_free(model);
    hobe_drive_free(drives.ramp);
    hobe_drive_free(drives.speed);
    return status;
}

int main(void)
{
    hobe_section *section = rectangle(0.03, 0.05);
    fail_each_allocation(go, section, 30, 400, "driven");
    hobe_section_free(section);
    return check_report();
}
