/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fronts.h"

#include "border.h"
#include "kernel.h"
#include "linsolve.h"
#include "panel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Relative to the diagonal: pivots below are rounding, or so near to it that pivoting is safer. */
static const double SMALLEST_PIVOT = 1e-14;

/* |L| |D| |L|', whose rounding is the error of K, may exceed the diagonal of K this much: where all
 * pivots are positive it equals that. */
static const double MOST_GROWTH = 1e5;

struct front {
    long first;        /* block, in the order of elimination */
    long rest;         /* where its later neighbours begin in rest[] */
    int pivots, rests; /* blocks of both */
    long panel;        /* where it begins */
    long target;       /* where what it leaves is sent: in target[] */
};

struct hobe_fronts {
    long blocks, multipliers; /* all; the last of them */
    struct border border;
    long *order, *position; /* [blocks] block at a position, position of a block */
    long *front_of;         /* [blocks] by position */
    struct front *front;
    long fronts;
    long *rest;   /* positions */
    long *target; /* of each pair x >= y of a front's rest, places in later panels */
    long size;
    double *d;      /* [3 * blocks] pivots, by position */
    double *growth; /* [3 * blocks] */
    double *x;      /* [3 * blocks] by position */
    double *v;      /* of one front */
    double *w, *room;
    const struct panel_functions *panel;
};

/* ---- structure of the factors ---------------------------------------------------------------- */

/* The rows below the diagonal of each column of L, by position. */
struct columns {
    long *start, *row; /* [blocks + 1], [start[blocks]] */
    long room;
    double cost; /* multiplications */
};

static int ascending(const void *a, const void *b)
{
    const long x = *(const long *)a, y = *(const long *)b;
    return (x > y) - (x < y);
}

/* Adds rows beyond j that are not marked with j yet. */
static void add_rows(struct columns *L, long j, const long *row, long count, const long *position,
                     long *mark)
{
    for (long k = 0; k < count; k++) {
        const long i = position ? position[row[k]] : row[k];
        if (i > j && mark[i] != j) {
            mark[i] = j;
            L->row[L->start[j + 1]++] = i;
        }
    }
}

/* Makes room for all the rows that column j can have. */
static enum hobe_status make_room(struct columns *L, long j, long most, struct hobe_error *err)
{
    const long used = L->start[j];
    if (used + most <= L->room)
        return HOBE_OK;
    const long room = 2 * L->room + most;
    long *grown = hobe_grow(L->row, (size_t)used, (size_t)room, sizeof *grown, err);
    if (!grown)
        return HOBE_NO_MEMORY;
    L->row = grown;
    L->room = room;
    return HOBE_OK;
}

/* A column has the rows of the matrix and of its children: the columns whose first row it is. */
static enum hobe_status fill_columns(struct columns *L, const hobe_fronts *f, const long *start,
                                     const long *row, long *work, struct hobe_error *err)
{
    const long n = f->blocks;
    long *mark = work, *child = work + n, *sibling = work + 2 * n; /* lists of children */
    for (long j = 0; j < 3 * n; j++)
        work[j] = -1;
    for (long j = 0; j < n; j++) {
        const long block = f->order[j], *own = row + start[block];
        const long entries = start[block + 1] - start[block];
        long most = entries;
        for (long c = child[j]; c >= 0; c = sibling[c])
            most += L->start[c + 1] - L->start[c];
        if (make_room(L, j, most, err))
            return HOBE_NO_MEMORY;
        L->start[j + 1] = L->start[j];
        add_rows(L, j, own, entries, f->position, mark);
        for (long c = child[j]; c >= 0; c = sibling[c])
            add_rows(L, j, L->row + L->start[c], L->start[c + 1] - L->start[c], NULL, mark);
        const long count = L->start[j + 1] - L->start[j];
        qsort(L->row + L->start[j], (size_t)count, sizeof *L->row, ascending);
        L->cost += (double)((count + 1) * (count + 1));
        if (count > 0) {
            const long parent = L->row[L->start[j]];
            sibling[j] = child[parent];
            child[parent] = j;
        }
    }
    return HOBE_OK;
}

static void free_columns(struct columns *L)
{
    hobe_free(L->start);
    hobe_free(L->row);
}

static enum hobe_status find_columns(struct columns *L, const hobe_fronts *f, const long *start,
                                     const long *row, struct hobe_error *err)
{
    const size_t n = (size_t)f->blocks;
    *L = (struct columns){.start = hobe_alloc(n + 1, sizeof *L->start, err)};
    long *work = L->start ? hobe_alloc(3 * n, sizeof *work, err) : NULL;
    const enum hobe_status status =
        work ? fill_columns(L, f, start, row, work, err) : HOBE_NO_MEMORY;
    hobe_free(work);
    if (status)
        free_columns(L);
    return status;
}

