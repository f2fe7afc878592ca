/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of sections, states and modes as Lua sees them. */
#include "lua_hobe.h"
#include "picture.h"

#include <math.h>
#include <string.h>

/* ---- what is drawn -------------------------------------------------------------------------- */

/* One drawing: a section, a state or a mode. */
struct item {
    const hobe_section *section;
    const hobe_solution *state;
    const hobe_modes *modes;
    int mode;
    const char *label;
};

#define LABEL(place)                                                                               \
    KEY(struct item, label, KEY_TEXT, .position = place, .doc = "a line above the drawing")

static const struct hobe_lua_key section_keys[] = {
    KEY(struct item, section, KEY_SECTION, REQUIRED, .position = 1, .doc = "a section"),
    LABEL(2),
    {0}};
static const struct hobe_lua_key state_keys[] = {
    KEY(struct item, state, KEY_RESULT, REQUIRED, .position = 1, .doc = "a result"), LABEL(2), {0}};
static const struct hobe_lua_key mode_keys[] = {
    KEY(struct item, modes, KEY_MODES, REQUIRED, .position = 1, .doc = "a set of modes"),
    KEY(struct item, mode, KEY_WHOLE, REQUIRED, KEY_FROM(1), .position = 2, .doc = "which"),
    LABEL(3),
    {0}};

static const struct hobe_lua_schema section_schema = {"section", section_keys};
static const struct hobe_lua_schema state_schema = {"state", state_keys};
static const struct hobe_lua_schema mode_schema = {"mode", mode_keys};

struct slice {
    const char *beam; /* NULL: none */
    double at;
};

static const struct hobe_lua_key slice_keys[] = {
    KEY(struct slice, beam, KEY_TEXT, REQUIRED, .position = 1, .doc = "name of the beam"),
    KEY(struct slice, at, KEY_NUMBER, REQUIRED, KEY_WITHIN(0, 1), .position = 2,
        .doc = "place, a fraction of its length"),
    {0}};

static const struct hobe_lua_schema slice_schema = {"slice", slice_keys};

struct view {
    double azimuth, elevation;
};

static const struct hobe_lua_key view_keys[] = {
    KEY(struct view, azimuth, KEY_NUMBER, KEY_WITHIN(-360, 360), .fallback = NAN, .unit = "deg",
        .doc =
            "where the viewer stands, from axis x towards y; -40 for beams, 180 for sections and "
            "slices, 215 for reliefs"),
    KEY(struct view, elevation, KEY_NUMBER, KEY_WITHIN(-90, 90), .fallback = NAN, .unit = "deg",
        .doc = "and how high; 25, 0 for sections and slices"),
    {0}};

static const struct hobe_lua_schema view_schema = {"view", view_keys};

static const char *const functions[] = {"w", "wy", "wz"}; /* in the order of the choices */
static const char *const units[] = {"m²", "m³", "m³"};

struct options {
    const char *file, *title, *colour;
    struct item state, mode;
    struct slice slice;
    struct view view;
    double scale, limit;
    int function, columns, width, relief, reference;
};

#define ONE(name, group_schema, text)                                                              \
    KEY_OF_LIST(name, .group = &group_schema, .doc = "a drawing of each " text)

static const struct hobe_lua_key picture_keys[] = {
    KEY(struct options, file, KEY_TEXT, REQUIRED, .doc = "PNG file in the output folder"),
    KEY(struct options, title, KEY_TEXT, .doc = "a line above the picture"),
    ONE("sections", section_schema, "section and its function `field`"),
    KEY_AS("state", struct options, state.state, KEY_RESULT, .doc = "one deformed state"),
    ONE("states", state_schema, "deformed state, in one range of colours"),
    KEY(struct options, mode, KEY_GROUP, .group = &mode_schema, .doc = "one mode shape"),
    ONE("modes", mode_schema, "mode shape"),
    KEY(struct options, slice, KEY_GROUP, .group = &slice_schema,
        .doc = "of states: draw the section at this place alone, on its axes now, with its shape "
               "before the load in grey"),
    KEY_AS("field", struct options, function, KEY_CHOICE, .choices = "w|wy|wz", .word = "w",
           .doc = "of sections: the function they are coloured by"),
    KEY(struct options, colour, KEY_TEXT, .word = "u",
        .doc = "of beams: what they are coloured by: `u` (its size), `ux`, `uy`, `uz`; `w`, the "
               "section's function; and, not of modes, `twist` or a stress, Pa: `mises`, or `sxx`, "
               "`syy`, `szz`, `syz`, `sxz`, `sxy` in the section's axes now"),
    KEY(struct options, relief, KEY_FLAG,
        .doc = "sections seen obliquely, with the function as a displacement along x"),
    KEY(struct options, scale, KEY_NUMBER, .fallback = 1,
        .doc = "magnifies displacements; those of modes and reliefs from a tenth of the size of "
               "what is drawn"),
    KEY(struct options, limit, KEY_NUMBER, KEY_ABOVE(0), .fallback = 0,
        .doc = "of states: size of the value at which the colours end, in the unit of what they "
               "show, where a few points would take them all, as the stress at re-entrant corners; "
               "what is larger has the last colour"),
    KEY(struct options, reference, KEY_FLAG, .fallback = 1,
        .doc = "of beams: draw the edges of the reference in grey, too"),
    KEY(struct options, view, KEY_GROUP, .group = &view_schema, .doc = "where it is seen from"),
    KEY(struct options, columns, KEY_WHOLE, KEY_WITHIN(0, 100),
        .doc = "drawings side by side; 0: as many as look well"),
    KEY(struct options, width, KEY_WHOLE, KEY_WITHIN(HOBE_PICTURE_LEAST, HOBE_PICTURE_MOST),
        .fallback = 1200, .unit = "pixels", .doc = "less where the drawings do not need it"),
    {0}};

