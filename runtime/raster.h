/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Triangles and lines drawn through a z-buffer, nine samples a pixel.  Nothing but memory: the same
 * calls give the same pixels everywhere. */
#ifndef HOBE_RASTER_H
#define HOBE_RASTER_H

#include "error.h"

#include <stdint.h>

/* Places are in pixels: x to the right, y down from the upper left corner, depth towards the
 * viewer in the same unit. */
struct hobe_vertex {
    double x, y, depth;
    double value; /* of the field that colours a triangle */
};

struct hobe_sample {
    float depth;
    uint8_t rgb[3], covered;
};

struct hobe_raster {
    int width, height;          /* pixels */
    struct hobe_sample *sample; /* [3 height][3 width] */
};

enum { HOBE_PALETTE = 256 };

/* How triangles are painted: a value v has the colour of (v - low)/(high - low). */
struct hobe_paint {
    const double (*palette)[3]; /* [HOBE_PALETTE] sRGB in [0,1], evenly from low to high */
    double low, high;
    double isoline; /* lines where v is a multiple of it; 0: none */
};

/* An empty raster. */
enum hobe_status hobe_raster_new(struct hobe_raster *raster, int width, int height,
                                 struct hobe_error *err);
void hobe_raster_free(struct hobe_raster *raster);

/* One flat facet, lit by a fixed light over the viewer's left shoulder; both sides are alike.  One
 * that faces the viewer has the very colours of its map. */
void hobe_raster_triangle(struct hobe_raster *raster, const struct hobe_vertex corner[3],
                          const struct hobe_paint *paint);

/* A line with round ends, in a grey from 0 to 1, a little nearer to the viewer than it is, so that
 * it shows on the surface it bounds. */
void hobe_raster_line(struct hobe_raster *raster, const struct hobe_vertex *a,
                      const struct hobe_vertex *b, double width, double grey);

/* Means of the samples: pixel[height][width] = alpha, red, green, blue of eight bits each from the
 * top down, colours multiplied by alpha. */
void hobe_raster_pixels(const struct hobe_raster *raster, uint32_t *pixel);

#endif
