/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Equilibrium paths: a clamped shallow arch through both its limit points and up again, beside its
 * classical theory; equilibrium, energy and step length; bifurcations; how a path ends. */
#include "check.h"
#include "scene.h"

#include <complex.h>
#include <math.h>
#include <string.h>

static const double E = 70e9, R = 10, BETA = 0.1, PI = 3.14159265358979323846;
static const double WIDTH = 0.05, HEIGHT = 0.01;

static enum hobe_status arc_point(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context;
    (void)err;
    const double a = BETA * (2 * t - 1);
    r[0] = R * sin(a);
    r[1] = 0;
    r[2] = R * cos(a);
    return HOBE_OK;
}

struct arch {
    hobe_section *section;
    hobe_curve *curve;
    hobe_model *model;
};

/* A clamped arch with a load down at `at`, that of one load factor. */
static struct arch make_arch(const char *element, int elements, double at, double load)
{
    struct arch arch = {rectangle(WIDTH, HEIGHT), curve_of(arc_point, NULL, NULL), new_model()};
    struct hobe_beam beam = beam_along_x(element, elements, arch.section, E, 0, 0);
    beam.curve = arch.curve;
    add_beam(arch.model, &beam);
    add_clamp(arch.model, "beam", 0, 0);
    add_clamp(arch.model, "beam", 1, 0);
    add_force(arch.model, "beam", at, 0, 0, -load);
    return arch;
}

static void free_arch(struct arch *arch)
{
    hobe_model_free(arch->model);
    hobe_curve_free(arch->curve);
    hobe_section_free(arch->section);
}

static hobe_path *follow(hobe_model *model, const struct hobe_path_options *options)
{
    struct hobe_error err;
    hobe_path *path;
    if (hobe_path_follow(model, options, &path, &err))
        check_stop("hobe_path_follow: %s", err.message);
    return path;
}

static struct hobe_path_info path_info(const hobe_path *path)
{
    struct hobe_path_info info;
    hobe_path_info(path, &info);
    return info;
}

static double crown(const hobe_solution *point)
{
    return -point_of(point, "beam", 0.5, 0, 0).u[2];
}

/* ---- theory ---------------------------------------------------------------------------------- */

/* The symmetric state of a clamped shallow arch under P at its crown with the thrust EI m^2, m
 * imaginary where that is a pull (Schreyer & Masur 1966): w = x^2/2R + A cos m x + B + D (sin m x/m
 * - x)/m^2, w up, x from the crown, P = 2 EI D, w = w' = 0 at x = L; the thrust is EA times the
 * mean of x w'/R - w'^2/2, a quadratic in D.  Gives P and the way down of the crown of one root. */
static int shallow_arch(double complex m, int root, double *P, double *down)
{
    const double L = R * BETA, inertia = WIDTH * pow(HEIGHT, 3) / 12, area = WIDTH * HEIGHT;
    const double complex s = csin(m * L), c = ccos(m * L);
    enum { POINTS = 100 }; /* of Simpson's rule: 1e-8 of the integrals */
    double k[3] = {-pow(L, 3) / (6 * R * R) + inertia * creal(m * m) * L / area, 0, 0};
    for (int i = 0; i <= POINTS; i++) { /* w' - x/R = g0 + D g1 */
        const double x = i * L / POINTS, weight = i % POINTS == 0 ? 1 : 2 + 2 * (i % 2);
        const double g0 = creal(-L / R * csin(m * x) / s);
        const double g1 = creal((ccos(m * x) - 1 - (c - 1) * csin(m * x) / s) / (m * m));
        k[0] += weight * g0 * g0 * L / (6 * POINTS);
        k[1] += weight * g0 * g1 * L / (3 * POINTS);
        k[2] += weight * g1 * g1 * L / (6 * POINTS);
    }
    const double under = k[1] * k[1] - 4 * k[0] * k[2];
    if (under < 0)
        return 0;
    const double D = (-k[1] + (root ? 1 : -1) * sqrt(under)) / (2 * k[2]);
    const double complex A = (L / R + D * (c - 1) / (m * m)) / (m * s);
    *P = 2 * E * inertia * D;
    *down = creal(A * (c - 1) + L * L / (2 * R) + D * (s / m - L) / (m * m));
    return 1;
}

