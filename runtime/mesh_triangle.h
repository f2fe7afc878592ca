/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quadratic triangles with straight sides, and matrices over the nodes of their mesh. */
#ifndef HOBE_MESH_TRIANGLE_H
#define HOBE_MESH_TRIANGLE_H

#include "section_mesh.h"

enum { NODES = 6, POINTS = 6 }; /* of a triangle: nodes, points of a cubature */

/* Shape functions of a triangle with straight sides at barycentric L, and their gradients. */
static inline void shape(const struct hobe_mesh *mesh, int triangle, const double L[3],
                         double N[NODES], double dN[NODES][2])
{
    const int *n = mesh->triangle[triangle];
    const double *p[3] = {mesh->node[n[0]], mesh->node[n[1]], mesh->node[n[2]]};
    const double twice =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    double dL[3][2];
    for (int i = 0; i < 3; i++) {
        const double *b = p[(i + 1) % 3], *c = p[(i + 2) % 3];
        dL[i][0] = (b[1] - c[1]) / twice;
        dL[i][1] = (c[0] - b[0]) / twice;
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        N[i] = L[i] * (2 * L[i] - 1);
        N[3 + i] = 4 * L[i] * L[j];
        for (int a = 0; a < 2; a++) {
            dN[i][a] = (4 * L[i] - 1) * dL[i][a];
            dN[3 + i][a] = 4 * (L[i] * dL[j][a] + L[j] * dL[i][a]);
        }
    }
}

static inline double area(const struct hobe_mesh *mesh, int triangle)
{
    const int *n = mesh->triangle[triangle];
    const double *a = mesh->node[n[0]], *b = mesh->node[n[1]], *c = mesh->node[n[2]];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

static inline void place(const struct hobe_mesh *mesh, int triangle, const double L[3], double p[2])
{
    const int *n = mesh->triangle[triangle];
    for (int a = 0; a < 2; a++)
        p[a] = L[0] * mesh->node[n[0]][a] + L[1] * mesh->node[n[1]][a] + L[2] * mesh->node[n[2]][a];
}

/* The k-th of six points, exact for degree 4 (Dunavant 1985); weights sum to 1. */
static inline double cubature(int k, double L[3])
{
    static const double b[2] = {0.44594849091596488632, 0.09157621350977074346};
    static const double weight[2] = {0.22338158967801146570, 0.10995174365532186764};
    const int orbit = k / 3;
    for (int i = 0; i < 3; i++)
        L[i] = i == k % 3 ? 1 - 2 * b[orbit] : b[orbit];
    return weight[orbit];
}

/* ---- matrices (mesh_matrix.c) ---------------------------------------------------------------- */

/* A symmetric matrix in compressed columns, with 1/sqrt of its diagonal. */
struct hobe_mesh_matrix {
    int n;
    long *start, *row;
    double *value, *scale;
};

/* All zero, with room for what the triangles add at `per` unknowns a node: unknown a of node i is
 * number per * i + a.  hobe_mesh_matrix_free frees what a failure leaves. */
enum hobe_status hobe_mesh_matrix_new(const struct hobe_mesh *mesh, int per,
                                      struct hobe_mesh_matrix *matrix, struct hobe_error *err);
void hobe_mesh_matrix_add(struct hobe_mesh_matrix *matrix, long row, long column, double value);
/* Sorts the rows of each column, closes the gaps and sets the scale, once all is added. */
void hobe_mesh_matrix_close(struct hobe_mesh_matrix *matrix);
void hobe_mesh_matrix_free(struct hobe_mesh_matrix *matrix);

/* Factors of a closed matrix, which must outlive them; NULL with err. */
struct hobe_linsolve *hobe_mesh_matrix_factor(const struct hobe_mesh_matrix *matrix,
                                              struct hobe_error *err);

#endif
