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
 * operations per element: force 1648577, force and tangent 15676239, energy 1617537
 * from station to station, symmetric in nothing: force 3220737, force and tangent 30859279
 * from station to station, symmetric in x: force 1648577, force and tangent 15676239
 * from station to station, symmetric in y: force 1649337, force and tangent 15679879
 * from station to station, symmetric in x y: force 862877, force and tangent 8086539
 * from station to station, symmetric in z: force 1649337, force and tangent 15679879
 * from station to station, symmetric in x z: force 862877, force and tangent 8086539
 * from station to station, symmetric in y z: force 866737, force and tangent 8111279
 * from station to station, symmetric in x y z: force 471577, force and tangent 4302239
 * as one tensor, symmetric in x: force 1809919, force and tangent 17431561
 * as one tensor, symmetric in x y: force 922159, force and tangent 8768773
 * as one tensor, symmetric in x z: force 922159, force and tangent 8768773
 * as one tensor, symmetric in x y z: force 479279, force and tangent 4444013
 */
#include "kernel.h"

#if HOBE_KERNEL_ABI != 7
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

static inline int larger(int i, int j)
{
    return i > j ? i : j;
}

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

/* Rows and columns of products (generator/products.py). */
struct products {
    int columns, pairs;         /* vectors, and pairs t >= v of those */
    const short *mirror;        /* of each vector of a row, its mirror image */
    const short *pair_t, *pair_v; /* first those with t = v, then by class of parities */
    const short *first_pair, *first_cross; /* of each class; without those with t = v */
    const short *row, *first_row;          /* rows of Q and of the symmetric part, by class */
    const short *skew_row, *first_skew_row;
};

/* ---- eqs. 27 and 28 as products with constant matrices (generator/products.py) ---- */

enum {
    COLUMNS = 51,      /* sums and differences of nodal vectors */
    PAIRS = 1326,      /* of those */
    BLOCKS = 1378,     /* of the tangent, pairs of nodal vectors: a row each */
    IMAGES = 578,      /* pairs of rows that are mirror images */
    ALONE = 170,       /* rows that are their own */
    CLASSES = 8,       /* of parities: 1 odd in x, 2 odd in y, 4 odd in z */
    LAST = 34,         /* the last position */
    OPPOSED = 1,       /* whether it is one of two: rows with the first are less those with it */
    MIRRORED = 1,      /* whether there are mirror images */
    GRAMS = 561,       /* pairs of section vectors */
    AXIAL = 392,       /* weights of a station for axial functions */
    MOST_PAIRS = 1326, /* of either kind */
};

/* of each section vector: 1 odd in x, 2 odd in y, 4 odd in z */
static const unsigned char parity[] = {
    0, 2, 4, 6, 2, 4, 6, 6, 4, 2, 2, 4, 0, 6, 2, 4, 0, 3, 5, 7, 3, 5, 7, 7, 5, 3, 3, 5, 1, 7, 3,
    5, 1,
};
/* of each nodal vector: whether its image has the other sign */
static const unsigned char odd_of[] = {
    0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
};
/* of each column: q_left + sign q_right, less the last position where shifted; its
 * function is share (N_left + sign N_right) */
