/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "saint_venant.h"

#include "linsolve.h"
#include "mesh_triangle.h"
#include "section_mirror.h"

#include <math.h>
#include <string.h>

/* ---- the equations -------------------------------------------------------------------------- */

/* K_ij = int G grad N_i . grad N_j dA and the right sides b[HOBE_SECTION_FUNCTIONS][nodes]:
 * int G (y N_i,z - z N_i,y) dA, which is the boundary condition's integral along the outline of
 * each region since (-z, y) has no divergence; int E y N_i dA; int E z N_i dA.  Node 0 is held at
 * 0. */
static void assemble(const hobe_section *section, const struct hobe_mesh *mesh,
                     struct hobe_mesh_matrix *K, double *b)
{
    const int nodes = mesh->nodes;
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t], region = mesh->region[t];
        const double E = hobe_section_E(section, region), G = hobe_section_G(section, region);
        double k[NODES][NODES] = {{0}}, L[3], N[NODES], dN[NODES][2], p[2];
        for (int g = 0; g < POINTS; g++) {
            const double weight = area(mesh, t) * cubature(g, L);
            shape(mesh, t, L, N, dN);
            place(mesh, t, L, p);
            for (int i = 0; i < NODES; i++) {
                b[HOBE_W * nodes + n[i]] += weight * G * (p[0] * dN[i][1] - p[1] * dN[i][0]);
                b[HOBE_WY * nodes + n[i]] += weight * E * p[0] * N[i];
                b[HOBE_WZ * nodes + n[i]] += weight * E * p[1] * N[i];
                for (int j = 0; j < NODES; j++)
                    k[i][j] += weight * G * (dN[i][0] * dN[j][0] + dN[i][1] * dN[j][1]);
            }
        }
        for (int i = 0; i < NODES; i++)
            for (int j = 0; j < NODES; j++)
                if (i == j || (n[i] && n[j]))
                    hobe_mesh_matrix_add(K, n[i], n[j], k[i][j]);
    }
}

/* K x = b for each function; x[HOBE_SECTION_FUNCTIONS][n] holds b before. */
static enum hobe_status solve(const struct hobe_mesh_matrix *K, double *x, struct hobe_error *err)
{
    hobe_linsolve *solver = hobe_mesh_matrix_factor(K, err);
    enum hobe_status status = solver ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
    for (int f = 0; !status && f < HOBE_SECTION_FUNCTIONS; f++) {
        x[f * K->n] = 0;
        status = hobe_linsolve_solve(solver, x + f * K->n, err);
    }
    hobe_linsolve_free(solver);
    return status;
}

/* ---- smooth fields -------------------------------------------------------------------------- */

struct hobe_extension {
    const struct hobe_mesh *mesh;
    unsigned char *held;
    struct hobe_mesh_matrix K; /* with rows and columns of held nodes those of the unit matrix */
    hobe_linsolve *solver;
};

/* k_ij = int grad N_i . grad N_j dA / A of a triangle: the weight makes the small triangles at
 * corners stiff, where the gradient of a harmonic field has no bound. */
static void stiff_laplace(const struct hobe_mesh *mesh, int t, double k[NODES][NODES])
{
    double L[3], N[NODES], dN[NODES][2];
    memset(k, 0, sizeof(double[NODES][NODES]));
    for (int g = 0; g < POINTS; g++) {
        const double weight = cubature(g, L);
        shape(mesh, t, L, N, dN);
        for (int i = 0; i < NODES; i++)
            for (int j = 0; j < NODES; j++)
                k[i][j] += weight * (dN[i][0] * dN[j][0] + dN[i][1] * dN[j][1]);
    }
}

static void assemble_extension(struct hobe_extension *x)
{
    for (int t = 0; t < x->mesh->triangles; t++) {
        const int *n = x->mesh->triangle[t];
        double k[NODES][NODES];
        stiff_laplace(x->mesh, t, k);
        for (int i = 0; i < NODES; i++)
            for (int j = 0; j < NODES; j++)
                if (i == j || (!x->held[n[i]] && !x->held[n[j]]))
                    hobe_mesh_matrix_add(&x->K, n[i], n[j], k[i][j]);
    }
    hobe_mesh_matrix_close(&x->K);
}

