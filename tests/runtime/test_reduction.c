/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reduced models against the whole ones.  With all unknowns in the basis both are the same,
 * whatever acts on them: at rest, vibrating, and in motion. */
#include "assemble.h"
#include "check.h"
#include "modes.h"
#include "reduction.h"
#include "scene.h"
#include "solution.h"
#include "vector3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of displacements, velocities and frequencies, relative: what is left of Newton's iterations and
 * of sums in another order.  Where a hinge lets a beam turn as a whole, in fields that are fixed,
 * strains of (0.1 rad)^2/2 cancel, which are 1e4 times those of the loads, and velocities, from
 * displacements over steps of 5 ms, feel 400 times what is left. */
static const double SAME = 1e-9, SAME_TURNED = 1e-7;
static double same; /* that of the scene */

static void expect_ok(enum hobe_status status, const struct hobe_error *err)
{
    if (status)
        check_stop("%s", err->message);
}

/* ---- bases ----------------------------------------------------------------------------------- */

/* As many fields as the beams have unknowns, random ones: [*count][vectors][3]. */
static double *all_fields(const hobe_model *model, int *count)
{
    const long size = 3 * model->vectors;
    *count = 0;
    for (long v = 0; v < model->beam_vectors; v++)
        *count += 3 * (model->unknown[v] >= 0);
    double *field = calloc((size_t)(*count * size), sizeof *field);
    long j = 0;
    for (long v = 0; v < model->beam_vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++, j++)
            for (long w = 0; w < model->beam_vectors; w++)
                for (int c = 0; c < 3 && model->unknown[w] >= 0; c++)
                    field[j * size + 3 * w + c] =
                        (v == w && a == c ? 3 : 0) + random_real(-0.1, 0.1);
    for (j = 0; j < *count; j++) /* joined vectors move together */
        for (long v = 0; v < model->beam_vectors; v++)
            memcpy(field + j * size + 3 * v, field + j * size + 3 * model->alias[v],
                   3 * sizeof *field);
    return field;
}

static hobe_reduced *reduce(hobe_model *model, const struct hobe_reduce *options)
{
    struct hobe_error err;
    hobe_reduced *reduced;
    expect_ok(hobe_reduce(model, options, &reduced, &err), &err);
    return reduced;
}

static hobe_model *small_of(const hobe_reduced *reduced, hobe_model *model)
{
    struct hobe_error err;
    hobe_model *small;
    expect_ok(hobe_reduced_model(reduced, model, &small, &err), &err);
    return small;
}

/* A basis of all unknowns. */
static hobe_reduced *keep_all(hobe_model *model)
{
    struct hobe_error err;
    struct hobe_reduce options = {.method = HOBE_REDUCE_FIELDS};
    struct hobe_reduced_info info;
    expect_ok(hobe_model_build(model, &err), &err);
    double *field = all_fields(model, &options.fields);
    options.field = field;
    hobe_reduced *reduced = reduce(model, &options);
    hobe_reduced_info(reduced, &info);
    check_that(info.unknowns == options.fields, "%d of %d fields are kept", info.unknowns,
               options.fields);
    free(field);
    return reduced;
}

/* ---- what is compared ------------------------------------------------------------------------ */

/* Two fields of the same model, relative to the larger one. */
static void same_field(const hobe_model *model, const double *a, const double *b, const char *what)
{
    double size = 0, apart = 0;
    for (long i = 0; i < 3 * model->moving; i++) {
        size = fmax(size, fabs(a[i]));
        apart = fmax(apart, fabs(a[i] - b[i]));
    }
    check_that(apart <= same * size, "%s: %g apart of %g", what, apart, size);
}

/* To a residual of 1e-11: projected sums round more than those of elements. */
static hobe_solution *rest(hobe_model *model)
{
    struct hobe_error err;
    hobe_solution *solution;
    const struct hobe_newton options = {.steps = 4, .tolerance = 1e-11};
    expect_ok(hobe_static(model, &options, &solution, &err), &err);
    return solution;
}

