/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "raster.h"

#include <math.h>
#include <string.h>

enum { SIDE = 3 }; /* samples along a side of a pixel */

static const double light[3] = {-0.36, -0.48, 0.8};    /* a unit vector to it, y down */
static const double AMBIENT = 0.55;                    /* the rest is the light's */
static const double ISOLINE_WIDTH = 1, ISOLINE = 0.62; /* pixels; the share of light it leaves */
static const double SLOWEST = 1e-5; /* isolines a pixel: below, the field is constant */
static const double ROUND = 1e-9;   /* so that neighbours leave no gap */
static const double NEARER = 2;     /* of lines, their width: shows on facets seen at 14 degrees */

enum hobe_status hobe_raster_new(struct hobe_raster *raster, int width, int height,
                                 struct hobe_error *err)
{
    const size_t samples = (size_t)SIDE * SIDE * (size_t)width * (size_t)height;
    *raster = (struct hobe_raster){width, height, hobe_alloc(samples, sizeof *raster->sample, err)};
    return raster->sample ? HOBE_OK : HOBE_NO_MEMORY;
}

void hobe_raster_free(struct hobe_raster *raster)
{
    hobe_free(raster->sample);
    *raster = (struct hobe_raster){0};
}

/* The samples [from, to) of a side with `samples` of them that lie in [low, high] pixels. */
static void clip(double low, double high, int samples, int *from, int *to)
{
    *from = (int)fmin(fmax(ceil(low * SIDE - 0.5), 0), samples);
    *to = (int)fmax(fmin(floor(high * SIDE - 0.5) + 1, samples), 0);
}

/* The sample in row i and column j where something at this depth would be seen, else NULL. */
static struct hobe_sample *seen(struct hobe_raster *raster, int i, int j, double depth)
{
    struct hobe_sample *s = raster->sample + (size_t)i * (size_t)(SIDE * raster->width) + j;
    return s->covered && s->depth > (float)depth ? NULL : s;
}

static void put(struct hobe_sample *s, double depth, const double rgb[3], double factor)
{
    s->depth = (float)depth;
    s->covered = 1;
    for (int k = 0; k < 3; k++)
        s->rgb[k] = (uint8_t)lround(255 * fmin(fmax(factor * rgb[k], 0), 1));
}

/* ---- triangles ------------------------------------------------------------------------------ */

/* A function a + b x + c y on the picture. */
struct affine {
    double a, b, c;
};

static double at(const struct affine *f, double x, double y)
{
    return f->a + f->b * x + f->c * y;
}

/* The affine function with values v at the corners of a triangle, twice its area given. */
static struct affine through(const struct hobe_vertex p[3], double twice, double v0, double v1,
                             double v2)
{
    struct affine f;
    f.b = ((v1 - v0) * (p[2].y - p[0].y) - (v2 - v0) * (p[1].y - p[0].y)) / twice;
    f.c = ((v2 - v0) * (p[1].x - p[0].x) - (v1 - v0) * (p[2].x - p[0].x)) / twice;
    f.a = v0 - f.b * p[0].x - f.c * p[0].y;
    return f;
}

/* depth = a + b x + c y has the normal (-b, -c, 1), which looks at the viewer. */
static double shade(const struct affine *depth)
{
    const double length = sqrt(depth->b * depth->b + depth->c * depth->c + 1);
    const double lit = (-light[0] * depth->b - light[1] * depth->c + light[2]) / length;
    return AMBIENT + (1 - AMBIENT) * fmin(fmax(lit / light[2], 0), 1);
}

static const double *colour(const struct hobe_paint *paint, double v)
{
    const double range = paint->high - paint->low, t = range > 0 ? (v - paint->low) / range : 0.5;
    return paint->palette[(int)lround(fmin(fmax(t, 0), 1) * (HOBE_PALETTE - 1))];
}

/* Light left by an isoline, if there is one: its distance is that of the values over the slope. */
static double line_factor(const struct hobe_paint *paint, double v, double slope)
{
    if (paint->isoline <= 0 || slope < SLOWEST * paint->isoline)
        return 1;
    const double off = fabs(v - paint->isoline * round(v / paint->isoline)) / slope;
    return off < ISOLINE_WIDTH / 2 ? ISOLINE : 1;
}

