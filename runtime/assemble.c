/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "assemble.h"

#include "element.h"
#include "pattern.h"
#include "reduction.h"

#include <stdint.h>
#include <string.h>

#ifdef _OPENMP
#include <omp.h>
#endif

enum {
    BATCHES_PER_TASK = 16,    /* neighbours that find each other's panels in the cache */
    ELEMENTS_PER_THREAD = 512 /* fewer are done before a second thread wakes up */
};

static int most_threads(void)
{
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

static int this_thread(void)
{
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

/* ---- schedule -------------------------------------------------------------------------------- */

static int tasks_of(const struct beam *beam)
{
    return (beam->batches + BATCHES_PER_TASK - 1) / BATCHES_PER_TASK;
}

/* The first colour that no task around has, the last one where all others are taken: used[] holds
 * a bit for each colour around a vector. */
static int find_colour(const struct hobe_model *model, const struct task *task, uint64_t *used)
{
    const struct batch *batch = task->beam->batch + task->first, *last = batch + task->count - 1;
    const int V = task->beam->kernel->vectors, end = last->first + last->count;
    uint64_t around = 0;
    int colour = 0;
    for (int i = V * batch->first; i < V * end; i++)
        around |= used[model_vector(model, task->beam, i / V, i % V)];
    while (colour < COLOURS - 1 && around >> colour & 1)
        colour++;
    for (int i = V * batch->first; i < V * end; i++)
        used[model_vector(model, task->beam, i / V, i % V)] |= (uint64_t)1 << colour;
    return colour;
}

/* Sorts the tasks by colour; each keeps its place among those of its own. */
static void sort_tasks(const struct hobe_model *model, long tasks, struct task *all,
                       unsigned char *colour, uint64_t *used, struct schedule *s)
{
    long at[COLOURS], next = 0;
    for (size_t i = 0; i < model->beams.count; i++)
        for (int t = 0; t < tasks_of(model_beam(model, i)); t++) {
            const struct beam *beam = model_beam(model, i);
            const int first = t * BATCHES_PER_TASK, left = beam->batches - first;
            all[next++] =
                (struct task){beam, first, left < BATCHES_PER_TASK ? left : BATCHES_PER_TASK};
        }
    for (long t = 0; t < tasks; t++) {
        colour[t] = (unsigned char)find_colour(model, all + t, used);
        s->first[colour[t] + 1]++;
    }
    for (int c = 0; c < COLOURS; c++) {
        at[c] = s->first[c];
        s->first[c + 1] += s->first[c];
    }
    for (long t = 0; t < tasks; t++)
        s->task[at[colour[t]]++] = all[t];
}

static enum hobe_status order_tasks(const struct hobe_model *model, long tasks, struct schedule *s,
                                    struct hobe_error *err)
{
    s->task = hobe_alloc((size_t)tasks, sizeof *s->task, err);
    struct task *all = hobe_alloc((size_t)tasks, sizeof *all, err);
    unsigned char *colour = hobe_alloc((size_t)tasks, sizeof *colour, err);
    uint64_t *used = hobe_alloc((size_t)model->vectors, sizeof *used, err);
    const enum hobe_status status = s->task && all && colour && used ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        sort_tasks(model, tasks, all, colour, used, s);
    hobe_free(all);
    hobe_free(colour);
    hobe_free(used);
    return status;
}

static enum hobe_status open_workspaces(const struct hobe_model *model, struct schedule *s,
                                        struct hobe_error *err)
{
    size_t V = 0, scratch = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct hobe_kernel *k = model_beam(model, i)->kernel;
        V = (size_t)k->vectors > V ? (size_t)k->vectors : V;
        const size_t more = hobe_element_scratch(k);
        scratch = more > scratch ? more : scratch;
    }
    const size_t blocks = 9 * V * (V + 1) / 2;
    s->work = hobe_alloc((size_t)s->threads, sizeof *s->work, err);
    for (int t = 0; s->work && t < s->threads; t++) {
        struct workspace *w = s->work + t;
        w->q0 = hobe_alloc(9 * V + 2 * blocks + scratch, sizeof(hobe_lanes), err);
        if (!w->q0)
            return HOBE_NO_MEMORY;
        w->u = w->q0 + 3 * V;
        w->f = w->u + 3 * V;
        w->K = w->f + 3 * V;
        w->more = w->K + blocks;
        w->scratch = w->more + blocks;
    }
    return s->work ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status assemble_schedule(hobe_model *model, struct hobe_error *err)
{
    struct schedule *s = &model->schedule;
    long tasks = 0, elements = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        tasks += tasks_of(model_beam(model, i));
        elements += model_beam(model, i)->spec.elements;
    }
    const long useful = 1 + elements / ELEMENTS_PER_THREAD;
    s->threads = useful < most_threads() ? (int)useful : most_threads();
    const enum hobe_status status = order_tasks(model, tasks, s, err);
    return status ? status : open_workspaces(model, s, err);
}

void assemble_free(struct schedule *s)
{
    for (int t = 0; s->work && t < s->threads; t++)
        hobe_free(s->work[t].q0);
    hobe_free(s->work);
    hobe_free(s->task);
}

/* ---- one batch ------------------------------------------------------------------------------- */

void assemble_gather(const struct hobe_model *model, const struct beam *beam,
                     const struct batch *batch, const double *u, hobe_lanes *to)
{
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        const int e = batch->first + (lane < batch->count ? lane : batch->count - 1);
        for (int v = 0; v < beam->kernel->vectors; v++) {
            const double *from = u + 3 * model_vector(model, beam, e, v);
            for (int a = 0; a < 3; a++)
                to[3 * v + a][lane] = from[a];
        }
    }
}

