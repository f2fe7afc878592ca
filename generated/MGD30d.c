/* MGD30d: this project: MGD30w3 whose section distorts in torsion
 *
 * Written by `python -m generator`, declaration e3c2506b576e0a92: do not edit.
 * nodes at xi = 0 1/2 1; 37 vectors, 111 degrees of freedom
 * modes 1 y z w wy wz ww w1 v1y v1z v2y v2z
 * the energy is exact with 5 Gauss points on the axis
 * vectors (mode@node, ' for d/dx): 1@1 1'@1 y@1 z@1 w@1 wy@1 wz@1 ww@1 w1@1 v1y@1 v1z@1 v2y@1
 *     v2z@1 y@2 z@2 w@2 wy@2 wz@2 ww@2 w1@2 v1y@2 v1z@2 v2y@2 v2z@2 1@3 1'@3 y@3 z@3 w@3 wy@3
 *     wz@3 ww@3 w1@3 v1y@3 v1z@3 v2y@3 v2z@3
 * operations per element: force 419652, force and tangent 3863061, energy 403762
 * from station to station, symmetric in nothing: 799812, 7482501
 * from station to station, symmetric in x: 419652, 3863061
 * from station to station, symmetric in y: 421812, 3876381
 * from station to station, symmetric in x y: 230652, 2060001
 * from station to station, symmetric in z: 421812, 3876381
 * from station to station, symmetric in x z: 230652, 2060001
 * from station to station, symmetric in y z: 238132, 2116861
 * from station to station, symmetric in x y z: 138812, 1180241
 * as one tensor, symmetric in x: 464749, 4376761
 * as one tensor, symmetric in x y: 241645, 2218297
 * as one tensor, symmetric in x z: 241645, 2218297
 * as one tensor, symmetric in x y z: 131949, 1154169
 */
#include "kernel.h"

#if HOBE_KERNEL_ABI != 8
#error Regenerate: this file was written for another kernel ABI
#endif

enum {
    V = 37,   /* nodal vectors */
    M = 12,   /* section modes */
    S = 23,   /* section vectors d_k', d_k */
    NA = 78,  /* Gram pairs d_k'.d_l' */
    NN = 144, /* normal block: those and d_k.d_l */
    NS = 132, /* shear block: d_k'.d_l */
    A = 7,    /* distinct axial functions */
};

static const hobe_real zero = {0};

/* Of each nodal vector: mode; whether it is a position; axial function. */
static const unsigned char mode[V] = {
    0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0, 0, 1, 2, 3,
    4, 5, 6, 7, 8, 9, 10, 11,
};
static const unsigned char position[V] = {
    1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0,
};
static const unsigned char axial_of[V] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6,
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
    0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0,
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
 * reference gradient, H = sum_I U_I g_I = du/dX: written with F0 + H/2.  Asked for a point at a
 * time, so small rather than fast. */
static __attribute__((cold)) void green_lagrange(const double g[3][S], const double D0[S][3],
                                                 const double U[S][3], double *E)
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

#ifdef __AVX512F__
enum { TALL = 1 }; /* 32 registers, for sums over more rows at a time */
#else
enum { TALL = 0 };
#endif

/* Rows and columns of products (generator/products.py). */
struct products {
    int columns, pairs;         /* vectors, and pairs t >= v of those */
    const unsigned char *mirror;          /* of each vector of a row, its mirror image */
    const unsigned char *pair_t, *pair_v; /* first those with t = v, then by class of parities */
    const short *first_pair, *first_cross; /* of each class; without those with t = v */
    const short *row, *first_row;          /* rows of Q and of the symmetric part, by class */
    const short *skew_row, *first_skew_row;
};

/* ---- eqs. 27 and 28 as products with constant matrices (generator/products.py) ---- */

enum {
    COLUMNS = 36,     /* sums and differences of nodal vectors */
    PAIRS = 666,      /* of those */
    BLOCKS = 703,     /* of the tangent, pairs of nodal vectors: a row each */
    CLASSES = 8,      /* of parities: 1 odd in x, 2 odd in y, 4 odd in z */
    LAST = 24,        /* the last position */
    OPPOSED = 1,      /* whether it is one of two: rows with the first are less those with it */
    MIRRORED = 1,     /* whether there are mirror images */
    GRAMS = 276,      /* pairs of section vectors */
    AXIAL = 392,      /* weights of a station for axial functions */
    MOST_PAIRS = 666, /* of either kind */
};

/* of each section vector: 1 odd in x, 2 odd in y, 4 odd in z */
static const unsigned char parity[] = {
    0,2,4,6,2,4,6,6,4,2,2,4,3,5,7,3,5,7,7,5,3,3,5,
};
/* of each nodal vector: whether its image has the other sign */
static const unsigned char odd_of[] = {
    0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,1,0,0,0,0,0,0,0,0,0,0,0,
};
/* of each column: q_left + sign q_right, less the last position where shifted; its
 * function is share (N_left + sign N_right) */
