/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hobe: a nonlinear beam solver with warping.  The public interface of the C library.
 *
 * Build a model from beams, supports and loads; solve it; ask for results anywhere in a beam:
 *
 *     struct hobe_error err;
 *     struct hobe_point tip;
 *     hobe_solution *solution = NULL;
 *     hobe_section *section = hobe_section_rectangle(0.1, 0.2, HOBE_WARPING_SERIES, &err);
 *     hobe_model *model = hobe_model_new(&err);
 *     struct hobe_beam beam = {.name = "arm", .kernel = hobe_find_kernel("MGD30w", &err),
 *                              .elements = 4, .section = section, .to = {1, 0, 0},
 *                              .material = {.E = 210e9, .nu = 0.3, .k2 = 1, .k3 = 1}};
 *     struct hobe_clamp clamp = {.beam = "arm", .at = 0};
 *     struct hobe_force force = {.beam = "arm", .at = 1, .value = {0, 0, -1000}};
 *     if (!section || !model || hobe_model_beam(model, &beam, &err) ||
 *         hobe_model_clamp(model, &clamp, &err) || hobe_model_force(model, &force, &err) ||
 *         hobe_static(model, &(struct hobe_newton){0}, &solution, &err) ||
 *         hobe_solution_point(solution, "arm", 1, 0, 0, &tip, &err))
 *         fprintf(stderr, "%s\n", err.message);
 *     else
 *         printf("%g m\n", tip.u[2]);
 *     hobe_solution_free(solution);
 *     hobe_model_free(model);
 *     hobe_section_free(section);
 *
 * In this order below: sections, materials, elements, curves, drives, the model, statics, paths,
 * motion in time, results, vibration, buckling, reduced models.
 *
 * SI units throughout; angles in radians; arrays row by row.  The library prints nothing, knows no
 * Lua, and copies what it is given unless it says otherwise.
 *
 * A function that can fail returns a status, 0 where it did not, or a pointer, NULL where it did,
 * and writes one sentence to err, which may be NULL (error.h); what a verb would hand out is NULL
 * then.  Whatever else a function says: a name that the model has not is HOBE_UNKNOWN, a number out
 * of its range or not finite HOBE_BAD_INPUT, and any may be HOBE_NO_MEMORY.  `where` tags are kept
 * by pointer and handed back in hobe_error.where: they must outlive the model, and may be NULL.
 *
 * What a function makes is the caller's, and freed by the ..._free of its type, which takes NULL;
 * what it returns as const belongs to its argument and lives as long as that. */
#ifndef HOBE_H
#define HOBE_H

#include "error.h"
#include "kernel.h"

#define HOBE_VERSION "0.1.0"

/* ---- sections (section_*.c) ----------------------------------------------------------------- */

enum hobe_warping {
    HOBE_WARPING_SERIES, /* a rectangle's Saint-Venant function, the series summed to convergence */
    HOBE_WARPING_PAPER,  /* the paper's closed forms: one term of eq. 33; eq. 34; eq. 36 */
    HOBE_WARPING_SOLVED  /* Saint-Venant's function by finite elements on the outline */
};

/* A cross-section: y to the left, z up, both from the centroid, seen along +x.  A section never
 * changes once it is made, so that threads may share it.
 *
 * Its function w is Saint-Venant's warping function, r_w = -kappa e_x.  On outlines it is made
 * orthogonal to 1, y and z over the section, which makes it that of a twist about the shear centre;
 * in an element the slopes y and z hold the difference.
 *
 * Its functions wy and wz are those of bending shear: psi_y with -div grad psi_y = y in the section
 * and no flux through its outline, made orthogonal to 1, y, z and w; wz from z alike, and to wy.
 * Their shear balances the growth of the axial stress E kappa y along a beam without coupling
 * to the transverse strains, as the element's elastic law has it.
 *
 * Solved outlines also have ww, v1y, v1z, v2y and v2z, by which an element's section distorts in
 * torsion (distortion.h); they are solved when they are first asked for. */
typedef struct hobe_section hobe_section;

struct hobe_section_properties {
    double A;             /* m^2 */
    double yc, zc;        /* centroid in the coordinates the outline was given in, m */
    double Iyy, Izz, Iyz; /* int z^2 dA, int y^2 dA, int y z dA, about the centroid, m^4 */
    double J;             /* Saint-Venant's torsion constant, m^4: exact for rectangles, circles and
                             tubes, of the finite elements (from above) for outlines */
    double J_w;           /* torsion constant with this warping function, m^4: J_w >= J */
    double Iw;            /* warping constant, int w^2 dA, m^6 */
    double ys, zs;        /* shear centre (Trefftz) from the centroid, m */
    double Wagner;        /* int r^4 dA - (int r^2 dA)^2/A, r from the shear centre, m^6 */
    double ky, kz, kyz;   /* shear correction: the energy of shear forces Vy, Vz through the shear
                             centre is (Vy^2/ky + Vz^2/kz + 2 kyz Vy Vz)/(2 G A) per length, with
                             wy and wz; kyz = 0 where y or z is an axis of symmetry */
    double width, height; /* extent along y and z, m */
};

/* All sizes in m.  NULL and err set, with one sentence, on sizes and outlines that make no section.
 * An outline that some section in use has already, to the last bit, is not solved again.
 *
 * A rectangle, width along y and height along z. */
hobe_section *hobe_section_rectangle(double width, double height, enum hobe_warping warping,
                                     struct hobe_error *err);

/* A solid circle and a round tube (radii): w = 0. */
hobe_section *hobe_section_circle(double radius, struct hobe_error *err);
hobe_section *hobe_section_tube(double outer, double inner, struct hobe_error *err);

/* Sections of a web along z and flanges along y. */
enum hobe_profile {
    HOBE_PROFILE_I,       /* the flanges may differ */
    HOBE_PROFILE_CHANNEL, /* the web at y = 0, the flanges to the left of it */
    HOBE_PROFILE_T,       /* the flange on top */
    HOBE_PROFILE_ANGLE,   /* legs from the origin along y (the flange) and z (the web) */
    HOBE_PROFILES
};
struct hobe_profile_sizes {
    double height, width;         /* over all, along z and y */
    double flange, web;           /* thicknesses */
    double top_width, top_flange; /* of an I-section's flange at +z; 0: as the other */
};

/* "I", "channel", "T", "angle". */
const char *hobe_profile_name(enum hobe_profile profile);

/* w solved; for the I-section with equal flanges also the paper's.  Its coordinates begin in the
 * middle of the height. */
hobe_section *hobe_section_profile(enum hobe_profile profile,
                                   const struct hobe_profile_sizes *sizes,
                                   enum hobe_warping warping, struct hobe_error *err);

/* A hollow rectangle of one wall thickness; w solved or the paper's. */
hobe_section *hobe_section_hollow(double width, double height, double thickness,
                                  enum hobe_warping warping, struct hobe_error *err);

enum { HOBE_MAX_OUTLINE = 1000 }; /* points, those of the holes included */

/* Any outline with holes: loops[0] points of the outline, then loops[1] of the first hole, ...;
 * point[sum of loops][2] = y, z from any origin, either way round.  w solved. */
hobe_section *hobe_section_polygon(int loops, const int *points, const double (*point)[2],
                                   struct hobe_error *err);

/* The text of a file that holds an outline with its holes: of all loops, in whatever order, that of
 * the largest area is the outline.
 *
 * A list of points: lines of y and z, apart by blanks or a comma; an empty line parts loops, '#'
 * begins a comment, and the first line may be a name or a head.  This is also Selig's format of
 * airfoils.
 *
 * A drawing in DXF (as text), where name ends in ".dxf": LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and
 * POLYLINE, chained to loops where their ends coincide (to 1e-5 of the extent); x is y, y is z.
 * Arcs become chords that enclose the same area. */
struct hobe_outline_file {
    const char *name; /* for sentences */
    const char *text; /* [size], any bytes */
    size_t size;      /* <= HOBE_MOST_OUTLINE_BYTES */
    double scale;     /* m in a unit of the file; 0: that of its $INSUNITS, else 1 */
    double tolerance; /* greatest distance of chords from an arc, m; 0: 1e-3 of the extent */
};
enum { HOBE_MOST_OUTLINE_BYTES = 16 << 20 };
hobe_section *hobe_section_file(const struct hobe_outline_file *file, struct hobe_error *err);

/* Gives the section at the fraction t in [0,1] of a beam's length; it is read before the next call
 * and stays its owner's. */
typedef enum hobe_status hobe_section_maker(void *context, double t, const hobe_section **section,
                                            struct hobe_error *err);

/* A section that varies along the beam smoothly: of one kind with sizes that are smooth functions
 * of x.  The beam's axis goes through its centroids.  `make` is called here only, at 17 to 513
 * places.  NULL and err set where the kind changes or the sizes have a kink, with the t at fault.
 */
hobe_section *hobe_section_taper(hobe_section_maker *make, void *context, struct hobe_error *err);

