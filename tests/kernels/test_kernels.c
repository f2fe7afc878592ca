/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tests of every kernel built in, against an independent evaluator and exact solutions.
 *
 * The random states take their seed, any text, from the environment variable HOBE_TEST_SEED.  The
 * exit status is 0 when no check failed. */
#include "check.h"
#include "checks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int goes_with(const struct hobe_kernel *kernel, int law)
{
    return pw_goes_with((enum pw_mechanics)law, !strcmp(kernel->mechanics, "structural"));
}

/* What no law touches is checked with one law. */
static int first(int law)
{
    return law == PW_AVERAGE || law == PW_STRUCTURAL;
}

static void check_kernel(const struct hobe_kernel *kernel)
{
    for (int law = 0; law < PW_LAWS; law++) {
        struct fixture fx;
        if (!goes_with(kernel, law))
            continue;
        fixture_open(&fx, kernel, (enum pw_mechanics)law);
        if (first(law)) {
            check_declaration(&fx);
            check_shape(&fx);
            check_strain(&fx);
            check_mass(&fx);
        }
        check_values(&fx);
        check_round_off(&fx, first(law));
        check_identities(&fx);
        check_rigid(&fx);
        if (law != PW_STRUCTURAL) {
            check_homogeneous(&fx);
            check_points(&fx, first(law));
        }
        if (!fx.known && first(law))
            printf("note: the evaluator does not know %s: checked for consistency only\n",
                   kernel->name);
        fixture_close(&fx);
    }
}

/* Curved, pretwisted, distorted, with a section function that varies along the element. */
static void check_curved(const struct hobe_kernel *kernel)
{
    for (int law = 0; law < PW_LAWS; law++) {
        struct fixture fx;
        if (!goes_with(kernel, law))
            continue;
        fixture_open_curved(&fx, kernel, (enum pw_mechanics)law);
        if (fx.known) {
            check_values(&fx);
            check_round_off(&fx, first(law));
            check_rigid(&fx);
            if (law != PW_STRUCTURAL)
                check_points(&fx, 0);
            if (first(law))
                check_strain(&fx);
            if (law == PW_AVERAGE) /* a rod's points are not the evaluator's of the volume */
                check_mass(&fx);
        }
        fixture_close(&fx);
    }
}

/* Both plans, on sections with each symmetry. */
static void check_products(const struct hobe_kernel *kernel)
{
    for (int law = 0; law < PW_LAWS; law++)
        for (int symmetry = HOBE_SYMMETRIC_X; symmetry < HOBE_SYMMETRIES; symmetry += 2) {
            struct fixture fx;
            if (!goes_with(kernel, law) || !kernel->tensor)
                continue;
            fixture_open_symmetric(&fx, kernel, (enum pw_mechanics)law, symmetry);
            check_plans(&fx);
            check_round_off(&fx, first(law) && symmetry == HOBE_SYMMETRIES - 1);
            check_rigid(&fx);
            if (first(law))
                check_identities(&fx);
            fixture_close(&fx);
        }
}

/* The plan from station to station where functions of a symmetric section vary along the axis. */
static void check_tapered(const struct hobe_kernel *kernel)
{
    const int z = HOBE_SYMMETRIC_Z, symmetries[] = {HOBE_SYMMETRIC_Y, z, HOBE_SYMMETRIC_Y | z};
    for (int i = 0; kernel->functions && i < 3; i++) {
        struct fixture fx;
        fixture_open_tapered(&fx, kernel, PW_AVERAGE, symmetries[i]);
        check_plans(&fx);
        fixture_close(&fx);
    }
}

static int built_in(const char *name)
{
    for (int i = 0; hobe_kernels()[i]; i++)
        if (!strcmp(hobe_kernels()[i]->name, name))
            return 1;
    return 0;
}

/* With arguments, only the elements they name are tested. */
static int asked(int argc, char **argv, const char *name)
{
    for (int i = 1; i < argc; i++)
        if (!strcmp(argv[i], name))
            return 1;
    return argc < 2;
}

int main(int argc, char **argv)
{
    const char *seed = getenv("HOBE_TEST_SEED");
    seed = seed && *seed ? seed : "1";
    printf("HOBE_TEST_SEED=%s\n", seed);
    random_seed(seed);
    for (int i = 0; i < pw_elements(); i++) {
        struct pw_element element;
        pw_element(i, &element);
        check("published elements built in", element.name, !built_in(element.name), 0);
        if (asked(argc, argv, element.name))
            check_evaluator(&element);
    }
    for (int i = 0; hobe_kernels()[i]; i++)
        if (asked(argc, argv, hobe_kernels()[i]->name)) {
            check_kernel(hobe_kernels()[i]);
            check_curved(hobe_kernels()[i]);
            check_products(hobe_kernels()[i]);
            check_tapered(hobe_kernels()[i]);
        }
    return check_report() ? EXIT_FAILURE : EXIT_SUCCESS;
}
