/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Springs and dampers: tangents against differences, forces in equilibrium, scenes that they alone
 * hold, statics, vibration and buckling in closed form, and what is refused.  Looks into the core
 * (model.h). */
#include "spring.h"

#include "check.h"
#include "damping.h"
#include "scene.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, RHO = 2700;

static const char *const kind_name[] = {"length", "torsion", "bushing"};

enum { KINDS = 3 };

static void add_spring(hobe_model *model, const struct hobe_spring *spring)
{
    struct hobe_error err;
    if (hobe_model_spring(model, spring, &err))
        check_stop("%s", err.message);
}

static void build(hobe_model *model)
{
    struct hobe_error err;
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
}

static struct hobe_spring_state spring_of(const hobe_solution *solution, const char *name)
{
    struct hobe_error err;
    struct hobe_spring_state state;
    if (hobe_solution_spring(solution, name, &state, &err))
        check_stop("%s", err.message);
    return state;
}

static void fill(const hobe_model *model, double size, double *x)
{
    for (long i = 0; i < 3 * model->vectors; i++)
        x[i] = random_real(-size, size);
}

/* ---- one spring ------------------------------------------------------------------------------ */

/* A spring of random numbers, its force not zero at the reference. */
static struct hobe_spring random_spring(enum hobe_spring_kind kind, int grounded)
{
    struct hobe_spring spring = {
        .beam = {"first", grounded ? NULL : "second"}, .at = {0.3, 0.6}, .kind = kind};
    const int parts = kind == HOBE_SPRING_BUSHING ? 3 : 1;
    for (int p = 0; p < parts; p++) {
        spring.stiffness[p] = random_real(1, 2);
        spring.damping[p] = random_real(1, 2);
    }
    if (kind == HOBE_SPRING_LENGTH)
        spring.length = random_real(0.1, 2);
    if (kind == HOBE_SPRING_TORSION) {
        random_direction(spring.axis);
        spring.angle = random_real(-1, 1);
    }
    if (kind == HOBE_SPRING_LENGTH)
        for (int a = 0; a < 3; a++)
            spring.to[a] = random_real(1, 2);
    return spring;
}

/* Two beams, which cross where a bushing sits, else lie apart; both are free. */
static hobe_model *crossing(const struct hobe_spring *spring, const hobe_section *section)
{
    const double lift = spring->kind == HOBE_SPRING_BUSHING ? 0 : 0.7;
    hobe_model *model = new_model();
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    beam.name = "first";
    random_direction(beam.up);
    add_beam(model, &beam);
    beam = beam_along_x("3433w", 2, section, E, 0.3, 1);
    beam.name = "second";
    random_direction(beam.up);
    memcpy(beam.from, (const double[3]){0.3, -0.6, lift}, sizeof beam.from);
    memcpy(beam.to, (const double[3]){0.3, 0.4, lift}, sizeof beam.to);
    add_beam(model, &beam);
    add_spring(model, spring);
    build(model);
    return model;
}

static double *state; /* of what follows, where it is a function of velocities */

static void by_displacements(const hobe_model *model, const double *u, double *r,
                             const struct matrix *K)
{
    spring_add(model, u, &AT_REST, r, K);
}

/* The force, and the tangent of a damper at rest, since that of its force is by displacements. */
static void by_velocities(const hobe_model *model, const double *v, double *r,
                          const struct matrix *K)
{
    spring_add(model, state, &(struct instant){.v = v}, r, NULL);
    if (K)
        spring_add(model, state, &(struct instant){.rate = 1}, r, K);
}

static void check_tangents(enum hobe_spring_kind kind, int grounded, const hobe_section *section)
{
    struct hobe_spring spring = random_spring(kind, grounded);
    hobe_model *model = crossing(&spring, section);
    check_tangent(model, by_displacements, 1, kind_name[kind]);
    hobe_model_free(model);
    memset(spring.stiffness, 0, sizeof spring.stiffness);
    model = crossing(&spring, section);
    state = field_on(model);
    fill(model, 0.3, state);
    check_tangent(model, by_velocities, 1, kind_name[kind]);
    hobe_free(state);
    hobe_model_free(model);
}

/* The sums of forces, and of moments about the origin, of all vectors: a position's moment is q x
 * f, and so is that of a slope or of any other vector. */
