/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_mirror.h"

#include "outline.h"

#include <math.h>
#include <string.h>

/* The point of an outline that is the image of the point p; -1 where there is none. */
static int image_of(const double p[2], const struct hobe_outline *o, int a, double at, double same)
{
    for (int j = 0; j < o->start[o->loops]; j++)
        if (fabs(p[a] + o->point[j][a] - 2 * at) < same &&
            fabs(p[1 - a] - o->point[j][1 - a]) < same)
            return j;
    return -1;
}

/* Whether an outline is the image of another.  A reflection turns the way round: the edge from i to
 * j has its image from that of j to that of i. */
static int is_image(const struct hobe_outline *of, const struct hobe_outline *o, int a, double at,
                    double same)
{
    if (of->start[of->loops] != o->start[o->loops])
        return 0;
    for (int l = 0; l < of->loops; l++)
        for (int i = of->start[l]; i < of->start[l + 1]; i++) {
            const int j = hobe_outline_next(of, l, i);
            const int from = image_of(of->point[j], o, a, at, same);
            int loop = 0;
            while (from >= 0 && from >= o->start[loop + 1])
                loop++;
            if (from < 0 ||
                hobe_outline_next(o, loop, from) != image_of(of->point[i], o, a, at, same))
                return 0;
        }
    return 1;
}

int mirror_outlines(int parts, const struct hobe_outline *outline, int a, double same, double *at)
{
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < parts; k++)
        for (int i = 0; i < outline[k].start[1]; i++) {
            low = fmin(low, outline[k].point[i][a]);
            high = fmax(high, outline[k].point[i][a]);
        }
    *at = (low + high) / 2;
    for (int k = 0; k < parts; k++) {
        int m = 0;
        while (m < parts && !is_image(outline + k, outline + m, a, *at, same))
            m++;
        if (m == parts)
            return 0;
    }
    return 1;
}

/* Moves what the mesh has into longer arrays, of twice the nodes and triangles. */
static enum hobe_status make_room(struct hobe_mesh *mesh, int a, struct hobe_error *err)
{
    const size_t n = (size_t)mesh->nodes, t = (size_t)mesh->triangles;
    struct hobe_mesh longer = {.nodes = mesh->nodes,
                               .triangles = mesh->triangles,
                               .node = hobe_alloc(2 * n, sizeof *longer.node, err),
                               .triangle = hobe_alloc(2 * t, sizeof *longer.triangle, err),
                               .region = hobe_alloc(2 * t, sizeof *longer.region, err)};
    int made = longer.node && longer.triangle && longer.region;
    for (int b = 0; b < 2; b++)
        if (a == b || mesh->image[b]) {
            longer.image[b] = hobe_alloc(2 * n, sizeof *longer.image[b], err);
            made &= longer.image[b] != NULL;
        }
    if (!made) {
        hobe_mesh_free(&longer);
        return HOBE_NO_MEMORY;
    }
    memcpy(longer.node, mesh->node, n * sizeof *longer.node);
    memcpy(longer.triangle, mesh->triangle, t * sizeof *longer.triangle);
    if (mesh->image[1 - a])
        memcpy(longer.image[1 - a], mesh->image[1 - a], n * sizeof **longer.image);
    hobe_mesh_free(mesh);
    *mesh = longer;
    return HOBE_OK;
}

/* The first n nodes and their images, which are themselves on the mirror. */
static void mirror_nodes(struct hobe_mesh *mesh, int n, int a, double at, double same)
{
    int *image = mesh->image[a], *across = mesh->image[1 - a];
    for (int i = 0; i < n; i++) {
        double *p = mesh->node[i];
        image[i] = i;
        if (fabs(p[a] - at) < same) {
            p[a] = at;
            continue;
        }
        image[i] = mesh->nodes++;
        image[image[i]] = i;
        mesh->node[image[i]][a] = 2 * at - p[a];
        mesh->node[image[i]][1 - a] = p[1 - a];
    }
    for (int i = 0; across && i < n; i++)
        across[image[i]] = image[across[i]];
}

enum hobe_status mirror_mesh(struct hobe_mesh *mesh, int a, double at, double same,
                             struct hobe_error *err)
{
    static const int turned[6] = {0, 2, 1, 5, 4, 3}; /* the image anticlockwise again */
    const int nodes = mesh->nodes, triangles = mesh->triangles;
    const enum hobe_status status = make_room(mesh, a, err);
    if (status)
        return status;
    mirror_nodes(mesh, nodes, a, at, same);
    for (int t = 0; t < triangles; t++)
        for (int i = 0; i < 6; i++)
            mesh->triangle[triangles + t][i] = mesh->image[a][mesh->triangle[t][turned[i]]];
    mesh->triangles *= 2;
    return HOBE_OK;
}

void mirror_restore(const struct hobe_mesh *mesh, double *value)
{
    const double none = 1e-18; /* in the square */
    for (int a = 0; a < 2; a++) {
        const int *image = mesh->image[a];
        double even = 0, odd = 0;
        for (int i = 0; image && i < mesh->nodes; i++) {
            even += pow(value[i] + value[image[i]], 2);
            odd += pow(value[i] - value[image[i]], 2);
        }
        if (!image || (even > none * odd && odd > none * even))
            continue;
        const double sign = even > odd ? 1 : -1;
        for (int i = 0; i < mesh->nodes; i++)
            if (image[i] >= i) {
                const double mean = (value[i] + sign * value[image[i]]) / 2;
                value[i] = mean;
                value[image[i]] = sign * mean;
            }
    }
}
