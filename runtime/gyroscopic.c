/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vibration in a turning frame: (lambda^2 M + lambda G + K) x = 0 with G = 2 M [w]x, the Coriolis
 * force, which is skew.
 *
 * The problem is projected on a basis V that makes M the unit matrix and K = diag(mu): the lowest
 * modes of K and M, and corrections.  Of a complex mode x the projection gives,
 *
 *     e = x + K^-1 (lambda^2 M + lambda G) x,
 *
 * which vanishes for a mode of the whole scene, is both the measure of what is missing and the
 * direction in which the basis grows: by inverse iteration all that vibrates fast, such as an axis
 * that stretches under Coriolis' force, comes in by its static response. */
#include "gyroscopic.h"

#include "eigen.h"
#include "mass.h"
#include "reduction.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDS = 12 };

/* The worst of the relative |e|: frequencies, of the second order in it, are then exact to
 * rounding. */
static const double RESIDUAL = 1e-7;

/* A real part below this share of |lambda| is rounding: eigenvalues about to meet move with its
 * square root. */
static const double GROWTH = 1e-7;

struct gyroscopic {
    struct pencil *s;
    const double *w;
    int wanted, definite;  /* definite: K is, and no mode can grow */
    int modes, count;      /* the first of the basis are modes of K and M, then corrections */
    double *mu, *V, *GV;   /* [count], [count][n], [count][n] = G V */
    double *field, *force; /* [vectors][3] scratch */
    double *lambda;        /* [wanted][2] */
    double *c;             /* [wanted][2][count] x = V c, real and imaginary parts */
    int growing;           /* modes of the projection that do */
    double *x, *e;         /* [2][n], [2 wanted][n] */
    double residual;
};

struct hobe_modal_options gyroscopic_basis(const struct pencil *s,
                                           const struct hobe_modal_options *o)
{
    const long most = o->method == HOBE_MODAL_DENSE ? s->rank : s->rank - 1;
    const long modes = 2L * o->modes + 10;
    return (struct hobe_modal_options){(int)(modes < most ? modes : most), o->method};
}

/* ---- basis ----------------------------------------------------------------------------------- */

/* y[n] = G x, scaled as the pencil is. */
static void multiply_gyroscopic(struct gyroscopic *g, const double *x, double *y)
{
    const hobe_model *model = g->s->model;
    const double *w = g->w;
    const double A[3][3] = {
        {0, -2 * w[2], 2 * w[1]}, {2 * w[2], 0, -2 * w[0]}, {-2 * w[1], 2 * w[0], 0}};
    modes_spread(g->s, x, g->field);
    memset(g->force, 0, (size_t)(3 * model->vectors) * sizeof *g->force);
    mass_force_through(model, A, g->field, g->force);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const long k = 3 * model->unknown[v] + a;
            y[k] = g->s->scale[k] * g->force[3 * v + a];
        }
}

static enum hobe_status make_room(struct gyroscopic *g, int count, struct hobe_error *err)
{
    const size_t n = (size_t)g->s->n, was = (size_t)g->count, is = (size_t)count;
    double *mu = hobe_grow(g->mu, was, is, sizeof *mu, err);
    g->mu = mu ? mu : g->mu;
    double *V = mu ? hobe_grow(g->V, was * n, is * n, sizeof *V, err) : NULL;
    g->V = V ? V : g->V;
    double *GV = V ? hobe_grow(g->GV, was * n, is * n, sizeof *GV, err) : NULL;
    g->GV = GV ? GV : g->GV;
    return GV ? HOBE_OK : HOBE_NO_MEMORY;
}

