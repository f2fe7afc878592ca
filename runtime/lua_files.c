/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of a run: kept in memory until the run has succeeded, then written together, so that a run
 * that fails leaves nothing behind.  And what case scripts may read: io.open sees the output folder
 * and nothing else, outlines come from the folder of the case. */
#define _GNU_SOURCE
#include "lua_hobe.h"

#include <errno.h>
#include <fcntl.h>
#include <lualib.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a script may do with io.open, which is outside the memory that Lua counts. */
static const size_t most_bytes = (size_t)256 << 20; /* in a run */
static const int most_opened = 2000;                /* in a run */

/* ---- staging -------------------------------------------------------------------------------- */

struct hobe_lua_file *hobe_lua_staged(lua_State *L, const char *name)
{
    struct hobe_lua_file *file = hobe_lua_context(L)->file;
    while (file && strcmp(file->name, name))
        file = file->next;
    return file;
}

/* Adds an empty file at the end of the list. */
static struct hobe_lua_file *add_file(lua_State *L, const char *name, const char *script)
{
    struct hobe_error err;
    size_t size = strlen(name) + 1, extra = script ? strlen(script) + 1 : 0;
    struct hobe_lua_file *file = hobe_alloc(1, sizeof *file + size + extra, &err);
    if (!file)
        hobe_lua_raise(L, &err);
    memcpy(file->name, name, size);
    if (script)
        file->script = memcpy(file->name + size, script, extra);
    struct hobe_lua_file **end = &hobe_lua_context(L)->file;
    while (*end)
        end = &(*end)->next;
    return *end = file;
}

static int is_reserved(const char *name)
{
    return !strcmp(name, "report.json") || !strcmp(name, "report.csv") ||
           !strcmp(name, "newton.csv") || !strcmp(name, "motion.csv") ||
           !strcmp(name, "report-notes.txt");
}

/* Raises when a file may not be staged under this name. */
static void check_name(lua_State *L, const char *name)
{
    struct hobe_error err;
    if (hobe_check_name(name, &err))
        hobe_lua_raise(L, &err);
    if (is_reserved(name) && !hobe_lua_context(L)->finishing)
        hobe_lua_fail(L, "file \"%s\" is one that hobe itself writes", name);
    if (hobe_lua_staged(L, name))
        hobe_lua_fail(L, "file \"%s\" is written twice in this run", name);
}

struct hobe_text *hobe_lua_stage(lua_State *L, const char *name)
{
    check_name(L, name);
    return &add_file(L, name, NULL)->text;
}

void hobe_lua_stage_picture(lua_State *L, const char *name, const char *script)
{
    check_name(L, name);
    add_file(L, name, script);
}

void hobe_lua_forget_files(struct hobe_lua *context)
{
    while (context->file) {
        struct hobe_lua_file *file = context->file;
        context->file = file->next;
        hobe_text_free(&file->text);
        hobe_free(file);
    }
}

void hobe_lua_check_file(lua_State *L, const char *verb, const char *file, const char *ending)
{
    struct hobe_error err;
    size_t size = strlen(file), end = strlen(ending);
    if (size <= end || strcmp(file + size - end, ending))
        hobe_lua_fail(L, "%s: file must end with %s, got \"%s\"", verb, ending, file);
    if (hobe_check_name(file, &err))
        hobe_lua_raise(L, &err);
}

/* Draws the pictures; without gnuplot that is a line on stderr, since the numbers are there. */
static void draw(lua_State *L, const char *folder)
{
    struct hobe_error err;
    int missing = 0;
    for (struct hobe_lua_file *file = hobe_lua_context(L)->file; file; file = file->next) {
        int drawn;
        if (!file->script)
            continue;
        if (hobe_plot_draw(folder, file->script, file->name, &drawn, &err))
            hobe_lua_raise(L, &err);
        missing += !drawn;
    }
    if (missing)
        fprintf(stderr,
                "hobe: gnuplot is not installed: %d picture%s not drawn, see the .gp files "
                "in %s\n",
                missing, missing > 1 ? "s" : "", folder);
}

