/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Smaller problems where they are exact, beside the whole one: elements whose section drops modes.
 */
#include "check.h"
#include "kernel_vectors.h"
#include "scene.h"
#include "smaller.h"

#include <math.h>
#include <string.h>

enum { MOST = 3 * HOBE_MAX_VECTORS };

/* Sums in another order. */
static const double EXACT = 1e-11;

static hobe_section *made(hobe_section *section, const struct hobe_error *err)
{
    if (!section)
        check_stop("%s", err->message);
    return section;
}

enum shape { RECTANGLE, CIRCLE, TUBE, SQUARE_BOX, CONE };

static hobe_section *section_of(enum shape shape)
{
    struct hobe_error err;
    if (shape == CONE)
        return tapered(section_of(TUBE), made(hobe_section_tube(0.05, 0.04, &err), &err));
    return made(shape == RECTANGLE ? hobe_section_rectangle(0.1, 0.2, HOBE_WARPING_SERIES, &err)
                : shape == CIRCLE  ? hobe_section_circle(0.1, &err)
                : shape == TUBE    ? hobe_section_tube(0.1, 0.08, &err)
                                   : hobe_section_hollow(.1, .1, .01, HOBE_WARPING_SOLVED, &err),
                &err);
}

/* What is left of an element on a section; NULL: all of it. */
static const struct {
    const char *element;
    enum shape shape;
    enum hobe_integration integration;
    const char *left;
} LEFT[] = {
    {"MGD30w", CIRCLE, HOBE_INTEGRATION_EXACT, "MGD30"},
    {"MGD30w", TUBE, HOBE_INTEGRATION_EXACT, "MGD30"},
    {"MGD30w", CONE, HOBE_INTEGRATION_EXACT, "MGD30"},
    {"BE24w", TUBE, HOBE_INTEGRATION_EXACT, "BE24"},
    {"3433w", CIRCLE, HOBE_INTEGRATION_EXACT, "3433"},
    {"MGD30d", RECTANGLE, HOBE_INTEGRATION_EXACT, "MGD30w3"},
    {"MGD30w", RECTANGLE, HOBE_INTEGRATION_EXACT, NULL},
    {"MGD30w3", CIRCLE, HOBE_INTEGRATION_EXACT, NULL}, /* wy, wz stay */
    {"MGD30w", SQUARE_BOX, HOBE_INTEGRATION_EXACT, NULL},
    {"MGD30w", SQUARE_BOX, HOBE_INTEGRATION_PAPER, "MGD30"}, /* eq. 36 vanishes */
};

/* The places [vectors] of the small element's vectors in the rich one. */
static void find_vectors(const struct hobe_kernel *small, const struct hobe_kernel *rich, int *at)
{
    for (int v = 0; v < small->vectors; v++) {
        const struct hobe_vector *is = small->vector + v;
        int mode = 0;
        while (strcmp(rich->mode[mode], small->mode[is->mode]))
            mode++;
        at[v] = hobe_kernel_vector(rich, is->node, mode, is->slope);
    }
}

/* The largest difference between a[n][n] of the small element and b of the rich one, whose rows
 * are at[n / each] each * ..., relative to the largest. */
static double difference(int n, const double *a, int rows, const double *b, const int *at)
{
    double most = 0, largest = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const double x = b[(3 * at[i / 3] + i % 3) * rows + 3 * at[j / 3] + j % 3];
            most = fmax(most, fabs(a[i * n + j] - x));
            largest = fmax(largest, fabs(x));
        }
    return most / largest;
}

