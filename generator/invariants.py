# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 3: what an element's energy needs that no state changes.

Collects sizes, polynomial degrees and exact axial integrals into an Element.  The section's part
of the H-tensor integrals (eqs. 27-28) depends on the section; the emitted `invariants` function
takes it from a cubature rule, once per section, material and length.
"""

from dataclasses import dataclass
from fractions import Fraction
from math import factorial

from .declaration import Declaration
from .shape import derivative

# Functions of a doubly symmetric section: odd in y, odd in z.  One that is not named here or not so
# costs speed alone: what a section keeps apart is found from its moments.
PARITY = {"w": (1, 1), "wy": (1, 0), "wz": (0, 1), "ww": (1, 1), "w1": (1, 1), "w2t": (1, 1),
          "v1y": (0, 1), "v1z": (1, 0), "v2y": (1, 0), "v2z": (0, 1), "v3y": (1, 0), "v3z": (0, 1),
          "w2": (0, 0), "w3": (0, 0)}


@dataclass(frozen=True)
class Mode:
    """phi = y^a z^b / (a! b!), or the section's function of that number."""

    name: str
    function: int | None
    powers: tuple = (0, 0)

    @property
    def scale(self):
        """1 / (a! b!), the factor that makes nodal vectors the derivatives of r."""
        return Fraction(1, factorial(self.powers[0]) * factorial(self.powers[1]))

    @property
    def parity(self):
        """1 where odd in y, and in z."""
        if self.function is not None:
            return PARITY.get(self.name, (0, 0))
        return self.powers[0] % 2, self.powers[1] % 2


@dataclass(frozen=True)
class Axial:
    """A distinct axial function: polynomial in xi (constant first), times l for a slope."""

    polynomial: tuple
    slope: bool


@dataclass(frozen=True)
class Element:
    declaration: Declaration
    modes: tuple     # Mode
    axial: tuple     # distinct Axial functions
    axial_of: tuple  # for each vector the number of its axial function
    overlap: tuple   # int_0^1 A_i A_j dxi, exact
    stations: int    # points on the axis: 2p + 1 for axial functions of degree p
    degree: int      # of the section's monomials

    @property
    def sizes(self):
        """Names and values of the constants that the emitted loops run over."""
        m = len(self.modes)
        blocks = {
            "NA": m * (m + 1) // 2,              # Gram pairs d_k'.d_l'
            "NN": m * m,                         # normal block: those and d_k.d_l
            "NS": m * (m - 1),                   # shear block: d_k'.d_l
        }
        if self.declaration.form == "structural":
            blocks = {
                "ROD": self.stations // 2,         # stations of the rod's strains, the first ones
                "NN": 6,                         # the rod's strains Gamma, kappa
                "NS": 3,                         # the section's strains E_yy, E_zz, 2 E_yz
            }
        return {
            "V": len(self.declaration.vectors),  # nodal vectors
            "M": m,                              # section modes
            "S": 2 * m - 1,                      # section vectors d_k', d_k
            **blocks,
            "A": len(self.axial),                # distinct axial functions
        }


def build(declaration, functions):
    """The Element of a declaration and its shape functions."""
    axial, axial_of = [], []
    for vector in declaration.vectors:
        item = Axial(functions[vector.field][vector.place], vector.slope)
        if item not in axial:
            axial.append(item)
        axial_of.append(axial.index(item))
    modes = tuple(_mode(name, declaration.functions) for name in declaration.modes)
    return Element(
        declaration=declaration,
        modes=modes,
        axial=tuple(axial),
        axial_of=tuple(axial_of),
        overlap=tuple(tuple(_integral(a.polynomial, b.polynomial) for b in axial) for a in axial),
        stations=_stations(declaration, functions),
        degree=max(sum(m.powers) for m in modes),
    )


def _mode(name, functions):
    if name in functions:
        return Mode(name, functions.index(name))
    return Mode(name, None, (name.count("y"), name.count("z")))


def _integral(a, b):
    return sum((p * q / (i + j + 1) for i, p in enumerate(a) for j, q in enumerate(b)), Fraction(0))


def _stations(declaration, functions):
    """Gauss points for the quartic energy in d_k' (all k) and d_k (k > 0); as many as the
    structural form has of two kinds."""
    slopes = max(len(derivative(f)) - 1 for fs in functions for f in fs)
    values = max(len(f) - 1 for field, fs in zip(declaration.fields, functions)
                 if field.modes != ("1",) for f in fs)
    return 2 * max(slopes, values) + 1  # n points integrate degree 2n - 1 >= 4 max
