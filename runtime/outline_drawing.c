/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline_drawing.h"

#include <math.h>
#include <string.h>

/* Of a drawing's extent: nearer points are one.  Files have six digits and more. */
static const double NEAR = 1e-5;

/* The largest angle of a chord, rad: the mesher must not take the corners of an arc for corners of
 * the section. */
static const double WIDEST = M_PI / 9;

/* ---- paths ---------------------------------------------------------------------------------- */

enum hobe_status hobe_drawing_new(struct hobe_drawing *drawing, const char *name,
                                  struct hobe_error *err)
{
    *drawing = (struct hobe_drawing){
        .name = name,
        .tolerance = INFINITY,
        .path = hobe_alloc(HOBE_MOST_DRAWN, sizeof *drawing->path, err),
        .point = hobe_alloc(HOBE_MOST_DRAWN, sizeof *drawing->point, err),
    };
    return drawing->path && drawing->point ? HOBE_OK : HOBE_NO_MEMORY;
}

void hobe_drawing_free(struct hobe_drawing *drawing)
{
    hobe_free(drawing->path);
    hobe_free(drawing->point);
    *drawing = (struct hobe_drawing){0};
}

struct hobe_path *hobe_path_last(struct hobe_drawing *drawing)
{
    return drawing->path + drawing->paths - 1;
}

/* Points of all paths. */
static int drawn(const struct hobe_drawing *drawing)
{
    return drawing->paths ? drawing->path[drawing->paths - 1].to : 0;
}

/* A point is no path. */
static void drop_point(struct hobe_drawing *drawing)
{
    if (drawing->paths && hobe_path_last(drawing)->to - hobe_path_last(drawing)->from < 2)
        drawing->paths--;
}

void hobe_path_begin(struct hobe_drawing *drawing, const char *what, int line)
{
    drop_point(drawing);
    const int from = drawn(drawing);
    drawing->path[drawing->paths++] = (struct hobe_path){what, line, from, from, 0};
}

static enum hobe_status fail_many(const struct hobe_drawing *drawing, struct hobe_error *err)
{
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "%s: an outline with its holes may have %d points, got more; where it has "
                     "arcs a larger tolerance needs fewer",
                     drawing->name, HOBE_MAX_OUTLINE);
}

enum hobe_status hobe_path_line(struct hobe_drawing *drawing, const double p[2],
                                struct hobe_error *err)
{
    struct hobe_path *path = hobe_path_last(drawing);
    if (!isfinite(p[0]) || !isfinite(p[1]))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: line %d: points must be finite, got (%g, %g) on this %s",
                         drawing->name, path->line, p[0], p[1], path->what);
    if (path->to >= HOBE_MOST_DRAWN)
        return fail_many(drawing, err);
    memcpy(drawing->point[path->to++], p, sizeof(double[2]));
    return HOBE_OK;
}

/* ---- arcs ----------------------------------------------------------------------------------- */

/* The number of chords: corners lie off an arc of radius r by r angle^2/6 + ..., which is less than
 * r angle^2/5 for the angles allowed; the chords' middles by less. */
static double chords(const struct hobe_drawing *drawing, const struct hobe_arc *arc)
{
    const double r = fmax(hypot(arc->a[0], arc->a[1]), hypot(arc->b[0], arc->b[1]));
    const double angle = fmin(sqrt(5 * drawing->tolerance / r), WIDEST);
    return fmax(2, ceil(fabs(arc->sweep) / angle));
}

/* The point at t, off the arc by the factor k from the centre. */
static enum hobe_status add_at(struct hobe_drawing *drawing, const struct hobe_arc *arc, double t,
                               double k, struct hobe_error *err)
{
    const double x = k * cos(t), y = k * sin(t);
    const double p[2] = {arc->centre[0] + x * arc->a[0] + y * arc->b[0],
                         arc->centre[1] + x * arc->a[1] + y * arc->b[1]};
    return hobe_path_line(drawing, p, err);
}

/* The sectors of n chords, sin(angle)/2 (2 k + (n - 2) k^2) in the circle's units, are those of the
 * arc, n angle/2. */
