# SPDX-License-Identifier: GPL-3.0-or-later
"""Declarations: what they mean, and how bad ones are refused."""

import re
import unittest

from declare import HEAD, LINEAR, PLANE, SMALL, SOURCE, Case, run, files
from generator import declaration, emit

THREE = ('name = "T"\nnodes = ["0", "1/2", "1"]\n[[field]]\nmodes = ["1", "y", "z"]\n'
         'dofs = { 1 = ["value"], 2 = ["value"], 3 = ["value"] }\n')


def more(field):
    return f"{SMALL}[[field]]\n{field}\n"


def explicit(*functions):
    """The smallest declaration with functions of its own."""
    return f"{SMALL}functions = [{', '.join(f'{chr(34)}{f}{chr(34)}' for f in functions)}]\n"


# 11 nodes and 24 modes.
MONOMIALS = [y * "y" + (n - y) * "z" for n in range(2, 7) for y in range(n, -1, -1)]
MANY = (f'name = "T"\nnodes = {[f"{i}/10" for i in range(11)]}\n[[field]]\n'
        f'modes = {["1", "y", "z", *MONOMIALS[:21]]}\n'
        f'dofs = {{ {", ".join(f"""{i} = ["value"]""" for i in range(1, 12))} }}\n')

# What is wrong: declaration, field, value and reason as the sentence must show them.
REFUSED = {
    "not TOML": ("name = ", "", "", "not TOML"),
    "unknown key": ('mode = "axis"\n' + SMALL, "mode", "'axis'", "unknown key"),
    "unknown key, near one": ("node = []\n" + SMALL, "node", "[]", "did you mean 'nodes'?"),
    "unknown key of a field": (more('modes = ["w"]\nlyke = "y"'), "field 2: lyke", "'y'",
                               "did you mean 'like'?"),
    "no name": (PLANE, "name", "None", "must be"),
    "name not text": ("name = 3\n" + PLANE, "name", "3", "must be"),
    "name with a blank": ('name = "a b"\n' + PLANE, "name", "'a b'", "letters, digits"),
    "name that C cannot tell from another": ('name = "T_2"\n' + PLANE, "name", "'T_2'",
                                             "letters, digits"),
    "name of the table of elements": (SMALL.replace('"T"', '"registry"'), "name", "'registry'",
                                      "registry.toml"),
    "source of two lines": ('source = "a\\nb"\n' + SMALL, "source", r"'a\nb'", "one line"),
    "source that ends a string": ("source = 'a\", \"'\n" + SMALL, "source", "'a\", \"'", "quotes"),
    "source that ends a comment": ('source = "*/ int x; /*"\n' + SMALL, "source",
                                   "'*/ int x; /*'", "comment"),
    "source not text": ("source = 1\n" + SMALL, "source", "1", "one line of text"),
    "no nodes": ('name = "T"\n' + PLANE, "nodes", "None", "missing"),
    "nodes not numbers": (SMALL.replace('"0"', '"O"'), "nodes", "['O', '1']", "rationals"),
    "nodes rounded": (SMALL.replace('"0", "1"', "0.0, 0.3, 1.0"), "nodes", "[0.0, 0.3, 1.0]",
                      "rationals"),
    "node at infinity": (SMALL.replace('"0", "1"', "0, inf"), "nodes", "[0, inf]", "rationals"),
    "nodes not a list": (SMALL.replace('["0", "1"]', '"01"'), "nodes", "'01'", "rationals"),
    "node without denominator": (SMALL.replace('"1"]', '"1/0"]', 1), "nodes", "['0', '1/0']",
                                 "rationals"),
    "one node": (SMALL.replace('"0", "1"', '"0"'), "nodes", "['0']", "ascend from 0 to 1"),
    "nodes descend": (THREE.replace('"1/2", "1"', '"1", "1/2"'), "nodes", "['0', '1', '1/2']",
                      "ascend from 0 to 1"),
    "node twice": (THREE.replace('"1/2"', '"0"'), "nodes", "['0', '0', '1']", "ascend"),
    "nodes up to 2": (SMALL.replace('"1"]', '"2"]', 1), "nodes", "['0', '2']", "from 0 to 1"),
    "unknown mechanics": ('mechanics = "mean"\n' + SMALL, "mechanics", "'mean'",
                          "one of average, axis, full"),
    "unknown form": ('form = "rod"\n' + SMALL, "form", "'rod'", "one of continuum, structural"),
    "law of the structural form": ('form = "structural"\nmechanics = "axis"\n' + SMALL, "mechanics",
                                   "'axis'", "a law of its own"),
    "modes of the structural form": ('form = "structural"\n' + more('modes = ["w"]\nlike = "y"'),
                                     "modes", "['1', 'y', 'z', 'w']", "1, y, z only"),
    "extends an unknown element": ('name = "T"\nextends = "BE25"\n', "extends", "'BE25'",
                                   "no such element"),
    "extends a list": ('name = "T"\nextends = ["BE24"]\n', "extends", "['BE24']",
                       "no such element"),
    "extends itself": ('name = "T"\nextends = "T"\n', "extends", "'T'", "cannot extend itself"),
    "fields not tables": (HEAD + "field = [1]\n", "field", "[1]", "[[field]]"),
    "field not repeated": (HEAD + '[field]\nmodes = ["1"]\n', "field", "{'modes': ['1']}",
                           "[[field]]"),
    "no modes": (more('like = "y"'), "field 2: modes", "None", "list of modes"),
    "modes not a list": (more('modes = "w"\nlike = "y"'), "field 2: modes", "'w'", "list of modes"),
    "no fields": (HEAD, "modes", "[]", 'must be "1", "y", "z"'),
    "modes in another order": (SMALL.replace('"y", "z"', '"z", "y"'), "modes", "['1', 'z', 'y']",
                               'must be "1", "y", "z"'),
    "no 1": (SMALL.replace('"1", "y"', '"y"'), "modes", "['y', 'z']", 'must be "1", "y", "z"'),
    "z before y": (more('modes = ["zy"]\nlike = "y"'), "modes", "'zy'", "y before z"),
    "not a mode": (more('modes = ["x"]\nlike = "y"'), "modes", "'x'", "monomial"),
    "mode with a line break": (more('modes = ["w\\n"]\nlike = "y"'), "modes", r"'w\n'", "monomial"),
    "empty mode": (more('modes = [""]\nlike = "y"'), "modes", "''", "monomial"),
    "mode twice": (more('modes = ["yy", "w", "yy"]\nlike = "y"'), "modes", "'yy'",
                   "declared twice"),
    "too high a monomial": (more(f'modes = ["{"y" * 2000}"]\nlike = "y"'), "modes", "yyy",
                            "to degree"),
    "too many section functions": (more(f'modes = {[f"w{i}" for i in range(17)]}\nlike = "y"'),
                                   "modes", "'w16'", "at most 24 modes and 16 section functions"),
    "neither dofs nor like": (more('modes = ["w"]'), "field 2: modes", "['w']",
                              "either dofs or like"),
    "both dofs and like": (more(f'modes = ["w"]\nlike = "y"\ndofs = {LINEAR}'), "field 2: modes",
                           "['w']", "either dofs or like"),
    "both functions and like": (more('modes = ["w"]\nlike = "y"\nfunctions = ["1", "2"]'),
                                "field 2: functions", "['1', '2']", "come with those of 'y'"),
    "like an unknown mode": (more('modes = ["w"]\nlike = "yy"'), "field 2: like", "'yy'",
                             "no such mode before; known are 1, y, z"),
    "like itself": (more('modes = ["w"]\nlike = "w"'), "field 2: like", "'w'",
                    "no such mode before"),
    "dofs not a table": (SMALL.replace(LINEAR, "[1, 2]"), "field 1: dofs", "[1, 2]",
                         "must be like"),
    "node that is not there": (SMALL.replace("2 =", "3 ="), "field 1: dofs", "'3'",
                               "counted from 1 to 2"),
    "node 0": (SMALL.replace("1 =", "0 ="), "field 1: dofs", "'0'", "counted from 1 to 2"),
    "node written twice": (SMALL.replace("{ 1", '{ 01 = ["value"], 1'), "field 1: dofs", "'01'",
                           "counted from 1 to 2"),
    "unknown functional": (SMALL.replace('2 = ["value"]', '2 = ["curvature"]'), "field 1: dofs.2",
                           "['curvature']", "value and slope"),
    "functional twice": (SMALL.replace('2 = ["value"]', '2 = ["value", "value"]'),
                         "field 1: dofs.2", "['value', 'value']", "twice"),
    "no value at an end": (THREE.replace('1 = ["value"], ', ""), "dofs", "[[], ['value']]",
                           "both end nodes"),
    "slope at one end": (SMALL.replace('1 = ["value"]', '1 = ["value", "slope"]'), "dofs",
                         "['value', 'slope']", "both end nodes"),
    "slopes only": (SMALL.replace("value", "slope"), "dofs", "['slope']", "the value among them"),
    "slope without value": (THREE.replace('2 = ["value"]', '2 = ["slope"]'), "functions", "3",
                            "do not determine a polynomial of degree 2"),
    "too many vectors": (MANY, "nodes", "'1/10'", "264 nodal vectors, at most 256"),
    "functions not a list": (SMALL + 'functions = "xi"\n', "field 1: functions", "'xi'",
                             "2 polynomials"),
    "too few functions": (explicit("xi"), "field 1: functions", "['xi']", "2 polynomials"),
    "functions not text": (SMALL + "functions = [0, 1]\n", "field 1: functions", "[0, 1]",
                           "2 polynomials"),
    "not 1 at its own node": (explicit("1 - xi", "2*xi"), "functions", "2", "must be 1 (Kronecker"),
    "not 0 at the other node": (explicit("1 - xi/2", "xi"), "functions", "1/2",
                                "must be 0 (Kronecker"),
    "no constants": (explicit("1 - xi**2", "xi"), "functions", "", "partition of unity"),
    "no linear centreline": (explicit("1 - xi**2", "xi**2"), "functions", "", "linear field"),
}

