/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs that go on after a kill: the journal of each motion (journal.h) in the output folder, which
 * is taken away once all results are there. */
#define _GNU_SOURCE
#include "journal.h"
#include "lua_hobe.h"

#include <errno.h>
#include <string.h>

/* The sum of the bytes of the case; raises where it cannot be read. */
static uint64_t sum_script(lua_State *L, const char *script)
{
    struct hobe_text text = {0};
    char part[4096];
    size_t size;
    FILE *file = fopen(script, "rb");
    if (!file)
        luaL_error(L, "%s could not be read: %s", script, strerror(errno));
    while ((size = fread(part, 1, sizeof part, file)) > 0)
        hobe_text_bytes(&text, part, size);
    fclose(file);
    const uint64_t sum = journal_sum(text.at, text.size);
    hobe_text_free(&text);
    return sum;
}

/* That of the parameters from the command line, in whatever order Lua has them. */
static uint64_t sum_overrides(lua_State *L)
{
    uint64_t sum = 0;
    hobe_lua_push_store(L, HOBE_LUA_OVERRIDES);
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        size_t name_size, size;
        const char *name = lua_tolstring(L, -2, &name_size), *value = lua_tolstring(L, -1, &size);
        const uint64_t pair[2] = {journal_sum(name, name_size), journal_sum(value, size)};
        sum += journal_sum(pair, sizeof pair);
    }
    lua_pop(L, 1);
    return sum;
}

static void write_name(int solve, char name[64])
{
    snprintf(name, 64, "motion-%d.journal", solve);
}

hobe_journal *hobe_lua_open_journal(lua_State *L)
{
    struct hobe_lua *context = hobe_lua_context(L);
    char key[200], name[64];
    struct hobe_error err;
    if (!context->program || !context->folder)
        return NULL;
    snprintf(key, sizeof key, "hobe %s, %s: case %016llx, parameters %016llx, solve %d",
             HOBE_VERSION, hobe_machine(), (unsigned long long)sum_script(L, context->script),
             (unsigned long long)sum_overrides(L), context->solves);
    write_name(context->solves, name);
    hobe_journal *journal = journal_open(context->folder, name, key, context->resume, &err);
    if (!journal)
        hobe_lua_raise(L, &err);
    return journal;
}

void hobe_lua_drop_journals(lua_State *L)
{
    const struct hobe_lua *context = hobe_lua_context(L);
    for (int i = 1; context->folder && i <= context->solves; i++) {
        char name[64];
        write_name(i, name);
        journal_remove(context->folder, name);
    }
}
