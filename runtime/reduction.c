/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reduction.h"

#include "body.h"
#include "mass.h"
#include "pattern.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- fields ---------------------------------------------------------------------------------- */

/* What bodies and multipliers have in a reduced field: behind the coordinates. */
static double *behind(const struct reduction *r, double *field)
{
    return field + 3 * r->blocks;
}

static size_t behind_size(const struct reduction *r)
{
    return (size_t)(3 * (r->whole->vectors - r->whole->beam_vectors));
}

/* x[3] = sum_j J_j q_j at the k-th vector touched. */
static void expand_at(const struct reduction *r, long k, const double *q, double x[3])
{
    const double *J = r->J + 3 * k * r->n;
    for (int a = 0; a < 3; a++, J += r->n) {
        double sum = 0;
        for (long j = 0; j < r->n; j++)
            sum += J[j] * q[j];
        x[a] = sum;
    }
}

static const double *expand_touched(const struct reduction *r, const double *q,
                                    const double *centre, double *field)
{
    for (long k = 0; k < r->touched; k++) {
        double *x = field + 3 * r->vector[k];
        expand_at(r, k, q, x);
        for (int a = 0; centre && a < 3; a++)
            x[a] += centre[3 * r->vector[k] + a];
    }
    memcpy(field + 3 * r->whole->beam_vectors, q + 3 * r->blocks, behind_size(r) * sizeof *field);
    return field;
}

const double *reduction_state(const hobe_model *model, const double *u)
{
    const struct reduction *r = model->reduction;
    return expand_touched(r, u, r->of->centre, r->u);
}

const double *reduction_rates(const hobe_model *model, const double *v)
{
    const struct reduction *r = model->reduction;
    return expand_touched(r, v, NULL, r->v);
}

/* phi_j on the vectors of beams, [beam_vectors][3]. */
static const double *basis_field(const struct reduction *r, long j)
{
    return r->of->basis.field + 3 * j * r->of->model->vectors;
}

void reduction_expand(const hobe_model *model, const double *q, int state, double *field)
{
    const struct reduction *r = model->reduction;
    const long beams = 3 * r->whole->beam_vectors;
    memset(field, 0, (size_t)beams * sizeof *field);
    if (state && r->of->centre)
        memcpy(field, r->of->centre, (size_t)beams * sizeof *field);
    for (long j = 0; j < r->n; j++) {
        const double *phi = basis_field(r, j);
        for (long i = 0; i < beams; i++)
            field[i] += q[j] * phi[i];
    }
    memcpy(field + beams, q + 3 * r->blocks, behind_size(r) * sizeof *field);
}

void reduction_project(const hobe_model *model, double factor, const double *F, double *f)
{
    const struct reduction *r = model->reduction;
    const long beams = 3 * r->whole->beam_vectors;
    for (long j = 0; j < r->n; j++)
        f[j] += factor * dot(beams, basis_field(r, j), F);
    for (size_t i = 0; i < behind_size(r); i++)
        behind(r, f)[i] += factor * F[(size_t)beams + i];
}

/* ---- matrices -------------------------------------------------------------------------------- */

/* K_ij += x of scalars of the state, where the layout of K has the block. */
static void add(const hobe_model *model, const struct matrix *K, long i, long j, double x)
{
    const struct reduction *r = model->reduction;
    const long row = model->unknown[i / 3], column = model->unknown[j / 3];
    const long place =
        row < 0 || column < 0 ? -1 : r->place[K->layout][column * model->unknowns + row];
    if (place >= 0)
        K->value[place + j % 3 * model->stride[K->layout][column] + i % 3] += x;
}

/* K += dense[n][n] of the coordinates. */
static void add_dense(const hobe_model *model, const double *dense, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    for (long j = 0; j < r->n; j++)
        for (long i = 0; i < r->n; i++)
            add(model, K, i, j, dense[i * r->n + j]);
}

/* ---- items ----------------------------------------------------------------------------------- */

