/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a ladder: tables and the picture of error against time. */
#include "ladder.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- tables --------------------------------------------------------------------------------- */

/* The number as it is, or with so many digits. */
static double rounded(double x, int digits)
{
    char text[40];
    snprintf(text, sizeof text, "%.*g", digits, x);
    return digits > 0 ? strtod(text, NULL) : x;
}

/* A table that grows cell by cell; texts of its own live in `words`, one after another. */
struct sheet {
    const char **head;
    struct hobe_cell *cell;
    char (*name)[120]; /* [columns] heads made here */
    size_t columns, cells, names;
    int digits; /* of numbers; 0: all */
};

static void add_number(struct sheet *s, double x)
{
    s->cell[s->cells++] = (struct hobe_cell){NULL, rounded(x, s->digits)};
}

static void add_word(struct sheet *s, const char *word)
{
    s->cell[s->cells++] = (struct hobe_cell){word, 0};
}

static void add_head(struct sheet *s, const char *head, const char *ending)
{
    char *name = s->name[s->names++];
    snprintf(name, sizeof *s->name, "%s%s", head, ending);
    s->head[s->columns++] = name;
}

/* Clocks, memory and place of a rung, in the table and in the file. */
enum { TIME, SETUP, SOLVE, SPREAD, UNKNOWNS, MEMORY, COSTS };
static const char *const cost_head[COSTS] = {"time, ms",  "set-up, ms", "solve, ms",
                                             "spread, %", "unknowns",   "MB"};

static void add_costs(struct sheet *s, const struct ladder_rung *rung)
{
    const double cost[COSTS] = {
        [TIME] = 1e3 * rung->time[LADDER_TOTAL].median,
        [SETUP] = 1e3 * rung->time[LADDER_SETUP].median,
        [SOLVE] = 1e3 * rung->time[LADDER_SOLVE].median,
        [SPREAD] = 100 * rung->time[LADDER_TOTAL].spread,
        [UNKNOWNS] = rung->unknowns,
        [MEMORY] = 1e-6 * rung->bytes,
    };
    for (int i = 0; i < COSTS; i++)
        if (rung->why)
            add_word(s, "");
        else if (i == UNKNOWNS)
            s->cell[s->cells++] = (struct hobe_cell){NULL, cost[i]};
        else
            add_number(s, cost[i]);
}

static void add_errors(const struct ladder *ladder, const struct ladder_rung *rung, int values,
                       struct sheet *s)
{
    for (int q = 0; q < ladder->quantities; q++) {
        if (values && rung->why)
            add_word(s, "");
        else if (values)
            add_number(s, rung->value[q]);
        if (rung->why)
            add_word(s, "");
        else
            add_number(s, rung->error[q]);
    }
    if (rung->why)
        add_word(s, "");
    else
        add_number(s, rung->worst);
}

static void add_heads(const struct ladder *ladder, int values, struct sheet *s)
{
    add_head(s, "model", "");
    for (int i = 0; i < COSTS; i++)
        add_head(s, cost_head[i], "");
    for (int q = 0; q < ladder->quantities; q++) {
        if (values)
            add_head(s, ladder->quantity[q].name, "");
        add_head(s, "error of ", ladder->quantity[q].name);
    }
    add_head(s, "largest error", "");
    add_head(s, "front", "");
    add_head(s, "failure", "");
    if (values)
        add_head(s, "command", "");
}

static void say_command(const struct ladder *ladder, const struct ladder_case *of,
                        const char *model, struct hobe_text *text)
{
    hobe_text_add(text, "hobe run %s%s %s", of->script, ladder->common.at ? ladder->common.at : "",
                  model);
}

/* The file of the script and what all models share. */
static void say_case(const struct ladder *ladder, const struct ladder_case *of,
                     struct hobe_text *text)
{
    const char *slash = strrchr(of->script, '/');
    hobe_text_add(text, "%s%s", slash ? slash + 1 : of->script,
                  ladder->common.at ? ladder->common.at : "");
}

