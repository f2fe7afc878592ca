/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hobe bench: the command line of the benchmarks. */
#define _GNU_SOURCE
#include "bench.h"
#include "main.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double SECONDS = 0.5, QUICK_SECONDS = 0.05;
static const char *const QUICK_ELEMENTS = "3333,MGD30w,34X3", *const LONG_ELEMENTS = "MGD30w";
static const long LONGEST = 10000, QUICK_LONGEST = 1000, LARGE_LONGEST = 100000;

struct arguments {
    const char *folder, *elements; /* names, apart by commas */
    enum hobe_lua_format format;
    int quick, large;
    double seconds; /* 0: not given */
};

static int read_seconds(const char *text, double *seconds)
{
    char *end;
    *seconds = strtod(text, &end);
    if (end != text && *end == '\0' && *seconds > 0 && *seconds <= 3600)
        return 0;
    return complain_usage("--seconds must be a number > 0, at most 3600, got \"%.100s\"", text);
}

/* Reads argv[*i]; 0, or the exit status after a complaint. */
static int read_argument(struct arguments *to, char **argv, int *i)
{
    const char *value;
    if ((value = option(argv, i, "--out")))
        to->folder = value;
    else if ((value = option(argv, i, "--format")))
        return read_format(value, &to->format);
    else if ((value = option(argv, i, "--element")))
        to->elements = value;
    else if ((value = option(argv, i, "--seconds")))
        return read_seconds(value, &to->seconds);
    else if (!strcmp(argv[*i], "--quick"))
        to->quick = 1;
    else if (!strcmp(argv[*i], "--large"))
        to->large = 1;
    else
        return complain_usage("unknown option or missing value: %.100s (see hobe help)", argv[*i]);
    return 0;
}

/* ---- which elements ------------------------------------------------------------------------- */

/* A list of kernels, ended by NULL as the built-in one is; freed by the caller. */
struct kernels {
    const struct hobe_kernel **at;
    int count;
};

static enum hobe_status add_kernel(struct kernels *to, const char *name, size_t size,
                                   struct hobe_error *err)
{
    char copy[100];
    snprintf(copy, sizeof copy, "%.*s", (int)size, name);
    const struct hobe_kernel *kernel = hobe_find_kernel(copy, err);
    if (!kernel)
        return err->status;
    for (int i = 0; i < to->count; i++)
        if (to->at[i] == kernel)
            return HOBE_OK;
    to->at[to->count++] = kernel;
    return HOBE_OK;
}

/* The kernels of these names, each once; all where names is NULL. */
static enum hobe_status find_kernels(const char *names, struct kernels *to, struct hobe_error *err)
{
    int all = 0;
    while (hobe_kernels()[all])
        all++;
    *to = (struct kernels){hobe_alloc((size_t)all, sizeof *to->at, err), 0};
    enum hobe_status status = to->at ? HOBE_OK : HOBE_NO_MEMORY;
    for (int i = 0; !status && !names && i < all; i++)
        to->at[to->count++] = hobe_kernels()[i];
    for (const char *name = names; !status && name;) {
        const size_t size = strcspn(name, ",");
        status = add_kernel(to, name, size, err);
        name = name[size] ? name + size + 1 : NULL;
    }
    return status;
}

/* ---- the run -------------------------------------------------------------------------------- */

/* A line on the terminal that the next one overwrites. */
static void show_progress(const char *what, const char *name)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%s %s", what, name);
}

static enum hobe_status measure(const struct bench_options *options, struct bench_rows *rows,
                                struct hobe_error *err)
{
    enum hobe_status status = bench_kernels(options, rows, err);
    if (!status)
        status = bench_scenes(options, rows, err);
    if (!status)
        status = bench_table6(options, rows, err);
    if (!status)
        status = bench_motions(options, rows, err);
    if (!status)
        status = bench_reduced(options, rows, err);
    show_progress("", "");
    return status;
}

/* Files first, so that a folder that cannot be written leaves no result on standard output. */
static int tell(const struct bench_rows *rows, const struct arguments *arguments)
{
    struct hobe_error err;
    struct hobe_text text = {0};
    int drawn = 1;
    if (arguments->folder && bench_write(rows, arguments->folder, &drawn, &err))
        return complain(err.message, 1);
    if (!drawn)
        complain("gnuplot is not installed: pictures not drawn", 0);
    bench_text(rows, (enum bench_format)arguments->format, &text);
    return print_text(&text);
}

static int run(const struct arguments *arguments, const struct kernels *kernels,
               const struct kernels *scenes)
{
    struct hobe_error err;
    struct bench_rows rows = {.pinned = bench_pin() != BENCH_NOT_PINNED};
    const struct bench_options options = {
        .kernels = kernels->count,
        .kernel = kernels->at,
        .scenes = scenes->count,
        .scene = scenes->at,
        .seconds = arguments->seconds > 0 ? arguments->seconds
                   : arguments->quick     ? QUICK_SECONDS
                                          : SECONDS,
        .longest = arguments->large   ? LARGE_LONGEST
                   : arguments->quick ? QUICK_LONGEST
                                      : LONGEST,
        .progress = show_progress,
    };
    const int status =
        measure(&options, &rows, &err) ? complain(err.message, 1) : tell(&rows, arguments);
    hobe_free(rows.at);
    return status;
}

int command_bench(int argc, char **argv)
{
    struct arguments arguments = {0};
    struct hobe_error err;
    struct kernels kernels = {0}, scenes = {0};
    for (int i = 2; i < argc; i++) {
        const int status = read_argument(&arguments, argv, &i);
        if (status)
            return status;
    }
    /* Libraries counted the processors when they were loaded: once more, with one. */
    if (bench_pin() == BENCH_NOW_PINNED)
        execv("/proc/self/exe", argv);
    const char *names = arguments.elements, *quick = arguments.quick ? QUICK_ELEMENTS : NULL;
    int status;
    if (arguments.folder && hobe_make_folder(arguments.folder, &err))
        status = complain(err.message, 1);
    else if (find_kernels(names ? names : quick, &kernels, &err) ||
             find_kernels(names ? names : LONG_ELEMENTS, &scenes, &err))
        status = complain(err.message, 1);
    else
        status = run(&arguments, &kernels, &scenes);
    hobe_free(kernels.at);
    hobe_free(scenes.at);
    return status;
}
