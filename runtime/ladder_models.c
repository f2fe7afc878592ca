/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The models of a ladder: every combination of the values along its axes, group by group. */
#include "ladder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

char *ladder_copy(const char *text, struct hobe_error *err)
{
    char *copy = hobe_alloc(strlen(text) + 1, 1, err);
    return copy ? strcpy(copy, text) : NULL;
}

static void free_axis(struct ladder_axis *axis)
{
    for (int i = 0; axis->value && i < axis->values; i++)
        hobe_free(axis->value[i]);
    hobe_free(axis->value);
    hobe_free(axis->name);
}

void ladder_free_groups(struct ladder *ladder)
{
    for (int g = 0; g < ladder->groups; g++) {
        for (int a = 0; a < ladder->group[g].axes; a++)
            free_axis(&ladder->group[g].axis[a]);
        hobe_free(ladder->group[g].axis);
    }
    hobe_free(ladder->group);
}

/* ---- axes ----------------------------------------------------------------------------------- */

/* Whether a quick ladder steps over every other value, as far as the last one goes. */
static int is_long(int values, char *const *value)
{
    int numbers = 1;
    for (int i = 0; i < values; i++)
        numbers = numbers && !isnan(ladder_number(value[i]));
    return numbers && values > 2;
}

/* Adds an axis, or puts it in the place of one of that name; every `stride`-th value, the last
 * among them. */
static enum hobe_status set_axis(struct ladder_group *group, const char *name, int values,
                                 char *const *value, int stride, struct hobe_error *err)
{
    int a = 0;
    while (a < group->axes && strcmp(group->axis[a].name, name))
        a++;
    if (a == group->axes) {
        struct ladder_axis *more =
            hobe_grow(group->axis, (size_t)a, (size_t)a + 1, sizeof *more, err);
        if (!more)
            return HOBE_NO_MEMORY;
        group->axis = more;
        group->axes++;
    } else
        free_axis(&group->axis[a]);
    struct ladder_axis *axis = &group->axis[a];
    *axis = (struct ladder_axis){ladder_copy(name, err), 0,
                                 hobe_alloc((size_t)values, sizeof *axis->value, err)};
    if (!axis->name || !axis->value)
        return HOBE_NO_MEMORY;
    for (int i = (values - 1) % stride; i < values; i += stride)
        if (!(axis->value[axis->values++] = ladder_copy(value[i], err)))
            return HOBE_NO_MEMORY;
    return HOBE_OK;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct ladder_axis *)a)->name, ((const struct ladder_axis *)b)->name);
}

/* The groups that the record says, at least one. */
static enum hobe_status read_groups(const struct ladder_record *record, int quick,
                                    struct ladder *ladder, struct hobe_error *err)
{
    int most = 1;
    while (ladder_find(record, "group", 1, most - 1))
        most++;
    ladder->group = hobe_alloc((size_t)most, sizeof *ladder->group, err);
    if (!ladder->group)
        return HOBE_NO_MEMORY;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < record->lines; i++) {
        const struct ladder_line *line = &record->line[i];
        ladder->groups += !strcmp(line->word[0], "group");
        if (ladder->groups > 0 && !strcmp(line->word[0], "axis") && line->words > 2)
            status = set_axis(&ladder->group[ladder->groups - 1], line->word[1], line->words - 2,
                              line->word + 2,
                              quick && is_long(line->words - 2, line->word + 2) ? 2 : 1, err);
    }
    ladder->groups = ladder->groups > 0 ? ladder->groups : 1;
    return status;
}

double ladder_most(const struct ladder *ladder, const char *name)
{
    double most = 0;
    for (int g = 0; g < ladder->groups; g++)
        for (int a = 0; a < ladder->group[g].axes; a++) {
            const struct ladder_axis *axis = &ladder->group[g].axis[a];
            for (int i = 0; !strcmp(axis->name, name) && i < axis->values; i++)
                most = fmax(most, ladder_number(axis->value[i]));
        }
    return most;
}

/* ---- rungs ---------------------------------------------------------------------------------- */

