/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Building a model: items in, checked and numbered beams with a sparsity pattern out. */
#include "model.h"

#include "assemble.h"
#include "body.h"
#include "constraint.h"
#include "damping.h"
#include "drive.h"
#include "joint.h"
#include "load.h"
#include "numbering.h"
#include "parts.h"
#include "pattern.h"
#include "point_mass.h"
#include "reduction.h"
#include "spring.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MAX_ELEMENTS = 1000000, MOST_NAMES = 3 /* of an item */ };

double hobe_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* ---- items ---------------------------------------------------------------------------------- */

void *list_append(struct list *list, size_t size, struct hobe_error *err)
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
    hobe_model *model = hobe_alloc(1, sizeof *model, err);
    struct hobe_error *failure = model ? hobe_alloc(1, sizeof *failure, err) : NULL;
    if (!failure) {
        hobe_free(model);
        return NULL;
    }
    model->failure = failure;
    return model;
}

static void free_named(struct list *list, size_t size, size_t name_offset, int names)
{
    for (size_t i = 0; i < list->count; i++)
        for (int n = 0; n < names; n++)
            hobe_free(*(char **)((char *)list->item + i * size + name_offset +
                                 (size_t)n * sizeof(char *)));
    hobe_free(list->item);
}

void model_forget_system(hobe_model *model)
{
    model->unknown = NULL;
    model->held = NULL;
    model->pattern = (struct pattern){0};
    model->touched = (struct touched){0};
    memset(model->stride, 0, sizeof model->stride);
    model->fronts = NULL;
    model->solver = NULL;
    model->schedule = (struct schedule){0};
}

void model_free_system(hobe_model *model)
{
    hobe_free(model->unknown);
    hobe_free(model->held);
    pattern_free(&model->pattern);
    hobe_free(model->touched.vector);
    hobe_free(model->touched.at);
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(model->stride[layout]);
    fronts_free(model->fronts);
    hobe_linsolve_free(model->solver);
    assemble_free(&model->schedule);
}

void hobe_model_free(hobe_model *model)
{
    if (!model)
        return;
    for (size_t i = 0; i < model->beams.count; i++)
        beam_free(model_beam(model, i));
    hobe_free(model->beams.item);
    free_named(&model->bodies, sizeof(struct body), offsetof(struct body, spec.name), 1);
    free_named(&model->masses, sizeof(struct point_mass), offsetof(struct point_mass, spec.beam),
               1);
    free_named(&model->clamps, sizeof(struct hobe_clamp), offsetof(struct hobe_clamp, beam), 2);
    free_named(&model->forces, sizeof(struct force), offsetof(struct force, spec.beam), 1);
    free_named(&model->moments, sizeof(struct moment), offsetof(struct moment, spec.beam), 1);
    free_named(&model->motions, sizeof(struct hobe_motion), offsetof(struct hobe_motion, beam), 1);
    free_named(&model->joins, sizeof(struct hobe_join), offsetof(struct hobe_join, beam), 2);
    free_named(&model->joints, sizeof(struct hobe_joint), offsetof(struct hobe_joint, beam), 3);
    hobe_free(model->gravities.item);

    for (size_t i = 0; i < model->springs.count; i++)
        tie_free(&model_spring(model, i)->tie);
    free_named(&model->springs, sizeof(struct spring), offsetof(struct spring, spec.beam), 3);
    for (size_t i = 0; i < model->ties.count; i++)
        tie_free(model_tie(model, i));
    hobe_free(model->ties.item);
    parts_free(model->parts);
    model_free_system(model);
    hobe_free(model->alias);
    hobe_free(model->dead);
    hobe_free(model->arm);
    for (size_t i = 0; i < model->notes; i++)
        hobe_free(model->note[i]);
    hobe_free(model->note);
    if (!model->reduction)
        hobe_free(model->failure);
    reduction_free(model->reduction);
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

/* What comes after the build would not be heard. */
static enum hobe_status check_open(const hobe_model *model, const char *where,
                                   struct hobe_error *err)
{
    if (!model->built && !model->failed)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, where,
                     "the scene is built already; add beams, supports and loads before");
}

