/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motion in time: order of the steps, beside the recursion of one linear oscillator, free flight,
 * no drift, consistent starts, chosen steps, forces in motion, and what is refused. */
#include "check.h"
#include "mass.h"
#include "modes.h"
#include "scene.h"
#include "solution.h"

#include <math.h>
#include <string.h>

static const double RHO = 1000; /* density, kg/m^3 */

static hobe_model *bar(const char *element, int elements, const hobe_section *section, double E)
{
    struct hobe_beam beam = beam_along_x(element, elements, section, E, 0.3, 1);
    hobe_model *model = new_model();
    beam.material.rho = RHO;
    add_beam(model, &beam);
    return model;
}

static void expect_ok(enum hobe_status status, const struct hobe_error *err)
{
    if (status)
        check_stop("%s", err->message);
}

static void add_pin(hobe_model *model, double at)
{
    struct hobe_error err;
    expect_ok(hobe_model_joint(
                  model,
                  &(struct hobe_joint){
                      .beam = {"beam"}, .name = "pin", .at = {at}, .kind = HOBE_JOINT_SPHERICAL},
                  &err),
              &err);
}

/* A hinge about z at 0, turned by a drive. */
static void add_motor(hobe_model *model, hobe_drive *drive)
{
    struct hobe_error err;
    expect_ok(hobe_model_joint(model,
                               &(struct hobe_joint){.beam = {"beam"},
                                                    .name = "motor",
                                                    .kind = HOBE_JOINT_REVOLUTE,
                                                    .axis = {0, 0, 1},
                                                    .angle = drive},
                               &err),
              &err);
}

static void add_gravity(hobe_model *model)
{
    struct hobe_error err;
    expect_ok(hobe_model_gravity(model, NULL, (const double[3]){0, 0, -9.81}, &err), &err);
}

static void set_moving(hobe_model *model, struct hobe_motion motion)
{
    struct hobe_error err;
    expect_ok(hobe_model_motion(model, &motion, &err), &err);
}

static hobe_history *move(hobe_model *model, const struct hobe_dynamic *options)
{
    struct hobe_error err;
    hobe_history *history;
    expect_ok(hobe_dynamic(model, options, &history, &err), &err);
    return history;
}

static struct hobe_history_info about(const hobe_history *history)
{
    struct hobe_history_info info;
    hobe_history_info(history, &info);
    return info;
}

static const hobe_solution *last_state(const hobe_history *history)
{
    return hobe_history_state(history, about(history).states - 1);
}

static const struct hobe_energies *last_energies(const hobe_history *history)
{
    return hobe_history_energies(history, about(history).states - 1);
}

static void velocity_of(const hobe_solution *state, double at, double v[3], double w[3])
{
    struct hobe_error err;
    expect_ok(hobe_solution_velocity(state, "beam", at, 0, 0, v, w, &err), &err);
}

static struct hobe_reaction reaction_of(const hobe_solution *state, const char *name)
{
    struct hobe_error err;
    struct hobe_reaction reaction;
    expect_ok(hobe_solution_reaction(state, name, &reaction, &err), &err);
    return reaction;
}

/* ---- order ----------------------------------------------------------------------------------- */

/* Where a stiff bar that turns about a spherical support is after half a second, how fast, and what
 * holds it. */
static void swing(const hobe_section *section, double rho, int steps, double x[3][3])
{
    hobe_model *model = bar("MGD30", 2, section, 1e12);
    double w[3];
    add_pin(model, 0.1);
    add_gravity(model);
    set_moving(model, (struct hobe_motion){.angular_velocity = {4, 1, 2}, .about = {0.1, 0, 0}});
    hobe_history *history = move(
        model, &(struct hobe_dynamic){.to = 0.5, .step = 0.5 / steps, .rho = rho, .store = 0.5});
    const hobe_solution *state = last_state(history);
    memcpy(x[0], point_of(state, "beam", 1, 0, 0).u, sizeof x[0]);
    velocity_of(state, 1, x[1], w);
    memcpy(x[2], reaction_of(state, "pin").force, sizeof x[2]);
    check_that(last_energies(history)->violation <= 1e-12, "the joint holds: %g",
               last_energies(history)->violation);
    hobe_history_free(history);
    hobe_model_free(model);
}