static void clear(const struct reduction *r, int matrix)
{
    for (long k = 0; k < r->touched; k++)
        memset(r->f + 3 * r->vector[k], 0, 3 * sizeof *r->f);
    memset(r->f + 3 * r->whole->beam_vectors, 0, behind_size(r) * sizeof *r->f);
    if (matrix)
        pattern_clear(r->whole, &r->K);
}

/* f += J'F */
static void gather_force(const struct reduction *r, double *f)
{
    const double *J = r->J;
    for (long k = 0; k < r->touched; k++)
        for (int a = 0; a < 3; a++, J += r->n) {
            const double F = r->f[3 * r->vector[k] + a];
            for (long j = 0; F != 0 && j < r->n; j++)
                f[j] += J[j] * F;
        }
    const double *F = r->f + 3 * r->whole->beam_vectors;
    for (size_t i = 0; i < behind_size(r); i++)
        behind(r, f)[i] += r->dropped[i] ? 0 : F[i];
}

/* product[3 touched][n] = K J, K the part of the vectors touched. */
static void multiply_touched(const struct reduction *r)
{
    const long m = 3 * r->whole->touched.count, rows = 3 * r->touched, n = r->n;
    memset(r->product, 0, (size_t)(rows * n) * sizeof *r->product);
    for (long s = 0; s < rows; s++)
        for (long row = 0; row < rows; row++) {
            const double k = r->K.value[s * m + row];
            for (long j = 0; k != 0 && j < n; j++)
                r->product[row * n + j] += k * r->J[s * n + j];
        }
}

/* The scalar of the reduced state that a scalar behind the touched vectors of beams is. */
static long scalar_of(const struct reduction *r, long k)
{
    return 3 * r->blocks + 3 * (r->whole->touched.vector[k / 3] - r->whole->beam_vectors) + k % 3;
}

/* K += what couples coordinates with bodies and multipliers, and these with each other. */
static void gather_behind(const hobe_model *model, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    const long m = 3 * r->whole->touched.count, rows = 3 * r->touched, n = r->n;
    for (long o = rows; o < m; o++) {
        const long to = scalar_of(r, o);
        if (r->dropped[to - 3 * r->blocks])
            continue;
        for (long j = 0; j < n; j++) {
            double below = 0, right = 0;
            for (long row = 0; row < rows; row++) {
                below += r->K.value[row * m + o] * r->J[row * n + j];
                right += r->K.value[o * m + row] * r->J[row * n + j];
            }
            add(model, K, to, j, below);
            add(model, K, j, to, right);
        }
        for (long p = rows; p < m; p++)
            if (!r->dropped[scalar_of(r, p) - 3 * r->blocks])
                add(model, K, scalar_of(r, p), to, r->K.value[o * m + p]);
    }
}

/* K += J'K J */
static void gather_tangent(const hobe_model *model, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    const long n = r->n;
    multiply_touched(r);
    memset(r->dense, 0, (size_t)(n * n) * sizeof *r->dense);
    for (long row = 0; row < 3 * r->touched; row++)
        for (long i = 0; i < n; i++) {
            const double J = r->J[row * n + i];
            for (long j = 0; J != 0 && j < n; j++)
                r->dense[i * n + j] += J * r->product[row * n + j];
        }
    add_dense(model, r->dense, K);
    gather_behind(model, K);
}

void reduction_act(const hobe_model *model, reduction_items *act, const double *u,
                   const struct instant *instant, double factor, double *f, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    if (!r) {
        act(model, u, instant, factor, f, K);
        return;
    }
    struct instant at = *instant;
    if (instant->v)
        at.v = reduction_rates(model, instant->v);
    clear(r, K != NULL);
    act(r->whole, reduction_state(model, u), &at, factor, r->f, K ? &r->K : NULL);
    gather_force(r, f);
    if (K)
        gather_tangent(model, K);
}

