/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernel ABI: the only header that generated code includes.
 *
 * A beam element is *axial functions* times *section modes*:
 *
 *     r(x,y,z) = sum_k phi_k(y,z) d_k(x),      d_k(x) = sum_v N_v(x) q_v,   k = mode of v,
 *
 * with nodal vectors q_v in R^3.  Of the M modes phi, phi_0 = 1.  The strain at a point of the
 * section depends on x only through the Gram matrix of the 2M-1 *section vectors*
 *
 *     D = (d_0', ..., d_{M-1}', d_1, ..., d_{M-1})            (d_0 itself never enters),
 *
 * so the energy per length is an exact quadratic form in the Gram differences from the reference
 *
 *     s_IJ = D_I.D_J - D0_I.D0_J  (I < J),     s_II = (D_I.D_I - D0_I.D0_I)/2,
 *
 * whose matrix holds every integral over the section (the H-tensor integrals of Tang, Tian & Hu
 * 2022, eqs. 27-28, factored into axis and section).  The Gram entries split into a *normal* block
 * (prime-prime and value-value pairs: eps_xx, eps_yy, eps_zz, 2 eps_yz) and a *shear* block
 * (prime-value pairs: 2 eps_xy, 2 eps_xz), which an isotropic law does not couple where the beam is
 * straight and its section the same all along.  Taper, curvature and pretwist couple them.
 *
 * That is the form "continuum".  The form "structural" keeps section vectors, invariants and
 * batches, and puts strains of another kind in the place of the Gram differences: those of a rod
 * whose section, with the modes 1, y, z, can stretch and shear (Nachbagauer, Gruber & Gerstmayr
 * 2013).  On the frame e_3 along d_z, e_1 normal to d_y and d_z, e_2 = e_3 x e_1 they are the
 * changes of
 *
 *     the components of r' and of 1/2 sum_i e_i x e_i'   the normal block: Gamma, kappa,
 *     d_y.d_y/2, d_z.d_z/2, d_y.d_z                      the shear block: E_yy, E_zz, 2 E_yz,
 *
 * and the energy is no polynomial of q.
 *
 * Differences are formed from displacements u = q - q0, not from positions, so that a small strain
 * keeps its digits and a beam far from the origin loses none.
 *
 * Arrays named `[..][HOBE_LANES]` or of type hobe_lanes hold one number for each of eight elements
 * (structure of arrays).  Elements of a batch share one hobe_invariants; spare lanes may hold
 * anything finite.  The caller owns all memory, and every array of hobe_lanes is aligned to
 * sizeof(hobe_lanes).  Kernels call no library, own no memory and keep no state.
 */
#ifndef HOBE_KERNEL_H
#define HOBE_KERNEL_H

#include <stddef.h>

/* Raised whenever anything below changes its meaning; generated files check it. */
#define HOBE_KERNEL_ABI 8

enum {
    HOBE_LANES = 8,          /* elements in a batch */
    HOBE_MAX_FUNCTIONS = 16, /* section functions (warping functions etc.) an element may use */
    HOBE_MAX_MODES = 24,     /* section modes of an element */
    HOBE_MAX_VECTORS = 256,  /* nodal vectors of an element */
    HOBE_MORE_STATIONS = 2   /* that invariants may have above those of the kernel */
};

typedef double hobe_lanes __attribute__((vector_size(8 * sizeof(double))));

/* The index of the Gram pair (i, j), i >= j, in a packed lower triangle; the same rule numbers the
 * 3 x 3 blocks of a tangent stiffness. */
static inline int hobe_pair(int i, int j)
{
    return i * (i + 1) / 2 + j;
}

/* One point of a section rule. */
struct hobe_section_point {
    double y, z;   /* m, from the centroid */
    double weight; /* m^2 */
    int region;    /* which of the section's materials is here */
    /* Section functions the element names: f, df/dy, df/dz, and df/dx at fixed y, z where the
     * section varies along the beam (else 0). */
    double f[HOBE_MAX_FUNCTIONS][4];
};

/* A cubature rule over a section: integral of g dA = sum of weight * g(point). */
struct hobe_section_rule {
    int points;
    const struct hobe_section_point *point; /* [points] */
};

