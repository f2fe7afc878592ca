/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a choice of model: the model, and what it needs and does without. */
#define _GNU_SOURCE
#include "advise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- models as words ------------------------------------------------------------------------- */

static const char LINEAR[] = "linear", PAPER[] = "paper", TIMES[] = "step=";
static const char *const WITHOUT[] = {[ADVISE_NO_SHEAR] = "no-shear",
                                      [ADVISE_NO_POISSON] = "no-poisson",
                                      [ADVISE_NO_INERTIA] = "quasi-static"};

void advise_model_word(const struct advise_model *model, char *text)
{
    char step[40] = "";
    if (model->step > 0)
        snprintf(step, sizeof step, ":%s%.17g", TIMES, model->step);
    snprintf(text, ADVISE_WORD, "%s:%d%s%s%s%s%s%s%s", model->kernel->name, model->elements,
             model->linear ? ":" : "", model->linear ? LINEAR : "", model->paper ? ":" : "",
             model->paper ? PAPER : "", step, model->without ? ":" : "",
             model->without ? WITHOUT[model->without] : "");
}

/* What stands behind the number of elements; 0 where it is nothing known. */
static int read_manner(const char *word, struct advise_model *model)
{
    if (!strcmp(word, LINEAR))
        return model->linear = 1;
    if (!strcmp(word, PAPER))
        return model->paper = 1;
    if (!strncmp(word, TIMES, strlen(TIMES))) {
        char *end;
        model->step = strtod(word + strlen(TIMES), &end);
        return *end == '\0' && isfinite(model->step) && model->step > 0;
    }
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
    return hobe_fail(
        err, HOBE_BAD_INPUT, NULL,
        "a model is ELEMENT:ELEMENTS, from 1 to %d, and perhaps :linear, :paper, "
        ":step=FACTOR, :no-shear, :no-poisson or :quasi-static, such as MGD30w:8, got \"%.100s\"",
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
    static const char *const without[] = {[ADVISE_NO_SHEAR] = "shear",
                                          [ADVISE_NO_POISSON] = "Poisson's coupling",
                                          [ADVISE_NO_INERTIA] = "dynamics"};
    const struct advise_problem *p = a->problem;
    const struct advise_model *model = &a->trial[a->model].model;
    int count = 0, has = 1;
    for (int w = ADVISE_COMPLETE + 1; w < ADVISE_WITHOUTS; w++)
        effect[count++] = (struct advise_effect){
            without[w], verdict(a, a->without[w], (int)model->without != w), a->without[w]};
    for (int l = 0; l < p->levels; l++) {
        if (l > 0)
            effect[count++] = (struct advise_effect){advise_step(p->level[l]),
                                                     verdict(a, a->level[l], has), a->level[l]};
        has = has && !advise_same_section(p->level[l], model->kernel);
    }
    effect[count++] = (struct advise_effect){"large displacements",
                                             verdict(a, a->linear, !model->linear), a->linear};
    effect[count++] = (struct advise_effect){"a finer mesh", "left out", a->mesh};
    effect[count++] = (struct advise_effect){"a shorter step", "left out", a->step};
    int known = 0;
    for (int i = 0; i < count; i++)
        if (!isnan(effect[i].loss.size))
            effect[known++] = effect[i];
    return known;
}

static void add_loss(const struct advice *a, struct advise_loss loss, struct hobe_text *text)
{
    if (isinf(loss.size))
        hobe_text_add(text, "all");
    else if (loss.size > 0)
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
    hobe_text_add(text, "%s, %d element%s%s", model->kernel->name, model->elements,
                  model->elements > 1 ? "s" : "", model->linear ? ", linear" : "");
    if (model->step > 0)
        hobe_text_add(text, ", %g times the step", model->step);
    if (model->without == ADVISE_NO_INERTIA)
        hobe_text_add(text, ", quasi-static");
    hobe_text_add(text, ": error about ");
    add_loss(a, a->error, text);
    if (a->problem->moves && isnan(a->step.size) && model->without != ADVISE_NO_INERTIA)
        hobe_text_add(text, ", that of the step in time, which cannot be changed, left out");
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

/* ---- tables ---------------------------------------------------------------------------------- */

/* A table that owns its cells. */
struct sheet {
    struct hobe_table table;
    struct hobe_cell *cell; /* NULL: no memory */
};

static struct sheet new_sheet(const char *title, size_t rows, size_t columns,
                              const char *const *head)
{
    struct sheet sheet = {{title, columns, rows, head, NULL}, NULL};
    sheet.table.cell = sheet.cell = hobe_alloc(rows * columns, sizeof *sheet.cell, NULL);
    for (size_t i = 0; sheet.cell && i < rows * columns; i++)
        sheet.cell[i].text = "";
    return sheet;
}

/* A number, or an empty cell where it is none. */
static struct hobe_cell number(double x)
{
    return (struct hobe_cell){isfinite(x) ? NULL : "", x};
}

/* A loss, and the quantity that it is in. */
static void fill_loss(const struct advice *a, struct advise_loss loss, struct hobe_cell *cell)
{
    cell[0] = number(loss.size);
    cell[1].text = loss.size > 0 && isfinite(loss.size) ? a->problem->name[loss.quantity] : "";
}

/* The values of the model taken beside the estimate. */
static struct sheet values_of(const struct advice *a)
{
    enum { NAME, VALUE, UNIT, BEST, COLUMNS };
    static const char *const head[COLUMNS] = {"value", "this model", "unit",
                                              "estimate of the finest"};
    const struct advise_problem *p = a->problem;
    const struct sheet sheet = new_sheet("values", (size_t)p->quantities, COLUMNS, head);
    struct hobe_cell *row = sheet.cell;
    for (int i = 0; sheet.cell && i < p->quantities; i++, row += COLUMNS) {
        row[NAME].text = p->name[i];
        row[VALUE] = number(a->trial[a->model].value[i]);
        row[UNIT].text = p->unit[i] ? p->unit[i] : "";
        row[BEST] = number(a->best[i]);
    }
    return sheet;
}

static struct sheet evidence_of(const struct advice *a)
{
    enum { EFFECT, VERDICT, LOSS, QUANTITY, COLUMNS };
    static const char *const head[COLUMNS] = {"effect", "verdict", "loss without it", "in"};
    struct advise_effect effect[ADVISE_EFFECTS];
    const int count = advise_evidence(a, effect);
    const struct sheet sheet = new_sheet("evidence", (size_t)count, COLUMNS, head);
    struct hobe_cell *row = sheet.cell;
    for (int i = 0; sheet.cell && i < count; i++, row += COLUMNS) {
        row[EFFECT].text = effect[i].effect;
        row[VERDICT].text = effect[i].verdict;
        fill_loss(a, effect[i].loss, row + LOSS);
    }
    return sheet;
}

/* All that were run, in their order; their words are kept in word[trials][ADVISE_WORD]. */
static struct sheet trials_of(const struct advice *a, char (*word)[ADVISE_WORD])
{
    enum { MODEL, COST, ERROR, QUANTITY, WHY, COLUMNS };
    static const char *const head[COLUMNS] = {"model", "operations", "error", "in", "failed"};
    const struct sheet sheet = new_sheet("trials", (size_t)a->trials, COLUMNS, head);
    struct hobe_cell *row = sheet.cell;
    for (int i = 0; sheet.cell && word && i < a->trials; i++, row += COLUMNS) {
        const struct advise_trial *trial = a->trial + i;
        advise_model_word(&trial->model, word[i]);
        row[MODEL].text = word[i];
        row[COST] = number(trial->cost);
        if (trial->failed)
            row[WHY].text = trial->why;
        else
            fill_loss(a, trial->error, row + ERROR);
    }
    return sheet;
}

/* The choice, a row. */
static struct sheet choice_of(const struct advice *a, const char *command, const char *word)
{
    enum { MODEL, HOLDS, ACCURACY, ERROR, QUANTITY, OPEN, COST, ALL, COMMAND, COLUMNS };
    static const char *const head[COLUMNS] = {"model",  "holds", "accuracy",   "error",
                                              "in",     "open",  "operations", "all operations",
                                              "command"};
    const struct sheet sheet = new_sheet("choice", 1, COLUMNS, head);
    struct hobe_cell *row = sheet.cell;
    if (!row)
        return sheet;
    row[MODEL].text = word;
    row[HOLDS].text = a->holds ? "yes" : "no";
    row[ACCURACY] = number(a->problem->accuracy);
    fill_loss(a, a->error, row + ERROR);
    row[OPEN] = number(a->open);
    row[COST] = number(a->trial[a->model].cost);
    row[ALL] = number(a->cost);
    row[COMMAND].text = command;
    return sheet;
}

/* Appends a table, and frees its cells. */
static void say_sheet(struct sheet sheet, struct hobe_text *text)
{
    sheet.table.title = NULL;
    if (sheet.cell)
        hobe_table_text(text, &sheet.table);
    else
        text->status = HOBE_NO_MEMORY;
    hobe_free(sheet.cell);
}

void advise_table(const struct advice *a, struct hobe_text *text)
{
    say_sheet(values_of(a), text);
    hobe_text_add(text, "\n");
    say_sheet(evidence_of(a), text);
}

void advise_json(const struct advice *a, const char *command, struct hobe_text *text)
{
    enum { SHEETS = 4 };
    char(*word)[ADVISE_WORD] = hobe_alloc((size_t)a->trials, sizeof *word, NULL);
    const struct sheet sheet[SHEETS] = {choice_of(a, command, word ? word[a->model] : ""),
                                        values_of(a), evidence_of(a), trials_of(a, word)};
    struct hobe_table table[SHEETS];
    int good = word != NULL;
    for (int i = 0; i < SHEETS; i++) {
        table[i] = sheet[i].table;
        good = good && sheet[i].cell;
    }
    if (good)
        hobe_tables_json(text, table, SHEETS);
    else
        text->status = HOBE_NO_MEMORY;
    for (int i = 0; i < SHEETS; i++)
        hobe_free(sheet[i].cell);
    hobe_free(word);
}
