/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of a kernel that no law touches: names and sizes, shape functions, strain, mass. */
#include "check.h"
#include "checks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Vectors in the order of the evaluator's table; its reference is ours. */
static void check_table(const struct fixture *fx)
{
    const struct hobe_kernel *k = fx->kernel;
    const struct pw_element *e = &fx->beam.element;
    const real frame[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    real X[PW_DOFS], *Y, error = 0;
    int wrong = k->vectors != e->vectors || k->nodes != e->nodes || k->modes != e->modes;
    check("sizes are those of the published element", k->name, wrong, 0);
    if (wrong)
        return;
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *a = &k->vector[v];
        const struct pw_vector *b = &e->vector[v];
        wrong += a->node != b->node || a->slope != b->slope ||
                 strcmp(k->mode[a->mode], e->mode[b->mode]) != 0;
    }
    check("vectors are those of the published element", k->name, wrong, 0);
    Y = grab((size_t)fx->dofs, sizeof *Y);
    reference(fx, Y);
    pw_reference(&fx->beam, frame, X);
    for (int i = 0; i < fx->dofs; i++)
        error = fmaxl(error, fabsl(X[i] - Y[i]));
    check("reference nodal vectors", k->name, error, 1e-15L);
    free(Y);
}

void check_declaration(const struct fixture *fx)
{
    const struct hobe_kernel *k = fx->kernel;
    const int M = k->modes;
    const char *law = k->mechanics;
    CHECK(k->abi == HOBE_KERNEL_ABI, k->name);
    CHECK(k->hash && *k->hash && k->source && *k->source, k->name);
    CHECK(!strcmp(law, "average") || !strcmp(law, "axis") || !strcmp(law, "full") || fx->structural,
          k->name);
    CHECK(k->normals == (fx->structural ? 6 : M * M), k->name);
    CHECK(k->shears == (fx->structural ? 3 : M * (M - 1)), k->name);
    CHECK((k->axis_rule != NULL) == fx->structural, k->name);
    CHECK((k->trilinear == NULL) == fx->structural, k->name);
    CHECK((k->gram == NULL) == fx->structural, k->name);
    CHECK((k->series == NULL) == fx->structural, k->name);
    CHECK(k->flops_force > 0 && k->flops_tangent > k->flops_force, k->name);
    CHECK(!strcmp(k->mode[0], "1"), k->name);
    CHECK(k->functions == 0 || !strcmp(k->function[0], "w"), k->name);
    CHECK(k->node[0] == 0 && k->node[k->nodes - 1] == 1, k->name);
    if (fx->known)
        check_table(fx);
}

/* ---- shape functions ------------------------------------------------------------------------ */

/* The functional of vector v, value or slope of its field at its node, gives 1 on its own function
 * and 0 on the others of the field.  Slopes count times the length.  Round-off of cubics. */
static void check_kronecker(const struct fixture *fx, double *N, double *Nx)
{
    const struct hobe_kernel *k = fx->kernel;
    const double l = (double)fx->beam.length;
    double error = 0;
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *a = &k->vector[v];
        k->shape(k->node[a->node], l, N, Nx);
        for (int w = 0; w < k->vectors; w++) {
            const struct hobe_vector *b = &k->vector[w];
            double size = (a->slope ? l : 1) / (b->slope ? l : 1);
            double value = size * (a->slope ? Nx[w] : N[w]);
            if (a->mode == b->mode)
                error = fmax(error, fabs(value - (v == w)));
        }
    }
    check("shape functions: 1 at their own node, 0 elsewhere", k->name, error, 2e-14L);
}

/* A field with nodal values 1 is 1, and one with values x and slopes 1 is x. */
static void check_completeness(const struct fixture *fx, double *N, double *Nx)
{
    const struct hobe_kernel *k = fx->kernel;
    const double l = (double)fx->beam.length;
    const double xi = 0.3;
    k->shape(xi, l, N, Nx);
    for (int m = 0; m < k->modes; m++) {
        double one = 0, slope = 0, x = 0, unit = 0;
        for (int v = 0; v < k->vectors; v++) {
            const struct hobe_vector *a = &k->vector[v];
            double at = a->slope ? 1 : l * k->node[a->node];
            if (a->mode != m)
                continue;
            one += a->slope ? 0 : N[v];
            slope += a->slope ? 0 : Nx[v];
            x += at * N[v];
            unit += at * Nx[v];
        }
        double error = fmax(fabs(one - 1), fabs(slope) * l);
        check("shape functions: partition of unity", k->name, error, 2e-14L);
        error = fmax(fabs(x / l - xi), fabs(unit - 1));
        check("shape functions: linear fields are exact", k->name, error, 2e-14L);
    }
}

/* Values and derivatives against the evaluator, and the derivative against the five-point
 * difference, which is exact for the polynomials of degree <= 4 that these are. */
