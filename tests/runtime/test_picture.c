/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures: colours, numbers, surfaces, the z-buffer, and what stands in a PNG. */
#include "check.h"
#include "colour.h"
#include "picture.h"
#include "raster.h"
#include "scale.h"
#include "scene.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- colours -------------------------------------------------------------------------------- */

/* Within sRGB, and lightness as promised: straight for RISING, alike on both sides for SIGNED.  The
 * matrices have ten digits, and there and back they leave 1e-7. */
static void check_colours(void)
{
    const double rounding = 1e-6;
    double first[3], last[3];
    hobe_colour(HOBE_COLOURS_RISING, 0, first);
    hobe_colour(HOBE_COLOURS_RISING, 1, last);
    const double from = hobe_lightness(first), to = hobe_lightness(last);
    check_that(to - from > 0.5, "lightness spans %g", to - from);
    for (int i = 0; i <= 1000; i++) {
        double rgb[2][3], mirror[3];
        const double t = i / 1000.;
        hobe_colour(HOBE_COLOURS_RISING, t, rgb[0]);
        hobe_colour(HOBE_COLOURS_SIGNED, t, rgb[1]);
        hobe_colour(HOBE_COLOURS_SIGNED, 1 - t, mirror);
        check_absolute(hobe_lightness(rgb[0]), from + t * (to - from), rounding, "rising at %g", t);
        check_absolute(hobe_lightness(rgb[1]), hobe_lightness(mirror), rounding, "signed at %g", t);
        for (int k = 0; k < 6; k++)
            check_that(rgb[k / 3][k % 3] >= 0 && rgb[k / 3][k % 3] <= 1, "map %d at %g: %g", k / 3,
                       t, rgb[k / 3][k % 3]);
    }
    hobe_colour(HOBE_COLOURS_SIGNED, -3, first);
    hobe_colour(HOBE_COLOURS_SIGNED, 0, last);
    check_that(!memcmp(first, last, sizeof first), "the map is held beyond its ends");
}

/* ---- numbers -------------------------------------------------------------------------------- */

static void check_text(const char *text, const char *expected)
{
    check_that(!strcmp(text, expected), "\"%s\" instead of \"%s\"", text, expected);
}

static void check_numbers(void)
{
    static const struct {
        double range, step;
        int most;
    } steps[] = {{1, 0.2, 8}, {1, 0.1, 10},    {2, 0.5, 5},
                 {7.3, 1, 8}, {1e-5, 2e-6, 8}, {999, 200, 8}};
    char text[HOBE_NUMBER];
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++)
        check_relative(hobe_tick_step(steps[i].range, steps[i].most), steps[i].step, 1e-12,
                       "steps of %g", steps[i].range);
    for (int i = 0; i < 200; i++) {
        const double range = exp(random_real(-30, 30)), step = hobe_tick_step(range, 8);
        check_that(range / step <= 8 + 1e-6 && range / step >= 3, "%g in steps of %g", range, step);
    }
    hobe_tick_text(-0.25, 0.05, text);
    check_text(text, "−0.25");
    hobe_tick_text(-1e-17, 0.05, text);
    check_text(text, "0.00");
    hobe_tick_text(1500, 500, text);
    check_text(text, "1500");
    hobe_number_text(4.923e-3, text);
    check_text(text, "4.92·10⁻³");
    hobe_number_text(-65.4e-6, text);
    check_text(text, "-65.4·10⁻⁶");
    hobe_number_text(999.7, text);
    check_text(text, "1·10³");
    hobe_number_text(12.5, text);
    check_text(text, "12.5");
    hobe_number_text(0, text);
    check_text(text, "0");
}

/* ---- the z-buffer --------------------------------------------------------------------------- */

enum { SIZE = 60 };

/* Two triangles across each other in a random order of drawing. */
static void draw_two(struct hobe_raster *raster, int order, const struct hobe_vertex p[2][3])
{
    static const double palette[HOBE_PALETTE][3] = {[0] = {1, 0, 0},
                                                    [HOBE_PALETTE - 1] = {0, 0, 1}};
    const struct hobe_paint paint = {palette, 0, 1, 0};
    struct hobe_error err;
    if (hobe_raster_new(raster, SIZE, SIZE, &err))
        check_stop("%s", err.message);
    for (int i = 0; i < 2; i++)
        hobe_raster_triangle(raster, p[(i + order) % 2], &paint);
}

static double area_of(const struct hobe_vertex p[3])
{
    return fabs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y)) / 2;
}

/* What is seen does not depend on the order of drawing; a triangle covers its area, but for one
 * sample in each row of samples at either side. */
