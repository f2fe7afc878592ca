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
    channel();
    askew();
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
