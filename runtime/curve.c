/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Placeholder until curves land: no caller makes one yet. */
#include "hobe.h"
double hobe_curve_length(const hobe_curve *curve)
{
    (void)curve;
    return 0;
}
enum hobe_status hobe_curve_at(const hobe_curve *curve, const double up[3], double at, double r[3],
                               double frame[3][3], double frame_x[3][3], struct hobe_error *err)
{
    (void)curve;
    (void)up;
    (void)at;
    (void)r;
    (void)frame;
    (void)frame_x;
    (void)err;
    return HOBE_OK;
}
