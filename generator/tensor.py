# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4, the plan "tensor": eqs. 27 and 28 as products with constant matrices.

Where an element is straight and prismatic its energy is a quadratic form in the Gram differences
gamma_tv of its nodal vectors, and with the fourth-order tensor A of that form

    dU/dq_i       = sum_j Q_ij q_j,    Q_ij = sum_(t<=v) A_(ij)(tv) gamma_tv,
    d2U/dq_i dq_j = Q_ij 1 + sum_tv A_(it)(jv) q_t q_v^T.

The last sum is split into its symmetric and its skew part,

    S_ij: A_(it)(jv) + A_(iv)(jt) times the 6 products of q_t with q_v,
    R_ij: A_(it)(jv) - A_(iv)(jt) times the 3 components of q_t x q_v,

so that force and tangent are three products of a constant matrix, rows (i, j), with columns of
numbers for each pair (t, v), t <= v.  A holds every integral over the volume: the H-tensors of
Tang, Tian & Hu 2022, shared by all equal elements.

The tensor is sparse by parity.  Each axial function has a mirror image about mid-length, so that
sums and differences of nodal vectors, the *columns* y_t, are even or odd in x; and a mode is even
or odd in y, and in z.  An integral that is odd in x vanishes, and so does one that is odd in y or z
where the section is symmetric.  Pairs (t, v) fall into 8 classes by their parities; a row meets the
columns of its own class alone, or of the classes that the section does not keep apart.

