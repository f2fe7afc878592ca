/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is compiled once for each kind of processor, as kernels are, beside them. */
#ifndef HOBE_MACHINE_H
#define HOBE_MACHINE_H

#include "kernel.h"

#include <string.h>

/* The list of all versions of HOBE_KERNEL(name), portable first. */
#ifdef HOBE_AVX512
#define HOBE_MACHINES(name)                                                                        \
    {                                                                                              \
        &hobe_kernel_##name, &hobe_kernel_##name##_avx2, &hobe_kernel_##name##_avx512              \
    }
#elif defined HOBE_AVX2
#define HOBE_MACHINES(name)                                                                        \
    {                                                                                              \
        &hobe_kernel_##name, &hobe_kernel_##name##_avx2                                            \
    }
#else
#define HOBE_MACHINES(name)                                                                        \
    {                                                                                              \
        &hobe_kernel_##name                                                                        \
    }
#endif

/* The place in such a list of the machine that the kernels in use are for. */
static inline int machine_in_use(void)
{
    const char *name = hobe_machine();
    return !strcmp(name, "portable") ? 0 : !strcmp(name, "avx2") ? 1 : 2;
}

#endif
