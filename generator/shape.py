# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 2: axial shape functions of each field, exact polynomials in xi = x/l.

A field with functionals L_i (values and slopes at nodes) gets the polynomials N_j of lowest degree
with L_i N_j = delta_ij.  Slopes are d/dx: their functions carry a factor l, kept apart here.
"""

import ast
from fractions import Fraction

import sympy

from .declaration import DeclarationError

MAX_DEGREE = 12  # of an explicit polynomial, and the largest exponent
MAX_NUMBER = 10**30  # numerators and denominators


def derive(declaration):
    """For each field the tuple of its shape functions, as tuples of Fractions, constant first."""
    functions = []
    for number, field in enumerate(declaration.fields):
        where = f"{declaration.path}: functions of {', '.join(field.modes)}"
        if field.functions is None:
            found = _interpolation(declaration.nodes, field.dofs, where)
        else:
            found = tuple(_polynomial(text, where) for text in field.functions)
        _check_kronecker(declaration.nodes, field.dofs, found, where)
        _check_completeness(declaration.nodes, field.dofs, found, where, number == 0)
        functions.append(found)
    return tuple(functions)


def evaluate(coefficients, xi):
    """Value of a polynomial (constant first) at xi."""
    value = Fraction(0)
    for c in reversed(coefficients):
        value = value * xi + c
    return value


def derivative(coefficients):
    return tuple(n * c for n, c in enumerate(coefficients))[1:] or (Fraction(0),)


def _apply(dof, nodes, coefficients):
    """The functional of a dof: value, or slope in xi, at its node."""
    return evaluate(derivative(coefficients) if dof.slope else coefficients, nodes[dof.node])


def _interpolation(nodes, dofs, where):
    """Columns of the inverse of the generalised Vandermonde matrix L_i xi^n."""
    size = len(dofs)
    powers = [(Fraction(0),) * n + (Fraction(1),) for n in range(size)]
    rows = [[sympy.Rational(*_apply(d, nodes, p).as_integer_ratio()) for p in powers] for d in dofs]
    matrix = sympy.Matrix(rows)
    if matrix.det() == 0:
        raise DeclarationError(f"{where}: its {size} functionals do not determine a polynomial of "
                               f"degree {size - 1}; give every node with a slope its value")
    inverse = matrix.inv()
    return tuple(_trim(Fraction(int(c.p), int(c.q)) for c in inverse.col(j)) for j in range(size))


def _polynomial(text, where):
    """The coefficients of a polynomial in xi, written with numbers, + - * / ** and parentheses."""
    try:
        found = _expand(ast.parse(text.strip(), mode="eval").body)
    except (ValueError, SyntaxError, RecursionError, MemoryError, ZeroDivisionError):
        found = None
    if found is None or len(found) > MAX_DEGREE + 1:
        raise DeclarationError(f"{where} = {text[:60]!r}: not a polynomial in xi of degree up to "
                               f"{MAX_DEGREE} with rational coefficients")
    return found


def _expand(node):
    """Coefficients of a syntax tree; nothing of it is ever executed."""
    match node:
        case ast.Constant(value=int(number)) if not isinstance(number, bool):
            return (Fraction(number),)
        case ast.Name(id="xi"):
            return (Fraction(0), Fraction(1))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return _combine([-1], [_expand(operand)])
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _expand(operand)
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return _combine([1, 1], [_expand(left), _expand(right)])
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return _combine([1, -1], [_expand(left), _expand(right)])
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return _product(_expand(left), _expand(right))
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            divisor = _expand(right)
            if len(divisor) > 1:
                raise ValueError("division by a polynomial")
            return _combine([1 / divisor[0]], [_expand(left)])
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(power))):
            if not 0 <= power <= MAX_DEGREE:
                raise ValueError("exponent out of range")
            base, result = _expand(left), (Fraction(1),)
            for _ in range(power):
                result = _product(result, base)
            return result
    raise ValueError("not a polynomial")


def _product(a, b):
    if len(a) + len(b) > MAX_DEGREE + 2:
        raise ValueError("degree out of range")
    total = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, p in enumerate(a):
        for j, q in enumerate(b):
            total[i + j] += p * q
    if any(max(abs(c.numerator), c.denominator) > MAX_NUMBER for c in total):
        raise ValueError("number out of range")
    return _trim(total)


def _trim(coefficients):
    coefficients = list(coefficients)
    while len(coefficients) > 1 and coefficients[-1] == 0:
        coefficients.pop()
    return tuple(coefficients)


def _check_kronecker(nodes, dofs, functions, where):
    for i, dof in enumerate(dofs):
        for j, function in enumerate(functions):
            value = _apply(dof, nodes, function)
            if value != (i == j):
                kind = "slope" if dof.slope else "value"
                raise DeclarationError(
                    f"{where}: number {j + 1} has {kind} {value} at node {dof.node + 1}, must be "
                    f"{int(i == j)} (Kronecker property)")


def _check_completeness(nodes, dofs, functions, where, centreline):
    """Rigid motion needs constants in the fields of 1, y, z, and continuity of a mode that does not
    vary along the beam in the others; the straight reference needs a linear centreline."""
    constant = _combine([int(not d.slope) for d in dofs], functions)
    if constant != (1,):
        raise DeclarationError(f"{where}: the shape functions cannot represent a constant "
                               "(partition of unity), so rigid motion would strain the element")
    linear = _combine([1 if d.slope else nodes[d.node] for d in dofs], functions)
    if centreline and linear != (0, 1):
        raise DeclarationError(f"{where}: the shape functions cannot represent a linear field, so "
                               "the element could not be at rest in its straight reference")


def _combine(weights, functions):
    size = max(len(f) for f in functions)
    total = [Fraction(0)] * size
    for weight, function in zip(weights, functions):
        for n, c in enumerate(function):
            total[n] += weight * c
    return _trim(total)
