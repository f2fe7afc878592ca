/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _DEFAULT_SOURCE
#include "journal.h"

#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

struct head {
    uint64_t size, sum;
};

struct hobe_journal {
    int file;
    char *bytes;     /* [size] of the file when it was opened */
    size_t size;     /* of its whole records */
    size_t next;     /* where the record to be read next begins */
    char path[1024]; /* for sentences */
};

/* Records begin at multiples of this, so that what they hold is aligned. */
enum { ALIGNED = 8 };

static size_t padded(uint64_t size)
{
    return (size_t)(size + (ALIGNED - 1)) / ALIGNED * ALIGNED;
}

/* Fowler, Noll & Vo's sum (FNV-1a), of the size as well, so that no run of zeros is a record. */
uint64_t journal_sum(const void *bytes, size_t size)
{
    const unsigned char *b = bytes;
    uint64_t sum = 14695981039346656037u ^ size;
    for (size_t i = 0; i < size; i++)
        sum = (sum ^ b[i]) * 1099511628211u;
    return sum;
}

/* The record at an offset, if it is whole, and where the next one would be. */
static const char *record_at(const char *bytes, size_t end, size_t offset, struct head *head,
                             size_t *next)
{
    if (offset >= end || end - offset < sizeof *head)
        return NULL;
    memcpy(head, bytes + offset, sizeof *head);
    const size_t room = end - offset - sizeof *head;
    const char *record = bytes + offset + sizeof *head;
    if (head->size > room || padded(head->size) > room ||
        head->sum != journal_sum(record, head->size))
        return NULL;
    *next = offset + sizeof *head + padded(head->size);
    return record;
}

static enum hobe_status fail_io(const hobe_journal *j, const char *verb, struct hobe_error *err)
{
    return hobe_fail(err, HOBE_IO, NULL, "%s could not be %s: %s", j->path, verb, strerror(errno));
}

/* ---- opening --------------------------------------------------------------------------------- */

/* A program that was just killed keeps its lock until it has left the system. */
static enum hobe_status lock(const hobe_journal *j, struct hobe_error *err)
{
    const struct timespec moment = {.tv_nsec = 50 * 1000 * 1000};
    for (int i = 0; i < 20; i++) {
        if (!flock(j->file, LOCK_EX | LOCK_NB))
            return HOBE_OK;
        nanosleep(&moment, NULL);
    }
    return hobe_fail(err, HOBE_IO, NULL, "%s is in use by another run", j->path);
}

static enum hobe_status open_file(hobe_journal *j, const char *folder, const char *name,
                                  struct hobe_error *err)
{
    const char *base;
    const enum hobe_status status = hobe_make_folder(folder, err);
    const int dir = status ? -1 : hobe_open_parent(folder, name, 1, &base, err);
    if (dir < 0)
        return status ? status : HOBE_IO;
    j->file = openat(dir, base, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    const int cause = errno;
    close(dir);
    errno = cause;
    if (j->file < 0)
        return fail_io(j, "opened", err);
    return lock(j, err);
}

static enum hobe_status read_file(hobe_journal *j, struct hobe_error *err)
{
    struct stat is;
    if (fstat(j->file, &is) || !S_ISREG(is.st_mode))
        return fail_io(j, "read", err);
    j->bytes = hobe_alloc((size_t)is.st_size, 1, err);
    if (!j->bytes)
        return HOBE_NO_MEMORY;
    while (j->size < (size_t)is.st_size) {
        const ssize_t n = read(j->file, j->bytes + j->size, (size_t)is.st_size - j->size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return fail_io(j, "read", err);
        if (n == 0)
            break;
        j->size += (size_t)n;
    }
    return HOBE_OK;
}

/* Keeps the whole records of a journal with that key; one that ended before its key is as good as
 * none. */
static enum hobe_status resume_file(hobe_journal *j, const char *key, struct hobe_error *err)
{
    struct head head;
    size_t end = 0, next;
    const enum hobe_status status = read_file(j, err);
    if (status)
        return status;
    const char *first = record_at(j->bytes, j->size, 0, &head, &next);
    if (first && (head.size != strlen(key) || memcmp(first, key, head.size) != 0))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s belongs to another run: the case, its parameters and the program must "
                         "be those that wrote it; start anew without --resume",
                         j->path);
    if (!first && j->size > sizeof head + padded(strlen(key)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s is not a journal of hobe, or damaged; start anew without --resume",
                         j->path);
    while (record_at(j->bytes, j->size, end, &head, &next))
        end = next;
    j->size = end;
    j->next = sizeof head + padded(strlen(key));
    return HOBE_OK;
}

hobe_journal *journal_open(const char *folder, const char *name, const char *key, int resume,
                           struct hobe_error *err)
{
    hobe_journal *j = hobe_alloc(1, sizeof *j, err);
    if (!j)
        return NULL;
    j->file = -1;
    snprintf(j->path, sizeof j->path, "%.700s/%.300s", folder, name);
    enum hobe_status status = open_file(j, folder, name, err);
    if (!status && resume)
        status = resume_file(j, key, err);
    if (!status && (ftruncate(j->file, (off_t)j->size) || lseek(j->file, 0, SEEK_END) < 0))
        status = fail_io(j, "written", err);
    if (!status && j->size == 0)
        status = journal_add(j, key, strlen(key), err);
    if (!status)
        return j;
    journal_close(j);
    return NULL;
}

void journal_remove(const char *folder, const char *name)
{
    const char *base;
    const int dir = hobe_open_parent(folder, name, 0, &base, NULL);
    if (dir >= 0) {
        unlinkat(dir, base, 0);
        close(dir);
    }
}

void journal_close(hobe_journal *j)
{
    if (!j)
        return;
    if (j->file >= 0)
        close(j->file);
    hobe_free(j->bytes);
    hobe_free(j);
}

/* ---- records --------------------------------------------------------------------------------- */

const void *journal_read(hobe_journal *j, size_t *size)
{
    struct head head;
    const char *record = record_at(j->bytes, j->size, j->next, &head, &j->next);
    if (record)
        *size = (size_t)head.size;
    return record;
}

enum hobe_status journal_add(hobe_journal *j, const void *record, size_t size,
                             struct hobe_error *err)
{
    const size_t all = sizeof(struct head) + padded(size);
    char *bytes = j->file < 0 ? NULL : hobe_alloc(all, 1, err);
    if (j->file < 0)
        return hobe_fail(err, HOBE_IO, NULL, "%s could not be written before", j->path);
    if (!bytes)
        return HOBE_NO_MEMORY;
    const struct head head = {size, journal_sum(record, size)};
    memcpy(bytes, &head, sizeof head);
    memcpy(bytes + sizeof head, record, size);
    size_t written = 0;
    while (written < all) {
        const ssize_t n = write(j->file, bytes + written, all - written);
        if (n < 0 && errno != EINTR)
            break;
        written += n < 0 ? 0 : (size_t)n;
    }
    hobe_free(bytes);
    if (written == all && !fsync(j->file))
        return HOBE_OK;
    const enum hobe_status status = fail_io(j, "written", err);
    close(j->file);
    j->file = -1;
    return status;
}
