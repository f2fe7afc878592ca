/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solvers confined to few fields while the n-th allocation fails: component modes of a jointed
 * scene in statics and in motion, dense and by Lanczos' method, and main directions of states. */
#include "check.h"
#include "fault.h"
#include "scene.h"

struct trial {
    hobe_model *model;
    struct hobe_projection projection;
};

static enum hobe_status solve_static(void *context, struct hobe_error *err)
{
    const struct trial *trial = context;
    const struct hobe_newton options = {.steps = 2, .projection = &trial->projection};
    hobe_solution *solution;
    const enum hobe_status status = hobe_static(trial->model, &options, &solution, err);
    check_that(!solution == (status != HOBE_OK), "a solution is there when it is found");
    hobe_solution_free(solution);
    return status;
}

static enum hobe_status move(void *context, struct hobe_error *err)
{
    const struct trial *trial = context;
    const struct hobe_dynamic options = {
        .to = 2e-3, .step = 1e-3, .projection = &trial->projection};
    hobe_history *history;
    const enum hobe_status status = hobe_dynamic(trial->model, &options, &history, err);
    check_that(!history == (status != HOBE_OK), "a motion is there when it is found");
    hobe_history_free(history);
    return status;
}

/* Built, so that later runs allocate the same each time. */
static hobe_model *bent(const hobe_section *section, int elements, int hinged)
{
    struct hobe_error err;
    struct hobe_beam beam = beam_along_x("MGD30", elements, section, 1e9, 0.3, 1);
    beam.material.rho = 1000;
    hobe_model *model = cantilever(&beam, 0);
    if (hinged) {
        beam.name = "second";
        beam.from[0] = 1;
        beam.to[0] = 2;
        add_beam(model, &beam);
        add_joint(model, &(struct hobe_joint){
                             .beam = {"beam", "second"}, .at = {1, 0}, .kind = HOBE_JOINT_FIXED});
    }
    add_force(model, "beam", 1, 0, 1, 2);
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    return model;
}

static void fail(fault_run *run, struct trial *trial, const char *what)
{
    struct hobe_error err;
    if (run(trial, &err)) /* what is made once is made here */
        check_stop("%s: %s", what, err.message);
    fail_each_allocation(run, trial, 20, 1000, what);
}

int main(void)
{
    hobe_section *section = rectangle(0.05, 0.08);
    hobe_model *jointed = bent(section, 1, 1), *fine = bent(section, 18, 0);
    const struct hobe_projection few = {.modes = 40, .deviation = 1e-12},
                                 interfaces = {.modes = 16};
    fail(solve_static, &(struct trial){jointed, few}, "static");
    fail(move, &(struct trial){jointed, few}, "motion");
    fail(solve_static, &(struct trial){fine, interfaces}, "by Lanczos' method");
    hobe_solution *state = solve(fine, 1);
    const hobe_solution *const states[] = {state};
    fail(solve_static,
         &(struct trial){fine,
                         {.method = HOBE_PROJECTION_SNAPSHOTS, .snapshot = states, .snapshots = 1}},
         "snapshots");
    hobe_solution_free(state);
    hobe_model_free(jointed);
    hobe_model_free(fine);
    hobe_section_free(section);
    return check_report();
}
