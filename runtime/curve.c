/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves by arc length: a parametrisation (Chebyshev series or spline), and a table of panels short
 * enough for Gauss's rule to give the arc length within each to rounding. */
#include "chebyshev.h"
#include "section.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { GAUSS = 8, MOST_POINTS = 10000, MOST_PANELS = 1 << 15, END_POINTS = 5, GRID = 1024 };

/* Of analytic functions this leaves rounding; see hobe_chebyshev_fit. */
static const double fit_tolerance = 1e-11;

/* Of the greatest speed: below, the direction of r_t drowns in rounding. */
static const double least_speed = 1e-6;

struct hobe_curve {
    struct hobe_chebyshev series; /* r(t) of a function; no terms: a spline */
    int intervals;                /* of the spline, or 1 */
    double *knot;                 /* [intervals + 1] t from 0 to 1 */
    double (*point)[3];           /* [intervals + 1][3] of the spline */
    double (*slope)[3];           /* its derivatives by t there */
    struct hobe_chebyshev twist;  /* phi(at); no terms: none */
    double up[3];                 /* where none is given */
    double slow;                  /* the t of least speed, nearly */
    double gauss[GAUSS][2];
    int panels;
    double *t, *s; /* [panels + 1] ends of the panels, and the arc length there, m */
};

/* ---- r(t) ----------------------------------------------------------------------------------- */

