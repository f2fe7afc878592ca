# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4, what both plans are made of: products of a constant matrix with products of vectors.

An energy that is a quadratic form in the Gram differences gamma_tv of vectors y_t has, with the
fourth-order tensor A of that form,

    dU/dy_i       = sum_j Q_ij y_j,    Q_ij = sum_(t<=v) A_(ij)(tv) gamma_tv,
    d2U/dy_i dy_j = Q_ij 1 + sum_tv A_(it)(jv) y_t y_v^T.

The last sum is split into its symmetric and its skew part,

    S_ij: A_(it)(jv) + A_(iv)(jt) times the 6 products of y_t with y_v,
    R_ij: A_(it)(jv) - A_(iv)(jt) times the 3 components of y_t x y_v,

so that force and tangent are three products of a constant matrix, rows (i, j), with *columns* of
numbers for each pair (t, v), t <= v.

The matrices are sparse by parity.  A vector is even or odd in x, in y and in z, and an integral of
four is zero where the four are odd together in a direction in which the element is its own mirror
image.  Pairs fall into 8 classes by their parities; a row meets the columns of its own class alone,
or of the classes that the element does not keep apart.
"""

from dataclasses import dataclass

from .form import filled, given
from .ir import Do, Function, If, Let, loop

CLASSES = 8            # of pairs: 1 odd in x, 2 odd in y, 4 odd in z
SYMMETRIES = range(8)  # the same bits: parities that an element keeps apart
ALONG = 1              # that of x
MERGED = tuple(tuple(k for k in range(CLASSES) if not k & s) for s in SYMMETRIES)
# Rows at a time, as many as are left of a class, for sums of 1, 6 and 3 columns: 24 sums want the
# 32 registers that a TALL machine has.
HEIGHTS = 4, 2, 1
WIDTHS = 1, 6, 3


def pair(i, j):
    """hobe_pair of kernel.h."""
    return i * (i + 1) // 2 + j


def by_class(items, kind, key=lambda _: 0):
    """The items in the order of their classes, then of key, and where each class begins."""
    order = tuple(sorted(items, key=lambda item: (kind[item], key(item))))
    return order, tuple(sum(kind[i] < c for i in order) for c in range(CLASSES + 1))


@dataclass(frozen=True)
class Products:
    """Orders of rows and columns."""

    name: str          # of the struct products in C
    columns: int       # vectors
    mirror: tuple      # of each vector of a row, its mirror image
    pairs: tuple       # (t, v), t >= v: those with t = v, then by class
    first_pair: tuple  # of each class, [CLASSES + 1]; pairs with t = v are of class 0
    rows: tuple        # rows of Q and S by class
    first_row: tuple
    skew_rows: tuple   # rows of R by class
    first_skew_row: tuple

    @property
    def tables(self):
        """The tables of a struct products, in its order; equal ones under the first's name."""
        return {
            "mirror": self.mirror,
            "pair_t": [t for t, _ in self.pairs], "pair_v": [v for _, v in self.pairs],
            "first_pair": self.first_pair,
            "first_cross": [max(n, self.columns) for n in self.first_pair],
            "row": self.rows, "first_row": self.first_row,
            "skew_row": self.skew_rows, "first_skew_row": self.first_skew_row,
        }

    @property
    def names(self):
        """What the loops say of `of`, for a Counter."""
        sizes = {"columns": self.columns, "pairs": len(self.pairs)}
        return {"of_" + name: value for name, value in (sizes | self.tables).items()}

    def numbers(self, symmetry):
        """How many coefficients the matrices have that a symmetry leaves."""
        tables = self.tables

        def count(row, columns):
            rows, pairs = tables[row], tables[columns]
            return sum((rows[c + 1] - rows[c]) * (pairs[k + 1] - pairs[k])
                       for c in range(CLASSES) for k in (c ^ m for m in MERGED[symmetry]))

        return 2 * count("first_row", "first_pair") + count("first_skew_row", "first_cross")


OF_VECTORS = "mirror", "pair_t", "pair_v"  # tables of numbers of vectors

TABLES = {
    "merged": [len(m) for m in MERGED],
    "merged_with": [k for m in MERGED for k in (*m, *(0,) * CLASSES)[:CLASSES]],
}


# ---- loop nests ----------------------------------------------------------------------------------

OF = "const struct products *of"


def functions():
    """The loop nests, the same for all products of all elements."""
    return (_differences(), _products(),
            _sum("row_stress", "Q", "row", 0), _sum("row_symmetric", "sym", "row", 1),
            _sum("row_skew", "skew", "skew_row", 2))


def is_tall(kind, height):
    return WIDTHS[kind] * height > 12


