/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dense symmetric elimination of a few columns: what a front does (fronts.h).
 *
 * A panel holds the first `columns` columns of a symmetric matrix of `rows` rows, by columns with a
 * stride that is a multiple of PANEL_ALIGN, zero above its diagonal blocks and in its spare rows.
 * Elimination without pivoting makes it
 *
 *     [A11     ]   [L11    ] [D   ] [L11' L21']
 *     [A21  A22] = [L21  I ] [   S] [      I  ],     S = A22 - L21 D L21'.
 *
 * Rows and columns are multiples of PANEL_STEP: those of 3 x 3 blocks.  The functions exist twice,
 * for registers of AVX2 and portably: hobe_machine says which go. */
#ifndef HOBE_PANEL_H
#define HOBE_PANEL_H

enum {
    PANEL_STEP = 3,
    PANEL_WIDE = 2 * PANEL_STEP, /* columns eliminated together */
    PANEL_ALIGN = 4,
    PANEL_SLACK = 8 /* doubles behind the last panel that may be read */
};

struct panel_functions {
    /* a[columns][stride]: the panel, overwritten by L below the diagonal, zero on and above it;
     * d[columns] the pivots; room[columns][PANEL_WIDE] is scratch. */
    void (*factor)(long rows, long columns, long stride, double *a, double *d, double *room);

    /* w[rows - columns][stride] = -L21 D L21' by its lower triangle, at the rows it has in the
     * panel; what is above its diagonal and behind its last row is undefined. */
    void (*update)(long rows, long columns, long stride, const double *a, const double *d,
                   double *w, double *room);

    /* v[stride], zero behind `rows`: v1 = L11^-1 v1, v2 -= L21 v1. */
    void (*forward)(long columns, long stride, const double *a, double *v);

    /* v1 = L11'^-1 (v1 - L21' v2). */
    void (*backward)(long columns, long stride, const double *a, double *v);
};

extern const struct panel_functions panel_portable;
#ifdef HOBE_AVX2
extern const struct panel_functions panel_avx2;
#endif

#endif
