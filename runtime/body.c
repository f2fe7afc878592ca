/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "body.h"

#include "constraint.h"
#include "eigen.h"
#include "pattern.h"
#include "reduction.h"
#include "vector3.h"

#include <stdio.h>
#include <string.h>

/* ---- inertia --------------------------------------------------------------------------------- */

/* Rounding of inertias that are given: what a plane figure's may lack, and a line's has. */
static const double ROUNDING = 1e-12;

static double square(double x)
{
    return x * x;
}

/* Volume, m^3, and int x_i^2 dV/V = j[3], m^2, of each shape with a size[3]. */
static double cylinder(const double *size, double j[3])
{
    j[0] = square(size[1]) / 12;
    j[1] = j[2] = square(size[0]) / 4;
    return M_PI * square(size[0]) * size[1];
}

static double box(const double *size, double j[3])
{
    for (int i = 0; i < 3; i++)
        j[i] = square(size[i]) / 12;
    return size[0] * size[1] * size[2];
}

static double sphere(const double *size, double j[3])
{
    j[0] = j[1] = j[2] = square(size[0]) / 5;
    return 4 * M_PI / 3 * square(size[0]) * size[0];
}

static const struct shape {
    const char *sizes;
    int sized; /* of size[3] it asks for */
    double (*measure)(const double *size, double j[3]);
} shapes[] = {
    [HOBE_SHAPE_CYLINDER] = {"radius and length of a cylinder", 2, cylinder},
    [HOBE_SHAPE_BOX] = {"the edges of a box", 3, box},
    [HOBE_SHAPE_SPHERE] = {"the radius of a sphere", 1, sphere},
};

/* The axes of a body, rows; `round` where the second may be any. */
static enum hobe_status find_axes(const struct hobe_body *spec, int round, double axes[3][3],
                                  struct hobe_error *err)
{
    static const double given[2][3] = {{1, 0, 0}, {0, 1, 0}};
    const double size = length3(spec->axis), second = length3(spec->second);
    if (!isfinite(size) || !isfinite(second))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "axis and second of body \"%s\" must be finite", spec->name);
    if (size > 0 && second == 0 && !round)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "body \"%s\" is not round about its axis: it needs second, the direction "
                         "{x, y, z} of its second one",
                         spec->name);
    memcpy(axes, given, sizeof given);
    if (size > 0)
        memcpy(axes[0], spec->axis, sizeof axes[0]);
    if (second > 0)
        memcpy(axes[1], spec->second, sizeof axes[1]);
    else if (size > 0)
        triad3(spec->axis, axes);
    if (fabs(dot3(axes[0], axes[1])) > 1e-9 * length3(axes[0]) * length3(axes[1]))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "axis and second of body \"%s\" must be at a right angle", spec->name);
    for (int i = 0; i < 2; i++) {
        const double length = length3(axes[i]);
        for (int a = 0; a < 3; a++)
            axes[i][a] /= length;
    }
    cross3(axes[0], axes[1], axes[2]);
    return HOBE_OK;
}

static enum hobe_status measure_shape(struct hobe_body *spec, double J[3][3],
                                      struct hobe_error *err)
{
    const struct shape *shape = shapes + spec->shape;
    double j[3];
    for (int i = 0; i < shape->sized; i++)
        if (!(spec->size[i] > 0 && isfinite(spec->size[i])))
            return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                             "body \"%s\": %s must be > 0, got %g m", spec->name, shape->sizes,
                             spec->size[i]);
    const double volume = shape->measure(spec->size, j);
    if ((spec->mass > 0) == (spec->density > 0))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "body \"%s\" needs a mass, kg, or a density, kg/m^3: one of them, > 0",
                         spec->name);
    if (spec->mass == 0)
        spec->mass = spec->density * volume;
    for (int i = 0; i < 3; i++)
        J[i][i] = spec->mass * j[i];
    return HOBE_OK;
}

/* J = tr(I)/2 - I of the inertia that is given. */
static enum hobe_status measure_given(const struct hobe_body *spec, double J[3][3],
                                      struct hobe_error *err)
{
    const double(*I)[3] = spec->inertia;
    const double trace = I[0][0] + I[1][1] + I[2][2];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            if (!isfinite(I[i][j]) || fabs(I[i][j] - I[j][i]) > ROUNDING * trace)
                return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                                 "the inertia of body \"%s\" must be finite and symmetric, got %g "
                                 "and %g kg m^2 about axes %d, %d",
                                 spec->name, I[i][j], I[j][i], i + 1, j + 1);
            J[i][j] = (i == j) * trace / 2 - I[i][j];
        }
    if (!(spec->mass > 0) || spec->density != 0)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "body \"%s\" without a shape needs a mass > 0, kg, and no density, got %g",
                         spec->name, spec->mass);
    return HOBE_OK;
}