/* Halved steps quarter the error: of displacements, velocities, and multipliers.  The bar's
 * vibrations are far too fast for the steps and are gone; 3 % for terms of higher order. */
static void order(const hobe_section *section)
{
    static const char *const what[] = {"displacements", "velocities", "multipliers"};
    double x[3][3][3];
    for (int i = 0; i < 3; i++)
        swing(section, 0.5, 50 << i, x[i]);
    for (int k = 0; k < 3; k++)
        check_relative(distance(x[0][k], x[1][k]) / distance(x[1][k], x[2][k]), 4, 0.03,
                       "%s are of second order", what[k]);
}

/* ---- one oscillator -------------------------------------------------------------------------- */

/* q, v, w, a of w = -omega^2 q after one step. */
static void step_scalar(double rho, double h, double omega, double x[4])
{
    const double am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1), gamma = 0.5 + af - am;
    const double beta = (gamma + 0.5) * (gamma + 0.5) / 4;
    const double q = x[0] + h * x[1] + h * h * (0.5 - beta) * x[3]; /* + h^2 beta a1 */
    /* (1 - am) a1 + am a = (1 - af) w1 + af w, w1 = -omega^2 (q + h^2 beta a1) */
    const double a1 = (-(1 - af) * omega * omega * q + af * x[2] - am * x[3]) /
                      (1 - am + (1 - af) * omega * omega * h * h * beta);
    x[0] = q + h * h * beta * a1;
    x[1] += h * ((1 - gamma) * x[3] + gamma * a1);
    x[2] = -omega * omega * x[0];
    x[3] = a1;
}

/* A cantilever starts in its first mode, so small that it is linear to 1e-8 of it. */
static void vibrate(const hobe_section *section, double rho, double omega_h)
{
    enum { STEPS = 12 };
    struct hobe_error err;
    hobe_model *model = bar("MGD30", 2, section, 1e9);
    add_clamp(model, "beam", 0, 0);
    hobe_modes *modes = modes_of(model, NULL, 2, HOBE_MODAL_DENSE);
    const double omega = mode_of(modes, 0).omega, h = omega_h / omega, size = 1e-8;
    double *u = hobe_alloc((size_t)(3 * model->vectors), sizeof *u, &err);
    for (long i = 0; u && i < 3 * model->vectors; i++)
        u[i] = size * modes_shape(modes, 0, NULL)[i];
    hobe_solution *start =
        solution_new(model, u, NULL, NULL, &(struct hobe_solution_info){0}, &err);
    hobe_history *history =
        move(model, &(struct hobe_dynamic){.to = STEPS * h, .step = h, .rho = rho, .start = start});
    const double full =
        point_of(start, "beam", 1, 0, 0).u[1] + point_of(start, "beam", 1, 0, 0).u[2];
    double x[4] = {1, 0, -omega * omega, -omega * omega}, worst = 0;
    for (int i = 1; i <= STEPS; i++) {
        const struct hobe_point tip = point_of(hobe_history_state(history, i), "beam", 1, 0, 0);
        step_scalar(rho, h, omega, x);
        worst = fmax(worst, fabs((tip.u[1] + tip.u[2]) / full - x[0]));
    }
    check_that(worst < 1e-6, "rho %g, omega h %g: one mode is one oscillator: %g", rho, omega_h,
               worst);
    hobe_history_free(history);
    hobe_solution_free(start);
    hobe_free(u);
    hobe_modes_free(modes);
    hobe_model_free(model);
}

/* The recursion itself: in the long run a step leaves rho of a fast vibration.  rho is a double
 * root, so that the state falls as n rho^n, and from N to 2 N steps as rho^N 2. */
static void spectrum(void)
{
    enum { LONG = 1000 };
    static const double rhos[] = {0.3, 0.8, 1};
    for (int i = 0; i < 3; i++) {
        const double fast = 1e5; /* omega h */
        double x[4] = {1, 0, -fast * fast, -fast * fast}, fallen = 0;
        for (int n = 1; n <= 2 * LONG; n++) {
            step_scalar(rhos[i], 1, fast, x);
            const double size = fabs(x[0]) + fabs(x[1]) / fast + fabs(x[3]) / (fast * fast);
            fallen += n > LONG ? log(size) : 0;
            for (int k = 0; k < 4; k++)
                x[k] /= size;
        }
        check_absolute(exp(fallen / LONG), rhos[i], 2.0 / LONG, "rho_inf %g", rhos[i]);
    }
}

