/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motion in time: the Princeton beam as a pendulum, let go where it is level. */
#include "bench_princeton.h"

/* It hangs, and swings at its fastest, after a quarter of its period: 0.34 s. */
static const double STEP = 2e-3, END = 0.4;

struct swing {
    hobe_model *model;
    struct hobe_dynamic options;
    struct hobe_history_info info; /* of the last motion */
    enum hobe_status status;
    struct hobe_error *err;
};

static enum hobe_status build(hobe_model *model, const struct hobe_kernel *kernel,
                              const hobe_section *section, int elements, struct hobe_error *err)
{
    const struct hobe_joint support = {.beam = {"beam"}, .kind = HOBE_JOINT_SPHERICAL};
    enum hobe_status status =
        bench_princeton_beam(model, kernel, elements, BENCH_PRINCETON_LENGTH, section, err);
    if (!status)
        status = hobe_model_joint(model, &support, err);
    if (!status)
        status = hobe_model_gravity(model, NULL, (const double[]){0, 0, -9.81}, err);
    return status ? status : hobe_model_build(model, err);
}

static void swing(void *context)
{
    struct swing *s = context;
    hobe_history *history = NULL;
    if (s->status)
        return;
    s->status = hobe_dynamic(s->model, &s->options, &history, s->err);
    if (!s->status)
        hobe_history_info(history, &s->info);
    hobe_history_free(history);
}

/* The row of one way, per step. */
static enum hobe_status tell(const struct swing *s, const struct bench_work *work,
                             const struct hobe_kernel *kernel, int elements,
                             struct bench_rows *rows)
{
    struct bench_time time = bench_time(work);
    struct bench_row *row = bench_add(rows, s->err);
    if (!row)
        return HOBE_NO_MEMORY;
    const double steps = (double)s->info.steps;
    time.least /= steps;
    time.median /= steps;
    *row = (struct bench_row){.kind = "motion",
                              .element = kernel->name,
                              .task = s->options.full_newton ? "step, full Newton" : "step",
                              .dofs = 3 * kernel->vectors,
                              .elements = elements,
                              .time = time,
                              .iterations = (double)s->info.iterations / steps,
                              .factors = (double)s->info.factorisations / steps};
    return HOBE_OK;
}

/* Factors at hand as long as they serve, and new ones in each iteration. */
static enum hobe_status race(hobe_model *model, const struct bench_options *options,
                             const struct hobe_kernel *kernel, int elements,
                             struct bench_rows *rows, struct hobe_error *err)
{
    struct swing way[2];
    struct bench_work work[2] = {{0}};
    for (int i = 0; i < 2; i++) {
        way[i] = (struct swing){
            .model = model,
            .options = {.to = END, .step = STEP, .store = END, .full_newton = i},
            .err = err,
        };
        work[i].run = swing;
        work[i].context = way + i;
    }
    enum hobe_status status = bench_race(work, 2, options->seconds, err);
    for (int i = 0; !status && i < 2; i++)
        status = way[i].status ? way[i].status : tell(way + i, work + i, kernel, elements, rows);
    bench_free_samples(work, 2);
    return status;
}

static enum hobe_status time_motion(const struct bench_options *options,
                                    const struct hobe_kernel *kernel, const hobe_section *section,
                                    struct bench_rows *rows, struct hobe_error *err)
{
    const int elements = bench_princeton_mesh(kernel);
    hobe_model *model = hobe_model_new(err);
    options->progress("pendulum of", kernel->name);
    enum hobe_status status = model ? build(model, kernel, section, elements, err) : HOBE_NO_MEMORY;
    if (!status)
        status = race(model, options, kernel, elements, rows, err);
    hobe_model_free(model);
    return status;
}

enum hobe_status bench_motions(const struct bench_options *options, struct bench_rows *rows,
                               struct hobe_error *err)
{
    hobe_section *section = bench_princeton_section(err);
    enum hobe_status status = section ? HOBE_OK : err->status;
    for (int i = 0; !status && i < options->kernels; i++)
        status = time_motion(options, options->kernel[i], section, rows, err);
    hobe_section_free(section);
    return status;
}
