/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where things stand in a picture.  Between picture.c and picture_layout.c only. */
#ifndef HOBE_PICTURE_LAYOUT_H
#define HOBE_PICTURE_LAYOUT_H

#include "picture.h"
#include "raster.h"

/* Lengths in the unit of a picture 1200 wide; they grow with the picture. */
enum {
    BASE = 1200,
    MARGIN = 28,
    GAP = 20,
    LEGEND = 170,
    BAR = 24,
    LEAST_BAR = 280,
    MOST_BAR = 420,
    TRIAD = 46
};
enum { TITLE = 25, LABEL = 18, CAPTION = 15, TICK = 15 }; /* sizes of letters */

/* Unit vectors to the viewer's right, up, and back to the viewer. */
struct view {
    double right[3], up[3], back[3];
};

/* What a panel shows: its colours' ends, and its extent on the screen, m. */
struct shown {
    double low, high;
    double left, right, bottom, top;
};

struct layout {
    const struct hobe_picture *picture;
    struct view view;
    struct shown *shown; /* [panels] */
    int columns, rows;
    int width, height;              /* pixels */
    double unit;                    /* pixels of a unit */
    double top;                     /* below the title, pixels */
    double first;                   /* where the first row begins, pixels */
    double head;                    /* height of label and caption, pixels */
    double cell_width, cell_height; /* of a drawing without its head, pixels */
    double metre;                   /* pixels of a metre where all panels have the same, else 0 */
};

/* How a panel's drawing maps to its own pixels: x = left + metre * right.p, ... */
struct projection {
    const struct view *view;
    double metre, left, top;
};

/* HOBE_BAD_INPUT where the picture would be too high.  layout_free frees what it made. */
enum hobe_status layout_new(const struct hobe_picture *picture, struct layout *layout,
                            struct hobe_error *err);
void layout_free(struct layout *layout);

/* Upper left corner of panel i's cell, pixels. */
void layout_cell(const struct layout *layout, int i, double *x, double *y);

/* Panel i in the middle of its cell. */
struct projection layout_projection(const struct layout *layout, int i);

/* The point p in the pixels of its panel's drawing; value 0. */
struct hobe_vertex project(const struct projection *projection, const double p[3]);

/* Point i of a surface with its value, `scale` times its displacement away from the reference. */
struct hobe_vertex project_point(const struct projection *projection,
                                 const struct hobe_surface *surface, int i, double scale);

#endif
