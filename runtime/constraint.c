/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "constraint.h"

#include "body.h"
#include "reduction.h"
#include "vector3.h"

#include <math.h>
#include <string.h>

enum { ORDERS = 3 }; /* a value and its derivatives by time */

/* c += factor a */
static void add(double factor, const double a[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] += factor * a[i];
}

/* c += a x b */
static void add_cross(const double a[3], const double b[3], double c[3])
{
    double product[3];
    cross3(a, b, product);
    add(1, product, c);
}

/* M = factor [a]x, the matrix of the cross product with a. */
static void spin(double factor, const double a[3], double M[3][3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        M[i][i] = 0;
        M[j][k] = -factor * a[i];
        M[k][j] = factor * a[i];
    }
}

/* ---- places and vectors ---------------------------------------------------------------------- */

/* The axial functions of a place's vectors, zero where they have no part in r, y or z. */
static void weigh(struct place place, double N[HOBE_MAX_VECTORS], double Nx[HOBE_MAX_VECTORS])
{
    const struct beam *beam = place.beam;
    const double length = hobe_element_invariants(beam_law(beam, place.element))->length;
    beam->kernel->shape(place.xi, length, N, Nx);
    for (int v = 0; v < beam->kernel->vectors; v++)
        if (beam->kernel->vector[v].mode > 2 || fabs(N[v]) < 1e-12)
            N[v] = 0; /* at a node all but its own are, to rounding */
}

void tied_at(struct place place, struct tied *tied)
{
    const struct beam *beam = place.beam;
    const double at = (place.element + place.xi) / beam->spec.elements;
    const double *q0 = beam_q0(beam, place.element);
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS], field[3][3] = {{0}};
    weigh(place, N, Nx);
    for (int v = 0; v < beam->kernel->vectors; v++)
        if (N[v] != 0)
            add(N[v], q0 + 3 * v, field[beam->kernel->vector[v].mode]);
    *tied = (struct tied){.place = place};
    beam_frame(beam, place.element, N, Nx, tied->frame);
    for (int a = 0; a < 3; a++)
        tied->position[a] = beam->origin ? beam->origin[place.element][a] + field[0][a]
                                         : beam->end[0][a] + at * beam->length * tied->frame[0][a];
    memcpy(tied->D0[1], field[1], sizeof field[1]);
    memcpy(tied->D0[2], field[2], sizeof field[2]);
    cross3(field[1], field[2], tied->D0[0]);
}

void tied_on_body(const struct body *body, const double point[3], const int slope[2],
                  struct tied *tied)
{
    *tied = (struct tied){.body = body, .slope = {slope[0], slope[1]}};
    memcpy(tied->position, point, sizeof tied->position);
    for (int i = 0; i < 2; i++)
        tied->D0[1 + i][slope[i]] = 1;
    cross3(tied->D0[1], tied->D0[2], tied->D0[0]);
    for (int i = 0; i < 3; i++)
        tied->frame[i][i] = 1;
}

struct tie *tie_add(struct hobe_model *model, const struct tied *a, const struct tied *b,
                    struct hobe_error *err)
{
    struct tie *tie = list_append(&model->ties, sizeof *tie, err);
    if (tie)
        *tie = (struct tie){.side = {*a, *b}};
    return tie;
}

struct constraint *tie_constraint(struct tie *tie)
{
    return &tie->constraint[tie->constraints++];
}

void tie_turning(struct tie *tie)
{
    for (int k = 0; k < 3; k++) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        struct constraint *c = tie_constraint(tie);
        for (int i = 0; i < 3; i++) {
            c->turn[i][l] = dot3(tie->side[0].frame[i], tie->side[1].frame[m]) / 2;
            c->turn[i][m] = -dot3(tie->side[0].frame[i], tie->side[1].frame[l]) / 2;
        }
    }
}

void tie_slopes(struct tie *tie)
{
    const int section = tie->side[0].place.beam ? 0 : 1;
    for (int i = 1; i < 3; i++)
        for (int j = 0; j < 3; j++)
            tie_constraint(tie)->turn[section ? j : i][section ? i : j] = 1;
}

