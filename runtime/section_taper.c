/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "section_taper.h"

#include "chebyshev.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

/* Of the numbers and values along the beam, relative; what their series then lose is the square. */
static const double TOLERANCE = 1e-10, FIELD_TOLERANCE = 1e-6;

/* The largest relative change of a number in a difference that gives d/dx of the section functions:
 * its error is (2e-4)^4, that of rounding 1e-16/2e-4.  It must be so small that no point of a rule
 * falls out of the smaller section. */
static const double STEP = 2e-4;

struct taper {
    struct hobe_section base;
    hobe_section *like; /* owned; its kind is the taper's, its numbers are those at 0 */
    struct hobe_chebyshev numbers;
    void *field; /* of a kind whose functions are solved, with its values along the beam */
    struct hobe_chebyshev values;
    struct memory *memory; /* of the field at the place last asked for */
};

/* Results are asked for point by point of one place after the other. */
struct memory {
    pthread_mutex_t lock;
    double at;
    void *here;
};

static const struct taper *as_taper(const hobe_section *section)
{
    return (const struct taper *)section;
}

/* ---- sections at a place -------------------------------------------------------------------- */

/* Values at a fraction of the length and their derivatives by it: n[2][count], of hobe_alloc. */
static double *series_at(const struct hobe_chebyshev *series, double at, struct hobe_error *err)
{
    double *n = hobe_alloc(2 * (size_t)series->values, sizeof *n, err);
    if (n)
        hobe_chebyshev_at(series, at, 1, n);
    return n;
}

static const struct hobe_section_field *field_of(const struct taper *t)
{
    return t->like->kind->sizes->field;
}

static hobe_section *make_section(const struct taper *t, const double *n, int bare,
                                  struct hobe_error *err)
{
    return t->like->kind->sizes->make(t->like, n, bare, err);
}

static hobe_section *section_at(const hobe_section *section, double at, int bare,
                                struct hobe_error *err)
{
    const struct taper *t = as_taper(section);
    double *n = series_at(&t->numbers, at, err);
    hobe_section *here = n ? make_section(t, n, bare, err) : NULL;
    hobe_free(n);
    return here;
}

hobe_section *hobe_section_at(const hobe_section *section, double at, struct hobe_error *err)
{
    if (!hobe_section_varies(section)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "this section is the same all along: %s",
                  section->text);
        return NULL;
    }
    return section_at(section, at, 0, err);
}

/* Sections at a place and around it, for their functions: step[k] has the numbers n + k h n', k =
 * -2, -1, 1, 2; only the first where nothing changes. */
enum { NEIGHBOURS = 4 };

struct around {
    hobe_section *here, *step[NEIGHBOURS];
    double h; /* fraction of the beam's length */
};

static const double offset[NEIGHBOURS] = {-2, -1, 1, 2};

static void free_around(struct around *a)
{
    hobe_section_free(a->here);
    for (int k = 0; k < NEIGHBOURS; k++)
        hobe_section_free(a->step[k]);
}

/* h such that no number changes by more than STEP over 2 h; 0 where none changes. */
static double step_of(int count, const double *n)
{
    double rate = 0, size = 0;
    for (int i = 0; i < count; i++)
        size = fmax(size, fabs(n[i]));
    for (int i = 0; i < count; i++)
        rate = fmax(rate, fabs(n[count + i]) / fmax(fabs(n[i]), 1e-3 * size));
    return rate > 1e-9 ? STEP / (2 * rate) : 0;
}

static enum hobe_status look_around(const struct taper *t, double at, int bare, struct around *a,
                                    struct hobe_error *err)
{
    const int count = t->numbers.values;
    *a = (struct around){0};
    double *n = series_at(&t->numbers, at, err);
    if (!n)
        return HOBE_NO_MEMORY;
    a->here = make_section(t, n, bare, err);
    a->h = step_of(count, n);
    int failed = !a->here;
    for (int k = 0; !failed && a->h > 0 && k < NEIGHBOURS; k++) {
        for (int i = 0; i < count; i++)
            n[i] += (offset[k] - (k ? offset[k - 1] : 0)) * a->h * n[count + i];
        a->step[k] = make_section(t, n, 1, err);
        failed = !a->step[k];
    }
    hobe_free(n);
    if (failed)
        free_around(a);
    return !failed ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
}

