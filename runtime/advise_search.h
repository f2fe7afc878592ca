/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the rooms of the search for a model share: advise.c, advise_sequence.c, advise_choice.c,
 * advise_step.c and advise_evidence.c. */
#ifndef HOBE_ADVISE_SEARCH_H
#define HOBE_ADVISE_SEARCH_H

#include "advise.h"

/* Sequences go on to meshes twice as fine as those that may be taken: where layers at an end need
 * the finest of these, the term behind it says how much they leave open. */
enum { BEYOND = 2, DOUBLINGS = 10 }; /* meshes 1, 2, 4, ... BEYOND * ADVISE_MOST */

/* A sequence over meshes, each twice as fine as the one before, and what it tends to. */
struct sequence {
    int count;
    int mesh[DOUBLINGS];
    double *term;         /* [DOUBLINGS][quantities] */
    double *limit, *open; /* [quantities], and how far that may be off */
    double *ratio;        /* [quantities] by which the error of a mesh twice as fine is smaller */
    double *slow;         /* [quantities] its last step, where steps do not shrink yet; else 0 */
};

/* The quantities Q(s, n) of a level, and what they are above those of the level before, D_s(n). */
enum { OWN, STEP, SEQUENCES };
struct level {
    const struct hobe_kernel *kernel;
    struct sequence of[SEQUENCES];
    int closed[SEQUENCES]; /* it cannot be refined */
};

struct search {
    const struct advise_problem *problem;
    struct advice *advice;
    struct level level[ADVISE_LEVELS];
    int levels;
    int base;        /* Q is the limit of this level's Q(s, n) and of the D above it */
    double accuracy; /* that is sought at the moment */
    double *scale;   /* [quantities] by which errors are measured */
    double *x;       /* [quantities] what is at hand */
};

static inline struct advise_model plain(const struct hobe_kernel *kernel, int elements)
{
    return (struct advise_model){.kernel = kernel, .elements = elements};
}

/* ---- trials (advise.c) ---------------------------------------------------------------------- */

/* The trial of a model, or NULL. */
const struct advise_trial *advise_find_trial(const struct search *s,
                                             const struct advise_model *model);

/* Runs a model, unless it has been; *trial is NULL where it failed. */
enum hobe_status advise_try_model(struct search *s, const struct advise_model *model,
                                  const struct advise_trial **trial, struct hobe_error *err);

/* ---- sequences and the estimate (advise_sequence.c) ------------------------------------------ */

/* Two meshes of a level to begin with, the coarsest that run; none: the level is left out. */
enum hobe_status advise_start_level(struct search *s, const struct hobe_kernel *kernel,
                                    struct hobe_error *err);
void advise_close_level(struct level *level);

/* A sequence without terms, of n quantities. */
enum hobe_status advise_open_sequence(struct sequence *of, size_t n, struct hobe_error *err);
void advise_close_sequence(struct sequence *of);

/* Adds a term: a - b, b NULL: 0.  A sequence begins anew where a mesh is missing. */
void advise_add_term(const struct search *s, struct sequence *to, int which, int elements,
                     const double *a, const double *b);

/* By what errors are measured, of the estimate. */
void advise_set_scale(struct search *s);

/* The largest |a - b| over the quantities; b NULL: 0. */
struct advise_loss advise_loss_of(const struct search *s, const double *a, const double *b);

/* x = what a level would give on a mesh; elements 0: its limit. */
void advise_predict(const struct search *s, int level, int elements, double *x);

/* Refines where most is open until no more than a share of the accuracy is. */
enum hobe_status advise_settle(struct search *s, double open, struct hobe_error *err);

/* ---- the choice (advise_choice.c) ------------------------------------------------------------ */

/* Runs the models up to a cost that the estimate gives hope, the cheapest first, until one holds;
 * failing that the nearest is taken. */
enum hobe_status advise_choose(struct search *s, struct hobe_error *err);

/* Whether a trial is within the accuracy; *error is its own, what is open included. */
int advise_holds(const struct search *s, const struct advise_trial *trial,
                 struct advise_loss *error);

/* Takes a trial. */
void advise_take(struct search *s, const struct advise_trial *trial, int held,
                 struct advise_loss error);

/* Whether what is open of the estimate decides: one that costs less than half may hold, too. */
int advise_hangs(const struct search *s);

/* Runs an element on meshes that cost less than half of the model taken, until one holds. */
enum hobe_status advise_try_element(struct search *s, const struct hobe_kernel *kernel, int linear,
                                    struct hobe_error *err);

/* Tries the elements that have the section modes of the model taken. */
enum hobe_status advise_try_twins(struct search *s, struct hobe_error *err);

/* ---- the step in time (advise_step.c) -------------------------------------------------------- */

/* Finds what the script's step leaves open, adds that to the estimate, and takes the model taken
 * with the longest step that holds. */
enum hobe_status advise_choose_step(struct search *s, struct hobe_error *err);

/* ---- the evidence (advise_evidence.c) -------------------------------------------------------- */

/* Weighs what the linear response loses, and takes it where it holds: what it loses and what its
 * mesh does may cancel. */
enum hobe_status advise_weigh_linear(struct search *s, struct hobe_error *err);

/* What the chosen model would lose without what it has in any case, and without inertia, which it
 * then may do without. */
enum hobe_status advise_weigh_without(struct search *s, struct hobe_error *err);

/* What each step between levels is worth, and what the chosen mesh leaves open. */
void advise_weigh_levels(struct search *s);

#endif
