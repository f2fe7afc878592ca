/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Large displacements against published and exact results: the Princeton beam, near, far and
 * turned; the elastica; a beam rolled up into a circle; pure bending on any mesh. */
#include "check.h"
#include "elastica.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>

/* ---- the Princeton beam ------------------------------------------------------------------------
 */

static const double LENGTH = 0.508, P3 = 13.345; /* m, N */

/* The force at 30 degrees between the axes y and z of the section. */
static void princeton_force(double P, double F[3])
{
    F[0] = 0;
    F[1] = -P * sin(M_PI / 6);
    F[2] = -P * cos(M_PI / 6);
}

static struct hobe_beam princeton_beam(const hobe_section *section, int elements, double length)
{
    struct hobe_beam beam = beam_along_x("MGD30w", elements, section, 71.7e9, 0.31, length);
    beam.mechanics = HOBE_MECHANICS_AXIS;
    return beam;
}

static hobe_section *princeton_section(void)
{
    return rectangle(3.2024e-3, 12.377e-3);
}

/* Tip under P3 of a beam along x. */
static struct hobe_point princeton_tip(const struct hobe_beam *beam)
{
    double F[3];
    hobe_model *model = cantilever(beam, 0);
    princeton_force(P3, F);
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    return tip_of(model, 1);
}

/* Recomputed from Tang, Tian & Hu 2022, Table 7, by a program that shares nothing with this one:
 * ten digits, the twist in degrees to five decimals.  Its exact values carry its own cubature of w,
 * good to some 1e-5 of J. */
static void princeton_values(void)
{
    static const struct {
        enum hobe_integration integration;
        double u[3], twist, tolerance, twist_tolerance;
    } known[] = {
        {HOBE_INTEGRATION_PAPER,
         {-1.714025118e-02, -1.178163053e-01, -1.671874272e-02},
         3.34599,
         1e-8,
         1e-5},
        {HOBE_INTEGRATION_EXACT,
         {-1.708297739e-02, -1.176497589e-01, -1.659323289e-02},
         3.23402,
         1e-5,
         1e-4},
    };
    hobe_section *section = princeton_section();
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = princeton_beam(section, 24, LENGTH);
        beam.integration = known[i].integration;
        const struct hobe_point tip = princeton_tip(&beam);
        for (int a = 0; a < 3; a++)
            check_relative(tip.u[a], known[i].u[a], known[i].tolerance,
                           "Princeton, setting %d: u%d", i, a + 1);
        check_absolute(tip.twist * 180 / M_PI, known[i].twist, known[i].twist_tolerance,
                       "Princeton, setting %d: twist", i);
    }
    hobe_section_free(section);
}

/* 2^20 m from the origin on every axis; positions and lengths are exact in binary, so that the far
 * beam has the near one's digits. */
static void princeton_far_away(void)
{
    hobe_section *section = princeton_section();
    struct hobe_beam beam = princeton_beam(section, 16, 0.5);
    const struct hobe_point near = princeton_tip(&beam);
    for (int a = 0; a < 3; a++) {
        beam.from[a] = a == 1 ? -0x1p20 : 0x1p20;
        beam.to[a] = beam.from[a] + (a == 0 ? 0.5 : 0);
    }
    const struct hobe_point far = princeton_tip(&beam);
    check_absolute(distance(far.u, near.u), 0, 1e-9 * norm(near.u), "far away: u");
    check_relative(far.twist, near.twist, 1e-9, "far away: twist");
    check_absolute(distance(far.rotation, near.rotation), 0, 1e-9, "far away: rotation");
    for (int i = 0; i < 6; i++)
        check_absolute(far.strain[i], near.strain[i], 1e-12, "far away: strain %d", i);
    check_absolute(far.r[0] - 0x1p20 - 0.5, far.u[0], 0x1p-32, "far away: r = r0 + u");
    hobe_section_free(section);
}

