/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "strain_form.h"

#include "assemble.h"
#include "eigen.h"

#include <string.h>

struct form;

/* Where the fields of a batch come from: phi_0 first. */
typedef void gather_fields(const struct form *, const struct beam *, const struct batch *);

struct form {
    const hobe_model *model;
    const double *centre, *field; /* as given */
    gather_fields *gather;
    long n, pairs;               /* fields with what stands before those given; their pairs */
    hobe_lanes *of;              /* [n + 2][3 V] fields on a batch; u_c and x0 + x_c */
    hobe_lanes *strain, *stress; /* [pairs][stations][grams] of a batch */
    double *A;                   /* [pairs][pairs] */
};

/* ---- fields on a batch ----------------------------------------------------------------------- */

/* A displacement; spare lanes do not move, and so have no strain. */
static void gather_displacement(const struct form *form, const struct beam *beam,
                                const struct batch *batch, const double *u, hobe_lanes *to)
{
    assemble_gather(form->model, beam, batch, u, to);
    for (int k = 0; k < 3 * beam->kernel->vectors; k++)
        for (int lane = batch->count; lane < HOBE_LANES; lane++)
            to[k][lane] = 0;
}

static void gather_open(const struct form *form, const struct beam *beam, const struct batch *batch)
{
    const long size = 3 * beam->kernel->vectors;
    hobe_lanes *centre = form->of, *change = form->of + form->n * size, *sum = change + size;
    if (form->centre)
        gather_displacement(form, beam, batch, form->centre, change);
    else
        memset(change, 0, (size_t)size * sizeof *change);
    for (long k = 0; k < size; k++) {
        centre[k] = batch->q0[k] + change[k];
        sum[k] = batch->q0[k] + centre[k];
    }
    for (long i = 1; i < form->n; i++)
        gather_displacement(form, beam, batch, form->field + 3 * form->model->vectors * (i - 1),
                            form->of + i * size);
}

/* Functions as fields along x: products of section vectors are then those of the functions. */
static void gather_closed(const struct form *form, const struct beam *beam,
                          const struct batch *batch)
{
    const long V = beam->kernel->vectors, all = form->model->vectors;
    memset(form->of, 0, (size_t)(3 * V * form->n) * sizeof *form->of);
    for (long v = 0; v < V; v++)
        for (int lane = 0; lane < batch->count; lane++) {
            const long at = model_vector(form->model, beam, batch->first + lane, (int)v);
            for (long a = 0; a < 3; a++)
                form->of[3 * (V * a + v)][lane] = batch->q0[3 * v + a][lane];
            for (long i = 3; i < form->n; i++)
                form->of[3 * (V * i + v)][lane] = form->field[(i - 3) * all + at];
        }
}

/* ---- the form -------------------------------------------------------------------------------- */

/* Numbers of the strain of a pair on a batch, [stations][grams]. */
static long strains_of(const struct beam *beam, const struct batch *batch)
{
    return (long)hobe_element_invariants(batch->law)->stations *
           (beam->kernel->normals + beam->kernel->shears);
}

/* The largest sizes of all beams. */
static enum hobe_status find_sizes(const hobe_model *model, long *vectors, long *strains,
                                   struct hobe_error *err)
{
    *vectors = *strains = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (!beam->kernel->gram)
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "a reduced model needs elements whose energy is a polynomial; that of "
                             "%s (beam \"%s\") is none: take one that is not \"structural\"",
                             beam->spec.kernel->name, beam->name);
        *vectors = beam->kernel->vectors > *vectors ? beam->kernel->vectors : *vectors;
        for (int b = 0; b < beam->batches; b++) {
            const long here = strains_of(beam, beam->batch + b);
            *strains = here > *strains ? here : *strains;
        }
    }
    return HOBE_OK;
}

/* A += S'Q S of a batch.  Of a centre the first pair is (u_c, x0 + x_c), not (x_c, x_c). */
static void add_batch(const struct form *form, const struct beam *beam, const struct batch *batch)
{
    const struct hobe_invariants *inv = hobe_element_invariants(batch->law);
    const long size = 3 * beam->kernel->vectors, strains = strains_of(beam, batch);
    form->gather(form, beam, batch);
    for (long i = 0, at = 0; i < form->n; i++)
        for (long j = 0; j <= i; j++, at += strains) {
            const int centre = form->gather == gather_open && i == 0;
            const hobe_lanes *a = form->of + (centre ? form->n : i) * size;
            const hobe_lanes *b = centre ? a + size : form->of + j * size;
            beam->kernel->gram(inv, a, b, form->strain + at, form->stress + at);
        }
    eigen_add_product((int)form->pairs, (int)(HOBE_LANES * strains), (const double *)form->strain,
                      (const double *)form->stress, form->A);
}

static enum hobe_status open_form(struct form *form, struct hobe_error *err)
{
    long vectors, strains;
    form->pairs = form_pairs(form->n);
    const size_t pairs = (size_t)form->pairs;
    const enum hobe_status status = find_sizes(form->model, &vectors, &strains, err);
    if (status)
        return status;
    form->of = hobe_alloc((size_t)(3 * (form->n + 2) * vectors), sizeof *form->of, err);
    form->strain = hobe_alloc(2 * pairs * (size_t)strains, sizeof *form->strain, err);
    form->A = hobe_alloc(pairs * pairs, sizeof *form->A, err);
    if (!form->of || !form->strain || !form->A)
        return HOBE_NO_MEMORY;
    form->stress = form->strain + form->pairs * strains;
    return HOBE_OK;
}

static enum hobe_status make(struct form *form, double **A, struct hobe_error *err)
{
    const enum hobe_status status = open_form(form, err);
    for (size_t i = 0; !status && i < form->model->beams.count; i++) {
        const struct beam *beam = model_beam(form->model, i);
        for (int b = 0; b < beam->batches; b++)
            add_batch(form, beam, beam->batch + b);
    }
    hobe_free(form->of);
    hobe_free(form->strain);
    if (status)
        hobe_free(form->A);
    *A = status ? NULL : form->A;
    return status;
}

enum hobe_status strain_form(const hobe_model *model, const double *centre, long n,
                             const double *field, double **A, struct hobe_error *err)
{
    struct form form = {
        .model = model, .centre = centre, .field = field, .gather = gather_open, .n = 1 + n};
    return make(&form, A, err);
}

enum hobe_status strain_form_closed(const hobe_model *model, long n, const double *function,
                                    double **A, struct hobe_error *err)
{
    struct form form = {.model = model, .field = function, .gather = gather_closed, .n = 3 + n};
    return make(&form, A, err);
}
