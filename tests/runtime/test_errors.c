/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every refusal of the core: status, the tag of the item at fault, and one sentence that names the
 * offending value. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const TAG = "the item at fault";

/* One sentence, with the words that must be in it; the tag where the caller gave one. */
static void refused(enum hobe_status got, enum hobe_status expected, const struct hobe_error *err,
                    const char *where, const char *words)
{
    const size_t length = strlen(err->message);
    check_that(got == expected && err->status == expected, "%s: status \"%s\", expected \"%s\": %s",
               words, hobe_status_words(got), hobe_status_words(expected), err->message);
    check_that(err->where == where, "%s: the tag is handed back", words);
    check_that(strstr(err->message, words) != NULL, "\"%s\" is named in: %s", words, err->message);
    check_that(length > 10 && !strchr(err->message, '\n') && err->message[length - 1] != '.',
               "one sentence without its full stop: %s", err->message);
}

/* A tag in every error, to see that a call sets it. */
static struct hobe_error fresh(void)
{
    return (struct hobe_error){.where = "not set"};
}

static hobe_section *section;

static struct hobe_beam good_beam(void)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, 70e9, 0.3, 1);
    beam.where = TAG;
    return beam;
}

/* ---- beams
 * --------------------------------------------------------------------------------------- */

static void bad_beam(const struct hobe_beam *beam, const char *words)
{
    hobe_model *model = new_model();
    struct hobe_error err = fresh();
    const enum hobe_status status = hobe_model_beam(model, beam, &err);
    refused(status, HOBE_BAD_INPUT, &err, TAG, words);
    check_that(hobe_model_beam(model, beam, NULL) != HOBE_OK, "%s: without an error to write to",
               words);
    hobe_model_free(model);
}

static void bad_kernels(void)
{
    struct hobe_error err = fresh();
    const struct hobe_kernel *kernel = hobe_find_kernel("MGD31", &err);
    refused(kernel ? HOBE_OK : err.status, HOBE_UNKNOWN, &err, NULL, "MGD31");
    for (int i = 0; hobe_kernels()[i]; i++)
        check_that(strstr(err.message, hobe_kernels()[i]->name) != NULL, "%s is listed: %s",
                   hobe_kernels()[i]->name, err.message);
    check_that(hobe_find_kernel("", NULL) == NULL, "no element has an empty name");
}

static void bad_elements(void)
{
    static const int counts[] = {0, -1, 1000001};
    static const char *const words[] = {"got 0", "got -1", "got 1000001"};
    for (int i = 0; i < 3; i++) {
        struct hobe_beam beam = good_beam();
        beam.elements = counts[i];
        bad_beam(&beam, words[i]);
    }
}

/* A number of the material outside its range. */
static void bad_material(size_t offset, double value, const char *words)
{
    struct hobe_beam beam = good_beam();
    memcpy((char *)&beam.material + offset, &value, sizeof value);
    bad_beam(&beam, words);
}

static void bad_materials(void)
{
    bad_material(offsetof(struct hobe_material, E), 0, "E must be > 0 (Pa), got 0");
    bad_material(offsetof(struct hobe_material, E), -2e11, "got -2e+11");
    bad_material(offsetof(struct hobe_material, E), NAN, "got nan");
    bad_material(offsetof(struct hobe_material, E), INFINITY, "got inf");
    bad_material(offsetof(struct hobe_material, nu), 0.5, "got 0.5");
    bad_material(offsetof(struct hobe_material, nu), -1, "got -1");
    bad_material(offsetof(struct hobe_material, nu), 3, "got 3");
    bad_material(offsetof(struct hobe_material, nu), NAN, "got nan");
    bad_material(offsetof(struct hobe_material, rho), -7, "got -7");
    bad_material(offsetof(struct hobe_material, rho), NAN, "got nan");
    bad_material(offsetof(struct hobe_material, k2), 0, "got 0 and 1");
    bad_material(offsetof(struct hobe_material, k2), NAN, "got nan and 1");
    bad_material(offsetof(struct hobe_material, k3), -0.5, "got 1 and -0.5");
    bad_material(offsetof(struct hobe_material, k3), NAN, "got 1 and nan");
}

