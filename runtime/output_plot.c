/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures: numbers as CSV, a gnuplot script beside them, and gnuplot run on it. */
#define _GNU_SOURCE
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- data and script ------------------------------------------------------------------------ */

void hobe_plot_data(struct hobe_text *text, const struct hobe_plot *plot)
{
    size_t rows = 0;
    for (size_t k = 0; k < plot->count; k++) {
        const struct hobe_series *series = &plot->series[k];
        hobe_text_bytes(text, k > 0 ? ",x," : "x,", k > 0 ? 3 : 2);
        hobe_text_csv(text, series->label ? series->label : "y");
        if (series->count > rows)
            rows = series->count;
    }
    hobe_text_bytes(text, "\n", 1);
    for (size_t i = 0; i < rows; i++) {
        for (size_t k = 0; k < plot->count; k++) {
            const struct hobe_series *series = &plot->series[k];
            hobe_text_bytes(text, ",", k > 0);
            if (i < series->count)
                hobe_text_number(text, series->x[i]);
            hobe_text_bytes(text, ",", 1);
            if (i < series->count)
                hobe_text_number(text, series->y[i]);
        }
        hobe_text_bytes(text, "\n", 1);
    }
}

/* A string of gnuplot in single quotes, within which only the quote itself means anything.  A
 * control character would end the line and start a command: it becomes a blank. */
static void quote(struct hobe_text *text, const char *string)
{
    hobe_text_bytes(text, "'", 1);
    for (const char *c = string; *c; c++) {
        int control = (unsigned char)*c < ' ' || *c == 127;
        hobe_text_bytes(text, control ? " " : c, 1);
        if (*c == '\'')
            hobe_text_bytes(text, c, 1);
    }
    hobe_text_bytes(text, "'", 1);
}

/* Where the i-th point of a series stands on the axes x, y. */
static void place(const struct hobe_plot *plot, const struct hobe_series *series, size_t i,
                  double at[2])
{
    at[0] = plot->log_x ? log10(series->x[i]) : series->x[i];
    at[1] = plot->log_y ? log10(series->y[i]) : series->y[i];
}

/* The extent of all points: box[0..1] in x, box[2..3] in y. */
static void extent(const struct hobe_plot *plot, double *box)
{
    int first = 1;
    for (size_t k = 0; k < plot->count; k++) {
        for (size_t i = 0; i < plot->series[k].count; i++, first = 0) {
            double at[2];
            place(plot, &plot->series[k], i, at);
            for (int axis = 0; axis < 2; axis++) {
                double *from = box + 2 * axis, *to = from + 1;
                *from = first || at[axis] < *from ? at[axis] : *from;
                *to = first || at[axis] > *to ? at[axis] : *to;
            }
        }
    }
}

/* The legend's place: a corner without points, or outside where there is none or it is long. */
static const char *legend(const struct hobe_plot *plot)
{
    static const char *const corner[] = {"right top", "left top", "right bottom", "left bottom"};
    size_t points[4] = {0}, best = 0, labels = 0;
    double box[4] = {0};
    for (size_t k = 0; k < plot->count; k++)
        labels += plot->series[k].label && *plot->series[k].label;
    if (labels > 5)
        return "outside right top";
    extent(plot, box);
    for (size_t k = 0; k < plot->count; k++) {
        for (size_t i = 0; i < plot->series[k].count; i++) {
            double at[2];
            place(plot, &plot->series[k], i, at);
            double x = at[0] - box[0], y = at[1] - box[2];
            int left = x<0.4 * (box[1] - box[0]), right = x> 0.6 * (box[1] - box[0]);
            int bottom = y<0.4 * (box[3] - box[2]), top = y> 0.6 * (box[3] - box[2]);
            if ((left || right) && (bottom || top))
                points[2 * bottom + left]++;
        }
    }
    for (size_t c = 1; c < 4; c++)
        best = points[c] < points[best] ? c : best;
    return points[best] > 0 ? "outside right top" : corner[best];
}

static void add_label(struct hobe_text *text, const char *what, const char *label)
{
    if (!label || !*label)
        return;
    hobe_text_add(text, "set %s ", what);
    quote(text, label);
    hobe_text_add(text, " noenhanced\n");
}

