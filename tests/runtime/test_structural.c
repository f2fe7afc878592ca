/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elements of the structural form in beams: published values, and the rod's own stiffnesses, which
 * the element takes from the section. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <string.h>

static const double E = 210e9, NU = 0.3, L = 1;

/* Tang, Tian & Hu 2022, Table 7, row "3333s", which quotes Ebel et al.: five digits. */
static void princeton(void)
{
    static const struct {
        int elements;
        double u3;
    } published[] = {{4, -0.016771}, {8, -0.016777}, {16, -0.016777}};
    const double P = 13.345, angle = M_PI / 6;
    hobe_section *section = rectangle(3.2024e-3, 12.377e-3);
    for (int i = 0; i < 3; i++) {
        const struct hobe_beam beam =
            beam_along_x("3333s", published[i].elements, section, 71.7e9, 0.31, 0.508);
        hobe_model *model = cantilever(&beam, 0);
        add_force(model, "beam", 1, 0, -P * sin(angle), -P * cos(angle));
        const struct hobe_point tip = tip_of(model, 4);
        check_relative(tip.u[2], published[i].u3, 1e-4, "Princeton, %d elements: u3",
                       published[i].elements);
    }
    hobe_section_free(section);
}

/* A tip force of 1e-6 of that which bends the beam by its length: P L^3/(3 EI) + P L/(k G A), which
 * two Gauss points on each element find on any mesh.  The deflection's second order is 1e-12. */
static void shear(void)
{
    const double W = 0.2, H = 0.4, G = E / (2 * (1 + NU)), k[3] = {0, 0.9, 0.6};
    hobe_section *section = rectangle(W, H);
    const struct hobe_section_properties p = properties_of(section);
    for (int n = 1; n <= 4; n += 3)
        for (int axis = 1; axis < 3; axis++) {
            struct hobe_beam beam = beam_along_x("3333s", n, section, E, NU, L);
            const double I = axis == 1 ? p.Izz : p.Iyy, P = 1e-6 * E * I / (L * L);
            beam.material.k3 = k[1]; /* on xy */
            beam.material.k2 = k[2]; /* on xz */
            hobe_model *model = cantilever(&beam, 0);
            add_force(model, "beam", 1, 0, axis == 1 ? P : 0, axis == 2 ? P : 0);
            const struct hobe_point tip = tip_of(model, 1);
            const double exact = P * L * L * L / (3 * E * I) + P * L / (k[axis] * G * p.A);
            check_relative(tip.u[axis], exact, 1e-9, "shear and bending along %c, %d elements",
                           "xyz"[axis], n);
        }
    hobe_section_free(section);
}

/* M = 2 pi EI/L bends a rod into a circle, however thick it is.  The mesh leaves the fourth power
 * of the angle of an element, 0.05 (2 pi/n)^4 rad. */
static void rolled_up(void)
{
    hobe_section *section = rectangle(0.1, 0.1);
    for (int n = 16; n <= 64; n *= 4) {
        const struct hobe_beam beam = beam_along_x("3333s", n, section, E, NU, L);
        hobe_model *model = cantilever(&beam, 0);
        add_moment(model, "beam", 1, 0, 2 * M_PI * E * properties_of(section).Iyy / L, 0);
        const struct hobe_point tip = tip_of(model, 8);
        const double mesh = 0.1 * pow(2 * M_PI / n, 4);
        check_absolute(tip.rotation[1], 0, mesh, "rolled up, %d elements: angle", n);
        check_absolute(norm(tip.r), 0, mesh * L, "rolled up, %d elements: tip", n);
    }
    hobe_section_free(section);
}

/* A force at the centroid of a channel twists it about its shear centre y_s,
 * -P y_s L/(G J) (P along z), by the true torsion constant and without a warping mode, and its axis
 * follows the twist: 1/3 P L^3/(EI) + P L/(G A) + P y_s^2 L/(G J). */
