/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams on curves: against straight ones, curved-beam theory, and themselves turned in space. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <string.h>

static const double E = 210e9, NU = 0.3;

/* A quarter of a circle from the origin, along X at first, to {R, R, 0}; all turned by `turn`. */
struct quarter {
    double R, turn[3][3];
};

static void rotate(const double turn[3][3], const double a[3], double b[3])
{
    for (int i = 0; i < 3; i++)
        b[i] = turn[0][i] * a[0] + turn[1][i] * a[1] + turn[2][i] * a[2];
}

static enum hobe_status quarter_point(void *context, double t, double *r, struct hobe_error *err)
{
    const struct quarter *q = context;
    const double a = M_PI / 2 * t;
    (void)err;
    rotate(q->turn, (const double[3]){q->R * sin(a), q->R * (1 - cos(a)), 0}, r);
    return HOBE_OK;
}

static enum hobe_status constant(void *context, double at, double *phi, struct hobe_error *err)
{
    (void)at, (void)err;
    *phi = *(const double *)context;
    return HOBE_OK;
}

static hobe_curve *must(hobe_curve *curve, const struct hobe_error *err)
{
    return curve ? curve : (check_stop("%s", err->message), NULL);
}

static struct hobe_point loaded_tip(const struct hobe_beam *beam, const double F[3], int steps)
{
    hobe_model *model = cantilever(beam, 1); /* free to warp, as in Saint-Venant's torsion */
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    return tip_of(model, steps);
}

/* On a line that is called a curve, and with width and height exchanged by a quarter turn of the
 * section: the same beam, but for rounding, which the condition of a slender beam's stiffness
 * (1e6) enlarges. */
static void test_line(void)
{
    const double line[2][3] = {{0, 0, 0}, {1, 0, 0}}, F[3] = {100, 200, -300};
    const double quarter_turn = M_PI / 2;
    struct hobe_error err = {0};
    hobe_section *flat = rectangle(0.03, 0.02), *upright = rectangle(0.02, 0.03);
    struct hobe_beam beam = beam_along_x("MGD30w", 4, flat, E, NU, 1);
    const struct hobe_point straight = loaded_tip(&beam, F, 2);
    hobe_curve *curve = must(hobe_curve_points(2, line, &err), &err);
    beam.curve = curve;
    const struct hobe_point curved = loaded_tip(&beam, F, 2);
    check_that(!hobe_curve_twist(curve, constant, (void *)&quarter_turn, &err), "%s", err.message);
    beam.section = upright;
    const struct hobe_point turned = loaded_tip(&beam, F, 2);
    check_absolute(distance(curved.u, straight.u), 0, 1e-9 * norm(straight.u), "a line");
    check_absolute(distance(turned.u, straight.u), 0, 1e-9 * norm(straight.u), "a quarter turn");
    hobe_curve_free(curve);
    hobe_section_free(flat);
    hobe_section_free(upright);
}

/* Castigliano's theorem for a thin quarter of a circle.  Shear, stretch and what the curvature does
 * to the section are of the order of (thickness/R)^2 = 1e-4, and so is the error of 16 elements. */
static void test_theory(void)
{
    struct quarter q = {2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    struct hobe_error err = {0};
    hobe_section *section = rectangle(0.02, 0.02);
    const struct hobe_section_properties p = properties_of(section);
    const double G = E / (2 * (1 + NU)), P = 1e-3, unit = P * q.R * q.R * q.R;
    hobe_curve *curve = must(hobe_curve_function(quarter_point, &q, &err), &err);
    struct hobe_beam beam = beam_along_x("MGD30w", 16, section, E, NU, 0);
    beam.curve = curve;
    const struct hobe_point in = loaded_tip(&beam, (const double[3]){0, P, 0}, 1);
    const struct hobe_point out = loaded_tip(&beam, (const double[3]){0, 0, P}, 1);
    const double ring = 3 * M_PI / 4 - 2;
    check_relative(in.u[1], unit / (E * p.Izz) * ring, 3e-4, "in the plane");
    check_relative(in.u[0], -unit / (E * p.Izz) / 2, 3e-4, "in the plane, across the load");
    check_relative(out.u[2], unit * (M_PI / 4 / (E * p.Iyy) + ring / (G * p.J)), 3e-4,
                   "out of the plane, with torsion");
    hobe_curve_free(curve);
    hobe_section_free(section);
}

/* Curve, up and load turned alike: everything turns, at large displacements. */
static void test_turned(void)
{
    hobe_section *section = rectangle(0.02, 0.05);
    const double F[3] = {1000, -2000, 1500}, phi = random_real(-1, 1);
    struct hobe_point tip[2];
    struct quarter q = {2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int i = 0; i < 2; i++) {
        struct hobe_error err = {0};
        double load[3];
        struct hobe_beam beam = beam_along_x("MGD30w", 6, section, E, NU, 0);
        hobe_curve *curve = must(hobe_curve_function(quarter_point, &q, &err), &err);
        check_that(!hobe_curve_twist(curve, constant, (void *)&phi, &err), "%s", err.message);
        beam.curve = curve;
        memcpy(beam.up, q.turn[2], sizeof beam.up);
        rotate(q.turn, F, load);
        tip[i] = loaded_tip(&beam, load, 3);
        hobe_curve_free(curve);
        if (i == 0) {
            double *e = q.turn[0], *f = q.turn[1], *g = q.turn[2], up[3];
            random_direction(e);
            random_direction(up);
            for (int a = 0; a < 3; a++)
                g[a] = e[(a + 1) % 3] * up[(a + 2) % 3] - e[(a + 2) % 3] * up[(a + 1) % 3];
            const double length = norm(g);
            for (int a = 0; a < 3; a++)
                g[a] /= length;
            for (int a = 0; a < 3; a++)
                f[a] = g[(a + 1) % 3] * e[(a + 2) % 3] - g[(a + 2) % 3] * e[(a + 1) % 3];
        }
    }
    double expected[3];
    rotate(q.turn, tip[0].u, expected);
    check_that(norm(expected) > 0.5, "a large displacement: %g m", norm(expected));
    check_absolute(distance(tip[1].u, expected), 0, 1e-9 * norm(expected), "the turned tip");
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    test_line();
    test_theory();
    for (int i = 0; i < 3; i++)
        test_turned();
    return check_report();
}
