/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Position, strain and rotation anywhere in a beam, and of bodies. */
#include "solution.h"

#include "around.h"
#include "body.h"
#include "reduction.h"
#include "vector3.h"

#include <string.h>

enum { TWIST_STEPS = 8 }; /* of an element, between which less than a quarter of a turn is taken */

/* ---- states --------------------------------------------------------------------------------- */

/* *copy = a field in which joined vectors move together. */
static enum hobe_status copy_field(const hobe_model *model, const double *field, double **copy,
                                   struct hobe_error *err)
{
    if (!field)
        return HOBE_OK;
    *copy = hobe_alloc((size_t)(3 * model->vectors), sizeof **copy, err);
    for (long v = 0; *copy && v < model->vectors; v++)
        memcpy(*copy + 3 * v, field + 3 * model->alias[v], 3 * sizeof *field);
    return *copy ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The fields of a reduced model as they are, and expanded. */
static enum hobe_status copy_reduced(const hobe_model *model, const double *const field[3],
                                     struct hobe_solution *s, struct hobe_error *err)
{
    const struct reduction *r = model->reduction;
    const size_t n = (size_t)(3 * model->vectors), size = (size_t)(3 * r->whole->vectors);
    double **const to[] = {&s->u, &s->v, &s->w};
    s->reduced = r->of;
    s->coordinates = model->vectors;
    s->q = hobe_alloc(3 * n, sizeof *s->q, err);
    double *all = hobe_alloc(size, sizeof *all, err);
    enum hobe_status status = s->q && all ? HOBE_OK : HOBE_NO_MEMORY;
    for (int i = 0; !status && i < 3 && field[i]; i++) {
        memcpy(s->q + (size_t)i * n, field[i], n * sizeof *s->q);
        reduction_expand(model, field[i], i == SOLUTION_U, all);
        status = copy_field(r->whole, all, to[i], err);
    }
    hobe_free(all);
    return status ? status : reduction_reactions(r, s, err);
}

int solution_is_of(const struct hobe_solution *state, const hobe_model *model)
{
    const struct reduction *r = model->reduction;
    return state->model == model_whole(model) && (!r || state->reduced == r->of);
}

hobe_solution *solution_new(const hobe_model *model, const double *u, const double *v,
                            const double *w, const struct hobe_solution_info *info,
                            struct hobe_error *err)
{
    hobe_solution *s = hobe_alloc(1, sizeof *s, err);
    if (!s)
        return NULL;
    *s = (struct hobe_solution){.model = model_whole(model), .info = *info};
    if (model->reduction) {
        if (!copy_reduced(model, (const double *const[]){u, v, w}, s, err))
            return s;
    } else if (!copy_field(model, u, &s->u, err) && !copy_field(model, v, &s->v, err) &&
               !copy_field(model, w, &s->w, err))
        return s;
    hobe_solution_free(s);
    return NULL;
}

void hobe_solution_free(hobe_solution *solution)
{
    if (!solution)
        return;
    hobe_free(solution->u);
    hobe_free(solution->v);
    hobe_free(solution->w);
    hobe_free(solution->q);
    hobe_free(solution);
}

static hobe_solution **entry(const struct list *list, int i)
{
    return i >= 0 && (size_t)i < list->count ? (hobe_solution **)list->item + i : NULL;
}

const hobe_solution *solutions_get(const struct list *list, int i)
{
    return entry(list, i) ? *entry(list, i) : NULL;
}

hobe_solution *solutions_take(struct list *list, int i)
{
    hobe_solution **at = entry(list, i), *taken = at ? *at : NULL;
    if (at)
        *at = NULL;
    return taken;
}

void solutions_free(struct list *list)
{
    for (size_t i = 0; i < list->count; i++)
        hobe_solution_free(*entry(list, (int)i));
    hobe_free(list->item);
}

void hobe_solution_info(const hobe_solution *solution, struct hobe_solution_info *info)
{
    *info = solution->info;
}

/* ---- volume --------------------------------------------------------------------------------- */

/* The section modes at the places of a section where the volume is watched. */
static enum hobe_status probe_modes(struct around *p, double phi[HOBE_PROBES][HOBE_MAX_MODES][4],
                                    struct hobe_error *err)
{
    const struct hobe_section *section = p->place.beam->spec.section;
    const struct hobe_section_place at = around_section_place(p->place);
    double probe[HOBE_PROBES][2];
    enum hobe_status status = hobe_section_probes_at(section, &at, probe, err);
    for (int c = 0; !status && c < section->probes; c++) {
        status = around_modes(p, probe[c][0], probe[c][1], err);
        memcpy(phi[c], p->phi, sizeof p->phi);
    }
    return status;
}

/* det F at the point of phi: that of dr/d(x,y,z) beside the reference's. */
static double volume(const struct amplitudes *reference, const struct amplitudes *now, int modes,
                     const double (*phi)[4])
{
    double r[3], G0[3][3], G[3][3];
    amplitudes_field(reference, modes, phi, r, G0);
    amplitudes_field(now, modes, phi, r, G);
    return determinant((const double(*)[3])G) / determinant((const double(*)[3])G0);
}

/* The least det F over the stations of a beam, where that is less than *smallest. */
static enum hobe_status smallest_volume(const hobe_model *model, const struct beam *beam,
                                        const double *u, double *smallest, struct hobe_error *err)
{
    const struct hobe_section *section = beam->spec.section;
    const int varies = hobe_section_varies(section);
    double phi[HOBE_PROBES][HOBE_MAX_MODES][4];
    struct around p;
    struct amplitudes reference, now;
    for (int e = 0; e < beam->spec.elements; e++) {
        const struct hobe_invariants *inv = hobe_element_invariants(beam_law(beam, e));
        for (int g = 0; g < inv->stations; g++) {
            const struct place place = {beam, e, inv->xi[g]};
            around_look(model, u, place, &p);
            const enum hobe_status status =
                varies || (e == 0 && g == 0) ? probe_modes(&p, phi, err) : HOBE_OK;
            if (status)
                return status;
            around_amplitudes(&p, p.q0, &reference);
            for (int i = 0; i < 3 * beam->kernel->vectors; i++)
                p.u[i] += p.q0[i];
            around_amplitudes(&p, p.u, &now);
            for (int c = 0; c < section->probes; c++)
                *smallest = fmin(*smallest, volume(&reference, &now, beam->kernel->modes,
                                                   (const double(*)[4])phi[c]));
        }
    }
    return HOBE_OK;
}

enum hobe_status solution_smallest_volume(const hobe_model *model, const double *u,
                                          double *smallest, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    *smallest = INFINITY;
    if (model->reduction) {
        reduction_expand(model, u, 1, model->reduction->all);
        u = model->reduction->all;
        model = model->reduction->whole;
    }
    for (size_t i = 0; !status && i < model->beams.count; i++)
        status = smallest_volume(model, model_beam(model, i), u, smallest, err);
    return status;
}

/* ---- places --------------------------------------------------------------------------------- */

/* The rotation vector of the rotation R. */
static void rotation_vector(const double R[3][3], double w[3])
{
    const double axis[3] = {R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]};
    const double s = length3(axis) / 2;                     /* sin */
    const double c = (R[0][0] + R[1][1] + R[2][2] - 1) / 2; /* cos */
    const double angle = atan2(s, c);
    if (s > 1e-8 || c > 0) {
        const double factor = s > 1e-8 ? angle / (2 * s) : 0.5;
        for (int a = 0; a < 3; a++)
            w[a] = factor * axis[a];
        return;
    }
    int largest = 0; /* half a turn: R = 2 n n' - 1 */
    for (int a = 1; a < 3; a++)
        if (R[a][a] > R[largest][largest])
            largest = a;
    const double n = sqrt(fmax(0, (R[largest][largest] + 1) / 2));
    for (int a = 0; a < 3; a++)
        w[a] = angle * (a == largest ? n : (R[largest][a] + R[a][largest]) / (4 * n));
}

