/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An element prepared for evaluation.  The public part is in hobe.h. */
#ifndef HOBE_ELEMENT_H
#define HOBE_ELEMENT_H

#include "hobe.h"

/* Whether force, or force and tangent, of a straight and prismatic element are cheaper as products
 * with its tensor than from station to station, with that symmetry (HOBE_SYMMETRIC_*): by counted
 * operations, of which those with a tensor run so many times as fast.  A tensor takes time to fill:
 * one of the two must gain HOBE_TENSOR_WORTH times. */
#define HOBE_TENSOR_WORTH 1.3
int hobe_tensor_pays(const struct hobe_kernel *kernel, int symmetry, int tangent);

/* That factor, as `hobe bench` measures it (AVX-512): loops over stations have shorter trips, which
 * costs them 1.5 to 2.4 times for the force and 1.7 to 2.2 for both, while the tensor stays in a
 * core's cache.  Where it is larger every batch reads it from memory, a number for two operations
 * of the force and a number for ten of the tangent: 0.7 and 1 of a busy machine are better than to
 * have won a tenth on a quiet one. */
double hobe_tensor_speed(const struct hobe_kernel *kernel, int symmetry, int tangent);

/* Force and tangent of a batch of such elements as in kernel.h, by the element's plan; and how many
 * hobe_lanes of scratch they take of elements of a kernel, as all of a kernel's functions do. */
void hobe_element_batch_force(const hobe_element *element, const hobe_lanes *q0,
                              const hobe_lanes *u, hobe_lanes *f, hobe_lanes *scratch);
void hobe_element_batch_tangent(const hobe_element *element, const hobe_lanes *q0,
                                const hobe_lanes *u, hobe_lanes *f, hobe_lanes *K,
                                hobe_lanes *scratch);
size_t hobe_element_scratch(const struct hobe_kernel *kernel);

/* Whether that is by its tensor: of force alone, or of force and tangent. */
int hobe_element_by_tensor(const hobe_element *element, int tangent);

/* Of the element's section, which does not vary: EA, N, and EI,
 * N m^2. */
struct stiffnesses {
    double EA, EIyy, EIzz, EIyz;
};
void hobe_element_stiffnesses(const hobe_element *element, struct stiffnesses *stiffnesses);

/* The elastic law per length that the element was made with, owned by it. */
const struct hobe_law *hobe_element_law(const hobe_element *element);

#endif
