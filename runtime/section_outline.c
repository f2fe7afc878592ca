/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_outline.h"

#include "outline.h"
#include "saint_venant.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PAPER_POINTS = 3, MOST_GAUSS = 64 };

struct shape {
    struct hobe_section base;
    struct hobe_outline outline; /* about its centroid */
    struct hobe_mesh mesh;
    double *w; /* [mesh.nodes] */
    struct hobe_rule warping_rule;
    struct hobe_parts parts;
    int paper; /* w is the parts' */
};

/* ---- cubature ------------------------------------------------------------------------------- */

static enum hobe_status gauss_points(int n, double (*gauss)[2], struct hobe_error *err)
{
    if (n > MOST_GAUSS)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%d > %d Gauss points are asked of a section",
                         n, MOST_GAUSS);
    return hobe_gauss(n, gauss, err);
}

/* For polynomials of degree 2 n - 2: the triangles from the centroid to each edge, counted negative
 * where the edge runs back, with n x n points each.  Some points lie outside the material, which
 * polynomials do not mind; the mesh would need a hundred times as many. */
static enum hobe_status fan_rule(const struct hobe_outline *o, int n, struct hobe_rule *rule,
                                 struct hobe_error *err)
{
    double gauss[MOST_GAUSS][2];
    enum hobe_status status = gauss_points(n, gauss, err);
    if (!status)
        status = hobe_rule_new(rule, (size_t)(n * n * o->start[o->loops]), err);
    if (status)
        return status;
    struct hobe_section_point *p = rule->point;
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
            const double twice = a[0] * b[1] - a[1] * b[0];
            for (int g = 0; g < n * n; g++, p++) {
                const double *s = gauss[g / n], *t = gauss[g % n];
                p->y = s[0] * (a[0] + t[0] * (b[0] - a[0]));
                p->z = s[0] * (a[1] + t[0] * (b[1] - a[1]));
                p->weight = twice * s[0] * s[1] * t[1];
            }
        }
    return HOBE_OK;
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
        branch(part, p->y, p->z, p->f[0]);
    }
    return status;
}

static enum hobe_status rule(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err)
{
    const struct shape *s = (const struct shape *)section;
    const int degree = s->paper && kernel->functions && kernel->degree < 2 ? 2 : kernel->degree;
    if (integration == HOBE_INTEGRATION_PAPER && !s->parts.count)
        return hobe_section_no_paper("such an outline", err);
    if (integration == HOBE_INTEGRATION_PAPER)
        return parts_rule(&s->parts, PAPER_POINTS, rule, err);
    if (s->paper)
        return parts_rule(&s->parts, 2 * degree + 1, rule, err);
    if (kernel->functions)
        return hobe_rule_copy(&s->warping_rule, rule, err);
    return fan_rule(&s->outline, 2 * degree + 1, rule, err);
}

/* ---- w -------------------------------------------------------------------------------------- */

static double outside(const struct hobe_part *part, double y, double z)
{
    return hypot(fmax(0, fabs(y - part->y) - part->width / 2),
                 fmax(0, fabs(z - part->z) - part->height / 2));
}

static void warping(const hobe_section *section, int paper, double y, double z, double *f)
{
    const struct shape *s = (const struct shape *)section;
    if (!paper && !s->paper) {
        hobe_mesh_field(&s->mesh, s->w, y, z, f);
        return;
    }
    const struct hobe_part *nearest = s->parts.part;
    for (int i = 1; i < s->parts.count; i++)
        if (outside(s->parts.part + i, y, z) < outside(nearest, y, z))
            nearest = s->parts.part + i;
    branch(nearest, y, z, f);
}

static void close_shape(hobe_section *section)
{
    struct shape *s = (struct shape *)section;
    hobe_outline_free(&s->outline);
    hobe_mesh_free(&s->mesh);
    hobe_free(s->w);
    hobe_rule_free(&s->warping_rule);
}

static const struct hobe_section_kind shape_kind = {rule, warping, close_shape};

/* ---- properties ----------------------------------------------------------------------------- */

/* Moments of area, about the centroid. */
static void set_moments(struct shape *s, const struct hobe_rule *fan)
{
    struct hobe_section_properties *p = &s->base.properties;
    const struct hobe_outline *o = &s->outline;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < fan->rule.points; i++) {
        const struct hobe_section_point *at = fan->point + i;
        p->Iyy += at->weight * at->z * at->z;
        p->Izz += at->weight * at->y * at->y;
        p->Iyz += at->weight * at->y * at->z;
    }
    for (int i = 0; i < o->start[1]; i++)
        for (int a = 0; a < 2; a++) {
            low[a] = fmin(low[a], o->point[i][a]);
            high[a] = fmax(high[a], o->point[i][a]);
        }
    p->width = high[0] - low[0];
    p->height = high[1] - low[1];
}

