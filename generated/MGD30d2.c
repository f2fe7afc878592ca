/* MGD30d2: this project: MGD30d whose section distorts far, to the second order
 *
 * Written by `python -m generator`, declaration 306ca0460513a409: do not edit.
 * nodes at xi = 0 1/2 1; 52 vectors, 156 degrees of freedom
 * modes 1 y z w wy wz ww w1 v1y v1z v2y v2z w2 w2t v3y v3z w3
 * the energy is exact with 5 Gauss points on the axis
 * vectors (mode@node, ' for d/dx): 1@1 1'@1 y@1 z@1 w@1 wy@1 wz@1 ww@1 w1@1 v1y@1 v1z@1 v2y@1
 *     v2z@1 w2@1 w2t@1 v3y@1 v3z@1 w3@1 y@2 z@2 w@2 wy@2 wz@2 ww@2 w1@2 v1y@2 v1z@2 v2y@2
 *     v2z@2 w2@2 w2t@2 v3y@2 v3z@2 w3@2 1@3 1'@3 y@3 z@3 w@3 wy@3 wz@3 ww@3 w1@3 v1y@3 v1z@3
 *     v2y@3 v2z@3 w2@3 w2t@3 v3y@3 v3z@3 w3@3
 * operations per element: force 1648577, force and tangent 12946172, energy 1617537
 */
#include "kernel.h"

#if HOBE_KERNEL_ABI != 4
#error Regenerate: this file was written for another kernel ABI
#endif

enum {
    V = 52,   /* nodal vectors */
    M = 17,   /* section modes */
    S = 33,   /* section vectors d_k', d_k */
    NA = 153, /* Gram pairs d_k'.d_l' */
    NN = 289, /* normal block: those and d_k.d_l */
    NS = 272, /* shear block: d_k'.d_l */
    A = 7,    /* distinct axial functions */
};

static const hobe_real zero = {0};

/* Of each nodal vector: mode; whether it is a position; axial function. */
static const unsigned char mode[V] = {
    0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
    11, 12, 13, 14, 15, 16, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16,
};
static const unsigned char position[V] = {
    1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
};
static const unsigned char axial_of[V] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 4, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
};
static const unsigned char is_slope[A] = {
    0, 1, 0, 0, 0, 1, 0,
};

/* int_0^1 A_i A_j dxi, exact */
static const double overlap[A * A] = {
    13.0 / 35.0, 11.0 / 210.0, 11.0 / 60.0, 1.0 / 3.0, 9.0 / 70.0, -13.0 / 420.0, -1.0 / 60.0,
    11.0 / 210.0, 1.0 / 105.0, 1.0 / 60.0, 1.0 / 15.0, 13.0 / 420.0, -1.0 / 140.0, 0.0,
    11.0 / 60.0, 1.0 / 60.0, 2.0 / 15.0, 1.0 / 15.0, -1.0 / 60.0, 0.0, -1.0 / 30.0, 1.0 / 3.0,
    1.0 / 15.0, 1.0 / 15.0, 8.0 / 15.0, 1.0 / 3.0, -1.0 / 15.0, 1.0 / 15.0, 9.0 / 70.0,
    13.0 / 420.0, -1.0 / 60.0, 1.0 / 3.0, 13.0 / 35.0, -11.0 / 210.0, 11.0 / 60.0,
    -13.0 / 420.0, -1.0 / 140.0, 0.0, -1.0 / 15.0, -11.0 / 210.0, 1.0 / 105.0, -1.0 / 60.0,
    -1.0 / 60.0, 0.0, -1.0 / 30.0, 1.0 / 15.0, 11.0 / 60.0, -1.0 / 60.0, 2.0 / 15.0,
};

static void shape(double xi, double length, double *N, double *Nx)
{
    const double A_xi[A][2] = { /* A_i(xi), dA_i/dxi */
        {1.0 + xi * (xi * (-3.0 + xi * 2.0)),
         xi * (-6.0 + xi * 6.0)},
        {xi * (1.0 + xi * (-2.0 + xi * 1.0)),
         1.0 + xi * (-4.0 + xi * 3.0)},
        {1.0 + xi * (-3.0 + xi * 2.0),
         -3.0 + xi * 4.0},
        {xi * (4.0 + xi * (-4.0)),
         4.0 + xi * (-8.0)},
        {xi * (xi * (3.0 + xi * (-2.0))),
         xi * (6.0 + xi * (-6.0))},
        {xi * (xi * (-1.0 + xi * 1.0)),
         xi * (-2.0 + xi * 3.0)},
        {xi * (-1.0 + xi * 2.0),
         -1.0 + xi * 4.0},
    };
    for (int v = 0; v < V; v++) {
        const int i = axial_of[v];
        N[v] = A_xi[i][0] * (is_slope[i] ? length : 1.0);
        Nx[v] = A_xi[i][1] * (is_slope[i] ? 1.0 : 1.0 / length);
    }
}