void hobe_raster_triangle(struct hobe_raster *raster, const struct hobe_vertex p[3],
                          const struct hobe_paint *paint)
{
    const double twice =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    int i0, i1, j0, j1;
    clip(fmin(fmin(p[0].y, p[1].y), p[2].y), fmax(fmax(p[0].y, p[1].y), p[2].y),
         SIDE * raster->height, &i0, &i1);
    clip(fmin(fmin(p[0].x, p[1].x), p[2].x), fmax(fmax(p[0].x, p[1].x), p[2].x),
         SIDE * raster->width, &j0, &j1);
    if (twice == 0 || i0 >= i1 || j0 >= j1)
        return;
    const struct affine L[3] = {through(p, twice, 1, 0, 0), through(p, twice, 0, 1, 0),
                                through(p, twice, 0, 0, 1)};
    const struct affine depth = through(p, twice, p[0].depth, p[1].depth, p[2].depth);
    const struct affine value = through(p, twice, p[0].value, p[1].value, p[2].value);
    const double bright = shade(&depth), slope = hypot(value.b, value.c);
    for (int i = i0; i < i1; i++)
        for (int j = j0; j < j1; j++) {
            const double x = (j + 0.5) / SIDE, y = (i + 0.5) / SIDE, z = at(&depth, x, y);
            if (at(L, x, y) < -ROUND || at(L + 1, x, y) < -ROUND || at(L + 2, x, y) < -ROUND)
                continue;
            struct hobe_sample *s = seen(raster, i, j, z);
            if (!s)
                continue;
            const double v = at(&value, x, y);
            put(s, z, colour(paint, v), bright * line_factor(paint, v, slope));
        }
}

/* ---- lines ---------------------------------------------------------------------------------- */

void hobe_raster_line(struct hobe_raster *raster, const struct hobe_vertex *a,
                      const struct hobe_vertex *b, double width, double grey)
{
    const double half = width / 2, dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
    const double rgb[3] = {grey, grey, grey};
    int i0, i1, j0, j1;
    clip(fmin(a->y, b->y) - half, fmax(a->y, b->y) + half, SIDE * raster->height, &i0, &i1);
    clip(fmin(a->x, b->x) - half, fmax(a->x, b->x) + half, SIDE * raster->width, &j0, &j1);
    for (int i = i0; i < i1; i++)
        for (int j = j0; j < j1; j++) {
            const double x = (j + 0.5) / SIDE - a->x, y = (i + 0.5) / SIDE - a->y;
            const double t = square > 0 ? fmin(fmax((x * dx + y * dy) / square, 0), 1) : 0;
            if (hypot(x - t * dx, y - t * dy) > half)
                continue;
            const double depth = a->depth + t * (b->depth - a->depth) + NEARER * width;
            struct hobe_sample *s = seen(raster, i, j, depth);
            if (s)
                put(s, depth, rgb, 1);
        }
}

/* ---- pixels --------------------------------------------------------------------------------- */

void hobe_raster_pixels(const struct hobe_raster *raster, uint32_t *pixel)
{
    const int columns = SIDE * raster->width, n = SIDE * SIDE;
    for (int i = 0; i < raster->height; i++)
        for (int j = 0; j < raster->width; j++) {
            unsigned sum[4] = {0};
            for (int k = 0; k < n; k++) {
                const size_t row = (size_t)(SIDE * i + k / SIDE) * (size_t)columns;
                const struct hobe_sample *s = raster->sample + row + SIDE * j + k % SIDE;
                sum[0] += s->covered;
                for (int c = 0; c < 3; c++)
                    sum[1 + c] += s->rgb[c]; /* zero where nothing is */
            }
            const unsigned alpha = (255 * sum[0] + n / 2) / n;
            uint32_t argb = alpha;
            for (int c = 0; c < 3; c++)
                argb = argb << 8 | (sum[1 + c] + n / 2) / n;
            pixel[(size_t)i * (size_t)raster->width + j] = argb;
        }
}
