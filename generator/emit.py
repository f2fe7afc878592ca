# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 5: C text.  One file per element, of parts that have rooms of their own."""

from . import batch, ctext, law, products, section, series, structural, tables, tensor
from .ir import write
from .shape import derivative

ABI = 8  # HOBE_KERNEL_ABI of kernel.h


def element_file(element, plan):
    """The C file of one element."""
    parts = [_head(element, plan), tables.of_element(element), _shape(element), _modes(element)]
    parts += [law.REFERENCE, *law.functions(element), law.INVARIANTS, *law.strains(element)]
    if plan.layout:
        parts += [products.STRUCTURE, tables.of_plan(element, plan), products.SYMMETRY,
                  products.COEFFICIENTS, tensor.COEFFICIENTS, section.COEFFICIENTS]
    parts += [_function(f) for f in plan.functions]
    parts += [batch.ENERGY]
    parts += ([batch.BATCH, batch.TRILINEAR, batch.GRAM, series.SERIES] if plan.layout
              else [batch.STRUCTURAL_BATCH])
    parts.append(_descriptor(element, plan))
    return "\n".join(parts)


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
        *ctext.wrap("modes", " ".join(d.modes)),
        _points(element),
        *ctext.wrap("vectors (mode@node, ' for d/dx):", vectors),
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


def _shape(element):
    lines = ["static void shape(double xi, double length, double *N, double *Nx)", "{",
             "    const double A_xi[A][2] = { /* A_i(xi), dA_i/dxi */"]
    for axial in element.axial:
        lines += [f"        {{{ctext.horner(axial.polynomial, 'xi')},",
                  f"         {ctext.horner(derivative(axial.polynomial), 'xi')}}},"]
    lines += ["    };", "    for (int v = 0; v < V; v++) {",
              "        const int i = axial_of[v];",
              "        N[v] = A_xi[i][0] * (is_slope[i] ? length : 1.0);",
              "        Nx[v] = A_xi[i][1] * (is_slope[i] ? 1.0 : 1.0 / length);",
              "    }"]
    return "\n".join(lines + ["}", ""])


def _monomial(scale, a, b):
    factors = ["y"] * a + ["z"] * b
    if scale != 1 or not factors:
        factors.insert(0, ctext.number(scale))
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


PLANS_OF = ("symmetry", "section", "section_cost", "tensor", "tensor_cost", "trilinear", "gram",
            "series")


def _cost(plan, of, name):
    """A table of struct hobe_plan_cost."""
    products_ = plan.sectional if of == "section" else plan.layout.products
    return ctext.table(f"static const struct hobe_plan_cost {of}_cost[HOBE_SYMMETRIES]", [
        f"{{{c[name + 'force_part']}, {c[name + 'tangent_part']}, {products_.numbers(s)}}}"
        if name + "force_part" in c else "{0, 0, 0}" for s, c in enumerate(plan.by_symmetry)])


def _descriptor(element, plan):
    counts, layout = plan.operations, plan.layout
    d, size = element.declaration, element.sizes
    functions = [f'"{f}"' for f in d.functions]
    rule = structural.axis_rule(element.stations // 2) if d.form == "structural" else ()
    lines = [
        ctext.table("static const double node[]", [ctext.number(x) for x in d.nodes]),
        ctext.table("static const struct hobe_vector vector[V]",
               [f"{{{v.node}, {v.mode}, {int(v.slope)}}}" for v in d.vectors]),
        ctext.table("static const char *const mode_name[M]", [f'"{m}"' for m in d.modes]),
        *([ctext.table("static const char *const function_name[]", functions)]
          if functions else []),
        *([ctext.table("static const double axis_rule[][2]",
                       [f"{{{x!r}, {w!r}}}" for x, w in rule])] if rule else []),
        *([_cost(plan, "section", ""), _cost(plan, "tensor", "tensor_")] if layout else []),
        "",
        f"extern const struct hobe_kernel HOBE_KERNEL({ctext.identifier(d.name)});",
        f"const struct hobe_kernel HOBE_KERNEL({ctext.identifier(d.name)}) = {{",
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
        "warping_strain": "warping_strain" if law.warping(element) else "NULL",
    }
    lines += [f"    .{name} = {value}," for name, value in fields.items()]
    return "\n".join(lines + ["};", ""])
