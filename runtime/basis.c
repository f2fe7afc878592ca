/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a model goes under its loads is known beforehand: along the paths of a few directions of
 * load, which are followed once.  The states they pass, each of unit energy so that small loads
 * count as much as large ones, span the space of all their derivatives; its principal fields in the
 * inner product of the stiffness are the basis.
 *
 * Paths of one direction know nothing of another.  Several loads of interest are therefore followed
 * one by one, back and forth, and mixed in pairs at every thirty degrees: to the fifth order that
 * is what the mixed derivatives of a pair would span. */
#include "basis.h"

#include "closure.h"
#include "mass.h"
#include "mixture.h"
#include "modes.h"
#include "solution.h"
#include "span.h"
#include "vector3.h"

#include <math.h>

enum {
    DEFAULT_MODES = 12,
    MOST_MODES = 60,
    PARTS = 3,  /* of a right angle between two loads */
    AHEAD = 40, /* steps of a path that nobody has asked for */
};

static const double AMPLITUDE = 0.1; /* of modes whose paths are followed: rad, or the length */

/* What a basis is made of: directions of load, and the fields so far. */
struct source {
    const struct hobe_reduce *options;
    struct span span;
    int count;
    int asked;          /* the first of them, which are loads of interest */
    hobe_model **model; /* [count] whose loads are the directions */
    double *weight;     /* [count] of the mixture at hand */
    hobe_modes *modes;  /* of the method by modes, whose forces of inertia are directions, too */
    struct mixture *inertia; /* [modes] */
    int opened;              /* of them */
};

/* The steps of a path, in units of its linear arc: the unknowns of a basis want as many states. */
static double arc_of(const struct source *s)
{
    return s->count > 1 ? 0.2 : fmin(0.1, 1.0 / s->options->modes);
}

/* ---- paths ----------------------------------------------------------------------------------- */

static enum hobe_status follow(hobe_model *model, double arc, int asked, hobe_path **path,
                               struct hobe_error *err)
{
    struct hobe_path_options options = {
        .newton.method = HOBE_METHOD_SERIES, .arc = arc, .steps = asked ? 0 : AHEAD};
    const enum hobe_status status = hobe_path_follow(model, &options, path, err);
    if (status != HOBE_BAD_INPUT) /* of what has no power series */
        return status;
    options.newton.method = HOBE_METHOD_NEWTON;
    return hobe_path_follow(model, &options, path, err);
}

/* Adds the states along a path, each of unit length; of one that nobody has asked for those before
 * the structure gives way. */
static enum hobe_status add_states(struct span *span, const hobe_path *path, int asked,
                                   struct hobe_error *err)
{
    const struct hobe_path_event *event = asked ? NULL : hobe_path_event(path, 0);
    const hobe_solution *state;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && (state = hobe_path_point(path, i)); i++) {
        if (event && i > event->before)
            break;
        status = span_add(span, state->u, err);
        if (!status)
            span_normalise(span, span->n - 1);
    }
    return status;
}

/* Adds the path under the mixture of loads.  A mixture that nobody has asked for may have none:
 * where the structure gives way, or no load is left. */
static enum hobe_status add_path(struct source *s, int asked, struct hobe_error *err)
{
    struct mixture mixture;
    hobe_path *path = NULL;
    enum hobe_status status = mixture_open(&mixture, s->count, s->model, s->weight, err);
    if (!status) {
        status = follow(&mixture.model, arc_of(s), asked, &path, err);
        if (!status)
            status = add_states(&s->span, path, asked, err);
        else if (!asked && status != HOBE_NO_MEMORY)
            status = HOBE_OK;
    }
    hobe_path_free(path);
    mixture_close(&mixture);
    return status;
}

static enum hobe_status add_pair(struct source *s, int i, int j, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int k = 0; !status && k < 4 * PARTS; k++) {
        const double angle = acos(0) * k / PARTS;
        if (k % PARTS == 0) /* one of them alone */
            continue;
        s->weight[i] = cos(angle);
        s->weight[j] = sin(angle);
        status = add_path(s, 0, err);
    }
    s->weight[i] = s->weight[j] = 0;
    return status;
}

static enum hobe_status add_paths(struct source *s, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < s->count; i++) {
        s->weight[i] = 1;
        status = add_path(s, i < s->asked, err);
        s->weight[i] = -1;
        if (!status && s->count > 1)
            status = add_path(s, 0, err);
        s->weight[i] = 0;
        for (int j = 0; !status && j < i; j++)
            status = add_pair(s, i, j, err);
    }
    return status;
}

/* What principal fields may leave of the states: a tenth of what displacements may lack. */
static double share_of(const struct source *s)
{
    return s->options->accuracy / 10;
}

/* ---- the methods ----------------------------------------------------------------------------- */