/* The elastic law per length of beam (Tang et al. 2022, eq. 26),
 *
 *     W = 1/2 int eps:C:eps dA  +  1/2 A  mean(eps):C_mean:mean(eps),
 *
 * where C is that of the region of the section, and mean() the weighted mean over a rule of its
 * own: the whole section (mechanics `average`), or the axis alone (mechanics `axis`, the paper's
 * selective integration).  Normal order xx, yy, zz; shear order yz, xz, xy, conjugate to
 * engineering strains 2 eps.  Pa.  Strains are on the axes of the section in the reference: e_x
 * along the axis, e_y the part of r_y normal to it, e_z = e_x x e_y.
 *
 * A twist kappa makes d_w ~ kappa e_x of a warping function w, and with it a strain of second order
 * in the plane of the section.  Of all warping functions, the modes whose names begin with w,
 *
 *     eta_ab = 1/2 (dp/dX_a . dp/dX_b - its value in the reference),  a, b = y, z,
 *     p = sum_k w_k(y,z) d_k(x).
 *
 * The section itself undoes it by moving in its plane, but the modes y, z can undo its mean alone:
 * left as it is, the rest makes a thin-walled beam too stiff in large torsion (in the flange of an
 * I-section of height h it is the stress E h^2 kappa^2/8).  Mechanics `average` therefore has
 * eps - eta + mean(eta) in the place of eps in the first integral.  The mean is that of the mean
 * law, weighted with E, in shear with G: so mean(eps) stays what it is, and no other uniform strain
 * takes less energy away.  (The best displacement of a square in its plane would leave 4 % of that,
 * which is 3e-5 of its twist.)  Where nothing warps, as at rest, nothing changes, and the energy
 * stays a sum of squares. */
struct hobe_elasticity {
    double normal[3][3], shear[3];
};
struct hobe_law {
    int regions;
    const struct hobe_elasticity *region; /* [regions] C, acts at each point */
    const double *density;                /* [regions] kg/m^3 */
    struct hobe_elasticity mean;          /* C_mean, acts on the mean strain, with area A */
    int relieved;                         /* whether eta is taken at its mean */
};

/* The section at a station of the axis. */
struct hobe_station {
    struct hobe_section_rule rule;                    /* integrates over the section */
    struct hobe_section_rule mean_normal, mean_shear; /* mean the strains of the mean law */
    /* For the form "structural", which cannot know them from a rule: Saint-Venant's torsion
     * constant, m^4, such that G J is the torsional stiffness with the G of region 0; and the shear
     * centre y, z, m, from the centroid. */
    double J, shear_centre[2];
};

/* All integrals of an element's energy that do not depend on its state.  The arrays belong to the
 * caller; `hobe_kernel.invariants` fills them.  One set serves every element of equal length,
 * section, material, mechanics and shape. */
struct hobe_invariants {
    double length; /* m */
    int stations;  /* axial integration points */
    double *xi;    /* [stations]             their positions in [0,1] */
    double *wx;    /* [stations]             their weights times length, m */
    double *N;     /* [stations][vectors]    axial functions N_v */
    double *Nx;    /* [stations][vectors]    dN_v/dx, 1/m */
    double *Qn;    /* [blocks][normals][normals] dW = 1/2 s'Q s, normal block */
    double *Qs;    /* [blocks][shears][shears]   shear block */
    double *Qc;    /* [blocks][normals][shears]  what couples them; NULL where nothing does */
    ptrdiff_t step_n, step_s, step_c; /* from a station's block to the next; 0 where all are one */
    double *mass; /* [vectors][vectors] scalar mass matrix; M = mass (x) I_3, kg */
    int symmetry; /* what kernel->symmetry says of the above, or less; the form "structural" has no
                     use for it, nor for what follows */
    ptrdiff_t step;  /* kernel->section_cost[symmetry].numbers where there is a block for each
                        station; 0 where one is for all */
    double *section; /* [stations * kernel->axial + blocks * section_cost[symmetry].numbers], filled
                        by kernel->section: energy, force and tangent from station to station */
    double *tensor;  /* [kernel->tensor_cost[symmetry].numbers], filled by kernel->tensor: force and
                        tangent are products with it.  NULL: they go from station to station. */
};

/* Parities that an energy keeps apart: where the section is its own mirror image under y -> -y
 * every integral of a product odd in y vanishes; likewise z.  And likewise x, where values of modes
 * count as odd and their slopes d_k' as even, of a beam that is straight and prismatic. */
enum { HOBE_SYMMETRIC_X = 1, HOBE_SYMMETRIC_Y = 2, HOBE_SYMMETRIC_Z = 4, HOBE_SYMMETRIES = 8 };

/* What force and tangent cost by one plan where the energy keeps certain parities apart:
 * operations per element and call, straight and prismatic, at kernel->stations; and how many
 * numbers the tensor, or a block of the section's, has. */
struct hobe_plan_cost {
    long flops_force, flops_tangent;
    size_t numbers;
};

/* What a nodal vector is: the node it sits on, the mode it multiplies, and whether it is the value
 * of d_k there or its derivative d d_k/dx. */
