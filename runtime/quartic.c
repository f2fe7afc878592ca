/* SPDX-License-Identifier: GPL-3.0-or-later */
/* STUB: projects the full assemble */
#include "quartic.h"
#include "assemble.h"
#include "pattern.h"
#include <string.h>
enum hobe_status quartic_open(struct quartic *q, const hobe_model *full, const double *centre,
                              long n, const double *field, struct hobe_error *err)
{
    const size_t N = (size_t)(3 * full->vectors);
    *q = (struct quartic){.full = full, .n = n};
    q->field = hobe_alloc((size_t)n * N, sizeof(double), err);
    q->u = hobe_alloc(3 * N, sizeof(double), err);
    if (!q->field || !q->u || pattern_columns((hobe_model *)full, err))
        return HOBE_NO_MEMORY;
    memcpy(q->field, field, (size_t)n * N * sizeof(double));
    q->f = q->u + N;
    q->centre = q->u + 2 * N;
    if (centre)
        memcpy(q->centre, centre, N * sizeof(double));
    return pattern_matrix(full, COLUMNS, &q->K, err);
}
void quartic_close(struct quartic *q)
{
    hobe_free(q->field);
    hobe_free(q->u);
    hobe_free(q->K.value);
}
static void expand(const struct quartic *q, const double *x)
{
    const long N = 3 * q->full->vectors;
    for (long i = 0; i < N; i++) {
        q->u[i] = q->centre[i];
        for (long j = 0; j < q->n; j++)
            q->u[i] += x[j] * q->field[j * N + i];
    }
}
double quartic_energy(const struct quartic *q, const double *x)
{
    expand(q, x);
    return assemble_energy(q->full, q->u);
}
void quartic_add(const struct quartic *q, const double *x, double *f, double *K)
{
    const hobe_model *m = q->full;
    const long N = 3 * m->vectors, n = q->n;
    expand(q, x);
    assemble(m, q->u, q->f, K ? &q->K : NULL);
    for (long j = 0; j < n; j++)
        for (long i = 0; i < N; i++)
            f[j] += q->field[j * N + i] * q->f[i];
    if (!K)
        return;
    double *w = hobe_alloc((size_t)N, sizeof *w, NULL);
    for (long j = 0; j < n; j++) {
        memset(w, 0, (size_t)N * sizeof *w);
        const struct pattern *p = &m->pattern;
        long *vec = hobe_alloc((size_t)m->unknowns, sizeof *vec, NULL);
        for (long v = 0; v < m->vectors; v++)
            if (m->unknown[v] >= 0)
                vec[m->unknown[v]] = v;
        for (long c = 0; c < 3 * p->blocks; c++)
            for (long k = p->Ap[c]; k < p->Ap[c + 1]; k++)
                w[3 * vec[p->Ai[k] / 3] + p->Ai[k] % 3] +=
                    q->K.value[k] * q->field[j * N + 3 * vec[c / 3] + c % 3];
        for (long i = 0; i < n; i++)
            for (long a = 0; a < N; a++)
                K[i * n + j] += q->field[i * N + a] * w[a];
        hobe_free(vec);
    }
    hobe_free(w);
}