static void oscillator(const hobe_section *section)
{
    static const double rhos[] = {0.3, 0.8, 1}, steps[] = {0.05, 1, 30};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            vibrate(section, rhos[i], steps[k]);
    spectrum();
}

/* ---- free flight ----------------------------------------------------------------------------- */

struct lost { /* the greatest changes of what a free beam keeps, relative */
    double momentum, angular_momentum, energy;
};

static struct lost fly(const hobe_section *section, double rho, int steps,
                       struct hobe_motion motion)
{
    hobe_model *model = bar("MGD30", 2, section, 1e8);
    struct lost lost = {0};
    set_moving(model, motion);
    hobe_history *history = move(
        model, &(struct hobe_dynamic){.to = 0.1, .step = 0.1 / steps, .rho = rho, .store = 0.01});
    const struct hobe_energies *first = hobe_history_energies(history, 0), *e;
    for (int i = 1; (e = hobe_history_energies(history, i)); i++) {
        lost.momentum = fmax(lost.momentum, distance(e->momentum, first->momentum));
        lost.angular_momentum =
            fmax(lost.angular_momentum, distance(e->angular_momentum, first->angular_momentum));
        lost.energy = fmax(lost.energy, fabs(e->balance));
    }
    lost.momentum /= norm(first->momentum);
    lost.angular_momentum /= norm(first->angular_momentum);
    lost.energy /= first->kinetic;
    hobe_history_free(history);
    hobe_model_free(model);
    return lost;
}

static void flight(const hobe_section *section)
{
    struct hobe_motion motion = {.velocity = {1, 2, 3}};
    random_direction(motion.angular_velocity);
    for (int a = 0; a < 3; a++)
        motion.angular_velocity[a] *= 5;
    for (int full = 0; full < 2; full++) {
        const double rho = full ? 1 : 0.8;
        const struct lost coarse = fly(section, rho, 400, motion);
        const struct lost fine = fly(section, rho, 800, motion);
        check_that(coarse.momentum <= 1e-12, "rho %g: momentum is kept: %g", rho, coarse.momentum);
        /* the greatest of few values, not all at their extremes: 15 % */
        check_relative(coarse.angular_momentum / fine.angular_momentum, 4, 0.15,
                       "rho %g: angular momentum, from %g", rho, coarse.angular_momentum);
        check_relative(coarse.energy / fine.energy, 4, 0.15, "rho %g: energy, from %g", rho,
                       coarse.energy);
    }
}

/* ---- no drift -------------------------------------------------------------------------------- */

/* A pendulum of one element: constraints are as good at the end as they were. */
static void drift(const hobe_section *section)
{
    enum { STEPS = 20000, STATES = 40 };
    hobe_model *model = bar("BE24", 1, section, 1e8);
    add_pin(model, 0.2);
    add_gravity(model);
    set_moving(model, (struct hobe_motion){.angular_velocity = {1, 2, -1}, .about = {0.2, 0, 0}});
    hobe_history *history = move(
        model,
        &(struct hobe_dynamic){.to = STEPS * 1e-3, .step = 1e-3, .store = STEPS * 1e-3 / STATES});
    double worst[2] = {0}, rate[2] = {0};
    for (int i = 1; i <= STATES; i++) {
        const struct hobe_energies *e = hobe_history_energies(history, i);
        const int late = i > STATES / 2;
        worst[late] = fmax(worst[late], e->violation);
        rate[late] = fmax(rate[late], e->violation_rate);
    }
    check_that(about(history).steps == STEPS, "all steps are taken: %ld", about(history).steps);
    check_that(worst[0] <= 1e-13 && worst[1] <= 1e-13, "constraints hold: %g, %g", worst[0],
               worst[1]);
    check_that(rate[1] <= 2 * rate[0] + 1e-12, "their rates do not grow: %g, %g", rate[0], rate[1]);
    hobe_history_free(history);
    hobe_model_free(model);
}

/* ---- forces ---------------------------------------------------------------------------------- */

/* What holds a beam, its weight and what damps its mass make its momentum change; its free end
 * carries nothing. */
