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

SYMMETRIES = range(4)  # of a section: 1 in y, 2 in z, both, none
CLASSES = 8            # of pairs: 1 odd in x, 2 odd in y, 4 odd in z
MERGED = (0, 2, 4, 6), (0, 4), (0, 2), (0,)  # by symmetry: classes that are not kept from class 0
HEIGHTS = 4, 2, 4      # rows at a time: their sums of 1, 6 and 3 columns fit 16 registers


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
    """Orders of rows and columns.  Rows are numbered as blocks of the tangent, hobe_pair(i, j)."""

    last: int           # the last position
    opposed: bool       # two positions: rows with the first, vector 0, are less those with the last
    mirror: tuple       # of each vector of a row, its mirror image
    columns: tuple      # Column
    pairs: tuple        # (t, v), t >= v: those with t = v, then by class
    first_pair: tuple   # of each class, [CLASSES + 1]; pairs with t = v are of class 0
    rows: tuple         # rows of Q and S by class
    first_row: tuple
    skew_rows: tuple    # rows of R by class
    first_skew_row: tuple
    images: tuple       # (row, row of its mirror image): the parts of both
    alone: tuple        # rows that are their own image

    @property
    def sizes(self):
        """Names and values of the constants that the loops run over."""
        return {
            "COLUMNS": len(self.columns),
            "PAIRS": len(self.pairs),
            "BLOCKS": _pair(len(self.mirror), 0),
            "IMAGES": len(self.images),
            "ALONE": len(self.alone),
            "CLASSES": CLASSES,
            "LAST": self.last,
            "OPPOSED": int(self.opposed),
        }

    @property
    def tables(self):
        """Integer tables of the loops by name."""
        return {
            "mirror_of": self.mirror,
            "left": [c.left for c in self.columns], "right": [c.right for c in self.columns],
            "shifted": [int(c.shifted) for c in self.columns],
            "pair_t": [t for t, _ in self.pairs], "pair_v": [v for _, v in self.pairs],
            "first_pair": self.first_pair,
            "first_cross": [max(n, len(self.columns)) for n in self.first_pair],
            "row": self.rows, "first_row": self.first_row,
            "skew_row": self.skew_rows, "first_skew_row": self.first_skew_row,
            "merged": [len(m) for m in MERGED],
            "merged_with": [k for m in MERGED for k in (*m, 0, 0, 0)[:4]],
            "image": [r for pair in self.images for r in pair], "alone": self.alone,
        }

    def numbers(self, symmetry):
        """How many coefficients a tensor has that the section's symmetry leaves."""
        tables = self.tables

        def count(row, pair):
            rows, pairs = tables[row], tables[pair]
            return sum((rows[c + 1] - rows[c]) * (pairs[k + 1] - pairs[k])
                       for c in range(CLASSES) for k in (c ^ m for m in MERGED[symmetry]))

        return 2 * count("first_row", "first_pair") + count("first_skew_row", "first_cross")


def layout(element):
    """The Layout of an Element of the form "continuum"."""
    vectors = element.declaration.vectors
    parity = [2 * y + 4 * z for y, z in (element.modes[v.mode].parity for v in vectors)]
    positions = [i for i, v in enumerate(vectors) if v.is_position]
    mirror, sign = _mirror(element)
    columns = _columns(mirror, sign, parity, positions)
    pairs = [(t, v) for t in range(len(columns)) for v in range(t + 1)]
    kind = {p: columns[p[0]].parity ^ columns[p[1]].parity for p in pairs}
    pairs, first_pair = _by_class(pairs, kind, lambda p: p[0] != p[1])
    opposed = len(positions) == 2 and mirror[0] == positions[1]
    if opposed:  # the last position from the first: odd about mid-length, like its function
        end = positions[1]
        mirror, sign = _put(mirror, end, end), _put(sign, end, -1)
    rows, kinds, skew_kinds, images, alone = _rows(mirror, sign, parity, first=int(opposed))
    order, first_row = _by_class(rows, kinds)
    skew, first_skew = _by_class(skew_kinds, skew_kinds)
    return Layout(positions[-1], opposed, mirror, columns, pairs, first_pair, order, first_row,
                  skew, first_skew, images, alone)


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


