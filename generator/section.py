# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4, the plan "section": eqs. 27 and 28 from station to station along the axis, for any beam.

At a station of the axis the energy per length is a quadratic form in the Gram differences of the
2M-1 section vectors D_I = (d_k', d_k), so that the rows Q, S and R of its derivatives by D_I are
products with constant matrices (products.py), one set for each station or, where the beam is
straight and prismatic, for all.  There d_k' counts as even in x and d_k as odd; taper, curvature
and pretwist mix them, and mix y and z as they please.

Rows (I, J) of the stations become rows (i, j) of nodal vectors with the weights w N_i^(a) N_j^(b),
a, b = 0, 1 derivatives.  Stations come in pairs about mid-length, g and its mirror image, and so do
nodal vectors.  With the sign s = (-1)^(a+b) of a derivative about mid-length, and c, c' the weights
and T, T' the rows of both stations,

    c T + c' T' = 1/2 (c + s c') (T + s T')  +  1/2 (c - s c') (T - s T'),

and the row of the mirror image, whose weights are +-s c' and +-s c, is +-(first part - second
part): each part is summed once for two blocks of the tangent.  What follows is as in tensor.py.
"""

from . import tensor
from .form import (AXIAL, CLEAR_FORCE, CURRENT, INVARIANTS, VECTORS, axis3, filled, given,
                   hand_back, numbers)
from .ir import Do, Function, If, Let, Note, loop
from .products import Products, by_class, pair
from .tensor import ROW

MORE_STATIONS = 2  # HOBE_MORE_STATIONS of kernel.h
LAW = Do("const double *H = inv->section + AXIAL * inv->stations + inv->step * g;", free=True)


def products(element):
    """The Products of an element's section vectors."""
    s = element.sizes["S"]
    parity = parities(element)
    pairs = [(t, v) for t in range(s) for v in range(t + 1)]
    kind = {p: parity[p[0]] ^ parity[p[1]] for p in pairs}
    pairs, first = by_class(pairs, kind, lambda p: p[0] != p[1])
    rows = tuple(pair(*p) for p in pairs)
    return Products("sectional", s, tuple(range(s)), pairs, first, rows, first, rows,
                    tuple(max(n, s) for n in first))


def parities(element):
    """Of each section vector: 1 odd in x, 2 odd in y, 4 odd in z."""
    parity = [2 * y + 4 * z for y, z in (mode.parity for mode in element.modes)]
    return parity + [p + 1 for p in parity[1:]]


