/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every coefficient of paths as power series, for every kind of load and joint, on beams, bodies
 * and masses.  Along a series of N terms the residual R(a) is analytic, and its coefficients of
 * a^k, k <= N, vanish.  They are read off a circle in the plane of complex a, without loss of
 * digits,
 *
 *     R_k r^k = 1/M sum_m R(r e^(i t_m)) e^(-i k t_m),    t_m = pi (2 m + 1)/M,
 *
 * where elements and constraints are the core's polynomials of four real states, and the loads are
 * written down once more, in complex arithmetic.  Looks into the core (series.h). */
#include "assemble.h"
#include "beam.h"
#include "body.h"
#include "check.h"
#include "constraint.h"
#include "load.h"
#include "scene.h"
#include "series.h"
#include "solution.h"

#include <complex.h>
#include <math.h>
#include <string.h>

static const double E = 70e9, RHO = 2700, PI = 3.14159265358979323846;

typedef double complex number;

/* ---- loads of complex states ----------------------------------------------------------------- */

/* Where a load acts: of its vectors the weights in r, r_y and r_z. */
struct station {
    int vectors;
    long vector[HOBE_MAX_VECTORS];
    double weight[3][HOBE_MAX_VECTORS];
};

static void find_on_body(const struct body *body, const double *point, struct station *s)
{
    *s = (struct station){.vectors = BODY_VECTORS, .weight = {{1}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (int v = 0; v < BODY_VECTORS; v++)
        s->vector[v] = body->first + v;
    for (int a = 0; a < 3 && point; a++)
        s->weight[0][1 + a] = point[a] - body->spec.centre[a];
}

static void find_on_beam(const hobe_model *model, const struct beam *beam, double at,
                         struct station *s)
{
    const struct place place = model_place(beam, at);
    const struct hobe_kernel *kernel = beam->kernel;
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS];
    kernel->shape(place.xi, beam->length / beam->spec.elements, N, Nx);
    *s = (struct station){.vectors = kernel->vectors};
    for (int v = 0; v < s->vectors; v++) {
        s->vector[v] = model_vector(model, beam, place.element, v);
        if (kernel->vector[v].mode < 3)
            s->weight[kernel->vector[v].mode][v] = N[v];
    }
}

static void find(const hobe_model *model, const char *name, double at, const double *point,
                 struct station *s)
{
    const struct body *body = model_find_body(model, name);
    if (body)
        find_on_body(body, point, s);
    else
        find_on_beam(model, model_find_beam(model, name, NULL, NULL), at, s);
}

/* r_y and r_z, of beams along x and of bodies: the global axes in the reference. */
static void find_slopes(const struct station *s, const number *u, number y[3], number z[3])
{
    for (int a = 0; a < 3; a++) {
        y[a] = a == 1;
        z[a] = a == 2;
        for (int v = 0; v < s->vectors; v++) {
            y[a] += s->weight[1][v] * u[3 * s->vector[v] + a];
            z[a] += s->weight[2][v] * u[3 * s->vector[v] + a];
        }
    }
}

static void subtract(const struct station *s, int of, const number F[3], number factor, number *R)
{
    for (int v = 0; v < s->vectors; v++)
        for (int a = 0; a < 3; a++)
            R[3 * s->vector[v] + a] -= factor * s->weight[of][v] * F[a];
}

/* F += m dphi/ds, phi the angle of the slope s about the axis b. */
static void turn(int b, const number s[3], double m, number F[3])
{
    const int c = (b + 1) % 3, d = (b + 2) % 3;
    const number square = s[c] * s[c] + s[d] * s[d];
    F[c] -= m * s[d] / square;
    F[d] += m * s[c] / square;
}

static void subtract_moment(const hobe_model *model, const struct hobe_moment *moment,
                            const number *u, number factor, number *R)
{
    struct station s;
    number y[3], z[3], on_y[3] = {0}, on_z[3] = {0};
    const double *M = moment->value;
    find(model, moment->beam, moment->at, NULL, &s);
    find_slopes(&s, u, y, z);
    turn(0, y, M[0] / 2, on_y);
    turn(0, z, M[0] / 2, on_z);
    turn(1, z, M[1], on_z);
    turn(2, y, M[2], on_y);
    subtract(&s, 1, on_y, factor, R);
    subtract(&s, 2, on_z, factor, R);
}

/* c = a x b, of length 1. */
static void normal(const number a[3], const number b[3], number c[3])
{
    number square = 0;
    for (int x = 0; x < 3; x++) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        c[x] = a[y] * b[z] - a[z] * b[y];
        square += c[x] * c[x];
    }
    for (int x = 0; x < 3; x++)
        c[x] /= csqrt(square);
}

