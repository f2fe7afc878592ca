/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Composite sections: parts of one material are the whole; layers and rings of several against
 * closed forms; what is refused. */
#include "check.h"
#include "hobe.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct hobe_material STEEL = {.E = 210e9, .nu = .3, .k2 = 1, .k3 = 1},
                                  ALUMINIUM = {.E = 70e9, .nu = .33, .k2 = 1, .k3 = 1},
                                  FOAM = {.E = 1e9, .nu = .25, .k2 = 1, .k3 = 1};

static double shear_modulus(const struct hobe_material *m)
{
    return m->E / (2 * (1 + m->nu));
}

/* The section, or the end of the test. */
static hobe_section *must(hobe_section *section, const struct hobe_error *err)
{
    if (!section)
        check_stop("%s", err->message);
    return section;
}

/* A composite that takes the sections of its parts. */
static hobe_section *try_composite(int parts, struct hobe_section_part *part,
                                   struct hobe_error *err)
{
    hobe_section *section = hobe_section_composite(parts, part, err);
    for (int k = 0; k < parts; k++)
        hobe_section_free((hobe_section *)part[k].section);
    return section;
}

static struct hobe_section_properties composite(int parts, struct hobe_section_part *part)
{
    struct hobe_error err;
    hobe_section *section = must(try_composite(parts, part, &err), &err);
    const struct hobe_section_properties p = properties_of(section);
    check_that(hobe_section_regions(section) == parts, "a region for each part");
    for (int k = 0; k < parts; k++)
        check_that(hobe_section_material(section, k)->E == part[k].material.E,
                   "region %d has the material of its part", k);
    printf("J %.8e  Iw %.6e  ky %.6f  kz %.6f  %s\n", p.J, p.Iw, p.ky, p.kz,
           hobe_section_text(section));
    hobe_section_free(section);
    return p;
}

/* ---- one material --------------------------------------------------------------------------- */

static void same(const struct hobe_section_properties *p, const struct hobe_section_properties *q,
                 double tolerance, const char *what)
{
    const double size = hypot(q->width, q->height);
    check_relative(p->A, q->A, 1e-13, "A, %s", what);
    check_absolute(p->yc, q->yc, 1e-13 * size, "yc, %s", what);
    check_absolute(p->zc, q->zc, 1e-13 * size, "zc, %s", what);
    check_relative(p->Iyy, q->Iyy, 1e-12, "Iyy, %s", what);
    check_relative(p->Izz, q->Izz, 1e-12, "Izz, %s", what);
    check_absolute(p->Iyz, q->Iyz, 1e-12 * (q->Iyy + q->Izz), "Iyz, %s", what);
    check_relative(p->Wagner, q->Wagner, 1e-3 * tolerance, "Wagner, %s", what);
    check_relative(p->J, q->J, tolerance, "J, %s", what);
    check_relative(p->J_w, q->J_w, tolerance, "J_w, %s", what);
    check_relative(p->Iw, q->Iw, 10 * tolerance, "Iw, %s", what);
    check_relative(p->ky, q->ky, tolerance, "ky, %s", what);
    check_relative(p->kz, q->kz, tolerance, "kz, %s", what);
    check_absolute(p->ys, q->ys, 1e-5 * size, "ys, %s", what);
    check_absolute(p->zs, q->zs, 1e-5 * size, "zs, %s", what);
    check_that(p->width == q->width && fabs(p->height - q->height) < 1e-15, "extent, %s", what);
}

/* Two meshes of one section, each within the accuracy of its corners. */
static void parts_of_one_material(void)
{
    static const struct hobe_profile_sizes I = {
        .height = .215, .width = .1, .flange = .015, .web = .01};
    struct hobe_error err;
    hobe_section *whole = rectangle(.1, .2);
    struct hobe_section_properties q = properties_of(whole);
    hobe_section_free(whole);
    struct hobe_section_part halves[2] = {{rectangle(.1, .1), {0, -.05}, STEEL},
                                          {rectangle(.1, .1), {0, .05}, STEEL}};
    struct hobe_section_properties p = composite(2, halves);
    same(&p, &q, 2e-5, "two halves of a rectangle");
    whole = must(hobe_section_profile(HOBE_PROFILE_I, &I, HOBE_WARPING_SOLVED, &err), &err);
    q = properties_of(whole);
    hobe_section_free(whole);
    struct hobe_section_part walls[3] = {{rectangle(.01, .185), {0, 0}, STEEL},
                                         {rectangle(.1, .015), {0, .1}, STEEL},
                                         {rectangle(.1, .015), {0, -.1}, STEEL}};
    p = composite(3, walls);
    same(&p, &q, 2e-4, "the walls of an I");
    whole = must(hobe_section_profile(HOBE_PROFILE_ANGLE, &I, HOBE_WARPING_SOLVED, &err), &err);
    q = properties_of(whole);
    struct hobe_section_part alone[1] = {{whole, {0, 0}, STEEL}};
    p = composite(1, alone);
    same(&p, &q, 1e-12, "an angle alone, from the origin of its outline");
}

