/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elements within richer ones: what is left of an element where the section drops modes. */
#ifndef HOBE_SMALLER_H
#define HOBE_SMALLER_H

#include "hobe.h"

/* Whether the one element is the other but for section modes: its nodes, its points on the axis and
 * the degree of its section polynomials are those of the richer one, and so are the vectors and the
 * axial functions of all the modes it has.  With the others held at zero both then are one function
 * of the state, as long as the section is integrated by one rule for both. */
int kernel_within(const struct hobe_kernel *small, const struct hobe_kernel *rich);

/* The element with fewest vectors of those built in that is within another and has all of its modes
 * but dropped ones, dropped[modes], on the section of a beam of that element: that itself where
 * there is none.  NULL with err set. */
const struct hobe_kernel *kernel_left(const struct hobe_beam *beam, double length,
                                      const unsigned char *dropped, struct hobe_error *err);

#endif
