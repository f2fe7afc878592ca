/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run of a case says to its ladder, split into words. */
#include "ladder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int count(const char *text, const char *of)
{
    int n = 0;
    for (; *text; text++)
        n += strchr(of, *text) != NULL;
    return n;
}

/* Splits `line` at its tabs into words from `word` on; their number. */
static int split(char *line, char **word)
{
    int words = 0;
    for (char *next = line; next; words++) {
        word[words] = next;
        next = strchr(next, '\t');
        if (next)
            *next++ = '\0';
    }
    return words;
}

enum hobe_status ladder_record_read(const char *text, size_t size, struct ladder_record *record,
                                    struct hobe_error *err)
{
    *record = (struct ladder_record){hobe_alloc(size + 1, 1, err), 0, 0, NULL, NULL};
    if (!record->text)
        return HOBE_NO_MEMORY;
    memcpy(record->text, text, size);
    const int words = count(record->text, "\t\n") + 1, lines = count(record->text, "\n");
    record->word = hobe_alloc((size_t)words, sizeof *record->word, err);
    record->line = hobe_alloc((size_t)lines + 1, sizeof *record->line, err);
    if (!record->word || !record->line)
        return HOBE_NO_MEMORY;
    char **word = record->word, *next = record->text;
    for (char *end; (end = strchr(next, '\n')); next = end + 1) {
        *end = '\0';
        struct ladder_line *line = &record->line[record->lines++];
        *line = (struct ladder_line){split(next, word), word};
        word += line->words;
    }
    record->whole = ladder_find(record, "end", 1, 0) != NULL;
    return HOBE_OK;
}

void ladder_record_free(struct ladder_record *record)
{
    hobe_free(record->text);
    hobe_free(record->line);
    hobe_free(record->word);
    *record = (struct ladder_record){0};
}

const struct ladder_line *ladder_find(const struct ladder_record *record, const char *word,
                                      int words, int i)
{
    for (int k = 0; k < record->lines; k++) {
        const struct ladder_line *line = &record->line[k];
        if (line->words >= words && !strcmp(line->word[0], word) && i-- == 0)
            return line;
    }
    return NULL;
}

double ladder_number(const char *word)
{
    char *end;
    const double x = strtod(word, &end);
    return end != word && *end == '\0' ? x : NAN;
}
