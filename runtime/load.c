/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load.h"

#include "body.h"
#include "constraint.h"
#include "drive.h"
#include "mass.h"
#include "point_mass.h"
#include "reduction.h"
#include "spin.h"
#include "taylor.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <string.h>

void tangent_add(const struct hobe_model *model, const struct beam *beam, int e, int v, int w,
                 const double block[3][3], const struct matrix *K)
{
    const int V = beam->kernel->vectors;
    const long place = beam->place[K->layout][((long)e * V + v) * V + w];
    if (place < 0)
        return;
    const int stride = model->stride[K->layout][model->unknown[model_vector(model, beam, e, w)]];
    for (int c = 0; c < 3; c++)
        for (int a = 0; a < 3; a++)
            K->value[place + c * stride + a] += block[a][c];
}

/* ---- the section where a load acts ---------------------------------------------------------- */

struct station {
    struct place place;      /* on a beam, */
    const struct body *body; /* or of this */
    int vectors;
    double weight[3][HOBE_MAX_VECTORS]; /* of its vectors in r, r_y, r_z there */
    double slope[2][3];                 /* r_y, r_z there */
    double frame[3][3];                 /* the section's axes there in the reference, rows */
};

/* The model's number of one of them. */
static long station_vector(const struct hobe_model *model, const struct station *s, int v)
{
    return s->body ? s->body->first + v : model_vector(model, s->place.beam, s->place.element, v);
}

