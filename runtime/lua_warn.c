/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What people should know of a solution beside its numbers: warnings and notes. */
#include "lua_result.h"

#include <math.h>

static const double FEW_DIGITS = 1e-6; /* a change above this is said */

void hobe_lua_note_change(lua_State *L, double change)
{
    if (change > FEW_DIGITS)
        hobe_lua_note(
            L,
            "only about %d digits of the displacements are settled; the rest is round-off, "
            "of which fewer elements make less, or the tolerance",
            (int)-log10(change));
}

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
    hobe_lua_warn(L,
                  warning == HOBE_WARNING_COLLAPSED ? HOBE_LUA_WARN_COLLAPSE : HOBE_LUA_WARN_WALLS,
                  lua_pushfstring(L, "%s%s", text, when));
    lua_pop(L, 1);
    return warning;
}

/* Warns of an equilibrium that a scene free to move would leave, and of what follows from that. */
static void warn_unstable(lua_State *L, const hobe_solution *solution, const char *what,
                          const char *so)
{
    struct hobe_solution_info info;
    char text[300];
    hobe_solution_info(solution, &info);
    if (info.negative <= 0)
        return;
    snprintf(text, sizeof text,
             "%s is unstable: its tangent stiffness has %d negative eigenvalue%s, so that %s", what,
             info.negative, info.negative > 1 ? "s" : "", so);
    hobe_lua_warn(L, HOBE_LUA_WARN_UNSTABLE, text);
}

/* Warns of an equilibrium that no load that grows leads to along its path. */
static void warn_jumped(lua_State *L, const hobe_solution *solution, const char *what)
{
    struct hobe_solution_info info;
    char text[300];
    hobe_solution_info(solution, &info);
    if (!(info.limit_load > 0))
        return;
    snprintf(text, sizeof text,
             "%s lies beyond a limit point, where the path from rest turns near load factor %.4g: "
             "a load that grows jumps from there, here or elsewhere; follow the path with "
             "hobe.path, and the jump with hobe.dynamic",
             what, info.limit_load);
    hobe_lua_warn(L, HOBE_LUA_WARN_JUMP, text);
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
            hobe_lua_warn(L, HOBE_LUA_WARN_MESH, text);
    }
}

void hobe_lua_warn_equilibrium(lua_State *L, const hobe_solution *solution, const hobe_model *model)
{
    const char *beam;
    for (int b = 0; (beam = hobe_model_beam_name(model, b)); b++)
        warn(L, solution, beam, "", HOBE_WARNING_NONE);
    warn_mesh(L, solution, model);
    warn_unstable(L, solution, "the equilibrium",
                  "there is a critical load below this one; look for it with hobe.buckling or "
                  "hobe.path, and disturb the scene a little to find where it goes");
    warn_jumped(L, solution, "the equilibrium");
}

void hobe_lua_warn_start(lua_State *L, const hobe_solution *start)
{
    warn_unstable(L, start, "dynamic: the equilibrium at the start",
                  "what disturbs it grows, rounding too; its modes (hobe.modal with `state`) tell "
                  "how fast");
    warn_jumped(L, start, "dynamic: the equilibrium at the start");
}

/* Warns of each beam of a model at the points of the path on top of the stack, where it gets worse.
 */
static void warn_along(lua_State *L, const hobe_model *model)
{
    const char *beam;
    for (int b = 0; (beam = hobe_model_beam_name(model, b)); b++) {
        enum hobe_warning told = HOBE_WARNING_NONE;
        for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; i++) {
            const hobe_solution *const *solution = lua_touserdata(L, -1); /* a result */
            struct hobe_solution_info info;
            char when[60];
            hobe_solution_info(*solution, &info);
            snprintf(when, sizeof when, " (load factor %.3g)", info.load);
            told = warn(L, *solution, beam, when, told);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
}

void hobe_lua_warn_path(lua_State *L, const hobe_solution *last, const hobe_model *model)
{
    warn_along(L, model);
    if (last)
        warn_mesh(L, last, model);
}
