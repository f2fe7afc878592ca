/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a choice of model: the model, and what it needs and does without. */
#include "advise.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *verdict(const struct advice *a, struct advise_loss loss, int has)
{
    if (!has)
        return "left out";
    return loss.size > a->problem->accuracy ? "needed" : "kept";
}

int advise_evidence(const struct advice *a, struct advise_effect *effect)
{
    static const char *const without[] = {
        [ADVISE_NO_SHEAR] = "shear", [ADVISE_NO_POISSON] = "Poisson's coupling"};
    const struct advise_problem *p = a->problem;
    const struct advise_model *model = &a->trial[a->model].model;
    int count = 0, has = 1;
    for (int w = ADVISE_COMPLETE + 1; w < ADVISE_WITHOUTS; w++)
        effect[count++] =
            (struct advise_effect){without[w], verdict(a, a->without[w], 1), a->without[w]};
    for (int l = 0; l < p->levels; l++) {
        if (l > 0)
            effect[count++] = (struct advise_effect){advise_step(p->level[l]),
                                                     verdict(a, a->level[l], has), a->level[l]};
        has = has && p->level[l] != model->kernel;
    }
    effect[count++] = (struct advise_effect){"large displacements",
                                             verdict(a, a->linear, !model->linear), a->linear};
    effect[count++] = (struct advise_effect){"a finer mesh", "left out", a->mesh};
    int known = 0;
    for (int i = 0; i < count; i++)
        if (!isnan(effect[i].loss.size))
            effect[known++] = effect[i];
    return known;
}

static void add_loss(const struct advice *a, struct advise_loss loss, struct hobe_text *text)
{
    if (loss.size > 0)
        hobe_text_add(text, "%.2g in %s", loss.size, a->problem->name[loss.quantity]);
    else
        hobe_text_add(text, "0");
}

void advise_say(const struct advice *a, struct hobe_text *text)
{
    const struct advise_model *model = &a->trial[a->model].model;
    hobe_text_add(text,
                  a->holds ? "accuracy %g is held by "
                           : "no model tried holds accuracy %g; nearest is ",
                  a->problem->accuracy);
    hobe_text_add(text, "%s, %d element%s%s: error about ", model->kernel->name, model->elements,
                  model->elements > 1 ? "s" : "", model->linear ? ", linear" : "");
    add_loss(a, a->error, text);
}

void advise_say_evidence(const struct advice *a, struct hobe_text *text)
{
    struct advise_effect effect[ADVISE_EFFECTS];
    const int count = advise_evidence(a, effect);
    for (int i = 0; i < count; i++) {
        hobe_text_add(text, "%s%s %s (", i > 0 ? ", " : "", effect[i].effect, effect[i].verdict);
        add_loss(a, effect[i].loss, text);
        hobe_text_add(text, ")");
    }
}

void advise_table(const struct advice *a, struct hobe_text *text)
{
    enum { EFFECT, VERDICT, LOSS, QUANTITY, COLUMNS };
    static const char *const head[COLUMNS] = {"effect", "", "loss without it", "in"};
    struct advise_effect effect[ADVISE_EFFECTS];
    struct hobe_cell cell[ADVISE_EFFECTS][COLUMNS] = {{{0}}};
    const int count = advise_evidence(a, effect);
    for (int i = 0; i < count; i++) {
        cell[i][EFFECT].text = effect[i].effect;
        cell[i][VERDICT].text = effect[i].verdict;
        cell[i][LOSS].number = effect[i].loss.size;
        cell[i][QUANTITY].text =
            effect[i].loss.size > 0 ? a->problem->name[effect[i].loss.quantity] : "";
    }
    hobe_table_text(text, &(struct hobe_table){NULL, COLUMNS, (size_t)count, head, cell[0]});
}