static const short left[] = {
    0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,14,15,16,17,18,19,20,21,22,23,
};
static const short right[] = {
    24,25,25,26,26,27,27,28,28,29,29,30,30,31,31,32,32,33,33,34,34,35,35,36,36,13,14,15,16,17,
    18,19,20,21,22,23,
};
static const short shifted[] = {
    0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,
};
static const double sign[] = {
    -1,-1,1,1,-1,1,-1,1,-1,1,-1,1,-1,1,-1,1,-1,1,-1,1,-1,1,-1,1,-1,1,1,1,1,1,1,1,1,1,1,1,
};
static const double share[] = {
    1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,
    1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,
    1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 2.0,1.0 / 4.0,1.0 / 4.0,
    1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,1.0 / 4.0,
};
/* nodal vectors in the order of their modes, those with rows */
static const unsigned char by_mode[] = {
    1,24,25,2,13,26,3,14,27,4,15,28,5,16,29,6,17,30,7,18,31,8,19,32,9,20,33,10,21,34,11,22,35,
    12,23,36,
};
/* where each mode begins */
static const unsigned char first_of[] = {
    0,3,6,9,12,15,18,21,24,27,30,33,36,
};
/* by symmetry: how many classes a row meets, and its own class times which */
static const short merged[] = {
    8,4,4,2,4,2,2,1,
};
static const short merged_with[] = {
    0,1,2,3,4,5,6,7,0,2,4,6,0,0,0,0,0,1,4,5,0,0,0,0,0,4,0,0,0,0,0,0,0,1,2,3,0,0,0,0,0,2,0,0,0,0,
    0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,
};
/* products of nodal vectors */
static const unsigned char nodal_mirror[] = {
    24,25,26,27,28,29,30,31,32,33,34,35,36,13,14,15,16,17,18,19,20,21,22,23,24,1,2,3,4,5,6,7,8,
    9,10,11,12,
};
static const unsigned char nodal_pair_t[] = {
    0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,
    34,35,2,9,10,11,12,13,14,15,15,16,16,17,17,18,18,19,19,20,20,21,21,21,22,22,22,23,23,23,24,
    24,24,25,25,25,25,26,26,26,26,27,27,27,28,28,28,28,28,29,29,29,29,29,30,30,30,30,31,31,31,
    31,31,32,32,32,32,32,32,33,33,33,33,33,33,34,34,34,34,34,34,34,35,35,35,35,35,35,35,1,2,4,6,
    8,9,10,10,11,12,12,13,14,14,15,15,16,16,16,17,17,18,18,18,19,19,20,20,20,21,21,21,22,22,22,
    22,23,23,23,24,24,24,24,25,25,25,25,26,26,26,26,27,27,27,28,28,28,28,29,29,29,29,30,30,30,
    31,31,31,32,32,32,32,33,33,33,33,34,34,34,34,35,35,35,35,3,4,4,7,8,9,10,10,11,12,13,13,14,
    14,15,15,16,16,17,17,17,18,18,18,19,20,20,21,22,22,23,23,23,24,24,24,25,26,26,26,27,27,27,
    27,27,28,29,29,29,29,30,30,30,30,30,30,31,31,31,31,31,31,32,32,32,32,32,32,33,34,35,35,35,
    35,35,35,3,3,4,7,8,9,9,10,11,12,13,13,14,14,15,15,16,16,17,17,17,18,18,18,19,19,20,21,21,22,
    23,23,23,24,24,24,25,25,26,26,26,27,27,27,27,28,28,29,29,29,30,30,30,30,31,31,31,31,32,32,
    32,33,33,34,34,35,35,35,5,6,6,7,8,9,10,11,12,12,13,13,14,14,15,15,16,16,17,18,18,19,19,19,
    20,20,20,21,21,21,22,22,22,23,24,24,25,25,25,26,27,27,27,27,27,28,28,28,28,29,30,30,30,30,
    30,30,31,31,31,31,31,31,32,33,33,33,33,33,33,34,34,34,34,34,34,35,5,5,6,7,8,9,10,11,11,12,
    13,13,14,14,15,15,16,16,17,17,18,19,19,19,20,20,20,21,21,21,22,22,22,23,23,24,25,25,25,26,
    26,27,27,27,27,28,28,28,29,29,30,30,30,30,31,31,31,31,32,32,33,33,33,34,34,34,35,35,5,6,7,8,
    8,9,10,11,11,12,12,13,14,14,15,16,16,17,17,18,18,19,19,19,20,20,20,21,21,21,22,22,22,23,23,
    23,23,24,24,24,24,25,25,25,25,26,26,26,26,26,27,28,28,28,28,28,29,29,29,29,29,29,30,31,32,
    32,32,32,32,32,33,33,33,33,33,33,33,34,34,34,34,34,34,34,35,35,35,35,35,35,35,35,5,6,7,7,8,
    9,10,11,11,12,12,13,13,14,15,15,16,17,17,18,18,19,19,19,20,20,20,21,21,21,22,22,22,23,23,23,
    23,24,24,24,24,25,25,25,25,26,26,26,26,27,27,28,28,28,28,29,29,29,29,30,30,31,31,32,32,32,
    32,33,33,33,33,34,34,34,34,35,35,35,35,
};
static const unsigned char nodal_pair_v[] = {
    0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,
    34,35,0,3,4,5,6,7,8,7,13,8,14,5,11,6,12,3,9,4,10,3,9,19,4,10,20,5,11,17,6,12,18,3,9,19,21,5,
    11,17,23,7,13,15,3,9,19,21,25,5,11,17,23,26,7,13,15,27,7,13,15,27,30,5,11,17,23,26,29,3,9,
    19,21,25,28,3,9,19,21,25,28,33,5,11,17,23,26,29,32,0,1,3,5,7,4,3,9,6,5,11,8,7,13,8,14,7,13,
    15,6,12,5,11,17,4,10,3,9,19,4,10,20,3,9,19,21,6,12,18,5,11,17,23,4,10,20,22,6,12,18,24,8,14,
    16,4,10,20,22,6,12,18,24,8,14,16,8,14,16,6,12,18,24,4,10,20,22,4,10,20,22,6,12,18,24,1,0,2,
    5,6,1,0,2,7,8,5,11,6,12,5,11,6,12,7,13,15,8,14,16,1,0,2,1,0,2,7,13,15,8,14,16,1,7,13,15,5,
    11,17,23,26,1,7,13,15,27,5,11,17,23,26,29,5,11,17,23,26,29,7,13,15,27,30,31,1,1,7,13,15,27,
    30,31,0,2,1,6,5,0,2,1,8,7,6,12,5,11,6,12,5,11,8,14,16,7,13,15,0,2,1,0,2,1,8,14,16,7,13,15,0,
    2,8,14,16,6,12,18,24,0,2,8,14,16,6,12,18,24,6,12,18,24,8,14,16,0,2,0,2,8,14,16,1,0,2,3,4,7,
    8,1,0,2,3,9,4,10,3,9,4,10,1,0,2,7,13,15,8,14,16,7,13,15,8,14,16,1,0,2,7,13,15,1,3,9,19,21,
    25,7,13,15,27,1,3,9,19,21,25,28,3,9,19,21,25,28,1,7,13,15,27,30,31,7,13,15,27,30,31,1,0,2,1,
    4,3,8,7,0,2,1,4,10,3,9,4,10,3,9,0,2,1,8,14,16,7,13,15,8,14,16,7,13,15,0,2,1,8,14,16,0,2,4,
    10,20,22,8,14,16,0,2,4,10,20,22,4,10,20,22,0,2,8,14,16,8,14,16,0,2,3,4,1,0,2,5,6,3,9,4,10,1,
    0,2,1,0,2,3,9,4,10,5,11,17,6,12,18,5,11,17,6,12,18,3,9,19,21,4,10,20,22,5,11,17,23,3,9,19,
    21,25,1,5,11,17,23,26,3,9,19,21,25,28,1,1,3,9,19,21,25,28,5,11,17,23,26,29,32,5,11,17,23,26,
    29,32,3,9,19,21,25,28,33,34,4,3,0,2,1,6,5,4,10,3,9,0,2,1,0,2,1,4,10,3,9,6,12,18,5,11,17,6,
    12,18,5,11,17,4,10,20,22,3,9,19,21,6,12,18,24,4,10,20,22,0,2,6,12,18,24,4,10,20,22,0,2,0,2,
    4,10,20,22,6,12,18,24,6,12,18,24,4,10,20,22,
};
static const short nodal_first_pair[] = {
    0,123,207,283,351,427,495,587,666,
};
static const short nodal_first_cross[] = {
    36,123,207,283,351,427,495,587,666,
};
static const short nodal_row[] = {
    2,5,9,14,17,20,24,27,32,35,40,43,44,48,51,54,57,60,65,68,71,76,77,81,84,87,90,93,96,101,102,
    104,108,111,114,117,119,124,127,128,135,138,141,146,147,149,152,156,159,162,165,167,170,175,
    178,179,186,189,194,197,198,205,208,209,213,216,219,222,224,227,230,233,236,241,242,244,247,
    252,255,258,263,264,266,269,274,275,279,282,285,288,290,293,296,299,301,324,326,353,356,361,
    362,381,384,387,390,410,413,414,440,445,446,471,474,477,503,504,536,570,573,605,606,641,678,
    349,350,364,367,372,373,377,392,395,398,401,405,421,424,425,434,437,448,451,456,457,461,464,
    468,479,482,485,488,492,495,500,511,514,515,524,527,532,535,543,546,547,556,559,560,564,567,
    575,578,581,584,588,591,594,597,600,608,611,616,617,621,624,629,632,635,640,643,646,651,652,
    656,659,664,665,669,672,675,680,683,686,689,693,696,699,702,13,25,31,34,39,42,49,52,53,82,
    85,86,109,112,113,123,126,129,132,134,157,160,161,168,174,177,180,183,185,188,193,196,199,
    202,204,207,214,217,218,225,228,229,280,283,284,291,294,295,338,341,346,347,352,375,376,382,
    385,386,412,415,418,436,459,460,472,473,505,508,537,540,596,619,620,631,654,655,4,16,56,67,
    92,137,232,254,302,305,310,311,313,316,321,322,327,330,335,336,393,396,397,409,420,423,426,
    429,433,469,480,483,484,493,499,502,510,513,516,519,523,526,531,534,542,545,548,551,555,558,
    565,568,569,576,579,580,589,592,593,670,673,674,681,684,685,694,697,698,12,19,30,33,38,41,
    59,62,63,70,73,74,95,98,99,122,125,130,131,133,140,143,144,151,173,176,181,182,184,187,192,
    195,200,201,203,206,235,238,239,246,249,250,257,260,261,268,271,272,339,342,345,348,355,358,
    359,379,402,403,411,416,417,442,443,466,489,490,506,507,538,539,562,585,586,667,690,691,7,
    22,46,79,106,154,211,277,303,306,309,312,314,317,320,323,328,331,334,337,366,369,370,408,
    419,422,427,428,432,439,450,453,454,463,498,501,509,512,517,518,522,525,530,533,541,544,549,
    550,554,557,599,602,603,610,613,614,623,626,627,634,637,638,645,648,649,658,661,662,8,18,23,
    26,47,50,58,61,64,69,72,75,80,83,88,89,94,97,100,103,107,110,115,116,118,139,142,145,148,
    150,155,158,163,164,166,169,212,215,220,221,223,226,234,237,240,243,245,248,251,256,259,262,
    265,267,270,273,278,281,286,287,289,292,297,298,340,343,344,354,357,360,363,383,388,389,407,
    430,431,441,444,447,475,476,497,520,521,529,552,553,571,572,607,642,11,29,37,121,172,191,
    304,307,308,315,318,319,329,332,333,365,368,371,374,380,391,394,399,400,404,438,449,452,455,
    458,462,467,470,478,481,486,487,491,494,563,566,574,577,582,583,587,590,598,601,604,609,612,
    615,618,622,625,628,633,636,639,644,647,650,653,657,660,663,668,671,676,677,679,682,687,688,
    692,695,700,701,
};
static const short nodal_skew_row[] = {
    17,24,32,40,43,48,51,57,60,68,71,76,81,84,87,149,167,186,205,208,224,227,244,247,266,269,
    274,290,293,296,349,364,367,372,373,392,395,398,401,421,424,425,437,448,451,456,457,468,479,
    482,485,488,500,511,514,515,532,535,543,546,547,564,567,575,578,581,584,597,600,608,611,616,
    617,632,635,640,643,646,651,652,669,672,675,680,683,686,689,93,96,101,102,108,111,114,117,
    124,127,128,138,141,146,147,156,159,162,165,175,178,179,194,197,198,213,216,219,222,233,236,
    241,242,255,258,263,264,279,282,285,288,301,326,353,356,361,362,381,384,387,390,410,413,414,
    440,445,446,461,471,474,477,492,503,504,524,536,556,559,570,573,588,591,605,606,621,624,641,
    656,659,664,678,693,696,699,13,25,31,34,39,42,49,52,53,82,85,86,92,134,137,168,185,188,204,
    207,225,228,229,232,254,291,294,295,302,305,310,311,327,330,335,336,376,393,396,397,409,420,
    423,426,429,460,469,480,483,484,499,502,510,513,516,519,531,534,542,545,548,551,565,568,569,
    576,579,580,620,655,670,673,674,681,684,685,4,16,56,67,109,112,113,123,126,129,132,157,160,
    161,174,177,180,183,193,196,199,202,214,217,218,280,283,284,313,316,321,322,338,341,346,347,
    352,375,382,385,386,412,415,418,433,436,459,472,473,493,505,508,523,526,537,540,555,558,589,
    592,593,596,619,631,654,694,697,698,12,19,30,33,38,41,59,62,63,70,73,74,106,133,151,154,184,
    187,203,206,211,246,249,250,268,271,272,277,303,306,309,312,328,331,334,337,366,369,370,403,
    408,419,422,427,428,439,450,453,454,490,498,501,509,512,517,518,530,533,541,544,549,550,586,
    599,602,603,610,613,614,634,637,638,645,648,649,691,7,22,46,79,95,98,99,122,125,130,131,140,
    143,144,173,176,181,182,192,195,200,201,235,238,239,257,260,261,314,317,320,323,339,342,345,
    348,355,358,359,379,402,411,416,417,432,442,443,463,466,489,506,507,522,525,538,539,554,557,
    562,585,623,626,627,658,661,662,667,690,8,18,23,26,47,50,58,61,64,69,72,75,80,83,88,89,118,
    121,150,166,169,172,191,223,226,245,248,251,267,270,273,289,292,297,298,304,307,308,329,332,
    333,365,368,371,374,380,391,394,399,400,431,438,449,452,455,458,467,470,478,481,486,487,521,
    553,563,566,574,577,582,583,598,601,604,609,612,615,618,633,636,639,644,647,650,653,668,671,
    676,677,679,682,687,688,11,29,37,94,97,100,103,107,110,115,116,139,142,145,148,155,158,163,
    164,212,215,220,221,234,237,240,243,256,259,262,265,278,281,286,287,315,318,319,340,343,344,
    354,357,360,363,383,388,389,404,407,430,441,444,447,462,475,476,491,494,497,520,529,552,571,
    572,587,590,607,622,625,628,642,657,660,663,692,695,700,701,
};
static const short nodal_first_skew_row[] = {
    0,87,171,247,315,391,459,551,630,
};
static const struct products nodal[1] = {{ 36, 666, nodal_mirror, nodal_pair_t,
    nodal_pair_v, nodal_first_pair, nodal_first_cross, nodal_row, nodal_first_pair,
    nodal_skew_row, nodal_first_skew_row}};
