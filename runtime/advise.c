/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cheapest model that holds an accuracy: coarse runs, what they say of the finest, and models
 * tried in the order of their cost. */
#include "advise_search.h"

#include <math.h>
#include <string.h>

static const double OPEN = 0.25;       /* share of the accuracy that the estimate may leave open */
static const double LEAST_OPEN = 0.02; /* where a choice hangs on it */

/* ---- trials ---------------------------------------------------------------------------------- */

static int same_model(const struct advise_model *a, const struct advise_model *b)
{
    return a->kernel == b->kernel && a->elements == b->elements && a->linear == b->linear &&
           a->paper == b->paper && a->step == b->step && a->without == b->without;
}

const struct advise_trial *advise_find_trial(const struct search *s,
                                             const struct advise_model *model)
{
    for (int i = 0; i < s->advice->trials; i++)
        if (same_model(&s->advice->trial[i].model, model))
            return s->advice->trial + i;
    return NULL;
}

static struct advise_trial *add_trial(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    if (a->trials == a->room) {
        const int room = 2 * a->room + 16;
        void *grown = hobe_grow(a->trial, (size_t)a->room, (size_t)room, sizeof *a->trial, err);
        if (!grown)
            return NULL;
        a->trial = grown;
        a->room = room;
    }
    struct advise_trial *trial = a->trial + a->trials;
    trial->value = hobe_alloc((size_t)s->problem->quantities, sizeof *trial->value, err);
    if (!trial->value)
        return NULL;
    a->trials++;
    return trial;
}

static int all_finite(const double *x, int n)
{
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

static enum hobe_status keep_sentence(struct advise_trial *trial, const char *text,
                                      struct hobe_error *err)
{
    trial->failed = 1;
    trial->why = hobe_alloc(strlen(text) + 1, 1, err);
    if (!trial->why)
        return HOBE_NO_MEMORY;
    strcpy(trial->why, text);
    return HOBE_OK;
}

enum hobe_status advise_try_model(struct search *s, const struct advise_model *model,
                                  const struct advise_trial **trial, struct hobe_error *err)
{
    const struct advise_problem *p = s->problem;
    struct hobe_error own;
    int iterations = 0;
    *trial = advise_find_trial(s, model);
    if (!*trial) {
        struct advise_trial *made = add_trial(s, err);
        if (!made)
            return HOBE_NO_MEMORY;
        made->model = *model;
        enum hobe_status status = p->run(p->context, model, made->value, &iterations, &own);
        if (status == HOBE_NO_MEMORY)
            return hobe_fail(err, status, NULL, "%s", own.message);
        if (!status && !all_finite(made->value, p->quantities))
            status = hobe_fail(&own, HOBE_BAD_INPUT, NULL, "a quantity is not a finite number");
        if (status && keep_sentence(made, own.message, err))
            return HOBE_NO_MEMORY;
        made->cost = advise_cost(model, iterations);
        s->advice->cost += made->cost;
        *trial = made;
    }
    if ((*trial)->failed)
        *trial = NULL;
    return HOBE_OK;
}

/* ---- all of it ------------------------------------------------------------------------------- */

static enum hobe_status open_search(struct search *s, const struct advise_problem *problem,
                                    struct advice *advice, struct hobe_error *err)
{
    const size_t n = (size_t)problem->quantities;
    *advice =
        (struct advice){.problem = problem, .model = -1, .linear = {NAN, 0}, .step = {NAN, 0}};
    for (int i = 0; i < ADVISE_WITHOUTS; i++)
        advice->without[i].size = NAN;
    for (int l = 1; l < ADVISE_LEVELS; l++)
        advice->level[l].size = NAN;
    *s = (struct search){.problem = problem, .advice = advice};
    s->accuracy = problem->moves ? 0.5 * problem->accuracy : problem->accuracy;
    advice->best = hobe_alloc(n, sizeof *advice->best, err);
    s->scale = hobe_alloc(n, sizeof *s->scale, err);
    s->x = hobe_alloc(n, sizeof *s->x, err);
    return advice->best && s->scale && s->x ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The levels that run; at least one. */
static enum hobe_status start_levels(struct search *s, struct hobe_error *err)
{
    const struct advise_problem *p = s->problem;
    for (int l = 0; l < p->levels; l++) {
        const enum hobe_status status = advise_start_level(s, p->level[l], err);
        if (status)
            return status;
    }
    if (s->levels > 0)
        return HOBE_OK;
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL, "no model of the scene runs: %.900s",
                     s->advice->trial[s->advice->trials - 1].why);
}

static enum hobe_status search(struct search *s, struct hobe_error *err)
{
    enum hobe_status status = start_levels(s, err);
    for (double open = OPEN; !status && open > LEAST_OPEN; open /= 4) {
        status = advise_settle(s, open, err);
        if (!status)
            status = advise_choose(s, err);
        if (!status && s->advice->holds && !advise_hangs(s))
            break;
    }
    if (!status)
        status = advise_try_twins(s, err);
    if (!status && s->problem->moves)
        status = advise_choose_step(s, err);
    if (!status && (s->problem->weighs_linear || s->problem->takes_linear))
        status = advise_weigh_linear(s, err);
    if (!status)
        status = advise_weigh_without(s, err);
    if (!status)
        advise_weigh_levels(s);
    for (int i = 0; i < s->advice->trials; i++) {
        struct advise_trial *trial = s->advice->trial + i;
        if (!trial->failed)
            trial->error = advise_loss_of(s, trial->value, s->advice->best);
    }
    return status;
}

enum hobe_status advise(const struct advise_problem *problem, struct advice *advice,
                        struct hobe_error *err)
{
    struct search s;
    enum hobe_status status = open_search(&s, problem, advice, err);
    if (!status)
        status = search(&s, err);
    for (int l = 0; l < s.levels; l++)
        advise_close_level(s.level + l);
    hobe_free(s.scale);
    hobe_free(s.x);
    return status;
}

void advice_free(struct advice *advice)
{
    for (int i = 0; i < advice->trials; i++) {
        hobe_free(advice->trial[i].value);
        hobe_free(advice->trial[i].why);
    }
    hobe_free(advice->trial);
    hobe_free(advice->best);
    *advice = (struct advice){0};
}
