/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Load steps over limit points are told, with the load of the limit point: a truss in closed form
 * and arches beside their paths, at a little and at many times that load; and what lies on the path
 * from rest is not, and is found where Newton's iteration from rest finds something else. */
#include "check.h"
#include "scene.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

static hobe_solution *at_once(hobe_model *model, enum hobe_method method)
{
    const struct hobe_newton options = {.method = method};
    struct hobe_error err;
    hobe_solution *solution;
    if (hobe_static(model, &options, &solution, &err))
        check_stop("hobe_static: %s", err.message);
    return solution;
}

/* ---- two bars -------------------------------------------------------------------------------- */

static void hinge(hobe_model *model, const char *first, double at, const char *second)
{
    const struct hobe_joint joint = {
        .beam = {first, second}, .at = {at}, .kind = HOBE_JOINT_REVOLUTE, .axis = {0, 1, 0}};
    add_joint(model, &joint);
}

/* Hinged bars from (-1, 0, 0) and (1, 0, 0) to (0, 0, H), and a load P down at the top. */
static hobe_model *truss(const hobe_section *section, double E, double H, double P)
{
    hobe_model *model = new_model();
    for (int i = 0; i < 2; i++) {
        struct hobe_beam bar = beam_along_x("MGD30", 1, section, E, 0, 0);
        bar.name = i ? "right" : "left";
        bar.material.rho = 1000;
        bar.from[0] = i ? 0 : -1;
        bar.from[2] = i ? H : 0;
        bar.to[0] = i;
        bar.to[2] = i ? 0 : H;
        add_beam(model, &bar);
    }
    hinge(model, "left", 0, NULL);
    hinge(model, "right", 1, NULL);
    hinge(model, "left", 1, "right");
    add_force(model, "left", 1, 0, 0, -P);
    return model;
}

/* Bars without Poisson's ratio have Green's strain (v^2 - H^2)/2l^2 with the top at height v, and
 * P = EA v (H^2 - v^2)/l^3: the limit is at v = H/sqrt(3), and it is found by steps of a millionth
 * of the load.  Bars as stout as these do not buckle before. */
