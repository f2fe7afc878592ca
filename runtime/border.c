/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "border.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- order ----------------------------------------------------------------------------------- */

struct turn {
    long when, block;
};

static int earlier(const void *a, const void *b)
{
    const struct turn *x = a, *y = b;
    return x->when != y->when ? (x->when > y->when) - (x->when < y->when)
                              : (x->block > y->block) - (x->block < y->block);
}

enum hobe_status border_order(long first, long blocks, const long *start, const long *row,
                              long *order, struct hobe_error *err)
{
    struct turn *turn = hobe_alloc((size_t)blocks, sizeof *turn, err);
    if (!turn)
        return HOBE_NO_MEMORY;
    for (long k = 0; k < blocks; k++)
        turn[order[k]] = (struct turn){2 * k, order[k]};
    for (long j = first; j < blocks; j++) {
        turn[j].when = -1;
        for (long k = start[j]; k < start[j + 1] && row[k] < first; k++)
            if (turn[row[k]].when >= turn[j].when)
                turn[j].when = turn[row[k]].when + 1;
    }
    qsort(turn, (size_t)blocks, sizeof *turn, earlier);
    for (long k = 0; k < blocks; k++)
        order[k] = turn[k].block;
    hobe_free(turn);
    return HOBE_OK;
}

/* ---- places ---------------------------------------------------------------------------------- */

/* Counts the vectors that each multiplier ties, and their pairs. */
static void count_vectors(struct border *b, const long *start, const long *row)
{
    for (long m = 0; m < b->multipliers; m++) {
        const long *at = row + start[b->first + m];
        long count = 0;
        while (at + count < row + start[b->first + m + 1] && at[count] < b->first)
            count++;
        b->start[m + 1] = b->start[m] + count;
        b->pairs[m + 1] = b->pairs[m] + count * (count + 1) / 2;
    }
}

/* Sorts the vectors of a multiplier: (i, j) is in the panels where i is eliminated after j. */
static void sort_vectors(const hobe_fronts *fronts, long *vector, long count)
{
    for (long k = 1; k < count; k++)
        for (long l = k; l > 0 && fronts_place(fronts, vector[l], vector[l - 1]) < 0; l--) {
            const long later = vector[l - 1];
            vector[l - 1] = vector[l];
            vector[l] = later;
        }
}

static void find_places(struct border *b, const hobe_fronts *fronts, const long *start,
                        const long *row)
{
    for (long m = 0; m < b->multipliers; m++) {
        const long count = b->start[m + 1] - b->start[m];
        long *vector = b->vector + b->start[m], *pair = b->pair + b->pairs[m];
        memcpy(vector, row + start[b->first + m], (size_t)count * sizeof *vector);
        sort_vectors(fronts, vector, count);
        for (long j = 0; j < count; j++) {
            b->place[b->start[m] + j] = fronts_place(fronts, b->first + m, vector[j]);
            b->stride[b->start[m] + j] = fronts_stride(fronts, vector[j]);
            for (long i = j; i < count; i++)
                *pair++ = fronts_place(fronts, vector[i], vector[j]);
        }
    }
}

enum hobe_status border_open(struct border *b, const hobe_fronts *fronts, long first, long blocks,
                             const long *start, const long *row, struct hobe_error *err)
{
    const size_t multipliers = (size_t)(blocks - first);
    *b = (struct border){.first = first, .multipliers = blocks - first};
    b->start = hobe_alloc(multipliers + 1, sizeof *b->start, err);
    b->pairs = hobe_alloc(multipliers + 1, sizeof *b->pairs, err);
    b->scale = hobe_alloc(3 * multipliers, sizeof *b->scale, err);
    if (!b->start || !b->pairs || !b->scale)
        return HOBE_NO_MEMORY;
    count_vectors(b, start, row);
    const size_t vectors = (size_t)b->start[multipliers];
    b->vector = hobe_alloc(vectors, sizeof *b->vector, err);
    b->place = hobe_alloc(vectors, sizeof *b->place, err);
    b->stride = hobe_alloc(vectors, sizeof *b->stride, err);
    b->E = hobe_alloc(9 * vectors, sizeof *b->E, err);
    b->pair = hobe_alloc((size_t)b->pairs[multipliers], sizeof *b->pair, err);
    if (!b->vector || !b->place || !b->stride || !b->E || !b->pair)
        return HOBE_NO_MEMORY;
    find_places(b, fronts, start, row);
    return HOBE_OK;
}

void border_free(struct border *b)
{
    hobe_free(b->start);
    hobe_free(b->vector);
    hobe_free(b->place);
    hobe_free(b->stride);
    hobe_free(b->E);
    hobe_free(b->pairs);
    hobe_free(b->pair);
    hobe_free(b->scale);
}

/* ---- values ---------------------------------------------------------------------------------- */

void border_scale(const struct border *b, const double *value, double *scale)
{
    for (long m = 0; m < b->multipliers; m++) {
        double largest[3] = {0}, *own = scale + 3 * (b->first + m);
        for (long k = b->start[m]; k < b->start[m + 1]; k++)
            for (int c = 0; c < 3; c++)
                for (int a = 0; a < 3; a++)
                    largest[a] =
                        fmax(largest[a], scale[3 * b->vector[k] + c] *
                                             fabs(value[b->place[k] + c * b->stride[k] + a]));
        for (int a = 0; a < 3; a++)
            if (largest[a] > 0)
                own[a] = 1 / largest[a];
    }
}

/* Adds E'E of one multiplier. */
static void stiffen(const struct border *b, long m, double *value)
{
    const long *pair = b->pair + b->pairs[m];
    for (long j = b->start[m]; j < b->start[m + 1]; j++)
        for (long i = j; i < b->start[m + 1]; i++) {
            double *to = value + *pair++;
            const double *x = b->E + 9 * i, *y = b->E + 9 * j;
            for (int c = 0; c < 3; c++)
                for (int a = i == j ? c : 0; a < 3; a++)
                    to[c * b->stride[j] + a] +=
                        x[a] * y[c] + x[3 + a] * y[3 + c] + x[6 + a] * y[6 + c];
        }
}

void border_stiffen(struct border *b, double *value, const double *scale)
{
    memcpy(b->scale, scale + 3 * b->first, (size_t)(3 * b->multipliers) * sizeof *scale);
    for (long m = 0; m < b->multipliers; m++) {
        const double *D = b->scale + 3 * m;
        for (long k = b->start[m]; k < b->start[m + 1]; k++)
            for (int a = 0; a < 3; a++)
                for (int c = 0; c < 3; c++)
                    b->E[9 * k + 3 * a + c] = D[a] * value[b->place[k] + c * b->stride[k] + a];
        stiffen(b, m, value);
    }
}

void border_load(const struct border *b, double *x)
{
    for (long m = 0; m < b->multipliers; m++) {
        const double *D = b->scale + 3 * m, *g = x + 3 * (b->first + m);
        for (long k = b->start[m]; k < b->start[m + 1]; k++)
            for (int a = 0; a < 3; a++)
                for (int c = 0; c < 3; c++)
                    x[3 * b->vector[k] + c] += b->E[9 * k + 3 * a + c] * D[a] * g[a];
    }
}