/* The place of a number among the tie's vectors, where it is put unless it is there. */
static int enter(struct tie *tie, long number)
{
    int i = 0;
    while (i < tie->vectors && tie->vector[i] != number)
        i++;
    if (i == tie->vectors)
        tie->vector[tie->vectors++] = number;
    return i;
}

/* A vector's part in r, y or z (0, 1, 2) of a side, unless it has none. */
static void add_term(struct tie *tie, int side, long vector, int what, double weight)
{
    if (weight != 0)
        tie->term[tie->terms++] = (struct tie_term){enter(tie, vector), 3 * side + what, weight};
}

static void add_terms(const struct hobe_model *model, struct tie *tie, int side)
{
    const struct tied *tied = tie->side + side;
    const struct place place = tied->place;
    double N[HOBE_MAX_VECTORS], Nx[HOBE_MAX_VECTORS];
    if (tied->body) {
        body_weights(tied->body, tied->position, N);
        for (int v = 0; v < BODY_VECTORS; v++)
            add_term(tie, side, tied->body->first + v, 0, N[v]);
        for (int i = 0; i < 2; i++)
            add_term(tie, side, tied->body->first + 1 + tied->slope[i], 1 + i, 1);
    }
    if (!place.beam)
        return;
    weigh(place, N, Nx);
    for (int v = 0; v < place.beam->kernel->vectors; v++)
        add_term(tie, side, model_vector(model, place.beam, place.element, v),
                 place.beam->kernel->vector[v].mode, N[v]);
}

/* At most so many terms has a side. */
static size_t most_terms(const struct tied *tied)
{
    if (tied->body)
        return BODY_VECTORS + 2;
    return tied->place.beam ? (size_t)tied->place.beam->kernel->vectors : 0;
}

enum hobe_status tie_resolve(struct hobe_model *model, struct tie *tie, struct hobe_error *err)
{
    const size_t most = most_terms(tie->side) + most_terms(tie->side + 1);
    tie->blocks = (tie->constraints + 2) / 3;
    tie->term = hobe_alloc(most, sizeof *tie->term, err);
    tie->vector = hobe_alloc(most + (size_t)tie->blocks, sizeof *tie->vector, err);
    if (!tie->term || !tie->vector)
        return HOBE_NO_MEMORY;
    for (int s = 0; s < 2; s++)
        add_terms(model, tie, s);
    tie->multiplier = model->vectors;
    for (int b = 0; b < tie->blocks; b++)
        tie->vector[tie->vectors++] = model->vectors++;
    return HOBE_OK;
}

void tie_free(struct tie *tie)
{
    hobe_free(tie->term);
    hobe_free(tie->vector);
    for (int layout = 0; layout < LAYOUTS; layout++)
        hobe_free(tie->place[layout]);
}

/* ---- drives ---------------------------------------------------------------------------------- */

/* s[3] = value and two derivatives of a drive at an instant, zero without one. */
static enum hobe_status drive_at(hobe_drive *drive, const struct instant *instant, double s[3],
                                 struct hobe_error *err)
{
    memset(s, 0, sizeof(double[3]));
    const int moves = drive && instant->held_back < 1;
    const enum hobe_status status = moves ? hobe_drive_at(drive, instant->time, s, err) : HOBE_OK;
    for (int p = 0; p < 3; p++)
        s[p] *= 1 - instant->held_back;
    return status;
}

/* turned = (alpha [e]x + beta [e]x^2) turn */
static void turn_columns(const double e[3], double alpha, double beta, const double turn[3][3],
                         double turned[3][3])
{
    for (int j = 0; j < 3; j++) {
        const double column[3] = {turn[0][j], turn[1][j], turn[2][j]};
        double once[3], twice[3];
        cross3(e, column, once);
        cross3(e, once, twice);
        for (int i = 0; i < 3; i++)
            turned[i][j] = alpha * once[i] + beta * twice[i];
    }
}

/* Adds to c, the p-th derivative by time of a constraint, what the rotation R = 1 + sin(theta) [e]x
 * + (1 - cos(theta)) [e]x^2 has beside 1, alpha and beta those of sine and 1 - cosine, and the way.
 */