static const short left[] = {
    0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13, 14,
    14, 15, 15, 16, 16, 17, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33,
};
static const short right[] = {
    34, 35, 35, 36, 36, 37, 37, 38, 38, 39, 39, 40, 40, 41, 41, 42, 42, 43, 43, 44, 44, 45, 45,
    46, 46, 47, 47, 48, 48, 49, 49, 50, 50, 51, 51, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
    29, 30, 31, 32, 33,
};
static const short shifted[] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
};
static const double sign[] = {
    -1, -1, 1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1,
    -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
};
static const double share[] = {
    1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0,
    1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0,
    1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0,
    1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0,
    1.0 / 2.0, 1.0 / 2.0, 1.0 / 2.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0,
    1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0,
    1.0 / 4.0, 1.0 / 4.0, 1.0 / 4.0,
};
/* vectors of the rows that have a mirror image after them, and of those alone */
static const short lead[] = {
    1, 1, 34, 1, 2, 1, 18, 1, 34, 2, 35, 2, 3, 1, 19, 1, 34, 3, 35, 3, 4, 1, 20, 1, 34, 4, 35,
    4, 5, 1, 21, 1, 34, 5, 35, 5, 6, 1, 22, 1, 34, 6, 35, 6, 7, 1, 23, 1, 34, 7, 35, 7, 8, 1,
    24, 1, 34, 8, 35, 8, 9, 1, 25, 1, 34, 9, 35, 9, 10, 1, 26, 1, 34, 10, 35, 10, 11, 1, 27, 1,
    34, 11, 35, 11, 12, 1, 28, 1, 34, 12, 35, 12, 13, 1, 29, 1, 34, 13, 35, 13, 14, 1, 30, 1,
    34, 14, 35, 14, 15, 1, 31, 1, 34, 15, 35, 15, 16, 1, 32, 1, 34, 16, 35, 16, 17, 1, 33, 1,
    34, 17, 35, 17, 2, 2, 18, 2, 3, 2, 18, 3, 19, 2, 36, 3, 4, 2, 18, 4, 20, 2, 36, 4, 5, 2, 18,
    5, 21, 2, 36, 5, 6, 2, 18, 6, 22, 2, 36, 6, 7, 2, 18, 7, 23, 2, 36, 7, 8, 2, 18, 8, 24, 2,
    36, 8, 9, 2, 18, 9, 25, 2, 36, 9, 10, 2, 18, 10, 26, 2, 36, 10, 11, 2, 18, 11, 27, 2, 36,
    11, 12, 2, 18, 12, 28, 2, 36, 12, 13, 2, 18, 13, 29, 2, 36, 13, 14, 2, 18, 14, 30, 2, 36,
    14, 15, 2, 18, 15, 31, 2, 36, 15, 16, 2, 18, 16, 32, 2, 36, 16, 17, 2, 18, 17, 33, 2, 36,
    17, 3, 3, 19, 3, 4, 3, 19, 4, 20, 3, 37, 4, 5, 3, 19, 5, 21, 3, 37, 5, 6, 3, 19, 6, 22, 3,
    37, 6, 7, 3, 19, 7, 23, 3, 37, 7, 8, 3, 19, 8, 24, 3, 37, 8, 9, 3, 19, 9, 25, 3, 37, 9, 10,
    3, 19, 10, 26, 3, 37, 10, 11, 3, 19, 11, 27, 3, 37, 11, 12, 3, 19, 12, 28, 3, 37, 12, 13, 3,
    19, 13, 29, 3, 37, 13, 14, 3, 19, 14, 30, 3, 37, 14, 15, 3, 19, 15, 31, 3, 37, 15, 16, 3,
    19, 16, 32, 3, 37, 16, 17, 3, 19, 17, 33, 3, 37, 17, 4, 4, 20, 4, 5, 4, 20, 5, 21, 4, 38, 5,
    6, 4, 20, 6, 22, 4, 38, 6, 7, 4, 20, 7, 23, 4, 38, 7, 8, 4, 20, 8, 24, 4, 38, 8, 9, 4, 20,
    9, 25, 4, 38, 9, 10, 4, 20, 10, 26, 4, 38, 10, 11, 4, 20, 11, 27, 4, 38, 11, 12, 4, 20, 12,
    28, 4, 38, 12, 13, 4, 20, 13, 29, 4, 38, 13, 14, 4, 20, 14, 30, 4, 38, 14, 15, 4, 20, 15,
    31, 4, 38, 15, 16, 4, 20, 16, 32, 4, 38, 16, 17, 4, 20, 17, 33, 4, 38, 17, 5, 5, 21, 5, 6,
    5, 21, 6, 22, 5, 39, 6, 7, 5, 21, 7, 23, 5, 39, 7, 8, 5, 21, 8, 24, 5, 39, 8, 9, 5, 21, 9,
    25, 5, 39, 9, 10, 5, 21, 10, 26, 5, 39, 10, 11, 5, 21, 11, 27, 5, 39, 11, 12, 5, 21, 12, 28,
    5, 39, 12, 13, 5, 21, 13, 29, 5, 39, 13, 14, 5, 21, 14, 30, 5, 39, 14, 15, 5, 21, 15, 31, 5,
    39, 15, 16, 5, 21, 16, 32, 5, 39, 16, 17, 5, 21, 17, 33, 5, 39, 17, 6, 6, 22, 6, 7, 6, 22,
    7, 23, 6, 40, 7, 8, 6, 22, 8, 24, 6, 40, 8, 9, 6, 22, 9, 25, 6, 40, 9, 10, 6, 22, 10, 26, 6,
    40, 10, 11, 6, 22, 11, 27, 6, 40, 11, 12, 6, 22, 12, 28, 6, 40, 12, 13, 6, 22, 13, 29, 6,
    40, 13, 14, 6, 22, 14, 30, 6, 40, 14, 15, 6, 22, 15, 31, 6, 40, 15, 16, 6, 22, 16, 32, 6,
    40, 16, 17, 6, 22, 17, 33, 6, 40, 17, 7, 7, 23, 7, 8, 7, 23, 8, 24, 7, 41, 8, 9, 7, 23, 9,
    25, 7, 41, 9, 10, 7, 23, 10, 26, 7, 41, 10, 11, 7, 23, 11, 27, 7, 41, 11, 12, 7, 23, 12, 28,
    7, 41, 12, 13, 7, 23, 13, 29, 7, 41, 13, 14, 7, 23, 14, 30, 7, 41, 14, 15, 7, 23, 15, 31, 7,
    41, 15, 16, 7, 23, 16, 32, 7, 41, 16, 17, 7, 23, 17, 33, 7, 41, 17, 8, 8, 24, 8, 9, 8, 24,
    9, 25, 8, 42, 9, 10, 8, 24, 10, 26, 8, 42, 10, 11, 8, 24, 11, 27, 8, 42, 11, 12, 8, 24, 12,
    28, 8, 42, 12, 13, 8, 24, 13, 29, 8, 42, 13, 14, 8, 24, 14, 30, 8, 42, 14, 15, 8, 24, 15,
    31, 8, 42, 15, 16, 8, 24, 16, 32, 8, 42, 16, 17, 8, 24, 17, 33, 8, 42, 17, 9, 9, 25, 9, 10,
    9, 25, 10, 26, 9, 43, 10, 11, 9, 25, 11, 27, 9, 43, 11, 12, 9, 25, 12, 28, 9, 43, 12, 13, 9,
    25, 13, 29, 9, 43, 13, 14, 9, 25, 14, 30, 9, 43, 14, 15, 9, 25, 15, 31, 9, 43, 15, 16, 9,
    25, 16, 32, 9, 43, 16, 17, 9, 25, 17, 33, 9, 43, 17, 10, 10, 26, 10, 11, 10, 26, 11, 27, 10,
    44, 11, 12, 10, 26, 12, 28, 10, 44, 12, 13, 10, 26, 13, 29, 10, 44, 13, 14, 10, 26, 14, 30,
    10, 44, 14, 15, 10, 26, 15, 31, 10, 44, 15, 16, 10, 26, 16, 32, 10, 44, 16, 17, 10, 26, 17,
    33, 10, 44, 17, 11, 11, 27, 11, 12, 11, 27, 12, 28, 11, 45, 12, 13, 11, 27, 13, 29, 11, 45,
    13, 14, 11, 27, 14, 30, 11, 45, 14, 15, 11, 27, 15, 31, 11, 45, 15, 16, 11, 27, 16, 32, 11,
    45, 16, 17, 11, 27, 17, 33, 11, 45, 17, 12, 12, 28, 12, 13, 12, 28, 13, 29, 12, 46, 13, 14,
    12, 28, 14, 30, 12, 46, 14, 15, 12, 28, 15, 31, 12, 46, 15, 16, 12, 28, 16, 32, 12, 46, 16,
    17, 12, 28, 17, 33, 12, 46, 17, 13, 13, 29, 13, 14, 13, 29, 14, 30, 13, 47, 14, 15, 13, 29,
    15, 31, 13, 47, 15, 16, 13, 29, 16, 32, 13, 47, 16, 17, 13, 29, 17, 33, 13, 47, 17, 14, 14,
    30, 14, 15, 14, 30, 15, 31, 14, 48, 15, 16, 14, 30, 16, 32, 14, 48, 16, 17, 14, 30, 17, 33,
    14, 48, 17, 15, 15, 31, 15, 16, 15, 31, 16, 32, 15, 49, 16, 17, 15, 31, 17, 33, 15, 49, 17,
    16, 16, 32, 16, 17, 16, 32, 17, 33, 16, 50, 17, 17, 17, 33, 17, 34, 34, 35, 1, 34, 18, 34,
    19, 34, 20, 34, 21, 34, 22, 34, 23, 34, 24, 34, 25, 34, 26, 34, 27, 34, 28, 34, 29, 34, 30,
    34, 31, 34, 32, 34, 33, 18, 18, 36, 2, 19, 18, 20, 18, 21, 18, 22, 18, 23, 18, 24, 18, 25,
    18, 26, 18, 27, 18, 28, 18, 29, 18, 30, 18, 31, 18, 32, 18, 33, 18, 19, 19, 37, 3, 20, 19,
    21, 19, 22, 19, 23, 19, 24, 19, 25, 19, 26, 19, 27, 19, 28, 19, 29, 19, 30, 19, 31, 19, 32,
    19, 33, 19, 20, 20, 38, 4, 21, 20, 22, 20, 23, 20, 24, 20, 25, 20, 26, 20, 27, 20, 28, 20,
    29, 20, 30, 20, 31, 20, 32, 20, 33, 20, 21, 21, 39, 5, 22, 21, 23, 21, 24, 21, 25, 21, 26,
    21, 27, 21, 28, 21, 29, 21, 30, 21, 31, 21, 32, 21, 33, 21, 22, 22, 40, 6, 23, 22, 24, 22,
    25, 22, 26, 22, 27, 22, 28, 22, 29, 22, 30, 22, 31, 22, 32, 22, 33, 22, 23, 23, 41, 7, 24,
    23, 25, 23, 26, 23, 27, 23, 28, 23, 29, 23, 30, 23, 31, 23, 32, 23, 33, 23, 24, 24, 42, 8,
    25, 24, 26, 24, 27, 24, 28, 24, 29, 24, 30, 24, 31, 24, 32, 24, 33, 24, 25, 25, 43, 9, 26,
    25, 27, 25, 28, 25, 29, 25, 30, 25, 31, 25, 32, 25, 33, 25, 26, 26, 44, 10, 27, 26, 28, 26,
    29, 26, 30, 26, 31, 26, 32, 26, 33, 26, 27, 27, 45, 11, 28, 27, 29, 27, 30, 27, 31, 27, 32,
    27, 33, 27, 28, 28, 46, 12, 29, 28, 30, 28, 31, 28, 32, 28, 33, 28, 29, 29, 47, 13, 30, 29,
    31, 29, 32, 29, 33, 29, 30, 30, 48, 14, 31, 30, 32, 30, 33, 30, 31, 31, 49, 15, 32, 31, 33,
    31, 32, 32, 50, 16, 33, 32, 33, 33, 51, 17,
};
/* by symmetry: how many classes a row meets, and its own class times which */
static const short merged[] = {
    8, 4, 4, 2, 4, 2, 2, 1,
};
static const short merged_with[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 4, 6, 0, 0, 0, 0, 0, 1, 4, 5, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0,
    0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0,
};
/* products of nodal vectors */
static const short nodal_mirror[] = {
    34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 18, 19, 20, 21, 22,
    23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
    14, 15, 16, 17,
};
static const short nodal_pair_t[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47,
    48, 49, 50, 2, 9, 10, 11, 12, 13, 14, 15, 15, 16, 16, 17, 17, 18, 18, 19, 19, 20, 20, 21,
    21, 21, 22, 22, 22, 23, 23, 23, 24, 24, 24, 25, 26, 26, 27, 27, 27, 28, 28, 28, 29, 29, 29,
    29, 30, 30, 30, 30, 31, 31, 31, 31, 32, 32, 32, 32, 33, 33, 34, 34, 34, 35, 35, 35, 35, 35,
    36, 36, 36, 36, 36, 37, 37, 37, 37, 38, 38, 38, 38, 38, 38, 39, 39, 39, 39, 39, 39, 40, 40,
    40, 40, 40, 41, 41, 41, 41, 41, 41, 42, 42, 42, 42, 42, 42, 42, 43, 43, 43, 43, 43, 43, 43,
    44, 44, 44, 44, 44, 44, 44, 44, 45, 45, 45, 45, 45, 45, 45, 45, 46, 46, 46, 47, 47, 47, 47,
    47, 47, 47, 48, 48, 48, 48, 48, 48, 48, 48, 48, 49, 49, 49, 49, 49, 49, 49, 49, 49, 50, 50,
    50, 50, 1, 2, 4, 6, 8, 9, 10, 10, 11, 12, 12, 13, 14, 14, 15, 15, 16, 16, 16, 17, 17, 18,
    18, 18, 19, 19, 20, 20, 20, 21, 21, 21, 22, 22, 22, 22, 23, 23, 23, 24, 24, 24, 24, 25, 25,
    26, 26, 27, 27, 27, 28, 28, 28, 28, 29, 29, 29, 29, 30, 30, 30, 30, 30, 31, 31, 31, 31, 32,
    32, 32, 32, 32, 33, 33, 33, 34, 34, 34, 35, 35, 35, 35, 35, 36, 36, 36, 36, 36, 37, 37, 37,
    37, 38, 38, 38, 38, 38, 39, 39, 39, 39, 39, 40, 40, 40, 40, 41, 41, 41, 41, 42, 42, 42, 42,
    42, 43, 43, 43, 43, 43, 44, 44, 44, 44, 44, 45, 45, 45, 45, 45, 46, 46, 46, 46, 47, 47, 47,
    47, 48, 48, 48, 48, 48, 49, 49, 49, 49, 49, 50, 50, 50, 50, 3, 4, 4, 7, 8, 9, 10, 10, 11,
    12, 13, 13, 14, 14, 15, 15, 16, 16, 17, 17, 17, 18, 18, 18, 19, 20, 20, 21, 22, 22, 23, 23,
    23, 24, 24, 24, 25, 25, 25, 25, 26, 26, 26, 26, 27, 27, 27, 27, 28, 28, 28, 28, 29, 29, 30,
    30, 30, 31, 31, 31, 31, 32, 32, 32, 32, 33, 33, 33, 33, 33, 34, 34, 34, 34, 34, 35, 35, 35,
    36, 36, 36, 36, 37, 37, 37, 37, 37, 37, 38, 38, 38, 39, 39, 39, 39, 39, 40, 40, 40, 40, 40,
    40, 40, 41, 41, 41, 41, 41, 41, 41, 42, 42, 42, 42, 42, 42, 42, 43, 43, 43, 44, 44, 44, 45,
    45, 45, 45, 45, 45, 45, 46, 46, 46, 46, 46, 46, 46, 46, 46, 47, 47, 47, 47, 47, 47, 47, 47,
    47, 48, 48, 48, 48, 49, 49, 49, 49, 49, 49, 49, 49, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50,
    3, 3, 4, 7, 8, 9, 9, 10, 11, 12, 13, 13, 14, 14, 15, 15, 16, 16, 17, 17, 17, 18, 18, 18, 19,
    19, 20, 21, 21, 22, 23, 23, 23, 24, 24, 24, 25, 25, 25, 25, 26, 26, 26, 26, 27, 27, 27, 27,
    28, 28, 28, 28, 29, 29, 29, 30, 30, 31, 31, 31, 31, 32, 32, 32, 32, 33, 33, 33, 33, 33, 34,
    34, 34, 34, 34, 35, 35, 35, 35, 36, 36, 36, 36, 37, 37, 37, 37, 37, 38, 38, 38, 38, 39, 39,
    39, 39, 40, 40, 40, 40, 40, 41, 41, 41, 41, 41, 42, 42, 42, 42, 43, 43, 43, 43, 44, 44, 44,
    44, 45, 45, 45, 45, 46, 46, 46, 46, 46, 47, 47, 47, 47, 47, 48, 48, 48, 48, 49, 49, 49, 49,
    50, 50, 50, 50, 50, 5, 6, 6, 7, 8, 9, 10, 11, 12, 12, 13, 13, 14, 14, 15, 15, 16, 16, 17,
    18, 18, 19, 19, 19, 20, 20, 20, 21, 21, 21, 22, 22, 22, 23, 24, 24, 25, 25, 25, 25, 26, 26,
    26, 26, 27, 27, 27, 27, 28, 28, 28, 28, 29, 29, 29, 29, 30, 30, 30, 30, 31, 31, 32, 32, 32,
    33, 33, 33, 33, 33, 34, 34, 34, 34, 34, 35, 35, 35, 35, 36, 36, 36, 37, 37, 37, 37, 37, 37,
    38, 38, 38, 38, 38, 39, 39, 39, 40, 40, 40, 40, 40, 40, 40, 41, 41, 41, 41, 41, 41, 41, 42,
    42, 42, 43, 43, 43, 43, 43, 43, 43, 44, 44, 44, 44, 44, 44, 44, 45, 45, 45, 46, 46, 46, 46,
    46, 46, 46, 46, 46, 47, 47, 47, 47, 47, 47, 47, 47, 47, 48, 48, 48, 48, 48, 48, 48, 48, 49,
    49, 49, 49, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 5, 5, 6, 7, 8, 9, 10, 11, 11, 12, 13,
    13, 14, 14, 15, 15, 16, 16, 17, 17, 18, 19, 19, 19, 20, 20, 20, 21, 21, 21, 22, 22, 22, 23,
    23, 24, 25, 25, 25, 25, 26, 26, 26, 26, 27, 27, 27, 27, 28, 28, 28, 28, 29, 29, 29, 29, 30,
    30, 30, 30, 31, 31, 31, 32, 32, 33, 33, 33, 33, 33, 34, 34, 34, 34, 34, 35, 35, 35, 35, 36,
    36, 36, 36, 37, 37, 37, 37, 37, 38, 38, 38, 38, 39, 39, 39, 39, 40, 40, 40, 40, 40, 41, 41,
    41, 41, 41, 42, 42, 42, 42, 43, 43, 43, 43, 44, 44, 44, 44, 45, 45, 45, 45, 46, 46, 46, 46,
    46, 47, 47, 47, 47, 47, 48, 48, 48, 48, 49, 49, 49, 49, 50, 50, 50, 50, 50, 5, 6, 7, 8, 8,
    9, 10, 11, 11, 12, 12, 13, 14, 14, 15, 16, 16, 17, 17, 18, 18, 19, 19, 19, 20, 20, 20, 21,
    21, 21, 22, 22, 22, 23, 23, 23, 23, 24, 24, 24, 24, 25, 25, 25, 26, 26, 26, 27, 27, 28, 28,
    28, 29, 29, 29, 29, 30, 30, 30, 30, 31, 31, 31, 31, 31, 32, 32, 32, 32, 32, 33, 33, 33, 33,
    34, 34, 34, 34, 35, 35, 35, 35, 35, 36, 36, 36, 36, 36, 36, 37, 37, 37, 38, 38, 38, 38, 38,
    38, 39, 39, 39, 39, 39, 39, 39, 40, 40, 40, 41, 41, 41, 42, 42, 42, 42, 42, 42, 42, 43, 43,
    43, 43, 43, 43, 43, 43, 44, 44, 44, 44, 44, 44, 44, 44, 45, 45, 45, 45, 45, 45, 45, 45, 45,
    46, 46, 46, 46, 46, 46, 46, 47, 47, 47, 47, 48, 48, 48, 48, 48, 48, 48, 48, 48, 49, 49, 49,
    49, 49, 49, 49, 49, 49, 49, 50, 50, 50, 50, 50, 50, 50, 50, 5, 6, 7, 7, 8, 9, 10, 11, 11,
    12, 12, 13, 13, 14, 15, 15, 16, 17, 17, 18, 18, 19, 19, 19, 20, 20, 20, 21, 21, 21, 22, 22,
    22, 23, 23, 23, 23, 24, 24, 24, 24, 25, 25, 25, 26, 26, 26, 27, 27, 27, 28, 28, 29, 29, 29,
    29, 30, 30, 30, 30, 31, 31, 31, 31, 31, 32, 32, 32, 32, 32, 33, 33, 33, 33, 34, 34, 34, 34,
    35, 35, 35, 35, 35, 36, 36, 36, 36, 36, 37, 37, 37, 37, 38, 38, 38, 38, 38, 39, 39, 39, 39,
    39, 40, 40, 40, 40, 41, 41, 41, 41, 42, 42, 42, 42, 42, 43, 43, 43, 43, 43, 44, 44, 44, 44,
    44, 45, 45, 45, 45, 45, 46, 46, 46, 46, 47, 47, 47, 47, 48, 48, 48, 48, 48, 49, 49, 49, 49,
    49, 50, 50, 50, 50,
};
static const short nodal_pair_v[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47,
    48, 49, 50, 0, 3, 4, 5, 6, 7, 8, 7, 13, 8, 14, 5, 11, 6, 12, 3, 9, 4, 10, 3, 9, 19, 4, 10,
    20, 5, 11, 17, 6, 12, 18, 1, 0, 2, 7, 13, 15, 8, 14, 16, 3, 9, 19, 21, 4, 10, 20, 22, 5, 11,
    17, 23, 6, 12, 18, 24, 1, 25, 0, 2, 26, 3, 9, 19, 21, 29, 5, 11, 17, 23, 31, 7, 13, 15, 27,
    3, 9, 19, 21, 29, 35, 5, 11, 17, 23, 31, 36, 7, 13, 15, 27, 37, 7, 13, 15, 27, 37, 40, 5,
    11, 17, 23, 31, 36, 39, 3, 9, 19, 21, 29, 35, 38, 3, 9, 19, 21, 29, 35, 38, 43, 5, 11, 17,
    23, 31, 36, 39, 42, 1, 25, 33, 7, 13, 15, 27, 37, 40, 41, 3, 9, 19, 21, 29, 35, 38, 43, 44,
    5, 11, 17, 23, 31, 36, 39, 42, 45, 1, 25, 33, 46, 0, 1, 3, 5, 7, 4, 3, 9, 6, 5, 11, 8, 7,
    13, 8, 14, 7, 13, 15, 6, 12, 5, 11, 17, 4, 10, 3, 9, 19, 4, 10, 20, 3, 9, 19, 21, 6, 12, 18,
    5, 11, 17, 23, 0, 2, 1, 25, 8, 14, 16, 7, 13, 15, 27, 4, 10, 20, 22, 3, 9, 19, 21, 29, 6,
    12, 18, 24, 5, 11, 17, 23, 31, 0, 2, 26, 1, 25, 33, 4, 10, 20, 22, 30, 6, 12, 18, 24, 32, 8,
    14, 16, 28, 4, 10, 20, 22, 30, 6, 12, 18, 24, 32, 8, 14, 16, 28, 8, 14, 16, 28, 6, 12, 18,
    24, 32, 4, 10, 20, 22, 30, 4, 10, 20, 22, 30, 6, 12, 18, 24, 32, 0, 2, 26, 34, 8, 14, 16,
    28, 4, 10, 20, 22, 30, 6, 12, 18, 24, 32, 0, 2, 26, 34, 1, 0, 2, 5, 6, 1, 0, 2, 7, 8, 5, 11,
    6, 12, 5, 11, 6, 12, 7, 13, 15, 8, 14, 16, 1, 0, 2, 1, 0, 2, 7, 13, 15, 8, 14, 16, 3, 9, 19,
    21, 4, 10, 20, 22, 5, 11, 17, 23, 6, 12, 18, 24, 1, 25, 0, 2, 26, 7, 13, 15, 27, 8, 14, 16,
    28, 3, 9, 19, 21, 29, 4, 10, 20, 22, 30, 1, 25, 33, 7, 13, 15, 27, 5, 11, 17, 23, 31, 36, 1,
    25, 33, 7, 13, 15, 27, 37, 5, 11, 17, 23, 31, 36, 39, 5, 11, 17, 23, 31, 36, 39, 7, 13, 15,
    27, 37, 40, 41, 1, 25, 33, 1, 25, 33, 7, 13, 15, 27, 37, 40, 41, 3, 9, 19, 21, 29, 35, 38,
    43, 44, 5, 11, 17, 23, 31, 36, 39, 42, 45, 1, 25, 33, 46, 7, 13, 15, 27, 37, 40, 41, 47, 3,
    9, 19, 21, 29, 35, 38, 43, 44, 48, 0, 2, 1, 6, 5, 0, 2, 1, 8, 7, 6, 12, 5, 11, 6, 12, 5, 11,
    8, 14, 16, 7, 13, 15, 0, 2, 1, 0, 2, 1, 8, 14, 16, 7, 13, 15, 4, 10, 20, 22, 3, 9, 19, 21,
    6, 12, 18, 24, 5, 11, 17, 23, 0, 2, 26, 1, 25, 8, 14, 16, 28, 7, 13, 15, 27, 4, 10, 20, 22,
    30, 3, 9, 19, 21, 29, 0, 2, 26, 34, 8, 14, 16, 28, 6, 12, 18, 24, 32, 0, 2, 26, 34, 8, 14,
    16, 28, 6, 12, 18, 24, 32, 6, 12, 18, 24, 32, 8, 14, 16, 28, 0, 2, 26, 34, 0, 2, 26, 34, 8,
    14, 16, 28, 4, 10, 20, 22, 30, 6, 12, 18, 24, 32, 0, 2, 26, 34, 8, 14, 16, 28, 4, 10, 20,
    22, 30, 1, 0, 2, 3, 4, 7, 8, 1, 0, 2, 3, 9, 4, 10, 3, 9, 4, 10, 1, 0, 2, 7, 13, 15, 8, 14,
    16, 7, 13, 15, 8, 14, 16, 1, 0, 2, 5, 11, 17, 23, 6, 12, 18, 24, 3, 9, 19, 21, 4, 10, 20,
    22, 7, 13, 15, 27, 8, 14, 16, 28, 1, 25, 0, 2, 26, 5, 11, 17, 23, 31, 6, 12, 18, 24, 32, 7,
    13, 15, 27, 1, 25, 33, 3, 9, 19, 21, 29, 35, 7, 13, 15, 27, 37, 1, 25, 33, 3, 9, 19, 21, 29,
    35, 38, 3, 9, 19, 21, 29, 35, 38, 1, 25, 33, 7, 13, 15, 27, 37, 40, 41, 7, 13, 15, 27, 37,
    40, 41, 1, 25, 33, 5, 11, 17, 23, 31, 36, 39, 42, 45, 3, 9, 19, 21, 29, 35, 38, 43, 44, 7,
    13, 15, 27, 37, 40, 41, 47, 1, 25, 33, 46, 5, 11, 17, 23, 31, 36, 39, 42, 45, 49, 0, 2, 1,
    4, 3, 8, 7, 0, 2, 1, 4, 10, 3, 9, 4, 10, 3, 9, 0, 2, 1, 8, 14, 16, 7, 13, 15, 8, 14, 16, 7,
    13, 15, 0, 2, 1, 6, 12, 18, 24, 5, 11, 17, 23, 4, 10, 20, 22, 3, 9, 19, 21, 8, 14, 16, 28,
    7, 13, 15, 27, 0, 2, 26, 1, 25, 6, 12, 18, 24, 32, 5, 11, 17, 23, 31, 8, 14, 16, 28, 0, 2,
    26, 34, 4, 10, 20, 22, 30, 8, 14, 16, 28, 0, 2, 26, 34, 4, 10, 20, 22, 30, 4, 10, 20, 22,
    30, 0, 2, 26, 34, 8, 14, 16, 28, 8, 14, 16, 28, 0, 2, 26, 34, 6, 12, 18, 24, 32, 4, 10, 20,
    22, 30, 8, 14, 16, 28, 0, 2, 26, 34, 6, 12, 18, 24, 32, 3, 4, 1, 0, 2, 5, 6, 3, 9, 4, 10, 1,
    0, 2, 1, 0, 2, 3, 9, 4, 10, 5, 11, 17, 6, 12, 18, 5, 11, 17, 6, 12, 18, 3, 9, 19, 21, 4, 10,
    20, 22, 7, 13, 15, 8, 14, 16, 1, 25, 0, 2, 26, 5, 11, 17, 23, 6, 12, 18, 24, 3, 9, 19, 21,
    29, 4, 10, 20, 22, 30, 7, 13, 15, 27, 8, 14, 16, 28, 5, 11, 17, 23, 31, 3, 9, 19, 21, 29,
    35, 1, 25, 33, 5, 11, 17, 23, 31, 36, 3, 9, 19, 21, 29, 35, 38, 1, 25, 33, 1, 25, 33, 3, 9,
    19, 21, 29, 35, 38, 5, 11, 17, 23, 31, 36, 39, 42, 5, 11, 17, 23, 31, 36, 39, 42, 3, 9, 19,
    21, 29, 35, 38, 43, 44, 7, 13, 15, 27, 37, 40, 41, 1, 25, 33, 46, 5, 11, 17, 23, 31, 36, 39,
    42, 45, 3, 9, 19, 21, 29, 35, 38, 43, 44, 48, 7, 13, 15, 27, 37, 40, 41, 47, 4, 3, 0, 2, 1,
    6, 5, 4, 10, 3, 9, 0, 2, 1, 0, 2, 1, 4, 10, 3, 9, 6, 12, 18, 5, 11, 17, 6, 12, 18, 5, 11,
    17, 4, 10, 20, 22, 3, 9, 19, 21, 8, 14, 16, 7, 13, 15, 0, 2, 26, 1, 25, 6, 12, 18, 24, 5,
    11, 17, 23, 4, 10, 20, 22, 30, 3, 9, 19, 21, 29, 8, 14, 16, 28, 7, 13, 15, 27, 6, 12, 18,
    24, 32, 4, 10, 20, 22, 30, 0, 2, 26, 34, 6, 12, 18, 24, 32, 4, 10, 20, 22, 30, 0, 2, 26, 34,
    0, 2, 26, 34, 4, 10, 20, 22, 30, 6, 12, 18, 24, 32, 6, 12, 18, 24, 32, 4, 10, 20, 22, 30, 8,
    14, 16, 28, 0, 2, 26, 34, 6, 12, 18, 24, 32, 4, 10, 20, 22, 30, 8, 14, 16, 28,
};
static const short nodal_first_pair[] = {
    0, 211, 363, 533, 678, 848, 993, 1174, 1326,
};
static const short nodal_first_cross[] = {
    51, 211, 363, 533, 678, 848, 993, 1174, 1326,
};
static const short nodal_row[] = {
    2, 5, 9, 14, 17, 20, 24, 27, 32, 35, 40, 43, 44, 48, 51, 54, 57, 60, 65, 68, 71, 76, 77, 81,
    84, 87, 90, 104, 109, 112, 113, 119, 122, 125, 130, 131, 135, 139, 142, 145, 148, 152, 166,
    170, 173, 176, 181, 182, 186, 189, 193, 196, 199, 202, 206, 209, 214, 217, 218, 224, 230,
    233, 236, 241, 242, 246, 249, 252, 256, 259, 262, 265, 269, 272, 275, 280, 283, 284, 290,
    296, 299, 304, 307, 308, 314, 320, 323, 324, 328, 331, 334, 337, 341, 344, 347, 350, 353,
    356, 361, 362, 366, 369, 372, 377, 380, 383, 388, 389, 393, 396, 399, 404, 405, 409, 412,
    415, 418, 422, 425, 428, 431, 434, 448, 452, 464, 469, 472, 473, 479, 485, 488, 489, 495,
    498, 501, 506, 507, 511, 514, 517, 522, 523, 527, 531, 534, 537, 540, 544, 547, 550, 553,
    556, 560, 574, 578, 590, 594, 596, 629, 631, 659, 663, 668, 671, 676, 677, 681, 706, 709,
    712, 715, 719, 745, 748, 749, 755, 785, 790, 791, 795, 826, 829, 832, 836, 868, 869, 875,
    911, 917, 955, 958, 962, 1000, 1001, 1005, 1046, 1050, 1093, 1097, 1129, 1141, 1145, 1162,
    1163, 1190, 1240, 1291, 1327, 1343, 1360, 1361, 92, 154, 436, 562, 608, 612, 624, 628, 643,
    647, 664, 665, 684, 687, 692, 693, 697, 702, 722, 725, 728, 731, 735, 740, 761, 764, 765,
    771, 779, 782, 798, 801, 806, 807, 811, 816, 819, 823, 839, 842, 845, 848, 852, 857, 860,
    865, 881, 884, 885, 891, 899, 902, 907, 910, 923, 926, 927, 933, 941, 944, 945, 949, 952,
    965, 968, 971, 974, 978, 983, 986, 989, 992, 995, 1008, 1011, 1016, 1017, 1021, 1026, 1029,
    1034, 1037, 1040, 1045, 1053, 1056, 1061, 1062, 1066, 1071, 1074, 1079, 1080, 1084, 1087,
    1090, 1100, 1103, 1106, 1109, 1113, 1118, 1121, 1124, 1127, 1157, 1161, 1175, 1180, 1183,
    1184, 1196, 1199, 1200, 1206, 1214, 1217, 1218, 1224, 1227, 1230, 1235, 1236, 1243, 1246,
    1251, 1252, 1256, 1261, 1264, 1269, 1270, 1274, 1278, 1281, 1284, 1287, 1294, 1297, 1300,
    1303, 1307, 1312, 1315, 1318, 1321, 1325, 1339, 1355, 1359, 1373, 1377, 13, 25, 31, 34, 39,
    42, 49, 52, 53, 82, 85, 86, 93, 96, 101, 102, 108, 111, 114, 117, 133, 140, 143, 144, 150,
    155, 158, 163, 164, 168, 184, 188, 194, 197, 198, 204, 213, 216, 219, 222, 226, 229, 244,
    248, 257, 260, 261, 267, 273, 279, 282, 285, 288, 292, 295, 298, 303, 306, 309, 312, 316,
    319, 322, 329, 332, 333, 339, 345, 348, 349, 364, 368, 391, 395, 410, 413, 414, 420, 426,
    429, 430, 437, 440, 445, 446, 450, 453, 456, 461, 462, 468, 471, 474, 477, 481, 484, 487,
    490, 493, 509, 513, 525, 532, 535, 536, 542, 548, 551, 552, 558, 563, 566, 571, 572, 576,
    579, 582, 587, 588, 592, 648, 651, 656, 657, 661, 667, 679, 683, 700, 701, 707, 710, 711,
    717, 747, 750, 753, 757, 781, 793, 797, 814, 815, 827, 828, 834, 870, 873, 877, 912, 915,
    919, 960, 991, 1003, 1007, 1024, 1025, 1036, 1048, 1052, 1069, 1070, 1095, 1143, 1192, 1226,
    1242, 1259, 1260, 4, 16, 56, 67, 121, 172, 232, 352, 379, 497, 597, 600, 605, 606, 610, 613,
    616, 621, 622, 626, 632, 635, 640, 641, 645, 695, 699, 723, 726, 727, 733, 744, 760, 763,
    766, 769, 773, 778, 809, 813, 824, 840, 843, 844, 850, 858, 864, 867, 880, 883, 886, 889,
    893, 898, 901, 906, 909, 922, 925, 928, 931, 935, 940, 943, 950, 953, 954, 966, 969, 970,
    976, 984, 987, 988, 1019, 1023, 1064, 1068, 1085, 1088, 1089, 1101, 1104, 1105, 1111, 1119,
    1122, 1123, 1130, 1133, 1138, 1139, 1146, 1149, 1154, 1155, 1159, 1164, 1167, 1172, 1173,
    1179, 1182, 1185, 1188, 1195, 1198, 1201, 1204, 1208, 1213, 1216, 1219, 1222, 1238, 1254,
    1258, 1272, 1279, 1282, 1283, 1289, 1295, 1298, 1299, 1305, 1313, 1316, 1317, 1323, 1328,
    1331, 1336, 1337, 1341, 1344, 1347, 1352, 1353, 1357, 1362, 1365, 1370, 1371, 1375, 12, 19,
    30, 33, 38, 41, 59, 62, 63, 70, 73, 74, 94, 97, 100, 103, 107, 110, 115, 116, 124, 127, 128,
    134, 149, 156, 159, 162, 165, 169, 175, 178, 179, 185, 203, 207, 212, 215, 220, 221, 225,
    228, 235, 238, 239, 245, 251, 266, 270, 278, 281, 286, 287, 291, 294, 297, 302, 305, 310,
    311, 315, 318, 321, 338, 342, 355, 358, 359, 365, 371, 374, 375, 382, 385, 386, 392, 398,
    401, 402, 419, 423, 438, 441, 444, 447, 451, 454, 457, 460, 463, 467, 470, 475, 476, 480,
    483, 486, 491, 492, 500, 503, 504, 510, 516, 519, 520, 526, 541, 545, 557, 564, 567, 570,
    573, 577, 580, 583, 586, 589, 593, 649, 652, 655, 658, 662, 670, 673, 674, 680, 704, 716,
    720, 737, 738, 746, 751, 752, 756, 787, 788, 794, 821, 833, 837, 854, 855, 871, 872, 876,
    913, 914, 918, 947, 959, 963, 980, 981, 1004, 1049, 1082, 1094, 1098, 1115, 1116, 1144,
    1191, 1276, 1292, 1309, 1310, 7, 22, 46, 79, 137, 191, 254, 326, 407, 529, 598, 601, 604,
    607, 611, 614, 617, 620, 623, 627, 633, 636, 639, 642, 646, 686, 689, 690, 696, 732, 736,
    743, 759, 762, 767, 768, 772, 777, 784, 800, 803, 804, 810, 818, 849, 853, 863, 866, 879,
    882, 887, 888, 892, 897, 900, 905, 908, 921, 924, 929, 930, 934, 939, 942, 975, 979, 994,
    997, 998, 1010, 1013, 1014, 1020, 1028, 1031, 1032, 1039, 1042, 1043, 1055, 1058, 1059,
    1065, 1073, 1076, 1077, 1110, 1114, 1131, 1134, 1137, 1140, 1147, 1150, 1153, 1156, 1160,
    1165, 1168, 1171, 1174, 1178, 1181, 1186, 1187, 1194, 1197, 1202, 1203, 1207, 1212, 1215,
    1220, 1221, 1229, 1232, 1233, 1239, 1245, 1248, 1249, 1255, 1263, 1266, 1267, 1273, 1288,
    1304, 1308, 1322, 1329, 1332, 1335, 1338, 1342, 1345, 1348, 1351, 1354, 1358, 1363, 1366,
    1369, 1372, 1376, 8, 18, 23, 26, 47, 50, 58, 61, 64, 69, 72, 75, 80, 83, 88, 89, 95, 98, 99,
    118, 123, 126, 129, 132, 138, 141, 146, 147, 151, 157, 160, 161, 167, 174, 177, 180, 183,
    187, 192, 195, 200, 201, 205, 208, 223, 227, 234, 237, 240, 243, 247, 250, 255, 258, 263,
    264, 268, 271, 274, 289, 293, 313, 317, 327, 330, 335, 336, 340, 343, 346, 354, 357, 360,
    363, 367, 370, 373, 376, 381, 384, 387, 390, 394, 397, 400, 403, 408, 411, 416, 417, 421,
    424, 427, 432, 433, 439, 442, 443, 449, 455, 458, 459, 478, 482, 494, 499, 502, 505, 508,
    512, 515, 518, 521, 524, 530, 533, 538, 539, 543, 546, 549, 554, 555, 559, 565, 568, 569,
    575, 581, 584, 585, 591, 650, 653, 654, 660, 669, 672, 675, 678, 682, 708, 713, 714, 718,
    742, 754, 758, 775, 776, 786, 789, 792, 796, 830, 831, 835, 862, 874, 878, 895, 896, 904,
    916, 920, 937, 938, 956, 957, 961, 1002, 1006, 1047, 1051, 1096, 1142, 1177, 1193, 1210,
    1211, 1241, 11, 29, 37, 106, 211, 277, 301, 466, 599, 602, 603, 609, 615, 618, 619, 625,
    634, 637, 638, 644, 685, 688, 691, 694, 698, 705, 721, 724, 729, 730, 734, 739, 770, 774,
    783, 799, 802, 805, 808, 812, 817, 822, 825, 838, 841, 846, 847, 851, 856, 859, 890, 894,
    932, 936, 948, 951, 964, 967, 972, 973, 977, 982, 985, 993, 996, 999, 1009, 1012, 1015,
    1018, 1022, 1027, 1030, 1033, 1038, 1041, 1044, 1054, 1057, 1060, 1063, 1067, 1072, 1075,
    1078, 1083, 1086, 1091, 1092, 1099, 1102, 1107, 1108, 1112, 1117, 1120, 1125, 1126, 1132,
    1135, 1136, 1148, 1151, 1152, 1158, 1166, 1169, 1170, 1189, 1205, 1209, 1223, 1228, 1231,
    1234, 1237, 1244, 1247, 1250, 1253, 1257, 1262, 1265, 1268, 1271, 1277, 1280, 1285, 1286,
    1290, 1293, 1296, 1301, 1302, 1306, 1311, 1314, 1319, 1320, 1324, 1330, 1333, 1334, 1340,
    1346, 1349, 1350, 1356, 1364, 1367, 1368, 1374,
};
static const short nodal_first_row[] = {
    0, 211, 363, 533, 678, 848, 993, 1174, 1326,
};
static const short nodal_skew_row[] = {
    17, 24, 32, 40, 43, 48, 51, 57, 60, 68, 71, 76, 81, 84, 87, 109, 112, 113, 122, 125, 130,
    131, 139, 142, 145, 148, 166, 249, 272, 296, 320, 323, 344, 347, 369, 372, 396, 399, 404,
    425, 428, 431, 436, 485, 488, 489, 514, 517, 522, 523, 547, 550, 553, 556, 562, 590, 608,
    612, 643, 647, 664, 684, 687, 692, 693, 697, 722, 725, 728, 731, 735, 761, 764, 765, 771,
    782, 798, 801, 806, 807, 811, 823, 839, 842, 845, 848, 852, 865, 881, 884, 885, 891, 907,
    910, 923, 926, 927, 933, 949, 952, 965, 968, 971, 974, 978, 992, 995, 1008, 1011, 1016,
    1017, 1021, 1037, 1040, 1045, 1053, 1056, 1061, 1062, 1066, 1084, 1087, 1090, 1100, 1103,
    1106, 1109, 1113, 1157, 1161, 1163, 1180, 1183, 1184, 1196, 1199, 1200, 1206, 1227, 1230,
    1235, 1236, 1243, 1246, 1251, 1252, 1256, 1278, 1281, 1284, 1287, 1294, 1297, 1300, 1303,
    1307, 1339, 1355, 1359, 1361, 92, 154, 173, 176, 181, 182, 186, 193, 196, 199, 202, 206,
    214, 217, 218, 224, 233, 236, 241, 242, 246, 256, 259, 262, 265, 269, 280, 283, 284, 290,
    304, 307, 308, 314, 328, 331, 334, 337, 341, 353, 356, 361, 362, 366, 380, 383, 388, 389,
    393, 409, 412, 415, 418, 422, 448, 452, 469, 472, 473, 479, 498, 501, 506, 507, 511, 531,
    534, 537, 540, 544, 574, 578, 596, 624, 628, 631, 659, 663, 668, 671, 676, 677, 681, 706,
    709, 712, 715, 719, 745, 748, 749, 755, 785, 790, 791, 795, 816, 826, 829, 832, 836, 857,
    868, 869, 875, 899, 911, 917, 941, 944, 955, 958, 962, 983, 986, 1000, 1001, 1005, 1026,
    1029, 1046, 1050, 1071, 1074, 1079, 1093, 1097, 1118, 1121, 1124, 1129, 1141, 1145, 1162,
    1190, 1214, 1217, 1218, 1240, 1261, 1264, 1269, 1270, 1291, 1312, 1315, 1318, 1321, 1327,
    1343, 1360, 1373, 13, 25, 31, 34, 39, 42, 49, 52, 53, 82, 85, 86, 93, 96, 101, 102, 108,
    111, 114, 117, 133, 140, 143, 144, 150, 155, 158, 163, 164, 168, 172, 229, 232, 273, 295,
    298, 319, 322, 345, 348, 349, 352, 379, 426, 429, 430, 453, 456, 461, 462, 484, 487, 490,
    493, 497, 525, 548, 551, 552, 558, 579, 582, 587, 588, 592, 597, 600, 605, 606, 610, 632,
    635, 640, 641, 645, 695, 699, 701, 723, 726, 727, 733, 744, 760, 763, 766, 769, 773, 809,
    813, 815, 824, 840, 843, 844, 850, 864, 867, 880, 883, 886, 889, 893, 906, 909, 922, 925,
    928, 931, 935, 950, 953, 954, 966, 969, 970, 976, 1019, 1023, 1025, 1064, 1068, 1070, 1085,
    1088, 1089, 1101, 1104, 1105, 1111, 1130, 1133, 1138, 1139, 1146, 1149, 1154, 1155, 1159,
    1179, 1182, 1185, 1188, 1195, 1198, 1201, 1204, 1208, 1238, 1254, 1258, 1260, 1279, 1282,
    1283, 1289, 1295, 1298, 1299, 1305, 1328, 1331, 1336, 1337, 1341, 1344, 1347, 1352, 1353,
    1357, 4, 16, 56, 67, 121, 184, 188, 194, 197, 198, 204, 213, 216, 219, 222, 226, 244, 248,
    257, 260, 261, 267, 279, 282, 285, 288, 292, 303, 306, 309, 312, 316, 329, 332, 333, 339,
    364, 368, 391, 395, 410, 413, 414, 420, 437, 440, 445, 446, 450, 468, 471, 474, 477, 481,
    509, 513, 532, 535, 536, 542, 563, 566, 571, 572, 576, 613, 616, 621, 622, 626, 648, 651,
    656, 657, 661, 667, 679, 683, 700, 707, 710, 711, 717, 747, 750, 753, 757, 778, 781, 793,
    797, 814, 827, 828, 834, 858, 870, 873, 877, 898, 901, 912, 915, 919, 940, 943, 960, 984,
    987, 988, 991, 1003, 1007, 1024, 1036, 1048, 1052, 1069, 1095, 1119, 1122, 1123, 1143, 1164,
    1167, 1172, 1173, 1192, 1213, 1216, 1219, 1222, 1226, 1242, 1259, 1272, 1313, 1316, 1317,
    1323, 1362, 1365, 1370, 1371, 1375, 12, 19, 30, 33, 38, 41, 59, 62, 63, 70, 73, 74, 94, 97,
    100, 103, 107, 110, 115, 116, 124, 127, 128, 134, 149, 156, 159, 162, 165, 169, 191, 228,
    251, 254, 294, 297, 318, 321, 326, 371, 374, 375, 398, 401, 402, 407, 454, 457, 460, 463,
    483, 486, 491, 492, 516, 519, 520, 526, 529, 557, 580, 583, 586, 589, 593, 598, 601, 604,
    607, 611, 633, 636, 639, 642, 646, 686, 689, 690, 696, 732, 736, 738, 743, 759, 762, 767,
    768, 772, 784, 800, 803, 804, 810, 849, 853, 855, 863, 866, 879, 882, 887, 888, 892, 905,
    908, 921, 924, 929, 930, 934, 975, 979, 981, 994, 997, 998, 1010, 1013, 1014, 1020, 1039,
    1042, 1043, 1055, 1058, 1059, 1065, 1110, 1114, 1116, 1131, 1134, 1137, 1140, 1147, 1150,
    1153, 1156, 1160, 1178, 1181, 1186, 1187, 1194, 1197, 1202, 1203, 1207, 1229, 1232, 1233,
    1239, 1245, 1248, 1249, 1255, 1288, 1304, 1308, 1310, 1329, 1332, 1335, 1338, 1342, 1345,
    1348, 1351, 1354, 1358, 7, 22, 46, 79, 137, 175, 178, 179, 185, 203, 207, 212, 215, 220,
    221, 225, 235, 238, 239, 245, 266, 270, 278, 281, 286, 287, 291, 302, 305, 310, 311, 315,
    338, 342, 355, 358, 359, 365, 382, 385, 386, 392, 419, 423, 438, 441, 444, 447, 451, 467,
    470, 475, 476, 480, 500, 503, 504, 510, 541, 545, 564, 567, 570, 573, 577, 614, 617, 620,
    623, 627, 649, 652, 655, 658, 662, 670, 673, 674, 680, 704, 716, 720, 737, 746, 751, 752,
    756, 777, 787, 788, 794, 818, 821, 833, 837, 854, 871, 872, 876, 897, 900, 913, 914, 918,
    939, 942, 947, 959, 963, 980, 1004, 1028, 1031, 1032, 1049, 1073, 1076, 1077, 1082, 1094,
    1098, 1115, 1144, 1165, 1168, 1171, 1174, 1191, 1212, 1215, 1220, 1221, 1263, 1266, 1267,
    1273, 1276, 1292, 1309, 1322, 1363, 1366, 1369, 1372, 1376, 8, 18, 23, 26, 47, 50, 58, 61,
    64, 69, 72, 75, 80, 83, 88, 89, 95, 98, 99, 118, 123, 126, 129, 132, 138, 141, 146, 147,
    151, 157, 160, 161, 167, 208, 211, 250, 271, 274, 277, 301, 343, 346, 370, 373, 376, 397,
    400, 403, 424, 427, 432, 433, 455, 458, 459, 466, 494, 515, 518, 521, 524, 546, 549, 554,
    555, 559, 581, 584, 585, 591, 599, 602, 603, 609, 634, 637, 638, 644, 685, 688, 691, 694,
    698, 705, 721, 724, 729, 730, 734, 770, 774, 776, 783, 799, 802, 805, 808, 812, 822, 825,
    838, 841, 846, 847, 851, 890, 894, 896, 932, 936, 938, 948, 951, 964, 967, 972, 973, 977,
    993, 996, 999, 1009, 1012, 1015, 1018, 1022, 1038, 1041, 1044, 1054, 1057, 1060, 1063, 1067,
    1083, 1086, 1091, 1092, 1099, 1102, 1107, 1108, 1112, 1132, 1135, 1136, 1148, 1151, 1152,
    1158, 1189, 1205, 1209, 1211, 1228, 1231, 1234, 1237, 1244, 1247, 1250, 1253, 1257, 1277,
    1280, 1285, 1286, 1290, 1293, 1296, 1301, 1302, 1306, 1330, 1333, 1334, 1340, 1346, 1349,
    1350, 1356, 11, 29, 37, 106, 174, 177, 180, 183, 187, 192, 195, 200, 201, 205, 223, 227,
    234, 237, 240, 243, 247, 255, 258, 263, 264, 268, 289, 293, 313, 317, 327, 330, 335, 336,
    340, 354, 357, 360, 363, 367, 381, 384, 387, 390, 394, 408, 411, 416, 417, 421, 439, 442,
    443, 449, 478, 482, 499, 502, 505, 508, 512, 530, 533, 538, 539, 543, 565, 568, 569, 575,
    615, 618, 619, 625, 650, 653, 654, 660, 669, 672, 675, 678, 682, 708, 713, 714, 718, 739,
    742, 754, 758, 775, 786, 789, 792, 796, 817, 830, 831, 835, 856, 859, 862, 874, 878, 895,
    904, 916, 920, 937, 956, 957, 961, 982, 985, 1002, 1006, 1027, 1030, 1033, 1047, 1051, 1072,
    1075, 1078, 1096, 1117, 1120, 1125, 1126, 1142, 1166, 1169, 1170, 1177, 1193, 1210, 1223,
    1241, 1262, 1265, 1268, 1271, 1311, 1314, 1319, 1320, 1324, 1364, 1367, 1368, 1374,
};
static const short nodal_first_skew_row[] = {
    0, 160, 312, 482, 627, 797, 942, 1123, 1275,
};
static const struct products nodal[1] = {
    {51, 1326, nodal_mirror, nodal_pair_t, nodal_pair_v, nodal_first_pair, nodal_first_cross,
    nodal_row, nodal_first_row, nodal_skew_row, nodal_first_skew_row},
};
/* products of section vectors */
static const short sectional_mirror[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32,
};
static const short sectional_pair_t[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32, 4, 5, 6, 7, 7, 8, 8, 9, 9, 10, 10, 10, 11, 11, 11, 12, 13,
    13, 13, 14, 14, 14, 14, 15, 15, 15, 15, 16, 16, 20, 21, 22, 23, 23, 24, 24, 25, 25, 26, 26,
    26, 27, 27, 27, 29, 29, 29, 30, 30, 30, 30, 31, 31, 31, 31, 32, 17, 17, 17, 17, 17, 18, 18,
    18, 18, 18, 19, 19, 19, 19, 20, 20, 20, 20, 20, 21, 21, 21, 21, 21, 22, 22, 22, 22, 23, 23,
    23, 23, 24, 24, 24, 24, 24, 25, 25, 25, 25, 25, 26, 26, 26, 26, 26, 27, 27, 27, 27, 27, 28,
    28, 28, 29, 29, 29, 29, 30, 30, 30, 30, 30, 31, 31, 31, 31, 31, 32, 32, 32, 1, 3, 4, 5, 6,
    6, 7, 7, 8, 8, 8, 9, 10, 11, 11, 11, 12, 12, 12, 12, 13, 13, 13, 13, 14, 14, 15, 15, 15, 15,
    16, 16, 16, 16, 16, 19, 21, 22, 22, 23, 23, 24, 24, 24, 27, 27, 27, 28, 28, 28, 28, 29, 29,
    29, 29, 30, 31, 31, 31, 31, 32, 32, 32, 32, 32, 17, 17, 17, 18, 18, 18, 18, 19, 19, 19, 19,
    19, 20, 20, 20, 21, 21, 21, 21, 22, 22, 22, 22, 22, 23, 23, 23, 23, 23, 24, 24, 24, 24, 25,
    25, 25, 26, 26, 26, 27, 27, 27, 27, 28, 28, 28, 28, 28, 29, 29, 29, 29, 29, 30, 30, 30, 31,
    31, 31, 31, 32, 32, 32, 32, 32, 2, 3, 4, 5, 6, 6, 7, 7, 8, 9, 9, 9, 10, 10, 10, 11, 12, 12,
    12, 12, 13, 13, 13, 13, 14, 14, 14, 14, 15, 15, 16, 16, 16, 16, 16, 19, 20, 22, 22, 23, 23,
    25, 25, 25, 26, 26, 26, 28, 28, 28, 28, 29, 29, 29, 29, 30, 30, 30, 30, 31, 32, 32, 32, 32,
    32, 17, 17, 17, 17, 18, 18, 18, 19, 19, 19, 19, 19, 20, 20, 20, 20, 21, 21, 21, 22, 22, 22,
    22, 22, 23, 23, 23, 23, 23, 24, 24, 24, 25, 25, 25, 25, 26, 26, 26, 26, 27, 27, 27, 28, 28,
    28, 28, 28, 29, 29, 29, 29, 29, 30, 30, 30, 30, 31, 31, 31, 32, 32, 32, 32, 32, 2, 3, 4, 5,
    5, 6, 7, 8, 8, 9, 9, 9, 10, 10, 10, 11, 11, 11, 11, 12, 12, 12, 13, 13, 14, 14, 14, 14, 15,
    15, 15, 15, 15, 16, 16, 16, 16, 18, 20, 21, 21, 24, 24, 25, 25, 25, 26, 26, 26, 27, 27, 27,
    27, 28, 28, 28, 29, 30, 30, 30, 30, 31, 31, 31, 31, 31, 32, 32, 32, 32, 17, 17, 17, 17, 17,
    18, 18, 18, 18, 18, 19, 19, 19, 20, 20, 20, 20, 20, 21, 21, 21, 21, 21, 22, 22, 22, 23, 23,
    23, 24, 24, 24, 24, 24, 25, 25, 25, 25, 25, 26, 26, 26, 26, 26, 27, 27, 27, 27, 27, 28, 28,
    28, 28, 29, 29, 29, 30, 30, 30, 30, 30, 31, 31, 31, 31, 31, 32, 32, 32, 32,
};
static const short sectional_pair_v[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32, 1, 2, 3, 3, 6, 2, 5, 1, 4, 1, 4, 9, 2, 5, 8, 0, 3, 6, 7, 1,
    4, 9, 10, 2, 5, 8, 11, 0, 12, 17, 18, 19, 19, 22, 18, 21, 17, 20, 17, 20, 25, 18, 21, 24,
    19, 22, 23, 17, 20, 25, 26, 18, 21, 24, 27, 28, 1, 4, 9, 10, 14, 2, 5, 8, 11, 15, 3, 6, 7,
    13, 1, 4, 9, 10, 14, 2, 5, 8, 11, 15, 3, 6, 7, 13, 3, 6, 7, 13, 2, 5, 8, 11, 15, 1, 4, 9,
    10, 14, 1, 4, 9, 10, 14, 2, 5, 8, 11, 15, 0, 12, 16, 3, 6, 7, 13, 1, 4, 9, 10, 14, 2, 5, 8,
    11, 15, 0, 12, 16, 0, 2, 0, 3, 2, 5, 2, 5, 3, 6, 7, 0, 0, 3, 6, 7, 1, 4, 9, 10, 2, 5, 8, 11,
    0, 12, 3, 6, 7, 13, 1, 4, 9, 10, 14, 18, 19, 18, 21, 18, 21, 19, 22, 23, 19, 22, 23, 17, 20,
    25, 26, 18, 21, 24, 27, 28, 19, 22, 23, 29, 17, 20, 25, 26, 30, 0, 12, 16, 3, 6, 7, 13, 2,
    5, 8, 11, 15, 0, 12, 16, 3, 6, 7, 13, 2, 5, 8, 11, 15, 2, 5, 8, 11, 15, 3, 6, 7, 13, 0, 12,
    16, 0, 12, 16, 3, 6, 7, 13, 1, 4, 9, 10, 14, 2, 5, 8, 11, 15, 0, 12, 16, 3, 6, 7, 13, 1, 4,
    9, 10, 14, 0, 1, 3, 0, 1, 4, 1, 4, 0, 3, 6, 7, 3, 6, 7, 0, 2, 5, 8, 11, 1, 4, 9, 10, 3, 6,
    7, 13, 0, 12, 2, 5, 8, 11, 15, 17, 19, 17, 20, 17, 20, 19, 22, 23, 19, 22, 23, 18, 21, 24,
    27, 17, 20, 25, 26, 19, 22, 23, 29, 28, 18, 21, 24, 27, 31, 3, 6, 7, 13, 0, 12, 16, 1, 4, 9,
    10, 14, 3, 6, 7, 13, 0, 12, 16, 1, 4, 9, 10, 14, 1, 4, 9, 10, 14, 0, 12, 16, 3, 6, 7, 13, 3,
    6, 7, 13, 0, 12, 16, 2, 5, 8, 11, 15, 1, 4, 9, 10, 14, 3, 6, 7, 13, 0, 12, 16, 2, 5, 8, 11,
    15, 1, 0, 2, 1, 4, 0, 0, 1, 4, 2, 5, 8, 2, 5, 8, 1, 4, 9, 10, 3, 6, 7, 0, 12, 2, 5, 8, 11,
    1, 4, 9, 10, 14, 3, 6, 7, 13, 17, 18, 17, 20, 17, 20, 18, 21, 24, 18, 21, 24, 17, 20, 25,
    26, 19, 22, 23, 28, 18, 21, 24, 27, 17, 20, 25, 26, 30, 19, 22, 23, 29, 2, 5, 8, 11, 15, 1,
    4, 9, 10, 14, 0, 12, 16, 2, 5, 8, 11, 15, 1, 4, 9, 10, 14, 0, 12, 16, 0, 12, 16, 1, 4, 9,
    10, 14, 2, 5, 8, 11, 15, 2, 5, 8, 11, 15, 1, 4, 9, 10, 14, 3, 6, 7, 13, 0, 12, 16, 2, 5, 8,
    11, 15, 1, 4, 9, 10, 14, 3, 6, 7, 13,
};
static const short sectional_first_pair[] = {
    0, 89, 161, 226, 291, 356, 421, 491, 561,
};
static const short sectional_first_cross[] = {
    33, 89, 161, 226, 291, 356, 421, 491, 561,
};
static const short sectional_row[] = {
    0, 2, 5, 9, 11, 14, 17, 20, 24, 27, 31, 34, 35, 38, 41, 44, 46, 49, 54, 56, 59, 64, 65, 68,
    71, 74, 77, 78, 90, 94, 97, 98, 104, 106, 109, 114, 115, 119, 122, 125, 128, 131, 135, 136,
    148, 152, 170, 189, 209, 227, 230, 249, 252, 272, 275, 295, 298, 299, 318, 321, 324, 342,
    345, 350, 368, 371, 376, 377, 396, 399, 402, 405, 434, 454, 457, 458, 464, 482, 485, 490,
    491, 495, 514, 517, 520, 523, 527, 556, 560, 154, 157, 162, 163, 167, 173, 176, 179, 182,
    186, 193, 196, 197, 203, 211, 214, 219, 220, 224, 233, 236, 239, 242, 246, 256, 259, 260,
    266, 279, 282, 283, 289, 302, 305, 308, 311, 315, 326, 329, 334, 335, 339, 352, 355, 360,
    361, 365, 380, 383, 386, 389, 393, 406, 418, 422, 438, 441, 442, 448, 466, 469, 474, 475,
    479, 498, 501, 504, 507, 511, 528, 540, 544, 1, 8, 10, 18, 23, 26, 30, 33, 39, 42, 43, 45,
    55, 69, 72, 73, 79, 82, 87, 88, 93, 96, 99, 102, 105, 117, 123, 126, 127, 133, 137, 140,
    145, 146, 150, 208, 250, 271, 274, 294, 297, 319, 322, 323, 397, 400, 401, 423, 426, 431,
    432, 453, 456, 459, 462, 493, 515, 518, 519, 525, 545, 548, 553, 554, 558, 153, 165, 169,
    174, 177, 178, 184, 192, 195, 198, 201, 205, 210, 222, 226, 234, 237, 238, 244, 255, 258,
    261, 264, 268, 278, 281, 284, 287, 291, 303, 306, 307, 313, 325, 337, 341, 351, 363, 367,
    381, 384, 385, 391, 407, 410, 415, 416, 420, 437, 440, 443, 446, 450, 465, 477, 481, 499,
    502, 503, 509, 529, 532, 537, 538, 542, 3, 7, 13, 15, 22, 25, 29, 32, 36, 48, 51, 52, 58,
    61, 62, 66, 80, 83, 86, 89, 92, 95, 100, 101, 108, 111, 112, 118, 120, 132, 138, 141, 144,
    147, 151, 207, 229, 270, 273, 293, 296, 344, 347, 348, 370, 373, 374, 424, 427, 430, 433,
    452, 455, 460, 461, 484, 487, 488, 494, 524, 546, 549, 552, 555, 559, 156, 159, 160, 166,
    171, 183, 187, 191, 194, 199, 200, 204, 213, 216, 217, 223, 231, 243, 247, 254, 257, 262,
    263, 267, 277, 280, 285, 286, 290, 300, 312, 316, 328, 331, 332, 338, 354, 357, 358, 364,
    378, 390, 394, 408, 411, 414, 417, 421, 436, 439, 444, 445, 449, 468, 471, 472, 478, 496,
    508, 512, 530, 533, 536, 539, 543, 4, 6, 12, 16, 19, 21, 28, 37, 40, 47, 50, 53, 57, 60, 63,
    67, 70, 75, 76, 81, 84, 85, 91, 103, 107, 110, 113, 116, 121, 124, 129, 130, 134, 139, 142,
    143, 149, 188, 228, 248, 251, 317, 320, 343, 346, 349, 369, 372, 375, 395, 398, 403, 404,
    425, 428, 429, 463, 483, 486, 489, 492, 513, 516, 521, 522, 526, 547, 550, 551, 557, 155,
    158, 161, 164, 168, 172, 175, 180, 181, 185, 190, 202, 206, 212, 215, 218, 221, 225, 232,
    235, 240, 241, 245, 253, 265, 269, 276, 288, 292, 301, 304, 309, 310, 314, 327, 330, 333,
    336, 340, 353, 356, 359, 362, 366, 379, 382, 387, 388, 392, 409, 412, 413, 419, 435, 447,
    451, 467, 470, 473, 476, 480, 497, 500, 505, 506, 510, 531, 534, 535, 541,
};
static const short sectional_first_row[] = {
    0, 89, 161, 226, 291, 356, 421, 491, 561,
};
static const short sectional_skew_row[] = {
    11, 17, 24, 31, 34, 38, 41, 46, 49, 56, 59, 64, 68, 71, 74, 78, 94, 97, 98, 106, 109, 114,
    115, 122, 125, 128, 131, 136, 148, 227, 249, 272, 295, 298, 318, 321, 342, 345, 368, 371,
    376, 396, 399, 402, 454, 457, 458, 482, 485, 490, 491, 514, 517, 520, 523, 556, 154, 157,
    162, 163, 167, 173, 176, 179, 182, 186, 193, 196, 197, 203, 211, 214, 219, 220, 224, 233,
    236, 239, 242, 246, 256, 259, 260, 266, 279, 282, 283, 289, 302, 305, 308, 311, 315, 326,
    329, 334, 335, 339, 352, 355, 360, 361, 365, 380, 383, 386, 389, 393, 406, 418, 422, 438,
    441, 442, 448, 466, 469, 474, 475, 479, 498, 501, 504, 507, 511, 528, 540, 544, 1, 8, 10,
    18, 23, 26, 30, 33, 39, 42, 43, 45, 55, 69, 72, 73, 79, 82, 87, 88, 93, 96, 99, 102, 105,
    117, 123, 126, 127, 133, 137, 140, 145, 146, 150, 208, 250, 271, 274, 294, 297, 319, 322,
    323, 397, 400, 401, 423, 426, 431, 432, 453, 456, 459, 462, 493, 515, 518, 519, 525, 545,
    548, 553, 554, 558, 153, 165, 169, 174, 177, 178, 184, 192, 195, 198, 201, 205, 210, 222,
    226, 234, 237, 238, 244, 255, 258, 261, 264, 268, 278, 281, 284, 287, 291, 303, 306, 307,
    313, 325, 337, 341, 351, 363, 367, 381, 384, 385, 391, 407, 410, 415, 416, 420, 437, 440,
    443, 446, 450, 465, 477, 481, 499, 502, 503, 509, 529, 532, 537, 538, 542, 3, 7, 13, 15, 22,
    25, 29, 32, 36, 48, 51, 52, 58, 61, 62, 66, 80, 83, 86, 89, 92, 95, 100, 101, 108, 111, 112,
    118, 120, 132, 138, 141, 144, 147, 151, 207, 229, 270, 273, 293, 296, 344, 347, 348, 370,
    373, 374, 424, 427, 430, 433, 452, 455, 460, 461, 484, 487, 488, 494, 524, 546, 549, 552,
    555, 559, 156, 159, 160, 166, 171, 183, 187, 191, 194, 199, 200, 204, 213, 216, 217, 223,
    231, 243, 247, 254, 257, 262, 263, 267, 277, 280, 285, 286, 290, 300, 312, 316, 328, 331,
    332, 338, 354, 357, 358, 364, 378, 390, 394, 408, 411, 414, 417, 421, 436, 439, 444, 445,
    449, 468, 471, 472, 478, 496, 508, 512, 530, 533, 536, 539, 543, 4, 6, 12, 16, 19, 21, 28,
    37, 40, 47, 50, 53, 57, 60, 63, 67, 70, 75, 76, 81, 84, 85, 91, 103, 107, 110, 113, 116,
    121, 124, 129, 130, 134, 139, 142, 143, 149, 188, 228, 248, 251, 317, 320, 343, 346, 349,
    369, 372, 375, 395, 398, 403, 404, 425, 428, 429, 463, 483, 486, 489, 492, 513, 516, 521,
    522, 526, 547, 550, 551, 557, 155, 158, 161, 164, 168, 172, 175, 180, 181, 185, 190, 202,
    206, 212, 215, 218, 221, 225, 232, 235, 240, 241, 245, 253, 265, 269, 276, 288, 292, 301,
    304, 309, 310, 314, 327, 330, 333, 336, 340, 353, 356, 359, 362, 366, 379, 382, 387, 388,
    392, 409, 412, 413, 419, 435, 447, 451, 467, 470, 473, 476, 480, 497, 500, 505, 506, 510,
    531, 534, 535, 541,
};
static const short sectional_first_skew_row[] = {
    0, 56, 128, 193, 258, 323, 388, 458, 528,
};
static const struct products sectional[1] = {
    {33, 561, sectional_mirror, sectional_pair_t, sectional_pair_v, sectional_first_pair,
    sectional_first_cross, sectional_row, sectional_first_row, sectional_skew_row,
    sectional_first_skew_row},
};