void hobe_lua_write_files(lua_State *L)
{
    struct hobe_lua *context = hobe_lua_context(L);
    struct hobe_error err;
    fflush(NULL); /* files that the script left open */
    for (struct hobe_lua_file *file = context->file; file; file = file->next)
        hobe_lua_check_text(L, &file->text);
    for (struct hobe_lua_file *file = context->file; file; file = file->next) {
        const char *text = file->text.at ? file->text.at : "";
        if (!file->script &&
            hobe_write_file(context->folder, file->name, text, file->text.size, &err))
            hobe_lua_raise(L, &err);
    }
    draw(L, context->folder);
    hobe_lua_forget_files(context);
}

void hobe_lua_publish(lua_State *L)
{
    if (!hobe_lua_context(L)->program)
        hobe_lua_write_files(L);
}

/* ---- reading -------------------------------------------------------------------------------- */

/* Pushes the folder that relative names start from. */
static const char *push_source(lua_State *L)
{
    const char *script = hobe_lua_context(L)->script;
    const char *slash = script ? strrchr(script, '/') : NULL;
    if (!slash)
        return lua_pushliteral(L, ".");
    return lua_pushlstring(L, script, slash == script ? 1 : (size_t)(slash - script));
}

static int open_trusted(lua_State *L, const char *name, struct hobe_error *err)
{
    const char *path = name;
    if (*name != '/')
        path = lua_pushfstring(L, "%s/%s", push_source(L), name);
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
        hobe_fail(err, HOBE_IO, NULL, "%.500s could not be read: %s", path, strerror(errno));
    return file;
}

static int open_source(lua_State *L, const char *what, const char *name)
{
    const struct hobe_lua *context = hobe_lua_context(L);
    struct hobe_error err;
    if (!context->program || context->trusted) {
        const int file = open_trusted(L, name, &err);
        return file < 0 ? hobe_lua_fail(L, "%s: %s", what, err.message) : file;
    }
    if (hobe_check_name(name, NULL))
        hobe_lua_fail(L,
                      "%s: a case script reads files in its own folder and below: a relative name "
                      "without \"..\" is needed, got \"%s\" (hobe run --trust allows others)",
                      what, name);
    const int file = hobe_open_file(push_source(L), name, &err);
    if (file < 0)
        hobe_lua_fail(L,
                      "%s: %s; a case script reads regular files in its own folder and below, "
                      "through no symbolic link (hobe run --trust allows others)",
                      what, err.message);
    return file;
}

void hobe_lua_read_file(lua_State *L, const char *what, const char *name, size_t most,
                        struct hobe_text *text)
{
    const int top = lua_gettop(L), file = open_source(L, what, name);
    char bytes[1 << 14];
    ssize_t n;
    do {
        n = read(file, bytes, sizeof bytes);
        if (n > 0)
            hobe_text_bytes(text, bytes, (size_t)n);
    } while ((n > 0 && text->size <= most && !text->status) || (n < 0 && errno == EINTR));
    const int cause = errno;
    close(file);
    const enum hobe_status status = text->status;
    if (n < 0 || status)
        hobe_text_free(text);
    if (status)
        hobe_lua_check_text(L, &(struct hobe_text){.status = status});
    if (n < 0)
        hobe_lua_fail(L, "%s: %s could not be read: %s", what, name, strerror(cause));
    lua_settop(L, top);
}

/* ---- io.open -------------------------------------------------------------------------------- */

/* A stream of C on a staged file, which lives as long as the Lua state. */
struct cookie {
    struct hobe_text *text;
    size_t *written; /* in the whole run */
    size_t at;       /* read so far */
};

static ssize_t cookie_write(void *p, const char *bytes, size_t size)
{
    struct cookie *cookie = p;
    *cookie->written += size;
    if (*cookie->written > most_bytes)
        cookie->text->status = HOBE_NO_MEMORY; /* so that the run cannot end well */
    hobe_text_bytes(cookie->text, bytes, size);
    return cookie->text->status ? 0 : (ssize_t)size;
}

