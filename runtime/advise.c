/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cheapest model that holds an accuracy: coarse runs, what they say of the finest, and models
 * tried in the order of their cost. */
#include "advise.h"

#include "kernel_vectors.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DOUBLINGS = 9 }; /* meshes 1, 2, 4, ... ADVISE_MOST of a sequence */

static const double NOTHING = 1e-12;   /* quantities below it are zero */
static const double SMALL = 0.01;      /* share of the largest of its unit that errors are measured
                                          by at least */
static const double OPEN = 0.25;       /* share of the accuracy that the estimate may leave open */
static const double LEAST_OPEN = 0.02; /* where a choice hangs on it */
static const double SLOW = 1.5, MODEST = 4, HIGH = 16; /* ratios of errors on meshes of n and 2 n */
static const double BETTER = 2; /* how much less a base must leave open than lower ones */
static const double CHEAPEST = 1.0 / 16,
                    CHEAPER = 0.5; /* costs at which other elements are tried */
static const double HOPE = 1.3;    /* times the accuracy that a prediction may miss to be tried */

static const int MESH[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};
enum { MESHES = sizeof MESH / sizeof *MESH };

/* A sequence over meshes, each twice as fine as the one before, and what it tends to. */
struct sequence {
    int count;
    int mesh[DOUBLINGS];
    double *term;         /* [DOUBLINGS][quantities] */
    double *limit, *open; /* [quantities], and how far that may be off */
    double *ratio;        /* [quantities] by which the error of a mesh twice as fine is smaller */
};

/* The quantities Q(s, n) of a level, and what they are above those of the level before, D_s(n). */
enum { OWN, STEP, SEQUENCES };
struct level {
    const struct hobe_kernel *kernel;
    struct sequence of[SEQUENCES];
    int closed[SEQUENCES]; /* it cannot be refined */
};

struct search {
    const struct advise_problem *problem;
    struct advice *advice;
    struct level level[ADVISE_LEVELS];
    int levels;
    int base;      /* Q is the limit of this level's Q(s, n) and of the D above it */
    double *scale; /* [quantities] by which errors are measured */
    double *x;     /* [quantities] what is at hand */
};

/* ---- levels ---------------------------------------------------------------------------------- */

static const struct {
    const char *element, *effect;
} LEVELS[] = {
    {"MGD30", "bending, shear and stretch"},   {"MGD30w", "warping in torsion"},
    {"MGD30w3", "warping in shear"},           {"MGD30d", "distortion of the section"},
    {"MGD30d2", "distortion of second order"},
};
enum { KNOWN = sizeof LEVELS / sizeof *LEVELS };

int advise_levels(const struct hobe_kernel **level)
{
    int levels = 0;
    for (int i = 0; i < KNOWN; i++) {
        const struct hobe_kernel *kernel = hobe_find_kernel(LEVELS[i].element, NULL);
        if (kernel)
            level[levels++] = kernel;
    }
    return levels;
}

const char *advise_step(const struct hobe_kernel *kernel)
{
    for (int i = 0; i < KNOWN; i++)
        if (!strcmp(kernel->name, LEVELS[i].element))
            return LEVELS[i].effect;
    return kernel->name;
}

int advise_same_section(const struct hobe_kernel *a, const struct hobe_kernel *b)
{
    if (a->modes != b->modes || strcmp(a->mechanics, b->mechanics))
        return 0;
    for (int k = 0; k < a->modes; k++)
        if (strcmp(a->mode[k], b->mode[k]))
            return 0;
    return 1;
}

int advise_leave_out(enum advise_without without, struct hobe_material *material)
{
    static const double STIFF = 1000;
    if (without == ADVISE_COMPLETE)
        return 1;
    if (material->k2 != 1 || material->k3 != 1)
        return 0;
    material->average_shear = without == ADVISE_NO_SHEAR;
    material->k2 = material->k3 = without == ADVISE_NO_SHEAR ? STIFF : 1 / (1 + material->nu);
    if (without == ADVISE_NO_POISSON)
        material->nu = 0; /* G = k E/2 is what it was */
    return 1;
}