def _by_class(items, kind, key=lambda _: 0):
    """The items in the order of their classes, then of key, and where each class begins."""
    order = tuple(sorted(items, key=lambda item: (kind[item], key(item))))
    return order, tuple(sum(kind[i] < c for i in order) for c in range(CLASSES + 1))


def _rows(mirror, sign, parity, first):
    """Rows of vectors from `first` on; classes of those of S and of R; images; rows alone.  Of two
    images with the sign s, the first row holds the part that both have alike, x-even where s > 0;
    the second the other.  An image with its indices exchanged is a transpose, and that of R is
    -R."""
    rows, kinds, skew, images, alone = [], {}, {}, [], []
    for i in range(first, len(mirror)):
        for j in range(first, i + 1):
            row, yz = _pair(i, j), parity[i] ^ parity[j]
            a, b = mirror[i], mirror[j]
            other, s = _pair(max(a, b), min(a, b)), sign[i] * sign[j]
            rows.append(row)
            odd = (s < 0) ^ (other < row)
            kinds[row] = yz + odd
            if i != j:
                skew[row] = yz + (odd ^ (a < b))
            if row < other:
                images.append((row, other))
            elif row == other:
                alone.append(row)
    return rows, kinds, skew, tuple(images), tuple(alone)


def _pair(i, j):
    return i * (i + 1) // 2 + j


# ---- loop nests ----------------------------------------------------------------------------------

INVARIANTS = "const struct hobe_invariants *inv"


def functions():
    """The loop nests, the same for every element."""
    sums = (_sum("row_stress", "Q", "row", HEIGHTS[0], 1),
            _sum("row_symmetric", "sym", "row", HEIGHTS[1], 6),
            _sum("row_skew", "skew", "skew_row", HEIGHTS[2], 3))
    return (_columns_of(), _differences(), _products(), *sums, _state(), _force(), _block(),
            _blocks(), _opposed(), _force_part(), _tangent_part())


def _columns_of():
    return Function(
        "column_vectors", (*given("x"), *filled("y")),
        "y[COLUMNS][3], the sums and differences about mid-length of nodal vectors x[V][3]",
        (loop("t", "COLUMNS",
              axis3("y[3 * t + a] = x[3 * left[t] + a] + sign[t] * x[3 * right[t] + a];"),
              If("shifted[t]", (axis3("y[3 * t + a] -= x[3 * LAST + a];"),))),))


def _differences():
    return Function(
        "column_differences", (*given("B", "C"), *filled("gamma")),
        "gamma_tv = B_t.C_v + C_t.B_v, gamma_tt = B_t.C_t: Gram differences as in `differences`",
        (loop("p", "COLUMNS", Do("gamma[p] = dot(B + 3 * pair_t[p], C + 3 * pair_t[p]);")),
         loop("p", "PAIRS", Do("const hobe_real *Bt = B + 3 * pair_t[p], *Ct = C + 3 * pair_t[p];",
                               free=True),
              Do("gamma[p] = dot(Bt, C + 3 * pair_v[p]) + dot(Ct, B + 3 * pair_v[p]);"),
              first="COLUMNS")))


def _products():
    def term(a, b, sign):
        return f"t{a} * v{b} {sign} t{b} * v{a}"

    mixed = (1, 2), (2, 0), (0, 1)
    factors = ", ".join(f"{x}{a} = {x}[{a}]" for x in "tv" for a in range(3))
    return Function(
        "products", (*given("y"), *filled("X", "Z")),
        "X[PAIRS][6]: xx, yy, zz, 2yz, 2xz, 2xy of y_t with y_v; Z[PAIRS - COLUMNS][3] = y_t x y_v",
        (loop("p", "PAIRS",
              Do("const hobe_real *t = y + 3 * pair_t[p], *v = y + 3 * pair_v[p];", free=True),
              Do(f"const hobe_real {factors};", free=True),
              Do("hobe_real *to = X + 6 * p;", free=True),
              *(Do(f"to[{a}] = t{a} * v{a};") for a in range(3)),
              *(Do(f"to[{3 + a}] = {term(*pair, '+')};") for a, pair in enumerate(mixed)),
              If("p >= COLUMNS", (
                  Do("hobe_real *cross = Z + 3 * (p - COLUMNS);", free=True),
                  *(Do(f"cross[{a}] = {term(*pair, '-')};") for a, pair in enumerate(mixed))))),))


