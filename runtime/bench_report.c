/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results of benchmarks as tables, files and pictures. */
#include "bench.h"

#include "bench_subject.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bench_row *bench_add(struct bench_rows *rows, struct hobe_error *err)
{
    if (rows->count == rows->room) {
        const size_t room = rows->room ? 2 * rows->room : 64;
        struct bench_row *at = rows->at ? hobe_grow(rows->at, rows->room, room, sizeof *at, err)
                                        : hobe_alloc(room, sizeof *at, err);
        if (!at)
            return NULL;
        rows->at = at;
        rows->room = room;
    }
    return rows->at + rows->count++;
}

/* ---- tables --------------------------------------------------------------------------------- */

enum {
    KIND,
    ELEMENT,
    SECTION,
    PLAN,
    TAKEN,
    TASK,
    DOFS,
    ELEMENTS,
    SECONDS,
    LEAST,
    SPREAD,
    NANOSECONDS,
    FLOPS,
    RATE,
    PEAK,
    POINTS,
    PRINTED,
    ITERATIONS,
    FACTORS,
    BYTES,
    WHOLE,
    OFFLINE,
    REPAID,
    TENSOR,
    COLUMNS
};

/* What programs call a column, and people beside the title of a table. */
static const struct {
    const char *full, *brief;
} heads[COLUMNS] = {
    [KIND] = {"kind", "kind"},
    [ELEMENT] = {"element", "element"},
    [SECTION] = {"section", "section"},
    [PLAN] = {"plan", "plan"},
    [TAKEN] = {"taken", "taken"},
    [TASK] = {"task", "task"},
    [DOFS] = {"dofs", "dofs"},
    [ELEMENTS] = {"elements", "elements"},
    [SECONDS] = {"median, s", "time, s"},
    [LEAST] = {"least, s", "least, s"},
    [SPREAD] = {"spread, %", "spread, %"},
    [NANOSECONDS] = {"ns per element", "ns"},
    [FLOPS] = {"flops per element", "flops"},
    [RATE] = {"GFLOP/s", "GFLOP/s"},
    [PEAK] = {"% of peak", "% of peak"},
    [POINTS] = {"points / this", "points/this"},
    [PRINTED] = {"eq. 28 / this", "eq. 28/this"},
    [ITERATIONS] = {"iterations per step", "iterations"},
    [FACTORS] = {"factors per step", "factors"},
    [BYTES] = {"bytes per element", "bytes"},
    [WHOLE] = {"whole / this", "whole/this"},
    [OFFLINE] = {"offline, s", "offline, s"},
    [REPAID] = {"repaid after iterations", "repaid after"},
    [TENSOR] = {"tensor, bytes", "tensor, bytes"},
};

static void fill(const struct bench_row *row, struct hobe_cell *cell)
{
    const double elements = (double)row->elements, time = row->time.median;
    const char *const texts[] = {
        row->kind, row->element, row->section, row->plan, row->taken ? "yes" : NULL, row->task};
    const double numbers[COLUMNS] = {
        [DOFS] = row->dofs,
        [ELEMENTS] = elements,
        [SECONDS] = time,
        [LEAST] = row->time.least,
        [SPREAD] = 100 * row->time.spread,
        [NANOSECONDS] = elements > 0 ? 1e9 * time / elements : 0,
        [FLOPS] = elements > 0 ? row->flops / elements : 0,
        [RATE] = 1e-9 * row->flops / time,
        [PEAK] = 100 * row->peak,
        [POINTS] = row->points,
        [PRINTED] = row->printed,
        [ITERATIONS] = row->iterations,
        [FACTORS] = row->factors,
        [BYTES] = elements > 0 ? row->bytes / elements : 0,
        [WHOLE] = row->whole,
        [OFFLINE] = row->offline,
        [REPAID] = row->whole > 1 ? row->offline / ((row->whole - 1) * time) : 0,
        [TENSOR] = row->tensor,
    };
    for (int j = 0; j < DOFS; j++)
        cell[j].text = texts[j] ? texts[j] : "";
    for (int j = DOFS; j < COLUMNS; j++) { /* 0: not known, but for the spread */
        cell[j].text = numbers[j] > 0 || j == SPREAD ? NULL : "";
        cell[j].number = numbers[j];
    }
}

/* A table of some kinds of rows in some columns. */
struct view {
    const char *title, *kinds[2];
    int columns, column[COLUMNS];
    int digits; /* for people; 0: all, for programs */
};

