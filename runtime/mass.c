/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mass.h"

#include "body.h"
#include "load.h"
#include "point_mass.h"
#include "vector3.h"

#include <string.h>

/* m[V][V] of element e, kg. */
static const double *element_mass(const struct beam *beam, int e)
{
    return hobe_element_invariants(beam_law(beam, e))->mass;
}

void mass_element_force(const struct hobe_model *model, const struct beam *beam, int e,
                        const double A[3][3], const double *a, double *f)
{
    const int V = beam->kernel->vectors;
    const double *m = element_mass(beam, e);
    for (int v = 0; v < V; v++) {
        double sum[3] = {0}, *to = f + 3 * model_vector(model, beam, e, v);
        for (int w = 0; w < V; w++)
            for (int c = 0; c < 3; c++)
                sum[c] += m[v * V + w] * a[3 * model_vector(model, beam, e, w) + c];
        for (int c = 0; c < 3; c++)
            to[c] += dot3(A[c], sum);
    }
}

static void element_matrix(const struct hobe_model *model, const struct beam *beam, int e,
                           const double A[3][3], const struct matrix *K)
{
    const int V = beam->kernel->vectors;
    for (int v = 0; v < V; v++)
        for (int w = 0; w < V; w++) {
            double block[3][3];
            times3(element_mass(beam, e)[v * V + w], A, block);
            tangent_add(model, beam, e, v, w, (const double(*)[3])block, K);
        }
}

void mass_force_of(const struct hobe_model *model, const struct beam *beam, double factor,
                   const double *a, double *f)
{
    for (int e = 0; e < beam->spec.elements; e++)
        mass_element_force(model, beam, e, MASS_ISOTROPIC(factor), a, f);
}

void mass_matrix_of(const struct hobe_model *model, const struct beam *beam, double factor,
                    const struct matrix *K)
{
    for (int e = 0; e < beam->spec.elements; e++)
        element_matrix(model, beam, e, MASS_ISOTROPIC(factor), K);
}

void mass_force_through(const struct hobe_model *model, const double A[3][3], const double *a,
                        double *f)
{
    for (size_t i = 0; i < model->beams.count; i++)
        for (int e = 0; e < model_beam(model, i)->spec.elements; e++)
            mass_element_force(model, model_beam(model, i), e, A, a, f);
    for (size_t i = 0; i < model->bodies.count; i++)
        body_mass_force(model_body(model, i), A, a, f);
    for (size_t i = 0; i < model->masses.count; i++) {
        double moved[3], through[3];
        point_mass_value(model, model_mass(model, i), a, moved);
        for (int c = 0; c < 3; c++)
            through[c] = dot3(A[c], moved);
        point_mass_force(model, model_mass(model, i), 1, through, f);
    }
}

void mass_matrix_through(const struct hobe_model *model, const double A[3][3],
                         const struct matrix *K)
{
    for (size_t i = 0; i < model->beams.count; i++)
        for (int e = 0; e < model_beam(model, i)->spec.elements; e++)
            element_matrix(model, model_beam(model, i), e, A, K);
    for (size_t i = 0; i < model->bodies.count; i++)
        body_mass_matrix(model, model_body(model, i), A, K);
    for (size_t i = 0; i < model->masses.count; i++)
        point_mass_matrix(model, model_mass(model, i), A, K);
}

void mass_force(const struct hobe_model *model, double factor, const double *a, double *f)
{
    mass_force_through(model, MASS_ISOTROPIC(factor), a, f);
}

void mass_matrix(const struct hobe_model *model, double factor, const struct matrix *K)
{
    mass_matrix_through(model, MASS_ISOTROPIC(factor), K);
}

double mass_product_of(const struct hobe_model *model, const struct beam *beam, const double *a,
                       const double *b)
{
    const int V = beam->kernel->vectors;
    double sum = 0;
    for (int e = 0; e < beam->spec.elements; e++)
        for (int v = 0; v < V; v++)
            for (int w = 0; w < V; w++)
                sum += element_mass(beam, e)[v * V + w] *
                       dot3(a + 3 * model_vector(model, beam, e, v),
                            b + 3 * model_vector(model, beam, e, w));
    return sum;
}

double mass_product(const struct hobe_model *model, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < model->beams.count; i++)
        sum += mass_product_of(model, model_beam(model, i), a, b);
    for (size_t i = 0; i < model->bodies.count; i++)
        sum += body_mass_product(model_body(model, i), a, b);
    for (size_t i = 0; i < model->masses.count; i++) {
        const struct point_mass *mass = model_mass(model, i);
        double x[3], y[3];
        point_mass_value(model, mass, a, x);
        point_mass_value(model, mass, b, y);
        sum += mass->spec.mass * dot3(x, y);
    }
    return sum;
}

void mass_translation(const struct hobe_model *model, int axis, double *field)
{
    memset(field, 0, (size_t)(3 * model->vectors) * sizeof *field);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int e = 0; e < beam->spec.elements; e++)
            for (int v = 0; v < beam->kernel->vectors; v++)
                if (beam->kernel->vector[v].mode == 0 && !beam->kernel->vector[v].slope)
                    field[3 * model_vector(model, beam, e, v) + axis] = 1;
    }
    for (size_t i = 0; i < model->bodies.count; i++)
        field[3 * model_body(model, i)->first + axis] = 1;
}

enum hobe_status mass_check(const struct hobe_model *model, const char *what,
                            struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (!(beam->spec.material.rho > 0))
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "%s needs a density: material.rho of beam \"%s\" is %g, must be > 0 "
                             "(kg/m^3)",
                             what, beam->name, beam->spec.material.rho);
    }
    return HOBE_OK;
}
