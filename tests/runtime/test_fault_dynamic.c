/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motions in which the n-th allocation fails, for n = 1, 2, ... until one gets through: each time
 * they end with "out of memory", and leak nothing (the sanitizer looks).  From the reference and
 * from the equilibrium, with fixed steps and chosen ones. */
#include "check.h"
#include "scene.h"

#include <stdio.h>

static hobe_model *pendulum(const hobe_section *section, int clamped)
{
    struct hobe_error err;
    struct hobe_beam beam = beam_along_x("MGD30", 1, section, 1e9, 0.3, 1);
    hobe_model *model = new_model();
    beam.material.rho = 1000;
    add_beam(model, &beam);
    const struct hobe_joint pin = {.beam = {"beam"}, .kind = HOBE_JOINT_SPHERICAL};
    if (clamped)
        add_clamp(model, "beam", 0, 0);
    else if (hobe_model_joint(model, &pin, &err))
        check_stop("%s", err.message);
    if (hobe_model_gravity(model, NULL, (const double[3]){0, 0, -9.81}, &err) ||
        hobe_model_motion(model, &(struct hobe_motion){.beam = "beam"}, &err))
        check_stop("%s", err.message);
    return model;
}

static void fail_each(const hobe_section *section, struct hobe_dynamic options)
{
    struct hobe_error err = {0};
    hobe_history *history;
    struct hobe_history_info info = {0};
    long n = 0, made;
    hobe_model *model = pendulum(section, options.equilibrium);
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    do {
        hobe_fail_allocation(++n);
        const enum hobe_status status = hobe_dynamic(model, &options, &history, &err);
        made = hobe_fail_allocation(0);
        check_that(!history == (status != HOBE_OK), "a motion is there when it is found");
        if (made >= n)
            check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY,
                       "allocation %ld: status %d, %s", n, status, err.message);
        else {
            check_that(status == HOBE_OK, "nothing failed: status %d, %s", status, err.message);
            hobe_history_info(history, &info);
            check_that(info.states > 2, "states are kept");
        }
        hobe_history_free(history);
    } while (made >= n && n < 1000);
    check_that(n > 10 && n < 1000, "allocations were counted: %ld", n);
    printf("%ld allocations failed in turn\n", n - 1);
    hobe_model_free(model);
}

int main(void)
{
    hobe_section *section = rectangle(0.05, 0.08);
    fail_each(section, (struct hobe_dynamic){.to = 4e-3, .step = 1e-3});
    fail_each(section, (struct hobe_dynamic){.to = 4e-3, .accuracy = 1e-4, .step = 1e-3});
    fail_each(section, (struct hobe_dynamic){.to = 4e-3, .step = 1e-3, .equilibrium = 1});
    hobe_section_free(section);
    return check_report();
}
