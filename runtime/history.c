/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "assemble.h"
#include "constraint.h"
#include "damping.h"
#include "load.h"
#include "mass.h"
#include "reduction.h"
#include "solution.h"
#include "spring.h"
#include "trust.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

enum { FIRST_ASKED = 20 };

/* ---- work ----------------------------------------------------------------------------------- */

enum hobe_status account_open(struct account *account, const hobe_model *model,
                              struct hobe_error *err)
{
    const size_t size = (size_t)(3 * model->vectors);
    *account = (struct account){.Q = hobe_alloc(size, sizeof(double), err),
                                .Q1 = hobe_alloc(size, sizeof(double), err),
                                .rate = hobe_alloc(size, sizeof(double), err)};
    return account->Q && account->Q1 && account->rate ? HOBE_OK : HOBE_NO_MEMORY;
}

void account_close(struct account *account)
{
    hobe_free(account->Q);
    hobe_free(account->Q1);
    hobe_free(account->rate);
}

static void sum_loads(const hobe_model *model, const double *u, const struct instant *instant,
                      double *Q)
{
    memset(Q, 0, (size_t)(3 * model->vectors) * sizeof *Q);
    load_subtract(model, u, instant, -1, Q, NULL);
}

/* lambda . Phi_t of drives, and what damping takes. */
static struct power find_power(const hobe_model *model, const double *u,
                               const struct instant *instant, double *rate)
{
    struct power power = {.damped = damping_power(model, u, instant->v)};
    memset(rate, 0, (size_t)(3 * model->vectors) * sizeof *rate);
    constraint_rate(model, u, instant, rate);
    for (long i = 3 * model->moving; i < 3 * model->vectors; i++)
        power.drives += u[i] * rate[i];
    return power;
}

void account_begin(struct account *account, const struct genalpha *g)
{
    const struct instant instant = {g->now.time, g->now.v, 0, 0};
    sum_loads(g->s.model, g->now.u, &instant, account->Q);
    account->power = find_power(g->s.model, g->now.u, &instant, account->rate);
}

void account_step(struct account *account, const struct genalpha *g)
{
    const hobe_model *model = g->s.model;
    const struct instant instant = {g->s.motion.instant.time, g->v, 0, 0};
    const struct power power = find_power(model, g->s.u, &instant, account->rate);
    double *Q = account->Q;
    sum_loads(model, g->s.u, &instant, account->Q1);
    for (long v = 0; v < model->moving; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const long i = 3 * v + a;
            account->loads += (Q[i] + account->Q1[i]) / 2 * (g->s.u[i] - g->now.u[i]);
        }
    account->drives += g->now.step * (account->power.drives + power.drives) / 2;
    account->damped += g->now.step * (account->power.damped + power.damped) / 2;
    account->power = power;
    account->Q = account->Q1;
    account->Q1 = Q;
}

/* ---- what is conserved ---------------------------------------------------------------------- */

/* Linear momentum, and q x M v of all nodal vectors. */
static void sum_momenta(struct genalpha *g, struct hobe_energies *e)
{
    const hobe_model *model = g->s.model;
    double *q = g->w, *p = g->force;
    if (model->reduction) {
        reduction_momenta(model, g->now.u, g->now.v, e->momentum, e->angular_momentum);
        return;
    }
    memset(p, 0, (size_t)(3 * model->vectors) * sizeof *p);
    mass_force(model, 1, g->now.v, p);
    for (int a = 0; a < 3; a++) {
        mass_translation(model, a, q);
        e->momentum[a] = dot(3 * model->moving, q, p);
    }
    model_reference(model, q);
    for (long v = 0; v < model->moving; v++) {
        double couple[3];
        for (int a = 0; a < 3; a++)
            q[3 * v + a] += g->now.u[3 * v + a];
        cross3(q + 3 * v, p + 3 * v, couple);
        for (int a = 0; a < 3; a++)
            e->angular_momentum[a] += couple[a];
    }
}

