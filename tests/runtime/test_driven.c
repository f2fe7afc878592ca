/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Driven joints and supports: what the drives move is where they have it, for any kind and time;
 * their tangents, and their rates and accelerations against differences in time; whole turns;
 * power.  Looks into the core for residuals. */
#include "check.h"
#include "constraint.h"
#include "drive.h"
#include "scene.h"
#include "solution.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 70e9;

/* ---- scenes ---------------------------------------------------------------------------------- */

/* A ramp from `from` at 0 s to `to` at `until`. */
static hobe_drive *ramp(double from, double to, double until)
{
    struct hobe_error err;
    const double point[2][2] = {{0, from}, {until, to}};
    hobe_drive *drive = hobe_drive_points(2, point, HOBE_RAMP, 0, &err);
    if (!drive)
        check_stop("%s", err.message);
    return drive;
}

/* Value, rate and second derivative. */
static double driven(hobe_drive *drive, double t, int p)
{
    struct hobe_error err;
    double d[3] = {0};
    if (drive && hobe_drive_at(drive, t, d, &err))
        check_stop("%s", err.message);
    return d[p];
}

static hobe_solution *solve_at(hobe_model *model, int steps, double time)
{
    struct hobe_error err;
    hobe_solution *solution;
    const struct hobe_newton options = {.steps = steps, .tolerance = 1e-12, .time = time};
    if (hobe_static(model, &options, &solution, &err))
        check_stop("%s", err.message);
    return solution;
}

static struct hobe_beam random_beam(const char *name, const hobe_section *section)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    beam.name = name;
    random_direction(beam.to);
    random_direction(beam.up);
    return beam;
}

/* p turned by theta about the unit axis e (Rodrigues). */
static void rotate(const double e[3], double theta, const double p[3], double to[3])
{
    double across[3];
    cross3(e, p, across);
    for (int a = 0; a < 3; a++)
        to[a] = cos(theta) * p[a] + sin(theta) * across[a] + (1 - cos(theta)) * dot3(e, p) * e[a];
}

/* ---- the ground as first part ---------------------------------------------------------------- */

/* Kinds and which drives leave nothing free; planar has an inline support at the same place. */
static const struct {
    enum hobe_joint_kind kind;
    int angle, position;
} holding[] = {
    {HOBE_JOINT_FIXED, 1, 0},     {HOBE_JOINT_FIXED, 0, 1},     {HOBE_JOINT_FIXED, 1, 1},
    {HOBE_JOINT_REVOLUTE, 1, 0},  {HOBE_JOINT_REVOLUTE, 1, 1},  {HOBE_JOINT_CYLINDRICAL, 1, 1},
    {HOBE_JOINT_PRISMATIC, 0, 1}, {HOBE_JOINT_PRISMATIC, 1, 1}, {HOBE_JOINT_PLANAR, 1, 1}};

/* A beam that nothing loads moves as a rigid body with the carriage, at any time: r = R(theta) (r0
 * - place) + place + s axis. */
static void rigid_motions(const hobe_section *section)
{
    for (size_t i = 0; i < sizeof holding / sizeof *holding; i++) {
        const struct hobe_beam beam = random_beam("beam", section);
        hobe_drive *angle = ramp(0, random_real(-2, 2), 1.5);
        hobe_drive *position = ramp(random_real(-1, 1), random_real(-1, 1), 1.5);
        struct hobe_joint joint = {.beam = {"beam"}, .at = {random_real(0, 1)}};
        const double t = random_real(0.5, 2);
        hobe_model *model = new_model();
        random_direction(joint.axis);
        add_beam(model, &beam);
        if (holding[i].kind == HOBE_JOINT_PLANAR) {
            joint.kind = HOBE_JOINT_INLINE;
            add_joint(model, &joint);
        }
        joint.kind = holding[i].kind;
        joint.angle = holding[i].angle ? angle : NULL;
        joint.position = holding[i].position ? position : NULL;
        add_joint(model, &joint);
        hobe_solution *solution = solve_at(model, 8, t);
        const double theta = driven(joint.angle, t, 0), s = driven(joint.position, t, 0);
        for (int end = 0; end < 2; end++) {
            const double arm[3] = {(end - joint.at[0]) * beam.to[0],
                                   (end - joint.at[0]) * beam.to[1],
                                   (end - joint.at[0]) * beam.to[2]};
            double r[3];
            rotate(joint.axis, theta, arm, r);
            for (int a = 0; a < 3; a++)
                r[a] += joint.at[0] * beam.to[a] + s * joint.axis[a];
            check_absolute(distance(point_of(solution, "beam", end, 0, 0).r, r), 0, 1e-9,
                           "%s %d%d: end %d, turned by %g rad and shifted by %g m",
                           hobe_joint_name(joint.kind), holding[i].angle, holding[i].position, end,
                           theta, s);
        }
        check_absolute(info_of(solution).energy, 0, 1e-6, "no strain");
        hobe_solution_free(solution);
        hobe_model_free(model);
        hobe_drive_free(angle);
        hobe_drive_free(position);
    }
}

