/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who tests the tester: the pointwise evaluator against itself and against exact solutions. */
#include "check.h"
#include "checks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The evaluator works in long double and has no cancellation to speak of. */
static real tolerance;

static void warping(real y, real z, real w[3])
{
    w[0] = y * z * (1 + 700 * y * y - 400 * z * z);
    w[1] = z * (1 + 2100 * y * y - 400 * z * z);
    w[2] = y * (1 + 700 * y * y - 1200 * z * z);
}

static struct pw_beam make_beam(const struct pw_element *element, enum pw_mechanics mechanics)
{
    return (struct pw_beam){.element = *element,
                            .length = 0.4L,
                            .width = 0.03L,
                            .height = 0.05L,
                            .y = 0.004L,
                            .z = -0.003L,
                            .E = 70e9L,
                            .nu = 0.3L,
                            .k2 = 0.85L,
                            .k3 = 0.7L,
                            .mechanics = mechanics,
                            .warping = warping,
                            .warping_degree = 3,
                            .J = 2e-7L,
                            .ys = 0.005L,
                            .zs = -0.002L};
}

/* The size of a component that strains the section by about 1. */
static real size(const struct pw_beam *beam, int i)
{
    const struct pw_vector *v = &beam->element.vector[i / 3];
    real phi[3 * PW_MODES];
    pw_modes(beam, beam->width / 2, beam->height / 2, phi);
    if (v->mode == 0)
        return v->slope ? 1 : beam->length;
    return 1 / hypotl(phi[3 * v->mode + 1], phi[3 * v->mode + 2]);
}

/* q = F X + t for the reference vectors X along the section axes. */
static void homogeneous(const struct pw_beam *beam, const real F[9], real shift, number *q)
{
    const real frame[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const struct pw_element *e = &beam->element;
    real X[PW_DOFS];
    pw_reference(beam, frame, X);
    for (int i = 0; i < 3 * e->vectors; i++) {
        const real *x = X + i / 3 * 3, *row = F + i % 3 * 3;
        int position = e->vector[i / 3].mode == 0 && !e->vector[i / 3].slope;
        q[i] = row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + (position ? shift : 0);
    }
}

/* Rotation and translation: no energy, no force. */
static void rigid(const struct pw_beam *beam)
{
    const int dofs = 3 * beam->element.vectors;
    const real EAl = beam->E * beam->width * beam->height * beam->length;
    real R[9], norm = 0;
    number q[PW_DOFS], f[PW_DOFS];
    random_rotation(R);
    homogeneous(beam, R, 3, q);
    pw_force(beam, q, f);
    for (int i = 0; i < dofs; i++)
        norm = fmaxl(norm, cabsl(f[i]) * size(beam, i));
    check("evaluator: rigid motion, force/EA", beam->element.name, norm / EAl, tolerance);
    check("evaluator: rigid motion, energy/EAl", beam->element.name,
          cabsl(pw_energy(beam, q)) / EAl, tolerance);
}

/* Under stretches 1.2, 0.9, 1.1 along the section axes U = V (lambda/2 tr(E)^2 + G E:E), whatever
 * the split of the law. */
static void stretch(const struct pw_beam *beam)
{
    const real F[9] = {1.2L, 0, 0, 0, 0.9L, 0, 0, 0, 1.1L};
    const real E[3] = {0.22L, -0.095L, 0.105L}, V = beam->width * beam->height * beam->length;
    const real trace = E[0] + E[1] + E[2], lambda = beam->E * 0.3L / (1.3L * 0.4L);
    const real squares = E[0] * E[0] + E[1] * E[1] + E[2] * E[2], G = beam->E / 2.6L;
    const real exact = V * (lambda / 2 * trace * trace + G * squares);
    number q[PW_DOFS];
    homogeneous(beam, F, 0, q);
    check("evaluator: energy of a uniform stretch", beam->element.name,
          fabsl(creall(pw_energy(beam, q)) / exact - 1), tolerance);
}

/* The same of the rod: U = E V (Gamma_1^2 + E_yy^2 + E_zz^2)/2, Gamma_1 = 0.2. */
static void rod_stretch(const struct pw_beam *beam)
{
    const real F[9] = {1.2L, 0, 0, 0, 0.9L, 0, 0, 0, 1.1L};
    const real V = beam->width * beam->height * beam->length;
    const real exact = beam->E * V * (0.2L * 0.2L + 0.095L * 0.095L + 0.105L * 0.105L) / 2;
    number q[PW_DOFS];
    homogeneous(beam, F, 0, q);
    check("evaluator: energy of a rod's uniform stretch", beam->element.name,
          fabsl(creall(pw_energy(beam, q)) / exact - 1), tolerance);
}

/* Force = dU/dq and tangent = df/dq along a random direction, tangent symmetric, and Gauss points
 * beyond the exact number change nothing. */
static void derivatives(const struct pw_beam *beam)
{
    const int dofs = 3 * beam->element.vectors;
    const real F[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, h = 0x1p-100L;
    number q[PW_DOFS], step[PW_DOFS], f[PW_DOFS], df[PW_DOFS];
    real p[PW_DOFS], d[PW_DOFS], work = 0, sum = 0, error = 0, norm = 0, skew = 0;
    real *K = grab((size_t)(dofs * dofs), sizeof *K);
    homogeneous(beam, F, 0, q);
    for (int i = 0; i < dofs; i++) {
        d[i] = random_real(-0.3L, 0.3L) * size(beam, i);
        p[i] = creall(q[i]) + random_real(-0.3L, 0.3L) * size(beam, i);
        q[i] = p[i];
        step[i] = p[i] + I * h * d[i];
    }
    pw_force(beam, q, f);
    pw_force(beam, step, df);
    pw_tangent(beam, p, K);
    for (int i = 0; i < dofs; i++) {
        real row = 0, exact = cimagl(df[i]) / h;
        for (int j = 0; j < dofs; j++) {
            row += K[i * dofs + j] * d[j];
            skew = fmaxl(skew,
                         fabsl(K[i * dofs + j] - K[j * dofs + i]) * size(beam, i) * size(beam, j));
        }
        work += creall(f[i]) * d[i];
        sum += fabsl(creall(f[i]) * d[i]);
        error = fmaxl(error, fabsl(row - exact) * size(beam, i));
        norm = fmaxl(norm, fabsl(exact) * size(beam, i));
    }
    free(K);
    const char *name = beam->element.name;
    check("evaluator: force is the gradient of the energy", name,
          fabsl(cimagl(pw_energy(beam, step)) / h - work) / sum, tolerance);
    check("evaluator: tangent is the gradient of the force", name, error / norm, tolerance);
    check("evaluator: tangent is symmetric", name, skew / norm, tolerance);
    if (beam->element.structural)
        return; /* its points are part of what it is */
    struct pw_beam finer = *beam;
    finer.extra = 1;
    check("evaluator: its Gauss rules are exact", name,
          cabsl(pw_energy(&finer, q) / pw_energy(beam, q) - 1), tolerance);
}

void check_evaluator(const struct pw_element *element)
{
    tolerance = 1e4L * pw_epsilon();
    for (int law = 0; law < PW_LAWS; law++) {
        struct pw_beam beam = make_beam(element, (enum pw_mechanics)law);
        if (!pw_goes_with(beam.mechanics, element->structural))
            continue;
        rigid(&beam);
        derivatives(&beam);
        if (law == PW_STRUCTURAL)
            rod_stretch(&beam);
        if (law == PW_FULL || law == PW_AVERAGE || law == PW_AXIS)
            stretch(&beam);
    }
}