/* Eliminating s unknowns of a front of w takes about s w^2. */
double advise_cost(const struct advise_model *model, int iterations)
{
    const struct hobe_kernel *kernel = model->kernel;
    const double front = 3 * kernel->vectors, step = 3 * hobe_kernel_step(kernel);
    return iterations * (double)model->elements *
           ((double)kernel->flops_tangent + step * front * front);
}

/* ---- trials ---------------------------------------------------------------------------------- */

static int same_model(const struct advise_model *a, const struct advise_model *b)
{
    return a->kernel == b->kernel && a->elements == b->elements && a->linear == b->linear &&
           a->without == b->without;
}

static const struct advise_trial *find_trial(const struct search *s,
                                             const struct advise_model *model)
{
    for (int i = 0; i < s->advice->trials; i++)
        if (same_model(&s->advice->trial[i].model, model))
            return s->advice->trial + i;
    return NULL;
}

static struct advise_trial *add_trial(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    if (a->trials == a->room) {
        const int room = 2 * a->room + 16;
        void *grown = hobe_grow(a->trial, (size_t)a->room, (size_t)room, sizeof *a->trial, err);
        if (!grown)
            return NULL;
        a->trial = grown;
        a->room = room;
    }
    struct advise_trial *trial = a->trial + a->trials;
    trial->value = hobe_alloc((size_t)s->problem->quantities, sizeof *trial->value, err);
    if (!trial->value)
        return NULL;
    a->trials++;
    return trial;
}

