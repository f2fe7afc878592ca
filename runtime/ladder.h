/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A ladder: many models of one case, each with its errors and its cost.
 *
 * A rung of it is a model, said by the words "element=MGD30w elements=8" that change the case's
 * parameters.  Whoever owns the ladder runs them; what a run says comes back as a record. */
#ifndef HOBE_LADDER_H
#define HOBE_LADDER_H

#include "bench_clock.h"
#include "output.h"

/* ---- what a run says (ladder_record.c) ------------------------------------------------------ */

/* Lines of words, apart by tabs:
 *
 *     value NAME UNIT VALUE EXPECTED WITHIN
 *                                     of the report; numbers in C's %a, nan where there is none
 *     cost SETUP SOLVE UNKNOWNS       s, s, and scalar unknowns of the largest scene
 *     memory BYTES                    at most, above what the process began with
 *     quantity NAME TRUTH             this and what follows is what hobe.chart says
 *     doubt X
 *     reference NAME VALUE
 *     group
 *     axis NAME VALUE ...             of the group above; parameters by name
 *     end                             or the record was cut off */
struct ladder_line {
    int words;
    char **word; /* [words] */
};

/* Lines point into `text`, which is the record's own. */
struct ladder_record {
    char *text;
    int lines, whole; /* whole: it has its end */
    struct ladder_line *line;
    char **word; /* of all lines */
};

/* Splits size bytes at text, which are copied; *record is to be freed whatever the status. */
enum hobe_status ladder_record_read(const char *text, size_t size, struct ladder_record *record,
                                    struct hobe_error *err);
void ladder_record_free(struct ladder_record *record);

/* The i-th line (from 0) that begins with `word` and has at least so many words; NULL past the
 * last. */
const struct ladder_line *ladder_find(const struct ladder_record *record, const char *word,
                                      int words, int i);

/* The number that a word says; NaN where it says none. */
double ladder_number(const char *word);

/* ---- the ladder (ladder.c) ------------------------------------------------------------------ */

/* What errors are of. */
struct ladder_quantity {
    char *name, *unit;    /* unit: NULL before a run has told it */
    double truth, expect; /* NaN where not known */
    double within;        /* how far from `expect` the case calls right, as hobe_value's; or NaN */
    double doubt;         /* that, where the truth is what is expected; 0 else */
    double open;          /* how far a converged run may be off, absolute; 0 of other truths */
};

/* A parameter and the values that it takes, in turn. */
struct ladder_axis {
    char *name;
    int values;
    char **value; /* [values] */
};

struct ladder_group {
    int axes;
    struct ladder_axis *axis; /* [axes], by name */
};

/* Clocks of a rung: building its scenes, solving them, and both. */
enum {
    LADDER_SETUP,
    LADDER_SOLVE,
    LADDER_TOTAL,
    LADDER_TIMES,
    LADDER_ROUNDS = 15,
    LADDER_MOST_RUNGS = 1000
};

struct ladder_rung {
    int place;             /* in the ladder, from 0, before it is sorted */
    char *model;           /* "element=MGD30w elements=8" */
    char *kind;            /* its element, or the value of its first axis: what it is drawn as */
    char *why;             /* the sentence it failed with; NULL: it did not */
    double *value, *error; /* [quantities]; errors over ladder_scale */
    double worst, excess;  /* the largest of them; of what they are above the doubt of the truth */
    int rounds;
    double sample[LADDER_TIMES][LADDER_ROUNDS]; /* [.][rounds] s */
    struct bench_time time[LADDER_TIMES];
    double wasted; /* s, of a run that failed, from its start to its end */
    double unknowns;
    double bytes; /* of memory */
    int front;    /* none is both faster and as right, or as fast and more right, as far as the
                     truth is known */
};

/* The model that stands for the truth where the case knows none, on its two finest meshes. */
struct ladder_reference {
    char *model[2]; /* [0] coarser, [1] taken; NULL: the truth is the case's own */
    double apart;   /* largest relative difference of a quantity between the two */
};

struct ladder {
    int quantities, rungs, groups;
    int by_model; /* rungs change element and mesh of all scenes, "--model=MGD30w:8", whatever the
                     parameters of the case */
    struct ladder_quantity *quantity;
    struct ladder_group *group;
    struct ladder_rung *rung; /* in the order of their cost, failures last, once climbed */
    struct ladder_reference reference;
    double doubt;            /* of all truths, relative: errors below it say nothing */
    struct hobe_text common; /* " P=10": words that all runs share, each after a blank */
};

/* Runs the case with these words, apart by blanks ("": none); where it is asked alone what its
 * ladder is, it may end with hobe.chart.  A run that fails is no
 * error: *why is its sentence then, of the caller's (hobe_text), and record empty; *seconds is how
 * long it took. */
typedef enum hobe_status ladder_run(void *context, const char *words, int ask,
                                    struct ladder_record *record, struct hobe_text *why,
                                    double *seconds, struct hobe_error *err);

struct ladder_options {
    /* From the command line.  Axes take the place of the case's own of the same name, or join them;
     * one of a single value that the case's ladder does not have is common to all runs, and what is
     * expected of the case then no longer counts as true.  One of the name "--model" takes the
     * place of the whole ladder. */
    int given;
    const struct ladder_axis *axis; /* [given] */
    int quick;                      /* every other value of long axes of numbers, three rounds */
    ladder_run *run;
    void *context;
    void (*progress)(const char *what, const char *words); /* says what is run now */
};

/* Asks the case for its ladder, runs all rungs in turn, round after round, at least three, and
 * finds their errors and the front.  *ladder is to be freed whatever the status. */
enum hobe_status ladder_climb(const struct ladder_options *options, struct ladder *ladder,
                              struct hobe_error *err);
void ladder_free(struct ladder *ladder);

/* What errors of the q-th quantity are relative to: its truth, or a hundredth of the largest of the
 * same unit where that is more; 1 where all are 0. */
double ladder_scale(const struct ladder *ladder, int q);

/* Of ladder_models.c: the groups of the case, or all elements and meshes where it has none, and the
 * axes given; the rungs that they make, none twice; the most elements that a rung has, or 0 where
 * they do not say; copies of texts. */
enum hobe_status ladder_make_rungs(const struct ladder_options *options,
                                   const struct ladder_record *record, struct ladder *ladder,
                                   struct hobe_error *err);
double ladder_most(const struct ladder *ladder);

/* Axes whose values make a word of `hobe run --model` in a case that has no ladder, and that word
 * itself; NULL at the end. */
extern const char *const ladder_model_axis[];
char *ladder_copy(const char *text, struct hobe_error *err);
void ladder_free_groups(struct ladder *ladder);

/* ---- what is said of it (ladder_report.c) --------------------------------------------------- */

struct ladder_case {
    const char *script, *machine; /* where times were measured */
};

enum ladder_format { LADDER_TABLE, LADDER_JSON, LADDER_CSV };

/* Appends the ladder: for people, or one table of everything. */
void ladder_text(const struct ladder *ladder, const struct ladder_case *of,
                 enum ladder_format format, struct hobe_text *text);

/* chart.csv, chart.json and the picture chart.png into a folder; *drawn as hobe_plot_draw. */
enum hobe_status ladder_write(const struct ladder *ladder, const struct ladder_case *of,
                              const char *folder, int *drawn, struct hobe_error *err);

#endif
