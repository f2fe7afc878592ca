/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The elastic laws of an element: of its section's regions, and of the mean strain. */
#include "element_parts.h"
#include "material.h"
#include "section.h"

#include <string.h>

static const struct hobe_material *material_of(const struct hobe_element_options *options,
                                               int region)
{
    const struct hobe_material *own = hobe_section_material(options->section, region);
    return own ? own : &options->material;
}

/* The law of the mean strain: Poisson's coupling of the material that has the section's EA over A
 * and the mean Poisson's ratio weighted with EA, so that EA and EI are the sums of the parts'
 * whatever their ratios; the mean shear law is the sum of theirs. */
static void set_mean(struct laws *laws, const struct hobe_element_options *options,
                     enum hobe_mechanics mechanics, const double *share)
{
    struct hobe_material whole = *material_of(options, 0);
    struct hobe_elasticity point, *mean = &laws->law.mean;
    double EA = 0, nuEA = 0, shear[3] = {0, 0, 0};
    for (int r = 0; r < laws->law.regions; r++) {
        const struct hobe_material *m = material_of(options, r);
        EA += share[r] * m->E;
        nuEA += share[r] * m->E * m->nu;
        hobe_material_law(m, mechanics, &point, mean);
        for (int a = 0; a < 3; a++)
            shear[a] += share[r] * mean->shear[a];
    }
    whole.E = EA;
    whole.nu = nuEA / EA;
    hobe_material_law(&whole, mechanics, &point, mean);
    memcpy(mean->shear, shear, sizeof shear);
}

void element_set_laws(struct laws *laws, const struct hobe_element_options *options,
                      enum hobe_mechanics mechanics, const struct hobe_section_rule *rule)
{
    double share[HOBE_MAX_REGIONS] = {0}, total = 0;
    struct hobe_elasticity mean;
    laws->law = (struct hobe_law){.regions = hobe_section_regions(options->section),
                                  .region = laws->region,
                                  .density = laws->density,
                                  .relieved = mechanics == HOBE_MECHANICS_AVERAGE};
    for (int p = 0; p < rule->points; p++)
        total += rule->point[p].weight;
    for (int p = 0; p < rule->points; p++) {
        const struct hobe_section_point *at = rule->point + p;
        const double EA = material_of(options, at->region)->E * at->weight;
        share[at->region] += at->weight / total;
        laws->EA += EA;
        laws->EIyy += EA * at->z * at->z;
        laws->EIzz += EA * at->y * at->y;
        laws->EIyz += EA * at->y * at->z;
    }
    for (int r = 0; r < laws->law.regions; r++) {
        hobe_material_law(material_of(options, r), mechanics, laws->region + r, &mean);
        laws->density[r] = material_of(options, r)->rho;
    }
    laws->G = material_of(options, 0)->E / (2 * (1 + material_of(options, 0)->nu));
    set_mean(laws, options, mechanics, share);
}
