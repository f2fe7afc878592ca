/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include "assemble.h"
#include "constraint.h"
#include "load.h"
#include "newton.h"
#include "numbering.h"
#include "pattern.h"
#include "reduction.h"
#include "solution.h"
#include "spring.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* Each part keeps lists as long as the scene's, which more of them would make many: the last takes
 * all that are left. */
enum { MOST_PARTS = 16 };

/* ---- which there are ------------------------------------------------------------------------- */

static size_t number_of(const hobe_model *model, const struct beam *beam)
{
    return (size_t)(beam - model_beam(model, 0));
}

/* Beams that a joint or spring has at its two places are of one group; the ground is none. */
static void join_tied(const hobe_model *model, const struct tie *tie, size_t *group)
{
    const struct beam *a = tie->side[0].place.beam, *b = tie->side[1].place.beam;
    if (a && b)
        group[group_of(group, number_of(model, a))] = group_of(group, number_of(model, b));
}

static int is_held(const hobe_model *model, const struct beam *beam)
{
    for (int e = 0; e < beam->spec.elements; e++)
        for (int v = 0; v < beam->kernel->vectors; v++)
            if (model->unknown[model_vector(model, beam, e, v)] >= 0)
                return 0;
    return 1;
}

/* Numbers the groups in the order of their first beams; number[root] = -1: none yet. */
static void number_parts(const hobe_model *model, const size_t *group, int *number,
                         struct parts *parts)
{
    for (size_t i = 0; i < model->beams.count; i++)
        number[i] = -1;
    for (size_t i = 0; i < model->beams.count; i++) {
        int *of_root = number + group_of(group, i);
        parts->of_beam[i] = -1;
        if (is_held(model, model_beam(model, i)))
            continue;
        if (*of_root < 0)
            *of_root = parts->count < MOST_PARTS ? parts->count++ : MOST_PARTS - 1;
        parts->of_beam[i] = *of_root;
    }
}

/* A spin acts on all beams by one matrix, and a body knows its own tie by its number: scenes with
 * either stay one problem. */
static enum hobe_status find(hobe_model *model, struct parts *parts, struct hobe_error *err)
{
    const size_t beams = model->beams.count;
    if (model->bodies.count > 0 || model->spun) {
        parts->count = 1;
        return HOBE_OK;
    }
    size_t *group = hobe_alloc(beams, sizeof *group, err);
    int *number = hobe_alloc(beams, sizeof *number, err);
    parts->of_beam = hobe_alloc(beams, sizeof *parts->of_beam, err);
    const enum hobe_status status = group && number && parts->of_beam ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status) {
        group_parts(model, group);
        for (size_t i = 0; i < model->ties.count; i++)
            join_tied(model, model_tie(model, i), group);
        for (size_t i = 0; i < model->springs.count; i++)
            join_tied(model, &model_spring(model, i)->tie, group);
        number_parts(model, group, number, parts);
    }
    hobe_free(group);
    hobe_free(number);
    return status;
}

enum hobe_status parts_find(hobe_model *model, struct hobe_error *err)
{
    struct parts *parts = hobe_alloc(1, sizeof *parts, err);
    char text[200];
    model->parts = parts;
    if (!parts || find(model, parts, err))
        return HOBE_NO_MEMORY;
    if (parts->count < 2)
        return HOBE_OK;
    snprintf(
        text, sizeof text,
        "statics solve %d parts of the scene, which nothing couples, each as a scene of its own: "
        "that is exact",
        parts->count);
    return model_add_note(model, text, err);
}

/* ---- a model of one -------------------------------------------------------------------------- */

/* list = copies of the items of another that belong to a part. */
static enum hobe_status keep_items(const hobe_model *model, int part, const struct list *from,
                                   size_t size, int (*keep)(const hobe_model *, int, const void *),
                                   struct list *list, struct hobe_error *err)
{
    for (size_t i = 0; i < from->count; i++) {
        const char *item = (const char *)from->item + i * size;
        if (!keep(model, part, item))
            continue;
        void *copy = list_append(list, size, err);
        if (!copy)
            return HOBE_NO_MEMORY;
        memcpy(copy, item, size);
    }
    return HOBE_OK;
}

static int holds_beam(const hobe_model *model, int part, const void *beam)
{
    return model->parts->of_beam[number_of(model, beam)] == part;
}

static int holds_tie(const hobe_model *model, int part, const void *item)
{
    const struct tie *tie = item;
    for (int s = 0; s < 2; s++)
        if (tie->side[s].place.beam && holds_beam(model, part, tie->side[s].place.beam))
            return 1;
    return 0;
}

static int holds_spring(const hobe_model *model, int part, const void *item)
{
    return holds_tie(model, part, &((const struct spring *)item)->tie);
}

static int holds_force(const hobe_model *model, int part, const void *item)
{
    return holds_beam(model, part, ((const struct force *)item)->on.place.beam);
}

