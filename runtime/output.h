/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run leaves behind: reports, tables and pictures as text, and files that are whole.
 *
 * Everything is composed in memory first, in a `struct hobe_text`, and then written in one stroke:
 * a file either has all of its new content or keeps its old one.  Nothing here prints. */
#ifndef HOBE_OUTPUT_H
#define HOBE_OUTPUT_H

#include "error.h"

/* ---- text (output.c) ------------------------------------------------------------------------ */

/* A growing string; {0} is empty.  `at` ends with '\0' once anything was added, and is NULL before.
 * Running out of memory is remembered in `status`, so that it need not be asked after each call. */
struct hobe_text {
    char *at;
    size_t size, room;
    enum hobe_status status;
};

/* Appends as printf does. */
void hobe_text_add(struct hobe_text *text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Appends size bytes as they are. */
void hobe_text_bytes(struct hobe_text *text, const char *bytes, size_t size);

/* Appends a cell of a CSV line (RFC 4180), quoted where its content asks for it. */
void hobe_text_csv(struct hobe_text *text, const char *cell);

/* Appends x with the fewest digits (15 to 17) that read back as the same number. */
void hobe_text_number(struct hobe_text *text, double x);

/* Frees the content and makes the text empty again; a {0} text is allowed. */
void hobe_text_free(struct hobe_text *text);

/* HOBE_OK, or HOBE_NO_MEMORY with err set when some of the text was lost. */
enum hobe_status hobe_text_check(const struct hobe_text *text, struct hobe_error *err);

/* ---- files (output.c) ----------------------------------------------------------------------- */

/* Makes the folder `path` and those above it where they are missing. */
enum hobe_status hobe_make_folder(const char *path, struct hobe_error *err);

/* HOBE_OK when `name` is a plain relative name for a file inside the output folder: parts separated
 * by '/', none empty or with a leading '.', no control characters.  Else HOBE_BAD_INPUT. */
enum hobe_status hobe_check_name(const char *name, struct hobe_error *err);

/* Replaces folder/name by the size bytes at data: a temporary file in the same folder, fsync,
 * rename.  Folders in name are made where missing; symbolic links below `folder` are not
 * followed.  HOBE_BAD_INPUT for a bad name, HOBE_IO with path and cause. */
enum hobe_status hobe_write_file(const char *folder, const char *name, const char *data,
                                 size_t size, struct hobe_error *err);

/* The same of a text, which is freed in any case. */
enum hobe_status hobe_write_text(const char *folder, const char *name, struct hobe_text *text,
                                 struct hobe_error *err);

/* Opens the regular file folder/name for reading, following no symbolic link below `folder`.
 * Returns a file descriptor that the caller closes, or -1 with err set. */
int hobe_open_file(const char *folder, const char *name, struct hobe_error *err);

/* Opens the folder that holds folder/name (made where missing if `make`) and points *base to the
 * last part of name.  Returns a file descriptor that the caller closes, or -1 with err set. */
int hobe_open_parent(const char *folder, const char *name, int make, const char **base,
                     struct hobe_error *err);

/* ---- reports and tables (output_table.c) ---------------------------------------------------- */

/* A value of a report.  Strings belong to the caller; unit may be NULL. */
struct hobe_value {
    const char *name, *unit;
    double value;
    double expect, within;      /* relative to |expect|; absolute where expect is 0 */
    int has_expect, has_within; /* whether they were given */
};

/* |value - expect| / |expect|, or |value| where expect is 0. */
double hobe_value_difference(const struct hobe_value *value);

/* Whether the value lies further from `expect` than `within`; 0 where one of them is missing. */
int hobe_value_fails(const struct hobe_value *value);

/* Sorts values by name, byte by byte: the order of every format below. */
void hobe_report_sort(struct hobe_value *value, size_t count);

/* Appends a report for people (checked: show ok or FAIL), as JSON (one object) and as CSV
 * (name,value,unit).  Each ends with a newline. */
void hobe_report_table(struct hobe_text *text, const struct hobe_value *value, size_t count,
                       int checked);
void hobe_report_json(struct hobe_text *text, const struct hobe_value *value, size_t count);
void hobe_report_csv(struct hobe_text *text, const struct hobe_value *value, size_t count);

/* A cell of a table: a text, or a number where text is NULL. */
struct hobe_cell {
    const char *text;
    double number;
};

/* A table; all memory belongs to the caller. */
struct hobe_table {
    const char *title; /* may be NULL */
    size_t columns, rows;
    const char *const *head;      /* [columns] */
    const struct hobe_cell *cell; /* [rows][columns] */
};

/* Appends the table, aligned for people (numbers with six digits) and as CSV (all digits). */
void hobe_table_text(struct hobe_text *text, const struct hobe_table *table);
void hobe_table_csv(struct hobe_text *text, const struct hobe_table *table);

/* Appends it as JSON, a line: an object that has under the title an array with an object for each
 * row; empty cells are left out. */
void hobe_table_json(struct hobe_text *text, const struct hobe_table *table);

/* The same of several, table[tables], in one object. */
void hobe_tables_json(struct hobe_text *text, const struct hobe_table *table, size_t tables);

/* ---- pictures (output_plot.c) --------------------------------------------------------------- */

enum hobe_style {
    HOBE_STYLE_LINE,
    HOBE_STYLE_POINTS,
    HOBE_STYLE_LINESPOINTS,
    HOBE_STYLE_CROSSES /* points that are out of the picture's range */
};

struct hobe_series {
    const char *label; /* may be NULL: not in the legend */
    enum hobe_style style;
    int colour; /* 0 black, 1, 2, ... of a palette; < 0: its place among the series, from 1 */
    size_t count;
    const double *x, *y; /* [count], finite */
};

/* A diagram; strings may be NULL and belong to the caller, as do the series. */
struct hobe_plot {
    const char *title, *xlabel, *ylabel;
    size_t count;
    const struct hobe_series *series; /* [count] */
    int log_x, log_y;                 /* logarithmic axes, whose numbers are > 0 */
};

/* Appends the numbers of the diagram as CSV: a pair of columns for each series. */
void hobe_plot_data(struct hobe_text *text, const struct hobe_plot *plot);

/* Appends a gnuplot script that draws the picture `image` (PNG) from the file `data` written by
 * hobe_plot_data, both names without folders.  No title or label is interpreted by gnuplot. */
void hobe_plot_script(struct hobe_text *text, const struct hobe_plot *plot, const char *data,
                      const char *image);

/* Draws: runs gnuplot on folder/script, which draws folder/image beside it.  *drawn is 0, without
 * an error, where gnuplot is not installed.  HOBE_IO with gnuplot's first words otherwise. */
enum hobe_status hobe_plot_draw(const char *folder, const char *script, const char *image,
                                int *drawn, struct hobe_error *err);

/* All three: NAME.data.csv, NAME.gp and, where gnuplot is there, NAME.png into the folder. */
enum hobe_status hobe_plot_write(const char *folder, const char *name, const struct hobe_plot *plot,
                                 int *drawn, struct hobe_error *err);

#endif