static int all_finite(const double *x, int n)
{
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

static enum hobe_status keep_sentence(struct advise_trial *trial, const char *text,
                                      struct hobe_error *err)
{
    trial->failed = 1;
    trial->why = hobe_alloc(strlen(text) + 1, 1, err);
    if (!trial->why)
        return HOBE_NO_MEMORY;
    strcpy(trial->why, text);
    return HOBE_OK;
}

/* Runs a model, unless it has been; *trial is NULL where it failed. */
static enum hobe_status try_model(struct search *s, const struct advise_model *model,
                                  const struct advise_trial **trial, struct hobe_error *err)
{
    const struct advise_problem *p = s->problem;
    struct hobe_error own;
    int iterations = 0;
    *trial = find_trial(s, model);
    if (!*trial) {
        struct advise_trial *made = add_trial(s, err);
        if (!made)
            return HOBE_NO_MEMORY;
        made->model = *model;
        enum hobe_status status = p->run(p->context, model, made->value, &iterations, &own);
        if (status == HOBE_NO_MEMORY)
            return hobe_fail(err, status, NULL, "%s", own.message);
        if (!status && !all_finite(made->value, p->quantities))
            status = hobe_fail(&own, HOBE_BAD_INPUT, NULL, "a quantity is not a finite number");
        if (status && keep_sentence(made, own.message, err))
            return HOBE_NO_MEMORY;
        made->cost = advise_cost(model, iterations);
        s->advice->cost += made->cost;
        *trial = made;
    }
    if ((*trial)->failed)
        *trial = NULL;
    return HOBE_OK;
}

static struct advise_model plain(const struct hobe_kernel *kernel, int elements)
{
    return (struct advise_model){.kernel = kernel, .elements = elements};
}

/* ---- sequences ------------------------------------------------------------------------------- */

/* The limit of a sequence by its last three terms, on meshes each twice as fine: of errors e, e/r,
 * e/r^2 it is D_2 + (D_2 - D_1)/(r - 1).  0 where they do not settle evenly. */
static int extrapolate(const double *D, int stride, double *limit, double *ratio)
{
    const double before = D[stride] - D[0], step = D[2 * stride] - D[stride];
    const double r = step != 0 ? before / step : HIGH;
    if (!(r >= SLOW))
        return 0;
    *ratio = fmin(r, HIGH);
    *limit = D[2 * stride] + step / (*ratio - 1);
    return 1;
}

/* What a sequence tends to, and by how much that may be off: by its last step, less where its order
 * shows, and where two orders agree by what they differ in.  Two terms say little: of the
 * difference of two levels twice their step, and of a quantity itself, whose step may vanish by
 * chance, nothing.
 */
static void find_limit(int is_step, int count, const double *D, int stride, double *limit,
                       double *open, double *ratio)
{
    const double *last = D + (count - 1) * stride;
    double earlier, earlier_ratio;
    *limit = *last;
    *ratio = 2;
    *open = INFINITY;
    if (count < 2)
        return;
    const double step = fabs(last[0] - last[-stride]);
    if (count > 2 || is_step)
        *open = count > 2 ? step : 2 * step;
    if (count < 3)
        return;
    if (!extrapolate(last - 2 * stride, stride, limit, ratio)) {
        const double before = fabs(last[-stride] - last[-2 * stride]);
        *open = before >= 2 * step ? step : 2 * fmax(step, before);
        return;
    }
    *open = step / (fmin(*ratio, MODEST) - 1);
    if (count > 3 && extrapolate(last - 3 * stride, stride, &earlier, &earlier_ratio))
        *open = fmin(*open, fmax(fabs(*limit - earlier), 0.2 * fabs(*limit - *last)));
}

static void find_limits(const struct search *s, int which, struct sequence *of)
{
    const int n = s->problem->quantities;
    for (int i = 0; i < n; i++)
        find_limit(which == STEP, of->count, of->term + i, n, of->limit + i, of->open + i,
                   of->ratio + i);
}

/* Adds a term: a - b, b NULL: 0.  A sequence begins anew where a mesh is missing. */
static void add_term(const struct search *s, struct level *level, int which, int elements,
                     const double *a, const double *b)
{
    struct sequence *to = level->of + which;
    const int n = s->problem->quantities;
    if (to->count > 0 && to->mesh[to->count - 1] >= elements)
        return;
    if (to->count > 0 && 2 * to->mesh[to->count - 1] != elements)
        to->count = 0;
    double *term = to->term + to->count * n;
    for (int i = 0; i < n; i++)
        term[i] = a[i] - (b ? b[i] : 0);
    to->mesh[to->count++] = elements;
    find_limits(s, which, to);
}

/* Runs a level on a mesh, and adds what that tells of it and the next; *ran: whether it does. */
static enum hobe_status add_mesh(struct search *s, int l, int elements, int *ran,
                                 struct hobe_error *err)
{
    const struct advise_model model = plain(s->level[l].kernel, elements);
    const struct advise_trial *own;
    const enum hobe_status status = try_model(s, &model, &own, err);
    *ran = own != NULL;
    if (status || !own)
        return status;
    add_term(s, &s->level[l], OWN, elements, own->value, NULL);
    for (int above = l; above <= l + 1 && above < s->levels; above++) {
        if (above == 0)
            continue;
        const struct advise_model pair[2] = {plain(s->level[above].kernel, elements),
                                             plain(s->level[above - 1].kernel, elements)};
        const struct advise_trial *a = find_trial(s, &pair[0]), *b = find_trial(s, &pair[1]);
        if (a && b && !a->failed && !b->failed)
            add_term(s, &s->level[above], STEP, elements, a->value, b->value);
    }
    return HOBE_OK;
}

/* One more term, on a mesh twice as fine; where that does not run, the sequence begins anew on the
 * next. */
static enum hobe_status refine(struct search *s, int l, int which, struct hobe_error *err)
{
    const struct sequence *of = &s->level[l].of[which];
    int next = of->count > 0 ? 2 * of->mesh[of->count - 1] : 1, ran = 0;
    enum hobe_status status = HOBE_OK;
    for (int k = 0; !status && !ran && k < 2 && next <= s->problem->most; k++, next *= 2) {
        ran = 1;
        for (int below = 0; !status && ran && below <= which; below++)
            status = add_mesh(s, l - below, next, &ran, err);
    }
    s->level[l].closed[which] = !ran;
    return status;
}

static enum hobe_status open_sequence(struct sequence *of, size_t n, struct hobe_error *err)
{
    of->term = hobe_alloc(DOUBLINGS * n, sizeof *of->term, err);
    of->limit = hobe_alloc(3 * n, sizeof *of->limit, err);
    if (!of->term || !of->limit)
        return HOBE_NO_MEMORY;
    of->open = of->limit + n;
    of->ratio = of->open + n;
    for (size_t i = 0; i < n; i++)
        of->open[i] = INFINITY;
    return HOBE_OK;
}

static void close_level(struct level *level)
{
    for (int k = 0; k < SEQUENCES; k++) {
        hobe_free(level->of[k].term);
        hobe_free(level->of[k].limit);
    }
}

/* Two meshes of a level to begin with, the coarsest that run; none: the level is left out. */
static enum hobe_status start_level(struct search *s, const struct hobe_kernel *kernel,
                                    struct hobe_error *err)
{
    struct level *level = s->level + s->levels++;
    enum hobe_status status = HOBE_OK;
    *level = (struct level){.kernel = kernel};
    for (int k = 0; !status && k < SEQUENCES; k++)
        status = open_sequence(&level->of[k], (size_t)s->problem->quantities, err);
    for (int mesh = 1; !status && level->of[OWN].count < 2 && mesh <= s->problem->most; mesh *= 2) {
        int ran;
        status = add_mesh(s, s->levels - 1, mesh, &ran, err);
    }
    if (!status && level->of[OWN].count == 0)
        close_level(s->level + --s->levels);
    return status;
}

/* ---- the estimate ---------------------------------------------------------------------------- */

/* By what errors are measured. */
static void set_scale(struct search *s)
{
    const struct advise_problem *p = s->problem;
    const double *best = s->advice->best;
    for (int i = 0; i < p->quantities; i++) {
        double size = fabs(best[i]);
        for (int j = 0; p->unit[i] && j < p->quantities; j++)
            if (p->unit[j] && !strcmp(p->unit[i], p->unit[j]))
                size = fmax(size, SMALL * fabs(best[j]));
        s->scale[i] = size > NOTHING ? size : INFINITY;
    }
}

/* The largest |a - b| over the quantities; b NULL: 0. */
static struct advise_loss loss_of(const struct search *s, const double *a, const double *b)
{
    struct advise_loss loss = {0, 0};
    for (int i = 0; i < s->problem->quantities; i++) {
        const double size = fabs(a[i] - (b ? b[i] : 0)) / s->scale[i];
        if (isfinite(s->scale[i]) && !(size <= loss.size))
            loss = (struct advise_loss){size, i};
    }
    return loss;
}

/* The sequence that level l adds to the estimate, with a level as its base. */
static const struct sequence *part_of(const struct search *s, int l, int base)
{
    return &s->level[l].of[l == base ? OWN : STEP];
}

/* The estimate with a level as its base: best, scale, and what is open. */
static void estimate_from(struct search *s, int base)
{
    struct advice *a = s->advice;
    const int n = s->problem->quantities;
    for (int i = 0; i < n; i++) {
        a->best[i] = s->x[i] = 0;
        for (int l = base; l < s->levels; l++) {
            a->best[i] += part_of(s, l, base)->limit[i];
            s->x[i] += part_of(s, l, base)->open[i];
        }
    }
    set_scale(s);
    s->base = base;
    a->open = loss_of(s, s->x, NULL).size;
}

/* That with the base which leaves least open: levels that have little to do with the scene only
 * add what is open of them.  Lower ones are cheaper to refine. */
static void estimate(struct search *s)
{
    double least = INFINITY;
    int base = 0;
    for (int b = 0; b < s->levels; b++) {
        estimate_from(s, b);
        if (s->advice->open < least / BETTER) {
            least = s->advice->open;
            base = b;
        }
    }
    estimate_from(s, base);
}

/* Refines where most is open until little is. */
static enum hobe_status settle(struct search *s, double open, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (estimate(s); !status && s->advice->open > open * s->problem->accuracy; estimate(s)) {
        int worst = -1;
        double most = 0;
        for (int l = s->base; l < s->levels; l++) {
            const double size = loss_of(s, part_of(s, l, s->base)->open, NULL).size;
            if (s->level[l].closed[l != s->base] || size <= most)
                continue;
            most = size;
            worst = l;
        }
        if (worst < 0)
            break;
        status = refine(s, worst, worst != s->base, err);
    }
    return status;
}

/* ---- the choice ------------------------------------------------------------------------------ */

/* A term on any mesh: as run, or by the errors of the meshes around it, between which they are
 * taken to be a power of the mesh. */
static double term_at(const struct sequence *of, int n, int elements, int i)
{
    const int last = of->count - 1;
    int k = 0;
    if (last < 0)
        return 0;
    while (k < last && of->mesh[k + 1] <= elements)
        k++;
    const double error = of->term[k * n + i] - of->limit[i];
    double shrink = of->ratio[i];
    if (elements <= of->mesh[k])
        return of->term[k * n + i];
    if (k < last) {
        const double next = of->term[(k + 1) * n + i] - of->limit[i];
        shrink = next * error > 0 ? error / next : 2;
    }
    return of->limit[i] + error * pow((double)elements / of->mesh[k], -log2(shrink));
}

/* x = what a level would give on a mesh; elements 0: its limit. */
static void predict(const struct search *s, int level, int elements, double *x)
{
    const int n = s->problem->quantities, base = level < s->base ? level : s->base;
    for (int i = 0; i < n; i++) {
        x[i] = 0;
        for (int l = base; l <= level; l++) {
            const struct sequence *of = part_of(s, l, base);
            x[i] += elements ? term_at(of, n, elements, i) : of->limit[i];
        }
    }
}

/* Whether a trial is within the accuracy; *error is its own, what is open included. */
static int holds(const struct search *s, const struct advise_trial *trial,
                 struct advise_loss *error)
{
    *error = loss_of(s, trial->value, s->advice->best);
    error->size += s->advice->open;
    return error->size <= s->problem->accuracy;
}

/* Takes a trial. */
static void take(struct search *s, const struct advise_trial *trial, int held,
                 struct advise_loss error)
{
    s->advice->model = (int)(trial - s->advice->trial);
    s->advice->holds = held;
    s->advice->error = error;
}

/* The iterations that a level takes, by its finest mesh so far. */
static int usual_iterations(const struct search *s, const struct level *level)
{
    const struct sequence *own = &level->of[OWN];
    const struct advise_model model = plain(level->kernel, own->mesh[own->count - 1]);
    return (int)lround(find_trial(s, &model)->cost / advise_cost(&model, 1));
}

/* Runs the models up to a cost that the estimate gives hope, the cheapest first, until one holds;
 * failing that the nearest is taken. */
static enum hobe_status choose(struct search *s, struct hobe_error *err)
{
    double done = 0;
    s->advice->model = -1;
    s->advice->holds = 0;
    for (;;) {
        struct advise_model next = {0};
        double cheapest = INFINITY;
        int level = 0;
        for (int l = 0; l < s->levels; l++)
            for (int k = 0; k < MESHES && MESH[k] <= s->problem->most; k++) {
                const struct advise_model model = plain(s->level[l].kernel, MESH[k]);
                const double cost = advise_cost(&model, usual_iterations(s, s->level + l));
                if (cost <= done || cost >= cheapest)
                    continue;
                next = model;
                cheapest = cost;
                level = l;
            }
        if (!next.kernel)
            return HOBE_OK;
        done = cheapest;
        const struct advise_trial *trial = find_trial(s, &next);
        predict(s, level, next.elements, s->x);
        if (!trial && loss_of(s, s->x, s->advice->best).size > HOPE * s->problem->accuracy)
            continue;
        const enum hobe_status status = try_model(s, &next, &trial, err);
        if (status)
            return status;
        struct advise_loss error;
        const int held = trial && holds(s, trial, &error);
        if (trial && (held || s->advice->model < 0 || error.size < s->advice->error.size))
            take(s, trial, held, error);
        if (held)
            return HOBE_OK;
    }
}

/* Whether what is open of the estimate decides: one that costs less than half may hold, too. */
static int hangs(const struct search *s)
{
    const struct advice *a = s->advice;
    if (a->model < 0)
        return 0;
    for (int i = 0; i < a->trials; i++) {
        const struct advise_trial *trial = a->trial + i;
        if (trial->failed || trial->model.linear || trial->model.without)
            continue;
        if (a->holds && trial->cost > 0.5 * a->trial[a->model].cost)
            continue;
        if (loss_of(s, trial->value, a->best).size - a->open < s->problem->accuracy &&
            i != a->model)
            return 1;
    }
    return 0;
}

/* Runs an element on meshes that cost less than half of the model taken, until one holds. */
static enum hobe_status try_element(struct search *s, const struct hobe_kernel *kernel, int linear,
                                    struct hobe_error *err)
{
    const struct advise_trial taken = s->advice->trial[s->advice->model];
    const int iterations = linear ? 1 : (int)lround(taken.cost / advise_cost(&taken.model, 1));
    for (int k = 0; k < MESHES && MESH[k] <= s->problem->most; k++) {
        const struct advise_model model = {.kernel = kernel, .elements = MESH[k], .linear = linear};
        const double cost = advise_cost(&model, iterations) / taken.cost;
        const struct advise_trial *trial;
        struct advise_loss error;
        if (cost < CHEAPEST || cost > CHEAPER)
            continue;
        const enum hobe_status status = try_model(s, &model, &trial, err);
        if (status)
            return status;
        if (trial && holds(s, trial, &error)) {
            take(s, trial, 1, error);
            return HOBE_OK;
        }
    }
    return HOBE_OK;
}

/* Tries the elements that have the section modes of the model taken. */
static enum hobe_status try_twins(struct search *s, struct hobe_error *err)
{
    const struct hobe_kernel *taken = s->advice->trial[s->advice->model].model.kernel;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && hobe_kernels()[i]; i++)
        if (hobe_kernels()[i] != taken && advise_same_section(hobe_kernels()[i], taken))
            status = try_element(s, hobe_kernels()[i], 0, err);
    return status;
}

