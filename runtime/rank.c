/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaussian elimination by rows, each with its largest entry for a pivot.  Reduced rows are kept
 * sparse: constraints far from each other share no column. */
#include "rank.h"

#include <math.h>
#include <string.h>

/* What is left of a row, relative to it, where it depends on others: rounding, amplified. */
static const double DEPENDENT = 1e-9;

struct row {
    long pivot; /* column, where the row is 1 */
    size_t first, count;
};

struct part {
    long column;
    double value;
};

enum hobe_status rank_open(struct rank *rank, long columns, struct hobe_error *err)
{
    *rank = (struct rank){.columns = columns};
    rank->x = hobe_alloc((size_t)columns, sizeof *rank->x, err);
    rank->pivot = hobe_alloc((size_t)columns, 1, err);
    return rank->x && rank->pivot ? HOBE_OK : HOBE_NO_MEMORY;
}

void rank_close(struct rank *rank)
{
    hobe_free(rank->x);
    hobe_free(rank->pivot);
    hobe_free(rank->row.item);
    hobe_free(rank->part.item);
}

static long largest(const struct rank *rank)
{
    long at = 0;
    for (long j = 1; j < rank->columns; j++)
        if (fabs(rank->x[j]) > fabs(rank->x[at]))
            at = j;
    return at;
}

static void reduce(struct rank *rank)
{
    const struct row *row = rank->row.item;
    const struct part *part = rank->part.item;
    for (size_t i = 0; i < rank->row.count; i++) {
        const double factor = rank->x[row[i].pivot];
        for (size_t k = row[i].first; factor != 0 && k < row[i].first + row[i].count; k++)
            rank->x[part[k].column] -= factor * part[k].value;
    }
}

static enum hobe_status keep(struct rank *rank, long pivot, struct hobe_error *err)
{
    struct row *row = list_append(&rank->row, sizeof *row, err);
    if (!row)
        return HOBE_NO_MEMORY;
    *row = (struct row){pivot, rank->part.count, 0};
    for (long j = 0; j < rank->columns; j++) {
        struct part *part = rank->x[j] != 0 ? list_append(&rank->part, sizeof *part, err) : NULL;
        if (part)
            *part = (struct part){j, rank->x[j] / rank->x[pivot]};
        else if (rank->x[j] != 0)
            return HOBE_NO_MEMORY;
    }
    row->count = rank->part.count - row->first;
    rank->pivot[pivot] = 1;
    return HOBE_OK;
}

enum hobe_status rank_add(struct rank *rank, int *independent, struct hobe_error *err)
{
    const double size = fabs(rank->x[largest(rank)]);
    reduce(rank);
    const long pivot = largest(rank);
    *independent = fabs(rank->x[pivot]) > DEPENDENT * size;
    const enum hobe_status status = *independent ? keep(rank, pivot, err) : HOBE_OK;
    memset(rank->x, 0, (size_t)rank->columns * sizeof *rank->x);
    return status;
}
