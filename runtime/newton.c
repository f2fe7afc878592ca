/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Static equilibrium: load steps, Newton's iteration with a consistent tangent, line search when
 * the plain iteration fails, and cut-back of the step when that fails too. */
#include "newton.h"

#include "assemble.h"
#include "component_modes.h"
#include "constraint.h"
#include "damping.h"
#include "inertia.h"
#include "load.h"
#include "mass.h"
#include "pattern.h"
#include "reduction.h"
#include "snapshot_modes.h"
#include "solution.h"
#include "spring.h"
#include "trust.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    DEFAULT_ITERATIONS = 30,
    EASY_ITERATIONS = 8, /* a step that needs no more lets the next one grow */
    MOST_SERIES = 10000, /* to the full load */
    LINE_SEARCH_CUTS = 12
};

static const double DEFAULT_TOLERANCE = 1e-9, DEFAULT_SMALLEST_STEP = 1e-4;

/* A residual this much above the load's is hopeless: the iteration has left. */
static const double DIVERGED = 1e12;

/* The residual moves by |D K eps u| when u is rounded.  An iteration that stalls within a few times
 * that has won every digit there is. */
static const double ROUND_OFF = 8 * DBL_EPSILON;

/* Below this share of the first residual of a step, its square adds no stress worth a thought. */
static const double NEAR = 0.1;

/* Displacements that one more correction changes by more than this share are none. */
static const double LOST = 0.01;

void solver_log(struct solver *s, const char *note)
{
    s->now.note = note;
    if (s->options.log)
        s->options.log(s->options.context, &s->now);
}

void solver_restrict(const hobe_model *model, const double *field, double *x)
{
    for (long v = 0; v < model->vectors; v++)
        if (model->unknown[v] >= 0)
            for (int a = 0; a < 3; a++)
                x[3 * model->unknown[v] + a] = field[3 * v + a];
}

void solver_move(struct solver *s, const double *x, double factor)
{
    const hobe_model *model = s->model;
    for (long v = 0; v < model->vectors; v++)
        if (model->unknown[v] >= 0)
            for (int a = 0; a < 3; a++)
                s->u[3 * v + a] += factor * x[3 * model->unknown[v] + a];
}

/* |D^p field| over all unknowns. */
static double whole_norm(const struct solver *s, const double *field, int p)
{
    const hobe_model *model = s->model;
    double sum[3] = {0}; /* three chains, which do not wait for each other */
    for (long v = 0; v < model->vectors; v++)
        if (model->unknown[v] >= 0)
            for (int a = 0; a < 3; a++) {
                const double D = s->scale[3 * model->unknown[v] + a];
                const double x = p > 0 ? D * field[3 * v + a] : field[3 * v + a] / D;
                sum[a] += x * x;
            }
    return sqrt(sum[0] + sum[1] + sum[2]);
}

double solver_norm(const struct solver *s, const double *field, int p)
{
    return s->space.count > 0 && p > 0 ? subspace_norm(&s->space, field) : whole_norm(s, field, p);
}

/* |D^-1 du| of the correction. */
static double correction_norm(const struct solver *s)
{
    double sum = 0;
    for (long i = 0; i < 3 * s->model->unknowns; i++)
        sum += s->x[i] * s->x[i] / (s->scale[i] * s->scale[i]);
    return sqrt(sum);
}

/* du . r */
static double work_of(const struct solver *s)
{
    const hobe_model *model = s->model;
    double sum = 0;
    for (long v = 0; v < model->vectors; v++)
        if (model->unknown[v] >= 0)
            for (int a = 0; a < 3; a++)
                sum += s->x[3 * model->unknown[v] + a] * s->r[3 * v + a];
    return sum;
}

/* K += factor M */
static void add_mass(const struct solver *s, double factor, const struct matrix *K)
{
    if (s->mass.value && s->mass.layout == K->layout)
        pattern_add(s->model, factor, &s->mass, K);
    else
        mass_matrix(s->model, factor, K);
}

