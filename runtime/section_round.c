/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Circles and round tubes: w vanishes, and cubature in polar coordinates is exact. */
#include "section.h"

#include <math.h>
#include <stdio.h>

enum { MAX_RADII = 64 };

struct ring {
    struct hobe_section base;
    double outer, inner;
};

/* For polynomials of degree 4 k: Gauss points in r^2, where even powers of r are polynomials of
 * degree 2 k, times equally spaced angles.  Odd powers come with angles that cancel. */
static enum hobe_status rule(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err)
{
    const struct ring *ring = (const struct ring *)section;
    const int degree = 4 * kernel->degree, radii = kernel->degree + 1, angles = degree + 1;
    const double from = ring->inner * ring->inner, to = ring->outer * ring->outer;
    double gauss[MAX_RADII][2];
    if (integration == HOBE_INTEGRATION_PAPER)
        return hobe_section_no_paper(ring->inner > 0 ? "a tube" : "a circle", err);
    if (radii > MAX_RADII)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "element %s has modes of degree %d, at most %d",
                         kernel->name, kernel->degree, MAX_RADII - 1);
    enum hobe_status status = hobe_gauss(radii, gauss, err);
    if (!status)
        status = hobe_rule_new(rule, (size_t)(radii * angles), err);
    for (int i = 0; !status && i < radii * angles; i++) {
        struct hobe_section_point *p = rule->point + i;
        const double *g = gauss[i / angles], angle = 2 * M_PI * (i % angles) / angles;
        const double r = sqrt(from + (to - from) * g[0]);
        p->y = r * cos(angle);
        p->z = r * sin(angle);
        p->weight = M_PI * (to - from) * g[1] / angles;
    }
    return status;
}

static void no_warping(const hobe_section *section, int paper, double y, double z, double *f)
{
    (void)section, (void)paper, (void)y, (void)z;
    f[0] = f[1] = f[2] = 0;
}

static const struct hobe_section_kind ring_kind = {rule, no_warping, NULL};

static hobe_section *ring(double outer, double inner, struct hobe_error *err)
{
    const double R2 = outer * outer, r2 = inner * inner;
    const double A = M_PI * (R2 - r2), I = A * (R2 + r2) / 4;
    struct ring *made = hobe_alloc(1, sizeof *made, err);
    if (!made)
        return NULL;
    made->outer = outer;
    made->inner = inner;
    made->base = (struct hobe_section){.kind = &ring_kind, .probes = 9};
    made->base.properties = (struct hobe_section_properties){
        .A = A,
        .Iyy = I,
        .Izz = I,
        .J = 2 * I,
        .J_w = 2 * I,
        .Wagner = M_PI * (R2 * R2 * R2 - r2 * r2 * r2) / 3 - 4 * I * I / A,
        .width = 2 * outer,
        .height = 2 * outer,
    };
    made->base.probe[8][0] = inner;
    for (int i = 0; i < 8; i++) {
        made->base.probe[i][0] = outer * cos(i * M_PI / 4);
        made->base.probe[i][1] = outer * sin(i * M_PI / 4);
    }
    return &made->base;
}

hobe_section *hobe_section_circle(double radius, struct hobe_error *err)
{
    if (!(radius > 0 && isfinite(radius))) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "a circle needs radius > 0 (m), got %g", radius);
        return NULL;
    }
    hobe_section *section = ring(radius, 0, err);
    if (section)
        snprintf(section->text, sizeof section->text, "circle of radius %g m, w: none", radius);
    return section;
}

hobe_section *hobe_section_tube(double outer, double inner, struct hobe_error *err)
{
    if (!(inner > 0 && outer > inner && isfinite(outer))) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "a tube needs radii outer > inner > 0 (m), got outer = %g, inner = %g", outer,
                  inner);
        return NULL;
    }
    hobe_section *section = ring(outer, inner, err);
    if (section)
        snprintf(section->text, sizeof section->text, "tube of radii %g and %g m, w: none", outer,
                 inner);
    return section;
}
