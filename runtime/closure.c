/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "closure.h"

#include "mass.h"
#include "vector3.h"

#include <string.h>

enum { MOST_MAPS = 9 };

/* The maps, [count][3][3]: e_b e_a' in space, a function's three in a row; P and [n]x in a plane.
 */
static int list_maps(int closed, const double normal[3], double map[MOST_MAPS][3][3])
{
    memset(map, 0, sizeof(double[MOST_MAPS][3][3]));
    if (closed == 3) {
        for (int i = 0; i < MOST_MAPS; i++)
            map[i][i % 3][i / 3] = 1;
        return MOST_MAPS;
    }
    const double length = length3(normal);
    for (int c = 0; c < 3; c++) {
        const double e[3] = {c == 0, c == 1, c == 2};
        double turned[3];
        cross3(normal, e, turned);
        for (int a = 0; a < 3; a++) {
            map[0][a][c] = (a == c) - normal[a] * normal[c] / (length * length);
            map[1][a][c] = turned[a] / length;
        }
    }
    return 2;
}

/* Adds A u for each map; `image` is [vectors][3]. */
static enum hobe_status add_images(struct span *span, const double *u, int maps,
                                   const double map[MOST_MAPS][3][3], double *image,
                                   struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < maps; i++) {
        for (long v = 0; v < span->model->vectors; v++)
            for (int a = 0; a < 3; a++)
                image[3 * v + a] = dot3(map[i][a], u + 3 * v);
        status = span_add(span, image, err);
    }
    return status;
}

/* Whether some vector of the beams is held. */
static int is_held(const hobe_model *model)
{
    for (long v = 0; v < model->beam_vectors; v++)
        if (model->held[v])
            return 1;
    return 0;
}

enum hobe_status closure_add(struct span *span, long first, int closed, const double normal[3],
                             struct hobe_error *err)
{
    const hobe_model *model = span->model;
    const size_t size = (size_t)(3 * model->vectors);
    const long given = span->n;
    double map[MOST_MAPS][3][3];
    const int maps = list_maps(closed, normal, map);
    double *image = hobe_alloc(2 * size, sizeof *image, err);
    if (!image)
        return HOBE_NO_MEMORY;
    double *u = image + size;
    enum hobe_status status = HOBE_OK;
    for (long j = first; !status && j < given; j++) {
        memcpy(u, span->field + j * 3 * model->vectors, size * sizeof *u);
        status = add_images(span, u, maps, (const double(*)[3][3])map, image, err);
    }
    for (int a = 0; !status && a < 3 && !is_held(model); a++) {
        mass_translation(model, a, u);
        status = add_images(span, u, maps, (const double(*)[3][3])map, image, err);
    }
    if (!status && !is_held(model)) {
        model_reference(model, u);
        status = add_images(span, u, maps, (const double(*)[3][3])map, image, err);
    }
    hobe_free(image);
    if (status)
        return status;
    if (span->group > 1)
        span_drop(span, first, given);
    span_orthonormalise(span, first);
    return HOBE_OK;
}
