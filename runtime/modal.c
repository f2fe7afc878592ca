/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies and mode shapes about an equilibrium: K phi = omega^2 M phi.
 *
 * Both matrices are scaled by D = diag(K)^(-1/2), without which K's condition reaches 1e25 (rich
 * section modes).  Solved is the inverse problem M x = nu K x, nu = 1/omega^2: the spectrum of a
 * beam spans ten decades and more, and rounding is relative to the largest eigenvalue, which must
 * therefore be that of the lowest mode.
 *
 * Rigid corners border K with multipliers, which have no mass: Lanczos' method in the inner product
 * of M keeps to the finite part of that pencil. */
#include "modal.h"
#include "assemble.h"
#include "constraint.h"
#include "eigen.h"
#include "load.h"
#include "pattern.h"
#include "solution.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    DEFAULT_MODES = 10,
    FEW_UNKNOWNS = 300,  /* dense takes as long as Lanczos, and sees the whole spectrum */
    MOST_UNKNOWNS = 6000 /* of dense matrices: 300 MB each */
};

struct hobe_modes {
    const hobe_model *model;
    struct hobe_modes_info info;
    double *omega2; /* [count] */
    double *shape;  /* [count][vectors][3] */
    char note[300];
};

/* ---- matrices -------------------------------------------------------------------------------- */

/* M = mass (x) I_3 of each element. */
static void assemble_mass(const hobe_model *model, double *Mx)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const int V = beam->kernel->vectors;
        for (int e = 0; e < beam->spec.elements; e++) {
            const double *mass = hobe_element_invariants(beam_law(beam, e))->mass;
            for (int v = 0; v < V; v++)
                for (int w = 0; w < V; w++) {
                    const double m = mass[v * V + w];
                    const double block[3][3] = {{m, 0, 0}, {0, m, 0}, {0, 0, m}};
                    tangent_add(model, beam, e, v, w, block, Mx);
                }
        }
    }
}

/* a'M b of two fields [vectors][3], held vectors included. */
static double mass_product(const hobe_model *model, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const int V = beam->kernel->vectors;
        for (int e = 0; e < beam->spec.elements; e++) {
            const double *mass = hobe_element_invariants(beam_law(beam, e))->mass;
            for (int v = 0; v < V; v++)
                for (int w = 0; w < V; w++)
                    sum += mass[v * V + w] * dot3(a + 3 * model_vector(model, beam, e, v),
                                                  b + 3 * model_vector(model, beam, e, w));
        }
    }
    return sum;
}

