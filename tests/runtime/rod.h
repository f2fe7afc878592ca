/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rods by the linear theory of Bernoulli, Saint-Venant and Timoshenko: what a statically
 * determinate one does under loads at its end, by quadrature along its axis (Castigliano). */
#ifndef HOBE_TEST_ROD_H
#define HOBE_TEST_ROD_H

/* A place of the axis: position, m; the section's axes, rows; and its stiffnesses on them, N and
 * N m^2: EA, GA along y, GA along z; GJ, EI about y, EI about z. */
struct rod_place {
    double r[3], frame[3][3], force[3], moment[3];
};

struct rod {
    void (*at)(const void *context, double t,
               struct rod_place *place); /* t in [0,1] of the length */
    const void *context;
    double length; /* m */
};

/* Displacement u, m, and rotation, rad, in global axes. */
struct rod_tip {
    double u[3], rotation[3];
};

/* Adds to the motion of the point `end` what the strains of the rod give under the force F and the
 * moment M there.  Pieces in a row add up. */
void rod_add(const struct rod *rod, const double end[3], const double F[3], const double M[3],
             struct rod_tip *tip);

#endif