void reduction_spare(const hobe_model *model, const double *u, double *f, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    for (long i = r->n; i < 3 * model->vectors; i++) {
        if (i >= 3 * r->blocks && !r->dropped[i - 3 * r->blocks])
            continue;
        f[i] += u[i];
        if (K)
            add(model, K, i, i, 1);
    }
}

/* ---- elements -------------------------------------------------------------------------------- */

void reduction_elastic(const hobe_model *model, const double *u, double *f, const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    if (K) {
        pattern_clear(model, K);
        memset(r->dense, 0, (size_t)(r->n * r->n) * sizeof *r->dense);
    }
    reduced_add(r->of, u, f, K ? r->dense : NULL);
    if (K)
        add_dense(model, r->dense, K);
}

double reduction_energy(const hobe_model *model, const double *u)
{
    return reduced_energy(model->reduction->of, u);
}

double reduction_centre(const hobe_model *model)
{
    const struct reduction *r = model->reduction;
    memset(r->dense, 0, (size_t)r->n * sizeof *r->dense);
    return sqrt(2 * fmax(0, reduced_energy(r->of, r->dense)));
}

void reduction_round_off(const hobe_model *model, const double *u, double *f)
{
    const struct reduction *r = model->reduction;
    double *moved = r->dense, *at = r->dense + r->n; /* which has room for both */
    memset(f, 0, (size_t)(3 * model->vectors) * sizeof *f);
    memset(at, 0, (size_t)r->n * sizeof *at);
    for (long j = 0; j < r->n; j++)
        moved[j] = u[j] * (1 + (j % 2 ? DBL_EPSILON : -DBL_EPSILON));
    reduced_add(r->of, u, at, NULL);
    reduced_add(r->of, moved, f, NULL);
    for (long j = 0; j < r->n; j++)
        f[j] -= at[j];
}

/* ---- inertia --------------------------------------------------------------------------------- */

/* Has bodies act, which come one to one. */
static void each_body(const struct reduction *r, const double A[3][3], const double *a, double *f)
{
    const size_t beams = (size_t)(3 * r->whole->beam_vectors);
    if (r->whole->bodies.count == 0)
        return;
    memset(r->f + beams, 0, behind_size(r) * sizeof *f);
    for (size_t i = 0; i < r->whole->bodies.count; i++)
        body_mass_force(model_body(r->whole, i), A, a, r->f);
    for (size_t i = 0; i < behind_size(r); i++)
        behind(r, f)[i] += r->f[beams + i];
}

void reduction_mass_force(const hobe_model *model, const double A[3][3], const double *a, double *f)
{
    const struct reduction *r = model->reduction;
    const long n = r->n;
    const double *m = r->mass;
    for (int k = 0; k < 9; k++, m += n * n)
        for (long i = 0; A[k / 3][k % 3] != 0 && i < n; i++)
            f[i] += A[k / 3][k % 3] * dot(n, m + i * n, a);
    if (r->whole->bodies.count > 0)
        each_body(r, A, reduction_rates(model, a), f);
}

double reduction_mass_product(const hobe_model *model, const double *a, const double *b)
{
    const struct reduction *r = model->reduction;
    const long n = r->n;
    double sum = 0;
    for (int k = 0; k < 9; k += 4)
        for (long i = 0; i < n; i++)
            sum += a[i] * dot(n, r->mass + (k * n + i) * n, b);
    if (r->whole->bodies.count == 0)
        return sum;
    const double *rates = reduction_rates(model, b);
    clear(r, 0);
    for (size_t i = 0; i < r->whole->bodies.count; i++)
        body_mass_force(model_body(r->whole, i), MASS_ISOTROPIC(1), rates, r->f);
    return sum + dot((long)behind_size(r), a + 3 * r->blocks, r->f + 3 * r->whole->beam_vectors);
}

