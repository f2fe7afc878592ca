# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the generator's loop nests in exact arithmetic (but for square roots) and counts what is
executed.

A lane is a number that counts each operation on it; indices and the doubles that all lanes share
are plain numbers, which do not count.  Local arrays start empty, so that reading what was never
written fails.
"""

import math
import operator
import re
from fractions import Fraction
from types import SimpleNamespace

from generator.ir import FUNCTIONS, Do, For, If, Let, Note, python


class Lane:
    """A number of the kind hobe_real."""

    operations = 0

    def __init__(self, value):
        self.value = value

    @staticmethod
    def _counted(operation):
        def apply(self, other):
            Lane.operations += 1
            return Lane(operation(self.value, getattr(other, "value", other)))
        return apply

    __add__ = __radd__ = _counted(operator.add)
    __mul__ = __rmul__ = _counted(operator.mul)
    __sub__ = _counted(operator.sub)
    __truediv__ = _counted(operator.truediv)


class Pointer:
    """A place in an array, as C has it."""

    def __init__(self, array, place=0):
        self.array, self.place = array, place

    def __add__(self, step):
        return Pointer(self.array, self.place + step)

    def __sub__(self, step):
        return self + -step

    def __getitem__(self, index):
        assert self.place + index >= 0
        return self.array[self.place + index]

    def __setitem__(self, index, value):
        assert self.place + index >= 0
        self.array[self.place + index] = value


def pair(i, j):
    assert i >= j
    return i * (i + 1) // 2 + j


class Machine:
    """The functions of a plan with the sizes and integer tables of an element."""

    def __init__(self, functions, tables):
        self.names = {
            **FUNCTIONS, **tables, "zero": Lane(0), "HOBE_PARTS": 1, "hobe_pair": pair,
            "empty": empty, "Fraction": Fraction, "hobe_root": root,
            "array": lambda *values: Pointer(list(values)),
        }
        for function in functions:
            exec("\n".join(_python(function)), self.names)

    def run(self, name, *arguments):
        """The operations of one call; results are in the arrays passed."""
        before = Lane.operations
        self.names[name](*arguments)
        return Lane.operations - before


def root(lane):
    Lane.operations += 1
    return Lane(math.sqrt(lane.value))


def empty(size):
    return Pointer([None] * size)


def lanes(values):
    return Pointer([Lane(v) for v in values])


def values(pointer):
    return [v.value for v in pointer.array]


def structure(**fields):
    """What C reaches by an arrow."""
    return SimpleNamespace(**fields)


def _python(function):
    arguments = ", ".join(re.search(r"\w+$", a)[0] for a in function.arguments)
    return [f"def {function.name}({arguments}):", *_block(function.body, 1)]


def _block(body, depth):
    pad, lines = "    " * depth, []
    for node in body:
        match node:
            case Do():
                lines += [pad + line for line in _statement(node.text)]
            case Let():
                lines.append(f"{pad}{node.var} = {_integer(node.expression)}")
            case For():
                span = f"range({_integer(node.first)}, {_integer(node.last)})"
                lines += [f"{pad}for {node.var} in {span}:", *_block(node.body, depth + 1)]
            case If():
                lines += [f"{pad}if {_integer(node.condition)}:", *_block(node.body, depth + 1)]
            case Note():
                pass
    return lines or [pad + "pass"]


def _integer(text):
    return python(text).replace("->", ".").replace("/", "//")


def _statement(text):
    """C declarations, assignments and calls as Python."""
    text = " ".join(text.split()).replace("->", ".").replace("0.5", "Fraction(1, 2)").rstrip(";")
    declared = re.match(r"(const )?(double|hobe_real|int) ", text)
    if not declared:
        return [text]
    lines = []
    for item in _split(text[declared.end():]):
        name, size, value = re.fullmatch(r"\*?(\w+)(?:\[(.*?)\])?(?: = (.*))?", item).groups()
        if value:
            value = _choice(value)
        if size and not value:
            value = f"empty({size})"
        elif size:
            value = f"array({value.strip('{}')})"
        lines.append(f"{name} = {value}")
    return lines


def _choice(value):
    """The operator ?:, which may be nested in its last place."""
    if choice := re.fullmatch(r"(.*?) \? (.*?) : (.*)", value):
        return f"({choice[2]}) if {choice[1]} else ({_choice(choice[3])})"
    return value


def _split(text):
    """At the commas outside brackets."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "([{") - (c in ")]}")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return [p.strip() for p in parts]