def _sum(name, target, row, height, width):
    """target_r = sum_p coefficient_rp X_p over the columns that meet the row's class: `height` rows
    at a time, whose sums stay in registers, then the rest one by one."""
    first = f"first_{row}"
    skew = row == "skew_row"  # without the diagonal columns, t = v
    pair = "first_cross" if skew else "first_pair"

    def rows(height):
        sums = [[f"s{h}{e}" for e in range(width)] for h in range(height)]
        return (
            *(Do("hobe_real " + ", ".join(f"{s} = zero" for s in line) + ";", free=True)
              for line in sums),
            loop("m", "merged[symmetry]",
                 Let("k", "c ^ merged_with[4 * symmetry + m]"),
                 loop("p", f"{pair}[k + 1]",
                      Do(f"const hobe_real *x = X + {width} * {'(p - COLUMNS)' if skew else 'p'};",
                         free=True),
                      *(Do(f"{sums[h][e]} += H[{h}] * x[{e}];")
                        for h in range(height) for e in range(width)),
                      Do(f"H += {height};", free=True),
                      first=f"{pair}[k]")),
            *(Do(f"{target}[{width} * {row}[r + {h}] + {e}] = {sums[h][e]};", free=True)
              for h in range(height) for e in range(width)))

    return Function(
        name, ("const double *H", "int symmetry", *given("X"), *filled(target)),
        f"{target}[row][{width}] = the rows' sums of coefficients H times columns\n"
        f" * X[PAIRS{' - COLUMNS' if skew else ''}][{width}]; returns the end of H",
        (loop("c", "CLASSES",
              Let("count", f"{first}[c + 1] - {first}[c]"),
              loop("b", f"count / {height}", Let("r", f"{first}[c] + {height} * b"), *rows(height)),
              loop("r", f"{first}[c + 1]", *rows(1),
                   first=f"{first}[c] + count / {height} * {height}")),
         Do("return H;", free=True)), result="const double *")


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
         Do("column_differences(B, y, gamma);"),
         loop("i", "3 * V", Do("x[i] = x0[i] + 0.5 * x[i];")),
         loop("i", "3 * COLUMNS", Do("y[i] = B[i] + 0.5 * y[i];")),
         Do("const double *H;", free=True),
         Do("H = row_stress(inv->tensor, inv->symmetry, gamma, Q);"),
         loop("o", "IMAGES",
              Do("hobe_real *a = Q + image[2 * o], *b = Q + image[2 * o + 1];", free=True),
              Do("const hobe_real sum = a[0] + b[0], difference = a[0] - b[0];"),
              Do("a[0] = sum;", free=True), Do("b[0] = difference;", free=True)),
         Do("return H;", free=True)), result="const double *")


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
        (loop("o", "IMAGES",
              Let("m", "image[2 * o]"), Let("n", "image[2 * o + 1]"),
              Do("hobe_real s[6], r[3];", free=True),
              loop("e", "6", Do("s[e] = sym[6 * m + e] + sym[6 * n + e];")),
              loop("e", "3", Do("r[e] = skew[3 * m + e] + skew[3 * n + e];")),
              store("m"),
              loop("e", "6", Do("s[e] = sym[6 * m + e] - sym[6 * n + e];")),
              loop("e", "3", Do("r[e] = skew[3 * m + e] - skew[3 * n + e];")),
              store("n")),
         loop("o", "ALONE", Let("m", "alone[o]"), store("m", "sym + 6 * m", "skew + 3 * m"))))


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
         Do("products(y, X, Z);"),
         Do("H = row_symmetric(H, inv->symmetry, X, sym);"),
         Do("row_skew(H, inv->symmetry, Z, skew);"),
         loop("i", "V", axis3("skew[3 * hobe_pair(i, i) + a] = zero;"), first="OPPOSED"),
         Do("blocks(Q, sym, skew, K);"),
         If("OPPOSED", (Do("opposed_blocks(K);"),))))


# ---- the coefficients ----------------------------------------------------------------------------

