/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress inside beams: beside closed forms; that it does the work of the elements' forces; that
 * rigid motions make none and the frame does not matter. */
#include "check.h"
#include "scene.h"
#include "solution.h"
#include "stress.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 70e9, NU = 0.33;
enum { XX, YY, ZZ, YZ, XZ, XY, STRESSES };

static struct hobe_stress stress_of(const hobe_solution *solution, double at, double y, double z)
{
    struct hobe_error err;
    struct hobe_stress stress;
    if (hobe_solution_stress(solution, "beam", at, y, z, &stress, &err))
        check_stop("%s", err.message);
    return stress;
}

/* All stresses in all axes, of a small load on a beam along x. */
static void check_stress(const struct hobe_stress *stress, const double expected[STRESSES],
                         double tolerance, const char *what)
{
    for (int k = 0; k < STRESSES; k++) {
        check_absolute(stress->S[k], expected[k], tolerance, "%s: S[%d]", what, k);
        check_absolute(stress->cauchy[k], expected[k], tolerance, "%s: cauchy[%d]", what, k);
        check_absolute(stress->section[k], expected[k], tolerance, "%s: section[%d]", what, k);
    }
}

static void close_scene(hobe_solution *solution, hobe_model *model, hobe_section *section)
{
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- closed forms --------------------------------------------------------------------------- */

/* P/A far from the clamp, whose end effect falls fivefold with each element; the second order of
 * the load is its strain, 1e-9. */
static void tension(const char *element, enum hobe_mechanics mechanics)
{
    const double sigma = 1e-9 * E;
    hobe_section *section = rectangle(0.1, 0.2);
    struct hobe_beam beam = beam_along_x(element, 20, section, E, NU, 10);
    beam.mechanics = mechanics;
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, sigma * 0.02, 0, 0);
    hobe_solution *solution = solve(model, 1);
    for (int i = 0; i < 6; i++) {
        const struct hobe_stress s = stress_of(solution, random_real(0.65, 0.95),
                                               random_real(-.05, .05), random_real(-.1, .1));
        check_stress(&s, (const double[STRESSES]){[XX] = sigma}, 1e-8 * sigma, "tension");
        check_relative(s.mises, sigma, 1e-8, "tension: von Mises");
        check_relative(s.energy, sigma * sigma / (2 * E), 1e-8, "tension: energy");
    }
    close_scene(solution, model, section);
}

/* M y/I of both bending moments, with forces at the end of a slender beam.  Elements with plane
 * sections carry the whole moment by sigma_xx; the rest of the bending moment of an element of
 * length l is of order (l/L)^2, and what elements without quadratic modes cannot give, 0, is the
 * other stresses' but for the shear of the forces. */
static void bending(const char *element)
{
    const double W = 0.1, H = 0.2, L = 10, P[2] = {3, 5};
    hobe_section *section = rectangle(W, H);
    const struct hobe_section_properties s = properties_of(section);
    const struct hobe_beam beam = beam_along_x(element, 32, section, E, NU, L);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, P[0], P[1]);
    hobe_solution *solution = solve(model, 1);
    const double most = P[1] * L * H / 2 / s.Iyy;
    for (int i = 0; i < 8; i++) {
        const double at = random_real(0.2, 0.8), y = random_real(-W / 2, W / 2);
        const double z = random_real(-H / 2, H / 2), x = L * (1 - at);
        const double sigma = -x * (P[0] * y / s.Izz + P[1] * z / s.Iyy);
        const struct hobe_stress stress = stress_of(solution, at, y, z);
        check_absolute(stress.section[XX], sigma, 2e-3 * most, "%s: M y/I at %g", element, at);
        for (int k = YY; k <= YZ; k++)
            check_absolute(stress.section[k], 0, 2e-3 * most, "%s in bending: %d", element, k);
    }
    close_scene(solution, model, section);
}

/* Timoshenko and Goodier's series for a rectangle with the short side 2a and the long 2b: the
 * greatest stress, in the middle of the long side, over T/(2b (2a)^2), so 1/alpha. */
