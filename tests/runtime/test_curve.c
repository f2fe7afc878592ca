/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves by arc length against closed forms, and the sentences about what is no curve. */
#include "check.h"
#include "hobe.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double no_up[3];

/* Position and axes at a place of a curve. */
struct place {
    double r[3], e[3][3], e_x[3][3];
};

static struct place look(const hobe_curve *curve, const double up[3], double at)
{
    struct place p;
    struct hobe_error err = {0};
    if (hobe_curve_at(curve, up, at, p.r, p.e, p.e_x, &err))
        check_stop("at %g: %s", at, err.message);
    return p;
}

/* Tolerance: relative to the size for r, to the curvature for e_x; `steep` is 1 over the sine of
 * the angle between curve and up, by which e_y and e_z are worse known than the curve's tangent. */
static void check_place(const struct place *p, const struct place *expected, double size,
                        double steep, double curvature, const char *what)
{
    for (int a = 0; a < 3; a++) {
        check_absolute(p->r[a], expected->r[a], 1e-12 * size, "%s: r[%d]", what, a);
        for (int i = 0; i < 3; i++) {
            check_absolute(p->e[i][a], expected->e[i][a], 1e-12 * steep, "%s: e[%d][%d]", what, i,
                           a);
            /* second derivatives of a series lose digits at its ends */
            check_absolute(p->e_x[i][a], expected->e_x[i][a], 1e-10 * curvature, "%s: e'[%d][%d]",
                           what, i, a);
        }
    }
}

static hobe_curve *must(hobe_curve *curve, const struct hobe_error *err)
{
    return curve ? curve : (check_stop("%s", err->message), NULL);
}

/* ---- helices --------------------------------------------------------------------------------- */

/* About Z: {R cos p, R sin p, H p}, p from `start` over `angle`, the parameter bent by `bend`. */
struct helix {
    double R, H, start, angle, bend;
    double twist[3]; /* phi = [0] + [1] at + [2] sin(3 at) */
};

static enum hobe_status helix_point(void *context, double t, double *r, struct hobe_error *err)
{
    const struct helix *h = context;
    const double p = h->start + h->angle * (t + h->bend * t * (1 - t));
    (void)err;
    r[0] = h->R * cos(p);
    r[1] = h->R * sin(p);
    r[2] = h->H * p;
    return HOBE_OK;
}

static enum hobe_status helix_twist(void *context, double at, double *phi, struct hobe_error *err)
{
    const double *twist = ((const struct helix *)context)->twist;
    (void)err;
    *phi = twist[0] + twist[1] * at + twist[2] * sin(3 * at);
    return HOBE_OK;
}

/* With up = Z the axes are Frenet's: e_y along the normal {-cos p, -sin p, 0}, or against it. */
static struct place helix_place(const struct helix *h, double at)
{
    const double norm = hypot(h->R, h->H), u = h->R / norm, v = h->H / norm;
    const double sign = copysign(1, h->angle), p = h->start + at * h->angle;
    const double c = cos(p), s = sin(p), n = -1 / norm;
    const struct place untwisted = {
        {h->R * c, h->R * s, h->H * p},
        {{-sign * u * s, sign * u * c, sign * v}, {-sign * c, -sign * s, 0}, {v * s, -v * c, u}},
        {{u * n * c, u * n * s, 0}, {-n * s, n * c, 0}, {-sign * v * n * c, -sign * v * n * s, 0}}};
    const double phi = h->twist[0] + h->twist[1] * at + h->twist[2] * sin(3 * at);
    const double phi_x = (h->twist[1] + 3 * h->twist[2] * cos(3 * at)) / fabs(h->angle) / norm;
    const double(*e)[3] = untwisted.e, (*e_x)[3] = untwisted.e_x;
    struct place twisted = untwisted;
    for (int a = 0; a < 3; a++) {
        twisted.e[1][a] = cos(phi) * e[1][a] + sin(phi) * e[2][a];
        twisted.e[2][a] = -sin(phi) * e[1][a] + cos(phi) * e[2][a];
        twisted.e_x[1][a] = cos(phi) * e_x[1][a] + sin(phi) * e_x[2][a] + phi_x * twisted.e[2][a];
        twisted.e_x[2][a] = -sin(phi) * e_x[1][a] + cos(phi) * e_x[2][a] - phi_x * twisted.e[1][a];
    }
    return twisted;
}