static void bad_places(void)
{
    struct hobe_beam beam;
    for (int a = 0; a < 9; a++) {
        beam = good_beam();
        (a < 3 ? beam.from : a < 6 ? beam.to : beam.up)[a % 3] = a % 2 ? NAN : -INFINITY;
        bad_beam(&beam, "beam \"beam\" must be finite");
    }
    beam = good_beam();
    memcpy(beam.to, beam.from, sizeof beam.to);
    bad_beam(&beam, "\"beam\" has no length");
    beam = good_beam();
    beam.up[0] = -3;
    bad_beam(&beam, "up = {-3, 0, 0} points along the beam \"beam\"");
    beam = good_beam();
    beam.from[0] = -1e308;
    beam.to[0] = 1e308;
    bad_beam(&beam, "beam \"beam\""); /* longer than any number */
}

static void bad_law(void)
{
    hobe_model *model = new_model();
    struct hobe_error err = fresh();
    struct hobe_beam beam = beam_along_x("B4", 1, section, 70e9, 0.3, 0.02);
    beam.where = TAG;
    beam.mechanics = HOBE_MECHANICS_AXIS;
    refused(hobe_model_beam(model, &beam, &err), HOBE_UNSTABLE, &err, TAG,
            "1 negative eigenvalue beside 6 zero");
    hobe_model_free(model);
}

static void same_name(void)
{
    struct hobe_beam beam = good_beam();
    hobe_model *model = cantilever(&beam, 0);
    struct hobe_error err = fresh();
    refused(hobe_model_beam(model, &beam, &err), HOBE_BAD_INPUT, &err, TAG,
            "two beams named \"beam\"");
    hobe_model_free(model);
}

/* What was refused leaves no trace: the model goes on with a better beam of the same name. */
static void refused_beam_is_gone(void)
{
    hobe_model *model = new_model();
    struct hobe_error err = fresh();
    struct hobe_model_info info;
    struct hobe_beam beam = good_beam();
    beam.material.nu = 0.5;
    check_that(hobe_model_beam(model, &beam, &err) == HOBE_BAD_INPUT, "nu = 0.5 is refused");
    hobe_model_info(model, &info);
    check_that(info.beams == 0 && !hobe_model_beam_name(model, 0), "a refused beam is gone");
    beam = good_beam();
    check_that(hobe_model_beam(model, &beam, &err) == HOBE_OK, "a better beam of the same name: %s",
               err.message);
    hobe_model_free(model);
}

/* ---- loads and supports
 * -------------------------------------------------------------------------- */

/* A place outside the beam, in each item that has one. */
static void bad_at(double at, const char *words)
{
    const struct hobe_beam beam = good_beam();
    hobe_model *model = cantilever(&beam, 0);
    struct hobe_error err = fresh();
    const struct hobe_clamp clamp = {TAG, "beam", NULL, at, 0};
    refused(hobe_model_clamp(model, &clamp, &err), HOBE_BAD_INPUT, &err, TAG, words);
    err = fresh();
    const struct hobe_force force = {.where = TAG, .beam = "beam", .at = at, .value = {1, 2, 3}};
    refused(hobe_model_force(model, &force, &err), HOBE_BAD_INPUT, &err, TAG, words);
    err = fresh();
    const struct hobe_moment moment = {.where = TAG, .beam = "beam", .at = at, .value = {1, 2, 3}};
    refused(hobe_model_moment(model, &moment, &err), HOBE_BAD_INPUT, &err, TAG, words);
    hobe_model_free(model);
}

