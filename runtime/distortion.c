/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distortion.h"

#include "linsolve.h"
#include "mesh_triangle.h"

#include <math.h>
#include <string.h>

/* Of what the load without its rigid part is to the whole: less is rounding, such as of a ring. */
static const double NO_LOAD = 1e-8;

enum { LOADS = 2, RIGID = 3 };

/* A cubature point of the mesh with all that is asked of it. */
struct point {
    double y, z, weight, E, G;
    double N[NODES], dN[NODES][2];
    const int *node; /* [NODES] */
};

static void set_point(const hobe_section *section, const struct hobe_mesh *mesh, int t, int k,
                      struct point *p)
{
    double L[3], at[2];
    p->weight = area(mesh, t) * cubature(k, L);
    shape(mesh, t, L, p->N, p->dN);
    place(mesh, t, L, at);
    p->y = at[0];
    p->z = at[1];
    p->E = hobe_section_E(section, mesh->region[t]);
    p->G = hobe_section_G(section, mesh->region[t]);
    p->node = mesh->triangle[t];
}

/* Value and gradient of nodal values at a point: f[3]. */
static void field(const struct point *p, const double *values, double f[3])
{
    f[0] = f[1] = f[2] = 0;
    for (int i = 0; i < NODES; i++) {
        const double value = values[p->node[i]];
        f[0] += p->N[i] * value;
        f[1] += p->dN[i][0] * value;
        f[2] += p->dN[i][1] * value;
    }
}

/* ---- along the axis ------------------------------------------------------------------------- */

static void assemble_axial(const hobe_section *section, const struct hobe_mesh *mesh,
                           const double *w, struct hobe_mesh_matrix *K, double *b)
{
    for (int g = 0; g < POINTS * mesh->triangles; g++) {
        struct point p;
        double f[3];
        set_point(section, mesh, g / POINTS, g % POINTS, &p);
        field(&p, w, f);
        for (int i = 0; i < NODES; i++) {
            b[p.node[i]] += p.weight * p.E * f[0] * p.N[i];
            for (int j = 0; j < NODES; j++)
                if (i == j || (p.node[i] && p.node[j])) /* node 0 is held */
                    hobe_mesh_matrix_add(K, p.node[i], p.node[j],
                                         p.weight * p.G *
                                             (p.dN[i][0] * p.dN[j][0] + p.dN[i][1] * p.dN[j][1]));
        }
    }
    b[0] = 0;
}

/* ww[nodes], up to a constant; zeros before. */
static enum hobe_status solve_axial(const hobe_section *section, const struct hobe_mesh *mesh,
                                    const double *w, double *ww, struct hobe_error *err)
{
    struct hobe_mesh_matrix K;
    hobe_linsolve *solver = NULL;
    enum hobe_status status = hobe_mesh_matrix_new(mesh, 1, &K, err);
    if (!status) {
        assemble_axial(section, mesh, w, &K, ww);
        hobe_mesh_matrix_close(&K);
        solver = hobe_mesh_matrix_factor(&K, err);
        status = solver ? hobe_linsolve_solve(solver, ww, err) : HOBE_NO_MEMORY;
    }
    hobe_linsolve_free(solver);
    hobe_mesh_matrix_free(&K);
    return status;
}

/* ---- in the plane --------------------------------------------------------------------------- */

/* The loads at a point; tau = (zs - z, y - ys) - grad w, as r_w = -kappa e_x. */
static void loads(const struct point *p, const double *w, const double centre[2],
                  double b[LOADS][2])
{
    double f[3];
    field(p, w, f);
    const double tau[2] = {centre[1] - p->z - f[1], p->y - centre[0] - f[2]};
    const double all[LOADS][2] = {{tau[0], tau[1]}, {-tau[1], tau[0]}};
    for (int l = 0; l < LOADS; l++)
        for (int a = 0; a < 2; a++)
            b[l][a] = p->G * all[l][a];
}

static void rigid(const struct point *p, double r[RIGID][2])
{
    const double motions[RIGID][2] = {{1, 0}, {0, 1}, {-p->z, p->y}};
    memcpy(r, motions, sizeof motions);
}

/* c: A c = b for a symmetric positive definite 3 x 3 A, by elimination in place. */
static void solve3(double A[RIGID][RIGID], double b[RIGID])
{
    for (int k = 0; k < RIGID; k++)
        for (int i = 0; i < RIGID; i++) {
            const double factor = i == k ? 0 : A[i][k] / A[k][k];
            for (int j = k; j < RIGID; j++)
                A[i][j] -= factor * A[k][j];
            b[i] -= factor * b[k];
        }
    for (int k = 0; k < RIGID; k++)
        b[k] /= A[k][k];
}

