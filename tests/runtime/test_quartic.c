/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a model on a few fields, and on functions with vectors for coefficients, is that of
 * its elements, with its derivatives: prismatic, tapered and curved beams, beams that share
 * vectors, at rest and about other states; its form is semidefinite; a rotation has no energy; what
 * round-off leaves of a slender beam.  Looks into the core (quartic.h). */
#include "quartic.h"

#include "assemble.h"
#include "check.h"
#include "eigen.h"
#include "quartic_closed.h"
#include "scene.h"
#include "solution.h"
#include "tangent.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, NU = 0.3;

/* ---- scenes ---------------------------------------------------------------------------------- */

static hobe_section *i_section(void)
{
    struct hobe_error err;
    const struct hobe_profile_sizes sizes = {
        .width = 0.1, .height = 0.2, .flange = 0.01, .web = 0.008};
    hobe_section *section = hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    return section;
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context;
    (void)err;
    r[0] = 2 * sin(t);
    r[1] = 2 * cos(t);
    r[2] = 0.3 * t;
    return HOBE_OK;
}

/* Two beams that meet at a corner, in a node they share. */
static hobe_model *corner(const hobe_section *section)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 10, section, E, NU, 2);
    hobe_model *model = cantilever(&beam, 0);
    beam = beam_along_x("3333w", 3, section, E, NU, 1);
    beam.name = "second";
    beam.from[0] = 2;
    beam.to[0] = 3;
    add_beam(model, &beam);
    add_join(model, "beam", 1, "second", 0);
    return model;
}

static hobe_model *curved(const hobe_section *section, hobe_curve *curve)
{
    struct hobe_beam beam = beam_along_x("MGD30w", 4, section, E, NU, 0);
    beam.curve = curve;
    return cantilever(&beam, 0);
}

static hobe_model *straight(const char *element, int elements, const hobe_section *section)
{
    const struct hobe_beam beam = beam_along_x(element, elements, section, E, NU, 2);
    return cantilever(&beam, 0);
}

/* ---- fields ---------------------------------------------------------------------------------- */

/* What a reduced energy is compared with: the elements, on fields of a built model. */
struct subject {
    const hobe_model *model;
    const char *what;
    long n, size;                                     /* of fields; 3 * vectors */
    double *centre, *field, *u, *f, *q, *reduced, *K; /* NULL centre: the reference */
};

static double *numbers(long count)
{
    double *x = hobe_alloc((size_t)count, sizeof *x, NULL);
    if (!x)
        check_stop("out of memory");
    return x;
}

static void random_field(const hobe_model *model, double size, double *u)
{
    for (long i = 0; i < 3 * model->vectors; i++)
        u[i] = model->unknown[i / 3] >= 0 ? random_real(-size, size) : 0;
}

static void open_subject(struct subject *s, hobe_model *model, long n, int at_rest,
                         const char *what)
{
    struct hobe_error err;
    if (hobe_model_build(model, &err))
        check_stop("%s: %s", what, err.message);
    *s = (struct subject){.model = model, .what = what, .n = n, .size = 3 * model->vectors};
    s->centre = at_rest ? NULL : field_on(model);
    s->field = numbers(n * s->size);
    s->u = field_on(model);
    s->f = field_on(model);
    s->q = numbers(n);
    s->reduced = numbers(2 * n);
    s->K = numbers(n * n);
    if (s->centre)
        random_field(model, 0.3, s->centre);
    for (long i = 0; i < n; i++)
        random_field(model, 1, s->field + i * s->size);
}

static void close_subject(struct subject *s)
{
    double *const all[] = {s->centre, s->field, s->u, s->f, s->q, s->reduced, s->K};
    for (int i = 0; i < 7; i++)
        hobe_free(all[i]);
}

static void expand(const struct subject *s, const double *q)
{
    for (long i = 0; i < s->size; i++) {
        s->u[i] = s->centre ? s->centre[i] : 0;
        for (long j = 0; j < s->n; j++)
            s->u[i] += q[j] * s->field[j * s->size + i];
    }
}

static double size_of(long n, const double *x)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sqrt(sum);
}

