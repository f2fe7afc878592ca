# SPDX-License-Identifier: GPL-3.0-or-later
"""Renews the numbers and pictures of the documentation: python3 docs/refresh.py

A block in a page between `<!-- $ COMMAND -->` and `<!-- end -->` holds what COMMAND prints; this
script runs the commands in the top folder and puts their output there.  Pictures are drawn by the
cases.  With --check nothing is written and the status tells whether a command failed.

With --charts it renews the page of charts instead, as `./hobe chart --all` does: its commands write
into folders of $OUT, whose pictures become docs/chart_FOLDER.png.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"(<!-- \$ (.*?) -->\n```\w*\n).*?(```\n<!-- end -->)", re.S)
PAGES = ("README.md", "elements/README.md")
CHARTS = ("docs/results.md",)
PICTURES = {  # case: the picture it draws, its name here
    "princeton_angles": ("twist.png", "princeton_twist.png"),
    "gallery": ("gallery.png", "sections.png"),
    "modes": ("modes.png", "modes.png"),
    "torsion_curves": ("fig11.png", "torsion.png"),
    "shaft": ("shaft.png", "shaft.png"),
}


def run(command, folder):
    print("$", command, file=sys.stderr)
    return subprocess.run(command, shell=True, cwd=TOP, check=True, text=True,
                          stdout=subprocess.PIPE, env=dict(os.environ, OUT=folder)).stdout


def draw(charts, folder):
    """Where the pictures are and where they belong; those of charts the page has drawn."""
    found = pathlib.Path(folder)
    if charts:
        return {p: f"chart_{p.parent.name}.png" for p in found.glob("*/chart.png")}
    for case in PICTURES:
        run(f"./hobe run cases/{case}.lua --out {folder}/{case}", folder)
    return {found / case / source: target for case, (source, target) in PICTURES.items()}


def main():
    check, charts = ("--check" in sys.argv[1:]), ("--charts" in sys.argv[1:])
    pages = {}
    with tempfile.TemporaryDirectory() as folder:
        for name in CHARTS if charts else PAGES:
            text = (TOP / name).read_text(encoding="utf-8")
            pages[name] = BLOCK.sub(lambda m: m[1] + run(m[2], folder) + m[3], text)
        pictures = draw(charts, folder)
        if check:
            return
        for source, target in pictures.items():
            shutil.copyfile(source, TOP / "docs" / target)
    for name, text in pages.items():
        (TOP / name).write_text(text, encoding="utf-8")


main()
