/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "error.h"

#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HOBE_ERROR_WORDS(code, words) words,
static const char *const status_words[] = {HOBE_ERROR_LIST(HOBE_ERROR_WORDS)};

enum { ALIGNMENT = 64 };

static atomic_long allocations, fail_at;

const char *hobe_status_words(enum hobe_status status)
{
    return (unsigned)status < HOBE_STATUSES ? status_words[status] : "unknown status";
}

enum hobe_status hobe_fail(struct hobe_error *err, enum hobe_status status, const char *where,
                           const char *format, ...)
{
    if (err) {
        va_list arguments;
        err->status = status;
        err->where = where;
        va_start(arguments, format);
        vsnprintf(err->message, sizeof err->message, format, arguments);
        va_end(arguments);
    }
    return status;
}

void hobe_fail_in(struct hobe_error *err, const char *what)
{
    char sentence[sizeof err->message];
    if (!err || err->status != HOBE_BAD_INPUT)
        return;
    memcpy(sentence, err->message, sizeof sentence);
    snprintf(err->message, sizeof err->message, "%.200s: %.700s", what, sentence);
}

void *hobe_alloc(size_t count, size_t size, struct hobe_error *err)
{
    const long n = ++allocations;
    void *p = NULL;
    size_t bytes = ALIGNMENT;
    if ((size == 0 || count <= (SIZE_MAX - ALIGNMENT) / size) && !(fail_at && n == fail_at)) {
        bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        p = aligned_alloc(ALIGNMENT, bytes ? bytes : ALIGNMENT);
    }
    if (!p) {
        hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: no room for %zu items of %zu bytes",
                  count, size);
        return NULL;
    }
    return memset(p, 0, bytes ? bytes : ALIGNMENT);
}

void *hobe_grow(void *p, size_t old_count, size_t new_count, size_t size, struct hobe_error *err)
{
    void *grown = hobe_alloc(new_count, size, err);
    if (!grown)
        return NULL;
    if (p)
        memcpy(grown, p, (old_count < new_count ? old_count : new_count) * size);
    hobe_free(p);
    return grown;
}

void hobe_free(void *p)
{
    free(p);
}

long hobe_fail_allocation(long n)
{
    const long seen = allocations;
    allocations = 0;
    fail_at = n;
    return seen;
}
