/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams as solids: wedges that fill the beam and stand upright, displacements and stresses of the
 * solution at their nodes. */
#include "check.h"
#include "scene.h"
#include "solid.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- wedges --------------------------------------------------------------------------------- */

/* The nodes of a wedge as pairs: of a triangle's six nodes, and of a line's three, 0 1 2 at its
 * start, end and middle. */
static const int part[HOBE_WEDGE][2] = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1},
                                        {3, 0}, {4, 0}, {5, 0}, {3, 1}, {4, 1}, {5, 1},
                                        {0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {5, 2}};

/* N and its derivatives by two barycentric coordinates and by t in [0,1]. */
static void shape(const double a[2], double t, double dN[HOBE_WEDGE][3])
{
    const double L[3] = {1 - a[0] - a[1], a[0], a[1]};
    static const double dL[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    const double line[3][2] = {{(1 - t) * (1 - 2 * t), 4 * t - 3},
                               {t * (2 * t - 1), 4 * t - 1},
                               {4 * t * (1 - t), 4 - 8 * t}};
    double N[6], dn[6][2];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        N[i] = L[i] * (2 * L[i] - 1);
        N[3 + i] = 4 * L[i] * L[j];
        for (int d = 0; d < 2; d++) {
            dn[i][d] = (4 * L[i] - 1) * dL[i][d];
            dn[3 + i][d] = 4 * (dL[i][d] * L[j] + L[i] * dL[j][d]);
        }
    }
    for (int n = 0; n < HOBE_WEDGE; n++) {
        const double *l = line[part[n][1]];
        for (int d = 0; d < 2; d++)
            dN[n][d] = dn[part[n][0]][d] * l[0];
        dN[n][2] = N[part[n][0]] * l[1];
    }
}

/* Volume of a wedge and the least of its Jacobian at the points of the rule: of degree 4 in the
 * triangle (Dunavant) and 5 along. */
static double volume_of(const struct hobe_solid *solid, int cell, int deformed, double *least)
{
    static const double triangle[2][2] = {{0.445948490915965, 0.223381589678011},
                                          {0.091576213509771, 0.109951743655322}};
    const double gauss[3][2] = {
        {0.5 - sqrt(0.15), 5 / 18.0}, {0.5, 4 / 9.0}, {0.5 + sqrt(0.15), 5 / 18.0}};
    double volume = 0;
    for (int k = 0; k < 18; k++) {
        const double q = triangle[k % 2][0], *g = gauss[k / 2 % 3];
        const double at[3][2] = {{q, q}, {1 - 2 * q, q}, {q, 1 - 2 * q}};
        double dN[HOBE_WEDGE][3], J[3][3] = {{0}}, normal[3];
        shape(at[k / 6], g[0], dN);
        for (int n = 0; n < HOBE_WEDGE; n++)
            for (int d = 0; d < 3; d++)
                for (int a = 0; a < 3; a++) {
                    const int p = solid->cell[cell][n];
                    J[d][a] +=
                        dN[n][d] * (solid->point[p][a] + deformed * solid->displacement[p][a]);
                }
        cross3(J[0], J[1], normal);
        const double det = dot3(normal, J[2]);
        *least = fmin(*least, det);
        volume += triangle[k % 2][1] / 2 * g[1] * det;
    }
    return volume;
}

static double volume(const struct hobe_solid *solid, int deformed, const char *what)
{
    double sum = 0, least = INFINITY;
    for (int c = 0; c < solid->cells; c++)
        sum += volume_of(solid, c, deformed, &least);
    check_that(least > 0, "%s: no wedge is turned over, least Jacobian %g", what, least);
    return sum;
}

/* ---- beams ---------------------------------------------------------------------------------- */

static struct hobe_solid solid_of(const hobe_solution *solution)
{
    struct hobe_error err;
    struct hobe_solid solid;
    if (hobe_solution_solid(solution, &solid, &err))
        check_stop("%s", err.message);
    return solid;
}

