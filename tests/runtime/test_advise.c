/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Advice on random scenes, against a much finer model and against the whole ladder. */
#include "advise.h"
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* A cantilever; loads at its end and all over it. */
struct cantilever {
    hobe_section *section;
    double length, force[3], moment[3], gravity[3];
    int solves;
};

enum { QUANTITIES = 7 };
static const char *const NAME[] = {"u1", "u2", "u3", "middle 2", "middle 3", "twist", "rotation"};
static const char *const UNIT[] = {"m", "m", "m", "m", "m", "rad", "rad"};

static const double E = 210e9, NU = 0.3, RHO = 7850;

static hobe_section *random_section(int kind)
{
    struct hobe_error err;
    hobe_section *s = NULL;
    const double h = random_real(0.1, 0.3), b = h * random_real(0.3, 1);
    const double t = random_real(0.04, 0.12) * b;
    const struct hobe_profile_sizes sizes = {
        .height = h, .width = b, .flange = t * random_real(1, 1.5), .web = t};
    if (kind == 0)
        s = hobe_section_rectangle(b, h, HOBE_WARPING_SERIES, &err);
    else if (kind == 1)
        s = hobe_section_tube(h / 2, h / 2 - t, &err);
    else
        s = hobe_section_profile(kind == 2 ? HOBE_PROFILE_I : HOBE_PROFILE_CHANNEL, &sizes,
                                 HOBE_WARPING_SOLVED, &err);
    if (!s)
        check_stop("%s", err.message);
    return s;
}

/* Loads that bend and twist it to a random degree, small to large. */
static struct cantilever random_cantilever(int kind)
{
    struct cantilever c = {.section = random_section(kind)};
    const struct hobe_section_properties p = properties_of(c.section);
    const double L = c.length = p.height * exp(random_real(log(4), log(60)));
    const double degree = exp(random_real(log(1e-4), log(1)));
    const double angle = random_real(0, 2 * M_PI), EI[2] = {E * p.Izz, E * p.Iyy};
    const double across[2] = {cos(angle), sin(angle)};
    for (int a = 0; a < 2; a++) {
        c.force[1 + a] = degree * 3 * EI[a] / (L * L) * across[a] * random_real(0, 1);
        c.moment[2 - a] = degree * EI[a] / L * across[a] * (random_real(0, 1) < 0.4);
        c.gravity[1 + a] = degree * 8 * EI[a] / (L * L * L * p.A * RHO) * across[a] *
                           (random_real(0, 1) < 0.4);
    }
    if (random_real(0, 1) < 0.5)
        c.moment[0] = degree * E / 2.6 * p.J / L;
    return c;
}

/* The model of it, with loads; NULL where it cannot be. */
static hobe_model *model_of(const struct cantilever *c, const struct advise_model *as)
{
    struct hobe_beam beam = beam_along_x(as->kernel->name, as->elements, c->section, E, NU, c->length);
    beam.material.rho = RHO;
    if (!advise_leave_out(as->without, &beam.material))
        return NULL;
    hobe_model *model = cantilever(&beam, 0);
    struct hobe_error err;
    add_force(model, "beam", 1, c->force[0], c->force[1], c->force[2]);
    add_moment(model, "beam", 1, c->moment[0], c->moment[1], c->moment[2]);
    hobe_model_gravity(model, NULL, c->gravity, &err);
    return model;
}

static enum hobe_status run(void *context, const struct advise_model *as, double *value,
                            int *iterations, struct hobe_error *err)
{
    struct cantilever *c = context;
    hobe_solution *solution;
    hobe_model *model = model_of(c, as);
    const struct hobe_newton options = {.linear = as->linear};
    enum hobe_status status = hobe_static(model, &options, &solution, err);
    c->solves++;
    if (!status) {
        const struct hobe_point tip = point_of(solution, "beam", 1, 0, 0);
        const struct hobe_point middle = point_of(solution, "beam", 0.5, 0, 0);
        struct hobe_solution_info info;
        hobe_solution_info(solution, &info);
        memcpy(value, tip.u, sizeof tip.u);
        memcpy(value + 3, middle.u + 1, 2 * sizeof *value);
        status = hobe_solution_twist(solution, "beam", 1, value + 5, err);
        value[6] = norm(tip.rotation);
        *iterations = as->linear ? 1 : info.factorisations;
    }
    hobe_solution_free(solution);
    hobe_model_free(model);
    return status;
}

/* The largest error of values beside the truth, measured as advice does. */
static double error_of(const double *value, const double *truth)
{
    double worst = 0;
    for (int i = 0; i < QUANTITIES; i++) {
        double size = fabs(truth[i]);
        for (int j = 0; j < QUANTITIES; j++)
            if (!strcmp(UNIT[i], UNIT[j]))
                size = fmax(size, 0.01 * fabs(truth[j]));
        if (size > 1e-12)
            worst = fmax(worst, fabs(value[i] - truth[i]) / size);
    }
    return worst;
}

