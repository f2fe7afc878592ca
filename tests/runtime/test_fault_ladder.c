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
    struct formula f = draw(0);
    fail_each_allocation(climb, &f, 50, 3000, "a ladder");
    return check_report();
}