static enum hobe_status check_at(const hobe_model *model, double at, const char *where,
                                 struct hobe_error *err)
{
    if (check_open(model, where, err))
        return HOBE_BAD_INPUT;
    if (at >= 0 && at <= 1)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, where,
                     "at must be a fraction of the beam's length from 0 to 1, got %g", at);
}

/* An earlier beam whose law serves this one, too: both straight and prismatic, with elements of
 * equal length. */
static const struct beam *find_lender(void *context, const struct beam *beam)
{
    const hobe_model *model = context;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *other = model_beam(model, i);
        if (other != beam && !other->law_of && beam_same_law(&beam->spec, &other->spec) &&
            beam->length / beam->spec.elements == other->length / other->spec.elements)
            return other;
    }
    return NULL;
}

/* Beams and bodies are found by their names. */
static enum hobe_status check_part_name(const hobe_model *model, const char *name,
                                        const char *where, struct hobe_error *err)
{
    int twice = hobe_model_has_body(model, name);
    for (size_t i = 0; i < model->beams.count; i++)
        twice |= !strcmp(model_beam(model, i)->name, name);
    return twice ? hobe_fail(err, HOBE_BAD_INPUT, where,
                             "the scene has two %s named \"%s\"; names must differ",
                             model->bodies.count ? "beams or bodies" : "beams", name)
                 : HOBE_OK;
}

enum hobe_status hobe_model_beam(hobe_model *model, const struct hobe_beam *spec,
                                 struct hobe_error *err)
{
    if (check_open(model, spec->where, err))
        return HOBE_BAD_INPUT;
    if (check_part_name(model, spec->name, spec->where, err))
        return HOBE_BAD_INPUT;
    if (spec->elements < 1 || spec->elements > MAX_ELEMENTS)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where, "elements must be from 1 to %d, got %d",
                         MAX_ELEMENTS, spec->elements);
    if (not_finite(spec->from, 3) || not_finite(spec->to, 3) || not_finite(spec->up, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "from, to and up of beam \"%s\" must be finite", spec->name);
    if (damping_check(spec, err))
        return HOBE_BAD_INPUT;
    struct beam *beam = list_append(&model->beams, sizeof *beam, err);
    if (!beam)
        return HOBE_NO_MEMORY;
    *beam = (struct beam){.spec = *spec};
    const double start = hobe_seconds();
    const enum hobe_status status = beam_open(beam, find_lender, model, err);
    model->setup += hobe_seconds() - start;
    if (status) { /* the model stays as it was */
        beam_free(beam);
        model->beams.count--;
    }
    return status;
}

/* Adds a copy of an item whose `names` texts from the given offset on, NULL or not, are copied too.
 */
static enum hobe_status add_item(struct list *list, const void *item, size_t size, size_t offset,
                                 int names, struct hobe_error *err)
{
    char *copy[MOST_NAMES] = {NULL};
    const char *name[MOST_NAMES];
    memcpy(name, (const char *)item + offset, (size_t)names * sizeof *name);
    int copied = 0;
    while (copied < names && (!name[copied] || (copy[copied] = copy_text(name[copied], err))))
        copied++;
    char *added = copied == names ? list_append(list, size, err) : NULL;
    if (!added) {
        for (int i = 0; i < copied; i++)
            hobe_free(copy[i]);
        return HOBE_NO_MEMORY;
    }
    memcpy(added, item, size);
    memcpy(added + offset, copy, (size_t)names * sizeof *copy);
    return HOBE_OK;
}

