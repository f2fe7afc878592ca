/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energy, force and tangent of random states against the evaluator, in every lane. */
#include "check.h"
#include "checks.h"

#include <math.h>
#include <stdlib.h>

/* Strains are of order one here, so differences lose nothing: sums of a few thousand terms of both
 * signs, relative to the norm of the whole. */
static const real tolerance = 1e-11L;

/* The tangent of a large element takes the evaluator long: then two lanes, and check_lanes, which
 * ties the other lanes to these, must do. */
static int tangent_lanes(const struct fixture *fx)
{
    return fx->kernel->vectors <= 13 ? HOBE_LANES : 2;
}

static void check_force(const struct fixture *fx, struct batch *b, int lane, const real *q)
{
    number position[PW_DOFS], force[PW_DOFS];
    real f[PW_DOFS], exact[PW_DOFS], U;
    for (int i = 0; i < fx->dofs; i++)
        position[i] = q[i];
    U = creall(pw_energy(&fx->beam, position));
    pw_force(&fx->beam, position, force);
    for (int i = 0; i < fx->dofs; i++)
        exact[i] = creall(force[i]);
    lane_vector(fx, b->f, lane, f);
    check("energy: against the evaluator", where(fx, lane), fabsl(b->U[0][lane] / U - 1),
          tolerance);
    check("force: against the evaluator", where(fx, lane), force_error(fx, f, exact), tolerance);
}

static void check_tangent(const struct fixture *fx, struct batch *b, int lane, const real *q)
{
    const size_t entries = (size_t)(fx->dofs * fx->dofs);
    real *exact = grab(2 * entries, sizeof *exact), *K = exact + entries;
    lane_matrix(fx, b->K, lane, K);
    pw_tangent(&fx->beam, q, exact);
    check("tangent: against the complex step of the evaluator's force", where(fx, lane),
          matrix_error(fx, K, exact), tolerance);
    free(exact);
}

/* Large displacements (0.3 of the length) and distortions (slopes 0.3) in random frames. */
void check_values(const struct fixture *fx)
{
    real q[PW_DOFS];
    struct batch b;
    if (!fx->known)
        return;
    batch_open(fx, &b);
    batch_random(fx, &b, 0.3L);
    run_energy(fx, &fx->inv, &b);
    run_tangent(fx, &fx->inv, &b);
    for (int lane = 0; lane < tangent_lanes(fx); lane++) {
        lane_position(fx, &b, lane, q);
        check_tangent(fx, &b, lane, q);
    }
    run_force(fx, &fx->inv, &b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_position(fx, &b, lane, q);
        check_force(fx, &b, lane, q);
    }
    batch_close(&b);
}

/* ---- round-off at small strain -------------------------------------------------------------- */

/* Lanes take the one strain and the other in turn. */
static const real strain[] = {1e-7L, 1e-10L};
enum { STRAINS = sizeof strain / sizeof *strain };

/* What is said of each strain, and how far force and energy may be off, relative to themselves. */
struct bounds {
    const char *energy, *force, *tangent;
    real bound;
};

/* About the reference itself the strain is linear in u and keeps all digits, whatever its size:
 * with absolute positions 1e-16/1e-10 = 1e-6 would remain.  After a large rotation u is of order
 * one, and the strain a small difference of its terms: 1e-16 times the sum of |N'| l, 10 to 30,
 * over the strain is what doubles can hold. */
static const struct bounds about[STRAINS] = {
    {"energy at strain 1e-7", "force at strain 1e-7", "tangent at strain 1e-7", 1e-13L},
    {"energy at strain 1e-10", "force at strain 1e-10", "tangent at strain 1e-10", 1e-13L}};
static const struct bounds turned[STRAINS] = {
    {"energy at strain 1e-7, turned", "force at strain 1e-7, turned",
     "tangent at strain 1e-7, turned", 1e-7L},
    {"energy at strain 1e-10, turned", "force at strain 1e-10, turned",
     "tangent at strain 1e-10, turned", 1e-4L}};

/* A tangent is of order one whatever the strain, and has its digits in any frame. */
static const real tangent_bound = 1e-13L;

/* The evaluator counts from the lane's reference, as the kernel does, and about it loses nothing;
 * but a rod's strains are differences of its own, and any after a large rotation. */
static real own_error(const struct fixture *fx, const struct bounds *bounds, int lane)
{
    const int differs = fx->structural || bounds == turned;
    return differs ? 100 * pw_epsilon() / strain[lane % STRAINS] : 0;
}

static void compare(const struct fixture *fx, struct batch *b, const struct bounds *bounds)
{
    struct pw_beam beam = fx->beam;
    number u[PW_DOFS], force[PW_DOFS];
    real q0[PW_DOFS], f[PW_DOFS], exact[PW_DOFS];
    beam.from = q0;
    run_energy(fx, &fx->inv, b);
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_vector(fx, b->q0, lane, q0);
        lane_vector(fx, b->u, lane, f);
        for (int i = 0; i < fx->dofs; i++)
            u[i] = f[i];
        pw_force(&beam, u, force);
        for (int i = 0; i < fx->dofs; i++)
            exact[i] = creall(force[i]);
        lane_vector(fx, b->f, lane, f);
        const struct bounds *is = bounds + lane % STRAINS;
        const real bound = is->bound + own_error(fx, bounds, lane);
        check(is->force, where(fx, lane), force_error(fx, f, exact), bound);
        const real U = creall(pw_energy(&beam, u));
        check(is->energy, where(fx, lane), fabsl(b->U[0][lane] / U - 1), bound);
    }
}

/* The tangent of the lanes of either strain. */
static void compare_tangent(const struct fixture *fx, struct batch *b, const struct bounds *bounds)
{
    const size_t entries = (size_t)(fx->dofs * fx->dofs);
    real *exact = grab(2 * entries, sizeof *exact), *K = exact + entries, q0[PW_DOFS], u[PW_DOFS];
    struct pw_beam beam = fx->beam;
    beam.from = q0;
    run_tangent(fx, &fx->inv, b);
    for (int lane = 0; lane < STRAINS; lane++) {
        lane_vector(fx, b->q0, lane, q0);
        lane_vector(fx, b->u, lane, u);
        lane_matrix(fx, b->K, lane, K);
        pw_tangent(&beam, u, exact);
        check(bounds[lane].tangent, where(fx, lane), matrix_error(fx, K, exact), tangent_bound);
    }
    free(exact);
}

/* Displacements that strain by up to strain[], about the reference; as they are, or turned. */
static void small_strains(const struct fixture *fx, struct batch *b, int rotate)
{
    real R[9], X[PW_DOFS], u[PW_DOFS], q0[PW_DOFS], x[PW_DOFS], q[PW_DOFS];
    reference(fx, X);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        random_rotation(R);
        turn(fx, R, X, q0);
        random_vectors(fx, strain[lane % STRAINS], u);
        for (int i = 0; i < fx->dofs; i++)
            x[i] = X[i] + u[i];
        random_rotation(R);
        turn(fx, R, x, q);
        for (int i = 0; rotate && i < fx->dofs; i++)
            u[i] = q[i] - q0[i];
        batch_set(fx, b, lane, q0, u);
    }
}

void check_round_off(const struct fixture *fx, int tangent)
{
    struct batch b;
    if (!fx->known)
        return;
    batch_open(fx, &b);
    for (int rotate = 0; rotate < 2; rotate++) {
        small_strains(fx, &b, rotate);
        compare(fx, &b, rotate ? turned : about);
        if (tangent)
            compare_tangent(fx, &b, rotate ? turned : about);
    }
    batch_close(&b);
}
