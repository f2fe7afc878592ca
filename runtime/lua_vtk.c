/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files for ParaView as Lua sees them. */
#include "lua_item.h"
#include "output_vtk.h"

#include <math.h>
#include <string.h>

/* A state of a series, or the one thing to be written. */
struct item {
    const hobe_solution *state;
    const hobe_modes *modes;
    int mode;
    double time;
};

static const struct hobe_lua_key state_keys[] = {
    KEY(struct item, state, KEY_RESULT, REQUIRED, .position = 1, .doc = "a result"),
    KEY(struct item, time, KEY_NUMBER, .position = 2, .fallback = NAN,
        .doc = "its time, or load, in the series; else its number"),
    {0}};
static const struct hobe_lua_key mode_keys[] = {
    KEY(struct item, modes, KEY_MODES, REQUIRED, .position = 1, .doc = "a set of modes"),
    KEY(struct item, mode, KEY_WHOLE, REQUIRED, KEY_FROM(1), .position = 2, .doc = "which"),
    {0}};

static const struct hobe_lua_schema state_schema = {"state", state_keys};
static const struct hobe_lua_schema mode_schema = {"mode", mode_keys};

struct options {
    const char *file;
    struct item state, mode;
    const hobe_history *motion;
    int every;
};

static const struct hobe_lua_key vtk_keys[] = {
    KEY(struct options, file, KEY_TEXT, REQUIRED,
        .doc = "file in the output folder: .vtu, or .pvd of a series, whose states become files "
               "beside it: of x.pvd x-0001.vtu, x-0002.vtu, ..."),
    KEY_AS("state", struct options, state.state, KEY_RESULT, .doc = "one deformed state"),
    KEY(struct options, mode, KEY_GROUP, .group = &mode_schema, .doc = "one mode shape"),
    KEY_OF_LIST("states", .group = &state_schema, .doc = "a series of states"),
    KEY(struct options, motion, KEY_HISTORY, .doc = "the series of a motion's states and times"),
    KEY(struct options, every, KEY_WHOLE, KEY_FROM(1), .fallback = 1,
        .doc = "of a motion: write every so many-th state, the start first"),
    {0}};

static const struct hobe_lua_schema vtk_schema = {"vtk", vtk_keys};

/* ---- one file ------------------------------------------------------------------------------- */

/* No Lua in here: an error must not jump over what is freed. */
static enum hobe_status compose(const struct item *item, struct hobe_text *text,
                                struct hobe_error *err)
{
    struct hobe_solid solid;
    const enum hobe_status status =
        item->state ? hobe_solution_solid(item->state, &solid, err)
                    : hobe_modes_solid(item->modes, item->mode - 1, &solid, err);
    if (status)
        return status;
    hobe_vtk_solid(&solid, text);
    hobe_solid_free(&solid);
    return hobe_text_check(text, err);
}

