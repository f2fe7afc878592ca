/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forces and moments at places: what each does in a state. */
#include "body.h"
#include "constraint.h"
#include "drive.h"
#include "load_parts.h"
#include "vector3.h"

#include <float.h>
#include <math.h>
#include <string.h>

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
void load_subtract_moment(const struct hobe_model *model, const struct moment *load,
                          const double *u, const struct instant *instant, double factor, double *r,
                          const struct matrix *K)
{
    const struct hobe_moment *moment = &load->spec;
    const double scaled =
        factor * drive_factor(model, moment->history, instant->time, moment->where);
    struct station s;
    station_find(model, &load->on, NULL, u, &s);
    const double(*frame)[3] = (const double(*)[3])s.frame;
    double m[3];
    for (int b = 0; b < 3; b++)
        m[b] = dot3(frame[b], moment->value);
    for (int slope = 0; slope < 2; slope++) {
        double F[3] = {0}, H[3][3] = {{0}};
        angle_force(frame[0], s.slope[slope], m[0] / 2, F, H);
        angle_force(frame[2 - slope], s.slope[slope], m[2 - slope], F, H);
        station_add_force(model, &s, 1 + slope, (const double *)F, -scaled, r);
        if (K)
            station_add_stiffness(model, &s, 1 + slope, 1 + slope, (const double(*)[3])H, -scaled,
                                  K);
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

static void subtract_follower(const struct hobe_model *model, const struct force *force,
                              const double *u, double factor, double *r, const struct matrix *K)
{
    struct station s;
    double t[3][3], local[3], F[3] = {0}, n_length;
    station_find(model, &force->on, load_point(force), u, &s);
    section_axes((const double(*)[3])s.slope, t, &n_length);
    for (int b = 0; b < 3; b++) {
        local[b] = dot3(s.frame[b], force->spec.value);
        for (int a = 0; a < 3; a++)
            F[a] += local[b] * t[b][a];
    }
    station_add_force(model, &s, 0, (const double *)F, -factor, r);
    for (int slope = 0; K && slope < 2; slope++) {
        double G[3][3];
        follower_derivative((const double(*)[3])s.slope, (const double(*)[3])t, n_length,
                            (const double *)local, slope, G);
        station_add_stiffness(model, &s, 0, 1 + slope, (const double(*)[3])G, -factor, K);
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
    station_find(model, &load->on, load_point(load), u, &s);
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
    station_add_force(model, &s, 0, (const double *)F, -factor, r);
    if (status || !K)
        return;
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 3; c++)
            sum[a][c] = G[0][a][c] + instant->rate * G[1][a][c];
    station_add_stiffness(model, &s, 0, 0, (const double(*)[3])sum, -factor, K);
}

void load_subtract_force(const struct hobe_model *model, const struct force *force, const double *u,
                         const struct instant *instant, double factor, double *r,
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
        station_find(model, &force->on, load_point(force), u, &s);
        station_add_force(model, &s, 0, spec->value, -scaled, r);
    }
}
