/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Letters, colour bar and PNG.  The only room that talks to cairo. */
#include "picture_layout.h"
#include "scale.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double LINE = 1.4, LARGE = 400;   /* width of edges, units, in cells this wide */
static const double FAINT = 0.65;              /* width of the reference's over that */
static const double BLACK = 0.15, GREY = 0.66; /* of the surface's edges, of the reference's */
static const double INK = 0.13, PALE = 0.4;    /* greys of letters */
static const double BEHIND = -1e30;            /* depth */
static const int BLEED = 4;                    /* pixels around a drawing for its lines */
static const double END_ON = 0.15;             /* length of an axis on the screen over its own */
enum { MOST_TICKS = 8, ISOLINES = 16 };        /* steps over the whole range */

/* What drawing needs beside the layout. */
struct drawing {
    const struct layout *at;
    cairo_t *cr;
    double palette[HOBE_PALETTE][3];
};

static void grey(cairo_t *cr, double level)
{
    cairo_set_source_rgb(cr, level, level, level);
}

/* ---- letters -------------------------------------------------------------------------------- */

static void use_font(cairo_t *cr, double size)
{
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cr, options);
    cairo_font_options_destroy(options);
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, size);
}

/* One line from x on, its base at y, in letters of `size` units; smaller ones where it would be
 * wider than `most`.  centred: in the middle of x and x + most. */
static void write_line(const struct drawing *d, double x, double y, double size, double most,
                       int centred, const char *text)
{
    cairo_text_extents_t box;
    use_font(d->cr, size * d->at->unit);
    cairo_text_extents(d->cr, text, &box);
    if (box.x_advance > most) {
        use_font(d->cr, size * d->at->unit * most / box.x_advance);
        cairo_text_extents(d->cr, text, &box);
    }
    cairo_move_to(d->cr, centred ? x + (most - box.x_advance) / 2 : x, y);
    cairo_show_text(d->cr, text);
}

/* ---- panels --------------------------------------------------------------------------------- */

/* The surface's edges, or those of its reference, which stand behind everything. */
static void draw_edges(struct hobe_raster *raster, const struct projection *projection,
                       const struct hobe_panel *panel, int reference, double width)
{
    const struct hobe_surface *surface = panel->surface;
    const double scale = reference ? 0 : panel->scale;
    for (int e = 0; e < surface->edges; e++) {
        const int *end = surface->edge[e];
        struct hobe_vertex a = project_point(projection, surface, end[0], scale);
        struct hobe_vertex b = project_point(projection, surface, end[1], scale);
        if (reference)
            a.depth = b.depth = BEHIND;
        hobe_raster_line(raster, &a, &b, (reference ? FAINT : 1) * width, reference ? GREY : BLACK);
    }
}

static void draw_surface(struct hobe_raster *raster, const struct projection *projection,
                         const struct hobe_surface *surface, double scale,
                         const struct hobe_paint *paint)
{
    for (int t = 0; t < surface->triangles; t++) {
        struct hobe_vertex corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = project_point(projection, surface, surface->triangle[t][k], scale);
        hobe_raster_triangle(raster, corner, paint);
    }
}

/* Puts the raster onto the page, its upper left corner at whole pixels x, y. */
static enum hobe_status blit(const struct drawing *d, const struct hobe_raster *raster, int x,
                             int y, struct hobe_error *err)
{
    const size_t pixels = (size_t)raster->width * (size_t)raster->height;
    uint32_t *pixel = hobe_alloc(pixels, sizeof *pixel, err);
    if (!pixel)
        return HOBE_NO_MEMORY;
    hobe_raster_pixels(raster, pixel);
    cairo_surface_t *image = cairo_image_surface_create_for_data(
        (unsigned char *)pixel, CAIRO_FORMAT_ARGB32, raster->width, raster->height,
        raster->width * (int)sizeof *pixel);
    cairo_set_source_surface(d->cr, image, x, y);
    cairo_paint(d->cr);
    grey(d->cr, 0); /* lets go of the image */
    cairo_surface_destroy(image);
    hobe_free(pixel);
    return HOBE_OK;
}

static struct hobe_paint paint_of(const struct drawing *d, int i)
{
    const struct hobe_picture *picture = d->at->picture;
    const struct shown *shown = d->at->shown + i;
    const double range = shown->high - shown->low;
    return (struct hobe_paint){(const double(*)[3])d->palette, shown->low, shown->high,
                               picture->isolines && range > 0 ? hobe_tick_step(range, ISOLINES)
                                                              : 0};
}

