/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Joints and supports: every kind's tangent, what it stops and what it leaves, reactions against
 * loads, theory of hinged beams and frames, and scenes with too few of them or too many.  Looks
 * into the core for residuals. */
#include "check.h"
#include "constraint.h"
#include "scene.h"
#include "solution.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, PI = 3.14159265358979323846;

enum { KINDS = HOBE_JOINT_DISTANCE + 1 }; /* those between beams */

/* Whether a kind has an axis. */
static int has_axis(enum hobe_joint_kind kind)
{
    return kind != HOBE_JOINT_FIXED && kind != HOBE_JOINT_SPHERICAL && kind != HOBE_JOINT_DISTANCE;
}

/* A support called `name` of the beam "beam"; the second axis is that of a universal joint. */
static void add_support(hobe_model *model, const char *name, double at, enum hobe_joint_kind kind,
                        const double axis[3])
{
    struct hobe_joint joint = {.beam = {"beam"}, .name = name, .at = {at}, .kind = kind};
    if (has_axis(kind))
        memcpy(joint.axis, axis, sizeof joint.axis);
    if (kind == HOBE_JOINT_UNIVERSAL)
        joint.second[axis[1] != 0 ? 2 : 1] = 1;
    add_joint(model, &joint);
}

static struct hobe_reaction reaction_of(const hobe_solution *solution, const char *name)
{
    struct hobe_error err;
    struct hobe_reaction reaction;
    if (hobe_solution_reaction(solution, name, &reaction, &err))
        check_stop("%s", err.message);
    return reaction;
}

static const double X[3] = {1, 0, 0}, Y[3] = {0, 1, 0}, Z[3] = {0, 0, 1};

/* ---- all kinds ------------------------------------------------------------------------------- */

/* How a scene lies: p -> R p, R a rotation by rows. */
struct pose {
    double R[3][3];
};

static void turn(const struct pose *pose, const double p[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = dot3(pose->R[i], p);
}

static struct pose random_pose(void)
{
    struct pose pose;
    double u[3], v[3];
    random_direction(u);
    random_direction(v);
    cross3(u, v, pose.R[2]);
    const double length = length3(pose.R[2]);
    for (int i = 0; i < 3; i++) {
        pose.R[0][i] = u[i];
        pose.R[2][i] /= length;
    }
    cross3(pose.R[2], pose.R[0], pose.R[1]);
    return pose;
}

/* Two beams that cross at a right angle, as "first" at 0.3 and "second" at 0.6, inside elements;
 * all four ends are held, so that any joint may lie between. */
struct crossing {
    enum hobe_joint_kind kind;
    double up[2][3], axis[3], second[3], force[3];
};

static struct crossing random_crossing(enum hobe_joint_kind kind)
{
    struct crossing c = {.kind = kind};
    double other[3];
    for (int i = 0; i < 2; i++)
        random_direction(c.up[i]);
    if (has_axis(kind))
        random_direction(c.axis);
    random_direction(other);
    if (kind == HOBE_JOINT_UNIVERSAL)
        cross3(c.axis, other, c.second);
    random_direction(c.force);
    for (int a = 0; a < 3; a++)
        c.force[a] *= 2e4;
    return c;
}

static hobe_model *crossing(const struct crossing *c, const struct pose *pose,
                            const hobe_section *section)
{
    static const char *const names[2] = {"first", "second"};
    static const double end[2][2][3] = {{{0, 0, 0}, {1, 0, 0}}, {{.3, -.6, 0}, {.3, .4, 0}}};
    const double apart = c->kind == HOBE_JOINT_DISTANCE ? 0.2 : 0;
    hobe_model *model = new_model();
    struct hobe_joint joint = {
        .beam = {names[0], names[1]}, .name = "joint", .at = {0.3, 0.6}, .kind = c->kind};
    double F[3];
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x(i ? "3433w" : "MGD30w", 2, section, E, 0.3, 1);
        beam.name = names[i];
        const double lift[3] = {end[i][0][0], end[i][0][1], i * apart};
        const double lifted[3] = {end[i][1][0], end[i][1][1], i * apart};
        turn(pose, lift, beam.from);
        turn(pose, lifted, beam.to);
        turn(pose, c->up[i], beam.up);
        add_beam(model, &beam);
        add_clamp(model, names[i], 0, 0);
        add_clamp(model, names[i], 1, 0);
    }
    turn(pose, c->axis, joint.axis);
    turn(pose, c->second, joint.second);
    add_joint(model, &joint);
    turn(pose, c->force, F);
    add_force(model, "second", 0.75, F[0], F[1], F[2]);
    return model;
}

