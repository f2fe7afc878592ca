/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections of any outline, with the paper's closed forms on rectangles where there are some. */
#ifndef HOBE_SECTION_OUTLINE_H
#define HOBE_SECTION_OUTLINE_H

#include "section.h"

enum { HOBE_MAX_PARTS = 4 };

/* A rectangle of the section with its branch of the paper's w = y (a z + b). */
struct hobe_part {
    double y, z, width, height; /* centre and size, m */
    double a, b;                /* -, m */
};
struct hobe_parts {
    int count;
    struct hobe_part part[HOBE_MAX_PARTS];
};

/* A section with the outline hobe_section_polygon takes; `parts` (may be NULL) about its centroid.
 * The caller writes text. */
hobe_section *hobe_section_outline(int loops, const int *points, const double (*point)[2],
                                   const struct hobe_parts *parts, enum hobe_warping warping,
                                   struct hobe_error *err);

/* Triangles of its mesh. */
int hobe_section_triangles(const hobe_section *section);

#endif
