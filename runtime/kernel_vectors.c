/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "kernel_vectors.h"

#include "hobe.h"
#include "vector3.h"

#include <stdio.h>
#include <string.h>

const struct hobe_kernel *hobe_find_kernel(const char *name, struct hobe_error *err)
{
    char known[700] = "";
    size_t used = 0;
    for (int i = 0; hobe_kernels()[i]; i++) {
        if (strcmp(hobe_kernels()[i]->name, name) == 0)
            return hobe_kernels()[i];
        if (used < sizeof known)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", i ? ", " : "",
                                     hobe_kernels()[i]->name);
    }
    hobe_fail(err, HOBE_UNKNOWN, NULL, "unknown element \"%s\"; known are %s", name, known);
    return NULL;
}

int hobe_kernel_step(const struct hobe_kernel *kernel)
{
    int v = 0;
    while (kernel->vector[v].node < kernel->nodes - 1)
        v++;
    return v;
}

int hobe_kernel_vector(const struct hobe_kernel *kernel, int node, int mode, int slope)
{
    for (int v = 0; v < kernel->vectors; v++) {
        const struct hobe_vector *is = kernel->vector + v;
        if (is->node == node && is->mode == mode && is->slope == slope)
            return v;
    }
    return -1;
}

void hobe_kernel_reference(const struct hobe_kernel *k, double length, const double frame[3][3],
                           double *q0)
{
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *is = k->vector + v;
        const double x = k->node[is->node] * length;
        for (int a = 0; a < 3; a++) {
            double value = 0; /* modes beyond 1, y, z vanish at rest */
            if (is->mode == 0)
                value = (is->slope ? 1 : x) * frame[0][a];
            else if (is->mode <= 2 && !is->slope)
                value = frame[is->mode][a];
            q0[3 * v + a] = value;
        }
    }
}

void hobe_kernel_axes(const struct hobe_kernel *k, const double *N, const double *Nx,
                      const double *q0, double axes[3][3])
{
    double d[2][3] = {{0}}; /* d_0', d_y */
    for (int v = 0; v < k->vectors; v++) {
        const int mode = k->vector[v].mode;
        for (int a = 0; mode < 2 && a < 3; a++)
            d[mode][a] += (mode ? N : Nx)[v] * q0[3 * v + a];
    }
    const double length = length3(d[0]), along = dot3(d[0], d[1]) / (length * length);
    for (int a = 0; a < 3; a++) {
        axes[0][a] = d[0][a] / length;
        axes[1][a] = d[1][a] - along * d[0][a];
    }
    const double across = length3(axes[1]);
    for (int a = 0; a < 3; a++)
        axes[1][a] /= across;
    cross3(axes[0], axes[1], axes[2]);
}