static void section_modes(double y, double z, const double (*f)[4],
                          double (*phi)[4])
{
    phi[0][0] = 1.0;
    phi[0][1] = 0.0;
    phi[0][2] = 0.0;
    phi[0][3] = 0.0;
    phi[1][0] = y;
    phi[1][1] = 1.0;
    phi[1][2] = 0.0;
    phi[1][3] = 0.0;
    phi[2][0] = z;
    phi[2][1] = 0.0;
    phi[2][2] = 1.0;
    phi[2][3] = 0.0;
    phi[3][0] = f[0][0];
    phi[3][1] = f[0][1];
    phi[3][2] = f[0][2];
    phi[3][3] = f[0][3];
    phi[4][0] = f[1][0];
    phi[4][1] = f[1][1];
    phi[4][2] = f[1][2];
    phi[4][3] = f[1][3];
    phi[5][0] = f[2][0];
    phi[5][1] = f[2][1];
    phi[5][2] = f[2][2];
    phi[5][3] = f[2][3];
    phi[6][0] = f[3][0];
    phi[6][1] = f[3][1];
    phi[6][2] = f[3][2];
    phi[6][3] = f[3][3];
    phi[7][0] = f[4][0];
    phi[7][1] = f[4][1];
    phi[7][2] = f[4][2];
    phi[7][3] = f[4][3];
    phi[8][0] = f[5][0];
    phi[8][1] = f[5][1];
    phi[8][2] = f[5][2];
    phi[8][3] = f[5][3];
    phi[9][0] = f[6][0];
    phi[9][1] = f[6][1];
    phi[9][2] = f[6][2];
    phi[9][3] = f[6][3];
    phi[10][0] = f[7][0];
    phi[10][1] = f[7][1];
    phi[10][2] = f[7][2];
    phi[10][3] = f[7][3];
    phi[11][0] = f[8][0];
    phi[11][1] = f[8][1];
    phi[11][2] = f[8][2];
    phi[11][3] = f[8][3];
    phi[12][0] = f[9][0];
    phi[12][1] = f[9][1];
    phi[12][2] = f[9][2];
    phi[12][3] = f[9][3];
    phi[13][0] = f[10][0];
    phi[13][1] = f[10][1];
    phi[13][2] = f[10][2];
    phi[13][3] = f[10][3];
    phi[14][0] = f[11][0];
    phi[14][1] = f[11][1];
    phi[14][2] = f[11][2];
    phi[14][3] = f[11][3];
    phi[15][0] = f[12][0];
    phi[15][1] = f[12][1];
    phi[15][2] = f[12][2];
    phi[15][3] = f[12][3];
    phi[16][0] = f[13][0];
    phi[16][1] = f[13][1];
    phi[16][2] = f[13][2];
    phi[16][3] = f[13][3];
}

/* The section vectors D[S][3] of nodal vectors q[V][3] at a place of the axis. */
static void vectors_at(const double *N, const double *Nx, const double *q, double D[S][3])
{
    for (int i = 0; i < 3 * S; i++)
        D[i / 3][i % 3] = 0.0;
    for (int v = 0; v < V; v++)
        for (int a = 0; a < 3; a++) {
            /* the first node's position drops out: N' sums to 0 over positions */
            const double x = q[3 * v + a] - (position[v] ? q[a] : 0.0);
            D[mode[v]][a] += Nx[v] * x;
            if (mode[v] > 0)
                D[M - 1 + mode[v]][a] += N[v] * x;
        }
}

static double product(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* c = a x b */
static void cross(const double *a, const double *b, double *c)
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void normalise(double *a)
{
    const double length = __builtin_sqrt(product(a, a));
    for (int i = 0; i < 3; i++)
        a[i] /= length;
}

/* The section's axes where its vectors are D: R[0] along d_0', R[1] as near to d_y as can be. */
static void section_axes(const double D[S][3], double R[3][3])
{
    for (int a = 0; a < 3; a++)
        R[0][a] = D[0][a];
    normalise(R[0]);
    const double along = product(D[M], R[0]);
    for (int a = 0; a < 3; a++)
        R[1][a] = D[M][a] - along * R[0][a];
    normalise(R[1]);
    cross(R[0], R[1], R[2]);
}

/* p[3][S]: dr/dx = sum_I p_0I D_I at a point of the section, dr/dy and dr/dz likewise. */
static void parameter_rows(const double (*phi)[4], double p[3][S])
{
    for (int k = 0; k < M; k++) {
        p[0][k] = phi[k][0];
        p[1][k] = p[2][k] = 0.0;
    }
    for (int k = 1; k < M; k++) {
        p[0][M - 1 + k] = phi[k][3];
        p[1][M - 1 + k] = phi[k][1];
        p[2][M - 1 + k] = phi[k][2];
    }
}

/* g[3][S]: the gradient dr/dX_a = sum_I g_aI D_I on the section's axes at a point of an element
 * whose reference has the section vectors D0, g = J0^-T p; returns det J0 (eq. 22). */
static double gradient_rows(const double (*phi)[4], const double D0[S][3], double g[3][S])
{
    double p[3][S], R[3][3], J[3][3] = {{0}}, C[3][3];
    parameter_rows(phi, p);
    section_axes(D0, R);
    for (int b = 0; b < 3; b++)
        for (int i = 0; i < S; i++)
            for (int a = 0; a < 3; a++)
                J[b][a] += p[b][i] * product(D0[i], R[a]);
    for (int b = 0; b < 3; b++) /* cofactors: sum_b C_ba J_ba' = det J if a = a', else 0 */
        cross(J[(b + 1) % 3], J[(b + 2) % 3], C[b]);
    const double det = product(J[0], C[0]);
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < S; i++)
            g[a][i] = (C[0][a] * p[0][i] + C[1][a] * p[1][i] + C[2][a] * p[2][i]) / det;
    return det;
}

