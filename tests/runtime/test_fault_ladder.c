/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A ladder whose models are formulas: its errors, its front and its converged run are those of the
 * formulas; and the same with memory running out anywhere. */
#include "check.h"
#include "fault.h"
#include "ladder.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { RUNGS = 12, FAILING = 8 };

/* A model of a case: Q = truth (1 + error/n^2), of the kind's own error, as dear as chance says. */
struct formula {
    double truth, error[3], seconds[RUNGS];
    int known; /* whether the case says its truth */
};

static double solve(const struct formula *f, int kind, double n)
{
    return f->truth * (1 + f->error[kind] / (n * n));
}

/* The place in the ladder of kind and mesh. */
static int place(int kind, double n)
{
    return 4 * kind + (int)lround(log2(n));
}

static void say_ladder(const struct formula *f, struct hobe_text *text)
{
    hobe_text_add(text, "quantity\tQ\t%a\n", f->known ? f->truth : NAN);
    hobe_text_add(text, "doubt\t0x0p+0\nreference\tkind\tb\ngroup\naxis\tkind\ta\tb\tc\n"
                        "axis\telements\t1\t2\t4\t8\ngroup\naxis\telements\t2\naxis\tkind\ta\n");
}

static enum hobe_status run(void *context, const char *words, int ask, struct ladder_record *record,
                            struct hobe_text *why, double *seconds, struct hobe_error *err)
{
    struct formula *f = context;
    struct hobe_text text = {0};
    char kind = 'a';
    int n = 1;
    *seconds = 1;
    if (ask)
        say_ladder(f, &text);
    else if (sscanf(words, "elements=%d kind=%c", &n, &kind) != 2 &&
             sscanf(words, "kind=%c elements=%d", &kind, &n) != 2)
        check_that(0, "a model is kind and elements, not %s", words);
    if (n == FAILING && kind == 'c')
        hobe_text_add(why, "no");
    const int at = n <= FAILING ? place(kind - 'a', n) : 0;
    hobe_text_add(&text, "value\tQ\tm\t%a\tnan\ncost\t0x1p-20\t%a\t%d\nmemory\t1e6\nend\n",
                  solve(f, kind - 'a', n), f->seconds[at], n);
    enum hobe_status status = hobe_text_check(&text, err);
    status = status ? status : ladder_record_read(text.at, text.size, record, err);
    hobe_text_free(&text);
    return status;
}

static struct formula draw(int known)
{
    struct formula f = {.truth = random_real(-5, -1), .known = known};
    for (int k = 0; k < 3; k++)
        f.error[k] = random_real(0.1, 1);
    for (int i = 0; i < RUNGS; i++)
        f.seconds[i] = random_real(1, 2);
    return f;
}

/* |Q - truth| of the rung at this place, relative */
static double error_of(const struct formula *f, int at, double truth)
{
    return fabs(solve(f, at / 4, exp2(at % 4)) / truth - 1);
}

/* Whether another model is better in cost and error, as far as the truth is known. */
static int is_beaten(const struct formula *f, int rung, double truth, double doubt)
{
    for (int i = 0; i < RUNGS - 1; i++) /* the last one fails */
        if (f->seconds[i] < f->seconds[rung] &&
            fmax(error_of(f, i, truth), doubt) <= fmax(error_of(f, rung, truth), doubt))
            return 1;
    return 0;
}

static void check_rung(const struct formula *f, const struct ladder *ladder,
                       const struct ladder_rung *rung)
{
    const double truth = ladder->quantity[0].truth;
    int n;
    char kind;
    if (!check_that(sscanf(rung->model, "elements=%d kind=%c", &n, &kind) == 2, "%s is a model",
                    rung->model))
        return;
    const int at = place(kind - 'a', n);
    check_that(!rung->why == (at != RUNGS - 1), "%s fails where it should", rung->model);
    if (rung->why)
        return;
    check_relative(rung->worst, error_of(f, at, truth), 1e-10, "error of %s", rung->model);
    check_relative(rung->time[LADDER_SOLVE].median, f->seconds[at], 1e-14, "time of %s",
                   rung->model);
    check_that(rung->front == !is_beaten(f, at, truth, ladder->doubt), "%s: front", rung->model);
    check_that(rung->rounds == LADDER_ROUNDS, "%s has all rounds", rung->model);
}

static struct ladder_options options_of(struct formula *f)
{
    return (struct ladder_options){.run = run, .context = f};
}

static void test_ladder(int known)
{
    struct formula f = draw(known);
    struct ladder ladder;
    struct hobe_error err;
    const struct ladder_options options = options_of(&f);
    if (ladder_climb(&options, &ladder, &err))
        check_stop("the ladder is not climbed: %s", err.message);
    check_that(ladder.rungs == RUNGS, "%d rungs, none twice", ladder.rungs);
    const double truth = known ? f.truth : solve(&f, 1, 32);
    check_relative(ladder.quantity[0].truth, truth, 1e-14, "the truth");
    if (!known)
        check_relative(ladder.reference.apart, fabs(solve(&f, 1, 16) / truth - 1), 1e-10,
                       "how far it has converged");
    for (int i = 0; i < ladder.rungs && i < RUNGS; i++)
        check_rung(&f, &ladder, &ladder.rung[i]);
    ladder_free(&ladder);
}

/* ---- a case that says no ladder ------------------------------------------------------------- */