/* A straight beam, stretched by a homogeneous field (nu = 0): the volume is A L, to the chords of
 * circles; the stress P/A everywhere. */
static void stretched(hobe_section *section, double tolerance, const char *what)
{
    const double L = 2, P = 1e6;
    const struct hobe_section_properties s = properties_of(section);
    const struct hobe_beam beam = beam_along_x("MGD30", 2, section, 1e9, 0, L);
    hobe_model *model = cantilever(&beam, 1);
    add_force(model, "beam", 1, P, 0, 0);
    hobe_solution *solution = solve(model, 1);
    struct hobe_solid solid = solid_of(solution);
    const double tip = point_of(solution, "beam", 1, 0, 0).u[0];
    check_relative(volume(&solid, 0, what), s.A * L, tolerance, "%s: volume", what);
    check_relative(volume(&solid, 1, what), s.A * (L + tip), tolerance, "%s: stretched", what);
    check_that(solid.stress != NULL, "%s: it has stress", what);
    for (int p = 0; p < solid.points; p++)
        if (!check_relative(solid.stress[p].mises, P / s.A, 1e-8, "%s: von Mises", what) ||
            !check_absolute(solid.displacement[p][0], solid.point[p][0] / L * tip, 1e-10 * tip,
                            "%s: displacement", what))
            break;
    hobe_solid_free(&solid);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context, (void)err;
    memcpy(r, (const double[3]){sin(t), 1 - cos(t), 0}, 3 * sizeof *r);
    return HOBE_OK;
}

/* A ring sector's volume is A L; parabolas instead of arcs of 1/20 rad miss 1e-7 of it.  3333s has
 * no stress. */
static void curved(const char *element)
{
    hobe_section *section = rectangle(0.1, 0.2);
    hobe_curve *curve = curve_of(arc, NULL, NULL);
    struct hobe_beam beam = beam_along_x(element, 10, section, 1e9, 0.3, 1);
    beam.curve = curve;
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, 100);
    hobe_solution *solution = solve(model, 1);
    struct hobe_solid solid = solid_of(solution);
    check_relative(volume(&solid, 0, element), 0.02, 1e-6, "%s: volume of an arc", element);
    volume(&solid, 1, element);
    check_that(!solid.stress == !strcmp(element, "3333s"), "%s: stress where there is one",
               element);
    hobe_solid_free(&solid);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
    hobe_curve_free(curve);
}

static hobe_section *I(double height)
{
    struct hobe_error err;
    const struct hobe_profile_sizes sizes = {
        .height = height, .width = 0.1, .flange = 0.015, .web = 0.01};
    return hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err);
}

/* An I-beam of growing height, whose mesh follows it: the area is linear. */
static void tapering(void)
{
    hobe_section *section = tapered(I(0.16), I(0.24));
    const struct hobe_beam beam = beam_along_x("MGD30", 1, section, 1e9, 0.3, 2);
    hobe_model *model = cantilever(&beam, 0);
    hobe_solution *solution = solve(model, 1);
    struct hobe_solid solid = solid_of(solution);
    /* the height goes through interpolation of the outline along the beam, to 1e-9 */
    check_relative(volume(&solid, 0, "taper"), 2 * (2 * 0.1 * 0.015 + 0.17 * 0.01), 1e-8,
                   "taper: volume");
    hobe_solid_free(&solid);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    struct hobe_error err;
    stretched(rectangle(0.1, 0.2), 1e-8, "rectangle");
    stretched(I(0.2), 1e-8, "I");
    /* sides are parabolas through points of the circle, an angle of pi/24 each: pi^4/24^4/30 */
    stretched(hobe_section_circle(0.1, &err), 2e-5, "circle");
    stretched(hobe_section_tube(0.1, 0.08, &err), 2e-5, "tube");
    curved("MGD30w");
    curved("3333s");
    tapering();
    return check_report();
}