static void check_raster(void)
{
    struct hobe_vertex p[2][3];
    struct hobe_raster raster[3];
    uint32_t pixel[3][SIZE * SIZE];
    double area = 0;
    for (int i = 0; i < 6; i++)
        p[i / 3][i % 3] = (struct hobe_vertex){random_real(0, SIZE), random_real(0, SIZE),
                                               random_real(-9, 9), i / 3};
    for (int k = 0; k < 3; k++)
        draw_two(raster + k, k, (const struct hobe_vertex(*)[3])p);
    memset(raster[2].sample, 0, 9 * SIZE * SIZE * sizeof *raster[2].sample);
    static const double white[HOBE_PALETTE][3];
    hobe_raster_triangle(raster + 2, p[0], &(struct hobe_paint){white, 0, 1, 0});
    for (int k = 0; k < 3; k++) {
        hobe_raster_pixels(raster + k, pixel[k]);
        hobe_raster_free(raster + k);
    }
    for (int i = 0; i < SIZE * SIZE; i++)
        area += (pixel[2][i] >> 24) / 255.;
    check_absolute(area, area_of(p[0]), 2 * SIZE / 3., "area of a triangle");
    check_that(!memcmp(pixel[0], pixel[1], sizeof pixel[0]), "the order of drawing shows");
}

/* ---- surfaces ------------------------------------------------------------------------------- */

/* Volume under a closed surface by the divergence theorem, reference or displaced. */
static double volume_of(const struct hobe_surface *s, double scale)
{
    double volume = 0;
    for (int t = 0; t < s->triangles; t++) {
        double p[3][3];
        for (int k = 0; k < 9; k++) {
            const int i = s->triangle[t][k / 3];
            p[k / 3][k % 3] = s->point[i][k % 3] + scale * s->displacement[i][k % 3];
        }
        volume += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                   p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                   p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
                  6;
    }
    return volume;
}

/* Area of a section's surface; each triangle must look along +x. */
static double section_area(const struct hobe_surface *s, const char *name)
{
    double area = 0, least = INFINITY;
    for (int t = 0; t < s->triangles; t++) {
        const double *a = s->point[s->triangle[t][0]], *b = s->point[s->triangle[t][1]];
        const double *c = s->point[s->triangle[t][2]];
        const double one = ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
        least = fmin(least, one);
        area += one;
    }
    check_that(least > -1e-18, "%s: a triangle is turned over, area %g", name, least);
    return area;
}

/* The outline runs around the material: its shoelace sum is the area, too. */
static double outline_area(const struct hobe_surface *s)
{
    double area = 0;
    for (int e = 0; e < s->outline; e++) {
        const double *a = s->point[s->edge[e][0]], *b = s->point[s->edge[e][1]];
        area += (a[1] * b[2] - b[1] * a[2]) / 2;
    }
    return area;
}

static hobe_section *sections(int i, const char **name)
{
    static const struct hobe_profile_sizes sizes = {
        .height = .2, .width = .1, .flange = .02, .web = .01};
    static const double corner[7][2] = {{0, 0},    {3, 0},    {3, 2},  {1, 2},
                                        {2.5, .5}, {2.8, .5}, {2.5, 1}};
    struct hobe_error err;
    hobe_section *made[] = {
        i == 0 ? hobe_section_rectangle(.3, .1, HOBE_WARPING_SERIES, &err) : NULL,
        i == 1 ? hobe_section_circle(.2, &err) : NULL,
        i == 2 ? hobe_section_tube(.2, .15, &err) : NULL,
        i == 3 ? hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err) : NULL,
        i == 4 ? hobe_section_hollow(.3, .2, .02, HOBE_WARPING_SOLVED, &err) : NULL,
        i == 5 ? hobe_section_polygon(2, (const int[]){4, 3}, corner, &err) : NULL};
    static const char *const names[] = {"rectangle", "circle", "tube", "I", "hollow", "polygon"};
    if (!made[i])
        check_stop("%s: %s", names[i], err.message);
    *name = names[i];
    return made[i];
}
enum { SECTIONS = 6, FINENESS = 10 };

/* The polygon of 8 n corners has sin(t)/t of the circle's area, t = pi/(4 n). */
static double share(int i)
{
    const double t = M_PI / (8 * FINENESS);
    return i == 1 || i == 2 ? sin(t) / t : 1;
}