/* A logarithmic axis; one of few decades has too few powers of ten to read a number by. */
static void add_logarithm(struct hobe_text *text, char axis, const double extent_of[2])
{
    const int first = (int)floor(extent_of[0]), last = (int)ceil(extent_of[1]);
    hobe_text_add(text, "set logscale %c\n", axis);
    if (last - first > 2) { /* by themselves all would have the decimals of the smallest */
        hobe_text_add(text, "set format %c '%%g'\n", axis);
        return;
    }
    hobe_text_add(text, "set %ctics (", axis);
    for (int k = first; k <= last; k++)
        hobe_text_add(text, "%s1e%d, 2e%d, 5e%d", k > first ? ", " : "", k, k, k);
    hobe_text_add(text, ")\n");
}

/* Colours that stay apart for most eyes (Okabe & Ito; Tol), after black. */
static const char *colour(int index)
{
    static const char *const palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                                          "#56b4e9", "#882255", "#999933", "#117733", "#aa4499",
                                          "#7f7f7f", "#44aa99", "#8c564b", "#332288", "#b8a300"};
    const int size = sizeof palette / sizeof *palette;
    return index == 0 ? "#000000" : palette[(index - 1) % size];
}

static void add_series(struct hobe_text *text, const struct hobe_plot *plot, size_t k,
                       const char *data)
{
    static const char *const style[] = {"lines lw 2", "points ps 1.3 lw 1.5",
                                        "linespoints lw 2 ps 1.2", "points ps 1.3 lw 2.5"};
    static const int point[] = {6, 4, 8, 12, 10, 7, 5, 9}; /* open and filled, distinct */
    const struct hobe_series *series = &plot->series[k];
    int index = series->colour < 0 ? (int)k + 1 : series->colour;
    hobe_text_add(text, "%s", k == 0 ? "plot " : ", \\\n     ");
    quote(text, data);
    hobe_text_add(text, " skip 1 using %zu:%zu with %s ", 2 * k + 1, 2 * k + 2,
                  style[series->style]);
    if (series->style != HOBE_STYLE_LINE)
        hobe_text_add(text, "pt %d ", series->style == HOBE_STYLE_CROSSES ? 2 : point[index % 8]);
    hobe_text_add(text, "lc rgb '%s' ", colour(index));
    if (!series->label || !*series->label) {
        hobe_text_add(text, "notitle");
        return;
    }
    hobe_text_add(text, "title ");
    quote(text, series->label);
    hobe_text_add(text, " noenhanced");
}

void hobe_plot_script(struct hobe_text *text, const struct hobe_plot *plot, const char *data,
                      const char *image)
{
    double box[4] = {0};
    hobe_text_add(text, "# Draws the picture again: gnuplot -d THIS_FILE\n"
                        "set encoding utf8\n"
                        "if (strstrt(GPVAL_TERMINALS, ' pngcairo ')) {\n"
                        "    set terminal pngcairo noenhanced size 1000,700 font 'Sans,13'\n"
                        "} else {\n"
                        "    set terminal png noenhanced size 1000,700\n"
                        "}\n"
                        "if (!exists('image')) image = ");
    quote(text, image);
    hobe_text_add(text, "\nset output image\n"
                        "set datafile separator ','\n"
                        "set border 3 lw 1.2\n"
                        "set tics nomirror out\n"
                        "set grid lc rgb '#d8d8d8' lt 1 lw 1\n"
                        "set autoscale noextend\n"
                        "set offsets graph 0.02, graph 0.02, graph 0.04, graph 0.04\n");
    extent(plot, box);
    if (plot->log_x)
        add_logarithm(text, 'x', box);
    if (plot->log_y)
        add_logarithm(text, 'y', box + 2);
    hobe_text_add(text, "set key %s spacing 1.2 width 1\n", legend(plot));
    add_label(text, "title", plot->title);
    add_label(text, "xlabel", plot->xlabel);
    add_label(text, "ylabel", plot->ylabel);
    for (size_t k = 0; k < plot->count; k++)
        add_series(text, plot, k, data);
    hobe_text_bytes(text, "\n", 1);
}

/* ---- drawing -------------------------------------------------------------------------------- */

