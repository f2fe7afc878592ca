/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What an element makes of its section: a beam's stiffness per length, without end effects.
 *
 * In a long prismatic beam under stretch, bending or torsion alone the strain does not depend on x:
 * d_k(x) is a rigid motion growing along x plus a constant c_k.  Any element represents that
 * exactly, so its tangent at rest, projected on these fields, gives a small quadratic form; with
 * the constants c_k free it leaves the beam's own stiffness against the four strains of the axis.
 */
#include "element_parts.h"

#include <string.h>

/* A constant whose energy is less than this, relative to what it had before others took their part
 * of it, costs none: reduced integration has such. */
static const double FREE = 1e-10;

enum { X, Y, Z };

/* d_k(x) = (c0 + c1 x + c2 x^2) e_a for one mode: sets the nodal vectors of field[vectors][3]. */
static void set_mode(const hobe_element *element, int mode, int axis, const double c[3],
                     double *field)
{
    const struct hobe_kernel *k = hobe_element_kernel(element);
    const double length = hobe_element_invariants(element)->length;
    for (int v = 0; v < k->vectors; v++)
        if (k->vector[v].mode == mode) {
            const double x = k->node[k->vector[v].node] * length;
            field[3 * v + axis] =
                k->vector[v].slope ? c[1] + 2 * c[2] * x : c[0] + c[1] * x + c[2] * x * x;
        }
}

/* The four motions: unit strain along the axis, unit curvatures about y and z, unit twist. */
static void set_motions(const hobe_element *element, int n, double *fields)
{
    static const struct {
        int motion, mode, axis;
        double c[3];
    } parts[] = {
        {HOBE_STRETCH, 0, X, {0, 1, 0}},
        {HOBE_BEND_Y, 0, Z, {0, 0, -0.5}}, /* u_x = z x, r_z turns along */
        {HOBE_BEND_Y, 2, X, {0, 1, 0}},
        {HOBE_BEND_Z, 0, Y, {0, 0, -0.5}},
        {HOBE_BEND_Z, 1, X, {0, 1, 0}},
        {HOBE_TWIST, 1, Z, {0, 1, 0}},
        {HOBE_TWIST, 2, Y, {0, -1, 0}},
    };
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        set_mode(element, parts[i].mode, parts[i].axis, parts[i].c, fields + parts[i].motion * n);
}

/* All fields, the four motions first; returns their number. */
static int set_fields(const hobe_element *element, double *fields)
{
    static const double constant[3] = {1, 0, 0};
    const struct hobe_kernel *k = hobe_element_kernel(element);
    const unsigned char *dropped = hobe_element_dropped(element);
    const int n = 3 * k->vectors;
    int count = HOBE_STRAINS;
    set_motions(element, n, fields);
    for (int mode = 1; mode < k->modes; mode++)
        for (int a = 0; a < 3; a++)
            /* r_y along z is left out: with r_z along y it would turn the beam about its axis */
            if (!dropped[mode] && !(mode == 1 && a == Z))
                set_mode(element, mode, a, constant, fields + count++ * n);
    return count;
}

/* Q = F K F' / length for the rows F[count][n], each of which is zero but for the vectors of a mode
 * or two, and a symmetric K; force[n] is scratch. */
static void project(double length, int n, const double *K, const double *F, int count,
                    double *force, double *Q)
{
    for (int j = 0; j < count; j++) {
        memset(force, 0, (size_t)n * sizeof *force);
        for (int b = 0; b < n; b++)
            for (int a = 0; a < n && F[j * n + b] != 0; a++)
                force[a] += F[j * n + b] * K[b * n + a];
        for (int i = 0; i <= j; i++) {
            double sum = 0;
            for (int a = 0; a < n; a++)
                sum += F[i * n + a] * force[a];
            Q[i * count + j] = Q[j * count + i] = sum / length;
        }
    }
}

/* C = Q_mm - Q_mc Q_cc^-1 Q_cm, m the motions, c the constants: these are eliminated one by one. */
static void relax(double *Q, int count, double C[HOBE_STRAINS][HOBE_STRAINS])
{
    double before[HOBE_STRAINS + 3 * HOBE_MAX_MODES];
    for (int i = 0; i < count; i++)
        before[i] = Q[i * count + i];
    for (int p = count - 1; p >= HOBE_STRAINS; p--) {
        const double *row = Q + p * count;
        if (row[p] <= FREE * before[p])
            continue;
        for (int i = 0; i < p; i++)
            for (int j = 0; j < p; j++)
                Q[i * count + j] -= Q[i * count + p] * row[j] / row[p];
    }
    for (int i = 0; i < HOBE_STRAINS; i++)
        memcpy(C[i], Q + i * count, sizeof C[i]);
}

enum hobe_status element_stiffness(const hobe_element *element, const double *K,
                                   double C[HOBE_STRAINS][HOBE_STRAINS], struct hobe_error *err)
{
    const struct hobe_kernel *k = hobe_element_kernel(element);
    const int n = 3 * k->vectors, most = HOBE_STRAINS + 3 * k->modes;
    double *force = hobe_alloc((size_t)n, sizeof *force, err);
    double *fields = hobe_alloc((size_t)(most * n), sizeof *fields, err);
    double *Q = hobe_alloc((size_t)(most * most), sizeof *Q, err);
    const enum hobe_status status = force && fields && Q ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status) {
        const int count = set_fields(element, fields);
        project(hobe_element_invariants(element)->length, n, K, fields, count, force, Q);
        relax(Q, count, C);
    }
    hobe_free(force);
    hobe_free(fields);
    hobe_free(Q);
    return status;
}

enum hobe_status hobe_element_stiffness(const hobe_element *element,
                                        double C[HOBE_STRAINS][HOBE_STRAINS],
                                        struct hobe_error *err)
{
    const size_t n = 3 * (size_t)hobe_element_kernel(element)->vectors;
    double *K = hobe_alloc(n * n, sizeof *K, err);
    if (!K)
        return HOBE_NO_MEMORY;
    enum hobe_status status = element_tangent_at_rest(element, K, err);
    if (!status)
        status = element_stiffness(element, K, C, err);
    hobe_free(K);
    return status;
}
