/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections of several outlines, each of its material. */
#include "material.h"
#include "section_shape.h"

#include <math.h>
#include <stdio.h>

/* Part k with its material and its outline moved to its place. */
static enum hobe_status add_part(struct shape *s, int k, const struct hobe_section_part *part,
                                 struct hobe_error *err)
{
    if (part->section->material)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "it is a composite section itself; give its parts instead");
    if (!part->section->kind->outline)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "its section varies along the beam, which a part's must not");
    if (!isfinite(part->at[0]) || !isfinite(part->at[1]))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "at must be finite (m), got (%g, %g)",
                         part->at[0], part->at[1]);
    s->base.material[k] = part->material;
    enum hobe_status status = hobe_material_check(&part->material, err);
    if (!status)
        status = part->section->kind->outline(part->section, s->outline + k, err);
    if (!status)
        hobe_outline_move(s->outline + k, part->at[0], part->at[1]);
    return status;
}

static enum hobe_status add_parts(struct shape *s, const struct hobe_section_part *part,
                                  struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    s->base.material = hobe_alloc((size_t)s->base.regions, sizeof *s->base.material, err);
    if (!s->base.material)
        return HOBE_NO_MEMORY;
    for (int k = 0; !status && k < s->base.regions; k++) {
        char name[20];
        snprintf(name, sizeof name, "part %d", k + 1);
        status = add_part(s, k, part + k, err);
        if (status)
            hobe_fail_in(err, name);
    }
    return status;
}

hobe_section *hobe_section_composite(int parts, const struct hobe_section_part *part,
                                     struct hobe_error *err)
{
    if (parts < 1 || parts > HOBE_MAX_REGIONS) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "composite: there must be 1 to %d parts, got %d",
                  HOBE_MAX_REGIONS, parts);
        return NULL;
    }
    struct shape *s = shape_new(parts, err);
    if (!s)
        return NULL;
    if (add_parts(s, part, err)) {
        hobe_fail_in(err, "composite");
        hobe_section_free(&s->base);
        return NULL;
    }
    hobe_section *section = shape_share(s, err);
    if (section)
        snprintf(section->text, sizeof section->text,
                 "composite of %d part%s, w: solved on %d triangles", parts, parts == 1 ? "" : "s",
                 hobe_section_triangles(section));
    else
        hobe_fail_in(err, "composite");
    return section;
}