/* Starts gnuplot on `script` in the folder dir, drawing into the file `image`; what it says goes
 * to `words`.  No shell, no start-up files, nothing on standard input.  0 or an errno. */
static int start(int dir, int words, const char *script, const char *image, pid_t *child)
{
    char set[128], path[300];
    snprintf(set, sizeof set, "image = '%s'", image);
    snprintf(path, sizeof path, "./%s", script); /* a name must not look like an option */
    char *const argv[] = {"gnuplot", "-d", "-e", set, path, NULL};
    posix_spawn_file_actions_t actions;
    int cause = posix_spawn_file_actions_init(&actions);
    if (cause)
        return cause;
    posix_spawn_file_actions_addfchdir_np(&actions, dir);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, words, 2);
    cause = posix_spawnp(child, argv[0], &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return cause;
}

/* Reads all that comes from a pipe and keeps the first line that is not blank or a marker. */
static void listen_to(int pipe_end, char *line, size_t size)
{
    char all[2000], more[500];
    size_t used = 0;
    ssize_t n;
    while ((n = read(pipe_end, more, sizeof more)) != 0) {
        if (n < 0 && errno != EINTR)
            break;
        for (ssize_t i = 0; i < n && used + 1 < sizeof all; i++)
            all[used++] = more[i];
    }
    all[used] = '\0';
    const char *from = all + strspn(all, " \t\r\n^");
    snprintf(line, size, "%.*s", (int)strcspn(from, "\r\n"), from);
}

/* Runs gnuplot to its end.  0: drawn; an errno; or -1 with gnuplot's words in line. */
static int run(int dir, const char *script, const char *image, char *line, size_t size)
{
    int pipe_end[2], how = 0;
    pid_t child;
    if (pipe2(pipe_end, O_CLOEXEC))
        return errno;
    int cause = start(dir, pipe_end[1], script, image, &child);
    close(pipe_end[1]);
    if (!cause) {
        listen_to(pipe_end[0], line, size);
        while (waitpid(child, &how, 0) < 0 && errno == EINTR)
            continue;
        cause = WIFEXITED(how) && WEXITSTATUS(how) == 0 ? 0 : -1;
    }
    close(pipe_end[0]);
    return cause;
}

enum hobe_status hobe_plot_draw(const char *folder, const char *script, const char *image,
                                int *drawn, struct hobe_error *err)
{
    const char *base, *script_base = strrchr(script, '/');
    char temporary[64], line[300] = "";
    script_base = script_base ? script_base + 1 : script;
    *drawn = 0;
    int dir = hobe_open_parent(folder, image, 0, &base, err);
    if (dir < 0)
        return err ? err->status : HOBE_IO;
    snprintf(temporary, sizeof temporary, ".hobe-%ld-image.tmp", (long)getpid());
    int cause = run(dir, script_base, temporary, line, sizeof line);
    if (cause == 0 && renameat(dir, temporary, dir, base)) {
        cause = -1;
        snprintf(line, sizeof line, "%s", strerror(errno));
    }
    *drawn = cause == 0;
    if (cause != 0)
        unlinkat(dir, temporary, 0);
    close(dir);
    if (cause == 0 || cause == ENOENT)
        return HOBE_OK;
    return hobe_fail(err, HOBE_IO, NULL, "%s/%s could not be drawn: %s", folder, image,
                     cause > 0 ? strerror(cause)
                     : *line   ? line
                               : "gnuplot failed");
}

enum hobe_status hobe_plot_write(const char *folder, const char *name, const struct hobe_plot *plot,
                                 int *drawn, struct hobe_error *err)
{
    char data[80], script[80], image[80];
    struct hobe_text text = {0};
    snprintf(data, sizeof data, "%s.data.csv", name);
    snprintf(script, sizeof script, "%s.gp", name);
    snprintf(image, sizeof image, "%s.png", name);
    hobe_plot_data(&text, plot);
    enum hobe_status status = hobe_write_text(folder, data, &text, err);
    if (!status) {
        hobe_plot_script(&text, plot, data, image);
        status = hobe_write_text(folder, script, &text, err);
    }
    return status ? status : hobe_plot_draw(folder, script, image, drawn, err);
}
