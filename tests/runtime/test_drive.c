/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of time: their derivatives against differences, their integrals against closed forms,
 * where they break, and what is refused. */
#include "check.h"
#include "hobe.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

enum { POINTS = 6 };

static hobe_drive *points_of(int n, const double (*point)[2], enum hobe_between between,
                             int integral)
{
    struct hobe_error err;
    hobe_drive *drive = hobe_drive_points(n, point, between, integral, &err);
    if (!drive)
        check_stop("%s", err.message);
    return drive;
}

static hobe_drive *function_of(hobe_function *function, void *context, int integral)
{
    struct hobe_error err;
    hobe_drive *drive = hobe_drive_function(function, context, integral, &err);
    if (!drive)
        check_stop("%s", err.message);
    return drive;
}

/* The p-th derivative at t. */
static double at(hobe_drive *drive, double t, int p)
{
    struct hobe_error err;
    double d[3];
    if (hobe_drive_at(drive, t, d, &err))
        check_stop("%s", err.message);
    return d[p];
}

/* ---- points ---------------------------------------------------------------------------------- */

/* The first two derivatives are those of what comes before them, by differences of fourth order
 * that see no breakpoint. */
static void check_derivatives(hobe_drive *drive, double t, const char *what)
{
    const double h = 1e-3;
    for (int p = 1; p < 3; p++) {
        const double slope = (8 * (at(drive, t + h, p - 1) - at(drive, t - h, p - 1)) -
                              (at(drive, t + 2 * h, p - 1) - at(drive, t - 2 * h, p - 1))) /
                             (12 * h);
        /* h^4/30 of the fifth derivative of it, which is that of a ramp of 4 in 0.3 s at most */
        const double left_out = pow(h, 4) / 30 * 2 * pow(M_PI / 0.3, p + 4);
        check_absolute(at(drive, t, p), slope, left_out + 1e-9, "%s: derivative %d at %g s", what,
                       p, t);
    }
}

static void random_points(void)
{
    double point[POINTS][2] = {{0, random_real(-2, 2)}};
    for (int i = 1; i < POINTS; i++) {
        point[i][0] = point[i - 1][0] + random_real(0.3, 1);
        point[i][1] = random_real(-2, 2);
    }
    for (int kind = 0; kind < 4; kind++) {
        hobe_drive *drive = points_of(POINTS, (const double(*)[2])point,
                                      kind < 2 ? HOBE_LINEAR : HOBE_RAMP, kind % 2);
        const char *what = kind < 2 ? "linear" : "ramp";
        for (int i = 0; i < POINTS; i++) {
            const double t = point[i][0], last = i == POINTS - 1;
            const double inside = last ? t + 0.5 : t + random_real(0.05, 0.25);
            check_derivatives(drive, inside, what);
            check_absolute(at(drive, t, kind % 2), point[i][1], 1e-14, "%s: point %d", what, i);
            check_that(hobe_drive_next(drive, inside) == (last ? INFINITY : point[i + 1][0]) &&
                           hobe_drive_next(drive, t) == hobe_drive_next(drive, inside),
                       "%s: where it breaks after point %d", what, i);
        }
        hobe_drive_free(drive);
    }
}

/* Eq. 30 of the paper is a ramp of the speed, rad/s: 48 (1 - cos(2 pi t))/2 to 0.5 s, 48 to 1 s,
 * 48 + 24 (1 - cos(4 pi (t - 1)))/2 to 1.25 s, then 72. */
static void speed_of_the_paper(void)
{
    static const double speed[4][2] = {{0, 0}, {0.5, 48}, {1, 48}, {1.25, 72}};
    static const double turned[][2] = {{0, 0}, {0.5, 12}, {1, 36}, {1.25, 51}, {2, 105}};
    hobe_drive *drive = points_of(4, speed, HOBE_RAMP, 1);
    for (int i = 0; i < 5; i++)
        check_absolute(at(drive, turned[i][0], 0), turned[i][1], 1e-12, "turned at %g s",
                       turned[i][0]);
    for (int i = 0; i < 10; i++) {
        const double t = random_real(0, 0.5), s = t / 2 + 1;
        check_absolute(at(drive, t, 1), 24 * (1 - cos(2 * PI * t)), 1e-12, "speed at %g s", t);
        check_absolute(at(drive, t, 0), 24 * (t - sin(2 * PI * t) / (2 * PI)), 1e-12,
                       "turned at %g s", t);
        check_absolute(at(drive, t, 2), 48 * PI * sin(2 * PI * t), 1e-11, "acceleration at %g s",
                       t);
        check_absolute(at(drive, s, 1), 48 + 12 * (1 - cos(4 * PI * (s - 1))), 1e-12,
                       "speed at %g s", s);
    }
    hobe_drive_free(drive);
}

/* A table's integral is made of trapezia, also from a time before 0, over a jump, and past the end.
 */
static void tables(void)
{
    static const double speed[5][2] = {{-1, 4}, {1, 2}, {2, 6}, {2, -1}, {3, 0}};
    static const double way[][2] = {{0, 0}, {1, 2.5}, {1.5, 4}, {2, 6.5}, {3, 6}, {9, 6}};
    hobe_drive *drive = points_of(5, speed, HOBE_LINEAR, 1);
    for (int i = 0; i < 6; i++)
        check_absolute(at(drive, way[i][0], 0), way[i][1], 1e-14, "way at %g s", way[i][0]);
    check_absolute(at(drive, 2, 1), -1, 0, "a jump is seen from the right");
    hobe_drive_free(drive);
    drive = points_of(1, speed, HOBE_RAMP, 1);
    check_absolute(at(drive, 3, 0), 12, 1e-14, "a constant speed");
    hobe_drive_free(drive);
}

