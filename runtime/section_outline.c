/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_outline.h"

#include "distortion.h"
#include "material.h"
#include "outline.h"
#include "saint_venant.h"
#include "section_cache.h"
#include "section_shape.h"
#include "section_surface.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum {
    PAPER_POINTS = 3,
    MOST_GAUSS = 64,
    MATERIAL = 6 /* numbers of a material */
};

/* ---- cubature ------------------------------------------------------------------------------- */

static enum hobe_status gauss_points(int n, double (*gauss)[2], struct hobe_error *err)
{
    if (n > MOST_GAUSS)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%d > %d Gauss points are asked of a section",
                         n, MOST_GAUSS);
    return hobe_gauss(n, gauss, err);
}

/* The points of one outline's edges; returns the place behind them. */
static struct hobe_section_point *add_fans(const struct hobe_outline *o, int region, int n,
                                           const double (*gauss)[2], struct hobe_section_point *p)
{
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
            const double twice = a[0] * b[1] - a[1] * b[0];
            for (int g = 0; g < n * n; g++, p++) {
                const double *s = gauss[g / n], *t = gauss[g % n];
                p->y = s[0] * (a[0] + t[0] * (b[0] - a[0]));
                p->z = s[0] * (a[1] + t[0] * (b[1] - a[1]));
                p->weight = twice * s[0] * s[1] * t[1];
                p->region = region;
            }
        }
    return p;
}

/* For polynomials of degree 2 n - 2: the triangles from the centroid to each edge, counted negative
 * where the edge runs back, with n x n points each.  Some points lie outside the material, which
 * polynomials do not mind; the mesh would need a hundred times as many. */
static enum hobe_status fan_rule(const struct shape *shape, int n, struct hobe_rule *rule,
                                 struct hobe_error *err)
{
    double gauss[MOST_GAUSS][2];
    int edges = 0;
    *rule = (struct hobe_rule){0};
    for (int r = 0; r < shape->base.regions; r++)
        edges += shape->outline[r].start[shape->outline[r].loops];
    enum hobe_status status = gauss_points(n, gauss, err);
    if (!status)
        status = hobe_rule_new(rule, (size_t)(n * n * edges), err);
    struct hobe_section_point *p = rule->point;
    for (int r = 0; !status && r < shape->base.regions; r++)
        p = add_fans(shape->outline + r, r, n, (const double(*)[2])gauss, p);
    return status;
}

static void branch(const struct hobe_part *part, double y, double z, double *f)
{
    f[0] = y * (part->a * z + part->b);
    f[1] = part->a * z + part->b;
    f[2] = part->a * y;
}

/* The parts' rectangles, n x n Gauss points each (Tang et al. 2022, appendix). */
static enum hobe_status parts_rule(const struct hobe_parts *parts, int n, struct hobe_rule *rule,
                                   struct hobe_error *err)
{
    double gauss[MOST_GAUSS][2];
    enum hobe_status status = gauss_points(n, gauss, err);
    if (!status)
        status = hobe_rule_new(rule, (size_t)(n * n * parts->count), err);
    for (int i = 0; !status && i < n * n * parts->count; i++) {
        const struct hobe_part *part = parts->part + i / (n * n);
        const double *s = gauss[i / n % n], *t = gauss[i % n];
        struct hobe_section_point *p = rule->point + i;
        p->y = part->y + (s[0] - 0.5) * part->width;
        p->z = part->z + (t[0] - 0.5) * part->height;
        p->weight = part->width * part->height * s[1] * t[1];
        branch(part, p->y, p->z, p->f[HOBE_W]);
    }
    return status;
}

/* The section that holds the fields: s itself, or the one whose solution it shares. */
static struct shape *owner(const struct shape *s)
{
    return (struct shape *)(s->shared ? s->shared : &s->base);
}

/* Adds the functions of distortion to the points of the mesh's rule. */
static enum hobe_status add_distortion(const struct shape *s, struct hobe_rule *rule,
                                       struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int part = HOBE_SECTION_FUNCTIONS; !status && part < HOBE_ALL_FUNCTIONS;
         part += HOBE_SECTION_FUNCTIONS) {
        struct hobe_rule more;
        const int fields = part - HOBE_SECTION_FUNCTIONS;
        status =
            hobe_mesh_rule(&s->mesh, owner(s)->distortion + fields * s->mesh.nodes, &more, err);
        for (int p = 0; !status && p < rule->rule.points; p++)
            for (int i = 0; i < HOBE_SECTION_FUNCTIONS && part + i < HOBE_ALL_FUNCTIONS; i++)
                memcpy(rule->point[p].f[part + i], more.point[p].f[i], sizeof more.point[p].f[i]);
        hobe_rule_free(&more);
    }
    return status;
}

