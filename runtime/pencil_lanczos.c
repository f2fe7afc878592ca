/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modes of large models and of models with ties: Lanczos' method about a shift, and the count of
 * modes below it that says whether one was missed. */
#include "pencil.h"

#include "eigen.h"
#include "inertia.h"
#include "pattern.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    COUNTED_DENSE = 2000, /* unknowns up to which signs are counted in dense factors: a second */
    ATTEMPTS = 4
};

/* Modes this near to the last one, relative to mu, may be its twins and are not counted on. */
static const double TWIN = 1e-6;

static enum hobe_status solve_factored(void *context, double *x, struct hobe_error *err)
{
    return pencil_divide(context, x, err);
}

static void shift(struct pencil *s, double sigma)
{
    for (long k = 0; k < values(s); k++)
        s->Sx[k] = s->Ax[k] - sigma * s->Mx[k];
}

/* The modes below sigma by dense factors. */
static enum hobe_status count_densely(struct pencil *s, double sigma, long *below,
                                      struct hobe_error *err)
{
    double *full = hobe_alloc((size_t)(s->n * s->n), sizeof *full, err);
    if (!full)
        return HOBE_NO_MEMORY;
    pencil_spread(s, s->Ax, sigma, full);
    const enum hobe_status status = eigen_count_negative((int)s->n, full, below, err);
    *below -= s->multipliers;
    hobe_free(full);
    return status;
}

/* The modes below sigma behind ties by two factorisations in columns, the last one of K - sigma M.
 */
static enum hobe_status count_behind_ties(struct pencil *s, double sigma, long *below,
                                          struct hobe_error *err)
{
    long column;
    const enum hobe_status status = inertia_behind_ties(s->model, s->Sx, s->ones, below, err);
    shift(s, sigma);
    return status ? status : hobe_linsolve_factor(s->model->solver, s->Sx, s->ones, &column, err);
}

/* Factors K - sigma M and counts the modes below sigma; -1 where that would take too long. */
static enum hobe_status count_below(struct pencil *s, double sigma, long *below,
                                    struct hobe_error *err)
{
    *below = -1;
    shift(s, sigma);
    enum hobe_status status = pencil_factor(s, s->Sx, s->ones, err);
    if (status == HOBE_SINGULAR)
        return hobe_fail(err, status, NULL,
                         "the stiffness is singular in this state: the scene is at a critical "
                         "load, or can move without resistance; change the load a little, or hold "
                         "the scene");
    if (status)
        return status;
    if (s->factored == FRONTS)
        *below = fronts_negative(s->model->fronts) - s->multipliers;
    else if (s->multipliers)
        status = count_behind_ties(s, sigma, below, err);
    else
        *below = hobe_linsolve_negative(s->model->solver);
    return !status && *below < 0 && s->n <= COUNTED_DENSE ? count_densely(s, sigma, below, err)
                                                          : status;
}

/* The `unstable` modes with negative nu = 1/mu, and the first of the others; without a count
 * those nearest to zero. */
static enum hobe_status run_lanczos(struct pencil *s, int modes, long unstable,
                                    struct hobe_error *err)
{
    const struct eigen_pencil pencil = {(int)s->n, s, pencil_multiply,
                                        s->buckling ? pencil_multiply_stiffness : NULL,
                                        solve_factored};
    const int most = (int)s->rank, below = unstable > 0 ? (int)unstable : 0;
    enum hobe_status status = pencil_make_room(s, modes > below ? modes : below, err);
    if (!status && below)
        status = eigen_lanczos(&pencil, EIGEN_SMALLEST, below, most, s->mu, s->X, err);
    if (!status && modes > below)
        status = eigen_lanczos(&pencil, unstable < 0 ? EIGEN_LARGEST_MAGNITUDE : EIGEN_LARGEST,
                               modes - below, most, s->mu + below, s->X + below * s->n, err);
    for (int i = 0; !status && i < s->room; i++) /* nu until here */
        s->mu[i] = pencil_mu(s, s->mu[i]);
    return status;
}

/* Sorts the modes found by mu: insertion, for few modes that are nearly sorted. */
static void sort_modes(struct pencil *s, double *buffer)
{
    const size_t size = (size_t)s->n * sizeof *buffer;
    for (int i = 1; i < s->room; i++) {
        const double mu = s->mu[i];
        int to = i;
        while (to > 0 && s->mu[to - 1] > mu)
            to--;
        memcpy(buffer, s->X + i * s->n, size);
        memmove(s->X + (to + 1) * s->n, s->X + to * s->n, (size_t)(i - to) * size);
        memcpy(s->X + to * s->n, buffer, size);
        memmove(s->mu + to + 1, s->mu + to, (size_t)(i - to) * sizeof *s->mu);
        s->mu[to] = mu;
    }
}

/* How many modes below the last wanted one are missing: Lanczos' method can overlook one of two
 * equal ones (a square section has pairs). */
static enum hobe_status count_missing(struct pencil *s, int modes, long *missing,
                                      struct hobe_error *err)
{
    long below;
    *missing = 0;
    while (modes > 0 && isinf(s->mu[modes - 1]))
        modes--;
    const double last = modes > 0 ? s->mu[modes - 1] : 0;
    if (last <= 0) /* unstable ones are as many as were counted */
        return HOBE_OK;
    const enum hobe_status status = count_below(s, (1 - TWIN) * last, &below, err);
    if (status || below < 0)
        return status;
    *missing = below;
    for (int i = 0; i < s->room; i++)
        *missing -= s->mu[i] < (1 - TWIN) * last;
    return HOBE_OK;
}

enum hobe_status pencil_lanczos(struct pencil *s, int modes, int *unstable, struct hobe_error *err)
{
    double *buffer = hobe_alloc((size_t)s->n, sizeof *buffer, err);
    enum hobe_status status = buffer ? HOBE_OK : HOBE_NO_MEMORY;
    long missing = 1, asked = modes;
    for (int attempt = 0; !status && missing > 0; attempt++) {
        long below;
        if (attempt == ATTEMPTS || asked >= s->rank) {
            status = hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                               "Lanczos' method overlooks %ld of the %d lowest modes; ask for "
                               "another number of modes, or use method = \"dense\"",
                               missing, modes);
            break;
        }
        status = count_below(s, 0, &below, err);
        if (!status && s->buckling && below > 0)
            status = pencil_fail_unstable(err);
        *unstable = (int)below;
        if (!status)
            status = run_lanczos(s, (int)asked, below, err);
        if (status)
            break;
        sort_modes(s, buffer);
        status = count_missing(s, modes, &missing, err);
        asked += missing + 2;
    }
    hobe_free(buffer);
    return status;
}