static const struct view everything = {
    "bench",
    {NULL, NULL},
    COLUMNS,
    {KIND,    ELEMENT,    SECTION, PLAN,        TAKEN, TASK,    DOFS,   ELEMENTS,
     SECONDS, LEAST,      SPREAD,  NANOSECONDS, FLOPS, RATE,    PEAK,   POINTS,
     PRINTED, ITERATIONS, FACTORS, BYTES,       WHOLE, OFFLINE, REPAID, TENSOR},
    0,
};
static const struct view views[] = {
    {"Elements, in batches of eight, per element",
     {"kernel", "baseline"},
     12,
     {ELEMENT, SECTION, PLAN, TAKEN, TASK, NANOSECONDS, SPREAD, FLOPS, RATE, PEAK, POINTS, PRINTED},
     3},
    {"Beams, steps of the first Newton iteration, per element",
     {"scene", NULL},
     6,
     {ELEMENT, ELEMENTS, TASK, NANOSECONDS, SPREAD, BYTES},
     3},
    {"Table 6: 21 load cases of the Princeton beam, set-up included",
     {"table 6", NULL},
     4,
     {ELEMENT, ELEMENTS, SECONDS, SPREAD},
     3},
    {"A pendulum's step in time, and what it takes on the average",
     {"motion", NULL},
     7,
     {ELEMENT, ELEMENTS, TASK, SECONDS, SPREAD, ITERATIONS, FACTORS},
     3},
    {"Newton iterations of a cantilever, whole and reduced",
     {"reduced", NULL},
     8,
     {ELEMENT, ELEMENTS, DOFS, SECONDS, WHOLE, OFFLINE, REPAID, TENSOR},
     3},
};

static int shows(const struct view *view, const struct bench_row *row)
{
    return !view->kinds[0] || !strcmp(row->kind, view->kinds[0]) ||
           (view->kinds[1] && !strcmp(row->kind, view->kinds[1]));
}

static double rounded(double x, int digits)
{
    char text[40];
    snprintf(text, sizeof text, "%.*g", digits, x);
    return strtod(text, NULL);
}

/* Appends rows seen through a view; nothing where it shows none. */
static void add_view(const struct bench_rows *rows, const struct view *view,
                     void (*print)(struct hobe_text *text, const struct hobe_table *table),
                     struct hobe_text *text)
{
    const char *head[COLUMNS];
    struct hobe_cell all[COLUMNS];
    struct hobe_table table = {view->title, (size_t)view->columns, 0, head, NULL};
    struct hobe_cell *cell = hobe_alloc(rows->count * COLUMNS, sizeof *cell, NULL), *to = cell;
    if (!cell) {
        text->status = HOBE_NO_MEMORY;
        return;
    }
    for (int j = 0; j < view->columns; j++)
        head[j] = view->digits ? heads[view->column[j]].brief : heads[view->column[j]].full;
    for (size_t i = 0; i < rows->count; i++) {
        if (!shows(view, rows->at + i))
            continue;
        fill(rows->at + i, all);
        for (int j = 0; j < view->columns; j++, to++) {
            *to = all[view->column[j]];
            if (view->digits && view->column[j] != ELEMENTS && view->column[j] != FLOPS)
                to->number = rounded(to->number, view->digits);
        }
        table.rows++;
    }
    table.cell = cell;
    if (table.rows)
        print(text, &table);
    hobe_free(cell);
}

/* The best of the races, flop/s; 0 where there was none. */
static double peak_rate(const struct bench_rows *rows)
{
    double rate = 0;
    for (size_t i = 0; i < rows->count; i++)
        if (!strcmp(rows->at[i].kind, "machine"))
            rate = fmax(rate, rows->at[i].flops / rows->at[i].time.median);
    return rate;
}

static void add_tables(const struct bench_rows *rows, struct hobe_text *text)
{
    const double rate = peak_rate(rows);
    hobe_text_add(text, "%s kernels, one core%s", bench_machine()->name,
                  rows->pinned ? "" : ", not pinned (the system does not allow it)");
    if (rate > 0)
        hobe_text_add(text, "; peak of fused multiply-adds %.3g GFLOP/s", 1e-9 * rate);
    hobe_text_add(text, "\n");
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        hobe_text_add(text, "\n");
        add_view(rows, views + i, hobe_table_text, text);
    }
}

void bench_text(const struct bench_rows *rows, enum bench_format format, struct hobe_text *text)
{
    if (format == BENCH_TABLE)
        add_tables(rows, text);
    else
        add_view(rows, &everything, format == BENCH_CSV ? hobe_table_csv : hobe_table_json, text);
}

/* ---- pictures ------------------------------------------------------------------------------- */

/* A diagram, its rows in series of those that are alike. */
struct figure {
    const char *name, *title, *xlabel, *ylabel;
    enum hobe_style style;
    int log_x;
    double (*x)(const struct bench_row *row); /* 0: the row is not in it */
    double (*y)(const struct bench_row *row);
    int (*alike)(const struct bench_row *a, const struct bench_row *b);
    const char *(*label)(const struct bench_row *row, char *text, size_t size);
};

static double time_per_element(const struct bench_row *row)
{
    return 1e6 * row->time.median / (double)row->elements;
}

static double kernel_x(const struct bench_row *row)
{
    return row->section && !strcmp(row->section, bench_classes[0].name) ? row->dofs : 0;
}

