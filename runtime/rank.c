/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaussian elimination by rows, each with its largest entry for a pivot.  Only entries other than
 * zero are kept and visited: constraints far from each other share no column. */
#include "rank.h"

#include <math.h>

/* What is left of a row, relative to it, where it depends on others: rounding, amplified. */
static const double DEPENDENT = 1e-9;

struct row { /* 1 in the column of its pivot */
    size_t first, count;
};

struct part {
    long column;
    double value;
};

enum hobe_status rank_open(struct rank *rank, long columns, struct hobe_error *err)
{
    *rank = (struct rank){0};
    rank->x = hobe_alloc((size_t)columns, sizeof *rank->x, err);
    rank->queued = hobe_alloc((size_t)columns, 1, err);
    rank->row_of = hobe_alloc((size_t)columns, sizeof *rank->row_of, err);
    return rank->x && rank->queued && rank->row_of ? HOBE_OK : HOBE_NO_MEMORY;
}

void rank_close(struct rank *rank)
{
    hobe_free(rank->x);
    hobe_free(rank->queued);
    hobe_free(rank->row_of);
    hobe_free(rank->queue.item);
    hobe_free(rank->row.item);
    hobe_free(rank->part.item);
}

void rank_put(struct rank *rank, long column, double value)
{
    rank->x[column] += value;
    if (rank->queued[column] || value == 0)
        return;
    long *next = list_append(&rank->queue, sizeof *next, NULL);
    if (next) {
        *next = column;
        rank->queued[column] = 1;
    } else
        rank->failed = 1;
}

static long queued(const struct rank *rank, size_t i)
{
    return ((const long *)rank->queue.item)[i];
}

static long largest(const struct rank *rank)
{
    long at = queued(rank, 0);
    for (size_t i = 1; i < rank->queue.count; i++)
        if (fabs(rank->x[queued(rank, i)]) > fabs(rank->x[at]))
            at = queued(rank, i);
    return at;
}

/* Takes reduced rows from the next one until it is zero in all their pivots.  It ends: a row has no
 * entry in the pivots of earlier ones. */
static void reduce(struct rank *rank)
{
    for (size_t i = 0; i < rank->queue.count; i++) {
        const long column = queued(rank, i), from = rank->row_of[column];
        const double factor = rank->x[column];
        rank->queued[column] = 0;
        if (!from || factor == 0)
            continue;
        const struct row row = ((const struct row *)rank->row.item)[from - 1];
        const struct part *part = (const struct part *)rank->part.item + row.first;
        for (size_t k = 0; k < row.count; k++)
            rank_put(rank, part[k].column, -factor * part[k].value);
        rank->x[column] = 0;
    }
}

/* Keeps the row over its pivot, and clears it. */
static void keep(struct rank *rank, long pivot)
{
    const double size = rank->x[pivot];
    const size_t first = rank->part.count;
    struct row *row = list_append(&rank->row, sizeof *row, NULL);
    for (size_t i = 0; row && i < rank->queue.count; i++) {
        double *x = rank->x + queued(rank, i);
        struct part *part = *x != 0 ? list_append(&rank->part, sizeof *part, NULL) : NULL;
        if (part)
            *part = (struct part){queued(rank, i), *x / size};
        rank->failed |= *x != 0 && !part;
        *x = 0;
    }
    if (row)
        *row = (struct row){first, rank->part.count - first};
    rank->failed |= !row;
    rank->row_of[pivot] = (long)rank->row.count;
}

enum hobe_status rank_add(struct rank *rank, int *independent, struct hobe_error *err)
{
    *independent = 0;
    if (rank->queue.count) {
        const double size = fabs(rank->x[largest(rank)]);
        reduce(rank);
        const long pivot = largest(rank);
        *independent = fabs(rank->x[pivot]) > DEPENDENT * size;
        if (*independent)
            keep(rank, pivot);
    }
    for (size_t i = 0; i < rank->queue.count; i++)
        rank->x[queued(rank, i)] = rank->queued[queued(rank, i)] = 0;
    rank->queue.count = 0;
    return rank->failed ? hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: dependent joints")
                        : HOBE_OK;
}
