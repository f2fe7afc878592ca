/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The equations of equilibrium: residual, tangent and its factors, norms, and when an iteration is
 * over. */
#include "solver.h"

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

enum { DEFAULT_ITERATIONS = 30 };

static const double DEFAULT_TOLERANCE = 1e-9, DEFAULT_SMALLEST_STEP = 1e-4;

/* A residual this much above the load's is hopeless: the iteration has left. */
static const double DIVERGED = 1e12;

/* The residual moves by |D K eps u| when u is rounded.  An iteration that stalls within a few times
 * that has won every digit there is. */
static const double ROUND_OFF = 8 * DBL_EPSILON;

/* Displacements that one more correction changes by more than this share are none. */
static const double LOST = 0.01;

/* ---- residual and tangent ------------------------------------------------------------------- */

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

/* ---- factors -------------------------------------------------------------------------------- */

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

/* ---- when it is over ------------------------------------------------------------------------ */

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

enum outcome solver_check_volume(struct solver *s, struct hobe_error *err)
{
    if (solution_smallest_volume(s->model, s->u, &s->info.smallest_volume, err))
        return ERROR;
    if (s->info.smallest_volume > 0)
        return CONVERGED;
    solver_log(s, "turned inside out");
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

/* ---- memory --------------------------------------------------------------------------------- */

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