static enum hobe_status open_basis(struct gyroscopic *g, struct hobe_error *err)
{
    struct pencil *s = g->s;
    const size_t size = (size_t)(3 * s->model->vectors), n = (size_t)s->n;
    const size_t wanted = (size_t)g->wanted;
    g->field = hobe_alloc(size, sizeof *g->field, err);
    g->force = hobe_alloc(size, sizeof *g->force, err);
    g->lambda = hobe_alloc(2 * wanted, sizeof *g->lambda, err);
    g->x = hobe_alloc(2 * n, sizeof *g->x, err);
    g->e = hobe_alloc(2 * wanted * n, sizeof *g->e, err);
    if (!g->field || !g->force || !g->lambda || !g->x || !g->e || make_room(g, s->room, err))
        return HOBE_NO_MEMORY;
    pencil_orthonormalize(s, s->room);
    g->modes = g->count = s->room;
    memcpy(g->mu, s->mu, (size_t)g->count * sizeof *g->mu);
    memcpy(g->V, s->X, (size_t)g->count * n * sizeof *g->V);
    for (int k = 0; k < g->count; k++)
        multiply_gyroscopic(g, g->V + k * s->n, g->GV + k * s->n);
    return pencil_factor(s, s->Ax, s->ones, err);
}

static void close_basis(struct gyroscopic *g)
{
    hobe_free(g->mu);
    hobe_free(g->V);
    hobe_free(g->GV);
    hobe_free(g->field);
    hobe_free(g->force);
    hobe_free(g->lambda);
    hobe_free(g->c);
    hobe_free(g->x);
    hobe_free(g->e);
}

/* ---- the projected problem ------------------------------------------------------------------- */

/* The columns A[2 count][2 count] of the inverse problem, whose largest eigenvalues 1/lambda are
 * those of the lowest modes and take the least from rounding.  With y = |mu|^1/2 c and v = lambda
 * c,
 *
 *     [ 0                |mu|^1/2 ]             [ -S p G p   -S p ]
 *     [ -S |mu|^1/2      -G       ]^-1    =     [  p          0   ],   p = |mu|^-1/2, S = sign mu,
 *
 * is skew where K is definite. */
static void fill(const struct gyroscopic *g, double *A)
{
    const long N = g->count, n = g->s->n;
    memset(A, 0, (size_t)(4 * N * N) * sizeof *A);
    for (long j = 0; j < N; j++) {
        const double p = 1 / sqrt(fabs(g->mu[j]));
        for (long i = 0; i < N; i++) {
            const double upper = dot(n, g->V + i * n, g->GV + j * n);
            const double lower = dot(n, g->V + j * n, g->GV + i * n);
            A[j * 2 * N + i] = -copysign(p / sqrt(fabs(g->mu[i])), g->mu[i]) * (upper - lower) / 2;
        }
        A[j * 2 * N + N + j] = p;
        A[(N + j) * 2 * N + j] = -copysign(p, g->mu[j]);
    }
}

static int comes_before(const double a[2], const double b[2])
{
    const double difference = (a[1] + a[0]) * (a[1] - a[0]) - (b[1] + b[0]) * (b[1] - b[0]);
    return difference < 0 || (difference == 0 && a[0] > b[0]);
}

/* lambda = 1/nu. */
static void invert(const struct gyroscopic *g, double re, double im, double lambda[2])
{
    const double size = hypot(re, im);
    const int grows = !g->definite && fabs(re) > GROWTH * size;
    lambda[0] = grows ? re / size / size : 0;
    lambda[1] = grows ? im / size / size : 1 / size;
}

/* Of every mode the eigenvalue with Im lambda > 0, or the growing one of a real pair, -1/nu its
 * twin: the lowest ones into lambda, and where they are found into `from`. */
static void choose(struct gyroscopic *g, const double *re, const double *im, int *from)
{
    int found = 0;
    g->growing = 0;
    for (int j = 0; j < 2 * g->count; j++) {
        double lambda[2];
        if (im[j] < 0 || (im[j] == 0 && re[j] <= 0))
            continue;
        invert(g, re[j], im[j], lambda);
        g->growing += lambda[0] > 0;
        int to = found < g->wanted ? found++ : g->wanted;
        for (; to > 0 && comes_before(lambda, g->lambda + 2 * (to - 1)); to--)
            if (to < g->wanted) {
                memcpy(g->lambda + 2 * to, g->lambda + 2 * (to - 1), sizeof lambda);
                from[to] = from[to - 1];
            }
        if (to < g->wanted) {
            memcpy(g->lambda + 2 * to, lambda, sizeof lambda);
            from[to] = j;
        }
    }
}

