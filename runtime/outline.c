/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline.h"

#include "hobe.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Relative to the outline's extent: closer points are one, smaller areas (in the square) none. */
static const double SAME = 1e-7;

int hobe_outline_next(const struct hobe_outline *o, int loop, int i)
{
    return i + 1 < o->start[loop + 1] ? i + 1 : o->start[loop];
}

/* Twice the area of the triangle a b c, positive anticlockwise. */
static double turn(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Area of one loop, positive anticlockwise, taken from its first point to keep digits. */
static double loop_area(const struct hobe_outline *o, int l)
{
    double twice = 0;
    for (int i = o->start[l]; i < o->start[l + 1]; i++)
        twice += turn(o->point[o->start[l]], o->point[i], o->point[hobe_outline_next(o, l, i)]);
    return twice / 2;
}

double hobe_outline_area(const struct hobe_outline *o, double centroid[2])
{
    const double *from = o->point[0];
    double A = 0, moment[2] = {0, 0};
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
            const double piece = turn(from, a, b) / 2;
            A += piece;
            for (int k = 0; k < 2; k++)
                moment[k] += piece * (a[k] + b[k] - 2 * from[k]) / 3;
        }
    for (int k = 0; k < 2; k++)
        centroid[k] = from[k] + moment[k] / A;
    return A;
}

void hobe_outline_move(struct hobe_outline *o, double y, double z)
{
    for (int i = 0; i < o->start[o->loops]; i++) {
        o->point[i][0] += y;
        o->point[i][1] += z;
    }
}

/* ---- checks --------------------------------------------------------------------------------- */

static double extent(const struct hobe_outline *o)
{
    double most = 0;
    for (int i = 0; i < o->start[1]; i++)
        most = fmax(most, hypot(o->point[i][0] - o->point[0][0], o->point[i][1] - o->point[0][1]));
    return most;
}

/* "the outline" or "hole 2" */
static const char *name_of(int loop, char name[20])
{
    snprintf(name, 20, loop ? "hole %d" : "the outline", loop);
    return name;
}

static enum hobe_status check_loop(const struct hobe_outline *o, int l, double size,
                                   struct hobe_error *err)
{
    char name[20];
    for (int i = o->start[l]; i < o->start[l + 1]; i++) {
        const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
        if (hypot(b[0] - a[0], b[1] - a[1]) <= SAME * size)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s has the point (%g, %g) twice in a row",
                             name_of(l, name), a[0], a[1]);
    }
    return HOBE_OK;
}

/* Whether the segments a b and c d meet or come closer than `near`. */
static int meet(const double *a, const double *b, const double *c, const double *d, double near)
{
    const double ab = hypot(b[0] - a[0], b[1] - a[1]) * near;
    const double cd = hypot(d[0] - c[0], d[1] - c[1]) * near;
    for (int k = 0; k < 2; k++)
        if (fmax(a[k], b[k]) < fmin(c[k], d[k]) - near ||
            fmax(c[k], d[k]) < fmin(a[k], b[k]) - near)
            return 0;
    const double c1 = turn(a, b, c), d1 = turn(a, b, d), a1 = turn(c, d, a), b1 = turn(c, d, b);
    const int apart = (c1 > ab && d1 > ab) || (c1 < -ab && d1 < -ab);
    return !apart && !((a1 > cd && b1 > cd) || (a1 < -cd && b1 < -cd));
}

/* Neighbours share a point; they overlap when they fold back on each other. */
static int folds_back(const double *a, const double *b, const double *c)
{
    const double e[2] = {b[0] - a[0], b[1] - a[1]}, f[2] = {c[0] - b[0], c[1] - b[1]};
    const double lengths = hypot(e[0], e[1]) * hypot(f[0], f[1]);
    return fabs(e[0] * f[1] - e[1] * f[0]) < SAME * lengths && e[0] * f[0] + e[1] * f[1] < 0;
}

static int edges_cross(const struct hobe_outline *o, int l, int i, int m, int j, double size)
{
    const int i2 = hobe_outline_next(o, l, i), j2 = hobe_outline_next(o, m, j);
    double(*p)[2] = o->point;
    if (l == m && i2 == j)
        return folds_back(p[i], p[i2], p[j2]);
    if (l == m && j2 == i)
        return folds_back(p[j], p[j2], p[i2]);
    return meet(p[i], p[i2], p[j], p[j2], SAME * size);
}

static enum hobe_status fail_crossing(const struct hobe_outline *o, int l, int i, int m, int j,
                                      struct hobe_error *err)
{
    const double *a = o->point[i], *b = o->point[j];
    char one[20], other[20];
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "%s crosses or touches %s, between the edges that begin at (%g, %g) "
                     "and (%g, %g)",
                     name_of(l, one), m == l ? "itself" : name_of(m, other), a[0], a[1], b[0],
                     b[1]);
}