/* On the axes n = r_y x r_z, t_y = r_z x n and r_z, each of length 1, where it follows. */
static void subtract_force(const hobe_model *model, const struct hobe_force *force, const number *u,
                           number factor, number *R)
{
    struct station s;
    number y[3], z[3], t[3][3], F[3] = {force->value[0], force->value[1], force->value[2]};
    find(model, force->beam, force->at, force->at_point ? force->point : NULL, &s);
    find_slopes(&s, u, y, z);
    normal(y, z, t[0]);
    normal(z, t[0], t[1]);
    normal(t[0], t[1], t[2]);
    for (int a = 0; a < 3 && force->follower; a++) {
        F[a] = 0;
        for (int b = 0; b < 3; b++)
            F[a] += force->value[b] * t[b][a];
    }
    subtract(&s, 0, F, factor, R);
}

static number at_time(hobe_drive *history, double time, number factor)
{
    struct hobe_error err;
    double d[3] = {1};
    if (history && hobe_drive_at(history, time, d, &err))
        check_stop("%s", err.message);
    return factor * d[0];
}

/* R -= factor Q; dead loads are the core's. */
static void subtract_loads(const hobe_model *model, const number *u, double time, number factor,
                           number *R)
{
    for (long i = 0; i < 3 * model->vectors; i++)
        R[i] -= factor * model->dead[i];
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct hobe_force *force = &model_force(model, i)->spec;
        if (force->follower || force->history) /* others are among the dead */
            subtract_force(model, force, u, at_time(force->history, time, factor), R);
    }
    for (size_t i = 0; i < model->moments.count; i++) {
        const struct hobe_moment *moment = &model_moment(model, i)->spec;
        subtract_moment(model, moment, u, at_time(moment->history, time, factor), R);
    }
}

/* ---- residuals ------------------------------------------------------------------------------- */

enum { DEGREE = 4 }; /* of polynomials such as elements and constraints are, or more */

/* s->r = what elements and constraints are in the state x + t y. */
static void polynomial_at(struct solver *s, const double *x, const double *y, double t)
{
    for (long i = 0; i < 3 * s->model->vectors; i++)
        s->u[i] = x[i] + t * y[i];
    solver_evaluate(s, 0, NO_TANGENT);
}

/* R = F(u) - lambda Q(u) and constraints of a complex state u = x + i y: a polynomial of t in
 * x + t y by Lagrange's at t = -2, ... 2, taken at i. */
static void find_residual(struct solver *s, const number *u, number lambda, number *R)
{
    const size_t n = (size_t)(3 * s->model->vectors);
    double *x = hobe_alloc(2 * n, sizeof *x, NULL), *y = x + n;
    for (size_t i = 0; i < n; i++) {
        x[i] = creal(u[i]);
        y[i] = cimag(u[i]);
        R[i] = 0;
    }
    for (int j = 0; j <= DEGREE; j++) {
        number weight = 1;
        for (int l = 0; l <= DEGREE; l++)
            weight *= l == j ? 1 : (DEGREE / 2.0 - l + I) / (j - l);
        polynomial_at(s, x, y, j - DEGREE / 2);
        for (size_t i = 0; i < n; i++)
            R[i] += weight * s->r[i];
    }
    subtract_loads(s->model, u, s->motion.instant.time, lambda, R);
    hobe_free(x);
}

/* u and, returned, the load factor of a series at a complex a. */
static number move(const struct series *series, number a, number *u)
{
    const long n = 3 * series->s->model->vectors;
    number lambda = 0;
    memset(u, 0, (size_t)n * sizeof *u);
    for (int k = SERIES_ORDER; k >= 0; k--) {
        lambda = lambda * a + series->lambda[k];
        for (long i = 0; i < n; i++)
            u[i] = u[i] * a + series->u[k][i];
    }
    return lambda;
}

/* Points on a circle.  What is left of R, of a^(k + CIRCLE) and higher, is taken for a^k: where the
 * series ends with 1e-4 of its beginning that is 1e-18 of it, times what products make of it. */
