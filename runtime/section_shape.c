/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties of a section of any outline, and the functions that are solved on it. */
#include "section_shape.h"
#include "saint_venant.h"

#include <math.h>
#include <string.h>

void shape_set_area(struct shape *s)
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

void shape_set_extent(struct shape *s)
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

enum hobe_status shape_solve(struct shape *s, struct hobe_error *err)
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

/* Mesh, functions and everything that needs them. */
static enum hobe_status solve(struct shape *s, struct hobe_error *err)
{
    enum hobe_status status = s->paper
                                  ? parts_mesh(s, err)
                                  : hobe_mesh_outlines(s->base.regions, s->outline, &s->mesh, err);
    if (!status)
        status = shape_solve(s, err);
    if (status)
        return status;
    hobe_section_set_shear(&s->base, &s->functions_rule);
    set_warping(s);
    return HOBE_OK;
}

/* For r^4: 3 x 3 points an edge. */
enum hobe_status shape_set_properties(hobe_section *section, struct hobe_error *err)
{
    struct shape *s = (struct shape *)section;
    struct hobe_rule fan;
    shape_set_area(s);
    shape_set_extent(s);
    enum hobe_status status = shape_fan_rule(s, 3, &fan, err);
    if (status)
        return status;
    set_moments(s, &fan);
    status = solve(s, err);
    if (!status)
        set_wagner(s, &fan);
    hobe_rule_free(&fan);
    return status;
}
