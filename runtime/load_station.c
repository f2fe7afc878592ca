/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places where loads act: what they move there, and what a force adds to. */
#include "body.h"
#include "load_parts.h"
#include "pattern.h"

#include <string.h>

long station_vector(const struct hobe_model *model, const struct station *s, int v)
{
    return s->body ? s->body->first + v : model_vector(model, s->place.beam, s->place.element, v);
}

/* A body's slopes are its directions d_2, d_3, and its axes the global ones. */
static void on_body(const struct body *body, const double point[3], const double *u,
                    struct station *s)
{
    *s = (struct station){.body = body,
                          .vectors = BODY_VECTORS,
                          .weight = {{0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                          .slope = {{0, 1, 0}, {0, 0, 1}},
                          .frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    body_weights(body, point, s->weight[0]);
    for (int m = 0; u && m < 2; m++)
        for (int a = 0; a < 3; a++)
            s->slope[m][a] += u[3 * (body->first + 2 + m) + a];
}

/* Axial functions at a place of a beam and the section's slopes in state u, NULL: the reference. */
void station_on_beam(const struct hobe_model *model, struct place place, const double *u,
                     struct station *s)
{
    const struct beam *beam = place.beam;
    const struct hobe_kernel *k = beam->kernel;
    const double *q0 = beam_q0(beam, place.element);
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS];
    *s = (struct station){.place = place, .vectors = k->vectors};
    k->shape(place.xi, hobe_element_invariants(beam_law(beam, place.element))->length, N, Nx);
    beam_frame(beam, place.element, N, Nx, s->frame);
    for (int v = 0; v < k->vectors; v++) {
        const int mode = k->vector[v].mode;
        if (mode > 2)
            continue;
        s->weight[mode][v] = N[v];
        for (int a = 0; a < 3 && mode > 0; a++)
            s->slope[mode - 1][a] +=
                N[v] * (q0[3 * v + a] + (u ? u[3 * station_vector(model, s, v) + a] : 0));
    }
}

void station_find(const struct hobe_model *model, const struct target *on, const double *point,
                  const double *u, struct station *s)
{
    if (on->body)
        on_body(on->body, point, u, s);
    else
        station_on_beam(model, on->place, u, s);
}

void station_add_force(const struct hobe_model *model, const struct station *s, int of,
                       const double F[3], double factor, double *r)
{
    for (int v = 0; v < s->vectors; v++) {
        const double weight = s->weight[of][v];
        double *rv = r + 3 * station_vector(model, s, v);
        for (int a = 0; a < 3 && weight != 0; a++)
            rv[a] += factor * weight * F[a];
    }
}

void station_add_stiffness(const struct hobe_model *model, const struct station *s, int of_v,
                           int of_w, const double G[3][3], double factor, const struct matrix *K)
{
    for (int v = 0; v < s->vectors; v++)
        for (int w = 0; w < s->vectors; w++) {
            const double weight = factor * s->weight[of_v][v] * s->weight[of_w][w];
            double block[3][3];
            if (weight == 0)
                continue;
            for (int a = 0; a < 3; a++)
                for (int c = 0; c < 3; c++)
                    block[a][c] = weight * G[a][c];
            if (s->body)
                body_tangent_add(model, s->body, v, w, (const double(*)[3])block, K);
            else
                pattern_add_element(model, s->place.beam, s->place.element, v, w,
                                    (const double(*)[3])block, K);
        }
}

void station_touch(const struct hobe_model *model, const struct station *s, int from, int to,
                   unsigned char *touched)
{
    for (int of = from; of <= to; of++)
        for (int v = 0; v < s->vectors; v++)
            if (s->weight[of][v] != 0)
                touched[station_vector(model, s, v)] = 1;
}
