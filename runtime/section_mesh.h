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
    double (*node)[2];             /* y, z, m */
    int (*triangle)[6];            /* corners anticlockwise, then the middles of sides 01, 12, 20 */
    int *region;                   /* [triangles] the outline a triangle lies in */
    int *image[2];                 /* [nodes] the mirror images under y -> -y and z -> -z about the
                                      middle, where the outlines are their own; else NULL */
    struct hobe_mesh_index *index; /* for hobe_mesh_find; NULL where none is set */
};

/* Meshes valid outlines, outline[parts], finer near their corners, with an index; triangles share
 * the edges where outlines touch.  The same outlines give the same mesh.  One sentence when two
 * overlap. */
enum hobe_status hobe_mesh_outlines(int parts, const struct hobe_outline *outline,
                                    struct hobe_mesh *mesh, struct hobe_error *err);
/* A copy, without an index. */
enum hobe_status hobe_mesh_copy(const struct hobe_mesh *from, struct hobe_mesh *to,
                                struct hobe_error *err);

/* Whether no triangle is turned over. */
int hobe_mesh_upright(const struct hobe_mesh *mesh);

void hobe_mesh_free(struct hobe_mesh *mesh);

/* A point of a mesh: its triangle and its barycentric coordinates there. */
struct hobe_mesh_place {
    int triangle;
    double L[3];
};

/* The point of the mesh nearest to (y, z): (y, z) itself within the outline. */
struct hobe_mesh_place hobe_mesh_find(const struct hobe_mesh *mesh, double y, double z);

/* Makes finding points within the outline fast; not worth its time for a mesh that is asked for a
 * few points.  Nodes must not move any more; the index goes with the mesh, after a failure, too. */
enum hobe_status hobe_mesh_set_index(struct hobe_mesh *mesh, struct hobe_error *err);
void hobe_mesh_free_index(struct hobe_mesh *mesh);

#endif
