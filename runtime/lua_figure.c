/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables and diagrams that a case makes beside its report. */
#include "lua_hobe.h"

#include <math.h>
#include <string.h>

/* ---- tables --------------------------------------------------------------------------------- */

struct table {
    const char *title, *file;
};

static const struct hobe_lua_key table_keys[] = {
    KEY(struct table, title, KEY_TEXT, .doc = "a line above the table"),
    KEY_OF_LIST("columns", REQUIRED, .doc = "heads of the columns"),
    KEY_OF_LIST("rows", REQUIRED,
                .doc = "a list of rows, each a list of numbers and strings; nil is empty"),
    KEY(struct table, file, KEY_TEXT, .doc = "CSV file in the output folder, with all digits"),
    {0}};

static const struct hobe_lua_schema table_schema = {"table", table_keys};

/* Pushes an array of the strings of the list columns. */
static const char **push_head(lua_State *L, size_t *columns)
{
    hobe_lua_push_key(L, 1, &table_schema, "columns");
    int list = lua_gettop(L);
    *columns = hobe_lua_list_size(L, list, "table: columns");
    if (*columns == 0)
        hobe_lua_fail(L, "table: columns must have at least one head");
    const char **head = lua_newuserdatauv(L, *columns * sizeof *head, 0);
    for (size_t j = 0; j < *columns; j++) {
        lua_rawgeti(L, list, (lua_Integer)j + 1);
        head[j] = hobe_lua_text(L, -1, "table: a head in columns");
        lua_pop(L, 1);
    }
    return head;
}

/* Reads the cells of row i (from 0), which is on top of the stack. */
static void read_row(lua_State *L, size_t i, size_t columns, struct hobe_cell *cell)
{
    if (!lua_istable(L, -1) || lua_rawlen(L, -1) > columns)
        hobe_lua_fail(L, "table: rows[%d] must be a list of at most %d cells, got %s", (int)i + 1,
                      (int)columns, hobe_lua_describe(L, -1));
    for (size_t j = 0; j < columns; j++) {
        const char *what = lua_pushfstring(L, "table: rows[%d][%d]", (int)i + 1, (int)j + 1);
        int type = lua_rawgeti(L, -2, (lua_Integer)j + 1);
        cell[j] = (struct hobe_cell){"", 0};
        if (type == LUA_TNUMBER)
            cell[j] = (struct hobe_cell){NULL, hobe_lua_number(L, -1, what)};
        else if (type != LUA_TNIL)
            cell[j].text = hobe_lua_text(L, -1, what);
        lua_pop(L, 2);
    }
}

/* Pushes an array of all cells. */
static const struct hobe_cell *push_cells(lua_State *L, size_t columns, size_t *rows)
{
    hobe_lua_push_key(L, 1, &table_schema, "rows");
    int list = lua_gettop(L);
    *rows = hobe_lua_list_size(L, list, "table: rows");
    struct hobe_cell *cell = lua_newuserdatauv(L, (*rows * columns + 1) * sizeof *cell, 0);
    for (size_t i = 0; i < *rows; i++) {
        lua_rawgeti(L, list, (lua_Integer)i + 1);
        read_row(L, i, columns, cell + i * columns);
        lua_pop(L, 1);
    }
    return cell;
}

static void show_table(lua_State *L, const struct hobe_table *table)
{
    struct hobe_lua *context = hobe_lua_context(L);
    hobe_table_text(&context->tables, table);
    hobe_text_bytes(&context->tables, "\n", 1);
    hobe_lua_check_text(L, &context->tables);
    if (context->program)
        return;
    fputs(context->tables.at, stdout);
    hobe_text_free(&context->tables);
}

/* hobe.table{title =, columns =, rows =, file =} */
static int make_table(lua_State *L)
{
    struct table read;
    struct hobe_table table;
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &table_schema, &read);
    if (read.file)
        hobe_lua_check_file(L, "table", read.file, ".csv");
    table.title = read.title;
    table.head = push_head(L, &table.columns);
    table.cell = push_cells(L, table.columns, &table.rows);
    show_table(L, &table);
    if (!read.file || !hobe_lua_context(L)->folder)
        return 0;
    hobe_table_csv(hobe_lua_stage(L, read.file), &table);
    hobe_lua_publish(L);
    return 0;
}

/* ---- pictures ------------------------------------------------------------------------------- */

struct series {
    const char *label;
    int style, colour;
};

static const struct hobe_lua_key series_keys[] = {
    KEY(struct series, label, KEY_TEXT, .doc = "its name in the legend"),
    KEY_OF_LIST("x", REQUIRED, .doc = "numbers"),
    KEY_OF_LIST("y", REQUIRED, .doc = "as many numbers"),
    KEY(struct series, style, KEY_CHOICE, .choices = "line|points|linespoints", .word = "line",
        .doc = "how it is drawn"),
    KEY(struct series, colour, KEY_WHOLE, KEY_WITHIN(0, 1000), .fallback = -1,
        .doc = "0 black, 1, 2, ... of a palette; by its place among the series where left out"),
    {0}};

static const struct hobe_lua_schema series_schema = {"series", series_keys};

struct plot {
    const char *file, *title, *xlabel, *ylabel;
    int xlog, ylog;
};

static const struct hobe_lua_key plot_keys[] = {
    KEY(struct plot, file, KEY_TEXT, REQUIRED, .doc = "PNG file in the output folder"),
    KEY(struct plot, title, KEY_TEXT, .doc = "a line above the picture"),
    KEY(struct plot, xlabel, KEY_TEXT, .doc = "what the x axis shows"),
    KEY(struct plot, ylabel, KEY_TEXT, .doc = "what the y axis shows"),
    KEY(struct plot, xlog, KEY_FLAG, .doc = "a logarithmic x axis, of numbers > 0"),
    KEY(struct plot, ylog, KEY_FLAG, .doc = "a logarithmic y axis, of numbers > 0"),
    KEY_OF_LIST("series", REQUIRED, .group = &series_schema,
                .doc = "a list of tables, one a curve"),
    {0}};

