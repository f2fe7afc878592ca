# SPDX-License-Identifier: GPL-3.0-or-later
"""C text of what the runtime calls: an element's functions on the parts of a batch."""

ENERGY = """\
static void energy(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                   hobe_lanes *U)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        energy_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)U + h);
}
"""

STRUCTURAL_BATCH = """\
static void force(const struct hobe_invariants *inv, const hobe_lanes *q0,
                               const hobe_lanes *u, hobe_lanes *f, hobe_lanes *scratch)
{
    (void)scratch;
    for (int h = 0; h < HOBE_PARTS; h++)
        force_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h);
}

static void tangent(const struct hobe_invariants *inv, const hobe_lanes *q0,
                                 const hobe_lanes *u, hobe_lanes *f, hobe_lanes *K,
                                 hobe_lanes *scratch)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        tangent_part(inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h,
                     (hobe_real *)K + h, (hobe_real *)scratch);
}
"""

BATCH = """\
static void force(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                  hobe_lanes *f, hobe_lanes *scratch)
{
    for (int h = 0; h < HOBE_PARTS; h++) {
        const hobe_real *reference = (const hobe_real *)q0 + h, *moved = (const hobe_real *)u + h;
        if (inv->tensor)
            tensor_force_part(inv, reference, moved, (hobe_real *)f + h, (hobe_real *)scratch);
        else
            force_part(inv, reference, moved, (hobe_real *)f + h);
    }
}

static void tangent(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                    hobe_lanes *f, hobe_lanes *K, hobe_lanes *scratch)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        (inv->tensor ? tensor_tangent_part : tangent_part)(
            inv, (const hobe_real *)q0 + h, (const hobe_real *)u + h, (hobe_real *)f + h,
            (hobe_real *)K + h, (hobe_real *)scratch);
}
"""

TRILINEAR = """\
static void trilinear(const struct hobe_invariants *inv, const hobe_lanes *a, const hobe_lanes *b,
                      const hobe_lanes *c, hobe_lanes *f, hobe_lanes *scratch)
{
    (void)scratch;
    for (int h = 0; h < HOBE_PARTS; h++)
        trilinear_part(inv, (const hobe_real *)a + h, (const hobe_real *)b + h,
                       (const hobe_real *)c + h, (hobe_real *)f + h);
}
"""


GRAM = """\
static void gram(const struct hobe_invariants *inv, const hobe_lanes *b, const hobe_lanes *c,
                 hobe_lanes *strain, hobe_lanes *stress)
{
    for (int h = 0; h < HOBE_PARTS; h++)
        gram_part(inv, (const hobe_real *)b + h, (const hobe_real *)c + h, (hobe_real *)strain + h,
                  (hobe_real *)stress + h);
}
"""