static double inverse_alpha(double a, double b)
{
    double J = 1, tau = 1;
    for (int n = 1; n < 200; n += 2) {
        const double c = n * M_PI * b / (2 * a);
        J -= 192 / pow(M_PI, 5) * a / b * tanh(c) / pow(n, 5);
        tau -= 8 / (M_PI * M_PI) / (n * n) / cosh(fmin(c, 700));
    }
    return 3 * tau / J;
}

/* The greatest stress of free torsion; of the mesh to half a percent, since its gradients are
 * linear in a triangle. */
static void torsion(const char *element, double ratio, int meshed)
{
    const double W = 0.1, H = ratio * W, T = 1;
    const double corner[4][2] = {{0, 0}, {W, 0}, {W, H}, {0, H}};
    struct hobe_error err;
    hobe_section *section =
        meshed ? hobe_section_polygon(1, (const int[]){4}, corner, &err) : rectangle(W, H);
    const struct hobe_beam beam = beam_along_x(element, 4, section, E, NU, 2);
    hobe_model *model = cantilever(&beam, 1);
    add_moment(model, "beam", 1, T, 0, 0);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_stress s = stress_of(solution, 0.5, W / 2, 0);
    const double tau = inverse_alpha(W / 2, H / 2) * T / (H * W * W);
    printf("torsion, %s, sides 1:%g, %s: alpha = %.6f, series %.6f\n", element, ratio,
           meshed ? "mesh" : "series", T / (H * W * W) / s.section[XZ],
           1 / inverse_alpha(W / 2, H / 2));
    /* 1e-6: second order of the angle, and w's series */
    check_relative(s.section[XZ], tau, meshed ? 5e-3 : 2e-6, "greatest stress of torsion");
    check_relative(s.mises, sqrt(3) * tau, meshed ? 5e-3 : 2e-6, "torsion: von Mises");
    close_scene(solution, model, section);
}

/* Zhuravskii's parabola, 1.5 V/A in the middle and 0 at the edge, with the functions of bending
 * shear; far from both ends.  nu = 0, since with it the transverse contraction of the bending
 * stress shears a wide section, too. */
static void shear(void)
{
    const double W = 0.1, H = 0.2, L = 4, V = 7;
    hobe_section *section = rectangle(W, H);
    const struct hobe_beam beam = beam_along_x("MGD30w3", 16, section, E, 0, L);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, V);
    hobe_solution *solution = solve(model, 1);
    for (int i = 0; i <= 8; i++) {
        const double z = H / 2 * (i / 4.0 - 1), t = 2 * z / H;
        const struct hobe_stress s = stress_of(solution, 0.5, random_real(-W / 2, W / 2), z);
        check_absolute(s.section[XZ], 1.5 * V / (W * H) * (1 - t * t), 5e-3 * V / (W * H),
                       "Zhuravskii at z = %g", z);
    }
    close_scene(solution, model, section);
}

/* Two layers in tension share the load by E: strains alike, sigma = E_k N/EA away from the ends.
 * The region counts on either side of the seam. */
static void layers(void)
{
    const double W = 0.1, H = 0.2, N = 20;
    const struct hobe_material material[2] = {{.E = 210e9, .nu = .3, .k2 = 1, .k3 = 1},
                                              {.E = 70e9, .nu = .3, .k2 = 1, .k3 = 1}};
    hobe_section *layer = rectangle(W, H / 2);
    struct hobe_error err;
    hobe_section *section = hobe_section_composite(
        2,
        (const struct hobe_section_part[]){{layer, {0, H / 4}, material[0]},
                                           {layer, {0, -H / 4}, material[1]}},
        &err);
    const struct hobe_section_properties p = properties_of(section);
    const struct hobe_beam beam = beam_along_x("MGD30w", 20, section, 1, 0, 10);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, N, 0, 0);
    hobe_solution *solution = solve(model, 1);
    const double seam = -p.zc, unit = N / (W * H / 2 * (material[0].E + material[1].E));
    for (int k = 0; k < 2; k++) {
        const double z = seam + (k ? -1 : 1) * random_real(1e-6, H / 2);
        const struct hobe_stress s = stress_of(solution, 0.8, random_real(-W / 2, W / 2), z);
        /* in a beam with plane sections layers of equal nu have no other stress */
        check_stress(&s, (const double[STRESSES]){[XX] = material[k].E * unit},
                     1e-6 * material[0].E * unit, "layers");
    }
    hobe_section_free(layer);
    close_scene(solution, model, section);
}

