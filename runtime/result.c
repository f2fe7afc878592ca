/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Position, strain and rotation anywhere in a beam. */
#include "solution.h"

#include "element.h"
#include "section.h"
#include "vector3.h"

#include <string.h>

/* One element's vectors around a point. */
struct around {
    const struct hobe_kernel *kernel;
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS], phi[HOBE_MAX_MODES][4];
    const double *q0; /* [vectors][3] reference, the element's first node at the origin */
    double u[3 * HOBE_MAX_VECTORS];
    double frame[3][3]; /* the section's axes on the beam's axis in the reference, rows */
};

/* Displacements of the element's vectors and its axial functions at a place. */
static void look_around(const hobe_model *model, const double *u, struct place place,
                        struct around *p)
{
    const struct beam *beam = place.beam;
    p->kernel = beam->kernel;
    const double length = hobe_element_invariants(beam_law(beam, place.element))->length;
    p->q0 = beam_q0(beam, place.element);
    p->kernel->shape(place.xi, length, p->N, p->Nx);
    beam_frame(beam, place.element, p->N, p->Nx, p->frame);
    for (int v = 0; v < p->kernel->vectors; v++)
        memcpy(p->u + 3 * v, u + 3 * model_vector(model, beam, place.element, v), 3 * sizeof *p->u);
}

static struct hobe_section_place section_place(struct place place)
{
    const struct beam *beam = place.beam;
    return (struct hobe_section_place){(place.element + place.xi) / beam->spec.elements,
                                       beam->length};
}

static enum hobe_status set_modes(struct place place, double y, double z, struct around *p,
                                  struct hobe_error *err)
{
    double f[HOBE_MAX_FUNCTIONS][4] = {{0}};
    const struct hobe_section_place at = section_place(place);
    const enum hobe_status status =
        hobe_section_functions_at(place.beam->spec.section, p->kernel, &at, y, z, f, err);
    if (!status)
        p->kernel->section_modes(y, z, (const double(*)[4])f, p->phi);
    return status;
}

/* Value and gradient by x, y, z of the field sum_v N_v phi_v q_v. */
static void field(const struct around *p, const double *q, double value[3], double F[3][3])
{
    for (int a = 0; a < 3; a++)
        value[a] = F[a][0] = F[a][1] = F[a][2] = 0;
    for (int v = 0; v < p->kernel->vectors; v++) {
        const double *phi = p->phi[p->kernel->vector[v].mode];
        for (int a = 0; a < 3; a++) {
            const double x = q[3 * v + a];
            value[a] += p->N[v] * phi[0] * x;
            F[a][0] += (p->Nx[v] * phi[0] + p->N[v] * phi[3]) * x;
            F[a][1] += p->N[v] * phi[1] * x;
            F[a][2] += p->N[v] * phi[2] * x;
        }
    }
}

static double determinant(double F[3][3])
{
    return F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
           F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
           F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
}

/* F = dr/dX at the point p, columns the section's axes X_a in the reference: with
 * J = R dr0/d(x,y,z), R the rows of the frame, F = R' + du/d(x,y,z) J^-1 (eq. 22). */
static void gradient(const struct around *p, double F[3][3])
{
    double value[3], G0[3][3], G[3][3], J[3][3] = {{0}}, C[3][3];
    field(p, p->q0, value, G0);
    field(p, p->u, value, G);
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
}

/* The section modes at the places of a section where the volume is watched. */
static enum hobe_status probe_modes(struct place place, struct around *p,
                                    double phi[HOBE_PROBES][HOBE_MAX_MODES][4],
                                    struct hobe_error *err)
{
    const struct hobe_section *section = place.beam->spec.section;
    const struct hobe_section_place at = section_place(place);
    double probe[HOBE_PROBES][2];
    enum hobe_status status = hobe_section_probes_at(section, &at, probe, err);
    for (int c = 0; !status && c < section->probes; c++) {
        status = set_modes(place, probe[c][0], probe[c][1], p, err);
        memcpy(phi[c], p->phi, sizeof p->phi);
    }
    return status;
}

/* The least det F over the stations of a beam, where that is less than *smallest. */
static enum hobe_status smallest_volume(const hobe_model *model, const struct beam *beam,
                                        const double *u, double *smallest, struct hobe_error *err)
{
    const struct hobe_section *section = beam->spec.section;
    const int varies = hobe_section_varies(section);
    double phi[HOBE_PROBES][HOBE_MAX_MODES][4];
    struct around p = {.kernel = beam->kernel};
    for (int e = 0; e < beam->spec.elements; e++) {
        const struct hobe_invariants *inv = hobe_element_invariants(beam_law(beam, e));
        for (int g = 0; g < inv->stations; g++) {
            const struct place place = {beam, e, inv->xi[g]};
            const enum hobe_status status =
                varies || (e == 0 && g == 0) ? probe_modes(place, &p, phi, err) : HOBE_OK;
            if (status)
                return status;
            look_around(model, u, place, &p);
            for (int c = 0; c < section->probes; c++) {
                double F[3][3];
                memcpy(p.phi, phi[c], sizeof p.phi);
                gradient(&p, F);
                *smallest = fmin(*smallest, determinant(F));
            }
        }
    }
    return HOBE_OK;
}

