/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks tables of arguments against their descriptions. */
#include "lua_schema.h"
#include "lua_hobe.h"

#include <math.h>
#include <string.h>

/* ---- words ---------------------------------------------------------------------------------- */

static int least(int a, int b, int c)
{
    int m = a < b ? a : b;
    return m < c ? m : c;
}

/* Edit distance of two words (Levenshtein), their first 63 characters. */
static int distance(const char *a, const char *b)
{
    int row[64], m = (int)strnlen(b, 63);
    for (int j = 0; j <= m; j++)
        row[j] = j;
    for (int i = 1; i <= 63 && a[i - 1]; i++) {
        int corner = row[0];
        row[0] = i;
        for (int j = 1; j <= m; j++) {
            int above = row[j];
            row[j] = least(above + 1, row[j - 1] + 1, corner + (a[i - 1] != b[j - 1]));
            corner = above;
        }
    }
    return row[m];
}

void hobe_lua_try(struct hobe_lua_nearest *nearest, const char *candidate)
{
    int d = distance(nearest->word, candidate);
    size_t size = strlen(nearest->word);
    if (size > 1 && !strncmp(nearest->word, candidate, size))
        d = 1; /* an abbreviation */
    if (nearest->best && d >= nearest->distance)
        return;
    nearest->best = candidate;
    nearest->distance = d;
}

/* Length of the UTF-8 character at s, or 0 where there is none or it is a control character. */
static size_t printable(const unsigned char *s)
{
    size_t n = *s < 0x80 ? 1 : *s >= 0xC2 && *s < 0xE0 ? 2 : *s >= 0xE0 && *s < 0xF0 ? 3 : 4;
    if (*s < ' ' || *s == 127 || (*s >= 0x80 && *s < 0xC2) || *s >= 0xF5)
        return 0;
    for (size_t i = 1; i < n; i++)
        if ((s[i] & 0xC0) != 0x80)
            return 0;
    return n;
}

/* Bytes of s that are whole printable characters, at most `most`. */
static size_t readable(const char *s, size_t most)
{
    size_t size = 0, n;
    while ((n = printable((const unsigned char *)s + size)) > 0 && size + n <= most)
        size += n;
    return size;
}

const char *hobe_lua_describe(lua_State *L, int index)
{
    switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
        return lua_pushliteral(L, "nothing");
    case LUA_TBOOLEAN:
        return lua_pushstring(L, lua_toboolean(L, index) ? "true" : "false");
    case LUA_TNUMBER:
        if (isnan(lua_tonumber(L, index))) /* which prints as -nan at times */
            return lua_pushliteral(L, "nan");
        lua_pushvalue(L, index);
        return lua_tostring(L, -1);
    case LUA_TSTRING: {
        size_t size, shown;
        const char *s = lua_tolstring(L, index, &size);
        shown = readable(s, 60);
        lua_pushlstring(L, s, shown);
        lua_pushfstring(L, "\"%s%s\"", lua_tostring(L, -1), shown < size ? "..." : "");
        lua_remove(L, -2);
        return lua_tostring(L, -1);
    }
    default:
        if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING)
            lua_pushfstring(L, "a %s", lua_tostring(L, -1));
        else
            lua_pushfstring(L, "a %s", luaL_typename(L, index));
        return lua_tostring(L, -1);
    }
}

/* ---- single values -------------------------------------------------------------------------- */

static void fail_type(lua_State *L, int index, const char *what, const char *expected)
{
    hobe_lua_fail(L, "%s must be %s, got %s", what, expected, hobe_lua_describe(L, index));
}

double hobe_lua_number(lua_State *L, int index, const char *what)
{
    if (lua_type(L, index) != LUA_TNUMBER)
        fail_type(L, index, what, "a number");
    double x = lua_tonumber(L, index);
    if (!isfinite(x))
        fail_type(L, index, what, "a finite number");
    return x;
}

const char *hobe_lua_text(lua_State *L, int index, const char *what)
{
    size_t size;
    if (lua_type(L, index) != LUA_TSTRING)
        fail_type(L, index, what, "a string");
    const char *s = lua_tolstring(L, index, &size);
    if (readable(s, size) != size)
        fail_type(L, index, what, "one line of UTF-8 text");
    return s;
}

size_t hobe_lua_list_size(lua_State *L, int index, const char *what)
{
    size_t n = 0, size = lua_rawlen(L, index);
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
        n++;
    if (n != size)
        hobe_lua_fail(L, "%s must be a list without keys or holes", what);
    return size;
}

