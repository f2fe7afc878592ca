/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solvers confined to few fields: where a scene is cut, what the modes hold exactly, that all of
 * them give the full solution, and what few give.  Looks into the core for the modes. */
#include "component_modes.h"

#include "check.h"
#include "scene.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 1e9, ALL = 1e6;

static struct hobe_beam bar(const hobe_section *section, int elements)
{
    struct hobe_beam beam = beam_along_x("MGD30", elements, section, E, 0.3, 1);
    beam.material.rho = 1000;
    return beam;
}

/* A clamped beam "beam", and "second" beyond it on a joint, held at its end where asked for. */
static hobe_model *two_beams(const hobe_section *section, enum hobe_joint_kind kind, int held)
{
    struct hobe_beam beam = bar(section, 3);
    hobe_model *model = cantilever(&beam, 0);
    beam.name = "second";
    beam.from[0] = 1;
    beam.to[0] = 2;
    add_beam(model, &beam);
    struct hobe_joint joint = {.beam = {"beam", "second"}, .at = {1, 0}, .kind = kind};
    joint.axis[1] = kind == HOBE_JOINT_REVOLUTE;
    add_joint(model, &joint);
    if (held)
        add_joint(model, &(struct hobe_joint){
                             .beam = {"second"}, .at = {1}, .kind = HOBE_JOINT_SPHERICAL});
    return model;
}

static hobe_solution *solve_projected(hobe_model *model, int steps,
                                      const struct hobe_projection *projection)
{
    const struct hobe_newton options = {
        .steps = steps, .tolerance = 1e-12, .projection = projection};
    hobe_solution *solution;
    struct hobe_error err;
    if (hobe_static(model, &options, &solution, &err))
        check_stop("%s", err.message);
    return solution;
}

/* The largest difference of displacements along a beam, relative to the largest. */
static double apart(const hobe_solution *a, const hobe_solution *b, const char *beam)
{
    double most = 0, size = 0;
    for (int i = 0; i <= 10; i++) {
        const struct hobe_point p = point_of(a, beam, i / 10.0, 0.01, 0.02);
        const struct hobe_point q = point_of(b, beam, i / 10.0, 0.01, 0.02);
        most = fmax(most, distance(p.u, q.u));
        size = fmax(size, norm(q.u));
    }
    return most / size;
}

/* ---- interfaces ------------------------------------------------------------------------------ */

static void count_interfaces(hobe_model *model, long expected, const char *what)
{
    struct hobe_error err;
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    unsigned char *kept = hobe_alloc((size_t)model->unknowns, sizeof *kept, &err);
    if (!kept || component_interfaces(model, kept, &err))
        check_stop("%s", err.message);
    long count = 0;
    for (long i = 0; i < model->unknowns; i++)
        count += kept[i];
    check_that(count == expected, "%s: %ld vectors are kept, %ld expected", what, count, expected);
    hobe_free(kept);
    hobe_model_free(model);
}

/* A node of MGD30 has r, r_x, r_y and r_z at an end of an element, and r_y and r_z in its middle.
 */
static void test_interfaces(const hobe_section *section)
{
    const struct hobe_beam beam = bar(section, 4);
    hobe_model *model = cantilever(&beam, 0);
    count_interfaces(model, 0, "no load");
    model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 1, 0, 0);
    count_interfaces(model, 4, "a moment at the end");
    model = cantilever(&beam, 0);
    add_force(model, "beam", 0.5, 0, 1, 0);
    add_follower(model, "beam", 1, 0, 1, 0);
    count_interfaces(model, 8, "a force between two elements and a follower");
    model = cantilever(&beam, 0);
    add_force(model, "beam", 0.6, 0, 1, 0);
    count_interfaces(model, 8, "a force inside an element, on r and r_x of its ends");
    count_interfaces(two_beams(section, HOBE_JOINT_SPHERICAL, 0), 8 + 1,
                     "a spherical joint, three multipliers");
    count_interfaces(two_beams(section, HOBE_JOINT_REVOLUTE, 0), 8 + 2,
                     "a revolute joint, five of six multipliers");
}

/* ---- what modes hold ------------------------------------------------------------------------- */

/* The share of a field of the unknowns, scaled, that is outside of the space. */
static double outside(const struct subspace *space, double *phi)
{
    double size = 0, left = 0;
    for (long i = 0; i < space->n; i++)
        size += phi[i] * phi[i];
    for (long j = 0; j < space->count; j++) {
        const double *w = space->W + j * space->n, along = dot(space->n, w, phi);
        for (long i = 0; i < space->n; i++)
            phi[i] -= along * w[i];
    }
    for (long i = 0; i < space->n; i++)
        left += phi[i] * phi[i];
    return sqrt(left / size);
}

