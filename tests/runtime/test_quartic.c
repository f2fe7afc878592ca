/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a model on a few fields is that of its elements, with its derivatives: prismatic,
 * tapered and curved beams, beams that share vectors, at rest and about other states.  Looks into
 * the core (quartic.h). */
#include "quartic.h"

#include "assemble.h"
#include "check.h"
#include "scene.h"
#include "tangent.h"

#include <math.h>
#include <string.h>

static const double E = 70e9, NU = 0.3;

/* ---- scenes ---------------------------------------------------------------------------------- */

static hobe_section *i_section(void)
{
    struct hobe_error err;
    const struct hobe_profile_sizes sizes = {
        .width = 0.1, .height = 0.2, .flange = 0.01, .web = 0.008};
    hobe_section *section =
        hobe_section_profile(HOBE_PROFILE_I, &sizes, HOBE_WARPING_SOLVED, &err);
    if (!section)
        check_stop("%s", err.message);
    return section;
}

static enum hobe_status arc(void *context, double t, double *r, struct hobe_error *err)
{
    (void)context;
    (void)err;
    r[0] = 2 * sin(t);
    r[1] = 2 * cos(t);
    r[2] = 0.3 * t;
    return HOBE_OK;
}
