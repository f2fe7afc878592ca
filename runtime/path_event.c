/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a path passes: limit points and bifurcations; and what it gives. */
#include "path_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The extreme load of the cubic lambda(s), 0 <= s <= h, with the given ends and slopes. */
static double extreme_load(const double load[2], const double slope[2], double h)
{
    const double rise = (load[1] - load[0]) / h;
    const double c = slope[0], b = (3 * rise - 2 * slope[0] - slope[1]) / h;
    const double a = (slope[0] + slope[1] - 2 * rise) / (h * h);
    /* 3 a s^2 + 2 b s + c = 0: the root between 0 and h, where the slope has both signs */
    const double root = sqrt(fmax(0, b * b - 3 * a * c));
    const double s = c / (c > 0 ? root - b : -root - b);
    return load[0] + s * (c + s * (b + s * a));
}

/* How far the current point is from the last one. */
static double travelled(const struct follower *f)
{
    const hobe_model *model = f->s.model;
    double sum = (f->lambda - f->last_lambda) * (f->lambda - f->last_lambda);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const double du = f->s.u[3 * v + a] - f->s.start[3 * v + a];
            sum += f->W[3 * model->unknown[v] + a] * du * du;
        }
    return sqrt(sum);
}

static enum hobe_status add_event(struct follower *f, struct hobe_path_event event,
                                  struct hobe_error *err)
{
    struct hobe_path_event *to = list_append(&f->path->events, sizeof event, err);
    if (!to)
        return HOBE_NO_MEMORY;
    *to = event;
    return HOBE_OK;
}

/* A limit point makes one eigenvalue change its sign; those beyond it belong to bifurcations. */
enum hobe_status path_find_events(struct follower *f, int before_negative, double before_kappa,
                                  struct hobe_error *err)
{
    const int known = before_negative >= 0 && f->s.info.negative >= 0;
    const int change = known ? f->s.info.negative - before_negative : 0;
    struct hobe_path_event event = {.before = (int)f->path->points.count - 2,
                                    .change = change,
                                    .load = {f->last_lambda, f->lambda}};
    const double slope[2] = {before_kappa, f->kappa};
    f->turned = before_kappa * f->kappa < 0;
    if (f->turned) {
        event.extreme =
            path_by_series(f) ? f->extreme : extreme_load(event.load, slope, travelled(f));
        if (add_event(f, event, err))
            return HOBE_NO_MEMORY;
    }
    if (known && (f->turned ? change != 1 && change != -1 : change != 0)) {
        event.bifurcation = 1;
        event.extreme = (event.load[0] + event.load[1]) / 2;
        return add_event(f, event, err);
    }
    return HOBE_OK;
}

void hobe_path_event_text(const struct hobe_path_event *event, char *text, size_t size)
{
    char change[80] = "";
    if (event->change)
        snprintf(change, sizeof change, ": %d negative eigenvalue%s %s", abs(event->change),
                 abs(event->change) == 1 ? "" : "s", event->change > 0 ? "more" : "less");
    if (event->bifurcation)
        snprintf(text, size,
                 "bifurcation between points %d and %d, load factors %.6g and %.6g%s; the path "
                 "goes on straight, another one crosses",
                 event->before + 1, event->before + 2, event->load[0], event->load[1], change);
    else
        snprintf(text, size, "limit point between points %d and %d, load factor %.6g%s",
                 event->before + 1, event->before + 2, event->extreme, change);
}

/* ---- what is given --------------------------------------------------------------------------- */

void hobe_path_free(hobe_path *path)
{
    if (!path)
        return;
    solutions_free(&path->points);
    hobe_free(path->events.item);
    hobe_free(path);
}

void hobe_path_info(const hobe_path *path, struct hobe_path_info *info)
{
    *info = path->info;
}

const hobe_solution *hobe_path_point(const hobe_path *path, int i)
{
    return solutions_get(&path->points, i);
}

hobe_solution *hobe_path_take(hobe_path *path, int i)
{
    return solutions_take(&path->points, i);
}

const struct hobe_path_event *hobe_path_event(const hobe_path *path, int i)
{
    return i >= 0 && (size_t)i < path->events.count
               ? (const struct hobe_path_event *)path->events.item + i
               : NULL;
}