static void drive_constraint(const struct tie *tie, const struct constraint *is, int p,
                             double alpha, double beta, double way, struct constraint *c)
{
    double turned[3][3];
    turn_columns(tie->axis, alpha, beta, is->turn, turned);
    c->offset -= is->driven ? way : 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            c->turn[i][j] += turned[i][j];
            if (p == 0) /* as `value` takes D_a0' D_b0 from D_a' D_b */
                c->offset += turned[i][j] * dot3(tie->side[0].D0[i], tie->side[1].D0[j]);
        }
}

/* c[p][k] = the p-th derivative by time of constraint k at an instant, p < ORDERS. */
static enum hobe_status constraints_at(const struct tie *tie, const struct instant *instant,
                                       struct constraint c[ORDERS][TIE_CONSTRAINTS],
                                       struct hobe_error *err)
{
    double a[ORDERS], s[ORDERS];
    memcpy(c[0], tie->constraint, sizeof c[0]);
    memset(c + 1, 0, (ORDERS - 1) * sizeof *c);
    if (!tie->angle && !tie->position)
        return HOBE_OK;
    enum hobe_status status = drive_at(tie->angle, instant, a, err);
    if (!status)
        status = drive_at(tie->position, instant, s, err);
    if (status)
        return status;
    const double sine = sin(a[0]), cosine = cos(a[0]), half = sin(a[0] / 2);
    const double alpha[ORDERS] = {sine, a[1] * cosine, a[2] * cosine - a[1] * a[1] * sine};
    const double beta[ORDERS] = {2 * half * half, a[1] * sine, a[2] * sine + a[1] * a[1] * cosine};
    for (int k = 0; k < tie->constraints; k++) {
        const struct constraint *is = tie->constraint + k;
        const double way[ORDERS] = {s[0] + is->bend / 2 * s[0] * s[0],
                                    s[1] + is->bend * s[0] * s[1],
                                    s[2] + is->bend * (s[1] * s[1] + s[0] * s[2])};
        if (1 + is->bend * s[0] <= 0)
            return hobe_fail(err, HOBE_BAD_INPUT, tie->where,
                             "a distance of %g m cannot change by %g m, at t = %g s", 1 / is->bend,
                             s[0], instant->time);
        for (int p = 0; p < ORDERS; p++)
            drive_constraint(tie, is, p, alpha[p], beta[p], way[p], c[p] + k);
    }
    return HOBE_OK;
}

/* The same; where a drive fails the model hears of it, and all is NaN. */
static void constraints_now(const struct hobe_model *model, const struct tie *tie,
                            const struct instant *instant,
                            struct constraint c[ORDERS][TIE_CONSTRAINTS])
{
    struct hobe_error err;
    if (!constraints_at(tie, instant, c, &err))
        return;
    model_fail(model, tie->where, &err);
    for (int p = 0; p < ORDERS; p++)
        for (int k = 0; k < tie->constraints; k++)
            c[p][k] = (struct constraint){.offset = NAN};
}

/* ---- the constraints ------------------------------------------------------------------------- */

/* Both places in a state.  Phi is a difference of nearly equal directions: it is formed from
 * displacements, D_a' D_b - D_a0' D_b0 = dD_a' D_b + D_a0' dD_b, to keep its digits. */
struct state {
    double D[2][3][3], dD[2][3][3], d[3];
    double lambda[TIE_CONSTRAINTS];
};

void tie_motion(const struct tie *tie, const double *field, double moved[TIE_VECTORS][3])
{
    memset(moved, 0, sizeof(double[TIE_VECTORS][3]));
    for (const struct tie_term *t = tie->term; field && t < tie->term + tie->terms; t++)
        add(t->weight, field + 3 * tie->vector[t->entry], moved[t->what]);
}