/* A body's slopes are its directions d_2, d_3, and its axes the global ones. */
static void find_on_body(const struct body *body, const double point[3], const double *u,
                         struct station *s)
{
    *s = (struct station){.body = body,
                          .vectors = BODY_VECTORS,
                          .weight = {{0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                          .slope = {{0, 1, 0}, {0, 0, 1}},
                          .frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    body_weights(body, point, s->weight[0]);
    for (int m = 0; u && m < 2; m++)
        for (int a = 0; a < 3; a++)
            s->slope[m][a] += u[3 * (body->first + 2 + m) + a];
}

/* Axial functions at a place of a beam and the section's slopes in state u, NULL: the reference. */
static void find_on_beam(const struct hobe_model *model, struct place place, const double *u,
                         struct station *s)
{
    const struct beam *beam = place.beam;
    const struct hobe_kernel *k = beam->kernel;
    const double *q0 = beam_q0(beam, place.element);
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS];
    *s = (struct station){.place = place, .vectors = k->vectors};
    k->shape(place.xi, hobe_element_invariants(beam_law(beam, place.element))->length, N, Nx);
    beam_frame(beam, place.element, N, Nx, s->frame);
    for (int v = 0; v < k->vectors; v++) {
        const int mode = k->vector[v].mode;
        if (mode > 2)
            continue;
        s->weight[mode][v] = N[v];
        for (int a = 0; a < 3 && mode > 0; a++)
            s->slope[mode - 1][a] +=
                N[v] * (q0[3 * v + a] + (u ? u[3 * station_vector(model, s, v) + a] : 0));
    }
}

/* What a force or moment acts on in state u; of a body the point, NULL: its centre. */
static void find_station(const struct hobe_model *model, const struct target *on,
                         const double *point, const double *u, struct station *s)
{
    if (on->body)
        find_on_body(on->body, point, u, s);
    else
        find_on_beam(model, on->place, u, s);
}

/* r += factor * w_v F over the vectors' weights in r, r_y or r_z (of: 0, 1, 2). */
static void add_force(const struct hobe_model *model, const struct station *s, int of,
                      const double F[3], double factor, double *r)
{
    for (int v = 0; v < s->vectors; v++) {
        const double weight = s->weight[of][v];
        double *rv = r + 3 * station_vector(model, s, v);
        for (int a = 0; a < 3 && weight != 0; a++)
            rv[a] += factor * weight * F[a];
    }
}

/* K += factor * w_v w_w G over the weights in one of them and in another. */
static void add_stiffness(const struct hobe_model *model, const struct station *s, int of_v,
                          int of_w, const double G[3][3], double factor, const struct matrix *K)
{
    for (int v = 0; v < s->vectors; v++)
        for (int w = 0; w < s->vectors; w++) {
            const double weight = factor * s->weight[of_v][v] * s->weight[of_w][w];
            double block[3][3];
            if (weight == 0)
                continue;
            for (int a = 0; a < 3; a++)
                for (int c = 0; c < 3; c++)
                    block[a][c] = weight * G[a][c];
            if (s->body)
                body_tangent_add(model, s->body, v, w, (const double(*)[3])block, K);
            else
                tangent_add(model, s->place.beam, s->place.element, v, w, (const double(*)[3])block,
                            K);
        }
}

/* ---- moments --------------------------------------------------------------------------------- */

/* Force and stiffness of the potential -m phi, phi the angle of the slope s about the unit axis e:
 * dphi/ds = e x s/|p|^2 with p = s - (s.e) e, and its symmetric derivative. */
static void angle_force(const double e[3], const double s[3], double m, double F[3], double H[3][3])
{
    double p[3], t[3];
    const double along = dot3(s, e);
    for (int a = 0; a < 3; a++)
        p[a] = s[a] - along * e[a];
    cross3(e, p, t);
    const double p2 = dot3(p, p);
    for (int a = 0; a < 3; a++) {
        F[a] += m * t[a] / p2;
        for (int c = 0; c < 3; c++) {
            /* d(e x s)/ds = [e]x; the angle is harmonic in its plane, so H = -(t p' + p t')/p^4 */
            H[a][c] -= m * (t[a] * p[c] + p[a] * t[c]) / (p2 * p2);
        }
    }
}

/* A moment M is resolved on the beam's reference axes, M = m_x e_x + m_y e_y + m_z e_z, and acts on
 * the angles of the section's slopes about them:
 *
 *     V = -m_x (phi_x(r_y) + phi_x(r_z))/2 - m_y phi_y(r_z) - m_z phi_z(r_y).
 *
 * Each slope is normal to the axis it turns about, so that at rest the moment does work on the
 * rotation about its own axis only.  The centreline's slope takes no part: a couple on it would be
 * carried by shear within one element, and soften without limit as the mesh is refined. */
static void subtract_moment(const struct hobe_model *model, const struct moment *load,
                            const double *u, const struct instant *instant, double factor,
                            double *r, const struct matrix *K)
{
    const struct hobe_moment *moment = &load->spec;
    const double scaled =
        factor * drive_factor(model, moment->history, instant->time, moment->where);
    struct station s;
    find_station(model, &load->on, NULL, u, &s);
    const double(*frame)[3] = (const double(*)[3])s.frame;
    double m[3];
    for (int b = 0; b < 3; b++)
        m[b] = dot3(frame[b], moment->value);
    for (int slope = 0; slope < 2; slope++) {
        double F[3] = {0}, H[3][3] = {{0}};
        angle_force(frame[0], s.slope[slope], m[0] / 2, F, H);
        angle_force(frame[2 - slope], s.slope[slope], m[2 - slope], F, H);
        add_force(model, &s, 1 + slope, (const double *)F, -scaled, r);
        if (K)
            add_stiffness(model, &s, 1 + slope, 1 + slope, (const double(*)[3])H, -scaled, K);
    }
}

/* ---- follower forces ------------------------------------------------------------------------- */

/* The section's axes t_x = n/|n|, n = r_y x r_z; t_z = r_z/|r_z|; t_y = t_z x t_x. */
static void section_axes(const double slope[2][3], double t[3][3], double *n_length)
{
    double n[3];
    cross3(slope[0], slope[1], n);
    *n_length = length3(n);
    const double z_length = length3(slope[1]);
    for (int a = 0; a < 3; a++) {
        t[0][a] = n[a] / *n_length;
        t[2][a] = slope[1][a] / z_length;
    }
    cross3(t[2], t[0], t[1]);
}

/* Change of F = sum_b F_b t_b with one slope (0: r_y, 1: r_z): G[a][c] = dF_a/d slope_c. */
static void follower_derivative(const double slope[2][3], const double t[3][3], double n_length,
                                const double local[3], int of, double G[3][3])
{
    const double z_length = length3(slope[1]);
    for (int c = 0; c < 3; c++) {
        double e[3] = {0}, dn[3], dx[3], dz[3] = {0}, part[3], dy[3];
        e[c] = 1;
        if (of == 0)
            cross3(e, slope[1], dn);
        else
            cross3(slope[0], e, dn);
        const double along = dot3(dn, t[0]);
        for (int a = 0; a < 3; a++) {
            dx[a] = (dn[a] - along * t[0][a]) / n_length;
            if (of == 1)
                dz[a] = (e[a] - t[2][c] * t[2][a]) / z_length;
        }
        cross3(dz, t[0], dy);
        cross3(t[2], dx, part);
        for (int a = 0; a < 3; a++)
            G[a][c] = local[0] * dx[a] + local[1] * (dy[a] + part[a]) + local[2] * dz[a];
    }
}

/* The point of a body that a force acts on; NULL: its centre. */
static const double *force_point(const struct force *force)
{
    return force->spec.at_point ? force->spec.point : NULL;
}

static void subtract_follower(const struct hobe_model *model, const struct force *force,
                              const double *u, double factor, double *r, const struct matrix *K)
{
    struct station s;
    double t[3][3], local[3], F[3] = {0}, n_length;
    find_station(model, &force->on, force_point(force), u, &s);
    section_axes((const double(*)[3])s.slope, t, &n_length);
    for (int b = 0; b < 3; b++) {
        local[b] = dot3(s.frame[b], force->spec.value);
        for (int a = 0; a < 3; a++)
            F[a] += local[b] * t[b][a];
    }
    add_force(model, &s, 0, (const double *)F, -factor, r);
    for (int slope = 0; K && slope < 2; slope++) {
        double G[3][3];
        follower_derivative((const double(*)[3])s.slope, (const double(*)[3])t, n_length,
                            (const double *)local, slope, G);
        add_stiffness(model, &s, 0, 1 + slope, (const double(*)[3])G, -factor, K);
    }
}

/* ---- forces of the caller -------------------------------------------------------------------- */

/* What such a force is asked at. */
struct contact {
    double t, x[3], v[3]; /* s, m, m/s */
};

static void find_contact(const struct hobe_model *model, const struct station *s, const double *u,
                         const struct instant *instant, struct contact *at)
{
    struct tied reference;
    *at = (struct contact){.t = instant->time};
    if (s->body)
        for (int a = 0; a < 3; a++)
            at->x[a] = s->body->spec.centre[a] + s->weight[0][1 + a];
    else {
        tied_at(s->place, &reference);
        memcpy(at->x, reference.position, sizeof at->x);
    }
    for (int v = 0; v < s->vectors; v++) {
        const long i = 3 * station_vector(model, s, v);
        for (int a = 0; a < 3; a++) {
            at->x[a] += s->weight[0][v] * u[i + a];
            at->v[a] += instant->v ? s->weight[0][v] * instant->v[i + a] : 0;
        }
    }
}

static enum hobe_status call(const struct hobe_force *force, const struct contact *at, double F[3],
                             struct hobe_error *err)
{
    const enum hobe_status status = force->function(force->context, at->t, at->x, at->v, F, err);
    if (!status && !isfinite(F[0] + F[1] + F[2]))
        return hobe_fail(err, HOBE_BAD_INPUT, force->where,
                         "the force on \"%s\" is {%g, %g, %g} at t = %g s; it must be finite",
                         force->beam, F[0], F[1], F[2], at->t);
    return status;
}

/* G by central differences; the error of the step eps^(1/3) is eps^(2/3), and what it scales with
 * is the length of the beam or the size of the body. */
static enum hobe_status differentiate(const struct hobe_force *force, const struct contact *at,
                                      double length, double G[2][3][3], struct hobe_error *err)
{
    const double step[2] = {cbrt(DBL_EPSILON) * length,
                            cbrt(DBL_EPSILON) * (length3(at->v) + length)};
    enum hobe_status status = HOBE_OK;
    for (int i = 0; i < 6; i++) {
        struct contact side[2] = {*at, *at};
        double F[2][3] = {{0}};
        for (int k = 0; !status && k < 2; k++) {
            double *moved = (i < 3 ? side[k].x : side[k].v) + i % 3;
            *moved += k ? step[i / 3] : -step[i / 3];
            status = call(force, side + k, F[k], err);
        }
        for (int a = 0; a < 3; a++)
            G[i / 3][a][i % 3] = (F[1][a] - F[0][a]) / (2 * step[i / 3]);
    }
    return status;
}

/* F and, where there is K, its derivatives; NaN where the caller's functions fail. */
static void subtract_called(const struct hobe_model *model, const struct force *load,
                            const double *u, const struct instant *instant, double factor,
                            double *r, const struct matrix *K)
{
    const struct hobe_force *force = &load->spec;
    struct station s;
    struct contact at;
    struct hobe_error err;
    double F[3], G[2][3][3], sum[3][3];
    find_station(model, &load->on, force_point(load), u, &s);
    const double length = s.body ? body_radius(s.body) : s.place.beam->length;
    find_contact(model, &s, u, instant, &at);
    enum hobe_status status = call(force, &at, F, &err);
    if (!status && K)
        status = force->derivative ? force->derivative(force->context, at.t, at.x, at.v, G, &err)
                                   : differentiate(force, &at, length, G, &err);
    if (status) {
        model_fail(model, force->where, &err);
        F[0] = F[1] = F[2] = NAN;
    }
    add_force(model, &s, 0, (const double *)F, -factor, r);
    if (status || !K)
        return;
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 3; c++)
            sum[a][c] = G[0][a][c] + instant->rate * G[1][a][c];
    add_stiffness(model, &s, 0, 0, (const double(*)[3])sum, -factor, K);
}

/* Any force but the constant dead ones: r -= factor Q. */
static void subtract_force(const struct hobe_model *model, const struct force *force,
                           const double *u, const struct instant *instant, double factor, double *r,
                           const struct matrix *K)
{
    const struct hobe_force *spec = &force->spec;
    struct station s;
    const double scaled = factor * drive_factor(model, spec->history, instant->time, spec->where);
    if (spec->function)
        subtract_called(model, force, u, instant, scaled, r, K);
    else if (spec->follower)
        subtract_follower(model, force, u, scaled, r, K);
    else {
        find_station(model, &force->on, force_point(force), u, &s);
        add_force(model, &s, 0, spec->value, -scaled, r);
    }
}

/* ---- all loads ------------------------------------------------------------------------------- */

/* g = gravity as far as it has histories. */
static void changing_gravity(const struct hobe_model *model, const struct instant *instant,
                             double g[3])
{
    const struct gravity *gravity = model->gravities.item;
    memset(g, 0, sizeof(double[3]));
    for (size_t i = 0; i < model->gravities.count; i++, gravity++) {
        const double factor = drive_factor(model, gravity->history, instant->time, gravity->where);
        for (int a = 0; a < 3; a++)
            g[a] += factor * gravity->g[a];
    }
}

/* f += factor times the weight of an element: M a, with a = g on every position of the centreline.
 */
static void add_weight(const struct hobe_model *model, const struct beam *beam, int e,
                       const double g[3], double factor, double *f)
{
    const struct hobe_kernel *k = beam->kernel;
    const double *mass = hobe_element_invariants(beam_law(beam, e))->mass;
    for (int v = 0; v < k->vectors; v++) {
        double m = 0;
        for (int w = 0; w < k->vectors; w++)
            if (k->vector[w].mode == 0 && !k->vector[w].slope)
                m += mass[v * k->vectors + w];
        double *to = f + 3 * model_vector(model, beam, e, v);
        for (int a = 0; a < 3; a++)
            to[a] += factor * m * g[a];
    }
}

/* The same of all elements, bodies and masses. */
static void add_weights(const struct hobe_model *model, const double g[3], double factor, double *f)
{
    if (model->reduction) {
        reduction_weights(model, g, factor, f);
        return;
    }
    for (size_t i = 0; i < model->beams.count; i++)
        for (int e = 0; e < model_beam(model, i)->spec.elements; e++)
            add_weight(model, model_beam(model, i), e, g, factor, f);
    for (size_t i = 0; i < model->bodies.count; i++)
        for (int a = 0; a < 3; a++)
            f[3 * model_body(model, i)->first + a] +=
                factor * model_body(model, i)->spec.mass * g[a];
    for (size_t i = 0; i < model->masses.count; i++)
        point_mass_force(model, model_mass(model, i), factor, g, f);
}

static enum hobe_status build_gravity(struct hobe_model *model, struct hobe_error *err)
{
    if (length3(model->gravity) == 0 && model->gravities.count == 0)
        return HOBE_OK;
    const enum hobe_status status = mass_check(model, "gravity", model->gravity_where, err);
    if (!status)
        add_weights(model, model->gravity, 1, model->dead);
    return status;
}

enum hobe_status load_at(const struct hobe_model *model, const char *beam, double at,
                         const double F[3], const char *where, double *r, struct hobe_error *err)
{
    const hobe_model *whole = model_whole(model);
    const struct beam *on = model_find_beam(whole, beam, where, err);
    struct station s;
    if (!on)
        return HOBE_UNKNOWN;
    find_on_beam(whole, model_place(on, at), NULL, &s);
    if (whole == model) {
        add_force(model, &s, 0, F, 1, r);
        return HOBE_OK;
    }
    double *field = hobe_alloc((size_t)(3 * whole->vectors), sizeof *field, err);
    if (!field)
        return HOBE_NO_MEMORY;
    add_force(whole, &s, 0, F, 1, field);
    reduction_project(model, 1, field, r);
    hobe_free(field);
    return HOBE_OK;
}

/* What a load acts on: a body, or, not at a point, a beam. */
static enum hobe_status find_target(const struct hobe_model *model, const char *name, double at,
                                    int at_point, const char *where, struct target *on,
                                    struct hobe_error *err)
{
    struct part part;
    if (model_find_part(model, name, where, &part, err))
        return HOBE_UNKNOWN;
    if (part.beam && at_point)
        return model_refuse_point(name, where, err);
    on->body = part.body;
    if (part.beam)
        on->place = model_place(part.beam, at);
    return HOBE_OK;
}

const struct hobe_force *load_follower(const struct hobe_model *model)
{
    model = model_whole(model);
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct hobe_force *force = &model_force(model, i)->spec;
        if (force->follower || force->function)
            return force;
    }
    return NULL;
}

