/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress at many points of one section.  The public part is in hobe.h. */
#ifndef HOBE_STRESS_H
#define HOBE_STRESS_H

#include "around.h"

/* A section of a beam in a state, and what the stress at all its points has in common. */
struct stress_section {
    struct around around;
    const struct hobe_law *law;
    double mean[6]; /* C_mean : mean(eps), the stress of the law on the mean strain, Pa */
    double energy;  /* of that law, spread over the section, J/m^3 */
    double eta[6];  /* mean strain of warping in the plane, where the law takes it at its mean */
    /* The mean of E over E_1, and of G over G_1: the stress of the mean law at a point goes with
     * E/E_1 over the one, and G/G_1 over the other.  0: it is the same everywhere. */
    double mean_E, mean_G;
    double axes[3][3]; /* the section's axes now, rows */
};

/* HOBE_BAD_INPUT where the element is structural, whose law knows no stress at a point. */
enum hobe_status stress_section(const hobe_solution *solution, const char *beam, double at,
                                struct stress_section *section, struct hobe_error *err);

/* The stress at (y, z), in a region of the section, which may be other than that found there: on
 * seams there are two. */
enum hobe_status stress_at(struct stress_section *section, double y, double z, int region,
                           struct hobe_stress *stress, struct hobe_error *err);

/* The same at a point of the section's rule for the element, which has the functions with it. */
void stress_at_point(struct stress_section *section, const struct hobe_section_point *point,
                     struct hobe_stress *stress);

#endif
