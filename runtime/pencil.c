/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pencil.h"

#include "assemble.h"
#include "constraint.h"
#include "eigen.h"
#include "inertia.h"
#include "load.h"
#include "pattern.h"
#include "reduction.h"
#include "solution.h"
#include "spring.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

enum {
    DEFAULT_MODES = 10,
    FEW_UNKNOWNS = 300,  /* dense takes as long as Lanczos, and sees the whole spectrum */
    MOST_UNKNOWNS = 6000 /* of dense matrices: 300 MB each */
};

/* ---- matrices -------------------------------------------------------------------------------- */

void pencil_tangent(struct pencil *s, double factor, double *Ax)
{
    const struct matrix K = {COLUMNS, Ax};
    const struct instant instant = solution_instant(s->state, s->model);
    assemble(s->model, s->u, s->r, &K);
    constraint_add(s->model, s->u, &instant, s->r, &K);
    spring_add(s->model, s->u, &instant, s->r, &K);
    load_subtract(s->model, s->u, &instant, factor, s->r, &K);
}

void pencil_scale(const struct pencil *s, double *Ax)
{
    const struct pattern *p = &s->model->pattern;
    for (long j = 0; j < s->n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            Ax[k] *= s->scale[p->Ai[k]] * s->scale[j];
}

/* y = A x, by rows, which are the columns of a symmetric matrix. */
static void multiply(const struct pencil *s, const double *Ax, const double *x, double *y)
{
    const struct pattern *p = &s->model->pattern;
    for (long j = 0; j < s->n; j++) {
        y[j] = 0;
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            y[j] += Ax[k] * x[p->Ai[k]];
    }
}

void pencil_multiply(void *context, const double *x, double *y)
{
    multiply(context, ((const struct pencil *)context)->Mx, x, y);
}

void pencil_multiply_stiffness(void *context, const double *x, double *y)
{
    multiply(context, ((const struct pencil *)context)->Ax, x, y);
}

void pencil_spread(const struct pencil *s, const double *Ax, double sigma, double *full)
{
    const struct pattern *p = &s->model->pattern;
    memset(full, 0, (size_t)(s->n * s->n) * sizeof *full);
    for (long j = 0; j < s->n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            full[j * s->n + p->Ai[k]] = Ax[k] - sigma * s->Mx[k];
}

/* ---- factors --------------------------------------------------------------------------------- */

enum hobe_status pencil_factor(struct pencil *s, const double *Ax, const double *scale,
                               struct hobe_error *err)
{
    long column;
    s->factored = COLUMNS;
    if (s->fronts) {
        pattern_to_fronts(s->model, Ax, s->fronts);
        if (!fronts_factor(s->model->fronts, s->fronts, scale)) {
            s->factored = FRONTS;
            return HOBE_OK;
        }
    }
    return hobe_linsolve_factor(s->model->solver, Ax, scale, &column, err);
}

enum hobe_status pencil_divide(struct pencil *s, double *x, struct hobe_error *err)
{
    if (s->factored == COLUMNS)
        return hobe_linsolve_solve(s->model->solver, x, err);
    fronts_solve(s->model->fronts, s->fronts, x);
    return HOBE_OK;
}

/* ---- modes ----------------------------------------------------------------------------------- */

enum hobe_status pencil_make_room(struct pencil *s, int modes, struct hobe_error *err)
{
    hobe_free(s->mu);
    hobe_free(s->X);
    s->room = modes;
    s->mu = hobe_alloc((size_t)modes, sizeof *s->mu, err);
    s->X = hobe_alloc((size_t)modes * (size_t)s->n, sizeof *s->X, err);
    return s->mu && s->X ? HOBE_OK : HOBE_NO_MEMORY;
}

double pencil_mu(const struct pencil *s, double nu)
{
    return s->buckling && nu <= s->least ? INFINITY : 1 / nu;
}

/* x'Mx = 1 and, among the modes, x_i'M x_j = 0 to rounding: dense vectors are orthogonal relative
 * to the lowest mode only.  The largest entry is positive, the first of nearly equal ones. */
void pencil_orthonormalize(struct pencil *s, int count)
{
    for (int i = 0; i < count; i++) {
        double *x = s->X + i * s->n, largest = 0;
        for (int pass = 0; pass < 2; pass++) {
            pencil_multiply(s, x, s->product);
            for (int j = 0; j < i; j++) {
                const double along = dot(s->n, s->product, s->X + j * s->n);
                for (long k = 0; k < s->n; k++)
                    x[k] -= along * s->X[j * s->n + k];
            }
            pencil_multiply(s, x, s->product);
            const double length = sqrt(dot(s->n, x, s->product));
            for (long k = 0; k < s->n; k++)
                x[k] /= length;
        }
        for (long k = 0; k < s->n; k++)
            if (fabs(x[k]) > (1 + 1e-6) * fabs(largest))
                largest = x[k];
        for (long k = 0; largest < 0 && k < s->n; k++)
            x[k] = -x[k];
    }
}

enum hobe_status pencil_fail_unstable(struct hobe_error *err)
{
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "the scene is unstable already in the state whose buckling is asked for; "
                     "start from a smaller load");
}

/* ---- dense ----------------------------------------------------------------------------------- */

/* Where K is indefinite, K - sigma M is not for a sigma below all omega^2, found by steps of four
 * from far below the lowest frequency; all omega^2 = sigma + 1/nu then lie above sigma. */
static enum hobe_status factor_dense(struct pencil *s, double *M, double *K, double *nu,
                                     double *sigma, struct hobe_error *err)
{
    double trace = 0;
    int definite = 0;
    pencil_spread(s, s->Mx, 0, M);
    for (long j = 0; j < s->n; j++)
        trace += M[j * s->n + j];
    double step = s->buckling ? 0 : 1e-12 * (double)s->n / trace; /* K's diagonal is 1 */
    for (*sigma = 0; isfinite(step); *sigma = -step, step *= 4) {
        pencil_spread(s, s->Mx, 0, M);
        pencil_spread(s, s->Ax, *sigma, K);
        const enum hobe_status status = eigen_dense((int)s->n, M, K, nu, &definite, err);
        if (status || definite)
            return status;
        if (s->buckling)
            return pencil_fail_unstable(err);
    }
    return hobe_fail(err, HOBE_SINGULAR, NULL, "the mass matrix is not positive definite");
}

static enum hobe_status solve_dense(struct pencil *s, int modes, int *unstable,
                                    struct hobe_error *err)
{
    const size_t size = (size_t)(s->n * s->n);
    double sigma, *M = hobe_alloc(size, sizeof *M, err);
    double *K = hobe_alloc(size, sizeof *K, err);
    double *nu = hobe_alloc((size_t)s->n, sizeof *nu, err);
    enum hobe_status status = M && K && nu ? pencil_make_room(s, modes, err) : HOBE_NO_MEMORY;
    if (!status)
        status = factor_dense(s, M, K, nu, &sigma, err);
    *unstable = 0;
    for (long i = 0; !status && i < s->n; i++) { /* nu ascending: the lowest mode is the last */
        const long from = s->n - 1 - i;
        const double mu = sigma + pencil_mu(s, nu[from]);
        *unstable += nu[from] > 0 && mu < 0; /* nu < 0 is rounding: M is definite */
        if (i < modes) {
            s->mu[i] = mu;
            memcpy(s->X + i * s->n, M + from * s->n, (size_t)s->n * sizeof *M);
        }
    }
    hobe_free(M);
    hobe_free(K);
    hobe_free(nu);
    return status;
}

enum hobe_status pencil_solve(struct pencil *s, const struct hobe_modal_options *options,
                              int *unstable, struct hobe_error *err)
{
    return options->method == HOBE_MODAL_DENSE ? solve_dense(s, options->modes, unstable, err)
                                               : pencil_lanczos(s, options->modes, unstable, err);
}

/* ---- what is asked for ----------------------------------------------------------------------- */

static enum hobe_status check_state(const struct pencil *s, const char *what,
                                    struct hobe_error *err)
{
    const hobe_model *model = s->model;
    if (s->state && !solution_is_of(s->state, model))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "the state belongs to another scene");
    const struct hobe_force *force = s->state || s->buckling ? load_follower(model) : NULL;
    if (force)
        return hobe_fail(err, HOBE_BAD_INPUT, force->where,
                         "a %s makes the stiffness unsymmetric, which %s cannot treat; make the "
                         "force on beam \"%s\" a dead one%s",
                         force->function ? "force that is a function of its place"
                                         : "follower force",
                         what, force->beam, s->buckling ? "" : ", or leave out the state");
    return HOBE_OK;
}

