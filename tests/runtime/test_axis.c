/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curved, pretwisted and tapered beams beside themselves: where nothing varies they are straight
 * and prismatic ones, their force has a potential and vanishes at rest, they turn with their axis,
 * and congruent elements share a law.  Looks into the core (model.h). */
#include "assemble.h"
#include "beam.h"
#include "check.h"
#include "load.h"
#include "scene.h"
#include "tangent.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double E = 70e9, NU = 0.33, RHO = 2700;

/* A helix {R sin p, R (1 - cos p), H p}, p = turn t, moved and turned, and its twist. */
struct helix {
    double R, turn, H, twist;
    double origin[3], Q[3][3]; /* r = origin + Q helix */
};

static const struct helix HELIX = {
    .R = 1, .turn = 1.2, .H = 0.2, .twist = 0.8, .Q = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

static void turned(const double Q[3][3], const double a[3], double b[3])
{
    for (int i = 0; i < 3; i++)
        b[i] = Q[i][0] * a[0] + Q[i][1] * a[1] + Q[i][2] * a[2];
}

static enum hobe_status helix_point(void *context, double t, double *r, struct hobe_error *err)
{
    const struct helix *h = context;
    const double p = h->turn * t;
    (void)err;
    turned(h->Q, (const double[3]){h->R * sin(p), h->R * (1 - cos(p)), h->H * p}, r);
    for (int a = 0; a < 3; a++)
        r[a] += h->origin[a];
    return HOBE_OK;
}

static enum hobe_status helix_twist(void *context, double at, double *phi, struct hobe_error *err)
{
    const struct helix *h = context;
    (void)err;
    *phi = h->twist * at * (1 - 0.5 * at);
    return HOBE_OK;
}

static void random_rotation(double Q[3][3])
{
    double x[3], along = 0, size = 0;
    random_direction(Q[0]);
    random_direction(x);
    for (int a = 0; a < 3; a++)
        along += x[a] * Q[0][a];
    for (int a = 0; a < 3; a++) {
        Q[1][a] = x[a] - along * Q[0][a];
        size = hypot(size, Q[1][a]);
    }
    for (int a = 0; a < 3; a++)
        Q[1][a] /= size;
    for (int a = 0; a < 3; a++)
        Q[2][a] = Q[0][(a + 1) % 3] * Q[1][(a + 2) % 3] - Q[0][(a + 2) % 3] * Q[1][(a + 1) % 3];
}

static double *numbers(int n)
{
    double *p = calloc((size_t)n, sizeof *p);
    if (!p)
        check_stop("out of memory: %d numbers", n);
    return p;
}

/* ---- the general path of an element against the prismatic one -------------------------------- */

static double worst(int n, const double *a, const double *b)
{
    double difference = 0, size = 0;
    for (int i = 0; i < n; i++) {
        difference = fmax(difference, fabs(a[i] - b[i]));
        size = fmax(size, fabs(b[i]));
    }
    return difference / size;
}

/* Force, tangent and mass of two elements that should be one, at a random state.  Rounding of sums
 * of up to 1e5 products. */
static void compare(const hobe_element *general, const hobe_element *plain, const double *q0,
                    const char *what)
{
    const struct hobe_kernel *k = hobe_element_kernel(plain);
    const int V = k->vectors, n = 3 * V;
    double *q = numbers(n), *f[2] = {numbers(n), numbers(n)};
    double *K[2] = {numbers(n * n), numbers(n * n)};
    const hobe_element *both[2] = {general, plain};
    struct hobe_error err;
    for (int i = 0; i < n; i++)
        q[i] = q0[i] + random_real(-0.1, 0.1);
    for (int i = 0; i < 2; i++)
        check_that(!hobe_element_force(both[i], q0, q, f[i], &err) &&
                       !hobe_element_tangent(both[i], q0, q, K[i], &err),
                   "%s, %s: %s", k->name, what, err.message);
    check_absolute(worst(n, f[0], f[1]), 0, 1e-11, "%s, %s: force", k->name, what);
    check_absolute(worst(n * n, K[0], K[1]), 0, 1e-11, "%s, %s: tangent", k->name, what);
    check_absolute(
        worst(V * V, hobe_element_invariants(general)->mass, hobe_element_invariants(plain)->mass),
        0, 1e-11, "%s, %s: mass", k->name, what);
    free(q);
    for (int i = 0; i < 2; i++) {
        free(f[i]);
        free(K[i]);
    }
}

/* A straight reference given as if it were curved, and a taper between two equal ends. */
static void one_kernel(const struct hobe_kernel *kernel, enum hobe_integration integration)
{
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    hobe_section *plain = rectangle(0.1, 0.2),
                 *taper = tapered(rectangle(0.1, 0.2), rectangle(0.1, 0.2));
    struct hobe_element_options options = {.kernel = kernel,
                                           .section = plain,
                                           .material = {E, NU, RHO, 0.9, 0.8, 0},
                                           .length = 0.5,
                                           .integration = integration};
    double *q0 = numbers(3 * kernel->vectors), Q[3][3];
    hobe_element *straight = new_element(&options);
    options.section = taper;
    hobe_element *tapers = new_element(&options);
    check_that(!hobe_element_q0(straight) && hobe_element_q0(tapers), "%s: paths", kernel->name);
    hobe_element_reference(straight, identity, q0);
    compare(tapers, straight, q0, "taper of equal ends");
    random_rotation(Q);
    hobe_element_reference(straight, (const double(*)[3])Q, q0);
    options.q0 = q0;
    for (int i = 0; i < 2; i++) {
        options.section = i ? taper : plain;
        hobe_element *general = new_element(&options);
        compare(general, straight, q0, i ? "taper on a line" : "line");
        hobe_element_free(general);
    }
    hobe_element_free(straight);
    hobe_element_free(tapers);
    free(q0);
    hobe_section_free(plain);
    hobe_section_free(taper);
}

/* ---- beams ----------------------------------------------------------------------------------- */

static struct hobe_beam heavy(struct hobe_beam beam)
{
    beam.material.rho = RHO;
    return beam;
}

/* The tip of a cantilever under F there, and its first mode, without it. */
static struct hobe_point tip_under(const struct hobe_beam *beam, const double F[3],
                                   struct hobe_mode *first)
{
    hobe_model *model = cantilever(beam, 0);
    add_force(model, "beam", 1, F[0], F[1], F[2]);
    hobe_modes *modes = modes_of(model, NULL, 4, HOBE_MODAL_AUTO);
    *first = mode_of(modes, 0);
    hobe_modes_free(modes);
    return tip_of(model, 1);
}

/* A beam through points of a line, with a taper of equal ends: large displacements and the first
 * frequency are those of the plain one.  Rounding times the condition of the stiffness, 1e6. */
static void straight_beam(const char *element)
{
    const double points[4][3] = {{1, 2, 3}, {2, 2.5, 3.5}, {2.5, 2.75, 3.75}, {4, 3.5, 4.5}};
    const double F[3] = {-2e4, 1e5, -1e5};
    hobe_section *plain = rectangle(0.1, 0.2);
    hobe_section *equal = tapered(rectangle(0.1, 0.2), rectangle(0.1, 0.2));
    struct hobe_error err = {0};
    hobe_curve *line = hobe_curve_points(4, points, &err);
    struct hobe_beam beam = heavy(beam_along_x(element, 3, plain, E, NU, 1));
    struct hobe_point tip[3];
    struct hobe_mode first[3];
    check_that(line != NULL, "%s", err.message);
    memcpy(beam.from, points[0], sizeof beam.from);
    memcpy(beam.to, points[3], sizeof beam.to);
    for (int i = 0; i < 3; i++) {
        beam.curve = i ? line : NULL;
        beam.section = i == 2 ? equal : plain;
        tip[i] = tip_under(&beam, F, first + i);
    }
    for (int i = 1; i < 3; i++) {
        check_absolute(distance(tip[i].u, tip[0].u), 0, 1e-9 * norm(tip[0].u), "%s: %s", element,
                       i == 1 ? "line" : "line, equal ends");
        check_absolute(tip[i].twist, tip[0].twist, 1e-9, "%s: twist", element);
        check_absolute(distance(tip[i].r0, tip[0].r0), 0, 1e-14 * norm(tip[0].r0), "r0");
        for (int v = 0; v < 6; v++)
            check_absolute(tip[i].strain[v], tip[0].strain[v], 1e-10, "%s: strain", element);
        check_relative(first[i].omega2, first[0].omega2, 1e-9, "%s: frequency", element);
    }
    hobe_curve_free(line);
    hobe_section_free(plain);
    hobe_section_free(equal);
}

static enum hobe_status quarter_turn(void *context, double at, double *phi, struct hobe_error *err)
{
    (void)context, (void)at, (void)err;
    *phi = M_PI / 2;
    return HOBE_OK;
}

/* Width and height exchanged, and the section turned back by the curve: the same beam, but for
 * rounding times the condition of the stiffness. */
static void turned_section(void)
{
    const double ends[2][3] = {{0, 0, 0}, {2, 0, 0}}, F[3] = {-2e4, 1e5, -1e5};
    hobe_section *upright = rectangle(0.1, 0.2), *flat = rectangle(0.2, 0.1);
    struct hobe_error err = {0};
    hobe_curve *line = hobe_curve_points(2, ends, &err);
    struct hobe_beam beam = heavy(beam_along_x("MGD30w", 4, upright, E, NU, 2));
    struct hobe_mode first[2];
    const struct hobe_point plain = tip_under(&beam, F, first);
    check_that(line && !hobe_curve_twist(line, quarter_turn, NULL, &err), "%s", err.message);
    beam.curve = line;
    beam.section = flat;
    const struct hobe_point turned = tip_under(&beam, F, first + 1);
    check_absolute(distance(turned.u, plain.u), 0, 1e-9 * norm(plain.u), "turned section: u");
    check_relative(first[1].omega2, first[0].omega2, 1e-9, "turned section: frequency");
    hobe_curve_free(line);
    hobe_section_free(upright);
    hobe_section_free(flat);
}

/* A cantilever on the helix whose section varies. */
struct helical {
    struct helix shape;
    hobe_curve *curve;
    hobe_section *section;
    struct hobe_beam beam;
};

static struct helical open_helical(const char *element, int elements, struct helix shape)
{
    static const double Z[3] = {0, 0, 1};
    struct helical h = {.shape = shape};
    h.curve = curve_of(helix_point, helix_twist, &h.shape);
    h.section = tapered(rectangle(0.1, 0.2), rectangle(0.08, 0.06));
    h.beam = heavy(beam_along_x(element, elements, h.section, E, NU, 1));
    h.beam.curve = h.curve;
    turned(shape.Q, Z, h.beam.up);
    return h;
}

static void close_helical(struct helical *h)
{
    hobe_curve_free(h->curve);
    hobe_section_free(h->section);
}

static void forces_of_loads(const hobe_model *model, const double *u, double *r,
                            const struct matrix *K)
{
    load_subtract(model, u, &AT_REST, 0.7, r, K);
}

/* At rest there is no force at all: strains are differences from the reference. */
static void at_rest(const hobe_model *model, const char *element)
{
    double *u = numbers((int)(3 * model->vectors)), *f = numbers((int)(3 * model->vectors));
    double most = 0;
    assemble(model, u, f, NULL);
    for (long i = 0; i < 3 * model->vectors; i++)
        most = fmax(most, fabs(f[i]));
    check_absolute(most, 0, 0, "%s: force at rest", element);
    check_absolute(assemble_energy(model, u), 0, 0, "%s: energy at rest", element);
    free(u);
    free(f);
}

static void tangents(const char *element)
{
    struct helical h = open_helical(element, 2, HELIX);
    hobe_model *model = cantilever(&h.beam, 0);
    check_tangent(model, assemble, 1, element);
    at_rest(model, element);
    hobe_model_free(model);
    model = cantilever(&h.beam, 0);
    add_moment(model, "beam", random_real(0.1, 0.9), 30, 40, 50);
    check_tangent(model, forces_of_loads, 1, "moment on a helix");
    hobe_model_free(model);
    model = cantilever(&h.beam, 0);
    add_follower(model, "beam", random_real(0.1, 0.9), 30, 40, 50);
    check_tangent(model, forces_of_loads, 0, "follower force on a helix");
    hobe_model_free(model);
    close_helical(&h);
}

/* ---- rigid motions --------------------------------------------------------------------------- */

struct response {
    struct hobe_point tip;
    double energy;
};

/* Under a dead and a follower force that turn with the shape. */
static struct response respond(const struct helix *shape)
{
    const double forces[2][3] = {{1e4, -3e4, 2e4}, {-3e4, 2e4, 1e4}};
    struct helical h = open_helical("MGD30w", 6, *shape);
    hobe_model *model = cantilever(&h.beam, 0);
    double F[2][3];
    for (int i = 0; i < 2; i++)
        turned(shape->Q, forces[i], F[i]);
    add_force(model, "beam", 1, F[0][0], F[0][1], F[0][2]);
    add_follower(model, "beam", 0.5, F[1][0], F[1][1], F[1][2]);
    hobe_solution *solution = solve(model, 2);
    const struct response found = {point_of(solution, "beam", 1, 0.01, 0.02),
                                   info_of(solution).energy};
    hobe_solution_free(solution);
    hobe_model_free(model);
    close_helical(&h);
    return found;
}

/* Far away the points of the axis are known to 1e-16 of the distance only, 1e-10 m at 1e6 m, and
 * with them the shape, which slopes and curvature enlarge; the displacements themselves lose
 * nothing. */
static void rigid_motion(double away, double tolerance)
{
    const struct response at_home = respond(&HELIX);
    struct helix moved = HELIX;
    double u[3], rotation[3];
    random_rotation(moved.Q);
    random_direction(moved.origin);
    for (int a = 0; a < 3; a++)
        moved.origin[a] *= away;
    const struct response there = respond(&moved);
    turned(moved.Q, at_home.tip.u, u);
    turned(moved.Q, at_home.tip.rotation, rotation);
    const double size = norm(u);
    printf("%g m away: u by %.1e, energy by %.1e\n", away, distance(u, there.tip.u) / size,
           there.energy / at_home.energy - 1);
    check_absolute(distance(u, there.tip.u), 0, tolerance * size, "turned, %g m away: u", away);
    check_absolute(distance(rotation, there.tip.rotation), 0, tolerance, "turned: rotation");
    check_absolute(there.tip.twist, at_home.tip.twist, tolerance, "turned: twist");
    check_relative(there.energy, at_home.energy, tolerance, "turned: energy");
    for (int v = 0; v < 6; v++)
        check_absolute(there.tip.strain[v], at_home.tip.strain[v], tolerance, "turned: strain");
}

/* ---- laws ------------------------------------------------------------------------------------ */

enum { ON_ARC = 8 }; /* elements */

static struct hobe_point arc_tip(const hobe_curve *curve, const hobe_section *section, int *laws,
                                 double *omega2)
{
    const double F[3] = {5e4, 1e5, 1e5};
    struct hobe_beam beam = heavy(beam_along_x("MGD30w", ON_ARC, section, E, NU, 1));
    struct hobe_mode first;
    beam.curve = curve;
    const struct hobe_point tip = tip_under(&beam, F, &first);
    *omega2 = first.omega2;
    hobe_model *model = cantilever(&beam, 0);
    *laws = model_beam(model, 0)->laws;
    hobe_model_free(model);
    return tip;
}

/* The elements of an arc are congruent.  Those of a spline through 400 places of it, unevenly
 * apart, differ in the slopes by (0.01)^3/24 and less, and each has its own law. */
static void laws(void)
{
    enum { POINTS = 400 };
    const struct helix shape = {.R = 2, .turn = 1.5, .Q = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    struct helix arc = shape;
    struct hobe_error err = {0};
    double r[POINTS][3], omega2[2];
    int count[2];
    for (int i = 0; i < POINTS; i++) {
        const double t = i / (POINTS - 1.);
        helix_point(&arc, t + 0.1 * t * (1 - t), r[i], &err);
    }
    hobe_curve *curve[2] = {curve_of(helix_point, NULL, &arc),
                            hobe_curve_points(POINTS, (const double(*)[3])r, &err)};
    hobe_section *section = rectangle(0.1, 0.2), *taper;
    const struct hobe_point tip[2] = {arc_tip(curve[0], section, count, omega2),
                                      arc_tip(curve[1], section, count + 1, omega2 + 1)};
    printf("laws of an arc: %d, of a spline: %d; tips apart %.1e\n", count[0], count[1],
           distance(tip[0].u, tip[1].u) / norm(tip[0].u));
    check_that(count[0] == 1, "an arc has %d laws", count[0]);
    check_that(count[1] > 1, "a spline has %d laws", count[1]);
    check_absolute(distance(tip[0].u, tip[1].u), 0, 1e-9 * norm(tip[0].u), "arc and spline");
    check_relative(omega2[1], omega2[0], 1e-9, "frequency of arc and spline");
    taper = tapered(rectangle(0.1, 0.2), rectangle(0.1, 0.1));
    arc_tip(curve[0], taper, count, omega2);
    check_that(count[0] == ON_ARC, "tapered elements differ: %d laws", count[0]);
    arc_tip(NULL, section, count, omega2);
    check_that(count[0] == 1, "a straight beam has %d laws", count[0]);
    for (int i = 0; i < 2; i++)
        hobe_curve_free(curve[i]);
    hobe_section_free(section);
    hobe_section_free(taper);
}

/* ---- loads and supports at interior places --------------------------------------------------- */

/* The work of F at 0.4 of the helix on its motion under M at 0.6, or of M on that under F.  At
 * nodes, where the slopes are the frame.  Half the difference of both signs leaves out the second
 * order. */
static double work_on(const struct hobe_beam *beam, const double F[3], const double M[3], int by_F)
{
    double work = 0;
    for (int sign = -1; sign < 2; sign += 2) {
        hobe_model *model = cantilever(beam, 0);
        if (by_F)
            add_moment(model, "beam", 0.6, sign * M[0], sign * M[1], sign * M[2]);
        else
            add_force(model, "beam", 0.4, sign * F[0], sign * F[1], sign * F[2]);
        hobe_solution *solution = solve(model, 1);
        const struct hobe_point p = point_of(solution, "beam", by_F ? 0.4 : 0.6, 0, 0);
        for (int a = 0; a < 3; a++)
            work += sign * (by_F ? F[a] * p.u[a] : M[a] * p.rotation[a]) / 2;
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    return work;
}

/* Betti: force and moment do the same work on each other's motion, of about 1e-7 N m.  The rotation
 * is seen in F to 1e-16; the third order is smaller. */
static void reciprocity(void)
{
    struct helical h = open_helical("MGD30w", 5, HELIX);
    double F[3], M[3];
    random_direction(F);
    random_direction(M);
    for (int a = 0; a < 3; a++) {
        F[a] *= 3;
        M[a] *= 3;
    }
    check_absolute(work_on(&h.beam, F, M, 1), work_on(&h.beam, F, M, 0), 1e-14,
                   "moment and force on a helix");
    close_helical(&h);
}

/* A follower force does the work that the strain energy gains: by central differences in the load,
 * whose error (1e-3)^2 of the curvature of the path the next step, halved, eliminates. */
static double work_ratio(hobe_model *(*make)(const struct hobe_beam *, double),
                         const struct hobe_beam *beam, double h)
{
    double energy[2], u[2][3], work = 0;
    struct hobe_point middle;
    for (int i = 0; i < 3; i++) {
        hobe_model *model = make(beam, 1 + (i - 1) * h);
        hobe_solution *solution = solve(model, 2);
        const struct hobe_point p = point_of(solution, "beam", 0.5, 0, 0);
        if (i == 1)
            middle = p;
        else {
            energy[i / 2] = info_of(solution).energy;
            memcpy(u[i / 2], p.u, sizeof p.u);
        }
        hobe_solution_free(solution);
        hobe_model_free(model);
    }
    /* along the normal of the section, r_y x r_z */
    double n[3];
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        n[a] = middle.F[b][1] * middle.F[c][2] - middle.F[c][1] * middle.F[b][2];
    }
    for (int a = 0; a < 3; a++)
        work += n[a] / norm(n) * (u[1][a] - u[0][a]);
    return (energy[1] - energy[0]) / work;
}

enum { PUSH = 200000 };

/* Pushed against its own axis in the middle. */
static hobe_model *pushed(const struct hobe_beam *beam, double factor)
{
    double r[3], frame[3][3], frame_x[3][3];
    struct hobe_error err = {0};
    hobe_model *model = cantilever(beam, 0);
    if (hobe_curve_at(beam->curve, beam->up, 0.5, r, frame, frame_x, &err))
        check_stop("%s", err.message);
    const double P = PUSH * factor;
    add_follower(model, "beam", 0.5, P * frame[0][0], P * frame[0][1], P * frame[0][2]);
    return model;
}

static void follower_work(void)
{
    struct helical h = open_helical("MGD30w", 2, HELIX);
    const double coarse = work_ratio(pushed, &h.beam, 2e-2),
                 fine = work_ratio(pushed, &h.beam, 1e-2);
    check_relative((4 * fine - coarse) / 3, PUSH, 1e-8, "work of a follower force");
    close_helical(&h);
}

/* Clamped in the middle, the outer half is a beam of its own. */
static void clamped_inside(void)
{
    const double F[3] = {3e4, -5e4, 7e4};
    const struct helix whole = {
        .R = 2, .turn = 2, .H = 0.3, .Q = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    struct helix both = whole, outer = whole;
    const double p = whole.turn / 2, c = cos(p), s = sin(p); /* screwed on by half the angle */
    const struct helix half = {.R = 2,
                               .turn = 1,
                               .H = 0.3,
                               .Q = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}},
                               .origin = {2 * s, 2 * (1 - c), 0.3 * p}};
    outer = half;
    hobe_section *section = rectangle(0.1, 0.2);
    hobe_curve *curve[2] = {curve_of(helix_point, NULL, &both),
                            curve_of(helix_point, NULL, &outer)};
    struct hobe_point tip[2];
    for (int i = 0; i < 2; i++) {
        struct hobe_beam beam = beam_along_x("3433w", i ? 3 : 6, section, E, NU, 1);
        hobe_model *model = new_model();
        beam.curve = curve[i];
        add_beam(model, &beam);
        add_clamp(model, "beam", i ? 0 : 0.5, 0);
        add_force(model, "beam", 1, F[0], F[1], F[2]);
        if (!i)
            add_force(model, "beam", 0, F[2], F[0], F[1]);
        tip[i] = tip_of(model, 1);
        hobe_curve_free(curve[i]);
    }
    check_absolute(distance(tip[0].r0, tip[1].r0), 0, 1e-12, "the tip of both");
    check_absolute(distance(tip[0].u, tip[1].u), 0, 1e-9 * norm(tip[1].u), "clamped inside");
    hobe_section_free(section);
}

int main(void)
{
    static const char *const names[] = {"BE24", "MGD30w", "3333w3", "3433w", "3333s"};
    random_start();
    for (int i = 0; hobe_kernels()[i]; i++) {
        const struct hobe_kernel *kernel = hobe_kernels()[i];
        one_kernel(kernel, HOBE_INTEGRATION_EXACT);
        if (!kernel->axis_rule) /* else it has its own points */
            one_kernel(kernel, HOBE_INTEGRATION_PAPER);
    }
    for (int i = 0; i < 5; i++) {
        straight_beam(names[i]);
        tangents(names[i]);
    }
    turned_section();
    rigid_motion(1, 1e-11);
    rigid_motion(1e6, 1e-8);
    laws();
    reciprocity();
    follower_work();
    clamped_inside();
    return check_report();
}