/* phi = a random rigid motion of the vectors of "second", which are at q[vectors][3]. */
static void move_second(const hobe_model *model, const double *q, double *phi)
{
    const struct beam *beam = model_beam(model, 1);
    double v[3], w[3];
    random_direction(v);
    random_direction(w);
    for (int e = 0; e < beam->spec.elements; e++)
        for (int i = 0; i < beam->kernel->vectors; i++) {
            const struct hobe_vector *is = beam->kernel->vector + i;
            const long vector = model_vector(model, beam, e, i);
            double *to = phi + 3 * model->unknown[vector];
            cross3(w, q + 3 * vector, to);
            for (int a = 0; a < 3 && is->mode == 0 && !is->slope; a++)
                to[a] += v[a];
        }
}

/* A rigid motion of a component is one of its constraint modes, on its own. */
static void test_rigid_motions(const hobe_section *section)
{
    struct hobe_error err;
    struct subspace space = {0};
    hobe_model *model = two_beams(section, HOBE_JOINT_SPHERICAL, 0);
    add_force(model, "second", 1, 0, 0, 1);
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    const size_t n = (size_t)(3 * model->unknowns), all = (size_t)(3 * model->vectors);
    double *u = hobe_alloc(all, sizeof *u, &err), *q = hobe_alloc(all, sizeof *q, &err);
    double *scale = hobe_alloc(n, sizeof *scale, &err), *phi = hobe_alloc(n, sizeof *phi, &err);
    if (!u || !q || !scale || !phi)
        check_stop("%s", err.message);
    model_reference(model, q);
    for (size_t i = 0; i < n; i++)
        scale[i] = 1;
    const struct hobe_projection interfaces = {.modes = 3 * 12};
    if (component_modes(model, &interfaces, u, 0, scale, &space, &err))
        check_stop("%s", err.message);
    check_that(space.count == 3 * 13, "%ld modes of the interfaces, 39 expected", space.count);
    for (int i = 0; i < 5; i++) {
        memset(phi, 0, n * sizeof *phi);
        move_second(model, q, phi);
        check_absolute(outside(&space, phi), 0, 1e-10, "a rigid motion");
    }
    subspace_close(&space);
    hobe_free(u);
    hobe_free(q);
    hobe_free(scale);
    hobe_free(phi);
    hobe_model_free(model);
}

/* Of small loads on the interfaces, constraint modes alone hold the response (Guyan 1965), of which
 * the load's square is left out; and all modes hold any. */
static void test_small_loads(const hobe_section *section)
{
    double F[3], M[3];
    random_direction(F);
    random_direction(M);
    struct hobe_beam beam = bar(section, 6);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 0.5, 1e-6 * F[0], 1e-6 * F[1], 1e-6 * F[2]);
    add_moment(model, "beam", 1, 1e-6 * M[0], 1e-6 * M[1], 1e-6 * M[2]);
    hobe_solution *full = solve_projected(model, 1, NULL);
    hobe_solution *few = solve_projected(model, 1, &(struct hobe_projection){.modes = 3 * 8});
    check_that(info_of(few).projected == 24, "24 unknowns, got %ld", info_of(few).projected);
    check_absolute(apart(few, full, "beam"), 0, 1e-8, "small loads on interfaces");
    hobe_solution_free(full);
    hobe_solution_free(few);
    hobe_model_free(model);
}

/* Up to a frequency: with its end held, the cantilever has the modes of a beam clamped twice. */
static void test_frequency(const hobe_section *section)
{
    const double frequency = pow(10, random_real(3.5, 6)); /* some to all of them */
    const struct hobe_beam beam = bar(section, 5);
    hobe_model *model = cantilever(&beam, 0), *twice = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, 1e-6);
    add_clamp(twice, "beam", 1, 0);
    hobe_modes *modes = modes_of(twice, NULL, 78, HOBE_MODAL_DENSE);
    int below = 0;
    while (below < 78 && mode_of(modes, below).omega <= frequency)
        below++;
    hobe_solution *few =
        solve_projected(model, 1, &(struct hobe_projection){.frequency = frequency});
    check_that(info_of(few).projected == 12 + below, "%ld fields up to %g rad/s, %d modes",
               info_of(few).projected, frequency, below);
    hobe_solution_free(few);
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_model_free(twice);
}

