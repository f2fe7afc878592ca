/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What people should see beside the numbers: notes, kept for the end of the run, and warnings, of
 * which each kind is told at once the first time and counted after that: a sweep that warns of
 * every mesh would drown the rest. */
#include "lua_hobe.h"

#include <stdarg.h>

/* "how many more of ..." */
static const char *const kinds[HOBE_LUA_WARNINGS] = {
    [HOBE_LUA_WARN_WALLS] = "bent walls",
    [HOBE_LUA_WARN_COLLAPSE] = "collapsed outlines",
    [HOBE_LUA_WARN_MESH] = "coarse meshes",
    [HOBE_LUA_WARN_UNSTABLE] = "unstable equilibria",
    [HOBE_LUA_WARN_JUMP] = "jumps past limit points",
    [HOBE_LUA_WARN_STEPS] = "long steps in time",
    [HOBE_LUA_WARN_DAMPING] = "rho above 0.9",
    [HOBE_LUA_WARN_ADVICE] = "accuracies that nothing holds",
};

int hobe_lua_note(lua_State *L, const char *format, ...)
{
    char line[1200];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    if (hobe_lua_context(L)->trying)
        return 0;
    hobe_lua_push_store(L, HOBE_LUA_NOTES);
    const int is_new = lua_getfield(L, -1, line) == LUA_TNIL;
    if (is_new) {
        lua_pushboolean(L, 1);
        lua_setfield(L, -3, line);
        lua_pushstring(L, line);
        lua_rawseti(L, -3, (lua_Integer)lua_rawlen(L, -3) + 1);
    }
    lua_pop(L, 2);
    return is_new;
}

void hobe_lua_warn(lua_State *L, enum hobe_lua_warning kind, const char *text)
{
    struct hobe_lua *context = hobe_lua_context(L);
    if (!hobe_lua_note(L, "%s", text) || (context->warned[kind]++ && !context->log))
        return;
    hobe_lua_where(L);
    fprintf(stderr, "%s: warning: %s\n", lua_tostring(L, -1), text);
    lua_pop(L, 1);
}

void hobe_lua_count_warnings(struct hobe_lua *context)
{
    const char *before = "hobe: warning: besides the first of each kind, ";
    for (int k = 0; k < HOBE_LUA_WARNINGS; k++) {
        if (context->warned[k] > 1 && !context->log) {
            fprintf(stderr, "%s%ld of %s", before, context->warned[k] - 1, kinds[k]);
            before = ", ";
        }
        context->warned[k] = 0;
    }
    if (*before == ',')
        fputs(context->program ? ": --log tells all, and --out DIR keeps them in report-notes.txt\n"
                               : "\n",
              stderr);
}

void hobe_lua_add_notes(lua_State *L, struct hobe_text *text, long most)
{
    hobe_lua_push_store(L, HOBE_LUA_NOTES);
    const lua_Integer count = (lua_Integer)lua_rawlen(L, -1);
    for (lua_Integer i = 1; i <= count && i <= most; i++) {
        lua_rawgeti(L, -1, i);
        hobe_text_add(text, "%s%s\n", i == 1 && text->size > 0 ? "\n" : "", lua_tostring(L, -1));
        lua_pop(L, 1);
    }
    if (count > most)
        hobe_text_add(text, "... and %lld more such lines, with --out DIR in report-notes.txt\n",
                      (long long)(count - most));
    lua_pop(L, 1);
}
