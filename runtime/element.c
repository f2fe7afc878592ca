/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "element.h"

#include "element_parts.h"
#include "kernel_vectors.h"
#include "material.h"
#include "section.h"

#include <math.h>
#include <string.h>

/* The structural form has one law and its own points on the axis. */
static enum hobe_status check_form(const struct hobe_element_options *options,
                                   struct hobe_error *err)
{
    const struct hobe_kernel *k = options->kernel;
    const enum hobe_mechanics own = hobe_mechanics_find(k->mechanics), asked = options->mechanics;
    const int structural = own == HOBE_MECHANICS_STRUCTURAL;
    if (asked && structural != (asked == HOBE_MECHANICS_STRUCTURAL))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "element %s does not take mechanics \"%s\"; leave it out for its own, "
                         "\"%s\"",
                         k->name, hobe_mechanics_name(asked), k->mechanics);
    if (structural && options->integration == HOBE_INTEGRATION_PAPER)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "element %s brings its own points on the axis and does not take "
                         "integration \"paper\"; leave it out",
                         k->name);
    return HOBE_OK;
}

hobe_element *hobe_element_new(const struct hobe_element_options *options, struct hobe_error *err)
{
    if (!(options->length > 0 && isfinite(options->length))) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "an element's length must be > 0 (m), got %g",
                  options->length);
        return NULL;
    }
    if (!hobe_section_material(options->section, 0) && hobe_material_check(&options->material, err))
        return NULL;
    if (check_form(options, err))
        return NULL;
    if (options->kernel->vectors > HOBE_MAX_VECTORS) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "element %s has %d vectors, at most %d are possible",
                  options->kernel->name, options->kernel->vectors, HOBE_MAX_VECTORS);
        return NULL;
    }
    enum plan plan;
    hobe_element *element =
        element_asked_plan(&plan, err) ? NULL : hobe_alloc(1, sizeof *element, err);
    if (!element)
        return NULL;
    element->kernel = options->kernel;
    element->section = options->section;
    element->mechanics =
        options->mechanics ? options->mechanics : hobe_mechanics_find(options->kernel->mechanics);
    if (element_integrate(element, options, plan, err) ||
        element_find_dropped(element, options, err) || element_check_rest(element, err) ||
        element_choose_plan(element, plan, err)) {
        hobe_element_free(element);
        return NULL;
    }
    return element;
}

void hobe_element_free(hobe_element *element)
{
    if (element) {
        hobe_free(element->numbers);
        hobe_free(element->invariants.section);
        hobe_free(element->whole.tensor);
        points_close(&element->points);
    }
    hobe_free(element);
}

const struct hobe_kernel *hobe_element_kernel(const hobe_element *element)
{
    return element->kernel;
}

const double *hobe_element_q0(const hobe_element *element)
{
    return element->q0;
}

const struct hobe_invariants *hobe_element_invariants(const hobe_element *element)
{
    return &element->invariants;
}

void hobe_element_stiffnesses(const hobe_element *element, struct stiffnesses *s)
{
    const struct laws *l = &element->laws;
    *s = (struct stiffnesses){l->EA, l->EIyy, l->EIzz, l->EIyz};
}

const struct hobe_law *hobe_element_law(const hobe_element *element)
{
    return &element->laws.law;
}

enum hobe_mechanics hobe_element_mechanics(const hobe_element *element)
{
    return element->mechanics;
}

void hobe_element_rest(const hobe_element *element, struct hobe_rest *rest)
{
    *rest = element->rest;
}

const unsigned char *hobe_element_dropped(const hobe_element *element)
{
    return element->dropped;
}

void hobe_element_reference(const hobe_element *element, const double frame[3][3], double *q0)
{
    hobe_kernel_reference(element->kernel, element->invariants.length, frame, q0);
}

/* One element in the first lane of a batch, the others at rest. */
struct single {
    hobe_lanes *q0, *u, *f, *K, *scratch;
};

static void single_free(struct single *s)
{
    hobe_free(s->q0);
}

static enum hobe_status single_new(const hobe_element *element, const double *q0, const double *q,
                                   struct single *s, struct hobe_error *err)
{
    const size_t V = (size_t)element->kernel->vectors, blocks = 9 * V * (V + 1) / 2;
    *s = (struct single){0};
    s->q0 =
        hobe_alloc(9 * V + blocks + hobe_element_scratch(element->kernel), sizeof(hobe_lanes), err);
    if (!s->q0)
        return HOBE_NO_MEMORY;
    s->u = s->q0 + 3 * V;
    s->f = s->u + 3 * V;
    s->K = s->f + 3 * V;
    s->scratch = s->K + blocks;
    for (size_t i = 0; i < 3 * V; i++) {
        for (int e = 0; e < HOBE_LANES; e++)
            s->q0[i][e] = q0[i];
        s->u[i][0] = q[i] - q0[i];
    }
    return HOBE_OK;
}

enum hobe_status hobe_element_energy(const hobe_element *element, const double *q0, const double *q,
                                     double *U, struct hobe_error *err)
{
    struct single s;
    if (single_new(element, q0, q, &s, err))
        return HOBE_NO_MEMORY;
    element->kernel->energy(&element->invariants, s.q0, s.u, s.f);
    *U = s.f[0][0];
    single_free(&s);
    return HOBE_OK;
}

enum hobe_status hobe_element_force(const hobe_element *element, const double *q0, const double *q,
                                    double *f, struct hobe_error *err)
{
    struct single s;
    if (single_new(element, q0, q, &s, err))
        return HOBE_NO_MEMORY;
    hobe_element_batch_force(element, s.q0, s.u, s.f, s.scratch);
    for (int i = 0; i < 3 * element->kernel->vectors; i++)
        f[i] = s.f[i][0];
    single_free(&s);
    return HOBE_OK;
}

enum hobe_status hobe_element_tangent(const hobe_element *element, const double *q0,
                                      const double *q, double *K, struct hobe_error *err)
{
    const int V = element->kernel->vectors, n = 3 * V;
    struct single s;
    if (single_new(element, q0, q, &s, err))
        return HOBE_NO_MEMORY;
    hobe_element_batch_tangent(element, s.q0, s.u, s.f, s.K, s.scratch);
    for (int v = 0; v < V; v++)
        for (int w = 0; w <= v; w++)
            for (int e = 0; e < 9; e++) {
                const int i = 3 * v + e / 3, j = 3 * w + e % 3;
                K[i * n + j] = K[j * n + i] = s.K[9 * hobe_pair(v, w) + e][0];
            }
    single_free(&s);
    return HOBE_OK;
}

void hobe_element_mass(const hobe_element *element, double *M)
{
    const int V = element->kernel->vectors, n = 3 * V;
    memset(M, 0, (size_t)(n * n) * sizeof *M);
    for (int v = 0; v < V; v++)
        for (int w = 0; w < V; w++)
            for (int a = 0; a < 3; a++)
                M[(3 * v + a) * n + 3 * w + a] = element->invariants.mass[v * V + w];
}
