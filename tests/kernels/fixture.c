/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fixture.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FUNCTION_DEGREE = 3 }; /* of test_functions, in y and in z */

static const char *const law_name[PW_LAWS] = {"axis", "average", "full", "mean shear",
                                              "structural"};

void *grab(size_t count, size_t size)
{
    size_t bytes = (count * size + 63) / 64 * 64;
    void *p = aligned_alloc(64, bytes ? bytes : 64);
    if (!p) {
        fprintf(stderr, "out of memory\n");
        exit(2);
    }
    memset(p, 0xff, bytes); /* all bits set: a NaN as double, and as long double */
    return p;
}

const char *where(const struct fixture *fx, int lane)
{
    static char text[80];
    int n = snprintf(text, sizeof text, "%s/%s", fx->kernel->name, law_name[fx->beam.mechanics]);
    if (lane >= 0)
        snprintf(text + n, sizeof text - (size_t)n, " lane %d", lane);
    return text;
}

/* ---- random numbers and rotations ----------------------------------------------------------- */

static uint64_t random_state;

void random_seed(const char *text)
{
    random_state = 14695981039346656037u; /* FNV-1a */
    for (; *text; text++)
        random_state = (random_state ^ (unsigned char)*text) * 1099511628211u;
}

/* splitmix64 */
real random_real(real from, real to)
{
    uint64_t x = random_state += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    x ^= x >> 31;
    return from + (to - from) * ((real)(x >> 11) * 0x1p-53L);
}

void random_rotation(real *R)
{
    real q[4], norm;
    do { /* a point of the unit ball, then of the sphere: a uniform quaternion */
        norm = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = random_real(-1, 1);
            norm += q[i] * q[i];
        }
    } while (norm > 1 || norm < 0.01L);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        real a = q[i], b = q[j], c = q[k], w = q[3];
        R[4 * i] = (w * w + a * a - b * b - c * c) / norm;
        R[3 * i + j] = 2 * (a * b - w * c) / norm;
        R[3 * i + k] = 2 * (a * c + w * b) / norm;
    }
}

/* ---- section, law, invariants --------------------------------------------------------------- */

/* Odd in y and z like the warping function of a rectangle; the others are anything. */
static void test_function(int i, real y, real z, real w[3])
{
    const real a = 800 + 100 * i, b = 500 - 60 * i, c = 0.3L * i;
    w[0] = y * z * (1 + a * y * y - b * z * z) + c * y * (y * y + z * z);
    w[1] = z * (1 + 3 * a * y * y - b * z * z) + c * (3 * y * y + z * z);
    w[2] = y * (1 + a * y * y - 3 * b * z * z) + c * 2 * y * z;
}

static void warping(real y, real z, real w[3])
{
    test_function(0, y, z, w);
}

void test_functions(double y, double z, double (*f)[4])
{
    for (int i = 0; i < HOBE_MAX_FUNCTIONS; i++) {
        real w[3];
        test_function(i, y, z, w);
        for (int d = 0; d < 3; d++)
            f[i][d] = (double)w[d];
        f[i][3] = 0;
    }
}

static void set(real w[3], real f, real fy, real fz)
{
    w[0] = f;
    w[1] = fy;
    w[2] = fz;
}

/* Those of a section that is its own mirror image: w and the like are odd in y and in z, the others
 * in one of them or in none. */
static void symmetric_functions(const struct hobe_kernel *kernel, double y, double z,
                                double (*f)[4])
{
    static const char *const odd_in_y[] = {"wy", "v1z", "v2y", "v3y"};
    static const char *const odd_in_z[] = {"wz", "v1y", "v2z", "v3z"};
    static const char *const even[] = {"w2", "w3"};
    for (int i = 0; i < kernel->functions; i++) {
        real w[3];
        test_function(0, y, z, w);
        set(w, w[0] + 100 * i * y * y * y * z, w[1] + 300 * i * y * y * z,
            w[2] + 100 * i * y * y * y);
        for (int n = 0; n < 4; n++) {
            if (n < 2 && !strcmp(kernel->function[i], even[n]))
                set(w, y * y + i * z * z, 2 * y, 2 * i * z);
            if (!strcmp(kernel->function[i], odd_in_y[n]))
                set(w, y * y * y + i * y * z * z, 3 * y * y + i * z * z, 2 * i * y * z);
            if (!strcmp(kernel->function[i], odd_in_z[n]))
                set(w, z * z * z + i * z * y * y, 2 * i * y * z, 3 * z * z + i * y * y);
        }
        for (int d = 0; d < 3; d++)
            f[i][d] = (double)w[d];
    }
}

/* One Gauss point more in each direction than the evaluator has: both are exact, and no two points
 * coincide; but the evaluator's where the reference is curved and neither is exact. */
