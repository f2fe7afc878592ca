# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 2: axial shape functions of each field, exact polynomials in xi = x/l.

A field with functionals L_i (values and slopes at nodes) gets the polynomials N_j of lowest degree
with L_i N_j = delta_ij.  Slopes are d/dx: their functions carry a factor l, kept apart here.
"""

import re
from fractions import Fraction

import sympy

from .declaration import DeclarationError

XI = sympy.Symbol("xi")
POLYNOMIAL = re.compile(r"(xi|[0-9+*/() -])+")  # sympy evaluates what it parses: nothing else


def derive(declaration):
    """For each field the tuple of its shape functions, as tuples of Fractions, constant first."""
    functions = []
    for number, field in enumerate(declaration.fields):
        where = f"element {declaration.name}, field {'/'.join(field.modes)}"
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
    try:
        if not POLYNOMIAL.fullmatch(text):
            raise ValueError(text)
        poly = sympy.Poly(sympy.parse_expr(text, {"xi": XI}), XI, domain="QQ")
    except (sympy.PolynomialError, sympy.SympifyError, SyntaxError, TypeError, ValueError):
        raise DeclarationError(f"{where}: {text!r} is not a polynomial in xi with rational "
                               "coefficients") from None
    return _trim(Fraction(int(c.p), int(c.q)) for c in reversed(poly.all_coeffs()))


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
                    f"{where}: function {j + 1} has {kind} {value} at node {dof.node + 1}, must be "
                    f"{int(i == j)} (Kronecker property)")


def _check_completeness(nodes, dofs, functions, where, centreline):
    """Rigid motion needs constants in every field; constant strain a linear centreline."""
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
