/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An element prepared for evaluation.  The public part is in hobe.h. */
#ifndef HOBE_ELEMENT_H
#define HOBE_ELEMENT_H

#include "hobe.h"

/* The position of an element's last node among its vectors: elements of a beam overlap there, so
 * that element e of a beam owns the vectors e * hobe_kernel_step() + v. */
int hobe_kernel_step(const struct hobe_kernel *kernel);

/* The vector that is the value (slope = 0) or slope of a mode at a node; -1 where there is none. */
int hobe_kernel_vector(const struct hobe_kernel *kernel, int node, int mode, int slope);

#endif
