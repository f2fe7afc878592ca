/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenes that turn steadily: the centrifugal force, and gyroscopic modes
 * against the dense quadratic eigenproblem, blades, shafts on their own axes; and motion.
 * Looks into the core (load.h) for the tangents, and (eigen.h) for eigenvalues. */
#include "assemble.h"
#include "check.h"
#include "constraint.h"
#include "eigen.h"
#include "load.h"
#include "mass.h"
#include "pattern.h"
#include "scene.h"
#include "solution.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- scenes ---------------------------------------------------------------------------------- */

static void add_spin(hobe_model *model, const struct hobe_spin *spin)
{
    struct hobe_error err;
    if (hobe_model_spin(model, spin, &err))
        check_stop("hobe_model_spin: %s", err.message);
}

static struct hobe_spin random_spin(double most)
{
    struct hobe_spin spin = {.speed = random_real(-most, most)};
    random_direction(spin.axis);
    for (int a = 0; a < 3; a++) {
        spin.axis[a] *= 7;
        spin.about[a] = random_real(-1, 1);
    }
    return spin;
}

static struct hobe_beam arm(const char *name, const hobe_section *section, int elements)
{
    struct hobe_beam beam = beam_along_x("MGD30", elements, section, 70e9, 0.3, 1);
    beam.name = name;
    beam.material.rho = 2700;
    return beam;
}

/* One arm, or two that meet at a random angle. */
static hobe_model *arms(const hobe_section *section, int corner)
{
    struct hobe_beam beam = arm("first", section, 2);
    hobe_model *model = new_model();
    add_beam(model, &beam);
    add_clamp(model, "first", 0, 0);
    if (corner) {
        beam.name = "second";
        beam.from[0] = 1;
        for (int a = 0; a < 3; a++)
            beam.to[a] = beam.from[a] + random_real(0.4, 0.8);
        add_beam(model, &beam);
        add_join(model, "first", 1, "second", 0);
    }
    return model;
}

/* ---- the force ------------------------------------------------------------------------------- */

static void all_loads(const hobe_model *model, const double *u, double *r, const struct matrix *K)
{
    load_subtract(model, u, &AT_REST, 0.7, r, K);
}

