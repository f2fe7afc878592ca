/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What kernels are measured against: the peak of the machine, and two ways to an element's force
 * and tangent stiffness that take no generator, written for eight elements at a time as kernels
 * are: by points (points.h), and as eqs. 27 and 28 are printed.  They stay as they are: ratios to
 * them compare kernels of different years. */
#ifndef HOBE_BENCH_BASELINE_H
#define HOBE_BENCH_BASELINE_H

#include "points.h"
#include "section.h"

/* The integrals of eqs. 27 and 28 over those points,
 *     A_tjkv = int C_anbc H_ta H_kn H_jb H_vc dV,      b_tk = int C_anbc H_ta H_kn delta_bc dV,
 * H_va = d(N_v phi_v)/dX_a. */
struct bench_tensors {
    int vectors;
    double *A;           /* [vectors]^4 */
    double *b;           /* [vectors]^2 */
    hobe_lanes *scratch; /* [3 vectors + 2 vectors^2] */
};
enum { BENCH_TENSOR_VECTORS = 16 }; /* A in half a megabyte */

/* The flops of a turn of bench_machine.turn. */
enum { BENCH_TURN_CHAINS = 12, BENCH_TURN_STEPS = 1000 };

/* The same source compiled for one kind of processor, as kernels are.  States and results as in
 * kernel.h: q[vectors][3], f[vectors][3], K[pairs][3][3] of eight elements. */
struct bench_machine {
    const char *name; /* as hobe_machine says */
    int width;        /* doubles of a register */

    /* BENCH_TURN_STEPS steps x = a x + b of each of BENCH_TURN_CHAINS registers that do not depend
     * on one another: as many fused multiply-adds as the machine can do. */
    void (*turn)(hobe_lanes *x);

    /* The sums of eqs. 27 and 28 as they are printed, K in its lower triangle; K may be NULL. */
    void (*printed)(const struct bench_tensors *t, const hobe_lanes *q, hobe_lanes *f,
                    hobe_lanes *K);
};

/* Of the processor that the kernels in use are for. */
const struct bench_machine *bench_machine(void);

/* Flops of an element as printed, counted in the source. */
double bench_printed_flops(const struct bench_tensors *t, int tangent);

/* A section whose rule has but the Gauss points that the polynomials among the modes ask for,
 * (2 degree + 1) each way, whatever its functions: what a textbook would take.  of: a rectangle,
 * which must outlive it. */
struct bench_section {
    hobe_section base;
    const hobe_section *of;
};
void bench_section_open(struct bench_section *section, const hobe_section *of);

/* Points of a straight element with mechanics `full`, at the rule of its section: the unsplit law
 * needs no strain averaged over the section, and is the least that there is to do.  And the
 * integrals over those points. */
enum hobe_status bench_points_open(struct points *p, const hobe_element *element,
                                   const hobe_section *section, struct hobe_error *err);
enum hobe_status bench_tensors_open(struct bench_tensors *t, const struct points *p,
                                    struct hobe_error *err);
void bench_tensors_close(struct bench_tensors *t);

#endif
