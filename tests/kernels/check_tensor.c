/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Force and tangent as products with an element's tensor, beside those from station to station. */
#include "check.h"
#include "checks.h"

#include <stdlib.h>

/* The same sums of a few thousand terms of both signs in another order, strains of order one. */
static const real rounding = 1e-12L;

/* Both batches hold the same states; b's results are the tensor's. */
static void compare(const struct fixture *fx, const struct batch *b, const struct batch *c)
{
    const size_t dofs = (size_t)fx->dofs;
    real *f = grab(2 * dofs, sizeof *f), *K = grab(2 * dofs * dofs, sizeof *K);
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        lane_vector(fx, b->f, lane, f);
        lane_vector(fx, c->f, lane, f + dofs);
        lane_matrix(fx, b->K, lane, K);
        lane_matrix(fx, c->K, lane, K + dofs * dofs);
        check("tensor: force beside that from station to station", where(fx, lane),
              force_error(fx, f, f + dofs), rounding);
        check("tensor: tangent beside that from station to station", where(fx, lane),
              matrix_error(fx, K, K + dofs * dofs), rounding);
    }
    free(f);
    free(K);
}

/* A tensor that knows of less symmetry than there is has more numbers, and the same products. */
static void check_symmetry(struct fixture *fx, int symmetry)
{
    struct batch b, c;
    struct hobe_invariants stations = fx->inv;
    stations.tensor = NULL;
    batch_open(fx, &b);
    batch_open(fx, &c);
    batch_random(fx, &b, 0.3L);
    for (int lane = 0; lane < HOBE_LANES; lane++)
        batch_copy(fx, &c, lane, &b, lane);
    fixture_set_tensor(fx, symmetry);
    run_tangent(fx, &stations, &c);
    run_tangent(fx, &fx->inv, &b);
    compare(fx, &b, &c);
    batch_close(&b);
    batch_close(&c);
}

void check_tensor(struct fixture *fx)
{
    check("tensor: the symmetry of the section", where(fx, -1),
          fx->kernel->symmetry(&fx->inv) != fx->symmetry, 0);
    for (int symmetry = 0; symmetry < HOBE_SYMMETRIES; symmetry++)
        if ((symmetry & fx->symmetry) == symmetry)
            check_symmetry(fx, symmetry);
}
