/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drawings in DXF (Drawing Exchange Format, as text): the entities that make outlines.
 *
 * A file alternates lines of a group code and of a value (Autodesk, DXF Reference).  Group 0 begins
 * an entity, 10 and 20 are the coordinates of its first point, 11 and 21 of its second, 40 to 42
 * and 50, 51 what the entity makes of them, 67 that it lies on the sheet of paper, 70 its flags,
 * 210 to 230 the normal of its plane. */
#include "outline_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CODES = 231 };
static const int READ[] = {10, 20, 11, 21, 40, 41, 42, 50, 51, 67, 70, 210, 220, 230};
enum { CLOSED = 1, MESH = 16 | 64, SPLINE_FRAME = 16 }; /* group 70 of a POLYLINE, a VERTEX */

struct tag {
    int code;
    struct hobe_word value;
};

struct dxf;
struct entity {
    const char *name;
    enum hobe_status (*draw)(struct dxf *dxf, struct hobe_error *err); /* NULL: left out */
    int own_plane; /* its coordinates are those of the plane with its normal */
};

enum section { NONE, HEADER, ENTITIES, OTHER };

struct dxf {
    struct hobe_lines lines;
    struct hobe_drawing *drawing;
    enum section section;
    int has_entities, at_units; /* ENTITIES was met; the value of $INSUNITS follows */
    int units;                  /* $INSUNITS */

    /* The entity that is being read. */
    const struct entity *entity; /* or NULL */
    struct hobe_word name;
    int line;
    double number[CODES]; /* by group code, 0 where there is none */

    /* A polyline, from its first vertex to the entity that is none of it. */
    int polyline; /* one is open */
    int flags, mirrored, vertices;
    int pending; /* number[10], [20] and [42] hold a vertex of an LWPOLYLINE */
    double first[2], last[2], bulge;
};

/* ---- words ---------------------------------------------------------------------------------- */

/* A flag or a choice; 0 for what is none. */
static int whole(double x)
{
    return x > 0 && x < 65536 ? (int)x : 0;
}

static enum hobe_status fail_at(const struct dxf *dxf, int line, const char *what,
                                const char *advice, struct hobe_error *err)
{
    return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s: line %d: %s; %s", dxf->drawing->name, line,
                     what, advice);
}

/* The next pair of lines. */
static enum hobe_status next_tag(struct dxf *dxf, struct tag *tag, struct hobe_error *err)
{
    struct hobe_word code = {0};
    double x;
    char quote[48], what[100];
    const int more = hobe_next_line(&dxf->lines, &code);
    if (!more || !hobe_next_line(&dxf->lines, &tag->value))
        return fail_at(dxf, dxf->lines.line, "the file ends without EOF", "it was cut short", err);
    if (!hobe_word_number(code, &x) || fabs(x) > 10000 || x != floor(x)) {
        snprintf(what, sizeof what, "\"%s\" is no group code of a DXF file",
                 hobe_word_quote(code, quote));
        return fail_at(dxf, dxf->lines.line - 1, what, "save the drawing as DXF, as text", err);
    }
    tag->code = (int)x;
    return HOBE_OK;
}

/* ---- entities ------------------------------------------------------------------------------- */

static void begin(struct dxf *dxf)
{
    hobe_path_begin(dxf->drawing, dxf->entity->name, dxf->line);
}

static enum hobe_status draw_line(struct dxf *dxf, struct hobe_error *err)
{
    const double *n = dxf->number;
    begin(dxf);
    const enum hobe_status status = hobe_path_line(dxf->drawing, (double[]){n[10], n[20]}, err);
    return status ? status : hobe_path_line(dxf->drawing, (double[]){n[11], n[21]}, err);
}

/* Turns from `from` to `to` anticlockwise, in (0, 2 pi]. */
static double sweep(double from, double to)
{
    const double turn = fmod(to - from, 2 * M_PI);
    return turn > 1e-9 ? turn : turn + 2 * M_PI;
}