/* ---- layers --------------------------------------------------------------------------------- */

/* Layers across z, from z = 0 upwards, of one width. */
enum { MOST_LAYERS = 3 };
struct layers {
    int count;
    double width, height[MOST_LAYERS];
    const struct hobe_material *material[MOST_LAYERS];
};

static struct hobe_section_properties stack(const struct layers *s)
{
    struct hobe_section_part part[MOST_LAYERS];
    double z = 0;
    for (int k = 0; k < s->count; k++) {
        part[k] = (struct hobe_section_part){
            rectangle(s->width, s->height[k]), {0, z + s->height[k] / 2}, *s->material[k]};
        z += s->height[k];
    }
    return composite(s->count, part);
}

/* The transformed section: EA-weighted centroid and EI, over E_1. */
static void transformed(const struct layers *s, double *zc, double *Iyy, double *Izz)
{
    double z = 0, EA = 0, ES = 0;
    *Iyy = *Izz = 0;
    for (int k = 0; k < s->count; k++) {
        const double h = s->height[k], n = s->material[k]->E / s->material[0]->E;
        EA += n * s->width * h;
        ES += n * s->width * h * (z + h / 2);
        *Iyy += n * s->width * (pow(z + h, 3) - pow(z, 3)) / 3;
        *Izz += n * h * pow(s->width, 3) / 12;
        z += h;
    }
    *zc = ES / EA;
    *Iyy -= ES * ES / EA;
}

/* GJ of two layers over G_1 by Prandtl's function F: div (grad F/G) = -2, F = 0 on the outline, F
 * and F_n/G continuous, GJ = 2 int F dA.  With sines along y, k = n pi/width, n odd, and s from
 * each outer side inwards F_n = b (1 - cosh k s) + a sinh k s with b = 8 G/(n pi k^2); the slopes
 * over G at the interface add up to 0, which gives F_n = f there. */
static double two_layer_torsion(const struct layers *s)
{
    double GJ = 0;
    for (int n = 4001; n > 0; n -= 2) {
        const double k = n * M_PI / s->width;
        double b[2], t[2], load = 0, slope = 0;
        for (int i = 0; i < 2; i++) {
            const double G = shear_modulus(s->material[i]), h = s->height[i];
            b[i] = 8 * G / (n * M_PI * k * k);
            t[i] = tanh(k * h / 2);
            load += b[i] * t[i] / G;
            slope += 1 / (tanh(k * h) * G);
        }
        const double f = load / slope;
        for (int i = 0; i < 2; i++) /* int F_n ds times int sin k y dy = 2/k */
            GJ += 2 * (b[i] * s->height[i] + t[i] * (f - 2 * b[i]) / k) * 2 / k;
    }
    return GJ / shear_modulus(s->material[0]);
}

/* kz of layers: the shear flow tau(z) = int of E z dz from z to the top fills every width alike, so
 * that k = EI^2/(GA int tau^2/G dA), here per width and by Boole's rule, exact for tau^2. */
static double layered_factor(const struct layers *s, double zc)
{
    static const double boole[5] = {7. / 90, 32. / 90, 12. / 90, 32. / 90, 7. / 90};
    double tau = 0, EI = 0, GA = 0, P = 0, z = -zc;
    for (int k = 0; k < s->count; k++) {
        const double h = s->height[k], E = s->material[k]->E, G = shear_modulus(s->material[k]);
        for (int i = 0; i < 5; i++) {
            const double at = z + h * i / 4, here = tau + E * (at * at - z * z) / 2;
            EI += boole[i] * h * E * at * at;
            P += boole[i] * h * here * here / G;
        }
        GA += G * h;
        tau += E * ((z + h) * (z + h) - z * z) / 2;
        z += h;
    }
    return EI * EI / (GA * P);
}