static void same_at_rest(hobe_model *whole, hobe_model *small, const char *what)
{
    hobe_solution *a = rest(whole), *b = rest(small);
    same_field(a->model, a->u, b->u, what);
    check_relative(info_of(b).energy, info_of(a).energy, 10 * same, "%s: energy", what);
    check_relative(info_of(b).smallest_volume, info_of(a).smallest_volume, same, "%s: volume",
                   what);
    hobe_solution_free(a);
    hobe_solution_free(b);
}

static void same_modes(hobe_model *whole, hobe_model *small, int loaded, const char *what)
{
    enum { MODES = 4 };
    hobe_solution *state[2] = {loaded ? rest(whole) : NULL, loaded ? rest(small) : NULL};
    hobe_modes *a = modes_of(whole, state[0], MODES, HOBE_MODAL_AUTO);
    hobe_modes *b = modes_of(small, state[1], MODES, HOBE_MODAL_AUTO);
    check_relative(modes_info(b).mass, modes_info(a).mass, same, "%s: mass", what);
    for (int i = 0; i < MODES; i++)
        check_relative(mode_of(b, i).omega2, mode_of(a, i).omega2, 10 * same, "%s: mode %d", what,
                       i);
    hobe_modes_free(a);
    hobe_modes_free(b);
    hobe_solution_free(state[0]);
    hobe_solution_free(state[1]);
}

static hobe_history *move(hobe_model *model, double to, int steps)
{
    struct hobe_error err;
    hobe_history *history;
    const struct hobe_dynamic options = {
        .to = to, .step = to / steps, .store = to, .tolerance = 1e-12};
    expect_ok(hobe_dynamic(model, &options, &history, &err), &err);
    return history;
}

/* Energies and momenta, relative to the larger of kinetic and strain energy, and to size m v. */
static void same_energies(const struct hobe_energies *a, const struct hobe_energies *b,
                          const char *what)
{
    const double size = fmax(a->kinetic, a->strain);
    const double x[] = {a->kinetic, a->strain, a->loads, a->drives, a->damped};
    const double y[] = {b->kinetic, b->strain, b->loads, b->drives, b->damped};
    for (size_t i = 0; i < sizeof x / sizeof *x; i++)
        check_absolute(y[i], x[i], 10 * same * size, "%s: energy %d", what, (int)i);
    for (int i = 0; i < 3; i++) {
        check_absolute(b->momentum[i], a->momentum[i], same * norm(a->momentum), "%s: momentum",
                       what);
        check_absolute(b->angular_momentum[i], a->angular_momentum[i],
                       same * norm(a->angular_momentum), "%s: angular momentum", what);
    }
    check_absolute(b->violation, a->violation, same, "%s: constraints", what);
    check_absolute(b->violation_rate, a->violation_rate, 1e-6, /* they are of order h^2 */
                   "%s: rates of constraints", what);
}

static void same_motion(hobe_model *whole, hobe_model *small, double to, const char *what)
{
    hobe_history *a = move(whole, to, 20), *b = move(small, to, 20);
    const hobe_solution *x = hobe_history_state(a, 1), *y = hobe_history_state(b, 1);
    same_field(x->model, x->u, y->u, what);
    same_field(x->model, x->v, y->v, what);
    same_energies(hobe_history_energies(a, 1), hobe_history_energies(b, 1), what);
    hobe_history_free(a);
    hobe_history_free(b);
}

/* ---- scenes ---------------------------------------------------------------------------------- */

static struct hobe_beam soft_beam(const hobe_section *section, int elements)
{
    struct hobe_beam beam = beam_along_x("MGD30", elements, section, 1e7, 0.3, 1);
    beam.material.rho = 1000;
    return beam;
}