/* Components along three axes, and the vector with given components. */
static void to_axes(double axes[3][3], const double v[3], double c[3])
{
    for (int b = 0; b < 3; b++)
        c[b] = v[0] * axes[b][0] + v[1] * axes[b][1] + v[2] * axes[b][2];
}

static void from_axes(double axes[3][3], const double c[3], double v[3])
{
    for (int a = 0; a < 3; a++)
        v[a] = c[0] * axes[0][a] + c[1] * axes[1][a] + c[2] * axes[2][a];
}

static void random_axes(double e[3][3])
{
    double along;
    do {
        random_direction(e[0]);
        random_direction(e[2]);
        along = e[0][0] * e[2][0] + e[0][1] * e[2][1] + e[0][2] * e[2][2];
    } while (fabs(along) > 0.9);
    double length = sqrt(1 - along * along);
    for (int a = 0; a < 3; a++)
        e[2][a] = (e[2][a] - along * e[0][a]) / length;
    for (int a = 0; a < 3; a++)
        e[1][a] = e[2][(a + 1) % 3] * e[0][(a + 2) % 3] - e[2][(a + 2) % 3] * e[0][(a + 1) % 3];
}

/* Turned into a random direction, with any `up` in the plane of the section's z axis and the beam,
 * the beam has the solution turned; limited by the conditioning of the tangent, 1e8. */
static void princeton_turned(void)
{
    hobe_section *section = princeton_section();
    struct hobe_beam beam = princeton_beam(section, 12, LENGTH);
    const struct hobe_point straight = princeton_tip(&beam);
    for (int i = 0; i < 5; i++) {
        double axes[3][3], F[3], local[3];
        random_axes(axes);
        const double stretch = random_real(0.01, 100), lean = random_real(-2, 2);
        for (int a = 0; a < 3; a++) {
            beam.from[a] = random_real(-1, 1);
            beam.to[a] = beam.from[a] + LENGTH * axes[0][a];
            beam.up[a] = stretch * (axes[2][a] + lean * axes[0][a]);
        }
        hobe_model *model = cantilever(&beam, 0);
        princeton_force(P3, local);
        from_axes(axes, local, F);
        add_force(model, "beam", 1, F[0], F[1], F[2]);
        const struct hobe_point tip = tip_of(model, 1);
        to_axes(axes, tip.u, local);
        check_absolute(distance(local, straight.u), 0, 1e-8 * norm(straight.u), "turned: u");
        check_absolute(tip.twist, straight.twist, 1e-8, "turned: twist");
        to_axes(axes, tip.rotation, local);
        check_absolute(distance(local, straight.rotation), 0, 1e-8, "turned: rotation");
        for (int k = 0; k < 6; k++)
            check_absolute(tip.strain[k], straight.strain[k], 1e-11, "turned: strain %d", k);
    }
    hobe_section_free(section);
}

/* Halving the elements: the differences shrink, and the finest two agree to 1e-3 of u, where the
 * boundary layer of warping at the clamp, one section height long, is not yet resolved. */
static void princeton_refined(void)
{
    hobe_section *section = princeton_section();
    double u[4][3], change[3];
    for (int i = 0; i < 4; i++) {
        struct hobe_beam beam = princeton_beam(section, 6 << i, LENGTH);
        const struct hobe_point tip = princeton_tip(&beam);
        for (int a = 0; a < 3; a++)
            u[i][a] = tip.u[a];
    }
    for (int i = 0; i < 3; i++)
        change[i] = distance(u[i + 1], u[i]) / norm(u[3]);
    printf("Princeton beam, change of u from 6 to 12, 24, 48 elements: %.1e %.1e %.1e\n", change[0],
           change[1], change[2]);
    check_that(change[1] < 0.6 * change[0] && change[2] < 0.6 * change[1],
               "each halving changes u less: %g %g %g", change[0], change[1], change[2]);
    check_that(change[2] < 1e-3, "24 and 48 elements agree: %g", change[2]);
    hobe_section_free(section);
}

/* ---- slender beams
 * ------------------------------------------------------------------------------- */

