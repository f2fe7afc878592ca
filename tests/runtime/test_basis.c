/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How few unknowns are enough: reduced models against the whole ones in the cases they are made
 * for, at loads their bases were not made of; and whether they know when they are not. */
#include "basis.h"
#include "check.h"
#include "scene.h"
#include "solution.h"
#include "trust.h"
#include "vector3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static void expect_ok(enum hobe_status status, const struct hobe_error *err)
{
    if (status)
        check_stop("%s: %s", hobe_status_words(status), err->message);
}

static hobe_reduced *reduce(hobe_model *model, const struct hobe_reduce *options)
{
    struct hobe_error err;
    hobe_reduced *reduced;
    expect_ok(hobe_reduce(model, options, &reduced, &err), &err);
    return reduced;
}

static int unknowns_of(const hobe_reduced *reduced)
{
    struct hobe_reduced_info info;
    hobe_reduced_info(reduced, &info);
    return info.unknowns;
}

static hobe_model *small_of(const hobe_reduced *reduced, hobe_model *model)
{
    struct hobe_error err;
    hobe_model *small;
    expect_ok(hobe_reduced_model(reduced, model, &small, &err), &err);
    return small;
}

static hobe_solution *solve_by(hobe_model *model, enum hobe_method method, int steps)
{
    struct hobe_error err;
    hobe_solution *solution;
    const struct hobe_newton options = {.method = method, .steps = steps, .tolerance = 1e-10};
    expect_ok(hobe_static(model, &options, &solution, &err), &err);
    return solution;
}

static double twist_of(const hobe_solution *solution)
{
    struct hobe_error err;
    double twist;
    expect_ok(hobe_solution_twist(solution, "beam", 1, &twist, &err), &err);
    return twist;
}

/* Their tips' distance over the first one's displacement. */
static double apart(const hobe_solution *a, const hobe_solution *b)
{
    const struct hobe_point p = point_of(a, "beam", 1, 0, 0), q = point_of(b, "beam", 1, 0, 0);
    return distance(p.u, q.u) / norm(p.u);
}

/* ---- torsion --------------------------------------------------------------------------------- */

static hobe_model *twisted(const struct hobe_beam *beam, double moment)
{
    hobe_model *model = cantilever(beam, 0);
    add_moment(model, "beam", 1, moment, 0, 0);
    return model;
}

/* A basis of the path to a moment, at that and on the way. */
static void torsion(const struct hobe_beam *beam, double moment, int modes, double turns, int steps,
                    const char *what)
{
    hobe_model *model = twisted(beam, moment);
    hobe_reduced *reduced = reduce(model, &(struct hobe_reduce){.modes = modes});
    check_that(unknowns_of(reduced) <= modes, "%s: %d unknowns of %d", what, unknowns_of(reduced),
               modes);
    struct hobe_coarse coarse;
    struct hobe_error err;
    for (int i = 0; i < 3; i++) {
        const double share = i == 0 ? 1 : random_real(0.1, 0.9);
        hobe_model *other = twisted(beam, share * moment), *small = small_of(reduced, other);
        hobe_solution *whole = solve_by(other, HOBE_METHOD_SERIES, 1);
        hobe_solution *is = solve_by(small, HOBE_METHOD_NEWTON, steps);
        const double expected = twist_of(whole);
        check_relative(twist_of(is), expected, 1e-3, "%s: twist at %g of the moment", what, share);
        check_that(i > 0 || expected > turns, "%s: %g rad", what, expected);
        check_that(info_of(is).indicator < 1e-3, "%s: indicator %g", what, info_of(is).indicator);
        expect_ok(hobe_reduced_coarse(small, is, &coarse, &err), &err);
        check_that(coarse.elements > 0 && coarse.reduced < 1e-3 && coarse.error > 1e-2,
                   "%s: %d elements err by %g, reduced by %g", what, coarse.elements, coarse.error,
                   coarse.reduced);
        hobe_solution_free(whole);
        hobe_solution_free(is);
        hobe_model_free(small);
        hobe_model_free(other);
    }
    hobe_reduced_free(reduced);
    hobe_model_free(model);
}

