/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pattern.h"

#include "body.h"
#include "constraint.h"
#include "load.h"
#include "reduction.h"
#include "spring.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void pattern_free(struct pattern *p)
{
    hobe_free(p->start);
    hobe_free(p->row);
    hobe_free(p->Ap);
    hobe_free(p->Ai);
    *p = (struct pattern){0};
}

/* The unknown of vector v of element e, -1 when held. */
static long unknown(const struct hobe_model *model, const struct beam *beam, int e, int v)
{
    return model->unknown[model_vector(model, beam, e, v)];
}

/* What couples vectors beside the elements: ties, then springs. */
static size_t couplings(const struct hobe_model *model)
{
    return model->ties.count + model->springs.count;
}

static struct tie *coupling(const struct hobe_model *model, size_t i)
{
    const size_t ties = model->ties.count;
    return i < ties ? model_tie(model, i) : &model_spring(model, i - ties)->tie;
}

/* Calls visit for every pair of unknown vectors (i, j) that an element, joint or spring couples,
 * repeats included. */
static void each_pair(const struct hobe_model *model, void (*visit)(struct pattern *, long, long),
                      struct pattern *pattern)
{
    for (long j = 0; model->reduction && j < model->unknowns; j++)
        for (long i = 0; i < model->unknowns; i++) /* each with all */
            visit(pattern, i, j);
    for (size_t b = 0; b < model->beams.count; b++) {
        const struct beam *beam = model_beam(model, b);
        for (int e = 0; e < beam->spec.elements; e++)
            for (int w = 0; w < beam->kernel->vectors; w++)
                for (int v = 0; v < beam->kernel->vectors; v++) {
                    const long i = unknown(model, beam, e, v), j = unknown(model, beam, e, w);
                    if (i >= 0 && j >= 0)
                        visit(pattern, i, j);
                }
    }
    for (size_t n = 0; n < couplings(model); n++) {
        const struct tie *tie = coupling(model, n);
        for (int w = 0; w < tie->vectors; w++)
            for (int v = 0; v < tie->vectors; v++) {
                const long i = model->unknown[tie->vector[v]], j = model->unknown[tie->vector[w]];
                if (i >= 0 && j >= 0)
                    visit(pattern, i, j);
            }
    }
}

static void count_pair(struct pattern *p, long i, long j)
{
    (void)i;
    p->start[j + 1]++;
}

/* start[j] is the place of the next row of column j while filling. */
static void fill_pair(struct pattern *p, long i, long j)
{
    p->row[p->start[j]++] = i;
}

static int ascending(const void *a, const void *b)
{
    const long x = *(const long *)a, y = *(const long *)b;
    return (x > y) - (x < y);
}

/* Sorts each column and removes repeats; start[] is shifted by one column after filling. */
static void tidy_columns(struct pattern *p)
{
    long kept = 0, begin = 0;
    for (long j = 0; j < p->blocks; j++) {
        const long end = p->start[j];
        qsort(p->row + begin, (size_t)(end - begin), sizeof *p->row, ascending);
        p->start[j] = kept;
        for (long k = begin; k < end; k++)
            if (k == begin || p->row[k] != p->row[k - 1])
                p->row[kept++] = p->row[k];
        begin = end;
    }
    p->start[p->blocks] = kept;
}

/* The same pattern in scalars. */
static enum hobe_status scalar_columns(struct pattern *p, struct hobe_error *err)
{
    p->Ap = hobe_alloc((size_t)(3 * p->blocks + 1), sizeof *p->Ap, err);
    p->Ai = hobe_alloc((size_t)(9 * p->start[p->blocks]), sizeof *p->Ai, err);
    if (!p->Ap || !p->Ai)
        return HOBE_NO_MEMORY;
    long next = 0;
    for (long j = 0; j < p->blocks; j++)
        for (int c = 0; c < 3; c++) {
            p->Ap[3 * j + c] = next;
            for (long b = p->start[j]; b < p->start[j + 1]; b++)
                for (int a = 0; a < 3; a++)
                    p->Ai[next++] = 3 * p->row[b] + a;
        }
    p->Ap[3 * p->blocks] = next;
    return HOBE_OK;
}