static void not_finite(void)
{
    const struct hobe_beam beam = good_beam();
    hobe_model *model = cantilever(&beam, 0);
    for (int a = 0; a < 3; a++) {
        double v[3] = {0};
        v[a] = a ? NAN : INFINITY;
        struct hobe_error err = fresh();
        const struct hobe_force force = {
            .where = TAG, .beam = "beam", .at = 1, .value = {v[0], v[1], v[2]}, .follower = a % 2};
        refused(hobe_model_force(model, &force, &err), HOBE_BAD_INPUT, &err, TAG,
                "force must be finite");
        err = fresh();
        const struct hobe_moment moment = {
            .where = TAG, .beam = "beam", .at = 1, .value = {v[0], v[1], v[2]}};
        refused(hobe_model_moment(model, &moment, &err), HOBE_BAD_INPUT, &err, TAG,
                "moment must be finite");
        err = fresh();
        refused(hobe_model_gravity(model, TAG, v, &err), HOBE_BAD_INPUT, &err, TAG,
                "gravity must be finite");
    }
    hobe_model_free(model);
}

/* ---- what only the whole scene shows
 * ------------------------------------------------------------- */

/* Builds, and is refused; again, and is refused again. */
static void bad_scene(hobe_model *model, enum hobe_status expected, const char *words)
{
    struct hobe_error err = fresh();
    hobe_solution *solution;
    refused(hobe_model_build(model, &err), expected, &err, TAG, words);
    check_that(hobe_model_build(model, &err) == expected, "%s: a second time", words);
    check_that(hobe_static(model, &(struct hobe_newton){0}, &solution, &err) == expected &&
                   !solution,
               "%s: nor is it solved", words);
    hobe_model_free(model);
}

/* A scene that may move in time, and has no equilibrium to be found, nor modes about one. */
static void loose_scene(hobe_model *model, const char *words)
{
    struct hobe_error err = fresh();
    hobe_solution *solution;
    hobe_modes *modes;
    check_that(hobe_model_build(model, &err) == HOBE_OK, "%s: it is built", words);
    for (int i = 0; i < 2; i++, err = fresh())
        refused(hobe_static(model, &(struct hobe_newton){0}, &solution, &err), HOBE_UNCONSTRAINED,
                &err, TAG, words);
    refused(hobe_modal(model, NULL, &(struct hobe_modal_options){0}, &modes, &err),
            HOBE_UNCONSTRAINED, &err, TAG, words);
    hobe_model_free(model);
}

static hobe_model *good_scene(void)
{
    const struct hobe_beam beam = good_beam();
    return cantilever(&beam, 0);
}

static void unknown_beams(void)
{
    struct hobe_error err;
    hobe_model *model = good_scene();
    hobe_model_clamp(model, &(struct hobe_clamp){TAG, "baem", NULL, 0, 0}, &err);
    bad_scene(model, HOBE_UNKNOWN, "no beam \"baem\" in the scene; beams are: \"beam\"");
    model = good_scene();
    hobe_model_force(model,
                     &(struct hobe_force){.where = TAG, .beam = "tip", .at = 0, .value = {1, 0, 0}},
                     &err);
    bad_scene(model, HOBE_UNKNOWN, "no beam \"tip\"");
    model = good_scene();
    hobe_model_force(model,
                     &(struct hobe_force){
                         .where = TAG, .beam = "top", .at = 0, .value = {1, 0, 0}, .follower = 1},
                     &err);
    bad_scene(model, HOBE_UNKNOWN, "no beam \"top\"");
    model = good_scene();
    hobe_model_moment(
        model, &(struct hobe_moment){.where = TAG, .beam = "", .at = 0, .value = {1, 0, 0}}, &err);
    bad_scene(model, HOBE_UNKNOWN, "no beam \"\"");
    for (int i = 0; i < 2; i++) {
        model = good_scene();
        const struct hobe_join join = {TAG, {i ? "beam" : "arm", i ? "arm" : "beam"}, {0, 1}};
        hobe_model_join(model, &join, &err);
        bad_scene(model, HOBE_UNKNOWN, "no beam \"arm\"");
    }
}

