# SPDX-License-Identifier: GPL-3.0-or-later
"""Renews the numbers and pictures of the documentation: python3 docs/refresh.py

A block in a page between `<!-- $ COMMAND -->` and `<!-- end -->` holds what COMMAND prints; this
script runs the commands in the top folder and puts their output there.  Pictures are drawn by the
cases.  With --check nothing is written and the status tells whether a command failed.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"(<!-- \$ (.*?) -->\n```\w*\n).*?(```\n<!-- end -->)", re.S)
PAGES = ("README.md", "elements/README.md")
PICTURES = {  # case: the picture it draws, its name here
    "princeton_angles": ("twist.png", "princeton_twist.png"),
    "gallery": ("gallery.png", "sections.png"),
    "modes": ("modes.png", "modes.png"),
    "torsion_curves": ("fig11.png", "torsion.png"),
    "shaft": ("shaft.png", "shaft.png"),
}


def run(command):
    print("$", command, file=sys.stderr)
    return subprocess.run(command, shell=True, cwd=TOP, check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def main():
    check = "--check" in sys.argv[1:]
    pages = {}
    for name in PAGES:
        text = (TOP / name).read_text(encoding="utf-8")
        pages[name] = BLOCK.sub(lambda m: m[1] + run(m[2]) + m[3], text)
    with tempfile.TemporaryDirectory() as folder:
        for case in PICTURES:
            run(f"./hobe run cases/{case}.lua --out {folder}/{case}")
        if check:
            return
        for case, (source, target) in PICTURES.items():
            shutil.copyfile(pathlib.Path(folder) / case / source, TOP / "docs" / target)
    for name, text in pages.items():
        (TOP / name).write_text(text, encoding="utf-8")


main()