/* d f/dx at (y, z) into f[..][3], by a difference of fourth order. */
static void add_rates(const struct around *a, double length, int paper, double y, double z,
                      double (*f)[4])
{
    static const double weight[NEIGHBOURS] = {1. / 12, -8. / 12, 8. / 12, -1. / 12};
    for (int k = 0; a->h > 0 && k < NEIGHBOURS; k++) {
        double g[HOBE_MAX_FUNCTIONS][4] = {{0}};
        a->step[k]->kind->functions(a->step[k], paper, y, z, g);
        for (int i = 0; i < HOBE_SECTION_FUNCTIONS; i++)
            f[i][3] += weight[k] * g[i][0] / (a->h * length);
    }
}

/* ---- the kind ------------------------------------------------------------------------------- */

static const struct hobe_section_place *or_start(const struct hobe_section_place *place)
{
    static const struct hobe_section_place start = {0, 1};
    return place ? place : &start;
}

/* The field at a place, with the memory locked; NULL, unlocked, on failure. */
static const void *lock_field(const struct taper *t, double at, struct hobe_error *err)
{
    struct memory *m = t->memory;
    pthread_mutex_lock(&m->lock);
    if (m->here && m->at == at)
        return m->here;
    double *values = series_at(&t->values, at, err);
    void *here = values ? field_of(t)->open_at(t->field, values, err) : NULL;
    hobe_free(values);
    if (here) {
        if (m->here)
            field_of(t)->close_at(m->here);
        m->here = here;
        m->at = at;
    } else
        pthread_mutex_unlock(&m->lock);
    return here;
}

static void unlock_field(const struct taper *t)
{
    pthread_mutex_unlock(&t->memory->lock);
}

static enum hobe_status solved_rule(const struct taper *t, const struct hobe_section_place *place,
                                    struct hobe_rule *rule, struct hobe_error *err)
{
    const void *here = lock_field(t, place->at, err);
    if (!here)
        return HOBE_NO_MEMORY;
    const enum hobe_status status = field_of(t)->rule(here, rule, err);
    unlock_field(t);
    for (int p = 0; !status && p < rule->rule.points; p++)
        for (int i = 0; i < HOBE_SECTION_FUNCTIONS; i++)
            rule->point[p].f[i][3] /= place->length;
    return status;
}

static enum hobe_status rule_at(const hobe_section *section, const struct hobe_kernel *kernel,
                                enum hobe_integration integration,
                                const struct hobe_section_place *place, struct hobe_rule *rule,
                                struct hobe_error *err)
{
    const struct taper *t = as_taper(section);
    const int paper = integration == HOBE_INTEGRATION_PAPER, solved = field_of(t) != NULL;
    struct around a;
    place = or_start(place);
    if (solved && kernel->functions && !paper)
        return solved_rule(t, place, rule, err);
    enum hobe_status status = look_around(t, place->at, solved, &a, err);
    if (status)
        return status;
    status = a.here->kind->rule(a.here, kernel, integration, rule, err);
    for (int p = 0; !status && kernel->functions && p < rule->rule.points; p++) {
        struct hobe_section_point *at = rule->point + p;
        add_rates(&a, place->length, paper, at->y, at->z, at->f);
    }
    free_around(&a);
    return status;
}

static enum hobe_status solved_functions(const struct taper *t,
                                         const struct hobe_section_place *place, double y, double z,
                                         double (*f)[4], struct hobe_error *err)
{
    const void *here = lock_field(t, place->at, err);
    if (!here)
        return HOBE_NO_MEMORY;
    field_of(t)->functions(here, y, z, f);
    unlock_field(t);
    for (int i = 0; i < HOBE_SECTION_FUNCTIONS; i++)
        f[i][3] /= place->length;
    return HOBE_OK;
}

static enum hobe_status functions_at(const hobe_section *section, int paper,
                                     const struct hobe_section_place *place, double y, double z,
                                     double (*f)[4], struct hobe_error *err)
{
    struct around a;
    place = or_start(place);
    if (field_of(as_taper(section)))
        return solved_functions(as_taper(section), place, y, z, f, err);
    const enum hobe_status status = look_around(as_taper(section), place->at, 1, &a, err);
    if (status)
        return status;
    a.here->kind->functions(a.here, paper, y, z, f);
    add_rates(&a, place->length, paper, y, z, f);
    free_around(&a);
    return HOBE_OK;
}

