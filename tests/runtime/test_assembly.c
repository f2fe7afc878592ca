/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums over elements: the same to the last digit by one thread and by many, and the same tangent in
 * fronts as in columns; what is left open by round-off.  Looks into the core (model.h). */
#include "assemble.h"
#include "check.h"
#include "pattern.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 70e9, NU = 0.33;

static void add_straight(hobe_model *model, const char *name, int elements, double from, double to,
                         const hobe_section *section)
{
    struct hobe_beam beam = beam_along_x("BE24w", elements, section, E, NU, 1);
    beam.name = name;
    beam.from[0] = from;
    beam.to[0] = to;
    add_beam(model, &beam);
}

static enum hobe_status half_circle(void *context, double t, double *r, struct hobe_error *err)
{
    const double a = 3.14159265358979323846 * (t + *(const double *)context);
    (void)err;
    r[0] = cos(a);
    r[1] = sin(a);
    r[2] = 0;
    return HOBE_OK;
}

/* One beam, long enough for several threads. */
static hobe_model *line(const hobe_section *section)
{
    hobe_model *model = new_model();
    add_straight(model, "beam", 1200, 0, 12, section);
    add_clamp(model, "beam", 0, 0);
    return model;
}

/* Beams that meet in a node, not in the order of their vectors. */
static hobe_model *forked(const hobe_section *section)
{
    hobe_model *model = new_model();
    add_straight(model, "one", 301, 4, 7, section);
    add_straight(model, "other", 150, 4, 6, section);
    add_straight(model, "stem", 400, 0, 4, section);
    add_join(model, "one", 0, "stem", 1);
    add_join(model, "other", 0, "stem", 1);
    add_clamp(model, "stem", 0, 0);
    return model;
}

static double *random_field(const hobe_model *model, double size)
{
    double *u = hobe_alloc((size_t)(3 * model->vectors), sizeof *u, NULL);
    if (!u)
        check_stop("no memory");
    for (long i = 0; i < 3 * model->vectors; i++)
        u[i] = random_real(-size, size);
    return u;
}

static struct matrix new_matrix(const hobe_model *model, enum layout layout)
{
    struct matrix K;
    if (pattern_matrix(model, layout, &K, NULL))
        check_stop("no memory");
    return K;
}

static void threads_agree(hobe_model *model, const char *what)
{
    const int most = model->schedule.threads;
    double *u = random_field(model, 1e-3), *f[2] = {random_field(model, 1), random_field(model, 1)};
    struct matrix K[2] = {new_matrix(model, FRONTS), new_matrix(model, FRONTS)};
    check_that(most > 1, "%s: large enough for %d threads", what, most);
    for (int i = 0; i < 2; i++) {
        model->schedule.threads = i ? most : 1;
        assemble(model, u, f[i], K + i);
    }
    check_that(!memcmp(f[0], f[1], (size_t)(3 * model->vectors) * sizeof *u), "%s: same forces",
               what);
    check_that(!memcmp(K[0].value, K[1].value, fronts_size(model->fronts) * sizeof *u),
               "%s: same tangent", what);
    for (int i = 0; i < 2; i++) {
        hobe_free(f[i]);
        hobe_free(K[i].value);
    }
    hobe_free(u);
}

/* y = A x in columns, x over the unknowns. */
static void multiply(const hobe_model *model, const struct matrix *A, const double *x, double *y)
{
    const struct pattern *p = &model->pattern;
    memset(y, 0, (size_t)(3 * p->blocks) * sizeof *y);
    for (long j = 0; j < 3 * p->blocks; j++)
        for (long k = p->Ap[j]; k < p->Ap[j + 1]; k++)
            y[p->Ai[k]] += A->value[k] * x[j];
}

/* A x = b by the fronts, multiplied out in the columns: relative to the sizes that meet there.  In
 * a state so near to rest that the beam has not buckled, at strains of 1e-6: else a pivot may be
 * small.
 */
static void layouts_agree(hobe_model *model, const char *what)
{
    const long n = 3 * model->unknowns;
    double *u = random_field(model, 1e-9), *f = random_field(model, 1);
    double *b = random_field(model, 1), *x = random_field(model, 1),
           *scale = random_field(model, 1);
    if (pattern_columns(model, NULL))
        check_stop("no memory");
    struct matrix F = new_matrix(model, FRONTS), C = new_matrix(model, COLUMNS);
    assemble(model, u, f, &F);
    assemble(model, u, f, &C);
    pattern_scale(model, &C, scale);
    for (long i = 0; i < n; i++) {
        u[i] = 1 / scale[i];
        b[i] *= u[i];
        x[i] = b[i];
    }
    pattern_scale(model, &F, scale);
    for (long i = 0; i < n; i++)
        check_relative(scale[i], 1 / u[i], 1e-12, "%s: diagonal %ld", what, i);
    check_that(!fronts_factor(model->fronts, F.value, scale), "%s: factors", what);
    fronts_solve(model->fronts, F.value, x);
    multiply(model, &C, x, f);
    double worst = 0, size = 0;
    for (long i = 0; i < n; i++) {
        worst = fmax(worst, fabs(f[i] - b[i]) * scale[i]);
        size = fmax(size, fabs(x[i]) / scale[i]);
    }
    check_absolute(worst / (1 + size), 0, 1e-12, "%s: fronts and columns", what);
    double *const all[] = {u, f, b, x, scale, F.value, C.value};
    for (int i = 0; i < 7; i++)
        hobe_free(all[i]);
}