/* The interval [x_i, x_(i+1)] of n, ascending, that holds `at`. */
static int find(const double *x, int n, double at)
{
    int low = 0, high = n;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (x[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The cubic with the given values and slopes at the ends of interval i. */
static void hermite(const hobe_curve *c, int i, double t, double d[3][3])
{
    const double h = c->knot[i + 1] - c->knot[i], u = (t - c->knot[i]) / h;
    for (int a = 0; a < 3; a++) {
        const double p = c->point[i][a], chord = c->point[i + 1][a] - p;
        const double m = h * c->slope[i][a], n = h * c->slope[i + 1][a];
        const double square = 3 * chord - 2 * m - n, cube = m + n - 2 * chord;
        d[0][a] = p + u * (m + u * (square + u * cube));
        d[1][a] = (m + u * (2 * square + 3 * u * cube)) / h;
        d[2][a] = (2 * square + 6 * u * cube) / (h * h);
    }
}

/* d = r, r_t and, where two orders are asked for, r_tt. */
static void derivatives(const hobe_curve *c, double t, int orders, double d[3][3])
{
    if (c->point)
        hermite(c, find(c->knot, c->intervals, t), t, d);
    else
        hobe_chebyshev_at(&c->series, t, orders, d[0]);
}

static double speed(const hobe_curve *c, double t)
{
    double d[3][3];
    derivatives(c, t, 1, d);
    return length3(d[1]);
}

/* ---- a parametrisation that moves ----------------------------------------------------------- */

static enum hobe_status fail_still(const hobe_curve *c, double t, struct hobe_error *err)
{
    double d[3][3];
    derivatives(c, t, 1, d);
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "the curve stands still, or turns back, near t = %.3g at {%.3g, %.3g, %.3g}; "
                     "its speed |dr/dt| must not vanish",
                     t, d[0][0], d[0][1], d[0][2]);
}

/* The t in [a,b] of least speed, where there is one minimum. */
static double slowest(const hobe_curve *c, double a, double b)
{
    for (int i = 0; i < 60; i++) {
        const double left = a + (b - a) / 3, right = b - (b - a) / 3;
        if (speed(c, left) < speed(c, right))
            b = right;
        else
            a = left;
    }
    return (a + b) / 2;
}

/* The g-th of `points` places in every interval. */
static double grid(const hobe_curve *c, int points, int g)
{
    const int i = g / points < c->intervals ? g / points : c->intervals - 1;
    return c->knot[i] + (c->knot[i + 1] - c->knot[i]) * (g - i * points) / points;
}

/* Looks for the slowest place between the points of a grid, and whether all runs along Z. */
static enum hobe_status check_speed(hobe_curve *c, struct hobe_error *err)
{
    const int points = 8 + GRID / c->intervals, last = points * c->intervals;
    double fastest = 0, d[3][3];
    int vertical = 1;
    for (int g = 0; g <= last; g++) {
        derivatives(c, grid(c, points, g), 1, d);
        const double v = length3(d[1]);
        fastest = fmax(fastest, v);
        vertical = vertical && hypot(d[1][0], d[1][1]) < 1e-6 * v;
    }
    for (int g = 0; g <= last; g++) {
        const double t = grid(c, points, g), v = speed(c, t);
        const double before = grid(c, points, g > 0 ? g - 1 : 0);
        const double after = grid(c, points, g < last ? g + 1 : last);
        if (v > fastest / 10 || speed(c, before) < v || speed(c, after) < v)
            continue;
        const double least = slowest(c, before, after);
        if (!(speed(c, least) > least_speed * fastest))
            return fail_still(c, least, err);
        if (speed(c, least) < speed(c, c->slow))
            c->slow = least;
    }
    c->up[0] = vertical ? -copysign(1, d[1][2]) : 0;
    c->up[2] = vertical ? 0 : 1;
    return HOBE_OK;
}

/* ---- arc length ----------------------------------------------------------------------------- */

/* The arc length from t = a to b within a panel. */
static double arc(const hobe_curve *c, double a, double b)
{
    double length = 0;
    for (int g = 0; g < GAUSS; g++)
        length += (b - a) * c->gauss[g][1] * speed(c, a + (b - a) * c->gauss[g][0]);
    return length;
}

/* Splits every interval into `parts` panels.  *change: the largest change of the arc length at the
 * ends of panels that are half as many. */
static enum hobe_status split(hobe_curve *c, int parts, double *change, struct hobe_error *err)
{
    const int panels = parts * c->intervals;
    double *t = hobe_alloc(2 * (size_t)panels + 2, sizeof *t, err);
    if (!t)
        return HOBE_NO_MEMORY;
    double *s = t + panels + 1;
    double lost = 0; /* to rounding (Kahan), which has one sign where panels are alike */
    for (int i = 1; i <= panels; i++) {
        t[i] = grid(c, parts, i);
        const double more = arc(c, t[i - 1], t[i]) - lost;
        s[i] = s[i - 1] + more;
        lost = s[i] - s[i - 1] - more;
    }
    *change = HUGE_VAL;
    if (c->t) {
        *change = 0;
        for (int i = 1; i <= c->panels; i++)
            *change = fmax(*change, fabs(s[2 * i] - c->s[i]));
    }
    hobe_free(c->t);
    c->t = t;
    c->s = s;
    c->panels = panels;
    return HOBE_OK;
}

/* Halves panels until the arc length changes by rounding only: 1e-13 of it leaves room for the sum
 * of many panels, and the next halving would gain 2^16. */
static enum hobe_status measure(hobe_curve *c, struct hobe_error *err)
{
    double change = HUGE_VAL;
    for (int parts = 1; !c->t || change > 1e-13 * hobe_curve_length(c); parts *= 2) {
        if (c->panels > MOST_PANELS)
            return fail_still(c, c->slow, err);
        const enum hobe_status status = split(c, parts, &change, err);
        if (status)
            return status;
    }
    return HOBE_OK;
}

/* The t at arc length s: Newton's method, kept inside the panel's shrinking bracket. */
static double parameter(const hobe_curve *c, double s)
{
    const int i = find(c->s, c->panels, s);
    const double start = c->t[i], within = s - c->s[i];
    double low = start, high = c->t[i + 1];
    double t = low + (high - low) * within / (c->s[i + 1] - c->s[i]);
    for (int k = 0; k < 60; k++) {
        const double miss = arc(c, start, t) - within;
        if (fabs(miss) <= 4 * DBL_EPSILON * hobe_curve_length(c))
            break;
        if (miss > 0)
            high = t;
        else
            low = t;
        t -= miss / speed(c, t);
        if (!(t > low && t < high))
            t = (low + high) / 2;
    }
    return t;
}

/* ---- making a curve ------------------------------------------------------------------------- */

/* The slope at an end, point i, of the polynomial through the outermost points i, i + step, ..., by
 * divided differences: its error stays below that of the spline. */
static void end_slope(const hobe_curve *c, int i, int step, double slope[3])
{
    const int degree = c->intervals < END_POINTS - 1 ? c->intervals : END_POINTS - 1;
    double f[END_POINTS][3], x[END_POINTS];
    for (int j = 0; j <= degree; j++) {
        x[j] = c->knot[i + step * j];
        memcpy(f[j], c->point[i + step * j], sizeof f[j]);
    }
    for (int order = 1; order <= degree; order++)
        for (int j = degree; j >= order; j--)
            for (int a = 0; a < 3; a++)
                f[j][a] = (f[j][a] - f[j - 1][a]) / (x[j] - x[j - order]);
    memset(slope, 0, 3 * sizeof *slope);
    double product = 1;
    for (int j = 1; j <= degree; product *= x[0] - x[j++])
        for (int a = 0; a < 3; a++)
            slope[a] += product * f[j][a];
}

/* Slopes k_i with which the curvature does not jump, h_i and d_i lengths and slopes of the chords:
 * h_i k_(i-1) + 2 (h_(i-1) + h_i) k_i + h_(i-1) k_(i+1) = 3 (h_i d_(i-1) + h_(i-1) d_i),
 * by elimination without pivoting, since the diagonal dominates.  upper[intervals] is scratch. */
static void solve_slopes(hobe_curve *c, double *upper)
{
    const int last = c->intervals;
    end_slope(c, 0, 1, c->slope[0]);
    end_slope(c, last, -1, c->slope[last]);
    upper[0] = 0;
    for (int i = 1; i < last; i++) {
        const double h = c->knot[i] - c->knot[i - 1], g = c->knot[i + 1] - c->knot[i];
        const double pivot = 2 * (h + g) - g * upper[i - 1];
        const double *p = c->point[i - 1], *q = c->point[i], *r = c->point[i + 1];
        for (int a = 0; a < 3; a++) {
            const double right = 3 * (g * (q[a] - p[a]) / h + h * (r[a] - q[a]) / g);
            c->slope[i][a] = (right - g * c->slope[i - 1][a]) / pivot;
        }
        upper[i] = h / pivot;
    }
    for (int i = last - 1; i > 0; i--)
        for (int a = 0; a < 3; a++)
            c->slope[i][a] -= upper[i] * c->slope[i + 1][a];
}

/* Knots at the fractions of the chords' length.  Points closer than rounding can tell apart over
 * that length count as the same. */
static enum hobe_status set_knots(hobe_curve *c, struct hobe_error *err)
{
    const int last = c->intervals;
    for (int i = 0; i <= last; i++)
        for (int a = 0; a < 3; a++)
            if (!isfinite(c->point[i][a]))
                return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                                 "point %d of the curve must be finite, got {%g, %g, %g}", i + 1,
                                 c->point[i][0], c->point[i][1], c->point[i][2]);
    for (int i = 0; i < last; i++) {
        double d[3];
        for (int a = 0; a < 3; a++)
            d[a] = c->point[i + 1][a] - c->point[i][a];
        c->knot[i + 1] = c->knot[i] + length3(d);
    }
    const double length = c->knot[last];
    if (!isfinite(length))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the curve is longer than a number can say: its points are too far apart");
    for (int i = 1; i <= last; i++)
        if (!(c->knot[i] - c->knot[i - 1] > 1e-9 * length))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "points %d and %d of the curve must differ, both are {%g, %g, %g}", i,
                             i + 1, c->point[i][0], c->point[i][1], c->point[i][2]);
    for (int i = 1; i <= last; i++)
        c->knot[i] /= length;
    return HOBE_OK;
}

