/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arithmetic of points: compiled once for each kind of processor, as kernels are. */
#include "points.h"

#include <string.h>

/* Of one point: the deformation gradient F_ia = dr_i/dX_a, and W_ia what warping functions add to
 * it, a = y, z; the strain, and its part eta in yy, zz, yz; the weighted stress S_ab, and T_ab that
 * works on eta.  Strains are kept as F'F less its reference, which is twice the normal ones. */
struct at_point {
    hobe_real F[3][3], W[3][2], strain[6], eta[3], S[3][3], T[2][2];
};

/* Of a station: means of strain and eta; the stress of the mean strain; the sum of the points'
 * stresses yy, zz, yz. */
struct at_station {
    hobe_real strain[6], eta[3], stress[6], sum[3];
};

/* Rows of a vector at a point: B[6][3], the strain xx, yy, zz, 2yz, 2xz, 2xy of each component;
 * weight C B; and weight S G. */
struct rows {
    hobe_real B[18], CB[18], SG[3];
};

/* What a call works with, of one part of a batch. */
struct work {
    const struct points *p;
    hobe_real *x, *x0;   /* [vectors][3] positions or displacements; reference or NULL */
    hobe_real *f, *K;    /* as in points_function; K may be NULL */
    struct rows *rows;   /* [vectors] */
    struct rows *mean;   /* [vectors] of the mean strain */
    hobe_real (*eta)[9]; /* [vectors] rows yy, zz, 2yz of the mean of eta */
};

enum { ROWS = sizeof(struct rows) / sizeof(hobe_real), ETA_ROWS = 9, ETA = 1 /* yy, in Voigt */ };

/* What a point is stays in registers: these know, where they are inlined, whether the element is
 * plain, with neither differences nor means to take. */
#define AT_POINT static inline __attribute__((always_inline))

/* Entries of a symmetric tensor. */
static const int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

static void clear(hobe_real *x, int n)
{
    for (int i = 0; i < n; i++)
        x[i] = (hobe_real){0};
}

/* ---- strain --------------------------------------------------------------------------------- */

/* x = one part of a batch, positions from the first node's. */
static void gather(const struct points *p, const hobe_real *q, hobe_real *x)
{
    for (int v = 0; v < p->vectors; v++)
        for (int i = 0; i < 3; i++) {
            x[3 * v + i] = q[(3 * v + i) * HOBE_PARTS];
            if (p->position[v])
                x[3 * v + i] -= q[i * HOBE_PARTS];
        }
}

AT_POINT void deform(int vectors, const double *G, const hobe_real *x, hobe_real F[3][3])
{
    clear(F[0], 9);
    for (int v = 0; v < vectors; v++)
        for (int i = 0; i < 3; i++)
            for (int a = 0; a < 3; a++)
                F[i][a] += G[3 * v + a] * x[3 * v + i];
}

/* F'F - 1 */
AT_POINT void strain_of(hobe_real F[3][3], hobe_real *strain)
{
    for (int r = 0; r < 6; r++) {
        const int a = voigt[r][0], b = voigt[r][1];
        strain[r] = F[0][a] * F[0][b] + F[1][a] * F[1][b] + F[2][a] * F[2][b];
        if (r < 3)
            strain[r] -= 1;
    }
}

/* F'F - F0'F0 = M'H + H'M with the mean M = F0 + H/2, which loses nothing where H is small; F0
 * becomes F. */
AT_POINT void strain_by(hobe_real F[3][3], hobe_real H[3][3], hobe_real *strain)
{
    for (int i = 0; i < 9; i++)
        F[i / 3][i % 3] += 0.5 * H[i / 3][i % 3];
    for (int r = 0; r < 6; r++) {
        const int a = voigt[r][0], b = voigt[r][1];
        strain[r] = F[0][a] * H[0][b] + F[1][a] * H[1][b] + F[2][a] * H[2][b] + H[0][a] * F[0][b] +
                    H[1][a] * F[1][b] + H[2][a] * F[2][b];
    }
    for (int i = 0; i < 9; i++)
        F[i / 3][i % 3] += 0.5 * H[i / 3][i % 3];
}

/* The gradient in y and z of what warping functions alone displace. */
static void warp(const struct points *p, const double *G, const hobe_real *x, hobe_real W[3][3])
{
    clear(W[0], 9);
    for (int v = 0; v < p->vectors; v++)
        for (int i = 0; p->warps[v] && i < 3; i++)
            for (int a = 1; a < 3; a++)
                W[i][a] += G[3 * v + a] * x[3 * v + i];
}

