/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "element.h"

#include "eigen.h"
#include "material.h"
#include "points.h"
#include "section.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where shape or section vary along an element its energy is no polynomial of xi, and takes
 * HOBE_MORE_STATIONS more than one that is straight and prismatic. */
enum { PAPER_STATIONS = 3, MOST_STATIONS = 32 };

/* Relative to what is already spanned, in the square: a section function closer to the earlier
 * modes than this is not a new one.  w of a circle is 0; of a rectangle never less than 1e-3. */
static const double DEPENDENT = 1e-10;

/* Eigenvalues of the scaled stiffness at rest, relative to the largest: rigid motions come out
 * below 1e-14, the softest deformation of an element 20 heights long above 1e-9. */
static const double ZERO_EIGENVALUE = 1e-12;

/* The laws of the section's regions, or of the beam's material where it has none of its own. */
struct laws {
    struct hobe_elasticity region[HOBE_MAX_REGIONS];
    double density[HOBE_MAX_REGIONS];
    struct hobe_law law;
    /* of the section where it does not vary; G of its first region */
    double EA, EIyy, EIzz, EIyz, G;
};

/* Ways to force and tangent. */
enum plan { CHEAPEST, SECTION, TENSOR, POINTS, PLANS };

struct hobe_element {
    const struct hobe_kernel *kernel;
    const hobe_section *section;
    enum hobe_mechanics mechanics;
    struct laws laws;
    struct hobe_invariants invariants;
    double *numbers; /* all arrays of the invariants but the tensor, and q0, in one block */
    double *q0; /* [V][3] where curved, pretwisted or tapered, NULL where straight, prismatic */
    struct hobe_rest rest;
    unsigned char dropped[HOBE_MAX_MODES];

    /* The plan: of force alone and of force and tangent. */
    int by_tensor[2];
    struct hobe_invariants whole; /* with a tensor; where no task takes it, tensor = NULL */
    struct points points;         /* vectors = 0: force and tangent are the kernel's own */
};

const struct hobe_kernel *hobe_find_kernel(const char *name, struct hobe_error *err)
{
    char known[700] = "";
    size_t used = 0;
    for (int i = 0; hobe_kernels()[i]; i++) {
        if (strcmp(hobe_kernels()[i]->name, name) == 0)
            return hobe_kernels()[i];
        if (used < sizeof known)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", i ? ", " : "",
                                     hobe_kernels()[i]->name);
    }
    hobe_fail(err, HOBE_UNKNOWN, NULL, "unknown element \"%s\"; known are %s", name, known);
    return NULL;
}

int hobe_kernel_step(const struct hobe_kernel *kernel)
{
    int v = 0;
    while (kernel->vector[v].node < kernel->nodes - 1)
        v++;
    return v;
}

int hobe_kernel_vector(const struct hobe_kernel *kernel, int node, int mode, int slope)
{
    for (int v = 0; v < kernel->vectors; v++) {
        const struct hobe_vector *is = kernel->vector + v;
        if (is->node == node && is->mode == mode && is->slope == slope)
            return v;
    }
    return -1;
}

void hobe_kernel_reference(const struct hobe_kernel *k, double length, const double frame[3][3],
                           double *q0)
{
    for (int v = 0; v < k->vectors; v++) {
        const struct hobe_vector *is = k->vector + v;
        const double x = k->node[is->node] * length;
        for (int a = 0; a < 3; a++) {
            double value = 0; /* modes beyond 1, y, z vanish at rest */
            if (is->mode == 0)
                value = (is->slope ? 1 : x) * frame[0][a];
            else if (is->mode <= 2 && !is->slope)
                value = frame[is->mode][a];
            q0[3 * v + a] = value;
        }
    }
}

void hobe_kernel_axes(const struct hobe_kernel *k, const double *N, const double *Nx,
                      const double *q0, double axes[3][3])
{
    double d[2][3] = {{0}}; /* d_0', d_y */
    for (int v = 0; v < k->vectors; v++) {
        const int mode = k->vector[v].mode;
        for (int a = 0; mode < 2 && a < 3; a++)
            d[mode][a] += (mode ? N : Nx)[v] * q0[3 * v + a];
    }
    const double length = length3(d[0]), along = dot3(d[0], d[1]) / (length * length);
    for (int a = 0; a < 3; a++) {
        axes[0][a] = d[0][a] / length;
        axes[1][a] = d[1][a] - along * d[0][a];
    }
    const double across = length3(axes[1]);
    for (int a = 0; a < 3; a++)
        axes[1][a] /= across;
    cross3(axes[0], axes[1], axes[2]);
}

