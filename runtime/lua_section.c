/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections as Lua sees them. */
#include "lua_hobe.h"

#include <math.h>
#include <string.h>

static int finalize(lua_State *L)
{
    hobe_section **section = luaL_checkudata(L, 1, HOBE_LUA_SECTION);
    hobe_section_free(*section);
    *section = NULL;
    return 0;
}

#define PROPERTY(name, unit, doc) FIELD(struct hobe_section_properties, name, 'd', unit, doc)

static const struct hobe_lua_field fields[] = {
    PROPERTY(A, "m^2", "area"),
    PROPERTY(yc, "m", "centroid in the coordinates an outline is given in, y"),
    PROPERTY(zc, "m", "the same, z"),
    PROPERTY(Iyy, "m^4", "integral of z^2 about the centroid"),
    PROPERTY(Izz, "m^4", "integral of y^2 about the centroid"),
    PROPERTY(Iyz, "m^4", "integral of y z about the centroid"),
    PROPERTY(J, "m^4", "Saint-Venant's torsion constant: exact, or by finite elements, from above"),
    PROPERTY(J_w, "m^4", "torsion constant with this warping function, >= J"),
    PROPERTY(Iw, "m^6", "warping constant, integral of w^2"),
    PROPERTY(ys, "m", "shear centre from the centroid, y"),
    PROPERTY(zs, "m", "the same, z"),
    PROPERTY(Wagner, "m^6",
             "Wagner constant: integral of r^4 - (integral of r^2)^2/A, r from the shear centre"),
    PROPERTY(ky, NULL,
             "shear correction factor along y, with wy: 1/ky is the energy of a shear force "
             "over that of an even shear stress"),
    PROPERTY(kz, NULL, "the same along z, with wz"),
    PROPERTY(kyz, NULL,
             "couples them: the energy of Vy and Vz through the shear centre is "
             "(Vy^2/ky + Vz^2/kz + 2 kyz Vy Vz)/(2 G A)"),
    PROPERTY(width, "m", "extent along y"),
    PROPERTY(height, "m", "extent along z"),
    {0}};

static int get_field(lua_State *L)
{
    hobe_section *const *section = luaL_checkudata(L, 1, HOBE_LUA_SECTION);
    const char *name = lua_tostring(L, 2);
    struct hobe_section_properties properties;
    if (!strcmp(name, "text")) {
        lua_pushstring(L, hobe_section_text(*section));
        return 1;
    }
    if (hobe_section_varies(*section))
        hobe_lua_fail(L,
                      "this section varies along the beam; ask for %s where it is the same, as in "
                      "section:at(0.5).%s",
                      name, name);
    hobe_section_properties(*section, &properties);
    return hobe_lua_push_field(L, "a section", fields, &properties, name);
}

hobe_section **hobe_lua_new_section(lua_State *L)
{
    hobe_section **section = lua_newuserdatauv(L, sizeof *section, 0);
    *section = NULL;
    hobe_lua_set_type(L, HOBE_LUA_SECTION, finalize, hobe_lua_section_methods, get_field);
    return section;
}

/* A number whose key was left out: the library takes 0 for its default. */
static double or_zero(double x)
{
    return isnan(x) ? 0 : x;
}

/* ---- rectangles ----------------------------------------------------------------------------- */

struct rectangle {
    double width, height, side;
    int warping;
};

#define SIZE(name, text)                                                                           \
    KEY(struct rectangle, name, KEY_NUMBER, REQUIRED, KEY_ABOVE(0), .unit = "m", .doc = text)
#define WARPING                                                                                    \
    KEY(struct rectangle, warping, KEY_CHOICE, .choices = "series|paper|solved", .word = "series", \
        .doc = "warping function: the Saint-Venant series summed to convergence, only its first "  \
               "term as in the paper, or finite elements")

static const struct hobe_lua_key rectangle_keys[] = {
    SIZE(width, "size along y"), SIZE(height, "size along z"), WARPING, {0}};
static const struct hobe_lua_key square_keys[] = {SIZE(side, "size along y and z"), WARPING, {0}};

static const struct hobe_lua_schema rectangle_schema = {"rectangle", rectangle_keys};
static const struct hobe_lua_schema square_schema = {"square", square_keys};