/* The words of the combination with this number, counted with the last axis fastest. */
static void say_model(const struct ladder_group *group, long number, struct hobe_text *words)
{
    long below = 1;
    for (int a = 1; a < group->axes; a++)
        below *= group->axis[a].values;
    for (int a = 0; a < group->axes; a++) {
        const struct ladder_axis *axis = &group->axis[a];
        hobe_text_add(words, "%s%s=%s", a > 0 ? " " : "", axis->name,
                      axis->value[number / below % axis->values]);
        below /= a + 1 < group->axes ? group->axis[a + 1].values : 1;
    }
}

static int is_there(const struct ladder *ladder, const char *model)
{
    for (int i = 0; i < ladder->rungs; i++)
        if (!strcmp(ladder->rung[i].model, model))
            return 1;
    return 0;
}

static enum hobe_status add_rung(const struct ladder_group *group, long number,
                                 struct ladder *ladder, struct hobe_error *err)
{
    struct hobe_text words = {0};
    say_model(group, number, &words);
    enum hobe_status status = hobe_text_check(&words, err);
    if (!status && !is_there(ladder, words.at)) {
        static const char element[] = "element=";
        struct ladder_rung *rung = &ladder->rung[ladder->rungs];
        rung->place = ladder->rungs++;
        const char *found = strstr(words.at, element);
        const char *kind = found ? found + strlen(element) : strchr(words.at, '=') + 1;
        const size_t q = (size_t)ladder->quantities, size = strcspn(kind, " ");
        rung->model = ladder_copy(words.at, err);
        rung->kind = hobe_alloc(size + 1, 1, err);
        rung->value = hobe_alloc(q, sizeof *rung->value, err);
        rung->error = hobe_alloc(q, sizeof *rung->error, err);
        if (!rung->model || !rung->kind || !rung->value || !rung->error)
            status = HOBE_NO_MEMORY;
        else
            memcpy(rung->kind, kind, size);
    }
    hobe_text_free(&words);
    return status;
}

static enum hobe_status add_rungs(const struct ladder_group *group, struct ladder *ladder,
                                  struct hobe_error *err)
{
    long models = group->axes > 0;
    for (int a = 0; a < group->axes; a++)
        if ((models *= group->axis[a].values) > LADDER_MOST_RUNGS)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL, "the ladder has more than %d models",
                             LADDER_MOST_RUNGS);
    struct ladder_rung *more = hobe_grow(ladder->rung, (size_t)ladder->rungs,
                                         (size_t)(ladder->rungs + models), sizeof *more, err);
    if (!more)
        return HOBE_NO_MEMORY;
    ladder->rung = more;
    enum hobe_status status = HOBE_OK;
    for (long number = 0; !status && number < models; number++)
        status = add_rung(group, number, ladder, err);
    return status;
}

static int has_axis(const struct ladder *ladder, const char *name)
{
    for (int g = 0; g < ladder->groups; g++)
        for (int a = 0; a < ladder->group[g].axes; a++)
            if (!strcmp(ladder->group[g].axis[a].name, name))
                return 1;
    return 0;
}

/* An axis from the command line: of every group, or common to all. */
static enum hobe_status give_axis(const struct ladder_axis *axis, struct ladder *ladder,
                                  struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    if (axis->values == 1 && !has_axis(ladder, axis->name)) {
        hobe_text_add(&ladder->common, " %s=%s", axis->name, axis->value[0]);
        return hobe_text_check(&ladder->common, err);
    }
    for (int g = 0; !status && g < ladder->groups; g++)
        status = set_axis(&ladder->group[g], axis->name, axis->values, axis->value, 1, err);
    return status;
}

enum hobe_status ladder_make_rungs(const struct ladder_options *options,
                                   const struct ladder_record *record, struct ladder *ladder,
                                   struct hobe_error *err)
{
    enum hobe_status status = read_groups(record, options->quick, ladder, err);
    for (int i = 0; !status && i < options->given; i++)
        status = give_axis(&options->axis[i], ladder, err);
    for (int g = 0; !status && g < ladder->groups; g++) {
        struct ladder_group *group = &ladder->group[g];
        if (group->axes > 0)
            qsort(group->axis, (size_t)group->axes, sizeof *group->axis, by_name);
        status = add_rungs(group, ladder, err);
    }
    if (!status && ladder->rungs == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the case has no ladder: it needs hobe.chart{ladder = ...}, a parameter "
                         "element or elements, or values given as elements=2,4,8");
    return status;
}
