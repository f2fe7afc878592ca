/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tapers of outlines, whose functions are solved on a mesh that moves, against the closed forms of
 * rectangles, against sections made at a place, and by scaling. */
#include "check.h"
#include "scene.h"
#include "section.h"

#include <math.h>
#include <stdio.h>

static const double LENGTH = 2; /* of the beam, m */

static hobe_section *rectangle_outline(double W, double H)
{
    const double y = W / 2, z = H / 2, corner[4][2] = {{-y, -z}, {y, -z}, {y, z}, {-y, z}};
    struct hobe_error err;
    hobe_section *section = hobe_section_polygon(1, (const int[]){4}, corner, &err);
    if (!section)
        check_stop("%s", err.message);
    return section;
}

static hobe_section *profile(double height, double width)
{
    const struct hobe_profile_sizes sizes = {
        .height = height, .width = width, .flange = 0.015, .web = 0.01};
    struct hobe_error err;
    hobe_section *section = hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    return section;
}

/* The taper between two sections, which it frees. */
static hobe_section *between(hobe_section *from, hobe_section *to)
{
    struct hobe_error err;
    hobe_section *taper = hobe_section_linear(from, to, &err);
    if (!taper)
        check_stop("%s", err.message);
    hobe_section_free(from);
    hobe_section_free(to);
    return taper;
}

static struct hobe_rule rule_of(const hobe_section *section, double at)
{
    const struct hobe_section_place place = {at, LENGTH};
    struct hobe_rule rule;
    struct hobe_error err;
    if (hobe_section_rule(section, hobe_find_kernel("MGD30w3", NULL), HOBE_INTEGRATION_EXACT,
                          &place, &rule, &err))
        check_stop("%s", err.message);
    return rule;
}

/* int f_i^2, int f_i,x^2 and int f_i f_i,x over the section: [3][3]. */
static void moments(const hobe_section *section, double at, double m[3][3])
{
    struct hobe_rule rule = rule_of(section, at);
    for (int i = 0; i < 3; i++) {
        m[i][0] = m[i][1] = m[i][2] = 0;
        for (int p = 0; p < rule.rule.points; p++) {
            const struct hobe_section_point *point = rule.point + p;
            const double f = point->f[i][0], fx = point->f[i][3];
            m[i][0] += point->weight * f * f;
            m[i][1] += point->weight * fx * fx;
            m[i][2] += point->weight * f * fx;
        }
    }
    hobe_rule_free(&rule);
}

/* Finite elements against the series: their own error, 1e-4 of w and of its derivative. */
static void against_rectangle(void)
{
    struct hobe_error err;
    hobe_section *solved = between(rectangle_outline(0.1, 0.2), rectangle_outline(0.12, 0.08));
    hobe_section *series = between(hobe_section_rectangle(0.1, 0.2, HOBE_WARPING_SERIES, &err),
                                   hobe_section_rectangle(0.12, 0.08, HOBE_WARPING_SERIES, &err));
    for (int k = 0; k < 5; k++) {
        const double at = random_real(0, 1);
        double a[3][3], b[3][3];
        moments(solved, at, a);
        moments(series, at, b);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const double size = j < 2 ? b[i][j] : sqrt(b[i][0] * b[i][1]);
                check_absolute(a[i][j], b[i][j], 1e-3 * size, "function %d, moment %d at %g", i, j,
                               at);
            }
    }
    hobe_section_free(solved);
    hobe_section_free(series);
}

/* The section at a place is that of the sizes there, J to the difference of two meshes. */
static void against_section(void)
{
    struct hobe_error err;
    hobe_section *taper = between(profile(0.3, 0.1), profile(0.15, 0.2));
    for (int k = 0; k < 3; k++) {
        const double at = random_real(0, 1);
        hobe_section *here = hobe_section_at(taper, at, &err);
        hobe_section *made = profile(0.3 - 0.15 * at, 0.1 + 0.1 * at);
        const struct hobe_section_properties p = properties_of(here), q = properties_of(made);
        double m[3][3];
        moments(taper, at, m);
        check_relative(p.A, q.A, 1e-12, "area at %g", at);
        check_relative(p.Iyy, q.Iyy, 1e-12, "Iyy at %g", at);
        check_relative(p.J, q.J, 1e-3, "J at %g", at);
        check_relative(m[0][0], q.Iw, 1e-3, "Iw of the moving mesh at %g", at);
        hobe_section_free(here);
        hobe_section_free(made);
    }
    hobe_section_free(taper);
}

/* A section that grows as s(x) in both directions has w = s^2 w1(y/s, z/s), and so
 * w_x = (s'/s)(2 w - y w_y - z w_z); wy and wz likewise with 3.  The mesh inside the outline does
 * not just grow, so that finite elements meet it with their error, 5e-4 at the worst point. */
static void scaling(void)
{
    static const double corner[6][2] = {{0, 0},     {.2, 0},    {.2, .03},
                                        {.04, .05}, {.03, .15}, {0, .15}};
    double twice[6][2];
    struct hobe_error err;
    for (int i = 0; i < 12; i++)
        twice[i / 2][i % 2] = 2 * corner[i / 2][i % 2];
    hobe_section *taper = between(hobe_section_polygon(1, (const int[]){6}, corner, &err),
                                  hobe_section_polygon(1, (const int[]){6}, twice, &err));
    for (int k = 0; k < 3; k++) {
        const double at = random_real(0, 1), rate = 1 / (1 + at) / LENGTH;
        static const int degree[3] = {2, 3, 3};
        struct hobe_rule rule = rule_of(taper, at);
        for (int i = 0; i < 3; i++) {
            double worst = 0, size = 0;
            for (int p = 0; p < rule.rule.points; p++) {
                const struct hobe_section_point *point = rule.point + p;
                const double *f = point->f[i];
                const double exact = rate * (degree[i] * f[0] - point->y * f[1] - point->z * f[2]);
                worst = fmax(worst, fabs(f[3] - exact));
                size = fmax(size, fabs(exact));
            }
            check_absolute(worst, 0, 2e-3 * size, "function %d of a growing section", i);
        }
        hobe_rule_free(&rule);
    }
    hobe_section_free(taper);
}

/* Outlines of another number of points, and one that turns over on the way. */
static void refusals(void)
{
    struct hobe_error err;
    hobe_section *from = rectangle_outline(0.1, 0.2), *to = profile(0.2, 0.1);
    check_that(!hobe_section_linear(from, to, &err), "a rectangle does not become an I");
    printf("%s\n", err.message);
    static const double turned[4][2] = {{.05, .1}, {-.05, .1}, {-.05, -.1}, {.05, -.1}};
    hobe_section *other = hobe_section_polygon(1, (const int[]){4}, turned, &err);
    check_that(other && !hobe_section_linear(from, other, &err), "a section does not shrink to 0");
    printf("%s\n", err.message);
    hobe_section_free(from);
    hobe_section_free(to);
    hobe_section_free(other);
}

int main(void)
{
    random_start();
    against_rectangle();
    against_section();
    scaling();
    refusals();
    return check_report();
}
