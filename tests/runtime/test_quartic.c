/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a model on a few fields is that of its elements, with its derivatives: prismatic,
 * tapered and curved beams, beams that share vectors, at rest and about other states.  Looks into
 * the core (quartic.h). */
#include "quartic.h"

#include "assemble.h"
#include "check.h"
#include "scene.h"
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

/* Both sum some thousand products; the tolerance is that of their largest. */
static void compare_forces(const struct subject *s, const struct quartic *quartic)
{
    double *projected = s->reduced + s->n;
    expand(s, s->q);
    check_relative(quartic_energy(quartic, s->q), assemble_energy(s->model, s->u), 1e-12,
                   "%s: energy", s->what);
    assemble(s->model, s->u, s->f, NULL);
    memset(s->reduced, 0, (size_t)s->n * sizeof *s->reduced);
    memset(s->K, 0, (size_t)(s->n * s->n) * sizeof *s->K);
    quartic_add(quartic, s->q, s->reduced, s->K);
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
static void compare_tangent(const struct subject *s, const struct quartic *quartic)
{
    static const double at[4] = {-2, -1, 1, 2}, weight[4] = {1, -8, 8, -1};
    const double h = 0.5, size = size_of(s->n * s->n, s->K);
    for (long j = 0; j < s->n; j++) {
        memset(s->reduced, 0, (size_t)s->n * sizeof *s->reduced);
        const double q = s->q[j];
        double *moved = s->reduced + s->n;
        for (int k = 0; k < 4; k++) {
            s->q[j] = q + at[k] * h;
            memset(moved, 0, (size_t)s->n * sizeof *moved);
            quartic_add(quartic, s->q, moved, NULL);
            for (long i = 0; i < s->n; i++)
                s->reduced[i] += weight[k] / (12 * h) * moved[i];
        }
        s->q[j] = q;
        for (long i = 0; i < s->n; i++)
            check_absolute(s->K[i * s->n + j], s->reduced[i], 1e-12 * size, "%s: tangent %ld %ld",
                           s->what, i, j);
    }
}

/* Frees the model. */
static void like_elements(hobe_model *model, long n, int at_rest, const char *what)
{
    struct hobe_error err;
    struct subject s;
    struct quartic quartic;
    open_subject(&s, model, n, at_rest, what);
    if (quartic_open(&quartic, model, s.centre, n, s.field, &err))
        check_stop("%s: %s", what, err.message);
    for (long i = 0; i < n; i++)
        s.q[i] = random_real(-1, 1);
    compare_forces(&s, &quartic);
    compare_tangent(&s, &quartic);
    quartic_close(&quartic);
    close_subject(&s);
    hobe_model_free(model);
}

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
    refused();
    return check_report();
}
