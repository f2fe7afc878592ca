/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solver verbs and their results. */
#define _GNU_SOURCE
#include "advise.h"
#include "lua_item.h"

#include <math.h>
#include <string.h>

struct result {              /* its user value is the scene */
    hobe_solution *solution; /* first: KEY_RESULT reads it */
    const hobe_model *model;
};

/* ---- Newton's log --------------------------------------------------------------------------- */

/* What the solver tells us as it goes.  The core must not be left by an error of Lua, so that
 * nothing here calls Lua. */
struct watch {
    struct hobe_lua *context;
    int log;      /* write each iteration to stderr */
    int shown;    /* a progress line stands on the terminal */
    double since; /* when it was last renewed, s */
};

static void write_row(struct hobe_text *text, int solve, const struct hobe_iteration *it)
{
    if (text->size == 0)
        hobe_text_add(text, "solve,step,iteration,load,residual,energy,line,note\n");
    hobe_text_add(text, "%d,%d,%d,%.6g,%.6g,%.6g,%.6g,", solve, it->step, it->iteration, it->load,
                  it->residual, it->energy, it->line);
    hobe_text_csv(text, it->note ? it->note : "");
    hobe_text_bytes(text, "\n", 1);
}

static void watch_iteration(void *p, const struct hobe_iteration *it)
{
    struct watch *watch = p;
    if (watch->context->program && watch->context->folder)
        write_row(&watch->context->newton, watch->context->solves, it);
    if (watch->log) {
        const char *note = it->note ? it->note : "";
        fprintf(stderr, "%5d %5d %9.6f %10.3e %10.3e %6.3f%s%s\n", it->step, it->iteration,
                it->load, it->residual, it->energy, it->line, *note ? "  " : "", note);
    } else if (watch->context->progress && hobe_lua_now() - watch->since > 0.2) {
        fprintf(stderr, "\rload %.4f, step %d, iteration %d, residual %.1e\033[K", it->load,
                it->step, it->iteration, it->residual);
        watch->since = hobe_lua_now();
        watch->shown = 1;
    }
}

static void begin_watch(struct watch *watch, struct hobe_lua *context, int log)
{
    *watch = (struct watch){context, log || context->log, 0, hobe_lua_now()};
    context->solves++;
    if (watch->log)
        fprintf(stderr, " step  iter      load   residual     energy   line  (solve %d)\n",
                context->solves);
}

static void end_watch(const struct watch *watch)
{
    if (watch->shown)
        fputs("\r\033[K", stderr);
}

/* ---- results -------------------------------------------------------------------------------- */

static int finalize(lua_State *L)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    hobe_solution_free(result->solution);
    result->solution = NULL;
    return 0;
}

/* All numbers of a result that are not at a place. */
struct summary {
    struct hobe_solution_info solution;
    struct hobe_model_info model;
};

#define SOLVED(key, field, type, unit, doc)                                                        \
    {                                                                                              \
        key, type, offsetof(struct summary, field), unit, doc                                      \
    }

static const struct hobe_lua_field fields[] = {
    SOLVED("steps", solution.steps, 'i', NULL, "load steps taken"),
    SOLVED("iterations", solution.iterations, 'i', NULL, "Newton iterations in all"),
    SOLVED("cutbacks", solution.cutbacks, 'i', NULL, "steps that were given up and halved"),
    SOLVED("factorisations", solution.factorisations, 'i', NULL, "factorisations in all"),
    SOLVED("residual", solution.residual, 'd', NULL, "relative residual at the end"),
    SOLVED(
        "change", solution.change, 'd', NULL,
        "share by which a last correction, beyond the tolerance, changed the displacements: what "
        "round-off leaves open is less"),
    SOLVED("load", solution.load, 'd', NULL, "load factor: 1, but for points of a path"),
    SOLVED("negative", solution.negative, 'i', NULL,
           "negative eigenvalues of the tangent stiffness, 0 where the equilibrium is stable, as a "
           "point of a path may be with some where the scene spins (hobe.modal tells); -1: not "
           "counted, as by hobe.static then, and with follower forces.  hobe.static warns where "
           "there are any"),
    SOLVED("limit_load", solution.limit_load, 'd', NULL,
           "load factor of the limit point where the path from rest turns, where hobe.static found "
           "an equilibrium beyond it, which a growing load comes to by a jump, and warned of that; "
           "0: none was met (not looked for from `start`)"),
    SOLVED("energy", solution.energy, 'd', "J", "strain energy"),
    SOLVED("smallest_volume", solution.smallest_volume, 'd', NULL,
           "smallest det F: 1 without strain, <= 0 where the beam is turned inside out"),
    SOLVED("indicator", solution.indicator, 'd', NULL,
           "of a reduced model and of a projection: what the displacements may lack of those of "
           "the whole scene, "
           "relative to their size; 0 of whole ones; not a number where it was not asked"),
    SOLVED("time", solution.time, 'd', "s", "of a state of a motion, and of functions of time"),
    SOLVED("unknowns", model.unknowns, 'l', NULL, "scalar unknowns"),
    SOLVED("projected", solution.projected, 'l', NULL,
           "those of a projection, multipliers included; 0: none"),
    SOLVED("linearisations", solution.linearisations, 'i', NULL,
           "how often the modes of a projection were found"),
    SOLVED("outside", solution.outside, 'd', NULL,
           "relative residual that stays outside the modes of a projection"),
    SOLVED("setup_seconds", model.setup, 'd', "s", "building the scene"),
    SOLVED("solve_seconds", solution.seconds, 'd', "s", "solving"),
    {0}};