static void touch(const struct hobe_model *model, const struct station *s, int from, int to,
                  unsigned char *touched)
{
    for (int of = from; of <= to; of++)
        for (int v = 0; v < s->vectors; v++)
            if (s->weight[of][v] != 0)
                touched[station_vector(model, s, v)] = 1;
}

/* Whether the force is the same in any state at any time, and so part of model->dead. */
static int is_constant(const struct hobe_force *force)
{
    return !force->follower && !force->function && !force->history;
}

void load_touch(const struct hobe_model *model, int changing, unsigned char *touched)
{
    struct station s;
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        const struct hobe_force *spec = &force->spec;
        if (changing && is_constant(spec))
            continue;
        find_station(model, &force->on, force_point(force), NULL, &s);
        touch(model, &s, 0, spec->follower || spec->function ? 2 : 0, touched);
    }
    for (size_t i = 0; i < model->moments.count; i++) {
        find_station(model, &model_moment(model, i)->on, NULL, NULL, &s);
        touch(model, &s, 1, 2, touched);
    }
}

enum hobe_status load_find(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < model->forces.count; i++) {
        const struct hobe_force *spec = &model_force(model, i)->spec;
        status = find_target(model, spec->beam, spec->at, spec->at_point, spec->where,
                             &model_force(model, i)->on, err);
    }
    for (size_t i = 0; !status && i < model->moments.count; i++) {
        const struct hobe_moment *spec = &model_moment(model, i)->spec;
        status = find_target(model, spec->beam, spec->at, spec->at_point, spec->where,
                             &model_moment(model, i)->on, err);
    }
    return status;
}

