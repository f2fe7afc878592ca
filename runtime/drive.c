/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of time with two derivatives: tables, ramps and the caller's own, or the integral of
 * one of them from t = 0.  Values at t depend on t alone, to the last bit, whatever was asked for
 * before. */
#include "drive.h"

#include "load.h"
#include "reduction.h"
#include "section.h"

#include <math.h>
#include <string.h>

enum { GAUSS = 8, STENCIL = 5, MOST_CELLS = 1 << 24 };

/* Step of the differences, and width of a cell of the grid on which functions are integrated: s, of
 * few bits, so that their multiples are exact. */
static const double STEP = 1.0 / 4096, CELL = 1.0 / 128;

static const double PI = 3.14159265358979323846;

struct hobe_drive {
    enum hobe_between between;
    int points;
    double (*point)[2]; /* [points] t, value */
    double *sum;        /* [points] integrals from the first point on */
    hobe_function *function;
    void *context;
    int integral;
    double gauss[GAUSS][2];
    double *cell; /* [cells + 1], room for `room`: integrals from 0 to the ends of cells */
    size_t cells, room;
};

/* ---- between points -------------------------------------------------------------------------- */

/* The last point that is not after t; -1 before the first. */
static int point_before(const hobe_drive *drive, double t)
{
    int low = -1, high = drive->points;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (drive->point[middle][0] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* f[3] = value and derivatives at tau after the point i, which is not the last, and their integral
 * from there on: v0 + (v1 - v0) s with s = tau/T, or s = (1 - cos(pi tau/T))/2. */
static double between_points(const hobe_drive *drive, int i, double tau, double f[3])
{
    const double *from = drive->point[i], *to = drive->point[i + 1];
    const double T = to[0] - from[0], rise = to[1] - from[1];
    f[0] = from[1];
    if (T == 0)
        return 0;
    if (drive->between == HOBE_LINEAR) {
        f[0] += rise * tau / T;
        f[1] = rise / T;
        return from[1] * tau + rise * tau * tau / (2 * T);
    }
    const double w = PI / T, half = sin(w * tau / 2);
    f[0] += rise * half * half;
    f[1] = rise / 2 * w * sin(w * tau);
    f[2] = rise / 2 * w * w * cos(w * tau);
    return from[1] * tau + rise / 2 * (tau - sin(w * tau) / w);
}

/* f[3] = value and derivatives at t, from the right where they jump; gives the integral from the
 * first point on. */
static double at_time(const hobe_drive *drive, double t, double f[3])
{
    const int i = point_before(drive, t), last = drive->points - 1, near = i < 0 ? 0 : i;
    const double tau = t - drive->point[near][0];
    f[1] = f[2] = 0;
    if (i >= 0 && i < last)
        return drive->sum[i] + between_points(drive, i, tau, f);
    f[0] = drive->point[near][1];
    return drive->sum[near] + f[0] * tau;
}

static void at_points(const hobe_drive *drive, double t, double d[3])
{
    double f[3];
    const double until = at_time(drive, t, f);
    if (drive->integral) {
        double first[3];
        d[0] = until - at_time(drive, 0, first);
        d[1] = f[0];
        d[2] = f[1];
    } else
        memcpy(d, f, sizeof f);
}

/* ---- the caller's functions ------------------------------------------------------------------ */

/* Offsets in steps and weights of the first and second derivative: central, and forward near t = 0,
 * before which nothing is asked for.  Their errors are h^4 f'''''/30 and h^4 f''''''/90, forward
 * h^4 f'''''/5 and 5 h^3 f'''''/6. */
static const double stencil[2][3][STENCIL] = {
    {{0, -2, -1, 1, 2},
     {0, 1. / 12, -8. / 12, 8. / 12, -1. / 12},
     {-30. / 12, -1. / 12, 16. / 12, 16. / 12, -1. / 12}},
    {{0, 1, 2, 3, 4},
     {-25. / 12, 48. / 12, -36. / 12, 16. / 12, -3. / 12},
     {35. / 12, -104. / 12, 114. / 12, -56. / 12, 11. / 12}}};

static enum hobe_status call(const hobe_drive *drive, double t, double *f, struct hobe_error *err)
{
    const enum hobe_status status = drive->function(drive->context, t, f, err);
    if (!status && !isfinite(*f))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the function of time is %g at t = %g s; it must be finite", *f, t);
    return status;
}

/* f[orders]: value, first and second derivative. */
static enum hobe_status differentiate(const hobe_drive *drive, double t, int orders, double *f,
                                      struct hobe_error *err)
{
    const double(*is)[STENCIL] = stencil[t < 2 * STEP];
    enum hobe_status status = HOBE_OK;
    memset(f, 0, (size_t)orders * sizeof *f);
    for (int i = 0; !status && i < (orders > 1 ? STENCIL : 1); i++) {
        double value;
        status = call(drive, t + is[0][i] * STEP, &value, err);
        if (!status && i == 0)
            f[0] = value;
        for (int p = 1; !status && p < orders; p++)
            f[p] += is[p][i] * value / (p == 1 ? STEP : STEP * STEP);
    }
    return status;
}

/* *sum += the integral over [from, from + width] by Gauss's rule. */
static enum hobe_status integrate(const hobe_drive *drive, double from, double width, double *sum,
                                  struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int g = 0; !status && g < GAUSS; g++) {
        double value = 0;
        status = call(drive, from + width * drive->gauss[g][0], &value, err);
        *sum += width * drive->gauss[g][1] * value;
    }
    return status;
}

/* Integrates as far as the begin of cell k. */
static enum hobe_status fill_cells(hobe_drive *drive, size_t k, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    if (k >= drive->room) {
        double *grown = hobe_grow(drive->cell, drive->room, 2 * k + 1, sizeof *grown, err);
        if (!grown)
            return HOBE_NO_MEMORY;
        drive->cell = grown;
        drive->room = 2 * k + 1;
    }
    for (; !status && drive->cells < k; drive->cells += !status) {
        double *next = drive->cell + drive->cells + 1;
        *next = drive->cell[drive->cells];
        status = integrate(drive, (double)drive->cells * CELL, CELL, next, err);
    }
    return status;
}

static enum hobe_status at_function(hobe_drive *drive, double t, int orders, double d[3],
                                    struct hobe_error *err)
{
    if (!drive->integral)
        return differentiate(drive, t, orders, d, err);
    if (!(t / CELL < MOST_CELLS))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a function that gives a velocity is integrated up to t = %g s, got %g; "
                         "give the motion itself",
                         MOST_CELLS * CELL, t);
    const size_t k = (size_t)(t / CELL);
    enum hobe_status status = fill_cells(drive, k, err);
    if (status)
        return status;
    d[0] = drive->cell[k];
    status = integrate(drive, (double)k * CELL, t - (double)k * CELL, d, err);
    return status || orders == 1 ? status : differentiate(drive, t, orders - 1, d + 1, err);
}

