/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every element at rest on every kind of rectangle with every mechanics: either refused by name, or
 * six zero and no negative eigenvalue, and the stiffness of section theory as far as the element's
 * modes can hold it.  Prints the table of EA, EIyy, EIzz, GJ over section theory. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 210e9, NU = 0.3;

struct subject {
    const struct hobe_kernel *kernel;
    const hobe_section *section;
    struct hobe_section_properties p;
    enum hobe_mechanics mechanics;
    char name[100];
};

static int has_mode(const struct hobe_kernel *k, const char *name)
{
    int found = 0;
    for (int m = 0; m < k->modes; m++)
        found |= strcmp(k->mode[m], name) == 0;
    return found;
}

static int is_structural(const struct hobe_kernel *k)
{
    return strcmp(k->mechanics, "structural") == 0;
}

/* ---- what section theory says of a set of modes
 * -------------------------------------------------- */

/* `axis` holds the Poisson coupling on the axis alone.  A section that can strain unevenly in its
 * plane then contracts there and nowhere else, at the price of
 *
 *     v = a y + p y^3/6 + q y z^2/2,   w = b z + r z^3/6 + s z y^2/2
 *
 * (no other cubic mode helps), of which wy and wz hold the terms p and r alone.  Energy per length
 * under unit strain of the axis, least over the amplitudes: 1/2 int E (eyy^2 + ezz^2) + G gyz^2 dA
 * + 1/2 A e:Enu:e on the axis, e = (1, a, b). */
static double axis_stretch(const struct hobe_section_properties *p, int mixed_cubics)
{
    const double G = E / (2 * (1 + NU)), lambda = E * NU / ((1 + NU) * (1 - 2 * NU));
    const double y2 = p->Izz / p->A, z2 = p->Iyy / p->A; /* means of powers over a rectangle */
    const double y4 = 9 * y2 * y2 / 5, z4 = 9 * z2 * z2 / 5, yz = y2 * z2;
    /* unknowns a, p, q, b, r, s; eyy = a + p y^2/2 + q z^2/2; ezz alike; gyz = (q + s) y z */
    const double yy[3][3] = {
        {1, y2 / 2, z2 / 2}, {y2 / 2, y4 / 4, yz / 4}, {z2 / 2, yz / 4, z4 / 4}};
    const double zz[3][3] = {
        {1, z2 / 2, y2 / 2}, {z2 / 2, z4 / 4, yz / 4}, {y2 / 2, yz / 4, y4 / 4}};
    double K[6][7] = {{0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            K[i][j] = E * yy[i][j];
            K[3 + i][3 + j] = E * zz[i][j];
        }
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            K[2 + 3 * i][2 + 3 * j] += G * yz;
            K[3 * i][3 * j] += i == j ? 2 * lambda * NU : lambda;
        }
    for (int i = 0; i < 6 && !mixed_cubics; i++)
        for (int j = 2; j < 6; j += 3)
            K[i][j] = K[j][i] = i == j; /* q = s = 0 */
    K[0][6] = K[3][6] = -lambda;        /* the right-hand side: the axis' unit strain */
    for (int i = 0; i < 6; i++)         /* elimination; the matrix is positive definite */
        for (int j = i + 1; j < 6; j++)
            for (int c = 6; c >= i; c--)
                K[j][c] -= K[j][i] / K[i][i] * K[i][c];
    double x[6], stiffness = E + 2 * lambda * NU;
    for (int i = 5; i >= 0; i--) {
        x[i] = K[i][6];
        for (int j = i + 1; j < 6; j++)
            x[i] -= K[i][j] * x[j];
        x[i] /= K[i][i];
    }
    stiffness += lambda * (x[0] + x[3]);
    return stiffness / E;
}

/* EA over section theory: 1 but for `axis` with cubic modes, which eat up to 21 %. */
static void check_stretch(const struct subject *s, double ratio)
{
    double expected = 1;
    if (s->mechanics == HOBE_MECHANICS_AXIS &&
        (has_mode(s->kernel, "yyy") || has_mode(s->kernel, "wy")))
        expected = axis_stretch(&s->p, has_mode(s->kernel, "yzz"));
    check_relative(ratio, expected, 1e-9, "EA of %s", s->name);
}

/* EI over section theory: 1, but `full` locks where the section cannot bend in its plane: a section
 * that keeps its outline is stiffer by (1-nu)/((1+nu)(1-2nu)), one that has w only in between. */
static void check_bending(const struct subject *s, double ratio, const char *what)
{
    const double locked = (1 - NU) / ((1 + NU) * (1 - 2 * NU));
    if (s->mechanics != HOBE_MECHANICS_FULL || has_mode(s->kernel, "yy"))
        check_relative(ratio, 1, 1e-9, "%s of %s", what, s->name);
    else if (has_mode(s->kernel, "w"))
        check_that(ratio > 1 && ratio < locked, "%s of %s lies between 1 and %g: %.10g", what,
                   s->name, locked, ratio);
    else
        check_relative(ratio, locked, 1e-9, "%s of %s", what, s->name);
}

