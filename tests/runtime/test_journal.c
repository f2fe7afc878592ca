/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The journal: cut at any byte, whole records are found and no other; it can be continued there. */
#define _DEFAULT_SOURCE
#include "check.h"
#include "error.h"
#include "journal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { RECORDS = 6, MOST = 40 };

static char folder[64] = "/tmp/hobe-journal-XXXXXX", path[128];
static const char *const NAME = "run.journal", *const KEY = "a key";

/* Record i: i * i bytes of its own. */
static size_t record(int i, char bytes[MOST])
{
    memset(bytes, 'a' + i, MOST);
    return (size_t)(i * i);
}

static hobe_journal *opened(int resume)
{
    struct hobe_error err;
    hobe_journal *j = journal_open(folder, NAME, KEY, resume, &err);
    if (!j)
        check_stop("%s", err.message);
    return j;
}

static void add(hobe_journal *j, int from, int to)
{
    struct hobe_error err;
    char bytes[MOST];
    for (int i = from; i < to; i++)
        if (journal_add(j, bytes, record(i, bytes), &err))
            check_stop("%s", err.message);
}

/* Reads all records, which must be 0, 1, 2, ...; how many. */
static int count(hobe_journal *j)
{
    int n = 0;
    size_t size;
    for (const char *found; (found = journal_read(j, &size)); n++) {
        char bytes[MOST];
        const int same = size == record(n, bytes) && memcmp(found, bytes, size) == 0;
        check_that(same && (size_t)found % 8 == 0, "record %d", n);
    }
    return n;
}

static off_t size_of_file(void)
{
    struct stat is;
    return stat(path, &is) ? -1 : is.st_size;
}

/* ends[i]: the size of the file with i records */
static void write_all(off_t ends[RECORDS + 1])
{
    hobe_journal *j = opened(0);
    check_that(count(j) == 0, "a new journal is empty");
    for (int i = 0; i < RECORDS; i++) {
        ends[i] = size_of_file();
        add(j, i, i + 1);
    }
    ends[RECORDS] = size_of_file();
    journal_close(j);
}

static void cut_anywhere(void)
{
    off_t ends[RECORDS + 1];
    write_all(ends);
    for (off_t size = ends[RECORDS]; size >= 0; size--) {
        int whole = 0;
        write_all(ends);
        while (whole < RECORDS && ends[whole + 1] <= size)
            whole++;
        if (truncate(path, size))
            check_stop("truncate");
        hobe_journal *j = opened(1);
        check_that(count(j) == whole, "records of %ld bytes", (long)size);
        add(j, whole, RECORDS);
        journal_close(j);
        j = opened(1);
        check_that(count(j) == RECORDS && size_of_file() == ends[RECORDS],
                   "records added to %ld bytes", (long)size);
        journal_close(j);
    }
}

/* One bit in the last record, or in its head. */
static void damaged(void)
{
    off_t ends[RECORDS + 1];
    for (int back = 1; back <= 48; back++) { /* 25 bytes padded to 32, 16 of the head */
        write_all(ends);
        FILE *file = fopen(path, "r+b");
        fseek(file, -back, SEEK_END);
        const int byte = fgetc(file);
        fseek(file, -back, SEEK_END);
        fputc(byte ^ 4, file);
        fclose(file);
        hobe_journal *j = opened(1);
        check_that(count(j) == RECORDS - (back > 7), "a bit, %d bytes from the end", back);
        journal_close(j);
    }
}

static void refused(const char *key, const char *words)
{
    struct hobe_error err = {0};
    hobe_journal *j = journal_open(folder, NAME, key, 1, &err);
    check_that(!j && err.status && strstr(err.message, words), "\"%s\": %s", words, err.message);
    journal_close(j);
}

static void refusals(void)
{
    off_t ends[RECORDS + 1];
    write_all(ends);
    refused("another key", "belongs to another run");
    hobe_journal *j = opened(1);
    refused(KEY, "in use by another run");
    journal_close(j);
    FILE *file = fopen(path, "wb");
    fputs("something else altogether, and longer than a head and a key", file);
    fclose(file);
    refused(KEY, "not a journal of hobe");
}

int main(void)
{
    if (!mkdtemp(folder))
        check_stop("mkdtemp");
    snprintf(path, sizeof path, "%s/%s", folder, NAME);
    cut_anywhere();
    damaged();
    refusals();
    unlink(path);
    rmdir(folder);
    return check_report();
}
