/* The elements built in.  Written by `python -m generator`: do not edit. */
#include "kernel.h"

#include <stdlib.h>
#include <string.h>

#ifdef HOBE_AVX512
extern const struct hobe_kernel hobe_kernel_3333_avx512;
extern const struct hobe_kernel hobe_kernel_3333s_avx512;
extern const struct hobe_kernel hobe_kernel_3333w_avx512;
extern const struct hobe_kernel hobe_kernel_3333w3_avx512;
extern const struct hobe_kernel hobe_kernel_3363_avx512;
extern const struct hobe_kernel hobe_kernel_3433_avx512;
extern const struct hobe_kernel hobe_kernel_3433w_avx512;
extern const struct hobe_kernel hobe_kernel_34X3_avx512;
extern const struct hobe_kernel hobe_kernel_B4_avx512;
extern const struct hobe_kernel hobe_kernel_BE24_avx512;
extern const struct hobe_kernel hobe_kernel_BE24w_avx512;
extern const struct hobe_kernel hobe_kernel_BE24w_II_avx512;
extern const struct hobe_kernel hobe_kernel_BE42_avx512;
extern const struct hobe_kernel hobe_kernel_MGD30_avx512;
extern const struct hobe_kernel hobe_kernel_MGD30d_avx512;
extern const struct hobe_kernel hobe_kernel_MGD30d2_avx512;
extern const struct hobe_kernel hobe_kernel_MGD30w_avx512;
extern const struct hobe_kernel hobe_kernel_MGD30w_II_avx512;
extern const struct hobe_kernel hobe_kernel_MGD30w3_avx512;

static const struct hobe_kernel *const avx512[] = {
    &hobe_kernel_3333_avx512,
    &hobe_kernel_3333s_avx512,
    &hobe_kernel_3333w_avx512,
    &hobe_kernel_3333w3_avx512,
    &hobe_kernel_3363_avx512,
    &hobe_kernel_3433_avx512,
    &hobe_kernel_3433w_avx512,
    &hobe_kernel_34X3_avx512,
    &hobe_kernel_B4_avx512,
    &hobe_kernel_BE24_avx512,
    &hobe_kernel_BE24w_avx512,
    &hobe_kernel_BE24w_II_avx512,
    &hobe_kernel_BE42_avx512,
    &hobe_kernel_MGD30_avx512,
    &hobe_kernel_MGD30d_avx512,
    &hobe_kernel_MGD30d2_avx512,
    &hobe_kernel_MGD30w_avx512,
    &hobe_kernel_MGD30w_II_avx512,
    &hobe_kernel_MGD30w3_avx512,
    NULL,
};
#endif

#ifdef HOBE_AVX2
extern const struct hobe_kernel hobe_kernel_3333_avx2;
extern const struct hobe_kernel hobe_kernel_3333s_avx2;
extern const struct hobe_kernel hobe_kernel_3333w_avx2;
extern const struct hobe_kernel hobe_kernel_3333w3_avx2;
extern const struct hobe_kernel hobe_kernel_3363_avx2;
extern const struct hobe_kernel hobe_kernel_3433_avx2;
extern const struct hobe_kernel hobe_kernel_3433w_avx2;
extern const struct hobe_kernel hobe_kernel_34X3_avx2;
extern const struct hobe_kernel hobe_kernel_B4_avx2;
extern const struct hobe_kernel hobe_kernel_BE24_avx2;
extern const struct hobe_kernel hobe_kernel_BE24w_avx2;
extern const struct hobe_kernel hobe_kernel_BE24w_II_avx2;
extern const struct hobe_kernel hobe_kernel_BE42_avx2;
extern const struct hobe_kernel hobe_kernel_MGD30_avx2;
extern const struct hobe_kernel hobe_kernel_MGD30d_avx2;
extern const struct hobe_kernel hobe_kernel_MGD30d2_avx2;
extern const struct hobe_kernel hobe_kernel_MGD30w_avx2;
extern const struct hobe_kernel hobe_kernel_MGD30w_II_avx2;
extern const struct hobe_kernel hobe_kernel_MGD30w3_avx2;

