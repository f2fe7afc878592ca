/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Circles and round tubes: w vanishes, wy and wz are known, and cubature in polar coordinates is
 * exact. */
#include "outline.h"
#include "section_surface.h"
#include "section_taper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MAX_RADII = 64,
    CUBIC = 3,   /* degree of wy and wz */
    CHORDS = 96, /* of a circle in a composite section */
};

struct ring {
    struct hobe_section base;
    double outer, inner;
};

/* Positions and weights of r dr on the radii: g[n][2]. */
typedef enum hobe_status radii(const struct ring *ring, int n, double (*g)[2],
                               struct hobe_error *err);

/* Gauss points in r^2, where even powers of r are polynomials of half the degree. */
static enum hobe_status square_radii(const struct ring *ring, int n, double (*g)[2],
                                     struct hobe_error *err)
{
    const double from = ring->inner * ring->inner, to = ring->outer * ring->outer;
    const enum hobe_status status = hobe_gauss(n, g, err);
    for (int i = 0; !status && i < n; i++) {
        g[i][0] = sqrt(from + (to - from) * g[i][0]);
        g[i][1] *= (to - from) / 2;
    }
    return status;
}

/* Gauss points in log r: positive and negative powers of r are exponentials, which converge fast
 * however small the bore (64 points: to round-off for radii of 10000 : 1). */
static enum hobe_status log_radii(const struct ring *ring, int n, double (*g)[2],
                                  struct hobe_error *err)
{
    const double length = log(ring->outer / ring->inner);
    const enum hobe_status status = hobe_gauss(n, g, err);
    for (int i = 0; !status && i < n; i++) {
        g[i][0] = ring->inner * exp(length * g[i][0]);
        g[i][1] *= length * g[i][0] * g[i][0];
    }
    return status;
}

/* Those radii times as many equally spaced angles as cancel every odd power up to the degree. */
static enum hobe_status polar_rule(const struct ring *ring, radii *set_radii, int n, int angles,
                                   struct hobe_rule *rule, struct hobe_error *err)
{
    double g[MAX_RADII][2];
    enum hobe_status status = set_radii(ring, n, g, err);
    if (!status)
        status = hobe_rule_new(rule, (size_t)(n * angles), err);
    for (int i = 0; !status && i < n * angles; i++) {
        struct hobe_section_point *p = rule->point + i;
        const double *at = g[i / angles], angle = 2 * M_PI * (i % angles) / angles;
        p->y = at[0] * cos(angle);
        p->z = at[0] * sin(angle);
        p->weight = 2 * M_PI * at[1] / angles;
    }
    return status;
}

/* Bending shear: psi = (a r + b r^3 + c/r) cos t has -div grad psi = r cos t = y with b = -1/8, and
 * no flux through the radii with c = 3/8 ri^2 ro^2 and an a that its part along y takes away:
 * wy = y g(r^2), g(s) = a + b s + c/s with int y wy dA = 0.  Into the bore it goes on linearly. */
static void functions(const hobe_section *section, int paper, double y, double z, double (*f)[4])
{
    const struct ring *ring = (const struct ring *)section;
    const double R2 = ring->outer * ring->outer, r2 = ring->inner * ring->inner;
    const double b = -1. / 8, c = 3. / 8 * r2 * R2;
    const double a = -(b * 2 / 3 * (R2 * R2 + R2 * r2 + r2 * r2) + 2 * c) / (R2 + r2);
    const double s = y * y + z * z, at = fmax(s, r2), over = c > 0 ? c / at : 0;
    const double g = a + b * at + over, slope = s < r2 ? 0 : 2 * (b - (c > 0 ? over / at : 0));
    const double wy[3] = {y * g, g + slope * y * y, slope * y * z};
    const double wz[3] = {z * g, slope * y * z, g + slope * z * z};
    (void)paper;
    memcpy(f[HOBE_WY], wy, sizeof wy);
    memcpy(f[HOBE_WZ], wz, sizeof wz);
}

