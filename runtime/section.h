/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cross-sections: what a kernel needs of one.  The public part is in hobe.h. */
#ifndef HOBE_SECTION_H
#define HOBE_SECTION_H

#include "hobe.h"

/* A cubature rule that owns its points. */
struct hobe_rule {
    struct hobe_section_rule rule;
    struct hobe_section_point *point;
};

/* The rule that integrates the kernel's energy over the section, with the values of the section
 * functions that the kernel names: exact (polynomials to round-off, section functions to about
 * 1e-9), or the paper's 3 x 3 Gauss points with its own warping function.
 * HOBE_UNKNOWN when the section lacks a function. */
enum hobe_status hobe_section_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                   enum hobe_integration integration, struct hobe_rule *rule,
                                   struct hobe_error *err);

/* The rule of one point on the axis, weight A. */
enum hobe_status hobe_axis_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                enum hobe_integration integration, struct hobe_rule *rule,
                                struct hobe_error *err);

void hobe_rule_free(struct hobe_rule *rule);

/* Gauss-Legendre points and weights on [0,1]: gauss[n][2]. */
enum hobe_status hobe_gauss(int n, double (*gauss)[2], struct hobe_error *err);

#endif
