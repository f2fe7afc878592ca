/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_outline.h"

#include "outline.h"
#include "saint_venant.h"
#include "section_cache.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PAPER_POINTS = 3, MOST_GAUSS = 64 };

struct shape {
    struct hobe_section base;
    struct hobe_outline outline; /* about its centroid */
    struct hobe_mesh mesh;
    double *values; /* of the functions, [HOBE_SECTION_FUNCTIONS][mesh.nodes] */
    struct hobe_rule functions_rule;
    struct hobe_parts parts;
    int paper;                  /* w is the parts' */
    const hobe_section *shared; /* all that is pointed to belongs to this section; or NULL */
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
        branch(part, p->y, p->z, p->f[HOBE_W]);
    }
    return status;
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
        return hobe_rule_copy(&s->functions_rule, rule, err);
    return fan_rule(&s->outline, 2 * degree + 1, rule, err);
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
    hobe_mesh_fields(&s->mesh, s->values, y, z, f);
    if (paper || s->paper)
        parts_warping(&s->parts, y, z, f[HOBE_W]);
}

static void close_shape(hobe_section *section)
{
    struct shape *s = (struct shape *)section;
    if (s->shared) {
        hobe_section_drop(s->shared);
        return;
    }
    hobe_outline_free(&s->outline);
    hobe_mesh_free(&s->mesh);
    hobe_free(s->values);
    hobe_rule_free(&s->functions_rule);
}

static const struct hobe_section_kind shape_kind = {
    .rule = rule, .functions = functions, .close = close_shape};

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

/* The functions behind what they are made orthogonal to. */
enum { ONE, Y, Z, FUNCTION, BASIS = FUNCTION + HOBE_SECTION_FUNCTIONS };

/* G_ij = int g_i g_j dA. */
static void gram(const struct hobe_rule *rule, double G[BASIS][BASIS])
{
    memset(G, 0, sizeof(double[BASIS][BASIS]));
    for (int p = 0; p < rule->rule.points; p++) {
        const struct hobe_section_point *at = rule->point + p;
        double g[BASIS] = {[ONE] = 1, [Y] = at->y, [Z] = at->z};
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
            g[FUNCTION + f] = at->f[f][0];
        for (int i = 0; i < BASIS; i++)
            for (int j = 0; j < BASIS; j++)
                G[i][j] += at->weight * g[i] * g[j];
    }
}

static double product(double G[BASIS][BASIS], const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < BASIS; i++)
        for (int j = 0; j < BASIS; j++)
            sum += a[i] * G[i][j] * b[j];
    return sum;
}

/* Gram and Schmidt: sum_j T_ij g_j is g_i made orthogonal to those before it. */
static void orthogonalise(double G[BASIS][BASIS], double T[BASIS][BASIS])
{
    double square[BASIS];
    for (int i = 0; i < BASIS; i++) {
        for (int j = 0; j < BASIS; j++)
            T[i][j] = i == j;
        for (int k = 0; k < i; k++) {
            const double part = square[k] > 0 ? product(G, T[i], T[k]) / square[k] : 0;
            for (int j = 0; j <= k; j++)
                T[i][j] -= part * T[k][j];
        }
        square[i] = product(G, T[i], T[i]);
    }
}

/* Makes the functions orthogonal.  About its centre (ys, zs) the warping of a twist is
 * w + zs y - ys z; orthogonal to y and z it does not bend, which is Trefftz's shear centre. */
static void set_functions(struct shape *s)
{
    struct hobe_section_properties *p = &s->base.properties;
    double G[BASIS][BASIS], T[BASIS][BASIS];
    gram(&s->functions_rule, G);
    orthogonalise(G, T);
    p->zs = T[FUNCTION + HOBE_W][Y];
    p->ys = -T[FUNCTION + HOBE_W][Z];
    for (int n = 0; n < s->mesh.nodes; n++) {
        double g[BASIS] = {[ONE] = 1, [Y] = s->mesh.node[n][0], [Z] = s->mesh.node[n][1]};
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
            g[FUNCTION + f] = s->values[f * s->mesh.nodes + n];
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++) {
            double *value = s->values + f * s->mesh.nodes + n;
            *value = 0;
            for (int j = 0; j <= FUNCTION + f; j++)
                *value += T[FUNCTION + f][j] * g[j];
        }
    }
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