static enum hobe_status mesh_rule(const struct shape *s, int distorts, struct hobe_rule *rule,
                                  struct hobe_error *err)
{
    const enum hobe_status status = hobe_rule_copy(&s->functions_rule, rule, err);
    return !status && distorts ? add_distortion(s, rule, err) : status;
}

static enum hobe_status rule(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err)
{
    const struct shape *s = (const struct shape *)section;
    const int degree = s->paper && kernel->functions && kernel->degree < 2 ? 2 : kernel->degree;
    const int bends = hobe_section_bends(kernel);
    if (integration == HOBE_INTEGRATION_PAPER && !s->parts.count)
        return hobe_section_no_paper("such an outline", err);
    if (integration == HOBE_INTEGRATION_PAPER && bends)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the paper's integration of such an outline has its closed form of w, but "
                         "none of wy and wz, which element %s uses; use integration = \"exact\"",
                         kernel->name);
    if (integration == HOBE_INTEGRATION_PAPER)
        return parts_rule(&s->parts, PAPER_POINTS, rule, err);
    if (s->paper && !bends)
        return parts_rule(&s->parts, 2 * degree + 1, rule, err);
    if (kernel->functions)
        return mesh_rule(s, hobe_section_distorts(kernel), rule, err);
    return fan_rule(s, 2 * degree + 1, rule, err);
}

/* ---- the functions -------------------------------------------------------------------------- */

static double outside(const struct hobe_part *part, double y, double z)
{
    return hypot(fmax(0, fabs(y - part->y) - part->width / 2),
                 fmax(0, fabs(z - part->z) - part->height / 2));
}

static void parts_warping(const struct hobe_parts *parts, double y, double z, double *f)
{
    const struct hobe_part *nearest = parts->part;
    for (int i = 1; i < parts->count; i++)
        if (outside(parts->part + i, y, z) < outside(nearest, y, z))
            nearest = parts->part + i;
    branch(nearest, y, z, f);
}

static void functions(const hobe_section *section, int paper, double y, double z, double (*f)[4])
{
    const struct shape *s = (const struct shape *)section;
    const struct hobe_mesh_place place = hobe_mesh_find(&s->mesh, y, z);
    const double *distortion = owner(s)->distortion;
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
    struct shape *s = owner((const struct shape *)section);
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
static const struct hobe_section_kind shape_kind = {.rule = rule,
                                                    .functions = functions,
                                                    .distort = distort,
                                                    .region = region_at,
                                                    .surface = surface,
                                                    .outline = copy_outline,
                                                    .close = close_shape,
                                                    .sizes = &shape_sizes};

/* ---- properties ----------------------------------------------------------------------------- */

/* Area, and the outlines about their centroid, weighted with E. */
static void set_area(struct shape *s)
{
    struct hobe_section_properties *p = &s->base.properties;
    double EA = 0, ES[2] = {0, 0};
    for (int r = 0; r < s->base.regions; r++) {
        double centroid[2];
        const double A = hobe_outline_area(s->outline + r, centroid),
                     E = hobe_section_E(&s->base, r);
        p->A += A;
        EA += E * A;
        for (int a = 0; a < 2; a++)
            ES[a] += E * A * centroid[a];
    }
    p->yc = ES[0] / EA;
    p->zc = ES[1] / EA;
    for (int r = 0; r < s->base.regions; r++)
        hobe_outline_move(s->outline + r, -p->yc, -p->zc);
}

/* Moments of area, about the centroid; J is still the polar one. */
static void set_moments(struct shape *s, const struct hobe_rule *fan)
{
    struct hobe_section_properties *p = &s->base.properties;
    for (int i = 0; i < fan->rule.points; i++) {
        const struct hobe_section_point *at = fan->point + i;
        const double E = at->weight * hobe_section_E(&s->base, at->region);
        const double G = at->weight * hobe_section_G(&s->base, at->region);
        p->Iyy += E * at->z * at->z;
        p->Izz += E * at->y * at->y;
        p->Iyz += E * at->y * at->z;
        p->J += G * (at->y * at->y + at->z * at->z);
    }
}

/* Extent, and probes among the points of the outlines. */
static void set_extent(struct shape *s)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    int points = 0, seen = 0;
    for (int r = 0; r < s->base.regions; r++)
        points += s->outline[r].start[1];
    for (int r = 0; r < s->base.regions; r++)
        for (int i = 0; i < s->outline[r].start[1]; i++, seen++) {
            const double *at = s->outline[r].point[i];
            for (int a = 0; a < 2; a++) {
                low[a] = fmin(low[a], at[a]);
                high[a] = fmax(high[a], at[a]);
            }
            if (seen * HOBE_PROBES >= s->base.probes * points && s->base.probes < HOBE_PROBES)
                memcpy(s->base.probe[s->base.probes++], at, sizeof(double[2]));
        }
    s->base.properties.width = high[0] - low[0];
    s->base.properties.height = high[1] - low[1];
}