static struct summary summarize(lua_State *L)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct summary summary;
    hobe_solution_info(result->solution, &summary.solution);
    hobe_model_info(result->model, &summary.model);
    return summary;
}

static int get_field(lua_State *L)
{
    struct summary summary = summarize(L);
    return hobe_lua_push_field(L, "a result", fields, &summary, lua_tostring(L, 2));
}

/* r:report() */
static int report(lua_State *L)
{
    struct summary summary = summarize(L);
    lua_newtable(L);
    for (const struct hobe_lua_field *field = fields; field->name; field++) {
        hobe_lua_push_field(L, "a result", fields, &summary, field->name);
        lua_setfield(L, -2, field->name);
    }
    return 1;
}

static const struct hobe_lua_key at_key = {.name = "at",
                                           .type = KEY_NUMBER,
                                           REQUIRED,
                                           KEY_WITHIN(0, 1),
                                           .doc = "a fraction of the beam's length"};
static const struct hobe_lua_key offset_key = {.name = "offset", .type = KEY_NUMBER};

/* What the arguments (beam, at, y, z) of a method say. */
struct spot {
    const hobe_solution *solution;
    const char *beam;
    double at, y, z;
};

static struct spot read_spot(lua_State *L, const char *name)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct spot spot = {.solution = result->solution};
    lua_settop(L, 5);
    spot.beam = hobe_lua_text(L, 2, lua_pushfstring(L, "%s: the beam", name));
    hobe_lua_read_value(L, 3, lua_pushfstring(L, "%s: at", name), &at_key, &spot.at);
    hobe_lua_read_value(L, 4, lua_pushfstring(L, "%s: y", name), &offset_key, &spot.y);
    hobe_lua_read_value(L, 5, lua_pushfstring(L, "%s: z", name), &offset_key, &spot.z);
    return spot;
}

/* The point that the arguments of a method ask for; `name` is the method. */
static struct hobe_point read_point(lua_State *L, const char *name)
{
    const struct spot s = read_spot(L, name);
    struct hobe_point point;
    struct hobe_error err;
    if (hobe_solution_point(s.solution, s.beam, s.at, s.y, s.z, &point, &err))
        hobe_lua_raise(L, &err);
    return point;
}

/* Whether the arguments of a method name a body, and, behind its name, a point of it or nil: finds
 * where that is. */
static int read_body(lua_State *L, const char *name, struct hobe_body_point *is)
{
    const struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct hobe_error err;
    double point[3];
    lua_settop(L, 5);
    const char *body = hobe_lua_text(L, 2, lua_pushfstring(L, "%s: the beam or body", name));
    if (!hobe_model_has_body(result->model, body))
        return 0;
    const int given = hobe_lua_read_body_point(L, 3, name, point);
    if (hobe_solution_body(result->solution, body, given ? point : NULL, is, &err))
        hobe_lua_raise(L, &err);
    return 1;
}

static int displacement(lua_State *L)
{
    struct hobe_body_point is;
    return hobe_lua_push_numbers(
        L, read_body(L, "displacement", &is) ? is.u : read_point(L, "displacement").u, 3);
}

static int position(lua_State *L)
{
    struct hobe_body_point is;
    return hobe_lua_push_numbers(
        L, read_body(L, "position", &is) ? is.r : read_point(L, "position").r, 3);
}

/* Pushes the velocity of the place that the arguments ask for, or the acceleration. */
static int push_rate(lua_State *L, const char *name, int acceleration)
{
    struct hobe_body_point is;
    if (read_body(L, name, &is))
        return hobe_lua_push_numbers(L, acceleration ? is.acceleration : is.velocity, 3);
    const struct spot s = read_spot(L, name);
    double rate[2][3];
    struct hobe_error err;
    if (hobe_solution_velocity(s.solution, s.beam, s.at, s.y, s.z, rate[0], rate[1], &err))
        hobe_lua_raise(L, &err);
    return hobe_lua_push_numbers(L, rate[acceleration], 3);
}

