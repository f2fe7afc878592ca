/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench_princeton.h"

static const double WIDTH = 3.2024e-3, HEIGHT = 12.377e-3; /* m */
static const struct hobe_material aluminium = {71.7e9, 0.31, 2700, 1, 1, 0};

hobe_section *bench_princeton_section(struct hobe_error *err)
{
    return hobe_section_rectangle(WIDTH, HEIGHT, HOBE_WARPING_SERIES, err);
}

enum hobe_status bench_princeton_beam(hobe_model *model, const struct hobe_kernel *kernel,
                                      int elements, double length, const hobe_section *section,
                                      struct hobe_error *err)
{
    return hobe_model_beam(model,
                           &(struct hobe_beam){.name = "beam",
                                               .kernel = kernel,
                                               .elements = elements,
                                               .section = section,
                                               .material = aluminium,
                                               .to = {length, 0, 0}},
                           err);
}

int bench_princeton_mesh(const struct hobe_kernel *kernel)
{
    return kernel->nodes == 2 ? 38 : kernel->nodes == 3 ? 24 : 16;
}