/* ---- work ----------------------------------------------------------------------------------- */

/* A model of one element whose state is given, not found. */
static hobe_solution *free_element(hobe_model **model, const struct hobe_beam *beam)
{
    *model = cantilever(beam, 0);
    return solve(*model, 1);
}

static void shake(hobe_solution *solution, double amount)
{
    const struct beam *beam = model_beam(solution->model, 0);
    for (int i = 0; i < 3 * beam->kernel->vectors; i++)
        solution->u[i] = amount * random_real(-1, 1);
}

typedef void strain_function(const double *N, const double *Nx, const double (*phi)[4],
                             const double *q0, const double *u, double *E);

/* The change of a strain along du.  It is quadratic in u, so that differences are exact. */
static void change_of(strain_function *strain, const struct around *p, const double *du, double *dE)
{
    double moved[3 * HOBE_MAX_VECTORS], there[2][STRESSES];
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < 3 * p->kernel->vectors; i++)
            moved[i] = p->u[i] + (side ? -1 : 1) * du[i];
        strain(p->N, p->Nx, (const double(*)[4])p->phi, p->q0, moved, there[side]);
    }
    for (int k = 0; k < STRESSES; k++)
        dE[k] = (there[0][k] - there[1][k]) / 2;
}

/* Of a section: int S dA, and the strain eta of kernel.h with its weights E or G. */
struct even {
    double S[STRESSES], eta[STRESSES], weight[STRESSES];
};

/* At phi's point: S:dE dV; where the law is relieved of eta, S:d(eta) dV less, and it adds to the
 * sums, the mean of eta being for the section as a whole. */
static double point_work(const struct stress_section *s, const struct hobe_stress *stress,
                         const hobe_section *section, int region, double volume, const double *du,
                         struct even *even)
{
    double dE[STRESSES], eta[STRESSES] = {0}, work = 0;
    change_of(s->around.kernel->strain, &s->around, du, dE);
    if (s->law->relieved)
        change_of(s->around.kernel->warping_strain, &s->around, du, eta);
    for (int k = 0; k < STRESSES; k++) {
        const double weight =
            volume * (k < YZ ? hobe_section_E(section, region) : hobe_section_G(section, region));
        work += volume * stress->S[k] * (dE[k] - eta[k]);
        even->S[k] += volume * stress->S[k];
        even->eta[k] += weight * eta[k];
        even->weight[k] += weight;
    }
    return work;
}

/* int S:dE dV in the state u, dE along du, E the strain that the law acts on. */
static double stress_work(hobe_solution *solution, const double *du, double *energy)
{
    const struct beam *beam = model_beam(solution->model, 0);
    const struct hobe_invariants *inv = hobe_element_invariants(beam_law(beam, 0));
    double work = 0;
    *energy = 0;
    for (int g = 0; g < inv->stations; g++) {
        struct stress_section s;
        struct even even = {0};
        struct hobe_error err;
        struct hobe_rule rule;
        const double at = inv->xi[g];
        if (stress_section(solution, "beam", at, &s, &err))
            check_stop("%s", err.message);
        const struct hobe_section_place place = around_section_place(s.around.place);
        if (hobe_section_rule(beam->spec.section, beam->kernel, beam->spec.integration, &place,
                              &rule, &err))
            check_stop("%s", err.message);
        for (int p = 0; p < rule.rule.points; p++) {
            const struct hobe_section_point *point = rule.point + p;
            struct hobe_stress here;
            double F[3][3];
            if (stress_at(&s, point->y, point->z, point->region, &here, &err))
                check_stop("%s", err.message);
            const double volume = inv->wx[g] * point->weight * around_gradient(&s.around, F);
            work += point_work(&s, &here, beam->spec.section, point->region, volume, du, &even);
            *energy += volume * here.energy;
        }
        for (int k = 0; k < STRESSES; k++)
            work += even.S[k] * even.eta[k] / even.weight[k];
        hobe_rule_free(&rule);
    }
    return work;
}

