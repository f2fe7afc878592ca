/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arithmetic of enriched elements: compiled once for each kind of processor, as kernels are. */
#include "enriched.h"

#include <string.h>

enum {
    MOST = HOBE_MAX_VECTORS + HOBE_MAX_MODES,
    MOST_GRAMS = HOBE_MAX_MODES * (2 * HOBE_MAX_MODES - 1)
};

/* Beside the diagonal of the law, that is what rounding makes of a symmetric section. */
static const double ZERO = 1e-14;

/* A pivot that is less than this, relative to what it was before the others took their part of it,
 * is that of a rigid motion.  An element of bending stiffness EI that is 1e5 times as long as thick
 * has 1e-11 beside GA. */
static const double FREE = 1e-12;

/* Axial functions that multiply vectors: of the kernel, or those tried. */
struct functions {
    int count, mode[MOST], degree[MOST];
    double N[MOST], Nx[MOST]; /* at a place */
};

/* One of a row of the law Q of Gram entries. */
struct entry {
    int column;
    double value;
};

/* What a call works with, of one part of a batch.  Section vectors are those of kernel.h. */
struct work {
    const struct enriched *e;
    int sections, normals, grams;
    struct functions of, trial;
    hobe_real *q0, *u, *f;      /* [vectors][3] */
    hobe_real *D0, *U, *D, *P;  /* [sections][3] D = D0 + U; P = dW/dD, with the station's weight */
    hobe_real *s, *stress, *CB; /* [grams]; CB[grams][3] of a section vector */
    hobe_real *H;               /* [sections][sections][3][3] dP/dD without the geometric part */
    hobe_real *K;               /* [3 n (3 n + 1)/2] lower triangle */
    hobe_real *F, *x, *pivot;   /* [n][3]; x = F - a, then the solution; 1/pivots, 0 of free ones */
    struct entry *entry, *row[MOST_GRAMS + 1]; /* Q, and where its rows [grams] begin and end */
};

static void clear(hobe_real *x, int n)
{
    for (int i = 0; i < n; i++)
        x[i] = (hobe_real){0};
}

/* ---- functions ------------------------------------------------------------------------------ */

/* Legendre's polynomials on [0, 1] at xi. */
static void evaluate(struct functions *of, double xi, double length)
{
    double p[MOST], px[MOST];
    const double t = 2 * xi - 1;
    p[0] = 1, p[1] = t;
    px[0] = 0, px[1] = 2 / length;
    for (int i = 0; i < of->count; i++) {
        const int k = of->degree[i];
        if (k > 1) {
            p[k] = ((2 * k - 1) * t * p[k - 1] - (k - 1) * p[k - 2]) / k;
            px[k] = px[k - 2] + (2 * k - 1) * 2 / length * p[k - 1];
        }
        of->N[i] = p[k];
        of->Nx[i] = px[k];
    }
}

/* As many for each mode as it has vectors, and one more; not more than there are stations to tell
 * them apart.  A constant of the centreline does nothing. */
static void choose(struct work *w)
{
    const struct hobe_kernel *k = w->e->kernel;
    w->trial.count = 0;
    for (int m = 0; m < k->modes; m++) {
        int count = 1;
        for (int v = 0; v < k->vectors; v++)
            count += k->vector[v].mode == m;
        for (int d = 0; d < count && d < w->e->inv->stations && !w->e->dropped[m]; d++) {
            w->trial.mode[w->trial.count] = m;
            w->trial.degree[w->trial.count] = d;
            w->trial.count += m > 0 || d > 0;
        }
    }
    w->of.count = k->vectors;
    for (int v = 0; v < k->vectors; v++)
        w->of.mode[v] = k->vector[v].mode;
}

/* The section vector of a mode's derivative, or of its value: none of the centreline's. */
static inline int section_vector(const struct work *w, int mode, int value)
{
    return value ? mode + w->e->kernel->modes - 1 : mode;
}

/* D += the section vectors of a field q[vectors][3]. */
static void add_sections(const struct work *w, const hobe_real *q, hobe_real *D)
{
    for (int v = 0; v < w->of.count; v++)
        for (int value = 0; value <= (w->of.mode[v] > 0); value++) {
            const double N = value ? w->of.N[v] : w->of.Nx[v];
            hobe_real *to = D + 3 * section_vector(w, w->of.mode[v], value);
            for (int a = 0; a < 3; a++)
                to[a] += N * q[3 * v + a];
        }
}

/* f += sign times the work of P on functions. */
static void add_work(const struct work *w, const struct functions *of, double sign, hobe_real *f)
{
    for (int i = 0; i < of->count; i++)
        for (int value = 0; value <= (of->mode[i] > 0); value++) {
            const double N = sign * (value ? of->N[i] : of->Nx[i]);
            const hobe_real *from = w->P + 3 * section_vector(w, of->mode[i], value);
            for (int a = 0; a < 3; a++)
                f[3 * i + a] += N * from[a];
        }
}

/* ---- a station ------------------------------------------------------------------------------ */

