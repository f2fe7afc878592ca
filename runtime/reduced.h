/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A basis with the elastic energy on it: what models are reduced by. */
#ifndef HOBE_REDUCED_H
#define HOBE_REDUCED_H

#include "basis.h"
#include "hobe.h"
#include "quartic.h"

struct hobe_reduced {
    hobe_model *model;
    struct hobe_reduced_info info;
    struct basis basis; /* of the model's fields; zero at held vectors */
    double *centre;     /* [vectors][3] u_c; NULL: the reference */
    struct quartic quartic;
};

#endif
