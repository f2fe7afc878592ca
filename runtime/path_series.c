/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps of a path along its power series. */
#include "path_parts.h"
#include "taylor.h"

#include <float.h>
#include <math.h>

/* The last term of a series over its first, where it is left. */
static const double LAST_TERM = 1e-6;

/* Parts of a step by series in which a root of a polynomial is looked for by its sign. */
enum { PARTS = 64 };

/* The coefficients of the distance from a plane. */
static void distance_series(const struct follower *f, const struct plane *p, taylor sum)
{
    for (int k = 0; k <= SERIES_ORDER; k++)
        sum[k] = path_distance(f, p, f->series.u[k], f->series.lambda[k]) + (k > 0 ? p->value : 0);
}

static double value_of(const taylor p, double a)
{
    double sum = p[SERIES_ORDER];
    for (int k = SERIES_ORDER - 1; k >= 0; k--)
        sum = sum * a + p[k];
    return sum;
}

/* The first a in (from, to] where p changes its sign; 0 where it does not. */
static double first_root(const taylor p, double from, double to)
{
    for (int part = 0; part < PARTS; part++) {
        double low = from + (to - from) * part / PARTS;
        double high = from + (to - from) * (part + 1) / PARTS;
        const double sign = value_of(p, low);
        if (sign == 0 || !(sign * value_of(p, high) <= 0))
            continue;
        for (int halving = 0; halving < DBL_MANT_DIG; halving++) {
            const double middle = (low + high) / 2;
            if (sign * value_of(p, middle) > 0)
                low = middle;
            else
                high = middle;
        }
        return high;
    }
    return 0;
}

/* How far to go, at most `arc`: past one limit point, whose load it notes, and not on to a second
 * one. */
static double pass_limit(struct follower *f, double arc)
{
    const double *lambda = f->series.lambda;
    taylor slope = {0};
    for (int k = 1; k <= SERIES_ORDER; k++)
        slope[k - 1] = k * lambda[k];
    const double first = first_root(slope, 0, arc);
    if (first == 0)
        return arc;
    f->extreme = value_of(lambda, first);
    const double second = first_root(slope, first + (arc - first) / PARTS, arc);
    return second > 0 ? (first + second) / 2 : arc;
}

/* The root of an end of the path within `arc`, where that becomes the plane; else arc. */
static double shorten(const struct follower *f, const struct plane *end, double arc,
                      const struct plane **plane)
{
    taylor to;
    distance_series(f, end, to);
    const double root = first_root(to, 0, arc);
    if (root > 0)
        *plane = end;
    return root > 0 ? root : arc;
}

const struct plane *path_predict_by_series(struct follower *f, double arc)
{
    const struct plane *plane = &f->step;
    arc = pass_limit(f, arc);
    if (f->reach.c)
        arc = shorten(f, &f->reach, arc, &plane);
    arc = shorten(f, &f->load, arc, &plane);
    f->path->info.end = plane == &f->load ? HOBE_PATH_LOAD : HOBE_PATH_DISPLACEMENT;
    f->lambda = series_move(&f->series, arc);
    f->kappa = series_slope(&f->series, arc, f->v);
    const double length = path_length(f, f->v, f->kappa);
    f->kappa /= length;
    for (long i = 0; i < f->n; i++)
        f->v[i] /= length;
    path_set_plane(f);
    return plane;
}

enum hobe_status path_expand(struct follower *f, double *longest, struct hobe_error *err)
{
    *longest = f->options.arc;
    if (!path_by_series(f))
        return HOBE_OK;
    for (long i = 0; i < f->n; i++)
        f->step.c[i] = f->W[i] * f->v[i];
    const enum hobe_status status = series_expand(&f->series, f->lambda, f->step.c, f->kappa, err);
    if (!status)
        *longest = fmin(*longest, series_range(&f->series, LAST_TERM));
    return status;
}
