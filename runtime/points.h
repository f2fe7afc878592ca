/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Force and tangent stiffness of an element by Gauss points through its volume, as textbooks have
 * it: strain, stress and B'CB at each.  No generator takes part, and no element is special: the
 * plan "points" is what the kernels' own plans are measured against, and one that HOBE_PLAN=points
 * takes in their place. */
#ifndef HOBE_POINTS_H
#define HOBE_POINTS_H

#include "hobe.h"

/* An element at its points: those of the section's rule at each station of the axis and, where its
 * law takes mean strains elsewhere, those of the rules of the mean. */
struct points {
    int vectors, stations;
    unsigned char *position; /* [vectors] whether it is a position of the centreline */
    int *first;              /* [stations + 1] the points of each station */
    double *weight;        /* [points] of the law at a point, m^3; 0: it is one of the mean alone */
    double *gradient;      /* [points][vectors][3] d(N_v phi_v)/dX on the section's axes, 1/m */
    unsigned char *region; /* [points] which of the laws acts there */
    struct hobe_elasticity law[HOBE_MAX_REGIONS];

    /* The law of the mean strain.  share = NULL: there is none. */
    double *share;  /* [points][2] in the mean of normal and of shear strains */
    double *volume; /* [stations] m^3 */
    struct hobe_elasticity mean;
    unsigned char *warps;        /* [vectors] of eta (struct hobe_law); NULL: left as it is */
    struct hobe_elasticity *sum; /* [stations] sum of weight * law, N m */
};

/* Tables of an element with the arguments of kernel->invariants, which has filled inv; its form is
 * the continuum's.  points_close frees them, even after a failure. */
enum hobe_status points_open(struct points *p, const struct hobe_kernel *kernel,
                             const struct hobe_invariants *inv, int sections,
                             const struct hobe_station *station, const struct hobe_law *law,
                             const double *q0, struct hobe_error *err);
void points_close(struct points *p);

/* Force and tangent of a batch as in kernel.h; K may be NULL.  q0 = NULL: u are positions, and the
 * strain is (F'F - 1)/2, which is cheaper and loses small strains to rounding.
 * scratch[POINTS_SCRATCH * vectors] */
typedef void points_function(const struct points *p, const hobe_lanes *q0, const hobe_lanes *u,
                             hobe_lanes *f, hobe_lanes *K, hobe_lanes *scratch);
enum { POINTS_SCRATCH = 93 };

/* The one compiled for the processor that the kernels in use are for. */
points_function *points_evaluate(void);

/* Flops of a call for each element by so many points, from positions and without a law of the mean
 * strain, counted in the source; and the Gauss points of the textbook, as many as the polynomials
 * among the element's modes ask for, on a rectangle: functions of a section want more. */
double points_flops(int vectors, int points, int tangent);
int points_of_rectangle(const struct hobe_kernel *kernel);

#endif