/* Prints all rungs: for people, or with all that is known. */
static void add_sheet(const struct ladder *ladder, const struct ladder_case *of, int everything,
                      const char *title,
                      void (*print)(struct hobe_text *, const struct hobe_table *),
                      struct hobe_text *text)
{
    const size_t most = (size_t)(11 + 2 * ladder->quantities), rungs = (size_t)ladder->rungs;
    struct sheet s = {hobe_alloc(most, sizeof *s.head, NULL),
                      hobe_alloc(most * rungs, sizeof *s.cell, NULL),
                      hobe_alloc(most, sizeof *s.name, NULL),
                      0,
                      0,
                      0,
                      everything ? 0 : 3};
    struct hobe_text *command = hobe_alloc(rungs, sizeof *command, NULL);
    if (!s.head || !s.cell || !s.name || !command)
        text->status = HOBE_NO_MEMORY;
    else
        add_heads(ladder, everything, &s);
    for (size_t i = 0; !text->status && i < rungs; i++) {
        const struct ladder_rung *rung = &ladder->rung[i];
        add_word(&s, rung->model);
        add_costs(&s, rung);
        add_errors(ladder, rung, everything, &s);
        add_word(&s, rung->front ? "yes" : "");
        add_word(&s, rung->why ? rung->why : "");
        say_command(ladder, of, rung->model, &command[i]);
        text->status = command[i].status;
        if (everything)
            add_word(&s, command[i].at);
    }
    if (!text->status)
        print(text, &(struct hobe_table){title, s.columns, rungs, s.head, s.cell});
    for (size_t i = 0; command && i < rungs; i++)
        hobe_text_free(&command[i]);
    hobe_free(command);
    hobe_free(s.head);
    hobe_free(s.cell);
    hobe_free(s.name);
}

static void add_truth(const struct ladder *ladder, struct hobe_text *text)
{
    hobe_text_add(text, "truth:");
    for (int q = 0; q < ladder->quantities; q++) {
        const struct ladder_quantity *quantity = &ladder->quantity[q];
        hobe_text_add(text, "%s %s %.7g%s%s", q > 0 ? "," : "", quantity->name, quantity->truth,
                      *quantity->unit ? " " : "", quantity->unit);
        if (quantity->doubt > 0)
            hobe_text_add(text, " (to %.2g)", quantity->doubt);
    }
    if (ladder->doubt > 0)
        hobe_text_add(text, "; errors below %.2g say nothing", ladder->doubt);
    if (ladder->reference.model[1])
        hobe_text_add(text, "\n    of %s, from which %s differs by %.2g",
                      ladder->reference.model[1], ladder->reference.model[0],
                      ladder->reference.apart);
    hobe_text_add(text, "\n");
}

static void add_all(const struct ladder *ladder, const struct ladder_case *of,
                    struct hobe_text *text)
{
    say_case(ladder, of, text);
    hobe_text_add(text, ": %d models, %s\n", ladder->rungs, of->machine);
    add_truth(ladder, text);
    hobe_text_add(text, "each by: ");
    say_command(ladder, of, "MODEL\n\n", text);
    add_sheet(ladder, of, 0, NULL, hobe_table_text, text);
}

void ladder_text(const struct ladder *ladder, const struct ladder_case *of,
                 enum ladder_format format, struct hobe_text *text)
{
    if (format == LADDER_TABLE)
        add_all(ladder, of, text);
    else
        add_sheet(ladder, of, 1, "chart", format == LADDER_CSV ? hobe_table_csv : hobe_table_json,
                  text);
}

/* ---- the picture ---------------------------------------------------------------------------- */

/* What can be shown of an error on a logarithmic axis. */
static const double LEAST_ERROR = 1e-16;

/* The picture while it is made: points x, y of one series after another. */
struct drawing {
    double *x, *y, edge; /* edge: the y of failures */
    struct hobe_series *series;
    size_t points, count;
};

static double height(const struct ladder_rung *rung)
{
    return fmax(rung->worst, LEAST_ERROR);
}

static void add_point(struct drawing *d, double x, double y)
{
    d->x[d->points] = x;
    d->y[d->points++] = y;
}

/* Ends the series that has the points from `first` on. */
static void add_series(struct drawing *d, const char *label, enum hobe_style style, int colour,
                       size_t first)
{
    if (d->points > first)
        d->series[d->count++] = (struct hobe_series){
            label, style, colour, d->points - first, d->x + first, d->y + first};
}

/* Points of all rungs of a kind, and crosses on the edge for those that failed. */
static void add_kind(const struct ladder *ladder, const char *kind, int colour, struct drawing *d)
{
    for (int failed = 0; failed < 2; failed++) {
        const size_t first = d->points;
        for (int i = 0; i < ladder->rungs; i++) {
            const struct ladder_rung *rung = &ladder->rung[i];
            if ((rung->why != NULL) != failed || strcmp(rung->kind, kind))
                continue;
            if (failed)
                add_point(d, rung->wasted, d->edge);
            else
                add_point(d, rung->time[LADDER_TOTAL].median, height(rung));
        }
        add_series(d, failed ? NULL : kind, failed ? HOBE_STYLE_CROSSES : HOBE_STYLE_POINTS, colour,
                   first);
    }
}

