/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What all sections share.  The only room that talks to GSL. */
#include "section.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
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

/* The slot of a function; HOBE_ALL_FUNCTIONS when there is none of that name. */
static int find_function(const char *name)
{
    static const char *const names[] = {
        [HOBE_W] = "w",     [HOBE_WY] = "wy",   [HOBE_WZ] = "wz",   [HOBE_WW] = "ww",
        [HOBE_W1] = "w1",   [HOBE_W2] = "w2",   [HOBE_W3] = "w3",   [HOBE_W2T] = "w2t",
        [HOBE_V1Y] = "v1y", [HOBE_V1Z] = "v1z", [HOBE_V2Y] = "v2y", [HOBE_V2Z] = "v2z",
        [HOBE_V3Y] = "v3y", [HOBE_V3Z] = "v3z"};
    int i = 0;
    while (i < HOBE_ALL_FUNCTIONS && strcmp(name, names[i]) != 0)
        i++;
    return i;
}

/* Rectangles and rings are too stout to distort: their functions of it are zero. */
enum hobe_status hobe_section_wall_bending(const hobe_section *section, double *c,
                                           struct hobe_error *err)
{
    *c = 0;
    return section->kind->distort ? section->kind->distort(section, c, err) : HOBE_OK;
}

/* Has the section make a function, if it is not there from the start. */
static enum hobe_status prepare(const hobe_section *section, const char *name,
                                struct hobe_error *err)
{
    const int slot = find_function(name);
    if (slot == HOBE_ALL_FUNCTIONS)
        return hobe_fail(err, HOBE_UNKNOWN, NULL,
                         "a section has no function %s; it has w, wy and wz, and of a solved "
                         "outline ww, w1, w2, w3, w2t and v1y, v1z to v3y, v3z",
                         name);
    double wall_bending;
    return slot < HOBE_SECTION_FUNCTIONS ? HOBE_OK
                                         : hobe_section_wall_bending(section, &wall_bending, err);
}

static enum hobe_status check_functions(const hobe_section *section,
                                        const struct hobe_kernel *kernel, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < kernel->functions; i++)
        status = prepare(section, kernel->function[i], err);
    return status;
}

int hobe_section_bends(const struct hobe_kernel *kernel)
{
    for (int i = 0; i < kernel->functions; i++)
        if (find_function(kernel->function[i]) != HOBE_W)
            return 1;
    return 0;
}

int hobe_section_distorts(const struct hobe_kernel *kernel)
{
    for (int i = 0; i < kernel->functions; i++)
        if (find_function(kernel->function[i]) >= HOBE_SECTION_FUNCTIONS)
            return 1;
    return 0;
}

/* Puts the functions of each point from the section's order into the kernel's. */
static void arrange(struct hobe_rule *rule, const struct hobe_kernel *kernel)
{
    int slot[HOBE_MAX_FUNCTIONS];
    for (int i = 0; i < kernel->functions; i++)
        slot[i] = find_function(kernel->function[i]);
    for (int p = 0; p < rule->rule.points; p++) {
        struct hobe_section_point *at = rule->point + p, from = *at;
        memset(at->f, 0, sizeof at->f);
        for (int i = 0; i < kernel->functions; i++)
            memcpy(at->f[i], from.f[slot[i]], sizeof at->f[i]);
    }
}

enum hobe_status hobe_section_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                   enum hobe_integration integration,
                                   const struct hobe_section_place *place, struct hobe_rule *rule,
                                   struct hobe_error *err)
{
    *rule = (struct hobe_rule){0};
    enum hobe_status status = check_functions(section, kernel, err);
    if (status)
        return status;
    status = section->kind->rule_at
                 ? section->kind->rule_at(section, kernel, integration, place, rule, err)
                 : section->kind->rule(section, kernel, integration, rule, err);
    if (!status)
        arrange(rule, kernel);
    return status;
}

static enum hobe_status functions_at(const hobe_section *section, int paper,
                                     const struct hobe_section_place *place, double y, double z,
                                     double (*f)[4], struct hobe_error *err)
{
    if (section->kind->functions_at)
        return section->kind->functions_at(section, paper, place, y, z, f, err);
    section->kind->functions(section, paper, y, z, f);
    return HOBE_OK;
}

/* The centroid need not lie in the material; functions are then those of the nearest point, or of
 * the branch of the closed form that continues there. */
enum hobe_status hobe_axis_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                enum hobe_integration integration,
                                const struct hobe_section_place *place, struct hobe_rule *rule,
                                struct hobe_error *err)
{
    const int paper = integration == HOBE_INTEGRATION_PAPER;
    *rule = (struct hobe_rule){0};
    enum hobe_status status = check_functions(section, kernel, err);
    if (!status)
        status = hobe_rule_new(rule, 1, err);
    if (status)
        return status;
    rule->point->weight = section->properties.A;
    if (section->kind->shape_at)
        status = section->kind->shape_at(section, place->at, &rule->point->weight, NULL, err);
    if (!status && kernel->functions)
        status = functions_at(section, paper, place, 0, 0, rule->point->f, err);
    arrange(rule, kernel);
    return status;
}

int hobe_section_varies(const hobe_section *section)
{
    return section->kind->rule_at != NULL;
}

enum hobe_status hobe_section_functions_at(const hobe_section *section,
                                           const struct hobe_kernel *kernel,
                                           const struct hobe_section_place *place, double y,
                                           double z, double (*f)[4], struct hobe_error *err)
{
    double all[HOBE_MAX_FUNCTIONS][4] = {{0}};
    enum hobe_status status = check_functions(section, kernel, err);
    if (!status && kernel->functions)
        status = functions_at(section, 0, place, y, z, all, err);
    for (int i = 0; !status && i < kernel->functions; i++)
        memcpy(f[i], all[find_function(kernel->function[i])], sizeof f[i]);
    return status;
}

