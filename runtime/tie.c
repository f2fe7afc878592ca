/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ties: two places, the vectors that move them, and what acts there. */
#include "body.h"
#include "constraint.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* The axial functions of a place's vectors, zero where they have no part in r, y or z. */
static void weigh(struct place place, double N[HOBE_MAX_VECTORS], double Nx[HOBE_MAX_VECTORS])
{
    const struct beam *beam = place.beam;
    const double length = hobe_element_invariants(beam_law(beam, place.element))->length;
    beam->kernel->shape(place.xi, length, N, Nx);
    for (int v = 0; v < beam->kernel->vectors; v++)
        if (beam->kernel->vector[v].mode > 2 || fabs(N[v]) < 1e-12)
            N[v] = 0; /* at a node all but its own are, to rounding */
}

void tied_at(struct place place, struct tied *tied)
{
    const struct beam *beam = place.beam;
    const double at = (place.element + place.xi) / beam->spec.elements;
    const double *q0 = beam_q0(beam, place.element);
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS], field[3][3] = {{0}};
    weigh(place, N, Nx);
    for (int v = 0; v < beam->kernel->vectors; v++)
        if (N[v] != 0)
            add3(N[v], q0 + 3 * v, field[beam->kernel->vector[v].mode]);
    *tied = (struct tied){.place = place};
    beam_frame(beam, place.element, N, Nx, tied->frame);
    for (int a = 0; a < 3; a++)
        tied->position[a] = beam->origin ? beam->origin[place.element][a] + field[0][a]
                                         : beam->end[0][a] + at * beam->length * tied->frame[0][a];
    memcpy(tied->D0[1], field[1], sizeof field[1]);
    memcpy(tied->D0[2], field[2], sizeof field[2]);
    cross3(field[1], field[2], tied->D0[0]);
}

void tied_on_body(const struct body *body, const double point[3], const int slope[2],
                  struct tied *tied)
{
    *tied = (struct tied){.body = body, .slope = {slope[0], slope[1]}};
    memcpy(tied->position, point, sizeof tied->position);
    for (int i = 0; i < 2; i++)
        tied->D0[1 + i][slope[i]] = 1;
    cross3(tied->D0[1], tied->D0[2], tied->D0[0]);
    for (int i = 0; i < 3; i++)
        tied->frame[i][i] = 1;
}

struct tie *tie_add(struct hobe_model *model, const struct tied *a, const struct tied *b,
                    struct hobe_error *err)
{
    struct tie *tie = list_append(&model->ties, sizeof *tie, err);
    if (tie)
        *tie = (struct tie){.side = {*a, *b}};
    return tie;
}

struct constraint *tie_constraint(struct tie *tie)
{
    return &tie->constraint[tie->constraints++];
}

void tie_turning(struct tie *tie)
{
    for (int k = 0; k < 3; k++) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        struct constraint *c = tie_constraint(tie);
        for (int i = 0; i < 3; i++) {
            c->turn[i][l] = dot3(tie->side[0].frame[i], tie->side[1].frame[m]) / 2;
            c->turn[i][m] = -dot3(tie->side[0].frame[i], tie->side[1].frame[l]) / 2;
        }
    }
}

void tie_slopes(struct tie *tie)
{
    const int section = tie->side[0].place.beam ? 0 : 1;
    for (int i = 1; i < 3; i++)
        for (int j = 0; j < 3; j++)
            tie_constraint(tie)->turn[section ? j : i][section ? i : j] = 1;
}

/* The place of a number among the tie's vectors, where it is put unless it is there. */
static int enter(struct tie *tie, long number)
{
    int i = 0;
    while (i < tie->vectors && tie->vector[i] != number)
        i++;
    if (i == tie->vectors)
        tie->vector[tie->vectors++] = number;
    return i;
}

/* A vector's part in r, y or z (0, 1, 2) of a side, unless it has none. */
static void add_term(struct tie *tie, int side, long vector, int what, double weight)
{
    if (weight != 0)
        tie->term[tie->terms++] = (struct tie_term){enter(tie, vector), 3 * side + what, weight};
}

