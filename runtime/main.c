/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hobe program: runs case scripts and says what is built in.
 *
 * Standard output holds results and nothing else; whatever a script prints goes to standard error.
 * An error is one line on standard error and the exit status 1; 2 for a wrong command line. */
#define _GNU_SOURCE
#include "main.h"

#include "element.h"
#include "points.h"
#include "smaller.h"

#include <lualib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char usage[] =
    "hobe " HOBE_VERSION ": a nonlinear beam solver with warping\n"
    "\n"
    "  hobe run CASE [name=value ...]   run a case script, with parameters changed\n"
    "      --out DIR                    write report, tables and pictures to a folder\n"
    "      --format table|json|csv      how the report is printed (table)\n"
    "      --resume                     go on with motions that a run of the same case into the\n"
    "                                   same folder had begun when it was stopped\n"
    "      --log                        print each Newton iteration and warning on standard error\n"
    "      --time-limit S               processor time that the script may spend in Lua (10)\n"
    "      --memory-limit MB            memory that the script may use in Lua (512)\n"
    "      --trust                      no sandbox, no limits: for scripts of your own\n"
    "      --model=ELEMENT:ELEMENTS     the same element and mesh for all scenes (and :linear,\n"
    "                                   :paper for the paper's points, :step=FACTOR in time)\n"
    "  hobe advise CASE [name=value ...] the cheapest model that holds an accuracy\n"
    "      --accuracy A                 largest relative error of a value of the report (1e-3)\n"
    "      --format table|json          how the advice is printed (table)\n"
    "  hobe chart CASE [name=value,...] run a ladder of models of a case: error against time\n"
    "      element=A,B elements=1,2     of a case that names no ladder (all; 1,2,4,8,16,32)\n"
    "      --model=A:1,B:2,...          these models, of any case\n"
    "      --quick                      fewer meshes, three rounds\n"
    "      --limit S                    processor time of a run (60)\n"
    "      --out DIR                    write chart.csv, chart.json and the picture to a folder\n"
    "      --format table|json|csv      how results are printed (table)\n"
    "  hobe elements                    list the elements built in\n"
    "      --explain NAME               one of them in detail\n"
    "  hobe bench                       time elements and scenes beside the machine's peak\n"
    "      --element NAME[,NAME...]     these, also in long beams (all; MGD30w in long beams)\n"
    "      --quick                      a look: 3333, MGD30w and 34X3, a tenth of the time\n"
    "      --seconds S                  for each race (0.5)\n"
    "      --large                      long beams to 100,000 elements (10,000)\n"
    "      --out DIR                    write bench.csv and pictures to a folder\n"
    "      --format table|json|csv      how results are printed (table)\n"
    "  hobe docs                        the reference of the Lua module, as Markdown\n"
    "  hobe version | help\n";

/* ---- errors --------------------------------------------------------------------------------- */

int complain(const char *message, int status)
{
    fputs("hobe: ", stderr);
    for (const char *c = message; *c; c++)
        fputc((unsigned char)*c < ' ' || *c == 127 ? ' ' : *c, stderr);
    fputc('\n', stderr);
    return status;
}

int complain_usage(const char *format, const char *word)
{
    char message[300];
    snprintf(message, sizeof message, format, word);
    return complain(message, 2);
}

/* Lua shortens long file names in its messages: puts the case's whole name back. */
static void complain_from(const char *script, const char *message)
{
    const size_t kept = LUA_IDSIZE - 1 - 3;
    size_t size = strlen(script);
    char whole[5000];
    if (size > kept && !strncmp(message, "...", 3) &&
        !strncmp(message + 3, script + size - kept, kept)) {
        snprintf(whole, sizeof whole, "%s%s", script, message + 3 + kept);
        message = whole;
    }
    complain(message, 1);
}

/* The script raised an error that is no text. */
static void complain_error_value(const char *script, const char *type)
{
    char message[5000];
    snprintf(message, sizeof message, "%s: the script raised an error that is a %s, not a text",
             script, type);
    complain(message, 1);
}

/* ---- hobe run ------------------------------------------------------------------------------- */

