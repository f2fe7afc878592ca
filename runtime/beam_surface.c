/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Skins of beams. */
#include "surface.h"

#include "around.h"
#include "solution.h"
#include "stress.h"
#include "vector3.h"

#include <stddef.h>
#include <string.h>

enum {
    FINENESS = 6,    /* of closed-form sections at the ends of beams, */
    FINE = 20,       /* and of a slice */
    PER_SIZE = 64,   /* points of the swept outline for the diagonal of the section */
    STEPS = 240,     /* from end to end, shared by the elements of a beam, */
    MOST_STEPS = 48, /* at most and at least so many in one */
    LEAST_STEPS = 2
};

static const double SHARP = 0.93; /* cosine of the turn from which a corner is an edge: 21 deg */

/* ---- fields --------------------------------------------------------------------------------- */

static double size_of_u(const struct hobe_point *p)
{
    return length3(p->u);
}

static double u_x(const struct hobe_point *p)
{
    return p->u[0];
}

static double u_y(const struct hobe_point *p)
{
    return p->u[1];
}

static double u_z(const struct hobe_point *p)
{
    return p->u[2];
}

static double twist(const struct hobe_point *p)
{
    return p->twist;
}

#define STRESS(name, symbol, signs, member)                                                        \
    {                                                                                              \
        name, symbol, "Pa", signs, 0, NULL, offsetof(struct hobe_stress, member)                   \
    }

static const struct hobe_field fields[] = {
    {"u", "|u|", "m", 0, 1, size_of_u, 0},     {"ux", "u₁", "m", 1, 1, u_x, 0},
    {"uy", "u₂", "m", 1, 1, u_y, 0},           {"uz", "u₃", "m", 1, 1, u_z, 0},
    {"twist", "twist", "rad", 1, 0, twist, 0}, {"w", "w", "m²", 1, 1, NULL, 0},
    STRESS("mises", "σ Mises", 0, mises),      STRESS("sxx", "σxx", 1, section[0]),
    STRESS("syy", "σyy", 1, section[1]),       STRESS("szz", "σzz", 1, section[2]),
    STRESS("syz", "σyz", 1, section[3]),       STRESS("sxz", "σxz", 1, section[4]),
    STRESS("sxy", "σxy", 1, section[5]),
};
enum { FIELDS = sizeof fields / sizeof *fields };

const struct hobe_field *hobe_find_field(const char *name, int linear, struct hobe_error *err)
{
    char known[200] = "";
    for (int i = 0; i < FIELDS; i++) {
        if (linear && !fields[i].linear)
            continue;
        if (!strcmp(fields[i].name, name))
            return fields + i;
        strcat(strcat(known, *known ? ", " : ""), fields[i].name);
    }
    hobe_fail(err, HOBE_UNKNOWN, NULL, "%s cannot be coloured by \"%.60s\", only by %s",
              linear ? "mode shapes" : "beams", name, known);
    return NULL;
}

/* ---- outlines ------------------------------------------------------------------------------- */

/* What is swept along a beam: the points of the section's surface that lie on its outline, or
 * enough of them. */
struct profile {
    int points;
    int *at;     /* [points] numbers in the surface */
    int *next;   /* [points] place in `at` of the point that follows in its loop */
    char *sharp; /* [points] whether it is a corner */
};

/* Cosine of the turn at b from a to c, points of a section's surface. */
static double turn(const struct hobe_surface *s, int a, int b, int c)
{
    const double *p = s->point[a], *q = s->point[b], *r = s->point[c];
    const double d[2] = {q[1] - p[1], q[2] - p[2]}, e[2] = {r[1] - q[1], r[2] - q[2]};
    return (d[0] * e[0] + d[1] * e[1]) / (hypot(d[0], d[1]) * hypot(e[0], e[1]));
}

static double distance(const struct hobe_surface *s, int a, int b)
{
    return hypot(s->point[a][1] - s->point[b][1], s->point[a][2] - s->point[b][2]);
}