static void tangents(void)
{
    hobe_section *section = rectangle(0.1, 0.2);
    for (int corner = 0; corner < 2; corner++) {
        hobe_model *model = arms(section, corner);
        const struct hobe_spin spin = random_spin(20);
        add_spin(model, &spin);
        check_tangent(model, all_loads, 1, "centrifugal force");
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* On a body at rest the force adds up to w^2 m P (c - about), c its centre, and so do the reactions
 * that hold it, by its deformed axis: rho A w^2 P int (r - about) ds.  The axis' mean is that of
 * Simpson's rule in every element, whose cubic is integrated exactly. */
static void balance(void)
{
    hobe_section *section = rectangle(0.05, 0.1);
    struct hobe_beam beam = arm("beam", section, 4);
    const double mass = 2700 * 0.005;
    hobe_model *model = new_model();
    struct hobe_spin spin = random_spin(60);
    double mean[3] = {0}, expected[3], arm_length = 0;
    add_beam(model, &beam);
    struct hobe_error err;
    struct hobe_reaction reaction;
    const struct hobe_clamp root = {.beam = "beam", .name = "root"};
    if (hobe_model_clamp(model, &root, &err))
        check_stop("clamp: %s", err.message);
    add_spin(model, &spin);
    hobe_solution *solution = solve(model, 1);
    for (int i = 0; i <= 8; i++) {
        const struct hobe_point p = point_of(solution, "beam", i / 8.0, 0, 0);
        const double weight = (i == 0 || i == 8 ? 1 : i % 2 ? 4 : 2) / 24.0;
        for (int a = 0; a < 3; a++)
            mean[a] += weight * ((a == 0) * i / 8.0 + p.u[a] - spin.about[a]);
    }
    const double e2 = dot3(spin.axis, spin.axis), along = dot3(mean, spin.axis) / e2;
    for (int a = 0; a < 3; a++) {
        expected[a] = -spin.speed * spin.speed * mass * (mean[a] - along * spin.axis[a]);
        arm_length = fmax(arm_length, fabs(expected[a]));
    }
    if (hobe_solution_reaction(solution, "root", &reaction, &err))
        check_stop("reaction: %s", err.message);
    for (int a = 0; a < 3; a++) /* equilibrium is found to 1e-9 of the load */
        check_absolute(reaction.force[a], expected[a], 1e-8 * arm_length, "reaction along %c",
                       "xyz"[a]);
    /* and the section force there, which is read off beyond the first element's own load */
    struct hobe_resultants cut;
    if (hobe_solution_resultants(solution, "beam", 0, HOBE_CUT_FORCES, &cut, &err))
        check_stop("resultants: %s", err.message);
    for (int a = 0; a < 3; a++) {
        double force = 0;
        for (int b = 0; b < 3; b++)
            force -= cut.axes[b][a] * cut.force[b];
        check_absolute(force, expected[a], 1e-8 * arm_length, "section force along %c", "xyz"[a]);
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- all modes, densely ---------------------------------------------------------------------- */

/* x = A^-1 x of a full matrix by columns, A[n][n] destroyed, for m right-hand sides x[m][n]:
 * elimination with complete rows pivoted. */
static void eliminate(int n, double *A, int m, double *x)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k; i < n; i++)
            if (fabs(A[k * n + i]) > fabs(A[k * n + best]))
                best = i;
        for (int j = 0; j < n + m; j++) {
            double *column = j < n ? A + j * n : x + (j - n) * n;
            const double held = column[best];
            column[best] = column[k];
            column[k] = held;
        }
        for (int j = n + m - 1; j > k; j--) {
            double *column = j < n ? A + j * n : x + (j - n) * n;
            const double factor = column[k] / A[k * n + k];
            for (int i = k + 1; i < n; i++)
                column[i] -= factor * A[k * n + i];
        }
    }
    for (int j = 0; j < m; j++)
        for (int k = n - 1; k >= 0; k--) {
            x[j * n + k] /= A[k * n + k];
            for (int i = 0; i < k; i++)
                x[j * n + i] -= A[k * n + i] * x[j * n + k];
        }
}

/* full[n][n], by columns, of a matrix in the model's pattern, rows and columns scaled. */
static void spread(const hobe_model *model, const double *value, const double *scale, double *full)
{
    const struct pattern *p = &model->pattern;
    const long n = 3 * model->unknowns;
    memset(full, 0, (size_t)(n * n) * sizeof *full);
    for (long j = 0; j < n; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            full[j * n + p->Ai[k]] = scale[p->Ai[k]] * value[k] * scale[j];
}

struct dense {
    int n;
    double *re, *im; /* [2n] 1/lambda */
};

static void *numbers(long n)
{
    void *p = calloc((size_t)n, sizeof(double));
    if (!p)
        check_stop("out of memory");
    return p;
}

/* 1/lambda are the eigenvalues of [-K^-1 G, -K^-1 M; I, 0]. */
static struct dense solve_densely(const hobe_model *model, const hobe_solution *state,
                                  const double w[3])
{
    struct hobe_error err;
    const int n = (int)(3 * model->unknowns);
    const double G[3][3] = {
        {0, -2 * w[2], 2 * w[1]}, {2 * w[2], 0, -2 * w[0]}, {-2 * w[1], 2 * w[0], 0}};
    struct dense d = {n, numbers(2 * n), numbers(2 * n)};
    struct matrix part[3];
    double *full = numbers(n * n), *right = numbers(2 * n * n), *A = numbers(4 * n * n);
    double *Z = numbers(4 * n * n), *scale = numbers(n), *r = numbers(3 * model->vectors);
    double *u = numbers(3 * model->vectors);
    for (int i = 0; i < 3; i++)
        if (pattern_matrix(model, COLUMNS, part + i, &err))
            check_stop("%s", err.message);
    for (long v = 0; v < model->vectors; v++)
        for (int a = 0; a < 3; a++)
            u[3 * v + a] = state->u[3 * v + a];
    assemble(model, u, r, &part[0]);
    constraint_add(model, u, &AT_REST, r, &part[0]);
    load_subtract(model, u, &AT_REST, 1, r, &part[0]);
    mass_matrix_through(model, G, &part[1]);
    mass_matrix(model, 1, &part[2]);
    pattern_scale(model, &part[0], scale);
    spread(model, part[0].value, scale, full);
    for (int i = 0; i < 2; i++)
        spread(model, part[1 + i].value, scale, right + i * n * n);
    eliminate(n, full, 2 * n, right);
    for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
            A[j * 2 * n + i] = -right[j * n + i];
            A[(n + j) * 2 * n + i] = -right[(n + j) * n + i];
        }
        A[j * 2 * n + n + j] = 1;
    }
    if (eigen_general(2 * n, A, d.re, d.im, Z, &err))
        check_stop("%s", err.message);
    void *const all[] = {full, right, A, Z, scale, r, u};
    for (int i = 0; i < 7; i++)
        free(all[i]);
    for (int i = 0; i < 3; i++)
        hobe_free(part[i].value);
    return d;
}

