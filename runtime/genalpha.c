/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "genalpha.h"

#include "constraint.h"
#include "mass.h"
#include "pattern.h"
#include "reduction.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { DEFAULT_ITERATIONS = 10 };

static const double DEFAULT_TOLERANCE = 1e-9, DEFAULT_RHO = 0.8;

/* The constraints hold to this at the end of each step, weighed. */
static const double CLOSED = 1e-10;

/* The residual moves by |D K eps u| when u is rounded, and by what multipliers are. */
static const double ROUND_OFF = 8 * DBL_EPSILON;

/* A residual so much larger than the first of its step has left. */
static const double DIVERGED = 1e6;

/* Factors cost about as much as so many iterations with those at hand: a step that would need more
 * makes new ones. */
static const double WORTH = 3;

/* ---- memory --------------------------------------------------------------------------------- */

static void set_parameters(struct genalpha *g, double rho)
{
    g->am = (2 * rho - 1) / (rho + 1);
    g->af = rho / (rho + 1);
    g->gamma = 0.5 + g->af - g->am;
    g->beta = (g->gamma + 0.5) * (g->gamma + 0.5) / 4;
}

/* Constraints without `turn` are lengths. */
static void set_weights(struct genalpha *g)
{
    const hobe_model *model = g->s.model, *whole = model_whole(model);
    for (size_t i = 0; i < whole->ties.count; i++) {
        const struct tie *tie = model_tie(whole, i);
        for (int k = 0; k < tie->constraints; k++) {
            int turns = 0;
            for (int j = 0; j < 9; j++)
                turns |= tie->constraint[k].turn[j / 3][j % 3] != 0;
            g->weight[3 * model_number(model, tie->multiplier) + k] = turns ? 1 : 1 / g->size;
        }
    }
}

enum hobe_status genalpha_open(struct genalpha *g, hobe_model *model,
                               const struct hobe_dynamic *options, struct hobe_error *err)
{
    *g = (struct genalpha){.tolerance =
                               options->tolerance > 0 ? options->tolerance : DEFAULT_TOLERANCE,
                           .max_iterations = options->max_iterations > 0 ? options->max_iterations
                                                                         : DEFAULT_ITERATIONS,
                           .full_newton = options->full_newton};
    set_parameters(g, options->rho > 0 ? options->rho : DEFAULT_RHO);
    enum hobe_status status =
        solver_open(&g->s, model, &(struct hobe_newton){.projection = options->projection}, err);
    if (!status && model->spun) /* Coriolis' force has a skew matrix */
        status = solver_use_columns(&g->s, err);
    if (status)
        return status;
    double **field[] = {&g->now.u, &g->now.v, &g->now.w, &g->now.a,  &g->v,
                        &g->w,     &g->a,     &g->force, &g->weight, &g->turned};
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        *field[i] = hobe_alloc((size_t)(3 * model->vectors), sizeof(double), err);
        if (!*field[i])
            return HOBE_NO_MEMORY;
    }
    status = mass_measure(model, &g->mass, &g->size, err);
    if (status)
        return status;
    set_weights(g);
    return solver_keep_mass(&g->s, err);
}

void genalpha_close(struct genalpha *g)
{
    double *const field[] = {g->now.u, g->now.v, g->now.w, g->now.a,  g->v,
                             g->w,     g->a,     g->force, g->weight, g->turned};
    for (size_t i = 0; i < sizeof field / sizeof *field; i++)
        hobe_free(field[i]);
    solver_close(&g->s);
}

/* ---- measures ------------------------------------------------------------------------------- */

double genalpha_violation(const struct genalpha *g, const double *r)
{
    double largest = 0;
    for (long i = 3 * g->s.model->moving; i < 3 * g->s.model->vectors; i++)
        largest = fmax(largest, g->weight[i] * fabs(r[i]));
    return largest;
}

double genalpha_norm(const struct genalpha *g, const double *x)
{
    return sqrt(fmax(0, mass_product(g->s.model, x, x)) / g->mass);
}

double genalpha_deviation(struct genalpha *g)
{
    for (long i = 0; i < 3 * g->s.model->moving; i++)
        g->force[i] = g->now.u[i] - g->turned[i];
    return genalpha_norm(g, g->force) / g->size;
}

