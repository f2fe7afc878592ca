/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench_baseline.h"

#include "element.h"
#include "machine.h"

extern const struct bench_machine hobe_kernel_bench, hobe_kernel_bench_avx2,
    hobe_kernel_bench_avx512;

const struct bench_machine *bench_machine(void)
{
    static const struct bench_machine *const machines[] = HOBE_MACHINES(bench);
    return machines[machine_in_use()];
}

double bench_printed_flops(const struct bench_tensors *t, int tangent)
{
    const double V = t->vectors, force = V * V * (2 * V * V + 2 * V + 12);
    return tangent ? force + V * (V + 1) / 2 * (21 * V * V + 3) : force;
}

/* ---- a section at few points ---------------------------------------------------------------- */

static const hobe_section *original(const hobe_section *section)
{
    return ((const struct bench_section *)section)->of;
}

static void functions(const hobe_section *section, int paper, double y, double z, double (*f)[4])
{
    original(section)->kind->functions(original(section), paper, y, z, f);
}

static enum hobe_status rule(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err)
{
    const struct hobe_section_properties *of = &section->properties;
    const int n = 2 * kernel->degree + 1;
    double(*gauss)[2] = hobe_alloc((size_t)n, sizeof *gauss, err);
    enum hobe_status status = gauss ? hobe_gauss(n, gauss, err) : HOBE_NO_MEMORY;
    *rule = (struct hobe_rule){0};
    if (!status)
        status = hobe_rule_new(rule, (size_t)(n * n), err);
    for (int i = 0; !status && i < n * n; i++) {
        struct hobe_section_point *at = rule->point + i;
        const double *y = gauss[i / n], *z = gauss[i % n];
        at->y = of->width * (y[0] - 0.5);
        at->z = of->height * (z[0] - 0.5);
        at->weight = of->A * y[1] * z[1];
        functions(section, integration == HOBE_INTEGRATION_PAPER, at->y, at->z, at->f);
    }
    hobe_free(gauss);
    return status;
}

void bench_section_open(struct bench_section *section, const hobe_section *of)
{
    static const struct hobe_section_kind kind = {.rule = rule, .functions = functions};
    section->base = *of;
    section->base.kind = &kind;
    section->of = of;
}

/* ---- tables --------------------------------------------------------------------------------- */

enum hobe_status bench_points_open(struct points *p, const hobe_element *element,
                                   const hobe_section *section, struct hobe_error *err)
{
    const struct hobe_kernel *k = hobe_element_kernel(element);
    struct hobe_rule rule;
    enum hobe_status status =
        hobe_section_rule(section, k, HOBE_INTEGRATION_EXACT, NULL, &rule, err);
    if (status)
        return status;
    status = points_open(p, k, hobe_element_invariants(element), 1,
                         &(struct hobe_station){.rule = rule.rule}, hobe_element_law(element), NULL,
                         err);
    hobe_rule_free(&rule);
    return status;
}

/* rows[6] = the strain xx, yy, zz, 2yz, 2xz, 2xy of a pair of vectors: sym(G_v G_w'), twice its
 * normal part. */
static void pair_rows(const double *Gv, const double *Gw, double *rows)
{
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        rows[a] = Gv[a] * Gw[a];
        rows[3 + a] = Gv[b] * Gw[c] + Gv[c] * Gw[b];
    }
}

/* stress[6] = weight C rows, by pairs: normal, shear */
static void pair_stress(const struct hobe_elasticity *C, double weight, const double *rows,
                        double *stress)
{
    for (int a = 0; a < 3; a++) {
        stress[a] = weight * (C->normal[a][0] * rows[0] + C->normal[a][1] * rows[1] +
                              C->normal[a][2] * rows[2]);
        stress[3 + a] = weight * C->shear[a] * rows[3 + a];
    }
}

/* One point's part of A and b. */
static void add_tensors(struct bench_tensors *t, const struct points *p, int point)
{
    const int V = t->vectors;
    const double *G = p->gradient + (long)3 * V * point;
    double left[6], right[6], stress[6], *A = t->A;
    for (int i = 0; i < V; i++)
        for (int j = 0; j < V; j++)
            for (int k = 0; k < V; k++) {
                pair_rows(G + 3 * i, G + 3 * k, left);
                pair_stress(p->law, p->weight[point], left, stress);
                if (j == 0)
                    t->b[V * i + k] += stress[0] + stress[1] + stress[2];
                for (int v = 0; v < V; v++, A++) {
                    pair_rows(G + 3 * j, G + 3 * v, right);
                    for (int r = 0; r < 6; r++)
                        *A += stress[r] * right[r];
                }
            }
}

enum hobe_status bench_tensors_open(struct bench_tensors *t, const struct points *p,
                                    struct hobe_error *err)
{
    const size_t V = (size_t)p->vectors;
    t->vectors = p->vectors;
    t->A = hobe_alloc(V * V * V * V, sizeof *t->A, err);
    t->b = hobe_alloc(V * V, sizeof *t->b, err);
    t->scratch = hobe_alloc(3 * V + 2 * V * V, sizeof *t->scratch, err);
    if (!t->A || !t->b || !t->scratch) {
        bench_tensors_close(t);
        return HOBE_NO_MEMORY;
    }
    for (int i = 0; i < p->first[p->stations]; i++)
        add_tensors(t, p, i);
    return HOBE_OK;
}

void bench_tensors_close(struct bench_tensors *t)
{
    hobe_free(t->A);
    hobe_free(t->b);
    hobe_free(t->scratch);
    *t = (struct bench_tensors){0};
}
