/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Advice about a formula in place of a scene, while allocations fail one by one. */
#include "advise.h"
#include "check.h"
#include "fault.h"

#include <math.h>

/* Errors of second order in the mesh and, where it moves, in the step; a tenth lost without w, and
 * meshes of 3 do not run. */
static enum hobe_status run(void *context, const struct advise_model *model, double *value,
                            int *iterations, struct hobe_error *err)
{
    const double n = model->elements, w = model->kernel->modes > 3;
    const double step = model->step > 0 ? model->step : 1;
    const int moves = *(const int *)context;
    *iterations = model->linear ? 1 : (int)fmax(1, 256 / step);
    value[0] = (1 + 0.1 * w) * (1 + 1 / (n * n)) + 0.5 * model->linear + 0.05 * step * step * moves;
    value[1] = 1e-15 * n;
    if (n == 3)
        return hobe_fail(err, HOBE_SINGULAR, NULL, "three is not a mesh");
    return HOBE_OK;
}

static void check_advice(const struct advice *advice)
{
    const struct advise_model *taken = &advice->trial[advice->model].model;
    const double error = 1.0 / (taken->elements * taken->elements);
    const int moves = advice->problem->moves;
    check_that(advice->holds && taken->kernel->modes > 3 && !taken->linear, "w, not linear");
    check_that(error <= 1e-2 && error > 1e-2 / 4, "no finer than needed: %d", taken->elements);
    check_relative(advice->best[0], 1.1, 1e-3, "Richardson's limit"); /* of the meshes 1, 2, 4, 8 */
    check_relative(advice->level[1].size, 0.1 / 1.1, 1e-3, "what w is worth");
    check_that(taken->step == (moves ? 0.25 : 0), "0.003 are left by a quarter of the step: %g",
               taken->step);
    if (moves)
        check_relative(advice->step.size, 0.05 / 16 / 1.1, 1e-3, "what the step leaves open");
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
                                           .moves = *(const int *)context,
                                           .takes_linear = 1,
                                           .run = run,
                                           .context = context};
    struct advice advice;
    struct hobe_text text = {0};
    enum hobe_status status = advise(&problem, &advice, err);
    if (!status) {
        advise_say(&advice, &text);
        advise_say_evidence(&advice, &text);
        advise_table(&advice, &text);
        advise_json(&advice, "hobe run", &text);
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
    int moves[] = {0, 1};
    fail_each_allocation(go, &moves[0], 20, 1000, "advice");
    fail_each_allocation(go, &moves[1], 20, 1000, "advice about a motion");
    return check_report();
}
