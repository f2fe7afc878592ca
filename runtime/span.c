/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "span.h"

#include "assemble.h"
#include "eigen.h"
#include "pattern.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* Principal fields are orthogonal; one that is none any more when its image is taken anew, is
 * nothing but what rounding has left. */
static const double ROUNDED = 0.1;

/* A share of a function, as its stiffest field has it, is a larger one of the soft fields that it
 * is a part of: of a beam's bending by the slenderness. */
static const double INDEPENDENT = 1e-5, INDEPENDENT_FUNCTION = 1e-6;

static size_t field_size(const struct span *span)
{
    return (size_t)(3 * span->model->vectors);
}

static long unknowns(const struct span *span)
{
    return 3 * span->model->unknowns;
}

enum hobe_status span_open(struct span *span, hobe_model *model, const double *u,
                           struct hobe_error *err)
{
    *span = (struct span){.model = model, .group = 1};
    enum hobe_status status = pattern_columns(model, err);
    if (!status)
        status = pattern_matrix(model, COLUMNS, &span->K, err);
    span->x = status ? NULL : hobe_alloc((size_t)(2 * unknowns(span)), sizeof *span->x, err);
    double *state = span->x ? hobe_alloc(field_size(span), 2 * sizeof *state, err) : NULL;
    if (state) {
        if (u)
            memcpy(state, u, field_size(span) * sizeof *u);
        assemble(model, state, state + field_size(span), &span->K);
    }
    hobe_free(state);
    return state ? HOBE_OK : status ? status : HOBE_NO_MEMORY;
}

void span_close(struct span *span)
{
    hobe_free(span->K.value);
    hobe_free(span->field);
    hobe_free(span->image);
    hobe_free(span->x);
}