static enum hobe_status set_spline(hobe_curve *c, const double (*r)[3], struct hobe_error *err)
{
    const size_t n = (size_t)c->intervals + 1;
    c->point = hobe_alloc(n, sizeof *c->point, err);
    c->slope = c->point ? hobe_alloc(n, sizeof *c->slope, err) : NULL;
    if (!c->slope)
        return HOBE_NO_MEMORY;
    memcpy(c->point, r, n * sizeof *c->point);
    const enum hobe_status status = set_knots(c, err);
    if (status)
        return status;
    double *scratch = hobe_alloc(n, sizeof *scratch, err);
    if (!scratch)
        return HOBE_NO_MEMORY;
    solve_slopes(c, scratch);
    hobe_free(scratch);
    return HOBE_OK;
}

/* A curve of so many intervals, its last knot at t = 1, with nothing in between. */
static hobe_curve *new_curve(int intervals, struct hobe_error *err)
{
    hobe_curve *c = hobe_alloc(1, sizeof *c, err);
    if (!c)
        return NULL;
    c->intervals = intervals;
    c->knot = hobe_alloc((size_t)intervals + 1, sizeof *c->knot, err);
    if (c->knot) {
        c->knot[intervals] = 1;
        return c;
    }
    hobe_curve_free(c);
    return NULL;
}

/* Finishes a curve whose parametrisation succeeded; or frees it. */
static hobe_curve *finish(hobe_curve *c, enum hobe_status status, struct hobe_error *err)
{
    if (!status)
        status = hobe_gauss(GAUSS, c->gauss, err);
    if (!status)
        status = check_speed(c, err);
    if (!status)
        status = measure(c, err);
    if (!status)
        return c;
    hobe_curve_free(c);
    return NULL;
}

hobe_curve *hobe_curve_function(hobe_function *point, void *context, struct hobe_error *err)
{
    hobe_curve *c = new_curve(1, err);
    return c ? finish(
                   c,
                   hobe_chebyshev_fit(&c->series, 3, point, context, fit_tolerance, "curve", err),
                   err)
             : NULL;
}