static int velocity(lua_State *L)
{
    return push_rate(L, "velocity", 0);
}

static int acceleration(lua_State *L)
{
    return push_rate(L, "acceleration", 1);
}

static int rotation(lua_State *L)
{
    struct hobe_body_point is;
    return hobe_lua_push_numbers(
        L, read_body(L, "rotation", &is) ? is.rotation : read_point(L, "rotation").rotation, 3);
}

static int angular_velocity(lua_State *L)
{
    struct hobe_body_point is;
    if (!read_body(L, "angular_velocity", &is))
        hobe_lua_fail(L, "angular_velocity: there is no body \"%s\" in the scene",
                      lua_tostring(L, 2));
    return hobe_lua_push_numbers(L, is.angular_velocity, 3);
}

static int strain(lua_State *L)
{
    return hobe_lua_push_numbers(L, read_point(L, "strain").strain, 6);
}

static int twist(lua_State *L)
{
    const struct spot s = read_spot(L, "twist");
    struct hobe_error err;
    double angle;
    if (hobe_solution_twist(s.solution, s.beam, s.at, &angle, &err))
        hobe_lua_raise(L, &err);
    lua_pushnumber(L, angle);
    return 1;
}

/* A number or some numbers that have a name; a list of them ends with {0}. */
struct part {
    const char *name;
    const double *value;
    int count;
};

/* Pushes a table of them. */
static int push_parts(lua_State *L, const struct part *part)
{
    lua_newtable(L);
    for (; part->name; part++) {
        if (part->count > 1)
            hobe_lua_push_numbers(L, part->value, part->count);
        else
            lua_pushnumber(L, *part->value);
        lua_setfield(L, -2, part->name);
    }
    return 1;
}

/* r:stress(beam, at, y, z) */
static int stress(lua_State *L)
{
    const struct spot s = read_spot(L, "stress");
    struct hobe_stress is;
    struct hobe_error err;
    if (hobe_solution_stress(s.solution, s.beam, s.at, s.y, s.z, &is, &err))
        hobe_lua_raise(L, &err);
    return push_parts(L, (const struct part[]){{"S", is.S, 6},
                                               {"strain", is.strain, 6},
                                               {"cauchy", is.cauchy, 6},
                                               {"section", is.section, 6},
                                               {"mises", &is.mises, 1},
                                               {"energy", &is.energy, 1},
                                               {0}});
}

static const struct hobe_lua_key cut_key = {
    .name = "from", .type = KEY_CHOICE, .choices = "forces|stress"};

/* r:resultants(beam, at, from) */
static int resultants(lua_State *L)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct hobe_resultants is;
    struct hobe_error err;
    double at;
    int cut;
    lua_settop(L, 4);
    const char *beam = hobe_lua_text(L, 2, "resultants: the beam");
    hobe_lua_read_value(L, 3, "resultants: at", &at_key, &at);
    hobe_lua_read_value(L, 4, "resultants: from", &cut_key, &cut);
    if (hobe_solution_resultants(result->solution, beam, at, (enum hobe_cut)cut, &is, &err))
        hobe_lua_raise(L, &err);
    push_parts(L, (const struct part[]){{"N", is.force, 1},
                                        {"Vy", is.force + 1, 1},
                                        {"Vz", is.force + 2, 1},
                                        {"Mx", is.moment, 1},
                                        {"My", is.moment + 1, 1},
                                        {"Mz", is.moment + 2, 1},
                                        {"B", &is.bimoment, 1},
                                        {"ex", is.axes[0], 3},
                                        {"ey", is.axes[1], 3},
                                        {"ez", is.axes[2], 3},
                                        {0}});
    lua_pushstring(L, is.cut == HOBE_CUT_FORCES ? "forces" : "stress");
    lua_setfield(L, -2, "from");
    return 1;
}

/* r:wall_bending(beam) */
static int wall_bending(lua_State *L)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct hobe_wall_bending is;
    struct hobe_error err;
    const char *beam = hobe_lua_text(L, 2, "wall_bending: the beam");
    hobe_lua_pause_clock();
    const enum hobe_status status = hobe_solution_wall_bending(result->solution, beam, &is, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    return push_parts(L, (const struct part[]){{"at", &is.at, 1},
                                               {"twist_rate", &is.twist_rate, 1},
                                               {"torque", &is.torque, 1},
                                               {"loss", &is.loss, 1},
                                               {"limit_torque", &is.limit_torque, 1},
                                               {0}});
}