enum hobe_status solver_keep_mass(struct solver *s, struct hobe_error *err)
{
    const enum hobe_status status = pattern_matrix(s->model, s->K.layout, &s->mass, err);
    if (!status)
        mass_matrix(s->model, 1, &s->mass);
    return status;
}

static void evaluate(struct solver *s, double factor, const struct matrix *K)
{
    const struct motion *m = &s->motion;
    const struct matrix *stiffness = m->mass_alone ? NULL : K;
    struct instant instant = m->instant;
    instant.held_back = 1 - factor;
    assemble_expecting(s->model, s->u, s->expecting ? s->step : NULL, s->r, stiffness);
    if (K && m->mass_alone)
        pattern_clear(s->model, K);
    constraint_add(s->model, s->u, &instant, s->r, K);
    spring_add(s->model, s->u, &instant, s->r, stiffness);
    damping_add(s->model, s->u, &instant, s->r, stiffness);
    load_subtract(s->model, s->u, &instant, factor, s->r, stiffness);
    for (long i = 0; m->force && i < 3 * s->model->moving; i++)
        s->r[i] += m->force[i];
    if (K && (m->inertia > 0 || m->mass_alone))
        add_mass(s, m->mass_alone ? 1 : m->inertia, K);
}

void solver_evaluate(struct solver *s, double factor, enum tangent tangent)
{
    s->factor = factor;
    s->expecting = tangent == NEXT_TANGENT;
    for (long i = 0; s->expecting && i < 3 * s->model->vectors; i++)
        s->step[i] = s->u[i] - s->turned[i];
    if (tangent)
        memcpy(s->turned, s->u, (size_t)(3 * s->model->vectors) * sizeof *s->u);
    evaluate(s, factor, tangent ? &s->K : NULL);
}

/* ---- one step -------------------------------------------------------------------------------- */

/* Where elimination without pivoting is not safe, the same tangent by LU with pivoting. */
static enum hobe_status factor_in_columns(struct solver *s, struct hobe_error *err)
{
    const struct matrix *K = s->K.layout == COLUMNS ? &s->K : &s->pivoting;
    if (K == &s->pivoting) {
        if (pattern_columns(s->model, err))
            return HOBE_NO_MEMORY;
        if (!K->value && pattern_matrix(s->model, COLUMNS, &s->pivoting, err))
            return HOBE_NO_MEMORY;
        evaluate(s, s->factor, K);
    }
    s->factored = COLUMNS;
    return hobe_linsolve_factor(s->model->solver, K->value, s->scale, &s->singular, err);
}

enum outcome solver_factor(struct solver *s, struct hobe_error *err)
{
    enum hobe_status status = HOBE_SINGULAR;
    if (s->space.count > 0)
        status = subspace_factor(&s->space, s->K.value, err);
    else if (s->K.layout == FRONTS) {
        s->factored = FRONTS;
        status = fronts_factor(s->model->fronts, s->K.value, s->scale);
    }
    if (status == HOBE_SINGULAR && s->space.count == 0)
        status = factor_in_columns(s, err);
    s->info.factorisations++;
    if (status == HOBE_SINGULAR)
        solver_log(s, "singular tangent");
    return status == HOBE_SINGULAR ? FAILED : status ? ERROR : CONVERGED;
}

enum hobe_status solver_negative(struct solver *s, long *negative, struct hobe_error *err)
{
    long spare;
    const long multipliers = inertia_multipliers(s->model, &spare);
    if (s->factored == FRONTS)
        *negative = fronts_negative(s->model->fronts) - multipliers;
    else if (multipliers == 0)
        *negative = hobe_linsolve_negative(s->model->solver);
    else {
        const enum hobe_status status =
            inertia_behind_ties(s->model, s->pivoting.value, s->scale, negative, err);
        return status ? status : factor_in_columns(s, err);
    }
    return HOBE_OK;
}