static void set_eta(const struct work *w, const double *G, struct at_point *at)
{
    hobe_real H[3][3], W[3][3] = {{{0}}}, strain[6];
    if (w->x0)
        warp(w->p, G, w->x0, W);
    warp(w->p, G, w->x, H);
    strain_by(W, H, strain);
    memcpy(at->eta, strain + ETA, sizeof at->eta);
    for (int i = 0; i < 6; i++)
        at->W[i / 2][i % 2] = W[i / 2][1 + i % 2];
}

AT_POINT void set_strain(const struct work *w, const double *G, int plain, struct at_point *at)
{
    hobe_real H[3][3];
    if (plain || !w->x0) {
        deform(w->p->vectors, G, w->x, at->F);
        strain_of(at->F, at->strain);
    } else {
        deform(w->p->vectors, G, w->x0, at->F);
        deform(w->p->vectors, G, w->x, H);
        strain_by(at->F, H, at->strain);
    }
    if (!plain && w->p->warps)
        set_eta(w, G, at);
}

/* ---- stress --------------------------------------------------------------------------------- */

AT_POINT void law_stress(const struct hobe_elasticity *C, double weight, const hobe_real *strain,
                         hobe_real *stress)
{
    for (int a = 0; a < 3; a++) {
        stress[a] = 0.5 * weight *
                    (C->normal[a][0] * strain[0] + C->normal[a][1] * strain[1] +
                     C->normal[a][2] * strain[2]);
        stress[3 + a] = weight * C->shear[a] * strain[3 + a];
    }
}

/* eta is taken at its mean. */
static void relieve(const struct at_station *station, struct at_point *at)
{
    for (int r = 0; r < 3; r++)
        at->strain[ETA + r] += station->eta[r] - at->eta[r];
}

/* What works on eta: less the stress at the point, plus its share of all. */
static void set_eta_stress(const double *share, const struct at_station *station,
                           const hobe_real *stress, struct at_point *at)
{
    for (int r = 0; r < 3; r++) {
        const int a = voigt[ETA + r][0] - 1, b = voigt[ETA + r][1] - 1;
        at->T[a][b] = at->T[b][a] = share[r / 2] * station->sum[r] - stress[ETA + r];
    }
}

static void add_mean_stress(const double *share, const struct at_station *station,
                            hobe_real *stress)
{
    for (int r = 0; r < 6; r++)
        stress[r] += share[r / 3] * station->stress[r];
}

/* The stress of a point's strain, and what the mean strain adds. */
AT_POINT void set_stress(const struct points *p, int i, const struct at_station *station, int plain,
                         struct at_point *at)
{
    hobe_real stress[6];
    if (!plain && p->warps)
        relieve(station, at);
    law_stress(p->law + p->region[i], p->weight[i], at->strain, stress);
    if (!plain && p->warps)
        set_eta_stress(p->share + 2 * i, station, stress, at);
    if (!plain && p->share)
        add_mean_stress(p->share + 2 * i, station, stress);
    for (int r = 0; r < 6; r++)
        at->S[voigt[r][0]][voigt[r][1]] = at->S[voigt[r][1]][voigt[r][0]] = stress[r];
}

/* One point's part of the means. */
static void add_means(const struct points *p, int i, struct at_point *at,
                      struct at_station *station)
{
    hobe_real stress[6];
    for (int r = 0; r < 6; r++)
        station->strain[r] += p->share[2 * i + r / 3] * at->strain[r];
    if (!p->warps)
        return;
    for (int r = 0; r < 3; r++) {
        station->eta[r] += p->share[2 * i + r / 2] * at->eta[r];
        at->strain[ETA + r] -= at->eta[r];
    }
    law_stress(p->law + p->region[i], p->weight[i], at->strain, stress);
    for (int r = 0; r < 3; r++)
        station->sum[r] += stress[ETA + r];
}

/* The stress of the mean strain; and of the mean of eta the part of the sum. */
static void set_mean_stress(const struct points *p, int g, struct at_station *station)
{
    hobe_real strain[6] = {{0}}, stress[6];
    law_stress(&p->mean, p->volume[g], station->strain, station->stress);
    if (!p->warps)
        return;
    memcpy(strain + ETA, station->eta, sizeof station->eta);
    law_stress(p->sum + g, 1, strain, stress);
    for (int r = 0; r < 3; r++)
        station->sum[r] += stress[ETA + r];
}

/* ---- force and tangent ---------------------------------------------------------------------- */

