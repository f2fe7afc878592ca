/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spring.h"

#include "joint.h"
#include "reduction.h"
#include "solution.h"
#include "vector3.h"

#include <stdio.h>
#include <string.h>

/* ---- what is asked for ----------------------------------------------------------------------- */

static int parts_of(const struct spring *spring)
{
    return spring->spec.kind == HOBE_SPRING_BUSHING ? 3 : 1;
}

/* Stiffness and damping: finite, not negative, and along one axis unless of a bushing. */
static enum hobe_status check_numbers(const struct hobe_spring *s, struct hobe_error *err)
{
    static const char *const name[2] = {"stiffness", "damping"};
    const double *const value[2] = {s->stiffness, s->damping};
    for (int i = 0; i < 6; i++) {
        const double x = value[i / 3][i % 3];
        if (!(x >= 0 && isfinite(x)))
            return hobe_fail(err, HOBE_BAD_INPUT, s->where, "%s of a spring must be >= 0, got %g",
                             name[i / 3], x);
        if (i % 3 > 0 && x > 0 && s->kind != HOBE_SPRING_BUSHING)
            return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                             "%s must be one number; only a spring of kind bushing has three",
                             name[i / 3]);
    }
    return HOBE_OK;
}

enum hobe_status spring_check(const struct hobe_spring *s, struct hobe_error *err)
{
    const int torsion = s->kind == HOBE_SPRING_TORSION, length = s->kind == HOBE_SPRING_LENGTH;
    const double axis = length3(s->axis);
    for (int i = 0; i < 2; i++)
        if (s->beam[i] && !(s->at[i] >= 0 && s->at[i] <= 1))
            return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                             "at must be a fraction of the beam's length from 0 to 1, got %g",
                             s->at[i]);
    if (!torsion && !length && s->kind != HOBE_SPRING_BUSHING)
        return hobe_fail(err, HOBE_BAD_INPUT, s->where, "there is no kind of spring %d",
                         (int)s->kind);
    if (!isfinite(axis) || torsion != (axis > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                         torsion ? "a spring of kind torsion needs axis, a direction {x, y, z} "
                                   "other than {0, 0, 0}"
                                 : "only a spring of kind torsion has an axis; leave it out");
    if (!(s->length >= 0 && isfinite(s->length)) || (!length && s->length > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                         length ? "length of a spring must be > 0 (m), got %g"
                                : "only a spring of kind length has a length, got %g",
                         s->length);
    if (!isfinite(s->angle) || (!torsion && s->angle != 0))
        return hobe_fail(err, HOBE_BAD_INPUT, s->where,
                         torsion ? "angle of a spring must be finite (rad), got %g"
                                 : "only a spring of kind torsion has an angle, got %g",
                         s->angle);
    return check_numbers(s, err);
}

/* ---- places and measures --------------------------------------------------------------------- */

/* Of b's directions across the axis on a's: sine and cosine of the angle, each twice. */
static void measure_angle(struct spring *s)
{
    double t[3][3], a[2][3], b[2][3];
    triad3(s->spec.axis, t);
    for (int k = 0; k < 2; k++) {
        joint_direction(s->tie.side, t[1 + k], a[k]);
        joint_direction(s->tie.side + 1, t[1 + k], b[k]);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double both = dot3(s->tie.side[0].D0[i], s->tie.side[1].D0[j]);
            s->measure[0].turn[i][j] = a[1][i] * b[0][j] - a[0][i] * b[1][j];
            s->measure[1].turn[i][j] = a[0][i] * b[0][j] + a[1][i] * b[1][j];
            for (int k = 0; k < 2; k++)
                s->start[k] += s->measure[k].turn[i][j] * both;
        }
}

static void measure_length(struct spring *s, const double gap[3])
{
    s->start[0] = length3(gap);
    memcpy(s->measure[0].hold, gap, sizeof s->measure[0].hold);
    s->measure[0].bend = 1;
}

/* Displacements along the global axes, which a carries. */
static void measure_displacements(struct spring *s)
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; i++)
        joint_direction(s->tie.side, axes[i], s->measure[i].slide);
}

