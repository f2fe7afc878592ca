/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a section of any outline holds; for section_outline.c, and for section_moving.c, which takes
 * it along a beam. */
#ifndef HOBE_SECTION_SHAPE_H
#define HOBE_SECTION_SHAPE_H

#include "outline.h"
#include "section_outline.h"
#include "section_taper.h"

struct shape {
    struct hobe_section base;
    struct hobe_outline *outline; /* [base.regions], about the centroid */
    struct hobe_mesh mesh;
    double *values; /* of the functions, [HOBE_SECTION_FUNCTIONS][mesh.nodes] */
    struct hobe_rule functions_rule;
    struct hobe_parts parts;
    int paper;                    /* w is the parts' */
    _Atomic(double *) distortion; /* [HOBE_DISTORTIONS][mesh.nodes] once asked for, of who solved */
    double wall_bending;          /* hobe_section_wall_bending, where those are there */
    const hobe_section *shared;   /* all that is pointed to belongs to this section; or NULL */
};

/* A shape with like's outline at other points, about their centroid; not solved. */
struct shape *hobe_shape_like(const struct shape *like, const double *numbers,
                              struct hobe_error *err);

/* Solves the functions on the shape's mesh: values, their rule, and J from the polar moment. */
enum hobe_status hobe_shape_solve(struct shape *s, struct hobe_error *err);

extern const struct hobe_section_field hobe_shape_field; /* section_moving.c */

#endif
