/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections of the same content are solved once while they are in use, by however many threads; the
 * last bit makes another content. */
#include "check.h"
#include "hobe.h"
#include "scene.h"
#include "section_cache.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

/* ---- outlines ------------------------------------------------------------------------------- */

static const struct hobe_profile_sizes SIZES = {.height = 2, .width = 1, .flange = .25, .web = .25};
/* The corners of the same I, to the last bit. */
static const double I[12][2] = {{-.5, -1},   {.5, -1},     {.5, -.75},    {.125, -.75},
                                {.125, .75}, {.5, .75},    {.5, 1},       {-.5, 1},
                                {-.5, .75},  {-.125, .75}, {-.125, -.75}, {-.5, -.75}};

/* The polygon, and whether it was solved: the solution takes many allocations. */
static hobe_section *polygon(const double (*point)[2], int *solved)
{
    struct hobe_error err;
    hobe_fail_allocation(0);
    hobe_section *section = hobe_section_polygon(1, (const int[]){12}, point, &err);
    const long allocations = hobe_fail_allocation(0);
    if (!section)
        check_stop("%s", err.message);
    *solved = allocations > 12;
    printf("%ld allocations: %s\n", allocations, hobe_section_text(section));
    return section;
}

static void same_section(const hobe_section *a, const hobe_section *b)
{
    const struct hobe_section_properties p = properties_of(a), q = properties_of(b);
    double f[3], g[3];
    struct hobe_error err;
    check_that(memcmp(&p, &q, sizeof p) == 0, "the same properties");
    hobe_section_function(a, "w", .3, .9, f, &err);
    hobe_section_function(b, "w", .3, .9, g, &err);
    check_that(memcmp(f, g, sizeof f) == 0, "the same function w");
}

static void outlines(void)
{
    struct hobe_error err;
    double other[12][2], turned[12][2];
    int solved;
    memcpy(other, I, sizeof I);
    other[7][1] = nextafter(1, 2);
    for (int i = 0; i < 12; i++)
        memcpy(turned[i], I[(12 - i) % 12], sizeof *I);
    hobe_section *first = polygon(I, &solved);
    check_that(solved, "the first is solved");
    hobe_section *second = polygon(I, &solved);
    check_that(!solved, "the second is not");
    hobe_section *third = polygon((const double(*)[2])turned, &solved);
    check_that(!solved, "nor is one that runs the other way round");
    hobe_section *changed = polygon((const double(*)[2])other, &solved);
    check_that(solved, "one bit makes another section");
    same_section(first, second);
    same_section(first, third);
    hobe_section_free(first);
    hobe_section_free(third);
    hobe_section *profile = hobe_section_profile(HOBE_PROFILE_I, &SIZES, HOBE_WARPING_PAPER, &err);
    if (!profile)
        check_stop("%s", err.message);
    const struct hobe_section_properties p = properties_of(profile), q = properties_of(second);
    check_that(p.J_w != q.J_w, "another warping function is another content");
    check_relative(p.J, q.J, 1e-4, "J, on triangles that end at the seams of eq. 34");
    check_that(strstr(hobe_section_text(second), "polygon") != NULL, "each has its own text: %s",
               hobe_section_text(second));
    hobe_section_free(profile);
    hobe_section_free(changed);
    hobe_section_free(second);
    hobe_section_free(polygon(I, &solved));
    check_that(solved, "what nobody uses is forgotten");
}

/* Two squares, the upper one of that modulus. */
static hobe_section *composite(double E, int *solved)
{
    struct hobe_error err;
    hobe_section *half = hobe_section_rectangle(1, 1, HOBE_WARPING_SERIES, &err);
    if (!half)
        check_stop("%s", err.message);
    const struct hobe_section_part part[2] = {
        {.section = half, .material = {.E = 2, .nu = .3, .k2 = 1, .k3 = 1}},
        {.section = half, .material = {.E = E, .nu = .3, .k2 = 1, .k3 = 1}, .at = {0, 1}}};
    hobe_fail_allocation(0);
    hobe_section *section = hobe_section_composite(2, part, &err);
    const long allocations = hobe_fail_allocation(0);
    if (!section)
        check_stop("%s", err.message);
    *solved = allocations > 20;
    printf("%ld allocations: %s\n", allocations, hobe_section_text(section));
    hobe_section_free(half);
    return section;
}

