-- expect: bad/path_reach_zero\.lua:11: reach must be a displacement other than
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.force{ "blade", at = 1, value = {0, 0, -10} },
}
hobe.path(scene, { reach = { "blade", at = 1, value = {0, 0, 0} } })
