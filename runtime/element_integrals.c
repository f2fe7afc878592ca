/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals over an element's section and axis: what its kernel keeps of a beam. */
#include "element_parts.h"
#include "section.h"

#include <math.h>
#include <string.h>

/* Where shape or section vary along an element its energy is no polynomial of xi, and takes
 * HOBE_MORE_STATIONS more than one that is straight and prismatic. */
enum { PAPER_STATIONS = 3, MOST_STATIONS = 32 };

/* Relative to what is already spanned, in the square: a section function closer to the earlier
 * modes than this is not a new one.  w of a circle is 0; of a rectangle never less than 1e-3. */
static const double DEPENDENT = 1e-10;

/* Lays the arrays of inv out in one block: one block of Q, or one for each station with a coupling
 * block and a reference of its own. */
static enum hobe_status allocate(hobe_element *element, int varies, struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    struct hobe_invariants *inv = &element->invariants;
    const size_t G = (size_t)inv->stations, V = (size_t)k->vectors, B = varies ? G : 1;
    const size_t NN = (size_t)k->normals, NS = (size_t)k->shears;
    const struct {
        size_t size;
        double **array;
    } parts[] = {
        {G, &inv->xi},
        {G, &inv->wx},
        {G * V, &inv->N},
        {G * V, &inv->Nx},
        {B * NN * NN, &inv->Qn},
        {B * NS * NS, &inv->Qs},
        {V * V, &inv->mass},
        {varies ? B * NN * NS : 0, &inv->Qc},
        {varies ? 3 * V : 0, &element->q0},
    };
    const size_t count = sizeof parts / sizeof *parts;
    size_t total = 0;
    for (size_t i = 0; i < count; i++)
        total += parts[i].size;
    element->numbers = hobe_alloc(total, sizeof(double), err);
    if (!element->numbers)
        return HOBE_NO_MEMORY;
    double *next = element->numbers;
    for (size_t i = 0; i < count; i++) {
        *parts[i].array = parts[i].size ? next : NULL;
        next += parts[i].size;
    }
    return HOBE_OK;
}

/* The section's place at xi of the element. */
static struct hobe_section_place place_at(const struct hobe_element_options *options, double xi)
{
    const double part = options->to > options->from ? options->to - options->from : 1;
    return (struct hobe_section_place){options->from + xi * part, options->length / part};
}

/* G_kl = int phi_k phi_l dA, its lower triangle. */
static enum hobe_status gram(const hobe_element *element,
                             const struct hobe_element_options *options,
                             enum hobe_integration integration,
                             double G[HOBE_MAX_MODES][HOBE_MAX_MODES], struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    struct hobe_rule rule;
    double phi[HOBE_MAX_MODES][4];
    const struct hobe_section_place middle = place_at(options, 0.5);
    const enum hobe_status status =
        hobe_section_rule(element->section, k, integration, &middle, &rule, err);
    if (status)
        return status;
    for (int p = 0; p < rule.rule.points; p++) {
        const struct hobe_section_point *at = rule.point + p;
        k->section_modes(at->y, at->z, at->f, phi);
        for (int i = 0; i < k->modes; i++)
            for (int j = 0; j <= i; j++)
                G[i][j] += at->weight * phi[i][0] * phi[j][0];
    }
    hobe_rule_free(&rule);
    return HOBE_OK;
}

/* Marks modes beyond 1, y, z that vanish or depend on earlier ones, by Gram-Schmidt (Cholesky
 * factor of G in place).  The paper's few points make modes dependent that are not, and are asked
 * only whether its own w vanishes. */
