/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hobe chart: the models of a case, each run in a process of its own, so that none finds what
 * another has computed, and one that fails takes none along. */
#define _GNU_SOURCE
#include "bench_baseline.h"
#include "ladder.h"
#include "main.h"
#include "model.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static const double LIMIT = 60; /* s */

struct chart {
    const char *script, *folder;
    enum hobe_lua_format format;
    int quick;
    double limit; /* s of processor time, of a run */
    int axes;
    struct ladder_axis *axis; /* [axes] that the command line gives; their texts lie in argv */
};

/* ---- a run ---------------------------------------------------------------------------------- */

/* Memory in use at most, bytes. */
static double memory(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * (double)usage.ru_maxrss;
}

/* Splits words that are apart by blanks; the caller frees the list with hobe_free. */
static char **list_words(char *text, int *words)
{
    size_t most = 1;
    for (const char *c = text; *c; c++)
        most += *c == ' ';
    char **word = hobe_alloc(most, sizeof *word, NULL), *save;
    *words = 0;
    for (char *w = strtok_r(text, " ", &save); word && w; w = strtok_r(NULL, " ", &save))
        word[(*words)++] = w;
    return word;
}

/* The child: runs the model and ends.  Its record goes to the file `record`, all else to `words`.
 */
static _Noreturn void run_child(const struct chart *chart, const char *model, int ask, int record,
                                int words)
{
    const rlim_t seconds = (rlim_t)ceil(chart->limit);
    const double before = memory();
    char *copy = ladder_copy(model, NULL);
    struct run run = {.script = chart->script,
                      .format = HOBE_LUA_RECORD,
                      .ask = ask,
                      .seconds = RUN_SECONDS,
                      .megabytes = RUN_MEGABYTES,
                      .to = fdopen(record, "w")};
    run.override = copy ? list_words(copy, &run.overrides) : NULL;
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1});
    if (!run.override || !run.to || dup2(words, STDOUT_FILENO) < 0 ||
        dup2(words, STDERR_FILENO) < 0)
        _exit(complain("out of memory", 1));
    const int status = run_script(&run);
    fprintf(run.to, "memory\t%.0f\n", memory() - before);
    fflush(NULL);
    _exit(status);
}

/* All that was written to a file, from its start, as a text. */
static enum hobe_status read_all(int file, struct hobe_text *text, struct hobe_error *err)
{
    char piece[4096];
    ssize_t size;
    lseek(file, 0, SEEK_SET);
    while ((size = read(file, piece, sizeof piece)) > 0)
        hobe_text_bytes(text, piece, (size_t)size);
    return hobe_text_check(text, err);
}

/* The sentence that a failed run ends with: its last line, without the program's name. */
static void keep_sentence(const struct chart *chart, int how, struct hobe_text *words,
                          struct hobe_text *why)
{
    static const char name[] = "hobe: ";
    while (words->size > 0 && words->at[words->size - 1] == '\n')
        words->at[--words->size] = '\0';
    const char *line = words->size > 0 ? strrchr(words->at, '\n') : NULL;
    line = line ? line + 1 : words->at;
    if (WIFSIGNALED(how) && WTERMSIG(how) == SIGXCPU)
        hobe_text_add(why, "it takes more than %g s of processor time (--limit)", chart->limit);
    else if (WIFSIGNALED(how))
        hobe_text_add(why, "it was ended by signal %d, %s", WTERMSIG(how),
                      strsignal(WTERMSIG(how)));
    else if (line && *line)
        hobe_text_add(why, "%s", strncmp(line, name, strlen(name)) ? line : line + strlen(name));
    else
        hobe_text_add(why, "it ended with status %d", WEXITSTATUS(how));
}

/* Runs the child to its end and reads what it wrote. */
static enum hobe_status run_process(const struct chart *chart, const char *model, int ask,
                                    const int *file, struct ladder_record *record,
                                    struct hobe_text *why, struct hobe_error *err)
{
    struct hobe_text words = {0}, said = {0};
    int how = 0;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0)
        run_child(chart, model, ask, file[0], file[1]);
    if (child < 0)
        return hobe_fail(err, HOBE_IO, NULL, "no process for a run: %s", strerror(errno));
    while (waitpid(child, &how, 0) < 0 && errno == EINTR)
        continue;
    enum hobe_status status = read_all(file[0], &said, err);
    status = status ? status : read_all(file[1], &words, err);
    status = status ? status : ladder_record_read(said.at ? said.at : "", said.size, record, err);
    if (!status && !record->whole)
        keep_sentence(chart, how, &words, why);
    hobe_text_free(&words);
    hobe_text_free(&said);
    return status;
}

/* A run for the ladder (ladder_run). */
static enum hobe_status run_model(void *context, const char *model, int ask,
                                  struct ladder_record *record, struct hobe_text *why,
                                  double *seconds, struct hobe_error *err)
{
    const double start = hobe_seconds();
    const int file[2] = {memfd_create("record", MFD_CLOEXEC), memfd_create("words", MFD_CLOEXEC)};
    enum hobe_status status;
    if (file[0] < 0 || file[1] < 0)
        status = hobe_fail(err, HOBE_IO, NULL, "no file for a run: %s", strerror(errno));
    else
        status = run_process(context, model, ask, file, record, why, err);
    for (int i = 0; i < 2; i++)
        if (file[i] >= 0)
            close(file[i]);
    *seconds = hobe_seconds() - start;
    return status;
}

enum hobe_status run_apart(const char *script, const char *words, struct ladder_record *record,
                           struct hobe_text *why, struct hobe_error *err)
{
    struct chart chart = {.script = script, .limit = LIMIT};
    double seconds;
    return run_model(&chart, words, 0, record, why, &seconds, err);
}

