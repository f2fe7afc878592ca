# SPDX-License-Identifier: GPL-3.0-or-later
"""elements/README.md says what is so."""

import os
import re
import subprocess
import unittest

from declare import ELEMENTS, SOURCE, Case, build, c_text
from generator import declaration

README = (SOURCE / "elements/README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", README, re.M | re.S)


class Example(Case):
    def setUp(self):
        super().setUp()
        self.text, = (text for kind, text in BLOCKS if kind == "toml")

    def declared(self, text):
        return declaration.read([*map(str, ELEMENTS), self.file(text)])[-1]

    def test_vectors(self):
        shown, = (text for kind, text in BLOCKS if text.startswith("vectors"))
        self.assertIn(f" * {shown}", c_text(build(self.declared(self.text))))

    def test_refusal(self):
        shown, = (text for kind, text in BLOCKS if "did you mean" in text)
        with self.assertRaises(declaration.DeclarationError) as caught:
            self.declared(self.text.replace("like ", "lkie "))
        self.assertEqual(str(caught.exception).removeprefix(f"{self.folder}/") + "\n", shown)

    def test_keys(self):
        """The tables list every key."""
        listed = re.findall(r"^\| `(?:\[\[)?(\w+)(?:\]\])?` \|", README, re.M)
        self.assertEqual(sorted(listed), sorted(declaration.KEYS + declaration.FIELD_KEYS))

    def test_limits(self):
        said, = re.findall(r"At most (\d+) modes, (\d+) of them functions of the section, "
                           r"and (\d+) vectors", " ".join(README.split()))
        self.assertEqual(tuple(map(int, said)), (
            declaration.MAX_MODES, declaration.MAX_FUNCTIONS, declaration.MAX_VECTORS))

    def test_table(self):
        """Holds what the program prints; docs/refresh.py puts it there."""
        program = os.environ.get("HOBE")
        if not program:
            self.skipTest("HOBE does not name the program")
        printed = subprocess.run([program, "elements"], capture_output=True, text=True, check=True)
        rows = {tuple(line.split()) for line in printed.stdout.splitlines()}
        if len(rows) < len(ELEMENTS) + 1:
            self.skipTest("this program has not all elements")
        shown, = (text for kind, text in BLOCKS
                  if kind == "text" and text.startswith("name "))
        for line in shown.splitlines():
            self.assertIn(tuple(line.split()), rows)


if __name__ == "__main__":
    unittest.main()