# Not polynomials in xi with rational coefficients.  Some would run code if evaluated as Python.
NOT_POLYNOMIALS = (
    "__import__('os').system('true')", "xi.__class__", "(lambda: xi)()", "[xi for x in (1,)][0]",
    "f(xi)", "xi(2)", "2(xi)", "print", "x", "xixi", "xi2", "l*xi", "E", "sin(xi)", "Abs(xi)", "oo",
    "1/xi", "xi**-1", "xi**(1/2)", "2**(1/2)", "xi**xi", "2**xi", "(-1)**(1/2)", "xi/0", "1/0",
    "0/0", "0**-1", "7//2 + xi", "7 % 2", "xi if xi else 1", "xi and 1", "xi == 1", "0.5*xi", "1e5",
    "True", "'xi'", "(xi", "xi)", "()", "(xi,)", "", " ", "*", "1 -", "1 2", "xi xi", "01",
    "xi\\n1", "xi = 1", "((9**15)**15)**15*xi", "-" * 5000 + "xi", "(" * 5000 + "xi" + ")" * 5000,
    "9**9**9**9", "xi**99999999", "9" * 5000)

# A polynomial of degree 1, but with a coefficient of 40 million digits.
BOMB = "((((((((9**9)**9)**9)**9)**9)**9)**9)**9)*xi"