static void set_section(struct fixture *fx)
{
    int degree = fx->kernel->degree, n;
    real x[PW_GAUSS], w[PW_GAUSS];
    if (fx->kernel->functions && degree < FUNCTION_DEGREE)
        degree = FUNCTION_DEGREE;
    n = 2 * degree + 2 < PW_GAUSS && !fx->curved ? 2 * degree + 2 : 2 * degree + 1;
    pw_gauss(n, x, w);
    fx->point = grab((size_t)(n * n), sizeof *fx->point);
    for (int p = 0; p < n * n; p++) {
        struct hobe_section_point *point = &fx->point[p];
        point->y = (double)(fx->beam.y + fx->beam.width * (x[p / n] - 0.5L));
        point->z = (double)(fx->beam.z + fx->beam.height * (x[p % n] - 0.5L));
        point->weight = (double)(fx->beam.width * fx->beam.height * w[p / n] * w[p % n]);
        point->region = 0;
        test_functions(point->y, point->z, point->f);
        if (fx->symmetry & (HOBE_SYMMETRIC_Y | HOBE_SYMMETRIC_Z))
            symmetric_functions(fx->kernel, point->y, point->z, point->f);
    }
    fx->axis = (struct hobe_section_point){.weight = 0.37}; /* a mean: any weight will do */
    test_functions(0, 0, fx->axis.f);
    fx->rule = (struct hobe_section_rule){n * n, fx->point};
    fx->mean = fx->beam.mechanics == PW_AXIS ? (struct hobe_section_rule){1, &fx->axis} : fx->rule;
}

static void set_law(struct fixture *fx)
{
    const double E = (double)fx->beam.E, nu = (double)fx->beam.nu, G = E / 2 / (1 + nu);
    const double k2 = (double)fx->beam.k2, k3 = (double)fx->beam.k3;
    const double lambda = 2 * G * nu / (1 - 2 * nu);
    const int full = fx->beam.mechanics == PW_FULL, mean = fx->beam.mechanics == PW_MEAN_SHEAR;
    const int split = !full && fx->beam.mechanics != PW_STRUCTURAL;
    struct hobe_elasticity *law = &fx->law;
    memset(&fx->mean_law, 0, sizeof fx->mean_law);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double solid = lambda + (i == j ? 2 * G : 0), rod = i == j ? E : 0;
            law->normal[i][j] = full ? solid : rod;
            fx->mean_law.normal[i][j] = split ? solid - rod : 0;
        }
    const double shear[3] = {G, mean ? G : k2 * G, mean ? G : k3 * G};
    const double mean_shear[3] = {0, mean ? (k2 - 1) * G : 0, mean ? (k3 - 1) * G : 0};
    memcpy(law->shear, shear, sizeof shear);
    memcpy(fx->mean_law.shear, mean_shear, sizeof mean_shear);
}

void grow_functions(const struct fixture *fx, double xi, double (*f)[4])
{
    for (int i = 0; i < HOBE_MAX_FUNCTIONS; i++) {
        f[i][3] = (double)(fx->beam.taper / fx->beam.length) * f[i][0];
        for (int d = 0; d < 3; d++)
            f[i][d] *= 1 + (double)fx->beam.taper * xi;
    }
}

/* The section rule at xi. */
static struct hobe_section_rule rule_at(const struct fixture *fx,
                                        const struct hobe_section_rule *rule, double xi)
{
    struct hobe_section_point *point = grab((size_t)rule->points, sizeof *point);
    memcpy(point, rule->point, (size_t)rule->points * sizeof *point);
    for (int p = 0; p < rule->points; p++)
        grow_functions(fx, xi, point[p].f);
    return (struct hobe_section_rule){rule->points, point};
}

/* What the fixture is made of, as kernel->invariants takes it. */
struct input {
    struct hobe_law law;
    struct hobe_station station[PW_GAUSS];
    double q0[PW_DOFS];
    int sections;
};

static void open_input(const struct fixture *fx, int stations, const double (*gauss)[2],
                       struct input *in)
{
    const int relieved = fx->beam.mechanics == PW_AVERAGE || fx->beam.mechanics == PW_MEAN_SHEAR;
    in->law = (struct hobe_law){1, &fx->law, &fx->density, fx->mean_law, relieved};
    in->sections = fx->curved ? stations : 1;
    for (int s = 0; s < in->sections; s++) {
        struct hobe_station *station = in->station + s;
        *station = (struct hobe_station){
            fx->rule,
            fx->mean,
            fx->mean,
            (double)fx->beam.J,
            {(double)fx->beam.ys, (double)fx->beam.zs},
        };
        if (!fx->curved)
            continue;
        station->rule = rule_at(fx, &fx->rule, gauss[s][0]);
        station->mean_normal = rule_at(fx, &fx->mean, gauss[s][0]);
        station->mean_shear = station->mean_normal;
    }
    for (int i = 0; fx->curved && i < fx->dofs; i++)
        in->q0[i] = (double)fx->curved[i];
}

