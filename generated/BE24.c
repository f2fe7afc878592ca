/* BE24: Yakoub & Shabana 2001; Tang, Tian & Hu 2022, Table 2
 *
 * Written by `python -m generator`, declaration 20f030f25728ccec: do not edit.
 * nodes at xi = 0 1; 8 vectors, 24 degrees of freedom
 * modes 1 y z
 * the energy is exact with 5 Gauss points on the axis
 * vectors (mode@node, ' for d/dx): 1@1 1'@1 y@1 z@1 1@2 1'@2 y@2 z@2
 * operations per element: force 3987, force and tangent 24012, energy 2887
 */
#include "kernel.h"

#if HOBE_KERNEL_ABI != 1
#error Regenerate: this file was written for another kernel ABI
#endif

enum {
    V = 8,  /* nodal vectors */
    M = 3,  /* section modes */
    S = 5,  /* section vectors d_k', d_k */
    NA = 6, /* Gram pairs d_k'.d_l' */
    NN = 9, /* normal block: those and d_k.d_l */
    NS = 6, /* shear block: d_k'.d_l */
    A = 6,  /* distinct axial functions */
};

static const hobe_real zero = {0};

/* Of each nodal vector: mode; whether it is a position; axial function. */
static const unsigned char mode[V] = {
    0, 0, 1, 2, 0, 0, 1, 2,
};
static const unsigned char position[V] = {
    1, 0, 0, 0, 1, 0, 0, 0,
};
static const unsigned char axial_of[V] = {
    0, 1, 2, 2, 3, 4, 5, 5,
};
static const unsigned char is_slope[A] = {
    0, 1, 0, 0, 1, 0,
};

/* int_0^1 A_i A_j dxi, exact */
static const double overlap[A * A] = {
    13.0 / 35.0, 11.0 / 210.0, 7.0 / 20.0, 9.0 / 70.0, -13.0 / 420.0, 3.0 / 20.0, 11.0 / 210.0,
    1.0 / 105.0, 1.0 / 20.0, 13.0 / 420.0, -1.0 / 140.0, 1.0 / 30.0, 7.0 / 20.0, 1.0 / 20.0,
    1.0 / 3.0, 3.0 / 20.0, -1.0 / 30.0, 1.0 / 6.0, 9.0 / 70.0, 13.0 / 420.0, 3.0 / 20.0,
    13.0 / 35.0, -11.0 / 210.0, 7.0 / 20.0, -13.0 / 420.0, -1.0 / 140.0, -1.0 / 30.0,
    -11.0 / 210.0, 1.0 / 105.0, -1.0 / 20.0, 3.0 / 20.0, 1.0 / 30.0, 1.0 / 6.0, 7.0 / 20.0,
    -1.0 / 20.0, 1.0 / 3.0,
};

static inline int symmetric(int i, int j)
{
    return i >= j ? hobe_pair(i, j) : hobe_pair(j, i);
}

static void shape(double xi, double length, double *N, double *Nx)
{
    const double A_xi[A][2] = { /* A_i(xi), dA_i/dxi */
        {1.0 + xi * (xi * (-3.0 + xi * 2.0)),
         xi * (-6.0 + xi * 6.0)},
        {xi * (1.0 + xi * (-2.0 + xi * 1.0)),
         1.0 + xi * (-4.0 + xi * 3.0)},
        {1.0 + xi * (-1.0),
         (-1.0)},
        {xi * (xi * (3.0 + xi * (-2.0))),
         xi * (6.0 + xi * (-6.0))},
        {xi * (xi * (-1.0 + xi * 1.0)),
         xi * (-2.0 + xi * 3.0)},
        {xi * 1.0,
         1.0},
    };
    for (int v = 0; v < V; v++) {
        const int i = axial_of[v];
        N[v] = A_xi[i][0] * (is_slope[i] ? length : 1.0);
        Nx[v] = A_xi[i][1] * (is_slope[i] ? 1.0 : 1.0 / length);
    }
}

static void section_modes(double y, double z, const double (*f)[3],
                          double (*phi)[3])
{
    (void)f;
    phi[0][0] = 1.0;
    phi[0][1] = 0.0;
    phi[0][2] = 0.0;
    phi[1][0] = y;
    phi[1][1] = 1.0;
    phi[1][2] = 0.0;
    phi[2][0] = z;
    phi[2][1] = 0.0;
    phi[2][2] = 1.0;
}

/* Rows that give the strains at a point from the Gram differences: eps_xx, eps_yy, eps_zz, 2eps_yz
 * from the normal block, 2eps_xz, 2eps_xy from the shear block. */
