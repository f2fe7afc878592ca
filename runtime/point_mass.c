/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "point_mass.h"

#include "around.h"
#include "pattern.h"
#include "vector3.h"

static enum hobe_status find_place(const struct hobe_model *model, struct point_mass *mass,
                                   struct hobe_error *err)
{
    struct around p;
    const struct beam *beam = model_find_beam(model, mass->spec.beam, mass->spec.where, err);
    if (!beam)
        return HOBE_UNKNOWN;
    mass->place = model_place(beam, mass->spec.at);
    around_look(model, NULL, mass->place, &p);
    enum hobe_status status = HOBE_OK;
    if (mass->spec.y == 0 && mass->spec.z == 0)
        around_axis(&p); /* where forces act */
    else
        status = around_modes(&p, mass->spec.y, mass->spec.z, err);
    for (int v = 0; !status && v < p.kernel->vectors; v++)
        mass->weight[v] = p.N[v] * p.phi[p.kernel->vector[v].mode][0];
    return status;
}

void point_mass_value(const struct hobe_model *model, const struct point_mass *mass,
                      const double *a, double value[3])
{
    const struct place place = mass->place;
    for (int c = 0; c < 3; c++)
        value[c] = 0;
    for (int v = 0; v < place.beam->kernel->vectors; v++)
        for (int c = 0; c < 3; c++)
            value[c] +=
                mass->weight[v] * a[3 * model_vector(model, place.beam, place.element, v) + c];
}

void point_mass_force(const struct hobe_model *model, const struct point_mass *mass, double factor,
                      const double g[3], double *f)
{
    const struct place place = mass->place;
    for (int v = 0; v < place.beam->kernel->vectors; v++)
        for (int c = 0; c < 3; c++)
            f[3 * model_vector(model, place.beam, place.element, v) + c] +=
                factor * mass->spec.mass * mass->weight[v] * g[c];
}

void point_mass_matrix(const struct hobe_model *model, const struct point_mass *mass,
                       const double A[3][3], const struct matrix *K)
{
    const struct place place = mass->place;
    for (int v = 0; v < place.beam->kernel->vectors; v++)
        for (int w = 0; w < place.beam->kernel->vectors; w++) {
            double block[3][3];
            times3(mass->spec.mass * mass->weight[v] * mass->weight[w], A, block);
            pattern_add_element(model, place.beam, place.element, v, w, (const double(*)[3])block,
                                K);
        }
}

enum hobe_status point_mass_places(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < model->masses.count; i++)
        status = find_place(model, model_mass(model, i), err);
    return status;
}