/* Pushes the bounds of a key as words: "> 0", "from 0 to 1", "> -1 and < 0.5". */
static const char *push_bounds(lua_State *L, const struct hobe_lua_key *key)
{
    const char *lower = key->bounds & KEY_LOWER_OPEN ? ">" : ">=";
    const char *upper = key->bounds & KEY_UPPER_OPEN ? "<" : "<=";
    int both = (key->bounds & KEY_LOWER) && (key->bounds & KEY_UPPER);
    char words[100];
    if (both && !(key->bounds & (KEY_LOWER_OPEN | KEY_UPPER_OPEN)))
        snprintf(words, sizeof words, "from %g to %g", key->lower, key->upper);
    else if (both)
        snprintf(words, sizeof words, "%s %g and %s %g", lower, key->lower, upper, key->upper);
    else if (key->bounds & KEY_LOWER)
        snprintf(words, sizeof words, "%s %g", lower, key->lower);
    else
        snprintf(words, sizeof words, "%s %g", upper, key->upper);
    return lua_pushstring(L, words);
}

int hobe_lua_is_within(const struct hobe_lua_key *key, double x)
{
    const int low = (key->bounds & KEY_LOWER) &&
                    (key->bounds & KEY_LOWER_OPEN ? x <= key->lower : x < key->lower);
    const int high = (key->bounds & KEY_UPPER) &&
                     (key->bounds & KEY_UPPER_OPEN ? x >= key->upper : x > key->upper);
    return !low && !high;
}

static double read_bounded(lua_State *L, int index, const char *what,
                           const struct hobe_lua_key *key)
{
    double x = hobe_lua_number(L, index, what);
    if (!hobe_lua_is_within(key, x))
        fail_type(L, index, what, push_bounds(L, key));
    return x;
}

static int read_whole(lua_State *L, int index, const char *what, const struct hobe_lua_key *key)
{
    double x = hobe_lua_number(L, index, what);
    if (x != floor(x) || fabs(x) > 1e9)
        fail_type(L, index, what, "a whole number");
    return (int)read_bounded(L, index, what, key);
}

/* The place of a word among "a|b|c", from 1; 0 when it is not there. */
static int find_choice(const char *choices, const char *word)
{
    size_t size = strlen(word);
    int place = 1;
    for (const char *c = choices;; c++, place++) {
        size_t n = strcspn(c, "|");
        if (n == size && !memcmp(c, word, n))
            return place;
        c += n;
        if (!*c)
            return 0;
    }
}

static int read_choice(lua_State *L, int index, const char *what, const struct hobe_lua_key *key)
{
    luaL_gsub(L, key->choices, "|", "\", \"");
    const char *words = lua_pushfstring(L, "one of \"%s\"", lua_tostring(L, -1));
    if (lua_type(L, index) != LUA_TSTRING)
        fail_type(L, index, what, words);
    int place = find_choice(key->choices, lua_tostring(L, index));
    if (place == 0)
        fail_type(L, index, what, words);
    lua_pop(L, 2);
    return place;
}

/* n numbers of the table at index, from its place `from` on. */
static void read_numbers(lua_State *L, int index, const char *what, int from, int n, double *x)
{
    for (int i = 0; i < n; i++) {
        const char *part = lua_pushfstring(L, "%s[%d]", what, i + 1);
        lua_rawgeti(L, index, from + i);
        x[i] = hobe_lua_number(L, -1, part);
        lua_pop(L, 2);
    }
}

static void read_vector(lua_State *L, int index, const char *what, int n, double *x)
{
    const char *expected = n == 3 ? "three numbers {x, y, z}" : "two numbers {a, b}";
    if (!lua_istable(L, index))
        fail_type(L, index, what, expected);
    int entries = 0;
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
        entries++;
    if (entries != n || (int)lua_rawlen(L, index) != n)
        hobe_lua_fail(L, "%s must be %s, got a table with %d", what, expected, entries);
    read_numbers(L, index, what, 1, n, x);
}

/* Objects: userdata whose first member points to what C is given. */
static const struct {
    const char *type, *expected;
} objects[] = {[KEY_SECTION] = {HOBE_LUA_SECTION, "a section, such as hobe.rectangle{...}"},
               [KEY_RESULT] = {HOBE_LUA_RESULT, "a result of hobe.static(scene)"},
               [KEY_MODES] = {HOBE_LUA_MODES, "a set of modes of hobe.modal(scene)"},
               [KEY_HISTORY] = {HOBE_LUA_HISTORY, "a motion of hobe.dynamic(scene, ...)"}};

