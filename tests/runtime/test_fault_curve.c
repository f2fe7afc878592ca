/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of both kinds while the n-th of the library's own allocations fails, n = 1, 2, ... */
#include "check.h"
#include "hobe.h"

#include <stdio.h>
#include <string.h>

static enum hobe_status parabola(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context, (void)err;
    r[0] = t;
    r[1] = t * t;
    r[2] = 0;
    return HOBE_OK;
}

static enum hobe_status twist(void *context, double at, double *phi, struct hobe_error *err)
{
    (void)context, (void)err;
    *phi = at;
    return HOBE_OK;
}

/* The curve, also where it could not be twisted. */
static hobe_curve *make(int by_points, enum hobe_status *status, struct hobe_error *err)
{
    static const double point[4][3] = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 3, 1}};
    hobe_curve *curve =
        by_points ? hobe_curve_points(4, point, err) : hobe_curve_function(parabola, NULL, err);
    *status = curve ? hobe_curve_twist(curve, twist, NULL, err) : err->status;
    return curve;
}

int main(void)
{
    for (int by_points = 0; by_points < 2; by_points++) {
        long n = 0, seen;
        do {
            struct hobe_error err = {0};
            enum hobe_status status;
            hobe_fail_allocation(++n);
            hobe_curve *curve = make(by_points, &status, &err);
            seen = hobe_fail_allocation(0);
            if (seen >= n)
                check_that(status == HOBE_NO_MEMORY && err.status == HOBE_NO_MEMORY &&
                               strncmp(err.message, "out of memory", 13) == 0,
                           "kind %d, allocation %ld of %ld: %s", by_points, n, seen, err.message);
            else
                check_that(!status, "nothing failed: %s", err.message);
            hobe_curve_free(curve);
        } while (seen >= n && n < 100);
        check_that(n > 6, "kind %d: %ld allocations", by_points, n - 1);
        printf("kind %d: %ld allocations\n", by_points, n - 1);
    }
    return check_report();
}
