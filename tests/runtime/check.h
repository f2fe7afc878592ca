/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counted checks: a failure prints a line, the last line of a test is "N passed, N failed". */
#ifndef HOBE_TEST_CHECK_H
#define HOBE_TEST_CHECK_H

#define CHECK_FORMAT(at) __attribute__((format(printf, at, at + 1)))

/* A statement that must hold; the format says which.  Returns it. */
int check_that(int holds, const char *format, ...) CHECK_FORMAT(2);

/* |value - expected| <= tolerance, and the same times |expected|.  A NaN fails. */
int check_absolute(double value, double expected, double tolerance, const char *format, ...)
    CHECK_FORMAT(4);
int check_relative(double value, double expected, double tolerance, const char *format, ...)
    CHECK_FORMAT(4);

/* The totals; the exit status. */
int check_report(void);

/* Ends the program where a test cannot go on: a failure and the totals. */
_Noreturn void check_stop(const char *format, ...) CHECK_FORMAT(1);

/* Random numbers in [from, to) and unit vectors; the seed is HOBE_TEST_SEED, or 1, and printed. */
void random_start(void);
double random_real(double from, double to);
void random_direction(double d[3]);

#endif
