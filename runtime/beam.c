/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "beam.h"

#include "kernel_vectors.h"
#include "material.h"
#include "section.h"
#include "smaller.h"
#include "vector3.h"

#include <string.h>

/* Relative to its length: elements whose vectors have Gram entries closer than this are congruent.
 * The axis itself is known to about 1e-12. */
static const double CONGRUENT = 1e-10;

/* ---- the axis ------------------------------------------------------------------------------- */

/* Axes of a straight beam: e_x along it, e_z as near to `up` as can be. */
static enum hobe_status straight_axis(struct beam *beam, struct hobe_error *err)
{
    const struct hobe_beam *s = &beam->spec;
    double(*e)[3] = beam->end_frame[0], d[3], up[3];
    for (int a = 0; a < 3; a++) {
        beam->end[0][a] = s->from[a];
        beam->end[1][a] = s->to[a];
        d[a] = s->to[a] - s->from[a];
        up[a] = s->up[a];
    }
    beam->length = length3(d);
    if (!isfinite(beam->length))
        return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                         "beam \"%s\" is longer than a number can say", beam->name);
    if (!(beam->length > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                         "beam \"%s\" has no length: from and to are the same point", beam->name);
    for (int a = 0; a < 3; a++)
        e[0][a] = d[a] / beam->length;
    if (up[0] == 0 && up[1] == 0 && up[2] == 0) {
        const int vertical = hypot(e[0][0], e[0][1]) < 1e-6;
        up[0] = vertical ? -copysign(1, e[0][2]) : 0;
        up[2] = vertical ? 0 : 1;
    }
    const double along = dot3(up, e[0]);
    for (int a = 0; a < 3; a++)
        e[2][a] = up[a] - along * e[0][a];
    const double across = length3(e[2]);
    if (!(across > 1e-6 * length3(up)))
        return hobe_fail(
            err, HOBE_BAD_INPUT, s->where,
            "up = {%g, %g, %g} points along the beam \"%s\"; give a direction across it", s->up[0],
            s->up[1], s->up[2], beam->name);
    for (int a = 0; a < 3; a++)
        e[2][a] /= across;
    cross3(e[2], e[0], e[1]);
    memcpy(beam->end_frame[1], e, sizeof beam->end_frame[1]);
    return HOBE_OK;
}

/* The place of an error in a curve is that of its beam. */
static enum hobe_status at_beam(const struct beam *beam, enum hobe_status status,
                                struct hobe_error *err)
{
    if (status && err && !err->where)
        err->where = beam->spec.where;
    return status;
}

static enum hobe_status curved_axis(struct beam *beam, struct hobe_error *err)
{
    double frame_x[3][3];
    enum hobe_status status = HOBE_OK;
    beam->length = hobe_curve_length(beam->spec.curve);
    for (int i = 0; !status && i < 2; i++)
        status = hobe_curve_at(beam->spec.curve, beam->spec.up, i, beam->end[i], beam->end_frame[i],
                               frame_x, err);
    return at_beam(beam, status, err);
}

void beam_origin(const struct beam *beam, int e, double origin[3])
{
    for (int a = 0; a < 3; a++)
        origin[a] = beam->origin ? beam->origin[e][a]
                                 : beam->end[0][a] + beam->length * e / beam->spec.elements *
                                                         beam->end_frame[0][0][a];
}

void beam_frame(const struct beam *beam, int e, const double *N, const double *Nx,
                double frame[3][3])
{
    if (beam->origin)
        hobe_kernel_axes(beam->kernel, N, Nx, beam_q0(beam, e), frame);
    else
        memcpy(frame, beam->end_frame[0], sizeof beam->end_frame[0]);
}

/* ---- elements ------------------------------------------------------------------------------- */

int beam_same_law(const struct hobe_beam *a, const struct hobe_beam *b)
{
    const struct hobe_material *m = &a->material, *n = &b->material;
    return a->kernel == b->kernel && a->section == b->section && a->mechanics == b->mechanics &&
           a->integration == b->integration && m->E == n->E && m->nu == n->nu && m->rho == n->rho &&
           m->k2 == n->k2 && m->k3 == n->k3 && m->average_shear == n->average_shear &&
           !hobe_section_varies(a->section);
}

/* The references of a curved beam's elements: nodes on the curve, slopes and section axes its own.
 */