enum hobe_status load_build(struct hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = load_find(model, err);
    for (size_t i = 0; !status && i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        struct station s;
        if (!is_constant(&force->spec))
            continue;
        find_station(model, &force->on, force_point(force), NULL, &s);
        add_force(model, &s, 0, force->spec.value, 1, model->dead);
    }
    if (!status)
        status = build_gravity(model, err);
    return status ? status : spin_build(model, err);
}

/* Those at places: forces that are not constant, and moments. */
static void subtract_placed(const struct hobe_model *model, const double *u,
                            const struct instant *instant, double factor, double *r,
                            const struct matrix *K)
{
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        if (!is_constant(&force->spec))
            subtract_force(model, force, u, instant, factor, r, K);
    }
    for (size_t i = 0; i < model->moments.count; i++)
        subtract_moment(model, model_moment(model, i), u, instant, factor, r, K);
}

void load_subtract(const struct hobe_model *model, const double *u, const struct instant *instant,
                   double factor, double *r, const struct matrix *K)
{
    const hobe_model *whole = model_whole(model);
    double g[3];
    if (factor == 0) /* functions that fail would make it NaN */
        return;
    for (long i = 0; i < 3 * model->vectors; i++)
        r[i] -= factor * model->dead[i];
    changing_gravity(whole, instant, g);
    if (whole->gravities.count > 0)
        add_weights(model, g, -factor, r);
    if (whole->forces.count + whole->moments.count > 0)
        reduction_act(model, subtract_placed, u, instant, factor, r, K);
    spin_subtract(model, u, instant, factor, r, K);
}

