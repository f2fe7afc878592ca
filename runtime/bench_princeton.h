/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The beam that scenes of benchmarks are made of: that of Princeton's experiments (Tang, Tian & Hu
 * 2022, Table 5 and section 5.1). */
#ifndef HOBE_BENCH_PRINCETON_H
#define HOBE_BENCH_PRINCETON_H

#include "bench.h"
#include "solver.h"

#define BENCH_PRINCETON_LENGTH 0.508 /* m */

/* Its rectangle, with warping; the caller frees it. */
hobe_section *bench_princeton_section(struct hobe_error *err);

/* Adds it as "beam" along x, in aluminium, of a length in m. */
enum hobe_status bench_princeton_beam(hobe_model *model, const struct hobe_kernel *kernel,
                                      int elements, double length, const hobe_section *section,
                                      struct hobe_error *err);

/* An iteration of Newton's method from the reference, where it leaves the solver. */
enum hobe_status bench_iterate(struct solver *solver, struct hobe_error *err);

/* Elements of meshes of about equal size, by the nodes of one (Table 5). */
int bench_princeton_mesh(const struct hobe_kernel *kernel);

#endif
