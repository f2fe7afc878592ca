/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reports and tables as text for people, CSV and JSON.  The only file that knows cJSON. */
#include "output.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- tables --------------------------------------------------------------------------------- */

/* Characters of a UTF-8 string, so that columns line up. */
static int width(const char *text)
{
    int n = 0;
    for (; *text; text++)
        n += ((unsigned char)*text & 0xC0) != 0x80;
    return n;
}

/* A cell as people read it: counts in full, else six digits; digits[32] holds a number. */
static const char *show(const struct hobe_cell *cell, char *digits)
{
    if (cell->text)
        return cell->text;
    int whole = cell->number == floor(cell->number) && fabs(cell->number) < 1e9;
    snprintf(digits, 32, whole ? "%.0f" : "%.6g", cell->number);
    return digits;
}

/* How a column is set: its width, and whether it stands at the right as numbers do. */
struct column {
    int width, right;
};

static struct column measure(const struct hobe_table *table, size_t j)
{
    struct column column = {width(table->head[j]), 0};
    int words = 0;
    for (size_t i = 0; i < table->rows; i++) {
        const struct hobe_cell *cell = &table->cell[i * table->columns + j];
        char digits[32];
        int n = width(show(cell, digits));
        if (n > column.width)
            column.width = n;
        column.right |= !cell->text;
        words |= cell->text && *cell->text;
    }
    column.right &= !words;
    return column;
}

static void add_cell(struct hobe_text *text, const char *cell, struct column column, int last)
{
    int pad = column.width - width(cell);
    if (column.right)
        hobe_text_add(text, "%*s", pad, "");
    hobe_text_add(text, "%s", cell);
    if (!column.right && !last)
        hobe_text_add(text, "%*s", pad, "");
    hobe_text_add(text, "%s", last ? "" : "  ");
}

/* Empty cells at the end of a line leave blanks behind, which nobody wants in a file. */
static void end_line(struct hobe_text *text)
{
    while (text->size > 0 && text->at[text->size - 1] == ' ')
        text->size--;
    hobe_text_bytes(text, "\n", 1);
}

void hobe_table_text(struct hobe_text *text, const struct hobe_table *table)
{
    size_t n = table->columns;
    struct column *column = hobe_alloc(n, sizeof *column, NULL);
    if (!column) {
        text->status = HOBE_NO_MEMORY;
        return;
    }
    if (table->title)
        hobe_text_add(text, "%s\n", table->title);
    for (size_t j = 0; j < n; j++) {
        column[j] = measure(table, j);
        add_cell(text, table->head[j], column[j], j + 1 == n);
    }
    end_line(text);
    for (size_t i = 0; i < table->rows; i++) {
        char digits[32];
        for (size_t j = 0; j < n; j++)
            add_cell(text, show(&table->cell[i * n + j], digits), column[j], j + 1 == n);
        end_line(text);
    }
    hobe_free(column);
}

void hobe_table_csv(struct hobe_text *text, const struct hobe_table *table)
{
    size_t n = table->columns;
    for (size_t j = 0; j < n; j++) {
        hobe_text_csv(text, table->head[j]);
        hobe_text_bytes(text, j + 1 < n ? "," : "\n", 1);
    }
    for (size_t i = 0; i < table->rows; i++) {
        for (size_t j = 0; j < n; j++) {
            const struct hobe_cell *cell = &table->cell[i * n + j];
            if (cell->text)
                hobe_text_csv(text, cell->text);
            else
                hobe_text_number(text, cell->number);
            hobe_text_bytes(text, j + 1 < n ? "," : "\n", 1);
        }
    }
}

/* cJSON prints up to 17 digits of 0.1; ours are the shortest that read back.  1 on success. */
static int add_number(cJSON *object, const char *key, double x)
{
    struct hobe_text digits = {0};
    hobe_text_number(&digits, x);
    int good = !digits.status && cJSON_AddRawToObject(object, key, digits.at);
    hobe_text_free(&digits);
    return good;
}

/* Adds the cells of a row; 1 on success. */
static int add_row(cJSON *array, const struct hobe_table *table, const struct hobe_cell *cell)
{
    cJSON *object = cJSON_CreateObject();
    if (!object || !cJSON_AddItemToArray(array, object)) {
        cJSON_Delete(object);
        return 0;
    }
    int good = 1;
    for (size_t j = 0; good && j < table->columns; j++)
        if (!cell[j].text)
            good = add_number(object, table->head[j], cell[j].number);
        else if (*cell[j].text)
            good = cJSON_AddStringToObject(object, table->head[j], cell[j].text) != NULL;
    return good;
}

/* Appends root as a line, and deletes it. */
static void add_json(struct hobe_text *text, cJSON *root, int good)
{
    char *json = good ? cJSON_PrintUnformatted(root) : NULL;
    if (json)
        hobe_text_add(text, "%s\n", json);
    else
        text->status = HOBE_NO_MEMORY;
    cJSON_free(json);
    cJSON_Delete(root);
}

