# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m generator --out DIR DECLARATION.toml ...: writes DIR/<element>.c and DIR/registry.c.

All given declarations are read before any is built, so that one may extend another; --only limits
what is written.  Times of the stages go to standard error.
"""

import argparse
import os
import sys
import time

from . import ctext, declaration, emit, invariants, plan, registry, shape


class Stages:
    """Adds up the time of each stage."""

    def __init__(self):
        self.seconds = {}

    def run(self, stage, function, *arguments):
        start = time.perf_counter()
        result = function(*arguments)
        self.seconds[stage] = self.seconds.get(stage, 0.0) + time.perf_counter() - start
        return result


def generate(paths, only, stages):
    """File names and texts for the declarations at paths; only: names to write, or empty."""
    declared = stages.run("declaration", declaration.read, paths)
    names = [d.name for d in declared]
    for name in only:
        if name not in names:
            raise declaration.DeclarationError(
                f"--only {name}: no such element; known are {', '.join(names)}")
    elements = []
    for item in sorted((d for d in declared if not only or d.name in only), key=lambda d: d.name):
        functions = stages.run("shape functions", shape.derive, item)
        elements.append(stages.run("invariants", invariants.build, item, functions))
    files = {}
    for element in elements:
        name = ctext.identifier(element.declaration.name) + ".c"
        contraction = stages.run("contraction plan", plan.build, element)
        files[name] = stages.run("C", emit.element_file, element, contraction)
    files["registry.c"] = stages.run("C", registry.write, elements)
    return files


def write(folder, files):
    """Replaces only files whose text changed, so that make recompiles no more than it must."""
    os.makedirs(folder, exist_ok=True)
    for name, text in files.items():
        path = os.path.join(folder, name)
        try:
            with open(path, encoding="utf-8") as stream:
                if stream.read() == text:
                    continue
        except OSError:
            pass
        with open(path + ".new", "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
        os.replace(path + ".new", path)


def main():
    parser = argparse.ArgumentParser(prog="generator", description=__doc__)
    parser.add_argument("--out", required=True, help="folder for the C files")
    parser.add_argument("--only", nargs="*", default=[], help="elements to write (default: all)")
    parser.add_argument("declarations", nargs="+")
    options = parser.parse_args()
    stages = Stages()
    try:
        files = generate(options.declarations, options.only, stages)
        stages.run("writing", write, options.out, files)
    except declaration.DeclarationError as error:
        sys.exit(f"generator: {error}")
    for stage, seconds in stages.seconds.items():
        print(f"generator: {stage:24s} {seconds:7.3f} s", file=sys.stderr)


main()