static void set_probes(struct shape *s)
{
    const int points = s->outline.start[1];
    s->base.probes = points < HOBE_PROBES ? points : HOBE_PROBES;
    for (int i = 0; i < s->base.probes; i++)
        memcpy(s->base.probe[i], s->outline.point[i * points / s->base.probes], sizeof(double[2]));
}

/* Trefftz: the centre of a twist that does not bend.  About (ys, zs) w is w + zs y - ys z, which is
 * orthogonal to y and z when
 *     int w y = ys Iyz - zs Izz,  int w z = ys Iyy - zs Iyz. */
static void set_shear_centre(struct shape *s)
{
    struct hobe_section_properties *p = &s->base.properties;
    const double determinant = p->Iyy * p->Izz - p->Iyz * p->Iyz;
    double wy = 0, wz = 0;
    for (int i = 0; i < s->warping_rule.rule.points; i++) {
        const struct hobe_section_point *at = s->warping_rule.point + i;
        wy += at->weight * at->f[0][0] * at->y;
        wz += at->weight * at->f[0][0] * at->z;
    }
    p->ys = (p->Izz * wz - p->Iyz * wy) / determinant;
    p->zs = (p->Iyz * wz - p->Iyy * wy) / determinant;
    for (int i = 0; i < s->mesh.nodes; i++)
        s->w[i] += p->zs * s->mesh.node[i][0] - p->ys * s->mesh.node[i][1];
}

static void set_wagner(struct shape *s, const struct hobe_rule *fan)
{
    struct hobe_section_properties *p = &s->base.properties;
    double r2 = 0, r4 = 0;
    for (int i = 0; i < fan->rule.points; i++) {
        const struct hobe_section_point *at = fan->point + i;
        const double r = hypot(at->y - p->ys, at->z - p->zs);
        r2 += at->weight * r * r;
        r4 += at->weight * r * r * r * r;
    }
    p->Wagner = r4 - r2 * r2 / p->A;
}

/* Mesh, w and everything that needs w. */
static enum hobe_status solve(struct shape *s, struct hobe_error *err)
{
    struct hobe_section_properties *p = &s->base.properties;
    double energy;
    enum hobe_status status = hobe_mesh_outline(&s->outline, &s->mesh, err);
    if (status)
        return status;
    s->w = hobe_alloc((size_t)s->mesh.nodes, sizeof *s->w, err);
    if (!s->w)
        return HOBE_NO_MEMORY;
    status = hobe_saint_venant(&s->mesh, s->w, &energy, err);
    if (!status)
        status = hobe_mesh_rule(&s->mesh, s->w, &s->warping_rule, err);
    if (status)
        return status;
    p->J = p->Iyy + p->Izz - energy;
    set_shear_centre(s);
    hobe_rule_free(&s->warping_rule);
    return s->paper ? parts_rule(&s->parts, 5, &s->warping_rule, err)
                    : hobe_mesh_rule(&s->mesh, s->w, &s->warping_rule, err);
}

/* For r^4: 3 x 3 points an edge. */
static enum hobe_status set_properties(struct shape *s, struct hobe_error *err)
{
    struct hobe_section_properties *p = &s->base.properties;
    struct hobe_rule fan;
    double centroid[2];
    p->A = hobe_outline_area(&s->outline, centroid);
    p->yc = centroid[0];
    p->zc = centroid[1];
    hobe_outline_move(&s->outline, -centroid[0], -centroid[1]);
    set_probes(s);
    enum hobe_status status = fan_rule(&s->outline, 3, &fan, err);
    if (status)
        return status;
    set_moments(s, &fan);
    status = solve(s, err);
    if (!status) {
        set_wagner(s, &fan);
        hobe_section_set_warping(&s->base, &s->warping_rule);
    }
    hobe_rule_free(&fan);
    return status;
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
    struct shape *s = hobe_alloc(1, sizeof *s, err);
    if (!s)
        return NULL;
    s->base.kind = &shape_kind;
    s->paper = warping == HOBE_WARPING_PAPER;
    if (parts)
        s->parts = *parts;
    if (hobe_outline_new(loops, points, point, &s->outline, err) || set_properties(s, err)) {
        hobe_section_free(&s->base);
        return NULL;
    }
    return &s->base;
}

int hobe_section_triangles(const hobe_section *section)
{
    return ((const struct shape *)section)->mesh.triangles;
}

hobe_section *hobe_section_polygon(int loops, const int *points, const double (*point)[2],
                                   struct hobe_error *err)
{
    if (loops < 1) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "a polygon needs an outline, got %d loops", loops);
        return NULL;
    }
    hobe_section *section =
        hobe_section_outline(loops, points, point, NULL, HOBE_WARPING_SOLVED, err);
    if (section)
        snprintf(section->text, sizeof section->text,
                 "polygon of %d points and %d hole%s, w: solved on %d triangles", points[0],
                 loops - 1, loops == 2 ? "" : "s", hobe_section_triangles(section));
    return section;
}