static enum hobe_status curved_references(struct beam *beam, struct hobe_error *err)
{
    const struct hobe_kernel *k = beam->kernel;
    for (int e = 0; e < beam->spec.elements; e++) {
        double *q0 = beam->q0 + 3 * (size_t)e * (size_t)k->vectors;
        for (int v = 0; v < k->vectors; v++) {
            const struct hobe_vector *is = k->vector + v;
            const double at = (e + k->node[is->node]) / beam->spec.elements;
            double r[3], frame[3][3], frame_x[3][3];
            const enum hobe_status status =
                hobe_curve_at(beam->spec.curve, beam->spec.up, at, r, frame, frame_x, err);
            if (status)
                return at_beam(beam, status, err);
            if (v == 0)
                memcpy(beam->origin[e], r, sizeof r);
            for (int a = 0; a < 3; a++) /* modes beyond 1, y, z vanish at rest */
                q0[3 * v + a] = is->mode > 2 ? 0
                                : is->mode == 0
                                    ? is->slope ? frame[0][a] : r[a] - beam->origin[e][a]
                                : is->slope ? frame_x[is->mode][a]
                                            : frame[is->mode][a];
        }
    }
    return HOBE_OK;
}

/* Whether elements e and f are the same but for a rigid motion. */
static int congruent(const struct beam *beam, int e, int f)
{
    const int V = beam->kernel->vectors;
    const double *q = beam_q0(beam, e), *p = beam_q0(beam, f);
    for (int v = 0; v < V; v++)
        for (int w = 0; w <= v; w++) {
            const double size = length3(q + 3 * v) * length3(q + 3 * w);
            if (!(fabs(dot3(q + 3 * v, q + 3 * w) - dot3(p + 3 * v, p + 3 * w)) <=
                  CONGRUENT * size))
                return 0;
        }
    return 1;
}

/* Numbers the laws: one, or one for each run of congruent elements, or for each element. */
static enum hobe_status number_laws(struct beam *beam, struct hobe_error *err)
{
    const int elements = beam->spec.elements, tapered = hobe_section_varies(beam->spec.section);
    beam->laws = 1;
    if (!beam->origin && !tapered)
        return HOBE_OK;
    beam->law_of = hobe_alloc((size_t)elements, sizeof *beam->law_of, err);
    if (!beam->law_of)
        return HOBE_NO_MEMORY;
    for (int e = 1, first = 0; e < elements; e++) { /* first: of the run, lest small steps add up */
        if (tapered || !congruent(beam, e, first)) {
            beam->laws++;
            first = e;
        }
        beam->law_of[e] = beam->laws - 1;
    }
    return HOBE_OK;
}

/* What is left of an element keeps its law. */
static enum hobe_mechanics own_mechanics(const struct hobe_beam *spec)
{
    return spec->mechanics ? spec->mechanics : hobe_mechanics_find(spec->kernel->mechanics);
}

static enum hobe_status make_laws(struct beam *beam, struct hobe_error *err)
{
    const struct hobe_beam *s = &beam->spec;
    for (int e = 0; e < s->elements; e++) {
        const int law = beam->law_of ? beam->law_of[e] : 0;
        if (beam->law[law])
            continue;
        beam->law[law] = hobe_element_new(
            &(struct hobe_element_options){.kernel = beam->kernel,
                                           .section = s->section,
                                           .material = s->material,
                                           .length = beam->length / s->elements,
                                           .mechanics = own_mechanics(s),
                                           .integration = s->integration,
                                           .from = (double)e / s->elements,
                                           .to = (e + 1.0) / s->elements,
                                           .q0 = beam->origin ? beam_q0(beam, e) : NULL},
            err);
        if (!beam->law[law])
            return at_beam(beam, err ? err->status : HOBE_BAD_INPUT, err);
    }
    return HOBE_OK;
}

static enum hobe_status set_laws(struct beam *beam, const struct beam *lender,
                                 struct hobe_error *err)
{
    const enum hobe_status status = number_laws(beam, err);
    if (status)
        return status;
    beam->law = hobe_alloc((size_t)beam->laws, sizeof(hobe_element *), err);
    if (!beam->law)
        return HOBE_NO_MEMORY;
    if (!lender)
        return make_laws(beam, err);
    beam->law[0] = lender->law[0];
    beam->borrowed = 1;
    return HOBE_OK;
}

static enum hobe_status set_references(struct beam *beam, struct hobe_error *err)
{
    const size_t n = 3 * (size_t)beam->kernel->vectors, elements = (size_t)beam->spec.elements;
    beam->q0 = hobe_alloc(n * (beam->spec.curve ? elements : 1), sizeof(double), err);
    if (!beam->q0)
        return HOBE_NO_MEMORY;
    if (!beam->spec.curve) {
        hobe_kernel_reference(beam->kernel, beam->length / beam->spec.elements,
                              (const double(*)[3])beam->end_frame[0], beam->q0);
        return HOBE_OK;
    }
    beam->origin = hobe_alloc(elements, sizeof *beam->origin, err);
    return beam->origin ? curved_references(beam, err) : HOBE_NO_MEMORY;
}

/* ---- batches -------------------------------------------------------------------------------- */