/* Q_rc of all Gram entries, the normal block before the shear block, at a station. */
static double law_entry(const struct hobe_invariants *inv, int g, int r, int c)
{
    if (r < NN && c < NN)
        return inv->Qn[inv->step_n * g + r * NN + c];
    if (r >= NN && c >= NN)
        return inv->Qs[inv->step_s * g + (r - NN) * NS + c - NN];
    if (!inv->Qc)
        return 0.0;
    return inv->Qc[inv->step_c * g + (r < c ? r : c) * NS + (r < c ? c : r) - NN];
}

/* The classes of pairs that the law of a station mixes, as bits that differ: entries of Q beyond
 * rounding. */
static int mixed(const struct hobe_invariants *inv, int g)
{
    const double rounding = 1e-13;
    double size[NN + NS];
    int odd[NN + NS], found = 0;
    for (int i = 0; i < S; i++)
        for (int k = 0; k <= i; k++) {
            const int r = gram_entry(k, i), ii = gram_entry(i, i), kk = gram_entry(k, k);
            odd[r] = parity[i] ^ parity[k];
            size[r] = __builtin_fabs(law_entry(inv, g, r, r));
            if (r < NN) /* its own may vanish: of warping functions the law may know means alone */
                size[r] += __builtin_sqrt(
                    __builtin_fabs(law_entry(inv, g, ii, ii) * law_entry(inv, g, kk, kk)));
        }
    for (int r = 0; r < NN + NS; r++)
        for (int c = 0; c < r; c++) {
            const double q = law_entry(inv, g, r, c) / rounding;
            if (q * q > size[r] * size[c])
                found |= odd[r] ^ odd[c];
        }
    return found;
}