static void set_context(lua_State *L, const struct run *run)
{
    struct hobe_lua *context = hobe_lua_context(L);
    context->program = 1;
    context->folder = run->folder;
    context->script = run->script;
    context->trusted = run->trust;
    context->resume = run->resume;
    context->ask = run->ask;
    context->log = run->log;
    context->progress = isatty(STDERR_FILENO);
    context->model = run->model;
    context->overridden = run->model != NULL;
    hobe_lua_push_store(L, HOBE_LUA_OVERRIDES);
    for (int i = 0; i < run->overrides; i++) {
        const char *equals = strchr(run->override[i], '=');
        lua_pushlstring(L, run->override[i], (size_t)(equals - run->override[i]));
        lua_pushstring(L, equals + 1);
        lua_rawset(L, -3);
    }
    lua_pop(L, 1);
}

/* Takes back what is given for models, which need not be a parameter of the case. */
static void forget_models(lua_State *L)
{
    hobe_lua_push_store(L, HOBE_LUA_OVERRIDES);
    for (int i = 0; ladder_model_axis[i]; i++) {
        lua_pushnil(L);
        lua_setfield(L, -2, ladder_model_axis[i]);
    }
    lua_pop(L, 1);
}

/* Runs in protected mode: argument 1 is the run; returns a sentence when the results, which are
 * out, are not as expected. */
static int run_protected(lua_State *L)
{
    const struct run *run = lua_touserdata(L, 1);
    set_context(L, run);
    if (run->trust)
        luaL_openlibs(L);
    else
        hobe_lua_open_sandbox(L);
    luaL_requiref(L, "hobe", luaopen_hobe, 0);
    lua_settop(L, 0);
    if (run->seconds > 0)
        hobe_lua_start_clock(L, run->seconds);
    if (luaL_loadfilex(L, run->script, "t")) {
        if (!strncmp(lua_tostring(L, -1), "attempt to load", 15)) /* Lua names no file here */
            lua_pushfstring(L, "%s: this is compiled Lua; a case must be source", run->script);
        return lua_error(L);
    }
    const int whole = lua_pcall(L, 0, 0, 0) == LUA_OK;
    if (!whole && lua_touserdata(L, -1) != hobe_lua_context(L))
        return lua_error(L);
    hobe_lua_check_memory();
    hobe_lua_pause_clock(); /* for good: the rest is not the script's */
    if (run->ask)
        forget_models(L);
    if (whole) /* else not all parameters may have been reached */
        hobe_lua_check_overrides(L);
    return hobe_lua_finish(L, run->format, run->to);
}

/* Takes the last word "--model=..." out of the overrides, as its model. */
static enum hobe_status read_model(struct run *run, struct advise_model *model,
                                   struct hobe_error *err)
{
    static const char option[] = "--model=";
    enum hobe_status status = HOBE_OK;
    int kept = 0;
    for (int i = 0; i < run->overrides; i++)
        if (strncmp(run->override[i], option, strlen(option)))
            run->override[kept++] = run->override[i];
        else if (!(status = advise_read_model(run->override[i] + strlen(option), model, err)))
            run->model = model;
    run->overrides = kept;
    return status;
}

int run_script(struct run *run)
{
    struct hobe_error err;
    struct advise_model model;
    if (read_model(run, &model, &err))
        return complain(err.message, 1);
    lua_State *L = hobe_lua_new_state(run->script, (size_t)(run->megabytes * 1048576));
    if (!L)
        return complain("out of memory", 1);
    lua_pushcfunction(L, run_protected);
    lua_pushlightuserdata(L, run);
    int status = lua_pcall(L, 1, 1, 0);
    hobe_lua_check_memory();
    hobe_lua_pause_clock();
    hobe_lua_count_warnings(hobe_lua_context(L));
    if (status != LUA_OK &&
        !hobe_lua_context(L)->resume) /* it would fail again; another's may not */
        hobe_lua_drop_journals(L);
    const char *message = lua_tostring(L, -1);
    if (message)
        complain_from(run->script, message);
    else if (status != LUA_OK)
        complain_error_value(run->script, luaL_typename(L, -1));
    lua_close(L);
    return status != LUA_OK || message;
}

