/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a reduced form keeps of its whole model: the basis where items act, inertia, damping. */
#include "mass.h"
#include "pattern.h"
#include "reduction_parts.h"
#include "vector3.h"

#include <string.h>

/* products[k][j] = phi_i,a' F_b with k = 3 a + b, for all i. */
static void project_parts(const struct reduction *r, const double *F, long i_step, double *products)
{
    for (long i = 0; i < r->n; i++) {
        const double *phi = reduction_field(r, i);
        double sum[9] = {0};
        for (long v = 0; v < r->whole->beam_vectors; v++)
            for (int k = 0; k < 9; k++)
                sum[k] += phi[3 * v + k / 3] * F[3 * v + k % 3];
        for (int k = 0; k < 9; k++)
            products[(k * r->n + i) * i_step] = sum[k];
    }
}

/* The inertia of beams and of the masses at them, projected. */
static enum hobe_status weigh(struct reduction *r, struct hobe_error *err)
{
    const hobe_model *whole = r->whole;
    const long n = r->n, beams = 3 * whole->beam_vectors;
    const size_t size = (size_t)(3 * whole->vectors);
    double *F = hobe_alloc(size, sizeof *F, err), *part = hobe_alloc(9 * (size_t)n, sizeof *F, err);
    for (long j = 0; F && part && j < n + 2; j++) { /* the fields, the centre, a translation */
        memset(F, 0, size * sizeof *F);
        memset(r->all, 0, size * sizeof *F);
        if (j < n)
            memcpy(r->all, reduction_field(r, j), (size_t)beams * sizeof *F);
        else if (j == n)
            model_reference(whole, r->all);
        else
            mass_translation(whole, 0, r->all);
        for (long i = 0; j == n && r->of->centre && i < beams; i++)
            r->all[i] += r->of->centre[i];
        mass_force(whole, 1, r->all, F);
        project_parts(r, F, j < n ? n : 1, j < n ? r->mass + j : j == n ? r->position : part);
    }
    for (int a = 0; F && part && a < 3; a++)
        memcpy(r->weight + a * n, part + 3 * a * n, (size_t)n * sizeof *part);
    hobe_free(F);
    hobe_free(part);
    return F && part ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The damping that holds back masses, where there is some. */
static enum hobe_status damp(struct reduction *r, struct hobe_error *err)
{
    const hobe_model *whole = r->whole;
    const size_t size = (size_t)(3 * whole->vectors), n = (size_t)r->n;
    int damped = 0;
    for (size_t b = 0; b < whole->beams.count; b++)
        damped |= model_beam(whole, b)->spec.damping.mass > 0;
    if (!damped)
        return HOBE_OK;
    r->damping = hobe_alloc(n * n, sizeof *r->damping, err);
    double *F = hobe_alloc(size, sizeof *F, err);
    for (long j = 0; r->damping && F && j < r->n; j++) {
        memset(F, 0, size * sizeof *F);
        for (size_t b = 0; b < whole->beams.count; b++)
            mass_force_of(whole, model_beam(whole, b), model_beam(whole, b)->spec.damping.mass,
                          reduction_field(r, j), F);
        for (long i = 0; i < r->n; i++)
            r->damping[i * r->n + j] = dot(3 * whole->beam_vectors, reduction_field(r, i), F);
    }
    hobe_free(F);
    return r->damping && F ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The basis where items act. */
static enum hobe_status touch(struct reduction *r, struct hobe_error *err)
{
    const struct touched *t = &r->whole->touched;
    enum hobe_status status = pattern_touch(r->whole, err);
    if (!status)
        status = pattern_matrix(r->whole, TOUCHED, &r->K, err);
    while (!status && r->touched < t->count && t->vector[r->touched] < r->whole->beam_vectors)
        r->touched++;
    const size_t rows = 3 * (size_t)r->touched, n = (size_t)r->n;
    r->vector = t->vector;
    r->J = status ? NULL : hobe_alloc(rows * n, sizeof *r->J, err);
    r->product = status ? NULL : hobe_alloc(rows * n, sizeof *r->product, err);
    for (size_t k = 0; r->J && k < rows; k++)
        for (long j = 0; j < r->n; j++)
            r->J[k * n + (size_t)j] = reduction_field(r, j)[3 * r->vector[k / 3] + (long)k % 3];
    return status ? status : r->J && r->product ? HOBE_OK : HOBE_NO_MEMORY;
}

static enum hobe_status allocate(struct reduction *r, struct hobe_error *err)
{
    const size_t n = (size_t)r->n, size = (size_t)(3 * r->whole->vectors);
    r->mass = hobe_alloc(9 * n * n, sizeof *r->mass, err);
    r->position = hobe_alloc(9 * n, sizeof *r->position, err);
    r->weight = hobe_alloc(3 * n, sizeof *r->weight, err);
    r->u = hobe_alloc(size, sizeof *r->u, err);
    r->v = hobe_alloc(size, sizeof *r->v, err);
    r->f = hobe_alloc(size, sizeof *r->f, err);
    r->all = hobe_alloc(size, sizeof *r->all, err);
    r->dense = hobe_alloc(n * n + n, sizeof *r->dense, err);
    r->scale = hobe_alloc((size_t)(3 * r->whole->unknowns), sizeof *r->scale, err);
    return r->mass && r->position && r->weight && r->u && r->v && r->f && r->all && r->dense &&
                   r->scale
               ? HOBE_OK
               : HOBE_NO_MEMORY;
}

/* The state q = 0 at the vectors touched. */
static const double *reference(const struct reduction *r)
{
    for (long k = 0; r->of->centre && k < r->touched; k++)
        memcpy(r->u + 3 * r->vector[k], r->of->centre + 3 * r->vector[k], 3 * sizeof *r->u);
    return r->u;
}

struct reduction *reduction_open(const struct hobe_reduced *of, hobe_model *whole,
                                 struct hobe_error *err)
{
    struct reduction *r = hobe_alloc(1, sizeof *r, err);
    if (!r)
        return NULL;
    *r = (struct reduction){
        .of = of, .whole = whole, .n = of->basis.n, .blocks = (of->basis.n + 2) / 3};
    if (!allocate(r, err) && !touch(r, err) && !reduction_drop(r, reference(r), err) &&
        !weigh(r, err) && !damp(r, err))
        return r;
    reduction_free(r);
    return NULL;
}

void reduction_free(struct reduction *r)
{
    if (!r)
        return;
    double *const memory[] = {r->J, r->mass, r->damping, r->position, r->weight, r->u,    r->v,
                              r->f, r->all,  r->K.value, r->product,  r->dense,  r->scale};
    for (size_t i = 0; i < sizeof memory / sizeof *memory; i++)
        hobe_free(memory[i]);
    hobe_free(r->dropped);
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(r->place[layout]);
    hobe_free(r);
}