/* Which parities the element keeps apart (kernel.h). */
static int symmetry(const struct hobe_invariants *inv)
{
    int kept = HOBE_SYMMETRIES - 1;
    for (int g = 0; g < (inv->step_n ? inv->stations : 1); g++)
        kept &= ~mixed(inv, g);
    return kept;
}

/* The coefficients c[3] of Q, of the symmetric and of the skew part of the row (i, j) and the column
 * (t, v), of one station or of all. */
typedef void coefficients(const struct hobe_invariants *inv, int g, int i, int j, int t, int v,
                          double c[3]);

/* From A_(ij)(tv), A_(it)(jv) and A_(iv)(jt). */
static void split(int t, int v, double c[3])
{
    const double first = c[1], second = t == v ? 0.0 : c[2];
    c[1] = first + second;
    c[2] = 0.5 * (first - second);
}

/* The vectors i >= j of a row, or of its mirror image if that comes first: both are parts of that
 * one's. */
static void row_vectors(const struct products *of, int r, int *i, int *j)
{
    for (int n = 0; n < 2; n++) {
        for (*i = 0; hobe_pair(*i + 1, 0) <= r; ++*i)
            ;
        *j = r - hobe_pair(*i, 0);
        const int other = symmetric(of->mirror[*i], of->mirror[*j]);
        r = other < r ? other : r;
    }
}

