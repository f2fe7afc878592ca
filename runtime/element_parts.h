/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An element's insides, for the rooms that make it (element*.c). */
#ifndef HOBE_ELEMENT_PARTS_H
#define HOBE_ELEMENT_PARTS_H

#include "hobe.h"
#include "points.h"

/* The laws of the section's regions, or of the beam's material where it has none of its own. */
struct laws {
    struct hobe_elasticity region[HOBE_MAX_REGIONS];
    double density[HOBE_MAX_REGIONS];
    struct hobe_law law;
    /* of the section where it does not vary; G of its first region */
    double EA, EIyy, EIzz, EIyz, G;
};

/* Ways to force and tangent; CHEAPEST is one of the two behind it. */
enum plan { CHEAPEST, SECTION, TENSOR, POINTS, PLANS };

struct hobe_element {
    const struct hobe_kernel *kernel;
    const hobe_section *section;
    enum hobe_mechanics mechanics;
    struct laws laws;
    struct hobe_invariants invariants;
    double *numbers; /* all arrays of the invariants but the tensor, and q0, in one block */
    double *q0; /* [V][3] where curved, pretwisted or tapered, NULL where straight, prismatic */
    struct hobe_rest rest;
    unsigned char dropped[HOBE_MAX_MODES];

    /* The plan: of force alone and of force and tangent. */
    int by_tensor[2];
    struct hobe_invariants whole; /* with a tensor; where no task takes it, tensor = NULL */
    struct points points;         /* vectors = 0: force and tangent are the kernel's own */
};

/* The laws of an element whose section has that rule; they point into *laws, which must stay where
 * it is. */
void element_set_laws(struct laws *laws, const struct hobe_element_options *options,
                      enum hobe_mechanics mechanics, const struct hobe_section_rule *rule);

/* Fills element->invariants, laws and numbers, and q0 where the element varies; with `plan` POINTS
 * its points, too. */
enum hobe_status element_integrate(hobe_element *element,
                                   const struct hobe_element_options *options, enum plan plan,
                                   struct hobe_error *err);

/* Fills the arrays of the kernel's plan "section", inv->section, to be freed by the caller. */
enum hobe_status element_fill_section(const struct hobe_kernel *kernel, struct hobe_invariants *inv,
                                      struct hobe_error *err);

/* Marks in element->dropped the modes beyond 1, y, z that vanish on the section or depend on
 * earlier ones. */
enum hobe_status element_find_dropped(hobe_element *element,
                                      const struct hobe_element_options *options,
                                      struct hobe_error *err);

/* The plan that HOBE_PLAN in the environment asks for, wherever it can be. */
enum hobe_status element_asked_plan(enum plan *plan, struct hobe_error *err);

/* Gives a straight and prismatic element its tensor for the tasks where that is the way to take. */
enum hobe_status element_choose_plan(hobe_element *element, enum plan plan, struct hobe_error *err);

/* K[3 V][3 V], the tangent at the reference, and what hobe_element_stiffness makes of it. */
enum hobe_status element_tangent_at_rest(const hobe_element *element, double *K,
                                         struct hobe_error *err);
enum hobe_status element_stiffness(const hobe_element *element, const double *K,
                                   double C[HOBE_STRAINS][HOBE_STRAINS], struct hobe_error *err);

/* Fills element->rest; HOBE_UNSTABLE where the stiffness at rest has negative eigenvalues. */
enum hobe_status element_check_rest(hobe_element *element, struct hobe_error *err);

#endif