/* A mesh so fine that Lanczos' method finds the modes; of a small weight, which is no load on
 * interfaces, the lowest leave out little: the static response falls off as omega^-2 of modes that
 * are further and further apart. */
static void test_fine_mesh(const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_beam beam = bar(section, 20);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, 1e-3);
    if (hobe_model_gravity(model, NULL, (const double[3]){0, 1e-3, -2e-3}, &err))
        check_stop("%s", err.message);
    hobe_solution *full = solve_projected(model, 1, NULL);
    double last = INFINITY;
    for (int modes = 12; modes <= 40; modes += 14) {
        hobe_solution *few = solve_projected(model, 1, &(struct hobe_projection){.modes = modes});
        const double error = apart(few, full, "beam");
        check_that(error < (modes == 12 ? INFINITY : 0.2 * last), "%d modes: %g", modes, error);
        last = error;
        hobe_solution_free(few);
    }
    check_absolute(last, 0, 1e-4, "the weight by 40 modes");
    hobe_solution_free(full);
    hobe_model_free(model);
}

/* ---- large displacements --------------------------------------------------------------------- */

/* All modes give the full solution; few give another, which is stiffer, and say so. */
static void test_all_modes(const hobe_section *section)
{
    struct hobe_beam beam = bar(section, 4);
    hobe_model *model = cantilever(&beam, 0);
    const double way = random_real(-1, 1);
    add_force(model, "beam", 1, 5e2, 5e2 * way, 1e3);
    add_moment(model, "beam", 1, 8e2, 0, 3e2 * way);
    hobe_solution *full = solve_projected(model, 4, NULL);
    hobe_solution *all = solve_projected(model, 4, &(struct hobe_projection){.modes = (int)ALL});
    hobe_solution *few = solve_projected(model, 4, &(struct hobe_projection){.modes = 30});
    check_absolute(apart(all, full, "beam"), 0, 1e-9, "all modes");
    check_absolute(info_of(all).outside, 0, 1e-9, "all modes leave nothing");
    check_that(info_of(full).projected == 0 && info_of(full).linearisations == 0,
               "none of the full");
    check_that(info_of(few).projected == 30 && info_of(few).linearisations == 4,
               "30 modes at 4 steps, got %ld and %d", info_of(few).projected,
               info_of(few).linearisations);
    check_that(info_of(few).outside > 1e-3, "few modes leave a residual, %g", info_of(few).outside);
    check_that(info_of(few).residual < 1e-11, "but not along them, %g", info_of(few).residual);
    check_absolute(info_of(all).indicator, 0, 1e-9, "the indicator of all modes");
    check_that(info_of(few).indicator > apart(few, full, "beam"), "that of few: %g",
               info_of(few).indicator);
    const struct hobe_point a = point_of(few, "beam", 1, 0, 0), b = point_of(full, "beam", 1, 0, 0);
    check_that(norm(a.u) < norm(b.u), "they are stiffer: %g, %g m", norm(a.u), norm(b.u));
    hobe_solution_free(full);
    hobe_solution_free(all);
    hobe_solution_free(few);
    hobe_model_free(model);
}

/* Modes of smaller steps do better: what a turning section needs of second order falls with them.
 */
static void test_more_steps(const hobe_section *section)
{
    struct hobe_beam beam = bar(section, 2);
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 1e3, 0, 0);
    hobe_solution *full = solve_projected(model, 4, NULL);
    double last = INFINITY;
    for (int steps = 4; steps <= 64; steps *= 4) {
        hobe_solution *few = solve_projected(model, steps, &(struct hobe_projection){.modes = 30});
        const double error = apart(few, full, "beam");
        check_that(error < 0.7 * last, "error in %d steps: %g after %g", steps, error, last);
        last = error;
        hobe_solution_free(few);
    }
    hobe_solution_free(full);
    hobe_model_free(model);
}

static void test_joint(const hobe_section *section)
{
    hobe_model *model = two_beams(section, HOBE_JOINT_REVOLUTE, 1);
    add_force(model, "second", 0.5, 1e3, 3e3, -3e3 * random_real(0.5, 1));
    hobe_solution *full = solve_projected(model, 4, NULL);
    hobe_solution *all = solve_projected(model, 4, &(struct hobe_projection){.modes = (int)ALL});
    hobe_solution *few = solve_projected(model, 4, &(struct hobe_projection){.modes = 70});
    check_absolute(apart(all, full, "second"), 0, 1e-9, "all modes of two beams");
    const struct hobe_point a = point_of(few, "beam", 1, 0, 0);
    const struct hobe_point b = point_of(few, "second", 0, 0, 0);
    check_absolute(distance(a.r, b.r), 0, 1e-10, "few modes keep the joint closed");
    hobe_solution_free(full);
    hobe_solution_free(all);
    hobe_solution_free(few);
    hobe_model_free(model);
}

