/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Building a model: items in, checked and numbered beams with a sparsity pattern out. */
#include "model.h"

#include "constraint.h"
#include "element.h"
#include "load.h"
#include "pattern.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MAX_ELEMENTS = 1000000 };

/* Ends that are joined must coincide to this fraction of the beams' length. */
static const double COINCIDENT = 1e-6;

double hobe_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* ---- items ---------------------------------------------------------------------------------- */

/* A new item at the end of a list, or NULL. */
static void *append(struct list *list, size_t size, struct hobe_error *err)
{
    if (list->count == list->room) {
        const size_t room = list->room ? 2 * list->room : 4;
        void *grown = hobe_grow(list->item, list->count, room, size, err);
        if (!grown)
            return NULL;
        list->item = grown;
        list->room = room;
    }
    return (char *)list->item + size * list->count++;
}

/* A copy of text of hobe_alloc. */
static char *copy_text(const char *text, struct hobe_error *err)
{
    const size_t size = strlen(text) + 1;
    char *copy = hobe_alloc(size, 1, err);
    return copy ? memcpy(copy, text, size) : NULL;
}

hobe_model *hobe_model_new(struct hobe_error *err)
{
    return hobe_alloc(1, sizeof(hobe_model), err);
}

static void free_named(struct list *list, size_t size, size_t name_offset, int names)
{
    for (size_t i = 0; i < list->count; i++)
        for (int n = 0; n < names; n++)
            hobe_free(*(char **)((char *)list->item + i * size + name_offset +
                                 (size_t)n * sizeof(char *)));
    hobe_free(list->item);
}

static void free_beam(struct beam *beam)
{
    if (!beam->borrowed)
        hobe_element_free(beam->element);
    hobe_free(beam->name);
    hobe_free(beam->q0);
    hobe_free(beam->q0_lanes);
    hobe_free(beam->block);
}

void hobe_model_free(hobe_model *model)
{
    if (!model)
        return;
    for (size_t i = 0; i < model->beams.count; i++)
        free_beam(model_beam(model, i));
    hobe_free(model->beams.item);
    free_named(&model->clamps, sizeof(struct hobe_clamp), offsetof(struct hobe_clamp, beam), 1);
    free_named(&model->forces, sizeof(struct hobe_force), offsetof(struct hobe_force, beam), 1);
    free_named(&model->moments, sizeof(struct hobe_moment), offsetof(struct hobe_moment, beam), 1);
    free_named(&model->joins, sizeof(struct hobe_join), offsetof(struct hobe_join, beam), 2);
    hobe_free(model->corners.item);
    hobe_linsolve_free(model->solver);
    pattern_free(&model->pattern);
    hobe_free(model->alias);
    hobe_free(model->unknown);
    hobe_free(model->held);
    hobe_free(model->dead);
    hobe_free(model->work.u);
    for (size_t i = 0; i < model->notes; i++)
        hobe_free(model->note[i]);
    hobe_free(model->note);
    hobe_free(model);
}

/* True when x is NaN or infinite anywhere. */
static int not_finite(const double *x, int n)
{
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return 1;
    return 0;
}

static enum hobe_status check_at(double at, const char *where, struct hobe_error *err)
{
    if (at >= 0 && at <= 1)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, where,
                     "at must be a fraction of the beam's length from 0 to 1, got %g", at);
}

/* Axes of a straight beam: e_x along it, e_z as near to `up` as can be. */
static enum hobe_status set_frame(struct beam *beam, struct hobe_error *err)
{
    const struct hobe_beam *s = &beam->spec;
    double(*e)[3] = beam->frame, d[3], up[3], along = 0, norm = 0;
    for (int a = 0; a < 3; a++) {
        d[a] = s->to[a] - s->from[a];
        up[a] = s->up[a];
    }
    beam->length = hypot(hypot(d[0], d[1]), d[2]);
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
    for (int a = 0; a < 3; a++)
        along += up[a] * e[0][a];
    const double length = hypot(hypot(up[0], up[1]), up[2]);
    for (int a = 0; a < 3; a++) {
        e[2][a] = up[a] - along * e[0][a];
        norm += e[2][a] * e[2][a];
    }
    if (!(sqrt(norm) > 1e-6 * length))
        return hobe_fail(
            err, HOBE_BAD_INPUT, s->where,
            "up = {%g, %g, %g} points along the beam \"%s\"; give a direction across it", s->up[0],
            s->up[1], s->up[2], beam->name);
    for (int a = 0; a < 3; a++)
        e[2][a] /= sqrt(norm);
    for (int a = 0; a < 3; a++) /* e_y = e_z x e_x */
        e[1][a] = e[2][(a + 1) % 3] * e[0][(a + 2) % 3] - e[2][(a + 2) % 3] * e[0][(a + 1) % 3];
    return HOBE_OK;
}

