/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a reduced model has to beat: the whole one on a mesh so coarse that it has about as many
 * unknowns. */
#include "load.h"
#include "reduction.h"
#include "solution.h"
#include "spring.h"
#include "trust.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 4, PLACES = 4 /* parts of a beam between places that are compared */ };

typedef enum hobe_status adder(hobe_model *model, const void *spec, struct hobe_error *err);

#define ADDER(item)                                                                                \
    static enum hobe_status add_##item(hobe_model *model, const void *spec,                        \
                                       struct hobe_error *err)                                     \
    {                                                                                              \
        return hobe_model_##item(model, spec, err);                                                \
    }
ADDER(clamp)
ADDER(join)
ADDER(joint)
ADDER(force)
ADDER(moment)

/* Adds items that begin with what they were given as. */
static enum hobe_status add_all(hobe_model *model, const struct list *from, size_t size, adder *add,
                                struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < from->count; i++)
        status = add(model, (const char *)from->item + i * size, err);
    return status;
}

/* The beams on `share` of their elements, at least one each. */
static enum hobe_status add_beams(hobe_model *model, const hobe_model *from, double share,
                                  struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < from->beams.count; i++) {
        struct hobe_beam spec = model_beam(from, i)->spec;
        spec.name = model_beam(from, i)->name;
        spec.elements = (int)fmax(1, round(share * spec.elements));
        status = hobe_model_beam(model, &spec, err);
    }
    return status;
}

static enum hobe_status add_loads(hobe_model *model, const hobe_model *from, struct hobe_error *err)
{
    const struct gravity *gravity = from->gravities.item;
    enum hobe_status status = hobe_model_gravity(model, from->gravity_where, from->gravity, err);
    for (size_t i = 0; !status && i < from->gravities.count; i++)
        status = hobe_model_gravity_history(model, gravity[i].where, gravity[i].g,
                                            gravity[i].history, err);
    if (!status && from->spun)
        status = hobe_model_spin(model, &from->spin, err);
    if (!status)
        status = add_all(model, &from->forces, sizeof(struct force), add_force, err);
    return status ? status : add_all(model, &from->moments, sizeof(struct moment), add_moment, err);
}

static enum hobe_status fill(hobe_model *model, const hobe_model *from, double share,
                             struct hobe_error *err)
{
    enum hobe_status status = add_beams(model, from, share, err);
    if (!status)
        status = add_all(model, &from->clamps, sizeof(struct hobe_clamp), add_clamp, err);
    if (!status)
        status = add_all(model, &from->joins, sizeof(struct hobe_join), add_join, err);
    if (!status)
        status = add_all(model, &from->joints, sizeof(struct hobe_joint), add_joint, err);
    for (size_t i = 0; !status && i < from->springs.count; i++)
        status = hobe_model_spring(model, &model_spring(from, i)->spec, err);
    return status ? status : add_loads(model, from, err);
}

/* The largest distance of two states at some places of all beams, on the axis and at a corner of
 * the section's extent, and the largest displacement of the first. */
static enum hobe_status compare(const hobe_solution *a, const hobe_solution *b, double *error,
                                struct hobe_error *err)
{
    double apart = 0, size = 0;
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < a->model->beams.count; i++) {
        const struct beam *beam = model_beam(a->model, i);
        struct hobe_section_properties p;
        hobe_section_properties(beam->spec.section, &p);
        for (int k = 0; !status && k < 2 * (PLACES + 1); k++) {
            const double at = k / 2 / (double)PLACES, y = k % 2 * p.width / 2;
            const double z = k % 2 * p.height / 2;
            double u[2][3], d[3];
            status = solution_displacement(a->model, a->u, beam->name, at, y, z, NULL, u[0], err);
            if (!status)
                status =
                    solution_displacement(b->model, b->u, beam->name, at, y, z, NULL, u[1], err);
            for (int x = 0; !status && x < 3; x++)
                d[x] = u[1][x] - u[0][x];
            if (status)
                break;
            apart = fmax(apart, length3(d));
            size = fmax(size, length3(u[0]));
        }
    }
    *error = size > 0 ? apart / size : 0;
    return status;
}

/* *whole = a state with what it lacks, as good as the whole model's; HOBE_NOT_CONVERGED, without a
 * sentence, where that is out of reach. */
static enum hobe_status complete(hobe_model *model, const hobe_solution *state,
                                 hobe_solution **whole, struct hobe_error *err)
{
    struct trust trust;
    double size = 0, indicator;
    double *u = hobe_alloc((size_t)(3 * model->vectors), sizeof *u, err);
    if (!u)
        return HOBE_NO_MEMORY;
    enum hobe_status status = trust_open(&trust, model, err);
    if (!status)
        status = trust_measure(&trust, state, &size, &indicator, u, err);
    trust_close(&trust);
    for (long i = 0; i < 3 * model->vectors; i++)
        u[i] += state->u[i];
    if (!status && isinf(indicator))
        status = HOBE_NOT_CONVERGED;
    if (!status) {
        *whole = solution_new(model, u, NULL, NULL, &state->info, err);
        status = *whole ? HOBE_OK : HOBE_NO_MEMORY;
    }
    hobe_free(u);
    return status;
}

static enum hobe_status measure(hobe_model *mesh, hobe_model *model, const hobe_solution *state,
                                struct hobe_coarse *coarse, struct hobe_error *err)
{
    const struct hobe_newton options = {.steps = STEPS};
    hobe_solution *is = NULL, *whole = NULL;
    struct hobe_model_info info;
    enum hobe_status status = complete(model, state, &whole, err);
    if (!status)
        status = hobe_static(mesh, &options, &is, err);
    if (!status)
        status = compare(whole, is, &coarse->error, err);
    if (!status)
        status = compare(whole, state, &coarse->reduced, err);
    hobe_model_info(mesh, &info);
    coarse->elements = status ? 0 : info.elements;
    coarse->unknowns = info.unknowns;
    hobe_solution_free(is);
    hobe_solution_free(whole);
    return status;
}

enum hobe_status hobe_reduced_coarse(const hobe_model *small, const hobe_solution *state,
                                     struct hobe_coarse *coarse, struct hobe_error *err)
{
    hobe_model *model = small->reduction->whole;
    const double share = (double)small->reduction->n / (double)(3 * model->unknowns);
    *coarse = (struct hobe_coarse){0};
    if (model->bodies.count + model->masses.count > 0)
        return HOBE_OK;
    hobe_model *mesh = hobe_model_new(err);
    if (!mesh)
        return HOBE_NO_MEMORY;
    enum hobe_status status = fill(mesh, model, share, err);
    if (!status)
        status = hobe_model_build(mesh, err);
    if (!status)
        status = measure(mesh, model, state, coarse, err);
    hobe_model_free(mesh);
    return status == HOBE_NO_MEMORY ? status : HOBE_OK;
}
