/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums of the elements' energy, force and tangent stiffness over a model. */
#ifndef HOBE_ASSEMBLE_H
#define HOBE_ASSEMBLE_H

#include "model.h"

/* Orders the batches, and makes room for each thread that sums them: as many as OpenMP gives, where
 * the model is large enough. */
enum hobe_status assemble_schedule(hobe_model *model, struct hobe_error *err);
void assemble_free(struct schedule *schedule);

/* to[V][3] = a field u[vectors][3] on a batch of a beam; spare lanes repeat the last element. */
void assemble_gather(const struct hobe_model *model, const struct beam *beam,
                     const struct batch *batch, const double *u, hobe_lanes *to);

/* f[vectors][3] = dU/dq of all elements in state u, N; and K the tangent stiffness of the unknowns,
 * unless NULL.  Both overwritten. */
void assemble(const struct hobe_model *model, const double *u, double *f, const struct matrix *K);

/* The same, but K holds the stresses that were expected of a step v, which has led to u: those of
 * strains linear in v, without what v has added to them by its square.  In a thin beam that turns
 * this is large, false, and gone after the next iteration; without it Newton's iteration does not
 * swing between turning and stretching.  It is Newton's still, with the stresses as unknowns of
 * their own (mixed integration points: Magisano, Leonetti & Garcea 2017, Comput. Methods Appl.
 * Mech. Eng. 313).  Elements whose energy is not quartic keep their tangent. */
void assemble_expecting(const struct hobe_model *model, const double *u, const double *v, double *f,
                        const struct matrix *K);

/* f[V][3] = dU/dq of element e of a beam alone, N, in memory of its own, and what its viscous
 * stress adds where it has the velocities v[vectors][3]; NULL: at rest. */
enum hobe_status assemble_element(const struct hobe_model *model, const struct beam *beam, int e,
                                  const double *u, const double *v, double *f,
                                  struct hobe_error *err);

/* K = the tangent of elements that are where u puts them and have come there from where
 * u - v would: it differs from that of unstrained ones by the geometric stiffness of the strains of
 * v, to the first order, without what the displacements v themselves change. */
void assemble_strained(const struct hobe_model *model, const double *u, const double *v,
                       const struct matrix *K);

/* What the elements keep of the power series of a path (hobe_kernel.series). */
struct series_table {
    hobe_lanes *value;
    size_t *batch; /* [beams] from a batch to the next, */
    size_t *beam;  /* [beams] from the first of all to a beam's first one */
};

/* Room for series up to an order.  HOBE_BAD_INPUT where an element's energy is not quartic. */
enum hobe_status assemble_series_open(const struct hobe_model *model, int order,
                                      struct series_table *table, struct hobe_error *err);
void assemble_series_close(struct series_table *table);

/* f[vectors][3] = the coefficient of a^k, k = 1, 2, ..., of dU/dq of all elements along the states
 * u_0 + a u_1 + ... + a^(k-1) u_(k-1), of which u = u_(k-1), N; overwritten. */
void assemble_series(const struct hobe_model *model, int k, const double *u,
                     const struct series_table *table, double *f);

/* The viscous stress of Kelvin and Voigt, S = tau C : dE/dt, of the beams whose damping.stiffness,
 * tau, is not zero: f += tau K_m(u) v, which is 2 tau T(q; q, v) of the kernels, and K += rate tau
 * K_m(u) unless NULL.  K_m is the tangent without its stresses, which is that of elements whose
 * reference is where u has them.  What f changes with u at fixed v is not in K: in a time step it
 * is to K as the rotations and strains of the step are to one. */
void assemble_viscous(const struct hobe_model *model, const double *u,
                      const struct instant *instant, double *f, const struct matrix *K);

/* v' tau K_m(u) v, W. */
double assemble_viscous_power(const struct hobe_model *model, const double *u, const double *v);

/* Strain energy of a beam's elements, and of all, J. */
double assemble_beam_energy(const struct hobe_model *model, const struct beam *beam,
                            const double *u);
double assemble_energy(const struct hobe_model *model, const double *u);

#endif