static long find_block(const struct pattern *p, long i, long j)
{
    const long *found = bsearch(&i, p->row + p->start[j], (size_t)(p->start[j + 1] - p->start[j]),
                                sizeof *p->row, ascending);
    return found - p->row;
}

/* Where a layout has block (i, j) of unknown vectors, and its stride. */
static long find_place(const struct hobe_model *model, enum layout layout, long i, long j)
{
    if (layout == FRONTS)
        return fronts_place(model->fronts, i, j);
    if (layout == COLUMNS)
        return pattern_scalar(&model->pattern, j, find_block(&model->pattern, i, j), 0, 0);
    const struct touched *t = &model->touched;
    return t->at[i] < 0 || t->at[j] < 0 ? -1 : 3 * (3 * t->at[j] * t->count + t->at[i]);
}

static int find_stride(const struct hobe_model *model, enum layout layout, long j)
{
    const long *start = model->pattern.start;
    return layout == FRONTS    ? fronts_stride(model->fronts, j)
           : layout == COLUMNS ? (int)(3 * (start[j + 1] - start[j]))
                               : (int)(3 * model->touched.count);
}

static enum hobe_status map_beam(const struct hobe_model *model, enum layout layout,
                                 struct beam *beam, struct hobe_error *err)
{
    const int V = beam->kernel->vectors;
    long *place = hobe_alloc((size_t)beam->spec.elements * (size_t)(V * V), sizeof *place, err);
    beam->place[layout] = place;
    if (!place)
        return HOBE_NO_MEMORY;
    for (int e = 0; e < beam->spec.elements; e++)
        for (int v = 0; v < V; v++)
            for (int w = 0; w < V; w++) {
                const long i = unknown(model, beam, e, v), j = unknown(model, beam, e, w);
                *place++ = i >= 0 && j >= 0 ? find_place(model, layout, i, j) : -1;
            }
    return HOBE_OK;
}

static enum hobe_status map_tie(const struct hobe_model *model, enum layout layout, struct tie *tie,
                                struct hobe_error *err)
{
    long *place = hobe_alloc((size_t)(tie->vectors * tie->vectors), sizeof *place, err);
    tie->place[layout] = place;
    if (!place)
        return HOBE_NO_MEMORY;
    for (int v = 0; v < tie->vectors; v++)
        for (int w = 0; w < tie->vectors; w++) {
            const long i = model->unknown[tie->vector[v]], j = model->unknown[tie->vector[w]];
            *place++ = i >= 0 && j >= 0 ? find_place(model, layout, i, j) : -1;
        }
    return HOBE_OK;
}

/* Of a reduced model. */
static enum hobe_status map_all(const struct hobe_model *model, enum layout layout,
                                struct hobe_error *err)
{
    const long n = model->unknowns;
    long *place = hobe_alloc((size_t)(n * n), sizeof *place, err);
    model->reduction->place[layout] = place;
    for (long k = 0; place && k < n * n; k++)
        place[k] = find_place(model, layout, k % n, k / n);
    return place ? HOBE_OK : HOBE_NO_MEMORY;
}

/* Where the blocks of beams, ties and springs are. */
static enum hobe_status map_blocks(struct hobe_model *model, enum layout layout,
                                   struct hobe_error *err)
{
    int *stride = hobe_alloc((size_t)model->unknowns, sizeof *stride, err);
    model->stride[layout] = stride;
    enum hobe_status status = stride ? HOBE_OK : HOBE_NO_MEMORY;
    for (long j = 0; !status && j < model->unknowns; j++)
        stride[j] = find_stride(model, layout, j);
    if (!status && model->reduction)
        status = map_all(model, layout, err);
    for (size_t b = 0; !status && b < model->beams.count; b++)
        status = map_beam(model, layout, model_beam(model, b), err);
    for (size_t i = 0; !status && i < couplings(model); i++)
        status = map_tie(model, layout, coupling(model, i), err);
    return status;
}

static void drop_place(long **place)
{
    hobe_free(*place);
    *place = NULL;
}