static void scatter_force(const struct hobe_model *model, const struct beam *beam,
                          const struct batch *batch, const hobe_lanes *from, double *f)
{
    for (int lane = 0; lane < batch->count; lane++)
        for (int v = 0; v < beam->kernel->vectors; v++) {
            double *to = f + 3 * model_vector(model, beam, batch->first + lane, v);
            for (int a = 0; a < 3; a++)
                to[a] += from[3 * v + a][lane];
        }
}

/* K += the blocks (v, w), v >= w, of one element and their transposes, where the layout has them:
 * column[3][3 V] are its columns of the vector w.  Blocks that follow each other in both go at
 * once. */
static void scatter_column(const double *column, const long *place, const int *stride, int V, int w,
                           double *value)
{
    for (int v = w, next; v < V; v = next) {
        const long at = place[v * V + w];
        for (next = v + 1; next < V && place[next * V + w] == at + 3 * (next - v);)
            next++;
        for (int c = 0; at >= 0 && c < 3; c++) {
            double *to = value + at + c * stride[w];
            const double *from = column + 3 * (V * c + v);
            for (int i = 0; i < 3 * (next - v); i++)
                to[i] += from[i];
        }
    }
    for (int v = w + 1; v < V; v++) {
        const long at = place[w * V + v];
        for (int a = 0; at >= 0 && a < 3; a++)
            for (int c = 0; c < 3; c++)
                value[at + a * stride[v] + c] += column[3 * (V * c + v) + a];
    }
}

static void scatter_tangent(const struct hobe_model *model, const struct beam *beam,
                            const struct batch *batch, const hobe_lanes *from,
                            const struct matrix *K)
{
    const int V = beam->kernel->vectors;
    const long *place = beam->place[K->layout] + (long)batch->first * V * V;
    int stride[HOBE_LANES][HOBE_MAX_VECTORS];
    double column[HOBE_LANES * 9 * HOBE_MAX_VECTORS]; /* [lane][3][3 V] */
    for (int lane = 0; lane < batch->count; lane++)
        for (int v = 0; v < V; v++) {
            const long j = model->unknown[model_vector(model, beam, batch->first + lane, v)];
            stride[lane][v] = j < 0 ? 0 : model->stride[K->layout][j];
        }
    for (int w = 0; w < V; w++) {
        for (int v = w; v < V; v++)
            for (int a = 0; a < 3; a++)
                for (int c = 0; c < 3; c++)
                    for (int lane = 0; lane < HOBE_LANES; lane++)
                        column[3 * (V * (3 * lane + c) + v) + a] =
                            from[9 * hobe_pair(v, w) + 3 * a + c][lane];
        for (int lane = 0; lane < batch->count; lane++)
            scatter_column(column + 9 * V * lane, place + (long)lane * V * V, stride[lane], V, w,
                           K->value);
    }
}