static void check_balance(enum hobe_spring_kind kind, const hobe_section *section)
{
    const struct hobe_spring spring = random_spring(kind, 0);
    hobe_model *model = crossing(&spring, section);
    double *q = field_on(model), *u = field_on(model), *v = field_on(model), *f = field_on(model);
    double force[3] = {0}, moment[3] = {0}, size = 0;
    model_reference(model, q);
    fill(model, 0.3, u);
    fill(model, 1, v);
    spring_add(model, u, &(struct instant){.v = v}, f, NULL);
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        const long vectors = (long)beam->step * (beam->spec.elements - 1) + beam->kernel->vectors;
        for (long n = beam->first; n < beam->first + vectors; n++) {
            const struct hobe_vector *is = beam->kernel->vector + (n - beam->first) % beam->step;
            double r[3], couple[3];
            for (int a = 0; a < 3; a++)
                r[a] = q[3 * n + a] + u[3 * n + a];
            cross3(r, f + 3 * n, couple);
            for (int a = 0; a < 3; a++) {
                force[a] += is->mode == 0 && !is->slope ? f[3 * n + a] : 0;
                moment[a] += couple[a];
                size += fabs(f[3 * n + a]);
            }
        }
    }
    check_that(size > 0, "%s: a force acts", kind_name[kind]);
    check_absolute(norm(force) / size, 0, 1e-14, "%s: forces are in balance", kind_name[kind]);
    check_absolute(norm(moment) / size, 0, 1e-14, "%s: moments are in balance", kind_name[kind]);
    check_relative(damping_power(model, u, v), spring_power(model, u, v), 1e-15, "%s: power",
                   kind_name[kind]);
    hobe_free(q);
    hobe_free(u);
    hobe_free(v);
    hobe_free(f);
    hobe_model_free(model);
}

/* Energy against the work of the force on the way to a state, by Gauss's rule of 3 points in 40
 * steps; power against that of the damper's force. */
static void check_work(enum hobe_spring_kind kind, const hobe_section *section)
{
    enum { STEPS = 40 };
    static const double at[3] = {0.1127016653792583, 0.5, 0.8872983346207417};
    static const double weight[3] = {5. / 18, 8. / 18, 5. / 18};
    struct hobe_spring spring = random_spring(kind, kind == HOBE_SPRING_LENGTH);
    hobe_model *model = crossing(&spring, section);
    const long n = 3 * model->vectors;
    double *u = field_on(model), *v = field_on(model), *f = field_on(model), work = 0, power = 0;
    fill(model, 0.2, v);
    for (int p = 0; p < 3 * STEPS; p++) {
        memset(f, 0, (size_t)n * sizeof *f);
        for (long i = 0; i < n; i++)
            u[i] = (p / 3 + at[p % 3]) / STEPS * v[i];
        spring_add(model, u, &AT_REST, f, NULL);
        for (long i = 0; i < n; i++)
            work += weight[p % 3] / STEPS * f[i] * v[i];
    }
    memset(u, 0, (size_t)n * sizeof *u);
    const double start = spring_energy(model, u);
    check_relative(spring_energy(model, v) - start, work, 1e-8, "%s: energy is work",
                   kind_name[kind]);
    fill(model, 0.2, u);
    for (int damped = 0; damped < 2; damped++) {
        memset(f, 0, (size_t)n * sizeof *f);
        spring_add(model, u, &(struct instant){.v = damped ? v : NULL}, f, NULL);
        for (long i = 0; i < n; i++)
            power += (damped ? 1 : -1) * f[i] * v[i];
    }
    check_relative(spring_power(model, u, v), power, 1e-10, "%s: power", kind_name[kind]);
    hobe_free(u);
    hobe_free(v);
    hobe_free(f);
    hobe_model_free(model);
}

/* ---- statics --------------------------------------------------------------------------------- */

static struct hobe_beam stub(const hobe_section *section, double length)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, length);
    beam.material.rho = RHO;
    return beam;
}

/* A cantilever with something at its tip, and a tip force or moment about x. */
static hobe_model *propped(const hobe_section *section, const struct hobe_spring *spring,
                           const double force[3], double torque)
{
    const struct hobe_beam beam = stub(section, 1);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, force[0], force[1], force[2]);
    if (torque != 0)
        add_moment(model, "beam", 1, torque, 0, 0);
    if (spring)
        add_spring(model, spring);
    return model;
}

/* A spring of stiffness k at the tip, whose flexibility alone is c: the load F moves it by F c/(1 +
 * k c), and the spring's force is k times that.  Loads are so small that what is not linear is
 * 1e-9. */