enum hobe_status solution_smallest_volume(const hobe_model *model, const double *u,
                                          double *smallest, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    *smallest = INFINITY;
    for (size_t i = 0; !status && i < model->beams.count; i++)
        status = smallest_volume(model, model_beam(model, i), u, smallest, err);
    return status;
}

/* The rotation vector of the rotation R. */
static void rotation_vector(const double R[3][3], double w[3])
{
    const double axis[3] = {R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]};
    const double s = length3(axis) / 2;                     /* sin */
    const double c = (R[0][0] + R[1][1] + R[2][2] - 1) / 2; /* cos */
    const double angle = atan2(s, c);
    if (s > 1e-8 || c > 0) {
        const double factor = s > 1e-8 ? angle / (2 * s) : 0.5;
        for (int a = 0; a < 3; a++)
            w[a] = factor * axis[a];
        return;
    }
    int largest = 0; /* half a turn: R = 2 n n' - 1 */
    for (int a = 1; a < 3; a++)
        if (R[a][a] > R[largest][largest])
            largest = a;
    const double n = sqrt(fmax(0, (R[largest][largest] + 1) / 2));
    for (int a = 0; a < 3; a++)
        w[a] = angle * (a == largest ? n : (R[largest][a] + R[a][largest]) / (4 * n));
}

/* The section's rotation: its axes t_x along r_y x r_z, t_y and t_z as near to r_y and r_z as an
 * orthonormal pair can be (both turned by the same angle in their plane). */
static void section_rotation(const double F[3][3], const double frame[3][3], double w[3])
{
    double y[3], z[3], n[3], back[3], t[3][3], R[3][3];
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
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            R[a][b] = t[0][a] * frame[0][b] + t[1][a] * frame[1][b] + t[2][a] * frame[2][b];
    rotation_vector((const double(*)[3])R, w);
}

/* The beam called name and the place at; NULL with err where there is none. */
static const struct beam *find_place(const hobe_model *model, const char *name, double at,
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

/* Where a point of the beam is in the reference. */
static void reference(const struct around *p, struct place place, double at, double y, double z,
                      double r0[3])
{
    const struct beam *beam = place.beam;
    double G0[3][3];
    if (beam->origin)
        field(p, p->q0, r0, G0);
    for (int a = 0; a < 3; a++)
        r0[a] = beam->origin ? beam->origin[place.element][a] + r0[a]
                             : beam->end[0][a] + at * beam->length * p->frame[0][a] +
                                   y * p->frame[1][a] + z * p->frame[2][a];
}

enum hobe_status solution_displacement(const hobe_model *model, const double *vectors,
                                       const char *name, double at, double y, double z,
                                       double r0[3], double u[3], struct hobe_error *err)
{
    struct place place;
    struct around p;
    double gradient_u[3][3];
    const struct beam *beam = find_place(model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    look_around(model, vectors, place, &p);
    const enum hobe_status status = set_modes(place, y, z, &p, err);
    if (status)
        return status;
    field(&p, p.u, u, gradient_u);
    if (r0)
        reference(&p, place, at, y, z, r0);
    return HOBE_OK;
}

enum hobe_status hobe_solution_point(const hobe_solution *solution, const char *name, double at,
                                     double y, double z, struct hobe_point *point,
                                     struct hobe_error *err)
{
    struct place place;
    struct around p;
    double axis[3][3], gradient_u[3][3];
    const struct beam *beam = find_place(solution->model, name, at, &place, err);
    if (!beam)
        return err ? err->status : HOBE_BAD_INPUT;
    look_around(solution->model, solution->u, place, &p);
    enum hobe_status status = set_modes(place, 0, 0, &p, err);
    if (status)
        return status;
    gradient(&p, axis);
    status = set_modes(place, y, z, &p, err);
    if (status)
        return status;
    gradient(&p, point->F);
    field(&p, p.u, point->u, gradient_u);
    beam->kernel->strain(p.N, p.Nx, (const double(*)[4])p.phi, p.q0, p.u, point->strain);
    reference(&p, place, at, y, z, point->r0);
    for (int a = 0; a < 3; a++)
        point->r[a] = point->r0[a] + point->u[a];
    double zy = 0, zz = 0; /* r_z on the reference axes */
    for (int a = 0; a < 3; a++) {
        zy += axis[a][2] * p.frame[1][a];
        zz += axis[a][2] * p.frame[2][a];
    }
    point->twist = atan2(-zy, zz);
    section_rotation((const double(*)[3])axis, (const double(*)[3])p.frame, point->rotation);
    return HOBE_OK;
}
