/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How much too stiff the mesh of a beam is: an estimate by what each element lacks (enriched.h).
 *
 * The work that the loads are short of, beside what they do, is the share of the displacements that
 * is missing.  It sees coarse meshes, in bending as in torsion and where warping fades from an end,
 * and locking: an element whose axis cannot follow a bent arc makes up for that by stretch, one
 * whose slopes cannot follow a turn by their length, both of which are so much stiffer that it
 * then hardly bends or twists.  It takes loads to act at the nodes. */
#include "assemble.h"
#include "element.h"
#include "enriched.h"
#include "solution.h"

#include <stdio.h>

/* Less is what a coarse mesh may well cost. */
static const double NOTICEABLE = 0.01;

/* The sum over a beam's elements, J. */
static enum hobe_status find_work(const hobe_solution *solution, const struct beam *beam,
                                  double *work, struct hobe_error *err)
{
    const size_t size = 3 * (size_t)beam->kernel->vectors;
    hobe_lanes of_batch, *u = hobe_alloc(size + enriched_scratch(beam->kernel), sizeof *u, err);
    *work = 0;
    for (int b = 0; u && b < beam->batches; b++) {
        const struct batch *batch = beam->batch + b;
        const struct enriched enriched = {beam->kernel, hobe_element_invariants(batch->law),
                                          hobe_element_dropped(batch->law)};
        assemble_gather(solution->model, beam, batch, solution->u, u);
        enriched_work()(&enriched, batch->q0, u, &of_batch, u + size);
        for (int lane = 0; lane < batch->count; lane++)
            *work += of_batch[lane];
    }
    hobe_free(u);
    return u ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_solution_mesh_error(const hobe_solution *solution, const char *name,
                                          double *share, struct hobe_error *err)
{
    const struct beam *beam = model_find_beam(solution->model, name, NULL, err);
    double work;
    *share = 0;
    if (!beam)
        return HOBE_UNKNOWN;
    if (hobe_element_mechanics(beam->law[0]) == HOBE_MECHANICS_STRUCTURAL)
        return HOBE_OK;
    const enum hobe_status status = find_work(solution, beam, &work, err);
    if (!status && work > 0)
        *share = work / (work + 2 * assemble_beam_energy(solution->model, beam, solution->u));
    return status;
}

enum hobe_status hobe_solution_mesh_warning(const hobe_solution *solution, const char *name,
                                            char *text, size_t size, struct hobe_error *err)
{
    double share;
    const enum hobe_status status = hobe_solution_mesh_error(solution, name, &share, err);
    snprintf(text, size, "%s", "");
    if (!status && share >= NOTICEABLE)
        snprintf(text, size,
                 "beam %s: about %.2g %% of what its loads should do to it is missing: its "
                 "elements cannot "
                 "follow how it bends and turns; use more of them, or such of higher order",
                 name, 100 * share);
    return status;
}