/* ---- preparation ---------------------------------------------------------------------------- */

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
static enum hobe_status find_dropped(hobe_element *element,
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

static void set_laws(struct laws *laws, const struct hobe_element_options *options,
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

static enum hobe_status integrate(hobe_element *element, const struct hobe_element_options *options,
                                  enum plan plan, const double (*gauss)[2], struct hobe_error *err)
{
    struct hobe_invariants *inv = &element->invariants;
    struct rules rules[MOST_STATIONS] = {0};
    struct hobe_station station[MOST_STATIONS];
    const int sections = hobe_section_varies(options->section) ? inv->stations : 1;
    enum hobe_status status = HOBE_OK;
    for (int g = 0; !status && g < sections; g++)
        status = set_station(element, options, gauss[g][0], rules + g, station + g, err);
    if (!status) {
        set_laws(&element->laws, options, element->mechanics, &station->rule);
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

/* The plan that HOBE_PLAN in the environment asks for, wherever it can be. */
static enum hobe_status asked_plan(enum plan *plan, struct hobe_error *err)
{
    static const char *const name[PLANS] = {"", "section", "tensor", "points"};
    const char *asked = getenv("HOBE_PLAN");
    *plan = CHEAPEST;
    while (asked && *plan < PLANS && strcmp(asked, name[*plan]))
        ++*plan;
    if (*plan < PLANS)
        return HOBE_OK;
    return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                     "HOBE_PLAN in the environment is \"%s\"; it must be \"section\", "
                     "\"tensor\" or \"points\", or unset for what is cheapest",
                     asked);
}

/* The arrays of the plan "section", filled, to be freed by the caller. */
static enum hobe_status fill_section(const struct hobe_kernel *k, struct hobe_invariants *inv,
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

static enum hobe_status fill_invariants(hobe_element *element,
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
    status = integrate(element, options, plan, (const double(*)[2])gauss, err);
    if (!status && paper && !varies)
        status = paper_mass(element, options, err);
    if (status || !element->kernel->section)
        return status;
    inv->symmetry = element->kernel->symmetry(inv);
    return fill_section(element->kernel, inv, err);
}

/* ---- the plan of force and tangent ---------------------------------------------------------- */

double hobe_tensor_speed(const struct hobe_kernel *kernel, int symmetry, int tangent)
{
    static const double cached[2] = {1.5, 1.8}, streamed[2] = {0.7, 1};
    const size_t cache = 2 << 20;
    const size_t size = kernel->tensor_cost[symmetry].numbers * sizeof(double);
    return (size > cache ? streamed : cached)[tangent];
}

/* How many times as fast as from station to station. */
static double tensor_gain(const struct hobe_kernel *kernel, int symmetry, int tangent)
{
    const struct hobe_plan_cost *tensor = kernel->tensor_cost + symmetry,
                                *section = kernel->section_cost + symmetry;
    const double ratio = tangent ? (double)section->flops_tangent / (double)tensor->flops_tangent
                                 : (double)section->flops_force / (double)tensor->flops_force;
    return hobe_tensor_speed(kernel, symmetry, tangent) * ratio;
}

int hobe_tensor_pays(const struct hobe_kernel *kernel, int symmetry, int tangent)
{
    if (!kernel->tensor || !(symmetry & HOBE_SYMMETRIC_X))
        return 0;
    const double force = tensor_gain(kernel, symmetry, 0), both = tensor_gain(kernel, symmetry, 1);
    return fmax(force, both) > HOBE_TENSOR_WORTH && (tangent ? both : force) > 1;
}

/* A straight and prismatic element is given its tensor for the tasks where that is the way to take.
 */
static enum hobe_status choose_plan(hobe_element *element, enum plan plan, struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    const struct hobe_invariants *inv = &element->invariants;
    const int possible = k->tensor && inv->symmetry & HOBE_SYMMETRIC_X && !element->q0;
    for (int t = 0; possible && t < 2; t++)
        element->by_tensor[t] =
            plan == CHEAPEST ? hobe_tensor_pays(k, inv->symmetry, t) : plan == TENSOR;
    if (!element->by_tensor[0] && !element->by_tensor[1])
        return HOBE_OK;
    struct hobe_invariants *whole = &element->whole;
    *whole = *inv;
    whole->tensor = hobe_alloc(k->tensor_cost[inv->symmetry].numbers, sizeof *whole->tensor, err);
    if (!whole->tensor)
        return HOBE_NO_MEMORY;
    k->tensor(whole);
    return HOBE_OK;
}

/* ---- the check at rest ---------------------------------------------------------------------- */

/* Eigenvalues of D K D at the reference, D = diag(K)^(-1/2), dropped modes left out. */
static enum hobe_status rest_eigenvalues(hobe_element *element, int *count, double *eigenvalue,
                                         struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    const int n = 3 * k->vectors;
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double *q = hobe_alloc((size_t)n, sizeof *q, err);
    double *K = hobe_alloc((size_t)(n * n), sizeof *K, err);
    enum hobe_status status = q && K ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status) {
        if (element->q0)
            memcpy(q, element->q0, (size_t)n * sizeof *q);
        else
            hobe_element_reference(element, identity, q);
        status = hobe_element_tangent(element, q, q, K, err);
    }
    if (!status) {
        int kept = 0;
        for (int i = 0; i < n; i++) /* rows and columns of the modes that take part, in place */
            if (!element->dropped[k->vector[i / 3].mode]) {
                int column = 0;
                for (int j = 0; j < n; j++)
                    if (!element->dropped[k->vector[j / 3].mode])
                        K[kept * n + column++] = K[i * n + j];
                kept++;
            }
        for (int i = 0; i < kept; i++)
            q[i] = K[i * n + i] != 0 ? 1 / sqrt(fabs(K[i * n + i])) : 1;
        for (int i = 0; i < kept; i++)
            for (int j = 0; j < kept; j++)
                K[i * kept + j] = q[i] * K[i * n + j] * q[j];
        *count = kept;
        status = hobe_eigenvalues(kept, K, eigenvalue, err);
    }
    hobe_free(q);
    hobe_free(K);
    return status;
}

static enum hobe_status check_rest(hobe_element *element, struct hobe_error *err)
{
    const int n = 3 * element->kernel->vectors;
    struct hobe_rest *rest = &element->rest;
    int count = 0;
    double *eigenvalue = hobe_alloc((size_t)n, sizeof *eigenvalue, err);
    if (!eigenvalue)
        return HOBE_NO_MEMORY;
    enum hobe_status status = rest_eigenvalues(element, &count, eigenvalue, err);
    if (!status) {
        const double largest = fmax(eigenvalue[count - 1], -eigenvalue[0]);
        rest->largest = eigenvalue[count - 1];
        rest->smallest = largest;
        for (int i = 0; i < count; i++) {
            const double e = eigenvalue[i];
            if (fabs(e) <= ZERO_EIGENVALUE * largest)
                rest->zero++;
            else if (e < 0)
                rest->negative++;
            else
                rest->positive++;
            if (fabs(e) > ZERO_EIGENVALUE * largest && fabs(e) < fabs(rest->smallest))
                rest->smallest = e;
        }
        if (rest->negative)
            status = hobe_fail(
                err, HOBE_UNSTABLE, NULL,
                "element %s with mechanics \"%s\" is unstable at rest on this section: its "
                "stiffness has %d negative eigenvalue%s beside %d zero and %d positive ones; use "
                "mechanics = \"average\"",
                element->kernel->name, hobe_mechanics_name(element->mechanics), rest->negative,
                rest->negative > 1 ? "s" : "", rest->zero, rest->positive);
    }
    hobe_free(eigenvalue);
    return status;
}

/* What the element makes of the section's EA, EI and GJ: it should be all of it. */
static enum hobe_status compare_stiffness(hobe_element *element,
                                          const struct hobe_section_properties *p,
                                          struct hobe_error *err)
{
    const struct laws *laws = &element->laws;
    const double section[HOBE_STRAINS] = {laws->EA, laws->EIyy, laws->EIzz, laws->G * p->J};
    double C[HOBE_STRAINS][HOBE_STRAINS];
    const enum hobe_status status = hobe_element_stiffness(element, C, err);
    for (int i = 0; !status && i < HOBE_STRAINS; i++)
        element->rest.share[i] = C[i][i] / section[i];
    return status;
}

/* The check depends on the element's proportions alone, and the softest modes of a long element
 * drown in round-off, so that a straight and prismatic one is checked at most 20 heights long: the
 * same section law with its axial part done again. */
static enum hobe_status check_at_rest(hobe_element *element, struct hobe_error *err)
{
    const struct hobe_kernel *k = element->kernel;
    struct hobe_section_properties p;
    hobe_section_properties(element->section, &p);
    const double longest = 20 * fmax(p.width, p.height),
                 scale = longest / element->invariants.length;
    if (element->q0)
        return check_rest(element, err);
    if (scale >= 1) {
        const enum hobe_status status = check_rest(element, err);
        return status ? status : compare_stiffness(element, &p, err);
    }
    hobe_element shorter = *element;
    shorter.points.vectors = 0; /* which are the longer one's */
    struct hobe_invariants *inv = &shorter.invariants;
    const size_t G = (size_t)inv->stations, V = (size_t)k->vectors;
    double *axis = hobe_alloc(G + 2 * G * V, sizeof *axis, err);
    if (!axis)
        return HOBE_NO_MEMORY;
    inv->length = longest;
    inv->wx = axis;
    inv->N = axis + G;
    inv->Nx = inv->N + G * V;
    for (size_t g = 0; g < G; g++) {
        inv->wx[g] = element->invariants.wx[g] * scale;
        k->shape(inv->xi[g], longest, inv->N + V * g, inv->Nx + V * g);
    }
    enum hobe_status status = k->section ? fill_section(k, inv, err) : HOBE_OK;
    if (!status)
        status = check_rest(&shorter, err);
    if (!status)
        status = compare_stiffness(&shorter, &p, err);
    element->rest = shorter.rest;
    if (k->section)
        hobe_free(inv->section);
    hobe_free(axis);
    return status;
}

/* ---- public --------------------------------------------------------------------------------- */

/* The structural form has one law and its own points on the axis. */
static enum hobe_status check_form(const struct hobe_element_options *options,
                                   struct hobe_error *err)
{
    const struct hobe_kernel *k = options->kernel;
    const enum hobe_mechanics own = hobe_mechanics_find(k->mechanics), asked = options->mechanics;
    const int structural = own == HOBE_MECHANICS_STRUCTURAL;
    if (asked && structural != (asked == HOBE_MECHANICS_STRUCTURAL))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "element %s does not take mechanics \"%s\"; leave it out for its own, "
                         "\"%s\"",
                         k->name, hobe_mechanics_name(asked), k->mechanics);
    if (structural && options->integration == HOBE_INTEGRATION_PAPER)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "element %s brings its own points on the axis and does not take "
                         "integration \"paper\"; leave it out",
                         k->name);
    return HOBE_OK;
}

hobe_element *hobe_element_new(const struct hobe_element_options *options, struct hobe_error *err)
{
    if (!(options->length > 0 && isfinite(options->length))) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "an element's length must be > 0 (m), got %g",
                  options->length);
        return NULL;
    }
    if (!hobe_section_material(options->section, 0) && hobe_material_check(&options->material, err))
        return NULL;
    if (check_form(options, err))
        return NULL;
    if (options->kernel->vectors > HOBE_MAX_VECTORS) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL, "element %s has %d vectors, at most %d are possible",
                  options->kernel->name, options->kernel->vectors, HOBE_MAX_VECTORS);
        return NULL;
    }
    enum plan plan;
    hobe_element *element = asked_plan(&plan, err) ? NULL : hobe_alloc(1, sizeof *element, err);
    if (!element)
        return NULL;
    element->kernel = options->kernel;
    element->section = options->section;
    element->mechanics =
        options->mechanics ? options->mechanics : hobe_mechanics_find(options->kernel->mechanics);
    if (fill_invariants(element, options, plan, err) || find_dropped(element, options, err) ||
        check_at_rest(element, err) || choose_plan(element, plan, err)) {
        hobe_element_free(element);
        return NULL;
    }
    return element;
}