/* ---- drives ---------------------------------------------------------------------------------- */

/* d[orders <= 3], room for three. */
static enum hobe_status evaluate(hobe_drive *drive, double t, int orders, double d[3],
                                 struct hobe_error *err)
{
    if (!(t >= 0 && isfinite(t)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "time begins at 0 s, got %g", t);
    if (drive->function)
        return at_function(drive, t, orders, d, err);
    at_points(drive, t, d);
    return HOBE_OK;
}

enum hobe_status hobe_drive_at(hobe_drive *drive, double t, double d[3], struct hobe_error *err)
{
    return evaluate(drive, t, 3, d, err);
}

double hobe_drive_next(const hobe_drive *drive, double t)
{
    const int next = drive->points > 0 ? point_before(drive, t) + 1 : 0;
    return next < drive->points ? drive->point[next][0] : INFINITY;
}

double drive_jump(const hobe_drive *drive)
{
    for (int i = 1; i < drive->points && !drive->integral; i++)
        if (drive->point[i][0] == drive->point[i - 1][0])
            return drive->point[i][0];
    return NAN;
}

static enum hobe_status check_points(int n, const double (*point)[2], struct hobe_error *err)
{
    if (n < 1)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "a function of time needs a point {t, value}");
    for (int i = 0; i < n; i++) {
        if (!isfinite(point[i][0]) || !isfinite(point[i][1]))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "points {t, value} must be finite, point %d is {%g, %g}", i + 1,
                             point[i][0], point[i][1]);
        if (i > 0 && !(point[i][0] >= point[i - 1][0]))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "points {t, value} must be in the order of time; %g s follows %g s",
                             point[i][0], point[i - 1][0]);
        if (i > 1 && point[i][0] == point[i - 2][0])
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "three points {t, value} are at t = %g s; two make a jump",
                             point[i][0]);
    }
    return HOBE_OK;
}

