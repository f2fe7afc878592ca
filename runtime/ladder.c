/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Climbs a ladder: runs its models in turn, and says how wrong and how dear each is. */
#include "ladder.h"

#include "advise.h"
#include "model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const int FEWEST_ROUNDS = 3;

/* s: as long as they take, rounds beyond the fewest are run. */
static const double LONG_ENOUGH = 10;

/* Meshes of the converged run, as multiples of the finest rung's. */
static const int CONVERGED_COARSE = 2, CONVERGED_FINE = 4;

/* Share of the largest truth of its unit that errors of a quantity are relative to at least. */
static const double SMALL = 0.01;

/* ---- quantities ----------------------------------------------------------------------------- */

static const struct ladder_line *find_value(const struct ladder_record *record, const char *name)
{
    const struct ladder_line *line;
    for (int i = 0; (line = ladder_find(record, "value", 5, i)); i++)
        if (!strcmp(line->word[1], name))
            return line;
    return NULL;
}

static enum hobe_status add_quantity(struct ladder *ladder, const char *name, double truth,
                                     struct hobe_error *err)
{
    struct ladder_quantity *quantity = &ladder->quantity[ladder->quantities++];
    *quantity = (struct ladder_quantity){ladder_copy(name, err), NULL, truth, NAN, NAN, 0, 0};
    return quantity->name ? HOBE_OK : HOBE_NO_MEMORY;
}

