/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces with a field on them: what a picture or a file for other programs shows. */
#ifndef HOBE_SURFACE_H
#define HOBE_SURFACE_H

#include "hobe.h"

/* Triangles, and the lines that make the shape readable.  {0} is empty. */
struct hobe_surface {
    int points, triangles, edges;
    double (*point)[3];        /* in the reference, m */
    double (*displacement)[3]; /* [points] m, or of a mode in any unit */
    double *value;             /* [points] of a field */
    int (*triangle)[3];        /* anticlockwise seen from outside */
    int (*edge)[2];
    int outline; /* of a section: so many edges come first that bound it */
};

/* Room for so many more, zero and not counted before they are added.  What is there stays on
 * failure. */
enum hobe_status hobe_surface_grow(struct hobe_surface *surface, int points, int triangles,
                                   int edges, struct hobe_error *err);
void hobe_surface_free(struct hobe_surface *surface);

/* Adds a triangle or an edge where there is room, counting up. */
void hobe_surface_triangle(struct hobe_surface *surface, int a, int b, int c);
void hobe_surface_edge(struct hobe_surface *surface, int a, int b);

/* What the displacements must be multiplied by for the largest of them to be this fraction of the
 * surface's size (the diagonal of its box); 0 where nothing moves. */
double hobe_surface_scale(const struct hobe_surface *surface, double fraction);

/* ---- of sections (section_surface.c) -------------------------------------------------------- */

/* A section in its plane (one that varies along the beam: that at its start): points (0, y, z), the
 * triangles' normals along +x, edges along its outline with the material on their left, then those
 * between the parts of a composite one; values 0.
 * Triangles come in fours, the quarters of a quadratic one (hobe_surface_quadratic).  Outlines have
 * those of their mesh; rectangles and rings a grid of 2 `fineness` (>= 1) cells along a side, or an
 * eighth of a turn. */
enum hobe_status hobe_section_surface(const hobe_section *section, int fineness,
                                      struct hobe_surface *surface, struct hobe_error *err);

/* The same with the values f of a section function, and displacements -f along x: those of a twist
 * about +x for w.  depth > 0, m: the end of a stub of a beam of that length, with its sides. */
enum hobe_status hobe_section_field(const hobe_section *section, const char *function, int fineness,
                                    double depth, struct hobe_surface *surface,
                                    struct hobe_error *err);

/* The t-th of the quadratic triangles of a section, of triangles/4: its corners, then the middles
 * of sides 01, 12, 20. */
void hobe_surface_quadratic(const struct hobe_surface *surface, int t, int n[6]);

/* ---- of beams (beam_surface.c) --------------------------------------------------------------- */

/* Something to colour beams by. */
struct hobe_field {
    const char *name;                                /* as scenes say it: "ux" */
    const char *symbol, *unit;                       /* as pictures do; unit may be NULL */
    int signs;                                       /* it has both signs */
    int linear;                                      /* mode shapes have it, too */
    double (*value)(const struct hobe_point *point); /* NULL: a stress, or a section function of
                                                        this name */
    size_t stress; /* where in struct hobe_stress a stress is; 0: it is none */
};

/* The field called name, one that mode shapes have where `linear`; NULL with err listing them. */
const struct hobe_field *hobe_find_field(const char *name, int linear, struct hobe_error *err);

/* HOBE_BAD_INPUT where the field is a stress and a beam has none (hobe_solution_stress). */
enum hobe_status hobe_check_field(const hobe_solution *solution, const struct hobe_field *field,
                                  struct hobe_error *err);

/* The skins of all beams: their outlines swept from end to end, and both ends closed, with the
 * displacements of the state and the values of the field; edges along sharp corners and around the
 * ends. */
enum hobe_status hobe_solution_surface(const hobe_solution *solution,
                                       const struct hobe_field *field, struct hobe_surface *surface,
                                       struct hobe_error *err);

/* The section of a beam at `at`, numbered like hobe_section_surface: points in its plane, and
 * displacements on its axes now (as hobe_stress.section), less those of the axis: how it warps and
 * changes its shape. */
enum hobe_status hobe_solution_slice(const hobe_solution *solution, const char *beam, double at,
                                     const struct hobe_field *field, struct hobe_surface *surface,
                                     struct hobe_error *err);

/* The skin of mode i and a linear field, displacements in 1/sqrt(kg). */
enum hobe_status hobe_modes_surface(const hobe_modes *modes, int i, const struct hobe_field *field,
                                    struct hobe_surface *surface, struct hobe_error *err);

#endif
