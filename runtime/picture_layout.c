/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture_layout.h"

#include "vector3.h"

enum { TALLEST_PICTURE = 30000 }; /* pixels; cairo has room for 32767 */

static const double FLATTEST = 0.18, TALLEST = 0.95; /* height over width of a cell in a grid */
static const double TALLEST_ALONE = 0.55;            /* height of one panel over the whole width */
static const double NARROWEST = 0.6;                 /* width of a cell over its height */
static const double LEAST_UNIT = 0.75;               /* so that small pictures can be read */
static const double CONSTANT = 1e-9; /* a field's range over its size, below which it has none */

static struct view look(double azimuth, double elevation)
{
    const double a = azimuth * M_PI / 180, e = elevation * M_PI / 180;
    return (struct view){{-sin(a), cos(a), 0},
                         {-sin(e) * cos(a), -sin(e) * sin(a), cos(e)},
                         {cos(e) * cos(a), cos(e) * sin(a), sin(e)}};
}

/* Point i of the surface where `scale` times its displacement takes it. */
static void displace(const struct hobe_surface *surface, int i, double scale, double p[3])
{
    for (int a = 0; a < 3; a++)
        p[a] = surface->point[i][a] + scale * surface->displacement[i][a];
}

/* ---- what is shown -------------------------------------------------------------------------- */

static void see(const struct view *view, const double p[3], struct shown *shown)
{
    const double x = dot3(view->right, p), y = dot3(view->up, p);
    shown->left = fmin(shown->left, x);
    shown->right = fmax(shown->right, x);
    shown->bottom = fmin(shown->bottom, y);
    shown->top = fmax(shown->top, y);
}

static struct shown measure(const struct view *view, const struct hobe_panel *panel)
{
    const struct hobe_surface *surface = panel->surface;
    struct shown shown = {INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int i = 0; i < surface->points; i++) {
        double p[3];
        displace(surface, i, panel->scale, p);
        see(view, p, &shown);
        if (panel->reference)
            see(view, surface->point[i], &shown);
    }
    for (int k = 0; panel->mark && k < HOBE_MARKS; k++)
        see(view, panel->mark[k], &shown);
    for (int i = 0; i < surface->points; i++) {
        shown.low = fmin(shown.low, surface->value[i]);
        shown.high = fmax(shown.high, surface->value[i]);
    }
    return shown;
}

/* A field that is constant but for rounding is coloured from zero on. */
static void widen(struct shown *s)
{
    const double most = fmax(fabs(s->low), fabs(s->high));
    if (s->high - s->low <= CONSTANT * most) {
        s->low = fmin(s->low, 0);
        s->high = fmax(s->high, 0);
    }
}

/* From -max to max where the field has a sign, and one range for all where it is shared. */
static void set_ranges(struct layout *at)
{
    const struct hobe_picture *picture = at->picture;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < picture->panels; i++) {
        struct shown *s = at->shown + i;
        if (picture->colours == HOBE_COLOURS_SIGNED) {
            s->high = fmax(fabs(s->low), fabs(s->high));
            s->low = -s->high;
        }
        low = fmin(low, s->low);
        high = fmax(high, s->high);
    }
    if (picture->limit > 0) {
        low = fmax(low, -picture->limit);
        high = fmin(high, picture->limit);
    }
    for (int i = 0; i < picture->panels; i++) {
        if (picture->range == HOBE_RANGE_SHARED) {
            at->shown[i].low = low;
            at->shown[i].high = high;
        }
        widen(at->shown + i);
    }
}

/* ---- the grid ------------------------------------------------------------------------------- */

static double width_of(const struct shown *s)
{
    return s->right - s->left;
}

static double height_of(const struct shown *s)
{
    return s->top - s->bottom;
}

/* The extremes of all panels. */
struct extremes {
    double width, height;     /* m */
    double tallest, flattest; /* height over width */
};

static struct extremes extremes_of(const struct layout *at)
{
    struct extremes e = {0, 0, 0, INFINITY};
    for (int i = 0; i < at->picture->panels; i++) {
        const struct shown *s = at->shown + i;
        e.width = fmax(e.width, width_of(s));
        e.height = fmax(e.height, height_of(s));
        e.tallest = fmax(e.tallest, height_of(s) / width_of(s));
        e.flattest = fmin(e.flattest, height_of(s) / width_of(s));
    }
    if (at->picture->same_scale)
        e.tallest = e.flattest = e.height / e.width;
    return e;
}

/* As many as make the whole about three to two, if the picture does not say. */
static int columns_of(const struct hobe_picture *picture, double aspect)
{
    const double well = ceil(sqrt(1.5 * picture->panels * fmin(fmax(aspect, FLATTEST), TALLEST)));
    const int columns = picture->columns > 0 ? picture->columns : (int)well;
    return columns < picture->panels ? columns : picture->panels;
}

