/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key `material` of a beam, of a part of a section and of one element. */
#include "lua_item.h"

#define MATERIAL(name, ...) KEY(struct hobe_material, name, KEY_NUMBER, __VA_ARGS__)

static const struct hobe_lua_key material_keys[] = {
    MATERIAL(E, REQUIRED, KEY_ABOVE(0), .unit = "Pa", .doc = "Young's modulus"),
    MATERIAL(nu, REQUIRED, KEY_BETWEEN(-1, 0.5), .doc = "Poisson's ratio"),
    MATERIAL(rho, KEY_FROM(0), .unit = "kg/m^3", .doc = "density; needed where mass matters"),
    MATERIAL(k2, KEY_ABOVE(0), .fallback = 1, .doc = "shear correction on xz"),
    MATERIAL(k3, KEY_ABOVE(0), .fallback = 1, .doc = "shear correction on xy"),
    KEY_AS("k", struct hobe_material, average_shear, KEY_CHOICE, .choices = "point|average",
           .word = "point",
           .doc = "where k2 and k3 act: on the strain at every point, which makes torsion softer, "
                  "too, or on the shear strain averaged over the section, which leaves it alone"),
    {0}};

const struct hobe_lua_schema hobe_lua_material_schema = {"material", material_keys};

void hobe_lua_finish_material(struct hobe_material *material)
{
    material->average_shear = material->average_shear == 2;
}

void hobe_lua_choose_material(lua_State *L, const struct hobe_lua_schema *schema,
                              const hobe_section *section, struct hobe_material *material)
{
    const int own = hobe_section_material(section, 0) != NULL;
    hobe_lua_push_key(L, 1, schema, "material");
    if (lua_isnil(L, -1) != own)
        hobe_lua_fail(L,
                      own ? "%s: a composite section brings its materials; leave material out"
                          : "%s: material is missing: a table {E =, nu =, rho =}",
                      schema->name);
    lua_pop(L, 1);
    hobe_lua_finish_material(material);
}