hobe_curve *hobe_curve_points(int n, const double (*r)[3], struct hobe_error *err)
{
    if (n < 2 || n > MOST_POINTS) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "a curve needs 2 to %d points, got %d", MOST_POINTS,
                  n);
        return NULL;
    }
    hobe_curve *c = new_curve(n - 1, err);
    return c ? finish(c, set_spline(c, r, err), err) : NULL;
}

enum hobe_status hobe_curve_twist(hobe_curve *curve, hobe_function *twist, void *context,
                                  struct hobe_error *err)
{
    struct hobe_chebyshev series;
    const enum hobe_status status =
        hobe_chebyshev_fit(&series, 1, twist, context, fit_tolerance, "twist", err);
    if (status)
        return status;
    hobe_chebyshev_free(&curve->twist);
    curve->twist = series;
    return HOBE_OK;
}

void hobe_curve_free(hobe_curve *curve)
{
    if (!curve)
        return;
    hobe_chebyshev_free(&curve->series);
    hobe_chebyshev_free(&curve->twist);
    hobe_free(curve->knot);
    hobe_free(curve->point);
    hobe_free(curve->slope);
    hobe_free(curve->t);
    hobe_free(curve);
}

double hobe_curve_length(const hobe_curve *curve)
{
    return curve->s[curve->panels];
}

/* ---- axes ----------------------------------------------------------------------------------- */

/* The unit vector of v and its derivative, v_x being that of v; returns |v|. */
static double normalise(const double v[3], const double v_x[3], double e[3], double e_x[3])
{
    const double length = length3(v);
    for (int a = 0; a < 3; a++)
        e[a] = v[a] / length;
    const double along = dot3(e, v_x);
    for (int a = 0; a < 3; a++)
        e_x[a] = (v_x[a] - along * e[a]) / length;
    return length;
}

/* Axes of e[0] and `up`, and their derivatives; returns the length of up's part across e[0]. */
static double set_axes(const double up[3], double e[3][3], double e_x[3][3])
{
    const double along = dot3(up, e[0]), along_x = dot3(up, e_x[0]);
    double n[3], n_x[3], left[3], right[3];
    for (int a = 0; a < 3; a++) {
        n[a] = up[a] - along * e[0][a];
        n_x[a] = -along_x * e[0][a] - along * e_x[0][a];
    }
    const double across = normalise(n, n_x, e[2], e_x[2]);
    cross3(e[2], e[0], e[1]);
    cross3(e_x[2], e[0], left);
    cross3(e[2], e_x[0], right);
    for (int a = 0; a < 3; a++)
        e_x[1][a] = left[a] + right[a];
    return across;
}

/* Turns e_y and e_z by phi about e_x; phi_x = d phi/ds. */
static void turn(double phi, double phi_x, double e[3][3], double e_x[3][3])
{
    const double c = cos(phi), s = sin(phi);
    for (int a = 0; a < 3; a++) {
        const double y = e[1][a], z = e[2][a], y_x = e_x[1][a], z_x = e_x[2][a];
        e[1][a] = c * y + s * z;
        e[2][a] = c * z - s * y;
        e_x[1][a] = c * y_x + s * z_x + phi_x * e[2][a];
        e_x[2][a] = c * z_x - s * y_x - phi_x * e[1][a];
    }
}

enum hobe_status hobe_curve_at(const hobe_curve *curve, const double up[3], double at, double r[3],
                               double frame[3][3], double frame_x[3][3], struct hobe_error *err)
{
    if (!(at >= 0 && at <= 1))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "at must be a fraction of the curve's length from 0 to 1, got %g", at);
    const double length = hobe_curve_length(curve);
    double d[3][3], phi[2];
    derivatives(curve, parameter(curve, at * length), 2, d);
    memcpy(r, d[0], sizeof d[0]);
    const double v = normalise(d[1], d[2], frame[0], frame_x[0]);
    for (int a = 0; a < 3; a++)
        frame_x[0][a] /= v; /* from d/dt to d/ds */
    if (up[0] == 0 && up[1] == 0 && up[2] == 0)
        up = curve->up;
    if (!(set_axes(up, frame, frame_x) > 1e-6 * length3(up)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "up = {%g, %g, %g} points along the curve at %g of its length; give a "
                         "direction across it",
                         up[0], up[1], up[2], at);
    if (curve->twist.terms) {
        hobe_chebyshev_at(&curve->twist, at, 1, phi);
        turn(phi[0], phi[1] / length, frame, frame_x);
    }
    return HOBE_OK;
}
