/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "eigen.h"

#include <arpack.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* BLAS: products of matrices.  LAPACK: eigenvalues of a symmetric matrix; of any; of a pencil with
 * a definite matrix; L D L' factors; L U factors and what they solve. */
extern void dgemm_(const char *turn_a, const char *turn_b, const int *m, const int *n, const int *k,
                   const double *alpha, const double *A, const int *lda, const double *B,
                   const int *ldb, const double *beta, double *C, const int *ldc);
extern void dsyev_(const char *job, const char *triangle, const int *n, double *A, const int *lda,
                   double *w, double *work, const int *lwork, int *info);
extern void dgeev_(const char *left, const char *right, const int *n, double *A, const int *lda,
                   double *re, double *im, double *VL, const int *ldvl, double *VR, const int *ldvr,
                   double *work, const int *lwork, int *info);
extern void dsygvd_(const int *type, const char *job, const char *triangle, const int *n, double *A,
                    const int *lda, double *B, const int *ldb, double *w, double *work,
                    const int *lwork, int *iwork, const int *liwork, int *info);
extern void dsytrf_(const char *triangle, const int *n, double *A, const int *lda, int *pivot,
                    double *work, const int *lwork, int *info);
extern void dgetrf_(const int *m, const int *n, double *A, const int *lda, int *pivot, int *info);
extern void dgetrs_(const char *transposed, const int *n, const int *sides, const double *LU,
                    const int *lda, const int *pivot, double *B, const int *ldb, int *info);

/* OpenBLAS: threads, which the small matrices here only wait for.  Other BLAS have no such call. */
extern void openblas_set_num_threads(int threads) __attribute__((weak));

static void use_one_thread(void)
{
    if (openblas_set_num_threads)
        openblas_set_num_threads(1);
}

static enum hobe_status fail_to_converge(int n, struct hobe_error *err)
{
    return hobe_fail(err, HOBE_SINGULAR, NULL,
                     "the eigenvalues of a %d x %d matrix did not converge", n, n);
}

/* ---- dense ---------------------------------------------------------------------------------- */

enum hobe_status hobe_eigenvalues(int n, double *A, double *eigenvalue, struct hobe_error *err)
{
    double best;
    int info, lwork = -1;
    use_one_thread();
    dsyev_("N", "L", &n, A, &n, eigenvalue, &best, &lwork, &info);
    lwork = (int)best;
    double *work = hobe_alloc((size_t)lwork, sizeof *work, err);
    if (!work)
        return HOBE_NO_MEMORY;
    dsyev_("N", "L", &n, A, &n, eigenvalue, work, &lwork, &info);
    hobe_free(work);
    return info ? fail_to_converge(n, err) : HOBE_OK;
}

/* Sylvester: A = L D L' has as many negative eigenvalues as D, whose blocks are 1 x 1, or 2 x 2
 * with one eigenvalue of each sign. */
static long negative_blocks(int n, const double *A, const int *pivot)
{
    long negative = 0;
    for (int i = 0; i < n; i++) {
        if (pivot[i] < 0)
            i++; /* the second row of a 2 x 2 block */
        else if (A[(size_t)i * (size_t)n + (size_t)i] >= 0)
            continue;
        negative++;
    }
    return negative;
}

