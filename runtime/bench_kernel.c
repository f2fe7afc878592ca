/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Kernels against the machine's peak and the baselines: one batch of eight elements, whose numbers
 * stay in the caches. */
#include "bench.h"

#include "bench_subject.h"
#include "material.h"

#include <math.h>

/* A baseline that differs by more has lost the element it is to stand for.  As printed, eq. 28 sums
 * products of positions, which cancel to those of strains: that takes a digit. */
static const double AGREE = 1e-12, PRINTED_AGREE = 1e-11;

/* ---- baselines ------------------------------------------------------------------------------ */

/* The baselines of an element, on a rectangle, with the kernel on the same law beside them. */
struct rivals {
    hobe_section *rectangle;
    struct bench_section section;
    struct bench_subject same;
    struct points points;         /* vectors = 0: there are none */
    struct bench_tensors tensors; /* vectors = 0: there are none */
};

static void close_rivals(struct rivals *r)
{
    bench_tensors_close(&r->tensors);
    points_close(&r->points);
    bench_subject_close(&r->same);
    hobe_section_free(r->rectangle);
}

static enum hobe_status open_rivals(struct rivals *r, const struct hobe_kernel *kernel,
                                    struct hobe_error *err)
{
    *r = (struct rivals){.rectangle = bench_classes[0].make(err)};
    if (!r->rectangle)
        return err->status;
    if (hobe_mechanics_find(kernel->mechanics) == HOBE_MECHANICS_STRUCTURAL)
        return HOBE_OK;
    bench_section_open(&r->section, r->rectangle);
    enum hobe_status status = bench_subject_full(&r->same, kernel, &r->section.base, err);
    if (!status)
        status = bench_points_open(&r->points, r->same.element, &r->section.base, err);
    if (!status && kernel->vectors <= BENCH_TENSOR_VECTORS)
        status = bench_tensors_open(&r->tensors, &r->points, err);
    return status;
}

/* The largest entry of x[n], of x - y where y is given. */
static double largest(const hobe_lanes *x, const hobe_lanes *y, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++)
        for (int lane = 0; lane < HOBE_LANES; lane++)
            most = fmax(most, fabs(x[i][lane] - (y ? y[i][lane] : 0)));
    return most;
}

static double differ(const struct bench_subject *s, const hobe_lanes *f, const hobe_lanes *K)
{
    const int dofs = 3 * s->kernel->vectors, entries = dofs * (dofs + 3) / 2;
    return fmax(largest(s->f, f, dofs) / largest(s->f, NULL, dofs),
                largest(s->K, K, entries) / largest(s->K, NULL, entries));
}

static enum hobe_status compare(const struct rivals *r, struct bench_difference *difference,
                                struct hobe_error *err)
{
    const struct bench_subject *s = &r->same;
    *difference = (struct bench_difference){0, 0};
    if (!r->points.vectors)
        return HOBE_OK;
    const size_t dofs = 3 * (size_t)s->kernel->vectors;
    hobe_lanes *f = hobe_alloc(dofs + dofs * (dofs + 3) / 2, sizeof *f, err), *K = f + dofs;
    if (!f)
        return HOBE_NO_MEMORY;
    for (int i = 0; i < s->plans; i++) {
        s->kernel->tangent(&s->plan[i].inv, s->q0, s->u, s->f, s->K, s->scratch);
        points_evaluate()(&r->points, NULL, s->q, f, K, s->scratch);
        difference->points = fmax(difference->points, differ(s, f, K));
        if (!r->tensors.vectors)
            continue;
        bench_machine()->printed(&r->tensors, s->q, f, K);
        difference->printed = fmax(difference->printed, differ(s, f, K));
    }
    hobe_free(f);
    return HOBE_OK;
}

enum hobe_status bench_compare(const struct hobe_kernel *kernel,
                               struct bench_difference *difference, struct hobe_error *err)
{
    struct rivals rivals;
    enum hobe_status status = open_rivals(&rivals, kernel, err);
    if (!status)
        status = compare(&rivals, difference, err);
    close_rivals(&rivals);
    return status;
}

static enum hobe_status check_rivals(const struct rivals *r, struct hobe_error *err)
{
    struct bench_difference difference;
    const enum hobe_status status = compare(r, &difference, err);
    if (status || (difference.points <= AGREE && difference.printed <= PRINTED_AGREE))
        return status;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "element %s differs from the benchmark's baselines points and eq. 28 by %.2g "
                     "and %.2g of its largest force or stiffness, more than %g and %g: one of them "
                     "is wrong",
                     r->same.kernel->name, difference.points, difference.printed, AGREE,
                     PRINTED_AGREE);
}

/* ---- a race --------------------------------------------------------------------------------- */

/* One who runs: the peak, a kernel by one of its plans, or a baseline. */
struct entrant {
    const char *kind, *plan;
    int taken;                           /* the plan is hobe's choice */
    int tangent;                         /* force and tangent, or force alone */
    double flops;                        /* of a call; 0: not known */
    hobe_lanes *turn;                    /* of the peak */
    const struct bench_subject *subject; /* of a kernel, */
    const struct hobe_invariants *inv;   /* and those it is called with */
    const struct rivals *rivals;         /* of a baseline */
};

static void run_peak(void *context)
{
    const struct entrant *e = context;
    bench_machine()->turn(e->turn);
}

static void run_kernel(void *context)
{
    const struct entrant *e = context;
    const struct bench_subject *s = e->subject;
    if (e->tangent)
        s->kernel->tangent(e->inv, s->q0, s->u, s->f, s->K, s->scratch);
    else
        s->kernel->force(e->inv, s->q0, s->u, s->f, s->scratch);
}