/* ---- motion ---------------------------------------------------------------------------------- */

/* A bar that hangs along x from a hinge and is pushed. */
static hobe_model *pendulum(const hobe_section *section, double speed)
{
    struct hobe_error err;
    const struct hobe_beam beam = bar(section, 3);
    const struct hobe_motion motion = {.beam = "beam", .angular_velocity = {0, speed, 0}};
    hobe_model *model = new_model();
    add_beam(model, &beam);
    add_joint(model, &(struct hobe_joint){
                         .beam = {"beam"}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 1, 0}});
    if (hobe_model_gravity(model, NULL, (const double[3]){9.81, 0, 0}, &err) ||
        hobe_model_motion(model, &motion, &err))
        check_stop("%s", err.message);
    return model;
}

static hobe_history *move(hobe_model *model, double step, const struct hobe_projection *projection)
{
    const struct hobe_dynamic options = {
        .to = 0.3, .step = step, .store = 0.3, .projection = projection};
    struct hobe_error err;
    hobe_history *history;
    if (hobe_dynamic(model, &options, &history, &err))
        check_stop("%s", err.message);
    return history;
}

/* How far two motions are apart at their end, relative to what has been moved. */
static double moved_apart(const hobe_history *a, const hobe_history *b)
{
    return apart(hobe_history_state(a, 1), hobe_history_state(b, 1), "beam");
}

/* A swing of 1e-5 rad, in which the bar is stretched as far as it swings: it takes the normal mode
 * that is stretched to be pulled back at all.  Each ten modes leave a tenth of the error, by 40 it
 * is 1e-4. */
static void test_small_swing(const hobe_section *section)
{
    hobe_model *model = pendulum(section, 4e-5);
    hobe_history *full = move(model, 5e-3, NULL);
    hobe_history *few = move(model, 5e-3, &(struct hobe_projection){.modes = 40});
    struct hobe_history_info info;
    hobe_history_info(few, &info);
    check_that(info.projected == 46 && info.linearisations == 1,
               "40 modes and 6 multipliers, found once: %ld, %d", info.projected,
               info.linearisations);
    check_absolute(moved_apart(few, full), 0, 5e-4, "a small swing by 40 modes");
    hobe_history_free(full);
    hobe_history_free(few);
    hobe_model_free(model);
}

/* All modes give the full motion; where they are found again accelerations settle, which changes
 * it by what the steps leave anyway, of second order. */
static void test_large_swing(const hobe_section *section)
{
    hobe_model *model = pendulum(section, 4);
    const struct hobe_projection once = {.modes = (int)ALL, .deviation = 1e3},
                                 again = {.modes = (int)ALL};
    hobe_history *full = move(model, 5e-3, NULL), *fine = move(model, 2.5e-3, NULL);
    hobe_history *one = move(model, 5e-3, &once), *more = move(model, 5e-3, &again);
    struct hobe_history_info info;
    hobe_history_info(more, &info);
    check_absolute(moved_apart(one, full), 0, 1e-7, "all modes, found once");
    check_that(info.linearisations > 5, "%d times found again", info.linearisations);
    check_that(moved_apart(more, full) < 2 * moved_apart(fine, full),
               "all modes, found again: apart by %g, steps by %g", moved_apart(more, full),
               moved_apart(fine, full));
    hobe_history_free(full);
    hobe_history_free(fine);
    hobe_history_free(one);
    hobe_history_free(more);
    hobe_model_free(model);
}

/* ---- snapshots ------------------------------------------------------------------------------- */

enum { TRAINED = 6 };

static hobe_model *bent(const hobe_section *section, double y, double z)
{
    const struct hobe_beam beam = bar(section, 4);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, y, z);
    return model;
}