/* A beam on a hinge whose end is at a driven distance from a point of the ground. */
static void driven_distance(const hobe_section *section)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    const struct hobe_joint hinge = {
        .beam = {"beam"}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 0, 1}};
    struct hobe_joint rod = {
        .beam = {"beam"}, .at = {1}, .kind = HOBE_JOINT_DISTANCE, .to = {0.2, -1, 0}};
    const double length = hypot(0.8, 1), change = random_real(-0.3, 0.3);
    hobe_model *model = new_model();
    rod.position = ramp(0, change, 1);
    add_beam(model, &beam);
    add_joint(model, &hinge);
    add_joint(model, &rod);
    hobe_solution *solution = solve_at(model, 6, 1);
    const struct hobe_point end = point_of(solution, "beam", 1, 0, 0);
    check_absolute(distance(end.r, rod.to), length + change, 1e-11, "the distance is driven");
    check_absolute(norm(end.r), 1, 1e-9, "and the beam turns");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_drive_free(rod.position);
}

/* Many turns: a state turned by theta meets Phi at any number of them, and steps get there. */
static void whole_turns(const hobe_section *section)
{
    const struct hobe_beam beam = random_beam("beam", section);
    struct hobe_joint joint = {.beam = {"beam"}, .kind = HOBE_JOINT_REVOLUTE};
    double arm[3];
    hobe_model *model = new_model();
    random_direction(joint.axis);
    joint.angle = ramp(0, 150, 1);
    add_beam(model, &beam);
    add_joint(model, &joint);
    const double t = acos(1 - 2 * 8. / 150) / 3.14159265358979323846; /* 8 rad */
    hobe_solution *solution = solve_at(model, 40, t);
    rotate(joint.axis, 8, beam.to, arm);
    check_absolute(distance(point_of(solution, "beam", 1, 0, 0).r, arm), 0, 1e-9,
                   "turned by 8 rad");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_drive_free(joint.angle);
}

/* The power of a drive is its torque times its speed; the torque that of a follower at the end. */
static void power(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_reaction reaction;
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    struct hobe_joint joint = {
        .beam = {"beam"}, .name = "shaft", .kind = HOBE_JOINT_CYLINDRICAL, .axis = {0, 0, 2}};
    const double t = random_real(0.2, 0.8), F[3] = {30, random_real(10, 100), random_real(10, 100)};
    hobe_model *model = new_model();
    joint.angle = ramp(0, 0.5, 1);
    joint.position = ramp(0, -0.2, 1);
    add_beam(model, &beam);
    add_joint(model, &joint);
    add_force(model, "beam", 0.9, F[0], F[1], F[2]);
    hobe_solution *solution = solve_at(model, 4, t);
    if (hobe_solution_reaction(solution, "shaft", &reaction, &err))
        check_stop("%s", err.message);
    const struct hobe_point p = point_of(solution, "beam", 0.9, 0, 0);
    check_relative(reaction.moment[2], -(p.r[0] * F[1] - p.r[1] * F[0]), 1e-8, "torque");
    check_relative(reaction.force[2], -F[2], 1e-8, "thrust");
    check_relative(reaction.power,
                   reaction.moment[2] * driven(joint.angle, t, 1) +
                       reaction.force[2] * driven(joint.position, t, 1),
                   1e-10, "power");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_drive_free(joint.angle);
    hobe_drive_free(joint.position);
}