static void strain_rows(const double (*phi)[3], double weight, double *en, double *es)
{
    for (int k = 0; k < M; k++)
        for (int l = 0; l <= k; l++)
            en[hobe_pair(k, l)] += weight * phi[k][0] * phi[l][0];
    for (int k = 1; k < M; k++)
        for (int l = 1; l <= k; l++) {
            double *e = en + NA + hobe_pair(k - 1, l - 1);
            e[1 * NN] += weight * phi[k][1] * phi[l][1];
            e[2 * NN] += weight * phi[k][2] * phi[l][2];
            e[3 * NN] += weight * (phi[k][1] * phi[l][2] + phi[l][1] * phi[k][2]);
        }
    for (int k = 0; k < M; k++)
        for (int l = 1; l < M; l++) {
            es[k * (M - 1) + l - 1] += weight * phi[k][0] * phi[l][2];
            es[NS + k * (M - 1) + l - 1] += weight * phi[k][0] * phi[l][1];
        }
}

/* Q += weight * sum_ab e_a C_ab e_b' over the rows e, lower triangle. */
static void add_law(double *Qn, double *Qs, const double *en, const double *es,
                    const double normal[3][3], const double shear[3], double weight)
{
    for (int r = 0; r < NN; r++) {
        double h[4] = {0};
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                h[a] += weight * normal[a][b] * en[b * NN + r];
        h[3] = weight * shear[0] * en[3 * NN + r];
        for (int c = 0; c <= r; c++)
            Qn[r * NN + c] += h[0] * en[c] + h[1] * en[NN + c] + h[2] * en[2 * NN + c] +
                              h[3] * en[3 * NN + c];
    }
    for (int r = 0; r < NS; r++) {
        const double h[2] = {weight * shear[1] * es[r], weight * shear[2] * es[NS + r]};
        for (int c = 0; c <= r; c++)
            Qs[r * NS + c] += h[0] * es[c] + h[1] * es[NS + c];
    }
}

static void mirror(double *Q, int n)
{
    for (int r = 0; r < n; r++)
        for (int c = 0; c < r; c++)
            Q[c * n + r] = Q[r * n + c];
}

/* Section part: Q of the law at each point and of the law on the mean strain. */
static void section_law(struct hobe_invariants *inv, const struct hobe_section_rule *rule,
                        const struct hobe_section_rule *mean, const struct hobe_elasticity *law)
{
    double en[4 * NN], es[2 * NS], phi[M][3], area = 0.0, total = 0.0;
    for (int i = 0; i < NN * NN; i++)
        inv->Qn[i] = 0.0;
    for (int i = 0; i < NS * NS; i++)
        inv->Qs[i] = 0.0;
    for (int p = 0; p < rule->points; p++) {
        const struct hobe_section_point *at = rule->point + p;
        for (int i = 0; i < 4 * NN; i++)
            en[i] = 0.0;
        for (int i = 0; i < 2 * NS; i++)
            es[i] = 0.0;
        section_modes(at->y, at->z, at->f, phi);
        strain_rows((const double(*)[3])phi, 1.0, en, es);
        add_law(inv->Qn, inv->Qs, en, es, law->normal, law->shear, at->weight);
        area += at->weight;
    }
    for (int i = 0; i < 4 * NN; i++)
        en[i] = 0.0;
    for (int i = 0; i < 2 * NS; i++)
        es[i] = 0.0;
    for (int p = 0; p < mean->points; p++)
        total += mean->point[p].weight;
    for (int p = 0; p < mean->points; p++) {
        const struct hobe_section_point *at = mean->point + p;
        section_modes(at->y, at->z, at->f, phi);
        strain_rows((const double(*)[3])phi, at->weight / total, en, es);
    }
    add_law(inv->Qn, inv->Qs, en, es, law->mean_normal, law->mean_shear, area);
    mirror(inv->Qn, NN);
    mirror(inv->Qs, NS);
    inv->step_n = inv->step_s = 0;
}

/* mass_vw = density int phi_k phi_l dA int N_v N_w dx */
static void mass_matrix(struct hobe_invariants *inv, const struct hobe_section_rule *rule,
                        double density)
{
    double moment[M][M] = {{0}}, phi[M][3];
    for (int p = 0; p < rule->points; p++) {
        const struct hobe_section_point *at = rule->point + p;
        section_modes(at->y, at->z, at->f, phi);
        for (int k = 0; k < M; k++)
            for (int l = 0; l < M; l++)
                moment[k][l] += at->weight * phi[k][0] * phi[l][0];
    }
    for (int v = 0; v < V; v++)
        for (int w = 0; w < V; w++) {
            const int i = axial_of[v], j = axial_of[w];
            double axis = overlap[i * A + j] * inv->length;
            axis *= (is_slope[i] ? inv->length : 1.0) * (is_slope[j] ? inv->length : 1.0);
            inv->mass[v * V + w] = density * moment[mode[v]][mode[w]] * axis;
        }
}