/* c of the chosen modes from the vectors of nu, which are those of lambda's conjugate. */
static enum hobe_status take_vectors(struct gyroscopic *g, const double *im, const double *Z,
                                     const int *from, struct hobe_error *err)
{
    const long N = g->count;
    hobe_free(g->c);
    g->c = hobe_alloc((size_t)(2 * g->wanted * N), sizeof *g->c, err);
    if (!g->c)
        return HOBE_NO_MEMORY;
    for (int i = 0; i < g->wanted; i++)
        for (long k = 0; k < N; k++) {
            const double *z = Z + from[i] * 2 * N, p = 1 / sqrt(fabs(g->mu[k]));
            g->c[2 * i * N + k] = p * z[k];
            g->c[(2 * i + 1) * N + k] = im[from[i]] > 0 ? -p * z[2 * N + k] : 0;
        }
    return HOBE_OK;
}

static enum hobe_status solve_projected(struct gyroscopic *g, struct hobe_error *err)
{
    const size_t size = 2 * (size_t)g->count;
    double *A = hobe_alloc(size * size, sizeof *A, err);
    double *Z = hobe_alloc(size * size, sizeof *Z, err);
    double *re = hobe_alloc(size, sizeof *re, err);
    double *im = hobe_alloc(size, sizeof *im, err);
    int *from = hobe_alloc((size_t)g->wanted, sizeof *from, err);
    enum hobe_status status = A && Z && re && im && from ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status) {
        fill(g, A);
        status = eigen_general((int)size, A, re, im, Z, err);
    }
    if (!status) {
        choose(g, re, im, from);
        status = take_vectors(g, im, Z, from, err);
    }
    hobe_free(A);
    hobe_free(Z);
    hobe_free(re);
    hobe_free(im);
    hobe_free(from);
    return status;
}

/* x = sum of B_k c_k. */
static void combine(const struct gyroscopic *g, const double *B, const double *c, double *x)
{
    const long n = g->s->n;
    memset(x, 0, (size_t)n * sizeof *x);
    for (long k = 0; k < g->count; k++)
        for (long i = 0; i < n; i++)
            x[i] += c[k] * B[k * n + i];
}

/* x'Mx; the pencil's `product` holds M x then. */
static double mass_norm2(struct gyroscopic *g, const double *x)
{
    pencil_multiply(g->s, x, g->s->product);
    return dot(g->s->n, x, g->s->product);
}

/* ---- corrections ----------------------------------------------------------------------------- */

/* e of mode i, real and imaginary part, made |x| = 1; *size is |e|. */
static enum hobe_status correct(struct gyroscopic *g, int i, double *size, struct hobe_error *err)
{
    const long n = g->s->n, N = g->count;
    const double *l = g->lambda + 2 * i, square[2] = {l[0] * l[0] - l[1] * l[1], 2 * l[0] * l[1]};
    double *e = g->e + 2 * i * n, norm2 = 0, e2 = 0;
    memset(e, 0, 2 * (size_t)n * sizeof *e);
    for (int part = 0; part < 2; part++) { /* times 1 and i: i^part (p + i q) */
        const double *c = g->c + (2 * i + part) * N, sign = part ? -1 : 1;
        double *real = e + part * n, *imaginary = e + (1 - part) * n, *x = g->x + part * n;
        combine(g, g->GV, c, x); /* G x for now */
        for (long k = 0; k < n; k++) {
            real[k] += l[0] * x[k];
            imaginary[k] += sign * l[1] * x[k];
        }
        combine(g, g->V, c, x);
        norm2 += mass_norm2(g, x);
        for (long k = 0; k < n; k++) {
            real[k] += square[0] * g->s->product[k];
            imaginary[k] += sign * square[1] * g->s->product[k];
        }
    }
    for (int part = 0; part < 2; part++) {
        const enum hobe_status status = pencil_divide(g->s, e + part * n, err);
        if (status)
            return status;
        for (long k = 0; k < n; k++)
            e[part * n + k] = (e[part * n + k] + g->x[part * n + k]) / sqrt(norm2);
        e2 += mass_norm2(g, e + part * n);
    }
    *size = sqrt(e2);
    return HOBE_OK;
}

