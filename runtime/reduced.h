/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A basis with the elastic energy on it: what models are reduced by. */
#ifndef HOBE_REDUCED_H
#define HOBE_REDUCED_H

#include "basis.h"
#include "hobe.h"
#include "quartic.h"
#include "quartic_closed.h"

#include <stdint.h>

/* What the beams of two models have in common where a basis serves both. */
struct fingerprint {
    uint64_t whole;   /* sum of what is counted: elements, joined and held vectors */
    double number[2]; /* strain energy of a field, J, and the reference along it, m^2 */
};

struct hobe_reduced {
    hobe_model *model;
    struct hobe_reduced_info info;
    struct fingerprint fingerprint;
    struct basis basis;           /* of the model's fields; zero at held vectors */
    double *centre;               /* [vectors][3] u_c; NULL: the reference */
    struct quartic quartic;       /* the energy on its fields, */
    struct quartic_closed closed; /* or on its functions, where it has such */
};

/* That of a model which is built. */
enum hobe_status reduced_fingerprint(const hobe_model *model, struct fingerprint *print,
                                     struct hobe_error *err);

/* Whether they are of the same beams, as far as rounding on another machine lets them be. */
int reduced_same(const struct fingerprint *a, const struct fingerprint *b);

/* U(q), J; f[n] += dU/dq and, unless NULL, K[n][n] += d2U/dq2 of the n coordinates.  Not for two
 * threads at once. */
double reduced_energy(const struct hobe_reduced *r, const double *q);
void reduced_add(const struct hobe_reduced *r, const double *q, double *f, double *K);

/* What is left to do once basis and centre are there, or are others: energy, and what is said of
 * them. */
enum hobe_status reduced_finish(struct hobe_reduced *r, double started, struct hobe_error *err);

#endif
