/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HOBE_QUARTIC_H
#define HOBE_QUARTIC_H
#include "model.h"
struct quartic {
    const hobe_model *full;
    long n;
    double *centre;
    double *field;
    double *u, *f;
    struct matrix K;
};
enum hobe_status quartic_open(struct quartic *q, const hobe_model *full, const double *centre,
                              long n, const double *field, struct hobe_error *err);
void quartic_close(struct quartic *q);
double quartic_energy(const struct quartic *q, const double *x);
void quartic_add(const struct quartic *q, const double *x, double *f, double *K);
#endif