void reduction_mass_matrix(const hobe_model *model, const double A[3][3], const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    const long size = r->n * r->n;
    memset(r->dense, 0, (size_t)size * sizeof *r->dense);
    for (int k = 0; k < 9; k++)
        for (long i = 0; A[k / 3][k % 3] != 0 && i < size; i++)
            r->dense[i] += A[k / 3][k % 3] * r->mass[k * size + i];
    add_dense(model, r->dense, K);
    if (r->whole->bodies.count == 0)
        return;
    pattern_clear(r->whole, &r->K);
    for (size_t i = 0; i < r->whole->bodies.count; i++)
        body_mass_matrix(r->whole, model_body(r->whole, i), A, &r->K);
    gather_behind(model, K);
}

void reduction_arm_force(const hobe_model *model, const double A[3][3], const double o[3],
                         double *f)
{
    const struct reduction *r = model->reduction;
    const long n = r->n;
    for (int k = 0; k < 9; k++)
        for (long i = 0; i < n; i++)
            f[i] +=
                A[k / 3][k % 3] * (r->position[k * n + i] - o[k % 3] * r->weight[k / 3 * n + i]);
    each_body(r, A, r->whole->arm, f);
}

void reduction_weights(const hobe_model *model, const double g[3], double factor, double *f)
{
    const struct reduction *r = model->reduction;
    for (int a = 0; a < 3; a++)
        for (long i = 0; i < r->n; i++)
            f[i] += factor * g[a] * r->weight[a * r->n + i];
    for (size_t i = 0; i < r->whole->bodies.count; i++) {
        const struct body *body = model_body(r->whole, i);
        for (int a = 0; a < 3; a++)
            f[3 * model_number(model, body->first) + a] += factor * body->spec.mass * g[a];
    }
}

void reduction_damping(const hobe_model *model, const struct instant *instant, double *f,
                       const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    if (!r->damping)
        return;
    for (long i = 0; i < r->n; i++)
        f[i] += dot(r->n, r->damping + i * r->n, instant->v);
    for (long i = 0; K && i < r->n * r->n; i++)
        r->dense[i] = instant->rate * r->damping[i];
    if (K)
        add_dense(model, r->dense, K);
}

double reduction_damping_power(const hobe_model *model, const double *v)
{
    const struct reduction *r = model->reduction;
    double power = 0;
    for (long i = 0; r->damping && i < r->n; i++)
        power += v[i] * dot(r->n, r->damping + i * r->n, v);
    return power;
}

/* The same of bodies. */
static void add_body_momenta(const hobe_model *model, const double *u, const double *v,
                             double momentum[3], double angular[3])
{
    const struct reduction *r = model->reduction;
    const double *state = reduction_state(model, u), *rates = reduction_rates(model, v);
    clear(r, 0);
    for (size_t i = 0; i < r->whole->bodies.count; i++) {
        const struct body *body = model_body(r->whole, i);
        body_reference(body, r->all);
        body_mass_force(body, MASS_ISOTROPIC(1), rates, r->f);
        for (long k = 3 * body->first; k < 3 * (body->first + BODY_VECTORS); k += 3) {
            double couple[3], q[3];
            for (int a = 0; a < 3; a++) {
                q[a] = r->all[k + a] + state[k + a];
                momentum[a] += k == 3 * body->first ? r->f[k + a] : 0;
            }
            cross3(q, r->f + k, couple);
            for (int a = 0; a < 3; a++)
                angular[a] += couple[a];
        }
    }
}

/* moment[c][b]: sum over the mass of velocities along c times places along b. */
void reduction_momenta(const hobe_model *model, const double *u, const double *v,
                       double momentum[3], double angular[3])
{
    const struct reduction *r = model->reduction;
    const long n = r->n;
    double moment[3][3];
    for (int k = 0; k < 9; k++) {
        moment[k / 3][k % 3] = dot(n, r->position + k * n, v);
        for (long i = 0; i < n; i++)
            moment[k / 3][k % 3] += v[i] * dot(n, r->mass + (k * n + i) * n, u);
    }
    for (int c = 0; c < 3; c++) {
        const int x = (c + 1) % 3, y = (c + 2) % 3;
        momentum[c] = dot(n, r->weight + c * n, v);
        angular[c] = moment[y][x] - moment[x][y];
    }
    add_body_momenta(model, u, v, momentum, angular);
}