Rows stay those of nodal vectors: the block K_ij and its mirror image are the sum and the difference
of an x-even and an x-odd part, each a row of one class.  Positions of the centreline enter as
differences, so that one column less than there are vectors is enough; and of two positions the
first needs no rows, since what it gains the last loses.
"""

from dataclasses import dataclass
from fractions import Fraction

from .form import axis3, filled, given
from .ir import Do, Function, If, Let, Note, loop
from .products import CLASSES, Products, by_class, pair


@dataclass(frozen=True)
class Column:
    """y = q_left + sign q_right, less the last position where shifted; its axial function is
    share (N_left + sign N_right)."""

    left: int
    right: int
    sign: int
    shifted: bool
    share: Fraction
    parity: int


@dataclass(frozen=True)
class Layout:
    """Rows and columns of the nodal vectors.  Rows are numbered as blocks of the tangent,
    hobe_pair(i, j)."""

    last: int           # the last position
    opposed: bool       # two positions: rows with the first, vector 0, are less those with the last
    mirrored: bool      # whether axial functions have mirror images
    sign: tuple         # of each vector of a row: that of its image
    columns: tuple      # Column
    products: Products  # of the columns, for the rows

    @property
    def sizes(self):
        """Names and values of the constants that the loops run over."""
        return {
            "COLUMNS": len(self.columns),
            "PAIRS": len(self.products.pairs),
            "BLOCKS": pair(len(self.sign), 0),
            "CLASSES": CLASSES,
            "LAST": self.last,
            "OPPOSED": int(self.opposed),
            "MIRRORED": int(self.mirrored),
        }

    @property
    def tables(self):
        """Integer tables of the loops by name."""
        return {
            "odd_of": [int(s < 0) for s in self.sign],
            "left": [c.left for c in self.columns], "right": [c.right for c in self.columns],
            "shifted": [int(c.shifted) for c in self.columns],
        }


def layout(element):
    """The Layout of an Element of the form "continuum"."""
    vectors = element.declaration.vectors
    parity = [2 * y + 4 * z for y, z in (element.modes[v.mode].parity for v in vectors)]
    positions = [i for i, v in enumerate(vectors) if v.is_position]
    mirror, sign = _mirror(element)
    columns = _columns(mirror, sign, parity, positions)
    pairs = [(t, v) for t in range(len(columns)) for v in range(t + 1)]
    kind = {p: columns[p[0]].parity ^ columns[p[1]].parity for p in pairs}
    pairs, first_pair = by_class(pairs, kind, lambda p: p[0] != p[1])
    mirrored = mirror != tuple(range(len(mirror)))
    opposed = len(positions) == 2 and mirror[0] == positions[1]
    if opposed:  # the last position from the first: odd about mid-length, like its function
        end = positions[1]
        mirror, sign = _put(mirror, end, end), _put(sign, end, -1)
    rows, kinds, skew_kinds = _rows(mirror, sign, parity, first=int(opposed))
    products = Products("nodal", len(columns), mirror, pairs, first_pair, *by_class(rows, kinds),
                        *by_class(skew_kinds, skew_kinds))
    return Layout(positions[-1], opposed, mirrored, sign, columns, products)


def _put(items, place, item):
    return items[:place] + (item,) + items[place + 1:]


def _mirror(element):
    """Of each vector the one whose axial function is its own about mid-length, and the sign; itself
    for all, where one has none."""
    vectors = element.declaration.vectors
    reversed_ = [_reversed(element.axial[a].polynomial) for a in element.axial_of]
    found = []
    for v, vector in enumerate(vectors):
        found += [(w, sign) for w, other in enumerate(vectors) for sign in (1, -1)
                  if (other.mode, other.slope) == (vector.mode, vector.slope)
                  and element.axial[element.axial_of[w]].polynomial
                  == tuple(sign * c for c in reversed_[v])]
    if len(found) < len(vectors) or any(s < 0 for v, (_, s) in zip(vectors, found)
                                        if v.is_position):
        return tuple(range(len(vectors))), (1,) * len(vectors)
    return tuple(zip(*found))


def _reversed(polynomial):
    """p(1 - xi)."""
    power, total = [Fraction(1)], [Fraction(0)] * len(polynomial)
    for c in polynomial:
        for i, p in enumerate(power):
            total[i] += c * p
        power = [a - b for a, b in zip([*power, 0], [0, *power])]
    return tuple(total)


def _columns(mirror, sign, parity, positions):
    """Sums and differences of a vector and its image, sums of positions from that of the ends; the
    functions of positions add up to one, so that the sum of the ends itself has no part."""
    found = []
    symmetric = any(m != v for v, m in enumerate(mirror))
    for v, m in enumerate(mirror):
        if v == m and (symmetric or v != positions[0]):
            found.append(Column(v, v, 1, symmetric and v in positions, Fraction(1, 4),
                                parity[v] + (sign[v] < 0)))
        elif v < m:
            if v != positions[0]:
                found.append(Column(v, m, sign[v], v in positions, Fraction(1, 2), parity[v]))
            found.append(Column(v, m, -sign[v], False, Fraction(1, 2), parity[v] + 1))
    return tuple(found)


def _rows(mirror, sign, parity, first):
    """Rows of vectors from `first` on; classes of those of S and of R.  Of two
    images with the sign s, the first row holds the part that both have alike, x-even where s > 0;
    the second the other.  An image with its indices exchanged is a transpose, and that of R is
    -R."""
    rows, kinds, skew = [], {}, {}
    for i in range(first, len(mirror)):
        for j in range(first, i + 1):
            row, yz = pair(i, j), parity[i] ^ parity[j]
            a, b = mirror[i], mirror[j]
            other, s = pair(max(a, b), min(a, b)), sign[i] * sign[j]
            rows.append(row)
            odd = (s < 0) ^ (other < row)
            kinds[row] = yz + odd
            if i != j:
                skew[row] = yz + (odd ^ (a < b))
    return rows, kinds, skew


# ---- loop nests ----------------------------------------------------------------------------------

INVARIANTS = "const struct hobe_invariants *inv"


def functions():
    """The loop nests, the same for every element; those of the tail serve section.py, too."""
    return (_columns_of(), _state(), _force_part(), _tangent_part())


def tail():
    """From rows to force and tangent."""
    return _images(), _force(), _block(), _blocks(), _opposed(), _finish()


def _columns_of():
    return Function(
        "column_vectors", (*given("x"), *filled("y")),
        "y[COLUMNS][3], the sums and differences about mid-length of nodal vectors x[V][3]",
        (loop("t", "COLUMNS",
              axis3("y[3 * t + a] = x[3 * left[t] + a] + sign[t] * x[3 * right[t] + a];"),
              If("shifted[t]", (axis3("y[3 * t + a] -= x[3 * LAST + a];"),))),))


def _state():
    return Function(
        "tensor_state",
        (INVARIANTS, *given("q0", "u"), *filled("x", "y", "gamma", "Q")),
        "The current x[V][3] = q0 + u, its columns y, gamma, and Q[row]; returns the rest of H",
        (Do("hobe_real x0[3 * V], B[3 * COLUMNS];", free=True),
         Do("gather(q0, x0);"),
         Do("gather(u, x);"),
         Note("gamma from the mean of before and after, and the change: no cancellation"),
         loop("i", "3 * V", Do("x0[i] += 0.5 * x[i];")),
         Do("column_vectors(x0, B);"),
         Do("column_vectors(x, y);"),
         Do("column_differences(nodal, B, y, gamma);"),
         loop("i", "3 * V", Do("x[i] = x0[i] + 0.5 * x[i];")),
         loop("i", "3 * COLUMNS", Do("y[i] = B[i] + 0.5 * y[i];")),
         Do("const double *H;", free=True),
         Do("H = row_stress(nodal, inv->tensor, inv->symmetry, gamma, Q);"),
         Do("images(Q);"),
         Do("return H;", free=True)), result="const double *")


# The number of a row of vectors v >= u, and of its mirror image.
ROW = Let("m", "hobe_pair(v, u)"), Let("n", "symmetric(nodal->mirror[v], nodal->mirror[u])")


def _rows_and_images(alone, both):
    """Statements for rows that are their own mirror image, and for pairs of rows."""
    return loop("v", "V", loop("u", "v + 1", *ROW, *((If("m == n", alone),) if alone else ()),
                               If("m < n", both), first="OPPOSED"), first="OPPOSED")


def _images():
    return Function(
        "images", filled("Q"), "Q of the rows from the parts that mirror images share",
        (_rows_and_images((), (
            Do("const hobe_real sum = Q[m] + Q[n], difference = Q[m] - Q[n];"),
            Do("Q[m] = sum;", free=True), Do("Q[n] = difference;", free=True))),))


def _force():
    return Function(
        "tensor_force", (*given("Q", "x"), *filled("f")),
        "f_i = sum_j Q_ij x_j, where x_0 = 0; on positions they are in balance",
        (axis3("f[a * HOBE_PARTS] = zero;"),
         loop("i", "V",
              Do("hobe_real sum[3] = {zero, zero, zero};", free=True),
              loop("j", "i", axis3("sum[a] += Q[hobe_pair(i, j)] * x[3 * j + a];"), first="1"),
              loop("j", "V", axis3("sum[a] += Q[hobe_pair(j, i)] * x[3 * j + a];"), first="i"),
              axis3("f[(3 * i + a) * HOBE_PARTS] = sum[a];"),
              If("position[i]", (axis3("f[a * HOBE_PARTS] -= sum[a];"),)), first="1")))


def _opposed():
    def copy(row, entry):
        return (Do(f"const hobe_real *k = K + 9 * HOBE_PARTS * {row};", free=True),
                loop("a", "3", loop("b", "3", Do(
                    f"to[(3 * a + b) * HOBE_PARTS] = zero - k[({entry}) * HOBE_PARTS];"))))

    return Function(
        "opposed_blocks", filled("K"),
        "K_i0 = -K_in of two positions 0 and n = LAST",
        (loop("i", "V",
              Do("hobe_real *to = K + 9 * HOBE_PARTS * hobe_pair(i, 0);", free=True),
              If("i < LAST", copy("hobe_pair(LAST, i)", "3 * b + a")),
              If("i >= LAST", copy("hobe_pair(i, LAST)", "3 * a + b")), first="1"),
         loop("e", "9", Do("K[e * HOBE_PARTS] = K[(9 * hobe_pair(LAST, LAST) + e) * HOBE_PARTS];",
                           free=True))))


def _force_part():
    return Function(
        "tensor_force_part",
        (INVARIANTS, *given("q0", "u"), *filled("f", "scratch")),
        "f = dU/dq, eq. 27, for one part of a batch",
        (Do("hobe_real x[3 * V], y[3 * COLUMNS], *gamma = scratch, *Q = gamma + PAIRS;", free=True),
         Do("tensor_state(inv, q0, u, x, y, gamma, Q);"),
         Do("tensor_force(Q, x, f);")))


def _block():
    off = ((1, 5, "+", 2), (3, 5, "-", 2), (6, 4, "+", 1), (2, 4, "-", 1), (5, 3, "+", 0),
           (7, 3, "-", 0))
    return Function(
        "block", (*given("s", "r", "Q"), *filled("k")),
        "k[3][3] = sym + skew + Q 1 of a row",
        (*(Do(f"k[{4 * a} * HOBE_PARTS] = s[{a}] + Q[0];") for a in range(3)),
         *(Do(f"k[{e} * HOBE_PARTS] = 0.5 * s[{a}] {sign} r[{c}];") for e, a, sign, c in off)),
        result="inline void")


def _blocks():
    def store(row, s="s", r="r"):
        return Do(f"block({s}, {r}, Q + {row}, K + 9 * HOBE_PARTS * {row});")

    return Function(
        "blocks", (*given("Q", "sym", "skew"), *filled("K")),
        "K_ij = sym_ij + skew_ij + Q_ij 1 from the rows, "
        "those of images from their sum and difference",
        (_rows_and_images((store("m", "sym + 6 * m", "skew + 3 * m"),), (
            Do("hobe_real s[6], r[3];", free=True),
            loop("e", "6", Do("s[e] = sym[6 * m + e] + sym[6 * n + e];")),
            loop("e", "3", Do("r[e] = skew[3 * m + e] + skew[3 * n + e];")),
            store("m"),
            loop("e", "6", Do("s[e] = sym[6 * m + e] - sym[6 * n + e];")),
            loop("e", "3", Do("r[e] = skew[3 * m + e] - skew[3 * n + e];")),
            store("n"))),))


def _tangent_part():
    return Function(
        "tensor_tangent_part",
        (INVARIANTS, *given("q0", "u"), *filled("f", "K", "scratch")),
        "f as in tensor_force_part and K = df/dq, eq. 28",
        (Do("hobe_real x[3 * V], y[3 * COLUMNS];", free=True),
         Do("hobe_real *X = scratch, *Z = X + 6 * PAIRS, *Q = Z + 3 * (PAIRS - COLUMNS);",
            free=True),
         Do("hobe_real *sym = Q + BLOCKS, *skew = sym + 6 * BLOCKS;", free=True),
         Do("const double *H;", free=True),
         Do("H = tensor_state(inv, q0, u, x, y, X, Q);"),
         Do("tensor_force(Q, x, f);"),
         Do("products(nodal, y, X, Z);"),
         Do("H = row_symmetric(nodal, H, inv->symmetry, X, sym);"),
         Do("row_skew(nodal, H, inv->symmetry, Z, skew);"),
         Do("finish(Q, sym, skew, K);")))


def _finish():
    return Function(
        "finish", (*given("Q", "sym"), *filled("skew", "K")), "K from the rows",
        (loop("i", "V", axis3("skew[3 * hobe_pair(i, i) + a] = zero;"), first="OPPOSED"),
         Do("blocks(Q, sym, skew, K);"),
         If("OPPOSED", (Do("opposed_blocks(K);"),))))


# ---- the coefficients ----------------------------------------------------------------------------


# ---- the coefficients ----------------------------------------------------------------------------

COEFFICIENTS = """\
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
"""
