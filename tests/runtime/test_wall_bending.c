/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How walls bend in torsion: against frames and rings of thin walls, against solids, and what is
 * told of it. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double NU = 0.3;

static hobe_section *made(hobe_section *section, const struct hobe_error *err)
{
    if (!section)
        check_stop("%s", err->message);
    return section;
}

static hobe_section *hollow(double width, double height, double thickness)
{
    struct hobe_error err;
    return made(hobe_section_hollow(width, height, thickness, HOBE_WARPING_SOLVED, &err), &err);
}

/* c of a section, which is freed. */
static double bending_of(hobe_section *section)
{
    struct hobe_error err;
    double c;
    if (hobe_section_wall_bending(section, &c, &err))
        check_stop("%s", err.message);
    hobe_section_free(section);
    return c;
}

/* ---- sections ------------------------------------------------------------------------------- */

/* Twice the energy of a wall of length a under the pressure p between end moments M, for E = 1. */
static double wall(double a, double p, double M, double thickness)
{
    const double D = pow(thickness, 3) / 12;
    return (p * p * pow(a, 5) / 120 - p * M * pow(a, 3) / 6 + M * M * a) / D;
}

/* A rectangular frame with middle lines a and b under the pressure 2 q of G = kappa = 1: the shear
 * flow q = t A/s of the enclosed area and the middle lines' half length, and equal end rotations.
 */
static double frame(double a, double b, double thickness)
{
    const double p = 4 * thickness * a * b / (2 * (a + b));
    const double M = p * (pow(a, 3) + pow(b, 3)) / (12 * (a + b));
    return 2 * (wall(a, p, M, thickness) + wall(b, p, M, thickness));
}

/* Corners are t/a stiffer than middle lines that meet there; two thicknesses take that out. */
static void frames(void)
{
    for (int i = 0; i < 2; i++) {
        const double a = 1, b = random_real(0.3, 1);
        double ratio[2];
        for (int k = 0; k < 2; k++) {
            const double t = (k ? 0.01 : 0.02) * b;
            ratio[k] = bending_of(hollow(a + t, b + t, t)) / frame(a, b, t);
        }
        check_absolute(ratio[1], 1, 0.02, "a thin frame, b = %g", b);
        check_absolute(2 * ratio[1] - ratio[0], 1, 4e-3, "a thinner frame, b = %g", b);
    }
}

static void place_on_circle(int corners, double radius, double (*point)[2])
{
    for (int i = 0; i < corners; i++) {
        point[i][0] = radius * cos(2 * M_PI * i / corners);
        point[i][1] = radius * sin(2 * M_PI * i / corners);
    }
}

/* A ring under pressure is only compressed: c = 8 pi R^5 t, to (t/R)^2 and the ripple of its
 * corners; in closed form it is left out. */
static void rings(void)
{
    enum { CORNERS = 64 };
    const double R = random_real(0.5, 2), t = 0.05 * R;
    const int loops[] = {CORNERS, CORNERS};
    double point[2 * CORNERS][2];
    struct hobe_error err;
    place_on_circle(CORNERS, R + t / 2, point);
    place_on_circle(CORNERS, R - t / 2, point + CORNERS);
    const double c =
        bending_of(made(hobe_section_polygon(2, loops, (const double(*)[2])point, &err), &err));
    check_relative(c, 8 * M_PI * pow(R, 5) * t, 0.01, "a ring");
    check_absolute(bending_of(made(hobe_section_tube(R + t / 2, R - t / 2, &err), &err)), 0, 0,
                   "a tube");
    check_absolute(bending_of(rectangle(1, 0.1)), 0, 0, "a rectangle");
}

/* Turned by any angle about any origin: on other meshes. */
static void angles(void)
{
    const int loops[] = {4, 4};
    for (int i = 0; i < 2; i++) {
        const double width = 1, height = random_real(0.3, 1), t = random_real(0.02, 0.1) * height;
        const double angle = random_real(0, 2 * M_PI), c = cos(angle), s = sin(angle);
        double point[8][2];
        struct hobe_error err;
        for (int k = 0; k < 8; k++) {
            const double y = (k % 4 == 0 || k % 4 == 3 ? -1 : 1) * (width / 2 - (k < 4 ? 0 : t));
            const double z = (k % 4 < 2 ? -1 : 1) * (height / 2 - (k < 4 ? 0 : t));
            point[k][0] = 3 + c * y - s * z;
            point[k][1] = 2 + s * y + c * z;
        }
        check_relative(
            bending_of(made(hobe_section_polygon(2, loops, (const double(*)[2])point, &err), &err)),
            bending_of(hollow(width, height, t)), 2e-3, "turned by %g", angle);
    }
}