/* ---- evidence -------------------------------------------------------------------------------- */

/* Weighs what the linear response loses, and takes it where it holds: what it loses and what its
 * mesh does may cancel. */
static enum hobe_status try_linear(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    struct advise_model model = a->trial[a->model].model;
    const struct advise_trial *trial;
    model.linear = 1;
    const enum hobe_status status = try_model(s, &model, &trial, err);
    if (status || !trial)
        return status;
    a->linear = loss_of(s, trial->value, a->trial[a->model].value);
    if (!s->problem->takes_linear || a->linear.size > 2 * s->problem->accuracy)
        return HOBE_OK;
    return try_element(s, model.kernel, 1, err);
}

/* What the chosen model would lose without what it has in any case. */
static enum hobe_status try_without(struct search *s, struct hobe_error *err)
{
    struct advice *a = s->advice;
    for (int w = ADVISE_COMPLETE + 1; w < ADVISE_WITHOUTS; w++) {
        struct advise_model model = a->trial[a->model].model;
        const struct advise_trial *trial;
        model.without = (enum advise_without)w;
        const enum hobe_status status = try_model(s, &model, &trial, err);
        if (status)
            return status;
        if (trial)
            a->without[w] = loss_of(s, trial->value, a->trial[a->model].value);
    }
    return HOBE_OK;
}