/* The rotation vector of the section's axes where F is the gradient on the axis. */
static void section_rotation(const double F[3][3], const double frame[3][3], double w[3])
{
    double t[3][3], R[3][3];
    around_axes(F, t);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            R[a][b] = t[0][a] * frame[0][b] + t[1][a] * frame[1][b] + t[2][a] * frame[2][b];
    rotation_vector((const double(*)[3])R, w);
}

/* Where a point of the beam is in the reference. */
static void reference(const struct around *p, double at, double y, double z, double r0[3])
{
    const struct place place = p->place;
    const struct beam *beam = place.beam;
    double G0[3][3];
    if (beam->origin)
        around_field(p, p->q0, r0, G0);
    for (int a = 0; a < 3; a++)
        r0[a] = beam->origin ? beam->origin[place.element][a] + r0[a]
                             : beam->end[0][a] + at * beam->length * p->frame[0][a] +
                                   y * p->frame[1][a] + z * p->frame[2][a];
}

enum hobe_status solution_displacement(const hobe_model *model, const double *vectors,
                                       const char *name, double at, double y, double z,
                                       double r0[3], double u[3], struct hobe_error *err)
{
    struct place place;
    struct around p;
    double gradient_u[3][3];
    const struct beam *beam = around_find(model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    around_look(model, vectors, place, &p);
    const enum hobe_status status = around_modes(&p, y, z, err);
    if (status)
        return status;
    around_field(&p, p.u, u, gradient_u);
    if (r0)
        reference(&p, at, y, z, r0);
    return HOBE_OK;
}

enum hobe_status hobe_solution_velocity(const hobe_solution *solution, const char *beam, double at,
                                        double y, double z, double velocity[3],
                                        double acceleration[3], struct hobe_error *err)
{
    const int moves = solution->v != NULL;
    enum hobe_status status = solution_displacement(
        solution->model, moves ? solution->v : solution->u, beam, at, y, z, NULL, velocity, err);
    if (!status)
        status = solution_displacement(solution->model, moves ? solution->w : solution->u, beam, at,
                                       y, z, NULL, acceleration, err);
    for (int a = 0; a < 3 && !moves; a++)
        velocity[a] = acceleration[a] = 0;
    return status;
}

const struct body *solution_find_body(const hobe_model *model, const char *name,
                                      struct hobe_error *err)
{
    const struct body *body = model_find_body(model, name);
    if (!body)
        hobe_fail(err, HOBE_UNKNOWN, NULL, "there is no body \"%s\" in the scene", name);
    return body;
}

/* Angle of r_z on the axis about the section's X in the reference, between -pi and pi. */
static double turned(const struct around *p, const double F[3][3])
{
    double zy = 0, zz = 0; /* r_z on the reference axes */
    for (int a = 0; a < 3; a++) {
        zy += F[a][2] * p->frame[1][a];
        zz += F[a][2] * p->frame[2][a];
    }
    return atan2(-zy, zz);
}

enum hobe_status hobe_solution_point(const hobe_solution *solution, const char *name, double at,
                                     double y, double z, struct hobe_point *point,
                                     struct hobe_error *err)
{
    struct place place;
    struct around p;
    double axis[3][3], gradient_u[3][3];
    const struct beam *beam = around_find(solution->model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    around_look(solution->model, solution->u, place, &p);
    around_axis(&p);
    around_gradient(&p, axis);
    const enum hobe_status status = around_modes(&p, y, z, err);
    if (status)
        return status;
    around_gradient(&p, point->F);
    around_field(&p, p.u, point->u, gradient_u);
    beam->kernel->strain(p.N, p.Nx, (const double(*)[4])p.phi, p.q0, p.u, point->strain);
    reference(&p, at, y, z, point->r0);
    for (int a = 0; a < 3; a++)
        point->r[a] = point->r0[a] + point->u[a];
    point->twist = turned(&p, (const double(*)[3])axis);
    section_rotation((const double(*)[3])axis, (const double(*)[3])p.frame, point->rotation);
    return HOBE_OK;
}

enum hobe_status hobe_solution_body(const hobe_solution *solution, const char *name,
                                    const double point[3], struct hobe_body_point *is,
                                    struct hobe_error *err)
{
    const struct body *body = solution_find_body(solution->model, name, err);
    double R[3][3];
    if (!body)
        return HOBE_UNKNOWN;
    *is = (struct hobe_body_point){.r = {0}};
    body_displacement(body, solution->u, point, is->r0, is->u);
    if (solution->v) {
        body_displacement(body, solution->v, point, is->r0, is->velocity);
        body_displacement(body, solution->w, point, is->r0, is->acceleration);
        body_turn(body, solution->u, solution->v, is->angular_velocity);
    }
    for (int a = 0; a < 3; a++) {
        is->r[a] = is->r0[a] + is->u[a];
        for (int i = 0; i < 3; i++)
            R[a][i] = (a == i) + solution->u[3 * (body->first + 1 + i) + a];
    }
    rotation_vector((const double(*)[3])R, is->rotation);
    return HOBE_OK;
}

/* Where turns are counted from: the first clamp of a beam, or its begin. */
static double held_at(const hobe_model *model, const struct beam *beam)
{
    for (size_t i = 0; i < model->clamps.count; i++) {
        const struct hobe_clamp *clamp = (const struct hobe_clamp *)model->clamps.item + i;
        if (!strcmp(clamp->beam, beam->name))
            return clamp->at;
    }
    return 0;
}

enum hobe_status hobe_solution_twist(const hobe_solution *solution, const char *name, double at,
                                     double *twist, struct hobe_error *err)
{
    struct place place;
    const struct beam *beam = around_find(solution->model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    const double from = held_at(solution->model, beam);
    const int steps = (int)ceil(fabs(at - from) * beam->spec.elements * TWIST_STEPS);
    double angle = 0, turns = 0;
    for (int k = 0; k <= steps; k++) {
        struct around p;
        double axis[3][3];
        const double before = angle;
        around_look(solution->model, solution->u,
                    model_place(beam, k < steps ? from + (at - from) * k / steps : at), &p);
        around_axis(&p);
        around_gradient(&p, axis);
        angle = turned(&p, (const double(*)[3])axis);
        const double jump = k > 0 ? (before - angle) / (2 * M_PI) : 0;
        turns = fabs(jump) > 0.25 && fabs(jump) < 0.75 ? 0 : turns + round(jump);
    }
    *twist = angle + 2 * M_PI * turns;
    return HOBE_OK;
}
