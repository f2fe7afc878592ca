# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 5: C text.  One file per element, and the registry of all of them."""

from fractions import Fraction

from . import products, section, series, structural, tensor
from .ir import write
from .shape import derivative

ABI = 8  # HOBE_KERNEL_ABI of kernel.h


def identifier(name):
    """An element's name as C sees it."""
    return name.replace("-", "_")


def element_file(element, plan):
    """The C file of one element."""
    parts = [_head(element, plan), _tables(element), _shape(element), _modes(element)]
    parts += [REFERENCE, *_law(element), INVARIANTS, *_strain(element)]
    if plan.layout:
        parts += [products.STRUCTURE, _plan_tables(element, plan), products.SYMMETRY,
                  products.COEFFICIENTS, tensor.COEFFICIENTS, section.COEFFICIENTS]
    parts += [_function(f) for f in plan.functions]
    parts += [ENERGY, *([BATCH, TRILINEAR, GRAM, series.SERIES] if plan.layout else [STRUCTURAL_BATCH]),
              _descriptor(element, plan)]
    return "\n".join(parts)


REGISTRY = """\
/* The elements built in.  Written by `python -m generator`: do not edit. */
#include "kernel.h"

#include <stdlib.h>
#include <string.h>

{tables}
/* Whether the environment leaves this machine to choose. */
static int allowed(const char *machine)
{{
    const char *only = getenv("HOBE_MACHINE");
    return !only || !strcmp(only, machine);
}}

const struct hobe_kernel *const *hobe_kernels(void)
{{
{choices}
    return portable;
}}

const char *hobe_machine(void)
{{
{names}
    return "portable";
}}
"""

TABLE = """{externs}

static const struct hobe_kernel *const {machine}[] = {{
{items}
    NULL,
}};
"""

CHOICE = """    if (allowed("{machine}") && {runs})
        return {machine};
"""

NAME = """    if (hobe_kernels() == {machine})
        return "{machine}";
"""

MACHINES = {  # the best first: what a processor must have
    "avx512": ("avx512f", "fma"),
    "avx2": ("avx2", "fma"),
    "portable": (),
}


def registry_file(elements):
    """The tables of built-in kernels, one for each machine they are compiled for."""
    symbols = ["hobe_kernel_" + identifier(e.declaration.name) for e in elements]
    tables, choices, names = [], [], []
    for machine, features in MACHINES.items():
        suffix = f"_{machine}" if features else ""
        table = TABLE.format(
            machine=machine, items="\n".join(f"    &{s}{suffix}," for s in symbols),
            externs="\n".join(f"extern const struct hobe_kernel {s}{suffix};" for s in symbols))
        runs = " && ".join(f'__builtin_cpu_supports("{f}")' for f in features)
        condition = f"#ifdef HOBE_{machine.upper()}\n"
        tables.append(f"{condition}{table}#endif\n" if features else table)
        if features:
            choices.append(f"{condition}{CHOICE.format(machine=machine, runs=runs)}#endif")
            names.append(f"{condition}{NAME.format(machine=machine)}#endif")
    return REGISTRY.format(tables="\n".join(tables), choices="\n".join(choices),
                           names="\n".join(names))


def _head(element, plan):
    counts = plan.operations
    d, size = element.declaration, element.sizes
    slopes = {False: "", True: "'"}
    vectors = " ".join(f"{d.modes[v.mode]}{slopes[v.slope]}@{v.node + 1}" for v in d.vectors)
    text = [
        f"{d.name}: {d.source or 'no source given'}",
        "",
        f"Written by `python -m generator`, declaration {d.hash}: do not edit.",
        f"nodes at xi = {' '.join(map(str, d.nodes))}; {size['V']} vectors, {3 * size['V']} "
        "degrees of freedom",
        *_wrap("modes", " ".join(d.modes)),
        _points(element),
        *_wrap("vectors (mode@node, ' for d/dx):", vectors),
        f"operations per element: force {counts['force_part']}, force and tangent "
        f"{counts['tangent_part']}, energy {counts['energy_part']}",
        *(f"{what}, symmetric in {where}: {c[name + 'force_part']}, {c[name + 'tangent_part']}"
          for name, what in PLANS.items()
          for where, c in zip(SYMMETRIC_IN, plan.by_symmetry) if name + "force_part" in c),
    ]
    return "\n".join(["/* " + text[0], *(" * " + t if t else " *" for t in text[1:]), " */",
                      '#include "kernel.h"', "", f"#if HOBE_KERNEL_ABI != {ABI}",
                      "#error Regenerate: this file was written for another kernel ABI",
                      "#endif", ""])