/* The stiffness with expected stresses is K(u) less the geometric stiffness of v v/2, which the
 * even part of the strained stiffness in v has, too: of strains u - v to u, +-v makes +-(B v) - v
 * v/2. */
static void expects(hobe_model *model, const char *what)
{
    const size_t size = fronts_size(model->fronts), n = (size_t)(3 * model->vectors);
    double *u = random_field(model, 1e-2), *v = random_field(model, 1e-2);
    double *f = random_field(model, 1), worst = 0, largest = 0;
    struct matrix K[5];
    for (int i = 0; i < 5; i++)
        K[i] = new_matrix(model, FRONTS);
    assemble_expecting(model, u, v, f, K);
    assemble(model, u, f, K + 1);
    assemble_strained(model, u, v, K + 2);
    for (size_t i = 0; i < n; i++)
        v[i] = -v[i];
    assemble_strained(model, u, v, K + 3);
    memset(v, 0, n * sizeof *v);
    assemble_strained(model, u, v, K + 4);
    for (size_t i = 0; i < size; i++) {
        const double even = (K[2].value[i] + K[3].value[i]) / 2 - K[4].value[i];
        worst = fmax(worst, fabs(K[0].value[i] - K[1].value[i] - even));
        largest = fmax(largest, fabs(even));
    }
    check_that(largest > 0, "%s: expected stresses differ", what);
    check_absolute(worst / largest, 0, 1e-10, "%s: expected stresses", what);
    for (int i = 0; i < 5; i++)
        hobe_free(K[i].value);
    double *const all[] = {u, v, f};
    for (int i = 0; i < 3; i++)
        hobe_free(all[i]);
}

/* A blade that a tip load bends by half its length and twists, in one step: the true tangent
 * takes about twice as many iterations. */
static void iterates_little(void)
{
    hobe_section *section = rectangle(3.2e-3, 12.4e-3);
    const struct hobe_beam beam = beam_along_x("MGD30w", 24, section, E, NU, 0.5);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, -9.4, -9.4);
    hobe_solution *r = solve(model, 1);
    check_that(info_of(r).iterations <= 8, "few iterations: %d", info_of(r).iterations);
    hobe_solution_free(r);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A ring of two half circles has no end to begin at: another order of elimination. */
static void ring(const hobe_section *section)
{
    double start[2] = {0, 1};
    hobe_curve *curve[2];
    hobe_model *model = new_model();
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x("MGD30w", 9, section, E, NU, 1);
        curve[i] = curve_of(half_circle, NULL, start + i);
        beam.name = i ? "second" : "first";
        beam.curve = curve[i];
        add_beam(model, &beam);
    }
    add_join(model, "first", 1, "second", 0);
    add_join(model, "second", 1, "first", 0);
    add_clamp(model, "first", 1.0 / 3, 0);
    if (hobe_model_build(model, NULL))
        check_stop("the ring could not be built");
    layouts_agree(model, "ring");
    expects(model, "ring");
    hobe_model_free(model);
    hobe_curve_free(curve[0]);
    hobe_curve_free(curve[1]);
}

/* A cantilever of square section under a small load at its tip; *theory is its deflection. */
static hobe_model *slender(const hobe_section *section, double side, int elements, double *theory)
{
    const double length = 10, stiffness = E * pow(side, 4) / 12, sag = 1e-4;
    const struct hobe_beam beam = beam_along_x("MGD30w", elements, section, E, 0, length);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, -3 * stiffness * sag / pow(length, 3));
    *theory = sag;
    return model;
}

/* `change` is more than the error by round-off, beside that of the mesh, which falls faster than by
 * the third power of its elements (4e-6 of ten, 3e-9 of a hundred). */
static void round_off(void)
{
    const double side = 1e-4;
    hobe_section *section = rectangle(side, side);
    double theory;
    for (int elements = 10; elements <= 1000; elements *= 10) {
        hobe_model *model = slender(section, side, elements, &theory);
        hobe_solution *r = solve(model, 1);
        const double change = info_of(r).change;
        const double error = -point_of(r, "beam", 1, 0, 0).u[2] / theory - 1;
        printf("%d elements: change %.1e, error %.1e\n", elements, change, error);
        check_that(fabs(error) < change + 0.01 * pow(elements, -3),
                   "%d elements: change %g, error %g", elements, change, error);
        hobe_solution_free(r);
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* Ten times more slender, round-off is as large as the load, and nothing is called a solution. */
static void nothing_left(void)
{
    const double side = 1e-5;
    const struct hobe_newton options = {.smallest_step = 0.9, .no_line_search = 1};
    struct hobe_error err = {0};
    double theory;
    hobe_section *section = rectangle(side, side);
    hobe_model *model = slender(section, side, 1000, &theory);
    hobe_solution *none;
    check_that(hobe_static(model, &options, &none, &err) == HOBE_NOT_CONVERGED && !none,
               "no equilibrium in round-off");
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    hobe_section *section = rectangle(0.02, 0.03);
    static hobe_model *(*const make[])(const hobe_section *) = {line, forked};
    static const char *const name[] = {"line", "fork"};
    for (int i = 0; i < 2; i++) {
        hobe_model *model = make[i](section);
        if (hobe_model_build(model, NULL))
            check_stop("%s could not be built", name[i]);
        threads_agree(model, name[i]);
        layouts_agree(model, name[i]);
        expects(model, name[i]);
        hobe_model_free(model);
    }
    ring(section);
    hobe_section_free(section);
    iterates_little();
    round_off();
    nothing_left();
    return check_report();
}
