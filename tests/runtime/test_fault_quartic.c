/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reduced energies of both forms while allocations fail one by one.  Looks into the core
 * (quartic.h). */
#include "check.h"
#include "fault.h"
#include "quartic.h"
#include "quartic_closed.h"
#include "scene.h"
#include "tangent.h"

struct fields {
    const hobe_model *model;
    const double *field; /* [3][vectors][3], or of functions */
};

static enum hobe_status open(void *context, struct hobe_error *err)
{
    const struct fields *fields = context;
    struct quartic quartic;
    const enum hobe_status status =
        quartic_open(&quartic, fields->model, fields->field, 2, fields->field, err);
    if (!status)
        quartic_close(&quartic);
    return status;
}

static enum hobe_status closed(void *context, struct hobe_error *err)
{
    const struct fields *fields = context;
    struct quartic_closed quartic;
    const enum hobe_status status =
        quartic_closed_open(&quartic, fields->model, 3, fields->field, err);
    if (!status)
        quartic_closed_close(&quartic);
    return status;
}

int main(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.1);
    const struct hobe_beam beam = beam_along_x("MGD30w", 2, section, 70e9, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    double *field = hobe_alloc((size_t)(9 * model->vectors), sizeof *field, &err);
    if (!field)
        check_stop("%s", err.message);
    struct fields fields = {model, field};
    fail_each_allocation(open, &fields, 4, 10, "quartic_open");
    fail_each_allocation(closed, &fields, 4, 10, "quartic_closed_open");
    hobe_free(field);
    hobe_model_free(model);
    hobe_section_free(section);
    return check_report();
}
