/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What models leave out, level by level and otherwise, and what they cost. */
#include "advise.h"

#include "kernel_vectors.h"

#include <string.h>

static const struct {
    const char *element, *effect;
} LEVELS[] = {
    {"MGD30", "bending, shear and stretch"},   {"MGD30w", "warping in torsion"},
    {"MGD30w3", "warping in shear"},           {"MGD30d", "distortion of the section"},
    {"MGD30d2", "distortion of second order"},
};
enum { KNOWN = sizeof LEVELS / sizeof *LEVELS };

int advise_levels(const struct hobe_kernel **level)
{
    int levels = 0;
    for (int i = 0; i < KNOWN; i++) {
        const struct hobe_kernel *kernel = hobe_find_kernel(LEVELS[i].element, NULL);
        if (kernel)
            level[levels++] = kernel;
    }
    return levels;
}

const char *advise_step(const struct hobe_kernel *kernel)
{
    for (int i = 0; i < KNOWN; i++)
        if (!strcmp(kernel->name, LEVELS[i].element))
            return LEVELS[i].effect;
    return kernel->name;
}

int advise_same_section(const struct hobe_kernel *a, const struct hobe_kernel *b)
{
    if (a->modes != b->modes || strcmp(a->mechanics, b->mechanics))
        return 0;
    for (int k = 0; k < a->modes; k++)
        if (strcmp(a->mode[k], b->mode[k]))
            return 0;
    return 1;
}

int advise_leave_out(enum advise_without without, struct hobe_material *material)
{
    static const double STIFF = 1000;
    if (without == ADVISE_COMPLETE || without == ADVISE_NO_INERTIA)
        return 1;
    if (material->k2 != 1 || material->k3 != 1)
        return 0;
    material->average_shear = without == ADVISE_NO_SHEAR;
    material->k2 = material->k3 = without == ADVISE_NO_SHEAR ? STIFF : 1 / (1 + material->nu);
    if (without == ADVISE_NO_POISSON)
        material->nu = 0; /* G = k E/2 is what it was */
    return 1;
}

/* Eliminating s unknowns of a front of w takes about s w^2. */
double advise_cost(const struct advise_model *model, int iterations)
{
    const struct hobe_kernel *kernel = model->kernel;
    const double front = 3 * kernel->vectors, step = 3 * hobe_kernel_step(kernel);
    return iterations * (double)model->elements *
           ((double)kernel->flops_tangent + step * front * front);
}