static void add_gravity(hobe_model *model, hobe_drive *history)
{
    struct hobe_error err;
    expect_ok(hobe_model_gravity_history(model, NULL, (const double[3]){1, 0, -5}, history, &err),
              &err);
}

static void add_spring(hobe_model *model, const struct hobe_spring *spring)
{
    struct hobe_error err;
    expect_ok(hobe_model_spring(model, spring, &err), &err);
}

/* A cantilever with a mass, a spring, and loads that depend on the state; `turning`: one among them
 * turns with the section. */
static hobe_model *loaded(const hobe_section *section, int turning)
{
    struct hobe_error err;
    struct hobe_beam beam = soft_beam(section, 2);
    beam.damping.mass = 2;
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, random_real(-5, 5), random_real(-5, 5), random_real(-5, 5));
    add_moment(model, "beam", 0.7, random_real(-3, 3), random_real(-3, 3), random_real(-3, 3));
    if (turning)
        add_follower(model, "beam", 0.8, 5, random_real(-5, 5), 3);
    add_spring(
        model,
        &(struct hobe_spring){
            .beam = {"beam"}, .at = {0.9}, .to = {1, 0.4, 0.2}, .stiffness = {40}, .damping = {3}});
    expect_ok(hobe_model_mass(model,
                              &(struct hobe_mass){.beam = "beam", .at = 0.6, .y = 0.02, .mass = 2},
                              &err),
              &err);
    add_gravity(model, NULL);
    return model;
}

static void loads(const hobe_section *section)
{
    same = SAME;
    for (int turning = 0; turning < 2; turning++) {
        const char *what = turning ? "cantilever, follower" : "cantilever";
        hobe_model *whole = loaded(section, turning);
        hobe_reduced *reduced = keep_all(whole);
        hobe_model *small = small_of(reduced, whole);
        same_at_rest(whole, small, what);
        same_modes(whole, small, !turning, what);
        same_motion(whole, small, 0.1, what);
        hobe_model_free(small);
        hobe_reduced_free(reduced);
        hobe_model_free(whole);
    }
}

/* A beam on a hinge, driven or not, with a body at its end. */
static hobe_model *hinged(const hobe_section *section, hobe_drive *angle, hobe_drive *weight)
{
    struct hobe_error err;
    struct hobe_beam beam = soft_beam(section, 2);
    hobe_model *model = new_model();
    add_beam(model, &beam);
    add_body(model, &(struct hobe_body){.name = "body",
                                        .density = 3000,
                                        .shape = HOBE_SHAPE_BOX,
                                        .size = {0.1, 0.15, 0.2},
                                        .centre = {1.1, 0.05, 0}});
    add_joint(model, &(struct hobe_joint){.beam = {"beam"},
                                          .name = "hinge",
                                          .kind = HOBE_JOINT_REVOLUTE,
                                          .axis = {0, 1, 0},
                                          .angle = angle});
    add_joint(model,
              &(struct hobe_joint){.beam = {"beam", "body"}, .at = {1}, .kind = HOBE_JOINT_FIXED});
    add_gravity(model, weight);
    if (!angle)
        expect_ok(
            hobe_model_motion(model, &(struct hobe_motion){.angular_velocity = {0, 1, 0}}, &err),
            &err);
    return model;
}

static void joints(const hobe_section *section)
{
    struct hobe_error err;
    hobe_drive *angle =
        hobe_drive_points(2, (const double[][2]){{0, 0}, {0.4, 0.5}}, HOBE_RAMP, 0, &err);
    hobe_drive *weight =
        hobe_drive_points(2, (const double[][2]){{0, 0.2}, {1, 1}}, HOBE_LINEAR, 0, &err);
    same = SAME_TURNED;
    for (int driven = 0; driven < 2; driven++) {
        const char *what = driven ? "driven hinge" : "hinge";
        hobe_model *whole = hinged(section, driven ? angle : NULL, weight);
        hobe_reduced *reduced = keep_all(whole);
        hobe_model *small = small_of(reduced, whole);
        if (driven)
            same_at_rest(whole, small, what);
        if (driven)
            same_modes(whole, small, 1, what);
        same_motion(whole, small, 0.1, what);
        hobe_model_free(small);
        hobe_reduced_free(reduced);
        hobe_model_free(whole);
    }
    hobe_drive_free(angle);
    hobe_drive_free(weight);
}

