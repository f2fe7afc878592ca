/* 3333s: Nachbagauer, Gruber & Gerstmayr 2013; Tang, Tian & Hu 2022, Table 7
 *
 * Written by `python -m generator`, declaration abcf9e0e56460d5e: do not edit.
 * nodes at xi = 0 1/2 1; 9 vectors, 27 degrees of freedom
 * modes 1 y z
 * 2 Gauss points on the axis for the rod's strains, 3 Lobatto points for the section's
 * vectors (mode@node, ' for d/dx): 1@1 y@1 z@1 1@2 y@2 z@2 1@3 y@3 z@3
 * operations per element: force 3535, force and tangent 32279, energy 2395
 */
#include "kernel.h"

#if HOBE_KERNEL_ABI != 8
#error Regenerate: this file was written for another kernel ABI
#endif

enum {
    V = 9,   /* nodal vectors */
    M = 3,   /* section modes */
    S = 5,   /* section vectors d_k', d_k */
    ROD = 2, /* stations of the rod's strains, before those of the section's */
    NN = 6,  /* the rod's strains Gamma, kappa */
    NS = 3,  /* the section's strains E_yy, E_zz, 2 E_yz */
    A = 3,   /* distinct axial functions */
};

static const hobe_real zero = {0};

/* Of each nodal vector: mode; whether it is a position; axial function. */
static const unsigned char mode[V] = {
    0, 1, 2, 0, 1, 2, 0, 1, 2,
};
static const unsigned char position[V] = {
    1, 0, 0, 1, 0, 0, 1, 0, 0,
};
static const unsigned char axial_of[V] = {
    0, 0, 0, 1, 1, 1, 2, 2, 2,
};
static const unsigned char is_slope[A] = {
    0, 0, 0,
};

/* int_0^1 A_i A_j dxi, exact */
static const double overlap[A * A] = {
    2.0 / 15.0, 1.0 / 15.0, -1.0 / 30.0, 1.0 / 15.0, 8.0 / 15.0, 1.0 / 15.0, -1.0 / 30.0,
    1.0 / 15.0, 2.0 / 15.0,
};

