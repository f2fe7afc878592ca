/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Advice on random scenes, against a much finer model and against the whole ladder. */
#include "advise.h"
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A cantilever; loads at its end and all over it. */
struct cantilever {
    hobe_section *section;
    double length, force[3], moment[3], gravity[3];
};

enum { QUANTITIES = 7, MANY_ITERATIONS = 40 };
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
    const double degree = exp(random_real(log(1e-4), log(0.3)));
    const double angle = random_real(0, 2 * M_PI), EI[2] = {E * p.Izz, E * p.Iyy};
    const double across[2] = {cos(angle), sin(angle)};
    for (int a = 0; a < 2; a++) {
        c.force[1 + a] = degree * 3 * EI[a] / (L * L) * across[a] * random_real(0, 1);
        c.moment[2 - a] = degree * EI[a] / L * across[a] * (random_real(0, 1) < 0.4);
        c.gravity[1 + a] =
            degree * 8 * EI[a] / (L * L * L * p.A * RHO) * across[a] * (random_real(0, 1) < 0.4);
    }
    if (random_real(0, 1) < 0.5)
        c.moment[0] = degree * E / 2.6 * p.J / L;
    return c;
}

/* The model of it, with loads; NULL where it cannot be. */
static hobe_model *model_of(const struct cantilever *c, const struct advise_model *as)
{
    struct hobe_beam beam =
        beam_along_x(as->kernel->name, as->elements, c->section, E, NU, c->length);
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

/* Whether a model of the ladder, no richer than one element, that costs less than `most` is within
 * the accuracy; which.  One of `stride` models is run, from a random one on. */
static int cheaper_holds(struct cantilever *c, const struct hobe_kernel *richest,
                         const double *truth, double accuracy, double most, int stride,
                         struct advise_model *which)
{
    static const char *const ELEMENTS[] = {"BE24",  "BE24w", "3333",   "3333w",   "3333w3", "3433",
                                           "3433w", "MGD30", "MGD30w", "MGD30w3", "MGD30d"};
    static const int MESH[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
    const int models = 2 * (int)(sizeof ELEMENTS / sizeof *ELEMENTS * (sizeof MESH / sizeof *MESH));
    for (int i = (int)random_real(0, stride); i < models; i += stride) {
        struct hobe_error err;
        double value[QUANTITIES];
        int iterations;
        *which = (struct advise_model){.kernel = hobe_find_kernel(ELEMENTS[i / 24], &err),
                                       .elements = MESH[i / 2 % 12],
                                       .linear = i % 2};
        if (which->kernel->modes <= richest->modes &&
            advise_cost(which, which->linear ? 1 : 3) < most &&
            !run(c, which, value, &iterations, &err) && advise_cost(which, iterations) < most &&
            error_of(value, truth) <= accuracy)
            return 1;
    }
    return 0;
}

/* How thorough the test is. */
struct thoroughness {
    int scenes, levels, most, finest, stride;
    double accuracy;
};

/* A random cantilever and its truth; others where one buckles, and where statics find no way past
 * that but by many trials a state that they had not been led to. */
static struct cantilever solved_cantilever(int kind, const struct advise_model *finest,
                                           double *truth)
{
    struct hobe_error err;
    struct cantilever c;
    int iterations;
    for (c = random_cantilever(kind);
         run(&c, finest, truth, &iterations, &err) || iterations > MANY_ITERATIONS;) {
        hobe_section_free(c.section);
        c = random_cantilever(kind);
    }
    return c;
}

/* The choice is within twice the accuracy that it claims, and no model of the ladder that is as
 * good costs less than a third. */
static void check_choice(const struct advice *advice, struct cantilever *c, const double *truth,
                         int stride)
{
    const struct advise_problem *p = advice->problem;
    const struct advise_trial *taken = advice->trial + advice->model;
    const double error = error_of(taken->value, truth);
    struct advise_model cheaper;
    struct hobe_text text = {0};
    advise_say(advice, &text);
    printf("L/h %.3g, %s: %s; it is %.2g; all trials cost %.0f times as much\n",
           c->length / properties_of(c->section).height, hobe_section_text(c->section), text.at,
           error, advice->cost / taken->cost);
    hobe_text_free(&text);
    check_that(advice->error.size <= p->accuracy || !advice->holds, "the claim is the accuracy's");
    check_that(!advice->holds || error <= 2 * p->accuracy, "accuracy %g met: %g", p->accuracy,
               error);
    check_that(advice->holds || error >= 0.1 * p->accuracy, "nothing holds %g: %g", p->accuracy,
               error);
    const int too_dear = cheaper_holds(c, p->level[p->levels - 1], truth, p->accuracy,
                                       taken->cost / 3, stride, &cheaper);
    check_that(!too_dear, "%s %d%s would do", cheaper.kernel->name, cheaper.elements,
               cheaper.linear ? " linear" : "");
}

/* Advice about a random cantilever, the truth the richest level on more elements than a choice may
 * have. */
static void check_advice(int kind, const struct thoroughness *how)
{
    struct hobe_error err;
    const struct hobe_kernel *level[ADVISE_LEVELS];
    const int known = advise_levels(level), levels = how->levels < known ? how->levels : known;
    const struct advise_model finest = {.kernel = level[levels - 1], .elements = how->finest};
    double truth[QUANTITIES];
    struct cantilever c = solved_cantilever(kind, &finest, truth);
    const struct advise_problem problem = {.quantities = QUANTITIES,
                                           .name = NAME,
                                           .unit = UNIT,
                                           .accuracy = how->accuracy,
                                           .levels = levels,
                                           .level = level,
                                           .most = how->most,
                                           .takes_linear = 1,
                                           .run = run,
                                           .context = &c};
    struct advice advice;
    if (advise(&problem, &advice, &err))
        check_stop("%s", err.message);
    check_choice(&advice, &c, truth, how->stride);
    advice_free(&advice);
    hobe_section_free(c.section);
}

/* runtime_advise [SCENES [LEVELS [ACCURACY]]]: more scenes, held against the whole ladder and a
 * finer truth, which may distort its section (4 levels), than there is time for in every run. */
int main(int argc, char **argv)
{
    struct thoroughness how = {
        .scenes = 4, .levels = 3, .most = 64, .finest = 128, .stride = 9, .accuracy = 3e-3};
    if (argc > 1)
        how = (struct thoroughness){atoi(argv[1]),
                                    argc > 2 ? atoi(argv[2]) : 3,
                                    128,
                                    512,
                                    1,
                                    argc > 3 ? atof(argv[3]) : 1e-3};
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    random_start();
    for (int i = 0; i < how.scenes; i++)
        check_advice(i % 4, &how);
    return check_report();
}
