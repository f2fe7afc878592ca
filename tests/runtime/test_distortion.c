/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of distortion against the equations that define them, and beams that have them. */
#include "check.h"
#include "scene.h"
#include "section.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const names[] = {"w", "wy", "wz", "ww", "v1y", "v1z", "v2y", "v2z"};

/* The section's rule with the functions in the order of their slots. */
static struct hobe_rule rule_of(const hobe_section *section)
{
    struct hobe_kernel kernel = *hobe_find_kernel("MGD30d", NULL);
    struct hobe_rule rule;
    struct hobe_error err;
    kernel.function = names;
    kernel.functions = HOBE_ALL_FUNCTIONS;
    if (hobe_section_rule(section, &kernel, HOBE_INTEGRATION_EXACT, NULL, &rule, &err))
        check_stop("%s", err.message);
    return rule;
}

/* int E f_i dA, int E y f_i dA, int E z f_i dA vanish: algebra. */
static void orthogonal(const char *name, const hobe_section *section, const struct hobe_rule *rule)
{
    for (int i = 0; i < HOBE_ALL_FUNCTIONS; i++) {
        double sum[3] = {0}, square = 0, moment[3] = {0};
        for (int p = 0; p < rule->rule.points; p++) {
            const struct hobe_section_point *at = rule->point + p;
            const double weight = at->weight * hobe_section_E(section, at->region);
            const double basis[3] = {1, at->y, at->z}, f = at->f[i][0];
            square += weight * f * f;
            for (int k = 0; k < 3; k++) {
                sum[k] += weight * basis[k] * f;
                moment[k] += weight * basis[k] * basis[k];
            }
        }
        for (int k = 0; k < 3; k++)
            check_absolute(sum[k], 0, 1e-10 * sqrt(square * moment[k]), "%s: %s against %d", name,
                           names[i], k);
    }
}

/* Quadratic fields phi e_a, which finite elements hold exactly: value and gradient. */
static void quadratic(int k, double y, double z, double phi[3])
{
    const double all[3][3] = {{y * y, 2 * y, 0}, {y * z, z, y}, {z * z, 0, 2 * z}};
    memcpy(phi, all[k], sizeof all[k]);
}

/* The load of v1 or v2 at a point. */
static void load(const struct hobe_section_point *p, double G, const double centre[2], int l,
                 double b[2])
{
    const double tau[2] = {centre[1] - p->z - p->f[HOBE_W][1], p->y - centre[0] - p->f[HOBE_W][2]};
    b[0] = G * (l ? -tau[1] : tau[0]);
    b[1] = G * (l ? tau[0] : tau[1]);
}

/* In-plane stiffness of v against phi e_a, of the isotropic law without Poisson's coupling. */
static double stiffness(const struct hobe_section_point *p, double E, int l, int a,
                        const double phi[3])
{
    const double *y = p->f[HOBE_V1Y + 2 * l], *z = p->f[HOBE_V1Z + 2 * l];
    return a ? E * (z[2] * phi[2] + (y[2] + z[1]) * phi[1] / 2)
             : E * (y[1] * phi[1] + (y[2] + z[1]) * phi[2] / 2);
}

/* The weak form against six quadratic fields: K(v, phi) is the same multiple of the balanced load's
 * work on each.  The rigid part of the load is found anew here, by its moments.  Not for sections
 * of two axes of symmetry, where it does no such work. */
static void equilibrium(const char *name, const hobe_section *section, const struct hobe_rule *rule)
{
    const struct hobe_section_properties q = properties_of(section);
    const double centre[2] = {q.ys, q.zs};
    for (int l = 0; l < 2; l++) {
        double work[6] = {0}, energy[6] = {0}, mass = 0, force[2] = {0}, moment = 0, polar = 0;
        for (int p = 0; p < rule->rule.points; p++) {
            const struct hobe_section_point *at = rule->point + p;
            const double E = at->weight * hobe_section_E(section, at->region);
            double b[2];
            load(at, at->weight * hobe_section_G(section, at->region), centre, l, b);
            mass += E;
            polar += E * (at->y * at->y + at->z * at->z);
            force[0] += b[0];
            force[1] += b[1];
            moment += at->y * b[1] - at->z * b[0];
        }
        for (int p = 0; p < rule->rule.points; p++) {
            const struct hobe_section_point *at = rule->point + p;
            const double E = at->weight * hobe_section_E(section, at->region);
            const double G = at->weight * hobe_section_G(section, at->region);
            double b[2], phi[3];
            load(at, G, centre, l, b);
            b[0] -= E * (force[0] / mass - at->z * moment / polar);
            b[1] -= E * (force[1] / mass + at->y * moment / polar);
            for (int k = 0; k < 6; k++) {
                quadratic(k / 2, at->y, at->z, phi);
                work[k] += b[k % 2] * phi[0];
                energy[k] += stiffness(at, E, l, k % 2, phi);
            }
        }
        int most = 0;
        for (int k = 1; k < 6; k++)
            most = fabs(work[k]) > fabs(work[most]) ? k : most;
        for (int k = 0; k < 6; k++)
            check_absolute(energy[k] / energy[most], work[k] / work[most], 1e-8,
                           "%s: equilibrium of v%d, field %d", name, l + 1, k);
    }
}