enum hobe_status hobe_model_body(hobe_model *model, const struct hobe_body *spec,
                                 struct hobe_error *err)
{
    struct body body;
    enum hobe_status status = check_open(model, spec->where, err);
    if (!status)
        status = check_part_name(model, spec->name, spec->where, err);
    if (!status)
        status = body_open(spec, &body, err);
    return status ? status
                  : add_item(&model->bodies, &body, sizeof body, offsetof(struct body, spec.name),
                             1, err);
}

enum hobe_status hobe_model_mass(hobe_model *model, const struct hobe_mass *spec,
                                 struct hobe_error *err)
{
    const struct point_mass mass = {.spec = *spec};
    if (check_at(model, spec->at, spec->where, err))
        return HOBE_BAD_INPUT;
    if (!(spec->mass >= 0) || not_finite(&spec->mass, 1) || not_finite(&spec->y, 1) ||
        not_finite(&spec->z, 1))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "a mass must be >= 0 (kg), its y and z finite (m), got %g at %g, %g",
                         spec->mass, spec->y, spec->z);
    return add_item(&model->masses, &mass, sizeof mass, offsetof(struct point_mass, spec.beam), 1,
                    err);
}

/* Reactions are asked for by name, so that no two supports or joints may have the same. */
static enum hobe_status check_name(const hobe_model *model, const char *name, const char *where,
                                   struct hobe_error *err)
{
    const struct hobe_clamp *clamp = model->clamps.item;
    const struct hobe_joint *joint = model->joints.item;
    int twice = 0;
    for (size_t i = 0; name && i < model->clamps.count; i++)
        twice |= clamp[i].name && !strcmp(clamp[i].name, name);
    for (size_t i = 0; name && i < model->joints.count; i++)
        twice |= joint[i].name && !strcmp(joint[i].name, name);
    return twice
               ? hobe_fail(err, HOBE_BAD_INPUT, where,
                           "there are two supports or joints \"%s\"; give each its own name", name)
               : HOBE_OK;
}

enum hobe_status hobe_model_clamp(hobe_model *model, const struct hobe_clamp *spec,
                                  struct hobe_error *err)
{
    if (check_at(model, spec->at, spec->where, err) ||
        check_name(model, spec->name, spec->where, err))
        return HOBE_BAD_INPUT;
    return add_item(&model->clamps, spec, sizeof *spec, offsetof(struct hobe_clamp, beam), 2, err);
}

enum hobe_status hobe_model_joint(hobe_model *model, const struct hobe_joint *spec,
                                  struct hobe_error *err)
{
    if (check_open(model, spec->where, err) || joint_check(spec, err) ||
        check_name(model, spec->name, spec->where, err))
        return HOBE_BAD_INPUT;
    return add_item(&model->joints, spec, sizeof *spec, offsetof(struct hobe_joint, beam), 3, err);
}

enum hobe_status hobe_model_spring(hobe_model *model, const struct hobe_spring *spec,
                                   struct hobe_error *err)
{
    if (check_open(model, spec->where, err) || spring_check(spec, err))
        return HOBE_BAD_INPUT;
    for (size_t i = 0; spec->name && i < model->springs.count; i++) {
        const char *other = model_spring(model, i)->spec.name;
        if (other && !strcmp(other, spec->name))
            return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                             "there are two springs \"%s\"; give each its own name", spec->name);
    }
    return add_item(&model->springs, &(struct spring){.spec = *spec}, sizeof(struct spring),
                    offsetof(struct spring, spec.beam), 3, err);
}