static void layers_of(const struct layers *s, const char *what)
{
    const struct hobe_section_properties p = stack(s);
    double zc, Iyy, Izz;
    transformed(s, &zc, &Iyy, &Izz);
    check_relative(p.zc, zc, 1e-12, "centroid of EA, %s", what);
    check_absolute(p.yc, 0, 1e-14, "centroid of EA, %s", what);
    check_relative(p.Iyy, Iyy, 1e-11, "EIyy, %s", what);
    check_relative(p.Izz, Izz, 1e-11, "EIzz, %s", what);
    check_relative(p.J_w, p.J, 1e-7, "J_w is J, %s", what);
    check_absolute(p.kyz, 0, 1e-5, "kyz, %s", what);
    /* a cubic in each layer, which a triangle or two across it hold to 1e-4 */
    check_relative(p.kz, layered_factor(s, zc), 2e-4, "kz, %s", what);
    if (s->count == 2)
        check_relative(p.J, two_layer_torsion(s), 2e-5, "J, %s", what);
}

static void layers(void)
{
    const struct layers plain = {2, .1, {.08, .12}, {&STEEL, &STEEL}},
                        strip = {2, .05, {.004, .006}, {&STEEL, &ALUMINIUM}},
                        block = {2, .1, {.1, .1}, {&ALUMINIUM, &STEEL}},
                        coated = {2, .1, {.2, .01}, {&FOAM, &STEEL}},
                        sandwich = {3, .1, {.01, .2, .01}, {&ALUMINIUM, &FOAM, &ALUMINIUM}};
    check_relative(two_layer_torsion(&plain), .22868168 * .2 * pow(.1, 3),
                   2e-8, /* half of its last digit */
                   "the series of one material");
    layers_of(&plain, "steel on steel");
    layers_of(&strip, "a bimetal strip");
    layers_of(&block, "a bimetal block");
    layers_of(&coated, "steel on foam");
    layers_of(&sandwich, "a sandwich");
}

/* ---- rings ---------------------------------------------------------------------------------- */

/* A core in a tube: GJ is the sum of the parts', no part warps; polygons of 96 sides, whose polar
 * moment is larger by 1e-7. */
static void core_in_a_tube(void)
{
    struct hobe_error err;
    const double r = .02, R = .05, n = FOAM.E / STEEL.E;
    const double g = shear_modulus(&FOAM) / shear_modulus(&STEEL);
    const double at[2] = {random_real(-1, 1), random_real(-1, 1)};
    struct hobe_section_part part[2] = {
        {must(hobe_section_tube(R, r, &err), &err), {at[0], at[1]}, STEEL},
        {must(hobe_section_circle(r, &err), &err), {at[0], at[1]}, FOAM}};
    const struct hobe_section_properties p = composite(2, part);
    const double I = M_PI / 4 * (pow(R, 4) - pow(r, 4) + n * pow(r, 4));
    check_relative(p.A, M_PI * R * R, 1e-12, "A of core and tube");
    check_absolute(hypot(p.yc - at[0], p.zc - at[1]), 0, 1e-12, "its centroid");
    check_relative(p.Iyy, I, 2e-7, "EIyy of core and tube");
    check_relative(p.Izz, I, 2e-7, "EIzz of core and tube");
    check_relative(p.J, M_PI / 2 * (pow(R, 4) - pow(r, 4) + g * pow(r, 4)), 2e-7,
                   "GJ of core and tube");
    check_that(p.Iw == 0, "core and tube do not warp");
}

/* ---- beams ---------------------------------------------------------------------------------- */