/* Those that the case names; else those of the report that have an expected value; else all. */
static enum hobe_status read_quantities(const struct ladder_record *record, struct ladder *ladder,
                                        struct hobe_error *err)
{
    const struct ladder_line *line;
    enum hobe_status status = HOBE_OK;
    ladder->quantity = hobe_alloc((size_t)record->lines, sizeof *ladder->quantity, err);
    if (!ladder->quantity)
        return HOBE_NO_MEMORY;
    for (int i = 0; !status && (line = ladder_find(record, "quantity", 3, i)); i++)
        status = add_quantity(ladder, line->word[1], ladder_number(line->word[2]), err);
    for (int all = 0; all < 2 && ladder->quantities == 0; all++)
        for (int i = 0; !status && (line = ladder_find(record, "value", 5, i)); i++)
            if (all || !isnan(ladder_number(line->word[4])))
                status = add_quantity(ladder, line->word[1], NAN, err);
    if (!status && ladder->quantities == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the case reports no value; a chart shows the errors of hobe.report's");
    return status;
}

/* The quantities of a run, and what it says of them; a sentence where it lacks one. */
static enum hobe_status read_values(struct ladder *ladder, const struct ladder_record *record,
                                    double *value, struct hobe_text *why, struct hobe_error *err)
{
    for (int q = 0; q < ladder->quantities; q++) {
        struct ladder_quantity *quantity = &ladder->quantity[q];
        const struct ladder_line *line = find_value(record, quantity->name);
        value[q] = line ? ladder_number(line->word[3]) : NAN;
        if (!isfinite(value[q])) {
            hobe_text_add(why, "it reports no number for %s", quantity->name);
            return hobe_text_check(why, err);
        }
        if (quantity->unit) {
            if (ladder_number(line->word[4]) != quantity->expect)
                quantity->expect = NAN; /* it is of a model, and not the truth */
            continue;
        }
        quantity->expect = ladder_number(line->word[4]);
        quantity->within = line->words > 5 ? ladder_number(line->word[5]) : NAN;
        if (!(quantity->unit = ladder_copy(line->word[2], err)))
            return HOBE_NO_MEMORY;
    }
    return HOBE_OK;
}

/* ---- runs ----------------------------------------------------------------------------------- */

/* One run of a model and what is common to all: its record, to be freed, and its sentence where it
 * fails. */
static enum hobe_status run(const struct ladder_options *options, const struct ladder *ladder,
                            const char *what, const char *model, struct ladder_record *record,
                            struct hobe_text *why, double *seconds, struct hobe_error *err)
{
    struct hobe_text words = {0};
    *record = (struct ladder_record){0};
    hobe_text_add(&words, "%s%s", model, ladder->common.at ? ladder->common.at : "");
    const char *said = words.at ? words.at : "";
    enum hobe_status status = hobe_text_check(&words, err);
    if (!status && options->progress)
        options->progress(what, said);
    if (!status)
        status = options->run(options->context, said, ladder->quantities == 0, record, why, seconds,
                              err);
    hobe_text_free(&words);
    return status ? status : hobe_text_check(why, err);
}

/* Asks the case, at the first values given, what it measures and which models it has. */
static enum hobe_status ask(const struct ladder_options *options, struct ladder *ladder,
                            struct ladder_record *record, struct hobe_error *err)
{
    struct hobe_text why = {0}, words = {0};
    double seconds;
    for (int i = 0; i < options->given; i++)
        hobe_text_add(&words, " %s=%s", options->axis[i].name, options->axis[i].value[0]);
    enum hobe_status status = hobe_text_check(&words, err);
    if (!status)
        status =
            run(options, ladder, "asking", words.at ? words.at : "", record, &why, &seconds, err);
    if (!status && why.size > 0)
        status = hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s", why.at);
    hobe_text_free(&why);
    hobe_text_free(&words);
    status = status ? status : read_quantities(record, ladder, err);
    return status ? status : ladder_make_rungs(options, record, ladder, err);
}

/* Adds the clocks of a run to its rung; 0 with the sentence where they stood still. */
static int keep_clocks(struct ladder_rung *rung, const struct ladder_record *record,
                       struct hobe_text *why)
{
    const struct ladder_line *cost = ladder_find(record, "cost", 4, 0);
    const struct ladder_line *memory = ladder_find(record, "memory", 2, 0);
    const double setup = cost ? ladder_number(cost->word[1]) : 0,
                 solve = cost ? ladder_number(cost->word[2]) : 0;
    if (!(setup + solve > 0)) {
        hobe_text_add(why, "it solves no scene, so that its cost is not known");
        return 0;
    }
    rung->sample[LADDER_SETUP][rung->rounds] = setup;
    rung->sample[LADDER_SOLVE][rung->rounds] = solve;
    rung->sample[LADDER_TOTAL][rung->rounds] = setup + solve;
    rung->rounds++;
    rung->unknowns = ladder_number(cost->word[3]);
    rung->bytes = fmax(rung->bytes, memory ? ladder_number(memory->word[1]) : 0);
    return 1;
}

static enum hobe_status run_rung(const struct ladder_options *options, struct ladder *ladder,
                                 struct ladder_rung *rung, const char *what, struct hobe_error *err)
{
    struct ladder_record record;
    struct hobe_text why = {0};
    enum hobe_status status =
        run(options, ladder, what, rung->model, &record, &why, &rung->wasted, err);
    if (!status && why.size == 0)
        status = read_values(ladder, &record, rung->value, &why, err);
    const int done = !status && why.size == 0 && keep_clocks(rung, &record, &why);
    if (!status && !done && !(rung->why = ladder_copy(why.at ? why.at : "", err)))
        status = HOBE_NO_MEMORY;
    ladder_record_free(&record);
    hobe_text_free(&why);
    return status;
}

/* An error where no rung is left. */
static enum hobe_status check_rungs(const struct ladder *ladder, struct hobe_error *err)
{
    for (int i = 0; i < ladder->rungs; i++)
        if (!ladder->rung[i].why)
            return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL, "no model runs; the first, %s, fails with: %s",
                     ladder->rung[0].model, ladder->rung[0].why);
}

