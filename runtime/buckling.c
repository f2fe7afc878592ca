/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linear buckling: the load factors lambda + mu at which the tangent stiffness, with the stresses
 * of the linear response but without its displacements, becomes singular: (K + mu G) phi = 0.
 *
 * K v = Q is the response to all loads.  G, the geometric stiffness, is the second derivative of
 * the strains by the displacements times the stresses of v; of a spring that of its extension
 * times v's force, of a joint that of its constraints times v's multipliers; and of loads that
 * depend on the state -dQ/du.  What v's rotations change in K is left out, as everywhere in linear
 * buckling: linear in mu it would be no rotation but a strain, and soften a beam that bends before
 * it buckles.
 *
 * G is the central difference of the tangent of elements that are strained by +-epsilon v in place:
 * exact where strains are quadratic in u. */
#include "assemble.h"
#include "constraint.h"
#include "load.h"
#include "modes.h"
#include "pattern.h"
#include "solution.h"
#include "spring.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The change of the scaled tangent over half the difference: rounding is 1e-12 of it, the error of
 * a structural law, of the second order, 1e-8. */
static const double CHANGE = 1e-4;

/* A load that would change the scaled stiffness this many times over, were its response linear, is
 * beyond what is meant by linear buckling. */
static const double BEYOND = 10;

/* s->r = the forces of all loads in the state s->u. */
static void loads_at(struct pencil *s)
{
    memset(s->r, 0, (size_t)(3 * s->model->vectors) * sizeof *s->r);
    const struct instant instant = solution_instant(s->state, s->model);
    load_subtract(s->model, s->u, &instant, -1, s->r, NULL);
}

/* rate[vectors][3] = v with K v = Q, by K's factors, zero where held. */
static enum hobe_status find_rate(struct pencil *s, double *rate, struct hobe_error *err)
{
    const hobe_model *model = s->model;
    loads_at(s);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++)
            s->product[3 * model->unknown[v] + a] = s->r[3 * v + a];
    enum hobe_status status = model_failure(model, err);
    if (!status)
        status = pencil_factor(s, s->Ax, s->scale, err);
    if (!status)
        status = pencil_divide(s, s->product, err);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++)
            rate[3 * v + a] = s->product[3 * model->unknown[v] + a];
    return status;
}

/* Ax = K + step G, but for what does not depend on the step; v[vectors][3] is scratch. */
static void stiffen(struct pencil *s, const double *rate, double lambda, double step, double *v,
                    double *Ax)
{
    const hobe_model *model = s->model;
    const struct matrix K = {COLUMNS, Ax};
    const struct instant instant = solution_instant(s->state, s->model);
    const long moving = 3 * model->moving, all = 3 * model->vectors;
    for (long i = 0; i < moving; i++)
        v[i] = step * rate[i];
    assemble_strained(model, s->u, v, &K);
    spring_strained(model, s->u, v, &K);
    for (long i = 0; i < all; i++) /* multipliers are forces */
        v[i] = s->u[i] + (i < moving ? 0 : step * rate[i]);
    constraint_add(model, v, &instant, s->r, &K);
    load_subtract(model, s->u, &instant, lambda + step, s->r, &K);
}

/* Mx = -D G D by the central difference over +-step; the largest of its entries. */
static double differentiate(struct pencil *s, const double *rate, double lambda, double step,
                            double *v)
{
    double largest = 0;
    stiffen(s, rate, lambda, step, v, s->Sx);
    stiffen(s, rate, lambda, -step, v, s->Mx);
    for (long k = 0; k < values(s); k++)
        s->Mx[k] = (s->Mx[k] - s->Sx[k]) / (2 * step);
    pencil_scale(s, s->Mx);
    for (long k = 0; k < values(s); k++)
        largest = fmax(largest, fabs(s->Mx[k]));
    return largest;
}

/* Both matrices of the pencil at the load factor of its state. */
static enum hobe_status make_matrices(struct pencil *s, double lambda, struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors);
    double *rate = hobe_alloc(2 * size, sizeof *rate, err);
    if (!rate)
        return HOBE_NO_MEMORY;
    pencil_tangent(s, lambda, s->Ax);
    pattern_scale(s->model, &(struct matrix){COLUMNS, s->Ax}, s->scale);
    const enum hobe_status status = find_rate(s, rate, err);
    if (!status) {
        const double change = differentiate(s, rate, lambda, 1, rate + size);
        if (change > 0)
            differentiate(s, rate, lambda, CHANGE / change, rate + size);
        s->least = change / BEYOND;
        pencil_scale(s, s->Ax);
    }
    hobe_free(rate);
    return status;
}

static void write_note(hobe_modes *modes, int wanted)
{
    const int found = modes->info.count;
    if (found == 0)
        snprintf(modes->note, sizeof modes->note,
                 "no critical load in the direction of the loads: none of their multiples makes "
                 "the stiffness singular");
    else if (found < wanted)
        snprintf(modes->note, sizeof modes->note,
                 "critical loads in the direction of the loads are %d, not the %d that were asked "
                 "for",
                 found, wanted);
}

static enum hobe_status solve(struct pencil *s, struct hobe_modal_options *o, hobe_modes **modes,
                              struct hobe_error *err)
{
    const double lambda = s->state ? s->state->info.load : 0;
    int unstable, found = 0;
    if (s->model->reduction)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "buckling is for whole models; of a reduced one, follow the path");
    enum hobe_status status = pencil_open(s, "linear buckling", err);
    if (!status)
        status = pencil_choose(s, o, err);
    if (!status)
        status = make_matrices(s, lambda, err);
    if (!status && s->least == 0)
        status = hobe_fail(err, HOBE_BAD_INPUT, NULL,
                           "buckling needs loads that strain the scene, and it has none");
    if (!status)
        status = pencil_solve(s, o, &unstable, err);
    if (status)
        return status;
    while (found < o->modes && isfinite(s->mu[found]))
        found++;
    *modes = modes_take(s, found, o->method, err);
    if (!*modes)
        return HOBE_NO_MEMORY;
    for (int i = 0; i < found; i++)
        (*modes)->mu[i] += lambda;
    write_note(*modes, o->modes);
    return HOBE_OK;
}

enum hobe_status hobe_buckling(hobe_model *model, const hobe_solution *state,
                               const struct hobe_modal_options *options, hobe_modes **modes,
                               struct hobe_error *err)
{
    return modes_find(&(struct pencil){.model = model, .state = state, .buckling = 1}, options,
                      solve, modes, err);
}

double hobe_modes_factor(const hobe_modes *modes, int i)
{
    return modes->info.buckling && modes_shape(modes, i, NULL) ? modes->mu[i] : NAN;
}