def _differences():
    return Function(
        "column_differences", (OF, *given("B", "C"), *filled("gamma")),
        "gamma_tv = B_t.C_v + C_t.B_v, gamma_tt = B_t.C_t: with B = y0 + u/2, C = u the Gram\n"
        " * differences y_t.y_v - y0_t.y0_v without cancellation, half of them where t = v",
        (loop("p", "of->columns",
              Do("const int t = 3 * of->pair_t[p];", free=True),
              Do("gamma[p] = dot(B + t, C + t);")),
         loop("p", "of->pairs",
              Do("const int t = 3 * of->pair_t[p], v = 3 * of->pair_v[p];", free=True),
              Do("gamma[p] = dot(B + t, C + v) + dot(C + t, B + v);"),
              first="of->columns")))


def _products():
    def term(a, b, sign):
        return f"t{a} * v{b} {sign} t{b} * v{a}"

    mixed = (1, 2), (2, 0), (0, 1)
    factors = ", ".join(f"{x}{a} = {x}[{a}]" for x in "tv" for a in range(3))
    return Function(
        "products", (OF, *given("y"), *filled("X", "Z")),
        "X[pairs][6]: xx, yy, zz, 2yz, 2xz, 2xy of y_t with y_v; Z[pairs - columns][3] = y_t x y_v",
        (loop("p", "of->pairs",
              Do("const hobe_real *t = y + 3 * of->pair_t[p], *v = y + 3 * of->pair_v[p];",
                 free=True),
              Do(f"const hobe_real {factors};", free=True),
              Do("hobe_real *to = X + 6 * p;", free=True),
              *(Do(f"to[{a}] = t{a} * v{a};") for a in range(3)),
              *(Do(f"to[{3 + a}] = {term(*both, '+')};") for a, both in enumerate(mixed)),
              If("p >= of->columns", (
                  Do("hobe_real *cross = Z + 3 * (p - of->columns);", free=True),
                  *(Do(f"cross[{a}] = {term(*both, '-')};") for a, both in enumerate(mixed))))),))


def _sum(name, target, row, kind):
    """target_r = sum_p coefficient_rp X_p over the columns that meet the row's class: as many rows
    at a time as registers hold sums, and are left."""
    width = WIDTHS[kind]
    times = f"{width} * " if width > 1 else ""
    skew = row == "skew_row"  # without the diagonal columns, t = v
    first, row = f"of->first_{row}", f"of->{row}"
    columns = "of->first_cross" if skew else "of->first_pair"
    at = "(p - of->columns)" if skew else "p"

    def rows(height):
        sums = [[f"s{h}{e}" for e in range(width)] for h in range(height)]
        return (
            *(Do("hobe_real " + ", ".join(f"{s} = zero" for s in line) + ";", free=True)
              for line in sums),
            loop("m", "merged[symmetry]",
                 Let("k", "c ^ merged_with[CLASSES * symmetry + m]"),
                 loop("p", f"{columns}[k + 1]",
                      Do(f"const hobe_real *x = X + {times}{at};", free=True),
                      *(Do(f"{sums[h][e]} += H[{h}] * x[{e}];")
                        for h in range(height) for e in range(width)),
                      Do(f"H += {height};", free=True),
                      first=f"{columns}[k]")),
            *(node for h in range(height) for node in (
                Do(f"to = {target} + {times}{row}[r + {h}];", free=True),
                *(Do(f"to[{e}] = {sums[h][e]};", free=True) for e in range(width)))))

    def blocks(n, start):
        """Those of the n-th height and those below, from row `start` on."""
        if n == len(HEIGHTS):
            return ()
        height, rest = HEIGHTS[n], f"r{n + 1}"
        count = f"(end - {start}) / {height}" if height > 1 else f"end - {start}"
        tall = "TALL * (" + count + ")" if is_tall(kind, height) else count
        return (Let(f"n{height}", tall),
                loop("b", f"n{height}", Let("r", f"{start} + {height} * b"), *rows(height)),
                *((Let(rest, f"{start} + {height} * n{height}"),) if height > 1 else ()),
                *blocks(n + 1, rest))

    return Function(
        name, (OF, "const double *H", "int symmetry", *given("X"), *filled(target)),
        f"{target}[row][{width}] = the rows' sums of coefficients H times columns\n"
        f" * X[pairs{' - columns' if skew else ''}][{width}]; returns the end of H",
        (Do("hobe_real *to;", free=True),
         loop("c", "CLASSES",
              Let("end", f"{first}[c + 1]"), Let("r0", f"{first}[c]"), *blocks(0, "r0")),
         Do("return H;", free=True)), result="const double *")


# ---- the coefficients ----------------------------------------------------------------------------

STRUCTURE = """\
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
"""

SYMMETRY = """\
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
"""

COEFFICIENTS = """\
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
    static const int height[3][3] = {HEIGHTS};
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
""".replace("HEIGHTS", ", ".join(
    "{" + ", ".join(f"TALL ? {h} : {HEIGHTS[n + 1]}" if is_tall(kind, h) else str(h)
                    for n, h in enumerate(HEIGHTS)) + "}" for kind in range(3)))
