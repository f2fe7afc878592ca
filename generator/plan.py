# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4: the section-factored contraction of eqs. 27 and 28, as loop nests; that of tensor.py,
the other way to force and tangent, comes with it.

At each axial station the S = 2M-1 section vectors D_I (d_k', then d_k) are formed from the nodal
vectors, their Gram differences s from the reference are contracted with the section's quadratic
form Q (sigma = Q s), and force and tangent are handed back to the nodes:

    dW/dD_I       = sum_J sigma_IJ D_J
    d2W/dD_I dD_J = sum_KL D_K Q_(IK)(JL) D_L^T + sigma_IJ 1

Both hold without factors of two because diagonal Gram entries carry a half (kernel.h).  Nothing
here knows an element's name: sizes and tables come from the Element.  This is the form "continuum";
what the form "structural" puts in its place is in structural.py.
"""

from dataclasses import dataclass

from . import structural, tensor
from .form import Form, axis3, filled, given, numbers, product
from .ir import Counter, Do, For, Function, If, Let, Note, loop


@dataclass(frozen=True)
class Plan:
    """The functions of a contraction, callees first, and the operations of one call of each "_part"
    of it, per lane, at the element's own number of stations, straight and prismatic: those of the
    tensor for each symmetry of the section."""

    functions: tuple
    operations: dict
    layout: tensor.Layout | None  # of the tensor; None where there is none
    tensors: tuple = ()           # operations by symmetry


def build(element):
    """The plan of an Element."""
    loops, names = functions(element.declaration.form), tables(element)
    counts = _counts(loops, {**names, "inv_stations": element.stations, "Qc": 0})
    if element.declaration.form != "continuum":
        return Plan(loops, counts, None)
    layout, products = tensor.layout(element), tensor.functions()
    names |= layout.sizes | layout.tables
    return Plan(loops + products, counts, layout, tuple(
        _counts(loops + products, {**names, "symmetry": s})
        for s in tensor.SYMMETRIES))


def tables(element):
    """Sizes and integer tables that the loops of an element run over."""
    vectors = element.declaration.vectors
    return {**element.sizes, "mode": [v.mode for v in vectors],
            "position": [int(v.is_position) for v in vectors]}


def _counts(loops, names):
    """Operations of one call of each "_part" that the names suffice for."""
    counter = Counter(loops, names)
    return {f.name: counter.count(f.name) for f in loops if f.name.endswith("_part")
            and f.name.startswith("tensor") == ("symmetry" in names)}


def functions(form):
    """The loop nests, the same for every element of a form: sizes and tables make the difference.
    """
    form = {"continuum": _continuum, "structural": structural.form}[form]()
    return (_section_vectors(), _dot(), _gather(), _expand(), *form.functions, _force_part(form),
            _energy_part(form), _tangent_part(form))


INVARIANTS = "const struct hobe_invariants *inv"


def _section_vectors():
    return Function(
        "section_vectors",
        (*numbers("N", "Nx"), *given("q"), *filled("D")),
        "D[S][3] = d_k' = sum_v N_v' q_v (I = k), and d_k = sum_v N_v q_v (I = M-1+k, k > 0)",
        (
            loop("i", "3 * S", Do("D[i] = zero;")),
            loop(
                "v", "V",
                Let("k", "mode[v]"),
                axis3("D[3 * k + a] += Nx[v] * q[3 * v + a];"),
                If("k > 0", (axis3("D[3 * (M - 1 + k) + a] += N[v] * q[3 * v + a];"),)),
            ),
        ))


def _dot():
    return Function(
        "dot", given("a", "b"), "a . b",
        (Do("return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];"),), result="inline hobe_real")


def _differences():
    def triangle(target, first, last):
        """Pairs of vectors first..last-1, numbered from 0."""
        i, j = ("i", "j") if first == "0" else (f"i - {first}", f"j - {first}")
        return For("i", first, last, (
            For("j", first, "i", (Do(f"{target}[hobe_pair({i}, {j})] = {mixed}"),)),
            Do(f"{target}[hobe_pair({i}, {i})] = dot(B + 3 * i, C + 3 * i);")))

    mixed = "dot(B + 3 * i, C + 3 * j) + dot(B + 3 * j, C + 3 * i);"
    return Function(
        "differences",
        (*given("B", "C"), *filled("n", "s")),
        "s_IJ = B_I.C_J + C_I.B_J, s_II = B_I.C_I: with B = D0 + U/2, C = U the Gram differences\n"
        " * D_I.D_J - D0_I.D0_J without cancellation",
        (
            Do("hobe_real *values = n + NA;", free=True),
            triangle("n", "0", "M"),
            triangle("values", "M", "S"),
            loop("i", "M", For("j", "M", "S", (Do(f"s[i * (M - 1) + j - M] = {mixed}"),))),
        ))


def _stress():
    coupling = loop("r", "NN", loop(
        "c", "NS",
        Do("tn[r] += Qc[r * NS + c] * s[c];"),
        Do("ts[c] += Qc[r * NS + c] * n[r];")))
    return Function(
        "stress",
        (*numbers("Qn", "Qs", "Qc"), *given("n", "s"), *filled("tn", "ts")),
        "sigma = Q s, the stress resultants conjugate to the Gram differences",
        (*product("NN", "Qn", "n", "tn"), *product("NS", "Qs", "s", "ts"),
         If("Qc", (coupling,))))


def _section_force():
    def row(first, last, entry):
        return For("j", first, last, (
            Do(f"const hobe_real t = {entry};"),
            axis3("P[3 * i + a] += t * D[3 * j + a];")))

    return Function(
        "section_force",
        (*given("tn", "ts", "D"), *filled("P")),
        "P_I = dW/dD_I = sum_J sigma_IJ D_J",
        (
            loop("i", "3 * S", Do("P[i] = zero;")),
            loop("i", "M", row("0", "M", "tn[symmetric(i, j)]"),
                 row("M", "S", "ts[i * (M - 1) + j - M]")),
            For("i", "M", "S", (row("0", "M", "ts[j * (M - 1) + i - M]"),
                                row("M", "S", "tn[NA + symmetric(i - M, j - M)]"))),
        ))


def _gather():
    return Function(
        "gather",
        (*given("q"), *filled("x")),
        "x[V][3] = one part of a batch, positions relative to the first node's",
        (loop("v", "V", loop(
            "a", "3",
            Do("x[3 * v + a] = q[(3 * v + a) * HOBE_PARTS];"),
            If("position[v]", (Do("x[3 * v + a] -= q[a * HOBE_PARTS];"),)))),))


AXIAL = Do("const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;", free=True)

LAW = (
    Do("const double *Qn = inv->Qn + inv->step_n * g, *Qs = inv->Qs + inv->step_s * g;", free=True),
    Do("const double *Qc = inv->Qc ? inv->Qc + inv->step_c * g : NULL;", free=True),
)

VECTORS = (
    Do("section_vectors(N, Nx, x0, B);"),
    Do("section_vectors(N, Nx, x, U);"),
    loop("i", "3 * S", Do("B[i] += 0.5 * U[i];")),
)

CURRENT = Note("D = D0 + U"), loop("i", "3 * S", Do("B[i] += 0.5 * U[i];"))

VECTOR_ARRAYS = Do("hobe_real x0[3 * V], x[3 * V], B[3 * S], U[3 * S];", free=True)
GRAM_ARRAYS = Do("hobe_real n[NN], s[NS], tn[NN], ts[NS];", free=True)


def _continuum():
    """The strain of the continuum at each point of the section, as Gram differences."""
    return Form(
        functions=(_differences(), _stress(), _section_force(), _polar(), _trilinear_part(),
                   _coupled_column(), _section_stiffness()),
        arrays=(GRAM_ARRAYS,),
        law=LAW,
        state=(Do("differences(B, U, n, s);"), Do("stress(Qn, Qs, Qc, n, s, tn, ts);")),
        work=(loop("r", "NN", Do("w += n[r] * tn[r];")), loop("r", "NS", Do("w += s[r] * ts[r];"))),
        force=(Do("section_force(tn, ts, B, U);"),),
        stiffness=(Do("section_stiffness(Qn, Qs, Qc, tn, ts, B, C, C + 9 * S * S);"),))


def _hand_back(source):
    """f_v += w (N_v' P_k' + N_v P_k)."""
    return loop(
        "v", "V",
        Let("k", "mode[v]"),
        Do("const double cx = inv->wx[g] * Nx[v], c = inv->wx[g] * N[v];", free=True),
        axis3(f"f[(3 * v + a) * HOBE_PARTS] += cx * {source}[3 * k + a];"),
        If("k > 0", (
            axis3(f"f[(3 * v + a) * HOBE_PARTS] += c * {source}[3 * (M - 1 + k) + a];"),)))


CLEAR_FORCE = loop("i", "3 * V", Do("f[i * HOBE_PARTS] = zero;"))


def _force_part(form):
    return Function(
        "force_part",
        (INVARIANTS, *given("q0", "u"), *filled("f")),
        "f = dU/dq, eq. 27, for one part of a batch",
        (
            VECTOR_ARRAYS,
            *form.arrays,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            CLEAR_FORCE,
            loop("g", "inv->stations", AXIAL, *form.law, *VECTORS, *form.state, *CURRENT,
                 *form.force, _hand_back("U")),
        ))


def _energy_part(form):
    return Function(
        "energy_part",
        (INVARIANTS, *given("q0", "u"), *filled("energy")),
        "U = sum_g w_g s.sigma/2, eq. 26",
        (
            VECTOR_ARRAYS,
            *form.arrays,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            Do("hobe_real sum = zero;"),
            loop("g", "inv->stations", AXIAL, *form.law, *VECTORS, *form.state,
                 Do("hobe_real w = zero;"), *form.work,
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
        "f = T(a; b, c): sigma = Q s(b, c), the Gram entries in polar form, applied to D(a)",
        (
            Do("hobe_real xa[3 * V];", free=True),
            VECTOR_ARRAYS,
            GRAM_ARRAYS,
            Do("gather(qa, xa);"),
            Do("gather(qb, x0);"),
            Do("gather(qc, x);"),
            CLEAR_FORCE,
            loop("g", "inv->stations", AXIAL, *LAW,
                 Do("polar(N, Nx, x0, x, B, U);"),
                 Do("differences(B, U, n, s);"),
                 Do("stress(Qn, Qs, Qc, n, s, tn, ts);"),
                 Do("section_vectors(N, Nx, xa, B);"),
                 Do("section_force(tn, ts, B, U);"), _hand_back("U")),
        ))


def _column():
    """T_r = sum_L Q_r(JL) D_L: the change of every stress resultant with D_J."""

    def product(size, q, entry, target, first, last):
        return loop(
            "r", size,
            Do("hobe_real sum[3] = {zero, zero, zero};", free=True),
            For("l", first, last, (
                axis3(f"sum[a] += {q}[r * {size} + {entry}] * D[3 * l + a];"),)),
            loop("a", "3", Do(f"{target}[3 * r + a] = sum[a];")))

    return (
        If("j < M", (product("NN", "Qn", "symmetric(j, l)", "Tn", "0", "M"),
                     product("NS", "Qs", "j * (M - 1) + l - M", "Ts", "M", "S"))),
        If("j >= M", (product("NN", "Qn", "NA + symmetric(j - M, l - M)", "Tn", "M", "S"),
                      product("NS", "Qs", "l * (M - 1) + j - M", "Ts", "0", "M"))),
    )


def _coupled_column():
    def add(row, column, target, first, last):
        """target_r += sum_L Qc_(row, column) D_L; one of row and column is r."""
        return loop("r", "NN" if target == "Tn" else "NS", For("l", first, last, (
            axis3(f"{target}[3 * r + a] += Qc[({row}) * NS + {column}] * D[3 * l + a];"),)))

    return Function(
        "coupled_column",
        (*numbers("Qc"), "int j", *given("D"), *filled("Tn", "Ts")),
        "Adds to T_r = sum_L Q_r(JL) D_L what couples the normal and the shear block",
        (
            If("j < M", (add("r", "j * (M - 1) + l - M", "Tn", "M", "S"),
                         add("symmetric(j, l)", "r", "Ts", "0", "M"))),
            If("j >= M", (add("r", "l * (M - 1) + j - M", "Tn", "0", "M"),
                          add("NA + symmetric(j - M, l - M)", "r", "Ts", "M", "S"))),
        ))


def _section_stiffness():
    def block(first, last, entry):
        return For("l", first, last, (
            Do(f"const int r = {entry[1]};", free=True),
            loop("a", "3", loop("b", "3", Do(
                f"sum[3 * a + b] += D[3 * l + a] * {entry[0]}[3 * r + b];")))))

    store = (
        loop("a", "3", Do("sum[4 * a] += t;")),
        loop("a", "3", loop("b", "3",
             Do("C[9 * (i * S + j) + 3 * a + b] = sum[3 * a + b];", free=True),
             Do("C[9 * (j * S + i) + 3 * b + a] = sum[3 * a + b];", free=True))),
    )
    zero9 = Do("hobe_real sum[9] = {zero, zero, zero, zero, zero, zero, zero, zero, zero};",
               free=True)
    return Function(
        "section_stiffness",
        (*numbers("Qn", "Qs", "Qc"), *given("tn", "ts", "D"), *filled("C", "T")),
        "C_IJ = d2W/dD_I dD_J = sum_K D_K T_(IK)^T + sigma_IJ 1, all S x S blocks, by columns:\n"
        " * T_r = sum_L Q_r(JL) D_L is the change of every stress resultant with D_J",
        (
            Do("hobe_real *Tn = T, *Ts = T + 3 * NN;", free=True),
            loop(
                "j", "S",
                *_column(),
                If("Qc", (Do("coupled_column(Qc, j, D, Tn, Ts);"),)),
                For("i", "j", "S", (
                    zero9,
                    Do("hobe_real t = zero;", free=True),
                    If("i < M", (
                        Do("t = tn[symmetric(i, j)];", free=True),
                        block("0", "M", ("Tn", "symmetric(i, l)")),
                        block("M", "S", ("Ts", "i * (M - 1) + l - M")))),
                    If("i >= M && j < M", (
                        Do("t = ts[j * (M - 1) + i - M];", free=True),)),
                    If("i >= M && j >= M", (
                        Do("t = tn[NA + symmetric(i - M, j - M)];", free=True),)),
                    If("i >= M", (
                        block("0", "M", ("Ts", "l * (M - 1) + i - M")),
                        block("M", "S", ("Tn", "NA + symmetric(i - M, l - M)")))),
                    *store)),
            ),
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


def _tangent_part(form):
    return Function(
        "tangent_part",
        (INVARIANTS, *given("q0", "u"), *filled("f", "K", "C")),
        "f as in force_part and K = df/dq, eq. 28; C: scratch for the section stiffness",
        (
            VECTOR_ARRAYS,
            *form.arrays,
            Do("gather(q0, x0);"),
            Do("gather(u, x);"),
            CLEAR_FORCE,
            loop("i", "9 * V * (V + 1) / 2", Do("K[i * HOBE_PARTS] = zero;")),
            loop("g", "inv->stations", AXIAL, *form.law, *VECTORS, *form.state, *CURRENT,
                 *form.stiffness,
                 Do("expand(N, Nx, inv->wx[g], C, K);"),
                 *form.force, _hand_back("U")),
        ))