static struct hobe_energies measure(struct genalpha *g, const struct account *account)
{
    const hobe_model *model = g->s.model;
    struct hobe_energies e = {.time = g->now.time,
                              .kinetic = mass_product(model, g->now.v, g->now.v) / 2,
                              .strain =
                                  assemble_energy(model, g->now.u) + spring_energy(model, g->now.u),
                              .loads = account->loads,
                              .drives = account->drives,
                              .damped = account->damped};
    const struct instant instant = {g->now.time, g->now.v, 0, 0};
    sum_momenta(g, &e);
    settle_rate(g, &g->now, g->s.u, g->force, g->w);
    e.violation_rate = genalpha_violation(g, g->w);
    memset(g->w, 0, (size_t)(3 * model->vectors) * sizeof *g->w);
    constraint_add(model, g->now.u, &instant, g->w, NULL);
    e.violation = genalpha_violation(g, g->w);
    return e;
}

/* ---- states --------------------------------------------------------------------------------- */

enum hobe_status history_append(hobe_history *history, hobe_solution *state,
                                const struct hobe_energies *energies, struct hobe_error *err)
{
    hobe_solution **to = list_append(&history->states, sizeof *to, err);
    struct hobe_energies *of = to ? list_append(&history->energies, sizeof *of, err) : NULL;
    if (to)
        *to = state;
    else
        hobe_solution_free(state);
    if (!of)
        return HOBE_NO_MEMORY;
    *of = *energies;
    history->info.states = (int)history->states.count;
    return HOBE_OK;
}

/* The state now with what a result knows of it; NULL with err set. */
static hobe_solution *new_state(struct genalpha *g, double started, struct hobe_error *err)
{
    struct hobe_solution_info info = g->s.info;
    info.load = 1;
    info.time = g->now.time;
    info.seconds = hobe_seconds() - started;
    if (solution_smallest_volume(g->s.model, g->now.u, &info.smallest_volume, err))
        return NULL;
    if (info.smallest_volume > 0)
        return solution_new(g->s.model, g->now.u, g->now.v, g->now.w, &info, err);
    hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
              "a beam is turned inside out at t = %g s (det F = %g); take smaller steps, more "
              "elements, or smaller loads",
              info.time, info.smallest_volume);
    return NULL;
}

/* The first states of a reduced model, and then every tenth, are asked, each by factors of the
 * whole model.  What went astray does not come back: a state has the largest indicator so far. */
static enum hobe_status ask(hobe_history *history, const hobe_model *model, hobe_solution *state,
                            struct hobe_error *err)
{
    const size_t count = history->states.count;
    enum hobe_status status = HOBE_OK;
    if (model->reduction && state->info.time > 0 && (count <= FIRST_ASKED || count % 10 == 0))
        status = trust_ask(model->reduction->whole, state, &history->size, err);
    history->indicator = fmax(history->indicator, state->info.indicator); /* NaN: not asked */
    state->info.indicator = history->indicator;
    return status;
}

enum hobe_status history_keep(hobe_history *history, struct genalpha *g, struct account *account,
                              double started, struct hobe_error *err)
{
    struct hobe_energies e = measure(g, account);
    const enum hobe_status failed = model_failure(g->s.model, err);
    if (failed)
        return failed;
    if (history->energies.count == 0)
        account->start = e.kinetic + e.strain;
    e.balance = e.kinetic + e.strain - account->start - e.loads - e.drives + e.damped;
    g->s.info.energy = e.strain;
    hobe_solution *state = new_state(g, started, err);
    if (!state)
        return err ? err->status : HOBE_NO_MEMORY;
    if (ask(history, g->s.model, state, err)) {
        hobe_solution_free(state);
        return HOBE_NO_MEMORY;
    }
    return history_append(history, state, &e, err);
}

/* ---- what is given -------------------------------------------------------------------------- */

void hobe_history_free(hobe_history *history)
{
    if (!history)
        return;
    solutions_free(&history->states);
    hobe_free(history->energies.item);
    hobe_free(history);
}

void hobe_history_info(const hobe_history *history, struct hobe_history_info *info)
{
    *info = history->info;
}

const hobe_solution *hobe_history_state(const hobe_history *history, int i)
{
    return solutions_get(&history->states, i);
}

hobe_solution *hobe_history_take(hobe_history *history, int i)
{
    return solutions_take(&history->states, i);
}

const struct hobe_energies *hobe_history_energies(const hobe_history *history, int i)
{
    return i >= 0 && (size_t)i < history->energies.count
               ? (const struct hobe_energies *)history->energies.item + i
               : NULL;
}