/* All symmetric states from a pull to the second pole of the thrust, m L = 2 pi. */
enum { STATES = 8000 };
struct state {
    int is;
    double P, down;
};
static struct state states[2][STATES];

static void find_states(void)
{
    for (int root = 0; root < 2; root++)
        for (int i = 0; i < STATES; i++) {
            const double m = 2 * PI / (R * BETA) * ((2 * i + 1.0) / STATES - 1);
            struct state *to = &states[root][i];
            to->is = shallow_arch(m < 0 ? I * m : m, root, &to->P, &to->down);
        }
}

/* Makes *best the load between two states at that crown, where it is nearer to P. */
static void try_between(const struct state *a, const struct state *b, double down, double P,
                        double *best)
{
    if (!a->is || !b->is || a->down == b->down || (a->down - down) * (b->down - down) > 0)
        return;
    const double at = a->P + (b->P - a->P) * (down - a->down) / (b->down - a->down);
    if (fabs(at - P) < fabs(*best - P))
        *best = at;
}

/* Of all states with that crown the load nearest to P; where one root ends the other begins. */
static double theory_load(double down, double P)
{
    double best = INFINITY;
    for (int i = 1; i < STATES; i++) {
        for (int root = 0; root < 2; root++)
            try_between(&states[root][i - 1], &states[root][i], down, P, &best);
        if (states[0][i].is != states[0][i - 1].is) {
            const int last = states[0][i].is ? i : i - 1;
            try_between(&states[0][last], &states[1][last], down, P, &best);
        }
    }
    return best;
}

/* ---- the arch -------------------------------------------------------------------------------- */

static const double LOAD = 1000; /* N; the limit is at about a half */

static const struct hobe_path_options FINE = {.arc = 0.1, .newton = {.tolerance = 1e-10}};

/* Up to the limit load, down through the lower one and up again, all of it within 1 % beside
 * theory, which leaves out the square of slopes: BETA^2 = 1 %, and more at the end. */
static void beside_theory(const char *element, int elements)
{
    struct arch arch = make_arch(element, elements, 0.5, LOAD);
    hobe_path *path = follow(arch.model, &FINE);
    const struct hobe_path_info info = path_info(path);
    double worst = 0;
    check_that(info.end == HOBE_PATH_LOAD, "%s: it comes to its load", element);
    const double limit = hobe_path_event(path, 0)->extreme * LOAD;
    for (int i = 0; i < info.points; i++) {
        const hobe_solution *point = hobe_path_point(path, i);
        const double P = info_of(point).load * LOAD;
        worst = fmax(worst, fabs(P - theory_load(crown(point), P)) / fmax(P, limit));
    }
    check_absolute(worst, 0, 1e-2, "%s: the whole path beside the theory of shallow arches",
                   element);
    check_absolute(info_of(hobe_path_point(path, info.points - 1)).load, 1, 1e-12,
                   "%s: the last load", element);
    hobe_path_free(path);
    free_arch(&arch);
}

static void limit_points(void)
{
    struct arch arch = make_arch("MGD30", 16, 0.5, LOAD);
    struct hobe_path_options coarse = FINE;
    hobe_path *path = follow(arch.model, &FINE);
    coarse.arc = FINE.arc / 2;
    hobe_path *halved = follow(arch.model, &coarse);
    int limits = 0, negative = 0;
    char text[300];
    for (int i = 0; hobe_path_event(path, i); i++) {
        const struct hobe_path_event *event = hobe_path_event(path, i);
        hobe_path_event_text(event, text, sizeof text);
        check_that(strstr(text, event->bifurcation ? "bifurcation between" : "limit point") != NULL,
                   "%s", text);
        check_absolute(event->extreme, hobe_path_event(halved, i)->extreme, 1e-4,
                       "event %d: the same with half the arc, whose error is a 16th", i);
        limits += !event->bifurcation;
        negative += event->change;
    }
    check_that(limits == 2, "up, down and up again: %d limit points", limits);
    check_that(negative == 0 && path_info(path).events == path_info(halved).events,
               "it ends stable: %d", negative);
    const double down = crown(hobe_path_point(path, path_info(path).points - 1));
    /* the end of the path is the same equilibrium, however it was come to */
    check_relative(down, crown(hobe_path_point(halved, path_info(halved).points - 1)), 1e-9,
                   "the end of the path from half the arc length");
    hobe_path_free(path);
    hobe_path_free(halved);
    free_arch(&arch);
}

