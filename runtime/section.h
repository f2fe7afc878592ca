/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cross-sections: what a kernel needs of one.  The public part is in hobe.h. */
#ifndef HOBE_SECTION_H
#define HOBE_SECTION_H

#include "surface.h"

struct hobe_outline; /* section_mesh.h */

/* The functions of a section, in the order in which its kind keeps them: w of torsion, wy and wz of
 * bending shear along y and z; and, of solved outlines, those of distortion.h. */
enum {
    HOBE_W,
    HOBE_WY,
    HOBE_WZ,
    HOBE_SECTION_FUNCTIONS,
    HOBE_WW = HOBE_SECTION_FUNCTIONS,
    HOBE_W1,
    HOBE_W2,
    HOBE_W3,
    HOBE_W2T,
    HOBE_V1Y,
    HOBE_V1Z,
    HOBE_V2Y,
    HOBE_V2Z,
    HOBE_V3Y,
    HOBE_V3Z,
    HOBE_ALL_FUNCTIONS
};

/* A cubature rule that owns its points. */
struct hobe_rule {
    struct hobe_section_rule rule;
    struct hobe_section_point *point;
};

/* A rule of points, all zero; hobe_rule_free frees it. */
enum hobe_status hobe_rule_new(struct hobe_rule *rule, size_t points, struct hobe_error *err);
enum hobe_status hobe_rule_copy(const struct hobe_rule *from, struct hobe_rule *to,
                                struct hobe_error *err);

/* Where along a beam a section is wanted. */
struct hobe_section_place {
    double at;     /* fraction of the beam's length, 0..1 */
    double length; /* of the beam, m */
};

/* The rule that integrates the kernel's energy over the section at a place (NULL: at 0; sections
 * that do not vary along the beam ignore it), with the values of the section functions that the
 * kernel names: exact (polynomials to round-off, section functions to about
 * 1e-9), or the paper's 3 x 3 Gauss points with its own warping function.
 * HOBE_UNKNOWN when the section lacks a function. */
enum hobe_status hobe_section_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                   enum hobe_integration integration,
                                   const struct hobe_section_place *place, struct hobe_rule *rule,
                                   struct hobe_error *err);

/* The rule of one point on the axis, weight A. */
enum hobe_status hobe_axis_rule(const hobe_section *section, const struct hobe_kernel *kernel,
                                enum hobe_integration integration,
                                const struct hobe_section_place *place, struct hobe_rule *rule,
                                struct hobe_error *err);

/* The functions that the kernel names and their gradients at (y, z) of a place, in the kernel's
 * order: f[HOBE_MAX_FUNCTIONS][4]. */
enum hobe_status hobe_section_functions_at(const hobe_section *section,
                                           const struct hobe_kernel *kernel,
                                           const struct hobe_section_place *place, double y,
                                           double z, double (*f)[4], struct hobe_error *err);

/* Which of the section's materials is at (y, z), or nearest to it. */
int hobe_section_region(const hobe_section *section, double y, double z);

/* One function and its gradient at (y, z) of a place (NULL: at 0), as hobe_section_function: f[3].
 */
enum hobe_status hobe_section_function_at(const hobe_section *section, const char *name,
                                          const struct hobe_section_place *place, double y,
                                          double z, double *f, struct hobe_error *err);

/* The surface of hobe_section_surface at a fraction of the beam's length, numbered alike along it:
 * fills an empty one, which the caller frees even after a failure. */
enum hobe_status hobe_section_surface_at(const hobe_section *section, double at, int fineness,
                                         struct hobe_surface *surface, struct hobe_error *err);

/* Places at which the material's volume is watched there: probe[HOBE_PROBES][2]. */
enum hobe_status hobe_section_probes_at(const hobe_section *section,
                                        const struct hobe_section_place *place, double (*probe)[2],
                                        struct hobe_error *err);

/* The section's properties there. */
enum hobe_status hobe_section_properties_at(const hobe_section *section,
                                            const struct hobe_section_place *place,
                                            struct hobe_section_properties *p,
                                            struct hobe_error *err);

void hobe_rule_free(struct hobe_rule *rule);

/* Gauss-Legendre points and weights on [0,1]: gauss[n][2]. */
enum hobe_status hobe_gauss(int n, double (*gauss)[2], struct hobe_error *err);