/* The rung that was the p-th before they were sorted, so that colours do not depend on times. */
static const struct ladder_rung *at_place(const struct ladder *ladder, int p)
{
    int i = 0;
    while (ladder->rung[i].place != p)
        i++;
    return &ladder->rung[i];
}

static int is_first(const struct ladder *ladder, const struct ladder_rung *rung)
{
    for (int i = 0; i < ladder->rungs; i++)
        if (ladder->rung[i].place < rung->place && !strcmp(ladder->rung[i].kind, rung->kind))
            return 0;
    return 1;
}

/* How far the truth is known, from the cheapest to the dearest rung. */
static void add_doubt(const struct ladder *ladder, struct drawing *d)
{
    const size_t first = d->points;
    int last = ladder->rungs - 1;
    while (last > 0 && ladder->rung[last].why)
        last--;
    for (int end = 0; ladder->doubt > 0 && end < 2; end++)
        add_point(d, ladder->rung[end ? last : 0].time[LADDER_TOTAL].median, ladder->doubt);
    add_series(d, "doubt of the truth", HOBE_STYLE_LINE, 11, first); /* grey */
}

/* Fills the drawing: the front below, the kinds on it. */
static void compose(const struct ladder *ladder, struct drawing *d)
{
    int colour = 0;
    d->edge = LEAST_ERROR;
    for (int i = 0; i < ladder->rungs; i++) {
        const struct ladder_rung *rung = &ladder->rung[i];
        d->edge = fmax(d->edge, rung->why ? 0 : 3 * height(rung));
        if (rung->front)
            add_point(d, rung->time[LADDER_TOTAL].median, height(rung));
    }
    add_series(d, "front", HOBE_STYLE_LINE, 0, 0);
    add_doubt(ladder, d);
    for (int p = 0; p < ladder->rungs; p++)
        if (is_first(ladder, at_place(ladder, p)))
            add_kind(ladder, at_place(ladder, p)->kind, ++colour, d);
}

static enum hobe_status draw(const struct ladder *ladder, const struct ladder_case *of,
                             const char *folder, int *drawn, struct hobe_error *err)
{
    const size_t n = (size_t)ladder->rungs;
    struct drawing d = {.x = hobe_alloc(2 * n + 2, sizeof *d.x, err),
                        .y = hobe_alloc(2 * n + 2, sizeof *d.y, err),
                        .series = hobe_alloc(2 * n + 2, sizeof *d.series, err)};
    struct hobe_text title = {0};
    say_case(ladder, of, &title);
    hobe_text_add(&title, ": %d models", ladder->rungs);
    enum hobe_status status = hobe_text_check(&title, err);
    if (!status && d.x && d.y && d.series) {
        compose(ladder, &d);
        const struct hobe_plot plot = {.title = title.at,
                                       .xlabel = ladder->rung[n - 1].why
                                                     ? "set-up and solve, s; crosses: failed after"
                                                     : "set-up and solve, s",
                                       .ylabel = "largest relative error",
                                       .count = d.count,
                                       .series = d.series,
                                       .log_x = 1,
                                       .log_y = 1};
        status = hobe_plot_write(folder, "chart", &plot, drawn, err);
    } else
        status = HOBE_NO_MEMORY;
    hobe_text_free(&title);
    hobe_free(d.x);
    hobe_free(d.y);
    hobe_free(d.series);
    return status;
}

enum hobe_status ladder_write(const struct ladder *ladder, const struct ladder_case *of,
                              const char *folder, int *drawn, struct hobe_error *err)
{
    static const char *const file[] = {[LADDER_JSON] = "chart.json", [LADDER_CSV] = "chart.csv"};
    enum hobe_status status = HOBE_OK;
    for (int format = LADDER_JSON; !status && format <= LADDER_CSV; format++) {
        struct hobe_text text = {0};
        ladder_text(ladder, of, (enum ladder_format)format, &text);
        status = hobe_write_text(folder, file[format], &text, err);
    }
    *drawn = 1;
    return status ? status : draw(ladder, of, folder, drawn, err);
}