static void test_helix(struct helix h, const char *what)
{
    struct hobe_error err = {0};
    hobe_curve *curve = must(hobe_curve_function(helix_point, &h, &err), &err);
    const double norm = hypot(h.R, h.H);
    const double size = h.R + fabs(h.H) * (fabs(h.start) + fabs(h.angle));
    check_relative(hobe_curve_length(curve), fabs(h.angle) * norm, 1e-13, "%s: length", what);
    check_that(!hobe_curve_twist(curve, helix_twist, &h, &err), "%s", err.message);
    for (int i = 0; i <= 30; i++) {
        const double at = i < 21 ? i / 20. : random_real(0, 1);
        const struct place p =
            look(curve, i % 2 ? no_up : (const double[3]){0, 0, 3}, i == 21 ? 1 : at);
        const struct place expected = helix_place(&h, i == 21 ? 1 : at);
        check_place(&p, &expected, size, norm / h.R, (fabs(h.angle) + 10) / norm, what);
    }
    hobe_curve_free(curve);
}

static void test_helices(void)
{
    test_helix((struct helix){2, 0, 0, M_PI / 2, 0, {0}}, "arc");
    test_helix((struct helix){1000, 0, 1, 2 * M_PI, .5, {0}}, "circle, bent parameter");
    test_helix((struct helix){.3, .1, .7, -6 * M_PI, .3, {0}}, "helix");
    test_helix((struct helix){.3, .1, .7, 40 * M_PI, 0, {0}}, "20 turns");
    for (int i = 0; i < 10; i++)
        test_helix((struct helix){random_real(.1, 1),
                                  random_real(-1, 1),
                                  random_real(-3, 3),
                                  copysign(random_real(1, 9), random_real(-1, 1)),
                                  random_real(-.5, .5),
                                  {random_real(-3, 3), random_real(-9, 9), random_real(-3, 3)}},
                   "twisted helix");
}

/* ---- any curve, any direction up ------------------------------------------------------------- */

/* Axes are orthonormal, e_z as near to `up` as can be, and the derivatives those of differences,
 * over 2 h = 2e-5 of the length, whose error is of the order of h^2 and of rounding over h. */
static void check_axes(const hobe_curve *curve, const double up[3], double at)
{
    const double h = 1e-5, length = hobe_curve_length(curve);
    const struct place p = look(curve, up, at), a = look(curve, up, at - h),
                       b = look(curve, up, at + h);
    double triple = 0, side = 0, top = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        triple += p.e[0][i] * (p.e[1][j] * p.e[2][k] - p.e[1][k] * p.e[2][j]);
        side += p.e[1][i] * up[i];
        top += p.e[2][i] * up[i];
        check_absolute((b.r[i] - a.r[i]) / (2 * h * length), p.e[0][i], 1e-7, "tangent");
        for (int n = 0; n < 3; n++) {
            double product = 0, turning = 0;
            for (int m = 0; m < 3; m++) {
                product += p.e[i][m] * p.e[n][m];
                turning += p.e[i][m] * p.e_x[n][m] + p.e_x[i][m] * p.e[n][m];
            }
            check_absolute(product, i == n, 1e-14, "e[%d] . e[%d]", i, n);
            check_absolute(turning * length, 0, 1e-9, "(e[%d] . e[%d])'", i, n);
            check_absolute((b.e[n][i] - a.e[n][i]) / (2 * h), length * p.e_x[n][i], 1e-4, "e'");
        }
    }
    check_absolute(triple, 1, 1e-14, "right-handed");
    check_absolute(side, 0, 1e-14, "e_y is normal to up");
    check_that(top > 0, "e_z is on the side of up");
}

