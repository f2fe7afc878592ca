/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a section of any outline holds, between the rooms that make, solve and use it. */
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

/* The section that holds the fields: s itself, or the one whose solution it shares. */
static inline struct shape *shape_owner(const struct shape *s)
{
    return (struct shape *)(s->shared ? s->shared : &s->base);
}

/* A section of that many outlines, all empty still, which hobe_section_free frees; NULL with err.
 */
struct shape *shape_new(int regions, struct hobe_error *err);

/* A section with a text of its own that shares all else with those of the same content; NULL with
 * err.  s, which has its outlines, is solved here if need be and belongs to the result. */
hobe_section *shape_share(struct shape *s, struct hobe_error *err);

/* ---- properties (section_shape.c) ----------------------------------------------------------- */

/* Area, and the outlines about their centroid, weighted with E. */
void shape_set_area(struct shape *s);

/* Extent, and probes among the points of the outlines. */
void shape_set_extent(struct shape *s);

/* Both, mesh, functions and all that needs them; of a section that is a shape. */
enum hobe_status shape_set_properties(hobe_section *section, struct hobe_error *err);

/* ---- cubature (section_cubature.c) ---------------------------------------------------------- */

/* As a kind of section has it (section.h). */
enum hobe_status shape_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                            enum hobe_integration integration, struct hobe_rule *rule,
                            struct hobe_error *err);

/* A rule for polynomials of degree 2 n - 2. */
enum hobe_status shape_fan_rule(const struct shape *shape, int n, struct hobe_rule *rule,
                                struct hobe_error *err);

/* gauss[n]: points and weights on [0, 1]; HOBE_BAD_INPUT for more than MOST_GAUSS. */
enum { MOST_GAUSS = 64 };
enum hobe_status shape_gauss(int n, double (*gauss)[2], struct hobe_error *err);

/* ---- the paper's parts (section_parts.c) ---------------------------------------------------- */

/* n x n Gauss points on each rectangle, with w there. */
enum hobe_status parts_rule(const struct hobe_parts *parts, int n, struct hobe_rule *rule,
                            struct hobe_error *err);

/* f[3] = w and its derivatives by y and z, of the nearest rectangle. */
void parts_warping(const struct hobe_parts *parts, double y, double z, double *f);

/* s->mesh, whose triangles end at the seams of the parts, where w has another branch. */
enum hobe_status parts_mesh(struct shape *s, struct hobe_error *err);

/* ---- along a beam --------------------------------------------------------------------------- */

/* A shape with like's outline at other points, about their centroid; not solved. */
struct shape *shape_like(const struct shape *like, const double *numbers, struct hobe_error *err);

/* Solves the functions on the shape's mesh: values, their rule, and J from the polar moment. */
enum hobe_status shape_solve(struct shape *s, struct hobe_error *err);

extern const struct hobe_section_field hobe_shape_field; /* section_moving.c */

#endif
