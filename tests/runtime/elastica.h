/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plane inextensible cantilever of length 1 and bending stiffness 1 under a tip force alpha
 * normal to its axis at rest: Euler's elastica, by integration from the tip. */
#ifndef HOBE_TEST_ELASTICA_H
#define HOBE_TEST_ELASTICA_H

struct elastica {
    double shortening, deflection; /* of the tip, along the axis and across */
    double angle;                  /* of the tip, rad */
};

/* The force keeps its direction, or turns with the tip. */
struct elastica elastica_dead(double alpha);
struct elastica elastica_follower(double alpha);

#endif