static const struct hobe_kernel *const avx2[] = {
    &hobe_kernel_3333_avx2,
    &hobe_kernel_3333s_avx2,
    &hobe_kernel_3333w_avx2,
    &hobe_kernel_3333w3_avx2,
    &hobe_kernel_3363_avx2,
    &hobe_kernel_3433_avx2,
    &hobe_kernel_3433w_avx2,
    &hobe_kernel_34X3_avx2,
    &hobe_kernel_B4_avx2,
    &hobe_kernel_BE24_avx2,
    &hobe_kernel_BE24w_avx2,
    &hobe_kernel_BE24w_II_avx2,
    &hobe_kernel_BE42_avx2,
    &hobe_kernel_MGD30_avx2,
    &hobe_kernel_MGD30d_avx2,
    &hobe_kernel_MGD30d2_avx2,
    &hobe_kernel_MGD30w_avx2,
    &hobe_kernel_MGD30w_II_avx2,
    &hobe_kernel_MGD30w3_avx2,
    NULL,
};
#endif

extern const struct hobe_kernel hobe_kernel_3333;
extern const struct hobe_kernel hobe_kernel_3333s;
extern const struct hobe_kernel hobe_kernel_3333w;
extern const struct hobe_kernel hobe_kernel_3333w3;
extern const struct hobe_kernel hobe_kernel_3363;
extern const struct hobe_kernel hobe_kernel_3433;
extern const struct hobe_kernel hobe_kernel_3433w;
extern const struct hobe_kernel hobe_kernel_34X3;
extern const struct hobe_kernel hobe_kernel_B4;
extern const struct hobe_kernel hobe_kernel_BE24;
extern const struct hobe_kernel hobe_kernel_BE24w;
extern const struct hobe_kernel hobe_kernel_BE24w_II;
extern const struct hobe_kernel hobe_kernel_BE42;
extern const struct hobe_kernel hobe_kernel_MGD30;
extern const struct hobe_kernel hobe_kernel_MGD30d;
extern const struct hobe_kernel hobe_kernel_MGD30d2;
extern const struct hobe_kernel hobe_kernel_MGD30w;
extern const struct hobe_kernel hobe_kernel_MGD30w_II;
extern const struct hobe_kernel hobe_kernel_MGD30w3;

static const struct hobe_kernel *const portable[] = {
    &hobe_kernel_3333,
    &hobe_kernel_3333s,
    &hobe_kernel_3333w,
    &hobe_kernel_3333w3,
    &hobe_kernel_3363,
    &hobe_kernel_3433,
    &hobe_kernel_3433w,
    &hobe_kernel_34X3,
    &hobe_kernel_B4,
    &hobe_kernel_BE24,
    &hobe_kernel_BE24w,
    &hobe_kernel_BE24w_II,
    &hobe_kernel_BE42,
    &hobe_kernel_MGD30,
    &hobe_kernel_MGD30d,
    &hobe_kernel_MGD30d2,
    &hobe_kernel_MGD30w,
    &hobe_kernel_MGD30w_II,
    &hobe_kernel_MGD30w3,
    NULL,
};

/* Whether the environment leaves this machine to choose. */
static int allowed(const char *machine)
{
    const char *only = getenv("HOBE_MACHINE");
    return !only || !strcmp(only, machine);
}

const struct hobe_kernel *const *hobe_kernels(void)
{
#ifdef HOBE_AVX512
    if (allowed("avx512") && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma"))
        return avx512;
#endif
#ifdef HOBE_AVX2
    if (allowed("avx2") && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return avx2;
#endif
    return portable;
}

const char *hobe_machine(void)
{
#ifdef HOBE_AVX512
    if (hobe_kernels() == avx512)
        return "avx512";
#endif
#ifdef HOBE_AVX2
    if (hobe_kernels() == avx2)
        return "avx2";
#endif
    return "portable";
}