static void read_state(const struct tie *tie, const double *u, struct state *s)
{
    double moved[TIE_VECTORS][3];
    *s = (struct state){0};
    tie_motion(tie, u, moved);
    for (int k = 0; u && k < tie->constraints; k++)
        s->lambda[k] = u[3 * tie->multiplier + k];
    for (int a = 0; a < 3; a++)
        s->d[a] = moved[3][a] - moved[0][a];
    for (int side = 0; side < 2; side++) {
        const double(*D0)[3] = tie->side[side].D0;
        double(*D)[3] = s->D[side], (*dD)[3] = s->dD[side];
        memcpy(dD[1], moved[3 * side + 1], sizeof(double[2][3]));
        for (int i = 1; i < 3; i++)
            for (int a = 0; a < 3; a++)
                D[i][a] = D0[i][a] + dD[i][a];
        add_cross(dD[1], D0[2], dD[0]);
        add_cross(D[1], dD[2], dD[0]);
        for (int a = 0; a < 3; a++)
            D[0][a] = D0[0][a] + dD[0][a];
    }
}

static double value(const struct constraint *c, const struct tie *tie, const struct state *s)
{
    double phi = c->offset + dot3(c->hold, s->d) + c->bend / 2 * dot3(s->d, s->d);
    for (int i = 0; i < 3; i++) {
        phi += c->slide[i] * dot3(s->D[0][i], s->d);
        for (int j = 0; j < 3; j++)
            phi += c->turn[i][j] *
                   (dot3(s->dD[0][i], s->D[1][j]) + dot3(tie->side[0].D0[i], s->dD[1][j]));
    }
    return phi;
}

/* W[side][i] = dPhi/dD_i with n taken for a direction of its own. */
static void by_directions(const struct constraint *c, const struct state *s, double W[2][3][3])
{
    memset(W, 0, sizeof(double[2][3][3]));
    for (int i = 0; i < 3; i++) {
        add(c->slide[i], s->d, W[0][i]);
        for (int j = 0; j < 3; j++) {
            add(c->turn[i][j], s->D[1][j], W[0][i]);
            add(c->turn[i][j], s->D[0][i], W[1][j]);
        }
    }
}

/* g = dPhi/d(r, y, z of both places); from n = y x z, w . dn = dy . (z x w) + dz . (w x y). */
static void gradient(const struct constraint *c, const struct state *s, double g[TIE_VECTORS][3])
{
    double W[2][3][3];
    by_directions(c, s, W);
    memcpy(g[3], c->hold, sizeof c->hold);
    add(c->bend, s->d, g[3]);
    for (int i = 0; i < 3; i++)
        add(c->slide[i], s->D[0][i], g[3]);
    for (int a = 0; a < 3; a++)
        g[0][a] = -g[3][a];
    for (int side = 0; side < 2; side++) {
        memcpy(g[3 * side + 1], W[side][1], sizeof(double[2][3]));
        add_cross(s->D[side][2], W[side][0], g[3 * side + 1]);
        add_cross(W[side][0], s->D[side][1], g[3 * side + 2]);
    }
}

/* sum_k lambda_k of the constraints c. */
static struct constraint combine(const struct tie *tie, const struct constraint *c,
                                 const double *lambda)
{
    struct constraint sum = {.offset = 0};
    for (int k = 0; k < tie->constraints; k++, c++) {
        add(lambda[k], c->slide, sum.slide);
        add(lambda[k], c->hold, sum.hold);
        sum.bend += lambda[k] * c->bend;
        for (int i = 0; i < 3; i++)
            add(lambda[k], c->turn[i], sum.turn[i]);
    }
    return sum;
}

void tie_jacobian(const struct tie *tie, double J[TIE_CONSTRAINTS][TIE_VECTORS][3])
{
    struct state s;
    read_state(tie, NULL, &s);
    for (int k = 0; k < tie->constraints; k++)
        gradient(tie->constraint + k, &s, J[k]);
}

