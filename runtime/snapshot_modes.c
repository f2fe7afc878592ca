/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "snapshot_modes.h"

#include "eigen.h"
#include "solver.h"
#include "solution.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double DEFAULT_ACCURACY = 1e-6;

/* Squares of singular values below this share of the largest are rounding. */
static const double ROUND_OFF = 1e-15;

/* S and the pairs of G = S'S = Z diag(square) Z'. */
struct snapshots {
    long n;
    int count;
    double *S, *G, *one; /* [count][n] D^-1 u_k; [count][count]: later Z, by rows; a unit matrix */
    double *square;      /* [count] ascending */
};

static enum hobe_status check(const struct hobe_model *model, const struct hobe_projection *how,
                              struct hobe_error *err)
{
    if (how->snapshots < 1)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a projection by snapshots needs some results to train with");
    if (model->vectors > model->moving)
        return hobe_fail(
            err, HOBE_BAD_INPUT, NULL,
            "a projection by snapshots does not hold for scenes with joints and bodies, "
            "whose constraints few states cannot fulfil");
    for (int k = 0; k < how->snapshots; k++)
        if (!model_same_shape(model, how->snapshot[k]->model))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "result %d to train with is of a scene of another shape, with %ld "
                             "unknowns instead of %ld",
                             k + 1, 3 * how->snapshot[k]->model->unknowns, 3 * model->unknowns);
    return HOBE_OK;
}

static enum hobe_status gather(struct snapshots *s, const struct hobe_model *model,
                               const struct hobe_projection *how, const double *scale,
                               struct hobe_error *err)
{
    const size_t m = (size_t)how->snapshots, n = (size_t)(3 * model->unknowns);
    *s = (struct snapshots){.n = (long)n, .count = how->snapshots};
    s->S = hobe_alloc(m * n, sizeof *s->S, err);
    s->G = hobe_alloc(m * m, sizeof *s->G, err);
    s->one = hobe_alloc(m * m, sizeof *s->one, err);
    s->square = hobe_alloc(m, sizeof *s->square, err);
    if (!s->S || !s->G || !s->one || !s->square)
        return HOBE_NO_MEMORY;
    for (size_t k = 0; k < m; k++) {
        double *row = s->S + k * n;
        solver_restrict(model, how->snapshot[k]->u, row);
        for (size_t i = 0; i < n; i++)
            row[i] /= scale[i];
        for (size_t j = 0; j <= k; j++)
            s->G[j * m + k] = s->G[k * m + j] = dot((long)n, row, s->S + j * n);
        s->one[k * m + k] = 1;
    }
    return HOBE_OK;
}

static void free_snapshots(struct snapshots *s)
{
    hobe_free(s->S);
    hobe_free(s->G);
    hobe_free(s->one);
    hobe_free(s->square);
}

/* How many directions are asked for, and there are. */
static enum hobe_status choose(const struct snapshots *s, const struct hobe_projection *how,
                               int *modes, struct hobe_error *err)
{
    const double accuracy = how->accuracy > 0 ? how->accuracy : DEFAULT_ACCURACY;
    const double largest = s->square[s->count - 1];
    double all = 0, kept = 0;
    int there = 0, enough = 0;
    for (int k = 0; k < s->count; k++) {
        there += s->square[k] > ROUND_OFF * largest;
        all += fmax(0, s->square[k]);
    }
    while (enough < there && !(all - kept <= accuracy * accuracy * all))
        kept += s->square[s->count - 1 - enough++];
    *modes = how->modes > 0 ? how->modes : enough;
    if (*modes > there || there == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%d modes are asked for of results that have %d directions; train with "
                         "more of them",
                         *modes, there);
    return HOBE_OK;
}

/* phi = D S z of a pair. */
static void take(const struct snapshots *s, int k, const double *scale, struct subspace *space)
{
    double *phi = subspace_next(space);
    memset(phi, 0, (size_t)s->n * sizeof *phi);
    for (int j = 0; j < s->count; j++)
        for (long i = 0; i < s->n; i++)
            phi[i] += s->G[k * s->count + j] * scale[i] * s->S[j * s->n + i];
    subspace_take(space);
}

enum hobe_status snapshot_modes(const struct hobe_model *model,
                                const struct hobe_projection *projection, const double *scale,
                                struct subspace *space, struct hobe_error *err)
{
    struct snapshots s = {0};
    int definite, modes = 0;
    enum hobe_status status = check(model, projection, err);
    if (!status)
        status = gather(&s, model, projection, scale, err);
    if (!status)
        status = eigen_dense(s.count, s.G, s.one, s.square, &definite, err);
    if (!status)
        status = choose(&s, projection, &modes, err);
    if (!status)
        status = subspace_open(space, model, scale, modes, err);
    for (int k = 0; !status && k < modes; k++)
        take(&s, s.count - 1 - k, scale, space);
    free_snapshots(&s);
    return status;
}