/* ---- all of them ----------------------------------------------------------------------------- */

struct assembly {
    const struct hobe_model *model;
    const double *u, *v;
    double *f;
    const struct matrix *K;
    double rate;
    const struct series_table *table;
    int order; /* of the series */
};

typedef void batch_work(const struct assembly *, const struct beam *, const struct batch *,
                        struct workspace *);

static void each_batch(const struct assembly *assembly, batch_work *work)
{
    const struct schedule *s = &assembly->model->schedule;
    for (int c = 0; c < COLOURS && s->first[c] < s->first[c + 1]; c++) {
        const int threads = c < COLOURS - 1 ? s->threads : 1;
        (void)threads; /* without OpenMP */
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
        for (long t = s->first[c]; t < s->first[c + 1]; t++) {
            const struct task *task = s->task + t;
            for (int b = 0; b < task->count; b++)
                work(assembly, task->beam, task->beam->batch + task->first + b,
                     s->work + this_thread());
        }
    }
}

/* K -= the geometric stiffness of the stresses of the strains v v/2.  These are -v v/2 on the way
 * from -v to 0, where the rest of the stiffness vanishes. */
static void expect_stresses(const struct assembly *a, const struct beam *beam,
                            const struct batch *batch, struct workspace *work)
{
    const int V = beam->kernel->vectors;
    assemble_gather(a->model, beam, batch, a->v, work->u);
    for (int k = 0; k < 3 * V; k++)
        work->q0[k] = -work->u[k];
    hobe_element_batch_tangent(batch->law, work->q0, work->u, work->f, work->more, work->scratch);
    for (int k = 0; k < 9 * hobe_pair(V, 0); k++)
        work->K[k] += work->more[k];
}

static void add_batch(const struct assembly *a, const struct beam *beam, const struct batch *batch,
                      struct workspace *work)
{
    const struct hobe_kernel *kernel = beam->kernel;
    assemble_gather(a->model, beam, batch, a->u, work->u);
    if (a->K)
        hobe_element_batch_tangent(batch->law, batch->q0, work->u, work->f, work->K, work->scratch);
    else
        hobe_element_batch_force(batch->law, batch->q0, work->u, work->f, work->scratch);
    scatter_force(a->model, beam, batch, work->f, a->f);
    if (a->K && a->v && kernel->trilinear) /* the energy is quartic */
        expect_stresses(a, beam, batch, work);
    if (a->K)
        scatter_tangent(a->model, beam, batch, work->K, a->K);
}

void assemble_expecting(const struct hobe_model *model, const double *u, const double *v, double *f,
                        const struct matrix *K)
{
    if (model->reduction) {
        reduction_elastic(model, u, f, K);
        return;
    }
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    if (K)
        pattern_clear(model, K);
    each_batch(&(struct assembly){.model = model, .u = u, .v = v, .f = f, .K = K}, add_batch);
}

void assemble(const struct hobe_model *model, const double *u, double *f, const struct matrix *K)
{
    assemble_expecting(model, u, NULL, f, K);
}

static void add_strained(const struct assembly *a, const struct beam *beam,
                         const struct batch *batch, struct workspace *work)
{
    const struct hobe_kernel *kernel = beam->kernel;
    assemble_gather(a->model, beam, batch, a->u, work->q0);
    assemble_gather(a->model, beam, batch, a->v, work->u);
    for (int k = 0; k < 3 * kernel->vectors; k++)
        work->q0[k] += batch->q0[k] - work->u[k];
    hobe_element_batch_tangent(batch->law, work->q0, work->u, work->f, work->K, work->scratch);
    scatter_tangent(a->model, beam, batch, work->K, a->K);
}

