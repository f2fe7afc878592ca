/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several beams in a scene: joined end to end, of different elements, and at rigid corners.
 * Looks into the core (constraint.h) for the corners' tangent. */
#include "check.h"
#include "constraint.h"
#include "scene.h"
#include "tangent.h"

#include <math.h>
#include <stdio.h>

static const double E = 70e9, NU = 0.33;

static struct hobe_beam named(struct hobe_beam beam, const char *name, const double from[3],
                              const double to[3])
{
    beam.name = name;
    for (int a = 0; a < 3; a++) {
        beam.from[a] = from[a];
        beam.to[a] = to[a];
    }
    return beam;
}

/* The tip of one beam of 2n elements and of two beams of n, under a large load that twists. */
static void two_make_one(const char *element)
{
    enum { HALF = 3 };
    const double L = 3, mid[3] = {L / 2, 0, 0}, start[3] = {0}, end[3] = {L, 0, 0};
    const double F[3] = {2e4, 4e4, -8e4};
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_beam whole = beam_along_x(element, 2 * HALF, section, E, NU, L);
    struct hobe_beam half = beam_along_x(element, HALF, section, E, NU, L / 2);
    hobe_model *one = cantilever(&whole, 0), *two = new_model();
    add_force(one, "beam", 1, F[0], F[1], F[2]);
    half = named(half, "outer", mid, end); /* the order of beams and of ends is free */
    add_beam(two, &half);
    half = named(half, "inner", start, mid);
    add_beam(two, &half);
    add_join(two, "outer", 0, "inner", 1);
    add_clamp(two, "inner", 0, 0);
    add_force(two, "outer", 1, F[0], F[1], F[2]);
    hobe_solution *a = solve(one, 1), *b = solve(two, 1);
    const struct hobe_point tip[2] = {point_of(a, "beam", 1, 0, 0), point_of(b, "outer", 1, 0, 0)};
    const double size = norm(tip[0].u);
    check_absolute(distance(tip[0].u, tip[1].u), 0, 1e-9 * size, "%s: two beams are one", element);
    check_absolute(tip[1].twist, tip[0].twist, 1e-9, "%s: twist of two beams", element);
    const struct hobe_point at[2] = {point_of(b, "inner", 1, 0.05, 0.1),
                                     point_of(b, "outer", 0, 0.05, 0.1)};
    check_absolute(distance(at[0].u, at[1].u), 0, 1e-15, "%s: the joint holds together", element);
    struct hobe_model_info info[2];
    hobe_model_info(one, info);
    hobe_model_info(two, info + 1);
    check_that(info[0].unknowns == info[1].unknowns && info[0].nonzeros == info[1].nonzeros,
               "%s: as many unknowns: %ld and %ld", element, info[0].unknowns, info[1].unknowns);
    check_relative(info_of(b).energy, info_of(a).energy, 1e-9, "%s: energy of two beams", element);
    hobe_solution_free(a);
    hobe_solution_free(b);
    hobe_model_free(one);
    hobe_model_free(two);
    hobe_section_free(section);
}

/* A cantilever of two kinds of element under a small tip force is exactly Timoshenko's, since each
 * kind holds his solution and position and slopes go through the joint. */