static ssize_t cookie_read(void *p, char *bytes, size_t size)
{
    struct cookie *cookie = p;
    size_t all = cookie->text->size; /* less than before if it was opened anew for writing */
    size_t left = cookie->at < all ? all - cookie->at : 0;
    size = size < left ? size : left;
    if (size > 0)
        memcpy(bytes, cookie->text->at + cookie->at, size);
    cookie->at += size;
    return (ssize_t)size;
}

static int cookie_close(void *p)
{
    hobe_free(p);
    return 0;
}

static int close_stream(lua_State *L)
{
    luaL_Stream *stream = luaL_checkudata(L, 1, LUA_FILEHANDLE);
    return luaL_fileresult(L, fclose(stream->f) == 0, NULL);
}

/* Pushes a Lua file that is not open yet: what is opened next belongs to it at once. */
static luaL_Stream *push_stream(lua_State *L)
{
    luaL_Stream *stream = lua_newuserdatauv(L, sizeof *stream, 0);
    *stream = (luaL_Stream){0};
    luaL_setmetatable(L, LUA_FILEHANDLE);
    return stream;
}

static FILE *open_text(lua_State *L, struct hobe_text *text, const char *mode)
{
    static const cookie_io_functions_t functions = {
        .read = cookie_read, .write = cookie_write, .close = cookie_close};
    struct cookie *cookie = hobe_alloc(1, sizeof *cookie, NULL);
    if (!cookie)
        return NULL;
    *cookie = (struct cookie){text, &hobe_lua_context(L)->written, 0};
    FILE *f = fopencookie(cookie, mode, functions);
    if (!f)
        hobe_free(cookie);
    return f;
}

static FILE *open_disk(lua_State *L, const char *name)
{
    struct hobe_error err;
    int file = hobe_open_file(hobe_lua_context(L)->folder, name, &err);
    if (file < 0 && err.status == HOBE_BAD_INPUT)
        hobe_lua_raise(L, &err);
    FILE *f = file < 0 ? NULL : fdopen(file, "r");
    if (file >= 0 && !f)
        close(file);
    return f;
}

/* What a script writes is gathered anew when it opens the same file for writing again. */
static struct hobe_text *stage_again(lua_State *L, const char *name)
{
    struct hobe_lua_file *file = hobe_lua_staged(L, name);
    if (!file) {
        hobe_lua_stage(L, name);
        file = hobe_lua_staged(L, name);
        file->by_script = 1;
    }
    if (!file->by_script)
        hobe_lua_fail(L, "file \"%s\" is written twice in this run", name);
    hobe_text_free(&file->text);
    return &file->text;
}

int hobe_lua_io_open(lua_State *L)
{
    const char *name = hobe_lua_text(L, 1, "io.open: the file name");
    const char *mode = luaL_optstring(L, 2, "r");
    int reads = !strcmp(mode, "r") || !strcmp(mode, "rb");
    if (!reads && strcmp(mode, "w") && strcmp(mode, "wb"))
        hobe_lua_fail(L, "io.open: a case script opens files with \"r\" or \"w\", got %s",
                      hobe_lua_describe(L, 2));
    if (!hobe_lua_context(L)->folder)
        hobe_lua_fail(L, "io.open: there is no output folder; run with --out DIR");
    if (hobe_lua_context(L)->opened++ >= most_opened)
        hobe_lua_fail(L, "io.open: a case script may open %d files", most_opened);
    luaL_Stream *stream = push_stream(L);
    struct hobe_lua_file *staged = hobe_lua_staged(L, name);
    if (!reads)
        stream->f = open_text(L, stage_again(L, name), "w");
    else if (staged && !staged->script)
        stream->f = open_text(L, &staged->text, "r");
    else
        stream->f = open_disk(L, name);
    if (!stream->f)
        return luaL_fileresult(L, 0, name);
    stream->closef = close_stream;
    return 1;
}
