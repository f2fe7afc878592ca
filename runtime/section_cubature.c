/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cubature of a section of any outline: by its edges for polynomials, by its mesh for functions. */
#include "saint_venant.h"
#include "section_shape.h"

#include <string.h>

enum { PAPER_POINTS = 3 };

enum hobe_status shape_gauss(int n, double (*gauss)[2], struct hobe_error *err)
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

/* The triangles from the centroid to each edge, counted negative
 * where the edge runs back, with n x n points each.  Some points lie outside the material, which
 * polynomials do not mind; the mesh would need a hundred times as many. */
enum hobe_status shape_fan_rule(const struct shape *shape, int n, struct hobe_rule *rule,
                                struct hobe_error *err)
{
    double gauss[MOST_GAUSS][2];
    int edges = 0;
    *rule = (struct hobe_rule){0};
    for (int r = 0; r < shape->base.regions; r++)
        edges += shape->outline[r].start[shape->outline[r].loops];
    enum hobe_status status = shape_gauss(n, gauss, err);
    if (!status)
        status = hobe_rule_new(rule, (size_t)(n * n * edges), err);
    struct hobe_section_point *p = rule->point;
    for (int r = 0; !status && r < shape->base.regions; r++)
        p = add_fans(shape->outline + r, r, n, (const double(*)[2])gauss, p);
    return status;
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
        status = hobe_mesh_rule(&s->mesh, shape_owner(s)->distortion + fields * s->mesh.nodes,
                                &more, err);
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

enum hobe_status shape_rule(const hobe_section *section, const struct hobe_kernel *kernel,
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
    return shape_fan_rule(s, 2 * degree + 1, rule, err);
}
