/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of arguments, described once: the description checks what a script passes, says what is
 * wrong with it, and prints the reference. */
#ifndef HOBE_LUA_SCHEMA_H
#define HOBE_LUA_SCHEMA_H

#include <lua.h>
#include <stddef.h>
#include <stdio.h>

#define HOBE_LUA_SECTION "hobe.section" /* type name of a section's userdata */

/* What a key holds, and the C object at its offset. */
enum hobe_lua_type {
    HOBE_LUA_NUMBER,  /* finite number                 double */
    HOBE_LUA_WHOLE,   /* whole number                  int */
    HOBE_LUA_TEXT,    /* one line of UTF-8             const char *, alive while the table is */
    HOBE_LUA_FLAG,    /* true or false                 int */
    HOBE_LUA_CHOICE,  /* one of `choices`              int: 1 for the first; 0 where left out */
    HOBE_LUA_VECTOR,  /* {x, y, z}                     double[3] */
    HOBE_LUA_PAIR,    /* {a, b}                        double[2] */
    HOBE_LUA_GROUP,   /* table described by `group`    the struct described there */
    HOBE_LUA_BEAMWISE /* a section                     const hobe_section * */
};

enum hobe_lua_flags {
    HOBE_LUA_REQUIRED = 1,
    HOBE_LUA_LOWER = 2, /* value >= lower, or > with HOBE_LUA_OPEN_LOWER */
    HOBE_LUA_UPPER = 4,
    HOBE_LUA_OPEN_LOWER = 8,
    HOBE_LUA_OPEN_UPPER = 16,
    HOBE_LUA_LIST = 32 /* any table; read by the function itself, `offset` unused */
};