enum hobe_status element_find_dropped(hobe_element *element,
                                      const struct hobe_element_options *options,
                                      struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    const int paper = options->integration == HOBE_INTEGRATION_PAPER;
    double G[HOBE_MAX_MODES][HOBE_MAX_MODES] = {{0}}, used[HOBE_MAX_MODES][HOBE_MAX_MODES] = {{0}};
    if (k->functions == 0)
        return HOBE_OK; /* monomials are independent on any section */
    enum hobe_status status = gram(element, options, HOBE_INTEGRATION_EXACT, G, err);
    if (!status && paper)
        status = gram(element, options, HOBE_INTEGRATION_PAPER, used, err);
    if (status)
        return status;
    for (int i = 0; i < k->modes; i++) {
        const double norm = G[i][i];
        for (int j = 0; j < i; j++) {
            double sum = G[i][j];
            for (int l = 0; l < j; l++)
                sum -= G[i][l] * G[j][l];
            G[i][j] = element->dropped[j] ? 0 : sum / G[j][j];
            G[i][i] -= G[i][j] * G[i][j];
        }
        element->dropped[i] = i > 2 && !(G[i][i] > DEPENDENT * norm && (!paper || used[i][i] > 0));
        G[i][i] = sqrt(fmax(G[i][i], 1e-300));
    }
    return HOBE_OK;
}

/* The rules of one station; the last two where the section has materials of its own. */
struct rules {
    struct hobe_rule section, axis, mean_normal, mean_shear;
};

static void free_rules(struct rules *rules)
{
    hobe_rule_free(&rules->section);
    hobe_rule_free(&rules->axis);
    hobe_rule_free(&rules->mean_normal);
    hobe_rule_free(&rules->mean_shear);
}

/* The mean strains of a section of several materials: weighted with E, and with G.  About the
 * centroid of EA bending then has no mean strain, and no uneven strain costs less than its mean
 * (Cauchy and Schwarz), so that EA and EI are those of section theory. */
static enum hobe_status set_means(const hobe_section *section, struct rules *rules,
                                  struct hobe_error *err)
{
    enum hobe_status status = hobe_rule_copy(&rules->section, &rules->mean_normal, err);
    if (!status)
        status = hobe_rule_copy(&rules->section, &rules->mean_shear, err);
    for (int p = 0; !status && p < rules->section.rule.points; p++) {
        const int region = rules->section.point[p].region;
        rules->mean_normal.point[p].weight *= hobe_section_E(section, region);
        rules->mean_shear.point[p].weight *= hobe_section_G(section, region);
    }
    return status;
}

static enum hobe_status set_station(const hobe_element *element,
                                    const struct hobe_element_options *options, double xi,
                                    struct rules *rules, struct hobe_station *station,
                                    struct hobe_error *err)
{
    const int on_axis = element->mechanics == HOBE_MECHANICS_AXIS;
    const struct hobe_section_place place = place_at(options, xi);
    enum hobe_status status = hobe_section_rule(options->section, element->kernel,
                                                options->integration, &place, &rules->section, err);
    if (!status)
        status = hobe_axis_rule(options->section, element->kernel, options->integration, &place,
                                &rules->axis, err);
    const int own = hobe_section_material(options->section, 0) != NULL;
    if (!status && own)
        status = set_means(options->section, rules, err);
    struct hobe_section_properties p = {0};
    if (!status && element->mechanics == HOBE_MECHANICS_STRUCTURAL)
        status = hobe_section_properties_at(options->section, &place, &p, err);
    *station = (struct hobe_station){
        .rule = rules->section.rule,
        .mean_normal = on_axis ? rules->axis.rule
                       : own   ? rules->mean_normal.rule
                               : rules->section.rule,
        .mean_shear = own ? rules->mean_shear.rule : rules->section.rule,
        .J = p.J,
        .shear_centre = {p.ys, p.zs},
    };
    return status;
}

/* The reference of an element that varies: the given one, or a straight one along X. */
static void set_reference(hobe_element *element, const double *q0)
{
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (q0)
        memcpy(element->q0, q0, 3 * (size_t)element->kernel->vectors * sizeof *q0);
    else if (element->q0)
        hobe_element_reference(element, identity, element->q0);
}

static enum hobe_status integrate_sections(hobe_element *element,
                                           const struct hobe_element_options *options,
                                           enum plan plan, const double (*gauss)[2],
                                           struct hobe_error *err)
{
    struct hobe_invariants *inv = &element->invariants;
    struct rules rules[MOST_STATIONS] = {0};
    struct hobe_station station[MOST_STATIONS];
    const int sections = hobe_section_varies(options->section) ? inv->stations : 1;
    enum hobe_status status = HOBE_OK;
    for (int g = 0; !status && g < sections; g++)
        status = set_station(element, options, gauss[g][0], rules + g, station + g, err);
    if (!status) {
        element_set_laws(&element->laws, options, element->mechanics, &station->rule);
        element->kernel->invariants(inv, gauss, sections, station, &element->laws.law, element->q0);
    }
    if (!status && plan == POINTS && element->kernel->section)
        status = points_open(&element->points, element->kernel, inv, sections, station,
                             &element->laws.law, element->q0, err);
    for (int g = 0; g < sections; g++)
        free_rules(rules + g);
    return status;
}

