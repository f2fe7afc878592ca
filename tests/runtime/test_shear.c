/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bending shear: the functions wy and wz, the shear factors they give, and short cantilevers that
 * deflect by them; shear factors that act on the average strain and leave torsion alone.  Looks
 * into the core (section.h). */
#include "check.h"
#include "hobe.h"
#include "scene.h"
#include "section.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 210e9, NU = 0.3;
static const struct hobe_profile_sizes SIZES = {
    .height = .215, .width = .1, .flange = .015, .web = .01};

static double shear_modulus(void)
{
    return E / (2 * (1 + NU));
}

/* The section, or the end of the test. */
static hobe_section *must(hobe_section *section, const struct hobe_error *err)
{
    if (!section)
        check_stop("%s", err->message);
    return section;
}

static hobe_section *profile(enum hobe_profile kind, enum hobe_warping warping)
{
    struct hobe_error err;
    return must(hobe_section_profile(kind, &SIZES, warping, &err), &err);
}

static hobe_section *circle(double radius)
{
    struct hobe_error err;
    return must(hobe_section_circle(radius, &err), &err);
}

static hobe_section *tube(double outer, double inner)
{
    struct hobe_error err;
    return must(hobe_section_tube(outer, inner, &err), &err);
}

static hobe_section *solved_rectangle(double width, double height)
{
    struct hobe_error err;
    return must(hobe_section_rectangle(width, height, HOBE_WARPING_SOLVED, &err), &err);
}

static hobe_section *hollow(double width, double height, double wall)
{
    struct hobe_error err;
    return must(hobe_section_hollow(width, height, wall, HOBE_WARPING_SOLVED, &err), &err);
}

/* ---- the factors ---------------------------------------------------------------------------- */

static void factors(hobe_section *section, double ky, double kz, double tolerance)
{
    const struct hobe_section_properties p = properties_of(section);
    check_relative(p.ky, ky, tolerance, "ky, %s", hobe_section_text(section));
    check_relative(p.kz, kz, tolerance, "kz, %s", hobe_section_text(section));
    check_absolute(p.kyz, 0, tolerance, "kyz, %s", hobe_section_text(section));
    hobe_section_free(section);
}

/* int tau^2 of a tube's psi = (a r + b r^3 + c/r) cos t, from ri = r to ro = 1, int y psi dA:
 * pi (a (1 - r^4)/4 + b (1 - r^6)/6 + c (1 - r^2)/2). */
static double tube_factor(double r)
{
    const double a = 3. / 8 * (1 + r * r), b = -1. / 8, c = 3. / 8 * r * r;
    const double A = M_PI * (1 - r * r), I = M_PI / 4 * (1 - pow(r, 4));
    return I * I /
           (A * M_PI * (a * (1 - pow(r, 4)) / 4 + b * (1 - pow(r, 6)) / 6 + c * (1 - r * r) / 2));
}

static void closed_forms(void)
{
    const double bore[] = {.9, .5, .01, 1e-4};
    factors(rectangle(.1, .2), 5. / 6, 5. / 6, 1e-12);
    factors(rectangle(.02, .2), 5. / 6, 5. / 6, 1e-12);
    factors(circle(.05), 6. / 7, 6. / 7, 1e-12);
    check_absolute(tube_factor(.9), .502, 5e-4, "three digits of a thin tube");
    for (int i = 0; i < 4; i++)
        factors(tube(.05, .05 * bore[i]), tube_factor(bore[i]), tube_factor(bore[i]), 1e-12);
}

/* A polygon of n points on two circles. */
static hobe_section *many_sided(double outer, double inner, int n)
{
    double point[200][2];
    struct hobe_error err;
    for (int i = 0; i < 2 * n; i++) {
        const double r = i < n ? outer : inner, angle = 2 * M_PI * i / n;
        point[i][0] = r * cos(angle);
        point[i][1] = r * sin(angle);
    }
    return must(hobe_section_polygon(2, (const int[]){n, n}, (const double(*)[2])point, &err),
                &err);
}

