/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The choice: models in the order of their cost, as far as the estimate gives hope, until one
 * holds. */
#include "advise_search.h"

#include <math.h>

static const double CHEAPEST = 1.0 / 16,
                    CHEAPER = 0.5; /* costs at which other elements are tried */
static const double HOPE = 1.3;    /* times the accuracy that a prediction may miss to be tried */

static const int MESH[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};
enum { MESHES = sizeof MESH / sizeof *MESH };

int advise_holds(const struct search *s, const struct advise_trial *trial,
                 struct advise_loss *error)
{
    *error = advise_loss_of(s, trial->value, s->advice->best);
    error->size += s->advice->open;
    return error->size <= s->accuracy;
}

void advise_take(struct search *s, const struct advise_trial *trial, int held,
                 struct advise_loss error)
{
    s->advice->model = (int)(trial - s->advice->trial);
    s->advice->holds = held;
    s->advice->error = error;
}

/* The iterations that a level takes, by its finest mesh so far. */
static int usual_iterations(const struct search *s, const struct level *level)
{
    const struct sequence *own = &level->of[OWN];
    const struct advise_model model = plain(level->kernel, own->mesh[own->count - 1]);
    return (int)lround(advise_find_trial(s, &model)->cost / advise_cost(&model, 1));
}

enum hobe_status advise_choose(struct search *s, struct hobe_error *err)
{
    double done = 0;
    s->advice->model = -1;
    s->advice->holds = 0;
    for (;;) {
        struct advise_model next = {0};
        double cheapest = INFINITY;
        int level = 0;
        for (int l = 0; l < s->levels; l++)
            for (int k = 0; k < MESHES && MESH[k] <= s->problem->most; k++) {
                const struct advise_model model = plain(s->level[l].kernel, MESH[k]);
                const double cost = advise_cost(&model, usual_iterations(s, s->level + l));
                if (cost <= done || cost >= cheapest)
                    continue;
                next = model;
                cheapest = cost;
                level = l;
            }
        if (!next.kernel)
            return HOBE_OK;
        done = cheapest;
        const struct advise_trial *trial = advise_find_trial(s, &next);
        advise_predict(s, level, next.elements, s->x);
        if (!trial && advise_loss_of(s, s->x, s->advice->best).size > HOPE * s->accuracy)
            continue;
        const enum hobe_status status = advise_try_model(s, &next, &trial, err);
        if (status)
            return status;
        struct advise_loss error;
        const int held = trial && advise_holds(s, trial, &error);
        if (trial && (held || s->advice->model < 0 || error.size < s->advice->error.size))
            advise_take(s, trial, held, error);
        if (held)
            return HOBE_OK;
    }
}

int advise_hangs(const struct search *s)
{
    const struct advice *a = s->advice;
    if (a->model < 0)
        return 0;
    for (int i = 0; i < a->trials; i++) {
        const struct advise_trial *trial = a->trial + i;
        if (trial->failed || trial->model.linear || trial->model.without)
            continue;
        if (a->holds && trial->cost > 0.5 * a->trial[a->model].cost)
            continue;
        if (advise_loss_of(s, trial->value, a->best).size - a->open < s->accuracy && i != a->model)
            return 1;
    }
    return 0;
}

enum hobe_status advise_try_element(struct search *s, const struct hobe_kernel *kernel, int linear,
                                    struct hobe_error *err)
{
    const struct advise_trial taken = s->advice->trial[s->advice->model];
    const int iterations = linear ? 1 : (int)lround(taken.cost / advise_cost(&taken.model, 1));
    for (int k = 0; k < MESHES && MESH[k] <= s->problem->most; k++) {
        const struct advise_model model = {.kernel = kernel, .elements = MESH[k], .linear = linear};
        const double cost = advise_cost(&model, iterations) / taken.cost;
        const struct advise_trial *trial;
        struct advise_loss error;
        if (cost < CHEAPEST || cost > CHEAPER)
            continue;
        const enum hobe_status status = advise_try_model(s, &model, &trial, err);
        if (status)
            return status;
        if (trial && advise_holds(s, trial, &error)) {
            advise_take(s, trial, 1, error);
            return HOBE_OK;
        }
    }
    return HOBE_OK;
}

enum hobe_status advise_try_twins(struct search *s, struct hobe_error *err)
{
    const struct hobe_kernel *taken = s->advice->trial[s->advice->model].model.kernel;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && hobe_kernels()[i]; i++)
        if (hobe_kernels()[i] != taken && advise_same_section(hobe_kernels()[i], taken))
            status = advise_try_element(s, hobe_kernels()[i], 0, err);
    return status;
}