/* ---- functions ------------------------------------------------------------------------------- */

struct wave {
    double frequency, phase, least; /* least time asked for */
};

static enum hobe_status wave(void *context, double t, double *f, struct hobe_error *err)
{
    struct wave *w = context;
    (void)err;
    w->least = fmin(w->least, t);
    *f = sin(w->frequency * t + w->phase);
    return HOBE_OK;
}

/* Differences have the errors that hobe.h states: (w h)^4/30 and /90 and rounding, forward ones in
 * the first steps (w h)^4/5 and (w h)^3; the integral is exact. */
static void functions(void)
{
    struct wave w = {random_real(5, 300), random_real(0, 6), 0};
    const double f = w.frequency, h = f / 4096, p = w.phase;
    hobe_drive *value = function_of(wave, &w, 0), *speed = function_of(wave, &w, 1);
    for (int i = 0; i < 10; i++) {
        const double t = i == 0 ? 0 : random_real(0, i < 4 ? 4e-4 : 3), a = f * t + p;
        const double first = pow(h, 4) / (t < 5e-4 ? 5 : 30) + 1e-11;
        const double second = t < 5e-4 ? pow(h, 3) : pow(h, 4) / 90;
        check_absolute(at(value, t, 0), sin(a), 0, "value at %g s", t);
        check_absolute(at(value, t, 1), f * cos(a), 1.1 * f * first, "derivative at %g s", t);
        check_absolute(at(value, t, 2), -f * f * sin(a), 1.1 * f * f * second + 5e-7,
                       "second derivative at %g s", t);
        check_absolute(at(speed, t, 0), (cos(p) - cos(a)) / f, 1e-13, "integral at %g s", t);
        check_absolute(at(speed, t, 1), sin(a), 0, "speed at %g s", t);
        check_absolute(at(speed, t, 2), f * cos(a), 1.1 * f * first, "its derivative at %g s", t);
    }
    check_that(w.least == 0, "nothing is asked for before t = 0: %g", w.least);
    check_that(hobe_drive_next(value, 1) == INFINITY, "functions do not break");
    hobe_drive *other = function_of(wave, &w, 1);
    for (int i = 0; i < 5; i++) {
        const double t = random_real(0, 5);
        check_that(at(speed, t, 0) == at(other, t, 0), "the same bits at %g s", t);
    }
    hobe_drive_free(value);
    hobe_drive_free(speed);
    hobe_drive_free(other);
}

/* ---- what is refused ------------------------------------------------------------------------- */

static enum hobe_status late(void *context, double t, double *f, struct hobe_error *err)
{
    (void)context;
    *f = t < 1 ? 0 : NAN;
    return t < 2 ? HOBE_OK : hobe_fail(err, HOBE_IO, NULL, "too late");
}

static void check_refused(enum hobe_status status, enum hobe_status expected,
                          const struct hobe_error *err, const char *sentence)
{
    check_that(status == expected && strstr(err->message, sentence), "\"%s\", got \"%s\"", sentence,
               err->message);
}

static void refused(void)
{
    static const struct {
        int n;
        double point[3][2];
        const char *sentence;
    } bad[] = {
        {0, {{0}}, "needs a point {t, value}"},
        {2, {{1, 0}, {0.5, 1}}, "in the order of time; 0.5 s follows 1 s"},
        {2, {{0, 0}, {1, NAN}}, "must be finite, point 2 is {1, nan}"},
        {3, {{1, 0}, {1, 1}, {1, 2}}, "three points {t, value} are at t = 1 s; two make a jump"}};
    struct hobe_error err;
    double d[3];
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        hobe_drive *drive = hobe_drive_points(bad[i].n, bad[i].point, HOBE_LINEAR, 0, &err);
        check_refused(drive ? HOBE_OK : HOBE_BAD_INPUT, err.status, &err, bad[i].sentence);
    }
    for (int integral = 0; integral < 2; integral++) {
        hobe_drive *drive = function_of(late, NULL, integral);
        check_that(!hobe_drive_at(drive, 0.9, d, &err), "before it fails");
        check_refused(hobe_drive_at(drive, 1.5, d, &err), HOBE_BAD_INPUT, &err, "must be finite");
        check_that(!hobe_drive_at(drive, 0.9, d, &err) && d[0] == 0, "and before it again");
        check_refused(hobe_drive_at(drive, -1, d, &err), HOBE_BAD_INPUT, &err, "begins at 0 s");
        if (!integral)
            check_refused(hobe_drive_at(drive, 2.5, d, &err), HOBE_IO, &err, "too late");
        else
            check_refused(hobe_drive_at(drive, 1e9, d, &err), HOBE_BAD_INPUT, &err,
                          "integrated up to t = 131072 s, got 1e+09");
        hobe_drive_free(drive);
    }
}

int main(void)
{
    random_start();
    random_points();
    speed_of_the_paper();
    tables();
    functions();
    refused();
    return check_report();
}