/* y = (K + diag K) x */
static void multiply(const struct span *span, const double *x, double *y)
{
    const struct pattern *p = &span->model->pattern;
    memset(y, 0, (size_t)unknowns(span) * sizeof *y);
    for (long j = 0; j < unknowns(span); j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            y[p->Ai[k]] += (p->Ai[k] == j ? 2 : 1) * span->K.value[k] * x[j];
}

static enum hobe_status grow(struct span *span, struct hobe_error *err)
{
    const long room = span->room > 0 ? 2 * span->room : 16;
    const size_t old = (size_t)span->room, new = (size_t)room;
    double *field =
        hobe_grow(span->field, old * field_size(span), new *field_size(span), sizeof *field, err);
    if (!field)
        return HOBE_NO_MEMORY;
    span->field = field;
    double *image = hobe_grow(span->image, old * (size_t)unknowns(span),
                              new *(size_t)unknowns(span), sizeof *image, err);
    if (!image)
        return HOBE_NO_MEMORY;
    span->image = image;
    span->room = room;
    return HOBE_OK;
}

enum hobe_status span_add(struct span *span, const double *field, struct hobe_error *err)
{
    const hobe_model *model = span->model;
    if (span->n == span->room && grow(span, err))
        return HOBE_NO_MEMORY;
    double *to = span->field + span->n * 3 * model->vectors;
    memset(to, 0, field_size(span) * sizeof *to);
    memset(span->x, 0, (size_t)unknowns(span) * sizeof *span->x);
    for (long v = 0; v < model->beam_vectors; v++) {
        const long of = model->alias[v];
        if (model->unknown[of] < 0)
            continue;
        for (int a = 0; a < 3; a++)
            to[3 * v + a] = span->x[3 * model->unknown[of] + a] = field[3 * of + a];
    }
    multiply(span, span->x, span->image + span->n * unknowns(span));
    span->n++;
    return HOBE_OK;
}

/* image_i . field_j over the beams' unknowns */
static double product_of_fields(const struct span *span, long i, long j)
{
    const hobe_model *model = span->model;
    const double *image = span->image + i * unknowns(span);
    const double *field = span->field + j * 3 * model->vectors;
    double sum = 0;
    for (long v = 0; v < model->beam_vectors; v++)
        if (model->alias[v] == v && model->unknown[v] >= 0)
            sum += dot3(image + 3 * model->unknown[v], field + 3 * v);
    return sum;
}

double span_product(const struct span *span, long i, long j)
{
    double sum = 0;
    for (long a = 0; a < span->group; a++)
        sum += product_of_fields(span, i + a, j + a);
    return sum;
}

static void axpy(long n, double factor, const double *x, double *y)
{
    for (long i = 0; i < n; i++)
        y[i] += factor * x[i];
}

void span_combine(struct span *span, long i, double factor, long j)
{
    const long N = 3 * span->model->vectors, n = unknowns(span);
    axpy(span->group * N, factor, span->field + j * N, span->field + i * N);
    axpy(span->group * n, factor, span->image + j * n, span->image + i * n);
}

static double length_of(const struct span *span, long i)
{
    return sqrt(fmax(0, span_product(span, i, i)));
}

void span_normalise(struct span *span, long i)
{
    const double length = length_of(span, i);
    if (length > 0)
        span_combine(span, i, 1 / length - 1, i);
}

/* Takes its parts along the first `count` fields from field i, twice, for what rounding leaves. */
static void take_parts(struct span *span, long count, long i)
{
    for (int again = 0; again < 2; again++)
        for (long j = 0; j < count; j += span->group)
            span_combine(span, i, -span_product(span, i, j), j);
}

static void move(struct span *span, long to, long from, long count)
{
    const size_t size = field_size(span), n = (size_t)unknowns(span), fields = (size_t)count;
    memmove(span->field + (size_t)to * size, span->field + (size_t)from * size,
            fields * size * sizeof(double));
    memmove(span->image + (size_t)to * n, span->image + (size_t)from * n,
            fields * n * sizeof(double));
}

void span_drop(struct span *span, long first, long end)
{
    move(span, first, end, span->n - end);
    span->n -= end - first;
}

/* Drops what is no longer than a share of what it was. */
static void orthonormalise(struct span *span, long first, double share)
{
    const long given = span->n;
    span->n = first;
    for (long i = first; i < given; i += span->group) {
        const long to = span->n;
        move(span, to, i, span->group);
        const double before = length_of(span, to);
        take_parts(span, to, to);
        if (!(length_of(span, to) > share * before))
            continue;
        span_normalise(span, to);
        span->n += span->group;
    }
}

void span_orthonormalise(struct span *span, long first)
{
    orthonormalise(span, first, span->group > 1 ? INDEPENDENT_FUNCTION : INDEPENDENT);
}

/* G[m][m] = the products of the fields from `first` on. */
static void fill_gram(const struct span *span, long first, long m, double *G)
{
    for (long i = 0; i < m; i++)
        for (long j = 0; j <= i; j++)
            G[i * m + j] = G[j * m + i] = span_product(span, first + i, first + j);
}

/* to += sum_i c[i] field (first + i) */
static void combine(const struct span *span, long first, long m, const double *c, double *to)
{
    const long size = 3 * span->model->vectors;
    for (long i = 0; i < m; i++)
        axpy(size, c[i], span->field + (first + i) * size, to);
}

/* How many of m principal fields, nu[m] ascending, leave no more than a share of all. */
static long count_principal(long m, const double *nu, long most, double share)
{
    double sum = 0, left = 0;
    long kept = m;
    for (long i = 0; i < m; i++)
        sum += nu[i];
    while (kept > 0 && left + nu[m - kept] <= share * share * sum)
        left += fmax(0, nu[m - kept--]); /* rounding makes some negative */
    return kept < most ? kept : most;
}

enum hobe_status span_compress(struct span *span, long first, long most, double share,
                               struct hobe_error *err)
{
    const long m = span->n - first, size = 3 * span->model->vectors;
    int definite = 1;
    double *G = hobe_alloc((size_t)(2 * m * m + m + (m < most ? m : most) * size), sizeof *G, err);
    if (!G)
        return HOBE_NO_MEMORY;
    double *one = G + m * m, *nu = one + m * m, *sum = nu + m;
    for (long i = 0; i < m; i++)
        one[i * m + i] = 1;
    for (long i = first; i < span->n; i++) /* of what is new alone */
        take_parts(span, first, i);
    fill_gram(span, first, m, G);
    enum hobe_status status = m > 0 ? eigen_dense((int)m, G, one, nu, &definite, err) : HOBE_OK;
    const long kept = status ? 0 : count_principal(m, nu, most, share);
    for (long k = 0; k < kept; k++)
        combine(span, first, m, G + (m - 1 - k) * m, sum + k * size);
    span->n = first;
    for (long k = 0; !status && k < kept; k++)
        status = span_add(span, sum + k * size, err);
    hobe_free(G);
    if (!status)
        orthonormalise(span, first, ROUNDED);
    return status;
}