enum hobe_status solver_solve(struct solver *s, const double *field, double factor, double *x,
                              struct hobe_error *err)
{
    solver_restrict(s->model, field, x);
    for (long i = 0; i < 3 * s->model->unknowns; i++)
        x[i] *= factor;
    if (s->space.count > 0)
        subspace_solve(&s->space, x);
    else if (s->factored == COLUMNS)
        return hobe_linsolve_solve(s->model->solver, x, err);
    else
        fronts_solve(s->model->fronts, s->K.value, x);
    return HOBE_OK;
}

enum hobe_status solver_confine(struct solver *s, double factor, struct hobe_error *err)
{
    const struct hobe_projection *how = s->options.projection;
    const int fixed = how && how->method == HOBE_PROJECTION_SNAPSHOTS;
    if (!how || (fixed && s->space.count > 0))
        return HOBE_OK;
    s->info.linearisations++;
    return fixed ? snapshot_modes(s->model, how, s->reference, &s->space, err)
                 : component_modes(s->model, how, s->u, factor, s->reference, &s->space, err);
}

/* Takes the correction, halved until the work of the residual along it has fallen. */
static void search_line(struct solver *s, double factor)
{
    const double first = fabs(work_of(s));
    double taken = 1;
    solver_move(s, s->x, 1);
    solver_evaluate(s, factor, NO_TANGENT);
    for (int cut = 0; cut < LINE_SEARCH_CUTS && !(fabs(work_of(s)) <= 0.9 * first); cut++) {
        solver_move(s, s->x, -taken / 2);
        taken /= 2;
        solver_evaluate(s, factor, NO_TANGENT);
    }
    s->now.line = taken;
}

/* What rounding may leave of the residual; of a reduced one the energy's large terms that cancel
 * round more than the state. */
static double round_off(struct solver *s)
{
    if (!s->model->reduction)
        return ROUND_OFF * solver_norm(s, s->u, -1);
    reduction_round_off(s->model, s->u, s->step); /* which the next tangent sets anew */
    return solver_norm(s, s->step, 1);
}

enum outcome solver_judge(struct solver *s, double norm, double last_norm)
{
    s->now.residual = s->info.residual = norm / s->load_norm;
    if (s->now.residual <= s->options.tolerance) {
        solver_log(s, "converged");
        return CONVERGED;
    }
    if (!(s->now.residual < DIVERGED)) {
        solver_log(s, "diverged");
        return FAILED;
    }
    if (norm > 0.5 * last_norm && norm <= round_off(s)) {
        solver_log(s, "converged to round-off");
        return CONVERGED;
    }
    solver_log(s, "");
    return GOING_ON;
}

enum outcome solver_measure(struct solver *s)
{
    const double centre = s->model->reduction ? reduction_centre(s->model) : 0;
    const double size = hypot(solver_norm(s, s->u, -1), centre);
    s->info.change = size > 0 ? correction_norm(s) / size : 0;
    if (s->info.change <= LOST)
        return CONVERGED;
    solver_log(s, "lost in round-off");
    return FAILED;
}

enum outcome solver_refine(struct solver *s, struct hobe_error *err)
{
    const enum outcome outcome = solver_factor(s, err);
    s->info.change = NAN;
    if (outcome != CONVERGED)
        return outcome == ERROR ? ERROR : solver_check_volume(s, err);
    if (solver_solve(s, s->r, -1, s->x, err))
        return ERROR;
    solver_move(s, s->x, 1);
    const enum outcome measured = solver_measure(s);
    return measured == CONVERGED ? solver_check_volume(s, err) : measured;
}

