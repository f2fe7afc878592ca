/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A motion on its way.  Between dynamic.c and checkpoint.c only. */
#ifndef HOBE_DYNAMIC_H
#define HOBE_DYNAMIC_H

#include "history.h"

/* Where steps must end, s: at the next state to keep, INFINITY where all are, and at the next break
 * of a drive or a load; the nearest is the target, or `to`.  Of such as rounding parts it is the
 * break, after which drives go on. */
struct stops {
    double begin, store, kink, target;
    long keep; /* the state at the target */
};

struct run {
    struct genalpha g;
    struct hobe_dynamic options;
    struct account account;
    hobe_history *history;
    struct stops stops;
    double wanted;  /* longest step now, s */
    double error;   /* of the last step, relative */
    double largest; /* of all steps of this length */
    long steady;    /* how many these are */
    double started; /* on the clock */
    size_t saved;   /* states of the history that the journal has */
};

/* Writes all that the motion to come depends on, and the states since the last time, to the
 * journal, if there is one; the next step makes factors of its own, journal or not, as after
 * checkpoint_load. */
enum hobe_status checkpoint_save(struct run *run, struct hobe_error *err);

/* Takes up the motion where the journal has it.  *found: whether it has any; HOBE_BAD_INPUT where
 * that is not of this model. */
enum hobe_status checkpoint_load(struct run *run, int *found, struct hobe_error *err);

#endif
