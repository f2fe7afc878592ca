/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress anywhere in a beam, by the law that its elements have (kernel.h).  The variation of the
 * energy per length,
 *
 *     dW = int eps:C:d(eps) dA + A mean(eps):C_mean:d(mean(eps)),   d(mean) = int m d(eps) dA,
 *
 * has S = C:eps + A m C_mean:mean(eps) at a point, m the weight of the mean there: 1/A, but for
 * composite sections, where it goes with E or G.  The mean of mechanics `axis` has all its weight
 * on the axis, where its stress would be infinite; it is shown spread evenly, which keeps its
 * force.  Where the law is relieved of the strain eta of warping, C has eps - eta + mean(eta) to
 * act on.  The strain shown is eps, that of the displacements. */
#include "stress.h"

#include "element.h"
#include "solution.h"
#include "vector3.h"

#include <string.h>

enum { NORMALS = 3, STRAINS = 6 };

static const int voigt[STRAINS][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

static double double_dot(const double a[STRAINS], const double b[STRAINS])
{
    double sum = 0;
    for (int i = 0; i < STRAINS; i++)
        sum += a[i] * b[i];
    return sum;
}

/* S = C : E */
static void apply(const struct hobe_elasticity *C, const double E[STRAINS], double S[STRAINS])
{
    for (int i = 0; i < NORMALS; i++) {
        S[i] = C->normal[i][0] * E[0] + C->normal[i][1] * E[1] + C->normal[i][2] * E[2];
        S[NORMALS + i] = C->shear[i] * E[NORMALS + i];
    }
}

static void strain_here(const struct around *p, double E[STRAINS])
{
    p->kernel->strain(p->N, p->Nx, (const double(*)[4])p->phi, p->q0, p->u, E);
}

/* What the law takes at its mean where phi is; 0 where it takes nothing. */
static void eta_here(const struct around *p, const struct hobe_law *law, double eta[STRAINS])
{
    if (law->relieved && p->kernel->warping_strain)
        p->kernel->warping_strain(p->N, p->Nx, (const double(*)[4])p->phi, p->q0, p->u, eta);
    else
        memset(eta, 0, STRAINS * sizeof *eta);
}

/* ---- the mean law --------------------------------------------------------------------------- */

/* Sums over a section: of weights, strains times weights, normal strains with E and shear with G.
 */
struct sums {
    double area, E, G, strain[STRAINS], eta[STRAINS];
};

static void add_point(struct around *p, const struct hobe_law *law,
                      const struct hobe_section_point *at, struct sums *sums)
{
    const hobe_section *section = p->place.beam->spec.section;
    double F[3][3], strain[STRAINS], eta[STRAINS];
    p->kernel->section_modes(at->y, at->z, at->f, p->phi);
    const double weight = at->weight * around_gradient(p, F);
    const double E = weight * hobe_section_E(section, at->region);
    const double G = weight * hobe_section_G(section, at->region);
    strain_here(p, strain);
    eta_here(p, law, eta);
    sums->area += weight;
    sums->E += E;
    sums->G += G;
    for (int i = 0; i < STRAINS; i++) {
        sums->strain[i] += (i < NORMALS ? E : G) * strain[i];
        sums->eta[i] += (i < NORMALS ? E : G) * eta[i];
    }
}

/* The sums over the points that the element itself has; or over its point on the axis. */
static enum hobe_status sum_up(struct stress_section *s, int on_axis, struct sums *sums,
                               struct hobe_error *err)
{
    struct around *p = &s->around;
    const struct hobe_beam *spec = &p->place.beam->spec;
    const struct hobe_section_place place = around_section_place(p->place);
    struct hobe_rule rule;
    *sums = (struct sums){0};
    const enum hobe_status status = (on_axis ? hobe_axis_rule : hobe_section_rule)(
        spec->section, p->kernel, spec->integration, &place, &rule, err);
    for (int i = 0; !status && i < rule.rule.points; i++)
        add_point(p, s->law, rule.point + i, sums);
    hobe_rule_free(&rule);
    return status;
}

/* Whether the law asks for the mean strain at all. */
static int has_mean(const struct hobe_law *law)
{
    static const struct hobe_elasticity none;
    return law->relieved || memcmp(&law->mean, &none, sizeof none) != 0;
}

static enum hobe_status set_mean(struct stress_section *s, int on_axis, struct hobe_error *err)
{
    struct sums whole, axis;
    double strain[STRAINS];
    enum hobe_status status = sum_up(s, 0, &whole, err);
    if (!status && on_axis)
        status = sum_up(s, 1, &axis, err);
    if (status)
        return status;
    const struct sums *normal = on_axis ? &axis : &whole;
    for (int i = 0; i < NORMALS; i++) {
        strain[i] = normal->strain[i] / normal->E;
        strain[NORMALS + i] = whole.strain[NORMALS + i] / whole.G;
    }
    for (int i = 0; i < STRAINS; i++)
        s->eta[i] = whole.eta[i] / (i < NORMALS ? whole.E : whole.G);
    apply(&s->law->mean, (const double *)strain, s->mean);
    s->energy = double_dot((const double *)strain, s->mean) / 2;
    s->mean_E = on_axis ? 0 : whole.E / whole.area;
    s->mean_G = whole.G / whole.area;
    return HOBE_OK;
}

/* ---- sections ------------------------------------------------------------------------------- */

enum hobe_status stress_section(const hobe_solution *solution, const char *name, double at,
                                struct stress_section *s, struct hobe_error *err)
{
    struct place place;
    double F[3][3];
    const struct beam *beam = around_find(solution->model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    const hobe_element *element = beam_law(beam, place.element);
    const enum hobe_mechanics mechanics = hobe_element_mechanics(element);
    if (mechanics == HOBE_MECHANICS_STRUCTURAL)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "beam \"%s\" has no stress at a point: the law of element %s is one of "
                         "section forces; ask for its resultants at the ends of elements",
                         name, beam->spec.kernel->name);
    *s = (struct stress_section){.law = hobe_element_law(element)};
    around_look(solution->model, solution->u, place, &s->around);
    around_axis(&s->around);
    around_gradient(&s->around, F);
    around_axes((const double(*)[3])F, s->axes);
    return has_mean(s->law) ? set_mean(s, mechanics == HOBE_MECHANICS_AXIS, err) : HOBE_OK;
}

/* ---- points --------------------------------------------------------------------------------- */

/* Adds the mean law's stress at a point of a region. */
static void add_mean(const struct stress_section *s, int region, double S[STRAINS])
{
    const hobe_section *section = s->around.place.beam->spec.section;
    const double normal = s->mean_E > 0 ? hobe_section_E(section, region) / s->mean_E : 1;
    const double shear = s->mean_G > 0 ? hobe_section_G(section, region) / s->mean_G : 1;
    for (int i = 0; i < NORMALS; i++) {
        S[i] += normal * s->mean[i];
        S[NORMALS + i] += shear * s->mean[NORMALS + i];
    }
}

/* to = A s A' of symmetric tensors */
static void transform(const double A[3][3], const double s[STRAINS], double factor,
                      double to[STRAINS])
{
    double full[3][3];
    for (int i = 0; i < STRAINS; i++)
        full[voigt[i][0]][voigt[i][1]] = full[voigt[i][1]][voigt[i][0]] = s[i];
    for (int i = 0; i < STRAINS; i++) {
        const double *a = A[voigt[i][0]], *b = A[voigt[i][1]];
        to[i] = 0;
        for (int k = 0; k < 3; k++)
            to[i] += factor * a[k] * dot3(full[k], b);
    }
}

static double von_mises(const double s[STRAINS])
{
    return sqrt((pow(s[0] - s[1], 2) + pow(s[1] - s[2], 2) + pow(s[2] - s[0], 2)) / 2 +
                3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

/* Where phi is. */
static void stress_here(const struct stress_section *s, int region, struct hobe_stress *stress)
{
    double F[3][3], felt[STRAINS], eta[STRAINS];
    strain_here(&s->around, stress->strain);
    eta_here(&s->around, s->law, eta);
    for (int i = 0; i < STRAINS; i++)
        felt[i] = stress->strain[i] - eta[i] + s->eta[i];
    apply(s->law->region + region, (const double *)felt, stress->S);
    stress->energy = double_dot(stress->S, felt) / 2 + s->energy;
    add_mean(s, region, stress->S);
    around_gradient(&s->around, F);
    transform((const double(*)[3])F, stress->S, 1 / determinant((const double(*)[3])F),
              stress->cauchy);
    transform(s->axes, stress->cauchy, 1, stress->section);
    stress->mises = von_mises(stress->cauchy);
}

enum hobe_status stress_at(struct stress_section *s, double y, double z, int region,
                           struct hobe_stress *stress, struct hobe_error *err)
{
    const enum hobe_status status = around_modes(&s->around, y, z, err);
    if (!status)
        stress_here(s, region, stress);
    return status;
}

void stress_at_point(struct stress_section *s, const struct hobe_section_point *point,
                     struct hobe_stress *stress)
{
    s->around.kernel->section_modes(point->y, point->z, point->f, s->around.phi);
    stress_here(s, point->region, stress);
}

enum hobe_status hobe_solution_stress(const hobe_solution *solution, const char *beam, double at,
                                      double y, double z, struct hobe_stress *stress,
                                      struct hobe_error *err)
{
    struct stress_section s;
    const enum hobe_status status = stress_section(solution, beam, at, &s, err);
    if (status)
        return status;
    const int region = hobe_section_region(s.around.place.beam->spec.section, y, z);
    return stress_at(&s, y, z, region, stress, err);
}
