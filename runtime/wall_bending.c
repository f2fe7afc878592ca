/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether thin walls keep their outline in torsion.  What bends them is in hobe.h, at
 * hobe_section_wall_bending. */
#include "around.h"
#include "solution.h"
#include "vector3.h"

#include <stdio.h>
#include <string.h>

/* Of the torque: less is within what else a beam neglects. */
static const double NOTICEABLE = 0.05;

/* Twist rate times the section's extent, rad.  A square tube of sides b loses
 * (1 - nu)/15 (kappa b^2/t)^2 of its torque: there less than NOTICEABLE while b < 1400 t; flat
 * tubes lose more, to the same power. */
static const double SLIGHT = 1e-3;

/* Twist rates of a beam that is twisted evenly differ by the tolerance of the iteration. */
static const double TIE = 1 + 1e-6;

/* Adds weight times d_y'.d_z and -d_z'.d_y to rate[2], d_y and d_z the section's slopes, of the
 * reference or, where u is given, of the state: the twist rate where they are orthonormal, which
 * small strain leaves them. */
static void add_twist(const struct around *p, const double *u, double weight, double rate[2])
{
    double d[2][3] = {{0}}, d_x[2][3] = {{0}};
    for (int v = 0; v < p->kernel->vectors; v++) {
        const int slope = p->kernel->vector[v].mode - 1; /* modes are 1, y, z, ... */
        for (int a = 0; a < 3 && (slope == 0 || slope == 1); a++) {
            const double q = p->q0[3 * v + a] + (u ? u[3 * v + a] : 0);
            d[slope][a] += p->N[v] * q;
            d_x[slope][a] += p->Nx[v] * q;
        }
    }
    rate[0] += weight * dot3(d_x[0], d[1]);
    rate[1] -= weight * dot3(d_x[1], d[0]);
}

/* The mean of the twist rate over an element, less that of the reference; by the slope that says
 * less, since a moment may turn the other alone in the element it acts on. */
static double mean_twist_rate(const hobe_solution *solution, const struct beam *beam, int e)
{
    const struct hobe_invariants *inv = hobe_element_invariants(beam_law(beam, e));
    double rate[2] = {0, 0}, length = 0;
    for (int g = 0; g < inv->stations; g++) {
        struct around p;
        around_look(solution->model, solution->u, (struct place){beam, e, inv->xi[g]}, &p);
        add_twist(&p, p.u, inv->wx[g], rate);
        add_twist(&p, NULL, -inv->wx[g], rate);
        length += inv->wx[g]; /* structural elements have two rules of it */
    }
    return rate[fabs(rate[1]) < fabs(rate[0])] / length;
}

/* The first element with the greatest, less than TIE times which is no more; sets at and
 * twist_rate.
 */
static int most_twisted(const hobe_solution *solution, const struct beam *beam,
                        struct hobe_wall_bending *b)
{
    int most = 0;
    b->twist_rate = 0;
    for (int e = 0; e < beam->spec.elements; e++) {
        const double rate = mean_twist_rate(solution, beam, e);
        if (fabs(rate) > TIE * fabs(b->twist_rate)) {
            b->twist_rate = rate;
            most = e;
        }
    }
    b->at = (most + 0.5) / beam->spec.elements;
    return most;
}

static int has_mode(const struct hobe_kernel *kernel, const char *name)
{
    for (int m = 0; m < kernel->modes; m++)
        if (!strcmp(kernel->mode[m], name))
            return 1;
    return 0;
}

/* Sets loss and limit_torque by the twist rate, on the section where that is. */
static enum hobe_status estimate(const struct beam *beam, const hobe_section *section,
                                 struct hobe_wall_bending *b, struct hobe_error *err)
{
    const struct hobe_material *own = hobe_section_material(section, 0);
    const struct hobe_material *m = own ? own : &beam->spec.material;
    const double G = m->E / (2 * (1 + m->nu)), GJ = G * section->properties.J;
    const double Wagner = m->E * section->properties.Wagner / 2;
    double c;
    const enum hobe_status status = hobe_section_wall_bending(section, &c, err);
    if (status)
        return status;
    const double walls = 2 * c * (1 - m->nu * m->nu) * G * G / m->E;
    const double square = b->twist_rate * b->twist_rate;
    const int bends = has_mode(beam->kernel, "v2y") && has_mode(beam->kernel, "v2z");
    b->loss = bends ? 0 : walls * square / (GJ + Wagner * square);
    b->limit_torque = walls > Wagner ? 2 * GJ / 3 * sqrt(GJ / (3 * (walls - Wagner))) : INFINITY;
    return HOBE_OK;
}

