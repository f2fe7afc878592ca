/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of a benchmark in which the n-th allocation fails, for n = 1, 2, ... until they get
 * through. */
#include "bench.h"
#include "bench_subject.h"
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

/* Batches, straight and curved. */
static enum hobe_status open_subjects(const struct hobe_kernel *kernel, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int c = 0; !status && c < BENCH_CLASSES; c += 2) {
        struct bench_subject subject;
        status = bench_subject_open(&subject, kernel, bench_classes + c, err);
        bench_subject_close(&subject);
    }
    return status;
}

static enum hobe_status run(void *context, struct hobe_error *err)
{
    const struct bench_options *options = context;
    struct bench_rows rows = {0};
    struct bench_difference difference;
    enum hobe_status status = open_subjects(options->scene[0], err);
    if (!status)
        status = bench_compare(options->scene[0], &difference, err);
    if (!status)
        status = bench_scenes(options, &rows, err);
    if (!status)
        status = print(&rows, err);
    hobe_free(rows.at);
    return status;
}

int main(void)
{
    struct hobe_error err;
    const struct hobe_kernel *const kernel[] = {hobe_find_kernel("BE24", &err)};
    struct bench_options options = {
        .scenes = 1, .scene = kernel, .seconds = 1e-6, .longest = 24, .progress = say_nothing};
    fail_each_allocation(run, &options, 100, 2000, "a benchmark");
    return check_report();
}