static enum hobe_status run_rounds(const struct ladder_options *options, struct ladder *ladder,
                                   struct hobe_error *err)
{
    const double start = hobe_seconds();
    enum hobe_status status = HOBE_OK;
    for (int round = 0; !status && round < LADDER_ROUNDS; round++) {
        char what[80];
        if (round >= FEWEST_ROUNDS && (options->quick || hobe_seconds() - start > LONG_ENOUGH))
            break;
        for (int i = 0; !status && i < ladder->rungs; i++) {
            snprintf(what, sizeof what, "round %d, %d of %d:", round + 1, i + 1, ladder->rungs);
            if (!ladder->rung[i].why)
                status = run_rung(options, ladder, &ladder->rung[i], what, err);
        }
        status = status ? status : check_rungs(ladder, err);
    }
    return status;
}

/* ---- the truth ------------------------------------------------------------------------------ */

double ladder_scale(const struct ladder *ladder, int q)
{
    const struct ladder_quantity *of = &ladder->quantity[q];
    double most = 0;
    for (int i = 0; i < ladder->quantities; i++)
        if (!strcmp(ladder->quantity[i].unit, of->unit))
            most = fmax(most, fabs(ladder->quantity[i].truth));
    return most > 0 ? fmax(fabs(of->truth), SMALL * most) : 1;
}

/* Whether a converged run of an element would fail, or take too long, as its finest rung does. */
static int is_dear(const struct ladder *ladder, const char *element)
{
    char model[ADVISE_WORD];
    snprintf(model, sizeof model, "--model=%s:%.0f", element, ladder_most(ladder));
    for (int i = 0; i < ladder->rungs; i++) {
        const struct ladder_rung *rung = &ladder->rung[i];
        if (!strcmp(rung->model, model))
            return rung->why || CONVERGED_FINE * rung->sample[LADDER_TOTAL][0] > LONG_ENOUGH;
    }
    return 0;
}

/* The elements that may stand for the truth, in turn: the case's, by its own words (NULL), or the
 * one that has most modes of the section, or fewer where that does not run or takes too long:
 * element[ADVISE_LEVELS], their number. */
static int list_elements(const struct ladder_record *record, const struct ladder *ladder,
                         const char **element)
{
    const struct hobe_kernel *level[ADVISE_LEVELS];
    const struct ladder_line *line;
    element[0] = NULL;
    if (!ladder->by_model)
        return 1;
    for (int i = 0; (line = ladder_find(record, "reference", 3, i)); i++)
        if (!strcmp(line->word[1], "element")) {
            element[0] = line->word[2];
            return 1;
        }
    int count = 0;
    for (int i = advise_levels(level) - 1; i >= 0; i--)
        if (i == 0 || !is_dear(ladder, level[i]->name))
            element[count++] = level[i]->name;
    return count;
}

/* Says the reference model: the case's words for it, with so many elements. */
static void say_reference(const struct ladder_record *record, const char *element, double elements,
                          struct hobe_text *words)
{
    const struct ladder_line *line;
    for (int i = 0; (line = ladder_find(record, "reference", 3, i)); i++)
        if (strcmp(line->word[1], "elements") && (!element || strcmp(line->word[1], "element")))
            hobe_text_add(words, "%s%s=%s", words->size > 0 ? " " : "", line->word[1],
                          line->word[2]);
    hobe_text_add(words, "%s", words->size > 0 ? " " : "");
    if (element)
        hobe_text_add(words, "--model=%s:%.0f", element, elements);
    else
        hobe_text_add(words, "elements=%.0f", elements);
}

/* The meshes of the two converged runs: that which the case names, and twice it. */
static int choose_meshes(const struct ladder_record *record, const struct ladder *ladder,
                         double *elements)
{
    const struct ladder_line *line;
    const double most = ladder_most(ladder);
    elements[0] = CONVERGED_COARSE * most;
    elements[1] = CONVERGED_FINE * most;
    for (int i = 0; (line = ladder_find(record, "reference", 3, i)); i++)
        if (!strcmp(line->word[1], "elements")) {
            elements[0] = ladder_number(line->word[2]);
            elements[1] = 2 * elements[0];
        }
    return elements[0] >= 1;
}