static void composites(void)
{
    int solved;
    hobe_section *first = composite(1, &solved);
    check_that(solved, "the first is solved");
    hobe_section *second = composite(1, &solved);
    check_that(!solved, "the second is not");
    hobe_section *softer = composite(nextafter(1, 0), &solved);
    check_that(solved, "one bit of a modulus makes another section");
    same_section(first, second);
    hobe_section_free(first);
    hobe_section_free(second);
    hobe_section_free(softer);
}

/* ---- threads -------------------------------------------------------------------------------- */

enum { THREADS = 8, TURNS = 2000, CONTENTS = 3 };
static atomic_long solutions[CONTENTS + 1], made, closed, wrong;

/* A section whose solution is a number. */
static enum hobe_status double_it(hobe_section *section, struct hobe_error *err)
{
    if (section->properties.yc < 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "negative");
    section->properties.A = 2 * section->properties.yc;
    solutions[(int)section->properties.yc]++;
    return HOBE_OK;
}

static void count_closed(hobe_section *section)
{
    (void)section;
    closed++;
}

static const hobe_section *shared(double content, struct hobe_error *err)
{
    static const struct hobe_section_kind kind = {.close = count_closed};
    hobe_section *section = hobe_alloc(1, sizeof *section, err);
    if (!section)
        return NULL;
    made++;
    section->kind = &kind;
    section->properties.yc = content;
    return hobe_section_share(section, &content, 1, double_it, err);
}

static void *user(void *start)
{
    const hobe_section *held[CONTENTS] = {0};
    for (int turn = *(int *)start; turn < TURNS; turn++) {
        const hobe_section **h = held + turn * 7 % CONTENTS;
        const double content = 1 + turn * 7 % CONTENTS;
        if (*h)
            hobe_section_drop(*h);
        *h = turn % 5 ? shared(content, NULL) : NULL;
        if (*h && (*h)->properties.A != 2 * content)
            wrong++;
    }
    for (int c = 0; c < CONTENTS; c++)
        if (held[c])
            hobe_section_drop(held[c]);
    return NULL;
}

/* One content is in use all the time, the others come and go. */
static void threads(void)
{
    pthread_t thread[THREADS];
    int start[THREADS];
    const hobe_section *one = shared(1, NULL);
    for (int t = 0; t < THREADS; t++) {
        start[t] = t;
        if (pthread_create(thread + t, NULL, user, start + t))
            check_stop("no thread");
    }
    for (int t = 0; t < THREADS; t++)
        pthread_join(thread[t], NULL);
    printf("%ld sections; solutions: %ld, %ld, %ld\n", (long)made, (long)solutions[1],
           (long)solutions[2], (long)solutions[3]);
    check_that(wrong == 0, "%ld sections of another content", (long)wrong);
    check_that(solutions[1] == 1, "what is in use is solved once, not %ld times",
               (long)solutions[1]);
    check_that(closed == made - 1, "all others are freed: %ld of %ld", (long)closed, (long)made);
    hobe_section_drop(one);
    check_that(closed == made, "the last as well");
}

static void failures(void)
{
    struct hobe_error err = {0};
    check_that(!shared(-1, &err) && !strcmp(err.message, "negative"), "an error of the solution");
    hobe_fail_allocation(2);
    const hobe_section *section = shared(1, &err);
    hobe_fail_allocation(0);
    check_that(!section && err.status == HOBE_NO_MEMORY, "no memory for the entry");
}

int main(void)
{
    outlines();
    composites();
    threads();
    failures();
    return check_report();
}
