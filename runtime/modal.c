/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies and mode shapes about an equilibrium: K phi = omega^2 M phi.
 *
 * Joints and rigid corners border K with multipliers, which have no mass: Lanczos' method in the
 * inner product of M keeps to the finite part of that pencil. */
#include "mass.h"
#include "modes.h"
#include "pattern.h"
#include "solution.h"

#include <math.h>
#include <stdio.h>

/* ---- what is given --------------------------------------------------------------------------- */

static void write_note(hobe_modes *modes)
{
    const int unstable = modes->info.unstable;
    if (unstable > 0)
        snprintf(modes->note, sizeof modes->note,
                 "the equilibrium is unstable: %d mode%s with omega^2 < 0, the lowest %.6g "
                 "rad^2/s^2",
                 unstable, unstable == 1 ? "" : "s", modes->mu[0]);
    else if (unstable < 0)
        snprintf(modes->note, sizeof modes->note,
                 "unstable modes were looked for only among the %d nearest to omega = 0",
                 modes->info.count);
}

static enum hobe_status solve(struct pencil *s, struct hobe_modal_options *o, hobe_modes **modes,
                              struct hobe_error *err)
{
    int unstable = 0;
    enum hobe_status status = mass_check(s->model, "vibration", err);
    if (!status)
        status = pencil_open(s, "modal analysis about a loaded state", err);
    if (!status)
        status = pencil_choose(s, o, err);
    if (status)
        return status;
    pencil_tangent(s, s->state ? s->state->info.load : 0, s->Ax);
    mass_matrix(s->model, 1, &(struct matrix){COLUMNS, s->Mx});
    pattern_scale(s->model, &(struct matrix){COLUMNS, s->Ax}, s->scale);
    pencil_scale(s, s->Ax);
    pencil_scale(s, s->Mx);
    status = pencil_solve(s, o, &unstable, err);
    if (status)
        return status;
    *modes = modes_take(s, o->modes, o->method, err);
    if (!*modes)
        return HOBE_NO_MEMORY;
    (*modes)->info.unstable = unstable;
    write_note(*modes);
    mass_translation(s->model, 0, s->r);
    (*modes)->info.mass = mass_product(s->model, s->r, s->r);
    return HOBE_OK;
}

enum hobe_status hobe_modal(hobe_model *model, const hobe_solution *state,
                            const struct hobe_modal_options *options, hobe_modes **modes,
                            struct hobe_error *err)
{
    return modes_find(&(struct pencil){.model = model, .state = state}, options, solve, modes, err);
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
    mode->omega2 = modes->mu[i];
    mode->omega = mode->omega2 < 0 ? NAN : sqrt(mode->omega2);
    for (int a = 0; a < 3; a++) {
        mass_translation(modes->model, a, field);
        mode->participation[a] = mass_product(modes->model, shape, field);
        mode->effective_mass[a] = mode->participation[a] * mode->participation[a];
    }
    hobe_free(field);
    return HOBE_OK;
}

double hobe_modes_mass(const hobe_modes *modes, int i, int j)
{
    const double *a = modes_shape(modes, i, NULL), *b = modes_shape(modes, j, NULL);
    return a && b ? mass_product(modes->model, a, b) : NAN;
}
