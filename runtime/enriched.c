/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "enriched.h"

#include "machine.h"

extern enriched_function hobe_kernel_enriched, hobe_kernel_enriched_avx2,
    hobe_kernel_enriched_avx512;

enriched_function *enriched_work(void)
{
    static enriched_function *const of[] = HOBE_MACHINES(enriched);
    return of[machine_in_use()];
}

/* The arrays of struct work, and one law with its columns. */
size_t enriched_scratch(const struct hobe_kernel *k)
{
    const size_t V = (size_t)k->vectors, S = 2 * (size_t)k->modes - 1, n = V + (size_t)k->modes,
                 grams = (size_t)(k->normals + k->shears);
    return 9 * V + 12 * S + 5 * grams + 9 * S * S + 3 * n * (3 * n + 1) / 2 + 9 * n +
           2 * grams * grams / HOBE_LANES + 1;
}
