/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks by name: each keeps its largest error and where it was seen, and is reported in a line. */
#ifndef HOBE_TEST_CHECK_H
#define HOBE_TEST_CHECK_H

/* Records that `error` was seen at `where` and must not exceed `tolerance`; a NaN fails.  The
 * name must be the same literal at every call of one check.  Failures are printed at once. */
void check(const char *name, const char *where, long double error, long double tolerance);

/* A condition that must hold. */
#define CHECK(condition, where) check(#condition, where, (condition) ? 0 : 1, 0)

/* Prints a line for each check and the totals; the number of failures. */
long check_report(void);

#endif
