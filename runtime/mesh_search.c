/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which triangle of a section's mesh holds a point. */
#include "section_mesh.h"

#include <math.h>
#include <string.h>

/* Cells of a grid for each triangle: near corners of the outline, where the mesh is fine, a cell
 * holds some dozens of triangles, elsewhere a few. */
enum { CELLS = 4 };

/* Square cells over the mesh; each knows the triangles whose boxes reach into it, in their order.
 */
struct hobe_mesh_index {
    double low[2], side; /* corner of the grid and side of a cell, m */
    int cells[2];        /* along y and z */
    int *first;          /* [cells + 1] where a cell's triangles begin */
    int *triangle;
};

/* low and high of the triangle along y and z. */
static void box(const struct hobe_mesh *mesh, int triangle, double low[2], double high[2])
{
    const int *n = mesh->triangle[triangle];
    const double *a = mesh->node[n[0]], *b = mesh->node[n[1]], *c = mesh->node[n[2]];
    for (int k = 0; k < 2; k++) {
        const double less = a[k] < b[k] ? a[k] : b[k], more = a[k] < b[k] ? b[k] : a[k];
        low[k] = less < c[k] ? less : c[k];
        high[k] = more > c[k] ? more : c[k];
    }
}

/* Square of the distance from p to the triangle's box: no more than that to the triangle. */
static double box_distance(const struct hobe_mesh *mesh, int triangle, const double p[2])
{
    double low[2], high[2], square = 0;
    box(mesh, triangle, low, high);
    for (int k = 0; k < 2; k++) {
        const double off = p[k] < low[k] ? low[k] - p[k] : p[k] > high[k] ? p[k] - high[k] : 0;
        square += off * off;
    }
    return square;
}

/* The point of the triangle nearest to p as barycentric L; returns its distance. */
static double approach(const struct hobe_mesh *mesh, int triangle, const double p[2], double L[3])
{
    const int *n = mesh->triangle[triangle];
    double nearest = INFINITY, raw[3];
    for (int i = 0; i < 3; i++) {
        const double *b = mesh->node[n[(i + 1) % 3]], *c = mesh->node[n[(i + 2) % 3]];
        raw[i] = (b[0] - p[0]) * (c[1] - p[1]) - (b[1] - p[1]) * (c[0] - p[0]);
    }
    if (raw[0] >= 0 && raw[1] >= 0 && raw[2] >= 0) {
        for (int i = 0; i < 3; i++)
            L[i] = raw[i] / (raw[0] + raw[1] + raw[2]);
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const double *a = mesh->node[n[i]], *b = mesh->node[n[j]];
        const double e[2] = {b[0] - a[0], b[1] - a[1]};
        const double along = ((p[0] - a[0]) * e[0] + (p[1] - a[1]) * e[1]);
        const double t = fmin(1, fmax(0, along / (e[0] * e[0] + e[1] * e[1])));
        const double d = hypot(a[0] + t * e[0] - p[0], a[1] + t * e[1] - p[1]);
        if (d < nearest) {
            nearest = d;
            L[0] = L[1] = L[2] = 0;
            L[i] = 1 - t;
            L[j] = t;
        }
    }
    return nearest;
}

/* ---- the grid ------------------------------------------------------------------------------- */

static int cell_along(const struct hobe_mesh_index *index, int k, double x)
{
    const double cell = floor((x - index->low[k]) / index->side);
    return (int)fmin(fmax(cell, 0), index->cells[k] - 1);
}

static void set_grid(const struct hobe_mesh *mesh, struct hobe_mesh_index *index)
{
    double high[2] = {-INFINITY, -INFINITY};
    index->low[0] = index->low[1] = INFINITY;
    for (int n = 0; n < mesh->nodes; n++)
        for (int k = 0; k < 2; k++) {
            index->low[k] = fmin(index->low[k], mesh->node[n][k]);
            high[k] = fmax(high[k], mesh->node[n][k]);
        }
    const double size[2] = {high[0] - index->low[0], high[1] - index->low[1]};
    const double wanted = CELLS * (double)mesh->triangles;
    /* not by the area alone: a strip of no height has no more cells than are wanted */
    index->side = fmax(sqrt(size[0] * size[1] / wanted), fmax(size[0], size[1]) / wanted);
    for (int k = 0; k < 2; k++)
        index->cells[k] = (int)(size[k] / index->side) + 1;
}

