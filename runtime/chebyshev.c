/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chebyshev.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { LEAST = 16, MOST = 512 };

struct fit {
    hobe_function *function;
    void *context;
    const char *name;
    int values;
    double largest;             /* |value| met so far */
    double cosine[2 * MOST];    /* cos(pi i / MOST) */
    double *sample, *c, *value; /* [MOST + 1][values] at t_i, the same for T_k, [values] */
};

/* The i-th of the extrema of T_MOST, among which are those of T_n for all n that divide MOST. */
static double extremum(const struct fit *fit, int i)
{
    return (1 + fit->cosine[i]) / 2;
}

/* Values at the extrema of T_n, but for those known from T_(n/2). */
static enum hobe_status sample(struct fit *fit, int n, struct hobe_error *err)
{
    const int stride = MOST / n;
    for (int i = 0; i <= MOST; i += stride) {
        double *f = fit->sample + (size_t)i * (size_t)fit->values;
        if (n > LEAST && i % (2 * stride) == 0)
            continue;
        const enum hobe_status status = fit->function(fit->context, extremum(fit, i), f, err);
        if (status)
            return status;
        for (int v = 0; v < fit->values; v++) {
            if (!isfinite(f[v]))
                return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s(%g) must be finite, got %g",
                                 fit->name, extremum(fit, i), f[v]);
            fit->largest = fmax(fit->largest, fabs(f[v]));
        }
    }
    return HOBE_OK;
}

/* The interpolant at the extrema of T_n: c_k = (2/n) sum_j'' f_j cos(pi j k / n), the first and
 * last of the sum, and of the c_k, halved. */
static void transform(struct fit *fit, int n)
{
    const int stride = MOST / n;
    const size_t m = (size_t)fit->values;
    memset(fit->c, 0, (size_t)(n + 1) * m * sizeof *fit->c);
    for (int k = 0; k <= n; k++)
        for (int j = 0; j <= n; j++) {
            const double half = (k % n ? 1 : 0.5) * (j % n ? 1 : 0.5);
            const double weight = 2 * half / n * fit->cosine[stride * (j * k % (2 * n))];
            for (size_t v = 0; v < m; v++)
                fit->c[(size_t)k * m + v] += weight * fit->sample[(size_t)(j * stride) * m + v];
        }
}

/* The number of terms up to the last with a coefficient above `least`. */
static int significant(const struct fit *fit, int terms, double least)
{
    size_t i = (size_t)terms * (size_t)fit->values;
    while (i > 0 && !(fabs(fit->c[i - 1]) > least))
        i--;
    return (int)((i + (size_t)fit->values - 1) / (size_t)fit->values);
}

/* The number of terms up to where only rounding is left.  It leaves an epsilon or two in every
 * coefficient, and far terms of nothing else cost the derivatives digits, k^4 for the second: past
 * the last that is surely more, a term counts while it is no farther from the one before than one
 * of an odd or even function. */
static int without_noise(const struct fit *fit, int most)
{
    int terms = significant(fit, most, 64 * DBL_EPSILON * fit->largest), next = terms;
    do {
        terms = next;
        next = significant(fit, terms + 2 < most ? terms + 2 : most, DBL_EPSILON * fit->largest);
    } while (next > terms);
    return terms;
}

/* Where half as many terms miss the function most: a kink or jump, or its sharpest turn. */
static enum hobe_status fail_rough(struct fit *fit, struct hobe_error *err)
{
    const struct hobe_chebyshev half = {fit->values, MOST / 2 + 1, fit->c};
    double worst = 0, place = 0;
    transform(fit, MOST / 2);
    for (int i = 1; i < MOST; i += 2) {
        hobe_chebyshev_at(&half, extremum(fit, i), 0, fit->value);
        for (int v = 0; v < fit->values; v++) {
            const double miss = fabs(fit->value[v] - fit->sample[i * fit->values + v]);
            if (miss > worst) {
                worst = miss;
                place = extremum(fit, i);
            }
        }
    }
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "%s must be smooth, but it has a kink, or turns too sharply, near %s(%.3f); "
                     "split the beam there",
                     fit->name, fit->name, place);
}

static enum hobe_status adapt(struct fit *fit, double tolerance, struct hobe_chebyshev *series,
                              struct hobe_error *err)
{
    int n = LEAST / 2;
    do {
        if (n == MOST)
            return fail_rough(fit, err);
        n *= 2;
        const enum hobe_status status = sample(fit, n, err);
        if (status)
            return status;
        transform(fit, n);
    } while (significant(fit, n + 1, tolerance * fit->largest) > n / 2 + 1);
    const int terms = without_noise(fit, n + 1);
    const size_t size = (size_t)terms * (size_t)fit->values;
    *series = (struct hobe_chebyshev){fit->values, terms, hobe_alloc(size, sizeof(double), err)};
    if (!series->c)
        return HOBE_NO_MEMORY;
    memcpy(series->c, fit->c, size * sizeof(double));
    return HOBE_OK;
}

enum hobe_status hobe_chebyshev_fit(struct hobe_chebyshev *series, int values,
                                    hobe_function *function, void *context, double tolerance,
                                    const char *name, struct hobe_error *err)
{
    const size_t m = (size_t)values;
    struct fit fit = {.function = function, .context = context, .name = name, .values = values};
    *series = (struct hobe_chebyshev){0};
    fit.sample = hobe_alloc((2 * (MOST + 1) + 1) * m, sizeof(double), err);
    if (!fit.sample)
        return HOBE_NO_MEMORY;
    fit.c = fit.sample + (MOST + 1) * m;
    fit.value = fit.c + (MOST + 1) * m;
    for (int i = 0; i < 2 * MOST; i++) /* as sines, for the digits near 0 and the symmetry */
        fit.cosine[i] = sin(M_PI * (MOST / 2 - (i < MOST ? i : 2 * MOST - i)) / MOST);
    const enum hobe_status status = adapt(&fit, tolerance, series, err);
    hobe_free(fit.sample);
    return status;
}

void hobe_chebyshev_free(struct hobe_chebyshev *series)
{
    hobe_free(series->c);
    *series = (struct hobe_chebyshev){0};
}

/* T_(k+1) = 2 x T_k - T_(k-1), x = 2 t - 1, differentiated by t, from T_(-1) = T_1 = x on. */
void hobe_chebyshev_at(const struct hobe_chebyshev *series, double t, int orders, double *f)
{
    const double x = 2 * t - 1;
    const int m = series->values;
    double T[HOBE_CHEBYSHEV_ORDERS + 1] = {1}, before[HOBE_CHEBYSHEV_ORDERS + 1] = {x, 2};
    memset(f, 0, (size_t)((orders + 1) * m) * sizeof *f);
    for (int k = 0; k < series->terms; k++)
        for (int d = orders; d >= 0; d--) {
            for (int v = 0; v < m; v++)
                f[d * m + v] += T[d] * series->c[k * m + v];
            const double next = 2 * (x * T[d] + (d ? 2 * d * T[d - 1] : 0)) - before[d];
            before[d] = T[d];
            T[d] = next;
        }
}