/* The i-th of 1/|lambda|, descending, of those with Im >= 0. */
static double largest(const struct dense *d, int i)
{
    double below = INFINITY;
    for (;; i--) {
        double most = 0;
        for (int j = 0; j < 2 * d->n; j++) {
            const double size = hypot(d->re[j], d->im[j]);
            if (d->im[j] > 0 && size < below && size > most)
                most = size;
        }
        if (i == 0)
            return most;
        below = most;
    }
}

/* Slow enough to be stable: |lambda| in order are the frequencies. */
static void against_dense(int corner, int count, enum hobe_modal_method method)
{
    hobe_section *section = rectangle(0.05, 0.08);
    hobe_model *model = arms(section, corner);
    struct hobe_spin spin = random_spin(100);
    double w[3];
    add_spin(model, &spin);
    hobe_solution *solution = solve(model, 1);
    const double length = length3(spin.axis);
    for (int a = 0; a < 3; a++)
        w[a] = spin.speed * spin.axis[a] / length;
    hobe_modes *modes = modes_of(model, solution, count, method);
    const struct dense d = solve_densely(model, solution, w);
    check_that(modes_info(modes).unstable == 0, "stable");
    /* the square of the residual that is asked for, and eigenvalues of a dense matrix that is not
     * symmetric, whose rounding is relative to its norm times their condition */
    for (int i = 0; i < count; i++)
        check_relative(mode_of(modes, i).omega, 1 / largest(&d, i), 1e-8,
                       "corner %d, mode %d of %d at %.3g rad/s", corner, i, count, spin.speed);
    for (int i = 0; i < count; i++)
        check_absolute(hobe_modes_mass(modes, i, i), 1, 1e-10, "modal mass");
    free(d.re);
    free(d.im);
    hobe_modes_free(modes);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- cantilevers ----------------------------------------------------------------------------- */

struct shaft {
    hobe_section *section;
    hobe_model *model;
    hobe_solution *solution;
    hobe_modes *modes;
};

static struct shaft turn_shaft(double width, double height, int axis, double w)
{
    struct shaft s = {.section = rectangle(width, height)};
    const struct hobe_beam beam = arm("beam", s.section, 4);
    s.model = cantilever(&beam, 0);
    struct hobe_spin spin = {.speed = w};
    spin.axis[axis] = 1;
    if (w > 0)
        add_spin(s.model, &spin);
    s.solution = solve(s.model, 1);
    s.modes = modes_of(s.model, s.solution, 4, HOBE_MODAL_AUTO);
    return s;
}

static void close_shaft(struct shaft *s)
{
    hobe_modes_free(s->modes);
    hobe_solution_free(s->solution);
    hobe_model_free(s->model);
    hobe_section_free(s->section);
}

/* A square blade across the axis flaps and lags alike but for what the centrifugal force takes from
 * the lag, w^2 M: omega_flap^2 - omega_lag^2 = w^2.  Coriolis' force stretches the lagging axis, by
 * which it moves with 4 w^2/omega_axial^2 = 2e-4 more inertia; the section's own is (h/L)^2 = 4e-4
 * of the whole. */
static void blade(void)
{
    const double w = 60;
    struct shaft s = turn_shaft(0.02, 0.02, 2, w);
    const struct hobe_mode lag = mode_of(s.modes, 0), flap = mode_of(s.modes, 1);
    check_relative(flap.omega2 - lag.omega2, w * w, 1e-3, "flap and lag");
    check_absolute(flap.whirl, 0, 1e-6, "flapping is to and fro");
    check_that(lag.omega < flap.omega && modes_info(s.modes).unstable == 0, "in this order");
    close_shaft(&s);
}

/* ---- shafts on their own axes ---------------------------------------------------------------- */

/* Seen in the turning frame a line of mass that whirls with omega either way does so with
 * omega - w and omega + w; its stiffness is singular at w = omega, and beyond it is stable for all
 * that.  The section's inertia about its diameters adds the order of (h/L)^2 w = 1e-4 w. */
static void round_shaft(void)
{
    struct shaft rest = turn_shaft(0.02, 0.02, 0, 0);
    const double omega = mode_of(rest.modes, 0).omega;
    static const double speeds[] = {0.2, 0.9, 1.5};
    for (int i = 0; i < 3; i++) {
        const double w = speeds[i] * omega;
        struct shaft s = turn_shaft(0.02, 0.02, 0, w);
        const struct hobe_mode with = mode_of(s.modes, 0), against = mode_of(s.modes, 1);
        check_absolute(with.omega, fabs(omega - w), 4e-4 * w, "forward whirl at %g omega",
                       speeds[i]);
        check_absolute(against.omega, omega + w, 4e-4 * w, "backward whirl at %g omega", speeds[i]);
        check_absolute(with.whirl, w < omega ? 1 : -1, 1e-3, "it goes with the frame");
        check_absolute(against.whirl, -1, 1e-3, "it goes against the frame");
        check_that(modes_info(s.modes).unstable == 0 &&
                       !hobe_modes_note(s.modes) == (speeds[i] < 1),
                   "stable at %g omega, by gyroscopic forces beyond: %s", speeds[i],
                   hobe_modes_note(s.modes) ? hobe_modes_note(s.modes) : "no note");
        double u[3], v[3];
        struct hobe_error err;
        if (hobe_modes_point(s.modes, 0, "beam", 1, 0, 0, u, &err) ||
            hobe_modes_quadrature(s.modes, 0, "beam", 1, 0, 0, v, &err))
            check_stop("%s", err.message);
        check_relative(norm(v), norm(u), 1e-5, "it circles");
        check_absolute(dot3(u, v), 0, 1e-5 * dot3(u, u), "it circles");
        close_shaft(&s);
    }
    close_shaft(&rest);
}

/* Two frequencies a < b of one shape: lambda^4 + (a^2 + b^2 + 2 w^2) lambda^2 +
 * (a^2 - w^2)(b^2 - w^2) = 0, unstable between a and b.  Both shapes differ by shear only. */
static void flat_shaft(void)
{
    struct shaft rest = turn_shaft(0.02, 0.03, 0, 0);
    const double a = mode_of(rest.modes, 0).omega, b = mode_of(rest.modes, 1).omega;
    for (int i = 0; i < 3; i++) {
        const double w = i == 0 ? 0.5 * a : i == 1 ? (a + b) / 2 : 1.2 * b;
        struct shaft s = turn_shaft(0.02, 0.03, 0, w);
        const double half = (a * a + b * b + 2 * w * w) / 2;
        const double root = sqrt(half * half - (a * a - w * w) * (b * b - w * w));
        const struct hobe_mode low = mode_of(s.modes, 0), high = mode_of(s.modes, 1);
        check_absolute(low.omega2, half - root, 1e-3 * w * w, "lambda^2 at %g rad/s", w);
        check_absolute(high.omega2, half + root, 1e-3 * high.omega2, "lambda^2 at %g rad/s", w);
        check_that(modes_info(s.modes).unstable == (i == 1) && (low.growth > 0) == (i == 1) &&
                       isnan(low.omega) == (i == 1) && (i != 1 || hobe_modes_note(s.modes)),
                   "unstable between the critical speeds alone: %d at %g rad/s",
                   modes_info(s.modes).unstable, w);
        close_shaft(&s);
    }
    close_shaft(&rest);
}

/* Buckling under the centrifugal force alone: the critical speed is the frequency at rest, to the
 * inertia of the section about its diameters, (h/L)^2 = 4e-4. */
static void critical_speed(void)
{
    struct shaft s = turn_shaft(0.02, 0.02, 0, 1), rest = turn_shaft(0.02, 0.02, 0, 0);
    struct hobe_error err;
    hobe_modes *modes;
    if (hobe_buckling(s.model, NULL, &(struct hobe_modal_options){.modes = 1}, &modes, &err))
        check_stop("buckling: %s", err.message);
    check_relative(sqrt(hobe_modes_factor(modes, 0)), mode_of(rest.modes, 0).omega, 4e-4,
                   "critical speed");
    hobe_modes_free(modes);
    close_shaft(&s);
    close_shaft(&rest);
}

/* ---- motion ---------------------------------------------------------------------------------- */

/* What is at rest in space circles backwards in the turning frame, unstrained: how far from there
 * the end of a rod that nothing holds is after `steps` steps of one second in all, m.  A history
 * must have the mean 1 in that second. */
static double drift(const struct hobe_spin *spin, int steps)
{
    hobe_section *section = rectangle(0.05, 0.1);
    struct hobe_beam beam = arm("beam", section, 1);
    hobe_model *model = new_model();
    beam.material.E = 1e8; /* forces of inertia are not lost in the rounding of strain */
    struct hobe_motion motion = {0};
    struct hobe_error err;
    hobe_history *history;
    double arm0[3], e[3], across[3], expected[3], first[3] = {1};
    const double length = length3(spin->axis), c = cos(spin->speed), s = -sin(spin->speed);
    add_beam(model, &beam);
    add_spin(model, spin);
    if (spin->history && hobe_drive_at(spin->history, 0, first, &err))
        check_stop("%s", err.message);
    for (int a = 0; a < 3; a++) {
        e[a] = spin->axis[a] / length;
        motion.angular_velocity[a] = -spin->speed * first[0] * e[a];
        motion.about[a] = spin->about[a];
        arm0[a] = (a == 0) - spin->about[a];
    }
    if (hobe_model_motion(model, &motion, &err) ||
        hobe_dynamic(model, &(struct hobe_dynamic){.to = 1, .step = 1.0 / steps, .store = 1},
                     &history, &err))
        check_stop("%s", err.message);
    const hobe_solution *end = hobe_history_state(history, 1);
    const struct hobe_point p = point_of(end, "beam", 1, 0, 0);
    cross3(e, arm0, across);
    for (int a = 0; a < 3; a++)
        expected[a] = spin->about[a] + c * arm0[a] + s * across[a] +
                      (1 - c) * dot3(e, arm0) * e[a] - (a == 0);
    const double off = distance(p.u, expected);
    hobe_history_free(history);
    hobe_model_free(model);
    hobe_section_free(section);
    return off;
}

/* The integration is of second order, halved steps leave a quarter; w h < 0.03. */
static void seen_from_the_frame(void)
{
    struct hobe_spin spin = random_spin(0);
    spin.speed = random_real(1, 1.5);
    const double coarse = drift(&spin, 50), fine = drift(&spin, 100);
    check_relative(coarse / fine, 4, 0.1, "from %.3g m to %.3g m off", coarse, fine);
    check_absolute(fine, 0, 1e-3, "at rest in space");
}

/* The same in a frame that turns ever faster, with Euler's force. */
static void seen_from_a_frame_that_speeds_up(void)
{
    struct hobe_spin spin = random_spin(0);
    struct hobe_error err;
    const double rise = random_real(-0.5, 0.5);
    const double point[2][2] = {{0, 1 - rise}, {1, 1 + rise}};
    spin.speed = random_real(1, 1.5);
    spin.history = hobe_drive_points(2, point, HOBE_LINEAR, 0, &err);
    if (!spin.history)
        check_stop("%s", err.message);
    const double coarse = drift(&spin, 50), fine = drift(&spin, 100);
    check_relative(coarse / fine, 4, 0.1, "from %.3g m to %.3g m off", coarse, fine);
    check_absolute(fine, 0, 2e-3, "at rest in space");
    hobe_drive_free(spin.history);
}

/* ---- what is refused ------------------------------------------------------------------------- */

static void refused(const struct hobe_spin *spin, int times, const char *words)
{
    struct hobe_error err = {0};
    hobe_section *section = rectangle(0.1, 0.1);
    hobe_model *model = arms(section, 0);
    enum hobe_status status = HOBE_OK;
    for (int i = 0; i < times; i++)
        status = hobe_model_spin(model, spin, &err);
    check_that(status == HOBE_BAD_INPUT && strstr(err.message, words), "%s: %d, %s", words, status,
               status ? err.message : "accepted");
    hobe_model_free(model);
    hobe_section_free(section);
}

static void errors(void)
{
    refused(&(struct hobe_spin){.speed = 1}, 1, "must be a direction");
    refused(&(struct hobe_spin){.axis = {NAN, 0, 1}, .speed = 1}, 1, "must be a direction");
    refused(&(struct hobe_spin){.axis = {0, 0, 1}, .speed = INFINITY}, 1, "must be finite");
    refused(&(struct hobe_spin){.axis = {0, 0, 1}, .speed = 1}, 2, "there is another one");
    struct hobe_error err;
    const double jump[3][2] = {{0, 0}, {1, 0}, {1, 1}};
    hobe_drive *history = hobe_drive_points(3, jump, HOBE_LINEAR, 0, &err);
    refused(&(struct hobe_spin){.axis = {0, 0, 1}, .speed = 1, .history = history}, 1,
            "cannot jump, at t = 1 s");
    hobe_drive_free(history);
    hobe_section *section = rectangle(0.1, 0.1);
    struct hobe_beam beam = arm("beam", section, 1);
    beam.material.rho = 0;
    hobe_model *model = cantilever(&beam, 0);
    add_spin(model, &(struct hobe_spin){.axis = {0, 0, 1}, .speed = 1});
    check_that(hobe_model_build(model, &err) == HOBE_BAD_INPUT &&
                   strstr(err.message, "a spin needs a density"),
               "no density: %s", err.message);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    tangents();
    balance();
    against_dense(0, 3, HOBE_MODAL_DENSE);
    against_dense(0, 3, HOBE_MODAL_LANCZOS);
    against_dense(1, 5, HOBE_MODAL_AUTO);
    blade();
    round_shaft();
    flat_shaft();
    critical_speed();
    seen_from_the_frame();
    seen_from_a_frame_that_speeds_up();
    errors();
    return check_report();
}