/* Runs the k-th of the two models that stand for the truth: value[quantities], or a sentence where
 * it fails. */
static enum hobe_status run_reference(const struct ladder_options *options,
                                      const struct ladder_record *record, const char *element,
                                      double elements, int k, struct ladder *ladder, double *value,
                                      struct hobe_text *why, struct hobe_error *err)
{
    struct ladder_record run_record;
    struct hobe_text words = {0};
    double seconds;
    say_reference(record, element, elements, &words);
    enum hobe_status status = hobe_text_check(&words, err);
    hobe_free(ladder->reference.model[k]);
    ladder->reference.model[k] = status ? NULL : ladder_copy(words.at, err);
    hobe_text_free(&words);
    if (!ladder->reference.model[k])
        return HOBE_NO_MEMORY;
    status = run(options, ladder, "reference:", ladder->reference.model[k], &run_record, why,
                 &seconds, err);
    if (!status && why->size == 0)
        status = read_values(ladder, &run_record, value, why, err);
    ladder_record_free(&run_record);
    return status;
}

/* Runs both, by the first element for which they run: value[2][quantities]. */
static enum hobe_status run_references(const struct ladder_options *options,
                                       const struct ladder_record *record, const double *elements,
                                       struct ladder *ladder, double *value, struct hobe_error *err)
{
    const char *element[ADVISE_LEVELS];
    const int count = list_elements(record, ladder, element);
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < count; i++) {
        struct hobe_text why = {0};
        int k = 0;
        for (; !status && k < 2 && why.size == 0; k++)
            status = run_reference(options, record, element[i], elements[k], k, ladder,
                                   value + (size_t)(k * ladder->quantities), &why, err);
        const int done = why.size == 0;
        if (!status && !done && i + 1 == count)
            status = hobe_fail(err, HOBE_BAD_INPUT, NULL, "the reference, %s, fails: %s",
                               ladder->reference.model[k - 1], why.at ? why.at : "");
        hobe_text_free(&why);
        if (done)
            break;
    }
    return status;
}

/* Makes a converged run stand for what nobody knows. */
static enum hobe_status converge(const struct ladder_options *options,
                                 const struct ladder_record *record, struct ladder *ladder,
                                 struct hobe_error *err)
{
    const size_t n = (size_t)ladder->quantities;
    double elements[2];
    if (!choose_meshes(record, ladder, elements))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the truth is not known, and there is no parameter elements along which a "
                         "run would converge; hobe.chart takes truth = {name = value}");
    double *value = hobe_alloc(2 * n, sizeof *value, err);
    enum hobe_status status =
        value ? run_references(options, record, elements, ladder, value, err) : HOBE_NO_MEMORY;
    for (size_t q = 0; !status && q < n; q++) {
        struct ladder_quantity *quantity = &ladder->quantity[q];
        quantity->open = isnan(quantity->truth) ? fabs(value[n + q] - value[q]) : 0;
        quantity->truth = isnan(quantity->truth) ? value[n + q] : quantity->truth;
    }
    hobe_free(value);
    for (int q = 0; !status && q < ladder->quantities; q++)
        ladder->reference.apart =
            fmax(ladder->reference.apart, ladder->quantity[q].open / ladder_scale(ladder, q));
    ladder->doubt = fmax(ladder->doubt, ladder->reference.apart);
    return status;
}

/* Takes what the case expects for the truth where nothing else is given, and what it calls right
 * for how far that is known, unless it says; whether all are known. */
static int take_expected(struct ladder *ladder)
{
    int known = 1, doubted = ladder->doubt > 0;
    for (int q = 0; q < ladder->quantities; q++) {
        struct ladder_quantity *quantity = &ladder->quantity[q];
        if (isnan(quantity->truth) && ladder->common.size == 0 && !isnan(quantity->expect)) {
            quantity->truth = quantity->expect;
            if (!doubted && quantity->within > 0)
                quantity->doubt = quantity->within;
        }
        known = known && !isnan(quantity->truth);
    }
    return known;
}

