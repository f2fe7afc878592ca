/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modal analysis in which the n-th allocation fails, for n = 1, 2, ... until it gets through: each
 * time it ends with "out of memory", and leaks nothing (the sanitizer looks).  Dense, by Lanczos'
 * method, and with a corner. */
#include "check.h"
#include "fault.h"
#include "scene.h"

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

struct run {
    hobe_model *model;
    enum hobe_modal_method method;
    double omega; /* of the third mode; 0: not known yet */
};

static enum hobe_status go(void *context, struct hobe_error *err)
{
    struct run *run = context;
    const struct hobe_modal_options options = {.modes = 3, .method = run->method};
    hobe_modes *modes;
    struct hobe_mode mode;
    enum hobe_status status = hobe_modal(run->model, NULL, &options, &modes, err);
    check_that(!modes == (status != HOBE_OK), "modes are there when they are found");
    if (!status)
        status = hobe_modes_mode(modes, 2, &mode, err);
    if (!status && run->omega == 0)
        run->omega = mode.omega;
    check_that(status || mode.omega == run->omega, "the same as before");
    hobe_modes_free(modes);
    return status;
}

static void fail_each(int corner, enum hobe_modal_method method, const char *what)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.05, 0.1);
    struct run run = {two_arms(section, corner), method, 0};
    if (go(&run, &err)) /* the model is built here */
        check_stop("%s", err.message);
    fail_each_allocation(go, &run, 10, 1000, what);
    hobe_model_free(run.model);
    hobe_section_free(section);
}

int main(void)
{
    fail_each(0, HOBE_MODAL_DENSE, "dense");
    fail_each(0, HOBE_MODAL_LANCZOS, "Lanczos");
    fail_each(1, HOBE_MODAL_LANCZOS, "Lanczos with a corner");
    return check_report();
}
