# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 5: C text.  One file per element, and the registry of all of them."""

from fractions import Fraction

from .ir import write
from .shape import derivative

ABI = 1  # HOBE_KERNEL_ABI of kernel.h


def identifier(name):
    """An element's name as C sees it."""
    return name.replace("-", "_")


def element_file(element, plan):
    """The C file of one element."""
    counts = plan.operations
    parts = [_head(element, counts), _tables(element), _shape(element), _modes(element)]
    parts += [INVARIANTS, STRAIN]
    parts += [_function(f) for f in plan.functions]
    parts += [BATCH, _descriptor(element, counts)]
    return "\n".join(parts)


REGISTRY = """\
/* The elements built in.  Written by `python -m generator`: do not edit. */
#include "kernel.h"

#include <stdlib.h>

{portable_externs}

static const struct hobe_kernel *const portable[] = {{
{portable_items}
    NULL,
}};

#ifdef HOBE_AVX2
{avx2_externs}

static const struct hobe_kernel *const avx2[] = {{
{avx2_items}
    NULL,
}};
#endif

const struct hobe_kernel *const *hobe_kernels(void)
{{
#ifdef HOBE_AVX2
    if (!getenv("HOBE_PORTABLE") && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return avx2;
#endif
    return portable;
}}
"""


def registry_file(elements):
    """The tables of built-in kernels, one for each machine they are compiled for."""
    symbols = ["hobe_kernel_" + identifier(e.declaration.name) for e in elements]
    lists = {}
    for table, suffix in (("portable", ""), ("avx2", "_avx2")):
        lists[table + "_externs"] = "\n".join(
            f"extern const struct hobe_kernel {s}{suffix};" for s in symbols)
        lists[table + "_items"] = "\n".join(f"    &{s}{suffix}," for s in symbols)
    return REGISTRY.format(**lists)


def _head(element, counts):
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
        f"the energy is exact with {element.stations} Gauss points on the axis",
        *_wrap("vectors (mode@node, ' for d/dx):", vectors),
        f"operations per element: force {counts['force_part']}, force and tangent "
        f"{counts['tangent_part']}, energy {counts['energy_part']}",
    ]
    return "\n".join(["/* " + text[0], *(" * " + t if t else " *" for t in text[1:]), " */",
                      '#include "kernel.h"', "", f"#if HOBE_KERNEL_ABI != {ABI}",
                      "#error Regenerate: this file was written for another kernel ABI",
                      "#endif", ""])


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


def _table(declaration, values, width=96):
    lines, line = [], "   "
    for value in values:
        if len(line) + len(value) + 2 > width:
            lines.append(line)
            line = "   "
        line += f" {value},"
    return "\n".join([f"{declaration} = {{", *lines, line, "};"])


def _tables(element):
    d, size = element.declaration, element.sizes
    notes = {"V": "nodal vectors", "M": "section modes", "S": "section vectors d_k', d_k",
             "NA": "Gram pairs d_k'.d_l'", "NN": "normal block: those and d_k.d_l",
             "NS": "shear block: d_k'.d_l", "A": "distinct axial functions"}
    width = max(len(f"{n} = {v},") for n, v in size.items())
    enum = [f"    {f'{n} = {v},':<{width}} /* {notes[n]} */" for n, v in size.items()]
    overlap = [_number(x) for row in element.overlap for x in row]
    return "\n".join([
        "enum {", *enum, "};", "",
        "static const hobe_real zero = {0};", "",
        "/* Of each nodal vector: mode; whether it is a position; axial function. */",
        _table("static const unsigned char mode[V]", [str(v.mode) for v in d.vectors]),
        _table("static const unsigned char position[V]",
               [str(int(v.is_position)) for v in d.vectors]),
        _table("static const unsigned char axial_of[V]", map(str, element.axial_of)),
        _table("static const unsigned char is_slope[A]",
               [str(int(a.slope)) for a in element.axial]),
        "", "/* int_0^1 A_i A_j dxi, exact */",
        _table("static const double overlap[A * A]", overlap), "",
        "static inline int symmetric(int i, int j)", "{",
        "    return i >= j ? hobe_pair(i, j) : hobe_pair(j, i);", "}", ""])


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
    lines = ["static void section_modes(double y, double z, const double (*f)[3],",
             "                          double (*phi)[3])", "{"]
    if not element.declaration.functions:
        lines.append("    (void)f;")
    for k, mode in enumerate(element.modes):
        if mode.function is not None:
            values = [f"f[{mode.function}][{i}]" for i in range(3)]
        else:
            (a, b), scale = mode.powers, mode.scale
            values = [_monomial(scale, a, b),
                      _monomial(scale * a, a - 1, b) if a else "0.0",
                      _monomial(scale * b, a, b - 1) if b else "0.0"]
        lines += [f"    phi[{k}][{i}] = {value};" for i, value in enumerate(values)]
    return "\n".join(lines + ["}", ""])


def _function(function):
    head = f"static {function.result} {function.name}("
    lines = [head]
    for number, argument in enumerate(function.arguments):
        text = argument + (")" if number == len(function.arguments) - 1 else ",")
        if len(lines[-1]) + len(text) + 1 > 100:
            lines[-1] = lines[-1].rstrip()
            lines.append(" " * len(head))
        lines[-1] += text + ("" if text.endswith(")") else " ")
    return "\n".join([f"/* {function.comment} */", *lines, "{", *write(function.body), "}", ""])


INVARIANTS = """\
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
"""

STRAIN = """\
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
"""

BATCH = """\
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
"""


def _descriptor(element, counts):
    d, size = element.declaration, element.sizes
    functions = [f'"{f}"' for f in d.functions]
    lines = [
        _table("static const double node[]", [_number(x) for x in d.nodes]),
        _table("static const struct hobe_vector vector[V]",
               [f"{{{v.node}, {v.mode}, {int(v.slope)}}}" for v in d.vectors]),
        _table("static const char *const mode_name[M]", [f'"{m}"' for m in d.modes]),
        *([_table("static const char *const function_name[]", functions)] if functions else []),
        "",
        f"extern const struct hobe_kernel HOBE_KERNEL({identifier(d.name)});",
        f"const struct hobe_kernel HOBE_KERNEL({identifier(d.name)}) = {{",
    ]
    # the section stiffness and one column, for one of at least two parts of a batch
    scratch = (9 * size["S"] ** 2 + 3 * (size["NN"] + size["NS"]) + 1) // 2
    fields = {
        "abi": ABI, "name": f'"{d.name}"', "hash": f'"{d.hash}"', "source": f'"{d.source}"',
        "mechanics": f'"{d.mechanics}"', "nodes": len(d.nodes), "vectors": "V", "modes": "M",
        "functions": len(functions), "stations": element.stations, "degree": element.degree,
        "normals": "NN", "shears": "NS", "flops_force": counts["force_part"],
        "flops_tangent": counts["tangent_part"], "scratch": scratch, "node": "node",
        "vector": "vector", "mode": "mode_name",
        "function": "function_name" if functions else "NULL", "shape": "shape",
        "section_modes": "section_modes", "invariants": "invariants", "energy": "energy",
        "force": "force", "tangent": "tangent", "trilinear": "trilinear", "strain": "strain",
    }
    lines += [f"    .{name} = {value}," for name, value in fields.items()]
    return "\n".join(lines + ["};", ""])
