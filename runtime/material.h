/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Isotropic elasticity as a kernel wants it. */
#ifndef HOBE_MATERIAL_H
#define HOBE_MATERIAL_H

#include "hobe.h"

/* HOBE_BAD_INPUT with the offending value when a constant is out of its range. */
enum hobe_status hobe_material_check(const struct hobe_material *material, struct hobe_error *err);

/* The laws of a material under one of the mechanics (not DEFAULT): at a point, and on the
 * mean strain. */
void hobe_material_law(const struct hobe_material *material, enum hobe_mechanics mechanics,
                       struct hobe_elasticity *point, struct hobe_elasticity *mean);

/* Mechanics by name; DEFAULT when there is none of that name. */
enum hobe_mechanics hobe_mechanics_find(const char *name);

#endif
