/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the rooms of the Lua face share: the context of a Lua state, errors with file and line, the
 * lists of what the module offers.  Only lua_*.c and main.c include this. */
#ifndef HOBE_LUA_HOBE_H
#define HOBE_LUA_HOBE_H

#include "hobe.h"
#include "lua_schema.h"
#include "output.h"

#include <lauxlib.h>
#include <lua.h>
#include <stdio.h>

/* ---- what the module offers (each room has its list) ---------------------------------------- */

/* One function or method: code and reference text in one record. */
struct hobe_lua_entry {
    const char *name; /* NULL ends a list */
    lua_CFunction function;
    const char *usage;                    /* as it is called */
    const char *doc;                      /* Markdown */
    const struct hobe_lua_schema *schema; /* of its table of arguments, or NULL */
    const struct hobe_lua_field *field;   /* of the object it returns, or NULL */
};

extern const struct hobe_lua_entry hobe_lua_section_entries[];   /* lua_section.c */
extern const struct hobe_lua_entry hobe_lua_composite_entries[]; /* lua_composite.c */
extern const struct hobe_lua_entry hobe_lua_taper_entries[];     /* lua_taper.c */
extern const struct hobe_lua_entry hobe_lua_section_methods[];   /* lua_taper.c */
extern const struct hobe_lua_entry hobe_lua_beam_entries[];      /* lua_beam.c */
extern const struct hobe_lua_entry hobe_lua_body_entries[];      /* lua_body.c */
extern const struct hobe_lua_entry hobe_lua_joint_entries[];     /* lua_joint.c */
extern const struct hobe_lua_entry hobe_lua_spring_entries[];    /* lua_spring.c */
extern const struct hobe_lua_entry hobe_lua_load_entries[];      /* lua_load.c */
extern const struct hobe_lua_entry hobe_lua_drive_entries[];     /* lua_drive.c */
extern const struct hobe_lua_entry hobe_lua_scene_entries[];     /* lua_scene.c */
extern const struct hobe_lua_entry hobe_lua_reduce_entries[];    /* lua_reduce.c */
extern const struct hobe_lua_entry hobe_lua_reduced_methods[];   /* lua_reduce.c */
extern const struct hobe_lua_entry hobe_lua_solve_entries[];     /* lua_solve.c */
extern const struct hobe_lua_entry hobe_lua_result_methods[];    /* lua_result.c */
extern const struct hobe_lua_entry hobe_lua_dynamic_entries[];   /* lua_dynamic.c */
extern const struct hobe_lua_entry hobe_lua_history_methods[];   /* lua_dynamic.c */
extern const struct hobe_lua_entry hobe_lua_modal_entries[];     /* lua_modal.c */
extern const struct hobe_lua_entry hobe_lua_modes_methods[];     /* lua_modal.c */
extern const struct hobe_lua_entry hobe_lua_kernel_entries[];    /* lua_kernel.c */
extern const struct hobe_lua_entry hobe_lua_kernel_methods[];    /* lua_kernel.c */
extern const struct hobe_lua_entry hobe_lua_report_entries[];    /* lua_report.c */
extern const struct hobe_lua_entry hobe_lua_chart_entries[];     /* lua_chart.c */
extern const struct hobe_lua_entry hobe_lua_figure_entries[];    /* lua_figure.c */
extern const struct hobe_lua_entry hobe_lua_picture_entries[];   /* lua_picture.c */
extern const struct hobe_lua_entry hobe_lua_vtk_entries[];       /* lua_vtk.c */

/* Chapters of the module and of its reference, in order; the last has no title. */
struct hobe_lua_chapter {
    const char *title;
    const struct hobe_lua_entry *entry;
    int methods; /* of an object, not functions of the module */
};
extern const struct hobe_lua_chapter hobe_lua_chapters[]; /* lua_hobe.c */

/* Sets the functions of a list in the table on top of the stack. */
void hobe_lua_add_entries(lua_State *L, const struct hobe_lua_entry *entry);

/* Sets the metatable of the userdata on top of the stack, made at the first call: the registry
 * name `type` ("hobe.scene"), a finalizer, methods (a list or NULL), and `field`, which is called
 * with the object and a key that is no method.  Both are NULL where no script sees the object. */
void hobe_lua_set_type(lua_State *L, const char *type, lua_CFunction finalizer,
                       const struct hobe_lua_entry *methods, lua_CFunction field);

/* Pushes a section that is still empty, so that what is made next is owned from the start. */
hobe_section **hobe_lua_new_section(lua_State *L);

/* ---- the context ---------------------------------------------------------------------------- */