static void test_snapshots(const hobe_section *section)
{
    hobe_model *trained[TRAINED];
    hobe_solution *snapshot[TRAINED];
    for (int i = 0; i < TRAINED; i++) {
        trained[i] = bent(section, 0, 1e3 * (i + 1));
        snapshot[i] = solve_projected(trained[i], 1, NULL);
    }
    const struct hobe_projection pod = {.method = HOBE_PROJECTION_SNAPSHOTS,
                                        .snapshot = (const hobe_solution *const *)snapshot,
                                        .snapshots = TRAINED};
    hobe_model *seen = bent(section, 0, 2.5e3), *other = bent(section, 2.5e3, 0);
    hobe_solution *full = solve_projected(seen, 1, NULL), *few = solve_projected(seen, 1, &pod);
    check_that(info_of(few).projected <= TRAINED, "as many unknowns as states at most");
    check_absolute(apart(few, full, "beam"), 0, 1e-4, "between loads it was trained with");
    hobe_solution *bound = solve_projected(other, 1, &pod);
    check_absolute(norm(point_of(bound, "beam", 1, 0, 0).u), 0, 1e-9,
                   "across them nothing moves: displacement");
    hobe_solution *state = solve_projected(
        trained[3], 1,
        &(struct hobe_projection){.method = HOBE_PROJECTION_SNAPSHOTS,
                                  .modes = TRAINED,
                                  .snapshot = (const hobe_solution *const *)snapshot,
                                  .snapshots = TRAINED});
    check_absolute(apart(state, snapshot[3], "beam"), 0, 1e-9, "a state of the training");
    hobe_solution_free(full);
    hobe_solution_free(few);
    hobe_solution_free(bound);
    hobe_solution_free(state);
    hobe_model_free(seen);
    hobe_model_free(other);
    for (int i = 0; i < TRAINED; i++) {
        hobe_solution_free(snapshot[i]);
        hobe_model_free(trained[i]);
    }
}

/* ---- errors ---------------------------------------------------------------------------------- */

static void refuse(hobe_model *model, const struct hobe_projection *projection, const char *says)
{
    const struct hobe_newton options = {.projection = projection};
    hobe_solution *solution;
    struct hobe_error err;
    const enum hobe_status status = hobe_static(model, &options, &solution, &err);
    check_that(status == HOBE_BAD_INPUT && !solution && strstr(err.message, says), "%s: %s", says,
               status ? err.message : "solved");
}

static void test_errors(const hobe_section *section)
{
    hobe_model *model = bent(section, 0, 1), *massless, *jointed;
    struct hobe_beam beam = bar(section, 2);
    hobe_path *path;
    hobe_history *history;
    struct hobe_error err;
    hobe_solution *state = solve_projected(model, 1, NULL);
    const hobe_solution *const states[] = {state};
    const struct hobe_projection few = {.modes = 6}, pod = {.method = HOBE_PROJECTION_SNAPSHOTS,
                                                            .modes = 2,
                                                            .snapshot = states,
                                                            .snapshots = 1};
    refuse(model, &few, "at least 12, one for each displacement");
    refuse(model, &(struct hobe_projection){.method = HOBE_PROJECTION_SNAPSHOTS}, "some results");
    refuse(model, &pod, "2 modes are asked for of results that have 1 directions");
    beam.material.rho = 0;
    massless = cantilever(&beam, 0);
    add_force(massless, "beam", 1, 0, 0, 1);
    refuse(massless, &few, "a projection by component modes");
    refuse(massless, &pod, "another shape");
    jointed = two_beams(section, HOBE_JOINT_REVOLUTE, 1);
    add_force(jointed, "beam", 1, 0, 0, 1);
    refuse(jointed, &pod, "joints and bodies");
    check_that(hobe_path_follow(model, &(struct hobe_path_options){.newton = {.projection = &few}},
                                &path, &err) == HOBE_BAD_INPUT &&
                   strstr(err.message, "not for paths"),
               "a path: %s", err.message);
    check_that(hobe_dynamic(model, &(struct hobe_dynamic){.to = 1, .step = 0.1, .projection = &few},
                            &history, &err) == HOBE_BAD_INPUT &&
                   strstr(err.message, "at least 12"),
               "a motion: %s", err.message);
    hobe_solution_free(state);
    hobe_model_free(model);
    hobe_model_free(massless);
    hobe_model_free(jointed);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.05, 0.08);
    test_interfaces(section);
    test_rigid_motions(section);
    test_small_loads(section);
    test_frequency(section);
    test_fine_mesh(section);
    test_all_modes(section);
    test_more_steps(section);
    test_joint(section);
    test_small_swing(section);
    test_large_swing(section);
    test_snapshots(section);
    test_errors(section);
    hobe_section_free(section);
    return check_report();
}