/* One whose sizes are linear in x between two of the same kind, which are not kept. */
hobe_section *hobe_section_linear(const hobe_section *from, const hobe_section *to,
                                  struct hobe_error *err);

/* Whether it is one of those two. */
int hobe_section_varies(const hobe_section *section);

/* The section that one of those has at the fraction `at` of the length, to be freed by the caller;
 * NULL with HOBE_BAD_INPUT for any other section. */
hobe_section *hobe_section_at(const hobe_section *section, double at, struct hobe_error *err);

void hobe_section_free(hobe_section *section);

/* Those of a section; of one that varies along the beam those at its begin. */
void hobe_section_properties(const hobe_section *section, struct hobe_section_properties *p);

/* One line about the section and its warping function, for reports. */
const char *hobe_section_text(const hobe_section *section);

/* Values of the section function `name`, "w", "wy" or "wz", at (y, z), beyond the outline those of
 * the nearest point: f[3] = f, df/dy, df/dz. HOBE_UNKNOWN when the section has no such function. */
enum hobe_status hobe_section_function(const hobe_section *section, const char *name, double y,
                                       double z, double *f, struct hobe_error *err);

/* How far the walls of a section bend in torsion.  A twist rate kappa turns Saint-Venant's shear
 * stress tau from one section to the next, which loads the walls by 2 kappa tau x e_x per volume:
 * in a closed thin wall with the shear flow q, by a pressure 2 q kappa.  A beam whose outline is
 * rigid does not see it.  The section's elastic answer, small and alike along the beam, takes the
 * energy (1/2) C kappa^4 per length, C = *c (1 - nu^2) G^2/E, with E, G and nu those of the beam or
 * of the first part; walls bent in a long beam stay plane along it, hence the E/(1 - nu^2).  With
 * Wagner's stress
 *
 *     T = G J kappa + (1/2 E Wagner - 2 C) kappa^3,
 *
 * which has a greatest torque where 4 C > E Wagner, as Brazier's tube has a greatest moment: there
 * the outline collapses.  Shear buckling of a wall may come earlier.
 *
 * *c in m^6, weighted with E/E_1 and G/G_1; 0 of rectangles, circles and tubes in closed form.
 * Solved by finite elements when it is first asked for, which takes about as long as the section
 * itself.  HOBE_UNKNOWN of outlines that vary along the beam. */
enum hobe_status hobe_section_wall_bending(const hobe_section *section, double *c,
                                           struct hobe_error *err);

/* ---- materials (material.c) ----------------------------------------------------------------- */

struct hobe_material {
    double E;      /* Young's modulus, Pa, > 0 */
    double nu;     /* Poisson's ratio, -1 < nu < 1/2 */
    double rho;    /* density, kg/m^3, >= 0 (0 where no mass is needed) */
    double k2, k3; /* shear correction factors on xz and xy (eq. 20), > 0; 1 where none is wanted */
    int average_shear; /* 0: they act at every point, and correct torsion too; 1: on the shear
                          strain averaged over the section, which torsion has none of */
};

enum hobe_mechanics {
    HOBE_MECHANICS_DEFAULT,   /* what the element declares */
    HOBE_MECHANICS_AVERAGE,   /* Poisson coupling of the section-averaged strain; so with what
                                 warping strains the section in its plane (struct hobe_law) */
    HOBE_MECHANICS_AXIS,      /* Poisson coupling on the axis: the paper's eq. 26 */
    HOBE_MECHANICS_FULL,      /* unsplit continuum mechanics */
    HOBE_MECHANICS_STRUCTURAL /* a rod's law: E, G and the section's J, no Poisson coupling; that of
                                 elements whose form is structural, which take no other */
};

/* "average", "axis", "full", "structural"; "default". */
const char *hobe_mechanics_name(enum hobe_mechanics mechanics);

enum hobe_integration {
    HOBE_INTEGRATION_EXACT, /* full quadrature of the exact warping function */
    HOBE_INTEGRATION_PAPER  /* 3 x 3 x 3 Gauss points and one term of eq. 33 */
};

/* ---- composite sections (section_composite.c) ----------------------------------------------- */

enum { HOBE_MAX_REGIONS = 32 }; /* parts of a composite section */

/* One part of a composite section. */
struct hobe_section_part {
    const hobe_section *section; /* not a composite one; its outline is copied */
    double at[2];                /* y, z of its origin, m: that of an outline's coordinates, the
                                    centroid of rectangles, circles and tubes */
    struct hobe_material material;
};

/* Parts of different materials, part[parts], which touch along edges in one piece and do not
 * overlap.  Circles and tubes become polygons of their area.  The section brings its materials, one
 * for each region, in the order of the parts.
 *
 * Its centroid is that of EA, its functions those of the composite: div G grad w = 0, and
 * div G grad psi_y = -E y, orthogonal in int E ..dA.  Of its properties A is geometric; those of
 * bending, Iw and Wagner are weighted with E/E_1, J and J_w with G/G_1, where part 1 is the
 * reference, so that EI is E_1 Iyy and GJ is G_1 J; in ky, kz and kyz G A is the sum over the
 * parts.  The parts' shear factors k2, k3 do not enter.
 *
 * In a beam each region has its law; the strains that `average` and average_shear act on are means
 * weighted with E, and with G, and Poisson's coupling is that of E the mean by area and nu the mean
 * by EA: EA and EI are those of the transformed section whatever the ratios. */
hobe_section *hobe_section_composite(int parts, const struct hobe_section_part *part,
                                     struct hobe_error *err);

/* Regions of a section, >= 1, and the material of one, owned by the section; NULL where it has none
 * of its own, and the beam's is used. */
int hobe_section_regions(const hobe_section *section);
const struct hobe_material *hobe_section_material(const hobe_section *section, int region);

/* ---- elements (element.c, kernel_vectors.c) ------------------------------------------------- */

/* The kernel called name, for good; NULL with HOBE_UNKNOWN, which lists the known ones. */
const struct hobe_kernel *hobe_find_kernel(const char *name, struct hobe_error *err);

/* One element prepared for evaluation: kernel, invariants, reference. */
typedef struct hobe_element hobe_element;

struct hobe_element_options {
    const struct hobe_kernel *kernel;
    const hobe_section *section;   /* must outlive the element */
    struct hobe_material material; /* where the section has none of its own */
    double length;                 /* m, > 0 */
    enum hobe_mechanics mechanics;
    enum hobe_integration integration;
    double from, to;  /* the element's part of its beam, fractions of the beam's length, which
                         sections that vary along it want to know; 0, 0: all of it */
    const double *q0; /* reference nodal vectors [vectors][3] where curved or pretwisted, copied;
                         NULL: straight */
};

/* NULL and err set on bad values (HOBE_BAD_INPUT) or a law that is indefinite at rest
 * (HOBE_UNSTABLE, with the inertia named). */
hobe_element *hobe_element_new(const struct hobe_element_options *options, struct hobe_error *err);
void hobe_element_free(hobe_element *element);

const struct hobe_kernel *hobe_element_kernel(const hobe_element *element);
const struct hobe_invariants *hobe_element_invariants(const hobe_element *element);
enum hobe_mechanics hobe_element_mechanics(const hobe_element *element);

/* Reference nodal vectors [vectors][3] where the element is curved, pretwisted or tapered (a
 * tapered straight one along X, its first node at the origin); NULL where it is straight and
 * prismatic. Owned by the element. */
const double *hobe_element_q0(const hobe_element *element);

/* The strains of an axis: stretch, curvatures about the section's y and z, and twist. */
enum hobe_strain { HOBE_STRETCH, HOBE_BEND_Y, HOBE_BEND_Z, HOBE_TWIST, HOBE_STRAINS };

/* How the stiffness at rest stands: what the check in hobe_element_new saw. */
struct hobe_rest {
    int zero, negative, positive; /* eigenvalues of the scaled free-free stiffness of one element */
    double smallest, largest;     /* its extreme nonzero eigenvalues, dimensionless */
    double share[HOBE_STRAINS];   /* EA, EIyy, EIzz, GJ of a long beam of such elements, over those
                                     of its section; 0 where it is curved, pretwisted or tapered */
};
void hobe_element_rest(const hobe_element *element, struct hobe_rest *rest);

/* Stiffness per length of a long beam of such elements, straight and prismatic, at rest, whose
 * section is free to strain as its modes let it: C[i][j], N, N m, N m^2, with EA, EIyy, EIzz, GJ
 * about the centroid on the diagonal. */
enum hobe_status hobe_element_stiffness(const hobe_element *element,
                                        double C[HOBE_STRAINS][HOBE_STRAINS],
                                        struct hobe_error *err);

/* Modes of the kernel that vanish on this section or depend on earlier ones, and are held at zero:
 * dropped[kernel->modes], 1 where so. */
const unsigned char *hobe_element_dropped(const hobe_element *element);

/* Reference nodal vectors of a straight element with the first node at the origin: q0[vectors][3],
 * for axes frame[3] = e_x, e_y, e_z (rows). */
void hobe_element_reference(const hobe_element *element, const double frame[3][3], double *q0);