static void invariants(struct hobe_invariants *inv, const double (*gauss)[2],
                       const struct hobe_section_rule *rule, const struct hobe_section_rule *mean,
                       const struct hobe_elasticity *law, double density)
{
    for (int g = 0; g < inv->stations; g++) {
        inv->xi[g] = gauss[g][0];
        inv->wx[g] = gauss[g][1] * inv->length;
        shape(gauss[g][0], inv->length, inv->N + V * g, inv->Nx + V * g);
    }
    section_law(inv, rule, mean, law);
    mass_matrix(inv, rule, density);
}

/* E = sym(G0' H + H' H / 2), G0 the reference gradient, H = du/dX: written with G0 + H/2. */
static void strain(const double *N, const double *Nx, const double (*phi)[3], const double *q0,
                   const double *u, double *E)
{
    double G[3][3] = {{0}}, H[3][3] = {{0}};
    for (int v = 0; v < V; v++) {
        const double *p = phi[mode[v]];
        const double gradient[3] = {Nx[v] * p[0], N[v] * p[1], N[v] * p[2]};
        for (int b = 0; b < 3; b++)
            for (int a = 0; a < 3; a++) {
                /* the first node's position drops out: sum_v gradient_v = 0 over positions */
                const double origin = position[v] ? 1.0 : 0.0;
                const double du = u[3 * v + a] - origin * u[a];
                G[b][a] += gradient[b] * (q0[3 * v + a] - origin * q0[a] + 0.5 * du);
                H[b][a] += gradient[b] * du;
            }
    }
    static const int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    for (int i = 0; i < 6; i++) {
        const int b = voigt[i][0], c = voigt[i][1];
        E[i] = 0.0;
        for (int a = 0; a < 3; a++)
            E[i] += b == c ? G[b][a] * H[b][a] : G[b][a] * H[c][a] + H[b][a] * G[c][a];
    }
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
static void stress(const double *Qn, const double *Qs, const hobe_real *n, const hobe_real *s,
                   hobe_real *tn, hobe_real *ts)
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
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        differences(B, U, n, s);
        stress(Qn, Qs, n, s, tn, ts);
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
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        differences(B, U, n, s);
        stress(Qn, Qs, n, s, tn, ts);
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
        polar(N, Nx, x0, x, B, U);
        differences(B, U, n, s);
        stress(Qn, Qs, n, s, tn, ts);
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

/* C_IJ = d2W/dD_I dD_J = sum_K D_K T_(IK)^T + sigma_IJ 1, all S x S blocks, by columns:
 * T_r = sum_L Q_r(JL) D_L is the change of every stress resultant with D_J */
static void section_stiffness(const double *Qn, const double *Qs, const hobe_real *tn,
                              const hobe_real *ts, const hobe_real *D, hobe_real *C, hobe_real *T)
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
        section_vectors(N, Nx, x0, B);
        section_vectors(N, Nx, x, U);
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        differences(B, U, n, s);
        stress(Qn, Qs, n, s, tn, ts);
        /* D = D0 + U */
        for (int i = 0; i < 3 * S; i++) {
            B[i] += 0.5 * U[i];
        }
        section_stiffness(Qn, Qs, tn, ts, B, C, C + 9 * S * S);
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
    0.0, 1.0,
};
static const struct hobe_vector vector[V] = {
    {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 2, 0},
};
static const char *const mode_name[M] = {
    "1", "y", "z",
};

extern const struct hobe_kernel HOBE_KERNEL(BE24);
const struct hobe_kernel HOBE_KERNEL(BE24) = {
    .abi = 1,
    .name = "BE24",
    .hash = "20f030f25728ccec",
    .source = "Yakoub & Shabana 2001; Tang, Tian & Hu 2022, Table 2",
    .mechanics = "average",
    .nodes = 2,
    .vectors = V,
    .modes = M,
    .functions = 0,
    .stations = 5,
    .degree = 1,
    .normals = NN,
    .shears = NS,
    .flops_force = 3987,
    .flops_tangent = 24012,
    .scratch = 135,
    .node = node,
    .vector = vector,
    .mode = mode_name,
    .function = NULL,
    .shape = shape,
    .section_modes = section_modes,
    .invariants = invariants,
    .energy = energy,
    .force = force,
    .tangent = tangent,
    .trilinear = trilinear,
    .strain = strain,
};
