/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hobe advise: the cheapest model of a case that holds an accuracy.  Each model is a run of the
 * case in a process of its own. */
#include "main.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double ACCURACY = 1e-3;
enum { MOST_ELEMENTS = 128 };

/* A case and the report of its first run, as the script has it. */
struct subject {
    const char *script;
    double accuracy;
    enum hobe_lua_format format; /* table or JSON */
    struct hobe_text words;      /* "P=10 angle=30" */
    struct ladder_record first;
    int quantities;
    const char **name, **unit; /* [quantities], in `first` */
};

/* ---- runs ------------------------------------------------------------------------------------ */

static const struct ladder_line *find_value(const struct ladder_record *record, const char *name)
{
    const struct ladder_line *line;
    for (int i = 0; (line = ladder_find(record, "value", 4, i)); i++)
        if (!strcmp(line->word[1], name))
            return line;
    return NULL;
}

/* What a whole record says: values and iterations. */
static enum hobe_status read_record(const struct subject *subject,
                                    const struct ladder_record *record, double *value,
                                    int *iterations, struct hobe_error *err)
{
    const struct ladder_line *took = ladder_find(record, "iterations", 2, 0);
    *iterations = took ? (int)fmax(1, ladder_number(took->word[1])) : 1;
    for (int q = 0; q < subject->quantities; q++) {
        const struct ladder_line *line = find_value(record, subject->name[q]);
        if (!line)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL, "it reports no %.100s", subject->name[q]);
        value[q] = ladder_number(line->word[3]);
    }
    return HOBE_OK;
}

/* A line on the terminal that the next one overwrites. */
static void show_progress(const char *what)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%s", what);
}

static enum hobe_status run_model(void *context, const struct advise_model *model, double *value,
                                  int *iterations, struct hobe_error *err)
{
    const struct subject *subject = context;
    struct ladder_record record = {0};
    struct hobe_text words = {0}, why = {0};
    char word[ADVISE_WORD];
    advise_model_word(model, word);
    show_progress(word);
    hobe_text_add(&words, "%s --model=%s", subject->words.at ? subject->words.at : "", word);
    enum hobe_status status = hobe_text_check(&words, err);
    if (!status)
        status = run_apart(subject->script, words.at, &record, &why, err);
    if (!status && !record.whole)
        status = hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s", why.at ? why.at : "it ended early");
    if (!status)
        status = read_record(subject, &record, value, iterations, err);
    ladder_record_free(&record);
    hobe_text_free(&words);
    hobe_text_free(&why);
    return status;
}

/* Runs the case as it is, for the names of what it reports: those that hobe.chart names, else all.
 */
static enum hobe_status ask(struct subject *subject, struct hobe_error *err)
{
    struct hobe_text why = {0};
    enum hobe_status status = run_apart(subject->script, subject->words.at ? subject->words.at : "",
                                        &subject->first, &why, err);
    if (!status && !subject->first.whole)
        status = hobe_fail(err, HOBE_BAD_INPUT, NULL, "%s", why.at ? why.at : "it ended early");
    hobe_text_free(&why);
    if (status)
        return status;
    const struct ladder_record *record = &subject->first;
    const size_t most = (size_t)record->lines;
    subject->name = hobe_alloc(2 * most, sizeof *subject->name, err);
    if (!subject->name)
        return HOBE_NO_MEMORY;
    subject->unit = subject->name + most;
    const char *kind = ladder_find(record, "quantity", 2, 0) ? "quantity" : "value";
    const struct ladder_line *line;
    for (int i = 0; (line = ladder_find(record, kind, 2, i)); i++) {
        const struct ladder_line *value = find_value(record, line->word[1]);
        if (!value)
            continue;
        subject->name[subject->quantities] = value->word[1];
        subject->unit[subject->quantities++] = *value->word[2] ? value->word[2] : NULL;
    }
    if (subject->quantities > 0)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "the case reports no value; advice is about those of hobe.report");
}