/* One element's quantities at absolute nodal vectors q[vectors][3]; q0 of the same shape.  The
 * strain energy U, J; the elastic force f[3 * vectors] = dU/dq; the tangent K[3 * vectors][3 *
 * vectors] = d2U/dq2 and the mass matrix M of the same shape, both full.  Of a vector that is a
 * position f is in N, K in N/m, M in kg; of one that multiplies a mode, in m^p, m^p times that. */
enum hobe_status hobe_element_energy(const hobe_element *element, const double *q0, const double *q,
                                     double *U, struct hobe_error *err);
enum hobe_status hobe_element_force(const hobe_element *element, const double *q0, const double *q,
                                    double *f, struct hobe_error *err);
enum hobe_status hobe_element_tangent(const hobe_element *element, const double *q0,
                                      const double *q, double *K, struct hobe_error *err);
void hobe_element_mass(const hobe_element *element, double *M);

/* ---- curves (curve.c) ----------------------------------------------------------------------- */

/* A function of one variable that the caller gives: writes its values at t into f, or returns a
 * status with err (which may be NULL) set, which ends what called it and is passed on. */
typedef enum hobe_status hobe_function(void *context, double t, double *f, struct hobe_error *err);

/* A smooth curve for the axis of a beam, with a twist of the section about it.  Once it is made
 * and twisted it never changes, so that threads may share it. */
typedef struct hobe_curve hobe_curve;

/* The curve r(t), m, for t in [0,1]; any parametrisation whose speed |r_t| never comes near zero.
 * `point` gives r[3]; it is called here only, at 17 to 513 places.  Analytic curves are met to
 * rounding.  NULL and err set: HOBE_BAD_INPUT where r is not finite, has a kink, or stands still,
 * with the t at fault; or the function's own status. */
hobe_curve *hobe_curve_function(hobe_function *point, void *context, struct hobe_error *err);

/* The curve through n points, 2 to 10000, r[n][3], m, copied: the cubic spline over the length of
 * the chords whose slopes at the ends are those of the polynomials through the five outermost
 * points, so that two points give a line and three a parabola.  Its error falls with the fourth
 * power of the distance of the points.  NULL and err set on coinciding neighbours, points that are
 * not finite, or a spline with a cusp. */
hobe_curve *hobe_curve_points(int n, const double (*r)[3], struct hobe_error *err);

/* Turns the section about the tangent by twist(at), rad, at the fraction `at` of the arc length:
 * positive from e_y to e_z.  `twist` gives one value, is smooth, and is called here only.  It
 * replaces an earlier twist; a failure leaves that in place. */
enum hobe_status hobe_curve_twist(hobe_curve *curve, hobe_function *twist, void *context,
                                  struct hobe_error *err);

void hobe_curve_free(hobe_curve *curve);

/* Arc length, m. */
double hobe_curve_length(const hobe_curve *curve);

/* At the fraction `at` in [0,1] of the arc length: the position r[3], m; the section's axes, rows
 * e_x (the tangent), e_y, e_z of frame; and their derivatives by arc length, frame_x, 1/m.  Before
 * the twist e_z is as near to `up` as can be; up = {0,0,0} stands for global Z or, for a straight
 * line along Z, global -X (X where it runs down).  HOBE_BAD_INPUT where `at` is outside [0,1] or
 * up along the tangent. */
enum hobe_status hobe_curve_at(const hobe_curve *curve, const double up[3], double at, double r[3],
                               double frame[3][3], double frame_x[3][3], struct hobe_error *err);

/* ---- drives (drive.c) ----------------------------------------------------------------------- */

/* A function of time t >= 0, s, with its first and second derivative: it moves joints and scales
 * loads.  Asking one for its value may store what it has integrated so far: threads must not share
 * it. */
typedef struct hobe_drive hobe_drive;

/* How a value goes from one point to the next: straight, or v0 + (v1 - v0)(1 - cos(pi s))/2 with s
 * from 0 to 1, which begins and ends at rest.  Before the first point and after the last it is
 * constant. */
enum hobe_between { HOBE_LINEAR, HOBE_RAMP };

/* A drive through n points, point[n][2] = t, value, copied, in the order of time; two points at one
 * time make a jump.  With `integral` their integral from t = 0 on, exact: points of a velocity give
 * a motion.  NULL and err set on points that are none. */
hobe_drive *hobe_drive_points(int n, const double (*point)[2], enum hobe_between between,
                              int integral, struct hobe_error *err);

/* A drive of the caller's function of time, smooth, one value; `context` must outlive it.  Its
 * derivatives are differences over steps h = 1/4096 s, whose relative errors are (w h)^4/30 and (w
 * h)^4/90 for an angular frequency w, and 1e-12 and 2e-8 of the value per s and s^2 by rounding; in
 * the first 2 h, where they look forward, (w h)^4/5 and (w h)^3.  With `integral` the motion is its
 * integral by Gauss's rule of 8 points in cells of 1/128 s, exact to rounding for w < 500 rad/s. */
hobe_drive *hobe_drive_function(hobe_function *function, void *context, int integral,
                                struct hobe_error *err);
void hobe_drive_free(hobe_drive *drive);

/* d[3] = value, d/dt, d2/dt2 at t; from the right where they jump.  HOBE_BAD_INPUT for t < 0, a
 * value that is not finite; the function's own status. */
enum hobe_status hobe_drive_at(hobe_drive *drive, double t, double d[3], struct hobe_error *err);

/* The first point after t, where derivatives may jump; INFINITY after the last, and of functions.
 */
double hobe_drive_next(const hobe_drive *drive, double t);

/* ---- model (model.c) ------------------------------------------------------------------------ */

typedef struct hobe_model hobe_model;

/* What a beam loses in motion: forces mass * M v, which hold back rigid motions, too; and the
 * viscous stress stiffness * C : dE/dt beside the elastic one (Kelvin, Voigt), which no rigid
 * motion feels. About an unloaded reference both are Rayleigh's damping: of a mode of angular
 * frequency omega it is the fraction (mass / omega + stiffness omega) / 2 of the critical one. */
struct hobe_damping {
    double mass;      /* 1/s, >= 0 */
    double stiffness; /* s, >= 0; only of elements whose energy is quartic */
};

struct hobe_beam {
    const char *where;
    const char *name; /* unique in the model */
    const struct hobe_kernel *kernel;
    int elements;                  /* >= 1 */
    const hobe_section *section;   /* must outlive the model */
    struct hobe_material material; /* where the section has none of its own */
    struct hobe_damping damping;   /* of hobe_dynamic; nothing at rest knows it */
    double from[3], to[3];         /* ends of a straight axis, m */
    const hobe_curve *curve; /* the axis where it is curved or pretwisted, in place of from and to;
                                must outlive the model; NULL: straight */
    double up[3]; /* direction the section's z axis points to (made normal to the axis); {0,0,0}:
                     global Z, or global -X for a beam along Z */
    enum hobe_mechanics mechanics;
    enum hobe_integration integration;
};

/* A rigid body: its inertia is that of a shape, or given.  It lies on its axes: the first along
 * `axis` ({0,0,0}: global X), the second along `second`, the third at a right angle to both. */
enum hobe_shape {
    HOBE_SHAPE_NONE,     /* mass and inertia are given */
    HOBE_SHAPE_CYLINDER, /* size: radius and length along the first axis */
    HOBE_SHAPE_BOX,      /* size: edges along the axes */
    HOBE_SHAPE_SPHERE    /* size: radius */
};
struct hobe_body {
    const char *where;
    const char *name; /* unique among beams and bodies */
    double mass;      /* kg, or 0 where a shape has a density, kg/m^3 */
    double density;
    double centre[3]; /* of mass, m, global axes in the reference */
    enum hobe_shape shape;
    double size[3];            /* m */
    double inertia[3][3];      /* without a shape: about the centre, on its axes, kg m^2; 0 < I_1,
                                  and each principal moment at most the sum of the others */
    double axis[3], second[3]; /* {0,0,0} for second: global Y where axis is left out, too, or any
                                  direction where the body is round about its first axis */
};

/* A mass at a point of a beam: of the section at `at` the material point (y, z), moved by every
 * mode of the section; it has no inertia about that point (a body has). */
struct hobe_mass {
    const char *where, *beam;
    double at, y, z; /* y, z in m from the centroid */
    double mass;     /* kg, >= 0 */
};

/* Supports and loads name a beam and a place `at` in [0,1] along its axis; or a body and a `point`
 * of it where `at_point` is 1, m, global axes in the reference; `at` then says nothing. */
struct hobe_clamp {
    const char *where, *beam;
    const char *name; /* by which hobe_solution_reaction knows it, or NULL */
    double at;        /* must be a node of the beam with a position */
    int free_warping; /* 0: every vector of the node is held.  1: r and the slopes y, z are, so that
                         the section stays in place but may warp, and stretch along the axis */
};

/* F[3], N, global axes: the caller's force on a place of a beam at the time t, s, in the position
 * x[3], m, with the velocity v[3], m/s, which is 0 in statics.  Smooth; or it returns a status with
 * err (which may be NULL) set, which ends the solve. */
