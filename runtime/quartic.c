/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "quartic.h"

#include "assemble.h"
#include "eigen.h"

#include <string.h>

/* The place of the pair (i, j) in a packed triangle. */
static long pair_of(long i, long j)
{
    return i > j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

static long aligned(long pairs)
{
    return (pairs + QUARTIC_ALIGN - 1) / QUARTIC_ALIGN * QUARTIC_ALIGN;
}

/* ---- offline: the matrix A of h -------------------------------------------------------------- */

/* Strains belong to pairs of fields, in the order of h: (u_c, x0 + x_c), (phi_i, 2 x_c), and
 * (phi_i, phi_j) with i >= j.  The first of a pair is a displacement. */
enum { CHANGE, SUM, TWICE, FIRST };

struct form {
    const hobe_model *model;
    const double *centre, *field; /* as in quartic_open */
    long n, size;                 /* of h */
    long (*pair)[2];              /* [size] */
    double *A;                    /* [size][size], its lower triangle */
    hobe_lanes *of;               /* [FIRST + n][3 V] the fields of a batch */
    hobe_lanes *strain, *stress;  /* [size][stations][grams] of a batch */
};

static void list_pairs(const struct form *form)
{
    long p = 0;
    form->pair[p][0] = CHANGE;
    form->pair[p++][1] = SUM;
    for (long i = 0; i < form->n; i++) {
        form->pair[p][0] = FIRST + i;
        form->pair[p++][1] = TWICE;
    }
    for (long i = 0; i < form->n; i++)
        for (long j = 0; j <= i; j++) {
            form->pair[p][0] = FIRST + i;
            form->pair[p++][1] = FIRST + j;
        }
}

/* Numbers of the strain of a pair in a batch, [stations][grams]. */
static long strains_of(const struct beam *beam, const struct batch *batch)
{
    return (long)hobe_element_invariants(batch->law)->stations *
           (beam->kernel->normals + beam->kernel->shears);
}

/* The largest sizes of all beams; HOBE_BAD_INPUT where an energy is not quartic. */
static enum hobe_status find_sizes(const struct form *form, long *vectors, long *strains,
                                   struct hobe_error *err)
{
    *vectors = *strains = 0;
    for (size_t i = 0; i < form->model->beams.count; i++) {
        const struct beam *beam = model_beam(form->model, i);
        if (!beam->kernel->gram)
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "a reduced model needs elements whose energy is a polynomial; that of "
                             "%s (beam \"%s\") is none: take one that is not \"structural\"",
                             beam->kernel->name, beam->name);
        *vectors = beam->kernel->vectors > *vectors ? beam->kernel->vectors : *vectors;
        for (int b = 0; b < beam->batches; b++) {
            const long here = strains_of(beam, beam->batch + b);
            *strains = here > *strains ? here : *strains;
        }
    }
    return HOBE_OK;
}

static enum hobe_status open_form(struct form *form, struct hobe_error *err)
{
    long vectors, strains;
    const size_t size = (size_t)form->size;
    const enum hobe_status status = find_sizes(form, &vectors, &strains, err);
    if (status)
        return status;
    form->pair = hobe_alloc(size, sizeof *form->pair, err);
    form->A = hobe_alloc(size * size, sizeof *form->A, err);
    form->of = hobe_alloc((size_t)(3 * (FIRST + form->n) * vectors), sizeof *form->of, err);
    form->strain = hobe_alloc(2 * size * (size_t)strains, sizeof *form->strain, err);
    if (!form->pair || !form->A || !form->of || !form->strain)
        return HOBE_NO_MEMORY;
    form->stress = form->strain + form->size * strains;
    list_pairs(form);
    return HOBE_OK;
}

static void close_form(const struct form *form)
{
    hobe_free(form->pair);
    hobe_free(form->A);
    hobe_free(form->of);
    hobe_free(form->strain);
}

/* A displacement on a batch; spare lanes do not move, and so have no strain. */
static void gather_displacement(const struct form *form, const struct beam *beam,
                                const struct batch *batch, const double *u, hobe_lanes *to)
{
    assemble_gather(form->model, beam, batch, u, to);
    for (int k = 0; k < 3 * beam->kernel->vectors; k++)
        for (int lane = batch->count; lane < HOBE_LANES; lane++)
            to[k][lane] = 0;
}