static enum hobe_status functions_rule(const struct ring *ring, int degree, struct hobe_rule *rule,
                                       struct hobe_error *err)
{
    const int angles = 4 * degree + 1;
    const enum hobe_status status =
        ring->inner > 0 ? polar_rule(ring, log_radii, MAX_RADII, angles, rule, err)
                        : polar_rule(ring, square_radii, degree + 1, angles, rule, err);
    for (int i = 0; !status && i < rule->rule.points; i++) {
        struct hobe_section_point *p = rule->point + i;
        functions(&ring->base, 0, p->y, p->z, p->f);
    }
    return status;
}

/* For polynomials of degree 4 k, and wy and wz as they are or cubics. */
static enum hobe_status rule(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err)
{
    const struct ring *ring = (const struct ring *)section;
    const int degree = kernel->degree, angles = 4 * degree + 1;
    if (integration == HOBE_INTEGRATION_PAPER)
        return hobe_section_no_paper(ring->inner > 0 ? "a tube" : "a circle", err);
    if (degree >= MAX_RADII)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "element %s has modes of degree %d, at most %d",
                         kernel->name, degree, MAX_RADII - 1);
    if (hobe_section_bends(kernel))
        return functions_rule(ring, degree > CUBIC ? degree : CUBIC, rule, err);
    return polar_rule(ring, square_radii, degree + 1, angles, rule, err);
}

/* Rows from the outer circle in; a solid circle has no edge at its centre. */
static enum hobe_status surface(const hobe_section *section, int fineness,
                                struct hobe_surface *surface, struct hobe_error *err)
{
    const struct ring *ring = (const struct ring *)section;
    const int rows = 2 * fineness, turn = 8 * rows;
    const enum hobe_status status = hobe_surface_grid(rows, turn, 1, surface, err);
    for (int p = 0; !status && p < surface->points; p++) {
        const double angle = 2 * M_PI * (p % turn) / turn, in = (double)(p / turn) / rows;
        const double r = ring->outer + (ring->inner - ring->outer) * in;
        surface->point[p][1] = r * cos(angle);
        surface->point[p][2] = r * sin(angle);
    }
    if (!status && ring->inner == 0)
        surface->edges = surface->outline = turn;
    return status;
}

static int count_sizes(const hobe_section *section)
{
    return ((const struct ring *)section)->inner > 0 ? 2 : 1;
}

static void read_sizes(const hobe_section *section, double *sizes)
{
    const struct ring *ring = (const struct ring *)section;
    sizes[0] = ring->outer;
    if (ring->inner > 0)
        sizes[1] = ring->inner;
}

static hobe_section *make_like(const hobe_section *like, const double *sizes, int bare,
                               struct hobe_error *err)
{
    (void)bare;
    return ((const struct ring *)like)->inner > 0 ? hobe_section_tube(sizes[0], sizes[1], err)
                                                  : hobe_section_circle(sizes[0], err);
}

static const struct hobe_section_sizes ring_sizes = {count_sizes, read_sizes, make_like, NULL};
/* Polygons of the circles' areas: their polar moments are larger by 1e-7. */
static enum hobe_status outline(const hobe_section *section, struct hobe_outline *outline,
                                struct hobe_error *err)
{
    const struct ring *ring = (const struct ring *)section;
    const double step = 2 * M_PI / CHORDS, longer = sqrt(step / sin(step));
    double point[2 * CHORDS][2];
    for (int i = 0; i < 2 * CHORDS; i++) {
        const double r = longer * (i < CHORDS ? ring->outer : ring->inner), angle = step * i;
        point[i][0] = r * cos(angle);
        point[i][1] = r * sin(angle);
    }
    return hobe_outline_new(ring->inner > 0 ? 2 : 1, (const int[]){CHORDS, CHORDS},
                            (const double(*)[2])point, outline, err);
}

static const struct hobe_section_kind ring_kind = {.rule = rule,
                                                   .functions = functions,
                                                   .surface = surface,
                                                   .outline = outline,
                                                   .sizes = &ring_sizes};

static hobe_section *ring(double outer, double inner, struct hobe_error *err)
{
    const double R2 = outer * outer, r2 = inner * inner;
    const double A = M_PI * (R2 - r2), I = A * (R2 + r2) / 4;
    struct hobe_rule rule;
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
    if (functions_rule(made, CUBIC, &rule, err)) {
        hobe_section_free(&made->base);
        return NULL;
    }
    hobe_section_set_shear(&made->base, &rule);
    hobe_rule_free(&rule);
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