/* The gradient's rows at a point; returns det J0, 1 where D0 is NULL (straight and prismatic). */
static double point_rows(const struct hobe_section_point *at, const double (*D0)[3],
                         double phi[M][4], double g[3][S])
{
    section_modes(at->y, at->z, at->f, phi);
    if (D0)
        return gradient_rows((const double(*)[4])phi, D0, g);
    parameter_rows((const double(*)[4])phi, g);
    return 1.0;
}

/* Blocks of one station; Qc is NULL where normal and shear strains do not mix. */
struct blocks {
    double *Qn, *Qs, *Qc;
};

static void clear(double *x, int n)
{
    for (int i = 0; i < n; i++)
        x[i] = 0.0;
}

/* Of each section vector: whether it is that of a warping function. */
static const unsigned char warps[S] = {
    0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 0,
    0, 1,
};

static inline int symmetric(int i, int j)
{
    return i >= j ? hobe_pair(i, j) : hobe_pair(j, i);
}

/* The place of s_IJ, I <= J, among the Gram entries: the normal block, then the shear block. */
static int gram_entry(int i, int j)
{
    if (i < M && j >= M)
        return NN + i * (M - 1) + j - M;
    return i < M ? hobe_pair(j, i) : NA + hobe_pair(j - M, i - M);
}

/* Rows e[6] += weight (strain at a point per Gram entry): xx, yy, zz, 2yz, 2xz, 2xy. */
static void strain_rows(const double g[3][S], double weight, double e[6][NN + NS])
{
    static const int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    for (int r = 0; r < 6; r++) {
        const double *a = g[voigt[r][0]], *b = g[voigt[r][1]];
        const double factor = r < 3 ? 0.5 * weight : weight;
        for (int j = 0; j < S; j++)
            for (int i = 0; i <= j; i++)
                e[r][gram_entry(i, j)] += factor * (a[i] * b[j] + a[j] * b[i]);
    }
}

/* Q_rc += sum_a h_ar e_ac over strains first..last-1; rows and columns of Q from r0 and c0. */
static void add_block(double *Q, int r0, int rows, int c0, int columns, int first, int last,
                      double h[6][NN + NS], double e[6][NN + NS])
{
    for (int r = 0; r < rows; r++) {
        const int end = r0 == c0 ? r + 1 : columns; /* the lower triangle of a symmetric block */
        for (int a = first; a < last; a++)
            for (int c = 0; c < end; c++)
                Q[r * columns + c] += h[a][r0 + r] * e[a][c0 + c];
    }
}

/* Q += weight * sum_ab e_a C_ab e_b' over the strains e. */
static void add_law(const struct blocks *to, double e[6][NN + NS],
                    const struct hobe_elasticity *C, double weight)
{
    double h[6][NN + NS];
    for (int r = 0; r < NN + NS; r++)
        for (int a = 0; a < 3; a++) {
            h[a][r] = weight * (C->normal[a][0] * e[0][r] + C->normal[a][1] * e[1][r] +
                                C->normal[a][2] * e[2][r]);
            h[3 + a][r] = weight * C->shear[a] * e[3 + a][r];
        }
    add_block(to->Qn, 0, NN, 0, NN, 0, to->Qc ? 6 : 4, h, e);
    add_block(to->Qs, NN, NS, NN, NS, to->Qc ? 0 : 4, 6, h, e);
    if (to->Qc)
        add_block(to->Qc, 0, NN, NN, NS, 0, 6, h, e);
}

static void mirror(double *Q, int n)
{
    for (int r = 0; r < n; r++)
        for (int c = 0; c < r; c++)
            Q[c * n + r] = Q[r * n + c];
}

/* The strain of the mean law, means over `normal` and `shear`. */
static void mean_rows(const struct hobe_section_rule *normal,
                      const struct hobe_section_rule *shear, const double (*D0)[3],
                      double e[6][NN + NS])
{
    for (int part = 0; part < 2; part++) {
        const struct hobe_section_rule *rule = part ? shear : normal;
        double sum[6][NN + NS], g[3][S], phi[M][4], total = 0.0;
        clear(sum[0], 6 * (NN + NS));
        for (int p = 0; p < rule->points; p++) {
            const double weight = rule->point[p].weight * point_rows(rule->point + p, D0, phi, g);
            strain_rows((const double(*)[S])g, weight, sum);
            total += weight;
        }
        for (int a = 3 * part; a < 3 * part + 3; a++)
            for (int r = 0; r < NN + NS; r++)
                e[a][r] = sum[a][r] / total;
    }
}

/* Strain at a point: what warping alone makes of yy, zz, 2yz becomes that of the mean strain. */
static void relieve(double e[6][NN + NS], double mean[6][NN + NS])
{
    for (int j = 0; j < S; j++)
        for (int i = 0; i <= j; i++)
            if (warps[i] && warps[j])
                for (int a = 1; a <= 3; a++)
                    e[a][gram_entry(i, j)] = mean[a][gram_entry(i, j)];
}

/* Q of the law at each point of a section and of the law on the mean strain, and
 * moment_kl = int density phi_k phi_l dA.  D0: section vectors of the reference, or NULL. */
