/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outlines: checked, turned the right way round, moved. */
#ifndef HOBE_OUTLINE_H
#define HOBE_OUTLINE_H

#include "section_mesh.h"

/* Copies loops[l] points of each loop and turns them as struct hobe_outline has it.  One sentence
 * when the outline crosses itself, has no area, has a hole outside or in another hole, ...; the
 * caller says whose outline it is (hobe_fail_in). */
enum hobe_status hobe_outline_new(int loops, const int *points, const double (*point)[2],
                                  struct hobe_outline *outline, struct hobe_error *err);
enum hobe_status hobe_outline_copy(const struct hobe_outline *from, struct hobe_outline *to,
                                   struct hobe_error *err);
void hobe_outline_free(struct hobe_outline *outline);

/* Area and centroid of the material. */
double hobe_outline_area(const struct hobe_outline *outline, double centroid[2]);

void hobe_outline_move(struct hobe_outline *outline, double y, double z);

/* Whether p lies in the material. */
int hobe_outline_holds(const struct hobe_outline *outline, const double p[2]);

/* The point that follows point i of the loop. */
int hobe_outline_next(const struct hobe_outline *outline, int loop, int i);

#endif
