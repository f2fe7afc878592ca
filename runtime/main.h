/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the words of the program share: main.c and main_*.c. */
#ifndef HOBE_MAIN_H
#define HOBE_MAIN_H

#include "advise.h"
#include "ladder.h"
#include "lua_hobe.h"
#include "output.h"

/* One line on standard error, whatever the message holds; returns the exit status given. */
int complain(const char *message, int status);

/* The same of a message with one word in it; returns 2, for a wrong command line. */
int complain_usage(const char *format, const char *word);

/* The value of option `name` at argv[*i] ("--name value" or "--name=value"), or NULL. */
char *option(char **argv, int *i, const char *name);

/* Reads the value of --format; 0, or the exit status after a complaint. */
int read_format(const char *text, enum hobe_lua_format *format);

/* Prints a text and frees it; the exit status. */
int print_text(struct hobe_text *text);

/* A run of a case. */
struct run {
    const char *script, *folder;
    enum hobe_lua_format format;
    int log, trust, resume;
    int ask;                          /* the script ends with hobe.chart, if it calls that */
    const struct advise_model *model; /* of all scenes, or NULL: as they say */
    double seconds, megabytes;        /* < 0: not given; 0: no limit */
    int overrides;
    char **override; /* [overrides] "name=value", or "--model=..." for `model` */
    FILE *to;        /* where results go; file descriptor 1 leads to standard error meanwhile */
};

/* What a script may take that is not trusted: s of processor time in Lua, and MB. */
enum { RUN_SECONDS = 10, RUN_MEGABYTES = 512 };

/* Runs the script; returns the exit status. */
int run_script(struct run *run);

/* Runs a script with words for it, apart by blanks, in a process of its own (main_chart.c).  A run
 * that fails is no error: *why is its sentence, of the caller's, and the record has no end. */
enum hobe_status run_apart(const char *script, const char *words, struct ladder_record *record,
                           struct hobe_text *why, struct hobe_error *err);

/* hobe advise, argv[2..] its arguments; the exit status (main_advise.c). */
int command_advise(int argc, char **argv);

/* hobe chart, argv[2..] its arguments; the exit status (main_chart.c). */
int command_chart(int argc, char **argv);

/* hobe bench, argv[2..] its arguments; the exit status (main_bench.c). */
int command_bench(int argc, char **argv);

#endif