static void gather_fields(const struct form *form, const struct beam *beam,
                          const struct batch *batch)
{
    const long size = 3 * beam->kernel->vectors;
    hobe_lanes *change = form->of + CHANGE * size;
    if (form->centre)
        gather_displacement(form, beam, batch, form->centre, change);
    else
        memset(change, 0, (size_t)size * sizeof *change);
    for (long k = 0; k < size; k++) {
        form->of[SUM * size + k] = 2 * batch->q0[k] + change[k];
        form->of[TWICE * size + k] = 2 * (batch->q0[k] + change[k]);
    }
    for (long i = 0; i < form->n; i++)
        gather_displacement(form, beam, batch, form->field + 3 * form->model->vectors * i,
                            form->of + (FIRST + i) * size);
}

/* A += S'Q S of a batch. */
static void add_batch(const struct form *form, const struct beam *beam, const struct batch *batch)
{
    const long size = 3 * beam->kernel->vectors, strains = strains_of(beam, batch);
    gather_fields(form, beam, batch);
    for (long p = 0; p < form->size; p++)
        beam->kernel->gram(hobe_element_invariants(batch->law), form->of + form->pair[p][0] * size,
                           form->of + form->pair[p][1] * size, form->strain + p * strains,
                           form->stress + p * strains);
    eigen_add_product((int)form->size, (int)(HOBE_LANES * strains), (const double *)form->strain,
                      (const double *)form->stress, form->A);
}

/* ---- offline: tensors ------------------------------------------------------------------------ */

static double entry(const struct form *form, long p, long r)
{
    return p > r ? form->A[p * form->size + r] : form->A[r * form->size + p];
}

/* a_{ij,kl} = s_ij'Q s_kl; and k4_ijkl is the sum of 1/2 a over the permutations of i, j, k, l. */
static double quartic_term(const struct form *form, long i, long j, long k, long l)
{
    const long first = 1 + form->n;
    return 4 * (entry(form, first + pair_of(i, j), first + pair_of(k, l)) +
                entry(form, first + pair_of(i, k), first + pair_of(j, l)) +
                entry(form, first + pair_of(i, l), first + pair_of(j, k)));
}

static double cubic_term(const struct form *form, long i, long j, long k)
{
    const long first = 1 + form->n;
    return 2 *
           (entry(form, 1 + i, first + pair_of(j, k)) + entry(form, 1 + j, first + pair_of(i, k)) +
            entry(form, 1 + k, first + pair_of(i, j)));
}

/* Where the row of a pair begins in k4. */
static long row_of(long p)
{
    const long block = p / QUARTIC_ALIGN, width = QUARTIC_ALIGN * (block + 1);
    return QUARTIC_ALIGN * (QUARTIC_ALIGN * block * (block + 1) / 2) + p % QUARTIC_ALIGN * width;
}

static void fill_quartic(const struct form *form, long i, long j, double *row)
{
    const long last = pair_of(i, j) / QUARTIC_ALIGN * QUARTIC_ALIGN + QUARTIC_ALIGN;
    for (long k = 0; k < form->n; k++)
        for (long l = 0; l <= k && pair_of(k, l) < last; l++)
            row[pair_of(k, l)] = quartic_term(form, i, j, k, l);
}

static void fill(const struct form *form, struct quartic *q)
{
    const long n = form->n;
    q->k0 = 0.5 * form->A[0];
    for (long i = 0; i < n; i++) {
        q->k1[i] = entry(form, 1 + i, 0);
        for (long j = 0; j <= i; j++) {
            const long p = pair_of(i, j);
            q->k2[p] = entry(form, 1 + i, 1 + j) + 2 * entry(form, 1 + n + p, 0);
            for (long k = 0; k < n; k++)
                q->k3[k * q->pairs + p] = cubic_term(form, i, j, k);
            fill_quartic(form, i, j, q->k4 + row_of(p));
        }
    }
}

