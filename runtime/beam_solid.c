/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams as solids. */
#include "solid.h"

#include "section.h"
#include "solution.h"
#include "stress.h"
#include "surface.h"

#include <string.h>

enum {
    FINENESS = 3, /* of closed-form sections */
    LAYERS = 2    /* of wedges in an element */
};

/* What is sampled, and where to. */
struct sampling {
    const hobe_model *model;
    const hobe_solution *solution; /* NULL: a mode */
    const hobe_modes *modes;
    int mode, stressed;
    struct hobe_solid *solid;
};

void hobe_solid_free(struct hobe_solid *solid)
{
    hobe_free(solid->point);
    hobe_free(solid->displacement);
    hobe_free(solid->stress);
    hobe_free(solid->cell);
    *solid = (struct hobe_solid){0};
}

/* Items at *p with room for more. */
static enum hobe_status grow(void **p, int count, int more, size_t size, struct hobe_error *err)
{
    void *grown = hobe_grow(*p, (size_t)count, (size_t)(count + more), size, err);
    *p = grown ? grown : *p;
    return grown ? HOBE_OK : HOBE_NO_MEMORY;
}

static enum hobe_status make_room(const struct sampling *s, int points, int cells,
                                  struct hobe_error *err)
{
    struct hobe_solid *to = s->solid;
    enum hobe_status status = grow((void **)&to->point, to->points, points, sizeof *to->point, err);
    if (!status)
        status =
            grow((void **)&to->displacement, to->points, points, sizeof *to->displacement, err);
    if (!status && s->stressed)
        status = grow((void **)&to->stress, to->points, points, sizeof *to->stress, err);
    return status ? status : grow((void **)&to->cell, to->cells, cells, sizeof *to->cell, err);
}

/* The points of one section. */
static enum hobe_status add_section(const struct sampling *s, const struct beam *beam, double at,
                                    struct hobe_error *err)
{
    const hobe_section *section = beam->spec.section;
    struct hobe_solid *to = s->solid;
    struct hobe_surface face = {0};
    struct stress_section stress;
    enum hobe_status status = hobe_section_surface_at(section, at, FINENESS, &face, err);
    if (!status && s->stressed)
        status = stress_section(s->solution, beam->name, at, &stress, err);
    for (int i = 0; !status && i < face.points; i++) {
        const double y = face.point[i][1], z = face.point[i][2];
        const int p = to->points++;
        double *r0 = to->point[p], *u = to->displacement[p];
        status =
            s->solution
                ? solution_displacement(s->model, s->solution->u, beam->name, at, y, z, r0, u, err)
                : modes_displacement(s->modes, s->mode, beam->name, at, y, z, r0, u, err);
        if (!status && s->stressed)
            status =
                stress_at(&stress, y, z, hobe_section_region(section, y, z), to->stress + p, err);
    }
    hobe_surface_free(&face);
    return status;
}

/* The wedge over six points of a section, from point `first` of the solid on, that has `size`
 * points. */
static void add_wedge(struct hobe_solid *to, const int n[6], int first, int size)
{
    const int middle = first + size, last = middle + size;
    int *cell = to->cell[to->cells++];
    for (int i = 0; i < 3; i++) {
        cell[i] = first + n[i];
        cell[3 + i] = last + n[i];
        cell[6 + i] = first + n[3 + i];
        cell[9 + i] = last + n[3 + i];
        cell[12 + i] = middle + n[i];
        cell[15 + i] = middle + n[3 + i];
    }
}

/* Three points along a beam for each layer, the ends shared. */
static enum hobe_status add_beam(const struct sampling *s, const struct beam *beam,
                                 struct hobe_error *err)
{
    const int layers = LAYERS * beam->spec.elements, first = s->solid->points;
    struct hobe_surface face = {0};
    enum hobe_status status = hobe_section_surface_at(beam->spec.section, 0, FINENESS, &face, err);
    const int triangles = face.triangles / 4, size = face.points;
    if (!status)
        status = make_room(s, (2 * layers + 1) * size, layers * triangles, err);
    for (int k = 0; !status && k <= 2 * layers; k++)
        status = add_section(s, beam, (double)k / (2 * layers), err);
    for (int c = 0; !status && c < layers * triangles; c++) {
        int n[6];
        hobe_surface_quadratic(&face, c % triangles, n);
        add_wedge(s->solid, n, first + 2 * (c / triangles) * size, size);
    }
    hobe_surface_free(&face);
    return status;
}

static enum hobe_status sample(const struct sampling *s, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    *s->solid = (struct hobe_solid){0};
    for (size_t i = 0; !status && i < s->model->beams.count; i++)
        status = add_beam(s, model_beam(s->model, i), err);
    if (status)
        hobe_solid_free(s->solid);
    return status;
}

enum hobe_status hobe_solution_solid(const hobe_solution *solution, struct hobe_solid *solid,
                                     struct hobe_error *err)
{
    struct sampling s = {.model = solution->model, .solution = solution, .solid = solid};
    const enum hobe_status status =
        hobe_check_field(solution, hobe_find_field("mises", 0, NULL), err);
    s.stressed = !status;
    return status && status != HOBE_BAD_INPUT ? status : sample(&s, err);
}

enum hobe_status hobe_modes_solid(const hobe_modes *modes, int i, struct hobe_solid *solid,
                                  struct hobe_error *err)
{
    return sample(
        &(struct sampling){.model = modes_model(modes), .modes = modes, .mode = i, .solid = solid},
        err);
}