void hobe_element_free(hobe_element *element)
{
    if (element) {
        hobe_free(element->numbers);
        hobe_free(element->invariants.section);
        hobe_free(element->whole.tensor);
        points_close(&element->points);
    }
    hobe_free(element);
}

const struct hobe_kernel *hobe_element_kernel(const hobe_element *element)
{
    return element->kernel;
}

const double *hobe_element_q0(const hobe_element *element)
{
    return element->q0;
}

const struct hobe_invariants *hobe_element_invariants(const hobe_element *element)
{
    return &element->invariants;
}

int hobe_element_by_tensor(const hobe_element *element, int tangent)
{
    return element->by_tensor[tangent];
}

void hobe_element_stiffnesses(const hobe_element *element, struct stiffnesses *s)
{
    const struct laws *l = &element->laws;
    *s = (struct stiffnesses){l->EA, l->EIyy, l->EIzz, l->EIyz};
}

const struct hobe_law *hobe_element_law(const hobe_element *element)
{
    return &element->laws.law;
}

enum hobe_mechanics hobe_element_mechanics(const hobe_element *element)
{
    return element->mechanics;
}

void hobe_element_rest(const hobe_element *element, struct hobe_rest *rest)
{
    *rest = element->rest;
}

const unsigned char *hobe_element_dropped(const hobe_element *element)
{
    return element->dropped;
}