static const struct pose as_it_is = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/* v turned by the rotation vector w (Rodrigues). */
static void rotate(const double w[3], const double v[3], double to[3])
{
    const double angle = norm(w), along = angle > 0 ? dot3(w, v) / (angle * angle) : 0;
    double across[3];
    cross3(w, v, across);
    for (int a = 0; a < 3; a++)
        to[a] = angle > 0 ? cos(angle) * (v[a] - along * w[a]) + along * w[a] +
                                sin(angle) / angle * across[a]
                          : v[a];
}

/* How far one direction has turned from another. */
static double angle_between(const double a[3], const double b[3])
{
    double product[3];
    cross3(a, b, product);
    return atan2(norm(product), dot3(a, b));
}

/* The largest |Phi| of the ties in a solution. */
static double violation(const hobe_solution *solution)
{
    const hobe_model *model = solution->model;
    struct hobe_error err;
    double worst = 0, *r = hobe_alloc((size_t)(3 * model->vectors), sizeof *r, &err);
    constraint_add(model, solution->u, &AT_REST, r, NULL);
    for (long i = 3 * model->beam_vectors; i < 3 * model->vectors; i++)
        worst = fmax(worst, fabs(r[i]));
    hobe_free(r);
    return worst;
}

/* What kinds stop, in words of their own: translations along and across the axis; the axes of both
 * parts parallel; their sections turned alike. */
static const struct {
    int along, across, parallel, alike;
} stops[KINDS] = {[HOBE_JOINT_FIXED] = {1, 1, 1, 1},       [HOBE_JOINT_SPHERICAL] = {1, 1, 0, 0},
                  [HOBE_JOINT_REVOLUTE] = {1, 1, 1, 0},    [HOBE_JOINT_UNIVERSAL] = {1, 1, 0, 0},
                  [HOBE_JOINT_CYLINDRICAL] = {0, 1, 1, 0}, [HOBE_JOINT_PRISMATIC] = {0, 1, 1, 1},
                  [HOBE_JOINT_PLANAR] = {1, 0, 1, 0},      [HOBE_JOINT_INLINE] = {0, 1, 0, 0},
                  [HOBE_JOINT_INPLANE] = {1, 0, 0, 0},     [HOBE_JOINT_DISTANCE] = {0, 0, 0, 0}};

/* Where a joint stops a motion, a few strains of it are left, which turn directions of a section
 * against each other.  Where it does not, it may be as small as chance has it. */
static void check_motion(double motion, double strain, int stopped, const char *kind,
                         const char *what)
{
    if (stopped)
        check_absolute(motion, 0, strain, "%s: %s is stopped", kind, what);
    else
        check_that(motion > 1e-8, "%s: %s is free: %g", kind, what, motion);
}

/* Motions of the second part against the first. */
static void check_motions(const struct crossing *c, const hobe_solution *solution)
{
    const char *kind = hobe_joint_name(c->kind);
    const struct hobe_point a = point_of(solution, "first", 0.3, 0, 0);
    const struct hobe_point b = point_of(solution, "second", 0.6, 0, 0);
    const double axis[3] = {c->axis[0], c->axis[1], c->axis[2] + !has_axis(c->kind)};
    double on_a[3], on_b[3], d[3], across[3], second[3];
    rotate(a.rotation, axis, on_a);
    rotate(b.rotation, axis, on_b);
    for (int i = 0; i < 3; i++)
        d[i] = b.u[i] - a.u[i];
    const double along = dot3(d, on_a);
    for (int i = 0; i < 3; i++)
        across[i] = d[i] - along * on_a[i];
    if (c->kind == HOBE_JOINT_DISTANCE)
        check_relative(distance(a.r, b.r), 0.2, 1e-12, "the distance is kept");
    const double small = 2e-3; /* of the other motions, by the strains here */
    check_motion(fabs(along), 1e-12 + small * norm(across), stops[c->kind].along, kind, "sliding");
    check_motion(norm(across), 1e-12 + small * fabs(along), stops[c->kind].across, kind,
                 "moving across");
    check_motion(angle_between(on_a, on_b), 3e-4, stops[c->kind].parallel, kind, "tilting");
    check_motion(distance(a.rotation, b.rotation), 3e-4, stops[c->kind].alike, kind, "turning");
    if (c->kind == HOBE_JOINT_UNIVERSAL) {
        rotate(b.rotation, c->second, second);
        check_absolute(dot3(on_a, second) / norm(second), 0, 3e-4, "%s: the right angle", kind);
    }
}

