/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reference of the Lua module, printed from the records that check and run it. */
#include "lua_hobe.h"

#include <math.h>

static void print_type(FILE *to, const struct hobe_lua_key *key)
{
    static const char *const words[] = {
        [KEY_NUMBER] = "number", [KEY_WHOLE] = "whole number", [KEY_TEXT] = "string",
        [KEY_FLAG] = "boolean",  [KEY_VECTOR] = "{x, y, z}",   [KEY_PAIR] = "{a, b}",
        [KEY_GROUP] = "table",   [KEY_SECTION] = "section",    [KEY_RESULT] = "result",
        [KEY_MODES] = "modes",   [KEY_HISTORY] = "motion",     [KEY_LIST] = "list"};
    if (key->type != KEY_CHOICE) {
        fputs(key->type == KEY_OTHER ? key->choices : words[key->type], to);
        return;
    }
    for (const char *c = key->choices; *c; c++) {
        if (c == key->choices || *c == '|')
            fputs(*c == '|' ? "\", \"" : "\"", to);
        if (*c != '|')
            fputc(*c, to);
    }
    fputc('"', to);
}

static void print_range(FILE *to, const struct hobe_lua_key *key)
{
    if (key->bounds & KEY_LOWER)
        fprintf(to, "%s %g", key->bounds & KEY_LOWER_OPEN ? ">" : ">=", key->lower);
    if ((key->bounds & KEY_LOWER) && (key->bounds & KEY_UPPER))
        fputs(", ", to);
    if (key->bounds & KEY_UPPER)
        fprintf(to, "%s %g", key->bounds & KEY_UPPER_OPEN ? "<" : "<=", key->upper);
}

/* A number that its key would refuse stands for one that was left out. */
static int has_default(const struct hobe_lua_key *key)
{
    return (key->type == KEY_NUMBER || key->type == KEY_WHOLE) && !isnan(key->fallback) &&
           hobe_lua_is_within(key, key->fallback);
}

static void print_default(FILE *to, const struct hobe_lua_key *key)
{
    if (key->flags & KEY_REQUIRED)
        fputs("required", to);
    else if (has_default(key))
        fprintf(to, "%g", key->fallback);
    else if (key->word)
        fprintf(to, "\"%s\"", key->word);
    else if (key->type == KEY_FLAG)
        fputs(key->fallback != 0 ? "true" : "false", to);
}

static void print_keys(FILE *to, const char *prefix, const struct hobe_lua_schema *schema)
{
    for (const struct hobe_lua_key *key = schema->key; key->name; key++) {
        fprintf(to, "| `%s%s`", prefix, key->name);
        if (key->position > 0)
            fprintf(to, " or [%d]", key->position);
        fputs(" | ", to);
        print_type(to, key);
        fprintf(to, " | %s | ", key->unit ? key->unit : "");
        print_range(to, key);
        fputs(" | ", to);
        print_default(to, key);
        fprintf(to, " | %s |\n", key->doc);
        if (key->group) {
            const char *each = key->type == KEY_LIST ? "[i]" : "";
            char inner[80];
            snprintf(inner, sizeof inner, "%s%s%s.", prefix, key->name, each);
            print_keys(to, inner, key->group);
        }
    }
}

static void print_schema(FILE *to, const struct hobe_lua_schema *schema)
{
    fputs("| key | type | unit | range | default | |\n|---|---|---|---|---|---|\n", to);
    print_keys(to, "", schema);
}

static void print_fields(FILE *to, const struct hobe_lua_field *field)
{
    fputs("| field | unit | |\n|---|---|---|\n", to);
    for (; field->name; field++)
        fprintf(to, "| `%s` | %s | %s |\n", field->name, field->unit ? field->unit : "",
                field->doc);
}

void hobe_lua_print_docs(FILE *to)
{
    fputs("# The Lua module hobe\n\n"
          "Printed by `hobe docs` from the records that check the arguments.  SI units; angles in "
          "radians.\n`[1]` means that a value may stand first, without its name.  What is wrong "
          "or unknown raises\nan error: one sentence with file and line that says what would be "
          "right.\n",
          to);
    for (const struct hobe_lua_chapter *chapter = hobe_lua_chapters; chapter->title; chapter++) {
        fprintf(to, "\n## %s\n", chapter->title);
        for (const struct hobe_lua_entry *entry = chapter->entry; entry->name; entry++) {
            fprintf(to, "\n### `%s`\n\n%s\n", entry->usage, entry->doc);
            if (entry->schema) {
                fputc('\n', to);
                print_schema(to, entry->schema);
            }
            if (entry->field) {
                fputs("\nReturned fields:\n\n", to);
                print_fields(to, entry->field);
            }
        }
    }
}
