/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slender curved and pretwisted beams against the theory of rods: arcs in their plane and out of
 * it, twisted strips, and arcs joined to straight beams.  Looks into the core (model.h) for what a
 * join shares. */
#include "check.h"
#include "model.h"
#include "rod.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 70e9; /* nu = 0 everywhere: G = E/2 */

static const double NONE[3] = {0};

/* An arc of radius R about Z from the origin, along {cos start, sin start, 0} at first; its section
 * turned by `twist` at the end, and straight along that direction where angle = 0 (length R). */
struct shape {
    double R, angle, start, twist, width, height;
    double stiffness[4]; /* EA, GJ, EIyy, EIzz: set by with_stiffness */
};

static struct shape with_stiffness(struct shape s)
{
    hobe_section *section = rectangle(s.width, s.height);
    const struct hobe_section_properties p = properties_of(section);
    hobe_section_free(section);
    const double stiffness[4] = {E * p.A, E / 2 * p.J, E * p.Iyy, E * p.Izz};
    memcpy(s.stiffness, stiffness, sizeof stiffness);
    return s;
}

static double length_of(const struct shape *s)
{
    return s->angle != 0 ? s->R * s->angle : s->R;
}

static enum hobe_status shape_point(void *context, double t, double *r, struct hobe_error *err)
{
    const struct shape *s = context;
    const double p = s->angle * t, c = cos(s->start), i = sin(s->start);
    const double x = s->angle != 0 ? s->R * sin(p) : s->R * t;
    const double y = s->angle != 0 ? s->R * (1 - cos(p)) : 0;
    (void)err;
    r[0] = c * x - i * y;
    r[1] = i * x + c * y;
    r[2] = 0;
    return HOBE_OK;
}

static enum hobe_status shape_twist(void *context, double at, double *phi, struct hobe_error *err)
{
    (void)err;
    *phi = ((const struct shape *)context)->twist * at;
    return HOBE_OK;
}

static void shape_place(const void *context, double t, struct rod_place *place)
{
    struct shape s = *(const struct shape *)context;
    const double p = s.start + s.angle * t, c = cos(p), i = sin(p);
    const double C = cos(s.twist * t), S = sin(s.twist * t);
    const double *k = s.stiffness;
    *place = (struct rod_place){.frame = {{c, i, 0}, {-i * C, c * C, S}, {i * S, -c * S, C}},
                                .force = {k[0], k[0] / 2, k[0] / 2},
                                .moment = {k[1], k[2], k[3]}};
    shape_point(&s, t, place->r, NULL);
}

/* ---- one beam -------------------------------------------------------------------------------- */

/* The end's motion under F and M there. */
static struct rod_tip beam_tip(const char *element, int elements, const struct shape *shape,
                               const double F[3], const double M[3])
{
    struct shape s = *shape;
    struct rod_tip tip;
    hobe_curve *curve = curve_of(shape_point, shape_twist, &s);
    hobe_section *section = rectangle(s.width, s.height);
    struct hobe_beam beam = beam_along_x(element, elements, section, E, 0, 1);
    beam.curve = curve;
    hobe_model *model = cantilever(&beam, 1);
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    add_moment(model, "beam", 1, M[0], M[1], M[2]);
    const struct hobe_point end = tip_of(model, 1);
    memcpy(tip.u, end.u, sizeof tip.u);
    memcpy(tip.rotation, end.rotation, sizeof tip.rotation);
    hobe_curve_free(curve);
    hobe_section_free(section);
    return tip;
}

static struct rod_tip rod_end(const struct shape *shape, const double F[3], const double M[3])
{
    const struct rod rod = {shape_place, shape, length_of(shape)};
    struct rod_place end;
    struct rod_tip tip = {{0}, {0}};
    shape_place(shape, 1, &end);
    rod_add(&rod, end.r, F, M, &tip);
    return tip;
}

/* How far displacement and rotation of the beam are from the rod's, over theirs. */
static void differences(const char *element, int elements, struct shape shape, const double F[3],
                        const double M[3], double off[2][3])
{
    shape = with_stiffness(shape);
    const struct rod_tip rod = rod_end(&shape, F, M);
    /* as small a load as leaves the second order behind */
    const double scale = 1e-8 / fmax(norm(rod.u), norm(rod.rotation));
    double f[3], m[3];
    for (int a = 0; a < 3; a++) {
        f[a] = scale * F[a];
        m[a] = scale * M[a];
    }
    const struct rod_tip beam = beam_tip(element, elements, &shape, f, m);
    for (int a = 0; a < 3; a++) {
        off[0][a] = (beam.u[a] / scale - rod.u[a]) / norm(rod.u);
        off[1][a] = (beam.rotation[a] / scale - rod.rotation[a]) / norm(rod.rotation);
    }
}