/* r:mesh_error(beam) */
static int mesh_error(lua_State *L)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct hobe_error err;
    double share;
    const char *beam = hobe_lua_text(L, 2, "mesh_error: the beam");
    if (hobe_solution_mesh_error(result->solution, beam, &share, &err))
        hobe_lua_raise(L, &err);
    lua_pushnumber(L, share);
    return 1;
}

/* r:reaction(name) */
static int reaction(lua_State *L)
{
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct hobe_reaction is;
    struct hobe_error err;
    const char *name = hobe_lua_text(L, 2, "reaction: the name");
    if (hobe_solution_reaction(result->solution, name, &is, &err))
        hobe_lua_raise(L, &err);
    return push_parts(
        L, (const struct part[]){
               {"force", is.force, 3}, {"moment", is.moment, 3}, {"power", &is.power, 1}, {0}});
}

/* r:spring(name) */
static int spring(lua_State *L)
{
    static const struct {
        const char *extension, *force;
        int parts;
    } kinds[] = {[HOBE_SPRING_LENGTH] = {"length", "force", 1},
                 [HOBE_SPRING_TORSION] = {"angle", "moment", 1},
                 [HOBE_SPRING_BUSHING] = {"displacement", "force", 3}};
    struct result *result = luaL_checkudata(L, 1, HOBE_LUA_RESULT);
    struct hobe_spring_state is;
    struct hobe_error err;
    const char *name = hobe_lua_text(L, 2, "spring: the name");
    if (hobe_solution_spring(result->solution, name, &is, &err))
        hobe_lua_raise(L, &err);
    const int parts = kinds[is.kind].parts;
    return push_parts(L, (const struct part[]){{kinds[is.kind].extension, is.extension, parts},
                                               {kinds[is.kind].force, is.force, parts},
                                               {0}});
}

const struct hobe_lua_entry hobe_lua_result_methods[] = {
    {"displacement", displacement, "r:displacement(beam, at [, y, z])",
     "`{u1, u2, u3}`, m, global axes, at the fraction `at` of the beam's length; of the axis, or "
     "of the point (y, z) of the section, m from the centroid.  Of a body: "
     "`r:displacement(body [, point])`, of its centre of mass, or of the point that was at "
     "`{x, y, z}` in the reference.",
     NULL, NULL},
    {"position", position, "r:position(beam, at [, y, z])",
     "`{x, y, z}`, m, global axes; also of a body.", NULL, NULL},
    {"velocity", velocity, "r:velocity(beam, at [, y, z])",
     "Of a state of a motion, `{v1, v2, v3}`, m/s, global axes; also of a body.", NULL, NULL},
    {"acceleration", acceleration, "r:acceleration(beam, at [, y, z])", "Likewise, m/s^2.", NULL,
     NULL},
    {"angular_velocity", angular_velocity, "r:angular_velocity(body)",
     "Of a body in a state of a motion, rad/s, global axes.", NULL, NULL},
    {"rotation", rotation, "r:rotation(beam, at)",
     "The rotation vector of the section, or of a body, rad, global axes.", NULL, NULL},
    {"twist", twist, "r:twist(beam, at)",
     "`atan2(-r_z.Y, r_z.Z)`, rad, with Y and Z the section's axes before the load, and its whole "
     "turns, counted along the beam from its first clamp (its begin, without one).  The slope "
     "`r_y` "
     "would give another angle.",
     NULL, NULL},
    {"strain", strain, "r:strain(beam, at [, y, z])",
     "Green-Lagrange strain `{xx, yy, zz, 2yz, 2xz, 2xy}` in the section's axes.", NULL, NULL},
    {"stress", stress, "r:stress(beam, at [, y, z])",
     "A table of stresses `{xx, yy, zz, yz, xz, xy}`, Pa: `cauchy` in global axes, `section` the "
     "same in the section's axes now, `S` (second Piola-Kirchhoff) in those before the load, with "
     "its `strain`; and `mises`, Pa, and the strain `energy`, J/m^3.  By the element's law: not of "
     "3333s, whose law is one of section forces.",
     NULL, NULL},
    {"resultants", resultants, "r:resultants(beam, at [, from])",
     "What the beam beyond `at` does to the part before it, about the centroid, on the section's "
     "axes now, `ex`, `ey`, `ez`: `N`, `Vy`, `Vz`, N; `Mx`, `My`, `Mz`, N m; the bimoment `B`, "
     "N m^2.  `from` says whence: `\"forces\"`, those at the nodes, which balance the loads as "
     "exactly as the iteration has converged, at ends of elements, where it is the default; "
     "`\"stress\"`, the integral of the traction, anywhere, which converges with the elements.",
     NULL, NULL},
    {"wall_bending", wall_bending, "r:wall_bending(beam)",
     "How far the beam's walls bend where it is twisted most, which an element whose outline is "
     "rigid does not know: `at`, the middle of that element, a fraction of the length; its "
     "`twist_rate`, rad/m, and `torque`, N m; `loss`, what the bending of the walls would take of "
     "the torque at that twist rate, a fraction, 0 where the element has the modes v2y and v2z; "
     "`limit_torque`, N m, at which the outline collapses, `math.huge` where it does not.  "
     "Estimated from `section:wall_bending()` for an even twist of a straight beam; shear buckling "
     "of a wide wall may come earlier.  `hobe.static` and `hobe.path` warn where `loss` is more "
     "than 0.05, and beyond the limit torque, on standard error and in a note, but not of sections "
     "that vary along the beam, whose solution takes too long to be asked always.",
     NULL, NULL},
    {"mesh_error", mesh_error, "r:mesh_error(beam)",
     "An estimate of how much too stiff the beam's mesh is in statics, from 0 to 1: the share of "
     "the energy in which forces by its strains and forces that balance its loads differ, in "
     "stretch and bending.  It sees coarse meshes and elements that lock, not what loads do that "
     "act inside elements at one place; 0 of 3333s and of sections that vary.  `hobe.static` and, "
     "at its end, `hobe.path` "
     "warn where it is 0.01 or more.",
     NULL, NULL},
    {"reaction", reaction, "r:reaction(name)",
     "What the clamp or support called `name` does to its beam, a joint to its second beam: "
     "`force`, `{x, y, z}`, N, and `moment` about the place where it sits, N m, global axes.",
     NULL, NULL},
    {"spring", spring, "r:spring(name)",
     "What the spring called `name` does, its damper included: `length`, m, and `force` that pulls "
     "its places together, N; of torsion `angle`, rad, and `moment` that turns the second beam "
     "back, N m; of a bushing `displacement`, `{x, y, z}`, m, and `force` that pushes the second "
     "place back, N.",
     NULL, NULL},
    {"report", report, "r:report()", "All fields of the result in a table.", NULL, NULL},
    {0}};

