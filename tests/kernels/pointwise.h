/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An independent evaluator of ANCF beam elements, to test the generated kernels against.
 *
 * It is the textbook, point by point: position r(xi,y,z) from the nodal vectors, deformation
 * gradient F, Green-Lagrange strain E = (F'F - I)/2, second Piola-Kirchhoff stress, virtual work,
 * Gauss points through the volume of a rectangular beam, straight or with any reference.  It has
 * its own table of elements and its own Gauss rules, and shares neither code nor tables with the
 * kernels or with the library.  Slow on purpose: long double, and derivatives by the complex step
 * f'(x) = Im f(x + ih)/h, which loses no digits.
 *
 * Units are SI.  Nodal vectors are flat arrays q[3*v + i], in the order of the element's nodes and
 * of its vectors at a node; F and E refer to the axes of the section, q to the global ones. */
#ifndef HOBE_TEST_POINTWISE_H
#define HOBE_TEST_POINTWISE_H

#include <complex.h>

typedef long double real;
typedef long double complex number;

enum {
    PW_NODES = 4,
    PW_MODES = 17,   /* MGD30d2 */
    PW_VECTORS = 52, /* MGD30d2 */
    PW_DOFS = 3 * PW_VECTORS,
    PW_GAUSS = 10 /* points of a Gauss rule in one direction, at most */
};

/* Axial functions of a field. */
enum pw_field { PW_LINEAR, PW_QUADRATIC, PW_CUBIC, PW_HERMITE };

struct pw_vector {
    int node, mode, slope; /* slope 1: the derivative d/dx of the mode's field at the node */
};

struct pw_element {
    const char *name;
    int nodes, modes, vectors;
    int degree;                   /* of the monomial modes: the highest power of y or of z */
    int structural;               /* a rod whose section strains, not a continuum */
    enum pw_field centre, others; /* of the mode 1, of all other modes */
    char mode[PW_MODES][8];       /* "1", "y", "z", "w", "yy", ... in the order they appear */
    struct pw_vector vector[PW_VECTORS];
};

/* The number of elements in the table, and the i-th one. */
int pw_elements(void);
void pw_element(int i, struct pw_element *element);

/* Finds an element by name; 0 if the table has none. */
int pw_find(const char *name, struct pw_element *element);

/* How Poisson's ratio and the shear corrections enter the energy. */
enum pw_mechanics {
    PW_AXIS,       /* E0 in the volume, Enu on the axis y = z = 0 with the whole area (eq. 26) */
    PW_AVERAGE,    /* E0 in the volume, Enu on the mean strain of each section; what warping
                      functions alone strain the section in its plane is spread over it evenly */
    PW_FULL,       /* unsplit continuum mechanics */
    PW_MEAN_SHEAR, /* as PW_AVERAGE, but k2 and k3 correct the mean shear strain only */
    PW_STRUCTURAL, /* the law of structural elements, and theirs alone */
    PW_LAWS
};

/* The section function w: value, d/dy, d/dz. */
typedef void pw_function(real y, real z, real w[3]);

/* One straight element of a rectangular section with its centre at (y, z) of the beam's axes: off
 * the axis no integral over the section vanishes by symmetry. */
struct pw_beam {
    struct pw_element element;
    real length, width, height; /* along x, y, z */
    real y, z;                  /* the section's centre */
    real E, nu, k2, k3;         /* k2 multiplies G on xz, k3 on xy */
    enum pw_mechanics mechanics;
    pw_function *warping;  /* a polynomial; only called where the element has the mode w */
    int warping_degree;    /* its highest power of y or of z */
    int extra;             /* Gauss points beyond those that integrate exactly (normally 0) */
    const real *reference; /* [3 vectors] curved, pretwisted, distorted; NULL: straight */
    const real *from;      /* [3 vectors] what q is counted from, a state without strain; NULL: 0 */
    real taper;            /* w grows along the element by the factor 1 + taper xi */
    real J, ys, zs;        /* PW_STRUCTURAL: torsion constant and shear centre, any */
};

/* The relative spacing of `real` as it is computed here: 1e-19 on x86, 2e-16 on machines whose long
 * double is a double, and under valgrind. */
real pw_epsilon(void);

/* Gauss-Legendre on [0,1]: exact up to degree 2n - 1. */
void pw_gauss(int n, real *x, real *weight);

/* Axial functions N[v] and dN/dx[v] at xi in [0,1]. */
void pw_shape(const struct pw_beam *beam, real xi, real *N, real *Nx);

/* Section modes: phi[3*k] = phi_k, d phi_k/dy, d phi_k/dz. */
void pw_modes(const struct pw_beam *beam, real y, real z, real *phi);

/* The reference configuration for a frame whose rows are e_x, e_y, e_z. */
void pw_reference(const struct pw_beam *beam, const real *frame, real *q0);

/* Strain energy U(q), force dU/dq (virtual work of the first Piola-Kirchhoff stress) and tangent
 * K[3V][3V] (complex step of the force). */
number pw_energy(const struct pw_beam *beam, const number *q);
void pw_force(const struct pw_beam *beam, const number *q, number *f);
void pw_tangent(const struct pw_beam *beam, const real *q, real *K);

/* The energy of a structural element; unless f is NULL, the force is added to f.  For the functions
 * above. */
number pw_rod(const struct pw_beam *beam, const number *q, number *f);

/* Whether a law is one of an element's. */
int pw_goes_with(enum pw_mechanics law, int structural);

/* Green-Lagrange strain at a point: xx, yy, zz, 2yz, 2xz, 2xy. */
void pw_strain(const struct pw_beam *beam, const real *q, real xi, real y, real z, real *E);

/* M[V][V] = rho int N_v phi_v N_w phi_w dV. */
void pw_mass(const struct pw_beam *beam, real density, real *M);

/* The energy per volume of a homogeneous strain, and its derivatives: the stress of the part that
 * acts in the volume and of the part that acts on the mean strain (Enu), Voigt order. */
real pw_density(const struct pw_beam *beam, const real *E, real *volume, real *mean);

#endif
