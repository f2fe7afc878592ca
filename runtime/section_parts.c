/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's closed forms: rectangles, each with its branch of w (Tang et al. 2022, appendix). */
#include "section_shape.h"

#include <math.h>

static void branch(const struct hobe_part *part, double y, double z, double *f)
{
    f[0] = y * (part->a * z + part->b);
    f[1] = part->a * z + part->b;
    f[2] = part->a * y;
}

enum hobe_status parts_rule(const struct hobe_parts *parts, int n, struct hobe_rule *rule,
                            struct hobe_error *err)
{
    double gauss[MOST_GAUSS][2];
    enum hobe_status status = shape_gauss(n, gauss, err);
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

static double outside(const struct hobe_part *part, double y, double z)
{
    return hypot(fmax(0, fabs(y - part->y) - part->width / 2),
                 fmax(0, fabs(z - part->z) - part->height / 2));
}

void parts_warping(const struct hobe_parts *parts, double y, double z, double *f)
{
    const struct hobe_part *nearest = parts->part;
    for (int i = 1; i < parts->count; i++)
        if (outside(parts->part + i, y, z) < outside(nearest, y, z))
            nearest = parts->part + i;
    branch(nearest, y, z, f);
}

enum hobe_status parts_mesh(struct shape *s, struct hobe_error *err)
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