static void shape(double xi, double length, double *N, double *Nx)
{
    const double A_xi[A][2] = { /* A_i(xi), dA_i/dxi */
        {1.0 + xi * (-3.0 + xi * 2.0),
         -3.0 + xi * 4.0},
        {xi * (4.0 + xi * (-4.0)),
         4.0 + xi * (-8.0)},
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
    (void)f;
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

/* Q += stiffness e e' over the rod's strains, both triangles. */
static void add_strain(double *Q, const double e[NN], double stiffness)
{
    for (int r = 0; r < NN; r++)
        for (int c = 0; c < NN; c++)
            Q[r * NN + c] += stiffness * e[r] * e[c];
}

/* Q of the rod's and of the section's strains, and moment_kl = int density phi_k phi_l dA.  Of the
 * law at a point: E = normal_00 (no Poisson coupling) and the shear moduli; shear forces act in the
 * shear centre, and torsion has Saint-Venant's constant.  D0: section vectors of the reference,
 * whose strains are meant per length of arc, |d_0'| dx; or NULL, straight. */
static void section_law(const struct blocks *to, const struct hobe_station *station,
                        const struct hobe_law *law, const double (*D0)[3], double moment[M][M])
{
    const double arc = D0 ? __builtin_sqrt(product(D0[0], D0[0])) : 1.0;
    const double ys = station->shear_centre[0], zs = station->shear_centre[1];
    double area = 0.0, shear[3] = {0}, phi[M][4], g[3][S];
    clear(to->Qn, NN * NN);
    clear(to->Qs, NS * NS);
    clear(moment[0], M * M);
    for (int p = 0; p < station->rule.points; p++) {
        const struct hobe_section_point *at = station->rule.point + p;
        const struct hobe_elasticity *C = law->region + at->region;
        const double e[NN] = {1.0, 0.0, 0.0, 0.0, at->z, -at->y}, weight = at->weight;
        add_strain(to->Qn, e, weight * C->normal[0][0] / arc);
        for (int i = 0; i < 3; i++)
            shear[i] += weight * C->shear[i];
        to->Qs[0] += arc * weight * C->normal[1][1];
        to->Qs[NS + 1] += arc * weight * C->normal[2][2];
        area += weight;
        const double mass = weight * point_rows(at, D0, phi, g) * law->density[at->region];
        for (int k = 0; k < M; k++)
            for (int l = 0; l < M; l++)
                moment[k][l] += mass * phi[k][0] * phi[l][0];
    }
    const double xy[NN] = {0.0, 1.0, 0.0, -zs, 0.0, 0.0}, xz[NN] = {0.0, 0.0, 1.0, ys, 0.0, 0.0};
    const double twist[NN] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    add_strain(to->Qn, xy, (shear[2] + area * law->mean.shear[2]) / arc);
    add_strain(to->Qn, xz, (shear[1] + area * law->mean.shear[1]) / arc);
    add_strain(to->Qn, twist, law->region[0].shear[0] * station->J / arc);
    to->Qs[2 * NS + 2] = arc * shear[0];
}

/* p parts of Gauss' and Lobatto's rules out of 2p + 1, and one more of Gauss': exact for degree
 * 2p + 1. */
static double mass_weight(const struct hobe_invariants *inv, int g)
{
    return inv->wx[g] * (g < ROD ? ROD + 1 : ROD) / (2 * ROD + 1);
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

/* K_vw += w (N_v', N_v) [C] (N_w', N_w)^T for v >= w */
static void expand(const double *N, const double *Nx, double w, const hobe_real *C, hobe_real *K)
{
    for (int v = 0; v < V; v++)
        for (int u = 0; u < v + 1; u++) {
            const int i = mode[v];
            const int j = mode[u];
            hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(v, u);
            const double cxx = w * Nx[v] * Nx[u], cx = w * Nx[v] * N[u];
            const double xc = w * N[v] * Nx[u], cc = w * N[v] * N[u];
            for (int e = 0; e < 9; e++)
                k[e * HOBE_PARTS] += cxx * C[9 * ((i) * S + j) + e];
            if (j > 0)
                for (int e = 0; e < 9; e++)
                    k[e * HOBE_PARTS] += cx * C[9 * ((i) * S + M - 1 + j) + e];
            if (i > 0)
                for (int e = 0; e < 9; e++)
                    k[e * HOBE_PARTS] += xc * C[9 * ((M - 1 + i) * S + j) + e];
            if (i > 0 && j > 0)
                for (int e = 0; e < 9; e++)
                    k[e * HOBE_PARTS] += cc * C[9 * ((M - 1 + i) * S + M - 1 + j) + e];
        }
}

/* c = a x b */
static inline void vector_product(const hobe_real *a, const hobe_real *b, hobe_real *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* c += a x b */
static inline void add_product(const hobe_real *a, const hobe_real *b, hobe_real *c)
{
    hobe_real p[3];
    vector_product(a, b, p);
    for (int i = 0; i < 3; i++)
        c[i] += p[i];
}

/* Y_Ii = e_i.D_I */
static void components(const hobe_real *e, const hobe_real *D, hobe_real *Y)
{
    for (int k = 0; k < S; k++)
        for (int i = 0; i < 3; i++)
            Y[3 * k + i] = dot(e + 3 * i, D + 3 * k);
}

/* The frame e_1, e_2, e_3 of a section with d_y = a, d_z = b; size = |a x b|, |b| */
static void frame(const hobe_real *a, const hobe_real *b, hobe_real *e, hobe_real *size)
{
    vector_product(a, b, e);
    size[0] = hobe_root(dot(e, e));
    size[1] = hobe_root(dot(b, b));
    for (int i = 0; i < 3; i++) {
        e[i] = e[i] / size[0];
        e[6 + i] = b[i] / size[1];
    }
    vector_product(e + 6, e, e + 3);
}

/* t = the change of the unit vector n of a vector size * n that changes by d, with all its
 * digits however small d is */
static void unit_change(const hobe_real *n, hobe_real size, const hobe_real *d, hobe_real *t)
{
    hobe_real v[3];
    for (int i = 0; i < 3; i++)
        v[i] = size * n[i] + d[i];
    const hobe_real now = hobe_root(dot(v, v));
    const hobe_real more = (dot(d, d) + 2.0 * size * dot(n, d)) / (now + size);
    for (int i = 0; i < 3; i++)
        t[i] = (d[i] - more * n[i]) / now;
}

/* w = L (a, b), the spin of the frame with changes a, b of Y_a = (0, alpha, gamma) and
 * Y_b = (0, 0, beta); components 10, 11 and 14 of Y */
static void spin(const hobe_real *Y, const hobe_real *a, const hobe_real *b, hobe_real *w)
{
    w[0] = zero - b[1] / Y[14];
    w[1] = b[0] / Y[14];
    w[2] = (w[1] * Y[11] - a[0]) / Y[10];
}

/* P[2][3] = L' m, forces on a and b */
static void couple(const hobe_real *Y, const hobe_real *m, hobe_real *P)
{
    P[0] = zero - m[2] / Y[10];
    P[1] = zero;
    P[2] = zero;
    P[3] = (m[1] - Y[11] * P[0]) / Y[14];
    P[4] = zero - m[0] / Y[14];
    P[5] = zero;
}

/* n[NN] = the changes of Gamma and kappa where components have changed by x to Y */
static void rod_strains(const hobe_real *kappa, const hobe_real *Y, const hobe_real *x,
                        hobe_real *n)
{
    hobe_real p[6];
    for (int i = 0; i < 3; i++)
        n[i] = x[i];
    for (int i = 0; i < 6; i++)
        p[i] = x[3 + i];
    add_product(x + 9, kappa, p);
    add_product(x + 12, kappa, p + 3);
    spin(Y, p, p + 3, n + 3);
}

/* n = changes of the rod's strains, without cancellation, and the frame e after them.  A
 * product changes by (change of one) (mean of the other) + the reverse: e_i changes by
 * t, D by U, and B is the mean of D. */
static void rod_differences(const hobe_real *B, const hobe_real *U, hobe_real *e, hobe_real *n)
{
    hobe_real D[3 * S], Y[3 * S], x[3 * S], t[9], d[3], size[2], kappa[3];
    for (int i = 0; i < 3 * S; i++)
        D[i] = B[i] - 0.5 * U[i];
    frame(D + 9, D + 12, e, size);
    components(e, D, Y);
    spin(Y, Y + 3, Y + 6, kappa);
    vector_product(U + 9, B + 12, d);
    add_product(B + 9, U + 12, d);
    unit_change(e, size[0], d, t);
    unit_change(e + 6, size[1], U + 12, t + 6);
    for (int i = 0; i < 3; i++) {
        e[i] += 0.5 * t[i];
        e[6 + i] += 0.5 * t[6 + i];
    }
    vector_product(t + 6, e, t + 3);
    add_product(e + 6, t, t + 3);
    for (int i = 0; i < 3; i++)
        e[3 + i] += 0.5 * t[3 + i];
    for (int k = 0; k < S; k++)
        for (int i = 0; i < 3; i++)
            x[3 * k + i] = dot(t + 3 * i, B + 3 * k) + dot(e + 3 * i, U + 3 * k);
    for (int i = 0; i < 3 * S; i++)
        Y[i] += x[i];
    rod_strains(kappa, Y, x, n);
    for (int i = 0; i < 9; i++)
        e[i] += 0.5 * t[i];
}

/* P_r' = t, (P_a', P_b') = p, nothing yet on a and b */
static void slope_forces(const hobe_real *t, const hobe_real *p, hobe_real *P)
{
    for (int i = 0; i < 3; i++)
        P[i] = t[i];
    for (int i = 0; i < 6; i++) {
        P[3 + i] = p[i];
        P[9 + i] = zero;
    }
}

/* Adds to P the forces on a and b that balance m and the moment of P */
static void balance(const hobe_real *Y, hobe_real *m, hobe_real *P)
{
    hobe_real p[6];
    for (int k = 0; k < S; k++)
        add_product(P + 3 * k, Y + 3 * k, m);
    couple(Y, m, p);
    for (int i = 0; i < 6; i++)
        P[9 + i] += p[i];
}

/* The components of P_I = dW/dD_I, the curvature, and p = L' t_kappa */
static void frame_force(const hobe_real *t, const hobe_real *Y, hobe_real *kappa, hobe_real *p,
                        hobe_real *P)
{
    hobe_real m[3] = {zero, zero, zero};
    spin(Y, Y + 3, Y + 6, kappa);
    couple(Y, t + 3, p);
    slope_forces(t, p, P);
    add_product(kappa, p, P + 9);
    add_product(kappa, p + 3, P + 12);
    balance(Y, m, P);
}

/* P_I = dW/dD_I of the rod's strains */
static void rod_force(const hobe_real *t, const hobe_real *D, const hobe_real *e, hobe_real *P)
{
    hobe_real Y[3 * S], F[3 * S], kappa[3], p[6];
    components(e, D, Y);
    frame_force(t, Y, kappa, p, F);
    for (int k = 0; k < S; k++)
        for (int a = 0; a < 3; a++)
            P[3 * k + a] = e[a] * F[3 * k] + e[3 + a] * F[3 * k + 1] + e[6 + a] * F[3 * k + 2];
}

/* C_IJ = d2W/dD_I dD_J of the rod's strains, column by column: the change of rod_force
 * with component b of D_J */
static void rod_stiffness(const double *Q, const hobe_real *t, const hobe_real *D,
                          const hobe_real *e, hobe_real *C)
{
    hobe_real Y[3 * S], F[3 * S], x[3 * S], P[3 * S];
    hobe_real kappa[3], w[3], m[3], p[6], q[6], n[NN], s[NN];
    components(e, D, Y);
    frame_force(t, Y, kappa, p, F);
    for (int j = 0; j < S; j++)
        for (int b = 0; b < 3; b++) {
            for (int i = 0; i < 3 * S; i++)
                x[i] = zero;
            for (int i = 0; i < 3; i++)
                x[3 * j + i] = e[3 * i + b];
            spin(Y, x + 9, x + 12, w);
            for (int k = 0; k < S; k++)
                add_product(Y + 3 * k, w, x + 3 * k);
            rod_strains(kappa, Y, x, n);
            for (int r = 0; r < NN; r++)
                s[r] = zero;
            for (int c = 0; c < NN; c++)
                for (int r = 0; r < NN; r++)
                    s[r] += Q[c * NN + r] * n[c];
            /* frame_force differentiated */
            for (int i = 0; i < 3; i++)
                m[i] = s[3 + i];
            add_product(p, x + 9, m);
            add_product(p + 3, x + 12, m);
            couple(Y, m, q);
            slope_forces(s, q, P);
            for (int i = 0; i < 2; i++) {
                add_product(n + 3, p + 3 * i, P + 9 + 3 * i);
                add_product(kappa, q + 3 * i, P + 9 + 3 * i);
            }
            for (int i = 0; i < 3; i++)
                m[i] = zero;
            for (int k = 0; k < S; k++)
                add_product(F + 3 * k, x + 3 * k, m);
            balance(Y, m, P);
            for (int k = 0; k < S; k++) {
                hobe_real *f = P + 3 * k, *c_ab = C + 9 * (k * S + j) + b;
                add_product(w, F + 3 * k, f);
                for (int a = 0; a < 3; a++)
                    c_ab[3 * a] = e[a] * f[0] + e[3 + a] * f[1] + e[6 + a] * f[2];
            }
        }
}

/* s[NS] = the changes of E_yy, E_zz, 2 E_yz where D, their mean, changes by x */
static void section_strains(const hobe_real *D, const hobe_real *x, hobe_real *s)
{
    s[0] = dot(D + 9, x + 9);
    s[1] = dot(D + 12, x + 12);
    s[2] = dot(D + 9, x + 12) + dot(D + 12, x + 9);
}

/* P_a, P_b += the stresses t[NS] times a and b */
static void section_stresses(const hobe_real *t, const hobe_real *D, hobe_real *P)
{
    for (int a = 0; a < 3; a++)
        P[9 + a] += t[0] * D[9 + a] + t[2] * D[12 + a];
    for (int a = 0; a < 3; a++)
        P[12 + a] += t[1] * D[12 + a] + t[2] * D[9 + a];
}

/* P_I = dW/dD_I of the section's strains */
static void section_force(const hobe_real *t, const hobe_real *D, hobe_real *P)
{
    for (int i = 0; i < 3 * S; i++)
        P[i] = zero;
    section_stresses(t, D, P);
}

/* C_IJ = d2W/dD_I dD_J of the section's strains, column by column */
static void section_stiffness(const double *Q, const hobe_real *t, const hobe_real *D,
                              hobe_real *C)
{
    hobe_real x[3 * S], P[3 * S], n[NS], s[NS];
    for (int i = 0; i < 9 * S * S; i++)
        C[i] = zero;
    for (int j = 0; j < S; j++)
        if (j >= M)
            for (int b = 0; b < 3; b++) {
                for (int i = 0; i < 3 * S; i++) {
                    x[i] = zero;
                    P[i] = zero;
                }
                x[3 * j + b] += 1.0;
                section_strains(D, x, n);
                for (int r = 0; r < NS; r++)
                    s[r] = zero;
                for (int c = 0; c < NS; c++)
                    for (int r = 0; r < NS; r++)
                        s[r] += Q[c * NS + r] * n[c];
                section_stresses(s, D, P);
                section_stresses(t, x, P);
                for (int k = 0; k < S; k++)
                    for (int a = 0; a < 3; a++)
                        C[9 * (k * S + j) + 3 * a + b] = P[3 * k + a];
            }
}

/* f = dU/dq, eq. 27, for one part of a batch */
static void force_part(const struct hobe_invariants *inv, const hobe_real *q0, const hobe_real *u,
                       hobe_real *f)
{
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];
    hobe_real e[9], n[NN], t[NN];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g;
        const double *Qs = inv->Qs + inv->step_s * g;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        if (g < ROD) {
            rod_differences(B, U, e, n);
            for (int r = 0; r < NN; r++)
                t[r] = zero;
            for (int c = 0; c < NN; c++)
                for (int r = 0; r < NN; r++)
                    t[r] += Qn[c * NN + r] * n[c];
        }
        if (g >= ROD) {
            section_strains(B, U, n);
            for (int r = 0; r < NS; r++)
                t[r] = zero;
            for (int c = 0; c < NS; c++)
                for (int r = 0; r < NS; r++)
                    t[r] += Qs[c * NS + r] * n[c];
        }
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        if (g < ROD)
            rod_force(t, B, e, U);
        if (g >= ROD)
            section_force(t, B, U);
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
    hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];
    hobe_real e[9], n[NN], t[NN];
    gather(q0, x0);
    gather(u, x);
    hobe_real sum = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g;
        const double *Qs = inv->Qs + inv->step_s * g;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        if (g < ROD) {
            rod_differences(B, U, e, n);
            for (int r = 0; r < NN; r++)
                t[r] = zero;
            for (int c = 0; c < NN; c++)
                for (int r = 0; r < NN; r++)
                    t[r] += Qn[c * NN + r] * n[c];
        }
        if (g >= ROD) {
            section_strains(B, U, n);
            for (int r = 0; r < NS; r++)
                t[r] = zero;
            for (int c = 0; c < NS; c++)
                for (int r = 0; r < NS; r++)
                    t[r] += Qs[c * NS + r] * n[c];
        }
        hobe_real w = zero;
        if (g < ROD)
            for (int r = 0; r < NN; r++)
                w += n[r] * t[r];
        if (g >= ROD)
            for (int r = 0; r < NS; r++)
                w += n[r] * t[r];
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
    hobe_real e[9], n[NN], t[NN];
    gather(q0, x0);
    gather(u, x);
    for (int i = 0; i < 3 * V; i++)
        f[i * HOBE_PARTS] = zero;
    for (int i = 0; i < 9 * V * (V + 1) / 2; i++)
        K[i * HOBE_PARTS] = zero;
    for (int g = 0; g < inv->stations; g++) {
        const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;
        const double *Qn = inv->Qn + inv->step_n * g;
        const double *Qs = inv->Qs + inv->step_s * g;
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        if (g < ROD) {
            rod_differences(B, U, e, n);
            for (int r = 0; r < NN; r++)
                t[r] = zero;
            for (int c = 0; c < NN; c++)
                for (int r = 0; r < NN; r++)
                    t[r] += Qn[c * NN + r] * n[c];
        }
        if (g >= ROD) {
            section_strains(B, U, n);
            for (int r = 0; r < NS; r++)
                t[r] = zero;
            for (int c = 0; c < NS; c++)
                for (int r = 0; r < NS; r++)
                    t[r] += Qs[c * NS + r] * n[c];
        }
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++)
            B[i] += 0.5 * U[i];
        if (g < ROD)
            rod_stiffness(Qn, t, B, e, C);
        if (g >= ROD)
            section_stiffness(Qs, t, B, C);
        expand(N, Nx, inv->wx[g], C, K);
        if (g < ROD)
            rod_force(t, B, e, U);
        if (g >= ROD)
            section_force(t, B, U);
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

static void energy(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                   hobe_lanes *U)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        energy_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)U + h);
}