/* The truth that is not given: what the case expects, else what a converged run finds. */
static enum hobe_status find_truth(const struct ladder_options *options,
                                   const struct ladder_record *record, struct ladder *ladder,
                                   struct hobe_error *err)
{
    const struct ladder_line *doubt = ladder_find(record, "doubt", 2, 0);
    ladder->doubt = doubt ? ladder_number(doubt->word[1]) : 0;
    return take_expected(ladder) ? HOBE_OK : converge(options, record, ladder, err);
}

/* ---- errors, cost and the front ------------------------------------------------------------- */

static void weigh(const struct ladder *ladder, struct ladder_rung *rung)
{
    for (int t = 0; t < LADDER_TIMES; t++)
        rung->time[t] =
            bench_time(&(struct bench_work){.rounds = rung->rounds, .sample = rung->sample[t]});
    for (int q = 0; q < ladder->quantities; q++) {
        rung->error[q] = fabs(rung->value[q] - ladder->quantity[q].truth) / ladder_scale(ladder, q);
        rung->worst = fmax(rung->worst, rung->error[q]);
        rung->excess =
            fmax(rung->excess, rung->error[q] - fmax(ladder->doubt, ladder->quantity[q].doubt));
    }
}

/* By cost, and by error where that is the same; those that failed behind. */
static int by_cost(const void *a, const void *b)
{
    const struct ladder_rung *x = a, *y = b;
    if (!x->why != !y->why)
        return !x->why ? -1 : 1;
    const double s = x->time[LADDER_TOTAL].median, t = y->time[LADDER_TOTAL].median;
    return s != t ? (s > t) - (s < t) : (x->worst > y->worst) - (x->worst < y->worst);
}

/* Pareto's: in the order of cost, those which are better than all before. */
static void draw_front(struct ladder *ladder)
{
    double best = INFINITY;
    for (int i = 0; i < ladder->rungs && !ladder->rung[i].why; i++) {
        ladder->rung[i].front = ladder->rung[i].excess < best;
        best = fmin(best, ladder->rung[i].excess);
    }
}

enum hobe_status ladder_climb(const struct ladder_options *options, struct ladder *ladder,
                              struct hobe_error *err)
{
    struct ladder_record record = {0};
    *ladder = (struct ladder){0};
    enum hobe_status status = ask(options, ladder, &record, err);
    status = status ? status : run_rounds(options, ladder, err);
    status = status ? status : find_truth(options, &record, ladder, err);
    ladder_record_free(&record);
    if (options->progress)
        options->progress("", "");
    if (status)
        return status;
    for (int i = 0; i < ladder->rungs; i++)
        if (!ladder->rung[i].why)
            weigh(ladder, &ladder->rung[i]);
    qsort(ladder->rung, (size_t)ladder->rungs, sizeof *ladder->rung, by_cost);
    draw_front(ladder);
    return HOBE_OK;
}

void ladder_free(struct ladder *ladder)
{
    for (int q = 0; q < ladder->quantities; q++) {
        hobe_free(ladder->quantity[q].name);
        hobe_free(ladder->quantity[q].unit);
    }
    for (int i = 0; i < ladder->rungs; i++) {
        hobe_free(ladder->rung[i].model);
        hobe_free(ladder->rung[i].kind);
        hobe_free(ladder->rung[i].why);
        hobe_free(ladder->rung[i].value);
        hobe_free(ladder->rung[i].error);
    }
    for (int k = 0; k < 2; k++)
        hobe_free(ladder->reference.model[k]);
    ladder_free_groups(ladder);
    hobe_text_free(&ladder->common);
    hobe_free(ladder->quantity);
    hobe_free(ladder->rung);
    *ladder = (struct ladder){0};
}