SYMMETRIC_IN = "nothing", "x", "y", "x y", "z", "x z", "y z", "x y z"
PLANS = {"": "from station to station", "tensor_": "as one tensor"}


def _points(element):
    """What the points on the axis are."""
    n = element.stations
    if element.declaration.form == "continuum":
        return f"the energy is exact with {n} Gauss points on the axis"
    return (f"{n // 2} Gauss points on the axis for the rod's strains, {n - n // 2} Lobatto points "
            "for the section's")


def _wrap(head, words, width=92):
    lines = [head]
    for word in words.split():
        if len(lines[-1]) + 1 + len(word) > width:
            lines.append("   ")
        lines[-1] += " " + word
    return lines


def _number(q):
    """An exact rational as a C constant expression (a quotient rounds correctly)."""
    q = Fraction(q)
    return f"{q.numerator}.0" if q.denominator == 1 else f"{q.numerator}.0 / {q.denominator}.0"


def _table(declaration, values, width=96, gap=" "):
    start = " " * (4 - len(gap))
    lines, line = [], start
    for value in values:
        if len(line) + len(value) + len(gap) + 1 > width:
            lines.append(line)
            line = start
        line += f"{gap}{value},"
    return "\n".join([f"{declaration} = {{", *lines, line, "};"])


BLOCKS = {
    "continuum": {"NA": "Gram pairs d_k'.d_l'", "NN": "normal block: those and d_k.d_l",
                  "NS": "shear block: d_k'.d_l"},
    "structural": {"ROD": "stations of the rod's strains, before those of the section's",
                   "NN": "the rod's strains Gamma, kappa",
                   "NS": "the section's strains E_yy, E_zz, 2 E_yz"},
}


def _tables(element):
    d, size = element.declaration, element.sizes
    notes = {"V": "nodal vectors", "M": "section modes", "S": "section vectors d_k', d_k",
             "A": "distinct axial functions", **BLOCKS[d.form]}
    overlap = [_number(x) for row in element.overlap for x in row]
    return "\n".join([
        *_enum(size, notes), "",
        "static const hobe_real zero = {0};", "",
        "/* Of each nodal vector: mode; whether it is a position; axial function. */",
        _table("static const unsigned char mode[V]", [str(v.mode) for v in d.vectors]),
        _table("static const unsigned char position[V]",
               [str(int(v.is_position)) for v in d.vectors]),
        _table("static const unsigned char axial_of[V]", map(str, element.axial_of)),
        _table("static const unsigned char is_slope[A]",
               [str(int(a.slope)) for a in element.axial]),
        "", "/* int_0^1 A_i A_j dxi, exact */",
        _table("static const double overlap[A * A]", overlap), ""])


PLAN_SIZES = {
    "COLUMNS": "sums and differences of nodal vectors", "PAIRS": "of those",
    "BLOCKS": "of the tangent, pairs of nodal vectors: a row each",
    "CLASSES": "of parities: 1 odd in x, 2 odd in y, 4 odd in z", "LAST": "the last position",
    "OPPOSED": "whether it is one of two: rows with the first are less those with it",
    "MIRRORED": "whether there are mirror images",
    "GRAMS": "pairs of section vectors", "AXIAL": "weights of a station for axial functions",
    "MOST_PAIRS": "of either kind",
}
PLAN_TABLES = {
    "parity": ("unsigned char", "of each section vector: 1 odd in x, 2 odd in y, 4 odd in z"),
    "odd_of": ("unsigned char", "of each nodal vector: whether its image has the other sign"),
    "left": ("short", "of each column: q_left + sign q_right, less the last position where "
                      "shifted; its\n * function is share (N_left + sign N_right)"),
    "right": ("short", None), "shifted": ("short", None), "sign": ("double", None),
    "share": ("double", None),
    "by_mode": ("unsigned char", "nodal vectors in the order of their modes, those with rows"),
    "first_of": ("unsigned char", "where each mode begins"),
    "merged": ("short", "by symmetry: how many classes a row meets, and its own class times which"),
    "merged_with": ("short", None),
}