/* The place, among the coefficients of a class of rows, of the one of row r and column p where sums
 * are taken over `height` rows at a time. */
static int place(int rows, int columns, int height, int r, int p)
{
    const int together = r < rows / height * height ? height : 1;
    return (r - r % together) * columns + p * together + r % together;
}

/* How many columns meet the rows of class c; their numbers to pair[], unless that is NULL. */
static int meets(int symmetry, int c, const short *first, int *pair)
{
    int count = 0;
    for (int m = 0; m < merged[symmetry]; m++) {
        const int k = c ^ merged_with[CLASSES * symmetry + m];
        for (int p = first[k]; p < first[k + 1]; p++, count++)
            if (pair)
                pair[count] = p;
    }
    return count;
}

/* The coefficients of the rows of class c: of sums first <= s < last to H[s], which move on. */
static void row_coefficients(const struct products *of, coefficients *value,
                             const struct hobe_invariants *inv, int g, int c, int first, int last,
                             double *H[3])
{
    static const int height[3] = {4, 2, 4};
    const int skew = first == 2;
    const short *row = skew ? of->skew_row : of->row;
    const short *start = skew ? of->first_skew_row : of->first_row;
    const int rows = start[c + 1] - start[c];
    int pair[MOST_PAIRS];
    const int columns = meets(inv->symmetry, c, skew ? of->first_cross : of->first_pair, pair);
    for (int r = 0; r < rows; r++) {
        int i, j;
        row_vectors(of, row[start[c] + r], &i, &j);
        for (int p = 0; p < columns; p++) {
            double all[3];
            value(inv, g, i, j, of->pair_t[pair[p]], of->pair_v[pair[p]], all);
            for (int s = first; s < last; s++)
                H[s][place(rows, columns, height[s], r, p)] = all[s];
        }
    }
    for (int s = first; s < last; s++)
        H[s] += rows * columns;
}

