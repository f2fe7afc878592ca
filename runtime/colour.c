/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps are straight between a few colours in Oklab (B. Ottosson 2020, whose matrices these are), a
 * space in which distance is what the eye sees: L lightness, a green to red, b blue to yellow. */
#include "colour.h"

#include <math.h>

enum { STOPS = 5 };

/* At t = 0, 1/4, 1/2, 3/4, 1: L, chroma, hue in degrees.  All of it lies within sRGB. */
static const double stops[][STOPS][3] = {
    [HOBE_COLOURS_RISING] = {{0.30, 0.13, 290},
                             {0.4525, 0.11, 250},
                             {0.605, 0.10, 195},
                             {0.7575, 0.15, 145},
                             {0.91, 0.17, 105}},
    [HOBE_COLOURS_SIGNED] =
        {{0.40, 0.13, 262}, {0.67, 0.11, 250}, {0.94, 0, 0}, {0.67, 0.14, 35}, {0.40, 0.15, 27}},
};

static double encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

static double decode(double srgb)
{
    return srgb <= 0.04045 ? srgb / 12.92 : pow((srgb + 0.055) / 1.055, 2.4);
}

static double cube(double x)
{
    return x * x * x;
}

void hobe_colour(enum hobe_colours colours, double t, double *rgb)
{
    const double at = fmin(fmax(t, 0), 1) * (STOPS - 1);
    const int i = at < STOPS - 1 ? (int)at : STOPS - 2;
    double lab[2][3], c[3];
    for (int k = 0; k < 2; k++) {
        const double *stop = stops[colours][i + k], hue = stop[2] * M_PI / 180;
        lab[k][0] = stop[0];
        lab[k][1] = stop[1] * cos(hue);
        lab[k][2] = stop[1] * sin(hue);
    }
    for (int k = 0; k < 3; k++)
        c[k] = lab[0][k] + (at - i) * (lab[1][k] - lab[0][k]);
    const double l = cube(c[0] + 0.3963377774 * c[1] + 0.2158037573 * c[2]);
    const double m = cube(c[0] - 0.1055613458 * c[1] - 0.0638541728 * c[2]);
    const double s = cube(c[0] - 0.0894841775 * c[1] - 1.2914855480 * c[2]);
    rgb[0] = encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s);
    rgb[1] = encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s);
    rgb[2] = encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
}

double hobe_lightness(const double *rgb)
{
    const double r = decode(rgb[0]), g = decode(rgb[1]), b = decode(rgb[2]);
    return 0.2104542553 * cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
           0.7936177850 * cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
           0.0040720468 * cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}