/* Elements in the batch that begins with element `first`. */
static int batch_size(const struct beam *beam, int first)
{
    int count = 1;
    while (count < HOBE_LANES && first + count < beam->spec.elements &&
           beam_law(beam, first + count) == beam_law(beam, first))
        count++;
    return count;
}

/* The references of a batch, structure of arrays; spare lanes repeat the last element. */
static void set_lanes(const struct beam *beam, const struct batch *batch, hobe_lanes *q0)
{
    for (int lane = 0; lane < HOBE_LANES; lane++) {
        const int e = batch->first + (lane < batch->count ? lane : batch->count - 1);
        const double *from = beam_q0(beam, e);
        for (int i = 0; i < 3 * beam->kernel->vectors; i++)
            q0[i][lane] = from[i];
    }
}

static enum hobe_status set_batches(struct beam *beam, struct hobe_error *err)
{
    const size_t n = 3 * (size_t)beam->kernel->vectors;
    for (int first = 0; first < beam->spec.elements; first += batch_size(beam, first))
        beam->batches++;
    const size_t lanes = n * (beam->origin ? (size_t)beam->batches : 1);
    beam->batch = hobe_alloc((size_t)beam->batches, sizeof *beam->batch, err);
    beam->q0_lanes = hobe_alloc(lanes, sizeof(hobe_lanes), err);
    if (!beam->batch || !beam->q0_lanes)
        return HOBE_NO_MEMORY;
    int first = 0;
    for (int i = 0; i < beam->batches; i++) {
        hobe_lanes *q0 = beam->q0_lanes + (beam->origin ? n * (size_t)i : 0);
        beam->batch[i] = (struct batch){first, batch_size(beam, first), beam_law(beam, first), q0};
        set_lanes(beam, beam->batch + i, q0);
        first += beam->batch[i].count;
    }
    return HOBE_OK;
}

/* References and laws of the beam's kernel. */
static enum hobe_status set_elements(struct beam *beam, const struct beam *lender,
                                     struct hobe_error *err)
{
    beam->step = hobe_kernel_step(beam->kernel);
    const enum hobe_status status = set_references(beam, err);
    return status ? status : set_laws(beam, lender, err);
}

static void free_elements(struct beam *beam)
{
    for (int i = 0; beam->law && !beam->borrowed && i < beam->laws; i++)
        hobe_element_free(beam->law[i]);
    hobe_free(beam->law);
    hobe_free(beam->law_of);
    hobe_free(beam->origin);
    hobe_free(beam->q0);
}

/* Once the elements say which modes the section drops, they are made again without those. */
static enum hobe_status leave_out(struct beam *beam, struct hobe_error *err)
{
    for (int i = 0; i < beam->laws; i++)
        for (int m = 0; m < beam->kernel->modes; m++)
            beam->dropped[m] |= hobe_element_dropped(beam->law[i])[m];
    const struct hobe_kernel *left = kernel_left(&beam->spec, beam->length, beam->dropped, err);
    if (!left)
        return at_beam(beam, err ? err->status : HOBE_BAD_INPUT, err);
    if (left == beam->kernel)
        return HOBE_OK;
    free_elements(beam);
    beam->law = NULL;
    beam->law_of = NULL;
    beam->origin = NULL;
    beam->q0 = NULL;
    beam->kernel = left;
    return set_elements(beam, NULL, err);
}

enum hobe_status beam_open(struct beam *beam,
                           const struct beam *(*lend)(void *, const struct beam *), void *context,
                           struct hobe_error *err)
{
    const size_t size = strlen(beam->spec.name) + 1;
    beam->name = hobe_alloc(size, 1, err);
    if (!beam->name)
        return HOBE_NO_MEMORY;
    beam->spec.name = memcpy(beam->name, beam->spec.name, size);
    const struct hobe_material *own = hobe_section_material(beam->spec.section, 0);
    if (own)
        beam->spec.material = *own; /* what is asked of a beam's material is asked of the first */
    enum hobe_status status = beam->spec.curve ? curved_axis(beam, err) : straight_axis(beam, err);
    if (status)
        return status;
    const int alike = !beam->spec.curve && !hobe_section_varies(beam->spec.section);
    const struct beam *lender = alike ? lend(context, beam) : NULL;
    beam->kernel = lender ? lender->kernel : beam->spec.kernel;
    if (lender)
        memcpy(beam->dropped, lender->dropped, sizeof beam->dropped);
    status = set_elements(beam, lender, err);
    if (!status && !lender)
        status = leave_out(beam, err);
    return status ? status : set_batches(beam, err);
}

void beam_free(struct beam *beam)
{
    free_elements(beam);
    hobe_free(beam->name);
    hobe_free(beam->q0_lanes);
    hobe_free(beam->batch);
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(beam->place[layout]);
}