enum outcome solver_iterate(struct solver *s, double factor, int line_search,
                            struct hobe_error *err)
{
    double first_energy = 0, first_norm = 0, last_norm = INFINITY;
    s->now.load = factor;
    s->now.line = s->now.energy = 1;
    for (s->now.iteration = 0; s->now.iteration <= s->options.max_iterations; s->now.iteration++) {
        const int far = s->now.iteration > 0 && last_norm > NEAR * first_norm;
        solver_evaluate(s, factor, far ? NEXT_TANGENT : TRUE_TANGENT);
        const double norm = solver_norm(s, s->r, 1);
        if (model_failure(s->model, err))
            return ERROR;
        if (s->now.iteration == 0)
            first_norm = norm;
        enum outcome outcome = solver_judge(s, norm, last_norm);
        if (outcome != GOING_ON)
            return outcome;
        last_norm = norm;
        outcome = solver_factor(s, err);
        if (outcome != CONVERGED)
            return outcome;
        if (solver_solve(s, s->r, -1, s->x, err))
            return ERROR;
        s->info.iterations++;
        const double energy = fabs(work_of(s));
        first_energy = fmax(first_energy, energy);
        s->now.energy = first_energy > 0 ? energy / first_energy : 0;
        if (s->jump.first && !line_search)
            jump_watch(s);
        if (line_search)
            search_line(s, factor);
        else
            solver_move(s, s->x, 1);
    }
    solver_log(s, "too many iterations");
    return FAILED;
}

enum outcome solver_check_volume(struct solver *s, struct hobe_error *err)
{
    if (solution_smallest_volume(s->model, s->u, &s->info.smallest_volume, err))
        return ERROR;
    if (s->info.smallest_volume > 0)
        return CONVERGED;
    solver_log(s, "turned inside out");
    return FAILED;
}

/* One step from s->start: plain Newton, then with line search; CONVERGED only where the solution
 * is not turned inside out. */
static enum outcome attempt(struct solver *s, double factor, struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors) * sizeof *s->u;
    for (int line_search = 0; line_search <= !s->options.no_line_search; line_search++) {
        enum outcome outcome = solver_iterate(s, factor, line_search, err);
        if (outcome == CONVERGED)
            outcome = solver_refine(s, err);
        if (outcome != FAILED)
            return outcome;
        s->reason = s->now.note;
        s->jump.suspected = 1;
        memcpy(s->u, s->start, size);
    }
    return FAILED;
}

/* ---- steps ----------------------------------------------------------------------------------- */

enum hobe_status solver_name_free(const struct solver *s, struct hobe_error *err)
{
    const hobe_model *model = s->model;
    for (size_t i = 0; i < model->beams.count && s->singular >= 0; i++) {
        const struct beam *beam = model_beam(model, i);
        for (int e = 0; e < beam->spec.elements; e++)
            for (int v = 0; v < beam->kernel->vectors; v++)
                if (model->unknown[model_vector(model, beam, e, v)] == s->singular / 3) {
                    const struct hobe_vector *is = beam->kernel->vector + v;
                    return hobe_fail(
                        err, HOBE_SINGULAR, beam->spec.where,
                        "the tangent stiffness is singular at rest: beam \"%s\" can move without "
                        "resistance in mode %s%s (component %c) near at = %.4g; hold it, or use "
                        "integration = \"exact\"",
                        beam->name, beam->kernel->mode[is->mode], is->slope ? "'" : "",
                        "xyz"[s->singular % 3],
                        (e + beam->kernel->node[is->node]) / beam->spec.elements);
                }
    }
    return hobe_fail(err, HOBE_SINGULAR, NULL,
                     "the tangent stiffness is singular at rest: the scene can move without "
                     "resistance; hold it, or use integration = \"exact\"");
}

static enum hobe_status give_up(const struct solver *s, double reached, double tried,
                                struct hobe_error *err)
{
    if (reached == 0 && s->singular >= 0 && s->now.iteration == 0)
        return solver_name_free(s, err);
    return hobe_fail(
        err, HOBE_NOT_CONVERGED, NULL,
        "no equilibrium found beyond %.4g of the load (at %.4g: %s, residual %.2g; "
        "%d steps, %d iterations, %d cut-backs); try a smaller load, a finer mesh, more "
        "steps, or a smaller smallest_step (now %g): past a limit point no static "
        "solution may exist near by: follow the path with hobe.path",
        reached, tried, s->reason, s->now.residual, s->info.steps, s->info.iterations,
        s->info.cutbacks, s->options.smallest_step);
}