static enum hobe_status open_spring(struct hobe_model *model, struct spring *s,
                                    struct hobe_error *err)
{
    const struct hobe_spring *spec = &s->spec;
    const char *other = spec->beam[1] ? spec->beam[1] : "the ground";
    double gap[3];
    int apart;
    struct hobe_joint places = {.where = spec->where, .at_point = spec->at_point};
    memcpy(places.beam, spec->beam, sizeof places.beam);
    memcpy(places.at, spec->at, sizeof places.at);
    memcpy(places.to, spec->to, sizeof places.to);
    memcpy(places.point, spec->point, sizeof places.point);
    const enum hobe_status status = joint_places(model, &places, s->tie.side, gap, &apart, err);
    if (status)
        return status;
    if (spec->kind == HOBE_SPRING_LENGTH && !apart)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "the places of a spring, on \"%s\" and %s, coincide, so that it has no "
                         "direction; use kind bushing",
                         spec->beam[0], other);
    if (spec->kind == HOBE_SPRING_BUSHING && spec->beam[1] && apart)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "the places of a bushing, on \"%s\" and \"%s\", are %g m apart; they must "
                         "coincide",
                         spec->beam[0], other, length3(gap));
    if (spec->kind == HOBE_SPRING_LENGTH)
        measure_length(s, gap);
    else if (spec->kind == HOBE_SPRING_TORSION)
        measure_angle(s);
    else
        measure_displacements(s);
    return tie_resolve(model, &s->tie, err);
}

enum hobe_status spring_build(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < model->springs.count; i++)
        status = open_spring(model, model_spring(model, i), err);
    return status;
}

/* ---- extensions ------------------------------------------------------------------------------ */

typedef double gradient[TIE_VECTORS][3];
typedef double hessian[TIE_VECTORS][TIE_VECTORS][3][3];

/* One of a spring's, from the reference, with its derivatives by r, y, z of both places. */
struct extension {
    double s;
    gradient G;
    hessian H;
};

