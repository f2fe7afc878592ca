/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The structural element's energy and force as its authors write them (Nachbagauer, Gruber &
 * Gerstmayr 2013): unit vectors differentiated by the chain rule, one degree of freedom after the
 * other, on the two Gauss and three Lobatto points of a quadratic beam. */
#include "pointwise.h"

#include <math.h>

enum { SLOPE, SLOPE_Y, SLOPE_Z, Y, Z, FIELDS }; /* r_x, r_xy, r_xz, r_y, r_z */
enum { RODS = 6, STRAINS = 9 };                 /* strains of the rod, then of the section */

static number dot(const number *a, const number *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const number *a, const number *b, number *c)
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* n = v/|v|, and its change dn = (dv - n (n.dv))/|v| */
static void unit(const number *v, const number *dv, number *n, number *dn)
{
    number length = csqrtl(dot(v, v));
    for (int i = 0; i < 3; i++)
        n[i] = v[i] / length;
    for (int i = 0; i < 3; i++)
        dn[i] = (dv[i] - n[i] * dot(n, dv)) / length;
}

/* The frame e of a section, and its change de with that of the section's slopes. */
static void frame(number D[FIELDS][3], number dD[FIELDS][3], number e[3][3], number de[3][3])
{
    number c[3], dc[3], other[3];
    cross(D[Y], D[Z], c);
    cross(dD[Y], D[Z], dc);
    cross(D[Y], dD[Z], other);
    for (int i = 0; i < 3; i++)
        dc[i] += other[i];
    unit(c, dc, e[0], de[0]);
    unit(D[Z], dD[Z], e[2], de[2]);
    cross(e[2], e[0], e[1]);
    cross(de[2], e[0], de[1]);
    cross(e[2], de[0], other);
    for (int i = 0; i < 3; i++)
        de[1][i] += other[i];
}

/* d(a.b) */
static number product_change(const number *a, const number *da, const number *b, const number *db)
{
    return dot(a, db) + dot(da, b);
}

/* Strains s of D and their changes ds with dD. */
static void strains(number D[FIELDS][3], number dD[FIELDS][3], number *s, number *ds)
{
    number e[3][3], de[3][3];
    frame(D, dD, e, de);
    for (int i = 0; i < 3; i++) {
        s[i] = dot(e[i], D[SLOPE]);
        ds[i] = product_change(e[i], de[i], D[SLOPE], dD[SLOPE]);
    }
    s[3] = (dot(e[2], D[SLOPE_Y]) - dot(e[1], D[SLOPE_Z])) / 2;
    ds[3] = (product_change(e[2], de[2], D[SLOPE_Y], dD[SLOPE_Y]) -
             product_change(e[1], de[1], D[SLOPE_Z], dD[SLOPE_Z])) /
            2;
    s[4] = dot(e[0], D[SLOPE_Z]);
    ds[4] = product_change(e[0], de[0], D[SLOPE_Z], dD[SLOPE_Z]);
    s[5] = -dot(e[0], D[SLOPE_Y]);
    ds[5] = -product_change(e[0], de[0], D[SLOPE_Y], dD[SLOPE_Y]);
    s[6] = dot(D[Y], D[Y]) / 2;
    s[7] = dot(D[Z], D[Z]) / 2;
    s[8] = dot(D[Y], D[Z]);
    ds[6] = dot(D[Y], dD[Y]);
    ds[7] = dot(D[Z], dD[Z]);
    ds[8] = product_change(D[Y], dD[Y], D[Z], dD[Z]);
}

/* The resultants of a rectangle's stresses: axial force and bending moments about the axis, which
 * need not be the centroid; shear forces of the strains in the shear centre; torsion. */
