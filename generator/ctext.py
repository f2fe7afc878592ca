# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of C: numbers, tables, constants, polynomials."""

from fractions import Fraction


def identifier(name):
    """An element's name as C sees it."""
    return name.replace("-", "_")


def wrap(head, words, width=92):
    lines = [head]
    for word in words.split():
        if len(lines[-1]) + 1 + len(word) > width:
            lines.append("   ")
        lines[-1] += " " + word
    return lines


def number(q):
    """An exact rational as a C constant expression (a quotient rounds correctly)."""
    q = Fraction(q)
    return f"{q.numerator}.0" if q.denominator == 1 else f"{q.numerator}.0 / {q.denominator}.0"


def table(declaration, values, width=96, gap=" "):
    start = " " * (4 - len(gap))
    lines, line = [], start
    for value in values:
        if len(line) + len(value) + len(gap) + 1 > width:
            lines.append(line)
            line = start
        line += f"{gap}{value},"
    return "\n".join([f"{declaration} = {{", *lines, line, "};"])


def enum(sizes, notes):
    width = max(len(f"{n} = {v},") for n, v in sizes.items())
    return ["enum {", *(f"    {f'{n} = {v},':<{width}} /* {notes[n]} */" for n, v in sizes.items()),
            "};"]


def horner(coefficients, x):
    text = f"({number(coefficients[-1])})" if coefficients[-1] < 0 else number(coefficients[-1])
    for c in reversed(coefficients[:-1]):
        inner = f"{x} * ({text})" if " " in text else f"{x} * {text}"
        text = f"{number(c)} + {inner}" if c else inner
    return text