static void section_law(const struct blocks *to, const struct hobe_station *station,
                        const struct hobe_law *law, const double (*D0)[3], double moment[M][M])
{
    double mean[6][NN + NS], e[6][NN + NS], g[3][S], phi[M][4], area = 0.0;
    clear(to->Qn, NN * NN);
    clear(to->Qs, NS * NS);
    if (to->Qc)
        clear(to->Qc, NN * NS);
    clear(moment[0], M * M);
    mean_rows(&station->mean_normal, &station->mean_shear, D0, mean);
    for (int p = 0; p < station->rule.points; p++) {
        const struct hobe_section_point *at = station->rule.point + p;
        const double weight = at->weight * point_rows(at, D0, phi, g);
        clear(e[0], 6 * (NN + NS));
        strain_rows((const double(*)[S])g, 1.0, e);
        if (law->relieved)
            relieve(e, mean);
        add_law(to, e, law->region + at->region, weight);
        area += weight;
        for (int k = 0; k < M; k++)
            for (int l = 0; l < M; l++)
                moment[k][l] += weight * law->density[at->region] * phi[k][0] * phi[l][0];
    }
    add_law(to, mean, &law->mean, area);
    mirror(to->Qn, NN);
    mirror(to->Qs, NS);
}

static double mass_weight(const struct hobe_invariants *inv, int g)
{
    return inv->wx[g];
}

/* mass_vw = int moment_kl N_v N_w dx, exact for one section */
static void mass_matrix(struct hobe_invariants *inv, double moment[M][M])
{
    for (int v = 0; v < V; v++)
        for (int w = 0; w < V; w++) {
            const int i = axial_of[v], j = axial_of[w];
            double axis = overlap[i * A + j] * inv->length;
            axis *= (is_slope[i] ? inv->length : 1.0) * (is_slope[j] ? inv->length : 1.0);
            inv->mass[v * V + w] = moment[mode[v]][mode[w]] * axis;
        }
}

/* The same, one station's part of the sum. */
static void add_mass(struct hobe_invariants *inv, int g, double moment[M][M])
{
    const double *N = inv->N + V * g, weight = mass_weight(inv, g);
    for (int v = 0; v < V; v++)
        for (int w = 0; w < V; w++)
            inv->mass[v * V + w] += weight * moment[mode[v]][mode[w]] * N[v] * N[w];
}

static void invariants(struct hobe_invariants *inv, const double (*gauss)[2], int sections,
                       const struct hobe_station *station, const struct hobe_law *law,
                       const double *q0)
{
    const struct blocks first = {inv->Qn, inv->Qs, q0 ? inv->Qc : NULL};
    double moment[M][M], D0[S][3];
    for (int g = 0; g < inv->stations; g++) {
        inv->xi[g] = gauss[g][0];
        inv->wx[g] = gauss[g][1] * inv->length;
        shape(gauss[g][0], inv->length, inv->N + V * g, inv->Nx + V * g);
    }
    inv->step_n = q0 ? NN * NN : 0;
    inv->step_s = q0 ? NS * NS : 0;
    inv->step_c = q0 ? NN * NS : 0;
    if (!q0) {
        section_law(&first, station, law, NULL, moment);
        mass_matrix(inv, moment);
        return;
    }
    clear(inv->mass, V * V);
    for (int g = 0; g < inv->stations; g++) {
        const struct blocks to = {first.Qn + inv->step_n * g, first.Qs + inv->step_s * g,
                                  first.Qc + inv->step_c * g};
        vectors_at(inv->N + V * g, inv->Nx + V * g, q0, D0);
        section_law(&to, station + (sections > 1 ? g : 0), law, (const double(*)[3])D0, moment);
        add_mass(inv, g, moment);
    }
}

/* E = sym(F0' H + H' H/2) of section vectors D0 and their changes U, F0 = sum_I D0_I g_I the
 * reference gradient, H = sum_I U_I g_I = du/dX: written with F0 + H/2. */
static void green_lagrange(const double g[3][S], const double D0[S][3], const double U[S][3],
                           double *E)
{
    static const int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    double F[3][3] = {{0}}, H[3][3] = {{0}};
    for (int b = 0; b < 3; b++)
        for (int i = 0; i < S; i++)
            for (int a = 0; a < 3; a++) {
                F[b][a] += g[b][i] * (D0[i][a] + 0.5 * U[i][a]);
                H[b][a] += g[b][i] * U[i][a];
            }
    for (int i = 0; i < 6; i++) {
        const int b = voigt[i][0], c = voigt[i][1];
        E[i] = i < 3 ? product(F[b], H[b]) : product(F[b], H[c]) + product(H[b], F[c]);
    }
}

static void strain(const double *N, const double *Nx, const double (*phi)[4], const double *q0,
                   const double *u, double *E)
{
    double D0[S][3], U[S][3], g[3][S];
    vectors_at(N, Nx, q0, D0);
    vectors_at(N, Nx, u, U);
    gradient_rows(phi, (const double(*)[3])D0, g);
    green_lagrange((const double(*)[S])g, (const double(*)[3])D0, (const double(*)[3])U, E);
}

/* The strain that relieve() takes at its mean. */
static void warping_strain(const double *N, const double *Nx, const double (*phi)[4],
                           const double *q0, const double *u, double *E)
{
    double D0[S][3], U[S][3], g[3][S];
    vectors_at(N, Nx, q0, D0);
    vectors_at(N, Nx, u, U);
    gradient_rows(phi, (const double(*)[3])D0, g);
    for (int b = 0; b < 3; b++)
        for (int i = 0; i < S; i++)
            g[b][i] *= b > 0 && warps[i]; /* no gradient along x, no other modes */
    green_lagrange((const double(*)[S])g, (const double(*)[3])D0, (const double(*)[3])U, E);
}

