/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of surfaces with a field in colours, drawn without a display. */
#ifndef HOBE_PICTURE_H
#define HOBE_PICTURE_H

#include "colour.h"
#include "output.h"
#include "surface.h"

/* Marks in the drawing of a section. */
enum { HOBE_MARK_CENTROID, HOBE_MARK_SHEAR_CENTRE, HOBE_MARKS };

/* One drawing.  All memory belongs to the caller. */
struct hobe_panel {
    const char *label; /* may be NULL */
    const struct hobe_surface *surface;
    double scale;            /* of its displacements */
    int reference;           /* draw its edges without displacement in grey */
    const double (*mark)[3]; /* [HOBE_MARKS] places, m; may be NULL */
};

enum hobe_picture_range {
    HOBE_RANGE_SHARED,  /* the colours mean the same in all panels */
    HOBE_RANGE_AMOUNTS, /* each panel has all colours, and says what its largest value is */
    HOBE_RANGE_RELATIVE /* each panel has all colours; amounts mean nothing */
};

/* Panels in a grid, row by row, all seen from the same side.  Strings are UTF-8; title
 * and unit may be NULL. */
struct hobe_picture {
    const char *title;
    const char *field, *unit;  /* what is coloured: "w", "m²" */
    enum hobe_colours colours; /* SIGNED: from -max to max; RISING: from the smallest on */
    enum hobe_picture_range range;
    double limit;   /* > 0: of a shared range; colours go no further, what is larger has the last */
    int width;      /* pixels, at most; less where the panels do not need it */
    int columns;    /* 0: as many as look well */
    int isolines;   /* draw lines of equal value */
    int same_scale; /* a metre is as long in every panel */
    const char *axes;          /* names of the three axes, "xyz" */
    double azimuth, elevation; /* of the viewer, degrees: from axis x towards y, and above the plane
                                  of both */
    int panels;                /* >= 1 */
    const struct hobe_panel *panel; /* [panels] */
};

enum { HOBE_PICTURE_LEAST = 300, HOBE_PICTURE_MOST = 4000 }; /* width */

/* Appends the picture as the bytes of a PNG file.  HOBE_BAD_INPUT where it would be too high. */
enum hobe_status hobe_picture_png(const struct hobe_picture *picture, struct hobe_text *png,
                                  struct hobe_error *err);

#endif