static void channel(void)
{
    const struct hobe_profile_sizes sizes = {
        .height = 0.1, .width = 0.05, .flange = 0.006, .web = 0.004};
    struct hobe_error err;
    hobe_section *section =
        hobe_section_profile(HOBE_PROFILE_CHANNEL, &sizes, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    const struct hobe_section_properties p = properties_of(section);
    const double G = E / (2 * (1 + NU)), P = 1e-6 * G * p.J / (L * fabs(p.ys));
    const struct hobe_beam beam = beam_along_x("3333s", 4, section, E, NU, L);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, P);
    const struct hobe_point tip = tip_of(model, 1);
    check_that(fabs(p.ys) > 0.02, "the shear centre is far out: %g", p.ys);
    check_relative(tip.twist, -P * p.ys * L / (G * p.J), 1e-6, "twist of a channel");
    check_relative(tip.u[2],
                   P * L * L * L / (3 * E * p.Iyy) + P * L / (G * p.A) +
                       P * p.ys * p.ys * L / (G * p.J),
                   1e-6, "deflection of a channel");
    hobe_section_free(section);
}

/* An angle bends askew: kappa = I^-1 (M_y, M_z) with the product of inertia. */
static void askew(void)
{
    const struct hobe_profile_sizes sizes = {
        .height = 0.1, .width = 0.06, .flange = 0.006, .web = 0.008};
    struct hobe_error err;
    hobe_section *section =
        hobe_section_profile(HOBE_PROFILE_ANGLE, &sizes, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    const struct hobe_section_properties p = properties_of(section);
    const double det = p.Iyy * p.Izz - p.Iyz * p.Iyz, M = 1e-6 * E * det / p.Iyy / L;
    const struct hobe_beam beam = beam_along_x("3333s", 2, section, E, NU, L);
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 0, M, 0);
    const struct hobe_point tip = tip_of(model, 1);
    check_relative(tip.rotation[1], M * p.Izz / (E * det) * L, 1e-6, "angle, about y");
    check_relative(tip.rotation[2], M * p.Iyz / (E * det) * L, 1e-6, "angle, about z");
    hobe_section_free(section);
}

/* Steel on aluminium, EA alike in both: tension and bending about y do not mix, and the axis is
 * halfway between the centroids. */
static void bimetal(void)
{
    const double W = 0.02, E1 = 210e9, H1 = 0.01, E2 = 70e9, H2 = 0.03, turn = 1e-6;
    const double EA = W * (E1 * H1 + E2 * H2), half = (H1 + H2) / 4;
    const double EI =
        W * (E1 * (pow(H1, 3) / 12 + H1 * half * half) + E2 * (pow(H2, 3) / 12 + H2 * half * half));
    struct hobe_error err;
    hobe_section *top = rectangle(W, H1), *bottom = rectangle(W, H2);
    const struct hobe_section_part parts[] = {
        {top, {0, H1 / 2}, {.E = E1, .nu = 0.3, .k2 = 1, .k3 = 1}},
        {bottom, {0, -H2 / 2}, {.E = E2, .nu = 0.33, .k2 = 1, .k3 = 1}}};
    hobe_section *section = hobe_section_composite(2, parts, &err);
    if (!section)
        check_stop("%s", err.message);
    for (int bends = 0; bends < 2; bends++) {
        const struct hobe_beam beam = beam_along_x("3333s", 2, section, E, NU, L);
        hobe_model *model = cantilever(&beam, 0);
        if (bends)
            add_moment(model, "beam", 1, 0, EI * turn / L, 0);
        else
            add_force(model, "beam", 1, EA * turn / L, 0, 0);
        const struct hobe_point tip = tip_of(model, 1);
        check_absolute(tip.rotation[1], bends * turn, 1e-8 * turn, "bimetal: rotation");
        /* a bent axis shortens by turn^2/6 */
        check_absolute(tip.u[0], !bends * turn, turn * turn, "bimetal: stretch");
    }
    hobe_section_free(section);
    hobe_section_free(top);
    hobe_section_free(bottom);
}

