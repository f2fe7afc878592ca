/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "points.h"

#include "kernel_vectors.h"
#include "machine.h"
#include "vector3.h"

extern points_function hobe_kernel_points, hobe_kernel_points_avx2, hobe_kernel_points_avx512;

points_function *points_evaluate(void)
{
    static points_function *const of[] = HOBE_MACHINES(points);
    return of[machine_in_use()];
}

double points_flops(int vectors, int points, int tangent)
{
    const double V = vectors, force = 36 * V + 129;
    return points * (tangent ? force + 105 * V + 61 * V * (V + 1) : force);
}

int points_of_rectangle(const struct hobe_kernel *kernel)
{
    const int n = 2 * kernel->degree + 1;
    return kernel->stations * n * n;
}

/* ---- rules ---------------------------------------------------------------------------------- */

/* Rules of a station: what is summed over the section, and the means of normal and shear strains.
 * Those at the same places share their points. */
enum { SECTION, MEAN_NORMAL, MEAN_SHEAR, RULES };

struct rules {
    const struct hobe_section_rule *rule[RULES];
    int at[RULES]; /* where the points of each begin among the station's */
    int points;    /* of all */
};

static int same_places(const struct hobe_section_rule *a, const struct hobe_section_rule *b)
{
    int same = a->points == b->points;
    for (int i = 0; same && i < a->points; i++)
        same = a->point[i].y == b->point[i].y && a->point[i].z == b->point[i].z;
    return same;
}

static void set_rules(const struct hobe_station *station, int rules, struct rules *of)
{
    *of = (struct rules){{&station->rule, &station->mean_normal, &station->mean_shear}, {0}, 0};
    for (int r = 0; r < rules; r++) {
        int like = 0;
        while (like < r && !same_places(of->rule[like], of->rule[r]))
            like++;
        of->at[r] = like < r ? of->at[like] : of->points;
        of->points += like < r ? 0 : of->rule[r]->points;
    }
}

/* ---- tables --------------------------------------------------------------------------------- */

/* Gradients of N_v phi_v with respect to x, y, z where the modes are phi. */
static void set_gradients(const struct hobe_kernel *k, const double *N, const double *Nx,
                          const double (*phi)[4], double *gradient)
{
    for (int v = 0; v < k->vectors; v++) {
        const double *at = phi[k->vector[v].mode];
        gradient[3 * v] = Nx[v] * at[0] + N[v] * at[3];
        gradient[3 * v + 1] = N[v] * at[1];
        gradient[3 * v + 2] = N[v] * at[2];
    }
}

/* The same with respect to X on the section's axes in the reference q0: J^-T times it, J = dX/d(x,
 * y, z), whose cofactors are products of its rows.  Returns det J. */
static double turn_gradients(int vectors, const double axes[3][3], const double *q0,
                             double *gradient)
{
    double J[3][3] = {{0}}, cofactor[3][3];
    for (int v = 0; v < vectors; v++)
        for (int i = 0; i < 3; i++)
            for (int a = 0; a < 3; a++)
                J[i][a] += dot3(axes[i], q0 + 3 * v) * gradient[3 * v + a];
    for (int i = 0; i < 3; i++)
        cross3(J[(i + 1) % 3], J[(i + 2) % 3], cofactor[i]);
    const double det = dot3(J[0], cofactor[0]);
    for (int v = 0; v < vectors; v++) {
        const double G[3] = {gradient[3 * v], gradient[3 * v + 1], gradient[3 * v + 2]};
        for (int i = 0; i < 3; i++)
            gradient[3 * v + i] = dot3(cofactor[i], G) / det;
    }
    return det;
}

/* The points of a rule at station g; volume[points]: weights times det J. */
static void set_points(const struct points *p, const struct hobe_kernel *k,
                       const struct hobe_invariants *inv, int g, int first,
                       const struct hobe_section_rule *rule, const double *q0, double *volume)
{
    const double *N = inv->N + g * k->vectors, *Nx = inv->Nx + g * k->vectors;
    double phi[HOBE_MAX_MODES][4], axes[3][3];
    if (q0)
        hobe_kernel_axes(k, N, Nx, q0, axes);
    for (int i = 0; i < rule->points; i++) {
        const struct hobe_section_point *at = rule->point + i;
        double *G = p->gradient + 3L * k->vectors * (first + i);
        k->section_modes(at->y, at->z, at->f, phi);
        set_gradients(k, N, Nx, (const double(*)[4])phi, G);
        volume[i] = at->weight;
        if (q0)
            volume[i] *= turn_gradients(k->vectors, (const double(*)[3])axes, q0, G);
        p->region[first + i] = (unsigned char)at->region;
    }
}