static int make_rectangle(lua_State *L, double width, double height, int warping)
{
    static const enum hobe_warping kinds[] = {HOBE_WARPING_SERIES, HOBE_WARPING_SERIES,
                                              HOBE_WARPING_PAPER, HOBE_WARPING_SOLVED};
    struct hobe_error err;
    hobe_section **section = hobe_lua_new_section(L);
    *section = hobe_section_rectangle(width, height, kinds[warping], &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

static int rectangle(lua_State *L)
{
    struct rectangle r;
    hobe_lua_read(L, 1, &rectangle_schema, &r);
    return make_rectangle(L, r.width, r.height, r.warping);
}

static int square(lua_State *L)
{
    struct rectangle r;
    hobe_lua_read(L, 1, &square_schema, &r);
    return make_rectangle(L, r.side, r.side, r.warping);
}

/* ---- round sections ------------------------------------------------------------------------- */

struct ring {
    double radius, outer, inner;
};

#define RADIUS(name, text)                                                                         \
    KEY(struct ring, name, KEY_NUMBER, REQUIRED, KEY_ABOVE(0), .unit = "m", .doc = text)

static const struct hobe_lua_key circle_keys[] = {RADIUS(radius, "radius"), {0}};
static const struct hobe_lua_key tube_keys[] = {
    RADIUS(outer, "outer radius"), RADIUS(inner, "inner radius, < outer"), {0}};

static const struct hobe_lua_schema circle_schema = {"circle", circle_keys};
static const struct hobe_lua_schema tube_schema = {"tube", tube_keys};

static int circle(lua_State *L)
{
    struct ring r;
    struct hobe_error err;
    hobe_lua_read(L, 1, &circle_schema, &r);
    hobe_section **section = hobe_lua_new_section(L);
    *section = hobe_section_circle(r.radius, &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

static int tube(lua_State *L)
{
    struct ring r;
    struct hobe_error err;
    hobe_lua_read(L, 1, &tube_schema, &r);
    hobe_section **section = hobe_lua_new_section(L);
    *section = hobe_section_tube(r.outer, r.inner, &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

/* ---- profiles and hollow rectangles ---------------------------------------------------------- */

struct profile {
    struct hobe_profile_sizes sizes;
    double thickness;
    int warping;
};

#define PART(name, text)                                                                           \
    KEY_AS(#name, struct profile, sizes.name, KEY_NUMBER, REQUIRED, KEY_ABOVE(0), .unit = "m",     \
           .doc = text)
#define PROFILE_KEYS                                                                               \
    PART(height, "size along z"), PART(width, "size along y"),                                     \
        PART(flange, "thickness of a flange, which runs along y"),                                 \
        PART(web, "thickness of the web, which runs along z")
#define CLOSED_FORM(equation)                                                                      \
    KEY(struct profile, warping, KEY_CHOICE, .choices = "solved|paper", .word = "solved",          \
        .doc = "warping function: finite elements, or the paper's closed form, " equation)

#define TOP(name, text)                                                                            \
    KEY_AS(#name, struct profile, sizes.name, KEY_NUMBER, KEY_ABOVE(0), .fallback = NAN,           \
           .unit = "m", .doc = text)

static const struct hobe_lua_key I_keys[] = {
    PROFILE_KEYS,
    TOP(top_width, "size along y of the flange at +z, where it is not `width`"),
    TOP(top_flange, "thickness of the flange at +z, where it is not `flange`"),
    CLOSED_FORM("eq. 34, for equal flanges"),
    {0}};
static const struct hobe_lua_key profile_keys[] = {PROFILE_KEYS, {0}};
static const struct hobe_lua_key hollow_keys[] = {PART(width, "size along y"),
                                                  PART(height, "size along z"),
                                                  KEY(struct profile, thickness, KEY_NUMBER,
                                                      REQUIRED, KEY_ABOVE(0), .unit = "m",
                                                      .doc = "thickness of the wall"),
                                                  CLOSED_FORM("eq. 36"),
                                                  {0}};

static const struct hobe_lua_schema profile_schemas[HOBE_PROFILES] = {
    [HOBE_PROFILE_I] = {"I", I_keys},
    [HOBE_PROFILE_CHANNEL] = {"channel", profile_keys},
    [HOBE_PROFILE_T] = {"T", profile_keys},
    [HOBE_PROFILE_ANGLE] = {"angle", profile_keys},
};
static const struct hobe_lua_schema hollow_schema = {"hollow", hollow_keys};
static const struct hobe_lua_schema box_schema = {"box", hollow_keys};

static enum hobe_warping outline_warping(int choice)
{
    return choice == 2 ? HOBE_WARPING_PAPER : HOBE_WARPING_SOLVED;
}

static int make_profile(lua_State *L, enum hobe_profile kind)
{
    struct profile p = {0};
    struct hobe_error err;
    hobe_lua_read(L, 1, profile_schemas + kind, &p);
    p.sizes.top_width = or_zero(p.sizes.top_width);
    p.sizes.top_flange = or_zero(p.sizes.top_flange);
    hobe_section **section = hobe_lua_new_section(L);
    *section = hobe_section_profile(kind, &p.sizes, outline_warping(p.warping), &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

static int I(lua_State *L)
{
    return make_profile(L, HOBE_PROFILE_I);
}

static int channel(lua_State *L)
{
    return make_profile(L, HOBE_PROFILE_CHANNEL);
}

static int T(lua_State *L)
{
    return make_profile(L, HOBE_PROFILE_T);
}

static int angle(lua_State *L)
{
    return make_profile(L, HOBE_PROFILE_ANGLE);
}

static int make_hollow(lua_State *L, const struct hobe_lua_schema *schema)
{
    struct profile p;
    struct hobe_error err;
    hobe_lua_read(L, 1, schema, &p);
    hobe_section **section = hobe_lua_new_section(L);
    *section = hobe_section_hollow(p.sizes.width, p.sizes.height, p.thickness,
                                   outline_warping(p.warping), &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

static int hollow(lua_State *L)
{
    return make_hollow(L, &hollow_schema);
}

static int box(lua_State *L)
{
    return make_hollow(L, &box_schema);
}

/* ---- polygons ------------------------------------------------------------------------------- */

enum { MOST_LOOPS = HOBE_MAX_OUTLINE / 3 };

struct loops {
    int loops, total;
    int points[MOST_LOOPS];
    double point[HOBE_MAX_OUTLINE][2];
};

static const struct hobe_lua_key polygon_keys[] = {
    KEY_OF_LIST("{y, z}, {y, z}, ...", REQUIRED, .unit = "m",
                .doc = "the corners in turn, either way round, from any origin"),
    KEY_OF_LIST("holes", .unit = "m", .doc = "a list of lists of corners"),
    {0}};
static const struct hobe_lua_schema polygon_schema = {"polygon", polygon_keys};

/* Adds the points [1], [2], ... of the table at index, called what, as one loop. */
static void read_loop(lua_State *L, int index, const char *what, struct loops *loops)
{
    static const struct hobe_lua_key pair = {.type = KEY_PAIR};
    const int count = (int)lua_rawlen(L, index);
    if (loops->loops == MOST_LOOPS || count > HOBE_MAX_OUTLINE - loops->total)
        hobe_lua_fail(L, "polygon: at most %d points in %d loops are possible", HOBE_MAX_OUTLINE,
                      MOST_LOOPS);
    for (int i = 1; i <= count; i++) {
        const char *place = lua_pushfstring(L, "%s[%d]", what, i);
        lua_rawgeti(L, index, i);
        hobe_lua_read_value(L, -1, place, &pair, loops->point[loops->total++]);
        lua_pop(L, 2);
    }
    loops->points[loops->loops++] = count;
}

/* Only [1] .. [n] and, where `holes` is set, the holes. */
static void check_list(lua_State *L, int index, const char *what, int holes)
{
    if (!lua_istable(L, index))
        hobe_lua_fail(L, "%s must be a list of points {y, z}, got %s", what,
                      hobe_lua_describe(L, index));
    const lua_Integer count = (lua_Integer)lua_rawlen(L, index);
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const int key = lua_absindex(L, -2);
        if (lua_isinteger(L, key) && lua_tointeger(L, key) >= 1 && lua_tointeger(L, key) <= count)
            continue;
        if (!holes || lua_type(L, key) != LUA_TSTRING || strcmp(lua_tostring(L, key), "holes") != 0)
            hobe_lua_fail(L, "%s: unknown key %s; it holds points {y, z}%s", what,
                          hobe_lua_describe(L, key), holes ? " and `holes`" : "");
    }
}

static int polygon(lua_State *L)
{
    struct hobe_error err;
    struct loops *loops = lua_newuserdatauv(L, sizeof *loops, 0);
    loops->loops = loops->total = 0;
    check_list(L, 1, "polygon", 1);
    read_loop(L, 1, "polygon: ", loops);
    if (lua_getfield(L, 1, "holes") != LUA_TNIL) {
        const int holes = lua_absindex(L, -1);
        check_list(L, holes, "polygon: holes", 0);
        for (int h = 1; h <= (int)lua_rawlen(L, holes); h++) {
            const char *what = lua_pushfstring(L, "polygon: holes[%d]", h);
            lua_rawgeti(L, holes, h);
            check_list(L, lua_absindex(L, -1), what, 0);
            read_loop(L, lua_absindex(L, -1), what, loops);
            lua_pop(L, 2);
        }
    }
    hobe_section **section = hobe_lua_new_section(L);
    *section =
        hobe_section_polygon(loops->loops, loops->points, (const double(*)[2])loops->point, &err);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

/* ---- outlines from files -------------------------------------------------------------------- */

struct outline {
    const char *file;
    double scale, tolerance;
};

static const struct hobe_lua_key outline_keys[] = {
    KEY(struct outline, file, KEY_TEXT, REQUIRED,
        .doc = "name of the file, from the folder of the case"),
    KEY(struct outline, scale, KEY_NUMBER, KEY_ABOVE(0), .fallback = NAN, .unit = "m",
        .doc = "one unit of the file; left out: the unit that a DXF file names, else 1 m"),
    KEY(struct outline, tolerance, KEY_NUMBER, KEY_ABOVE(0), .fallback = NAN, .unit = "m",
        .doc = "greatest distance between an arc and its chords; left out: 1e-3 of the extent"),
    {0}};
static const struct hobe_lua_schema outline_schema = {"outline", outline_keys};

static int outline(lua_State *L)
{
    struct outline o;
    struct hobe_error err;
    struct hobe_text text = {0};
    hobe_lua_read(L, 1, &outline_schema, &o);
    hobe_section **section = hobe_lua_new_section(L);
    hobe_lua_read_file(L, "outline", o.file, HOBE_MOST_OUTLINE_BYTES, &text);
    const struct hobe_outline_file file = {.name = o.file,
                                           .text = text.at ? text.at : "",
                                           .size = text.size,
                                           .scale = or_zero(o.scale),
                                           .tolerance = or_zero(o.tolerance)};
    *section = hobe_section_file(&file, &err);
    hobe_text_free(&text);
    if (!*section)
        hobe_lua_raise(L, &err);
    return 1;
}

const struct hobe_lua_entry hobe_lua_section_entries[] = {
    {"rectangle", rectangle, "hobe.rectangle{width =, height =}",
     "A solid rectangle, about its centroid.  Besides the fields below, `text` says in words what "
     "the section and its warping function are.",
     &rectangle_schema, fields},
    {"square", square, "hobe.square{side =}", "A solid square; fields as of a rectangle.",
     &square_schema, NULL},
    {"circle", circle, "hobe.circle{radius =}",
     "A solid circle, which does not warp: elements with a mode w leave it out, and say so.",
     &circle_schema, NULL},
    {"tube", tube, "hobe.tube{outer =, inner =}", "A round tube, which does not warp.",
     &tube_schema, NULL},
    {"I", I, "hobe.I{height =, width =, flange =, web =}",
     "An I-section; its flanges may differ.  Its warping function, as that of every outline below, "
     "is "
     "solved by finite elements on a mesh that is finer at the corners; it is orthogonal to 1, y "
     "and z, which makes it that of a twist about the shear centre.",
     profile_schemas + HOBE_PROFILE_I, NULL},
    {"channel", channel, "hobe.channel{height =, width =, flange =, web =}",
     "A channel, open to the left (+y).", profile_schemas + HOBE_PROFILE_CHANNEL, NULL},
    {"T", T, "hobe.T{height =, width =, flange =, web =}", "A T, the flange on top (+z).",
     profile_schemas + HOBE_PROFILE_T, NULL},
    {"angle", angle, "hobe.angle{height =, width =, flange =, web =}",
     "An angle with legs along +y (the flange) and +z (the web).",
     profile_schemas + HOBE_PROFILE_ANGLE, NULL},
    {"hollow", hollow, "hobe.hollow{width =, height =, thickness =}",
     "A hollow rectangle of one wall thickness.", &hollow_schema, NULL},
    {"box", box, "hobe.box{width =, height =, thickness =}", "Another name of hollow.", &box_schema,
     NULL},
    {"polygon", polygon, "hobe.polygon{ {y, z}, {y, z}, ..., holes = {...} }",
     "Any outline, with holes.", &polygon_schema, NULL},
    {"outline", outline, "hobe.outline{file =}",
     "An outline with its holes from a file: of all its loops, that of the largest area is the "
     "outline.  A file whose name ends in `.dxf` is a drawing in DXF, as text: its LINE, ARC, "
     "CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE are chained where their ends coincide, to 1e-5 of "
     "the extent; x is y, y is z; arcs become chords that enclose the same area.  Any other file "
     "is a list of points: `y z` or `y, z` on each line, an empty line between loops, `#` before "
     "comments, the first line a name or a head if it is no point; airfoils in Selig's format are "
     "such lists.  A case script reads regular files of at most 16 MB in its own folder and below, "
     "through no symbolic link, unless `--trust` is given; `text` says which unit was used.",
     &outline_schema, NULL},
    {0}};