static enum hobe_status by_series(struct source *s, struct hobe_error *err)
{
    const enum hobe_status status = add_paths(s, err);
    return status ? status : span_compress(&s->span, 0, s->options->modes, share_of(s), err);
}

/* The modes themselves, so that small vibrations are exact; then what they and the loads make of
 * one another. */
static enum hobe_status by_modes(struct source *s, struct hobe_error *err)
{
    const struct hobe_modes_info *info = &s->modes->info;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < info->count; i++)
        status = span_add(&s->span, modes_shape(s->modes, i, NULL), err);
    if (status)
        return status;
    span_orthonormalise(&s->span, 0);
    const long exact = s->span.n;
    status = add_paths(s, err);
    return status ? status
                  : span_compress(&s->span, exact, s->options->modes - exact, share_of(s), err);
}

static enum hobe_status by_fields(struct source *s, struct hobe_error *err)
{
    const long size = 3 * s->span.model->vectors;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < s->options->fields; i++)
        status = span_add(&s->span, s->options->field + i * size, err);
    if (!status)
        span_orthonormalise(&s->span, 0);
    return status;
}

static enum hobe_status make(struct source *s, struct hobe_error *err)
{
    switch (s->options->method) {
    case HOBE_REDUCE_MODES:
        return by_modes(s, err);
    case HOBE_REDUCE_FIELDS:
        return by_fields(s, err);
    default:
        return by_series(s, err);
    }
}

/* Displacements from a centre reach where those from the reference do if it is among the fields. */
static enum hobe_status add_centre(struct span *span, const hobe_solution *centre,
                                   struct hobe_error *err)
{
    const long before = span->n;
    const enum hobe_status status = span_add(span, centre->u, err);
    if (!status)
        span_orthonormalise(span, before);
    return status;
}

/* ---- all of it ------------------------------------------------------------------------------- */

static int has_loads(const hobe_model *model)
{
    const long size = 3 * model->moving;
    for (long i = 0; i < size; i++)
        if (model->dead[i] != 0)
            return 1;
    return model->spun || model->moments.count > 0 || model->gravities.count > 0 ||
           model->forces.count > 0;
}

/* The models whose loads are of interest; the others must be of the same shape. */
static enum hobe_status open_loads(struct source *s, hobe_model *full, struct hobe_error *err)
{
    const struct hobe_reduce *o = s->options;
    enum hobe_status status = HOBE_OK;
    if (has_loads(full))
        s->model[s->count++] = full;
    for (int i = 0; !status && i < o->load_count; i++) {
        status = hobe_model_build(o->loads[i], err);
        if (!status && !model_same_shape(full, o->loads[i]))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "the scenes of loads must have the beams, joints and supports of the "
                             "one that is reduced; number %d has others",
                             i + 1);
        s->model[s->count++] = o->loads[i];
    }
    s->asked = s->count;
    return status;
}

/* The factor of a mode that turns or shifts nothing by more than AMPLITUDE. */
static double amplitude_of(const hobe_model *model, const double *shape)
{
    double most = 0;
    for (size_t b = 0; b < model->beams.count; b++) {
        const struct beam *beam = model_beam(model, b);
        const struct hobe_kernel *k = beam->kernel;
        for (int e = 0; e < beam->spec.elements; e++)
            for (int v = 0; v < k->vectors; v++) {
                const int mode = k->vector[v].mode, slope = k->vector[v].slope;
                const double size = length3(shape + 3 * model_vector(model, beam, e, v));
                if (mode == 0 || (mode <= 2 && !slope)) /* r in m; r_x, r_y and r_z in rad */
                    most = fmax(most, mode == 0 && !slope ? size / beam->length : size);
            }
    }
    return AMPLITUDE / most;
}

/* How far mode i goes: with no more energy than the softest, or stiff ones would bend so far that
 * the structure gives way. */
static double factor_of(const struct source *s, int i)
{
    const hobe_model *model = s->span.model;
    const double *mu = s->modes->mu;
    int soft = 0;
    while (!(mu[soft] > 0))
        soft++;
    return fmin(amplitude_of(model, modes_shape(s->modes, i, NULL)),
                amplitude_of(model, modes_shape(s->modes, soft, NULL)) * sqrt(mu[soft] / mu[i]));
}

/* Forces of inertia M phi omega^2 s, which s phi answers to the first order. */
static enum hobe_status open_inertia(struct source *s, int i, struct hobe_error *err)
{
    const double *shape = modes_shape(s->modes, i, NULL), none = 0;
    struct mixture *to = s->inertia + i;
    s->opened++;
    const enum hobe_status status =
        mixture_open(to, 1, (hobe_model *const[]){s->span.model}, &none, err);
    if (!status)
        mass_force(s->span.model, s->modes->mu[i] * factor_of(s, i), shape, to->dead);
    s->model[s->count++] = &to->model;
    return status;
}

