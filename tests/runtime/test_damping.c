/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damping of beams: a rigid motion feels none of the viscous stress, any other loses energy; the
 * matrices against differences, and against stiffness and mass at rest; and what cannot be damped.
 * Looks into the core (model.h). */
#include "damping.h"

#include "assemble.h"
#include "check.h"
#include "mass.h"
#include "pattern.h"
#include "scene.h"
#include "tangent.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, TAU = 3e-4, ALPHA = 700;

/* Equal on vectors that are one. */
static void fill(const hobe_model *model, double size, double *x)
{
    for (long i = 0; i < 3 * model->vectors; i++)
        x[i] = random_real(-size, size);
    for (long v = 0; v < model->vectors; v++)
        memcpy(x + 3 * v, x + 3 * model->alias[v], 3 * sizeof *x);
}

static double product(const hobe_model *model, const double *a, const double *b)
{
    double sum = 0;
    for (long i = 0; i < 3 * model->vectors; i++)
        sum += a[i] * b[i];
    return sum;
}

/* ---- scenes ---------------------------------------------------------------------------------- */

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context;
    (void)err;
    r[0] = sin(t);
    r[1] = 1 - cos(t);
    r[2] = 0.2 * t * t;
    return HOBE_OK;
}

/* A straight beam of more elements than a batch has, clamped inside, and a curved one that leaves
 * in its direction. */
static hobe_model *branch(const char *element, struct hobe_damping damping,
                          const hobe_section *section, const hobe_curve *curve)
{
    struct hobe_error err;
    hobe_model *model = new_model();
    struct hobe_beam beam = beam_along_x(element, 9, section, E, 0.3, 1);
    beam.damping = damping;
    beam.material.rho = 2700;
    add_beam(model, &beam);
    beam.name = "arc";
    beam.curve = curve;
    beam.elements = 3;
    add_beam(model, &beam);
    add_join(model, "beam", 0, "arc", 0);
    add_clamp(model, "beam", 4.0 / 9, 0);
    if (hobe_model_build(model, &err))
        check_stop("%s: %s", element, err.message);
    return model;
}

/* A rotation by rows. */
static void random_rotation(double R[3][3])
{
    double other[3];
    random_direction(R[0]);
    random_direction(other);
    cross3(R[0], other, R[2]);
    const double size = length3(R[2]);
    for (int a = 0; a < 3; a++)
        R[2][a] /= size;
    cross3(R[2], R[0], R[1]);
}

/* The state u and velocities v of a rigid rotation of everything, held or not: q = R q0, v = w x q.
 */
static void turn_rigidly(const hobe_model *model, double *u, double *v)
{
    double w[3], R[3][3], q[3], *q0 = field_on(model);
    random_rotation(R);
    random_direction(w);
    model_reference(model, q0);
    for (long n = 0; n < 3 * model->vectors; n += 3) {
        for (int a = 0; a < 3; a++) {
            q[a] = dot3(R[a], q0 + n);
            u[n + a] = q[a] - q0[n + a];
        }
        cross3(w, q, v + n);
    }
    hobe_free(q0);
}

/* ---- checks ---------------------------------------------------------------------------------- */

static void force(const hobe_model *model, const double *u, const double *v, double *f)
{
    memset(f, 0, 3 * (size_t)model->vectors * sizeof *f);
    damping_add(model, u, &(struct instant){.v = v}, f, NULL);
}

/* Rotating rigidly there is no viscous force, which is measured by that of a random motion as fast.
 * Round-off is relative to single products, which are larger by the stiffest section modes. */
static void check_rigid(const hobe_section *section, const hobe_curve *curve)
{
    hobe_model *model = branch("MGD30w", (struct hobe_damping){0, TAU}, section, curve);
    double *u = field_on(model), *v = field_on(model), *f = field_on(model);
    turn_rigidly(model, u, v);
    force(model, u, v, f);
    const double rigid = sqrt(product(model, f, f)), power = damping_power(model, u, v);
    fill(model, sqrt(3 * product(model, v, v) / (3 * (double)model->vectors)), v);
    force(model, u, v, f);
    check_absolute(rigid / sqrt(product(model, f, f)), 0, 1e-12, "rigid motion: viscous force");
    check_absolute(power / damping_power(model, u, v), 0, 1e-12, "rigid motion: power");
    hobe_free(u);
    hobe_free(v);
    hobe_free(f);
    hobe_model_free(model);
}

/* At a random state the forces are linear in the velocities by a symmetric matrix, whose quadratic
 * form is the power. */
