/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fault.h"

#include "check.h"

#include <stdio.h>
#include <string.h>

void fail_each_allocation(fault_run *run, void *context, long least, long most, const char *what)
{
    long n = 0, seen;
    do {
        struct hobe_error err = {0};
        hobe_fail_allocation(++n);
        const enum hobe_status status = run(context, &err);
        seen = hobe_fail_allocation(0);
        if (seen >= n)
            check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY &&
                           strncmp(err.message, "out of memory", 13) == 0,
                       "%s, allocation %ld of %ld: status %d, %s", what, n, seen, status,
                       err.message);
        else
            check_that(!status, "%s: nothing failed: %s", what, err.message);
    } while (seen >= n && n <= most);
    check_that(n > least && n <= most, "%s: %ld allocations", what, n - 1);
    printf("%s: %ld allocations\n", what, n - 1);
}
