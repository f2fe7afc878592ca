# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4 for the form "structural": a rod whose section can stretch and shear (Nachbagauer, Gruber
& Gerstmayr 2013), on the same shape functions.

With a = d_y, b = d_z the section carries a frame, the QR factors of (b, a),

    e_3 = b/|b|,  e_1 = a x b/|a x b|,  e_2 = e_3 x e_1,  a = alpha e_2 + gamma e_3,  b = beta e_3,

and the energy per length is a quadratic form in the changes since the reference of

    Gamma_i = e_i.r'                              stretch, two shears
    kappa   = 1/2 sum_i e_i x e_i', on the frame  torsion, two bendings
    E_yy = a.a/2,  E_zz = b.b/2,  2 E_yz = a.b    the section's own strain.

The first six are the rod's strains n.  Let Y_I be the components on the frame of the section
vectors D_I = r', a', b', a, b.  A change x of a and b turns the frame by the spin w = L x; seen
from the frame then, Y changes by x_I - w x Y_I.  L also makes the curvature, kappa = L (a', b'),
which changes by L (x_a' - kappa x x_a, x_b' - kappa x x_b).  Forces go the other way, by the
transpose: a moment m on the frame is the forces L' m on a and b, for which a x P_a + b x P_b = m.
So, with stresses t = Q n,

    P_r' = t_Gamma,   (P_a', P_b') = L' t_kappa,
    P_a = kappa x P_a',  P_b = kappa x P_b', and forces that balance the moment sum_I P_I x Y_I,

and the section's strains add their stresses times a and b.  For the tangent these lines are
differentiated, one component of D after the other: no matrix of second derivatives is written down.