/* products of section vectors */
static const unsigned char sectional_mirror[] = {
    0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,
};
static const unsigned char sectional_pair_t[] = {
    0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,4,5,6,7,7,8,8,9,9,10,10,10,11,11,
    11,15,16,17,18,18,19,19,20,20,21,21,21,22,22,22,12,12,12,12,13,13,13,13,14,14,14,15,15,15,
    15,16,16,16,16,17,17,17,18,18,18,19,19,19,19,20,20,20,20,21,21,21,21,22,22,22,22,1,3,4,5,6,
    6,7,7,8,8,8,9,10,11,11,11,14,16,17,17,18,18,19,19,19,22,22,22,12,13,13,13,14,14,14,14,15,16,
    16,16,17,17,17,17,18,18,18,18,19,19,19,20,21,22,22,22,2,3,4,5,6,6,7,7,8,9,9,9,10,10,10,11,
    14,15,17,17,18,18,20,20,20,21,21,21,12,12,12,13,14,14,14,14,15,15,15,16,17,17,17,17,18,18,
    18,18,19,20,20,20,21,21,21,22,2,3,4,5,5,6,7,8,8,9,9,9,10,10,10,11,11,11,11,13,15,16,16,19,
    19,20,20,20,21,21,21,22,22,22,22,12,12,12,12,13,13,13,13,14,15,15,15,15,16,16,16,16,17,18,
    19,19,19,19,20,20,20,20,21,21,21,21,22,22,22,22,
};
static const unsigned char sectional_pair_v[] = {
    0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,1,2,3,3,6,2,5,1,4,1,4,9,2,5,8,12,
    13,14,14,17,13,16,12,15,12,15,20,13,16,19,1,4,9,10,2,5,8,11,3,6,7,1,4,9,10,2,5,8,11,3,6,7,3,
    6,7,2,5,8,11,1,4,9,10,1,4,9,10,2,5,8,11,0,2,0,3,2,5,2,5,3,6,7,0,0,3,6,7,13,14,13,16,13,16,
    14,17,18,14,17,18,0,3,6,7,2,5,8,11,0,3,6,7,2,5,8,11,2,5,8,11,3,6,7,0,0,3,6,7,0,1,3,0,1,4,1,
    4,0,3,6,7,3,6,7,0,12,14,12,15,12,15,14,17,18,14,17,18,3,6,7,0,1,4,9,10,3,6,7,0,1,4,9,10,1,4,
    9,10,0,3,6,7,3,6,7,0,1,0,2,1,4,0,0,1,4,2,5,8,2,5,8,1,4,9,10,12,13,12,15,12,15,13,16,19,13,
    16,19,12,15,20,21,2,5,8,11,1,4,9,10,0,2,5,8,11,1,4,9,10,0,0,1,4,9,10,2,5,8,11,2,5,8,11,1,4,
    9,10,
};
static const short sectional_first_pair[] = {
    0,53,94,122,150,178,206,241,276,
};
static const short sectional_first_cross[] = {
    23,53,94,122,150,178,206,241,276,
};
static const short sectional_row[] = {
    0,2,5,9,14,20,27,35,44,54,65,77,90,104,119,135,152,170,189,209,230,252,275,11,17,24,31,34,
    38,41,46,49,56,59,64,68,71,74,132,149,167,185,188,203,206,222,225,243,246,251,266,269,272,
    79,82,87,88,93,96,99,102,108,111,112,121,124,129,130,138,141,144,147,156,159,160,174,177,
    178,192,195,198,201,211,214,219,220,232,235,240,241,255,258,261,264,1,8,10,18,23,26,30,33,
    39,42,43,45,55,69,72,73,118,150,166,169,184,187,204,207,208,267,270,271,78,94,97,98,107,110,
    113,116,120,139,142,143,155,158,161,164,173,176,179,182,193,196,197,210,231,256,259,260,3,7,
    13,15,22,25,29,32,36,48,51,52,58,61,62,66,117,134,165,168,183,186,224,227,228,245,248,249,
    81,84,85,91,106,109,114,115,123,126,127,136,154,157,162,163,172,175,180,181,190,213,216,217,
    234,237,238,253,4,6,12,16,19,21,28,37,40,47,50,53,57,60,63,67,70,75,76,103,133,148,151,202,
    205,223,226,229,244,247,250,265,268,273,274,80,83,86,89,92,95,100,101,105,122,125,128,131,
    137,140,145,146,153,171,191,194,199,200,212,215,218,221,233,236,239,242,254,257,262,263,
};
static const struct products sectional[1] = {{ 23, 276, sectional_mirror, sectional_pair_t,
    sectional_pair_v, sectional_first_pair, sectional_first_cross, sectional_row,
    sectional_first_pair, sectional_row, sectional_first_cross}};

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

