/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads that change in time, and forces of the caller: against the same loads constant, tangents
 * against differences, and what is refused.  Looks into the core for residuals. */
#include "check.h"
#include "load.h"
#include "scene.h"
#include "spring.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 70e9;

static struct hobe_beam dense_beam(const hobe_section *section)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 2, section, E, 0.3, 1);
    beam.material.rho = 2700;
    return beam;
}

static hobe_solution *solve_at(hobe_model *model, double time)
{
    struct hobe_error err;
    hobe_solution *solution;
    const struct hobe_newton options = {.tolerance = 1e-13, .time = time};
    if (hobe_static(model, &options, &solution, &err))
        check_stop("%s", err.message);
    return solution;
}

static hobe_drive *straight(double from, double to)
{
    struct hobe_error err;
    const double point[2][2] = {{0, from}, {2, to}};
    hobe_drive *drive = hobe_drive_points(2, point, HOBE_LINEAR, 0, &err);
    if (!drive)
        check_stop("%s", err.message);
    return drive;
}

/* ---- histories ------------------------------------------------------------------------------- */

enum { FORCE, FOLLOWER, MOMENT, GRAVITY, LOADS };
static const char *const names[LOADS] = {"force", "follower", "moment", "gravity"};

/* A cantilever with a load times `factor` and the history. */
static hobe_model *loaded(const hobe_section *section, int load, const double value[3],
                          double factor, hobe_drive *history)
{
    struct hobe_error err;
    const struct hobe_beam beam = dense_beam(section);
    hobe_model *model = cantilever(&beam, 0);
    struct hobe_force force = {
        .beam = "beam", .at = 0.8, .follower = load == FOLLOWER, .history = history};
    struct hobe_moment moment = {.beam = "beam", .at = 0.7, .history = history};
    double g[3];
    for (int a = 0; a < 3; a++) {
        force.value[a] = factor * value[a];
        moment.value[a] = factor * value[a];
        g[a] = factor * value[a];
    }
    if (load == MOMENT    ? hobe_model_moment(model, &moment, &err)
        : load == GRAVITY ? hobe_model_gravity_history(model, NULL, g, history, &err)
                          : hobe_model_force(model, &force, &err))
        check_stop("%s", err.message);
    return model;
}

/* At any time a load with a history is the load times its value, and so are the section forces. */
static void each_load(const hobe_section *section)
{
    for (int load = 0; load < LOADS; load++) {
        hobe_drive *history = straight(random_real(-1, 0), random_real(0.5, 2));
        const double t = random_real(0, 2);
        double value[3], d[3];
        struct hobe_error err;
        struct hobe_resultants is[2];
        hobe_solution *solution[2];
        hobe_model *model[2];
        random_direction(value);
        for (int a = 0; a < 3; a++)
            value[a] *= load == GRAVITY ? 50 : 2000;
        if (hobe_drive_at(history, t, d, &err))
            check_stop("%s", err.message);
        for (int i = 0; i < 2; i++) {
            model[i] = loaded(section, load, value, i ? d[0] : 1, i ? NULL : history);
            solution[i] = solve_at(model[i], t);
            if (hobe_solution_resultants(solution[i], "beam", 0.5, HOBE_CUT_FORCES, is + i, &err))
                check_stop("%s", err.message);
        }
        const struct hobe_point a = point_of(solution[0], "beam", 1, 0, 0);
        const struct hobe_point b = point_of(solution[1], "beam", 1, 0, 0);
        check_absolute(distance(a.u, b.u), 0, 1e-10 * norm(b.u), "%s: displacement", names[load]);
        check_absolute(distance(is[0].moment, is[1].moment), 0, 1e-7 * norm(is[1].moment),
                       "%s: section moments", names[load]);
        check_absolute(info_of(solution[0]).time, t, 0, "the time of a solution");
        for (int i = 0; i < 2; i++) {
            hobe_solution_free(solution[i]);
            hobe_model_free(model[i]);
        }
        hobe_drive_free(history);
    }
}

/* ---- forces of the caller -------------------------------------------------------------------- */

/* F = t F0 + A x + B v + c (x.x) e, with A and B of no symmetry. */
struct field {
    double F0[3], A[3][3], B[3][3], c, e[3];
    double fails; /* from this time on */
};