static void forces_of_ties(const hobe_model *model, const double *u, double *r,
                           const struct matrix *K)
{
    constraint_add(model, u, &AT_REST, r, K);
}

/* The tangent at a random state; the same scene in two poses: motions, reactions, residuals. */
static void each_kind(enum hobe_joint_kind kind, const hobe_section *section)
{
    const char *name = hobe_joint_name(kind);
    const struct crossing c = random_crossing(kind);
    const struct pose pose = random_pose();
    hobe_model *model = crossing(&c, &as_it_is, section), *other = crossing(&c, &pose, section);
    check_tangent(model, forces_of_ties, 1, name);
    hobe_solution *solution = solve(model, 1), *turned = solve(other, 1);
    check_motions(&c, solution);
    check_absolute(violation(solution), 0, 1e-13, "%s: residual", name);
    const struct hobe_point tip = point_of(solution, "second", 0.75, 0, 0);
    const struct hobe_point far = point_of(turned, "second", 0.75, 0, 0);
    const struct hobe_reaction at = reaction_of(solution, "joint"),
                               to = reaction_of(turned, "joint");
    double u[3], F[3], M[3];
    turn(&pose, tip.u, u);
    turn(&pose, at.force, F);
    turn(&pose, at.moment, M);
    check_that(norm(tip.u) > 1e-5, "%s: it moves by %g m", name, norm(tip.u));
    check_absolute(distance(u, far.u), 0, 1e-9 * norm(u), "%s: displacement in a turned scene",
                   name);
    check_absolute(distance(F, to.force), 0, 1e-8 * norm(c.force), "%s: force likewise", name);
    check_absolute(distance(M, to.moment), 0, 1e-8 * norm(c.force), "%s: moment likewise", name);
    hobe_solution_free(solution);
    hobe_solution_free(turned);
    hobe_model_free(model);
    hobe_model_free(other);
}

static void all_kinds(void)
{
    hobe_section *section = rectangle(0.03, 0.03);
    for (int kind = 0; kind < KINDS; kind++)
        each_kind((enum hobe_joint_kind)kind, section);
    check_that(!hobe_joint_name((enum hobe_joint_kind)(HOBE_JOINT_RIGID + 1)),
               "there are no more kinds");
    hobe_section_free(section);
}

/* ---- other ways to the same ------------------------------------------------------------------ */

/* A fixed support is a clamp that leaves warping free; their reactions are those of the loads, for
 * any loads, about where the support is. */
static void fixed_and_clamped(void)
{
    const double F[3] = {3e3, 1e4, -2e4}, L = 2;
    hobe_section *section = rectangle(0.05, 0.1);
    struct hobe_beam beam = beam_along_x("MGD30w", 4, section, E, 0.3, L);
    hobe_model *model[2];
    hobe_solution *solution[2];
    for (int i = 0; i < 2; i++) {
        struct hobe_error err;
        const struct hobe_clamp clamp = {.beam = "beam", .name = "root", .free_warping = 1};
        model[i] = new_model();
        add_beam(model[i], &beam);
        if (i)
            add_support(model[i], "root", 0, HOBE_JOINT_FIXED, X);
        else if (hobe_model_clamp(model[i], &clamp, &err))
            check_stop("%s", err.message);
        add_force(model[i], "beam", 0.7, F[0], F[1], F[2]);
        solution[i] = solve(model[i], 1);
        const struct hobe_point p = point_of(solution[i], "beam", 0.7, 0, 0);
        const struct hobe_reaction root = reaction_of(solution[i], "root");
        double M[3];
        cross3(p.r, F, M);
        for (int a = 0; a < 3; a++) {
            check_absolute(root.force[a], -F[a], 1e-8 * norm(F), "%d: force %c", i, "xyz"[a]);
            check_absolute(root.moment[a], -M[a], 1e-8 * L * norm(F), "%d: moment %c", i, "xyz"[a]);
        }
    }
    const struct hobe_point a = point_of(solution[0], "beam", 1, 0, 0);
    const struct hobe_point b = point_of(solution[1], "beam", 1, 0, 0);
    /* the clamp stops the stretch of the section in its plane, too: Poisson strains of bending that
     * reach over a height */
    check_absolute(distance(a.u, b.u), 0, 5e-4 * norm(a.u), "clamped and fixed");
    for (int i = 0; i < 2; i++) {
        hobe_solution_free(solution[i]);
        hobe_model_free(model[i]);
    }
    hobe_section_free(section);
}

