/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static long passed, failed;
static uint64_t state;

static int count(int holds, const char *format, va_list arguments)
{
    if (holds) {
        passed++;
        return 1;
    }
    failed++;
    printf("FAILED: ");
    vprintf(format, arguments);
    return 0;
}

int check_that(int holds, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    count(holds, format, arguments);
    va_end(arguments);
    if (!holds)
        printf("\n");
    return holds;
}

static int compare(double value, double expected, double allowed, const char *format,
                   va_list arguments)
{
    const int holds = fabs(value - expected) <= allowed;
    count(holds, format, arguments);
    if (!holds)
        printf(": got %.12g, expected %.12g, off by %.3g, allowed %.3g\n", value, expected,
               value - expected, allowed);
    return holds;
}

int check_absolute(double value, double expected, double tolerance, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int holds = compare(value, expected, tolerance, format, arguments);
    va_end(arguments);
    return holds;
}

int check_relative(double value, double expected, double tolerance, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int holds = compare(value, expected, tolerance * fabs(expected), format, arguments);
    va_end(arguments);
    return holds;
}

int check_report(void)
{
    printf("%ld passed, %ld failed\n", passed, failed);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

void check_stop(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    count(0, format, arguments);
    va_end(arguments);
    printf("\n");
    check_report();
    exit(EXIT_FAILURE);
}

void random_start(void)
{
    const char *seed = getenv("HOBE_TEST_SEED");
    if (!seed || !*seed)
        seed = "1";
    printf("seed %s\n", seed);
    state = 14695981039346656037u; /* FNV-1a, so that the seed may be any text */
    for (; *seed; seed++)
        state = (state ^ (unsigned char)*seed) * 1099511628211u;
}

double random_real(double from, double to)
{
    state += 0x9e3779b97f4a7c15u; /* splitmix64 */
    uint64_t x = state;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    x ^= x >> 31;
    return from + (to - from) * (double)(x >> 11) * 0x1p-53;
}

void random_direction(double d[3])
{
    double length;
    do {
        for (int a = 0; a < 3; a++)
            d[a] = random_real(-1, 1);
        length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    } while (length > 1 || length < 0.1);
    for (int a = 0; a < 3; a++)
        d[a] /= length;
}