/* The drawing of panel i with its cell's upper left corner at whole pixels x, y. */
static enum hobe_status draw_panel(const struct drawing *d, int i, int x, int y,
                                   struct hobe_error *err)
{
    const struct layout *at = d->at;
    const struct hobe_panel *panel = at->picture->panel + i;
    const struct hobe_paint paint = paint_of(d, i);
    const double line = LINE * at->unit * fmin(1, sqrt(at->cell_width / (LARGE * at->unit)));
    struct projection projection = layout_projection(at, i);
    struct hobe_raster raster;
    projection.left += BLEED;
    projection.top += BLEED;
    enum hobe_status status = hobe_raster_new(&raster, (int)ceil(at->cell_width) + 2 * BLEED,
                                              (int)ceil(at->cell_height) + 2 * BLEED, err);
    if (status)
        return status;
    if (panel->reference)
        draw_edges(&raster, &projection, panel, 1, line);
    draw_surface(&raster, &projection, panel->surface, panel->scale, &paint);
    draw_edges(&raster, &projection, panel, 0, line);
    status = blit(d, &raster, x - BLEED, y - BLEED, err);
    hobe_raster_free(&raster);
    return status;
}

/* ---- marks ---------------------------------------------------------------------------------- */

static const char *const mark_words[HOBE_MARKS] = {"centroid", "shear centre"};

/* The lines of mark k at x, y: a cross for the centroid, a ring for the shear centre. */
static void draw_mark(const struct drawing *d, int k, double x, double y, double width,
                      double level)
{
    const double size = (k == HOBE_MARK_CENTROID ? 7 : 5.5) * d->at->unit;
    cairo_new_path(d->cr);
    if (k == HOBE_MARK_CENTROID) {
        cairo_move_to(d->cr, x - size, y);
        cairo_line_to(d->cr, x + size, y);
        cairo_move_to(d->cr, x, y - size);
        cairo_line_to(d->cr, x, y + size);
    } else
        cairo_arc(d->cr, x, y, size, 0, 2 * M_PI);
    grey(d->cr, level);
    cairo_set_line_width(d->cr, width * d->at->unit);
    cairo_stroke(d->cr);
}

/* Black on white, so that they show on any colour. */
static void draw_marks(const struct drawing *d, int i, double x, double y)
{
    const struct hobe_panel *panel = d->at->picture->panel + i;
    const struct projection projection = layout_projection(d->at, i);
    for (int pass = 0; panel->mark && pass < 2; pass++)
        for (int k = 0; k < HOBE_MARKS; k++) {
            const struct hobe_vertex p = project(&projection, panel->mark[k]);
            draw_mark(d, k, x + p.x, y + p.y, pass ? 1.7 : 4.5, pass ? 0 : 1);
        }
}

/* ---- cells ---------------------------------------------------------------------------------- */

/* Its label, and what its largest value is. */
static void draw_head(const struct drawing *d, int i, double x, double y)
{
    const struct layout *at = d->at;
    const struct hobe_picture *picture = at->picture;
    const char *label = picture->panel[i].label;
    char number[HOBE_NUMBER], caption[200];
    if (label) {
        y += 1.3 * LABEL * at->unit;
        grey(d->cr, INK);
        write_line(d, x, y, LABEL, at->cell_width, 1, label);
    }
    if (picture->range != HOBE_RANGE_AMOUNTS)
        return;
    hobe_number_text(at->shown[i].high, number);
    if (at->shown[i].high > 0)
        snprintf(caption, sizeof caption, "|%.40s| ≤ %s %.40s", picture->field, number,
                 picture->unit ? picture->unit : "");
    else
        snprintf(caption, sizeof caption, "%.40s = 0", picture->field);
    grey(d->cr, PALE);
    write_line(d, x, y + 1.4 * CAPTION * at->unit, CAPTION, at->cell_width, 1, caption);
}

static enum hobe_status draw_cells(const struct drawing *d, struct hobe_error *err)
{
    for (int i = 0; i < d->at->picture->panels; i++) {
        double x, y;
        layout_cell(d->at, i, &x, &y);
        draw_head(d, i, x, y);
        x = round(x);
        y = round(y + d->at->head);
        const enum hobe_status status = draw_panel(d, i, (int)x, (int)y, err);
        if (status)
            return status;
        draw_marks(d, i, x, y);
    }
    return HOBE_OK;
}

/* ---- the legend ----------------------------------------------------------------------------- */

/* What the colours show: "w, 10⁻³ m²", or "w / max |w|" where that is another in each panel. */
static void name_bar(const struct hobe_picture *picture, int power, char *text, size_t size)
{
    char ten[HOBE_NUMBER] = "";
    const char *unit = picture->unit ? picture->unit : "";
    const int bars = *picture->field == '|';
    if (power) {
        hobe_power_text(power, ten);
        strcat(ten, " ");
    }
    if (picture->range != HOBE_RANGE_SHARED)
        snprintf(text, size, "%.40s / max%s%.40s%s", picture->field, bars ? "" : " |",
                 bars ? "" : picture->field, bars ? "" : "|");
    else
        snprintf(text, size, "%.40s%s%s%.40s", picture->field, *unit || *ten ? ", " : "", ten,
                 unit);
}