/* Warns of a beam in a state where that is worse than what was `told` of it; returns the worse. */
static enum hobe_warning warn(lua_State *L, const hobe_solution *solution, const char *beam,
                              const char *when, enum hobe_warning told)
{
    enum hobe_warning warning;
    struct hobe_error err;
    char text[600];
    hobe_lua_pause_clock();
    const enum hobe_status status =
        hobe_solution_warning(solution, beam, &warning, text, sizeof text, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    if (warning <= told)
        return told;
    hobe_lua_warn(L, lua_pushfstring(L, "%s%s", text, when));
    lua_pop(L, 1);
    return warning;
}

/* Warns of an equilibrium that a scene free to move would leave. */
static void warn_unstable(lua_State *L, const hobe_solution *solution)
{
    struct hobe_solution_info info;
    char text[300];
    hobe_solution_info(solution, &info);
    if (info.negative <= 0)
        return;
    snprintf(text, sizeof text,
             "the equilibrium is unstable: its tangent stiffness has %d negative eigenvalue%s, so "
             "that there is a critical load below this one; look for it with hobe.buckling or "
             "hobe.path, and disturb the scene a little to find where it goes",
             info.negative, info.negative > 1 ? "s" : "");
    hobe_lua_warn(L, text);
}

/* Warns of an equilibrium that no path leads to. */
static void warn_jumped(lua_State *L, const hobe_solution *solution)
{
    struct hobe_solution_info info;
    char text[300];
    hobe_solution_info(solution, &info);
    if (!(info.limit_load > 0))
        return;
    snprintf(text, sizeof text,
             "the equilibrium is not on the path from rest, which turns at a limit point near load "
             "factor %.4g: a load that grows jumps from there, here or elsewhere; follow the path "
             "with hobe.path, and the jump with hobe.dynamic",
             info.limit_load);
    hobe_lua_warn(L, text);
}

/* Warns of each beam whose mesh is too coarse.  Few unknowns balance loads on few fields only, and
 * have an indicator of their own. */
static void warn_mesh(lua_State *L, const hobe_solution *solution, const hobe_model *model)
{
    struct hobe_solution_info info;
    struct hobe_error err;
    char text[600];
    const char *beam;
    hobe_solution_info(solution, &info);
    if (info.projected > 0 || info.indicator != 0)
        return;
    for (int b = 0; (beam = hobe_model_beam_name(model, b)); b++) {
        if (hobe_solution_mesh_warning(solution, beam, text, sizeof text, &err))
            hobe_lua_raise(L, &err);
        if (*text)
            hobe_lua_warn(L, text);
    }
}

/* Warns of each beam of a model at the points of the path on top of the stack, where it gets worse.
 */
static void warn_along(lua_State *L, const hobe_model *model)
{
    const char *beam;
    for (int b = 0; (beam = hobe_model_beam_name(model, b)); b++) {
        enum hobe_warning told = HOBE_WARNING_NONE;
        for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; i++) {
            const struct result *result = lua_touserdata(L, -1);
            struct hobe_solution_info info;
            char when[60];
            hobe_solution_info(result->solution, &info);
            snprintf(when, sizeof when, " (load factor %.3g)", info.load);
            told = warn(L, result->solution, beam, when, told);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
}

hobe_solution **hobe_lua_new_result(lua_State *L, int scene)
{
    scene = lua_absindex(L, scene);
    const struct hobe_lua_scene *of = lua_touserdata(L, scene);
    struct result *result = lua_newuserdatauv(L, sizeof *result, 1);
    *result = (struct result){NULL, of->model};
    hobe_lua_set_type(L, HOBE_LUA_RESULT, finalize, hobe_lua_result_methods, get_field);
    lua_pushvalue(L, scene);
    lua_setiuservalue(L, -2, 1);
    return &result->solution;
}

void hobe_lua_check_linear(lua_State *L, const char *verb)
{
    const struct advise_model *model = hobe_lua_context(L)->model;
    if (model && model->linear && strcmp(verb, "static"))
        hobe_lua_fail(L, "%s: a linear model is one of hobe.static alone", verb);
}

struct hobe_lua_scene *hobe_lua_read_verb(lua_State *L, const struct hobe_lua_schema *schema,
                                          void *options, size_t size)
{
    lua_settop(L, 2);
    if (hobe_lua_context(L)->called)
        hobe_lua_fail(L, "%s: a function that a solver calls cannot solve", schema->name);
    struct hobe_lua_scene *scene = hobe_lua_read_scene(L, schema->name);
    if (lua_isnil(L, 2)) {
        lua_newtable(L);
        lua_replace(L, 2);
    }
    memset(options, 0, size);
    hobe_lua_read(L, 2, schema, options);
    hobe_lua_check_linear(L, schema->name);
    return scene;
}

/* ---- statics -------------------------------------------------------------------------------- */

static const double FEW_DIGITS = 1e-6; /* a change above this is said */

struct options {
    struct hobe_newton newton;
    struct hobe_projection projection;
    int line_search, log;
};

#define NEWTON(name, kind, ...) KEY_AS(#name, struct options, newton.name, kind, __VA_ARGS__)

/* METHOD of the options of a verb. */
#define METHOD(owner, field)                                                                       \
    KEY_AS("method", owner, field, KEY_CHOICE, .choices = "newton|series", .word = "newton",       \
           .doc = "`series`: steps go along a power series of the path, as far as that is good; "  \
                  "fewer factorisations where many steps are needed")

static const struct hobe_lua_key static_keys[] = {
    METHOD(struct options, newton.method),
    NEWTON(start, KEY_RESULT,
           .doc = "a result to start from, at the full load, in one step, or if that fails from "
                  "the reference: of this scene or of one of the same shape, under another load "
                  "or of other size; not by series.  So a sweep goes from neighbour to neighbour: "
                  "r = hobe.static(scene, { start = r })"),
    NEWTON(steps, KEY_WHOLE, KEY_WITHIN(1, 1e6), .fallback = 1, .doc = "load steps to begin with"),
    NEWTON(time, KEY_NUMBER, KEY_FROM(0), .unit = "s",
           .doc = "when functions of time are taken; load steps go to the motions of joints there, "
                  "as to the loads"),
    NEWTON(tolerance, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-9,
           .doc = "residual to reach, relative to the load"),
    NEWTON(max_iterations, KEY_WHOLE, KEY_WITHIN(1, 1000), .fallback = 30,
           .doc = "iterations of a step before it is cut"),
    NEWTON(smallest_step, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-4,
           .doc = "share of the load below which a step is not cut"),
    KEY(struct options, projection, KEY_GROUP, .group = &hobe_lua_projection_schema,
        .doc = "looks for corrections among few fields only, by the matrices and forces of the "
               "whole: it shows what such fields can do, and takes longer; not by series"),
    NEWTON(linear, KEY_FLAG,
           .doc = "the linear response to the loads instead, right where they are small: one "
                  "correction from the reference; `residual` tells how far from equilibrium it is"),
    KEY(struct options, line_search, KEY_FLAG, .fallback = 1,
        .doc = "whether steps that increase the residual are shortened"),
    KEY(struct options, log, KEY_FLAG, .doc = "print each iteration on standard error"),
    {0}};

static const struct hobe_lua_schema static_schema = {"static", static_keys};

static struct hobe_solution_info info_of(const hobe_solution *solution)
{
    struct hobe_solution_info info;
    hobe_solution_info(solution, &info);
    return info;
}

/* Says when few digits are settled. */
static void note_change(lua_State *L, double change)
{
    if (change > FEW_DIGITS)
        hobe_lua_note(
            L,
            "only about %d digits of the displacements are settled; the rest is round-off, "
            "of which fewer elements make less, or the tolerance",
            (int)-log10(change));
}

/* hobe.static(scene, options) */
static int solve_static(lua_State *L)
{
    struct options options;
    struct hobe_lua_scene *scene = hobe_lua_read_verb(L, &static_schema, &options, sizeof options);
    struct watch watch;
    struct hobe_error err;
    const struct advise_model *model = hobe_lua_context(L)->model;
    options.newton.no_line_search = !options.line_search;
    options.newton.projection = hobe_lua_finish_projection(L, &static_schema, &options.projection);
    options.newton.linear |= model && model->linear;
    hobe_solution **solution = hobe_lua_new_result(L, 1);
    options.newton.log = watch_iteration;
    options.newton.context = &watch;
    hobe_lua_pause_clock();
    begin_watch(&watch, hobe_lua_context(L), options.log);
    enum hobe_status status = hobe_static(scene->model, &options.newton, solution, &err);
    end_watch(&watch);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    const struct hobe_solution_info info = info_of(*solution);
    hobe_lua_context(L)->cost.factorisations += info.factorisations;
    hobe_lua_context(L)->cost.solve += info.seconds;
    note_change(L, info.change);
    hobe_lua_note_reduced(L, info.indicator, *solution);
    const char *beam;
    for (int b = 0; (beam = hobe_model_beam_name(scene->model, b)); b++)
        warn(L, *solution, beam, "", HOBE_WARNING_NONE);
    warn_mesh(L, *solution, scene->model);
    warn_unstable(L, *solution);
    warn_jumped(L, *solution);
    return 1;
}

/* ---- paths ---------------------------------------------------------------------------------- */

struct path_options {
    struct hobe_path_options path;
    int log;
};

static const struct hobe_lua_key reach_keys[] = {
    KEY(struct hobe_reach, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam"),
    KEY(struct hobe_reach, at, KEY_NUMBER, REQUIRED, KEY_WITHIN(0, 1),
        .doc = "place, a fraction of the beam's length"),
    KEY(struct hobe_reach, value, KEY_VECTOR, REQUIRED, .unit = "m",
        .doc = "reached when the displacement has this component along this direction"),
    {0}};

static const struct hobe_lua_schema reach_schema = {"reach", reach_keys};

#define PATH(name, field, kind, ...)                                                               \
    KEY_AS(name, struct path_options, path.field, kind, __VA_ARGS__)

static const struct hobe_lua_key path_keys[] = {
    PATH("steps", steps, KEY_WHOLE, KEY_WITHIN(1, 1e6), .fallback = 200, .doc = "steps at most"),
    PATH("arc", arc, KEY_NUMBER, KEY_ABOVE(0),
         .doc = "longest step: 1 is what the linear response to all loads would take; 0.05 unless "
                "given, by series without limit"),
    PATH("smallest_arc", smallest_arc, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-4,
         .doc = "share of it below which a step is not cut"),
    PATH("to", to, KEY_NUMBER, .fallback = 1,
         .doc = "load factor that ends the path, other than 0; the path starts towards it"),
    PATH("reach", reach, KEY_GROUP, .group = &reach_schema,
         .doc = "a displacement that ends the path"),
    METHOD(struct path_options, path.newton.method),
    PATH("tolerance", newton.tolerance, KEY_NUMBER, KEY_BETWEEN(0, 1), .fallback = 1e-9,
         .doc = "residual to reach, relative to the load"),
    PATH("max_iterations", newton.max_iterations, KEY_WHOLE, KEY_WITHIN(1, 1000), .fallback = 12,
         .doc = "iterations of a step before it is cut"),
    KEY(struct path_options, log, KEY_FLAG, .doc = "print each iteration on standard error"),
    {0}};

static const struct hobe_lua_schema path_schema = {"path", path_keys};

struct path {
    hobe_path *path;
};

static int finalize_path(lua_State *L)
{
    struct path *path = luaL_checkudata(L, 1, "hobe.path");
    hobe_path_free(path->path);
    path->path = NULL;
    return 0;
}

static void set_number(lua_State *L, const char *key, double value)
{
    lua_pushnumber(L, value);
    lua_setfield(L, -2, key);
}

/* Sets limit_points and bifurcations of the table on top, and says them in notes. */
static void set_events(lua_State *L, const hobe_path *path)
{
    static const char *const lists[] = {"limit_points", "bifurcations"};
    for (int kind = 0; kind < 2; kind++) {
        lua_newtable(L);
        for (int i = 0; hobe_path_event(path, i); i++) {
            const struct hobe_path_event *event = hobe_path_event(path, i);
            char text[300];
            if (event->bifurcation != kind)
                continue;
            hobe_path_event_text(event, text, sizeof text);
            hobe_lua_note(L, "%s", text);
            lua_newtable(L);
            set_number(L, "load", event->extreme);
            set_number(L, "from", event->load[0]);
            set_number(L, "to", event->load[1]);
            set_number(L, "change", event->change);
            lua_pushinteger(L, event->before + 1);
            lua_setfield(L, -2, "after");
            lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
        }
        lua_setfield(L, -2, lists[kind]);
    }
}

/* Pushes the list of results with the fields of the whole path. */
static void push_path(lua_State *L, hobe_path *path, const hobe_model *model)
{
    static const char *const ends[] = {"load", "displacement", "steps"};
    struct hobe_path_info info;
    double change = 0, indicator = NAN;
    const hobe_solution *last = NULL;
    hobe_path_info(path, &info);
    hobe_lua_context(L)->cost.solve += info.seconds;
    hobe_lua_context(L)->cost.factorisations += info.factorisations;
    lua_createtable(L, info.points, 6);
    for (int i = 0; i < info.points; i++) {
        hobe_solution **point = hobe_lua_new_result(L, 1);
        last = *point = hobe_path_take(path, i);
        change = fmax(change, info_of(*point).change);
        indicator = fmax(indicator, info_of(*point).indicator);
        lua_rawseti(L, -2, i + 1);
    }
    note_change(L, change);
    hobe_lua_note_reduced(L, indicator, NULL);
    lua_pushstring(L, ends[info.end]);
    lua_setfield(L, -2, "ended");
    set_number(L, "solve_seconds", info.seconds);
    lua_pushinteger(L, info.iterations);
    lua_setfield(L, -2, "iterations");
    lua_pushinteger(L, info.cutbacks);
    lua_setfield(L, -2, "cutbacks");
    lua_pushinteger(L, info.factorisations);
    lua_setfield(L, -2, "factorisations");
    set_events(L, path);
    warn_along(L, model);
    if (last)
        warn_mesh(L, last, model);
    if (info.end == HOBE_PATH_STEPS)
        hobe_lua_note(L, "the path ends after its %d steps, short of its end; give it more steps",
                      info.points);
}

/* hobe.path(scene, options) */
static int solve_path(lua_State *L)
{
    struct path_options options;
    struct hobe_lua_scene *scene = hobe_lua_read_verb(L, &path_schema, &options, sizeof options);
    struct watch watch;
    struct hobe_error err;
    if (options.path.to == 0)
        hobe_lua_fail(L, "path: to must not be 0, where the path begins");
    struct path *path = lua_newuserdatauv(L, sizeof *path, 0);
    path->path = NULL;
    hobe_lua_set_type(L, "hobe.path", finalize_path, NULL, get_field);
    options.path.newton.log = watch_iteration;
    options.path.newton.context = &watch;
    hobe_lua_pause_clock();
    begin_watch(&watch, hobe_lua_context(L), options.log);
    enum hobe_status status = hobe_path_follow(scene->model, &options.path, &path->path, &err);
    end_watch(&watch);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    push_path(L, path->path, scene->model);
    return 1;
}

const struct hobe_lua_entry hobe_lua_solve_entries[] = {
    {"static", solve_static, "hobe.static(scene [, {steps =, ...}])",
     "Static equilibrium under all loads, from the reference: load steps with automatic "
     "cut-back, Newton's iteration with line search.  Returns a result.",
     &static_schema, fields},
    {"path", solve_path, "hobe.path(scene [, {steps =, arc =, to =, reach =, ...}])",
     "The equilibrium path from the reference through limit points, by arc length: the load factor "
     "is found with the displacements.  Returns a list of results, `p[i].load` the load factor of "
     "the i-th and `p[i].negative` its negative eigenvalues; and in it `ended`, what ended it: "
     "`\"load\"`, `\"displacement\"` or `\"steps\"`; `iterations`, `factorisations`, `cutbacks`, "
     "`solve_seconds`; "
     "and "
     "`limit_points` and `bifurcations`, lists of tables: `load`, the factor there; `from` and "
     "`to`, those of the points before and after; `after`, the number of the point before; "
     "`change`, of the negative eigenvalues.  They are said in notes, too.  At a bifurcation the "
     "path goes on straight.",
     &path_schema, NULL},
    {0}};
