/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report of a case, and the end of a run: files, standard output, expectations. */
#include "lua_hobe.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/* ---- values --------------------------------------------------------------------------------- */

struct value {
    double value, expect, within;
    const char *unit;
};

static const struct hobe_lua_key value_keys[] = {
    KEY(struct value, value, KEY_NUMBER, REQUIRED, .position = 1, .doc = "the number"),
    KEY(struct value, unit, KEY_TEXT, .position = 2, .doc = "its unit, none where left out"),
    KEY(struct value, expect, KEY_NUMBER, .fallback = NAN, .doc = "what it should be; shown"),
    KEY(struct value, within, KEY_NUMBER, KEY_ABOVE(0), .fallback = NAN,
        .doc = "how far it may lie from `expect`, relative to its size (absolute where that is "
               "0); checked when all parameters are at their defaults"),
    {0}};

static const struct hobe_lua_schema value_schema = {"report", value_keys};

enum { VALUE = 1, UNIT, EXPECT, WITHIN, PLACE }; /* how a value is kept in its table */

static void keep_number(lua_State *L, double x, int place)
{
    if (isnan(x))
        return;
    lua_pushnumber(L, x);
    lua_rawseti(L, -2, place);
}

/* Pushes the table that keeps the value at index, which is called name. */
static void push_value(lua_State *L, int index, const char *name)
{
    struct value v = {.expect = NAN, .within = NAN};
    const char *what = lua_pushfstring(L, "report: %s", name);
    if (lua_istable(L, index))
        hobe_lua_read_group(L, index, what, &value_schema, &v);
    else
        v.value = hobe_lua_number(L, index, what);
    if (isnan(v.expect) && !isnan(v.within))
        hobe_lua_fail(L, "%s has within but no expect", what);
    lua_createtable(L, PLACE, 0);
    keep_number(L, v.value, VALUE);
    lua_pushstring(L, v.unit);
    lua_rawseti(L, -2, UNIT);
    keep_number(L, v.expect, EXPECT);
    keep_number(L, v.within, WITHIN);
    hobe_lua_where(L);
    lua_rawseti(L, -2, PLACE);
    lua_remove(L, -2);
}

static int get_number(lua_State *L, int place, double *x)
{
    int there = lua_rawgeti(L, -1, place) != LUA_TNIL;
    *x = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return there;
}

/* Pushes an array of all values, sorted; its strings belong to the store. */
static struct hobe_value *push_values(lua_State *L, size_t *count)
{
    struct hobe_value *value;
    *count = 0;
    hobe_lua_push_store(L, HOBE_LUA_REPORT);
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
        ++*count;
    value = lua_newuserdatauv(L, (*count + 1) * sizeof *value, 0);
    memset(value, 0, (*count + 1) * sizeof *value);
    lua_insert(L, -2);
    struct hobe_value *next = value;
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1), next++) {
        next->name = lua_tostring(L, -2);
        get_number(L, VALUE, &next->value);
        next->has_expect = get_number(L, EXPECT, &next->expect);
        next->has_within = get_number(L, WITHIN, &next->within);
        lua_rawgeti(L, -1, UNIT);
        next->unit = lua_tostring(L, -1);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    hobe_report_sort(value, *count);
    return value;
}

/* Pushes the sentence about the values that miss their expectation; 0 where none does. */
static int push_failure(lua_State *L, const struct hobe_value *value, size_t count)
{
    const struct hobe_value *first = NULL;
    char sentence[600];
    int more = -1;
    for (size_t i = 0; i < count; i++) {
        if (!hobe_value_fails(&value[i]))
            continue;
        first = first ? first : &value[i];
        more++;
    }
    if (!first)
        return 0;
    snprintf(
        sentence, sizeof sentence,
        "report: %.100s is %.7g%s%.50s but %.7g is expected, a %sdifference of %.2g, more than "
        "within = %g",
        first->name, first->value, first->unit ? " " : "", first->unit ? first->unit : "",
        first->expect, first->expect != 0 ? "relative " : "", hobe_value_difference(first),
        first->within);
    hobe_lua_push_store(L, HOBE_LUA_REPORT);
    lua_getfield(L, -1, first->name);
    lua_rawgeti(L, -1, PLACE);
    lua_pushfstring(L, "%s: %s", lua_tostring(L, -1), sentence);
    if (more > 0)
        lua_pushfstring(L, "%s (and %d more)", lua_tostring(L, -1), more);
    return 1;
}

/* ---- hobe.report ---------------------------------------------------------------------------- */

/* Prints a report at once, for a stock Lua, and raises where a value fails. */
static void print_now(lua_State *L)
{
    struct hobe_text *text = &hobe_lua_context(L)->tables;
    size_t count;
    const struct hobe_value *value = push_values(L, &count);
    hobe_text_free(text);
    hobe_report_table(text, value, count, 1);
    hobe_lua_check_text(L, text);
    fputs(text->at, stdout);
    hobe_text_free(text);
    if (push_failure(L, value, count))
        lua_error(L);
}