/* ---- against the elements -------------------------------------------------------------------- */

/* A reduced energy of either form, on s.n fields. */
struct reduced {
    struct quartic open;
    struct quartic_closed closed;
    int is_closed;
};

static double energy_of(const struct reduced *r, const double *q)
{
    return r->is_closed ? quartic_closed_energy(&r->closed, q) : quartic_energy(&r->open, q);
}

static void add_of(const struct reduced *r, const double *q, double *f, double *K)
{
    if (r->is_closed)
        quartic_closed_add(&r->closed, q, f, K);
    else
        quartic_add(&r->open, q, f, K);
}

/* Both sum some thousand products; the tolerance is that of their largest. */
static void compare_forces(const struct subject *s, const struct reduced *reduced)
{
    double *projected = s->reduced + s->n;
    expand(s, s->q);
    check_relative(energy_of(reduced, s->q), assemble_energy(s->model, s->u), 1e-12, "%s: energy",
                   s->what);
    assemble(s->model, s->u, s->f, NULL);
    memset(s->reduced, 0, (size_t)s->n * sizeof *s->reduced);
    memset(s->K, 0, (size_t)(s->n * s->n) * sizeof *s->K);
    add_of(reduced, s->q, s->reduced, s->K);
    for (long i = 0; i < s->n; i++) {
        projected[i] = 0;
        for (long k = 0; k < s->size; k++)
            projected[i] += s->field[i * s->size + k] * s->f[k];
    }
    const double size = size_of(s->n, projected);
    for (long i = 0; i < s->n; i++)
        check_absolute(s->reduced[i], projected[i], 1e-12 * size, "%s: force %ld", s->what, i);
}

/* Force is cubic, and so differences of fourth order are exact. */
static void compare_tangent(const struct subject *s, const struct reduced *reduced)
{
    static const double at[4] = {-2, -1, 1, 2}, weight[4] = {1, -8, 8, -1};
    const double h = 0.5, size = size_of(s->n * s->n, s->K);
    double *moved = s->reduced + s->n;
    for (long j = 0; j < s->n; j++) {
        const double q = s->q[j];
        memset(s->reduced, 0, (size_t)s->n * sizeof *s->reduced);
        for (int k = 0; k < 4; k++) {
            s->q[j] = q + at[k] * h;
            memset(moved, 0, (size_t)s->n * sizeof *moved);
            add_of(reduced, s->q, moved, NULL);
            for (long i = 0; i < s->n; i++)
                s->reduced[i] += weight[k] / (12 * h) * moved[i];
        }
        s->q[j] = q;
        for (long i = 0; i < s->n; i++)
            check_absolute(s->K[i * s->n + j], s->reduced[i], 1e-12 * size, "%s: tangent %ld %ld",
                           s->what, i, j);
    }
}

/* The form in the strains has no negative eigenvalue, but for round-off, scaled to a diagonal of
 * one. */
static void check_definite(const struct subject *s)
{
    struct hobe_error err;
    const long pairs = form_pairs(s->n + 1);
    double *A, *B = numbers(pairs * pairs), *lambda = numbers(pairs);
    if (strain_form(s->model, s->centre, s->n, s->field, &A, &err))
        check_stop("%s: %s", s->what, err.message);
    const long first = s->centre ? 0 : 1; /* no strain at rest */
    for (long p = first; p < pairs; p++)
        for (long r = first; r <= p; r++)
            B[(r - first) * (pairs - first) + p - first] =
                A[p * pairs + r] / sqrt(A[p * pairs + p] * A[r * pairs + r]);
    if (hobe_eigenvalues((int)(pairs - first), B, lambda, &err))
        check_stop("%s: %s", s->what, err.message);
    check_that(lambda[0] > -1e-13 * lambda[pairs - first - 1], "%s: semidefinite, %g of %g",
               s->what, lambda[0], lambda[pairs - first - 1]);
    hobe_free(A);
    hobe_free(B);
    hobe_free(lambda);
}