enum { CIRCLE = 96 };

/* R[k][3 vectors] = the coefficients of the residual times r^k, by half of the circle, since the
 * other is conjugate. */
static void find_coefficients(struct series *series, double r, double *R)
{
    const size_t n = (size_t)(3 * series->s->model->vectors);
    number *u = hobe_alloc(2 * n, sizeof *u, NULL), *at = u + n;
    memset(R, 0, (SERIES_ORDER + 1) * n * sizeof *R);
    for (int m = 0; m < CIRCLE / 2; m++) {
        const number direction = cexp(I * PI * (2 * m + 1) / CIRCLE);
        number turned = 2.0 / CIRCLE;
        const number lambda = move(series, r * direction, u);
        find_residual(series->s, u, lambda, at);
        for (int k = 0; k <= SERIES_ORDER; k++, turned /= direction)
            for (size_t i = 0; i < n; i++)
                R[(size_t)k * n + i] += creal(turned * at[i]);
    }
    hobe_free(u);
}

/* |D F'(u_0) u_k| r^k, what other terms of the same order balance: differences of order 4. */
static double size_of_term(struct series *series, int k, double r)
{
    static const double weight[] = {1, -8, 0, 8, -1};
    struct solver *s = series->s;
    const size_t n = (size_t)(3 * s->model->vectors);
    double *v = hobe_alloc(2 * n, sizeof *v, NULL), *sum = v + n;
    for (size_t i = 0; i < n; i++)
        v[i] = pow(r, k) * series->u[k][i];
    for (int j = 0; j <= DEGREE; j++) {
        polynomial_at(s, series->u[0], v, j - DEGREE / 2);
        for (size_t i = 0; i < n; i++)
            sum[i] += weight[j] / 12 * s->r[i];
    }
    const double size = solver_norm(s, sum, 1);
    hobe_free(v);
    return size;
}

/* ---- series ---------------------------------------------------------------------------------- */

/* The slope of the series beside differences of its states. */
static void check_slope(const struct series *series, double a, const char *what)
{
    const struct solver *s = series->s;
    const size_t n = (size_t)(3 * s->model->unknowns);
    const double h = 1e-4 * a; /* its square and, of the series, round-off: 1e-8 or less */
    double *v = hobe_alloc(3 * n, sizeof *v, NULL), *w[] = {v + n, v + 2 * n}, lambda[2];
    double worst = 0, most = 0;
    const double rate = series_slope(series, a, v);
    for (int side = 0; side < 2; side++) {
        lambda[side] = series_move(series, side ? a + h : a - h);
        solver_restrict(s->model, s->u, w[side]);
    }
    check_absolute((lambda[1] - lambda[0]) / (2 * h), rate, 1e-6, "%s: by the load", what);
    for (size_t i = 0; i < n; i++) { /* one measure for all, as in solver_norm */
        worst = fmax(worst, fabs((w[1][i] - w[0][i]) / (2 * h) - v[i]) / s->scale[i]);
        most = fmax(most, fabs(v[i]) / s->scale[i]);
    }
    check_absolute(worst / most, 0, 1e-6, "%s: slope", what);
    hobe_free(v);
}

/* c . u_k + kappa lambda_k = 1 of k = 1, or else 0. */
static void check_plane(const struct series *series, const double *c, double kappa, double r,
                        const char *what)
{
    const struct solver *s = series->s;
    const long n = 3 * s->model->unknowns;
    double *x = hobe_alloc((size_t)n, sizeof *x, NULL);
    for (int k = 1; k <= SERIES_ORDER; k++) {
        double sum = kappa * series->lambda[k];
        solver_restrict(s->model, series->u[k], x);
        for (long i = 0; i < n; i++)
            sum += c[i] * x[i];
        check_absolute(pow(r, k - 1) * sum, k == 1, 1e-10, "%s: plane, order %d", what, k);
    }
    hobe_free(x);
}

/* A plane across the line from the reference to the state, in the norm of the solver. */
static double *plane_of(const struct solver *s)
{
    const double size = solver_norm(s, s->u, -1);
    double *c = hobe_alloc((size_t)(3 * s->model->unknowns), sizeof *c, NULL);
    solver_restrict(s->model, s->u, c);
    for (long i = 0; i < 3 * s->model->unknowns; i++)
        c[i] /= s->scale[i] * s->scale[i] * size * size;
    return c;
}