enum hobe_status pencil_choose(const struct pencil *s, struct hobe_modal_options *o,
                               struct hobe_error *err)
{
    const long all = s->rank;
    if (o->modes == 0)
        o->modes = all < DEFAULT_MODES ? (int)all : DEFAULT_MODES;
    if (o->modes < 1 || o->modes > all)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "modes must be from 1 to the %ld that this scene has, got %d", all,
                         o->modes);
    if (o->method == HOBE_MODAL_DENSE && s->multipliers)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "method \"dense\" does not hold for joints and rigid corners; use "
                         "\"lanczos\"");
    if (o->method == HOBE_MODAL_AUTO)
        o->method = !s->multipliers && (s->n <= FEW_UNKNOWNS || o->modes > s->n / 4)
                        ? HOBE_MODAL_DENSE
                        : HOBE_MODAL_LANCZOS;
    if (o->method == HOBE_MODAL_DENSE && s->n > MOST_UNKNOWNS)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "method \"dense\" is for at most %d unknowns, got %ld; use \"lanczos\" "
                         "for less than a quarter of the modes",
                         MOST_UNKNOWNS, s->n);
    if (o->method == HOBE_MODAL_LANCZOS && o->modes >= all)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "method \"lanczos\" finds at most %ld modes of this scene, got %d",
                         all - 1, o->modes);
    return HOBE_OK;
}