static enum hobe_status helix(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context;
    (void)err;
    r[0] = cos(2 * t);
    r[1] = sin(2 * t);
    r[2] = t;
    return HOBE_OK;
}

/* A support inside an element of a curved beam: it stays, and carries what the load asks for. */
static void on_a_curve(void)
{
    const double F[3] = {2e3, 1e3, -3e3}, at = 0.37;
    hobe_section *section = rectangle(0.05, 0.1);
    hobe_curve *curve = curve_of(helix, NULL, NULL);
    struct hobe_beam beam = beam_along_x("3433w", 5, section, E, 0.3, 1);
    hobe_model *model = new_model();
    beam.curve = curve;
    add_beam(model, &beam);
    add_support(model, "root", at, HOBE_JOINT_FIXED, X);
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point root = point_of(solution, "beam", at, 0, 0);
    const struct hobe_point p = point_of(solution, "beam", 1, 0, 0);
    const struct hobe_reaction is = reaction_of(solution, "root");
    const double arm[3] = {p.r[0] - root.r[0], p.r[1] - root.r[1], p.r[2] - root.r[2]};
    double M[3];
    cross3(arm, F, M);
    check_absolute(norm(root.u), 0, 1e-15, "the support on a curve stays");
    for (int a = 0; a < 3; a++) {
        check_absolute(is.force[a], -F[a], 1e-8 * norm(F), "on a curve: force %c", "xyz"[a]);
        check_absolute(is.moment[a], -M[a], 1e-8 * norm(F), "on a curve: moment %c", "xyz"[a]);
    }
    check_that(norm(p.u) > 0.01, "the end moves by %g m", norm(p.u));
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_curve_free(curve);
    hobe_section_free(section);
}

/* A frame whose corner is a join, or a fixed joint. */
static void corner_and_fixed(void)
{
    hobe_section *section = rectangle(0.05, 0.05);
    double u[2][3];
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x("MGD30w", 4, section, E, 0.3, 1);
        hobe_model *model = new_model();
        beam.name = "arm";
        add_beam(model, &beam);
        beam.name = "column";
        beam.from[0] = 1;
        beam.to[1] = 0.5;
        beam.to[2] = -1;
        add_beam(model, &beam);
        add_clamp(model, "column", 1, 0);
        if (i)
            add_joint(model, &(struct hobe_joint){.beam = {"column", "arm"}, .at = {0, 1}});
        else
            add_join(model, "column", 0, "arm", 1);
        add_force(model, "arm", 0, 3e3, 1e3, -2e3);
        hobe_solution *solution = solve(model, 1);
        memcpy(u[i], point_of(solution, "arm", 0, 0, 0).u, sizeof u[i]);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    check_absolute(distance(u[0], u[1]), 0, 1e-10 * norm(u[0]), "a join is a fixed joint");
    hobe_section_free(section);
}

/* ---- theory ---------------------------------------------------------------------------------- */

/* A beam on two supports: turning about x stops at the left end, sliding along it at the left. */
static hobe_model *simple_beam(const char *element, int elements, const hobe_section *section,
                               double length, double nu)
{
    struct hobe_beam beam = beam_along_x(element, elements, section, E, nu, length);
    hobe_model *model = new_model();
    beam.material.rho = 2700;
    add_beam(model, &beam);
    add_support(model, "left", 0, HOBE_JOINT_UNIVERSAL, Y);
    add_support(model, "right", 1, HOBE_JOINT_INLINE, X);
    return model;
}

