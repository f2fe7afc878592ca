/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench_subject.h"

#include "element.h"
#include "model.h"

#include <math.h>

/* Sizes that make numbers of all modes alike; times do not depend on them. */
static const double WIDTH = 1, HEIGHT = 1.5, LENGTH = 2, RADIUS = 20, STRAIN = 1e-2;
static const struct hobe_material material = {210e9, 0.3, 7850, 1, 1, 0};

/* ---- section classes ------------------------------------------------------------------------ */

static hobe_section *rectangle(struct hobe_error *err)
{
    return hobe_section_rectangle(WIDTH, HEIGHT, HOBE_WARPING_SERIES, err);
}

static hobe_section *angle(struct hobe_error *err)
{
    const struct hobe_profile_sizes sizes = {HEIGHT, WIDTH, 0.2, 0.3, 0, 0};
    return hobe_section_profile(HOBE_PROFILE_ANGLE, &sizes, HOBE_WARPING_SOLVED, err);
}

static hobe_section *taper(struct hobe_error *err)
{
    hobe_section *from = rectangle(err), *to = NULL, *section = NULL;
    if (from)
        to = hobe_section_rectangle(WIDTH / 2, HEIGHT / 2, HOBE_WARPING_SERIES, err);
    if (to)
        section = hobe_section_linear(from, to, err);
    hobe_section_free(from);
    hobe_section_free(to);
    return section;
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    const double angle_of = HOBE_LANES * LENGTH / RADIUS * t;
    (void)context;
    (void)err;
    r[0] = RADIUS * sin(angle_of);
    r[1] = RADIUS * (1 - cos(angle_of));
    r[2] = 0;
    return HOBE_OK;
}

const struct bench_class bench_classes[BENCH_CLASSES] = {
    {"rectangle", rectangle, 0},
    {"angle", angle, 0},
    {"arc", rectangle, 1},
    {"taper", taper, 0},
};

/* ---- a batch -------------------------------------------------------------------------------- */

/* The same numbers in every run, in [-1/2, 1/2). */
static double chance(unsigned long *state)
{
    *state = *state * 6364136223846793005UL + 1442695040888963407UL;
    return (double)(*state >> 11) * 0x1p-53 - 0.5;
}

/* A strained state, and room for the results. */
static enum hobe_status set_state(struct bench_subject *s, struct hobe_error *err)
{
    const size_t dofs = 3 * (size_t)s->kernel->vectors, K = dofs * (dofs + 3) / 2;
    unsigned long state = 1;
    s->u = hobe_alloc(3 * dofs + K + hobe_element_scratch(s->kernel), sizeof *s->u, err);
    if (!s->u)
        return HOBE_NO_MEMORY;
    s->q = s->u + dofs;
    s->f = s->q + dofs;
    s->K = s->f + dofs;
    s->scratch = s->K + K;
    for (size_t i = 0; i < dofs; i++) {
        for (int lane = 0; lane < HOBE_LANES; lane++)
            s->u[i][lane] = STRAIN * chance(&state);
        s->q[i] = s->q0[i] + s->u[i];
    }
    return HOBE_OK;
}

static struct bench_plan *add_plan(struct bench_subject *s, const char *name, int tensor,
                                   const hobe_element *element)
{
    struct bench_plan *plan = s->plan + s->plans++;
    *plan = (struct bench_plan){.name = name, .inv = *hobe_element_invariants(element)};
    for (int t = 0; t < 2; t++)
        plan->taken[t] = hobe_element_by_tensor(element, t) == tensor;
    return plan;
}

/* From station to station.  The generator counts flops for straight, prismatic elements. */
static void add_section_plan(struct bench_subject *s, const hobe_element *element)
{
    const struct hobe_kernel *k = s->kernel;
    struct bench_plan *plan = add_plan(s, "section", 0, element);
    if (plan->inv.stations != k->stations)
        return;
    const struct hobe_plan_cost *cost = k->section ? k->section_cost + plan->inv.symmetry : NULL;
    plan->flops[0] = (double)(cost ? cost->flops_force : k->flops_force);
    plan->flops[1] = (double)(cost ? cost->flops_tangent : k->flops_tangent);
}

