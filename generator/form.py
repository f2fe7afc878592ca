# SPDX-License-Identifier: GPL-3.0-or-later
"""What plans have in common (stage 4): arguments, and the statements by which section vectors come
from nodal vectors at a station g of the axis and forces go back to them."""

from .ir import Do, If, Let, Note, loop

INVARIANTS = "const struct hobe_invariants *inv"


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


AXIAL = Do("const double *N = inv->N + V * g, *Nx = inv->Nx + V * g;", free=True)

# U, the change of the section vectors D[S][3], and B, the mean of D before and after
VECTORS = (
    Do("section_vectors(N, Nx, x0, B);"),
    Do("section_vectors(N, Nx, x, U);"),
    loop("i", "3 * S", Do("B[i] += 0.5 * U[i];")),
)

# B, D after the change
CURRENT = Note("D = D0 + U"), loop("i", "3 * S", Do("B[i] += 0.5 * U[i];"))

CLEAR_FORCE = loop("i", "3 * V", Do("f[i * HOBE_PARTS] = zero;"))


def hand_back(source):
    """f_v += w (N_v' P_k' + N_v P_k)."""
    return loop(
        "v", "V",
        Let("k", "mode[v]"),
        Do("const double cx = inv->wx[g] * Nx[v], c = inv->wx[g] * N[v];", free=True),
        axis3(f"f[(3 * v + a) * HOBE_PARTS] += cx * {source}[3 * k + a];"),
        If("k > 0", (
            axis3(f"f[(3 * v + a) * HOBE_PARTS] += c * {source}[3 * (M - 1 + k) + a];"),)))
