/* The elements built in.  Written by the generator: do not edit. */
#include "kernel.h"

extern const struct hobe_kernel hobe_kernel_3333;
extern const struct hobe_kernel hobe_kernel_3333w;
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
extern const struct hobe_kernel hobe_kernel_MGD30w;
extern const struct hobe_kernel hobe_kernel_MGD30w_II;

const struct hobe_kernel *const hobe_kernels[] = {
    &hobe_kernel_3333,
    &hobe_kernel_3333w,
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
    &hobe_kernel_MGD30w,
    &hobe_kernel_MGD30w_II,
    NULL,
};