static const struct hobe_lua_schema picture_schema = {"picture", picture_keys};

/* Pushes all items of the one key that says what to draw. */
static const struct item *push_items(lua_State *L, const struct options *options, int *count)
{
    static const struct {
        const char *key;
        const struct hobe_lua_schema *schema;
    } lists[] = {{"sections", &section_schema}, {"states", &state_schema}, {"modes", &mode_schema}};
    int given = (options->state.state != NULL) + (options->mode.modes != NULL);
    struct item *items = lua_newuserdatauv(L, sizeof *items, 0);
    *items = options->mode.modes ? options->mode : options->state;
    *count = 1;
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++) {
        hobe_lua_push_key(L, 1, &picture_schema, lists[k].key);
        const int list = lua_gettop(L);
        if (lua_isnil(L, list))
            continue;
        const char *what = lua_pushfstring(L, "picture: %s", lists[k].key);
        *count = (int)hobe_lua_list_size(L, list, what);
        items = lua_newuserdatauv(L, (size_t)(*count + 1) * sizeof *items, 0);
        memset(items, 0, (size_t)(*count + 1) * sizeof *items);
        for (int i = 0; i < *count; i++) {
            const char *each = lua_pushfstring(L, "%s[%d]", what, i + 1);
            lua_rawgeti(L, list, i + 1);
            hobe_lua_read_group(L, lua_gettop(L), each, lists[k].schema, items + i);
            lua_pop(L, 2);
        }
        given++;
    }
    if (given != 1 || *count == 0)
        hobe_lua_fail(L,
                      "picture must be given something to draw in one of sections, state, "
                      "states, mode, modes; got %d of them",
                      given);
    return items;
}

/* ---- checks without drawing ----------------------------------------------------------------- */

static const struct hobe_field *find_field(lua_State *L, const struct options *options,
                                           const struct item *item)
{
    struct hobe_error err;
    const struct hobe_field *field = hobe_find_field(options->colour, item->modes != NULL, &err);
    if (!field)
        hobe_lua_raise(L, &err);
    return field;
}

/* Whether a script is right must not depend on --out: what can be wrong is found before. */
static void check_item(lua_State *L, const struct options *options, const struct hobe_field *field,
                       const struct item *item)
{
    const char *function = functions[options->function], *sliced = options->slice.beam;
    struct hobe_error err;
    struct hobe_modes_info info;
    struct hobe_point point;
    double f[4];
    if (item->section && hobe_section_function(item->section, function, 0, 0, f, &err))
        hobe_lua_raise(L, &err);
    if (item->state && hobe_check_field(item->state, field, &err))
        hobe_lua_raise(L, &err);
    if (sliced && !item->state)
        hobe_lua_fail(L, "picture: slice needs a state or states to cut");
    if (sliced && hobe_solution_point(item->state, sliced, options->slice.at, 0, 0, &point, &err))
        hobe_lua_raise(L, &err);
    if (!item->modes)
        return;
    hobe_modes_info(item->modes, &info);
    if (item->mode > info.count)
        hobe_lua_fail(L, "picture: the mode must be from 1 to %d, got %d", info.count, item->mode);
}

/* ---- drawing -------------------------------------------------------------------------------- */

enum { FINENESS = 20 };              /* of closed-form sections */
static const double DEPTH = 0.3;     /* of the stub of a relief */
static const double AMPLITUDE = 0.1; /* of modes and reliefs */

/* Everything a picture points to. */
struct work {
    struct hobe_picture picture;
    struct hobe_surface *surface;
    struct hobe_panel *panel;
    double (*mark)[HOBE_MARKS][3];
};

static enum hobe_status make_section(const struct options *options, const struct item *item,
                                     struct work *work, int i, struct hobe_error *err)
{
    struct hobe_section_properties properties;
    const char *function = functions[options->function];
    double *shear_centre = work->mark[i][HOBE_MARK_SHEAR_CENTRE];
    hobe_section_properties(item->section, &properties);
    shear_centre[1] = properties.ys;
    shear_centre[2] = properties.zs;
    if (!options->relief)
        work->panel[i].mark = (const double(*)[3])work->mark[i];
    return hobe_section_field(item->section, function, FINENESS,
                              options->relief ? DEPTH * fmax(properties.width, properties.height)
                                              : 0,
                              work->surface + i, err);
}

