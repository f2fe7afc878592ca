/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rigid bodies and masses: the mass matrix against integrals over shapes and the energy of rigid
 * motions; tangents of rigidity, joints and loads; bodies on beams against forces and frequencies
 * that are known; free tops against Euler's equations; what is refused.  Looks into the core. */
#include "body.h"
#include "check.h"
#include "constraint.h"
#include "load.h"
#include "mass.h"
#include "scene.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, RHO = 2700;

/* ---- scenes ---------------------------------------------------------------------------------- */

static void add_mass(hobe_model *model, double at, double y, double z, double mass)
{
    struct hobe_error err;
    const struct hobe_mass spec = {.beam = "beam", .at = at, .y = y, .z = z, .mass = mass};
    if (hobe_model_mass(model, &spec, &err))
        check_stop("%s", err.message);
}

static void build(hobe_model *model)
{
    struct hobe_error err;
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
}

static struct hobe_body_point body_of(const hobe_solution *solution, const char *name,
                                      const double *point)
{
    struct hobe_error err;
    struct hobe_body_point is;
    if (hobe_solution_body(solution, name, point, &is, &err))
        check_stop("%s", err.message);
    return is;
}

/* Two axes at a right angle. */
static void random_axes(double axis[3], double second[3])
{
    double other[3];
    random_direction(axis);
    random_direction(other);
    cross3(axis, other, second);
}

/* A body "body" of those principal inertias about random axes, at a random place. */
static struct hobe_body random_body(double mass, double I1, double I2, double I3)
{
    struct hobe_body body = {
        .name = "body", .mass = mass, .inertia = {{I1, 0, 0}, {0, I2, 0}, {0, 0, I3}}};
    for (int a = 0; a < 3; a++)
        body.centre[a] = random_real(-1, 1);
    random_axes(body.axis, body.second);
    return body;
}

/* ---- mass ------------------------------------------------------------------------------------ */

/* Points of a shape on its axes, |x| in its size, and their shares of the volume: rules that are
 * exact for second moments. */
enum { MOST_POINTS = 3 * 8 * 2 };

static int rule_of(const struct hobe_body *body, double x[MOST_POINTS][3], double w[MOST_POINTS])
{
    static const double gauss = 0.57735026918962576; /* 1/sqrt(3), weights 1/2 each */
    const double *size = body->size;
    int n = 0;
    if (body->shape == HOBE_SHAPE_BOX) {
        for (; n < 8; n++) {
            for (int a = 0; a < 3; a++)
                x[n][a] = (n >> a & 1 ? gauss : -gauss) * size[a] / 2;
            w[n] = 1.0 / 8;
        }
        return n;
    }
    /* int r^2 over a disk is R^2/2, over a ball 3 R^2/5: one radius and even directions */
    const int ball = body->shape == HOBE_SHAPE_SPHERE;
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < 8; k++, n++) {
            const double along = side ? gauss : -gauss, angle = k * acos(-1) / 4;
            const double radius = ball ? sqrt(0.6) * size[0] : size[0] / sqrt(2);
            const double across = ball ? sqrt(1 - along * along) : 1;
            x[n][0] = along * (ball ? radius : size[1] / 2);
            x[n][1] = radius * across * cos(angle);
            x[n][2] = radius * across * sin(angle);
            w[n] = 1.0 / 16;
        }
    return n;
}