static enum hobe_status shape_at(const hobe_section *section, double at, double *area,
                                 double (*probe)[2], struct hobe_error *err)
{
    hobe_section *here = section_at(section, at, 1, err);
    if (!here)
        return err ? err->status : HOBE_NO_MEMORY;
    *area = here->properties.A;
    if (probe)
        memcpy(probe, here->probe, sizeof here->probe);
    hobe_section_free(here);
    return HOBE_OK;
}

static enum hobe_status properties_at(const hobe_section *section, double at,
                                      struct hobe_section_properties *p, struct hobe_error *err)
{
    hobe_section *here = section_at(section, at, 0, err);
    if (!here)
        return err ? err->status : HOBE_NO_MEMORY;
    *p = here->properties;
    hobe_section_free(here);
    return HOBE_OK;
}

static enum hobe_status surface_at(const hobe_section *section, double at, int fineness,
                                   struct hobe_surface *surface, struct hobe_error *err)
{
    const struct taper *t = as_taper(section);
    const struct hobe_section_field *field = field_of(t);
    if (field) {
        const void *solved = lock_field(t, at, err);
        if (!solved)
            return HOBE_NO_MEMORY;
        const enum hobe_status status = field->surface(solved, surface, err);
        unlock_field(t);
        return status;
    }
    hobe_section *here = section_at(section, at, 1, err);
    const enum hobe_status status = here  ? hobe_section_surface(here, fineness, surface, err)
                                    : err ? err->status
                                          : HOBE_NO_MEMORY;
    if (here)
        hobe_section_free(here);
    return status;
}

/* Those of closed forms are zero; solved ones do not follow an outline along the beam. */
static enum hobe_status distort(const hobe_section *section, double *wall_bending,
                                struct hobe_error *err)
{
    *wall_bending = 0;
    if (!field_of(as_taper(section)))
        return HOBE_OK;
    return hobe_fail(
        err, HOBE_UNKNOWN, NULL,
        "an outline that varies along the beam has the functions w, wy and wz only, and "
        "does not know how its walls bend");
}

static void close_taper(hobe_section *section)
{
    struct taper *t = (struct taper *)section;
    if (t->memory) {
        if (t->memory->here)
            field_of(t)->close_at(t->memory->here);
        pthread_mutex_destroy(&t->memory->lock);
        hobe_free(t->memory);
    }
    if (t->field)
        field_of(t)->close(t->field);
    hobe_section_free(t->like);
    hobe_chebyshev_free(&t->numbers);
    hobe_chebyshev_free(&t->values);
}

static const struct hobe_section_kind taper_kind = {
    .close = close_taper,
    .distort = distort,
    .rule_at = rule_at,
    .functions_at = functions_at,
    .surface_at = surface_at,
    .shape_at = shape_at,
    .properties_at = properties_at,
};

/* ---- making one ----------------------------------------------------------------------------- */

struct maker {
    const hobe_section *like;
    hobe_section_maker *make;
    void *context;
};

/* The numbers of the section that the caller has at t. */
static enum hobe_status sample(void *context, double t, double *numbers, struct hobe_error *err)
{
    const struct maker *m = context;
    const hobe_section *section = NULL;
    const enum hobe_status status = m->make(m->context, t, &section, err);
    if (status) {
        char place[40];
        snprintf(place, sizeof place, "at %.3g of the beam", t);
        hobe_fail_in(err, place);
        return status;
    }
    if (section->kind != m->like->kind ||
        section->kind->sizes->count(section) != m->like->kind->sizes->count(m->like))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the section changes its kind along the beam: \"%s\" at 0, \"%s\" at %g; "
                         "it must stay the same but for its sizes",
                         m->like->text, section->text, t);
    section->kind->sizes->read(section, numbers);
    return HOBE_OK;
}

/* A copy of the section at 0, to make the others from. */
static enum hobe_status set_like(struct taper *t, hobe_section_maker *make, void *context,
                                 struct hobe_error *err)
{
    const hobe_section *start = NULL;
    const enum hobe_status status = make(context, 0, &start, err);
    if (status)
        return status;
    const struct hobe_section_sizes *sizes = start->kind->sizes;
    if (!sizes || !sizes->count(start))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "a taper cannot be made of this section: %s",
                         start->text);
    double *n = hobe_alloc((size_t)sizes->count(start), sizeof *n, err);
    if (!n)
        return HOBE_NO_MEMORY;
    sizes->read(start, n);
    t->like = sizes->make(start, n, 0, err);
    hobe_free(n);
    return t->like ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
}

