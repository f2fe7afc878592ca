/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact solutions that every element must contain: rigid motion and homogeneous deformation. */
#include "check.h"
#include "checks.h"

#include <math.h>
#include <stdlib.h>

static real EA(const struct fixture *fx)
{
    return fx->beam.E * fx->beam.width * fx->beam.height;
}

/* A lane's state from nodal vectors X in the reference (along section axes) to q = R0 X, and
 * displaced to R F X, the positions moved by `shift` besides. */
static void set_lane(const struct fixture *fx, struct batch *b, int lane, const real *F,
                     const real *R, real shift)
{
    real *X = grab(4 * (size_t)fx->dofs, sizeof *X), *FX = X + fx->dofs, *q0 = X + 2 * fx->dofs;
    real *q = X + 3 * fx->dofs, R0[9];
    random_rotation(R0);
    reference(fx, X);
    turn(fx, R0, X, q0);
    turn(fx, F, X, FX);
    turn(fx, R, FX, q);
    for (int i = 0; i < fx->dofs; i++)
        q[i] += (is_position(fx, i / 3) ? shift : 0) - q0[i];
    batch_set(fx, b, lane, q0, q);
    free(X);
}

/* The largest sum of |dN/dx| over the positions: what turns an error of a position into one of
 * strain. */
static real amplification(const struct fixture *fx)
{
    real worst = 0;
    for (int s = 0; s < fx->inv.stations; s++) {
        real sum = 0;
        for (int v = 0; v < fx->kernel->vectors; v++)
            if (is_position(fx, v))
                sum += fabsl((real)fx->inv.Nx[s * fx->kernel->vectors + v]);
        worst = fmaxl(worst, sum);
    }
    return worst;
}

static void rigid(const struct fixture *fx, struct batch *b, const char *name, real shift,
                  real bound)
{
    const real unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    real R[9], *f = grab((size_t)fx->dofs, sizeof *f);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        random_rotation(R);
        set_lane(fx, b, lane, unit, R, shift);
    }
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_vector(fx, b->f, lane, f);
        check(name, where(fx, lane), force_norm(fx, f) / (EA(fx) * fx->beam.length), bound);
    }
    free(f);
}

/* No force.  What remains after a translation is the rounding of the given displacements, half a
 * unit in the last place of 1e3 m, 5.7e-14 m, over the distance of the nodes: some 1e-12, with a
 * factor for the sums of both signs.  (check_translation shows that this is all.) */
void check_rigid(const struct fixture *fx)
{
    const real far = 1000, unit = 0x1p-44L;
    struct batch b;
    batch_open(fx, &b);
    rigid(fx, &b, "rigid rotation: force/EA", 0, 1e-13L);
    rigid(fx, &b, "rigid rotation and translation by 1e3 m: force/EA", far,
          10 * unit * amplification(fx));
    batch_close(&b);
}

/* ---- homogeneous deformation ---------------------------------------------------------------- */

/* F of a lane: stretches, the three simple shears, then anything near the unit matrix. */
static void deformation(int lane, real *F)
{
    for (int i = 0; i < 9; i++)
        F[i] = i % 4 == 0;
    switch (lane) {
    case 0:
        F[0] = 1.25L;
        break;
    case 1:
        F[0] = 0.8L;
        F[4] = 1.1L;
        F[8] = 1.2L;
        break;
    case 2:
        F[1] = 0.4L; /* x += 0.4 y */
        break;
    case 3:
        F[6] = 0.4L; /* z += 0.4 x */
        break;
    case 4:
        F[5] = 0.4L; /* y += 0.4 z */
        break;
    default:
        for (int i = 0; i < 9; i++)
            F[i] += random_real(-0.3L, 0.3L);
    }
}