static void check_prop(const hobe_section *section)
{
    static const double F[3] = {1e-2, 2e-3, 1e-3};
    const double k[3] = {1e9, 1e6, 3e5};
    const struct hobe_spring bushing = {.beam = {"beam"},
                                        .name = "k",
                                        .at = {1},
                                        .kind = HOBE_SPRING_BUSHING,
                                        .stiffness = {k[0], k[1], k[2]}};
    const struct hobe_point alone = tip_of(propped(section, NULL, F, 0), 1);
    hobe_model *model = propped(section, &bushing, F, 0);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_spring_state is = spring_of(solution, "k");
    for (int a = 0; a < 3; a++) {
        const double expected = alone.u[a] / (1 + k[a] * alone.u[a] / F[a]);
        check_relative(is.extension[a], expected, 1e-7, "propped cantilever: %c", "xyz"[a]);
        check_relative(is.force[a], k[a] * is.extension[a], 1e-15, "force of its support");
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
}

/* The same of a length across the axis, along the force, and of an angle about the axis. */
static void check_tip(const hobe_section *section)
{
    const double n[3] = {0, 0.6, 0.8}, F[3] = {0, 0.6e-3, 0.8e-3}, none[3] = {0}, k = 2e5, M = 1e-3;
    const struct hobe_spring line = {.beam = {"beam"},
                                     .name = "k",
                                     .at = {1},
                                     .stiffness = {k},
                                     .to = {1, -2 * n[1], -2 * n[2]}};
    const struct hobe_spring angle = {.beam = {"beam"},
                                      .name = "k",
                                      .at = {1},
                                      .kind = HOBE_SPRING_TORSION,
                                      .axis = {2, 0, 0},
                                      .stiffness = {k}};
    const struct hobe_point alone = tip_of(propped(section, NULL, F, 0), 1);
    const double moved = alone.u[1] * n[1] + alone.u[2] * n[2];
    hobe_model *model = propped(section, &line, F, 0);
    hobe_solution *solution = solve(model, 1);
    struct hobe_spring_state is = spring_of(solution, "k");
    check_relative(is.force[0], k * moved / (1 + k * moved / 1e-3), 1e-7, "spring across the tip");
    check_relative(is.extension[0] - 2, is.force[0] / k, 1e-6, "its length"); /* digits of 2 m */
    hobe_solution_free(solution);
    hobe_model_free(model);
    model = propped(section, &angle, none,
                    M); /* the spring's twin is a stiffer bar: by two stiffnesses */
    solution = solve(model, 1);
    is = spring_of(solution, "k");
    const double bar = (M - is.force[0]) / is.extension[0]; /* G J/L of the bar, found from one */
    hobe_solution_free(solution);
    hobe_model_free(model);
    struct hobe_spring twice = angle;
    twice.stiffness[0] *= 2;
    model = propped(section, &twice, none, M);
    solution = solve(model, 1);
    is = spring_of(solution, "k");
    check_relative(is.extension[0], M / (bar + 2 * k), 1e-9, "torsion spring beside a bar");
    hobe_solution_free(solution);
    hobe_model_free(model);
}

/* A hinge with a torsion spring, turned by more than a right angle: the moment acts on the
 * section's angle about the same axis.  The bar is stiff: its bending is 1e-7 of the angle. */
static void check_hinge(const hobe_section *section)
{
    struct hobe_error err;
    const double k = 10, M = 20;
    const struct hobe_joint hinge = {
        .beam = {"beam"}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 0, 1}};
    const struct hobe_spring spring = {.beam = {"beam"},
                                       .name = "k",
                                       .kind = HOBE_SPRING_TORSION,
                                       .axis = {0, 0, 1},
                                       .stiffness = {k},
                                       .angle = 0.5};
    const struct hobe_beam beam = stub(section, 1);
    hobe_model *model = new_model();
    add_beam(model, &beam);
    if (hobe_model_joint(model, &hinge, &err))
        check_stop("%s", err.message);
    add_spring(model, &spring);
    add_moment(model, "beam", 0, 0, 0, M);
    hobe_solution *solution = solve(model, 4);
    const struct hobe_spring_state is = spring_of(solution, "k");
    check_relative(is.extension[0], M / k + 0.5, 1e-6, "hinge with a spring: angle");
    check_relative(is.force[0], M, 1e-8, "hinge with a spring: moment");
    check_relative(info_of(solution).energy, M * M / k / 2, 1e-4, "hinge with a spring: energy");
    hobe_solution_free(solution);
    hobe_model_free(model);
}

