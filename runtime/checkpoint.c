/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motions that go on from a journal, to the same bits.
 *
 *     record = struct mark, u, v, w, a, then for each state since the last record
 *              struct hobe_solution_info, struct hobe_energies, u, v, w
 *
 * with fields [vectors][3], in the memory layout of the program that wrote it. */
#include "dynamic.h"
#include "journal.h"
#include "output.h"
#include "solution.h"

#include <string.h>

struct mark {
    long vectors, states; /* of the model; in this record */
    struct stops stops;
    double wanted, error, largest, smallest_step;
    double time, step, begin; /* of genalpha_state */
    long steady, taken;
    double loads, drives, damped, start; /* of the account */
    struct hobe_history_info history;
    struct hobe_solution_info solver;
    double seconds; /* spent so far */
};

static struct mark mark_of(const struct run *run)
{
    const struct genalpha_state *now = &run->g.now;
    const struct account *account = &run->account;
    return (struct mark){.vectors = run->g.s.model->vectors,
                         .states = (long)(run->history->states.count - run->saved),
                         .stops = run->stops,
                         .wanted = run->wanted,
                         .error = run->error,
                         .largest = run->largest,
                         .smallest_step = run->options.smallest_step,
                         .time = now->time,
                         .step = now->step,
                         .begin = now->begin,
                         .steady = run->steady,
                         .taken = now->taken,
                         .loads = account->loads,
                         .drives = account->drives,
                         .damped = account->damped,
                         .start = account->start,
                         .history = run->history->info,
                         .solver = run->g.s.info,
                         .seconds = hobe_seconds() - run->started};
}

static void take_mark(struct run *run, const struct mark *mark)
{
    struct genalpha_state *now = &run->g.now;
    struct account *account = &run->account;
    run->stops = mark->stops;
    run->wanted = mark->wanted;
    run->error = mark->error;
    run->largest = mark->largest;
    run->steady = mark->steady;
    run->options.smallest_step = mark->smallest_step;
    now->time = mark->time;
    now->step = mark->step;
    now->begin = mark->begin;
    now->taken = mark->taken;
    account->loads = mark->loads;
    account->drives = mark->drives;
    account->damped = mark->damped;
    account->start = mark->start;
    run->history->info = mark->history;
    run->g.s.info = mark->solver;
    run->started = hobe_seconds() - mark->seconds;
}

/* What the steps to come do not keep: factors, and the forces at the begin of a step. */
static void begin_anew(struct run *run)
{
    genalpha_forget(&run->g);
    account_begin(&run->account, &run->g);
}

/* ---- to the journal -------------------------------------------------------------------------- */

static void add_field(struct hobe_text *record, const struct run *run, const double *field)
{
    hobe_text_bytes(record, (const char *)field,
                    (size_t)(3 * run->g.s.model->vectors) * sizeof *field);
}

static void add_state(struct hobe_text *record, const struct run *run, size_t i)
{
    const struct hobe_solution *state = hobe_history_state(run->history, (int)i);
    const struct hobe_energies *energies = hobe_history_energies(run->history, (int)i);
    hobe_text_bytes(record, (const char *)&state->info, sizeof state->info);
    hobe_text_bytes(record, (const char *)energies, sizeof *energies);
    for (int which = SOLUTION_U; which <= SOLUTION_W; which++)
        add_field(record, run, solution_field(state, run->g.s.model, which));
}

enum hobe_status checkpoint_save(struct run *run, struct hobe_error *err)
{
    const struct genalpha_state *now = &run->g.now;
    const struct mark mark = mark_of(run);
    struct hobe_text record = {0};
    begin_anew(run);
    if (!run->options.journal)
        return HOBE_OK;
    hobe_text_bytes(&record, (const char *)&mark, sizeof mark);
    add_field(&record, run, now->u);
    add_field(&record, run, now->v);
    add_field(&record, run, now->w);
    add_field(&record, run, now->a);
    for (; run->saved < run->history->states.count; run->saved++)
        add_state(&record, run, run->saved);
    enum hobe_status status = hobe_text_check(&record, err);
    if (!status)
        status = journal_add(run->options.journal, record.at, record.size, err);
    hobe_text_free(&record);
    return status;
}

/* ---- from the journal ------------------------------------------------------------------------ */

static const char *take_field(const struct run *run, const char *at, double *field)
{
    const size_t size = (size_t)(3 * run->g.s.model->vectors) * sizeof *field;
    memcpy(field, at, size);
    return at + size;
}

/* A record begins at a multiple of 8 bytes, and all of its parts are multiples of 8 bytes. */
static enum hobe_status take_state(struct run *run, const char **at, struct hobe_error *err)
{
    const hobe_model *model = run->g.s.model;
    const struct hobe_solution_info *info = (const void *)*at;
    const struct hobe_energies *energies = (const void *)(*at + sizeof *info);
    const double *field = (const void *)(*at + sizeof *info + sizeof *energies);
    const long n = 3 * model->vectors;
    hobe_solution *state = solution_new(model, field, field + n, field + 2 * n, info, err);
    const enum hobe_status status =
        state ? history_append(run->history, state, energies, err) : HOBE_NO_MEMORY;
    *at = (const char *)(field + 3 * n);
    return status;
}

static enum hobe_status take_record(struct run *run, const char *at, size_t size,
                                    struct hobe_error *err)
{
    struct genalpha_state *now = &run->g.now;
    const struct mark *mark = (const void *)at;
    const long vectors = run->g.s.model->vectors;
    const size_t field = (size_t)(3 * vectors) * sizeof(double);
    const size_t state =
        sizeof(struct hobe_solution_info) + sizeof(struct hobe_energies) + 3 * field;
    if (size < sizeof *mark || mark->vectors != vectors || mark->states < 0 ||
        size != sizeof *mark + 4 * field + (size_t)mark->states * state)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the motion to resume is of another scene; start anew without --resume");
    take_mark(run, mark);
    at = take_field(run, at + sizeof *mark, now->u);
    at = take_field(run, at, now->v);
    at = take_field(run, at, now->w);
    at = take_field(run, at, now->a);
    enum hobe_status status = HOBE_OK;
    for (long i = 0; !status && i < mark->states; i++)
        status = take_state(run, &at, err);
    return status;
}

enum hobe_status checkpoint_load(struct run *run, int *found, struct hobe_error *err)
{
    size_t size;
    const char *record;
    enum hobe_status status = HOBE_OK;
    *found = 0;
    while (!status && run->options.journal &&
           (record = journal_read(run->options.journal, &size))) {
        status = take_record(run, record, size, err);
        *found = 1;
    }
    run->saved = run->history->states.count;
    if (*found && !status)
        begin_anew(run);
    return status;
}