static enum hobe_status estimate_there(const struct beam *beam, struct hobe_wall_bending *b,
                                       struct hobe_error *err)
{
    const hobe_section *section = beam->spec.section;
    if (!hobe_section_varies(section))
        return estimate(beam, section, b, err);
    hobe_section *there = hobe_section_at(section, b->at, err);
    const enum hobe_status status = there ? estimate(beam, there, b, err)
                                    : err ? err->status
                                          : HOBE_NO_MEMORY;
    hobe_section_free(there);
    return status;
}

/* Sets the torque at the end of the most twisted element. */
static enum hobe_status cut(const hobe_solution *solution, const struct beam *beam, int element,
                            struct hobe_wall_bending *b, struct hobe_error *err)
{
    struct hobe_resultants resultants;
    const enum hobe_status status =
        hobe_solution_resultants(solution, beam->name, (element + 1.0) / beam->spec.elements,
                                 HOBE_CUT_FORCES, &resultants, err);
    b->torque = status ? 0 : resultants.moment[0];
    return status;
}

enum hobe_status hobe_solution_wall_bending(const hobe_solution *solution, const char *name,
                                            struct hobe_wall_bending *bending,
                                            struct hobe_error *err)
{
    const struct beam *beam = model_find_beam(solution->model, name, NULL, err);
    if (!beam)
        return HOBE_UNKNOWN;
    const int element = most_twisted(solution, beam, bending);
    const enum hobe_status status = estimate_there(beam, bending, err);
    return status ? status : cut(solution, beam, element, bending, err);
}

/* ---- the warning ---------------------------------------------------------------------------- */

static void tell(const struct beam *beam, const struct hobe_wall_bending *b,
                 enum hobe_warning warning, char *text, size_t size)
{
    char limit[80] = "";
    if (warning == HOBE_WARNING_COLLAPSED)
        snprintf(text, size,
                 "beam %s: at %.3g of its length its torque, %.4g N m, is beyond about %.3g N m, "
                 "where the bent walls give way and the outline collapses: this result means "
                 "nothing; use less load, or a solid or shell model",
                 beam->name, b->at, fabs(b->torque), b->limit_torque);
    if (warning != HOBE_WARNING_BENDS)
        return;
    if (b->limit_torque < INFINITY)
        snprintf(limit, sizeof limit, ", and at about %.3g N m the outline collapses",
                 b->limit_torque);
    snprintf(text, size,
             "beam %s: at %.3g of its length a torque of %.4g N m twists it by %.3g rad/m, which "
             "bends its walls; element %s keeps them straight and is about %.2g %% too stiff "
             "at that twist%s: use a solid or shell model or, in a long beam, an element with v2y "
             "and v2z",
             beam->name, b->at, fabs(b->torque), fabs(b->twist_rate), beam->spec.kernel->name,
             100 * b->loss, limit);
}

/* Whether walls could matter at that twist rate and the element would not find that itself. */
static int worth_asking(const struct beam *beam, double rate)
{
    const struct hobe_section *section = beam->spec.section;
    const double extent = hypot(section->properties.width, section->properties.height);
    return !hobe_section_varies(section) && !has_mode(beam->kernel, "w2t") &&
           fabs(rate) * extent > SLIGHT;
}

/* What is to be said, in order of cost. */
static enum hobe_status judge(const hobe_solution *solution, const struct beam *beam,
                              struct hobe_wall_bending *b, enum hobe_warning *warning,
                              struct hobe_error *err)
{
    const int element = most_twisted(solution, beam, b);
    if (!worth_asking(beam, b->twist_rate))
        return HOBE_OK;
    enum hobe_status status = estimate_there(beam, b, err);
    if (status || (b->loss < NOTICEABLE && b->limit_torque == INFINITY))
        return status;
    status = cut(solution, beam, element, b, err);
    if (!status && fabs(b->torque) > b->limit_torque)
        *warning = HOBE_WARNING_COLLAPSED;
    else if (!status && b->loss >= NOTICEABLE)
        *warning = HOBE_WARNING_BENDS;
    return status;
}

enum hobe_status hobe_solution_warning(const hobe_solution *solution, const char *name,
                                       enum hobe_warning *warning, char *text, size_t size,
                                       struct hobe_error *err)
{
    struct hobe_wall_bending bending;
    const struct beam *beam = model_find_beam(solution->model, name, NULL, err);
    *warning = HOBE_WARNING_NONE;
    snprintf(text, size, "%s", "");
    if (!beam)
        return HOBE_UNKNOWN;
    const enum hobe_status status = judge(solution, beam, &bending, warning, err);
    tell(beam, &bending, *warning, text, size);
    return status;
}