static enum hobe_status run_steps(struct solver *s, struct hobe_error *err)
{
    const size_t size = (size_t)(3 * s->model->vectors) * sizeof *s->u;
    double reached = 0, step = 1.0 / s->options.steps;
    int fresh = 1; /* the state is another one than that of the last attempt */
    while (reached < 1) {
        const double target = reached + step > 1 - 1e-9 ? 1 : reached + step;
        const int before = s->info.iterations;
        s->now.step = s->info.steps + 1;
        memcpy(s->start, s->u, size);
        if (fresh && solver_confine(s, reached, err))
            return err ? err->status : HOBE_NO_MEMORY;
        s->jump.suspected = 0;
        enum outcome outcome = attempt(s, target, err);
        if (outcome == CONVERGED && s->jump.first && s->jump.suspected)
            outcome = jump_verify(s, reached, target, err);
        fresh = outcome == CONVERGED;
        if (outcome == ERROR)
            return err ? err->status : HOBE_NO_MEMORY;
        if (outcome == FAILED) {
            if (step / 2 < s->options.smallest_step)
                return give_up(s, reached, target, err);
            step /= 2;
            s->info.cutbacks++;
            solver_log(s, "step cut back");
            continue;
        }
        s->info.steps++;
        s->info.load = reached = target;
        if (s->info.iterations - before <= EASY_ITERATIONS && s->info.cutbacks)
            step = fmin(2 * step, 1.0 / s->options.steps);
    }
    return HOBE_OK;
}

/* ---- a start from another solution ----------------------------------------------------------- */

/* Newton at the full load from the start that is given, in one step; FAILED leaves the reference.
 */
static enum outcome attempt_start(struct solver *s, struct hobe_error *err)
{
    const hobe_solution *start = s->options.start;
    const size_t size = (size_t)(3 * s->model->vectors) * sizeof *s->u;
    memcpy(s->u, solution_field(start, s->model, SOLUTION_U), size);
    memcpy(s->start, s->u, size);
    s->now.step = 1;
    if (solver_confine(s, 1, err))
        return ERROR;
    const enum outcome outcome = attempt(s, 1, err);
    if (outcome == CONVERGED) {
        s->info.steps = 1;
        s->info.load = 1;
    } else {
        s->info.cutbacks++;
        memset(s->u, 0, size);
    }
    return outcome;
}

/* ---- all of it ------------------------------------------------------------------------------- */

/* D = diag(K)^(-1/2) and the norm of the load, both at the reference. */
static void set_scale(struct solver *s)
{
    solver_evaluate(s, 1, TRUE_TANGENT);
    pattern_scale(s->model, &s->K, s->scale);
    if (s->model->reduction && s->model->reduction->of->centre) { /* where F is not 0 */
        memset(s->r, 0, (size_t)(3 * s->model->vectors) * sizeof *s->r);
        load_subtract(s->model, s->u, &s->motion.instant, 1, s->r, NULL);
    }
    s->load_norm = solver_norm(s, s->r, 1); /* F = 0 at the reference */
    if (s->reference)
        memcpy(s->reference, s->scale, (size_t)(3 * s->model->unknowns) * sizeof *s->scale);
}

enum hobe_status solver_use_columns(struct solver *s, struct hobe_error *err)
{
    if (s->K.layout == COLUMNS)
        return HOBE_OK;
    hobe_free(s->K.value);
    s->K.value = NULL;
    if (pattern_columns(s->model, err))
        return HOBE_NO_MEMORY;
    return pattern_matrix(s->model, COLUMNS, &s->K, err);
}