struct hobe_vector {
    unsigned char node, mode, slope;
};

struct hobe_kernel {
    int abi;                   /* HOBE_KERNEL_ABI of the generator that wrote it */
    const char *name;          /* "MGD30w" */
    const char *hash;          /* of the declaration */
    const char *source;        /* where the element was published */
    const char *mechanics;     /* default elastic law: "average", "axis" or "full"; or "structural",
                                  the law of that form, which takes no other */
    int nodes, vectors, modes; /* sizes; 3 * vectors degrees of freedom */
    int functions;             /* section functions among the modes */
    int stations;              /* Gauss points on the axis that integrate the energy exactly */
    int degree;                /* of the section polynomials; the energy has 4 * degree */
    int normals, shears;       /* sizes of the blocks: M^2 and M(M-1); structural: 6 and 3 */
    long flops_force,
        flops_tangent;  /* per element and call, counted by the generator, at `stations`, straight
                           and prismatic with any section, from station to station */
    size_t scratch;     /* hobe_lanes the caller provides to force and tangent */
    const double *node; /* [nodes]     node positions xi */
    const double (*axis_rule)[2]; /* [stations] positions and weights on [0,1] that the element's
                                     strains are made for; NULL: Gauss-Legendre, `stations` or more
                                     points */
    const struct hobe_vector *vector; /* [vectors]  in the order of the degrees of freedom */
    const char *const *mode;          /* [modes]    names: "1", "y", "z", "w", "yy", ... */
    const char *const *function;      /* [functions] names of the section functions, "w" first */

    /* Axial functions and their x-derivatives at xi in [0,1] of an element of the given length:
     * N[vectors], Nx[vectors] (1/m). */
    void (*shape)(double xi, double length, double *N, double *Nx);

    /* Section modes at (y, z): phi[modes][4] = phi, d phi/dy, d phi/dz, d phi/dx.  f as in
     * hobe_section_point, only read where the element names section functions. */
    void (*section_modes)(double y, double z, const double (*f)[4], double (*phi)[4]);

    /* Fills inv (arrays owned by the caller, sizes as above) from the law and `sections` of the
     * axis: 1 for all stations, or one for each.  inv->length and inv->stations are set by the
     * caller; gauss[stations][2] holds positions and weights on [0,1], those of axis_rule if any.
     * q0: reference nodal vectors [vectors][3] of a curved, pretwisted or tapered element, whose
     * strains are taken through J0 = dr0/d(x,y,z) (eq. 22); inv then has a block for each station,
     * with Qc, and the mass matrix is summed over the stations.  NULL: straight and prismatic; inv
     * has one block and no Qc, and the mass matrix is exact whatever the rule on the axis. */
    void (*invariants)(struct hobe_invariants *inv, const double (*gauss)[2], int sections,
                       const struct hobe_station *station, const struct hobe_law *law,
                       const double *q0);

    /* Two plans for the sums of eqs. 27 and 28, products with constant matrices both; the more an
     * element is symmetric the fewer numbers they have.  `section` goes from station to station,
     * for any beam.  `tensor` takes all at once, for those that are straight and prismatic: the
     * energy is a quadratic form in the Gram differences of the nodal vectors, with a tensor that
     * holds every integral over the volume; it needs HOBE_SYMMETRIC_X.  By the bits
     * HOBE_SYMMETRIC_*, [HOBE_SYMMETRIES]; NULL, like the three functions, where the energy is not
     * quartic ("structural"). */
    const struct hobe_plan_cost *section_cost, *tensor_cost;
    size_t axial; /* numbers of the plan `section` that a station has, beside those of a block */

    /* The symmetries that the quadratic forms in inv have. */
    int (*symmetry)(const struct hobe_invariants *inv);

    /* Fill inv->section and inv->tensor, given by the caller with inv->symmetry and inv->step, from
     * the rest of inv, which for the tensor has one block; inv->symmetry may leave out what
     * kernel->symmetry says.  Energy, force, tangent, trilinear and gram need the first. */
    void (*section)(const struct hobe_invariants *inv);
    void (*tensor)(const struct hobe_invariants *inv);

    /* Strain energy of a batch, J.  q0: reference nodal vectors, u: displacements from it, both
     * [vectors][3][HOBE_LANES]; U[HOBE_LANES].  Only differences of the centreline's positions
     * matter, in u as in q0. */
    void (*energy)(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                   hobe_lanes *U);

    /* Elastic force +dU/dq (eq. 27 with the sign of eq. 29): f[vectors][3][HOBE_LANES], N or N m,
     * overwritten. */
    void (*force)(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                  hobe_lanes *f, hobe_lanes *scratch);