enum hobe_status eigen_count_negative(int n, double *A, long *negative, struct hobe_error *err)
{
    double best;
    int info, lwork = -1;
    use_one_thread();
    int *pivot = hobe_alloc((size_t)n, sizeof *pivot, err);
    if (!pivot)
        return HOBE_NO_MEMORY;
    dsytrf_("L", &n, A, &n, pivot, &best, &lwork, &info);
    lwork = (int)best;
    double *work = hobe_alloc((size_t)lwork, sizeof *work, err);
    if (work) {
        dsytrf_("L", &n, A, &n, pivot, work, &lwork, &info);
        *negative = negative_blocks(n, A, pivot);
    }
    hobe_free(work);
    hobe_free(pivot);
    return work ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status eigen_dense(int n, double *M, double *K, double *nu, int *definite,
                             struct hobe_error *err)
{
    const int type = 1;
    double best;
    int best_whole, info, lwork = -1, liwork = -1;
    use_one_thread();
    dsygvd_(&type, "V", "L", &n, M, &n, K, &n, nu, &best, &lwork, &best_whole, &liwork, &info);
    lwork = (int)best;
    liwork = best_whole;
    double *work = hobe_alloc((size_t)lwork, sizeof *work, err);
    int *iwork = hobe_alloc((size_t)liwork, sizeof *iwork, err);
    if (work && iwork)
        dsygvd_(&type, "V", "L", &n, M, &n, K, &n, nu, work, &lwork, iwork, &liwork, &info);
    const int ran = work && iwork;
    hobe_free(work);
    hobe_free(iwork);
    if (!ran)
        return HOBE_NO_MEMORY;
    *definite = info <= n; /* beyond: the Cholesky factors of K end at row info - n */
    return info > 0 && info <= n ? fail_to_converge(n, err) : HOBE_OK;
}

enum hobe_status eigen_general(int n, double *A, double *re, double *im, double *Z,
                               struct hobe_error *err)
{
    double best;
    int info, lwork = -1;
    use_one_thread();
    dgeev_("N", "V", &n, A, &n, re, im, NULL, &n, Z, &n, &best, &lwork, &info);
    lwork = (int)best;
    double *work = hobe_alloc((size_t)lwork, sizeof *work, err);
    if (!work)
        return HOBE_NO_MEMORY;
    dgeev_("N", "V", &n, A, &n, re, im, NULL, &n, Z, &n, work, &lwork, &info);
    hobe_free(work);
    return info ? fail_to_converge(n, err) : HOBE_OK;
}

/* After scaling, pivots of a sound matrix stay above this share of the largest. */
static const double NO_PIVOT = 1e-17;

enum hobe_status eigen_factor(int n, double *A, int *pivot, struct hobe_error *err)
{
    double smallest = INFINITY, largest = 0;
    int info;
    use_one_thread();
    dgetrf_(&n, &n, A, &n, pivot, &info);
    for (size_t i = 0; i < (size_t)n; i++) {
        const double size = fabs(A[i * (size_t)n + i]);
        smallest = fmin(smallest, size);
        largest = fmax(largest, size);
    }
    if (info || !(smallest > NO_PIVOT * largest))
        return hobe_fail(err, HOBE_SINGULAR, NULL,
                         "a dense matrix of %d unknowns is singular (pivots from %.1e to %.1e)", n,
                         smallest, largest);
    return HOBE_OK;
}

void eigen_divide(int n, const double *LU, const int *pivot, double *x)
{
    const int one = 1;
    int info;
    dgetrs_("N", &n, &one, LU, &n, pivot, x, &n, &info);
}

void eigen_add_product(int n, int k, const double *X, const double *Y, double *A)
{
    enum { WIDE = 64 }; /* columns at a time: few of the products above the diagonal */
    const double one = 1;
    use_one_thread();
    for (int i = 0; i < n; i += WIDE) {
        const int wide = n - i < WIDE ? n - i : WIDE, tall = n - i;
        const size_t at = (size_t)i * (size_t)k;
        dgemm_("T", "N", &wide, &tall, &k, &one, Y + at, &k, X + at, &k, &one,
               A + (size_t)i * (size_t)n + i, &n);
    }
}

/* ---- Lanczos -------------------------------------------------------------------------------- */

enum { RESTARTS = 1000, LEAST_SPACE = 20 };

struct lanczos {
    int n, wanted, space, info;
    const char *end;
    double *start, *V, *workd, *workl;
    int iparam[11], ipntr[14];
};

static int work_size(const struct lanczos *l)
{
    return l->space * (l->space + 8);
}

static enum hobe_status open_lanczos(struct lanczos *l, struct hobe_error *err)
{
    const size_t n = (size_t)l->n, space = (size_t)l->space;
    l->start = hobe_alloc(n, sizeof *l->start, err);
    l->V = hobe_alloc(n * space, sizeof *l->V, err);
    l->workd = hobe_alloc(3 * n, sizeof *l->workd, err);
    l->workl = hobe_alloc((size_t)work_size(l), sizeof *l->workl, err);
    if (!l->start || !l->V || !l->workd || !l->workl)
        return HOBE_NO_MEMORY;
    /* a fixed sequence without pattern (splitmix64), so that results repeat to the last digit */
    uint64_t state = 1;
    for (int i = 0; i < l->n; i++) {
        uint64_t x = state += 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        l->start[i] = (double)(x >> 11) * 0x1p-52 - 1;
    }
    l->info = 1;      /* the start vector is given */
    l->iparam[0] = 1; /* exact shifts */
    l->iparam[2] = RESTARTS;
    l->iparam[3] = 1;
    l->iparam[6] = 3; /* shift and invert */
    return HOBE_OK;
}

static void close_lanczos(struct lanczos *l)
{
    hobe_free(l->start);
    hobe_free(l->V);
    hobe_free(l->workd);
    hobe_free(l->workl);
}

/* ARPACK's reverse communication: it asks for products until it is content. */
static enum hobe_status run_lanczos(struct lanczos *l, const struct eigen_pencil *pencil,
                                    struct hobe_error *err)
{
    const size_t size = (size_t)l->n * sizeof(double);
    void (*const inner)(void *, const double *, double *) =
        pencil->inner ? pencil->inner : pencil->multiply;
    int ido = 0;
    for (;;) {
        dsaupd_c(&ido, "G", l->n, l->end, l->wanted, 0, l->start, l->space, l->V, l->n, l->iparam,
                 l->ipntr, l->workd, l->workl, work_size(l), &l->info);
        const double *x = l->workd + l->ipntr[0] - 1;
        double *y = l->workd + l->ipntr[1] - 1;
        if (ido == 2)
            inner(pencil->context, x, y);
        else if (ido == -1 || (ido == 1 && pencil->inner))
            pencil->multiply(pencil->context, x, y);
        else if (ido == 1) /* M x is there from the inner product */
            memcpy(y, l->workd + l->ipntr[2] - 1, size);
        else
            break;
        const enum hobe_status status = ido == 2 ? HOBE_OK : pencil->solve(pencil->context, y, err);
        if (status)
            return status;
    }
    if (l->info || l->iparam[4] < l->wanted)
        return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                         "Lanczos' method found %d of %d modes (ARPACK's dsaupd: %d); ask for "
                         "fewer, or use method = \"dense\"",
                         l->iparam[4], l->wanted, l->info);
    return HOBE_OK;
}

