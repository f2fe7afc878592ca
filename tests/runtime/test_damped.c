/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damped motions in closed form: oscillators on springs with dampers, a bar of viscous material
 * under a load that begins at once, free flight against mass damping; and a beam that turns, which
 * viscous stress must not hold back.  Values of two steps h and h/2 are extrapolated: generalised
 * alpha is of second order, and what is left is of the third. */
#include "check.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>

static const double PI = 3.14159265358979323846;

static const double E = 70e9, RHO = 2700, LENGTH = 0.4, WIDTH = 0.1, HEIGHT = 0.06;

/* The motion from the reference, rho_inf = 1. */
static hobe_history *move(hobe_model *model, double to, double step)
{
    struct hobe_error err;
    hobe_history *history;
    const struct hobe_dynamic options = {.to = to, .step = step, .rho = 1, .store = to};
    if (hobe_dynamic(model, &options, &history, &err))
        check_stop("%s", err.message);
    return history;
}

/* Where the end of the beam is, the twist included, at a time reached in so many steps. */
static void end_at(hobe_model *model, double to, int steps, double end[4])
{
    hobe_history *history = move(model, to, to / steps);
    struct hobe_history_info info;
    hobe_history_info(history, &info);
    const struct hobe_point point =
        point_of(hobe_history_state(history, info.states - 1), "beam", 1, 0, 0);
    for (int a = 0; a < 3; a++)
        end[a] = point.u[a];
    end[3] = point.twist;
    hobe_history_free(history);
}

static void extrapolate(hobe_model *model, double to, int steps, double end[4])
{
    double coarse[4];
    end_at(model, to, steps, coarse);
    end_at(model, to, 2 * steps, end);
    for (int a = 0; a < 4; a++)
        end[a] += (end[a] - coarse[a]) / 3;
}

/* From rest, x'' + 2 zeta omega x' + omega^2 x = omega^2. */
static double response(double omega, double zeta, double t)
{
    const double along = sqrt(1 - zeta * zeta);
    return 1 - exp(-zeta * omega * t) *
                   (cos(along * omega * t) + zeta / along * sin(along * omega * t));
}

static struct hobe_beam damped_beam(const hobe_section *section, int elements, double mass,
                                    double stiffness)
{
    struct hobe_beam beam = beam_along_x("MGD30w", elements, section, E, 0, LENGTH);
    beam.material.rho = RHO;
    beam.damping = (struct hobe_damping){mass, stiffness};
    return beam;
}

static void add_spring(hobe_model *model, const struct hobe_spring *spring)
{
    struct hobe_error err;
    if (hobe_model_spring(model, spring, &err))
        check_stop("%s", err.message);
}

/* A stiff bar that springs let move along x, across and about x: its mass or inertia is I, and the
 * damper half the critical one.  The bar itself gives way by 1e-7 of what springs do. */
static void check_springs(const hobe_section *section)
{
    const double k = 10, m = RHO * LENGTH * WIDTH * HEIGHT;
    const double I = m * (WIDTH * WIDTH + HEIGHT * HEIGHT) / 12, zeta = 0.5;
    const double omega = sqrt(2 * k / m), omega_x = sqrt(k / I), c = zeta * omega * m;
    const struct hobe_beam beam = damped_beam(section, 2, 0, 0);
    hobe_model *model = new_model();
    double end[4];
    add_beam(model, &beam);
    for (int i = 0; i < 2; i++) /* along x a length; across, bushings */
        add_spring(model, &(struct hobe_spring){.beam = {"beam"},
                                                .at = {i},
                                                .kind = HOBE_SPRING_BUSHING,
                                                .stiffness = {0, k, k},
                                                .damping = {0, c, 0}});
    add_spring(model, &(struct hobe_spring){
                          .beam = {"beam"}, .stiffness = {2 * k}, .damping = {2 * c}, .to = {-3}});
    add_spring(model, &(struct hobe_spring){.beam = {"beam"},
                                            .at = {0.5},
                                            .kind = HOBE_SPRING_TORSION,
                                            .stiffness = {k},
                                            .damping = {2 * zeta * k / omega_x},
                                            .axis = {1, 0, 0}});
    add_force(model, "beam", 0.5, 1e-3, 1e-3, 1e-3);
    add_moment(model, "beam", 0.5, 1e-3, 0, 0);
    extrapolate(model, 0.4 * PI / omega, 300, end);
    const double x = 1e-3 / (2 * k), t = 0.4 * PI / omega;
    check_relative(end[0], x * response(omega, zeta, t), 1e-5, "a length with a damper");
    check_relative(end[1], x * response(omega, zeta, t), 1e-5, "bushings with dampers");
    check_relative(end[2], x * response(omega, 0, t), 1e-5, "bushings without");
    check_relative(end[3], 1e-3 / k * response(omega_x, zeta, t), 1e-5, "torsion with a damper");
    hobe_model_free(model);
}