static void set_wagner(struct shape *s, const struct hobe_rule *fan)
{
    struct hobe_section_properties *p = &s->base.properties;
    double EA = 0, r2 = 0, r4 = 0;
    for (int i = 0; i < fan->rule.points; i++) {
        const struct hobe_section_point *at = fan->point + i;
        const double E = at->weight * hobe_section_E(&s->base, at->region);
        const double r = hypot(at->y - p->ys, at->z - p->zs);
        EA += E;
        r2 += E * r * r;
        r4 += E * r * r * r * r;
    }
    p->Wagner = r4 - r2 * r2 / EA;
}

/* On the paper's parts w is theirs.  They have two axes of symmetry, where any such w is orthogonal
 * to wy and wz. */
static void set_warping(struct shape *s)
{
    for (int i = 0; s->paper && i < s->functions_rule.rule.points; i++) {
        struct hobe_section_point *at = s->functions_rule.point + i;
        parts_warping(&s->parts, at->y, at->z, at->f[HOBE_W]);
    }
    hobe_section_set_warping(&s->base, &s->functions_rule);
}

enum hobe_status hobe_shape_solve(struct shape *s, struct hobe_error *err)
{
    double energy, centre[2];
    s->values = hobe_alloc(HOBE_SECTION_FUNCTIONS * (size_t)s->mesh.nodes, sizeof *s->values, err);
    if (!s->values)
        return HOBE_NO_MEMORY;
    enum hobe_status status =
        hobe_saint_venant(&s->base, &s->mesh, s->values, &energy, centre, err);
    if (!status)
        status = hobe_mesh_rule(&s->mesh, s->values, &s->functions_rule, err);
    if (status)
        return status;
    s->base.properties.J -= energy;
    s->base.properties.ys = centre[0];
    s->base.properties.zs = centre[1];
    return HOBE_OK;
}

/* On the paper's parts, where w has other branches, triangles end at their seams. */
static enum hobe_status mesh_parts(struct shape *s, struct hobe_error *err)
{
    struct hobe_outline outline[HOBE_MAX_PARTS] = {0};
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < s->parts.count; i++) {
        const struct hobe_part *p = s->parts.part + i;
        const double y = p->width / 2, z = p->height / 2;
        const double corner[4][2] = {
            {p->y - y, p->z - z}, {p->y + y, p->z - z}, {p->y + y, p->z + z}, {p->y - y, p->z + z}};
        status = hobe_outline_new(1, &(int){4}, corner, outline + i, err);
    }
    if (!status)
        status = hobe_mesh_outlines(s->parts.count, outline, &s->mesh, err);
    for (int t = 0; !status && t < s->mesh.triangles; t++)
        s->mesh.region[t] = 0;
    for (int i = 0; i < s->parts.count; i++)
        hobe_outline_free(outline + i);
    return status;
}

/* Mesh, functions and everything that needs them. */
static enum hobe_status solve(struct shape *s, struct hobe_error *err)
{
    enum hobe_status status = s->paper
                                  ? mesh_parts(s, err)
                                  : hobe_mesh_outlines(s->base.regions, s->outline, &s->mesh, err);
    if (!status)
        status = hobe_shape_solve(s, err);
    if (status)
        return status;
    hobe_section_set_shear(&s->base, &s->functions_rule);
    set_warping(s);
    return HOBE_OK;
}

