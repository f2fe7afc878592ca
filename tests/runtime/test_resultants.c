/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Section forces against the loads they carry: exactly at the ends of elements, whatever the axis
 * and however large the deformation; and those of the stress, which converge to them. */
#include "check.h"
#include "scene.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static struct hobe_resultants cut_of(const hobe_solution *solution, double at, enum hobe_cut cut)
{
    struct hobe_error err;
    struct hobe_resultants r;
    if (hobe_solution_resultants(solution, "beam", at, cut, &r, &err))
        check_stop("%s", err.message);
    return r;
}

/* ---- balance -------------------------------------------------------------------------------- */

enum { FORCES = 4, ELEMENTS = 5 };
static const double AT[FORCES] = {0.37, 0.4, 0.83, 1}; /* 0.4: where two elements meet */

struct scene {
    hobe_model *model;
    hobe_solution *solution;
    double force[FORCES][3];
};

/* Forces that bend the beam far, with E = 5e7 and about 2 x 0.1 x 0.2 m. */
static struct scene bent(const struct hobe_beam *beam)
{
    struct scene scene = {.model = cantilever(beam, 0)};
    for (int i = 0; i < FORCES; i++) {
        for (int a = 0; a < 3; a++)
            scene.force[i][a] = random_real(-60, 60);
        add_force(scene.model, "beam", AT[i], scene.force[i][0], scene.force[i][1],
                  scene.force[i][2]);
    }
    scene.solution = solve(scene.model, 4);
    return scene;
}

/* At the end of the k-th element, of the forces at it and beyond. */
static void balance(const struct scene *scene, int k, const char *what)
{
    const double at = (double)k / ELEMENTS;
    const struct hobe_resultants r = cut_of(scene->solution, at, HOBE_CUT_BEST);
    const struct hobe_point here = point_of(scene->solution, "beam", at, 0, 0);
    double force[3] = {0}, moment[3] = {0}, most = 0;
    check_that(r.cut == HOBE_CUT_FORCES, "%s: nodal forces at %g", what, at);
    for (int i = 0; i < FORCES; i++) {
        const struct hobe_point p = point_of(scene->solution, "beam", AT[i], 0, 0);
        double arm[3], couple[3];
        if (AT[i] < at - 1e-9)
            continue;
        for (int a = 0; a < 3; a++)
            arm[a] = p.r[a] - here.r[a];
        cross3(arm, scene->force[i], couple);
        for (int a = 0; a < 3; a++) {
            force[a] += scene->force[i][a];
            moment[a] += couple[a];
        }
        most += norm(scene->force[i]);
    }
    for (int b = 0; b < 3; b++) {
        /* Newton's iteration ends at 1e-13 of the load, in stiffness-weighted forces */
        check_absolute(r.force[b], dot3(r.axes[b], force), 1e-8 * most, "%s: force %d at %g", what,
                       b, at);
        check_absolute(r.moment[b], dot3(r.axes[b], moment), 1e-8 * most, "%s: moment %d at %g",
                       what, b, at);
    }
}

static void balances(const struct hobe_beam *beam, const char *what)
{
    const struct scene scene = bent(beam);
    for (int k = 0; k <= ELEMENTS; k++)
        balance(&scene, k, what);
    printf("%s: the tip moved by %g m\n", what, norm(point_of(scene.solution, "beam", 1, 0, 0).u));
    hobe_solution_free(scene.solution);
    hobe_model_free(scene.model);
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context, (void)err;
    memcpy(r, (const double[3]){2 * sin(t), 2 * (1 - cos(t)), 0.3 * t}, 3 * sizeof *r);
    return HOBE_OK;
}

static enum hobe_status turning(void *context, double at, double *angle, struct hobe_error *err)
{
    (void)context, (void)err;
    *angle = 0.8 * at;
    return HOBE_OK;
}