/* A file that waits for the end of the run. */
struct hobe_lua_file {
    struct hobe_lua_file *next;
    struct hobe_text text;
    int by_script; /* opened with io.open */
    char *script;  /* of a picture: the gnuplot script that draws `name`; no text then */
    char name[];
};

struct advise_model; /* advise.h */

/* What is warned of. */
enum hobe_lua_warning {
    HOBE_LUA_WARN_WALLS,
    HOBE_LUA_WARN_COLLAPSE,
    HOBE_LUA_WARN_MESH,
    HOBE_LUA_WARN_UNSTABLE,
    HOBE_LUA_WARN_JUMP,
    HOBE_LUA_WARN_STEPS,
    HOBE_LUA_WARN_DAMPING,
    HOBE_LUA_WARN_ADVICE,
    HOBE_LUA_WARNINGS
};

/* One per Lua state, in its registry; freed with it. */
struct hobe_lua {
    int program;        /* in the hobe program results wait for the end of the run, so that a run
                           that fails leaves none; in a stock Lua they appear at once */
    int log;            /* print Newton's log and every warning on stderr */
    int progress;       /* stderr is a terminal: show how far a solve is */
    const char *folder; /* for results, or NULL: no files; kept by the caller */
    const char *script; /* the case, or NULL in a stock Lua; kept by the caller */
    int trusted;        /* the case may read any file */
    int resume;         /* motions go on from their journals */
    int solves;         /* calls of a solver verb so far */
    const struct advise_model *model; /* in place of what the script says of its models, or NULL;
                                         kept by the caller */
    int stepped;                      /* some motion took steps in time that are fixed */
    int moved;                        /* 1: some did, whose states are at times of their own; -1:
                                         one of them where steps end; 0: none */
    int trying;                       /* models are being tried: nothing is noted */
    int overridden;                   /* some parameter is not at its default */
    int called;                       /* a function of the script is being called by the core */
    int finishing;                    /* the report's own files may be staged */
    int opened;                       /* calls of io.open so far */
    size_t written;                   /* bytes written to their files so far */
    struct hobe_text tables;          /* tables for stdout */
    struct hobe_text newton;          /* the log of all solves as CSV */
    struct hobe_text motion;          /* the balance of all motions as CSV */
    struct hobe_text chart;           /* what hobe.chart says, in lines of a record (ladder.h) */
    int ask;                          /* that is all: hobe.chart raises the context itself as an
                                         error */
    struct {                          /* what the scenes took so far */
        double setup, solve;          /* s */
        long unknowns;                /* of the largest */
        long factorisations;          /* of statics and paths; of motions iterations, each
                                         of which evaluates forces even where it factors nothing */
    } cost;
    long warned[HOBE_LUA_WARNINGS]; /* how often */
    struct hobe_lua_file *file;
};

struct hobe_lua *hobe_lua_context(lua_State *L);

/* Seconds of a monotonic clock. */
double hobe_lua_now(void);

/* The journal of the motion that is about to be solved, to be closed by the caller; NULL where
 * there is no output folder.  Raises.  (lua_resume.c) */
struct hobe_journal *hobe_lua_open_journal(lua_State *L);

/* Removes those of all motions of this run. */
void hobe_lua_drop_journals(lua_State *L);

/* Tables that belong to the context. */
enum hobe_lua_store {
    HOBE_LUA_OVERRIDES = 1, /* parameter -> text from the command line */
    HOBE_LUA_PARAMETERS,    /* parameter -> default */
    HOBE_LUA_REPORT,        /* name -> {value, unit, expect, within, where} */
    HOBE_LUA_NOTES,         /* lines for people, in order and as keys */
    HOBE_LUA_KEPT,          /* strings that C points to */
    HOBE_LUA_STORES = HOBE_LUA_KEPT
};
void hobe_lua_push_store(lua_State *L, enum hobe_lua_store store);

/* ---- notes and warnings (lua_notes.c) ------------------------------------------------------- */

/* Remembers a line that people should see with the results; the same line only once.  Whether it is
 * new. */
