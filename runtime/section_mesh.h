/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outlines of sections and their meshes of quadratic triangles. */
#ifndef HOBE_SECTION_MESH_H
#define HOBE_SECTION_MESH_H

#include "error.h"

/* An outline and its holes: loop 0 runs anticlockwise, the others clockwise, so that the material
 * lies to the left of every edge.  Loop l has the points start[l] .. start[l + 1] - 1. */
struct hobe_outline {
    int loops;
    int *start;         /* [loops + 1] */
    double (*point)[2]; /* y, z, m */
};

struct hobe_mesh {
    int nodes, triangles;
    double (*node)[2];  /* y, z, m */
    int (*triangle)[6]; /* corners anticlockwise, then the middles of sides 01, 12, 20 */
};

/* Meshes a valid outline, finer near its corners.  The same outline gives the same mesh. */
enum hobe_status hobe_mesh_outline(const struct hobe_outline *outline, struct hobe_mesh *mesh,
                                   struct hobe_error *err);
void hobe_mesh_free(struct hobe_mesh *mesh);

#endif