/* ARPACK gives 1/nu. */
static enum hobe_status take_vectors(struct lanczos *l, double *nu, double *X,
                                     struct hobe_error *err)
{
    int *select = hobe_alloc((size_t)l->space, sizeof *select, err);
    if (!select)
        return HOBE_NO_MEMORY;
    dseupd_c(1, "A", select, nu, X, l->n, 0, "G", l->n, l->end, l->wanted, 0, l->start, l->space,
             l->V, l->n, l->iparam, l->ipntr, l->workd, l->workl, work_size(l), &l->info);
    hobe_free(select);
    if (l->info)
        return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                         "Lanczos' method gave no vectors (ARPACK's dseupd: %d)", l->info);
    for (int i = 0; i < l->wanted; i++)
        nu[i] = 1 / nu[i];
    return HOBE_OK;
}

enum hobe_status eigen_lanczos(const struct eigen_pencil *pencil, enum eigen_end end, int wanted,
                               int most, double *nu, double *X, struct hobe_error *err)
{
    static const char *const ends[] = {
        [EIGEN_LARGEST] = "LA", [EIGEN_SMALLEST] = "SA", [EIGEN_LARGEST_MAGNITUDE] = "LM"};
    const int room = 2 * wanted + 1 > LEAST_SPACE ? 2 * wanted + 1 : LEAST_SPACE;
    struct lanczos l = {
        .n = pencil->n, .wanted = wanted, .space = room < most ? room : most, .end = ends[end]};
    use_one_thread();
    enum hobe_status status = open_lanczos(&l, err);
    if (!status)
        status = run_lanczos(&l, pencil, err);
    if (!status)
        status = take_vectors(&l, nu, X, err);
    close_lanczos(&l);
    return status;
}
