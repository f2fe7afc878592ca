/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetric elimination front after front, of matrices with the patterns of chains, rings and trees
 * of random elements, definite and not, held by multipliers and not: beside LU with pivoting and a
 * count of eigenvalues.  Looks into the core (fronts.h). */
#include "check.h"
#include "eigen.h"
#include "fronts.h"
#include "linsolve.h"
#include "vector3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 120, MULTIPLIERS = 8, ELEMENT = 40, RIGID = 3 }; /* blocks; loose motions */

struct matrix {
    long blocks, n, multipliers; /* n = 3 blocks */
    int loose;                   /* whether elements do not resist these motions: */
    double rigid[RIGID][3 * MOST];
    char coupled[MOST][MOST];
    double full[3 * MOST][3 * MOST];
};

static int random_int(int from, int to)
{
    return from + (int)random_real(0, to - from + 1 - 1e-9);
}

/* B = (1 - z z') B with orthonormal rigid motions z of the element. */
static void let_loose(const struct matrix *K, const long *block, int n,
                      double B[3 * ELEMENT][3 * ELEMENT])
{
    double z[RIGID][3 * ELEMENT];
    for (int m = 0; m < RIGID; m++) {
        for (int i = 0; i < n; i++)
            z[m][i] = K->rigid[m][3 * block[i / 3] + i % 3];
        for (int l = 0; l < m; l++) {
            const double along = dot(n, z[l], z[m]);
            for (int i = 0; i < n; i++)
                z[m][i] -= along * z[l][i];
        }
        const double length = sqrt(dot(n, z[m], z[m]));
        for (int i = 0; i < n; i++)
            z[m][i] /= length;
        for (int k = 0; k < n; k++) {
            double along = 0;
            for (int i = 0; i < n; i++)
                along += z[m][i] * B[i][k];
            for (int i = 0; i < n; i++)
                B[i][k] -= along * z[m][i];
        }
    }
}