/* Sections and materials alike, so that one law serves both. */
static int same_law(const struct hobe_beam *a, const struct hobe_beam *b)
{
    const struct hobe_material *m = &a->material, *n = &b->material;
    return a->kernel == b->kernel && a->section == b->section && a->mechanics == b->mechanics &&
           a->integration == b->integration && m->E == n->E && m->nu == n->nu && m->rho == n->rho &&
           m->k2 == n->k2 && m->k3 == n->k3;
}

/* Elements of equal law and length are one: beams share it. */
static enum hobe_status find_element(const hobe_model *model, struct beam *beam,
                                     struct hobe_error *err)
{
    const struct hobe_beam *s = &beam->spec;
    const double length = beam->length / s->elements;
    for (size_t i = 0; i + 1 < model->beams.count; i++) {
        const struct beam *other = model_beam(model, i);
        if (same_law(s, &other->spec) && length == other->length / other->spec.elements) {
            beam->element = other->element;
            beam->borrowed = 1;
            return HOBE_OK;
        }
    }
    beam->element = hobe_element_new(&(struct hobe_element_options){.kernel = s->kernel,
                                                                    .section = s->section,
                                                                    .material = s->material,
                                                                    .length = length,
                                                                    .mechanics = s->mechanics,
                                                                    .integration = s->integration},
                                     err);
    if (!beam->element && err)
        err->where = s->where;
    return beam->element ? HOBE_OK : err ? err->status : HOBE_BAD_INPUT;
}

/* The element and its reference, in one lane and in all. */
static enum hobe_status prepare(const hobe_model *model, struct beam *beam, struct hobe_error *err)
{
    const size_t n = 3 * (size_t)beam->spec.kernel->vectors;
    beam->kernel = beam->spec.kernel;
    beam->step = hobe_kernel_step(beam->kernel);
    const enum hobe_status status = find_element(model, beam, err);
    if (status)
        return status;
    beam->q0 = hobe_alloc(n, sizeof(double), err);
    beam->q0_lanes = hobe_alloc(n, sizeof(hobe_lanes), err);
    if (!beam->q0 || !beam->q0_lanes)
        return HOBE_NO_MEMORY;
    hobe_element_reference(beam->element, (const double(*)[3])beam->frame, beam->q0);
    for (size_t i = 0; i < n; i++)
        for (int e = 0; e < HOBE_LANES; e++)
            beam->q0_lanes[i][e] = beam->q0[i];
    return HOBE_OK;
}

static enum hobe_status set_up_beam(const hobe_model *model, struct beam *beam,
                                    struct hobe_error *err)
{
    beam->name = copy_text(beam->spec.name, err);
    if (!beam->name)
        return HOBE_NO_MEMORY;
    beam->spec.name = beam->name;
    const enum hobe_status status = set_frame(beam, err);
    return status ? status : prepare(model, beam, err);
}

enum hobe_status hobe_model_beam(hobe_model *model, const struct hobe_beam *spec,
                                 struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++)
        if (strcmp(model_beam(model, i)->name, spec->name) == 0)
            return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                             "the scene has two beams named \"%s\"; names must differ", spec->name);
    if (spec->elements < 1 || spec->elements > MAX_ELEMENTS)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where, "elements must be from 1 to %d, got %d",
                         MAX_ELEMENTS, spec->elements);
    if (not_finite(spec->from, 3) || not_finite(spec->to, 3) || not_finite(spec->up, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "from, to and up of beam \"%s\" must be finite", spec->name);
    struct beam *beam = append(&model->beams, sizeof *beam, err);
    if (!beam)
        return HOBE_NO_MEMORY;
    *beam = (struct beam){.spec = *spec};
    const double start = hobe_seconds();
    const enum hobe_status status = set_up_beam(model, beam, err);
    model->setup += hobe_seconds() - start;
    if (status) { /* the model stays as it was */
        free_beam(beam);
        model->beams.count--;
    }
    return status;
}

