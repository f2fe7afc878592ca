/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections of every kind, and an element of a composite one, while the n-th of the library's own
 * allocations fails, n = 1, 2, ... */
#include "check.h"
#include "fault.h"

#include <stdio.h>

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

static hobe_section *section_of(int kind, struct hobe_error *err)
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

static enum hobe_status make(void *kind, struct hobe_error *err)
{
    hobe_section *section = section_of(*(const int *)kind, err);
    const enum hobe_status status = section ? HOBE_OK : err->status;
    hobe_section_free(section);
    return status;
}

static enum hobe_status element_on(void *section, struct hobe_error *err)
{
    const struct hobe_element_options options = {
        .kernel = hobe_find_kernel("MGD30w3", err), .section = section, .length = 4};
    hobe_element *element = hobe_element_new(&options, err);
    const enum hobe_status status = element ? HOBE_OK : err->status;
    hobe_element_free(element);
    return status;
}

/* The functions of distortion, which are solved when they are asked for first. */
static enum hobe_status distortion_of(void *section, struct hobe_error *err)
{
    double f[3];
    return hobe_section_function(section, "v1y", .9, .4, f, err);
}

int main(void)
{
    struct hobe_error err;
    for (int kind = 0; kind < KINDS; kind++) {
        char what[20];
        snprintf(what, sizeof what, "kind %d", kind);
        fail_each_allocation(make, &kind, 1, 100, what);
    }
    /* an element whose section has materials and mean strains of its own */
    hobe_section *section = composite(&err);
    if (!section)
        check_stop("%s", err.message);
    fail_each_allocation(element_on, section, 10, 100, "composite element");
    hobe_section_free(section);
    section = hobe_section_hollow(2, 1, .2, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    fail_each_allocation(distortion_of, section, 10, 100, "distortion");
    hobe_section_free(section);
    return check_report();
}
