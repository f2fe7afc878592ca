/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Texts that grow in memory, and files that are written whole or not at all. */
#define _GNU_SOURCE
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- text ----------------------------------------------------------------------------------- */

/* Makes room for more bytes and a '\0'; 0 when there is no memory. */
static int reserve(struct hobe_text *text, size_t more)
{
    if (text->status)
        return 0;
    size_t need = text->size + more + 1;
    if (need <= text->room)
        return 1;
    size_t room = need < 128 ? 256 : 2 * need;
    char *at =
        text->at ? hobe_grow(text->at, text->room, room, 1, NULL) : hobe_alloc(room, 1, NULL);
    if (!at) {
        text->status = HOBE_NO_MEMORY;
        return 0;
    }
    text->at = at;
    text->room = room;
    return 1;
}

void hobe_text_add(struct hobe_text *text, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    int n = vsnprintf(NULL, 0, format, args);
    if (n > 0 && reserve(text, (size_t)n)) {
        vsnprintf(text->at + text->size, (size_t)n + 1, format, again);
        text->size += (size_t)n;
    }
    va_end(again);
    va_end(args);
}

void hobe_text_bytes(struct hobe_text *text, const char *bytes, size_t size)
{
    if (!reserve(text, size))
        return;
    memcpy(text->at + text->size, bytes, size);
    text->size += size;
    text->at[text->size] = '\0';
}

void hobe_text_csv(struct hobe_text *text, const char *cell)
{
    if (!cell[strcspn(cell, ",\"\r\n")]) {
        hobe_text_bytes(text, cell, strlen(cell));
        return;
    }
    hobe_text_bytes(text, "\"", 1);
    for (const char *c = cell; *c; c++) {
        hobe_text_bytes(text, c, 1);
        if (*c == '"')
            hobe_text_bytes(text, c, 1);
    }
    hobe_text_bytes(text, "\"", 1);
}

void hobe_text_number(struct hobe_text *text, double x)
{
    char digits[40];
    for (int n = 15; n <= 17; n++) {
        snprintf(digits, sizeof digits, "%.*g", n, x);
        if (strtod(digits, NULL) == x)
            break;
    }
    char *comma = strchr(digits, ','); /* a host program may have set a locale */
    if (comma)
        *comma = '.';
    hobe_text_bytes(text, digits, strlen(digits));
}

void hobe_text_free(struct hobe_text *text)
{
    hobe_free(text->at);
    *text = (struct hobe_text){0};
}

enum hobe_status hobe_text_check(const struct hobe_text *text, struct hobe_error *err)
{
    if (!text->status)
        return HOBE_OK;
    return hobe_fail(err, text->status, NULL, "out of memory for the text of a result");
}

/* ---- files ---------------------------------------------------------------------------------- */

/* Writes the sentence for errno; verb: "written", "read", "made". */
static enum hobe_status fail_io(struct hobe_error *err, const char *folder, const char *name,
                                const char *verb)
{
    return hobe_fail(err, HOBE_IO, NULL, "%s%s%s could not be %s: %s", folder, *name ? "/" : "",
                     name, verb, strerror(errno));
}

enum hobe_status hobe_make_folder(const char *path, struct hobe_error *err)
{
    char part[PATH_MAX];
    size_t size = strlen(path);
    if (size == 0 || size >= sizeof part)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "a folder's name must have 1 to %d characters",
                         PATH_MAX - 1);
    for (size_t n = 1; n <= size; n++) {
        if (path[n] != '/' && path[n] != '\0')
            continue;
        memcpy(part, path, n);
        part[n] = '\0';
        if (mkdir(part, 0777) && errno != EEXIST)
            return fail_io(err, part, "", "made");
    }
    struct stat status;
    if (stat(path, &status))
        return fail_io(err, path, "", "made");
    errno = ENOTDIR;
    return S_ISDIR(status.st_mode) ? HOBE_OK : fail_io(err, path, "", "made");
}