static int kernel_alike(const struct bench_row *a, const struct bench_row *b)
{
    return !strcmp(a->plan, b->plan) && !strcmp(a->task, b->task);
}

static const char *kernel_label(const struct bench_row *row, char *text, size_t size)
{
    snprintf(text, size, "%s: %s", row->plan, row->task);
    return text;
}

static double scene_x(const struct bench_row *row)
{
    return !strcmp(row->kind, "scene") ? (double)row->elements : 0;
}

static int scene_alike(const struct bench_row *a, const struct bench_row *b)
{
    return !strcmp(a->element, b->element) && !strcmp(a->task, b->task);
}

static const char *scene_label(const struct bench_row *row, char *text, size_t size)
{
    snprintf(text, size, "%s: %s", row->element, row->task);
    return text;
}

static double reduced_x(const struct bench_row *row)
{
    return row->offline > 0 ? row->dofs : 0;
}

static double reduced_gain(const struct bench_row *row)
{
    return row->whole;
}

static int reduced_alike(const struct bench_row *a, const struct bench_row *b)
{
    return !strcmp(a->element, b->element) && a->elements == b->elements;
}

static const char *reduced_label(const struct bench_row *row, char *text, size_t size)
{
    snprintf(text, size, "%ld x %s", row->elements, row->element);
    return text;
}

static const struct figure figures[] = {
    {"kernels", "Elements on a rectangle, in batches of eight", "degrees of freedom of an element",
     "µs per element", HOBE_STYLE_POINTS, 0, kernel_x, time_per_element, kernel_alike,
     kernel_label},
    {"scenes", "Steps of a Newton iteration on beams", "elements of the beam", "µs per element",
     HOBE_STYLE_LINESPOINTS, 1, scene_x, time_per_element, scene_alike, scene_label},
    {"reduced", "Newton iterations of reduced models", "unknowns",
     "times that one of the whole model takes longer", HOBE_STYLE_LINESPOINTS, 0, reduced_x,
     reduced_gain, reduced_alike, reduced_label},
};

/* What a figure is made of while it is drawn; room for all rows. */
struct drawing {
    double *x, *y;
    struct hobe_series *series;
    char (*label)[80];
    size_t count; /* of series */
};

/* The series of all rows like the i-th; nothing where an earlier one had them. */
static size_t add_series(const struct bench_rows *rows, const struct figure *figure, size_t i,
                         struct drawing *d, size_t used)
{
    const struct bench_row *row = rows->at + i;
    for (size_t j = 0; j < i; j++)
        if (figure->x(rows->at + j) > 0 && figure->alike(rows->at + j, row))
            return 0;
    size_t count = 0;
    for (size_t j = i; j < rows->count; j++) {
        const double x = figure->x(rows->at + j);
        if (!(x > 0) || !figure->alike(rows->at + j, row))
            continue;
        d->x[used + count] = x;
        d->y[used + count++] = figure->y(rows->at + j);
    }
    const char *label = figure->label(row, d->label[d->count], sizeof d->label[0]);
    d->series[d->count++] =
        (struct hobe_series){label, figure->style, -1, count, d->x + used, d->y + used};
    return count;
}

static enum hobe_status draw(const struct bench_rows *rows, const struct figure *figure,
                             const char *folder, int *drawn, struct hobe_error *err)
{
    const size_t n = rows->count;
    struct drawing d = {hobe_alloc(n, sizeof *d.x, err), hobe_alloc(n, sizeof *d.y, err),
                        hobe_alloc(n, sizeof *d.series, err), hobe_alloc(n, sizeof *d.label, err),
                        0};
    enum hobe_status status = d.x && d.y && d.series && d.label ? HOBE_OK : HOBE_NO_MEMORY;
    size_t used = 0;
    for (size_t i = 0; !status && i < n; i++)
        if (figure->x(rows->at + i) > 0)
            used += add_series(rows, figure, i, &d, used);
    const struct hobe_plot plot = {.title = figure->title,
                                   .xlabel = figure->xlabel,
                                   .ylabel = figure->ylabel,
                                   .count = d.count,
                                   .series = d.series,
                                   .log_x = figure->log_x,
                                   .log_y = 1};
    if (used)
        status = hobe_plot_write(folder, figure->name, &plot, drawn, err);
    hobe_free(d.x);
    hobe_free(d.y);
    hobe_free(d.series);
    hobe_free(d.label);
    return status;
}

enum hobe_status bench_write(const struct bench_rows *rows, const char *folder, int *drawn,
                             struct hobe_error *err)
{
    struct hobe_text text = {0};
    *drawn = 1;
    bench_text(rows, BENCH_CSV, &text);
    enum hobe_status status = hobe_write_text(folder, "bench.csv", &text, err);
    for (size_t i = 0; !status && i < sizeof figures / sizeof *figures; i++)
        status = draw(rows, figures + i, folder, drawn, err);
    return status;
}
