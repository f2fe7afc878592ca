/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rod.h"

#include "vector3.h"

/* Of Simpson's rule: its error is of the order (turn / PANELS)^4/180, 1e-12 for a few turns. */
enum { PANELS = 2000 };

/* strain += sum_b e_b (e_b . load)/stiffness_b */
static void add_strain(const double frame[3][3], const double stiffness[3], const double load[3],
                       double strain[3])
{
    for (int b = 0; b < 3; b++) {
        const double along = dot3(frame[b], load) / stiffness[b];
        for (int a = 0; a < 3; a++)
            strain[a] += along * frame[b][a];
    }
}

void rod_add(const struct rod *rod, const double end[3], const double F[3], const double M[3],
             struct rod_tip *tip)
{
    for (int i = 0; i <= 2 * PANELS; i++) {
        const double weight = (i % (2 * PANELS) == 0 ? 1 : i % 2 ? 4 : 2) / (6. * PANELS);
        double arm[3], moment[3], stretch[3] = {0}, bend[3] = {0}, swing[3];
        struct rod_place p;
        rod->at(rod->context, i / (2. * PANELS), &p);
        for (int a = 0; a < 3; a++)
            arm[a] = end[a] - p.r[a];
        cross3(arm, F, moment);
        for (int a = 0; a < 3; a++)
            moment[a] += M[a];
        add_strain((const double(*)[3])p.frame, p.force, F, stretch);
        add_strain((const double(*)[3])p.frame, p.moment, moment, bend);
        cross3(bend, arm, swing);
        for (int a = 0; a < 3; a++) {
            tip->u[a] += weight * rod->length * (stretch[a] + swing[a]);
            tip->rotation[a] += weight * rod->length * bend[a];
        }
    }
}