/* A_ij = int E r_i . r_j dA. */
static void rigid_gram(const hobe_section *section, const struct hobe_mesh *mesh,
                       double A[RIGID][RIGID])
{
    memset(A, 0, sizeof(double[RIGID][RIGID]));
    for (int g = 0; g < POINTS * mesh->triangles; g++) {
        struct point p;
        double r[RIGID][2];
        set_point(section, mesh, g / POINTS, g % POINTS, &p);
        rigid(&p, r);
        for (int i = 0; i < RIGID; i++)
            for (int j = 0; j < RIGID; j++)
                A[i][j] += p.weight * p.E * (r[i][0] * r[j][0] + r[i][1] * r[j][1]);
    }
}

struct plane {
    const hobe_section *section;
    const struct hobe_mesh *mesh;
    const double *w, *centre;
    double A[RIGID][RIGID]; /* of the rigid motions; the last is the polar moment */
    double c[LOADS][RIGID]; /* the rigid part of each load, E sum c_i r_i */
    double size[LOADS];     /* int |load|^2 dA without and ... */
    double whole[LOADS];    /* ... with its rigid part */
    long held[RIGID];       /* unknowns that hold the section */
};

static void set_rigid_parts(struct plane *s)
{
    memset(s->c, 0, sizeof s->c);
    for (int g = 0; g < POINTS * s->mesh->triangles; g++) {
        struct point p;
        double r[RIGID][2], b[LOADS][2];
        set_point(s->section, s->mesh, g / POINTS, g % POINTS, &p);
        rigid(&p, r);
        loads(&p, s->w, s->centre, b);
        for (int l = 0; l < LOADS; l++)
            for (int i = 0; i < RIGID; i++)
                s->c[l][i] += p.weight * (r[i][0] * b[l][0] + r[i][1] * b[l][1]);
    }
    for (int l = 0; l < LOADS; l++) {
        double A[RIGID][RIGID];
        memcpy(A, s->A, sizeof A);
        solve3(A, s->c[l]);
    }
}

/* Takes the rigid part out of the loads at a point. */
static void balance(const struct plane *s, const struct point *p, double b[LOADS][2])
{
    double r[RIGID][2];
    rigid(p, r);
    for (int l = 0; l < LOADS; l++)
        for (int i = 0; i < RIGID; i++)
            for (int a = 0; a < 2; a++)
                b[l][a] -= p->E * s->c[l][i] * r[i][a];
}

static int is_held(const struct plane *s, long unknown)
{
    return unknown == s->held[0] || unknown == s->held[1] || unknown == s->held[2];
}

/* Holds node 0, and the node farthest from it across the line between them. */
static void hold(struct plane *s)
{
    const double(*node)[2] = (const double(*)[2])s->mesh->node;
    int far = 0;
    double most = 0;
    for (int n = 0; n < s->mesh->nodes; n++) {
        const double d = hypot(node[n][0] - node[0][0], node[n][1] - node[0][1]);
        if (d > most) {
            most = d;
            far = n;
        }
    }
    const int across = fabs(node[far][0] - node[0][0]) > fabs(node[far][1] - node[0][1]);
    s->held[0] = 0;
    s->held[1] = 1;
    s->held[2] = 2 * far + across;
}

/* k[2 NODES][2 NODES] of a point: E (eps_yy^2 + eps_zz^2 + gamma_yz^2/2), the isotropic law without
 * Poisson's coupling: walls at any angle bend alike. */
static void add_stiffness(const struct plane *s, const struct point *p, struct hobe_mesh_matrix *K)
{
    for (int i = 0; i < NODES; i++)
        for (int j = 0; j < NODES; j++) {
            const double *d = p->dN[i], *e = p->dN[j];
            const double k[2][2] = {{d[0] * e[0] + d[1] * e[1] / 2, d[1] * e[0] / 2},
                                    {d[0] * e[1] / 2, d[1] * e[1] + d[0] * e[0] / 2}};
            for (int a = 0; a < 4; a++) {
                const long row = 2 * p->node[i] + a / 2, column = 2 * p->node[j] + a % 2;
                if (row == column || (!is_held(s, row) && !is_held(s, column)))
                    hobe_mesh_matrix_add(K, row, column, p->weight * p->E * k[a / 2][a % 2]);
            }
        }
}

/* x[LOADS][2 nodes]: right sides. */
static void assemble(struct plane *s, struct hobe_mesh_matrix *K, double *x)
{
    memset(s->size, 0, sizeof s->size);
    memset(s->whole, 0, sizeof s->whole);
    for (int g = 0; g < POINTS * s->mesh->triangles; g++) {
        struct point p;
        double b[LOADS][2], whole[LOADS][2];
        set_point(s->section, s->mesh, g / POINTS, g % POINTS, &p);
        loads(&p, s->w, s->centre, whole);
        memcpy(b, whole, sizeof b);
        balance(s, &p, b);
        add_stiffness(s, &p, K);
        for (int l = 0; l < LOADS; l++)
            for (int a = 0; a < 2; a++) {
                s->size[l] += p.weight * b[l][a] * b[l][a];
                s->whole[l] += p.weight * whole[l][a] * whole[l][a];
                for (int i = 0; i < NODES; i++)
                    x[(size_t)(2 * l * s->mesh->nodes + 2 * p.node[i] + a)] +=
                        p.weight * b[l][a] * p.N[i];
            }
    }
    for (int l = 0; l < LOADS; l++)
        for (int i = 0; i < RIGID; i++)
            x[2 * l * s->mesh->nodes + s->held[i]] = 0;
}