static void stresses(const struct pw_beam *beam, const number *s, number *t)
{
    const real y = beam->y, z = beam->z, E = beam->E, G = E / (2 * (1 + beam->nu));
    const real A = beam->width * beam->height;
    const real Iyy = A * (beam->height * beam->height / 12 + z * z);
    const real Izz = A * (beam->width * beam->width / 12 + y * y);
    t[0] = E * A * (s[0] + z * s[4] - y * s[5]);
    t[4] = E * (A * z * s[0] + Iyy * s[4] - A * y * z * s[5]);
    t[5] = E * (Izz * s[5] - A * y * s[0] - A * y * z * s[4]);
    t[1] = beam->k3 * G * A * (s[1] - beam->zs * s[3]);
    t[2] = beam->k2 * G * A * (s[2] + beam->ys * s[3]);
    t[3] = G * beam->J * s[3] - beam->zs * t[1] + beam->ys * t[2];
    t[6] = E * A * s[6];
    t[7] = E * A * s[7];
    t[8] = G * A * s[8];
}

static void add_vector(const struct pw_vector *vector, int i, number value, const real *N,
                       const real *Nx, int v, number D[FIELDS][3])
{
    static const int slope[] = {SLOPE, SLOPE_Y, SLOPE_Z}, plain[] = {-1, Y, Z};
    D[slope[vector->mode]][i] += Nx[v] * value;
    if (plain[vector->mode] >= 0)
        D[plain[vector->mode]][i] += N[v] * value;
}

static void fields(const struct pw_beam *beam, const number *q, const real *N, const real *Nx,
                   number D[FIELDS][3])
{
    for (int i = 0; i < 3 * FIELDS; i++)
        D[i / 3][i % 3] = 0;
    for (int v = 0; v < beam->element.vectors; v++)
        for (int i = 0; i < 3; i++)
            add_vector(&beam->element.vector[v], i, q[3 * v + i], N, Nx, v, D);
}

/* Strains since the reference: beam->reference, per length of its arc, which is returned; or
 * straight. */
static real rest(const struct pw_beam *beam, const real *N, const real *Nx, number *s)
{
    static const real straight[STRAINS] = {1, 0, 0, 0, 0, 0, 0.5L, 0.5L, 0};
    number q0[PW_DOFS], D[FIELDS][3], still[FIELDS][3] = {{0}}, none[STRAINS];
    for (int k = 0; k < STRAINS; k++)
        s[k] = straight[k];
    if (!beam->reference)
        return 1;
    for (int i = 0; i < 3 * beam->element.vectors; i++)
        q0[i] = beam->reference[i];
    fields(beam, q0, N, Nx, D);
    strains(D, still, s, none);
    return sqrtl(creall(dot(D[SLOPE], D[SLOPE])));
}

/* Adds a point's energy, and its part of the force unless f is NULL; strains first..last-1. */
static number point(const struct pw_beam *beam, const number *q, real xi, real weight, int first,
                    int last, number *f)
{
    real N[PW_VECTORS], Nx[PW_VECTORS];
    number D[FIELDS][3], dD[FIELDS][3] = {{0}}, s[STRAINS], s0[STRAINS], ds[STRAINS], t[STRAINS];
    number energy = 0;
    pw_shape(beam, xi, N, Nx);
    const real arc = rest(beam, N, Nx, s0), scale = first < RODS ? weight / arc : weight * arc;
    fields(beam, q, N, Nx, D);
    strains(D, dD, s, ds);
    for (int k = 0; k < STRAINS; k++)
        s[k] -= s0[k];
    stresses(beam, s, t);
    for (int k = first; k < last; k++)
        energy += scale * t[k] * s[k] / 2;
    for (int i = 0; f && i < 3 * beam->element.vectors; i++) {
        add_vector(&beam->element.vector[i / 3], i % 3, 1, N, Nx, i / 3, dD);
        strains(D, dD, s, ds);
        for (int k = first; k < last; k++)
            f[i] += scale * t[k] * ds[k];
        add_vector(&beam->element.vector[i / 3], i % 3, -1, N, Nx, i / 3, dD);
    }
    return energy;
}

number pw_rod(const struct pw_beam *beam, const number *q, number *f)
{
    const real third = 1 / 3.0L, gauss = 0.5L / sqrtl(3), l = beam->length;
    number energy = 0;
    for (int p = -1; p <= 1; p += 2)
        energy += point(beam, q, 0.5L + p * gauss, l / 2, 0, RODS, f);
    for (int p = 0; p <= 2; p++)
        energy += point(beam, q, p / 2.0L, l * third / (p == 1 ? 0.5L : 2), RODS, STRAINS, f);
    return energy;
}