/* ---- along a series -------------------------------------------------------------------------- */

/* The slopes r_y, r_z at a station, which was found in u[0], along the states u[known]. */
static void find_slopes(const struct hobe_model *model, const struct station *s,
                        const double *const *u, int known, taylor3 slope[2])
{
    memset(slope, 0, 2 * sizeof *slope);
    for (int m = 0; m < 2; m++) {
        memcpy(slope[m][0], s->slope[m], sizeof s->slope[m]);
        for (int v = 0; v < s->vectors; v++)
            for (int i = 1; i < known; i++)
                for (int a = 0; a < 3; a++)
                    slope[m][i][a] +=
                        s->weight[1 + m][v] * u[i][3 * station_vector(model, s, v) + a];
    }
}

/* F[k] += that of angle_force. */
static void angle_series(int k, const double e[3], const taylor3 slope, double m, double F[3])
{
    taylor3 p = {{0}}, axis = {{e[0], e[1], e[2]}}, t = {{0}}, quotient;
    taylor along = {0}, p2 = {0};
    memcpy(p, slope, sizeof p);
    taylor_dot(k, slope, axis, 1, along);
    taylor_scale(k, along, axis, -1, p);
    taylor_cross(k, axis, p, t);
    taylor_dot(k, p, p, 1, p2);
    taylor_divide(k, t, p2, m, quotient);
    for (int a = 0; a < 3; a++)
        F[a] += quotient[k][a];
}