enum hobe_status hobe_model_force(hobe_model *model, const struct hobe_force *spec,
                                  struct hobe_error *err)
{
    if (check_at(model, spec->at, spec->where, err))
        return HOBE_BAD_INPUT;
    if (not_finite(spec->value, 3) || not_finite(spec->point, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "a force must be finite (N), and its point (m)");
    if (spec->function && (spec->follower || length3(spec->value) > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "a force that is a function gives its global axes itself; leave out "
                         "follower and any other value");
    return add_item(&model->forces, &(struct force){.spec = *spec}, sizeof(struct force),
                    offsetof(struct force, spec.beam), 1, err);
}

enum hobe_status hobe_model_moment(hobe_model *model, const struct hobe_moment *spec,
                                   struct hobe_error *err)
{
    if (check_at(model, spec->at, spec->where, err))
        return HOBE_BAD_INPUT;
    if (not_finite(spec->value, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where, "a moment must be finite (N m)");
    return add_item(&model->moments, &(struct moment){.spec = *spec}, sizeof(struct moment),
                    offsetof(struct moment, spec.beam), 1, err);
}

enum hobe_status hobe_model_join(hobe_model *model, const struct hobe_join *spec,
                                 struct hobe_error *err)
{
    if (check_open(model, spec->where, err))
        return HOBE_BAD_INPUT;
    return add_item(&model->joins, spec, sizeof *spec, offsetof(struct hobe_join, beam), 2, err);
}

enum hobe_status hobe_model_motion(hobe_model *model, const struct hobe_motion *spec,
                                   struct hobe_error *err)
{
    if (check_open(model, spec->where, err))
        return HOBE_BAD_INPUT;
    if (not_finite(spec->velocity, 3) || not_finite(spec->angular_velocity, 3) ||
        not_finite(spec->about, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "velocity (m/s), angular_velocity (rad/s) and about (m) must be finite");
    return add_item(&model->motions, spec, sizeof *spec, offsetof(struct hobe_motion, beam), 1,
                    err);
}

enum hobe_status hobe_model_gravity_history(hobe_model *model, const char *where, const double g[3],
                                            hobe_drive *history, struct hobe_error *err)
{
    if (check_open(model, where, err))
        return HOBE_BAD_INPUT;
    if (not_finite(g, 3))
        return hobe_fail(err, HOBE_BAD_INPUT, where, "gravity must be finite (m/s^2)");
    model->gravity_where = where;
    for (int a = 0; a < 3 && !history; a++)
        model->gravity[a] += g[a];
    struct gravity *gravity = history ? list_append(&model->gravities, sizeof *gravity, err) : NULL;
    if (gravity)
        *gravity = (struct gravity){{g[0], g[1], g[2]}, history, where};
    return history && !gravity ? HOBE_NO_MEMORY : HOBE_OK;
}

enum hobe_status hobe_model_gravity(hobe_model *model, const char *where, const double g[3],
                                    struct hobe_error *err)
{
    return hobe_model_gravity_history(model, where, g, NULL, err);
}

enum hobe_status hobe_model_spin(hobe_model *model, const struct hobe_spin *spec,
                                 struct hobe_error *err)
{
    if (check_open(model, spec->where, err))
        return HOBE_BAD_INPUT;
    const double length = length3(spec->axis);
    if (!(length > 0 && isfinite(length)))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "the axis of a spin must be a direction {x, y, z}, got {%g, %g, %g}",
                         spec->axis[0], spec->axis[1], spec->axis[2]);
    if (not_finite(spec->about, 3) || !isfinite(spec->speed))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "a spin's speed (rad/s) and the point it is about (m) must be finite");
    if (spec->history && !isnan(drive_jump(spec->history)))
        return hobe_fail(
            err, HOBE_BAD_INPUT, spec->where,
            "the speed of a spin cannot jump, at t = %g s; let it rise in a short time",
            drive_jump(spec->history));
    if (model->spun)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "a scene turns as a whole, with one spin; there is another one");
    model->spun = 1;
    model->spin = *spec;
    for (int a = 0; a < 3; a++)
        model->spin.axis[a] = spec->axis[a] / length;
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
    if (hobe_model_has_body(model, name)) {
        hobe_fail(err, HOBE_UNKNOWN, where, "\"%s\" is a body; a beam is needed here", name);
        return NULL;
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
    model = model_whole(model);
    return i >= 0 && (size_t)i < model->beams.count ? model_beam(model, (size_t)i)->name : NULL;
}

enum hobe_status model_check_held(const struct hobe_model *model, struct hobe_error *err)
{
    if (err && model->loose.status)
        *err = model->loose;
    return model->loose.status;
}

int model_same_shape(const hobe_model *a, const hobe_model *b)
{
    const size_t size = (size_t)a->vectors * sizeof *a->unknown;
    return a->vectors == b->vectors && a->beam_vectors == b->beam_vectors &&
           a->unknowns == b->unknowns && !memcmp(a->alias, b->alias, size) &&
           !memcmp(a->unknown, b->unknown, size);
}

void model_reference(const struct hobe_model *model, double *q)
{
    memset(q, 0, (size_t)(3 * model->vectors) * sizeof *q);
    for (size_t i = 0; i < model->bodies.count; i++)
        body_reference(model_body(model, i), q);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int e = 0; e < beam->spec.elements; e++)
            for (int v = 0; v < beam->kernel->vectors; v++) {
                const struct hobe_vector *is = beam->kernel->vector + v;
                double *to = q + 3 * model_vector(model, beam, e, v), origin[3];
                beam_origin(beam, e, origin);
                for (int a = 0; a < 3; a++)
                    to[a] =
                        beam_q0(beam, e)[3 * v + a] + (is->mode == 0 && !is->slope ? origin[a] : 0);
            }
    }
}