static void scale_values(const struct modal *s, double *Ax)
{
    const struct pattern *p = &s->model->pattern;
    for (long j = 0; j < s->n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            Ax[k] *= s->scale[p->Ai[k]] * s->scale[j];
}

static void assemble_matrices(struct modal *s)
{
    assemble(s->model, s->u, s->r, s->Ax);
    constraint_add(s->model, s->u, s->r, s->Ax);
    if (s->state)
        load_subtract(s->model, s->u, s->state->info.load, s->r, s->Ax);
    assemble_mass(s->model, s->Mx);
    pattern_scale(&s->model->pattern, s->Ax, s->scale);
    scale_values(s, s->Ax);
    scale_values(s, s->Mx);
}

/* y = M x, by rows, which are the columns of a symmetric matrix. */
void modal_multiply_mass(void *context, const double *x, double *y)
{
    const struct modal *s = context;
    const struct pattern *p = &s->model->pattern;
    for (long j = 0; j < s->n; j++) {
        y[j] = 0;
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            y[j] += s->Mx[k] * x[p->Ai[k]];
    }
}

/* Full = A - sigma M, [n][n]. */
void modal_spread(const struct modal *s, const double *Ax, double sigma, double *full)
{
    const struct pattern *p = &s->model->pattern;
    memset(full, 0, (size_t)(s->n * s->n) * sizeof *full);
    for (long j = 0; j < s->n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            full[j * s->n + p->Ai[k]] = Ax[k] - sigma * s->Mx[k];
}

/* ---- modes ----------------------------------------------------------------------------------- */

enum hobe_status modal_make_room(struct modal *s, int modes, struct hobe_error *err)
{
    hobe_free(s->omega2);
    hobe_free(s->X);
    s->room = modes;
    s->omega2 = hobe_alloc((size_t)modes, sizeof *s->omega2, err);
    s->X = hobe_alloc((size_t)modes * (size_t)s->n, sizeof *s->X, err);
    return s->omega2 && s->X ? HOBE_OK : HOBE_NO_MEMORY;
}

/* x'Mx = 1 and, among the modes, x_i'M x_j = 0 to rounding: dense vectors are orthogonal relative
 * to the lowest mode only.  The largest entry is positive, the first of nearly equal ones. */
static void orthonormalize(struct modal *s)
{
    for (int i = 0; i < s->room; i++) {
        double *x = s->X + i * s->n, largest = 0;
        for (int pass = 0; pass < 2; pass++) {
            modal_multiply_mass(s, x, s->product);
            for (int j = 0; j < i; j++) {
                const double along = dot(s->n, s->product, s->X + j * s->n);
                for (long k = 0; k < s->n; k++)
                    x[k] -= along * s->X[j * s->n + k];
            }
            modal_multiply_mass(s, x, s->product);
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

/* ---- dense ----------------------------------------------------------------------------------- */

/* Where K is indefinite, K - sigma M is not for a sigma below all omega^2, found by steps of four
 * from far below the lowest frequency; all omega^2 = sigma + 1/nu then lie above sigma. */
static enum hobe_status factor_dense(struct modal *s, double *M, double *K, double *nu,
                                     double *sigma, struct hobe_error *err)
{
    double trace = 0;
    int definite = 0;
    modal_spread(s, s->Mx, 0, M);
    for (long j = 0; j < s->n; j++)
        trace += M[j * s->n + j];
    double step = 1e-12 * (double)s->n / trace; /* K's diagonal is 1 */
    for (*sigma = 0; isfinite(step); *sigma = -step, step *= 4) {
        modal_spread(s, s->Mx, 0, M);
        modal_spread(s, s->Ax, *sigma, K);
        const enum hobe_status status = eigen_dense((int)s->n, M, K, nu, &definite, err);
        if (status || definite)
            return status;
    }
    return hobe_fail(err, HOBE_SINGULAR, NULL, "the mass matrix is not positive definite");
}

static enum hobe_status solve_dense(struct modal *s, int modes, int *unstable,
                                    struct hobe_error *err)
{
    const size_t size = (size_t)(s->n * s->n);
    double sigma, *M = hobe_alloc(size, sizeof *M, err);
    double *K = hobe_alloc(size, sizeof *K, err);
    double *nu = hobe_alloc((size_t)s->n, sizeof *nu, err);
    enum hobe_status status = M && K && nu ? modal_make_room(s, modes, err) : HOBE_NO_MEMORY;
    if (!status)
        status = factor_dense(s, M, K, nu, &sigma, err);
    *unstable = 0;
    for (long i = 0; !status && i < s->n; i++) { /* nu ascending: the lowest mode is the last */
        const long from = s->n - 1 - i;
        const double omega2 = sigma + 1 / nu[from];
        *unstable += omega2 < 0;
        if (i < modes) {
            s->omega2[i] = omega2;
            memcpy(s->X + i * s->n, M + from * s->n, (size_t)s->n * sizeof *M);
        }
    }
    hobe_free(M);
    hobe_free(K);
    hobe_free(nu);
    return status;
}

/* ---- what is asked for ----------------------------------------------------------------------- */

static enum hobe_status check_model(const struct modal *s, struct hobe_error *err)
{
    const hobe_model *model = s->model;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (!(beam->spec.material.rho > 0))
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "vibration needs a density: material.rho of beam \"%s\" is %g, must "
                             "be > 0 (kg/m^3)",
                             beam->name, beam->spec.material.rho);
    }
    if (s->state && s->state->model != model)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "the state belongs to another scene");
    for (size_t i = 0; s->state && i < model->forces.count; i++) {
        const struct hobe_force *force = (const struct hobe_force *)model->forces.item + i;
        if (force->follower)
            return hobe_fail(err, HOBE_BAD_INPUT, force->where,
                             "a follower force makes the stiffness unsymmetric, which modal "
                             "analysis about a loaded state cannot treat; make the force on beam "
                             "\"%s\" a dead one, or leave out the state",
                             force->beam);
    }
    return HOBE_OK;
}

/* Settles method and number of modes. */
static enum hobe_status choose(const struct modal *s, struct hobe_modal_options *o,
                               struct hobe_error *err)
{
    const long all = s->n - 2 * s->multipliers;
    if (o->modes == 0)
        o->modes = all < DEFAULT_MODES ? (int)all : DEFAULT_MODES;
    if (o->modes < 1 || o->modes > all)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "modes must be from 1 to the %ld that this scene has, got %d", all,
                         o->modes);
    if (o->method == HOBE_MODAL_DENSE && s->multipliers)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "method \"dense\" does not hold for rigid corners; use \"lanczos\"");
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

static enum hobe_status open_modal(struct modal *s, struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors), n = (size_t)(3 * s->model->unknowns);
    s->n = (long)n;
    for (long v = s->model->beam_vectors; v < s->model->vectors; v++)
        s->multipliers += 3 * (s->model->unknown[v] >= 0);
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
    if (s->state)
        memcpy(s->u, s->state->u, size * sizeof *s->u);
    for (size_t i = 0; i < n; i++)
        s->ones[i] = 1;
    return HOBE_OK;
}