/* The finite elements against the closed forms.  Along a thin wall they hold the cubic across it to
 * 1e-4; a polygon of 100 points differs from its circle by
 * some (2 pi/100)^2/3 in A and I. */
static void solved_factors(void)
{
    const double k = tube_factor(.6);
    factors(solved_rectangle(.1, .2), 5. / 6, 5. / 6, 2e-5);
    factors(solved_rectangle(.1, .02), 5. / 6, 5. / 6, 2e-4);
    factors(many_sided(.05, .03, 100), k, k, 2e-3);
}

/* Turned by an angle the compliances 1/ky, kyz, 1/kz turn as a tensor. */
static void factors_turn(void)
{
    enum { N = 6 };
    static const double corner[N][2] = {{0, 0},      {.1, 0},   {.1, .015},
                                        {.01, .015}, {.01, .2}, {0, .2}};
    const double t = random_real(.1, 1.4), c = cos(t), s = sin(t);
    double point[N][2];
    struct hobe_error err;
    for (int i = 0; i < N; i++) {
        point[i][0] = c * corner[i][0] - s * corner[i][1];
        point[i][1] = s * corner[i][0] + c * corner[i][1];
    }
    hobe_section *straight = must(hobe_section_polygon(1, (const int[]){N}, corner, &err), &err);
    hobe_section *turned =
        must(hobe_section_polygon(1, (const int[]){N}, (const double(*)[2])point, &err), &err);
    const struct hobe_section_properties p = properties_of(straight), q = properties_of(turned);
    const double yy = 1 / p.ky, zz = 1 / p.kz, yz = p.kyz;
    /* two meshes, each within 2e-5 */
    check_relative(1 / q.ky, c * c * yy + s * s * zz - 2 * s * c * yz, 1e-4, "ky turned by %g", t);
    check_relative(1 / q.kz, s * s * yy + c * c * zz + 2 * s * c * yz, 1e-4, "kz turned by %g", t);
    check_absolute(q.kyz, s * c * (yy - zz) + (c * c - s * s) * yz, 1e-4 * (yy + zz),
                   "kyz turned by %g", t);
    hobe_section_free(straight);
    hobe_section_free(turned);
}

/* ---- the functions -------------------------------------------------------------------------- */

/* wy along a rectangle's width and a circle's diameter, by hand. */
static void functions_by_hand(void)
{
    struct hobe_error err;
    hobe_section *sections[] = {rectangle(.2, .1), circle(.1)};
    for (int i = 0; i < 20; i++) {
        const double y = random_real(-.1, .1), a = .1;
        const double wy[] = {y * (a * a / 10 - y * y / 6), y * (a * a / 12 - y * y / 8)};
        const double slope[] = {a * a / 10 - y * y / 2, a * a / 12 - 3 * y * y / 8};
        for (int k = 0; k < 2; k++) {
            double f[3];
            check_that(!hobe_section_function(sections[k], "wy", y, 0, f, &err), "wy is known");
            check_absolute(f[0], wy[k], 1e-15 * a * a, "wy at %g, %s", y,
                           hobe_section_text(sections[k]));
            check_absolute(f[1], slope[k], 1e-14 * a * a, "its slope at %g", y);
            hobe_section_function(sections[k], "wz", 0, y, f, &err);
            if (k == 1)
                check_absolute(f[0], wy[k], 1e-15 * a * a, "wz of a circle at %g", y);
        }
    }
    hobe_section_free(sections[0]);
    hobe_section_free(sections[1]);
}

