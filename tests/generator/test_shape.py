# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape functions, vectors, exact integrals and stations of the elements shipped."""

import functools
import re
import unittest
from fractions import Fraction
from itertools import combinations_with_replacement

import sympy
from declare import LINEAR, PLANE, Case, c_text, shipped
from generator import shape

XI = sympy.Symbol("xi")

# Axial functions by node; those of slopes carry the length l.
LAGRANGE_2 = ("1 - xi", "xi")
LAGRANGE_3 = ("1 - 3*xi + 2*xi**2", "4*xi*(1 - xi)", "xi*(2*xi - 1)")
LAGRANGE_4 = ("1 - 11/2*xi + 9*xi**2 - 9/2*xi**3", "(9 - 45/2*xi + 27/2*xi**2)*xi",
              "(-9/2 + 18*xi - 27/2*xi**2)*xi", "(1 - 9/2*xi + 9/2*xi**2)*xi")
HERMITE = ("1 - 3*xi**2 + 2*xi**3", "xi - 2*xi**2 + xi**3", "3*xi**2 - 2*xi**3", "-xi**2 + xi**3")

QUADRATIC, CUBIC = "yy yz zz", "yyy yyz yzz zzz"
QUARTIC = "yyyy yyyz yyzz yzzz zzzz"

# Of each element: centreline, other fields, the modes of its nodes (1' is the slope of 1), vectors.
END, MIDDLE = "1 1' y z ", "y z "
EXPECTED = {
    "BE24": (HERMITE, LAGRANGE_2, [END] * 2, 8),
    "BE42": (HERMITE, LAGRANGE_2, [END + QUADRATIC] * 2, 14),
    "B4": (HERMITE, LAGRANGE_2, [f"{END}{QUADRATIC} {CUBIC} {QUARTIC}"] * 2, 32),
    "MGD30": (HERMITE, LAGRANGE_3, [END, MIDDLE, END], 10),
    "3333": (LAGRANGE_3, LAGRANGE_3, ["1 y z"] * 3, 9),
    "3333s": (LAGRANGE_3, LAGRANGE_3, ["1 y z"] * 3, 9),
    "3363": (LAGRANGE_3, LAGRANGE_3, ["1 y z " + QUADRATIC] * 3, 18),
    "3433": (LAGRANGE_4, LAGRANGE_4, ["1 y z"] * 4, 12),
    "34X3": (LAGRANGE_4, LAGRANGE_4, [f"1 y z {QUADRATIC} {CUBIC}"] * 4, 40),
    "BE24w": (HERMITE, LAGRANGE_2, [END + "w"] * 2, 10),
    "MGD30w": (HERMITE, LAGRANGE_3, [END + "w", MIDDLE + "w", END + "w"], 13),
    "3333w": (LAGRANGE_3, LAGRANGE_3, ["1 y z w"] * 3, 12),
    "3433w": (LAGRANGE_4, LAGRANGE_4, ["1 y z w"] * 4, 16),
    "BE24w-II": (HERMITE, LAGRANGE_2, [f"{END}w {QUADRATIC} {CUBIC}"] * 2, 24),
    "MGD30w-II": (HERMITE, LAGRANGE_3, [f"{modes}w {QUADRATIC} {CUBIC}"
                                        for modes in (END, MIDDLE, END)], 34),
}


@functools.cache
def expand(text):
    """Coefficients of a polynomial, constant first."""
    poly = sympy.Poly(sympy.sympify(text, {"xi": XI}, rational=True), XI)
    return tuple(Fraction(int(c.p), int(c.q)) for c in reversed(poly.all_coeffs()))


def in_sympy(polynomial):
    return sum(sympy.Rational(c.numerator, c.denominator) * XI**n for n, c in enumerate(polynomial))


@functools.cache
def integral(a, b):
    value = sympy.integrate(sympy.expand(in_sympy(a) * in_sympy(b)), (XI, 0, 1))
    return Fraction(int(value.p), int(value.q))


def each(test):
    """Runs a test(self, name, element) for every published element."""

    @functools.wraps(test)
    def run(self):
        for name in EXPECTED:
            with self.subTest(name):
                test(self, name, self.elements[name])

    return run


