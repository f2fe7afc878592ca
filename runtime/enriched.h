/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What an element lacks: the difference to one that has polynomials of one degree more for each of
 * its modes, alone under the nodal forces that the element has.
 *
 * Those forces f_v balance the loads.  On trial functions b_i they do the work F_i = sum_v f_v
 * b_i(v), where b_i(v) is what the nodal vector v is of b_i, a value or a slope; the element's
 * stress does a_i, and a_i = F_i on its own functions.  What it lacks, x, is to the first order
 * that of
 *
 *     K x = F - a,     K = int B'CB,
 *
 * K without the geometric part, so that it is no less than zero, and its null space, rigid motions,
 * does no work.  All elements on their own are in equilibrium with the loads: in a linear scene the
 * energy x'Kx/2 of all is at least that of the error (Prager & Synge, Quart. Appl. Math. 5, 1947;
 * local problems with the forces between elements: Ladeveze & Leguillon, SIAM J. Numer. Anal. 20,
 * 1983), but for what more degrees would add, and F.x = x'Kx is the work of the loads that the mesh
 * is short of.  Where elements turn far and their energy grows with a higher power than that of
 * what they lack, F.x still is that work, while the energy is a part of it. */
#ifndef HOBE_ENRICHED_H
#define HOBE_ENRICHED_H

#include "kernel.h"

/* An element of the form "continuum". */
struct enriched {
    const struct hobe_kernel *kernel;
    const struct hobe_invariants *inv;
    const unsigned char *dropped; /* [modes] those held at zero */
};

/* work[HOBE_LANES] = F.x of a batch, J; q0, u as in kernel.h. */
typedef void enriched_function(const struct enriched *e, const hobe_lanes *q0, const hobe_lanes *u,
                               hobe_lanes *work, hobe_lanes *scratch);

/* How many hobe_lanes of scratch that takes. */
size_t enriched_scratch(const struct hobe_kernel *kernel);

/* The one compiled for the processor that the kernels in use are for. */
enriched_function *enriched_work(void);

#endif