/* A quarter of the unknowns for modes, the rest for what they make of one another. */
static enum hobe_status open_modes(struct source *s, struct hobe_error *err)
{
    const struct hobe_reduce *o = s->options;
    struct hobe_modal_options options = {.modes = 1 + o->modes / 4};
    enum hobe_status status = hobe_modal(s->span.model, NULL, &options, &s->modes, err);
    if (status)
        return status;
    const size_t count = (size_t)s->modes->info.count;
    s->inertia = hobe_alloc(count, sizeof *s->inertia, err);
    if (!s->inertia)
        return HOBE_NO_MEMORY;
    for (int i = 0; !status && i < (int)count; i++)
        if (s->modes->mu[i] > 0)
            status = open_inertia(s, i, err);
    return status;
}

static enum hobe_status open_source(struct source *s, hobe_model *full, struct hobe_error *err)
{
    const struct hobe_reduce *o = s->options;
    const size_t room = (size_t)(1 + o->load_count + o->modes);
    s->model = hobe_alloc(room, sizeof *s->model, err);
    s->weight = hobe_alloc(room, sizeof *s->weight, err);
    if (!s->model || !s->weight)
        return HOBE_NO_MEMORY;
    enum hobe_status status = open_loads(s, full, err);
    if (!status && o->method == HOBE_REDUCE_SERIES && s->count == 0)
        status = hobe_fail(err, HOBE_BAD_INPUT, NULL,
                           "method \"series\" makes a basis of the paths under loads, and there "
                           "are none; give some, or take method = \"modes\"");
    if (!status)
        status = span_open(&s->span, full, NULL, err);
    return status || o->method != HOBE_REDUCE_MODES ? status : open_modes(s, err);
}

static void close_source(struct source *s)
{
    for (int i = 0; i < s->opened; i++)
        mixture_close(s->inertia + i);
    hobe_free(s->inertia);
    hobe_modes_free(s->modes);
    span_close(&s->span);
    hobe_free(s->model);
    hobe_free(s->weight);
}

/* The fields that a span has become. */
static void take(struct span *span, struct basis *basis)
{
    *basis = (struct basis){span->n, span->room, span->field};
    span->field = NULL;
}

static enum hobe_status check_closed(const struct hobe_reduce *o, struct hobe_error *err)
{
    if (o->closed != 0 && o->closed != 2 && o->closed != 3)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a basis is closed under rotations in a plane, 2, or in space, 3; got "
                         "closed = %d",
                         o->closed);
    if (o->closed == 2 && !(length3(o->normal) > 0 && isfinite(length3(o->normal))))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a basis closed in a plane needs its normal, got {%g, %g, %g}",
                         o->normal[0], o->normal[1], o->normal[2]);
    return HOBE_OK;
}

/* In space by functions, whose energy takes fewer numbers. */
static enum hobe_status close_span(struct span *span, long first, const struct hobe_reduce *o,
                                   struct hobe_error *err)
{
    if (basis_of_functions(o->closed, o->centre != NULL))
        span->group = 3;
    return closure_add(span, first, o->closed, o->normal, err);
}

enum hobe_status basis_make(hobe_model *full, const struct hobe_reduce *options,
                            struct basis *basis, struct hobe_error *err)
{
    struct hobe_reduce o = *options;
    struct source s = {.options = &o};
    *basis = (struct basis){0};
    if (o.modes <= 0)
        o.modes = o.accuracy > 0 ? MOST_MODES : DEFAULT_MODES;
    if (o.centre && o.modes > 1)
        o.modes--; /* and the centre itself */
    enum hobe_status status = check_closed(&o, err);
    if (!status)
        status = hobe_model_build(full, err);
    if (!status)
        status = open_source(&s, full, err);
    if (!status)
        status = make(&s, err);
    if (!status && o.centre && o.method != HOBE_REDUCE_FIELDS)
        status = add_centre(&s.span, o.centre, err);
    if (!status && o.closed)
        status = close_span(&s.span, 0, &o, err);
    if (!status)
        take(&s.span, basis);
    close_source(&s);
    return status;
}

enum hobe_status basis_add(struct basis *basis, hobe_model *full, const struct hobe_reduce *options,
                           const double *field, struct hobe_error *err)
{
    struct span span;
    enum hobe_status status = span_open(&span, full, NULL, err);
    for (long i = 0; !status && i < basis->n; i++)
        status = span_add(&span, basis->field + i * 3 * full->vectors, err);
    if (!status)
        status = span_add(&span, field, err);
    if (!status && options->closed)
        status = close_span(&span, basis->n, options, err);
    else if (!status)
        span_orthonormalise(&span, basis->n);
    if (!status) {
        basis_free(basis);
        take(&span, basis);
    }
    span_close(&span);
    return status;
}

void basis_free(struct basis *basis)
{
    hobe_free(basis->field);
}