/* Gradients agree with differences of the values, and within a ring -div grad wy = y. */
static void differences(hobe_section *section, double y, double z)
{
    static const char *const names[] = {"wy", "wz"};
    const double h = 1e-4;
    struct hobe_error err;
    for (int k = 0; k < 2; k++) {
        double f[3], up[3], down[3], left[3], right[3];
        hobe_section_function(section, names[k], y, z, f, &err);
        hobe_section_function(section, names[k], y, z + h, up, &err);
        hobe_section_function(section, names[k], y, z - h, down, &err);
        hobe_section_function(section, names[k], y + h, z, left, &err);
        hobe_section_function(section, names[k], y - h, z, right, &err);
        /* second-order differences: h^2/6 times derivatives of c/r, 3/32 c/r^5 and less */
        check_absolute((left[0] - right[0]) / (2 * h), f[1], 1e-7, "d%s/dy", names[k]);
        check_absolute((up[0] - down[0]) / (2 * h), f[2], 1e-7, "d%s/dz", names[k]);
        check_absolute((left[1] - right[1] + up[2] - down[2]) / (2 * h), k ? -z : -y, 1e-6,
                       "div grad %s", names[k]);
    }
}

static void functions_of_a_tube(void)
{
    hobe_section *section = tube(1, .5);
    for (int i = 0; i < 20; i++) {
        const double r = random_real(.51, .99), t = random_real(0, 2 * M_PI);
        differences(section, r * cos(t), r * sin(t));
    }
    hobe_section_free(section);
}

/* With the values of w, wy and wz. */
static struct hobe_rule rule_of(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_rule rule;
    const struct hobe_kernel *kernel = hobe_find_kernel("MGD30w3", &err);
    if (hobe_section_rule(section, kernel, HOBE_INTEGRATION_EXACT, NULL, &rule, &err))
        check_stop("%s", err.message);
    return rule;
}

/* A block with a wide plate on top, aside; the block is the reference. */
static hobe_section *unsymmetric_composite(void)
{
    struct hobe_error err;
    hobe_section *block = rectangle(.1, .1), *plate = rectangle(.2, .03);
    const struct hobe_section_part part[] = {{block, {0, 0}, {E, NU, 0, 1, 1, 0}},
                                             {plate, {.02, .065}, {E / 3, NU, 0, 1, 1, 0}}};
    hobe_section *section = must(hobe_section_composite(2, part, &err), &err);
    hobe_section_free(block);
    hobe_section_free(plate);
    return section;
}

/* In int E ..dA each function is orthogonal to 1, y, z and those before it, to round-off. */
static void orthogonal(hobe_section *section)
{
    enum { FIRST = 3, ALL = FIRST + HOBE_SECTION_FUNCTIONS };
    struct hobe_rule rule = rule_of(section);
    double G[ALL][ALL] = {{0}};
    for (int p = 0; p < rule.rule.points; p++) {
        const struct hobe_section_point *at = rule.point + p;
        const double g[ALL] = {1, at->y, at->z, at->f[0][0], at->f[1][0], at->f[2][0]};
        for (int i = 0; i < ALL; i++)
            for (int j = 0; j < ALL; j++)
                G[i][j] += at->weight * hobe_section_E(section, at->region) * g[i] * g[j];
    }
    for (int i = FIRST; i < ALL; i++)
        for (int j = 0; j < i; j++)
            check_absolute(G[i][j], 0, 1e-12 * sqrt(G[i][i] * G[j][j]) + 1e-300,
                           "orthogonality %d %d, %s", i, j, hobe_section_text(section));
    hobe_rule_free(&rule);
    hobe_section_free(section);
}

static void functions_are_orthogonal(void)
{
    orthogonal(unsymmetric_composite());
    orthogonal(rectangle(.1, .2));
    orthogonal(circle(.05));
    orthogonal(tube(.05, .01));
    orthogonal(profile(HOBE_PROFILE_I, HOBE_WARPING_SOLVED));
    orthogonal(profile(HOBE_PROFILE_CHANNEL, HOBE_WARPING_SOLVED));
    orthogonal(profile(HOBE_PROFILE_ANGLE, HOBE_WARPING_SOLVED));
}

/* ---- beams ---------------------------------------------------------------------------------- */