enum hobe_status tie_reaction(const struct tie *tie, const double *u, const struct instant *instant,
                              double force[3], double moment[3], struct hobe_error *err)
{
    struct state s;
    struct constraint c[ORDERS][TIE_CONSTRAINTS];
    double g[TIE_VECTORS][3];
    const enum hobe_status status = constraints_at(tie, instant, c, err);
    if (status)
        return status;
    read_state(tie, u, &s);
    const struct constraint sum = combine(tie, c[0], s.lambda);
    gradient(&sum, &s, g);
    for (int a = 0; a < 3; a++) {
        force[a] = -g[3][a];
        moment[a] = 0;
    }
    for (int i = 1; i < 3; i++)
        add_cross(g[3 + i], s.D[1][i], moment);
    return HOBE_OK;
}

/* H += factor A' B */
static void add_product(double factor, const double A[3][3], const double B[3][3], double H[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                H[i][j] += factor * A[k][i] * B[k][j];
}

/* The second derivatives of Phi by r, y, z: products of the directions' first derivatives
 * L = dD_i/d(y, z), and where n is bent itself, w . d2n = 2 dy . (dz x w). */
static void hessian(const struct constraint *c, const struct state *s,
                    double H[TIE_VECTORS][TIE_VECTORS][3][3])
{
    static const double one[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double W[2][3][3], L[2][3][2][3][3] = {0};
    by_directions(c, s, W);
    memset(H, 0, sizeof(double[TIE_VECTORS][TIE_VECTORS][3][3]));
    for (int side = 0; side < 2; side++) {
        spin(-1, s->D[side][2], L[side][0][0]);
        spin(1, s->D[side][1], L[side][0][1]);
        memcpy(L[side][1][0], one, sizeof one);
        memcpy(L[side][2][1], one, sizeof one);
        spin(-1, W[side][0], H[3 * side + 1][3 * side + 2]);
    }
    add_product(c->bend, one, one, H[0][0]);
    add_product(-c->bend, one, one, H[0][3]);
    add_product(c->bend, one, one, H[3][3]);
    for (int i = 0; i < 3; i++)
        for (int p = 0; p < 2; p++) {
            const double(*La)[3] = (const double(*)[3])L[0][i][p];
            add_product(-c->slide[i], one, La, H[0][1 + p]);
            add_product(c->slide[i], La, one, H[1 + p][3]);
            for (int j = 0; j < 3; j++)
                for (int q = 0; q < 2; q++)
                    add_product(c->turn[i][j], La, (const double(*)[3])L[1][j][q], H[1 + p][4 + q]);
        }
    for (int i = 0; i < TIE_VECTORS; i++)
        for (int j = 0; j < i; j++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    H[i][j][a][b] = H[j][i][b][a];
}

double tie_measure(const struct tie *tie, const struct constraint *c, const double *u,
                   double G[TIE_VECTORS][3], double (*H)[TIE_VECTORS][3][3])
{
    struct state s;
    read_state(tie, u, &s);
    gradient(c, &s, G);
    if (H)
        hessian(c, &s, H);
    return value(c, tie, &s);
}

void tie_add_side(const struct tie *tie, int side, double factor, const double G[TIE_VECTORS][3],
                  double *f)
{
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++)
        if (t->what / 3 == side)
            add(factor * t->weight, G[t->what], f + 3 * tie->vector[t->entry]);
}

void tie_add_force(const struct tie *tie, double factor, const double G[TIE_VECTORS][3], double *f)
{
    for (int side = 0; side < 2; side++)
        tie_add_side(tie, side, factor, G, f);
}

/* ---- assembly -------------------------------------------------------------------------------- */

/* Adds to scalar (a, b) of the block of entries i and j, where the layout of K has it. */
static void add_at(const struct hobe_model *model, const struct tie *tie, int i, int a, int j,
                   int b, double amount, const struct matrix *K)
{
    const long place = tie->place[K->layout][i * tie->vectors + j];
    if (place >= 0)
        K->value[place + b * model->stride[K->layout][model->unknown[tie->vector[j]]] + a] +=
            amount;
}

void tie_add_tangent(const struct hobe_model *model, const struct tie *tie,
                     double H[TIE_VECTORS][TIE_VECTORS][3][3], const struct matrix *K)
{
    for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++)
        for (const struct tie_term *v = tie->term; v < tie->term + tie->terms; v++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    add_at(model, tie, t->entry, a, v->entry, b,
                           t->weight * v->weight * H[t->what][v->what][a][b], K);
}

/* The curvature of the constraints c, times their multipliers. */
static void add_curvature(const struct hobe_model *model, const struct tie *tie,
                          const struct constraint *c, const struct state *s, const struct matrix *K)
{
    double H[TIE_VECTORS][TIE_VECTORS][3][3];
    const struct constraint sum = combine(tie, c, s->lambda);
    hessian(&sum, s, H);
    tie_add_tangent(model, tie, H, K);
}

/* And the constraints' derivatives J beside their multipliers, with 1 on spare ones. */
static void add_border(const struct hobe_model *model, const struct tie *tie,
                       double J[TIE_CONSTRAINTS][TIE_VECTORS][3], const struct matrix *K)
{
    for (int k = 0; k < 3 * tie->blocks; k++) {
        const int row = tie_entry(tie, k), m = k % 3;
        if (k >= tie->constraints)
            add_at(model, tie, row, m, row, m, 1, K);
        for (int t = 0; t < tie->terms && k < tie->constraints; t++)
            for (int a = 0; a < 3; a++) {
                const struct tie_term *term = tie->term + t;
                const double amount = term->weight * J[k][term->what][a];
                add_at(model, tie, term->entry, a, row, m, amount, K);
                add_at(model, tie, row, m, term->entry, a, amount, K);
            }
    }
}

static void add_tie(const struct hobe_model *model, const struct tie *tie, const double *u,
                    const struct instant *instant, double *f, const struct matrix *K)
{
    struct state s;
    struct constraint c[ORDERS][TIE_CONSTRAINTS];
    double J[TIE_CONSTRAINTS][TIE_VECTORS][3];
    constraints_now(model, tie, instant, c);
    read_state(tie, u, &s);
    for (int k = 0; k < 3 * tie->blocks; k++) {
        const long multiplier = 3 * tie->multiplier + k;
        if (k >= tie->constraints) {
            f[multiplier] += u[multiplier];
            continue;
        }
        gradient(c[0] + k, &s, J[k]);
        f[multiplier] += value(c[0] + k, tie, &s);
        tie_add_force(tie, s.lambda[k], (const double(*)[3])J[k], f);
    }
    if (K) {
        add_curvature(model, tie, c[0], &s, K);
        add_border(model, tie, J, K);
    }
}

static void add_ties(const struct hobe_model *model, const double *u, const struct instant *instant,
                     double factor, double *f, const struct matrix *K)
{
    (void)factor;
    for (size_t i = 0; i < model->ties.count; i++)
        add_tie(model, model_tie(model, i), u, instant, f, K);
}

void constraint_add(const struct hobe_model *model, const double *u, const struct instant *instant,
                    double *f, const struct matrix *K)
{
    if (model_whole(model)->ties.count > 0)
        reduction_act(model, add_ties, u, instant, 1, f, K);
    if (model->reduction)
        reduction_spare(model, u, f, K);
}

/* ---- their derivatives by time --------------------------------------------------------------- */

/* Directions and distance of a tie and their derivatives along u + v t. */
struct rates {
    double D[ORDERS][2][3][3], d[ORDERS][3];
};

static void read_rates(const struct tie *tie, const double *u, const double *v, struct rates *m)
{
    struct state s;
    double moved[TIE_VECTORS][3];
    memset(m, 0, sizeof *m);
    read_state(tie, u, &s);
    tie_motion(tie, v, moved);
    memcpy(m->D[0], s.D, sizeof s.D);
    memcpy(m->d[0], s.d, sizeof s.d);
    for (int a = 0; a < 3; a++)
        m->d[1][a] = moved[3][a] - moved[0][a];
    for (int side = 0; side < 2; side++) {
        double(*D1)[3] = m->D[1][side];
        memcpy(D1[1], moved[3 * side + 1], sizeof(double[2][3]));
        add_cross(D1[1], s.D[side][2], D1[0]);
        add_cross(s.D[side][1], D1[2], D1[0]);
        cross3(D1[1], D1[2], m->D[2][side][0]);
        add_cross(D1[1], D1[2], m->D[2][side][0]);
    }
}

/* The p-th derivative, p = 1 or 2, of constraint k, a sum of products, by Leibniz's rule:
 * (f g)'' = f'' g + 2 f' g' + f g''. */
static double derivative(int p, struct constraint c[ORDERS][TIE_CONSTRAINTS], int k,
                         const struct rates *m)
{
    double sum = c[p][k].offset + dot3(c[0][k].hold, m->d[p]);
    for (int i = 0; i <= p; i++) {
        const double choose = i % p ? p : 1;
        sum += choose * c[0][k].bend / 2 * dot3(m->d[i], m->d[p - i]);
        for (int l = 0; l < 3; l++)
            sum += choose * c[0][k].slide[l] * dot3(m->D[i][0][l], m->d[p - i]);
        for (int j = 0; j <= p - i; j++) {
            const int h = p - i - j; /* of a, b and the coefficients */
            const double times = p == 1 || i == p || j == p || h == p ? 1 : 2;
            for (int l = 0; l < 3; l++)
                for (int n = 0; n < 3; n++)
                    sum += times * c[h][k].turn[l][n] * dot3(m->D[i][0][l], m->D[j][1][n]);
        }
    }
    return sum;
}

/* out = the p-th derivatives of all constraints, at their multipliers. */
static void differentiate(const struct hobe_model *model, int p, const double *u, const double *v,
                          const struct instant *instant, double *out)
{
    const hobe_model *whole = model_whole(model);
    memset(out, 0, (size_t)(3 * model->vectors) * sizeof *out);
    if (model->reduction) {
        u = reduction_state(model, u);
        v = v ? reduction_rates(model, v) : NULL;
    }
    for (size_t i = 0; i < whole->ties.count; i++) {
        const struct tie *tie = model_tie(whole, i);
        struct constraint c[ORDERS][TIE_CONSTRAINTS];
        struct rates m;
        constraints_now(whole, tie, instant, c);
        read_rates(tie, u, v, &m);
        double *rate = out + 3 * model_number(model, tie->multiplier);
        for (int k = 0; k < tie->constraints; k++)
            rate[k] = reduction_drops(model, tie->multiplier, k) ? 0 : derivative(p, c, k, &m);
    }
}

void constraint_rate(const struct hobe_model *model, const double *u, const struct instant *instant,
                     double *rate)
{
    differentiate(model, 1, u, NULL, instant, rate);
}

void constraint_acceleration(const struct hobe_model *model, const double *u, const double *v,
                             const struct instant *instant, double *out)
{
    differentiate(model, 2, u, v, instant, out);
}

enum hobe_status tie_power(const struct tie *tie, const double *u, const struct instant *instant,
                           double *power, struct hobe_error *err)
{
    struct constraint c[ORDERS][TIE_CONSTRAINTS];
    struct rates m;
    const enum hobe_status status = constraints_at(tie, instant, c, err);
    *power = 0;
    if (status)
        return status;
    read_rates(tie, u, NULL, &m);
    for (int k = 0; k < tie->constraints; k++)
        *power += u[3 * tie->multiplier + k] * derivative(1, c, k, &m);
    return HOBE_OK;
}

void constraint_inside(const struct hobe_model *model, const double *u,
                       const struct instant *instant, const struct beam *beam, int e, double *f)
{
    for (size_t i = 0; i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        struct state s;
        struct constraint c[ORDERS][TIE_CONSTRAINTS];
        if (!place_inside(tie->side[0].place, beam, e) &&
            !place_inside(tie->side[1].place, beam, e))
            continue;
        constraints_now(model, tie, instant, c);
        read_state(tie, u, &s);
        for (int k = 0; k < tie->constraints; k++) {
            double J[TIE_VECTORS][3];
            gradient(c[0] + k, &s, J);
            for (int side = 0; side < 2; side++)
                if (place_inside(tie->side[side].place, beam, e))
                    tie_add_side(tie, side, -s.lambda[k], (const double(*)[3])J, f);
        }
    }
}
