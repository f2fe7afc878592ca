/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Limits on what a case script may use of time and memory.
 *
 * They are met by ending the process, since an error could be caught by pcall.  Nothing is lost by
 * that: results exist only in memory until a run has succeeded.
 *
 * Time.  A timer of the process raises a flag, and a hook that Lua calls every thousand
 * instructions sees it and knows the line.  A C function of the libraries can work for hours
 * between two instructions (patterns, table.move): where the hook has not come for half a second
 * more, the signal handler itself ends the process, and says the line that the last call of such a
 * function has left behind.
 *
 * Memory.  The allocator counts.  Lua answers a refusal by collecting its garbage and asking for
 * the same again; when it does not, or when that must be refused as well, the limit is met. */
#define _GNU_SOURCE
#include "lua_hobe.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

/* A line of a script; the name of the case, or the short name of another chunk. */
struct place {
    int line; /* 0: unknown */
    int other;
    char name[LUA_IDSIZE];
};

/* One a process, because signals are. */
static struct {
    const char *script; /* the case */
    lua_State *L;
    size_t bytes, used; /* memory: limit, in use */
    size_t refused;     /* size that was refused in `refusal` and not asked for again yet */
    struct place refusal;
    double seconds, spent, since;
    int running; /* the clock */
    int paused;
    volatile sig_atomic_t late;
    struct place place; /* of the last library call */
    char time_sentence[120], memory_sentence[120];
} limits;

/* ---- the end -------------------------------------------------------------------------------- */

/* The innermost line of the case that is running; else of another chunk, made with load. */
static void find_place(lua_State *L, struct place *place)
{
    lua_Debug at;
    *place = (struct place){0};
    for (int level = 0; lua_getstack(L, level, &at); level++) {
        lua_getinfo(L, "Sl", &at);
        int other = *at.source != '@' || !limits.script || strcmp(at.source + 1, limits.script);
        if (at.currentline <= 0 || (other && place->line > 0))
            continue;
        place->line = at.currentline;
        place->other = other;
        memcpy(place->name, at.short_src, sizeof place->name);
        if (!other)
            return;
    }
}

/* Appends a string; usable in a signal handler, as all that follows. */
static size_t put(char *line, size_t size, size_t at, const char *s)
{
    while (*s && at + 1 < size)
        line[at++] = *s++;
    line[at] = '\0';
    return at;
}

static size_t put_number(char *line, size_t size, size_t at, int n)
{
    char digits[16], *d = digits + sizeof digits;
    *--d = '\0';
    do
        *--d = (char)('0' + n % 10);
    while (n /= 10);
    return put(line, size, at, d);
}

static _Noreturn void end_process(const struct place *place, const char *sentence)
{
    char line[5000];
    size_t size = put(line, sizeof line, 0, "hobe: ");
    size = put(line, sizeof line, size, place->other ? place->name : limits.script);
    if (place->line > 0) {
        size = put(line, sizeof line, size, ":");
        size = put_number(line, sizeof line, size, place->line);
    }
    size = put(line, sizeof line, size, ": ");
    size = put(line, sizeof line, size, sentence);
    size = put(line, sizeof line, size, "\n");
    if (write(STDERR_FILENO, line, size) < 0)
        _exit(3); /* nobody to tell */
    _exit(1);
}

/* ---- memory --------------------------------------------------------------------------------- */

/* Whether more may be had: the process ends when it may not for a second time. */
static int may_grow(size_t more, size_t size)
{
    int fits = limits.bytes == 0 || limits.used + more <= limits.bytes;
    if (limits.refused > 0 && (limits.refused != size || !fits))
        end_process(&limits.refusal, limits.memory_sentence);
    limits.refused = fits ? 0 : size;
    if (!fits && limits.L)
        find_place(limits.L, &limits.refusal);
    return fits;
}

void hobe_lua_check_memory(void)
{
    if (limits.refused > 0)
        end_process(&limits.refusal, limits.memory_sentence);
}

static void *allocate(void *context, void *p, size_t old_size, size_t size)
{
    (void)context;
    old_size = p ? old_size : 0; /* without p it is a type */
    if (size == 0) {
        free(p);
        limits.used -= old_size;
        return NULL;
    }
    if (size > old_size && !may_grow(size - old_size, size))
        return NULL;
    void *moved = realloc(p, size);
    if (!moved)
        return NULL;
    limits.used += size - old_size;
    return moved;
}

lua_State *hobe_lua_new_state(const char *script, size_t bytes)
{
    limits.script = script;
    limits.bytes = bytes;
    snprintf(limits.memory_sentence, sizeof limits.memory_sentence,
             "the script needs more than %zu MB of memory (--memory-limit MB allows more)",
             bytes >> 20);
    limits.L = lua_newstate(allocate, NULL);
    return limits.L;
}

/* ---- time ----------------------------------------------------------------------------------- */

static void on_signal(int number)
{
    (void)number;
    if (limits.late)
        end_process(&limits.place, limits.time_sentence);
    limits.late = 1;
}

static void on_count(lua_State *L, lua_Debug *at)
{
    struct place place;
    (void)at;
    if (!limits.late)
        return;
    find_place(L, &place);
    end_process(&place, limits.time_sentence);
}

/* Processor time of the process, s. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Sets the timer to go off after `seconds` and every half second from then on; 0 stops it. */
static void set_timer(double seconds)
{
    struct itimerval timer = {.it_interval = {.tv_usec = 500000}};
    timer.it_value.tv_sec = (time_t)seconds;
    timer.it_value.tv_usec = (suseconds_t)(1e6 * (seconds - (double)(time_t)seconds));
    setitimer(ITIMER_PROF, &timer, NULL);
}

void hobe_lua_start_clock(lua_State *L, double seconds)
{
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART};
    limits.seconds = seconds;
    limits.running = 1;
    snprintf(limits.time_sentence, sizeof limits.time_sentence,
             "the script spent more than %g s in Lua itself (--time-limit S allows more)", seconds);
    sigaction(SIGPROF, &action, NULL);
    lua_sethook(L, on_count, LUA_MASKCOUNT, 1000);
    hobe_lua_resume_clock();
}

void hobe_lua_pause_clock(void)
{
    if (!limits.running)
        return;
    set_timer(0);
    limits.paused = 1;
    limits.spent += now() - limits.since;
}

void hobe_lua_resume_clock(void)
{
    if (!limits.running)
        return;
    double left = limits.seconds - limits.spent;
    limits.since = now();
    limits.paused = 0;
    set_timer(left > 1e-3 ? left : 1e-3);
}

int hobe_lua_clock_paused(void)
{
    return limits.paused;
}

void hobe_lua_mark_place(lua_State *L)
{
    find_place(L, &limits.place);
}
