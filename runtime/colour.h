/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Colour maps whose lightness says as much as their hue. */
#ifndef HOBE_COLOUR_H
#define HOBE_COLOUR_H

enum hobe_colours {
    HOBE_COLOURS_RISING, /* dark blue to yellow, evenly lighter: for fields of one sign */
    HOBE_COLOURS_SIGNED  /* blue, near white, red, equally light on both sides of 0.5 */
};

/* The colour of t in [0,1] (held at the ends beyond): rgb[3] in [0,1], sRGB. */
void hobe_colour(enum hobe_colours colours, double t, double *rgb);

/* Lightness L of a colour in Oklab, 0 black to 1 white, in which equal steps look equal. */
double hobe_lightness(const double *rgb);

#endif