/* Without a load: a spring that is too short pulls a cantilever's tip up until both are in
 * equilibrium. */
static void check_prestress(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_reaction reaction;
    const struct hobe_beam beam = stub(section, 2);
    const struct hobe_clamp clamp = {.beam = "beam", .name = "wall"};
    const struct hobe_spring spring = {.beam = {"beam"},
                                       .name = "k",
                                       .at = {1},
                                       .stiffness = {3e4},
                                       .length = 0.2,
                                       .to = {2, 0, 1}};
    hobe_model *model = new_model();
    add_beam(model, &beam);
    if (hobe_model_clamp(model, &clamp, &err))
        check_stop("%s", err.message);
    add_spring(model, &spring);
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
    const struct hobe_spring_state is = spring_of(solution, "k");
    if (hobe_solution_reaction(solution, "wall", &reaction, &err))
        check_stop("%s", err.message);
    check_that(tip.u[2] > 1e-2, "a short spring pulls: %g", tip.u[2]);
    for (int a = 0; a < 3; a++) {
        const double along = (spring.to[a] - tip.r[a]) / is.extension[0];
        check_absolute(reaction.force[a], -is.force[0] * along, 1e-6 * is.force[0],
                       "the wall holds against it: %c", "xyz"[a]);
    }
    check_relative(is.extension[0], distance(spring.to, tip.r), 1e-14,
                   "length of the short spring");
    check_relative(is.force[0], 3e4 * (is.extension[0] - 0.2), 1e-14, "its force");
    hobe_solution_free(solution);
    hobe_model_free(model);
}

/* ---- a stiff bar on springs ------------------------------------------------------------------ */

static const double LENGTH = 0.4, WIDTH = 0.1, HEIGHT = 0.06;

/* Both ends on soft bushings k, and a soft spring about its axis. */
static hobe_model *bedded(const hobe_section *section, const double k[3], double torsion)
{
    const struct hobe_beam beam = stub(section, LENGTH);
    struct hobe_spring spring = {
        .beam = {"beam"}, .kind = HOBE_SPRING_BUSHING, .stiffness = {k[0], k[1], k[2]}};
    hobe_model *model = new_model();
    add_beam(model, &beam);
    add_spring(model, &spring);
    spring.at[0] = 1;
    add_spring(model, &spring);
    spring = (struct hobe_spring){.beam = {"beam"},
                                  .at = {0.4},
                                  .kind = HOBE_SPRING_TORSION,
                                  .axis = {1, 0, 0},
                                  .stiffness = {torsion}};
    add_spring(model, &spring);
    return model;
}

/* Rigid motions: three translations, and three rotations about the middle.  Of the bar's own
 * stiffness the springs are 1e-7. */
static void check_frequencies(const hobe_section *section)
{
    const double k[3] = {4, 5, 7}, torsion = 0.03, m = RHO * LENGTH * WIDTH * HEIGHT;
    const double squared[3] = {LENGTH * LENGTH, WIDTH * WIDTH, HEIGHT * HEIGHT};
    double expected[6] = {2 * k[0] / m,
                          2 * k[1] / m,
                          2 * k[2] / m,
                          torsion / (m * (squared[1] + squared[2]) / 12),
                          k[2] * squared[0] / 2 / (m * (squared[0] + squared[2]) / 12),
                          k[1] * squared[0] / 2 / (m * (squared[0] + squared[1]) / 12)};
    hobe_model *model = bedded(section, k, torsion);
    hobe_modes *modes = modes_of(model, NULL, 6, HOBE_MODAL_DENSE);
    for (int i = 0; i < 6; i++) {
        int least = 0;
        for (int j = 1; j < 6; j++)
            least = expected[j] < expected[least] ? j : least;
        check_relative(mode_of(modes, i).omega2, expected[least], 1e-6,
                       "bar on springs: frequency %d", i + 1);
        expected[least] = INFINITY;
    }
    hobe_modes_free(modes);
    hobe_model_free(model);
}

/* In line with the bar, a spring from each end to the ground a distance away; the force P on the
 * bar is shared by them, and the one that is pressed gives way sideways, against a bushing, at P/2
 * = k times that distance. */
