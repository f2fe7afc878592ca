/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a case says to `hobe chart`: which models it has, what is true of it, and what a run cost.
 */
#include "lua_hobe.h"

#include <math.h>
#include <string.h>

/* ---- parts of a chart ----------------------------------------------------------------------- */

struct chart {
    double doubt;
};

static const struct hobe_lua_key chart_keys[] = {
    KEY_OF_LIST("quantities", .doc = "names of report values whose errors count; those of `truth`, "
                                     "else all that have `expect`, else all"),
    KEY_OF_LIST("truth",
                .doc = "`{name = number}`: what these are, by a converged solid, theory or an "
                       "experiment, at the parameters that the case has now.  The truth of others "
                       "is their `expect` where parameters beyond the ladder's are at their "
                       "defaults, else a converged run"),
    KEY(struct chart, doubt, KEY_NUMBER, KEY_FROM(0),
        .doc = "uncertainty of the truth, relative: errors below it count alike; left out, that "
               "of what is expected is its `within`"),
    KEY_OF_LIST("ladder",
                .doc = "a list of tables `{parameter = {value, value, ...}, ...}`: each is a group "
                       "of models, all combinations of these values of parameters of the case.  "
                       "Where it is left out, `hobe run --model` makes the models: all elements, "
                       "1, 2, 4, 8, 16 and 32 of them in the beam that has most"),
    KEY_OF_LIST("reference",
                .doc = "`{parameter = value}`: the model of the converged run, by its defaults "
                       "where left out, with two and four times the most `elements` of the ladder "
                       "(or as many as said here, and twice that); without a ladder the element "
                       "that has most modes of the section, as for `hobe advise`"),
    {0}};

static const struct hobe_lua_schema chart_schema = {"chart", chart_keys};

/* Pushes a list of the names that are keys of the table at `index`, sorted. */
static void push_names(lua_State *L, int index, const char *what)
{
    lua_newtable(L);
    const int list = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, index); lua_settop(L, list + 1)) {
        if (lua_type(L, list + 1) != LUA_TSTRING)
            hobe_lua_fail(L, "chart: %s has names for keys, got %s", what,
                          hobe_lua_describe(L, list + 1));
        const char *name = hobe_lua_text(L, list + 1, "chart: a name");
        lua_Integer place = (lua_Integer)lua_rawlen(L, list);
        for (; place > 0; place--) { /* those after it make room */
            lua_rawgeti(L, list, place);
            if (strcmp(lua_tostring(L, -1), name) < 0)
                break;
            lua_rawseti(L, list, place + 1);
        }
        lua_pushstring(L, name);
        lua_rawseti(L, list, place + 1);
    }
}

/* Appends a tab and the value on top of the stack, as the command line would say it. */
static void add_value(lua_State *L, struct hobe_text *text, const char *what)
{
    const int type = lua_type(L, -1), top = lua_gettop(L);
    if (type != LUA_TNUMBER && type != LUA_TSTRING && type != LUA_TBOOLEAN)
        hobe_lua_fail(L, "chart: %s must be a number, string or boolean, got %s", what,
                      hobe_lua_describe(L, -1));
    luaL_tolstring(L, -1, NULL);
    const char *word = hobe_lua_text(L, -1, what);
    if (!*word || strpbrk(word, " ,"))
        hobe_lua_fail(L, "chart: %s must be a word without blanks and commas, got %s", what,
                      hobe_lua_describe(L, -1));
    hobe_text_add(text, "\t%s", word);
    lua_settop(L, top);
}

/* The table that key `name` of the chart at index 1 holds, its index; 0 where it is left out. */
static int push_table(lua_State *L, const char *name)
{
    hobe_lua_push_key(L, 1, &chart_schema, name);
    return lua_istable(L, -1) ? lua_gettop(L) : 0;
}

/* "quantity" lines of the names in a list, with their truth where there is a table of it; how many
 * have one. */
static int add_quantities(lua_State *L, struct hobe_text *text, int list, int truth)
{
    const int top = lua_gettop(L);
    const lua_Integer count = (lua_Integer)hobe_lua_list_size(L, list, "chart: quantities");
    int found = 0;
    for (lua_Integer i = 1; i <= count; i++, lua_settop(L, top)) {
        double value = NAN;
        lua_rawgeti(L, list, i);
        const char *name = hobe_lua_text(L, -1, "chart: a name in quantities");
        const char *what = lua_pushfstring(L, "chart: truth.%s", name);
        if (truth && lua_getfield(L, truth, name) != LUA_TNIL)
            value = hobe_lua_number(L, -1, what);
        hobe_text_add(text, "quantity\t%s\t%a\n", name, value);
        found += !isnan(value);
    }
    return found;
}

