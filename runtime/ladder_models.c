/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The models of a ladder: every combination of the values along its axes, group by group. */
#include "ladder.h"

#include "kernel.h"

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
    ladder->group = NULL;
    ladder->groups = 0;
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

/* The groups that the record says, or one. */
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

/* ---- models of any case --------------------------------------------------------------------- */

enum part { ELEMENT, ELEMENTS, INTEGRATION, MODEL, PARTS };
const char *const ladder_model_axis[] = {"element", "elements", "integration", "--model", NULL};

static enum part part_of(const char *name)
{
    int p = 0;
    while (p < PARTS && strcmp(ladder_model_axis[p], name))
        p++;
    return (enum part)p;
}

/* The ladder of a case that says none: all elements, on meshes from one of them on. */
static enum hobe_status make_usual(int quick, struct ladder *ladder, struct hobe_error *err)
{
    char mesh[][3] = {"1", "2", "4", "8", "16", "32"}, exact[] = "exact";
    enum { MESHES = sizeof mesh / sizeof *mesh };
    char *meshes[MESHES], *integration[] = {exact};
    const struct hobe_kernel *const *kernel = hobe_kernels();
    int kernels = 0;
    while (kernel[kernels])
        kernels++;
    char **name = hobe_alloc((size_t)kernels, sizeof *name, err);
    if (!name)
        return HOBE_NO_MEMORY;
    for (int i = 0; i < kernels; i++)
        name[i] = (char *)kernel[i]->name;
    for (int i = 0; i < MESHES; i++)
        meshes[i] = mesh[i];
    struct ladder_group *group = ladder->group;
    enum hobe_status status = set_axis(group, ladder_model_axis[ELEMENT], kernels, name, 1, err);
    if (!status)
        status = set_axis(group, ladder_model_axis[ELEMENTS], MESHES, meshes, quick ? 2 : 1, err);
    if (!status)
        status = set_axis(group, ladder_model_axis[INTEGRATION], 1, integration, 1, err);
    hobe_free(name);
    return status;
}

/* The elements that a value of an axis says, or 0. */
static double count_elements(enum part part, const char *value)
{
    const char *colon = strchr(value, ':');
    if (part == ELEMENTS)
        return ladder_number(value);
    return part == MODEL && colon ? strtod(colon + 1, NULL) : 0;
}

double ladder_most(const struct ladder *ladder)
{
    double most = 0;
    for (int g = 0; g < ladder->groups; g++)
        for (int a = 0; a < ladder->group[g].axes; a++) {
            const struct ladder_axis *axis = &ladder->group[g].axis[a];
            for (int i = 0; i < axis->values; i++)
                most = fmax(most, count_elements(part_of(axis->name), axis->value[i]));
        }
    return most;
}

static int has_axis(const struct ladder *ladder, const char *name)
{
    for (int g = 0; g < ladder->groups; g++)
        for (int a = 0; a < ladder->group[g].axes; a++)
            if (!strcmp(ladder->group[g].axis[a].name, name))
                return 1;
    return 0;
}

/* ---- rungs ---------------------------------------------------------------------------------- */

/* The value of axis a in the combination with this number, counted with the last axis fastest. */
static const char *choose(const struct ladder_group *group, long number, int a)
{
    for (int b = group->axes - 1; b > a; b--)
        number /= group->axis[b].values;
    return group->axis[a].value[number % group->axis[a].values];
}

/* The words of that combination; `usual`: parts of a model are one word. */
static void say_model(const struct ladder_group *group, long number, int usual,
                      struct hobe_text *words)
{
    const char *part[PARTS] = {NULL};
    for (int a = 0; a < group->axes; a++) {
        const char *name = group->axis[a].name, *value = choose(group, number, a);
        const enum part p = usual ? part_of(name) : PARTS;
        if (p < PARTS)
            part[p] = value;
        else
            hobe_text_add(words, "%s%s=%s", words->size > 0 ? " " : "", name, value);
    }
    if (!usual)
        return;
    hobe_text_add(words, "%s--model=%s:%s", words->size > 0 ? " " : "", part[ELEMENT],
                  part[ELEMENTS]);
    if (strcmp(part[INTEGRATION], "exact"))
        hobe_text_add(words, ":%s", part[INTEGRATION]);
}

/* What a model is drawn as, and how long that is. */
static const char *find_kind(const char *model, size_t *size)
{
    static const char *const before[] = {"--model=", "element=", "="};
    const char *found = NULL, *start = model;
    for (int i = 0; !found && i < 3; i++)
        if ((found = strstr(model, before[i])))
            start = found + strlen(before[i]);
    *size = strcspn(start, " :");
    return start;
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
    say_model(group, number, ladder->by_model && !has_axis(ladder, ladder_model_axis[MODEL]),
              &words);
    enum hobe_status status = hobe_text_check(&words, err);
    if (!status && !is_there(ladder, words.at)) {
        size_t size;
        struct ladder_rung *rung = &ladder->rung[ladder->rungs];
        rung->place = ladder->rungs++;
        const char *kind = find_kind(words.at, &size);
        const size_t q = (size_t)ladder->quantities;
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

/* An axis from the command line: of every group, or common to all. */
static enum hobe_status give_axis(const struct ladder_axis *axis, struct ladder *ladder,
                                  struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    if (axis->values == 1 && !has_axis(ladder, axis->name) && part_of(axis->name) != MODEL) {
        hobe_text_add(&ladder->common, " %s=%s", axis->name, axis->value[0]);
        return hobe_text_check(&ladder->common, err);
    }
    for (int g = 0; !status && g < ladder->groups; g++)
        status = set_axis(&ladder->group[g], axis->name, axis->values, axis->value, 1, err);
    return status;
}

/* Where models are words of --model, an axis of those takes the place of all groups, and other
 * parts are parameters; without one a case that says no group has the usual ladder. */
static enum hobe_status give_models(const struct ladder_options *options,
                                    const struct ladder_record *record, struct ladder *ladder,
                                    struct hobe_error *err)
{
    for (int i = 0; i < options->given; i++)
        if (part_of(options->axis[i].name) == MODEL) {
            ladder_free_groups(ladder);
            ladder->by_model = ladder->groups = 1;
            ladder->group = hobe_alloc(1, sizeof *ladder->group, err);
            return ladder->group ? HOBE_OK : HOBE_NO_MEMORY;
        }
    if (ladder_find(record, "group", 1, 0))
        return HOBE_OK;
    ladder->by_model = 1;
    return make_usual(options->quick, ladder, err);
}

enum hobe_status ladder_make_rungs(const struct ladder_options *options,
                                   const struct ladder_record *record, struct ladder *ladder,
                                   struct hobe_error *err)
{
    enum hobe_status status = read_groups(record, options->quick, ladder, err);
    if (!status)
        status = give_models(options, record, ladder, err);
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
                         "the ladder of the case is empty; a group of it has values of parameters, "
                         "{element = {\"MGD30w\"}, elements = {2, 4, 8}}");
    return status;
}
