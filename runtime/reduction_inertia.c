/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Inertia and damping on the coordinates of a basis, and motions in them. */
#include "body.h"
#include "mass.h"
#include "pattern.h"
#include "reduction_parts.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

/* Has bodies act, which come one to one. */
static void each_body(const struct reduction *r, const double A[3][3], const double *a, double *f)
{
    const size_t beams = (size_t)(3 * r->whole->beam_vectors);
    if (r->whole->bodies.count == 0)
        return;
    memset(r->f + beams, 0, reduction_behind_size(r) * sizeof *f);
    for (size_t i = 0; i < r->whole->bodies.count; i++)
        body_mass_force(model_body(r->whole, i), A, a, r->f);
    for (size_t i = 0; i < reduction_behind_size(r); i++)
        reduction_behind(r, f)[i] += r->f[beams + i];
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
    reduction_clear(r, 0);
    for (size_t i = 0; i < r->whole->bodies.count; i++)
        body_mass_force(model_body(r->whole, i), MASS_ISOTROPIC(1), rates, r->f);
    return sum + dot((long)reduction_behind_size(r), a + 3 * r->blocks,
                     r->f + 3 * r->whole->beam_vectors);
}

void reduction_mass_matrix(const hobe_model *model, const double A[3][3], const struct matrix *K)
{
    const struct reduction *r = model->reduction;
    const long size = r->n * r->n;
    memset(r->dense, 0, (size_t)size * sizeof *r->dense);
    for (int k = 0; k < 9; k++)
        for (long i = 0; A[k / 3][k % 3] != 0 && i < size; i++)
            r->dense[i] += A[k / 3][k % 3] * r->mass[k * size + i];
    reduction_add_dense(model, r->dense, K);
    if (r->whole->bodies.count == 0)
        return;
    pattern_clear(r->whole, &r->K);
    for (size_t i = 0; i < r->whole->bodies.count; i++)
        body_mass_matrix(r->whole, model_body(r->whole, i), A, &r->K);
    reduction_gather_behind(model, K);
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
        reduction_add_dense(model, r->dense, K);
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
    reduction_clear(r, 0);
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
    memcpy(reduction_behind(r, q), v + 3 * r->whole->beam_vectors,
           reduction_behind_size(r) * sizeof *q);
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