/* Frees the model. */
static void like_elements(hobe_model *model, long n, int at_rest, const char *what)
{
    struct hobe_error err;
    struct subject s;
    struct reduced reduced = {.is_closed = 0};
    open_subject(&s, model, n, at_rest, what);
    if (quartic_open(&reduced.open, model, s.centre, n, s.field, &err))
        check_stop("%s: %s", what, err.message);
    for (long i = 0; i < n; i++)
        s.q[i] = random_real(-1, 1);
    compare_forces(&s, &reduced);
    compare_tangent(&s, &reduced);
    check_definite(&s);
    quartic_close(&reduced.open);
    close_subject(&s);
    hobe_model_free(model);
}

/* ---- closed under 3 x 3 maps ----------------------------------------------------------------- */

/* Frees the model. */
static void closed_like_elements(hobe_model *model, long functions, const char *what)
{
    struct hobe_error err;
    struct subject s;
    struct reduced reduced = {.is_closed = 1};
    open_subject(&s, model, 3 * functions, 1, what);
    double *function = numbers(functions * model->vectors);
    memset(s.field, 0, (size_t)(s.n * s.size) * sizeof *s.field);
    for (long b = 0; b < functions; b++)
        for (long v = 0; v < model->vectors; v++) {
            const double value = model->unknown[v] >= 0 ? random_real(-1, 1) : 0;
            function[b * model->vectors + v] = value;
            for (long x = 0; x < 3; x++)
                s.field[(3 * b + x) * s.size + 3 * v + x] = value;
        }
    if (quartic_closed_open(&reduced.closed, model, functions, function, &err))
        check_stop("%s: %s", what, err.message);
    for (long i = 0; i < s.n; i++)
        s.q[i] = random_real(-1, 1);
    compare_forces(&s, &reduced);
    compare_tangent(&s, &reduced);
    quartic_closed_close(&reduced.closed);
    hobe_free(function);
    close_subject(&s);
    hobe_model_free(model);
}

/* q = R (e_a + p) - e_a, with the rotation about e_z and then e_x; e_a of the first three. */
static void turn(long functions, const double *p, double *q)
{
    const double a = random_real(1, 5), b = random_real(1, 5);
    for (long i = 0; i < functions; i++) {
        double c[3] = {p[3 * i], p[3 * i + 1], p[3 * i + 2]};
        if (i < 3)
            c[i] += 1;
        const double x = cos(a) * c[0] - sin(a) * c[1], y = sin(a) * c[0] + cos(a) * c[1];
        q[3 * i] = x - (i == 0);
        q[3 * i + 1] = cos(b) * y - sin(b) * c[2] - (i == 1);
        q[3 * i + 2] = sin(b) * y + cos(b) * c[2] - (i == 2);
    }
}

/* A free beam with the three functions of its reference, and two more, turned as a whole. */
static void rotations(const hobe_section *section, hobe_curve *curve)
{
    enum { FUNCTIONS = 5 };
    struct hobe_error err;
    struct quartic_closed closed;
    double p[3 * FUNCTIONS] = {0}, q[3 * FUNCTIONS];
    struct hobe_beam beam = beam_along_x("MGD30w", 4, section, E, NU, 0);
    beam.curve = curve;
    hobe_model *model = new_model();
    add_beam(model, &beam);
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    const long vectors = model->vectors;
    double *x0 = field_on(model), *function = numbers(FUNCTIONS * vectors);
    model_reference(model, x0);
    for (long v = 0; v < vectors; v++)
        for (long b = 0; b < FUNCTIONS; b++)
            function[b * vectors + v] = b < 3 ? x0[3 * v + b] : random_real(-1, 1);
    if (quartic_closed_open(&closed, model, FUNCTIONS, function, &err))
        check_stop("%s", err.message);
    turn(FUNCTIONS, p, q);
    const double turned = quartic_closed_energy(&closed, q);
    for (int i = 0; i < 3 * FUNCTIONS; i++)
        p[i] = random_real(-0.3, 0.3);
    turn(FUNCTIONS, p, q);
    const double size = quartic_closed_energy(&closed, p);
    check_absolute(turned, 0, 1e-14 * size, "a rotation has no energy");
    check_relative(quartic_closed_energy(&closed, q), size, 1e-12, "a rotation adds none");
    quartic_closed_close(&closed);
    hobe_free(function);
    hobe_free(x0);
    hobe_model_free(model);
}

