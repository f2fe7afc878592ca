# SPDX-License-Identifier: GPL-3.0-or-later
"""C text of an element's constant tables."""

from . import ctext, products, section

BLOCKS = {
    "continuum": {"NA": "Gram pairs d_k'.d_l'", "NN": "normal block: those and d_k.d_l",
                  "NS": "shear block: d_k'.d_l"},
    "structural": {"ROD": "stations of the rod's strains, before those of the section's",
                   "NN": "the rod's strains Gamma, kappa",
                   "NS": "the section's strains E_yy, E_zz, 2 E_yz"},
}


def of_element(element):
    d, size = element.declaration, element.sizes
    notes = {"V": "nodal vectors", "M": "section modes", "S": "section vectors d_k', d_k",
             "A": "distinct axial functions", **BLOCKS[d.form]}
    overlap = [ctext.number(x) for row in element.overlap for x in row]
    return "\n".join([
        *ctext.enum(size, notes), "",
        "static const hobe_real zero = {0};", "",
        "/* Of each nodal vector: mode; whether it is a position; axial function. */",
        ctext.table("static const unsigned char mode[V]", [str(v.mode) for v in d.vectors]),
        ctext.table("static const unsigned char position[V]",
               [str(int(v.is_position)) for v in d.vectors]),
        ctext.table("static const unsigned char axial_of[V]", map(str, element.axial_of)),
        ctext.table("static const unsigned char is_slope[A]",
               [str(int(a.slope)) for a in element.axial]),
        "", "/* int_0^1 A_i A_j dxi, exact */",
        ctext.table("static const double overlap[A * A]", overlap), ""])


PLAN_SIZES = {
    "COLUMNS": "sums and differences of nodal vectors", "PAIRS": "of those",
    "BLOCKS": "of the tangent, pairs of nodal vectors: a row each",
    "CLASSES": "of parities: 1 odd in x, 2 odd in y, 4 odd in z", "LAST": "the last position",
    "OPPOSED": "whether it is one of two: rows with the first are less those with it",
    "MIRRORED": "whether there are mirror images",
    "GRAMS": "pairs of section vectors", "AXIAL": "weights of a station for axial functions",
    "MOST_PAIRS": "of either kind",
}
PLAN_TABLES = {
    "parity": ("unsigned char", "of each section vector: 1 odd in x, 2 odd in y, 4 odd in z"),
    "odd_of": ("unsigned char", "of each nodal vector: whether its image has the other sign"),
    "left": ("short", "of each column: q_left + sign q_right, less the last position where "
                      "shifted; its\n * function is share (N_left + sign N_right)"),
    "right": ("short", None), "shifted": ("short", None), "sign": ("double", None),
    "share": ("double", None),
    "by_mode": ("unsigned char", "nodal vectors in the order of their modes, those with rows"),
    "first_of": ("unsigned char", "where each mode begins"),
    "merged": ("short", "by symmetry: how many classes a row meets, and its own class times which"),
    "merged_with": ("short", None),
}


def of_plan(element, plan):
    layout = plan.layout
    sizes = {**layout.sizes, **section.sizes(element)}
    sizes["MOST_PAIRS"] = max(sizes["PAIRS"], sizes["GRAMS"])
    tables = {"parity": section.parities(element), **layout.tables, **section.tables(element),
              **products.TABLES,
              "sign": [c.sign for c in layout.columns],
              "share": [ctext.number(c.share) for c in layout.columns]}
    lines = ["/* ---- eqs. 27 and 28 as products with constant matrices (generator/products.py) "
             "---- */", "", *ctext.enum(sizes, PLAN_SIZES), ""]
    for name, (kind, note) in PLAN_TABLES.items():
        lines += [f"/* {note} */"] if note else []
        lines.append(ctext.table(f"static const {kind} {name}[]", map(str, tables[name]), gap=""))
    for of, note in (layout.products, "nodal vectors"), (plan.sectional, "section vectors"):
        lines.append(f"/* products of {note} */")
        names = {}  # of tables; equal ones are written once
        kinds = {name: "unsigned char" if name in products.OF_VECTORS else "short"
                 for name in of.tables}
        for name, table in of.tables.items():
            names.setdefault((kinds[name], *table), f"{of.name}_{name}")
        lines += [ctext.table(f"static const {kind} {name}[]", map(str, table), gap="")
                  for (kind, *table), name in names.items()]
        of_names = ", ".join(names[kinds[name], *table] for name, table in of.tables.items())
        lines.append("\n".join(ctext.wrap(f"static const struct products {of.name}[1] = {{{{",
                                     f"{of.columns}, {len(of.pairs)}, {of_names}}}}};")))
    return "\n".join([*lines, ""])
