/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "homogeneous.h"

#include "check.h"

#include <math.h>
#include <stdlib.h>

/* LAPACK: solves the symmetric positive definite A X = B. */
extern void dposv_(const char *triangle, const int *n, const int *columns, double *A,
                   const int *lda, double *B, const int *ldb, int *info);

enum { X, Y, Z };

static double *allocate(int n)
{
    double *p = calloc((size_t)n, sizeof *p);
    if (!p)
        check_stop("out of memory: %d numbers", n);
    return p;
}

/* d_k(x) = (c0 + c1 x + c2 x^2) e_a for one mode: sets the nodal vectors of field[vectors][3]. */
static void set_mode(const hobe_element *element, int mode, int axis, double c0, double c1,
                     double c2, double *field)
{
    const struct hobe_kernel *k = hobe_element_kernel(element);
    const double length = hobe_element_invariants(element)->length;
    for (int v = 0; v < k->vectors; v++)
        if (k->vector[v].mode == mode) {
            const double x = k->node[k->vector[v].node] * length;
            field[3 * v + axis] = k->vector[v].slope ? c1 + 2 * c2 * x : c0 + c1 * x + c2 * x * x;
        }
}

/* The four motions: unit strain along the axis, unit curvatures about y and z, unit twist. */
static void set_motion(const hobe_element *element, int which, double *field)
{
    switch (which) {
    case STRETCH:
        set_mode(element, 0, X, 0, 1, 0, field);
        break;
    case BEND_Y: /* u_x = z x, r_z turns along */
        set_mode(element, 0, Z, 0, 0, -0.5, field);
        set_mode(element, 2, X, 0, 1, 0, field);
        break;
    case BEND_Z:
        set_mode(element, 0, Y, 0, 0, -0.5, field);
        set_mode(element, 1, X, 0, 1, 0, field);
        break;
    default:
        set_mode(element, 1, Z, 0, 1, 0, field);
        set_mode(element, 2, Y, 0, -1, 0, field);
    }
}

/* All fields, the four motions first; returns their number. */
static int set_fields(const hobe_element *element, double *fields)
{
    const struct hobe_kernel *k = hobe_element_kernel(element);
    const unsigned char *dropped = hobe_element_dropped(element);
    const int n = 3 * k->vectors;
    int count = 0;
    for (; count < HOMOGENEOUS; count++)
        set_motion(element, count, fields + count * n);
    for (int mode = 1; mode < k->modes; mode++)
        for (int a = 0; a < 3; a++)
            /* r_y along z is left out: with r_z along y it would turn the beam about its axis */
            if (!dropped[mode] && !(mode == 1 && a == Z))
                set_mode(element, mode, a, 1, 0, 0, fields + count++ * n);
    return count;
}

/* Q = F K F' / length for the rows F[count][n] and the tangent at rest. */
static void project(const hobe_element *element, const double *F, int count, double *Q)
{
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int n = 3 * hobe_element_kernel(element)->vectors;
    double *q = allocate(n), *K = allocate(n * n), *force = allocate(n);
    struct hobe_error err;
    hobe_element_reference(element, identity, q);
    if (hobe_element_tangent(element, q, q, K, &err))
        check_stop("%s", err.message);
    for (int j = 0; j < count; j++) {
        for (int a = 0; a < n; a++) {
            force[a] = 0;
            for (int b = 0; b < n; b++)
                force[a] += K[a * n + b] * F[j * n + b];
        }
        for (int i = 0; i < count; i++) {
            double sum = 0;
            for (int a = 0; a < n; a++)
                sum += F[i * n + a] * force[a];
            Q[i * count + j] = sum / hobe_element_invariants(element)->length;
        }
    }
    free(q);
    free(K);
    free(force);
}

/* C = Q_mm - Q_mc Q_cc^-1 Q_cm: m the motions, c the constants, scaled to a diagonal of ones. */
static void relax(const double *Q, int count, double C[HOMOGENEOUS][HOMOGENEOUS])
{
    const int c = count - HOMOGENEOUS, columns = HOMOGENEOUS;
    double *A = allocate(c * c), *B = allocate(c * columns), *d = allocate(c);
    int info;
    for (int i = 0; i < c; i++)
        d[i] = 1 / sqrt(Q[(i + HOMOGENEOUS) * (count + 1)]);
    for (int i = 0; i < c; i++) {
        const double *row = Q + (i + HOMOGENEOUS) * count;
        for (int j = 0; j < c; j++)
            A[i * c + j] = d[i] * row[j + HOMOGENEOUS] * d[j];
        for (int m = 0; m < columns; m++)
            B[m * c + i] = d[i] * row[m];
    }
    dposv_("L", &c, &columns, A, &c, B, &c, &info);
    if (info)
        check_stop("a field that is constant along the axis costs no energy");
    for (int m = 0; m < columns; m++)
        for (int p = 0; p < columns; p++) {
            C[m][p] = Q[m * count + p];
            for (int i = 0; i < c; i++)
                C[m][p] -= Q[m * count + i + HOMOGENEOUS] * d[i] * B[p * c + i];
        }
    free(A);
    free(B);
    free(d);
}

void homogeneous_stiffness(const hobe_element *element, double C[HOMOGENEOUS][HOMOGENEOUS])
{
    const struct hobe_kernel *k = hobe_element_kernel(element);
    const int most = HOMOGENEOUS + 3 * k->modes;
    double *fields = allocate(most * 3 * k->vectors), *Q = allocate(most * most);
    const int count = set_fields(element, fields);
    project(element, fields, count, Q);
    relax(Q, count, C);
    free(fields);
    free(Q);
}