static const struct hobe_lua_schema plot_schema = {"plot", plot_keys};

/* The numbers of list `key` of the series at index, in memory that the table at `keep` holds. */
static const double *read_list(lua_State *L, int index, const char *what, const char *key, int keep,
                               size_t *count)
{
    const char *full = lua_pushfstring(L, "%s.%s", what, key);
    hobe_lua_push_key(L, index, &series_schema, key);
    int list = lua_gettop(L);
    *count = hobe_lua_list_size(L, list, full);
    double *x = lua_newuserdatauv(L, (*count + 1) * sizeof *x, 0);
    lua_rawseti(L, keep, (lua_Integer)lua_rawlen(L, keep) + 1);
    for (size_t i = 0; i < *count; i++) {
        lua_rawgeti(L, list, (lua_Integer)i + 1);
        if (lua_type(L, -1) != LUA_TNUMBER || !isfinite(lua_tonumber(L, -1))) {
            full = lua_pushfstring(L, "%s[%d]", full, (int)i + 1);
            hobe_lua_number(L, -2, full);
        }
        x[i] = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    lua_pop(L, 2);
    return x;
}

/* Reads series i (from 0), which is on top of the stack. */
static struct hobe_series read_series(lua_State *L, size_t i, int keep)
{
    const char *what = lua_pushfstring(L, "plot: series[%d]", (int)i + 1);
    int index = lua_gettop(L) - 1;
    struct series read;
    struct hobe_series series;
    size_t rows;
    hobe_lua_read_group(L, index, what, &series_schema, &read);
    series.label = read.label;
    series.colour = read.colour;
    series.style = read.style > 0 ? (enum hobe_style)(read.style - 1) : HOBE_STYLE_LINE;
    series.x = read_list(L, index, what, "x", keep, &series.count);
    series.y = read_list(L, index, what, "y", keep, &rows);
    if (series.count != rows || rows == 0)
        hobe_lua_fail(L, "%s must have as many numbers in y as in x, at least one, got %d and %d",
                      what, (int)rows, (int)series.count);
    lua_pop(L, 1);
    return series;
}

/* Pushes all series. */
static const struct hobe_series *push_series(lua_State *L, size_t *count)
{
    hobe_lua_push_key(L, 1, &plot_schema, "series");
    int list = lua_gettop(L);
    *count = hobe_lua_list_size(L, list, "plot: series");
    if (*count == 0)
        hobe_lua_fail(L, "plot: series must have at least one series");
    struct hobe_series *series = lua_newuserdatauv(L, *count * sizeof *series, 0);
    lua_newtable(L);
    int keep = lua_gettop(L);
    for (size_t i = 0; i < *count; i++) {
        lua_rawgeti(L, list, (lua_Integer)i + 1);
        series[i] = read_series(L, i, keep);
        lua_pop(L, 1);
    }
    return series;
}

/* A logarithmic axis has no place for numbers that are not positive. */
static void check_positive(lua_State *L, size_t series, const char *key, size_t count,
                           const double *value)
{
    for (size_t i = 0; i < count; i++)
        if (!(value[i] > 0))
            hobe_lua_fail(L,
                          "plot: series[%d].%s[%d] must be > 0 on a logarithmic axis (%slog), "
                          "got %f",
                          (int)series + 1, key, (int)i + 1, key, value[i]);
}

static const char *last_part(const char *name)
{
    const char *slash = strrchr(name, '/');
    return slash ? slash + 1 : name;
}

/* hobe.plot{file =, series =, ...} */
static int make_plot(lua_State *L)
{
    struct plot read;
    struct hobe_plot plot;
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &plot_schema, &read);
    hobe_lua_check_file(L, "plot", read.file, ".png");
    plot = (struct hobe_plot){.title = read.title,
                              .xlabel = read.xlabel,
                              .ylabel = read.ylabel,
                              .log_x = read.xlog,
                              .log_y = read.ylog};
    plot.series = push_series(L, &plot.count);
    for (size_t i = 0; i < plot.count; i++) {
        const struct hobe_series *series = plot.series + i;
        if (read.xlog)
            check_positive(L, i, "x", series->count, series->x);
        if (read.ylog)
            check_positive(L, i, "y", series->count, series->y);
    }
    if (!hobe_lua_context(L)->folder)
        return 0;
    lua_pushlstring(L, read.file, strlen(read.file) - strlen(".png"));
    const char *data = lua_pushfstring(L, "%s.data.csv", lua_tostring(L, -1));
    const char *script = lua_pushfstring(L, "%s.gp", lua_tostring(L, -2));
    hobe_plot_data(hobe_lua_stage(L, data), &plot);
    hobe_plot_script(hobe_lua_stage(L, script), &plot, last_part(data), last_part(read.file));
    hobe_lua_stage_picture(L, read.file, script);
    hobe_lua_publish(L);
    return 0;
}

const struct hobe_lua_entry hobe_lua_figure_entries[] = {
    {"table", make_table, "hobe.table{columns = {...}, rows = {{...}, ...}}",
     "A table on standard output (not with `--format json` or `csv`) and in a file.", &table_schema,
     NULL},
    {"plot", make_plot, "hobe.plot{file = \"x.png\", series = {{x = {...}, y = {...}}, ...}}",
     "A picture in the output folder, drawn by gnuplot, with its numbers (`x.data.csv`) and its "
     "script (`x.gp`) beside it.  Without an output folder nothing is done.",
     &plot_schema, NULL},
    {0}};