/* The load F at the end of a bar, clamped at 0: u(L, t) = F L/E A - sum 2 F/(rho A L omega_n^2) (1
 * - response_n), omega_n = (2 n - 1) pi/2 sqrt(E/rho)/L, zeta_n = (alpha/omega_n + tau omega_n)/2.
 * Those that are damped more than critically have come to rest. */
static void check_bar(const hobe_section *section, double alpha, double tau)
{
    const double first = PI / 2 * sqrt(E / RHO) / LENGTH, t = 5 * PI / first, F = 1;
    const double area = WIDTH * HEIGHT;
    const struct hobe_beam beam = damped_beam(section, 6, alpha * first, tau / first);
    hobe_model *model = cantilever(&beam, 1);
    double end[4], expected = F * LENGTH / (E * area), omega = first, zeta;
    add_force(model, "beam", 1, F, 0, 0);
    while ((zeta = (alpha * first / omega + tau * omega / first) / 2) < 1) {
        expected -= 2 * F / (RHO * area * LENGTH * omega * omega) * (1 - response(omega, zeta, t));
        omega += 2 * first;
    }
    extrapolate(model, t, 800, end);
    check_relative(end[0], expected, 1e-6, "bar with damping %g, %g", alpha, tau);
    hobe_model_free(model);
}

/* v = v0 exp(-alpha t) of what flies freely, while it turns. */
static void check_flight(const hobe_section *section)
{
    struct hobe_error err;
    const double alpha = 2, t = 0.3;
    const struct hobe_motion motion = {.velocity = {3, 1, 0}, .angular_velocity = {0, 0, 4}};
    double lost[2], turned[2];
    for (int i = 0; i < 2; i++) {
        const struct hobe_beam beam = damped_beam(section, 2, alpha, 1e-5);
        hobe_model *model = new_model();
        add_beam(model, &beam);
        if (hobe_model_motion(model, &motion, &err))
            check_stop("%s", err.message);
        hobe_history *history = move(model, t, t / (i ? 400 : 200));
        struct hobe_history_info info;
        hobe_history_info(history, &info);
        const struct hobe_energies *first = hobe_history_energies(history, 0);
        const struct hobe_energies *last = hobe_history_energies(history, info.states - 1);
        lost[i] = last->momentum[0] / first->momentum[0];
        turned[i] = last->angular_momentum[2] / first->angular_momentum[2];
        check_absolute(last->balance / first->kinetic, 0, 1e-5, "flight: energy that was taken");
        hobe_history_free(history);
        hobe_model_free(model);
    }
    check_relative((4 * lost[1] - lost[0]) / 3, exp(-alpha * t), 1e-7, "flight: momentum");
    check_relative((4 * turned[1] - turned[0]) / 3, exp(-alpha * t), 1e-7,
                   "flight: angular momentum");
}

/* A beam that turns freely: viscous stress damps its vibrations, but has no moment. */
static void check_turning(const hobe_section *section)
{
    struct hobe_error err;
    const double t = 0.05;
    const struct hobe_beam beam = damped_beam(section, 2, 0, 1e-5);
    const struct hobe_motion motion = {.angular_velocity = {3, 5, 60}};
    hobe_model *model = new_model();
    add_beam(model, &beam);
    if (hobe_model_motion(model, &motion, &err))
        check_stop("%s", err.message);
    hobe_history *history = move(model, t, t / 400);
    struct hobe_history_info info;
    hobe_history_info(history, &info);
    const struct hobe_energies *first = hobe_history_energies(history, 0);
    const struct hobe_energies *last = hobe_history_energies(history, info.states - 1);
    for (int a = 0; a < 3; a++)
        check_absolute(last->angular_momentum[a] - first->angular_momentum[a], 0,
                       1e-5 * fabs(first->angular_momentum[2]), "turning: angular momentum %c",
                       "xyz"[a]);
    check_that(last->damped > 0 && last->damped < 1e-3 * first->kinetic, "turning loses little: %g",
               last->damped / first->kinetic);
    check_that((double)info.iterations < 4.0 * (double)info.steps,
               "turning: %ld iterations of %ld steps", info.iterations, info.steps);
    printf("turning: %ld iterations, %ld steps, L %g damped %g\n", info.iterations, info.steps,
           last->angular_momentum[2] / first->angular_momentum[2] - 1,
           last->damped / first->kinetic);
    hobe_history_free(history);
    hobe_model_free(model);
}

int main(void)
{
    hobe_section *section = rectangle(WIDTH, HEIGHT);
    check_springs(section);
    check_bar(section, 0, 0.2);
    check_bar(section, 0.1, 0.1);
    check_flight(section);
    check_turning(section);
    hobe_section_free(section);
    return check_report();
}
