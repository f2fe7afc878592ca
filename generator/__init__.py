# SPDX-License-Identifier: GPL-3.0-or-later
"""The element compiler: from a declaration of ten lines to specialised C.

Five stages, each a module with one input and one output; `__main__` runs them and times them.

    stage               module          input -> output
    declaration         declaration.py  TOML file -> Declaration: nodes, fields, nodal vectors
    shape functions     shape.py        Declaration -> axial functions N(xi), exact polynomials
    invariants          invariants.py   both -> sizes, degrees, exact axial integrals, section modes
    contraction plan    plan.py         Element -> loop nests (ir.py) with their operation counts:
                        section.py      from station to station,
                        tensor.py       and as products with one tensor;
                        products.py     what both are made of
    C                   emit.py         loop nests -> one C file per element; its parts:
                        tables.py       constants,
                        law.py          what it makes of its section,
                        batch.py        what the runtime calls;
                        ctext.py        how numbers and tables are written
                        registry.py     all elements for all machines

All algebra is exact (sympy rationals); numbers become decimal only when printed.  The text depends
on the declaration and on the generator alone: not on the version of sympy, on hash seeds, dates or
paths.
"""
