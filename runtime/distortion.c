/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distortion.h"

#include "linsolve.h"
#include "mesh_triangle.h"
#include "section_mirror.h"

#include <math.h>
#include <string.h>

/* Of what the load without its rigid part is to the whole: less is rounding, such as of a ring. */
static const double NO_LOAD = 1e-8;

enum { WW, W1, W2, W3, W2T, AXIAL }; /* fields along the axis, */
enum { V1, V2, V3, PAIRS };          /* and pairs of fields in the plane */
enum { RIGID = 3 };

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

struct fields {
    const hobe_section *section;
    const struct hobe_mesh *mesh;
    const double *w, *centre;
    double *axial;          /* [AXIAL][nodes] */
    double *v;              /* [PAIRS][2][nodes] */
    double A[RIGID][RIGID]; /* of the rigid motions; the last is the polar moment */
    long held[RIGID];       /* unknowns that hold the section */
};

/* The fields of pair l and their gradients at a point: f[2][3]. */
static void pair(const struct fields *s, const struct point *p, int l, double f[2][3])
{
    for (int a = 0; a < 2; a++)
        field(p, s->v + (2 * l + a) * s->mesh->nodes, f[a]);
}

/* ---- in the plane --------------------------------------------------------------------------- */

/* The load of pair l at a point: a force b and a stress g.  tau = (zs - z, y - ys) - grad w, as
 * r_w = -kappa e_x; the stress is that which undoes v2's strain of second order. */
static void load(const struct fields *s, const struct point *p, int l, double b[2], double g[2][2])
{
    double f[3], v[2][3];
    field(p, s->w, f);
    pair(s, p, V2, v);
    const double tau[2] = {p->G * (s->centre[1] - p->z - f[1]),
                           p->G * (p->y - s->centre[0] - f[2])};
    for (int a = 0; a < 2; a++) {
        const double force[PAIRS] = {[V1] = tau[a], [V2] = a ? tau[0] : -tau[1]};
        b[a] = force[l];
        for (int c = 0; c < 2; c++)
            g[a][c] =
                l == V3 ? -p->E / 2 * (v[0][1 + a] * v[0][1 + c] + v[1][1 + a] * v[1][1 + c]) : 0;
    }
}

/* c: of moments int f . r_i dA, the rigid motion sum c_i r_i with these moments of E. */
static void rigid_part(const struct fields *s, double c[RIGID])
{
    double A[RIGID][RIGID];
    memcpy(A, s->A, sizeof A);
    solve3(A, c);
}

static void set_rigid_part(const struct fields *s, int l, double c[RIGID])
{
    memset(c, 0, sizeof(double[RIGID]));
    for (int k = 0; k < POINTS * s->mesh->triangles; k++) {
        struct point p;
        double r[RIGID][2], b[2], g[2][2];
        set_point(s->section, s->mesh, k / POINTS, k % POINTS, &p);
        rigid(&p, r);
        load(s, &p, l, b, g);
        for (int i = 0; i < RIGID; i++)
            c[i] += p.weight * (r[i][0] * b[0] + r[i][1] * b[1]);
    }
    rigid_part(s, c);
}

static int is_held(const struct fields *s, long unknown)
{
    return unknown == s->held[0] || unknown == s->held[1] || unknown == s->held[2];
}

/* Holds node 0, and the node farthest from it across the line between them. */
static void hold(struct fields *s)
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
static void add_stiffness(const struct fields *s, const struct point *p, struct hobe_mesh_matrix *K)
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

static void assemble_plane(const struct fields *s, struct hobe_mesh_matrix *K)
{
    for (int k = 0; k < POINTS * s->mesh->triangles; k++) {
        struct point p;
        set_point(s->section, s->mesh, k / POINTS, k % POINTS, &p);
        add_stiffness(s, &p, K);
    }
    hobe_mesh_matrix_close(K);
}