static void run_points(void *context)
{
    const struct entrant *e = context;
    const struct bench_subject *s = &e->rivals->same;
    points_evaluate()(&e->rivals->points, NULL, s->q, s->f, e->tangent ? s->K : NULL, s->scratch);
}

static void run_printed(void *context)
{
    const struct entrant *e = context;
    const struct bench_subject *s = &e->rivals->same;
    bench_machine()->printed(&e->rivals->tensors, s->q, s->f, e->tangent ? s->K : NULL);
}

enum { MOST_ENTRANTS = 1 + 2 * (BENCH_PLANS + 2) };

struct race {
    const char *class;
    const struct bench_subject *subject;
    hobe_lanes turn[BENCH_TURN_CHAINS];
    int entrants, points[2], printed[2]; /* places of the baselines by `tangent`; 0: none */
    struct entrant entrant[MOST_ENTRANTS];
    struct bench_work work[MOST_ENTRANTS];
};

/* Enters one; its place. */
static int enter(struct race *race, void (*run)(void *context), const struct entrant *entrant)
{
    const int i = race->entrants++;
    race->entrant[i] = *entrant;
    race->work[i] = (struct bench_work){.run = run, .context = race->entrant + i};
    return i;
}

static void enter_plans(struct race *race, int tangent)
{
    const struct bench_subject *s = race->subject;
    for (int i = 0; i < s->plans; i++)
        enter(race, run_kernel,
              &(struct entrant){.kind = "kernel",
                                .plan = s->plan[i].name,
                                .taken = s->plan[i].taken[tangent],
                                .tangent = tangent,
                                .flops = HOBE_LANES * s->plan[i].flops[tangent],
                                .subject = s,
                                .inv = &s->plan[i].inv});
}

static void enter_baselines(struct race *race, const struct rivals *rivals, int tangent)
{
    struct entrant e = {.kind = "baseline", .tangent = tangent, .rivals = rivals};
    if (rivals->points.vectors) {
        e.plan = "points";
        e.flops = HOBE_LANES * points_flops(rivals->points.vectors,
                                            points_of_rectangle(race->subject->kernel), tangent);
        race->points[tangent] = enter(race, run_points, &e);
    }
    if (rivals->tensors.vectors) {
        e.plan = "eq. 28";
        e.flops = HOBE_LANES * bench_printed_flops(&rivals->tensors, tangent);
        race->printed[tangent] = enter(race, run_printed, &e);
    }
}

static void line_up(struct race *race, const char *class, const struct bench_subject *s,
                    const struct rivals *rivals)
{
    *race = (struct race){.class = class, .subject = s};
    enter(race, run_peak,
          &(struct entrant){.kind = "machine",
                            .flops =
                                2.0 * BENCH_TURN_CHAINS * BENCH_TURN_STEPS * bench_machine()->width,
                            .turn = race->turn});
    for (int tangent = 0; tangent < 2; tangent++) {
        enter_plans(race, tangent);
        enter_baselines(race, rivals, tangent);
    }
}

/* How many times as long the baseline at `place` takes for an element. */
static double against(const struct race *race, int place, int i, int elements)
{
    return place ? bench_ratio(race->work + place, race->work + i) / HOBE_LANES * elements : 0;
}

static enum hobe_status report(const struct race *race, int i, struct bench_rows *rows,
                               struct hobe_error *err)
{
    const struct entrant *e = race->entrant + i;
    struct bench_row *row = bench_add(rows, err);
    if (!row)
        return HOBE_NO_MEMORY;
    *row = (struct bench_row){.kind = e->kind,
                              .element = race->subject->kernel->name,
                              .plan = e->plan,
                              .taken = e->taken,
                              .time = bench_time(race->work + i),
                              .flops = e->flops};
    if (!e->plan)
        return HOBE_OK; /* the peak */
    row->section = race->class;
    row->dofs = 3 * race->subject->kernel->vectors;
    row->task = e->tangent ? "force, tangent" : "force";
    row->elements = e->inv ? race->subject->count : HOBE_LANES;
    row->points = against(race, race->points[e->tangent], i, (int)row->elements);
    row->printed = against(race, race->printed[e->tangent], i, (int)row->elements);
    row->peak = e->flops / race->entrant[0].flops * bench_ratio(race->work, race->work + i);
    return HOBE_OK;
}

/* The baselines are those of the rectangle whatever the class, and are reported with it. */
static enum hobe_status race_class(const struct bench_options *options, int c,
                                   const struct hobe_kernel *kernel, const struct rivals *rivals,
                                   struct bench_rows *rows, struct hobe_error *err)
{
    struct bench_subject subject;
    struct race race;
    enum hobe_status status = bench_subject_open(&subject, kernel, bench_classes + c, err);
    if (!status) {
        line_up(&race, bench_classes[c].name, &subject, rivals);
        status = bench_race(race.work, race.entrants, options->seconds, err);
        for (int i = 0; !status && i < race.entrants; i++)
            if (c == 0 || race.entrant[i].inv)
                status = report(&race, i, rows, err);
        bench_free_samples(race.work, race.entrants);
    }
    bench_subject_close(&subject);
    return status;
}

enum hobe_status bench_kernels(const struct bench_options *options, struct bench_rows *rows,
                               struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < options->kernels; i++) {
        struct rivals rivals;
        const struct hobe_kernel *kernel = options->kernel[i];
        options->progress("kernel of", kernel->name);
        status = open_rivals(&rivals, kernel, err);
        if (!status)
            status = check_rivals(&rivals, err);
        for (int c = 0; !status && c < BENCH_CLASSES; c++)
            status = race_class(options, c, kernel, &rivals, rows, err);
        close_rivals(&rivals);
    }
    return status;
}