/* ---- motions from outside -------------------------------------------------------------------- */

/* A = L L'. */
void reduction_solve(long n, double *A, double *x)
{
    for (long j = 0; j < n; j++) {
        double *Lj = A + j * n;
        for (long k = 0; k < j; k++)
            Lj[k] = A[k * n + k] > 0 ? (Lj[k] - dot(k, Lj, A + k * n)) / A[k * n + k] : 0;
        Lj[j] = sqrt(fmax(0, Lj[j] - dot(j, Lj, Lj)));
        x[j] = Lj[j] > 0 ? (x[j] - dot(j, Lj, x)) / Lj[j] : 0;
    }
    for (long j = n; j-- > 0;) {
        for (long k = j + 1; k < n; k++)
            x[j] -= A[k * n + j] * x[k];
        x[j] = A[j * n + j] > 0 ? x[j] / A[j * n + j] : 0;
    }
}

enum hobe_status reduction_fit(const hobe_model *model, const double *v, double *q, double *left,
                               struct hobe_error *err)
{
    const struct reduction *r = model->reduction;
    const long n = r->n, size = 3 * r->whole->vectors;
    double *field = hobe_alloc((size_t)size, sizeof *field, err);
    if (!field)
        return HOBE_NO_MEMORY;
    memset(q, 0, (size_t)(3 * model->vectors) * sizeof *q);
    mass_force(r->whole, 1, v, field);
    reduction_project(model, 1, field, q);
    memcpy(behind(r, q), v + 3 * r->whole->beam_vectors, behind_size(r) * sizeof *q);
    for (long i = 0; i < n * n; i++)
        r->dense[i] = r->mass[i] + r->mass[4 * n * n + i] + r->mass[8 * n * n + i];
    reduction_solve(n, r->dense, q);
    reduction_expand(model, q, 0, field);
    for (long i = 0; i < size; i++)
        field[i] -= v[i];
    const double all = mass_product(r->whole, v, v);
    *left = all > 0 ? sqrt(fmax(0, mass_product(r->whole, field, field)) / all) : 0;
    hobe_free(field);
    return HOBE_OK;
}

enum hobe_status reduction_check_motion(const hobe_model *model, struct hobe_error *err)
{
    const hobe_model *whole = model->reduction->whole;
    for (size_t i = 0; i < whole->beams.count; i++) {
        const struct beam *beam = model_beam(whole, i);
        if (beam->spec.damping.stiffness > 0)
            return hobe_fail(err, HOBE_BAD_INPUT, beam->spec.where,
                             "damping.stiffness of beam \"%s\" is not in the reduced model's "
                             "energy; use damping.mass, or the whole model",
                             beam->name);
    }
    return HOBE_OK;
}

/* ---- scale ----------------------------------------------------------------------------------- */

/* Fields of a basis are normal in the stiffness and, for rigid motions, a billionth of its
 * diagonal: what is stiff by less than this share of the stiffest is so by rounding. */
static const double SOFTEST = 1e-3;

static void limit_coordinates(const struct reduction *r, double *scale)
{
    double least = INFINITY;
    for (long j = 0; j < r->n; j++)
        least = scale[j] > 0 ? fmin(least, scale[j]) : least;
    const double most = isfinite(least) ? least / sqrt(SOFTEST) : 1;
    for (long j = 0; j < r->n; j++)
        scale[j] = scale[j] > 0 ? fmin(scale[j], most) : most;
}

/* What D = diag^(-1/2) of the coordinates lets the vectors touched move by: D^2 = sum_j J_j^2
 * D_j^2. */
