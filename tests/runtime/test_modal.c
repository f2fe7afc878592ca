/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies and mode shapes: mass, classical beam theory, solids, prestress, stability,
 * corners, and both methods against each other. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* ---- helpers --------------------------------------------------------------------------------- */

static void shape_at(const hobe_modes *modes, int i, const char *beam, double at, double y,
                     double z, double u[3])
{
    struct hobe_error err;
    if (hobe_modes_point(modes, i, beam, at, y, z, u, &err))
        check_stop("hobe_modes_point: %s", err.message);
}

/* What a mode of a beam along x does most at its end: 'x', 'y', 'z' or 't' (torsion). */
static char kind_of(const hobe_modes *modes, int i, const char *beam, const hobe_section *section)
{
    const struct hobe_section_properties p = properties_of(section);
    double centre[3], corner[3], most = 0;
    char kind = 't';
    shape_at(modes, i, beam, 1, 0, 0, centre);
    shape_at(modes, i, beam, 1, p.width / 2, p.height / 2, corner);
    most = hypot(corner[1] - centre[1], corner[2] - centre[2]);
    for (int a = 0; a < 3; a++)
        if (fabs(centre[a]) > most) {
            most = fabs(centre[a]);
            kind = "xyz"[a];
        }
    return kind;
}

/* The frequency of the n-th mode (from 0) of a kind, rad/s. */
static double frequency(const hobe_modes *modes, const char *beam, const hobe_section *section,
                        char kind, int n)
{
    const int count = modes_info(modes).count;
    for (int i = 0; i < count; i++)
        if (kind_of(modes, i, beam, section) == kind && n-- == 0)
            return mode_of(modes, i).omega;
    check_stop("no such mode of kind %c among %d", kind, count);
}

static struct hobe_beam with_density(struct hobe_beam beam, double rho)
{
    beam.material.rho = rho;
    return beam;
}

static void orthonormal(const hobe_modes *modes, const char *what)
{
    double worst = 0;
    const int count = modes_info(modes).count;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            worst = fmax(worst, fabs(hobe_modes_mass(modes, i, j) - (i == j)));
    /* rounding of sums of some thousand products */
    check_absolute(worst, 0, 1e-10, "%s: Phi'M Phi = 1", what);
}

/* ---- theory ---------------------------------------------------------------------------------- */

/* Roots of cos b cosh b = -1: bending of a cantilever. */
static const double BETA[] = {1.87510406871, 4.69409113297, 7.85475743824};

static double euler(double E, double I, double rho, double A, double L, int n)
{
    return BETA[n] * BETA[n] * sqrt(E * I / (rho * A)) / (L * L);
}

/* Slender, nu = 0: shear and rotary inertia shift the n-th frequency by the order of
 * (beta h / L)^2 (1 + E/(k G)) / 24 (Timoshenko), 1.5e-5 for the first and 2.6e-4 for the third
 * at h/L = 1/100; the mesh of 12 cubic elements is finer than that. */