/* ---- what is said --------------------------------------------------------------------------- */

/* A line on the terminal that the next one overwrites. */
static void show_progress(const char *what, const char *model)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%s %s", what, model);
}

/* The processor's name, or that of its architecture's kernels. */
static void name_processor(char *name, size_t size)
{
    char line[300];
    FILE *file = fopen("/proc/cpuinfo", "r");
    snprintf(name, size, "a processor without a name");
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) || !colon)
            continue;
        line[strcspn(line, "\n")] = '\0';
        snprintf(name, size, "%s", colon + 1 + strspn(colon + 1, " "));
        break;
    }
    if (file)
        fclose(file);
}

/* Files first, so that a folder that cannot be written leaves no result on standard output. */
static int tell(const struct chart *chart, const struct ladder *ladder)
{
    struct hobe_error err;
    struct hobe_text text = {0};
    char processor[100], machine[200];
    int drawn = 1;
    name_processor(processor, sizeof processor);
    snprintf(machine, sizeof machine, "%s kernels, one core of %s", bench_machine()->name,
             processor);
    const struct ladder_case of = {chart->script, machine};
    if (chart->folder && ladder_write(ladder, &of, chart->folder, &drawn, &err))
        return complain(err.message, 1);
    if (!drawn)
        complain("gnuplot is not installed: the picture is not drawn", 0);
    ladder_text(ladder, &of, (enum ladder_format)chart->format, &text);
    return print_text(&text);
}

static int climb(const struct chart *chart)
{
    struct hobe_error err;
    struct ladder ladder;
    struct chart context = *chart;
    const struct ladder_options options = {.given = chart->axes,
                                           .axis = chart->axis,
                                           .quick = chart->quick,
                                           .run = run_model,
                                           .context = &context,
                                           .progress = show_progress};
    const enum hobe_status status = ladder_climb(&options, &ladder, &err);
    const int result = status ? complain(err.message, 1) : tell(chart, &ladder);
    ladder_free(&ladder);
    return result;
}

/* ---- the command line ----------------------------------------------------------------------- */

static int read_limit(const char *text, double *limit)
{
    char *end;
    *limit = strtod(text, &end);
    if (end != text && *end == '\0' && *limit >= 1 && *limit <= 86400)
        return 0;
    return complain_usage("--limit must be a number of seconds from 1 to 86400, got \"%.100s\"",
                          text);
}

/* "name=a,b": an axis, whose texts stay in argv. */
static int read_axis(struct chart *chart, char *word)
{
    char *next = strchr(word, '=');
    size_t most = 1;
    for (const char *c = next; *c; c++)
        most += *c == ',';
    *next++ = '\0';
    for (int a = 0; a < chart->axes; a++)
        if (!strcmp(chart->axis[a].name, word))
            return complain_usage("a parameter is given twice: %.100s", word);
    struct ladder_axis *axis = &chart->axis[chart->axes++];
    *axis = (struct ladder_axis){word, 0, hobe_alloc(most, sizeof *axis->value, NULL)};
    if (!axis->value)
        return complain("out of memory", 1);
    while (next) {
        char *comma = strchr(next, ',');
        if (comma)
            *comma++ = '\0';
        if (!*next || strpbrk(next, " \t\n"))
            return complain_usage("values of a parameter are words with commas between them, "
                                  "%.100s=2,4,8",
                                  word);
        axis->value[axis->values++] = next;
        next = comma;
    }
    return 0;
}

/* Reads argv[*i]; 0, or the exit status after a complaint. */
static int read_argument(struct chart *chart, char **argv, int *i)
{
    const char *value;
    if ((value = option(argv, i, "--out")))
        chart->folder = value;
    else if ((value = option(argv, i, "--format")))
        return read_format(value, &chart->format);
    else if ((value = option(argv, i, "--limit")))
        return read_limit(value, &chart->limit);
    else if (!strcmp(argv[*i], "--quick"))
        chart->quick = 1;
    else if (!strncmp(argv[*i], "--model=", 8))
        return read_axis(chart, argv[*i]);
    else if (*argv[*i] == '-')
        return complain_usage("unknown option or missing value: %.100s (see hobe help)", argv[*i]);
    else if (strchr(argv[*i], '='))
        return read_axis(chart, argv[*i]);
    else if (chart->script)
        return complain_usage("one case at a time; what is \"%.100s\"? (see hobe help)", argv[*i]);
    else
        chart->script = argv[*i];
    return 0;
}

static int start(struct chart *chart, int argc, char **argv)
{
    struct hobe_error err;
    for (int i = 2; i < argc; i++) {
        const int status = read_argument(chart, argv, &i);
        if (status)
            return status;
    }
    if (!chart->script)
        return complain("which case? hobe chart CASE [name=value,value...] (see hobe help)", 2);
    if (chart->folder && hobe_make_folder(chart->folder, &err))
        return complain(err.message, 1);
    return climb(chart);
}

int command_chart(int argc, char **argv)
{
    /* Libraries counted the processors when they were loaded: once more, with one. */
    if (bench_pin() == BENCH_NOW_PINNED)
        execv("/proc/self/exe", argv);
    struct chart chart = {.limit = LIMIT};
    chart.axis = hobe_alloc((size_t)argc, sizeof *chart.axis, NULL);
    if (!chart.axis)
        return complain("out of memory", 1);
    const int status = start(&chart, argc, argv);
    for (int a = 0; a < chart.axes; a++)
        hobe_free(chart.axis[a].value);
    hobe_free(chart.axis);
    return status;
}