/* By products with a tensor, which the element may not have. */
static enum hobe_status add_tensor_plan(struct bench_subject *s, const hobe_element *element,
                                        struct hobe_error *err)
{
    const struct hobe_kernel *k = s->kernel;
    struct bench_plan *plan = add_plan(s, "tensor", 1, element);
    const struct hobe_plan_cost *size = k->tensor_cost + plan->inv.symmetry;
    plan->flops[0] = (double)size->flops_force;
    plan->flops[1] = (double)size->flops_tangent;
    plan->inv.tensor = s->tensor = hobe_alloc(size->numbers, sizeof(double), err);
    if (!s->tensor)
        return HOBE_NO_MEMORY;
    k->tensor(&plan->inv);
    return HOBE_OK;
}

/* All plans that there are for an element. */
static enum hobe_status set_plans(struct bench_subject *s, const hobe_element *element,
                                  struct hobe_error *err)
{
    add_section_plan(s, element);
    return s->kernel->tensor && !hobe_element_invariants(element)->Qc
               ? add_tensor_plan(s, element, err)
               : HOBE_OK;
}

static enum hobe_status set_model(struct bench_subject *s, struct hobe_error *err)
{
    const struct hobe_beam beam = {.name = s->kernel->name,
                                   .kernel = s->kernel,
                                   .elements = HOBE_LANES,
                                   .section = s->section,
                                   .material = material,
                                   .to = {HOBE_LANES * LENGTH, 0, 0},
                                   .curve = s->curve};
    s->model = hobe_model_new(err);
    enum hobe_status status = s->model ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        status = hobe_model_beam(s->model, &beam, err);
    if (!status)
        status = hobe_model_clamp(s->model, &(struct hobe_clamp){.beam = beam.name}, err);
    if (!status)
        status = hobe_model_build(s->model, err);
    if (!status) {
        const struct batch *batch = model_beam(s->model, 0)->batch;
        status = set_plans(s, batch->law, err);
        s->count = batch->count;
        s->q0 = batch->q0;
    }
    return status;
}

enum hobe_status bench_subject_open(struct bench_subject *s, const struct hobe_kernel *kernel,
                                    const struct bench_class *class, struct hobe_error *err)
{
    *s = (struct bench_subject){.kernel = kernel, .section = class->make(err)};
    if (s->section && class->curved)
        s->curve = hobe_curve_function(arc, NULL, err);
    if (!s->section || (class->curved && !s->curve))
        return err->status;
    const enum hobe_status status = set_model(s, err);
    return status ? status : set_state(s, err);
}

enum hobe_status bench_subject_full(struct bench_subject *s, const struct hobe_kernel *kernel,
                                    const hobe_section *section, struct hobe_error *err)
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const struct hobe_element_options options = {.kernel = kernel,
                                                 .section = section,
                                                 .material = material,
                                                 .length = LENGTH,
                                                 .mechanics = HOBE_MECHANICS_FULL};
    const size_t dofs = 3 * (size_t)kernel->vectors;
    *s = (struct bench_subject){.kernel = kernel, .count = HOBE_LANES};
    s->element = hobe_element_new(&options, err);
    if (!s->element)
        return err->status;
    s->own_q0 = hobe_alloc(dofs, sizeof *s->own_q0, err);
    double *q0 = hobe_alloc(dofs, sizeof *q0, err);
    if (s->own_q0 && q0) {
        hobe_element_reference(s->element, axes, q0);
        for (size_t i = 0; i < dofs; i++)
            s->own_q0[i] = q0[i] + (hobe_lanes){0};
    }
    hobe_free(q0);
    s->q0 = s->own_q0;
    enum hobe_status status = s->own_q0 && q0 ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        status = set_plans(s, s->element, err);
    return status ? status : set_state(s, err);
}

void bench_subject_close(struct bench_subject *s)
{
    hobe_free(s->u);
    hobe_free(s->own_q0);
    hobe_free(s->tensor);
    hobe_element_free(s->element);
    hobe_model_free(s->model);
    hobe_curve_free(s->curve);
    hobe_section_free(s->section);
}