/* Those of the chart at index 1; whether it names any. */
static int read_quantities(lua_State *L, struct hobe_text *text)
{
    const int truth = push_table(L, "truth");
    int list = push_table(L, "quantities"), known = 0;
    if (truth) {
        push_names(L, truth, "truth");
        known = (int)lua_rawlen(L, -1);
        list = list ? list : lua_gettop(L);
    }
    if (list && add_quantities(L, text, list, truth) < known)
        hobe_lua_fail(L, "chart: truth has a name that is not among the quantities");
    return list && lua_rawlen(L, list) > 0;
}

/* A line `word` with name and value, or values, of each parameter in the table at `index`. */
static void add_parameters(lua_State *L, struct hobe_text *text, int index, const char *word)
{
    const int top = lua_gettop(L);
    push_names(L, index, "a table of parameters");
    for (lua_Integer i = 1; i <= (lua_Integer)lua_rawlen(L, top + 1); i++, lua_settop(L, top + 1)) {
        lua_rawgeti(L, top + 1, i);
        const char *name = lua_tostring(L, -1);
        hobe_text_add(text, "%s\t%s", word, name);
        lua_getfield(L, index, name);
        const int value = lua_gettop(L);
        if (!lua_istable(L, value))
            add_value(L, text, name);
        for (lua_Integer k = 1; lua_istable(L, value) && k <= (lua_Integer)lua_rawlen(L, value);
             k++, lua_settop(L, value)) {
            lua_rawgeti(L, value, k);
            add_value(L, text, name);
        }
        hobe_text_add(text, "\n");
    }
    lua_settop(L, top);
}

/* hobe.chart{quantities =, truth =, doubt =, ladder =, reference =} */
static int chart(lua_State *L)
{
    struct hobe_text *text = &hobe_lua_context(L)->chart;
    struct chart read;
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &chart_schema, &read);
    hobe_text_free(text); /* the last one counts */
    const int named = read_quantities(L, text);
    hobe_text_add(text, "doubt\t%a\n", read.doubt);
    const int reference = push_table(L, "reference");
    if (reference)
        add_parameters(L, text, reference, "reference");
    const int ladder = push_table(L, "ladder");
    const int groups = ladder ? (int)hobe_lua_list_size(L, ladder, "chart: ladder") : 0;
    for (int g = 1; g <= groups; g++) {
        if (lua_rawgeti(L, ladder, g) != LUA_TTABLE)
            hobe_lua_fail(L, "chart: ladder[%d] must be a table {parameter = {values}}, got %s", g,
                          hobe_lua_describe(L, -1));
        hobe_text_add(text, "group\n");
        add_parameters(L, text, lua_gettop(L), "axis");
        lua_settop(L, ladder);
    }
    hobe_lua_check_text(L, text);
    if (!hobe_lua_context(L)->ask || !named) /* without names the report tells them */
        return 0;
    lua_pushlightuserdata(L, hobe_lua_context(L));
    return lua_error(L);
}

const struct hobe_lua_entry hobe_lua_chart_entries[] = {
    {"chart", chart, "hobe.chart{quantities =, truth =, doubt =, ladder =, reference =}",
     "What `hobe chart CASE` makes of the case: a ladder of models, each a run of the case with "
     "other parameters (`hobe.param`), its errors in values of the report, and its cost.  `hobe "
     "run` takes no notice.  A case without it has a ladder of all elements and meshes.",
     &chart_schema, NULL},
    {0}};

/* ---- the record of a run -------------------------------------------------------------------- */

void hobe_lua_add_record(lua_State *L, struct hobe_text *text, const struct hobe_value *value,
                         size_t count)
{
    const struct hobe_lua *context = hobe_lua_context(L);
    hobe_text_add(text, "cost\t%a\t%a\t%ld\n", context->cost.setup, context->cost.solve,
                  context->cost.unknowns);
    hobe_text_add(text, "iterations\t%ld\n", context->cost.factorisations);
    if (context->stepped)
        hobe_text_add(text, "stepped\n");
    if (context->moved > 0)
        hobe_text_add(text, "moved\n");
    for (size_t i = 0; i < count; i++)
        hobe_text_add(text, "value\t%s\t%s\t%a\t%a\t%a\n", value[i].name,
                      value[i].unit ? value[i].unit : "", value[i].value,
                      value[i].has_expect ? value[i].expect : NAN,
                      value[i].has_within ? value[i].within : NAN);
    if (context->chart.at)
        hobe_text_add(text, "%s", context->chart.at);
    hobe_text_add(text, "end\n");
}