/* What an attempt that failed has made. */
static void drop_layout(struct hobe_model *model, enum layout layout)
{
    hobe_free(model->stride[layout]);
    model->stride[layout] = NULL;
    for (size_t b = 0; b < model->beams.count; b++)
        drop_place(model_beam(model, b)->place + layout);
    for (size_t i = 0; i < couplings(model); i++)
        drop_place(coupling(model, i)->place + layout);
    if (model->reduction)
        drop_place(model->reduction->place + layout);
}

static void drop_columns(struct hobe_model *model)
{
    drop_place(&model->pattern.Ap);
    drop_place(&model->pattern.Ai);
    drop_layout(model, COLUMNS);
}

static enum hobe_status block_columns(struct hobe_model *model, struct hobe_error *err)
{
    struct pattern *p = &model->pattern;
    p->blocks = model->unknowns;
    p->start = hobe_alloc((size_t)p->blocks + 1, sizeof *p->start, err);
    if (!p->start)
        return HOBE_NO_MEMORY;
    each_pair(model, count_pair, p);
    for (long j = 0; j < p->blocks; j++)
        p->start[j + 1] += p->start[j];
    p->row = hobe_alloc((size_t)p->start[p->blocks], sizeof *p->row, err);
    if (!p->row)
        return HOBE_NO_MEMORY;
    each_pair(model, fill_pair, p);
    tidy_columns(p);
    return HOBE_OK;
}

enum hobe_status pattern_columns(struct hobe_model *model, struct hobe_error *err)
{
    struct pattern *p = &model->pattern;
    if (model->solver)
        return HOBE_OK;
    enum hobe_status status = scalar_columns(p, err);
    if (!status)
        status = map_blocks(model, COLUMNS, err);
    if (!status)
        model->solver = hobe_linsolve_analyse(3 * p->blocks, p->Ap, p->Ai, err);
    if (!model->solver)
        drop_columns(model);
    return model->solver ? HOBE_OK : HOBE_NO_MEMORY;
}

/* Blocks of multipliers, which are numbered behind all others. */
static long multipliers(const struct hobe_model *model)
{
    long count = 0;
    for (long v = model->moving; v < model->vectors; v++)
        count += model->unknown[v] >= 0;
    return count;
}

enum hobe_status pattern_build(struct hobe_model *model, struct hobe_error *err)
{
    const struct pattern *p = &model->pattern;
    const enum hobe_status status = block_columns(model, err);
    if (status)
        return status;
    if (load_follower(model))
        return pattern_columns(model, err);
    model->fronts = fronts_analyse(p->blocks, multipliers(model), p->start, p->row, err);
    return model->fronts ? map_blocks(model, FRONTS, err) : HOBE_NO_MEMORY;
}

void pattern_mark(const struct hobe_model *model, int changing, unsigned char *touched)
{
    load_touch(model, changing, touched);
    for (size_t i = 0; i < couplings(model); i++)
        for (int v = 0; v < coupling(model, i)->vectors; v++)
            touched[coupling(model, i)->vector[v]] = 1;
    for (long v = model->beam_vectors; v < model->vectors; v++)
        touched[v] = 1;
}

enum hobe_status pattern_touch(struct hobe_model *model, struct hobe_error *err)
{
    struct touched *t = &model->touched;
    if (t->at)
        return HOBE_OK;
    unsigned char *touched = hobe_alloc((size_t)model->vectors, 1, err);
    t->vector = touched ? hobe_alloc((size_t)model->unknowns, sizeof *t->vector, err) : NULL;
    t->at = t->vector ? hobe_alloc((size_t)model->unknowns, sizeof *t->at, err) : NULL;
    if (t->at)
        pattern_mark(model, 1, touched);
    t->count = 0;
    for (long v = 0; t->at && v < model->vectors; v++)
        if (model->unknown[v] >= 0) {
            t->at[model->unknown[v]] = touched[v] ? t->count : -1;
            t->vector[t->count] = v;
            t->count += touched[v];
        }
    hobe_free(touched);
    if (t->at && !map_blocks(model, TOUCHED, err))
        return HOBE_OK;
    drop_layout(model, TOUCHED);
    drop_place(&t->vector);
    drop_place(&t->at);
    return HOBE_NO_MEMORY;
}