/* A small force at a third: reactions by the lever, deflection there P a^2 b^2/(3 EI L) + P a b/(GA
 * L); cubic elements have both. */
static void simple_beam_bends(void)
{
    const double L = 1, a = L / 3, b = L - a, P = 1e-3, G = E / 2;
    hobe_section *section = rectangle(0.05, 0.1);
    const struct hobe_section_properties p = properties_of(section);
    hobe_model *model = simple_beam("3433", 3, section, L, 0);
    add_force(model, "beam", a / L, 0, 2 * P, -P);
    hobe_solution *solution = solve(model, 1);
    const double I[3] = {0, p.Izz, p.Iyy}, F[3] = {0, 2 * P, -P};
    const struct hobe_point at = point_of(solution, "beam", a / L, 0, 0);
    const struct hobe_reaction left = reaction_of(solution, "left");
    const struct hobe_reaction right = reaction_of(solution, "right");
    for (int i = 1; i < 3; i++) {
        check_relative(at.u[i], F[i] * (a * a * b * b / (3 * E * I[i]) + a * b / (G * p.A)) / L,
                       1e-8, "simple beam: deflection %c", "xyz"[i]);
        check_relative(left.force[i], -F[i] * b / L, 1e-8, "simple beam: left %c", "xyz"[i]);
        check_relative(right.force[i], -F[i] * a / L, 1e-8, "simple beam: right %c", "xyz"[i]);
    }
    check_absolute(norm(left.moment) + norm(right.moment), 0, 1e-8 * P * L, "and no moment");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* Lowest root omega^2 of Timoshenko's beam, k = 1, with n half waves:
 * (GA b^2 - m w)(EI b^2 + GA - J w) = (GA b)^2,  m = rho A, J = rho I, b = n pi/L. */
static double timoshenko(double EI, double GA, double m, double J, double b)
{
    const double p = m * (EI * b * b + GA) + J * GA * b * b, q = GA * EI * b * b * b * b;
    return 2 * q / (p + sqrt(p * p - 4 * m * J * q));
}

static void simple_beam_vibrates(void)
{
    const double L = 1, rho = 2700;
    hobe_section *section = rectangle(0.05, 0.1);
    const struct hobe_section_properties p = properties_of(section);
    hobe_model *model = simple_beam("3433", 24, section, L, 0);
    hobe_modes *modes = modes_of(model, NULL, 3, HOBE_MODAL_AUTO);
    const double GA = E / 2 * p.A, m = rho * p.A;
    const double expected[3] = {
        sqrt(timoshenko(E * p.Izz, GA, m, rho * p.Izz, PI / L)),
        sqrt(timoshenko(E * p.Iyy, GA, m, rho * p.Iyy, PI / L)),
        sqrt(timoshenko(E * p.Izz, GA, m, rho * p.Izz, 2 * PI / L)),
    };
    for (int i = 0; i < 3; i++) /* of the order (b h)^6 of a cubic element, h = L/24 */
        check_relative(mode_of(modes, i).omega, expected[i], 1e-6, "simple beam: frequency %d", i);
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A beam has as many modes as its vectors have components, less one for each constraint; nothing
 * else of the multipliers shows. */
static void modes_are_counted(void)
{
    struct hobe_error err;
    hobe_modes *modes;
    hobe_section *section = rectangle(0.05, 0.1);
    hobe_model *model = simple_beam("3433", 1, section, 1, 0);
    check_that(hobe_modal(model, NULL, &(struct hobe_modal_options){.modes = 31}, &modes, &err) ==
                       HOBE_BAD_INPUT &&
                   strstr(err.message, "from 1 to the 30 that"),
               "36 components, 6 constraints: %s", err.message);
    modes = modes_of(model, NULL, 29, HOBE_MODAL_AUTO);
    check_that(mode_of(modes, 28).omega > mode_of(modes, 0).omega, "29 of them are found");
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* Euler's loads of a hinged column, pi^2 EI/L^2 about both axes, to the order (h/L)^2. */
static void column_buckles(void)
{
    const double L = 1;
    struct hobe_error err;
    hobe_section *section = rectangle(0.005, 0.01);
    const struct hobe_section_properties p = properties_of(section);
    const double expected[3] = {PI * PI * E * p.Izz, 4 * PI * PI * E * p.Izz, PI * PI * E * p.Iyy};
    hobe_model *model = simple_beam("MGD30", 16, section, L, 0.3);
    hobe_modes *modes;
    add_force(model, "beam", 1, -1, 0, 0);
    if (hobe_buckling(model, NULL, &(struct hobe_modal_options){.modes = 3}, &modes, &err))
        check_stop("%s", err.message);
    for (int i = 0; i < 3; i++) /* the second and third are one where h = 2 w */
        check_relative(hobe_modes_factor(modes, i), expected[i], 1e-3, "hinged column: load %d", i);
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A column whose top is guided moves across by P L^3/(12 EI) + P L/GA and keeps its direction, with
 * the moment P L/2 at both ends. */
static void guided_column(void)
{
    const double L = 1, P = 1e-3, G = E / 2;
    hobe_section *section = rectangle(0.05, 0.1);
    const struct hobe_section_properties p = properties_of(section);
    const struct hobe_beam beam = beam_along_x("3433", 2, section, E, 0, L);
    hobe_model *model = cantilever(&beam, 1);
    add_support(model, "guide", 1, HOBE_JOINT_PRISMATIC, Z);
    add_force(model, "beam", 1, 0, 0, -P);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
    const struct hobe_reaction guide = reaction_of(solution, "guide");
    check_relative(tip.u[2], -P * (L * L * L / (12 * E * p.Iyy) + L / (G * p.A)), 1e-8, "guided");
    check_relative(guide.moment[1], -P * L / 2, 1e-8, "the guide's moment");
    check_absolute(guide.force[2], 0, 1e-8 * P, "and no force along it");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* Two bars lean on each other, hinged at their feet and at the top: an arch with three hinges,
 * whose reactions follow from moments about them where it is now, however it is loaded. */
static void three_hinges(void)
{
    static const double top[3] = {1, 0, 0.4}, foot[2][3] = {{0}, {1.7, 0, 0.1}};
    static const char *const names[2] = {"left", "right"};
    const double F[3] = {2e3, 0, -9e3}, at = 0.4;
    hobe_section *section = rectangle(0.04, 0.03);
    hobe_model *model = new_model();
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x(i ? "3333w" : "MGD30w", 5, section, E, 0.3, 1);
        beam.name = names[i];
        memcpy(beam.from, foot[i], sizeof beam.from);
        memcpy(beam.to, top, sizeof beam.to);
        add_beam(model, &beam);
        add_joint(model, &(struct hobe_joint){.beam = {names[i]},
                                              .name = names[i],
                                              .kind = HOBE_JOINT_REVOLUTE,
                                              .axis = {0, 1, 0}});
    }
    add_joint(model, &(struct hobe_joint){.beam = {"left", "right"},
                                          .name = "crown",
                                          .at = {1, 1},
                                          .kind = HOBE_JOINT_REVOLUTE,
                                          .axis = {0, -2, 0}});
    add_force(model, "left", at, F[0], F[1], F[2]);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point p = point_of(solution, "left", at, 0, 0);
    const struct hobe_point crown = point_of(solution, "right", 1, 0, 0);
    const struct hobe_reaction left = reaction_of(solution, "left");
    const struct hobe_reaction right = reaction_of(solution, "right");
    const struct hobe_reaction hinge = reaction_of(solution, "crown");
    double sum[3], M[3], lever[3], line[3], along[3];
    for (int a = 0; a < 3; a++) {
        sum[a] = left.force[a] + right.force[a] + F[a];
        lever[a] = foot[1][a];
        line[a] = crown.r[a] - foot[1][a];
    }
    check_absolute(norm(sum), 0, 1e-8 * norm(F), "three hinges: forces");
    cross3(lever, right.force, M);
    cross3(p.r, F, sum);
    check_absolute(M[1] + sum[1], 0, 1e-8 * norm(F), "three hinges: moments about the left foot");
    cross3(line, right.force, along);
    check_absolute(norm(along), 0, 1e-8 * norm(F), "the unloaded bar's force lies along it");
    check_absolute(distance(hinge.force, right.force) - 2 * norm(hinge.force), 0, 1e-8 * norm(F),
                   "and goes through the crown");
    check_absolute(fabs(left.moment[1]) + fabs(right.moment[1]) + fabs(hinge.moment[1]), 0,
                   1e-8 * norm(F), "hinges carry no moment about their axes");
    check_that(fabs(crown.u[2]) > 1e-4, "the crown moves by %g m", crown.u[2]);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A bar hangs from a rod to a point of the ground, and turns about its other end: the rod pulls
 * along its line with what moments about that end ask for, far from where it was. */
static void rod_to_the_ground(void)
{
    const double top[3] = {0.7, 0, 1.1}, F[3] = {4e3, 0, -1e4}, at = 0.75;
    hobe_section *section = rectangle(0.02, 0.02);
    const struct hobe_beam beam = beam_along_x("MGD30w", 6, section, E, 0.3, 1);
    hobe_model *model = new_model();
    add_beam(model, &beam);
    add_support(model, "hinge", 0, HOBE_JOINT_REVOLUTE, Y);
    add_joint(model, &(struct hobe_joint){.beam = {"beam"},
                                          .name = "rod",
                                          .at = {1},
                                          .kind = HOBE_JOINT_DISTANCE,
                                          .to = {top[0], top[1], top[2]}});
    add_force(model, "beam", at, F[0], F[1], F[2]);
    hobe_solution *solution = solve(model, 2);
    const struct hobe_point p = point_of(solution, "beam", at, 0, 0);
    const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
    const struct hobe_reaction rod = reaction_of(solution, "rod");
    const double line[3] = {top[0] - tip.r[0], top[1] - tip.r[1], top[2] - tip.r[2]};
    double across[3], M[3], of_rod[3];
    check_relative(norm(line), hypot(0.3, 1.1), 1e-12, "the rod keeps its length");
    cross3(line, rod.force, across);
    check_absolute(norm(across), 0, 1e-8 * norm(F), "the rod pulls along its line");
    cross3(p.r, F, M);
    cross3(tip.r, rod.force, of_rod);
    check_absolute(M[1] + of_rod[1], 0, 1e-8 * norm(F), "moments about the hinge");
    check_that(norm(tip.u) > 0.02, "the tip moves by %g m", norm(tip.u));
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- too few and too many -------------------------------------------------------------------- */

static void check_sentence(hobe_model *model, enum hobe_status status, const char *words)
{
    struct hobe_error err = {0};
    hobe_solution *solution;
    check_that(hobe_static(model, &(struct hobe_newton){0}, &solution, &err) == status &&
                   strstr(err.message, words),
               "\"%s\" is said: %s", words, err.message);
    hobe_model_free(model);
}

static hobe_model *bar(const hobe_section *section)
{
    const struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    hobe_model *model = new_model();
    add_beam(model, &beam);
    return model;
}

static void too_few(const hobe_section *section)
{
    hobe_model *model = bar(section);
    add_support(model, NULL, 0, HOBE_JOINT_SPHERICAL, X);
    add_support(model, NULL, 1, HOBE_JOINT_SPHERICAL, X);
    check_sentence(model, HOBE_UNCONSTRAINED, "\"beam\" is free to move: rotation about x; hold");
    model = bar(section);
    add_support(model, NULL, 0, HOBE_JOINT_UNIVERSAL, Y);
    check_sentence(model, HOBE_UNCONSTRAINED, "is free to move: rotations about y, z;");
    model = bar(section);
    add_support(model, NULL, 0.25, HOBE_JOINT_PRISMATIC, X);
    check_sentence(model, HOBE_UNCONSTRAINED, "is free to move: translation along x;");
    /* a bar hangs on another by a hinge */
    model = bar(section);
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    beam.name = "pendulum";
    beam.from[0] = 1;
    beam.to[2] = -1;
    add_beam(model, &beam);
    add_clamp(model, "beam", 0, 0);
    add_joint(model, &(struct hobe_joint){.beam = {"beam", "pendulum"},
                                          .at = {1, 0},
                                          .kind = HOBE_JOINT_REVOLUTE,
                                          .axis = {0, 1, 0}});
    check_sentence(model, HOBE_UNCONSTRAINED, "\"pendulum\" is free to move: rotation about y;");
}

static void too_many(const hobe_section *section)
{
    hobe_model *model = bar(section);
    add_clamp(model, "beam", 0, 0);
    add_support(model, "pin", 0, HOBE_JOINT_INPLANE, Z);
    check_sentence(model, HOBE_BAD_INPUT, "the joint \"pin\" of beam \"beam\" at 0 stops motions");
    model = bar(section);
    add_support(model, NULL, 0.4, HOBE_JOINT_FIXED, X);
    add_support(model, NULL, 0.4, HOBE_JOINT_REVOLUTE, Y);
    check_sentence(model, HOBE_BAD_INPUT, "the joint of beam \"beam\" at 0.4 stops motions");
    model = bar(section);
    for (int i = 0; i < 4; i++) /* more than the three positions that shape an element's axis */
        add_support(model, NULL, 0.1 * (i + 1), HOBE_JOINT_FIXED, X);
    check_sentence(model, HOBE_BAD_INPUT, "stops motions that clamps or joints before it stop");
}

static void refuse(const struct hobe_joint *joint, const char *words)
{
    struct hobe_error err = {0};
    hobe_section *section = rectangle(0.1, 0.1);
    hobe_model *model = bar(section);
    check_that((hobe_model_joint(model, joint, &err) || hobe_model_build(model, &err)) &&
                   strstr(err.message, words),
               "\"%s\" is said: %s", words, err.message);
    hobe_model_free(model);
    hobe_section_free(section);
}

static void refused(void)
{
    refuse(&(struct hobe_joint){.beam = {"beam"}, .at = {2}}, "at must be a fraction");
    refuse(&(struct hobe_joint){.beam = {"bean"}}, "there is no beam \"bean\"");
    refuse(&(struct hobe_joint){.beam = {"beam"}, .axis = {1, 0, 0}}, "has no axis");
    refuse(&(struct hobe_joint){.beam = {"beam"}, .kind = HOBE_JOINT_REVOLUTE}, "needs axis");
    refuse(&(struct hobe_joint){.beam = {"beam"},
                                .kind = (enum hobe_joint_kind)(HOBE_JOINT_RIGID + 1)},
           "no kind of joint 11");
    refuse(&(struct hobe_joint){.beam = {"beam"}, .kind = HOBE_JOINT_DISTANCE}, "needs places");
    refuse(&(struct hobe_joint){.beam = {"beam", "beam"}, .at = {0, 0.5}}, "are 0.5 m apart");
    refuse(
        &(struct hobe_joint){
            .beam = {"beam"}, .kind = HOBE_JOINT_UNIVERSAL, .axis = {1, 0, 0}, .second = {1, 1, 0}},
        "must be at a right angle");
}

static void names(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_reaction reaction;
    hobe_model *model = bar(section);
    const struct hobe_clamp clamp = {.beam = "beam", .name = "root"};
    check_that(!hobe_model_clamp(model, &clamp, &err), "a clamp with a name");
    check_that(hobe_model_clamp(model, &clamp, &err) == HOBE_BAD_INPUT &&
                   strstr(err.message, "two supports or joints \"root\""),
               "a name twice: %s", err.message);
    add_support(model, "end", 1, HOBE_JOINT_INPLANE, Z);
    hobe_solution *solution = solve(model, 1);
    check_that(hobe_solution_reaction(solution, "roof", &reaction, &err) == HOBE_UNKNOWN &&
                   strstr(err.message, "are: \"root\", \"end\""),
               "an unknown name: %s", err.message);
    hobe_solution_free(solution);
    hobe_model_free(model);
}

int main(void)
{
    random_start();
    all_kinds();
    fixed_and_clamped();
    on_a_curve();
    corner_and_fixed();
    simple_beam_bends();
    simple_beam_vibrates();
    modes_are_counted();
    column_buckles();
    guided_column();
    three_hinges();
    rod_to_the_ground();
    hobe_section *section = rectangle(0.1, 0.1);
    too_few(section);
    too_many(section);
    refused();
    names(section);
    hobe_section_free(section);
    return check_report();
}