void reduction_scale(const hobe_model *model, double *scale)
{
    const struct reduction *r = model->reduction;
    const hobe_model *whole = r->whole;
    limit_coordinates(r, scale);
    if (whole->bodies.count == 0)
        return;
    for (long k = 0; k < 3 * r->touched; k++) {
        double sum = 0;
        for (long j = 0; j < r->n; j++)
            sum += pow(r->J[k * r->n + j] * scale[j], 2);
        r->scale[3 * whole->unknown[r->vector[k / 3]] + k % 3] = sqrt(sum);
    }
    for (int back = 0; back < 2; back++) {
        for (long v = whole->beam_vectors; v < whole->vectors; v++) {
            const long from = model->unknown[model_number(model, v)];
            for (int a = 0; a < 3 && from >= 0; a++) {
                double *there = r->scale + 3 * whole->unknown[v] + a;
                double *here = scale + 3 * from + a;
                *(back ? here : there) = *(back ? there : here);
            }
        }
        if (!back)
            body_scale(whole, r->scale);
    }
}

/* ---- memory ---------------------------------------------------------------------------------- */

/* products[k][j] = phi_i,a' F_b with k = 3 a + b, for all i. */
static void project_parts(const struct reduction *r, const double *F, long i_step, double *products)
{
    for (long i = 0; i < r->n; i++) {
        const double *phi = basis_field(r, i);
        double sum[9] = {0};
        for (long v = 0; v < r->whole->beam_vectors; v++)
            for (int k = 0; k < 9; k++)
                sum[k] += phi[3 * v + k / 3] * F[3 * v + k % 3];
        for (int k = 0; k < 9; k++)
            products[(k * r->n + i) * i_step] = sum[k];
    }
}