/* Force, tangent and mass of both in one state of the modes that are left. */
static void compare_elements(const struct hobe_element_options *options,
                             const struct hobe_kernel *small)
{
    static double q0[2][MOST], q[2][MOST], f[2][MOST], K[2][MOST * MOST];
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct hobe_error err;
    struct hobe_element_options less = *options;
    int at[HOBE_MAX_VECTORS];
    less.kernel = small;
    hobe_element *element[2] = {new_element(&less), new_element(options)};
    const int n = 3 * small->vectors, rows = 3 * options->kernel->vectors;
    find_vectors(small, options->kernel, at);
    for (int i = 0; i < 2; i++) {
        hobe_element_reference(element[i], identity, q0[i]);
        memcpy(q[i], q0[i], sizeof q[i]);
    }
    for (int k = 0; k < n; k++) {
        const double step = random_real(-0.1, 0.1);
        q[0][k] += step;
        q[1][3 * at[k / 3] + k % 3] += step;
    }
    for (int i = 0; i < 2; i++)
        check_that(!hobe_element_force(element[i], q0[i], q[i], f[i], &err) &&
                       !hobe_element_tangent(element[i], q0[i], q[i], K[i], &err),
                   "force and tangent");
    double most = 0, largest = 0;
    for (int k = 0; k < n; k++) {
        const double x = f[1][3 * at[k / 3] + k % 3];
        most = fmax(most, fabs(f[0][k] - x));
        largest = fmax(largest, fabs(x));
    }
    check_absolute(most / largest, 0, EXACT, "force of %s for %s", small->name,
                   options->kernel->name);
    check_absolute(difference(n, K[0], rows, K[1], at), 0, EXACT, "its tangent");
    for (int i = 0; i < 2; i++)
        hobe_element_mass(element[i], K[i]);
    check_absolute(difference(n, K[0], rows, K[1], at), 0, EXACT, "its mass");
    for (int i = 0; i < 2; i++)
        hobe_element_free(element[i]);
}

/* A cantilever of the element asked for, and one of what is left, are the same to the last digit.
 */
static void compare_beams(const struct hobe_beam *beam, const char *left)
{
    struct hobe_solution_info info[2];
    struct hobe_point tip[2];
    for (int i = 0; i < 2; i++) {
        struct hobe_beam one = *beam;
        struct hobe_error err;
        one.kernel = i ? hobe_find_kernel(left, &err) : beam->kernel;
        hobe_model *model = cantilever(&one, 0);
        add_force(model, "beam", 1, 1e5, 2e5, 3e5);
        hobe_solution *solution = solve(model, 1);
        info[i] = info_of(solution);
        tip[i] = point_of(solution, "beam", 1, 0.01, 0.02);
        int named = 0;
        for (int k = 0; hobe_model_note(model, k); k++)
            named |= strstr(hobe_model_note(model, k), "what is left of") != NULL;
        check_that(named == !i, "%s is named", left);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    check_that(info[0].iterations == info[1].iterations, "iterations");
    check_absolute(distance(tip[0].u, tip[1].u), 0, 0, "%s for %s", left, beam->kernel->name);
    check_absolute(info[0].energy, info[1].energy, 0, "energy");
}

static void dropped_modes(void)
{
    for (size_t i = 0; i < sizeof LEFT / sizeof *LEFT; i++) {
        struct hobe_error err;
        hobe_section *section = section_of(LEFT[i].shape);
        struct hobe_beam beam = beam_along_x(LEFT[i].element, 2, section, 2.1e11, 0.3, 1);
        beam.integration = LEFT[i].integration;
        beam.material.rho = 7800;
        const struct hobe_element_options options = {.kernel = beam.kernel,
                                                     .section = section,
                                                     .material = beam.material,
                                                     .length = 0.5,
                                                     .integration = beam.integration};
        hobe_element *element = new_element(&options);
        const struct hobe_kernel *left = kernel_left(&beam, 1, hobe_element_dropped(element), &err);
        check_that(left && !strcmp(left->name, LEFT[i].left ? LEFT[i].left : LEFT[i].element),
                   "%s leaves %s", LEFT[i].element, left ? left->name : err.message);
        hobe_element_free(element);
        if (left != beam.kernel) {
            compare_elements(&options, left);
            compare_beams(&beam, left->name);
        }
        hobe_section_free(section);
    }
}

/* Elements that differ in more than their modes are not within each other. */
static void others(void)
{
    static const struct {
        const char *small, *rich;
        int within;
    } pairs[] = {{"MGD30", "MGD30w", 1},    {"MGD30", "MGD30d2", 1}, {"MGD30w", "MGD30", 0},
                 {"MGD30", "MGD30", 0},     {"3333", "MGD30w", 0},   {"3333", "3333s", 0},
                 {"MGD30", "MGD30w-II", 0}, {"BE24", "BE42", 0},     {"3433", "34X3", 0}};
    struct hobe_error err;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        check_that(kernel_within(hobe_find_kernel(pairs[i].small, &err),
                                 hobe_find_kernel(pairs[i].rich, &err)) == pairs[i].within,
                   "%s within %s: %d", pairs[i].small, pairs[i].rich, pairs[i].within);
}

int main(void)
{
    random_start();
    others();
    dropped_modes();
    return check_report();
}