/* Counts the triangles of each cell c in first[c + 1]; or, where `triangle` is there, enters them
 * at first[c], which moves on to where those of c + 1 begin. */
static void sort_triangles(const struct hobe_mesh *mesh, const struct hobe_mesh_index *index)
{
    for (int t = 0; t < mesh->triangles; t++) {
        double low[2], high[2];
        box(mesh, t, low, high);
        for (int j = cell_along(index, 1, low[1]); j <= cell_along(index, 1, high[1]); j++)
            for (int i = cell_along(index, 0, low[0]); i <= cell_along(index, 0, high[0]); i++) {
                int *at = index->first + j * index->cells[0] + i;
                if (index->triangle)
                    index->triangle[(*at)++] = t;
                else
                    at[1]++;
            }
    }
}

enum hobe_status hobe_mesh_set_index(struct hobe_mesh *mesh, struct hobe_error *err)
{
    struct hobe_mesh_index *index = hobe_alloc(1, sizeof *index, err);
    if (!index)
        return HOBE_NO_MEMORY;
    mesh->index = index;
    set_grid(mesh, index);
    const int cells = index->cells[0] * index->cells[1];
    index->first = hobe_alloc((size_t)cells + 1, sizeof *index->first, err);
    if (!index->first)
        return HOBE_NO_MEMORY;
    sort_triangles(mesh, index);
    for (int c = 0; c < cells; c++)
        index->first[c + 1] += index->first[c];
    index->triangle = hobe_alloc((size_t)index->first[cells], sizeof *index->triangle, err);
    if (!index->triangle)
        return HOBE_NO_MEMORY;
    sort_triangles(mesh, index);
    memmove(index->first + 1, index->first, (size_t)cells * sizeof *index->first);
    index->first[0] = 0;
    return HOBE_OK;
}

void hobe_mesh_free_index(struct hobe_mesh *mesh)
{
    if (mesh->index) {
        hobe_free(mesh->index->first);
        hobe_free(mesh->index->triangle);
    }
    hobe_free(mesh->index);
    mesh->index = NULL;
}

/* ---- the search ----------------------------------------------------------------------------- */

/* The nearest of some triangles, all where `triangle` is NULL; returns its distance. */
static double nearest_of(const struct hobe_mesh *mesh, int count, const int *triangle,
                         const double p[2], struct hobe_mesh_place *place)
{
    double nearest = INFINITY;
    for (int i = 0; i < count && nearest > 0; i++) {
        const int t = triangle ? triangle[i] : i;
        double L[3];
        if (box_distance(mesh, t, p) > nearest * nearest)
            continue;
        const double d = approach(mesh, t, p, L);
        if (d < nearest) {
            nearest = d;
            place->triangle = t;
            memcpy(place->L, L, sizeof L);
        }
    }
    return nearest;
}

/* The distance from p to the border of the cell it lies in, negative out of it. */
static double to_border(const struct hobe_mesh_index *index, const int cell[2], const double p[2])
{
    double border = INFINITY;
    for (int k = 0; k < 2; k++) {
        const double from = p[k] - index->low[k] - cell[k] * index->side;
        border = fmin(border, fmin(from, index->side - from));
    }
    return border;
}

struct hobe_mesh_place hobe_mesh_find(const struct hobe_mesh *mesh, double y, double z)
{
    const double p[2] = {y, z};
    const struct hobe_mesh_index *index = mesh->index;
    struct hobe_mesh_place place = {0, {1, 0, 0}};
    if (index) {
        const int cell[2] = {cell_along(index, 0, y), cell_along(index, 1, z)};
        const int *first = index->first + cell[1] * index->cells[0] + cell[0];
        const double d =
            nearest_of(mesh, first[1] - first[0], index->triangle + first[0], p, &place);
        if (d == 0 || d <= to_border(index, cell, p)) /* no other can be nearer */
            return place;
    }
    nearest_of(mesh, mesh->triangles, NULL, p, &place);
    return place;
}
