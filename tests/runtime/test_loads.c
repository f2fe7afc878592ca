/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads: the tangents of those that depend on the state, moments on turned beams, reciprocity,
 * gravity and its reactions.  Looks into the core (load.h) for the tangents. */
#include "check.h"
#include "load.h"
#include "scene.h"
#include "tangent.h"

#include <math.h>
#include <stdio.h>

static const double E = 70e9, NU = 0.33;

/* ---- tangents
 * ------------------------------------------------------------------------------------ */

static void all_loads(const hobe_model *model, const double *u, double *r, const struct matrix *K)
{
    load_subtract(model, u, &AT_REST, 0.7, r, K);
}

static void tangents(void)
{
    static const char *const names[] = {"MGD30w", "3433", "BE24"};
    hobe_section *section = rectangle(0.1, 0.2);
    for (int i = 0; i < 9; i++) {
        struct hobe_beam beam = beam_along_x(names[i % 3], 2, section, E, NU, 1);
        for (int a = 0; a < 3; a++) {
            beam.to[a] = random_real(0.5, 1);
            beam.up[a] = a == 2 ? 3 : random_real(-1, 1);
        }
        const double at = i < 3 ? 1 : random_real(0.55, 0.95);
        double v[3];
        for (int a = 0; a < 3; a++)
            v[a] = random_real(50, 100);
        hobe_model *model = cantilever(&beam, 0);
        add_follower(model, "beam", at, v[0], v[1], v[2]);
        check_tangent(model, all_loads, 0, "follower force");
        hobe_model_free(model);
        model = cantilever(&beam, 0);
        add_moment(model, "beam", at, v[0], v[1], v[2]);
        check_tangent(model, all_loads, 1, "moment");
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* ---- Newton with them
 * ------------------------------------------------------------------------------ */

enum { REMEMBERED = 40 };

struct history {
    int count;
    double residual[REMEMBERED];
};

static void remember(void *context, const struct hobe_iteration *now)
{
    struct history *h = context;
    if (h->count < REMEMBERED)
        h->residual[h->count++] = now->residual;
}

/* With a consistent tangent the residual falls like its square once it is small: the last
 * correction wins three digits at least; a tangent that lacks the load's share wins one. */
static void quadratic_convergence(const char *what, void (*load)(hobe_model *))
{
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_beam beam = beam_along_x("MGD30w", 8, section, E, NU, 4);
    hobe_model *model = cantilever(&beam, 0);
    struct history h = {0};
    struct hobe_error err;
    hobe_solution *solution;
    const struct hobe_newton options = {.tolerance = 1e-7, .log = remember, .context = &h};
    load(model);
    if (hobe_static(model, &options, &solution, &err))
        check_stop("%s: %s", what, err.message);
    printf("%s: residuals", what);
    for (int i = 0; i < h.count; i++)
        printf(" %.1e", h.residual[i]);
    printf("\n");
    const int last = h.count - 1;
    check_that(info_of(solution).iterations <= 20 && info_of(solution).cutbacks == 0,
               "%s: %d iterations", what, info_of(solution).iterations);
    check_that(h.residual[last] < 1e-3 * h.residual[last - 1],
               "%s: quadratic at the end: %g after %g", what, h.residual[last],
               h.residual[last - 1]);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

static void load_dead(hobe_model *model)
{
    add_force(model, "beam", 1, 0, 1e5, -2e5);
}

static void push_follower(hobe_model *model)
{
    add_follower(model, "beam", 1, 0, 1e5, -2e5);
}

static void load_moment(hobe_model *model)
{
    add_moment(model, "beam", 1, 1e5, 1.5e5, 5e4);
}

/* ---- moments on turned beams
 * ----------------------------------------------------------------------- */

/* The section axes turned by `about` x: a beam along x with z along (0, -s, c). */
static struct hobe_point moment_tip(double turn, const double m[3])
{
    const double c = cos(turn), s = sin(turn);
    hobe_section *section = rectangle(0.1, 0.2);
    struct hobe_beam beam = beam_along_x("MGD30w", 6, section, E, NU, 2);
    beam.up[1] = -s;
    beam.up[2] = c;
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, m[0], c * m[1] - s * m[2], s * m[1] + c * m[2]);
    const struct hobe_point tip = tip_of(model, 2);
    hobe_section_free(section);
    return tip;
}

/* A moment about a global axis is resolved on the beam's own axes: turning beam and moment turns
 * the solution. */
static void moments_turn_with_the_beam(void)
{
    const double m[3] = {1e5, 2e5, 5e4};
    const struct hobe_point straight = moment_tip(0, m);
    for (int i = 0; i < 3; i++) {
        const double turn = random_real(-3, 3), c = cos(turn), s = sin(turn);
        const struct hobe_point tip = moment_tip(turn, m);
        const double u[3] = {tip.u[0], c * tip.u[1] + s * tip.u[2], c * tip.u[2] - s * tip.u[1]};
        /* limited by the tangent's conditioning */
        check_absolute(distance(u, straight.u), 0, 1e-9, "a turned beam under a moment");
        check_absolute(tip.twist, straight.twist, 1e-9, "twist of a turned beam");
    }
}

/* Small end moments turn the tip about their own axes, and only those, also on a beam that lies
 * askew: M L/(EI), T L/(G J). */
static void moments_by_axis(void)
{
    const double turn = 1e-7, L = 1.5;
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_section_properties p = properties_of(section);
    const double G = E / (2 * (1 + NU));
    const double stiffness[3] = {G * p.J_w / L, E * p.Iyy / L, E * p.Izz / L};
    for (int axis = 0; axis < 3; axis++) {
        double M[3], e[3][3] = {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
        struct hobe_beam beam = beam_along_x("MGD30w", 3, section, E, NU, L);
        for (int a = 0; a < 3; a++) {
            beam.to[a] = L * e[0][a];
            M[a] = turn * stiffness[axis] * e[axis][a];
        }
        hobe_model *model = cantilever(&beam, 1);
        add_moment(model, "beam", 1, M[0], M[1], M[2]);
        const struct hobe_point tip = tip_of(model, 1);
        for (int b = 0; b < 3; b++) {
            const double about =
                tip.rotation[0] * e[b][0] + tip.rotation[1] * e[b][1] + tip.rotation[2] * e[b][2];
            /* the rotation's second order and J_w */
            check_absolute(about, axis == b ? turn : 0, 1e-6 * turn,
                           "a moment about axis %d turns about axis %d", axis, b);
        }
    }
    hobe_section_free(section);
}

/* ---- reciprocity
 * -------------------------------------------------------------------------------------- */

/* Small loads anywhere: the displacement at b under a force at a is that at a under a force at b.
 */
static void reciprocity(const char *element)
{
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_beam beam = beam_along_x(element, 3, section, E, NU, 1);
    for (int i = 0; i < 4; i++) {
        const double at[2] = {random_real(0.1, 1), random_real(0.1, 1)};
        double work[2], d[2][3];
        random_direction(d[0]);
        random_direction(d[1]);
        for (int k = 0; k < 2; k++) {
            const double P = 1e-3, *F = d[k]; /* N: strains of 1e-13 */
            hobe_model *model = cantilever(&beam, 0);
            add_force(model, "beam", at[k], P * F[0], P * F[1], P * F[2]);
            hobe_solution *solution = solve(model, 1);
            const struct hobe_point p = point_of(solution, "beam", at[1 - k], 0, 0);
            const double *other = d[1 - k];
            work[k] = (p.u[0] * other[0] + p.u[1] * other[1] + p.u[2] * other[2]) / P;
            hobe_solution_free(solution);
            hobe_model_free(model);
        }
        /* of the bending flexibility: small parts of the vectors carry its round-off */
        const double size = 1 / (3 * E * properties_of(section).Izz);
        check_absolute(work[0], work[1], 1e-9 * size, "%s: force at %g and at %g", element, at[0],
                       at[1]);
    }
    hobe_section_free(section);
}

/* A force at an interior node of the centreline bends the beam as theory has it, exactly in an
 * element whose slope r_x may jump there. */
static void interior_force(void)
{
    const double L = 2, a = 1, P = 1;
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_beam beam = beam_along_x("3433w", 4, section, E, NU, L);
    const double EI = E * properties_of(section).Iyy;
    const double GA = E / (2 * (1 + NU)) * properties_of(section).A;
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", a / L, 0, 0, -P);
    const struct hobe_point tip = tip_of(model, 1);
    /* round-off times the tangent's condition */
    check_relative(-tip.u[2], P * a * a * (3 * L - a) / (6 * EI) + P * a / GA, 1e-8,
                   "force at mid-span");
    hobe_section_free(section);
}

/* ---- gravity
 * ------------------------------------------------------------------------------------------ */

/* Displacements of the vectors of the first element, read off at its nodes: MGD30 holds nothing but
 * positions and slopes. */
static void first_element(const hobe_solution *solution, const struct hobe_kernel *k, int elements,
                          double *u)
{
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *is = k->vector + v;
        const struct hobe_point p = point_of(solution, "beam", k->node[is->node] / elements, 0, 0);
        for (int a = 0; a < 3; a++) {
            const int column = is->mode ? is->mode : 0;
            u[3 * v + a] = is->mode == 0 && !is->slope ? p.u[a] : p.F[a][column] - (a == column);
        }
    }
}

/* The clamp carries the weight: elastic force less load on the held position. */
static void weight(void)
{
    enum { ELEMENTS = 6 };
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, g[3] = {1, -2, -9.81};
    const double L = 3, rho = 2700;
    hobe_section *section = rectangle(0.05, 0.1);
    struct hobe_beam beam = beam_along_x("MGD30", ELEMENTS, section, E, NU, L);
    beam.material.rho = rho;
    struct hobe_error err;
    hobe_model *model = cantilever(&beam, 0);
    if (hobe_model_gravity(model, NULL, g, &err))
        check_stop("%s", err.message);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_element_options options = {.kernel = beam.kernel,
                                                 .section = section,
                                                 .material = beam.material,
                                                 .length = L / ELEMENTS};
    hobe_element *element = hobe_element_new(&options, &err);
    if (!element)
        check_stop("%s", err.message);
    double q0[30], q[30], f[30], M[900];
    first_element(solution, beam.kernel, ELEMENTS, q);
    hobe_element_reference(element, identity, q0);
    for (int i = 0; i < 30; i++)
        q[i] += q0[i];
    if (hobe_element_force(element, q0, q, f, &err))
        check_stop("%s", err.message);
    hobe_element_mass(element, M);
    for (int a = 0; a < 3; a++) {
        double reaction = f[a];
        for (int v = 0; v < 10; v++) /* M a with a = g on the positions */
            if (beam.kernel->vector[v].mode == 0 && !beam.kernel->vector[v].slope)
                reaction -= M[a * 30 + 3 * v + a] * g[a];
        /* read off positions: F - 1 has 1e-16 of 1 as its error, 1e-9 of the strains */
        check_relative(reaction, -rho * properties_of(section).A * L * g[a], 1e-6,
                       "reaction to the weight along %c", "xyz"[a]);
    }
    hobe_element_free(element);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* rho g A L^4/(8EI) and the shear's rho g L^2/(2G); two calls add up. */
static void sag(void)
{
    const double L = 3, rho = 2700, g = 1e-3;
    hobe_section *section = rectangle(0.05, 0.1);
    const struct hobe_section_properties p = properties_of(section);
    struct hobe_beam beam = beam_along_x("3433w", 4, section, E, NU, L);
    struct hobe_error err;
    beam.material.rho = rho;
    hobe_model *model = cantilever(&beam, 0);
    for (int i = 0; i < 2; i++)
        if (hobe_model_gravity(model, NULL, (const double[3]){0, 0, -g / 2}, &err))
            check_stop("%s", err.message);
    const struct hobe_point tip = tip_of(model, 1);
    const double G = E / (2 * (1 + NU));
    const double exact = rho * g * L * L * (p.A * L * L / (8 * E * p.Iyy) + 1 / (2 * G));
    /* cubic functions hold the slope of a moment quadratic in x, and the nodes' deflection is then
     * exact; round-off times the tangent's condition is left */
    check_relative(-tip.u[2], exact, 1e-8, "sag under gravity");
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    tangents();
    quadratic_convergence("dead force", load_dead);
    quadratic_convergence("follower force", push_follower);
    quadratic_convergence("moment", load_moment);
    moments_turn_with_the_beam();
    moments_by_axis();
    reciprocity("MGD30w");
    reciprocity("3433w");
    reciprocity("34X3");
    interior_force();
    weight();
    sag();
    return check_report();
}
