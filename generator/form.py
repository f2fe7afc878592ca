# SPDX-License-Identifier: GPL-3.0-or-later
"""What the forms of the elastic force have in common, and what each must say (stage 4).

All elements share how section vectors come from nodal vectors and how forces and stiffnesses go
back to them (plan.py).  A form says what happens between, at one station of the axis.
"""

from dataclasses import dataclass

from .ir import Do, loop


@dataclass(frozen=True)
class Form:
    """Statements at a station g of the axis.  They find U, the change of the section vectors
    D[S][3], and B, the mean of D before and after; after `state`, B is D after the change."""

    functions: tuple  # those that the statements call, callees first, and parts of its own
    arrays: tuple     # of the state
    law: tuple        # pointers to the invariants of the station
    state: tuple      # from B and U to strains and stresses
    work: tuple       # w += strain times stress
    force: tuple      # U = dW/dD
    stiffness: tuple  # C = d2W/dD2, S x S blocks


def numbers(*names):
    """Arguments that are the same for all lanes."""
    return tuple(f"const double *{name}" for name in names)


def given(*names):
    return tuple(f"const hobe_real *{name}" for name in names)


def filled(*names):
    return tuple(f"hobe_real *{name}" for name in names)


def axis3(text):
    return loop("a", "3", Do(text))


def product(size, q, s, sigma):
    """sigma = Q s, by columns of the symmetric Q: independent sums, where rows would wait for each
    other."""
    return (
        loop("r", size, Do(f"{sigma}[r] = zero;")),
        loop("c", size, loop("r", size, Do(f"{sigma}[r] += {q}[c * {size} + r] * {s}[c];"))),
    )