static void torsions(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.1, 0.1);
    struct hobe_beam beam = beam_along_x("MGD30w", 12, section, 1e9, 0.3, 2);
    torsion(&beam, 5.45e3, 6, 2, 4, "square to 2 rad");
    torsion(&beam, 41.5e3, 30, 16, 32, "square to 16 rad");
    hobe_section_free(section);
    const struct hobe_profile_sizes sizes = {0.215, 0.1, 0.015, 0.01, 0, 0};
    section = hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_PAPER, &err);
    if (!section)
        check_stop("%s", err.message);
    beam = beam_along_x("MGD30w", 12, section, 210e9, 0.3, 2);
    torsion(&beam, 60e3, 12, 2, 8, "I to 2 rad");
    torsion(&beam, 360e3, 22, 5, 16, "I to 5 rad");
    hobe_section_free(section);
}

/* ---- the Princeton beam ---------------------------------------------------------------------- */

static hobe_model *princeton(const struct hobe_beam *beam, double angle)
{
    hobe_model *model = cantilever(beam, 0);
    add_force(model, "beam", 1, 0, -13.345 * sin(angle), -13.345 * cos(angle));
    return model;
}

/* One basis of two directions for all angles, on both sides of them. */
static void all_angles(const struct hobe_beam *beam, int modes, double in_twist)
{
    hobe_model *along = princeton(beam, 0), *across = princeton(beam, PI / 2);
    const struct hobe_reduce options = {.modes = modes, .loads = &across, .load_count = 1};
    hobe_reduced *reduced = reduce(along, &options);
    check_that(unknowns_of(reduced) <= modes, "Princeton: %d unknowns of %d", unknowns_of(reduced),
               modes);
    for (int i = 0; i < 8; i++) {
        const double angle = PI / 4 * (i + random_real(0.1, 0.9));
        hobe_model *model = princeton(beam, angle), *small = small_of(reduced, model);
        hobe_solution *whole = solve_by(model, HOBE_METHOD_SERIES, 1);
        hobe_solution *is = solve_by(small, HOBE_METHOD_NEWTON, 2);
        check_absolute(apart(whole, is), 0, 1e-3, "Princeton, %d unknowns at %g rad", modes, angle);
        check_relative(twist_of(is), twist_of(whole), in_twist, "twist, %d unknowns at %g rad",
                       modes, angle);
        hobe_solution_free(whole);
        hobe_solution_free(is);
        hobe_model_free(small);
        hobe_model_free(model);
    }
    hobe_reduced_free(reduced);
    hobe_model_free(across);
    hobe_model_free(along);
}

/* About a state that the load leads to the basis has that among its fields, and comes back. */
static void about_a_state(const struct hobe_beam *beam)
{
    hobe_model *full = princeton(beam, 0.5), *half = cantilever(beam, 0);
    add_force(half, "beam", 1, 0, -6 * sin(0.5), -6 * cos(0.5));
    hobe_solution *centre = solve(full, 1), *whole = solve(half, 1);
    hobe_reduced *reduced = reduce(full, &(struct hobe_reduce){.modes = 9, .centre = centre});
    hobe_model *small = small_of(reduced, half);
    hobe_solution *is = solve_by(small, HOBE_METHOD_NEWTON, 1);
    check_that(unknowns_of(reduced) <= 9, "with the centre: %d unknowns", unknowns_of(reduced));
    check_absolute(apart(whole, is), 0, 1e-5, "back from a state");
    hobe_solution_free(is);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_solution_free(centre);
    hobe_solution_free(whole);
    hobe_model_free(half);
    hobe_model_free(full);
}

static void angles(void)
{
    hobe_section *section = rectangle(3.2024e-3, 12.377e-3);
    const struct hobe_beam beam = beam_along_x("MGD30w", 12, section, 71.7e9, 0.31, 0.508);
    all_angles(&beam, 20, 1.5e-2);
    all_angles(&beam, 27, 1e-3);
    about_a_state(&beam);
    hobe_section_free(section);
}

/* ---- a beam that spins ----------------------------------------------------------------------- */

static hobe_model *spinning(const struct hobe_beam *beam, double speed, double force)
{
    struct hobe_error err;
    hobe_model *model = cantilever(beam, 1);
    const struct hobe_spin spin = {.axis = {0, 0, 1}, .speed = speed};
    if (speed > 0)
        expect_ok(hobe_model_spin(model, &spin, &err), &err);
    if (force != 0)
        add_force(model, "beam", 1, 0, force, 0);
    return model;
}

/* Extension and bending at a speed, in the plane of the turn. */
static void steady(const hobe_reduced *reduced, const struct hobe_beam *beam, double speed,
                   double force, double within)
{
    hobe_model *model = spinning(beam, speed, force), *small = small_of(reduced, model);
    hobe_solution *whole = solve(model, 1), *is = solve_by(small, HOBE_METHOD_NEWTON, 1);
    check_absolute(apart(whole, is), 0, within, "at %g rad/s under %g N", speed, force);
    hobe_solution_free(whole);
    hobe_solution_free(is);
    hobe_model_free(small);
    hobe_model_free(model);
}

