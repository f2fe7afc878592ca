/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Modes in a frame that turns steadily. */
#ifndef HOBE_GYROSCOPIC_H
#define HOBE_GYROSCOPIC_H

#include "modes.h"

/* How many modes of K and M to start from, by the method of the options. */
struct hobe_modal_options gyroscopic_basis(const struct pencil *s,
                                           const struct hobe_modal_options *o);

/* The modes that o asks for, of lambda^2 M + 2 lambda M [w]x + K, w the frame's angular velocity,
 * from a pencil of K and M that is solved for such a basis and told how many of its mu are
 * negative, -1: unknown. */
enum hobe_status gyroscopic_modes(struct pencil *s, const struct hobe_modal_options *o,
                                  const double w[3], int negative, hobe_modes **modes,
                                  struct hobe_error *err);

#endif