struct hobe_extension *hobe_extension_new(const struct hobe_mesh *mesh, const unsigned char *held,
                                          struct hobe_error *err)
{
    const size_t n = (size_t)mesh->nodes;
    struct hobe_extension *x = hobe_alloc(1, sizeof *x, err);
    if (!x)
        return NULL;
    x->mesh = mesh;
    x->held = hobe_alloc(n, sizeof *x->held, err);
    if (x->held && !hobe_mesh_matrix_new(mesh, 1, &x->K, err)) {
        memcpy(x->held, held, n);
        assemble_extension(x);
        x->solver = hobe_mesh_matrix_factor(&x->K, err);
    }
    if (x->solver)
        return x;
    hobe_extension_free(x);
    return NULL;
}

enum hobe_status hobe_extension_apply(const struct hobe_extension *x, double *values,
                                      struct hobe_error *err)
{
    const struct hobe_mesh *mesh = x->mesh;
    double *b = hobe_alloc((size_t)mesh->nodes, sizeof *b, err);
    if (!b)
        return HOBE_NO_MEMORY;
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t];
        double k[NODES][NODES];
        stiff_laplace(mesh, t, k);
        for (int i = 0; i < NODES; i++)
            for (int j = 0; j < NODES; j++)
                if (!x->held[n[i]] && x->held[n[j]])
                    b[n[i]] -= k[i][j] * values[n[j]];
    }
    const enum hobe_status status = hobe_linsolve_solve(x->solver, b, err);
    for (int i = 0; i < mesh->nodes; i++)
        if (!x->held[i])
            values[i] = b[i];
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t];
        for (int i = 0; i < 3; i++)
            values[n[3 + i]] = (values[n[i]] + values[n[(i + 1) % 3]]) / 2;
    }
    hobe_free(b);
    return status;
}

void hobe_extension_free(struct hobe_extension *x)
{
    if (!x)
        return;
    hobe_linsolve_free(x->solver);
    hobe_mesh_matrix_free(&x->K);
    hobe_free(x->held);
    hobe_free(x);
}

/* ---- the fields anywhere -------------------------------------------------------------------- */

void hobe_mesh_fields(const struct hobe_mesh *mesh, const double *values,
                      const struct hobe_mesh_place *place, double (*f)[4])
{
    const int *node = mesh->triangle[place->triangle];
    double N[NODES], dN[NODES][2];
    shape(mesh, place->triangle, place->L, N, dN);
    for (int k = 0; k < HOBE_SECTION_FUNCTIONS; k++) {
        f[k][0] = f[k][1] = f[k][2] = 0;
        for (int i = 0; i < NODES; i++) {
            const double value = values[k * mesh->nodes + node[i]];
            f[k][0] += N[i] * value;
            f[k][1] += dN[i][0] * value;
            f[k][2] += dN[i][1] * value;
        }
    }
}

enum hobe_status hobe_mesh_rule(const struct hobe_mesh *mesh, const double *values,
                                struct hobe_rule *rule, struct hobe_error *err)
{
    const int points = POINTS * mesh->triangles;
    if (hobe_rule_new(rule, (size_t)points, err))
        return HOBE_NO_MEMORY;
    for (int i = 0; i < points; i++) {
        struct hobe_section_point *at = rule->point + i;
        struct hobe_mesh_place here = {.triangle = i / POINTS};
        double p[2];
        at->weight = area(mesh, here.triangle) * cubature(i % POINTS, here.L);
        place(mesh, here.triangle, here.L, p);
        at->y = p[0];
        at->z = p[1];
        at->region = mesh->region[here.triangle];
        hobe_mesh_fields(mesh, values, &here, at->f);
    }
    return HOBE_OK;
}

/* ---- orthogonality -------------------------------------------------------------------------- */

/* Iw over I_p^2/A below which there is no w: w of 1e-10 of the section's size, in the square. */
static const double NO_WARPING = 1e-20;

/* The functions behind what they are made orthogonal to. */
enum { ONE, Y, Z, FUNCTION, BASIS = FUNCTION + HOBE_SECTION_FUNCTIONS };

