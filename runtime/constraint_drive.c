/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Constraints at an instant: what drives add to them. */
#include "constraint_parts.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* s[3] = value and two derivatives of a drive at an instant, zero without one. */
static enum hobe_status drive_at(hobe_drive *drive, const struct instant *instant, double s[3],
                                 struct hobe_error *err)
{
    memset(s, 0, sizeof(double[3]));
    const int moves = drive && instant->held_back < 1;
    const enum hobe_status status = moves ? hobe_drive_at(drive, instant->time, s, err) : HOBE_OK;
    for (int p = 0; p < 3; p++)
        s[p] *= 1 - instant->held_back;
    return status;
}

/* turned = (alpha [e]x + beta [e]x^2) turn */
static void turn_columns(const double e[3], double alpha, double beta, const double turn[3][3],
                         double turned[3][3])
{
    for (int j = 0; j < 3; j++) {
        const double column[3] = {turn[0][j], turn[1][j], turn[2][j]};
        double once[3], twice[3];
        cross3(e, column, once);
        cross3(e, once, twice);
        for (int i = 0; i < 3; i++)
            turned[i][j] = alpha * once[i] + beta * twice[i];
    }
}

/* Adds to c, the p-th derivative by time of a constraint, what the rotation R = 1 + sin(theta) [e]x
 * + (1 - cos(theta)) [e]x^2 has beside 1, alpha and beta those of sine and 1 - cosine, and the way.
 */
static void drive_constraint(const struct tie *tie, const struct constraint *is, int p,
                             double alpha, double beta, double way, struct constraint *c)
{
    double turned[3][3];
    turn_columns(tie->axis, alpha, beta, is->turn, turned);
    c->offset -= is->driven ? way : 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            c->turn[i][j] += turned[i][j];
            if (p == 0) /* as constraint_value takes D_a0' D_b0 from D_a' D_b */
                c->offset += turned[i][j] * dot3(tie->side[0].D0[i], tie->side[1].D0[j]);
        }
}

enum hobe_status constraint_at(const struct tie *tie, const struct instant *instant,
                               struct constraint c[ORDERS][TIE_CONSTRAINTS], struct hobe_error *err)
{
    double a[ORDERS], s[ORDERS];
    memcpy(c[0], tie->constraint, sizeof c[0]);
    memset(c + 1, 0, (ORDERS - 1) * sizeof *c);
    if (!tie->angle && !tie->position)
        return HOBE_OK;
    enum hobe_status status = drive_at(tie->angle, instant, a, err);
    if (!status)
        status = drive_at(tie->position, instant, s, err);
    if (status)
        return status;
    const double sine = sin(a[0]), cosine = cos(a[0]), half = sin(a[0] / 2);
    const double alpha[ORDERS] = {sine, a[1] * cosine, a[2] * cosine - a[1] * a[1] * sine};
    const double beta[ORDERS] = {2 * half * half, a[1] * sine, a[2] * sine + a[1] * a[1] * cosine};
    for (int k = 0; k < tie->constraints; k++) {
        const struct constraint *is = tie->constraint + k;
        const double way[ORDERS] = {s[0] + is->bend / 2 * s[0] * s[0],
                                    s[1] + is->bend * s[0] * s[1],
                                    s[2] + is->bend * (s[1] * s[1] + s[0] * s[2])};
        if (1 + is->bend * s[0] <= 0)
            return hobe_fail(err, HOBE_BAD_INPUT, tie->where,
                             "a distance of %g m cannot change by %g m, at t = %g s", 1 / is->bend,
                             s[0], instant->time);
        for (int p = 0; p < ORDERS; p++)
            drive_constraint(tie, is, p, alpha[p], beta[p], way[p], c[p] + k);
    }
    return HOBE_OK;
}

void constraint_now(const struct hobe_model *model, const struct tie *tie,
                    const struct instant *instant, struct constraint c[ORDERS][TIE_CONSTRAINTS])
{
    struct hobe_error err;
    if (!constraint_at(tie, instant, c, &err))
        return;
    model_fail(model, tie->where, &err);
    for (int p = 0; p < ORDERS; p++)
        for (int k = 0; k < tie->constraints; k++)
            c[p][k] = (struct constraint){.offset = NAN};
}
