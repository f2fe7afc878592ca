/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_cache.h"

#include <pthread.h>
#include <string.h>

struct entry {
    struct entry *next;
    hobe_section *section;
    long users;
    size_t count;
    double content[]; /* [count] */
};

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static struct entry *entries; /* those in use */

/* Counts one more user of the entry with the content of `like`, or returns NULL. */
static struct entry *use(const struct entry *like)
{
    struct entry *e = entries;
    while (e && (e->count != like->count ||
                 memcmp(e->content, like->content, like->count * sizeof *like->content) != 0))
        e = e->next;
    if (e)
        e->users++;
    return e;
}

static struct entry *find(const struct entry *like)
{
    pthread_mutex_lock(&lock);
    struct entry *found = use(like);
    pthread_mutex_unlock(&lock);
    return found;
}

/* Makes a solved entry the one of its content, unless another thread has been faster. */
static struct entry *add(struct entry *entry)
{
    pthread_mutex_lock(&lock);
    struct entry *found = use(entry);
    if (!found) {
        entry->users = 1;
        entry->next = entries;
        entries = found = entry;
    }
    pthread_mutex_unlock(&lock);
    return found;
}

static void free_entry(struct entry *entry)
{
    if (entry)
        hobe_section_free(entry->section);
    hobe_free(entry);
}

const hobe_section *hobe_section_share(hobe_section *section, const double *content, size_t count,
                                       enum hobe_status (*solve)(hobe_section *section,
                                                                 struct hobe_error *err),
                                       struct hobe_error *err)
{
    struct entry *entry = hobe_alloc(1, sizeof *entry + count * sizeof *content, err);
    if (!entry) {
        hobe_section_free(section);
        return NULL;
    }
    entry->section = section;
    entry->count = count;
    memcpy(entry->content, content, count * sizeof *content);
    struct entry *shared = find(entry);
    if (!shared && !solve(section, err))
        shared = add(entry);
    if (shared != entry)
        free_entry(entry);
    return shared ? shared->section : NULL;
}

void hobe_section_drop(const hobe_section *section)
{
    struct entry *unused = NULL;
    pthread_mutex_lock(&lock);
    struct entry **at = &entries;
    while ((*at)->section != section)
        at = &(*at)->next;
    if (--(*at)->users == 0) {
        unused = *at;
        *at = unused->next;
    }
    pthread_mutex_unlock(&lock);
    free_entry(unused);
}