def _plan_tables(element, plan):
    layout = plan.layout
    sizes = {**layout.sizes, **section.sizes(element)}
    sizes["MOST_PAIRS"] = max(sizes["PAIRS"], sizes["GRAMS"])
    tables = {"parity": section.parities(element), **layout.tables, **section.tables(element),
              **products.TABLES,
              "sign": [c.sign for c in layout.columns],
              "share": [_number(c.share) for c in layout.columns]}
    lines = ["/* ---- eqs. 27 and 28 as products with constant matrices (generator/products.py) "
             "---- */", "", *_enum(sizes, PLAN_SIZES), ""]
    for name, (kind, note) in PLAN_TABLES.items():
        lines += [f"/* {note} */"] if note else []
        lines.append(_table(f"static const {kind} {name}[]", map(str, tables[name]), gap=""))
    for of, note in (layout.products, "nodal vectors"), (plan.sectional, "section vectors"):
        lines.append(f"/* products of {note} */")
        names = {}  # of tables; equal ones are written once
        kinds = {name: "unsigned char" if name in products.OF_VECTORS else "short"
                 for name in of.tables}
        for name, table in of.tables.items():
            names.setdefault((kinds[name], *table), f"{of.name}_{name}")
        lines += [_table(f"static const {kind} {name}[]", map(str, table), gap="")
                  for (kind, *table), name in names.items()]
        of_names = ", ".join(names[kinds[name], *table] for name, table in of.tables.items())
        lines.append("\n".join(_wrap(f"static const struct products {of.name}[1] = {{{{",
                                     f"{of.columns}, {len(of.pairs)}, {of_names}}}}};")))
    return "\n".join([*lines, ""])


def _enum(sizes, notes):
    width = max(len(f"{n} = {v},") for n, v in sizes.items())
    return ["enum {", *(f"    {f'{n} = {v},':<{width}} /* {notes[n]} */" for n, v in sizes.items()),
            "};"]


def _horner(coefficients, x):
    text = f"({_number(coefficients[-1])})" if coefficients[-1] < 0 else _number(coefficients[-1])
    for c in reversed(coefficients[:-1]):
        inner = f"{x} * ({text})" if " " in text else f"{x} * {text}"
        text = f"{_number(c)} + {inner}" if c else inner
    return text


def _shape(element):
    lines = ["static void shape(double xi, double length, double *N, double *Nx)", "{",
             "    const double A_xi[A][2] = { /* A_i(xi), dA_i/dxi */"]
    for axial in element.axial:
        lines += [f"        {{{_horner(axial.polynomial, 'xi')},",
                  f"         {_horner(derivative(axial.polynomial), 'xi')}}},"]
    lines += ["    };", "    for (int v = 0; v < V; v++) {",
              "        const int i = axial_of[v];",
              "        N[v] = A_xi[i][0] * (is_slope[i] ? length : 1.0);",
              "        Nx[v] = A_xi[i][1] * (is_slope[i] ? 1.0 : 1.0 / length);",
              "    }"]
    return "\n".join(lines + ["}", ""])


def _monomial(scale, a, b):
    factors = ["y"] * a + ["z"] * b
    if scale != 1 or not factors:
        factors.insert(0, _number(scale))
    return " * ".join(factors)


def _modes(element):
    lines = ["static void section_modes(double y, double z, const double (*f)[4],",
             "                          double (*phi)[4])", "{"]
    if not element.declaration.functions:
        lines.append("    (void)f;")
    for k, mode in enumerate(element.modes):
        if mode.function is not None:
            values = [f"f[{mode.function}][{i}]" for i in range(4)]
        else:
            (a, b), scale = mode.powers, mode.scale
            values = [_monomial(scale, a, b),
                      _monomial(scale * a, a - 1, b) if a else "0.0",
                      _monomial(scale * b, a, b - 1) if b else "0.0",
                      "0.0"]
        lines += [f"    phi[{k}][{i}] = {value};" for i, value in enumerate(values)]
    return "\n".join(lines + ["}", ""])


def _function(function):
    head = f"static {function.result} {function.name}(".replace("* ", "*")
    lines = [head]
    for number, argument in enumerate(function.arguments):
        text = argument + (")" if number == len(function.arguments) - 1 else ",")
        if len(lines[-1]) + len(text) + 1 > 100:
            lines[-1] = lines[-1].rstrip()
            lines.append(" " * len(head))
        lines[-1] += text + ("" if text.endswith(")") else " ")
    return "\n".join([f"/* {function.comment} */", *lines, "{", *write(function.body), "}", ""])


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


def _warps(element):
    """Of each section vector whether it is that of a warping function, whose name begins with w;
    empty where none is."""
    warps = [mode.startswith("w") for mode in element.declaration.modes]
    return warps + warps[1:] if any(warps) else []


def _law(element):
    if element.declaration.form == "structural":
        return [structural.LAW]
    if not (warps := _warps(element)):
        return [GRAM_LAW, SECTION_LAW.replace("RELIEVE", "")]
    table = _table("static const unsigned char warps[S]", [str(int(w)) for w in warps])
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
 * reference gradient, H = sum_I U_I g_I = du/dX: written with F0 + H/2.  Asked for a point at a time,
 * so small rather than fast. */
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