/* Cells as wide as there is room, as high as the tallest drawing needs; narrower where no drawing
 * needs the width. */
static void set_cells(struct layout *at)
{
    const struct hobe_picture *picture = at->picture;
    const struct extremes e = extremes_of(at);
    at->columns = columns_of(picture, e.tallest);
    at->rows = (picture->panels + at->columns - 1) / at->columns;
    const double gaps = MARGIN + LEGEND + (at->columns + 1) * GAP;
    const double width = (picture->width - at->unit * gaps) / at->columns;
    const double most = picture->panels > 1 ? TALLEST * width : TALLEST_ALONE * picture->width;
    at->cell_height = fmin(width * fmax(e.tallest, FLATTEST), most);
    at->cell_width = fmin(width, at->cell_height * fmax(1 / e.flattest, NARROWEST));
    if (picture->same_scale)
        at->metre = fmin(at->cell_width / e.width, at->cell_height / e.height);
}

static enum hobe_status set_size(struct layout *at, struct hobe_error *err)
{
    const struct hobe_picture *picture = at->picture;
    const double k = at->unit;
    int labels = 0;
    for (int i = 0; i < picture->panels; i++)
        labels = labels || picture->panel[i].label;
    at->head = k * (labels * 1.6 * LABEL + (picture->range == HOBE_RANGE_AMOUNTS) * 1.5 * CAPTION +
                    GAP / 4.);
    at->top = k * (MARGIN + (picture->title ? 2 * TITLE : 0));
    const double grid = at->rows * (at->head + at->cell_height + k * GAP);
    const double legend = k * (LEAST_BAR + 4 * TRIAD);
    const double width = at->columns * (at->cell_width + k * GAP) + k * (MARGIN + LEGEND + GAP);
    const double height = at->top + fmax(grid, legend) + k * (MARGIN - GAP);
    if (height > TALLEST_PICTURE)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a picture of %d drawings in %d columns would be %.0f pixels high, at "
                         "most %d are possible: take more columns or fewer drawings",
                         picture->panels, at->columns, height, TALLEST_PICTURE);
    at->width = (int)ceil(width);
    at->height = (int)ceil(height);
    at->first = at->top + fmax(legend - grid, 0) / 2;
    return HOBE_OK;
}

/* ---- the layout ----------------------------------------------------------------------------- */

enum hobe_status layout_new(const struct hobe_picture *picture, struct layout *layout,
                            struct hobe_error *err)
{
    *layout = (struct layout){.picture = picture,
                              .view = look(picture->azimuth, picture->elevation),
                              .unit = fmax((double)picture->width / BASE, LEAST_UNIT)};
    layout->shown = hobe_alloc((size_t)picture->panels, sizeof *layout->shown, err);
    if (!layout->shown)
        return HOBE_NO_MEMORY;
    for (int i = 0; i < picture->panels; i++)
        layout->shown[i] = measure(&layout->view, picture->panel + i);
    set_ranges(layout);
    set_cells(layout);
    const enum hobe_status status = set_size(layout, err);
    if (status)
        layout_free(layout);
    return status;
}

void layout_free(struct layout *layout)
{
    hobe_free(layout->shown);
    layout->shown = NULL;
}

void layout_cell(const struct layout *layout, int i, double *x, double *y)
{
    const double gap = GAP * layout->unit;
    *x = MARGIN * layout->unit + i % layout->columns * (layout->cell_width + gap);
    *y = layout->first + i / layout->columns * (layout->head + layout->cell_height + gap);
}

struct projection layout_projection(const struct layout *layout, int i)
{
    const struct shown *s = layout->shown + i;
    const double own = fmin(layout->cell_width / width_of(s), layout->cell_height / height_of(s));
    const double metre = layout->metre > 0 ? layout->metre : own;
    return (struct projection){&layout->view, metre,
                               layout->cell_width / 2 - metre * (s->left + s->right) / 2,
                               layout->cell_height / 2 + metre * (s->bottom + s->top) / 2};
}

struct hobe_vertex project_point(const struct projection *projection,
                                 const struct hobe_surface *surface, int i, double scale)
{
    double p[3];
    displace(surface, i, scale, p);
    struct hobe_vertex vertex = project(projection, p);
    vertex.value = surface->value[i];
    return vertex;
}

struct hobe_vertex project(const struct projection *projection, const double p[3])
{
    const struct view *view = projection->view;
    return (struct hobe_vertex){.x = projection->left + projection->metre * dot3(view->right, p),
                                .y = projection->top - projection->metre * dot3(view->up, p),
                                .depth = projection->metre * dot3(view->back, p)};
}
