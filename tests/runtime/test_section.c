/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rectangles: areas and moments, Saint-Venant's torsion constant, and the warping function as the
 * solution of its boundary value problem. */
#include "check.h"
#include "hobe.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Torsion constants J = beta a b^3, Timoshenko & Goodier, and more digits of the same series. */
static void torsion_constants(void)
{
    static const double table[][2] = {
        {1, .14057701}, {1.5, .19576071}, {2, .22868168}, {3, .26331693}, {10, .31232504}};
    for (int i = 0; i < 5; i++)
        for (int turned = 0; turned < 2; turned++) {
            const double b = 0.07, a = table[i][0] * b;
            hobe_section *section = turned ? rectangle(b, a) : rectangle(a, b);
            const struct hobe_section_properties p = properties_of(section);
            const double beta = p.J / (a * pow(b, 3));
            /* half of the table's last digit */
            check_absolute(beta, table[i][1], 0.5001e-8, "beta of %g : 1", table[i][0]);
            hobe_section_free(section);
        }
}

static void areas_and_moments(void)
{
    const double W = 0.3, H = 0.7;
    hobe_section *section = rectangle(W, H);
    const struct hobe_section_properties p = properties_of(section);
    check_relative(p.A, W * H, 1e-15, "area");
    check_relative(p.Iyy, W * pow(H, 3) / 12, 1e-14, "Iyy = int z^2 dA");
    check_relative(p.Izz, H * pow(W, 3) / 12, 1e-14, "Izz = int y^2 dA");
    check_that(p.Iyz == 0, "Iyz of a rectangle is 0");
    check_that(p.width == W && p.height == H, "width along y, height along z");
    check_that(strstr(hobe_section_text(section), "0.3") != NULL, "the text names the size: %s",
               hobe_section_text(section));
    hobe_section_free(section);
}

/* With Saint-Venant's function J_w is J.  What is left is the cubature near the corners, where the
 * second derivatives of w have a logarithm: some 1e-10 of J.  J_w is the difference of I_p and
 * b^2/c, so that the error grows with I_p/J, which is 2500 at 1 : 100. */