static enum hobe_status draw_arc(struct dxf *dxf, struct hobe_error *err)
{
    const double *n = dxf->number, from = n[50] * M_PI / 180, to = n[51] * M_PI / 180;
    begin(dxf);
    return hobe_path_arc(
        dxf->drawing,
        &(struct hobe_arc){{n[10], n[20]}, {n[40], 0}, {0, n[40]}, from, sweep(from, to)}, err);
}

static enum hobe_status draw_circle(struct dxf *dxf, struct hobe_error *err)
{
    const double *n = dxf->number;
    begin(dxf);
    return hobe_path_ellipse(
        dxf->drawing, &(struct hobe_arc){{n[10], n[20]}, {n[40], 0}, {0, n[40]}, 0, 2 * M_PI}, err);
}

/* The minor axis is the normal of the plane times the major one. */
static enum hobe_status draw_ellipse(struct dxf *dxf, struct hobe_error *err)
{
    const double *n = dxf->number, minor = n[230] < 0 ? -n[40] : n[40];
    const struct hobe_arc arc = {{n[10], n[20]},
                                 {n[11], n[21]},
                                 {-minor * n[21], minor * n[11]},
                                 n[41],
                                 sweep(n[41], n[42])};
    begin(dxf);
    return 2 * M_PI - arc.sweep < 1e-6 ? hobe_path_ellipse(dxf->drawing, &arc, err)
                                       : hobe_path_arc(dxf->drawing, &arc, err);
}

/* From the last vertex to p, with the bulge b = tan(sweep/4): about the centre
 * (last + p)/2 + (1 - b^2)/(4 b) (normal to the left). */
static enum hobe_status draw_bulge(struct dxf *dxf, const double p[2], struct hobe_error *err)
{
    const double b = dxf->bulge, *from = dxf->last, d[2] = {p[0] - from[0], p[1] - from[1]};
    if (fabs(b) < 1e-8) /* whose centre would lose all digits */
        return hobe_path_line(dxf->drawing, p, err);
    const double side = (1 - b * b) / (4 * b);
    const double a[2] = {-d[0] / 2 + side * d[1], -d[1] / 2 - side * d[0]};
    return hobe_path_arc(
        dxf->drawing,
        &(struct hobe_arc){
            {from[0] - a[0], from[1] - a[1]}, {a[0], a[1]}, {-a[1], a[0]}, 0, 4 * atan(b)},
        err);
}

static enum hobe_status add_vertex(struct dxf *dxf, struct hobe_error *err)
{
    const double *n = dxf->number, p[2] = {n[10], n[20]};
    if (n[67] != 0)
        return HOBE_OK;
    const enum hobe_status status =
        dxf->vertices++ ? draw_bulge(dxf, p, err) : hobe_path_line(dxf->drawing, p, err);
    if (dxf->vertices == 1)
        memcpy(dxf->first, p, sizeof p);
    memcpy(dxf->last, p, sizeof p);
    dxf->bulge = n[42];
    dxf->number[42] = 0;
    return status;
}

static enum hobe_status draw_vertex(struct dxf *dxf, struct hobe_error *err)
{
    if (!dxf->polyline)
        return fail_at(dxf, dxf->line, "VERTEX without a POLYLINE", "the file is damaged", err);
    return whole(dxf->number[70]) & SPLINE_FRAME ? HOBE_OK : add_vertex(dxf, err);
}

/* The end of what stands before the vertices of a POLYLINE, or of a whole LWPOLYLINE. */
static enum hobe_status draw_polyline(struct dxf *dxf, struct hobe_error *err)
{
    dxf->flags = whole(dxf->number[70]);
    dxf->mirrored = dxf->number[230] < 0;
    if (dxf->flags & MESH)
        return fail_at(dxf, dxf->line, "this POLYLINE is a mesh", "draw its outline", err);
    return dxf->pending ? add_vertex(dxf, err) : HOBE_OK;
}