/* The inertia of beams and of the masses at them, projected. */
static enum hobe_status weigh(struct reduction *r, struct hobe_error *err)
{
    const hobe_model *whole = r->whole;
    const long n = r->n, beams = 3 * whole->beam_vectors;
    const size_t size = (size_t)(3 * whole->vectors);
    double *F = hobe_alloc(size, sizeof *F, err), *part = hobe_alloc(9 * (size_t)n, sizeof *F, err);
    for (long j = 0; F && part && j < n + 2; j++) { /* the fields, the centre, a translation */
        memset(F, 0, size * sizeof *F);
        memset(r->all, 0, size * sizeof *F);
        if (j < n)
            memcpy(r->all, basis_field(r, j), (size_t)beams * sizeof *F);
        else if (j == n)
            model_reference(whole, r->all);
        else
            mass_translation(whole, 0, r->all);
        for (long i = 0; j == n && r->of->centre && i < beams; i++)
            r->all[i] += r->of->centre[i];
        mass_force(whole, 1, r->all, F);
        project_parts(r, F, j < n ? n : 1, j < n ? r->mass + j : j == n ? r->position : part);
    }
    for (int a = 0; F && part && a < 3; a++)
        memcpy(r->weight + a * n, part + 3 * a * n, (size_t)n * sizeof *part);
    hobe_free(F);
    hobe_free(part);
    return F && part ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The damping that holds back masses, where there is some. */
static enum hobe_status damp(struct reduction *r, struct hobe_error *err)
{
    const hobe_model *whole = r->whole;
    const size_t size = (size_t)(3 * whole->vectors), n = (size_t)r->n;
    int damped = 0;
    for (size_t b = 0; b < whole->beams.count; b++)
        damped |= model_beam(whole, b)->spec.damping.mass > 0;
    if (!damped)
        return HOBE_OK;
    r->damping = hobe_alloc(n * n, sizeof *r->damping, err);
    double *F = hobe_alloc(size, sizeof *F, err);
    for (long j = 0; r->damping && F && j < r->n; j++) {
        memset(F, 0, size * sizeof *F);
        for (size_t b = 0; b < whole->beams.count; b++)
            mass_force_of(whole, model_beam(whole, b), model_beam(whole, b)->spec.damping.mass,
                          basis_field(r, j), F);
        for (long i = 0; i < r->n; i++)
            r->damping[i * r->n + j] = dot(3 * whole->beam_vectors, basis_field(r, i), F);
    }
    hobe_free(F);
    return r->damping && F ? HOBE_OK : HOBE_NO_MEMORY;
}

/* The basis where items act. */
static enum hobe_status touch(struct reduction *r, struct hobe_error *err)
{
    const struct touched *t = &r->whole->touched;
    enum hobe_status status = pattern_touch(r->whole, err);
    if (!status)
        status = pattern_matrix(r->whole, TOUCHED, &r->K, err);
    while (!status && r->touched < t->count && t->vector[r->touched] < r->whole->beam_vectors)
        r->touched++;
    const size_t rows = 3 * (size_t)r->touched, n = (size_t)r->n;
    r->vector = t->vector;
    r->J = status ? NULL : hobe_alloc(rows * n, sizeof *r->J, err);
    r->product = status ? NULL : hobe_alloc(rows * n, sizeof *r->product, err);
    for (size_t k = 0; r->J && k < rows; k++)
        for (long j = 0; j < r->n; j++)
            r->J[k * n + (size_t)j] = basis_field(r, j)[3 * r->vector[k / 3] + (long)k % 3];
    return status ? status : r->J && r->product ? HOBE_OK : HOBE_NO_MEMORY;
}

static enum hobe_status allocate(struct reduction *r, struct hobe_error *err)
{
    const size_t n = (size_t)r->n, size = (size_t)(3 * r->whole->vectors);
    r->mass = hobe_alloc(9 * n * n, sizeof *r->mass, err);
    r->position = hobe_alloc(9 * n, sizeof *r->position, err);
    r->weight = hobe_alloc(3 * n, sizeof *r->weight, err);
    r->u = hobe_alloc(size, sizeof *r->u, err);
    r->v = hobe_alloc(size, sizeof *r->v, err);
    r->f = hobe_alloc(size, sizeof *r->f, err);
    r->all = hobe_alloc(size, sizeof *r->all, err);
    r->dense = hobe_alloc(n * n + n, sizeof *r->dense, err);
    r->scale = hobe_alloc((size_t)(3 * r->whole->unknowns), sizeof *r->scale, err);
    return r->mass && r->position && r->weight && r->u && r->v && r->f && r->all && r->dense &&
                   r->scale
               ? HOBE_OK
               : HOBE_NO_MEMORY;
}

/* The state q = 0 at the vectors touched. */
static const double *reference(const struct reduction *r)
{
    for (long k = 0; r->of->centre && k < r->touched; k++)
        memcpy(r->u + 3 * r->vector[k], r->of->centre + 3 * r->vector[k], 3 * sizeof *r->u);
    return r->u;
}

struct reduction *reduction_open(const struct hobe_reduced *of, hobe_model *whole,
                                 struct hobe_error *err)
{
    struct reduction *r = hobe_alloc(1, sizeof *r, err);
    if (!r)
        return NULL;
    *r = (struct reduction){
        .of = of, .whole = whole, .n = of->basis.n, .blocks = (of->basis.n + 2) / 3};
    if (!allocate(r, err) && !touch(r, err) && !reduction_drop(r, reference(r), err) &&
        !weigh(r, err) && !damp(r, err))
        return r;
    reduction_free(r);
    return NULL;
}

void reduction_free(struct reduction *r)
{
    if (!r)
        return;
    double *const memory[] = {r->J, r->mass, r->damping, r->position, r->weight, r->u,    r->v,
                              r->f, r->all,  r->K.value, r->product,  r->dense,  r->scale};
    for (size_t i = 0; i < sizeof memory / sizeof *memory; i++)
        hobe_free(memory[i]);
    hobe_free(r->dropped);
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(r->place[layout]);
    hobe_free(r);
}
