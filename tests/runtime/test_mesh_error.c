/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The estimate of what a mesh misses: exact where an element's curvature is even along it, near the
 * truth where elements lock on an arc or are twisted far, within bounds of it in random scenes,
 * nothing where nothing is wrong; and its warning. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 1e9, SIDE = 0.1, RADIUS = 10;

/* Of what is missing, the estimate is between these multiples, but for so little that nobody is
 * warned of it. */
static const double SHARE = 0.3, MOST = 3, LEAST = 1e-3;

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
                       (share >= 0.01 ? strstr(text, "beam beam: about ") == text : !*text),
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

/* ---- far twisted ----------------------------------------------------------------------------- */

static double twist_of(const hobe_solution *solution)
{
    struct hobe_error err;
    double angle;
    if (hobe_solution_twist(solution, "beam", 1, &angle, &err))
        check_stop("%s", err.message);
    return angle;
}

/* Slopes that turn are interpolated and so too short between nodes, which makes a mesh too stiff by
 * a third of the twist up to most of it, here 10 rad: the estimate is the share of the twist that
 * is missing, by a first order that is up to an eighth more where half is missing. */
static void twisted(hobe_section *section)
{
    static const struct {
        const char *name;
        int n;
    } meshes[] = {{"3433w", 16}, {"BE24w", 16}, {"3333w", 4}, {"MGD30w", 4}, {"3433w", 2}};
    double truth = 0;
    for (int i = 0; i < 5; i++) {
        struct hobe_beam beam = beam_along_x(meshes[i].name, meshes[i].n, section, E, 0.3, 5);
        hobe_model *model = cantilever(&beam, 1);
        add_moment(model, "beam", 1, 1e4, 0, 0);
        hobe_solution *solution = solve(model, 4);
        const double angle = twist_of(solution), share = mesh_error(solution);
        truth = i ? truth : angle;
        const double missing = 1 - angle / truth;
        printf("%2d of %-8s miss %.4f of %.3f rad, estimated %.4f\n", meshes[i].n, meshes[i].name,
               missing, truth, share);
        if (i)
            check_relative(share, missing, 0.25, "twist that %d of %s miss", meshes[i].n,
                           meshes[i].name);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
}

/* ---- random scenes --------------------------------------------------------------------------- */

/* A cantilever: straight, bent to an arc, pretwisted or tapered. */
enum { STRAIGHT, ARC, TWISTED, TAPERED, SHAPES };
static const char *const shapes[SHAPES] = {"straight", "bent", "pretwisted", "tapered"};
struct scene {
    struct hobe_beam beam;
    hobe_section *section;
    hobe_curve *curve; /* or NULL */
    double length, angle, twist, load[3];
    int shape, free_warping, moment;
};

static enum hobe_status bent(void *context, double t, double *value, struct hobe_error *err)
{
    const struct scene *s = context;
    const double angle = fmax(s->angle, 1e-9);
    (void)err;
    value[0] = s->length * sin(angle * t) / angle;
    value[1] = 0;
    value[2] = s->length * 2 * pow(sin(angle * t / 2), 2) / angle;
    return HOBE_OK;
}

static enum hobe_status turned(void *context, double t, double *value, struct hobe_error *err)
{
    (void)err;
    *value = ((const struct scene *)context)->twist * t;
    return HOBE_OK;
}

/* The work of the small load on n elements, twice the energy; the estimate unless NULL. */
static double energy_on(struct scene *s, int n, double *share)
{
    s->beam.elements = n;
    hobe_model *model = cantilever(&s->beam, s->free_warping);
    (s->moment ? add_moment : add_force)(model, "beam", 1, s->load[0], s->load[1], s->load[2]);
    hobe_solution *solution = solve(model, 1);
    const double energy = info_of(solution).energy;
    if (share)
        *share = mesh_error(solution);
    hobe_solution_free(solution);
    hobe_model_free(model);
    return energy;
}

/* Cubic modes of the section let its outline turn away from slopes that a clamp or a moment holds,
 * the more the finer the mesh: there is no truth to compare with. */
static int turns_away(const struct hobe_kernel *kernel, int mode)
{
    return mode < kernel->modes &&
           (!strcmp(kernel->mode[mode], "yyy") || turns_away(kernel, mode + 1));
}

/* L/h from 3 to 300.  Where slopes are linear between two nodes the reference itself of a bent,
 * pretwisted or tapered beam is another on each mesh, by as much as is estimated: those are
 * straight, and so are elements that take long to integrate.  What is freed with it is the
 * caller's. */
static void choose_scene(const struct hobe_kernel *kernel, struct scene *s)
{
    const int straight = kernel->nodes == 2 || kernel->vectors > 24, rich = turns_away(kernel, 0);
    const double width = SIDE * random_real(0.3, 1), taper = random_real(0.4, 1);
    s->shape = straight ? STRAIGHT : (int)random_real(0, SHAPES);
    s->length = SIDE * pow(10, random_real(0.5, 2.5));
    s->angle = s->shape == ARC ? random_real(0.2, 1.6) : 0;
    s->twist = s->shape == TWISTED ? random_real(0.2, 2) : 0;
    s->free_warping = !rich && random_real(0, 1) < 0.5;
    s->moment = !rich && random_real(0, 1) < 0.5;
    s->section = rectangle(width, SIDE);
    if (s->shape == TAPERED)
        s->section = tapered(s->section, rectangle(width * taper, SIDE * 0.6));
    s->curve = NULL;
    if (s->shape == ARC || s->shape == TWISTED)
        s->curve = curve_of(bent, s->shape == TWISTED ? turned : NULL, s);
    s->beam = beam_along_x(kernel->name, 1, s->section, E, random_real(0, 0.45), s->length);
    s->beam.curve = s->curve;
    s->beam.up[1] = 1;
    random_direction(s->load);
    for (int a = 0; a < 3; a++) /* bends and twists by 1e-6 or less */
        s->load[a] *= 1e-8 * E * pow(width, 3) * SIDE / pow(s->length, s->moment ? 1 : 2);
}

/* On a mesh of one to six elements; of two or more where a section goes to half its size, for which
 * one degree more is not enough. */
static void random_scene(const struct hobe_kernel *kernel)
{
    struct scene s;
    choose_scene(kernel, &s);
    const int n = (int)random_real(s.shape == TAPERED ? 2 : 1, kernel->vectors > 24 ? 3 : 7);
    double share;
    const double energy = energy_on(&s, n, &share);
    const double missing = 1 - energy / energy_on(&s, 6 * n, NULL);
    printf("%-9s %d of L/h = %-6.3g %-10s %s, %-5s warping: misses %.2e, estimated %.2e, %.2f\n",
           kernel->name, n, s.length / SIDE, shapes[s.shape], s.moment ? "moment" : "force ",
           s.free_warping ? "free" : "fixed", missing, share, share / missing);
    check_that(share < LEAST + MOST * missing && share > SHARE * missing - LEAST,
               "%s: estimate %g, missing %g", kernel->name, share, missing);
    hobe_curve_free(s.curve);
    hobe_section_free(s.section);
}

static void random_scenes(int count)
{
    int kernels = 0;
    while (hobe_kernels()[kernels])
        kernels++;
    for (int i = 0; i < count; i++) {
        const struct hobe_kernel *kernel = hobe_kernels()[(int)random_real(0, kernels)];
        if (strcmp(kernel->mechanics, "structural") != 0)
            random_scene(kernel);
    }
}

int main(void)
{
    hobe_section *section = rectangle(SIDE, SIDE);
    random_start();
    even_curvature(section);
    locking(section);
    nothing_amiss(section);
    twisted(section);
    random_scenes(6);
    hobe_section_free(section);
    return check_report();
}
