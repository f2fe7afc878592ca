/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The equilibrium path about a point of it as a power series (asymptotic numerical method: Damil &
 * Potier-Ferry 1990, Int. J. Eng. Sci. 28; Cochelin 1994, Comput. Struct. 53):
 *
 *     u(a) = sum_k a^k u_k,    lambda(a) = sum_k a^k lambda_k,    F(u(a)) = lambda(a) Q(u(a)).
 *
 * Force is cubic in u, and so what u_k adds to the coefficient of a^k is K(u_0) u_k alone: order
 * after order K(u_0) u_k = lambda_k Q_0 + what lower orders make, with the one factorisation of K.
 * One more equation says what a is, the distance from the point along its tangent in the norm of
 * the path: c . u_1 + kappa lambda_1 = 1, c . u_k + kappa lambda_k = 0 for k > 1. */
#ifndef HOBE_SERIES_H
#define HOBE_SERIES_H

#include "assemble.h"
#include "solver.h"

enum { SERIES_ORDER = 20 }; /* at most TAYLOR_ORDER */

struct series {
    struct solver *s;
    double **u, **Q; /* [order + 1][vectors][3] displacements, multipliers; the loads' forces */
    double *lambda;  /* [order + 1] */
    struct series_table table;
    double *f, *more; /* [vectors][3] */
    double *q;        /* [unknowns] K^-1 Q_0 */
};

/* Memory for series of a solver's model, whose tangent has been factored where they are expanded.
 * What is open is closed, too, after an error. */
enum hobe_status series_open(struct series *series, struct solver *s, struct hobe_error *err);
void series_close(struct series *series);

/* The coefficients about the state s->u with the load factor lambda, an equilibrium, by the last
 * factors, those of the true tangent there; c[unknowns] and kappa as above. */
enum hobe_status series_expand(struct series *series, double lambda, const double *c, double kappa,
                               struct hobe_error *err);

/* How far the series is good: where its last term is a share of its first, in the norm of the
 * solver. */
double series_range(const struct series *series, double share);

/* s->u at a, and the load factor there. */
double series_move(const struct series *series, double a);

/* v[unknowns] = du/da at a, and dlambda/da. */
double series_slope(const struct series *series, double a, double *v);

#endif
