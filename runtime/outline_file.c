/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline_file.h"

#include "section.h"
#include "section_outline.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const double CHORDS = 1e-3; /* default tolerance, of the drawing's extent */

/* ---- lines and words ------------------------------------------------------------------------ */

static int blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

static struct hobe_word trim(struct hobe_word word)
{
    for (; word.size > 0 && blank(*word.at); word.at++)
        word.size--;
    while (word.size > 0 && blank(word.at[word.size - 1]))
        word.size--;
    return word;
}

int hobe_next_line(struct hobe_lines *lines, struct hobe_word *line)
{
    const size_t left = (size_t)(lines->end - lines->at);
    if (left == 0)
        return 0;
    const char *end = memchr(lines->at, '\n', left);
    const size_t size = end ? (size_t)(end - lines->at) : left;
    *line = trim((struct hobe_word){lines->at, size});
    lines->at += end ? size + 1 : size;
    lines->line++;
    return 1;
}

int hobe_word_is(struct hobe_word word, const char *name)
{
    return strlen(name) == word.size && !memcmp(word.at, name, word.size);
}

int hobe_word_number(struct hobe_word word, double *x)
{
    char text[64], *end;
    if (word.size == 0 || word.size >= sizeof text)
        return 0;
    memcpy(text, word.at, word.size);
    text[word.size] = '\0';
    if (strlen(text) != word.size || strspn(text, "0123456789+-.eE") != word.size)
        return 0;
    char *dot = strchr(text, '.'); /* a host program may have set a locale */
    if (dot)
        *dot = *localeconv()->decimal_point;
    *x = strtod(text, &end);
    return *end == '\0';
}

const char *hobe_word_quote(struct hobe_word word, char quote[48])
{
    const size_t shown = word.size > 40 ? 40 : word.size;
    for (size_t i = 0; i < shown; i++)
        quote[i] = word.at[i];
    for (size_t i = 0; i < shown; i++)
        if (quote[i] < ' ' || quote[i] > '~')
            quote[i] = '?';
    memcpy(quote + shown, "...", 4);
    if (shown == word.size)
        quote[shown] = '\0';
    return quote;
}

/* ---- lists of points ------------------------------------------------------------------------ */

/* Takes the next word off the line; blanks, commas and semicolons lie between words. */
static int next_word(struct hobe_word *line, struct hobe_word *word)
{
    static const char between[] = " \t,;";
    size_t n = 0;
    while (line->size > 0 && memchr(between, *line->at, sizeof between - 1)) {
        line->at++;
        line->size--;
    }
    while (n < line->size && !memchr(between, line->at[n], sizeof between - 1))
        n++;
    *word = (struct hobe_word){line->at, n};
    line->at += n;
    line->size -= n;
    return n > 0;
}

/* Two numbers and nothing else. */
static int read_point(struct hobe_word line, double point[2])
{
    struct hobe_word word;
    for (int a = 0; a < 2; a++)
        if (!next_word(&line, &word) || !hobe_word_number(word, point + a))
            return 0;
    return !next_word(&line, &word);
}

/* A first line that does not begin with a number: a name or a head. */
static int is_head(struct hobe_word line)
{
    struct hobe_word word;
    double x;
    return next_word(&line, &word) && !hobe_word_number(word, &x);
}

static struct hobe_word without_comment(struct hobe_word line)
{
    const char *comment = line.size ? memchr(line.at, '#', line.size) : NULL;
    if (comment)
        line.size = (size_t)(comment - line.at);
    return trim(line);
}

/* Each loop is a closed path. */
static enum hobe_status draw_list(struct hobe_lines lines, struct hobe_drawing *drawing,
                                  struct hobe_error *err)
{
    struct hobe_word line;
    int first = 1, between = 1; /* no content yet; no loop has begun */
    enum hobe_status status = HOBE_OK;
    while (!status && hobe_next_line(&lines, &line)) {
        const struct hobe_word content = without_comment(line);
        double point[2];
        char quote[48];
        if (line.size == 0)
            between = 1;
        if (content.size == 0)
            continue; /* a comment does not part loops */
        const int head = first && is_head(content);
        first = 0;
        if (head)
            continue;
        if (!read_point(content, point))
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "%s: line %d must hold two numbers, y and z, got \"%s\"",
                             drawing->name, lines.line, hobe_word_quote(content, quote));
        if (between) {
            hobe_path_begin(drawing, "loop", lines.line);
            hobe_path_last(drawing)->closed = 1;
        }
        between = 0;
        status = hobe_path_line(drawing, point, err);
    }
    return status;
}

