/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reduced.h"

#include "assemble.h"
#include "enrich.h"
#include "journal.h"
#include "pattern.h"
#include "reduction.h"
#include "solution.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* What beams and supports have in common in two models is the same to this. */
static const double SAME = 1e-9;

/* ---- what models have in common -------------------------------------------------------------- */

enum hobe_status reduced_fingerprint(const hobe_model *model, struct fingerprint *print,
                                     struct hobe_error *err)
{
    const size_t n = (size_t)(3 * model->vectors), beams = (size_t)model->beam_vectors;
    double *u = hobe_alloc(n, sizeof *u, err), *q = hobe_alloc(n, sizeof *q, err);
    const uint64_t joined = journal_sum(model->alias, beams * sizeof *model->alias);
    *print = (struct fingerprint){.whole = joined ^ journal_sum(model->held, beams)};
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const uint64_t is[3] = {print->whole, (uint64_t)beam->spec.elements,
                                journal_sum(beam->kernel->hash, strlen(beam->kernel->hash))};
        print->whole = journal_sum(is, sizeof is);
    }
    for (size_t i = 0; u && q && i < 3 * beams; i++) /* any field that is not even */
        u[i] = 0.1 * sin(1 + 0.7 * (double)i);
    if (u && q) {
        model_reference(model, q);
        print->number[0] = assemble_energy(model, u);
        print->number[1] = dot((long)(3 * beams), u, q);
    }
    hobe_free(u);
    hobe_free(q);
    return u && q ? HOBE_OK : HOBE_NO_MEMORY;
}

int reduced_same(const struct fingerprint *a, const struct fingerprint *b)
{
    int same = a->whole == b->whole;
    for (int i = 0; i < 2; i++)
        same &= fabs(a->number[i] - b->number[i]) <= SAME * fabs(a->number[i]);
    return same;
}

/* ---- bases ----------------------------------------------------------------------------------- */

static enum hobe_status check_options(const hobe_model *model, const struct hobe_reduce *o,
                                      struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (!beam->kernel->trilinear)
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "beam \"%s\" cannot be reduced: the energy of element %s is no "
                             "polynomial; use another element",
                             beam->name, beam->spec.kernel->name);
    }
    if (model->beams.count == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "a scene without a beam cannot be reduced");
    if (o->modes < 0 || !(o->accuracy >= 0 && isfinite(o->accuracy)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a basis needs modes >= 0 and accuracy >= 0, got %d and %g", o->modes,
                         o->accuracy);
    if (o->centre && o->centre->model != model)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the centre of a basis must be a state of the scene that is reduced");
    return HOBE_OK;
}

static enum hobe_status copy_centre(struct hobe_reduced *r, const hobe_solution *centre,
                                    struct hobe_error *err)
{
    const size_t size = (size_t)(3 * r->model->vectors);
    if (!centre)
        return HOBE_OK;
    r->centre = hobe_alloc(size, sizeof *r->centre, err);
    if (!r->centre)
        return HOBE_NO_MEMORY;
    memcpy(r->centre, centre->u, size * sizeof *r->centre);
    return HOBE_OK;
}

/* ---- energy ---------------------------------------------------------------------------------- */

static int has_functions(const struct hobe_reduced *r)
{
    return basis_of_functions(r->info.closed, r->centre != NULL);
}

/* Of the functions psi_b, the x components of every third field. */
static enum hobe_status open_closed(struct hobe_reduced *r, struct hobe_error *err)
{
    const long n = r->basis.n / 3, vectors = r->model->vectors;
    double *function = hobe_alloc((size_t)(n * vectors), sizeof *function, err);
    if (!function)
        return HOBE_NO_MEMORY;
    for (long b = 0; b < n; b++)
        for (long v = 0; v < vectors; v++)
            function[b * vectors + v] = r->basis.field[3 * (3 * b * vectors + v)];
    const enum hobe_status status = quartic_closed_open(&r->closed, r->model, n, function, err);
    hobe_free(function);
    return status;
}

static enum hobe_status open_energy(struct hobe_reduced *r, struct hobe_error *err)
{
    return has_functions(r)
               ? open_closed(r, err)
               : quartic_open(&r->quartic, r->model, r->centre, r->basis.n, r->basis.field, err);
}

static void close_energy(struct hobe_reduced *r)
{
    quartic_close(&r->quartic);
    quartic_closed_close(&r->closed);
}

double reduced_energy(const struct hobe_reduced *r, const double *q)
{
    return has_functions(r) ? quartic_closed_energy(&r->closed, q) : quartic_energy(&r->quartic, q);
}

void reduced_add(const struct hobe_reduced *r, const double *q, double *f, double *K)
{
    if (has_functions(r))
        quartic_closed_add(&r->closed, q, f, K);
    else
        quartic_add(&r->quartic, q, f, K);
}

