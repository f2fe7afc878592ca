/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "component_modes.h"

#include "mass.h"
#include "pattern.h"
#include "pencil.h"

#include <string.h>

enum { FIRST_MODES = 16 }; /* looked for below a frequency */

/* ---- the interfaces ------------------------------------------------------------------------- */

/* Keeps all vectors of a node of an element one of whose vectors is touched. */
static void keep_nodes(const struct hobe_model *model, const struct beam *beam, int e,
                       const unsigned char *touched, unsigned char *kept)
{
    const struct hobe_kernel *k = beam->kernel;
    for (int v = 0; v < k->vectors; v++)
        for (int w = 0; w < k->vectors && touched[model_vector(model, beam, e, v)]; w++) {
            const long unknown = model->unknown[model_vector(model, beam, e, w)];
            if (k->vector[w].node == k->vector[v].node && unknown >= 0)
                kept[unknown] = 1;
        }
}

enum hobe_status component_interfaces(const struct hobe_model *model, unsigned char *kept,
                                      struct hobe_error *err)
{
    unsigned char *touched = hobe_alloc((size_t)model->vectors, sizeof *touched, err);
    if (!touched)
        return HOBE_NO_MEMORY;
    pattern_mark(model, 0, touched);
    for (size_t i = 0; i < model->beams.count; i++)
        for (int e = 0; e < model_beam(model, i)->spec.elements; e++)
            keep_nodes(model, model_beam(model, i), e, touched, kept);
    for (long v = model->beam_vectors; v < model->vectors; v++)
        if (model->unknown[v] >= 0)
            kept[model->unknown[v]] = 1;
    hobe_free(touched);
    return HOBE_OK;
}

/* ---- the matrices --------------------------------------------------------------------------- */

/* A structure that is cut at its interfaces. */
struct cut {
    struct pencil s;                      /* K and M, later with the interfaces held; scaled */
    unsigned char *kept;                  /* [unknowns] component_interfaces */
    long boundary, multipliers, interior; /* scalar unknowns: n = their sum */
};

static enum hobe_status open_cut(struct cut *cut, struct hobe_error *err)
{
    struct hobe_model *model = cut->s.model;
    const enum hobe_status status = pencil_open(&cut->s, "a projection", err);
    if (status)
        return status;
    cut->kept = hobe_alloc((size_t)model->unknowns, sizeof *cut->kept, err);
    if (!cut->kept || component_interfaces(model, cut->kept, err))
        return HOBE_NO_MEMORY;
    for (long v = model->moving; v < model->vectors; v++)
        cut->multipliers += model->unknown[v] >= 0 ? 3 : 0;
    for (long i = 0; i < model->unknowns; i++)
        cut->boundary += cut->kept[i] ? 3 : 0;
    cut->interior = cut->s.n - cut->boundary;
    cut->boundary -= cut->multipliers;
    return HOBE_OK;
}

static void close_cut(struct cut *cut)
{
    pencil_close(&cut->s);
    hobe_free(cut->kept);
}

static void assemble_cut(struct cut *cut, const double *u, double factor)
{
    struct pencil *s = &cut->s;
    memcpy(s->u, u, (size_t)(3 * s->model->vectors) * sizeof *u);
    pencil_tangent(s, factor, s->Ax);
    mass_matrix(s->model, 1, &(struct matrix){COLUMNS, s->Mx});
    pattern_scale(s->model, &(struct matrix){COLUMNS, s->Ax}, s->scale);
    pencil_scale(s, s->Ax);
    pencil_scale(s, s->Mx);
}

/* side[boundary + multipliers][n] = -K_ib e_k of the constraint modes, zero where kept. */
static void take_sides(const struct cut *cut, double *side)
{
    const struct pencil *s = &cut->s;
    const struct pattern *p = &s->model->pattern;
    for (long j = 0; j < s->n; j++) {
        if (!cut->kept[j / 3])
            continue;
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            if (!cut->kept[p->Ai[k] / 3])
                side[p->Ai[k]] = -s->Ax[k];
        side += s->n;
    }
}