/* Two materials side by side: a line where they touch. */
static void check_composite(void)
{
    struct hobe_error err;
    const struct hobe_material steel = {.E = 210e9, .nu = 0.3, .k2 = 1, .k3 = 1};
    const double touch = 0.1;
    hobe_section *left = rectangle(0.2, touch), *right = rectangle(0.1, 3 * touch);
    const struct hobe_section_part part[2] = {{left, {0.15, 0.05}, steel}, {right, {0, 0}, steel}};
    hobe_section *both = hobe_section_composite(2, part, &err);
    struct hobe_surface face;
    if (!both || hobe_section_surface(both, FINENESS, &face, &err))
        check_stop("composite: %s", err.message);
    double seam = 0;
    for (int e = face.outline; e < face.edges; e++)
        seam += distance(face.point[face.edge[e][0]], face.point[face.edge[e][1]]);
    check_relative(seam, touch, 1e-9, "where two parts touch"); /* gmsh's tolerance of geometry */
    check_relative(outline_area(&face), 5 * touch * touch, 1e-9, "composite: area in the outline");
    hobe_surface_free(&face);
    hobe_section_free(both);
    hobe_section_free(left);
    hobe_section_free(right);
}

static void check_section_surfaces(void)
{
    for (int i = 0; i < SECTIONS; i++) {
        const char *name;
        hobe_section *section = sections(i, &name);
        const double A = properties_of(section).A * share(i), depth = 0.07;
        struct hobe_surface flat, stub;
        struct hobe_error err;
        double w[4];
        if (hobe_section_field(section, "w", FINENESS, 0, &flat, &err) ||
            hobe_section_field(section, "wy", FINENESS, depth, &stub, &err))
            check_stop("%s: %s", name, err.message);
        check_relative(section_area(&flat, name), A, 1e-12, "%s: area of the triangles", name);
        check_relative(outline_area(&flat), A, 1e-12, "%s: area within the edges", name);
        const int p = (int)random_real(0, flat.points);
        hobe_section_function(section, "w", flat.point[p][1], flat.point[p][2], w, &err);
        check_that(flat.value[p] == w[0] && flat.displacement[p][0] == -w[0], "%s: w", name);
        check_that(stub.points == flat.points + 2 * flat.edges, "%s: points of a stub", name);
        check_absolute(stub.point[stub.points - 1][0], depth, 0, "%s: depth", name);
        hobe_surface_free(&flat);
        hobe_surface_free(&stub);
        hobe_section_free(section);
    }
}

/* The skin of a straight beam is closed, and holds A L; the flat beam of a stretched state as well,
 * which displaces it by a homogeneous field. */
static void check_beam_surfaces(void)
{
    struct hobe_error err;
    for (int i = 0; i < SECTIONS; i += 3) {
        const char *name;
        hobe_section *section = sections(i, &name);
        const struct hobe_beam beam = beam_along_x("MGD30", 3, section, 1e9, 0, 2);
        hobe_model *model = cantilever(&beam, 1);
        add_force(model, "beam", 1, 1e6, 0, 0);
        hobe_solution *solution = solve(model, 1);
        const double tip = point_of(solution, "beam", 1, 0, 0).u[0];
        const double V = 2 * properties_of(section).A;
        struct hobe_surface skin;
        if (hobe_solution_surface(solution, hobe_find_field("ux", 0, &err), &skin, &err))
            check_stop("%s", err.message);
        check_relative(volume_of(&skin, 0), V, 1e-12, "%s: volume", name);
        /* nu = 0: the section keeps its size, as round-off of Newton's iteration leaves it */
        check_relative(volume_of(&skin, 1), V * (1 + tip / 2), 1e-8, "%s: stretched", name);
        double most = 0;
        for (int p = 0; p < skin.points; p++)
            most = fmax(most, skin.value[p]);
        check_relative(most, tip, 1e-8, "%s: largest ux", name);
        hobe_surface_free(&skin);
        if (hobe_solution_surface(solution, hobe_find_field("sxx", 0, &err), &skin, &err))
            check_stop("%s", err.message);
        for (int p = 0; p < skin.points; p++) /* and the stress is the force over the area */
            if (!check_relative(skin.value[p] * V, 2 * 1e6, 1e-8, "%s: sxx", name))
                break;
        hobe_surface_free(&skin);
        hobe_solution_free(solution);
        hobe_model_free(model);
        hobe_section_free(section);
    }
    check_that(!hobe_find_field("uw", 0, &err) && strstr(err.message, "\"uw\", only by u, ux"),
               "%s", err.message);
    check_that(!hobe_find_field("twist", 1, &err) && strstr(err.message, "mode shapes"), "%s",
               err.message);
}

/* A slice of a beam that is twisted by two right angles and stretched, with nu = 0: in its own
 * plane the section is as before, and out of it it warps by -kappa w. */
