/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections of every kind, and an element of a composite one, while the n-th of the library's own
 * allocations fails, n = 1, 2, ... */
#include "check.h"
#include "hobe.h"

#include <stdio.h>
#include <string.h>

enum { KINDS = 6 };

static hobe_section *composite(struct hobe_error *err)
{
    static const struct hobe_material m = {1, 0, 0, 1, 1, 0};
    hobe_section *core = hobe_section_circle(1, err), *made = NULL;
    hobe_section *sleeve = core ? hobe_section_tube(2, 1, err) : NULL;
    if (sleeve)
        made = hobe_section_composite(
            2, (struct hobe_section_part[]){{core, {0, 0}, m}, {sleeve, {0, 0}, m}}, err);
    hobe_section_free(core);
    hobe_section_free(sleeve);
    return made;
}

static hobe_section *make(int kind, struct hobe_error *err)
{
    static const double corner[6][2] = {{0, 0}, {3, 0}, {3, 2}, {1, .5}, {2, .5}, {2, 1}};
    static const struct hobe_profile_sizes sizes = {
        .height = .2, .width = .1, .flange = .02, .web = .02};
    static const char list[] = "0 0\n3 0\n0 4\n";
    static const struct hobe_outline_file file = {
        .name = "list", .text = list, .size = sizeof list - 1};
    switch (kind) {
    case 0:
        return hobe_section_tube(2, 1, err);
    case 1:
        return hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_PAPER, err);
    case 2:
        return hobe_section_polygon(2, (const int[]){3, 3}, corner, err);
    case 3:
        return hobe_section_file(&file, err);
    case 4:
        return composite(err);
    default:
        return hobe_section_hollow(2, 1, .2, HOBE_WARPING_SOLVED, err);
    }
}

static void check_failure(int made, long n, long seen, const struct hobe_error *err,
                          const char *what)
{
    if (seen >= n)
        check_that(!made && err->status == HOBE_NO_MEMORY &&
                       strncmp(err->message, "out of memory", 13) == 0,
                   "%s, allocation %ld of %ld: %s", what, n, seen, err->message);
    else
        check_that(made, "nothing failed: %s", err->message);
}

static void sections(int kind)
{
    char what[20];
    long n = 0, seen;
    snprintf(what, sizeof what, "kind %d", kind);
    do {
        struct hobe_error err = {0};
        hobe_fail_allocation(++n);
        hobe_section *section = make(kind, &err);
        seen = hobe_fail_allocation(0);
        check_failure(section != NULL, n, seen, &err, what);
        hobe_section_free(section);
    } while (seen >= n && n < 100);
    printf("%s: %ld allocations\n", what, n - 1);
}

/* An element whose section has materials and mean strains of its own. */
static void composite_element(void)
{
    struct hobe_error err = {0};
    hobe_section *section = composite(&err);
    if (!section)
        check_stop("%s", err.message);
    const struct hobe_element_options options = {
        .kernel = hobe_find_kernel("MGD30w3", &err), .section = section, .length = 4};
    long n = 0, seen;
    do {
        err = (struct hobe_error){0};
        hobe_fail_allocation(++n);
        hobe_element *element = hobe_element_new(&options, &err);
        seen = hobe_fail_allocation(0);
        check_failure(element != NULL, n, seen, &err, "composite element");
        hobe_element_free(element);
    } while (seen >= n && n < 100);
    hobe_section_free(section);
}

/* The functions of distortion, asked for of a section that is solved. */
static void distortion(void)
{
    long n = 0, seen;
    do {
        struct hobe_error err = {0};
        double f[3];
        hobe_section *section = hobe_section_hollow(2, 1, .2, HOBE_WARPING_SOLVED, &err);
        if (!section)
            check_stop("%s", err.message);
        hobe_fail_allocation(++n);
        const enum hobe_status status = hobe_section_function(section, "v1y", .9, .4, f, &err);
        seen = hobe_fail_allocation(0);
        check_failure(status == HOBE_OK, n, seen, &err, "distortion");
        hobe_section_free(section);
    } while (seen >= n && n < 100);
}

int main(void)
{
    for (int kind = 0; kind < KINDS; kind++)
        sections(kind);
    composite_element();
    distortion();
    return check_report();
}
