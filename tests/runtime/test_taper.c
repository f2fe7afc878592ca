/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams that taper: bars, cantilevers and shafts against closed forms and quadrature, one element
 * against Galerkin's method by hand; mass; and d/dx of the section functions.  Looks into the core
 * (section.h) for the last. */
#include "check.h"
#include "rod.h"
#include "scene.h"
#include "section.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 70e9, L = 2;

/* ---- the theory ------------------------------------------------------------------------------ */

/* A rectangle whose sides go linearly from one end to the other. */
struct ends {
    double width[2], height[2];
};

static double between(const double end[2], double t)
{
    return end[0] + t * (end[1] - end[0]);
}

static double torsion_constant(double width, double height)
{
    hobe_section *section = rectangle(width, height);
    const double J = properties_of(section).J;
    hobe_section_free(section);
    return J;
}

enum stiffness { STRETCH, BENDING, TORSION };

/* EA, EIyy, GJ at a place, nu = 0. */
static double stiffness_at(const struct ends *ends, enum stiffness kind, double t)
{
    const double W = between(ends->width, t), H = between(ends->height, t);
    return kind == STRETCH   ? E * W * H
           : kind == BENDING ? E * W * H * H * H / 12
                             : E / 2 * torsion_constant(W, H);
}

/* The end's motion under a unit load there: int m^2/k dx with m = 1, for bending the arm; Gauss. */
static double exact_compliance(const struct ends *ends, enum stiffness kind)
{
    double gauss[32][2], sum = 0;
    hobe_gauss(32, gauss, NULL);
    for (int g = 0; g < 32; g++) {
        const double arm = kind == BENDING ? L * (1 - gauss[g][0]) : 1;
        sum += L * gauss[g][1] * arm * arm / stiffness_at(ends, kind, gauss[g][0]);
    }
    return sum;
}

/* The same where the strain can only be a + b x (terms 2) or a + b x + c x^2 (terms 3): the largest
 * b'G^-1 b with G = int k p p' dx, b = int m p dx, p the monomials; by elimination. */
static double galerkin_compliance(const struct ends *ends, enum stiffness kind, int terms)
{
    double gauss[32][2], G[3][4] = {{0}}, sum = 0;
    hobe_gauss(32, gauss, NULL);
    for (int g = 0; g < 32; g++) {
        const double t = gauss[g][0], weight = L * gauss[g][1];
        const double k = stiffness_at(ends, kind, t), arm = kind == BENDING ? L * (1 - t) : 1;
        for (int i = 0; i < terms; i++) {
            for (int j = 0; j < terms; j++)
                G[i][j] += weight * k * pow(t, i + j);
            G[i][3] += weight * arm * pow(t, i);
        }
    }
    for (int i = 0; i < terms; i++) {
        sum += G[i][3] * G[i][3] / G[i][i]; /* b'G^-1 b = sum of squares of L^-1 b over pivots */
        for (int j = i + 1; j < terms; j++) {
            const double factor = G[j][i] / G[i][i];
            for (int c = i; c < 4; c++)
                G[j][c] -= factor * G[i][c];
        }
    }
    return sum;
}

/* ---- the beams ------------------------------------------------------------------------------- */

/* The end's motion under a load so small that its square does not matter, over the load. */
static double compliance(const char *element, int elements, const struct ends *ends,
                         enum stiffness kind)
{
    hobe_section *section = tapered(rectangle(ends->width[0], ends->height[0]),
                                    rectangle(ends->width[1], ends->height[1]));
    const struct hobe_beam beam = beam_along_x(element, elements, section, E, 0, L);
    hobe_model *model = cantilever(&beam, 1);
    const double load = 1e-8 / exact_compliance(ends, kind); /* 1e-8 m or rad */
    if (kind == TORSION)
        add_moment(model, "beam", 1, load, 0, 0);
    else
        add_force(model, "beam", 1, kind == STRETCH ? load : 0, 0, kind == BENDING ? load : 0);
    const struct hobe_point tip = tip_of(model, 1);
    hobe_section_free(section);
    return (kind == TORSION ? tip.twist : tip.u[kind == BENDING ? 2 : 0]) / load;
}

/* Compliances of 1, 2, 4, 8 elements: one is Galerkin's to `floor`, where theory ends, and
 * until there the error falls like (1/n)^order. */