enum hobe_status hobe_model_clamp(hobe_model *model, const struct hobe_clamp *spec,
                                  struct hobe_error *err)
{
    if (check_at(spec->at, spec->where, err))
        return HOBE_BAD_INPUT;
    struct hobe_clamp *clamp = append(&model->clamps, sizeof *clamp, err);
    if (!clamp)
        return HOBE_NO_MEMORY;
    *clamp = *spec;
    clamp->beam = copy_text(spec->beam, err);
    return clamp->beam ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_model_force(hobe_model *model, const struct hobe_force *spec,
                                  struct hobe_error *err)
{
    if (check_at(spec->at, spec->where, err))
        return HOBE_BAD_INPUT;
    if (not_finite(spec->value, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where, "a force must be finite (N)");
    struct hobe_force *force = append(&model->forces, sizeof *force, err);
    if (!force)
        return HOBE_NO_MEMORY;
    *force = *spec;
    force->beam = copy_text(spec->beam, err);
    return force->beam ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_model_moment(hobe_model *model, const struct hobe_moment *spec,
                                   struct hobe_error *err)
{
    if (check_at(spec->at, spec->where, err))
        return HOBE_BAD_INPUT;
    if (not_finite(spec->value, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where, "a moment must be finite (N m)");
    struct hobe_moment *moment = append(&model->moments, sizeof *moment, err);
    if (!moment)
        return HOBE_NO_MEMORY;
    *moment = *spec;
    moment->beam = copy_text(spec->beam, err);
    return moment->beam ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_model_join(hobe_model *model, const struct hobe_join *spec,
                                 struct hobe_error *err)
{
    struct hobe_join *join = append(&model->joins, sizeof *join, err);
    if (!join)
        return HOBE_NO_MEMORY;
    *join = *spec;
    join->beam[1] = NULL;
    join->beam[0] = copy_text(spec->beam[0], err);
    join->beam[1] = join->beam[0] ? copy_text(spec->beam[1], err) : NULL;
    return join->beam[1] ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_model_gravity(hobe_model *model, const char *where, const double g[3],
                                    struct hobe_error *err)
{
    if (not_finite(g, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, where, "gravity must be finite (m/s^2)");
    for (int a = 0; a < 3; a++)
        model->gravity[a] += g[a];
    model->gravity_where = where;
    return HOBE_OK;
}

/* ---- look-up -------------------------------------------------------------------------------- */

const struct beam *model_find_beam(const struct hobe_model *model, const char *name,
                                   const char *where, struct hobe_error *err)
{
    char known[400] = "";
    size_t used = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (strcmp(beam->name, name) == 0)
            return beam;
        if (used < sizeof known)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s\"%s\"", i ? ", " : "",
                                     beam->name);
    }
    hobe_fail(err, HOBE_UNKNOWN, where, "there is no beam \"%s\" in the scene; beams are: %s", name,
              model->beams.count ? known : "none");
    return NULL;
}

struct place model_place(const struct beam *beam, double at)
{
    const double x = at * beam->spec.elements;
    int e = (int)floor(x);
    if (e >= beam->spec.elements)
        e = beam->spec.elements - 1;
    return (struct place){beam, e, x - e};
}

const char *hobe_model_beam_name(const hobe_model *model, int i)
{
    return i >= 0 && (size_t)i < model->beams.count ? model_beam(model, (size_t)i)->name : NULL;
}

const char *hobe_model_note(const hobe_model *model, int i)
{
    return i >= 0 && (size_t)i < model->notes ? model->note[i] : NULL;
}

void hobe_model_info(const hobe_model *model, struct hobe_model_info *info)
{
    *info = (struct hobe_model_info){.beams = (int)model->beams.count,
                                     .vectors = model->vectors,
                                     .unknowns = 3 * model->unknowns,
                                     .setup = model->setup};
    for (size_t i = 0; i < model->beams.count; i++)
        info->elements += model_beam(model, i)->spec.elements;
    if (model->pattern.start)
        info->nonzeros = 9 * model->pattern.start[model->unknowns];
}

static enum hobe_status add_note(hobe_model *model, const char *text, struct hobe_error *err)
{
    char **grown = hobe_grow(model->note, model->notes, model->notes + 1, sizeof *grown, err);
    if (!grown)
        return HOBE_NO_MEMORY;
    model->note = grown;
    grown[model->notes] = copy_text(text, err);
    return grown[model->notes] && ++model->notes ? HOBE_OK : HOBE_NO_MEMORY;
}

/* ---- numbering ------------------------------------------------------------------------------ */

/* Beams in the order added, then one block of multipliers for every join: more than enough. */
static enum hobe_status allocate_vectors(hobe_model *model, struct hobe_error *err)
{
    model->vectors = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        struct beam *beam = model_beam(model, i);
        beam->first = model->vectors;
        model->vectors += (long)beam->step * (beam->spec.elements - 1) + beam->kernel->vectors;
    }
    model->beam_vectors = model->vectors;
    const size_t n = (size_t)model->vectors + model->joins.count;
    model->alias = hobe_alloc(n, sizeof *model->alias, err);
    model->unknown = hobe_alloc(n, sizeof *model->unknown, err);
    model->held = hobe_alloc(n, sizeof *model->held, err);
    model->dead = hobe_alloc(3 * n, sizeof *model->dead, err);
    if (!model->alias || !model->unknown || !model->held || !model->dead)
        return HOBE_NO_MEMORY;
    for (size_t v = 0; v < n; v++)
        model->alias[v] = (long)v;
    return HOBE_OK;
}

/* Vectors that a section does not carry are held at zero, and named. */
static enum hobe_status hold_dropped(hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const struct hobe_kernel *k = beam->kernel;
        const unsigned char *dropped = hobe_element_dropped(beam->element);
        for (int m = 0; m < k->modes; m++) {
            char text[200];
            if (!dropped[m])
                continue;
            snprintf(
                text, sizeof text,
                "beam \"%s\": section mode %s vanishes or depends on earlier modes and is left "
                "out",
                beam->name, k->mode[m]);
            if (add_note(model, text, err))
                return HOBE_NO_MEMORY;
            for (int e = 0; e < beam->spec.elements; e++)
                for (int v = 0; v < k->vectors; v++)
                    if (k->vector[v].mode == m)
                        model->held[model_vector(model, beam, e, v)] = 1;
        }
    }
    return HOBE_OK;
}

static enum hobe_status note_spurious(hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        struct hobe_rest rest;
        char text[240];
        hobe_element_rest(beam->element, &rest);
        if (rest.zero <= 6)
            continue;
        snprintf(text, sizeof text,
                 "beam \"%s\": with integration = \"paper\" element %s has %d zero-energy modes, "
                 "%d of them spurious; supports may not hold them",
                 beam->name, beam->kernel->name, rest.zero, rest.zero - 6);
        if (add_note(model, text, err))
            return HOBE_NO_MEMORY;
    }
    return HOBE_OK;
}

/* The node of a beam at `at`, as element and node of it; -1 where there is none with a position. */
static int node_at(const struct beam *beam, double at, int *element)
{
    const struct hobe_kernel *k = beam->kernel;
    const struct place place = model_place(beam, at);
    *element = place.element;
    for (int n = 0; n < k->nodes; n++)
        if (fabs(k->node[n] - place.xi) < 1e-9 && hobe_kernel_vector(k, n, 0, 0) >= 0)
            return n;
    return -1;
}

static enum hobe_status hold_clamps(hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->clamps.count; i++) {
        const struct hobe_clamp *c = (const struct hobe_clamp *)model->clamps.item + i;
        const struct beam *beam = model_find_beam(model, c->beam, c->where, err);
        int e;
        if (!beam)
            return HOBE_UNKNOWN;
        const int node = node_at(beam, c->at, &e);
        if (node < 0)
            return hobe_fail(
                err, HOBE_BAD_INPUT, c->where,
                "a clamp must sit on a node: beam \"%s\" has %d elements of type %s and "
                "none of their nodes with a position at %g",
                beam->name, beam->spec.elements, beam->kernel->name, c->at);
        for (int v = 0; v < beam->kernel->vectors; v++) {
            const struct hobe_vector *is = beam->kernel->vector + v;
            if (is->node == node && (is->mode <= 2 || !c->free_warping))
                model->held[model_vector(model, beam, e, v)] = 1;
        }
    }
    return HOBE_OK;
}

/* ---- joins ---------------------------------------------------------------------------------- */

/* One end of a join, resolved. */
struct joined {
    const struct beam *beam;
    int element, node;
};

static enum hobe_status find_joined(const hobe_model *model, const struct hobe_join *join,
                                    struct joined end[2], struct hobe_error *err)
{
    double gap = 0;
    for (int i = 0; i < 2; i++) {
        end[i].beam = model_find_beam(model, join->beam[i], join->where, err);
        if (!end[i].beam)
            return HOBE_UNKNOWN;
        if (join->at[i] != 0 && join->at[i] != 1)
            return hobe_fail(err, HOBE_BAD_INPUT, join->where,
                             "beams are joined at their ends: at must be 0 or 1, got %g",
                             join->at[i]);
        end[i].node = node_at(end[i].beam, join->at[i], &end[i].element);
    }
    const struct beam *a = end[0].beam, *b = end[1].beam;
    if (a == b)
        return hobe_fail(err, HOBE_BAD_INPUT, join->where, "beam \"%s\" is joined to itself",
                         a->name);
    for (int c = 0; c < 3; c++)
        gap = hypot(gap, (join->at[0] == 0 ? a->spec.from : a->spec.to)[c] -
                             (join->at[1] == 0 ? b->spec.from : b->spec.to)[c]);
    if (gap > COINCIDENT * fmax(a->length, b->length))
        return hobe_fail(err, HOBE_BAD_INPUT, join->where,
                         "the joined ends of \"%s\" and \"%s\" are %g m apart; they must coincide",
                         a->name, b->name, gap);
    return HOBE_OK;
}

static int parallel(const struct beam *a, const struct beam *b)
{
    double turn = 0;
    for (int i = 0; i < 9; i++)
        turn = fmax(turn, fabs(a->frame[i / 3][i % 3] - b->frame[i / 3][i % 3]));
    return turn < 1e-9;
}

static long representative(const hobe_model *model, long v)
{
    while (model->alias[v] != v)
        v = model->alias[v];
    return v;
}

/* Makes the vector of a mode at two joined nodes one. */
static void share(hobe_model *model, const struct joined end[2], int mode, int slope)
{
    long v[2];
    for (int i = 0; i < 2; i++) {
        const int local = hobe_kernel_vector(end[i].beam->kernel, end[i].node, mode, slope);
        if (local < 0)
            return;
        v[i] = representative(model, end[i].beam->first + (long)end[i].element * end[i].beam->step +
                                         local);
    }
    model->alias[v[0] > v[1] ? v[0] : v[1]] = v[0] > v[1] ? v[1] : v[0];
}

/* Beams at an angle keep their own slopes, which a corner ties together. */
static enum hobe_status add_corner(hobe_model *model, const struct joined end[2],
                                   struct hobe_error *err)
{
    struct corner *corner = append(&model->corners, sizeof *corner, err);
    if (!corner)
        return HOBE_NO_MEMORY;
    for (int i = 0; i < 2; i++) {
        corner->beam[i] = end[i].beam;
        corner->element[i] = end[i].element;
        for (int s = 0; s < 2; s++)
            corner->slope[i][s] = hobe_kernel_vector(end[i].beam->kernel, end[i].node, 1 + s, 0);
    }
    corner->vector[CORNER_VECTORS - 1] = model->vectors++;
    corner_orient(corner);
    return HOBE_OK;
}

/* Positions are shared; so are slopes y, z of parallel beams, and slope x and further modes where
 * the beams are alike. */
static enum hobe_status join_one(hobe_model *model, const struct hobe_join *join,
                                 struct hobe_error *err)
{
    struct joined end[2];
    const enum hobe_status status = find_joined(model, join, end, err);
    if (status)
        return status;
    share(model, end, 0, 0);
    if (!parallel(end[0].beam, end[1].beam))
        return add_corner(model, end, err);
    share(model, end, 1, 0);
    share(model, end, 2, 0);
    for (int m = 0;
         same_law(&end[0].beam->spec, &end[1].beam->spec) && m < end[0].beam->kernel->modes; m++) {
        share(model, end, m, 0);
        share(model, end, m, 1);
    }
    return HOBE_OK;
}

static enum hobe_status apply_joins(hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->joins.count; i++) {
        const enum hobe_status status =
            join_one(model, (const struct hobe_join *)model->joins.item + i, err);
        if (status)
            return status;
    }
    for (long v = 0; v < model->vectors; v++)
        model->alias[v] = representative(model, v);
    for (size_t i = 0; i < model->corners.count; i++) {
        struct corner *c = model_corner(model, i);
        for (int v = 0; v < CORNER_VECTORS - 1; v++)
            c->vector[v] =
                model_vector(model, c->beam[v / 2], c->element[v / 2], c->slope[v / 2][v % 2]);
    }
    return HOBE_OK;
}

