/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The benchmarks' baselines are what they say: the force and tangent of the same element by other
 * roads.  And the race they run in counts right. */
#include "bench.h"
#include "check.h"

#include <string.h>

/* Each element against its baselines: algebra in another order, 1e-12 of the largest entry, and a
 * digit less for eq. 28, which as printed sums products of positions that cancel. */
static void test_baselines(void)
{
    int points = 0, printed = 0;
    for (int i = 0; hobe_kernels()[i]; i++) {
        const struct hobe_kernel *kernel = hobe_kernels()[i];
        struct bench_difference difference;
        struct hobe_error err;
        if (bench_compare(kernel, &difference, &err))
            check_stop("%s: %s", kernel->name, err.message);
        check_that(difference.points <= 1e-12, "%s: points, %g", kernel->name, difference.points);
        check_that(difference.printed <= 1e-11, "%s: eq. 28, %g", kernel->name, difference.printed);
        points += difference.points > 0;
        printed += difference.printed > 0;
        check_that((difference.points > 0) == (strcmp(kernel->mechanics, "structural") != 0),
                   "%s: points for every continuum", kernel->name);
        check_that((difference.printed > 0) ==
                       (difference.points > 0 && kernel->vectors <= BENCH_TENSOR_VECTORS),
                   "%s: eq. 28 for few vectors", kernel->name);
    }
    check_that(points > 0 && printed > 0, "some elements have baselines");
}

/* Flops are what the baselines are said to cost: of a turn, an element, its tangent. */
static void test_flops(void)
{
    const struct bench_tensors t = {.vectors = 2};
    check_absolute(points_flops(2, 3, 0), 3 * (36 * 2 + 129), 0, "points, force");
    check_absolute(points_flops(2, 3, 1), 3 * (36 * 2 + 129 + 105 * 2 + 3 * 122), 0,
                   "points, tangent");
    check_absolute(bench_printed_flops(&t, 0), 4 * (8 + 4 + 12), 0, "eq. 27");
    check_absolute(bench_printed_flops(&t, 1), 4 * (8 + 4 + 12) + 3 * (21 * 4 + 3), 0, "eq. 28");
}

/* ---- races ---------------------------------------------------------------------------------- */

static void count(void *context)
{
    ++*(long *)context;
}

/* What a race says of samples that are known. */
static void test_statistics(void)
{
    double a[] = {3, 1, 2, 5, 4}, b[] = {1, 1, 1, 5, 1};
    const struct bench_work first = {.rounds = 5, .sample = a}, second = {.rounds = 5, .sample = b};
    const struct bench_time time = bench_time(&first);
    check_absolute(time.least, 1, 0, "least");
    check_absolute(time.median, 3, 0, "median");
    check_absolute(time.spread, 2.0 / 3, 1e-15, "quartiles 2 and 4 over 3");
    check_absolute(bench_ratio(&first, &second), 2, 0, "median of 3 1 2 1 4");
}

static void test_race(void)
{
    long calls[2] = {0, 0};
    struct hobe_error err;
    struct bench_work work[2] = {{.run = count, .context = calls},
                                 {.run = count, .context = calls + 1}};
    check_that(bench_race(work, 2, 1e-3, &err) == HOBE_OK, "a race");
    for (int i = 0; i < 2; i++) {
        check_that(work[i].rounds >= 3, "at least three rounds");
        check_that(calls[i] >= work[i].rounds * work[i].calls, "as many calls as said");
        check_that(bench_time(work + i).least > 0, "that take time");
    }
    bench_free_samples(work, 2);
}

int main(void)
{
    test_baselines();
    test_flops();
    test_statistics();
    test_race();
    return check_report();
}