/* Keeps the sharp corners of the loop through `first`, and others at least `spacing` apart.
 * follows[i]: the point after i, taken away as it is passed. */
static void walk(struct profile *p, const struct hobe_surface *face, int *follows, int first,
                 double spacing)
{
    const int start = p->points;
    int before = first, i = follows[first];
    while (follows[i] != first && !(turn(face, before, i, follows[i]) < SHARP)) {
        before = i; /* to a sharp corner, if there is one, to begin with */
        i = follows[i];
    }
    for (int after; (after = follows[i]) >= 0; before = i, i = after) {
        const int sharp = turn(face, before, i, after) < SHARP;
        follows[i] = -1;
        if (p->points > start && !sharp &&
            (distance(face, p->at[p->points - 1], i) < spacing ||
             distance(face, p->at[start], i) < spacing))
            continue;
        p->at[p->points] = i;
        p->sharp[p->points] = (char)sharp;
        p->next[p->points] = p->points + 1;
        p->points++;
    }
    p->next[p->points - 1] = start;
}

static void free_profile(struct profile *p)
{
    hobe_free(p->at);
    hobe_free(p->next);
    hobe_free(p->sharp);
}

static enum hobe_status make_profile(const struct hobe_surface *face, double spacing,
                                     struct profile *p, struct hobe_error *err)
{
    const size_t edges = (size_t)face->outline;
    int *follows = hobe_alloc((size_t)face->points, sizeof *follows, err);
    *p = (struct profile){.at = hobe_alloc(edges, sizeof *p->at, err),
                          .next = hobe_alloc(edges, sizeof *p->next, err),
                          .sharp = hobe_alloc(edges, sizeof *p->sharp, err)};
    if (!follows || !p->at || !p->next || !p->sharp) {
        hobe_free(follows);
        free_profile(p);
        return HOBE_NO_MEMORY;
    }
    memset(follows, -1, (size_t)face->points * sizeof *follows);
    for (int e = 0; e < face->outline; e++)
        follows[face->edge[e][0]] = face->edge[e][1];
    for (int i = 0; i < face->points; i++)
        if (follows[i] >= 0)
            walk(p, face, follows, i, spacing);
    hobe_free(follows);
    return HOBE_OK;
}

/* ---- sweeping ------------------------------------------------------------------------------- */

/* What moves the beams. */
struct motion {
    const hobe_model *model;
    const hobe_solution *solution; /* NULL: a mode */
    const hobe_modes *modes;
    int mode;
    const struct hobe_field *field;
};

/* The section somewhere along a beam. */
struct station {
    const struct motion *motion;
    const struct beam *beam;
    int fineness;
    double at;
    struct hobe_surface face;
    struct stress_section stress; /* where the field is a stress */
    double twist;                 /* where it is the twist: with its whole turns */
};

/* Makes the section at another place of the beam, whose surface is numbered alike. */
static enum hobe_status move_station(struct station *s, double at, struct hobe_error *err)
{
    const hobe_section *section = s->beam->spec.section;
    enum hobe_status status = HOBE_OK;
    s->at = at;
    if (s->motion->field->stress)
        status = stress_section(s->motion->solution, s->beam->name, at, &s->stress, err);
    else if (s->motion->field->value == twist)
        status = hobe_solution_twist(s->motion->solution, s->beam->name, at, &s->twist, err);
    if (status || (s->face.points && !hobe_section_varies(section)))
        return status;
    hobe_surface_free(&s->face);
    s->face = (struct hobe_surface){0};
    return hobe_section_surface_at(section, at, s->fineness, &s->face, err);
}

/* The field at (y, z), where the beam has the point. */
static enum hobe_status find_value(struct station *s, double y, double z,
                                   const struct hobe_point *point, double *value,
                                   struct hobe_error *err)
{
    const hobe_section *section = s->beam->spec.section;
    const struct hobe_field *field = s->motion->field;
    const struct hobe_section_place place = {s->at, s->beam->length};
    struct hobe_stress stress;
    double f[4];
    enum hobe_status status = HOBE_OK;
    if (field->value)
        *value = field->value(point);
    else if (field->stress) {
        const int region = hobe_section_region(section, y, z);
        status = stress_at(&s->stress, y, z, region, &stress, err);
        memcpy(value, (const char *)&stress + field->stress, sizeof *value);
    } else {
        status = hobe_section_function_at(section, field->name, &place, y, z, f, err);
        *value = f[0];
    }
    return status;
}