/* ---- curved and tapered beams --------------------------------------------------------------- */

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    const double *radius = context, angle = t * M_PI / 4;
    (void)err;
    r[0] = *radius * sin(angle);
    r[1] = *radius * (1 - cos(angle));
    r[2] = 0;
    return HOBE_OK;
}

/* Bathe & Bolourchi 1979: an arc of 45 degrees, R = 100, 1 x 1, E = 1e7, nu = 0, bent out of its
 * plane by P at its tip.  Positions of the tip of a rod with the square's torsion constant, by an
 * independent program, three decimals; sixteen elements are 1e-3 from them. */
static void bend(void)
{
    static const struct {
        double P, tip[3];
    } known[] = {{300, {58.536, 22.113, 40.481}}, {600, {46.892, 15.558, 53.608}}};
    double radius = 100;
    struct hobe_error err;
    hobe_section *section = rectangle(1, 1);
    hobe_curve *curve = hobe_curve_function(arc, &radius, &err);
    if (!curve)
        check_stop("%s", err.message);
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x("3333s", 16, section, 1e7, 0, 0);
        beam.curve = curve;
        hobe_model *model = cantilever(&beam, 0);
        add_force(model, "beam", 1, 0, 0, known[i].P);
        const struct hobe_point tip = tip_of(model, 10);
        check_absolute(distance(tip.r, known[i].tip), 0, 2e-3, "45-degree bend, P = %g",
                       known[i].P);
    }
    hobe_curve_free(curve);
    hobe_section_free(section);
}

/* The torsion constant of a cone is that of each station: theta = int M dx/(G pi R^4/2)
 * = 2 M L/(3 pi G (R_0 - R_1)) (1/R_1^3 - 1/R_0^3); two points on each of 32 elements leave 1e-6.
 */
static void cone(void)
{
    const double R0 = 0.1, R1 = 0.06, G = E / (2 * (1 + NU)), M = 1;
    struct hobe_error err;
    hobe_section *from = hobe_section_circle(R0, &err), *to = hobe_section_circle(R1, &err);
    hobe_section *section = hobe_section_linear(from, to, &err);
    if (!section)
        check_stop("%s", err.message);
    const struct hobe_beam beam = beam_along_x("3333s", 32, section, E, NU, L);
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, M, 0, 0);
    check_relative(tip_of(model, 1).twist,
                   2 * M * L / (3 * M_PI * G * (R0 - R1)) * (pow(R1, -3) - pow(R0, -3)), 1e-6,
                   "twist of a cone");
    hobe_section_free(section);
    hobe_section_free(from);
    hobe_section_free(to);
}

/* ---- what does not go together --------------------------------------------------------------- */

static void refused(const char *name, enum hobe_mechanics mechanics,
                    enum hobe_integration integration, const char *sentence)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_element_options options = {.kernel = hobe_find_kernel(name, &err),
                                                 .section = section,
                                                 .material = {.E = E, .nu = NU, .k2 = 1, .k3 = 1},
                                                 .length = L,
                                                 .mechanics = mechanics,
                                                 .integration = integration};
    hobe_element *element = hobe_element_new(&options, &err);
    check_that(!element && err.status == HOBE_BAD_INPUT && strcmp(err.message, sentence) == 0,
               "refused: %s", element ? "accepted" : err.message);
    hobe_element_free(element);
    hobe_section_free(section);
}

int main(void)
{
    princeton();
    shear();
    rolled_up();
    channel();
    askew();
    bimetal();
    bend();
    cone();
    refused("3333s", HOBE_MECHANICS_AVERAGE, HOBE_INTEGRATION_EXACT,
            "element 3333s does not take mechanics \"average\"; leave it out for its own, "
            "\"structural\"");
    refused("3333", HOBE_MECHANICS_STRUCTURAL, HOBE_INTEGRATION_EXACT,
            "element 3333 does not take mechanics \"structural\"; leave it out for its own, "
            "\"average\"");
    refused("3333s", HOBE_MECHANICS_DEFAULT, HOBE_INTEGRATION_PAPER,
            "element 3333s brings its own points on the axis and does not take integration "
            "\"paper\"; leave it out");
    return check_report();
}
