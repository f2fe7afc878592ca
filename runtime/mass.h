/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mass matrix of a model: constant, and M = m (x) I_3 with the m of each part. */
#ifndef HOBE_MASS_H
#define HOBE_MASS_H

#include "model.h"

/* factor I_3 for A below. */
#define MASS_ISOTROPIC(factor)                                                                     \
    ((const double[3][3]){{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}})

/* f[vectors][3] += factor M a, a[vectors][3]. */
void mass_force(const struct hobe_model *model, double factor, const double *a, double *f);

/* K += factor M */
void mass_matrix(const struct hobe_model *model, double factor, const struct matrix *K);

/* The same with m (x) A in the place of M, and f of one element of a beam alone. */
void mass_force_through(const struct hobe_model *model, const double A[3][3], const double *a,
                        double *f);
void mass_matrix_through(const struct hobe_model *model, const double A[3][3],
                         const struct matrix *K);
void mass_element_force(const struct hobe_model *model, const struct beam *beam, int e,
                        const double A[3][3], const double *a, double *f);

/* Of one beam alone. */
void mass_force_of(const struct hobe_model *model, const struct beam *beam, double factor,
                   const double *a, double *f);
void mass_matrix_of(const struct hobe_model *model, const struct beam *beam, double factor,
                    const struct matrix *K);
double mass_product_of(const struct hobe_model *model, const struct beam *beam, const double *a,
                       const double *b);

/* a'M b of two fields [vectors][3], held vectors included. */
double mass_product(const struct hobe_model *model, const double *a, const double *b);

/* field[vectors][3] = the unit translation of everything along a global axis. */
void mass_translation(const struct hobe_model *model, int axis, double *field);

/* *mass, kg, and the radius of gyration about the mass centre, sections included, *size, m, of the
 * reference. */
enum hobe_status mass_measure(const struct hobe_model *model, double *mass, double *size,
                              struct hobe_error *err);

/* HOBE_BAD_INPUT where a beam has no mass; `what` needs some ("vibration"), `where` is its tag,
 * NULL: the beam's. */
enum hobe_status mass_check(const struct hobe_model *model, const char *what, const char *where,
                            struct hobe_error *err);

#endif
