/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The evidence: what leaving out an effect loses. */
#include "advise_search.h"

#include <math.h>

enum hobe_status advise_weigh_linear(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    struct advise_model model = a->trial[a->model].model;
    const struct advise_trial *trial;
    model.linear = 1;
    const enum hobe_status status = advise_try_model(s, &model, &trial, err);
    if (status || !trial)
        return status;
    a->linear = advise_loss_of(s, trial->value, a->trial[a->model].value);
    if (!s->problem->takes_linear || a->linear.size > 2 * s->accuracy)
        return HOBE_OK;
    return advise_try_element(s, model.kernel, 1, err);
}

/* Equilibria in place of a motion: what they lose, all where there is none or no such quantity of
 * it; they are taken where they hold and cost less. */
static enum hobe_status weigh_dynamics(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    struct advise_loss *loss = a->without + ADVISE_NO_INERTIA, error;
    struct advise_model model = a->trial[a->model].model;
    const struct advise_trial *trial;
    if (!s->problem->dynamic)
        return HOBE_OK;
    model.without = ADVISE_NO_INERTIA;
    model.step = 0;
    const enum hobe_status status = advise_try_model(s, &model, &trial, err);
    if (status)
        return status;
    *loss = trial ? advise_loss_of(s, trial->value, a->trial[a->model].value)
                  : (struct advise_loss){INFINITY, 0};
    if (trial && advise_holds(s, trial, &error) && trial->cost < a->trial[a->model].cost) {
        advise_take(s, trial, 1, error);
        a->step.size = NAN; /* it has none */
    }
    return HOBE_OK;
}

enum hobe_status advise_weigh_without(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    for (int w = ADVISE_COMPLETE + 1; w < ADVISE_NO_INERTIA; w++) {
        struct advise_model model = a->trial[a->model].model;
        const struct advise_trial *trial;
        model.without = (enum advise_without)w;
        const enum hobe_status status = advise_try_model(s, &model, &trial, err);
        if (status)
            return status;
        if (trial)
            a->without[w] = advise_loss_of(s, trial->value, a->trial[a->model].value);
    }
    return weigh_dynamics(s, err);
}

void advise_weigh_levels(struct search *s)
{
    struct advice *a = s->advice;
    const struct advise_model *taken = &a->trial[a->model].model;
    const struct advise_model twin = plain(taken->kernel, taken->elements);
    for (int l = 0, at = 0; l < s->levels; l++) {
        while (s->problem->level[at] != s->level[l].kernel)
            at++;
        if (l > 0 && s->level[l].of[STEP].count > 0)
            a->level[at] = advise_loss_of(s, s->level[l].of[STEP].limit, NULL);
        if (advise_same_section(s->level[l].kernel, taken->kernel) && advise_find_trial(s, &twin)) {
            advise_predict(s, l, 0, s->x);
            a->mesh = advise_loss_of(s, advise_find_trial(s, &twin)->value, s->x);
        }
    }
}
