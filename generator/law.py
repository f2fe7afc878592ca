# SPDX-License-Identifier: GPL-3.0-or-later
"""C text of what an element makes of its section: vectors, laws, integrals, strains."""

from . import ctext, structural

REFERENCE = """\
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
"""

GRAM_LAW = """\
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
"""

RELIEF = """\
/* Strain at a point: what warping alone makes of yy, zz, 2yz becomes that of the mean strain. */
static void relieve(double e[6][NN + NS], double mean[6][NN + NS])
{
    for (int j = 0; j < S; j++)
        for (int i = 0; i <= j; i++)
            if (warps[i] && warps[j])
                for (int a = 1; a <= 3; a++)
                    e[a][gram_entry(i, j)] = mean[a][gram_entry(i, j)];
}
"""

SECTION_LAW = """\
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
RELIEVE        add_law(to, e, law->region + at->region, weight);
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
"""

RELIEVE = """\
        if (law->relieved)
            relieve(e, mean);
"""


def warping(element):
    """Of each section vector whether it is that of a warping function, whose name begins with w;
    empty where none is."""
    warps = [mode.startswith("w") for mode in element.declaration.modes]
    return warps + warps[1:] if any(warps) else []


def functions(element):
    if element.declaration.form == "structural":
        return [structural.LAW]
    if not (warps := warping(element)):
        return [GRAM_LAW, SECTION_LAW.replace("RELIEVE", "")]
    table = ctext.table("static const unsigned char warps[S]", [str(int(w)) for w in warps])
    return ["/* Of each section vector: whether it is that of a warping function. */",
            table + "\n", GRAM_LAW, RELIEF, SECTION_LAW.replace("RELIEVE", RELIEVE)]


INVARIANTS = """\
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
"""

STRAIN = """\
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
"""

WARPING_STRAIN = """\
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
"""


def strains(element):
    return [STRAIN, WARPING_STRAIN] if warping(element) else [STRAIN]
