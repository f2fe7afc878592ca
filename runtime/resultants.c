/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Section forces.  Where two elements meet they are read off the nodal forces: move all that lies
 * beyond by a rigid motion, and no element there does work; what the element before the cut then
 * does at its last node is the work of the loads beyond, less those that act on that element.  In
 * motion -M w is a load, too. */
#include "assemble.h"
#include "constraint.h"
#include "load.h"
#include "mass.h"
#include "solution.h"
#include "spring.h"
#include "stress.h"
#include "vector3.h"

#include <string.h>

/* Of an element's length: a place so near to an end is there. */
static const double AT_END = 1e-9;

/* Global force and moment on the section's axes. */
static void resolve(const double force[3], const double moment[3], struct hobe_resultants *r)
{
    for (int b = 0; b < 3; b++) {
        r->force[b] = dot3(r->axes[b], force);
        r->moment[b] = dot3(r->axes[b], moment);
    }
}

/* Moves a place near an end of an element to it, xi = 1 but at the beam's start; 0 where it is
 * near none. */
static int snap(struct place *place)
{
    if (place->xi < AT_END && place->element > 0) {
        place->element--;
        place->xi = 1;
    }
    if (place->xi < AT_END)
        place->xi = 0;
    if (place->xi > 1 - AT_END)
        place->xi = 1;
    return place->xi == 0 || place->xi == 1;
}

/* ---- nodal forces --------------------------------------------------------------------------- */

/* What the node at the cut gets from its element, with force and moment about it in global axes.
 */
static void sum_node(const struct around *p, const double *f, struct hobe_resultants *r)
{
    const struct hobe_kernel *k = p->kernel;
    const int node = p->place.xi > 0 ? k->nodes - 1 : 0;
    double force[3] = {0}, moment[3] = {0};
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *is = k->vector + v;
        double q[3], couple[3];
        if (is->node != node)
            continue;
        for (int a = 0; a < 3; a++)
            q[a] = p->q0[3 * v + a] + p->u[3 * v + a];
        cross3(q, f + 3 * v, couple);
        if (is->mode == 0 && !is->slope)
            add3(1, f + 3 * v, force);
        else
            add3(1, couple, moment);
        if (!is->slope && !strcmp(k->mode[is->mode], "w"))
            r->bimoment += dot3(r->axes[0], f + 3 * v);
    }
    resolve((const double *)force, (const double *)moment, r);
}

static enum hobe_status from_forces(const hobe_solution *solution, const struct around *p,
                                    struct hobe_resultants *r, struct hobe_error *err)
{
    const hobe_model *model = solution->model;
    const struct beam *beam = p->place.beam;
    const int e = p->place.element;
    double f[3 * HOBE_MAX_VECTORS];
    double *loads = hobe_alloc(3 * (size_t)model->vectors, sizeof *loads, err);
    enum hobe_status status =
        loads ? assemble_element(model, beam, e, solution->u, solution->v, f, err) : HOBE_NO_MEMORY;
    if (!status) {
        const struct instant instant = solution_instant(solution, solution->model);
        load_inside(model, solution->u, &instant, solution->info.load, beam, e, loads);
        constraint_inside(model, solution->u, &instant, beam, e, loads);
        spring_inside(model, solution->u, &instant, beam, e, loads);
        if (solution->v) {
            const double alpha = beam->spec.damping.mass;
            mass_element_force(model, beam, e, MASS_ISOTROPIC(-1), solution->w, loads);
            mass_element_force(model, beam, e, MASS_ISOTROPIC(-alpha), solution->v, loads);
        }
        status = model_failure(model, err);
        for (int v = 0; v < p->kernel->vectors; v++)
            for (int a = 0; a < 3; a++) {
                const double load = loads[3 * model_vector(model, beam, e, v) + a];
                f[3 * v + a] = p->place.xi > 0 ? f[3 * v + a] - load : load - f[3 * v + a];
            }
        sum_node(p, f, r);
    }
    hobe_free(loads);
    return status;
}

/* ---- stress --------------------------------------------------------------------------------- */

/* Where phi's point is now, in the element. */
static void position(const struct around *p, double r[3])
{
    double u[3], F[3][3];
    around_field(p, p->q0, r, F);
    around_field(p, p->u, u, F);
    add3(1, u, r);
}

/* The place of w among the kernel's functions, or -1. */
static int find_warping(const struct hobe_kernel *kernel)
{
    int i = kernel->functions - 1;
    while (i >= 0 && strcmp(kernel->function[i], "w") != 0)
        i--;
    return i;
}

/* The sum over the points of a section's rule, about the point `centre`. */
static void sum_points(struct stress_section *s, const struct hobe_section_rule *rule,
                       const double centre[3], struct hobe_resultants *r)
{
    const int w = find_warping(s->around.kernel);
    double force[3] = {0}, moment[3] = {0};
    for (int i = 0; i < rule->points; i++) {
        const struct hobe_section_point *point = rule->point + i;
        struct hobe_stress stress;
        double F[3][3], arm[3], traction[3], couple[3];
        stress_at_point(s, point, &stress);
        around_gradient(&s->around, F);
        position(&s->around, arm);
        const double on_x[3] = {stress.S[0], stress.S[5], stress.S[4]};
        for (int a = 0; a < 3; a++) {
            arm[a] -= centre[a];
            traction[a] = point->weight * dot3(F[a], on_x);
        }
        cross3(arm, traction, couple);
        add3(1, traction, force);
        add3(1, couple, moment);
        if (w >= 0)
            r->bimoment += point->f[w][0] * dot3(r->axes[0], traction);
    }
    resolve((const double *)force, (const double *)moment, r);
}

static enum hobe_status from_stress(const hobe_solution *solution, const char *name, double at,
                                    struct hobe_resultants *r, struct hobe_error *err)
{
    struct stress_section section;
    struct hobe_rule rule;
    double centre[3];
    enum hobe_status status = stress_section(solution, name, at, &section, err);
    if (status)
        return status;
    around_axis(&section.around);
    const struct beam *beam = section.around.place.beam;
    const struct hobe_section_place place = around_section_place(section.around.place);
    position(&section.around, centre);
    status = hobe_section_rule(beam->spec.section, beam->kernel, beam->spec.integration, &place,
                               &rule, err);
    if (status)
        return status;
    sum_points(&section, &rule.rule, centre, r);
    hobe_rule_free(&rule);
    return HOBE_OK;
}

/* ---- public --------------------------------------------------------------------------------- */

enum hobe_status hobe_solution_resultants(const hobe_solution *solution, const char *name,
                                          double at, enum hobe_cut cut, struct hobe_resultants *r,
                                          struct hobe_error *err)
{
    struct place place;
    struct around p;
    double F[3][3];
    const struct beam *beam = around_find(solution->model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    const int at_end = snap(&place);
    if (cut == HOBE_CUT_FORCES && !at_end)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "nodal forces give resultants at the ends of elements, multiples of 1/%d "
                         "of the length of beam \"%s\", got %g",
                         beam->spec.elements, name, at);
    *r = (struct hobe_resultants){.cut = cut ? cut : at_end ? HOBE_CUT_FORCES : HOBE_CUT_STRESS};
    around_look(solution->model, solution->u, place, &p);
    around_axis(&p);
    around_gradient(&p, F);
    around_axes((const double(*)[3])F, r->axes);
    return r->cut == HOBE_CUT_FORCES ? from_forces(solution, &p, r, err)
                                     : from_stress(solution, name, at, r, err);
}