enum hobe_status hobe_check_name(const char *name, struct hobe_error *err)
{
    int start = 1, good = *name != '\0' && strlen(name) < 1000; /* start: of a part of the name */
    for (const char *c = name; *c; c++) {
        good = good && (unsigned char)*c >= ' ' && *c != 127 && *c != '\\';
        good = good && !(start && (*c == '/' || *c == '.'));
        start = *c == '/';
    }
    if (good && !start)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "a file must be a plain name inside the output folder, such as "
                     "\"figures/u3.png\", got \"%.200s\"",
                     name);
}

int hobe_open_parent(const char *folder, const char *name, int make, const char **base,
                     struct hobe_error *err)
{
    if (hobe_check_name(name, err))
        return -1;
    int dir = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const char *slash;
    for (*base = name; dir >= 0 && (slash = strchr(*base, '/')); *base = slash + 1) {
        char part[NAME_MAX + 1];
        int next = -1;
        if ((size_t)(slash - *base) >= sizeof part) {
            errno = ENAMETOOLONG;
        } else {
            memcpy(part, *base, (size_t)(slash - *base));
            part[slash - *base] = '\0';
            if (make)
                mkdirat(dir, part, 0777); /* a failure shows in openat */
            next = openat(dir, part, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        }
        int cause = errno;
        close(dir);
        errno = cause;
        dir = next;
    }
    if (dir < 0)
        fail_io(err, folder, name, make ? "written" : "read");
    return dir;
}

/* Writes all bytes, to the disk; 0 on success, else -1 with errno set. */
static int write_all(int file, const char *data, size_t size)
{
    while (size > 0) {
        ssize_t n = write(file, data, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return -1;
        data += n;
        size -= (size_t)n;
    }
    return fsync(file);
}

/* Creates base in dir through a temporary file; 0 on success, else -1 with errno set. */
static int replace(int dir, const char *base, const char *data, size_t size)
{
    static unsigned count;
    char temporary[64];
    snprintf(temporary, sizeof temporary, ".hobe-%ld-%u.tmp", (long)getpid(), count++);
    int file = openat(dir, temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0)
        return -1;
    int failed = write_all(file, data, size), cause = errno;
    if (close(file) && !failed) {
        failed = -1;
        cause = errno;
    }
    if (!failed && !renameat(dir, temporary, dir, base))
        return 0;
    if (!failed)
        cause = errno;
    unlinkat(dir, temporary, 0);
    errno = cause;
    return -1;
}

enum hobe_status hobe_write_file(const char *folder, const char *name, const char *data,
                                 size_t size, struct hobe_error *err)
{
    const char *base;
    enum hobe_status status = hobe_make_folder(folder, err);
    if (status)
        return status;
    int dir = hobe_open_parent(folder, name, 1, &base, err);
    if (dir < 0)
        return err ? err->status : HOBE_IO;
    if (replace(dir, base, data, size))
        status = fail_io(err, folder, name, "written");
    close(dir);
    return status;
}

enum hobe_status hobe_write_text(const char *folder, const char *name, struct hobe_text *text,
                                 struct hobe_error *err)
{
    enum hobe_status status = hobe_text_check(text, err);
    if (!status)
        status = hobe_write_file(folder, name, text->at, text->size, err);
    hobe_text_free(text);
    return status;
}

int hobe_open_file(const char *folder, const char *name, struct hobe_error *err)
{
    const char *base;
    int dir = hobe_open_parent(folder, name, 0, &base, err);
    if (dir < 0)
        return -1;
    /* Not blocking: a pipe with no writer must not hang the run before it is refused. */
    int file = openat(dir, base, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat status;
    if (file < 0) {
        fail_io(err, folder, name, "read");
    } else if (fstat(file, &status) || !S_ISREG(status.st_mode)) {
        hobe_fail(err, HOBE_IO, NULL, "%s/%s could not be read: not a regular file", folder, name);
        close(file);
        file = -1;
    }
    close(dir);
    return file;
}