static void write_solid(lua_State *L, const char *file, const struct item *item)
{
    struct hobe_text *text = hobe_lua_stage(L, file);
    struct hobe_error err;
    hobe_lua_pause_clock();
    const enum hobe_status status = compose(item, text, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
}

static void write_one(lua_State *L, const struct options *options)
{
    const struct item *item = options->mode.modes ? &options->mode : &options->state;
    struct hobe_modes_info info;
    hobe_lua_check_file(L, "vtk", options->file, ".vtu");
    if (item->modes)
        hobe_modes_info(item->modes, &info);
    if (item->modes && item->mode > info.count)
        hobe_lua_fail(L, "vtk: the mode must be from 1 to %d, got %d", info.count, item->mode);
    if (hobe_lua_context(L)->folder)
        write_solid(L, options->file, item);
}

/* ---- series --------------------------------------------------------------------------------- */

/* Room for a series on top of the stack. */
static struct item *push_items(lua_State *L, int count)
{
    const size_t size = (size_t)(count + 1) * sizeof(struct item);
    return memset(lua_newuserdatauv(L, size, 0), 0, size);
}

/* The states of the list at an index. */
static const struct item *push_states(lua_State *L, int list, int *count)
{
    *count = (int)hobe_lua_list_size(L, list, "vtk: states");
    struct item *items = push_items(L, *count);
    for (int i = 0; i < *count; i++) {
        const char *each = lua_pushfstring(L, "vtk: states[%d]", i + 1);
        lua_rawgeti(L, list, i + 1);
        hobe_lua_read_group(L, lua_gettop(L), each, &state_schema, items + i);
        if (isnan(items[i].time))
            items[i].time = i + 1;
        lua_pop(L, 2);
    }
    return items;
}

/* Those of the motion at an index. */
static const struct item *push_motion(lua_State *L, int motion, const struct options *options,
                                      int *count)
{
    const int every = options->every;
    struct hobe_history_info info;
    hobe_history_info(options->motion, &info);
    *count = (info.states - 1) / every + 1;
    struct item *items = push_items(L, *count);
    for (int i = 0; i < *count; i++) {
        items[i].time = hobe_history_energies(options->motion, i * every)->time;
        items[i].state = hobe_lua_push_state(L, motion, i * every);
        lua_pop(L, 1);
    }
    return items;
}

static void write_series(lua_State *L, const char *file, const struct item *items, int count)
{
    const char **names = lua_newuserdatauv(L, (size_t)(count + 1) * sizeof *names, 0);
    double *times = lua_newuserdatauv(L, (size_t)(count + 1) * sizeof *times, 0);
    luaL_checkstack(L, count, "states");
    for (int i = 0; i < count; i++) {
        char number[16];
        snprintf(number, sizeof number, "%04d", i + 1);
        lua_pushlstring(L, file, strlen(file) - strlen(".pvd"));
        const char *name = lua_pushfstring(L, "%s-%s.vtu", lua_tostring(L, -1), number);
        lua_remove(L, -2);
        write_solid(L, name, items + i);
        const char *slash = strrchr(name, '/');
        names[i] = slash ? slash + 1 : name;
        times[i] = items[i].time;
    }
    hobe_vtk_series(count, names, times, hobe_lua_stage(L, file));
}

static void write_many(lua_State *L, const struct options *options)
{
    int count;
    hobe_lua_check_file(L, "vtk", options->file, ".pvd");
    hobe_lua_push_key(L, 1, &vtk_schema, options->motion ? "motion" : "states");
    const int index = lua_gettop(L);
    const struct item *items =
        options->motion ? push_motion(L, index, options, &count) : push_states(L, index, &count);
    if (hobe_lua_context(L)->folder)
        write_series(L, options->file, items, count);
}

/* hobe.vtk{file =, state =, ...} */
static int write_vtk(lua_State *L)
{
    struct options options = {0};
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &vtk_schema, &options);
    const int series = hobe_lua_is_given(L, &vtk_schema, "states") + (options.motion != NULL);
    const int given = (options.state.state != NULL) + (options.mode.modes != NULL) + series;
    if (given != 1)
        hobe_lua_fail(L, "vtk must be given one of state, states, motion, mode; got %d of them",
                      given);
    if (hobe_lua_is_given(L, &vtk_schema, "every") && !options.motion)
        hobe_lua_fail(L, "vtk: every = %d needs a motion to choose from", options.every);
    if (series)
        write_many(L, &options);
    else
        write_one(L, &options);
    if (hobe_lua_context(L)->folder)
        hobe_lua_publish(L);
    return 0;
}

const struct hobe_lua_entry hobe_lua_vtk_entries[] = {
    {"vtk", write_vtk, "hobe.vtk{file = \"beam.vtu\", state = r}",
     "A file for ParaView in the output folder: a state, a series of states or a motion (.pvd), "
     "or a mode shape as wedges that are quadratic along and across, with the section as it is, in "
     "the reference; and at each point `displacement`, m (for Warp By Vector), and of states "
     "`stress` (Cauchy, global axes, Pa), `strain` (Green-Lagrange, on the section's axes before "
     "the load), both xx, yy, zz, xy, yz, xz, and `von Mises`, Pa; no stress where a beam has "
     "none, as 3333s.  "
     "Times of a motion are in s.",
     &vtk_schema, NULL},
    {0}};