/* What its report expects of Q: nothing, the truth to one percent, or what the model has. */
enum expected { NOTHING, TRUTH, MODEL };
struct plain {
    struct formula formula;
    enum expected expected;
    int fails; /* models of MGD30d2 */
};

static enum hobe_status run_plain(void *context, const char *words, int ask,
                                  struct ladder_record *record, struct hobe_text *why,
                                  double *seconds, struct hobe_error *err)
{
    const struct plain *plain = context;
    const struct formula *f = &plain->formula;
    struct hobe_text text = {0};
    char name[20] = "3333";
    int n = 1;
    *seconds = 1;
    if (!ask && sscanf(words, "--model=%19[^:]:%d", name, &n) != 2)
        check_that(0, "a model is --model=ELEMENT:ELEMENTS, not %s", words);
    const double value = solve(f, name[0] == '3' ? 0 : !strcmp(name, "MGD30w") ? 1 : 2, n);
    if (plain->fails && !strcmp(name, "MGD30d2"))
        hobe_text_add(why, "no");
    hobe_text_add(&text, "value\tQ\tm\t%a\t%a\t%a\ncost\t1\t1\t%d\nend\n", value,
                  plain->expected == TRUTH   ? f->truth
                  : plain->expected == MODEL ? value
                                             : NAN,
                  plain->expected ? 0.01 : NAN, n);
    enum hobe_status status = hobe_text_check(&text, err);
    status = status ? status : ladder_record_read(text.at, text.size, record, err);
    hobe_text_free(&text);
    return status;
}

static char name_3333[] = "3333", name_MGD30w[] = "MGD30w", one[] = "1", two[] = "2", three[] = "3";
static char element_axis[] = "element", elements_axis[] = "elements", other_axis[] = "P";
static char *elements_given[] = {name_3333, name_MGD30w}, *meshes_given[] = {one, two},
            *other_given[] = {three};
static const struct ladder_axis given[] = {{element_axis, 2, elements_given},
                                           {elements_axis, 2, meshes_given},
                                           {other_axis, 1, other_given}};

static void test_plain(enum expected expected, int fails, int common)
{
    struct plain plain = {draw(0), expected, fails};
    const struct ladder_options options = {
        .given = 2 + common, .axis = given, .run = run_plain, .context = &plain};
    struct ladder ladder;
    struct hobe_error err;
    if (ladder_climb(&options, &ladder, &err))
        check_stop("the ladder of a plain case is not climbed: %s", err.message);
    check_that(ladder.rungs == 4, "%d rungs", ladder.rungs);
    const int known = expected == TRUTH && !common;
    check_that((ladder.reference.model[1] == NULL) == known,
               "a converged run where nothing is known");
    if (!known)
        check_that(
            !strcmp(ladder.reference.model[1], fails ? "--model=MGD30d:8" : "--model=MGD30d2:8"),
            "%s is the reference", ladder.reference.model[1]);
    const double truth = known ? plain.formula.truth : solve(&plain.formula, 2, 8);
    check_relative(ladder.quantity[0].truth, truth, 1e-14, "the truth of a plain case");
    check_absolute(ladder.quantity[0].doubt, known ? 0.01 : 0, 1e-14, "its doubt");
    for (int i = 0; i < ladder.rungs; i++) {
        const struct ladder_rung *rung = &ladder.rung[i];
        int n = 0;
        char name[20] = "";
        sscanf(rung->model, "--model=%19[^:]:%d", name, &n);
        check_that(!strcmp(name, rung->kind), "%s is drawn as %s", rung->model, rung->kind);
        const double error = fabs(solve(&plain.formula, name[0] == 'M', n) / truth - 1);
        check_relative(rung->worst, error, 1e-10, "error of %s", rung->model);
        check_absolute(rung->excess, fmax(0, error - (known ? 0.01 : ladder.doubt)), 1e-12,
                       "its excess");
    }
    ladder_free(&ladder);
}

static enum hobe_status climb_plain(void *context, struct hobe_error *err)
{
    const struct ladder_options options = {
        .given = 3, .axis = given, .run = run_plain, .context = context};
    struct ladder ladder;
    enum hobe_status status = ladder_climb(&options, &ladder, err);
    ladder_free(&ladder);
    return status;
}

/* All of it, written as text, too. */
static enum hobe_status climb(void *context, struct hobe_error *err)
{
    static const struct ladder_case of = {"a.lua", "a machine"};
    const struct ladder_options options = options_of(context);
    struct ladder ladder;
    struct hobe_text text = {0};
    enum hobe_status status = ladder_climb(&options, &ladder, err);
    for (int format = LADDER_TABLE; !status && format <= LADDER_CSV; format++)
        ladder_text(&ladder, &of, (enum ladder_format)format, &text);
    status = status ? status : hobe_text_check(&text, err);
    hobe_text_free(&text);
    ladder_free(&ladder);
    return status;
}

int main(void)
{
    random_start();
    for (int i = 0; i < 20; i++)
        test_ladder(i % 2);
    for (int i = 0; i < 12; i++)
        test_plain((enum expected)(i % 3), i / 3 % 2, i / 6);
    struct formula f = draw(0);
    fail_each_allocation(climb, &f, 50, 3000, "a ladder");
    struct plain plain = {f, NOTHING, 1};
    fail_each_allocation(climb_plain, &plain, 50, 3000, "a ladder by --model");
    return check_report();
}
