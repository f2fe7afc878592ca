/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ways to force and tangent: which an element takes, and a batch by it. */
#include "element.h"
#include "element_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum hobe_status element_asked_plan(enum plan *plan, struct hobe_error *err)
{
    static const char *const name[PLANS] = {"", "section", "tensor", "points"};
    const char *asked = getenv("HOBE_PLAN");
    *plan = CHEAPEST;
    while (asked && *plan < PLANS && strcmp(asked, name[*plan]))
        ++*plan;
    if (*plan < PLANS)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "HOBE_PLAN in the environment is \"%s\"; it must be \"section\", "
                     "\"tensor\" or \"points\", or unset for what is cheapest",
                     asked);
}

double hobe_tensor_speed(const struct hobe_kernel *kernel, int symmetry, int tangent)
{
    static const double cached[2] = {1.5, 1.8}, streamed[2] = {0.7, 1};
    const size_t cache = 2 << 20;
    const size_t size = kernel->tensor_cost[symmetry].numbers * sizeof(double);
    return (size > cache ? streamed : cached)[tangent];
}

/* How many times as fast as from station to station. */
static double tensor_gain(const struct hobe_kernel *kernel, int symmetry, int tangent)
{
    const struct hobe_plan_cost *tensor = kernel->tensor_cost + symmetry,
                                *section = kernel->section_cost + symmetry;
    const double ratio = tangent ? (double)section->flops_tangent / (double)tensor->flops_tangent
                                 : (double)section->flops_force / (double)tensor->flops_force;
    return hobe_tensor_speed(kernel, symmetry, tangent) * ratio;
}

int hobe_tensor_pays(const struct hobe_kernel *kernel, int symmetry, int tangent)
{
    if (!kernel->tensor || !(symmetry & HOBE_SYMMETRIC_X))
        return 0;
    const double force = tensor_gain(kernel, symmetry, 0), both = tensor_gain(kernel, symmetry, 1);
    return fmax(force, both) > HOBE_TENSOR_WORTH && (tangent ? both : force) > 1;
}

enum hobe_status element_choose_plan(hobe_element *element, enum plan plan, struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    const struct hobe_invariants *inv = &element->invariants;
    const int possible = k->tensor && inv->symmetry & HOBE_SYMMETRIC_X && !element->q0;
    for (int t = 0; possible && t < 2; t++)
        element->by_tensor[t] =
            plan == CHEAPEST ? hobe_tensor_pays(k, inv->symmetry, t) : plan == TENSOR;
    if (!element->by_tensor[0] && !element->by_tensor[1])
        return HOBE_OK;
    struct hobe_invariants *whole = &element->whole;
    *whole = *inv;
    whole->tensor = hobe_alloc(k->tensor_cost[inv->symmetry].numbers, sizeof *whole->tensor, err);
    if (!whole->tensor)
        return HOBE_NO_MEMORY;
    k->tensor(whole);
    return HOBE_OK;
}

int hobe_element_by_tensor(const hobe_element *element, int tangent)
{
    return element->by_tensor[tangent];
}

static const struct hobe_invariants *of_task(const hobe_element *element, int tangent)
{
    return element->by_tensor[tangent] ? &element->whole : &element->invariants;
}

void hobe_element_batch_force(const hobe_element *element, const hobe_lanes *q0,
                              const hobe_lanes *u, hobe_lanes *f, hobe_lanes *scratch)
{
    if (element->points.vectors)
        points_evaluate()(&element->points, q0, u, f, NULL, scratch);
    else
        element->kernel->force(of_task(element, 0), q0, u, f, scratch);
}

void hobe_element_batch_tangent(const hobe_element *element, const hobe_lanes *q0,
                                const hobe_lanes *u, hobe_lanes *f, hobe_lanes *K,
                                hobe_lanes *scratch)
{
    if (element->points.vectors)
        points_evaluate()(&element->points, q0, u, f, K, scratch);
    else
        element->kernel->tangent(of_task(element, 1), q0, u, f, K, scratch);
}

size_t hobe_element_scratch(const struct hobe_kernel *kernel)
{
    const size_t points = POINTS_SCRATCH * (size_t)kernel->vectors;
    return kernel->scratch > points ? kernel->scratch : points;
}
