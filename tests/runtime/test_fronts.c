/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetric elimination front after front, of matrices with the patterns of chains, rings and trees
 * of random elements, definite and not: beside LU with pivoting and a count of eigenvalues.  Looks
 * into the core (fronts.h). */
#include "check.h"
#include "eigen.h"
#include "fronts.h"
#include "linsolve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 120 }; /* blocks */

struct matrix {
    long blocks, n; /* n = 3 blocks */
    char coupled[MOST][MOST];
    double full[3 * MOST][3 * MOST];
};

static int random_int(int from, int to)
{
    return from + (int)random_real(0, to - from + 1 - 1e-9);
}

/* K += B B' - shift I over the blocks of an element. */
static void add_element(struct matrix *K, const long *block, int count, double shift)
{
    double B[3 * 40][3 * 40];
    for (int i = 0; i < 3 * count; i++)
        for (int k = 0; k < 3 * count; k++)
            B[i][k] = random_real(-1, 1);
    for (int i = 0; i < 3 * count; i++)
        for (int j = 0; j < 3 * count; j++) {
            double sum = i == j ? 1 - shift : 0;
            for (int k = 0; k < 3 * count; k++)
                sum += B[i][k] * B[j][k];
            K->coupled[block[i / 3]][block[j / 3]] = 1;
            K->full[3 * block[i / 3] + i % 3][3 * block[j / 3] + j % 3] += sum;
        }
}

/* A beam of elements with `ends` blocks at each end and `inside` between, from the blocks
 * first[ends]; those of the last end go to last[ends]. */
static void add_beam(struct matrix *K, int elements, int ends, int inside, const long *first,
                     long *last, double shift)
{
    memcpy(last, first, (size_t)ends * sizeof *last);
    for (int e = 0; e < elements && K->blocks + inside + ends <= MOST; e++) {
        long block[40];
        for (int k = 0; k < inside + ends; k++)
            block[ends + k] = K->blocks++;
        memcpy(block, last, (size_t)ends * sizeof *last);
        memcpy(last, block + ends + inside, (size_t)ends * sizeof *last);
        add_element(K, block, 2 * ends + inside, shift);
    }
}

enum shape { CHAIN, TREE, RING, SHAPES };
static const char *const shape_name[] = {"chain", "tree", "ring"};

static void make_matrix(struct matrix *K, enum shape shape, double shift)
{
    const int ends = random_int(1, 6), inside = random_int(0, 5);
    long start[6], last[6], again[6];
    memset(K, 0, sizeof *K);
    for (int k = 0; k < ends; k++)
        start[k] = K->blocks++;
    add_beam(K, random_int(1, 8), ends, inside, start, last, shift);
    for (int branch = 0; shape == TREE && branch < 3; branch++)
        add_beam(K, random_int(1, 4), ends, inside, branch < 2 ? last : start, again, shift);
    if (shape == RING) {
        long block[12];
        memcpy(block, start, (size_t)ends * sizeof *block);
        memcpy(block + ends, last, (size_t)ends * sizeof *block);
        add_element(K, block, last[0] == start[0] ? ends : 2 * ends, shift);
    }
    K->n = 3 * K->blocks;
}

/* Its compressed columns, of blocks and of scalars. */
struct compressed {
    long start[MOST + 1], row[MOST * MOST], Ap[3 * MOST + 1], Ai[9 * MOST * MOST];
    double Ax[9 * MOST * MOST];
};

static void compress(const struct matrix *K, struct compressed *C)
{
    long blocks = 0, scalars = 0;
    for (long j = 0; j < K->blocks; j++) {
        C->start[j] = blocks;
        for (long i = 0; i < K->blocks; i++)
            if (K->coupled[i][j])
                C->row[blocks++] = i;
        for (int c = 0; c < 3; c++) {
            C->Ap[3 * j + c] = scalars;
            for (long k = C->start[j]; k < blocks; k++)
                for (int a = 0; a < 3; a++) {
                    C->Ai[scalars] = 3 * C->row[k] + a;
                    C->Ax[scalars++] = K->full[3 * C->row[k] + a][3 * j + c];
                }
        }
    }
    C->start[K->blocks] = blocks;
    C->Ap[K->n] = scalars;
}

static void spread(const struct matrix *K, const hobe_fronts *f, double *value)
{
    memset(value, 0, fronts_size(f) * sizeof *value);
    for (long i = 0; i < K->blocks; i++)
        for (long j = 0; j < K->blocks; j++) {
            const long at = K->coupled[i][j] ? fronts_place(f, i, j) : -1;
            for (int c = 0; c < 3 && at >= 0; c++)
                for (int a = i == j ? c : 0; a < 3; a++)
                    value[at + c * fronts_stride(f, j) + a] = K->full[3 * i + a][3 * j + c];
        }
}