/* ---- round-off ------------------------------------------------------------------------------- */

/* A cantilever of length 1 and height h with a force across its end that turns it far, at load 2.
 */
static hobe_model *whip(const hobe_section *section, double h, double load)
{
    const struct hobe_beam beam = beam_along_x("MGD30w", 8, section, E, NU, 1);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 0, load * E * h * h * h * h / 12);
    return model;
}

/* Three equilibria of a slender beam as fields, in the second of them: the tensor sums products
 * with EA whose differences are of EI, and so loses EA L^2/EI of the 1e16 that kernels keep. */
static void slender(void)
{
    const double h = 1e-3, lost = 12 / (h * h);
    struct hobe_error err;
    struct subject s;
    struct quartic quartic;
    hobe_section *section = rectangle(h, h);
    hobe_model *model = whip(section, h, 2);
    open_subject(&s, model, 3, 1, "slender");
    for (int i = 0; i < 3; i++) {
        hobe_model *loaded = whip(section, h, 1 + i);
        hobe_solution *solution = solve(loaded, 4);
        memcpy(s.field + i * s.size, solution->u, (size_t)s.size * sizeof *s.field);
        hobe_solution_free(solution);
        hobe_model_free(loaded);
    }
    if (quartic_open(&quartic, model, NULL, 3, s.field, &err))
        check_stop("%s: %s", s.what, err.message);
    s.q[1] = 1;
    expand(&s, s.q);
    const double energy = assemble_energy(model, s.u), reduced = quartic_energy(&quartic, s.q);
    check_relative(reduced, energy, 1e-15 * lost, "slender: energy");
    quartic_add(&quartic, s.q, s.reduced, NULL);
    double work = 0;
    assemble(model, s.u, s.f, NULL);
    for (long k = 0; k < s.size; k++)
        work += s.f[k] * s.field[s.size + k];
    check_relative(s.reduced[1], work, 1e-15 * lost, "slender: force");
    quartic_close(&quartic);
    close_subject(&s);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- all of them ----------------------------------------------------------------------------- */

static void scenes(void)
{
    hobe_section *square = rectangle(0.1, 0.1), *I = i_section();
    hobe_section *taper = tapered(rectangle(0.1, 0.2), rectangle(0.05, 0.1));
    hobe_curve *curve = curve_of(arc, NULL, NULL);
    like_elements(straight("MGD30w", 3, square), 5, 1, "square");
    like_elements(straight("MGD30w", 1, square), 1, 1, "one field");
    like_elements(straight("MGD30d", 2, I), 4, 0, "I-section that distorts");
    like_elements(straight("MGD30w", 3, taper), 4, 0, "taper");
    like_elements(curved(square, curve), 3, 0, "curve");
    like_elements(corner(square), 6, 0, "two beams");
    closed_like_elements(straight("MGD30w", 3, square), 3, "closed");
    closed_like_elements(straight("MGD30d", 2, I), 1, "closed, one function");
    closed_like_elements(curved(square, curve), 2, "closed, curve");
    rotations(square, curve);
    hobe_curve_free(curve);
    hobe_section_free(taper);
    hobe_section_free(I);
    hobe_section_free(square);
}

static void refused(void)
{
    struct hobe_error err;
    struct subject s;
    struct quartic quartic;
    hobe_section *square = rectangle(0.1, 0.1);
    hobe_model *model = straight("3333s", 2, square);
    open_subject(&s, model, 2, 1, "structural");
    check_that(quartic_open(&quartic, model, NULL, 2, s.field, &err) == HOBE_BAD_INPUT &&
                   strstr(err.message, "polynomial"),
               "no polynomial: %s", err.message);
    close_subject(&s);
    hobe_model_free(model);
    hobe_section_free(square);
}

int main(void)
{
    random_start();
    scenes();
    slender();
    refused();
    return check_report();
}