/* The principal values of J are those of int x^2: none is negative, and one at most is zero. */
static enum hobe_status check_inertia(const struct hobe_body *spec, const double J[3][3],
                                      struct hobe_error *err)
{
    const double trace = J[0][0] + J[1][1] + J[2][2];
    double copy[9], j[3];
    memcpy(copy, J, sizeof copy);
    const enum hobe_status status = hobe_eigenvalues(3, copy, j, err);
    if (status)
        return status;
    const double I[3] = {j[0] + j[1], j[0] + j[2], j[1] + j[2]}; /* ascending, as j is */
    if (!(j[0] >= -ROUNDING * trace))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "no body has the principal inertias %g, %g, %g kg m^2 of \"%s\": none may "
                         "be more than the sum of the others",
                         I[0], I[1], I[2], spec->name);
    if (!(I[0] > ROUNDING * trace))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "body \"%s\" has the principal inertias %g, %g, %g kg m^2, and would turn "
                         "freely where one is 0; give it some, or take hobe.mass",
                         spec->name, I[0], I[1], I[2]);
    return HOBE_OK;
}

/* Whether J is round about the first axis. */
static int is_round(const double J[3][3])
{
    const double trace = J[0][0] + J[1][1] + J[2][2];
    return fabs(J[1][1] - J[2][2]) + fabs(J[0][1]) + fabs(J[0][2]) + fabs(J[1][2]) <=
           ROUNDING * trace;
}

enum hobe_status body_open(const struct hobe_body *spec, struct body *body, struct hobe_error *err)
{
    double J[3][3] = {{0}}, axes[3][3];
    *body = (struct body){.spec = *spec};
    if (!isfinite(length3(spec->centre)) || !isfinite(spec->mass) || !isfinite(spec->density))
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where,
                         "mass, density and centre of body \"%s\" must be finite", spec->name);
    if (spec->shape < HOBE_SHAPE_NONE || spec->shape > HOBE_SHAPE_SPHERE)
        return hobe_fail(err, HOBE_BAD_INPUT, spec->where, "there is no shape %d of a body",
                         (int)spec->shape);
    enum hobe_status status = spec->shape == HOBE_SHAPE_NONE ? measure_given(spec, J, err)
                                                             : measure_shape(&body->spec, J, err);
    if (!status)
        status = check_inertia(spec, (const double(*)[3])J, err);
    if (!status)
        status = find_axes(spec, is_round((const double(*)[3])J), axes, err);
    body->mass[0][0] = body->spec.mass;
    for (int i = 0; !status && i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    body->mass[1 + a][1 + b] += axes[i][a] * J[i][j] * axes[j][b];
    return status;
}

double body_radius(const struct body *body)
{
    return sqrt((body->mass[1][1] + body->mass[2][2] + body->mass[3][3]) / body->mass[0][0]);
}

/* ---- look-up --------------------------------------------------------------------------------- */

const struct body *model_find_body(const struct hobe_model *model, const char *name)
{
    model = model_whole(model);
    for (size_t i = 0; i < model->bodies.count; i++)
        if (!strcmp(model_body(model, i)->spec.name, name))
            return model_body(model, i);
    return NULL;
}

int hobe_model_has_body(const hobe_model *model, const char *name)
{
    return model_find_body(model, name) != NULL;
}

enum hobe_status model_find_part(const struct hobe_model *model, const char *name,
                                 const char *where, struct part *part, struct hobe_error *err)
{
    *part = (struct part){.body = model_find_body(model, name)};
    if (!part->body)
        part->beam = model_find_beam(model, name, where, err);
    return part->beam || part->body ? HOBE_OK : HOBE_UNKNOWN;
}

enum hobe_status model_refuse_point(const char *name, const char *where, struct hobe_error *err)
{
    return hobe_fail(
        err, HOBE_BAD_INPUT, where,
        "at is missing: the place on beam \"%s\", a fraction of its length; a point is "
        "one of a body",
        name);
}

/* ---- rigidity -------------------------------------------------------------------------------- */

/* The constraints by two ties of a body with itself, whose slopes y, z are two of its directions:
 * as those of a, those of b, and the pairs of slopes whose product is kept. */
static const struct {
    int slope[2][2], pair[3][2];
} rigid[2] = {
    {{{0, 1}, {0, 2}}, {{1, 1}, {2, 1}, {1, 2}}}, /* d1.d1, d2.d1, d1.d3 */
    {{{1, 2}, {1, 2}}, {{1, 1}, {1, 2}, {2, 2}}}, /* d2.d2, d2.d3, d3.d3 */
};

static enum hobe_status add_tie(struct hobe_model *model, const struct body *body, int half,
                                struct hobe_error *err)
{
    struct tied side[2];
    for (int s = 0; s < 2; s++)
        tied_on_body(body, body->spec.centre, rigid[half].slope[s], side + s);
    struct tie *tie = tie_add(model, side, side + 1, err);
    if (!tie)
        return HOBE_NO_MEMORY;
    tie->where = body->spec.where;
    tie->rigidity = 1;
    for (int k = 0; k < 3; k++) {
        const int *pair = rigid[half].pair[k];
        const int square = rigid[half].slope[0][pair[0] - 1] == rigid[half].slope[1][pair[1] - 1];
        tie_constraint(tie)->turn[pair[0]][pair[1]] = square ? 0.5 : 1;
    }
    return HOBE_OK;
}