static void two_bars(double times)
{
    const double E = 1e9, height = 0.1, H = random_real(0.03, 0.12);
    const double EA = E * height * height, l = sqrt(1 + H * H);
    const double limit = EA * 2 * pow(H, 3) / (3 * sqrt(3) * pow(l, 3)), P = times * limit;
    hobe_section *section = rectangle(height, height);
    hobe_model *model = truss(section, E, H, P);
    hobe_solution *solution = at_once(model, HOBE_METHOD_NEWTON);
    const double v = H + point_of(solution, "left", 1, 0, 0).u[2];
    if (times > 1)
        check_relative(info_of(solution).limit_load * P, limit, 1e-5,
                       "two bars under %g times their limit load: that load", times);
    else
        check_that(info_of(solution).limit_load == 0, "two bars under %g of it", times);
    check_relative(EA * v * (H * H - v * v) / pow(l, 3), P, 1e-6, "equilibrium at %g", times);
    check_that(info_of(solution).negative == 0 && (v < 0) == (times > 1), "stable at %g", v / H);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A motion that begins at such an equilibrium says so of its first state alone. */
static void motion(void)
{
    const struct hobe_dynamic options = {.to = 1e-5, .step = 1e-5, .equilibrium = 1};
    struct hobe_error err;
    hobe_history *history;
    hobe_section *section = rectangle(0.1, 0.1);
    hobe_model *model = truss(section, 1e9, 0.05, 5e3);
    hobe_solution *start = at_once(model, HOBE_METHOD_NEWTON);
    if (hobe_dynamic(model, &options, &history, &err))
        check_stop("hobe_dynamic: %s", err.message);
    const double first = info_of(hobe_history_state(history, 0)).limit_load;
    check_that(first > 0 && first == info_of(start).limit_load, "the start of a motion: %g", first);
    check_that(info_of(hobe_history_state(history, 1)).limit_load == 0, "and what follows");
    hobe_history_free(history);
    hobe_solution_free(start);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- arches ---------------------------------------------------------------------------------- */

struct arc {
    double radius, half; /* m, rad */
};

static enum hobe_status arc_point(void *context, double t, double *r, struct hobe_error *err)
{
    const struct arc *arc = context;
    (void)err;
    const double a = arc->half * (2 * t - 1);
    r[0] = arc->radius * sin(a);
    r[1] = 0;
    r[2] = arc->radius * cos(a);
    return HOBE_OK;
}

/* The load factor of the first limit point of the path to the full load; 0: it has none. */
static double first_limit(hobe_model *model)
{
    const struct hobe_path_options options = {.newton.method = HOBE_METHOD_SERIES};
    struct hobe_error err;
    hobe_path *path;
    double limit = 0;
    if (hobe_path_follow(model, &options, &path, &err))
        check_stop("hobe_path_follow: %s", err.message);
    for (int i = 0; hobe_path_event(path, i) && limit == 0; i++)
        if (!hobe_path_event(path, i)->bifurcation)
            limit = hobe_path_event(path, i)->extreme;
    hobe_path_free(path);
    return limit;
}

static hobe_model *arch(const hobe_section *section, const hobe_curve *curve, double P)
{
    struct hobe_beam beam = beam_along_x("MGD30", 12, section, 70e9, 0, 0);
    hobe_model *model = new_model();
    beam.curve = curve;
    add_beam(model, &beam);
    add_clamp(model, "beam", 0, 0);
    add_clamp(model, "beam", 1, 0);
    add_force(model, "beam", 0.5, 0, 0, -P);
    return model;
}

/* A clamped arch whose rise is some times its height, under `times` its limit load in one step. */
static void arches(double times)
{
    struct arc arc = {10, 0.1};
    hobe_section *section = rectangle(0.05, random_real(0.008, 0.012));
    hobe_curve *curve = curve_of(arc_point, NULL, &arc);
    hobe_model *model = arch(section, curve, 1000);
    const double limit = 1000 * first_limit(model);
    hobe_model_free(model);
    model = arch(section, curve, times * limit);
    for (int series = 0; series < 2; series++) {
        hobe_solution *solution = at_once(model, series ? HOBE_METHOD_SERIES : HOBE_METHOD_NEWTON);
        check_relative(info_of(solution).limit_load * times, 1, 1e-5,
                       "an arch under %g times its limit load", times);
        check_that(info_of(solution).negative == 0, "it has come to rest on the other side");
        hobe_solution_free(solution);
    }
    hobe_model_free(model);
    hobe_curve_free(curve);
    hobe_section_free(section);
}

/* ---- none ------------------------------------------------------------------------------------ */

/* Cantilevers, bent and twisted far: their tips are where the path by series ends, of which
 * Newton's iteration in one step finds something else where the column is pushed, or twisted by
 * turns. */
static void cantilevers(const char *what, double Fx, double Fz, double Mx, double nu)
{
    hobe_section *section = rectangle(0.1, 0.1);
    const struct hobe_beam beam = beam_along_x("MGD30w", 20, section, 1e9, nu, 5);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, Fx, 0, Fz);
    add_moment(model, "beam", 1, Mx, 0, 0);
    hobe_solution *by_newton = at_once(model, HOBE_METHOD_NEWTON);
    hobe_solution *by_series = at_once(model, HOBE_METHOD_SERIES);
    const struct hobe_point a = point_of(by_newton, "beam", 1, 0, 0);
    const struct hobe_point b = point_of(by_series, "beam", 1, 0, 0);
    check_absolute(distance(a.u, b.u), 0, 1e-7, "%s: on its path", what);
    check_absolute(a.twist, b.twist, 1e-7, "%s: twist", what);
    check_that(info_of(by_newton).limit_load == 0 && info_of(by_series).limit_load == 0,
               "%s: no limit point, told at %g", what, info_of(by_newton).limit_load);
    hobe_solution_free(by_newton);
    hobe_solution_free(by_series);
    hobe_model_free(model);
    hobe_section_free(section);
}

static void on_the_path(void)
{
    const double EI = 1e9 * 1e-4 / 12, euler = PI * PI * EI / 100;
    cantilevers("elastica 10", 0, 10 * EI / 25, 0, 0);
    cantilevers("elastica 1000", 0, 1000 * EI / 25, 0, 0);
    cantilevers("pulled", random_real(1, 1000) * EI / 25, random_real(1, 30) * EI / 25, 0, 0);
    cantilevers("pushed", -random_real(1.1, 2) * euler, 1e-3 * euler, 0, 0);
    cantilevers("twisted", 0, 0, 31e3, 0.3);
}

int main(void)
{
    random_start();
    static const double times[] = {1.05, 1.5, 5, 50};
    two_bars(0.8);
    two_bars(pow(10, random_real(0.3, 2)));
    for (int i = 0; i < 4; i++) {
        if (i > 0) /* just above the limit Newton's iteration may find nothing, and says so */
            two_bars(times[i]);
        arches(times[i]);
    }
    motion();
    on_the_path();
    return check_report();
}