static void check_functions(const struct fixture *fx, double *N, double *Nx, double *D)
{
    const struct hobe_kernel *k = fx->kernel;
    const double l = (double)fx->beam.length, h = 0.125;
    static const double weight[4] = {1, -8, 8, -1}, step[4] = {-2, -1, 1, 2};
    for (double xi = 0; xi <= 1; xi += 1 / 16.0) {
        double error = 0;
        real n[PW_VECTORS], nx[PW_VECTORS];
        memset(D, 0, (size_t)k->vectors * sizeof *D);
        for (int s = 0; s < 4; s++) {
            k->shape(xi + step[s] * h, l, N, Nx);
            for (int v = 0; v < k->vectors; v++)
                D[v] += weight[s] * N[v] / (12 * h * l);
        }
        k->shape(xi, l, N, Nx);
        for (int v = 0; v < k->vectors; v++) {
            double size = k->vector[v].slope ? 1 : l; /* makes the derivative dimensionless */
            error = fmax(error, size * fabs(Nx[v] - D[v]));
        }
        check("shape functions: derivative by differences", k->name, error, 1e-12L);
        if (!fx->known)
            continue;
        pw_shape(&fx->beam, xi, n, nx);
        error = 0;
        for (int v = 0; v < k->vectors; v++) {
            real size = k->vector[v].slope ? fx->beam.length : 1;
            error = fmax(error, (double)fabsl((N[v] - n[v]) / size));
            error = fmax(error, (double)fabsl((Nx[v] - nx[v]) / size * fx->beam.length));
        }
        check("shape functions: against the evaluator", k->name, error, 1e-13L);
    }
}

void check_shape(const struct fixture *fx)
{
    const size_t n = (size_t)fx->kernel->vectors;
    double *N = grab(3 * n, sizeof *N);
    check_kronecker(fx, N, N + n);
    check_completeness(fx, N, N + n);
    check_functions(fx, N, N + n, N + 2 * n);
    free(N);
}

/* ---- section modes and strain --------------------------------------------------------------- */

/* Modes by name at a random point of the section, relative to the largest over the section. */
static void check_modes(const struct fixture *fx, double y, double z, double (*phi)[4])
{
    real exact[3 * PW_MODES], error = 0;
    pw_modes(&fx->beam, y, z, exact);
    for (int m = 0; m < fx->kernel->modes; m++) {
        int e = 0;
        while (strcmp(fx->beam.element.mode[e], fx->kernel->mode[m]))
            e++;
        for (int d = 0; d < 3; d++) {
            real size = fabsl(exact[3 * e + d]) + 1e-30L;
            error = fmaxl(error, fabsl(phi[m][d] - exact[3 * e + d]) / size);
        }
    }
    check("section modes: against the evaluator", fx->kernel->name, error, 1e-14L);
}

/* Strain at random points of random states of order 0.3; round-off of sums over up to 40 vectors.
 */
void check_strain(const struct fixture *fx)
{
    const size_t n = (size_t)fx->kernel->vectors, dofs = (size_t)fx->dofs;
    double *N = grab(2 * n + 2 * dofs, sizeof *N), *q0 = N + 2 * n, *u = q0 + dofs;
    real *q = grab(dofs, sizeof *q), E[6];
    struct batch b;
    batch_open(fx, &b);
    batch_random(fx, &b, 0.3L);
    for (int lane = 0; fx->known && lane < HOBE_LANES; lane++) {
        double f[HOBE_MAX_FUNCTIONS][4], phi[HOBE_MAX_MODES][4], e[6];
        double xi = (double)random_real(0, 1), y = (double)random_real(-0.015L, 0.015L);
        double z = (double)random_real(-0.025L, 0.025L);
        real error = 0, norm = 0;
        test_functions(y, z, f);
        fx->kernel->shape(xi, (double)fx->beam.length, N, N + n);
        fx->kernel->section_modes(y, z, (const double(*)[4])f, phi);
        check_modes(fx, y, z, phi);
        grow_functions(fx, xi, f);
        fx->kernel->section_modes(y, z, (const double(*)[4])f, phi);
        for (size_t i = 0; i < dofs; i++) {
            q0[i] = b.q0[i][lane];
            u[i] = b.u[i][lane];
        }
        fx->kernel->strain(N, N + n, (const double(*)[4])phi, q0, u, e);
        lane_position(fx, &b, lane, q);
        pw_strain(&fx->beam, q, xi, y, z, E);
        for (int i = 0; i < 6; i++) {
            error = fmaxl(error, fabsl(e[i] - E[i]));
            norm = fmaxl(norm, fabsl(E[i]));
        }
        check("strain: against the evaluator", where(fx, lane), error / norm, 1e-12L);
    }
    batch_close(&b);
    free(N);
    free(q);
}

/* ---- mass ----------------------------------------------------------------------------------- */