static size_t values(const struct hobe_model *model, enum layout layout)
{
    const size_t touched = 3 * (size_t)model->touched.count;
    return layout == FRONTS    ? fronts_size(model->fronts)
           : layout == COLUMNS ? (size_t)(9 * model->pattern.start[model->unknowns])
                               : touched * touched;
}

enum hobe_status pattern_matrix(const struct hobe_model *model, enum layout layout,
                                struct matrix *matrix, struct hobe_error *err)
{
    matrix->layout = layout;
    matrix->value = hobe_alloc(values(model, layout), sizeof *matrix->value, err);
    return matrix->value ? HOBE_OK : HOBE_NO_MEMORY;
}

void pattern_clear(const struct hobe_model *model, const struct matrix *matrix)
{
    const size_t size = values(model, matrix->layout), share = 1 << 16;
    const int threads = model->schedule.threads;
    (void)threads; /* without OpenMP */
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < size; i += share)
        memset(matrix->value + i, 0, (size - i < share ? size - i : share) * sizeof(double));
}

void pattern_add_block(const struct hobe_model *model, long place, long vector,
                       const double block[3][3], const struct matrix *A)
{
    if (place < 0)
        return;
    const int stride = model->stride[A->layout][model->unknown[vector]];
    for (int c = 0; c < 3; c++)
        for (int a = 0; a < 3; a++)
            A->value[place + c * stride + a] += block[a][c];
}

void pattern_add_element(const struct hobe_model *model, const struct beam *beam, int e, int v,
                         int w, const double block[3][3], const struct matrix *A)
{
    const int V = beam->kernel->vectors;
    pattern_add_block(model, beam->place[A->layout][((long)e * V + v) * V + w],
                      model_vector(model, beam, e, w), block, A);
}

void pattern_to_fronts(const struct hobe_model *model, const double *Ax, double *fronts)
{
    const struct pattern *p = &model->pattern;
    pattern_clear(model, &(struct matrix){FRONTS, fronts});
    for (long j = 0; j < p->blocks; j++)
        for (long b = p->start[j]; b < p->start[j + 1]; b++) {
            const long at = fronts_place(model->fronts, p->row[b], j);
            for (int c = 0; at >= 0 && c < 3; c++)
                memcpy(fronts + at + c * model->stride[FRONTS][j],
                       Ax + pattern_scalar(p, j, b, 0, c), 3 * sizeof *Ax);
        }
}

void pattern_add(const struct hobe_model *model, double factor, const struct matrix *B,
                 const struct matrix *A)
{
    const size_t size = values(model, A->layout);
    for (size_t i = 0; i < size; i++)
        A->value[i] += factor * B->value[i];
}

/* Of the diagonals, 0 where they are. */
static void scale_columns(const struct pattern *p, const double *Ax, double *scale)
{
    for (long j = 0; j < 3 * p->blocks; j++) {
        scale[j] = 0;
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            if (p->Ai[k] == j && Ax[k] != 0)
                scale[j] = 1 / sqrt(fabs(Ax[k]));
    }
}

/* And of the rows without one, by the scale of the others. */
static void scale_border(const struct pattern *p, const double *Ax, double *scale)
{
    for (long j = 0; j < 3 * p->blocks; j++) {
        double largest = 0;
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            largest = fmax(largest, scale[p->Ai[k]] * fabs(Ax[k]));
        if (scale[j] == 0)
            scale[j] = largest > 0 ? 1 / largest : 1;
    }
}

void pattern_scale(const struct hobe_model *model, const struct matrix *A, double *scale)
{
    if (A->layout == FRONTS)
        fronts_scale(model->fronts, A->value, scale);
    else
        scale_columns(&model->pattern, A->value, scale);
    if (model->reduction)
        reduction_scale(model, scale);
    else
        body_scale(model, scale);
    if (A->layout == FRONTS)
        fronts_scale_border(model->fronts, A->value, scale);
    else
        scale_border(&model->pattern, A->value, scale);
}