/* Points at one displacement, from paths of two arc lengths: the same load. */
static void reach(void)
{
    struct arch arch = make_arch("MGD30w", 8, 0.5, LOAD);
    for (int i = 0; i < 4; i++) {
        const double down = random_real(0.002, 0.085);
        struct hobe_path_options options = FINE;
        double load[2];
        options.reach = (struct hobe_reach){.beam = "beam", .at = 0.5, .value = {0, 0, -down}};
        for (int k = 0; k < 2; k++) {
            options.arc = FINE.arc / (1 + k);
            hobe_path *path = follow(arch.model, &options);
            const struct hobe_path_info info = path_info(path);
            const hobe_solution *last = hobe_path_point(path, info.points - 1);
            check_that(info.end == HOBE_PATH_DISPLACEMENT, "it comes to %g m", down);
            check_relative(crown(last), down, 1e-9, "the crown is where it should be");
            load[k] = info_of(last).load;
            hobe_path_free(path);
        }
        check_absolute(load[1], load[0], 1e-6, "the load there, from half the arc length");
    }
    free_arch(&arch);
}

/* Every point is an equilibrium, and the strain energy is the work of
 * the load along the path, by trapezoids between its points. */
static void equilibrium(void)
{
    struct arch arch = make_arch("MGD30w", 8, 0.4, LOAD);
    struct hobe_path_options options = FINE;
    double error[2];
    for (int k = 0; k < 2; k++) {
        options.arc = 0.05 / (1 + k);
        options.steps = 1000;
        hobe_path *path = follow(arch.model, &options);
        double work = 0, last = 0, last_load = 0, most = 0;
        for (int i = 0; hobe_path_point(path, i); i++) {
            const hobe_solution *point = hobe_path_point(path, i);
            const double down = -point_of(point, "beam", 0.4, 0, 0).u[2];
            check_that(info_of(point).residual <= 1e-9, "point %d: residual %g", i,
                       info_of(point).residual);
            work += LOAD * (info_of(point).load + last_load) / 2 * (down - last);
            error[k] = info_of(point).energy - work;
            most = fmax(most, info_of(point).energy);
            last = down;
            last_load = info_of(point).load;
        }
        error[k] /= most;
        hobe_path_free(path);
    }
    check_absolute(error[0], 0, 1e-2, "the energy is the work of the load, trapezoids");
    check_that(fabs(error[1]) < 0.35 * fabs(error[0]),
               "and better with half the arc, by the square: %g, %g", error[1], error[0]);
    free_arch(&arch);
}

/* ---- bifurcations ---------------------------------------------------------------------------- */

/* A perfect column goes on straight through Euler's loads of both axes, and they are told; also
 * with a corner, where the signs of multipliers are told apart. */
