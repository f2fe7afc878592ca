/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modal analysis, buckling and paths in which the n-th allocation fails, for n = 1, 2, ... until it
 * gets through: each time it ends with "out of memory", and leaks nothing (the sanitizer looks).
 * Dense, by Lanczos' method, and with a corner; in a turning frame; a path to its load and to a
 * displacement. */
#include "check.h"
#include "scene.h"

#include <math.h>
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
    add_force(model, "second", 1, -1e4, 0, 2e3);
    return model;
}

/* What is tried gives one number to compare. */
typedef enum hobe_status trial(hobe_model *model, int variant, double *number,
                               struct hobe_error *err);

static enum hobe_status vibrate(hobe_model *model, int method, double *omega,
                                struct hobe_error *err)
{
    const struct hobe_modal_options options = {.modes = 3,
                                               .method = (enum hobe_modal_method)method};
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

static enum hobe_status turn(hobe_model *model, int method, double *omega, struct hobe_error *err)
{
    const struct hobe_modal_options options = {.modes = 2,
                                               .method = (enum hobe_modal_method)method};
    hobe_solution *state;
    hobe_modes *modes = NULL;
    struct hobe_mode mode = {0};
    enum hobe_status status = hobe_static(model, &(struct hobe_newton){0}, &state, err);
    if (!status) {
        status = hobe_modal(model, state, &options, &modes, err);
        check_that(!modes == (status != HOBE_OK), "modes are there when they are found");
    }
    if (!status)
        status = hobe_modes_mode(modes, 1, &mode, err);
    *omega = mode.omega;
    hobe_modes_free(modes);
    hobe_solution_free(state);
    return status;
}

static enum hobe_status buckle(hobe_model *model, int method, double *factor,
                               struct hobe_error *err)
{
    const struct hobe_modal_options options = {.modes = 1,
                                               .method = (enum hobe_modal_method)method};
    hobe_modes *modes;
    const enum hobe_status status = hobe_buckling(model, NULL, &options, &modes, err);
    check_that(!modes == (status != HOBE_OK), "modes are there when they are found");
    *factor = status ? 0 : hobe_modes_factor(modes, 0);
    hobe_modes_free(modes);
    return status;
}

static enum hobe_status follow(hobe_model *model, int reach, double *load, struct hobe_error *err)
{
    struct hobe_path_options options = {.arc = 0.3, .to = 0.6};
    hobe_path *path;
    struct hobe_solution_info info = {0};
    struct hobe_path_info all;
    if (reach)
        options.reach = (struct hobe_reach){NULL, "second", 1, {0, 0, 0.003}};
    const enum hobe_status status = hobe_path_follow(model, &options, &path, err);
    check_that(!path == (status != HOBE_OK), "a path is there when it is found");
    if (!status) {
        hobe_path_info(path, &all);
        hobe_solution_info(hobe_path_point(path, all.points - 1), &info);
        check_that((int)all.end == reach, "it ends where it should");
    }
    *load = info.load;
    hobe_path_free(path);
    return status;
}

static void add_spin(hobe_model *model)
{
    struct hobe_error err;
    if (hobe_model_spin(model, &(struct hobe_spin){.axis = {0, 1, 1}, .speed = 30}, &err))
        check_stop("%s", err.message);
}

static void fail_each(trial *try, int corner, int variant)
{
    struct hobe_error err = {0};
    /* after a static solution the solver goes on with the pivots of whatever came before */
    const double share = try == turn ? 1e-10 : 0;
    double expected, number;
    long n = 0, made;
    hobe_section *section = rectangle(0.05, 0.1);
    hobe_model *model = two_arms(section, corner);
    if (try == turn)
        add_spin(model);
    if (try(model, variant, &expected, &err)) /* the model is built here */
        check_stop("%s", err.message);
    do {
        hobe_fail_allocation(++n);
        const enum hobe_status status = try(model, variant, &number, &err);
        made = hobe_fail_allocation(0);
        if (made >= n)
            check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY,
                       "allocation %ld of variant %d: status %d, %s", n, variant, status,
                       err.message);
        else
            check_that(status == HOBE_OK && fabs(number - expected) <= share * fabs(expected),
                       "nothing failed: status %d, %.17g, before %.17g", status, number, expected);
    } while (made >= n && n < 1000);
    check_that(n > 10 && n < 1000, "allocations were counted: %ld", n);
    printf("%ld allocations failed in turn\n", n - 1);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    fail_each(vibrate, 0, HOBE_MODAL_DENSE);
    fail_each(vibrate, 0, HOBE_MODAL_LANCZOS);
    fail_each(vibrate, 1, HOBE_MODAL_LANCZOS);
    fail_each(turn, 0, HOBE_MODAL_DENSE);
    fail_each(turn, 1, HOBE_MODAL_LANCZOS);
    fail_each(buckle, 0, HOBE_MODAL_DENSE);
    fail_each(buckle, 1, HOBE_MODAL_LANCZOS);
    fail_each(follow, 0, HOBE_PATH_LOAD);
    fail_each(follow, 1, HOBE_PATH_DISPLACEMENT);
    return check_report();
}
