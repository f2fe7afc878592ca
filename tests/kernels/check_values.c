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

static void compare(const struct fixture *fx, struct batch *b, const char *force_name,
                    const char *energy_name, real bound)
{
    number position[PW_DOFS], force[PW_DOFS];
    real q[PW_DOFS], f[PW_DOFS], exact[PW_DOFS];
    run_energy(fx, &fx->inv, b);
    run_force(fx, &fx->inv, b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_position(fx, b, lane, q);
        for (int i = 0; i < fx->dofs; i++)
            position[i] = q[i];
        pw_force(&fx->beam, position, force);
        for (int i = 0; i < fx->dofs; i++)
            exact[i] = creall(force[i]);
        lane_vector(fx, b->f, lane, f);
        check(force_name, where(fx, lane), force_error(fx, f, exact), bound);
        real U = creall(pw_energy(&fx->beam, position));
        check(energy_name, where(fx, lane), fabsl(b->U[0][lane] / U - 1), bound);
    }
}

/* Strain of 1e-7.  About the reference itself the strain is linear in u and keeps all digits: with
 * absolute positions 1e-16/1e-7 = 1e-9 would remain.  The evaluator loses 7 digits of its own, from
 * 1e-19 where long double has them.  After a large rotation u itself is rounded at 1e-16, and the
 * strain is the small difference of large terms: 1e-9, times the sum of |N'| l (10 to 30), is what
 * doubles can hold. */
void check_round_off(const struct fixture *fx)
{
    const real small = 1e-7L, own = 100 * pw_epsilon() / small;
    real R[9], X[PW_DOFS], u[PW_DOFS], q0[PW_DOFS], v[PW_DOFS], q[PW_DOFS];
    struct batch b;
    if (!fx->known)
        return;
    batch_open(fx, &b);
    batch_random(fx, &b, small);
    compare(fx, &b, "round-off: force at strain 1e-7", "round-off: energy at strain 1e-7",
            1e-12L + own);
    reference(fx, X);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        random_vectors(fx, small, u);
        for (int i = 0; i < fx->dofs; i++)
            v[i] = X[i] + u[i];
        random_rotation(R);
        turn(fx, R, X, q0);
        random_rotation(R);
        turn(fx, R, v, q);
        for (int i = 0; i < fx->dofs; i++)
            u[i] = q[i] - q0[i];
        batch_set(fx, &b, lane, q0, u);
    }
    compare(fx, &b, "round-off: force at strain 1e-7 after a large rotation",
            "round-off: energy at strain 1e-7 after a large rotation", 1e-7L + own);
    batch_close(&b);
}