const char *hobe_model_note(const hobe_model *model, int i)
{
    return i >= 0 && (size_t)i < model->notes ? model->note[i] : NULL;
}

void hobe_model_info(const hobe_model *model, struct hobe_model_info *info)
{
    const hobe_model *whole = model_whole(model);
    const struct reduction *r = model->reduction;
    *info = (struct hobe_model_info){.beams = (int)whole->beams.count,
                                     .bodies = (int)whole->bodies.count,
                                     .vectors = model->vectors,
                                     .unknowns = 3 * model->unknowns,
                                     .setup = model->setup};
    if (r)
        info->unknowns -= 3 * r->blocks - r->n; /* spare ones */
    for (size_t i = 0; i < whole->beams.count; i++)
        info->elements += model_beam(whole, i)->spec.elements;
    if (model->pattern.start)
        info->nonzeros = 9 * model->pattern.start[model->unknowns];
}

enum hobe_status model_add_note(hobe_model *model, const char *text, struct hobe_error *err)
{
    char **grown = hobe_grow(model->note, model->notes, model->notes + 1, sizeof *grown, err);
    if (!grown)
        return HOBE_NO_MEMORY;
    model->note = grown;
    grown[model->notes] = copy_text(text, err);
    return grown[model->notes] && ++model->notes ? HOBE_OK : HOBE_NO_MEMORY;
}

void model_fail(const struct hobe_model *model, const char *where, const struct hobe_error *err)
{
    if (model->failure->status)
        return;
    *model->failure = *err;
    if (!err->where)
        model->failure->where = where;
}

enum hobe_status model_failure(const struct hobe_model *model, struct hobe_error *err)
{
    const enum hobe_status status = model->failure->status;
    if (status && err)
        *err = *model->failure;
    model->failure->status = HOBE_OK;
    return status;
}

/* ---- build ---------------------------------------------------------------------------------- */

static enum hobe_status build(hobe_model *model, struct hobe_error *err)
{
    if (model->beams.count + model->bodies.count == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "the scene has no beam and no body");
    enum hobe_status status = number_model(model, err);
    if (status)
        return status;
    if (model->unknowns == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, model_beam(model, 0)->spec.where,
                         "nothing is left to solve for: every node is clamped");
    status = pattern_build(model, err);
    if (!status)
        status = point_mass_places(model, err);
    if (!status)
        status = load_build(model, err);
    if (!status)
        status = parts_find(model, err);
    return status ? status : assemble_schedule(model, err);
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