enum hobe_status hobe_path_arc(struct hobe_drawing *drawing, const struct hobe_arc *arc,
                               struct hobe_error *err)
{
    const struct hobe_path *path = hobe_path_last(drawing);
    const double n = chords(drawing, arc), angle = arc->sweep / n, q = angle / sin(angle);
    const double k = n * q / (1 + sqrt(1 + (n - 2) * n * q));
    enum hobe_status status = HOBE_OK;
    if (!(n < HOBE_MOST_DRAWN))
        return fail_many(drawing, err);
    for (int i = path->to > path->from ? 1 : 0; !status && i <= (int)n; i++)
        status = add_at(drawing, arc, arc->from + i * angle, i == 0 || i == (int)n ? 1 : k, err);
    return status;
}

enum hobe_status hobe_path_ellipse(struct hobe_drawing *drawing, const struct hobe_arc *arc,
                                   struct hobe_error *err)
{
    const double n = chords(drawing, arc), angle = arc->sweep / n;
    enum hobe_status status = HOBE_OK;
    if (!(n < HOBE_MOST_DRAWN))
        return fail_many(drawing, err);
    for (int i = 0; !status && i < (int)n; i++)
        status = add_at(drawing, arc, arc->from + i * angle, sqrt(angle / sin(angle)), err);
    hobe_path_last(drawing)->closed = 1;
    return status;
}

/* ---- chaining ------------------------------------------------------------------------------- */

/* Of n points. */
static double extent(const double (*point)[2], int n)
{
    double size = 0;
    for (int a = 0; a < 2; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < n; i++) {
            low = fmin(low, point[i][a]);
            high = fmax(high, point[i][a]);
        }
        size = fmax(size, high - low);
    }
    return size;
}

double hobe_drawing_extent(const struct hobe_drawing *drawing)
{
    return extent((const double(*)[2])drawing->point, drawn(drawing));
}

/* End e of the drawing: the start of path e/2 where e is even, its last point where odd. */
static const double *end_of(const struct hobe_drawing *drawing, int e)
{
    const struct hobe_path *path = drawing->path + e / 2;
    return drawing->point[e % 2 ? path->to - 1 : path->from];
}

/* The work of chaining, loop by loop. */
struct chain {
    const struct hobe_drawing *drawing;
    double near;  /* closer ends coincide */
    int *partner; /* [2 paths] the end that coincides with it; -1 where a path has no open ends */
    struct hobe_loops *loops;
    int points; /* of all loops so far */
};

static enum hobe_status fail_end(const struct chain *chain, int e, int meeting, double nearest,
                                 struct hobe_error *err)
{
    const struct hobe_path *path = chain->drawing->path + e / 2;
    const double *p = end_of(chain->drawing, e);
    if (meeting > 1)
        return hobe_fail(
            err, HOBE_BAD_INPUT, NULL,
            "%s: %d ends meet at (%g, %g), one of them the %s's of line %d; an outline "
            "goes on one way only",
            chain->drawing->name, meeting + 1, p[0], p[1], path->what, path->line);
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "%s: the %s of line %d ends at (%g, %g), where nothing goes on (the nearest "
                     "other end is %g away); an outline must be closed",
                     chain->drawing->name, path->what, path->line, p[0], p[1], nearest);
}

/* Finds for each end of an open path the one other that coincides with it. */
static enum hobe_status find_partners(struct chain *chain, struct hobe_error *err)
{
    const struct hobe_drawing *drawing = chain->drawing;
    for (int e = 0; e < 2 * drawing->paths; e++) {
        const double *p = end_of(drawing, e);
        double nearest = INFINITY;
        int meeting = 0;
        if (chain->partner[e] < 0)
            continue;
        for (int f = 0; f < 2 * drawing->paths; f++) {
            const double *q = end_of(drawing, f), distance = hypot(q[0] - p[0], q[1] - p[1]);
            if (f == e || chain->partner[f] < 0)
                continue;
            if (distance <= chain->near) {
                chain->partner[e] = f;
                meeting++;
            }
            nearest = fmin(nearest, distance);
        }
        if (meeting != 1)
            return fail_end(chain, e, meeting, nearest, err);
    }
    return HOBE_OK;
}

/* Adds a path's points to the last loop, from its last point back where `back`. */
static void add_points(struct chain *chain, const struct hobe_path *path, int back)
{
    struct hobe_loops *loops = chain->loops;
    int *points = loops->points + loops->loops - 1;
    for (int i = path->from; i < path->to; i++) {
        const double *p = chain->drawing->point[back ? path->from + path->to - 1 - i : i];
        const double *last = *points > 0 ? loops->point[chain->points - 1] : NULL;
        if (last && hypot(p[0] - last[0], p[1] - last[1]) <= chain->near)
            continue;
        memcpy(loops->point[chain->points++], p, sizeof(double[2]));
        ++*points;
    }
}

