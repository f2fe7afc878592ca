/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a choice of model: the model, and what it needs and does without. */
#define _GNU_SOURCE
#include "advise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- models as words ------------------------------------------------------------------------- */

static const char LINEAR[] = "linear", PAPER[] = "paper";
static const char *const WITHOUT[] = {
    [ADVISE_NO_SHEAR] = "no-shear", [ADVISE_NO_POISSON] = "no-poisson"};

void advise_model_word(const struct advise_model *model, char *text)
{
    snprintf(text, ADVISE_WORD, "%s:%d%s%s%s%s%s%s", model->kernel->name, model->elements,
             model->linear ? ":" : "", model->linear ? LINEAR : "", model->paper ? ":" : "",
             model->paper ? PAPER : "", model->without ? ":" : "",
             model->without ? WITHOUT[model->without] : "");
}

/* What stands behind the number of elements; 0 where it is nothing known. */
static int read_manner(const char *word, struct advise_model *model)
{
    if (!strcmp(word, LINEAR))
        return model->linear = 1;
    if (!strcmp(word, PAPER))
        return model->paper = 1;
    for (int w = ADVISE_COMPLETE + 1; w < ADVISE_WITHOUTS; w++)
        if (!strcmp(word, WITHOUT[w])) {
            model->without = (enum advise_without)w;
            return 1;
        }
    return 0;
}

enum hobe_status advise_read_model(const char *text, struct advise_model *model,
                                   struct hobe_error *err)
{
    static const int most = 1000000;
    char copy[ADVISE_WORD], *save, *end = copy;
    snprintf(copy, sizeof copy, "%s", text);
    *model = (struct advise_model){0};
    const char *name = strtok_r(copy, ":", &save), *number = strtok_r(NULL, ":", &save);
    model->kernel = hobe_find_kernel(name ? name : "", err);
    if (!model->kernel)
        return err ? err->status : HOBE_UNKNOWN;
    const long elements = number ? strtol(number, &end, 10) : 0;
    int good = elements >= 1 && elements <= most && *end == '\0';
    model->elements = (int)elements;
    for (const char *word; good && (word = strtok_r(NULL, ":", &save));)
        good = read_manner(word, model);
    if (good)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "a model is ELEMENT:ELEMENTS, from 1 to %d, and perhaps :linear, :paper, "
                     ":no-shear or :no-poisson, such as MGD30w:8, got \"%.100s\"",
                     most, text);
}

/* ---- evidence -------------------------------------------------------------------------------- */

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
        has = has && !advise_same_section(p->level[l], model->kernel);
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