/* D[S][3] = d_k' = sum_v N_v' q_v (I = k), and d_k = sum_v N_v q_v (I = M-1+k, k > 0) */
static void section_vectors(const double *N, const double *Nx, const hobe_real *q, hobe_real *D)
{
    for (int i = 0; i < 3 * S; i++) {
        D[i] = zero;
    }
    for (int v = 0; v < V; v++) {
        const int k = mode[v];
        for (int a = 0; a < 3; a++) {
            D[3 * k + a] += Nx[v] * q[3 * v + a];
        }
        if (k > 0) {
            for (int a = 0; a < 3; a++) {
                D[3 * (M - 1 + k) + a] += N[v] * q[3 * v + a];
            }
        }
    }
}

/* a . b */
static inline hobe_real dot(const hobe_real *a, const hobe_real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* x[V][3] = one part of a batch, positions relative to the first node's */
static void gather(const hobe_real *q, hobe_real *x)
{
    for (int v = 0; v < V; v++) {
        for (int a = 0; a < 3; a++) {
            x[3 * v + a] = q[(3 * v + a) * HOBE_PARTS];
            if (position[v]) {
                x[3 * v + a] -= q[a * HOBE_PARTS];
            }
        }
    }
}

/* K_vw += w (N_v', N_v) [C] (N_w', N_w)^T for v >= w */
static void expand(const double *N, const double *Nx, double w, const hobe_real *C, hobe_real *K)
{
    for (int v = 0; v < V; v++) {
        for (int u = 0; u < v + 1; u++) {
            const int i = mode[v];
            const int j = mode[u];
            hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(v, u);
            const double cxx = w * Nx[v] * Nx[u], cx = w * Nx[v] * N[u];
            const double xc = w * N[v] * Nx[u], cc = w * N[v] * N[u];
            for (int e = 0; e < 9; e++) {
                k[e * HOBE_PARTS] += cxx * C[9 * ((i) * S + j) + e];
            }
            if (j > 0) {
                for (int e = 0; e < 9; e++) {
                    k[e * HOBE_PARTS] += cx * C[9 * ((i) * S + M - 1 + j) + e];
                }
            }
            if (i > 0) {
                for (int e = 0; e < 9; e++) {
                    k[e * HOBE_PARTS] += xc * C[9 * ((M - 1 + i) * S + j) + e];
                }
            }
            if (i > 0 && j > 0) {
                for (int e = 0; e < 9; e++) {
                    k[e * HOBE_PARTS] += cc * C[9 * ((M - 1 + i) * S + M - 1 + j) + e];
                }
            }
        }
    }
}

/* s_IJ = B_I.C_J + C_I.B_J, s_II = B_I.C_I: with B = D0 + U/2, C = U the Gram differences
 * D_I.D_J - D0_I.D0_J without cancellation */
static void differences(const hobe_real *B, const hobe_real *C, hobe_real *n, hobe_real *s)
{
    hobe_real *values = n + NA;
    for (int i = 0; i < M; i++) {
        for (int j = 0; j < i; j++) {
            n[hobe_pair(i, j)] = dot(B + 3 * i, C + 3 * j) + dot(B + 3 * j, C + 3 * i);
        }
        n[hobe_pair(i, i)] = dot(B + 3 * i, C + 3 * i);
    }
    for (int i = M; i < S; i++) {
        for (int j = M; j < i; j++) {
            values[hobe_pair(i - M, j - M)] = dot(B + 3 * i, C + 3 * j) + dot(B + 3 * j, C + 3 * i);
        }
        values[hobe_pair(i - M, i - M)] = dot(B + 3 * i, C + 3 * i);
    }
    for (int i = 0; i < M; i++) {
        for (int j = M; j < S; j++) {
            s[i * (M - 1) + j - M] = dot(B + 3 * i, C + 3 * j) + dot(B + 3 * j, C + 3 * i);
        }
    }
}

/* sigma = Q s, the stress resultants conjugate to the Gram differences */
static void stress(const double *Qn, const double *Qs, const double *Qc, const hobe_real *n,
                   const hobe_real *s, hobe_real *tn, hobe_real *ts)
{
    for (int r = 0; r < NN; r++) {
        tn[r] = zero;
    }
    for (int c = 0; c < NN; c++) {
        for (int r = 0; r < NN; r++) {
            tn[r] += Qn[c * NN + r] * n[c];
        }
    }
    for (int r = 0; r < NS; r++) {
        ts[r] = zero;
    }
    for (int c = 0; c < NS; c++) {
        for (int r = 0; r < NS; r++) {
            ts[r] += Qs[c * NS + r] * s[c];
        }
    }
    if (Qc) {
        for (int r = 0; r < NN; r++) {
            for (int c = 0; c < NS; c++) {
                tn[r] += Qc[r * NS + c] * s[c];
                ts[c] += Qc[r * NS + c] * n[r];
            }
        }
    }
}

/* P_I = dW/dD_I = sum_J sigma_IJ D_J */
static void section_force(const hobe_real *tn, const hobe_real *ts, const hobe_real *D,
                          hobe_real *P)
{
    for (int i = 0; i < 3 * S; i++) {
        P[i] = zero;
    }
    for (int i = 0; i < M; i++) {
        for (int j = 0; j < M; j++) {
            const hobe_real t = tn[symmetric(i, j)];
            for (int a = 0; a < 3; a++) {
                P[3 * i + a] += t * D[3 * j + a];
            }
        }
        for (int j = M; j < S; j++) {
            const hobe_real t = ts[i * (M - 1) + j - M];
            for (int a = 0; a < 3; a++) {
                P[3 * i + a] += t * D[3 * j + a];
            }
        }
    }
    for (int i = M; i < S; i++) {
        for (int j = 0; j < M; j++) {
            const hobe_real t = ts[j * (M - 1) + i - M];
            for (int a = 0; a < 3; a++) {
                P[3 * i + a] += t * D[3 * j + a];
            }
        }
        for (int j = M; j < S; j++) {
            const hobe_real t = tn[NA + symmetric(i - M, j - M)];
            for (int a = 0; a < 3; a++) {
                P[3 * i + a] += t * D[3 * j + a];
            }
        }
    }
}

/* section vectors of b/2 and of c */
static void polar(const double *N, const double *Nx, const hobe_real *b, const hobe_real *c,
                  hobe_real *B, hobe_real *C)
{
    section_vectors(N, Nx, b, B);
    section_vectors(N, Nx, c, C);
    for (int i = 0; i < 3 * S; i++) {
        B[i] = 0.5 * B[i];
    }
}

/* f = T(a; b, c): sigma = Q s(b, c), the Gram entries in polar form, applied to D(a) */
static void trilinear_part(const struct hobe_invariants *inv, const hobe_real *qa,
                           const hobe_real *qb, const hobe_real *qc, hobe_real *f)
{
    hobe_real xa[3 * V];
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];
    hobe_real n[NN], s[NS], tn[NN], ts[NS];
    gather(qa, xa);
    gather(qb, x0);
    gather(qc, x);
    for (int i = 0; i < 3 * V; i++) {
        f[i * HOBE_PARTS] = zero;
    }
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g, *Qs = inv->Qs + inv->step_s * g;
        const double *Qc = inv->Qc ? inv->Qc + inv->step_c * g : NULL;
        polar(N, Nx, x0, x, B, U);
        differences(B, U, n, s);
        stress(Qn, Qs, Qc, n, s, tn, ts);
        section_vectors(N, Nx, xa, B);
        section_force(tn, ts, B, U);
        for (int v = 0; v < V; v++) {
            const int k = mode[v];
            const double cx = inv->wx[g] * Nx[v], c = inv->wx[g] * N[v];
            for (int a = 0; a < 3; a++) {
                f[(3 * v + a) * HOBE_PARTS] += cx * U[3 * k + a];
            }
            if (k > 0) {
                for (int a = 0; a < 3; a++) {
                    f[(3 * v + a) * HOBE_PARTS] += c * U[3 * (M - 1 + k) + a];
                }
            }
        }
    }
}

