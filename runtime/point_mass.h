/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Masses at points of beams: m w_v w_w (x) I_3 on the vectors of an element, w = N phi(y, z) there,
 * of every mode of the section. */
#ifndef HOBE_POINT_MASS_H
#define HOBE_POINT_MASS_H

#include "model.h"

struct point_mass {
    struct hobe_mass spec;
    struct place place;
    double weight[HOBE_MAX_VECTORS]; /* w, of the element's vectors */
};

static inline struct point_mass *model_mass(const struct hobe_model *model, size_t i)
{
    return (struct point_mass *)model->masses.item + i;
}

/* value = its part of a field of vectors, a[vectors][3]: its displacement, or likewise. */
void point_mass_value(const struct hobe_model *model, const struct point_mass *mass,
                      const double *a, double value[3]);

/* f[vectors][3] += factor times the force m g that acts on it in the field g, m/s^2. */
void point_mass_force(const struct hobe_model *model, const struct point_mass *mass, double factor,
                      const double g[3], double *f);

/* K += its part of m (x) A. */
void point_mass_matrix(const struct hobe_model *model, const struct point_mass *mass,
                       const double A[3][3], const struct matrix *K);

/* Finds the places of all masses. */
enum hobe_status point_mass_places(struct hobe_model *model, struct hobe_error *err);

#endif
