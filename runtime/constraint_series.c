/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What constraints add to the power series of a path: polynomials of series (constraint.h has the
 * names). */
#include "constraint.h"
#include "taylor.h"
#include "vector3.h"

#include <string.h>

/* c += factor a */
static void add(int k, double factor, const taylor3 a, taylor3 c)
{
    for (int i = 0; i <= k; i++)
        for (int x = 0; x < 3; x++)
            c[i][x] += factor * a[i][x];
}

/* Both places along the states u[known]. */
struct course {
    taylor3 moved[TIE_VECTORS], D[2][3], d;
};

static void read_course(const struct tie *tie, const double *const *u, int known, int k,
                        struct course *s)
{
    memset(s, 0, sizeof *s);
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++)
        for (int i = 0; i < known; i++)
            for (int x = 0; x < 3; x++)
                s->moved[t->what][i][x] += t->weight * u[i][3 * tie->vector[t->entry] + x];
    add(k, 1, s->moved[3], s->d);
    add(k, -1, s->moved[0], s->d);
    for (int side = 0; side < 2; side++) {
        taylor3 *D = s->D[side];
        for (int i = 1; i < 3; i++) {
            memcpy(D[i][0], tie->side[side].D0[i], sizeof D[i][0]);
            add(k, 1, s->moved[3 * side + i], D[i]);
        }
        taylor_cross(k, D[1], D[2], D[0]);
    }
}

/* W[side][i] = dPhi/dD_i with n taken for a direction of its own. */
static void by_directions(const struct constraint *c, const struct course *s, int k,
                          taylor3 W[2][3])
{
    memset(W, 0, sizeof(taylor3[2][3]));
    for (int i = 0; i < 3; i++) {
        add(k, c->slide[i], s->d, W[0][i]);
        for (int j = 0; j < 3; j++) {
            add(k, c->turn[i][j], s->D[1][j], W[0][i]);
            add(k, c->turn[i][j], s->D[0][i], W[1][j]);
        }
    }
}

/* The coefficient of a^k > 0 of Phi = sum_i D_ai . W_ai + (hold + bend d/2) . d. */
static double value(const struct constraint *c, const struct course *s, int k,
                    const taylor3 W[2][3])
{
    taylor phi = {0};
    for (int i = 0; i < 3; i++)
        taylor_dot(k, s->D[0][i], W[0][i], 1, phi);
    taylor_dot(k, s->d, s->d, c->bend / 2, phi);
    return phi[k] + dot3(c->hold, s->d[k]);
}

/* g = dPhi/d(r, y, z of both places). */
static void gradient(const struct constraint *c, const struct course *s, int k,
                     const taylor3 W[2][3], taylor3 g[TIE_VECTORS])
{
    memset(g, 0, sizeof(taylor3[TIE_VECTORS]));
    memcpy(g[3][0], c->hold, sizeof c->hold);
    add(k, c->bend, s->d, g[3]);
    for (int i = 0; i < 3; i++)
        add(k, c->slide[i], s->D[0][i], g[3]);
    add(k, -1, g[3], g[0]);
    for (int side = 0; side < 2; side++) {
        for (int i = 1; i < 3; i++)
            add(k, 1, W[side][i], g[3 * side + i]);
        taylor_cross(k, s->D[side][2], W[side][0], g[3 * side + 1]);
        taylor_cross(k, W[side][0], s->D[side][1], g[3 * side + 2]);
    }
}

static void add_tie(const struct tie *tie, const double *const *u, int known, int k, double *f)
{
    struct course s;
    taylor3 W[2][3], g[TIE_VECTORS], force[TIE_VECTORS] = {{{0}}};
    read_course(tie, u, known, k, &s);
    for (int c = 0; c < tie->constraints; c++) {
        const long multiplier = 3 * tie->multiplier + c;
        taylor lambda = {0};
        for (int i = 0; i < known; i++)
            lambda[i] = u[i][multiplier];
        by_directions(tie->constraint + c, &s, k, W);
        gradient(tie->constraint + c, &s, k, W, g);
        f[multiplier] += value(tie->constraint + c, &s, k, W);
        for (int i = 0; i < TIE_VECTORS; i++)
            taylor_scale(k, lambda, g[i], 1, force[i]);
    }
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++)
        for (int x = 0; x < 3; x++)
            f[3 * tie->vector[t->entry] + x] += t->weight * force[t->what][k][x];
}

void constraint_series(const struct hobe_model *model, const double *const *u, int known, int k,
                       double *f)
{
    for (size_t i = 0; i < model->ties.count; i++)
        add_tie(model_tie(model, i), u, known, k, f);
}
