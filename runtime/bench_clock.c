/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE
#include "bench_clock.h"

#include "model.h"

#include <sched.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST_ROUNDS = 3, MOST_ROUNDS = 999 };

/* s: a thousand times what it costs to read the clock. */
static const double SHORTEST_SAMPLE = 5e-5;

/* s: beside it, what is cold in a first call is nothing. */
static const double LONG_CALL = 0.1;

enum bench_pin bench_pin(void)
{
    const int here = sched_getcpu();
    cpu_set_t set;
    if (!sched_getaffinity(0, sizeof set, &set) && CPU_COUNT(&set) == 1)
        return BENCH_WAS_PINNED;
    if (here < 0 || here >= CPU_SETSIZE)
        return BENCH_NOT_PINNED;
    CPU_ZERO(&set);
    CPU_SET(here, &set);
    return sched_setaffinity(0, sizeof set, &set) ? BENCH_NOT_PINNED : BENCH_NOW_PINNED;
}

/* s of so many calls */
static double run(const struct bench_work *work, long calls)
{
    const double start = hobe_seconds();
    for (long i = 0; i < calls; i++)
        work->run(work->context);
    return hobe_seconds() - start;
}

/* Doubles the number of calls until they last; the time of the last sample, s.  A first call that
 * is long says enough. */
static double warm_up(struct bench_work *work)
{
    double taken = run(work, work->calls = 1);
    if (taken > LONG_CALL)
        return taken;
    while ((taken = run(work, work->calls)) < SHORTEST_SAMPLE)
        work->calls *= 2;
    return taken;
}

enum hobe_status bench_race(struct bench_work *work, int works, double seconds,
                            struct hobe_error *err)
{
    double round = 0;
    for (int i = 0; i < works; i++)
        round += warm_up(work + i);
    int rounds = seconds < MOST_ROUNDS * round ? (int)(seconds / round) : MOST_ROUNDS;
    if (rounds < FEWEST_ROUNDS)
        rounds = FEWEST_ROUNDS;
    for (int i = 0; i < works; i++) {
        work[i].rounds = rounds;
        work[i].sample = hobe_alloc((size_t)rounds, sizeof(double), err);
        if (!work[i].sample) {
            bench_free_samples(work, i);
            return HOBE_NO_MEMORY;
        }
    }
    for (int r = 0; r < rounds; r++)
        for (int i = 0; i < works; i++)
            work[i].sample[r] = run(work + i, work[i].calls) / (double)work[i].calls;
    return HOBE_OK;
}

void bench_free_samples(struct bench_work *work, int works)
{
    for (int i = 0; i < works; i++) {
        hobe_free(work[i].sample);
        work[i].sample = NULL;
    }
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The value below which the share lies of n ascending ones. */
static double quantile(const double *x, int n, double share)
{
    const double at = share * (n - 1);
    const int i = (int)at < n - 1 ? (int)at : n - 2;
    return x[i] + (at - i) * (x[i + 1] - x[i]);
}

struct bench_time bench_time(const struct bench_work *work)
{
    double sorted[MOST_ROUNDS];
    const int n = work->rounds;
    memcpy(sorted, work->sample, (size_t)n * sizeof *sorted);
    qsort(sorted, (size_t)n, sizeof *sorted, ascending);
    const double median = quantile(sorted, n, 0.5);
    return (struct bench_time){
        .least = sorted[0],
        .median = median,
        .spread = (quantile(sorted, n, 0.75) - quantile(sorted, n, 0.25)) / median,
    };
}

double bench_ratio(const struct bench_work *a, const struct bench_work *b)
{
    double ratio[MOST_ROUNDS];
    for (int r = 0; r < a->rounds; r++)
        ratio[r] = a->sample[r] / b->sample[r];
    qsort(ratio, (size_t)a->rounds, sizeof *ratio, ascending);
    return quantile(ratio, a->rounds, 0.5);
}
