/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of a scene that nothing couples, together beside each alone: the same numbers for the same
 * work; and what couples them. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double E = 2.1e11, NU = 0.3, LENGTH = 1;

/* What the scenes are made of, each at its own place. */
enum kind {
    SOFT,     /* bent far, in many iterations */
    STIFF,    /* hardly bent */
    PROPPED,  /* with multipliers */
    FOLLOWED, /* without a symmetric tangent */
    COLUMN,   /* beyond its critical load */
    IDLE,     /* without a load */
    KINDS
};
static const char *const NAME[KINDS] = {"soft", "stiff", "propped", "followed", "column", "idle"};

/* The load that buckles a cantilever about its weaker axis. */
static double critical(const hobe_section *section)
{
    const struct hobe_section_properties p = properties_of(section);
    return M_PI * M_PI * E * fmin(p.Iyy, p.Izz) / (4 * LENGTH * LENGTH);
}

static void add(hobe_model *model, const hobe_section *section, enum kind kind)
{
    struct hobe_beam beam = beam_along_x("3333", 4, section, E, NU, LENGTH);
    const struct hobe_joint prop = {
        .beam = {"propped"}, .at = {1}, .kind = HOBE_JOINT_INPLANE, .axis = {0, 0, 1}};
    beam.name = NAME[kind];
    beam.material.rho = 7800;
    beam.from[1] = beam.to[1] = kind;
    add_beam(model, &beam);
    add_clamp(model, beam.name, 0, 0);
    if (kind == PROPPED)
        add_joint(model, &prop);
    const double P = critical(section);
    if (kind == COLUMN)
        add_force(model, beam.name, 1, -1.3 * P, 0, 0);
    else if (kind == FOLLOWED)
        add_follower(model, beam.name, 1, 0, 0.3 * P, 0.2 * P);
    else if (kind != IDLE)
        add_force(model, beam.name, kind == SOFT ? 1 : 0.7, 0, kind == SOFT ? P : 1e-3 * P,
                  1e-2 * P);
}

static void count_line(void *context, const struct hobe_iteration *iteration)
{
    (void)iteration;
    ++*(int *)context;
}

struct answer {
    struct hobe_solution_info info;
    struct hobe_point tip[2];
    int lines; /* of the log: evaluations */
};

/* Of a scene of one or two; twice: also from where it ended. */
static struct answer answer_of(const hobe_section *section, int count, const enum kind *kind,
                               enum hobe_method method)
{
    struct answer answer = {.lines = 0};
    struct hobe_newton options = {
        .method = method, .tolerance = 1e-12, .log = count_line, .context = &answer.lines};
    struct hobe_error err;
    hobe_solution *solution[2];
    hobe_model *model = new_model();
    for (int i = 0; i < count; i++)
        add(model, section, kind[i]);
    for (int i = 0; i < 2; i++) {
        if (hobe_static(model, &options, solution + i, &err))
            check_stop("%s", err.message);
        options.start = solution[0];
    }
    answer.info = info_of(solution[0]);
    for (int i = 0; i < count; i++) {
        const struct hobe_point again = point_of(solution[1], NAME[kind[i]], 1, 0, 0);
        answer.tip[i] = point_of(solution[0], NAME[kind[i]], 1, 0.01, 0.02);
        check_absolute(distance(again.u, point_of(solution[0], NAME[kind[i]], 1, 0, 0).u), 0, 1e-9,
                       "from where it ended"); /* what the tolerance leaves */
    }
    hobe_solution_free(solution[0]);
    hobe_solution_free(solution[1]);
    hobe_model_free(model);
    return answer;
}

static int largest(int a, int b)
{
    return a > b ? a : b;
}

/* Of the parts alone the sum, without idle ones and -1 where one is. */
static int negatives(const struct answer *a, const struct answer *b)
{
    if (a->info.factorisations == 0 || b->info.factorisations == 0)
        return a->info.factorisations == 0 ? b->info.negative : a->info.negative;
    return a->info.negative < 0 || b->info.negative < 0 ? -1 : a->info.negative + b->info.negative;
}

static void compare(const hobe_section *section, const enum kind pair[2], enum hobe_method method)
{
    const struct answer both = answer_of(section, 2, pair, method);
    const struct answer alone[2] = {answer_of(section, 1, pair, method),
                                    answer_of(section, 1, pair + 1, method)};
    const struct hobe_solution_info *a = &alone[0].info, *b = &alone[1].info, *s = &both.info;
    for (int i = 0; i < 2; i++)
        check_absolute(distance(both.tip[i].u, alone[i].tip[0].u), 0, 1e-12 * LENGTH,
                       "%s beside %s", NAME[pair[i]], NAME[pair[1 - i]]);
    check_relative(s->energy, a->energy + b->energy, 1e-12, "energy");
    check_that(both.lines == alone[0].lines + alone[1].lines, "%d lines of the log, not %d + %d",
               both.lines, alone[0].lines, alone[1].lines);
    check_that(s->factorisations == a->factorisations + b->factorisations, "factorisations");
    check_that(s->iterations == largest(a->iterations, b->iterations) &&
                   s->steps == largest(a->steps, b->steps) &&
                   s->cutbacks == largest(a->cutbacks, b->cutbacks),
               "iterations and steps are those of the part that takes most");
    check_that(s->negative == negatives(alone, alone + 1), "%s and %s: %d negative, not %d and %d",
               NAME[pair[0]], NAME[pair[1]], s->negative, a->negative, b->negative);
}

