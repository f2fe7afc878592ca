/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_surface.h"

#include "section.h"

#include <string.h>

/* The quarters of the triangle with corners n[0..2] and n[3..5] in the middle of its sides. */
static void add_quarters(const int n[6], struct hobe_surface *s)
{
    hobe_surface_triangle(s, n[0], n[3], n[5]);
    hobe_surface_triangle(s, n[3], n[1], n[4]);
    hobe_surface_triangle(s, n[5], n[4], n[2]);
    hobe_surface_triangle(s, n[3], n[4], n[5]);
}

void hobe_surface_quadratic(const struct hobe_surface *surface, int t, int n[6])
{
    const int(*quarter)[3] = (const int(*)[3])surface->triangle + 4 * t;
    memcpy(n,
           (int[]){quarter[0][0], quarter[1][1], quarter[2][2], quarter[3][0], quarter[3][1],
                   quarter[3][2]},
           6 * sizeof *n);
}

/* Both triangles of two by two cells, the first at row i and column j. */
static void add_cells(int i, int j, int n, struct hobe_surface *s)
{
    int at[3][3];
    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++)
            at[k][l] = (i + k) * n + (j + l) % n;
    add_quarters((const int[]){at[0][0], at[0][2], at[2][2], at[0][1], at[1][2], at[1][1]}, s);
    add_quarters((const int[]){at[0][0], at[2][2], at[2][0], at[1][1], at[2][1], at[1][0]}, s);
}

enum hobe_status hobe_surface_grid(int rows, int columns, int wrapped, struct hobe_surface *surface,
                                   struct hobe_error *err)
{
    const int n = columns + !wrapped, last = rows * n;
    const int edges = 2 * columns + (wrapped ? 0 : 2 * rows);
    if (hobe_surface_grow(surface, (rows + 1) * n, 2 * rows * columns, edges, err))
        return HOBE_NO_MEMORY;
    surface->points = (rows + 1) * n;
    for (int i = 0; i < rows; i += 2)
        for (int j = 0; j < columns; j += 2)
            add_cells(i, j, n, surface);
    for (int j = 0; j < columns; j++)
        hobe_surface_edge(surface, j, (j + 1) % n);
    for (int j = 0; j < columns; j++)
        hobe_surface_edge(surface, last + (j + 1) % n, last + j);
    for (int i = 0; i < rows && !wrapped; i++) {
        hobe_surface_edge(surface, i * n + columns, (i + 1) * n + columns);
        hobe_surface_edge(surface, (i + 1) * n, i * n);
    }
    surface->outline = surface->edges;
    return HOBE_OK;
}

/* What a side of a triangle is, told by the node in its middle; or 1 + the region of the one
 * triangle that has it, which makes it a part of the outline. */
enum { INNER = -1, SEAM = -2 };

/* Sets side[nodes]; counts those of the outline and between regions. */
static void sort_sides(const struct hobe_mesh *mesh, int *side, int *outline, int *seams)
{
    *outline = *seams = 0;
    for (int t = 0; t < mesh->triangles; t++)
        for (int k = 3; k < 6; k++) {
            int *s = side + mesh->triangle[t][k];
            const int same = *s == mesh->region[t] + 1;
            *outline += *s ? -1 : 1;
            *seams += *s && !same;
            *s = !*s ? mesh->region[t] + 1 : same ? INNER : SEAM;
        }
}

static void add_side(const int *node, int k, struct hobe_surface *surface)
{
    hobe_surface_edge(surface, node[k], node[3 + k]);
    hobe_surface_edge(surface, node[3 + k], node[(k + 1) % 3]);
}

static void fill(const struct hobe_mesh *mesh, int *side, struct hobe_surface *s)
{
    for (int i = 0; i < mesh->nodes; i++)
        memcpy(s->point[s->points++] + 1, mesh->node[i], sizeof mesh->node[i]);
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t];
        add_quarters(n, s);
        for (int k = 0; k < 3; k++)
            if (side[n[3 + k]] > 0)
                add_side(n, k, s);
    }
    s->outline = s->edges;
    for (int t = 0; t < mesh->triangles; t++)
        for (int k = 0; k < 3; k++)
            if (side[mesh->triangle[t][3 + k]] == SEAM) {
                add_side(mesh->triangle[t], k, s);
                side[mesh->triangle[t][3 + k]] = INNER; /* once */
            }
}

enum hobe_status hobe_surface_mesh(const struct hobe_mesh *mesh, struct hobe_surface *surface,
                                   struct hobe_error *err)
{
    int *side = hobe_alloc((size_t)mesh->nodes, sizeof *side, err), outline, seams;
    if (!side)
        return HOBE_NO_MEMORY;
    sort_sides(mesh, side, &outline, &seams);
    const enum hobe_status status =
        hobe_surface_grow(surface, mesh->nodes, 4 * mesh->triangles, 2 * (outline + seams), err);
    if (!status)
        fill(mesh, side, surface);
    hobe_free(side);
    return status;
}

enum hobe_status hobe_section_surface(const hobe_section *section, int fineness,
                                      struct hobe_surface *surface, struct hobe_error *err)
{
    hobe_section *start = NULL;
    *surface = (struct hobe_surface){0};
    if (hobe_section_varies(section)) {
        section = start = hobe_section_at(section, 0, err);
        if (!start)
            return err ? err->status : HOBE_NO_MEMORY;
    }
    const enum hobe_status status = section->kind->surface(section, fineness, surface, err);
    if (status)
        hobe_surface_free(surface);
    hobe_section_free(start);
    return status;
}

/* A wall from each edge of the outline to x = depth, where nothing moves. */
static enum hobe_status add_walls(struct hobe_surface *s, double depth, struct hobe_error *err)
{
    const int edges = s->outline;
    if (hobe_surface_grow(s, 2 * edges, 2 * edges, edges, err))
        return HOBE_NO_MEMORY;
    for (int e = 0; e < edges; e++) {
        const int *near = s->edge[e], far = s->points;
        for (int k = 0; k < 2; k++) {
            double *p = s->point[s->points++];
            memcpy(p, s->point[near[k]], sizeof *s->point);
            p[0] = depth;
        }
        hobe_surface_triangle(s, near[0], near[1], far + 1);
        hobe_surface_triangle(s, near[0], far + 1, far);
        hobe_surface_edge(s, far, far + 1);
    }
    return HOBE_OK;
}

enum hobe_status hobe_section_field(const hobe_section *section, const char *function, int fineness,
                                    double depth, struct hobe_surface *surface,
                                    struct hobe_error *err)
{
    enum hobe_status status = hobe_section_surface(section, fineness, surface, err);
    const int face = surface->points;
    if (!status && depth > 0)
        status = add_walls(surface, depth, err);
    for (int i = 0; !status && i < surface->points; i++) {
        const double *p = surface->point[i];
        double f[4];
        status = hobe_section_function(section, function, p[1], p[2], f, err);
        surface->value[i] = f[0];
        surface->displacement[i][0] = i < face ? -f[0] : 0;
    }
    if (status)
        hobe_surface_free(surface);
    return status;
}

enum hobe_status hobe_section_surface_at(const hobe_section *section, double at, int fineness,
                                         struct hobe_surface *surface, struct hobe_error *err)
{
    return section->kind->surface_at
               ? section->kind->surface_at(section, at, fineness, surface, err)
               : hobe_section_surface(section, fineness, surface, err);
}
