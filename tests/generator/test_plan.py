# SPDX-License-Identifier: GPL-3.0-or-later
"""The contraction plan: its operations counted, and its algebra exact."""

import re
import unittest
from fractions import Fraction
from random import Random

from declare import HEAD, PLANE, Case, c_text, shipped
from generator import plan, products, section, structural, tensor
from generator.shape import derivative
from generator.ir import Counter, Do, For, Function, If, Let, Note, loop, operations
from interpret import Machine, Pointer, empty, lanes, structure, values

HALF = Fraction(1, 2)


class Small(unittest.TestCase):
    """Counts worked out by hand."""

    def test_statement(self):
        for text, count in (("a[i] = zero;", 0), ("a[i * n + 1] += b * c[2 * j - 1];", 2),
                            ("a = b - c / d;", 2), ("a[k[i + 1] * 2] = b[i] + c;", 1),
                            ("sum += half * w;", 2),
                            ("a = f(b + 3 * i) * g(c, h(d - 1));", 1),
                            ("a = b * hobe_root(c[2 * i]);", 2)):
            with self.subTest(text):
                self.assertEqual(operations(text), count)

    def test_loop_nest(self):
        n = 4
        body = (
            Do("hobe_real s[2 * n], *p = s + 1;", free=True),
            Note("a + b * c"),
            loop("i", "n",                                    # 4 times
                 Do("x[i] = y[i] * z;"),                      # 1
                 Let("m", "kind[i]"),
                 For("j", "i", "n", (                         # 4 + 3 + 2 + 1 times
                     Do("x[i] += y[j] * z;"),                 # 2
                     If("m > 0 && j > i", (Do("x[j] += z;"),)),  # 1; at i = 1: 2, at i = 3: 0
                 )),
                 If("kind[i] == 2", (loop("a", "3", Do("x[a] = x[a] + x[a];")),))),  # 3, at i = 3
            loop("k", "n * (n + 1) / 2", Do("x[0] += z;")),   # 10
        )
        arguments = "const hobe_real *y", "hobe_real *x", "hobe_real z"
        callee = Function("callee", arguments, "", body)
        square = Function("square", ("const hobe_real *a",), "", (Do("return a[0] * a[0];"),),
                          result="hobe_real")
        caller = Function("caller", arguments, "", (
            Do("callee(y, x, z);"),
            loop("i", "2", Do("callee(y, x, z);")),
            Do("x[0] += square(y + 3 * 0) + square(y + 1) * z;")))
        by_hand = 4 * 1 + 10 * 2 + (2 + 0) * 1 + 3 + 10
        above = 3 * by_hand + 3 + 2 * 1
        tables = {"n": n, "kind": [0, 1, 0, 2]}
        counter = Counter((callee, square, caller), tables)
        self.assertEqual(counter.count("callee"), by_hand)
        self.assertEqual(counter.count("caller"), above)
        machine = Machine((callee, square, caller), tables)
        x, y, z = lanes([0] * n), lanes(range(n)), lanes([2])[0]
        self.assertEqual(machine.run("caller", y, x, z), above)