static enum hobe_status field_force(void *context, double t, const double x[3], const double v[3],
                                    double F[3], struct hobe_error *err)
{
    const struct field *f = context;
    for (int a = 0; a < 3; a++)
        F[a] = t * f->F0[a] + dot3(f->A[a], x) + dot3(f->B[a], v) + f->c * dot3(x, x) * f->e[a];
    if (t == 7)
        F[0] = NAN;
    return t < f->fails ? HOBE_OK : hobe_fail(err, HOBE_IO, NULL, "the field is gone");
}

static enum hobe_status field_derivative(void *context, double t, const double x[3],
                                         const double v[3], double G[2][3][3],
                                         struct hobe_error *err)
{
    const struct field *f = context;
    (void)t;
    (void)v;
    (void)err;
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 3; c++) {
            G[0][a][c] = f->A[a][c] + 2 * f->c * x[c] * f->e[a];
            G[1][a][c] = f->B[a][c];
        }
    return HOBE_OK;
}

static struct field random_field(void)
{
    struct field f = {.c = random_real(-500, 500), .fails = INFINITY};
    random_direction(f.F0);
    random_direction(f.e);
    for (int a = 0; a < 3; a++) {
        f.F0[a] *= 1000;
        for (int c = 0; c < 3; c++) {
            f.A[a][c] = random_real(-500, 500);
            f.B[a][c] = random_real(-50, 50);
        }
    }
    return f;
}

static hobe_model *in_field(const hobe_section *section, struct field *field, int given,
                            hobe_drive *history)
{
    struct hobe_error err;
    struct hobe_beam beam = dense_beam(section);
    beam.from[0] = 0.3; /* positions are not those from the begin */
    beam.to[0] = 1.3;
    hobe_model *model = cantilever(&beam, 0);
    const struct hobe_force force = {.where = "there",
                                     .beam = "beam",
                                     .at = 0.9,
                                     .history = history,
                                     .function = field_force,
                                     .derivative = given ? field_derivative : NULL,
                                     .context = field};
    if (hobe_model_force(model, &force, &err))
        check_stop("%s", err.message);
    return model;
}

/* All loads at 1.5 s in a motion with v = 40 u. */
static void all_loads(const hobe_model *model, const double *u, double *r, const struct matrix *K)
{
    struct hobe_error err;
    double *v = hobe_alloc((size_t)(3 * model->vectors), sizeof *v, &err);
    const struct instant instant = {.time = 1.5, .v = v, .rate = 40};
    for (long i = 0; i < 3 * model->vectors; i++)
        v[i] = 40 * u[i];
    load_subtract(model, u, &instant, 0.7, r, K);
    hobe_free(v);
}

/* The tangent with derivatives given and by differences; the equilibrium is that under the same
 * force, dead, as it is in the end. */
static void fields(const hobe_section *section)
{
    struct field field = random_field();
    hobe_drive *history = straight(0.5, 1);
    for (int given = 0; given < 2; given++) {
        struct hobe_error err;
        double F[3], d[3];
        hobe_model *model = in_field(section, &field, given, history);
        check_tangent(model, all_loads, 0, given ? "given" : "by differences");
        hobe_solution *solution = solve_at(model, 1.5);
        const struct hobe_point at = point_of(solution, "beam", 0.9, 0, 0);
        const double rest[3] = {0};
        if (field_force(&field, 1.5, at.r, rest, F, &err) || hobe_drive_at(history, 1.5, d, &err))
            check_stop("%s", err.message);
        struct hobe_beam beam = dense_beam(section);
        hobe_model *dead = cantilever(&beam, 0);
        add_force(dead, "beam", 0.9, d[0] * F[0], d[0] * F[1], d[0] * F[2]);
        hobe_solution *same = solve_at(dead, 0);
        const struct hobe_point end = point_of(same, "beam", 0.9, 0, 0);
        check_that(norm(at.u) > 1e-4, "it moves by %g m", norm(at.u));
        check_absolute(distance(at.u, end.u), 0, 1e-9 * norm(at.u), "the same force, dead");
        check_that(info_of(solution).iterations <= info_of(same).iterations + 2,
                   "Newton converges as with dead forces: %d iterations",
                   info_of(solution).iterations);
        hobe_solution_free(solution);
        hobe_solution_free(same);
        hobe_model_free(model);
        hobe_model_free(dead);
    }
    hobe_drive_free(history);
}

/* A spring and damper to a point of the ground. */
struct ground {
    double k, c, length, to[3];
};