static void draw_ticks(const struct drawing *d, double x, double y, double height, double low,
                       double high)
{
    const double unit = d->at->unit, step = hobe_tick_step(high - low, MOST_TICKS);
    const double first = ceil(low / step - 1e-9), last = floor(high / step + 1e-9);
    for (int i = 0; i <= last - first; i++) {
        char text[HOBE_NUMBER];
        const double v = (first + i) * step;
        const double at = y + height * (high - v) / (high - low);
        hobe_tick_text(v, step, text);
        grey(d->cr, INK);
        cairo_set_line_width(d->cr, 1.2 * unit);
        cairo_move_to(d->cr, x, at);
        cairo_line_to(d->cr, x + 5 * unit, at);
        cairo_stroke(d->cr);
        write_line(d, x + 10 * unit, at + 0.36 * TICK * unit, TICK, (LEGEND - BAR - 10) * unit, 0,
                   text);
    }
}

/* The bar from y down. */
static void draw_bar(const struct drawing *d, double x, double y, double height)
{
    const struct hobe_picture *picture = d->at->picture;
    const double unit = d->at->unit;
    const int shared = picture->range == HOBE_RANGE_SHARED;
    double low = picture->colours == HOBE_COLOURS_SIGNED ? -1 : 0, high = 1;
    char name[200];
    if (shared) {
        low = d->at->shown->low;
        high = d->at->shown->high;
    }
    const int power = hobe_tick_power(fmax(fabs(low), fabs(high)));
    name_bar(picture, power, name, sizeof name);
    grey(d->cr, INK);
    write_line(d, x, y, LABEL, LEGEND * unit, 0, name);
    y += LABEL * unit;
    height -= LABEL * unit;
    for (int i = 0; i < HOBE_PALETTE; i++) { /* each down to the end, so that no seams show */
        const double *rgb = d->palette[HOBE_PALETTE - 1 - i], from = height * i / HOBE_PALETTE;
        cairo_set_source_rgb(d->cr, rgb[0], rgb[1], rgb[2]);
        cairo_rectangle(d->cr, x, y + from, BAR * unit, height - from);
        cairo_fill(d->cr);
    }
    grey(d->cr, INK);
    cairo_set_line_width(d->cr, unit);
    cairo_rectangle(d->cr, x, y, BAR * unit, height);
    cairo_stroke(d->cr);
    if (high > low)
        draw_ticks(d, x + BAR * unit, y, height, low / pow(10, power), high / pow(10, power));
}

static void draw_mark_words(const struct drawing *d, double x, double y)
{
    const double unit = d->at->unit;
    for (int k = 0; k < HOBE_MARKS; k++, y += 1.7 * CAPTION * unit) {
        draw_mark(d, k, x + BAR * unit / 2, y - 0.36 * CAPTION * unit, 1.7, 0);
        grey(d->cr, INK);
        write_line(d, x + (BAR + 10) * unit, y, CAPTION, (LEGEND - BAR - 10) * unit, 0,
                   mark_words[k]);
    }
}

/* An axis that points at the viewer, a ring with a dot, or away, a ring with a cross. */
static void draw_axis_end_on(const struct drawing *d, double x, double y, int towards)
{
    const double unit = d->at->unit, r = 5.5 * unit, c = r * M_SQRT1_2;
    cairo_new_path(d->cr);
    cairo_arc(d->cr, x, y, r, 0, 2 * M_PI);
    cairo_stroke(d->cr);
    if (towards) {
        cairo_arc(d->cr, x, y, r / 3, 0, 2 * M_PI);
        cairo_fill(d->cr);
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        cairo_move_to(d->cr, x - c, y - side * c);
        cairo_line_to(d->cr, x + c, y + side * c);
    }
    cairo_stroke(d->cr);
}

/* An arrow from x, y along the unit vector (ex, ey). */
static void draw_arrow(const struct drawing *d, double x, double y, double ex, double ey,
                       double length)
{
    const double tip = 9 * d->at->unit, wide = tip / 2.5, ax = x + length * ex,
                 ay = y + length * ey;
    cairo_move_to(d->cr, x, y);
    cairo_line_to(d->cr, ax, ay);
    cairo_stroke(d->cr);
    cairo_move_to(d->cr, ax + tip * ex, ay + tip * ey);
    cairo_line_to(d->cr, ax - wide * ey, ay + wide * ex);
    cairo_line_to(d->cr, ax + wide * ey, ay - wide * ex);
    cairo_fill(d->cr);
}