static void forces(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_beam beam = beam_along_x("MGD30w", 4, section, 1e8, 0.3, 1);
    hobe_model *model = new_model();
    beam.material.rho = RHO;
    beam.damping = (struct hobe_damping){.mass = 3, .stiffness = 1e-3};
    add_beam(model, &beam);
    const struct hobe_clamp clamp = {NULL, "beam", "clamp", 0, 0};
    struct hobe_resultants cut;
    expect_ok(hobe_model_clamp(model, &clamp, &err), &err);
    add_gravity(model);
    hobe_history *history =
        move(model, &(struct hobe_dynamic){.to = 0.1, .step = 1e-3, .store = 0.1});
    const hobe_solution *state = last_state(history);
    const struct hobe_reaction reaction = reaction_of(state, "clamp");
    double *one = hobe_alloc((size_t)(3 * model->vectors), sizeof *one, &err), weight = 0;
    for (int a = 0; one && a < 3; a++) {
        mass_translation(model, a, one);
        weight = mass_product(model, one, one) * 9.81;
        check_absolute(reaction.force[a] - (a == 2 ? weight : 0),
                       mass_product(model, one, state->w) + 3 * mass_product(model, one, state->v),
                       1e-9 * weight, "force and momentum along %c", "xyz"[a]);
    }
    expect_ok(hobe_solution_resultants(state, "beam", 1, HOBE_CUT_FORCES, &cut, &err), &err);
    check_that(norm(cut.force) <= 1e-7 * weight, "the free end carries %g N", norm(cut.force));
    expect_ok(hobe_solution_resultants(state, "beam", 0, HOBE_CUT_FORCES, &cut, &err), &err);
    /* the cut's forces are on the clamped section's axes, the global ones; the tolerance is that of
     * Newton's residual, relative to the forces */
    for (int a = 0; a < 3; a++)
        check_absolute(cut.force[a], -reaction.force[a], 1e-7 * weight, "the cut at the clamp, %c",
                       "xyz"[a]);
    hobe_free(one);
    hobe_history_free(history);
    hobe_model_free(model);
}

/* ---- steps that are chosen ------------------------------------------------------------------- */

static void fall(const hobe_section *section, struct hobe_dynamic options, double u[3],
                 struct hobe_history_info *info)
{
    hobe_model *model = bar("MGD30", 2, section, 1e8);
    add_pin(model, 0);
    add_gravity(model);
    hobe_history *history = move(model, &options);
    memcpy(u, point_of(last_state(history), "beam", 1, 0, 0).u, sizeof(double[3]));
    *info = about(history);
    check_absolute(info->time, options.to, 0, "it ends in time");
    hobe_history_free(history);
    hobe_model_free(model);
}

static void accuracy(const hobe_section *section)
{
    struct hobe_history_info info[3];
    double u[3][3];
    fall(section, (struct hobe_dynamic){.to = 0.3, .accuracy = 1e-5}, u[0], info);
    fall(section, (struct hobe_dynamic){.to = 0.3, .accuracy = 1e-5, .step = 2e-3}, u[1], info + 1);
    fall(section, (struct hobe_dynamic){.to = 3 * 0.1, .step = 1e-4, .store = 0.1}, u[2], info + 2);
    check_that(info[0].largest_step > 2 * info[0].smallest_step, "the step grows");
    check_that(info[1].largest_step <= 2e-3, "but not beyond what is asked: %g",
               info[1].largest_step);
    check_that(info[2].states == 4 && info[2].steps == 3000, "states are kept when asked: %d, %ld",
               info[2].states, info[2].steps);
    for (int i = 0; i < 2; i++) /* so many steps, each with its error */
        check_that(distance(u[i], u[2]) <= 1e-5 * (double)info[i].steps,
                   "accuracy is met: %g in %ld", distance(u[i], u[2]), info[i].steps);
}

/* Steps that have grown while all is at rest are too long for what comes then. */
static void rejection(const hobe_section *section)
{
    static const double speed[][2] = {{0, 0}, {0.5, 0}, {0.51, 20}};
    struct hobe_error err;
    hobe_drive *drive = hobe_drive_points(3, speed, HOBE_LINEAR, 1, &err);
    hobe_model *model = bar("MGD30", 2, section, 1e8);
    if (!drive)
        check_stop("%s", err.message);
    add_motor(model, drive);
    hobe_history *history =
        move(model, &(struct hobe_dynamic){.to = 0.55, .accuracy = 1e-5, .store = 0.55});
    const struct hobe_history_info info = about(history);
    check_that(info.rejected > 0 && info.smallest_step < 0.1 * info.largest_step,
               "steps too long are rejected: %ld, from %g to %g", info.rejected, info.largest_step,
               info.smallest_step);
    check_that(info.steps < 2000, "and few are taken: %ld", info.steps);
    hobe_history_free(history);
    hobe_model_free(model);
    hobe_drive_free(drive);
}