/* The field's values at t. */
static enum hobe_status solve_at(void *context, double at, double *values, struct hobe_error *err)
{
    const struct taper *t = context;
    double *n = series_at(&t->numbers, at, err);
    const enum hobe_status status =
        n ? field_of(t)->solve(t->field, n, values, err) : HOBE_NO_MEMORY;
    hobe_free(n);
    return status;
}

static enum hobe_status set_field(struct taper *t, struct hobe_error *err)
{
    int values;
    if (!field_of(t))
        return HOBE_OK;
    t->field = field_of(t)->open(t->like, &values, err);
    t->memory = t->field ? hobe_alloc(1, sizeof *t->memory, err) : NULL;
    if (!t->memory)
        return err ? err->status : HOBE_NO_MEMORY;
    pthread_mutex_init(&t->memory->lock, NULL);
    return hobe_chebyshev_fit(&t->values, values, solve_at, t, FIELD_TOLERANCE, "the section", err);
}

static enum hobe_status fill(struct taper *t, hobe_section_maker *make, void *context,
                             struct hobe_error *err)
{
    enum hobe_status status = set_like(t, make, context, err);
    if (status)
        return status;
    struct maker maker = {t->like, make, context};
    t->base.properties = t->like->properties;
    t->base.probes = t->like->probes;
    memcpy(t->base.probe, t->like->probe, sizeof t->base.probe);
    snprintf(t->base.text, sizeof t->base.text, "varies along the beam; at 0: %.120s",
             t->like->text);
    status = hobe_chebyshev_fit(&t->numbers, t->like->kind->sizes->count(t->like), sample, &maker,
                                TOLERANCE, "the section", err);
    return status ? status : set_field(t, err);
}

hobe_section *hobe_section_taper(hobe_section_maker *make, void *context, struct hobe_error *err)
{
    struct taper *t = hobe_alloc(1, sizeof *t, err);
    if (!t)
        return NULL;
    t->base.kind = &taper_kind;
    if (fill(t, make, context, err)) {
        hobe_section_free(&t->base);
        return NULL;
    }
    return &t->base;
}

/* ---- between two ends ----------------------------------------------------------------------- */

struct ends {
    const hobe_section *end[2];
    hobe_section *made; /* the last one between them */
};

static enum hobe_status between(void *context, double t, const hobe_section **section,
                                struct hobe_error *err)
{
    struct ends *ends = context;
    const struct hobe_section_sizes *sizes = ends->end[0]->kind->sizes;
    const int count = sizes->count(ends->end[0]);
    double *n = hobe_alloc(2 * (size_t)count, sizeof *n, err);
    if (!n)
        return HOBE_NO_MEMORY;
    for (int e = 0; e < 2; e++)
        sizes->read(ends->end[e], n + e * count);
    for (int i = 0; i < count; i++)
        n[i] += t * (n[count + i] - n[i]);
    hobe_section_free(ends->made);
    *section = ends->made = sizes->make(ends->end[0], n, 1, err);
    hobe_free(n);
    return ends->made ? HOBE_OK : err ? err->status : HOBE_NO_MEMORY;
}

hobe_section *hobe_section_linear(const hobe_section *from, const hobe_section *to,
                                  struct hobe_error *err)
{
    struct ends ends = {{from, to}, NULL};
    for (int e = 0; e < 2; e++)
        if (!ends.end[e]->kind->sizes || !ends.end[e]->kind->sizes->count(ends.end[e])) {
            hobe_fail(err, HOBE_BAD_INPUT, NULL, "a taper cannot be made of this section: %s",
                      ends.end[e]->text);
            return NULL;
        }
    if (from->kind != to->kind || from->kind->sizes->count(from) != to->kind->sizes->count(to)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "a taper needs two sections that differ in sizes only, got \"%s\" and \"%s\"",
                  from->text, to->text);
        return NULL;
    }
    hobe_section *made = hobe_section_taper(between, &ends, err);
    hobe_section_free(ends.made);
    return made;
}