class Shipped(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.elements = shipped()

    @each
    def test_shape_functions(self, name, element):
        centreline, others, *_ = EXPECTED[name]
        for vector, axial in zip(element.declaration.vectors, element.axial_of):
            wanted = (centreline if vector.mode == 0 else others)[vector.place]
            self.assertEqual(element.axial[axial].polynomial, expand(wanted))
            self.assertEqual(element.axial[axial].slope, vector.slope)

    @each
    def test_vectors(self, name, element):
        item = element.declaration
        found = [(v.node, item.modes[v.mode] + "'" * v.slope) for v in item.vectors]
        modes = EXPECTED[name][2]
        self.assertEqual(found, [(n, m) for n, at in enumerate(modes) for m in at.split()])
        self.assertEqual(len(found), EXPECTED[name][3])

    @each
    def test_nodes(self, name, element):
        last = len(EXPECTED[name][2]) - 1
        self.assertEqual(element.declaration.nodes, tuple(
            Fraction(i, last) for i in range(last + 1)))

    @each
    def test_stations(self, name, element):
        """The fewest Gauss points that integrate the quartic of d_k' and d_k, k > 0."""
        powers = [len(element.axial[a].polynomial) - (2 if v.mode == 0 else 1)
                  for v, a in zip(element.declaration.vectors, element.axial_of)]
        self.assertEqual(element.stations, -(-(4 * max(powers) + 1) // 2))
        self.assertEqual(element.stations, 7 if name in ("3433", "3433w", "34X3") else 5)

    @each
    def test_overlap(self, _, element):
        for i, j in combinations_with_replacement(range(len(element.axial)), 2):
            found = element.overlap[i][j]
            self.assertEqual(found, integral(element.axial[i].polynomial,
                                             element.axial[j].polynomial))
            self.assertEqual(found, element.overlap[j][i])

    @each
    def test_printed_functions(self, _, element):
        """The C text carries the same polynomials and their derivatives, exactly."""
        points = [Fraction(n, 7) for n in range(-3, 5)]  # more than any degree
        rows = re.search(r"A_xi\[A\]\[2\] = \{.*?\n(.*?)\n    \};", c_text(element), re.S)[1]
        rows = re.sub(r"\b(\d+)\.0\b", r"Fraction(\1)", rows)
        rows = re.findall(r"\{(.*?),\n(.*?)\},", rows)
        self.assertEqual(len(rows), len(element.axial))
        for axial, texts in zip(element.axial, rows):
            wanted = axial.polynomial, shape.derivative(axial.polynomial)
            for text, polynomial in zip(texts, wanted):
                for xi in points:
                    found = eval(text.strip(), {"Fraction": Fraction, "xi": xi})
                    self.assertEqual(found, shape.evaluate(polynomial, xi))

    @each
    def test_section_modes(self, _, element):
        """Monomials carry their factorials; a section function is its own."""
        for mode, name in zip(element.modes, element.declaration.modes):
            if name == "w":
                self.assertEqual(mode.function, 0)
                continue
            a, b = name.count("y"), name.count("z")
            self.assertEqual((mode.function, mode.powers), (None, (a, b)))
            factorials = sympy.factorial(a) * sympy.factorial(b)
            self.assertEqual(mode.scale, Fraction(1, int(factorials)))


class Derived(Case):
    def test_irregular_nodes(self):
        """Any nodes and functionals: N_j is 1 for its own and 0 for the others."""
        text = ('name = "T"\nnodes = ["0", "1/5", "2/3", "1"]\n[[field]]\nmodes = ["1", "y", "z"]\n'
                'dofs = { 1 = ["value", "slope"], 2 = ["value"], 3 = ["slope", "value"], '
                '4 = ["value", "slope"] }\n')
        item, = self.read(text)
        functions, = shape.derive(item)
        self.assertEqual({len(f) for f in functions}, {7})
        for i, dof in enumerate(item.fields[0].dofs):
            for j, function in enumerate(functions):
                poly = in_sympy(function)
                value = (sympy.diff(poly, XI) if dof.slope else poly).subs(
                    XI, sympy.Rational(str(item.nodes[dof.node])))
                self.assertEqual(value, int(i == j))

    def test_explicit_functions(self):
        """The derived functions written out, in any form, give the same C but for its hash."""
        slopes = '{ 1 = ["value", "slope"], 2 = ["value", "slope"] }'
        centre = f'[[field]]\nmodes = ["1"]\ndofs = {slopes}\n'
        plane = PLANE.replace('"1", ', "")
        head = 'name = "T"\nnodes = ["0", "1"]\n'
        forms = ('"(1 - xi)**2*(1 + 2*xi)", "xi*(xi - 1)**2", "-(2*xi - 3)*xi**2", "xi*xi*(-1+xi)"',
                 '"+1-6/2*xi**2+2*xi**3", "xi - 4/2*xi**2 + xi**3", "xi**2*3 - (2*xi)*xi**2", '
                 '"(xi**3*3 - 3*xi**2)/3"')
        derived = c_text(self.element(head + centre + plane))
        for form in forms:
            text = c_text(self.element(f"{head}{centre}functions = [{form}]\n{plane}"
                                       'functions = ["1 - xi", "xi"]\n'))
            changed = [(a, b) for a, b in zip(derived.split("\n"), text.split("\n")) if a != b]
            self.assertEqual(len(changed), 2)
            for a, b in changed:
                self.assertNotEqual(a, b)
                self.assertEqual(re.sub(r"\b[0-9a-f]{16}\b", "", a),
                                 re.sub(r"\b[0-9a-f]{16}\b", "", b))
            self.assertEqual(len(derived), len(text))

    def test_other_functions(self):
        """Functions that differ from the derived ones are kept, and set the stations."""
        bubble = "xi*(1 - xi)*(1/2 - xi)"
        text = ('name = "T"\nnodes = ["0", "1"]\n[[field]]\nmodes = ["1"]\n'
                f'dofs = {LINEAR}\n[[field]]\nmodes = ["y", "z"]\ndofs = {LINEAR}\n'
                f'functions = ["1 - xi + {bubble}", "xi - {bubble}"]\n')
        element = self.element(text)
        self.assertEqual(element.axial[1].polynomial, expand(f"1 - xi + {bubble}"))
        self.assertEqual(element.stations, 7)


if __name__ == "__main__":
    unittest.main()