void hobe_tables_json(struct hobe_text *text, const struct hobe_table *table, size_t tables)
{
    cJSON *root = cJSON_CreateObject();
    int good = root != NULL;
    for (size_t k = 0; good && k < tables; k++) {
        cJSON *rows = cJSON_AddArrayToObject(root, table[k].title);
        good = rows != NULL;
        for (size_t i = 0; good && i < table[k].rows; i++)
            good = add_row(rows, &table[k], table[k].cell + i * table[k].columns);
    }
    add_json(text, root, good);
}

void hobe_table_json(struct hobe_text *text, const struct hobe_table *table)
{
    hobe_tables_json(text, table, 1);
}

/* ---- reports -------------------------------------------------------------------------------- */

double hobe_value_difference(const struct hobe_value *value)
{
    double difference = fabs(value->value - value->expect);
    return value->expect != 0 ? difference / fabs(value->expect) : difference;
}

int hobe_value_fails(const struct hobe_value *value)
{
    return value->has_expect && value->has_within &&
           !(hobe_value_difference(value) <= value->within);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct hobe_value *)a)->name, ((const struct hobe_value *)b)->name);
}

void hobe_report_sort(struct hobe_value *value, size_t count)
{
    if (count > 0)
        qsort(value, count, sizeof *value, by_name);
}

enum { NAME, VALUE, UNIT, EXPECTED, DIFFERENCE, CHECK, COLUMNS };

/* A row of the report; a difference is an order of magnitude: two digits tell it. */
static void fill_row(struct hobe_cell *row, const struct hobe_value *value, int checked)
{
    for (int j = 0; j < COLUMNS; j++)
        row[j].text = "";
    row[NAME].text = value->name;
    row[VALUE] = (struct hobe_cell){NULL, value->value};
    if (value->unit)
        row[UNIT].text = value->unit;
    if (!value->has_expect)
        return;
    char digits[32];
    snprintf(digits, sizeof digits, "%.2g", hobe_value_difference(value));
    row[EXPECTED] = (struct hobe_cell){NULL, value->expect};
    row[DIFFERENCE] = (struct hobe_cell){NULL, strtod(digits, NULL)};
    if (value->has_within && checked)
        row[CHECK].text = hobe_value_fails(value) ? "FAIL" : "ok";
}

/* Drops the columns from `columns` on, which a report without expectations leaves empty. */
static void squeeze(struct hobe_cell *cell, size_t rows, size_t columns)
{
    for (size_t i = 1; i < rows; i++)
        memmove(cell + i * columns, cell + i * COLUMNS, columns * sizeof *cell);
}

void hobe_report_table(struct hobe_text *text, const struct hobe_value *value, size_t count,
                       int checked)
{
    static const char *const head[COLUMNS] = {"name",     "value",      "unit",
                                              "expected", "difference", ""};
    size_t columns = EXPECTED;
    struct hobe_cell *cell = hobe_alloc(count * COLUMNS, sizeof *cell, NULL);
    if (!cell) {
        text->status = HOBE_NO_MEMORY;
        return;
    }
    for (size_t i = 0; i < count; i++) {
        fill_row(cell + i * COLUMNS, &value[i], checked);
        if (value[i].has_expect)
            columns = COLUMNS;
    }
    squeeze(cell, count, columns);
    hobe_table_text(
        text, &(struct hobe_table){.columns = columns, .rows = count, .head = head, .cell = cell});
    hobe_free(cell);
}

void hobe_report_csv(struct hobe_text *text, const struct hobe_value *value, size_t count)
{
    hobe_text_add(text, "name,value,unit\n");
    for (size_t i = 0; i < count; i++) {
        hobe_text_csv(text, value[i].name);
        hobe_text_bytes(text, ",", 1);
        hobe_text_number(text, value[i].value);
        hobe_text_bytes(text, ",", 1);
        hobe_text_csv(text, value[i].unit ? value[i].unit : "");
        hobe_text_bytes(text, "\n", 1);
    }
}

static int add_value(cJSON *report, const struct hobe_value *value)
{
    cJSON *object = cJSON_AddObjectToObject(report, value->name);
    if (!object || !add_number(object, "value", value->value))
        return 0;
    if (value->unit && !cJSON_AddStringToObject(object, "unit", value->unit))
        return 0;
    if (value->has_expect && !add_number(object, "expect", value->expect))
        return 0;
    return !value->has_within || add_number(object, "within", value->within);
}

void hobe_report_json(struct hobe_text *text, const struct hobe_value *value, size_t count)
{
    cJSON *root = cJSON_CreateObject();
    cJSON *report = root ? cJSON_AddObjectToObject(root, "report") : NULL;
    int good = report != NULL;
    for (size_t i = 0; good && i < count; i++)
        good = add_value(report, &value[i]);
    add_json(text, root, good);
}