/* For r^4: 3 x 3 points an edge. */
static enum hobe_status set_properties(hobe_section *section, struct hobe_error *err)
{
    struct shape *s = (struct shape *)section;
    struct hobe_rule fan;
    set_area(s);
    set_extent(s);
    enum hobe_status status = fan_rule(s, 3, &fan, err);
    if (status)
        return status;
    set_moments(s, &fan);
    status = solve(s, err);
    if (!status)
        set_wagner(s, &fan);
    hobe_rule_free(&fan);
    return status;
}

/* A section of that many outlines, all empty still, which hobe_section_free frees. */
static struct shape *new_shape(int regions, struct hobe_error *err)
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

/* A section with a text of its own that shares all else with those of the same content.  s has its
 * outlines and is solved here if need be. */
static hobe_section *share(struct shape *s, struct hobe_error *err)
{
    size_t count;
    struct shape *handle = hobe_alloc(1, sizeof *handle, err);
    double *content = handle ? content_of(s, &count, err) : NULL;
    if (content)
        handle->shared = hobe_section_share(&s->base, content, count, set_properties, err);
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
    struct shape *s = new_shape(1, err);
    if (!s)
        return NULL;
    s->paper = warping == HOBE_WARPING_PAPER;
    if (parts)
        s->parts = *parts;
    if (hobe_outline_new(loops, points, point, s->outline, err)) {
        hobe_section_free(&s->base);
        return NULL;
    }
    return share(s, err);
}

/* ---- composite sections --------------------------------------------------------------------- */

/* Part k with its material and its outline moved to its place. */
static enum hobe_status add_part(struct shape *s, int k, const struct hobe_section_part *part,
                                 struct hobe_error *err)
{
    if (part->section->material)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "it is a composite section itself; give its parts instead");
    if (!part->section->kind->outline)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "its section varies along the beam, which a part's must not");
    if (!isfinite(part->at[0]) || !isfinite(part->at[1]))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "at must be finite (m), got (%g, %g)",
                         part->at[0], part->at[1]);
    s->base.material[k] = part->material;
    enum hobe_status status = hobe_material_check(&part->material, err);
    if (!status)
        status = part->section->kind->outline(part->section, s->outline + k, err);
    if (!status)
        hobe_outline_move(s->outline + k, part->at[0], part->at[1]);
    return status;
}

static enum hobe_status add_parts(struct shape *s, const struct hobe_section_part *part,
                                  struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    s->base.material = hobe_alloc((size_t)s->base.regions, sizeof *s->base.material, err);
    if (!s->base.material)
        return HOBE_NO_MEMORY;
    for (int k = 0; !status && k < s->base.regions; k++) {
        char name[20];
        snprintf(name, sizeof name, "part %d", k + 1);
        status = add_part(s, k, part + k, err);
        if (status)
            hobe_fail_in(err, name);
    }
    return status;
}

hobe_section *hobe_section_composite(int parts, const struct hobe_section_part *part,
                                     struct hobe_error *err)
{
    if (parts < 1 || parts > HOBE_MAX_REGIONS) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "composite: there must be 1 to %d parts, got %d",
                  HOBE_MAX_REGIONS, parts);
        return NULL;
    }
    struct shape *s = new_shape(parts, err);
    if (!s)
        return NULL;
    if (add_parts(s, part, err)) {
        hobe_fail_in(err, "composite");
        hobe_section_free(&s->base);
        return NULL;
    }
    hobe_section *section = share(s, err);
    if (section)
        snprintf(section->text, sizeof section->text,
                 "composite of %d part%s, w: solved on %d triangles", parts, parts == 1 ? "" : "s",
                 hobe_section_triangles(section));
    else
        hobe_fail_in(err, "composite");
    return section;
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

struct shape *hobe_shape_like(const struct shape *like, const double *numbers,
                              struct hobe_error *err)
{
    const struct hobe_outline *o = like->outline;
    struct shape *s = new_shape(1, err);
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
    set_area(s);
    set_extent(s);
    return s;
}

static hobe_section *make_like(const hobe_section *section, const double *numbers, int bare,
                               struct hobe_error *err)
{
    const struct shape *like = (const struct shape *)section;
    struct shape *s = hobe_shape_like(like, numbers, err);
    if (!s)
        return NULL;
    snprintf(s->base.text, sizeof s->base.text, "outline of %d points, w: solved",
             s->outline->start[1]);
    if (!bare) {
        s->base.properties = (struct hobe_section_properties){0};
        s->base.probes = 0;
        return share(s, err);
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