typedef enum hobe_status hobe_force_function(void *context, double t, const double x[3],
                                             const double v[3], double F[3],
                                             struct hobe_error *err);

/* Its derivatives G[0][a][c] = dF_a/dx_c, N/m, and G[1][a][c] = dF_a/dv_c, N s/m.  Without them
 * they are central differences over steps of 6e-6 of the beam's length, and of the velocity and a
 * length per s. */
typedef enum hobe_status hobe_force_derivative(void *context, double t, const double x[3],
                                               const double v[3], double G[2][3][3],
                                               struct hobe_error *err);

struct hobe_force {
    const char *where, *beam;
    double at;
    double value[3];     /* N, global axes */
    int follower;        /* 1: the force turns with the section or body from that direction */
    hobe_drive *history; /* factor of time; NULL: 1.  It outlives the model, as all drives do */
    hobe_force_function *function;     /* in place of value, which is {0,0,0}, and not follower */
    hobe_force_derivative *derivative; /* of it; NULL: by differences */
    void *context;                     /* of both */
    int at_point;
    double point[3]; /* of a body; its centre where at_point is 0 */
};
/* Conservative: with M = m_x e_x + m_y e_y + m_z e_z on the beam's reference axes, its potential is
 * -m_x (phi_x(r_y) + phi_x(r_z))/2 - m_y phi_y(r_z) - m_z phi_z(r_y), phi_a(s) the angle of the
 * section's slope s about e_a.  Of a body the axes are the global ones, and the slopes its
 * directions that are global Y and Z in the reference. */
struct hobe_moment {
    const char *where, *beam; /* a beam or a body */
    double at;                /* of a beam */
    int at_point;             /* 1: it acts on a body, wherever */
    double value[3];          /* N m about the global axes */
    hobe_drive *history;      /* as of forces */
};
struct hobe_join { /* ends of two beams that share a node, rigidly, at any angle */
    const char *where, *beam[2];
    double at[2]; /* 0 or 1 */
};

/* What a joint stops of the motion of its second part against its first: translations of its place
 * along and across the axis, which belongs to the first part and moves with it, and rotations.
 *
 *     kind          translations   rotations
 *     fixed         all            all, of the sections' mean axes
 *     spherical     all            none
 *     revolute      all            all but about the axis
 *     universal     all            one: the first part's axis and the second part's `second` stay
 *                                  at a right angle
 *     cylindrical   across         all but about the axis
 *     prismatic     across         all
 *     planar        along          all but about the axis
 *     inline        across         none
 *     inplane       along          none
 *     distance      along the line between the places, which are apart; none
 *     rigid         all            all, and those of the slopes y, z against each other: the mean
 *                                  plane of a beam's section is the body's, or the ground's, and
 *                                  neither shears nor strains there; the axis stretches freely
 *
 * Directions that belong to a beam are carried by the section's slopes y, z and by its normal
 * n = y x z with the components they have in the reference: d_x n + d_y y + d_z z.  Warping and
 * every other mode of the section stay free.  A body carries its directions that are global axes in
 * the reference.
 *
 * A drive moves the second part: `angle`, rad, turns it about the axis, `position`, m, shifts it
 * along the axis, d . axis = position, or lengthens a distance.  What the kind leaves free of the
 * driven motion is free no more; what it stops is stopped where the drive has it.  An angle needs a
 * kind that stops the axis from tilting: fixed, revolute, cylindrical, prismatic or planar; any
 * kind takes a position.  Driven joints need an axis, but for a distance. */
enum hobe_joint_kind {
    HOBE_JOINT_FIXED,
    HOBE_JOINT_SPHERICAL,
    HOBE_JOINT_REVOLUTE,
    HOBE_JOINT_UNIVERSAL,
    HOBE_JOINT_CYLINDRICAL,
    HOBE_JOINT_PRISMATIC,
    HOBE_JOINT_PLANAR,
    HOBE_JOINT_INLINE,
    HOBE_JOINT_INPLANE,
    HOBE_JOINT_DISTANCE,
    HOBE_JOINT_RIGID
};

/* A joint between places anywhere on two beams or bodies, which must coincide but for a distance;
 * or between the ground, its first part, and a place of one: a support.  The place of a body is
 * `point` where at_point is 1, or that of the beam it is joined to. */
struct hobe_joint {
    const char *where;
    const char *beam[2]; /* the first and the second part; beam[1] NULL: a support of beam[0] */
    const char *name;    /* by which hobe_solution_reaction knows it, or NULL */
    double at[2];        /* of beams */
    enum hobe_joint_kind kind;
    double axis[3];   /* global, in the reference; {0,0,0} for distance, and for fixed, rigid and
                         spherical that are not driven */
    double second[3]; /* of universal joints, at a right angle to the axis; else {0,0,0} */
    double to[3];     /* of a support that keeps a distance: the point of the ground, m; of two
                         bodies, where at_point is 2: the point of the second */
    int at_point;     /* 1: `point` is given; 2: `to` of two bodies, too */
    double point[3];  /* of bodies, m, global axes in the reference */
    hobe_drive *angle, *position; /* NULL, or how the joint is driven; they outlive the model */
};

/* Velocities with which hobe_dynamic starts: a rigid motion of what is as the start has it.  Of
 * several that speak of a beam or body the last counts. */
struct hobe_motion {
    const char *where;
    const char *beam;           /* or a body; NULL: everything */
    double velocity[3];         /* m/s, of the point `about` */
    double angular_velocity[3]; /* rad/s */
    double about[3];            /* m */
};

/* "revolute" etc.; NULL for no kind. */
const char *hobe_joint_name(enum hobe_joint_kind kind);

/* What a spring acts on: the distance of its places; the angle by which its second part has turned
 * against the first about an axis, from -pi to pi: whole turns are not counted; the displacement of
 * the second place against the first, along the global axes in the reference, which move with the
 * first part: an elastic support, or a joint that gives. */
enum hobe_spring_kind { HOBE_SPRING_LENGTH, HOBE_SPRING_TORSION, HOBE_SPRING_BUSHING };

/* A spring and damper without mass between places anywhere on two beams or bodies, or between the
 * ground and one: the force k (l - l0) + c dl/dt along the line of its places, the moment k (a -
 * a0) + c da/dt about its axis, or three forces, on both places in opposite directions.  A spring
 * of kind length has no direction where its places coincide, nor a bushing between two beams where
 * they do not. Directions belong to a beam as those of joints do (above).  Springs hold a scene as
 * supports do, along their extensions; statics do not scale them by the load factor.  */
struct hobe_spring {
    const char *where;
    const char *beam[2]; /* beam[1] NULL: between the ground and beam[0] */
    const char *name;    /* by which hobe_solution_spring knows it, or NULL */
    double at[2];
    enum hobe_spring_kind kind;
    double
        stiffness[3];  /* k >= 0, N/m; N m/rad; of a bushing along x, y, z, else the first alone */
    double damping[3]; /* c >= 0, N s/m; N m s/rad; likewise; at rest there is none */
    double length;     /* l0 > 0 of a length, m; 0: the distance in the reference */
    double angle;      /* a0 of torsion, rad, from the reference */
    double axis[3];    /* of torsion: global, in the reference; it moves with the first part */
    double to[3];      /* of a length to the ground: its place there, m; of two bodies, where
                          at_point is 2: the place on the second */
    int at_point;      /* as of a joint */
    double point[3];   /* of bodies, m */
};

/* An empty model.  Freed after all solutions, paths, motions and modes that refer to it. */
hobe_model *hobe_model_new(struct hobe_error *err);
void hobe_model_free(hobe_model *model);

/* Each adds a copy of one item; names are resolved by hobe_model_build, after which HOBE_BAD_INPUT
 * refuses more.  Errors have the item's `where`.  A beam makes its elements here: HOBE_UNSTABLE as
 * of hobe_element_new. */
enum hobe_status hobe_model_beam(hobe_model *, const struct hobe_beam *, struct hobe_error *);
enum hobe_status hobe_model_body(hobe_model *, const struct hobe_body *, struct hobe_error *);
enum hobe_status hobe_model_mass(hobe_model *, const struct hobe_mass *, struct hobe_error *);
enum hobe_status hobe_model_clamp(hobe_model *, const struct hobe_clamp *, struct hobe_error *);
enum hobe_status hobe_model_force(hobe_model *, const struct hobe_force *, struct hobe_error *);
enum hobe_status hobe_model_moment(hobe_model *, const struct hobe_moment *, struct hobe_error *);
enum hobe_status hobe_model_join(hobe_model *, const struct hobe_join *, struct hobe_error *);
enum hobe_status hobe_model_motion(hobe_model *, const struct hobe_motion *, struct hobe_error *);
enum hobe_status hobe_model_joint(hobe_model *, const struct hobe_joint *, struct hobe_error *);
enum hobe_status hobe_model_spring(hobe_model *, const struct hobe_spring *, struct hobe_error *);
/* Gravity, m/s^2 in global axes, on every beam, body and mass; repeated calls add up. */
enum hobe_status hobe_model_gravity(hobe_model *, const char *where, const double g[3],
                                    struct hobe_error *);