void assemble_strained(const struct hobe_model *model, const double *u, const double *v,
                       const struct matrix *K)
{
    pattern_clear(model, K);
    each_batch(&(struct assembly){.model = model, .u = u, .v = v, .K = K}, add_strained);
}

/* work->q0 = q in state u, work->f = 2 T(q; q, v). */
static void find_viscous(const struct hobe_model *model, const struct beam *beam,
                         const struct batch *batch, const double *u, const double *v,
                         const struct workspace *work)
{
    const struct hobe_kernel *kernel = beam->kernel;
    assemble_gather(model, beam, batch, u, work->q0);
    for (int k = 0; k < 3 * kernel->vectors; k++)
        work->q0[k] += batch->q0[k];
    assemble_gather(model, beam, batch, v, work->u);
    kernel->trilinear(hobe_element_invariants(batch->law), work->q0, work->q0, work->u, work->f,
                      work->scratch);
    for (int k = 0; k < 3 * kernel->vectors; k++)
        work->f[k] *= 2;
}

static void add_viscous(const struct assembly *a, const struct beam *beam,
                        const struct batch *batch, struct workspace *work)
{
    const int V = beam->kernel->vectors;
    const double tau = beam->spec.damping.stiffness;
    if (tau == 0)
        return;
    find_viscous(a->model, beam, batch, a->u, a->v, work);
    for (int k = 0; k < 3 * V; k++)
        work->f[k] *= tau;
    scatter_force(a->model, beam, batch, work->f, a->f);
    if (!a->K)
        return;
    memset(work->u, 0, (size_t)(3 * V) * sizeof *work->u);
    hobe_element_batch_tangent(batch->law, work->q0, work->u, work->f, work->K, work->scratch);
    for (int k = 0; k < 9 * hobe_pair(V, 0); k++)
        work->K[k] *= a->rate * tau;
    scatter_tangent(a->model, beam, batch, work->K, a->K);
}

void assemble_viscous(const struct hobe_model *model, const double *u,
                      const struct instant *instant, double *f, const struct matrix *K)
{
    each_batch(&(struct assembly){model, u, instant->v, f, K, instant->rate, NULL, 0}, add_viscous);
}

double assemble_viscous_power(const struct hobe_model *model, const double *u, const double *v)
{
    const struct workspace *work = model->schedule.work;
    double power = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const double tau = beam->spec.damping.stiffness;
        for (int b = 0; tau > 0 && b < beam->batches; b++) {
            const struct batch *batch = beam->batch + b;
            find_viscous(model, beam, batch, u, v, work);
            for (int k = 0; k < 3 * beam->kernel->vectors; k++)
                for (int lane = 0; lane < batch->count; lane++)
                    power += tau * work->f[k][lane] * work->u[k][lane];
        }
    }
    return power;
}

/* ---- series ---------------------------------------------------------------------------------- */

static enum hobe_status lay_out_table(const struct hobe_model *model, int order,
                                      struct series_table *table, size_t *size,
                                      struct hobe_error *err)
{
    *size = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const struct hobe_kernel *k = beam->kernel;
        size_t stations = 0;
        if (!k->series)
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "method = \"series\" needs elements whose energy is a polynomial; "
                             "that of %s (beam \"%s\") is none: use method = \"newton\"",
                             k->name, beam->name);
        for (int b = 0; b < beam->batches; b++) {
            const size_t here = (size_t)hobe_element_invariants(beam->batch[b].law)->stations;
            stations = here > stations ? here : stations;
        }
        table->beam[i] = *size;
        table->batch[i] = (size_t)(order + 1) * stations *
                          (size_t)(3 * (2 * k->modes - 1) + k->normals + k->shears);
        *size += (size_t)beam->batches * table->batch[i];
    }
    return HOBE_OK;
}