hobe_drive *hobe_drive_points(int n, const double (*point)[2], enum hobe_between between,
                              int integral, struct hobe_error *err)
{
    if (check_points(n, point, err))
        return NULL;
    hobe_drive *drive = hobe_alloc(1, sizeof *drive, err);
    if (!drive)
        return NULL;
    *drive = (hobe_drive){.between = between, .points = n, .integral = integral};
    drive->point = hobe_alloc((size_t)n, sizeof *drive->point, err);
    drive->sum = hobe_alloc((size_t)n, sizeof *drive->sum, err);
    if (!drive->point || !drive->sum) {
        hobe_drive_free(drive);
        return NULL;
    }
    memcpy(drive->point, point, (size_t)n * sizeof *point);
    for (int i = 0; i + 1 < n; i++) {
        double f[3];
        drive->sum[i + 1] =
            drive->sum[i] + between_points(drive, i, point[i + 1][0] - point[i][0], f);
    }
    return drive;
}

hobe_drive *hobe_drive_function(hobe_function *function, void *context, int integral,
                                struct hobe_error *err)
{
    hobe_drive *drive = hobe_alloc(1, sizeof *drive, err);
    if (!drive)
        return NULL;
    *drive =
        (hobe_drive){.function = function, .context = context, .integral = integral, .room = 1};
    drive->cell = hobe_alloc(1, sizeof *drive->cell, err);
    if (!drive->cell || hobe_gauss(GAUSS, drive->gauss, err)) {
        hobe_drive_free(drive);
        return NULL;
    }
    return drive;
}

void hobe_drive_free(hobe_drive *drive)
{
    if (!drive)
        return;
    hobe_free(drive->point);
    hobe_free(drive->sum);
    hobe_free(drive->cell);
    hobe_free(drive);
}

const struct hobe_joint *drive_joint(const struct hobe_model *model)
{
    model = model_whole(model);
    const struct hobe_joint *joint = model->joints.item;
    for (size_t i = 0; i < model->joints.count; i++)
        if (joint[i].angle || joint[i].position)
            return joint + i;
    return NULL;
}

/* The first orders of the factor and its derivatives. */
static void find_factor(const struct hobe_model *model, hobe_drive *history, double t,
                        const char *where, int orders, double d[3])
{
    struct hobe_error err;
    if (!history || !evaluate(history, t, orders, d, &err))
        return;
    model_fail(model, where, &err);
    d[0] = d[1] = NAN;
}

double drive_factor(const struct hobe_model *model, hobe_drive *history, double t,
                    const char *where)
{
    double d[3] = {1};
    find_factor(model, history, t, where, 1, d);
    return d[0];
}

void drive_history(const struct hobe_model *model, hobe_drive *history, double t, const char *where,
                   double d[2])
{
    double all[3] = {1};
    find_factor(model, history, t, where, 2, all);
    memcpy(d, all, 2 * sizeof *d);
}

/* *next is not after the next point of a drive, which may be NULL. */
static void stop_at(const hobe_drive *drive, double t, double *next)
{
    if (drive)
        *next = fmin(*next, hobe_drive_next(drive, t));
}

double drive_next(const struct hobe_model *model, double t)
{
    model = model_whole(model);
    const struct hobe_joint *joint = model->joints.item;
    const struct gravity *gravity = model->gravities.item;
    double next = INFINITY;
    for (size_t i = 0; i < model->joints.count; i++) {
        stop_at(joint[i].angle, t, &next);
        stop_at(joint[i].position, t, &next);
    }
    for (size_t i = 0; i < model->forces.count; i++)
        stop_at(model_force(model, i)->spec.history, t, &next);
    for (size_t i = 0; i < model->moments.count; i++)
        stop_at(model_moment(model, i)->spec.history, t, &next);
    for (size_t i = 0; i < model->gravities.count; i++)
        stop_at(gravity[i].history, t, &next);
    stop_at(model->spin.history, t, &next);
    return next;
}