static void check_coefficients(struct series *series, double r, const char *what)
{
    struct solver *s = series->s;
    const size_t n = (size_t)(3 * s->model->vectors);
    double *R = hobe_alloc((SERIES_ORDER + 1) * n, sizeof *R, NULL);
    /* Round-off is about 1e-13 of the largest term, which at order 2 is that of stretching; the
     * load and the last terms may be 1e-4 of it, and less. */
    const double tolerance = 1e-8;
    find_coefficients(series, r, R);
    for (int k = 0; k <= SERIES_ORDER; k++) {
        const double size = k ? size_of_term(series, k, r) : s->load_norm;
        check_absolute(solver_norm(s, R + (size_t)k * n, 1) / size, 0, tolerance,
                       "%s: coefficient of order %d", what, k);
    }
    hobe_free(R);
}

/* About the state of load factor 1 at a time.  Frees the model. */
static void check_series(hobe_model *model, double time, const char *what)
{
    struct hobe_error err;
    struct solver s;
    struct series series;
    hobe_solution *at;
    const struct hobe_newton options = {.steps = 4, .tolerance = 1e-14, .time = time};
    if (hobe_static(model, &options, &at, &err) || solver_open(&s, model, &options, &err) ||
        series_open(&series, &s, &err))
        check_stop("%s: %s", what, err.message);
    memcpy(s.u, at->u, (size_t)(3 * model->vectors) * sizeof *s.u);
    double *c = plane_of(&s);
    solver_evaluate(&s, 1, TRUE_TANGENT);
    if (solver_factor(&s, &err) != CONVERGED || series_expand(&series, 1, c, 1, &err))
        check_stop("%s: no series", what);
    const double r = series_range(&series, 1e-4);
    check_plane(&series, c, 1, r, what);
    check_slope(&series, r / 2, what);
    check_coefficients(&series, r, what);
    hobe_free(c);
    series_close(&series);
    solver_close(&s);
    hobe_solution_free(at);
    hobe_model_free(model);
}

/* ---- scenes ---------------------------------------------------------------------------------- */

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
    check_series(model, 0, "a force");
    model = arm(element, section);
    random_direction(d);
    add_moment(model, "beam", 0.8, 500 * d[0], 500 * d[1], 500 * d[2]);
    check_series(model, 0, "a moment");
    model = arm(element, section);
    random_direction(d);
    add_follower(model, "beam", 1, 200 * d[0], 200 * d[1], 200 * d[2]);
    add_force(model, "beam", 0.5, 100 * d[2], 100 * d[0], 100 * d[1]);
    check_series(model, 0, "a follower force");
}

/* Loads that change in time, at some time. */
static void histories(const hobe_section *section)
{
    struct hobe_error err;
    const double point[2][2] = {{0, 0}, {1, 1}}, time = random_real(0.3, 1);
    hobe_drive *ramp = hobe_drive_points(2, point, HOBE_LINEAR, 0, &err);
    const struct hobe_force force[] = {
        {.beam = "beam", .at = 1, .value = {0, 100, 50}, .follower = 1, .history = ramp},
        {.beam = "beam", .at = 0.5, .value = {10, -100, 50}, .history = ramp}};
    const struct hobe_moment moment = {
        .beam = "beam", .at = 0.7, .value = {50, 80, 20}, .history = ramp};
    hobe_model *model = arm("MGD30w", section);
    if (!ramp || hobe_model_force(model, force, &err) || hobe_model_force(model, force + 1, &err) ||
        hobe_model_moment(model, &moment, &err))
        check_stop("%s", err.message);
    check_series(model, time, "histories");
    hobe_drive_free(ramp);
}

/* A joint of a kind between two parts, with its axes. */
static struct hobe_joint joint_of(enum hobe_joint_kind kind, const char *a, const char *b)
{
    struct hobe_joint is = {.beam = {a, b}, .at = {1, 0}, .kind = kind};
    if (kind != HOBE_JOINT_FIXED && kind != HOBE_JOINT_SPHERICAL && kind != HOBE_JOINT_DISTANCE)
        is.axis[1] = 1;
    if (kind == HOBE_JOINT_UNIVERSAL)
        is.second[2] = 1;
    return is;
}

