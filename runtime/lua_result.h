/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results, between the verbs that solve and the rooms of what is said of them. */
#ifndef HOBE_LUA_RESULT_H
#define HOBE_LUA_RESULT_H

#include "lua_hobe.h"

/* Pushes a result that is still empty, of the scene at an index.  (lua_result.c) */
hobe_solution **hobe_lua_new_result(lua_State *L, int scene);

/* What is read of a result as r.KEY; ends with {0}.  (lua_result.c) */
extern const struct hobe_lua_field hobe_lua_result_fields[];

/* Notes when few digits are settled: `change` is that of hobe_solution_info.  (lua_warn.c) */
void hobe_lua_note_change(lua_State *L, double change);

/* Warns of an equilibrium of the model where its outline, mesh or stability is not to be relied on;
 * the same of the points, results, in the list on top of the stack, where they get worse, and of
 * the mesh of the `last`, or NULL where there is none.  (lua_warn.c) */
void hobe_lua_warn_equilibrium(lua_State *L, const hobe_solution *solution,
                               const hobe_model *model);
void hobe_lua_warn_start(lua_State *L, const hobe_solution *start); /* of a motion */
void hobe_lua_warn_path(lua_State *L, const hobe_solution *last, const hobe_model *model);

#endif