/* G_ij = int E g_i g_j dA. */
static void gram(const hobe_section *section, const struct hobe_rule *rule, double G[BASIS][BASIS])
{
    memset(G, 0, sizeof(double[BASIS][BASIS]));
    for (int p = 0; p < rule->rule.points; p++) {
        const struct hobe_section_point *at = rule->point + p;
        const double weight = at->weight * hobe_section_E(section, at->region);
        double g[BASIS] = {[ONE] = 1, [Y] = at->y, [Z] = at->z};
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
            g[FUNCTION + f] = at->f[f][0];
        for (int i = 0; i < BASIS; i++)
            for (int j = 0; j < BASIS; j++)
                G[i][j] += weight * g[i] * g[j];
    }
}

static double product(double G[BASIS][BASIS], const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < BASIS; i++)
        for (int j = 0; j < BASIS; j++)
            sum += a[i] * G[i][j] * b[j];
    return sum;
}

/* Gram and Schmidt: sum_j T_ij g_j is g_i made orthogonal to those before it.  What rounding leaves
 * of a section that does not warp is no function: T_ij = 0. */
static void orthogonalise(double G[BASIS][BASIS], double T[BASIS][BASIS])
{
    const double none = NO_WARPING * pow(G[Y][Y] + G[Z][Z], 2) / G[ONE][ONE];
    double square[BASIS];
    for (int i = 0; i < BASIS; i++) {
        for (int j = 0; j < BASIS; j++)
            T[i][j] = i == j;
        for (int k = 0; k < i; k++) {
            const double part = square[k] > 0 ? product(G, T[i], T[k]) / square[k] : 0;
            for (int j = 0; j <= k; j++)
                T[i][j] -= part * T[k][j];
        }
        square[i] = product(G, T[i], T[i]);
        if (i == FUNCTION + HOBE_W && square[i] < none) {
            memset(T[i], 0, sizeof T[i]);
            square[i] = 0;
        }
    }
}

/* Makes the functions orthogonal.  About its centre (ys, zs) the warping of a twist is
 * w + zs y - ys z; orthogonal to y and z it does not bend, which is Trefftz's shear centre. */
static enum hobe_status make_orthogonal(const hobe_section *section, const struct hobe_mesh *mesh,
                                        double *values, double centre[2], struct hobe_error *err)
{
    struct hobe_rule rule;
    double G[BASIS][BASIS], T[BASIS][BASIS];
    const enum hobe_status status = hobe_mesh_rule(mesh, values, &rule, err);
    if (status)
        return status;
    gram(section, &rule, G);
    hobe_rule_free(&rule);
    orthogonalise(G, T);
    centre[0] = -T[FUNCTION + HOBE_W][Z];
    centre[1] = T[FUNCTION + HOBE_W][Y];
    for (int n = 0; n < mesh->nodes; n++) {
        double g[BASIS] = {[ONE] = 1, [Y] = mesh->node[n][0], [Z] = mesh->node[n][1]};
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
            g[FUNCTION + f] = values[f * mesh->nodes + n];
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++) {
            double *value = values + f * mesh->nodes + n;
            *value = 0;
            for (int j = 0; j <= FUNCTION + f; j++)
                *value += T[FUNCTION + f][j] * g[j];
        }
    }
    for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
        mirror_restore(mesh, values + f * mesh->nodes);
    return HOBE_OK;
}

enum hobe_status hobe_saint_venant(const hobe_section *section, const struct hobe_mesh *mesh,
                                   double *values, double *energy, double centre[2],
                                   struct hobe_error *err)
{
    const size_t n = (size_t)mesh->nodes, all = HOBE_SECTION_FUNCTIONS * n;
    struct hobe_mesh_matrix K;
    double *b = hobe_alloc(all, sizeof *b, err);
    enum hobe_status status = hobe_mesh_matrix_new(mesh, 1, &K, err);
    if (!status && b) {
        assemble(section, mesh, &K, b);
        hobe_mesh_matrix_close(&K);
        memcpy(values, b, all * sizeof *b);
        status = solve(&K, values, err);
    } else
        status = HOBE_NO_MEMORY;
    *energy = 0;
    for (size_t i = 0; !status && i < n; i++)
        *energy += values[HOBE_W * n + i] * b[HOBE_W * n + i];
    hobe_mesh_matrix_free(&K);
    hobe_free(b);
    return status ? status : make_orthogonal(section, mesh, values, centre, err);
}