static void check_slice(void)
{
    struct hobe_error err;
    struct hobe_surface slice;
    const double L = 4, turn = M_PI;
    hobe_section *section = rectangle(0.02, 0.03);
    const struct hobe_beam beam = beam_along_x("MGD30w", 20, section, 1e9, 0, L);
    hobe_model *model = cantilever(&beam, 1);
    add_moment(model, "beam", 1, turn / L * 0.5e9 * properties_of(section).J, 0, 0);
    add_force(model, "beam", 1, 1e9 * properties_of(section).A * 1e-3, 0, 0);
    hobe_solution *solution = solve(model, 4);
    if (hobe_solution_slice(solution, "beam", 0.3, hobe_find_field("twist", 0, &err), &slice, &err))
        check_stop("%s", err.message);
    for (int i = 0; i < slice.points; i++) {
        const double *p = slice.point[i], *d = slice.displacement[i];
        double w[4];
        if (hobe_section_function(section, "w", p[1], p[2], w, &err))
            check_stop("%s", err.message);
        /* second order: (kappa h)^2 = 6e-4, and the stretch, 1e-3, times w and h */
        check_absolute(d[0], -turn / L * w[0], 2e-3 * turn / L * 0.02 * 0.03, "it warps");
        check_absolute(hypot(d[1], d[2]), 0, 2e-3 * 0.03, "it keeps its shape");
        check_absolute(slice.value[i], 0.3 * turn, 2e-3 * turn, "and has the twist");
    }
    hobe_surface_free(&slice);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- pictures ------------------------------------------------------------------------------- */

struct stream {
    const struct hobe_text *text;
    size_t at;
};

static cairo_status_t next(void *p, unsigned char *bytes, unsigned size)
{
    struct stream *stream = p;
    if (stream->at + size > stream->text->size)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(bytes, stream->text->at + stream->at, size);
    stream->at += size;
    return CAIRO_STATUS_SUCCESS;
}

/* Red, green and blue of a pixel. */
static void pixel_at(cairo_surface_t *image, int x, int y, int rgb[3])
{
    uint32_t argb;
    const size_t stride = (size_t)cairo_image_surface_get_stride(image);
    memcpy(&argb, cairo_image_surface_get_data(image) + (size_t)y * stride + 4 * (size_t)x, 4);
    for (int k = 0; k < 3; k++)
        rgb[k] = argb >> (16 - 8 * k) & 255;
}

/* A square alone, without a title: it fills a square of 0.55 of the picture's width, from the
 * margin of 28 on; w is odd about both middle lines. */
static void check_square(const struct hobe_text *png)
{
    struct stream stream = {png, 0};
    cairo_surface_t *image = cairo_image_surface_create_from_png_stream(next, &stream);
    const int side = 660, left = 28, width = cairo_image_surface_get_width(image);
    int rgb[3], other[3], filled = 0, top = 0;
    check_that(width == left + side + 20 + 170 + 20, "%d pixels wide", width);
    while (top < 100 && (pixel_at(image, left + side / 2, top, rgb), rgb[0] == 255))
        top++;
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            pixel_at(image, left + x, top + y, rgb);
            filled += rgb[0] + rgb[1] + rgb[2] < 3 * 255;
        }
    /* one row of pixels may be missed where the edge stands within it */
    check_that(filled > (side - 2) * (side - 2), "%d of %d pixels are filled", filled, side * side);
    int odd = 0;
    for (int i = 0; i < 100; i++) {
        const int x = (int)random_real(10, side / 2 - 30), y = (int)random_real(10, side / 2 - 30);
        pixel_at(image, left + x, top + y, rgb);
        pixel_at(image, left + side - 1 - x, top + y, other);
        odd += (rgb[0] >= rgb[2]) == (other[0] <= other[2]);
    }
    check_that(odd >= 95, "%d of 100 places have the other sign across the middle", odd);
    cairo_surface_destroy(image);
}

static void check_pictures(void)
{
    hobe_section *section = rectangle(1, 1);
    struct hobe_error err;
    struct hobe_surface surface;
    if (hobe_section_field(section, "w", 20, 0, &surface, &err))
        check_stop("%s", err.message);
    const struct hobe_panel panel = {.surface = &surface};
    const struct hobe_picture picture = {.field = "w",
                                         .unit = "m²",
                                         .colours = HOBE_COLOURS_SIGNED,
                                         .width = 1200,
                                         .axes = "xyz",
                                         .azimuth = 180,
                                         .panels = 1,
                                         .panel = &panel};
    struct hobe_text png[2] = {{0}};
    for (int i = 0; i < 2; i++)
        if (hobe_picture_png(&picture, png + i, &err))
            check_stop("%s", err.message);
    check_that(png[0].size == png[1].size && !memcmp(png[0].at, png[1].at, png[0].size),
               "the same scene, the same bytes");
    check_square(png);
    for (int i = 0; i < 2; i++)
        hobe_text_free(png + i);
    hobe_surface_free(&surface);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    check_colours();
    check_numbers();
    for (int i = 0; i < 20; i++)
        check_raster();
    check_section_surfaces();
    check_composite();
    check_beam_surfaces();
    check_slice();
    check_pictures();
    return check_report();
}
