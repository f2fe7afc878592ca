/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether an element is stable at rest, and what it makes of its section's stiffness. */
#include "eigen.h"
#include "element_parts.h"

#include <math.h>
#include <string.h>

/* Eigenvalues of the scaled stiffness at rest, relative to the largest: rigid motions come out
 * below 1e-14, the softest deformation of an element 20 heights long above 1e-9. */
static const double ZERO_EIGENVALUE = 1e-12;

enum hobe_status element_tangent_at_rest(const hobe_element *element, double *K,
                                         struct hobe_error *err)
{
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const size_t n = 3 * (size_t)element->kernel->vectors;
    double *q = hobe_alloc(n, sizeof *q, err);
    if (!q)
        return HOBE_NO_MEMORY;
    if (element->q0)
        memcpy(q, element->q0, n * sizeof *q);
    else
        hobe_element_reference(element, identity, q);
    const enum hobe_status status = hobe_element_tangent(element, q, q, K, err);
    hobe_free(q);
    return status;
}

/* Eigenvalues of D K D, D = diag(K)^(-1/2), dropped modes left out; K is lost. */
static enum hobe_status rest_eigenvalues(const hobe_element *element, double *K, int *count,
                                         double *eigenvalue, struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    const int n = 3 * k->vectors;
    double *scale = eigenvalue; /* not needed at the same time */
    int kept = 0;
    for (int i = 0; i < n; i++) /* rows and columns of the modes that take part, in place */
        if (!element->dropped[k->vector[i / 3].mode]) {
            int column = 0;
            for (int j = 0; j < n; j++)
                if (!element->dropped[k->vector[j / 3].mode])
                    K[kept * n + column++] = K[i * n + j];
            kept++;
        }
    for (int i = 0; i < kept; i++)
        scale[i] = K[i * n + i] != 0 ? 1 / sqrt(fabs(K[i * n + i])) : 1;
    for (int i = 0; i < kept; i++)
        for (int j = 0; j < kept; j++)
            K[i * kept + j] = scale[i] * K[i * n + j] * scale[j];
    *count = kept;
    return hobe_eigenvalues(kept, K, eigenvalue, err);
}

/* K is lost. */
static enum hobe_status check_eigenvalues(hobe_element *element, double *K, struct hobe_error *err)
{
    const int n = 3 * element->kernel->vectors;
    struct hobe_rest *rest = &element->rest;
    int count = 0;
    double *eigenvalue = hobe_alloc((size_t)n, sizeof *eigenvalue, err);
    if (!eigenvalue)
        return HOBE_NO_MEMORY;
    enum hobe_status status = rest_eigenvalues(element, K, &count, eigenvalue, err);
    if (!status) {
        const double largest = fmax(eigenvalue[count - 1], -eigenvalue[0]);
        rest->largest = eigenvalue[count - 1];
        rest->smallest = largest;
        for (int i = 0; i < count; i++) {
            const double e = eigenvalue[i];
            if (fabs(e) <= ZERO_EIGENVALUE * largest)
                rest->zero++;
            else if (e < 0)
                rest->negative++;
            else
                rest->positive++;
            if (fabs(e) > ZERO_EIGENVALUE * largest && fabs(e) < fabs(rest->smallest))
                rest->smallest = e;
        }
        if (rest->negative)
            status = hobe_fail(
                err, HOBE_UNSTABLE, NULL,
                "element %s with mechanics \"%s\" is unstable at rest on this section: its "
                "stiffness has %d negative eigenvalue%s beside %d zero and %d positive ones; use "
                "mechanics = \"average\"",
                element->kernel->name, hobe_mechanics_name(element->mechanics), rest->negative,
                rest->negative > 1 ? "s" : "", rest->zero, rest->positive);
    }
    hobe_free(eigenvalue);
    return status;
}

/* What the element makes of the section's EA, EI and GJ: it should be all of it. */
static enum hobe_status compare_stiffness(hobe_element *element, const double *K,
                                          const struct hobe_section_properties *p,
                                          struct hobe_error *err)
{
    const struct laws *laws = &element->laws;
    const double section[HOBE_STRAINS] = {laws->EA, laws->EIyy, laws->EIzz, laws->G * p->J};
    double C[HOBE_STRAINS][HOBE_STRAINS];
    const enum hobe_status status = element_stiffness(element, K, C, err);
    for (int i = 0; !status && i < HOBE_STRAINS; i++)
        element->rest.share[i] = C[i][i] / section[i];
    return status;
}

/* Both, by one tangent; curved and tapered elements have no such stiffness. */
static enum hobe_status check(hobe_element *element, const struct hobe_section_properties *p,
                              struct hobe_error *err)
{
    const size_t n = 3 * (size_t)element->kernel->vectors;
    double *K = hobe_alloc(n * n, sizeof *K, err);
    if (!K)
        return HOBE_NO_MEMORY;
    enum hobe_status status = element_tangent_at_rest(element, K, err);
    if (!status && !element->q0)
        status = compare_stiffness(element, K, p, err);
    if (!status)
        status = check_eigenvalues(element, K, err);
    hobe_free(K);
    return status;
}

/* The check depends on the element's proportions alone, and the softest modes of a long element
 * drown in round-off, so that a straight and prismatic one is checked at most 20 heights long: the
 * same section law with its axial part done again. */
enum hobe_status element_check_rest(hobe_element *element, struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    struct hobe_section_properties p;
    hobe_section_properties(element->section, &p);
    const double longest = 20 * fmax(p.width, p.height),
                 scale = longest / element->invariants.length;
    if (element->q0 || scale >= 1)
        return check(element, &p, err);
    hobe_element shorter = *element;
    shorter.points.vectors = 0; /* which are the longer one's */
    struct hobe_invariants *inv = &shorter.invariants;
    const size_t G = (size_t)inv->stations, V = (size_t)k->vectors;
    double *axis = hobe_alloc(G + 2 * G * V, sizeof *axis, err);
    if (!axis)
        return HOBE_NO_MEMORY;
    inv->length = longest;
    inv->wx = axis;
    inv->N = axis + G;
    inv->Nx = inv->N + G * V;
    for (size_t g = 0; g < G; g++) {
        inv->wx[g] = element->invariants.wx[g] * scale;
        k->shape(inv->xi[g], longest, inv->N + V * g, inv->Nx + V * g);
    }
    enum hobe_status status = k->section ? element_fill_section(k, inv, err) : HOBE_OK;
    if (!status)
        status = check(&shorter, &p, err);
    element->rest = shorter.rest;
    if (k->section)
        hobe_free(inv->section);
    hobe_free(axis);
    return status;
}
