/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outlines from the text of files: lists of points and DXF drawings. */
#ifndef HOBE_OUTLINE_FILE_H
#define HOBE_OUTLINE_FILE_H

#include "outline_drawing.h"

/* Text that is read line by line; its bytes may be anything. */
struct hobe_lines {
    const char *at, *end;
    int line; /* the number of the last line read, from 1 */
};

/* A part of the text. */
struct hobe_word {
    const char *at;
    size_t size;
};

/* The next line without the blanks around it; 0 at the end. */
int hobe_next_line(struct hobe_lines *lines, struct hobe_word *line);

/* Whether the word is this name. */
int hobe_word_is(struct hobe_word word, const char *name);

/* Whether the word is a decimal number, finite or not; then *x. */
int hobe_word_number(struct hobe_word word, double *x);

/* The word for a sentence: its first 40 characters, '?' for those that are not plain ASCII. */
const char *hobe_word_quote(struct hobe_word word, char quote[48]);

/* The unit of a file. */
struct hobe_unit {
    double metres; /* in one unit; 0: not known */
    char text[40]; /* where that is from; empty where the file does not say */
};

/* Draws the lines and curves of a DXF file (outline_dxf.c). */
enum hobe_status hobe_draw_dxf(struct hobe_lines lines, struct hobe_drawing *drawing,
                               struct hobe_unit *unit, struct hobe_error *err);

/* The loops of a file in metres, for hobe_loops_free, and the unit that was used.  Whether they
 * make an outline is left to hobe_section_polygon. */
enum hobe_status hobe_outline_read(const struct hobe_outline_file *file, struct hobe_loops *loops,
                                   struct hobe_unit *unit, struct hobe_error *err);

#endif
