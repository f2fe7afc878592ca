/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The nodal vectors of a kernel: which there are, where they start, the axes they give. */
#ifndef HOBE_KERNEL_VECTORS_H
#define HOBE_KERNEL_VECTORS_H

#include "kernel.h"

/* The position of an element's last node among its vectors: elements of a beam overlap there, so
 * that element e of a beam owns the vectors e * hobe_kernel_step() + v. */
int hobe_kernel_step(const struct hobe_kernel *kernel);

/* Reference nodal vectors q0[vectors][3] of a straight element of that length, its first node at
 * the origin, on the axes frame[3] = e_x, e_y, e_z (rows). */
void hobe_kernel_reference(const struct hobe_kernel *kernel, double length,
                           const double frame[3][3], double *q0);

/* The vector that is the value (slope = 0) or slope of a mode at a node; -1 where there is none. */
int hobe_kernel_vector(const struct hobe_kernel *kernel, int node, int mode, int slope);

/* The section's axes where the axial functions are N, Nx, of an element with the reference
 * q0[vectors][3], rows: e_x along d_0', e_y as near to d_y as can be. */
void hobe_kernel_axes(const struct hobe_kernel *kernel, const double *N, const double *Nx,
                      const double *q0, double axes[3][3]);

#endif