static void force(const struct hobe_invariants *inv, const hobe_lanes *q0,
                               const hobe_lanes *u, hobe_lanes *f, hobe_lanes *scratch)
{
    (void)scratch;
    for (int h = 0; h < HOBE_PARTS; h++)
        force_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h);
}

static void tangent(const struct hobe_invariants *inv, const hobe_lanes *q0,
                                 const hobe_lanes *u, hobe_lanes *f, hobe_lanes *K,
                                 hobe_lanes *scratch)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        tangent_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h,
                     (hobe_real *)K + h, (hobe_real *)scratch);
}

static const double node[] = {
    0.0, 1.0 / 2.0, 1.0,
};
static const struct hobe_vector vector[V] = {
    {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 0, 0}, {2, 1, 0},
    {2, 2, 0},
};
static const char *const mode_name[M] = {
    "1", "y", "z",
};
static const double axis_rule[][2] = {
    {0.2113248654051871, 0.5}, {0.7886751345948129, 0.5}, {0.0, 0.16666666666666666},
    {0.5, 0.6666666666666666}, {1.0, 0.16666666666666666},
};

extern const struct hobe_kernel HOBE_KERNEL(3333s);
const struct hobe_kernel HOBE_KERNEL(3333s) = {
    .abi = 8,
    .name = "3333s",
    .hash = "abcf9e0e56460d5e",
    .source = "Nachbagauer, Gruber & Gerstmayr 2013; Tang, Tian & Hu 2022, Table 7",
    .mechanics = "structural",
    .nodes = 3,
    .vectors = V,
    .modes = M,
    .functions = 0,
    .stations = 5,
    .degree = 1,
    .normals = NN,
    .shears = NS,
    .flops_force = 3535,
    .flops_tangent = 32279,
    .scratch = 225,
    .node = node,
    .axis_rule = axis_rule,
    .vector = vector,
    .mode = mode_name,
    .function = NULL,
    .shape = shape,
    .section_modes = section_modes,
    .invariants = invariants,
    .energy = energy,
    .force = force,
    .tangent = tangent,
    .axial = 0,
    .symmetry = NULL,
    .section = NULL,
    .section_cost = NULL,
    .tensor = NULL,
    .tensor_cost = NULL,
    .trilinear = NULL,
    .gram = NULL,
    .series = NULL,
    .strain = strain,
    .warping_strain = NULL,
};