void hobe_element_reference(const hobe_element *element, const double frame[3][3], double *q0)
{
    hobe_kernel_reference(element->kernel, element->invariants.length, frame, q0);
}

static const struct hobe_invariants *of_task(const hobe_element *element, int tangent)
{
    return element->by_tensor[tangent] ? &element->whole : &element->invariants;
}

void hobe_element_batch_force(const hobe_element *element, const hobe_lanes *q0,
                              const hobe_lanes *u, hobe_lanes *f, hobe_lanes *scratch)
{
    if (element->points.vectors)
        points_evaluate()(&element->points, q0, u, f, NULL, scratch);
    else
        element->kernel->force(of_task(element, 0), q0, u, f, scratch);
}

void hobe_element_batch_tangent(const hobe_element *element, const hobe_lanes *q0,
                                const hobe_lanes *u, hobe_lanes *f, hobe_lanes *K,
                                hobe_lanes *scratch)
{
    if (element->points.vectors)
        points_evaluate()(&element->points, q0, u, f, K, scratch);
    else
        element->kernel->tangent(of_task(element, 1), q0, u, f, K, scratch);
}

size_t hobe_element_scratch(const struct hobe_kernel *kernel)
{
    const size_t points = POINTS_SCRATCH * (size_t)kernel->vectors;
    return kernel->scratch > points ? kernel->scratch : points;
}