static void close_input(const struct fixture *fx, struct input *in)
{
    for (int s = 0; fx->curved && s < in->sections; s++) {
        free((void *)in->station[s].rule.point);
        free((void *)in->station[s].mean_normal.point);
    }
}

static void fill(const struct fixture *fx, const double (*gauss)[2], struct hobe_invariants *inv)
{
    struct input in;
    open_input(fx, inv->stations, gauss, &in);
    fx->kernel->invariants(inv, gauss, in.sections, in.station, &in.law, fx->curved ? in.q0 : NULL);
    close_input(fx, &in);
}

void fixture_take_points(struct fixture *fx)
{
    struct input in;
    struct hobe_error err;
    double gauss[PW_GAUSS][2];
    for (int s = 0; s < fx->inv.stations; s++)
        gauss[s][0] = fx->inv.xi[s];
    open_input(fx, fx->inv.stations, (const double(*)[2])gauss, &in);
    fx->points = grab(1, sizeof *fx->points);
    if (points_open(fx->points, fx->kernel, &fx->inv, in.sections, in.station, &in.law,
                    fx->curved ? in.q0 : NULL, &err)) {
        fprintf(stderr, "%s\n", err.message);
        exit(2);
    }
    close_input(fx, &in);
}

void fixture_drop_points(struct fixture *fx)
{
    points_close(fx->points);
    free(fx->points);
    fx->points = NULL;
}

void set_section_plan(const struct hobe_kernel *kernel, int symmetry, struct hobe_invariants *inv)
{
    const size_t block = kernel->section_cost[symmetry].numbers, stations = (size_t)inv->stations;
    inv->symmetry = symmetry;
    inv->step = inv->step_n ? (ptrdiff_t)block : 0;
    inv->section =
        grab(stations * kernel->axial + (inv->step ? stations : 1) * block, sizeof(double));
    kernel->section(inv);
}

void make_invariants(const struct fixture *fx, int stations, int blocks,
                     struct hobe_invariants *inv)
{
    const struct hobe_kernel *k = fx->kernel;
    const size_t rows = (size_t)(stations * k->vectors), copies = (size_t)blocks;
    const size_t nn = (size_t)(k->normals * k->normals), ns = (size_t)(k->shears * k->shears);
    real x[PW_GAUSS], w[PW_GAUSS];
    double gauss[PW_GAUSS][2];
    memset(inv, 0, sizeof *inv);
    inv->length = (double)fx->beam.length;
    inv->stations = stations;
    inv->xi = grab((size_t)stations, sizeof(double));
    inv->wx = grab((size_t)stations, sizeof(double));
    inv->N = grab(rows, sizeof(double));
    inv->Nx = grab(rows, sizeof(double));
    inv->Qn = grab(copies * nn, sizeof(double));
    inv->Qs = grab(copies * ns, sizeof(double));
    inv->Qc = fx->curved ? grab((size_t)(stations * k->normals * k->shears), sizeof(double)) : NULL;
    inv->mass = grab((size_t)(k->vectors * k->vectors), sizeof(double));
    pw_gauss(stations, x, w);
    for (int s = 0; s < stations; s++) {
        gauss[s][0] = k->axis_rule ? k->axis_rule[s][0] : (double)x[s];
        gauss[s][1] = k->axis_rule ? k->axis_rule[s][1] : (double)w[s];
    }
    fill(fx, (const double(*)[2])gauss, inv);
    for (int s = 1; !fx->curved && s < blocks; s++) {
        memcpy(inv->Qn + (size_t)s * nn, inv->Qn, nn * sizeof(double));
        memcpy(inv->Qs + (size_t)s * ns, inv->Qs, ns * sizeof(double));
    }
    if (!fx->curved) {
        inv->step_n = blocks > 1 ? (ptrdiff_t)nn : 0;
        inv->step_s = blocks > 1 ? (ptrdiff_t)ns : 0;
    }
    if (k->section)
        set_section_plan(k, k->symmetry(inv), inv);
}

void free_invariants(struct hobe_invariants *inv)
{
    free(inv->xi);
    free(inv->wx);
    free(inv->N);
    free(inv->Nx);
    free(inv->Qn);
    free(inv->Qs);
    free(inv->Qc);
    free(inv->mass);
    free(inv->section);
    free(inv->tensor);
}

/* The largest slope of each mode over the section decides the size of its vectors: a vector of size
 * 1/slope tilts a fibre by about 1. */
