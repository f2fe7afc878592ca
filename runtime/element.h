/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An element prepared for evaluation.  The public part is in hobe.h. */
#ifndef HOBE_ELEMENT_H
#define HOBE_ELEMENT_H

#include "hobe.h"

/* The position of an element's last node among its vectors: elements of a beam overlap there, so
 * that element e of a beam owns the vectors e * hobe_kernel_step() + v. */
int hobe_kernel_step(const struct hobe_kernel *kernel);

/* Reference nodal vectors q0[vectors][3] of a straight element of that length, its first node at
 * the origin, on the axes frame[3] = e_x, e_y, e_z (rows). */
void hobe_kernel_reference(const struct hobe_kernel *kernel, double length,
                           const double frame[3][3], double *q0);

/* The vector that is the value (slope = 0) or slope of a mode at a node; -1 where there is none. */
int hobe_kernel_vector(const struct hobe_kernel *kernel, int node, int mode, int slope);

/* Whether force and tangent of a straight and prismatic element are cheaper as products with its
 * tensor than from station to station, with that symmetry (HOBE_SYMMETRIC_*). */
int hobe_tensor_pays(const struct hobe_kernel *kernel, int symmetry);

/* Of the element's section, which does not vary: EA, N, and EI,
 * N m^2. */
struct stiffnesses {
    double EA, EIyy, EIzz, EIyz;
};
void hobe_element_stiffnesses(const hobe_element *element, struct stiffnesses *stiffnesses);

/* The elastic law per length that the element was made with, owned by it. */
const struct hobe_law *hobe_element_law(const hobe_element *element);

#endif
