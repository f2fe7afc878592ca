/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Advice about a formula in place of a scene, while allocations fail one by one. */
#include "advise.h"
#include "check.h"
#include "fault.h"

#include <math.h>

/* Errors of second order in the mesh, a tenth lost without w, and meshes of 3 do not run. */
static enum hobe_status run(void *context, const struct advise_model *model, double *value,
                            int *iterations, struct hobe_error *err)
{
    const double n = model->elements, w = model->kernel->modes > 3;
    (void)context;
    *iterations = model->linear ? 1 : 4;
    value[0] = (1 + 0.1 * w) * (1 + 1 / (n * n)) + 0.5 * model->linear;
    value[1] = 1e-15 * n;
    if (n == 3)
        return hobe_fail(err, HOBE_SINGULAR, NULL, "three is not a mesh");
    return HOBE_OK;
}

static void check_advice(const struct advice *advice)
{
    const struct advise_model *taken = &advice->trial[advice->model].model;
    const double error = 1.0 / (taken->elements * taken->elements);
    check_that(advice->holds && taken->kernel->modes > 3 && !taken->linear, "w, not linear");
    check_that(error <= 1e-2 && error > 1e-2 / 4, "no finer than needed: %d", taken->elements);
    check_relative(advice->best[0], 1.1, 1e-3, "Richardson's limit"); /* of the meshes 1, 2, 4, 8 */
    check_relative(advice->level[1].size, 0.1 / 1.1, 1e-3, "what w is worth");
    check_relative(advice->linear.size, 0.5 / 1.1, 1e-3, "what a linear model loses");
}

static enum hobe_status go(void *context, struct hobe_error *err)
{
    static const char *const name[] = {"value", "rounding"}, *const unit[] = {"m", NULL};
    const struct hobe_kernel *level[ADVISE_LEVELS];
    const struct advise_problem problem = {.quantities = 2,
                                           .name = name,
                                           .unit = unit,
                                           .accuracy = 1e-2,
                                           .levels = advise_levels(level),
                                           .level = level,
                                           .most = 64,
                                           .takes_linear = 1,
                                           .run = run};
    struct advice advice;
    struct hobe_text text = {0};
    enum hobe_status status = advise(&problem, &advice, err);
    (void)context;
    if (!status) {
        advise_say(&advice, &text);
        advise_say_evidence(&advice, &text);
        advise_table(&advice, &text);
        status = hobe_text_check(&text, err);
    }
    if (!status)
        check_advice(&advice);
    hobe_text_free(&text);
    advice_free(&advice);
    return status;
}

int main(void)
{
    fail_each_allocation(go, NULL, 20, 1000, "advice");
    return check_report();
}