/* Entities of a plane whose normal is -z have x to the left. */
static void mirror(struct dxf *dxf)
{
    const struct hobe_path *path = hobe_path_last(dxf->drawing);
    for (int i = path->from; i < path->to; i++)
        dxf->drawing->point[i][0] *= -1;
}

static enum hobe_status end_polyline(struct dxf *dxf, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    if (dxf->vertices && dxf->flags & CLOSED) {
        status = draw_bulge(dxf, dxf->first, err);
        hobe_path_last(dxf->drawing)->closed = 1;
    }
    if (dxf->mirrored)
        mirror(dxf);
    dxf->polyline = 0;
    return status;
}

static enum hobe_status refuse(struct dxf *dxf, struct hobe_error *err)
{
    char quote[48], what[100];
    snprintf(what, sizeof what, "%s is not read", hobe_word_quote(dxf->name, quote));
    return fail_at(dxf, dxf->line, what, "turn it into lines, arcs or polylines", err);
}

static const struct entity entities[] = {
    {"LINE", draw_line, 0},
    {"ARC", draw_arc, 1},
    {"CIRCLE", draw_circle, 1},
    {"ELLIPSE", draw_ellipse, 0},
    {"LWPOLYLINE", draw_polyline, 0},
    {"POLYLINE", draw_polyline, 0},
    {"VERTEX", draw_vertex, 0},
    {"SEQEND", NULL, 0},
    /* what stands beside an outline */
    {"ATTDEF", NULL, 0},
    {"DIMENSION", NULL, 0},
    {"HATCH", NULL, 0},
    {"LEADER", NULL, 0},
    {"MTEXT", NULL, 0},
    {"MULTILEADER", NULL, 0},
    {"POINT", NULL, 0},
    {"TEXT", NULL, 0},
    {"VIEWPORT", NULL, 0},
};

static const struct entity *find_entity(struct hobe_word name)
{
    static const struct entity other = {"", refuse, 0};
    for (size_t i = 0; i < sizeof entities / sizeof *entities; i++)
        if (hobe_word_is(name, entities[i].name))
            return entities + i;
    return &other;
}

/* ---- the file ------------------------------------------------------------------------------- */

static enum hobe_status end_entity(struct dxf *dxf, struct hobe_error *err)
{
    const struct entity *entity = dxf->entity;
    if (!entity || !entity->draw || dxf->number[67] != 0)
        return HOBE_OK;
    if (dxf->number[210] != 0 || dxf->number[220] != 0)
        return fail_at(dxf, dxf->line, "this entity does not lie in the xy plane",
                       "an outline is flat", err);
    const enum hobe_status status = entity->draw(dxf, err);
    if (entity->own_plane && dxf->number[230] < 0)
        mirror(dxf);
    return status;
}

static void begin_entity(struct dxf *dxf, struct hobe_word name)
{
    dxf->entity = find_entity(name);
    dxf->name = name;
    dxf->line = dxf->lines.line;
    dxf->pending = 0;
    memset(dxf->number, 0, sizeof dxf->number);
    if (dxf->entity->draw == draw_polyline) {
        dxf->polyline = 1;
        dxf->vertices = 0;
        begin(dxf);
    }
}

/* Group 0: the end of one thing and the beginning of another. */
static enum hobe_status take_name(struct dxf *dxf, struct hobe_word name, struct hobe_error *err)
{
    enum hobe_status status = end_entity(dxf, err);
    dxf->entity = NULL;
    if (!status && dxf->polyline && !hobe_word_is(name, "VERTEX"))
        status = end_polyline(dxf, err);
    if (status)
        return status;
    if (hobe_word_is(name, "SECTION") || hobe_word_is(name, "ENDSEC") || hobe_word_is(name, "EOF"))
        dxf->section = NONE;
    else if (dxf->section == ENTITIES)
        begin_entity(dxf, name);
    return HOBE_OK;
}

/* Group 2 behind SECTION. */
static void take_section(struct dxf *dxf, struct hobe_word name)
{
    dxf->section = hobe_word_is(name, "HEADER")     ? HEADER
                   : hobe_word_is(name, "ENTITIES") ? ENTITIES
                                                    : OTHER;
    dxf->has_entities |= dxf->section == ENTITIES;
}