static enum hobe_status open_tensors(struct quartic *q, struct hobe_error *err)
{
    const size_t n = (size_t)q->n, pairs = (size_t)q->pairs;
    q->k1 = hobe_alloc(n, sizeof *q->k1, err);
    q->k2 = hobe_alloc(pairs, sizeof *q->k2, err);
    q->k3 = hobe_alloc(n * pairs, sizeof *q->k3, err);
    q->k4 = hobe_alloc((size_t)row_of(q->pairs), sizeof *q->k4, err);
    q->work = hobe_alloc(3 * pairs, sizeof *q->work, err);
    return q->k1 && q->k2 && q->k3 && q->k4 && q->work ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status quartic_open(struct quartic *q, const hobe_model *model, const double *centre,
                              long n, const double *field, struct hobe_error *err)
{
    const long pairs = n * (n + 1) / 2;
    struct form form = {
        .model = model, .centre = centre, .field = field, .n = n, .size = 1 + n + pairs};
    *q = (struct quartic){.n = n, .pairs = aligned(pairs)};
    enum hobe_status status = open_form(&form, err);
    if (!status)
        status = open_tensors(q, err);
    for (size_t i = 0; !status && i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int b = 0; b < beam->batches; b++)
            add_batch(&form, beam, beam->batch + b);
    }
    if (!status)
        fill(&form, q);
    close_form(&form);
    if (status)
        quartic_close(q);
    return status;
}

void quartic_close(struct quartic *q)
{
    hobe_free(q->k1);
    hobe_free(q->k2);
    hobe_free(q->k3);
    hobe_free(q->k4);
    hobe_free(q->work);
    *q = (struct quartic){.n = 0};
}

/* ---- online ---------------------------------------------------------------------------------- */

/* y = k4 w of pairs.  Each number of a block of rows is used twice, but for its last columns. */
static void multiply(const struct quartic *q, const double *w, double *y)
{
    const double *a = q->k4;
    for (long p = 0; p < q->pairs; p += QUARTIC_ALIGN) {
        const long width = p + QUARTIC_ALIGN;
        const double *b = a + width, *c = b + width, *d = c + width;
        double sum[QUARTIC_ALIGN] = {0};
        for (long k = 0; k < p; k++) {
            sum[0] += a[k] * w[k];
            sum[1] += b[k] * w[k];
            sum[2] += c[k] * w[k];
            sum[3] += d[k] * w[k];
            y[k] += a[k] * w[p] + b[k] * w[p + 1] + c[k] * w[p + 2] + d[k] * w[p + 3];
        }
        for (int r = 0; r < QUARTIC_ALIGN; r++) {
            y[p + r] = sum[r];
            for (long k = p; k < width; k++)
                y[p + r] += a[r * width + k] * w[k];
        }
        a = d + width;
    }
}

/* work = w, the pairs q_i q_j, twice where i > j; X = k3 q; Y = k4:qq. */
static void contract(const struct quartic *q, const double *x)
{
    double *w = q->work, *X = w + q->pairs, *Y = X + q->pairs;
    for (long i = 0, p = 0; i < q->n; i++, p++) {
        for (long j = 0; j < i; j++)
            w[p++] = 2 * x[i] * x[j];
        w[p] = x[i] * x[i];
    }
    memset(X, 0, (size_t)q->pairs * sizeof *X);
    for (long k = 0; k < q->n; k++)
        for (long p = 0; p < q->pairs; p++)
            X[p] += q->k3[k * q->pairs + p] * x[k];
    multiply(q, w, Y);
}

double quartic_energy(const struct quartic *q, const double *x)
{
    const double *w = q->work, *X = w + q->pairs, *Y = X + q->pairs;
    double energy = q->k0;
    contract(q, x);
    for (long i = 0; i < q->n; i++)
        energy += q->k1[i] * x[i];
    for (long p = 0; p < q->pairs; p++)
        energy += w[p] * (q->k2[p] / 2 + X[p] / 6 + Y[p] / 24);
    return energy;
}

void quartic_add(const struct quartic *q, const double *x, double *f, double *K)
{
    const long n = q->n;
    const double *X = q->work + q->pairs, *Y = X + q->pairs;
    contract(q, x);
    for (long i = 0, p = 0; i < n; i++) {
        f[i] += q->k1[i];
        for (long j = 0; j <= i; j++, p++) {
            const double secant = q->k2[p] + X[p] / 2 + Y[p] / 6;
            const double tangent = q->k2[p] + X[p] + Y[p] / 2;
            f[i] += secant * x[j];
            if (j < i)
                f[j] += secant * x[i];
            if (!K)
                continue;
            K[i * n + j] += tangent;
            if (j < i)
                K[j * n + i] += tangent;
        }
    }
}