/* ---- what is said ---------------------------------------------------------------------------- */

static int tell(const struct subject *subject, const struct advice *advice)
{
    struct hobe_text text = {0}, command = {0};
    char word[ADVISE_WORD];
    const struct advise_trial *taken = advice->trial + advice->model;
    advise_model_word(&taken->model, word);
    hobe_text_add(&command, "hobe run %s %s%s--model=%s", subject->script,
                  subject->words.at ? subject->words.at : "", subject->words.at ? " " : "", word);
    if (command.status)
        text.status = command.status;
    else if (subject->format == HOBE_LUA_JSON)
        advise_json(advice, command.at, &text);
    else {
        advise_say(advice, &text);
        hobe_text_add(&text, "\n  %s\n\n", command.at);
        advise_table(advice, &text);
        hobe_text_add(&text, "\n%d models were run, %.3g times the operations of this one\n",
                      advice->trials, advice->cost / taken->cost);
    }
    hobe_text_free(&command);
    return print_text(&text) || !advice->holds;
}

static int search(struct subject *subject)
{
    struct hobe_error err;
    struct advice advice = {0};
    const struct hobe_kernel *level[ADVISE_LEVELS];
    enum hobe_status status = ask(subject, &err);
    const struct advise_problem problem = {
        .quantities = subject->quantities,
        .name = subject->name,
        .unit = subject->unit,
        .accuracy = subject->accuracy,
        .levels = advise_levels(level),
        .level = level,
        .most = MOST_ELEMENTS,
        .dynamic = ladder_find(&subject->first, "moved", 1, 0) != NULL,
        .moves = ladder_find(&subject->first, "stepped", 1, 0) != NULL,
        .takes_linear = 1,
        .run = run_model,
        .context = subject};
    if (!status)
        status = advise(&problem, &advice, &err);
    show_progress("");
    const int result = status ? complain(err.message, 1) : tell(subject, &advice);
    advice_free(&advice);
    return result;
}

/* ---- the command line ------------------------------------------------------------------------ */

static int read_accuracy(const char *text, double *accuracy)
{
    char *end;
    *accuracy = strtod(text, &end);
    if (end != text && *end == '\0' && *accuracy > 0 && *accuracy < 1)
        return 0;
    return complain_usage("--accuracy must be a number between 0 and 1, got \"%.100s\"", text);
}

static int read_form(const char *text, enum hobe_lua_format *format)
{
    const int status = read_format(text, format);
    if (status || *format != HOBE_LUA_CSV)
        return status;
    return complain_usage("advice is printed as table or json, not as %.100s", text);
}

/* Reads argv[*i]; 0, or the exit status after a complaint. */
static int read_argument(struct subject *subject, char **argv, int *i)
{
    const char *value;
    if ((value = option(argv, i, "--accuracy")))
        return read_accuracy(value, &subject->accuracy);
    if ((value = option(argv, i, "--format")))
        return read_form(value, &subject->format);
    if (*argv[*i] == '-')
        return complain_usage("unknown option or missing value: %.100s (see hobe help)", argv[*i]);
    if (strchr(argv[*i], '='))
        hobe_text_add(&subject->words, "%s%s", subject->words.size > 0 ? " " : "", argv[*i]);
    else if (subject->script)
        return complain_usage("one case at a time; what is \"%.100s\"? (see hobe help)", argv[*i]);
    else
        subject->script = argv[*i];
    return 0;
}

int command_advise(int argc, char **argv)
{
    struct subject subject = {.accuracy = ACCURACY};
    int status = 0;
    for (int i = 2; !status && i < argc; i++)
        status = read_argument(&subject, argv, &i);
    if (!status && !subject.script)
        status = complain("which case? hobe advise CASE [--accuracy A] (see hobe help)", 2);
    if (!status)
        status = subject.words.status ? complain("out of memory", 1) : search(&subject);
    ladder_record_free(&subject.first);
    hobe_free(subject.name);
    hobe_text_free(&subject.words);
    return status;
}