/* a'Mb for one component of nodal vectors. */
static real bilinear(const struct fixture *fx, const real *a, const real *b, int i, int j)
{
    const int n = fx->kernel->vectors;
    real s = 0;
    for (int v = 0; v < n; v++)
        for (int w = 0; w < n; w++)
            s += a[3 * v + i] * fx->inv.mass[v * n + w] * b[3 * w + j];
    return s;
}

/* int rho x_i x_j dV about the first node. */
static real second_moment(const struct fixture *fx, int i, int j)
{
    const real size[3] = {fx->beam.length, fx->beam.width, fx->beam.height};
    const real centre[3] = {fx->beam.length / 2, fx->beam.y, fx->beam.z};
    const real m = fx->density * size[0] * size[1] * size[2];
    return m * (centre[i] * centre[j] + (i == j ? size[i] * size[i] / 12 : 0));
}

/* Rigid bodies are in the element's space: a rotation about the first node, v = o x X, has the
 * kinetic energy 1/2 (o.o tr S - o.S o) with the box's second moments S. */
static void check_rotation(const struct fixture *fx, const real *X)
{
    const real o[3] = {0.8L, -1.1L, 0.6L};
    real *v = grab((size_t)fx->dofs, sizeof *v), energy = 0, exact = 0;
    for (int i = 0; i < fx->dofs; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        const real *x = X + i / 3 * 3;
        v[i] = o[j] * x[k] - o[k] * x[j];
    }
    for (int i = 0; i < 3; i++) {
        energy += bilinear(fx, v, v, i, i) / 2;
        for (int j = 0; j < 3; j++)
            exact +=
                (o[j] * o[j] * second_moment(fx, i, i) - o[i] * o[j] * second_moment(fx, i, j)) / 2;
    }
    check("mass: kinetic energy of a rigid rotation", fx->kernel->name, fabsl(energy / exact - 1),
          1e-13L);
    free(v);
}

/* The mass rho A l and its first moment. */
static void check_translation(const struct fixture *fx, const real *X)
{
    const real l = fx->beam.length, m = fx->density * l * fx->beam.width * fx->beam.height;
    real *one = grab((size_t)fx->dofs, sizeof *one);
    for (int i = 0; i < fx->dofs; i++)
        one[i] = is_position(fx, i / 3);
    check("mass: rho A l in all", fx->kernel->name, fabsl(bilinear(fx, one, one, 0, 0) / m - 1),
          1e-13L);
    const real centre[3] = {l / 2, fx->beam.y, fx->beam.z};
    for (int i = 0; i < 3; i++)
        check("mass: first moment, over rho A l^2", fx->kernel->name,
              fabsl(bilinear(fx, one, X, i, i) / m - centre[i]) / l, 1e-13L);
    free(one);
}

/* A straight reference given as if it were curved has the same mass, from the points of the axis;
 * entry by entry as below. */
static void check_mass_of_stations(const struct fixture *fx)
{
    const int n = fx->kernel->vectors;
    struct fixture varying = *fx;
    struct hobe_invariants inv;
    real error = 0;
    varying.curved = grab((size_t)fx->dofs, sizeof *varying.curved);
    reference(fx, varying.curved);
    make_invariants(&varying, fx->kernel->stations, fx->kernel->stations, &inv);
    for (int v = 0; v < n; v++)
        for (int w = 0; w < n; w++) {
            const double *m = fx->inv.mass;
            const real size = sqrtl((real)m[v * n + v] * m[w * n + w]);
            error = fmaxl(error, fabsl((real)inv.mass[v * n + w] - m[v * n + w]) / size);
        }
    check("mass: summed over stations", fx->kernel->name, error, 1e-13L);
    free_invariants(&inv);
    free(varying.curved);
}

/* Entry by entry relative to the diagonal, |m_vw| <= sqrt(m_vv m_ww): round-off of a quadrature. */
void check_mass(const struct fixture *fx)
{
    const int n = fx->kernel->vectors;
    const double *m = fx->inv.mass;
    real skew = 0, error = 0, *M = grab((size_t)(n * n), sizeof *M);
    real *X = grab((size_t)fx->dofs, sizeof *X);
    reference(fx, X);
    if (!fx->curved) {
        check_translation(fx, X);
        check_rotation(fx, X);
        check_mass_of_stations(fx);
    }
    free(X);
    if (fx->known)
        pw_mass(&fx->beam, fx->density, M);
    for (int v = 0; v < n; v++)
        for (int w = 0; w < n; w++) {
            real size = sqrtl((real)m[v * n + v] * m[w * n + w]);
            skew = fmaxl(skew, fabsl((real)m[v * n + w] - m[w * n + v]) / size);
            if (fx->known)
                error = fmaxl(error, fabsl(m[v * n + w] - M[v * n + w]) / size);
        }
    check("mass: symmetric", fx->kernel->name, skew, 1e-14L);
    check("mass: against the evaluator", fx->kernel->name, error, 1e-13L);
    free(M);
}
