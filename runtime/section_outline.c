/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_outline.h"

#include "distortion.h"
#include "saint_venant.h"
#include "section_cache.h"
#include "section_shape.h"
#include "section_surface.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { MATERIAL = 6 }; /* numbers of a material */

/* ---- the functions -------------------------------------------------------------------------- */

static void functions(const hobe_section *section, int paper, double y, double z, double (*f)[4])
{
    const struct shape *s = (const struct shape *)section;
    const struct hobe_mesh_place place = hobe_mesh_find(&s->mesh, y, z);
    const double *distortion = shape_owner(s)->distortion;
    hobe_mesh_fields(&s->mesh, s->values, &place, f);
    if (distortion) {
        double more[HOBE_DISTORTIONS][4] = {{0}}; /* without change along the beam */
        for (int part = 0; part < HOBE_DISTORTIONS; part += HOBE_SECTION_FUNCTIONS)
            hobe_mesh_fields(&s->mesh, distortion + part * s->mesh.nodes, &place, more + part);
        memcpy(f + HOBE_SECTION_FUNCTIONS, more,
               (HOBE_ALL_FUNCTIONS - HOBE_SECTION_FUNCTIONS) * sizeof *more);
    }
    if (paper || s->paper)
        parts_warping(&s->parts, y, z, f[HOBE_W]);
}

static int region_at(const hobe_section *section, double y, double z)
{
    const struct hobe_mesh *mesh = &((const struct shape *)section)->mesh;
    return mesh->region[hobe_mesh_find(mesh, y, z).triangle];
}

/* Whatever the fineness: the mesh is as fine as w needs. */
static enum hobe_status surface(const hobe_section *section, int fineness,
                                struct hobe_surface *surface, struct hobe_error *err)
{
    (void)fineness;
    return hobe_surface_mesh(&((const struct shape *)section)->mesh, surface, err);
}

/* Sections are shared by threads: who asks first solves. */
static enum hobe_status distort(const hobe_section *section, double *wall_bending,
                                struct hobe_error *err)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    struct shape *s = shape_owner((const struct shape *)section);
    const double centre[2] = {section->properties.ys, section->properties.zs};
    const size_t nodes = (size_t)s->mesh.nodes;
    enum hobe_status status = HOBE_OK;
    pthread_mutex_lock(&lock);
    if (!s->distortion) {
        double *values = hobe_alloc(HOBE_DISTORTIONS * nodes, sizeof *values, err);
        status = values ? hobe_distortion(section, &s->mesh, s->values, centre, values,
                                          &s->wall_bending, err)
                        : HOBE_NO_MEMORY;
        if (status)
            hobe_free(values);
        else
            s->distortion = values;
    }
    *wall_bending = s->wall_bending;
    pthread_mutex_unlock(&lock);
    return status;
}

static void close_shape(hobe_section *section)
{
    struct shape *s = (struct shape *)section;
    if (s->shared) {
        hobe_section_drop(s->shared);
        return;
    }
    for (int r = 0; r < s->base.regions; r++)
        hobe_outline_free(s->outline + r);
    hobe_free(s->outline);
    hobe_free(s->base.material);
    hobe_mesh_free(&s->mesh);
    hobe_free(s->values);
    hobe_free(s->distortion);
    hobe_rule_free(&s->functions_rule);
}

/* Composite sections are no parts of others: region 0 is the outline. */
static enum hobe_status copy_outline(const hobe_section *section, struct hobe_outline *outline,
                                     struct hobe_error *err)
{
    const struct shape *s = (const struct shape *)section;
    const enum hobe_status status = hobe_outline_copy(s->outline, outline, err);
    if (!status)
        hobe_outline_move(outline, section->properties.yc, section->properties.zc);
    return status;
}

static const struct hobe_section_sizes shape_sizes;
static const struct hobe_section_kind shape_kind = {.rule = shape_rule,
                                                    .functions = functions,
                                                    .distort = distort,
                                                    .region = region_at,
                                                    .surface = surface,
                                                    .outline = copy_outline,
                                                    .close = close_shape,
                                                    .sizes = &shape_sizes};

/* ---- one solution for each content ---------------------------------------------------------- */

struct shape *shape_new(int regions, struct hobe_error *err)
{
    struct shape *s = hobe_alloc(1, sizeof *s, err);
    if (!s)
        return NULL;
    s->base.kind = &shape_kind;
    s->outline = hobe_alloc((size_t)regions, sizeof *s->outline, err);
    if (s->outline) {
        s->base.regions = regions;
        return s;
    }
    hobe_section_free(&s->base);
    return NULL;
}

/* Numbers that say what an outline is: its loops, where they end, its points. */
static size_t outline_numbers(const struct hobe_outline *o)
{
    return (size_t)(1 + o->loops + 2 * o->start[o->loops]);
}

static double *write_outline(const struct hobe_outline *o, double *at)
{
    const size_t coordinates = (size_t)(2 * o->start[o->loops]);
    *at++ = o->loops;
    for (int l = 1; l <= o->loops; l++)
        *at++ = o->start[l];
    memcpy(at, o->point, coordinates * sizeof *at);
    return at + coordinates;
}

static double *write_material(const struct hobe_material *m, double *at)
{
    const double law[MATERIAL] = {m->E, m->nu, m->rho, m->k2, m->k3, m->average_shear};
    _Static_assert(sizeof law == sizeof *m, "a material has members that are not here");
    memcpy(at, law, sizeof law);
    return at + MATERIAL;
}