static void all_balances(void)
{
    static const char *const elements[] = {"3333", "MGD30w", "3433w", "BE24w", "3333s"};
    hobe_section *section = rectangle(0.1, 0.2);
    hobe_section *taper = tapered(rectangle(0.1, 0.2), rectangle(0.08, 0.1));
    hobe_curve *curve = curve_of(arc, turning, NULL);
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++) {
        struct hobe_beam beam = beam_along_x(elements[i], ELEMENTS, section, 5e7, 0.3, 2);
        balances(&beam, elements[i]);
        beam.curve = curve;
        balances(&beam, "curved");
        beam.section = taper;
        balances(&beam, "curved and tapered");
    }
    hobe_section_free(section);
    hobe_section_free(taper);
    hobe_curve_free(curve);
}

/* Weight is spread over the elements, and a follower force turns with the section: what lies
 * beyond the cut, to rounding. */
/* A support and a spring between the ends of elements: what they do to the beam is among the forces
 * beyond a cut. */
static void held_between(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.2);
    struct hobe_beam beam = beam_along_x("MGD30", ELEMENTS, section, 5e7, 0.3, 2);
    hobe_model *model = cantilever(&beam, 0);
    const double F[3] = {random_real(-60, 60), random_real(-60, 60), random_real(-60, 60)};
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    const struct hobe_joint support = {
        .beam = {"beam"}, .name = "pin", .at = {0.5}, .kind = HOBE_JOINT_SPHERICAL};
    const struct hobe_spring spring = {.beam = {"beam"},
                                       .name = "cushion",
                                       .at = {0.73},
                                       .kind = HOBE_SPRING_BUSHING,
                                       .stiffness = {300, 400, 500}};
    if (hobe_model_joint(model, &support, &err) || hobe_model_spring(model, &spring, &err))
        check_stop("%s", err.message);
    hobe_solution *solution = solve(model, 2);
    struct hobe_reaction pin;
    if (hobe_solution_reaction(solution, "pin", &pin, &err))
        check_stop("%s", err.message);
    const struct hobe_point at = point_of(solution, "beam", 0.73, 0, 0);
    for (int k = 2; k < ELEMENTS; k++) {
        const struct hobe_resultants r = cut_of(solution, (double)k / ELEMENTS, HOBE_CUT_FORCES);
        for (int a = 0; a < 3; a++) {
            double force = 0, beyond = F[a];
            for (int b = 0; b < 3; b++)
                force += r.force[b] * r.axes[b][a];
            beyond -= k < 4 ? spring.stiffness[a] * at.u[a] : 0;
            beyond += k < 3 ? pin.force[a] : 0;
            /* Newton's residual, and rounding of stresses some hundred times the load's */
            check_absolute(force, beyond, 1e-7 * 60, "force %d at %d/%d", a, k, ELEMENTS);
        }
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

static void weight_and_follower(void)
{
    const double g[3] = {0, 0, -9.81}, L = 2, rho = 300;
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.2);
    struct hobe_beam beam = beam_along_x("MGD30w", ELEMENTS, section, 1e7, 0.3, L);
    beam.material.rho = rho;
    hobe_model *model = cantilever(&beam, 0);
    if (hobe_model_gravity(model, NULL, g, &err))
        check_stop("%s", err.message);
    add_follower(model, "beam", 1, 0, 0, 40);
    hobe_solution *solution = solve(model, 2);
    const struct hobe_resultants tip = cut_of(solution, 1, HOBE_CUT_FORCES);
    check_absolute(tip.force[0], 0, 1e-6, "a follower stays across the section");
    check_absolute(tip.force[2], 40, 1e-6, "with its size");
    for (int k = 0; k <= ELEMENTS; k++) {
        const double at = (double)k / ELEMENTS;
        const struct hobe_resultants r = cut_of(solution, at, HOBE_CUT_FORCES);
        for (int a = 0; a < 3; a++) {
            double force = 0;
            for (int b = 0; b < 3; b++)
                force += r.force[b] * r.axes[b][a] - tip.force[b] * tip.axes[b][a];
            check_absolute(force, rho * 0.02 * L * (1 - at) * g[a], 1e-7, "weight beyond %g", at);
        }
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- stress --------------------------------------------------------------------------------- */

/* The integral of the traction converges to the nodal forces; in the middle of elements, whose
 * errors fall with the square of their length or faster. */
static void convergence(const char *element)
{
    hobe_section *section = rectangle(0.1, 0.2);
    double error[2] = {0, 0};
    for (int fine = 0; fine < 2; fine++) {
        const int elements = fine ? 40 : 10;
        const struct hobe_beam beam = beam_along_x(element, elements, section, 1e9, 0.3, 2);
        hobe_model *model = cantilever(&beam, 0);
        add_force(model, "beam", 1, 400, 200, 500);
        add_moment(model, "beam", 1, 300, 0, 0);
        hobe_solution *solution = solve(model, 2);
        for (int i = 4; i < 8; i++) {
            const double at = i / 10.0;
            const struct hobe_resultants exact = cut_of(solution, at, HOBE_CUT_FORCES);
            const struct hobe_resultants r = cut_of(solution, at, HOBE_CUT_STRESS);
            for (int b = 0; b < 3; b++) {
                error[fine] = fmax(error[fine], fabs(r.moment[b] - exact.moment[b]) / 1000);
                error[fine] = fmax(error[fine], fabs(r.force[b] - exact.force[b]) / 1000);
            }
        }
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    printf("%s: stress beside nodal forces: %.1e, with elements a quarter as long %.1e\n", element,
           error[0], error[1]);
    check_that(error[1] < error[0] / 8 && error[1] < 2e-3, "%s: convergence", element);
    hobe_section_free(section);
}

/* Held warping: the bimoment at the clamp falls off along the beam, and both ways agree on it. */
static void bimoment(void)
{
    const double L = 1, T = 1, nu = 0.3;
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_section_properties p = properties_of(section);
    const struct hobe_beam beam = beam_along_x("3433w", 60, section, 1, nu, L);
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 1e-9 * T, 0, 0);
    hobe_solution *solution = solve(model, 1);
    const double Ip = p.Iyy + p.Izz, b = Ip - p.J;
    /* of the rigid outline, test_results.c: E Iw p' with p = T/(G J) (1 - cosh(m(L - x))/cosh(mL)),
     * r_w = -p */
    const double m = sqrt((b - b * b / Ip) / (2 * (1 + nu) * p.Iw));
    const double G = 1 / (2 * (1 + nu));
    for (int i = 0; i < 8; i++) {
        const double at = i / 20.0, x = at * L;
        const double theory = -p.Iw * m * T / (G * p.J) * sinh(m * (L - x)) / cosh(m * L);
        const double B = cut_of(solution, at, HOBE_CUT_FORCES).bimoment / 1e-9;
        /* the section also shears in its plane there, which that theory leaves out */
        check_absolute(B, theory, 0.05 * p.Iw * m * T / (G * p.J), "bimoment at %g", at);
        if (i > 0)
            check_absolute(cut_of(solution, at, HOBE_CUT_STRESS).bimoment / 1e-9, B,
                           0.01 * p.Iw * m * T / (G * p.J), "bimoment of the stress at %g", at);
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- what is refused ------------------------------------------------------------------------ */

static void refused(void)
{
    struct hobe_error err = {0};
    struct hobe_resultants r;
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_beam beam = beam_along_x("3333s", 3, section, 1e9, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    hobe_solution *solution = solve(model, 1);
    check_that(hobe_solution_resultants(solution, "beam", 0.5, HOBE_CUT_FORCES, &r, &err) ==
                       HOBE_BAD_INPUT &&
                   strstr(err.message, "multiples of 1/3"),
               "no nodal forces there: %s", err.message);
    check_that(hobe_solution_resultants(solution, "beam", 0.5, HOBE_CUT_BEST, &r, &err) ==
                       HOBE_BAD_INPUT &&
                   strstr(err.message, "3333s"),
               "nor a stress: %s", err.message);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    all_balances();
    held_between();
    weight_and_follower();
    convergence("MGD30w");
    convergence("3433w");
    bimoment();
    refused();
    return check_report();
}