/* Turned and shifted by a drive, a beam vibrates as in the reference. */
static void modes_of_driven(const hobe_section *section)
{
    struct hobe_beam beam = random_beam("beam", section);
    struct hobe_joint joint = {.beam = {"beam"}, .kind = HOBE_JOINT_CYLINDRICAL};
    hobe_model *model = new_model();
    random_direction(joint.axis);
    joint.angle = ramp(0, 1.2, 1);
    joint.position = ramp(0.1, 0.5, 1);
    beam.material.rho = 2700;
    add_beam(model, &beam);
    add_joint(model, &joint);
    hobe_solution *solution = solve_at(model, 8, 1);
    hobe_modes *turned = modes_of(model, solution, 3, HOBE_MODAL_LANCZOS);
    hobe_modes *at_rest = modes_of(model, NULL, 3, HOBE_MODAL_LANCZOS);
    for (int i = 0; i < 3; i++)
        check_relative(mode_of(turned, i).omega2, mode_of(at_rest, i).omega2, 1e-7,
                       "omega^2 of mode %d", i);
    hobe_modes_free(turned);
    hobe_modes_free(at_rest);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_drive_free(joint.angle);
    hobe_drive_free(joint.position);
}

/* ---- two beams ------------------------------------------------------------------------------- */

static const double NOW = 0.6;

static void forces_now(const hobe_model *model, const double *u, double *r, const struct matrix *K)
{
    const struct instant instant = {.time = NOW};
    constraint_add(model, u, &instant, r, K);
}

/* Phi at the multipliers for u + tau v at NOW + tau. */
static void phi(const hobe_model *model, const double *u, const double *v, double tau, double *r)
{
    struct hobe_error err;
    const long n = 3 * model->vectors;
    const struct instant instant = {.time = NOW + tau};
    double *moved = hobe_alloc((size_t)n, sizeof *moved, &err);
    for (long i = 0; i < n; i++)
        moved[i] = u[i] + (v ? tau * v[i] : 0);
    memset(r, 0, (size_t)n * sizeof *r);
    constraint_add(model, moved, &instant, r, NULL);
    hobe_free(moved);
}

/* At a random state, rates and accelerations of all constraints against differences of fourth
 * order, h = 1e-2 and 2e-3: their errors and rounding are some 1e-8. */
static void check_rates(const hobe_model *model, const char *what)
{
    static const double first[4] = {1. / 12, -8. / 12, 8. / 12, -1. / 12};
    static const double second[5] = {-1. / 12, 16. / 12, -30. / 12, 16. / 12, -1. / 12};
    static const int at[4] = {-2, -1, 1, 2};
    const long n = 3 * model->vectors, from = 3 * model->beam_vectors;
    const struct instant instant = {.time = NOW};
    struct hobe_error err;
    double *const all = hobe_alloc((size_t)(7 * n), sizeof *all, &err);
    double *u = all, *v = u + n, *r = v + n, *rate = r + n, *acceleration = rate + n;
    double *slope = acceleration + n, *bend = slope + n;
    for (long i = 0; i < from; i++) {
        u[i] = random_real(-0.3, 0.3);
        v[i] = random_real(-1, 1);
    }
    constraint_rate(model, u, &instant, rate);
    constraint_acceleration(model, u, v, &instant, acceleration);
    for (int k = 0; k < 4; k++) {
        phi(model, u, NULL, 2e-3 * at[k], r);
        for (long i = from; i < n; i++)
            slope[i] += first[k] * r[i] / 2e-3;
    }
    for (int k = 0; k < 5; k++) {
        phi(model, u, v, 2e-3 * (k - 2), r);
        for (long i = from; i < n; i++)
            bend[i] += second[k] * r[i] / 4e-6;
    }
    for (long i = 0; i < n; i++) {
        check_absolute(rate[i], slope[i], 1e-8, "%s: rate %ld", what, i - from);
        check_absolute(acceleration[i], bend[i], 1e-6 * (1 + fabs(bend[i])), "%s: acceleration %ld",
                       what, i - from);
    }
    hobe_free(all);
}