static void check_buckling(const hobe_section *section)
{
    struct hobe_error err;
    const double k[3] = {0, 500, 700}, away = 0.3;
    struct hobe_spring spring = {.beam = {"beam"}, .stiffness = {4e5}, .to = {-away, 0, 0}};
    hobe_modes *modes;
    hobe_model *model = bedded(section, k, 3);
    add_spring(model, &spring);
    spring.at[0] = 1;
    spring.to[0] = LENGTH + away;
    add_spring(model, &spring);
    add_force(model, "beam", 0.5, 1, 0, 0);
    if (hobe_buckling(model, NULL, &(struct hobe_modal_options){.modes = 2}, &modes, &err))
        check_stop("%s", err.message);
    for (int i = 0; i < 2; i++)
        check_relative(hobe_modes_factor(modes, i), 2 * away * k[1 + i], 1e-3,
                       "spring in line: load %d", i + 1);
    hobe_modes_free(modes);
    hobe_model_free(model);
}

/* ---- what holds, and what is refused --------------------------------------------------------- */

/* Three lengths at each end of a beam along the axes hold but its rotation about its axis. */
static void check_held(const hobe_section *section)
{
    for (int held = 0; held < 3; held++) {
        struct hobe_error err = {0};
        const double k[3] = {1, held > 0 ? 1 : 0, 1};
        hobe_model *model = bedded(section, k, held > 1 ? 1 : 0);
        hobe_solution *solution = NULL;
        add_force(model, "beam", 1, 0, 0, 1e-6);
        const enum hobe_status status =
            hobe_static(model, &(struct hobe_newton){0}, &solution, &err);
        check_that(status == (held > 1 ? HOBE_OK : HOBE_UNCONSTRAINED) &&
                       (held > 1 || strstr(err.message, "rotation")),
                   "held by %d kinds: %s", held, err.message);
        check_that(held > 0 || strstr(err.message, "translation along y"), "free along y: %s",
                   err.message);
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
}

static void check_refused(const hobe_section *section)
{
    static const struct {
        struct hobe_spring spring;
        const char *says;
    } bad[] = {
        {{.beam = {"beam"}, .at = {2}}, "at must be"},
        {{.beam = {"beam"}, .kind = 7}, "no kind of spring 7"},
        {{.beam = {"beam"}, .kind = HOBE_SPRING_TORSION}, "needs axis"},
        {{.beam = {"beam"}, .axis = {1, 0, 0}}, "only a spring of kind torsion has an axis"},
        {{.beam = {"beam"}, .length = -1}, "must be > 0 (m), got -1"},
        {{.beam = {"beam"}, .kind = HOBE_SPRING_BUSHING, .length = 1}, "has a length, got 1"},
        {{.beam = {"beam"}, .angle = 1}, "has an angle, got 1"},
        {{.beam = {"beam"}, .stiffness = {-3}}, "stiffness of a spring must be >= 0, got -3"},
        {{.beam = {"beam"}, .damping = {NAN}}, "damping of a spring must be >= 0, got nan"},
        {{.beam = {"beam"}, .damping = {1, 2}}, "damping must be one number"},
        {{.beam = {"beam"}}, "coincide, so that it has no direction"},
        {{.beam = {"beam", "none"}}, "there is no beam \"none\""},
        {{.beam = {"beam", "beam"}, .at = {0, 1}, .kind = HOBE_SPRING_BUSHING}, "must coincide"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct hobe_error err = {0};
        const struct hobe_beam beam = stub(section, 1);
        hobe_model *model = cantilever(&beam, 0);
        enum hobe_status status = hobe_model_spring(model, &bad[i].spring, &err);
        if (!status)
            status = hobe_model_build(model, &err);
        check_that(status && strstr(err.message, bad[i].says), "refused: %s: %s", bad[i].says,
                   err.message);
        hobe_model_free(model);
    }
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(WIDTH, HEIGHT);
    for (int kind = 0; kind < KINDS; kind++) {
        for (int grounded = 0; grounded < 2; grounded++)
            check_tangents((enum hobe_spring_kind)kind, grounded, section);
        check_balance((enum hobe_spring_kind)kind, section);
        check_work((enum hobe_spring_kind)kind, section);
    }
    check_prop(section);
    check_tip(section);
    check_hinge(section);
    check_prestress(section);
    check_frequencies(section);
    check_buckling(section);
    check_held(section);
    check_refused(section);
    hobe_section_free(section);
    return check_report();
}
