/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums of the elements' energy, force and tangent stiffness over a model. */
#ifndef HOBE_ASSEMBLE_H
#define HOBE_ASSEMBLE_H

#include "model.h"

/* f[vectors][3] = dU/dq of all elements in state u, N; and Ax[nonzeros] the values of the tangent
 * stiffness of the unknowns in the model's pattern, unless Ax is NULL.  Both overwritten. */
void assemble(const struct hobe_model *model, const double *u, double *f, double *Ax);

/* f[V][3] = dU/dq of element e of a beam alone, N, in memory of its own. */
enum hobe_status assemble_element(const struct hobe_model *model, const struct beam *beam, int e,
                                  const double *u, double *f, struct hobe_error *err);

/* Strain energy of all elements, J. */
double assemble_energy(const struct hobe_model *model, const double *u);

#endif