static void converges(const char *element, const struct ends *ends, enum stiffness kind, int terms,
                      int order, double floor)
{
    static const char *const names[] = {"stretch", "bending", "torsion"};
    const double exact = exact_compliance(ends, kind);
    double error[4];
    for (int i = 0; i < 4; i++) {
        const double found = compliance(element, 1 << i, ends, kind);
        error[i] = found / exact - 1;
        if (i == 0)
            check_relative(found, galerkin_compliance(ends, kind, terms), floor,
                           "%s, one element, %s", element, names[kind]);
    }
    printf("%-7s %s: off by %9.2e %9.2e %9.2e %9.2e\n", element, names[kind], error[0], error[1],
           error[2], error[3]);
    for (int i = 2; i < 4; i++) {
        const double seen = log2(error[i - 1] / error[i]);
        check_that(fabs(error[i]) < floor || fabs(seen - order) < 0.6,
                   "%s, %s: order %.2f at n = %d, expected %d", element, names[kind], seen, 1 << i,
                   order);
    }
}

/* A bar of constant height: u = P L ln(A1/A0)/(E (A1 - A0)).  One element's strain is a polynomial
 * of its degree less one, and its end is as Galerkin has it; the end's error has the square of the
 * strain's order.  Small
 * strain leaves 1e-8. */
static void bars(void)
{
    const struct ends ends = {{0.1, 0.05}, {0.1, 0.1}};
    check_relative(exact_compliance(&ends, STRETCH), L * log(0.5) / (E * (0.005 - 0.01)), 1e-13,
                   "quadrature of a bar");
    converges("3333", &ends, STRETCH, 2, 4, 5e-8);
    converges("BE24", &ends, STRETCH, 3, 6, 5e-8);
    converges("3433", &ends, STRETCH, 3, 6, 5e-8);
}

/* Slender: shear adds (H/L)^2.  Without it the slope of the section is that of the cubic
 * centreline, and the curvature linear, even where the section's own may be more. */
static void cantilevers(void)
{
    const struct ends thin = {{0.01, 0.01}, {0.004, 0.002}};
    converges("MGD30", &thin, BENDING, 2, 4, 1e-5);
    converges("3433", &thin, BENDING, 2, 4, 1e-5);
}

/* Twist of a slender shaft.  The warping that grows along it, and w_x, add (H/L)^2. */
static void shafts(void)
{
    const struct ends thin = {{0.02, 0.01}, {0.01, 0.02}}, flat = {{0.02, 0.02}, {0.01, 0.005}};
    converges("MGD30w", &thin, TORSION, 2, 4, 4e-5);
    converges("MGD30w", &flat, TORSION, 2, 4, 4e-5);
}

/* ---- Timoshenko's beam, exactly -------------------------------------------------------------- */

static void tapered_place(const void *context, double t, struct rod_place *place)
{
    const struct ends *ends = context;
    const double W = between(ends->width, t), H = between(ends->height, t), A = W * H;
    *place = (struct rod_place){
        .r = {t * L},
        .frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        .force = {E * A, E / 2 * A, E / 2 * A},
        .moment = {stiffness_at(ends, TORSION, t), E * A * H * H / 12, E * A * W * W / 12}};
}

/* A stocky cantilever about both axes: planar sections (nu = 0, k = 1) are Timoshenko's. */
static void stocky(void)
{
    const struct ends ends = {{0.2, 0.3}, {0.4, 0.1}};
    const struct rod rod = {tapered_place, &ends, L};
    const double end[3] = {L, 0, 0}, F[3] = {0.3, 0.1, 0.2}, none[3] = {0};
    struct rod_tip expected = {{0}, {0}};
    hobe_section *section = tapered(rectangle(0.2, 0.4), rectangle(0.3, 0.1));
    const struct hobe_beam beam = beam_along_x("3433", 64, section, E, 0, L);
    hobe_model *model = cantilever(&beam, 0);
    rod_add(&rod, end, F, none, &expected);
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    const struct hobe_point tip = tip_of(model, 1);
    for (int a = 0; a < 3; a++) /* F_x L^2/EI, which stiffens, is 1e-6; a tenth of it is left */
        check_absolute(tip.u[a], expected.u[a], 1e-7 * norm(expected.u), "stocky: u[%d]", a);
    check_relative(tip.rotation[1], expected.rotation[1], 1e-7, "stocky: about y");
    check_relative(tip.rotation[2], expected.rotation[2], 1e-7, "stocky: about z");
    hobe_section_free(section);
}

static hobe_section *circle(double radius)
{
    struct hobe_error err;
    hobe_section *section = hobe_section_circle(radius, &err);
    return section ? section : (check_stop("%s", err.message), NULL);
}

static hobe_section *tube(double outer, double inner)
{
    struct hobe_error err;
    hobe_section *section = hobe_section_tube(outer, inner, &err);
    return section ? section : (check_stop("%s", err.message), NULL);
}