/* The beam becomes the rod as it gets thin: what a beam of thickness h differs by, (h/R)^2, the
 * value at h/2 eliminates, and (h/R)^4 and the mesh are left. */
static void becomes_rod(const char *element, int elements, struct shape shape, const double F[3],
                        const double M[3], double tolerance, const char *what)
{
    struct shape half = shape;
    double thick[2][3], thin[2][3], worst[2] = {0};
    half.width /= 2;
    half.height /= 2;
    differences(element, elements, shape, F, M, thick);
    differences(element, elements, half, F, M, thin);
    for (int k = 0; k < 6; k++) {
        const double left = (4 * thin[k / 3][k % 3] - thick[k / 3][k % 3]) / 3;
        worst[0] = fmax(worst[0], fabs(thick[k / 3][k % 3]));
        worst[1] = fmax(worst[1], fabs(left));
        check_absolute(left, 0, tolerance, "%s: %s[%d]", what, k < 3 ? "u" : "rotation", k % 3);
    }
    printf("%-24s %-7s off by %.1e, in the limit by %.1e\n", what, element, worst[0], worst[1]);
}

/* The rods themselves: a quarter of a ring by Castigliano's theorem, pi/4 and 3 pi/4 - 2 of
 * F R^3/(EI) and of F R^3/(GJ). */
static void rods(void)
{
    const struct shape ring =
        with_stiffness((struct shape){.R = 1, .angle = M_PI / 2, .width = 1e-6, .height = 2e-6});
    const double X[3] = {1, 0, 0}, Y[3] = {0, 1, 0}, Z[3] = {0, 0, 1};
    const double GJ = ring.stiffness[1], EIy = ring.stiffness[2], EIz = ring.stiffness[3];
    const double quarter = M_PI / 4, rest = 3 * M_PI / 4 - 2;
    /* stretch and shear are (h/R)^2 = 1e-12 of it */
    check_relative(rod_end(&ring, X, NONE).u[0], quarter / EIz, 1e-10, "ring along X");
    check_relative(rod_end(&ring, X, NONE).u[1], -1 / (2 * EIz), 1e-10, "ring across X");
    check_relative(rod_end(&ring, Y, NONE).u[1], rest / EIz, 1e-10, "ring along Y");
    check_relative(rod_end(&ring, Z, NONE).u[2], quarter / EIy + rest / GJ, 1e-10, "ring along Z");
    check_relative(rod_end(&ring, NONE, Z).rotation[2], M_PI / 2 / EIz, 1e-10, "ring about Z");
    check_relative(rod_end(&ring, NONE, X).rotation[0], quarter * (1 / GJ + 1 / EIy), 1e-10,
                   "ring about X");
}

static void rings(void)
{
    const struct shape ring = {.R = 1, .angle = M_PI / 2, .width = 0.02, .height = 0.03};
    const double in_plane[3] = {2, 1, 0}, across[3] = {0, 0, 1}, M[3] = {1, 2, 3};
    becomes_rod("MGD30w", 48, ring, in_plane, NONE, 5e-7, "ring, in its plane");
    becomes_rod("MGD30w", 48, ring, across, NONE, 5e-7, "ring, out of its plane");
    becomes_rod("3433w", 32, ring, NONE, M, 5e-7, "ring, moment");
}

static void strips(void)
{
    const struct shape quarter = {.R = 1, .twist = M_PI / 2, .width = 0.01, .height = 0.002};
    struct shape turns = quarter;
    turns.twist = 6 * M_PI;
    const double F[3] = {0, 1, 2}, M[3] = {0, 2, 1};
    becomes_rod("3433w", 64, quarter, F, NONE, 5e-7, "strip, a quarter turn");
    becomes_rod("MGD30w", 64, quarter, F, M, 1e-6, "strip, a quarter turn");
    becomes_rod("3433w", 256, turns, F, M, 1e-6, "strip, three turns");
}

/* ---- mass ------------------------------------------------------------------------------------ */

/* Relative to Pappus' A R angle: the centroid is on the axis. */
static double mass_error(const char *element, int elements, const struct shape *shape)
{
    struct shape s = *shape;
    hobe_curve *curve = curve_of(shape_point, shape_twist, &s);
    hobe_section *section = rectangle(s.width, s.height);
    struct hobe_beam beam = beam_along_x(element, elements, section, E, 0, 1);
    beam.curve = curve;
    beam.material.rho = 2700;
    hobe_model *model = cantilever(&beam, 0);
    hobe_modes *modes = modes_of(model, NULL, 1, HOBE_MODAL_AUTO);
    const double mass = modes_info(modes).mass;
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
    hobe_curve_free(curve);
    return mass / (beam.material.rho * s.width * s.height * length_of(&s)) - 1;
}

