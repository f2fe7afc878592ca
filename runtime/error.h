/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One list of what can go wrong, and the allocation functions that report it.
 *
 * Every function that can fail takes a `struct hobe_error *` and returns a status; zero is success.
 * The core writes one sentence: what is wrong, the offending value, what would be right.  The
 * caller knows where the input came from and puts file and line in front. */
#ifndef HOBE_ERROR_H
#define HOBE_ERROR_H

#include <stdarg.h>
#include <stddef.h>

/*   code           in words */
#define HOBE_ERROR_LIST(X)                                                                         \
    X(HOBE_OK, "no error")                                                                         \
    X(HOBE_NO_MEMORY, "out of memory")                                                             \
    X(HOBE_BAD_INPUT, "bad input")                                                                 \
    X(HOBE_UNKNOWN, "unknown name")                                                                \
    X(HOBE_UNCONSTRAINED, "the scene can move freely")                                             \
    X(HOBE_UNSTABLE, "the elastic law is indefinite")                                              \
    X(HOBE_SINGULAR, "the tangent stiffness is singular")                                          \
    X(HOBE_NOT_CONVERGED, "Newton's iteration does not converge")                                  \
    X(HOBE_IO, "a file could not be read or written")

#define HOBE_ERROR_ENUM(code, words) code,
enum hobe_status { HOBE_ERROR_LIST(HOBE_ERROR_ENUM) HOBE_STATUSES };

struct hobe_error {
    enum hobe_status status;
    const char *where;  /* tag of the item at fault (hobe_beam.where etc.), or NULL */
    char message[1000]; /* one sentence */
};

/* The words of a status. */
const char *hobe_status_words(enum hobe_status status);

/* Writes a sentence into err (which may be NULL) and returns status. */
enum hobe_status hobe_fail(struct hobe_error *err, enum hobe_status status, const char *where,
                           const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Puts "what: " in front of a sentence about bad input in err (which may be NULL). */
void hobe_fail_in(struct hobe_error *err, const char *what);

/* Zeroed memory for count items of size bytes, aligned to 64 bytes (so that it may hold
 * hobe_lanes); NULL with err set when there is none.  A count of 0 gives a valid pointer. */
void *hobe_alloc(size_t count, size_t size, struct hobe_error *err);

/* Moves the old_count items at p into a new block of new_count; p stays valid on failure. */
void *hobe_grow(void *p, size_t old_count, size_t new_count, size_t size, struct hobe_error *err);

/* Frees what hobe_alloc gave; NULL is allowed. */
void hobe_free(void *p);

/* For tests: the n-th allocation from now fails (n >= 1), 0 turns that off.  Returns the number
 * of allocations since the last call. */
long hobe_fail_allocation(long n);

#endif