class Refusals(Case):
    def test_sentences(self):
        for what, (text, field, value, reason) in REFUSED.items():
            with self.subTest(what):
                message = self.refusal(text)
                path = self.file(text)
                self.assertTrue(message.startswith(f"{path}: {field}"), message)
                self.assertIn(value, message.removeprefix(path))
                self.assertIn(reason, message)
                self.assertNotIn("\n", message)

    def test_cycle(self):
        ring = ['name = "A"\nextends = "B"\n', 'name = "B"\nextends = "C"\n',
                'name = "C"\nextends = "A"\n']
        self.assertIn("cannot extend itself", self.refusal(*ring))

    def test_nodes_of_an_extension(self):
        message = self.refusal(SMALL, 'name = "U"\nextends = "T"\nnodes = ["0", "1"]\n')
        self.assertRegex(message, r"U\.toml: nodes = \['0', '1'\]: nodes are those of T")

    def test_same_name(self):
        other = self.folder / "other"
        other.mkdir()
        (other / "T.toml").write_text(SMALL)
        with self.assertRaisesRegex(declaration.DeclarationError, "name = 'T': already declared"):
            declaration.read([self.file(SMALL), str(other / "T.toml")])

    def test_file_of_another_name(self):
        path = self.folder / "other.toml"
        path.write_text(SMALL)
        with self.assertRaisesRegex(declaration.DeclarationError, "other.toml: name = 'T'"):
            declaration.read([str(path)])

    def test_no_file(self):
        with self.assertRaisesRegex(declaration.DeclarationError, "no.toml: No such file"):
            declaration.read(["no.toml"])

    def test_not_text(self):
        path = self.folder / "T.toml"
        path.write_bytes(b'name = "\xff"\n')
        with self.assertRaisesRegex(declaration.DeclarationError, "T.toml: not TOML"):
            declaration.read([str(path)])

    def test_not_polynomials(self):
        for text in NOT_POLYNOMIALS:
            with self.subTest(text[:40]):
                message = self.refusal(explicit("1 - xi", text))
                shown = text.replace("\\n", "\n")[:60]
                self.assertRegex(message, "^[^\n]*T.toml: functions of 1, y, z[^\n]*$")
                self.assertIn(f"{shown!r}", message)
                self.assertIn("not a polynomial in xi", message)

    def test_no_code_runs(self):
        """Not even code that ends in a polynomial."""
        trace = self.folder / "trace"
        for call in (f"open('{trace}', 'w').close() or xi", f"xi if open('{trace}', 'w') else xi",
                     f"xi + 0*len([open('{trace}', 'w')])"):
            with self.subTest(call):
                self.assertIn("not a polynomial", self.refusal(explicit("1 - xi", call)))
                self.assertFalse(trace.exists())

    def test_bomb(self):
        """Refused at once; the limit is generous, since most of a run is Python's start."""
        result = run("--out", self.folder / "out", self.file(explicit("1 - xi", BOMB)), seconds=20)
        self.assertRegex(result.stderr, "^generator: [^\n]*not a polynomial[^\n]*\n$")

    def test_command(self):
        """One sentence on standard error, status 1, no file."""
        out = self.folder / "out"
        result = run("--out", out, self.file(SMALL), self.file(SMALL.replace('"T"', '"U V"')))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^generator: .*U V\.toml: name = 'U V': [^\n]*\n$")
        self.assertFalse(out.exists())

    def test_only(self):
        result = run("--out", self.folder / "out", self.file(SMALL), "--only", "U")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"--only U: no such element; known are T\n$")


