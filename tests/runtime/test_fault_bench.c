/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A benchmark in which the n-th allocation fails, for n = 1, 2, ... until it gets through. */
#include "bench.h"
#include "check.h"
#include "fault.h"

static void say_nothing(const char *what, const char *name)
{
    (void)what;
    (void)name;
}

static enum hobe_status print(const struct bench_rows *rows, struct hobe_error *err)
{
    struct hobe_text text = {0};
    for (int format = BENCH_TABLE; format <= BENCH_CSV; format++)
        bench_text(rows, (enum bench_format)format, &text);
    const enum hobe_status status = hobe_text_check(&text, err);
    hobe_text_free(&text);
    return status;
}

static enum hobe_status run(void *context, struct hobe_error *err)
{
    struct bench_rows rows = {0};
    enum hobe_status status = bench_kernels(context, &rows, err);
    if (!status)
        status = bench_scenes(context, &rows, err);
    if (!status)
        status = print(&rows, err);
    hobe_free(rows.at);
    return status;
}

int main(void)
{
    struct hobe_error err;
    const struct hobe_kernel *const kernel[] = {hobe_find_kernel("BE24", &err)};
    struct bench_options options = {.kernels = 1,
                                    .kernel = kernel,
                                    .scenes = 1,
                                    .scene = kernel,
                                    .seconds = 1e-6,
                                    .longest = 24,
                                    .progress = say_nothing};
    fail_each_allocation(run, &options, 100, 5000, "a benchmark");
    return check_report();
}
