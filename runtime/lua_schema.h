/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of arguments, described once: the description checks what a script passes, says what is
 * wrong with it, fills a C struct, and prints the reference. */
#ifndef HOBE_LUA_SCHEMA_H
#define HOBE_LUA_SCHEMA_H

#include <lua.h>
#include <stddef.h>

/* Type names of userdata that begin with a pointer to the object. */
#define HOBE_LUA_SECTION "hobe.section"
#define HOBE_LUA_RESULT  "hobe.result"
#define HOBE_LUA_MODES   "hobe.modes"
#define HOBE_LUA_HISTORY "hobe.history"

/* What a key holds, and the C object at its offset. */
enum hobe_lua_type {
    KEY_NUMBER,  /* finite number              double */
    KEY_WHOLE,   /* whole number               int */
    KEY_TEXT,    /* one line of UTF-8          const char *, alive as long as the table is */
    KEY_FLAG,    /* true or false              int */
    KEY_CHOICE,  /* one of `choices`           int: 1 for the first, 2, ...; 0 where left out */
    KEY_VECTOR,  /* {x, y, z}                  double[3]; {0, 0, 0} where left out */
    KEY_PAIR,    /* {a, b}                     double[2]; {0, 0} where left out */
    KEY_GROUP,   /* table described by `group` the struct described there */
    KEY_SECTION, /* a section                  const hobe_section *, alive as long as the section */
    KEY_RESULT,  /* a result of static         const hobe_solution *, likewise; NULL where left out
                  */
    KEY_MODES,   /* modes of modal             const hobe_modes *, likewise; NULL where left out */
    KEY_HISTORY, /* a motion of dynamic        const hobe_history *, likewise; NULL where left out
                  */
    KEY_LIST,    /* any table                  nothing: the function reads it itself */
    KEY_OTHER    /* what `choices` says        nothing: the function checks and reads it itself */
};

enum hobe_lua_flags {
    KEY_REQUIRED = 1,
    KEY_LOWER = 2,      /* value >= lower ... */
    KEY_LOWER_OPEN = 4, /* ... or > lower */
    KEY_UPPER = 8,
    KEY_UPPER_OPEN = 16
};

/* Bounds, written into the record of a key. */
#define KEY_ABOVE(x)     .lower = (x), .bounds = KEY_LOWER | KEY_LOWER_OPEN
#define KEY_FROM(x)      .lower = (x), .bounds = KEY_LOWER
#define KEY_BELOW(x)     .upper = (x), .bounds = KEY_UPPER | KEY_UPPER_OPEN
#define KEY_WITHIN(a, b) .lower = (a), .upper = (b), .bounds = KEY_LOWER | KEY_UPPER
#define KEY_BETWEEN(a, b)                                                                          \
    .lower = (a), .upper = (b), .bounds = KEY_LOWER | KEY_LOWER_OPEN | KEY_UPPER | KEY_UPPER_OPEN

struct hobe_lua_key {
    const char *name; /* NULL ends the list */
    enum hobe_lua_type type;
    int position; /* may stand without its name at this place of the table; a vector's three numbers
                     from there on; 0: named only */
    unsigned flags, bounds;
    size_t offset; /* in the struct that is filled, from the schema's start */
    double fallback, lower, upper;
    const char *choices;                 /* "series|paper"; of other: "number or function" */
    const char *word;                    /* fallback of a text; of a choice, what 0 stands for */
    const struct hobe_lua_schema *group; /* of a group; of the items of a list, for the reference */
    const char *unit, *doc;              /* unit may be NULL */
};

/* A record of a key for the field of the struct `owner`, under its own name or another. */
#define KEY(owner, field, kind, ...) KEY_AS(#field, owner, field, kind, __VA_ARGS__)
#define KEY_AS(key_name, owner, field, kind, ...)                                                  \
    {                                                                                              \
        .name = key_name, .type = kind, .offset = offsetof(owner, field), __VA_ARGS__              \
    }
#define KEY_OF_LIST(key_name, ...)                                                                 \
    {                                                                                              \
        .name = key_name, .type = KEY_LIST, __VA_ARGS__                                            \
    }
#define KEY_OF_OTHER(key_name, types, ...)                                                         \
    {                                                                                              \
        .name = key_name, .type = KEY_OTHER, .choices = types, __VA_ARGS__                         \
    }
#define REQUIRED .flags = KEY_REQUIRED

struct hobe_lua_schema {
    const char *name; /* of the constructor, as errors say it: "rectangle" */
    const struct hobe_lua_key *key;
};

/* Checks the value at `index` against the schema and fills *out, whose fields stand at the keys'
 * offsets.  Raises one sentence, with file and line, that names key and value: no table, unknown
 * key (with the nearest known one), missing, wrong type, not finite, out of bounds. */
void hobe_lua_read(lua_State *L, int index, const struct hobe_lua_schema *schema, void *out);

/* The same for the table at the absolute `index` of something called `what` ("report: u3"). */
void hobe_lua_read_group(lua_State *L, int index, const char *what,
                         const struct hobe_lua_schema *schema, void *out);

/* The same for one value under the name `what` ("displacement: at"). */
void hobe_lua_read_value(lua_State *L, int index, const char *what, const struct hobe_lua_key *key,
                         void *out);

/* Pushes key `name` of the table at `index`, or what stands at its position. */
void hobe_lua_push_key(lua_State *L, int index, const struct hobe_lua_schema *schema,
                       const char *name);

/* A finite number at `index`, or a sentence about `what`. */
double hobe_lua_number(lua_State *L, int index, const char *what);

/* A string on one line of valid UTF-8 at `index`, or a sentence about `what`. */
const char *hobe_lua_text(lua_State *L, int index, const char *what);

/* Whether a key's bounds allow the number x. */
int hobe_lua_is_within(const struct hobe_lua_key *key, double x);

/* The number of items of the list at the absolute `index`; a sentence where keys are not 1..n. */
size_t hobe_lua_list_size(lua_State *L, int index, const char *what);

/* Pushes the value at `index` as a sentence would quote it: got -0.01, "x", a table. */
const char *hobe_lua_describe(lua_State *L, int index);

/* A number that a script reads from an object. */
struct hobe_lua_field {
    const char *name; /* NULL ends the list */
    char type;        /* 'd' double, 'i' int, 'l' long */
    size_t offset;
    const char *unit, *doc; /* unit may be NULL */
};
#define FIELD(owner, field, kind, measure, text) FIELD_AS(#field, owner, field, kind, measure, text)
#define FIELD_AS(key, owner, field, kind, measure, text)                                           \
    {                                                                                              \
        key, kind, offsetof(owner, field), measure, text                                           \
    }

/* Pushes the field called name of the struct at `from`.  Raises, with the nearest name, where the
 * object (said with its article: "a section") has none. */
int hobe_lua_push_field(lua_State *L, const char *object, const struct hobe_lua_field *field,
                        const void *from, const char *name);

/* The nearest of several names by edit distance. */
struct hobe_lua_nearest {
    const char *word, *best; /* best is NULL before the first try */
    int distance;
};
void hobe_lua_try(struct hobe_lua_nearest *nearest, const char *candidate);

#endif