/* Leads file descriptor 1 to standard error and keeps the way to the old one. */
static FILE *divert_output(void)
{
    fflush(stdout);
    int old = dup(STDOUT_FILENO);
    FILE *to = old < 0 ? NULL : fdopen(old, "w");
    if (to && dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        return NULL;
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    return to;
}

static int start(struct run *run)
{
    struct hobe_error err;
    if (run->seconds < 0)
        run->seconds = run->trust ? 0 : RUN_SECONDS;
    if (run->megabytes < 0)
        run->megabytes = run->trust ? 0 : RUN_MEGABYTES;
    if (run->folder && hobe_make_folder(run->folder, &err))
        return complain(err.message, 1);
    if (run->folder && access(run->folder, W_OK | X_OK))
        return complain("the output folder is not writable", 1);
    run->to = divert_output();
    if (!run->to)
        return complain("standard output is closed", 1);
    int status = run_script(run);
    fclose(run->to);
    return status;
}

/* ---- the command line ----------------------------------------------------------------------- */

char *option(char **argv, int *i, const char *name)
{
    size_t size = strlen(name);
    if (strncmp(argv[*i], name, size))
        return NULL;
    if (argv[*i][size] == '=')
        return argv[*i] + size + 1;
    if (argv[*i][size] != '\0' || !argv[*i + 1])
        return NULL;
    return argv[++*i];
}

static int read_limit(const char *text, const char *name, double *value)
{
    char *end;
    *value = strtod(text, &end);
    if (end != text && *end == '\0' && isfinite(*value) && *value >= 0 && *value <= 1e9)
        return 0;
    return complain_usage("%s must be a number >= 0 (0: no limit)", name);
}

int read_format(const char *text, enum hobe_lua_format *format)
{
    static const char *const formats[] = {"table", "json", "csv"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(text, formats[i]))
            continue;
        *format = (enum hobe_lua_format)i;
        return 0;
    }
    return complain_usage("--format must be table, json or csv, got \"%.100s\"", text);
}

/* Keeps name=value at the front of the list of overrides. */
static int read_override(struct run *run, char *word)
{
    size_t size = strcspn(word, "=") + 1;
    for (int i = 0; i < run->overrides; i++)
        if (!strncmp(run->override[i], word, size))
            return complain_usage("a parameter is given twice: %.100s", word);
    run->override[run->overrides++] = word;
    return 0;
}

/* Reads argv[*i]; 0, or the exit status after a complaint. */
static int read_argument(struct run *run, char **argv, int *i)
{
    const char *value;
    if ((value = option(argv, i, "--out")))
        run->folder = value;
    else if ((value = option(argv, i, "--format")))
        return read_format(value, &run->format);
    else if ((value = option(argv, i, "--time-limit")))
        return read_limit(value, "--time-limit", &run->seconds);
    else if ((value = option(argv, i, "--memory-limit")))
        return read_limit(value, "--memory-limit", &run->megabytes);
    else if (!strcmp(argv[*i], "--log"))
        run->log = 1;
    else if (!strcmp(argv[*i], "--trust"))
        run->trust = 1;
    else if (!strcmp(argv[*i], "--resume"))
        run->resume = 1;
    else if (!strncmp(argv[*i], "--model=", 8))
        return read_override(run, argv[*i]);
    else if (*argv[*i] == '-')
        return complain_usage("unknown option or missing value: %.100s (see hobe help)", argv[*i]);
    else if (strchr(argv[*i], '='))
        return read_override(run, argv[*i]);
    else if (run->script)
        return complain_usage("one case at a time; what is \"%.100s\"? (see hobe help)", argv[*i]);
    else
        run->script = argv[*i];
    return 0;
}

