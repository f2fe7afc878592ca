/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Static equilibrium: load steps, Newton's iteration with a consistent tangent, line search when
 * the plain iteration fails, and cut-back of the step when that fails too. */
#include "newton.h"

#include "load.h"
#include "reduction.h"
#include "solution.h"

#include <math.h>
#include <string.h>

enum {
    EASY_ITERATIONS = 8, /* a step that needs no more lets the next one grow */
    MOST_SERIES = 10000, /* to the full load */
    LINE_SEARCH_CUTS = 12
};

/* Below this share of the first residual of a step, its square adds no stress worth a thought. */
static const double NEAR = 0.1;

/* ---- one step -------------------------------------------------------------------------------- */

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