/* f_v += F S G_v */
AT_POINT void add_force(int vectors, const double *G, const struct at_point *at, hobe_real *f)
{
    for (int i = 0; i < 3; i++) {
        hobe_real P[3];
        for (int a = 0; a < 3; a++)
            P[a] =
                at->F[i][0] * at->S[0][a] + at->F[i][1] * at->S[1][a] + at->F[i][2] * at->S[2][a];
        for (int v = 0; v < vectors; v++)
            f[(3 * v + i) * HOBE_PARTS] +=
                P[0] * G[3 * v] + P[1] * G[3 * v + 1] + P[2] * G[3 * v + 2];
    }
}

/* f_v += W T G_v of vectors that warp */
static void add_eta_force(const struct points *p, const double *G, const struct at_point *at,
                          hobe_real *f)
{
    for (int v = 0; v < p->vectors; v++)
        for (int i = 0; p->warps[v] && i < 3; i++)
            for (int a = 0; a < 2; a++)
                f[(3 * v + i) * HOBE_PARTS] +=
                    (at->W[i][0] * at->T[0][a] + at->W[i][1] * at->T[1][a]) * G[3 * v + 1 + a];
}

AT_POINT void set_B(const double *G, const struct at_point *at, hobe_real *B)
{
    for (int i = 0; i < 3; i++)
        for (int r = 0; r < 3; r++) {
            const int a = voigt[3 + r][0], b = voigt[3 + r][1];
            B[3 * r + i] = at->F[i][r] * G[r];
            B[9 + 3 * r + i] = at->F[i][a] * G[b] + at->F[i][b] * G[a];
        }
}

/* B[3][3]: eta yy, zz, 2yz of each component of a vector that warps */
static void set_eta_B(const double *G, const struct at_point *at, hobe_real *B)
{
    for (int i = 0; i < 3; i++) {
        B[i] = at->W[i][0] * G[1];
        B[3 + i] = at->W[i][1] * G[2];
        B[6 + i] = at->W[i][0] * G[2] + at->W[i][1] * G[1];
    }
}

AT_POINT void set_CB(const struct hobe_elasticity *C, double weight, struct rows *rows)
{
    const hobe_real *B = rows->B;
    hobe_real *CB = rows->CB;
    for (int i = 0; i < 3; i++)
        for (int r = 0; r < 3; r++) {
            CB[3 * r + i] = weight * C->normal[r][0] * B[i] + weight * C->normal[r][1] * B[3 + i] +
                            weight * C->normal[r][2] * B[6 + i];
            CB[9 + 3 * r + i] = weight * C->shear[r] * B[9 + 3 * r + i];
        }
}

/* eta of the mean in the place of its own, of a vector that warps. */
static void relieve_rows(const double *G, const struct at_point *at, const hobe_real *mean,
                         hobe_real *B)
{
    hobe_real own[ETA_ROWS];
    set_eta_B(G, at, own);
    for (int r = 0; r < ETA_ROWS; r++)
        B[3 * ETA + r] += mean[r] - own[r];
}

/* Of all vectors at a point. */
AT_POINT void set_rows(const struct work *w, int i, const double *G, int plain,
                       const struct at_point *at)
{
    const struct points *p = w->p;
    for (int v = 0; v < p->vectors; v++, G += 3) {
        struct rows *rows = w->rows + v;
        set_B(G, at, rows->B);
        if (!plain && p->warps && p->warps[v])
            relieve_rows(G, at, w->eta[v], rows->B);
        set_CB(p->law + p->region[i], p->weight[i], rows);
        for (int a = 0; a < 3; a++)
            rows->SG[a] = at->S[a][0] * G[0] + at->S[a][1] * G[1] + at->S[a][2] * G[2];
    }
}

/* K += B'CB + G S G' 1, its lower triangle; G[vectors][3], rows[vectors] */
AT_POINT void add_tangent(int vectors, const double *G, const struct rows *rows, hobe_real *K)
{
    for (int v = 0; v < vectors; v++)
        for (int w = 0; w <= v; w++, K += 9 * HOBE_PARTS) {
            const struct rows *row = rows + v;
            const hobe_real *c = rows[w].CB, s = row->SG[0] * G[3 * w] + row->SG[1] * G[3 * w + 1] +
                                                 row->SG[2] * G[3 * w + 2];
            hobe_real k[9] = {s, {0}, {0}, {0}, s, {0}, {0}, {0}, s};
            for (int r = 0; r < 6; r++)
                for (int ij = 0; ij < 9; ij++)
                    k[ij] += row->B[3 * r + ij / 3] * c[3 * r + ij % 3];
            for (int ij = 0; ij < 9; ij++)
                K[ij * HOBE_PARTS] += k[ij];
        }
}

