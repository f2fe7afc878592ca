/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Paths as power series: how many factorisations they need, and that they end where Newton's do;
 * limit points; what has no series; starts from other solutions. */
#include "check.h"
#include "scene.h"
#include "solution.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, PI = 3.14159265358979323846;

static const struct hobe_newton BY_SERIES = {.method = HOBE_METHOD_SERIES};

static hobe_solution *solve_with(hobe_model *model, const struct hobe_newton *options)
{
    struct hobe_error err;
    hobe_solution *solution;
    if (hobe_static(model, options, &solution, &err))
        check_stop("hobe_static: %s", err.message);
    return solution;
}

static hobe_path *follow(hobe_model *model, const struct hobe_path_options *options)
{
    struct hobe_error err;
    hobe_path *path;
    if (hobe_path_follow(model, options, &path, &err))
        check_stop("hobe_path_follow: %s", err.message);
    return path;
}

/* ---- whole paths ----------------------------------------------------------------------------- */

/* Frees the model. */
static void like_newton(hobe_model *model, const char *what, int newton_steps, int most)
{
    hobe_solution *series = solve_with(model, &BY_SERIES), *newton = solve(model, newton_steps);
    const struct hobe_solution_info is = info_of(series), was = info_of(newton);
    double worst = 0, size = 0;
    for (long i = 0; i < 3 * model->beam_vectors; i++) {
        worst = fmax(worst, fabs(series->u[i] - newton->u[i]));
        size = fmax(size, fabs(newton->u[i]));
    }
    check_absolute(worst / size, 0, 1e-10, "%s: all displacements are Newton's", what);
    check_that(is.factorisations <= most, "%s: %d factorisations in %d steps, Newton's %d", what,
               is.factorisations, is.steps, was.factorisations);
    check_absolute(is.load, 1, 1e-14, "%s: at the full load", what);
    hobe_solution_free(series);
    hobe_solution_free(newton);
    hobe_model_free(model);
}

static void statics(void)
{
    hobe_section *section = rectangle(3.2024e-3, 12.377e-3);
    struct hobe_beam beam = beam_along_x("MGD30w", 12, section, 71.7e9, 0.31, 0.508);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, -13.345 * sin(PI / 6), -13.345 * cos(PI / 6));
    like_newton(model, "Princeton, P3 at 30 deg", 1, 4);
    hobe_section_free(section);

    section = rectangle(0.1, 0.1);
    beam = beam_along_x("MGD30w", 8, section, 1e9, 0.3, 5);
    model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, 10 * properties_of(section).Iyy * 1e9 / 25);
    like_newton(model, "elastica, P L^2/EI = 10", 4, 12);
    model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 0, 2 * PI * properties_of(section).Iyy * 1e9 / 5, 0);
    like_newton(model, "rolled up", 8, 16);
    hobe_section_free(section);
}

/* 29 rad, by a fifth of the factorisations of Newton's steps, which are about as many as need the
 * fewest; a single one to begin with comes to another state. */