enum hobe_status assemble_series_open(const struct hobe_model *model, int order,
                                      struct series_table *table, struct hobe_error *err)
{
    size_t size;
    if (model->reduction)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "method = \"series\" is for whole models; a reduced one is solved by "
                         "method = \"newton\"");
    table->beam = hobe_alloc(2 * model->beams.count, sizeof *table->beam, err);
    if (!table->beam)
        return HOBE_NO_MEMORY;
    table->batch = table->beam + model->beams.count;
    const enum hobe_status status = lay_out_table(model, order, table, &size, err);
    if (status)
        return status;
    table->value = hobe_alloc(size, sizeof *table->value, err);
    return table->value ? HOBE_OK : HOBE_NO_MEMORY;
}

void assemble_series_close(struct series_table *table)
{
    hobe_free(table->value);
    hobe_free(table->beam);
}

static void add_coefficient(const struct assembly *a, const struct beam *beam,
                            const struct batch *batch, struct workspace *work)
{
    const long i = beam - model_beam(a->model, 0), b = batch - beam->batch;
    assemble_gather(a->model, beam, batch, a->u, work->u);
    beam->kernel->series(hobe_element_invariants(batch->law), a->order, batch->q0, work->u,
                         a->table->value + a->table->beam[i] + (size_t)b * a->table->batch[i],
                         work->f);
    scatter_force(a->model, beam, batch, work->f, a->f);
}

void assemble_series(const struct hobe_model *model, int k, const double *u,
                     const struct series_table *table, double *f)
{
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    each_batch(&(struct assembly){.model = model, .u = u, .f = f, .table = table, .order = k},
               add_coefficient);
}

/* ---- energy and single elements -------------------------------------------------------------- */

double assemble_beam_energy(const struct hobe_model *model, const struct beam *beam,
                            const double *u)
{
    const struct workspace *work = model->schedule.work;
    double energy = 0;
    for (int b = 0; b < beam->batches; b++) {
        const struct batch *batch = beam->batch + b;
        assemble_gather(model, beam, batch, u, work->u);
        beam->kernel->energy(hobe_element_invariants(batch->law), batch->q0, work->u, work->f);
        for (int lane = 0; lane < batch->count; lane++)
            energy += work->f[0][lane];
    }
    return energy;
}

double assemble_energy(const struct hobe_model *model, const double *u)
{
    double energy = 0;
    if (model->reduction)
        return reduction_energy(model, u);
    for (size_t i = 0; i < model->beams.count; i++)
        energy += assemble_beam_energy(model, model_beam(model, i), u);
    return energy;
}

enum hobe_status assemble_element(const struct hobe_model *model, const struct beam *beam, int e,
                                  const double *u, const double *v, double *f,
                                  struct hobe_error *err)
{
    const struct hobe_kernel *k = beam->kernel;
    const size_t n = 3 * (size_t)k->vectors;
    const struct batch *batch = beam->batch;
    hobe_lanes *of = hobe_alloc(3 * n + hobe_element_scratch(k), sizeof *of, err);
    if (!of)
        return HOBE_NO_MEMORY;
    const struct workspace work = {.q0 = of, .u = of + n, .f = of + 2 * n, .scratch = of + 3 * n};
    while (e >= batch->first + batch->count)
        batch++;
    assemble_gather(model, beam, batch, u, work.u);
    hobe_element_batch_force(batch->law, batch->q0, work.u, work.f, work.scratch);
    for (size_t i = 0; i < n; i++)
        f[i] = work.f[i][e - batch->first];
    if (v && beam->spec.damping.stiffness > 0) {
        find_viscous(model, beam, batch, u, v, &work);
        for (size_t i = 0; i < n; i++)
            f[i] += beam->spec.damping.stiffness * work.f[i][e - batch->first];
    }
    hobe_free(of);
    return HOBE_OK;
}