class State:
    """An element with random exact coefficients, as a plan's functions see it."""

    def __init__(self, element, stations, translates=True, coupled=False):
        random = Random(1)
        self.element, self.size = element, element.sizes
        self.vectors = element.declaration.vectors
        v, normals, shears = (self.size[k] for k in ("V", "NN", "NS"))
        self.position = [int(vector.mode == 0 and not vector.slope) for vector in self.vectors]
        self.continuum = element.declaration.form == "continuum"
        names = plan.tables(element)
        if self.continuum:
            self.layout, self.sectional = tensor.layout(element), section.products(element)
            names |= {of.name: structure(columns=of.columns, pairs=len(of.pairs), **of.tables)
                      for of in (self.layout.products, self.sectional)}
            names["sign"] = [c.sign for c in self.layout.columns]
        self.machine = Machine(plan.functions(element.declaration.form), names)

        def some(count):
            return [Fraction(random.randint(-9, 9)) for _ in range(count)]

        half = some((stations + 1) // 2)
        self.wx = half + half[:stations // 2][::-1]
        values_, slopes = zip(*(self._functions(Fraction(g + 1, stations + 1))
                                for g in range(stations)))
        self.N, self.Nx = [x for row in values_ for x in row], [x for row in slopes for x in row]
        if not translates:  # the slopes of the positions' functions do not add up to zero
            self.N, self.Nx = some(v * stations), some(v * stations)
        self.Qn, self.Qs = self._symmetric(some(normals**2)), self._symmetric(some(shears**2))
        self.Qc = some(normals * shears) if coupled else None
        self.inv = structure(stations=stations, step_n=0, step_s=0, step_c=0, N=Pointer(self.N),
                             Nx=Pointer(self.Nx), wx=Pointer(self.wx), Qn=Pointer(self.Qn),
                             Qs=Pointer(self.Qs), Qc=Pointer(self.Qc) if coupled else None)
        if self.continuum:
            self.set_section(0 if coupled else products.ALONG)
        self.q0, self.u, self.h = some(3 * v), some(3 * v), some(3 * v)

    def _functions(self, xi):
        """Values and slopes of the vectors' axial functions, length 1."""
        polynomials = [self.element.axial[a].polynomial for a in self.element.axial_of]
        return tuple([sum(c * xi**n for n, c in enumerate(p)) for p in ps]
                     for ps in (polynomials, map(derivative, polynomials)))

    def set_section(self, symmetry):
        """inv.section from its definition."""
        v, a = self.size["V"], self.size["A"]
        first = [self.element.axial_of.index(i) for i in range(a)]
        weights, last = [], self.inv.stations - 1
        for g in range(self.inv.stations):
            for i in first:
                for j in first:
                    here, there = ([self.wx[at] * f[at * v + i] * h[at * v + j]
                                    for f in (self.Nx, self.N) for h in (self.Nx, self.N)]
                                   for at in (g, last - g))
                    there = [x * sign for x, sign in zip(there, (1, -1, -1, 1))]
                    both = [[(x + y) / 2 for x, y in zip(here, there)],
                            [(x - y) / 2 for x, y in zip(here, there)]]
                    weights += sum(both, []) if self.layout.mirrored else here + 4 * [0]
        self.inv.symmetry, self.inv.step = symmetry, 0
        self.inv.section = Pointer(weights + self.in_order(self.sectional, symmetry, self._split))

    def in_order(self, of, symmetry, coefficient):
        """The coefficients in the order in which the sums read them: coefficient(kind, row, pair).
        """
        found = []
        for kind, (rows, first) in enumerate((*((of.rows, of.first_row),) * 2,
                                              (of.skew_rows, of.first_skew_row))):
            for c in range(products.CLASSES):
                left = list(rows[first[c]:first[c + 1]])
                pairs = [p for m in products.MERGED[symmetry]
                         for p in of.pairs[slice(*of.first_pair[c ^ m:][:2])]
                         if kind < 2 or p[0] != p[1]]
                while left:
                    count = next(h for h in products.HEIGHTS if h <= len(left))
                    found += [coefficient(kind, row, p) for p in pairs for row in left[:count]]
                    del left[:count]
        assert len(found) == of.numbers(symmetry)
        return found

    def _split(self, kind, row, pair):
        """A coefficient of section vectors."""
        i = next(i for i in range(row, -1, -1) if i * (i + 1) // 2 <= row)
        i, j, (t, v) = i, row - i * (i + 1) // 2, pair
        if kind == 0:
            return self.law(i, j, t, v)
        first, second = self.law(i, t, j, v), self.law(i, v, j, t)
        if kind == 1:
            return first + second if t != v else first
        return (first - second) / 2

    def law(self, i, j, t, v):
        """Q of two pairs of section vectors."""
        m = self.size["M"]

        def place(i, j):
            i, j = max(i, j), min(i, j)
            if (i < m) != (j < m):
                return 1, j * (m - 1) + i - m
            i, j, start = (i, j, 0) if i < m else (i - m, j - m, self.size["NA"])
            return 0, start + i * (i + 1) // 2 + j

        (a, r), (b, c) = sorted((place(i, j), place(t, v)))
        q, columns = ((self.Qn, self.size["NN"]), (self.Qs, self.size["NS"]))[a] if a == b else (
            self.Qc, self.size["NS"])
        return q[r * columns + c] if q else Fraction(0)

    @staticmethod
    def _symmetric(entries):
        n = int(len(entries)**0.5)
        return [entries[max(r, c) * n + min(r, c)] for r in range(n) for c in range(n)]

    def at(self, t):
        return [a + t * b for a, b in zip(self.u, self.h)]

    def relative(self, q):
        """Vectors with positions from the first node's."""
        return [x - self.position[i // 3] * q[i % 3] for i, x in enumerate(q)]

    def energy(self, u):
        out = empty(1)
        self.machine.run("energy_part", self.inv, lanes(self.q0), lanes(u), out)
        return values(out)[0]

    def force(self, u):
        out = empty(3 * self.size["V"])
        self.machine.run("force_part", self.inv, lanes(self.q0), lanes(u), out)
        return values(out)

    def tangent(self, u):
        """Force, and the tangent as a full matrix."""
        v = self.size["V"]
        out, packed = empty(3 * v), empty(9 * v * (v + 1) // 2)
        self.machine.run("tangent_part", self.inv, lanes(self.q0), lanes(u), out, packed,
                         self.scratch())
        entries = values(packed)
        matrix = [[None] * (3 * v) for _ in range(3 * v)]
        for i in range(v):
            for j in range(i + 1):
                for a in range(3):
                    for b in range(3):
                        entry = entries[9 * (i * (i + 1) // 2 + j) + 3 * a + b]
                        matrix[3 * i + a][3 * j + b] = entry
                        if i != j:
                            matrix[3 * j + b][3 * i + a] = entry
        return values(out), matrix

    def scratch(self):
        if not self.continuum:
            return empty(9 * self.size["S"]**2)
        return empty(section.scratch(self.element, self.layout.sizes["BLOCKS"]))

    def trilinear(self, a, b, c):
        out = empty(3 * self.size["V"])
        self.machine.run("trilinear_part", self.inv, lanes(a), lanes(b), lanes(c), out)
        return values(out)

    def gram(self, b, c):
        """Strains and stresses of all stations."""
        m = self.size["M"]
        out = [empty(self.inv.stations * m * (2 * m - 1)) for _ in range(2)]
        self.machine.run("gram_part", self.inv, lanes(b), lanes(c), *out)
        return tuple(map(values, out))

    def defined_energy(self, u):
        """U = sum_g w_g s'Q s/2 from the definitions in kernel.h; positions from the first one."""
        m, size = self.size["M"], self.size["V"]
        total = 0
        for g in range(self.inv.stations):
            grams = []
            for q in map(self.relative, (self.q0, [a + b for a, b in zip(self.q0, u)])):
                prime, value = [[0] * 3 for _ in range(m)], [[0] * 3 for _ in range(m)]
                for v, vector in enumerate(self.vectors):
                    for a in range(3):
                        prime[vector.mode][a] += self.Nx[g * size + v] * q[3 * v + a]
                        value[vector.mode][a] += self.N[g * size + v] * q[3 * v + a]
                normal = [dot(d[i], d[j]) * (HALF if i == j else 1)
                          for d in (prime, value[1:]) for i in range(len(d)) for j in range(i + 1)]
                grams.append((normal, [dot(p, d) for p in prime for d in value[1:]]))
            n, s = ([b - a for a, b in zip(*block)] for block in zip(*grams))
            for left, right, q, factor in ((n, n, self.Qn, HALF), (s, s, self.Qs, HALF),
                                           (n, s, self.Qc, 1)):
                total += self.wx[g] * factor * sum(a * b * q[r * len(right) + c] if q else 0
                                                   for r, a in enumerate(left)
                                                   for c, b in enumerate(right))
        return total


class Products(State):
    """An element with its tensor, worked out from its definition: A_(ik)(jl) is the sum, over the
    stations and the section vectors, of their functions times Q.  Two stations about mid-length,
    and a random Q of which entries that the symmetry forbids are zero."""

    def __init__(self, element, symmetry):
        super().__init__(element, 2)
        vectors = self.size["S"]
        modes = [m.parity for m in element.modes]
        self.kinds = [(2 * y + 4 * z) & symmetry for y, z in modes + modes[1:]]
        m = self.size["M"]
        self.normal = [(i, j) for first, last in ((0, m), (m, vectors))
                       for i in range(first, last) for j in range(first, i + 1)]
        self.shear = [(i, j) for i in range(m) for j in range(m, vectors)]
        self.Qn, self.Qs = self._kept(self.Qn, self.normal), self._kept(self.Qs, self.shear)
        columns = self.layout.columns
        self.columns = [[self._column(g, c) for c in columns] for g in range(2)]
        self.rows = [[self._row(g, v) for v in range(self.size["V"])] for g in range(2)]
        numbers = self.in_order(self.layout.products, symmetry, self._coefficient)
        for name, value in (("Qn", self.Qn), ("Qs", self.Qs), ("tensor", numbers)):
            setattr(self.inv, name, Pointer(value))
        self.set_section(symmetry)

    def _kept(self, q, pairs):
        kind = [self.kinds[i] ^ self.kinds[j] for i, j in pairs]
        n = len(pairs)
        return [x if kind[i // n] == kind[i % n] else Fraction(0) for i, x in enumerate(q)]

    def _row(self, g, v):
        """What the vector v is in each section vector at station g."""
        m, k, at = self.size["M"], self.vectors[v].mode, g * self.size["V"] + v
        row = [Fraction(0)] * self.size["S"]
        row[k] = self.Nx[at]
        if k > 0:
            row[m - 1 + k] = self.N[at]
        return row

    def _column(self, g, column):
        return [column.share * (a + column.sign * b)
                for a, b in zip(self._row(g, column.left), self._row(g, column.right))]

    def _entry(self, first, second):
        """A of two pairs of vectors, each ("rows" or "columns", number)."""
        total = Fraction(0)
        for g in range(2):
            a, b, c, d = (getattr(self, kind)[g][i] for kind, i in first + second)
            for q, pairs in (self.Qn, self.normal), (self.Qs, self.shear):
                left, right = ([x[i] * y[j] + (x[j] * y[i] if i != j else 0) for i, j in pairs]
                               for x, y in ((a, b), (c, d)))
                n = len(pairs)
                total += self.wx[g] * sum(x * dot(q[r * n:r * n + n], right)
                                          for r, x in enumerate(left) if x)
        return total

    def _coefficient(self, kind, row, pair):
        i, j = next((i, row - i * (i + 1) // 2) for i in range(row, -1, -1)
                    if i * (i + 1) // 2 <= row)
        a, b = self.layout.products.mirror[i], self.layout.products.mirror[j]
        image = max(a, b) * (max(a, b) + 1) // 2 + min(a, b)
        if image < row:
            return self._coefficient(kind, image, pair)
        i, j, t, v = ("rows", i), ("rows", j), ("columns", pair[0]), ("columns", pair[1])
        if kind == 0:
            return self._entry((i, j), (t, v))
        first, second = self._entry((i, t), (j, v)), self._entry((i, v), (j, t))
        if kind == 1:
            return first + second if t != v else first
        return (first - second) / 2

    def by_tensor(self, u):
        """Force, and force and tangent, as the section-wise plan gives them."""
        v, sizes = self.size["V"], self.layout.sizes
        f, g, packed = empty(3 * v), empty(3 * v), empty(9 * v * (v + 1) // 2)
        scratch = 9 * sizes["PAIRS"] + 10 * sizes["BLOCKS"]
        q0, u = lanes(self.q0), lanes(u)
        counts = [self.machine.run("tensor_force_part", self.inv, q0, u, f, empty(scratch)),
                  self.machine.run("tensor_tangent_part", self.inv, q0, u, g, packed,
                                   empty(scratch))]
        return values(f), values(g), values(packed), counts


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def slope(f):
    """f'(0) of a polynomial of degree 4 at most, exactly."""
    return [(8 * (b - a) - (d - c)) / 12 for a, b, c, d in zip(f(-1), f(1), f(-2), f(2))]


class Exact(Case):
    """Identities of the plan in rationals: Hermite centreline, section function, two stations, of
    an element whose normal and shear block are coupled, as by curvature."""

    coupled = True

    @classmethod
    def setUpClass(cls):
        cls.state = State(shipped()["BE24w"], stations=2, coupled=cls.coupled)

    def test_energy(self):
        """Equal to its definition, and formed from relative positions: a translation changes
        nothing even where the axial functions, as if rounded, do not add up."""
        state = State(self.state.element, stations=2, translates=False, coupled=self.coupled)
        self.assertEqual(state.energy(state.u), state.defined_energy(state.u))
        self.assertEqual(state.energy([Fraction(0)] * len(state.u)), 0)
        moved = [x + 1000 * state.position[i // 3] for i, x in enumerate(state.u)]
        self.assertEqual(state.energy(moved), state.energy(state.u))

    def test_force(self):
        """The slope of the energy."""
        state = self.state
        wanted, = slope(lambda t: [state.energy(state.at(t))])
        self.assertEqual(dot(state.force(state.u), state.h), wanted)
        self.assertNotEqual(wanted, 0)

    def test_tangent(self):
        """The slope of the force, which comes with it unchanged; symmetric diagonal blocks."""
        state = self.state
        force, matrix = state.tangent(state.u)
        self.assertEqual(force, state.force(state.u))
        self.assertEqual([dot(row, state.h) for row in matrix],
                         slope(lambda t: state.force(state.at(t))))
        self.assertEqual(matrix, [list(column) for column in zip(*matrix)])

    def test_trilinear(self):
        """Linear in each argument, symmetric in the last two, and the force when made so."""
        state = self.state
        q = [a + b for a, b in zip(state.q0, state.u)]
        force = [a - b for a, b in zip(state.trilinear(q, q, q),
                                       state.trilinear(q, state.q0, state.q0))]
        self.assertEqual(force, state.force(state.u))
        f = state.trilinear(state.u, state.q0, state.h)
        self.assertEqual(f, state.trilinear(state.u, state.h, state.q0))
        tripled = [3 * x for x in state.u]
        self.assertEqual(state.trilinear(tripled, state.q0, state.h), [3 * x for x in f])
        self.assertEqual(state.trilinear(state.q0, tripled, state.h),
                         [3 * x for x in state.trilinear(state.q0, state.u, state.h)])

    def test_gram(self):
        """Strains by stresses are the trilinear form, and the energy."""
        state = self.state
        strain, _ = state.gram(state.u, state.q0)
        _, stress = state.gram(state.h, state.u)
        self.assertEqual(2 * dot(strain, stress),
                         dot(state.trilinear(state.u, state.h, state.u), state.q0))
        strain, stress = state.gram([2 * a + b for a, b in zip(state.q0, state.u)], state.u)
        self.assertEqual(dot(strain, stress) / 2, state.energy(state.u))


class Uncoupled(Exact):
    """The same of an element that is straight and prismatic."""

    coupled = False


class Tensor(Case):
    """The plan "tensor" is the plan over stations, in rationals, and its counts are those of an
    execution."""

    def check(self, element, symmetries=(1, 3, 5, 7)):
        for symmetry in symmetries:
            with self.subTest(element.declaration.name, symmetry=symmetry):
                state = Products(element, symmetry)
                v = state.size["V"]
                force, packed = empty(3 * v), empty(9 * v * (v + 1) // 2)
                state.machine.run("tangent_part", state.inv, lanes(state.q0), lanes(state.u), force,
                                  packed, state.scratch())
                *found, counts = state.by_tensor(state.u)
                self.assertEqual(found, [values(force), values(force), values(packed)])
                printed = plan.build(element).by_symmetry[symmetry]
                self.assertEqual(counts, [printed["tensor_force_part"],
                                          printed["tensor_tangent_part"]])

    def test_shipped(self):
        """Three positions; two, with slopes and a section function."""
        elements = shipped()
        self.check(elements["3333"])
        self.check(elements["BE24w"], symmetries=(7,))

    def test_no_mirror(self):
        """Nodes that have no mirror image: columns are the vectors themselves."""
        text = HEAD.replace('"0", "1"', '"0", "1/3", "1"') + PLANE.replace(
            '2 = ["value"]', '2 = ["value"], 3 = ["value"]')
        element = self.element(text)
        self.assertFalse(tensor.layout(element).mirrored)
        self.check(element, symmetries=(7,))

    def test_sizes(self):
        """Each symmetry leaves about half the numbers, and so does a mirror image."""
        layout = tensor.layout(shipped()["MGD30w"])
        numbers = [layout.products.numbers(s) for s in products.SYMMETRIES]
        self.assertEqual(numbers[3], numbers[5])
        for more, less in (numbers[1], numbers[3]), (numbers[3], numbers[7]):
            self.assertTrue(1.8 < more / less < 2.2, numbers)


class Counted(Case):
    """The counts printed are those of an execution."""

    def check(self, element):
        state = State(element, element.stations)
        v = state.size["V"]
        q, u, f = lanes(state.q0), lanes(state.u), empty(3 * v)
        packed, scratch = empty(9 * v * (v + 1) // 2), state.scratch()
        counts = [state.machine.run("force_part", state.inv, q, u, f),
                  state.machine.run("tangent_part", state.inv, q, u, f, packed, scratch),
                  state.machine.run("energy_part", state.inv, q, u, empty(1))]
        text = c_text(element)
        printed = re.search(r"operations per element: force (\d+), force and tangent (\d+), "
                            r"energy (\d+)\n", text)
        self.assertEqual([int(c) for c in printed.groups()], counts)
        self.assertIn(f".flops_force = {counts[0]},", text)
        self.assertIn(f".flops_tangent = {counts[1]},", text)

    def test_shipped(self):
        elements = shipped()
        for name in ("BE24", "3333", "3333s", "MGD30w"):
            with self.subTest(name):
                self.check(elements[name])

    def test_new(self):
        self.check(self.element(HEAD + PLANE + '[[field]]\nmodes = ["w", "yz"]\nlike = "y"\n'))


class AxisRule(unittest.TestCase):
    """The structural form's points: Gauss' and Lobatto's rule, and what the two make of a mass."""

    def test_degrees(self):
        for p in range(1, 6):
            rule = structural.axis_rule(p)
            gauss, lobatto = rule[:p], rule[p:]
            both = [(x, w * (p + 1) / (2 * p + 1)) for x, w in gauss]
            both += [(x, w * p / (2 * p + 1)) for x, w in lobatto]
            self.assertEqual([len(gauss), len(lobatto)], [p, p + 1])
            self.assertEqual([lobatto[0][0], lobatto[-1][0]], [0, 1])
            for points, degree in (gauss, 2 * p - 1), (lobatto, 2 * p - 1), (both, 2 * p + 1):
                for n in range(degree + 2):
                    error = abs(sum(w * x**n for x, w in points) - 1 / (n + 1))
                    self.assertEqual(error < 1e-15, n <= degree, (p, degree, n))  # round-off


if __name__ == "__main__":
    unittest.main()