/* One element in the first lane of a batch, the others at rest. */
struct single {
    hobe_lanes *q0, *u, *f, *K, *scratch;
};

static void single_free(struct single *s)
{
    hobe_free(s->q0);
}

static enum hobe_status single_new(const hobe_element *element, const double *q0, const double *q,
                                   struct single *s, struct hobe_error *err)
{
    const size_t V = (size_t)element->kernel->vectors, blocks = 9 * V * (V + 1) / 2;
    *s = (struct single){0};
    s->q0 =
        hobe_alloc(9 * V + blocks + hobe_element_scratch(element->kernel), sizeof(hobe_lanes), err);
    if (!s->q0)
        return HOBE_NO_MEMORY;
    s->u = s->q0 + 3 * V;
    s->f = s->u + 3 * V;
    s->K = s->f + 3 * V;
    s->scratch = s->K + blocks;
    for (size_t i = 0; i < 3 * V; i++) {
        for (int e = 0; e < HOBE_LANES; e++)
            s->q0[i][e] = q0[i];
        s->u[i][0] = q[i] - q0[i];
    }
    return HOBE_OK;
}

enum hobe_status hobe_element_energy(const hobe_element *element, const double *q0, const double *q,
                                     double *U, struct hobe_error *err)
{
    struct single s;
    if (single_new(element, q0, q, &s, err))
        return HOBE_NO_MEMORY;
    element->kernel->energy(&element->invariants, s.q0, s.u, s.f);
    *U = s.f[0][0];
    single_free(&s);
    return HOBE_OK;
}

enum hobe_status hobe_element_force(const hobe_element *element, const double *q0, const double *q,
                                    double *f, struct hobe_error *err)
{
    struct single s;
    if (single_new(element, q0, q, &s, err))
        return HOBE_NO_MEMORY;
    hobe_element_batch_force(element, s.q0, s.u, s.f, s.scratch);
    for (int i = 0; i < 3 * element->kernel->vectors; i++)
        f[i] = s.f[i][0];
    single_free(&s);
    return HOBE_OK;
}

enum hobe_status hobe_element_tangent(const hobe_element *element, const double *q0,
                                      const double *q, double *K, struct hobe_error *err)
{
    const int V = element->kernel->vectors, n = 3 * V;
    struct single s;
    if (single_new(element, q0, q, &s, err))
        return HOBE_NO_MEMORY;
    hobe_element_batch_tangent(element, s.q0, s.u, s.f, s.K, s.scratch);
    for (int v = 0; v < V; v++)
        for (int w = 0; w <= v; w++)
            for (int e = 0; e < 9; e++) {
                const int i = 3 * v + e / 3, j = 3 * w + e % 3;
                K[i * n + j] = K[j * n + i] = s.K[9 * hobe_pair(v, w) + e][0];
            }
    single_free(&s);
    return HOBE_OK;
}

void hobe_element_mass(const hobe_element *element, double *M)
{
    const int V = element->kernel->vectors, n = 3 * V;
    memset(M, 0, (size_t)(n * n) * sizeof *M);
    for (int v = 0; v < V; v++)
        for (int w = 0; w < V; w++)
            for (int a = 0; a < 3; a++)
                M[(3 * v + a) * n + 3 * w + a] = element->invariants.mass[v * V + w];
}