/* |K x - b| relative to |K| |x| + |b|, the worst row. */
static double backward_error(const struct matrix *K, const double *x, const double *b)
{
    double worst = 0;
    for (long i = 0; i < K->n; i++) {
        double residual = -b[i], size = fabs(b[i]);
        for (long j = 0; j < K->n; j++) {
            residual += K->full[i][j] * x[j];
            size += fabs(K->full[i][j] * x[j]);
        }
        worst = fmax(worst, fabs(residual) / size);
    }
    return worst;
}

static void compare_solutions(const struct matrix *K, const struct compressed *C,
                              const hobe_fronts *f, const double *value, const double *scale,
                              const char *what)
{
    double b[3 * MOST], x[3 * MOST], y[3 * MOST], size = 0, difference = 0;
    long column;
    hobe_linsolve *lu = hobe_linsolve_analyse(K->n, (long *)C->Ap, (long *)C->Ai, NULL);
    if (!lu || hobe_linsolve_factor(lu, C->Ax, scale, &column, NULL))
        check_stop("no LU factors");
    for (long i = 0; i < K->n; i++)
        b[i] = x[i] = y[i] = random_real(-1, 1);
    fronts_solve(f, value, x);
    hobe_linsolve_solve(lu, y, NULL);
    hobe_linsolve_free(lu);
    for (long i = 0; i < K->n; i++) {
        size = fmax(size, fabs(y[i]));
        difference = fmax(difference, fabs(x[i] - y[i]));
    }
    check_absolute(backward_error(K, x, b), 0, 1e-10, "%s, %ld blocks: K x - b", what, K->blocks);
    /* an eigenvalue near zero loses digits by its condition; the one above does not depend on it */
    check_absolute(difference / size, 0, 1e-7, "%s, %ld blocks: beside LU", what, K->blocks);
}

/* One random matrix; 1 where it was eliminated. */
static int run(enum shape shape, double shift)
{
    static struct matrix K;
    static struct compressed C;
    static double full[9 * MOST * MOST];
    double scale[3 * MOST];
    long negative;
    make_matrix(&K, shape, shift);
    compress(&K, &C);
    hobe_fronts *f = fronts_analyse(K.blocks, 0, C.start, C.row, NULL);
    double *value = f ? hobe_alloc(fronts_size(f), sizeof *value, NULL) : NULL;
    if (!value)
        check_stop("no memory");
    spread(&K, f, value);
    fronts_scale(f, value, scale);
    for (long i = 0; i < K.n; i++)
        check_relative(scale[i], 1 / sqrt(fabs(K.full[i][i])), 1e-15, "scale %ld", i);
    const int done = !fronts_factor(f, value, scale);
    if (done) {
        compare_solutions(&K, &C, f, value, scale, shape_name[shape]);
        for (long i = 0; i < K.n; i++)
            for (long j = 0; j < K.n; j++)
                full[i * K.n + j] = K.full[i][j];
        eigen_count_negative((int)K.n, full, &negative, NULL);
        check_that(fronts_negative(f) == negative, "%s, %ld blocks: %ld negative, not %ld",
                   shape_name[shape], K.blocks, fronts_negative(f), negative);
    }
    hobe_free(value);
    fronts_free(f);
    return done;
}

/* A zero on the diagonal cannot be a pivot, and says so instead of dividing by it. */
static void refuses(void)
{
    const long start[] = {0, 2, 4}, row[] = {0, 1, 0, 1};
    const double ones[] = {1, 1, 1, 1, 1, 1};
    hobe_fronts *f = fronts_analyse(2, 0, start, row, NULL);
    double *value = f ? hobe_alloc(fronts_size(f), sizeof *value, NULL) : NULL;
    if (!value)
        check_stop("no memory");
    for (int a = 0; a < 3; a++)
        value[fronts_place(f, 1, 0) + a * fronts_stride(f, 0) + a] = 1;
    check_that(fronts_factor(f, value, ones) == HOBE_SINGULAR, "a zero pivot is refused");
    hobe_free(value);
    fronts_free(f);
}

int main(void)
{
    random_start();
    for (enum shape shape = CHAIN; shape < SHAPES; shape++) {
        int indefinite = 0;
        for (int i = 0; i < 20; i++) {
            check_that(run(shape, 0), "a definite matrix needs no pivoting");
            indefinite += run(shape, random_real(2, 8));
        }
        check_that(indefinite > 10, "%s: most indefinite matrices need no pivoting",
                   shape_name[shape]);
    }
    refuses();
    return check_report();
}