static void test_axes(void)
{
    for (int n = 0; n < 20; n++) {
        struct helix h = {1, random_real(-1, 1), random_real(-3, 3), 2, random_real(-.5, .5), {0}};
        double up[3], across = 1, points[6][3];
        struct hobe_error err = {0};
        hobe_curve *smooth = must(hobe_curve_function(helix_point, &h, &err), &err);
        for (int i = 0; i < 6; i++)
            helix_point(&h, i / 5., points[i], &err);
        hobe_curve *spline = must(hobe_curve_points(6, (const double(*)[3])points, &err), &err);
        do { /* near the tangent derivatives grow beyond the differences' tolerance */
            random_direction(up);
            across = 1;
            for (int i = 0; i <= 20; i++) {
                const struct place p = look(smooth, no_up, i / 20.);
                const double along = up[0] * p.e[0][0] + up[1] * p.e[0][1] + up[2] * p.e[0][2];
                across = fmin(across, sqrt(1 - along * along));
            }
        } while (across < 0.4);
        for (int i = 0; i < 5; i++) {
            check_axes(smooth, up, random_real(0.01, 0.99));
            check_axes(spline, up, random_real(0.01, 0.99));
        }
        hobe_curve_free(smooth);
        hobe_curve_free(spline);
    }
}

/* ---- an uneven parametrisation ----------------------------------------------------------------
 */

static enum hobe_status ellipse(void *context, double t, double *r, struct hobe_error *err)
{
    (void)err;
    r[0] = cos(2 * M_PI * t);
    r[1] = *(const double *)context * sin(2 * M_PI * t);
    r[2] = 5;
    return HOBE_OK;
}

/* The perimeter by arithmetic-geometric means (Abramowitz & Stegun 17.6). */
static double perimeter(double b)
{
    double mean = 1, root = b, sum = (1 - b * b) / 2;
    for (double power = 1; mean - root > 1e-15; power *= 2) {
        const double half = (mean - root) / 2, next = (mean + root) / 2;
        root = sqrt(mean * root);
        mean = next;
        sum += power * half * half;
    }
    return 2 * M_PI / mean * (1 - sum);
}

static void test_ellipses(void)
{
    for (int i = 0; i < 3; i++) {
        const double b = (const double[]){.9, .1, .01}[i];
        struct hobe_error err = {0};
        hobe_curve *curve = must(hobe_curve_function(ellipse, (void *)&b, &err), &err);
        check_relative(hobe_curve_length(curve), perimeter(b), 1e-13, "ellipse of axes 1, %g", b);
        const struct place p = look(curve, no_up, .25), q = look(curve, no_up, .5);
        const double quarter[3] = {0, b, 5}, half[3] = {-1, 0, 5};
        for (int a = 0; a < 3; a++) {
            check_absolute(p.r[a], quarter[a], 1e-12, "a quarter of it, b = %g", b);
            check_absolute(q.r[a], half[a], 1e-12, "half of it, b = %g", b);
        }
        hobe_curve_free(curve);
    }
}

/* ---- splines ----------------------------------------------------------------------------------
 */

static void test_line(void)
{
    double r[2][3], d[3], up[3];
    struct hobe_error err = {0};
    const double length = random_real(1, 5);
    random_direction(d);
    random_direction(up);
    for (int a = 0; a < 3; a++) {
        r[0][a] = random_real(-1, 1);
        r[1][a] = r[0][a] + length * d[a];
    }
    hobe_curve *curve = must(hobe_curve_points(2, (const double(*)[3])r, &err), &err);
    check_relative(hobe_curve_length(curve), length, 1e-14, "length of a line");
    for (int i = 0; i <= 4; i++) {
        const struct place p = look(curve, up, i / 4.);
        for (int a = 0; a < 3; a++) {
            check_absolute(p.r[a], r[0][a] + i / 4. * length * d[a], 1e-14, "r");
            check_absolute(p.e[0][a], d[a], 1e-14, "tangent");
            for (int n = 0; n < 3; n++)
                check_absolute(p.e_x[n][a], 0, 1e-13, "a line's axes stand");
        }
    }
    hobe_curve_free(curve);
}

/* Where no `up` is given, a line along Z has global -X, a line down X, and others Z. */
static void test_default_up(void)
{
    static const double to[3][3] = {{0, 0, 2}, {0, 0, -2}, {1, 0, 2}};
    for (int i = 0; i < 3; i++) {
        struct hobe_error err = {0};
        const double r[2][3] = {{0, 0, 0}, {to[i][0], to[i][1], to[i][2]}};
        hobe_curve *curve = must(hobe_curve_points(2, r, &err), &err);
        const struct place p = look(curve, no_up, .5);
        check_absolute(p.e[1][1], 1, 1e-15, "e_y is Y");
        check_that(i == 2 ? p.e[2][2] > 0 : p.e[2][0] * to[i][2] < 0, "e_z of line %d", i);
        hobe_curve_free(curve);
    }
}

