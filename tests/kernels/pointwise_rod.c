/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The structural element's energy and force as its authors write them (Nachbagauer, Gruber &
 * Gerstmayr 2013): unit vectors and their derivatives along the beam by the chain rule, on the two
 * Gauss and three Lobatto points of a quadratic beam.  The force differentiates the strains one
 * degree of freedom after the other, with dual numbers. */
#include "pointwise.h"

#include <math.h>
#include <string.h>

enum { SLOPE, SLOPE_Y, SLOPE_Z, Y, Z, FIELDS }; /* r_x, r_xy, r_xz, r_y, r_z */
enum { RODS = 6, STRAINS = 9 };                 /* strains of the rod, then of the section */

/* A value and its derivative by one degree of freedom. */
typedef struct {
    number v, d;
} dual;

static dual plus(dual a, real factor, dual b)
{
    return (dual){a.v + factor * b.v, a.d + factor * b.d};
}

static dual times(dual a, dual b)
{
    return (dual){a.v * b.v, a.d * b.v + a.v * b.d};
}

static dual over(dual a, dual b)
{
    return (dual){a.v / b.v, (a.d - a.v / b.v * b.d) / b.v};
}

static dual root(dual a)
{
    const number r = csqrtl(a.v);
    return (dual){r, a.d / (2 * r)};
}

static dual dot(const dual *a, const dual *b)
{
    return plus(plus(times(a[0], b[0]), 1, times(a[1], b[1])), 1, times(a[2], b[2]));
}

/* c += a x b */
static void add_cross(const dual *a, const dual *b, dual *c)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = plus(c[i], 1, plus(times(a[j], b[k]), -1, times(a[k], b[j])));
    }
}

/* n = v/|v| and n' = (v' - n (n.v'))/|v| */
static void unit(const dual *v, const dual *v_x, dual *n, dual *n_x)
{
    const dual length = root(dot(v, v));
    for (int i = 0; i < 3; i++)
        n[i] = over(v[i], length);
    const dual along = dot(n, v_x);
    for (int i = 0; i < 3; i++)
        n_x[i] = over(plus(v_x[i], -1, times(n[i], along)), length);
}

/* The frame of a section and its derivative along the beam. */
static void frame(dual D[FIELDS][3], dual e[3][3], dual e_x[3][3])
{
    dual c[3] = {{0}}, c_x[3] = {{0}};
    memset(e[1], 0, sizeof e[1]);
    memset(e_x[1], 0, sizeof e_x[1]);
    add_cross(D[Y], D[Z], c);
    add_cross(D[SLOPE_Y], D[Z], c_x);
    add_cross(D[Y], D[SLOPE_Z], c_x);
    unit(c, c_x, e[0], e_x[0]);
    unit(D[Z], D[SLOPE_Z], e[2], e_x[2]);
    add_cross(e[2], e[0], e[1]);
    add_cross(e_x[2], e[0], e_x[1]);
    add_cross(e[2], e_x[0], e_x[1]);
}

static void strains(dual D[FIELDS][3], dual *s)
{
    static const dual half = {0.5L, 0};
    dual e[3][3], e_x[3][3], twice[3] = {{0}};
    frame(D, e, e_x);
    for (int i = 0; i < 3; i++)
        add_cross(e[i], e_x[i], twice); /* twice the vector of twist and curvature */
    for (int i = 0; i < 3; i++) {
        s[i] = dot(e[i], D[SLOPE]);
        s[3 + i] = times(half, dot(e[i], twice));
    }
    s[6] = times(half, dot(D[Y], D[Y]));
    s[7] = times(half, dot(D[Z], D[Z]));
    s[8] = dot(D[Y], D[Z]);
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

/* The fields at a point; component `column` of the nodal vectors is what d differentiates by. */
static void fields(const struct pw_beam *beam, const number *q, const real *N, const real *Nx,
                   int column, dual D[FIELDS][3])
{
    static const int slope[] = {SLOPE, SLOPE_Y, SLOPE_Z}, plain[] = {-1, Y, Z};
    memset(D, 0, FIELDS * sizeof D[0]);
    for (int i = 0; i < 3 * beam->element.vectors; i++) {
        const int v = i / 3, mode = beam->element.vector[v].mode;
        const dual x = {q[i], i == column};
        D[slope[mode]][i % 3] = plus(D[slope[mode]][i % 3], Nx[v], x);
        if (plain[mode] >= 0)
            D[plain[mode]][i % 3] = plus(D[plain[mode]][i % 3], N[v], x);
    }
}

/* Strains of the reference, and its length of arc by x: beam->from, beam->reference, or straight.
 */
static real rest(const struct pw_beam *beam, const real *N, const real *Nx, dual *s)
{
    static const real straight[STRAINS] = {1, 0, 0, 0, 0, 0, 0.5L, 0.5L, 0};
    number q0[PW_DOFS];
    dual D[FIELDS][3];
    for (int k = 0; k < STRAINS; k++)
        s[k] = (dual){straight[k], 0};
    const real *reference = beam->from ? beam->from : beam->reference;
    if (!reference)
        return 1;
    for (int i = 0; i < 3 * beam->element.vectors; i++)
        q0[i] = reference[i];
    fields(beam, q0, N, Nx, -1, D);
    strains(D, s);
    return sqrtl(creall(dot(D[SLOPE], D[SLOPE]).v));
}

/* A point's energy, and its part of the force unless f is NULL; strains first..last-1. */
static number point(const struct pw_beam *beam, const number *q, real xi, real weight, int first,
                    int last, number *f)
{
    real N[PW_VECTORS], Nx[PW_VECTORS];
    dual D[FIELDS][3], s[STRAINS], s0[STRAINS];
    number change[STRAINS], t[STRAINS], energy = 0;
    pw_shape(beam, xi, N, Nx);
    const real arc = rest(beam, N, Nx, s0), scale = first < RODS ? weight / arc : weight * arc;
    fields(beam, q, N, Nx, -1, D);
    strains(D, s);
    for (int k = 0; k < STRAINS; k++)
        change[k] = s[k].v - s0[k].v;
    stresses(beam, change, t);
    for (int k = first; k < last; k++)
        energy += scale * t[k] * change[k] / 2;
    for (int i = 0; f && i < 3 * beam->element.vectors; i++) {
        fields(beam, q, N, Nx, i, D);
        strains(D, s);
        for (int k = first; k < last; k++)
            f[i] += scale * t[k] * s[k].d;
    }
    return energy;
}

number pw_rod(const struct pw_beam *beam, const number *change, number *f)
{
    number q[PW_DOFS];
    for (int i = 0; i < 3 * beam->element.vectors; i++)
        q[i] = change[i] + (beam->from ? beam->from[i] : 0);
    const real third = 1 / 3.0L, gauss = 0.5L / sqrtl(3), l = beam->length;
    number energy = 0;
    for (int p = -1; p <= 1; p += 2)
        energy += point(beam, q, 0.5L + p * gauss, l / 2, 0, RODS, f);
    for (int p = 0; p <= 2; p++)
        energy += point(beam, q, p / 2.0L, l * third / (p == 1 ? 0.5L : 2), RODS, STRAINS, f);
    return energy;
}