/* The order given or that of least degree, multipliers put to their places. */
static enum hobe_status set_order(hobe_fronts *f, int least_degree, const long *start,
                                  const long *row, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (long j = 0; j < f->blocks; j++)
        f->order[j] = j;
    if (least_degree)
        status = hobe_linsolve_order(f->blocks, start, row, f->order, err);
    if (!status && f->multipliers > 0)
        status = border_order(f->blocks - f->multipliers, f->blocks, start, row, f->order, err);
    for (long j = 0; j < f->blocks; j++)
        f->position[f->order[j]] = j;
    return status;
}

/* The order given, or that of least degree where the former makes new entries and the latter is
 * cheaper. */
static enum hobe_status choose_order(struct columns *L, hobe_fronts *f, const long *start,
                                     const long *row, struct hobe_error *err)
{
    struct columns given;
    enum hobe_status status = set_order(f, 0, start, row, err);
    if (!status)
        status = find_columns(&given, f, start, row, err);
    if (status)
        return status;
    *L = given;
    if (2 * given.start[f->blocks] + f->blocks == start[f->blocks]) /* no new entries */
        return HOBE_OK;
    status = set_order(f, 1, start, row, err);
    if (!status)
        status = find_columns(L, f, start, row, err);
    if (status || L->cost < given.cost) {
        free_columns(&given);
        return status;
    }
    free_columns(L);
    *L = given;
    status = set_order(f, 0, start, row, err);
    if (status)
        free_columns(L);
    return status;
}

/* ---- fronts ---------------------------------------------------------------------------------- */

static long rows_of(const struct front *front)
{
    return 3 * (front->pivots + front->rests);
}

static long stride_of(const struct front *front)
{
    return (rows_of(front) + PANEL_ALIGN - 1) / PANEL_ALIGN * PANEL_ALIGN;
}

/* A column goes with the one before when its rows are those of the latter, less itself. */
static int joins(const struct columns *L, long j)
{
    const long before = L->start[j] - L->start[j - 1], count = L->start[j + 1] - L->start[j];
    return before == count + 1 && L->row[L->start[j - 1]] == j;
}

