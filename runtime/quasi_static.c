/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "quasi_static.h"

#include "solution.h"

#include <math.h>

static const double NEAR = 1e-6; /* of the time between states: one so near the end is the end */

/* The equilibrium at a time, looked for from the state before. */
static enum hobe_status keep(hobe_model *model, double time, const hobe_solution *before,
                             hobe_history *history, struct hobe_error *err)
{
    struct hobe_history_info *info = &history->info;
    hobe_solution *state;
    const enum hobe_status status =
        hobe_static(model, &(struct hobe_newton){.start = before, .time = time}, &state, err);
    if (status)
        return status;
    info->time = time;
    info->iterations += state->info.iterations;
    info->factorisations += state->info.factorisations;
    return history_append(history, state,
                          &(struct hobe_energies){.time = time, .strain = state->info.energy}, err);
}

enum hobe_status quasi_static(hobe_model *model, const struct hobe_dynamic *options,
                              hobe_history *history, struct hobe_error *err)
{
    const hobe_solution *before = options->start;
    const double every = options->store, to = options->to, begin = before ? before->info.time : 0;
    if (!(every > 0) || !(to > begin))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a quasi-static motion needs store > 0 s, the time between its states, "
                         "and an end after its start at t = %g s, got %g and %g",
                         begin, every, to);
    history->info.smallest_step = history->info.largest_step = every;
    for (long k = 0;; k++) {
        const double next = begin + (double)k * every, t = next < to - NEAR * every ? next : to;
        const enum hobe_status status = keep(model, t, before, history, err);
        if (status || t == to)
            return status;
        before = hobe_history_state(history, history->info.states - 1);
        history->info.steps++;
    }
}