/* The paper's points integrate the mass matrix, too: of an element that is straight and prismatic,
 * whose kernel makes it exact, they make it here.  34X3 and the like lose rank by them. */
static enum hobe_status paper_mass(hobe_element *element,
                                   const struct hobe_element_options *options,
                                   struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    const struct hobe_invariants *inv = &element->invariants;
    double G[HOBE_MAX_MODES][HOBE_MAX_MODES] = {{0}};
    const enum hobe_status status = gram(element, options, HOBE_INTEGRATION_PAPER, G, err);
    for (int v = 0; !status && v < k->vectors; v++)
        for (int w = 0; w <= v; w++) {
            const int a = k->vector[v].mode, b = k->vector[w].mode;
            double axis = 0;
            for (int g = 0; g < inv->stations; g++)
                axis += inv->wx[g] * inv->N[g * k->vectors + v] * inv->N[g * k->vectors + w];
            inv->mass[v * k->vectors + w] = inv->mass[w * k->vectors + v] =
                options->material.rho * G[a > b ? a : b][a > b ? b : a] * axis;
        }
    return status;
}

/* Points on the axis: those the element brings, or Gauss's. */
static int stations(const struct hobe_kernel *kernel, int varies, enum hobe_integration integration)
{
    if (kernel->axis_rule)
        return kernel->stations;
    if (integration == HOBE_INTEGRATION_PAPER)
        return PAPER_STATIONS;
    return kernel->stations + (varies ? HOBE_MORE_STATIONS : 0);
}

static enum hobe_status axis_rule(const struct hobe_kernel *kernel, int count, double (*rule)[2],
                                  struct hobe_error *err)
{
    if (!kernel->axis_rule)
        return hobe_gauss(count, rule, err);
    memcpy(rule, kernel->axis_rule, (size_t)count * sizeof *rule);
    return HOBE_OK;
}

enum hobe_status element_fill_section(const struct hobe_kernel *k, struct hobe_invariants *inv,
                                      struct hobe_error *err)
{
    const size_t block = k->section_cost[inv->symmetry].numbers, stations = (size_t)inv->stations;
    inv->step = inv->step_n ? (ptrdiff_t)block : 0;
    inv->section = hobe_alloc(stations * k->axial + (inv->step ? stations : 1) * block,
                              sizeof *inv->section, err);
    if (!inv->section)
        return HOBE_NO_MEMORY;
    k->section(inv);
    return HOBE_OK;
}

enum hobe_status element_integrate(hobe_element *element,
                                   const struct hobe_element_options *options, enum plan plan,
                                   struct hobe_error *err)
{
    const int paper = options->integration == HOBE_INTEGRATION_PAPER;
    const int varies = options->q0 || hobe_section_varies(options->section);
    struct hobe_invariants *inv = &element->invariants;
    double gauss[MOST_STATIONS][2];
    inv->length = options->length;
    inv->stations = stations(element->kernel, varies, options->integration);
    if (inv->stations > MOST_STATIONS)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL, "element %s needs %d > %d axial points",
                         element->kernel->name, inv->stations, MOST_STATIONS);
    enum hobe_status status = allocate(element, varies, err);
    if (!status)
        status = axis_rule(element->kernel, inv->stations, gauss, err);
    if (status)
        return status;
    set_reference(element, options->q0);
    status = integrate_sections(element, options, plan, (const double(*)[2])gauss, err);
    if (!status && paper && !varies)
        status = paper_mass(element, options, err);
    if (status || !element->kernel->section)
        return status;
    inv->symmetry = element->kernel->symmetry(inv);
    return element_fill_section(element->kernel, inv, err);
}
