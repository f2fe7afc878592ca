# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 4: contraction plans, ways to the sums of eqs. 27 and 28, as loop nests.

`section` (section.py) goes from station to station along the axis, for any beam; `tensor`
(tensor.py) takes all at once, where the beam is straight and prismatic.  Both are products of
constant matrices with products of vectors (products.py).  Nothing here knows an element's name:
sizes and tables come from the Element.  The form "structural" has a way of its own (structural.py).

A third plan, `points`, goes by Gauss points through the volume.  Where all modes are polynomials,
so that few points are exact, force and tangent have up to 67 times the operations of what is taken,
and nowhere fewer; functions of a section want hundreds of points.  It is not emitted: one file of
the runtime (points_machine.c) is that plan for all elements, as the yardstick.
"""

from dataclasses import dataclass

from . import products, section, structural, tensor
from .form import axis3, filled, given, numbers
from .ir import Counter, Do, Function, If, Let, loop


@dataclass(frozen=True)
class Plan:
    """The functions of an element, callees first, and the operations of one call of each "_part",
    per lane, at the element's own number of stations."""

    functions: tuple
    operations: dict                         # straight and prismatic, any section
    layout: tensor.Layout | None = None      # of the tensor; None where there is none
    sectional: products.Products | None = None
    by_symmetry: tuple = ()                  # operations by symmetry


def build(element):
    """The plan of an Element."""
    loops, names = functions(element.declaration.form), tables(element)
    if element.declaration.form != "continuum":
        counter = Counter(loops, {**names, "inv_stations": element.stations})
        return Plan(loops, {name: counter.count(name) for name in PARTS})
    layout, sectional = tensor.layout(element), section.products(element)
    counters = [Counter(loops, {**names, **of.names, "inv_stations": element.stations})
                for of in (sectional, layout.products)]
    counts = tuple(_by_symmetry(*counters, s) for s in products.SYMMETRIES)
    return Plan(loops, counts[1], layout, sectional, counts)


def tables(element):
    """Sizes and integer tables that the loops of an element run over."""
    vectors = element.declaration.vectors
    names = {**element.sizes, "mode": [v.mode for v in vectors],
             "position": [int(v.is_position) for v in vectors], "axial_of": element.axial_of}
    if element.declaration.form == "continuum":
        layout = tensor.layout(element)
        names |= {**layout.sizes, **layout.tables, **section.sizes(element),
                  **section.tables(element), **products.TABLES, "TALL": 1,
                  "nodal_mirror": layout.products.mirror}
    return names


PARTS = "force_part", "tangent_part", "energy_part"


def _by_symmetry(sectional, nodal, symmetry):
    for counter in sectional, nodal:
        counter.set("symmetry", symmetry)
    counts = {name: sectional.count(name) for name in PARTS}
    if symmetry & products.ALONG:  # which the tensor needs
        counts |= {name: nodal.count(name) for name in ("tensor_force_part", "tensor_tangent_part")}
    return counts


def functions(form):
    """The loop nests, the same for every element of a form: sizes and tables make the difference.
    """
    common = _section_vectors(), _dot(), _gather()
    if form == "structural":
        return (*common, *structural.functions())
    return (*common, *products.functions(), *tensor.tail(), *section.functions(),
            *tensor.functions())


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


def _gather():
    return Function(
        "gather",
        (*given("q"), *filled("x")),
        "x[V][3] = one part of a batch, positions relative to the first node's",
        (loop("v", "V", loop(
            "a", "3",
            Do("x[3 * v + a] = q[(3 * v + a) * HOBE_PARTS];"),
            If("position[v]", (Do("x[3 * v + a] -= q[a * HOBE_PARTS];"),)))),))
