/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights: of elements, bodies and masses under gravity. */
#include "body.h"
#include "drive.h"
#include "load_parts.h"
#include "mass.h"
#include "point_mass.h"
#include "reduction.h"
#include "vector3.h"

#include <string.h>

void load_changing_gravity(const struct hobe_model *model, const struct instant *instant,
                           double g[3])
{
    const struct gravity *gravity = model->gravities.item;
    memset(g, 0, sizeof(double[3]));
    for (size_t i = 0; i < model->gravities.count; i++, gravity++) {
        const double factor = drive_factor(model, gravity->history, instant->time, gravity->where);
        for (int a = 0; a < 3; a++)
            g[a] += factor * gravity->g[a];
    }
}

void load_add_weight(const struct hobe_model *model, const struct beam *beam, int e,
                     const double g[3], double factor, double *f)
{
    const struct hobe_kernel *k = beam->kernel;
    const double *mass = hobe_element_invariants(beam_law(beam, e))->mass;
    for (int v = 0; v < k->vectors; v++) {
        double m = 0;
        for (int w = 0; w < k->vectors; w++)
            if (k->vector[w].mode == 0 && !k->vector[w].slope)
                m += mass[v * k->vectors + w];
        double *to = f + 3 * model_vector(model, beam, e, v);
        for (int a = 0; a < 3; a++)
            to[a] += factor * m * g[a];
    }
}

void load_add_weights(const struct hobe_model *model, const double g[3], double factor, double *f)
{
    if (model->reduction) {
        reduction_weights(model, g, factor, f);
        return;
    }
    for (size_t i = 0; i < model->beams.count; i++)
        for (int e = 0; e < model_beam(model, i)->spec.elements; e++)
            load_add_weight(model, model_beam(model, i), e, g, factor, f);
    for (size_t i = 0; i < model->bodies.count; i++)
        for (int a = 0; a < 3; a++)
            f[3 * model_body(model, i)->first + a] +=
                factor * model_body(model, i)->spec.mass * g[a];
    for (size_t i = 0; i < model->masses.count; i++)
        point_mass_force(model, model_mass(model, i), factor, g, f);
}

enum hobe_status load_build_weights(struct hobe_model *model, struct hobe_error *err)
{
    if (length3(model->gravity) == 0 && model->gravities.count == 0)
        return HOBE_OK;
    const enum hobe_status status = mass_check(model, "gravity", model->gravity_where, err);
    if (!status)
        load_add_weights(model, model->gravity, 1, model->dead);
    return status;
}