/* Axis and slopes of an element are polynomials, whose volume is that of the arc, or of the twisted
 * strip, to the fourth order of the turn in an element. */
static void masses(void)
{
    static const char *const names[] = {"MGD30w", "3333", "3433"};
    const struct shape shapes[2] = {{.R = 1, .angle = 1.5, .twist = 1, .width = 0.1, .height = 0.3},
                                    {.R = 1, .twist = 2, .width = 0.1, .height = 0.3}};
    for (int i = 0; i < 6; i++) {
        const struct shape *shape = shapes + i % 2;
        const double coarse = mass_error(names[i / 2], 4, shape);
        const double fine = mass_error(names[i / 2], 8, shape);
        printf("mass of %s, %s: off by %.1e, %.1e\n", i % 2 ? "a strip" : "an arc", names[i / 2],
               coarse, fine);
        check_absolute(fine, 0, 1e-5, "%s: mass", names[i / 2]);
        check_absolute(log2(coarse / fine), 4, 0.1, "%s: order of the mass", names[i / 2]);
    }
}

/* ---- joins ----------------------------------------------------------------------------------- */

static void shifted_place(const void *context, double t, struct rod_place *place)
{
    shape_place(context, t, place);
    place->r[0] += 1; /* behind the straight beam */
}

static enum hobe_status shifted_point(void *context, double t, double *r, struct hobe_error *err)
{
    const enum hobe_status status = shape_point(context, t, r, err);
    r[0] += 1;
    return status;
}

/* A straight beam of 1 m along X and an arc that goes on from its end, at an angle or not; how far
 * the tip is from the rods' place for it. */
static void joined(double start, int corners, double height, double off[3])
{
    struct shape arc = with_stiffness(
        (struct shape){.R = 1, .angle = 1, .start = start, .width = height, .height = height});
    struct shape bar = arc;
    bar.angle = bar.start = 0;
    const double F[3] = {1e-4 * pow(height, 4), 2e-4 * pow(height, 4), 3e-4 * pow(height, 4)};
    hobe_curve *curve = curve_of(shifted_point, NULL, &arc);
    hobe_section *section = rectangle(height, height);
    struct hobe_beam first = beam_along_x("MGD30w", 4, section, E, 0, 1), second = first;
    second.name = "arc";
    second.elements = 16;
    second.curve = curve;
    hobe_model *model = cantilever(&first, 1);
    add_beam(model, &second);
    add_join(model, "beam", 1, "arc", 0);
    add_force(model, "arc", 1, F[0], F[1], F[2]);
    hobe_solution *solution = solve(model, 1);
    check_that((int)model->ties.count == corners, "start %g: %d corners", start,
               (int)model->ties.count);
    const struct hobe_point tip = point_of(solution, "arc", 1, 0, 0);
    const struct hobe_point at[2] = {point_of(solution, "beam", 1, 0, 0),
                                     point_of(solution, "arc", 0, 0, 0)};
    check_absolute(distance(at[0].u, at[1].u), 0, 1e-12 * norm(tip.u), "start %g: joint", start);
    check_absolute(distance(at[0].rotation, at[1].rotation), 0, 1e-14, "start %g: joint", start);
    struct rod_tip expected = {{0}, {0}};
    const struct rod rod[2] = {{shape_place, &bar, 1}, {shifted_place, &arc, 1}};
    for (int i = 0; i < 2; i++)
        rod_add(rod + i, tip.r0, F, NONE, &expected);
    for (int a = 0; a < 3; a++)
        off[a] = (tip.u[a] - expected.u[a]) / norm(expected.u);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_curve_free(curve);
    hobe_section_free(section);
}

/* Parallel frames share their vectors, others meet in a corner; both carry all forces and moments.
 */
static void joins(double start, int corners, double tolerance)
{
    double thick[3], thin[3];
    joined(start, corners, 0.02, thick);
    joined(start, corners, 0.01, thin);
    printf("joined at %g rad: off by %.1e, %.1e, %.1e\n", start, thin[0], thin[1], thin[2]);
    for (int a = 0; a < 3; a++)
        check_absolute((4 * thin[a] - thick[a]) / 3, 0, tolerance, "joined at %g: u[%d]", start, a);
}

int main(void)
{
    random_start();
    rods();
    rings();
    strips();
    masses();
    joins(0, 0, 2e-6);
    joins(0.6, 1, 2e-6);
    return check_report();
}