/* Of the tip of a cantilever that may warp, for a force along y and one along z through the shear
 * centre: per unit of force, what its deflections along y and z are beyond bending's, m/N, and its
 * twist, 1/N.  The force acts on the axis with the moment that moves it. */
struct tip {
    double shear[2][2], twist[2];
};

static struct tip tip_under_force(const struct hobe_beam *beam)
{
    const struct hobe_section_properties p = properties_of(beam->section);
    const double L = beam->to[0], P = 1e-6 * E * fmin(p.Iyy, p.Izz) / (L * L);
    const double bend = L * L * L / (3 * E * (p.Iyy * p.Izz - p.Iyz * p.Iyz));
    const double bending[2][2] = {{bend * p.Iyy, -bend * p.Iyz}, {-bend * p.Iyz, bend * p.Izz}};
    struct tip tip;
    for (int k = 0; k < 2; k++) {
        hobe_model *model = cantilever(beam, 1);
        add_force(model, "beam", 1, 0, k == 0 ? P : 0, k == 1 ? P : 0);
        add_moment(model, "beam", 1, P * (k == 0 ? -p.zs : p.ys), 0, 0);
        const struct hobe_point point = tip_of(model, 1);
        tip.twist[k] = point.twist / P;
        for (int a = 0; a < 2; a++)
            tip.shear[k][a] = point.u[1 + a] / P - bending[k][a];
    }
    return tip;
}

/* int G dA; the reference of a composite section has G as all others. */
static double shear_stiffness(const hobe_section *section)
{
    struct hobe_rule rule = rule_of(section);
    double GA = 0;
    for (int p = 0; p < rule.rule.points; p++)
        GA += rule.point[p].weight * hobe_section_G(section, rule.point[p].region);
    hobe_rule_free(&rule);
    return shear_modulus() * GA;
}

/* The growth of the tip's shear with the beam's length is K/(G A), K = [1/ky kyz; kyz 1/kz], that
 * of its twist nothing.  The ends take their share, for a force on the axis is not the stress of
 * bending shear: the same in a beam twice as long, once their warping has decayed.  It has to 1e-6
 * but where thin walls that are open let it reach far. */
static void deflects(const char *element, hobe_section *section, int elements, double tolerance)
{
    const struct hobe_section_properties p = properties_of(section);
    const double L = 4 * fmax(p.width, p.height), GA = shear_stiffness(section);
    const double expected[2][2] = {{1 / p.ky, p.kyz}, {p.kyz, 1 / p.kz}};
    const struct hobe_beam beam = beam_along_x(element, elements, section, E, NU, L),
                           twice = beam_along_x(element, 2 * elements, section, E, NU, 2 * L);
    const struct tip near = tip_under_force(&beam), far = tip_under_force(&twice);
    printf("%-8s", element);
    for (int k = 0; k < 2; k++) {
        for (int a = 0; a < 2; a++) {
            const double K = (far.shear[k][a] - near.shear[k][a]) * GA / L;
            check_absolute(K, expected[k][a], tolerance / fmin(p.ky, p.kz), "K[%d][%d], %s, %s", k,
                           a, element, hobe_section_text(section));
            printf("  %.8f (%.8f)", K, expected[k][a]);
        }
        check_absolute((far.twist[k] - near.twist[k]) * GA * hypot(p.width, p.height) / L, 0,
                       tolerance, "no twist, %s", hobe_section_text(section));
    }
    printf("  %s\n", hobe_section_text(section));
    hobe_section_free(section);
}