/* Copies that pointer to *out. */
static void read_object(lua_State *L, int index, const char *what, enum hobe_lua_type type,
                        void *out)
{
    void *object = luaL_testudata(L, index, objects[type].type), *held = NULL;
    if (object)
        memcpy(&held, object, sizeof held);
    if (!held)
        fail_type(L, index, what, objects[type].expected);
    memcpy(out, &held, sizeof held);
}

/* Puts the value at index, which is there, into *out. */
static void read_value(lua_State *L, int index, const char *what, const struct hobe_lua_key *key,
                       void *out)
{
    switch (key->type) {
    case KEY_NUMBER:
        *(double *)out = read_bounded(L, index, what, key);
        break;
    case KEY_WHOLE:
        *(int *)out = read_whole(L, index, what, key);
        break;
    case KEY_TEXT:
        *(const char **)out = hobe_lua_text(L, index, what);
        break;
    case KEY_FLAG:
        if (!lua_isboolean(L, index))
            fail_type(L, index, what, "true or false");
        *(int *)out = lua_toboolean(L, index);
        break;
    case KEY_CHOICE:
        *(int *)out = read_choice(L, index, what, key);
        break;
    case KEY_VECTOR:
        read_vector(L, index, what, 3, out);
        break;
    case KEY_PAIR:
        read_vector(L, index, what, 2, out);
        break;
    case KEY_GROUP:
        hobe_lua_read_group(L, index, what, key->group, out);
        break;
    case KEY_SECTION:
    case KEY_RESULT:
    case KEY_MODES:
    case KEY_HISTORY:
        read_object(L, index, what, key->type, out);
        break;
    case KEY_LIST:
        if (!lua_istable(L, index))
            fail_type(L, index, what, "a table");
        break;
    case KEY_OTHER:
        break;
    }
}

/* What a key holds that the script left out. */
static void set_fallback(const struct hobe_lua_key *key, void *out)
{
    if (key->type == KEY_NUMBER)
        *(double *)out = key->fallback;
    else if (key->type == KEY_WHOLE || key->type == KEY_FLAG)
        *(int *)out = (int)key->fallback;
    else if (key->type == KEY_TEXT)
        *(const char **)out = key->word;
    else if (key->type == KEY_CHOICE)
        *(int *)out = 0;
    else if (key->type == KEY_VECTOR)
        memset(out, 0, 3 * sizeof(double));
    else if (key->type == KEY_PAIR)
        memset(out, 0, 2 * sizeof(double));
    else if (key->type == KEY_RESULT || key->type == KEY_MODES || key->type == KEY_HISTORY)
        memset(out, 0, sizeof(void *)); /* NULL */
}

void hobe_lua_read_value(lua_State *L, int index, const char *what, const struct hobe_lua_key *key,
                         void *out)
{
    index = lua_absindex(L, index);
    if (!lua_isnoneornil(L, index))
        read_value(L, index, what, key, out);
    else if (key->flags & KEY_REQUIRED)
        hobe_lua_fail(L, "%s is missing: %s", what, key->doc);
    else
        set_fallback(key, out);
}

/* ---- tables --------------------------------------------------------------------------------- */

/* The most items that may stand without a key. */
static int positions(const struct hobe_lua_schema *schema)
{
    int most = 0;
    for (const struct hobe_lua_key *key = schema->key; key->name; key++) {
        int last = key->position + (key->type == KEY_VECTOR ? 2 : 0);
        if (key->position > 0 && last > most)
            most = last;
    }
    return most;
}

/* Raises: the key at `index` is none of the schema's. */
static void fail_unknown(lua_State *L, int index, const char *what,
                         const struct hobe_lua_schema *schema)
{
    const char *shown = hobe_lua_describe(L, index);
    struct hobe_lua_nearest nearest = {.word = lua_tostring(L, index)};
    lua_pushliteral(L, "");
    for (const struct hobe_lua_key *key = schema->key; key->name; key++) {
        hobe_lua_try(&nearest, key->name);
        lua_pushfstring(L, "%s%s%s", lua_tostring(L, -1), key == schema->key ? "" : ", ",
                        key->name);
        lua_remove(L, -2);
    }
    hobe_lua_fail(L, "%s: unknown key %s, did you mean \"%s\"? (keys: %s)", what, shown,
                  nearest.best, lua_tostring(L, -1));
}