/* m w'w over the points of a shape, w the weights of the body's vectors there. */
static void check_shape(struct hobe_body *body, double volume)
{
    double x[MOST_POINTS][3], w[MOST_POINTS], axes[3][3], expected[4][4] = {{0}};
    hobe_model *model = new_model();
    random_axes(body->axis, body->second);
    body->name = "body";
    body->density = RHO;
    for (int a = 0; a < 3; a++)
        body->centre[a] = random_real(-1, 1);
    add_body(model, body);
    memcpy(axes[0], body->axis, sizeof axes[0]);
    for (int a = 0; a < 3; a++)
        axes[1][a] = body->second[a] / norm(body->second);
    cross3(axes[0], axes[1], axes[2]);
    const int points = rule_of(body, x, w);
    for (int p = 0; p < points; p++) {
        double at[3], weight[4];
        for (int a = 0; a < 3; a++)
            at[a] = body->centre[a] + x[p][0] * axes[0][a] + x[p][1] * axes[1][a] +
                    x[p][2] * axes[2][a];
        body_weights(model_body(model, 0), at, weight);
        for (int i = 0; i < 16; i++)
            expected[i / 4][i % 4] += RHO * volume * w[p] * weight[i / 4] * weight[i % 4];
    }
    for (int i = 0; i < 16; i++)
        check_absolute(model_body(model, 0)->mass[i / 4][i % 4], expected[i / 4][i % 4],
                       1e-12 * RHO * volume, "shape %d: mass %d, %d", (int)body->shape, i / 4,
                       i % 4);
    hobe_model_free(model);
}

static void shapes(void)
{
    const double pi = acos(-1);
    check_shape(&(struct hobe_body){.shape = HOBE_SHAPE_BOX, .size = {0.3, 0.2, 0.1}}, 0.006);
    check_shape(&(struct hobe_body){.shape = HOBE_SHAPE_CYLINDER, .size = {0.24, 0.05}},
                pi * 0.24 * 0.24 * 0.05);
    check_shape(&(struct hobe_body){.shape = HOBE_SHAPE_SPHERE, .size = {0.2}}, 4 * pi / 3 * 0.008);
}

/* v'M v/2 = m |v|^2/2 + w.I w/2 of any rigid motion, and M v is its momentum; with a mass on a beam
 * beside it, whose point moves likewise. */
static void rigid_motion(void)
{
    const double I[3] = {random_real(1, 2), random_real(1, 2), random_real(1, 2)}, m = 3;
    const struct hobe_body body = random_body(m, I[0], I[1], I[2]);
    hobe_section *section = rectangle(0.05, 0.1);
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    hobe_model *model = new_model();
    struct hobe_error err;
    double w[3], v[3], energy = m / 2, third[3], arm[3];
    add_beam(model, &beam);
    add_body(model, &body);
    add_mass(model, 0.3, 0.02, -0.03, 2);
    build(model);
    double *q = hobe_alloc((size_t)(3 * model->vectors), sizeof *q, &err);
    double *rate = hobe_alloc((size_t)(3 * model->vectors), sizeof *rate, &err);
    random_direction(w);
    random_direction(v);
    model_reference(model, q);
    cross3(body.axis, body.second, third);
    const double *axis[3] = {body.axis, body.second, third};
    for (int i = 0; i < 3; i++)
        energy += I[i] / 2 * pow(dot3(w, axis[i]) / norm(axis[i]), 2);
    const long first = model_body(model, 0)->first;
    for (long i = first; i < first + 4; i++) {
        cross3(w, q + 3 * i, rate + 3 * i);
        for (int a = 0; a < 3 && i == first; a++)
            rate[3 * i + a] = v[a];
    }
    check_relative(mass_product(model, rate, rate) / 2, energy, 1e-12, "energy of a body");
    memset(rate, 0, (size_t)(3 * model->vectors) * sizeof *rate);
    for (long i = 0; i < model->beam_vectors; i++)
        cross3(w, q + 3 * i, rate + 3 * i);
    cross3(w, (const double[3]){0.3, 0.02, -0.03}, arm);
    check_relative(mass_product(model, rate, rate), 2 * dot3(arm, arm), 1e-10,
                   "energy of a mass off the axis");
    mass_translation(model, 1, q);
    check_relative(mass_product(model, q, q), m + 2, 1e-12, "all is moved");
    hobe_free(q);
    hobe_free(rate);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- tangents -------------------------------------------------------------------------------- */

static void forces_of_ties(const hobe_model *model, const double *u, double *r,
                           const struct matrix *K)
{
    constraint_add(model, u, &AT_REST, r, K);
}

static void forces_of_loads(const hobe_model *model, const double *u, double *r,
                            const struct matrix *K)
{
    load_subtract(model, u, &AT_REST, 1, r, K);
}

static void accelerations(const hobe_model *model, const double *u, double *r,
                          const struct matrix *K)
{
    mass_force(model, 1, u, r);
    if (K)
        mass_matrix(model, 1, K);
}

/* A beam and two bodies, the second joined to the first. */
static hobe_model *chain(const hobe_section *section, enum hobe_joint_kind kind, int beam_first)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    struct hobe_body body = random_body(2, 1, 1.2, 1.5);
    hobe_model *model = cantilever(&beam, 0);
    struct hobe_joint joint = {.beam = {"beam", "body"}, .at = {0.7, 0.7}, .kind = kind};
    if (!beam_first) {
        joint.beam[0] = "body";
        joint.beam[1] = "beam";
    }
    if (kind == HOBE_JOINT_DISTANCE) {
        joint.at_point = 1;
        joint.point[2] = 0.4;
    } else if (kind != HOBE_JOINT_FIXED && kind != HOBE_JOINT_SPHERICAL &&
               kind != HOBE_JOINT_RIGID) {
        random_axes(joint.axis, joint.second);
        if (kind != HOBE_JOINT_UNIVERSAL)
            memset(joint.second, 0, sizeof joint.second);
    }
    add_body(model, &body);
    add_joint(model, &joint);
    body.name = "other";
    add_body(model, &body);
    add_joint(model, &(struct hobe_joint){
                         .beam = {"other", "body"}, .at_point = 1, .point = {0.2, 0.3, 0.4}});
    return model;
}

