/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What supports and joints do to the beams they hold. */
#include "assemble.h"
#include "constraint.h"
#include "damping.h"
#include "load.h"
#include "mass.h"
#include "numbering.h"
#include "solution.h"
#include "spring.h"
#include "vector3.h"

#include <stdio.h>
#include <string.h>

static int is_called(const char *name, const char *wanted)
{
    return name && !strcmp(name, wanted);
}

/* The residual on the vectors of a clamp's node: what holds them. */
static enum hobe_status from_clamp(const hobe_solution *solution, const struct hobe_clamp *clamp,
                                   struct hobe_reaction *reaction, struct hobe_error *err)
{
    const hobe_model *model = solution->model;
    const struct beam *beam = model_find_beam(model, clamp->beam, NULL, err);
    int e;
    const int node = node_at(beam, clamp->at, &e);
    double *r = hobe_alloc(3 * (size_t)model->vectors, sizeof *r, err);
    if (!r)
        return HOBE_NO_MEMORY;
    const struct instant instant = solution_instant(solution, solution->model);
    assemble(model, solution->u, r, NULL);
    constraint_add(model, solution->u, &instant, r, NULL);
    spring_add(model, solution->u, &instant, r, NULL);
    damping_add(model, solution->u, &instant, r, NULL);
    load_subtract(model, solution->u, &instant, solution->info.load, r, NULL);
    if (solution->w)
        mass_force(model, 1, solution->w, r);
    for (int v = 0; v < beam->kernel->vectors; v++) {
        const struct hobe_vector *is = beam->kernel->vector + v;
        const long number = model_vector(model, beam, e, v);
        double q[3], couple[3];
        for (int a = 0; a < 3; a++)
            q[a] = beam_q0(beam, e)[3 * v + a] + solution->u[3 * number + a];
        cross3(q, r + 3 * number, couple);
        for (int a = 0; a < 3 && is->node == node; a++)
            *(is->mode || is->slope ? reaction->moment + a : reaction->force + a) +=
                is->mode || is->slope ? couple[a] : r[3 * number + a];
    }
    hobe_free(r);
    return model_failure(model, err);
}

static enum hobe_status from_tie(const hobe_solution *solution, const struct tie *tie,
                                 struct hobe_reaction *reaction, struct hobe_error *err)
{
    const struct instant instant = solution_instant(solution, solution->model);
    const enum hobe_status status =
        tie_reaction(tie, solution->u, &instant, reaction->force, reaction->moment, err);
    return status ? status : tie_power(tie, solution->u, &instant, &reaction->power, err);
}

static enum hobe_status fail_unknown(const hobe_model *model, const char *name,
                                     struct hobe_error *err)
{
    char known[400] = "";
    size_t used = 0;
    const struct hobe_clamp *clamp = model->clamps.item;
    const struct hobe_joint *joint = model->joints.item;
    for (size_t i = 0; i < model->clamps.count + model->joints.count; i++) {
        const char *is =
            i < model->clamps.count ? clamp[i].name : joint[i - model->clamps.count].name;
        if (is && used < sizeof known)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s\"%s\"",
                                     used ? ", " : "", is);
    }
    return hobe_fail(err, HOBE_UNKNOWN, NULL,
                     "there is no support or joint \"%s\" in the scene; those with a name are: %s",
                     name, used ? known : "none");
}

enum hobe_status hobe_solution_reaction(const hobe_solution *solution, const char *name,
                                        struct hobe_reaction *reaction, struct hobe_error *err)
{
    const hobe_model *model = solution->model;
    *reaction = (struct hobe_reaction){0};
    for (size_t i = 0; i < model->clamps.count; i++) {
        const struct hobe_clamp *clamp = (const struct hobe_clamp *)model->clamps.item + i;
        if (is_called(clamp->name, name))
            return from_clamp(solution, clamp, reaction, err);
    }
    for (size_t i = 0; i < model->ties.count; i++)
        if (is_called(model_tie(model, i)->name, name))
            return from_tie(solution, model_tie(model, i), reaction, err);
    return fail_unknown(model, name, err);
}
