/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "constraint.h"

#include "constraint_parts.h"
#include "reduction.h"
#include "vector3.h"

#include <string.h>

/* M = factor [a]x, the matrix of the cross product with a. */
static void spin(double factor, const double a[3], double M[3][3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        M[i][i] = 0;
        M[j][k] = -factor * a[i];
        M[k][j] = factor * a[i];
    }
}

void tie_read_state(const struct tie *tie, const double *u, struct tie_state *s)
{
    double moved[TIE_VECTORS][3];
    *s = (struct tie_state){0};
    tie_motion(tie, u, moved);
    for (int k = 0; u && k < tie->constraints; k++)
        s->lambda[k] = u[3 * tie->multiplier + k];
    for (int a = 0; a < 3; a++)
        s->d[a] = moved[3][a] - moved[0][a];
    for (int side = 0; side < 2; side++) {
        const double(*D0)[3] = tie->side[side].D0;
        double(*D)[3] = s->D[side], (*dD)[3] = s->dD[side];
        memcpy(dD[1], moved[3 * side + 1], sizeof(double[2][3]));
        for (int i = 1; i < 3; i++)
            for (int a = 0; a < 3; a++)
                D[i][a] = D0[i][a] + dD[i][a];
        add_cross3(dD[1], D0[2], dD[0]);
        add_cross3(D[1], dD[2], dD[0]);
        for (int a = 0; a < 3; a++)
            D[0][a] = D0[0][a] + dD[0][a];
    }
}

double constraint_value(const struct constraint *c, const struct tie *tie,
                        const struct tie_state *s)
{
    double phi = c->offset + dot3(c->hold, s->d) + c->bend / 2 * dot3(s->d, s->d);
    for (int i = 0; i < 3; i++) {
        phi += c->slide[i] * dot3(s->D[0][i], s->d);
        for (int j = 0; j < 3; j++)
            phi += c->turn[i][j] *
                   (dot3(s->dD[0][i], s->D[1][j]) + dot3(tie->side[0].D0[i], s->dD[1][j]));
    }
    return phi;
}

/* W[side][i] = dPhi/dD_i with n taken for a direction of its own. */
static void by_directions(const struct constraint *c, const struct tie_state *s, double W[2][3][3])
{
    memset(W, 0, sizeof(double[2][3][3]));
    for (int i = 0; i < 3; i++) {
        add3(c->slide[i], s->d, W[0][i]);
        for (int j = 0; j < 3; j++) {
            add3(c->turn[i][j], s->D[1][j], W[0][i]);
            add3(c->turn[i][j], s->D[0][i], W[1][j]);
        }
    }
}

/* From n = y x z, w . dn = dy . (z x w) + dz . (w x y). */
void constraint_gradient(const struct constraint *c, const struct tie_state *s,
                         double g[TIE_VECTORS][3])
{
    double W[2][3][3];
    by_directions(c, s, W);
    memcpy(g[3], c->hold, sizeof c->hold);
    add3(c->bend, s->d, g[3]);
    for (int i = 0; i < 3; i++)
        add3(c->slide[i], s->D[0][i], g[3]);
    for (int a = 0; a < 3; a++)
        g[0][a] = -g[3][a];
    for (int side = 0; side < 2; side++) {
        memcpy(g[3 * side + 1], W[side][1], sizeof(double[2][3]));
        add_cross3(s->D[side][2], W[side][0], g[3 * side + 1]);
        add_cross3(W[side][0], s->D[side][1], g[3 * side + 2]);
    }
}

/* sum_k lambda_k of the constraints c. */
static struct constraint combine(const struct tie *tie, const struct constraint *c,
                                 const double *lambda)
{
    struct constraint sum = {.offset = 0};
    for (int k = 0; k < tie->constraints; k++, c++) {
        add3(lambda[k], c->slide, sum.slide);
        add3(lambda[k], c->hold, sum.hold);
        sum.bend += lambda[k] * c->bend;
        for (int i = 0; i < 3; i++)
            add3(lambda[k], c->turn[i], sum.turn[i]);
    }
    return sum;
}

void tie_jacobian(const struct tie *tie, double J[TIE_CONSTRAINTS][TIE_VECTORS][3])
{
    struct tie_state s;
    tie_read_state(tie, NULL, &s);
    for (int k = 0; k < tie->constraints; k++)
        constraint_gradient(tie->constraint + k, &s, J[k]);
}

enum hobe_status tie_reaction(const struct tie *tie, const double *u, const struct instant *instant,
                              double force[3], double moment[3], struct hobe_error *err)
{
    struct tie_state s;
    struct constraint c[ORDERS][TIE_CONSTRAINTS];
    double g[TIE_VECTORS][3];
    const enum hobe_status status = constraint_at(tie, instant, c, err);
    if (status)
        return status;
    tie_read_state(tie, u, &s);
    const struct constraint sum = combine(tie, c[0], s.lambda);
    constraint_gradient(&sum, &s, g);
    for (int a = 0; a < 3; a++) {
        force[a] = -g[3][a];
        moment[a] = 0;
    }
    for (int i = 1; i < 3; i++)
        add_cross3(g[3 + i], s.D[1][i], moment);
    return HOBE_OK;
}

