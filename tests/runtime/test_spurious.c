/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motions that strain no Gauss point: how many the paper's 3 x 3 x 3 points leave to each element,
 * beside the rank of its strains there.  Of a straight element of a rectangle the fields are
 *
 *     u(x,y,z) = sum over modes k of phi_k(y,z) p_k(x),  p_k any polynomial of degree < V_k,
 *
 * V_k nodal vectors of the mode, whichever functions the element has them in; and stretching the
 * axes of the element, and displacements inversely, keeps the motions without strain, so that the
 * points of the cube [-1, 1]^3 do.  Those of an element are the null space of its stiffness: E0 is
 * positive definite, and the part of Poisson's ratio sees the strains of the same points. */
#include "check.h"
#include "kernel.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 3, ROWS = 6 * POINTS * POINTS * POINTS, MAX_COLUMNS = 3 * 64 };

static const double E = 210e9, NU = 0.3;

/* A column of the strains at all points, of one coordinate's motion; and how many. */
static double column[MAX_COLUMNS][ROWS];
static int columns;

/* ---- the strains ----------------------------------------------------------------------------- */

/* y^a z^b and its derivatives. */
static void monomial(int a, int b, double y, double z, double f[3])
{
    f[0] = pow(y, a) * pow(z, b);
    f[1] = a ? a * pow(y, a - 1) * pow(z, b) : 0;
    f[2] = b ? b * pow(y, a) * pow(z, b - 1) : 0;
}

/* A mode and its derivatives.  In place of w and of the cubics wy, wz of bending shear, some that
 * are odd and even as they are: the rank does not depend on which.  0 where a rectangle has it
 * not, as the modes of distortion. */
static int evaluate(const char *mode, double y, double z, double f[3])
{
    static const double SINH = 0.7; /* eq. 33 has one term like this */
    if (!strcmp(mode, "w")) {
        f[0] = y * z - SINH * sin(z) * sinh(y);
        f[1] = z - SINH * sin(z) * cosh(y);
        f[2] = y - SINH * cos(z) * sinh(y);
        return 1;
    }
    int a = 0, b = 0;
    for (const char *c = mode; *c; c++) {
        a += *c == 'y';
        b += *c == 'z';
    }
    if (mode[0] == 'v' || (mode[0] == 'w' && a + b == 0))
        return 0;
    monomial(mode[0] == 'w' ? 3 * a : a, mode[0] == 'w' ? 3 * b : b, y, z, f);
    return 1;
}

/* Adds the strains of the motions x^p phi_k along the three axes. */
static int add_columns(const char *mode, int p)
{
    const double abscissa[POINTS] = {-sqrt(0.6), 0, sqrt(0.6)};
    double f[3];
    for (int at = 0; at < POINTS * POINTS * POINTS; at++) {
        const double x = abscissa[at / 9];
        if (!evaluate(mode, abscissa[at / 3 % 3], abscissa[at % 3], f))
            return 0;
        const double gradient[3] = {p ? p * pow(x, p - 1) * f[0] : 0, pow(x, p) * f[1],
                                    pow(x, p) * f[2]};
        for (int c = 0; c < 3; c++) {
            double *e = &column[columns + c][6 * at]; /* xx, yy, zz, 2yz, 2xz, 2xy */
            memset(e, 0, 6 * sizeof *e);
            e[c] = gradient[c];
            for (int other = 0; other < 3; other++)
                if (other != c)
                    e[6 - c - other] = gradient[other];
        }
    }
    columns += 3;
    return 1;
}

/* The rank of the columns: Gram and Schmidt, the longest first, twice each. */
static int rank(void)
{
    int found = 0;
    for (; found < columns; found++) {
        int longest = found;
        double most = 0;
        for (int j = found; j < columns; j++) {
            double square = 0;
            for (int pass = 0; pass < 2 * found; pass++) {
                const double *q = column[pass % found];
                double product = 0;
                for (int i = 0; i < ROWS; i++)
                    product += q[i] * column[j][i];
                for (int i = 0; i < ROWS; i++)
                    column[j][i] -= product * q[i];
            }
            for (int i = 0; i < ROWS; i++)
                square += column[j][i] * column[j][i];
            if (square > most) {
                most = square;
                longest = j;
            }
        }
        if (most < 1e-20) /* strains are of the order of 1, and rounding leaves 1e-15 of those */
            break;
        for (int i = 0; i < ROWS; i++) {
            const double x = column[longest][i] / sqrt(most);
            column[longest][i] = column[found][i];
            column[found][i] = x;
        }
    }
    return found;
}

/* ---- the elements ---------------------------------------------------------------------------- */

/* The motions that strain none of the points. */
static int expected(const struct hobe_kernel *kernel)
{
    int vectors[MAX_COLUMNS] = {0};
    columns = 0;
    for (int v = 0; v < kernel->vectors; v++)
        add_columns(kernel->mode[kernel->vector[v].mode], vectors[kernel->vector[v].mode]++);
    const int all = columns;
    return all - rank();
}

static void try_element(const struct hobe_kernel *kernel, enum hobe_mechanics mechanics, int zero)
{
    const double width = random_real(0.05, 0.2), height = random_real(0.05, 0.2);
    hobe_section *section = rectangle(width, height);
    const struct hobe_element_options options = {
        .kernel = kernel,
        .section = section,
        .material = {.E = E, .nu = NU, .k2 = 1, .k3 = 1},
        .length = random_real(1, 4) * fmax(width, height),
        .mechanics = mechanics,
        .integration = HOBE_INTEGRATION_PAPER,
    };
    struct hobe_error err;
    struct hobe_rest rest = {0};
    hobe_element *element = hobe_element_new(&options, &err);
    if (element) {
        hobe_element_rest(element, &rest);
        check_that(rest.zero == zero, "%s, %s, %g x %g: %d motions without energy, %d expected",
                   kernel->name, hobe_mechanics_name(mechanics), width, height, rest.zero, zero);
    } else
        check_that(mechanics == HOBE_MECHANICS_AXIS && err.status == HOBE_UNSTABLE, "%s: %s",
                   kernel->name, err.message);
    hobe_element_free(element);
    hobe_section_free(section);
}

int main(void)
{
    random_start();
    int most = 0;
    for (int k = 0; hobe_kernels()[k]; k++) {
        const struct hobe_kernel *kernel = hobe_kernels()[k];
        if (!strcmp(kernel->mechanics, "structural")) /* which does not take the paper's points */
            continue;
        const int zero = expected(kernel);
        printf("%-10s %3d unknowns, %2d motions without energy\n", kernel->name,
               3 * kernel->vectors, zero);
        most = zero > most ? zero : most;
        for (int m = HOBE_MECHANICS_AVERAGE; m < HOBE_MECHANICS_STRUCTURAL; m++)
            try_element(kernel, (enum hobe_mechanics)m, zero);
    }
    check_that(most == 14, "eight more than rigid motions at most");
    return check_report();
}