/* A corner between held sections has nothing to say: its multipliers would be undetermined. */
static void hold_idle_corners(hobe_model *model)
{
    for (size_t i = 0; i < model->corners.count; i++) {
        const long *v = model_corner(model, i)->vector;
        model->held[v[4]] =
            model->held[v[0]] && model->held[v[1]] && model->held[v[2]] && model->held[v[3]];
    }
}

/* A beam is held when its group of joined beams has a clamp: the joins and clamps of this room stop
 * all six rigid motions.  Beams are grouped by the vectors they share. */
static enum hobe_status check_held(const hobe_model *model, struct hobe_error *err)
{
    const size_t n = model->beams.count;
    size_t *group = hobe_alloc(n, sizeof *group, err);
    enum hobe_status status = group ? HOBE_OK : HOBE_NO_MEMORY;
    for (size_t i = 0; !status && i < n; i++)
        group[i] = i;
    for (size_t pass = 0; !status && pass < n; pass++)
        for (size_t j = 0; j < model->joins.count; j++) {
            const struct hobe_join *join = (const struct hobe_join *)model->joins.item + j;
            size_t g[2] = {0, 0};
            for (size_t i = 0; i < n; i++)
                for (int s = 0; s < 2; s++)
                    if (strcmp(model_beam(model, i)->name, join->beam[s]) == 0)
                        g[s] = i;
            const size_t lowest = group[g[0]] < group[g[1]] ? group[g[0]] : group[g[1]];
            group[g[0]] = group[g[1]] = lowest;
        }
    for (size_t i = 0; !status && i < n; i++) {
        int clamped = 0;
        for (size_t c = 0; c < model->clamps.count; c++)
            for (size_t k = 0; k < n; k++)
                clamped |= group[k] == group[i] &&
                           strcmp(((const struct hobe_clamp *)model->clamps.item)[c].beam,
                                  model_beam(model, k)->name) == 0;
        if (!clamped)
            status = hobe_fail(err, HOBE_UNCONSTRAINED, model_beam(model, i)->spec.where,
                               "beam \"%s\" is free to move: translations along x, y, z and "
                               "rotations about x, y, z; hold it by a clamp or join it to a held "
                               "beam",
                               model_beam(model, i)->name);
    }
    hobe_free(group);
    return status;
}

