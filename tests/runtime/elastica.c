/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "elastica.h"

#include <math.h>

enum { STEPS = 4000 }; /* error of Runge-Kutta below 1e-13 for alpha up to 20 */

/* psi(s), the angle of the axis at the distance s from the tip, measured from the tip: bending
 * moment psi' and psi'' = alpha cos(psi + turn), where the force makes the angle `turn` with the
 * normal at the tip; x, y: the root seen along the tip's tangent and normal. */
struct ray {
    double psi, slope, x, y;
};

static struct ray derivative(const struct ray *r, double alpha, double turn)
{
    return (struct ray){r->slope, alpha * cos(turn - r->psi), cos(r->psi), sin(r->psi)};
}

static struct ray moved(const struct ray *r, double h, const struct ray *d)
{
    return (struct ray){r->psi + h * d->psi, r->slope + h * d->slope, r->x + h * d->x,
                        r->y + h * d->y};
}

/* From the tip to the root. */
static struct ray shoot(double alpha, double turn)
{
    const double h = 1.0 / STEPS;
    struct ray r = {0};
    for (int i = 0; i < STEPS; i++) {
        const struct ray k1 = derivative(&r, alpha, turn);
        const struct ray r2 = moved(&r, h / 2, &k1), k2 = derivative(&r2, alpha, turn);
        const struct ray r3 = moved(&r, h / 2, &k2), k3 = derivative(&r3, alpha, turn);
        const struct ray r4 = moved(&r, h, &k3), k4 = derivative(&r4, alpha, turn);
        r = moved(&r, h / 6, &k1);
        r = moved(&r, h / 3, &k2);
        r = moved(&r, h / 3, &k3);
        r = moved(&r, h / 6, &k4);
    }
    return r;
}

/* The tip seen from the root, where the axis is horizontal. */
static struct elastica from_root(const struct ray *r)
{
    const double c = cos(r->psi), s = sin(r->psi);
    return (struct elastica){1 - (c * r->x + s * r->y), s * r->x - c * r->y, r->psi};
}

struct elastica elastica_follower(double alpha)
{
    const struct ray root = shoot(alpha, 0);
    return from_root(&root);
}

/* The tip's angle is the one whose root comes out horizontal: bisection. */
struct elastica elastica_dead(double alpha)
{
    double low = 0, high = M_PI / 2;
    for (int i = 0; i < 60; i++) {
        const double turn = (low + high) / 2;
        if (shoot(alpha, turn).psi > turn)
            low = turn;
        else
            high = turn;
    }
    const struct ray root = shoot(alpha, low);
    return from_root(&root);
}