/* A motion goes on from a state that it has kept as if it had not stopped, but for the start of the
 * algorithmic accelerations, which is of the order of the steps. */
static void go_on(const hobe_section *section)
{
    hobe_model *model = bar("MGD30", 2, section, 1e8);
    add_pin(model, 0);
    add_gravity(model);
    const struct hobe_dynamic whole = {.to = 0.2, .step = 1e-3, .store = 0.1};
    hobe_history *history = move(model, &whole);
    struct hobe_dynamic half = whole;
    half.start = hobe_history_state(history, 1);
    hobe_history *rest = move(model, &half);
    check_absolute(hobe_history_energies(rest, 0)->time, 0.1, 1e-15, "it begins at its time");
    const double *u = point_of(last_state(history), "beam", 1, 0, 0).u;
    check_that(distance(u, point_of(last_state(rest), "beam", 1, 0, 0).u) <= 1e-6 * norm(u),
               "and goes the same way");
    hobe_history_free(rest);
    hobe_history_free(history);
    hobe_model_free(model);
}

/* A beam that hangs in equilibrium stays there. */
static void rest(const hobe_section *section)
{
    hobe_model *model = bar("MGD30w", 4, section, 1e8);
    add_clamp(model, "beam", 0, 0);
    add_gravity(model);
    hobe_solution *still = solve(model, 1);
    hobe_history *history =
        move(model, &(struct hobe_dynamic){.to = 0.1, .step = 0.01, .rho = 1, .equilibrium = 1});
    const double *u = point_of(still, "beam", 1, 0, 0).u;
    check_that(distance(point_of(last_state(history), "beam", 1, 0, 0).u, u) <= 1e-8 * norm(u),
               "equilibrium lasts"); /* the tolerance of the static solution */
    check_that(last_energies(history)->kinetic <= 1e-12 * last_energies(history)->strain,
               "without motion");
    hobe_history_free(history);
    hobe_solution_free(still);
    hobe_model_free(model);
}

/* A straight column above Euler's load is an equilibrium that does not last: its motion says so at
 * the start, and of no later state. */
static void unstable(const hobe_section *section)
{
    const double E = 1e8, euler = M_PI * M_PI * E * properties_of(section).Izz / 4;
    for (int above = 0; above < 2; above++) {
        hobe_model *model = bar("MGD30w", 4, section, E);
        add_clamp(model, "beam", 0, 0);
        add_force(model, "beam", 1, -(above ? 1.1 : 0.9) * euler, 0, 0);
        hobe_history *history =
            move(model, &(struct hobe_dynamic){.to = 0.01, .step = 0.01, .equilibrium = 1});
        check_that(info_of(hobe_history_state(history, 0)).negative == above,
                   "negative eigenvalues of %d at the start", above);
        check_that(info_of(last_state(history)).negative == -1, "not counted in motion");
        hobe_history_free(history);
        hobe_model_free(model);
    }
}

/* ---- kinks ----------------------------------------------------------------------------------- */

/* A damped bar that is turned with a speed which breaks at times that no step would meet. */
static struct hobe_energies turn(const hobe_section *section, hobe_drive *drive, int steps,
                                 double x[2][3])
{
    struct hobe_beam beam = beam_along_x("MGD30", 4, section, 1e9, 0.3, 1);
    hobe_model *model = new_model();
    double w[3];
    beam.material.rho = RHO;
    beam.damping.stiffness = 1e-3;
    add_beam(model, &beam);
    add_motor(model, drive);
    hobe_history *history =
        move(model, &(struct hobe_dynamic){.to = 0.25, .step = 0.25 / steps, .store = 0.125});
    const struct hobe_energies energies = *last_energies(history);
    memcpy(x[0], point_of(last_state(history), "beam", 1, 0, 0).u, sizeof x[0]);
    velocity_of(last_state(history), 1, x[1], w);
    /* segments to 0.0733, 0.125, 0.131, 0.2 and 0.25 s, of whole steps each */
    if (steps == 200)
        check_that(about(history).steps == 59 + 42 + 5 + 56 + 40, "steps end at the breaks: %ld",
                   about(history).steps);
    hobe_history_free(history);
    hobe_model_free(model);
    return energies;
}