/* The two lowest frequencies in the turning frame. */
static void rotating(const hobe_reduced *reduced, const struct hobe_beam *beam, double speed,
                     double within)
{
    hobe_model *model = spinning(beam, speed, 0), *small = small_of(reduced, model);
    hobe_solution *whole = solve(model, 1), *is = solve_by(small, HOBE_METHOD_NEWTON, 1);
    hobe_modes *expected = modes_of(model, whole, 2, HOBE_MODAL_AUTO);
    hobe_modes *modes = modes_of(small, is, 2, HOBE_MODAL_AUTO);
    check_absolute(apart(whole, is), 0, 1e-3, "extension at %g rad/s", speed);
    for (int i = 0; i < 2; i++)
        check_relative(mode_of(modes, i).omega, mode_of(expected, i).omega, within,
                       "frequency %d at %g rad/s", i, speed);
    hobe_modes_free(modes);
    hobe_modes_free(expected);
    hobe_solution_free(whole);
    hobe_solution_free(is);
    hobe_model_free(small);
    hobe_model_free(model);
}

static void spin(void)
{
    hobe_section *section = rectangle(sqrt(0.006), sqrt(0.006));
    struct hobe_beam beam = beam_along_x("MGD30", 8, section, 4.6666667e9, 0, 10);
    beam.material.rho = 200;
    beam.material.k2 = beam.material.k3 = 0.714286;
    hobe_model *model = spinning(&beam, 12, 0), *bent = spinning(&beam, 0, 30);
    hobe_reduced *reduced =
        reduce(model, &(struct hobe_reduce){.modes = 7, .loads = &bent, .load_count = 1});
    steady(reduced, &beam, random_real(2, 6), 0, 1e-3);
    steady(reduced, &beam, random_real(2, 6), random_real(5, 30), 1e-3);
    steady(reduced, &beam, 12, random_real(5, 30), 5e-3);
    hobe_reduced_free(reduced);
    reduced = reduce(model, &(struct hobe_reduce){.method = HOBE_REDUCE_MODES, .modes = 7});
    rotating(reduced, &beam, random_real(2, 6), 2e-3);
    rotating(reduced, &beam, 12, 2e-3);
    hobe_reduced_free(reduced);
    hobe_model_free(bent);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- trust ----------------------------------------------------------------------------------- */

/* A force anywhere, and a moment, of up to the size of what the basis knows. */
static hobe_model *random_case(const struct hobe_beam *beam, double force)
{
    double d[3], m[3];
    hobe_model *model = cantilever(beam, 0);
    const double size = force * pow(10, random_real(-2, 0));
    random_direction(d);
    random_direction(m);
    add_force(model, "beam", random_real(0.3, 1), size * d[0], size * d[1], size * d[2]);
    if (random_real(0, 1) < 0.5)
        add_moment(model, "beam", 1, 0, size * m[1] / 3, size * m[2] / 3);
    return model;
}

/* The indicator of a case over its true error, in the indicator's own norm. */
static double ratio_of(const hobe_reduced *reduced, hobe_model *model)
{
    struct hobe_error err;
    struct trust trust;
    hobe_model *small = small_of(reduced, model);
    hobe_solution *whole = solve(model, 4), *is = solve_by(small, HOBE_METHOD_NEWTON, 4);
    expect_ok(trust_open(&trust, model, &err), &err);
    const double size = trust_norm(&trust, is->u);
    for (long i = 0; i < 3 * model->vectors; i++)
        whole->u[i] -= is->u[i];
    const double error = trust_norm(&trust, whole->u) / size, indicator = info_of(is).indicator;
    check_that(indicator >= error, "the indicator, %g, is not below the error, %g", indicator,
               error);
    trust_close(&trust);
    hobe_solution_free(whole);
    hobe_solution_free(is);
    hobe_model_free(small);
    return indicator / error;
}

static hobe_history *move(hobe_model *model)
{
    struct hobe_error err;
    hobe_history *history;
    const struct hobe_dynamic options = {.to = 0.6, .step = 0.01, .store = 0.1};
    expect_ok(hobe_dynamic(model, &options, &history, &err), &err);
    return history;
}

/* The indicators of states in motion beside their true errors: estimates, since what is out of
 * balance at a stored state was not always.  They are held to half of the error, and the worst to
 * twenty times the worst. */
static void motion(int modes)
{
    struct hobe_error err;
    struct trust trust;
    hobe_section *section = rectangle(0.1, 0.06);
    struct hobe_beam beam = beam_along_x("MGD30w", 4, section, 1e9, 0.3, 2);
    beam.material.rho = 1000;
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 300, 500);
    hobe_reduced *reduced =
        reduce(model, &(struct hobe_reduce){.method = HOBE_REDUCE_MODES, .modes = modes});
    hobe_model *small = small_of(reduced, model);
    hobe_history *is = move(small), *was = move(model);
    double size = 0, worst = 0, worst_error = 0;
    expect_ok(trust_open(&trust, model, &err), &err);
    for (int i = 1; hobe_history_state(is, i); i++) {
        const hobe_solution *a = hobe_history_state(is, i), *b = hobe_history_state(was, i);
        double *apart = calloc((size_t)(3 * model->vectors), sizeof *apart);
        size = fmax(size, trust_norm(&trust, a->u));
        for (long j = 0; j < 3 * model->vectors; j++)
            apart[j] = a->u[j] - b->u[j];
        const double error = trust_norm(&trust, apart) / size;
        check_that(info_of(a).indicator >= error / 2, "in motion: indicator %g of %g",
                   info_of(a).indicator, error);
        worst = fmax(worst, info_of(a).indicator);
        worst_error = fmax(worst_error, error);
        free(apart);
    }
    check_that(worst <= 20 * worst_error, "in motion: the worst is %g of %g", worst, worst_error);
    trust_close(&trust);
    hobe_history_free(is);
    hobe_history_free(was);
    hobe_model_free(small);
    hobe_reduced_free(reduced);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* So many unknowns as an accuracy needs; and what is asked of it besides is refused. */
static void accurate(void)
{
    struct hobe_error err;
    hobe_solution *solution;
    int before = 0;
    hobe_section *section = rectangle(0.1, 0.06);
    const struct hobe_beam beam = beam_along_x("MGD30w", 6, section, 1e9, 0.3, 2);
    const double force = 2 * 1e9 * properties_of(section).Iyy / 4;
    hobe_model *model = cantilever(&beam, 0), *across = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, force);
    add_force(across, "beam", 1, 0, force, 0);
    for (double accuracy = 1e-2; accuracy > 1e-5; accuracy /= 30) {
        hobe_reduced *reduced = reduce(model, &(struct hobe_reduce){.accuracy = accuracy});
        hobe_model *small = small_of(reduced, model), *other = small_of(reduced, across);
        hobe_solution *whole = solve(model, 1), *is = solve_by(small, HOBE_METHOD_NEWTON, 1);
        check_absolute(apart(whole, is), 0, accuracy, "accuracy %g", accuracy);
        check_that(info_of(is).indicator <= accuracy, "indicator %g for accuracy %g",
                   info_of(is).indicator, accuracy);
        check_that(unknowns_of(reduced) > before, "accuracy %g takes more than %d unknowns",
                   accuracy, before);
        before = unknowns_of(reduced);
        const enum hobe_status status =
            hobe_static(other, &(struct hobe_newton){0}, &solution, &err);
        check_that(status == HOBE_NOT_CONVERGED, "what it was not made for is refused: %s",
                   status ? err.message : "no error");
        hobe_solution_free(whole);
        hobe_solution_free(is);
        hobe_model_free(other);
        hobe_model_free(small);
        hobe_reduced_free(reduced);
    }
    hobe_reduced *none;
    const struct hobe_reduce few = {.accuracy = 1e-6, .modes = 2};
    check_that(hobe_reduce(model, &few, &none, &err) == HOBE_NOT_CONVERGED && !none,
               "two unknowns are not that accurate");
    hobe_model_free(across);
    hobe_model_free(model);
    hobe_section_free(section);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void indicator(void)
{
    enum { CASES = 100 };
    double ratio[CASES];
    hobe_section *section = rectangle(0.1, 0.06);
    const struct hobe_beam beam = beam_along_x("MGD30w", 6, section, 1e9, 0.3, 2);
    const double force = 2 * 1e9 * properties_of(section).Iyy / 4;
    hobe_model *model = cantilever(&beam, 0), *across = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, force);
    add_force(across, "beam", 1, 0, force, 0);
    hobe_reduced *reduced =
        reduce(model, &(struct hobe_reduce){.modes = 18, .loads = &across, .load_count = 1});
    for (int i = 0; i < CASES; i++) {
        hobe_model *other = random_case(&beam, force);
        ratio[i] = ratio_of(reduced, other);
        hobe_model_free(other);
    }
    qsort(ratio, CASES, sizeof *ratio, ascending);
    check_that(ratio[CASES / 2] <= 5, "the indicator's median is %g times the error",
               ratio[CASES / 2]);
    hobe_reduced_free(reduced);
    hobe_model_free(across);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- rotations ------------------------------------------------------------------------------- */

/* u[vectors][3] = R (x_0 + u) - x_0 with a random rotation, about the normal unless NULL. */
static void turn(const hobe_model *model, const double *normal, double *u)
{
    double axis[3], *x0 = calloc((size_t)(3 * model->vectors), sizeof *x0);
    const double angle = random_real(-3, 3);
    random_direction(axis);
    if (normal)
        memcpy(axis, normal, sizeof axis);
    model_reference(model, x0);
    for (long v = 0; v < model->beam_vectors; v++) {
        double q[3], across[3];
        for (int a = 0; a < 3; a++)
            q[a] = x0[3 * v + a] + u[3 * v + a];
        cross3(axis, q, across);
        for (int a = 0; a < 3; a++)
            u[3 * v + a] = cos(angle) * q[a] + sin(angle) * across[a] +
                           (1 - cos(angle)) * dot3(axis, q) * axis[a] - x0[3 * v + a];
    }
    free(x0);
}

/* A bar on a joint, which may turn as a whole: its states, turned, are in the closed space. */
static void closed(int of, const double normal[3])
{
    struct hobe_error err;
    struct basis basis;
    hobe_section *section = rectangle(0.1, 0.06);
    const struct hobe_beam beam = beam_along_x("MGD30w", 3, section, 1e9, 0.3, 2);
    hobe_model *model = new_model();
    add_beam(model, &beam);
    add_joint(model, &(struct hobe_joint){.beam = {"beam"}, .kind = HOBE_JOINT_FIXED});
    add_force(model, "beam", 1, 0, normal ? 0 : 200, 500);
    struct hobe_reduce options = {.modes = 3, .closed = of};
    if (normal)
        memcpy(options.normal, normal, sizeof options.normal);
    expect_ok(basis_make(model, &options, &basis, &err), &err);
    const long n = basis.n, size = 3 * model->vectors;
    double *u = calloc((size_t)size, sizeof *u);
    for (long j = 0; j < 3; j++)
        for (long i = 0; i < size; i++)
            u[i] += 0.1 * basis.field[j * size + i];
    turn(model, normal, u);
    expect_ok(basis_add(&basis, model, &options, u, &err), &err);
    check_that(basis.n == n, "closed = %d: a turned state is among the %ld fields", of, n);
    u[3 * (model->beam_vectors / 2)] += 1;
    expect_ok(basis_add(&basis, model, &options, u, &err), &err);
    check_that(basis.n > n, "closed = %d: and another one is not", of);
    free(u);
    basis_free(&basis);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- what makes no basis --------------------------------------------------------------------- */

static void refused(hobe_model *model, const struct hobe_reduce *options, const char *sentence)
{
    struct hobe_error err;
    struct basis basis;
    const enum hobe_status status = basis_make(model, options, &basis, &err);
    check_that(status == HOBE_BAD_INPUT && strstr(err.message, sentence), "\"%s\": %s", sentence,
               status ? err.message : "no error");
    basis_free(&basis);
}

static void refusals(void)
{
    hobe_section *section = rectangle(0.1, 0.06);
    struct hobe_beam beam = beam_along_x("MGD30w", 3, section, 1e9, 0.3, 2);
    hobe_model *model = cantilever(&beam, 0);
    refused(model, &(struct hobe_reduce){.modes = 3}, "there are none");
    refused(model, &(struct hobe_reduce){.closed = 1}, "got closed = 1");
    refused(model, &(struct hobe_reduce){.closed = 2}, "needs its normal, got {0, 0, 0}");
    beam.elements = 4;
    hobe_model *other = twisted(&beam, 1);
    refused(model, &(struct hobe_reduce){.loads = &other, .load_count = 1}, "number 1 has others");
    hobe_model_free(other);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    torsions();
    angles();
    spin();
    indicator();
    accurate();
    motion(6);
    motion(15);
    closed(3, NULL);
    closed(2, (const double[]){0, 1, 0});
    refusals();
    return check_report();
}
