/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A file that grows by records and is whole after each: what a long run needs to go on from where
 * it was killed.
 *
 *     file   = record*            the first holds the key: what the run is
 *     record = size, sum, bytes   two 64-bit numbers of this machine, then size bytes
 *
 * A record is on the disk when journal_add returns.  One that was torn by a kill has a sum that is
 * not its own: it and what may follow count as never written. */
#ifndef HOBE_JOURNAL_H
#define HOBE_JOURNAL_H

#include "error.h"

#include <stddef.h>
#include <stdint.h>

typedef struct hobe_journal hobe_journal;

/* Opens folder/name (hobe_check_name) for the run that `key` says.  resume: keeps the records of a
 * journal that is there, else begins a new one.  NULL with err set: HOBE_BAD_INPUT where the
 * journal to resume is of another run, or not one; HOBE_IO, also where another program has it open.
 */
hobe_journal *journal_open(const char *folder, const char *name, const char *key, int resume,
                           struct hobe_error *err);

/* The next of the records that were there when it was opened, from the first behind the key, and
 * its size in bytes; NULL behind the last.  Aligned to 8 bytes, owned by the journal. */
const void *journal_read(hobe_journal *journal, size_t *size);

/* Appends a record.  HOBE_IO, after which no more can be added. */
enum hobe_status journal_add(hobe_journal *journal, const void *record, size_t size,
                             struct hobe_error *err);

/* The sum of size bytes that records are known by. */
uint64_t journal_sum(const void *bytes, size_t size);

/* Removes a journal's file, if there is one. */
void journal_remove(const char *folder, const char *name);

/* Closes the file, which stays; NULL is allowed. */
void journal_close(hobe_journal *journal);

#endif
