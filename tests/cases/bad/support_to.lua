-- expect: bad/support_to\.lua:9: support: kind "distance" needs to = \{x, y, z\}, a point of the ground; no other kind has it$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.support{ "blade", at = 1, kind = "distance" },
  hobe.force{ "blade", at = 1, value = {0, 0, -10} },
}
local r = hobe.static(scene)
