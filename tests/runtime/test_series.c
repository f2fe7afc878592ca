/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Paths as power series: every coefficient, for every kind of load and joint, by how the residual
 * of the series falls; how many factorisations a path needs, and that it ends where Newton's does;
 * limit points; starts from other solutions.  Looks into the core (series.h). */
#include "check.h"
#include "scene.h"
#include "series.h"
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

/* ---- coefficients ---------------------------------------------------------------------------- */

/* The residual of a series at a, as a share of the load. */
static double residual_at(struct series *series, double a)
{
    struct solver *s = series->s;
    solver_evaluate(s, series_move(series, a), NO_TANGENT);
    return solver_norm(s, s->r, 1) / s->load_norm;
}

/* The slope of the series beside differences of its states. */
static void check_slope(const struct series *series, double a, const char *what)
{
    const struct solver *s = series->s;
    const size_t n = (size_t)(3 * s->model->unknowns);
    const double h = 1e-4 * a; /* its square and, of the series, round-off: 1e-8 or less */
    double *v = hobe_alloc(3 * n, sizeof *v, NULL), *w[] = {v + n, v + 2 * n};
    double worst = 0, most = 0;
    check_absolute(series_slope(series, a, v), 1, 1e-12, "%s: by the load", what);
    for (int side = 0; side < 2; side++) {
        series_move(series, side ? a + h : a - h);
        solver_restrict(s->model, s->u, w[side]);
    }
    for (size_t i = 0; i < n; i++) { /* one measure for all, as in solver_norm */
        worst = fmax(worst, fabs((w[1][i] - w[0][i]) / (2 * h) - v[i]) / s->scale[i]);
        most = fmax(most, fabs(v[i]) / s->scale[i]);
    }
    check_absolute(worst / most, 0, 1e-6, "%s: slope", what);
    hobe_free(v);
}

/* The power by which the residual falls between a and a/2, the first a down where it is `most`. */
static double power_of(struct series *series, double a, double most)
{
    while (!(residual_at(series, a) <= most))
        a *= 0.9;
    return log2(residual_at(series, a) / residual_at(series, a / 2));
}

/* A series that ends with its n-th term. */
static void cut_off(struct series *series, int n)
{
    for (int k = n + 1; k <= SERIES_ORDER; k++) {
        memset(series->u[k], 0, (size_t)(3 * series->s->model->vectors) * sizeof(double));
        series->lambda[k] = 0;
    }
}

/* About a state of load factor 1 the residual of N terms is of order N + 1, and a wrong one among
 * them would be seen as its smaller power. */
static void check_order(hobe_model *model, const char *what)
{
    struct hobe_error err;
    struct solver s;
    struct series series;
    hobe_solution *at = solve(model, 4);
    const struct hobe_newton options = {0};
    if (solver_open(&s, model, &options, &err) || series_open(&series, &s, &err))
        check_stop("%s: %s", what, err.message);
    memcpy(s.u, at->u, (size_t)(3 * model->vectors) * sizeof *s.u);
    solver_evaluate(&s, 1, TRUE_TANGENT);
    if (solver_factor(&s, &err) != CONVERGED || series_expand(&series, 1, NULL, 1, &err))
        check_stop("%s: no series", what);
    const double a = series_range(&series, 1e-3);
    check_slope(&series, a / 2, what);
    /* Where the residual is 1e-3 the next terms, of either sign, are 0.7 of each other or more. */
    check_absolute(power_of(&series, a, 1e-3), SERIES_ORDER + 1, 6, "%s: power of the residual",
                   what);
    /* Where it is 1e-9 they are a few 0.01 of terms up to the 4th. */
    for (int n = 4; n > 0; n--) {
        cut_off(&series, n);
        check_absolute(power_of(&series, a, 1e-9), n + 1, 0.5, "%s: power of the residual", what);
    }
    series_close(&series);
    solver_close(&s);
    hobe_solution_free(at);
    hobe_model_free(model);
}

static hobe_model *arm(const char *element, const hobe_section *section)
{
    const struct hobe_beam beam = beam_along_x(element, 3, section, E, 0.3, 1);
    return cantilever(&beam, 0);
}

static void loads(const char *element, const hobe_section *section)
{
    double d[3];
    hobe_model *model = arm(element, section);
    random_direction(d);
    add_force(model, "beam", 1, 300 * d[0], 300 * d[1], 300 * d[2]);
    check_order(model, "a force");
    model = arm(element, section);
    random_direction(d);
    add_moment(model, "beam", 0.8, 500 * d[0], 500 * d[1], 500 * d[2]);
    check_order(model, "a moment");
    model = arm(element, section);
    random_direction(d);
    add_follower(model, "beam", 1, 200 * d[0], 200 * d[1], 200 * d[2]);
    add_force(model, "beam", 0.5, 100 * d[2], 100 * d[0], 100 * d[1]);
    check_order(model, "a follower force");
}

/* Two beams, the first clamped, the second held by the joint and a support. */
static void joint(const struct hobe_joint *joint, const hobe_section *section)
{
    struct hobe_error err;
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 0.5);
    hobe_model *model = cantilever(&beam, 0);
    const struct hobe_joint support = {.beam = {"outer"}, .at = {1}, .kind = HOBE_JOINT_FIXED};
    const double gap = joint->kind == HOBE_JOINT_DISTANCE ? 0.2 : 0;
    beam.name = "outer";
    beam.from[0] = 0.5 + gap;
    beam.to[0] = 1 + gap;
    add_beam(model, &beam);
    if (hobe_model_joint(model, joint, &err) || hobe_model_joint(model, &support, &err))
        check_stop("%s", err.message);
    add_force(model, "beam", 0.9, random_real(20, 50), random_real(50, 100), -100);
    add_moment(model, "outer", 0.3, 20, random_real(-20, 20), random_real(-20, 20));
    check_order(model, hobe_joint_name(joint->kind));
}

static void joints(const hobe_section *section)
{
    for (int kind = 0; kind <= HOBE_JOINT_DISTANCE; kind++) {
        struct hobe_joint is = {
            .beam = {"beam", "outer"}, .at = {1, 0}, .kind = (enum hobe_joint_kind)kind};
        if (kind != HOBE_JOINT_FIXED && kind != HOBE_JOINT_SPHERICAL && kind != HOBE_JOINT_DISTANCE)
            is.axis[1] = 1;
        if (kind == HOBE_JOINT_UNIVERSAL)
            is.second[2] = 1;
        joint(&is, section);
    }
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

static void refused(const hobe_section *section)
{
    struct hobe_error err;
    const struct hobe_beam beam = beam_along_x("3333s", 2, section, E, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    hobe_solution *solution;
    add_force(model, "beam", 1, 0, 0, 1);
    check_that(hobe_static(model, &BY_SERIES, &solution, &err) == HOBE_BAD_INPUT && !solution &&
                   strstr(err.message, "3333s"),
               "no polynomial: %s", err.message);
    hobe_model_free(model);
    model = bent(section, 2, 0);
    solution = solve_with(model, &BY_SERIES);
    check_that(info_of(solution).load == 1 && info_of(solution).steps == 0, "no load");
    hobe_solution_free(solution);
    hobe_model_free(model);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.02, 0.03);
    loads("MGD30w", section);
    loads("34X3", section);
    joints(section);
    starts(section);
    refused(section);
    hobe_section_free(section);
    statics();
    torsion();
    arch();
    lateral_buckling();
    return check_report();
}