/* K += G T G' 1 of vectors that warp */
static void add_eta_tangent(const struct points *p, const double *G, const struct at_point *at,
                            hobe_real *K)
{
    for (int v = 0; v < p->vectors; v++)
        for (int w = 0; w <= v; w++, K += 9 * HOBE_PARTS) {
            const double *a = G + 3 * v + 1, *b = G + 3 * w + 1;
            if (!p->warps[v] || !p->warps[w])
                continue;
            const hobe_real s = at->T[0][0] * (a[0] * b[0]) + at->T[1][1] * (a[1] * b[1]) +
                                at->T[0][1] * (a[0] * b[1] + a[1] * b[0]);
            for (int i = 0; i < 3; i++)
                K[4 * i * HOBE_PARTS] += s;
        }
}

/* ---- an element ----------------------------------------------------------------------------- */

/* One point's part of the rows of means. */
static void add_mean_rows(const struct work *w, int i, const double *G, const struct at_point *at)
{
    const struct points *p = w->p;
    const double *share = p->share + 2 * i;
    hobe_real B[18];
    for (int v = 0; v < p->vectors; v++) {
        set_B(G + 3 * v, at, B);
        for (int r = 0; r < 18; r++)
            w->mean[v].B[r] += share[r / 9] * B[r];
        if (!p->warps || !p->warps[v])
            continue;
        set_eta_B(G + 3 * v, at, B);
        for (int r = 0; r < ETA_ROWS; r++)
            w->eta[v][r] += share[r / 6] * B[r];
    }
}

/* Means over a station, and the tangent of their law. */
static void find_means(const struct work *w, int g, struct at_station *station)
{
    const struct points *p = w->p;
    const int V = p->vectors;
    if (w->K) {
        clear((hobe_real *)w->mean, ROWS * V);
        clear(w->eta[0], ETA_ROWS * V);
    }
    for (int i = p->first[g]; i < p->first[g + 1]; i++) {
        const double *G = p->gradient + 3 * V * i;
        struct at_point at;
        set_strain(w, G, 0, &at);
        add_means(p, i, &at, station);
        if (w->K)
            add_mean_rows(w, i, G, &at);
    }
    set_mean_stress(p, g, station);
    for (int v = 0; w->K && v < V; v++)
        set_CB(&p->mean, p->volume[g], w->mean + v);
    if (w->K)
        add_tangent(V, p->gradient, w->mean, w->K); /* no S G: that is the points' */
}

AT_POINT void add_point(const struct work *w, int i, const struct at_station *station, int plain)
{
    const struct points *p = w->p;
    const double *G = p->gradient + 3 * p->vectors * i;
    struct at_point at;
    set_strain(w, G, plain, &at);
    set_stress(p, i, station, plain, &at);
    add_force(p->vectors, G, &at, w->f);
    if (!plain && p->warps)
        add_eta_force(p, G, &at, w->f);
    if (!w->K)
        return;
    set_rows(w, i, G, plain, &at);
    add_tangent(p->vectors, G, w->rows, w->K);
    if (!plain && p->warps)
        add_eta_tangent(p, G, &at, w->K);
}

static void add_station(const struct work *w, int g)
{
    const struct points *p = w->p;
    const int plain = !w->x0 && !p->share;
    struct at_station station = {.strain = {{0}}};
    if (p->share)
        find_means(w, g, &station);
    for (int i = p->first[g]; plain && i < p->first[g + 1]; i++)
        add_point(w, i, &station, 1);
    for (int i = p->first[g]; !plain && i < p->first[g + 1]; i++)
        add_point(w, i, &station, 0);
}

points_function HOBE_KERNEL(points);

void HOBE_KERNEL(points)(const struct points *p, const hobe_lanes *q0, const hobe_lanes *u,
                         hobe_lanes *f, hobe_lanes *K, hobe_lanes *scratch)
{
    const int V = p->vectors;
    hobe_real *x = (hobe_real *)scratch, *x0 = x + 3 * V, *eta = x0 + 3 * V;
    struct rows *rows = (struct rows *)(eta + ETA_ROWS * V);
    clear((hobe_real *)f, 3 * V * HOBE_PARTS);
    if (K)
        clear((hobe_real *)K, 9 * hobe_pair(V, 0) * HOBE_PARTS);
    for (int h = 0; h < HOBE_PARTS; h++) {
        gather(p, (const hobe_real *)u + h, x);
        if (q0)
            gather(p, (const hobe_real *)q0 + h, x0);
        const struct work w = {.p = p,
                               .x = x,
                               .x0 = q0 ? x0 : NULL,
                               .f = (hobe_real *)f + h,
                               .K = K ? (hobe_real *)K + h : NULL,
                               .rows = rows,
                               .mean = rows + V,
                               .eta = (hobe_real(*)[ETA_ROWS])eta};
        for (int g = 0; g < p->stations; g++)
            add_station(&w, g);
    }
}