/* Adds point i of the section's surface. */
static enum hobe_status add_point(struct station *at, int i, struct hobe_surface *s,
                                  struct hobe_error *err)
{
    const struct motion *motion = at->motion;
    const double y = at->face.point[i][1], z = at->face.point[i][2];
    const int p = s->points++;
    struct hobe_point point;
    enum hobe_status status;
    if (motion->solution) {
        status = hobe_solution_point(motion->solution, at->beam->name, at->at, y, z, &point, err);
        point.twist = at->twist;
    } else
        status = modes_displacement(motion->modes, motion->mode, at->beam->name, at->at, y, z,
                                    point.r0, point.u, err);
    if (!status)
        status = find_value(at, y, z, &point, s->value + p, err);
    if (status)
        return status;
    memcpy(s->point[p], point.r0, sizeof point.r0);
    memcpy(s->displacement[p], point.u, sizeof point.u);
    return HOBE_OK;
}

/* The section, facing the beam's end, or its begin where `turned`. */
static enum hobe_status add_face(struct station *at, int turned, struct hobe_surface *s,
                                 struct hobe_error *err)
{
    const struct hobe_surface *face = &at->face;
    const int first = s->points;
    enum hobe_status status = HOBE_OK;
    for (int i = 0; !status && i < face->points; i++)
        status = add_point(at, i, s, err);
    for (int t = 0; t < face->triangles; t++) {
        const int *n = face->triangle[t];
        hobe_surface_triangle(s, first + n[0], first + n[1 + turned], first + n[2 - turned]);
    }
    for (int e = 0; e < face->edges; e++)
        hobe_surface_edge(s, first + face->edge[e][0], first + face->edge[e][1]);
    return status;
}

/* The wall between the outline from point `first` of s on and the next one. */
static void add_wall(const struct profile *p, int first, struct hobe_surface *s)
{
    for (int i = 0; i < p->points; i++) {
        const int a = first + i, b = first + p->next[i];
        hobe_surface_triangle(s, a, b, b + p->points);
        hobe_surface_triangle(s, a, b + p->points, a + p->points);
        if (p->sharp[i])
            hobe_surface_edge(s, a, a + p->points);
    }
}

static int steps_of(const struct beam *beam)
{
    const int elements = beam->spec.elements, even = STEPS / elements;
    const int most = even < MOST_STEPS ? even : MOST_STEPS;
    return elements * (most > LEAST_STEPS ? most : LEAST_STEPS);
}

/* Room for one more beam. */
static enum hobe_status make_room(const struct hobe_surface *face, const struct profile *p,
                                  int steps, struct hobe_surface *s, struct hobe_error *err)
{
    int corners = 0;
    for (int i = 0; i < p->points; i++)
        corners += p->sharp[i];
    return hobe_surface_grow(s, (steps + 1) * p->points + 2 * face->points,
                             2 * steps * p->points + 2 * face->triangles,
                             steps * corners + 2 * face->edges, err);
}

/* The outline from end to end, after both ends. */
static enum hobe_status add_skin(struct station *at, const struct profile *p,
                                 struct hobe_surface *s, struct hobe_error *err)
{
    const int steps = steps_of(at->beam);
    enum hobe_status status = make_room(&at->face, p, steps, s, err);
    if (!status)
        status = add_face(at, 1, s, err);
    for (int k = 0; !status && k <= steps; k++) {
        const int first = s->points;
        status = move_station(at, (double)k / steps, err);
        for (int i = 0; !status && i < p->points; i++)
            status = add_point(at, p->at[i], s, err);
        if (!status && k > 0)
            add_wall(p, first - p->points, s);
    }
    return status ? status : add_face(at, 0, s, err);
}