/* A few points at equal chords: the slopes at the ends are those of finite differences.  (Up to
 * four points lie on one cubic, which the spline must be, as test_parabola sees.) */
static void test_few_points(void)
{
    static const double weight[3][5] = {{-3, 4, -1}, {-11, 18, -9, 2}, {-25, 48, -36, 16, -3}};
    for (int i = 0; i < 20; i++) {
        const int n = 3 + i % 3;
        double r[5][3] = {{0}}, d[3], slope[2][3] = {{0}}, norm[2];
        struct hobe_error err = {0};
        for (int k = 1; k < n; k++) {
            random_direction(d);
            d[0] += 2;
            norm[0] = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            for (int a = 0; a < 3; a++)
                r[k][a] = r[k - 1][a] + d[a] / norm[0];
        }
        for (int k = 0; k < n; k++)
            for (int a = 0; a < 3; a++) {
                slope[0][a] += weight[n - 3][k] * r[k][a];
                slope[1][a] -= weight[n - 3][k] * r[n - 1 - k][a];
            }
        hobe_curve *curve = must(hobe_curve_points(n, (const double(*)[3])r, &err), &err);
        for (int end = 0; end < 2; end++) {
            const struct place p = look(curve, no_up, end);
            const double *s = slope[end];
            norm[end] = sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
            for (int a = 0; a < 3; a++) {
                check_absolute(p.e[0][a], s[a] / norm[end], 1e-13, "%d points, end %d", n, end);
                check_absolute(p.r[a], r[end * (n - 1)][a], 1e-14, "%d points, end %d", n, end);
            }
        }
        hobe_curve_free(curve);
    }
}

static void test_parabola(void)
{
    static const double r[3][3] = {{-1, 0, 1}, {0, 0, 0}, {1, 0, 1}};
    struct hobe_error err = {0};
    hobe_curve *curve = must(hobe_curve_points(3, r, &err), &err);
    check_relative(hobe_curve_length(curve), sqrt(5) + asinh(2) / 2, 1e-13, "length");
    const struct place p = look(curve, no_up, .5);
    check_absolute(p.r[0], 0, 1e-13, "the vertex");
    check_absolute(p.e_x[0][2], 2, 1e-12, "its curvature");
    hobe_curve_free(curve);
}

/* Largest error of position on a circle of radius 1 through n equal points. */
static double circle_error(int n)
{
    struct hobe_error err = {0};
    struct helix h = {1, 0, 0, 2 * M_PI, 0, {0}};
    double(*r)[3] = calloc((size_t)n, sizeof *r), error = 0;
    for (int i = 0; i < n; i++)
        helix_point(&h, i / (n - 1.), r[i], NULL);
    hobe_curve *curve = must(hobe_curve_points(n, (const double(*)[3])r, &err), &err);
    free(r);
    for (int i = 0; i <= 100; i++) {
        const struct place p = look(curve, no_up, i / 100.);
        const double angle = 2 * M_PI * i / 100;
        error = fmax(error, hypot(p.r[0] - cos(angle), p.r[1] - sin(angle)));
    }
    hobe_curve_free(curve);
    return error;
}

static void test_circle(void)
{
    const double coarse = circle_error(33), fine = circle_error(65);
    check_that(coarse < 1e-5, "33 points: %g", coarse);
    check_that(coarse > 12 * fine, "the fourth power of the distance: %g, %g", coarse, fine);
    check_absolute(circle_error(10000), 0, 1e-12, "as many points as there may be");
}

/* ---- what is no curve -------------------------------------------------------------------------
 */

enum shape { CONSTANT, CUSP, SLOW, KINK, NOT_FINITE, OWN };