enum hobe_status hobe_section_probes_at(const hobe_section *section,
                                        const struct hobe_section_place *place, double (*probe)[2],
                                        struct hobe_error *err)
{
    double area;
    if (section->kind->shape_at)
        return section->kind->shape_at(section, place->at, &area, probe, err);
    memcpy(probe, section->probe, sizeof section->probe);
    return HOBE_OK;
}

int hobe_section_regions(const hobe_section *section)
{
    return section->material ? section->regions : 1;
}

int hobe_section_region(const hobe_section *section, double y, double z)
{
    return hobe_section_regions(section) > 1 ? section->kind->region(section, y, z) : 0;
}

const struct hobe_material *hobe_section_material(const hobe_section *section, int region)
{
    return section->material ? section->material + region : NULL;
}

double hobe_section_E(const hobe_section *section, int region)
{
    const struct hobe_material *m = section->material;
    return m ? m[region].E / m[0].E : 1;
}

double hobe_section_G(const hobe_section *section, int region)
{
    const struct hobe_material *m = section->material;
    return m ? m[region].E / m[0].E * (1 + m[0].nu) / (1 + m[region].nu) : 1;
}

enum hobe_status hobe_section_properties_at(const hobe_section *section,
                                            const struct hobe_section_place *place,
                                            struct hobe_section_properties *p,
                                            struct hobe_error *err)
{
    if (section->kind->properties_at)
        return section->kind->properties_at(section, place->at, p, err);
    *p = section->properties;
    return HOBE_OK;
}

/* Fields of shear on the section: a unit twist, unit shears, gradients of the functions. */
enum { TWIST, SHEAR_Y, SHEAR_Z, GRADIENT, FIELDS = GRADIENT + HOBE_SECTION_FUNCTIONS };

/* S_ij = int G/G_1 g_i . g_j dA of the fields g. */
static void shear_energy(const hobe_section *section, const struct hobe_rule *rule,
                         double S[FIELDS][FIELDS])
{
    memset(S, 0, sizeof(double[FIELDS][FIELDS]));
    for (int p = 0; p < rule->rule.points; p++) {
        const struct hobe_section_point *at = rule->point + p;
        const double weight = at->weight * hobe_section_G(section, at->region);
        double g[FIELDS][2] = {[TWIST] = {-at->z, at->y}, [SHEAR_Y] = {1, 0}, [SHEAR_Z] = {0, 1}};
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
            memcpy(g[GRADIENT + f], at->f[f] + 1, sizeof g[GRADIENT + f]);
        for (int i = 0; i < FIELDS; i++)
            for (int j = 0; j < FIELDS; j++)
                S[i][j] += weight * (g[i][0] * g[j][0] + g[i][1] * g[j][1]);
    }
}

/* Gives field k the amplitude of least energy, whatever the others have. */
static void release(double S[FIELDS][FIELDS], int k)
{
    const double pivot = S[k][k];
    double row[FIELDS];
    if (!(pivot > 0))
        return; /* the section has no such function */
    memcpy(row, S[k], sizeof row);
    for (int i = 0; i < FIELDS; i++)
        for (int j = 0; j < FIELDS; j++)
            S[i][j] -= row[i] * row[j] / pivot;
}

void hobe_section_set_warping(hobe_section *section, const struct hobe_rule *rule)
{
    struct hobe_section_properties *p = &section->properties;
    double S[FIELDS][FIELDS];
    shear_energy(section, rule, S);
    release(S, GRADIENT + HOBE_W);
    release(S, SHEAR_Y);
    release(S, SHEAR_Z);
    p->J_w = S[TWIST][TWIST];
    p->Iw = 0;
    for (int i = 0; i < rule->rule.points; i++) {
        const struct hobe_section_point *at = rule->point + i;
        p->Iw += hobe_section_E(section, at->region) * at->weight * pow(at->f[HOBE_W][0], 2);
    }
}

void hobe_section_set_shear(hobe_section *section, const struct hobe_rule *rule)
{
    struct hobe_section_properties *p = &section->properties;
    double S[FIELDS][FIELDS];
    shear_energy(section, rule, S);
    const double GA = S[SHEAR_Y][SHEAR_Y]; /* over G_1 */
    for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++)
        release(S, GRADIENT + f);
    const double yy = S[SHEAR_Y][SHEAR_Y] / GA, zz = S[SHEAR_Z][SHEAR_Z] / GA;
    const double yz = S[SHEAR_Y][SHEAR_Z] / GA, determinant = yy * zz - yz * yz;
    p->ky = determinant / zz;
    p->kz = determinant / yy;
    p->kyz = -yz / determinant;
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

enum hobe_status hobe_section_function_at(const hobe_section *section, const char *name,
                                          const struct hobe_section_place *place, double y,
                                          double z, double *f, struct hobe_error *err)
{
    double all[HOBE_MAX_FUNCTIONS][4] = {{0}};
    enum hobe_status status = prepare(section, name, err);
    if (!status)
        status = functions_at(section, 0, place, y, z, all, err);
    if (!status)
        memcpy(f, all[find_function(name)], 3 * sizeof *f);
    return status;
}

enum hobe_status hobe_section_function(const hobe_section *section, const char *name, double y,
                                       double z, double *f, struct hobe_error *err)
{
    return hobe_section_function_at(section, name, NULL, y, z, f, err);
}