static void torsion(void)
{
    hobe_section *section = rectangle(0.1, 0.1);
    const struct hobe_beam beam = beam_along_x("MGD30w", 20, section, 1e9, 0.3, 5);
    hobe_model *model = cantilever(&beam, 0);
    add_moment(model, "beam", 1, 31e3, 0, 0);
    hobe_solution *series = solve_with(model, &BY_SERIES), *newton = solve(model, 100);
    struct hobe_error err;
    double twist[2];
    if (hobe_solution_twist(series, "beam", 1, twist, &err) ||
        hobe_solution_twist(newton, "beam", 1, twist + 1, &err))
        check_stop("%s", err.message);
    check_relative(twist[0], twist[1], 1e-10, "twist");
    check_absolute(twist[0], 29, 0.5, "twist, rad");
    check_that(5 * info_of(series).factorisations <= info_of(newton).factorisations,
               "torsion: %d factorisations, Newton's %d", info_of(series).factorisations,
               info_of(newton).factorisations);
    hobe_solution_free(series);
    hobe_solution_free(newton);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- limit points and bifurcations ----------------------------------------------------------- */

static enum hobe_status arc_point(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context;
    (void)err;
    r[0] = 10 * sin(0.1 * (2 * t - 1));
    r[1] = 0;
    r[2] = 10 * cos(0.1 * (2 * t - 1));
    return HOBE_OK;
}

/* Events beside those of small steps, whose cubic errs by 1e-5; loads by a series do not. */
static void compare_events(hobe_model *model, double arc, const char *what)
{
    hobe_path *series = follow(model, &(struct hobe_path_options){.newton = BY_SERIES});
    hobe_path *small =
        follow(model, &(struct hobe_path_options){.newton = {.tolerance = 1e-10}, .arc = arc});
    struct hobe_path_info is, was;
    hobe_path_info(series, &is);
    hobe_path_info(small, &was);
    check_that(is.events == was.events && is.end == HOBE_PATH_LOAD, "%s: %d events of %d", what,
               is.events, was.events);
    for (int i = 0; i < is.events && i < was.events; i++) {
        const struct hobe_path_event *a = hobe_path_event(series, i);
        const struct hobe_path_event *b = hobe_path_event(small, i);
        check_that(a->bifurcation == b->bifurcation && a->change == b->change, "%s: event %d", what,
                   i);
        if (a->bifurcation) /* known no better than the points around it */
            check_that(a->load[0] < b->load[1] && b->load[0] < a->load[1], "%s: bifurcation %d",
                       what, i);
        else
            check_absolute(a->extreme, b->extreme, 1e-5, "%s: limit load %d", what, i);
    }
    check_that(3 * is.factorisations < was.factorisations, "%s: %d factorisations, %d", what,
               is.factorisations, was.factorisations);
    const struct hobe_point p = point_of(hobe_path_point(series, is.points - 1), "beam", 0.5, 0, 0);
    const struct hobe_point q = point_of(hobe_path_point(small, was.points - 1), "beam", 0.5, 0, 0);
    check_absolute(distance(p.u, q.u), 0, 1e-7, "%s: the end, by a residual of 1e-10", what);
    hobe_path_free(series);
    hobe_path_free(small);
}

static void arch(void)
{
    struct hobe_error err;
    hobe_section *section = rectangle(0.05, 0.01);
    hobe_curve *curve = curve_of(arc_point, NULL, NULL);
    struct hobe_beam beam = beam_along_x("MGD30", 16, section, E, 0, 0);
    hobe_model *model = new_model();
    beam.curve = curve;
    add_beam(model, &beam);
    add_clamp(model, "beam", 0, 0);
    add_clamp(model, "beam", 1, 0);
    add_force(model, "beam", 0.5, 0, 0, -1000);
    compare_events(model, 0.05, "a shallow arch");
    const double down = random_real(0.01, 0.08);
    const struct hobe_path_options options = {
        .newton = BY_SERIES, .reach = {.beam = "beam", .at = 0.5, .value = {0, 0, -down}}};
    hobe_path *path = follow(model, &options);
    struct hobe_path_info info;
    hobe_path_info(path, &info);
    check_that(info.end == HOBE_PATH_DISPLACEMENT, "it comes to %g m", down);
    check_relative(-point_of(hobe_path_point(path, info.points - 1), "beam", 0.5, 0, 0).u[2], down,
                   1e-9, "the crown is where it should be");
    hobe_path_free(path);
    hobe_solution *solution;
    check_that(hobe_static(model, &(struct hobe_newton){.method = HOBE_METHOD_SERIES}, &solution,
                           &err) == HOBE_OK &&
                   info_of(solution).negative == 0,
               "static by series goes through limit points");
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_curve_free(curve);
    hobe_section_free(section);
}

/* A blade under a force at its tip along its high side leaves its plane: one eigenvalue turns. */
static void lateral_buckling(void)
{
    hobe_section *section = rectangle(0.01, 0.1);
    const struct hobe_beam beam = beam_along_x("MGD30w", 8, section, E, 0.3, 2);
    hobe_model *model = cantilever(&beam, 0);
    const struct hobe_section_properties is = properties_of(section);
    const double G = E / 2.6;
    const double critical = 4.013 * sqrt(E * is.Izz * G * is.J) / 4; /* Prandtl, Michell 1899 */
    add_force(model, "beam", 1, 0, 0, -2 * critical);
    hobe_path *path = follow(model, &(struct hobe_path_options){.newton = BY_SERIES, .arc = 0.1});
    struct hobe_path_info info;
    hobe_path_info(path, &info);
    const struct hobe_path_event *event = hobe_path_event(path, 0);
    check_that(info.events == 1 && event->bifurcation && event->change == 1, "%d events",
               info.events);
    check_that(event && event->load[0] < 0.5 * 1.02 && 0.5 < event->load[1] * 1.02,
               "the critical load, 0.5, is between %g and %g", event->load[0], event->load[1]);
    hobe_path_free(path);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- starts ---------------------------------------------------------------------------------- */

static hobe_model *bent(const hobe_section *section, int elements, double P)
{
    const struct hobe_beam beam = beam_along_x("MGD30w", elements, section, E, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    if (P != 0)
        add_force(model, "beam", 1, 0, P / 2, P);
    return model;
}

static void starts(const hobe_section *section)
{
    struct hobe_error err;
    hobe_model *first = bent(section, 4, 2e3), *second = bent(section, 4, 2.1e3);
    hobe_model *other = bent(section, 5, 2e3), *far = bent(section, 4, -1e6);
    hobe_solution *start = solve(first, 1), *cold = solve(second, 1), *none;
    const struct hobe_newton options = {.start = start, .tolerance = 1e-13};
    hobe_solution *warm = solve_with(second, &options);
    check_absolute(distance(point_of(warm, "beam", 1, 0, 0).u, point_of(cold, "beam", 1, 0, 0).u),
                   0, 1e-11, "from another load: the same equilibrium");
    check_that(info_of(warm).iterations < info_of(cold).iterations, "in fewer iterations: %d, %d",
               info_of(warm).iterations, info_of(cold).iterations);
    hobe_solution_free(warm);
    warm = solve_with(first, &options);
    check_that(info_of(warm).iterations <= 1, "from itself: %d iterations",
               info_of(warm).iterations);
    hobe_solution_free(warm);
    check_that(hobe_static(other, &options, &none, &err) == HOBE_BAD_INPUT && !none &&
                   strstr(err.message, "same shape"),
               "another mesh: %s", err.message);
    const struct hobe_newton hard = {.start = start, .max_iterations = 4, .smallest_step = 1e-6};
    warm = solve_with(far, &hard);
    check_that(info_of(warm).steps > 1 && info_of(warm).cutbacks > 0 && info_of(warm).load == 1,
               "too far: by steps from the reference");
    hobe_solution_free(warm);
    hobe_solution_free(cold);
    hobe_solution_free(start);
    hobe_model_free(first);
    hobe_model_free(second);
    hobe_model_free(other);
    hobe_model_free(far);
}

/* Frees the model. */
static void check_refusal(hobe_model *model, const char *words)
{
    struct hobe_error err;
    hobe_solution *solution;
    add_force(model, "beam", 1, 0, 0, 1);
    check_that(hobe_static(model, &BY_SERIES, &solution, &err) == HOBE_BAD_INPUT && !solution &&
                   strstr(err.message, words),
               "%s: %s", words, err.message);
    hobe_model_free(model);
}

static enum hobe_status no_force(void *context, double t, const double x[3], const double v[3],
                                 double F[3], struct hobe_error *err)
{
    (void)context, (void)t, (void)x, (void)v, (void)err;
    F[0] = F[1] = F[2] = 0;
    return HOBE_OK;
}

/* What has no power series, and what needs none. */
static void refused(const hobe_section *section)
{
    struct hobe_error err;
    const double point[2][2] = {{0, 0}, {1, 1}};
    const struct hobe_beam beam = beam_along_x("3333s", 2, section, E, 0.3, 1);
    struct hobe_beam heavy = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    const struct hobe_spring spring = {.beam = {"beam"}, .kind = HOBE_SPRING_BUSHING, .at = {1}};
    const struct hobe_force force = {.beam = "beam", .at = 1, .function = no_force};
    const struct hobe_spin spin = {.axis = {0, 0, 1}, .speed = 1};
    hobe_drive *drive = hobe_drive_points(2, point, HOBE_RAMP, 0, &err);
    const struct hobe_joint driven = {
        .beam = {"beam"}, .at = {1}, .kind = HOBE_JOINT_INLINE, .axis = {1}, .position = drive};
    check_refusal(cantilever(&beam, 0), "that of 3333s (beam \"beam\") is none: use");
    hobe_model *model = bent(section, 2, 0);
    if (!drive || hobe_model_spring(model, &spring, &err))
        check_stop("%s", err.message);
    check_refusal(model, "no power series of springs; use method = \"newton\"");
    model = bent(section, 2, 0);
    if (hobe_model_force(model, &force, &err))
        check_stop("%s", err.message);
    check_refusal(model, "no power series of forces that are functions of the state; use");
    heavy.material.rho = 2700;
    model = cantilever(&heavy, 0);
    if (hobe_model_spin(model, &spin, &err))
        check_stop("%s", err.message);
    check_refusal(model, "no power series of a scene that spins; use");
    model = bent(section, 2, 0);
    add_joint(model, &driven);
    check_refusal(model, "cannot follow a driven joint; use hobe.static with method = \"newton\"");
    hobe_drive_free(drive);
    model = bent(section, 2, 0);
    hobe_solution *solution = solve_with(model, &BY_SERIES);
    check_that(info_of(solution).load == 1 && info_of(solution).steps == 0, "no load");
    hobe_solution_free(solution);
    hobe_model_free(model);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.02, 0.03);
    starts(section);
    refused(section);
    hobe_section_free(section);
    statics();
    torsion();
    arch();
    lateral_buckling();
    return check_report();
}