/* Which parities the element keeps apart (kernel.h); asked once, so small rather than fast. */
static __attribute__((cold)) int symmetry(const struct hobe_invariants *inv)
{
    int kept = HOBE_SYMMETRIES - 1;
    for (int g = 0; g < (inv->step_n ? inv->stations : 1); g++)
        kept &= ~mixed(inv, g);
    return kept;
}

/* The coefficients c[3] of Q, of the symmetric and of the skew part of the row (i, j) and the
 * column (t, v), of one station or of all. */
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
 * are taken over so many rows at a time as `height` says, down to 1. */
static int place(int rows, int columns, const int *height, int r, int p)
{
    int start = 0;
    while (r >= start + (rows - start) / *height * *height)
        start += (rows - start) / *height * *height, height++;
    const int within = (r - start) % *height;
    return (r - within) * columns + p * *height + within;
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
    static const int height[3][3] = {{4, 2, 1}, {TALL ? 4 : 2, 2, 1}, {4, 2, 1}};
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
    for (int i = 0; i < 3 * S; i++)
        D[i] = zero;
    for (int v = 0; v < V; v++) {
        const int k = mode[v];
        for (int a = 0; a < 3; a++)
            D[3 * k + a] += Nx[v] * q[3 * v + a];
        if (k > 0)
            for (int a = 0; a < 3; a++)
                D[3 * (M - 1 + k) + a] += N[v] * q[3 * v + a];
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
    for (int v = 0; v < V; v++)
        for (int a = 0; a < 3; a++) {
            x[3 * v + a] = q[(3 * v + a) * HOBE_PARTS];
            if (position[v])
                x[3 * v + a] -= q[a * HOBE_PARTS];
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
    hobe_real *to;
    for (int c = 0; c < CLASSES; c++) {
        const int end = of->first_row[c + 1];
        const int r0 = of->first_row[c];
        const int n4 = (end - r0) / 4;
        for (int b = 0; b < n4; b++) {
            const int r = r0 + 4 * b;
            hobe_real s00 = zero;
            hobe_real s10 = zero;
            hobe_real s20 = zero;
            hobe_real s30 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + p;
                    s00 += H[0] * x[0];
                    s10 += H[1] * x[0];
                    s20 += H[2] * x[0];
                    s30 += H[3] * x[0];
                    H += 4;
                }
            }
            to = Q + of->row[r + 0];
            to[0] = s00;
            to = Q + of->row[r + 1];
            to[0] = s10;
            to = Q + of->row[r + 2];
            to[0] = s20;
            to = Q + of->row[r + 3];
            to[0] = s30;
        }
        const int r1 = r0 + 4 * n4;
        const int n2 = (end - r1) / 2;
        for (int b = 0; b < n2; b++) {
            const int r = r1 + 2 * b;
            hobe_real s00 = zero;
            hobe_real s10 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + p;
                    s00 += H[0] * x[0];
                    s10 += H[1] * x[0];
                    H += 2;
                }
            }
            to = Q + of->row[r + 0];
            to[0] = s00;
            to = Q + of->row[r + 1];
            to[0] = s10;
        }
        const int r2 = r1 + 2 * n2;
        const int n1 = end - r2;
        for (int b = 0; b < n1; b++) {
            const int r = r2 + 1 * b;
            hobe_real s00 = zero;
            for (int m = 0; m < merged[symmetry]; m++) {
                const int k = c ^ merged_with[CLASSES * symmetry + m];
                for (int p = of->first_pair[k]; p < of->first_pair[k + 1]; p++) {
                    const hobe_real *x = X + p;
                    s00 += H[0] * x[0];
                    H += 1;
                }
            }
            to = Q + of->row[r + 0];
            to[0] = s00;
        }
    }
    return H;
}