/* All that decides about the solution of s, whose outlines are as they were given: count numbers.
 */
static double *content_of(const struct shape *s, size_t *count, struct hobe_error *err)
{
    const size_t parts = (size_t)s->parts.count * sizeof *s->parts.part / sizeof(double);
    const int materials = s->base.material ? s->base.regions : 0;
    *count = 4 + parts + (size_t)(MATERIAL * materials);
    for (int r = 0; r < s->base.regions; r++)
        *count += outline_numbers(s->outline + r);
    double *content = hobe_alloc(*count, sizeof *content, err), *at = content;
    if (!content)
        return NULL;
    *at++ = s->paper;
    *at++ = s->parts.count;
    *at++ = s->base.regions;
    *at++ = materials;
    for (int r = 0; r < s->base.regions; r++)
        at = write_outline(s->outline + r, at);
    for (int r = 0; r < materials; r++)
        at = write_material(s->base.material + r, at);
    memcpy(at, s->parts.part, parts * sizeof *at);
    return content;
}

hobe_section *shape_share(struct shape *s, struct hobe_error *err)
{
    size_t count;
    struct shape *handle = hobe_alloc(1, sizeof *handle, err);
    double *content = handle ? content_of(s, &count, err) : NULL;
    if (content)
        handle->shared = hobe_section_share(&s->base, content, count, shape_set_properties, err);
    else
        hobe_section_free(&s->base);
    hobe_free(content);
    if (!content || !handle->shared) {
        hobe_free(handle);
        return NULL;
    }
    const hobe_section *shared = handle->shared;
    *handle = *(const struct shape *)shared;
    handle->shared = shared;
    return &handle->base;
}

hobe_section *hobe_section_outline(int loops, const int *points, const double (*point)[2],
                                   const struct hobe_parts *parts, enum hobe_warping warping,
                                   struct hobe_error *err)
{
    if (warping == HOBE_WARPING_SERIES || (warping == HOBE_WARPING_PAPER && !parts)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "warping = \"%s\" is not known for this section; use \"solved\"",
                  warping == HOBE_WARPING_SERIES ? "series" : "paper");
        return NULL;
    }
    struct shape *s = shape_new(1, err);
    if (!s)
        return NULL;
    s->paper = warping == HOBE_WARPING_PAPER;
    if (parts)
        s->parts = *parts;
    if (hobe_outline_new(loops, points, point, s->outline, err)) {
        hobe_section_free(&s->base);
        return NULL;
    }
    return shape_share(s, err);
}

/* ---- along a beam --------------------------------------------------------------------------- */

/* The numbers of an outline are its points about the centroid.  Sections of parts, of materials or
 * of the paper's closed forms, do not taper. */
static int count_numbers(const hobe_section *section)
{
    const struct shape *s = (const struct shape *)section;
    return s->base.regions > 1 || s->base.material || s->paper
               ? 0
               : 2 * s->outline->start[s->outline->loops];
}

static void read_numbers(const hobe_section *section, double *numbers)
{
    const struct hobe_outline *o = ((const struct shape *)section)->outline;
    memcpy(numbers, o->point, 2 * (size_t)o->start[o->loops] * sizeof *numbers);
}

struct shape *shape_like(const struct shape *like, const double *numbers, struct hobe_error *err)
{
    const struct hobe_outline *o = like->outline;
    struct shape *s = shape_new(1, err);
    int *points = s ? hobe_alloc((size_t)o->loops, sizeof *points, err) : NULL;
    for (int l = 0; points && l < o->loops; l++)
        points[l] = o->start[l + 1] - o->start[l];
    const enum hobe_status status =
        points ? hobe_outline_new(o->loops, points, (const double(*)[2])numbers, s->outline, err)
               : HOBE_NO_MEMORY;
    hobe_free(points);
    if (status) {
        if (s)
            hobe_section_free(&s->base);
        return NULL;
    }
    shape_set_area(s);
    shape_set_extent(s);
    return s;
}

static hobe_section *make_like(const hobe_section *section, const double *numbers, int bare,
                               struct hobe_error *err)
{
    const struct shape *like = (const struct shape *)section;
    struct shape *s = shape_like(like, numbers, err);
    if (!s)
        return NULL;
    snprintf(s->base.text, sizeof s->base.text, "outline of %d points, w: solved",
             s->outline->start[1]);
    if (!bare) {
        s->base.properties = (struct hobe_section_properties){0};
        s->base.probes = 0;
        return shape_share(s, err);
    }
    return &s->base;
}

static const struct hobe_section_sizes shape_sizes = {count_numbers, read_numbers, make_like,
                                                      &hobe_shape_field};

int hobe_section_triangles(const hobe_section *section)
{
    return ((const struct shape *)section)->mesh.triangles;
}

hobe_section *hobe_section_polygon(int loops, const int *points, const double (*point)[2],
                                   struct hobe_error *err)
{
    if (loops < 1) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "polygon: there must be an outline, got %d loops",
                  loops);
        return NULL;
    }
    hobe_section *section =
        hobe_section_outline(loops, points, point, NULL, HOBE_WARPING_SOLVED, err);
    if (section)
        snprintf(section->text, sizeof section->text,
                 "polygon of %d points and %d hole%s, w: solved on %d triangles", points[0],
                 loops - 1, loops == 2 ? "" : "s", hobe_section_triangles(section));
    else
        hobe_fail_in(err, "polygon");
    return section;
}