/* The place of s_ij among the Gram entries (kernel.h): the normal block, then the shear block. */
static inline int gram(const struct work *w, int i, int j)
{
    const int M = w->e->kernel->modes, low = i < j ? i : j, high = i < j ? j : i;
    if (high < M)
        return hobe_pair(high, low);
    return low < M ? w->normals + low * (M - 1) + high - M
                   : M * (M + 1) / 2 + hobe_pair(high - M, low - M);
}

static double law_at(const struct work *w, int g, int r, int c)
{
    const struct hobe_invariants *inv = w->e->inv;
    const int n = w->normals, m = w->grams - n, low = r < c ? r : c, high = r < c ? c : r;
    if (high < n)
        return inv->Qn[inv->step_n * g + r * n + c];
    if (low >= n)
        return inv->Qs[inv->step_s * g + (r - n) * m + c - n];
    return inv->Qc ? inv->Qc[inv->step_c * g + low * m + high - n] : 0;
}

/* The rows of Q at a station, without what is zero: on a symmetric section most is. */
static void set_law(struct work *w, int g)
{
    struct entry *next = w->entry;
    for (int r = 0; r < w->grams; r++) {
        w->row[r] = next;
        for (int c = 0; c < w->grams; c++) {
            const double Q = law_at(w, g, r, c);
            if (Q * Q > ZERO * ZERO * law_at(w, g, r, r) * law_at(w, g, c, c))
                *next++ = (struct entry){c, Q};
        }
    }
    w->row[w->grams] = next;
}

/* P, by the strains s_ij = D_i.D_j - D0_i.D0_j, s_ii half of that. */
static void find_stress(struct work *w, double weight)
{
    for (int i = 0; i < w->sections; i++)
        for (int j = 0; j <= i; j++) {
            hobe_real s = {0};
            for (int a = 0; a < 3; a++)
                s += w->U[3 * i + a] * w->D[3 * j + a] + w->D0[3 * i + a] * w->U[3 * j + a];
            w->s[gram(w, i, j)] = (i == j ? 0.5 : 1) * s;
        }
    for (int r = 0; r < w->grams; r++) {
        w->stress[r] = (hobe_real){0};
        for (const struct entry *Q = w->row[r]; Q < w->row[r + 1]; Q++)
            w->stress[r] += weight * Q->value * w->s[Q->column];
    }
    clear(w->P, 3 * w->sections);
    for (int i = 0; i < w->sections; i++)
        for (int j = 0; j < w->sections; j++)
            for (int a = 0; a < 3; a++)
                w->P[3 * i + a] += w->stress[gram(w, i, j)] * w->D[3 * j + a];
}

/* CB = what the change of the section vector j does to the stress, d s_jl = D_l.dD_j. */
static void stress_of(struct work *w, int j, double weight)
{
    clear(w->CB, 3 * w->grams);
    for (int l = 0; l < w->sections; l++) {
        const int r = gram(w, j, l);
        for (const struct entry *Q = w->row[r]; Q < w->row[r + 1]; Q++)
            for (int a = 0; a < 3; a++)
                w->CB[3 * Q->column + a] += weight * Q->value * w->D[3 * l + a];
    }
}

/* H_ij for all i whose mode does not come before that of j. */
static void find_stiffness(struct work *w, double weight)
{
    const int M = w->e->kernel->modes;
    for (int j = 0; j < w->sections; j++) {
        const int mode = j < M ? j : j - M + 1;
        stress_of(w, j, weight);
        for (int i = 0; i < w->sections; i++) {
            hobe_real *H = w->H + 9 * (i * w->sections + j);
            if ((i < M ? i : i - M + 1) < mode)
                continue;
            clear(H, 9);
            for (int l = 0; l < w->sections; l++) {
                const hobe_real *CB = w->CB + 3 * gram(w, i, l);
                for (int a = 0; a < 9; a++)
                    H[a] += w->D[3 * l + a / 3] * CB[a % 3];
            }
        }
    }
}

/* The block of two trial functions, added to K. */
static void add_block(struct work *w, int i, int j, const hobe_real block[9])
{
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < (i == j ? a + 1 : 3); c++)
            w->K[hobe_pair(3 * i + a, 0) + 3 * j + c] += block[3 * a + c];
}

static void add_stiffness(struct work *w)
{
    const struct functions *t = &w->trial;
    for (int i = 0; i < t->count; i++)
        for (int j = 0; j <= i; j++) {
            hobe_real block[9];
            clear(block, 9);
            for (int p = 0; p <= (t->mode[i] > 0); p++)
                for (int q = 0; q <= (t->mode[j] > 0); q++) {
                    const double N = (p ? t->N[i] : t->Nx[i]) * (q ? t->N[j] : t->Nx[j]);
                    const hobe_real *H =
                        w->H + 9 * (section_vector(w, t->mode[i], p) * w->sections +
                                    section_vector(w, t->mode[j], q));
                    for (int a = 0; a < 9; a++)
                        block[a] += N * H[a];
                }
            add_block(w, i, j, block);
        }
}