/* argv[2..] are the arguments; the overrides are gathered at the front of argv. */
static int command_run(int argc, char **argv)
{
    struct run run = {.seconds = -1, .megabytes = -1, .override = argv};
    for (int i = 2; i < argc; i++) {
        int status = read_argument(&run, argv, &i);
        if (status)
            return status;
    }
    if (!run.script)
        return complain("which case? hobe run CASE [name=value ...] (see hobe help)", 2);
    if (run.resume && !run.folder)
        return complain("--resume needs the folder of the run that was stopped: --out DIR", 2);
    return start(&run);
}

/* ---- hobe elements -------------------------------------------------------------------------- */

int print_text(struct hobe_text *text)
{
    int failed = text->status || fputs(text->at, stdout) < 0 || fflush(stdout);
    hobe_text_free(text);
    return failed ? complain("the output could not be written", 1) : 0;
}

static void join_modes(struct hobe_text *text, const struct hobe_kernel *kernel)
{
    for (int k = 0; k < kernel->modes; k++)
        hobe_text_add(text, k > 0 ? " %s" : "%s", kernel->mode[k]);
}

/* One plan's flops, and for which task it is taken. */
static void explain_cost(struct hobe_text *text, const char *plan,
                         const struct hobe_plan_cost *cost, const int taken[2])
{
    hobe_text_add(text, "%s %ld%s, %ld%s", plan, cost->flops_force, taken[0] ? " (taken)" : "",
                  cost->flops_tangent, taken[1] ? " (taken)" : "");
}

/* What each plan costs on a straight beam and on one that is curved or tapered, by the symmetry
 * that the section keeps; the tensor is for straight ones. */
static void explain_symmetry(struct hobe_text *text, const struct hobe_kernel *k, int s)
{
    static const char *const section[] = {"any section", "symmetric in y", "symmetric in z",
                                          "symmetric in y and z"};
    const int straight = s & HOBE_SYMMETRIC_X;
    int tensor[2], stations[2];
    for (int t = 0; t < 2; t++)
        stations[t] = !(tensor[t] = hobe_tensor_pays(k, s, t));
    hobe_text_add(text, "  %s, %s: ", straight ? "straight" : "varying", section[s / 2]);
    explain_cost(text, "section", k->section_cost + s, stations);
    if (straight) {
        explain_cost(text, "; tensor", k->tensor_cost + s, tensor);
        hobe_text_add(text, " at %.3g, %.3g times the speed", hobe_tensor_speed(k, s, 0),
                      hobe_tensor_speed(k, s, 1));
    }
    hobe_text_add(text, "\n");
}

static void explain_plans(struct hobe_text *text, const struct hobe_kernel *k)
{
    if (!k->section) {
        hobe_text_add(text, "flops of force, and of force and tangent: %ld, %ld\n", k->flops_force,
                      k->flops_tangent);
        return;
    }
    const int points = points_of_rectangle(k);
    hobe_text_add(text,
                  "flops of force, and of force and tangent, by each plan; taken is what has least "
                  "for its speed, a tensor where one of the two gains %g times:\n",
                  HOBE_TENSOR_WORTH);
    hobe_text_add(text,
                  "  by %d points, which polynomials on a rectangle need, to compare: %.0f, %.0f\n",
                  points, points_flops(k->vectors, points, 0), points_flops(k->vectors, points, 1));
    for (int s = HOBE_SYMMETRIES - 1; s >= 0; s--)
        explain_symmetry(text, k, s);
}

/* What it runs on where the section drops modes. */
static void explain_within(struct hobe_text *text, const struct hobe_kernel *k)
{
    const char *before = "on a section that drops its other modes it is, and costs no more than, ";
    for (int i = 0; hobe_kernels()[i]; i++)
        if (kernel_within(hobe_kernels()[i], k)) {
            hobe_text_add(text, "%s%s", before, hobe_kernels()[i]->name);
            before = " or ";
        }
    if (*before == ' ')
        hobe_text_add(text, "\n");
}

