/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rank of a matrix whose rows come one by one: which of them depend on earlier ones. */
#ifndef HOBE_RANK_H
#define HOBE_RANK_H

#include "model.h"

struct rank {
    long columns;
    double *x;             /* [columns] the next row, to be set; zero again after rank_add */
    unsigned char *pivot;  /* [columns] whether some row has its pivot there */
    struct list row, part; /* reduced rows, and their entries other than zero */
};

enum hobe_status rank_open(struct rank *rank, long columns, struct hobe_error *err);
void rank_close(struct rank *rank);

/* Adds the row x; *independent: whether it is no combination of earlier ones, to rounding. */
enum hobe_status rank_add(struct rank *rank, int *independent, struct hobe_error *err);

#endif