/* H += factor A B' */
static void add_outer(double factor, gradient A, gradient B, hessian H)
{
    for (int i = 0; i < TIE_VECTORS; i++)
        for (int j = 0; j < TIE_VECTORS; j++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    H[i][j][a][b] += factor * A[i][a] * B[j][b];
}

/* z = x from_x + y from_y, of n numbers each */
static void mix(int n, double x, const void *from_x, double y, const void *from_y, void *z)
{
    for (int i = 0; i < n; i++)
        ((double *)z)[i] = x * ((const double *)from_x)[i] + y * ((const double *)from_y)[i];
}

enum { IN_G = 3 * TIE_VECTORS, IN_H = IN_G * IN_G };

/* From phi = (l^2 - l0^2)/2: s = l - l0, formed without that difference. */
static void extend_length(const struct spring *spring, const double *u, struct extension *x)
{
    const double start = spring->start[0];
    const double phi = tie_measure(&spring->tie, spring->measure, u, x->G, x->H);
    const double l = sqrt(start * start + 2 * phi);
    x->s = 2 * phi / (l + start);
    mix(IN_G, 1 / l, x->G, 0, x->G, x->G);
    mix(IN_H, 1 / l, x->H, 0, x->H, x->H);
    add_outer(-1 / l, x->G, x->G, x->H);
}

/* s = atan2(Y, X), the imaginary part of ln Z of Z = X + i Y: d ln Z = dZ/Z, d2 ln Z = d2Z/Z -
 * (dZ/Z)^2. */
static void extend_angle(const struct spring *spring, const double *u, struct extension *x)
{
    struct extension y, c; /* of Y and X */
    gradient growth;       /* d ln |Z| */
    const double Y = spring->start[0] + tie_measure(&spring->tie, spring->measure, u, y.G, y.H);
    const double X = spring->start[1] + tie_measure(&spring->tie, spring->measure + 1, u, c.G, c.H);
    const double R2 = X * X + Y * Y;
    x->s = atan2(Y, X) - atan2(spring->start[0], spring->start[1]);
    mix(IN_G, X / R2, y.G, -Y / R2, c.G, x->G);
    mix(IN_G, Y / R2, y.G, X / R2, c.G, growth);
    mix(IN_H, X / R2, y.H, -Y / R2, c.H, x->H);
    add_outer(-1, x->G, growth, x->H);
    add_outer(-1, growth, x->G, x->H);
}

static void extend(const struct spring *spring, int part, const double *u, struct extension *x)
{
    if (spring->spec.kind == HOBE_SPRING_LENGTH)
        extend_length(spring, u, x);
    else if (spring->spec.kind == HOBE_SPRING_TORSION)
        extend_angle(spring, u, x);
    else
        x->s = tie_measure(&spring->tie, spring->measure + part, u, x->G, x->H);
}

/* Where the elastic force is zero. */
static double rest_of(const struct spring *spring)
{
    return spring->spec.length > 0 ? spring->spec.length - spring->start[0] : spring->spec.angle;
}

/* G . dq of a field on the vectors: the extension's rate. */
static double rate_of(const struct spring *spring, gradient G, const double *field)
{
    gradient moved;
    double rate = 0;
    tie_motion(&spring->tie, field, moved);
    for (int i = 0; i < TIE_VECTORS; i++)
        rate += dot3(G[i], moved[i]);
    return rate;
}

/* The elastic force of a part at an extension. */
static double elastic_force(const struct spring *spring, int part, const struct extension *x)
{
    return spring->spec.stiffness[part] * (x->s - rest_of(spring));
}

/* With the damper's, at velocities v unless NULL. */
static double force_of(const struct spring *spring, int part, struct extension *x, const double *v)
{
    return elastic_force(spring, part, x) +
           (v ? spring->spec.damping[part] * rate_of(spring, x->G, v) : 0);
}

/* ---- sums ------------------------------------------------------------------------------------ */

static void add_stiffness(const struct hobe_model *model, const struct spring *spring,
                          double stiffness, double force, struct extension *x,
                          const struct matrix *K)
{
    mix(IN_H, force, x->H, 0, x->H, x->H);
    add_outer(stiffness, x->G, x->G, x->H);
    tie_add_tangent(model, &spring->tie, x->H, K);
}

static void add_part(const struct hobe_model *model, const struct spring *spring, int part,
                     const double *u, const struct instant *instant, double *f,
                     const struct matrix *K)
{
    const struct hobe_spring *spec = &spring->spec;
    struct extension x;
    extend(spring, part, u, &x);
    const double force = force_of(spring, part, &x, instant->v);
    tie_add_force(&spring->tie, force, (const double(*)[3])x.G, f);
    if (K)
        add_stiffness(model, spring, spec->stiffness[part] + instant->rate * spec->damping[part],
                      force, &x, K);
}

static void add_springs(const struct hobe_model *model, const double *u,
                        const struct instant *instant, double factor, double *f,
                        const struct matrix *K)
{
    (void)factor;
    for (size_t i = 0; i < model->springs.count; i++)
        for (int p = 0; p < parts_of(model_spring(model, i)); p++)
            add_part(model, model_spring(model, i), p, u, instant, f, K);
}

void spring_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                double *f, const struct matrix *K)
{
    if (model_whole(model)->springs.count > 0)
        reduction_act(model, add_springs, u, instant, 1, f, K);
}

void spring_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                   const struct beam *beam, int e, double *f)
{
    for (size_t i = 0; i < model->springs.count; i++) {
        const struct spring *spring = model_spring(model, i);
        for (int p = 0; p < parts_of(spring); p++)
            for (int side = 0; side < 2; side++) {
                struct extension x;
                if (!place_inside(spring->tie.side[side].place, beam, e))
                    continue;
                extend(spring, p, u, &x);
                tie_add_side(&spring->tie, side, -force_of(spring, p, &x, instant->v),
                             (const double(*)[3])x.G, f);
            }
    }
}