static enum hobe_status read_number(const struct dxf *dxf, const struct tag *tag, double *x,
                                    struct hobe_error *err)
{
    char quote[48], what[100];
    if (hobe_word_number(tag->value, x))
        return HOBE_OK;
    snprintf(what, sizeof what, "group %d must be a number, got \"%s\"", tag->code,
             hobe_word_quote(tag->value, quote));
    return fail_at(dxf, dxf->lines.line, what, "the file is damaged", err);
}

/* A group of the entity.  Each 10 of an LWPOLYLINE begins a vertex. */
static enum hobe_status take_group(struct dxf *dxf, const struct tag *tag, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    int known = 0;
    double x;
    for (size_t i = 0; i < sizeof READ / sizeof *READ; i++)
        known |= tag->code == READ[i];
    if (!known)
        return HOBE_OK;
    if (tag->code == 10 && !strcmp(dxf->entity->name, "LWPOLYLINE")) {
        if (dxf->pending)
            status = add_vertex(dxf, err);
        dxf->pending = 1;
    }
    if (!status)
        status = read_number(dxf, tag, &x, err);
    if (!status)
        dxf->number[tag->code] = x;
    return status;
}

static enum hobe_status take(struct dxf *dxf, const struct tag *tag, struct hobe_error *err)
{
    double x;
    if (tag->code == 0)
        return take_name(dxf, tag->value, err);
    if (dxf->entity)
        return dxf->entity->draw ? take_group(dxf, tag, err) : HOBE_OK;
    if (dxf->section == NONE && tag->code == 2)
        take_section(dxf, tag->value);
    if (dxf->section != HEADER)
        return HOBE_OK;
    if (tag->code == 9)
        dxf->at_units = hobe_word_is(tag->value, "$INSUNITS");
    if (!dxf->at_units || tag->code != 70)
        return HOBE_OK;
    const enum hobe_status status = read_number(dxf, tag, &x, err);
    if (!status)
        dxf->units = whole(x);
    return status;
}

static void set_unit(const struct dxf *dxf, struct hobe_unit *unit)
{
    static const struct {
        int code;
        const char *name;
        double metres;
    } units[] = {{1, "in", 0.0254}, {2, "ft", 0.3048}, {4, "mm", 1e-3},
                 {5, "cm", 1e-2},   {6, "m", 1},       {14, "dm", 0.1}};
    *unit = (struct hobe_unit){0};
    if (dxf->units)
        snprintf(unit->text, sizeof unit->text, "$INSUNITS = %d", dxf->units);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (units[i].code == dxf->units) {
            unit->metres = units[i].metres;
            snprintf(unit->text, sizeof unit->text, "$INSUNITS: %s", units[i].name);
        }
}

static int is_binary(const struct hobe_lines *lines)
{
    static const char mark[] = "AutoCAD Binary DXF";
    return lines->end - lines->at >= (ptrdiff_t)sizeof mark &&
           !memcmp(lines->at, mark, sizeof mark - 1);
}

enum hobe_status hobe_draw_dxf(struct hobe_lines lines, struct hobe_drawing *drawing,
                               struct hobe_unit *unit, struct hobe_error *err)
{
    struct dxf dxf = {.lines = lines, .drawing = drawing};
    struct tag tag = {0};
    enum hobe_status status;
    if (is_binary(&lines))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: this is a binary DXF; save the drawing as DXF text (ASCII)",
                         drawing->name);
    do {
        status = next_tag(&dxf, &tag, err);
        if (!status)
            status = take(&dxf, &tag, err);
    } while (!status && !(tag.code == 0 && hobe_word_is(tag.value, "EOF")));
    if (!status && !dxf.has_entities)
        status =
            hobe_fail(err, HOBE_BAD_INPUT, NULL,
                      "%s: it has no section ENTITIES, where the drawing would be", drawing->name);
    set_unit(&dxf, unit);
    return status;
}