def sizes(element):
    """Names and values of the constants of the loops."""
    s = element.sizes["S"]
    return {"GRAMS": s * (s + 1) // 2, "AXIAL": 8 * element.sizes["A"]**2}


def tables(element):
    """Integer tables of the loops by name."""
    vectors = element.declaration.vectors
    order = sorted(range(len(vectors)), key=lambda v: vectors[v].mode)
    opposed = tensor.layout(element).opposed
    order = [v for v in order if v >= opposed]
    modes = [vectors[v].mode for v in order]
    return {"by_mode": order,
            "first_of": [sum(m < k for m in modes) for k in range(element.sizes["M"] + 1)]}


def scratch(element, blocks):
    """Numbers that the tangent works with: Q of the rows of nodal vectors; products; the rows of
    all stations."""
    s, grams = element.sizes["S"], sizes(element)["GRAMS"]
    return blocks + 9 * grams - 3 * s + 10 * grams * (element.stations + MORE_STATIONS)


# ---- loop nests ----------------------------------------------------------------------------------

def functions():
    """The loop nests, the same for every element."""
    return (_section_force(), _force_part(), _energy_part(), _polar(), _trilinear_part(),
            _gram_part(), _station_rows(), _even_and_odd(), _nodal_blocks(), _tangent_part())


def _section_force():
    def row(first, last, entry):
        return loop("j", last, Do(f"const hobe_real t = Q[{entry}];", free=True),
                    axis3("P[3 * i + a] += t * D[3 * j + a];"), first=first)

    return Function(
        "section_force",
        (*given("Q", "D"), *filled("P")),
        "P_I = dW/dD_I = sum_J Q_IJ D_J",
        (loop("i", "S",
              axis3("P[3 * i + a] = zero;"),
              row("0", "i", "hobe_pair(i, j)"),
              row("i", "S", "hobe_pair(j, i)")),))


ARRAYS = Do("hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S], gamma[GRAMS], Q[GRAMS];", free=True)
STRESS = (
    Do("column_differences(sectional, B, U, gamma);"),
    Do("row_stress(sectional, H, inv->symmetry, gamma, Q);"),
)


def _force_part():
    return Function(
        "force_part",
        (INVARIANTS, *given("q0", "u"), *filled("f")),
        "f = dU/dq, eq. 27, for one part of a batch",
        (
            ARRAYS,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            CLEAR_FORCE,
            loop("g", "inv->stations", AXIAL, LAW, *VECTORS, *STRESS, *CURRENT,
                 Do("section_force(Q, B, U);"), hand_back("U")),
        ))


def _energy_part():
    return Function(
        "energy_part",
        (INVARIANTS, *given("q0", "u"), *filled("energy")),
        "U = sum_g w_g s.sigma/2, eq. 26",
        (
            ARRAYS,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            Do("hobe_real sum = zero;"),
            loop("g", "inv->stations", AXIAL, LAW, *VECTORS, *STRESS,
                 Do("hobe_real w = zero;"),
                 loop("p", "GRAMS",
                      Do("const int row = hobe_pair(sectional->pair_t[p], sectional->pair_v[p]);",
                         free=True),
                      Do("w += gamma[p] * Q[row];")),
                 Do("const double half = 0.5 * inv->wx[g];", free=True),
                 Do("sum += half * w;")),
            Do("energy[0] = sum;"),
        ))


def _polar():
    return Function(
        "polar",
        (*numbers("N", "Nx"), *given("b", "c"), *filled("B", "C")),
        "section vectors of b/2 and of c",
        (
            Do("section_vectors(N, Nx, b, B);"),
            Do("section_vectors(N, Nx, c, C);"),
            loop("i", "3 * S", Do("B[i] = 0.5 * B[i];")),
        ))


def _trilinear_part():
    return Function(
        "trilinear_part",
        (INVARIANTS, *given("qa", "qb", "qc"), *filled("f")),
        "f = T(a; b, c): Q of the Gram entries of b and c in polar form, applied to D(a)",
        (
            Do("hobe_real xa[3 * V];", free=True),
            ARRAYS,
            Do("gather(qa, xa);"),
            Do("gather(qb, x0);"),
            Do("gather(qc, x);"),
            CLEAR_FORCE,
            loop("g", "inv->stations", AXIAL, LAW,
                 Do("polar(N, Nx, x0, x, B, U);"),
                 *STRESS,
                 Do("section_vectors(N, Nx, xa, B);"),
                 Do("section_force(Q, B, U);"), hand_back("U")),
        ))


def _gram_part():
    return Function(
        "gram_part",
        (INVARIANTS, *given("qb", "qc"), *filled("strain", "stress")),
        "the Gram entries of b and c in polar form, and w_g Q of them",
        (
            ARRAYS,
            Do("gather(qb, x0);"),
            Do("gather(qc, x);"),
            loop("g", "inv->stations", AXIAL, LAW,
                 Do("polar(N, Nx, x0, x, B, U);"),
                 *STRESS,
                 loop("p", "GRAMS",
                      Do("const int row = hobe_pair(sectional->pair_t[p], sectional->pair_v[p]);",
                         free=True),
                      Do("strain[(GRAMS * g + p) * HOBE_PARTS] = gamma[p];", free=True),
                      Do("stress[(GRAMS * g + p) * HOBE_PARTS] = inv->wx[g] * Q[row];"))),
        ))


def _station_rows():
    return Function(
        "station_rows",
        (INVARIANTS, "int g", *given("x0", "x"), *filled("X", "T")),
        "T = the rows (I, J) of station g: Q[GRAMS], symmetric[GRAMS][6], skew[GRAMS][3]",
        (
            Do("hobe_real B[3 * S], U[3 * S], *Z = X + 6 * GRAMS;", free=True),
            Do("hobe_real *sym = T + GRAMS, *skew = T + 7 * GRAMS;", free=True),
            AXIAL, LAW, *VECTORS,
            Do("column_differences(sectional, B, U, X);"),
            *CURRENT,
            Do("H = row_stress(sectional, H, inv->symmetry, X, T);"),
            Do("products(sectional, B, X, Z);"),
            Do("H = row_symmetric(sectional, H, inv->symmetry, X, sym);"),
            Do("row_skew(sectional, H, inv->symmetry, Z, skew);"),
            loop("i", "S", axis3("skew[3 * hobe_pair(i, i) + a] = zero;")),
        ))


def _even_and_odd():
    return Function(
        "even_and_odd", filled("T", "W"),
        "T + s T' and T - s T' of the rows T of a station and T' = W of its mirror image",
        (loop("i", "S", loop("j", "i + 1",
                             Let("r", "hobe_pair(i, j)"), Let("along", "(i < M) == (j < M)"),
                             Do("hobe_real *plus = along ? T : W, *minus = along ? W : T;",
                                free=True),
                             loop("e", "10",
                                  Do("const int at = e < 1 ? r : e < 7 ? GRAMS + 6 * r + e - 1 :"
                                     "\n                     7 * GRAMS + 3 * r + e - 7;",
                                     free=True),
                                  Do("const hobe_real sum = T[at] + W[at], less = T[at] - W[at];"),
                                  Do("plus[at] = sum;", free=True),
                                  Do("minus[at] = less;", free=True)))),))


def _pair_of_rows():
    """Of the i-th and the j-th nodal vector in the order of modes, which are k and l."""
    sums = [f"s{e}" for e in range(10)]

    def add(n, sign):
        at = [f"t[p{n}]", *(f"t[GRAMS + 6 * p{n} + {e}]" for e in range(6)),
              *(f"w[7 * GRAMS + 3 * p{n} + {e}]" for e in range(3))]
        return [Do(f"{s} {sign if e > 6 else '+'}= {f'd{n}' if e > 6 else f'c[{n}]'} * {at[e]};")
                for e, s in enumerate(sums)]

    def store(x, row):
        return (Do(f"Q[{row}] = {x}[0];", free=True),
                Do(f"block({x} + 1, {x} + 7, {x}, K + 9 * HOBE_PARTS * {row});"))

    return (
        Let("v", "larger(by_mode[i], by_mode[j])"), Let("u", "by_mode[i] + by_mode[j] - v"), *ROW,
        Let("a", "mode[v]"), Let("b", "mode[u]"), Let("parts", "(m <= n) + (m < n)"),
        Let("p0", "symmetric(a, b)"), Let("p1", "symmetric(a, M - 1 + b)"),
        Let("p2", "symmetric(M - 1 + a, b)"), Let("p3", "symmetric(M - 1 + a, M - 1 + b)"),
        Do("const int side = a < b ? -1 : 1;", free=True),
        Do("hobe_real x[20], y[10];", free=True),
        loop("z", "parts",
             Let("part", "odd_of[v] ^ odd_of[u] ^ z"),
             Let("turned", "part ^ (nodal->mirror[v] < nodal->mirror[u])"),
             *(Do("hobe_real " + ", ".join(f"{s} = zero" for s in half) + ";", free=True)
               for half in (sums[:5], sums[5:])),
             loop("g", "last + 1",
                  Let("image", "inv->stations - 1 - g"),
                  Let("same", "part ? image : g"), Let("other", "turned ? image : g"),
                  Do("const hobe_real *t = T + 10 * GRAMS * same;", free=True),
                  Do("const hobe_real *w = T + 10 * GRAMS * other;", free=True),
                  Do("const double *c = inv->section + AXIAL * g + 4 * part +\n"
                     "                  8 * (A * axial_of[v] + axial_of[u]);", free=True),
                  Do("const double *d = c + 4 * (turned - part);", free=True),
                  Do("const double d0 = side * d[0], d1 = d[1], d2 = d[2], "
                     "d3 = side * d[3];", free=True),
                  *add(0, "+"),
                  If("b > 0", add(1, "-")),
                  If("a > 0", add(2, "+")),
                  If("a > 0 && b > 0", add(3, "+"))),
             *(Do(f"x[10 * z + {e}] = {s};", free=True) for e, s in enumerate(sums)),
             If("v == u", (loop("e", "3", Do("x[10 * z + 7 + e] = zero;")),))),
        If("parts == 1", store("x", "m")),
        If("parts == 2", (
            loop("e", "10", Do("y[e] = x[e] + x[10 + e];")), *store("y", "m"),
            loop("e", "10", Do("y[e] = x[e] - x[10 + e];")), *store("y", "n"))))


def _nodal_blocks():
    return Function(
        "nodal_blocks",
        (INVARIANTS, *given("T"), *filled("Q", "K")),
        "Q and K of the rows of nodal vectors from the rows T of stations, even and odd parts:\n"
        " * of a row and its mirror image the sum of what they share, then of what they differ by",
        (
            Let("last", LAST),
            loop("k", "M", loop("l", "k + 1", loop("i", "first_of[k + 1]",
                 Let("end", "k == l ? i + 1 : first_of[l + 1]"),
                 loop("j", "end", *_pair_of_rows(), first="first_of[l]"), first="first_of[k]"))),
            If("OPPOSED", (Do("opposed_blocks(K);"),)),
        ))


LAST = "MIRRORED ? (inv->stations - 1) / 2 : inv->stations - 1"


def _tangent_part():
    return Function(
        "tangent_part",
        (INVARIANTS, *given("q0", "u"), *filled("f", "K", "scratch")),
        "f = dU/dq and K = df/dq, eq. 28, for one part of a batch",
        (
            Do("hobe_real x0[3 * V], x[3 * V], *Q = scratch, *X = Q + BLOCKS;", free=True),
            Do("hobe_real *T = X + 9 * GRAMS - 3 * S;", free=True),
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            loop("g", "inv->stations", Do("station_rows(inv, g, x0, x, X, T + 10 * GRAMS * g);")),
            Let("couples", "MIRRORED ? inv->stations / 2 : 0"),
            loop("g", "couples",
                 Let("other", "inv->stations - 1 - g"),
                 Do("even_and_odd(T + 10 * GRAMS * g, T + 10 * GRAMS * other);")),
            Do("nodal_blocks(inv, T, Q, K);"),
            Note("D = D0 + U"),
            loop("i", "3 * V", Do("x[i] += x0[i];")),
            Do("tensor_force(Q, x, f);"),
        ))


# ---- the coefficients ----------------------------------------------------------------------------

COEFFICIENTS = """\
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
"""