/* Two arms in a row in a frame that turns. */
static void spins(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_beam beam = soft_beam(section, 1);
    struct hobe_spin spin = {.speed = 3, .about = {0.1, 0.2, -0.1}};
    hobe_model *whole = cantilever(&beam, 0);
    beam.name = "second";
    beam.from[0] = 1;
    beam.to[0] = random_real(1.4, 1.8);
    add_beam(whole, &beam);
    add_join(whole, "beam", 1, "second", 0);
    same = SAME;
    random_direction(spin.axis);
    expect_ok(hobe_model_spin(whole, &spin, &err), &err);
    hobe_reduced *reduced = keep_all(whole);
    hobe_model *small = small_of(reduced, whole);
    same_at_rest(whole, small, "spin");
    same_modes(whole, small, 1, "spin");
    same_motion(whole, small, 0.1, "spin");
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(whole);
}

/* ---- bases of few fields --------------------------------------------------------------------- */

/* Vibration modes in the basis are modes of the reduced model, with the same frequencies; `given`:
 * as fields, or by the method that takes them first; and in the closure of these. */
static void retains_modes(const hobe_section *section, int given, int closed)
{
    enum { MODES = 2 };
    struct hobe_beam beam = soft_beam(section, 2);
    hobe_model *whole = cantilever(&beam, 0);
    hobe_modes *a = modes_of(whole, NULL, MODES, HOBE_MODAL_AUTO);
    const struct hobe_reduce options = {.method = given ? HOBE_REDUCE_FIELDS : HOBE_REDUCE_MODES,
                                        .modes = given ? 0 : 4 * MODES,
                                        .field = a->shape,
                                        .fields = MODES,
                                        .closed = closed};
    hobe_reduced *reduced = reduce(whole, &options);
    hobe_model *small = small_of(reduced, whole);
    hobe_modes *b = modes_of(small, NULL, MODES, HOBE_MODAL_AUTO);
    for (int i = 0; i < MODES; i++)
        check_relative(mode_of(b, i).omega, mode_of(a, i).omega, SAME, "mode %d%s%s", i,
                       given ? ", given" : "", closed ? ", closed" : "");
    hobe_modes_free(a);
    hobe_modes_free(b);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(whole);
}

static struct hobe_reaction reaction_of(const hobe_solution *state, const char *name)
{
    struct hobe_error err;
    struct hobe_reaction reaction;
    expect_ok(hobe_solution_reaction(state, name, &reaction, &err), &err);
    return reaction;
}

/* Fields found under a support keep it by themselves: its reaction is there all the same.  Within
 * what the basis leaves out, 1e-6 of displacements and 1e-4 of forces. */
static void keeps_supports(const hobe_section *section)
{
    struct hobe_beam beam = soft_beam(section, 3);
    hobe_model *whole = new_model();
    add_beam(whole, &beam);
    add_body(whole, &(struct hobe_body){.name = "body",
                                        .mass = 0.5,
                                        .shape = HOBE_SHAPE_SPHERE,
                                        .size = {0.1},
                                        .centre = {1, 0, 0}});
    add_joint(whole,
              &(struct hobe_joint){.beam = {"beam"}, .name = "wall", .kind = HOBE_JOINT_RIGID});
    add_joint(whole,
              &(struct hobe_joint){.beam = {"beam", "body"}, .at = {1}, .kind = HOBE_JOINT_FIXED});
    add_force(whole, "beam", 1, random_real(-5, 5), random_real(-5, 5), random_real(-5, 5));
    add_moment(whole, "beam", 1, 2, random_real(-3, 3), random_real(-3, 3));
    add_gravity(whole, NULL);
    hobe_reduced *reduced = reduce(whole, &(struct hobe_reduce){.modes = 12});
    hobe_model *small = small_of(reduced, whole);
    hobe_solution *a = rest(whole), *b = rest(small);
    same = 1e-6;
    same_field(whole, a->u, b->u, "support");
    const struct hobe_reaction x = reaction_of(a, "wall"), y = reaction_of(b, "wall");
    check_absolute(distance(x.force, y.force), 0, 1e-4 * norm(x.force), "reaction");
    check_absolute(distance(x.moment, y.moment), 0, 1e-4 * norm(x.moment), "moment");
    hobe_solution_free(a);
    hobe_solution_free(b);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(whole);
}

