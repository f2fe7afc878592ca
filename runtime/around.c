/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "around.h"

#include "vector3.h"

#include <string.h>

const struct beam *around_find(const hobe_model *model, const char *name, double at,
                               struct place *place, struct hobe_error *err)
{
    const struct beam *beam = model_find_beam(model, name, NULL, err);
    if (beam && !(at >= 0 && at <= 1)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "at must be a fraction of the beam's length from 0 to 1, got %g", at);
        return NULL;
    }
    if (beam)
        *place = model_place(beam, at);
    return beam;
}

void around_look(const hobe_model *model, const double *u, struct place place, struct around *p)
{
    const struct beam *beam = place.beam;
    p->kernel = beam->kernel;
    p->place = place;
    const double length = hobe_element_invariants(beam_law(beam, place.element))->length;
    p->q0 = beam_q0(beam, place.element);
    p->kernel->shape(place.xi, length, p->N, p->Nx);
    beam_frame(beam, place.element, p->N, p->Nx, p->frame);
    for (int v = 0; v < p->kernel->vectors; v++)
        for (int a = 0; a < 3; a++)
            p->u[3 * v + a] = u ? u[3 * model_vector(model, beam, place.element, v) + a] : 0;
}

struct hobe_section_place around_section_place(struct place place)
{
    const struct beam *beam = place.beam;
    return (struct hobe_section_place){(place.element + place.xi) / beam->spec.elements,
                                       beam->length};
}

enum hobe_status around_modes(struct around *p, double y, double z, struct hobe_error *err)
{
    double f[HOBE_MAX_FUNCTIONS][4] = {{0}};
    const struct hobe_section_place at = around_section_place(p->place);
    const enum hobe_status status =
        hobe_section_functions_at(p->place.beam->spec.section, p->kernel, &at, y, z, f, err);
    if (!status)
        p->kernel->section_modes(y, z, (const double(*)[4])f, p->phi);
    return status;
}

void around_axis(struct around *p)
{
    static const double none[HOBE_MAX_FUNCTIONS][4];
    p->kernel->section_modes(0, 0, none, p->phi);
}

void around_amplitudes(const struct around *p, const double *q, struct amplitudes *of)
{
    memset(of->a, 0, (size_t)p->kernel->modes * sizeof *of->a);
    memset(of->ax, 0, (size_t)p->kernel->modes * sizeof *of->ax);
    for (int v = 0; v < p->kernel->vectors; v++) {
        double *a = of->a[p->kernel->vector[v].mode], *ax = of->ax[p->kernel->vector[v].mode];
        for (int c = 0; c < 3; c++) {
            a[c] += p->N[v] * q[3 * v + c];
            ax[c] += p->Nx[v] * q[3 * v + c];
        }
    }
}

void amplitudes_field(const struct amplitudes *of, int modes, const double (*phi)[4],
                      double value[3], double F[3][3])
{
    for (int c = 0; c < 3; c++)
        value[c] = F[c][0] = F[c][1] = F[c][2] = 0;
    for (int m = 0; m < modes; m++)
        for (int c = 0; c < 3; c++) {
            const double a = of->a[m][c];
            value[c] += phi[m][0] * a;
            F[c][0] += phi[m][0] * of->ax[m][c] + phi[m][3] * a;
            F[c][1] += phi[m][1] * a;
            F[c][2] += phi[m][2] * a;
        }
}

void around_field(const struct around *p, const double *q, double value[3], double F[3][3])
{
    struct amplitudes of;
    around_amplitudes(p, q, &of);
    amplitudes_field(&of, p->kernel->modes, (const double(*)[4])p->phi, value, F);
}

double determinant(const double F[3][3])
{
    return F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
           F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
           F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
}

/* With J = R dr0/d(x,y,z), R the rows of the frame, F = R' + du/d(x,y,z) J^-1 (eq. 22). */
double around_gradient(const struct around *p, double F[3][3])
{
    double value[3], G0[3][3], G[3][3], J[3][3] = {{0}}, C[3][3];
    around_field(p, p->q0, value, G0);
    around_field(p, p->u, value, G);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            for (int c = 0; c < 3; c++)
                J[b][a] += p->frame[a][c] * G0[c][b]; /* its columns, as rows */
    for (int b = 0; b < 3; b++)
        cross3(J[(b + 1) % 3], J[(b + 2) % 3], C[b]); /* J^-1 = C/det */
    const double det = dot3(J[0], C[0]);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            F[a][b] = p->frame[b][a];
            for (int c = 0; c < 3; c++)
                F[a][b] += G[a][c] * C[c][b] / det;
        }
    return det;
}

void around_axes(const double F[3][3], double t[3][3])
{
    double y[3], z[3], n[3], back[3];
    for (int a = 0; a < 3; a++) {
        y[a] = F[a][1];
        z[a] = F[a][2];
    }
    cross3(y, z, n);
    for (int a = 0; a < 3; a++)
        t[0][a] = n[a] / length3(n);
    cross3(z, t[0], back); /* r_z turned back by a right angle about the normal */
    for (int a = 0; a < 3; a++)
        back[a] += y[a];
    for (int a = 0; a < 3; a++)
        t[1][a] = back[a] / length3(back);
    cross3(t[0], t[1], t[2]);
}