static enum hobe_status check_crossings(const struct hobe_outline *o, double size,
                                        struct hobe_error *err)
{
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++)
            for (int m = l; m < o->loops; m++)
                for (int j = m == l ? i + 1 : o->start[m]; j < o->start[m + 1]; j++)
                    if (edges_cross(o, l, i, m, j, size))
                        return fail_crossing(o, l, i, m, j, err);
    return HOBE_OK;
}

/* Whether p lies within the loop: an odd number of edges to its right. */
static int inside(const struct hobe_outline *o, int l, const double p[2])
{
    int odd = 0;
    for (int i = o->start[l]; i < o->start[l + 1]; i++) {
        const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
        if ((a[1] > p[1]) != (b[1] > p[1]) &&
            p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
            odd = !odd;
    }
    return odd;
}

int hobe_outline_holds(const struct hobe_outline *o, const double p[2])
{
    int odd = 0;
    for (int l = 0; l < o->loops; l++)
        odd ^= inside(o, l, p);
    return odd;
}

/* No edges cross, so that one point of each hole tells. */
static enum hobe_status check_holes(const struct hobe_outline *o, struct hobe_error *err)
{
    for (int l = 1; l < o->loops; l++)
        for (int m = 0; m < o->loops; m++) {
            const double *p = o->point[o->start[l]];
            if (m != l && inside(o, m, p) != (m == 0))
                return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                                 m ? "hole %d at (%g, %g) lies in another hole"
                                   : "hole %d at (%g, %g) lies outside the outline",
                                 l, p[0], p[1]);
        }
    return HOBE_OK;
}

static enum hobe_status check_counts(int loops, const int *points, int *total,
                                     struct hobe_error *err)
{
    char name[20];
    *total = 0;
    for (int l = 0; l < loops; l++) {
        if (points[l] < 3)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s needs at least 3 points, got %d",
                             name_of(l, name), points[l]);
        if (points[l] > HOBE_MAX_OUTLINE - *total)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "an outline with its holes may have %d points, got more",
                             HOBE_MAX_OUTLINE);
        *total += points[l];
    }
    return HOBE_OK;
}

/* Keeps the first point, by which errors name a loop. */
static void reverse(struct hobe_outline *o, int l)
{
    for (int i = o->start[l] + 1, j = o->start[l + 1] - 1; i < j; i++, j--)
        for (int k = 0; k < 2; k++) {
            const double swap = o->point[i][k];
            o->point[i][k] = o->point[j][k];
            o->point[j][k] = swap;
        }
}

static enum hobe_status check(struct hobe_outline *o, struct hobe_error *err)
{
    char name[20];
    const double size = extent(o);
    enum hobe_status status = HOBE_OK;
    for (int i = 0; i < o->start[o->loops]; i++)
        if (!isfinite(o->point[i][0]) || !isfinite(o->point[i][1]))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL, "points must be finite, got (%g, %g)",
                             o->point[i][0], o->point[i][1]);
    for (int l = 0; !status && l < o->loops; l++)
        status = check_loop(o, l, size, err);
    for (int l = 0; !status && l < o->loops; l++) {
        if (fabs(loop_area(o, l)) <= SAME * size * size)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s encloses no area", name_of(l, name));
        if ((loop_area(o, l) > 0) != (l == 0))
            reverse(o, l);
    }
    if (!status)
        status = check_crossings(o, size, err);
    return status ? status : check_holes(o, err);
}

enum hobe_status hobe_outline_new(int loops, const int *points, const double (*point)[2],
                                  struct hobe_outline *outline, struct hobe_error *err)
{
    int total;
    *outline = (struct hobe_outline){0};
    enum hobe_status status = check_counts(loops, points, &total, err);
    if (status)
        return status;
    outline->loops = loops;
    outline->start = hobe_alloc((size_t)loops + 1, sizeof *outline->start, err);
    outline->point = hobe_alloc((size_t)total, sizeof *outline->point, err);
    if (outline->start && outline->point) {
        for (int l = 0; l < loops; l++)
            outline->start[l + 1] = outline->start[l] + points[l];
        memcpy(outline->point, point, (size_t)total * sizeof *point);
        status = check(outline, err);
    } else
        status = HOBE_NO_MEMORY;
    if (status)
        hobe_outline_free(outline);
    return status;
}

enum hobe_status hobe_outline_copy(const struct hobe_outline *from, struct hobe_outline *to,
                                   struct hobe_error *err)
{
    const size_t loops = (size_t)from->loops, points = (size_t)from->start[loops];
    to->loops = from->loops;
    to->start = hobe_alloc(loops + 1, sizeof *to->start, err);
    to->point = hobe_alloc(points, sizeof *to->point, err);
    if (!to->start || !to->point) {
        hobe_outline_free(to);
        return HOBE_NO_MEMORY;
    }
    memcpy(to->start, from->start, (loops + 1) * sizeof *to->start);
    memcpy(to->point, from->point, points * sizeof *to->point);
    return HOBE_OK;
}

void hobe_outline_free(struct hobe_outline *outline)
{
    hobe_free(outline->start);
    hobe_free(outline->point);
    *outline = (struct hobe_outline){0};
}