/* Adds to T_r = sum_L Q_r(JL) D_L what couples the normal and the shear block */
static void coupled_column(const double *Qc, int j, const hobe_real *D, hobe_real *Tn,
                           hobe_real *Ts)
{
    if (j < M) {
        for (int r = 0; r < NN; r++) {
            for (int l = M; l < S; l++) {
                for (int a = 0; a < 3; a++) {
                    Tn[3 * r + a] += Qc[(r) * NS + j * (M - 1) + l - M] * D[3 * l + a];
                }
            }
        }
        for (int r = 0; r < NS; r++) {
            for (int l = 0; l < M; l++) {
                for (int a = 0; a < 3; a++) {
                    Ts[3 * r + a] += Qc[(symmetric(j, l)) * NS + r] * D[3 * l + a];
                }
            }
        }
    }
    if (j >= M) {
        for (int r = 0; r < NN; r++) {
            for (int l = 0; l < M; l++) {
                for (int a = 0; a < 3; a++) {
                    Tn[3 * r + a] += Qc[(r) * NS + l * (M - 1) + j - M] * D[3 * l + a];
                }
            }
        }
        for (int r = 0; r < NS; r++) {
            for (int l = M; l < S; l++) {
                for (int a = 0; a < 3; a++) {
                    Ts[3 * r + a] += Qc[(NA + symmetric(j - M, l - M)) * NS + r] * D[3 * l + a];
                }
            }
        }
    }
}

/* C_IJ = d2W/dD_I dD_J = sum_K D_K T_(IK)^T + sigma_IJ 1, all S x S blocks, by columns:
 * T_r = sum_L Q_r(JL) D_L is the change of every stress resultant with D_J */