/* A cone: 4 P L^3/(3 E pi r0^3 r1) of bending and P L/(G pi r0 r1) of shear. */
static void cone(void)
{
    const double r0 = 0.2, r1 = 0.1, P = 100;
    hobe_section *section = tapered(circle(r0), circle(r1));
    const struct hobe_beam beam = beam_along_x("3433", 64, section, E, 0, L);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, P);
    check_relative(tip_of(model, 1).u[2],
                   4 * P * L * L * L / (3 * E * M_PI * r0 * r0 * r0 * r1) +
                       P * L / (E / 2 * M_PI * r0 * r1),
                   1e-6, "cone");
    hobe_section_free(section);
}

/* ---- mass ------------------------------------------------------------------------------------ */

static void mass(hobe_section *section, double volume, const char *what)
{
    static const char *const names[] = {"MGD30w", "3333", "3433"};
    const double rho = 7850;
    for (int i = 0; i < 3; i++) {
        struct hobe_beam beam = beam_along_x(names[i], 1 + 2 * i, section, E, 0.3, L);
        beam.material.rho = rho;
        hobe_model *model = cantilever(&beam, 0);
        hobe_modes *modes = modes_of(model, NULL, 1, HOBE_MODAL_AUTO);
        check_relative(modes_info(modes).mass, rho * volume, 1e-12, "%s: mass of a %s", names[i],
                       what);
        hobe_modes_free(modes);
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

static void masses(void)
{
    const double a = 0.1, b = 0.2, c = 0.3, d = 0.05; /* widths a to b, heights c to d */
    mass(tapered(rectangle(a, c), rectangle(b, d)), L * (2 * a * c + a * d + b * c + 2 * b * d) / 6,
         "wedge");
    mass(tapered(circle(a), circle(b)), L * M_PI * (a * a + a * b + b * b) / 3, "cone");
    mass(tapered(tube(b, a), tube(c, d)),
         L * M_PI * (b * b + b * c + c * c - a * a - a * d - d * d) / 3, "hollow cone");
}

/* ---- d/dx of the section functions ----------------------------------------------------------- */

typedef hobe_section *section_at(double x);

static hobe_section *crossing(double x) /* wider than high before x = 1, higher than wide after */
{
    return rectangle(0.2 - 0.05 * x, 0.1 + 0.05 * x);
}

static hobe_section *narrowing(double x)
{
    return tube(0.2 - 0.02 * x, 0.1 - 0.03 * x);
}

static double value(section_at *make, const char *name, double x, double y, double z)
{
    double f[3];
    struct hobe_error err;
    hobe_section *section = make(x);
    if (hobe_section_function(section, name, y, z, f, &err))
        check_stop("%s", err.message);
    hobe_section_free(section);
    return f[0];
}

/* f_x of the taper against a difference of sections made by hand, of fourth order. */
static void rates(section_at *make, double at, double size, const char *what)
{
    const double x = at * L, h = 1e-3 * L, y = random_real(0.3, 0.45) * size;
    const double z = random_real(0.3, 0.45) * size;
    const struct hobe_section_place place = {at, L}, twice = {at, 2 * L};
    const struct hobe_kernel *kernel = hobe_find_kernel("MGD30w3", NULL);
    hobe_section *taper = tapered(make(0), make(L));
    double f[HOBE_MAX_FUNCTIONS][4] = {{0}}, g[HOBE_MAX_FUNCTIONS][4] = {{0}};
    struct hobe_error err;
    check_that(!hobe_section_functions_at(taper, kernel, &place, y, z, f, &err) &&
                   !hobe_section_functions_at(taper, kernel, &twice, y, z, g, &err),
               "%s: %s", what, err.message);
    for (int i = 0; i < kernel->functions; i++) {
        const char *name = kernel->function[i];
        if (make == narrowing && i == 0)
            continue; /* a tube has no w */
        const double rate =
            (8 * (value(make, name, x + h, y, z) - value(make, name, x - h, y, z)) -
             value(make, name, x + 2 * h, y, z) + value(make, name, x - 2 * h, y, z)) /
            (12 * h);
        check_absolute(f[i][0], value(make, name, x, y, z), 1e-12 * size * size, "%s: %s", what,
                       name);
        check_relative(f[i][3], rate, 1e-7, "%s: d%s/dx at %g", what, name, at);
        check_relative(g[i][3], f[i][3] / 2, 1e-12, "%s: on twice the length", what);
    }
    hobe_section_free(taper);
}

int main(void)
{
    random_start();
    bars();
    cantilevers();
    shafts();
    stocky();
    cone();
    masses();
    for (int i = 0; i < 8; i++) {
        const double at = i ? random_real(0.05, 0.95) : 0.5; /* 0.5: a square */
        rates(crossing, at, 0.1, "rectangle");
        rates(narrowing, at, 0.3, "tube");
    }
    return check_report();
}