/* sym[row][6] = the rows' sums of coefficients H times columns
 * X[pairs][6]; returns the end of H */
static const double *row_symmetric(const struct products *of, const double *H, int symmetry,
                                   const hobe_real *X, hobe_real *sym)
{
    hobe_real *to;
    for (int c = 0; c < CLASSES; c++) {
        const int end = of->first_row[c + 1];
        const int r0 = of->first_row[c];
        const int n4 = TALL * ((end - r0) / 4);
        for (int b = 0; b < n4; b++) {
            const int r = r0 + 4 * b;
            hobe_real s00 = zero, s01 = zero, s02 = zero, s03 = zero, s04 = zero, s05 = zero;
            hobe_real s10 = zero, s11 = zero, s12 = zero, s13 = zero, s14 = zero, s15 = zero;
            hobe_real s20 = zero, s21 = zero, s22 = zero, s23 = zero, s24 = zero, s25 = zero;
            hobe_real s30 = zero, s31 = zero, s32 = zero, s33 = zero, s34 = zero, s35 = zero;
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
                    s20 += H[2] * x[0];
                    s21 += H[2] * x[1];
                    s22 += H[2] * x[2];
                    s23 += H[2] * x[3];
                    s24 += H[2] * x[4];
                    s25 += H[2] * x[5];
                    s30 += H[3] * x[0];
                    s31 += H[3] * x[1];
                    s32 += H[3] * x[2];
                    s33 += H[3] * x[3];
                    s34 += H[3] * x[4];
                    s35 += H[3] * x[5];
                    H += 4;
                }
            }
            to = sym + 6 * of->row[r + 0];
            to[0] = s00;
            to[1] = s01;
            to[2] = s02;
            to[3] = s03;
            to[4] = s04;
            to[5] = s05;
            to = sym + 6 * of->row[r + 1];
            to[0] = s10;
            to[1] = s11;
            to[2] = s12;
            to[3] = s13;
            to[4] = s14;
            to[5] = s15;
            to = sym + 6 * of->row[r + 2];
            to[0] = s20;
            to[1] = s21;
            to[2] = s22;
            to[3] = s23;
            to[4] = s24;
            to[5] = s25;
            to = sym + 6 * of->row[r + 3];
            to[0] = s30;
            to[1] = s31;
            to[2] = s32;
            to[3] = s33;
            to[4] = s34;
            to[5] = s35;
        }
        const int r1 = r0 + 4 * n4;
        const int n2 = (end - r1) / 2;
        for (int b = 0; b < n2; b++) {
            const int r = r1 + 2 * b;
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
            to = sym + 6 * of->row[r + 0];
            to[0] = s00;
            to[1] = s01;
            to[2] = s02;
            to[3] = s03;
            to[4] = s04;
            to[5] = s05;
            to = sym + 6 * of->row[r + 1];
            to[0] = s10;
            to[1] = s11;
            to[2] = s12;
            to[3] = s13;
            to[4] = s14;
            to[5] = s15;
        }
        const int r2 = r1 + 2 * n2;
        const int n1 = end - r2;
        for (int b = 0; b < n1; b++) {
            const int r = r2 + 1 * b;
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
            to = sym + 6 * of->row[r + 0];
            to[0] = s00;
            to[1] = s01;
            to[2] = s02;
            to[3] = s03;
            to[4] = s04;
            to[5] = s05;
        }
    }
    return H;
}