/* What each step between levels is worth, and what the chosen mesh leaves open. */
static void weigh_levels(struct search *s)
{
    struct advice *a = s->advice;
    const struct advise_model *taken = &a->trial[a->model].model;
    const struct advise_model twin = plain(taken->kernel, taken->elements);
    for (int l = 0, at = 0; l < s->levels; l++) {
        while (s->problem->level[at] != s->level[l].kernel)
            at++;
        if (l > 0 && s->level[l].of[STEP].count > 0)
            a->level[at] = loss_of(s, s->level[l].of[STEP].limit, NULL);
        if (advise_same_section(s->level[l].kernel, taken->kernel) && find_trial(s, &twin)) {
            predict(s, l, 0, s->x);
            a->mesh = loss_of(s, find_trial(s, &twin)->value, s->x);
        }
    }
}

/* ---- all of it ------------------------------------------------------------------------------- */

static enum hobe_status open_search(struct search *s, const struct advise_problem *problem,
                                    struct advice *advice, struct hobe_error *err)
{
    const size_t n = (size_t)problem->quantities;
    *advice = (struct advice){.problem = problem, .model = -1, .linear = {NAN, 0}};
    for (int i = 0; i < ADVISE_WITHOUTS; i++)
        advice->without[i].size = NAN;
    for (int l = 1; l < ADVISE_LEVELS; l++)
        advice->level[l].size = NAN;
    *s = (struct search){.problem = problem, .advice = advice};
    advice->best = hobe_alloc(n, sizeof *advice->best, err);
    s->scale = hobe_alloc(n, sizeof *s->scale, err);
    s->x = hobe_alloc(n, sizeof *s->x, err);
    return advice->best && s->scale && s->x ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The levels that run; at least one. */
static enum hobe_status start_levels(struct search *s, struct hobe_error *err)
{
    const struct advise_problem *p = s->problem;
    for (int l = 0; l < p->levels; l++) {
        const enum hobe_status status = start_level(s, p->level[l], err);
        if (status)
            return status;
    }
    if (s->levels > 0)
        return HOBE_OK;
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL, "no model of the scene runs: %.900s",
                     s->advice->trial[s->advice->trials - 1].why);
}