static void draw_axis(const struct drawing *d, double x, double y, int axis)
{
    static const double rgb[3][3] = {{0.75, 0.15, 0.15}, {0.1, 0.5, 0.2}, {0.15, 0.3, 0.75}};
    const struct view *view = &d->at->view;
    const double unit = d->at->unit, ex = view->right[axis], ey = -view->up[axis];
    const double seen = hypot(ex, ey), length = seen * TRIAD * unit, half = TRIAD * unit / 2;
    const int end_on = seen < END_ON;
    const char name[2] = {d->at->picture->axes[axis], '\0'};
    cairo_set_source_rgb(d->cr, rgb[axis][0], rgb[axis][1], rgb[axis][2]);
    cairo_set_line_width(d->cr, 2 * unit);
    if (end_on)
        draw_axis_end_on(d, x, y, view->back[axis] > 0);
    else
        draw_arrow(d, x, y, ex / seen, ey / seen, length);
    const double far = length + 18 * unit, low = 0.36 * CAPTION * unit;
    const double nx = end_on ? 14 * unit : far * ex / seen,
                 ny = end_on ? 12 * unit : far * ey / seen;
    write_line(d, x + nx - half, y + ny + low, CAPTION, 2 * half, 1, name);
}

/* The axis farthest from the viewer first. */
static void draw_triad(const struct drawing *d, double x, double y)
{
    const double *back = d->at->view.back;
    int order[3] = {0, 1, 2};
    for (int i = 0; i < 3; i++)
        for (int j = i; j > 0 && back[order[j]] < back[order[j - 1]]; j--) {
            const int swap = order[j];
            order[j] = order[j - 1];
            order[j - 1] = swap;
        }
    for (int i = 0; i < 3; i++)
        draw_axis(d, x, y, order[i]);
}

static void draw_legend(const struct drawing *d)
{
    const struct layout *at = d->at;
    const double unit = at->unit, x = at->width - (MARGIN + LEGEND - GAP) * unit;
    const double bottom = at->height - MARGIN * unit, y = at->top + LABEL * unit;
    int marks = 0;
    for (int i = 0; i < at->picture->panels; i++)
        marks = marks || at->picture->panel[i].mark;
    double room = bottom - y - 3.3 * TRIAD * unit;
    if (marks)
        room -= 3.4 * CAPTION * unit;
    draw_bar(d, x, y, fmin(room, MOST_BAR * unit));
    if (marks)
        draw_mark_words(d, x, bottom - (3 * TRIAD + 1.7 * CAPTION) * unit);
    draw_triad(d, x + 1.2 * TRIAD * unit, bottom - 1.2 * TRIAD * unit);
}

/* ---- the whole ------------------------------------------------------------------------------ */

static enum hobe_status draw(struct drawing *d, struct hobe_error *err)
{
    const struct layout *at = d->at;
    for (int i = 0; i < HOBE_PALETTE; i++)
        hobe_colour(at->picture->colours, i / (HOBE_PALETTE - 1.), d->palette[i]);
    grey(d->cr, 1);
    cairo_paint(d->cr);
    grey(d->cr, INK);
    if (at->picture->title)
        write_line(d, MARGIN * at->unit, (MARGIN + 0.75 * TITLE) * at->unit, TITLE,
                   at->width - 2 * MARGIN * at->unit, 0, at->picture->title);
    draw_legend(d);
    return draw_cells(d, err);
}

static cairo_status_t keep(void *png, const unsigned char *bytes, unsigned size)
{
    struct hobe_text *text = png;
    hobe_text_bytes(text, (const char *)bytes, size);
    return text->status ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

enum hobe_status hobe_picture_png(const struct hobe_picture *picture, struct hobe_text *png,
                                  struct hobe_error *err)
{
    struct layout layout;
    enum hobe_status status = layout_new(picture, &layout, err);
    if (status)
        return status;
    cairo_surface_t *page =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.width, layout.height);
    struct drawing drawing = {.at = &layout, .cr = cairo_create(page)};
    if (!cairo_status(drawing.cr))
        status = draw(&drawing, err);
    cairo_status_t failed = cairo_status(drawing.cr);
    if (!failed && !status)
        failed = cairo_surface_write_to_png_stream(page, keep, png);
    if (failed && !status) /* nothing else can go wrong: letters are UTF-8 */
        status =
            hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: a picture of %d x %d pixels: %s",
                      layout.width, layout.height, cairo_status_to_string(failed));
    cairo_destroy(drawing.cr);
    cairo_surface_destroy(page);
    layout_free(&layout);
    return status;
}