/* A basis about an equilibrium has it whatever its fields are. */
static void about_a_state(const hobe_section *section, int closed)
{
    hobe_model *whole = loaded(section, 0);
    hobe_solution *a = rest(whole);
    hobe_reduced *reduced =
        reduce(whole, &(struct hobe_reduce){.modes = 3, .centre = a, .closed = closed});
    hobe_model *small = small_of(reduced, whole);
    hobe_solution *b = rest(small);
    same = SAME;
    same_field(whole, a->u, b->u, "centre");
    check_that(info_of(b).change < same, "centre: its change is %g", info_of(b).change);
    hobe_solution_free(a);
    hobe_solution_free(b);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(whole);
}

/* u = (R - 1) q, R the turn by an angle about a random axis. */
static void turn(const hobe_model *model, const double *q, double angle, double *u)
{
    double axis[3];
    random_direction(axis);
    for (long v = 0; v < model->vectors; v++) {
        double across[3], back[3];
        cross3(axis, q + 3 * v, across);
        cross3(axis, across, back);
        for (int a = 0; a < 3; a++)
            u[3 * v + a] = sin(angle) * across[a] + (1 - cos(angle)) * back[a];
    }
}

/* The largest of the elastic forces in `share` of the way from the reference to a state. */
static double largest_force(const hobe_model *model, const double *x, double share)
{
    const size_t n = (size_t)(3 * model->vectors);
    double *part = calloc(2 * n, sizeof *part), largest = 0;
    for (size_t i = 0; i < n; i++)
        part[i] = share * x[i];
    assemble(model, part, part + n, NULL);
    for (size_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(part[n + i]));
    free(part);
    return largest;
}

/* A beam that floats. */
static hobe_model *flying(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_beam beam = soft_beam(section, 2);
    struct hobe_motion motion = {.velocity = {1, -2, 3}, .about = {0.4, 0.1, 0}};
    hobe_model *whole = new_model();
    add_beam(whole, &beam);
    random_direction(motion.angular_velocity);
    expect_ok(hobe_model_motion(whole, &motion, &err), &err);
    return whole;
}

/* In the smallest basis closed under rotations: turned as a whole it feels no force, and flying it
 * keeps its momenta. */
