/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scale.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

double hobe_tick_step(double range, int most)
{
    static const double nice[] = {1, 2, 5, 10};
    const double least = range / most, decade = pow(10, floor(log10(least)));
    int i = 0;
    while (i < 3 && nice[i] * decade < least * (1 - 1e-9)) /* as many as `most`, but for rounding */
        i++;
    return nice[i] * decade;
}

int hobe_tick_power(double x)
{
    const double size = fabs(x) * 1.0005; /* 999.7 has the three digits of 1000 */
    if (size == 0 || !isfinite(size) || (size >= 0.01 && size < 1000))
        return 0;
    return 3 * (int)floor(log10(size) / 3);
}

void hobe_tick_text(double x, double step, char *text)
{
    const int digits = (int)fmax(0, -floor(log10(step) + 1e-9));
    const double size = fabs(x) < step / 1e6 ? 0 : fabs(x);
    snprintf(text, HOBE_NUMBER, "%s%.*f", size > 0 && x < 0 ? "−" : "", digits, size);
}

void hobe_power_text(int power, char *text)
{
    static const char *const digit[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];
    snprintf(plain, sizeof plain, "%d", power < 0 ? -power : power);
    strcpy(text, power < 0 ? "10⁻" : "10");
    for (const char *c = plain; *c; c++)
        strcat(text, digit[*c - '0']);
}

void hobe_number_text(double x, char *text)
{
    const int power = hobe_tick_power(x);
    char ten[HOBE_NUMBER];
    hobe_power_text(power, ten);
    if (power)
        snprintf(text, HOBE_NUMBER, "%.3g·%.24s", x / pow(10, power), ten);
    else
        snprintf(text, HOBE_NUMBER, "%.3g", x);
}