/* The same times a factor of time; NULL: 1. */
enum hobe_status hobe_model_gravity_history(hobe_model *, const char *where, const double g[3],
                                            hobe_drive *history, struct hobe_error *);

/* The scene as seen in a frame that turns about a line: all supports turn with it, and
 * loads keep their direction in it.  In equilibrium there F(q) = Q + w^2 M P q, the centrifugal
 * force on the distance from the axis, P = I - e e': the load factor of statics scales w^2.
 * Vibration about it (hobe_modal) and motion feel Coriolis' force, too; velocities and momenta are
 * those in the frame.  Where the speed changes in time, motion feels Euler's force -dw/dt M e x q
 * besides; an equilibrium, at its time, and vibration about it are those of a steady turn. */
struct hobe_spin {
    const char *where;
    double axis[3];      /* e, of any length, global axes */
    double about[3];     /* a point of the line, m */
    double speed;        /* w, rad/s, positive by the right-hand rule about the axis */
    hobe_drive *history; /* a factor of w that changes in time, without jumps; NULL: 1 */
};
/* At most one; HOBE_BAD_INPUT for a second one, an axis of no length, and a speed that jumps.
 * Beams need densities, as hobe_model_build says. */
enum hobe_status hobe_model_spin(hobe_model *, const struct hobe_spin *, struct hobe_error *);

/* Checks the model and does everything that is done once: invariants, numbering, sparsity and
 * scatter maps, symbolic factorisation.  The verbs call it when it has not been called.
 * HOBE_BAD_INPUT and HOBE_UNKNOWN with the `where` of the item at fault. */
enum hobe_status hobe_model_build(hobe_model *model, struct hobe_error *err);

struct hobe_model_info {
    int beams, elements, bodies;
    long vectors;  /* nodal vectors, held ones included */
    long unknowns; /* scalar unknowns solved for */
    long nonzeros; /* of the tangent stiffness */
    double setup;  /* s, spent on adding beams and in hobe_model_build */
};
void hobe_model_info(const hobe_model *model, struct hobe_model_info *info);

/* What the next owner of the results should know: dropped modes, spurious zero-energy modes, ...
 * The i-th sentence, or NULL past the last.  Owned by the model. */
const char *hobe_model_note(const hobe_model *model, int i);

/* ---- statics (newton.c) --------------------------------------------------------------------- */

struct hobe_iteration { /* what a log line shows */
    int step, iteration;
    double load;      /* load factor this step aims at, 0..1 */
    double residual;  /* scaled residual norm over that of the load */
    double energy;    /* |du . r| over its first value in the step */
    double line;      /* line-search factor taken */
    const char *note; /* "" or what happened: "converged", "cut back", ... */
};

enum hobe_method {
    HOBE_METHOD_AUTO,   /* newton */
    HOBE_METHOD_NEWTON, /* steps begin at the last state, or along the path's tangent there */
    HOBE_METHOD_SERIES  /* they go along a power series of the path, as far as that is good: fewer
                           factorisations where many steps are needed (asymptotic numerical method,
                           Cochelin 1994); only of elements whose energy is a polynomial */
};

typedef struct hobe_solution hobe_solution;

/* A solver that looks for its corrections among few fields only (Galerkin's method): the residual
 * of the full model is projected on them, and what they cannot see of it stays.  Forces and
 * matrices are those of the full model, so that this takes longer than the full solution: it shows
 * what such fields can do. */
enum hobe_projection_method {
    HOBE_PROJECTION_COMPONENTS, /* constraint modes and fixed-interface normal modes of the tangent
                                  stiffness (component_modes.h), found again where the scene moves:
                                  at each load step, or in motion by `deviation` */
    HOBE_PROJECTION_SNAPSHOTS   /* the main directions of states that are given (proper orthogonal
                                  decomposition, Sirovich 1987), for good */
};

struct hobe_projection {
    enum hobe_projection_method method;
    int modes;        /* how many; of snapshots 0: as many as `accuracy` asks for */
    double frequency; /* of components: or all normal modes up to this, rad/s */
    double deviation; /* of components in motion: displacements, relative to the scene's size in
                         the norm of the mass, after which modes are found again; 0: 0.1 */
    double accuracy;  /* of snapshots: the share of them, in the norm of the scaled displacements,
                         that may be left out; 0: 1e-6 */
    const hobe_solution *const *snapshot; /* [snapshots] of the model or of one of the same shape */
    int snapshots;
};

struct hobe_newton {
    enum hobe_method method;
    const hobe_solution *start; /* where hobe_static begins, at the full load: an equilibrium of the
                                   model or of one of the same shape, under other loads or of other
                                   size; NULL, or if there is nothing near: the reference */
    int steps;                  /* load steps to begin with; 0: 1; not by series */
    int max_iterations;         /* in a step; 0: 30 */
    double tolerance;           /* on `residual`; 0: 1e-9 */
    double smallest_step;       /* of the load factor, below which the solve is given up; 0: 1e-4 */
    int no_line_search;
    const struct hobe_projection *projection; /* NULL: none; not by series */
    int linear;  /* 1: the linear response to the loads instead, one correction from the reference,
                    whose residual tells how far from equilibrium that is; not by series */
    double time; /* s, at which drives and histories are taken, >= 0; the motion of drives is scaled
                    by the load factor, too */
    void (*log)(void *context, const struct hobe_iteration *iteration); /* may be NULL */
    void *context;
};

struct hobe_solution_info {
    /* Of parts of a scene that nothing couples the most that one took, but all factorisations. */
    int steps, iterations, cutbacks, factorisations;
    double load;       /* load factor reached: 1 of hobe_static */
    double time;       /* s, of drives, histories and hobe_dynamic */
    int negative;      /* negative eigenvalues of the tangent stiffness, 0 where the equilibrium is
                          stable, as it may be with some where the scene spins (hobe_modal tells);
                          -1: not counted, as by hobe_static then, and with follower forces, and in
                          a motion but for the equilibrium that it starts from */
    double limit_load; /* the load factor of a limit point on the path from rest, beyond which the
                          equilibrium lies on another branch, which a load that grows comes to by a
                          jump; also of the first state of a motion that begins there; 0: none
                          was met (jump.h; not looked for from options.start, nor with a
                          projection) */
    double residual;   /* of the last iteration */
    double change;  /* of the displacements by a last correction, beyond what tolerance asked for,
                       relative to their size, in the norm sum u^2 K_0 over the diagonal of the
                       stiffness at rest; it is taken, and round-off leaves less than that open (by
                       series, which leave it, so much); NaN where the stiffness has no factors */
    double energy;  /* strain energy, that of springs included, J */
    long projected; /* unknowns of a projection, multipliers included; 0: none */
    int linearisations; /* how often its modes were found */
    double outside;     /* residual of the full model, most of which a projection does not see */
    double
        smallest_volume; /* min det F over the stations of all elements and places of a section */
    double indicator; /* of a reduced model and of a projection: what its displacements may lack of
                         those of the whole one, relative to their size, in motion the largest so
                         far; 0 of whole models; NaN: not asked */
    double seconds;   /* in the verb so far, without set-up */
};

/* Static equilibrium under all loads of the model from its reference or options.start; by series
 * the path to it is followed (hobe_path_follow), through limit points, too.  On success *solution
 * is owned by the caller and refers to the model, which must outlive it.  HOBE_NOT_CONVERGED says
 * how far the load got and what to try.  Parts of the scene that nothing couples are solved each by
 * itself.  Large models are summed by several threads, as many as OMP_NUM_THREADS allows; results
 * do not depend on their number. */
enum hobe_status hobe_static(hobe_model *model, const struct hobe_newton *options,
                             hobe_solution **solution, struct hobe_error *err);
void hobe_solution_free(hobe_solution *solution);
void hobe_solution_info(const hobe_solution *solution, struct hobe_solution_info *info);

/* ---- paths (path.c) ------------------------------------------------------------------------- */

/* A place whose displacement ends a path: where its component along `value` reaches the length of
 * `value`, m. */
struct hobe_reach {
    const char *where, *beam; /* beam: NULL where there is no such end */
    double at;
    double value[3];
};

struct hobe_path_options {
    struct hobe_newton newton; /* of which steps, smallest_step and no_line_search do not count */
    int steps;                 /* at most; 0: 200 */
    double arc; /* longest step, in units of the arc that the linear response to all loads takes
                   from the reference; 0: 0.05, by series no limit but how far these are good */
    double smallest_arc; /* below which the path is given up, as a share of arc; 0: 1e-4 */
    double to; /* load factor that ends the path, and the direction in which it starts; 0: 1 */
    struct hobe_reach reach;
};

/* Equilibria from the reference on, in order, under a load factor that is found with them. */
typedef struct hobe_path hobe_path;

enum hobe_path_end { HOBE_PATH_LOAD, HOBE_PATH_DISPLACEMENT, HOBE_PATH_STEPS };