static void tangents(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.05, 0.1);
    for (int kind = 0; kind <= HOBE_JOINT_RIGID; kind++)
        for (int first = 0; first < 2; first++) {
            hobe_model *model = chain(section, (enum hobe_joint_kind)kind, first);
            check_tangent(model, forces_of_ties, 1, hobe_joint_name((enum hobe_joint_kind)kind));
            hobe_model_free(model);
        }
    for (int follower = 0; follower < 2; follower++) {
        hobe_model *model = chain(section, HOBE_JOINT_FIXED, 0);
        const struct hobe_force force = {.beam = "body",
                                         .value = {1, 2, 3},
                                         .follower = follower,
                                         .at_point = 1,
                                         .point = {0.3, 0.2, -0.1}};
        const struct hobe_moment moment = {.beam = "other", .at_point = 1, .value = {3, 1, 2}};
        add_mass(model, 0.4, 0.01, 0, 2);
        if (hobe_model_force(model, &force, &err) ||
            (!follower && hobe_model_moment(model, &moment, &err)))
            check_stop("%s", err.message);
        check_tangent(model, forces_of_loads, !follower, follower ? "follower" : "moment");
        check_tangent(model, accelerations, 1, "mass");
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* ---- bodies on beams ------------------------------------------------------------------------- */

/* What a cantilever, its load and a body on it do, all of which change sign with the load. */
struct answer {
    double tip[3], rotation[3], centre[3], body_rotation[3], on_tip[3], force[3], moment[3];
};

/* A body beside the tip, under gravity and a moment; or its weight and their moment at the tip. */
static struct answer answer_to(const hobe_section *section, const struct hobe_body *body,
                               int as_load, const double g[3], const double M[3])
{
    struct hobe_error err;
    struct answer is;
    struct hobe_beam beam = beam_along_x("MGD30w", 4, section, E, 0.3, 1);
    beam.material.rho = RHO;
    hobe_model *model = cantilever(&beam, 0);
    memset(&is, 0, sizeof is);
    hobe_model_gravity(model, NULL, g, &err);
    if (as_load) {
        const double arm[3] = {body->centre[0] - 1, body->centre[1], body->centre[2]};
        const double m = body->mass;
        double couple[3];
        cross3(arm, g, couple);
        add_force(model, "beam", 1, m * g[0], m * g[1], m * g[2]);
        add_moment(model, "beam", 1, M[0] + m * couple[0], M[1] + m * couple[1],
                   M[2] + m * couple[2]);
    } else {
        const struct hobe_moment moment = {
            .beam = "body", .at_point = 1, .value = {M[0], M[1], M[2]}};
        add_body(model, body);
        add_joint(model,
                  &(struct hobe_joint){.beam = {"beam", "body"}, .name = "joint", .at = {1}});
        if (hobe_model_moment(model, &moment, &err))
            check_stop("%s", err.message);
    }
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
    memcpy(is.tip, tip.u, sizeof is.tip);
    memcpy(is.rotation, tip.rotation, sizeof is.rotation);
    if (!as_load) {
        struct hobe_reaction reaction;
        const struct hobe_body_point at = body_of(solution, "body", (const double[3]){1, 0, 0});
        const struct hobe_body_point centre = body_of(solution, "body", NULL);
        if (hobe_solution_reaction(solution, "joint", &reaction, &err))
            check_stop("%s", err.message);
        memcpy(is.centre, centre.u, sizeof is.centre);
        memcpy(is.body_rotation, centre.rotation, sizeof is.body_rotation);
        memcpy(is.on_tip, at.u, sizeof is.on_tip);
        memcpy(is.force, reaction.force, sizeof is.force);
        memcpy(is.moment, reaction.moment, sizeof is.moment);
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    return is;
}

/* The part of the answer that is linear in the load, and of third order. */
static struct answer linear_answer(const hobe_section *section, const struct hobe_body *body,
                                   int as_load, const double g[3], const double M[3])
{
    const double g_back[3] = {-g[0], -g[1], -g[2]}, M_back[3] = {-M[0], -M[1], -M[2]};
    struct answer is = answer_to(section, body, as_load, g, M);
    const struct answer back = answer_to(section, body, as_load, g_back, M_back);
    double *to = (double *)&is;
    for (size_t i = 0; i < sizeof is / sizeof *to; i++)
        to[i] = (to[i] - ((const double *)&back)[i]) / 2;
    return is;
}

/* The tip goes where the force and moment of the body's weight would take it, and the body with it;
 * angles
 * are of the order 1e-5, so that their third order is 1e-10 of them, and so is rounding of 1e-15;
 * the tip has ten times that, from moments that nearly cancel. */
static void weight_on_a_cantilever(void)
{
    const double g[3] = {0.3e-2, 0.5e-2, -9.81e-2}, M[3] = {2e-2, -1e-2, 3e-2}, m = 20;
    hobe_section *section = rectangle(0.05, 0.1);
    const struct hobe_body body = random_body(m, 1, 1.2, 1.5);
    const double arm[3] = {body.centre[0] - 1, body.centre[1], body.centre[2]};
    double couple[3], moved[3];
    const struct answer a = linear_answer(section, &body, 0, g, M);
    const struct answer b = linear_answer(section, &body, 1, g, M);
    cross3(arm, g, couple);
    check_absolute(distance(a.tip, b.tip), 0, 1e-8 * norm(a.tip), "weight of a body: tip");
    check_absolute(distance(a.rotation, b.rotation), 0, 1e-8 * norm(a.rotation), "its rotation");
    cross3(a.rotation, arm, moved);
    for (int i = 0; i < 3; i++)
        moved[i] += a.tip[i];
    check_absolute(distance(a.body_rotation, a.rotation), 0, 1e-9 * norm(a.rotation),
                   "the body turns along");
    check_absolute(distance(a.centre, moved), 0, 1e-8 * norm(moved), "its centre moves along");
    check_absolute(distance(a.on_tip, a.tip), 0, 1e-12 * norm(a.tip), "and the tip in it");
    for (int i = 0; i < 3; i++) {
        check_absolute(a.force[i], -m * g[i], 1e-9 * m * norm(g), "force of the joint");
        check_absolute(a.moment[i], -M[i] - m * couple[i], 1e-9 * m * norm(g) * (1 + norm(arm)),
                       "its moment");
    }
    hobe_section_free(section);
}

/* A cantilever with a mass mu m at its tip: 1 + cos b cosh b = mu b (sin b cosh b - cos b sinh b),
 * w = b^2 sqrt(EI/m L^3); the first root by bisection. */
static double frequency_number(double mu)
{
    double low = 0.1, high = 1.8752;
    for (int i = 0; i < 60; i++) {
        const double b = (low + high) / 2;
        const double f = 1 + cos(b) * cosh(b) - mu * b * (sin(b) * cosh(b) - cos(b) * sinh(b));
        *(f > 0 ? &low : &high) = b;
    }
    return low * low;
}

static void mass_on_a_cantilever(void)
{
    const double L = 1, h = 0.005, mu = 0.7;
    hobe_section *section = rectangle(h, h);
    struct hobe_beam beam = beam_along_x("3433", 16, section, E, 0, L);
    beam.material.rho = RHO;
    const double m = RHO * h * h * L;
    double omega[3];
    for (int i = 0; i < 3; i++) { /* a mass; a small body, by two kinds of joints */
        struct hobe_body body = {.name = "body", .mass = mu * m, .centre = {L}};
        hobe_model *model = cantilever(&beam, 0);
        for (int a = 0; a < 3; a++)
            body.inertia[a][a] = 1e-9 * mu * m * L * L;
        if (i == 0)
            add_mass(model, 1, 0, 0, mu * m);
        else {
            add_body(model, &body);
            add_joint(model,
                      &(struct hobe_joint){.beam = {"beam", "body"},
                                           .at = {1},
                                           .kind = i == 1 ? HOBE_JOINT_FIXED : HOBE_JOINT_RIGID});
        }
        hobe_modes *modes = modes_of(model, NULL, 2, HOBE_MODAL_AUTO);
        omega[i] = mode_of(modes, 0).omega;
        check_relative(modes_info(modes).mass, (1 + mu) * m, 1e-12, "mass of all");
        hobe_modes_free(modes);
        hobe_model_free(model);
    }
    /* shear and rotary inertia: of the order (h/L)^2, times about 4 */
    check_relative(omega[0], frequency_number(mu) * sqrt(E * h * h / 12 / (RHO * pow(L, 4))), 1e-4,
                   "mass at the tip");
    /* the bodies' rotary inertia: 1e-9 (b')^2 */
    check_relative(omega[1], omega[0], 1e-8, "a small body is a mass");
    check_relative(omega[2], omega[0], 1e-6, "also where the section is kept from straining");
    hobe_section_free(section);
}

/* Modes about a loaded state: a pendulum of one body, w^2 = m g l/(I + m l^2). */
static void pendulum(void)
{
    struct hobe_error err;
    const double l = 0.7, g = 9.81, m = 3, I = 0.2;
    hobe_model *model = new_model();
    struct hobe_body body = {.name = "bob",
                             .mass = m,
                             .centre = {0, 0, -l},
                             .inertia = {{0.3, 0, 0}, {0, I, 0}, {0, 0, 0.25}}};
    add_body(model, &body);
    add_joint(model,
              &(struct hobe_joint){
                  .beam = {"bob"}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 1, 0}, .at_point = 1});
    hobe_model_gravity(model, NULL, (const double[3]){0, 0, -g}, &err);
    hobe_history *history;
    const struct hobe_motion push = {.beam = "bob", .angular_velocity = {0, 1e-4, 0}};
    const double omega = sqrt(m * g * l / (I + m * l * l)), t = 2;
    if (hobe_model_motion(model, &push, &err) ||
        hobe_dynamic(model, &(struct hobe_dynamic){.to = t, .step = 1e-3, .rho = 1, .store = t},
                     &history, &err))
        check_stop("%s", err.message);
    const struct hobe_body_point end = body_of(hobe_history_state(history, 1), "bob", NULL);
    /* of second order: (w h)^2/12 of the phase */
    check_absolute(end.rotation[1], 1e-4 / omega * sin(omega * t), 1e-4 * 2e-5, "pendulum");
    check_absolute(norm(end.r), l, 1e-12, "its arm is rigid");
    hobe_history_free(history);
    hobe_model_free(model);
}

/* ---- free tops ------------------------------------------------------------------------------- */

/* How far the directions d_i of the body's axes are, after the time t in so many steps from the
 * angular velocity w0 on its axes, from those expected there; d[3][3] rows. */
static double top_error(const struct hobe_body *body, const double d0[3][3], const double w0[3],
                        double t, int steps, const double expected[3][3])
{
    struct hobe_error err;
    hobe_history *history;
    hobe_model *model = new_model();
    struct hobe_motion motion = {.velocity = {0.3, -0.2, 0.1}};
    double error = 0;
    add_body(model, body);
    memcpy(motion.about, body->centre, sizeof motion.about);
    for (int i = 0; i < 9; i++)
        motion.angular_velocity[i % 3] += w0[i / 3] * d0[i / 3][i % 3];
    if (hobe_model_motion(model, &motion, &err) ||
        hobe_dynamic(model, &(struct hobe_dynamic){.to = t, .step = t / steps, .store = t},
                     &history, &err))
        check_stop("%s", err.message);
    const hobe_solution *end = hobe_history_state(history, 1);
    const struct hobe_body_point centre = body_of(end, "body", NULL);
    for (int a = 0; a < 3; a++)
        check_absolute(centre.u[a], motion.velocity[a] * t, 1e-9, "the centre moves evenly");
    for (int i = 0; i < 3; i++) {
        double tip[3];
        for (int a = 0; a < 3; a++)
            tip[a] = body->centre[a] + d0[i][a];
        const struct hobe_body_point p = body_of(end, "body", tip);
        for (int a = 0; a < 3; a++)
            error = fmax(error, fabs(p.r[a] - centre.r[a] - expected[i][a]));
    }
    hobe_history_free(history);
    hobe_model_free(model);
    return error;
}

/* The body's axes in the reference, rows. */
static void axes_of(const struct hobe_body *body, double d[3][3])
{
    for (int a = 0; a < 3; a++) {
        d[0][a] = body->axis[a] / norm(body->axis);
        d[1][a] = body->second[a] / norm(body->second);
    }
    cross3(d[0], d[1], d[2]);
}

/* d += of rows d turned about the unit vector e. */
static void turn_about(const double e[3], double angle, double d[3][3])
{
    for (int i = 0; i < 3; i++) {
        double across[3];
        const double along = dot3(e, d[i]);
        cross3(e, d[i], across);
        for (int a = 0; a < 3; a++)
            d[i][a] = cos(angle) * (d[i][a] - along * e[a]) + along * e[a] + sin(angle) * across[a];
    }
}

static void check_order(const struct hobe_body *body, const double d0[3][3], const double w0[3],
                        double t, int steps, const double expected[3][3], const char *what)
{
    const double coarse = top_error(body, d0, w0, t, steps, expected);
    const double fine = top_error(body, d0, w0, t, 2 * steps, expected);
    check_that(coarse < 0.1, "%s: error %g", what, coarse);
    /* a sixth of it: the next order */
    check_absolute(coarse / fine, 4, 0.7, "%s: second order", what);
}

/* A body that is round about its first axis turns about that by w_1 (I - I_1)/I, while that turns
 * about the angular momentum L by |L|/I. */
static void symmetric_top(void)
{
    const double I1 = 0.5, I = 0.3, w[3] = {4, 1.5, 0}, t = 1.3;
    const struct hobe_body body = random_body(2, I1, I, I);
    double d0[3][3], d[3][3], L[3] = {0};
    axes_of(&body, d0);
    memcpy(d, d0, sizeof d);
    for (int a = 0; a < 3; a++)
        L[a] = I1 * w[0] * d0[0][a] + I * w[1] * d0[1][a];
    const double size = norm(L);
    turn_about(d0[0], w[0] * (I - I1) / I * t, d);
    for (int a = 0; a < 3; a++)
        L[a] /= size;
    turn_about(L, size / I * t, d);
    check_order(&body, (const double(*)[3])d0, w, t, 400, (const double(*)[3])d, "symmetric top");
}

/* Rates of the directions d (rows) and of the angular velocity w on them: d_i' = w x d_i, Euler's
 * equations; y = d, w. */
static void euler(const double I[3], const double y[12], double rate[12])
{
    double w[3] = {0};
    for (int i = 0; i < 9; i++)
        w[i % 3] += y[9 + i / 3] * y[i];
    for (int i = 0; i < 3; i++) {
        cross3(w, y + 3 * i, rate + 3 * i);
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        rate[9 + i] = (I[j] - I[k]) / I[i] * y[9 + j] * y[9 + k];
    }
}

static void runge_kutta(const double I[3], double h, double y[12])
{
    static const double at[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    double rate[12] = {0}, sum[12] = {0}, moved[12];
    for (int s = 0; s < 4; s++) {
        for (int i = 0; i < 12; i++)
            moved[i] = y[i] + at[s] * h * rate[i];
        euler(I, moved, rate);
        for (int i = 0; i < 12; i++)
            sum[i] += weight[s] / 6 * h * rate[i];
    }
    for (int i = 0; i < 12; i++)
        y[i] += sum[i];
}

/* About its intermediate axis a body turns over, and back. */
static void tumbling(void)
{
    const double I[3] = {0.2, 0.3, 0.45}, w[3] = {0.1, 3, -0.05}, t = 5;
    const struct hobe_body body = random_body(2, I[0], I[1], I[2]);
    double d0[3][3], y[12], least = w[1];
    axes_of(&body, d0);
    memcpy(y, d0, sizeof d0);
    memcpy(y + 9, w, sizeof w);
    for (int i = 0; i < 20000; i++) { /* its error is 1e-13 */
        runge_kutta(I, t / 20000, y);
        least = fmin(least, y[10]);
    }
    check_that(least < -2.9, "it turns over: w_2 comes to %g", least);
    check_order(&body, (const double(*)[3])d0, w, t, 1600, (const double(*)[3])y, "tumbling");
}

/* ---- what is refused ------------------------------------------------------------------------- */

static void refuse_body(struct hobe_body body, const char *words)
{
    struct hobe_error err = {0};
    hobe_model *model = new_model();
    body.name = "body";
    check_that(hobe_model_body(model, &body, &err) == HOBE_BAD_INPUT && strstr(err.message, words),
               "\"%s\" is said: %s", words, err.message);
    hobe_model_free(model);
}

static void bad_bodies(void)
{
    const struct hobe_body good = {.mass = 1, .inertia = {{2, 0, 0}, {0, 2, 0}, {0, 0, 3}}};
    struct hobe_body body = good;
    body.inertia[2][2] = 4.1;
    refuse_body(body, "principal inertias 2, 2, 4.1 kg m^2 of \"body\": none may be more than");
    body.inertia[2][2] = 0;
    refuse_body(body, "would turn freely");
    body = good;
    body.inertia[0][1] = 0.1;
    refuse_body(body, "symmetric, got 0.1 and 0 kg m^2 about axes 1, 2");
    body = good;
    body.mass = 0;
    refuse_body(body, "needs a mass > 0");
    body = good;
    body.axis[1] = 1;
    refuse_body(body, "needs second");
    body.second[1] = 1;
    refuse_body(body, "must be at a right angle");
    body.second[1] = NAN;
    refuse_body(body, "must be finite");
    refuse_body((struct hobe_body){.shape = (enum hobe_shape)4}, "no shape 4");
    refuse_body((struct hobe_body){.shape = HOBE_SHAPE_BOX, .size = {1, 2}}, "must be > 0, got 0");
    refuse_body((struct hobe_body){.shape = HOBE_SHAPE_SPHERE, .size = {1}}, "one of them, > 0");
    body = (struct hobe_body){.shape = HOBE_SHAPE_SPHERE, .size = {1}, .mass = 1, .centre = {NAN}};
    refuse_body(body, "must be finite");
}

static hobe_model *body_alone(void)
{
    hobe_model *model = new_model();
    const struct hobe_body body = random_body(1, 1, 1, 1);
    add_body(model, &body);
    return model;
}

static void check_sentence(hobe_model *model, enum hobe_status status, const char *words)
{
    struct hobe_error err = {0};
    hobe_solution *solution;
    check_that(hobe_static(model, &(struct hobe_newton){0}, &solution, &err) == status &&
                   strstr(err.message, words),
               "\"%s\" is said: %s", words, err.message);
    hobe_model_free(model);
}

static void bad_scenes(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.1);
    const struct hobe_beam beam = beam_along_x("MGD30w", 1, section, E, 0.3, 1);
    const struct hobe_joint fixed = {.beam = {"body"}, .name = "joint", .at_point = 1};
    struct hobe_joint joint = fixed;
    check_sentence(new_model(), HOBE_BAD_INPUT, "no beam and no body");
    check_sentence(body_alone(), HOBE_UNCONSTRAINED,
                   "body \"body\" is free to move: translations along x, y, z and rotations");
    hobe_model *model = body_alone();
    add_joint(model, &fixed);
    joint.name = "second";
    joint.kind = HOBE_JOINT_SPHERICAL;
    joint.point[0] = 1;
    add_joint(model, &joint);
    check_sentence(model, HOBE_BAD_INPUT, "the joint \"second\" of body \"body\" stops motions");
    model = body_alone();
    joint.at_point = 0;
    add_joint(model, &joint);
    check_sentence(model, HOBE_BAD_INPUT, "the place on body \"body\" is missing");
    model = body_alone();
    add_joint(model, &(struct hobe_joint){.beam = {"body", "body"}, .at_point = 1});
    check_sentence(model, HOBE_BAD_INPUT, "cannot be joined to itself");
    model = cantilever(&beam, 0);
    add_joint(model, &(struct hobe_joint){.beam = {"beam"}, .at_point = 1});
    check_sentence(model, HOBE_BAD_INPUT, "at is missing: the place on beam \"beam\"");
    model = cantilever(&beam, 0);
    add_joint(model, &(struct hobe_joint){.beam = {"beam", "beam"}, .kind = HOBE_JOINT_RIGID});
    check_sentence(model, HOBE_BAD_INPUT, "needs a body or the ground");
    model = body_alone();
    add_clamp(model, "body", 0, 0);
    check_sentence(model, HOBE_UNKNOWN, "\"body\" is a body; a beam is needed");
    model = body_alone();
    check_that(hobe_model_beam(model, &(struct hobe_beam){.name = "body"}, &err) ==
                       HOBE_BAD_INPUT &&
                   strstr(err.message, "two beams or bodies named \"body\""),
               "a name twice: %s", err.message);
    check_that(hobe_model_mass(model, &(struct hobe_mass){.beam = "x", .mass = -1}, &err) ==
                       HOBE_BAD_INPUT &&
                   strstr(err.message, "a mass must be >= 0"),
               "a negative mass: %s", err.message);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    shapes();
    rigid_motion();
    tangents();
    weight_on_a_cantilever();
    mass_on_a_cantilever();
    pendulum();
    symmetric_top();
    tumbling();
    bad_bodies();
    bad_scenes();
    return check_report();
}
