/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface.h"

#include "vector3.h"

#include <string.h>

/* Items at p with room for more; p itself, and *lost, where there is no memory. */
static void *grow(void *p, int count, int more, size_t size, int *lost, struct hobe_error *err)
{
    void *grown = hobe_grow(p, (size_t)count, (size_t)(count + more), size, err);
    *lost = *lost || !grown;
    return grown ? grown : p;
}

enum hobe_status hobe_surface_grow(struct hobe_surface *s, int points, int triangles, int edges,
                                   struct hobe_error *err)
{
    int lost = 0;
    s->point = grow(s->point, s->points, points, sizeof *s->point, &lost, err);
    s->displacement = grow(s->displacement, s->points, points, sizeof *s->displacement, &lost, err);
    s->value = grow(s->value, s->points, points, sizeof *s->value, &lost, err);
    s->triangle = grow(s->triangle, s->triangles, triangles, sizeof *s->triangle, &lost, err);
    s->edge = grow(s->edge, s->edges, edges, sizeof *s->edge, &lost, err);
    return lost ? HOBE_NO_MEMORY : HOBE_OK;
}

void hobe_surface_free(struct hobe_surface *surface)
{
    hobe_free(surface->point);
    hobe_free(surface->displacement);
    hobe_free(surface->value);
    hobe_free(surface->triangle);
    hobe_free(surface->edge);
    *surface = (struct hobe_surface){0};
}

void hobe_surface_triangle(struct hobe_surface *surface, int a, int b, int c)
{
    memcpy(surface->triangle[surface->triangles++], (int[]){a, b, c}, sizeof *surface->triangle);
}

void hobe_surface_edge(struct hobe_surface *surface, int a, int b)
{
    memcpy(surface->edge[surface->edges++], (int[]){a, b}, sizeof *surface->edge);
}

double hobe_surface_scale(const struct hobe_surface *surface, double fraction)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double size[3], most = 0;
    for (int i = 0; i < surface->points; i++) {
        most = fmax(most, length3(surface->displacement[i]));
        for (int a = 0; a < 3; a++) {
            low[a] = fmin(low[a], surface->point[i][a]);
            high[a] = fmax(high[a], surface->point[i][a]);
        }
    }
    for (int a = 0; a < 3; a++)
        size[a] = high[a] - low[a];
    return most > 0 ? fraction * length3(size) / most : 0;
}
