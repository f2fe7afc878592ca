/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A scene that chooses its model: trials of it in Lua, for the search in advise.c. */
#include "advise.h"
#include "lua_item.h"
#include "lua_result.h"

#include <math.h>
#include <string.h>

/* Arguments of what runs in protected mode, so that no error of Lua leaves the core: the list of
 * items, the function or nil, a table that keeps names alive, and the search. */
enum { ITEMS = 1, FUNCTION, KEPT, SEARCH, ARGUMENTS = SEARCH };

enum { MOST_QUANTITIES = 2000, MOST_ELEMENTS = 64 /* of the beam that has most */ };

/* A search from Lua. */
struct trials {
    lua_State *L;
    int first; /* absolute index of the items, with the other arguments behind them */
    int count; /* quantities, known after the first run */
    const char *name[MOST_QUANTITIES], *unit[MOST_QUANTITIES];
    const struct advise_model *model; /* NULL: as the script has it */
    double *value;                    /* [count]; NULL: to learn their names */
    struct advice advice;
};

/* ---- quantities ------------------------------------------------------------------------------ */

enum { PLACES = 3, PARTS = 6 };

/* Those of a scene that names none: how ends and middles of its beams are displaced and turned. */
static void ask_beams(lua_State *L, const hobe_model *model, const hobe_solution *solution)
{
    static const double at[PLACES] = {0, 0.5, 1};
    static const char *const part[] = {"u1", "u2", "u3", "rotation 1", "rotation 2", "rotation 3"};
    const char *beam;
    struct hobe_error err;
    lua_newtable(L);
    for (int b = 0; (beam = hobe_model_beam_name(model, b)); b++)
        for (int i = 0; i < PLACES; i++) {
            struct hobe_point point;
            if (hobe_solution_point(solution, beam, at[i], 0, 0, &point, &err))
                hobe_lua_raise(L, &err);
            for (int k = 0; k < PARTS; k++) {
                lua_pushfstring(L, "%s of %s at %f", part[k], beam, at[i]);
                lua_createtable(L, 2, 0);
                lua_pushnumber(L, k < 3 ? point.u[k] : point.rotation[k - 3]);
                lua_rawseti(L, -2, 1);
                lua_pushstring(L, k < 3 ? "m" : "rad");
                lua_rawseti(L, -2, 2);
                lua_rawset(L, -3);
            }
        }
}

/* Pushes the table of quantities of the scene on top of the stack. */
static void push_quantities(lua_State *L, const struct trials *t)
{
    struct hobe_lua *context = hobe_lua_context(L);
    if (!lua_isnil(L, FUNCTION)) {
        lua_pushvalue(L, FUNCTION);
        lua_pushvalue(L, -2);
        lua_call(L, 1, 1);
        return;
    }
    const struct hobe_lua_scene *scene = lua_touserdata(L, -1);
    const struct hobe_newton options = {.linear = t->model && t->model->linear};
    struct hobe_error err;
    struct hobe_solution_info info;
    hobe_solution **solution = hobe_lua_new_result(L, lua_gettop(L));
    hobe_lua_pause_clock();
    const enum hobe_status status = hobe_static(scene->model, &options, solution, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    hobe_solution_info(*solution, &info);
    context->cost.solve += info.seconds;
    context->cost.factorisations += info.factorisations;
    ask_beams(L, scene->model, *solution);
}

/* The number, and its unit or NULL, of the quantity on top of the stack. */
static double read_quantity(lua_State *L, const char *name, const char **unit)
{
    const char *what = lua_pushfstring(L, "scene: quantity %s", name);
    double x;
    *unit = NULL;
    if (lua_istable(L, -2)) {
        lua_rawgeti(L, -2, 1);
        x = hobe_lua_number(L, -1, what);
        lua_rawgeti(L, -3, 2);
        if (!lua_isnil(L, -1))
            *unit = hobe_lua_text(L, -1, what);
        lua_pop(L, 2);
    } else
        x = hobe_lua_number(L, -2, what);
    lua_pop(L, 1);
    return x;
}

/* Learns the names of the quantities in the table on top of the stack; they and their units stay
 * alive with that table, which is kept. */
static void learn_names(lua_State *L, struct trials *t)
{
    const int table = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, table); lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING)
            hobe_lua_fail(L, "scene: quantities have names, {sag = %s}", hobe_lua_describe(L, -1));
        if (t->count == MOST_QUANTITIES)
            hobe_lua_fail(L, "scene: quantities must be at most %d; give a function that names few",
                          MOST_QUANTITIES);
        t->name[t->count] = lua_tostring(L, -2);
        read_quantity(L, t->name[t->count], t->unit + t->count);
        t->count++;
    }
    if (t->count == 0)
        hobe_lua_fail(L, "scene: quantities must give a table {name = number}, with one at least");
    lua_pushvalue(L, table);
    lua_rawseti(L, KEPT, 1);
}

