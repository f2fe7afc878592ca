/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modal analysis in which the n-th allocation fails, for n = 1, 2, ... until it gets through: each
 * time it ends with "out of memory", and leaks nothing (the sanitizer looks).  Dense, by Lanczos'
 * method, and with a corner. */
#include "check.h"
#include "scene.h"

#include <stdio.h>

static hobe_model *two_arms(hobe_section *section, int corner)
{
    struct hobe_beam beam = beam_along_x("MGD30", 2, section, 70e9, 0.3, 1);
    beam.material.rho = 2700;
    hobe_model *model = cantilever(&beam, 0);
    beam.name = "second";
    beam.from[0] = 1;
    beam.to[0] = corner ? 1 : 2;
    beam.to[2] = corner;
    add_beam(model, &beam);
    add_join(model, "beam", 1, "second", 0);
    return model;
}

static enum hobe_status go(hobe_model *model, enum hobe_modal_method method, double *omega,
                           struct hobe_error *err)
{
    const struct hobe_modal_options options = {.modes = 3, .method = method};
    hobe_modes *modes;
    struct hobe_mode mode;
    enum hobe_status status = hobe_modal(model, NULL, &options, &modes, err);
    check_that(!modes == (status != HOBE_OK), "modes are there when they are found");
    if (!status)
        status = hobe_modes_mode(modes, 2, &mode, err);
    *omega = status ? 0 : mode.omega;
    hobe_modes_free(modes);
    return status;
}

static void fail_each(int corner, enum hobe_modal_method method)
{
    struct hobe_error err = {0};
    double expected, omega;
    long n = 0, made;
    hobe_section *section = rectangle(0.05, 0.1);
    hobe_model *model = two_arms(section, corner);
    if (go(model, method, &expected, &err)) /* the model is built here */
        check_stop("%s", err.message);
    do {
        hobe_fail_allocation(++n);
        const enum hobe_status status = go(model, method, &omega, &err);
        made = hobe_fail_allocation(0);
        if (made >= n)
            check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY,
                       "allocation %ld of method %d: status %d, %s", n, method, status,
                       err.message);
        else
            check_that(status == HOBE_OK && omega == expected,
                       "nothing failed: status %d, omega %.17g, before %.17g", status, omega,
                       expected);
    } while (made >= n && n < 1000);
    check_that(n > 10 && n < 1000, "allocations were counted: %ld", n);
    printf("%ld allocations failed in turn\n", n - 1);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    fail_each(0, HOBE_MODAL_DENSE);
    fail_each(0, HOBE_MODAL_LANCZOS);
    fail_each(1, HOBE_MODAL_LANCZOS);
    return check_report();
}
