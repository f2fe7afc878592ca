/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mass.h"

#include "body.h"
#include "load.h"
#include "point_mass.h"
#include "reduction.h"
#include "vector3.h"

#include <string.h>

/* m[V][V] of element e, kg. */
static const double *element_mass(const struct beam *beam, int e)
{
    return hobe_element_invariants(beam_law(beam, e))->mass;
}

/* A vector with a zero behind it, which compilers take as one. */
typedef double padded[4];

/* sum[v] = sum_w m[v][w] a_w of element e. */
static void weigh(const struct hobe_model *model, const struct beam *beam, int e, const double *a,
                  padded sum[HOBE_MAX_VECTORS])
{
    const int V = beam->kernel->vectors;
    const double *m = element_mass(beam, e);
    padded of[HOBE_MAX_VECTORS];
    for (int w = 0; w < V; w++) {
        memcpy(of[w], a + 3 * model_vector(model, beam, e, w), 3 * sizeof *a);
        of[w][3] = 0;
    }
    for (int v = 0; v < V; v++, m += V) {
        padded s = {0};
        for (int w = 0; w < V; w++)
            for (int c = 0; c < 4; c++)
                s[c] += m[w] * of[w][c];
        memcpy(sum[v], s, sizeof s);
    }
}

void mass_element_force(const struct hobe_model *model, const struct beam *beam, int e,
                        const double A[3][3], const double *a, double *f)
{
    padded sum[HOBE_MAX_VECTORS];
    weigh(model, beam, e, a, sum);
    for (int v = 0; v < beam->kernel->vectors; v++) {
        double *to = f + 3 * model_vector(model, beam, e, v);
        for (int c = 0; c < 3; c++)
            to[c] += dot3(A[c], sum[v]);
    }
}

static void element_matrix(const struct hobe_model *model, const struct beam *beam, int e,
                           const double A[3][3], const struct matrix *K)
{
    const int V = beam->kernel->vectors;
    const double *m = element_mass(beam, e);
    const long *place = beam->place[K->layout] + (long)e * V * V;
    for (int w = 0; w < V; w++) {
        const long j = model->unknown[model_vector(model, beam, e, w)];
        const int stride = j < 0 ? 0 : model->stride[K->layout][j];
        for (int v = 0; v < V; v++) {
            const long at = place[v * V + w];
            for (int c = 0; at >= 0 && c < 3; c++)
                for (int a = 0; a < 3; a++)
                    K->value[at + c * stride + a] += m[v * V + w] * A[a][c];
        }
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
    if (model->reduction) {
        reduction_mass_force(model, A, a, f);
        return;
    }
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
    if (model->reduction) {
        reduction_mass_matrix(model, A, K);
        return;
    }
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
    double sum = 0;
    padded Ma[HOBE_MAX_VECTORS];
    for (int e = 0; e < beam->spec.elements; e++) {
        weigh(model, beam, e, a, Ma);
        for (int v = 0; v < beam->kernel->vectors; v++)
            sum += dot3(Ma[v], b + 3 * model_vector(model, beam, e, v));
    }
    return sum;
}

double mass_product(const struct hobe_model *model, const double *a, const double *b)
{
    double sum = 0;
    if (model->reduction)
        return reduction_mass_product(model, a, b);
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

enum hobe_status mass_measure(const struct hobe_model *model, double *mass, double *size,
                              struct hobe_error *err)
{
    model = model_whole(model);
    const size_t n = (size_t)(3 * model->vectors);
    double *q = hobe_alloc(n, sizeof *q, err), *one = hobe_alloc(n, sizeof *one, err);
    if (q && one) {
        model_reference(model, q);
        mass_translation(model, 0, one);
        *mass = mass_product(model, one, one);
        for (int a = 0; a < 3; a++) {
            mass_translation(model, a, one);
            const double centre = mass_product(model, q, one) / *mass;
            for (long i = a; i < 3 * model->vectors; i += 3)
                q[i] -= centre * one[i];
        }
        *size = sqrt(fmax(0, mass_product(model, q, q)) / *mass);
    }
    hobe_free(q);
    hobe_free(one);
    return q && one ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status mass_check(const struct hobe_model *model, const char *what, const char *where,
                            struct hobe_error *err)
{
    model = model_whole(model);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (!(element_mass(beam, 0)[0] > 0)) /* of some part of a composite section */
            return hobe_fail(err, HOBE_BAD_INPUT, where ? where : beam->spec.where,
                             "%s needs a density: material.rho of beam \"%s\" is %g, must be > 0 "
                             "(kg/m^3)",
                             what, beam->name, beam->spec.material.rho);
    }
    return HOBE_OK;
}