static void column(int corner)
{
    hobe_section *section = rectangle(0.01, 0.02);
    struct hobe_beam beam = beam_along_x("MGD30", 8, section, E, 0.3, corner ? 0.5 : 1);
    hobe_model *model = cantilever(&beam, 0);
    if (corner) { /* turned about the axis by a right angle */
        beam.name = "outer";
        beam.from[0] = 0.5;
        beam.to[0] = 1;
        beam.up[1] = 1;
        add_beam(model, &beam);
        add_join(model, "beam", 1, "outer", 0);
    }
    const double weak = PI * PI * E * properties_of(section).Izz / 4;
    const double strong = 4 * weak; /* of the straight one */
    add_force(model, corner ? "outer" : "beam", 1, -6 * weak, 0, 0);
    const struct hobe_path_options options = {.arc = 0.02};
    hobe_path *path = follow(model, &options);
    int found = 0;
    for (int i = 0; hobe_path_event(path, i); i++) {
        const struct hobe_path_event *event = hobe_path_event(path, i);
        check_that(event->bifurcation && event->change == 1, "column: event %d, change %d", i,
                   event->change);
        if (!corner) {
            const double at = (found ? strong : weak) / (6 * weak);
            check_that(event->load[0] < at * 1.001 && at * 0.998 < event->load[1],
                       "Euler's load %g between %g and %g", at, event->load[0], event->load[1]);
        }
        found++;
    }
    check_that(found == 2, "%d bifurcations", found);
    hobe_path_free(path);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- how a path begins and ends -------------------------------------------------------------- */

/* A path to load 1 of a beam that bends by its own length ends where hobe_static does. */
static void like_static(void)
{
    hobe_section *section = rectangle(0.01, 0.02);
    const struct hobe_beam beam = beam_along_x("MGD30w", 6, section, 1e9, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, random_real(3, 6), random_real(-6, -3));
    /* From -0.64 N m on the path turns before the load is reached, and static ends there. */
    add_moment(model, "beam", 1, random_real(-0.4, 1), 0, 0);
    hobe_solution *solution = solve(model, 4);
    const struct hobe_path_options options = {.arc = 0.2};
    hobe_path *path = follow(model, &options);
    const struct hobe_path_info info = path_info(path);
    hobe_solution *last = hobe_path_take(path, info.points - 1);
    check_that(!hobe_path_point(path, info.points - 1) && !hobe_path_take(path, info.points),
               "taken");
    const struct hobe_point a = point_of(last, "beam", 1, 0, 0);
    const struct hobe_point b = point_of(solution, "beam", 1, 0, 0);
    check_absolute(distance(a.u, b.u), 0, 1e-8, "the end of the path is the static solution");
    check_that(info_of(last).negative == 0 && info.events == 0, "and stable");
    hobe_solution_free(last);
    hobe_solution_free(solution);
    hobe_path_free(path);
    hobe_model_free(model);
    hobe_section_free(section);
}

static void ends(void)
{
    struct hobe_error err = {0};
    hobe_path *path;
    struct arch arch = make_arch("MGD30", 8, 0.5, LOAD);
    struct hobe_path_options options = {.steps = 3};
    path = follow(arch.model, &options);
    check_that(path_info(path).end == HOBE_PATH_STEPS && path_info(path).points == 3 &&
                   !hobe_path_event(path, 0),
               "three steps");
    hobe_path_free(path);
    options.to = -0.1; /* pulled up */
    options.steps = 0;
    path = follow(arch.model, &options);
    const hobe_solution *last = hobe_path_point(path, path_info(path).points - 1);
    check_absolute(info_of(last).load, -0.1, 1e-12, "it starts towards its end");
    check_that(crown(last) < 0, "pulled up");
    hobe_path_free(path);
    options.reach = (struct hobe_reach){.beam = "bean", .at = 0.5, .value = {0, 0, 1}};
    check_that(hobe_path_follow(arch.model, &options, &path, &err) == HOBE_UNKNOWN && !path &&
                   strstr(err.message, "bean"),
               "no such beam: %s", err.message);
    options.reach = (struct hobe_reach){.beam = "beam", .at = 0.5};
    check_that(hobe_path_follow(arch.model, &options, &path, &err) == HOBE_BAD_INPUT && !path,
               "no direction: %s", err.message);
    options = (struct hobe_path_options){.smallest_arc = 0.9, .newton = {.max_iterations = 1}};
    check_that(hobe_path_follow(arch.model, &options, &path, &err) == HOBE_NOT_CONVERGED && !path &&
                   strstr(err.message, "could not be followed beyond 0 of the load"),
               "too few iterations: %s", err.message);
    free_arch(&arch);
    arch = make_arch("MGD30", 8, 0.5, 0);
    check_that(hobe_path_follow(arch.model, &options, &path, &err) == HOBE_BAD_INPUT && !path,
               "no load: %s", err.message);
    free_arch(&arch);
    hobe_path_free(NULL);
}

int main(void)
{
    random_start();
    find_states();
    beside_theory("MGD30", 48);
    beside_theory("3333s", 48);
    limit_points();
    reach();
    equilibrium();
    column(0);
    column(1);
    like_static();
    ends();
    return check_report();
}
