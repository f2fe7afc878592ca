/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What must hold when memory runs out anywhere. */
#ifndef HOBE_TEST_FAULT_H
#define HOBE_TEST_FAULT_H

#include "hobe.h"

/* Something that allocates, and frees what it made whatever its status. */
typedef enum hobe_status fault_run(void *context, struct hobe_error *err);

/* Runs it while the n-th of the library's own allocations fails, n = 1, 2, ... until it gets
 * through, which takes at least `least` allocations and at most `most`: each time before it ends
 * with "out of memory".  The sanitizer looks for leaks. */
void fail_each_allocation(fault_run *run, void *context, long least, long most, const char *what);

#endif
