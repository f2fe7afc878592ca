/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "smaller.h"

#include "kernel_vectors.h"
#include "section.h"

#include <math.h>
#include <string.h>

/* Both are written by one generator, from one set of conditions: what is one function differs by
 * rounding at most. */
static const double SAME = 1e-14;

/* The place of a mode in an element; -1 where it has none of that name. */
static int find_mode(const struct hobe_kernel *k, const char *name)
{
    for (int m = 0; m < k->modes; m++)
        if (!strcmp(k->mode[m], name))
            return m;
    return -1;
}

static int same_axis(const struct hobe_kernel *a, const struct hobe_kernel *b)
{
    if (a->nodes != b->nodes || a->stations != b->stations || !a->axis_rule != !b->axis_rule)
        return 0;
    return !memcmp(a->node, b->node, (size_t)a->nodes * sizeof *a->node) &&
           (!a->axis_rule ||
            !memcmp(a->axis_rule, b->axis_rule, (size_t)a->stations * sizeof *a->axis_rule));
}

/* The vector of the rich element that is vector v of the small one; -1: none. */
static int find_vector(const struct hobe_kernel *small, int v, const struct hobe_kernel *rich)
{
    const struct hobe_vector *is = small->vector + v;
    const int mode = find_mode(rich, small->mode[is->mode]);
    return mode < 0 ? -1 : hobe_kernel_vector(rich, is->node, mode, is->slope);
}

/* Whether the small one has every vector of its modes that the rich one has, and no other, with the
 * same functions: polynomials, which one place that is nothing special tells apart. */
static int same_vectors(const struct hobe_kernel *small, const struct hobe_kernel *rich)
{
    double N[2][HOBE_MAX_VECTORS], Nx[2][HOBE_MAX_VECTORS];
    int shared = 0;
    small->shape(0.3, 1, N[0], Nx[0]);
    rich->shape(0.3, 1, N[1], Nx[1]);
    for (int v = 0; v < small->vectors; v++) {
        const int w = find_vector(small, v, rich);
        if (w < 0 || fabs(N[0][v] - N[1][w]) > SAME || fabs(Nx[0][v] - Nx[1][w]) > 10 * SAME)
            return 0;
    }
    for (int w = 0; w < rich->vectors; w++)
        shared += find_mode(small, rich->mode[rich->vector[w].mode]) >= 0;
    return shared == small->vectors;
}

int kernel_within(const struct hobe_kernel *small, const struct hobe_kernel *rich)
{
    return small->vectors < rich->vectors && !small->section == !rich->section &&
           small->degree == rich->degree && same_axis(small, rich) && same_vectors(small, rich);
}

static int keeps_all(const struct hobe_kernel *small, const struct hobe_kernel *rich,
                     const unsigned char *dropped)
{
    for (int m = 0; m < rich->modes; m++)
        if (!dropped[m] && find_mode(small, rich->mode[m]) < 0)
            return 0;
    return 1;
}

/* Whether the section's points and weights are the same for both: of functions they may be more. */
static enum hobe_status compare_rules(const struct hobe_beam *beam, double length,
                                      const struct hobe_kernel *small, int *same,
                                      struct hobe_error *err)
{
    const struct hobe_section_place middle = {0.5, length};
    struct hobe_rule a, b = {0};
    enum hobe_status status =
        hobe_section_rule(beam->section, small, beam->integration, &middle, &a, err);
    if (!status)
        status =
            hobe_section_rule(beam->section, beam->kernel, beam->integration, &middle, &b, err);
    *same = !status && a.rule.points == b.rule.points;
    for (int i = 0; *same && i < a.rule.points; i++)
        *same = a.point[i].y == b.point[i].y && a.point[i].z == b.point[i].z &&
                a.point[i].weight == b.point[i].weight && a.point[i].region == b.point[i].region;
    hobe_rule_free(&a);
    hobe_rule_free(&b);
    return status;
}

const struct hobe_kernel *kernel_left(const struct hobe_beam *beam, double length,
                                      const unsigned char *dropped, struct hobe_error *err)
{
    const struct hobe_kernel *left = beam->kernel;
    for (int i = 0; hobe_kernels()[i]; i++) {
        const struct hobe_kernel *k = hobe_kernels()[i];
        int same;
        if (k->vectors >= left->vectors || !kernel_within(k, beam->kernel) ||
            !keeps_all(k, beam->kernel, dropped))
            continue;
        if (compare_rules(beam, length, k, &same, err))
            return NULL;
        if (same)
            left = k;
    }
    return left;
}