static void add_law(const struct hobe_elasticity *C, double weight, struct hobe_elasticity *sum)
{
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++)
            sum->normal[a][b] += weight * C->normal[a][b];
        sum->shear[a] += weight * C->shear[a];
    }
}

/* The weights of one rule of a station, whose points are from `first` on. */
static void set_weights(const struct points *p, int g, int rule, int first, int points,
                        double length, const double *volume)
{
    double total = 0;
    for (int i = 0; i < points; i++)
        total += volume[i];
    for (int i = 0; i < points; i++) {
        const int at = first + i;
        if (rule != SECTION)
            p->share[2 * at + rule - MEAN_NORMAL] = volume[i] / total;
        else
            p->weight[at] = length * volume[i];
        if (rule == SECTION && p->warps)
            add_law(p->law + p->region[at], length * volume[i], p->sum + g);
    }
    if (rule == SECTION && p->share)
        p->volume[g] = length * total;
}

static enum hobe_status allocate(struct points *p, int means, int relieved, struct hobe_error *err)
{
    const size_t n = (size_t)p->first[p->stations], V = (size_t)p->vectors, G = (size_t)p->stations;
    p->position = hobe_alloc(V, sizeof *p->position, err);
    p->weight = hobe_alloc(n, sizeof *p->weight, err);
    p->gradient = hobe_alloc(3 * n * V, sizeof *p->gradient, err);
    p->region = hobe_alloc(n, sizeof *p->region, err);
    int failed = !p->position || !p->weight || !p->gradient || !p->region;
    if (means && !failed) {
        p->share = hobe_alloc(2 * n, sizeof *p->share, err);
        p->volume = hobe_alloc(G, sizeof *p->volume, err);
        failed = !p->share || !p->volume;
    }
    if (relieved && !failed) {
        p->warps = hobe_alloc(V, sizeof *p->warps, err);
        p->sum = hobe_alloc(G, sizeof *p->sum, err);
        failed = !p->warps || !p->sum;
    }
    return failed ? HOBE_NO_MEMORY : HOBE_OK;
}

/* Whether the law is that of means, too. */
static int has_mean(const struct hobe_elasticity *mean)
{
    int found = 0;
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++)
            found |= mean->normal[a][b] != 0;
        found |= mean->shear[a] != 0;
    }
    return found;
}

enum hobe_status points_open(struct points *p, const struct hobe_kernel *kernel,
                             const struct hobe_invariants *inv, int sections,
                             const struct hobe_station *station, const struct hobe_law *law,
                             const double *q0, struct hobe_error *err)
{
    const int relieved = law->relieved && kernel->warping_strain;
    const int means = relieved || has_mean(&law->mean), rules = means ? RULES : 1;
    struct rules of;
    *p = (struct points){.vectors = kernel->vectors, .stations = inv->stations, .mean = law->mean};
    memcpy(p->law, law->region, (size_t)law->regions * sizeof *p->law);
    p->first = hobe_alloc((size_t)inv->stations + 1, sizeof *p->first, err);
    for (int g = 0; p->first && g < inv->stations; g++) {
        set_rules(station + (sections > 1 ? g : 0), rules, &of);
        p->first[g + 1] = p->first[g] + of.points;
    }
    double *volume = NULL;
    if (!p->first || allocate(p, means, relieved, err) ||
        !(volume = hobe_alloc((size_t)p->first[inv->stations], sizeof *volume, err)))
        return HOBE_NO_MEMORY;
    for (int v = 0; v < kernel->vectors; v++) {
        const struct hobe_vector *is = kernel->vector + v;
        p->position[v] = is->mode == 0 && !is->slope;
        if (relieved)
            p->warps[v] = kernel->mode[is->mode][0] == 'w';
    }
    for (int g = 0; g < inv->stations; g++) {
        set_rules(station + (sections > 1 ? g : 0), rules, &of);
        for (int r = 0; r < rules; r++) {
            const int first = p->first[g] + of.at[r];
            set_points(p, kernel, inv, g, first, of.rule[r], q0, volume);
            set_weights(p, g, r, first, of.rule[r]->points, inv->wx[g], volume);
        }
    }
    hobe_free(volume);
    return HOBE_OK;
}

void points_close(struct points *p)
{
    hobe_free(p->first);
    hobe_free(p->position);
    hobe_free(p->weight);
    hobe_free(p->gradient);
    hobe_free(p->region);
    hobe_free(p->share);
    hobe_free(p->volume);
    hobe_free(p->warps);
    hobe_free(p->sum);
    *p = (struct points){0};
}