static void add_moment_series(const struct hobe_model *model, const struct moment *load,
                              const double *const *u, double time, int known, int k, double *Q)
{
    const struct hobe_moment *moment = &load->spec;
    const double factor = drive_factor(model, moment->history, time, moment->where);
    struct station s;
    taylor3 slope[2];
    find_station(model, &load->on, NULL, u[0], &s);
    find_slopes(model, &s, u, known, slope);
    for (int m = 0; m < 2; m++) {
        double F[3] = {0};
        angle_series(k, s.frame[0], slope[m], dot3(s.frame[0], moment->value) / 2, F);
        angle_series(k, s.frame[2 - m], slope[m], dot3(s.frame[2 - m], moment->value), F);
        add_force(model, &s, 1 + m, F, factor, Q);
    }
}

/* The axes of section_axes, and of them the force. */
static void add_follower_series(const struct hobe_model *model, const struct force *load,
                                const double *const *u, double time, int known, int k, double *Q)
{
    const struct hobe_force *force = &load->spec;
    const double factor = drive_factor(model, force->history, time, force->where);
    struct station s;
    taylor3 slope[2], n = {{0}}, t[3] = {{{0}}};
    taylor size;
    double F[3] = {0};
    find_station(model, &load->on, force_point(load), u[0], &s);
    find_slopes(model, &s, u, known, slope);
    taylor_cross(k, slope[0], slope[1], n);
    taylor_length(k, n, size);
    taylor_divide(k, n, size, 1, t[0]);
    taylor_length(k, slope[1], size);
    taylor_divide(k, slope[1], size, 1, t[2]);
    taylor_cross(k, t[2], t[0], t[1]);
    for (int b = 0; b < 3; b++)
        for (int a = 0; a < 3; a++)
            F[a] += dot3(s.frame[b], force->value) * t[b][k][a];
    add_force(model, &s, 0, F, factor, Q);
}