void spring_strained(const struct hobe_model *model, const double *u, const double *v,
                     const struct matrix *K)
{
    for (size_t i = 0; i < model->springs.count; i++) {
        const struct spring *spring = model_spring(model, i);
        for (int p = 0; p < parts_of(spring); p++) {
            const double k = spring->spec.stiffness[p];
            struct extension x;
            extend(spring, p, u, &x);
            add_stiffness(model, spring, k,
                          elastic_force(spring, p, &x) + k * rate_of(spring, x.G, v), &x, K);
        }
    }
}

double spring_energy(const struct hobe_model *model, const double *u)
{
    double energy = 0;
    u = model->reduction ? reduction_state(model, u) : u;
    model = model_whole(model);
    for (size_t i = 0; i < model->springs.count; i++) {
        const struct spring *spring = model_spring(model, i);
        for (int p = 0; p < parts_of(spring); p++) {
            struct extension x;
            extend(spring, p, u, &x);
            energy += elastic_force(spring, p, &x) * (x.s - rest_of(spring)) / 2;
        }
    }
    return energy;
}

double spring_power(const struct hobe_model *model, const double *u, const double *v)
{
    double power = 0;
    u = model->reduction ? reduction_state(model, u) : u;
    v = model->reduction ? reduction_rates(model, v) : v;
    model = model_whole(model);
    for (size_t i = 0; i < model->springs.count; i++) {
        const struct spring *spring = model_spring(model, i);
        for (int p = 0; p < parts_of(spring); p++) {
            struct extension x;
            extend(spring, p, u, &x);
            const double rate = rate_of(spring, x.G, v);
            power += spring->spec.damping[p] * rate * rate;
        }
    }
    return power;
}

int spring_jacobian(const struct spring *spring, double J[TIE_CONSTRAINTS][TIE_VECTORS][3])
{
    int rows = 0;
    for (int p = 0; p < parts_of(spring); p++)
        if (spring->spec.stiffness[p] > 0) {
            struct extension x;
            extend(spring, p, NULL, &x);
            memcpy(J[rows++], x.G, sizeof x.G);
        }
    return rows;
}

/* ---- results --------------------------------------------------------------------------------- */

static enum hobe_status fail_unknown(const hobe_model *model, const char *name,
                                     struct hobe_error *err)
{
    char known[400] = "";
    size_t used = 0;
    for (size_t i = 0; i < model->springs.count; i++) {
        const char *is = model_spring(model, i)->spec.name;
        if (is && used < sizeof known)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s\"%s\"",
                                     used ? ", " : "", is);
    }
    return hobe_fail(err, HOBE_UNKNOWN, NULL,
                     "there is no spring \"%s\" in the scene; those with a name are: %s", name,
                     used ? known : "none");
}

enum hobe_status hobe_solution_spring(const hobe_solution *solution, const char *name,
                                      struct hobe_spring_state *state, struct hobe_error *err)
{
    const hobe_model *model = solution->model;
    for (size_t i = 0; i < model->springs.count; i++) {
        const struct spring *spring = model_spring(model, i);
        if (!spring->spec.name || strcmp(spring->spec.name, name) != 0)
            continue;
        *state = (struct hobe_spring_state){.kind = spring->spec.kind};
        for (int p = 0; p < parts_of(spring); p++) {
            struct extension x;
            extend(spring, p, solution->u, &x);
            state->extension[p] = x.s;
            state->force[p] = force_of(spring, p, &x, solution->v);
        }
        if (spring->spec.kind == HOBE_SPRING_LENGTH)
            state->extension[0] += spring->start[0];
        return HOBE_OK;
    }
    return fail_unknown(model, name, err);
}
