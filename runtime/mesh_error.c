/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How much too stiff the mesh of a beam is: an estimate from its own equilibrium.
 *
 * The nodal forces of an element give the force and the moment in every section of it that balance
 * the loads, N* along the axis p = r' and M*.  Its strains give others by the section's law: of the
 * axis and of the slopes d_y, d_z, as changes from the reference,
 *
 *     N = EA mean(e_xx),  (M_y, M_z) = EI (kappa_y, kappa_z),  kappa_y = p.d_z', kappa_z = p.d_y'.
 *
 * The energy of the difference bounds that of the error (Prager & Synge, Quart. Appl. Math. 5,
 * 1947; Ladeveze's error in the constitutive relation).  It sees what a coarse mesh misses of
 * bending, and membrane locking: an element whose axis cannot follow a bent arc makes up for that
 * by stretch, which in a slender beam is so much stiffer that it then hardly bends.  Where both
 * slopes turn along an element, in torsion, they are shorter in between, since they are
 * interpolated: that goes with N.  Of both the mean over an element is left out: Poisson's ratio
 * makes one where something presses on the section, as its own spin does, and even twist another; a
 * coarse mesh makes none.  Shear and the rest of torsion are left out, too, so that the estimate is
 * low. */
#include "around.h"
#include "assemble.h"
#include "element.h"
#include "section.h"
#include "solution.h"
#include "vector3.h"

#include <stdio.h>
#include <string.h>

/* Less is what a coarse mesh may well cost.  Twist can be wrong by ten times as much, where far
 * twisted bars get stiffer with the third power of it. */
static const double NOTICEABLE = 0.01;

/* p = r', the section's slopes d_y, d_z, and their derivatives along the axis, of some field. */
struct directors {
    double p[3], d[2][3], d_x[2][3];
};

static void add_scaled(double sum[3], double factor, const double a[3])
{
    for (int i = 0; i < 3; i++)
        sum[i] += factor * a[i];
}

static void add_directors(const struct around *at, const double *q, struct directors *sum)
{
    for (int v = 0; v < at->kernel->vectors; v++) {
        const int slope = at->kernel->vector[v].mode - 1; /* modes are 1, y, z, ... */
        if (slope < 0)
            add_scaled(sum->p, at->Nx[v], q + 3 * v);
        if (slope == 0 || slope == 1) {
            add_scaled(sum->d[slope], at->N[v], q + 3 * v);
            add_scaled(sum->d_x[slope], at->Nx[v], q + 3 * v);
        }
    }
}

/* (a + da).(b + db) - a.b, with all digits where the changes are small. */
static double change(const double a[3], const double da[3], const double b[3], const double db[3])
{
    return dot3(a, db) + dot3(da, b) + dot3(da, db);
}

/* In a section: N, M_y, and M_z about -z, conjugate to the strains; and sqrt(2) EA times what both
 * slopes stretch by, the lesser of d_y.d_y/2 and d_z.d_z/2. */
enum { AXIAL, SLOPES, EVEN };
struct inner {
    double N[EVEN], M[2];
};

/* Those of the strains: mean(e_xx) has the turn of the section's slopes, too. */
static struct inner of_strains(const struct directors *R, const struct directors *u,
                               const struct stiffnesses *k)
{
    const double kappa_z = change(R->p, u->p, R->d_x[0], u->d_x[0]);
    const double kappa_y = change(R->p, u->p, R->d_x[1], u->d_x[1]);
    const double y = change(R->d[0], u->d[0], R->d[0], u->d[0]) / 2;
    const double z = change(R->d[1], u->d[1], R->d[1], u->d[1]) / 2;
    const double turned = k->EIzz * change(R->d_x[0], u->d_x[0], R->d_x[0], u->d_x[0]) +
                          k->EIyy * change(R->d_x[1], u->d_x[1], R->d_x[1], u->d_x[1]);
    return (struct inner){
        .N = {(k->EA * change(R->p, u->p, R->p, u->p) + turned) / 2 +
                  k->EIyz * change(R->d_x[0], u->d_x[0], R->d_x[1], u->d_x[1]),
              y * z > 0 ? M_SQRT2 * k->EA * copysign(fmin(fabs(y), fabs(z)), y) : 0},
        .M = {k->EIyy * kappa_y + k->EIyz * kappa_z, k->EIyz * kappa_y + k->EIzz * kappa_z},
    };
}

/* The energy per length of the moments, J/m. */
static double bending_energy(const double M[2], const struct stiffnesses *k)
{
    return (M[0] * M[0] * k->EIzz + M[1] * M[1] * k->EIyy - 2 * M[0] * M[1] * k->EIyz) /
           (k->EIyy * k->EIzz - k->EIyz * k->EIyz) / 2;
}

/* An end of an element: where it is, and the force and moment there, on what lies before it. */
struct cut {
    double place[3], force[3], moment[3];
};

/* Where the axis is now, from the element's first node in the reference. */
static void axis_place(const struct around *at, double r[3])
{
    memset(r, 0, 3 * sizeof *r);
    for (int v = 0; v < at->kernel->vectors; v++)
        if (at->kernel->vector[v].mode == 0) {
            add_scaled(r, at->N[v], at->q0 + 3 * v);
            add_scaled(r, at->N[v], at->u + 3 * v);
        }
}

/* f[vectors][3]: the element's nodal forces. */
static struct cut cut_end(const struct around *at, const double *f, int end)
{
    const struct hobe_kernel *k = at->kernel;
    const double sign = end ? 1 : -1;
    struct cut cut = {.force = {0}};
    axis_place(at, cut.place);
    for (int v = 0; v < k->vectors; v++) {
        double q[3], couple[3];
        if (k->vector[v].node != (end ? k->nodes - 1 : 0))
            continue;
        for (int a = 0; a < 3; a++)
            q[a] = at->q0[3 * v + a] + at->u[3 * v + a];
        cross3(q, f + 3 * v, couple);
        if (k->vector[v].mode == 0 && !k->vector[v].slope)
            add_scaled(cut.force, sign, f + 3 * v);
        else
            add_scaled(cut.moment, sign, couple);
    }
    return cut;
}

/* What balances the ends in between: each end's, the nearer the more. */
static struct inner of_cuts(const struct around *at, const struct cut cut[2],
                            const struct directors *now)
{
    const double share[2] = {1 - at->place.xi, at->place.xi};
    double here[3], force[3] = {0}, moment[3] = {0};
    axis_place(at, here);
    for (int i = 0; i < 2; i++) {
        double arm[3], couple[3];
        for (int a = 0; a < 3; a++)
            arm[a] = cut[i].place[a] - here[a];
        cross3(arm, cut[i].force, couple);
        add_scaled(force, share[i], cut[i].force);
        add_scaled(moment, share[i], cut[i].moment);
        add_scaled(moment, share[i], couple);
    }
    return (struct inner){.N = {dot3(force, now->p) / dot3(now->p, now->p)},
                          .M = {dot3(moment, now->d[0]), -dot3(moment, now->d[1])}};
}

/* What the strains at a place say, less what balances the ends. */
static struct inner difference(const struct around *at, const struct cut cut[2],
                               const struct stiffnesses *k)
{
    struct directors R = {.p = {0}}, u = {.p = {0}}, now;
    add_directors(at, at->q0, &R);
    add_directors(at, at->u, &u);
    now = R;
    add_directors(at, at->u, &now);
    const struct inner balanced = of_cuts(at, cut, &now);
    struct inner left = of_strains(&R, &u, k);
    left.N[AXIAL] -= balanced.N[AXIAL];
    for (int i = 0; i < 2; i++)
        left.M[i] -= balanced.M[i];
    return left;
}

/* Adds the energy of the difference in an element, J. */
static enum hobe_status add_element(const hobe_solution *solution, const struct beam *beam, int e,
                                    double *energy, struct hobe_error *err)
{
    const hobe_element *law = beam_law(beam, e);
    const struct hobe_invariants *inv = hobe_element_invariants(law);
    double f[3 * HOBE_MAX_VECTORS], N[EVEN] = {0}, NN = 0;
    struct stiffnesses k;
    struct cut cut[2];
    struct around at;
    const enum hobe_status status =
        assemble_element(solution->model, beam, e, solution->u, NULL, f, err);
    if (status)
        return status;
    hobe_element_stiffnesses(law, &k);
    for (int end = 0; end < 2; end++) {
        around_look(solution->model, solution->u, (struct place){beam, e, end}, &at);
        cut[end] = cut_end(&at, f, end);
    }
    for (int g = 0; g < inv->stations; g++) {
        around_look(solution->model, solution->u, (struct place){beam, e, inv->xi[g]}, &at);
        const struct inner left = difference(&at, (const struct cut *)cut, &k);
        for (int i = 0; i < EVEN; i++) {
            N[i] += inv->wx[g] * left.N[i];
            NN += inv->wx[g] * left.N[i] * left.N[i];
        }
        *energy += inv->wx[g] * bending_energy(left.M, &k);
    }
    for (int i = 0; i < EVEN; i++)
        NN -= N[i] * N[i] / inv->length;
    *energy += fmax(NN, 0) / k.EA / 2;
    return HOBE_OK;
}

enum hobe_status hobe_solution_mesh_error(const hobe_solution *solution, const char *name,
                                          double *share, struct hobe_error *err)
{
    const struct beam *beam = model_find_beam(solution->model, name, NULL, err);
    double error = 0;
    *share = 0;
    if (!beam)
        return HOBE_UNKNOWN;
    if (hobe_element_mechanics(beam->law[0]) == HOBE_MECHANICS_STRUCTURAL ||
        hobe_section_varies(beam->spec.section))
        return HOBE_OK;
    enum hobe_status status = HOBE_OK;
    for (int e = 0; !status && e < beam->spec.elements; e++)
        status = add_element(solution, beam, e, &error, err);
    if (!status && error > 0)
        *share = error / (error + assemble_beam_energy(solution->model, beam, solution->u));
    return status;
}

enum hobe_status hobe_solution_mesh_warning(const hobe_solution *solution, const char *name,
                                            char *text, size_t size, struct hobe_error *err)
{
    double share;
    const enum hobe_status status = hobe_solution_mesh_error(solution, name, &share, err);
    snprintf(text, size, "%s", "");
    if (!status && share >= NOTICEABLE)
        snprintf(
            text, size,
            "beam %s: its strains and the forces that balance its loads differ by about %.2g %% of "
            "the energy, and it is wrong by as much, or in torsion more: its elements cannot "
            "follow how it bends and turns; use more of them, or such of higher order",
            name, 100 * share);
    return status;
}
