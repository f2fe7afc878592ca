/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of a relief, a state, a mode and a slice, and a file of a solid, in which the n-th
 * allocation fails, for n = 1, 2, ... until one gets through: each time it ends with "out of
 * memory", and leaks nothing (the sanitizer looks). */
#include "check.h"
#include "output_vtk.h"
#include "picture.h"
#include "scene.h"

#include <stdio.h>

enum { KINDS = 5 };

struct scene {
    hobe_section *section;
    hobe_solution *solution;
    hobe_modes *modes;
};

static enum hobe_status draw(const struct scene *scene, int kind, struct hobe_text *png,
                             struct hobe_error *err)
{
    struct hobe_surface surface;
    const struct hobe_field *field = hobe_find_field(kind % 2 ? "mises" : "u", kind % 2 == 0, err);
    enum hobe_status status =
        kind == 0   ? hobe_section_field(scene->section, "w", 4, 0.01, &surface, err)
        : kind == 1 ? hobe_solution_surface(scene->solution, field, &surface, err)
        : kind == 2 ? hobe_modes_surface(scene->modes, 0, field, &surface, err)
                    : hobe_solution_slice(scene->solution, "beam", 1, field, &surface, err);
    const struct hobe_panel panel = {.surface = &surface, .scale = 1, .reference = 1, .label = "a"};
    const struct hobe_picture picture = {
        .title = "t", .field = "u", .width = 300, .axes = "xyz", .panels = 1, .panel = &panel};
    if (status)
        return status;
    status = hobe_picture_png(&picture, png, err);
    hobe_surface_free(&surface);
    return status;
}

static enum hobe_status write_solid(const struct scene *scene, struct hobe_text *text,
                                    struct hobe_error *err)
{
    struct hobe_solid solid;
    const enum hobe_status status = hobe_solution_solid(scene->solution, &solid, err);
    if (status)
        return status;
    hobe_vtk_solid(&solid, text);
    hobe_solid_free(&solid);
    return hobe_text_check(text, err);
}

static void fail_each(const struct scene *scene, int kind)
{
    long n = 0, seen;
    do {
        struct hobe_error err = {0};
        struct hobe_text png = {0};
        hobe_fail_allocation(++n);
        const enum hobe_status status =
            kind == KINDS - 1 ? write_solid(scene, &png, &err) : draw(scene, kind, &png, &err);
        seen = hobe_fail_allocation(0);
        if (seen >= n)
            check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY,
                       "kind %d, allocation %ld of %ld: status %d, %s", kind, n, seen, status,
                       err.message);
        else
            check_that(status == HOBE_OK && png.size > 0, "nothing failed: %s", err.message);
        hobe_text_free(&png);
    } while (seen >= n && n < 200);
    printf("kind %d: %ld allocations\n", kind, n - 1);
}

int main(void)
{
    struct hobe_error err;
    struct scene scene = {.section = rectangle(0.05, 0.1)};
    struct hobe_beam beam = beam_along_x("BE24w", 1, scene.section, 70e9, 0.3, 1);
    beam.material.rho = 2700;
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, 1);
    scene.solution = solve(model, 1);
    if (hobe_modal(model, NULL, &(struct hobe_modal_options){.modes = 1}, &scene.modes, &err))
        check_stop("%s", err.message);
    for (int kind = 0; kind < KINDS; kind++)
        fail_each(&scene, kind);
    hobe_modes_free(scene.modes);
    hobe_solution_free(scene.solution);
    hobe_model_free(model);
    hobe_section_free(scene.section);
    return check_report();
}