/* The ladder's cheapest model that is within the accuracy; cost INFINITY where there is none. */
static struct advise_trial best_of_ladder(struct cantilever *c, const double *truth, double accuracy)
{
    static const char *const ELEMENTS[] = {"BE24",   "BE24w", "3333",  "3333w",   "3333w3", "3433",
                                           "3433w",  "MGD30", "MGD30w", "MGD30w3", "MGD30d"};
    static const int MESH[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
    struct advise_trial best = {.cost = INFINITY};
    for (size_t e = 0; e < sizeof ELEMENTS / sizeof *ELEMENTS; e++)
        for (size_t m = 0; m < sizeof MESH / sizeof *MESH; m++)
            for (int linear = 1; linear >= 0; linear--) {
                struct hobe_error err;
                double value[QUANTITIES];
                int iterations;
                const struct advise_model model = {.kernel = hobe_find_kernel(ELEMENTS[e], &err),
                                                   .elements = MESH[m],
                                                   .linear = linear};
                if (advise_cost(&model, linear ? 1 : 2) >= best.cost ||
                    run(c, &model, value, &iterations, &err))
                    continue;
                const double cost = advise_cost(&model, iterations);
                if (cost < best.cost && error_of(value, truth) <= accuracy)
                    best = (struct advise_trial){.model = model, .cost = cost};
            }
    return best;
}

static void one(int kind, double accuracy)
{
    struct hobe_error err;
    struct cantilever c = random_cantilever(kind);
    struct advice advice;
    const struct hobe_kernel *level[ADVISE_LEVELS];
    struct advise_problem problem = {.quantities = QUANTITIES, .name = NAME, .unit = UNIT,
                                     .accuracy = accuracy, .levels = advise_levels(level),
                                     .level = level, .most = 64, .takes_linear = 1, .run = run, .context = &c};
    const enum hobe_status status = advise(&problem, &advice, &err);
    if (status)
        check_stop("%s", err.message);
    double truth[QUANTITIES];
    int iterations;
    const struct advise_model fine = {.kernel = level[problem.levels - 1], .elements = 160};
    if (run(&c, &fine, truth, &iterations, &err))
        check_stop("%s", err.message);
    const struct advise_trial *t = advice.trial + advice.model;
    const double error = error_of(t->value, truth);
    printf("solves %d t %.2f ", c.solves, (double)clock()/CLOCKS_PER_SEC);
    const struct advise_trial best = getenv("QUICK") ? (struct advise_trial){.cost=INFINITY} : best_of_ladder(&c, truth, accuracy);
    printf("kind %d L/h %5.1f: %s%-8s %2d %s claim %.2e true %.2e (%s) cost ratio %.2f (%s %d %s) search %.1f trials %d\n",
           kind, c.length / properties_of(c.section).height, advice.holds ? "" : "NOT ",
           t->model.kernel->name, t->model.elements, t->model.linear ? "linear" : "      ", advice.error.size, error,
           NAME[advice.error.quantity], t->cost / best.cost, best.model.kernel ? best.model.kernel->name : "-", best.model.elements, best.model.linear ? "linear" : "", advice.cost / t->cost, advice.trials);
    if (getenv("V")) {
        for (int l = 0; l < problem.levels; l++) printf("   %-30s %.2e %s\n", advise_step(level[l]), advice.level[l].size, NAME[advice.level[l].quantity]);
        printf("   linear %.2e  noshear %.2e nopoisson %.2e mesh %.2e open %.2e\n", advice.linear.size, advice.without[1].size, advice.without[2].size, advice.mesh.size, advice.open);
        for (int i = 0; i < advice.trials; i++) { const struct advise_trial *q = advice.trial + i;
            printf("      %-8s %3d %d %d  err %.2e cost %.3g %s\n", q->model.kernel->name, q->model.elements, q->model.linear, q->model.without, q->failed ? NAN : error_of(q->value, truth), q->cost, q->why ? q->why : ""); }
        printf("   best error %.2e\n", error_of(advice.best, truth));
    }
    check_that(!advice.holds || error <= 2 * accuracy, "accuracy %g", error);
    check_that(t->cost <= 3 * best.cost, "cost");
    advice_free(&advice);
    hobe_section_free(c.section);
}

int main(int argc, char **argv)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    random_start();
    const int scenes = argc > 1 ? atoi(argv[1]) : 4;
    for (int i = 0; i < scenes; i++)
        one(i % 4, argc > 2 ? atof(argv[2]) : 1e-3);
    return check_report();
}