/* f . du of the element. */
static double force_work(hobe_solution *solution, const double *du, double *energy)
{
    const struct beam *beam = model_beam(solution->model, 0);
    const int n = 3 * beam->kernel->vectors;
    double q[3 * HOBE_MAX_VECTORS], f[3 * HOBE_MAX_VECTORS], work = 0;
    struct hobe_error err;
    for (int i = 0; i < n; i++)
        q[i] = beam_q0(beam, 0)[i] + solution->u[i];
    if (hobe_element_force(beam_law(beam, 0), beam_q0(beam, 0), q, f, &err) ||
        hobe_element_energy(beam_law(beam, 0), beam_q0(beam, 0), q, energy, &err))
        check_stop("%s", err.message);
    for (int i = 0; i < n; i++)
        work += f[i] * du[i];
    return work;
}

/* In any state the stress does the work of the element's force, and its energy is the element's.
 */
static void work(const struct hobe_beam *beam, const char *what)
{
    hobe_model *model;
    hobe_solution *solution = free_element(&model, beam);
    double du[3 * HOBE_MAX_VECTORS], energy[2];
    shake(solution, 0.05);
    for (int i = 0; i < 3 * beam->kernel->vectors; i++)
        du[i] = random_real(-0.05, 0.05);
    const double by_force = force_work(solution, du, energy);
    const double by_stress = stress_work(solution, du, energy + 1);
    /* functions at points of a mesh are found again by a search, which rounds: 1e-9 */
    const double scale = fmax(fabs(by_force), energy[0]);
    check_absolute(by_stress, by_force, 1e-8 * scale, "%s: work of the stress", what);
    check_relative(energy[1], energy[0], 1e-8, "%s: energy", what);
    hobe_solution_free(solution);
    hobe_model_free(model);
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)err;
    const double R = *(double *)context;
    memcpy(r, (const double[3]){R * sin(t), R * (1 - cos(t)), 0.2 * t}, 3 * sizeof *r);
    return HOBE_OK;
}

static enum hobe_status turning(void *context, double at, double *angle, struct hobe_error *err)
{
    (void)context, (void)err;
    *angle = 0.4 * at;
    return HOBE_OK;
}

static void works(void)
{
    double R = 1;
    struct hobe_error err;
    const struct hobe_material material[2] = {{.E = 3, .nu = .1, .k2 = .7, .k3 = .8},
                                              {.E = 1, .nu = .4, .k2 = .9, .k3 = .6, 1}};
    hobe_section *plain = rectangle(0.3, 0.5),
                 *taper = tapered(rectangle(.3, .4), rectangle(.2, .5));
    hobe_section *layers_of_two =
        hobe_section_composite(2,
                               (const struct hobe_section_part[]){{plain, {0, 0}, material[0]},
                                                                  {plain, {0.3, 0.1}, material[1]}},
                               &err);
    hobe_curve *curve = curve_of(arc, turning, &R);
    struct hobe_beam beam = beam_along_x("MGD30w3", 1, plain, 1, 0.3, 1);
    beam.material = material[0];
    work(&beam, "straight");
    beam.material.average_shear = 1;
    work(&beam, "average shear");
    beam.mechanics = HOBE_MECHANICS_FULL;
    work(&beam, "full");
    beam.mechanics = HOBE_MECHANICS_AVERAGE;
    beam.section = taper;
    work(&beam, "taper");
    beam.section = layers_of_two;
    work(&beam, "composite");
    beam.curve = curve;
    work(&beam, "curved composite");
    hobe_section_free(layers_of_two);
    hobe_section_free(taper);
    hobe_section_free(plain);
    hobe_curve_free(curve);
}

/* ---- frames --------------------------------------------------------------------------------- */

/* A random rotation, rows. */
static void random_rotation(double R[3][3])
{
    double other[3];
    random_direction(R[0]);
    random_direction(other);
    cross3(R[0], other, R[1]);
    const double length = norm(R[1]);
    for (int a = 0; a < 3; a++)
        R[1][a] /= length;
    cross3(R[0], R[1], R[2]);
}

