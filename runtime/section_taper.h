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
    int (*count)(const hobe_section *section);
    void (*read)(const hobe_section *section, double *numbers);
    /* A section like `like` with other numbers; `bare`: it serves for its functions and probes
     * only, and is cheap. */
    hobe_section *(*make)(const hobe_section *like, const double *numbers, int bare,
                          struct hobe_error *err);
};

#endif