    /* Force as above and tangent stiffness (eq. 28): the lower triangle in 3 x 3 blocks,
     * K[hobe_pair(v,w)][3][3][HOBE_LANES], v >= w, diagonal blocks in full; overwritten. */
    void (*tangent)(const struct hobe_invariants *inv, const hobe_lanes *q0, const hobe_lanes *u,
                    hobe_lanes *f, hobe_lanes *K, hobe_lanes *scratch);

    /* The cubic force in multilinear form: f = T(a; b, c), linear in each and symmetric in b, c,
     * so that force(q) = T(q; q, q) - T(q; q0, q0).
     * Arguments as in force, absolute positions up to a common translation of each.  NULL where the
     * energy is not quartic ("structural"). */
    void (*trilinear)(const struct hobe_invariants *inv, const hobe_lanes *a, const hobe_lanes *b,
                      const hobe_lanes *c, hobe_lanes *f, hobe_lanes *scratch);

    /* The same by strains: of b and c, as above, the bilinear form of the Gram entries at every
     * station, strain[stations][normals + shears][HOBE_LANES] in an order of the kernel's own, and
     * stress = w Q strain, of the same shape.  Then
     *
     *     T(a; b, c).d = 2 sum strain(a, d) stress(b, c),
     *     energy(q) = 1/2 sum strain stress  of b = q + q0, c = u,
     *
     * and what many such sums share is found once.  Reduced models start here.  NULL where the
     * energy is not quartic ("structural"). */
    void (*gram)(const struct hobe_invariants *inv, const hobe_lanes *b, const hobe_lanes *c,
                 hobe_lanes *strain, hobe_lanes *stress);

    /* The force along a power series, q(a) = q0 + u_0 + a u_1 + a^2 u_2 + ...: to be called with
     * k = 1, 2, ... and u = u_(k-1), and gives the coefficient of a^k without the part of u_k
     * itself, which is K(u_0) u_k: f[vectors][3][HOBE_LANES], overwritten.  For orders up to K,
     * table[K + 1][stations][3 (2 modes - 1) + normals + shears] is the caller's and keeps section
     * vectors and stresses between the calls, so that an order costs O(k).  NULL where the energy
     * is not quartic ("structural"). */
    void (*series)(const struct hobe_invariants *inv, int k, const hobe_lanes *q0,
                   const hobe_lanes *u, hobe_lanes *table, hobe_lanes *f);

    /* Green-Lagrange strain at a point of one element on the section's axes there, from N, Nx of
     * `shape` and phi of `section_modes`; q0, u: [vectors][3].
     * E in Voigt order xx, yy, zz, 2yz, 2xz, 2xy. */
    void (*strain)(const double *N, const double *Nx, const double (*phi)[4], const double *q0,
                   const double *u, double *E);

    /* Of that the part eta (struct hobe_law), 0 but for yy, zz, 2yz.  NULL where no mode is a
     * warping function. */
    void (*warping_strain)(const double *N, const double *Nx, const double (*phi)[4],
                           const double *q0, const double *u, double *E);
};

/* The elements built in, in the order of the declarations' names; ends with NULL.  Each is compiled
 * for more than one machine: the table is that of the best one this processor can run, or of the
 * one that HOBE_MACHINE in the environment names (portable, avx2, avx512), if it can run that. */
const struct hobe_kernel *const *hobe_kernels(void);

/* The machine that table is of: "portable", "avx2" or "avx512". */
const char *hobe_machine(void);

/* ---- for generated code only ---------------------------------------------------------------- */

/* A register's worth of lanes.  A kernel works through a batch in HOBE_PARTS passes, each on values
 * that fit the machine's registers; pass h of item i sits at index i * HOBE_PARTS + h. */
#ifdef __AVX512F__
#define HOBE_KERNEL(name) hobe_kernel_##name##_avx512
typedef double hobe_real __attribute__((vector_size(8 * sizeof(double)), may_alias));
#elif defined __AVX2__
#define HOBE_KERNEL(name) hobe_kernel_##name##_avx2
typedef double hobe_real __attribute__((vector_size(4 * sizeof(double)), may_alias));
#else
#define HOBE_KERNEL(name) hobe_kernel_##name
typedef double hobe_real __attribute__((vector_size(2 * sizeof(double)), may_alias));
#endif
enum { HOBE_PARTS = sizeof(hobe_lanes) / sizeof(hobe_real) };

/* The square roots of the lanes: one instruction, once the compiler need not set errno. */
static inline hobe_real hobe_root(hobe_real x)
{
    for (size_t i = 0; i < sizeof x / sizeof x[0]; i++)
        x[i] = __builtin_sqrt(x[i]);
    return x;
}

#endif
