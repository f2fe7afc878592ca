/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads along a power series of states. */
#include "drive.h"
#include "load_parts.h"
#include "taylor.h"
#include "vector3.h"

#include <string.h>

/* The slopes r_y, r_z at a station, which was found in u[0], along the states u[known]. */
static void find_slopes(const struct hobe_model *model, const struct station *s,
                        const double *const *u, int known, taylor3 slope[2])
{
    memset(slope, 0, 2 * sizeof *slope);
    for (int m = 0; m < 2; m++) {
        memcpy(slope[m][0], s->slope[m], sizeof s->slope[m]);
        for (int v = 0; v < s->vectors; v++)
            for (int i = 1; i < known; i++)
                for (int a = 0; a < 3; a++)
                    slope[m][i][a] +=
                        s->weight[1 + m][v] * u[i][3 * station_vector(model, s, v) + a];
    }
}

/* F[k] += that of angle_force. */
static void angle_series(int k, const double e[3], const taylor3 slope, double m, double F[3])
{
    taylor3 p = {{0}}, axis = {{e[0], e[1], e[2]}}, t = {{0}}, quotient;
    taylor along = {0}, p2 = {0};
    memcpy(p, slope, sizeof p);
    taylor_dot(k, slope, axis, 1, along);
    taylor_scale(k, along, axis, -1, p);
    taylor_cross(k, axis, p, t);
    taylor_dot(k, p, p, 1, p2);
    taylor_divide(k, t, p2, m, quotient);
    for (int a = 0; a < 3; a++)
        F[a] += quotient[k][a];
}

static void add_moment_series(const struct hobe_model *model, const struct moment *load,
                              const double *const *u, double time, int known, int k, double *Q)
{
    const struct hobe_moment *moment = &load->spec;
    const double factor = drive_factor(model, moment->history, time, moment->where);
    struct station s;
    taylor3 slope[2];
    station_find(model, &load->on, NULL, u[0], &s);
    find_slopes(model, &s, u, known, slope);
    for (int m = 0; m < 2; m++) {
        double F[3] = {0};
        angle_series(k, s.frame[0], slope[m], dot3(s.frame[0], moment->value) / 2, F);
        angle_series(k, s.frame[2 - m], slope[m], dot3(s.frame[2 - m], moment->value), F);
        station_add_force(model, &s, 1 + m, F, factor, Q);
    }
}

/* The axes of section_axes, and of them the force. */
static void add_follower_series(const struct hobe_model *model, const struct force *load,
                                const double *const *u, double time, int known, int k, double *Q)
{
    const struct hobe_force *force = &load->spec;
    const double factor = drive_factor(model, force->history, time, force->where);
    struct station s;
    taylor3 slope[2], n = {{0}}, t[3] = {{{0}}};
    taylor size;
    double F[3] = {0};
    station_find(model, &load->on, load_point(load), u[0], &s);
    find_slopes(model, &s, u, known, slope);
    taylor_cross(k, slope[0], slope[1], n);
    taylor_length(k, n, size);
    taylor_divide(k, n, size, 1, t[0]);
    taylor_length(k, slope[1], size);
    taylor_divide(k, slope[1], size, 1, t[2]);
    taylor_cross(k, t[2], t[0], t[1]);
    for (int b = 0; b < 3; b++)
        for (int a = 0; a < 3; a++)
            F[a] += dot3(s.frame[b], force->value) * t[b][k][a];
    station_add_force(model, &s, 0, F, factor, Q);
}

void load_series(const struct hobe_model *model, const double *const *u,
                 const struct instant *instant, int known, int k, double *Q)
{
    memset(Q, 0, (size_t)(3 * model->vectors) * sizeof *Q);
    if (k == 0) {
        load_subtract(model, u[0], instant, -1, Q, NULL);
        return;
    }
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        if (force->spec.follower)
            add_follower_series(model, force, u, instant->time, known, k, Q);
    }
    for (size_t i = 0; i < model->moments.count; i++)
        add_moment_series(model, model_moment(model, i), u, instant->time, known, k, Q);
}
