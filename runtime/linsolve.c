/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linsolve.h"

#include <amd.h>
#include <klu.h>

_Static_assert(sizeof(SuiteSparse_long) == sizeof(long), "long is SuiteSparse's 64-bit index");

/* Stale pivots are kept while the factors' entries stay within 1/this of the matrix's. */
static const double PIVOT_GROWTH = 1e-3;

struct hobe_linsolve {
    long n, *Ap, *Ai;
    double *Ax;          /* scaled copy */
    const double *scale; /* of the last factors */
    double *own_scale;
    klu_l_common common;
    klu_l_symbolic *symbolic;
    klu_l_numeric *numeric;
};

hobe_linsolve *hobe_linsolve_analyse(long n, long *Ap, long *Ai, struct hobe_error *err)
{
    hobe_linsolve *s = hobe_alloc(1, sizeof *s, err);
    if (!s)
        return NULL;
    s->n = n;
    s->Ap = Ap;
    s->Ai = Ai;
    s->Ax = hobe_alloc((size_t)Ap[n], sizeof *s->Ax, err);
    s->own_scale = hobe_alloc((size_t)n, sizeof *s->own_scale, err);
    if (!s->Ax || !s->own_scale) {
        hobe_linsolve_free(s);
        return NULL;
    }
    klu_l_defaults(&s->common);
    s->common.scale = 0; /* scaled symmetrically here, which keeps pivots on the diagonal */
    s->common.btf = 0;   /* a beam's tangent is irreducible */
    s->symbolic = klu_l_analyze(n, Ap, Ai, &s->common);
    if (!s->symbolic) {
        hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: ordering of %ld unknowns", n);
        hobe_linsolve_free(s);
        return NULL;
    }
    return s;
}

enum hobe_status hobe_linsolve_order(long n, const long *Ap, const long *Ai, long *order,
                                     struct hobe_error *err)
{
    if (amd_l_order(n, Ap, Ai, order, NULL, NULL) == AMD_OUT_OF_MEMORY)
        return hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: ordering of %ld blocks", n);
    return HOBE_OK;
}

/* New values with the pivots of the last factors, which saves the search for pivots; 0 where there
 * are none or the factors would grow. */
static int factor_again(hobe_linsolve *s)
{
    return s->numeric && klu_l_refactor(s->Ap, s->Ai, s->Ax, s->symbolic, s->numeric, &s->common) &&
           s->common.status == KLU_OK &&
           klu_l_rgrowth(s->Ap, s->Ai, s->Ax, s->symbolic, s->numeric, &s->common) &&
           s->common.rgrowth > PIVOT_GROWTH;
}

enum hobe_status hobe_linsolve_factor(hobe_linsolve *s, const double *Ax, const double *scale,
                                      long *column, struct hobe_error *err)
{
    *column = -1;
    for (long j = 0; j < s->n; j++) {
        s->own_scale[j] = scale[j];
        for (long p = s->Ap[j]; p < s->Ap[j + 1]; p++)
            s->Ax[p] = scale[s->Ai[p]] * Ax[p] * scale[j];
    }
    if (!factor_again(s)) {
        if (s->numeric)
            klu_l_free_numeric(&s->numeric, &s->common);
        s->numeric = klu_l_factor(s->Ap, s->Ai, s->Ax, s->symbolic, &s->common);
    }
    if (s->common.status == KLU_OUT_OF_MEMORY || s->common.status == KLU_TOO_LARGE)
        return hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: factors of %ld unknowns", s->n);
    if (s->common.status == KLU_SINGULAR) {
        *column = s->common.singular_col;
        return hobe_fail(err, HOBE_SINGULAR, NULL, "the tangent stiffness is singular");
    }
    /* after scaling a sound beam stays above 1e-12; a mechanism ends at round-off */
    if (s->numeric && klu_l_rcond(s->symbolic, s->numeric, &s->common) && s->common.rcond < 1e-17)
        return hobe_fail(err, HOBE_SINGULAR, NULL,
                         "the tangent stiffness is singular (reciprocal condition %.1e)",
                         s->common.rcond);
    if (!s->numeric)
        return hobe_fail(err, HOBE_SINGULAR, NULL, "the tangent stiffness has no LU factors");
    return HOBE_OK;
}

enum hobe_status hobe_linsolve_solve(hobe_linsolve *s, double *b, struct hobe_error *err)
{
    for (long i = 0; i < s->n; i++)
        b[i] *= s->own_scale[i];
    if (!klu_l_solve(s->symbolic, s->numeric, s->n, 1, b, &s->common))
        return hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: back-substitution");
    for (long i = 0; i < s->n; i++)
        b[i] *= s->own_scale[i];
    return HOBE_OK;
}

long hobe_linsolve_negative(const hobe_linsolve *s)
{
    const double *pivot = s->numeric->Udiag;
    long negative = 0;
    for (long k = 0; k < s->n; k++) {
        if (s->numeric->Pnum[k] != s->symbolic->Q[k])
            return -1;
        negative += pivot[k] < 0;
    }
    return negative;
}

void hobe_linsolve_free(hobe_linsolve *s)
{
    if (!s)
        return;
    if (s->numeric)
        klu_l_free_numeric(&s->numeric, &s->common);
    if (s->symbolic)
        klu_l_free_symbolic(&s->symbolic, &s->common);
    hobe_free(s->Ax);
    hobe_free(s->own_scale);
    hobe_free(s);
}