static void slender(void)
{
    hobe_section *section = rectangle(0.01, 0.02);
    const struct hobe_beam beam =
        with_density(beam_along_x("MGD30w", 12, section, 70e9, 0, 2), 2700);
    hobe_model *model = cantilever(&beam, 0);
    hobe_modes *modes = modes_of(model, NULL, 12, HOBE_MODAL_AUTO);
    const struct hobe_section_properties p = properties_of(section);
    for (int n = 0; n < 3; n++) {
        const double slope = BETA[n] * 0.02 / 2;
        check_relative(frequency(modes, "beam", section, 'y', n),
                       euler(70e9, p.Izz, 2700, p.A, 2, n), slope * slope / 2, "bending %d about z",
                       n + 1);
        check_relative(frequency(modes, "beam", section, 'z', n),
                       euler(70e9, p.Iyy, 2700, p.A, 2, n), slope * slope / 2, "bending %d about y",
                       n + 1);
    }
    orthonormal(modes, "slender");
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* Round-off in ever more slender beams is of the size that the modes say, which is chance: within a
 * factor of ten; and it is said where it passes one in a thousand.  Theory and mesh are closer than
 * 1e-4 of 1000 heights, and a hundredth of that each time. The
 * highest modes are lost in the round-off of the lowest, and are not taken for unstable ones. */
static void round_off(void)
{
    hobe_section *section = rectangle(0.01, 0.02);
    double last = 0;
    for (double length = 10; length < 1e5; length *= 10) {
        const struct hobe_beam beam =
            with_density(beam_along_x("MGD30w", 12, section, 70e9, 0, length), 2700);
        hobe_model *model = cantilever(&beam, 0);
        hobe_modes *modes = modes_of(model, NULL, 2, HOBE_MODAL_DENSE);
        const double share = modes_info(modes).round_off;
        const double exact = euler(70e9, 2e-8 / 12, 2700, 2e-4, length, 0);
        const double error = fabs(mode_of(modes, 0).omega2 / (exact * exact) - 1);
        check_that(error < 10 * share + 1e-2 / (length * length), "%g m: round-off %g, error %g",
                   length, share, error);
        check_that(share > 5 * last, "%g m: more round-off, %g", length, share);
        const char *note = hobe_modes_note(modes);
        check_that((note && strstr(note, "rounding")) == (share > 1e-3), "%g m: said", length);
        check_that(modes_info(modes).unstable == 0, "%g m: stable", length);
        last = share;
        hobe_modes_free(modes);
        hobe_model_free(model);
    }
    hobe_section_free(section);
}

/* With warping and axial stretch free at the clamp the ends of a bar agree with bar theory:
 * axial (2n-1) pi/(2L) sqrt(E/rho), torsion (2n-1) pi/(2L) sqrt(G J/(rho I_p)).  nu = 0: no lateral
 * inertia, whose share else is (nu pi r/L)^2.  The warping inertia and restraint of the vibrating
 * bar are of the order (h/L)^2 = 2.5e-5 of the first and nine times that of the second. */
static void bar(void)
{
    const double E = 210e9, rho = 7850, L = 10;
    hobe_section *section = rectangle(0.05, 0.05);
    const struct hobe_beam beam = with_density(beam_along_x("MGD30w", 10, section, E, 0, L), rho);
    hobe_model *model = cantilever(&beam, 1);
    hobe_modes *modes = modes_of(model, NULL, 60, HOBE_MODAL_DENSE);
    const struct hobe_section_properties p = properties_of(section);
    const double axial = PI / (2 * L) * sqrt(E / rho);
    const double torsion = PI / (2 * L) * sqrt(E / 2 * p.J_w / (rho * (p.Iyy + p.Izz)));
    for (int n = 0; n < 2; n++) {
        const int odd = 2 * n + 1;
        check_relative(frequency(modes, "beam", section, 'x', n), odd * axial, 1e-5 * odd * odd,
                       "axial %d", n + 1);
        check_relative(frequency(modes, "beam", section, 't', n), odd * torsion, 2.5e-5 * odd * odd,
                       "torsion %d", n + 1);
    }
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- the square beam of Tang et al. 2022, Fig. 7 (b) ----------------------------------------- */

static double square_frequency(int elements, enum hobe_mechanics mechanics,
                               enum hobe_integration integration, char kind)
{
    hobe_section *section = rectangle(0.1, 0.1);
    struct hobe_beam beam =
        with_density(beam_along_x("MGD30w", elements, section, 1e9, 0.3, 2), 7850);
    beam.mechanics = mechanics;
    beam.integration = integration;
    hobe_model *model = cantilever(&beam, 0);
    hobe_modes *modes = modes_of(model, NULL, 10, HOBE_MODAL_AUTO);
    const double omega = frequency(modes, "beam", section, kind, 0);
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
    return omega;
}

static void square(void)
{
    static const struct {
        int elements;
        double omega;
    } paper[] = {{1, 9.088}, {10, 9.041}, {50, 9.041}};
    /* An independent prototype: half of the last digit.  One element apart: there its mass matrix,
     * with three points on the axis, is lighter than the exact one. */
    for (int i = 0; i < 3; i++)
        check_absolute(
            square_frequency(paper[i].elements, HOBE_MECHANICS_AXIS, HOBE_INTEGRATION_PAPER, 'z'),
            paper[i].omega, i == 0 ? 3e-3 : 5e-4, "paper settings, %d elements", paper[i].elements);
    /* a converged solid model; the beam holds the clamped face and shear a little differently */
    check_relative(square_frequency(20, HOBE_MECHANICS_DEFAULT, HOBE_INTEGRATION_EXACT, 'z'), 9.060,
                   5e-3, "bending of the solid");
    check_relative(square_frequency(20, HOBE_MECHANICS_DEFAULT, HOBE_INTEGRATION_EXACT, 't'),
                   159.78, 5e-3, "torsion of the solid");
}

/* Conforming elements converge from above; cubic ones with the sixth power for bending. */
static void convergence(void)
{
    double omega[4];
    for (int i = 0; i < 4; i++)
        omega[i] = square_frequency(1 << i, HOBE_MECHANICS_DEFAULT, HOBE_INTEGRATION_EXACT, 'z');
    for (int i = 0; i < 3; i++)
        check_that(omega[i] > omega[i + 1], "finer is softer: %.12g, %.12g", omega[i],
                   omega[i + 1]);
    check_that(omega[2] - omega[3] < (omega[1] - omega[2]) / 8,
               "and the steps shrink by more than 8 (third order at least): %.3g, %.3g",
               omega[1] - omega[2], omega[2] - omega[3]);
}

/* ---- mass ------------------------------------------------------------------------------------ */

/* All modes together carry the mass, less what the support takes: the held node's share, here of
 * the order of the sixth part of one of 10 elements.  Every direction has the same. */
static void mass(void)
{
    hobe_section *section = rectangle(0.1, 0.1);
    const struct hobe_beam beam =
        with_density(beam_along_x("MGD30", 10, section, 1e9, 0.3, 2), 7850);
    hobe_model *model = cantilever(&beam, 0);
    hobe_modes *modes = modes_of(model, NULL, 1, HOBE_MODAL_DENSE);
    const long all = modes_info(modes).unknowns;
    hobe_modes_free(modes);
    modes = modes_of(model, NULL, (int)all, HOBE_MODAL_DENSE);
    const double rho_A_L = 7850 * 0.01 * 2;
    double sum[3] = {0};
    for (int i = 0; i < all; i++)
        for (int a = 0; a < 3; a++)
            sum[a] += mode_of(modes, i).effective_mass[a];
    check_relative(modes_info(modes).mass, rho_A_L, 1e-13, "rho A L");
    for (int a = 0; a < 3; a++) {
        check_that(sum[a] < rho_A_L && sum[a] > 0.95 * rho_A_L,
                   "effective masses along %c: %.6g of %.6g kg", "xyz"[a], sum[a], rho_A_L);
        check_relative(sum[a], sum[0], 1e-8, "the same along %c", "xyz"[a]);
    }
    /* the first bending mode of a uniform cantilever carries 0.613 of the mass; shear: h/L = 1/20
     */
    const struct hobe_mode first = mode_of(modes, 0);
    check_relative(first.effective_mass[1] + first.effective_mass[2], 0.6131 * rho_A_L, 3e-3,
                   "the first mode's share");
    orthonormal(modes, "all modes");
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- prestress ------------------------------------------------------------------------------- */

/* Cantilever of bending stiffness 1, mass 1 and length 1 under the dead tension T at its tip: zero
 * where omega is a frequency.  Shapes cosh ax - cos bx and sinh ax / a - sin bx / b with
 * a^2 - b^2 = T, a b = omega; at the tip w'' = 0 and w''' = T w'. */
static double tension_determinant(double T, double omega)
{
    const double root = sqrt(T * T / 4 + omega * omega);
    const double a = sqrt(root + T / 2), b = sqrt(root - T / 2);
    const double ch = cosh(a), sh = sinh(a), c = cos(b), s = sin(b);
    return (a * a * ch + b * b * c) * (b * b * ch + a * a * c) -
           (a * sh + b * s) * (a * b * b * sh - a * a * b * s);
}

/* The first root of f(parameter, x) above 0. */
static double first_root(double (*f)(double, double), double parameter, double step)
{
    double low = step, high = 2 * step;
    while (f(parameter, low) * f(parameter, high) > 0) {
        low = high;
        high += step;
    }
    for (int i = 0; i < 60; i++) {
        const double middle = (low + high) / 2;
        *(f(parameter, low) * f(parameter, middle) > 0 ? &low : &high) = middle;
    }
    return low;
}

/* A slender cantilever, 10 x 20 mm, under `tension` times its Euler load of the weak direction. */
struct column {
    hobe_section *section;
    hobe_model *model;
    hobe_solution *solution;
    double unit; /* sqrt(EI / (rho A)) / L^2 of the weak direction, rad/s */
};

static struct column open_column(double tension, int elements)
{
    const double E = 70e9, rho = 2700, L = 2;
    struct column c = {.section = rectangle(0.01, 0.02)};
    const struct hobe_section_properties p = properties_of(c.section);
    const double euler_load = PI * PI * E * p.Izz / (4 * L * L);
    const struct hobe_beam beam =
        with_density(beam_along_x("MGD30w", elements, c.section, E, 0, L), rho);
    c.model = cantilever(&beam, 0);
    add_force(c.model, "beam", 1, tension * euler_load, 0, 0);
    c.solution = solve(c.model, 1);
    c.unit = sqrt(E * p.Izz / (rho * p.A)) / (L * L);
    return c;
}

static void close_column(struct column *c)
{
    hobe_solution_free(c->solution);
    hobe_model_free(c->model);
    hobe_section_free(c->section);
}

/* Against the beam-column; shear, rotary inertia, axial strain: (h/L)^2 = 2.5e-5 and less,
 * magnified as omega^2 nears zero. */
static void prestress(void)
{
    static const double tensions[] = {4, 1, 0, -0.5, -0.9};
    for (int i = 0; i < 5; i++) {
        struct column c = open_column(tensions[i], 12);
        hobe_modes *modes = modes_of(c.model, c.solution, 2, HOBE_MODAL_AUTO);
        const double exact =
            c.unit * first_root(tension_determinant, tensions[i] * PI * PI / 4, 0.02);
        check_relative(mode_of(modes, 0).omega, exact, 2e-4, "tension %g of Euler's load",
                       tensions[i]);
        check_that(!hobe_modes_note(modes) && modes_info(modes).unstable == 0, "stable");
        hobe_modes_free(modes);
        modes = modes_of(c.model, NULL, 1, HOBE_MODAL_AUTO);
        check_relative(mode_of(modes, 0).omega, c.unit * BETA[0] * BETA[0], 2e-4,
                       "the reference does not feel the load");
        hobe_modes_free(modes);
        close_column(&c);
    }
}

/* Straight under 10 times Euler's load of the weak direction: there the first (1) and second (9)
 * critical loads are passed, in the strong direction the first (4).  Both methods say so, however
 * few modes are wanted, and agree. */
static void unstable(void)
{
    struct column c = open_column(-10, 12);
    double dense[5];
    for (int method = HOBE_MODAL_DENSE; method <= HOBE_MODAL_LANCZOS; method++)
        for (int count = 5; count >= 1; count -= 4) {
            hobe_modes *modes = modes_of(c.model, c.solution, count, method);
            check_that(modes_info(modes).unstable == 3, "method %d, %d wanted: %d unstable modes",
                       method, count, modes_info(modes).unstable);
            check_that(hobe_modes_note(modes) && strstr(hobe_modes_note(modes), "3 modes"),
                       "the note counts them");
            for (int i = 0; i < count; i++) {
                const struct hobe_mode mode = mode_of(modes, i);
                check_that((mode.omega2 < 0) == (i < 3) && !isnan(mode.omega) == (i >= 3),
                           "omega^2 = %g of mode %d", mode.omega2, i);
                if (method == HOBE_MODAL_DENSE && count == 5)
                    dense[i] = mode.omega2;
                else
                    check_relative(mode.omega2, dense[i], 1e-8, "method %d, mode %d", method, i);
            }
            orthonormal(modes, "unstable");
            hobe_modes_free(modes);
        }
    close_column(&c);
}

/* ---- both methods ---------------------------------------------------------------------------- */

/* A bent and twisted state under forces and a moment, and a square section at rest, whose modes
 * come in pairs. */
static void methods_agree(int loaded)
{
    hobe_section *section = rectangle(0.02, loaded ? 0.04 : 0.02);
    const struct hobe_beam beam =
        with_density(beam_along_x("MGD30w", 20, section, 210e9, 0.3, 1), 7850);
    hobe_model *model = cantilever(&beam, 0);
    add_force(model, "beam", 1, 0, 2000, -3000);
    add_moment(model, "beam", 0.5, 300, 0, 0);
    hobe_solution *solution = loaded ? solve(model, 4) : NULL;
    hobe_modes *dense = modes_of(model, solution, 12, HOBE_MODAL_DENSE);
    hobe_modes *lanczos = modes_of(model, solution, 12, HOBE_MODAL_LANCZOS);
    for (int i = 0; i < 12; i++)
        check_relative(mode_of(lanczos, i).omega, mode_of(dense, i).omega, 1e-9,
                       "Lanczos beside dense, mode %d", i);
    orthonormal(dense, "dense");
    orthonormal(lanczos, "Lanczos");
    for (int i = 0; i < 12 && loaded; i++) { /* no twins here: the shapes agree too */
        double a[3], b[3];
        shape_at(dense, i, "beam", 0.7, 0.003, 0.004, a);
        shape_at(lanczos, i, "beam", 0.7, 0.003, 0.004, b);
        check_absolute(distance(a, b), 0, 1e-6, "shape of mode %d", i);
    }
    hobe_modes_free(dense);
    hobe_modes_free(lanczos);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- stiffness of a loaded state ------------------------------------------------------------- */

/* Two arms, the outer at an angle where `corner`, under a force and a moment that bend and twist
 * them by some tenths of a radian, and `extra` in one direction at the tip. */
static hobe_model *loaded_arms(hobe_section *section, int corner, int direction, double extra)
{
    struct hobe_beam beam = with_density(beam_along_x("MGD30w", 2, section, 5e9, 0.3, 1), 1000);
    double force[3] = {-20, 60, -90};
    hobe_model *model = cantilever(&beam, 0);
    beam.name = "outer";
    beam.from[0] = 1;
    beam.to[0] = corner ? 1.5 : 2;
    beam.to[1] = corner ? 0.8 : 0;
    add_beam(model, &beam);
    add_join(model, "beam", 1, "outer", 0);
    force[direction] += extra;
    add_force(model, "outer", 1, force[0], force[1], force[2]);
    add_moment(model, "outer", 1, 60, 40, -50);
    return model;
}

static double tip_movement(hobe_section *section, int corner, int direction, double extra)
{
    hobe_model *model = loaded_arms(section, corner, direction, extra);
    hobe_solution *solution = solve(model, 4);
    const double u = point_of(solution, "outer", 1, 0, 0).u[direction];
    hobe_solution_free(solution);
    hobe_model_free(model);
    return u;
}

/* All modes together hold the whole tangent: sum_i phi_i phi_i / omega_i^2 at the tip is its
 * flexibility there, which statics gives by differences.  This sees prestress, the stiffness of
 * loads, and that of a strained corner.  The step moves the tip by 1e-4 of its way, so that
 * curvature (1e-8) and rounding (1e-12 of the way) stay below 1e-6; with a corner the lowest 60
 * modes of about 100 are asked for, the others are stiff. */
static void flexibility(int corner)
{
    hobe_section *section = rectangle(0.03, 0.05);
    hobe_model *model = loaded_arms(section, corner, 0, 0);
    hobe_solution *solution = solve(model, 4);
    hobe_modes *modes = modes_of(model, solution, 1, HOBE_MODAL_AUTO);
    const long unknowns = modes_info(modes).unknowns;
    hobe_modes_free(modes);
    modes = modes_of(model, solution, corner ? 60 : (int)unknowns, HOBE_MODAL_AUTO);
    for (int a = 0; a < 3; a++) {
        double sum = 0, u[3];
        for (int i = 0; i < modes_info(modes).count; i++) {
            shape_at(modes, i, "outer", 1, 0, 0, u);
            sum += u[a] * u[a] / mode_of(modes, i).omega2;
        }
        const double difference =
            tip_movement(section, corner, a, 0.01) - tip_movement(section, corner, a, -0.01);
        check_relative(sum, difference / 0.02, 1e-6, "flexibility along %c%s", "xyz"[a],
                       corner ? " behind a corner" : "");
    }
    hobe_modes_free(modes);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- corners --------------------------------------------------------------------------------- */

/* Two equal inextensible arms at a right angle, the first clamped, vibrating in their plane: zero
 * where b = beta L belongs to a frequency.  The first arm carries the second's mass at its end; the
 * second is simply supported there; slopes and moments agree. */
static double frame_determinant(double unused, double b)
{
    (void)unused;
    const double ch = cosh(b), sh = sinh(b), c = cos(b), s = sin(b);
    /* second arm p (cosh - cos) + q sinh + sin, free end */
    const double det = (ch + c) * ch - sh * (sh - s);
    const double p = (s * ch - sh * c) / det, q = ((ch + c) * c - (sh - s) * s) / det;
    /* first arm P (cosh - cos) + Q (sinh - sin), third derivative -b w at its end */
    const double P = ch + c + b * (sh - s), Q = -(sh - s + b * (ch - c));
    const double slope = P * (sh + s) + Q * (ch - c), moment = P * (ch + c) + Q * (sh + s);
    return moment * (q + 1) - 2 * p * slope;
}

static hobe_model *frame(hobe_section *section, int elements)
{
    struct hobe_beam beam =
        with_density(beam_along_x("MGD30", elements, section, 70e9, 0, 1), 2700);
    hobe_model *model = new_model();
    beam.name = "first";
    add_beam(model, &beam);
    beam.name = "second";
    beam.from[0] = beam.to[0] = beam.to[2] = 1;
    add_beam(model, &beam);
    add_clamp(model, "first", 0, 0);
    add_join(model, "first", 1, "second", 0);
    return model;
}

/* Slender arms (h/L = 1/100): theory to the order of 1e-4. */
static void corner(void)
{
    hobe_section *section = rectangle(0.02, 0.01);
    const struct hobe_section_properties p = properties_of(section);
    hobe_model *model = frame(section, 8);
    hobe_modes *modes = modes_of(model, NULL, 6, HOBE_MODAL_AUTO);
    double omega = 0, tip[3];
    check_that(modes_info(modes).method == HOBE_MODAL_LANCZOS, "corners are left to Lanczos");
    check_that(modes_info(modes).unstable == 0, "a frame at rest is stable: %d",
               modes_info(modes).unstable);
    for (int i = 5; i >= 0; i--) {
        shape_at(modes, i, "second", 1, 0, 0, tip);
        if (fabs(tip[1]) < 0.1 * norm(tip))
            omega = mode_of(modes, i).omega;
    }
    const double b = first_root(frame_determinant, 0, 0.01);
    check_relative(omega, b * b * sqrt(70e9 * p.Iyy / (2700 * p.A)), 5e-4,
                   "in the plane of the frame");
    orthonormal(modes, "frame");
    hobe_modes_free(modes);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* A straight beam, 2 m long and 50 x 50 mm, whose outer half has its axes turned: the joint becomes
 * a corner. */
static hobe_model *turned(hobe_section *section)
{
    struct hobe_beam beam = with_density(beam_along_x("MGD30w", 6, section, 70e9, 0.3, 1), 2700);
    hobe_model *model = new_model();
    beam.name = "inner";
    add_beam(model, &beam);
    beam.name = "beam";
    beam.from[0] = 1;
    beam.to[0] = 2;
    beam.up[1] = 1;
    add_beam(model, &beam);
    add_clamp(model, "inner", 0, 0);
    add_join(model, "inner", 1, "beam", 0);
    return model;
}

/* The corner lets the section there strain but must keep the frequencies. */
static void straight_corner(void)
{
    hobe_section *section = rectangle(0.05, 0.05);
    hobe_model *model = turned(section), *whole;
    const struct hobe_beam both =
        with_density(beam_along_x("MGD30w", 12, section, 70e9, 0.3, 2), 2700);
    whole = cantilever(&both, 0);
    hobe_modes *modes = modes_of(model, NULL, 4, HOBE_MODAL_AUTO);
    hobe_modes *expected = modes_of(whole, NULL, 4, HOBE_MODAL_AUTO);
    for (int i = 0; i < 4; i++) /* the local strain at the joint: a hundredth of h/L */
        check_relative(mode_of(modes, i).omega, mode_of(expected, i).omega, 5e-4,
                       "straight with a corner, mode %d", i);
    hobe_modes_free(modes);
    hobe_modes_free(expected);
    hobe_model_free(model);
    hobe_model_free(whole);
    hobe_section_free(section);
}

/* The same under five times Euler's load: both planes have passed their first critical load (1) and
 * not their second (9).  One mode is wanted, and two are told. */
static void unstable_corner(void)
{
    hobe_section *section = rectangle(0.05, 0.05);
    hobe_model *model = turned(section);
    add_force(model, "beam", 1, -5 * PI * PI * 70e9 * properties_of(section).Iyy / 16, 0, 0);
    hobe_solution *solution = solve(model, 1);
    hobe_modes *modes = modes_of(model, solution, 1, HOBE_MODAL_AUTO);
    check_that(modes_info(modes).unstable == 2 && mode_of(modes, 0).omega2 < 0,
               "%d unstable modes, omega^2 = %g", modes_info(modes).unstable,
               mode_of(modes, 0).omega2);
    hobe_modes_free(modes);
    hobe_solution_free(solution);
    hobe_model_free(model);
    hobe_section_free(section);
}

/* ---- what is refused ------------------------------------------------------------------------- */

static void refused(hobe_model *model, const hobe_solution *state, int modes,
                    enum hobe_modal_method method, enum hobe_status expected, const char *words)
{
    struct hobe_error err = {0};
    hobe_modes *found;
    const struct hobe_modal_options options = {.modes = modes, .method = method};
    const enum hobe_status status = hobe_modal(model, state, &options, &found, &err);
    check_that(status == expected && !found && strstr(err.message, words), "%s: %d, %s", words,
               status, status ? err.message : "accepted");
    hobe_modes_free(found);
}

static void errors(void)
{
    hobe_section *section = rectangle(0.02, 0.04);
    struct hobe_beam beam = beam_along_x("MGD30", 2, section, 70e9, 0.3, 1);
    hobe_model *model = cantilever(&beam, 0);
    refused(model, NULL, 1, HOBE_MODAL_AUTO, HOBE_BAD_INPUT, "density");
    hobe_model_free(model);
    beam.material.rho = 2700;
    model = cantilever(&beam, 0);
    add_follower(model, "beam", 1, 0, 0, 100);
    hobe_solution *solution = solve(model, 1);
    refused(model, solution, 1, HOBE_MODAL_AUTO, HOBE_BAD_INPUT, "follower");
    refused(model, NULL, -1, HOBE_MODAL_AUTO, HOBE_BAD_INPUT, "the 36");
    refused(model, NULL, 37, HOBE_MODAL_AUTO, HOBE_BAD_INPUT, "the 36");
    refused(model, NULL, 36, HOBE_MODAL_LANCZOS, HOBE_BAD_INPUT, "at most 35");
    hobe_model *other = frame(section, 1);
    refused(other, solution, 1, HOBE_MODAL_AUTO, HOBE_BAD_INPUT, "another scene");
    refused(other, NULL, 1, HOBE_MODAL_DENSE, HOBE_BAD_INPUT, "corners");
    hobe_modes *modes = modes_of(model, NULL, 2, HOBE_MODAL_AUTO); /* at rest it does no harm */
    struct hobe_error err;
    struct hobe_mode mode;
    double u[3];
    check_that(hobe_modes_mode(modes, 2, &mode, &err) && strstr(err.message, "no mode 2"),
               "no third mode");
    check_that(hobe_modes_point(modes, 0, "bean", 0, 0, 0, u, &err) == HOBE_UNKNOWN,
               "no such beam");
    check_that(hobe_modes_point(modes, 0, "beam", 2, 0, 0, u, &err) == HOBE_BAD_INPUT,
               "no such place");
    check_that(isnan(hobe_modes_mass(modes, 0, 2)), "nor a product with a third mode");
    hobe_modes_free(modes);
    hobe_modes_free(NULL);
    hobe_solution_free(solution);
    hobe_model_free(other);
    hobe_model_free(model);
    hobe_section_free(section);
}

int main(void)
{
    slender();
    round_off();
    bar();
    square();
    convergence();
    mass();
    prestress();
    unstable();
    methods_agree(0);
    methods_agree(1);
    flexibility(0);
    flexibility(1);
    corner();
    straight_corner();
    unstable_corner();
    errors();
    return check_report();
}
