/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The estimate of what a mesh misses: exact where an element's curvature is even along it, near the
 * truth where elements lock on an arc, nothing where nothing is wrong; and its warning. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 1e9, SIDE = 0.1, RADIUS = 10;

static double mesh_error(const hobe_solution *solution)
{
    struct hobe_error err;
    double share;
    if (hobe_solution_mesh_error(solution, "beam", &share, &err))
        check_stop("%s", err.message);
    return share;
}

/* A cantilever under a force at its end: M goes straight, but is even along each of n elements
 * whose slopes are linear or whose axis is quadratic.  1/(4 n^2) of the work is missing; what shear
 * adds is a few (SIDE/L)^2 = 1e-6; the load is so small since a turn phi of slender elements locks,
 * too. */
static void even_curvature(hobe_section *section)
{
    static const char *const names[] = {"BE24", "3333"};
    for (int i = 0; i < 2; i++)
        for (int n = 1; n <= 4; n *= 2) {
            struct hobe_beam beam = beam_along_x(names[i], n, section, E, 0, 100);
            hobe_model *model = cantilever(&beam, 1);
            add_force(model, "beam", 1, 0, 0, 1e-6);
            hobe_solution *solution = solve(model, 1);
            check_absolute(mesh_error(solution), 0.25 / (n * n), 1e-5, "%d of %s", n, names[i]);
            hobe_solution_free(solution);
            hobe_model_free(model);
        }
}

/* A quarter of a circle in the plane X-Z. */
static enum hobe_status arc(void *context, double t, double *value, struct hobe_error *err)
{
    (void)context;
    (void)err;
    value[0] = RADIUS * sin(M_PI / 2 * t);
    value[1] = 0;
    value[2] = RADIUS * (1 - cos(M_PI / 2 * t));
    return HOBE_OK;
}

/* Pulled along X at its end it gives way by pi/4 P R^3/EI, to (SIDE/RADIUS)^2.  What n elements
 * miss of that is what the estimate says, within a fifth. */
static void locking(hobe_section *section)
{
    static const char *const names[] = {"BE24", "3333", "MGD30w", "3433", "3333s"};
    const double EI = E * pow(SIDE, 4) / 12, P = 1e-6 * EI / (RADIUS * RADIUS);
    hobe_curve *curve = curve_of(arc, NULL, NULL);
    for (int i = 0; i < 5; i++) {
        struct hobe_beam beam = beam_along_x(names[i], 6, section, E, 0, 1);
        struct hobe_error err;
        char text[600];
        beam.curve = curve;
        beam.up[1] = 1;
        hobe_model *model = cantilever(&beam, 1);
        add_force(model, "beam", 1, P, 0, 0);
        hobe_solution *solution = solve(model, 1);
        const double u = point_of(solution, "beam", 1, 0, 0).u[0];
        const double missing = 1 - u / (M_PI / 4 * P * pow(RADIUS, 3) / EI);
        const double share = mesh_error(solution);
        printf("%-8s misses %.5f, estimated %.5f\n", names[i], missing, share);
        check_that(!hobe_solution_mesh_warning(solution, "beam", text, sizeof text, &err) &&
                       (share >= 0.01
                            ? strstr(text, "beam beam: its strains and the forces ") != NULL
                            : !*text),
                   "%s says %s", names[i], text);
        if (i < 2)
            check_relative(share, missing, 0.2, "share that %s misses", names[i]);
        else
            check_absolute(share, missing, 4e-3, "share that %s misses", names[i]);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    hobe_curve_free(curve);
}

/* Where the strains are right the estimate is nothing, whatever has made them: stretch, twist with
 * its shortening, bending by a moment. */
static void nothing_amiss(hobe_section *section)
{
    static const double loads[][3] = {{2e3, 0, 0}, {0, 20, 0}, {0, 0, 20}};
    for (int i = 0; i < 3; i++) {
        struct hobe_beam beam = beam_along_x("MGD30w", 8, section, E, 0, 2);
        hobe_model *model = cantilever(&beam, 1);
        add_moment(model, "beam", 1, loads[i][0], loads[i][1], loads[i][2]);
        hobe_solution *solution = solve(model, 1);
        check_absolute(mesh_error(solution), 0, 1e-5, "moment %d", i);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
}

int main(void)
{
    hobe_section *section = rectangle(SIDE, SIDE);
    even_curvature(section);
    locking(section);
    nothing_amiss(section);
    hobe_section_free(section);
    return check_report();
}