int hobe_lua_note(lua_State *L, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same, and writes the first of a kind, or with context->log each, to standard error with the
 * place in the script: whoever takes the numbers alone should see it, too. */
void hobe_lua_warn(lua_State *L, enum hobe_lua_warning kind, const char *text);

/* Says on standard error how many more there were of each kind, if any, and forgets them. */
void hobe_lua_count_warnings(struct hobe_lua *context);

/* Appends the notes, after an empty line where there is text, and of more than `most` how many. */
void hobe_lua_add_notes(lua_State *L, struct hobe_text *text, long most);

/* ---- files for the end of the run (lua_files.c) --------------------------------------------- */

/* Raises unless `file` is a good name that ends with `ending`.  So it is checked without an output
 * folder, too: whether a script is right must not depend on --out. */
void hobe_lua_check_file(lua_State *L, const char *verb, const char *file, const char *ending);

/* A text that will become the file `name` in the output folder; owned by the context.  Raises on a
 * bad name and on one that is taken. */
struct hobe_text *hobe_lua_stage(lua_State *L, const char *name);

/* The staged file, or NULL. */
struct hobe_lua_file *hobe_lua_staged(lua_State *L, const char *name);

/* Has the picture `name` drawn by the staged gnuplot script once the files are written. */
void hobe_lua_stage_picture(lua_State *L, const char *name, const char *script);

/* Writes all staged files into the context's folder, draws the pictures, and forgets them. */
void hobe_lua_write_files(lua_State *L);
void hobe_lua_forget_files(struct hobe_lua *context);

/* Writes them now where there is no end of the run: in a stock Lua files appear at once. */
void hobe_lua_publish(lua_State *L);

/* Reads the file `name` for hobe.`what` into the empty text, which the caller frees.  A relative
 * name starts from the folder of the case, in a stock Lua from the working folder.  A case that is
 * not trusted reads regular files in its folder and below, through no symbolic link.  Raises, with
 * the text freed; reading ends soon after `most` bytes, which the caller refuses. */
void hobe_lua_read_file(lua_State *L, const char *what, const char *name, size_t most,
                        struct hobe_text *text);

/* io.open(name, "r" or "w") inside the output folder, for the sandbox. */
int hobe_lua_io_open(lua_State *L);

/* ---- values -------------------------------------------------------------------------------- */

/* Pushes a list of the n numbers x; returns 1. */
int hobe_lua_push_numbers(lua_State *L, const double *x, int n);

/* ---- errors --------------------------------------------------------------------------------- */

/* Pushes "file:line" of the innermost Lua function that is running, or "". */
void hobe_lua_where(lua_State *L);

/* Raise an error, the place in front: with a format of lua_pushfstring; from err, whose own
 * `where` goes before the place of the call. */
int hobe_lua_fail(lua_State *L, const char *format, ...) __attribute__((noreturn));
int hobe_lua_raise(lua_State *L, const struct hobe_error *err) __attribute__((noreturn));

/* Raises when a text of ours is incomplete for want of memory. */
void hobe_lua_check_text(lua_State *L, const struct hobe_text *text);

/* ---- run, from main.c ----------------------------------------------------------------------- */

/* The module: what `require "hobe"` gives. */
int luaopen_hobe(lua_State *L);

/* Raises when an override was never asked for by hobe.param. */
void hobe_lua_check_overrides(lua_State *L);

/* How results are printed; a record is what a ladder reads (ladder.h). */
enum hobe_lua_format { HOBE_LUA_TABLE, HOBE_LUA_JSON, HOBE_LUA_CSV, HOBE_LUA_RECORD };

/* The end of a run: writes the files, then the report to `to`.  Returns 1, with a sentence on top
 * of the stack, when a value missed its expectation, else 0. */
int hobe_lua_finish(lua_State *L, enum hobe_lua_format format, FILE *to);

/* Appends the record of the run, with the values of its report (lua_chart.c). */
void hobe_lua_add_record(lua_State *L, struct hobe_text *text, const struct hobe_value *value,
                         size_t count);

/* Writes the reference of the Lua module as Markdown (lua_docs.c). */
void hobe_lua_print_docs(FILE *to);

/* ---- limits and sandbox (lua_limits.c, lua_sandbox.c) --------------------------------------- */

/* A Lua state for the program, to run the case in file `script`; its memory ends at `bytes` (0: no
 * limit).  NULL when there is no memory.  One a process: a script that asks for more memory, or
 * time, than it may have ends the process with a sentence. */
lua_State *hobe_lua_new_state(const char *script, size_t bytes);

/* Ends the process where the limit of memory was met, even if the script has caught the error. */
void hobe_lua_check_memory(void);

/* Starts the clock: the script may spend `seconds` of processor time in Lua. */
void hobe_lua_start_clock(lua_State *L, double seconds);

/* Around the work of a solver verb, which is not Lua's time.  No Lua error may be raised between
 * the two.  Nothing happens where no clock was started. */
void hobe_lua_pause_clock(void);
void hobe_lua_resume_clock(void);

/* Whether it is in such work: a function of the script that the core calls there resumes the clock.
 */
int hobe_lua_clock_paused(void);

/* Remembers the running line, for the sentence about a limit that is met inside a C function. */
void hobe_lua_mark_place(lua_State *L);

/* Opens the safe part of the standard libraries and puts nothing else within reach. */
void hobe_lua_open_sandbox(lua_State *L);

#endif
