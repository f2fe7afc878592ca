/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files for ParaView and its kin. */
#ifndef HOBE_OUTPUT_VTK_H
#define HOBE_OUTPUT_VTK_H

#include "output.h"
#include "solid.h"

/* Appends a solid as a .vtu file: wedges of VTK's type 32 in the reference; of each point its
 * displacement (for "Warp By Vector"), and where there is stress the tensors `stress` (Cauchy,
 * global axes, Pa) and `strain` (Green-Lagrange, on the section's axes in the reference, shear as
 * that of a tensor), xx, yy, zz, xy, yz, xz, and `von Mises`, Pa. */
void hobe_vtk_solid(const struct hobe_solid *solid, struct hobe_text *text);

/* Appends a .pvd file that lists file[count] in the same folder, each with its time. */
void hobe_vtk_series(int count, const char *const *file, const double *time,
                     struct hobe_text *text);

#endif
