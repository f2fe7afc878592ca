/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of both kinds while the n-th of the library's own allocations fails, n = 1, 2, ... */
#include "check.h"
#include "fault.h"

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

static enum hobe_status make(void *by_points, struct hobe_error *err)
{
    static const double point[4][3] = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 3, 1}};
    hobe_curve *curve = *(const int *)by_points ? hobe_curve_points(4, point, err)
                                                : hobe_curve_function(parabola, NULL, err);
    const enum hobe_status status = curve ? hobe_curve_twist(curve, twist, NULL, err) : err->status;
    hobe_curve_free(curve);
    return status;
}

int main(void)
{
    for (int by_points = 0; by_points < 2; by_points++)
        fail_each_allocation(make, &by_points, 6, 100, by_points ? "points" : "function");
    return check_report();
}