static void check_power(const char *element, struct hobe_damping damping,
                        const hobe_section *section, const hobe_curve *curve)
{
    hobe_model *model = branch(element, damping, section, curve);
    double *u = field_on(model), *f = field_on(model), *v[2] = {field_on(model), field_on(model)};
    double work[2];
    fill(model, 0.3, u);
    for (int i = 0; i < 2; i++)
        fill(model, 1, v[i]);
    for (int i = 0; i < 2; i++) {
        force(model, u, v[i], f);
        const double power = damping_power(model, u, v[i]);
        check_that(power > 0, "%s: motion loses energy: %g", element, power);
        check_relative(product(model, v[i], f), power, 1e-12, "%s: v'f", element);
        work[i] = product(model, v[1 - i], f);
    }
    check_relative(work[0], work[1], 1e-10, "%s: symmetry", element);
    hobe_free(u);
    hobe_free(f);
    hobe_free(v[0]);
    hobe_free(v[1]);
    hobe_model_free(model);
}

/* The forces as functions of the velocities, in one state. */
static double *state;

static void by_velocities(const hobe_model *model, const double *v, double *r,
                          const struct matrix *K)
{
    damping_add(model, state, &(struct instant){.v = v, .rate = 1}, r, K);
}

static void check_matrix(const char *element, struct hobe_damping damping,
                         const hobe_section *section, const hobe_curve *curve)
{
    hobe_model *model = branch(element, damping, section, curve);
    state = field_on(model);
    fill(model, 0.3, state);
    check_tangent(model, by_velocities, 1, element);
    hobe_free(state);
    hobe_model_free(model);
}

/* At rest the matrices are those of Rayleigh: alpha M + tau K. */
static void check_rest(const char *element, const hobe_section *section, const hobe_curve *curve)
{
    const double rate = 900;
    hobe_model *model = branch(element, (struct hobe_damping){ALPHA, TAU}, section, curve);
    double *u = field_on(model), *f = field_on(model), worst = 0, largest = 0;
    struct matrix C, K, M;
    if (pattern_matrix(model, FRONTS, &C, NULL) || pattern_matrix(model, FRONTS, &K, NULL) ||
        pattern_matrix(model, FRONTS, &M, NULL))
        check_stop("out of memory");
    damping_add(model, u, &(struct instant){.v = u, .rate = rate}, f, &C);
    assemble(model, u, f, &K);
    mass_matrix(model, ALPHA, &M);
    for (size_t i = 0; i < fronts_size(model->fronts); i++) {
        worst = fmax(worst, fabs(C.value[i] - rate * (TAU * K.value[i] + M.value[i])));
        largest = fmax(largest, fabs(C.value[i]));
    }
    check_that(largest > 0, "%s: damping at rest is there", element);
    check_absolute(worst / largest, 0, 1e-14, "%s: damping at rest is Rayleigh's", element);
    hobe_free(C.value);
    hobe_free(K.value);
    hobe_free(M.value);
    hobe_free(u);
    hobe_free(f);
    hobe_model_free(model);
}

static void check_refused(const char *element, struct hobe_damping damping,
                          const hobe_section *section, const char *what)
{
    struct hobe_error err = {0};
    hobe_model *model = new_model();
    struct hobe_beam beam = beam_along_x(element, 1, section, E, 0.3, 1);
    beam.damping = damping;
    check_that(hobe_model_beam(model, &beam, &err) == HOBE_BAD_INPUT && strstr(err.message, what),
               "refused for %s: %s", what, err.message);
    hobe_model_free(model);
}

int main(void)
{
    static const char *const elements[] = {"MGD30w", "3433w", "BE24w"};
    static const struct hobe_damping all = {ALPHA, TAU}, viscous = {0, TAU}, mass = {ALPHA, 0};
    random_start();
    hobe_section *section = rectangle(0.1, 0.06);
    hobe_curve *curve = curve_of(arc, NULL, NULL);
    check_rigid(section, curve);
    for (int i = 0; i < 3; i++) {
        check_power(elements[i], all, section, curve);
        check_matrix(elements[i], viscous, section, curve);
        check_rest(elements[i], section, curve);
    }
    check_power("3333s", mass, section, curve);
    check_matrix("3333s", mass, section, curve);
    check_refused("3333s", viscous, section, "viscous stress");
    check_refused("MGD30w", (struct hobe_damping){-1, 0}, section, "damping.mass");
    check_refused("MGD30w", (struct hobe_damping){0, NAN}, section, "damping.stiffness");
    hobe_curve_free(curve);
    hobe_section_free(section);
    return check_report();
}