static int holds_moment(const hobe_model *model, int part, const void *item)
{
    return holds_beam(model, part, ((const struct moment *)item)->on.place.beam);
}

/* The lists of a part: beams with what acts on them, and what ties them to each other. */
static const struct {
    size_t list, size;
    int (*keep)(const hobe_model *, int, const void *);
} KEPT[] = {
    {offsetof(struct hobe_model, beams), sizeof(struct beam), holds_beam},
    {offsetof(struct hobe_model, ties), sizeof(struct tie), holds_tie},
    {offsetof(struct hobe_model, springs), sizeof(struct spring), holds_spring},
    {offsetof(struct hobe_model, forces), sizeof(struct force), holds_force},
    {offsetof(struct hobe_model, moments), sizeof(struct moment), holds_moment},
};
enum { KINDS = sizeof KEPT / sizeof *KEPT };

static struct list *list_of(const hobe_model *model, int kind)
{
    return (struct list *)((char *)model + KEPT[kind].list);
}

typedef void with_places(long *place[LAYOUTS]);

/* Where blocks lie is all that copies of beams, ties and springs have of their own. */
static void each_places(hobe_model *part, with_places *with)
{
    for (size_t i = 0; i < part->beams.count; i++)
        with(model_beam(part, i)->place);
    for (size_t i = 0; i < part->ties.count; i++)
        with(model_tie(part, i)->place);
    for (size_t i = 0; i < part->springs.count; i++)
        with(model_spring(part, i)->tie.place);
}

static void forget_places(long *place[LAYOUTS])
{
    memset(place, 0, LAYOUTS * sizeof *place);
}

static void free_places(long *place[LAYOUTS])
{
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(place[layout]);
}

static void free_part(hobe_model *part)
{
    if (!part)
        return;
    each_places(part, free_places);
    for (int kind = 0; kind < KINDS; kind++)
        hobe_free(list_of(part, kind)->item);
    model_free_system(part);
    hobe_free(part);
}

/* All vectors are held but those of the part's beams and ties that were free before. */
static enum hobe_status hold_others(const hobe_model *model, hobe_model *part,
                                    struct hobe_error *err)
{
    const size_t n = (size_t)model->vectors;
    part->held = hobe_alloc(n, sizeof *part->held, err);
    part->unknown = hobe_alloc(n, sizeof *part->unknown, err);
    if (!part->held || !part->unknown)
        return HOBE_NO_MEMORY;
    memset(part->held, 1, n);
    for (size_t i = 0; i < part->beams.count; i++) {
        const struct beam *beam = model_beam(part, i);
        for (int e = 0; e < beam->spec.elements; e++)
            for (int v = 0; v < beam->kernel->vectors; v++) {
                const long at = model_vector(model, beam, e, v);
                part->held[at] = model->held[at];
            }
    }
    for (size_t i = 0; i < part->ties.count; i++) {
        const struct tie *tie = model_tie(part, i);
        for (int b = 0; b < tie->blocks; b++)
            part->held[tie->multiplier + b] = model->held[tie->multiplier + b];
    }
    number_unknowns(part);
    return HOBE_OK;
}

static enum hobe_status build(const hobe_model *model, int p, hobe_model *part,
                              struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int kind = 0; !status && kind < KINDS; kind++)
        status = keep_items(model, p, list_of(model, kind), KEPT[kind].size, KEPT[kind].keep,
                            list_of(part, kind), err);
    each_places(part, forget_places);
    if (!status)
        status = hold_others(model, part, err);
    if (!status)
        status = pattern_build(part, err);
    if (!status)
        status = load_find(part, err);
    return status ? status : assemble_schedule(part, err);
}

/* The model of part p, which shares with that of the scene what it does not change. */
static hobe_model *open_part(const hobe_model *model, int p, struct hobe_error *err)
{
    hobe_model *part = hobe_alloc(1, sizeof *part, err);
    if (!part)
        return NULL;
    *part = *model;
    model_forget_system(part);
    for (int kind = 0; kind < KINDS; kind++)
        *list_of(part, kind) = (struct list){0};
    if (!build(model, p, part, err))
        return part;
    free_part(part);
    return NULL;
}

static enum hobe_status open_all(hobe_model *model, struct hobe_error *err)
{
    struct parts *parts = model->parts;
    if (!parts->part)
        parts->part = hobe_alloc((size_t)parts->count, sizeof *parts->part, err);
    for (int p = 0; parts->part && p < parts->count; p++)
        if (!parts->part[p] && !(parts->part[p] = open_part(model, p, err)))
            return HOBE_NO_MEMORY;
    return parts->part ? HOBE_OK : HOBE_NO_MEMORY;
}

void parts_free(struct parts *parts)
{
    if (!parts)
        return;
    for (int p = 0; parts->part && p < parts->count; p++)
        free_part(parts->part[p]);
    hobe_free(parts->part);
    hobe_free(parts->of_beam);
    hobe_free(parts);
}