/* Raises unless the key at `index` belongs to the schema. */
static void check_key(lua_State *L, int index, const char *what,
                      const struct hobe_lua_schema *schema)
{
    int isint;
    lua_Integer place = lua_tointegerx(L, index, &isint);
    if (lua_type(L, index) == LUA_TSTRING) {
        for (const struct hobe_lua_key *key = schema->key; key->name; key++)
            if (!strcmp(key->name, lua_tostring(L, index)))
                return;
        fail_unknown(L, index, what, schema);
    }
    if (lua_type(L, index) == LUA_TNUMBER && isint && place >= 1 && place <= positions(schema))
        return;
    hobe_lua_fail(L, "%s: unexpected item %s at [%s]; items have names here", what,
                  hobe_lua_describe(L, index + 1), luaL_tolstring(L, index, NULL));
}

static void check_keys(lua_State *L, int index, const char *what,
                       const struct hobe_lua_schema *schema)
{
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
        check_key(L, lua_absindex(L, -2), what, schema);
}

/* Reads one key of the table at index, by name or by position. */
static void read_key(lua_State *L, int index, const char *what, const struct hobe_lua_key *key,
                     void *out)
{
    lua_pushstring(L, key->name);
    int named = lua_rawget(L, index) != LUA_TNIL;
    int placed = key->position > 0 && lua_rawgeti(L, index, key->position) != LUA_TNIL;
    if (named && placed)
        hobe_lua_fail(L, "%s is given twice: by name and as item %d", what, key->position);
    if (key->position > 0)
        lua_remove(L, named ? -1 : -2);
    if (placed && key->type == KEY_VECTOR) {
        read_numbers(L, index, what, key->position, 3, out);
        lua_pop(L, 1);
        return;
    }
    hobe_lua_read_value(L, -1, what, key, out);
    lua_pop(L, 1);
}

/* what: "rectangle" or, inside, "beam: material". */
void hobe_lua_read_group(lua_State *L, int index, const char *what,
                         const struct hobe_lua_schema *schema, void *out)
{
    int nested = strchr(what, ':') != NULL;
    if (!lua_istable(L, index))
        hobe_lua_fail(L, nested ? "%s must be a table, got %s" : "%s must be given a table, got %s",
                      what, hobe_lua_describe(L, index));
    luaL_checkstack(L, 20, "too many nested tables");
    check_keys(L, index, what, schema);
    for (const struct hobe_lua_key *key = schema->key; key->name; key++) {
        const char *full = lua_pushfstring(L, nested ? "%s.%s" : "%s: %s", what, key->name);
        read_key(L, index, full, key, (char *)out + key->offset);
        lua_pop(L, 1);
    }
}

void hobe_lua_read(lua_State *L, int index, const struct hobe_lua_schema *schema, void *out)
{
    hobe_lua_read_group(L, lua_absindex(L, index), schema->name, schema, out);
}

void hobe_lua_push_key(lua_State *L, int index, const struct hobe_lua_schema *schema,
                       const char *name)
{
    index = lua_absindex(L, index);
    lua_pushstring(L, name);
    if (lua_rawget(L, index) != LUA_TNIL)
        return;
    for (const struct hobe_lua_key *key = schema->key; key->name; key++) {
        if (key->position > 0 && !strcmp(key->name, name)) {
            lua_pop(L, 1);
            lua_rawgeti(L, index, key->position);
        }
    }
}

/* ---- fields of objects ---------------------------------------------------------------------- */

int hobe_lua_push_field(lua_State *L, const char *object, const struct hobe_lua_field *field,
                        const void *from, const char *name)
{
    struct hobe_lua_nearest nearest = {.word = name};
    for (; field->name; field++) {
        const char *at = (const char *)from + field->offset;
        hobe_lua_try(&nearest, field->name);
        if (strcmp(field->name, name))
            continue;
        if (field->type == 'd')
            lua_pushnumber(L, *(const double *)at);
        else
            lua_pushinteger(L, field->type == 'i' ? *(const int *)at : *(const long *)at);
        return 1;
    }
    return hobe_lua_fail(L, "%s has no field \"%s\", did you mean \"%s\"?", object, name,
                         nearest.best);
}