/* Two beams, the first clamped, the second held by the joint and a support. */
static void between_beams(enum hobe_joint_kind kind, const hobe_section *section)
{
    const double gap = kind == HOBE_JOINT_DISTANCE ? 0.2 : 0;
    const struct hobe_joint joint = joint_of(kind, "beam", "outer"),
                            support = {.beam = {"outer"}, .at = {1}, .kind = HOBE_JOINT_FIXED};
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 0.5);
    hobe_model *model = cantilever(&beam, 0);
    beam.name = "outer";
    beam.from[0] = 0.5 + gap;
    beam.to[0] = 1 + gap;
    add_beam(model, &beam);
    add_joint(model, &joint);
    add_joint(model, &support);
    add_force(model, "beam", 0.9, random_real(20, 50), random_real(50, 100), -100);
    add_moment(model, "outer", 0.3, 20, random_real(-20, 20), random_real(-20, 20));
    check_series(model, 0, hobe_joint_name(kind));
}

/* Two beams with a corner. */
static void corner(const hobe_section *section)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 0.5);
    hobe_model *model = cantilever(&beam, 0);
    beam.name = "outer";
    beam.from[0] = beam.to[0] = 0.5;
    beam.to[1] = random_real(0.2, 0.4);
    beam.to[2] = random_real(0.2, 0.4);
    add_beam(model, &beam);
    add_join(model, "beam", 1, "outer", 0);
    add_force(model, "outer", 0.9, random_real(20, 50), random_real(50, 100), -100);
    add_follower(model, "beam", 0.6, random_real(20, 50), random_real(50, 100), -100);
    check_series(model, 0, "a corner");
}

static void add_weight(hobe_model *model)
{
    struct hobe_error err;
    const struct hobe_mass mass = {.beam = "beam", .at = 0.6, .y = 0.01, .z = 0.01, .mass = 2};
    const double g[3] = {random_real(-1, 1), random_real(-1, 1), -9.81};
    if (hobe_model_mass(model, &mass, &err) || hobe_model_gravity(model, NULL, g, &err))
        check_stop("%s", err.message);
}

/* A clamped beam with a mass, a body at its end, on that the joint and another body, which a beam
 * holds; all have weight, and the bodies loads. */
static void between_bodies(enum hobe_joint_kind kind, const hobe_section *section)
{
    const double gap = kind == HOBE_JOINT_DISTANCE ? 0.2 : 0;
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 0.5);
    struct hobe_body body = {.name = "first", .mass = 3, .shape = HOBE_SHAPE_SPHERE, .size = {0.1}};
    struct hobe_joint joint = joint_of(kind, "first", "second");
    beam.material.rho = RHO;
    hobe_model *model = cantilever(&beam, 0);
    add_weight(model);
    beam.name = "outer";
    beam.from[0] = 0.7 + gap;
    beam.to[0] = 1.2 + gap;
    add_beam(model, &beam);
    add_clamp(model, "outer", 1, 0);
    body.centre[0] = 0.55;
    add_body(model, &body);
    body.name = "second";
    body.centre[0] = 0.65 + gap;
    add_body(model, &body);
    joint.at_point = gap > 0 ? 2 : 1;
    joint.point[0] = 0.6;
    joint.to[0] = gap > 0 ? 0.8 : 0;
    add_joint(model, &joint);
    add_joint(model,
              &(struct hobe_joint){.beam = {"beam", "first"}, .at = {1}, .kind = HOBE_JOINT_RIGID});
    add_joint(model, &(struct hobe_joint){
                         .beam = {"outer", "second"}, .at = {0}, .kind = HOBE_JOINT_FIXED});
    add_force(model, "first", 0, 20, random_real(-50, 50), random_real(-50, 50));
    add_moment(model, "first", 0, random_real(-20, 20), random_real(-20, 20), 10);
    add_follower(model, "second", 0, 20, random_real(-50, 50), random_real(-50, 50));
    check_series(model, 0, hobe_joint_name(kind));
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.02, 0.03);
    loads("MGD30w", section);
    loads("34X3", section);
    histories(section);
    corner(section);
    for (int kind = 0; kind <= HOBE_JOINT_DISTANCE; kind++) {
        between_beams((enum hobe_joint_kind)kind, section);
        between_bodies((enum hobe_joint_kind)kind, section);
    }
    hobe_section_free(section);
    return check_report();
}