static void add_terms(const struct hobe_model *model, struct tie *tie, int side)
{
    const struct tied *tied = tie->side + side;
    const struct place place = tied->place;
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS];
    if (tied->body) {
        body_weights(tied->body, tied->position, N);
        for (int v = 0; v < BODY_VECTORS; v++)
            add_term(tie, side, tied->body->first + v, 0, N[v]);
        for (int i = 0; i < 2; i++)
            add_term(tie, side, tied->body->first + 1 + tied->slope[i], 1 + i, 1);
    }
    if (!place.beam)
        return;
    weigh(place, N, Nx);
    for (int v = 0; v < place.beam->kernel->vectors; v++)
        add_term(tie, side, model_vector(model, place.beam, place.element, v),
                 place.beam->kernel->vector[v].mode, N[v]);
}

/* At most so many terms has a side. */
static size_t most_terms(const struct tied *tied)
{
    if (tied->body)
        return BODY_VECTORS + 2;
    return tied->place.beam ? (size_t)tied->place.beam->kernel->vectors : 0;
}

enum hobe_status tie_resolve(struct hobe_model *model, struct tie *tie, struct hobe_error *err)
{
    const size_t most = most_terms(tie->side) + most_terms(tie->side + 1);
    tie->blocks = (tie->constraints + 2) / 3;
    tie->term = hobe_alloc(most, sizeof *tie->term, err);
    tie->vector = hobe_alloc(most + (size_t)tie->blocks, sizeof *tie->vector, err);
    if (!tie->term || !tie->vector)
        return HOBE_NO_MEMORY;
    for (int s = 0; s < 2; s++)
        add_terms(model, tie, s);
    tie->multiplier = model->vectors;
    for (int b = 0; b < tie->blocks; b++)
        tie->vector[tie->vectors++] = model->vectors++;
    return HOBE_OK;
}

void tie_free(struct tie *tie)
{
    hobe_free(tie->term);
    hobe_free(tie->vector);
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(tie->place[layout]);
}

/* ---- what moves and acts there --------------------------------------------------------------- */

void tie_motion(const struct tie *tie, const double *field, double moved[TIE_VECTORS][3])
{
    memset(moved, 0, sizeof(double[TIE_VECTORS][3]));
    for (const struct tie_term *t = tie->term; field && t < tie->term + tie->terms; t++)
        add3(t->weight, field + 3 * tie->vector[t->entry], moved[t->what]);
}

void tie_add_side(const struct tie *tie, int side, double factor, const double G[TIE_VECTORS][3],
                  double *f)
{
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++)
        if (t->what / 3 == side)
            add3(factor * t->weight, G[t->what], f + 3 * tie->vector[t->entry]);
}

void tie_add_force(const struct tie *tie, double factor, const double G[TIE_VECTORS][3], double *f)
{
    for (int side = 0; side < 2; side++)
        tie_add_side(tie, side, factor, G, f);
}

double *tie_scalar(const struct hobe_model *model, const struct tie *tie, int i, int a, int j,
                   int b, const struct matrix *K)
{
    const long place = tie->place[K->layout][i * tie->vectors + j];
    if (place < 0)
        return NULL;
    return K->value + place + b * model->stride[K->layout][model->unknown[tie->vector[j]]] + a;
}

void tie_add_at(const struct hobe_model *model, const struct tie *tie, int i, int a, int j, int b,
                double amount, const struct matrix *K)
{
    double *at = tie_scalar(model, tie, i, a, j, b, K);
    if (at)
        *at += amount;
}

void tie_add_tangent(const struct hobe_model *model, const struct tie *tie,
                     double H[TIE_VECTORS][TIE_VECTORS][3][3], const struct matrix *K)
{
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++)
        for (const struct tie_term *v = tie->term; v < tie->term + tie->terms; v++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    tie_add_at(model, tie, t->entry, a, v->entry, b,
                               t->weight * v->weight * H[t->what][v->what][a][b], K);
}
