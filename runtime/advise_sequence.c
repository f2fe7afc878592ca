/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sequences over meshes, their limits, and the estimate of the finest model that they add up to. */
#include "advise_search.h"

#include <math.h>
#include <string.h>

static const double NOTHING = 1e-12; /* quantities below it are zero */
static const double SMALL = 0.01;    /* share of the largest of its unit that errors are measured
                                        by at least */
static const double SLOW = 1.5, MODEST = 4, SURE = 5,
                    HIGH = 16;  /* ratios of errors on meshes of n and 2 n */
static const double BETTER = 2; /* how much less a base must leave open than lower ones */

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
 * shows, and where two orders agree by what they differ in, or by what a mesh twice as fine would
 * leave: slow sequences agree by chance while a layer at an end is still too thin for them.  Two
 * terms say little: of the difference of two levels twice their step, and of a quantity itself,
 * whose step may vanish by chance, nothing. */
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
        *open =
            fmin(*open, fmax(fabs(*limit - earlier), fabs(*limit - *last) / fmin(*ratio, SURE)));
}

/* The last step of a sequence that does not settle yet, or has but two terms. */
static double slow_step(int count, const double *D, int stride)
{
    const double *last = D + (count - 1) * stride;
    double limit, ratio;
    if (count < 2 || (count > 2 && extrapolate(last - 2 * stride, stride, &limit, &ratio)))
        return 0;
    return fabs(last[0] - last[-stride]);
}

static void find_limits(const struct search *s, int which, struct sequence *of)
{
    const int n = s->problem->quantities;
    for (int i = 0; i < n; i++) {
        find_limit(which == STEP, of->count, of->term + i, n, of->limit + i, of->open + i,
                   of->ratio + i);
        of->slow[i] = slow_step(of->count, of->term + i, n);
    }
}

void advise_add_term(const struct search *s, struct sequence *to, int which, int elements,
                     const double *a, const double *b)
{
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
    const enum hobe_status status = advise_try_model(s, &model, &own, err);
    *ran = own != NULL;
    if (status || !own)
        return status;
    advise_add_term(s, &s->level[l].of[OWN], OWN, elements, own->value, NULL);
    for (int above = l; above <= l + 1 && above < s->levels; above++) {
        if (above == 0)
            continue;
        const struct advise_model pair[2] = {plain(s->level[above].kernel, elements),
                                             plain(s->level[above - 1].kernel, elements)};
        const struct advise_trial *a = advise_find_trial(s, &pair[0]),
                                  *b = advise_find_trial(s, &pair[1]);
        if (a && b && !a->failed && !b->failed)
            advise_add_term(s, &s->level[above].of[STEP], STEP, elements, a->value, b->value);
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
    for (int k = 0; !status && !ran && k < 2 && next <= BEYOND * s->problem->most; k++, next *= 2) {
        ran = 1;
        for (int below = 0; !status && ran && below <= which; below++)
            status = add_mesh(s, l - below, next, &ran, err);
    }
    s->level[l].closed[which] = !ran;
    return status;
}

enum hobe_status advise_open_sequence(struct sequence *of, size_t n, struct hobe_error *err)
{
    of->term = hobe_alloc(DOUBLINGS * n, sizeof *of->term, err);
    of->limit = hobe_alloc(4 * n, sizeof *of->limit, err);
    if (!of->term || !of->limit)
        return HOBE_NO_MEMORY;
    of->open = of->limit + n;
    of->ratio = of->open + n;
    of->slow = of->ratio + n;
    for (size_t i = 0; i < n; i++)
        of->open[i] = INFINITY;
    return HOBE_OK;
}

void advise_close_sequence(struct sequence *of)
{
    hobe_free(of->term);
    hobe_free(of->limit);
}

void advise_close_level(struct level *level)
{
    for (int k = 0; k < SEQUENCES; k++)
        advise_close_sequence(level->of + k);
}

enum hobe_status advise_start_level(struct search *s, const struct hobe_kernel *kernel,
                                    struct hobe_error *err)
{
    struct level *level = s->level + s->levels++;
    enum hobe_status status = HOBE_OK;
    *level = (struct level){.kernel = kernel};
    for (int k = 0; !status && k < SEQUENCES; k++)
        status = advise_open_sequence(&level->of[k], (size_t)s->problem->quantities, err);
    for (int mesh = 1; !status && level->of[OWN].count < 2 && mesh <= s->problem->most; mesh *= 2) {
        int ran;
        status = add_mesh(s, s->levels - 1, mesh, &ran, err);
    }
    if (!status && level->of[OWN].count == 0)
        advise_close_level(s->level + --s->levels);
    return status;
}

/* ---- the estimate ---------------------------------------------------------------------------- */

void advise_set_scale(struct search *s)
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

struct advise_loss advise_loss_of(const struct search *s, const double *a, const double *b)
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

/* What a sequence leaves open of the estimate with a level as its base, [quantities]; NULL:
 * nothing. Of the steps from level to level that the base itself takes, what is slow: that hides in
 * the quantity while more of it still converges fast. */
static const double *open_of(const struct search *s, int l, int which, int base)
{
    const struct sequence *of = &s->level[l].of[which];
    if (l <= base && which == STEP)
        return l > 0 && !s->level[l].closed[STEP] ? of->slow : NULL;
    return part_of(s, l, base) == of ? of->open : NULL;
}

/* The estimate with a level as its base: best, scale, and what is open. */
static void estimate_from(struct search *s, int base)
{
    struct advice *a = s->advice;
    const int n = s->problem->quantities;
    for (int i = 0; i < n; i++) {
        a->best[i] = s->x[i] = 0;
        for (int l = base; l < s->levels; l++)
            a->best[i] += part_of(s, l, base)->limit[i];
        for (int k = 0; k < SEQUENCES * s->levels; k++) {
            const double *open = open_of(s, k / SEQUENCES, k % SEQUENCES, base);
            s->x[i] += open ? open[i] : 0;
        }
    }
    advise_set_scale(s);
    s->base = base;
    a->open = advise_loss_of(s, s->x, NULL).size;
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

void advise_predict(const struct search *s, int level, int elements, double *x)
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

enum hobe_status advise_settle(struct search *s, double open, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (estimate(s); !status && s->advice->open > open * s->accuracy; estimate(s)) {
        int worst = -1;
        double most = 0;
        for (int k = 0; k < SEQUENCES * s->levels; k++) {
            const int l = k / SEQUENCES, which = k % SEQUENCES;
            const double *of = open_of(s, l, which, s->base);
            const double size = of ? advise_loss_of(s, of, NULL).size : 0;
            if (s->level[l].closed[which] || size <= most)
                continue;
            most = size;
            worst = k;
        }
        if (worst < 0)
            break;
        status = refine(s, worst / SEQUENCES, worst % SEQUENCES, err);
    }
    return status;
}