static void section_stiffness(const double *Qn, const double *Qs, const double *Qc,
                              const hobe_real *tn, const hobe_real *ts, const hobe_real *D,
                              hobe_real *C, hobe_real *T)
{
    hobe_real *Tn = T, *Ts = T + 3 * NN;
    for (int j = 0; j < S; j++) {
        if (j < M) {
            for (int r = 0; r < NN; r++) {
                hobe_real sum[3] = {zero, zero, zero};
                for (int l = 0; l < M; l++) {
                    for (int a = 0; a < 3; a++) {
                        sum[a] += Qn[r * NN + symmetric(j, l)] * D[3 * l + a];
                    }
                }
                for (int a = 0; a < 3; a++) {
                    Tn[3 * r + a] = sum[a];
                }
            }
            for (int r = 0; r < NS; r++) {
                hobe_real sum[3] = {zero, zero, zero};
                for (int l = M; l < S; l++) {
                    for (int a = 0; a < 3; a++) {
                        sum[a] += Qs[r * NS + j * (M - 1) + l - M] * D[3 * l + a];
                    }
                }
                for (int a = 0; a < 3; a++) {
                    Ts[3 * r + a] = sum[a];
                }
            }
        }
        if (j >= M) {
            for (int r = 0; r < NN; r++) {
                hobe_real sum[3] = {zero, zero, zero};
                for (int l = M; l < S; l++) {
                    for (int a = 0; a < 3; a++) {
                        sum[a] += Qn[r * NN + NA + symmetric(j - M, l - M)] * D[3 * l + a];
                    }
                }
                for (int a = 0; a < 3; a++) {
                    Tn[3 * r + a] = sum[a];
                }
            }
            for (int r = 0; r < NS; r++) {
                hobe_real sum[3] = {zero, zero, zero};
                for (int l = 0; l < M; l++) {
                    for (int a = 0; a < 3; a++) {
                        sum[a] += Qs[r * NS + l * (M - 1) + j - M] * D[3 * l + a];
                    }
                }
                for (int a = 0; a < 3; a++) {
                    Ts[3 * r + a] = sum[a];
                }
            }
        }
        if (Qc) {
            coupled_column(Qc, j, D, Tn, Ts);
        }
        for (int i = j; i < S; i++) {
            hobe_real sum[9] = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
            hobe_real t = zero;
            if (i < M) {
                t = tn[symmetric(i, j)];
                for (int l = 0; l < M; l++) {
                    const int r = symmetric(i, l);
                    for (int a = 0; a < 3; a++) {
                        for (int b = 0; b < 3; b++) {
                            sum[3 * a + b] += D[3 * l + a] * Tn[3 * r + b];
                        }
                    }
                }
                for (int l = M; l < S; l++) {
                    const int r = i * (M - 1) + l - M;
                    for (int a = 0; a < 3; a++) {
                        for (int b = 0; b < 3; b++) {
                            sum[3 * a + b] += D[3 * l + a] * Ts[3 * r + b];
                        }
                    }
                }
            }
            if (i >= M && j < M) {
                t = ts[j * (M - 1) + i - M];
            }
            if (i >= M && j >= M) {
                t = tn[NA + symmetric(i - M, j - M)];
            }
            if (i >= M) {
                for (int l = 0; l < M; l++) {
                    const int r = l * (M - 1) + i - M;
                    for (int a = 0; a < 3; a++) {
                        for (int b = 0; b < 3; b++) {
                            sum[3 * a + b] += D[3 * l + a] * Ts[3 * r + b];
                        }
                    }
                }
                for (int l = M; l < S; l++) {
                    const int r = NA + symmetric(i - M, l - M);
                    for (int a = 0; a < 3; a++) {
                        for (int b = 0; b < 3; b++) {
                            sum[3 * a + b] += D[3 * l + a] * Tn[3 * r + b];
                        }
                    }
                }
            }
            for (int a = 0; a < 3; a++) {
                sum[4 * a] += t;
            }
            for (int a = 0; a < 3; a++) {
                for (int b = 0; b < 3; b++) {
                    C[9 * (i * S + j) + 3 * a + b] = sum[3 * a + b];
                    C[9 * (j * S + i) + 3 * b + a] = sum[3 * a + b];
                }
            }
        }
    }
}

/* f = dU/dq, eq. 27, for one part of a batch */
static void force_part(const struct hobe_invariants *inv, const hobe_real *q0, const hobe_real *u,
                       hobe_real *f)
{
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];
    hobe_real n[NN], s[NS], tn[NN], ts[NS];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++) {
        f[i * HOBE_PARTS] = zero;
    }
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g, *Qs = inv->Qs + inv->step_s * g;
        const double *Qc = inv->Qc ? inv->Qc + inv->step_c * g : NULL;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        differences(B, U, n, s);
        stress(Qn, Qs, Qc, n, s, tn, ts);
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        section_force(tn, ts, B, U);
        for (int v = 0; v < V; v++) {
            const int k = mode[v];
            const double cx = inv->wx[g] * Nx[v], c = inv->wx[g] * N[v];
            for (int a = 0; a < 3; a++) {
                f[(3 * v + a) * HOBE_PARTS] += cx * U[3 * k + a];
            }
            if (k > 0) {
                for (int a = 0; a < 3; a++) {
                    f[(3 * v + a) * HOBE_PARTS] += c * U[3 * (M - 1 + k) + a];
                }
            }
        }
    }
}

/* U = sum_g w_g s.sigma/2, eq. 26 */
static void energy_part(const struct hobe_invariants *inv, const hobe_real *q0, const hobe_real *u,
                        hobe_real *energy)
{
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];
    hobe_real n[NN], s[NS], tn[NN], ts[NS];
    gather(q0, x0);
    gather(u, x);
    hobe_real sum = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g, *Qs = inv->Qs + inv->step_s * g;
        const double *Qc = inv->Qc ? inv->Qc + inv->step_c * g : NULL;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        differences(B, U, n, s);
        stress(Qn, Qs, Qc, n, s, tn, ts);
        hobe_real w = zero;
        for (int r = 0; r < NN; r++) {
            w += n[r] * tn[r];
        }
        for (int r = 0; r < NS; r++) {
            w += s[r] * ts[r];
        }
        const double half = 0.5 * inv->wx[g];
        sum += half * w;
    }
    energy[0] = sum;
}

