/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A drawing: paths of lines and arcs, joined to the loops of an outline. */
#ifndef HOBE_OUTLINE_DRAWING_H
#define HOBE_OUTLINE_DRAWING_H

#include "hobe.h"

/* Points while paths are apart: each line brings both of its ends. */
enum { HOBE_MOST_DRAWN = 2 * HOBE_MAX_OUTLINE };

/* The points from .. to - 1 of a drawing, in turn. */
struct hobe_path {
    const char *what; /* for sentences: "LINE" */
    int line;         /* of the file, where it begins */
    int from, to;
    int closed; /* the last point leads to the first */
};

struct hobe_drawing {
    const char *name;       /* of the file, for sentences */
    double tolerance;       /* greatest distance between an arc and its chords, > 0 */
    struct hobe_path *path; /* [HOBE_MOST_DRAWN] */
    double (*point)[2];     /* [HOBE_MOST_DRAWN] */
    int paths;              /* the last of them may still grow */
};

/* A drawing of no paths, and its end. */
enum hobe_status hobe_drawing_new(struct hobe_drawing *drawing, const char *name,
                                  struct hobe_error *err);
void hobe_drawing_free(struct hobe_drawing *drawing);

/* Begins a path; every point until the next call belongs to it. */
void hobe_path_begin(struct hobe_drawing *drawing, const char *what, int line);

/* The path that grows. */
struct hobe_path *hobe_path_last(struct hobe_drawing *drawing);

/* A straight line to p, or the first point.  One sentence where there are too many points or p is
 * not finite, as in all that follows. */
enum hobe_status hobe_path_line(struct hobe_drawing *drawing, const double p[2],
                                struct hobe_error *err);

/* An arc p(t) = centre + a cos t + b sin t, t = from .. from + sweep, of a circle or an ellipse of
 * conjugate semi-axes a and b.  Its ends lie on it.  The corners between lie off it by less than
 * the tolerance, so far that the chords enclose its area: the area of a drawing is exact, moments
 * are to fourth order of the angle of a chord. */
struct hobe_arc {
    double centre[2], a[2], b[2];
    double from, sweep; /* rad */
};

/* Adds the corners of an arc and its end; its start, too, where it begins the path. */
enum hobe_status hobe_path_arc(struct hobe_drawing *drawing, const struct hobe_arc *arc,
                               struct hobe_error *err);

/* Adds a whole circle or ellipse as a closed path's points. */
enum hobe_status hobe_path_ellipse(struct hobe_drawing *drawing, const struct hobe_arc *arc,
                                   struct hobe_error *err);

/* The longer side of the box that holds all points. */
double hobe_drawing_extent(const struct hobe_drawing *drawing);

/* Loops of points as hobe_section_polygon takes them, the one of the largest area first. */
struct hobe_loops {
    int loops;
    int *points;        /* [loops] */
    double (*point)[2]; /* [sum of points] */
};

/* Chains paths whose ends coincide to closed loops and leaves out points that repeat the one
 * before; a path smaller than that is none.  One sentence for a path that leads nowhere and for
 * three ends at one place.  hobe_loops_free frees the loops. */
enum hobe_status hobe_drawing_loops(struct hobe_drawing *drawing, struct hobe_loops *loops,
                                    struct hobe_error *err);
void hobe_loops_free(struct hobe_loops *loops);

#endif