/* The last point of the last loop may repeat its first. */
static void close_loop(struct chain *chain)
{
    struct hobe_loops *loops = chain->loops;
    int *points = loops->points + loops->loops - 1;
    const double *last = loops->point[chain->points - 1];
    const double *first = loops->point[chain->points - *points];
    if (*points > 1 && hypot(last[0] - first[0], last[1] - first[1]) <= chain->near) {
        --*points;
        chain->points--;
    }
}

/* The loop that path p belongs to; the ends of its paths are -1 from then on. */
static void add_loop(struct chain *chain, int p)
{
    int e = 2 * p; /* where the path is entered */
    chain->loops->points[chain->loops->loops++] = 0;
    do {
        const int out = e ^ 1, next = chain->partner[out];
        add_points(chain, chain->drawing->path + e / 2, e % 2);
        chain->partner[e] = chain->partner[out] = -1;
        e = next;
    } while (e >= 0 && chain->partner[e] >= 0);
    close_loop(chain);
}

static double area(const double (*point)[2], int n)
{
    double twice = 0;
    for (int i = 1; i + 1 < n; i++)
        twice += (point[i][0] - point[0][0]) * (point[i + 1][1] - point[0][1]) -
                 (point[i][1] - point[0][1]) * (point[i + 1][0] - point[0][0]);
    return fabs(twice) / 2;
}

/* Moves the `count` points at `from` to the front. */
static void rotate(double (*point)[2], int from, int count)
{
    for (; from > 0; from--)
        for (int i = from; i < from + count; i++)
            for (int a = 0; a < 2; a++) {
                const double swap = point[i - 1][a];
                point[i - 1][a] = point[i][a];
                point[i][a] = swap;
            }
}

/* What holds all others is larger than they. */
static void put_outline_first(struct hobe_loops *loops)
{
    int outline = 0, from = 0, start = 0;
    double largest = -1;
    for (int l = 0; l < loops->loops; start += loops->points[l++]) {
        const double A = area((const double(*)[2])loops->point + start, loops->points[l]);
        if (A <= largest)
            continue;
        largest = A;
        outline = l;
        from = start;
    }
    const int points = loops->points[outline];
    rotate(loops->point, from, points);
    memmove(loops->points + 1, loops->points, (size_t)outline * sizeof *loops->points);
    loops->points[0] = points;
}

static enum hobe_status chain_paths(struct chain *chain, struct hobe_error *err)
{
    const struct hobe_drawing *drawing = chain->drawing;
    for (int p = 0; p < drawing->paths; p++) {
        const struct hobe_path *path = drawing->path + p;
        const double(*point)[2] = (const double(*)[2])drawing->point + path->from;
        if (path->closed || extent(point, path->to - path->from) <= chain->near)
            chain->partner[2 * p] = chain->partner[2 * p + 1] = -1;
    }
    const enum hobe_status status = find_partners(chain, err);
    for (int p = 0; !status && p < drawing->paths; p++)
        if (drawing->path[p].closed || chain->partner[2 * p] >= 0)
            add_loop(chain, p);
    return status;
}

enum hobe_status hobe_drawing_loops(struct hobe_drawing *drawing, struct hobe_loops *loops,
                                    struct hobe_error *err)
{
    drop_point(drawing);
    struct chain chain = {
        .drawing = drawing,
        .near = NEAR * hobe_drawing_extent(drawing),
        .partner = hobe_alloc(2 * (size_t)drawing->paths, sizeof *chain.partner, err),
        .loops = loops,
    };
    enum hobe_status status = HOBE_NO_MEMORY;
    *loops = (struct hobe_loops){
        .points = hobe_alloc((size_t)drawing->paths, sizeof *loops->points, err),
        .point = hobe_alloc((size_t)drawn(drawing), sizeof *loops->point, err),
    };
    if (chain.partner && loops->points && loops->point)
        status = chain_paths(&chain, err);
    hobe_free(chain.partner);
    if (!status && !loops->loops)
        status =
            hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s: there is no outline in it", drawing->name);
    if (!status && chain.points > HOBE_MAX_OUTLINE)
        status = fail_many(drawing, err);
    if (status)
        hobe_loops_free(loops);
    else
        put_outline_first(loops);
    return status;
}

void hobe_loops_free(struct hobe_loops *loops)
{
    hobe_free(loops->points);
    hobe_free(loops->point);
    *loops = (struct hobe_loops){0};
}
