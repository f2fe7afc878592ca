/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energy, force and tangent of one beam element, by Gauss points through its volume. */
#include "pointwise.h"

#include <math.h>
#include <string.h>

enum { POINTS = PW_GAUSS * PW_GAUSS + 1 }; /* of a section; the last one used is the axis */

real pw_epsilon(void)
{
    volatile real e = 1, above = 2;
    while (above > 1) {
        e /= 2;
        above = 1 + e;
    }
    return 2 * e;
}

void pw_gauss(int n, real *x, real *weight)
{
    const real pi = acosl(-1.0L);
    for (int i = 0; i < n; i++) {
        real t = cosl(pi * (i + 0.75L) / (n + 0.5L)), slope = 1;
        for (int step = 0; step < 20; step++) { /* Newton on the Legendre polynomial P_n */
            real p = 1, before = 0;
            for (int k = 1; k <= n; k++) {
                real next = ((2 * k - 1) * t * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = n * (t * p - before) / (t * t - 1);
            t -= p / slope;
        }
        x[i] = (1 - t) / 2;
        weight[i] = 1 / ((1 - t * t) * slope * slope);
    }
}

int pw_goes_with(enum pw_mechanics law, int structural)
{
    return (law == PW_STRUCTURAL) == structural;
}

/* ---- the law -------------------------------------------------------------------------------- */

/* Voigt matrices: `volume` acts on the strain of a point, `mean` on the strain averaged over the
 * section (or taken on the axis). */
struct law {
    real volume[6][6], mean[6][6];
};

static void set_law(const struct pw_beam *beam, struct law *law)
{
    const real E = beam->E, nu = beam->nu;
    const real G = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    const int full = beam->mechanics == PW_FULL, sheared = beam->mechanics == PW_MEAN_SHEAR;
    memset(law, 0, sizeof *law);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            if (full)
                law->volume[i][j] = i == j ? lambda + 2 * G : lambda;
            else {
                law->volume[i][j] = i == j ? E : 0;
                law->mean[i][j] = i == j ? lambda + 2 * G - E : lambda;
            }
        }
    law->volume[3][3] = G;
    law->volume[4][4] = sheared ? G : beam->k2 * G;
    law->volume[5][5] = sheared ? G : beam->k3 * G;
    law->mean[4][4] = sheared ? (beam->k2 - 1) * G : 0;
    law->mean[5][5] = sheared ? (beam->k3 - 1) * G : 0;
}

/* sigma += c C eps; the energy 1/2 c eps:C:eps is returned. */
static number add_stress(real C[6][6], real c, const number *eps, number *sigma)
{
    number twice = 0;
    for (int i = 0; i < 6; i++) {
        number s = 0;
        for (int j = 0; j < 6; j++)
            if (C[i][j] != 0)
                s += C[i][j] * eps[j];
        sigma[i] += c * s;
        twice += c * s * eps[i];
    }
    return twice / 2;
}

/* A deformation gradient where nothing is strained, and its change. */
struct gradient {
    number F0[3][3], H[3][3];
};

/* E = (F'F - F0'F0)/2 of F = F0 + H, written F0'H + H'F: a small H loses no digits. */
static void green_lagrange(const struct gradient *at, number *eps)
{
    static const int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    for (int r = 0; r < 6; r++) {
        const int i = voigt[r][0], j = voigt[r][1];
        number C = 0;
        for (int k = 0; k < 3; k++)
            C += at->F0[k][i] * at->H[k][j] + at->H[k][i] * (at->F0[k][j] + at->H[k][j]);
        eps[r] = r < 3 ? C / 2 : C;
    }
}

/* The first Piola-Kirchhoff stress P = F S. */
static void first_piola(const struct gradient *at, const number *s, number P[3][3])
{
    number F[3][3];
    for (int i = 0; i < 9; i++)
        F[i / 3][i % 3] = at->F0[i / 3][i % 3] + at->H[i / 3][i % 3];
    const number S[3][3] = {{s[0], s[5], s[4]}, {s[5], s[1], s[3]}, {s[4], s[3], s[2]}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            P[i][j] = F[i][0] * S[0][j] + F[i][1] * S[1][j] + F[i][2] * S[2][j];
}

/* ---- quadrature ----------------------------------------------------------------------------- */

struct grid {
    int stations, points; /* points of a section, the axis among them, last and without weight */
    real area;
    real length_weight[PW_GAUSS];
    real N[PW_GAUSS][PW_VECTORS], Nx[PW_GAUSS][PW_VECTORS];
    real xi[PW_GAUSS], weight[POINTS], phi[POINTS][3 * PW_MODES];
};

/* Polynomial degrees decide the number of points.  Along the axis dr/dx and the other fields have
 * degree 2 (3 for cubic Lagrange), strain twice that, energy four times: 8 or 12.  Over the section
 * the energy has four times the degree of the modes. */
static void set_grid(const struct pw_beam *beam, struct grid *g)
{
    const struct pw_element *e = &beam->element;
    int cubic = e->others == PW_CUBIC, degree = e->degree;
    for (int k = 0; k < e->modes; k++)
        if (e->mode[k][0] == 'w' && beam->warping_degree > degree)
            degree = beam->warping_degree;
    int n = 2 * degree + 1 + beam->extra;
    real x[PW_GAUSS], w[PW_GAUSS];
    g->stations = (cubic ? 7 : 5) + beam->extra;
    pw_gauss(g->stations, x, w);
    for (int s = 0; s < g->stations; s++) {
        g->xi[s] = x[s];
        g->length_weight[s] = w[s] * beam->length;
        pw_shape(beam, x[s], g->N[s], g->Nx[s]);
    }
    g->area = beam->width * beam->height;
    g->points = n * n + 1;
    pw_gauss(n, x, w);
    for (int p = 0; p < n * n; p++) {
        real y = beam->y + beam->width * (x[p / n] - 0.5L);
        real z = beam->z + beam->height * (x[p % n] - 0.5L);
        g->weight[p] = g->area * w[p / n] * w[p % n];
        pw_modes(beam, y, z, g->phi[p]);
    }
    g->weight[n * n] = 0;
    pw_modes(beam, 0, 0, g->phi[n * n]);
}

/* The axes of the section in the reference, rows: e_x along dr/dx on the axis, e_y as near to the
 * slope r_y there as can be. */
static void local_axes(const struct pw_beam *beam, const real *N, const real *Nx, real R[3][3])
{
    real slope[2][3] = {{0}}, length = 0, along = 0;
    for (int v = 0; v < beam->element.vectors; v++) {
        const int mode = beam->element.vector[v].mode;
        for (int i = 0; mode < 2 && i < 3; i++)
            slope[mode][i] += (mode ? N[v] : Nx[v]) * beam->reference[3 * v + i];
    }
    for (int i = 0; i < 3; i++) {
        length += slope[0][i] * slope[0][i];
        along += slope[0][i] * slope[1][i];
    }
    real across = 0;
    for (int i = 0; i < 3; i++) {
        R[0][i] = slope[0][i] / sqrtl(length);
        R[1][i] = slope[1][i] - along / length * slope[0][i];
        across += R[1][i] * R[1][i];
    }
    for (int i = 0; i < 3; i++)
        R[1][i] /= sqrtl(across);
    for (int i = 0; i < 3; i++)
        R[2][i] = R[0][(i + 1) % 3] * R[1][(i + 2) % 3] - R[0][(i + 2) % 3] * R[1][(i + 1) % 3];
}

/* X = A^-1 by Cramer's rule; returns det A. */
static real invert(real A[3][3], real X[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            X[j][i] = A[a][c] * A[b][d] - A[a][d] * A[b][c];
        }
    const real det = A[0][0] * X[0][0] + A[0][1] * X[1][0] + A[0][2] * X[2][0];
    for (int i = 0; i < 9; i++)
        X[i / 3][i % 3] /= det;
    return det;
}

/* The gradient of N_v phi_v, for all vectors at a point: G[v] = d/dX_j on the section's axes.
 * Returns det dX/d(x,y,z), the volume there over that of the straight beam. */
static real gradients(const struct pw_beam *beam, real xi, const real *N, const real *Nx,
                      const real *phi, real G[PW_VECTORS][3])
{
    const int vectors = beam->element.vectors;
    real R[3][3], J[3][3] = {{0}}, back[3][3];
    for (int v = 0; v < vectors; v++) {
        const int mode = beam->element.vector[v].mode, w = beam->element.mode[mode][0] == 'w';
        const real *f = phi + 3 * mode, grown = w ? 1 + beam->taper * xi : 1;
        G[v][0] = (Nx[v] * grown + (w ? N[v] * beam->taper / beam->length : 0)) * f[0];
        G[v][1] = N[v] * grown * f[1];
        G[v][2] = N[v] * grown * f[2];
    }
    if (!beam->reference)
        return 1;
    local_axes(beam, N, Nx, R);
    for (int v = 0; v < vectors; v++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int a = 0; a < 3; a++)
                    J[i][j] += R[i][a] * beam->reference[3 * v + a] * G[v][j];
    const real volume = invert(J, back);
    for (int v = 0; v < vectors; v++) {
        const real along[3] = {G[v][0], G[v][1], G[v][2]};
        for (int j = 0; j < 3; j++)
            G[v][j] = along[0] * back[0][j] + along[1] * back[1][j] + along[2] * back[2][j];
    }
    return volume;
}

/* Parts of the deformation: of all modes, and of the warping functions alone. */
enum { WHOLE, WARPING, PARTS };

static int takes_part(const struct pw_element *e, int v, int part)
{
    return part == WHOLE || e->mode[e->vector[v].mode][0] == 'w';
}

/* F_ij = d r_i/d X_j, as far as a part of the modes makes it. */
static void deformation(const struct pw_element *e, int part, real G[PW_VECTORS][3],
                        const number *q, number F[3][3])
{
    memset(F, 0, 9 * sizeof F[0][0]);
    for (int v = 0; v < e->vectors; v++)
        for (int i = 0; takes_part(e, v, part) && i < 3; i++)
            for (int j = 0; j < 3; j++)
                F[i][j] += q[3 * v + i] * G[v][j];
}

/* The law that spreads the in-plane strain of warping, w[p] at a point, evenly over the section:
 * its energy is that of eps - w + mean(w).  W: of the warping functions. */
static void spread(int n, const real *weight, real area, const struct gradient *W, number (*eps)[6])
{
    number w[POINTS][6], mean[6] = {0};
    for (int p = 0; p < n; p++) {
        green_lagrange(W + p, w[p]);
        for (int i = 1; i < 4; i++)
            mean[i] += weight[p] / area * w[p][i];
    }
    for (int p = 0; p < n; p++)
        for (int i = 1; i < 4; i++)
            eps[p][i] += mean[i] - w[p][i];
}

/* What works on dW: less the stress in the plane at each point, plus its mean. */
static void spread_stress(int n, const real *weight, real area, const struct gradient *W,
                          number (*sigma)[6], number (*P)[3][3])
{
    number sum[6] = {0};
    for (int p = 0; p < n; p++)
        for (int i = 1; i < 4; i++)
            sum[i] += sigma[p][i];
    for (int p = 0; p < n; p++) {
        number s[6] = {0};
        for (int i = 1; i < 4; i++)
            s[i] = weight[p] / area * sum[i] - sigma[p][i];
        first_piola(W + p, s, P[p]);
    }
}

/* From F at the points of a section: the energy per length, and P times the weight of each point,
 * whose work on dF is the variation of that energy; of both parts. */
static number section(const struct pw_beam *beam, const struct law *law, int n, const real *weight,
                      struct gradient (*F)[POINTS], number (*P)[POINTS][3][3])
{
    const int axis = n - 1, on_axis = beam->mechanics == PW_AXIS;
    const int even = beam->mechanics == PW_AVERAGE || beam->mechanics == PW_MEAN_SHEAR;
    real area = 0;
    struct law C = *law;
    number eps[POINTS][6], sigma[POINTS][6], mean[6] = {0}, mean_stress[6] = {0}, energy = 0;
    for (int p = 0; p < n; p++)
        area += weight[p];
    for (int p = 0; p < n; p++) {
        green_lagrange(&F[WHOLE][p], eps[p]);
        for (int i = 0; i < 6; i++)
            mean[i] += on_axis ? (p == axis) * eps[p][i] : weight[p] / area * eps[p][i];
    }
    energy += area * add_stress(C.mean, 1, mean, mean_stress);
    if (even)
        spread(n, weight, area, F[WARPING], eps);
    memset(sigma, 0, sizeof sigma);
    for (int p = 0; p < n; p++)
        energy += add_stress(C.volume, weight[p], eps[p], sigma[p]);
    memset(P[WARPING], 0, (size_t)n * sizeof P[WARPING][0]);
    if (even)
        spread_stress(n, weight, area, F[WARPING], sigma, P[WARPING]);
    for (int p = 0; p < n; p++) {
        /* d mean(eps) is d eps on the axis, or the weighted mean of d eps. */
        real share = on_axis ? (p == axis) * area : weight[p];
        for (int i = 0; i < 6; i++)
            sigma[p][i] += share * mean_stress[i];
        first_piola(&F[WHOLE][p], sigma[p], P[WHOLE][p]);
    }
    return energy;
}

/* ---- energy, force, tangent ----------------------------------------------------------------- */

struct station {
    real weight[POINTS], G[POINTS][PW_VECTORS][3];
    struct gradient F[PARTS][POINTS];
    number P[PARTS][POINTS][3][3];
};

/* F of a part at a point in state q, which is counted from beam->from or is itself a state; then
 * nothing is strained where the section's axes are, and functions that warp as in the reference. */
static void set_gradient(const struct pw_beam *beam, int part, real G[PW_VECTORS][3],
                         const number *q, struct gradient *at)
{
    const struct pw_element *e = &beam->element;
    const real *rest = beam->from ? beam->from : beam->reference;
    number q0[PW_DOFS];
    for (int i = 0; i < 3 * e->vectors; i++)
        q0[i] = rest ? rest[i] : 0; /* straight: warping functions rest */
    deformation(e, part, G, q, at->H);
    if (part == WHOLE && !beam->from)
        for (int i = 0; i < 9; i++)
            at->F0[i / 3][i % 3] = i % 4 == 0;
    else
        deformation(e, part, G, q0, at->F0);
    for (int i = 0; !beam->from && i < 9; i++)
        at->H[i / 3][i % 3] -= at->F0[i / 3][i % 3];
}

static void set_station(const struct pw_beam *beam, const struct grid *g, int s, const number *q,
                        struct station *station)
{
    for (int p = 0; p < g->points; p++) {
        const real *N = g->N[s], *Nx = g->Nx[s];
        station->weight[p] =
            g->weight[p] * gradients(beam, g->xi[s], N, Nx, g->phi[p], station->G[p]);
        for (int part = 0; part < PARTS; part++)
            set_gradient(beam, part, station->G[p], q, &station->F[part][p]);
    }
}

/* f += weight * P : d(dr/dX)/dq at a point. */
static void add_force(const struct pw_element *e, struct station *t, int p, real weight, number *f)
{
    for (int v = 0; v < e->vectors; v++)
        for (int part = 0; part < PARTS; part++)
            for (int i = 0; takes_part(e, v, part) && i < 3; i++)
                for (int j = 0; j < 3; j++)
                    f[3 * v + i] += weight * t->P[part][p][i][j] * t->G[p][v][j];
}

/* Energy and, unless f is NULL, force. */
static number evaluate(const struct pw_beam *beam, const number *q, number *f)
{
    static struct grid g;
    static struct station t;
    struct law law;
    number energy = 0;
    set_law(beam, &law);
    set_grid(beam, &g);
    for (int s = 0; s < g.stations; s++) {
        set_station(beam, &g, s, q, &t);
        energy += g.length_weight[s] * section(beam, &law, g.points, t.weight, t.F, t.P);
        for (int p = 0; f && p < g.points; p++)
            add_force(&beam->element, &t, p, g.length_weight[s], f);
    }
    return energy;
}

number pw_energy(const struct pw_beam *beam, const number *q)
{
    return beam->element.structural ? pw_rod(beam, q, NULL) : evaluate(beam, q, NULL);
}

void pw_force(const struct pw_beam *beam, const number *q, number *f)
{
    for (int i = 0; i < 3 * beam->element.vectors; i++)
        f[i] = 0;
    if (beam->element.structural)
        pw_rod(beam, q, f);
    else
        evaluate(beam, q, f);
}

/* One column of a station's tangent: the imaginary part of the force at q + ih e_column.  Only row
 * column % 3 of F feels that vector. */
static void tangent_column(const struct pw_beam *beam, const struct law *law, const struct grid *g,
                           struct station *t, int s, int column, real *K)
{
    static struct gradient F[PARTS][POINTS];
    const real h = 0x1p-100L;
    const struct pw_element *e = &beam->element;
    memcpy(F, t->F, sizeof F);
    for (int part = 0; part < PARTS; part++)
        for (int p = 0; takes_part(e, column / 3, part) && p < g->points; p++)
            for (int j = 0; j < 3; j++)
                F[part][p].H[column % 3][j] += I * h * t->G[p][column / 3][j];
    section(beam, law, g->points, t->weight, F, t->P);
    for (int p = 0; p < g->points; p++)
        for (int v = 0; v < e->vectors; v++)
            for (int part = 0; part < PARTS; part++)
                for (int i = 0; takes_part(e, v, part) && i < 3; i++)
                    for (int j = 0; j < 3; j++)
                        K[(3 * v + i) * 3 * e->vectors + column] +=
                            cimagl(t->P[part][p][i][j]) / h * g->length_weight[s] * t->G[p][v][j];
}

/* The same for a rod, whose force is cheap: as a whole. */
static void rod_column(const struct pw_beam *beam, number *q, int column, real *K)
{
    const real h = 0x1p-100L;
    const int dofs = 3 * beam->element.vectors;
    number f[PW_DOFS];
    q[column] += I * h;
    pw_force(beam, q, f);
    q[column] = creall(q[column]);
    for (int i = 0; i < dofs; i++)
        K[i * dofs + column] = cimagl(f[i]) / h;
}

void pw_tangent(const struct pw_beam *beam, const real *q, real *K)
{
    static struct grid g;
    static struct station t;
    const int dofs = 3 * beam->element.vectors;
    struct law law;
    number position[PW_DOFS];
    set_law(beam, &law);
    set_grid(beam, &g);
    for (int i = 0; i < dofs; i++)
        position[i] = q[i];
    for (int i = 0; i < dofs * dofs; i++)
        K[i] = 0;
    for (int column = 0; beam->element.structural && column < dofs; column++)
        rod_column(beam, position, column, K);
    for (int s = 0; !beam->element.structural && s < g.stations; s++) {
        set_station(beam, &g, s, position, &t);
        for (int column = 0; column < dofs; column++)
            tangent_column(beam, &law, &g, &t, s, column, K);
    }
}

/* ---- strain, mass --------------------------------------------------------------------------- */

void pw_strain(const struct pw_beam *beam, const real *q, real xi, real y, real z, real *E)
{
    real N[PW_VECTORS], Nx[PW_VECTORS], phi[3 * PW_MODES], G[PW_VECTORS][3];
    number position[PW_DOFS], eps[6];
    struct gradient F;
    for (int i = 0; i < 3 * beam->element.vectors; i++)
        position[i] = q[i];
    pw_shape(beam, xi, N, Nx);
    pw_modes(beam, y, z, phi);
    gradients(beam, xi, N, Nx, phi, G);
    set_gradient(beam, WHOLE, G, position, &F);
    green_lagrange(&F, eps);
    for (int i = 0; i < 6; i++)
        E[i] = creall(eps[i]);
}

void pw_mass(const struct pw_beam *beam, real density, real *M)
{
    static struct grid g;
    const struct pw_element *e = &beam->element;
    set_grid(beam, &g);
    memset(M, 0, (size_t)(e->vectors * e->vectors) * sizeof *M);
    for (int s = 0; s < g.stations; s++)
        for (int p = 0; p < g.points; p++) {
            real value[PW_VECTORS], G[PW_VECTORS][3],
                weight = density * g.length_weight[s] * g.weight[p];
            weight *= gradients(beam, g.xi[s], g.N[s], g.Nx[s], g.phi[p], G);
            for (int v = 0; v < e->vectors; v++) {
                value[v] = g.N[s][v] * g.phi[p][3 * e->vector[v].mode];
                if (e->mode[e->vector[v].mode][0] == 'w')
                    value[v] *= 1 + beam->taper * g.xi[s];
            }
            for (int v = 0; v < e->vectors; v++)
                for (int w = 0; w < e->vectors; w++)
                    M[v * e->vectors + w] += weight * value[v] * value[w];
        }
}

real pw_density(const struct pw_beam *beam, const real *E, real *volume, real *mean)
{
    struct law law;
    number eps[6], stress[6] = {0}, mean_stress[6] = {0}, energy;
    set_law(beam, &law);
    for (int i = 0; i < 6; i++)
        eps[i] = E[i];
    energy = add_stress(law.volume, 1, eps, stress) + add_stress(law.mean, 1, eps, mean_stress);
    for (int i = 0; i < 6; i++) {
        volume[i] = creall(stress[i]);
        mean[i] = creall(mean_stress[i]);
    }
    return creall(energy);
}
