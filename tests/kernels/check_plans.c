/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plans for force and tangent side by side, knowing of more or less symmetry. */
#include "check.h"
#include "checks.h"

#include <stdlib.h>

/* The same sums of a few thousand terms of both signs in another order, strains of order one. */
static const real rounding = 1e-12L;

struct names {
    const char *force, *tangent;
};

/* The states of c by the plans of inv, beside the results in c. */
static void compare(const struct fixture *fx, const struct hobe_invariants *inv,
                    const struct batch *c, const struct names *names)
{
    const size_t dofs = (size_t)fx->dofs;
    real *f = grab(2 * dofs, sizeof *f), *K = grab(2 * dofs * dofs, sizeof *K);
    struct batch b;
    batch_open(fx, &b);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        batch_copy(fx, &b, lane, c, lane);
    run_tangent(fx, inv, &b);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_vector(fx, b.f, lane, f);
        lane_vector(fx, c->f, lane, f + dofs);
        lane_matrix(fx, b.K, lane, K);
        lane_matrix(fx, c->K, lane, K + dofs * dofs);
        check(names->force, where(fx, lane), force_error(fx, f, f + dofs), rounding);
        check(names->tangent, where(fx, lane), matrix_error(fx, K, K + dofs * dofs), rounding);
    }
    batch_close(&b);
    free(f);
    free(K);
}

/* A plan that knows of less symmetry than there is has more numbers, and the same products. */
void check_plans(struct fixture *fx)
{
    static const struct names section = {"section: force, knowing of symmetries or of none",
                                         "section: tangent, knowing of symmetries or of none"};
    static const struct names tensor = {"tensor: force beside that from station to station",
                                        "tensor: tangent beside that from station to station"};
    struct batch b;
    check("plans: the symmetries of the element", where(fx, -1),
          fx->kernel->symmetry(&fx->inv) != fx->symmetry, 0);
    batch_open(fx, &b);
    batch_random(fx, &b, 0.3L);
    for (int symmetry = 0; symmetry < HOBE_SYMMETRIES; symmetry++) {
        if ((symmetry & fx->symmetry) != symmetry)
            continue;
        fixture_set_plans(fx, symmetry);
        struct hobe_invariants stations = fx->inv;
        stations.tensor = NULL;
        if (symmetry == 0)
            run_tangent(fx, &stations, &b);
        compare(fx, &stations, &b, &section);
        if (symmetry & HOBE_SYMMETRIC_X)
            compare(fx, &fx->inv, &b, &tensor);
    }
    batch_close(&b);
}

void check_points(struct fixture *fx, int small)
{
    static const struct names points = {"points: force beside the kernel's",
                                        "points: tangent beside the kernel's"};
    struct batch b;
    batch_open(fx, &b);
    batch_random(fx, &b, 0.3L);
    run_tangent(fx, &fx->inv, &b);
    fixture_take_points(fx);
    compare(fx, &fx->inv, &b, &points);
    if (small)
        check_round_off(fx, 0);
    fixture_drop_points(fx);
    batch_close(&b);
}
