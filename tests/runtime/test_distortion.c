/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of distortion against the equations that define them, and beams that have them. */
#include "check.h"
#include "scene.h"
#include "section.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {"w",   "wy",  "wz",  "ww",  "w1",  "w2",  "w3",
                                    "w2t", "v1y", "v1z", "v2y", "v2z", "v3y", "v3z"};
enum { PAIRS = 3, WARPINGS = 5 };

/* The section's rule with the functions in the order of their slots. */
static struct hobe_rule rule_of(const hobe_section *section)
{
    struct hobe_kernel kernel = *hobe_find_kernel("MGD30d2", NULL);
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

/* A section's rule and, at each of its points, v1, v2 and v3 as they were solved: value and
 * gradient, v[points][PAIRS][2][3]. */
struct solved {
    const char *name;
    const hobe_section *section;
    const struct hobe_rule *rule;
    double centre[2], E, yy, yz, zz; /* integrals of E, E y^2, E y z, E z^2 */
    double (*v)[PAIRS][2][3];
};

static void moments(struct solved *s)
{
    const struct hobe_section_properties q = properties_of(s->section);
    s->centre[0] = q.ys;
    s->centre[1] = q.zs;
    for (int p = 0; p < s->rule->rule.points; p++) {
        const struct hobe_section_point *at = s->rule->point + p;
        const double E = at->weight * hobe_section_E(s->section, at->region);
        s->E += E;
        s->yy += E * at->y * at->y;
        s->yz += E * at->y * at->z;
        s->zz += E * at->z * at->z;
    }
}

/* The load of v_l on the points: a force b and a stress g, times the weight. */
static void load(const struct solved *s, int p, int l, double b[2], double g[2][2])
{
    const struct hobe_section_point *at = s->rule->point + p;
    const double E = at->weight * hobe_section_E(s->section, at->region);
    const double G = at->weight * hobe_section_G(s->section, at->region);
    const double(*v2)[3] = (const double(*)[3])s->v[p][1];
    const double tau[2] = {s->centre[1] - at->z - at->f[HOBE_W][1],
                           at->y - s->centre[0] - at->f[HOBE_W][2]};
    const double force[PAIRS][2] = {{G * tau[0], G * tau[1]}, {-G * tau[1], G * tau[0]}};
    memcpy(b, force[l], sizeof force[l]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            g[i][k] =
                l < 2 ? 0 : -E / 2 * (v2[0][1 + i] * v2[0][1 + k] + v2[1][1 + i] * v2[1][1 + k]);
}

/* The work of the load without its rigid part, found anew here by moments, on phi e_a. */
static double work(const struct solved *s, int l, int a, int linear, int k)
{
    double sum = 0, force[2] = {0}, moment = 0, b[2], g[2][2];
    for (int p = 0; p < s->rule->rule.points; p++) {
        const struct hobe_section_point *at = s->rule->point + p;
        load(s, p, l, b, g);
        force[0] += b[0];
        force[1] += b[1];
        moment += at->y * b[1] - at->z * b[0];
    }
    for (int p = 0; p < s->rule->rule.points; p++) {
        const struct hobe_section_point *at = s->rule->point + p;
        const double E = at->weight * hobe_section_E(s->section, at->region);
        const double spin = moment / (s->yy + s->zz);
        double phi[3] = {k ? at->z : at->y, !k, k};
        if (!linear)
            quadratic(k, at->y, at->z, phi);
        load(s, p, l, b, g);
        b[0] -= E * (force[0] / s->E - at->z * spin);
        b[1] -= E * (force[1] / s->E + at->y * spin);
        sum += b[a] * phi[0] + g[a][0] * phi[1] + g[a][1] * phi[2];
    }
    return sum;
}

/* In-plane stiffness of the rule's v_l against phi e_a, of the isotropic law without Poisson's
 * coupling. */
static double energy(const struct solved *s, int l, int a, int linear, int k)
{
    double sum = 0;
    for (int p = 0; p < s->rule->rule.points; p++) {
        const struct hobe_section_point *at = s->rule->point + p;
        const double E = at->weight * hobe_section_E(s->section, at->region);
        const double *y = at->f[HOBE_V1Y + 2 * l], *z = at->f[HOBE_V1Z + 2 * l];
        double phi[3] = {0, !k, k};
        if (!linear)
            quadratic(k, at->y, at->z, phi);
        sum += a ? E * (z[2] * phi[2] + (y[2] + z[1]) * phi[1] / 2)
                 : E * (y[1] * phi[1] + (y[2] + z[1]) * phi[2] / 2);
    }
    return sum;
}

/* The weak form against six quadratic fields: K(v, phi) is the same multiple of the load's work on
 * each.  Not for sections of two axes of symmetry, where the load does no such work.  Returns the
 * multiple. */
static double equilibrium(const struct solved *s, int l)
{
    double done[6], stored[6];
    int most = 0;
    for (int k = 0; k < 6; k++) {
        done[k] = work(s, l, k % 2, 0, k / 2);
        stored[k] = energy(s, l, k % 2, 0, k / 2);
        most = fabs(done[k]) > fabs(done[most]) ? k : most;
    }
    for (int k = 0; k < 6; k++)
        check_absolute(stored[k] / stored[most], done[k] / done[most], 1e-8,
                       "%s: equilibrium of v%d, field %d", s->name, l + 1, k);
    return done[most] / stored[most];
}

/* v_l as it was solved: the rule's, which has no part in y and z, times `size`, and a linear field
 * whose strain is the mean one, which the load gives, and which leaves no mean rotation. */
static void complete(struct solved *s, int l, double size)
{
    double L[2][2];
    for (int a = 0; a < 2; a++)
        L[a][a] = (work(s, l, a, 1, a) - size * energy(s, l, a, 1, a)) / s->E;
    const double shear = 2 * (work(s, l, 0, 1, 1) - size * energy(s, l, 0, 1, 1)) / s->E;
    L[0][1] = (shear * s->yy + (L[1][1] - L[0][0]) * s->yz) / (s->yy + s->zz);
    L[1][0] = shear - L[0][1];
    for (int p = 0; p < s->rule->rule.points; p++)
        for (int a = 0; a < 2; a++) {
            const struct hobe_section_point *at = s->rule->point + p;
            double *v = s->v[p][l][a];
            for (int k = 0; k < 3; k++)
                v[k] = size * at->f[HOBE_V1Y + 2 * l + a][k] + (k ? L[a][k - 1] : 0);
            v[0] += L[a][0] * at->y + L[a][1] * at->z;
        }
}

/* ww, w1, w2, w3 and w2t against the quadratic functions: int G grad f . grad phi is the work of
 * their source and flux. */
static void warpings(const struct solved *s)
{
    for (int f = 0; f < WARPINGS; f++)
        for (int k = 0; k < 3; k++) {
            double left = 0, right = 0, size = 0;
            for (int p = 0; p < s->rule->rule.points; p++) {
                const struct hobe_section_point *at = s->rule->point + p;
                const double E = at->weight * hobe_section_E(s->section, at->region);
                const double G = at->weight * hobe_section_G(s->section, at->region);
                const double turn[2] = {s->centre[1] - at->z, at->y - s->centre[0]};
                const double *w = at->f[HOBE_WW + f];
                double(*v)[2][3] = s->v[p], phi[3], F[2];
                quadratic(k, at->y, at->z, phi);
                for (int a = 0; a < 2; a++) {
                    const double flux[WARPINGS] = {0, v[0][a][0], v[1][a][0], v[2][a][0],
                                                   (a ? v[1][0][0] : -v[1][1][0]) +
                                                       turn[0] * v[1][0][1 + a] +
                                                       turn[1] * v[1][1][1 + a]};
                    F[a] = flux[f];
                }
                left += G * (w[1] * phi[1] + w[2] * phi[2]);
                right += G * (F[0] * phi[1] + F[1] * phi[2]);
                right += f ? 0 : E * at->f[HOBE_W][0] * phi[0];
                size += fabs(G * (w[1] * phi[1] + w[2] * phi[2]));
            }
            check_absolute(left, right, 1e-8 * size, "%s: %s, function %d", s->name,
                           names[HOBE_WW + f], k);
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
    struct solved s = {.name = name, .section = section, .rule = &rule};
    s.v = calloc((size_t)rule.rule.points, sizeof *s.v);
    orthogonal(name, section, &rule);
    moments(&s);
    for (int l = 0; l < PAIRS; l++)
        complete(&s, l, equilibrium(&s, l));
    warpings(&s);
    free(s.v);
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
 * outline is 1.4 % too fast on both. */
static void frequencies(void)
{
    const struct hobe_profile_sizes sizes = {
        .height = 0.215, .width = 0.1, .flange = 0.015, .web = 0.01};
    struct hobe_error err;
    hobe_section *I =
        checked(hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err), &err);
    hobe_section *hollow =
        checked(hobe_section_hollow(0.16, 0.08, 0.01, HOBE_WARPING_SOLVED, &err), &err);
    check_relative(torsion("MGD30d", I, 210e9), 282.3, 1.5e-3, "torsion of the I");
    check_relative(torsion("MGD30d", hollow, 1e9), 132.1, 1e-3, "torsion of the hollow beam");
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
