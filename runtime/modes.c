/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "modes.h"

#include "body.h"
#include "reduction.h"

#include "solution.h"

#include <string.h>

void modes_spread(const struct pencil *s, const double *x, double *field)
{
    const hobe_model *model = s->model;
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3; a++) {
            const long k = 3 * model->unknown[v] + a;
            field[3 * v + a] = model->unknown[v] < 0 ? 0 : s->scale[k] * x[k];
        }
}

void modes_expand(const struct pencil *s, const double *x, double *field)
{
    modes_spread(s, x, s->model->reduction ? s->r : field);
    if (s->model->reduction)
        reduction_expand(s->model, s->r, 0, field);
}

hobe_modes *modes_new(const struct pencil *s, int count, enum hobe_modal_method method,
                      struct hobe_error *err)
{
    const hobe_model *model = model_whole(s->model);
    const size_t size = (size_t)(3 * model->vectors);
    hobe_modes *modes = hobe_alloc(1, sizeof *modes, err);
    if (!modes)
        return NULL;
    modes->model = model;
    modes->info = (struct hobe_modes_info){
        .count = count, .buckling = s->buckling, .unknowns = s->n, .method = method};
    modes->mu = hobe_alloc((size_t)count, sizeof *modes->mu, err);
    modes->shape = hobe_alloc((size_t)count * size, sizeof *modes->shape, err);
    if (modes->mu && modes->shape)
        return modes;
    hobe_modes_free(modes);
    return NULL;
}

hobe_modes *modes_take(struct pencil *s, int count, enum hobe_modal_method method,
                       struct hobe_error *err)
{
    hobe_modes *modes = modes_new(s, count, method, err);
    if (!modes)
        return NULL;
    pencil_orthonormalize(s, count);
    memcpy(modes->mu, s->mu, (size_t)count * sizeof *modes->mu);
    for (int i = 0; i < count; i++)
        modes_expand(s, s->X + i * s->n, modes->shape + 3 * i * modes->model->vectors);
    return modes;
}

enum hobe_status modes_find(struct pencil *s, const struct hobe_modal_options *options,
                            modes_solver *solve, hobe_modes **modes, struct hobe_error *err)
{
    struct hobe_modal_options o = *options;
    *modes = NULL;
    enum hobe_status status = hobe_model_build(s->model, err);
    if (!status)
        status = model_check_held(s->model, err);
    if (status)
        return status;
    const double started = hobe_seconds();
    status = solve(s, &o, modes, err);
    pencil_close(s);
    if (!status) {
        (*modes)->info.seconds = hobe_seconds() - started;
        return HOBE_OK;
    }
    hobe_modes_free(*modes);
    *modes = NULL;
    return status;
}

void hobe_modes_free(hobe_modes *modes)
{
    if (!modes)
        return;
    hobe_free(modes->mu);
    hobe_free(modes->shape);
    hobe_free(modes->quadrature);
    hobe_free(modes->exponent);
    hobe_free(modes);
}

const hobe_model *modes_model(const hobe_modes *modes)
{
    return modes->model;
}

void hobe_modes_info(const hobe_modes *modes, struct hobe_modes_info *info)
{
    *info = modes->info;
}

const char *hobe_modes_note(const hobe_modes *modes)
{
    return modes->note[0] ? modes->note : NULL;
}

const double *modes_shape(const hobe_modes *modes, int i, struct hobe_error *err)
{
    if (i >= 0 && i < modes->info.count)
        return modes->shape + 3 * i * modes->model->vectors;
    hobe_fail(err, HOBE_BAD_INPUT, NULL, "there is no mode %d among %d", i, modes->info.count);
    return NULL;
}

enum hobe_status hobe_modes_quadrature(const hobe_modes *modes, int i, const char *beam, double at,
                                       double y, double z, double u[3], struct hobe_error *err)
{
    const double *shape = modes_shape(modes, i, err);
    if (!shape)
        return HOBE_BAD_INPUT;
    if (modes->quadrature)
        shape = modes->quadrature + (shape - modes->shape);
    const enum hobe_status status =
        solution_displacement(modes->model, shape, beam, at, y, z, NULL, u, err);
    for (int a = 0; a < 3 && !modes->quadrature; a++)
        u[a] = 0;
    return status;
}

enum hobe_status modes_displacement(const hobe_modes *modes, int i, const char *beam, double at,
                                    double y, double z, double r0[3], double u[3],
                                    struct hobe_error *err)
{
    const double *shape = modes_shape(modes, i, err);
    if (!shape)
        return HOBE_BAD_INPUT;
    return solution_displacement(modes->model, shape, beam, at, y, z, r0, u, err);
}

enum hobe_status hobe_modes_point(const hobe_modes *modes, int i, const char *beam, double at,
                                  double y, double z, double u[3], struct hobe_error *err)
{
    return modes_displacement(modes, i, beam, at, y, z, NULL, u, err);
}

enum hobe_status hobe_modes_body(const hobe_modes *modes, int i, const char *name,
                                 const double point[3], double u[3], double quadrature[3],
                                 struct hobe_error *err)
{
    double r0[3];
    const double *shape = modes_shape(modes, i, err);
    const struct body *body = shape ? solution_find_body(modes->model, name, err) : NULL;
    if (!body)
        return shape ? HOBE_UNKNOWN : HOBE_BAD_INPUT;
    body_displacement(body, shape, point, r0, u);
    for (int a = 0; a < 3; a++)
        quadrature[a] = 0;
    if (modes->quadrature)
        body_displacement(body, modes->quadrature + (shape - modes->shape), point, r0, quadrature);
    return HOBE_OK;
}