struct hobe_path_info {
    int points, events;
    int iterations, cutbacks, factorisations;
    enum hobe_path_end end; /* what ended the path: options.to, options.reach, or options.steps */
    double seconds;         /* in hobe_path_follow without set-up */
};

/* Between two neighbouring points the stiffness has become singular. */
struct hobe_path_event {
    int bifurcation; /* 0: a limit point, where the load turns; 1: another path crosses */
    int before;      /* number of the point before, from 0; -1: the reference */
    int change;      /* of the number of negative eigenvalues; 0 where that is not known */
    double load[2];  /* load factors before and after */
    double extreme;  /* of a limit point: the load factor there, of the cubic through both points
                        with their tangents; of a bifurcation the mean of both */
};

/* Follows the equilibrium path from the reference by arc length: s'= 1 in the norm |(u, lambda)|^2
 * = u'W u/c + lambda^2, W the diagonal of the stiffness at the reference and c the u'W u of the
 * linear response to all loads.  Each step is corrected in the plane normal to the tangent (Riks
 * 1979), and ends the path exactly at options.to or options.reach when it passes that.  On success
 * *path is owned by the caller and refers to the model.  HOBE_NOT_CONVERGED says how far it got. */
enum hobe_status hobe_path_follow(hobe_model *model, const struct hobe_path_options *options,
                                  hobe_path **path, struct hobe_error *err);
void hobe_path_free(hobe_path *path);
void hobe_path_info(const hobe_path *path, struct hobe_path_info *info);

/* The i-th point, owned by the path; its info.load is the load factor.  NULL past the last. */
const hobe_solution *hobe_path_point(const hobe_path *path, int i);

/* The same, to be owned by the caller from now on; the path has it no more. */
hobe_solution *hobe_path_take(hobe_path *path, int i);

/* The i-th event, 0 <= i < events, and its sentence; points are counted from 1 in it. */
const struct hobe_path_event *hobe_path_event(const hobe_path *path, int i);
void hobe_path_event_text(const struct hobe_path_event *event, char *text, size_t size);

/* ---- motion in time (dynamic.c, history.c) --------------------------------------------------- */

struct hobe_time_step { /* what a log line shows: a step that was taken, or given up */
    long step;          /* taken so far */
    double time;        /* reached, s */
    double size;        /* of the step, s */
    int iterations;     /* of Newton's method in it */
    double error;       /* of its displacements, relative to the scene's size; NaN: not estimated */
    const char *note;   /* "" or why it was given up */
};

/* Either a fixed step, or the accuracy that chooses the steps; `step` is then the longest. */
struct hobe_dynamic {
    double to;          /* the time that ends the motion, s, > that of the start */
    double step;        /* s; 0: left to the accuracy */
    double accuracy;    /* of the displacements in a step, relative to the scene's size; 0: the step
                           is fixed */
    double rho;         /* spectral radius at infinity, 0 < rho <= 1: what is left in a step of what
                           is too fast for the steps; 0: 0.8 */
    double store;       /* time between the states that are kept, which steps end at, s; 0: every
                           step is kept */
    double tolerance;   /* of forces left over, relative to those of inertia, loads and joints; 0:
                           1e-9 */
    int max_iterations; /* in a step; 0: 10 */
    int full_newton;    /* 1: each iteration has factors of its own; 0: those at hand serve on, over
                           iterations and steps, as long as they converge fast enough */
    double smallest_step; /* below which a motion that needs accuracy is given up, s; 0: 1e-9 of
                             the time to go */
    const struct hobe_projection *projection; /* NULL: none; without a journal */
    int equilibrium; /* 1: it starts from the static equilibrium under the loads of t = 0; 0:
                        from the reference; with the velocities of hobe_motion */
    const hobe_solution *start; /* or from this state of the model: an equilibrium, at t = 0, or one
                                   of an earlier motion, at its time with its velocities */
    int quasi_static; /* 1: without inertia and damping, its states the equilibria at their times,
                         for which it needs store, and no more than that and start; 0: as it moves
                       */
    void (*log)(void *context, const struct hobe_time_step *step); /* may be NULL */
    void *context;
    struct hobe_journal *journal; /* to go on from, and to keep what is needed for that, every 100
                                     steps (journal.h); NULL: none.  Motions with and without are
                                     the same to the last bit */
};

typedef struct hobe_history hobe_history;

struct hobe_history_info {
    int states;                       /* kept, the first among them */
    long steps, rejected, iterations; /* taken; given up; of Newton's method in all */
    long factorisations;
    double time;                        /* reached, s */
    double smallest_step, largest_step; /* taken, s */
    double largest_error; /* of displacements in a step, relative to the scene's size */
    long projected;       /* unknowns of a projection, multipliers included; 0: none */
    int linearisations;   /* how often its modes were found */
    double seconds;       /* in hobe_dynamic without set-up */
};

/* The motion of a model under its loads, all of them on: M w + F(q) + Phi_q' lambda = Q(q, v, t),
 * Phi(q, t) = 0, by generalised alpha (genalpha.h).  It may be free to move.  Velocities of the
 * start that break constraints by more than 1e-6 are refused, smaller faults are mended.
 * HOBE_BAD_INPUT also where a beam has no density; HOBE_NOT_CONVERGED says at what time, and why, a
 * step failed: a fixed one, or the smallest.  On success *history is owned by the caller and refers
 * to the model, which must outlive it. */
enum hobe_status hobe_dynamic(hobe_model *model, const struct hobe_dynamic *options,
                              hobe_history **history, struct hobe_error *err);
void hobe_history_free(hobe_history *history);
void hobe_history_info(const hobe_history *history, struct hobe_history_info *info);

/* The i-th kept state, owned by the history; its info.time is its time.  NULL past the last. */
const hobe_solution *hobe_history_state(const hobe_history *history, int i);

/* The same, to be owned by the caller from now on; the history has it no more. */
hobe_solution *hobe_history_take(hobe_history *history, int i);

/* What a motion keeps and loses. */
struct hobe_energies {
    double time;        /* s */
    double kinetic;     /* v'M v/2, J */
    double strain;      /* J */
    double loads;       /* work of all loads since the start, J */
    double drives;      /* and of the drives of joints */
    double damped;      /* what damping has taken since the start, J */
    double balance;     /* kinetic + strain, less their values at the start, less the work of
                           loads and drives, and damped: what the integration has lost (< 0), J */
    double momentum[3]; /* kg m/s */
    double angular_momentum[3]; /* about the origin, kg m^2/s */
    double violation;           /* the largest |Phi|, relative to the scene's size, or rad */
    double violation_rate;      /* the largest |Phi_q v + Phi_t|, likewise, 1/s */
};

/* Of the i-th kept state; NULL past the last. */
const struct hobe_energies *hobe_history_energies(const hobe_history *history, int i);

/* Velocity, m/s, and acceleration, m/s^2, at the place (at, y, z) of a beam, as in
 * hobe_solution_point; 0 of equilibria. */
enum hobe_status hobe_solution_velocity(const hobe_solution *solution, const char *beam, double at,
                                        double y, double z, double velocity[3],
                                        double acceleration[3], struct hobe_error *err);

/* ---- results (result.c, stress.c, resultants.c) --------------------------------------------- */

struct hobe_point {
    double r[3], r0[3]; /* position now and in the reference, m; displacement r - r0 is u */
    double u[3];        /* displacement, m, with the digits that r - r0 would lose */
    double F[3][3];     /* deformation gradient to the global axes, columns dr/dx, dr/dy, dr/dz */
    double strain[6];   /* Green-Lagrange, Voigt xx, yy, zz, 2yz, 2xz, 2xy, section axes */
    double rotation[3]; /* rotation vector of the section, rad, global axes */
    double twist;       /* atan2(-r_z.Y, r_z.Z), Y, Z the section's axes in the reference, rad */
};

/* Everything at the place (at, y, z) of a beam: at in [0,1]; y, z in m from the centroid, where the
 * section's functions go on beyond its outline as at the nearest point. */
enum hobe_status hobe_solution_point(const hobe_solution *solution, const char *beam, double at,
                                     double y, double z, struct hobe_point *point,
                                     struct hobe_error *err);

/* Where a point of a body is, `point` in the reference, m, global axes; NULL: its centre. */
struct hobe_body_point {
    double r[3], r0[3], u[3];            /* as in hobe_point */
    double rotation[3];                  /* rotation vector of the body, rad, global axes */
    double velocity[3], acceleration[3]; /* m/s, m/s^2; 0 of equilibria */
    double angular_velocity[3];          /* rad/s, global axes */
};
enum hobe_status hobe_solution_body(const hobe_solution *solution, const char *body,
                                    const double point[3], struct hobe_body_point *is,
                                    struct hobe_error *err);

/* *twist: that of hobe_point with its whole turns, rad.  They are counted along the beam from its
 * first clamp, or from its begin where it has none, at which the twist is between -pi and pi; anew
 * from where a bent beam makes r_z pass the direction of the section's X in the reference, where
 * the angle jumps by half a turn. */