/* H += factor A' B */
static void add_product(double factor, const double A[3][3], const double B[3][3], double H[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                H[i][j] += factor * A[k][i] * B[k][j];
}

/* The second derivatives of Phi by r, y, z: products of the directions' first derivatives
 * L = dD_i/d(y, z), and where n is bent itself, w . d2n = 2 dy . (dz x w). */
static void hessian(const struct constraint *c, const struct tie_state *s,
                    double H[TIE_VECTORS][TIE_VECTORS][3][3])
{
    static const double one[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double W[2][3][3], L[2][3][2][3][3] = {0};
    by_directions(c, s, W);
    memset(H, 0, sizeof(double[TIE_VECTORS][TIE_VECTORS][3][3]));
    for (int side = 0; side < 2; side++) {
        spin(-1, s->D[side][2], L[side][0][0]);
        spin(1, s->D[side][1], L[side][0][1]);
        memcpy(L[side][1][0], one, sizeof one);
        memcpy(L[side][2][1], one, sizeof one);
        spin(-1, W[side][0], H[3 * side + 1][3 * side + 2]);
    }
    add_product(c->bend, one, one, H[0][0]);
    add_product(-c->bend, one, one, H[0][3]);
    add_product(c->bend, one, one, H[3][3]);
    for (int i = 0; i < 3; i++)
        for (int p = 0; p < 2; p++) {
            const double(*La)[3] = (const double(*)[3])L[0][i][p];
            add_product(-c->slide[i], one, La, H[0][1 + p]);
            add_product(c->slide[i], La, one, H[1 + p][3]);
            for (int j = 0; j < 3; j++)
                for (int q = 0; q < 2; q++)
                    add_product(c->turn[i][j], La, (const double(*)[3])L[1][j][q], H[1 + p][4 + q]);
        }
    for (int i = 0; i < TIE_VECTORS; i++)
        for (int j = 0; j < i; j++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    H[i][j][a][b] = H[j][i][b][a];
}

double tie_measure(const struct tie *tie, const struct constraint *c, const double *u,
                   double G[TIE_VECTORS][3], double (*H)[TIE_VECTORS][3][3])
{
    struct tie_state s;
    tie_read_state(tie, u, &s);
    constraint_gradient(c, &s, G);
    if (H)
        hessian(c, &s, H);
    return constraint_value(c, tie, &s);
}

/* ---- assembly -------------------------------------------------------------------------------- */
/* The curvature of the constraints c, times their multipliers. */
static void add_curvature(const struct hobe_model *model, const struct tie *tie,
                          const struct constraint *c, const struct tie_state *s,
                          const struct matrix *K)
{
    double H[TIE_VECTORS][TIE_VECTORS][3][3];
    const struct constraint sum = combine(tie, c, s->lambda);
    hessian(&sum, s, H);
    tie_add_tangent(model, tie, H, K);
}

/* And the constraints' derivatives J beside their multipliers, with 1 on spare ones. */
static void add_border(const struct hobe_model *model, const struct tie *tie,
                       double J[TIE_CONSTRAINTS][TIE_VECTORS][3], const struct matrix *K)
{
    for (int k = 0; k < 3 * tie->blocks; k++) {
        const int row = tie_entry(tie, k), m = k % 3;
        if (k >= tie->constraints)
            tie_add_at(model, tie, row, m, row, m, 1, K);
        for (int t = 0; t < tie->terms && k < tie->constraints; t++)
            for (int a = 0; a < 3; a++) {
                const struct tie_term *term = tie->term + t;
                const double amount = term->weight * J[k][term->what][a];
                tie_add_at(model, tie, term->entry, a, row, m, amount, K);
                tie_add_at(model, tie, row, m, term->entry, a, amount, K);
            }
    }
}

static void add_tie(const struct hobe_model *model, const struct tie *tie, const double *u,
                    const struct instant *instant, double *f, const struct matrix *K)
{
    struct tie_state s;
    struct constraint c[ORDERS][TIE_CONSTRAINTS];
    double J[TIE_CONSTRAINTS][TIE_VECTORS][3];
    constraint_now(model, tie, instant, c);
    tie_read_state(tie, u, &s);
    for (int k = 0; k < 3 * tie->blocks; k++) {
        const long multiplier = 3 * tie->multiplier + k;
        if (k >= tie->constraints) {
            f[multiplier] += u[multiplier];
            continue;
        }
        constraint_gradient(c[0] + k, &s, J[k]);
        f[multiplier] += constraint_value(c[0] + k, tie, &s);
        tie_add_force(tie, s.lambda[k], (const double(*)[3])J[k], f);
    }
    if (K) {
        add_curvature(model, tie, c[0], &s, K);
        add_border(model, tie, J, K);
    }
}

static void add_ties(const struct hobe_model *model, const double *u, const struct instant *instant,
                     double factor, double *f, const struct matrix *K)
{
    (void)factor;
    for (size_t i = 0; i < model->ties.count; i++)
        add_tie(model, model_tie(model, i), u, instant, f, K);
}

void constraint_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                    double *f, const struct matrix *K)
{
    if (model_whole(model)->ties.count > 0)
        reduction_act(model, add_ties, u, instant, 1, f, K);
    if (model->reduction)
        reduction_spare(model, u, f, K);
}

void constraint_inside(const struct hobe_model *model, const double *u,
                       const struct instant *instant, const struct beam *beam, int e, double *f)
{
    for (size_t i = 0; i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        struct tie_state s;
        struct constraint c[ORDERS][TIE_CONSTRAINTS];
        if (!place_inside(tie->side[0].place, beam, e) &&
            !place_inside(tie->side[1].place, beam, e))
            continue;
        constraint_now(model, tie, instant, c);
        tie_read_state(tie, u, &s);
        for (int k = 0; k < tie->constraints; k++) {
            double J[TIE_VECTORS][3];
            constraint_gradient(c[0] + k, &s, J);
            for (int side = 0; side < 2; side++)
                if (place_inside(tie->side[side].place, beam, e))
                    tie_add_side(tie, side, -s.lambda[k], (const double(*)[3])J, f);
        }
    }
}