static void add_station(struct work *w, int g)
{
    const struct hobe_invariants *inv = w->e->inv;
    const int V = w->of.count;
    memcpy(w->of.N, inv->N + V * g, (size_t)V * sizeof *w->of.N);
    memcpy(w->of.Nx, inv->Nx + V * g, (size_t)V * sizeof *w->of.Nx);
    evaluate(&w->trial, inv->xi[g], inv->length);
    clear(w->D0, 3 * w->sections);
    clear(w->U, 3 * w->sections);
    add_sections(w, w->q0, w->D0);
    add_sections(w, w->u, w->U);
    for (int i = 0; i < 3 * w->sections; i++)
        w->D[i] = w->D0[i] + w->U[i];
    if (g == 0 || inv->step_n > 0)
        set_law(w, g);
    find_stress(w, inv->wx[g]);
    add_work(w, &w->of, 1, w->f);
    add_work(w, &w->trial, -1, w->x);
    find_stiffness(w, inv->wx[g]);
    add_stiffness(w);
}

/* ---- the element ---------------------------------------------------------------------------- */

/* F by the nodal forces, where all stations have been. */
static void find_loads(struct work *w)
{
    const struct hobe_kernel *k = w->e->kernel;
    clear(w->F, 3 * w->trial.count);
    for (int v = 0; v < k->vectors; v++) {
        evaluate(&w->trial, k->node[k->vector[v].node], w->e->inv->length);
        for (int i = 0; i < w->trial.count; i++)
            for (int a = 0; a < 3 && w->trial.mode[i] == w->of.mode[v]; a++)
                w->F[3 * i + a] +=
                    (k->vector[v].slope ? w->trial.Nx[i] : w->trial.N[i]) * w->f[3 * v + a];
    }
}

/* x = K^-1 x, from the last unknown to the first, so that rigid motions are left for the last. */
static void solve(struct work *w)
{
    const int n = 3 * w->trial.count;
    for (int p = 0; p < n; p++)
        w->pivot[p] = w->K[hobe_pair(p, p)];
    for (int p = n - 1; p >= 0; p--) {
        const hobe_real *row = w->K + hobe_pair(p, 0), most = w->pivot[p];
        for (size_t l = 0; l < sizeof most / sizeof(double); l++)
            w->pivot[p][l] = row[p][l] > FREE * most[l] ? 1 / row[p][l] : 0;
        for (int i = 0; i < p; i++) {
            const hobe_real factor = row[i] * w->pivot[p];
            hobe_real *to = w->K + hobe_pair(i, 0);
            for (int j = 0; j <= i; j++)
                to[j] -= factor * row[j];
            w->x[i] -= factor * w->x[p];
        }
    }
    for (int p = 0; p < n; p++) {
        const hobe_real *row = w->K + hobe_pair(p, 0);
        for (int j = 0; j < p; j++)
            w->x[p] -= row[j] * w->x[j];
        w->x[p] *= w->pivot[p];
    }
}

/* Divides the scratch. */
static void lay_out(struct work *w, const struct enriched *e, hobe_lanes *scratch)
{
    const struct hobe_kernel *k = e->kernel;
    hobe_real *next = (hobe_real *)scratch;
    w->e = e;
    w->normals = k->normals;
    w->grams = k->normals + k->shears;
    w->sections = 2 * k->modes - 1;
    choose(w);
    const int V = 3 * k->vectors, S = 3 * w->sections, n = 3 * w->trial.count;
    const struct {
        hobe_real **array;
        int size;
    } arrays[] = {{&w->q0, V},
                  {&w->u, V},
                  {&w->f, V},
                  {&w->D0, S},
                  {&w->U, S},
                  {&w->D, S},
                  {&w->P, S},
                  {&w->s, w->grams},
                  {&w->stress, w->grams},
                  {&w->CB, 3 * w->grams},
                  {&w->H, S * S},
                  {&w->K, n * (n + 1) / 2},
                  {&w->F, n},
                  {&w->x, n},
                  {&w->pivot, n}};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        *arrays[i].array = next;
        next += arrays[i].size;
    }
    w->entry = (struct entry *)next;
}

extern enriched_function HOBE_KERNEL(enriched);

void HOBE_KERNEL(enriched)(const struct enriched *e, const hobe_lanes *q0, const hobe_lanes *u,
                           hobe_lanes *work, hobe_lanes *scratch)
{
    struct work w;
    lay_out(&w, e, scratch);
    for (int part = 0; part < HOBE_PARTS; part++) {
        const int n = 3 * w.trial.count;
        hobe_real sum = {0};
        for (int i = 0; i < 3 * w.of.count; i++) {
            w.q0[i] = ((const hobe_real *)q0)[i * HOBE_PARTS + part];
            w.u[i] = ((const hobe_real *)u)[i * HOBE_PARTS + part];
        }
        clear(w.f, 3 * w.of.count);
        clear(w.K, n * (n + 1) / 2);
        clear(w.x, n);
        for (int g = 0; g < e->inv->stations; g++)
            add_station(&w, g);
        find_loads(&w);
        for (int i = 0; i < n; i++)
            w.x[i] += w.F[i];
        solve(&w);
        for (int i = 0; i < n; i++)
            sum += w.F[i] * w.x[i];
        ((hobe_real *)work)[part] = sum;
    }
}