static void set_sizes(struct fixture *fx)
{
    const struct hobe_kernel *k = fx->kernel;
    real slope[HOBE_MAX_MODES] = {0};
    for (int p = 0; p < fx->rule.points; p++) {
        double phi[HOBE_MAX_MODES][4];
        const struct hobe_section_point *point = &fx->point[p];
        k->section_modes(point->y, point->z, (const double(*)[4])point->f, phi);
        for (int m = 0; m < k->modes; m++)
            slope[m] = fmaxl(slope[m], hypotl(phi[m][1], phi[m][2]));
    }
    fx->size = grab((size_t)fx->dofs, sizeof(real));
    for (int i = 0; i < fx->dofs; i++) {
        const struct hobe_vector *v = &k->vector[i / 3];
        real size = v->mode == 0 ? fx->beam.length : 1 / slope[v->mode];
        fx->size[i] = v->slope ? size / fx->beam.length : size;
    }
}

/* A reference distorted by up to `scale`: its vectors tilt and stretch by that. */
static void set_reference(struct fixture *fx, real scale)
{
    real *X = grab((size_t)fx->dofs, sizeof *X);
    real *u = grab((size_t)fx->dofs, sizeof *u);
    reference(fx, X);
    random_vectors(fx, scale, u);
    for (int i = 0; i < fx->dofs; i++)
        X[i] += u[i];
    free(u);
    fx->curved = X;
    fx->beam.reference = X;
}

static void open_fixture(struct fixture *fx, const struct hobe_kernel *kernel,
                         enum pw_mechanics mechanics, int curved, int symmetry)
{
    memset(fx, 0, sizeof *fx);
    fx->symmetry = symmetry;
    fx->kernel = kernel;
    fx->dofs = 3 * kernel->vectors;
    fx->structural = !strcmp(kernel->mechanics, "structural");
    fx->known = pw_find(kernel->name, &fx->beam.element);
    fx->density = 2700;
    fx->beam.length = 0.4L;
    fx->beam.width = 0.03L;
    fx->beam.height = 0.05L;
    /* off the axis, so that no moment vanishes but by the symmetry asked for */
    fx->beam.y = symmetry & HOBE_SYMMETRIC_Y ? 0 : 0.004L;
    fx->beam.z = symmetry & HOBE_SYMMETRIC_Z ? 0 : -0.003L;
    fx->beam.E = 70e9L;
    fx->beam.nu = 0.3L;
    fx->beam.k2 = 0.85L;
    fx->beam.k3 = 0.7L;
    fx->beam.J = 3e-7L; /* near the true one; a shear centre far from the centroid */
    fx->beam.ys = -0.006L;
    fx->beam.zs = 0.009L;
    fx->beam.mechanics = mechanics;
    fx->beam.warping = warping;
    fx->beam.warping_degree = FUNCTION_DEGREE;
    set_section(fx);
    set_law(fx);
    set_sizes(fx);
    if (curved) {
        free(fx->point);
        fx->beam.taper = 0.4L;
        set_reference(fx, symmetry ? 0 : 0.05L);
        set_section(fx);
    }
    make_invariants(fx, kernel->stations, curved ? kernel->stations : 1, &fx->inv);
}

void fixture_open(struct fixture *fx, const struct hobe_kernel *kernel, enum pw_mechanics mechanics)
{
    open_fixture(fx, kernel, mechanics, 0, HOBE_SYMMETRIC_X);
}

void fixture_open_curved(struct fixture *fx, const struct hobe_kernel *kernel,
                         enum pw_mechanics mechanics)
{
    open_fixture(fx, kernel, mechanics, 1, 0);
}

void fixture_open_tapered(struct fixture *fx, const struct hobe_kernel *kernel,
                          enum pw_mechanics mechanics, int symmetry)
{
    open_fixture(fx, kernel, mechanics, 1, symmetry);
}

void fixture_open_symmetric(struct fixture *fx, const struct hobe_kernel *kernel,
                            enum pw_mechanics mechanics, int symmetry)
{
    open_fixture(fx, kernel, mechanics, 0, symmetry);
}

void fixture_set_plans(struct fixture *fx, int symmetry)
{
    const struct hobe_kernel *k = fx->kernel;
    free(fx->inv.tensor);
    free(fx->inv.section);
    set_section_plan(k, symmetry, &fx->inv);
    fx->inv.tensor = NULL;
    if (!(symmetry & HOBE_SYMMETRIC_X))
        return;
    fx->inv.tensor = grab(k->tensor_cost[symmetry].numbers, sizeof(double));
    k->tensor(&fx->inv);
}

void fixture_close(struct fixture *fx)
{
    free_invariants(&fx->inv);
    free(fx->point);
    free(fx->size);
    free(fx->curved);
}