static hobe_section *checked(hobe_section *section, const struct hobe_error *err)
{
    if (!section)
        check_stop("%s", err->message);
    return section;
}

static void check_section(const char *name, hobe_section *section)
{
    struct hobe_rule rule = rule_of(section);
    orthogonal(name, section, &rule);
    equilibrium(name, section, &rule);
    hobe_rule_free(&rule);
    hobe_section_free(section);
}

/* The first frequency in torsion of a cantilever of 2 m, rad/s; torsion has no part in what shakes
 * along an axis. */
static double torsion(const char *element, const hobe_section *section, double E)
{
    const struct hobe_material material = {.E = E, .nu = 0.3, .rho = 7850, .k2 = 1, .k3 = 1};
    const struct hobe_beam beam = {.name = "beam",
                                   .kernel = hobe_find_kernel(element, NULL),
                                   .elements = 20,
                                   .section = section,
                                   .material = material,
                                   .to = {2, 0, 0}};
    hobe_model *model = cantilever(&beam, 0);
    hobe_modes *modes = modes_of(model, NULL, 6, HOBE_MODAL_AUTO);
    double omega = NAN;
    for (int i = 5; i >= 0; i--) {
        double u[3], corner[3];
        struct hobe_error err;
        hobe_modes_point(modes, i, "beam", 1, 0, 0, u, &err);
        hobe_modes_point(modes, i, "beam", 1, 0, 0.04, corner, &err);
        if (fabs(corner[1] - u[1]) > 10 * hypot(u[1], u[2]))
            omega = mode_of(modes, i).omega;
    }
    hobe_modes_free(modes);
    hobe_model_free(model);
    return omega;
}

/* Against converged quadratic bricks with a clamped face: 282.3(2) and 132.1(1) rad/s.  A rigid
 * outline is 1.4 % too fast on both.  What is left on the I, 0.4 %, is not understood; a solid of
 * our own has 283.1. */
static void frequencies(void)
{
    const struct hobe_profile_sizes sizes = {
        .height = 0.215, .width = 0.1, .flange = 0.015, .web = 0.01};
    struct hobe_error err;
    hobe_section *I =
        checked(hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err), &err);
    hobe_section *hollow =
        checked(hobe_section_hollow(0.16, 0.08, 0.01, HOBE_WARPING_SOLVED, &err), &err);
    check_relative(torsion("MGD30d", I, 210e9), 282.3, 5e-3, "torsion of the I");
    check_relative(torsion("MGD30d", hollow, 1e9), 132.1, 3e-3, "torsion of the hollow beam");
    check_that(torsion("MGD30w3", hollow, 1e9) > 1.01 * 132.1, "a rigid outline is too stiff");
    hobe_section_free(I);
    hobe_section_free(hollow);
}

/* A rectangle in closed form has none of them: their modes are left out, and named; a taper of an
 * outline does not know them, and says so. */
static void without(void)
{
    struct hobe_error err;
    double f[3];
    hobe_section *series =
        checked(hobe_section_rectangle(0.1, 0.2, HOBE_WARPING_SERIES, &err), &err);
    const struct hobe_beam beam = beam_along_x("MGD30d", 2, series, 1e9, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    check_that(hobe_model_build(model, &err) == HOBE_OK, "MGD30d on a rectangle");
    check_that(hobe_model_note(model, 3) != NULL, "dropped modes are named");
    hobe_model_free(model);
    hobe_section *hollow[2] = {
        checked(hobe_section_hollow(0.16, 0.08, 0.01, HOBE_WARPING_SOLVED, &err), &err),
        checked(hobe_section_hollow(0.12, 0.06, 0.01, HOBE_WARPING_SOLVED, &err), &err)};
    hobe_section *taper = checked(hobe_section_linear(hollow[0], hollow[1], &err), &err);
    check_that(hobe_section_function(taper, "v1y", 0, 0.03, f, &err) == HOBE_UNKNOWN,
               "a taper has no v1y");
    printf("%s\n", err.message);
    hobe_section_free(series);
    hobe_section_free(taper);
    for (int i = 0; i < 2; i++)
        hobe_section_free(hollow[i]);
}

int main(void)
{
    static const double corner[6][2] = {{0, 0},     {.2, 0},    {.2, .03},
                                        {.04, .05}, {.03, .15}, {0, .15}};
    static const double pierced[7][2] = {{0, 0},     {.2, .01},   {.18, .1}, {.02, .12},
                                         {.02, .02}, {.17, .025}, {.03, .1}};
    struct hobe_error err;
    random_start();
    check_section("an angle",
                  checked(hobe_section_polygon(1, (const int[]){6}, corner, &err), &err));
    check_section("a hollow section",
                  checked(hobe_section_polygon(2, (const int[]){4, 3}, pierced, &err), &err));
    frequencies();
    without();
    return check_report();
}