/* Two loaded beams: the second is carried by the first, whose end turns and shifts it. */
static void carried(enum hobe_joint_kind kind, int drives, const hobe_section *section)
{
    const char *what = hobe_joint_name(kind);
    struct hobe_beam beam[2] = {random_beam("first", section), random_beam("second", section)};
    struct hobe_joint joint = {.beam = {"first", "second"}, .at = {0.3, 0.6}, .kind = kind};
    hobe_drive *angle = ramp(0, random_real(0.5, 1), 1), *position = ramp(0, 0.3, 1);
    hobe_model *model = new_model();
    for (int i = 0; i < 2; i++) {
        const double apart = i && kind == HOBE_JOINT_DISTANCE ? 0.5 : 0;
        for (int a = 0; a < 3 && i; a++) { /* the places coincide */
            beam[1].from[a] = 0.3 * beam[0].to[a] - 0.6 * beam[1].to[a] + apart;
            beam[1].to[a] += beam[1].from[a];
        }
        add_beam(model, beam + i);
        add_clamp(model, beam[i].name, 0, 0);
    }
    joint.angle = drives & 1 ? angle : NULL;
    joint.position = drives & 2 ? position : NULL;
    if (kind != HOBE_JOINT_DISTANCE)
        random_direction(joint.axis);
    if (kind == HOBE_JOINT_UNIVERSAL) {
        double other[3];
        random_direction(other);
        cross3(joint.axis, other, joint.second);
    }
    add_joint(model, &joint);
    check_tangent(model, forces_now, 1, what);
    check_rates(model, what);
    hobe_model_free(model);
    hobe_drive_free(angle);
    hobe_drive_free(position);
}

/* Every kind with every drive that it takes. */
static void each_kind(const hobe_section *section)
{
    for (int kind = 0; kind <= HOBE_JOINT_DISTANCE; kind++) {
        const int turns = kind == HOBE_JOINT_FIXED || kind == HOBE_JOINT_REVOLUTE ||
                          kind == HOBE_JOINT_CYLINDRICAL || kind == HOBE_JOINT_PRISMATIC ||
                          kind == HOBE_JOINT_PLANAR;
        for (int drives = 1; drives < 4; drives++)
            if (turns || drives == 2)
                carried((enum hobe_joint_kind)kind, drives, section);
    }
}

/* A loaded beam carries another, without load, which keeps its shape: both turn against each other
 * by theta to a few strains of the first, and the place shifts by s along the carried axis. */
static void turned_against_a_beam(const hobe_section *section)
{
    struct hobe_beam first = beam_along_x("MGD30w", 4, section, E, 0.3, 1), second = first;
    struct hobe_joint joint = {.beam = {"beam", "second"},
                               .at = {1, 0},
                               .kind = HOBE_JOINT_CYLINDRICAL,
                               .axis = {1, 0, 0}};
    const double theta = random_real(0.5, 1.5), s = random_real(0.1, 0.3);
    hobe_model *model = cantilever(&first, 0);
    joint.angle = ramp(0, theta, 1);
    joint.position = ramp(0, s, 1);
    second.name = "second";
    second.from[0] = 1;
    second.to[0] = 2;
    add_beam(model, &second);
    add_joint(model, &joint);
    add_force(model, "beam", 1, 0, 0, 1000);
    hobe_solution *solution = solve_at(model, 8, 1);
    const struct hobe_point a = point_of(solution, "beam", 1, 0, 0);
    const struct hobe_point b = point_of(solution, "second", 0, 0, 0);
    const struct hobe_point c = point_of(solution, "second", 1, 0, 0);
    double on_a[3], on_b[3];
    const struct hobe_point up_a = point_of(solution, "beam", 1, 0, 1e-3);
    const struct hobe_point up_b = point_of(solution, "second", 0, 0, 1e-3);
    for (int i = 0; i < 3; i++) {
        on_a[i] = (up_a.r[i] - a.r[i]) / 1e-3;
        on_b[i] = (up_b.r[i] - b.r[i]) / 1e-3;
    }
    check_relative(distance(b.r, c.r), 1, 1e-9, "the carried beam keeps its length");
    check_that(norm(a.u) > 1e-2, "the carrier bends by %g m", norm(a.u));
    check_absolute(dot3(on_a, on_b), cos(theta), 3e-4, "the angle between both");
    check_absolute(distance(a.r, b.r), s, 3e-4 * s, "the shift along the axis");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_drive_free(joint.angle);
    hobe_drive_free(joint.position);
}

