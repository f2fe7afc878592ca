/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "inertia.h"

#include "constraint.h"
#include "eigen.h"
#include "reduction.h"

#include <string.h>

/* Numbers of the dense matrix that counting takes at most: 160 MB. */
static const double MOST_NUMBERS = 2e7;

long inertia_multipliers(const struct hobe_model *model, long *spare)
{
    const struct reduction *r = model->reduction;
    long multipliers = 0;
    *spare = r ? 3 * r->blocks - r->n + r->drops : 0;
    model = model_whole(model);
    for (size_t i = 0; i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        if (!model->held[tie->multiplier]) {
            multipliers += tie->constraints;
            *spare += 3 * tie->blocks - tie->constraints;
        }
    }
    return multipliers - (r ? r->drops : 0);
}

/* Takes constraint k of a tie out of the tangent: its row goes to G[n] and, scaled, G'G is added to
 * the vectors it ties. */
static void detach(const struct hobe_model *model, const struct tie *tie, int k,
                   const double *scale, const struct matrix *K, double *G)
{
    const int last = tie_entry(tie, k), m = k % 3, tied = tie->vectors - tie->blocks;
    const long *unknown = model->unknown;
    const double D = scale[3 * unknown[tie->vector[last]] + m];
    for (int i = 0; i < tied; i++)
        for (int a = 0; a < 3; a++) {
            double *at = tie_scalar(model, tie, last, m, i, a, K);
            if (!at)
                continue;
            G[3 * unknown[tie->vector[i]] + a] = *at;
            *at = *tie_scalar(model, tie, i, a, last, m, K) = 0;
        }
    for (int i = 0; i < tied; i++)
        for (int j = 0; j < tied; j++)
            for (int a = 0; a < 3; a++)
                for (int c = 0; c < 3; c++) {
                    double *at = tie_scalar(model, tie, i, a, j, c, K);
                    if (at)
                        *at += D * G[3 * unknown[tie->vector[i]] + a] * D *
                               G[3 * unknown[tie->vector[j]] + c];
                }
    *tie_scalar(model, tie, last, m, last, m, K) = 1 / (D * D);
}

/* S = G A^-1 G' with the last factors of A, G[m][n], and how many of its eigenvalues are positive.
 */
static enum hobe_status count_positive(struct hobe_model *model, long m, const double *G,
                                       long *positive, struct hobe_error *err)
{
    const long n = 3 * model->unknowns;
    double *S = hobe_alloc((size_t)(m * m), sizeof *S, err);
    double *eigenvalue = hobe_alloc((size_t)m, sizeof *eigenvalue, err);
    double *x = hobe_alloc((size_t)n, sizeof *x, err);
    enum hobe_status status = S && eigenvalue && x ? HOBE_OK : HOBE_NO_MEMORY;
    for (long i = 0; !status && i < m; i++) {
        memcpy(x, G + i * n, (size_t)n * sizeof *G);
        status = hobe_linsolve_solve(model->solver, x, err);
        for (long j = 0; j < m; j++)
            for (long k = 0; k < n; k++)
                S[i * m + j] += x[k] * G[j * n + k];
    }
    if (!status)
        status = hobe_eigenvalues((int)m, S, eigenvalue, err);
    *positive = 0;
    for (long i = 0; !status && i < m; i++)
        *positive += eigenvalue[i] > 0;
    hobe_free(S);
    hobe_free(eigenvalue);
    hobe_free(x);
    return status;
}

/* Sylvester: the bordered matrix [A G'; G 0] is congruent to one with A + G'G in the place of A,
 * and so has the signs of A + G'G and of -S, S = G (A + G'G)^-1 G'; a negative one for each
 * multiplier is not a mode's.  G'G ties what would be loose without the constraints. */
enum hobe_status inertia_behind_ties(struct hobe_model *model, double *Ax, const double *scale,
                                     long *negative, struct hobe_error *err)
{
    const struct matrix K = {COLUMNS, Ax};
    const long n = 3 * model->unknowns;
    long rows = 0, column, positive = 0, spare;
    const long all = inertia_multipliers(model, &spare);
    *negative = -1;
    if ((double)all * (double)n > MOST_NUMBERS || model->reduction)
        return HOBE_OK;
    double *G = hobe_alloc((size_t)(all * n), sizeof *G, err);
    if (!G)
        return HOBE_NO_MEMORY;
    for (size_t i = 0; i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        for (int k = 0; k < tie->constraints && !model->held[tie->multiplier]; k++)
            detach(model, tie, k, scale, &K, G + n * rows++);
    }
    enum hobe_status status = hobe_linsolve_factor(model->solver, Ax, scale, &column, err);
    const long signs = status ? -1 : hobe_linsolve_negative(model->solver);
    if (signs >= 0)
        status = count_positive(model, rows, G, &positive, err);
    if (signs >= 0 && !status)
        *negative = signs + positive - rows;
    hobe_free(G);
    return status == HOBE_SINGULAR ? HOBE_OK : status; /* then it is not known */
}