/* Empties the table on top of the stack. */
static void clear(lua_State *L)
{
    for (lua_pushnil(L); lua_next(L, -2);) {
        lua_pop(L, 1);
        lua_pushvalue(L, -1);
        lua_pushnil(L);
        lua_rawset(L, -4);
    }
}

/* hobe.report{name = value, ...} */
static int report(lua_State *L)
{
    int program = hobe_lua_context(L)->program;
    lua_settop(L, 1);
    if (!lua_istable(L, 1))
        hobe_lua_fail(L, "report must be given a table, report{name = number}, got %s",
                      hobe_lua_describe(L, 1));
    hobe_lua_push_store(L, HOBE_LUA_REPORT);
    if (!program)
        clear(L);
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING)
            hobe_lua_fail(L, "report: values have names, report{u3 = %s}",
                          hobe_lua_describe(L, -1));
        const char *name = hobe_lua_text(L, -2, "report: a name");
        push_value(L, lua_absindex(L, -1), name);
        lua_setfield(L, 2, name);
    }
    if (!program)
        print_now(L);
    return 0;
}

/* hobe.output(folder) */
static int output(lua_State *L)
{
    struct hobe_lua *context = hobe_lua_context(L);
    struct hobe_error err;
    const char *folder = hobe_lua_text(L, 1, "output: the folder");
    if (context->program)
        hobe_lua_fail(L, "output: here the command line names the output folder, --out DIR");
    if (hobe_make_folder(folder, &err))
        hobe_lua_raise(L, &err);
    hobe_lua_push_store(L, HOBE_LUA_KEPT);
    lua_pushvalue(L, 1);
    lua_setfield(L, -2, "folder");
    context->folder = folder;
    return 0;
}

const struct hobe_lua_entry hobe_lua_report_entries[] = {
    {"report", report, "hobe.report{name = number, name = {number, unit, expect =, within =}}",
     "The values that a case is about; several calls add up, and a name that comes again replaces "
     "its value.  A plain number has no unit.  A value further than `within` from `expect` makes "
     "the run fail.",
     &value_schema, NULL},
    {"output", output, "hobe.output(folder)",
     "Under a stock Lua: where tables and pictures with a `file` go (nowhere before).  In the "
     "program that is `--out DIR`.",
     NULL, NULL},
    {0}};

/* ---- the end of a run ----------------------------------------------------------------------- */

static const long SHOWN = 10; /* of the notes, below the report */

/* A log becomes a file unless it is empty. */
static void stage_log(lua_State *L, const char *name, struct hobe_text *log)
{
    if (log->size == 0 && !log->status)
        return;
    *hobe_lua_stage(L, name) = *log;
    *log = (struct hobe_text){0};
}

/* Adds the report's own files to those of the script. */
static void stage_report(lua_State *L, const struct hobe_value *value, size_t count)
{
    struct hobe_lua *context = hobe_lua_context(L);
    context->finishing = 1;
    hobe_report_json(hobe_lua_stage(L, "report.json"), value, count);
    hobe_report_csv(hobe_lua_stage(L, "report.csv"), value, count);
    stage_log(L, "newton.csv", &context->newton);
    stage_log(L, "motion.csv", &context->motion);
    hobe_lua_add_notes(L, hobe_lua_stage(L, "report-notes.txt"), LONG_MAX);
}

static void write_text(lua_State *L, const struct hobe_text *text, FILE *to)
{
    if (text->size > 0)
        fwrite(text->at, 1, text->size, to);
    if (fflush(to) || ferror(to))
        hobe_lua_fail(L, "standard output could not be written: %s", strerror(errno));
}

int hobe_lua_finish(lua_State *L, enum hobe_lua_format format, FILE *to)
{
    struct hobe_lua *context = hobe_lua_context(L);
    struct hobe_text *text = &context->tables;
    size_t count;
    const struct hobe_value *value = push_values(L, &count);
    if (format != HOBE_LUA_TABLE)
        hobe_text_free(text);
    if (format == HOBE_LUA_JSON)
        hobe_report_json(text, value, count);
    else if (format == HOBE_LUA_CSV)
        hobe_report_csv(text, value, count);
    else if (format == HOBE_LUA_RECORD)
        hobe_lua_add_record(L, text, value, count);
    else if (count > 0)
        hobe_report_table(text, value, count, !context->overridden);
    if (format == HOBE_LUA_TABLE)
        hobe_lua_add_notes(L, text, SHOWN);
    hobe_lua_check_text(L, text); /* before a file is written: all or nothing */
    if (context->folder) {
        stage_report(L, value, count);
        hobe_lua_write_files(L);
    }
    write_text(L, text, to);
    hobe_lua_drop_journals(L);
    return !context->overridden && push_failure(L, value, count);
}