static void turns(const hobe_section *section)
{
    struct hobe_error err;
    hobe_model *whole = flying(section);
    expect_ok(hobe_model_build(whole, &err), &err);
    const size_t size = (size_t)(3 * whole->vectors);
    double *q = calloc(2 * size, sizeof *q), *u = q + size, left;
    model_reference(whole, q);
    hobe_reduced *reduced = reduce(
        whole,
        &(struct hobe_reduce){.method = HOBE_REDUCE_FIELDS, .field = q, .fields = 1, .closed = 3});
    hobe_model *small = small_of(reduced, whole);
    double *x = calloc((size_t)(6 * small->vectors), sizeof *x);
    turn(whole, q, 2, u);
    expect_ok(reduction_fit(small, u, x, &left, &err), &err);
    check_that(left < 1e-10, "%g of a rotation is not in a closed basis", left);
    check_absolute(largest_force(small, x, 1) / largest_force(small, x, 0.9), 0, 1e-10,
                   "forces of a turned beam");
    for (long i = 0; i < 3 * small->vectors; i++)
        x[3 * small->vectors + i] = 0.9 * x[i];
    check_absolute(reduction_energy(small, x) / reduction_energy(small, x + 3 * small->vectors), 0,
                   1e-10, "energy of a turned beam");
    hobe_history *history = move(small, 0.5, 50);
    const struct hobe_energies *a = hobe_history_energies(history, 0);
    const struct hobe_energies *b = hobe_history_energies(history, 1);
    check_absolute(distance(a->momentum, b->momentum), 0, 1e-9 * norm(a->momentum), "momentum");
    /* generalised alpha keeps it to the second order: (1 rad/s 0.01 s)^2 */
    check_absolute(distance(a->angular_momentum, b->angular_momentum), 0,
                   1e-4 * norm(a->angular_momentum), "angular momentum");
    hobe_history_free(history);
    free(q);
    free(x);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(whole);
}

/* ---- bases of functions ---------------------------------------------------------------------- */

/* Energy, forces and tangent on functions, and on their fields as any others: sums of some thousand
 * products in another order, of which the largest are a hundred times what is left. */
static void same_energy(const hobe_reduced *reduced)
{
    struct hobe_error err;
    struct quartic general;
    const long n = reduced->basis.n;
    expect_ok(quartic_open(&general, reduced->model, NULL, n, reduced->basis.field, &err), &err);
    double *q = calloc((size_t)(3 * n + 2 * n * n), sizeof *q), size[2] = {0};
    double *f[2] = {q + n, q + 2 * n}, *K[2] = {q + 3 * n, q + 3 * n + n * n};
    for (long j = 0; j < n; j++)
        q[j] = random_real(-1, 1);
    check_relative(reduced_energy(reduced, q), quartic_energy(&general, q), 1e-12, "energy");
    reduced_add(reduced, q, f[0], K[0]);
    quartic_add(&general, q, f[1], K[1]);
    for (long i = 0; i < n * n; i++) {
        size[0] = fmax(size[0], i < n ? fabs(f[1][i]) : 0);
        size[1] = fmax(size[1], fabs(K[1][i]));
    }
    for (long i = 0; i < n * n; i++) {
        if (i < n)
            check_absolute(f[0][i], f[1][i], 1e-12 * size[0], "force %ld", i);
        check_absolute(K[0][i], K[1][i], 1e-12 * size[1], "tangent %ld", i);
    }
    free(q);
    quartic_close(&general);
}

/* A beam that floats, in the closure of two fields, with vectors for coordinates: it moves as in
 * the same fields taken one by one. */
static void like_general(const hobe_section *section)
{
    enum { FIELDS = 2 };
    struct hobe_error err;
    hobe_model *whole = flying(section);
    add_force(whole, "beam", 1, random_real(-5, 5), random_real(-5, 5), random_real(-5, 5));
    expect_ok(hobe_model_build(whole, &err), &err);
    double *field = calloc((size_t)(3 * FIELDS * whole->vectors), sizeof *field);
    for (long i = 0; i < 3 * FIELDS * whole->vectors; i++)
        field[i] = random_real(-1, 1);
    struct hobe_reduce options = {
        .method = HOBE_REDUCE_FIELDS, .field = field, .fields = FIELDS, .closed = 3};
    hobe_reduced *closed = reduce(whole, &options);
    check_that(closed->basis.n % 3 == 0, "functions have three fields each, and all are %ld",
               closed->basis.n);
    same_energy(closed);
    options = (struct hobe_reduce){
        .method = HOBE_REDUCE_FIELDS, .field = closed->basis.field, .fields = (int)closed->basis.n};
    hobe_reduced *general = reduce(whole, &options);
    hobe_model *small = small_of(closed, whole), *other = small_of(general, whole);
    same = SAME;
    same_motion(other, small, 0.1, "functions");
    free(field);
    hobe_model_free(small);
    hobe_model_free(other);
    hobe_reduced_free(closed);
    hobe_reduced_free(general);
    hobe_model_free(whole);
}