/* K += B B' + (1 - shift) I over the blocks of an element, or B B' where it is loose. */
static void add_element(struct matrix *K, const long *block, int count, double shift)
{
    double B[3 * ELEMENT][3 * ELEMENT];
    for (int i = 0; i < 3 * count; i++)
        for (int k = 0; k < 3 * count; k++)
            B[i][k] = random_real(-1, 1);
    if (K->loose)
        let_loose(K, block, 3 * count, B);
    for (int i = 0; i < 3 * count; i++)
        for (int j = 0; j < 3 * count; j++) {
            double sum = i == j && !K->loose ? 1 - shift : 0;
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
    for (int e = 0; e < elements && K->blocks + inside + ends <= MOST - MULTIPLIERS; e++) {
        long block[ELEMENT];
        for (int k = 0; k < inside + ends; k++)
            block[ends + k] = K->blocks++;
        memcpy(block, last, (size_t)ends * sizeof *last);
        memcpy(last, block + ends + inside, (size_t)ends * sizeof *last);
        add_element(K, block, 2 * ends + inside, shift);
    }
}

enum shape { CHAIN, TREE, RING, SHAPES };
static const char *const shape_name[] = {"chain", "tree", "ring"};

/* One more multiplier, of three constraints or less and spare ones with 1 on the diagonal, of
 * vectors of which one is tied by no other first of all. */
static void add_multiplier(struct matrix *K, long vectors)
{
    const long j = K->blocks++, own = K->multipliers++;
    const int constraints = own == 0 ? 3 : random_int(1, 3), tied = random_int(1, 4);
    long block[4] = {vectors - 1 - own};
    K->coupled[j][j] = 1;
    for (int k = 0; k < tied; k++) {
        if (k > 0)
            block[k] = random_int(0, (int)vectors - 1);
        K->coupled[block[k]][j] = K->coupled[j][block[k]] = 1;
        for (int l = 0; l <= k; l++)
            K->coupled[block[k]][block[l]] = K->coupled[block[l]][block[k]] = 1;
        for (int a = 0; a < constraints; a++)
            for (int c = 0; c < 3; c++)
                K->full[3 * j + a][3 * block[k] + c] = K->full[3 * block[k] + c][3 * j + a] =
                    random_real(-1, 1);
    }
    for (int a = constraints; a < 3; a++)
        K->full[3 * j + a][3 * j + a] = 1;
}

static void make_matrix(struct matrix *K, enum shape shape, double shift, int loose,
                        int multipliers)
{
    const int ends = random_int(1, 6), inside = random_int(0, 5);
    long start[6], last[6], again[6];
    memset(K, 0, sizeof *K);
    K->loose = loose;
    for (long i = 0; i < 3 * MOST; i++)
        for (int m = 0; m < RIGID; m++)
            K->rigid[m][i] = random_real(-1, 1);
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
    const long vectors = K->blocks;
    for (int m = 0; m < multipliers && m < vectors; m++)
        add_multiplier(K, vectors);
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

/* The worst row of |D (K x - b)| beside the sum of |D^-1 x| and D |b|, D the scale: elimination
 * without pivots promises no more where |L| |D| |L|' exceeds the diagonal of K, as it may by 1e5;
 * rows of K and x that are small beside it feel the rounding of others. */
static double backward_error(const struct matrix *K, const double *scale, const double *x,
                             const double *b)
{
    double worst = 0, sum = 0;
    for (long j = 0; j < K->n; j++)
        sum += fabs(x[j]) / scale[j];
    for (long i = 0; i < K->n; i++) {
        double residual = -b[i];
        for (long j = 0; j < K->n; j++)
            residual += K->full[i][j] * x[j];
        worst = fmax(worst, scale[i] * fabs(residual) / (sum + scale[i] * fabs(b[i])));
    }
    return worst;
}

/* |K^-1| |K| of the scaled matrix, or less: K y = b, b random, shows the smallest eigenvalue. */
static double condition(const struct matrix *K, const double *scale, const double *y,
                        const double *b)
{
    double norm = 0, size = 0, load = 0;
    for (long i = 0; i < K->n; i++) {
        double row = 0;
        for (long j = 0; j < K->n; j++)
            row += fabs(K->full[i][j]) * scale[i] * scale[j];
        norm = fmax(norm, row);
        size = fmax(size, fabs(y[i]) / scale[i]);
        load = fmax(load, fabs(b[i]) * scale[i]);
    }
    return norm * size / load;
}

static void compare_solutions(const struct matrix *K, const struct compressed *C,
                              const hobe_fronts *f, const double *value, const double *scale,
                              const char *what)
{
    double b[3 * MOST], x[3 * MOST], y[3 * MOST], size = 0, difference = 0;
    const double rounding = 1e-15; /* of the sums of a residual */
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
        size = fmax(size, fabs(y[i]) / scale[i]);
        difference = fmax(difference, fabs(x[i] - y[i]) / scale[i]);
    }
    const double error = backward_error(K, scale, x, b), other = backward_error(K, scale, y, b);
    check_absolute(error, 0, 1e-10, "%s, %ld blocks: K x - b", what, K->blocks);
    /* an eigenvalue near zero loses digits by its condition, which is known but for a factor; the
     * one above does not depend on it */
    check_absolute(difference / size, 0,
                   10 * condition(K, scale, y, b) * (double)K->n * (error + other + rounding),
                   "%s, %ld blocks: beside LU", what, K->blocks);
}

/* diag(K)^(-1/2), and what makes the largest entry of a multiplier's row one. */
static void check_scale(const struct matrix *K, const double *scale)
{
    for (long i = 0; i < K->n; i++) {
        double largest = 0;
        for (long j = 0; K->full[i][i] == 0 && j < K->n; j++)
            largest = fmax(largest, fabs(K->full[i][j]) * scale[j]);
        check_relative(scale[i], 1 / (largest > 0 ? largest : sqrt(fabs(K->full[i][i]))), 1e-15,
                       "scale %ld", i);
    }
}

/* A multiplier comes after what it ties. */
static void check_order(const struct matrix *K, const hobe_fronts *f)
{
    for (long i = K->blocks - K->multipliers; i < K->blocks; i++)
        for (long j = 0; j < K->blocks - K->multipliers; j++)
            check_that(!K->coupled[i][j] || fronts_place(f, i, j) >= 0,
                       "multiplier %ld before vector %ld", i, j);
}

static void check_negative(const struct matrix *K, const hobe_fronts *f, const char *what)
{
    static double full[9 * MOST * MOST];
    long negative;
    for (long i = 0; i < K->n; i++)
        memcpy(full + i * K->n, K->full[i], (size_t)K->n * sizeof *full);
    eigen_count_negative((int)K->n, full, &negative, NULL);
    check_that(fronts_negative(f) == negative,
               "%s, %ld blocks, %ld multipliers: %ld negative, not %ld", what, K->blocks,
               K->multipliers, fronts_negative(f), negative);
}

/* One random matrix; 1 where it was eliminated. */
static int run(enum shape shape, double shift, int loose, int multipliers)
{
    static struct matrix K;
    static struct compressed C;
    double scale[3 * MOST];
    make_matrix(&K, shape, shift, loose, multipliers);
    compress(&K, &C);
    hobe_fronts *f = fronts_analyse(K.blocks, K.multipliers, C.start, C.row, NULL);
    double *value = f ? hobe_alloc(fronts_size(f), sizeof *value, NULL) : NULL;
    if (!value)
        check_stop("no memory");
    spread(&K, f, value);
    fronts_scale(f, value, scale);
    fronts_scale_border(f, value, scale);
    check_scale(&K, scale);
    check_order(&K, f);
    const int done = !fronts_factor(f, value, scale);
    if (done) {
        compare_solutions(&K, &C, f, value, scale, shape_name[shape]);
        check_negative(&K, f, shape_name[shape]);
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

/* The same constraint twice leaves the second multiplier nothing. */
static void refuses_twice(void)
{
    const long start[] = {0, 3, 5, 7}, row[] = {0, 1, 2, 0, 1, 0, 2};
    const double ones[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    hobe_fronts *f = fronts_analyse(3, 2, start, row, NULL);
    double *value = f ? hobe_alloc(fronts_size(f), sizeof *value, NULL) : NULL;
    if (!value)
        check_stop("no memory");
    for (long i = 0; i < 3; i++)
        for (int a = 0; a < 3; a++)
            value[fronts_place(f, i, 0) + a * fronts_stride(f, 0) + a] = 1;
    check_that(fronts_factor(f, value, ones) == HOBE_SINGULAR, "a constraint twice is refused");
    hobe_free(value);
    fronts_free(f);
}

/* ---- long rows of joints --------------------------------------------------------------------- */

enum { PART = 12, TIED = 3, ROWS = 40 }; /* blocks of a beam, those tied at its ends; of a column */

/* Columns of blocks while they are found. */
struct columns {
    long *count, (*row)[ROWS];
};

static void couple(struct columns *c, const long *block, int count)
{
    for (int k = 0; k < count; k++)
        for (int l = 0; l < count; l++) {
            long i = 0, *row = c->row[block[k]], *end = c->count + block[k];
            while (i < *end && row[i] < block[l])
                i++;
            if (i < *end && row[i] == block[l])
                continue;
            memmove(row + i + 1, row + i, (size_t)(*end - i) * sizeof *row);
            row[i] = block[l];
            ++*end;
        }
}

/* How large the panels are of beams in a row, jointed by two multipliers each: they have the
 * numbers that `number` gives them. */
static size_t row_size(long beams, const long *number)
{
    const long blocks = beams * PART + 2 * (beams - 1);
    long *start = hobe_alloc((size_t)blocks + 1, sizeof *start, NULL), *row, block[PART];
    struct columns c = {hobe_alloc((size_t)blocks, sizeof *c.count, NULL),
                        hobe_alloc((size_t)blocks, sizeof *c.row, NULL)};
    for (long b = 0; b < beams; b++) {
        for (long k = 0; k < PART; k++)
            block[k] = number[b] * PART + k;
        couple(&c, block, PART);
        for (long k = 0; k < TIED && b > 0; k++) {
            block[k] = number[b - 1] * PART + PART - 1 - k;
            block[TIED + k] = number[b] * PART + k;
        }
        for (long k = 0; k < 2 && b > 0; k++)
            block[2 * TIED + k] = beams * PART + 2 * (b - 1) + k;
        couple(&c, block, b > 0 ? 2 * TIED + 2 : 0);
    }
    for (long j = 0; j < blocks; j++)
        start[j + 1] = start[j] + c.count[j];
    row = hobe_alloc((size_t)start[blocks], sizeof *row, NULL);
    for (long j = 0; j < blocks; j++)
        memcpy(row + start[j], c.row[j], (size_t)c.count[j] * sizeof *row);
    hobe_fronts *f = fronts_analyse(blocks, 2 * (beams - 1), start, row, NULL);
    const size_t size = f ? fronts_size(f) : 0;
    fronts_free(f);
    hobe_free(row);
    hobe_free(start);
    hobe_free(c.count);
    hobe_free(c.row);
    return size;
}

/* Multipliers are eliminated where their neighbours are: panels grow as the beams do, in whatever
 * order these are numbered. */
static void grows_linearly(void)
{
    enum { BEAMS = 1000 };
    long number[BEAMS];
    for (long b = 0; b < BEAMS; b++)
        number[b] = b;
    const size_t few = row_size(10, number), many = row_size(BEAMS, number);
    check_that(many < BEAMS / 10 * few * 1.2, "%zu doubles of %d beams, %zu of 10", many, BEAMS,
               few);
    for (long b = BEAMS - 1; b > 0; b--) {
        const long other = random_int(0, (int)b), swapped = number[b];
        number[b] = number[other];
        number[other] = swapped;
    }
    const size_t mixed = row_size(BEAMS, number);
    check_that(mixed < 2 * many, "%zu doubles of beams in a random order, %zu in a row", mixed,
               many);
}

int main(void)
{
    random_start();
    for (enum shape shape = CHAIN; shape < SHAPES; shape++) {
        int indefinite = 0;
        for (int i = 0; i < 20; i++) {
            check_that(run(shape, 0, 0, 0), "a definite matrix needs no pivoting");
            check_that(run(shape, 0, 0, random_int(1, MULTIPLIERS)), "nor do constraints of it");
            check_that(run(shape, 0, 1, random_int(1, MULTIPLIERS)), "nor where they must hold it");
            indefinite += run(shape, random_real(2, 8), 0, i % 2 * random_int(1, MULTIPLIERS));
        }
        check_that(indefinite > 10, "%s: most indefinite matrices need no pivoting",
                   shape_name[shape]);
    }
    refuses();
    refuses_twice();
    grows_linearly();
    return check_report();
}