static enum hobe_status search(struct search *s, struct hobe_error *err)
{
    enum hobe_status status = start_levels(s, err);
    for (double open = OPEN; !status && open > LEAST_OPEN; open /= 4) {
        status = settle(s, open, err);
        if (!status)
            status = choose(s, err);
        if (!status && s->advice->holds && !hangs(s))
            break;
    }
    if (!status)
        status = try_twins(s, err);
    if (!status && (s->problem->weighs_linear || s->problem->takes_linear))
        status = try_linear(s, err);
    if (!status)
        status = try_without(s, err);
    if (!status)
        weigh_levels(s);
    return status;
}

enum hobe_status advise(const struct advise_problem *problem, struct advice *advice,
                        struct hobe_error *err)
{
    struct search s;
    enum hobe_status status = open_search(&s, problem, advice, err);
    if (!status)
        status = search(&s, err);
    for (int l = 0; l < s.levels; l++)
        close_level(s.level + l);
    hobe_free(s.scale);
    hobe_free(s.x);
    return status;
}

void advice_free(struct advice *advice)
{
    for (int i = 0; i < advice->trials; i++) {
        hobe_free(advice->trial[i].value);
        hobe_free(advice->trial[i].why);
    }
    hobe_free(advice->trial);
    hobe_free(advice->best);
    *advice = (struct advice){0};
}
