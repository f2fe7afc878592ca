/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that people read beside a colour bar. */
#ifndef HOBE_SCALE_H
#define HOBE_SCALE_H

enum { HOBE_NUMBER = 40 }; /* bytes of a number in words */

/* The smallest of 1, 2, 5 times a power of ten that divides `range` > 0 into at most `most` >= 1
 * steps. */
double hobe_tick_step(double range, int most);

/* The power of ten, a multiple of 3, that leaves numbers of the size |x| with one to three digits
 * before the point; 0 for 0, and where they need none: from 0.01 to 999. */
int hobe_tick_power(double x);

/* x with as many digits after the point as ticks of this step have. */
void hobe_tick_text(double x, double step, char *text);

/* x with three digits and the power of ten in superscripts where it needs one: "4.92·10⁻³". */
void hobe_number_text(double x, char *text);

/* "10⁻³" for -3; UTF-8. */
void hobe_power_text(int power, char *text);

#endif