/* What an accuracy needs besides are functions, too. */
static void enriched(const hobe_section *section)
{
    hobe_model *whole = loaded(section, 0);
    hobe_reduced *reduced =
        reduce(whole, &(struct hobe_reduce){.modes = 2, .accuracy = 1e-4, .closed = 3});
    hobe_model *small = small_of(reduced, whole);
    hobe_solution *a = rest(whole), *b = rest(small);
    same = 1e-4;
    same_field(whole, a->u, b->u, "enriched functions");
    same_energy(reduced);
    hobe_solution_free(a);
    hobe_solution_free(b);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(whole);
}

/* ---- files ----------------------------------------------------------------------------------- */

static void expect_refused(hobe_model *model, const void *bytes, size_t size, const char *what)
{
    hobe_reduced *reduced;
    struct hobe_error err;
    const enum hobe_status status = hobe_reduced_read(model, bytes, size, &reduced, &err);
    check_that(status == HOBE_BAD_INPUT && !reduced, "%s: status %d", what, (int)status);
}

/* What is written comes back, but not for another beam, nor damaged or cut off. */
static void files(const hobe_section *section, int closed)
{
    struct hobe_error err;
    struct hobe_beam beam = soft_beam(section, 2);
    hobe_model *whole = loaded(section, 0);
    hobe_reduced *reduced = reduce(whole, &(struct hobe_reduce){.modes = 5, .closed = closed}),
                 *read;
    void *bytes;
    size_t size;
    expect_ok(hobe_reduced_write(reduced, &bytes, &size, &err), &err);
    expect_ok(hobe_reduced_read(whole, bytes, size, &read, &err), &err);
    hobe_model *small[2] = {small_of(reduced, whole), small_of(read, whole)};
    hobe_solution *a = rest(small[0]), *b = rest(small[1]);
    check_that(!memcmp(a->u, b->u, (size_t)(3 * whole->vectors) * sizeof *a->u),
               "the basis that was read gives another state");
    hobe_solution_free(a);
    hobe_solution_free(b);
    beam.to[0] *= 1.001;
    hobe_model *longer = cantilever(&beam, 0);
    expect_refused(longer, bytes, size, "another length");
    beam.to[0] = 1;
    beam.material.E *= 1.001;
    hobe_model *stiffer = cantilever(&beam, 0), *other;
    expect_refused(stiffer, bytes, size, "another stiffness");
    check_that(hobe_reduced_model(reduced, stiffer, &other, &err) == HOBE_BAD_INPUT && !other,
               "a basis of another beam is taken");
    expect_refused(whole, bytes, size - 1, "cut off");
    expect_refused(whole, bytes, 10, "cut off at 10 bytes");
    for (int i = 0; i < 50; i++) {
        char *at = (char *)bytes + (size_t)random_real(0, (double)size);
        *at ^= 4;
        expect_refused(whole, bytes, size, "damaged");
        *at ^= 4;
    }
    hobe_free(bytes);
    hobe_model_free(small[0]);
    hobe_model_free(small[1]);
    hobe_reduced_free(reduced);
    hobe_reduced_free(read);
    hobe_model_free(whole);
    hobe_model_free(longer);
    hobe_model_free(stiffer);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.1, 0.2);
    loads(section);
    joints(section);
    spins(section);
    retains_modes(section, 0, 0);
    retains_modes(section, 1, 0);
    retains_modes(section, 0, 3);
    keeps_supports(section);
    about_a_state(section, 0);
    about_a_state(section, 3);
    turns(section);
    like_general(section);
    enriched(section);
    files(section, 0);
    files(section, 3);
    hobe_section_free(section);
    return check_report();
}