/* Puts the surface of a section into the section's plane and its displacements onto the section's
 * axes now, less those of the axis. */
static void straighten(const struct station *at, const double centre[3], struct hobe_surface *s)
{
    const hobe_solution *solution = at->motion->solution;
    struct around p;
    double F[3][3], t[3][3];
    around_look(solution->model, solution->u, model_place(at->beam, at->at), &p);
    around_axis(&p);
    around_gradient(&p, F);
    around_axes((const double(*)[3])F, t);
    for (int i = 0; i < s->points; i++) {
        double r[3];
        for (int a = 0; a < 3; a++)
            r[a] = s->point[i][a] + s->displacement[i][a] - centre[a];
        memcpy(s->point[i], at->face.point[i], sizeof *s->point);
        for (int a = 0; a < 3; a++)
            s->displacement[i][a] = dot3(t[a], r) - s->point[i][a];
    }
}

enum hobe_status hobe_solution_slice(const hobe_solution *solution, const char *beam, double at,
                                     const struct hobe_field *field, struct hobe_surface *surface,
                                     struct hobe_error *err)
{
    const struct motion motion = {.model = solution->model, .solution = solution, .field = field};
    struct station s = {.motion = &motion, .fineness = FINE};
    struct hobe_point axis;
    *surface = (struct hobe_surface){0};
    enum hobe_status status = hobe_solution_point(solution, beam, at, 0, 0, &axis, err);
    if (status)
        return status;
    s.beam = model_find_beam(solution->model, beam, NULL, err);
    status = move_station(&s, at, err);
    if (!status)
        status = hobe_surface_grow(surface, s.face.points, s.face.triangles, s.face.edges, err);
    if (!status)
        status = add_face(&s, 0, surface, err);
    if (!status)
        straighten(&s, axis.r, surface);
    else
        hobe_surface_free(surface);
    hobe_surface_free(&s.face);
    return status;
}

static enum hobe_status add_beam(const struct motion *motion, const struct beam *beam,
                                 struct hobe_surface *s, struct hobe_error *err)
{
    struct station at = {.motion = motion, .beam = beam, .fineness = FINENESS};
    struct hobe_section_properties properties;
    struct profile profile;
    enum hobe_status status = move_station(&at, 0, err);
    if (!status) {
        hobe_section_properties(beam->spec.section, &properties);
        const double size = hypot(properties.width, properties.height);
        status = make_profile(&at.face, size / PER_SIZE, &profile, err);
    }
    if (!status) {
        status = add_skin(&at, &profile, s, err);
        free_profile(&profile);
    }
    hobe_surface_free(&at.face);
    return status;
}

static enum hobe_status sweep(const struct motion *motion, struct hobe_surface *surface,
                              struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    *surface = (struct hobe_surface){0};
    for (size_t i = 0; !status && i < motion->model->beams.count; i++)
        status = add_beam(motion, model_beam(motion->model, i), surface, err);
    if (status)
        hobe_surface_free(surface);
    return status;
}

enum hobe_status hobe_check_field(const hobe_solution *solution, const struct hobe_field *field,
                                  struct hobe_error *err)
{
    struct stress_section section;
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && field->stress && i < solution->model->beams.count; i++)
        status = stress_section(solution, model_beam(solution->model, i)->name, 0, &section, err);
    return status;
}

enum hobe_status hobe_solution_surface(const hobe_solution *solution,
                                       const struct hobe_field *field, struct hobe_surface *surface,
                                       struct hobe_error *err)
{
    const struct motion motion = {.model = solution->model, .solution = solution, .field = field};
    return sweep(&motion, surface, err);
}

enum hobe_status hobe_modes_surface(const hobe_modes *modes, int i, const struct hobe_field *field,
                                    struct hobe_surface *surface, struct hobe_error *err)
{
    const struct motion motion = {
        .model = modes_model(modes), .modes = modes, .mode = i, .field = field};
    return sweep(&motion, surface, err);
}