/* A square beam of length 1 and EI = 1, nu = 0. */
static struct hobe_beam slender(const char *element, int elements, const hobe_section *section)
{
    return beam_along_x(element, elements, section, 1 / properties_of(section).Iyy, 0, 1);
}

static void tip_under(const char *element, double height, double alpha, int follower, double tip[3])
{
    hobe_section *section = rectangle(height, height);
    const struct hobe_beam beam = slender(element, 48, section);
    hobe_model *model = cantilever(&beam, 0);
    (follower ? add_follower : add_force)(model, "beam", 1, 0, 0, -alpha);
    const struct hobe_point p = tip_of(model, 5);
    tip[0] = -p.u[0];
    tip[1] = -p.u[2];
    tip[2] = p.rotation[1];
    hobe_section_free(section);
}

/* The elastica is the limit of vanishing thickness; shear and stretch of a real beam are of order
 * (h/L)^2, which the values at h and h/2 eliminate.  Left is (k h)^4 with the curvature k^2 of up
 * to 2 alpha/L^2, 6e-7 alpha^2 at h = 0.02, of which a tenth is allowed. */
static void elastica(const char *element, double alpha, int follower)
{
    static const char *const what[] = {"shortening", "deflection", "angle"};
    const struct elastica e = follower ? elastica_follower(alpha) : elastica_dead(alpha);
    const double exact[3] = {e.shortening, e.deflection, e.angle};
    double thick[3], thin[3], limit[3];
    tip_under(element, 0.02, alpha, follower, thick);
    tip_under(element, 0.01, alpha, follower, thin);
    for (int i = 0; i < 3; i++) {
        limit[i] = (4 * thin[i] - thick[i]) / 3;
        check_absolute(limit[i], exact[i], 6e-8 * alpha * alpha, "%s, %s force %g: %s", element,
                       follower ? "follower" : "dead", alpha, what[i]);
    }
    printf("elastica %-6s %-8s %2g: %.9f %.9f %.9f, off by %8.1e %8.1e %8.1e\n", element,
           follower ? "follower" : "dead", alpha, limit[0], limit[1], limit[2], limit[0] - exact[0],
           limit[1] - exact[1], limit[2] - exact[2]);
}

/* The integration of elastica.c against the tabulated elliptic integrals, six digits. */
static void elastica_table(void)
{
    static const double table[][3] = {{1, .056433, .301721},
                                      {2, .160642, .493457},
                                      {4, .328941, .669964},
                                      {10, .554996, .810609}};
    for (int i = 0; i < 4; i++) {
        const struct elastica e = elastica_dead(table[i][0]);
        check_absolute(e.shortening, table[i][1], 0.5e-6, "elastica %g: shortening", table[i][0]);
        check_absolute(e.deflection, table[i][2], 0.5e-6, "elastica %g: deflection", table[i][0]);
    }
}

static void elasticas(void)
{
    static const double alpha[] = {1, 2, 4, 10};
    elastica_table();
    for (int i = 0; i < 4; i++)
        elastica("3433", alpha[i], 0);
    elastica("MGD30", 2, 0);
    elastica("3333s", 2, 0);
    elastica("3333s", 10, 1);
    elastica("3433", 2, 1);
    elastica("3433", 10, 1);
}

/* M = 2 pi EI/L bends the beam into a circle, in the limit of vanishing thickness.  With thickness,
 * the quadratic terms of Green's strain, k z + k^2 z^2/2 less the section's own shortening, soften
 * the bending to first order in (k h)^2 like
 *
 *     M = EI k (1 - 28/5 k^2 h^2/12)
 *
 * (stretch -3/2 k^2 h^2/12 of the axis and contraction -k^2 h^2/12 along z eliminated). */
