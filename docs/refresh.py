# SPDX-License-Identifier: GPL-3.0-or-later
"""Renews the numbers and pictures of the documentation: python3 docs/refresh.py

A block in a page between `<!-- $ COMMAND -->` and `<!-- end -->` holds what COMMAND prints; this
script runs the commands in the top folder and puts their output there.  Pictures are drawn by the
cases.  With --check nothing is written and the status tells whether a command failed.

With --charts it renews the page of charts instead: its commands write into folders of $OUT, whose
pictures become docs/chart_FOLDER.png.  With --atlas it makes docs/atlas.md and its pictures anew from
the cases of the atlas: the comment at the head of each, its pictures and its tables.
`./hobe chart --all` does both.
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
ATLAS = "docs/atlas.md"
ATLAS_HEAD = """# The atlas of failures

Where methods fail, how it is seen, and what is done about it.  Each case is a test that fails when
a failure becomes silent; its words, pictures and tables are those of its file.
`./hobe chart --all` makes this page anew.
"""
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


def renew(names, folder):
    """The pages by name, with what their commands print now."""
    return {name: BLOCK.sub(lambda m: m[1] + run(m[2], folder) + m[3],
                            (TOP / name).read_text(encoding="utf-8")) for name in names}


def describe(case):
    """Title and text of a case of the atlas, from the comment at its head."""
    lines = case.read_text(encoding="utf-8").split("\nlocal ", 1)[0].splitlines()
    text = "\n".join(line[2:].strip() for line in lines if not line.startswith("-- Long:"))
    first, text = text.split(".", 1)
    title = " ".join(first.split()).removeprefix("Atlas of failures: ")
    return title[0].upper() + title[1:], text.strip()


def section(case, folder, pictures):
    """A case's part of the page; adds its pictures, where they are and where they belong."""
    title, text = describe(case)
    command = f"./hobe run cases/{case.name}"
    printed = run(f"{command} --out $OUT/{case.stem}", folder)
    shown = ""
    for picture in sorted(pathlib.Path(folder, case.stem).glob("*.png")):
        name = case.stem if case.stem == f"atlas_{picture.stem}" else f"{case.stem}_{picture.stem}"
        pictures[picture] = f"{name}.png"
        shown += f"![{title}: {picture.stem}]({name}.png)\n\n"
    table = printed.split("\n\nname ")[0]
    return (f"\n## {title}\n\n{text}\n\n{shown}<!-- $ {command} | sed '/^name /,$d' -->\n"
            f"```text\n{table}\n```\n<!-- end -->\n")


def draw(folder):
    """Where the pictures of PICTURES are and where they belong."""
    found = pathlib.Path(folder)
    for case in PICTURES:
        run(f"./hobe run cases/{case}.lua --out {folder}/{case}", folder)
    return {found / case / source: target for case, (source, target) in PICTURES.items()}


def main():
    check, charts, atlas = (word in sys.argv[1:] for word in ("--check", "--charts", "--atlas"))
    pages, pictures = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        if charts:
            pages = renew(CHARTS, folder)
            pictures = {p: f"chart_{p.parent.name}.png"
                        for p in pathlib.Path(folder).glob("*/chart.png")}
        if atlas:
            cases = sorted(TOP.glob("cases/atlas_*.lua"))
            pages[ATLAS] = ATLAS_HEAD + "".join(section(c, folder, pictures) for c in cases)
        if not charts and not atlas:
            pages, pictures = renew(PAGES, folder), draw(folder)
        if check:
            return
        for old in (TOP / "docs").glob("atlas_*.png") if atlas else ():
            old.unlink()
        for source, target in pictures.items():
            shutil.copyfile(source, TOP / "docs" / target)
    for name, text in pages.items():
        (TOP / name).write_text(text, encoding="utf-8")


main()
