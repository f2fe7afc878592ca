# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 1: read a declaration and explain what is refused (file, field, value, reason).

A declaration is a TOML file (see elements/README.md):

    name, source          strings
    nodes                 node positions xi in [0, 1], exact rationals as strings
    extends               another element, whose nodes and fields come first
    form                  of the elastic force: "continuum" (default), the strain at each point of
                          the section; "structural", a rod whose section can stretch and shear
    mechanics             default elastic law: "average" (default), "axis" or "full"; the form
                          "structural" has a law of its own
    [[field]]             modes that share axial functions
        modes             "1", monomials like "y", "yz", "yyy", or section functions like "w", "v1y"
        dofs              { node = ["value", "slope"], ... }, nodes counted from 1; or
        like              a mode declared before, whose dofs (and functions) are taken
        functions         optional polynomials in xi, one per dof, in place of the derived ones
"""

import difflib
import hashlib
import json
import pathlib
import re
import tomllib
from dataclasses import dataclass
from fractions import Fraction

FORMS = ("continuum", "structural")
MECHANICS = ("average", "axis", "full")
KINDS = ("value", "slope")
KEYS = ("name", "source", "nodes", "extends", "form", "mechanics", "field")
FIELD_KEYS = ("modes", "dofs", "like", "functions")
MONOMIAL = re.compile(r"(?=.)y*z*")
FUNCTION = re.compile(r"[vw][a-z0-9]*")
MAX_FUNCTIONS, MAX_MODES, MAX_VECTORS = 16, 24, 256  # HOBE_MAX_... of kernel.h
MAX_DEGREE = 12  # of a monomial


class DeclarationError(Exception):
    """A refused declaration: one sentence with file, field, value and reason."""


@dataclass(frozen=True)
class Dof:
    """A functional of d_k: its value or slope (d/dx) at a node."""

    node: int
    slope: bool


@dataclass(frozen=True)
class Field:
    """Modes that share the axial functions of `dofs`; functions: explicit polynomials or None."""

    modes: tuple
    dofs: tuple
    functions: tuple | None


@dataclass(frozen=True)
class Vector:
    """A nodal vector: mode k's value or slope at a node, and its place among its field's dofs."""

    node: int
    mode: int
    slope: bool
    field: int
    place: int

    @property
    def is_position(self):
        """Positions of the centreline lose the first node's: only their differences matter."""
        return self.mode == 0 and not self.slope


@dataclass(frozen=True)
class Declaration:
    path: str
    name: str
    source: str
    form: str
    mechanics: str
    nodes: tuple  # Fractions, ascending, from 0 to 1
    fields: tuple
    hash: str

    @property
    def modes(self):
        return tuple(m for f in self.fields for m in f.modes)

    @property
    def functions(self):
        return tuple(m for m in self.modes if FUNCTION.fullmatch(m))

    @property
    def vectors(self):
        """The nodal vectors node by node, mode by mode, value before slope."""
        found = []
        for node in range(len(self.nodes)):
            mode = 0
            for f, field in enumerate(self.fields):
                for k in range(len(field.modes)):
                    found += [Vector(node, mode + k, d.slope, f, p)
                              for p, d in enumerate(field.dofs) if d.node == node]
                mode += len(field.modes)
        return tuple(found)


def read(paths):
    """All declarations of the given files, in the order of the files."""
    raw = {}
    for path in paths:
        table = _load(path)
        if table["name"] in raw:
            _refuse(path, "name", table["name"], f"already declared in {raw[table['name']][0]}")
        raw[table["name"]] = (path, table)
    return [_declaration(name, raw) for name in raw]


def _refuse(path, field, value, reason):
    raise DeclarationError(f"{path}: {field} = {value!r}: {reason}")