/* EA, EI and GJ of a beam are those of its section; the axis of EA does not couple them. */
static void beams(void)
{
    static const char *const kernels[] = {"MGD30w", "MGD30w3", "3333w", "BE24w"};
    static const struct hobe_material soft = {.E = 30e9, .nu = .1, .k2 = 1, .k3 = 1};
    struct hobe_error err;
    hobe_section *block = rectangle(.1, .1), *plate = rectangle(.2, .03);
    const struct hobe_section_part part[] = {{block, {0, 0}, soft}, {plate, {.02, .065}, STEEL}};
    hobe_section *section = must(hobe_section_composite(2, part, &err), &err);
    const struct hobe_section_properties p = properties_of(section);
    for (int k = 0; k < 4; k++) {
        const struct hobe_element_options options = {
            .kernel = hobe_find_kernel(kernels[k], &err), .section = section, .length = 1};
        double C[HOBE_STRAINS][HOBE_STRAINS];
        hobe_element *element = new_element(&options);
        check_that(!hobe_element_stiffness(element, C, NULL), "its stiffness");
        hobe_element_free(element);
        check_relative(C[HOBE_STRETCH][HOBE_STRETCH], soft.E * .1 * .1 + STEEL.E * .2 * .03, 1e-9,
                       "EA, %s", kernels[k]);
        check_relative(C[HOBE_BEND_Y][HOBE_BEND_Y], soft.E * p.Iyy, 1e-9, "EIyy, %s", kernels[k]);
        check_relative(C[HOBE_BEND_Z][HOBE_BEND_Z], soft.E * p.Izz, 1e-9, "EIzz, %s", kernels[k]);
        check_relative(C[HOBE_TWIST][HOBE_TWIST], shear_modulus(&soft) * p.J_w, 1e-7, "GJ, %s",
                       kernels[k]);
        for (int bend = HOBE_BEND_Y; bend <= HOBE_BEND_Z; bend++)
            check_absolute(C[HOBE_STRETCH][bend] /
                               sqrt(C[HOBE_STRETCH][HOBE_STRETCH] * C[bend][bend]),
                           0, 1e-10, "stretch bends, %s", kernels[k]);
    }
    hobe_section_free(section);
    hobe_section_free(block);
    hobe_section_free(plate);
}

/* ---- refusals ------------------------------------------------------------------------------- */

static void refused(int parts, struct hobe_section_part *part, const char *words)
{
    struct hobe_error err = {0};
    hobe_section *section = try_composite(parts, part, &err);
    check_that(!section && err.status == HOBE_BAD_INPUT && strstr(err.message, words) &&
                   !strchr(err.message, '\n'),
               "refused with \"%s\": %s", words, section ? "accepted" : err.message);
    hobe_section_free(section);
}

static void refusals(void)
{
    static const struct {
        double at[3][2];
        int parts;
        const char *words;
    } bad[] = {
        {{{0, 0}, {.05, 0}}, 2, "parts 1 and 2 overlap"},
        {{{0, 0}, {0, 0}}, 2, "parts 1 and 2 overlap"},
        {{{0, 0}, {.1, 0}, {.15, .1}}, 3, ""},
        {{{0, 0}, {.11, 0}}, 2, "part 2 is apart"},
        {{{0, 0}, {.1, .1}}, 2, "part 2 is apart"}, /* they share a corner */
        {{{0, 0}, {.1, 0}, {.3, 0}}, 3, "part 3 is apart"},
        {{{0, 0}, {NAN, 0}}, 2, "part 2: at must be finite (m), got (nan"},
    };
    struct hobe_error err;
    struct hobe_section_part part[3];
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        for (int k = 0; k < bad[i].parts; k++)
            part[k] = (struct hobe_section_part){
                rectangle(.1, .1), {bad[i].at[k][0], bad[i].at[k][1]}, STEEL};
        if (*bad[i].words)
            refused(bad[i].parts, part, bad[i].words);
        else
            composite(bad[i].parts, part);
    }
    part[0] = (struct hobe_section_part){rectangle(.1, .1), {0, 0}, STEEL};
    part[0].section = must(try_composite(1, part, &err), &err);
    refused(1, part, "part 1: it is a composite section itself");
    part[0] = (struct hobe_section_part){rectangle(.1, .1), {0, 0}, STEEL};
    part[0].material.E = -1;
    refused(1, part, "part 1: E must be > 0");
    refused(0, part, "got 0");
    hobe_section *plain = rectangle(.1, .1);
    check_that(hobe_section_regions(plain) == 1 && !hobe_section_material(plain, 0),
               "a plain section has one region and no material of its own");
    hobe_section_free(plain);
}

int main(void)
{
    random_start();
    parts_of_one_material();
    layers();
    core_in_a_tube();
    beams();
    refusals();
    return check_report();
}