/* On the paper's parts w is theirs.  They have two axes of symmetry, where any such w is orthogonal
 * to wy and wz.  The mesh does not know where one part ends and another begins, and gives J_w and
 * Iw of theirs to 1e-4 only; they are integrated part by part. */
static enum hobe_status set_warping(struct shape *s, struct hobe_error *err)
{
    struct hobe_rule rule;
    if (!s->paper) {
        hobe_section_set_warping(&s->base, &s->functions_rule);
        return HOBE_OK;
    }
    for (int i = 0; i < s->functions_rule.rule.points; i++) {
        struct hobe_section_point *at = s->functions_rule.point + i;
        parts_warping(&s->parts, at->y, at->z, at->f[HOBE_W]);
    }
    const enum hobe_status status = parts_rule(&s->parts, 5, &rule, err);
    if (!status)
        hobe_section_set_warping(&s->base, &rule);
    hobe_rule_free(&rule);
    return status;
}

/* Mesh, functions and everything that needs them. */
static enum hobe_status solve(struct shape *s, struct hobe_error *err)
{
    struct hobe_section_properties *p = &s->base.properties;
    double energy;
    enum hobe_status status = hobe_mesh_outlines(1, &s->outline, &s->mesh, err);
    if (status)
        return status;
    s->values = hobe_alloc(HOBE_SECTION_FUNCTIONS * (size_t)s->mesh.nodes, sizeof *s->values, err);
    if (!s->values)
        return HOBE_NO_MEMORY;
    status = hobe_saint_venant(&s->mesh, s->values, &energy, err);
    if (!status)
        status = hobe_mesh_rule(&s->mesh, s->values, &s->functions_rule, err);
    if (status)
        return status;
    p->J = p->Iyy + p->Izz - energy;
    set_functions(s);
    hobe_rule_free(&s->functions_rule);
    status = hobe_mesh_rule(&s->mesh, s->values, &s->functions_rule, err);
    if (status)
        return status;
    hobe_section_set_shear(&s->base, &s->functions_rule);
    return set_warping(s, err);
}

/* For r^4: 3 x 3 points an edge. */
static enum hobe_status set_properties(hobe_section *section, struct hobe_error *err)
{
    struct shape *s = (struct shape *)section;
    struct hobe_section_properties *p = &section->properties;
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
    if (!status)
        set_wagner(s, &fan);
    hobe_rule_free(&fan);
    return status;
}

/* All that decides about the solution of s, whose outline is as it was given: count numbers. */
static double *content_of(const struct shape *s, size_t *count, struct hobe_error *err)
{
    const struct hobe_outline *o = &s->outline;
    const size_t loops = (size_t)o->loops, points = (size_t)o->start[loops];
    const size_t parts = (size_t)s->parts.count * sizeof *s->parts.part / sizeof(double);
    *count = 3 + loops + 2 * points + parts;
    double *content = hobe_alloc(*count, sizeof *content, err), *at = content;
    if (!content)
        return NULL;
    *at++ = s->paper;
    *at++ = s->parts.count;
    for (size_t l = 0; l <= loops; l++)
        *at++ = o->start[l];
    memcpy(at, o->point, 2 * points * sizeof *at);
    memcpy(at + 2 * points, s->parts.part, parts * sizeof *at);
    return content;
}

/* A section with a text of its own that shares all else with those of the same content.  s has its
 * outline and is solved here if need be. */
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
    struct shape *s = hobe_alloc(1, sizeof *s, err);
    if (!s)
        return NULL;
    s->base.kind = &shape_kind;
    s->paper = warping == HOBE_WARPING_PAPER;
    if (parts)
        s->parts = *parts;
    if (hobe_outline_new(loops, points, point, &s->outline, err)) {
        hobe_section_free(&s->base);
        return NULL;
    }
    return share(s, err);
}

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
