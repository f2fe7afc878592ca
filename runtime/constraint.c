/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "constraint.h"

#include "vector3.h"

#include <string.h>

/* c += factor a x b */
static void add_cross(double factor, const double a[3], const double b[3], double c[3])
{
    double product[3];
    cross3(a, b, product);
    for (int i = 0; i < 3; i++)
        c[i] += factor * product[i];
}

/* M += factor [a]x, the matrix of the cross product with a. */
static void add_spin(double factor, const double a[3], double M[3][3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        M[j][k] -= factor * a[i];
        M[k][j] += factor * a[i];
    }
}

/* P += factor [a]x [b]x = factor (b a' - (a.b) 1) */
static void add_spins(double factor, const double a[3], const double b[3], double P[3][3])
{
    const double along = dot3(a, b);
    for (int i = 0; i < 3; i++) {
        P[i][i] -= factor * along;
        for (int j = 0; j < 3; j++)
            P[i][j] += factor * b[i] * a[j];
    }
}

void corner_orient(struct corner *corner)
{
    for (int s = 0; s < 2; s++)
        for (int t = 0; t < 3; t++)
            corner->C[s][t] = dot3(corner->frame[1][1 + s], corner->frame[0][t]);
}

/* The vectors of a corner in state u.  Phi is a difference of nearly equal directions: it is formed
 * from displacements, p_s x b_s = b0 x db + dp x b with p0 = b0, to keep its digits. */
struct state {
    double y[3], z[3], b[2][3], lambda[3];
    double p[2][3]; /* p_y, p_z */
    double w[2][3]; /* b_s x lambda */
    double phi[3];
};

static void read_state(const struct corner *c, const double *u, struct state *s)
{
    const double *y0 = c->frame[0][1], *z0 = c->frame[0][2];
    const double *dy = u + 3 * c->vector[0], *dz = u + 3 * c->vector[1];
    double dn[3] = {0};
    for (int a = 0; a < 3; a++) {
        s->y[a] = y0[a] + dy[a];
        s->z[a] = z0[a] + dz[a];
        s->lambda[a] = u[3 * c->vector[4] + a];
        s->phi[a] = 0;
    }
    add_cross(1, dy, z0, dn);
    add_cross(1, s->y, dz, dn);
    for (int i = 0; i < 2; i++) {
        const double *b0 = c->frame[1][1 + i], *db = u + 3 * c->vector[2 + i];
        double dp[3];
        for (int a = 0; a < 3; a++) {
            dp[a] = c->C[i][0] * dn[a] + c->C[i][1] * dy[a] + c->C[i][2] * dz[a];
            s->p[i][a] = b0[a] + dp[a];
            s->b[i][a] = b0[a] + db[a];
        }
        cross3(s->b[i], s->lambda, s->w[i]);
        add_cross(1, b0, db, s->phi);
        add_cross(1, dp, s->b[i], s->phi);
    }
}

/* V = lambda . Phi = sum_s w_s . p_s with w_s = b_s x lambda:
 * V_y = sum C_sx z x w_s + C_sy w_s,  V_z = sum C_sx w_s x y + C_sz w_s,  V_b = lambda x p,
 * V_lambda = Phi = sum p_s x b_s. */
static void first_derivatives(const struct corner *c, const struct state *s,
                              double V[CORNER_VECTORS][3])
{
    memset(V, 0, sizeof(double[CORNER_VECTORS][3]));
    for (int i = 0; i < 2; i++) {
        add_cross(c->C[i][0], s->z, s->w[i], V[0]);
        add_cross(c->C[i][0], s->w[i], s->y, V[1]);
        for (int a = 0; a < 3; a++) {
            V[0][a] += c->C[i][1] * s->w[i][a];
            V[1][a] += c->C[i][2] * s->w[i][a];
        }
        add_cross(1, s->lambda, s->p[i], V[2 + i]);
    }
    memcpy(V[4], s->phi, sizeof s->phi);
}

/* The second derivatives of V; dw_s = [b_s]x dlambda - [lambda]x db_s. */
static void second_derivatives(const struct corner *c, const struct state *s,
                               double H[CORNER_VECTORS][CORNER_VECTORS][3][3])
{
    memset(H, 0, sizeof(double[CORNER_VECTORS][CORNER_VECTORS][3][3]));
    for (int i = 0; i < 2; i++) {
        const double *C = c->C[i];
        add_spin(-C[0], s->w[i], H[0][1]); /* d(z x w)/dz */
        add_spins(-C[0], s->z, s->lambda, H[0][2 + i]);
        add_spin(-C[1], s->lambda, H[0][2 + i]);
        add_spins(C[0], s->z, s->b[i], H[0][4]);
        add_spin(C[1], s->b[i], H[0][4]);
        add_spins(C[0], s->y, s->lambda, H[1][2 + i]); /* d(w x y)/dw = -[y]x */
        add_spin(-C[2], s->lambda, H[1][2 + i]);
        add_spins(-C[0], s->y, s->b[i], H[1][4]);
        add_spin(C[2], s->b[i], H[1][4]);
        add_spin(-1, s->p[i], H[2 + i][4]); /* d(lambda x p)/dlambda */
    }
    for (int i = 0; i < CORNER_VECTORS; i++)
        for (int j = 0; j < i; j++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    H[i][j][a][b] = H[j][i][b][a];
}

static void add_stiffness(const struct hobe_model *model, const struct corner *c,
                          const struct state *s, double *Ax)
{
    double H[CORNER_VECTORS][CORNER_VECTORS][3][3];
    second_derivatives(c, s, H);
    for (int i = 0; i < CORNER_VECTORS; i++)
        for (int j = 0; j < CORNER_VECTORS; j++) {
            const long unknown = model->unknown[c->vector[j]];
            for (int a = 0; a < 3 && c->block[i][j] >= 0; a++)
                for (int b = 0; b < 3; b++)
                    Ax[pattern_scalar(&model->pattern, unknown, c->block[i][j], a, b)] +=
                        H[i][j][a][b];
        }
}

void constraint_add(const struct hobe_model *model, const double *u, double *f, double *Ax)
{
    for (size_t i = 0; i < model->corners.count; i++) {
        const struct corner *c = model_corner(model, i);
        struct state s;
        double V[CORNER_VECTORS][3];
        read_state(c, u, &s);
        first_derivatives(c, &s, V);
        for (int v = 0; v < CORNER_VECTORS; v++)
            for (int a = 0; a < 3; a++)
                f[3 * c->vector[v] + a] += V[v][a];
        if (Ax)
            add_stiffness(model, c, &s, Ax);
    }
}