/* Adds a vector, made orthonormal in M; not one that is there already. */
static void append(struct gyroscopic *g, const double *e)
{
    const long n = g->s->n;
    double *to = g->V + g->count * n;
    memcpy(to, e, (size_t)n * sizeof *e);
    for (int pass = 0; pass < 2; pass++) {
        mass_norm2(g, to); /* M to */
        for (long k = 0; k < g->count; k++) {
            const double along = dot(n, g->s->product, g->V + k * n);
            for (long i = 0; i < n; i++)
                to[i] -= along * g->V[k * n + i];
        }
    }
    const double length = sqrt(mass_norm2(g, to));
    if (!(length > RESIDUAL / 2))
        return;
    for (long i = 0; i < n; i++)
        to[i] /= length;
    g->count++;
}

/* The corrections E turned among themselves so that E'KE is diagonal, too.  They are orthogonal to
 * the modes, in M and so in K. */
static enum hobe_status diagonalize(struct gyroscopic *g, struct hobe_error *err)
{
    const long n = g->s->n, m = g->count - g->modes;
    const size_t square = (size_t)(m * m), all = (size_t)(m * n);
    double *E = g->V + g->modes * n, *turned = hobe_alloc(all, sizeof *turned, err);
    double *unit = hobe_alloc(square, sizeof *unit, err);
    double *K = hobe_alloc(square, sizeof *K, err);
    double *nu = hobe_alloc((size_t)m, sizeof *nu, err);
    int definite = 0;
    enum hobe_status status = turned && unit && K && nu ? HOBE_OK : HOBE_NO_MEMORY;
    for (long i = 0; !status && i < m; i++) {
        pencil_multiply_stiffness(g->s, E + i * n, g->s->product);
        unit[i * m + i] = 1;
        for (long j = 0; j < m; j++)
            K[i * m + j] = dot(n, g->s->product, E + j * n);
    }
    if (!status)
        status = eigen_dense((int)m, unit, K, nu, &definite, err);
    if (!status && !definite)
        status = hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                           "modes of the turning frame: a mode with negative stiffness was "
                           "overlooked; ask for another number of modes, or use method = "
                           "\"dense\"");
    for (long i = 0; !status && i < m; i++) {
        for (long j = 0; j < m; j++)
            for (long k = 0; k < n; k++)
                turned[i * n + k] += unit[i * m + j] * E[j * n + k] / sqrt(nu[i]);
        g->mu[g->modes + i] = 1 / nu[i];
    }
    if (!status)
        memcpy(E, turned, all * sizeof *E);
    for (int k = g->modes; !status && k < g->count; k++)
        multiply_gyroscopic(g, g->V + k * n, g->GV + k * n);
    hobe_free(turned);
    hobe_free(unit);
    hobe_free(K);
    hobe_free(nu);
    return status;
}

/* Corrects every mode; where some need it, the basis grows by their corrections. */
static enum hobe_status improve(struct gyroscopic *g, struct hobe_error *err)
{
    const long n = g->s->n;
    enum hobe_status status = make_room(g, g->count + 2 * g->wanted, err);
    const int before = g->count;
    g->residual = 0;
    for (int i = 0; !status && i < g->wanted; i++) {
        double size = 0;
        status = correct(g, i, &size, err);
        g->residual = fmax(g->residual, size);
        if (size <= RESIDUAL) /* nothing to add */
            memset(g->e + 2 * i * n, 0, 2 * (size_t)n * sizeof *g->e);
    }
    if (status || g->residual <= RESIDUAL)
        return status;
    for (int i = 0; i < 2 * g->wanted && g->count < g->s->rank; i++)
        append(g, g->e + i * n);
    return g->count > before ? diagonalize(g, err) : HOBE_OK;
}

/* Until the modes stay, or the basis holds all that there is. */
static enum hobe_status converge(struct gyroscopic *g, struct hobe_error *err)
{
    for (int round = 0; round < ROUNDS; round++) {
        const int before = g->count;
        enum hobe_status status = solve_projected(g, err);
        if (!status && g->count < g->s->rank)
            status = improve(g, err);
        if (status || g->count == before)
            return status;
    }
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                     "the modes of the turning frame still change by %.2g of their size; ask for "
                     "more modes, or use method = \"dense\"",
                     g->residual);
}

/* ---- what is found --------------------------------------------------------------------------- */

