/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam's stiffness per length, measured on one element at rest without end effects.
 *
 * In a long prismatic beam under stretch, bending or torsion alone the strain does not depend on x:
 * d_k(x) is a rigid motion growing along x plus a constant c_k.  Any element represents that
 * exactly, so its tangent at rest, projected on these fields, gives a small quadratic form; with
 * the constants c_k free it leaves the beam's own stiffness against the four strains of the axis.
 */
#ifndef HOBE_TEST_HOMOGENEOUS_H
#define HOBE_TEST_HOMOGENEOUS_H

#include "hobe.h"

enum homogeneous { STRETCH, BEND_Y, BEND_Z, TWIST, HOMOGENEOUS };

/* C[i][j]: N, N m, N m^2, with EA, EIyy, EIzz, GJ on the diagonal. */
void homogeneous_stiffness(const hobe_element *element, double C[HOMOGENEOUS][HOMOGENEOUS]);

#endif
