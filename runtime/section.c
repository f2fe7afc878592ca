/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What all sections share.  The only room that talks to GSL. */
#include "section.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <string.h>

enum hobe_status hobe_gauss(int n, double (*gauss)[2], struct hobe_error *err)
{
    gsl_set_error_handler_off();
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc((size_t)n);
    if (!table)
        return hobe_fail(err, HOBE_NO_MEMORY, NULL, "out of memory: %d Gauss points", n);
    for (int i = 0; i < n; i++)
        gsl_integration_glfixed_point(0, 1, (size_t)i, &gauss[i][0], &gauss[i][1], table);
    gsl_integration_glfixed_table_free(table);
    return HOBE_OK;
}

enum hobe_status hobe_rule_new(struct hobe_rule *rule, size_t points, struct hobe_error *err)
{
    *rule = (struct hobe_rule){.point = hobe_alloc(points, sizeof *rule->point, err)};
    if (!rule->point)
        return HOBE_NO_MEMORY;
    rule->rule = (struct hobe_section_rule){(int)points, rule->point};
    return HOBE_OK;
}

enum hobe_status hobe_rule_copy(const struct hobe_rule *from, struct hobe_rule *to,
                                struct hobe_error *err)
{
    const size_t points = (size_t)from->rule.points;
    const enum hobe_status status = hobe_rule_new(to, points, err);
    if (!status)
        memcpy(to->point, from->point, points * sizeof *to->point);
    return status;
}

void hobe_rule_free(struct hobe_rule *rule)
{
    hobe_free(rule->point);
    *rule = (struct hobe_rule){0};
}

/* Sections know one function, w. */
static enum hobe_status check_functions(const struct hobe_kernel *kernel, struct hobe_error *err)
{
    for (int i = 0; i < kernel->functions; i++)
        if (strcmp(kernel->function[i], "w") != 0)
            return hobe_fail(err, HOBE_UNKNOWN, NULL,
                             "element %s uses the section function %s, sections have only w",
                             kernel->name, kernel->function[i]);
    return HOBE_OK;
}

enum hobe_status hobe_section_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                   enum hobe_integration integration,
                                   const struct hobe_section_place *place, struct hobe_rule *rule,
                                   struct hobe_error *err)
{
    (void)place;
    *rule = (struct hobe_rule){0};
    const enum hobe_status status = check_functions(kernel, err);
    return status ? status : section->kind->rule(section, kernel, integration, rule, err);
}

/* The centroid need not lie in the material; w is then that of the nearest point, or of the branch
 * of the closed form that continues there. */
enum hobe_status hobe_axis_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                enum hobe_integration integration,
                                const struct hobe_section_place *place, struct hobe_rule *rule,
                                struct hobe_error *err)
{
    (void)place;
    *rule = (struct hobe_rule){0};
    enum hobe_status status = check_functions(kernel, err);
    if (!status)
        status = hobe_rule_new(rule, 1, err);
    if (status)
        return status;
    rule->point->weight = section->properties.A;
    if (kernel->functions)
        section->kind->warping(section, integration == HOBE_INTEGRATION_PAPER, 0, 0,
                               rule->point->f[0]);
    return HOBE_OK;
}

int hobe_section_varies(const hobe_section *section)
{
    (void)section;
    return 0;
}

void hobe_section_set_warping(hobe_section *section, const struct hobe_rule *rule)
{
    struct hobe_section_properties *p = &section->properties;
    double b = 0, c = 0, mean[2] = {0, 0};
    p->Iw = 0;
    for (int i = 0; i < rule->rule.points; i++) {
        const struct hobe_section_point *at = rule->point + i;
        const double *f = at->f[0];
        b += at->weight * (at->z * f[1] - at->y * f[2]);
        c += at->weight * (f[1] * f[1] + f[2] * f[2]);
        for (int a = 0; a < 2; a++)
            mean[a] += at->weight * f[1 + a] / p->A;
        p->Iw += at->weight * f[0] * f[0];
    }
    c -= p->A * (mean[0] * mean[0] + mean[1] * mean[1]);
    p->J_w = p->Iyy + p->Izz - (c > 0 ? b * b / c : 0);
}

enum hobe_status hobe_section_no_paper(const char *what, struct hobe_error *err)
{
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "the paper has no integration of %s; it has that of rectangles, I-sections "
                     "and hollow rectangles",
                     what);
}

void hobe_section_free(hobe_section *section)
{
    if (section && section->kind->close)
        section->kind->close(section);
    hobe_free(section);
}

void hobe_section_properties(const hobe_section *section, struct hobe_section_properties *p)
{
    *p = section->properties;
}

const char *hobe_section_text(const hobe_section *section)
{
    return section->text;
}

enum hobe_status hobe_section_function(const hobe_section *section, const char *name, double y,
                                       double z, double *f, struct hobe_error *err)
{
    if (strcmp(name, "w") != 0)
        return hobe_fail(err, HOBE_UNKNOWN, NULL, "a section has no function %s, only w", name);
    section->kind->warping(section, 0, y, z, f);
    return HOBE_OK;
}
