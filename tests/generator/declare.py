# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers of the generator's tests: declarations from text, elements, runs of the command."""

import os
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import generator
from generator import declaration, emit, invariants, plan, shape

SOURCE = Path(__file__).resolve().parents[2]
ELEMENTS = sorted(SOURCE.glob("elements/*.toml"))

# The smallest declaration there is, and its parts.
LINEAR = '{ 1 = ["value"], 2 = ["value"] }'
HEAD = 'name = "T"\nnodes = ["0", "1"]\n'
PLANE = f'[[field]]\nmodes = ["1", "y", "z"]\ndofs = {LINEAR}\n'
SMALL = HEAD + PLANE


class Case(unittest.TestCase):
    """A test with a folder of its own for declarations and generated files."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, text):
        """The path of a declaration of this text, called after its element."""
        try:
            name = tomllib.loads(text).get("name")
        except tomllib.TOMLDecodeError:
            name = None
        stem = name if isinstance(name, str) and name.isprintable() and "/" not in name else "T"
        path = self.folder / f"{stem}.toml"
        path.write_text(text, encoding="utf-8")
        return str(path)

    def read(self, *texts):
        return declaration.read([self.file(text) for text in texts])

    def element(self, *texts):
        """The element of the last text, which may extend the others."""
        return build(self.read(*texts)[-1])

    def refusal(self, *texts):
        """The sentence by which declarations are refused before any C is written."""
        with self.assertRaises(declaration.DeclarationError) as caught:
            for item in self.read(*texts):
                build(item)
        return str(caught.exception)


def build(item):
    return invariants.build(item, shape.derive(item))


def shipped():
    """The elements of elements/ by name."""
    return {d.name: build(d) for d in declaration.read(map(str, ELEMENTS))}


def c_text(element):
    return emit.element_file(element, plan.build(element))


def run(*arguments, python=sys.executable, seconds=120, **environment):
    """python -m generator ARGUMENTS."""
    home = str(Path(generator.__file__).resolve().parents[1])
    return subprocess.run([python, "-B", "-m", "generator", *map(str, arguments)], cwd=home,
                          env={**os.environ, "PYTHONPATH": home, **environment}, timeout=seconds,
                          capture_output=True, text=True, check=False)


def files(folder):
    """Names and bytes of the files of a folder."""
    return {p.name: p.read_bytes() for p in sorted(Path(folder).iterdir())}