/* ---- files ---------------------------------------------------------------------------------- */

static int is_dxf(const char *name)
{
    const size_t size = strlen(name);
    return size >= 4 && !strcasecmp(name + size - 4, ".dxf");
}

static enum hobe_status draw(const struct hobe_outline_file *file, struct hobe_drawing *drawing,
                             struct hobe_unit *unit, struct hobe_error *err)
{
    static const char mark[] = "\xEF\xBB\xBF"; /* of UTF-8, which some editors write */
    struct hobe_lines lines = {file->text, file->text + file->size, 0};
    if (file->size >= 3 && !memcmp(file->text, mark, 3))
        lines.at += 3;
    drawing->paths = 0;
    if (is_dxf(file->name))
        return hobe_draw_dxf(lines, drawing, unit, err);
    *unit = (struct hobe_unit){0};
    return draw_list(lines, drawing, err);
}

/* The scale: the caller's, else the file's, else 1. */
static enum hobe_status choose_unit(const struct hobe_outline_file *file, struct hobe_unit *unit,
                                    struct hobe_error *err)
{
    if (file->scale > 0)
        *unit = (struct hobe_unit){file->scale, "scale"};
    else if (!*unit->text)
        *unit = (struct hobe_unit){1, "no unit given"};
    else if (unit->metres == 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: its unit, %s, is not known; give scale, the metres in one unit",
                         file->name, unit->text);
    return HOBE_OK;
}

/* Draws coarsely first, to learn the extent, of which the tolerance is a part. */
static enum hobe_status read_loops(const struct hobe_outline_file *file,
                                   struct hobe_drawing *drawing, struct hobe_loops *loops,
                                   struct hobe_unit *unit, struct hobe_error *err)
{
    enum hobe_status status = draw(file, drawing, unit, err);
    if (!status)
        status = choose_unit(file, unit, err);
    if (status)
        return status;
    drawing->tolerance = file->tolerance > 0 ? file->tolerance / unit->metres
                                             : CHORDS * hobe_drawing_extent(drawing);
    struct hobe_unit same;
    status = draw(file, drawing, &same, err);
    return status ? status : hobe_drawing_loops(drawing, loops, err);
}

static enum hobe_status check_file(const struct hobe_outline_file *file, struct hobe_error *err)
{
    if (!(file->scale >= 0) || !isfinite(file->scale))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: scale must be > 0 (m per unit of the file), got %g", file->name,
                         file->scale);
    if (!(file->tolerance >= 0) || !isfinite(file->tolerance))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s: tolerance must be > 0 (m), got %g",
                         file->name, file->tolerance);
    if (file->size > HOBE_MOST_OUTLINE_BYTES)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: a file of an outline may have at most %d MB", file->name,
                         HOBE_MOST_OUTLINE_BYTES >> 20);
    return HOBE_OK;
}

enum hobe_status hobe_outline_read(const struct hobe_outline_file *file, struct hobe_loops *loops,
                                   struct hobe_unit *unit, struct hobe_error *err)
{
    struct hobe_drawing drawing;
    *loops = (struct hobe_loops){0};
    enum hobe_status status = check_file(file, err);
    if (status)
        return status;
    status = hobe_drawing_new(&drawing, file->name, err);
    if (!status)
        status = read_loops(file, &drawing, loops, unit, err);
    hobe_drawing_free(&drawing);
    for (int l = 0, i = 0; !status && l < loops->loops; l++)
        for (int end = i + loops->points[l]; i < end; i++)
            for (int a = 0; a < 2; a++)
                loops->point[i][a] *= unit->metres;
    return status;
}

hobe_section *hobe_section_file(const struct hobe_outline_file *file, struct hobe_error *err)
{
    struct hobe_loops loops;
    struct hobe_unit unit;
    if (hobe_outline_read(file, &loops, &unit, err))
        return NULL;
    hobe_section *section = hobe_section_outline(
        loops.loops, loops.points, (const double(*)[2])loops.point, NULL, HOBE_WARPING_SOLVED, err);
    char quote[48];
    if (section)
        snprintf(section->text, sizeof section->text,
                 "%s: %d points and %d hole%s, 1 unit = %g m (%s), w: solved on %d triangles",
                 hobe_word_quote((struct hobe_word){file->name, strlen(file->name)}, quote),
                 loops.points[0], loops.loops - 1, loops.loops == 2 ? "" : "s", unit.metres,
                 unit.text, hobe_section_triangles(section));
    else
        hobe_fail_in(err, file->name);
    hobe_loops_free(&loops);
    return section;
}