static enum hobe_status allocate(struct solver *s, struct hobe_error *err)
{
    const size_t vectors = (size_t)(3 * s->model->vectors), n = (size_t)(3 * s->model->unknowns);
    s->u = hobe_alloc(vectors, sizeof *s->u, err);
    s->start = hobe_alloc(vectors, sizeof *s->start, err);
    s->turned = hobe_alloc(vectors, sizeof *s->turned, err);
    s->step = hobe_alloc(vectors, sizeof *s->step, err);
    s->r = hobe_alloc(vectors, sizeof *s->r, err);
    s->x = hobe_alloc(n, sizeof *s->x, err);
    s->scale = hobe_alloc(n, sizeof *s->scale, err);
    if (!s->u || !s->start || !s->turned || !s->step || !s->r || !s->x || !s->scale)
        return HOBE_NO_MEMORY;
    if (pattern_matrix(s->model, s->model->fronts ? FRONTS : COLUMNS, &s->K, err))
        return HOBE_NO_MEMORY;
    if (!s->options.projection)
        return HOBE_OK;
    s->reference = hobe_alloc(n, sizeof *s->reference, err);
    return s->reference ? solver_use_columns(s, err) : HOBE_NO_MEMORY;
}

void solver_close(struct solver *s)
{
    hobe_free(s->u);
    hobe_free(s->start);
    hobe_free(s->turned);
    hobe_free(s->step);
    hobe_free(s->r);
    hobe_free(s->K.value);
    hobe_free(s->pivoting.value);
    hobe_free(s->mass.value);
    hobe_free(s->x);
    hobe_free(s->scale);
    hobe_free(s->reference);
    subspace_close(&s->space);
    jump_close(s);
}

static void set_defaults(struct hobe_newton *o)
{
    if (o->steps <= 0)
        o->steps = 1;
    if (o->max_iterations <= 0)
        o->max_iterations = DEFAULT_ITERATIONS;
    if (!(o->tolerance > 0))
        o->tolerance = DEFAULT_TOLERANCE;
    if (!(o->smallest_step > 0))
        o->smallest_step = DEFAULT_SMALLEST_STEP;
}

enum hobe_status solver_open(struct solver *s, hobe_model *model, const struct hobe_newton *options,
                             struct hobe_error *err)
{
    *s = (struct solver){.model = model, .options = *options, .singular = -1};
    s->info.negative = -1;
    s->info.indicator = model->reduction ? NAN : 0;
    set_defaults(&s->options);
    s->motion.instant.time = s->info.time = options->time;
    if (options->projection && model->reduction)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "a projection is for whole scenes, not for reduced models");
    const enum hobe_status status = allocate(s, err);
    if (status)
        return status;
    set_scale(s);
    return model_failure(model, err);
}

hobe_solution *solver_take(struct solver *s, double started, struct hobe_error *err)
{
    s->info.energy = assemble_energy(s->model, s->u) + spring_energy(s->model, s->u);
    s->info.seconds = hobe_seconds() - started;
    s->info.projected = s->space.count;
    s->info.outside = s->space.count > 0 ? whole_norm(s, s->r, 1) / s->load_norm : 0;
    hobe_solution *taken = solution_new(s->model, s->u, NULL, NULL, &s->info, err);
    const int few = s->model->reduction || s->space.count > 0;
    double size = 0;
    if (taken && few && trust_ask((hobe_model *)model_whole(s->model), taken, &size, err)) {
        hobe_solution_free(taken);
        return NULL;
    }
    return taken;
}

/* A reduced model keeps to the accuracy it was asked for, or says that it does not. */
static enum hobe_status check_trust(const hobe_model *model, hobe_solution **solution,
                                    struct hobe_error *err)
{
    const double accuracy = model->reduction ? model->reduction->of->info.accuracy : 0;
    const double indicator = (*solution)->info.indicator;
    if (!(accuracy > 0) || indicator <= accuracy)
        return HOBE_OK;
    hobe_solution_free(*solution);
    *solution = NULL;
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                     "the reduced model may lack %.2g of the displacements under these loads, more "
                     "than its accuracy %.2g; reduce the scene with these among its loads, or "
                     "solve the whole one",
                     indicator, accuracy);
}

