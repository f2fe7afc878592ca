/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "inertia.h"

#include "constraint.h"
#include "eigen.h"

#include <string.h>

long inertia_multipliers(const struct hobe_model *model)
{
    long multipliers = 0;
    for (long v = model->beam_vectors; v < model->vectors; v++)
        multipliers += 3 * (model->unknown[v] >= 0);
    return multipliers;
}

/* Takes a corner's multipliers out of the tangent: their rows go to G[3][n] and, scaled, G'G is
 * added to the vectors they tie. */
static void detach_corner(const struct hobe_model *model, const struct corner *c,
                          const double *scale, double *Ax, double *G)
{
    enum { TIED = CORNER_VECTORS - 1 };
    const struct pattern *p = &model->pattern;
    const long *unknown = model->unknown, n = 3 * model->unknowns;
    const long row = unknown[c->vector[TIED]];
    double g[TIED][3][3] = {0};
    for (int i = 0; i < TIED; i++)
        for (int m = 0; m < 3 && c->block[TIED][i] >= 0; m++)
            for (int a = 0; a < 3; a++) {
                const long column = unknown[c->vector[i]];
                double *at = Ax + pattern_scalar(p, column, c->block[TIED][i], m, a);
                G[m * n + 3 * column + a] = *at;
                g[i][m][a] = scale[3 * row + m] * *at;
                *at = Ax[pattern_scalar(p, row, c->block[i][TIED], a, m)] = 0;
            }
    for (int i = 0; i < TIED; i++)
        for (int j = 0; j < TIED; j++)
            for (int a = 0; a < 3 && c->block[i][j] >= 0; a++)
                for (int b = 0; b < 3; b++)
                    for (int m = 0; m < 3; m++)
                        Ax[pattern_scalar(p, unknown[c->vector[j]], c->block[i][j], a, b)] +=
                            g[i][m][a] * g[j][m][b];
    for (int m = 0; m < 3; m++) {
        const double D = scale[3 * row + m];
        Ax[pattern_scalar(p, row, c->block[TIED][TIED], m, m)] = 1 / (D * D);
    }
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
 * multiplier is not a mode's.  G'G ties what would be loose without the corners. */
enum hobe_status inertia_behind_corners(struct hobe_model *model, double *Ax, const double *scale,
                                        long *negative, struct hobe_error *err)
{
    const long n = 3 * model->unknowns;
    double *G = hobe_alloc((size_t)(inertia_multipliers(model) * n), sizeof *G, err);
    long rows = 0, column, positive = 0;
    *negative = -1;
    if (!G)
        return HOBE_NO_MEMORY;
    for (size_t i = 0; i < model->corners.count; i++) {
        const struct corner *c = model_corner(model, i);
        if (model->unknown[c->vector[CORNER_VECTORS - 1]] >= 0) {
            detach_corner(model, c, scale, Ax, G + rows * n);
            rows += 3;
        }
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