static void two_kinds(const char *first, const char *second, double tolerance)
{
    const double L = 2, P = 1, mid[3] = {0.75, 0, 0}, start[3] = {0}, end[3] = {L, 0, 0};
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_section_properties p = properties_of(section);
    struct hobe_beam beam = beam_along_x(first, 2, section, E, NU, L);
    hobe_model *model = new_model();
    beam = named(beam, "a", start, mid);
    add_beam(model, &beam);
    beam = named(beam_along_x(second, 3, section, E, NU, L), "b", mid, end);
    add_beam(model, &beam);
    add_clamp(model, "a", 0, 0);
    add_join(model, "a", 1, "b", 0);
    add_force(model, "b", 1, 0, 0, -P);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point tip = point_of(solution, "b", 1, 0, 0);
    const double GA = E / (2 * (1 + NU)) * p.A;
    check_relative(-tip.u[2], P * L * L * L / (3 * E * p.Iyy) + P * L / GA, tolerance,
                   "%s joined to %s", first, second);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* Two materials in a row: each half keeps its own. */
static void two_materials(void)
{
    const double L = 1, P = 1, A = 0.02, mid[3] = {L, 0, 0}, start[3] = {0}, end[3] = {2 * L, 0, 0};
    hobe_section *section = rectangle(0.1, 0.2);
    hobe_model *model = new_model();
    struct hobe_beam beam = named(beam_along_x("3433", 2, section, E, 0, L), "soft", start, mid);
    add_beam(model, &beam);
    beam = named(beam_along_x("3433", 2, section, 3 * E, 0, L), "stiff", mid, end);
    add_beam(model, &beam);
    add_join(model, "soft", 1, "stiff", 0);
    add_clamp(model, "soft", 0, 0);
    add_force(model, "stiff", 1, P, 0, 0);
    hobe_solution *solution = solve(model, 1);
    check_relative(point_of(solution, "stiff", 1, 0, 0).u[0], P * L / A * (1 / E + 1 / (3 * E)),
                   1e-8, "two materials in tension");
    check_relative(point_of(solution, "soft", 0.3, 0, 0).strain[0], P / (E * A), 1e-8,
                   "strain of the soft half");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- corners
 * --------------------------------------------------------------------------------------- */

/* An angle bracket: a column of height h up from a clamp, an arm of length l from its top along x;
 * ends of the arm to choose. */
struct bracket {
    double height, length;
    const char *column, *arm;
    int elements, reversed;
};

static hobe_model *bracket(const struct bracket *b, const hobe_section *section)
{
    const double foot[3] = {0}, top[3] = {0, 0, b->height}, tip[3] = {b->length, 0, b->height};
    struct hobe_beam beam = beam_along_x(b->column, b->elements, section, E, NU, 1);
    hobe_model *model = new_model();
    beam = named(beam, "column", foot, top);
    add_beam(model, &beam);
    beam = named(beam_along_x(b->arm, b->elements, section, E, NU, 1), "arm",
                 b->reversed ? tip : top, b->reversed ? top : tip);
    add_beam(model, &beam);
    add_join(model, "column", 1, "arm", b->reversed ? 1 : 0);
    add_clamp(model, "column", 0, 1);
    return model;
}

/* Two beams that meet at any angle, their sections turned anyhow. */
static hobe_model *random_corner(const hobe_section *section)
{
    const double origin[3] = {0};
    double end[2][3];
    hobe_model *model = new_model();
    for (int i = 0; i < 2; i++) {
        random_direction(end[i]);
        struct hobe_beam beam = named(beam_along_x("MGD30w", 2, section, E, NU, 1),
                                      i ? "second" : "first", i ? end[0] : origin, end[0]);
        for (int a = 0; a < 3; a++) {
            beam.to[a] += i ? end[1][a] : 0;
            beam.up[a] = random_real(-1, 1);
        }
        add_beam(model, &beam);
    }
    add_join(model, "first", 1, "second", 0);
    add_clamp(model, "first", 0, 0);
    return model;
}

static void forces_of_ties(const hobe_model *model, const double *u, double *r,
                           const struct matrix *K)
{
    constraint_add(model, u, &AT_REST, r, K);
}

/* The multipliers' energy lambda . Phi has its tangent; and a small force turns both sections
 * alike. */
static void random_corners(void)
{
    hobe_section *section = rectangle(0.1, 0.1);
    for (int i = 0; i < 6; i++) {
        hobe_model *model = random_corner(section);
        double F[3];
        random_direction(F);
        add_force(model, "second", 1, F[0], F[1], F[2]);
        check_tangent(model, forces_of_ties, 1, "corner");
        hobe_solution *solution = solve(model, 1);
        const struct hobe_point a = point_of(solution, "first", 1, 0, 0);
        const struct hobe_point b = point_of(solution, "second", 0, 0, 0);
        /* but for the sections' own shear in their planes */
        check_absolute(distance(a.rotation, b.rotation), 0, 0.02 * norm(a.rotation),
                       "the corner stays rigid");
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* Small loads on the bracket, against beam theory: a force F at the tip turns the corner by
 * (h, l) = height, length:
 *     F_z: bending of arm and column,  u_z = F (l^3/3 + l^2 h)/EIyy + F l/GA + F h/EA,
 *     F_y: bending of the arm and torsion and bending of the column,
 *          u_y = F (l^3 + h^3)/(3 EIzz) + F (l + h)/GA + F l^2 h/(G J).
 * The column's z axis is -X for a beam along +Z, its y axis Y, so that both bend alike.  The foot
 * is free to warp, as both ends are at the corner, so that torsion is Saint-Venant's. */
static void bracket_in_theory(const struct bracket *b)
{
    hobe_section *section = rectangle(0.1, 0.2);
    const struct hobe_section_properties p = properties_of(section);
    const double h = b->height, l = b->length, F = 1e-2, G = E / (2 * (1 + NU)), GA = G * p.A;
    for (int axis = 1; axis < 3; axis++) {
        hobe_model *model = bracket(b, section);
        add_force(model, "arm", b->reversed ? 0 : 1, 0, axis == 1 ? F : 0, axis == 2 ? F : 0);
        hobe_solution *solution = solve(model, 1);
        const struct hobe_point tip = point_of(solution, "arm", b->reversed ? 0 : 1, 0, 0);
        const struct hobe_point corner = point_of(solution, "column", 1, 0, 0);
        const struct hobe_point start = point_of(solution, "arm", b->reversed ? 1 : 0, 0, 0);
        const double bend_y = F * (l * l * l / 3 + l * l * h) / (E * p.Iyy) + F * l / GA;
        const double bend_z = F * (l * l * l + h * h * h) / (3 * E * p.Izz) + F * (l + h) / GA;
        const double exact =
            axis == 2 ? bend_y + F * h / (E * p.A) : bend_z + F * l * l * h / (G * p.J);
        /* round-off times the tangent's condition; and the foot does not let a pressed column
         * swell, a hundred thousandth of the whole */
        check_relative(tip.u[axis], exact, axis == 2 ? 2e-5 : 1e-8, "bracket of %s and %s: u%c",
                       b->column, b->arm, "xyz"[axis]);
        /* bending and torsion pass the corner as they are */
        check_absolute(distance(corner.rotation, start.rotation), 0, 1e-8 * norm(corner.rotation),
                       "bracket of %s and %s: the corner stays rigid", b->column, b->arm);
        check_absolute(distance(corner.u, start.u), 0, 1e-18, "the corner holds together");
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* Far from rest too, and Newton finds it: the corner does not open when the arm hangs down. */
static void bracket_far_from_rest(const struct bracket *b)
{
    hobe_section *section = rectangle(0.02, 0.02);
    hobe_model *model = bracket(b, section);
    add_force(model, "arm", b->reversed ? 0 : 1, 100, 150, -400);
    hobe_solution *solution = solve(model, 4);
    const struct hobe_point corner = point_of(solution, "column", 1, 0, 0);
    const struct hobe_point start = point_of(solution, "arm", b->reversed ? 1 : 0, 0, 0);
    printf("bracket of %s and %s: corner turned by (%.4f, %.4f, %.4f) rad\n", b->column, b->arm,
           corner.rotation[0], corner.rotation[1], corner.rotation[2]);
    check_that(norm(corner.rotation) > 0.3, "the corner turns far");
    /* Phi vanishes for the mean axes of a section; `rotation` takes the normal first, so that shear
     * (1e-4 here) may differ */
    check_absolute(distance(corner.rotation, start.rotation), 0, 1e-3, "the corner stays rigid");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A straight beam whose second half has its section turned about the axis by a quarter: with a
 * square section it is the same beam, and the joint a corner of multipliers. */
static void corner_in_a_straight_beam(void)
{
    const double L = 2, F[3] = {1e3, 3e3, -2e3};
    const double mid[3] = {L / 2, 0, 0}, start[3] = {0}, end[3] = {L, 0, 0};
    hobe_section *section = rectangle(0.1, 0.1);
    const struct hobe_beam whole = beam_along_x("MGD30", 8, section, E, 0, L);
    hobe_model *one = cantilever(&whole, 0), *two = new_model();
    add_force(one, "beam", 1, F[0], F[1], F[2]);
    struct hobe_beam half = named(beam_along_x("MGD30", 4, section, E, 0, L), "a", start, mid);
    add_beam(two, &half);
    half = named(half, "b", mid, end);
    half.up[1] = 1;
    add_beam(two, &half);
    add_join(two, "a", 1, "b", 0);
    add_clamp(two, "a", 0, 0);
    add_force(two, "b", 1, F[0], F[1], F[2]);
    hobe_solution *a = solve(one, 1), *b = solve(two, 1);
    const struct hobe_point tip[2] = {point_of(a, "beam", 1, 0, 0), point_of(b, "b", 1, 0, 0)};
    /* the slope r_x and the sections' stretch and shear do not go through a corner */
    check_absolute(distance(tip[0].u, tip[1].u), 0, 1e-4 * norm(tip[0].u),
                   "a section turned by a quarter");
    hobe_solution_free(a);
    hobe_solution_free(b);
    hobe_model_free(one);
    hobe_model_free(two);
    hobe_section_free(section);
}

/* A clamp at the corner holds one beam's slopes, and through the corner the other's. */
static void clamp_at_the_corner(void)
{
    const double L = 1, foot[3] = {0}, top[3] = {0, 0, L}, tip[3] = {L, 0, 0}, P = 1;
    hobe_section *section = rectangle(0.1, 0.1);
    const double EI = E * properties_of(section).Iyy, GA = E / (2 * (1 + NU)) * 0.01;
    hobe_model *model = new_model();
    struct hobe_beam beam = named(beam_along_x("MGD30", 2, section, E, NU, L), "column", foot, top);
    add_beam(model, &beam);
    beam = named(beam, "arm", foot, tip);
    add_beam(model, &beam);
    add_join(model, "column", 0, "arm", 0);
    add_clamp(model, "column", 0, 0);
    add_force(model, "arm", 1, 0, 0, -P);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point p = point_of(solution, "arm", 1, 0, 0);
    check_relative(-p.u[2], P * L * L * L / (3 * EI) + P * L / GA, 1e-8,
                   "clamped through a corner");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* Clamped at both ends of the joint, the corner has nothing to do. */
static void corner_that_is_held(void)
{
    const double L = 1, foot[3] = {0}, top[3] = {0, 0, L}, tip[3] = {L, 0, 0};
    hobe_section *section = rectangle(0.1, 0.1);
    hobe_model *model = new_model();
    struct hobe_beam beam = named(beam_along_x("MGD30", 2, section, E, NU, L), "column", foot, top);
    struct hobe_error err = {0};
    hobe_solution *solution = NULL;
    add_beam(model, &beam);
    beam = named(beam, "arm", foot, tip);
    add_beam(model, &beam);
    add_join(model, "column", 0, "arm", 0);
    add_clamp(model, "column", 0, 0);
    add_clamp(model, "arm", 0, 0);
    add_force(model, "arm", 1, 0, 0, -1);
    check_that(!hobe_static(model, &(struct hobe_newton){0}, &solution, &err),
               "a corner held on both sides: %s", err.message);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A closed square of four beams, clamped at a corner and pulled along its diagonal: it solves, and
 * is symmetric about the diagonal as far as the clamp is, which holds one beam's slopes and through
 * the corner the other's mean rotation. */
static void closed_frame(void)
{
    static const double at[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    static const char *const names[] = {"south", "east", "north", "west"};
    hobe_section *section = rectangle(0.05, 0.05);
    hobe_model *model = new_model();
    for (int i = 0; i < 4; i++) {
        const struct hobe_beam beam =
            named(beam_along_x("3433", 4, section, E, NU, 1), names[i], at[i], at[(i + 1) % 4]);
        add_beam(model, &beam);
    }
    for (int i = 0; i < 4; i++)
        add_join(model, names[i], 1, names[(i + 1) % 4], 0);
    add_clamp(model, "south", 0, 0);
    add_force(model, "east", 1, 1, 0, 1);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point far = point_of(solution, "east", 1, 0, 0);
    const struct hobe_point east = point_of(solution, "south", 1, 0, 0);
    const struct hobe_point west = point_of(solution, "west", 0, 0, 0);
    check_relative(far.u[0], far.u[2], 1e-3, "a square frame pulled along its diagonal");
    check_relative(east.u[2], west.u[0], 1e-3, "symmetry of the frame");
    check_that(far.u[0] > 0 && east.u[2] > 0 && west.u[0] > 0, "the square becomes a lozenge");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    two_make_one("MGD30w");
    two_make_one("3433w");
    two_make_one("BE42");
    two_kinds("3433w", "MGD30w", 1e-8); /* round-off times the tangent's condition */
    two_kinds("3433", "MGD30", 1e-8);
    /* a full clamp holds MGD30's slope r_x too, and with it the shear at the clamp: up to an eighth
     * of the share of one element in the shear's deflection, here 1.2 % of the whole */
    two_kinds("MGD30w", "3433w", 3e-4);
    two_materials();
    const struct bracket brackets[] = {
        {2, 1.5, "MGD30w", "MGD30w", 4, 0},
        {2, 1.5, "MGD30w", "3433w", 4, 1},
    };
    for (int i = 0; i < 2; i++) {
        bracket_in_theory(brackets + i);
        bracket_far_from_rest(brackets + i);
    }
    random_corners();
    corner_in_a_straight_beam();
    clamp_at_the_corner();
    corner_that_is_held();
    closed_frame();
    return check_report();
}