/* Surface and panel of item i. */
static enum hobe_status make_panel(const struct options *options, const struct hobe_field *field,
                                   const struct item *item, struct work *work, int i,
                                   struct hobe_error *err)
{
    struct hobe_surface *surface = work->surface + i;
    struct hobe_panel *panel = work->panel + i;
    enum hobe_status status;
    *panel = (struct hobe_panel){.label = item->label, .surface = surface, .scale = options->scale};
    if (item->section)
        status = make_section(options, item, work, i, err);
    else if (options->slice.beam)
        status = hobe_solution_slice(item->state, options->slice.beam, options->slice.at, field,
                                     surface, err);
    else if (item->state)
        status = hobe_solution_surface(item->state, field, surface, err);
    else
        status = hobe_modes_surface(item->modes, item->mode - 1, field, surface, err);
    const int flat = item->section && !options->relief;
    if (flat)
        panel->scale = 0;
    else if (!item->state)
        panel->scale *= hobe_surface_scale(surface, AMPLITUDE);
    panel->reference = options->reference && !item->section;
    return status;
}

static void set_picture(const struct options *options, const struct hobe_field *field,
                        const struct item *item, int count, struct hobe_picture *picture)
{
    const int section = item->section != NULL, relief = section && options->relief;
    const int flat = (section && !relief) || options->slice.beam;
    const double azimuth = flat ? 180 : relief ? 215 : -40, elevation = flat ? 0 : 25;
    *picture = (struct hobe_picture){
        .title = options->title,
        .field = section ? functions[options->function] : field->symbol,
        .unit = section ? units[options->function] : field->unit,
        .colours = section || field->signs ? HOBE_COLOURS_SIGNED : HOBE_COLOURS_RISING,
        .range = item->modes            ? HOBE_RANGE_RELATIVE
                 : section && count > 1 ? HOBE_RANGE_AMOUNTS
                                        : HOBE_RANGE_SHARED,
        .limit = options->limit,
        .width = options->width,
        .columns = options->columns,
        .isolines = section,
        .same_scale = !section,
        .axes = section || options->slice.beam ? "xyz" : "XYZ",
        .azimuth = isnan(options->view.azimuth) ? azimuth : options->view.azimuth,
        .elevation = isnan(options->view.elevation) ? elevation : options->view.elevation,
        .panels = count,
    };
}

/* No Lua in here: an error must not jump over what is freed. */
static enum hobe_status draw(const struct options *options, const struct hobe_field *field,
                             const struct item *item, int count, struct hobe_text *png,
                             struct hobe_error *err)
{
    struct work work = {.surface = hobe_alloc((size_t)count, sizeof *work.surface, err),
                        .panel = hobe_alloc((size_t)count, sizeof *work.panel, err),
                        .mark = hobe_alloc((size_t)count, sizeof *work.mark, err)};
    enum hobe_status status = work.surface && work.panel && work.mark ? HOBE_OK : HOBE_NO_MEMORY;
    for (int i = 0; !status && i < count; i++)
        status = make_panel(options, field, item + i, &work, i, err);
    set_picture(options, field, item, count, &work.picture);
    work.picture.panel = work.panel;
    if (!status)
        status = hobe_picture_png(&work.picture, png, err);
    for (int i = 0; work.surface && i < count; i++)
        hobe_surface_free(work.surface + i);
    hobe_free(work.surface);
    hobe_free(work.panel);
    hobe_free(work.mark);
    return status;
}

/* hobe.picture{file =, sections =, ...} */
static int make_picture(lua_State *L)
{
    struct options options = {.view = {NAN, NAN}};
    struct hobe_error err;
    int count;
    lua_settop(L, 1);
    hobe_lua_read(L, 1, &picture_schema, &options);
    hobe_lua_check_file(L, "picture", options.file, ".png");
    options.function -= options.function > 0; /* 0: left out */
    const struct item *items = push_items(L, &options, &count);
    const struct hobe_field *field = items->section ? NULL : find_field(L, &options, items);
    for (int i = 0; i < count; i++)
        check_item(L, &options, field, items + i);
    if (!hobe_lua_context(L)->folder)
        return 0;
    struct hobe_text *png = hobe_lua_stage(L, options.file);
    hobe_lua_pause_clock();
    const enum hobe_status status = draw(&options, field, items, count, png, &err);
    hobe_lua_resume_clock();
    if (status)
        hobe_lua_raise(L, &err);
    hobe_lua_publish(L);
    return 0;
}

const struct hobe_lua_entry hobe_lua_picture_entries[] = {
    {"picture", make_picture, "hobe.picture{file = \"x.png\", sections = {{s, \"name\"}, ...}}",
     "A picture in the output folder of one of: sections with a section function in colours, "
     "deformed states, mode shapes.  Beams are drawn as they are, section outline, warping and "
     "all.  Colours of a sheet of sections or modes go to the largest value of each drawing.  "
     "Without an output folder nothing is drawn.",
     &picture_schema, NULL},
    {0}};
