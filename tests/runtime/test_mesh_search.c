/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points found in the mesh of a section: themselves within the outline, the nearest point of it
 * outside, and the same with and without the index.  Looks into the core (section_mesh.h). */
#include "check.h"
#include "section_mesh.h"

#include <math.h>

static double area_of(const double a[2], const double b[2], const double c[2])
{
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/* Random weights, within the triangle. */
static void random_weights(double L[3])
{
    const double a = random_real(0, 1), b = random_real(0, 1);
    L[0] = fmin(a, b);
    L[1] = fabs(a - b);
    L[2] = 1 - fmax(a, b);
}

static void point_at(const struct hobe_mesh *mesh, const struct hobe_mesh_place *place, double p[2])
{
    const int *n = mesh->triangle[place->triangle];
    for (int a = 0; a < 2; a++)
        p[a] = place->L[0] * mesh->node[n[0]][a] + place->L[1] * mesh->node[n[1]][a] +
               place->L[2] * mesh->node[n[2]][a];
}

/* No distance from the mesh is more. */
static double nearest_node(const struct hobe_mesh *mesh, const double p[2])
{
    double nearest = INFINITY;
    for (int n = 0; n < mesh->nodes; n++)
        nearest = fmin(nearest, hypot(mesh->node[n][0] - p[0], mesh->node[n][1] - p[1]));
    return nearest;
}

static void inside(const struct hobe_mesh *mesh)
{
    double total = 0;
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t];
        struct hobe_mesh_place wanted = {.triangle = t};
        double p[2], q[2];
        total += area_of(mesh->node[n[0]], mesh->node[n[1]], mesh->node[n[2]]);
        random_weights(wanted.L);
        point_at(mesh, &wanted, p);
        const struct hobe_mesh_place found = hobe_mesh_find(mesh, p[0], p[1]);
        point_at(mesh, &found, q);
        check_absolute(hypot(q[0] - p[0], q[1] - p[1]), 0, 1e-14, "a point of triangle %d", t);
    }
    check_relative(total, 0.0598, 1e-12, "the area of the outline");
}

/* Both ways give the same triangle and coordinates, and no node is nearer. */
static void anywhere(const struct hobe_mesh *mesh, const struct hobe_mesh *plain)
{
    for (int i = 0; i < 500; i++) {
        const double p[2] = {random_real(-0.3, 0.5), random_real(-0.3, 0.7)};
        const struct hobe_mesh_place a = hobe_mesh_find(mesh, p[0], p[1]);
        const struct hobe_mesh_place b = hobe_mesh_find(plain, p[0], p[1]);
        double q[2];
        check_that(a.triangle == b.triangle && a.L[0] == b.L[0] && a.L[1] == b.L[1],
                   "triangle %d at (%g, %g), without the index %d", a.triangle, p[0], p[1],
                   b.triangle);
        point_at(mesh, &a, q);
        check_that(hypot(q[0] - p[0], q[1] - p[1]) <= nearest_node(mesh, p) * (1 + 1e-14),
                   "a node is nearer to (%g, %g)", p[0], p[1]);
    }
}

int main(void)
{
    /* an L of 0.2 x 0.4 m with a hole in its foot, fine at its corners */
    int start[] = {0, 6, 10};
    double point[][2] = {{0, 0},   {0.2, 0},     {0.2, 0.2},  {0.1, 0.2},  {0.1, 0.4},
                         {0, 0.4}, {0.12, 0.08}, {0.12, 0.1}, {0.13, 0.1}, {0.13, 0.08}};
    const struct hobe_outline outline = {2, start, point};
    struct hobe_error err;
    struct hobe_mesh mesh, plain;
    random_start();
    if (hobe_mesh_outlines(1, &outline, &mesh, &err) || hobe_mesh_copy(&mesh, &plain, &err))
        check_stop("%s", err.message);
    check_that(mesh.index && !plain.index, "a new mesh has an index, a copy has none");
    inside(&mesh);
    anywhere(&mesh, &plain);
    hobe_mesh_free(&mesh);
    hobe_mesh_free(&plain);
    return check_report();
}