/* Curved, tapered: a rotation by any angle makes no stress beyond rounding. */
static void rigid(void)
{
    double R = 2, Q[3][3];
    hobe_section *section = tapered(rectangle(.3, .4), rectangle(.2, .5));
    hobe_curve *curve = curve_of(arc, turning, &R);
    struct hobe_beam beam = beam_along_x("3433w", 1, section, 1, 0.3, 1);
    beam.curve = curve;
    hobe_model *model;
    hobe_solution *solution = free_element(&model, &beam);
    const double *q0 = beam_q0(model_beam(model, 0), 0);
    random_rotation(Q);
    for (int v = 0; v < beam.kernel->vectors; v++)
        for (int a = 0; a < 3; a++)
            solution->u[3 * v + a] = dot3(Q[a], q0 + 3 * v) - q0[3 * v + a];
    for (int i = 0; i < 6; i++) {
        const struct hobe_stress s =
            stress_of(solution, random_real(0, 1), random_real(-.1, .1), random_real(-.2, .2));
        check_absolute(s.mises, 0, 1e-13, "a rigid rotation: von Mises over E");
        check_absolute(s.energy, 0, 1e-25, "and energy");
    }
    close_scene(solution, model, section);
    hobe_curve_free(curve);
}

/* A scene and the same turned as a whole. */
static void turned_scene(void)
{
    double Q[3][3];
    hobe_section *section = rectangle(0.1, 0.2);
    hobe_model *model[2];
    hobe_solution *solution[2];
    random_rotation(Q);
    for (int turned = 0; turned < 2; turned++) {
        struct hobe_beam beam = beam_along_x("MGD30w", 4, section, 1e7, 0.3, 2);
        double force[3] = {-20, 30, 50}, moment[3] = {10, 5, -5}, load[2][3];
        for (int a = 0; a < 3; a++) {
            beam.to[a] = turned ? 2 * Q[a][0] : beam.to[a];
            beam.up[a] = turned ? Q[a][2] : a == 2;
            load[0][a] = turned ? dot3(Q[a], force) : force[a];
            load[1][a] = turned ? dot3(Q[a], moment) : moment[a];
        }
        model[turned] = cantilever(&beam, 0);
        add_force(model[turned], "beam", 1, load[0][0], load[0][1], load[0][2]);
        add_moment(model[turned], "beam", 1, load[1][0], load[1][1], load[1][2]);
        solution[turned] = solve(model[turned], 2);
    }
    for (int i = 0; i < 6; i++) {
        const double at = random_real(0, 1), y = random_real(-.05, .05), z = random_real(-.1, .1);
        const struct hobe_stress a = stress_of(solution[0], at, y, z);
        const struct hobe_stress b = stress_of(solution[1], at, y, z);
        /* of two solutions, each converged to 1e-13 of the load in stiffness-weighted forces */
        check_relative(b.mises, a.mises, 1e-8, "von Mises of a scene turned as a whole");
        for (int k = 0; k < STRESSES; k++)
            check_absolute(b.section[k], a.section[k], 1e-8 * a.mises, "in the section's axes");
    }
    for (int i = 0; i < 2; i++) {
        hobe_solution_free(solution[i]);
        hobe_model_free(model[i]);
    }
    hobe_section_free(section);
}

/* ---- what is refused ------------------------------------------------------------------------ */

static void structural(void)
{
    struct hobe_error err = {0};
    struct hobe_stress stress;
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_beam beam = beam_along_x("3333s", 1, section, E, NU, 1);
    hobe_model *model = cantilever(&beam, 0);
    hobe_solution *solution = solve(model, 1);
    check_that(hobe_solution_stress(solution, "beam", 0.5, 0, 0, &stress, &err) == HOBE_BAD_INPUT &&
                   strstr(err.message, "3333s") && strstr(err.message, "resultants"),
               "a rod's law has no stress: %s", err.message);
    check_that(hobe_solution_stress(solution, "beam", 2, 0, 0, &stress, &err) == HOBE_BAD_INPUT,
               "a place off the beam");
    check_that(hobe_solution_stress(solution, "b", 0, 0, 0, &stress, &err) == HOBE_UNKNOWN,
               "no such beam");
    close_scene(solution, model, section);
}

int main(void)
{
    random_start();
    tension("3433", HOBE_MECHANICS_DEFAULT);
    tension("MGD30w", HOBE_MECHANICS_AXIS);
    bending("3433");
    bending("MGD30w");
    torsion("MGD30w", 1, 0);
    torsion("3433w", 2, 0);
    torsion("MGD30w", 1, 1);
    shear();
    layers();
    works();
    rigid();
    turned_scene();
    structural();
    return check_report();
}