enum hobe_status genalpha_confine(struct genalpha *g, struct hobe_error *err)
{
    const size_t size = (size_t)(3 * g->s.model->vectors) * sizeof *g->turned;
    memcpy(g->s.u, g->now.u, size);
    memcpy(g->turned, g->now.u, size);
    genalpha_forget(g);
    return solver_confine(&g->s, 1, err);
}

double genalpha_acceleration(const struct genalpha *g)
{
    return sqrt(fmax(0, dot(3 * g->s.model->moving, g->w, g->force)) / g->mass);
}

double genalpha_error(struct genalpha *g)
{
    const double h = g->now.step, share = fabs(g->beta + (g->am - g->af) / 2 - 1.0 / 6);
    for (long i = 0; i < 3 * g->s.model->moving; i++)
        g->force[i] = g->a[i] - g->now.a[i];
    return share * h * h * genalpha_norm(g, g->force);
}

/* ---- one step ------------------------------------------------------------------------------- */

int genalpha_choose_step(struct genalpha *g, double target, double longest)
{
    struct genalpha_state *now = &g->now;
    const double last = now->step, remaining = target - now->time;
    now->step = remaining / ceil(remaining / longest - 1e-9);
    now->begin = now->time;
    now->taken = 0;
    const int changed = !(fabs(now->step - last) <= 1e-6 * last);
    g->factored &= !changed;
    return changed;
}

void genalpha_forget(struct genalpha *g)
{
    g->factored = 0;
}

/* Constant accelerations and multipliers; or, where they are inert, displacements h v, which the
 * accelerations do not enter: those of a load that comes at once move a node far by themselves. */
static void predict(struct genalpha *g)
{
    const struct genalpha_state *now = &g->now;
    const double h = now->step, beta = g->beta, gamma = g->gamma;
    memcpy(g->s.u, now->u, (size_t)(3 * g->s.model->vectors) * sizeof *g->s.u);
    for (long i = 0; i < 3 * g->s.model->moving; i++) {
        const double a = now->a[i], w = now->w[i];
        g->a[i] = g->inert ? a - a / (2 * beta) : (w - g->am * a) / (1 - g->am);
        g->w[i] = ((1 - g->am) * g->a[i] + g->am * a - g->af * w) / (1 - g->af);
        g->v[i] = now->v[i] + h * ((1 - gamma) * a + gamma * g->a[i]);
        g->s.u[i] += h * now->v[i] + h * h * ((0.5 - beta) * a + beta * g->a[i]);
    }
}

/* The residual at the state that is being found, and the Newton matrix with its scale if asked. */
static void evaluate(struct genalpha *g, enum tangent tangent)
{
    struct solver *s = &g->s;
    memset(g->force, 0, (size_t)(3 * s->model->vectors) * sizeof *g->force);
    mass_force(s->model, 1, g->w, g->force);
    solver_evaluate(s, 1, tangent);
    if (tangent)
        pattern_scale(s->model, &s->K, s->scale);
}

/* What the residual is small beside: the forces of inertia, of dead loads and of constraints; and
 * what rounding leaves of it. */
static double goal(const struct genalpha *g)
{
    const struct solver *s = &g->s;
    const hobe_model *model = s->model;
    double held = 0;
    for (long v = model->moving; v < model->vectors; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const double force = s->u[3 * v + a] / s->scale[3 * model->unknown[v] + a];
            held += force * force;
        }
    const double forces = solver_norm(s, g->force, 1) + solver_norm(s, model->dead, 1) + sqrt(held);
    return fmax(g->tolerance * forces, ROUND_OFF * solver_norm(s, s->u, -1));
}

/* Takes the correction x. */
static void move(struct genalpha *g)
{
    struct solver *s = &g->s;
    const hobe_model *model = s->model;
    const struct motion *m = &s->motion;
    const double curvature = 1 / (g->now.step * g->now.step * g->beta);
    solver_move(s, s->x, 1);
    for (long v = 0; v < model->moving; v++)
        for (int a = 0; a < 3 && model->unknown[v] >= 0; a++) {
            const double x = s->x[3 * model->unknown[v] + a];
            g->v[3 * v + a] += m->instant.rate * x;
            g->w[3 * v + a] += m->inertia * x;
            g->a[3 * v + a] += curvature * x;
        }
}