/* A second beam "arm" from there on, free. */
static hobe_model *two_beams(double x, double y, double z)
{
    struct hobe_beam arm = good_beam();
    hobe_model *model = good_scene();
    arm.name = "arm";
    arm.from[0] = x;
    arm.from[1] = y;
    arm.from[2] = z;
    arm.to[0] = x + 1;
    arm.to[1] = y;
    arm.to[2] = z;
    add_beam(model, &arm);
    return model;
}

static void bad_join(hobe_model *model, const char *first, double at, const char *second,
                     double second_at, const char *words)
{
    struct hobe_error err;
    const struct hobe_join join = {TAG, {first, second}, {at, second_at}};
    if (hobe_model_join(model, &join, &err))
        check_stop("%s", err.message);
    bad_scene(model, HOBE_BAD_INPUT, words);
}

static void bad_joins(void)
{
    bad_join(two_beams(1, 1e-3, 0), "beam", 1, "arm", 0, "\"beam\" and \"arm\" are 0.001 m apart");
    bad_join(two_beams(1, 0, 0), "beam", 0, "arm", 0, "are 1 m apart");
    bad_join(two_beams(1, 0, 0), "beam", 0.5, "arm", 0, "at must be 0 or 1, got 0.5");
    bad_join(two_beams(1, 0, 0), "beam", 1, "arm", NAN, "got nan");
    bad_join(two_beams(1, 0, 0), "beam", 1, "beam", 0, "\"beam\" is joined to itself");
}

static void bad_supports(void)
{
    struct hobe_error err;
    hobe_model *model = new_model();
    struct hobe_beam beam = good_beam();
    add_beam(model, &beam);
    loose_scene(model, "beam \"beam\" is free to move: translations along x, y, z and rotations");
    loose_scene(two_beams(1, 0, 0), "beam \"arm\" is free to move");
    model = good_scene();
    hobe_model_clamp(model, &(struct hobe_clamp){TAG, "beam", NULL, 0.3, 0}, &err);
    bad_scene(model, HOBE_BAD_INPUT, "none of their nodes with a position at 0.3");
    model = good_scene(); /* the middle node of MGD30w has slopes, no position */
    hobe_model_clamp(model, &(struct hobe_clamp){TAG, "beam", NULL, 0.25, 0}, &err);
    bad_scene(model, HOBE_BAD_INPUT, "a clamp must sit on a node: beam \"beam\" has 2 elements");
    beam.kernel = hobe_find_kernel("BE24", &err);
    beam.elements = 1;
    model = cantilever(&beam, 0);
    add_clamp(model, "beam", 1, 0);
    bad_scene(model, HOBE_BAD_INPUT, "every node is clamped");
}

static void no_beam(void)
{
    hobe_model *model = new_model();
    struct hobe_error err = fresh();
    refused(hobe_model_build(model, &err), HOBE_BAD_INPUT, &err, NULL, "the scene has no beam");
    hobe_model_free(model);
}

static void weightless(void)
{
    struct hobe_error err;
    hobe_model *model = good_scene();
    if (hobe_model_gravity(model, TAG, (const double[3]){0, 0, -9.81}, &err))
        check_stop("%s", err.message);
    bad_scene(model, HOBE_BAD_INPUT, "material.rho of beam \"beam\" is 0");
}

/* ---- results and elements
 * ------------------------------------------------------------------------ */

static void bad_points(void)
{
    static const double at[] = {-0.1, 1.5, NAN};
    static const char *const words[] = {"got -0.1", "got 1.5", "got nan"};
    hobe_model *model = good_scene();
    add_force(model, "beam", 1, 0, 0, -1);
    hobe_solution *solution = solve(model, 1);
    struct hobe_error err;
    struct hobe_point p;
    for (int i = 0; i < 3; i++) {
        err = fresh();
        refused(hobe_solution_point(solution, "beam", at[i], 0, 0, &p, &err), HOBE_BAD_INPUT, &err,
                NULL, words[i]);
    }
    err = fresh();
    refused(hobe_solution_point(solution, "blade", 1, 0, 0, &p, &err), HOBE_UNKNOWN, &err, NULL,
            "no beam \"blade\" in the scene; beams are: \"beam\"");
    hobe_solution_free(solution);
    hobe_model_free(model);
}