/* The order holds over the breaks, and so it does of the balance of work. */
static void kinks(const hobe_section *section)
{
    static const double speed[][2] = {{0, 0}, {0.0733, 4}, {0.131, 4}, {0.2, -1}};
    struct hobe_error err;
    hobe_drive *drive = hobe_drive_points(4, speed, HOBE_LINEAR, 1, &err);
    double x[3][2][3];
    struct hobe_energies e[3];
    if (!drive)
        check_stop("%s", err.message);
    for (int i = 0; i < 3; i++)
        e[i] = turn(section, drive, 200 << i, x[i]);
    hobe_drive_free(drive);
    for (int k = 0; k < 2; k++) /* segments have whole numbers of steps, not halves: 15 % */
        check_relative(distance(x[0][k], x[1][k]) / distance(x[1][k], x[2][k]), 4, 0.15, "%s",
                       k ? "velocities over breaks" : "displacements over breaks");
    check_relative(e[1].balance / e[2].balance, 4, 0.1, "the balance, %g J of %g", e[2].balance,
                   e[2].drives);
    check_that(e[2].damped > 0.1 && fabs(e[2].balance) < 1e-3 * e[2].drives, "of all the work");
}

/* ---- without inertia ------------------------------------------------------------------------- */

static hobe_model *driven_bar(const hobe_section *section, hobe_drive *drive)
{
    hobe_model *model = bar("MGD30", 2, section, 1e7);
    add_motor(model, drive);
    add_gravity(model);
    return model;
}

/* The states of a quasi-static motion are the equilibria of their times, found from elsewhere, at
 * rest; the last interval may be shorter. */
static void equilibria(const hobe_section *section)
{
    static const double angle[][2] = {{0, 0}, {0.1, 1}, {0.2, 0.5}}, time[] = {0, 0.08, 0.16, 0.2};
    enum { STATES = sizeof time / sizeof *time };
    struct hobe_error err;
    hobe_drive *drive = hobe_drive_points(3, angle, HOBE_LINEAR, 0, &err);
    if (!drive)
        check_stop("%s", err.message);
    hobe_model *model = driven_bar(section, drive), *other = driven_bar(section, drive);
    hobe_history *history =
        move(model, &(struct hobe_dynamic){.to = 0.2, .step = 1, .store = 0.08, .quasi_static = 1});
    check_that(about(history).states == STATES, "%d states", about(history).states);
    for (int i = 0; i < STATES; i++) {
        const hobe_solution *state = hobe_history_state(history, i);
        hobe_solution *alone;
        double v[3], w[3];
        struct hobe_solution_info info;
        expect_ok(hobe_static(other, &(struct hobe_newton){.time = time[i]}, &alone, &err), &err);
        hobe_solution_info(state, &info);
        check_absolute(info.time, time[i], 1e-15, "time of state %d", i);
        check_absolute(
            distance(point_of(state, "beam", 1, 0, 0).r, point_of(alone, "beam", 1, 0, 0).r), 0,
            1e-9, "state %d, to the tolerance of Newton's iteration", i);
        expect_ok(hobe_solution_velocity(state, "beam", 1, 0, 0, v, w, &err), &err);
        check_that(norm(v) == 0 && norm(w) == 0, "it is at rest");
        hobe_solution_free(alone);
    }
    hobe_history_free(history);
    hobe_model_free(model);
    hobe_model_free(other);
    hobe_drive_free(drive);
}

/* ---- what is refused ------------------------------------------------------------------------- */

static void refuse(hobe_model *model, const struct hobe_dynamic *options, enum hobe_status expected,
                   const char *words)
{
    struct hobe_error err = {0};
    hobe_history *history;
    const enum hobe_status status = hobe_dynamic(model, options, &history, &err);
    check_that(status == expected && !history && strstr(err.message, words), "\"%s\" is said: %s",
               words, err.message);
    hobe_model_free(model);
}