enum hobe_status reduced_finish(struct hobe_reduced *r, double started, struct hobe_error *err)
{
    enum hobe_status status = reduced_fingerprint(r->model, &r->fingerprint, err);
    close_energy(r);
    if (!status)
        status = open_energy(r, err);
    r->info.unknowns = (int)r->basis.n;
    r->info.whole = 3 * r->model->unknowns;
    r->info.seconds = hobe_seconds() - started;
    return status;
}

enum hobe_status hobe_reduce(hobe_model *model, const struct hobe_reduce *options,
                             hobe_reduced **reduced, struct hobe_error *err)
{
    *reduced = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (!status)
        status = check_options(model, options, err);
    if (status)
        return status;
    const double started = hobe_seconds();
    hobe_reduced *r = hobe_alloc(1, sizeof *r, err);
    if (!r)
        return HOBE_NO_MEMORY;
    *r = (struct hobe_reduced){.model = model,
                               .info = {.method = options->method, .closed = options->closed}};
    status = copy_centre(r, options->centre, err);
    if (!status)
        status = basis_make(model, options, &r->basis, err);
    if (!status)
        status = reduced_finish(r, started, err);
    if (!status && options->accuracy > 0)
        status = enrich(r, options, started, err);
    if (status)
        hobe_reduced_free(r);
    else
        *reduced = r;
    return status;
}

void hobe_reduced_free(hobe_reduced *r)
{
    if (!r)
        return;
    close_energy(r);
    basis_free(&r->basis);
    hobe_free(r->centre);
    hobe_free(r);
}

void hobe_reduced_info(const hobe_reduced *reduced, struct hobe_reduced_info *info)
{
    *info = reduced->info;
}

/* ---- models ---------------------------------------------------------------------------------- */

/* Arrays of a model whose vectors are coordinates, and what lies behind the beams' of the whole. */
static enum hobe_status number(hobe_model *small, struct hobe_error *err)
{
    const struct reduction *r = small->reduction;
    const hobe_model *whole = r->whole;
    const long behind = whole->beam_vectors - r->blocks;
    small->beam_vectors = r->blocks;
    small->moving = whole->moving - behind;
    small->vectors = whole->vectors - behind;
    const size_t n = (size_t)small->vectors;
    small->alias = hobe_alloc(n, sizeof *small->alias, err);
    small->unknown = hobe_alloc(n, sizeof *small->unknown, err);
    small->held = hobe_alloc(n, sizeof *small->held, err);
    small->dead = hobe_alloc(3 * n, sizeof *small->dead, err);
    if (!small->alias || !small->unknown || !small->held || !small->dead)
        return HOBE_NO_MEMORY;
    for (long v = 0; v < small->vectors; v++) {
        small->alias[v] = v;
        small->held[v] = v >= r->blocks && whole->held[v + behind];
        small->unknown[v] = small->held[v] ? -1 : small->unknowns++;
    }
    reduction_project(small, 1, whole->dead, small->dead);
    return HOBE_OK;
}

static enum hobe_status build(hobe_model *small, const hobe_reduced *reduced, hobe_model *whole,
                              struct hobe_error *err)
{
    small->reduction = reduction_open(reduced, whole, err);
    if (!small->reduction)
        return HOBE_NO_MEMORY;
    small->failure = whole->failure;
    small->spin = whole->spin;
    small->spun = whole->spun;
    small->loose = whole->loose;
    small->schedule.threads = 1;
    const enum hobe_status status = number(small, err);
    return status ? status : pattern_build(small, err);
}

/* The model has the beams of the basis, held and joined alike. */
static enum hobe_status check_beams(const hobe_reduced *reduced, const hobe_model *model,
                                    struct hobe_error *err)
{
    struct fingerprint print;
    const enum hobe_status status = reduced_fingerprint(model, &print, err);
    if (!status && (reduced->model->beam_vectors != model->beam_vectors ||
                    !reduced_same(&print, &reduced->fingerprint)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a basis serves scenes of the same beams, joins and clamps alone; "
                         "reduce this one by itself");
    return status;
}

enum hobe_status hobe_reduced_model(const hobe_reduced *reduced, hobe_model *model,
                                    hobe_model **small, struct hobe_error *err)
{
    const double started = hobe_seconds();
    *small = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (status)
        return status;
    status = check_beams(reduced, model, err);
    hobe_model *made = status ? NULL : hobe_alloc(1, sizeof *made, err);
    if (!made)
        return status ? status : HOBE_NO_MEMORY;
    status = build(made, reduced, model, err);
    made->built = 1;
    made->setup = hobe_seconds() - started;
    if (status)
        hobe_model_free(made);
    else
        *small = made;
    return status;
}