enum hobe_status hobe_solution_twist(const hobe_solution *solution, const char *beam, double at,
                                     double *twist, struct hobe_error *err);

/* Stress by the law that the element has.  `average` and `axis` add the stress of the mean strain:
 * evenly, or in composite sections in proportion to E (normal) and G (shear); that of `axis`, which
 * acts on the axis, is shown spread evenly, too.  Shear factors k2, k3 scale the stresses xz, xy
 * they correct. */
struct hobe_stress {
    double strain[6];  /* Green-Lagrange, as in hobe_point */
    double S[6];       /* second Piola-Kirchhoff, Pa, Voigt xx, yy, zz, yz, xz, xy, on the section's
                          axes in the reference; conjugate to the strain that the law acts on, with
                          mechanics `average` not quite that of the displacements (struct hobe_law
                          of kernel.h) */
    double cauchy[6];  /* F S F'/det F, Pa, xx, yy, zz, yz, xz, xy, global axes */
    double section[6]; /* the same on the section's axes now: x normal to it, y and z as near to r_y
                          and r_z as can be on the axis */
    double mises;      /* von Mises, of cauchy, Pa */
    double energy;     /* strain energy per volume of the reference, J/m^3 */
};

/* Stress at the place (at, y, z) of a beam, as in hobe_solution_point; on a seam of a composite
 * section that of either side.  HOBE_BAD_INPUT where the element's form is structural: its law
 * knows section forces, no stress. */
enum hobe_status hobe_solution_stress(const hobe_solution *solution, const char *beam, double at,
                                      double y, double z, struct hobe_stress *stress,
                                      struct hobe_error *err);

/* What the part of a beam beyond a cut (at larger `at`) does to the part before it, about the
 * centroid and on the section's axes now (as hobe_stress.section).
 *
 * HOBE_CUT_FORCES: from the nodal forces of the element before the cut, less the loads between its
 * ends; of the first element at 0, from its other end.  They balance the loads beyond as exactly as
 * Newton's iteration has converged, in any state: forces, weight, and moments of forces; not those
 * of hobe_moment where its section has turned far, which does not keep its direction.  There are
 * such only at the ends of elements; a load at the cut itself counts as beyond, but not at 0.
 * HOBE_CUT_STRESS: the integral over the section of the traction P e_x, P = F S, and of its moment;
 * anywhere, but only as good as the strain, which converges as elements get smaller. */
enum hobe_cut {
    HOBE_CUT_BEST,   /* HOBE_CUT_FORCES at ends of elements, else HOBE_CUT_STRESS */
    HOBE_CUT_FORCES, /* HOBE_BAD_INPUT where `at` is no end of an element */
    HOBE_CUT_STRESS  /* HOBE_BAD_INPUT for structural elements */
};
struct hobe_resultants {
    enum hobe_cut cut;
    double force[3];   /* normal force (tension > 0) and shear forces along y and z, N */
    double moment[3];  /* torsional moment and bending moments about y and z, N m */
    double bimoment;   /* int P_xx w dA, N m^2, or what moves the section mode w; 0 without one */
    double axes[3][3]; /* e_x, e_y, e_z of the section now, rows: global force = sum force_b e_b */
};
enum hobe_status hobe_solution_resultants(const hobe_solution *solution, const char *beam,
                                          double at, enum hobe_cut cut,
                                          struct hobe_resultants *resultants,
                                          struct hobe_error *err);

/* How far a beam's walls bend where it is twisted most: in the element of the greatest mean twist
 * rate, less that of the reference.  See hobe_section_wall_bending, which it asks; it assumes an
 * even twist of a beam that is straight in the reference.  A section that varies is solved anew for
 * that place. */
struct hobe_wall_bending {
    double at;           /* the middle of that element, a fraction of the beam's length */
    double twist_rate;   /* there, rad/m */
    double torque;       /* by its nodal forces, N m */
    double loss;         /* the fraction of the torque at that twist rate that wall bending would
                            take; 0 where the element has the modes v2y and v2z for that */
    double limit_torque; /* at which the outline collapses, N m; INFINITY where it does not */
};
enum hobe_status hobe_solution_wall_bending(const hobe_solution *solution, const char *beam,
                                            struct hobe_wall_bending *bending,
                                            struct hobe_error *err);

/* What must not be overlooked about a beam in a state. */
enum hobe_warning {
    HOBE_WARNING_NONE,
    HOBE_WARNING_BENDS,    /* wall bending would take 1/20 of the torque or more */
    HOBE_WARNING_COLLAPSED /* the torque is beyond the limit torque */
};

/* The warning and its sentence, "" of none.  Cheap where the beam is hardly twisted: walls are
 * asked only where the section's extent times the twist rate is more than 0.001 rad, which bends
 * even walls that are a thousand times as wide as thick by less than would be told.  Not of
 * sections that vary along the beam, nor of elements with w2t, whose outline collapses where it
 * should. */
enum hobe_status hobe_solution_warning(const hobe_solution *solution, const char *beam,
                                       enum hobe_warning *warning, char *text, size_t size,
                                       struct hobe_error *err);

/* An estimate of how much too stiff a beam's mesh is in a state of statics, from 0 to 1: the share
 * that is missing of what the loads do to the beam, with the same element on a fine mesh for truth.
 * By what each element lacks under the nodal forces it has (enriched.h), in stretch, shear,
 * bending, torsion and any of its modes: coarse meshes, locking, warping that fades from an end. In
 * random cantilevers it is between 0.3 and 3 times the truth, to 0.001; not in it are what loads do
 * that act inside elements, and what the reference of a curved beam itself lacks where slopes are
 * linear. It costs about an iteration of Newton, a few with many modes.  0 with mechanics
 * `structural`, whose strains count at points of their own, and with integration `paper`, which has
 * too few. */
enum hobe_status hobe_solution_mesh_error(const hobe_solution *solution, const char *beam,
                                          double *share, struct hobe_error *err);

/* The sentence to warn with where that is 1/100 or more, "" where it is less. */
enum hobe_status hobe_solution_mesh_warning(const hobe_solution *solution, const char *beam,
                                            char *text, size_t size, struct hobe_error *err);

/* What a clamp or support does to its beam or body, and a joint to its second, global axes: the
 * force and its moment about the place where it sits.  Of a clamp the forces on all vectors of its
 * node, with those on the slope x and on section modes in the moment; clamps that hold one node of
 * several beams each give the whole. */
struct hobe_reaction {
    double force[3], moment[3]; /* N, N m */
    double power;               /* W, of its drives */
};
enum hobe_status hobe_solution_reaction(const hobe_solution *solution, const char *name,
                                        struct hobe_reaction *reaction, struct hobe_error *err);

/* What a spring and its damper do. */
struct hobe_spring_state {
    enum hobe_spring_kind kind;
    double extension[3]; /* the length, m; the angle, rad; or three displacements, m */
    double force[3]; /* that pulls both places together, N; the moment that turns the second part
                        back, N m; or three forces that push the second place back, N */
};

/* Of the spring called name; HOBE_UNKNOWN where there is none. */
enum hobe_status hobe_solution_spring(const hobe_solution *solution, const char *name,
                                      struct hobe_spring_state *state, struct hobe_error *err);

/* The i-th beam's name in the order added, or NULL past the last. */
const char *hobe_model_beam_name(const hobe_model *model, int i);

/* Whether the model has a body of that name. */
int hobe_model_has_body(const hobe_model *model, const char *name);

/* ---- vibration (modal.c) -------------------------------------------------------------------- */

enum hobe_modal_method {
    HOBE_MODAL_AUTO,   /* by size: dense for few unknowns, Lanczos for many or with corners */
    HOBE_MODAL_DENSE,  /* LAPACK, all modes at once; not for rigid corners */
    HOBE_MODAL_LANCZOS /* ARPACK, shift and invert about zero */
};

struct hobe_modal_options {
    int modes; /* wanted, those of the smallest omega^2; 0: 10, or all where there are fewer */
    enum hobe_modal_method method;
};

/* Undamped small vibrations about an equilibrium: K phi = omega^2 M phi with K the tangent
 * stiffness of elements, corners and loads there (so that prestress counts) and phi'M phi = 1.
 *
 * Where the scene spins, with angular velocity w, and the state has a load factor > 0:
 * (lambda^2 M + 2 lambda M [w]x + K) phi = 0 in the turning frame, the centrifugal force in K, with
 * complex lambda and phi, phi^H M phi = 1: the motion is Re(phi exp(lambda t)).  Its largest
 * component is at its crest at t = 0.  Gyroscopic forces may keep stable what K does not: what
 * counts is the real part of lambda. */
typedef struct hobe_modes hobe_modes;

struct hobe_modes_info {
    int count;        /* modes found */
    int buckling;     /* they are of hobe_buckling */
    int unstable;     /* modes of the scene that grow, wanted or not; -1: not known */
    long unknowns;    /* scalar unknowns, multipliers included */
    double mass;      /* of all beams, bodies and masses, kg */
    double residual;  /* of a turning frame: how much a step of inverse iteration would change the
                         worst of the shapes, relative, whose square is the error of a frequency */
    double round_off; /* of hobe_modal at rest: the largest share of an omega^2 that rounding of the
                         stiffness may make up, as a rule that of the lowest */
    double seconds;   /* in hobe_modal without set-up */
    enum hobe_modal_method method; /* that was used */
};

