/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bases, enriched and closed, while the n-th of the library's own allocations fails. */
#include "basis.h"
#include "check.h"
#include "fault.h"
#include "scene.h"

struct make {
    hobe_model *model;
    struct hobe_reduce options;
};

static enum hobe_status make_basis(void *context, struct hobe_error *err)
{
    const struct make *make = context;
    struct basis basis;
    const enum hobe_status status = basis_make(make->model, &make->options, &basis, err);
    basis_free(&basis);
    return status;
}

static enum hobe_status reduce(void *context, struct hobe_error *err)
{
    const struct make *make = context;
    hobe_reduced *reduced;
    const enum hobe_status status = hobe_reduce(make->model, &make->options, &reduced, err);
    hobe_reduced_free(reduced);
    return status;
}

int main(void)
{
    hobe_section *section = rectangle(0.1, 0.06);
    struct hobe_beam beam = beam_along_x("BE24", 1, section, 1e9, 0.3, 2);
    beam.material.rho = 1000;
    hobe_model *model = cantilever(&beam, 0), *unloaded = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, 200);
    struct hobe_error err;
    if (hobe_model_build(model, &err) || hobe_model_build(unloaded, &err))
        check_stop("%s", err.message);
    struct make make = {model, {.accuracy = 1e-5, .modes = 6}};
    fail_each_allocation(reduce, &make, 100, 1000, "accuracy");
    make.options = (struct hobe_reduce){.accuracy = 1e-3, .modes = 2, .closed = 3};
    fail_each_allocation(reduce, &make, 100, 1000, "accuracy, closed");
    make.model = unloaded;
    make.options = (struct hobe_reduce){.method = HOBE_REDUCE_MODES, .modes = 1, .closed = 3};
    fail_each_allocation(make_basis, &make, 50, 1000, "modes");
    hobe_model_free(unloaded);
    hobe_model_free(model);
    hobe_section_free(section);
    return check_report();
}