/* f as in force_part and K = df/dq, eq. 28; C: scratch for the section stiffness */
static void tangent_part(const struct hobe_invariants *inv, const hobe_real *q0,
                         const hobe_real *u, hobe_real *f, hobe_real *K, hobe_real *C)
{
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];
    hobe_real n[NN], s[NS], tn[NN], ts[NS];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++) {
        f[i * HOBE_PARTS] = zero;
    }
    for (int i = 0; i < 9 * V * (V + 1) / 2; i++) {
        K[i * HOBE_PARTS] = zero;
    }
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g, *Qs = inv->Qs + inv->step_s * g;
        const double *Qc = inv->Qc ? inv->Qc + inv->step_c * g : NULL;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        differences(B, U, n, s);
        stress(Qn, Qs, Qc, n, s, tn, ts);
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        section_stiffness(Qn, Qs, Qc, tn, ts, B, C, C + 9 * S * S);
        expand(N, Nx, inv->wx[g], C, K);
        section_force(tn, ts, B, U);
        for (int v = 0; v < V; v++) {
            const int k = mode[v];
            const double cx = inv->wx[g] * Nx[v], c = inv->wx[g] * N[v];
            for (int a = 0; a < 3; a++) {
                f[(3 * v + a) * HOBE_PARTS] += cx * U[3 * k + a];
            }
            if (k > 0) {
                for (int a = 0; a < 3; a++) {
                    f[(3 * v + a) * HOBE_PARTS] += c * U[3 * (M - 1 + k) + a];
                }
            }
        }
    }
}

static void energy(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                   hobe_lanes *U)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        energy_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)U + h);
}

static void force(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                  hobe_lanes *f, hobe_lanes *scratch)
{
    (void)scratch;
    for (int h = 0; h < HOBE_PARTS; h++)
        force_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h);
}

static void tangent(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                    hobe_lanes *f, hobe_lanes *K, hobe_lanes *scratch)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        tangent_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h,
                     (hobe_real *)K + h, (hobe_real *)scratch);
}

static void trilinear(const struct hobe_invariants *inv, const hobe_lanes *a, const hobe_lanes *b,
                      const hobe_lanes *c, hobe_lanes *f, hobe_lanes *scratch)
{
    (void)scratch;
    for (int h = 0; h < HOBE_PARTS; h++)
        trilinear_part(inv, (const hobe_real *)a + h, (const hobe_real *)b + h,
                       (const hobe_real *)c + h, (hobe_real *)f + h);
}

static const double node[] = {
    0.0, 1.0 / 2.0, 1.0,
};
static const struct hobe_vector vector[V] = {
    {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {0, 4, 0}, {0, 5, 0}, {0, 6, 0},
    {0, 7, 0}, {0, 8, 0}, {0, 9, 0}, {0, 10, 0}, {0, 11, 0}, {0, 12, 0}, {0, 13, 0}, {0, 14, 0},
    {0, 15, 0}, {0, 16, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}, {1, 4, 0}, {1, 5, 0}, {1, 6, 0},
    {1, 7, 0}, {1, 8, 0}, {1, 9, 0}, {1, 10, 0}, {1, 11, 0}, {1, 12, 0}, {1, 13, 0}, {1, 14, 0},
    {1, 15, 0}, {1, 16, 0}, {2, 0, 0}, {2, 0, 1}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0}, {2, 4, 0},
    {2, 5, 0}, {2, 6, 0}, {2, 7, 0}, {2, 8, 0}, {2, 9, 0}, {2, 10, 0}, {2, 11, 0}, {2, 12, 0},
    {2, 13, 0}, {2, 14, 0}, {2, 15, 0}, {2, 16, 0},
};
static const char *const mode_name[M] = {
    "1", "y", "z", "w", "wy", "wz", "ww", "w1", "v1y", "v1z", "v2y", "v2z", "w2", "w2t", "v3y",
    "v3z", "w3",
};
static const char *const function_name[] = {
    "w", "wy", "wz", "ww", "w1", "v1y", "v1z", "v2y", "v2z", "w2", "w2t", "v3y", "v3z", "w3",
};

extern const struct hobe_kernel HOBE_KERNEL(MGD30d2);
const struct hobe_kernel HOBE_KERNEL(MGD30d2) = {
    .abi = 4,
    .name = "MGD30d2",
    .hash = "306ca0460513a409",
    .source = "this project: MGD30d whose section distorts far, to the second order",
    .mechanics = "average",
    .nodes = 3,
    .vectors = V,
    .modes = M,
    .functions = 14,
    .stations = 5,
    .degree = 1,
    .normals = NN,
    .shears = NS,
    .flops_force = 1648577,
    .flops_tangent = 12946172,
    .scratch = 5742,
    .node = node,
    .axis_rule = NULL,
    .vector = vector,
    .mode = mode_name,
    .function = function_name,
    .shape = shape,
    .section_modes = section_modes,
    .invariants = invariants,
    .energy = energy,
    .force = force,
    .tangent = tangent,
    .trilinear = trilinear,
    .strain = strain,
    .warping_strain = warping_strain,
};