/* K and M with the interfaces held: unit rows and columns, and zero ones. */
static void hold_interfaces(struct cut *cut)
{
    struct pencil *s = &cut->s;
    const struct pattern *p = &s->model->pattern;
    for (long j = 0; j < s->n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            if (cut->kept[j / 3] || cut->kept[p->Ai[k] / 3]) {
                s->Ax[k] = p->Ai[k] == j;
                s->Mx[k] = 0;
            }
    s->multipliers = 0;
    s->rank = cut->interior;
}

/* ---- modes ---------------------------------------------------------------------------------- */

/* Takes a field in the pencil's scale, x = phi/D. */
static void take(const struct cut *cut, const double *x, struct subspace *space)
{
    double *phi = subspace_next(space);
    for (long i = 0; i < cut->s.n; i++)
        phi[i] = cut->s.scale[i] * x[i];
    subspace_take(space);
}

static enum hobe_status take_constraint_modes(struct cut *cut, double *side, struct subspace *space,
                                              struct hobe_error *err)
{
    struct pencil *s = &cut->s;
    if (cut->interior == s->n)
        return HOBE_OK;
    enum hobe_status status = pencil_factor(s, s->Ax, s->ones, err);
    if (status == HOBE_SINGULAR)
        return hobe_fail(err, status, NULL,
                         "the scene can move without resistance while its interfaces, the nodes at "
                         "joints, springs and loads, are held; component modes need it held");
    for (long j = 0; !status && j < s->n; j++) {
        if (!cut->kept[j / 3])
            continue;
        status = pencil_divide(s, side, err);
        side[j] = 1;
        if (!status)
            take(cut, side, space);
        side += s->n;
    }
    return status;
}

/* Finds the lowest modes: *count of them as asked for or, up to a frequency, more and more until
 * one lies beyond.  As many as the interior has unknowns are not looked for. */
static enum hobe_status solve_modes(struct cut *cut, const struct hobe_projection *projection,
                                    long *count, struct hobe_error *err)
{
    const int open = projection->frequency > 0;
    const double most = projection->frequency * projection->frequency;
    enum hobe_status status = HOBE_OK;
    long below = 0;
    *count = open ? FIRST_MODES : projection->modes - cut->boundary;
    if (cut->interior == 0)
        *count = 0;
    for (int again = *count > 0 && (open || *count < cut->interior); !status && again;) {
        *count = *count < cut->interior ? *count : cut->interior;
        struct hobe_modal_options options = {.modes = (int)*count};
        int unstable;
        status = pencil_choose(&cut->s, &options, err);
        if (!status)
            status = pencil_solve(&cut->s, &options, &unstable, err);
        while (!status && open && below < *count && cut->s.mu[below] <= most)
            below++;
        again = open && below == *count && below < cut->interior;
        if (open)
            *count = again ? 2 * *count : below;
    }
    return status;
}

static void take_normal_modes(const struct cut *cut, long count, struct subspace *space)
{
    for (long i = 0; i < count; i++) {
        double *x = cut->s.X + i * cut->s.n;
        for (long j = 0; j < cut->s.n; j++)
            x[j] = cut->kept[j / 3] ? 0 : x[j];
        take(cut, x, space);
    }
}

static void take_interior(const struct cut *cut, struct subspace *space)
{
    for (long i = 0; i < cut->s.model->unknowns; i++)
        if (!cut->kept[i])
            subspace_take_vector(space, i);
}

static enum hobe_status find_modes(struct cut *cut, const struct hobe_projection *projection,
                                   const double *u, double factor, struct subspace *space,
                                   struct hobe_error *err)
{
    const long sides = cut->boundary + cut->multipliers;
    long count;
    double *side = hobe_alloc((size_t)(sides * cut->s.n), sizeof *side, err);
    if (!side)
        return HOBE_NO_MEMORY;
    assemble_cut(cut, u, factor);
    take_sides(cut, side);
    hold_interfaces(cut);
    enum hobe_status status = take_constraint_modes(cut, side, space, err);
    hobe_free(side);
    if (!status)
        status = solve_modes(cut, projection, &count, err);
    if (!status && count >= cut->interior)
        take_interior(cut, space);
    else if (!status)
        take_normal_modes(cut, count, space);
    return status;
}

/* What is asked for is there. */
static enum hobe_status check(const struct cut *cut, const struct hobe_projection *projection,
                              struct hobe_error *err)
{
    if (projection->frequency > 0 || projection->modes >= cut->boundary)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "modes of a projection must be at least %ld, one for each displacement of the "
                     "nodes at joints, springs and loads, got %d",
                     cut->boundary, projection->modes);
}

enum hobe_status component_modes(struct hobe_model *model, const struct hobe_projection *projection,
                                 const double *u, double factor, const double *scale,
                                 struct subspace *space, struct hobe_error *err)
{
    struct cut cut = {.s.model = model};
    enum hobe_status status = mass_check(model, "a projection by component modes", NULL, err);
    if (!status)
        status = open_cut(&cut, err);
    if (!status)
        status = check(&cut, projection, err);
    const long most = cut.interior + cut.boundary;
    const int all = projection->frequency > 0 || projection->modes > most;
    if (!status)
        status = subspace_open(space, model, scale,
                               cut.multipliers + (all ? most : projection->modes), err);
    if (!status)
        status = find_modes(&cut, projection, u, factor, space, err);
    close_cut(&cut);
    return status;
}
