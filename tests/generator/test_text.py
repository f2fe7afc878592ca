# SPDX-License-Identifier: GPL-3.0-or-later
"""The files written: the same bytes everywhere, within budget, and C that compiles."""

import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from functools import cache
from pathlib import Path

import sympy
from declare import ELEMENTS, SMALL, SOURCE, Case, files, run
from generator import ctext

C_NAMES = [ctext.identifier(name) for name in sorted(p.stem for p in ELEMENTS)]

# Budgets, generous for a slow machine; what is reached is printed by the generator and by size(1).
SECONDS_TO_GENERATE = 60  # all elements
SECONDS_TO_COMPILE = 30   # any one
TEXT_OF_C = 70_000        # bytes, any one, and for
TEXT_OF_VECTOR = 700      # each nodal vector, since tables hold pairs of them
TEXT_OF_CODE = 64 * 1024  # bytes of .text, any one: the tangent should fit a level-2 cache


@cache
def pythons():
    """Pythons that can run the generator, one for each version of sympy."""
    folders = [*os.environ.get("PATH", "").split(os.pathsep), "/usr/bin"]
    found = {sympy.__version__: sys.executable}
    for python in dict.fromkeys(Path(folder) / "python3" for folder in folders if folder):
        ask = "import sys, sympy, tomllib; print(sympy.__version__, sys.executable)"
        try:
            result = subprocess.run([python, "-c", ask], capture_output=True, text=True, timeout=60,
                                    check=False)
        except OSError:
            continue
        if result.returncode == 0:
            version, path = result.stdout.strip().split(" ", 1)
            found.setdefault(version, path)
    return found


class Written(Case):
    @classmethod
    def setUpClass(cls):
        cls.common = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.common.cleanup)
        start = time.monotonic()
        cls.text = cls.generate(PYTHONHASHSEED="0")
        cls.seconds = time.monotonic() - start

    @classmethod
    def generate(cls, *arguments, **environment):
        """Names and texts of all files written."""
        with tempfile.TemporaryDirectory(dir=cls.common.name) as out:
            result = run("--out", out, *(arguments or ELEMENTS), **environment)
            if result.returncode != 0:
                raise AssertionError(result.stderr)
            return {name: data.decode() for name, data in files(out).items()}

    def test_files(self):
        self.assertEqual(sorted(self.text), sorted([*(f"{n}.c" for n in C_NAMES), "registry.c"]))

    def test_same_bytes(self):
        """For any hash seed, order, folder and time of the declarations."""
        some = self.generate(*ELEMENTS, "--only", "34X3", "MGD30w-II", PYTHONHASHSEED="1")
        self.assertEqual(some, {**some, "34X3.c": self.text["34X3.c"],
                                "MGD30w_II.c": self.text["MGD30w_II.c"]})
        copies = [shutil.copy(p, self.folder) for p in ELEMENTS]
        os.utime(copies[0], (0, 0))
        self.assertEqual(self.generate(*reversed(copies), PYTHONHASHSEED="2", LC_ALL="C",
                                       TZ="Asia/Tokyo"), self.text)

    def test_same_bytes_from_every_sympy(self):
        others = [path for version, path in pythons().items() if version != sympy.__version__]
        if not others:
            self.skipTest("one version of sympy here")
        for python in others:
            self.assertEqual(self.generate(python=python), self.text)

    def test_nothing_of_the_machine(self):
        """No path, date, version or name of a host in the text."""
        words = [str(SOURCE), self.common.name, sys.executable, sympy.__version__,
                 platform.python_version(), platform.node() + ":", time.strftime("%Y-%m-%d")]
        dates_and_paths = re.compile(r"\d\d:\d\d|\d{4}-\d\d-\d\d|/tmp|/home|/usr|\.toml")
        for name, text in self.text.items():
            for word in words:
                self.assertNotIn(word, text, name)
            self.assertIsNone(dates_and_paths.search(text), name)
            self.assertTrue(text.isascii() and text.endswith("\n"), name)
            self.assertFalse(set("\r\t") & set(text), name)

    def test_budget(self):
        self.assertLess(self.seconds, SECONDS_TO_GENERATE)
        for name, text in self.text.items():
            vectors = int((re.search(r"\bV = (\d+)", text) or [0, 0])[1])
            self.assertLess(len(text), TEXT_OF_C + TEXT_OF_VECTOR * vectors, name)

    def test_registry(self):
        """All elements, in the order of their names, for each machine."""
        listed = re.findall(r"^    &hobe_kernel_(\w+),$", self.text["registry.c"], re.M)
        self.assertEqual(listed, [name + suffix for suffix in ("_avx512", "_avx2", "")
                                  for name in C_NAMES])

    def test_compile_largest(self):
        """The longest text and the one with the most vectors, alone, without warnings."""
        compiler = shutil.which(os.environ.get("CC") or "gcc")
        if not compiler:
            self.skipTest("no gcc here")
        longest = max(self.text, key=lambda name: len(self.text[name]))
        for name in sorted({longest, "34X3.c"}):
            source, target = self.folder / name, self.folder / "element.o"
            source.write_text(self.text[name])
            start = time.monotonic()
            subprocess.run([compiler, "-std=gnu11", "-O3", "-Wall", "-Wextra", "-Wshadow",
                            "-Wstrict-prototypes", "-Wmissing-prototypes", "-Werror", "-I",
                            SOURCE / "runtime", "-c", source, "-o", target], check=True)
            self.assertLess(time.monotonic() - start, SECONDS_TO_COMPILE, name)
            if shutil.which("size"):
                sizes = subprocess.run(["size", target], capture_output=True, text=True, check=True)
                self.assertLess(int(sizes.stdout.split("\n")[1].split()[0]), TEXT_OF_CODE, name)

    def test_unchanged_files_stay(self):
        """A second run replaces only what changed."""
        out, path = self.folder / "out", self.file(SMALL)
        self.assertEqual(run("--out", out, path).returncode, 0)
        before = {p.name: p.stat().st_ino for p in out.iterdir()}
        self.file('mechanics = "axis"\n' + SMALL)
        self.assertEqual(run("--out", out, path).returncode, 0)
        after = {p.name: p.stat().st_ino for p in out.iterdir()}
        self.assertEqual([name for name in before if after[name] != before[name]], ["T.c"])


if __name__ == "__main__":
    unittest.main()
