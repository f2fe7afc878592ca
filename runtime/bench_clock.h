/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A race: works timed turn by turn, so that a noisy moment of the machine falls on all of them. */
#ifndef HOBE_BENCH_CLOCK_H
#define HOBE_BENCH_CLOCK_H

#include "error.h"

/* Something to be timed.  The caller sets the first two; the race fills the rest. */
struct bench_work {
    void (*run)(void *context); /* a call of it, which leaves it ready for the next */
    void *context;
    long calls; /* in a sample, so many that the clock's grain does not matter */
    int rounds;
    double *sample; /* [rounds] s per call; bench_free_samples frees them */
};

/* What the samples of a work say, s per call. */
struct bench_time {
    double least, median;
    double spread; /* between the quartiles, as a share of the median */
};

/* Binds the process to one processor: that it is on, unless it is bound to one already. */
enum bench_pin { BENCH_NOT_PINNED, BENCH_NOW_PINNED, BENCH_WAS_PINNED };
enum bench_pin bench_pin(void);

/* Runs the works in turn, round after round, for about so many seconds, after a warm-up in which
 * each finds its number of calls; at least three rounds however long they take. */
enum hobe_status bench_race(struct bench_work *work, int works, double seconds,
                            struct hobe_error *err);
void bench_free_samples(struct bench_work *work, int works);

/* The time of a work, after a race. */
struct bench_time bench_time(const struct bench_work *work);

/* How many times as long a takes as b: the median over the rounds of a race of both. */
double bench_ratio(const struct bench_work *a, const struct bench_work *b);

#endif
