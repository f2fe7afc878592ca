/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Chebyshev series against the functions they were made of. */
#include "chebyshev.h"
#include "check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Relative to the largest value; derivatives of k terms lose k^2 and k^4 at the ends, k = 40. */
static const double tolerance[HOBE_CHEBYSHEV_ORDERS + 1] = {1e-14, 1e-12, 1e-10};

struct wave {
    double frequency, phase;
    int calls;
};

/* exp(t) and a wave. */
static enum hobe_status two_values(void *context, double t, double *f, struct hobe_error *err)
{
    struct wave *wave = context;
    (void)err;
    wave->calls++;
    f[0] = exp(t);
    f[1] = sin(wave->frequency * t + wave->phase);
    return HOBE_OK;
}

static void test_smooth(void)
{
    struct wave wave = {random_real(0, 25), random_real(0, 6), 0};
    struct hobe_chebyshev series;
    struct hobe_error err = {0};
    if (hobe_chebyshev_fit(&series, 2, two_values, &wave, 1e-11, "f", &err))
        check_stop("%s", err.message);
    const int calls = wave.calls;
    check_that(calls >= 17 && calls <= 129, "%d calls", calls);
    for (int i = 0; i < 20; i++) {
        const double t = i < 2 ? i : random_real(0, 1), p = wave.frequency * t + wave.phase;
        const double q = wave.frequency;
        const double expected[6] = {exp(t), sin(p), exp(t), q * cos(p), exp(t), -q * q * sin(p)};
        double f[6];
        hobe_chebyshev_at(&series, t, 2, f);
        for (int k = 0; k < 6; k++)
            check_absolute(f[k], expected[k], tolerance[k / 2] * (k % 2 ? 1 + pow(q, k / 2) : 3),
                           "value %d at %g, frequency %g", k, t, q);
    }
    check_that(wave.calls == calls, "a series does not call the function");
    hobe_chebyshev_free(&series);
}

static enum hobe_status polynomial(void *context, double t, double *f, struct hobe_error *err)
{
    (void)err;
    *f = 0;
    for (int k = *(int *)context; k >= 0; k--)
        *f = *f * t + 1;
    return HOBE_OK;
}

/* A polynomial is its series: degree + 1 terms. */
static void test_polynomials(void)
{
    for (int degree = 0; degree < 8; degree++) {
        struct hobe_chebyshev series;
        double f[3];
        if (hobe_chebyshev_fit(&series, 1, polynomial, &degree, 1e-11, "f", NULL))
            check_stop("degree %d", degree);
        check_that(series.terms == degree + 1, "degree %d: %d terms", degree, series.terms);
        hobe_chebyshev_at(&series, 1, 2, f);
        check_absolute(f[0], degree + 1, 1e-13, "degree %d", degree);
        check_absolute(f[1], degree * (degree + 1) / 2., 1e-12, "degree %d, slope", degree);
        check_absolute(f[2], (degree - 1) * degree * (degree + 1) / 3., 1e-10, "degree %d, second",
                       degree);
        hobe_chebyshev_free(&series);
    }
}

/* ---- what is not smooth ---------------------------------------------------------------------- */

struct rough {
    double place;
    int order; /* of the derivative that jumps */
};

static enum hobe_status jump(void *context, double t, double *f, struct hobe_error *err)
{
    const struct rough *rough = context;
    (void)err;
    *f = sin(t) + (t > rough->place ? pow(t - rough->place, rough->order) : 0);
    return HOBE_OK;
}

/* The sentence finds the place, within the distance of samples, pi/512 of t's scale. */
static void test_kinks(void)
{
    for (int i = 0; i < 30; i++) {
        struct rough rough = {random_real(0.02, 0.98), i % 3};
        struct hobe_chebyshev series;
        struct hobe_error err = {0};
        const enum hobe_status status =
            hobe_chebyshev_fit(&series, 1, jump, &rough, 1e-11, "width", &err);
        double found = -1;
        const char *near = strstr(err.message, "near width(");
        check_that(status == HOBE_BAD_INPUT && !series.c && near &&
                       sscanf(near, "near width(%lf)", &found) == 1,
                   "order %d at %g: \"%s\"", rough.order, rough.place, err.message);
        check_absolute(found, rough.place, 0.01, "the place of a jump of order %d", rough.order);
    }
}

static enum hobe_status fails(void *context, double t, double *f, struct hobe_error *err)
{
    *f = t > 0.4 && t < 0.6 ? *(double *)context : t;
    return *(double *)context > 0 ? HOBE_OK
                                  : hobe_fail(err, HOBE_UNKNOWN, NULL, "no value at %g", t);
}

static void test_failures(void)
{
    struct hobe_chebyshev series;
    struct hobe_error err = {0};
    double value = HUGE_VAL;
    check_that(hobe_chebyshev_fit(&series, 1, fails, &value, 1e-11, "f", &err) == HOBE_BAD_INPUT &&
                   !strcmp(err.message, "f(0.597545) must be finite, got inf"),
               "infinite: \"%s\"", err.message);
    value = -1;
    check_that(hobe_chebyshev_fit(&series, 1, fails, &value, 1e-11, "f", &err) == HOBE_UNKNOWN &&
                   !strcmp(err.message, "no value at 1"),
               "the function's own sentence: \"%s\"", err.message);
    check_that(hobe_chebyshev_fit(&series, 1, fails, &value, 1e-11, "f", NULL) == HOBE_UNKNOWN,
               "no err wanted");
}

int main(void)
{
    random_start();
    for (int i = 0; i < 20; i++)
        test_smooth();
    test_polynomials();
    test_kinks();
    test_failures();
    return check_report();
}
