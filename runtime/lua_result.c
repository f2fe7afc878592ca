/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results of solvers: their numbers, and what their methods say at a place. */
#include "lua_result.h"
#include "lua_item.h"

struct result {              /* its user value is the scene */
    hobe_solution *solution; /* first: KEY_RESULT reads it */
    const hobe_model *model;
};
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

#define SOLVED(key, field, type, unit, doc) FIELD_AS(key, struct summary, field, type, unit, doc)

const struct hobe_lua_field hobe_lua_result_fields[] = {
    SOLVED("steps", solution.steps, 'i', NULL, "load steps taken"),
    SOLVED(
        "iterations", solution.iterations, 'i', NULL,
        "Newton iterations in all; of parts of the scene that nothing couples the most one took"),
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
           "also of the first state of a motion; 0: none was met (not looked for from `start`)"),
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
    return hobe_lua_push_field(L, "a result", hobe_lua_result_fields, &summary, lua_tostring(L, 2));
}

/* r:report() */
static int report(lua_State *L)
{
    struct summary summary = summarize(L);
    lua_newtable(L);
    for (const struct hobe_lua_field *field = hobe_lua_result_fields; field->name; field++) {
        hobe_lua_push_field(L, "a result", hobe_lua_result_fields, &summary, field->name);
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
     "An estimate of how much too stiff the beam's mesh is in statics, from 0 to 1: the share that "
     "is missing of what the loads do to it, beside the same element on a fine mesh.  It sees "
     "coarse "
     "meshes and elements that lock, between 0.3 and 3 times the truth in random cantilevers; not "
     "what loads do that act inside elements; 0 of 3333s and with integration `paper`.  "
     "`hobe.static` and, at its end, `hobe.path` warn where it is 0.01 or more.",
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