static void beams_shear_as_their_sections(void)
{
    deflects("MGD30w3", rectangle(.1, .2), 4, 1e-6);
    deflects("MGD30w3", tube(.05, .045), 4, 1e-6);
    deflects("MGD30w3", circle(.05), 4, 1e-6);
    deflects("MGD30w3", profile(HOBE_PROFILE_I, HOBE_WARPING_SOLVED), 4, 1e-6);
    deflects("MGD30w3", hollow(.16, .08, .01), 4, 1e-5);
    deflects("MGD30w3", profile(HOBE_PROFILE_CHANNEL, HOBE_WARPING_SOLVED), 4, 5e-4);
    deflects("MGD30w3", profile(HOBE_PROFILE_ANGLE, HOBE_WARPING_SOLVED), 4, 5e-4);
    deflects("MGD30w3", unsymmetric_composite(), 4, 5e-4);
    /* a quadratic axis holds the cubic deflection by elements only */
    deflects("3333w3", rectangle(.1, .2), 16, 1e-2);
    deflects("3333w3", profile(HOBE_PROFILE_I, HOBE_WARPING_SOLVED), 16, 1e-2);
}

/* ---- factors on the average ----------------------------------------------------------------- */

/* With k = 1/2 on the average a beam without wy and wz is twice as soft in shear and as stiff in
 * torsion; at every point both are halved. */
static void average_factors(void)
{
    const double L = .4, k = .5;
    for (int average = 0; average < 2; average++)
        for (int w = 0; w < 2; w++) {
            hobe_section *section = rectangle(.1, .2);
            const struct hobe_section_properties p = properties_of(section);
            struct hobe_beam beam = beam_along_x(w ? "MGD30w" : "MGD30", 4, section, E, NU, L);
            beam.material.k2 = beam.material.k3 = k;
            beam.material.average_shear = average;
            const struct hobe_element_options options = {
                .kernel = beam.kernel, .section = section, .material = beam.material, .length = .1};
            double C[HOBE_STRAINS][HOBE_STRAINS];
            hobe_element *element = new_element(&options);
            check_that(!hobe_element_stiffness(element, C, NULL), "its stiffness");
            hobe_element_free(element);
            const struct tip tip = tip_under_force(&beam);
            hobe_section_free(section);
            for (int a = 0; a < 2; a++)
                check_relative(tip.shear[a][a] * shear_modulus() * p.A / L, 1 / k, 1e-7,
                               "shear along %c, %s", "yz"[a], beam.kernel->name);
            check_relative(C[HOBE_TWIST][HOBE_TWIST],
                           (average ? 1 : k) * shear_modulus() * (w ? p.J_w : p.Iyy + p.Izz), 1e-9,
                           "torsion, %s, k on the %s", beam.kernel->name,
                           average ? "average" : "points");
        }
}

/* ---- refusals ------------------------------------------------------------------------------- */

/* The paper integrates wy and wz where they are closed forms. */
static void paper_integration(void)
{
    struct hobe_error err;
    hobe_section *sections[] = {rectangle(.1, .2), profile(HOBE_PROFILE_I, HOBE_WARPING_SOLVED),
                                profile(HOBE_PROFILE_I, HOBE_WARPING_PAPER)};
    for (int i = 0; i < 3; i++) {
        const struct hobe_element_options options = {.kernel = hobe_find_kernel("MGD30w3", &err),
                                                     .section = sections[i],
                                                     .material = {E, NU, 0, 1, 1, 0},
                                                     .length = .4,
                                                     .integration = HOBE_INTEGRATION_PAPER};
        hobe_element *element = hobe_element_new(&options, &err);
        check_that(i == 0 ? element != NULL
                          : !element && err.status == HOBE_BAD_INPUT &&
                                strstr(err.message, "wy and wz") && strstr(err.message, "MGD30w3"),
                   "paper integration of %s: %s", hobe_section_text(sections[i]),
                   element ? "done" : err.message);
        hobe_element_free(element);
        hobe_section_free(sections[i]);
    }
}

int main(void)
{
    random_start();
    closed_forms();
    solved_factors();
    factors_turn();
    functions_by_hand();
    functions_of_a_tube();
    functions_are_orthogonal();
    beams_shear_as_their_sections();
    average_factors();
    paper_integration();
    return check_report();
}