static void strain_of(const real *F, real *E)
{
    real C[3][3] = {{0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                C[i][j] += F[3 * k + i] * F[3 * k + j];
    for (int i = 0; i < 3; i++)
        E[i] = (C[i][i] - 1) / 2;
    E[3] = C[1][2];
    E[4] = C[0][2];
    E[5] = C[0][1];
}

/* P = R F S for a Voigt stress. */
static void piola(const real *R, const real *F, const real *s, real P[3][3])
{
    const real S[3][3] = {{s[0], s[5], s[4]}, {s[5], s[1], s[3]}, {s[4], s[3], s[2]}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            P[i][j] = 0;
            for (int k = 0; k < 3; k++)
                for (int m = 0; m < 3; m++)
                    P[i][j] += R[3 * i + k] * F[3 * k + m] * S[m][j];
        }
}

/* Integrals of modes over the section: moment[m] = int phi_m, int d phi_m/dy, int d phi_m/dz; by
 * Boole's rule, exact up to degree 5 in each direction. */
static void section_moments(const struct fixture *fx, real moment[HOBE_MAX_MODES][3])
{
    static const real weight[5] = {7 / 90.0L, 32 / 90.0L, 12 / 90.0L, 32 / 90.0L, 7 / 90.0L};
    for (int p = 0; p < 25; p++) {
        double f[HOBE_MAX_FUNCTIONS][4], phi[HOBE_MAX_MODES][4];
        double y = (double)(fx->beam.y + fx->beam.width * (p / 5 - 2) / 4);
        double z = (double)(fx->beam.z + fx->beam.height * (p % 5 - 2) / 4);
        real area = fx->beam.width * fx->beam.height * weight[p / 5] * weight[p % 5];
        test_functions(y, z, f);
        fx->kernel->section_modes(y, z, (const double(*)[4])f, phi);
        for (int m = 0; m < fx->kernel->modes; m++)
            for (int d = 0; d < 3; d++)
                moment[m][d] = (p ? moment[m][d] : 0) + area * phi[m][d];
    }
}

/* The same as a strain meant on the axis takes them: the area times the values there. */
static void axis_moments(const struct fixture *fx, real moment[HOBE_MAX_MODES][3])
{
    double f[HOBE_MAX_FUNCTIONS][4], phi[HOBE_MAX_MODES][4];
    test_functions(0, 0, f);
    fx->kernel->section_modes(0, 0, (const double(*)[4])f, phi);
    for (int m = 0; m < fx->kernel->modes; m++)
        for (int d = 0; d < 3; d++)
            moment[m][d] = fx->beam.width * fx->beam.height * phi[m][d];
}

/* integral[v] = int N_v dx (Simpson, exact for cubics), slope[v] = int N_v' dx = N_v(l) - N_v(0).
 */
static void axis_integrals(const struct fixture *fx, real *integral, real *slope)
{
    const int n = fx->kernel->vectors;
    const double l = (double)fx->beam.length;
    double *N = grab(4 * (size_t)n, sizeof *N);
    for (int i = 0; i < 3; i++)
        fx->kernel->shape(i / 2.0, l, N + i * n, N + 3 * n);
    for (int v = 0; v < n; v++) {
        integral[v] = fx->beam.length * ((real)N[v] + 4 * N[n + v] + N[2 * n + v]) / 6;
        slope[v] = (real)N[2 * n + v] - N[v];
    }
    free(N);
}

/* f_v += int P : grad(N_v phi_v) for a constant P. */
static void add_force(const struct fixture *fx, real P[3][3], real moment[HOBE_MAX_MODES][3],
                      const real *integral, const real *slope, real *f)
{
    for (int v = 0; v < fx->kernel->vectors; v++) {
        const real *m = moment[fx->kernel->vector[v].mode];
        for (int i = 0; i < 3; i++)
            f[3 * v + i] += P[i][0] * slope[v] * m[0] + P[i][1] * integral[v] * m[1] +
                            P[i][2] * integral[v] * m[2];
    }
}

/* The exact energy A l W(E), and the nodal forces by virtual work of the constant stress. */
static real exact_force(const struct fixture *fx, const real *F, const real *R, real *f)
{
    const size_t n = (size_t)fx->kernel->vectors;
    real moment[HOBE_MAX_MODES][3], E[6], volume[6], mean[6], P[3][3], W;
    real *integral = grab(2 * n, sizeof *integral), *slope = integral + n;
    strain_of(F, E);
    W = pw_density(&fx->beam, E, volume, mean);
    axis_integrals(fx, integral, slope);
    for (int i = 0; i < fx->dofs; i++)
        f[i] = 0;
    section_moments(fx, moment);
    piola(R, F, volume, P);
    add_force(fx, P, moment, integral, slope, f);
    if (fx->beam.mechanics == PW_AXIS)
        axis_moments(fx, moment);
    piola(R, F, mean, P);
    add_force(fx, P, moment, integral, slope, f);
    free(integral);
    return fx->beam.width * fx->beam.height * fx->beam.length * W;
}

/* The nodal vectors of r = F X are in every element's space.  Round-off of sums. */
void check_homogeneous(const struct fixture *fx)
{
    real F[HOBE_LANES][9], R[HOBE_LANES][9], *f = grab(2 * (size_t)fx->dofs, sizeof *f);
    real *exact = f + fx->dofs;
    struct batch b;
    batch_open(fx, &b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        deformation(lane, F[lane]);
        random_rotation(R[lane]);
        set_lane(fx, &b, lane, F[lane], R[lane], 0.5L);
    }
    run_energy(fx, &fx->inv, &b);
    run_force(fx, &fx->inv, &b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        real U = exact_force(fx, F[lane], R[lane], exact);
        lane_vector(fx, b.f, lane, f);
        check("homogeneous deformation: energy A l W(E)", where(fx, lane),
              fabsl(b.U[0][lane] / U - 1), 1e-12L);
        check("homogeneous deformation: nodal forces", where(fx, lane), force_error(fx, f, exact),
              1e-12L);
    }
    batch_close(&b);
    free(f);
}
