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
    int *region;        /* [triangles] the outline a triangle lies in */
};

/* Meshes valid outlines, outline[parts], finer near their corners; triangles share the edges where
 * outlines touch.  The same outlines give the same mesh.  One sentence when two overlap. */
enum hobe_status hobe_mesh_outlines(int parts, const struct hobe_outline *outline,
                                    struct hobe_mesh *mesh, struct hobe_error *err);
enum hobe_status hobe_mesh_copy(const struct hobe_mesh *from, struct hobe_mesh *to,
                                struct hobe_error *err);

/* Whether no triangle is turned over. */
int hobe_mesh_upright(const struct hobe_mesh *mesh);

void hobe_mesh_free(struct hobe_mesh *mesh);

#endif