/* A frame about a core next to nothing, of another material; lengths go with the sixth power. */
static void weights(void)
{
    const struct hobe_material solid = {1, NU, 0, 1, 1, 0}, nothing = {1e-8, NU, 0, 1, 1, 0};
    struct hobe_error err;
    hobe_section *frame = hollow(0.3, 0.2, 0.02), *core = rectangle(0.26, 0.16);
    const struct hobe_section_part parts[] = {{frame, {0, 0}, solid}, {core, {0, 0}, nothing}};
    const double both = bending_of(made(hobe_section_composite(2, parts, &err), &err));
    const double alone = bending_of(frame);
    hobe_section_free(core);
    check_relative(both, alone, 1e-3, "a soft core, and another mesh");
    check_relative(bending_of(hollow(3, 2, 0.2)), 1e6 * alone, 1e-6, "ten times as large");
}

/* ---- beams ---------------------------------------------------------------------------------- */

struct bar {
    const char *element;
    hobe_section *section; /* freed */
    double E, torque;
    hobe_function *twist; /* of the reference; NULL: straight */
};

/* A straight axis of 2 m whose section turns. */
static hobe_curve *turning(hobe_function *twist)
{
    static const double ends[2][3] = {{0, 0, 0}, {2, 0, 0}};
    struct hobe_error err;
    hobe_curve *curve = hobe_curve_points(2, ends, &err);
    if (!curve || hobe_curve_twist(curve, twist, NULL, &err))
        check_stop("%s", err.message);
    return curve;
}

struct told {
    struct hobe_wall_bending is;
    enum hobe_warning warning;
    char text[600];
};

/* What there is to tell of a cantilever of 2 m that may warp under an end moment. */
static struct told tell(const struct bar *bar)
{
    struct told told;
    struct hobe_wall_bending none;
    struct hobe_error err;
    struct hobe_beam beam = beam_along_x(bar->element, 4, bar->section, bar->E, NU, 2);
    hobe_curve *curve = bar->twist ? turning(bar->twist) : NULL;
    beam.curve = curve;
    hobe_model *model = cantilever(&beam, 1);
    add_moment(model, "beam", 1, bar->torque, 0, 0);
    hobe_solution *solution = solve(model, 1);
    if (hobe_solution_wall_bending(solution, "beam", &told.is, &err) ||
        hobe_solution_warning(solution, "beam", &told.warning, told.text, sizeof told.text, &err))
        check_stop("%s", err.message);
    check_that(hobe_solution_wall_bending(solution, "bean", &none, &err) == HOBE_UNKNOWN &&
                   strstr(err.message, "bean"),
               "a beam that is not there");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_curve_free(curve);
    hobe_section_free(bar->section);
    return told;
}

/* Converged quadratic bricks with a clamped face, E = 1 GPa, 2 m long.  A box of 250 x 50 x 5 mm
 * has its greatest torque at 0.200 kN m; a hollow section of 160 x 80 x 10 mm twists by 0.5034(10)
 * at 1 kN m, which is 1.7(2) % more than linearly.  The estimate knows no clamped end and no wall
 * that bends far. */
static void solids(void)
{
    const struct told box = tell(&(struct bar){"MGD30w", hollow(.25, .05, .005), 1e9, 150, NULL});
    const struct told tube = tell(&(struct bar){"MGD30w", hollow(.16, .08, .01), 1e9, 1e3, NULL});
    check_relative(box.is.limit_torque, 200, 0.03, "limit torque of the box");
    check_absolute(tube.is.loss, 0.017, 0.003, "loss of the hollow section");
    check_that(tube.warning == HOBE_WARNING_NONE && !tube.text[0], "which is no warning");
    printf("%s\n", box.text);
}

