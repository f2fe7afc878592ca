/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The states that a motion keeps, and what it conserves and loses. */
#ifndef HOBE_HISTORY_H
#define HOBE_HISTORY_H

#include "genalpha.h"

struct hobe_history {
    struct hobe_history_info info;
    struct list states, energies; /* hobe_solution *, struct hobe_energies */
    double size, indicator;       /* the largest so far of a reduced model's states (trust.h) */
};

/* The work since the start, by steps: of loads (Q + Q1)/2 . (u1 - u), exact where they are dead; of
 * drives and damping h (P + P1)/2. */
struct account {
    double *Q, *Q1; /* [vectors][3] the loads at the begin and at the end of a step, N */
    double *rate;   /* [vectors][3] Phi_t */
    struct power {
        double drives, damped;
    } power;                      /* at the begin, W */
    double loads, drives, damped; /* J */
    double start;                 /* kinetic and strain energy there, J */
};

enum hobe_status account_open(struct account *account, const hobe_model *model,
                              struct hobe_error *err);
void account_close(struct account *account);

/* The forces at the begin of a step, where they are not those at the end of the last. */
void account_begin(struct account *account, const struct genalpha *g);

/* The work of the step that has just been found, before it is accepted. */
void account_step(struct account *account, const struct genalpha *g);

/* Appends a state, which is the history's from then on, or freed after a failure. */
enum hobe_status history_append(hobe_history *history, hobe_solution *state,
                                const struct hobe_energies *energies, struct hobe_error *err);

/* Keeps the state now.  HOBE_NOT_CONVERGED where it is turned inside out. */
enum hobe_status history_keep(hobe_history *history, struct genalpha *g, struct account *account,
                              double started, struct hobe_error *err);

#endif
