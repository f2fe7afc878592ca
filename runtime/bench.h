/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `hobe bench`: what elements and scenes cost on this machine, beside its peak and beside baselines
 * that stay as they are. */
#ifndef HOBE_BENCH_H
#define HOBE_BENCH_H

#include "bench_baseline.h"
#include "bench_clock.h"
#include "output.h"

/* A result.  Texts live as long as the program. */
struct bench_row {
    const char *kind;    /* "machine", "kernel", "baseline", "scene",
                            "motion", "reduced" or "table 6" */
    const char *element; /* NULL where there is none, as all texts below */
    const char *section, *plan, *task;
    int taken;              /* the plan is that which hobe takes there */
    int dofs;               /* of an element, of a reduced model; 0: none */
    long elements;          /* that the time is of */
    struct bench_time time; /* of a call, s */
    double flops;           /* of a call, as counted; 0: not known */
    double peak;            /* share of the peak in the same rounds; 0: not known */
    double points, printed; /* times that the baselines take longer, in the same rounds; 0: none */
    double iterations, factors; /* of Newton's method, in a step in time; 0: none */
    double bytes; /* of memory at most, above what was there before; 0: not measured */
    double whole, offline, tensor; /* of a reduced model: times that the whole one takes longer, in
                                      the same rounds; s to make it; bytes of its energy */
};
struct bench_rows {
    struct bench_row *at; /* bench_add; freed by its owner with hobe_free */
    size_t count, room;
    int pinned; /* to one core */
};

/* A new row, to be filled; NULL with err where there is no room. */
struct bench_row *bench_add(struct bench_rows *rows, struct hobe_error *err);

/* What to measure. */
struct bench_options {
    int kernels, scenes;
    const struct hobe_kernel *const
        *kernel; /* [kernels] in races of kernels, in Table 6, in motion */
    const struct hobe_kernel *const *scene;               /* [scenes] in long beams */
    double seconds;                                       /* for each race */
    long longest;                                         /* beam, elements */
    void (*progress)(const char *what, const char *name); /* says what is timed now */
};

/* Kernels (bench_kernel.c): a race for each element and section class, on one batch. */
enum hobe_status bench_kernels(const struct bench_options *options, struct bench_rows *rows,
                               struct hobe_error *err);

/* Scenes (bench_scene.c): beams of 24 to `longest` elements; the load cases of the paper's Table 6;
 * and steps in time of a pendulum (bench_motion.c). */
enum hobe_status bench_scenes(const struct bench_options *options, struct bench_rows *rows,
                              struct hobe_error *err);
enum hobe_status bench_table6(const struct bench_options *options, struct bench_rows *rows,
                              struct hobe_error *err);
enum hobe_status bench_motions(const struct bench_options *options, struct bench_rows *rows,
                               struct hobe_error *err);

/* Newton iterations of a cantilever on few unknowns, beside those of its elements
 * (bench_reduced.c). */
enum hobe_status bench_reduced(const struct bench_options *options, struct bench_rows *rows,
                               struct hobe_error *err);

/* The largest differences of force and tangent between a kernel and the baselines of its element in
 * a strained state, relative to the kernel's largest entry; 0 where there is no baseline: they
 * exist for the form "continuum", those of eqs. 27 and 28 for up to BENCH_TENSOR_VECTORS vectors.
 */
struct bench_difference {
    double points, printed;
};
enum hobe_status bench_compare(const struct hobe_kernel *kernel,
                               struct bench_difference *difference, struct hobe_error *err);

/* ---- what is said of it (bench_report.c) ---------------------------------------------------- */

enum bench_format { BENCH_TABLE, BENCH_JSON, BENCH_CSV };

/* Appends the results: tables for people, or one table of everything. */
void bench_text(const struct bench_rows *rows, enum bench_format format, struct hobe_text *text);

/* bench.csv and the pictures kernels.png, scenes.png and reduced.png into a folder. */
enum hobe_status bench_write(const struct bench_rows *rows, const char *folder, int *drawn,
                             struct hobe_error *err);

#endif