static enum hobe_status steady(void *context, double t, double *f, struct hobe_error *err)
{
    (void)context;
    (void)err;
    *f = 3 * t;
    return HOBE_OK;
}

static hobe_model *driven(const hobe_section *section, hobe_drive *drive)
{
    hobe_model *model = bar("MGD30", 2, section, 1e9);
    add_motor(model, drive);
    return model;
}

static void refused(const hobe_section *section)
{
    const struct hobe_dynamic good = {.to = 0.1, .step = 1e-3};
    struct hobe_error err;
    hobe_model *model = new_model();
    struct hobe_beam beam = beam_along_x("MGD30", 1, section, 1e9, 0.3, 1);
    add_beam(model, &beam);
    refuse(model, &good, HOBE_BAD_INPUT, "material.rho of beam \"beam\" is 0");
    refuse(bar("MGD30", 1, section, 1e9), &(struct hobe_dynamic){.to = 1}, HOBE_BAD_INPUT,
           "needs step (s), or accuracy");
    refuse(bar("MGD30", 1, section, 1e9), &(struct hobe_dynamic){.to = -1, .step = 1},
           HOBE_BAD_INPUT, "must end after its start at t = 0 s, got to = -1");
    refuse(bar("MGD30", 1, section, 1e9), &(struct hobe_dynamic){.to = 1, .step = 1, .rho = 2},
           HOBE_BAD_INPUT, "rho up to 1");
    refuse(bar("MGD30", 1, section, 1e9),
           &(struct hobe_dynamic){.to = 1, .step = 1, .equilibrium = 1}, HOBE_UNCONSTRAINED,
           "free to move");
    refuse(bar("MGD30", 1, section, 1e9),
           &(struct hobe_dynamic){.to = 1, .step = 1, .quasi_static = 1}, HOBE_BAD_INPUT,
           "needs store > 0 s");
    refuse(bar("MGD30", 1, section, 1e9),
           &(struct hobe_dynamic){.to = 1, .step = 1, .store = 1, .quasi_static = 1},
           HOBE_UNCONSTRAINED, "free to move");
    model = bar("MGD30", 1, section, 1e9);
    add_clamp(model, "beam", 0, 0);
    set_moving(model, (struct hobe_motion){.velocity = {1, 0, 0}});
    refuse(model, &good, HOBE_BAD_INPUT,
           "is clamped at 0 and cannot start with the velocity {1, 0");
    model = bar("MGD30", 1, section, 1e9);
    set_moving(model, (struct hobe_motion){.beam = "baem"});
    refuse(model, &good, HOBE_UNKNOWN, "no beam \"baem\"");
    model = bar("MGD30", 1, section, 1e9);
    add_pin(model, 0.5);
    set_moving(model, (struct hobe_motion){.velocity = {0, 0, 2}});
    refuse(model, &good, HOBE_BAD_INPUT, "velocities of the start break the joint \"pin\" by 2");
    hobe_drive *drive = hobe_drive_function(steady, NULL, 0, &err);
    refuse(driven(section, drive), &good, HOBE_BAD_INPUT,
           "a drive with a jump: the joint \"motor\" starts with the speed 3");
    model = driven(section, drive);
    set_moving(model, (struct hobe_motion){.angular_velocity = {0, 0, 3}});
    hobe_history *history = move(model, &good);
    check_that(last_state(history) != NULL, "unless the velocities fit");
    hobe_history_free(history);
    hobe_model_free(model);
    hobe_drive_free(drive);
}

/* A step that is far too long says when and why. */
static void too_long(const hobe_section *section)
{
    hobe_model *model = bar("MGD30", 2, section, 1e9);
    set_moving(model, (struct hobe_motion){.angular_velocity = {0, 30, 40}});
    refuse(model, &(struct hobe_dynamic){.to = 10, .step = 0.5}, HOBE_NOT_CONVERGED,
           "no motion was found beyond t = ");
}

int main(void)
{
    hobe_section *section = rectangle(0.05, 0.08);
    random_start();
    order(section);
    oscillator(section);
    flight(section);
    drift(section);
    forces(section);
    accuracy(section);
    rejection(section);
    go_on(section);
    kinks(section);
    equilibria(section);
    rest(section);
    unstable(section);
    refused(section);
    too_long(section);
    hobe_section_free(section);
    return check_report();
}
