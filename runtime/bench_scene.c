/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole scenes: the steps of a Newton iteration on beams of ever more elements, and the load cases
 * of the paper's Table 6. */
#define _GNU_SOURCE
#include "bench_princeton.h"
#include "solver.h"

#include <fcntl.h>
#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* A beam longer than this is held again after as many elements each: a cantilever of thousands has
 * no digits left. */
enum { BAY = 24 };

/* Below this, pages of memory are too coarse to tell what an element takes. */
enum { MEMORY_FROM = 1000 };

/* ---- long beams ----------------------------------------------------------------------------- */

/* A beam in bays of the Princeton beam's length and mesh under its weight; each work leaves it in
 * the reference. */
struct scene {
    const struct hobe_kernel *kernel;
    const hobe_section *section;
    int elements;
    hobe_model *model;
    struct solver solver;
    enum hobe_status status; /* of the works */
    struct hobe_error *err;
};

static hobe_model *build(const struct scene *s)
{
    hobe_model *model = hobe_model_new(s->err);
    enum hobe_status status = model ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        status =
            bench_princeton_beam(model, s->kernel, s->elements,
                                 BENCH_PRINCETON_LENGTH / BAY * s->elements, s->section, s->err);
    for (int e = 0; !status && e < s->elements; e += BAY)
        status = hobe_model_clamp(model,
                                  &(struct hobe_clamp){.beam = "beam",
                                                       .at = (double)e / s->elements,
                                                       .free_warping = e > 0},
                                  s->err);
    if (!status)
        status = hobe_model_gravity(model, NULL, (const double[]){0, 0, -9.81}, s->err);
    if (!status)
        status = hobe_model_build(model, s->err);
    if (!status)
        return model;
    hobe_model_free(model);
    return NULL;
}

static void run_setup(void *context)
{
    struct scene *s = context;
    hobe_model *model = build(s);
    if (!model)
        s->status = s->err->status;
    hobe_model_free(model);
}

static void run_residual(void *context)
{
    solver_evaluate(&((struct scene *)context)->solver, 1, 0);
}

static void run_tangent(void *context)
{
    solver_evaluate(&((struct scene *)context)->solver, 1, 1);
}

static void run_factor(void *context)
{
    struct scene *s = context;
    if (solver_factor(&s->solver, s->err) != CONVERGED)
        s->status = s->err->status;
}

static void run_solve(void *context)
{
    struct scene *s = context;
    if (solver_solve(&s->solver, s->solver.r, -1, s->solver.x, s->err))
        s->status = s->err->status;
}

enum hobe_status bench_iterate(struct solver *s, struct hobe_error *err)
{
    solver_evaluate(s, 1, TRUE_TANGENT);
    solver_norm(s, s->r, 1);
    if (solver_factor(s, err) != CONVERGED || solver_solve(s, s->r, -1, s->x, err))
        return err->status;
    solver_move(s, s->x, 1);
    memset(s->u, 0, (size_t)(3 * s->model->vectors) * sizeof *s->u);
    return HOBE_OK;
}

static void run_iteration(void *context)
{
    struct scene *s = context;
    if (bench_iterate(&s->solver, s->err))
        s->status = s->err->status;
}

static const struct {
    const char *name;
    void (*run)(void *context);
} tasks[] = {
    {"set-up", run_setup},  {"residual", run_residual}, {"residual, tangent", run_tangent},
    {"factor", run_factor}, {"solve", run_solve},       {"Newton iteration", run_iteration},
};
enum { TASKS = sizeof tasks / sizeof *tasks, ITERATION = TASKS - 1 };

/* A number of kB from /proc/self/status, in bytes; 0 where there is none. */
static double memory(const char *name)
{
    char line[200];
    long kB = 0;
    FILE *file = fopen("/proc/self/status", "r");
    while (file && fgets(line, sizeof line, file))
        if (!strncmp(line, name, strlen(name)))
            sscanf(line + strlen(name), ": %ld", &kB);
    if (file)
        fclose(file);
    return 1024.0 * (double)kB;
}

/* Begins to watch for the most memory in use; what is in use now, bytes, 0 where that fails. */
static double watch_memory(void)
{
    malloc_trim(0);
    const int file = open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
    const int reset = file >= 0 && write(file, "5", 1) == 1;
    if (file >= 0)
        close(file);
    return reset ? memory("VmRSS") : 0;
}

static enum hobe_status open_scene(struct scene *s)
{
    s->model = build(s);
    if (!s->model)
        return s->err->status;
    const enum hobe_status status =
        solver_open(&s->solver, s->model, &(struct hobe_newton){0}, s->err);
    if (!status)
        run_iteration(s);
    return status ? status : s->status;
}

