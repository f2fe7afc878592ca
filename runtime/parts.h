/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of a scene that nothing couples: each is a problem of its own.
 *
 * Beams that share a vector, a joint or a spring are in one part.  The tangent of the
 * whole is block diagonal in the parts, whatever the state, and so each has its own equilibrium;
 * solved by itself it takes no shorter steps, and no more iterations, than it would alone.
 * hobe_static begins here. */
#ifndef HOBE_PARTS_H
#define HOBE_PARTS_H

#include "hobe.h"

struct parts {
    int count;         /* 1: the scene is one problem */
    hobe_model **part; /* [count] models of the parts' beams, NULL until asked for: their states
                          are the scene's, [vectors][3], in which all others are held */
    int *of_beam;      /* [beams] -1: all of it is held */
};

/* Finds the parts of a model that is numbered, and notes where they are more than one. */
enum hobe_status parts_find(hobe_model *model, struct hobe_error *err);
void parts_free(struct parts *parts);

#endif
