/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams as solids: what a file for other programs holds. */
#ifndef HOBE_SOLID_H
#define HOBE_SOLID_H

#include "hobe.h"

enum { HOBE_WEDGE = 18 }; /* nodes of a wedge that is quadratic in all directions */

/* Wedges between sections.  Of a wedge come first the corners, 0 1 2 of its first triangle and 3 4
 * 5 of the one further along the beam, anticlockwise seen against the beam's axis; then the middles
 * of the sides 01, 12, 20, 34, 45, 53, 03, 14, 25 and those of the faces 0143, 1254, 2035. */
struct hobe_solid {
    int points, cells;
    double (*point)[3];         /* [points] in the reference, m */
    double (*displacement)[3];  /* [points] m, or of a mode 1/sqrt(kg) */
    struct hobe_stress *stress; /* [points]; NULL: of a mode, or where a beam has none */
    int (*cell)[HOBE_WEDGE];    /* [cells] */
};

/* All beams of a state: two layers of wedges in each element, as fine across as pictures are; at
 * ends of elements the stress is that of the element beyond, at seams of composite sections that of
 * either side. */
enum hobe_status hobe_solution_solid(const hobe_solution *solution, struct hobe_solid *solid,
                                     struct hobe_error *err);

/* The same of mode i, without stress. */
enum hobe_status hobe_modes_solid(const hobe_modes *modes, int i, struct hobe_solid *solid,
                                  struct hobe_error *err);

void hobe_solid_free(struct hobe_solid *solid);

#endif