static enum hobe_status gather_fronts(hobe_fronts *f, const struct columns *L,
                                      struct hobe_error *err)
{
    long rest = 0, target = 0;
    for (long j = 0; j < f->blocks; j++)
        f->fronts += j == 0 || !joins(L, j);
    f->front = hobe_alloc((size_t)f->fronts, sizeof *f->front, err);
    if (!f->front)
        return HOBE_NO_MEMORY;
    struct front *front = f->front - 1;
    for (long j = 0; j < f->blocks; j++) {
        if (j == 0 || !joins(L, j))
            (++front)->first = j;
        front->pivots++;
        front->rests = (int)(L->start[j + 1] - L->start[j]);
        f->front_of[j] = front - f->front;
    }
    for (long s = 0; s < f->fronts; s++) {
        front = f->front + s;
        front->rest = rest;
        front->target = target;
        front->panel = f->size;
        rest += front->rests;
        target += (long)front->rests * (front->rests + 1) / 2;
        f->size += 3 * front->pivots * stride_of(front);
    }
    f->size += PANEL_SLACK;
    f->rest = hobe_alloc((size_t)rest, sizeof *f->rest, err);
    f->target = hobe_alloc((size_t)target, sizeof *f->target, err);
    return f->rest && f->target ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The place of block (i, j), i >= j, by positions. */
static long place(const hobe_fronts *f, long i, long j)
{
    const struct front *front = f->front + f->front_of[j];
    long row = i - front->first;
    if (row >= front->pivots) {
        const long *rest = f->rest + front->rest;
        const long *at = bsearch(&i, rest, (size_t)front->rests, sizeof i, ascending);
        row = front->pivots + (at - rest);
    }
    return front->panel + 3 * (j - front->first) * stride_of(front) + 3 * row;
}

/* The blocks that each front leaves something to, and where they are. */
static void find_targets(hobe_fronts *f, const struct columns *L)
{
    for (long s = 0; s < f->fronts; s++) {
        const struct front *front = f->front + s;
        memcpy(f->rest + front->rest, L->row + L->start[front->first + front->pivots - 1],
               (size_t)front->rests * sizeof *f->rest);
    }
    for (long s = 0; s < f->fronts; s++) {
        const struct front *front = f->front + s;
        const long *rest = f->rest + front->rest;
        long *target = f->target + front->target;
        for (int y = 0; y < front->rests; y++)
            for (int x = y; x < front->rests; x++)
                *target++ = place(f, rest[x], rest[y]);
    }
}

/* Room for the largest front. */
static enum hobe_status make_room_for_one(hobe_fronts *f, struct hobe_error *err)
{
    long v = 0, w = 0, pivots = 0;
    for (long s = 0; s < f->fronts; s++) {
        const struct front *front = f->front + s;
        const long stride = stride_of(front), rests = 3 * front->rests * stride;
        v = stride > v ? stride : v;
        w = rests > w ? rests : w;
        pivots = front->pivots > pivots ? front->pivots : pivots;
    }
    f->v = hobe_alloc((size_t)v, sizeof *f->v, err);
    f->w = hobe_alloc((size_t)w, sizeof *f->w, err);
    f->room = hobe_alloc((size_t)(3 * pivots * PANEL_WIDE), sizeof *f->room, err);
    return f->v && f->w && f->room ? HOBE_OK : HOBE_NO_MEMORY;
}

static const struct panel_functions *choose_panel(void)
{
#ifdef HOBE_AVX2
    if (strcmp(hobe_machine(), "portable") != 0)
        return &panel_avx2;
#endif
    return &panel_portable;
}

static enum hobe_status analyse(hobe_fronts *f, const long *start, const long *row,
                                struct hobe_error *err)
{
    const size_t n = (size_t)f->blocks;
    struct columns L;
    f->panel = choose_panel();
    f->order = hobe_alloc(n, sizeof *f->order, err);
    f->position = hobe_alloc(n, sizeof *f->position, err);
    f->front_of = hobe_alloc(n, sizeof *f->front_of, err);
    f->d = hobe_alloc(3 * n, sizeof *f->d, err);
    f->growth = hobe_alloc(3 * n, sizeof *f->growth, err);
    f->x = hobe_alloc(3 * n, sizeof *f->x, err);
    if (!f->order || !f->position || !f->front_of || !f->d || !f->growth || !f->x)
        return HOBE_NO_MEMORY;
    enum hobe_status status = choose_order(&L, f, start, row, err);
    if (status)
        return status;
    status = gather_fronts(f, &L, err);
    if (!status) {
        find_targets(f, &L);
        status = make_room_for_one(f, err);
    }
    free_columns(&L);
    if (!status)
        status = border_open(&f->border, f, f->blocks - f->multipliers, f->blocks, start, row, err);
    return status;
}

hobe_fronts *fronts_analyse(long blocks, long multipliers, const long *start, const long *row,
                            struct hobe_error *err)
{
    hobe_fronts *f = hobe_alloc(1, sizeof *f, err);
    if (!f)
        return NULL;
    f->blocks = blocks;
    f->multipliers = multipliers;
    if (analyse(f, start, row, err)) {
        fronts_free(f);
        return NULL;
    }
    return f;
}

void fronts_free(hobe_fronts *f)
{
    if (!f)
        return;
    border_free(&f->border);
    hobe_free(f->order);
    hobe_free(f->position);
    hobe_free(f->front_of);
    hobe_free(f->front);
    hobe_free(f->rest);
    hobe_free(f->target);
    hobe_free(f->d);
    hobe_free(f->growth);
    hobe_free(f->x);
    hobe_free(f->v);
    hobe_free(f->w);
    hobe_free(f->room);
    hobe_free(f);
}

/* ---- values ---------------------------------------------------------------------------------- */

size_t fronts_size(const hobe_fronts *f)
{
    return (size_t)f->size;
}

long fronts_place(const hobe_fronts *f, long i, long j)
{
    return f->position[i] < f->position[j] ? -1 : place(f, f->position[i], f->position[j]);
}

int fronts_stride(const hobe_fronts *f, long j)
{
    return (int)stride_of(f->front + f->front_of[f->position[j]]);
}

void fronts_scale(const hobe_fronts *f, const double *value, double *scale)
{
    for (long s = 0; s < f->fronts; s++) {
        const struct front *front = f->front + s;
        const long stride = stride_of(front);
        for (int k = 0; k < 3 * front->pivots; k++) {
            const double diagonal = fabs(value[front->panel + k * stride + k]);
            scale[3 * f->order[front->first + k / 3] + k % 3] =
                diagonal > 0 ? 1 / sqrt(diagonal) : 1;
        }
    }
}

void fronts_scale_border(const hobe_fronts *f, const double *value, double *scale)
{
    border_scale(&f->border, value, scale);
}

/* ---- factors --------------------------------------------------------------------------------- */

/* Sends w, what a front leaves, to the panels of later ones. */
static void send_rest(const hobe_fronts *f, const struct front *front, double *value)
{
    const long stride = stride_of(front);
    const long *rest = f->rest + front->rest, *target = f->target + front->target;
    for (int y = 0; y < front->rests; y++) {
        const long to_stride = stride_of(f->front + f->front_of[rest[y]]);
        const double *from = f->w + 3 * y * stride + 3 * front->pivots;
        for (int x = y; x < front->rests; x++) {
            double *to = value + *target++;
            for (int c = 0; c < 3; c++)
                for (int a = x == y ? c : 0; a < 3; a++)
                    to[c * to_stride + a] += from[c * stride + 3 * x + a];
        }
    }
}

/* Adds what a negative pivot, scalar k of a front, makes |L| |D| |L|' exceed the diagonal of K by,
 * relative to that. */
static int grows(hobe_fronts *f, const struct front *front, const double *value, int k,
                 const double *scale)
{
    const double *l = value + front->panel + k * stride_of(front);
    const double d = f->d[3 * front->first + k];
    int grown = 0;
    for (int i = 3 * (k / 3); i < 3 * (front->pivots + front->rests); i++) {
        const int b = i / 3;
        const long at =
            b < front->pivots ? front->first + b : f->rest[front->rest + b - front->pivots];
        const double s = scale[3 * f->order[at] + i % 3];
        const double L = i == k ? 1 : l[i];
        f->growth[3 * at + i % 3] -= 2 * L * L * d * s * s;
        grown |= !(f->growth[3 * at + i % 3] < MOST_GROWTH);
    }
    return grown;
}

/* Whether the pivots of a front can be trusted. */
static int check_pivots(hobe_fronts *f, const struct front *front, const double *value,
                        const double *scale)
{
    for (int k = 0; k < 3 * front->pivots; k++) {
        const double d = f->d[3 * front->first + k];
        const double s = scale[3 * f->order[front->first + k / 3] + k % 3];
        if (!(fabs(d) * s * s > SMALLEST_PIVOT) || !isfinite(d))
            return 0;
        if (d < 0 && grows(f, front, value, k, scale))
            return 0;
    }
    return 1;
}

enum hobe_status fronts_factor(hobe_fronts *f, double *value, const double *scale)
{
    memset(f->growth, 0, (size_t)(3 * f->blocks) * sizeof *f->growth);
    border_stiffen(&f->border, value, scale);
    for (long s = 0; s < f->fronts; s++) {
        const struct front *front = f->front + s;
        const long rows = rows_of(front), columns = 3 * front->pivots, stride = stride_of(front);
        double *panel = value + front->panel, *d = f->d + 3 * front->first;
        f->panel->factor(rows, columns, stride, panel, d, f->room);
        if (!check_pivots(f, front, value, scale))
            return HOBE_SINGULAR;
        f->panel->update(rows, columns, stride, panel, d, f->w, f->room);
        send_rest(f, front, value);
    }
    return HOBE_OK;
}

long fronts_negative(const hobe_fronts *f)
{
    long negative = 0;
    for (long i = 0; i < 3 * f->blocks; i++)
        negative += f->d[i] < 0;
    return negative;
}

/* ---- solution -------------------------------------------------------------------------------- */

/* v = (x at the pivots, x at the rest or zero), zero behind. */
static void gather_front(const hobe_fronts *f, const struct front *front, int with_rest)
{
    const long pivots = 3 * front->pivots, stride = stride_of(front);
    const long *rest = f->rest + front->rest;
    memcpy(f->v, f->x + 3 * front->first, (size_t)pivots * sizeof *f->v);
    memset(f->v + pivots, 0, (size_t)(stride - pivots) * sizeof *f->v);
    for (int k = 0; with_rest && k < front->rests; k++)
        memcpy(f->v + pivots + 3 * k, f->x + 3 * rest[k], 3 * sizeof *f->v);
}

static void solve_forward(const hobe_fronts *f, const struct front *front, const double *value)
{
    const long pivots = 3 * front->pivots;
    const long *rest = f->rest + front->rest;
    gather_front(f, front, 0);
    f->panel->forward(pivots, stride_of(front), value + front->panel, f->v);
    for (long k = 0; k < pivots; k++)
        f->x[3 * front->first + k] = f->v[k] / f->d[3 * front->first + k];
    for (int k = 0; k < front->rests; k++)
        for (int a = 0; a < 3; a++)
            f->x[3 * rest[k] + a] += f->v[pivots + 3 * k + a];
}

void fronts_solve(const hobe_fronts *f, const double *value, double *x)
{
    border_load(&f->border, x);
    for (long j = 0; j < f->blocks; j++)
        memcpy(f->x + 3 * j, x + 3 * f->order[j], 3 * sizeof *x);
    for (long s = 0; s < f->fronts; s++)
        solve_forward(f, f->front + s, value);
    for (long s = f->fronts; s-- > 0;) {
        const struct front *front = f->front + s;
        gather_front(f, front, 1);
        f->panel->backward(3 * front->pivots, stride_of(front), value + front->panel, f->v);
        memcpy(f->x + 3 * front->first, f->v, (size_t)(3 * front->pivots) * sizeof *f->v);
    }
    for (long j = 0; j < f->blocks; j++)
        memcpy(x + 3 * f->order[j], f->x + 3 * j, 3 * sizeof *x);
}
