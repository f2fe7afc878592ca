/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "assemble.h"

#include "pattern.h"

#include <string.h>

/* A field of a batch, structure of arrays; spare lanes repeat the last element. */
static void gather(const struct hobe_model *model, const struct beam *beam,
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
                          const struct batch *batch, double *f)
{
    for (int lane = 0; lane < batch->count; lane++)
        for (int v = 0; v < beam->kernel->vectors; v++) {
            double *to = f + 3 * model_vector(model, beam, batch->first + lane, v);
            for (int a = 0; a < 3; a++)
                to[a] += model->work.f[3 * v + a][lane];
        }
}

/* The blocks (v, w) and (w, v) of a batch, where the layout has them. */
static void scatter_blocks(const struct batch *batch, const hobe_lanes K[9], const long *place,
                           long step, const int *stride, int V, int v, int w, double *value)
{
    for (int lane = 0; lane < batch->count; lane++) {
        const long at = place[lane * step + v * V + w], mirror = place[lane * step + w * V + v];
        double *to = value + at;
        for (int c = 0, s = stride[lane * V + w]; at >= 0 && c < 3; c++)
            for (int a = 0; a < 3; a++)
                to[c * s + a] += K[3 * a + c][lane];
        to = value + mirror;
        for (int a = 0, s = stride[lane * V + v]; mirror >= 0 && v != w && a < 3; a++)
            for (int c = 0; c < 3; c++)
                to[a * s + c] += K[3 * a + c][lane];
    }
}

static void scatter_tangent(const struct hobe_model *model, const struct beam *beam,
                            const struct batch *batch, const struct matrix *K)
{
    const int V = beam->kernel->vectors;
    const long *place = beam->place[K->layout] + (long)batch->first * V * V;
    int stride[HOBE_LANES * HOBE_MAX_VECTORS];
    for (int lane = 0; lane < batch->count; lane++)
        for (int v = 0; v < V; v++) {
            const long j = model->unknown[model_vector(model, beam, batch->first + lane, v)];
            stride[lane * V + v] = j < 0 ? 0 : model->stride[K->layout][j];
        }
    for (int v = 0; v < V; v++)
        for (int w = 0; w <= v; w++)
            scatter_blocks(batch, model->work.K + 9 * hobe_pair(v, w), place, (long)V * V, stride,
                           V, v, w, K->value);
}

void assemble(const struct hobe_model *model, const double *u, double *f, const struct matrix *K)
{
    const struct workspace *work = &model->work;
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    if (K)
        pattern_clear(model, K);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int b = 0; b < beam->batches; b++) {
            const struct batch *batch = beam->batch + b;
            const struct hobe_invariants *inv = hobe_element_invariants(batch->law);
            gather(model, beam, batch, u, work->u);
            if (K)
                beam->kernel->tangent(inv, batch->q0, work->u, work->f, work->K, work->scratch);
            else
                beam->kernel->force(inv, batch->q0, work->u, work->f, work->scratch);
            scatter_force(model, beam, batch, f);
            if (K)
                scatter_tangent(model, beam, batch, K);
        }
    }
}

void assemble_strained(const struct hobe_model *model, const double *u, const double *v,
                       const struct matrix *K)
{
    const struct workspace *work = &model->work;
    pattern_clear(model, K);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int b = 0; b < beam->batches; b++) {
            const struct batch *batch = beam->batch + b;
            gather(model, beam, batch, u, work->q0);
            gather(model, beam, batch, v, work->u);
            for (int k = 0; k < 3 * beam->kernel->vectors; k++)
                work->q0[k] += batch->q0[k] - work->u[k];
            beam->kernel->tangent(hobe_element_invariants(batch->law), work->q0, work->u, work->f,
                                  work->K, work->scratch);
            scatter_tangent(model, beam, batch, K);
        }
    }
}

double assemble_energy(const struct hobe_model *model, const double *u)
{
    double energy = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int b = 0; b < beam->batches; b++) {
            const struct batch *batch = beam->batch + b;
            gather(model, beam, batch, u, model->work.u);
            beam->kernel->energy(hobe_element_invariants(batch->law), batch->q0, model->work.u,
                                 model->work.f);
            for (int lane = 0; lane < batch->count; lane++)
                energy += model->work.f[0][lane];
        }
    }
    return energy;
}

enum hobe_status assemble_element(const struct hobe_model *model, const struct beam *beam, int e,
                                  const double *u, double *f, struct hobe_error *err)
{
    const struct hobe_kernel *k = beam->kernel;
    const size_t n = 3 * (size_t)k->vectors;
    const struct batch *batch = beam->batch;
    hobe_lanes *of = hobe_alloc(2 * n + k->scratch, sizeof *of, err);
    if (!of)
        return HOBE_NO_MEMORY;
    while (e >= batch->first + batch->count)
        batch++;
    gather(model, beam, batch, u, of);
    k->force(hobe_element_invariants(batch->law), batch->q0, of, of + n, of + 2 * n);
    for (size_t i = 0; i < n; i++)
        f[i] = of[n + i][e - batch->first];
    hobe_free(of);
    return HOBE_OK;
}
