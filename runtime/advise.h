/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cheapest model of a scene that holds an accuracy.
 *
 * Models differ in what sections can do, level by level, in the number of elements, and in whether
 * they are linear.  A few coarse ones say what the finest would: with Q(s, n) a quantity of the
 * level s on n elements,
 *
 *     Q = sum over s of the limit, as n grows, of D_s(n) = Q(s, n) - Q(s - 1, n),
 *
 * each limit by the order of convergence that its own sequence n = 1, 2, 4, ... shows (Richardson
 * 1911), refined where most is open; differences of levels converge on meshes that leave the
 * quantity itself far from converged.  A model is taken when it was run and lies within the
 * accuracy of Q, what is open of Q included; and models are tried in the order of their cost.  Then
 * other elements with the same modes of the section, and the linear response, may do it cheaper.
 *
 * In motions the step in time h adds one more difference, T(h) = Q(h) - Q(h_0) of the model taken,
 * with a limit of its own: meshes are chosen for half of the accuracy with the step h_0 of the
 * script, then the longest step is taken that holds the whole. */
#ifndef HOBE_ADVISE_H
#define HOBE_ADVISE_H

#include "hobe.h"
#include "output.h"

/* What a model leaves out to see what that loses; of these only inertia makes one cheaper. */
enum advise_without {
    ADVISE_COMPLETE,
    ADVISE_NO_SHEAR,   /* the section's mean shear strain is held by 1000 times its stiffness */
    ADVISE_NO_POISSON, /* nu = 0 in Poisson's coupling, with the same G */
    ADVISE_NO_INERTIA, /* motions are equilibria at the times of their states (quasi_static.h) */
    ADVISE_WITHOUTS
};

struct advise_model {
    const struct hobe_kernel *kernel;
    int elements; /* of the beam that has most; others in the proportions of the scene */
    int linear;   /* the linear response */
    int paper;    /* the paper's points of integration; else as the scene says */
    double step;  /* times the step in time of the script's motions of fixed step; 0: as it is */
    enum advise_without without;
};

/* A model as a word, "MGD30w:8", "MGD30w:8:linear:paper", "MGD30w:8:step=0.5", "MGD30w:8:no-shear":
 * text[ADVISE_WORD]; and back, HOBE_BAD_INPUT or HOBE_UNKNOWN for what is none. */
enum { ADVISE_WORD = 120 };
void advise_model_word(const struct advise_model *model, char *text);
enum hobe_status advise_read_model(const char *text, struct advise_model *model,
                                   struct hobe_error *err);

/* Changes a material so that it leaves that out; 0 where it cannot, for the shear factors it has.
 */
int advise_leave_out(enum advise_without without, struct hobe_material *material);

/* Runs a model: its quantities, value[quantities], and the iterations (factorisations) that it
 * takes.  HOBE_NO_MEMORY ends the search; any other error is that of this model, which then holds
 * nothing. */
typedef enum hobe_status advise_run(void *context, const struct advise_model *model, double *value,
                                    int *iterations, struct hobe_error *err);

struct advise_problem {
    int quantities;
    const char *const *name; /* [quantities] */
    const char *const *unit; /* [quantities], NULL: none of its own */
    double accuracy; /* largest error of a quantity, relative to it, or to a hundredth of the
                        largest of its unit, where that is more; what is below 1e-12 counts as 0 */
    int levels;      /* at most ADVISE_LEVELS; each section's modes contain those before */
    const struct hobe_kernel *const *level;
    int most;          /* elements, at most */
    int dynamic;       /* what motions without inertia lose is to be known */
    int moves;         /* the scene's motions take fixed steps in time, which are to be chosen */
    int weighs_linear; /* what a linear model loses is to be known, ... */
    int takes_linear;  /* ... and it may be taken */
    advise_run *run;
    void *context;
};

enum { ADVISE_LEVELS = 8, ADVISE_MOST = 256 };

/* The levels that hobe knows, of those elements that are built in: 1 y z, then w, wy and wz, and
 * those of distortion; level[ADVISE_LEVELS]; their number. */
int advise_levels(const struct hobe_kernel **level);

/* Whether two elements have the same modes of the section and the same mechanics, so that they tend
 * to the same and differ in how fast. */
int advise_same_section(const struct hobe_kernel *a, const struct hobe_kernel *b);

/* What the step from the level before to this one is about: "warping in torsion". */
const char *advise_step(const struct hobe_kernel *kernel);

/* Operations of a model that takes so many iterations: force and tangent of the elements, and
 * elimination along the beam. */
double advise_cost(const struct advise_model *model, int iterations);

/* A loss: the largest error of a quantity, relative, and which it is. */
struct advise_loss {
    double size;
    int quantity;
};

/* A model that was run. */
struct advise_trial {
    struct advise_model model;
    int failed;
    char *why;                /* the sentence, of one that failed */
    double *value;            /* [quantities] */
    double cost;              /* operations */
    struct advise_loss error; /* beside the estimate in the end; of one that ran */
};

struct advice {
    const struct advise_problem *problem; /* which must outlive it */
    int holds;                            /* the model holds the accuracy; else it came nearest */
    int model;                            /* the trial that is taken; -1: none ran */
    struct advise_loss error;             /* of it, by estimate, what is open included */
    double open;                          /* of the estimate of the quantities */
    struct advise_loss mesh;              /* error of its mesh alone */
    struct advise_loss step;              /* and of its step in time alone; NaN: not known */
    struct advise_loss level[ADVISE_LEVELS];     /* what leaving out the step to a level loses, 0 of
                                                    the first */
    struct advise_loss linear;                   /* what a linear model loses; NaN: not known */
    struct advise_loss without[ADVISE_WITHOUTS]; /* NaN: not known */
    double *best;                                /* [quantities], the estimate */
    double cost;                                 /* of all trials */
    struct advise_trial *trial;
    int trials, room;
};

/* Finds the model; *advice is to be freed whatever the status.  HOBE_NOT_CONVERGED where no model
 * runs, with what the last one says. */
enum hobe_status advise(const struct advise_problem *problem, struct advice *advice,
                        struct hobe_error *err);
void advice_free(struct advice *advice);

/* ---- what is said of it (advise_report.c) --------------------------------------------------- */

/* An effect, what leaving it out loses, and whether the model taken has it: "needed", "kept" where
 * it would not be, "left out"; for the mesh, what it costs. */
struct advise_effect {
    const char *effect, *verdict;
    struct advise_loss loss;
};
enum { ADVISE_EFFECTS = ADVISE_LEVELS + ADVISE_WITHOUTS + 3 };

/* Those that are known: effect[ADVISE_EFFECTS]; their number. */
int advise_evidence(const struct advice *advice, struct advise_effect *effect);

/* Appends the choice as a sentence, and the evidence as another. */
void advise_say(const struct advice *advice, struct hobe_text *text);
void advise_say_evidence(const struct advice *advice, struct hobe_text *text);

/* Appends values and evidence as tables; or, as JSON, a line, an object of four arrays: choice (one
 * object, with the command that runs it), values, evidence and trials. */
void advise_table(const struct advice *advice, struct hobe_text *text);
void advise_json(const struct advice *advice, const char *command, struct hobe_text *text);

#endif