/* ---- what is kept of them ------------------------------------------------------------------- */

/* Takes 1, y and z out of a field; returns what is left, int E f^2 dA. */
static double orthogonalise(const struct plane *s, double *values)
{
    double A[RIGID][RIGID] = {{0}}, part[RIGID] = {0}, square = 0, f[3];
    struct point p;
    for (int g = 0; g < POINTS * s->mesh->triangles; g++) {
        set_point(s->section, s->mesh, g / POINTS, g % POINTS, &p);
        field(&p, values, f);
        const double basis[RIGID] = {1, p.y, p.z}, weight = p.weight * p.E;
        for (int i = 0; i < RIGID; i++) {
            part[i] += weight * basis[i] * f[0];
            for (int j = 0; j < RIGID; j++)
                A[i][j] += weight * basis[i] * basis[j];
        }
    }
    solve3(A, part);
    for (int n = 0; n < s->mesh->nodes; n++)
        values[n] -= part[0] + part[1] * s->mesh->node[n][0] + part[2] * s->mesh->node[n][1];
    for (int g = 0; g < POINTS * s->mesh->triangles; g++) {
        set_point(s->section, s->mesh, g / POINTS, g % POINTS, &p);
        field(&p, values, f);
        square += p.weight * p.E * f[0] * f[0];
    }
    return square;
}

/* The fields v[2][nodes] of load l from x[nodes][2]. */
static void keep(const struct plane *s, int l, const double *x, double *v)
{
    const int nodes = s->mesh->nodes, loaded = s->size[l] > NO_LOAD * NO_LOAD * s->whole[l];
    double square = 0;
    for (int a = 0; a < 2; a++) {
        for (int n = 0; n < nodes; n++)
            v[a * nodes + n] = x[2 * n + a];
        square += orthogonalise(s, v + a * nodes);
    }
    for (int i = 0; i < 2 * nodes; i++)
        v[i] *= loaded && square > 0 ? sqrt(s->A[2][2] / square) : 0;
}

/* v[LOADS][2][nodes], and the work of each load on its answer, work[LOADS]. */
static enum hobe_status solve_plane(struct plane *s, double *v, double *work,
                                    struct hobe_error *err)
{
    const int nodes = s->mesh->nodes;
    struct hobe_mesh_matrix K;
    hobe_linsolve *solver = NULL;
    double *x = hobe_alloc(2 * LOADS * (size_t)nodes, sizeof *x, err);
    enum hobe_status status = hobe_mesh_matrix_new(s->mesh, 2, &K, err);
    if (!status && x) {
        hold(s);
        assemble(s, &K, x);
        memcpy(v, x,
               2 * LOADS * (size_t)nodes * sizeof *v); /* the loads, until they are answered */
        hobe_mesh_matrix_close(&K);
        solver = hobe_mesh_matrix_factor(&K, err);
    }
    status = solver ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
    for (int l = 0; !status && l < LOADS; l++) {
        const int first = 2 * l * nodes;
        status = hobe_linsolve_solve(solver, x + first, err);
        work[l] = 0;
        for (int i = first; i < first + 2 * nodes; i++)
            work[l] += v[i] * x[i];
        if (!status)
            keep(s, l, x + first, v + first);
    }
    hobe_linsolve_free(solver);
    hobe_mesh_matrix_free(&K);
    hobe_free(x);
    return status;
}

enum hobe_status hobe_distortion(const hobe_section *section, const struct hobe_mesh *mesh,
                                 const double *w, const double centre[2], double *values,
                                 double *wall_bending, struct hobe_error *err)
{
    double work[LOADS];
    const size_t nodes = (size_t)mesh->nodes;
    struct plane s = {.section = section, .mesh = mesh, .w = w, .centre = centre};
    memset(values, 0, HOBE_DISTORTIONS * nodes * sizeof *values);
    rigid_gram(section, mesh, s.A);
    set_rigid_parts(&s);
    enum hobe_status status = solve_axial(section, mesh, w, values, err);
    if (status)
        return status;
    orthogonalise(&s, values);
    status = solve_plane(&s, values + nodes, work, err);
    *wall_bending = 4 * work[1]; /* of twice the load of v2 */
    return status;
}
