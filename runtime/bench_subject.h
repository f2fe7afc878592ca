/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A batch of eight elements, strained, for a kernel to be timed or tried on. */
#ifndef HOBE_BENCH_SUBJECT_H
#define HOBE_BENCH_SUBJECT_H

#include "hobe.h"

/* Sections and axes that kernels treat differently. */
struct bench_class {
    const char *name;
    hobe_section *(*make)(struct hobe_error *err);
    int curved;
};
enum { BENCH_CLASSES = 4 };
extern const struct bench_class
    bench_classes[BENCH_CLASSES]; /* rectangle, straight; angle; arc; taper */

/* One of the kernel's ways to force and tangent: which it takes is decided by the invariants. */
struct bench_plan {
    const char *name;
    int taken[2]; /* by hobe for such an element: for force; for force and tangent */
    struct hobe_invariants inv;
    double flops[2]; /* of an element, force; force and tangent; 0: not counted */
};
enum { BENCH_PLANS = 2 };

struct bench_subject {
    const struct hobe_kernel *kernel;
    int plans;
    struct bench_plan plan[BENCH_PLANS];
    int count;                           /* elements in the batch: those that share the law */
    const hobe_lanes *q0;                /* [vectors][3] */
    hobe_lanes *u, *q, *f, *K, *scratch; /* q = q0 + u; results as in kernel.h */

    /* what that belongs to */
    hobe_section *section;
    hobe_curve *curve;
    hobe_model *model;
    hobe_element *element;
    hobe_lanes *own_q0;
    double *tensor;
};

/* The first batch of a beam of eight elements.  bench_subject_close frees it even after a failure.
 */
enum hobe_status bench_subject_open(struct bench_subject *s, const struct hobe_kernel *kernel,
                                    const struct bench_class *class, struct hobe_error *err);

/* One straight element of a section (kept by the caller) with mechanics `full` in all lanes. */
enum hobe_status bench_subject_full(struct bench_subject *s, const struct hobe_kernel *kernel,
                                    const hobe_section *section, struct hobe_error *err);
void bench_subject_close(struct bench_subject *s);

#endif