enum hobe_status pencil_open(struct pencil *s, const char *what, struct hobe_error *err)
{
    if (check_state(s, what, err))
        return HOBE_BAD_INPUT;
    if (pattern_columns(s->model, err))
        return HOBE_NO_MEMORY;
    const size_t size = (size_t)(3 * s->model->vectors), n = (size_t)(3 * s->model->unknowns);
    s->n = (long)n;
    long spare;
    s->multipliers = inertia_multipliers(s->model, &spare);
    s->rank = s->n - 2 * s->multipliers - spare;
    s->u = hobe_alloc(size, sizeof *s->u, err);
    s->r = hobe_alloc(size, sizeof *s->r, err);
    s->scale = hobe_alloc(n, sizeof *s->scale, err);
    s->ones = hobe_alloc(n, sizeof *s->ones, err);
    s->product = hobe_alloc(n, sizeof *s->product, err);
    s->Ax = hobe_alloc((size_t)values(s), sizeof *s->Ax, err);
    s->Mx = hobe_alloc((size_t)values(s), sizeof *s->Mx, err);
    s->Sx = hobe_alloc((size_t)values(s), sizeof *s->Sx, err);
    if (!s->u || !s->r || !s->scale || !s->ones || !s->product || !s->Ax || !s->Mx || !s->Sx)
        return HOBE_NO_MEMORY;
    if (s->model->fronts) {
        s->fronts = hobe_alloc(fronts_size(s->model->fronts), sizeof *s->fronts, err);
        if (!s->fronts)
            return HOBE_NO_MEMORY;
    }
    if (s->state)
        memcpy(s->u, solution_field(s->state, s->model, SOLUTION_U), size * sizeof *s->u);
    for (size_t i = 0; i < n; i++)
        s->ones[i] = 1;
    return HOBE_OK;
}

void pencil_close(struct pencil *s)
{
    hobe_free(s->u);
    hobe_free(s->r);
    hobe_free(s->scale);
    hobe_free(s->ones);
    hobe_free(s->product);
    hobe_free(s->Ax);
    hobe_free(s->Mx);
    hobe_free(s->Sx);
    hobe_free(s->fronts);
    hobe_free(s->mu);
    hobe_free(s->X);
}
