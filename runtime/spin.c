/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Turning.  In a frame that turns with w = w e about a point o, the acceleration of what
 * rests there is w x (w x (r - o)) = -w^2 P (r - o), P = I - e e'.  Positions are sums of nodal
 * vectors, r - o = S q, with o taken from those that are positions; so that virtual work gives
 * -w^2 M P q, M = m (x) I: slopes and section vectors are thrown outwards as positions are.
 * What moves in the frame feels Coriolis' force -2 M w x v, besides, and Euler's -M dw/dt x q where
 * the speed changes. */
#include "spin.h"

#include "drive.h"
#include "mass.h"
#include "reduction.h"
#include "vector3.h"

#include <math.h>

/* w and dw/dt about the axis at an instant, rad/s and rad/s^2. */
struct turn {
    double speed, rate;
};

static struct turn turn_at(const struct hobe_model *model, double time)
{
    const struct hobe_spin *spin = &model->spin;
    double d[2];
    drive_history(model, spin->history, time, spin->where, d);
    return (struct turn){spin->speed * d[0], spin->speed * d[1]};
}

/* A = square P */
static void outwards(const struct hobe_model *model, double square, double A[3][3])
{
    const double *e = model->spin.axis;
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 3; c++)
            A[a][c] = square * ((a == c) - e[a] * e[c]);
}

/* A = speed [e]x */
static void sideways(const struct hobe_model *model, double speed, double A[3][3])
{
    for (int c = 0; c < 3; c++) {
        const double e[3] = {c == 0, c == 1, c == 2};
        double column[3];
        cross3(model->spin.axis, e, column);
        for (int a = 0; a < 3; a++)
            A[a][c] = speed * column[a];
    }
}

/* A = factor (w^2 P - dw/dt [e]x), what positions are thrown by; equilibria turn steadily. */
static void thrown(const struct hobe_model *model, const struct turn *turn, int moving,
                   double factor, double A[3][3])
{
    double across[3][3];
    outwards(model, factor * turn->speed * turn->speed, A);
    sideways(model, moving ? -factor * turn->rate : 0, across);
    for (int i = 0; i < 9; i++)
        A[i / 3][i % 3] += across[i / 3][i % 3];
}

enum hobe_status spin_build(struct hobe_model *model, struct hobe_error *err)
{
    if (!model->spun)
        return HOBE_OK;
    if (mass_check(model, "a spin", NULL, err))
        return HOBE_BAD_INPUT;
    const size_t size = (size_t)(3 * model->vectors);
    model->arm = hobe_alloc(size, sizeof *model->arm, err);
    double *field = hobe_alloc(size, sizeof *field, err);
    if (model->arm && field) {
        model_reference(model, model->arm);
        for (int a = 0; a < 3; a++) {
            mass_translation(model, a, field);
            for (size_t i = 0; i < size; i++)
                model->arm[i] -= model->spin.about[a] * field[i];
        }
    }
    hobe_free(field);
    return model->arm && field ? HOBE_OK : HOBE_NO_MEMORY;
}

/* f += (m (x) A) of the arms of the reference. */
static void add_arms(const struct hobe_model *model, const double A[3][3], double *f)
{
    if (model->reduction)
        reduction_arm_force(model, A, model->spin.about, f);
    else
        mass_force_through(model, A, model->arm, f);
}

void spin_subtract(const struct hobe_model *model, const double *u, const struct instant *instant,
                   double factor, double *r, const struct matrix *K)
{
    double A[3][3];
    if (!model->spun)
        return;
    const int moving = instant->v != NULL;
    const struct turn turn = turn_at(model, instant->time);
    thrown(model, &turn, moving, -factor, A);
    add_arms(model, (const double(*)[3])A, r);
    mass_force_through(model, (const double(*)[3])A, u, r);
    thrown(model, &turn, moving && K && K->layout == COLUMNS, -factor, A);
    if (K)
        mass_matrix_through(model, (const double(*)[3])A, K);
    if (!moving)
        return;
    sideways(model, 2 * factor * turn.speed, A);
    mass_force_through(model, (const double(*)[3])A, instant->v, r);
    sideways(model, 2 * factor * turn.speed * instant->rate, A);
    if (K && K->layout == COLUMNS)
        mass_matrix_through(model, (const double(*)[3])A, K);
}

void spin_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double factor, const struct beam *beam, int e, double *f)
{
    double A[3][3];
    if (!model->spun)
        return;
    const struct turn turn = turn_at(model, instant->time);
    thrown(model, &turn, instant->v != NULL, factor, A);
    mass_element_force(model, beam, e, (const double(*)[3])A, model->arm, f);
    mass_element_force(model, beam, e, (const double(*)[3])A, u, f);
    sideways(model, -2 * factor * turn.speed, A);
    if (instant->v)
        mass_element_force(model, beam, e, (const double(*)[3])A, instant->v, f);
}

enum hobe_status spin_velocity(const struct hobe_model *model, double factor, double time,
                               double w[3], struct hobe_error *err)
{
    const struct hobe_spin *spin = &model->spin;
    const double speed = model->spun ? turn_at(model, time).speed * sqrt(factor) : 0;
    const enum hobe_status status = model_failure(model, err);
    if (status)
        return status;
    for (int a = 0; a < 3; a++)
        w[a] = speed * spin->axis[a];
    return model->spun && factor < 0
               ? hobe_fail(err, HOBE_BAD_INPUT, spin->where,
                           "no speed has the centrifugal force of the load factor %g, which scales "
                           "the speed's square; take a state with one >= 0",
                           factor)
               : HOBE_OK;
}