void load_series(const struct hobe_model *model, const double *const *u,
                 const struct instant *instant, int known, int k, double *Q)
{
    memset(Q, 0, (size_t)(3 * model->vectors) * sizeof *Q);
    if (k == 0) {
        load_subtract(model, u[0], instant, -1, Q, NULL);
        return;
    }
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        if (force->spec.follower)
            add_follower_series(model, force, u, instant->time, known, k, Q);
    }
    for (size_t i = 0; i < model->moments.count; i++)
        add_moment_series(model, model_moment(model, i), u, instant->time, known, k, Q);
}

/* ---- inside an element ----------------------------------------------------------------------- */

void load_inside(const struct hobe_model *model, const double *u, const struct instant *instant,
                 double factor, const struct beam *beam, int e, double *f)
{
    double g[3];
    changing_gravity(model, instant, g);
    for (int a = 0; a < 3; a++)
        g[a] += model->gravity[a];
    add_weight(model, beam, e, g, factor, f);
    for (size_t i = 0; i < model->masses.count; i++) {
        const struct point_mass *mass = model_mass(model, i);
        if (place_inside(mass->place, beam, e))
            point_mass_force(model, mass, factor, g, f);
    }
    spin_inside(model, u, instant, factor, beam, e, f);
    for (size_t i = 0; i < model->forces.count; i++) {
        const struct force *force = model_force(model, i);
        if (place_inside(force->on.place, beam, e))
            subtract_force(model, force, u, instant, -factor, f, NULL);
    }
    for (size_t i = 0; i < model->moments.count; i++) {
        const struct moment *moment = model_moment(model, i);
        if (place_inside(moment->on.place, beam, e))
            subtract_moment(model, moment, u, instant, -factor, f, NULL);
    }
}