/* The end of the path to the full load. */
static enum hobe_status follow_series(hobe_model *model, const struct hobe_newton *options,
                                      hobe_solution **solution, struct hobe_error *err)
{
    const struct hobe_path_options along = {
        .newton = *options, .steps = MOST_SERIES, .smallest_arc = options->smallest_step};
    struct hobe_path_info info;
    hobe_path *path;
    enum hobe_status status = hobe_path_follow(model, &along, &path, err);
    if (status)
        return status;
    hobe_path_info(path, &info);
    if (info.end == HOBE_PATH_LOAD) {
        *solution = hobe_path_take(path, info.points - 1);
        for (int i = info.events - 1; i >= 0; i--)
            if (!hobe_path_event(path, i)->bifurcation)
                (*solution)->info.limit_load = hobe_path_event(path, i)->extreme;
        if (model->spun)
            (*solution)->info.negative = -1;
    } else
        status = hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                           "the path to the full load does not come to it in %d series; look where "
                           "it goes with hobe.path",
                           info.points);
    hobe_path_free(path);
    return status;
}

/* u = K_0^-1 Q, and what of the load it leaves unbalanced. */
static enum hobe_status respond(struct solver *s, struct hobe_error *err)
{
    const enum outcome outcome = solver_factor(s, err);
    if (outcome != CONVERGED)
        return outcome == ERROR ? err->status : solver_name_free(s, err);
    enum hobe_status status = solver_solve(s, s->r, -1, s->x, err);
    if (status)
        return status;
    solver_move(s, s->x, 1);
    solver_evaluate(s, 1, NO_TANGENT);
    status = model_failure(s->model, err);
    if (status)
        return status;
    s->info.steps = s->info.iterations = 1;
    s->info.load = 1;
    s->info.residual = solver_norm(s, s->r, 1) / s->load_norm;
    return solution_smallest_volume(s->model, s->u, &s->info.smallest_volume, err);
}

/* Equilibrium at the full load, in s->u. */
static enum hobe_status find(struct solver *s, struct hobe_error *err)
{
    if (s->options.linear)
        return respond(s, err);
    if (!s->options.projection && jump_open(s, err))
        return HOBE_NO_MEMORY;
    const enum outcome outcome = s->options.start ? attempt_start(s, err) : FAILED;
    if (outcome == ERROR)
        return err ? err->status : HOBE_NO_MEMORY;
    return outcome == CONVERGED ? HOBE_OK : run_steps(s, err);
}

/* Counts the negative eigenvalues at the equilibrium: of the factors of the last iteration, which
 * are there, and where those have any of the tangent itself.  A scene that spins may be stable with
 * some, and follower forces have no symmetric tangent: not counted. */
static enum hobe_status count_negative(struct solver *s, struct hobe_error *err)
{
    long negative = 1;
    if (s->K.layout != FRONTS || s->model->spun || load_follower(s->model) ||
        s->options.projection || s->options.linear)
        return HOBE_OK;
    if (s->info.factorisations > 0 && s->factored == FRONTS && solver_negative(s, &negative, err))
        return err ? err->status : HOBE_NO_MEMORY;
    if (negative != 0) {
        negative = -1;
        solver_evaluate(s, 1, TRUE_TANGENT);
        const enum outcome outcome = solver_factor(s, err);
        if (outcome == ERROR || (outcome == CONVERGED && solver_negative(s, &negative, err)))
            return err ? err->status : HOBE_NO_MEMORY;
    }
    s->info.negative = (int)negative;
    return HOBE_OK;
}

enum hobe_status newton_static(hobe_model *model, const struct hobe_newton *options,
                               hobe_solution **solution, struct hobe_error *err)
{
    struct solver s;
    const double started = hobe_seconds();
    enum hobe_status status = solver_open(&s, model, options, err);
    const int loaded = !status && s.load_norm > 0;
    if (loaded && options->method == HOBE_METHOD_SERIES && !options->linear)
        status = follow_series(model, &s.options, solution, err);
    else if (loaded) {
        status = find(&s, err);
        if (!status)
            status = count_negative(&s, err);
    } else
        s.info.load = s.info.smallest_volume = 1; /* no load: the reference is the answer */
    if (!status && !*solution) {
        *solution = solver_take(&s, started, err);
        status = *solution ? HOBE_OK : HOBE_NO_MEMORY;
    }
    if (!status)
        status = check_trust(model, solution, err);
    solver_close(&s);
    return status;
}