static enum hobe_status spring_force(void *context, double t, const double x[3], const double v[3],
                                     double F[3], struct hobe_error *err)
{
    const struct ground *g = context;
    double e[3];
    (void)t;
    (void)err;
    for (int a = 0; a < 3; a++)
        e[a] = x[a] - g->to[a];
    const double l = norm(e), size = g->k * (l - g->length) + g->c * dot3(e, v) / l;
    for (int a = 0; a < 3; a++)
        F[a] = -size * e[a] / l;
    return HOBE_OK;
}

/* A force that is that of a spring is the spring, on all vectors at a random state in motion. */
static void spring_of_the_caller(const hobe_section *section)
{
    struct hobe_error err;
    struct ground ground = {.k = 3e4, .c = 200, .length = 0.4, .to = {0.9, 0.5, -0.3}};
    struct hobe_beam beam = dense_beam(section);
    hobe_model *model[2] = {cantilever(&beam, 0), cantilever(&beam, 0)};
    const struct hobe_force force = {
        .beam = "beam", .at = 0.7, .function = spring_force, .context = &ground};
    struct hobe_spring spring = {.beam = {"beam"},
                                 .at = {0.7},
                                 .kind = HOBE_SPRING_LENGTH,
                                 .stiffness = {ground.k},
                                 .damping = {ground.c},
                                 .length = ground.length};
    memcpy(spring.to, ground.to, sizeof spring.to);
    if (hobe_model_force(model[0], &force, &err) || hobe_model_spring(model[1], &spring, &err))
        check_stop("%s", err.message);
    for (int i = 0; i < 2; i++)
        if (hobe_model_build(model[i], &err))
            check_stop("%s", err.message);
    const long n = 3 * model[0]->vectors;
    double *const all = hobe_alloc((size_t)(4 * n), sizeof *all, &err);
    double *u = all, *v = u + n, *r = v + n, *f = r + n, largest = 0;
    for (long i = 0; i < n; i++) {
        u[i] = random_real(-0.1, 0.1);
        v[i] = random_real(-1, 1);
    }
    const struct instant instant = {.time = 1, .v = v};
    load_subtract(model[0], u, &instant, 1, r, NULL);
    spring_add(model[1], u, &instant, f, NULL);
    for (long i = 0; i < n; i++)
        largest = fmax(largest, fabs(f[i]));
    for (long i = 0; i < n; i++)
        check_absolute(r[i], f[i], 1e-12 * largest, "the spring's force %ld", i);
    hobe_free(all);
    for (int i = 0; i < 2; i++)
        hobe_model_free(model[i]);
}

/* ---- what is refused ------------------------------------------------------------------------- */

static void check_sentence(enum hobe_status status, enum hobe_status expected,
                           const struct hobe_error *err, const char *sentence)
{
    check_that(status == expected && strstr(err->message, sentence), "\"%s\", got \"%s\"", sentence,
               err->message);
}

static void refused(const hobe_section *section)
{
    struct hobe_error err;
    struct field field = random_field();
    hobe_solution *solution;
    hobe_model *model = in_field(section, &field, 0, NULL);
    field.fails = 1;
    check_sentence(hobe_static(model, &(struct hobe_newton){.time = 2}, &solution, &err), HOBE_IO,
                   &err, "the field is gone");
    check_that(err.where && !strcmp(err.where, "there"), "the force is named");
    hobe_path *path;
    const struct hobe_path_options late = {.newton.time = 2};
    check_sentence(hobe_path_follow(model, &late, &path, &err), HOBE_IO, &err, "the field is gone");
    field.fails = 8;
    check_sentence(hobe_static(model, &(struct hobe_newton){.time = 7}, &solution, &err),
                   HOBE_BAD_INPUT, &err, "the force on \"beam\" is {nan, ");
    solution = solve_at(model, 1);
    hobe_modes *modes;
    check_sentence(
        hobe_modal(model, solution, &(struct hobe_modal_options){.modes = 1}, &modes, &err),
        HOBE_BAD_INPUT, &err, "a force that is a function of its place makes");
    hobe_solution_free(solution);
    hobe_model_free(model);
    model = new_model();
    const struct hobe_force both = {.beam = "beam", .value = {1}, .function = field_force};
    check_sentence(hobe_model_force(model, &both, &err), HOBE_BAD_INPUT, &err,
                   "leave out follower and any other value");
    hobe_model_free(model);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.03, 0.05);
    each_load(section);
    fields(section);
    spring_of_the_caller(section);
    refused(section);
    hobe_section_free(section);
    return check_report();
}