COEFFICIENTS = """\
/* Which parities the section keeps apart (kernel.h): of the entries of Q that are odd in y, or in
 * z, none may be more than rounding. */
static int symmetry(const struct hobe_invariants *inv)
{
    const double rounding = 1e-13;
    double size[NN + NS];
    int odd[NN + NS], kept = 3;
    for (int i = 0; i < S; i++)
        for (int k = 0; k <= i; k++) {
            const int r = gram_entry(k, i), s = r - NN;
            const int ii = gram_entry(i, i), kk = gram_entry(k, k);
            odd[r] = parity[i] ^ parity[k];
            size[r] = __builtin_fabs(s < 0 ? inv->Qn[r * NN + r] : inv->Qs[s * NS + s]);
            if (s < 0) /* its own may vanish: of warping functions the law may know means alone */
                size[r] += __builtin_sqrt(
                    __builtin_fabs(inv->Qn[ii * NN + ii] * inv->Qn[kk * NN + kk]));
        }
    for (int block = 0; block < 2; block++) {
        const int n = block ? NS : NN, first = block * NN;
        const double *Q = block ? inv->Qs : inv->Qn;
        for (int r = 0; r < n; r++)
            for (int c = 0; c < r; c++) {
                const double q = Q[r * n + c] / rounding;
                if (q * q > size[first + r] * size[first + c])
                    kept &= ~(odd[first + r] ^ odd[first + c]);
            }
    }
    return kept;
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

/* The coefficients c[3] of Q, of the symmetric and of the skew part, of the pair of columns p in
 * the row of vectors i, j. */
static void coefficients(const struct hobe_invariants *inv, int i, int j, int p, double c[3])
{
    static const int order[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
    const int t = pair_t[p], v = pair_v[p];
    const int k[4] = {mode[i], mode[j], mode[left[t]], mode[left[v]]};
    double a[16];
    axial_integrals(inv, i, j, t, v, a);
    for (int n = 0; n < 3; n++)
        c[n] = tensor_entry(inv, a, k, order[n]);
    const double first = c[1], second = t == v ? 0.0 : c[2];
    c[1] = first + second;
    c[2] = 0.5 * (first - second);
}

/* The vectors i >= j of a row, or of its mirror image if that comes first: both are parts of that
 * one's. */
static void row_vectors(int r, int *i, int *j)
{
    for (int n = 0; n < 2; n++) {
        for (*i = 0; hobe_pair(*i + 1, 0) <= r; ++*i)
            ;
        *j = r - hobe_pair(*i, 0);
        const int other = symmetric(mirror_of[*i], mirror_of[*j]);
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
static int meets(const struct hobe_invariants *inv, int c, const short *first, int *pair)
{
    int count = 0;
    for (int m = 0; m < merged[inv->symmetry]; m++) {
        const int k = c ^ merged_with[4 * inv->symmetry + m];
        for (int p = first[k]; p < first[k + 1]; p++, count++)
            if (pair)
                pair[count] = p;
    }
    return count;
}

/* The coefficients of the rows of class c: of sums first <= s < last to H[s], which move on. */
static void row_coefficients(const struct hobe_invariants *inv, int c, int first, int last,
                             double *H[3])
{
    static const int height[3] = {HEIGHTS};
    const short *of = first == 2 ? skew_row : row, *start = first == 2 ? first_skew_row : first_row;
    const int rows = start[c + 1] - start[c];
    int pair[PAIRS];
    const int columns = meets(inv, c, first == 2 ? first_cross : first_pair, pair);
    for (int r = 0; r < rows; r++) {
        int i, j;
        row_vectors(of[start[c] + r], &i, &j);
        for (int p = 0; p < columns; p++) {
            double value[3];
            coefficients(inv, i, j, pair[p], value);
            for (int s = first; s < last; s++)
                H[s][place(rows, columns, height[s], r, p)] = value[s];
        }
    }
    for (int s = first; s < last; s++)
        H[s] += rows * columns;
}

static void tensor(const struct hobe_invariants *inv)
{
    int count = 0;
    for (int c = 0; c < CLASSES; c++)
        count += (first_row[c + 1] - first_row[c]) * meets(inv, c, first_pair, NULL);
    double *H[3] = {inv->tensor, inv->tensor + count, inv->tensor + 2 * count};
    for (int c = 0; c < CLASSES; c++) {
        row_coefficients(inv, c, 0, 2, H); /* of Q and of the symmetric part */
        row_coefficients(inv, c, 2, 3, H); /* of the skew part */
    }
}
""".replace("HEIGHTS", ", ".join(map(str, HEIGHTS)))
