/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies and mode shapes about an equilibrium: K phi = omega^2 M phi.
 *
 * Joints and rigid corners border K with multipliers, which have no mass: Lanczos' method in the
 * inner product of M keeps to the finite part of that pencil. */
#include "load.h"
#include "modes.h"
#include "pattern.h"
#include "solution.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- mass ------------------------------------------------------------------------------------ */

/* M = mass (x) I_3 of each element. */
static void assemble_mass(const hobe_model *model, const struct matrix *M)
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
                    tangent_add(model, beam, e, v, w, block, M);
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
                 unstable, unstable == 1 ? "" : "s", modes->mu[0]);
    else if (unstable < 0)
        snprintf(modes->note, sizeof modes->note,
                 "unstable modes were looked for only among the %d nearest to omega = 0",
                 modes->info.count);
}

static enum hobe_status check_density(const hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (!(beam->spec.material.rho > 0))
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "vibration needs a density: material.rho of beam \"%s\" is %g, must "
                             "be > 0 (kg/m^3)",
                             beam->name, beam->spec.material.rho);
    }
    return HOBE_OK;
}

static enum hobe_status solve(struct pencil *s, struct hobe_modal_options *o, hobe_modes **modes,
                              struct hobe_error *err)
{
    int unstable = 0;
    enum hobe_status status = check_density(s->model, err);
    if (!status)
        status = pencil_open(s, "modal analysis about a loaded state", err);
    if (!status)
        status = pencil_choose(s, o, err);
    if (status)
        return status;
    pencil_tangent(s, s->state ? s->state->info.load : 0, s->Ax);
    assemble_mass(s->model, &(struct matrix){COLUMNS, s->Mx});
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
    translate(s->model, 0, s->r);
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
        translate(modes->model, a, field);
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