static void close_modal(struct modal *s)
{
    hobe_free(s->u);
    hobe_free(s->r);
    hobe_free(s->scale);
    hobe_free(s->ones);
    hobe_free(s->product);
    hobe_free(s->Ax);
    hobe_free(s->Mx);
    hobe_free(s->Sx);
    hobe_free(s->omega2);
    hobe_free(s->X);
}

/* ---- what is given --------------------------------------------------------------------------- */

/* The unit translation of everything along an axis. */
static void translate(const hobe_model *model, int axis, double *field)
{
    memset(field, 0, (size_t)(3 * model->vectors) * sizeof *field);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int e = 0; e < beam->spec.elements; e++)
            for (int v = 0; v < beam->kernel->vectors; v++)
                if (beam->kernel->vector[v].mode == 0 && !beam->kernel->vector[v].slope)
                    field[3 * model_vector(model, beam, e, v) + axis] = 1;
    }
}

static void write_note(hobe_modes *modes)
{
    const int unstable = modes->info.unstable;
    if (unstable > 0)
        snprintf(modes->note, sizeof modes->note,
                 "the equilibrium is unstable: %d mode%s with omega^2 < 0, the lowest %.6g "
                 "rad^2/s^2",
                 unstable, unstable == 1 ? "" : "s", modes->omega2[0]);
    else if (unstable < 0)
        snprintf(modes->note, sizeof modes->note,
                 "unstable modes were looked for only among the %d nearest to omega = 0",
                 modes->info.count);
}

/* phi = D x on the unknowns, zero where held. */
static void write_shapes(const struct modal *s, hobe_modes *modes)
{
    const hobe_model *model = s->model;
    for (int i = 0; i < modes->info.count; i++)
        for (long v = 0; v < model->vectors; v++)
            for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
                const long k = 3 * model->unknown[v] + a;
                modes->shape[3 * (i * model->vectors + v) + a] = s->scale[k] * s->X[i * s->n + k];
            }
}

static enum hobe_status finish(struct modal *s, int count, int unstable,
                               enum hobe_modal_method method, hobe_modes **to,
                               struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors);
    hobe_modes *modes = *to = hobe_alloc(1, sizeof *modes, err);
    if (!modes)
        return HOBE_NO_MEMORY;
    modes->model = s->model;
    modes->omega2 = hobe_alloc((size_t)count, sizeof *modes->omega2, err);
    modes->shape = hobe_alloc((size_t)count * size, sizeof *modes->shape, err);
    if (!modes->omega2 || !modes->shape)
        return HOBE_NO_MEMORY;
    modes->info = (struct hobe_modes_info){
        .count = count, .unstable = unstable, .unknowns = s->n, .method = method};
    orthonormalize(s);
    memcpy(modes->omega2, s->omega2, (size_t)count * sizeof *modes->omega2);
    write_shapes(s, modes);
    write_note(modes);
    translate(s->model, 0, s->r);
    modes->info.mass = mass_product(s->model, s->r, s->r);
    return HOBE_OK;
}