static void rolled_up(const char *element, double height, int elements)
{
    hobe_section *section = rectangle(height, height);
    const struct hobe_beam beam = slender(element, elements, section);
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 0, 2 * M_PI, 0);
    const struct hobe_point tip = tip_of(model, 8);
    const double order = pow(2 * M_PI * height, 2) / 12;
    const double excess = 2 * M_PI * 5.6 * order;
    /* the circle does not close by the arc that is turned too far, and the axis shortens */
    printf("rolled up, %s, h/L %g, n %d: tip at (%.2e, %.2e, %.2e) m, %.5e rad too far (%.5e)\n",
           element, height, elements, tip.r[0], tip.r[1], tip.r[2], tip.rotation[1], excess);
    check_that(norm(tip.r) < 1.05 * excess / (2 * M_PI), "%s: the circle closes: %g", element,
               norm(tip.r));
    /* the ends, where r_z keeps its length, are h/L of the beam, and the next order is (k h)^4; the
     * mesh leaves 1e-6 rad */
    check_absolute(tip.rotation[1], excess, (height + 12 * order) * excess + 1e-6,
                   "%s: angle of the circle", element);
    hobe_section_free(section);
}

/* ---- end moments
 * --------------------------------------------------------------------------------- */

/* A small end moment bends the beam to M L/(EI) on every mesh, also one much finer than the section
 * is high: a couple on the slopes of the section is carried by bending, not by one element. The
 * rotation's second order is 1e-12 of it; round-off times the tangent's condition, 1e8 on the
 * finest mesh, 1e-8. */
static void bending_moment(const char *element)
{
    const double E = 210e9, W = 0.05, H = 0.1, L = 1, turn = 1e-6;
    hobe_section *section = rectangle(W, H);
    const struct hobe_section_properties p = properties_of(section);
    for (int n = 1; n <= 64; n *= 4)
        for (int axis = 1; axis < 3; axis++) {
            const struct hobe_beam beam = beam_along_x(element, n, section, E, 0.3, L);
            const double EI = E * (axis == 1 ? p.Iyy : p.Izz), M = EI * turn / L;
            hobe_model *model = cantilever(&beam, 0);
            add_moment(model, "beam", 1, 0, axis == 1 ? M : 0, axis == 2 ? M : 0);
            const struct hobe_point tip = tip_of(model, 1);
            check_relative(tip.rotation[axis], turn, 1e-8, "%s, n %d: end moment about %c", element,
                           n, "xyz"[axis]);
            check_relative(axis == 1 ? -tip.u[2] : tip.u[1], turn * L / 2, 1e-8,
                           "%s, n %d: deflection by an end moment about %c", element, n,
                           "xyz"[axis]);
        }
    hobe_section_free(section);
}

/* An element that bends in its plane feels that the clamp holds its outline, and the section that
 * the moment acts on its slopes: end effects over a height or two, which the deflection knows
 * little of and refinement resolves. */
static void bending_moment_of_rich_element(void)
{
    const double E = 210e9, W = 0.05, H = 0.1, L = 1, turn = 1e-6;
    hobe_section *section = rectangle(W, H);
    double rotation[3], deflection[3];
    for (int i = 0; i < 3; i++) {
        const struct hobe_beam beam = beam_along_x("34X3", 4 << (2 * i), section, E, 0.3, L);
        hobe_model *model = cantilever(&beam, 0);
        add_moment(model, "beam", 1, 0, E * properties_of(section).Iyy * turn / L, 0);
        const struct hobe_point tip = tip_of(model, 1);
        rotation[i] = tip.rotation[1];
        deflection[i] = -tip.u[2];
        check_relative(deflection[i], turn * L / 2, 2e-3, "34X3: deflection by an end moment");
    }
    check_absolute(rotation[2], rotation[1], 0.02 * turn, "34X3: no softening without limit");
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    princeton_values();
    princeton_far_away();
    princeton_turned();
    princeton_refined();
    elasticas();
    rolled_up("3433", 1e-2, 48);
    rolled_up("MGD30", 1e-2, 64);
    rolled_up("3433", 1e-3, 96);
    bending_moment("MGD30w");
    bending_moment("3433");
    bending_moment("3333w");
    bending_moment("3333s");
    bending_moment_of_rich_element();
    return check_report();
}