/* All coefficients, in the order in which the sums read them. */
static void fill_products(const struct products *of, coefficients *value,
                          const struct hobe_invariants *inv, int g, double *to)
{
    int count = 0;
    for (int c = 0; c < CLASSES; c++)
        count += (of->first_row[c + 1] - of->first_row[c]) *
                 meets(inv->symmetry, c, of->first_pair, NULL);
    double *H[3] = {to, to + count, to + 2 * count};
    for (int c = 0; c < CLASSES; c++) {
        row_coefficients(of, value, inv, g, c, 0, 2, H); /* of Q and of the symmetric part */
        row_coefficients(of, value, inv, g, c, 2, 3, H); /* of the skew part */
    }
}

/* a[16] = int of the axial functions of vectors i, j and columns t, v (e = 0..3) over the length:
 * bit e of the index says whether it is the function itself or its derivative. */
static void axial_integrals(const struct hobe_invariants *inv, int i, int j, int t, int v,
                            double a[16])
{
    clear(a, 16);
    for (int g = 0; g < inv->stations; g++) {
        const double *F[2] = {inv->Nx + V * g, inv->N + V * g};
        double rows[4], columns[4];
        for (int n = 0; n < 4; n++) {
            const double *f = F[n & 1], *h = F[n >> 1];
            rows[n] = inv->wx[g] * f[i] * h[j];
            columns[n] = share[t] * (f[left[t]] + sign[t] * f[right[t]]) * share[v] *
                         (h[left[v]] + sign[v] * h[right[v]]);
        }
        for (int n = 0; n < 16; n++)
            a[n] += rows[n & 3] * columns[n >> 2];
    }
}

/* The entry of A whose indices are those of a in the given order, modes k[4]: the sum over the
 * section vectors that they are d_k' or d_k of. */
static double tensor_entry(const struct hobe_invariants *inv, const double a[16], const int k[4],
                           const int order[4])
{
    double sum = 0.0;
    int normal[2][2], shear[2][2]; /* Gram entries of both pairs: both primed or none, or one */
    for (int h = 0; h < 2; h++) {
        const int p = k[order[2 * h]], q = k[order[2 * h + 1]];
        normal[h][0] = symmetric(p, q);
        normal[h][1] = p && q ? NA + symmetric(p - 1, q - 1) : -1;
        shear[h][0] = q ? p * (M - 1) + q - 1 : -1;
        shear[h][1] = p ? q * (M - 1) + p - 1 : -1;
    }
    for (int n = 0; n < 4; n++) {
        const int x = n & 1, y = n >> 1, both = x << order[0] | x << order[1];
        const int *N = normal[0], *G = shear[0];
        if (N[x] >= 0 && normal[1][y] >= 0)
            sum += a[both | y << order[2] | y << order[3]] * inv->Qn[N[x] * NN + normal[1][y]];
        if (G[x] >= 0 && shear[1][y] >= 0)
            sum += a[1 << order[1 - x] | 1 << order[3 - y]] * inv->Qs[G[x] * NS + shear[1][y]];
    }
    return sum;
}

static void nodal_coefficients(const struct hobe_invariants *inv, int g, int i, int j, int t, int v,
                               double c[3])
{
    static const int order[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
    const int k[4] = {mode[i], mode[j], mode[left[t]], mode[left[v]]};
    double a[16];
    (void)g; /* of all */
    axial_integrals(inv, i, j, t, v, a);
    for (int n = 0; n < 3; n++)
        c[n] = tensor_entry(inv, a, k, order[n]);
    split(t, v, c);
}

static void tensor(const struct hobe_invariants *inv)
{
    fill_products(nodal, nodal_coefficients, inv, 0, inv->tensor);
}

static void sectional_coefficients(const struct hobe_invariants *inv, int g, int i, int j, int t,
                                   int v, double c[3])
{
    const int pair[3][4] = {{i, j, t, v}, {i, t, j, v}, {i, v, j, t}};
    for (int n = 0; n < 3; n++) {
        const int *p = pair[n];
        c[n] = law_entry(inv, g, gram_entry(p[0] < p[1] ? p[0] : p[1], larger(p[0], p[1])),
                         gram_entry(p[2] < p[3] ? p[2] : p[3], larger(p[2], p[3])));
    }
    split(t, v, c);
}

/* weight[A][A][2][4]: of two axial functions at the stations g and h, mirror images, the parts
 * (c + s c')/2 and (c - s c')/2 of their products, both derived, the first, the second, none. */
static void axial_weights(const struct hobe_invariants *inv, int g, int h, double *weight)
{
    for (int a = 0; a < A; a++)
        for (int b = 0; b < A; b++, weight += 8) {
            int v = 0, w = 0;
            while (axial_of[v] != a)
                v++;
            while (axial_of[w] != b)
                w++;
            for (int n = 0; n < 4; n++) {
                const double *F = n & 2 ? inv->N : inv->Nx, *G = n & 1 ? inv->N : inv->Nx;
                const double here = inv->wx[g] * F[V * g + v] * G[V * g + w];
                const double there = inv->wx[h] * F[V * h + v] * G[V * h + w];
                const double other = n == 1 || n == 2 ? -there : there;
                weight[n] = MIRRORED ? 0.5 * (here + other) : here;
                weight[4 + n] = MIRRORED ? 0.5 * (here - other) : 0.0;
            }
        }
}

static void section(const struct hobe_invariants *inv)
{
    double *H = inv->section + AXIAL * inv->stations;
    for (int g = 0; g < inv->stations; g++)
        axial_weights(inv, g, inv->stations - 1 - g, inv->section + AXIAL * g);
    for (int g = 0; g < (inv->step ? inv->stations : 1); g++)
        fill_products(sectional, sectional_coefficients, inv, g, H + inv->step * g);
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

/* gamma_tv = B_t.C_v + C_t.B_v, gamma_tt = B_t.C_t: with B = y0 + u/2, C = u the Gram
 * differences y_t.y_v - y0_t.y0_v without cancellation, half of them where t = v */
static void column_differences(const struct products *of, const hobe_real *B, const hobe_real *C,
                               hobe_real *gamma)
{
    for (int p = 0; p < of->columns; p++) {
        const int t = 3 * of->pair_t[p];
        gamma[p] = dot(B + t, C + t);
    }
    for (int p = of->columns; p < of->pairs; p++) {
        const int t = 3 * of->pair_t[p], v = 3 * of->pair_v[p];
        gamma[p] = dot(B + t, C + v) + dot(C + t, B + v);
    }
}

/* X[pairs][6]: xx, yy, zz, 2yz, 2xz, 2xy of y_t with y_v; Z[pairs - columns][3] = y_t x y_v */
static void products(const struct products *of, const hobe_real *y, hobe_real *X, hobe_real *Z)
{
    for (int p = 0; p < of->pairs; p++) {
        const hobe_real *t = y + 3 * of->pair_t[p], *v = y + 3 * of->pair_v[p];
        const hobe_real t0 = t[0], t1 = t[1], t2 = t[2], v0 = v[0], v1 = v[1], v2 = v[2];
        hobe_real *to = X + 6 * p;
        to[0] = t0 * v0;
        to[1] = t1 * v1;
        to[2] = t2 * v2;
        to[3] = t1 * v2 + t2 * v1;
        to[4] = t2 * v0 + t0 * v2;
        to[5] = t0 * v1 + t1 * v0;
        if (p >= of->columns) {
            hobe_real *cross = Z + 3 * (p - of->columns);
            cross[0] = t1 * v2 - t2 * v1;
            cross[1] = t2 * v0 - t0 * v2;
            cross[2] = t0 * v1 - t1 * v0;
        }
    }
}

/* Q[row][1] = the rows' sums of coefficients H times columns
 * X[pairs][1]; returns the end of H */
static const double *row_stress(const struct products *of, const double *H, int symmetry,
                                const hobe_real *X, hobe_real *Q)
{
    for (int c = 0; c < CLASSES; c++) {
        const int count = of->first_row[c + 1] - of->first_row[c];
        for (int b = 0; b < count / 4; b++) {
            const int r = of->first_row[c] + 4 * b;
            hobe_real s00 = zero;
            hobe_real s10 = zero;
            hobe_real s20 = zero;
            hobe_real s30 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + 1 * p;
                    s00 += H[0] * x[0];
                    s10 += H[1] * x[0];
                    s20 += H[2] * x[0];
                    s30 += H[3] * x[0];
                    H += 4;
                }
            }
            Q[1 * of->row[r + 0] + 0] = s00;
            Q[1 * of->row[r + 1] + 0] = s10;
            Q[1 * of->row[r + 2] + 0] = s20;
            Q[1 * of->row[r + 3] + 0] = s30;
        }
        for (int r = of->first_row[c] + count / 4 * 4; r < of->first_row[c + 1]; r++) {
            hobe_real s00 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + 1 * p;
                    s00 += H[0] * x[0];
                    H += 1;
                }
            }
            Q[1 * of->row[r + 0] + 0] = s00;
        }
    }
    return H;
}

/* sym[row][6] = the rows' sums of coefficients H times columns
 * X[pairs][6]; returns the end of H */
static const double *row_symmetric(const struct products *of, const double *H, int symmetry,
                                   const hobe_real *X, hobe_real *sym)
{
    for (int c = 0; c < CLASSES; c++) {
        const int count = of->first_row[c + 1] - of->first_row[c];
        for (int b = 0; b < count / 2; b++) {
            const int r = of->first_row[c] + 2 * b;
            hobe_real s00 = zero, s01 = zero, s02 = zero, s03 = zero, s04 = zero, s05 = zero;
            hobe_real s10 = zero, s11 = zero, s12 = zero, s13 = zero, s14 = zero, s15 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + 6 * p;
                    s00 += H[0] * x[0];
                    s01 += H[0] * x[1];
                    s02 += H[0] * x[2];
                    s03 += H[0] * x[3];
                    s04 += H[0] * x[4];
                    s05 += H[0] * x[5];
                    s10 += H[1] * x[0];
                    s11 += H[1] * x[1];
                    s12 += H[1] * x[2];
                    s13 += H[1] * x[3];
                    s14 += H[1] * x[4];
                    s15 += H[1] * x[5];
                    H += 2;
                }
            }
            sym[6 * of->row[r + 0] + 0] = s00;
            sym[6 * of->row[r + 0] + 1] = s01;
            sym[6 * of->row[r + 0] + 2] = s02;
            sym[6 * of->row[r + 0] + 3] = s03;
            sym[6 * of->row[r + 0] + 4] = s04;
            sym[6 * of->row[r + 0] + 5] = s05;
            sym[6 * of->row[r + 1] + 0] = s10;
            sym[6 * of->row[r + 1] + 1] = s11;
            sym[6 * of->row[r + 1] + 2] = s12;
            sym[6 * of->row[r + 1] + 3] = s13;
            sym[6 * of->row[r + 1] + 4] = s14;
            sym[6 * of->row[r + 1] + 5] = s15;
        }
        for (int r = of->first_row[c] + count / 2 * 2; r < of->first_row[c + 1]; r++) {
            hobe_real s00 = zero, s01 = zero, s02 = zero, s03 = zero, s04 = zero, s05 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + 6 * p;
                    s00 += H[0] * x[0];
                    s01 += H[0] * x[1];
                    s02 += H[0] * x[2];
                    s03 += H[0] * x[3];
                    s04 += H[0] * x[4];
                    s05 += H[0] * x[5];
                    H += 1;
                }
            }
            sym[6 * of->row[r + 0] + 0] = s00;
            sym[6 * of->row[r + 0] + 1] = s01;
            sym[6 * of->row[r + 0] + 2] = s02;
            sym[6 * of->row[r + 0] + 3] = s03;
            sym[6 * of->row[r + 0] + 4] = s04;
            sym[6 * of->row[r + 0] + 5] = s05;
        }
    }
    return H;
}