/* x[nodes][2]: the load without its rigid part E sum c_i r_i; whether anything is left. */
static int set_load(const struct fields *s, int l, double *x)
{
    double c[RIGID], size = 0, whole = 0;
    set_rigid_part(s, l, c);
    memset(x, 0, 2 * (size_t)s->mesh->nodes * sizeof *x);
    for (int k = 0; k < POINTS * s->mesh->triangles; k++) {
        struct point p;
        double r[RIGID][2], b[2], g[2][2];
        set_point(s->section, s->mesh, k / POINTS, k % POINTS, &p);
        rigid(&p, r);
        load(s, &p, l, b, g);
        for (int a = 0; a < 2; a++) {
            whole += p.weight * b[a] * b[a];
            for (int i = 0; i < RIGID; i++)
                b[a] -= p.E * c[i] * r[i][a];
            size += p.weight * b[a] * b[a];
            for (int i = 0; i < NODES; i++)
                x[2 * p.node[i] + a] +=
                    p.weight * (b[a] * p.N[i] + g[a][0] * p.dN[i][0] + g[a][1] * p.dN[i][1]);
        }
    }
    for (int i = 0; i < RIGID; i++)
        x[s->held[i]] = 0;
    return size >= NO_LOAD * NO_LOAD * whole;
}

/* v[2][nodes] from x[nodes][2], without its rigid motion; zeros unless loaded. */
static void keep(const struct fields *s, const double *x, int loaded, double *v)
{
    const int nodes = s->mesh->nodes;
    double c[RIGID] = {0};
    for (int k = 0; k < POINTS * s->mesh->triangles; k++) {
        struct point p;
        double r[RIGID][2];
        set_point(s->section, s->mesh, k / POINTS, k % POINTS, &p);
        rigid(&p, r);
        for (int i = 0; i < NODES; i++)
            for (int j = 0; j < RIGID; j++)
                for (int a = 0; a < 2; a++)
                    c[j] += p.weight * p.E * p.N[i] * r[j][a] * x[2 * p.node[i] + a];
    }
    rigid_part(s, c);
    for (int n = 0; n < nodes; n++) {
        v[n] = loaded ? x[2 * n] - c[0] + c[2] * s->mesh->node[n][1] : 0;
        v[nodes + n] = loaded ? x[2 * n + 1] - c[1] - c[2] * s->mesh->node[n][0] : 0;
    }
}

/* v: each pair by the load that the ones before make; work[PAIRS], of each load on its answer. */
static enum hobe_status solve_plane(struct fields *s, double *work, struct hobe_error *err)
{
    const int unknowns = 2 * s->mesh->nodes;
    struct hobe_mesh_matrix K;
    hobe_linsolve *solver = NULL;
    double *x = hobe_alloc((size_t)unknowns, sizeof *x, err);
    enum hobe_status status = hobe_mesh_matrix_new(s->mesh, 2, &K, err);
    if (!status && x) {
        hold(s);
        assemble_plane(s, &K);
        solver = hobe_mesh_matrix_factor(&K, err);
    }
    status = solver ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
    for (int l = 0; !status && l < PAIRS; l++) {
        double *v = s->v + l * unknowns; /* the load, until it is answered */
        const int loaded = set_load(s, l, v);
        memcpy(x, v, (size_t)unknowns * sizeof *x);
        status = hobe_linsolve_solve(solver, x, err);
        work[l] = 0;
        for (int i = 0; i < unknowns; i++)
            work[l] += v[i] * x[i];
        keep(s, x, loaded, v);
    }
    hobe_linsolve_free(solver);
    hobe_mesh_matrix_free(&K);
    hobe_free(x);
    return status;
}

/* ---- along the axis ------------------------------------------------------------------------- */

/* Right sides at a point: a source b[0] and a flux b[1], b[2]. */
static void axial_loads(const struct fields *s, const struct point *p, double b[AXIAL][3])
{
    const double turn[2] = {s->centre[1] - p->z, p->y - s->centre[0]}; /* e_x x r */
    double w[3], v[PAIRS][2][3];
    field(p, s->w, w);
    memset(b, 0, sizeof(double[AXIAL][3]));
    b[WW][0] = p->E * w[0];
    for (int l = 0; l < PAIRS; l++) {
        pair(s, p, l, v[l]);
        for (int a = 0; a < 2; a++)
            b[W1 + l][1 + a] = p->G * v[l][a][0];
    }
    for (int a = 0; a < 2; a++)
        b[W2T][1 + a] = p->G * ((a ? v[V2][0][0] : -v[V2][1][0]) + turn[0] * v[V2][0][1 + a] +
                                turn[1] * v[V2][1][1 + a]);
}