enum hobe_status body_ties(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; i < model->bodies.count; i++) {
        struct body *body = model_body(model, i);
        body->tie = model->ties.count;
        for (int half = 0; !status && half < 2; half++)
            status = add_tie(model, body, half, err);
    }
    return status;
}

/* ---- scale ----------------------------------------------------------------------------------- */

/* The smallest scale of the vectors in the position of a place; INFINITY where none has one. */
static double scale_of(const struct hobe_model *model, const struct tie *tie, int side,
                       const double *scale)
{
    double least = INFINITY;
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++) {
        const long unknown = model->unknown[tie->vector[t->entry]];
        for (int a = 0; a < 3 && t->what == 3 * side && unknown >= 0; a++)
            if (scale[3 * unknown + a] > 0)
                least = fmin(least, scale[3 * unknown + a]);
    }
    return least;
}

/* The vectors of a body at most by `most` per metre. */
static void limit(const struct hobe_model *model, const struct body *body, double most,
                  double *scale)
{
    for (int v = 0; v < BODY_VECTORS; v++)
        for (int a = 0; a < 3; a++) {
            double *s = scale + 3 * model->unknown[body->first + v] + a;
            *s = fmin(*s > 0 ? *s : 1, v == 0 ? most : most / body_radius(body));
        }
}

void body_scale(const struct hobe_model *model, double *scale)
{
    for (int bodies = 0; bodies < 2; bodies++) /* joined to beams first, then to each other */
        for (size_t i = 0; i < model->ties.count && model->bodies.count; i++) {
            const struct tie *tie = model_tie(model, i);
            for (int s = 0; s < 2; s++)
                if (tie->side[s].body && !tie->side[1 - s].body == !bodies)
                    limit(model, tie->side[s].body, scale_of(model, tie, 1 - s, scale), scale);
        }
}

/* ---- fields ---------------------------------------------------------------------------------- */

void body_weights(const struct body *body, const double point[3], double weight[BODY_VECTORS])
{
    weight[0] = 1;
    for (int i = 0; i < 3; i++)
        weight[1 + i] = point ? point[i] - body->spec.centre[i] : 0;
}

void body_tangent_add(const struct hobe_model *model, const struct body *body, int v, int w,
                      const double block[3][3], const struct matrix *K)
{
    const struct tie *tie = model_tie(model, body->tie);
    pattern_add_block(model, tie->place[K->layout][v * tie->vectors + w], body->first + w, block,
                      K);
}

void body_mass_force(const struct body *body, const double A[3][3], const double *a, double *f)
{
    for (int v = 0; v < BODY_VECTORS; v++)
        for (int w = 0; w < BODY_VECTORS; w++)
            for (int c = 0; c < 3; c++)
                f[3 * (body->first + v) + c] +=
                    body->mass[v][w] * dot3(A[c], a + 3 * (body->first + w));
}

void body_mass_matrix(const struct hobe_model *model, const struct body *body, const double A[3][3],
                      const struct matrix *K)
{
    for (int v = 0; v < BODY_VECTORS; v++)
        for (int w = 0; w < BODY_VECTORS; w++) {
            double block[3][3];
            times3(body->mass[v][w], A, block);
            body_tangent_add(model, body, v, w, (const double(*)[3])block, K);
        }
}

double body_mass_product(const struct body *body, const double *a, const double *b)
{
    double sum = 0;
    for (int v = 0; v < BODY_VECTORS; v++)
        for (int w = 0; w < BODY_VECTORS; w++)
            sum += body->mass[v][w] * dot3(a + 3 * (body->first + v), b + 3 * (body->first + w));
    return sum;
}

void body_reference(const struct body *body, double *q)
{
    memcpy(q + 3 * body->first, body->spec.centre, sizeof body->spec.centre);
    for (int i = 0; i < 3; i++)
        q[3 * (body->first + 1 + i) + i] = 1;
}

void body_displacement(const struct body *body, const double *vectors, const double point[3],
                       double r0[3], double u[3])
{
    double weight[BODY_VECTORS];
    body_weights(body, point, weight);
    for (int a = 0; a < 3; a++) {
        r0[a] = body->spec.centre[a] + weight[1 + a];
        u[a] = 0;
        for (int v = 0; v < BODY_VECTORS; v++)
            u[a] += weight[v] * vectors[3 * (body->first + v) + a];
    }
}

void body_turn(const struct body *body, const double *u, const double *v, double turn[3])
{
    for (int a = 0; a < 3; a++)
        turn[a] = 0;
    for (int i = 0; i < 3; i++) {
        const long at = 3 * (body->first + 1 + i);
        const double d[3] = {u[at] + (i == 0), u[at + 1] + (i == 1), u[at + 2] + (i == 2)};
        double product[3];
        cross3(d, v + at, product);
        for (int a = 0; a < 3; a++)
            turn[a] += product[a] / 2;
    }
}