/* skew[row][3] = the rows' sums of coefficients H times columns
 * X[pairs - columns][3]; returns the end of H */
static const double *row_skew(const struct products *of, const double *H, int symmetry,
                              const hobe_real *X, hobe_real *skew)
{
    hobe_real *to;
    for (int c = 0; c < CLASSES; c++) {
        const int end = of->first_skew_row[c + 1];
        const int r0 = of->first_skew_row[c];
        const int n4 = (end - r0) / 4;
        for (int b = 0; b < n4; b++) {
            const int r = r0 + 4 * b;
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
            to = skew + 3 * of->skew_row[r + 0];
            to[0] = s00;
            to[1] = s01;
            to[2] = s02;
            to = skew + 3 * of->skew_row[r + 1];
            to[0] = s10;
            to[1] = s11;
            to[2] = s12;
            to = skew + 3 * of->skew_row[r + 2];
            to[0] = s20;
            to[1] = s21;
            to[2] = s22;
            to = skew + 3 * of->skew_row[r + 3];
            to[0] = s30;
            to[1] = s31;
            to[2] = s32;
        }
        const int r1 = r0 + 4 * n4;
        const int n2 = (end - r1) / 2;
        for (int b = 0; b < n2; b++) {
            const int r = r1 + 2 * b;
            hobe_real s00 = zero, s01 = zero, s02 = zero;
            hobe_real s10 = zero, s11 = zero, s12 = zero;
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
                    H += 2;
                }
            }
            to = skew + 3 * of->skew_row[r + 0];
            to[0] = s00;
            to[1] = s01;
            to[2] = s02;
            to = skew + 3 * of->skew_row[r + 1];
            to[0] = s10;
            to[1] = s11;
            to[2] = s12;
        }
        const int r2 = r1 + 2 * n2;
        const int n1 = end - r2;
        for (int b = 0; b < n1; b++) {
            const int r = r2 + 1 * b;
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
            to = skew + 3 * of->skew_row[r + 0];
            to[0] = s00;
            to[1] = s01;
            to[2] = s02;
        }
    }
    return H;
}

/* Q of the rows from the parts that mirror images share */
static void images(hobe_real *Q)
{
    for (int v = OPPOSED; v < V; v++)
        for (int u = OPPOSED; u < v + 1; u++) {
            const int m = hobe_pair(v, u);
            const int n = symmetric(nodal->mirror[v], nodal->mirror[u]);
            if (m < n) {
                const hobe_real sum = Q[m] + Q[n], difference = Q[m] - Q[n];
                Q[m] = sum;
                Q[n] = difference;
            }
        }
}

/* f_i = sum_j Q_ij x_j, where x_0 = 0; on positions they are in balance */
static void tensor_force(const hobe_real *Q, const hobe_real *x, hobe_real *f)
{
    for (int a = 0; a < 3; a++)
        f[a * HOBE_PARTS] = zero;
    for (int i = 1; i < V; i++) {
        hobe_real sum[3] = {zero, zero, zero};
        for (int j = 1; j < i; j++)
            for (int a = 0; a < 3; a++)
                sum[a] += Q[hobe_pair(i, j)] * x[3 * j + a];
        for (int j = i; j < V; j++)
            for (int a = 0; a < 3; a++)
                sum[a] += Q[hobe_pair(j, i)] * x[3 * j + a];
        for (int a = 0; a < 3; a++)
            f[(3 * i + a) * HOBE_PARTS] = sum[a];
        if (position[i])
            for (int a = 0; a < 3; a++)
                f[a * HOBE_PARTS] -= sum[a];
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
    for (int v = OPPOSED; v < V; v++)
        for (int u = OPPOSED; u < v + 1; u++) {
            const int m = hobe_pair(v, u);
            const int n = symmetric(nodal->mirror[v], nodal->mirror[u]);
            if (m == n)
                block(sym + 6 * m, skew + 3 * m, Q + m, K + 9 * HOBE_PARTS * m);
            if (m < n) {
                hobe_real s[6], r[3];
                for (int e = 0; e < 6; e++)
                    s[e] = sym[6 * m + e] + sym[6 * n + e];
                for (int e = 0; e < 3; e++)
                    r[e] = skew[3 * m + e] + skew[3 * n + e];
                block(s, r, Q + m, K + 9 * HOBE_PARTS * m);
                for (int e = 0; e < 6; e++)
                    s[e] = sym[6 * m + e] - sym[6 * n + e];
                for (int e = 0; e < 3; e++)
                    r[e] = skew[3 * m + e] - skew[3 * n + e];
                block(s, r, Q + n, K + 9 * HOBE_PARTS * n);
            }
        }
}

/* K_i0 = -K_in of two positions 0 and n = LAST */
static void opposed_blocks(hobe_real *K)
{
    for (int i = 1; i < V; i++) {
        hobe_real *to = K + 9 * HOBE_PARTS * hobe_pair(i, 0);
        if (i < LAST) {
            const hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(LAST, i);
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    to[(3 * a + b) * HOBE_PARTS] = zero - k[(3 * b + a) * HOBE_PARTS];
        }
        if (i >= LAST) {
            const hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(i, LAST);
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    to[(3 * a + b) * HOBE_PARTS] = zero - k[(3 * a + b) * HOBE_PARTS];
        }
    }
    for (int e = 0; e < 9; e++)
        K[e * HOBE_PARTS] = K[(9 * hobe_pair(LAST, LAST) + e) * HOBE_PARTS];
}

/* K from the rows */
static void finish(const hobe_real *Q, const hobe_real *sym, hobe_real *skew, hobe_real *K)
{
    for (int i = OPPOSED; i < V; i++)
        for (int a = 0; a < 3; a++)
            skew[3 * hobe_pair(i, i) + a] = zero;
    blocks(Q, sym, skew, K);
    if (OPPOSED)
        opposed_blocks(K);
}

/* P_I = dW/dD_I = sum_J Q_IJ D_J */
static void section_force(const hobe_real *Q, const hobe_real *D, hobe_real *P)
{
    for (int i = 0; i < S; i++) {
        for (int a = 0; a < 3; a++)
            P[3 * i + a] = zero;
        for (int j = 0; j < i; j++) {
            const hobe_real t = Q[hobe_pair(i, j)];
            for (int a = 0; a < 3; a++)
                P[3 * i + a] += t * D[3 * j + a];
        }
        for (int j = i; j < S; j++) {
            const hobe_real t = Q[hobe_pair(j, i)];
            for (int a = 0; a < 3; a++)
                P[3 * i + a] += t * D[3 * j + a];
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
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        column_differences(sectional, B, U, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, Q);
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        section_force(Q, B, U);
        for (int v = 0; v < V; v++) {
            const int k = mode[v];
            const double cx = inv->wx[g] * Nx[v], c = inv->wx[g] * N[v];
            for (int a = 0; a < 3; a++)
                f[(3 * v + a) * HOBE_PARTS] += cx * U[3 * k + a];
            if (k > 0)
                for (int a = 0; a < 3; a++)
                    f[(3 * v + a) * HOBE_PARTS] += c * U[3 * (M - 1 + k) + a];
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
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
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
    for (int i = 0; i < 3 * S; i++)
        B[i] = 0.5 * B[i];
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
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
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
            for (int a = 0; a < 3; a++)
                f[(3 * v + a) * HOBE_PARTS] += cx * U[3 * k + a];
            if (k > 0)
                for (int a = 0; a < 3; a++)
                    f[(3 * v + a) * HOBE_PARTS] += c * U[3 * (M - 1 + k) + a];
        }
    }
}

/* the Gram entries of b and c in polar form, and w_g Q of them */
static void gram_part(const struct hobe_invariants *inv, const hobe_real *qb, const hobe_real *qc,
                      hobe_real *strain, hobe_real *stress)
{
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S], gamma[GRAMS], Q[GRAMS];
    gather(qb, x0);
    gather(qc, x);
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
        polar(N, Nx, x0, x, B, U);
        column_differences(sectional, B, U, gamma);
        row_stress(sectional, H, inv->symmetry, gamma, Q);
        for (int p = 0; p < GRAMS; p++) {
            const int row = hobe_pair(sectional->pair_t[p], sectional->pair_v[p]);
            strain[(GRAMS * g + p) * HOBE_PARTS] = gamma[p];
            stress[(GRAMS * g + p) * HOBE_PARTS] = inv->wx[g] * Q[row];
        }
    }
}

