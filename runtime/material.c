/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "material.h"

#include <math.h>
#include <string.h>

static const char *const names[] = {"default", "average", "axis", "full", "structural"};

const char *hobe_mechanics_name(enum hobe_mechanics mechanics)
{
    return names[mechanics];
}

enum hobe_mechanics hobe_mechanics_find(const char *name)
{
    for (int m = HOBE_MECHANICS_AVERAGE; m <= HOBE_MECHANICS_STRUCTURAL; m++)
        if (strcmp(names[m], name) == 0)
            return (enum hobe_mechanics)m;
    return HOBE_MECHANICS_DEFAULT;
}

enum hobe_status hobe_material_check(const struct hobe_material *m, struct hobe_error *err)
{
    if (!(m->E > 0 && isfinite(m->E)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "E must be > 0 (Pa), got %g", m->E);
    if (!(m->nu > -1 && m->nu < 0.5))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "nu must be greater than -1 and less than 0.5 (at 0.5 the material is "
                         "incompressible and Lame's constant infinite), got %g",
                         m->nu);
    if (!(m->rho >= 0 && isfinite(m->rho)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "rho must be >= 0 (kg/m^3), got %g", m->rho);
    if (!(m->k2 > 0 && isfinite(m->k2)) || !(m->k3 > 0 && isfinite(m->k3)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "shear correction factors k2, k3 must be > 0, got %g and %g", m->k2,
                         m->k3);
    return HOBE_OK;
}

void hobe_material_law(const struct hobe_material *m, enum hobe_mechanics mechanics,
                       struct hobe_elasticity *point, struct hobe_elasticity *mean)
{
    const double G = m->E / (2 * (1 + m->nu));
    const double lambda = m->E * m->nu / ((1 + m->nu) * (1 - 2 * m->nu));
    const int full = mechanics == HOBE_MECHANICS_FULL;
    const int split = !full && mechanics != HOBE_MECHANICS_STRUCTURAL;
    const double k[3] = {1, m->k2, m->k3};
    *point = *mean = (struct hobe_elasticity){0};
    for (int a = 0; a < 3; a++) {
        point->shear[a] = m->average_shear ? G : k[a] * G;
        mean->shear[a] = m->average_shear ? (k[a] - 1) * G : 0;
        for (int b = 0; b < 3; b++) {
            /* eqs. 19 and 20: E = E0 + Enu, lambda + 2G = E + 2 lambda nu on the diagonal */
            const double E0 = a == b ? m->E : 0;
            const double Enu = a == b ? 2 * lambda * m->nu : lambda;
            point->normal[a][b] = full ? E0 + Enu : E0;
            mean->normal[a][b] = split ? Enu : 0;
        }
    }
}
