/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady turning.  In a frame that turns with w = w e about a point o, the acceleration of what
 * rests there is w x (w x (r - o)) = -w^2 P (r - o), P = I - e e'.  Positions are sums of nodal
 * vectors, r - o = S q, with o taken from those that are positions; so that virtual work gives
 * -w^2 M P q, M = m (x) I: slopes and section vectors are thrown outwards as positions are.
 * What moves in the frame feels Coriolis' force -2 M w x v, besides. */
#include "spin.h"

#include "mass.h"
#include "vector3.h"

#include <math.h>

/* A = factor w^2 P */
static void outwards(const struct hobe_model *model, double factor, double A[3][3])
{
    const struct hobe_spin *spin = &model->spin;
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 3; c++)
            A[a][c] =
                factor * spin->speed * spin->speed * ((a == c) - spin->axis[a] * spin->axis[c]);
}

/* A = factor 2 [w]x */
static void sideways(const struct hobe_model *model, double factor, double A[3][3])
{
    const struct hobe_spin *spin = &model->spin;
    for (int c = 0; c < 3; c++) {
        const double e[3] = {c == 0, c == 1, c == 2};
        double column[3];
        cross3(spin->axis, e, column);
        for (int a = 0; a < 3; a++)
            A[a][c] = 2 * factor * spin->speed * column[a];
    }
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

void spin_subtract(const struct hobe_model *model, const double *u, const struct instant *instant,
                   double factor, double *r, const struct matrix *K)
{
    double A[3][3];
    if (!model->spun)
        return;
    outwards(model, -factor, A);
    mass_force_through(model, (const double(*)[3])A, model->arm, r);
    mass_force_through(model, (const double(*)[3])A, u, r);
    if (K)
        mass_matrix_through(model, (const double(*)[3])A, K);
    if (!instant->v)
        return;
    sideways(model, factor, A);
    mass_force_through(model, (const double(*)[3])A, instant->v, r);
    sideways(model, factor * instant->rate, A);
    if (K && K->layout == COLUMNS)
        mass_matrix_through(model, (const double(*)[3])A, K);
}

void spin_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double factor, const struct beam *beam, int e, double *f)
{
    double A[3][3];
    if (!model->spun)
        return;
    outwards(model, factor, A);
    mass_element_force(model, beam, e, (const double(*)[3])A, model->arm, f);
    mass_element_force(model, beam, e, (const double(*)[3])A, u, f);
    sideways(model, -factor, A);
    if (instant->v)
        mass_element_force(model, beam, e, (const double(*)[3])A, instant->v, f);
}

enum hobe_status spin_velocity(const struct hobe_model *model, double factor, double w[3],
                               struct hobe_error *err)
{
    const struct hobe_spin *spin = &model->spin;
    for (int a = 0; a < 3; a++)
        w[a] = model->spun ? spin->speed * sqrt(factor) * spin->axis[a] : 0;
    return model->spun && factor < 0
               ? hobe_fail(err, HOBE_BAD_INPUT, spin->where,
                           "no speed has the centrifugal force of the load factor %g, which scales "
                           "the speed's square; take a state with one >= 0",
                           factor)
               : HOBE_OK;
}