/* GJ: the section's where the law is a rod's; I_p without warping, 4 Iyy Izz/I_p with the mode yz,
 * J_w with w.  The modes of the quartic set come closer to J than yz alone, from above. */
static void check_torsion(const struct subject *s, double ratio)
{
    const double Ip = s->p.Iyy + s->p.Izz, yz = 4 * s->p.Iyy * s->p.Izz / Ip;
    if (is_structural(s->kernel))
        check_relative(ratio, 1, 1e-9, "GJ of %s", s->name);
    else if (has_mode(s->kernel, "w")) {
        check_relative(ratio * s->p.J, s->p.J_w, 1e-9, "GJ of %s is G J_w", s->name);
        check_relative(ratio, 1, 1e-6, "GJ of %s", s->name);
    } else if (has_mode(s->kernel, "yyyz"))
        check_that(ratio > 1 && ratio < yz / s->p.J, "GJ of %s: %.10g", s->name, ratio);
    else if (has_mode(s->kernel, "yz"))
        check_relative(ratio * s->p.J, yz, 1e-9, "GJ of %s is 4 G Iyy Izz/I_p", s->name);
    else
        check_relative(ratio * s->p.J, Ip, 1e-9, "GJ of %s is G I_p", s->name);
}

/* ---- one element ----------------------------------------------------------------------------- */

static void check_refusal(const struct subject *s, const struct hobe_error *err)
{
    check_that(err->status == HOBE_UNSTABLE && strstr(err->message, s->kernel->name) &&
                   strstr(err->message, hobe_mechanics_name(s->mechanics)) &&
                   strstr(err->message, " negative eigenvalue"),
               "%s is refused by name: %s", s->name, err->message);
    printf("%-34s refused: %.60s...\n", s->name, err->message);
}

/* The vectors of modes that a rectangle in closed form has: all but those of distortion. */
static int kept_vectors(const struct hobe_kernel *kernel)
{
    int kept = 0;
    for (int v = 0; v < kernel->vectors; v++) {
        const char *mode = kernel->mode[kernel->vector[v].mode];
        kept += mode[0] != 'v' && (mode[0] != 'w' || strchr("yz", mode[1]));
    }
    return kept;
}

static void check_element(const struct subject *s, const hobe_element *element)
{
    struct hobe_rest rest;
    double C[HOBE_STRAINS][HOBE_STRAINS], ratio[HOBE_STRAINS];
    const double G = E / (2 * (1 + NU));
    const double theory[] = {E * s->p.A, E * s->p.Iyy, E * s->p.Izz, G * s->p.J};
    hobe_element_rest(element, &rest);
    check_that(rest.zero == 6 && rest.negative == 0, "%s: %d zero, %d negative eigenvalues",
               s->name, rest.zero, rest.negative);
    check_that(rest.zero + rest.positive == 3 * kept_vectors(s->kernel), "%s: no mode is left out",
               s->name);
    check_that(!hobe_element_stiffness(element, C, NULL), "its stiffness");
    for (int i = 0; i < HOBE_STRAINS; i++)
        check_relative(rest.share[i], ratio[i] = C[i][i] / theory[i], 1e-8, /* 30 heights long */
                       "share %d of the section's stiffness, %s", i, s->name);
    for (int i = 0; i < HOBE_STRAINS; i++)
        for (int j = 0; j < i; j++)
            check_absolute(C[i][j] / sqrt(C[i][i] * C[j][j]), 0, 1e-12, "%s: coupling %d %d",
                           s->name, i, j);
    check_stretch(s, ratio[HOBE_STRETCH]);
    check_bending(s, ratio[HOBE_BEND_Y], "EIyy");
    check_bending(s, ratio[HOBE_BEND_Z], "EIzz");
    check_torsion(s, ratio[HOBE_TWIST]);
    printf("%-34s %.8f %.8f %.8f %11.8f  %.1e\n", s->name, ratio[HOBE_STRETCH], ratio[HOBE_BEND_Y],
           ratio[HOBE_BEND_Z], ratio[HOBE_TWIST], rest.smallest / rest.largest);
}

static hobe_element *make(const struct subject *s, double heights, struct hobe_error *err)
{
    const struct hobe_element_options options = {
        .kernel = s->kernel,
        .section = s->section,
        .material = {.E = E, .nu = NU, .k2 = 1, .k3 = 1},
        .length = heights * fmax(s->p.width, s->p.height),
        .mechanics = s->mechanics,
    };
    return hobe_element_new(&options, err);
}

static void try_element(struct subject *s, double heights)
{
    struct hobe_error err;
    hobe_element *element = make(s, heights, &err);
    snprintf(s->name, sizeof s->name, "%-9s %-7s %.4g x %.4g, %gh", s->kernel->name,
             hobe_mechanics_name(s->mechanics), s->p.width, s->p.height, heights);
    if (element)
        check_element(s, element);
    else
        check_refusal(s, &err);
    hobe_element_free(element);
}

/* Two heights long on every section; on the square also short with the law that may fail there, and
 * long with the default one. */