static void warping_gives_torsion_constant(void)
{
    static const double sizes[][2] = {{1, 1},   {1, 1.5}, {2, 1},  {1, 3},  {3.2024, 12.377},
                                      {1, 3.9}, {1, 4.1}, {1, 10}, {10, 1}, {1, 30},
                                      {30, 1},  {1, 100}, {100, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const double *s = sizes[i], ratio = fmax(s[0] / s[1], s[1] / s[0]);
        hobe_section *section = rectangle(s[0] * 1e-3, s[1] * 1e-3);
        const struct hobe_section_properties p = properties_of(section);
        printf("rectangle %7g : %-7g J_w/J - 1 = %9.2e\n", s[0], s[1], p.J_w / p.J - 1);
        check_relative(p.J_w, p.J, ratio > 50 ? 5e-8 : 1e-8, "J_w of %g x %g", s[0], s[1]);
        hobe_section_free(section);
    }
}

static void paper_term(void)
{
    struct hobe_error err;
    hobe_section *section = hobe_section_rectangle(3.2024e-3, 12.377e-3, HOBE_WARPING_PAPER, &err);
    if (!section)
        check_stop("%s", err.message);
    const struct hobe_section_properties p = properties_of(section);
    /* 1.162 in the text: three decimals */
    check_absolute(p.J_w / p.J, 1.162, 0.5e-3, "one term on the Princeton section");
    hobe_section_free(section);
}

static double omega(const hobe_section *section, double y, double z)
{
    double f[3];
    struct hobe_error err;
    if (hobe_section_function(section, "w", y, z, f, &err))
        check_stop("%s", err.message);
    return f[0];
}

/* Beyond the outline w is that of the nearest point, also far away. */
static void beyond(const hobe_section *section, double W, double H)
{
    const double far = 20 * fmax(W, H), y = random_real(-.5, .5) * W, z = random_real(-.5, .5) * H;
    check_that(omega(section, far, z) == omega(section, W / 2, z), "w right of the rectangle");
    check_that(omega(section, y, -far) == omega(section, y, -H / 2), "w below the rectangle");
    check_that(omega(section, far, far) == omega(section, W / 2, H / 2), "w off its corner");
}

static void gradient(const hobe_section *section, double y, double z, double f[3])
{
    struct hobe_error err;
    if (hobe_section_function(section, "w", y, z, f, &err))
        check_stop("%s", err.message);
}

/* Fourth-order differences of the values agree with the gradient, and the differences of the
 * gradient with Laplace's equation. */
static void interior(const hobe_section *section, double W, double H)
{
    const double b = fmin(W, H), h = 1e-3 * b;
    for (int i = 0; i < 40; i++) {
        /* a tenth of the short side off the edges: near corners the derivatives grow */
        const double y = random_real(-1, 1) * (W / 2 - b / 10);
        const double z = random_real(-1, 1) * (H / 2 - b / 10);
        double f[3], wy[4][3], wz[4][3];
        static const double at[4] = {-2, -1, 1, 2}, weight[4] = {1, -8, 8, -1};
        double dy = 0, dz = 0, laplace = 0;
        gradient(section, y, z, f);
        for (int k = 0; k < 4; k++) {
            gradient(section, y + at[k] * h, z, wy[k]);
            gradient(section, y, z + at[k] * h, wz[k]);
            dy += weight[k] / (12 * h) * wy[k][0];
            dz += weight[k] / (12 * h) * wz[k][0];
            laplace += weight[k] / (12 * h) * (wy[k][1] + wz[k][2]);
        }
        /* truncation (h/b)^4 times fifth derivatives, round-off 1e-16 b/h */
        check_absolute(dy, f[1], 1e-9 * fmax(W, H), "dw/dy at (%g, %g)", y, z);
        check_absolute(dz, f[2], 1e-9 * fmax(W, H), "dw/dz at (%g, %g)", y, z);
        check_absolute(laplace, 0, 1e-8, "Laplace's equation at (%g, %g)", y, z);
    }
}

/* No shear on the free sides: omega_y = -z at y = +-W/2 and omega_z = y at z = +-H/2, so that
 * r_w = -kappa e_x: u_x = -kappa w turns omega's sign of the usual one. */
static void sides(const hobe_section *section, double W, double H)
{
    const double a = fmax(W, H), b = fmin(W, H);
    for (int i = 0; i < 40; i++) {
        const double side = i % 2 ? 1 : -1;
        double y = side * W / 2, z = random_real(-1, 1) * (H / 2 - 0.05 * b), f[3];
        gradient(section, y, z, f);
        /* The flux of the series converges like 1/N^2 on the sides it is summed along (150 terms:
         * 1e-5 away from the corners), and holds by construction, to round-off, on the others. */
        check_absolute(f[1], -z, W < H ? 1e-14 * a : 1e-4 * b, "w_y = -z at (%g, %g)", y, z);
        y = random_real(-1, 1) * (W / 2 - 0.05 * b);
        z = side * H / 2;
        gradient(section, y, z, f);
        check_absolute(f[2], y, W < H ? 1e-4 * b : 1e-14 * a, "w_z = y at (%g, %g)", y, z);
    }
}

/* w is odd in y and in z, and w of the turned rectangle is -w with y and z exchanged. */
static void symmetry(const hobe_section *section, double W, double H)
{
    hobe_section *turned = rectangle(H, W);
    for (int i = 0; i < 40; i++) {
        const double y = random_real(-W / 2, W / 2), z = random_real(-H / 2, H / 2);
        const double w = omega(section, y, z), size = W * H;
        check_absolute(omega(section, -y, z), -w, 1e-15 * size, "odd in y");
        check_absolute(omega(section, y, -z), -w, 1e-15 * size, "odd in z");
        /* a square uses the same series twice: the sine along the other side, whose tail differs */
        check_absolute(omega(turned, z, y), -w, (W == H ? 1e-7 : 1e-14) * size, "turned");
    }
    hobe_section_free(turned);
}

static void warping_function(double W, double H)
{
    hobe_section *section = rectangle(W, H);
    interior(section, W, H);
    sides(section, W, H);
    symmetry(section, W, H);
    beyond(section, W, H);
    hobe_section_free(section);
}

static void refusals(void)
{
    static const double bad[] = {0, -0.1, NAN, INFINITY, -INFINITY};
    struct hobe_error err;
    for (int i = 0; i < 5; i++)
        for (int side = 0; side < 2; side++) {
            err = (struct hobe_error){0};
            hobe_section *section = hobe_section_rectangle(side ? 0.1 : bad[i], side ? bad[i] : 0.1,
                                                           HOBE_WARPING_SERIES, &err);
            char value[40];
            snprintf(value, sizeof value, "%g", bad[i]);
            check_that(!section && err.status == HOBE_BAD_INPUT && strstr(err.message, value) &&
                           !strchr(err.message, '\n'),
                       "a side of %g is refused: %s", bad[i], err.message);
            hobe_section_free(section);
        }
    hobe_section *section = rectangle(1, 1);
    double f[3];
    check_that(hobe_section_function(section, "v", 0, 0, f, &err) == HOBE_UNKNOWN &&
                   strstr(err.message, " v"),
               "an unknown section function is refused: %s", err.message);
    check_that(hobe_section_rectangle(-1, 1, HOBE_WARPING_SERIES, NULL) == NULL,
               "without an error to write to");
    hobe_section_free(section);
    hobe_section_free(NULL);
}

int main(void)
{
    random_start();
    areas_and_moments();
    torsion_constants();
    warping_gives_torsion_constant();
    paper_term();
    warping_function(0.1, 0.1);
    warping_function(3.2024e-3, 12.377e-3);
    warping_function(0.2, 0.02);
    refusals();
    return check_report();
}