/* T = the rows (I, J) of station g: Q[GRAMS], symmetric[GRAMS][6], skew[GRAMS][3] */
static void station_rows(const struct hobe_invariants *inv, int g, const hobe_real *x0,
                         const hobe_real *x, hobe_real *X, hobe_real *T)
{
    hobe_real B[3 * S], U[3 * S], *Z = X + 6 * GRAMS;
    hobe_real *sym = T + GRAMS, *skew = T + 7 * GRAMS;
    const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
    const double *H = inv->section + AXIAL * inv->stations + inv->step * g;
    section_vectors(N, Nx, x0, B);
    section_vectors(N, Nx, x, U);
    for (int i = 0; i < 3 * S; i++)
        B[i] += 0.5 * U[i];
    column_differences(sectional, B, U, X);
    /* D = D0 + U */
    for (int i = 0; i < 3 * S; i++)
        B[i] += 0.5 * U[i];
    H = row_stress(sectional, H, inv->symmetry, X, T);
    products(sectional, B, X, Z);
    H = row_symmetric(sectional, H, inv->symmetry, X, sym);
    row_skew(sectional, H, inv->symmetry, Z, skew);
    for (int i = 0; i < S; i++)
        for (int a = 0; a < 3; a++)
            skew[3 * hobe_pair(i, i) + a] = zero;
}

/* T + s T' and T - s T' of the rows T of a station and T' = W of its mirror image */
static void even_and_odd(hobe_real *T, hobe_real *W)
{
    for (int i = 0; i < S; i++)
        for (int j = 0; j < i + 1; j++) {
            const int r = hobe_pair(i, j);
            const int along = (i < M) == (j < M);
            hobe_real *plus = along ? T : W, *minus = along ? W : T;
            for (int e = 0; e < 10; e++) {
                const int at = e < 1 ? r : e < 7 ? GRAMS + 6 * r + e - 1 :
                                     7 * GRAMS + 3 * r + e - 7;
                const hobe_real sum = T[at] + W[at], less = T[at] - W[at];
                plus[at] = sum;
                minus[at] = less;
            }
        }
}

/* Q and K of the rows of nodal vectors from the rows T of stations, even and odd parts:
 * of a row and its mirror image the sum of what they share, then of what they differ by */
