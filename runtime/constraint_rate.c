/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derivatives of constraints by time, and the power of their drives. */
#include "constraint_parts.h"
#include "reduction.h"
#include "vector3.h"

#include <string.h>

/* Directions and distance of a tie and their derivatives along u + v t. */
struct rates {
    double D[ORDERS][2][3][3], d[ORDERS][3];
};

static void read_rates(const struct tie *tie, const double *u, const double *v, struct rates *m)
{
    struct tie_state s;
    double moved[TIE_VECTORS][3];
    memset(m, 0, sizeof *m);
    tie_read_state(tie, u, &s);
    tie_motion(tie, v, moved);
    memcpy(m->D[0], s.D, sizeof s.D);
    memcpy(m->d[0], s.d, sizeof s.d);
    for (int a = 0; a < 3; a++)
        m->d[1][a] = moved[3][a] - moved[0][a];
    for (int side = 0; side < 2; side++) {
        double(*D1)[3] = m->D[1][side];
        memcpy(D1[1], moved[3 * side + 1], sizeof(double[2][3]));
        add_cross3(D1[1], s.D[side][2], D1[0]);
        add_cross3(s.D[side][1], D1[2], D1[0]);
        cross3(D1[1], D1[2], m->D[2][side][0]);
        add_cross3(D1[1], D1[2], m->D[2][side][0]);
    }
}

/* The p-th derivative, p = 1 or 2, of constraint k, a sum of products, by Leibniz's rule:
 * (f g)'' = f'' g + 2 f' g' + f g''. */
static double derivative(int p, struct constraint c[ORDERS][TIE_CONSTRAINTS], int k,
                         const struct rates *m)
{
    double sum = c[p][k].offset + dot3(c[0][k].hold, m->d[p]);
    for (int i = 0; i <= p; i++) {
        const double choose = i % p ? p : 1;
        sum += choose * c[0][k].bend / 2 * dot3(m->d[i], m->d[p - i]);
        for (int l = 0; l < 3; l++)
            sum += choose * c[0][k].slide[l] * dot3(m->D[i][0][l], m->d[p - i]);
        for (int j = 0; j <= p - i; j++) {
            const int h = p - i - j; /* of a, b and the coefficients */
            const double times = p == 1 || i == p || j == p || h == p ? 1 : 2;
            for (int l = 0; l < 3; l++)
                for (int n = 0; n < 3; n++)
                    sum += times * c[h][k].turn[l][n] * dot3(m->D[i][0][l], m->D[j][1][n]);
        }
    }
    return sum;
}

/* out = the p-th derivatives of all constraints, at their multipliers. */
static void differentiate(const struct hobe_model *model, int p, const double *u, const double *v,
                          const struct instant *instant, double *out)
{
    const hobe_model *whole = model_whole(model);
    memset(out, 0, (size_t)(3 * model->vectors) * sizeof *out);
    if (model->reduction) {
        u = reduction_state(model, u);
        v = v ? reduction_rates(model, v) : NULL;
    }
    for (size_t i = 0; i < whole->ties.count; i++) {
        const struct tie *tie = model_tie(whole, i);
        struct constraint c[ORDERS][TIE_CONSTRAINTS];
        struct rates m;
        constraint_now(whole, tie, instant, c);
        read_rates(tie, u, v, &m);
        double *rate = out + 3 * model_number(model, tie->multiplier);
        for (int k = 0; k < tie->constraints; k++)
            rate[k] = reduction_drops(model, tie->multiplier, k) ? 0 : derivative(p, c, k, &m);
    }
}

void constraint_rate(const struct hobe_model *model, const double *u, const struct instant *instant,
                     double *rate)
{
    differentiate(model, 1, u, NULL, instant, rate);
}

void constraint_acceleration(const struct hobe_model *model, const double *u, const double *v,
                             const struct instant *instant, double *out)
{
    differentiate(model, 2, u, v, instant, out);
}

enum hobe_status tie_power(const struct tie *tie, const double *u, const struct instant *instant,
                           double *power, struct hobe_error *err)
{
    struct constraint c[ORDERS][TIE_CONSTRAINTS];
    struct rates m;
    const enum hobe_status status = constraint_at(tie, instant, c, err);
    *power = 0;
    if (status)
        return status;
    read_rates(tie, u, NULL, &m);
    for (int k = 0; k < tie->constraints; k++)
        *power += u[3 * tie->multiplier + k] * derivative(1, c, k, &m);
    return HOBE_OK;
}
