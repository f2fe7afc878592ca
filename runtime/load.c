/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load.h"

#include "body.h"
#include "load_parts.h"
#include "point_mass.h"
#include "reduction.h"
#include "spin.h"

#include <string.h>

/* What a load acts on: a body, or, not at a point, a beam. */
static enum hobe_status find_target(const struct hobe_model *model, const char *name, double at,
                                    int at_point, const char *where, struct target *on,
                                    struct hobe_error *err)
{
    struct part part;
    if (model_find_part(model, name, where, &part, err))
        return HOBE_UNKNOWN;
    if (part.beam && at_point)
        return model_refuse_point(name, where, err);
    on->body = part.body;
    if (part.beam)
        on->place = model_place(part.beam, at);
    return HOBE_OK;
}

enum hobe_status load_find(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < model->forces.count; i++) {
        const struct hobe_force *spec = &model_force(model, i)->spec;
        status = find_target(model, spec->beam, spec->at, spec->at_point, spec->where,
                             &model_force(model, i)->on, err);
    }
    for (size_t i = 0; !status && i < model->moments.count; i++) {
        const struct hobe_moment *spec = &model_moment(model, i)->spec;
        status = find_target(model, spec->beam, spec->at, spec->at_point, spec->where,
                             &model_moment(model, i)->on, err);
    }
    return status;
}

/* Whether the force is the same in any state at any time, and so part of model->dead. */
static int is_constant(const struct hobe_force *force)
{
    return !force->follower && !force->function && !force->history;
}

enum hobe_status load_build(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = load_find(model, err);
    for (size_t i = 0; !status && i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        struct station s;
        if (!is_constant(&force->spec))
            continue;
        station_find(model, &force->on, load_point(force), NULL, &s);
        station_add_force(model, &s, 0, force->spec.value, 1, model->dead);
    }
    if (!status)
        status = load_build_weights(model, err);
    return status ? status : spin_build(model, err);
}

/* Those at places: forces that are not constant, and moments. */
static void subtract_placed(const struct hobe_model *model, const double *u,
                            const struct instant *instant, double factor, double *r,
                            const struct matrix *K)
{
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        if (!is_constant(&force->spec))
            load_subtract_force(model, force, u, instant, factor, r, K);
    }
    for (size_t i = 0; i < model->moments.count; i++)
        load_subtract_moment(model, model_moment(model, i), u, instant, factor, r, K);
}

void load_subtract(const struct hobe_model *model, const double *u, const struct instant *instant,
                   double factor, double *r, const struct matrix *K)
{
    const hobe_model *whole = model_whole(model);
    double g[3];
    if (factor == 0) /* functions that fail would make it NaN */
        return;
    for (long i = 0; i < 3 * model->vectors; i++)
        r[i] -= factor * model->dead[i];
    load_changing_gravity(whole, instant, g);
    if (whole->gravities.count > 0)
        load_add_weights(model, g, -factor, r);
    if (whole->forces.count + whole->moments.count > 0)
        reduction_act(model, subtract_placed, u, instant, factor, r, K);
    spin_subtract(model, u, instant, factor, r, K);
}

void load_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double factor, const struct beam *beam, int e, double *f)
{
    double g[3];
    load_changing_gravity(model, instant, g);
    for (int a = 0; a < 3; a++)
        g[a] += model->gravity[a];
    load_add_weight(model, beam, e, g, factor, f);
    for (size_t i = 0; i < model->masses.count; i++) {
        const struct point_mass *mass = model_mass(model, i);
        if (place_inside(mass->place, beam, e))
            point_mass_force(model, mass, factor, g, f);
    }
    spin_inside(model, u, instant, factor, beam, e, f);
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        if (place_inside(force->on.place, beam, e))
            load_subtract_force(model, force, u, instant, -factor, f, NULL);
    }
    for (size_t i = 0; i < model->moments.count; i++) {
        const struct moment *moment = model_moment(model, i);
        if (place_inside(moment->on.place, beam, e))
            load_subtract_moment(model, moment, u, instant, -factor, f, NULL);
    }
}

/* ---- what others ask of loads ---------------------------------------------------------------- */

enum hobe_status load_at(const struct hobe_model *model, const char *beam, double at,
                         const double F[3], const char *where, double *r, struct hobe_error *err)
{
    const hobe_model *whole = model_whole(model);
    const struct beam *on = model_find_beam(whole, beam, where, err);
    struct station s;
    if (!on)
        return HOBE_UNKNOWN;
    station_on_beam(whole, model_place(on, at), NULL, &s);
    if (whole == model) {
        station_add_force(model, &s, 0, F, 1, r);
        return HOBE_OK;
    }
    double *field = hobe_alloc((size_t)(3 * whole->vectors), sizeof *field, err);
    if (!field)
        return HOBE_NO_MEMORY;
    station_add_force(whole, &s, 0, F, 1, field);
    reduction_project(model, 1, field, r);
    hobe_free(field);
    return HOBE_OK;
}

const struct hobe_force *load_follower(const struct hobe_model *model)
{
    model = model_whole(model);
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct hobe_force *force = &model_force(model, i)->spec;
        if (force->follower || force->function)
            return force;
    }
    return NULL;
}

void load_touch(const struct hobe_model *model, int changing, unsigned char *touched)
{
    struct station s;
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        const struct hobe_force *spec = &force->spec;
        if (changing && is_constant(spec))
            continue;
        station_find(model, &force->on, load_point(force), NULL, &s);
        station_touch(model, &s, 0, spec->follower || spec->function ? 2 : 0, touched);
    }
    for (size_t i = 0; i < model->moments.count; i++) {
        station_find(model, &model_moment(model, i)->on, NULL, NULL, &s);
        station_touch(model, &s, 1, 2, touched);
    }
}
