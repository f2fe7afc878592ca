/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Large torsion of cantilevers whose section warps: beside Vlasov's equation with Wagner's term and
 * beside a solid; and the stress in it. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>

static const double NU = 0.3, LENGTH = 2;

static hobe_solution *twisted(hobe_model **model, const hobe_section *section, double E, double T)
{
    const struct hobe_beam beam = beam_along_x("MGD30w", 20, section, E, NU, LENGTH);
    *model = cantilever(&beam, 0);
    add_moment(*model, "beam", 1, T, 0, 0);
    return solve(*model, 8);
}

static hobe_section *thin_walled(void)
{
    const struct hobe_profile_sizes sizes = {
        .height = .215, .width = .1, .flange = .015, .web = .01};
    struct hobe_error err;
    hobe_section *section = hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    return section;
}

/* ---- thin walls ----------------------------------------------------------------------------- */

/* E Iw p'' = G J p + E In p^3/2 - T of the twist p per length, and what it adds up to. */
struct vlasov {
    double GJ, EIw, EIn, T;
    double p, slope;      /* p', 1/m^2 */
    double twist, square; /* int p dx, rad, and int p^2 dx, rad^2/m */
};

/* Heun's step. */
static void step(struct vlasov *v, double h)
{
    double rate[2][4];
    const struct vlasov start = *v;
    for (int k = 0; k < 2; k++) {
        const double p = v->p, torque = v->GJ * p + v->EIn * p * p * p / 2;
        rate[k][0] = v->slope;
        rate[k][1] = (torque - v->T) / v->EIw;
        rate[k][2] = p;
        rate[k][3] = p * p;
        const double part = k ? h / 2 : h;
        *v = start;
        for (int i = 0; i <= k; i++) {
            v->p += part * rate[i][0];
            v->slope += part * rate[i][1];
            v->twist += part * rate[i][2];
            v->square += part * rate[i][3];
        }
    }
}

/* From p = 0 at the clamp to p' = 0 at the free end, by bisection of p' at the clamp: too small a
 * one vanishes before the end, where p turns back. */
static struct vlasov shoot(struct vlasov v)
{
    enum { STEPS = 4000 };
    double low = 0, high = v.T / sqrt(v.GJ * v.EIw);
    struct vlasov end = v;
    for (int i = 0; i < 60; i++) {
        struct vlasov now = v;
        int n = 0;
        now.slope = (low + high) / 2;
        for (; n < STEPS && now.slope > 0; n++)
            step(&now, LENGTH / STEPS);
        if (n < STEPS)
            low = (low + high) / 2;
        else {
            high = (low + high) / 2;
            end = now;
        }
    }
    return end;
}

/* The equation has the first nonlinear term of an expansion in (p r)^2, which is 1 % at the outer
 * fibres under the greatest moment: so good is it, and half as good the shortening, which goes with
 * the square of the twist.  Had the flanges to bear the strain
 * (p h/2)^2/2 across that warping makes there, the beam would be 12 % too stiff. */
static void beside_vlasov(void)
{
    static const double moment[] = {1e3, 3637, 10e3, 30e3};
    const double E = 210e9;
    hobe_section *section = thin_walled();
    const struct hobe_section_properties s = properties_of(section);
    for (int i = 0; i < 4; i++) {
        hobe_model *model;
        hobe_solution *solution = twisted(&model, section, E, moment[i]);
        const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
        const struct vlasov v = shoot((struct vlasov){
            .GJ = E / (2 * (1 + NU)) * s.J, .EIw = E * s.Iw, .EIn = E * s.Wagner, .T = moment[i]});
        const double shortening = (s.Iyy + s.Izz) / s.A * v.square / 2;
        printf("I, %g N m: twist %.5f rad, theory %.5f; shortening %.5g m, theory %.5g\n",
               moment[i], tip.twist, v.twist, -tip.u[0], shortening);
        check_relative(tip.twist, v.twist, 0.01, "twist of the I under %g N m", moment[i]);
        check_relative(-tip.u[0], shortening, 0.02, "shortening of the I under %g N m", moment[i]);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* The flanges carry Wagner's stress along the beam and none across, but for what the change of
 * torsion along it brings: not E (p h/2)^2/2. */
static void stress_across(void)
{
    const double E = 210e9, z = 0.1, at = 0.52;
    struct hobe_error err;
    hobe_model *model;
    hobe_section *section = thin_walled();
    hobe_solution *solution = twisted(&model, section, E, 10e3);
    const double dx = 0.01, p = (point_of(solution, "beam", at + dx / 2, 0, 0).twist -
                                 point_of(solution, "beam", at - dx / 2, 0, 0).twist) /
                                (dx * LENGTH);
    const double spurious = E * p * p * z * z / 2;
    for (int i = 0; i < 5; i++) {
        struct hobe_stress s;
        const double y = random_real(-.05, .05);
        const struct hobe_point point = point_of(solution, "beam", at, y, z);
        if (hobe_solution_stress(solution, "beam", at, y, z, &s, &err))
            check_stop("%s", err.message);
        for (int k = 1; k <= 3; k++) {
            check_absolute(s.S[k], 0, 0.02 * spurious, "stress %d across the flange", k);
            check_relative(s.strain[k], point.strain[k], 1e-12, "strain of the displacement");
        }
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- a solid -------------------------------------------------------------------------------- */

/* Against converged quadratic bricks, 3.700(5) rad and 3.49 mm: to two of their uncertainties, and
 * to three in the last digit. */
static void beside_a_solid(void)
{
    hobe_model *model;
    hobe_section *section = rectangle(0.1, 0.1);
    hobe_solution *solution = twisted(&model, section, 1e9, 10e3);
    const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
    const double twist = tip.twist < 0 ? tip.twist + 2 * M_PI : tip.twist; /* known to a turn */
    printf("square, 10 kN m: twist %.5f rad, shortening %.5g m\n", twist, -tip.u[0]);
    check_relative(twist, 3.700, 3e-3, "twist of the square");
    check_relative(-tip.u[0], 3.49e-3, 1e-2, "shortening of the square");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    beside_vlasov();
    stress_across();
    beside_a_solid();
    return check_report();
}
