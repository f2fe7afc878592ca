/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

#include <stdio.h>
#include <string.h>

enum { CHECKS = 200, PRINTED = 4 };

static struct entry {
    const char *name;
    long double worst, tolerance;
    char where[80];
    long count, failures;
} entry[CHECKS];
static int entries;

static struct entry *find(const char *name)
{
    for (int i = 0; i < entries; i++)
        if (!strcmp(entry[i].name, name))
            return &entry[i];
    struct entry *e = &entry[entries < CHECKS - 1 ? entries++ : CHECKS - 1];
    e->name = name;
    e->worst = -1;
    return e;
}

void check(const char *name, const char *where, long double error, long double tolerance)
{
    struct entry *e = find(name);
    e->count++;
    if (!(error <= e->worst)) { /* also a NaN is worse */
        e->worst = error;
        e->tolerance = tolerance;
        snprintf(e->where, sizeof e->where, "%s", where);
    }
    if (error <= tolerance)
        return;
    if (e->failures++ < PRINTED)
        printf("FAILED %s: %s: error %.3Lg > %.3Lg\n", name, where, error, tolerance);
}

long check_report(void)
{
    long count = 0, failures = 0;
    for (int i = 0; i < entries; i++) {
        const struct entry *e = &entry[i];
        printf("%s: max error %.2Lg (%s), tolerance %.2Lg, %ld checks", e->name, e->worst, e->where,
               e->tolerance, e->count);
        if (e->failures)
            printf(", %ld FAILED\n", e->failures);
        else
            printf(" ok\n");
        count += e->count;
        failures += e->failures;
    }
    printf("%ld checks, %ld failures\n", count, failures);
    return failures;
}