/* ---- statics --------------------------------------------------------------------------------- */

static void larger(double *a, double b)
{
    if (b > *a || isnan(b))
        *a = b;
}

/* The negative eigenvalues of both; of a part without a load, whose tangent has not been factored,
 * there are none. */
static int add_negative(const struct hobe_solution_info *all, const struct hobe_solution_info *one)
{
    if (all->factorisations == 0 || one->factorisations == 0)
        return all->factorisations == 0 ? one->negative : all->negative;
    return all->negative < 0 || one->negative < 0 ? -1 : all->negative + one->negative;
}

static void add_info(struct hobe_solution_info *all, const struct hobe_solution_info *one)
{
    all->negative = add_negative(all, one);
    all->steps = one->steps > all->steps ? one->steps : all->steps;
    all->iterations = one->iterations > all->iterations ? one->iterations : all->iterations;
    all->cutbacks = one->cutbacks > all->cutbacks ? one->cutbacks : all->cutbacks;
    all->factorisations += one->factorisations;
    all->energy += one->energy;
    if (one->limit_load > 0 && !(all->limit_load > 0 && all->limit_load < one->limit_load))
        all->limit_load = one->limit_load;
    larger(&all->residual, one->residual);
    larger(&all->change, one->change);
    all->smallest_volume = fmin(all->smallest_volume, one->smallest_volume);
}

/* What went wrong, and where. */
static enum hobe_status name_part(const hobe_model *part, enum hobe_status status,
                                  struct hobe_error *err)
{
    const struct beam *beam = model_beam(part, 0);
    struct hobe_error was;
    if (status != HOBE_NOT_CONVERGED || !err)
        return status;
    was = *err;
    return hobe_fail(err, status, was.where ? was.where : beam->spec.where,
                     "beam \"%.100s\"%s, which nothing couples to the rest of the scene: %.800s",
                     beam->name, part->beams.count > 1 ? " and what it is joined to" : "",
                     was.message);
}

/* Equilibrium of a part, whose displacements are put among u[vectors][3]. */
static enum hobe_status solve(hobe_model *part, const struct hobe_newton *options, double *u,
                              struct hobe_solution_info *info, struct hobe_error *err)
{
    struct hobe_newton own = *options;
    hobe_solution *start = NULL, *found = NULL;
    if (options->start) {
        start = solution_new(part, options->start->u, NULL, NULL, &options->start->info, err);
        if (!start)
            return HOBE_NO_MEMORY;
        own.start = start;
    }
    const enum hobe_status status = newton_static(part, &own, &found, err);
    for (long v = 0; !status && v < part->vectors; v++)
        if (part->unknown[v] >= 0)
            memcpy(u + 3 * v, found->u + 3 * v, 3 * sizeof *u);
    if (!status)
        add_info(info, &found->info);
    hobe_solution_free(start);
    hobe_solution_free(found);
    return name_part(part, status, err);
}

static enum hobe_status solve_all(hobe_model *model, const struct hobe_newton *options,
                                  hobe_solution **solution, struct hobe_error *err)
{
    const double started = hobe_seconds();
    struct hobe_solution_info info = {
        .load = 1, .time = options->time, .negative = -1, .smallest_volume = 1};
    double *u = hobe_alloc(3 * (size_t)model->vectors, sizeof *u, err);
    enum hobe_status status = u ? open_all(model, err) : HOBE_NO_MEMORY;
    for (int p = 0; !status && p < model->parts->count; p++)
        status = solve(model->parts->part[p], options, u, &info, err);
    info.seconds = hobe_seconds() - started;
    if (!status) {
        *solution = solution_new(model, u, NULL, NULL, &info, err);
        status = *solution ? HOBE_OK : HOBE_NO_MEMORY;
    }
    hobe_free(u);
    return status;
}

/* The start, unless NULL, must be a state of the model or of one with the same unknowns. */
static enum hobe_status check_start(const hobe_model *model, const hobe_solution *start,
                                    struct hobe_error *err)
{
    const struct reduction *reduction = model->reduction;
    if (!start ||
        (reduction ? start->reduced == reduction->of && start->coordinates == model->vectors
                   : model_same_shape(model, start->model)))
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "start must be a result of this scene or of one of the same shape (the same "
                     "elements, joins and supports in the same order): it has %ld unknowns, here "
                     "are %ld",
                     3 * start->model->unknowns, 3 * model->unknowns);
}

enum hobe_status hobe_static(hobe_model *model, const struct hobe_newton *options,
                             hobe_solution **solution, struct hobe_error *err)
{
    *solution = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (!status)
        status = model_check_held(model, err);
    if (!status && !options->linear)
        status = check_start(model, options->start, err);
    if (status)
        return status;
    /* a linear answer takes one factorisation anyway, and fields of a projection may be in all */
    const int apart =
        !model->reduction && model->parts->count > 1 && !options->linear && !options->projection;
    return (apart ? solve_all : newton_static)(model, options, solution, err);
}
