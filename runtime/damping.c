/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "damping.h"

#include "assemble.h"
#include "mass.h"
#include "reduction.h"
#include "spring.h"

#include <math.h>

void damping_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double *f, const struct matrix *K)
{
    if (!instant->v)
        return;
    if (model->reduction) {
        reduction_damping(model, instant, f, K);
        return;
    }
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const double alpha = beam->spec.damping.mass;
        if (alpha == 0)
            continue;
        mass_force_of(model, beam, alpha, instant->v, f);
        if (K)
            mass_matrix_of(model, beam, instant->rate * alpha, K);
    }
    assemble_viscous(model, u, instant, f, K);
}

double damping_power(const struct hobe_model *model, const double *u, const double *v)
{
    double power = spring_power(model, u, v);
    if (model->reduction)
        return power + reduction_damping_power(model, v);
    power += assemble_viscous_power(model, u, v);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        if (beam->spec.damping.mass > 0)
            power += beam->spec.damping.mass * mass_product_of(model, beam, v, v);
    }
    return power;
}

enum hobe_status damping_check(const struct hobe_beam *spec, struct hobe_error *err)
{
    const double value[2] = {spec->damping.mass, spec->damping.stiffness};
    static const char *const name[2] = {"mass", "stiffness"}, *const unit[2] = {"1/s", "s"};
    for (int i = 0; i < 2; i++)
        if (!(value[i] >= 0 && isfinite(value[i])))
            return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                             "damping.%s of beam \"%s\" must be >= 0 (%s), got %g", name[i],
                             spec->name, unit[i], value[i]);
    if (value[1] > 0 && !spec->kernel->trilinear)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "beam \"%s\" cannot have damping.stiffness: element %s has a structural "
                         "law, and no viscous stress; use damping.mass, or another element",
                         spec->name, spec->kernel->name);
    return HOBE_OK;
}