/* x^H M x = 1, and the largest component of the nodal vectors is real and positive, the first of
 * nearly equal ones. */
static void write_shape(struct gyroscopic *g, int i, double *real, double *imaginary)
{
    const hobe_model *model = model_whole(g->s->model);
    double norm2 = 0, largest[2] = {1, 0}, most = 0;
    for (int part = 0; part < 2; part++) {
        combine(g, g->V, g->c + (2 * i + part) * g->count, g->x);
        norm2 += mass_norm2(g, g->x);
        modes_expand(g->s, g->x, part ? imaginary : real);
    }
    for (long k = 0; k < 3 * model->beam_vectors; k++)
        if (hypot(real[k], imaginary[k]) > (1 + 1e-6) * most) {
            most = hypot(real[k], imaginary[k]);
            largest[0] = real[k] / most;
            largest[1] = imaginary[k] / most;
        }
    for (long k = 0; k < 3 * model->vectors; k++) {
        const double a = real[k], b = imaginary[k];
        real[k] = (a * largest[0] + b * largest[1]) / sqrt(norm2);
        imaginary[k] = (b * largest[0] - a * largest[1]) / sqrt(norm2);
    }
}

static void write_note(hobe_modes *modes, int negative)
{
    const struct hobe_modes_info *info = &modes->info;
    int worst = 0;
    for (int i = 0; i < info->count; i++)
        if (modes->exponent[2 * i] > modes->exponent[2 * worst])
            worst = i;
    if (info->unstable > 0)
        snprintf(modes->note, sizeof modes->note,
                 "the equilibrium is unstable: %d mode%s %s in the turning frame, the fastest of "
                 "those found with the exponent %.6g %+.6gi 1/s",
                 info->unstable, info->unstable == 1 ? "" : "s",
                 info->unstable == 1 ? "grows" : "grow", modes->exponent[2 * worst],
                 modes->exponent[2 * worst + 1]);
    else if (negative > 0)
        snprintf(modes->note, sizeof modes->note,
                 "the equilibrium is kept stable by gyroscopic forces alone: its stiffness has %d "
                 "negative eigenvalue%s, and internal damping would make it unstable",
                 negative, negative == 1 ? "" : "s");
    else if (negative < 0)
        snprintf(modes->note, sizeof modes->note,
                 "unstable modes were looked for only among the %d found", info->count);
}

static hobe_modes *take(struct gyroscopic *g, const struct hobe_modal_options *o, int negative,
                        struct hobe_error *err)
{
    const size_t size = (size_t)(3 * model_whole(g->s->model)->vectors), count = (size_t)g->wanted;
    hobe_modes *modes = modes_new(g->s, g->wanted, o->method, err);
    if (!modes)
        return NULL;
    modes->quadrature = hobe_alloc(count * size, sizeof *modes->quadrature, err);
    modes->exponent = hobe_alloc(2 * count, sizeof *modes->exponent, err);
    if (!modes->quadrature || !modes->exponent) {
        hobe_modes_free(modes);
        return NULL;
    }
    memcpy(modes->exponent, g->lambda, 2 * count * sizeof *g->lambda);
    memcpy(modes->w, g->w, sizeof modes->w);
    for (int i = 0; i < g->wanted; i++) {
        const double *l = g->lambda + 2 * i;
        modes->mu[i] = (l[1] + l[0]) * (l[1] - l[0]);
        write_shape(g, i, modes->shape + (size_t)i * size, modes->quadrature + (size_t)i * size);
    }
    modes->info.residual = g->residual;
    modes->info.unstable = negative < 0 && !g->growing ? -1 : g->growing;
    write_note(modes, negative);
    return modes;
}

enum hobe_status gyroscopic_modes(struct pencil *s, const struct hobe_modal_options *o,
                                  const double w[3], int negative, hobe_modes **modes,
                                  struct hobe_error *err)
{
    struct gyroscopic g = {.s = s, .w = w, .wanted = o->modes, .definite = negative == 0};
    enum hobe_status status = open_basis(&g, err);
    if (!status)
        status = converge(&g, err);
    if (!status) {
        *modes = take(&g, o, negative, err);
        status = *modes ? HOBE_OK : HOBE_NO_MEMORY;
    }
    close_basis(&g);
    return status;
}