class Meaning(Case):
    def test_small(self):
        item, = self.read(SMALL)
        self.assertEqual((item.name, item.mechanics, item.modes), ("T", "average", ("1", "y", "z")))
        self.assertEqual(len(item.vectors), 6)

    def test_extension(self):
        base = 'mechanics = "axis"\n' + SMALL
        item = self.read(base, 'name = "U"\nextends = "T"\n[[field]]\nmodes = ["w"]\nlike = "z"\n',
                         'name = "V"\nextends = "U"\nmechanics = "full"\n')
        self.assertEqual([i.modes[3:] for i in item], [(), ("w",), ("w",)])
        self.assertEqual([i.mechanics for i in item], ["axis", "axis", "full"])
        self.assertEqual(item[1].functions, ("w",))

    def test_form(self):
        item = self.read('mechanics = "axis"\n' + SMALL,
                         'name = "U"\nextends = "T"\nform = "structural"\n',
                         'name = "V"\nextends = "U"\n',
                         'name = "W"\nextends = "V"\nform = "continuum"\n')
        self.assertEqual([(i.form, i.mechanics) for i in item],
                         [("continuum", "axis"), ("structural", "structural"),
                          ("structural", "structural"), ("continuum", "axis")])

    def test_base_declared_later(self):
        self.assertEqual(self.read('name = "U"\nextends = "T"\n', SMALL)[0].modes, ("1", "y", "z"))

    def test_vectors_follow_modes_not_dofs(self):
        """Node by node, mode by mode, value before slope, however the dofs are written."""
        text = (HEAD + '[[field]]\nmodes = ["1", "y"]\n'
                'dofs = { 2 = ["slope", "value"], 1 = ["slope", "value"] }\n'
                f'[[field]]\nmodes = ["z"]\ndofs = {LINEAR}\n')
        vectors = [(v.node, v.mode, v.slope) for v in self.read(text)[0].vectors]
        self.assertEqual(vectors, [(n, m, s) for n in (0, 1)
                                   for m, s in ((0, 0), (0, 1), (1, 0), (1, 1), (2, 0))])

    def test_like_takes_functions(self):
        bubble = '"1 - xi + xi*(1 - xi)", "xi - xi*(1 - xi)"'
        text = (SMALL + f'[[field]]\nmodes = ["yy"]\ndofs = {LINEAR}\nfunctions = [{bubble}]\n'
                '[[field]]\nmodes = ["zz"]\nlike = "yy"\n')
        element = self.element(text)
        self.assertEqual(element.axial_of, (0, 0, 0, 1, 1, 2, 2, 2, 3, 3))
        self.assertEqual(element.axial[1].polynomial, (1, 0, -1))

    def test_hash(self):
        """Follows all that is declared, the bases included, and nothing else."""
        def digest(*texts):
            return self.read(*texts)[-1].hash

        child = 'name = "U"\nextends = "T"\n'
        self.assertEqual(digest(SMALL), digest("# remark\n" + SMALL.replace(" = ", "   = ")))
        self.assertNotEqual(digest(SMALL), digest('mechanics = "axis"\n' + SMALL))
        self.assertNotEqual(digest(SMALL, child), digest('mechanics = "axis"\n' + SMALL, child))
        self.assertRegex(digest(SMALL), "^[0-9a-f]{16}$")

    def test_limits_are_those_of_the_abi(self):
        header = (SOURCE / "runtime/kernel.h").read_text()
        defined = dict(re.findall(r"(HOBE_\w+) (?:= )?(\d+)", header))
        self.assertEqual(int(defined["HOBE_KERNEL_ABI"]), emit.ABI)
        self.assertEqual(int(defined["HOBE_MAX_FUNCTIONS"]), declaration.MAX_FUNCTIONS)
        self.assertEqual(int(defined["HOBE_MAX_MODES"]), declaration.MAX_MODES)
        self.assertEqual(int(defined["HOBE_MAX_VECTORS"]), declaration.MAX_VECTORS)

    def test_command(self):
        out = self.folder / "out"
        child = 'name = "U-2"\nextends = "T"\n[[field]]\nmodes = ["w"]\nlike = "y"\n'
        result = run("--out", out, self.file(SMALL), self.file(child), "--only", "U-2")
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        self.assertEqual(list(files(out)), ["U_2.c", "registry.c"])
        for stage in ("declaration", "shape functions", "invariants", "contraction plan", "C"):
            self.assertRegex(result.stderr, rf"generator: .*{stage}.* \d+\.\d+ s\n")


if __name__ == "__main__":
    unittest.main()