static void pairs(const hobe_section *section)
{
    for (enum kind a = 0; a < KINDS; a++)
        for (enum kind b = a + 1; b < KINDS; b++)
            compare(section, (const enum kind[2]){a, b}, HOBE_METHOD_NEWTON);
    compare(section, (const enum kind[2]){SOFT, STIFF}, HOBE_METHOD_SERIES);
}

static void unstable_are_counted(const hobe_section *section)
{
    const enum kind kinds[2] = {PROPPED, COLUMN};
    check_that(answer_of(section, 2, kinds, HOBE_METHOD_NEWTON).info.negative == 1,
               "a column beyond its critical load, multipliers beside it");
}

/* The one that fails is named; the other is not asked to cut its steps. */
static void failure_is_named(const hobe_section *section)
{
    const struct hobe_newton few = {.max_iterations = 3, .smallest_step = 0.5};
    struct hobe_solution *solution;
    struct hobe_error err;
    hobe_model *model = new_model();
    add(model, section, STIFF);
    add(model, section, SOFT);
    check_that(hobe_static(model, &few, &solution, &err) == HOBE_NOT_CONVERGED &&
                   strstr(err.message, "beam \"soft\"") && !strstr(err.message, "stiff"),
               "%s", err.message);
    hobe_model_free(model);
}

static int is_noted(hobe_model *model, const char *what)
{
    struct hobe_error err;
    int noted = 0;
    if (hobe_model_build(model, &err))
        check_stop("%s", err.message);
    for (int i = 0; hobe_model_note(model, i); i++)
        noted |= strstr(hobe_model_note(model, i), what) != NULL;
    return noted;
}

static void couple(hobe_model *model, int how)
{
    struct hobe_error err;
    const struct hobe_joint joint = {
        .beam = {"soft", "stiff"}, .at = {1, 1}, .kind = HOBE_JOINT_DISTANCE};
    const struct hobe_spring spring = {.beam = {"soft", "stiff"}, .at = {1, 1}, .stiffness = {1e3}};
    if (how == 1)
        add_joint(model, &joint);
    else if (how == 2)
        check_that(!hobe_model_spring(model, &spring, &err), "a spring");
    else if (how == 3)
        hobe_model_spin(model, &(struct hobe_spin){.axis = {0, 0, 1}, .speed = 1}, &err);
}

/* Joints, springs and a spin make one problem of two beams, and so does a join. */
static void couplings(const hobe_section *section)
{
    for (int how = 0; how < 4; how++) {
        hobe_model *model = new_model();
        add(model, section, SOFT);
        add(model, section, STIFF);
        couple(model, how);
        check_that(is_noted(model, "nothing couples") == !how, "coupled by %d", how);
        hobe_model_free(model);
    }
    hobe_model *model = new_model();
    struct hobe_beam beam = beam_along_x("3333", 1, section, E, NU, LENGTH);
    add_beam(model, &beam);
    beam.name = "further";
    beam.from[0] = LENGTH;
    beam.to[0] = 2 * LENGTH;
    add_beam(model, &beam);
    add_clamp(model, "beam", 0, 0);
    add_join(model, "beam", 1, "further", 0);
    check_that(!is_noted(model, "nothing couples"), "joined");
    hobe_model_free(model);
}

/* More beams than there are parts for. */
static void many(const hobe_section *section)
{
    enum { BEAMS = 20 };
    hobe_model *model = new_model();
    char name[BEAMS][16];
    for (int i = 0; i < BEAMS; i++) {
        struct hobe_beam beam = beam_along_x("3333", 1, section, E, NU, LENGTH);
        snprintf(name[i], sizeof name[i], "b%d", i);
        beam.name = name[i];
        beam.from[1] = beam.to[1] = i;
        add_beam(model, &beam);
        add_clamp(model, name[i], 0, 0);
        add_force(model, name[i], 1, 0, 1e5, 1e5);
    }
    hobe_solution *solution = solve(model, 1);
    const struct hobe_point first = point_of(solution, name[0], 1, 0, 0);
    for (int i = 1; i < BEAMS; i++)
        check_absolute(distance(first.u, point_of(solution, name[i], 1, 0, 0).u), 0, 1e-12 * LENGTH,
                       "beam %d of many", i);
    hobe_solution_free(solution);
    hobe_model_free(model);
}

int main(void)
{
    hobe_section *section = rectangle(0.05, 0.08);
    pairs(section);
    unstable_are_counted(section);
    failure_is_named(section);
    couplings(section);
    many(section);
    hobe_section_free(section);
    return check_report();
}