struct hobe_mode {
    double omega2;            /* -Re(lambda^2), that is omega^2 but for flutter, rad^2/s^2; < 0
                                 where the equilibrium is unstable */
    double omega;             /* Im(lambda), rad/s; NaN where lambda is real: divergence */
    double growth;            /* Re(lambda), 1/s, 0 where stable; beside an omega: flutter, which
                                 comes as a mode that grows and one that decays */
    double whirl;             /* of a turning frame: 1 where all circles about the axis as the frame
                                 turns, -1 against it, 0 where the motion is to and fro */
    double participation[3];  /* phi'M r_a, r_a the unit translation of all along global X, Y, Z,
                                 supports included (they shake), sqrt(kg) */
    double effective_mass[3]; /* its square, kg: over all modes they add up to hobe_modes_info.mass
                                 less what rests on the supports; NaN, as
                                 participation is, in a turning frame */
};

/* Vibration about the equilibrium `state` of this model under its loads, or, where NULL, about the
 * reference without load.  HOBE_BAD_INPUT where a beam has no density, or a state holds follower
 * forces (whose stiffness is not symmetric); HOBE_SINGULAR at a critical load.  On success *modes
 * is owned by the caller and refers to the model, which must outlive it; not to the state. Lanczos'
 * method is not for two threads at once. */
enum hobe_status hobe_modal(hobe_model *model, const hobe_solution *state,
                            const struct hobe_modal_options *options, hobe_modes **modes,
                            struct hobe_error *err);
void hobe_modes_free(hobe_modes *modes);
void hobe_modes_info(const hobe_modes *modes, struct hobe_modes_info *info);

/* What must not be overlooked, such as unstable modes: a sentence, or NULL.  Owned by modes. */
const char *hobe_modes_note(const hobe_modes *modes);

/* The i-th mode, 0 <= i < count, omega^2 ascending. */
enum hobe_status hobe_modes_mode(const hobe_modes *modes, int i, struct hobe_mode *mode,
                                 struct hobe_error *err);

/* Displacement u of mode i at the place (at, y, z) of a beam as in hobe_solution_point, global
 * axes, 1/sqrt(kg): times a modal coordinate in m sqrt(kg) it is in m. */
enum hobe_status hobe_modes_point(const hobe_modes *modes, int i, const char *beam, double at,
                                  double y, double z, double u[3], struct hobe_error *err);

/* The same of the imaginary part of a mode in a turning frame, zero elsewhere: with it the place is
 * displaced by u cos(omega t) - quadrature sin(omega t). */
enum hobe_status hobe_modes_quadrature(const hobe_modes *modes, int i, const char *beam, double at,
                                       double y, double z, double u[3], struct hobe_error *err);

/* Both of a body's point as in hobe_solution_body. */
enum hobe_status hobe_modes_body(const hobe_modes *modes, int i, const char *body,
                                 const double point[3], double u[3], double quadrature[3],
                                 struct hobe_error *err);

/* phi_i'M phi_j, summed over the elements: the modal mass, 1, where i = j, and 0 elsewhere, but for
 * rounding and turning frames, whose modes are not orthogonal; the real part, phi_i^H M phi_j.  NaN
 * where there are no such modes. */
double hobe_modes_mass(const hobe_modes *modes, int i, int j);

/* ---- buckling (buckling.c) ------------------------------------------------------------------ */

/* Linear buckling from the equilibrium `state` of this model, or, where NULL, from the reference:
 * the factors lambda of all loads, above that state's own lambda_s, at which (K + (lambda -
 * lambda_s) G) phi = 0, K the tangent stiffness in the state and G the geometric stiffness of the
 * stresses that the loads add to it linearly.  The smallest first, at most as many as wanted (0:
 * 10); phi'G phi = -1 J.  HOBE_BAD_INPUT where the scene has follower forces or no load, or is
 * unstable in that state already.  On success *modes as from hobe_modal, for hobe_modes_factor and
 * hobe_modes_point. */
enum hobe_status hobe_buckling(hobe_model *model, const hobe_solution *state,
                               const struct hobe_modal_options *options, hobe_modes **modes,
                               struct hobe_error *err);

/* The i-th critical load factor; NaN where there is none. */
double hobe_modes_factor(const hobe_modes *modes, int i);

/* ---- reduced models (reduction.c, basis.c, quartic.c) ----------------------------------------
 */

/* A basis of displacements of a model, and its strain energy on it:
 *
 *     u = u_c + sum_j q_j phi_j,     U(q) a polynomial of fourth degree, exact,
 *
 * phi_j fields on all nodal vectors of the beams.  What is held in the model is held in all of
 * them; joints, springs, bodies, masses and loads act as they do on the whole model. */
typedef struct hobe_reduced hobe_reduced;

enum hobe_reduce_method {
    HOBE_REDUCE_SERIES, /* where paths under the loads of interest lead: their principal fields */
    HOBE_REDUCE_MODES,  /* lowest vibration modes, and where paths under their forces of inertia
                           and the loads lead besides */
    HOBE_REDUCE_FIELDS  /* the fields that are given, dependent ones left out */
};

struct hobe_reduce {
    enum hobe_reduce_method method;
    int modes;       /* unknowns q, at most; 0: as many as accuracy needs, or 12 */
    double accuracy; /* relative, of the displacements under the loads of interest: so many fields,
                        and what they lack there besides; hobe_static refuses what is less accurate
                        under others (HOBE_NOT_CONVERGED).  0: modes say */
    const hobe_solution *centre; /* u_c: a state of the model, copied; NULL: the reference */
    int closed; /* 0; 3: with each field its components along all axes, so that any rotation of the
                   whole is in the basis, and the polynomial one of fewer terms unless there is a
                   centre; 2: those along the axes of a plane */
    double normal[3];         /* of that plane */
    hobe_model *const *loads; /* [load_count] models of the same beams and supports whose loads are
                                 of interest beside those of the model */
    int load_count;
    const double *field; /* [fields][vectors][3] of HOBE_REDUCE_FIELDS, m */
    int fields;
};

struct hobe_reduced_info {
    enum hobe_reduce_method method;
    int unknowns;    /* q */
    int closed;      /* as in hobe_reduce */
    long whole;      /* unknowns of the model */
    double accuracy; /* that was asked for, or 0 */
    double seconds;  /* offline: basis and energy; of one that was read, to read it */
};

/* Makes the basis and the energy on it.  HOBE_BAD_INPUT for elements whose energy is not quartic,
 * and options that make no basis.  On success *reduced is owned by the caller and refers to the
 * model, which must outlive it. */
enum hobe_status hobe_reduce(hobe_model *model, const struct hobe_reduce *options,
                             hobe_reduced **reduced, struct hobe_error *err);
void hobe_reduced_free(hobe_reduced *reduced);
void hobe_reduced_info(const hobe_reduced *reduced, struct hobe_reduced_info *info);

/* A model for hobe_static, hobe_path_follow, hobe_modal and hobe_dynamic whose unknowns are q: the
 * reduced form of `model`, which has the beams and supports of the one that the basis was made of,
 * or is it, and its own loads.  Solutions are handed out as such of `model`, expanded.
 * HOBE_BAD_INPUT where the beams or supports differ.  On success *small is owned by the caller and
 * refers to both, which must outlive it. */
enum hobe_status hobe_reduced_model(const hobe_reduced *reduced, hobe_model *model,
                                    hobe_model **small, struct hobe_error *err);

/* What a reduced model has to beat: the model itself on the coarsest mesh that has about as many
 * unknowns, an element to each beam at least.  Both errors are of displacements at places along the
 * beams, on the axis and at a corner of the section's extent, over the largest of them, beside the
 * state with all that it lacks (the corrections of the indicator). */
struct hobe_coarse {
    int elements; /* of all beams; 0: such a mesh has no equilibrium, supports that are no nodes of
                     it, or bodies, or the state is out of reach of the indicator */
    long unknowns;
    double error, reduced; /* of the mesh, and of the reduced model */
};

/* Of an equilibrium of a reduced model (hobe_reduced_model). */
enum hobe_status hobe_reduced_coarse(const hobe_model *small, const hobe_solution *state,
                                     struct hobe_coarse *coarse, struct hobe_error *err);

/* The basis as bytes, for a file, in *bytes, which the caller frees by hobe_free; and from such,
 * for the model it was made of.  HOBE_BAD_INPUT where the bytes are damaged or of another model. */
enum hobe_status hobe_reduced_write(const hobe_reduced *reduced, void **bytes, size_t *size,
                                    struct hobe_error *err);
enum hobe_status hobe_reduced_read(hobe_model *model, const void *bytes, size_t size,
                                   hobe_reduced **reduced, struct hobe_error *err);

#endif