Points on the axis: where shape functions have degree p, p Gauss points for the rod's strains, so
that they do not lock, and p + 1 Lobatto points for the section's, so that no motion is free.
"""

import sympy

from .form import (AXIAL, CLEAR_FORCE, CURRENT, INVARIANTS, VECTORS, axis3, filled, given,
                   hand_back, numbers, product)
from .ir import Do, Function, If, Let, Note, loop


def axis_rule(degree):
    """Positions and weights on [0, 1]: Gauss' rule, then Lobatto's, for shape functions of this
    degree p (Lobatto: both ends and the extrema of the Legendre polynomial P_p)."""
    x = sympy.Symbol("x")
    legendre = sympy.legendre_poly(degree, x, polys=True)
    slope = legendre.diff(x)
    gauss = [(r, 2 / ((1 - r**2) * slope.eval(r)**2)) for r in _roots(legendre)]
    lobatto = [(r, sympy.Rational(2, degree * (degree + 1)) / legendre.eval(r)**2)
               for r in (sympy.Integer(-1), *_roots(slope), sympy.Integer(1))]
    return [(float((1 + r) / 2), float(w / 2)) for r, w in gauss + lobatto]


def _roots(polynomial):
    return sorted(polynomial.nroots(n=40)) if polynomial.degree() > 0 else []


ROD, SECTION = "g < ROD", "g >= ROD"
VECTOR_ARRAYS = Do("hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];", free=True)
ARRAYS = Do("hobe_real e[9], n[NN], t[NN];", free=True)
LAW_AT = (Do("const double *Qn = inv->Qn + inv->step_n * g;", free=True),
          Do("const double *Qs = inv->Qs + inv->step_s * g;", free=True))
STRESS = (If(ROD, (Do("rod_differences(B, U, e, n);"), *product("NN", "Qn", "n", "t"))),
          If(SECTION, (Do("section_strains(B, U, n);"), *product("NS", "Qs", "n", "t"))))
FORCE = (If(ROD, (Do("rod_force(t, B, e, U);"),)),
         If(SECTION, (Do("section_force(t, B, U);"),)))


def functions():
    return (_expand(), _vector_product(), _add_product(), _components(), _frame(), _unit_change(),
            _spin(), _couple(), _rod_strains(), _rod_differences(), _slope_forces(), _balance(),
            _frame_force(), _rod_force(), _rod_stiffness(), _section_strains(),
            _section_stresses(), _section_force(), _section_stiffness(), _force_part(),
            _energy_part(), _tangent_part())


# ---- from stations to nodes ----------------------------------------------------------------------

def _force_part():
    return Function(
        "force_part",
        (INVARIANTS, *given("q0", "u"), *filled("f")),
        "f = dU/dq, eq. 27, for one part of a batch",
        (
            VECTOR_ARRAYS,
            ARRAYS,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            CLEAR_FORCE,
            loop("g", "inv->stations", AXIAL, *LAW_AT, *VECTORS, *STRESS, *CURRENT,
                 *FORCE, hand_back("U")),
        ))


def _energy_part():
    return Function(
        "energy_part",
        (INVARIANTS, *given("q0", "u"), *filled("energy")),
        "U = sum_g w_g s.sigma/2, eq. 26",
        (
            VECTOR_ARRAYS,
            ARRAYS,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            Do("hobe_real sum = zero;"),
            loop("g", "inv->stations", AXIAL, *LAW_AT, *VECTORS, *STRESS,
                 Do("hobe_real w = zero;"),
                 If(ROD, (loop("r", "NN", Do("w += n[r] * t[r];")),)),
                 If(SECTION, (loop("r", "NS", Do("w += n[r] * t[r];")),)),
                 Do("const double half = 0.5 * inv->wx[g];", free=True),
                 Do("sum += half * w;")),
            Do("energy[0] = sum;"),
        ))


def _expand():
    def add(c, i, j):
        return loop("e", "9", Do(f"k[e * HOBE_PARTS] += {c} * C[9 * (({i}) * S + {j}) + e];"))

    return Function(
        "expand",
        (*numbers("N", "Nx"), "double w", *given("C"), *filled("K")),
        "K_vw += w (N_v', N_v) [C] (N_w', N_w)^T for v >= w",
        (
            loop("v", "V", loop(
                "u", "v + 1",
                Let("i", "mode[v]"),
                Let("j", "mode[u]"),
                Do("hobe_real *k = K + 9 * HOBE_PARTS * hobe_pair(v, u);", free=True),
                Do("const double cxx = w * Nx[v] * Nx[u], cx = w * Nx[v] * N[u];", free=True),
                Do("const double xc = w * N[v] * Nx[u], cc = w * N[v] * N[u];", free=True),
                add("cxx", "i", "j"),
                If("j > 0", (add("cx", "i", "M - 1 + j"),)),
                If("i > 0", (add("xc", "M - 1 + i", "j"),)),
                If("i > 0 && j > 0", (add("cc", "M - 1 + i", "M - 1 + j"),)))),
        ))


def _tangent_part():
    return Function(
        "tangent_part",
        (INVARIANTS, *given("q0", "u"), *filled("f", "K", "C")),
        "f as in force_part and K = df/dq, eq. 28; C: scratch for the section stiffness",
        (
            VECTOR_ARRAYS,
            ARRAYS,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            CLEAR_FORCE,
            loop("i", "9 * V * (V + 1) / 2", Do("K[i * HOBE_PARTS] = zero;")),
            loop("g", "inv->stations", AXIAL, *LAW_AT, *VECTORS, *STRESS, *CURRENT,
                 If(ROD, (Do("rod_stiffness(Qn, t, B, e, C);"),)),
                 If(SECTION, (Do("section_stiffness(Qs, t, B, C);"),)),
                 Do("expand(N, Nx, inv->wx[g], C, K);"),
                 *FORCE, hand_back("U")),
        ))


# ---- frame and spin ------------------------------------------------------------------------------

def _vector_product():
    return Function(
        "vector_product", (*given("a", "b"), *filled("c")), "c = a x b",
        (Do("c[0] = a[1] * b[2] - a[2] * b[1];"),
         Do("c[1] = a[2] * b[0] - a[0] * b[2];"),
         Do("c[2] = a[0] * b[1] - a[1] * b[0];")), result="inline void")


def _add_product():
    return Function(
        "add_product", (*given("a", "b"), *filled("c")), "c += a x b",
        (Do("hobe_real p[3];", free=True),
         Do("vector_product(a, b, p);"),
         loop("i", "3", Do("c[i] += p[i];"))),
        result="inline void")


def _components():
    return Function(
        "components", (*given("e", "D"), *filled("Y")), "Y_Ii = e_i.D_I",
        (loop("k", "S", loop("i", "3", Do("Y[3 * k + i] = dot(e + 3 * i, D + 3 * k);"))),))


def _frame():
    return Function(
        "frame", (*given("a", "b"), *filled("e", "size")),
        "The frame e_1, e_2, e_3 of a section with d_y = a, d_z = b; size = |a x b|, |b|",
        (Do("vector_product(a, b, e);"),
         Do("size[0] = hobe_root(dot(e, e));"),
         Do("size[1] = hobe_root(dot(b, b));"),
         loop("i", "3", Do("e[i] = e[i] / size[0];"), Do("e[6 + i] = b[i] / size[1];")),
         Do("vector_product(e + 6, e, e + 3);")))


def _unit_change():
    return Function(
        "unit_change", (*given("n"), "hobe_real size", *given("d"), *filled("t")),
        "t = the change of the unit vector n of a vector size * n that changes by d, with all its\n"
        " * digits however small d is",
        (Do("hobe_real v[3];", free=True),
         loop("i", "3", Do("v[i] = size * n[i] + d[i];")),
         Do("const hobe_real now = hobe_root(dot(v, v));"),
         Do("const hobe_real more = (dot(d, d) + 2.0 * size * dot(n, d)) / (now + size);"),
         loop("i", "3", Do("t[i] = (d[i] - more * n[i]) / now;"))))


def _spin():
    return Function(
        "spin", (*given("Y", "a", "b"), *filled("w")),
        "w = L (a, b), the spin of the frame with changes a, b of Y_a = (0, alpha, gamma) and\n"
        " * Y_b = (0, 0, beta); components 10, 11 and 14 of Y",
        (Do("w[0] = zero - b[1] / Y[14];"),
         Do("w[1] = b[0] / Y[14];"),
         Do("w[2] = (w[1] * Y[11] - a[0]) / Y[10];")))


def _couple():
    return Function(
        "couple", (*given("Y", "m"), *filled("P")), "P[2][3] = L' m, forces on a and b",
        (Do("P[0] = zero - m[2] / Y[10];"),
         Do("P[1] = zero;"),
         Do("P[2] = zero;"),
         Do("P[3] = (m[1] - Y[11] * P[0]) / Y[14];"),
         Do("P[4] = zero - m[0] / Y[14];"),
         Do("P[5] = zero;")))


# ---- the rod's part, in components on its frame --------------------------------------------------

def _rod_strains():
    return Function(
        "rod_strains", (*given("kappa", "Y", "x"), *filled("n")),
        "n[NN] = the changes of Gamma and kappa where components have changed by x to Y",
        (Do("hobe_real p[6];", free=True),
         loop("i", "3", Do("n[i] = x[i];")),
         loop("i", "6", Do("p[i] = x[3 + i];")),
         Do("add_product(x + 9, kappa, p);"),
         Do("add_product(x + 12, kappa, p + 3);"),
         Do("spin(Y, p, p + 3, n + 3);")))


def _rod_differences():
    return Function(
        "rod_differences", (*given("B", "U"), *filled("e", "n")),
        "n = changes of the rod's strains, without cancellation, and the frame e after them.  A\n"
        " * product changes by (change of one) (mean of the other) + the reverse: e_i changes by\n"
        " * t, D by U, and B is the mean of D.",
        (Do("hobe_real D[3 * S], Y[3 * S], x[3 * S], t[9], d[3], size[2], kappa[3];", free=True),
         loop("i", "3 * S", Do("D[i] = B[i] - 0.5 * U[i];")),
         Do("frame(D + 9, D + 12, e, size);"),
         Do("components(e, D, Y);"),
         Do("spin(Y, Y + 3, Y + 6, kappa);"),
         Do("vector_product(U + 9, B + 12, d);"),
         Do("add_product(B + 9, U + 12, d);"),
         Do("unit_change(e, size[0], d, t);"),
         Do("unit_change(e + 6, size[1], U + 12, t + 6);"),
         loop("i", "3", Do("e[i] += 0.5 * t[i];"), Do("e[6 + i] += 0.5 * t[6 + i];")),
         Do("vector_product(t + 6, e, t + 3);"),
         Do("add_product(e + 6, t, t + 3);"),
         loop("i", "3", Do("e[3 + i] += 0.5 * t[3 + i];")),
         loop("k", "S", loop("i", "3", Do(
             "x[3 * k + i] = dot(t + 3 * i, B + 3 * k) + dot(e + 3 * i, U + 3 * k);"))),
         loop("i", "3 * S", Do("Y[i] += x[i];")),
         Do("rod_strains(kappa, Y, x, n);"),
         loop("i", "9", Do("e[i] += 0.5 * t[i];"))))


def _slope_forces():
    return Function(
        "slope_forces", (*given("t", "p"), *filled("P")),
        "P_r' = t, (P_a', P_b') = p, nothing yet on a and b",
        (loop("i", "3", Do("P[i] = t[i];")),
         loop("i", "6", Do("P[3 + i] = p[i];"), Do("P[9 + i] = zero;"))))


def _balance():
    return Function(
        "balance", (*given("Y"), *filled("m", "P")),
        "Adds to P the forces on a and b that balance m and the moment of P",
        (Do("hobe_real p[6];", free=True),
         loop("k", "S", Do("add_product(P + 3 * k, Y + 3 * k, m);")),
         Do("couple(Y, m, p);"),
         loop("i", "6", Do("P[9 + i] += p[i];"))))


MOMENT = Do("hobe_real m[3] = {zero, zero, zero};", free=True)


def _frame_force():
    return Function(
        "frame_force", (*given("t", "Y"), *filled("kappa", "p", "P")),
        "The components of P_I = dW/dD_I, the curvature, and p = L' t_kappa",
        (MOMENT,
         Do("spin(Y, Y + 3, Y + 6, kappa);"),
         Do("couple(Y, t + 3, p);"),
         Do("slope_forces(t, p, P);"),
         Do("add_product(kappa, p, P + 9);"),
         Do("add_product(kappa, p + 3, P + 12);"),
         Do("balance(Y, m, P);")))


def _rod_force():
    return Function(
        "rod_force", (*given("t", "D", "e"), *filled("P")), "P_I = dW/dD_I of the rod's strains",
        (Do("hobe_real Y[3 * S], F[3 * S], kappa[3], p[6];", free=True),
         Do("components(e, D, Y);"),
         Do("frame_force(t, Y, kappa, p, F);"),
         loop("k", "S", axis3(
             "P[3 * k + a] = e[a] * F[3 * k] + e[3 + a] * F[3 * k + 1] + e[6 + a] * F[3 * k + 2];"
         ))))


def _force_change():
    """P from the changes n of strains, s of stresses, x of components; F, kappa and p are those of
    frame_force."""
    return (
        Note("frame_force differentiated"),
        loop("i", "3", Do("m[i] = s[3 + i];")),
        Do("add_product(p, x + 9, m);"),
        Do("add_product(p + 3, x + 12, m);"),
        Do("couple(Y, m, q);"),
        Do("slope_forces(s, q, P);"),
        loop("i", "2",
             Do("add_product(n + 3, p + 3 * i, P + 9 + 3 * i);"),
             Do("add_product(kappa, q + 3 * i, P + 9 + 3 * i);")),
        loop("i", "3", Do("m[i] = zero;")),
        loop("k", "S", Do("add_product(F + 3 * k, x + 3 * k, m);")),
        Do("balance(Y, m, P);"),
    )


def _rod_stiffness():
    return Function(
        "rod_stiffness", (*numbers("Q"), *given("t", "D", "e"), *filled("C")),
        "C_IJ = d2W/dD_I dD_J of the rod's strains, column by column: the change of rod_force\n"
        " * with component b of D_J",
        (Do("hobe_real Y[3 * S], F[3 * S], x[3 * S], P[3 * S];", free=True),
         Do("hobe_real kappa[3], w[3], m[3], p[6], q[6], n[NN], s[NN];", free=True),
         Do("components(e, D, Y);"),
         Do("frame_force(t, Y, kappa, p, F);"),
         loop(
             "j", "S", loop(
                 "b", "3",
                 loop("i", "3 * S", Do("x[i] = zero;")),
                 loop("i", "3", Do("x[3 * j + i] = e[3 * i + b];")),
                 Do("spin(Y, x + 9, x + 12, w);"),
                 loop("k", "S", Do("add_product(Y + 3 * k, w, x + 3 * k);")),
                 Do("rod_strains(kappa, Y, x, n);"),
                 *product("NN", "Q", "n", "s"),
                 *_force_change(),
                 loop("k", "S",
                      Do("hobe_real *f = P + 3 * k, *c_ab = C + 9 * (k * S + j) + b;", free=True),
                      Do("add_product(w, F + 3 * k, f);"),
                      axis3("c_ab[3 * a] = e[a] * f[0] + e[3 + a] * f[1] + e[6 + a] * f[2];"))))))


# ---- the section's part --------------------------------------------------------------------------

def _section_strains():
    return Function(
        "section_strains", (*given("D", "x"), *filled("s")),
        "s[NS] = the changes of E_yy, E_zz, 2 E_yz where D, their mean, changes by x",
        (Do("s[0] = dot(D + 9, x + 9);"),
         Do("s[1] = dot(D + 12, x + 12);"),
         Do("s[2] = dot(D + 9, x + 12) + dot(D + 12, x + 9);")))


def _section_stresses():
    return Function(
        "section_stresses", (*given("t", "D"), *filled("P")),
        "P_a, P_b += the stresses t[NS] times a and b",
        (axis3("P[9 + a] += t[0] * D[9 + a] + t[2] * D[12 + a];"),
         axis3("P[12 + a] += t[1] * D[12 + a] + t[2] * D[9 + a];")))


def _section_force():
    return Function(
        "section_force", (*given("t", "D"), *filled("P")),
        "P_I = dW/dD_I of the section's strains",
        (loop("i", "3 * S", Do("P[i] = zero;")),
         Do("section_stresses(t, D, P);")))


def _section_stiffness():
    return Function(
        "section_stiffness", (*numbers("Q"), *given("t", "D"), *filled("C")),
        "C_IJ = d2W/dD_I dD_J of the section's strains, column by column",
        (Do("hobe_real x[3 * S], P[3 * S], n[NS], s[NS];", free=True),
         loop("i", "9 * S * S", Do("C[i] = zero;")),
         loop(
             "j", "S", If("j >= M", (loop(
                 "b", "3",
                 loop("i", "3 * S", Do("x[i] = zero;"), Do("P[i] = zero;")),
                 Do("x[3 * j + b] += 1.0;"),
                 Do("section_strains(D, x, n);"),
                 *product("NS", "Q", "n", "s"),
                 Do("section_stresses(s, D, P);"),
                 Do("section_stresses(t, x, P);"),
                 loop("k", "S", axis3("C[9 * (k * S + j) + 3 * a + b] = P[3 * k + a];"))),)))))


# ---- the section's law ---------------------------------------------------------------------------

LAW = """\
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
"""