/* ---- for the kinds of sections ---------------------------------------------------------------
 *
 * A kind embeds struct hobe_section as its first member, fills it once, and never changes it
 * afterwards, so that threads may share it. */

enum { HOBE_PROBES = 16 };

struct hobe_section_kind {
    /* The rule of hobe_section_rule, with the section's functions at HOBE_W, HOBE_WY, HOBE_WZ of
     * each point whatever the kernel calls for, and the others where it calls for them. */
    enum hobe_status (*rule)(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err);
    /* The functions and their gradients at (y, z), f[HOBE_MAX_FUNCTIONS][4]; `paper`: those
     * that go with the paper's integration.  What the section has not is left alone. */
    void (*functions)(const hobe_section *section, int paper, double y, double z, double (*f)[4]);
    /* The region at (y, z), or the nearest one; of a kind that can have several. */
    int (*region)(const hobe_section *section, double y, double z);
    /* The outline about the section's own origin; circles become polygons of their area. */
    enum hobe_status (*outline)(const hobe_section *section, struct hobe_outline *outline,
                                struct hobe_error *err);
    enum hobe_status (*surface)(const hobe_section *section, int fineness,
                                struct hobe_surface *surface,
                                struct hobe_error *err); /* hobe_section_surface */
    /* Makes the functions from HOBE_WW on, which cost more than most beams are worth, and keeps
     * them, with the *wall_bending of hobe_section_wall_bending; NULL: all are zero. */
    enum hobe_status (*distort)(const hobe_section *section, double *wall_bending,
                                struct hobe_error *err);
    void (*close)(hobe_section *section); /* frees what the kind added; may be NULL */
    const struct hobe_section_sizes
        *sizes; /* of a kind that can taper (section_taper.h), or NULL */

    /* Of a section that varies along the beam, in place of rule and functions; else NULL. */
    enum hobe_status (*rule_at)(const hobe_section *section, const struct hobe_kernel *kernel,
                                enum hobe_integration integration,
                                const struct hobe_section_place *place, struct hobe_rule *rule,
                                struct hobe_error *err);
    enum hobe_status (*functions_at)(const hobe_section *section, int paper,
                                     const struct hobe_section_place *place, double y, double z,
                                     double (*f)[4], struct hobe_error *err);
    enum hobe_status (*surface_at)(const hobe_section *section, double at, int fineness,
                                   struct hobe_surface *surface, struct hobe_error *err);
    /* Its area at a fraction of the beam's length, and its probes unless NULL. */
    enum hobe_status (*shape_at)(const hobe_section *section, double at, double *area,
                                 double (*probe)[2], struct hobe_error *err);
    /* All its properties there. */
    enum hobe_status (*properties_at)(const hobe_section *section, double at,
                                      struct hobe_section_properties *p, struct hobe_error *err);
};

struct hobe_section {
    const struct hobe_section_kind *kind;
    struct hobe_section_properties properties;
    struct hobe_material *material; /* [regions] of its own; NULL: the beam's */
    int regions;                    /* where it has materials */
    int probes;
    double probe[HOBE_PROBES][2]; /* places where the material's volume is watched, y, z, m */
    char text[160];
};

/* E and G of a region over those of the first; 1 where the section has no materials of its own. */
double hobe_section_E(const hobe_section *section, int region);
double hobe_section_G(const hobe_section *section, int region);

/* Sets Iw and J_w by the w of a rule: the least energy of a unit twist, (-z, y) as a field of
 * shear, when the amplitude of w and a constant shear are free, as they are in an element. */
void hobe_section_set_warping(hobe_section *section, const struct hobe_rule *rule);

/* Sets ky, kz and kyz by the functions of a rule: k is the least energy of unit shears when the
 * amplitudes of the functions are free, over that when they are held.  Functions that vanish do not
 * matter. */
void hobe_section_set_shear(hobe_section *section, const struct hobe_rule *rule);

/* Whether the kernel has functions of bending shear; of distortion. */
int hobe_section_bends(const struct hobe_kernel *kernel);
int hobe_section_distorts(const struct hobe_kernel *kernel);

/* HOBE_BAD_INPUT: this section has no version in the paper. */
enum hobe_status hobe_section_no_paper(const char *what, struct hobe_error *err);

#endif