static void every_combination(void)
{
    static const double sizes[][2] = {{0.1, 0.1}, {0.1, 0.2}, {3.2024e-3, 12.377e-3}, {0.2, 0.02}};
    printf("%-34s %-10s %-10s %-10s %-11s  softest/stiffest\n",
           "element, mechanics, section, length", "EA", "EIyy", "EIzz", "GJ");
    for (int i = 0; i < 4; i++) {
        hobe_section *section = rectangle(sizes[i][0], sizes[i][1]);
        struct subject s = {.section = section, .p = properties_of(section)};
        for (int k = 0; hobe_kernels()[k]; k++)
            for (int m = HOBE_MECHANICS_AVERAGE; m <= HOBE_MECHANICS_STRUCTURAL; m++) {
                s.kernel = hobe_kernels()[k];
                s.mechanics = (enum hobe_mechanics)m;
                if ((m == HOBE_MECHANICS_STRUCTURAL) != is_structural(s.kernel))
                    continue;
                try_element(&s, 2);
                if (i == 0 && (m == HOBE_MECHANICS_AXIS || m == HOBE_MECHANICS_STRUCTURAL))
                    try_element(&s, 0.2);
                if (i == 0 && (m == HOBE_MECHANICS_AVERAGE || m == HOBE_MECHANICS_STRUCTURAL))
                    try_element(&s, 30);
            }
        hobe_section_free(section);
    }
}

/* A very short B4 gains energy by straining its axis, so that the refusal is seen to work; with the
 * default law the same element stands. */
static void indefinite_is_refused(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.1);
    struct subject s = {.section = section,
                        .p = properties_of(section),
                        .kernel = hobe_find_kernel("B4", &err),
                        .mechanics = HOBE_MECHANICS_AXIS,
                        .name = "a short B4"};
    hobe_element *element = make(&s, 0.2, &err);
    check_that(!element && err.status == HOBE_UNSTABLE, "a short B4 with `axis` is refused");
    check_that(strstr(err.message, "1 negative eigenvalue beside 6 zero and 89 positive") != NULL,
               "the inertia is named: %s", err.message);
    hobe_element_free(element);
    s.mechanics = HOBE_MECHANICS_DEFAULT;
    element = make(&s, 0.2, &err);
    check_that(element && hobe_element_mechanics(element) == HOBE_MECHANICS_AVERAGE,
               "the default law is `average` and stands");
    hobe_element_free(element);
    hobe_section_free(section);
}

/* Too few points leave motions without energy: seen, and said by the model. */
static void spurious_modes_are_noted(void)
{
    static const char *const names[] = {"34X3", "B4"};
    hobe_section *section = rectangle(0.1, 0.1);
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x(names[i], 1, section, E, NU, 0.2);
        struct hobe_error err;
        beam.integration = HOBE_INTEGRATION_PAPER;
        hobe_model *model = cantilever(&beam, 0);
        const enum hobe_status status = hobe_model_build(model, &err);
        const char *note = hobe_model_note(model, 0);
        check_that(!status && note && strstr(note, "14 zero-energy modes") &&
                       strstr(note, names[i]),
                   "%s with 3 x 3 x 3 points: %s", names[i], note ? note : err.message);
        const char *more = note ? hobe_model_note(model, 1) : NULL;
        check_that(more && strstr(more, "times the GJ of its section") &&
                       !hobe_model_note(model, 2),
                   "a second note tells of torsion: %s", more ? more : "none");
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* A beam that is stiffer or softer than its section says so; one that is as stiff says nothing. */
static void wrong_stiffness_is_noted(void)
{
    static const struct {
        const char *element;
        enum hobe_mechanics mechanics;
        const char *note; /* NULL: none */
    } beams[] = {
        {"MGD30w", HOBE_MECHANICS_AVERAGE, NULL},
        {"3333s", HOBE_MECHANICS_STRUCTURAL, NULL},
        {"3333", HOBE_MECHANICS_AVERAGE, "average has 1.186 times the GJ of its section"},
        {"MGD30", HOBE_MECHANICS_FULL,
         "full has 1.346 times the EIyy, 1.346 times the EIzz, 1.186 times the GJ of its section"},
        {"MGD30w-II", HOBE_MECHANICS_AXIS, "axis has 0.8425 times the EA of its section"},
    };
    hobe_section *section = rectangle(0.1, 0.1);
    for (size_t i = 0; i < sizeof beams / sizeof *beams; i++) {
        struct hobe_beam beam = beam_along_x(beams[i].element, 1, section, E, NU, 0.2);
        struct hobe_error err;
        beam.mechanics = beams[i].mechanics;
        hobe_model *model = cantilever(&beam, 0);
        const enum hobe_status status = hobe_model_build(model, &err);
        const char *note = hobe_model_note(model, 0);
        check_that(!status && (beams[i].note ? note && strstr(note, beams[i].note) : !note),
                   "%s: %s", beams[i].element,
                   note     ? note
                   : status ? err.message
                            : "no note");
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

int main(void)
{
    every_combination();
    indefinite_is_refused();
    spurious_modes_are_noted();
    wrong_stiffness_is_noted();
    return check_report();
}