enum hobe_status hobe_modal(hobe_model *model, const hobe_solution *state,
                            const struct hobe_modal_options *options, hobe_modes **modes,
                            struct hobe_error *err)
{
    struct hobe_modal_options o = *options;
    struct modal s = {.model = model, .state = state};
    int unstable = 0;
    *modes = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (status)
        return status;
    const double started = hobe_seconds();
    status = check_model(&s, err);
    if (!status)
        status = open_modal(&s, err);
    if (!status)
        status = choose(&s, &o, err);
    if (!status) {
        assemble_matrices(&s);
        status = o.method == HOBE_MODAL_DENSE ? solve_dense(&s, o.modes, &unstable, err)
                                              : modal_lanczos(&s, o.modes, &unstable, err);
    }
    if (!status)
        status = finish(&s, o.modes, unstable, o.method, modes, err);
    close_modal(&s);
    if (status) {
        hobe_modes_free(*modes);
        *modes = NULL;
    } else
        (*modes)->info.seconds = hobe_seconds() - started;
    return status;
}

void hobe_modes_free(hobe_modes *modes)
{
    if (!modes)
        return;
    hobe_free(modes->omega2);
    hobe_free(modes->shape);
    hobe_free(modes);
}

const hobe_model *modes_model(const hobe_modes *modes)
{
    return modes->model;
}

void hobe_modes_info(const hobe_modes *modes, struct hobe_modes_info *info)
{
    *info = modes->info;
}

const char *hobe_modes_note(const hobe_modes *modes)
{
    return modes->note[0] ? modes->note : NULL;
}

/* The shape of mode i, or NULL with err. */
static const double *shape_of(const hobe_modes *modes, int i, struct hobe_error *err)
{
    if (i >= 0 && i < modes->info.count)
        return modes->shape + 3 * i * modes->model->vectors;
    hobe_fail(err, HOBE_BAD_INPUT, NULL, "there is no mode %d among %d", i, modes->info.count);
    return NULL;
}

enum hobe_status hobe_modes_mode(const hobe_modes *modes, int i, struct hobe_mode *mode,
                                 struct hobe_error *err)
{
    const double *shape = shape_of(modes, i, err);
    if (!shape)
        return HOBE_BAD_INPUT;
    double *field = hobe_alloc((size_t)(3 * modes->model->vectors), sizeof *field, err);
    if (!field)
        return HOBE_NO_MEMORY;
    mode->omega2 = modes->omega2[i];
    mode->omega = mode->omega2 < 0 ? NAN : sqrt(mode->omega2);
    for (int a = 0; a < 3; a++) {
        translate(modes->model, a, field);
        mode->participation[a] = mass_product(modes->model, shape, field);
        mode->effective_mass[a] = mode->participation[a] * mode->participation[a];
    }
    hobe_free(field);
    return HOBE_OK;
}

enum hobe_status modes_displacement(const hobe_modes *modes, int i, const char *beam, double at,
                                    double y, double z, double r0[3], double u[3],
                                    struct hobe_error *err)
{
    const double *shape = shape_of(modes, i, err);
    if (!shape)
        return HOBE_BAD_INPUT;
    return solution_displacement(modes->model, shape, beam, at, y, z, r0, u, err);
}

enum hobe_status hobe_modes_point(const hobe_modes *modes, int i, const char *beam, double at,
                                  double y, double z, double u[3], struct hobe_error *err)
{
    return modes_displacement(modes, i, beam, at, y, z, NULL, u, err);
}

double hobe_modes_mass(const hobe_modes *modes, int i, int j)
{
    const double *a = shape_of(modes, i, NULL), *b = shape_of(modes, j, NULL);
    return a && b ? mass_product(modes->model, a, b) : NAN;
}