def _load(path):
    try:
        with open(path, "rb") as stream:
            table = tomllib.load(stream)
    except OSError as error:
        raise DeclarationError(f"{path}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise DeclarationError(f"{path}: not TOML: {error}") from None
    _known_keys(path, "", table, KEYS)
    name = table.get("name")
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9-]*", name):
        _refuse(path, "name", name, "must be letters, digits and -")
    if name != pathlib.Path(path).stem or name == "registry":
        _refuse(path, "name", name, "the file must be called after the element, NAME.toml, and "
                                    "not registry.toml")
    return table


def _known_keys(path, where, table, known):
    for key in table:
        if key not in known:
            near = difflib.get_close_matches(key, known, 1)
            hint = f"; did you mean {near[0]!r}?" if near else ""
            _refuse(path, where + key, table[key],
                    f"unknown key, known are {', '.join(known)}{hint}")


def _declaration(name, raw):
    path, table = raw[name]
    nodes, fields, form, mechanics, trail = _inherit(name, raw, ())
    source = table.get("source", "")
    if (not isinstance(source, str) or not source.isprintable()
            or any(mark in source for mark in ('"', "\\", "/*", "*/"))):
        _refuse(path, "source", source,
                "must be one line of text without quotes, backslashes and comment marks")
    digest = hashlib.sha256(json.dumps(trail, sort_keys=True).encode()).hexdigest()[:16]
    law = form if form == "structural" else mechanics
    declaration = Declaration(path, name, source, form, law, nodes, fields, digest)
    _check_modes(path, declaration)
    _check_continuity(path, declaration)
    return declaration


def _inherit(name, raw, below):
    """Nodes, fields, form and mechanics of an element after those of the elements it extends."""
    path, table = raw[name]
    if name in below:
        _refuse(path, "extends", name, "an element cannot extend itself")
    nodes, fields, form, mechanics, trail = (), (), FORMS[0], MECHANICS[0], []
    if (base := table.get("extends")) is not None:
        if not isinstance(base, str) or base not in raw:
            _refuse(path, "extends", base, f"no such element; known are {', '.join(sorted(raw))}")
        nodes, fields, form, mechanics, trail = _inherit(base, raw, below + (name,))
    if "nodes" in table:
        if nodes:
            _refuse(path, "nodes", table["nodes"], f"nodes are those of {table['extends']}")
        nodes = _nodes(path, table["nodes"])
    if not nodes:
        _refuse(path, "nodes", None, "missing: give node positions or extend an element")
    form = table.get("form", form)
    if form not in FORMS:
        _refuse(path, "form", form, f"must be one of {', '.join(FORMS)}")
    if form == "structural" and "mechanics" in table:
        _refuse(path, "mechanics", table["mechanics"],
                "the form \"structural\" has a law of its own: leave mechanics out")
    mechanics = table.get("mechanics", mechanics)
    if mechanics not in MECHANICS:
        _refuse(path, "mechanics", mechanics, f"must be one of {', '.join(MECHANICS)}")
    declared = table.get("field", [])
    if not isinstance(declared, list) or not all(isinstance(f, dict) for f in declared):
        _refuse(path, "field", declared, "write each field as a [[field]] table")
    for number, field in enumerate(declared, 1):
        fields += (_field(path, f"field {number}: ", field, nodes, fields),)
    return nodes, fields, form, mechanics, trail + [table]


def _nodes(path, texts):
    try:
        if not isinstance(texts, list) or not all(isinstance(t, str) for t in texts):
            raise TypeError(texts)
        nodes = tuple(Fraction(t) for t in texts)
    except (TypeError, ValueError, ZeroDivisionError):
        _refuse(path, "nodes", texts, 'must be rationals like ["0", "1/2", "1"]')
    ascending = all(a < b for a, b in zip(nodes, nodes[1:]))
    if len(nodes) < 2 or nodes[0] != 0 or nodes[-1] != 1 or not ascending:
        _refuse(path, "nodes", texts, "must ascend from 0 to 1")
    return nodes


