/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An outline along a beam: one mesh that follows it, with the functions solved on it. */
#include "section_shape.h"

#include "saint_venant.h"
#include "section_surface.h"

#include <math.h>
#include <string.h>

/* Of the section's size: a node so near to an edge lies on it. */
static const double ON_EDGE = 1e-9;

/* A mesh that follows an outline: its nodes on an edge keep their place between the edge's ends,
 * the others follow smoothly. */
struct moving {
    const struct shape *like;
    struct hobe_extension *extension;
    int *edge;    /* [nodes] first point of the edge a node lies on, -1: inside */
    int *next;    /* [nodes] the edge's other end */
    double *part; /* [nodes] its place between them */
    double size;  /* of the section, m */
};

/* The edge that node n lies on. */
static void find_edge(struct moving *m, int n)
{
    const struct hobe_outline *o = m->like->outline;
    const double *at = m->like->mesh.node[n];
    m->edge[n] = -1;
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const int j = hobe_outline_next(o, l, i);
            const double *a = o->point[i], *b = o->point[j];
            const double e[2] = {b[0] - a[0], b[1] - a[1]}, d[2] = {at[0] - a[0], at[1] - a[1]};
            const double square = e[0] * e[0] + e[1] * e[1];
            const double s = fmin(1, fmax(0, (d[0] * e[0] + d[1] * e[1]) / square));
            if (hypot(d[0] - s * e[0], d[1] - s * e[1]) > ON_EDGE * m->size)
                continue;
            m->edge[n] = i;
            m->next[n] = j;
            m->part[n] = s;
            return;
        }
}

static void close_moving(void *field)
{
    struct moving *m = field;
    hobe_extension_free(m->extension);
    hobe_free(m->edge);
    hobe_free(m->next);
    hobe_free(m->part);
    hobe_free(m);
}

/* Values are y, z and the functions at each node, in units of the section's size. */
enum { PLACES = 2, VALUES = PLACES + HOBE_SECTION_FUNCTIONS };

static void *open_moving(const hobe_section *section, int *values, struct hobe_error *err)
{
    const struct shape *like = (const struct shape *)section;
    const size_t n = (size_t)like->mesh.nodes;
    struct moving *m = hobe_alloc(1, sizeof *m, err);
    unsigned char *held = m ? hobe_alloc(n, sizeof *held, err) : NULL;
    if (!held) {
        hobe_free(m);
        return NULL;
    }
    m->like = like;
    m->size = fmax(section->properties.width, section->properties.height);
    m->edge = hobe_alloc(n, sizeof *m->edge, err);
    m->next = hobe_alloc(n, sizeof *m->next, err);
    m->part = hobe_alloc(n, sizeof *m->part, err);
    if (m->edge && m->next && m->part) {
        for (size_t i = 0; i < n; i++) {
            find_edge(m, (int)i);
            held[i] = m->edge[i] >= 0;
        }
        m->extension = hobe_extension_new(&like->mesh, held, err);
    }
    hobe_free(held);
    *values = VALUES * (int)n;
    if (m->extension)
        return m;
    close_moving(m);
    return NULL;
}

/* The nodes' displacements along y (a = 0) or z from like's outline to that of s. */
static enum hobe_status move_nodes(const struct moving *m, const struct shape *s, int a, double *u,
                                   struct hobe_error *err)
{
    const double(*from)[2] = (const double(*)[2])m->like->outline->point;
    const double(*to)[2] = (const double(*)[2])s->outline->point;
    for (int n = 0; n < m->like->mesh.nodes; n++) {
        const int i = m->edge[n], j = m->next[n];
        const double part = m->part[n];
        u[n] = i < 0 ? 0 : (1 - part) * (to[i][a] - from[i][a]) + part * (to[j][a] - from[j][a]);
    }
    return hobe_extension_apply(m->extension, u, err);
}

/* Gives s like's mesh, moved. */
static enum hobe_status moved_mesh(const struct moving *m, struct shape *s, struct hobe_error *err)
{
    const struct hobe_mesh *from = &m->like->mesh;
    double *u = hobe_alloc((size_t)from->nodes, sizeof *u, err);
    enum hobe_status status = u ? hobe_mesh_copy(from, &s->mesh, err) : HOBE_NO_MEMORY;
    for (int a = 0; !status && a < 2; a++) {
        status = move_nodes(m, s, a, u, err);
        for (int n = 0; !status && n < from->nodes; n++)
            s->mesh.node[n][a] += u[n];
    }
    hobe_free(u);
    if (!status && !hobe_mesh_upright(&s->mesh))
        status =
            hobe_fail(err, HOBE_BAD_INPUT, NULL,
                      "the section's outline changes its shape too much along the beam for one "
                      "mesh; divide the beam and join its parts");
    return status;
}