static void nodal_blocks(const struct hobe_invariants *inv, const hobe_real *T, hobe_real *Q,
                         hobe_real *K)
{
    const int last = MIRRORED ? (inv->stations - 1) / 2 : inv->stations - 1;
    for (int k = 0; k < M; k++)
        for (int l = 0; l < k + 1; l++)
            for (int i = first_of[k]; i < first_of[k + 1]; i++) {
                const int end = k == l ? i + 1 : first_of[l + 1];
                for (int j = first_of[l]; j < end; j++) {
                    const int v = larger(by_mode[i], by_mode[j]);
                    const int u = by_mode[i] + by_mode[j] - v;
                    const int m = hobe_pair(v, u);
                    const int n = symmetric(nodal->mirror[v], nodal->mirror[u]);
                    const int a = mode[v];
                    const int b = mode[u];
                    const int parts = (m <= n) + (m < n);
                    const int p0 = symmetric(a, b);
                    const int p1 = symmetric(a, M - 1 + b);
                    const int p2 = symmetric(M - 1 + a, b);
                    const int p3 = symmetric(M - 1 + a, M - 1 + b);
                    const int side = a < b ? -1 : 1;
                    hobe_real x[20], y[10];
                    for (int z = 0; z < parts; z++) {
                        const int part = odd_of[v] ^ odd_of[u] ^ z;
                        const int turned = part ^ (nodal->mirror[v] < nodal->mirror[u]);
                        hobe_real s0 = zero, s1 = zero, s2 = zero, s3 = zero, s4 = zero;
                        hobe_real s5 = zero, s6 = zero, s7 = zero, s8 = zero, s9 = zero;
                        for (int g = 0; g < last + 1; g++) {
                            const int image = inv->stations - 1 - g;
                            const int same = part ? image : g;
                            const int other = turned ? image : g;
                            const hobe_real *t = T + 10 * GRAMS * same;
                            const hobe_real *w = T + 10 * GRAMS * other;
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
                            if (b > 0) {
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
                            if (a > 0) {
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
                            if (a > 0 && b > 0) {
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
                        if (v == u)
                            for (int e = 0; e < 3; e++)
                                x[10 * z + 7 + e] = zero;
                    }
                    if (parts == 1) {
                        Q[m] = x[0];
                        block(x + 1, x + 7, x, K + 9 * HOBE_PARTS * m);
                    }
                    if (parts == 2) {
                        for (int e = 0; e < 10; e++)
                            y[e] = x[e] + x[10 + e];
                        Q[m] = y[0];
                        block(y + 1, y + 7, y, K + 9 * HOBE_PARTS * m);
                        for (int e = 0; e < 10; e++)
                            y[e] = x[e] - x[10 + e];
                        Q[n] = y[0];
                        block(y + 1, y + 7, y, K + 9 * HOBE_PARTS * n);
                    }
                }
            }
    if (OPPOSED)
        opposed_blocks(K);
}

/* f = dU/dq and K = df/dq, eq. 28, for one part of a batch */
static void tangent_part(const struct hobe_invariants *inv, const hobe_real *q0,
                         const hobe_real *u, hobe_real *f, hobe_real *K, hobe_real *scratch)
{
    hobe_real x0[3 * V], x[3 * V], *Q = scratch, *X = Q + BLOCKS;
    hobe_real *T = X + 9 * GRAMS - 3 * S;
    gather(q0, x0);
    gather(u, x);
    for (int g = 0; g < inv->stations; g++)
        station_rows(inv, g, x0, x, X, T + 10 * GRAMS * g);
    const int couples = MIRRORED ? inv->stations / 2 : 0;
    for (int g = 0; g < couples; g++) {
        const int other = inv->stations - 1 - g;
        even_and_odd(T + 10 * GRAMS * g, T + 10 * GRAMS * other);
    }
    nodal_blocks(inv, T, Q, K);
    /* D = D0 + U */
    for (int i = 0; i < 3 * V; i++)
        x[i] += x0[i];
    tensor_force(Q, x, f);
}

/* y[COLUMNS][3], the sums and differences about mid-length of nodal vectors x[V][3] */
static void column_vectors(const hobe_real *x, hobe_real *y)
{
    for (int t = 0; t < COLUMNS; t++) {
        for (int a = 0; a < 3; a++)
            y[3 * t + a] = x[3 * left[t] + a] + sign[t] * x[3 * right[t] + a];
        if (shifted[t])
            for (int a = 0; a < 3; a++)
                y[3 * t + a] -= x[3 * LAST + a];
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
    for (int i = 0; i < 3 * V; i++)
        x0[i] += 0.5 * x[i];
    column_vectors(x0, B);
    column_vectors(x, y);
    column_differences(nodal, B, y, gamma);
    for (int i = 0; i < 3 * V; i++)
        x[i] = x0[i] + 0.5 * x[i];
    for (int i = 0; i < 3 * COLUMNS; i++)
        y[i] = B[i] + 0.5 * y[i];
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

static void gram(const struct hobe_invariants *inv, const hobe_lanes *b, const hobe_lanes *c,
                 hobe_lanes *strain, hobe_lanes *stress)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        gram_part(inv, (const hobe_real *)b + h, (const hobe_real *)c + h, (hobe_real *)strain + h,
                  (hobe_real *)stress + h);
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
    {0, 7, 0}, {0, 8, 0}, {0, 9, 0}, {0, 10, 0}, {0, 11, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0},
    {1, 4, 0}, {1, 5, 0}, {1, 6, 0}, {1, 7, 0}, {1, 8, 0}, {1, 9, 0}, {1, 10, 0}, {1, 11, 0},
    {2, 0, 0}, {2, 0, 1}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0}, {2, 4, 0}, {2, 5, 0}, {2, 6, 0},
    {2, 7, 0}, {2, 8, 0}, {2, 9, 0}, {2, 10, 0}, {2, 11, 0},
};
static const char *const mode_name[M] = {
    "1", "y", "z", "w", "wy", "wz", "ww", "w1", "v1y", "v1z", "v2y", "v2z",
};
static const char *const function_name[] = {
    "w", "wy", "wz", "ww", "w1", "v1y", "v1z", "v2y", "v2z",
};
static const struct hobe_plan_cost section_cost[HOBE_SYMMETRIES] = {
    {799812, 7482501, 216361}, {419652, 3863061, 108385}, {421812, 3876381, 108757},
    {230652, 2060001, 54583}, {421812, 3876381, 108757}, {230652, 2060001, 54583},
    {238132, 2116861, 56229}, {138812, 1180241, 28319},
};
static const struct hobe_plan_cost tensor_cost[HOBE_SYMMETRIES] = {
    {0, 0, 0}, {464749, 4376761, 647142}, {0, 0, 0}, {241645, 2218297, 324582}, {0, 0, 0},
    {241645, 2218297, 324582}, {0, 0, 0}, {131949, 1154169, 165510},
};

extern const struct hobe_kernel HOBE_KERNEL(MGD30d);
const struct hobe_kernel HOBE_KERNEL(MGD30d) = {
    .abi = 8,
    .name = "MGD30d",
    .hash = "e3c2506b576e0a92",
    .source = "this project: MGD30w3 whose section distorts in torsion",
    .mechanics = "average",
    .nodes = 3,
    .vectors = V,
    .modes = M,
    .functions = 9,
    .stations = 5,
    .degree = 1,
    .normals = NN,
    .shears = NS,
    .flops_force = 419652,
    .flops_tangent = 3863061,
    .scratch = 22438,
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
    .gram = gram,
    .series = series,
    .strain = strain,
    .warping_strain = warping_strain,
};