static enum hobe_status odd_shape(void *context, double t, double *r, struct hobe_error *err)
{
    const enum shape shape = *(const enum shape *)context;
    const double x = t - .3;
    r[0] = shape == CONSTANT ? 1 : shape == CUSP ? x * x : shape == SLOW ? x * x * x : x;
    r[1] = shape == CONSTANT ? 2 : shape == KINK ? fabs(x) : shape == CUSP ? x * x * x : 0;
    r[2] = shape == NOT_FINITE && t < .1 ? NAN : 0;
    return shape == OWN ? hobe_fail(err, HOBE_UNKNOWN, NULL, "my own") : HOBE_OK;
}

static void check_sentence(hobe_curve *curve, const struct hobe_error *err, enum hobe_status status,
                           const char *part)
{
    check_that(!curve && err->status == status && strstr(err->message, part), "\"%s\": \"%s\"",
               part, err->message);
    hobe_curve_free(curve);
}

static void test_bad_functions(void)
{
    static const char *const part[] = {[CONSTANT] = "stands still, or turns back, near t = ",
                                       [CUSP] = "near t = 0.3 at {",
                                       [SLOW] = "near t = 0.3 at {",
                                       [KINK] = "near curve(0.",
                                       [NOT_FINITE] = " must be finite, got nan",
                                       [OWN] = "my own"};
    for (enum shape shape = CONSTANT; shape <= OWN; shape++) {
        struct hobe_error err = {0};
        hobe_curve *curve = hobe_curve_function(odd_shape, &shape, &err);
        check_sentence(curve, &err, shape == OWN ? HOBE_UNKNOWN : HOBE_BAD_INPUT, part[shape]);
        check_that(!hobe_curve_function(odd_shape, &shape, NULL), "no err wanted");
    }
}

static void test_bad_points(void)
{
    static const struct {
        int n;
        double r[4][3];
        const char *part;
    } bad[] = {
        {0, {{0}}, "needs 2 to 10000 points, got 0"},
        {1, {{0}}, "needs 2 to 10000 points, got 1"},
        {10001, {{0}}, "got 10001"},
        {2, {{1, 2, 3}, {1, 2, 3}}, "points 1 and 2 of the curve must differ, both are {1, "},
        {3, {{0}, {1}, {1, 1e-12}}, "points 2 and 3 of the curve must differ"},
        {3, {{0}, {1, 2, INFINITY}, {1}}, "point 2 of the curve must be finite, got {1, 2, i"},
        {2, {{-1e308}, {1e308}}, "longer than a number can say"},
        {3, {{0}, {1}, {0}}, "turns back, near t = 0.5 at {1, 0, 0}"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct hobe_error err = {0};
        hobe_curve *curve = hobe_curve_points(bad[i].n, bad[i].r, &err);
        check_sentence(curve, &err, HOBE_BAD_INPUT, bad[i].part);
    }
}

static enum hobe_status no_twist(void *context, double at, double *phi, struct hobe_error *err)
{
    (void)context;
    *phi = at;
    return hobe_fail(err, HOBE_UNKNOWN, NULL, "no twist at %g", at);
}

static void test_bad_places(void)
{
    static const double line[2][3] = {{0}, {1}};
    static const struct {
        double at, up[3];
        const char *part;
    } bad[] = {{-1e-9, {0}, "from 0 to 1, got -1e-09"},
               {1.5, {0}, "got 1.5"},
               {NAN, {0}, "got nan"},
               {.25, {2}, "up = {2, 0, 0} points along the curve at 0.25 of its length"},
               {.25, {0, NAN}, "up = {0, nan, 0}"}};
    struct hobe_error err = {0};
    struct place p;
    hobe_curve *curve = must(hobe_curve_points(2, line, &err), &err);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        check_that(hobe_curve_at(curve, bad[i].up, bad[i].at, p.r, p.e, p.e_x, &err) ==
                           HOBE_BAD_INPUT &&
                       strstr(err.message, bad[i].part),
                   "\"%s\": \"%s\"", bad[i].part, err.message);
    check_that(hobe_curve_twist(curve, no_twist, NULL, &err) == HOBE_UNKNOWN, "twist's own");
    hobe_curve_free(curve);
    hobe_curve_free(NULL);
}

int main(void)
{
    random_start();
    test_helices();
    test_axes();
    test_ellipses();
    test_line();
    test_default_up();
    test_few_points();
    test_parabola();
    test_circle();
    test_bad_functions();
    test_bad_points();
    test_bad_places();
    return check_report();
}