def _strain(element):
    return [STRAIN, WARPING_STRAIN] if _warps(element) else [STRAIN]


ENERGY = """\
static void energy(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                   hobe_lanes *U)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        energy_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)U + h);
}
"""

STRUCTURAL_BATCH = """\
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
"""

BATCH = """\
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
"""

TRILINEAR = """\
static void trilinear(const struct hobe_invariants *inv, const hobe_lanes *a, const hobe_lanes *b,
                      const hobe_lanes *c, hobe_lanes *f, hobe_lanes *scratch)
{
    (void)scratch;
    for (int h = 0; h < HOBE_PARTS; h++)
        trilinear_part(inv, (const hobe_real *)a + h, (const hobe_real *)b + h,
                       (const hobe_real *)c + h, (hobe_real *)f + h);
}
"""


GRAM = """\
static void gram(const struct hobe_invariants *inv, const hobe_lanes *b, const hobe_lanes *c,
                 hobe_lanes *strain, hobe_lanes *stress)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        gram_part(inv, (const hobe_real *)b + h, (const hobe_real *)c + h, (hobe_real *)strain + h,
                  (hobe_real *)stress + h);
}
"""


PLANS_OF = ("symmetry", "section", "section_cost", "tensor", "tensor_cost", "trilinear", "gram",
            "series")


def _cost(plan, of, name):
    """A table of struct hobe_plan_cost."""
    products_ = plan.sectional if of == "section" else plan.layout.products
    return _table(f"static const struct hobe_plan_cost {of}_cost[HOBE_SYMMETRIES]", [
        f"{{{c[name + 'force_part']}, {c[name + 'tangent_part']}, {products_.numbers(s)}}}"
        if name + "force_part" in c else "{0, 0, 0}" for s, c in enumerate(plan.by_symmetry)])


def _descriptor(element, plan):
    counts, layout = plan.operations, plan.layout
    d, size = element.declaration, element.sizes
    functions = [f'"{f}"' for f in d.functions]
    rule = structural.axis_rule(element.stations // 2) if d.form == "structural" else ()
    lines = [
        _table("static const double node[]", [_number(x) for x in d.nodes]),
        _table("static const struct hobe_vector vector[V]",
               [f"{{{v.node}, {v.mode}, {int(v.slope)}}}" for v in d.vectors]),
        _table("static const char *const mode_name[M]", [f'"{m}"' for m in d.modes]),
        *([_table("static const char *const function_name[]", functions)] if functions else []),
        *([_table("static const double axis_rule[][2]", [f"{{{x!r}, {w!r}}}" for x, w in rule])]
          if rule else []),
        *([_cost(plan, "section", ""), _cost(plan, "tensor", "tensor_")] if layout else []),
        "",
        f"extern const struct hobe_kernel HOBE_KERNEL({identifier(d.name)});",
        f"const struct hobe_kernel HOBE_KERNEL({identifier(d.name)}) = {{",
    ]
    scratch = 9 * size["S"] ** 2  # the section stiffness; or columns, rows and their products
    if layout:
        pairs, columns, blocks = (layout.sizes[k] for k in ("PAIRS", "COLUMNS", "BLOCKS"))
        scratch = max(section.scratch(element, blocks), 9 * pairs - 3 * columns + 10 * blocks)
    fields = {
        "abi": ABI, "name": f'"{d.name}"', "hash": f'"{d.hash}"', "source": f'"{d.source}"',
        "mechanics": f'"{d.mechanics}"', "nodes": len(d.nodes), "vectors": "V", "modes": "M",
        "functions": len(functions), "stations": element.stations, "degree": element.degree,
        "normals": "NN", "shears": "NS", "flops_force": counts["force_part"],
        "flops_tangent": counts["tangent_part"], "scratch": scratch, "node": "node",
        "axis_rule": "axis_rule" if rule else "NULL", "vector": "vector", "mode": "mode_name",
        "function": "function_name" if functions else "NULL", "shape": "shape",
        "section_modes": "section_modes", "invariants": "invariants", "energy": "energy",
        "force": "force", "tangent": "tangent",
        "axial": "AXIAL" if layout else 0,
        **{name: name if layout else "NULL" for name in PLANS_OF}, "strain": "strain",
        "warping_strain": "warping_strain" if _warps(element) else "NULL",
    }
    lines += [f"    .{name} = {value}," for name, value in fields.items()]
    return "\n".join(lines + ["};", ""])