static enum hobe_status race_scene(struct scene *s, double seconds, double bytes,
                                   struct bench_rows *rows)
{
    struct bench_work work[TASKS] = {{0}};
    for (int i = 0; i < TASKS; i++) {
        work[i].run = tasks[i].run;
        work[i].context = s;
    }
    enum hobe_status status = bench_race(work, TASKS, seconds, s->err);
    if (!status)
        status = s->status;
    for (int i = 0; !status && i < TASKS; i++) {
        struct bench_row *row = bench_add(rows, s->err);
        if (row)
            *row = (struct bench_row){.kind = "scene",
                                      .element = s->kernel->name,
                                      .task = tasks[i].name,
                                      .dofs = 3 * s->kernel->vectors,
                                      .elements = s->elements,
                                      .time = bench_time(work + i),
                                      .bytes = i == ITERATION ? bytes : 0};
        else
            status = HOBE_NO_MEMORY;
    }
    bench_free_samples(work, TASKS);
    return status;
}

static enum hobe_status time_scene(const struct bench_options *options,
                                   const struct hobe_kernel *kernel, const hobe_section *section,
                                   int elements, struct bench_rows *rows, struct hobe_error *err)
{
    struct scene s = {.kernel = kernel, .section = section, .elements = elements, .err = err};
    char name[100];
    snprintf(name, sizeof name, "%d x %s", elements, kernel->name);
    options->progress("beam of", name);
    const double before = elements >= MEMORY_FROM ? watch_memory() : 0;
    enum hobe_status status = open_scene(&s);
    if (!status)
        status = race_scene(&s, options->seconds, before > 0 ? memory("VmHWM") - before : 0, rows);
    solver_close(&s.solver);
    hobe_model_free(s.model);
    return status;
}

enum hobe_status bench_scenes(const struct bench_options *options, struct bench_rows *rows,
                              struct hobe_error *err)
{
    static const int sizes[] = {24, 240, 1000, 10000, 100000};
    hobe_section *section = bench_princeton_section(err);
    enum hobe_status status = section ? HOBE_OK : err->status;
    for (int i = 0; i < options->scenes; i++)
        for (size_t n = 0; !status && n < sizeof sizes / sizeof *sizes; n++)
            if (sizes[n] <= options->longest)
                status = time_scene(options, options->scene[i], section, sizes[n], rows, err);
    hobe_section_free(section);
    return status;
}

/* ---- Table 6 -------------------------------------------------------------------------------- */

struct table6 {
    const struct hobe_kernel *kernel;
    const hobe_section *section;
    int elements;
    enum hobe_status status;
    struct hobe_error *err;
};

static enum hobe_status load_case(const struct table6 *t, double P, double angle)
{
    hobe_solution *solution = NULL;
    hobe_model *model = hobe_model_new(t->err);
    const struct hobe_force force = {
        .beam = "beam", .at = 1, .value = {0, -P * sin(angle), -P * cos(angle)}};
    enum hobe_status status = model ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        status = bench_princeton_beam(model, t->kernel, t->elements, BENCH_PRINCETON_LENGTH,
                                      t->section, t->err);
    if (!status)
        status = hobe_model_clamp(model, &(struct hobe_clamp){.beam = "beam"}, t->err);
    if (!status)
        status = hobe_model_force(model, &force, t->err);
    if (!status)
        status = hobe_static(model, &(struct hobe_newton){0}, &solution, t->err);
    hobe_solution_free(solution);
    hobe_model_free(model);
    return status;
}

static void run_table6(void *context)
{
    static const double loads[] = {4.448, 8.896, 13.345}; /* N */
    struct table6 *t = context;
    for (int i = 0; i < 3; i++)
        for (int degrees = 0; !t->status && degrees <= 90; degrees += 15)
            t->status = load_case(t, loads[i], degrees * M_PI / 180);
}

static enum hobe_status time_table6(const struct bench_options *options, struct table6 *t,
                                    struct bench_rows *rows)
{
    struct bench_work work = {.run = run_table6, .context = t};
    options->progress("Table 6 by", t->kernel->name);
    enum hobe_status status = bench_race(&work, 1, options->seconds, t->err);
    if (!status)
        status = t->status;
    struct bench_row *row = status ? NULL : bench_add(rows, t->err);
    if (row)
        *row = (struct bench_row){.kind = "table 6",
                                  .element = t->kernel->name,
                                  .task = "21 load cases",
                                  .dofs = 3 * t->kernel->vectors,
                                  .elements = t->elements,
                                  .time = bench_time(&work)};
    bench_free_samples(&work, 1);
    return status ? status : row ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status bench_table6(const struct bench_options *options, struct bench_rows *rows,
                              struct hobe_error *err)
{
    hobe_section *section = bench_princeton_section(err);
    enum hobe_status status = section ? HOBE_OK : err->status;
    for (int i = 0; !status && i < options->kernels; i++) {
        const struct hobe_kernel *kernel = options->kernel[i];
        struct table6 t = {kernel, section, bench_princeton_mesh(kernel), HOBE_OK, err};
        status = time_table6(options, &t, rows);
    }
    hobe_section_free(section);
    return status;
}
