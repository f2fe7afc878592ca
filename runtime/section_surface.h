/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How kinds of sections make their surfaces (hobe_section_surface). */
#ifndef HOBE_SECTION_SURFACE_H
#define HOBE_SECTION_SURFACE_H

#include "section_mesh.h"
#include "surface.h"

/* Both fill an empty surface.
 *
 * A grid of rows x columns cells, both even, with its boundary as edges, points still zero: point
 * (i, j) is number i * n + j, n = columns + 1.  `wrapped`: column n - 1 would be column 0 again, n
 * = columns. Normals are along +x where j counts along y and i along z. */
enum hobe_status hobe_surface_grid(int rows, int columns, int wrapped, struct hobe_surface *surface,
                                   struct hobe_error *err);

/* The triangles of a mesh, each split in four; points are numbered as its nodes. */
enum hobe_status hobe_surface_mesh(const struct hobe_mesh *mesh, struct hobe_surface *surface,
                                   struct hobe_error *err);

#endif
