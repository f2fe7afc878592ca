/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of a relief, a state and a mode in which the n-th allocation fails, for n = 1, 2, ...
 * until one gets through: each time it ends with "out of memory", and leaks nothing (the sanitizer
 * looks). */
#include "check.h"
#include "fault.h"
#include "picture.h"
#include "scene.h"

struct scene {
    hobe_section *section;
    hobe_solution *solution;
    hobe_modes *modes;
    int kind; /* of surface */
};

static enum hobe_status surface_of(const struct scene *scene, struct hobe_surface *surface,
                                   struct hobe_error *err)
{
    const struct hobe_field *field =
        hobe_find_field(scene->kind == 1 ? "mises" : "u", scene->kind != 1, err);
    switch (scene->kind) {
    case 0:
        return hobe_section_field(scene->section, "w", 4, 0.01, surface, err);
    case 1:
        return hobe_solution_surface(scene->solution, field, surface, err);
    default:
        return hobe_modes_surface(scene->modes, 0, field, surface, err);
    }
}

static enum hobe_status draw(void *context, struct hobe_error *err)
{
    struct hobe_surface surface;
    struct hobe_text png = {0};
    enum hobe_status status = surface_of(context, &surface, err);
    const struct hobe_panel panel = {.surface = &surface, .scale = 1, .reference = 1, .label = "a"};
    const struct hobe_picture picture = {
        .title = "t", .field = "u", .width = 300, .axes = "xyz", .panels = 1, .panel = &panel};
    if (status)
        return status;
    status = hobe_picture_png(&picture, &png, err);
    check_that(status || png.size > 0, "a picture of %zu bytes", png.size);
    hobe_surface_free(&surface);
    hobe_text_free(&png);
    return status;
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
    static const char *const what[] = {"relief", "state", "mode"};
    for (; scene.kind < 3; scene.kind++)
        fail_each_allocation(draw, &scene, 10, 200, what[scene.kind]);
    hobe_modes_free(scene.modes);
    hobe_solution_free(scene.solution);
    hobe_model_free(model);
    hobe_section_free(scene.section);
    return check_report();
}