/* skew[row][3] = the rows' sums of coefficients H times columns
 * X[pairs - columns][3]; returns the end of H */
static const double *row_skew(const struct products *of, const double *H, int symmetry,
                              const hobe_real *X, hobe_real *skew)
{
    for (int c = 0; c < CLASSES; c++) {
        const int count = of->first_skew_row[c + 1] - of->first_skew_row[c];
        for (int b = 0; b < count / 4; b++) {
            const int r = of->first_skew_row[c] + 4 * b;
            hobe_real s00 = zero, s01 = zero, s02 = zero;
            hobe_real s10 = zero, s11 = zero, s12 = zero;
            hobe_real s20 = zero, s21 = zero, s22 = zero;
            hobe_real s30 = zero, s31 = zero, s32 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_cross[k]; p < of->first_cross[k + 1]; p++) {
                    const hobe_real *x = X + 3 * (p - of->columns);
                    s00 += H[0] * x[0];
                    s01 += H[0] * x[1];
                    s02 += H[0] * x[2];
                    s10 += H[1] * x[0];
                    s11 += H[1] * x[1];
                    s12 += H[1] * x[2];
                    s20 += H[2] * x[0];
                    s21 += H[2] * x[1];
                    s22 += H[2] * x[2];
                    s30 += H[3] * x[0];
                    s31 += H[3] * x[1];
                    s32 += H[3] * x[2];
                    H += 4;
                }
            }
            skew[3 * of->skew_row[r + 0] + 0] = s00;
            skew[3 * of->skew_row[r + 0] + 1] = s01;
            skew[3 * of->skew_row[r + 0] + 2] = s02;
            skew[3 * of->skew_row[r + 1] + 0] = s10;
            skew[3 * of->skew_row[r + 1] + 1] = s11;
            skew[3 * of->skew_row[r + 1] + 2] = s12;
            skew[3 * of->skew_row[r + 2] + 0] = s20;
            skew[3 * of->skew_row[r + 2] + 1] = s21;
            skew[3 * of->skew_row[r + 2] + 2] = s22;
            skew[3 * of->skew_row[r + 3] + 0] = s30;
            skew[3 * of->skew_row[r + 3] + 1] = s31;
            skew[3 * of->skew_row[r + 3] + 2] = s32;
        }
        for (int r = of->first_skew_row[c] + count / 4 * 4; r < of->first_skew_row[c + 1]; r++) {
            hobe_real s00 = zero, s01 = zero, s02 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_cross[k]; p < of->first_cross[k + 1]; p++) {
                    const hobe_real *x = X + 3 * (p - of->columns);
                    s00 += H[0] * x[0];
                    s01 += H[0] * x[1];
                    s02 += H[0] * x[2];
                    H += 1;
                }
            }
            skew[3 * of->skew_row[r + 0] + 0] = s00;
            skew[3 * of->skew_row[r + 0] + 1] = s01;
            skew[3 * of->skew_row[r + 0] + 2] = s02;
        }
    }
    return H;
}

/* Q of the rows from the parts that mirror images share */
static void images(hobe_real *Q)
{
    for (int o = 0; o < IMAGES; o++) {
        const int v = lead[2 * o];
        const int u = lead[2 * o + 1];
        const int m = hobe_pair(v, u);
        const int n = symmetric(nodal->mirror[v], nodal->mirror[u]);
        hobe_real *a = Q + m, *b = Q + n;
        const hobe_real sum = a[0] + b[0], difference = a[0] - b[0];
        a[0] = sum;
        b[0] = difference;
    }
}

/* f_i = sum_j Q_ij x_j, where x_0 = 0; on positions they are in balance */
static void tensor_force(const hobe_real *Q, const hobe_real *x, hobe_real *f)
{
    for (int a = 0; a < 3; a++) {
        f[a * HOBE_PARTS] = zero;
    }
    for (int i = 1; i < V; i++) {
        hobe_real sum[3] = {zero, zero, zero};
        for (int j = 1; j < i; j++) {
            for (int a = 0; a < 3; a++) {
                sum[a] += Q[hobe_pair(i, j)] * x[3 * j + a];
            }
        }
        for (int j = i; j < V; j++) {
            for (int a = 0; a < 3; a++) {
                sum[a] += Q[hobe_pair(j, i)] * x[3 * j + a];
            }
        }
        for (int a = 0; a < 3; a++) {
            f[(3 * i + a) * HOBE_PARTS] = sum[a];
        }
        if (position[i]) {
            for (int a = 0; a < 3; a++) {
                f[a * HOBE_PARTS] -= sum[a];
            }
        }
    }
}

/* k[3][3] = sym + skew + Q 1 of a row */
static inline void block(const hobe_real *s, const hobe_real *r, const hobe_real *Q, hobe_real *k)
{
    k[0 * HOBE_PARTS] = s[0] + Q[0];
    k[4 * HOBE_PARTS] = s[1] + Q[0];
    k[8 * HOBE_PARTS] = s[2] + Q[0];
    k[1 * HOBE_PARTS] = 0.5 * s[5] + r[2];
    k[3 * HOBE_PARTS] = 0.5 * s[5] - r[2];
    k[6 * HOBE_PARTS] = 0.5 * s[4] + r[1];
    k[2 * HOBE_PARTS] = 0.5 * s[4] - r[1];
    k[5 * HOBE_PARTS] = 0.5 * s[3] + r[0];
    k[7 * HOBE_PARTS] = 0.5 * s[3] - r[0];
}

/* K_ij = sym_ij + skew_ij + Q_ij 1 from the rows, those of images from their sum and difference */
static void blocks(const hobe_real *Q, const hobe_real *sym, const hobe_real *skew, hobe_real *K)
{
    for (int o = 0; o < IMAGES; o++) {
        const int v = lead[2 * o];
        const int u = lead[2 * o + 1];
        const int m = hobe_pair(v, u);
        const int n = symmetric(nodal->mirror[v], nodal->mirror[u]);
        hobe_real s[6], r[3];
        for (int e = 0; e < 6; e++) {
            s[e] = sym[6 * m + e] + sym[6 * n + e];
        }
        for (int e = 0; e < 3; e++) {
            r[e] = skew[3 * m + e] + skew[3 * n + e];
        }
        block(s, r, Q + m, K + 9 * HOBE_PARTS * m);
        for (int e = 0; e < 6; e++) {
            s[e] = sym[6 * m + e] - sym[6 * n + e];
        }
        for (int e = 0; e < 3; e++) {
            r[e] = skew[3 * m + e] - skew[3 * n + e];
        }
        block(s, r, Q + n, K + 9 * HOBE_PARTS * n);
    }
    for (int o = IMAGES; o < IMAGES + ALONE; o++) {
        const int v = lead[2 * o];
        const int u = lead[2 * o + 1];
        const int m = hobe_pair(v, u);
        block(sym + 6 * m, skew + 3 * m, Q + m, K + 9 * HOBE_PARTS * m);
    }
}

/* K_i0 = -K_in of two positions 0 and n = LAST */
static void opposed_blocks(hobe_real *K)
{
    for (int i = 1; i < V; i++) {
        hobe_real *to = K + 9 * HOBE_PARTS * hobe_pair(i, 0);
        if (i < LAST) {
            const hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(LAST, i);
            for (int a = 0; a < 3; a++) {
                for (int b = 0; b < 3; b++) {
                    to[(3 * a + b) * HOBE_PARTS] = zero - k[(3 * b + a) * HOBE_PARTS];
                }
            }
        }
        if (i >= LAST) {
            const hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(i, LAST);
            for (int a = 0; a < 3; a++) {
                for (int b = 0; b < 3; b++) {
                    to[(3 * a + b) * HOBE_PARTS] = zero - k[(3 * a + b) * HOBE_PARTS];
                }
            }
        }
    }
    for (int e = 0; e < 9; e++) {
        K[e * HOBE_PARTS] = K[(9 * hobe_pair(LAST, LAST) + e) * HOBE_PARTS];
    }
}

/* K from the rows */
static void finish(const hobe_real *Q, const hobe_real *sym, hobe_real *skew, hobe_real *K)
{
    for (int i = OPPOSED; i < V; i++) {
        for (int a = 0; a < 3; a++) {
            skew[3 * hobe_pair(i, i) + a] = zero;
        }
    }
    blocks(Q, sym, skew, K);
    if (OPPOSED) {
        opposed_blocks(K);
    }
}

/* P_I = dW/dD_I = sum_J Q_IJ D_J */
static void section_force(const hobe_real *Q, const hobe_real *D, hobe_real *P)
{
    for (int i = 0; i < S; i++) {
        for (int a = 0; a < 3; a++) {
            P[3 * i + a] = zero;
        }
        for (int j = 0; j < i; j++) {
            const hobe_real t = Q[hobe_pair(i, j)];
            for (int a = 0; a < 3; a++) {
                P[3 * i + a] += t * D[3 * j + a];
            }
        }
        for (int j = i; j < S; j++) {
            const hobe_real t = Q[hobe_pair(j, i)];
            for (int a = 0; a < 3; a++) {
                P[3 * i + a] += t * D[3 * j + a];
            }
        }
    }
}

/* f = dU/dq, eq. 27, for one part of a batch */
static void force_part(const struct hobe_invariants *inv, const hobe_real *q0, const hobe_real *u,
                       hobe_real *f)
{
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S], gamma[GRAMS], Q[GRAMS];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++) {
        f[i * HOBE_PARTS] = zero;
    }
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        column_differences(sectional, B, U, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, Q);
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        section_force(Q, B, U);
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
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S], gamma[GRAMS], Q[GRAMS];
    gather(q0, x0);
    gather(u, x);
    hobe_real sum = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        column_differences(sectional, B, U, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, Q);
        hobe_real w = zero;
        for (int p = 0; p < GRAMS; p++) {
            const int row = hobe_pair(sectional->pair_t[p], sectional->pair_v[p]);
            w += gamma[p] * Q[row];
        }
        const double half = 0.5 * inv->wx[g];
        sum += half * w;
    }
    energy[0] = sum;
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

/* f = T(a; b, c): Q of the Gram entries of b and c in polar form, applied to D(a) */
static void trilinear_part(const struct hobe_invariants *inv, const hobe_real *qa,
                           const hobe_real *qb, const hobe_real *qc, hobe_real *f)
{
    hobe_real xa[3 * V];
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S], gamma[GRAMS], Q[GRAMS];
    gather(qa, xa);
    gather(qb, x0);
    gather(qc, x);
    for (int i = 0; i < 3 * V; i++) {
        f[i * HOBE_PARTS] = zero;
    }
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        polar(N, Nx, x0, x, B, U);
        column_differences(sectional, B, U, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, Q);
        section_vectors(N, Nx, xa, B);
        section_force(Q, B, U);
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

/* T = the rows (I, J) of station g: Q[GRAMS], symmetric[GRAMS][6], skew[GRAMS][3]; X: scratch */
static void station_rows(const struct hobe_invariants *inv, int g, const hobe_real *x0,
                         const hobe_real *x, hobe_real *X, hobe_real *T)
{
    hobe_real B[3 * S], U[3 * S], *Z = X + 6 * GRAMS;
    hobe_real *sym = T + GRAMS, *skew = T + 7 * GRAMS;
    const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
    const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
    section_vectors(N, Nx, x0, B);
    section_vectors(N, Nx, x, U);
    for (int i = 0; i < 3 * S; i++) {
        B[i] += 0.5 * U[i];
    }
    column_differences(sectional, B, U, X);
    /* D = D0 + U */
    for (int i = 0; i < 3 * S; i++) {
        B[i] += 0.5 * U[i];
    }
    H = row_stress(sectional, H, inv->symmetry, X, T);
    products(sectional, B, X, Z);
    H = row_symmetric(sectional, H, inv->symmetry, X, sym);
    row_skew(sectional, H, inv->symmetry, Z, skew);
    for (int i = 0; i < S; i++) {
        for (int a = 0; a < 3; a++) {
            skew[3 * hobe_pair(i, i) + a] = zero;
        }
    }
}

/* T + s T' and T - s T' of the rows T of a station and T' = W of its mirror image */
static void even_and_odd(hobe_real *T, hobe_real *W)
{
    for (int i = 0; i < S; i++) {
        for (int j = 0; j < i + 1; j++) {
            const int r = hobe_pair(i, j);
            const int along = (i < M) == (j < M);
            hobe_real *plus = along ? T : W, *minus = along ? W : T;
            for (int e = 0; e < 10; e++) {
                const int at = e < 1 ? r : e < 7 ? GRAMS + 6 * r + e - 1 : 7 * GRAMS + 3 * r + e - 7;
                const hobe_real sum = T[at] + W[at], less = T[at] - W[at];
                plus[at] = sum;
                minus[at] = less;
            }
        }
    }
}

/* Q and K of the rows of nodal vectors from the rows T of stations, even and odd parts: of a
 * row and its mirror image the sum of what they share, then that of what they differ by */
