/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step in time: what it leaves open, by halves of it (Richardson), and the longest that holds.
 */
#include "advise_search.h"

#include <math.h>

static const double OPEN = 0.25;  /* share of the accuracy that the limit may leave open */
enum { FINEST = 64 };             /* parts of the script's step, at most */
static const double LONGEST = 64; /* times the script's step, at most */

/* The model with another step; 1: that of the script. */
static struct advise_model with_step(const struct advise_model *model, double step)
{
    struct advise_model other = *model;
    other.step = step == 1 ? 0 : step;
    return other;
}

/* Terms T(h_0/k) = Q(h_0/k) - Q(h_0), k = 1, 2, 4, ..., until their limit is known well enough:
 * by three at least, as two may agree by chance. */
static enum hobe_status find_terms(struct search *s, const struct advise_trial *taken,
                                   struct sequence *of, struct hobe_error *err)
{
    const struct advise_model model = taken->model;
    const int at = (int)(taken - s->advice->trial);
    for (int parts = 1; parts <= FINEST; parts *= 2) {
        const struct advise_model next = with_step(&model, 1.0 / parts);
        const struct advise_trial *trial;
        const enum hobe_status status = advise_try_model(s, &next, &trial, err);
        if (status || !trial)
            return status;
        advise_add_term(s, of, OWN, parts, trial->value, s->advice->trial[at].value);
        if (advise_loss_of(s, of->open, NULL).size <= OPEN * s->accuracy)
            return HOBE_OK;
    }
    return HOBE_OK;
}

/* Tries a step, which is taken where it is better than the one taken: one that holds where that
 * does not, or costs less; or is nearer, where nothing holds.  *better: whether it is. */
static enum hobe_status try_step(struct search *s, double step, int *better, struct hobe_error *err)
{
    struct advice *a = s->advice;
    const struct advise_model model = with_step(&a->trial[a->model].model, step);
    const struct advise_trial *trial;
    struct advise_loss error;
    *better = 0;
    const enum hobe_status status = advise_try_model(s, &model, &trial, err);
    if (status || !trial)
        return status;
    const int held = advise_holds(s, trial, &error);
    *better = held ? !a->holds || trial->cost < a->trial[a->model].cost
                   : !a->holds && error.size < a->error.size;
    if (*better)
        advise_take(s, trial, held, error);
    return HOBE_OK;
}

/* Longer steps while they hold, or shorter ones until one does. */
static enum hobe_status try_steps(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    enum hobe_status status = HOBE_OK;
    int better = 1;
    a->holds = advise_holds(s, a->trial + a->model, &a->error);
    if (a->holds)
        for (double step = 2; !status && better && step <= LONGEST; step *= 2)
            status = try_step(s, step, &better, err);
    else
        for (int parts = 2; !status && !a->holds && parts <= FINEST; parts *= 2)
            status = try_step(s, 1.0 / parts, &better, err);
    return status;
}

enum hobe_status advise_choose_step(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    struct sequence of = {0};
    const int n = s->problem->quantities, script = a->model;
    s->accuracy = s->problem->accuracy;
    enum hobe_status status = advise_open_sequence(&of, (size_t)n, err);
    if (!status)
        status = find_terms(s, a->trial + a->model, &of, err);
    if (!status && of.count > 1) {
        for (int i = 0; i < n; i++)
            a->best[i] += of.limit[i];
        advise_set_scale(s);
        a->open += advise_loss_of(s, of.open, NULL).size;
        status = try_steps(s, err);
        for (int i = 0; i < n; i++)
            s->x[i] = a->trial[script].value[i] + of.limit[i];
        if (!status)
            a->step = advise_loss_of(s, a->trial[a->model].value, s->x);
    }
    advise_close_sequence(&of);
    return status;
}