/* ---- build ---------------------------------------------------------------------------------- */

static void number_unknowns(hobe_model *model)
{
    model->unknowns = 0;
    for (long v = 0; v < model->vectors; v++)
        model->unknown[v] = model->alias[v] == v && !model->held[v] ? model->unknowns++ : -1;
}

static enum hobe_status allocate_work(hobe_model *model, struct hobe_error *err)
{
    size_t V = 0, scratch = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct hobe_kernel *k = model_beam(model, i)->kernel;
        V = (size_t)k->vectors > V ? (size_t)k->vectors : V;
        scratch = k->scratch > scratch ? k->scratch : scratch;
    }
    const size_t blocks = 9 * V * (V + 1) / 2;
    struct workspace *w = &model->work;
    w->u = hobe_alloc(6 * V + blocks + scratch, sizeof(hobe_lanes), err);
    if (!w->u)
        return HOBE_NO_MEMORY;
    w->f = w->u + 3 * V;
    w->K = w->f + 3 * V;
    w->scratch = w->K + blocks;
    return HOBE_OK;
}

static enum hobe_status build(hobe_model *model, struct hobe_error *err)
{
    if (model->beams.count == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "the scene has no beam");
    enum hobe_status status = allocate_vectors(model, err);
    if (!status)
        status = apply_joins(model, err);
    if (!status)
        status = hold_dropped(model, err);
    if (!status)
        status = hold_clamps(model, err);
    if (!status)
        status = check_held(model, err);
    if (!status)
        status = note_spurious(model, err);
    if (status)
        return status;
    hold_idle_corners(model);
    number_unknowns(model);
    if (model->unknowns == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, model_beam(model, 0)->spec.where,
                         "nothing is left to solve for: every node is clamped");
    status = pattern_build(model, err);
    if (!status)
        status = load_build(model, err);
    if (!status)
        status = allocate_work(model, err);
    if (status)
        return status;
    model->solver =
        hobe_linsolve_analyse(3 * model->unknowns, model->pattern.Ap, model->pattern.Ai, err);
    return model->solver ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_model_build(hobe_model *model, struct hobe_error *err)
{
    if (model->built)
        return HOBE_OK;
    if (model->failed)
        return hobe_fail(err, model->failed, NULL, "this scene could not be built before");
    const double start = hobe_seconds();
    model->failed = build(model, err);
    model->built = !model->failed;
    model->setup += hobe_seconds() - start;
    return model->failed;
}
