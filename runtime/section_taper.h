/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections that vary along the beam. */
#ifndef HOBE_SECTION_TAPER_H
#define HOBE_SECTION_TAPER_H

#include "section.h"

/* What a kind of section must tell so that a taper can be made of it.
 *
 * Its *numbers* say all about a section of the kind: the sizes of a rectangle, the points of an
 * outline.  Along the beam they are smooth functions of x, and so are the section functions at
 * fixed y and z, whose derivative by x the strain of a tapered beam needs (eq. 38). */
struct hobe_section_sizes {
    int (*count)(const hobe_section *section); /* 0 where this one cannot taper */
    void (*read)(const hobe_section *section, double *numbers);
    /* A section like `like` with other numbers.  `bare` is cheap: it serves for functions, where
     * they are known in closed form, for probes, and for rules of kernels without functions. */
    hobe_section *(*make)(const hobe_section *like, const double *numbers, int bare,
                          struct hobe_error *err);
    const struct hobe_section_field *field; /* NULL: the functions are known in closed form */
};

/* Of a kind whose functions are solved: one mesh that moves with the outline along the beam.  Its
 * *values*, places and functions at the nodes, are smooth functions of x. */
struct hobe_section_field {
    /* Prepares the mesh of `like`, which must outlive the field; *values: how many there are. */
    void *(*open)(const hobe_section *like, int *values, struct hobe_error *err);
    /* The values at given numbers, dimensionless and of like magnitude. */
    enum hobe_status (*solve)(const void *field, const double *numbers, double *values,
                              struct hobe_error *err);
    /* The field at a place, from values[2][values]: the values there and their derivatives by the
     * fraction of the length.  By it are f[..][3] of what follows. */
    void *(*open_at)(const void *field, const double *values, struct hobe_error *err);
    enum hobe_status (*rule)(const void *here, struct hobe_rule *rule, struct hobe_error *err);
    void (*functions)(const void *here, double y, double z, double (*f)[4]);
    /* The surface, numbered alike all along the beam. */
    enum hobe_status (*surface)(const void *here, struct hobe_surface *surface,
                                struct hobe_error *err);
    void (*close_at)(void *here);
    void (*close)(void *field);
};

#endif