static int explain_element(const char *name)
{
    struct hobe_error err;
    struct hobe_text text = {0};
    const struct hobe_kernel *k = hobe_find_kernel(name, &err);
    if (!k)
        return complain(err.message, 1);
    hobe_text_add(&text, "%s (%s)\nmodes of the section: ", k->name, k->source);
    join_modes(&text, k);
    hobe_text_add(&text, "\ndefault mechanics: %s\npoints on the axis: %d\n", k->mechanics,
                  k->stations);
    explain_plans(&text, k);
    explain_within(&text, k);
    hobe_text_add(&text, "declaration: %s\n", k->hash);
    hobe_text_add(&text, "nodal vectors, three degrees of freedom each, in order:\n");
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *vector = &k->vector[v];
        hobe_text_add(&text, "  node %d (x/l = %.4g): ", vector->node + 1, k->node[vector->node]);
        hobe_text_add(&text, "%s of the coefficient of %s\n", vector->slope ? "slope" : "value",
                      k->mode[vector->mode]);
    }
    return print_text(&text);
}

enum { NAME, NODES, DOFS, STATIONS, FLOPS, MECHANICS, MODES, COLUMNS };

static int list_elements(void)
{
    static const char *const head[COLUMNS] = {
        "name", "nodes", "dofs", "stations", "flops", "mechanics", "modes of the section"};
    struct hobe_text text = {0};
    size_t rows = 0;
    while (hobe_kernels()[rows])
        rows++;
    struct hobe_cell *cell = hobe_alloc(rows * COLUMNS, sizeof *cell, NULL);
    struct hobe_text *modes = hobe_alloc(rows, sizeof *modes, NULL);
    for (size_t i = 0; cell && modes && i < rows; i++) {
        const struct hobe_kernel *k = hobe_kernels()[i];
        struct hobe_cell *row = cell + i * COLUMNS;
        join_modes(&modes[i], k);
        row[NAME].text = k->name;
        row[NODES].number = k->nodes;
        row[DOFS].number = 3 * k->vectors;
        row[STATIONS].number = k->stations;
        row[FLOPS].number = (double)k->flops_tangent;
        row[MECHANICS].text = k->mechanics;
        row[MODES].text = modes[i].at;
    }
    if (cell && modes)
        hobe_table_text(&text, &(struct hobe_table){NULL, COLUMNS, rows, head, cell});
    else
        text.status = HOBE_NO_MEMORY;
    for (size_t i = 0; modes && i < rows; i++)
        hobe_text_free(&modes[i]);
    hobe_free(modes);
    hobe_free(cell);
    return print_text(&text);
}

static int command_elements(int argc, char **argv)
{
    if (argc == 2)
        return list_elements();
    int i = 2;
    const char *name = option(argv, &i, "--explain");
    if (!name || i + 1 < argc)
        return complain("hobe elements [--explain NAME]", 2);
    return explain_element(name);
}

/* ---- main ----------------------------------------------------------------------------------- */

/* For tests of sanitized builds: HOBE_FAIL_ALLOCATION=n makes the n-th allocation fail. */
static void arm_failure(void)
{
#ifdef HOBE_FAULTS
    const char *n = getenv("HOBE_FAIL_ALLOCATION");
    if (n)
        hobe_fail_allocation(strtol(n, NULL, 10));
#endif
}

int main(int argc, char **argv)
{
    const char *command = argc > 1 ? argv[1] : "";
    arm_failure();
    if (!strcmp(command, "run"))
        return command_run(argc, argv);
    if (!strcmp(command, "elements"))
        return command_elements(argc, argv);
    if (!strcmp(command, "advise"))
        return command_advise(argc, argv);
    if (!strcmp(command, "chart"))
        return command_chart(argc, argv);
    if (!strcmp(command, "bench"))
        return command_bench(argc, argv);
    if (!strcmp(command, "docs"))
        hobe_lua_print_docs(stdout);
    else if (!strcmp(command, "version") || !strcmp(command, "--version"))
        puts("hobe " HOBE_VERSION);
    else if (!strcmp(command, "help") || !strcmp(command, "--help") || !strcmp(command, "-h"))
        fputs(usage, stdout);
    else
        return complain_usage("unknown command \"%.100s\" (see hobe help)", command);
    return fflush(stdout) ? complain("the output could not be written", 1) : 0;
}
