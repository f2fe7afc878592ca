/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the checks of a kernel need: a section rule, an elastic law, the kernel's invariants, random
 * states, and batches of eight elements. */
#ifndef HOBE_TEST_FIXTURE_H
#define HOBE_TEST_FIXTURE_H

#include "kernel.h"
#include "points.h"
#include "pointwise.h"

/* One kernel with one elastic law. */
struct fixture {
    const struct hobe_kernel *kernel;
    struct pw_beam beam; /* the same element for the evaluator; beam.element only where known */
    int known, structural, dofs;
    int symmetry; /* HOBE_SYMMETRIC_X where straight, and those of the section */
    double density;
    real *size; /* [dofs] of a nodal vector that turns or stretches the section by about 1 */
    struct hobe_section_point *point, axis;
    struct hobe_section_rule rule, mean;
    struct hobe_elasticity law, mean_law;
    real *curved; /* [dofs] its reference where it is not straight and prismatic */
    struct hobe_invariants inv;
    struct points *points; /* force and tangent are taken by them, unless NULL */
};

/* Aligned memory filled with NaN, so that a read of what nobody wrote shows.  Ends the program
 * when there is none. */
void *grab(size_t count, size_t size);

void fixture_open(struct fixture *fx, const struct hobe_kernel *kernel,
                  enum pw_mechanics mechanics);
/* The same with a reference that is curved, pretwisted and distorted, and a section function that
 * grows along the element. */
void fixture_open_curved(struct fixture *fx, const struct hobe_kernel *kernel,
                         enum pw_mechanics mechanics);
/* The same, straight and prismatic, with a section that is its own mirror image. */
void fixture_open_symmetric(struct fixture *fx, const struct hobe_kernel *kernel,
                            enum pw_mechanics mechanics, int symmetry);
/* The same, straight, with section functions that grow along the element: HOBE_SYMMETRIC_X is lost.
 */
void fixture_open_tapered(struct fixture *fx, const struct hobe_kernel *kernel,
                          enum pw_mechanics mechanics, int symmetry);
void fixture_close(struct fixture *fx);

/* From now on both plans have only the numbers that this symmetry leaves, and force and tangent are
 * products with the tensor where it has HOBE_SYMMETRIC_X. */
void fixture_set_plans(struct fixture *fx, int symmetry);

/* From now on force and tangent are taken by points; until fixture_drop_points. */
void fixture_take_points(struct fixture *fx);
void fixture_drop_points(struct fixture *fx);

/* The plan "section" of a kernel with what this symmetry leaves; an array to be freed by
 * free_invariants. */
void set_section_plan(const struct hobe_kernel *kernel, int symmetry, struct hobe_invariants *inv);

/* The invariants with another number of stations; one block for all stations or one for each.
 * Arrays to be freed by free_invariants. */
void make_invariants(const struct fixture *fx, int stations, int blocks,
                     struct hobe_invariants *inv);
void free_invariants(struct hobe_invariants *inv);

/* The section functions of the tests: polynomials of degree three in y and in z. */
void test_functions(double y, double z, double (*f)[4]);

/* The same at xi of a tapered element: times 1 + taper xi. */
void grow_functions(const struct fixture *fx, double xi, double (*f)[4]);

/* "3333w/average lane 3"; lane < 0: no lane.  Overwritten by the next call. */
const char *where(const struct fixture *fx, int lane);

/* ---- random numbers and rotations ----------------------------------------------------------- */

/* The seed is any text. */
void random_seed(const char *text);
real random_real(real from, real to);

/* A random rotation matrix, row-major, orthonormal to the last digit of `real`. */
void random_rotation(real *R);

/* ---- states --------------------------------------------------------------------------------- */

/* Nodal vectors (rows of X, [vectors][3], along section axes) turned into global axes: q = R X. */
void turn(const struct fixture *fx, const real *R, const real *X, real *q);

/* Nodal vectors of the straight reference along the section axes, first node at the origin. */
void reference(const struct fixture *fx, real *X);

/* Random components up to scale * fx->size. */
void random_vectors(const struct fixture *fx, real scale, real *u);

/* Is v the position of a node, the only vector that a translation changes? */
int is_position(const struct fixture *fx, int v);

/* sqrt(sum (x_i size_i)^2) of forces: makes N, N m, N m^2 comparable; in J.  And the same of a
 * difference, relative to the second. */
real force_norm(const struct fixture *fx, const real *f);
real force_error(const struct fixture *fx, const real *f, const real *exact);
real matrix_error(const struct fixture *fx, const real *K, const real *exact);

/* ---- batches -------------------------------------------------------------------------------- */

struct batch {
    hobe_lanes *q0, *u, *q; /* [vectors][3]; q = q0 + u */
    hobe_lanes *f, *K, *U, *scratch;
    real *exact_q0, *exact_u; /* [lanes][dofs]: before rounding, after rounding */
};

void batch_open(const struct fixture *fx, struct batch *b);
void batch_close(struct batch *b);

/* Puts a state into a lane, rounded to double; u is returned rounded in b->exact_u. */
void batch_set(const struct fixture *fx, struct batch *b, int lane, const real *q0, const real *u);

/* Eight different states: random frames, displacements up to scale. */
void batch_random(const struct fixture *fx, struct batch *b, real scale);

/* Lane `from` of b to lane `to` of a. */
void batch_copy(const struct fixture *fx, struct batch *a, int to, const struct batch *b, int from);

/* The exact position q0 + u of a lane. */
void lane_position(const struct fixture *fx, const struct batch *b, int lane, real *q);

/* One lane of an array of [dofs], and of a tangent as a full matrix [dofs][dofs]. */
void lane_vector(const struct fixture *fx, const hobe_lanes *a, int lane, real *x);
void lane_matrix(const struct fixture *fx, const hobe_lanes *K, int lane, real *full);

/* Calls of the kernel; outputs and scratch are filled with NaN before. */
void run_energy(const struct fixture *fx, const struct hobe_invariants *inv, struct batch *b);
void run_force(const struct fixture *fx, const struct hobe_invariants *inv, struct batch *b);
void run_tangent(const struct fixture *fx, const struct hobe_invariants *inv, struct batch *b);
void run_trilinear(const struct fixture *fx, const hobe_lanes *p, const hobe_lanes *q,
                   const hobe_lanes *r, struct batch *b);
void run_series(const struct fixture *fx, int k, const hobe_lanes *u, hobe_lanes *table,
                struct batch *b);

#endif