static enum outcome fail(struct genalpha *g, const char *reason)
{
    g->reason = reason;
    g->factored = 0;
    return FAILED;
}

static enum outcome correct(struct genalpha *g, struct hobe_error *err)
{
    struct solver *s = &g->s;
    const enum outcome outcome = g->factored ? CONVERGED : solver_factor(s, err);
    if (outcome == FAILED)
        return fail(g, "its equations are singular");
    if (outcome == ERROR || solver_solve(s, s->r, -1, s->x, err))
        return ERROR;
    g->factored = !g->full_newton;
    move(g);
    return CONVERGED;
}

/* How the iteration stands: how many factors were made in this step, and whether the last tangent
 * is of the state before; norms of the residual, the first and the last. */
struct progress {
    int own, turned;
    double first, last;
};

/* Within a step, the tangent with the stresses that the last correction expects: that of a thin
 * beam which turns far in a step swings otherwise. */
static enum tangent best_tangent(const struct progress *p)
{
    return p->own && p->turned ? NEXT_TANGENT : TRUE_TANGENT;
}

/* Whether the factors at hand take too many iterations more: with those of this step one, since
 * new ones converge quadratically. */
static int too_slow(const struct progress *p, double norm, double goal)
{
    const double rate = norm / p->last;
    return !(rate < 0.5) || log(goal / norm) / log(rate) > (p->own ? 1 : WORTH);
}

/* The residual with a new Newton matrix; where factors of an earlier step have led away, at the
 * beginning again.  Its norm. */
static double renew(struct genalpha *g, const struct progress *p, double norm)
{
    if (!p->own && !(norm < p->last))
        predict(g);
    g->factored = 0;
    evaluate(g, best_tangent(p));
    return solver_norm(&g->s, g->s.r, 1);
}

static enum outcome iterate(struct genalpha *g, struct hobe_error *err)
{
    struct solver *s = &g->s;
    struct progress p = {.last = INFINITY};
    for (g->iterations = 0; g->iterations <= g->max_iterations; g->iterations++) {
        evaluate(g, g->factored || g->iterations ? NO_TANGENT : best_tangent(&p));
        if (model_failure(s->model, err))
            return ERROR;
        double norm = solver_norm(s, s->r, 1);
        const double wanted = goal(g);
        p.first = g->iterations ? p.first : fmax(norm, wanted);
        if (norm <= wanted && genalpha_violation(g, s->r) <= CLOSED) {
            g->factored &= p.own < 2; /* a step that wears them out leaves none to the next */
            return CONVERGED;
        }
        if (!(norm <= DIVERGED * p.first) && (p.own || !g->iterations))
            return fail(g, "Newton's iteration diverges");
        if (g->iterations && (!g->factored || too_slow(&p, norm, wanted)))
            norm = renew(g, &p, norm);
        p.turned = !g->factored;
        p.own += p.turned;
        p.last = norm;
        const enum outcome outcome = correct(g, err);
        if (outcome != CONVERGED)
            return outcome;
    }
    return fail(g, "Newton's iteration takes too long");
}

enum outcome genalpha_step(struct genalpha *g, struct hobe_error *err)
{
    const double h = g->now.step;
    g->s.motion = (struct motion){.instant = {g->now.begin + (double)(g->now.taken + 1) * h, g->v,
                                              g->gamma / (h * g->beta), 0},
                                  .force = g->force,
                                  .inertia = (1 - g->am) / ((1 - g->af) * h * h * g->beta)};
    enum outcome outcome = FAILED;
    for (g->inert = 0; outcome == FAILED && g->inert < 2; g->inert++) {
        predict(g);
        outcome = iterate(g, err);
    }
    return outcome;
}

static void swap(double **a, double **b)
{
    double *c = *a;
    *a = *b;
    *b = c;
}

void genalpha_accept(struct genalpha *g)
{
    struct genalpha_state *now = &g->now;
    swap(&now->u, &g->s.u);
    swap(&now->v, &g->v);
    swap(&now->w, &g->w);
    swap(&now->a, &g->a);
    now->time = g->s.motion.instant.time;
    now->taken++;
    g->s.info.iterations += g->iterations;
    g->s.info.steps++;
}
