/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bases of reduced models: few fields of displacements in which a model moves as it does under the
 * loads of interest. */
#ifndef HOBE_BASIS_H
#define HOBE_BASIS_H

#include "model.h"

/* Fields [n][vectors][3] of a model, m: zero at held vectors, bodies and multipliers, those of
 * joined vectors spread; orthonormal in the stiffness at rest (span.h), and independent.  They come
 * in the order of what they are worth: the first few are the best basis of that size.
 *
 * A basis of functions has psi_b e_a, in the order 3 b + a: its coordinates are vectors q_b. */
struct basis {
    long n, room;
    double *field;
};

/* Whether a basis is one of functions: closed under all maps in space, and not about a centre,
 * whose fields would have to be among them. */
static inline int basis_of_functions(int closed, int has_centre)
{
    return closed == 3 && !has_centre;
}

/* A basis as the options ask for.  HOBE_BAD_INPUT where they make none; closed by basis_free, after
 * an error too. */
enum hobe_status basis_make(hobe_model *full, const struct hobe_reduce *options,
                            struct basis *basis, struct hobe_error *err);

/* Appends what of a field of the model is new to the basis, if anything is; and what closes it
 * then, as the options have it. */
enum hobe_status basis_add(struct basis *basis, hobe_model *full, const struct hobe_reduce *options,
                           const double *field, struct hobe_error *err);
void basis_free(struct basis *basis);

#endif