static void read_quantities(lua_State *L, const struct trials *t)
{
    const char *unit;
    for (int i = 0; i < t->count; i++) {
        if (lua_getfield(L, -1, t->name[i]) == LUA_TNIL)
            hobe_lua_fail(L, "scene: quantity %s is missing", t->name[i]);
        t->value[i] = read_quantity(L, t->name[i], &unit);
        lua_pop(L, 1);
    }
}

/* ---- trials ---------------------------------------------------------------------------------- */

/* Runs in protected mode; argument 1 is the search. */
static int run_trial(lua_State *L)
{
    struct trials *t = lua_touserdata(L, SEARCH);
    hobe_lua_make_scene(L, ITEMS, t->model);
    push_quantities(L, t);
    if (!lua_istable(L, -1))
        hobe_lua_fail(L, "scene: quantities must give a table {name = number}, got %s",
                      hobe_lua_describe(L, -1));
    if (t->value)
        read_quantities(L, t);
    else
        learn_names(L, t);
    return 0;
}

/* Runs a trial; an error's value is on top of the stack where the status is not LUA_OK. */
static int call_trial(struct trials *t, const struct advise_model *model, double *value)
{
    lua_State *L = t->L;
    t->model = model;
    t->value = value;
    hobe_lua_context(L)->trying = 1;
    luaL_checkstack(L, ARGUMENTS + 1, NULL);
    lua_pushcfunction(L, run_trial);
    for (int i = 0; i < ARGUMENTS; i++)
        lua_pushvalue(L, t->first + i);
    const int status = lua_pcall(L, ARGUMENTS, 0, 0);
    hobe_lua_context(L)->trying = 0;
    return status;
}

static enum hobe_status run(void *context, const struct advise_model *model, double *value,
                            int *iterations, struct hobe_error *err)
{
    struct trials *t = context;
    const long before = hobe_lua_context(t->L)->cost.factorisations;
    const int status = call_trial(t, model, value);
    *iterations = (int)fmax(1, (double)(hobe_lua_context(t->L)->cost.factorisations - before));
    if (status == LUA_OK)
        return HOBE_OK;
    const char *message = lua_tostring(t->L, -1);
    hobe_fail(err, status == LUA_ERRMEM ? HOBE_NO_MEMORY : HOBE_BAD_INPUT, NULL, "%s",
              message ? message : "an error without words");
    lua_pop(t->L, 1);
    return err->status;
}

/* ---- the choice ------------------------------------------------------------------------------ */

static int finalize(lua_State *L)
{
    struct trials *t = lua_touserdata(L, 1);
    advice_free(&t->advice);
    return 0;
}

static struct trials *push_trials(lua_State *L)
{
    struct trials *t = lua_newuserdatauv(L, sizeof *t, 0);
    memset(t, 0, sizeof *t);
    t->L = L;
    hobe_lua_set_type(L, "hobe.trials", finalize, NULL, NULL);
    return t;
}

/* Says the choice with the results, or on standard error, too, where nothing holds. */
static void tell(lua_State *L, const struct advice *advice)
{
    char line[2][1100];
    struct hobe_text text[2] = {{0}};
    advise_say(advice, &text[0]);
    advise_say_evidence(advice, &text[1]);
    for (int i = 0; i < 2; i++) {
        snprintf(line[i], sizeof line[i], "%s", text[i].at ? text[i].at : "");
        hobe_text_free(&text[i]);
    }
    if (advice->holds)
        hobe_lua_note(L, "%s", line[0]);
    else
        hobe_lua_warn(L, HOBE_LUA_WARN_ADVICE, line[0]);
    hobe_lua_note(L, "%s", line[1]);
}

void hobe_lua_advise(lua_State *L, int items, int function, double accuracy)
{
    const struct hobe_kernel *level[ADVISE_LEVELS];
    struct hobe_error err;
    const int first = lua_gettop(L) + 1;
    lua_pushvalue(L, items);
    lua_pushvalue(L, function);
    lua_newtable(L);
    struct trials *t = push_trials(L);
    t->first = first;
    if (call_trial(t, NULL, NULL) != LUA_OK)
        lua_error(L);
    const struct advise_problem problem = {.quantities = t->count,
                                           .name = t->name,
                                           .unit = t->unit,
                                           .accuracy = accuracy,
                                           .levels = advise_levels(level),
                                           .level = level,
                                           .most = MOST_ELEMENTS,
                                           .weighs_linear = lua_isnil(L, function),
                                           .run = run,
                                           .context = t};
    if (advise(&problem, &t->advice, &err))
        hobe_lua_raise(L, &err);
    tell(L, &t->advice);
    hobe_lua_make_scene(L, items, &t->advice.trial[t->advice.model].model);
    lua_replace(L, first);
    lua_settop(L, first);
}