static void assemble_axial(const struct fields *s, struct hobe_mesh_matrix *K)
{
    const int nodes = s->mesh->nodes;
    for (int k = 0; k < POINTS * s->mesh->triangles; k++) {
        struct point p;
        double b[AXIAL][3];
        set_point(s->section, s->mesh, k / POINTS, k % POINTS, &p);
        axial_loads(s, &p, b);
        for (int i = 0; i < NODES; i++) {
            for (int l = 0; l < AXIAL; l++)
                s->axial[l * nodes + p.node[i]] +=
                    p.weight * (b[l][0] * p.N[i] + b[l][1] * p.dN[i][0] + b[l][2] * p.dN[i][1]);
            for (int j = 0; j < NODES; j++)
                if (i == j || (p.node[i] && p.node[j])) /* node 0 is held */
                    hobe_mesh_matrix_add(K, p.node[i], p.node[j],
                                         p.weight * p.G *
                                             (p.dN[i][0] * p.dN[j][0] + p.dN[i][1] * p.dN[j][1]));
        }
    }
    for (int l = 0; l < AXIAL; l++)
        s->axial[l * nodes] = 0;
    hobe_mesh_matrix_close(K);
}

/* axial: up to constants; zeros before. */
static enum hobe_status solve_axial(const struct fields *s, struct hobe_error *err)
{
    struct hobe_mesh_matrix K;
    hobe_linsolve *solver = NULL;
    enum hobe_status status = hobe_mesh_matrix_new(s->mesh, 1, &K, err);
    if (!status) {
        assemble_axial(s, &K);
        solver = hobe_mesh_matrix_factor(&K, err);
        status = solver ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
    }
    for (int l = 0; !status && l < AXIAL; l++)
        status = hobe_linsolve_solve(solver, s->axial + l * s->mesh->nodes, err);
    hobe_linsolve_free(solver);
    hobe_mesh_matrix_free(&K);
    return status;
}

/* ---- what is kept of them ------------------------------------------------------------------- */

/* Takes 1, y and z out of a field; returns what is left, int E f^2 dA. */
static double orthogonalise(const struct fields *s, double *values)
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

/* Makes v[2][nodes] orthogonal to 1, y and z and as large as y and z are. */
static void normalise(const struct fields *s, double *v)
{
    const int nodes = s->mesh->nodes;
    const double square = orthogonalise(s, v) + orthogonalise(s, v + nodes);
    for (int i = 0; i < 2 * nodes; i++)
        v[i] *= square > 0 ? sqrt(s->A[2][2] / square) : 0;
}

enum hobe_status hobe_distortion(const hobe_section *section, const struct hobe_mesh *mesh,
                                 const double *w, const double centre[2], double *values,
                                 double *wall_bending, struct hobe_error *err)
{
    const int nodes = mesh->nodes;
    double work[PAIRS] = {0};
    struct fields s = {.section = section,
                       .mesh = mesh,
                       .w = w,
                       .centre = centre,
                       .axial = values,
                       .v = values + AXIAL * nodes};
    memset(values, 0, HOBE_DISTORTIONS * (size_t)nodes * sizeof *values);
    rigid_gram(section, mesh, s.A);
    enum hobe_status status = solve_plane(&s, work, err);
    *wall_bending = 4 * work[V2]; /* of twice the load of v2 */
    if (!status)
        status = solve_axial(&s, err);
    for (int l = 0; !status && l < PAIRS; l++)
        normalise(&s, s.v + 2 * l * nodes);
    for (int l = 0; !status && l < AXIAL; l++)
        orthogonalise(&s, s.axial + l * nodes);
    for (int l = 0; !status && l < HOBE_DISTORTIONS; l++)
        mirror_restore(mesh, values + l * nodes);
    return status;
}
