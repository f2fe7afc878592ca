/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reduced models beside the whole one: Newton iterations of a cantilever on more and more of its
 * modes of vibration.  A better basis costs more to find, and then the same. */
#include "bench_princeton.h"
#include "modes.h"
#include "solver.h"
#include "reduced.h"

#include <stdio.h>

/* What is reduced takes as long as many iterations: this share of the longest beam is enough. */
enum { SHARE = 10 };

static const int unknowns[] = {6, 12, 20, 27, 35}; /* at most MOST */
enum { BASES = sizeof unknowns / sizeof *unknowns, MOST = 35 };

/* A model, whole or reduced, and its solver at rest. */
struct way {
    hobe_model *model;
    hobe_reduced *reduced; /* NULL: whole */
    struct solver solver;
    enum hobe_status status; /* of the iterations */
    struct hobe_error *err;
};

static void iterate(void *context)
{
    struct way *way = context;
    if (!way->status)
        way->status = bench_iterate(&way->solver, way->err);
}

static hobe_model *cantilever(const struct hobe_kernel *kernel, const hobe_section *section,
                              int elements, struct hobe_error *err)
{
    hobe_model *model = hobe_model_new(err);
    enum hobe_status status = model ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        status =
            bench_princeton_beam(model, kernel, elements, BENCH_PRINCETON_LENGTH, section, err);
    if (!status)
        status = hobe_model_clamp(model, &(struct hobe_clamp){.beam = "beam"}, err);
    if (!status)
        status = hobe_model_force(
            model, &(struct hobe_force){.beam = "beam", .at = 1, .value = {0, 3, -3}}, err);
    if (!status)
        status = hobe_model_build(model, err);
    if (!status)
        return model;
    hobe_model_free(model);
    return NULL;
}

/* The whole model reduced to its first modes; or itself, of 0 modes. */
static enum hobe_status open_way(struct way *way, hobe_model *whole, const hobe_modes *modes,
                                 int count, struct hobe_error *err)
{
    const struct hobe_reduce options = {
        .method = HOBE_REDUCE_FIELDS, .modes = count, .field = modes->shape, .fields = count};
    enum hobe_status status = HOBE_OK;
    *way = (struct way){.model = count ? NULL : whole, .err = err};
    if (count)
        status = hobe_reduce(whole, &options, &way->reduced, err);
    if (count && !status)
        status = hobe_reduced_model(way->reduced, whole, &way->model, err);
    if (!status)
        status = solver_open(&way->solver, way->model, &(struct hobe_newton){0}, err);
    return status;
}

static void close_way(struct way *way)
{
    solver_close(&way->solver);
    if (way->reduced)
        hobe_model_free(way->model);
    hobe_reduced_free(way->reduced);
}

static enum hobe_status tell(const struct way *way, const struct bench_work *work,
                             const struct bench_work *whole, const struct hobe_kernel *kernel,
                             int elements, struct bench_rows *rows)
{
    struct hobe_reduced_info info = {.unknowns = (int)(3 * way->model->unknowns)};
    struct bench_row *row = bench_add(rows, way->err);
    if (!row)
        return HOBE_NO_MEMORY;
    if (way->reduced)
        hobe_reduced_info(way->reduced, &info);
    *row = (struct bench_row){.kind = "reduced",
                              .element = kernel->name,
                              .task = "Newton iteration",
                              .dofs = info.unknowns,
                              .elements = elements,
                              .time = bench_time(work),
                              .whole = bench_ratio(whole, work),
                              .offline = info.seconds,
                              .tensor = way->reduced ? quartic_bytes(&way->reduced->quartic) : 0};
    return HOBE_OK;
}

/* The whole model first. */
static enum hobe_status race(struct way *way, const struct bench_options *options,
                             const struct hobe_kernel *kernel, int elements,
                             struct bench_rows *rows, struct hobe_error *err)
{
    struct bench_work work[1 + BASES] = {{0}};
    for (int i = 0; i <= BASES; i++) {
        work[i].run = iterate;
        work[i].context = way + i;
    }
    enum hobe_status status = bench_race(work, 1 + BASES, options->seconds, err);
    for (int i = 0; !status && i <= BASES; i++)
        status =
            way[i].status ? way[i].status : tell(way + i, work + i, work, kernel, elements, rows);
    bench_free_samples(work, 1 + BASES);
    return status;
}

static enum hobe_status time_beam(const struct bench_options *options,
                                  const struct hobe_kernel *kernel, const hobe_section *section,
                                  int elements, struct bench_rows *rows, struct hobe_error *err)
{
    struct way way[1 + BASES] = {{0}};
    char name[100];
    snprintf(name, sizeof name, "%d x %s", elements, kernel->name);
    options->progress("reduced beam of", name);
    hobe_modes *modes = NULL;
    hobe_model *whole = cantilever(kernel, section, elements, err);
    enum hobe_status status = whole ? HOBE_OK : err->status;
    if (!status)
        status = hobe_modal(whole, NULL, &(struct hobe_modal_options){.modes = MOST}, &modes, err);
    for (int i = 0; !status && i <= BASES; i++)
        status = open_way(way + i, whole, modes, i ? unknowns[i - 1] : 0, err);
    if (!status)
        status = race(way, options, kernel, elements, rows, err);
    for (int i = 0; i <= BASES; i++)
        close_way(way + i);
    hobe_modes_free(modes);
    hobe_model_free(whole);
    return status;
}

enum hobe_status bench_reduced(const struct bench_options *options, struct bench_rows *rows,
                               struct hobe_error *err)
{
    static const int sizes[] = {20, 100, 1000};
    hobe_section *section = bench_princeton_section(err);
    enum hobe_status status = section ? HOBE_OK : err->status;
    for (int i = 0; i < options->scenes; i++)
        for (size_t n = 0; !status && n < sizeof sizes / sizeof *sizes; n++)
            if (options->scene[i]->gram && SHARE * sizes[n] <= options->longest)
                status = time_beam(options, options->scene[i], section, sizes[n], rows, err);
    hobe_section_free(section);
    return status;
}
