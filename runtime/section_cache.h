/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections that are solved, by their content.
 *
 * To solve a section takes a tenth of a second, and scripts describe the same one again and again.
 * One whose content is in use already is not solved anew.  What nobody uses any more is freed at
 * once: the cache holds what its users hold, and nothing at the end of a program that frees its
 * sections.  All threads may call. */
#ifndef HOBE_SECTION_CACHE_H
#define HOBE_SECTION_CACHE_H

#include "section.h"

/* The solved section of this content[count], every number of which matters to the last bit: one in
 * use, or `section` once `solve` has solved it.  `section` belongs to the cache from here on, and
 * is freed where it is not needed.  hobe_section_drop gives the result back; until then it does not
 * change.  NULL with the error of `solve`, or for want of memory. */
const hobe_section *hobe_section_share(hobe_section *section, const double *content, size_t count,
                                       enum hobe_status (*solve)(hobe_section *section,
                                                                 struct hobe_error *err),
                                       struct hobe_error *err);
void hobe_section_drop(const hobe_section *section);

#endif
