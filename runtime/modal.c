/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies and mode shapes about an equilibrium: K phi = omega^2 M phi; where the frame
 * turns, gyroscopic.c goes on from these modes.
 *
 * Joints and rigid corners border K with multipliers, which have no mass: Lanczos' method in the
 * inner product of M keeps to the finite part of that pencil. */
#include "gyroscopic.h"
#include "mass.h"
#include "modes.h"
#include "pattern.h"
#include "solution.h"
#include "spin.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

/* ---- what is given --------------------------------------------------------------------------- */

/* More than this share of an omega^2 is said. */
static const double FEW_DIGITS = 1e-3;

static void write_note(hobe_modes *modes)
{
    const int unstable = modes->info.unstable;
    const double share = modes->info.round_off;
    int n = 0;
    if (unstable > 0)
        n = snprintf(modes->note, sizeof modes->note,
                     "the equilibrium is unstable: %d mode%s with omega^2 < 0, the lowest %.6g "
                     "rad^2/s^2",
                     unstable, unstable == 1 ? "" : "s", modes->mu[0]);
    else if (unstable < 0)
        n = snprintf(modes->note, sizeof modes->note,
                     "unstable modes were looked for only among the %d nearest to omega = 0",
                     modes->info.count);
    if (share > FEW_DIGITS)
        snprintf(modes->note + n, sizeof modes->note - (size_t)n,
                 "%srounding of the stiffness may make up %.1g of the lowest omega^2; fewer "
                 "elements have less of it",
                 n > 0 ? "; " : "", share);
}

/* The share of an omega^2 = x'K x, K with a unit diagonal, that is left to chance when each entry
 * of the diagonal is rounded: eps |(x_k^2)| in the Euclidean norm. */
static double round_off(const struct pencil *s, int i)
{
    const double *x = s->X + i * s->n;
    double sum = 0;
    for (long k = 0; k < s->n - s->multipliers; k++)
        sum += x[k] * x[k] * x[k] * x[k];
    return DBL_EPSILON * sqrt(sum) / fabs(s->mu[i]);
}

/* The modes of K and M, at least so many as the options ask for, in the pencil. */
static enum hobe_status solve_pencil(struct pencil *s, const struct hobe_modal_options *o,
                                     double load, int *unstable, struct hobe_error *err)
{
    pencil_tangent(s, load, s->Ax);
    mass_matrix(s->model, 1, &(struct matrix){COLUMNS, s->Mx});
    pattern_scale(s->model, &(struct matrix){COLUMNS, s->Ax}, s->scale);
    pencil_scale(s, s->Ax);
    pencil_scale(s, s->Mx);
    return pencil_solve(s, o, unstable, err);
}

static enum hobe_status take(struct pencil *s, const struct hobe_modal_options *o, int unstable,
                             hobe_modes **modes, struct hobe_error *err)
{
    *modes = modes_take(s, o->modes, o->method, err);
    if (!*modes)
        return HOBE_NO_MEMORY;
    (*modes)->info.unstable = unstable;
    for (int i = 0; i < o->modes; i++)
        (*modes)->info.round_off = fmax((*modes)->info.round_off, round_off(s, i));
    write_note(*modes);
    return HOBE_OK;
}

static enum hobe_status solve(struct pencil *s, struct hobe_modal_options *o, hobe_modes **modes,
                              struct hobe_error *err)
{
    const double load = s->state ? s->state->info.load : 0;
    const double time = s->state ? s->state->info.time : 0;
    double w[3] = {0};
    int unstable = 0;
    enum hobe_status status = mass_check(s->model, "vibration", NULL, err);
    if (!status)
        status = pencil_open(s, "modal analysis about a loaded state", err);
    if (!status)
        status = spin_velocity(s->model, load, time, w, err);
    if (!status)
        status = pencil_choose(s, o, err);
    if (status)
        return status;
    const int turning = dot3(w, w) > 0;
    const struct hobe_modal_options basis = turning ? gyroscopic_basis(s, o) : *o;
    status = solve_pencil(s, &basis, load, &unstable, err);
    if (!status)
        status = turning ? gyroscopic_modes(s, o, w, unstable, modes, err)
                         : take(s, o, unstable, modes, err);
    if (status)
        return status;
    double size;
    return mass_measure(s->model, &(*modes)->info.mass, &size, err);
}

enum hobe_status hobe_modal(hobe_model *model, const hobe_solution *state,
                            const struct hobe_modal_options *options, hobe_modes **modes,
                            struct hobe_error *err)
{
    return modes_find(&(struct pencil){.model = model, .state = state}, options, solve, modes, err);
}

/* What of the mode's angular momentum about the axis is in phase with its energy: for a motion
 * a cos(omega t) - b sin(omega t) it is -omega w.(a x b), summed over the mass. */
static double whirl(const hobe_modes *modes, const double *a, const double *b, double *field)
{
    const double w = length3(modes->w);
    for (long v = 0; v < modes->model->vectors; v++)
        cross3(modes->w, a + 3 * v, field + 3 * v);
    return -2 * mass_product(modes->model, b, field) / w;
}

enum hobe_status hobe_modes_mode(const hobe_modes *modes, int i, struct hobe_mode *mode,
                                 struct hobe_error *err)
{
    const double *shape = modes_shape(modes, i, err);
    if (!shape)
        return HOBE_BAD_INPUT;
    double *field = hobe_alloc((size_t)(3 * modes->model->vectors), sizeof *field, err);
    if (!field)
        return HOBE_NO_MEMORY;
    const double *exponent = modes->exponent ? modes->exponent + 2 * i : NULL;
    *mode = (struct hobe_mode){.omega2 = modes->mu[i]};
    mode->omega = exponent           ? exponent[1] > 0 ? exponent[1] : NAN
                  : mode->omega2 < 0 ? NAN
                                     : sqrt(mode->omega2);
    mode->growth = exponent ? exponent[0] : mode->omega2 < 0 ? sqrt(-mode->omega2) : 0;
    if (exponent)
        mode->whirl = whirl(modes, shape, modes->quadrature + 3 * i * modes->model->vectors, field);
    for (int a = 0; a < 3; a++) {
        mass_translation(modes->model, a, field);
        mode->participation[a] = exponent ? NAN : mass_product(modes->model, shape, field);
        mode->effective_mass[a] = mode->participation[a] * mode->participation[a];
    }
    hobe_free(field);
    return HOBE_OK;
}

double hobe_modes_mass(const hobe_modes *modes, int i, int j)
{
    const double *a = modes_shape(modes, i, NULL), *b = modes_shape(modes, j, NULL);
    if (!a || !b)
        return NAN;
    double sum = mass_product(modes->model, a, b);
    if (modes->quadrature)
        sum += mass_product(modes->model, modes->quadrature + (a - modes->shape),
                            modes->quadrature + (b - modes->shape));
    return sum;
}
