/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams that share a node: one vector for what they share, a corner where they meet at an angle. */
#include "numbering.h"

#include "constraint.h"
#include "kernel_vectors.h"

#include <math.h>

/* Ends that are joined must coincide to this fraction of the beams' length. */
static const double COINCIDENT = 1e-6;

/* One end of a join, resolved. */
struct joined {
    const struct beam *beam;
    int element, node;
    size_t end; /* 2 * beam, + 1 at its far end */
};

static enum hobe_status find_joined(const hobe_model *model, const struct hobe_join *join,
                                    struct joined end[2], struct hobe_error *err)
{
    double gap = 0;
    for (int i = 0; i < 2; i++) {
        end[i].beam = model_find_beam(model, join->beam[i], join->where, err);
        if (!end[i].beam)
            return HOBE_UNKNOWN;
        if (join->at[i] != 0 && join->at[i] != 1)
            return hobe_fail(err, HOBE_BAD_INPUT, join->where,
                             "beams are joined at their ends: at must be 0 or 1, got %g",
                             join->at[i]);
        end[i].end = 2 * (size_t)(end[i].beam - model_beam(model, 0)) + (join->at[i] == 1);
        end[i].node = node_at(end[i].beam, join->at[i], &end[i].element);
    }
    const struct beam *a = end[0].beam, *b = end[1].beam;
    if (a == b)
        return hobe_fail(err, HOBE_BAD_INPUT, join->where, "beam \"%s\" is joined to itself",
                         a->name);
    for (int c = 0; c < 3; c++)
        gap = hypot(gap, a->end[join->at[0] == 1][c] - b->end[join->at[1] == 1][c]);
    if (gap > COINCIDENT * fmax(a->length, b->length))
        return hobe_fail(err, HOBE_BAD_INPUT, join->where,
                         "the joined ends of \"%s\" and \"%s\" are %g m apart; they must coincide",
                         a->name, b->name, gap);
    return HOBE_OK;
}

static const double (*end_frame(const struct joined *end))[3]
{
    return (const double(*)[3])end->beam->end_frame[end->end % 2];
}

static int parallel(const struct joined end[2])
{
    const double(*a)[3] = end_frame(end), (*b)[3] = end_frame(end + 1);
    double turn = 0;
    for (int i = 0; i < 9; i++)
        turn = fmax(turn, fabs(a[i / 3][i % 3] - b[i / 3][i % 3]));
    return turn < 1e-9;
}

static long representative(const hobe_model *model, long v)
{
    while (model->alias[v] != v)
        v = model->alias[v];
    return v;
}

/* Makes the vector of a mode at two joined nodes one. */
static void share(hobe_model *model, const struct joined end[2], int mode, int slope)
{
    long v[2];
    for (int i = 0; i < 2; i++) {
        const int local = hobe_kernel_vector(end[i].beam->kernel, end[i].node, mode, slope);
        if (local < 0)
            return;
        v[i] = representative(model, end[i].beam->first + (long)end[i].element * end[i].beam->step +
                                         local);
    }
    model->alias[v[0] > v[1] ? v[0] : v[1]] = v[0] > v[1] ? v[1] : v[0];
}

/* Beams at an angle keep their own slopes, which a corner ties together. */
static enum hobe_status add_corner(hobe_model *model, const char *where, const struct joined end[2],
                                   struct hobe_error *err)
{
    struct tied side[2];
    for (int i = 0; i < 2; i++)
        tied_at(model_place(end[i].beam, (double)(end[i].end % 2)), side + i);
    struct tie *tie = tie_add(model, side, side + 1, err);
    if (!tie)
        return HOBE_NO_MEMORY;
    tie->corner = 1;
    tie->where = where;
    tie_turning(tie);
    return HOBE_OK;
}

/* Notes that two ends are tied; 0 when they are already, by other joins of the same node. */
static int tie(size_t *tied, const struct joined end[2])
{
    size_t root[2];
    for (int i = 0; i < 2; i++)
        for (root[i] = end[i].end; tied[root[i]] != root[i];)
            root[i] = tied[root[i]];
    tied[root[0]] = root[1];
    return root[0] != root[1];
}

/* Positions are shared; so are slopes y, z of parallel beams, and slope x and further modes where
 * the beams are alike.  A join that closes a ring at a node adds nothing, and as a corner would
 * have dependent multipliers. */
static enum hobe_status join_one(hobe_model *model, const struct hobe_join *join, size_t *tied,
                                 struct hobe_error *err)
{
    struct joined end[2];
    const enum hobe_status status = find_joined(model, join, end, err);
    if (status || !tie(tied, end))
        return status;
    share(model, end, 0, 0);
    if (!parallel(end))
        return add_corner(model, join->where, end, err);
    share(model, end, 1, 0);
    share(model, end, 2, 0);
    for (int m = 0;
         beam_same_law(&end[0].beam->spec, &end[1].beam->spec) && m < end[0].beam->kernel->modes;
         m++) {
        share(model, end, m, 0);
        share(model, end, m, 1);
    }
    return HOBE_OK;
}

enum hobe_status join_beams(hobe_model *model, struct hobe_error *err)
{
    const size_t ends = 2 * model->beams.count;
    size_t *tied = hobe_alloc(ends, sizeof *tied, err);
    enum hobe_status status = tied ? HOBE_OK : HOBE_NO_MEMORY;
    for (size_t i = 0; !status && i < ends; i++)
        tied[i] = i;
    for (size_t i = 0; !status && i < model->joins.count; i++)
        status = join_one(model, (const struct hobe_join *)model->joins.item + i, tied, err);
    hobe_free(tied);
    if (status)
        return status;
    for (long v = 0; v < model->vectors; v++)
        model->alias[v] = representative(model, v);
    return HOBE_OK;
}