def _field(path, where, table, nodes, before):
    _known_keys(path, where, table, FIELD_KEYS)
    modes = table.get("modes")
    if not isinstance(modes, list) or not modes or not all(isinstance(m, str) for m in modes):
        _refuse(path, where + "modes", modes, 'must be a list of modes like ["y", "z"]')
    if ("like" in table) == ("dofs" in table):
        _refuse(path, where + "modes", modes, "a field has either dofs or like")
    if "like" in table and "functions" in table:
        _refuse(path, where + "functions", table["functions"],
                f"come with those of {table['like']!r}")
    if "like" in table:
        for field in before:
            if table["like"] in field.modes:
                return Field(tuple(modes), field.dofs, field.functions)
        known = ", ".join(m for f in before for m in f.modes)
        _refuse(path, where + "like", table["like"], f"no such mode before; known are {known}")
    dofs = _dofs(path, where, table["dofs"], nodes)
    functions = table.get("functions")
    if functions is not None:
        if (not isinstance(functions, list) or len(functions) != len(dofs)
                or not all(isinstance(f, str) for f in functions)):
            _refuse(path, where + "functions", functions,
                    f"must be {len(dofs)} polynomials in xi, one per dof")
        functions = tuple(functions)
    return Field(tuple(modes), dofs, functions)


def _dofs(path, where, table, nodes):
    dofs = []
    if not isinstance(table, dict) or not table:
        _refuse(path, where + "dofs", table, 'must be like { 1 = ["value"], 2 = ["value"] }')
    for node in table:
        if node not in map(str, range(1, len(nodes) + 1)):
            _refuse(path, where + "dofs", node, f"nodes are counted from 1 to {len(nodes)}")
        kinds = table[node]
        if not isinstance(kinds, list) or not kinds or any(k not in KINDS for k in kinds):
            _refuse(path, where + f"dofs.{node}", kinds, "must be a list of value and slope")
        if len(set(kinds)) < len(kinds):
            _refuse(path, where + f"dofs.{node}", kinds, "names a functional twice")
        dofs += [Dof(int(node) - 1, k == "slope") for k in kinds]
    return tuple(sorted(dofs, key=lambda d: (d.node, d.slope)))


def _check_modes(path, declaration):
    modes = declaration.modes
    if modes[:3] != ("1", "y", "z"):
        _refuse(path, "modes", list(modes), 'the first three modes must be "1", "y", "z"')
    if declaration.form == "structural" and len(modes) > 3:
        _refuse(path, "modes", list(modes), "the form \"structural\" has the modes 1, y, z only")
    for mode in modes:
        if mode != "1" and not MONOMIAL.fullmatch(mode) and not FUNCTION.fullmatch(mode):
            _refuse(path, "modes", mode,
                    'must be "1", a monomial like "yyz" (y before z) or a section function "w..." '
                    'or "v..."')
        if MONOMIAL.fullmatch(mode) and len(mode) > MAX_DEGREE:
            _refuse(path, "modes", mode, f"monomials go to degree {MAX_DEGREE}")
        if modes.count(mode) > 1:
            _refuse(path, "modes", mode, "declared twice")
    if len(modes) > MAX_MODES or len(declaration.functions) > MAX_FUNCTIONS:
        _refuse(path, "modes", list(modes),
                f"at most {MAX_MODES} modes and {MAX_FUNCTIONS} section functions")
    if len(declaration.vectors) > MAX_VECTORS:
        _refuse(path, "nodes", [str(x) for x in declaration.nodes],
                f"{len(declaration.vectors)} nodal vectors, at most {MAX_VECTORS}")


def _check_continuity(path, declaration):
    """Elements meet at their end nodes: both must carry the same vectors, a value of each mode."""
    last = len(declaration.nodes) - 1
    for field in declaration.fields:
        kinds = [tuple(d.slope for d in field.dofs if d.node == n) for n in (0, last)]
        if kinds[0] != kinds[1] or False not in kinds[0]:
            ends = [[KINDS[s] for s in k] for k in kinds]
            _refuse(path, f"dofs of {', '.join(field.modes)} at the ends", ends,
                    "both end nodes must carry the same functionals, the value among them")