/* The loss and the limit torque are those of T = G J kappa + (E Wagner/2 - 2 C) kappa^3, whose
 * coefficients are taken from the section.  The twist rate is the beam's, with what its ends do. */
static void cubic(const char *element)
{
    const double E = random_real(1e9, 2e11), G = E / 2 / (1 + NU), torque = -E * 1e-7;
    hobe_section *box = hollow(.25, .05, .005);
    const struct hobe_section_properties p = properties_of(box);
    const double C = bending_of(box) * (1 - NU * NU) * G * G / E;
    const struct told told = tell(&(struct bar){element, hollow(.25, .05, .005), E, torque, NULL});
    const double kappa = told.is.twist_rate, linear = G * p.J, third = E * p.Wagner / 2 - 2 * C;
    const double top = sqrt(-linear / (3 * third)),
                 here = linear + E * p.Wagner / 2 * kappa * kappa;
    check_relative(told.is.torque, torque, 1e-6, "%s: torque", element);
    check_relative(here * kappa, torque, 5e-3, "%s: twist rate", element);
    check_relative(told.is.loss, 2 * C * kappa * kappa / here, 1e-10, "%s: loss", element);
    check_relative(told.is.limit_torque, linear * top + third * pow(top, 3), 1e-10, "%s: limit",
                   element);
}

static void levels(void)
{
    static const struct {
        const char *element;
        double torque;
        enum hobe_warning warning;
    } boxes[] = {{"MGD30w", 20, HOBE_WARNING_NONE},        {"MGD30w", 150, HOBE_WARNING_BENDS},
                 {"MGD30w", -800, HOBE_WARNING_COLLAPSED}, {"3333s", 150, HOBE_WARNING_BENDS},
                 {"MGD30d", 150, HOBE_WARNING_NONE},       {"MGD30d", 250, HOBE_WARNING_COLLAPSED}};
    static const double square[4][2] = {{0, 0}, {.1, 0}, {.1, .1}, {0, .1}};
    struct hobe_error err;
    for (size_t i = 0; i < sizeof boxes / sizeof *boxes; i++) {
        const struct told told = tell(
            &(struct bar){boxes[i].element, hollow(.25, .05, .005), 1e9, boxes[i].torque, NULL});
        check_that(told.warning == boxes[i].warning, "%s at %g N m: %s", boxes[i].element,
                   boxes[i].torque, told.text);
        check_that(!told.text[0] == !told.warning && strlen(told.text) < sizeof told.text - 1,
                   "a sentence where there is a warning, and all of it");
    }
    const struct told solid = tell(
        &(struct bar){"MGD30w", made(hobe_section_polygon(1, (const int[]){4}, square, &err), &err),
                      1e9, 2000, NULL});
    check_that(solid.warning == HOBE_WARNING_NONE, "a solid section: %s", solid.text);
}

static enum hobe_status helix(void *context, double t, double *angle, struct hobe_error *err)
{
    (void)context;
    (void)err;
    *angle = t;
    return HOBE_OK;
}

/* A twist of the reference is none; it strains nothing.  A taper has walls, too. */
static void references(void)
{
    const struct told turned =
        tell(&(struct bar){"MGD30w", hollow(.25, .05, .005), 1e9, 1e-3, helix});
    const struct told tapering = tell(&(struct bar){
        "MGD30w", tapered(hollow(.25, .05, .005), hollow(.25, .0501, .005)), 1e9, 150, NULL});
    const struct told even = tell(&(struct bar){"MGD30w", hollow(.25, .05, .005), 1e9, 150, NULL});
    check_that(fabs(turned.is.twist_rate) < 1e-5 && turned.is.loss < 1e-9, "a helix at rest");
    check_relative(tapering.is.limit_torque, even.is.limit_torque, 5e-3, "hardly a taper");
    check_that(tapering.is.loss > 0.07 && !tapering.warning, "tapers are told of when asked");
}

int main(void)
{
    static const char *const elements[] = {"BE24w", "3333w", "MGD30w", "MGD30w3", "3333s"};
    hobe_section *box = hollow(.25, .05, .005); /* that of most bars: solved once for all of them */
    random_start();
    frames();
    rings();
    angles();
    weights();
    solids();
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++)
        cubic(elements[i]);
    levels();
    references();
    hobe_section_free(box);
    return check_report();
}