static void nodal_blocks(const struct hobe_invariants *inv, const hobe_real *T, hobe_real *Q,
                         hobe_real *K)
{
    const int last = MIRRORED ? (inv->stations - 1) / 2 : inv->stations - 1;
    for (int o = 0; o < IMAGES + ALONE; o++) {
        const int v = lead[2 * o];
        const int u = lead[2 * o + 1];
        const int m = hobe_pair(v, u);
        const int n = symmetric(nodal->mirror[v], nodal->mirror[u]);
        const int k = mode[v];
        const int l = mode[u];
        const int parts = 1 + (o < IMAGES);
        const int p0 = symmetric(k, l);
        const int p1 = symmetric(k, M - 1 + l);
        const int p2 = symmetric(M - 1 + k, l);
        const int p3 = symmetric(M - 1 + k, M - 1 + l);
        const double side = k < l ? -1.0 : 1.0;
        hobe_real x[20], y[10];
        for (int z = 0; z < parts; z++) {
            const int part = odd_of[v] ^ odd_of[u] ^ z;
            const int turned = part ^ (nodal->mirror[v] < nodal->mirror[u]);
            hobe_real s0 = zero, s1 = zero, s2 = zero, s3 = zero, s4 = zero;
            hobe_real s5 = zero, s6 = zero, s7 = zero, s8 = zero, s9 = zero;
            for (int g = 0; g < last + 1; g++) {
                const int image = inv->stations - 1 - g;
                const hobe_real *t = T + 10 * GRAMS * (part ? image : g);
                const hobe_real *w = T + 10 * GRAMS * (turned ? image : g);
                const double *c = inv->section + AXIAL * g + 4 * part +
                                  8 * (A * axial_of[v] + axial_of[u]);
                const double *d = c + 4 * (turned - part);
                const double d0 = side * d[0], d1 = d[1], d2 = d[2], d3 = side * d[3];
                s0 += c[0] * t[p0];
                s1 += c[0] * t[GRAMS + 6 * p0 + 0];
                s2 += c[0] * t[GRAMS + 6 * p0 + 1];
                s3 += c[0] * t[GRAMS + 6 * p0 + 2];
                s4 += c[0] * t[GRAMS + 6 * p0 + 3];
                s5 += c[0] * t[GRAMS + 6 * p0 + 4];
                s6 += c[0] * t[GRAMS + 6 * p0 + 5];
                s7 += d0 * w[7 * GRAMS + 3 * p0 + 0];
                s8 += d0 * w[7 * GRAMS + 3 * p0 + 1];
                s9 += d0 * w[7 * GRAMS + 3 * p0 + 2];
                if (l > 0) {
                    s0 += c[1] * t[p1];
                    s1 += c[1] * t[GRAMS + 6 * p1 + 0];
                    s2 += c[1] * t[GRAMS + 6 * p1 + 1];
                    s3 += c[1] * t[GRAMS + 6 * p1 + 2];
                    s4 += c[1] * t[GRAMS + 6 * p1 + 3];
                    s5 += c[1] * t[GRAMS + 6 * p1 + 4];
                    s6 += c[1] * t[GRAMS + 6 * p1 + 5];
                    s7 -= d1 * w[7 * GRAMS + 3 * p1 + 0];
                    s8 -= d1 * w[7 * GRAMS + 3 * p1 + 1];
                    s9 -= d1 * w[7 * GRAMS + 3 * p1 + 2];
                }
                if (k > 0) {
                    s0 += c[2] * t[p2];
                    s1 += c[2] * t[GRAMS + 6 * p2 + 0];
                    s2 += c[2] * t[GRAMS + 6 * p2 + 1];
                    s3 += c[2] * t[GRAMS + 6 * p2 + 2];
                    s4 += c[2] * t[GRAMS + 6 * p2 + 3];
                    s5 += c[2] * t[GRAMS + 6 * p2 + 4];
                    s6 += c[2] * t[GRAMS + 6 * p2 + 5];
                    s7 += d2 * w[7 * GRAMS + 3 * p2 + 0];
                    s8 += d2 * w[7 * GRAMS + 3 * p2 + 1];
                    s9 += d2 * w[7 * GRAMS + 3 * p2 + 2];
                }
                if (k > 0 && l > 0) {
                    s0 += c[3] * t[p3];
                    s1 += c[3] * t[GRAMS + 6 * p3 + 0];
                    s2 += c[3] * t[GRAMS + 6 * p3 + 1];
                    s3 += c[3] * t[GRAMS + 6 * p3 + 2];
                    s4 += c[3] * t[GRAMS + 6 * p3 + 3];
                    s5 += c[3] * t[GRAMS + 6 * p3 + 4];
                    s6 += c[3] * t[GRAMS + 6 * p3 + 5];
                    s7 += d3 * w[7 * GRAMS + 3 * p3 + 0];
                    s8 += d3 * w[7 * GRAMS + 3 * p3 + 1];
                    s9 += d3 * w[7 * GRAMS + 3 * p3 + 2];
                }
            }
            x[10 * z + 0] = s0;
            x[10 * z + 1] = s1;
            x[10 * z + 2] = s2;
            x[10 * z + 3] = s3;
            x[10 * z + 4] = s4;
            x[10 * z + 5] = s5;
            x[10 * z + 6] = s6;
            x[10 * z + 7] = s7;
            x[10 * z + 8] = s8;
            x[10 * z + 9] = s9;
            if (v == u) {
                for (int a = 0; a < 3; a++) {
                    x[10 * z + 7 + a] = zero;
                }
            }
        }
        if (parts == 1) {
            Q[m] = x[0];
            block(x + 1, x + 7, x, K + 9 * HOBE_PARTS * m);
        }
        if (parts == 2) {
            for (int e = 0; e < 10; e++) {
                y[e] = x[e] + x[10 + e];
            }
            Q[m] = y[0];
            block(y + 1, y + 7, y, K + 9 * HOBE_PARTS * m);
            for (int e = 0; e < 10; e++) {
                y[e] = x[e] - x[10 + e];
            }
            Q[n] = y[0];
            block(y + 1, y + 7, y, K + 9 * HOBE_PARTS * n);
        }
    }
    if (OPPOSED) {
        opposed_blocks(K);
    }
}

/* f = dU/dq and K = df/dq, eq. 28, for one part of a batch */
static void tangent_part(const struct hobe_invariants *inv, const hobe_real *q0,
                         const hobe_real *u, hobe_real *f, hobe_real *K, hobe_real *scratch)
{
    hobe_real x0[3 * V], x[3 * V], *Q = scratch, *X = Q + BLOCKS;
    hobe_real *T = X + 9 * GRAMS - 3 * S;
    gather(q0, x0);
    gather(u, x);
    for (int g = 0; g < inv->stations; g++) {
        station_rows(inv, g, x0, x, X, T + 10 * GRAMS * g);
    }
    const int couples = MIRRORED ? inv->stations / 2 : 0;
    for (int g = 0; g < couples; g++) {
        even_and_odd(T + 10 * GRAMS * g, T + 10 * GRAMS * (inv->stations - 1 - g));
    }
    nodal_blocks(inv, T, Q, K);
    /* D = D0 + U */
    for (int i = 0; i < 3 * V; i++) {
        x[i] += x0[i];
    }
    tensor_force(Q, x, f);
}

/* y[COLUMNS][3], the sums and differences about mid-length of nodal vectors x[V][3] */
static void column_vectors(const hobe_real *x, hobe_real *y)
{
    for (int t = 0; t < COLUMNS; t++) {
        for (int a = 0; a < 3; a++) {
            y[3 * t + a] = x[3 * left[t] + a] + sign[t] * x[3 * right[t] + a];
        }
        if (shifted[t]) {
            for (int a = 0; a < 3; a++) {
                y[3 * t + a] -= x[3 * LAST + a];
            }
        }
    }
}

/* The current x[V][3] = q0 + u, its columns y, gamma, and Q[row]; returns the rest of H */
static const double *tensor_state(const struct hobe_invariants *inv, const hobe_real *q0,
                                  const hobe_real *u, hobe_real *x, hobe_real *y, hobe_real *gamma,
                                  hobe_real *Q)
{
    hobe_real x0[3 * V], B[3 * COLUMNS];
    gather(q0, x0);
    gather(u, x);
    /* gamma from the mean of before and after, and the change: no cancellation */
    for (int i = 0; i < 3 * V; i++) {
        x0[i] += 0.5 * x[i];
    }
    column_vectors(x0, B);
    column_vectors(x, y);
    column_differences(nodal, B, y, gamma);
    for (int i = 0; i < 3 * V; i++) {
        x[i] = x0[i] + 0.5 * x[i];
    }
    for (int i = 0; i < 3 * COLUMNS; i++) {
        y[i] = B[i] + 0.5 * y[i];
    }
    const double *H;
    H = row_stress(nodal, inv->tensor, inv->symmetry, gamma, Q);
    images(Q);
    return H;
}

/* f = dU/dq, eq. 27, for one part of a batch */
static void tensor_force_part(const struct hobe_invariants *inv, const hobe_real *q0,
                              const hobe_real *u, hobe_real *f, hobe_real *scratch)
{
    hobe_real x[3 * V], y[3 * COLUMNS], *gamma = scratch, *Q = gamma + PAIRS;
    tensor_state(inv, q0, u, x, y, gamma, Q);
    tensor_force(Q, x, f);
}

/* f as in tensor_force_part and K = df/dq, eq. 28 */
static void tensor_tangent_part(const struct hobe_invariants *inv, const hobe_real *q0,
                                const hobe_real *u, hobe_real *f, hobe_real *K, hobe_real *scratch)
{
    hobe_real x[3 * V], y[3 * COLUMNS];
    hobe_real *X = scratch, *Z = X + 6 * PAIRS, *Q = Z + 3 * (PAIRS - COLUMNS);
    hobe_real *sym = Q + BLOCKS, *skew = sym + 6 * BLOCKS;
    const double *H;
    H = tensor_state(inv, q0, u, x, y, X, Q);
    tensor_force(Q, x, f);
    products(nodal, y, X, Z);
    H = row_symmetric(nodal, H, inv->symmetry, X, sym);
    row_skew(nodal, H, inv->symmetry, Z, skew);
    finish(Q, sym, skew, K);
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
    for (int h = 0; h < HOBE_PARTS; h++) {
        const hobe_real *reference = (const hobe_real *)q0 + h, *moved = (const hobe_real *)u + h;
        if (inv->tensor)
            tensor_force_part(inv, reference, moved, (hobe_real *)f + h, (hobe_real *)scratch);
        else
            force_part(inv, reference, moved, (hobe_real *)f + h);
    }
}

static void tangent(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                    hobe_lanes *f, hobe_lanes *K, hobe_lanes *scratch)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        (inv->tensor ? tensor_tangent_part : tangent_part)(
            inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h,
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

/* What a station keeps of one order of a series: its section vectors D and its stresses Q. */
enum { KEPT = 3 * S + GRAMS };

static void add_to(hobe_real *sum, const hobe_real *x, int n)
{
    for (int i = 0; i < n; i++)
        sum[i] += x[i];
}

/* The Gram entries of order k > 1 that D_1 .. D_(k-1) make: sum of D_i . D_j, i + j = k.  The
 * orders at a station are `order` apart. */
static void gram_of_order(int k, const hobe_real *at, ptrdiff_t order, hobe_real *gamma)
{
    hobe_real weighted[3 * S], more[GRAMS];
    for (int p = 0; p < GRAMS; p++)
        gamma[p] = zero;
    for (int i = 1; i <= k / 2; i++) {
        const double weight = 2 * i < k ? 1.0 : 0.5;
        for (int a = 0; a < 3 * S; a++)
            weighted[a] = weight * at[i * order + a];
        column_differences(sectional, weighted, at + (k - i) * order, more);
        add_to(gamma, more, GRAMS);
    }
}

/* P = sum of Q_i D_(k-i), i = 1 .. k. */
static void force_of_order(int k, const hobe_real *at, ptrdiff_t order, hobe_real *P)
{
    hobe_real more[3 * S];
    for (int i = 0; i < 3 * S; i++)
        P[i] = zero;
    for (int i = 1; i <= k; i++) {
        section_force(at + i * order + 3 * S, at + (k - i) * order, more);
        add_to(P, more, 3 * S);
    }
}

/* Q += the stress of the Gram entries of B and D, what completes an order: with D_0 of the state
 * and D_m, m > 0; or with B = D0 + U/2 and U of the state itself. */
static void add_stress(const double *H, int symmetry, const hobe_real *B, const hobe_real *D,
                       hobe_real *Q)
{
    hobe_real gamma[GRAMS], more[GRAMS];
    column_differences(sectional, B, D, gamma);
    row_stress(sectional, H, symmetry, gamma, more);
    add_to(Q, more, GRAMS);
}

/* The first order: D_0 = D0 + U of the state, from the reference x0, and its Q_0. */
static void begin_series(const double *N, const double *Nx, const double *H, int symmetry,
                         const hobe_real *x0, hobe_real *at)
{
    hobe_real D0[3 * S], B[3 * S];
    section_vectors(N, Nx, x0, D0);
    for (int i = 0; i < 3 * S; i++)
        B[i] = D0[i] + 0.5 * at[i];
    for (int i = 3 * S; i < KEPT; i++)
        at[i] = zero;
    add_stress(H, symmetry, B, at, at + 3 * S);
    add_to(at, D0, 3 * S);
}

static void series_part(const struct hobe_invariants *inv, int k, const hobe_real *q0,
                        const hobe_real *u, hobe_real *table, hobe_real *f)
{
    const ptrdiff_t order = (ptrdiff_t)HOBE_PARTS * inv->stations * KEPT;
    hobe_real x0[3 * V], x[3 * V], P[3 * S], gamma[GRAMS];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        hobe_real *at = table + KEPT * g, *next = at + k * order;
        section_vectors(N, Nx, x, next - order);
        if (k > 1)
            add_stress(H, inv->symmetry, at, next - order, next - order + 3 * S);
        else
            begin_series(N, Nx, H, inv->symmetry, x0, at);
        gram_of_order(k, at, order, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, next + 3 * S);
        force_of_order(k, at, order, P);
        for (int v = 0; v < V; v++)
            for (int a = 0; a < 3; a++) {
                const int m = mode[v];
                f[(3 * v + a) * HOBE_PARTS] += inv->wx[g] * Nx[v] * P[3 * m + a];
                if (m > 0)
                    f[(3 * v + a) * HOBE_PARTS] += inv->wx[g] * N[v] * P[3 * (M - 1 + m) + a];
            }
    }
}

static void series(const struct hobe_invariants *inv, int k, const hobe_lanes *q0,
                   const hobe_lanes *u, hobe_lanes *table, hobe_lanes *f)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        series_part(inv, k, (const hobe_real *)q0 + h, (const hobe_real *)u + h,
                    (hobe_real *)table + (ptrdiff_t)h * inv->stations * KEPT, (hobe_real *)f + h);
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
static const struct hobe_plan_cost section_cost[HOBE_SYMMETRIES] = {
    {3220737, 30859279, 908226}, {1648577, 15676239, 454530}, {1649337, 15679879, 454626},
    {862877, 8086539, 227730}, {1649337, 15679879, 454626}, {862877, 8086539, 227730},
    {866737, 8111279, 228426}, {471577, 4302239, 114630},
};
static const struct hobe_plan_cost tensor_cost[HOBE_SYMMETRIES] = {
    {0, 0, 0}, {1809919, 17431561, 2593917}, {0, 0, 0}, {922159, 8768773, 1298079}, {0, 0, 0},
    {922159, 8768773, 1298079}, {0, 0, 0}, {479279, 4444013, 651099},
};

extern const struct hobe_kernel HOBE_KERNEL(MGD30d2);
const struct hobe_kernel HOBE_KERNEL(MGD30d2) = {
    .abi = 7,
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
    .flops_tangent = 15676239,
    .scratch = 45598,
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
    .axial = AXIAL,
    .symmetry = symmetry,
    .section = section,
    .section_cost = section_cost,
    .tensor = tensor,
    .tensor_cost = tensor_cost,
    .trilinear = trilinear,
    .series = series,
    .strain = strain,
    .warping_strain = warping_strain,
};
