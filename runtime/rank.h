/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rank of a sparse matrix whose rows come one by one: which of them depend on earlier ones. */
#ifndef HOBE_RANK_H
#define HOBE_RANK_H

#include "model.h"

struct rank {
    double *x; /* [columns] the next row */
    unsigned char
        *queued;       /* [columns] whether it may have an entry there that is not seen to yet */
    long *row_of;      /* [columns] 1 + the reduced row with its pivot there, 0: none */
    struct list queue; /* long: columns of the next row, repeats included */
    struct list row, part; /* reduced rows, and their entries */
    int failed;            /* no memory */
};

enum hobe_status rank_open(struct rank *rank, long columns, struct hobe_error *err);
void rank_close(struct rank *rank);

/* Adds to an entry of the next row, which begins with zeros. */
void rank_put(struct rank *rank, long column, double value);

/* Takes the row; *independent: whether it is no combination of earlier ones, to rounding. */
enum hobe_status rank_add(struct rank *rank, int *independent, struct hobe_error *err);

#endif