static void bad_lengths(void)
{
    static const double length[] = {0, -1, NAN, INFINITY};
    static const char *const words[] = {"got 0", "got -1", "got nan", "got inf"};
    for (int i = 0; i < 4; i++) {
        struct hobe_error err = fresh();
        const struct hobe_beam beam = good_beam();
        const struct hobe_element_options options = {.kernel = beam.kernel,
                                                     .section = section,
                                                     .material = beam.material,
                                                     .length = length[i]};
        hobe_element *element = hobe_element_new(&options, &err);
        refused(element ? HOBE_OK : err.status, HOBE_BAD_INPUT, &err, NULL, words[i]);
        hobe_element_free(element);
    }
}

/* Many beams, so that the list of the known is long: it ends within its sentence. */
static void long_lists(void)
{
    hobe_model *model = new_model();
    struct hobe_beam beam = beam_along_x("BE24", 1, section, 70e9, 0.3, 1);
    char name[60];
    struct hobe_error err = fresh();
    beam.name = name;
    for (int i = 0; i < 60; i++) {
        snprintf(name, sizeof name, "a beam with a long name, number %d", i);
        add_beam(model, &beam);
    }
    hobe_model_clamp(model, &(struct hobe_clamp){TAG, "none", NULL, 0, 0}, &err);
    bad_scene(model, HOBE_UNKNOWN, "no beam \"none\"");
}

/* What is added to a model that is built, or could not be, would not count. */
static void too_late(int fails)
{
    const struct hobe_beam beam = beam_along_x("BE24", 1, section, 70e9, 0.3, 1);
    struct hobe_beam other = beam;
    hobe_model *model = cantilever(&beam, 0);
    struct hobe_error err[6];
    for (int i = 0; i < 6; i++)
        err[i] = fresh();
    if (fails)
        add_force(model, "beem", 1, 0, 0, 1);
    check_that(!hobe_model_build(model, err) == !fails, "the build: %s", err->message);
    other.name = "other";
    other.where = TAG;
    const enum hobe_status status[6] = {
        hobe_model_beam(model, &other, err),
        hobe_model_clamp(model, &(struct hobe_clamp){TAG, "beam", NULL, 0, 0}, err + 1),
        hobe_model_force(model,
                         &(struct hobe_force){.where = TAG, .beam = "beam", .at = 0, .value = {0}},
                         err + 2),
        hobe_model_moment(
            model, &(struct hobe_moment){.where = TAG, .beam = "beam", .at = 0, .value = {0}},
            err + 3),
        hobe_model_join(model, &(struct hobe_join){TAG, {"beam", "other"}, {1, 0}}, err + 4),
        hobe_model_gravity(model, TAG, (const double[3]){0, 0, -9.81}, err + 5),
    };
    for (int i = 0; i < 6; i++)
        refused(status[i], HOBE_BAD_INPUT, err + i, TAG, "built already");
    hobe_model_free(model);
}

static void words_of_statuses(void)
{
    for (int s = 0; s < HOBE_STATUSES; s++)
        check_that(strlen(hobe_status_words((enum hobe_status)s)) > 5, "status %d has words", s);
    check_that(strlen(hobe_status_words(HOBE_STATUSES)) > 5, "an unknown status has words");
}

int main(void)
{
    section = rectangle(0.1, 0.2);
    bad_kernels();
    bad_elements();
    bad_materials();
    bad_places();
    bad_law();
    same_name();
    refused_beam_is_gone();
    bad_at(-0.01, "got -0.01");
    bad_at(1.0001, "got 1.0001");
    bad_at(NAN, "got nan");
    not_finite();
    unknown_beams();
    bad_joins();
    bad_supports();
    no_beam();
    weightless();
    bad_points();
    bad_lengths();
    long_lists();
    too_late(0);
    too_late(1);
    words_of_statuses();
    hobe_section_free(section);
    return check_report();
}
