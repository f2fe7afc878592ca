# SPDX-License-Identifier: GPL-3.0-or-later
"""Loop nests: the little language in which contraction plans are written.

The same tree is printed as C and walked to count its floating-point operations, so that the count
in a file's header is that of its loops, conditions and triangular bounds included.
"""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Do:
    """One C statement.  Every * + - / outside square brackets counts as an operation on each lane
    (`+=` as one), and so does a square root; `free` statements count nothing: pointers, integers,
    and products of numbers that all lanes share."""

    text: str
    free: bool = False


@dataclass(frozen=True)
class For:
    """for (int var = first; var < last; var++) body; bounds are integer expressions."""

    var: str
    first: str
    last: str
    body: tuple


@dataclass(frozen=True)
class If:
    """if (condition) body; the condition may use loop variables, sizes and integer tables."""

    condition: str
    body: tuple


@dataclass(frozen=True)
class Let:
    """const int var = expression of loop variables, sizes and integer tables, for use in bounds and
    conditions."""

    var: str
    expression: str


@dataclass(frozen=True)
class Note:
    """A comment line."""

    text: str


@dataclass(frozen=True)
class Function:
    """A static C function.  A statement that calls another counts that one's operations, too."""

    name: str
    arguments: tuple
    comment: str
    body: tuple
    result: str = "void"


def loop(var, last, *body, first="0"):
    return For(var, first, last, body)


def write(body, depth=1):
    """The lines of C of a body."""
    pad, lines = "    " * depth, []
    for node in body:
        match node:
            case Do():
                lines += [pad + line for line in node.text.split("\n")]
            case Note():
                lines.append(f"{pad}/* {node.text} */")
            case Let():
                lines.append(f"{pad}const int {node.var} = {node.expression};")
            case For():
                i = node.var
                head = f"for (int {i} = {node.first}; {i} < {node.last}; {i}++)"
                lines += _under(pad, head, node.body, depth)
            case If():
                lines += _under(pad, f"if ({node.condition})", node.body, depth)
    return lines


def _under(pad, head, body, depth):
    """The lines of a body under the head of a loop or condition, in braces unless one statement."""
    lines = write(body, depth + 1)
    single = len(body) == 1 and (isinstance(body[0], (For, If))
                                 or isinstance(body[0], Do) and body[0].text.count(";") == 1)
    return [pad + head, *lines] if single else [f"{pad}{head} {{", *lines, pad + "}"]


class Counter:
    """Counts operations of functions under given sizes and integer tables."""

    def __init__(self, functions, names):
        self.functions = {f.name: f for f in functions}
        self.names = dict(names)
        self.known = {}
        self.text = {name: str(f.body) for name, f in self.functions.items()}

    def set(self, name, value):
        """Another value of a name; what does not depend on it stays counted."""
        self.names[name] = value
        changed = {f for f, text in self.text.items() if name in text}
        while more := {f for f, text in self.text.items() if f not in changed
                       and any(f"{c}(" in text for c in changed)}:
            changed |= more
        self.known = {f: n for f, n in self.known.items() if f not in changed}

    def count(self, function):
        """Operations of one call, per lane."""
        if function not in self.known:
            self.known[function] = self._body(self.functions[function].body, self.names)
        return self.known[function]

    def _body(self, body, names):
        total, names = 0, dict(names)
        for node in body:
            match node:
                case Do() if not node.free:
                    total += self._statement(node.text)
                case Let():
                    names[node.var] = _integer(node.expression, names)
                case If():
                    if _integer(node.condition, names):
                        total += self._body(node.body, names)
                case For():
                    total += self._loop(node, names)
        return total

    def _loop(self, node, names):
        first, last = _integer(node.first, names), _integer(node.last, names)
        if first < last and not _depends(node.body, node.var):
            return (last - first) * self._body(node.body, {**names, node.var: first})
        return sum(self._body(node.body, {**names, node.var: i}) for i in range(first, last))

    def _statement(self, text):
        called = [name for name in re.findall(r"(\w+)\(", text) if name in self.functions]
        return operations(text) + sum(map(self.count, called))


def operations(text):
    """Arithmetic operators and square roots of a C statement, those inside indices and arguments
    aside."""
    roots = len(re.findall(r"\bhobe_root\(", text))
    while (inner := re.sub(r"\[[^\[\]]*\]|\w\([^()]*\)", "", text)) != text:
        text = inner
    return roots + len(re.findall(r"[*/+-]", text))


def _depends(body, var):
    """Whether any bound, condition or Let below uses the variable."""
    use = re.compile(rf"\b{var}\b")
    for node in body:
        match node:
            case Let() if use.search(node.expression) and _depends(body, node.var):
                return True
            case If() if use.search(node.condition) or _depends(node.body, var):
                return True
            case For() if (use.search(node.first) or use.search(node.last)
                           or _depends(node.body, var)):
                return True
    return False


def _integer(expression, names):
    text = python(expression).replace("->", "_").replace("/", "//")
    return int(eval(text, {"__builtins__": {}, **FUNCTIONS, **names}))


# Those of kernel.h and the head of a file that expressions may call.
FUNCTIONS = {
    "hobe_pair": lambda i, j: i * (i + 1) // 2 + j,
    "symmetric": lambda i, j: max(i, j) * (max(i, j) + 1) // 2 + min(i, j),
    "larger": max,
}


def python(expression):
    """An expression of C as Python's, but for divisions and arrows."""
    text = expression.replace("&&", " and ")
    if choice := re.fullmatch(r"(.*) \? (.*) : (.*)", text):
        text = f"({choice[2]}) if {choice[1]} else ({choice[3]})"
    return text