/* ---- what is refused ------------------------------------------------------------------------- */

static enum hobe_status broken(void *context, double t, double *f, struct hobe_error *err)
{
    (void)context;
    (void)t;
    (void)f;
    return hobe_fail(err, HOBE_IO, NULL, "broken on purpose");
}

static void check_sentence(enum hobe_status status, enum hobe_status expected,
                           const struct hobe_error *err, const char *sentence)
{
    check_that(status == expected && strstr(err->message, sentence), "\"%s\", got \"%s\"", sentence,
               err->message);
}

static void refused(const hobe_section *section)
{
    static const double jump[2][2] = {{1, 0}, {1, 2}};
    struct hobe_error err;
    hobe_solution *solution;
    hobe_drive *drive = hobe_drive_points(2, jump, HOBE_LINEAR, 0, &err), *smooth = ramp(0, 1, 1);
    hobe_drive *bad = hobe_drive_function(broken, NULL, 0, &err), *away = ramp(0, -2, 1);
    const struct hobe_joint joint[] = {
        {.beam = {"beam"}, .kind = HOBE_JOINT_REVOLUTE, .axis = {1}, .angle = drive},
        {.beam = {"beam"}, .kind = HOBE_JOINT_SPHERICAL, .axis = {1}, .angle = smooth},
        {.beam = {"beam"}, .kind = HOBE_JOINT_FIXED, .angle = smooth},
        {.beam = {"beam"}, .where = "here", .kind = HOBE_JOINT_FIXED, .axis = {1}, .angle = bad},
        {.beam = {"beam"}, .at = {1}, .kind = HOBE_JOINT_DISTANCE, .to = {2}, .position = away}};
    const struct hobe_beam beam = beam_along_x("MGD30w", 1, section, E, 0.3, 1);
    hobe_model *model = new_model();
    check_sentence(hobe_model_joint(model, joint, &err), HOBE_BAD_INPUT, &err,
                   "the angle of a joint cannot jump, at t = 1 s");
    check_sentence(hobe_model_joint(model, joint + 1, &err), HOBE_BAD_INPUT, &err,
                   "kind spherical lets its axis tilt");
    check_sentence(hobe_model_joint(model, joint + 2, &err), HOBE_BAD_INPUT, &err,
                   "a driven joint of kind fixed needs axis");
    add_beam(model, &beam);
    add_joint(model, joint + 3);
    check_sentence(hobe_static(model, &(struct hobe_newton){0}, &solution, &err), HOBE_IO, &err,
                   "broken on purpose");
    check_that(err.where && !strcmp(err.where, "here"), "the joint is named");
    hobe_model_free(model);
    model = cantilever(&beam, 0);
    add_joint(model, joint + 4);
    check_that(drive_next(model, 0.5) == 1 && drive_next(model, 1) == INFINITY, "breakpoints");
    check_sentence(hobe_static(model, &(struct hobe_newton){.time = 1}, &solution, &err),
                   HOBE_BAD_INPUT, &err, "a distance of 1 m cannot change by -2 m, at t = 1 s");
    hobe_path *path;
    check_sentence(hobe_path_follow(model, &(struct hobe_path_options){0}, &path, &err),
                   HOBE_BAD_INPUT, &err, "cannot follow a driven joint");
    hobe_model_free(model);
    hobe_drive_free(drive);
    hobe_drive_free(smooth);
    hobe_drive_free(bad);
    hobe_drive_free(away);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.03, 0.03);
    rigid_motions(section);
    driven_distance(section);
    whole_turns(section);
    power(section);
    modes_of_driven(section);
    each_kind(section);
    turned_against_a_beam(section);
    refused(section);
    hobe_section_free(section);
    return check_report();
}