static enum hobe_status solve_moving(const void *field, const double *numbers, double *values,
                                     struct hobe_error *err)
{
    const struct moving *m = field;
    const int nodes = m->like->mesh.nodes;
    struct shape *s = shape_like(m->like, numbers, err);
    if (!s)
        return err ? err->status : HOBE_NO_MEMORY;
    enum hobe_status status = moved_mesh(m, s, err);
    if (!status)
        status = shape_solve(s, err);
    for (int n = 0; !status && n < nodes; n++) {
        double unit = m->size;
        for (int a = 0; a < PLACES; a++)
            values[a * nodes + n] = s->mesh.node[n][a] / unit;
        for (int f = 0; f < HOBE_SECTION_FUNCTIONS; f++) {
            unit *= f < 2 ? m->size : 1; /* w: m^2; wy, wz: m^3 */
            values[(PLACES + f) * nodes + n] = s->values[f * nodes + n] / unit;
        }
    }
    hobe_section_free(&s->base);
    return status;
}

/* A mesh and the fields on it at a place, and their derivatives: of the places, of the functions.
 */
struct here {
    struct hobe_mesh mesh;
    double *functions, *rates, *velocities; /* [HOBE_SECTION_FUNCTIONS][nodes] */
};

static void close_here(void *here)
{
    struct here *h = here;
    hobe_mesh_free(&h->mesh);
    hobe_free(h->functions);
    hobe_free(h);
}

static void *open_here(const void *field, const double *values, struct hobe_error *err)
{
    const struct moving *m = field;
    const size_t n = (size_t)m->like->mesh.nodes, all = HOBE_SECTION_FUNCTIONS * n;
    const double unit[HOBE_SECTION_FUNCTIONS] = {pow(m->size, 2), pow(m->size, 3), pow(m->size, 3)};
    struct here *h = hobe_alloc(1, sizeof *h, err);
    if (!h)
        return NULL;
    h->functions = hobe_alloc(3 * all, sizeof *h->functions, err);
    if (!h->functions || hobe_mesh_copy(&m->like->mesh, &h->mesh, err)) {
        close_here(h);
        return NULL;
    }
    h->rates = h->functions + all;
    h->velocities = h->rates + all;
    for (size_t i = 0; i < n; i++) {
        for (size_t a = 0; a < PLACES; a++) {
            h->mesh.node[i][a] = m->size * values[a * n + i];
            h->velocities[a * n + i] = m->size * values[VALUES * n + a * n + i];
        }
        for (size_t f = 0; f < HOBE_SECTION_FUNCTIONS; f++) {
            h->functions[f * n + i] = unit[f] * values[(PLACES + f) * n + i];
            h->rates[f * n + i] = unit[f] * values[VALUES * n + (PLACES + f) * n + i];
        }
    }
    return h;
}

/* df/dx at fixed y, z = the rate at the moving point less its velocity . grad f. */
static void set_rates(double (*f)[4], double (*rate)[4], double (*velocity)[4])
{
    for (int i = 0; i < HOBE_SECTION_FUNCTIONS; i++)
        f[i][3] = rate[i][0] - velocity[0][0] * f[i][1] - velocity[1][0] * f[i][2];
}

static enum hobe_status moving_rule(const void *here, struct hobe_rule *rule,
                                    struct hobe_error *err)
{
    const struct here *h = here;
    struct hobe_rule rates = {0}, velocities = {0};
    enum hobe_status status = hobe_mesh_rule(&h->mesh, h->functions, rule, err);
    if (!status)
        status = hobe_mesh_rule(&h->mesh, h->rates, &rates, err);
    if (!status)
        status = hobe_mesh_rule(&h->mesh, h->velocities, &velocities, err);
    for (int p = 0; !status && p < rule->rule.points; p++)
        set_rates(rule->point[p].f, rates.point[p].f, velocities.point[p].f);
    hobe_rule_free(&rates);
    hobe_rule_free(&velocities);
    return status;
}

static void moving_functions(const void *here, double y, double z, double (*f)[4])
{
    const struct here *h = here;
    double rate[HOBE_SECTION_FUNCTIONS][4], velocity[HOBE_SECTION_FUNCTIONS][4];
    const struct hobe_mesh_place place = hobe_mesh_find(&h->mesh, y, z);
    hobe_mesh_fields(&h->mesh, h->functions, &place, f);
    hobe_mesh_fields(&h->mesh, h->rates, &place, rate);
    hobe_mesh_fields(&h->mesh, h->velocities, &place, velocity);
    set_rates(f, rate, velocity);
}

static enum hobe_status moving_surface(const void *here, struct hobe_surface *surface,
                                       struct hobe_error *err)
{
    return hobe_surface_mesh(&((const struct here *)here)->mesh, surface, err);
}

const struct hobe_section_field hobe_shape_field = {
    .open = open_moving,
    .solve = solve_moving,
    .open_at = open_here,
    .rule = moving_rule,
    .functions = moving_functions,
    .surface = moving_surface,
    .close_at = close_here,
    .close = close_moving,
};
